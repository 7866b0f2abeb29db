#!/bin/sh
# typeset.sh FOLDER PDF: LaTeX on the woven edition in FOLDER, until its references stand. Fails where one stays undefined, or a box
# sticks out. Without arguments it only looks whether all that the edition needs is there. Installs nothing.
set -eu

for tool in pandoc gnuplot dot pdflatex; do
    command -v "$tool" >/dev/null || { echo "$tool is missing: run \"make deps-paper\"." >&2; exit 1; }
done
[ $# -gt 0 ] || exit 0

cd "$1"
# The same file every time: its dates are those of no day.
export SOURCE_DATE_EPOCH=0 FORCE_SOURCE_DATE=1
for pass in 1 2 3 4; do
    pdflatex -interaction=nonstopmode -halt-on-error -file-line-error coulomb-tether.tex >typeset.out ||
        { grep -A 3 -E '^[^ ]+:[0-9]+: ' coulomb-tether.log >&2 || tail -n 20 typeset.out >&2; exit 1; }
    [ "$pass" -eq 1 ] || grep -q 'Rerun to get\|Table widths have changed' coulomb-tether.log || break
done
! grep -E '^Overfull|LaTeX Warning: .*undefined|has been referenced but does not exist' coulomb-tether.log typeset.out >&2 || exit 1
cd - >/dev/null
mv "$1/coulomb-tether.pdf" "$2"
sed -n 's/^Output written on .*(\([0-9]* pages\).*/\1/p' "$1/typeset.out"
