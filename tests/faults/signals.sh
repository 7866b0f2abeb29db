#!/bin/sh
# Signals at random moments, drawn by SEED: nothing half done under its final name, no process left behind, no hang,
# and the next `make data` completes.
. tests/faults/harness.sh
SEED=${SEED:-$(date +%s)}
MOMENTS=${MOMENTS:-4} # of each signal
sent=0

# SECONDS: as many moments between 0 and that.
moments() {
    awk -v seed="$SEED" -v count="$MOMENTS" -v most="$1" \
        'BEGIN { srand(seed); for (i = 0; i < count; i++) printf "%.3f\n", most * rand() }'
}

# SIGNAL SECONDS COMMAND...: command and group get the signal then; its exit status is in $ended.
interrupt() {
    sent_signal=$1 moment=$2
    shift 2
    sent=$((sent + 1)) ended=0
    without_orphans timeout --preserve-status -k 10 -s "$sent_signal" "$moment" "$@" || ended=$?
    case $ended in
        124) echo 'a process was left behind'; return 1 ;;
        137) echo 'it did not end'; return 1 ;;
    esac
}

# ---- make data ----

patience=120
data=$work/data

# What there is under its final name is the committed file.
is_whole() {
    mkdir -p "$data"
    (cd "$data" && find . -type f ! -name '*.tmp') >"$work/files"
    while read -r file; do
        cmp "$data/$file" "data/$file" || return 1
    done <"$work/files"
}
leaves_whole_files() { # SIGNAL SECONDS
    rm -rf "$data"
    interrupt "$1" "$2" make --silent DATA="$data" data && is_whole
}
completes() { make --silent DATA="$data" data && diff -r data "$data"; }

for signal in INT TERM PIPE; do
    for moment in $(moments 10); do
        check "make data, SIG$signal after $moment s" leaves_whole_files $signal "$moment"
    done
done
check 'make data completes' completes

# ---- conform ----

patience=20

# SIGNAL NUMBER SECONDS COMMAND...: dead of the signal, or done before it came; the report is whole if there is one.
dies_or_is_done() {
    name_of=$1 number=$2 after=$3
    shift 3
    rm -f "$work/report.xml"
    interrupt "$name_of" "$after" "$@" || return 1
    if [ -e "$work/report.xml" ] && ! cmp "$work/report.xml" "$work/whole.xml"; then return 1; fi
    if is_right "$ended" || { [ "$ended" -eq $((128 + number)) ] && is_beginning "$work/out"; }; then return; fi
    show "$ended"
    return 1
}
set -- conform --only algebra --random 100 --seed 1 --report "$work/report.xml" -- "$client" wrong
expect "$@"
mv "$work/report.xml" "$work/whole.xml"
for each in INT:2 TERM:15 HUP:1 QUIT:3; do
    for moment in $(moments 1.5); do
        check "conform, SIG${each%:*} after $moment s" dies_or_is_done ${each%:*} ${each#*:} "$moment" "$program" "$@"
    done
    for moment in $(moments 0.5); do
        check "conform with a client that hangs, SIG${each%:*} after $moment s" dies_or_is_done ${each%:*} ${each#*:} \
            "$moment" "$program" conform --timeout 60 -- sh -c 'sleep 60 & sleep 60'
    done
done

# ---- vectors ----

expect vectors eq14 --count 5000 --seed 1
for each in INT:2 TERM:15 PIPE:13; do
    for moment in $(moments 2); do
        check "vectors, SIG${each%:*} after $moment s" dies_or_is_done ${each%:*} ${each#*:} \
            "$moment" "$program" vectors eq14 --count 5000 --seed 1
    done
done

# ---- a reader that has seen enough ----

# WORDS: exit status 1 and not a word, however much there was still to say.
ends_quietly() {
    { timeout 20 "$program" "$@" 2>"$work/err"; echo $? >"$work/status"; } | head -n 1 >"$work/out"
    show "$(cat "$work/status")"
    [ "$(cat "$work/status")" -eq 1 ] && [ ! -s "$work/err" ]
}
check 'vectors into head' ends_quietly vectors eq14 --count 100000000 --seed 1
check 'trajectory into head' ends_quietly trajectory linear --every 1
check 'figure into head' ends_quietly figure 7a
check 'equations into head' ends_quietly equations --json

echo "signals: $sent sent, SEED=$SEED"
finish
