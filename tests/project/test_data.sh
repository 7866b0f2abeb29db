#!/bin/sh
# data/ holds facts: regenerated here, every file has to be the committed one, byte for byte.
set -u

again=$BUILD/data # as make was given it: a target's name holds no blank
passed=0 failed=0
rm -rf "$again"
if ! ${MAKE:-make} BUILD="$BUILD" DATA="$again" data >"$CT_BUILD/tests/data.make" 2>&1; then
    cat "$CT_BUILD/tests/data.make"
    failed=1
fi
for file in $( { (cd data && find . -type f ! -name '*.tmp'); (cd "$again" && find . -type f); } | sort -u); do
    if cmp "data/$file" "$again/$file"; then
        passed=$((passed + 1))
    else
        failed=$((failed + 1))
    fi
done
# Readers by name (csv.DictReader, pandas, the data package's) keep one of two columns of one name.
for file in data/*.csv data/golden/*.csv; do
    twice=$(head -n 1 "$file" | tr ',' '\n' | sort | uniq -d)
    if [ -z "$twice" ]; then
        passed=$((passed + 1))
    else
        echo "$file: two columns of one name: $twice"
        failed=$((failed + 1))
    fi
done
# README's Table 1 and findings are those of the program.
{ echo '```'; "$CT_PROGRAM" table1; echo '```'; } >"$CT_BUILD/tests/table1.md"
LC_ALL=C awk -f paper/read.awk -f paper/findings.awk "$CT_BUILD/claims.json" >"$CT_BUILD/tests/findings.md"
if paper/readme.sh README.md table1="$CT_BUILD/tests/table1.md" findings="$CT_BUILD/tests/findings.md" | cmp - README.md; then
    passed=$((passed + 1))
else
    failed=$((failed + 1))
fi

all=$((passed + failed))
echo "$((100 * passed / (all > 0 ? all : 1)))%: Checks: $all, Failures: $failed, Errors: 0"
[ "$failed" -eq 0 ] && [ "$passed" -gt 0 ]
