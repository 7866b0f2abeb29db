#!/bin/sh
# The sheets are the same data to every YAML reader: Python's (YAML 1.1), Ruby's, JavaScript's (1.1 and 1.2), Perl's and
# R's; those that are installed are tried, and named.
# shellcheck disable=SC2086  # no sheet's name has a blank
. tests/harness.sh
export LC_ALL=C.UTF-8
export NODE_PATH=/usr/share/nodejs # where Debian keeps its packages
sheets='paper/equations.yaml paper/derivations.yaml paper/claims.yaml'
here=tests/sheet/yaml tried= missing=

has() { "$@" >/dev/null 2>&1; }

# NAME FIRST COMMAND...: what it reads of the sheets is what Python read, FIRST.
reads() {
    tried="$tried, $1" name=$1 first=$work/$2
    shift 2
    check "the sheets as $name has them" agrees "$@"
}
agrees() { "$@" >"$work/other" && sort "$work/other" | diff "$first" -; }

# The project's own reader, which is always there: what was compiled in is what the files say.
"$CT_PROGRAM" equations >"$work/within"
check 'the program reads the files as it reads itself' sh -c '
    "$CT_BUILD/sheet-check" $1 equations | diff "$0" -' "$work/within" "$sheets"

python=/usr/bin/python3
if has $python -c 'import yaml'; then
    check 'the sheets as Python has them' $python $here/tree.py "$work/typed" "$work/untyped" $sheets
    sort -o "$work/typed" "$work/typed" && sort -o "$work/untyped" "$work/untyped"
    check 'no other scalars than numbers and texts' \
        awk -F '\t' '$2 != "number" && $2 != "text" { print; bad = 1 } END { exit bad || NR < 1000 }' "$work/typed"
    tried=Python
    if has ruby -ryaml -e ''; then reads Ruby typed ruby $here/tree.rb $sheets; else missing="$missing Ruby"; fi
    if has node -e 'require("yaml")'; then reads JavaScript typed node $here/tree.js $sheets; else missing="$missing JavaScript"; fi
    if has perl -MYAML::XS -e ''; then reads Perl untyped perl $here/tree.pl $sheets; else missing="$missing Perl"; fi
    if has Rscript -e 'library(yaml)'; then reads R typed Rscript $here/tree.R $sheets; else missing="$missing R"; fi
else
    missing=' all: no python3-yaml'
fi
echo "tried: ${tried:-none}; skipped:${missing:- none}"
finish
