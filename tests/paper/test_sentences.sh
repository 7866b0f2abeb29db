#!/bin/sh
# Every sentence of the paper has a row in data/verdicts.csv, or a reason in paper/sentences.csv; and what is missing is noticed.
. tests/harness.sh

# FILE: what paper/sentences.awk says of it
read_sentences() {
    LC_ALL=C awk -f paper/read.awk -f paper/sentences.awk data/verdicts.csv "$1" >"$work/out" 2>&1
}

# EXPRESSION MESSAGE: sentences.csv edited so stops with that.
stops_with() {
    sed "$1" paper/sentences.csv >"$work/sentences.csv"
    ! cmp -s paper/sentences.csv "$work/sentences.csv" && ! read_sentences "$work/sentences.csv" && grep -qF -- "$2" "$work/out" ||
        { cat "$work/out"; return 1; }
}
notices() { check "$1" stops_with "$@"; }
all_fine() { read_sentences paper/sentences.csv || { cat "$work/out"; return 1; }; }

check 'all sentences' all_fine
notices 's/,equation-12,$/,equation-99,/' "unknown row 'equation-99'"
notices '/,equation-12,$/d' "no sentence names the row 'equation-12'"
notices '/,near-rigid,$/d' "no sentence names the row 'near-rigid'"
notices '/^Title,/s/,aim$/,/' 'expected rows of data/verdicts.csv, or a reason'
notices '/^Title,/s/,,aim$/,equation-1,aim/' 'expected rows of data/verdicts.csv, or a reason'
notices '/^Title,/s/,aim$/,dull/' "unknown reason 'dull'"
notices '/^Title,/s/^Title,/,/' 'expected a section and a sentence'
notices '/^Title,/s/,aim$/,aim,/' 'expected 4 fields'
notices '2,9999d' 'expected sentences'

finish
