#!/bin/sh
# Usage: coverage/report.sh FOLDER
# Makes FOLDER/index.html from the traces in FOLDER/build and fails where a folder of sources is covered
# less than coverage/thresholds asks for, or where a line is left out without a reason. Works with lcov 1.16 and 2.x,
# which name their options differently.
set -eu
export LC_ALL=C
out=$1
log=$out/log
: >"$log"

case $(lcov --version) in
    *version\ 1.*) branches=lcov_branch_coverage=1 html_branches=genhtml_branch_coverage=1 lenient= ;;
    # 2.x calls it inconsistent that a macro has several branches on one line, and unused what a filter did not need.
    *) branches=branch_coverage=1 html_branches=$branches lenient='--ignore-errors inconsistent,unused' ;;
esac

# Where memory runs out, out_of_memory() ends the program; no suite has so little of it.
exhausted='out_of_memory\(\);'

# What else is left out, a line each: LCOV_EXCL_LINE or LCOV_EXCL_BR_LINE (its branches alone), a colon and the reason.
marks() { grep -rnoE "LCOV_EXCL.*|^ *$exhausted" ref verify; }
if marks | grep -vE "LCOV_EXCL_(BR_)?LINE: [^ ]|$exhausted"; then
    echo 'coverage: left out without a reason on the line, or more than a line' >&2
    exit 1
fi

# Both chatter even when quiet, so they are heard only when they fail.
logged() { "$@" >>"$log" 2>&1 || { cat "$log" >&2; exit 1; }; }
# From 2.4 on lcov has a pattern begin and end with a word.
# shellcheck disable=SC2086
quiet_lcov() { logged lcov --quiet --rc "$branches" --rc "lcov_excl_line=LCOV_EXCL_LINE|out_of_memory(?=\\(\\);)" $lenient "$@"; }

# The first capture knows every line compiled, the second those executed: a file that nothing ran counts too.
capture() { quiet_lcov --capture --directory "$out/build" --base-directory . --no-external "$@"; }
capture --initial --output-file "$out/none.info"
capture --output-file "$out/run.info"
quiet_lcov --add-tracefile "$out/none.info" --add-tracefile "$out/run.info" --output-file "$out/all.info"
quiet_lcov --extract "$out/all.info" "$(pwd)/ref/*" "$(pwd)/verify/*" --output-file "$out/report.info"
# shellcheck disable=SC2086
logged genhtml --quiet --rc "$html_branches" $lenient --prefix "$(pwd)" --title 'The Coulomb tether' \
    --output-directory "$out" "$out/report.info"

# Of each folder what its files' records count, added up and compared as numbers: 99.96 % of the lines is not all of them. And
# whatever no test executes, by its name; lcov 2.2 counts functions in lines FNA of their own.
status=0
awk -F'[:,]' -v root="$(pwd)/" '
    FNR == NR { if (!/^#/) thresholds[++count] = $0; next }
    /^SF:/ { file = substr($0, 4); sub(root, "", file); folder = file; sub("/.*", "", folder) }
    /^(LF|FNF|BRF):/ { all[folder, $1] += $2 }
    /^(LH|FNH|BRH):/ { hit[folder, substr($1, 1, length($1) - 1) "F"] += $2 }
    /^FNDA:0,/ { missed[folder] = missed[folder] file ": function " $3 "\n" }
    /^FNA:[0-9]+,0,/ { missed[folder] = missed[folder] file ": function " $4 "\n" }
    /^DA:[0-9]+,0(,|$)/ { missed[folder] = missed[folder] file ":" $2 "\n" }
    END {
        split("LF FNF BRF", record, " ")
        split("lines functions branches", kind, " ")
        for (i = 1; i <= count; i++) {
            split(thresholds[i], least, " ")
            folder = least[1]
            for (k = 1; k <= 3; k++) {
                h = hit[folder, record[k]] + 0
                n = all[folder, record[k]] + 0
                fine = n > 0 && 100 * h >= least[k + 1] * n
                printf "%-7s %-9s %5d of %5d  %5.1f %%, at least %s%s\n", folder, kind[k], h, n, n ? int(1000 * h / n) / 10 : 0,
                    least[k + 1], fine ? "" : ": TOO FEW"
                failed += !fine
            }
            printf "%s", missed[folder]
        }
        exit failed > 0
    }' coverage/thresholds "$out/report.info" || status=1
printf '%d lines left out:\n' "$(marks | wc -l)"
marks | sed -E 's/LCOV_EXCL_(BR_)?LINE: */ /; s| *\*/.*||'
exit "$status"
