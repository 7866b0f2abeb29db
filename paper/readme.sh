#!/bin/sh
# Prints README.md with its generated blocks made anew: README.md BLOCK=FILE ...
# A block stands between <!-- BLOCK --> and <!-- end of BLOCK -->.
set -eu

readme=$1
shift
text=$(cat "$readme")
for pair; do
    block=${pair%%=*} file=${pair#*=}
    printf '%s\n' "$text" | grep -q "^<!-- $block -->$" || {
        echo "readme.sh: no block '$block' in $readme" >&2
        exit 1
    }
    text=$(printf '%s\n' "$text" | awk -v block="$block" -v file="$file" '
        $0 == "<!-- end of " block " -->" { inside = 0 }
        !inside { print }
        $0 == "<!-- " block " -->" { inside = 1; while ((getline line < file) > 0) print line }')
done
printf '%s\n' "$text"
