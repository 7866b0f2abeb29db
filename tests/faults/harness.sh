# shellcheck shell=sh
# What the tests of faults share; sourced from the project's root. A fault may end in two ways: the right output, or
# exit status 1 with one line on standard error, and then nothing on standard output but a beginning of what is right.
# shellcheck disable=SC2034,SC2154  # shared is not used here, or not set
. tests/harness.sh
program=$CT_PROGRAM
client=$CT_BUILD/tests/faulty
# Where it is preloaded from no name may hold a blank or a colon.
shim=$work/faults.so
cp "$CT_BUILD/tests/faults.so" "$shim" || exit 1
refused=0 survived=0
: >"$work/none"
input=$work/none

is_one_line() { [ "$(wc -l <"$1")" -eq 1 ]; }
is_beginning() { head -c "$(wc -c <"$1")" "$work/expected" | cmp -s - "$1"; }

# Of a run that ended with this status, its output in out and err.
refusal=1
is_refusal() { [ "$1" -eq "$refusal" ] && is_one_line "$work/err" && grep -q '^coulomb-tether: ' "$work/err" && is_beginning "$work/out"; }
is_right() { [ "$1" -eq "$right" ] && cmp -s "$work/out" "$work/expected"; }
show() { echo "exit status $1"; cat "$work/err"; head -n 3 "$work/out" | cut -c 1-200; }

# ARGUMENT...: what the program says without faults, and its exit status, in expected and $right.
expect() {
    right=0
    "$program" "$@" <"$input" >"$work/expected" 2>/dev/null || right=$?
}

# ---- allocations ----

# ARGUMENT...: each allocation from number $from on, fails, later ones in steps that $step makes grow.
survives_allocations() {
    expect "$@"
    status=0
    LD_PRELOAD=$shim FAULTS=$work FAULTS_FROM=$from FAULTS_STEP=$step "$program" "$@" \
        <"$input" >"$work/out" 2>"$work/err" || status=$?
    # shellcheck disable=SC2046
    set -- $(sed -n '$s/\([0-9]*\) allocations, \([0-9]*\) refused, \([0-9]*\) survived, \([0-9]*\) wrong/\1 \2 \3 \4/p' "$work/report")
    [ $# -eq 4 ] || { cat "$work/report"; show $status; return 1; }
    refused=$((refused + $2)) survived=$((survived + $3))
    if ! is_right $status || [ "$4" -ne 0 ] || [ "$2" -eq 0 ]; then
        cat "$work/report"
        show $status
        return 1
    fi
}

# ARGUMENT...: how many allocations a run makes.
allocations_of() {
    LD_PRELOAD=$shim FAULTS=$work FAULTS_AT=0 "$program" "$@" <"$input" >"$work/out" 2>"$work/err"
    sed -n 's/ allocations.*//p' "$work/report"
}

# ---- clients ----

# COMMAND...: runs it; its exit status, or 124 where after $patience seconds a process is still there that it started.
patience=30
without_orphans() {
    # The pipe's end comes when the last process that holds it has gone.
    { status=0; "$@" 9>&1 >"$work/out" 2>"$work/err" || status=$?; echo $status >"$work/status"; } |
        timeout "$patience" cat >"$work/held" || return 124
    return "$(cat "$work/status")"
}
