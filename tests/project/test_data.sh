#!/bin/sh
# data/ holds facts: regenerated here, every file has to be the committed one, byte for byte.
. tests/harness.sh

again=$BUILD/data # as make was given it: a target's name holds no blank
rm -rf "$again"
check 'make data' "${MAKE:-make}" BUILD="$BUILD" DATA="$again" data
for file in $( { (cd data && find . -type f ! -name '*.tmp'); (cd "$again" && find . -type f); } | sort -u); do
    check "$file" cmp "data/$file" "$again/$file"
done

# README's Table 1 and findings are those of the program.
{ echo '```'; "$CT_PROGRAM" table1; echo '```'; } >"$work/table1.md"
LC_ALL=C awk -f paper/read.awk -f paper/findings.awk "$CT_BUILD/claims.json" >"$work/findings.md"
paper/readme.sh README.md table1="$work/table1.md" findings="$work/findings.md" >"$work/README.md"
check README cmp "$work/README.md" README.md
finish
