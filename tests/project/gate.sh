#!/bin/sh
# The gate: a line an equation, see gate.awk. Reads what make check has left in BUILD, and DATA; writes BUILD/gate.csv.
set -eu
data=${DATA-data}
for file in "$BUILD/equations.json" ref/*.c "$BUILD"/tests/*.tap "$BUILD/errors.json" "$BUILD/derivations.json" "$data"/golden/*.csv \
    "$data/verdicts.csv" paper/[0-9]*.md; do
    [ ! -e "$file" ] || set -- "$@" "$file"
done
LC_ALL=C awk -f paper/read.awk -f tests/project/gate.awk -v build="$BUILD" -v data="$data" -v csv_file="$BUILD/gate.csv.tmp" "$@"
mv "$BUILD/gate.csv.tmp" "$BUILD/gate.csv"
