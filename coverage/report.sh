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

# Whatever no test executes, by its name. lcov 2.2 counts functions in lines FNA of their own.
unexecuted() { # FOLDER
    awk -F'[:,]' -v root="$(pwd)/" '
        /^SF:/ { file = substr($0, 4); sub(root, "", file) }
        /^FNDA:0,/ { print file ": function " $3 }
        /^FNA:[0-9]+,0,/ { print file ": function " $4 }
        /^DA:[0-9]+,0/ { print file ":" $2 }' "$out/$1.info"
}

# lcov's summary has lines like "  branches...: 43.7% (7 of 16 branches)". The counts are compared, not the
# rounded percentages: 99.96 % of the lines is not all of them.
gate() { # FOLDER LINES FUNCTIONS BRANCHES
    quiet_lcov --extract "$out/report.info" "$(pwd)/$1/*" --output-file "$out/$1.info"
    # shellcheck disable=SC2086
    lcov --rc "$branches" $lenient --summary "$out/$1.info" 2>&1 |
        awk -v folder="$1" -v lines="$2" -v functions="$3" -v branches="$4" '
        BEGIN { least["lines"] = lines; least["functions"] = functions; least["branches"] = branches }
        match($0, /\([0-9]+ of [0-9]+ /) {
            split(substr($0, RSTART + 1, RLENGTH - 1), count, " ")
            hit = count[1]; all = count[3]
            kind = $1; sub(/\..*/, "", kind)
            fine = 100 * hit >= least[kind] * all
            printf "%-7s %-9s %5d of %5d  %5.1f %%, at least %s%s\n", folder, kind, hit, all,
                int(1000 * hit / all) / 10, least[kind], fine ? "" : ": TOO FEW"
            failed += !fine
            seen++
        }
        END { if (seen != 3) print folder ": lcov gave " seen + 0 " of 3 figures"; exit failed || seen != 3 }'
}

status=0
while read -r folder lines functions least_branches; do
    case $folder in '#'*) continue ;; esac
    gate "$folder" "$lines" "$functions" "$least_branches" || status=1
    unexecuted "$folder"
done <coverage/thresholds
printf '%d lines left out:\n' "$(marks | wc -l)"
marks | sed -E 's/LCOV_EXCL_(BR_)?LINE: */ /; s| *\*/.*||'
exit "$status"
