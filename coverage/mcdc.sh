#!/bin/sh
# Usage: coverage/mcdc.sh FOLDER
# Condition coverage of ref/ by its own suites, which run in FOLDER: of every condition in a decision, whether a test
# shows that it decides alone, to true and to false (masking MC/DC). gcc counts that from version 14 on; with another
# compiler nothing is measured, and that is said. Fails where an outcome is not covered, and names it.
set -eu
export LC_ALL=C
out=$1
: "${CC:=cc}" "${MAKE:=make}"

if ! echo 'int x;' | $CC -fcondition-coverage -x c -c -o /dev/null - 2>/dev/null; then
    echo "mcdc: $CC has no -fcondition-coverage, nothing is measured (gcc has it from version 14 on)"
    exit
fi
gcov=gcov-$($CC -dumpversion)
command -v "$gcov" >/dev/null || gcov=gcov

# Only the library is instrumented: the suites around it are compiled as ever.
rm -rf "$out"
$MAKE BUILD="$out" CFLAGS='-O0 -g --coverage -fcondition-coverage' "$out/libcoulombtether.a"
suites=$(for file in tests/ref/test_ref_*.c; do basename "$file" .c; done | grep -v gsl)
$MAKE BUILD="$out" CFLAGS=-O1 LDFLAGS=--coverage "$out/tests/run" "$out/tests/test_ref_gsl"
# shellcheck disable=SC2086
"$out/tests/run" $suites domain_of_the_sheet_is_that_of_ref >"$out/log" 2>&1 && "$out/tests/test_ref_gsl" >>"$out/log" 2>&1 || { cat "$out/log"; exit 1; }

# gcov writes the sources out with lines between like "condition outcomes covered 3/4" and "condition  1 not covered
# (false)", and what a source includes behind it. The header's functions count once in each source.
for file in ref/*.c; do
    "$gcov" --conditions --stdout --object-directory "$out/ref" "$file"
done | awk '
    /:Source:/ { source = $0; sub(/.*:Source:/, "", source); next }
    /^condition outcomes covered / {
        split($NF, count, "/")
        covered[source] += count[1]; all[source] += count[2]; hit += count[1]; total += count[2]
        next
    }
    /^condition .* not covered/ { print source ":" line ": " $0 ": " text; next }
    { split($0, field, ":"); line = field[2] + 0; text = substr($0, index($0, field[3])) }
    END {
        for (source in all)
            printf "%-20s %4d of %4d condition outcomes\n", source, covered[source], all[source] | "sort"
        close("sort")
        printf "%-20s %4d of %4d condition outcomes, all of them needed\n", "ref", hit, total
        exit total == 0 || hit < total
    }'
