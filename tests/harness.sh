# shellcheck shell=sh
# What the scripts among the suites share; sourced from the project's root. By hand a script finds what was built in build/.
set -u
unset MAKEFLAGS MAKELEVEL
export BUILD="${BUILD:-build}"
export PYTHON="${PYTHON:-python3}"
export CT_BUILD="${CT_BUILD:-$(cd "$BUILD" && pwd)}"
export CT_PROGRAM="${CT_PROGRAM:-$CT_BUILD/coulomb-tether}"
work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT
trap 'exit 1' HUP INT TERM
checks=0 failures=0

# NAME COMMAND...: a check; what the command printed is shown when it fails.
check() {
    name=$1
    shift
    checks=$((checks + 1))
    "$@" >"$work/log" 2>&1 && return
    failures=$((failures + 1))
    echo "$0: $name: failed: $*"
    head -n 40 "$work/log" | sed 's/^/    /'
}

# Check's line of totals.
finish() {
    echo "$((100 * (checks - failures) / checks))%: Checks: $checks, Failures: $failures, Errors: 0"
    [ "$failures" -eq 0 ]
}
