#!/bin/sh
# The names of verify/: no two functions, types, constants or macros at file scope have one name in different files.
set -u

LC_ALL=C awk '
# Indices of series by their symbols stand in more than one table: x is x in each of them.
BEGIN { split("ONE TWO THREE LAMBDA HOLD main", symbol, " "); for (i in symbol) shared[symbol[i]] = 1 }
function note(name) {
    checks++
    if (length(name) <= 2 || name in shared || (name in where && where[name] == FILENAME)) return
    if (name in where) { print FILENAME ":" FNR ": " name " is a name of " where[name] ", too"; failed++ }
    else where[name] = FILENAME
}
function note_enumerators(text,    list, n, i) {
    gsub(/\/\*[^*]*\*\//, "", text)
    sub(/^[^{]*\{/, "", text)
    sub(/\}.*/, "", text)
    n = split(text, list, ",")
    for (i = 1; i <= n; i++) {
        sub(/=.*/, "", list[i])
        gsub(/[ \t]/, "", list[i])
        if (list[i] != "") note(list[i])
    }
}
FNR == 1 { enumerators = head = "" }
/^#define / && $2 !~ /_H$/ { name = $2; sub(/\(.*/, "", name); note(name) }
/^(static |const )*(struct|enum|union) [A-Za-z0-9_]+ \{/ { match($0, /(struct|enum|union) [A-Za-z0-9_]+/); note(substr($0, RSTART, RLENGTH)) }
/^enum .*\{/ { enumerators = " " }
enumerators != "" { enumerators = enumerators $0; if (/\}/) { note_enumerators(enumerators); enumerators = "" } }
/^static .* = / { name = $0; sub(/ = .*/, "", name); gsub(/\[[^]]*\]/, "", name); sub(/.*[ *]/, "", name); note(name) }
/^[a-z].*\(/ { head = $0; sub(/\(.*/, "", head); sub(/.*[ *]/, "", head) } # a function, if a line with { follows
/^\{/ { if (head != "") note(head); head = "" }
END {
    printf "%d%%: Checks: %d, Failures: %d, Errors: 0\n", checks ? 100 * (checks - failed) / checks : 0, checks, failed
    exit failed > 0 || checks == 0
}' verify/*/*.h verify/*/*.c
