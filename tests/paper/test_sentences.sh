#!/bin/sh
# Every sentence of the paper names rows of data/verdicts.csv, or has a reason in paper/sentences.csv why it has none; every row on
# what the paper says is named by a sentence. And what is missing is noticed.
. tests/harness.sh

read_sentences() { # FILE
    LC_ALL=C awk -F , '
        function wrong(text) { print FILENAME ":" FNR ": " text; mistakes = 1 }
        { gsub(/"[^"]*"/, "x") } # a text that holds commas
        NR == FNR { kind[$1] = $3; next }
        FNR == 1 { next }
        NF != 4 || $1 == "" || $2 == "" { wrong("expected a section, a sentence, rows, a reason") }
        ($3 == "") == ($4 == "") { wrong("expected rows of data/verdicts.csv, or a reason why there are none") }
        $4 !~ /^(aim|definition|input|cited|background)?$/ { wrong("unknown reason " $4) }
        {
            count = split($3, names, " ")
            for (k = 1; k <= count; k++) {
                if (!(names[k] in kind))
                    wrong("unknown row " names[k])
                named[names[k]]
            }
        }
        END {
            for (id in kind)
                if (id != "id" && kind[id] != "beyond" && !(id in named))
                    wrong("no sentence names the row " id)
            exit mistakes
        }' data/verdicts.csv "$1"
}

# EXPRESSION MESSAGE: sentences.csv edited so stops with that.
stops_with() {
    sed "$1" paper/sentences.csv >"$work/sentences.csv"
    ! cmp -s paper/sentences.csv "$work/sentences.csv" && ! read_sentences "$work/sentences.csv" >"$work/out" && grep -F -- "$2" "$work/out"
}
notices() { check "$1" stops_with "$@"; }

check 'all sentences' read_sentences paper/sentences.csv
notices 's/,equation-12,$/,equation-99,/' 'unknown row equation-99'
notices '/,equation-12,$/d' 'no sentence names the row equation-12'
notices '/,near-rigid,$/d' 'no sentence names the row near-rigid'
notices '/^Title,/s/,aim$/,/' 'expected rows of data/verdicts.csv, or a reason'
notices '/^Title,/s/,,aim$/,equation-1,aim/' 'expected rows of data/verdicts.csv, or a reason'
notices '/^Title,/s/,aim$/,dull/' 'unknown reason dull'
notices '/^Title,/s/^Title,/,/' 'expected a section, a sentence'
notices '/^Title,/s/,aim$/,aim,/' 'expected a section, a sentence'
notices '2,9999d' 'no sentence names the row equation-1'
finish
