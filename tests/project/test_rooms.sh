#!/bin/sh
# The rooms of verify/: an include leads to the same room or to one that a room may use, and no file leads back to itself.
set -u

LC_ALL=C house='
text:
formula:  text
sheet:    text formula
proof:    text formula sheet
motion:   text formula sheet
evaluate: text formula sheet proof motion
claims:   text formula sheet proof motion evaluate
conform:  text formula sheet proof motion evaluate
command:  text formula sheet proof motion evaluate claims conform' awk '
BEGIN {
    rooms = split(ENVIRON["house"], lines, "\n")
    for (i = 1; i <= rooms; i++) {
        words = split(lines[i], word, /[: ]+/)
        for (k = 1; k <= words; k++)
            if (word[k] != "") may[word[1], word[k]] = 1
    }
}
function fail(text) { print text; failed++ }
FNR == 1 { files++; split(FILENAME, part, "/"); room = part[2]; unit = FILENAME; sub(/\.[ch]$/, "", unit) }
!((room, room) in may) && FNR == 1 { fail(FILENAME ": " room "/ is none of the rooms") }
/^#include "/ {
    checks++
    target = $2; gsub(/"/, "", target)
    if (target == "coulombtether.h") { # ref/ has one door
        if (unit != "verify/evaluate/reference") fail(FILENAME ":" FNR ": only verify/evaluate/reference.c includes ref/")
        next
    }
    if (split(target, to, "/") != 2) { fail(FILENAME ":" FNR ": expected \"ROOM/FILE.h\", found " $2); next }
    if (!((room, to[1]) in may)) fail(FILENAME ":" FNR ": " room "/ may not use " to[1] "/")
    other = "verify/" target; sub(/\.h$/, "", other)
    if (other != unit && !((unit, other) in leads)) { leads[unit, other] = 1; next_of[unit] = next_of[unit] " " other }
}
# A circle is found by going on from a file until it is met again.
function visit(u,    list, n, i) {
    state[u] = 1
    n = split(next_of[u], list, " ")
    for (i = 1; i <= n; i++) {
        if (state[list[i]] == 1) fail(list[i] " and " u ": a circle of includes")
        else if (!state[list[i]]) visit(list[i])
    }
    state[u] = 2
}
END {
    for (u in next_of) if (!state[u]) visit(u)
    checks += files
    printf "%d%%: Checks: %d, Failures: %d, Errors: 0\n", checks ? 100 * (checks - failed) / checks : 0, checks, failed
    exit failed > 0 || checks == 0
}' verify/*/*.[ch]
