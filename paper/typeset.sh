#!/bin/sh
# typeset.sh FOLDER PDF: LaTeX on the woven edition in FOLDER, until its references stand. Fails where one stays
# undefined, or a box sticks out by more than 5 points. Without arguments it only looks whether all that the edition
# needs is there. Installs nothing.
set -eu
export LC_ALL=C # a comma is no decimal point here

missing() {
    echo "$1 is missing: run \"make deps-paper\"." >&2
    exit 1
}
for tool in pandoc gnuplot dot pdflatex kpsewhich pdftocairo; do
    command -v "$tool" >/dev/null || missing "$tool"
done
for file in lmodern.sty microtype.sty listings.sty booktabs.sty; do
    kpsewhich "$file" >/dev/null || missing "LaTeX's $file"
done
[ $# -gt 0 ] || exit 0

cd "$1"
name=coulomb-tether
log=$name.log
# The same file every time: its dates are those of no day.
SOURCE_DATE_EPOCH=0 FORCE_SOURCE_DATE=1
export SOURCE_DATE_EPOCH FORCE_SOURCE_DATE
for pass in 1 2 3 4; do
    pdflatex -interaction=nonstopmode -halt-on-error -file-line-error "$name.tex" >typeset.out ||
        { grep -A 3 -E '^[^ ]+:[0-9]+: ' "$log" >&2 || tail -n 20 typeset.out >&2; exit 1; }
    [ "$pass" -eq 1 ] || grep -q 'Rerun to get\|Table widths have changed' "$log" || break
done

awk -v name="$log" '
    seen[$0]++ { next }
    /LaTeX Warning: (Reference|Citation|Hyper reference).*undefined/ { print name ": " $0; bad = 1 }
    /name\{.*\} has been referenced but does not exist/ { print name ": " $0; bad = 1 }
    /^Overfull .[hv]box \(/ { if (substr($3, 2) + 0 > 5) { print name ": " $0; bad = 1 } }
    END { exit bad }' "$log" typeset.out >&2
cd - >/dev/null
cp "$1/$name.pdf" "$2.tmp"
mv "$2.tmp" "$2"
sed -n 's/^Output written on .*(\([0-9]* pages\).*/\1/p' "$1/typeset.out"
