#!/bin/sh
# The rooms of verify/: an include leads to the same room or to one that a room may use, and no file leads back to itself; and so does
# what an object file takes of another one. ref/ takes nothing of verify/.
set -eu

symbols=$(mktemp)
trap 'rm -f "$symbols"' EXIT
(cd "$CT_BUILD" && nm -A -g -P ref/*.o verify/*/*.o) >"$symbols"

LC_ALL=C symbols=$symbols house='
ref:
text:
formula:  text
sheet:    text formula
proof:    text formula sheet
motion:   text formula sheet
evaluate: text formula sheet proof motion ref
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
# FILE.o: NAME T where it is defined, FILE.o: NAME U where it is taken.
FILENAME == ENVIRON["symbols"] {
    split($1, part, "/")
    room = part[1] == "ref" ? "ref" : part[2]
    if ($3 == "U") taken[room, $2] = $1
    else home[$2] = room
    next
}
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
    for (pair in taken) {
        split(pair, of, SUBSEP)
        if (!(of[2] in home)) continue # of a library
        checks++
        if (!((of[1], home[of[2]]) in may)) fail(taken[pair] " " of[2] " is of " home[of[2]] "/")
    }
    for (u in next_of) if (!state[u]) visit(u)
    checks += files
    printf "%d%%: Checks: %d, Failures: %d, Errors: 0\n", checks ? 100 * (checks - failed) / checks : 0, checks, failed
    exit failed > 0 || checks == 0
}' "$symbols" verify/*/*.[ch]
