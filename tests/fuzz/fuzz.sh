#!/bin/sh
# Fuzzes targets two at a time, from the inputs that tests/fuzz/corpus/ keeps: FOLDER SECONDS TARGET...
#
# FOLDER has the executables. What is new goes to FOLDER/found/TARGET/, an input that fails to FOLDER/failed/; the last
# lines say how to see it again. SEED fixes where the search begins, which is elsewhere each time without it. A case may
# take CASE_SECONDS (10: a trajectory of a million rows takes 5) and 2 GB.
set -eu

fuzz() {
    target=$1
    log=$folder/$target.log
    mkdir -p "$folder/found/$target" "$folder/failed"
    status=0
    "$folder/$target" -seed="${SEED:-0}" -max_total_time="$seconds" -timeout="${CASE_SECONDS:-10}" -rss_limit_mb=2048 -max_len=4096 \
        -dict="$folder/words.dict" -artifact_prefix="$folder/failed/$target-" -print_final_stats=1 \
        "$folder/found/$target" "tests/fuzz/corpus/$target" >"$log" 2>&1 || status=$?
    awk -v target="$target" -v status="$status" '
        { for (i = 1; i < NF; i++) if ($i == "cov:") edges = $(i + 1) }
        /^stat::number_of_executed_units/ { runs = $2 }
        END { printf "%-14s %10d runs %7d edges  %s\n", target, runs, edges, status ? "FAILED" : "fine" }' "$log"
    if [ "$status" -ne 0 ]; then
        tail -n 40 "$log"
        echo "again: $folder/$target FILE, with the FILE that was written to $folder/failed/"
    fi
    return "$status"
}

if [ "$1" = --one ]; then
    folder=$2 seconds=$3
    fuzz "$4"
    exit
fi
folder=$1 seconds=$2
shift 2
# What the inputs are made of: keys, functions and names of the sheets, options and words of the command line, strange numbers.
{
    grep -ohE '^ *(- )?[A-Za-z0-9_]+:|[a-z0-9]+\(|eq[0-9]+\.[A-Za-z0-9_]+' paper/equations.yaml paper/derivations.yaml | tr -d ' -'
    grep -ohE '"-?-?[a-z0-9-]+"' verify/command/options.c | tr -d '"'
    printf '%s\n' nan -inf 1e308 1e400 1e-400 0x1p-1074 '>=' @printed eq07-paper eq07-1-0 L=10 Omega=7.2915e-5 skip invalid
} | sort -u | sed 's/.*/"&"/' >"$folder/words.dict"
printf '%s\0' "$@" | xargs -0 -n 1 -P 2 "$0" --one "$folder" "$seconds"
