#!/bin/sh
# What fails around the program: memory, disks, descriptors, signals. The right output or one clear line, no half file,
# no hang, no process left behind. A sample of what `make faults` does in full.
. tests/faults/harness.sh

# WORDS: the command's allocations, about a hundred of them, fail.
each() {
    # shellcheck disable=SC2086
    check "allocations of $1" survives_allocations $1
}

# A sanitizer brings an allocator of its own, and gcov takes memory at the end as if there always were some.
if ldd "$program" | grep -q 'lib[a-z]*san'; then
    echo 'allocations skipped: a sanitizer makes them'
elif grep -q __gcov_exit "$program"; then
    echo 'allocations skipped: gcov makes some that may not fail'
else
    from=1 step=16
    each 'eval eq07 Omega=7.2915e-5 k_c=8.99e9 m1=150 m2=150 L=10'
    from=$(allocations_of equations nothing) step=4
    each 'eval eq41roots Omega=1 C1=10 C2=2'
    each 'figure 4'
    each 'trajectory nonlinear --at 1000'
    each 'verify derivations kepler'
    each 'verify errors --count 1'
    each 'vectors eq14 --count 3 --seed 1'
    each 'conform --answers data/golden/eq09.csv eq09'
    each 'equations eq30 --json'
fi

# ---- output ----

refuses() { # COMMAND...: with exit status 1 and one line
    status=0
    "$@" >"$work/out" 2>"$work/err" || status=$?
    show $status
    is_refusal $status
}
: >"$work/expected"
to_full_disk() { "$program" "$@" >/dev/full; }
without_output() { "$program" "$@" >&-; }
for command in --version 'equations eq30' table1 'vectors eq41roots --golden' 'equations --json'; do
    # shellcheck disable=SC2086
    check "$command to a full disk" refuses to_full_disk $command
done
check 'a closed standard output' refuses without_output table1
report_to_full_disk() ( # as if: a file may have 512 bytes; gcov's counts, which may have more, go elsewhere and are not missed
    trap '' XFSZ
    export GCOV_PREFIX="$work/counts" GCOV_ERROR_FILE=/dev/null
    ulimit -f 1
    "$program" conform --only algebra --report "$work/full.xml" -- "$client" none >/dev/null
)
check 'a report to a full disk' refuses report_to_full_disk
check 'no report is left' test ! -e "$work/full.xml" -a ! -e "$work/full.xml.tmp"

# ---- input ----

: >"$work/expected"
without_input() { "$program" eval - <&-; }
check 'a closed standard input' refuses without_input
check 'answers that cannot be read' refuses "$program" conform --answers data eq07
unreadable_sheet() { "$CT_BUILD/sheet-check" data data data 2>&1 | grep -qx 'data: cannot be read'; }
check 'a sheet that cannot be read' unreadable_sheet

# ---- a client ----

conforms() { "$program" conform --only eq07,eq09 --timeout 5 -- "$client" none; }
with_short_transfers() { LD_PRELOAD=$shim FAULTS=$work FAULTS_SHORT=1 conforms; }
without_child_signals() { env --ignore-signal=CHLD "$program" conform --only eq07 --timeout 1 -- "$client" none; }
without_standard_input() { conforms <&-; }
if ! ldd "$program" | grep -q 'lib[a-z]*san'; then
    check 'a client over pipes that take a byte at a time' with_short_transfers
fi
if env --ignore-signal=CHLD true 2>/dev/null; then # GNU's alone
    check 'a client where the caller ignores the end of children' without_child_signals
fi
check 'a client without a standard input of our own' without_standard_input

# TERM comes while the client, and a child of it, hang, and nobody reads its complaints.
mkfifo "$work/unread"
term_in_conversation() {
    # shellcheck disable=SC2016
    timeout -k 5 60 "$program" conform -- sh -c 'sleep 60 & echo >"$0"; exec yes >&2' "$work/started" 2>&3 3>&- &
    until [ -e "$work/started" ]; do sleep 0.05; done
    sleep 0.2
    kill -TERM $!
    wait $!
}
dies_of_term() {
    exec 3<>"$work/unread"
    without_orphans term_in_conversation
    status=$?
    echo "exit status $status"
    [ $status -eq 143 ]
}
check 'SIGTERM ends program and client' dies_of_term

finish
