#!/bin/sh
# System calls that fail, each in turn, by strace: writing, reading, opening, renaming, and all that it takes to talk
# to a client.
. tests/faults/harness.sh
MOST=${MOST:-12} # of the calls of one kind in a run, the first so many
injected=0 harmless=0 client_only='' on=''

if ! strace -qq -o "$work/trace" true; then
    echo 'calls skipped: strace is missing, or may not trace'
    finish
    exit
fi

# Run before each fault, and after one that was refused.
# shellcheck disable=SC2317
prepare() { :; }
# shellcheck disable=SC2317
inspect() { :; }

traced() { # STRACE-OPTION... PROGRAM ARGUMENT...
    timeout -k 1 120 strace -qq -e signal=none -o "$work/trace" "$@" <"$input" >"$work/out" 2>"$work/err"
}

# CALLS ERROR STRACE-OPTION... -- ARGUMENT...: each of these calls fails in turn; where $client_only is set, those alone
# after the start of a client.
survives_calls() {
    calls=$1 error=$2
    shift 2
    options=
    while [ "$1" != -- ]; do
        options="$options $1"
        shift
    done
    shift
    expect "$@"
    n=0
    if [ -n "$client_only" ]; then
        traced -e "trace=$calls,clone,clone3,vfork" "$program" "$@"
        n=$(sed '/^\(clone\|vfork\)/,$d' "$work/trace" | wc -l)
    fi
    most=$((n + MOST)) first=$((n + 1))
    while [ "$n" -lt "$most" ]; do
        n=$((n + 1)) status=0
        prepare
        # shellcheck disable=SC2086
        traced $options -e "trace=$calls" -e "inject=$calls:error=$error:when=$n$on" "$program" "$@" || status=$?
        grep -q INJECTED "$work/trace" || break
        injected=$((injected + 1))
        if is_right $status; then
            harmless=$((harmless + 1))
        elif ! is_refusal $status || ! inspect; then
            echo "call $n: $(grep INJECTED "$work/trace")"
            show $status
            return 1
        fi
    done
    [ "$n" -gt "$first" ] # otherwise there was no such call
}

# CALLS ERROR STRACE-OPTION... -- WORDS
each() {
    check "$*" survives_calls "$@"
}

# ---- output ----

on=+ # what has failed once fails on
for error in ENOSPC EIO; do
    each write $error -P "$work/out" -- equations
    each write $error -P "$work/out" -- eval eq41roots Omega=1 C1=10 C2=2
    each write $error -P "$work/out" -- table1
    each write $error -P "$work/out" -- figure 4
    each write $error -P "$work/out" -- figure 7a --rk4 100
    each write $error -P "$work/out" -- trajectory nonlinear --at 1000,2000
    each write $error -P "$work/out" -- equations --json
    each write $error -P "$work/out" -- verify errors --count 2
    each write $error -P "$work/out" -- study forced
    each write $error -P "$work/out" -- vectors eq03 --golden
    each write $error -P "$work/out" -- vectors eq14 --count 30 --seed 1
    each write $error -P "$work/out" -- conform --kills --only eq30
done
on=''

# ---- files ----

golden=$(pwd -P)/data/golden/eq09.csv
refusal=1
each openat EACCES -P "$golden" -- conform --answers "$golden" eq09
each openat EMFILE -P "$golden" -- conform --answers "$golden" eq09
each read EIO -P "$golden" -- conform --answers "$golden" eq09

# The file of --report is the old one then, whole, and nothing lies beside it.
report=$work/folder/report.json
mkdir "$work/folder"
# shellcheck disable=SC2317
prepare() { echo old >"$report"; }
# shellcheck disable=SC2317
inspect() { [ "$(cat "$report")" = old ] && [ "$(ls "$work/folder")" = report.json ]; }
for call in openat:EACCES write:ENOSPC write:EIO close:EIO rename:EACCES; do
    each ${call%:*} ${call#*:} -P "$report.tmp" -- conform --only eq07,eq09 --report "$report" -- "$client" none
done
prepare() { :; }
inspect() { :; }

# ---- a client ----

client_only=yes
for call in poll:ENOMEM read:EIO write:EIO poll:EINTR read:EINTR wait4:EINTR; do
    each ${call%:*} ${call#*:} -- conform --only eq07,eq09 --random 100 --seed 1 --timeout 5 -- "$client" none
done
client_only=''
for call in pipe2:EMFILE clone,clone3,vfork:EAGAIN; do
    each ${call%:*} ${call#*:} -- conform --only eq07,eq09 --random 100 --seed 1 --timeout 5 -- "$client" none
done

echo "calls: $injected made to fail, $harmless of them without consequence"
finish
