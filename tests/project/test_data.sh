#!/bin/sh
# data/ holds facts: regenerated here, every file has to be the committed one, byte for byte.
. tests/harness.sh

again=$BUILD/data # as make was given it: a target's name holds no blank
rm -rf "$again"
check 'make data' "${MAKE:-make}" BUILD="$BUILD" DATA="$again" data
for file in $( { (cd data && find . -type f ! -name '*.tmp'); (cd "$again" && find . -type f); } | sort -u); do
    check "$file" cmp "data/$file" "$again/$file"
done
# Readers by name (csv.DictReader, pandas, the data package's) keep one of two columns of one name.
check 'names of columns' awk -F , 'FNR == 1 { for (i = 1; i <= NF; i++) if (seen[FILENAME, $i]++) { print FILENAME, $i; bad = 1 } }
    END { exit bad }' data/*.csv data/golden/*.csv
check 'descriptions' awk '/"type": / && !/"description": / { print; bad = 1 } END { exit bad }' data/datapackage.json
# From a file that is not there, or empty, or has no title no package is made, and one line says why.
echo id >"$work/other.csv"
makes_no_package_of() { # FILE MESSAGE
    ! "$CT_PROGRAM" design n=12 --json | "$PYTHON" paper/package.py 1 paper/package.json "$CT_BUILD/equations.json" "$1" >"$work/json" 2>"$work/said" &&
        [ "$(cat "$work/said")" = "package: $1: $2" ] && [ "$(tail -n 1 "$work/json")" != ' ]}' ]
}
check 'no file' makes_no_package_of "$work/none.csv" 'expected a header line'
: >"$work/table1.csv"
check 'an empty file' makes_no_package_of "$work/table1.csv" 'expected a header line'
check 'a file without a title' makes_no_package_of "$work/other.csv" 'has no title in paper/package.json'
if /usr/bin/python3 -c 'import pandas' 2>/dev/null; then
    check pandas /usr/bin/python3 tests/project/pandas_reads.py
else
    echo "pandas skipped: not found"
fi

# README's Table 1 and findings are those of the program.
{ echo '```'; "$CT_PROGRAM" table1; echo '```'; } >"$work/table1.md"
"$PYTHON" paper/claims.py markdown <"$CT_BUILD/claims.json" >"$work/findings.md"
awk -v folder="$work" -f paper/readme.awk README.md >"$work/README.new"
check README cmp "$work/README.new" README.md
finish
