#!/bin/sh
# The gate: in a copy of the project in which every link is there `make gate` passes; with each link broken in turn it
# fails, and names what is missing.
. tests/harness.sh
unset DATA
project=$(pwd)

# A copy of what the gate reads. Tests are not run here: the logs say of each section that one has passed.
fresh() {
    rm -rf "$work/copy"
    mkdir -p "$work/copy/data" "$work/copy/build/tests" "$work/copy/tests/project" || exit 1
    cd "$work/copy" || exit 1
    cp -RL "$project/Makefile" "$project/ref" "$project/paper" .
    cp "$project/tests/project/gate.py" tests/project/
    cp -RL "$project/data/golden" "$project/data/verdicts.csv" data/
    cp "$work/derivations.json" "$work/errors.json" "$work/equations.json" build/
    cp "$work/all.tap" build/tests/
    chmod -R u+w . # whatever the project's own files allow
}

gate() { BUILD=build DATA=data "$PYTHON" tests/project/gate.py >"$work/table" 2>&1; }

# MESSAGE COMMAND: after the command, in a fresh copy, the gate fails and says so.
fails_and_says() {
    fresh
    eval "$2" || { echo "cannot break: $2"; return 1; }
    if gate; then echo 'the gate passed'; return 1; fi
    grep -F -- "$1" "$work/table" && return
    echo "expected: $1"
    grep '^gate:' "$work/table"
    return 1
}
breaks() { check "$1" fails_and_says "$2" "$3"; }

cp "$CT_BUILD/derivations.json" "$CT_BUILD/errors.json" "$CT_BUILD/equations.json" "$work" || exit 1
: >"$work/all.tap"
fresh
gate
sed -n 's/.*expected one named \(.*\)_\.\.\. in .*/ok 1 - tests\/test.c:suite:\1_holds: Passed/p' "$work/table" >"$work/all.tap"

passes() { fresh; make --silent BUILD=build DATA=data gate >"$work/table" 2>&1 || { grep '^gate:' "$work/table"; return 1; }; }
check 'nothing is broken' passes

breaks 'no function' 'eq18: 0 functions in ref/ with the header Eq. (18), expected one' \
    "sed -i 's/ Eq. (18) / Eq (18) /' ref/control.c"
breaks 'two functions' 'eq18: 2 functions in ref/ with the header Eq. (18), expected one' \
    "cp ref/control.c ref/again.c"
breaks 'a function of no equation' 'ref/: ct_charge_product_variation carries Eq. (81), which the sheet lacks' \
    "sed -i 's/Eq. (18) /Eq. (81) /' ref/control.c"
breaks 'a definition computed' 'eq20: is a definition, yet ct_charge_product_variation in ref/ carries Eq. (20)' \
    "sed -i 's/Eq. (18) /Eq. (20) /' ref/control.c"
breaks 'no test' 'eq18: no passing test, expected one named eq18_...' \
    "sed -i '/:eq18_/d' build/tests/all.tap"
breaks 'a failed test' 'eq18: test eq18_holds failed' \
    "sed -i '/:eq18_/s/^ok/not ok/' build/tests/all.tap"
breaks 'no log' "tests/: no executed tests, expected Check's TAP logs in build/tests/" \
    "rm build/tests/all.tap"
breaks 'a test of no equation' 'tests/: eq99_holds tests (99), which the sheet lacks' \
    "sed -i 's/:eq18_/:eq99_/' build/tests/all.tap"
breaks 'no error' 'eq18: no measured error in build/errors.json' \
    "sed -i '/\"eq18\"/d' build/errors.json"
breaks 'a large error' 'eq18: ref errs by 9.0e+00 roundings, at most 8 are expected' \
    "sed -i '/\"eq18\"/s/\"worst_E\": [^,]*/\"worst_E\": 9.0e+00/' build/errors.json"
breaks 'an error of no equation' 'errors: eq99 was measured, which the sheet lacks' \
    "sed -i 's/\"eq18\"/\"eq99\"/' build/errors.json"
breaks 'no step' 'eq18: no derivation step leads to (18)' \
    "sed -i '/\"feedback_law\"/s/\"to\": \\[\"18\"\\]/\"to\": []/' build/derivations.json"
breaks 'a broken step' 'derivations: step feedback_law does not hold' \
    "sed -i '/\"feedback_law\"/{n;s/\"finding\": \"holds\"/\"finding\": \"differs\"/;}' build/derivations.json"
breaks 'a step to no equation' 'derivations: step feedback_law names (99), which the sheet lacks' \
    "sed -i '/\"feedback_law\"/s/\"to\": \\[\"18\"\\]/\"to\": [\"99\"]/' build/derivations.json"
breaks 'no vectors' 'eq18: no golden vectors in data/golden/eq18.csv' "rm data/golden/eq18.csv"
breaks 'vectors of no equation' 'golden: data/golden/eq99.csv has vectors of eq99, which the sheet lacks' \
    "cp data/golden/eq18.csv data/golden/eq99.csv"
breaks 'no verdict' 'eq18: no verdict equation-18 in data/verdicts.csv' "sed -i '/^equation-18,/d' data/verdicts.csv"
breaks 'a verdict on no equation' 'verdicts: equation-99 is a verdict on (99), which the sheet lacks' \
    "sed -i 's/^equation-18,/equation-99,/' data/verdicts.csv"
breaks 'no place' 'eq18: no place in the edition, expected <<equation eq18>> in paper/*.md' \
    "sed -i '/^<<equation eq18>>/d' paper/06-control.md"
breaks 'a chapter left out' 'eq18: no place in the edition, expected <<equation eq18>> in paper/*.md' \
    "rm paper/06-control.md"
breaks 'code left out' 'eq18: its function is not in the edition, expected <<function eq18>> in paper/*.md' \
    "sed -i '/^<<function eq18>>/d' paper/06-control.md"
breaks 'a place of no equation' 'names eq99, which the sheet lacks' \
    "sed -i 's/^<<equation eq18>>/<<equation eq99>>/' paper/06-control.md"

finish
