#!/bin/sh
# The sheets are the same data to every YAML reader: Python's (YAML 1.1), Ruby's, JavaScript's (1.1 and 1.2), Perl's and
# R's; those that are installed are tried, and named.
. tests/harness.sh
export LC_ALL=C.UTF-8
export NODE_PATH=/usr/share/nodejs # where Debian keeps its packages
here=tests/sheet/yaml tried= missing=

has() { "$@" >/dev/null 2>&1; }
lines() { "$@" >"$work/out" 2>"$work/errors" && sort "$work/out"; }
same() { diff "$1" "$2"; }

# NAME FIRST COMMAND...: what it reads of each sheet is what FIRST, Python, read.
reads() {
    reader=$1 first=$2
    shift 2
    tried="$tried, $reader"
    for sheet in equations derivations claims; do
        lines "$@" "paper/$sheet.yaml" ${version:+"$version"} >"$work/other" || cat "$work/errors"
        check "$sheet.yaml as $reader has it" same "$work/$first.$sheet" "$work/other"
    done
}

# The project's own reader, which is always there: what was compiled in is what the files say.
"$CT_PROGRAM" equations >"$work/within"
check 'the program reads the files as it reads itself' sh -c '
    "$CT_BUILD/sheet-check" paper/equations.yaml paper/derivations.yaml paper/claims.yaml equations | diff "$0" -' "$work/within"

python=/usr/bin/python3 version=
if has $python -c 'import yaml'; then
    for sheet in equations derivations claims; do
        lines $python $here/tree.py "paper/$sheet.yaml" >"$work/typed.$sheet"
        lines $python $here/tree.py "paper/$sheet.yaml" untyped >"$work/untyped.$sheet"
        check "$sheet.yaml has no other scalars than numbers and texts" \
            sh -c 'awk -F "\t" "\$2 != \"number\" && \$2 != \"text\" { print; bad = 1 } END { exit bad || NR < 100 }" "$0"' "$work/typed.$sheet"
    done
    tried=Python
    if has ruby -ryaml -e ''; then reads Ruby typed ruby $here/tree.rb; else missing="$missing Ruby"; fi
    if has node -e 'require("yaml")'; then
        version=1.1 && reads 'JavaScript 1.1' typed node $here/tree.js
        version=1.2 && reads 'JavaScript 1.2' typed node $here/tree.js
        version=
    else
        missing="$missing JavaScript"
    fi
    if has perl -MYAML::XS -e ''; then reads Perl untyped perl $here/tree.pl; else missing="$missing Perl"; fi
    if has Rscript -e 'library(yaml)'; then reads R typed Rscript $here/tree.R; else missing="$missing R"; fi
else
    missing=' all: no python3-yaml'
fi
echo "tried: ${tried:-none}; skipped:${missing:- none}"
finish
