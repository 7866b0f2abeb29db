#!/bin/sh
# Runs suites, as many at once as there are processors, and adds up what they say: check.sh FILE..., all of them or,
# where ONLY is set, those that it names (test_flow test_wrong).
#
# A suite is a script tests/ROOM/test_NAME.sh, or a test program's share of that name, and ends with Check's line of totals,
#     100%: Checks: 12, Failures: 0, Errors: 0
# and exits 0 when nothing failed. What a failing suite printed is shown in full. A suite that dies,
# hangs or says nothing counts as one failure more. Suites start at the project's root and find what was
# built in CT_BUILD, the program in CT_PROGRAM. Called by make, which gives BUILD.
set -eu

CT_BUILD=$(cd "$BUILD" && pwd)
CT_PROGRAM=$CT_BUILD/coulomb-tether
# The makes that suites start are of this one, and do not wait for each other.
CT_MAKE=${CT_MAKE:-$$}
export BUILD CT_BUILD CT_PROGRAM CT_MAKE
records=$CT_BUILD/tests
numbers='s/^ *[0-9]*%: Checks: \([0-9]*\), Failures: \([0-9]*\), Errors: \([0-9]*\).*/\1 \2 \3/p'

# Not every system has this command, or this option of it.
limit=
if timeout --foreground 1 true 2>/dev/null; then limit="timeout --foreground $((600 * ${CK_TIMEOUT_MULTIPLIER:-1}))"; fi

run_one() { # FILE
    name=${1##*/}
    name=${name%.*}
    log=$records/$name.log
    status=0
    case $1 in
        *.sh) ;;
        */test_corpora.c | */test_ref_gsl.c)
            set -- "$records/$name"
            if [ ! -x "$1" ]; then # by make, and said there
                echo "$name is left out"
                return
            fi ;;
        *) set -- "$records/run" "$name" ;;
    esac
    run() { CK_FORK=$1 && shift && export CK_FORK && CK_TAP_LOG_FILE_NAME=$records/$name.tap $limit "$@" >"$log" 2>&1 </dev/null; }
    # All tests of a suite in one process; where that dies it has failed, and which test it was is seen with a process for each.
    run "${CK_FORK-no}" "$@" || status=$?
    totals=$(sed -n "$numbers" "$log")
    case ${totals:+said}$1 in said* | *.sh) ;; *) run yes "$@" || :; totals=$(sed -n "$numbers" "$log") ;; esac

    # shellcheck disable=SC2086
    set -- $totals
    if [ $# -ne 3 ] || [ "$1" -eq 0 ]; then
        verdict="no result (exit status $status)"; passed=0 failed=1
    else
        verdict="Checks: $1, Failures: $2, Errors: $3"; passed=$(($1 - $2 - $3)) failed=$(($2 + $3))
        if [ "$failed" -eq 0 ] && [ "$status" -ne 0 ]; then
            verdict="$verdict, yet exit status $status"; failed=1
        fi
    fi
    echo "$passed $failed" >"$records/$name.count"

    percent=$((100 * passed / (passed + failed)))
    report=$(printf '%-24s %3d%%: %s' "$name" "$percent" "$verdict")
    if [ "$failed" -ne 0 ]; then
        report=$report$(printf '\n'; sed 's/^/    /' "$log")
    fi
    printf '%s\n' "$report"
}

if [ "${1-}" = --one ]; then
    run_one "$2"
    exit
fi

# What is in ONLY, of the files given.
only() {
    for name in $ONLY; do
        found=
        for file; do
            case $file in */"$name".*) found=$file; printf '%s\0' "$file" ;; esac
        done
        [ -n "$found" ] || { echo "check: there is no suite '$name'" >&2; return 1; }
    done
}

mkdir -p "$records"
echo "$CT_MAKE" >"$CT_BUILD/make.lock"
rm -f "$records"/*.count
chosen=$records/chosen
if [ -n "${ONLY-}" ]; then
    only "$@" >"$chosen"
else
    rm -f "$records"/*.log "$records"/*.tap
    printf '%s\0' "$@" >"$chosen"
fi
xargs -0 -n 1 -P "$(getconf _NPROCESSORS_ONLN)" "$0" --one <"$chosen"

# The gate reads what the suites have left behind, and the committed data; each equation counts as a check.
if [ -z "${ONLY-}" ]; then
    sound=true
    DATA=data "$PYTHON" tests/project/gate.py >"$records/gate.log" 2>&1 || sound=false
    if $sound && [ -z "${V-}" ]; then tail -n 1 "$records/gate.log"; else cat "$records/gate.log"; fi
    sed -n 's/^gate: \([0-9]*\) of \([0-9]*\) equations .*/\1 \2/p' "$records/gate.log" | {
        read -r good all || { good=0 all=1; }
        if [ "$good" -eq "$all" ] && ! $sound; then all=$((all + 1)); fi
        echo "$good $((all - good))" >"$records/gate.count"
    }
fi

cat "$records"/*.count 2>/dev/null | awk '
    { passed += $1; failed += $2 }
    END { printf "%d passed, %d failed\n", passed, failed; exit !(passed > 0 && failed == 0) }'
