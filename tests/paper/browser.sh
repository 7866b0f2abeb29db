#!/bin/sh
# browser.sh FOLDER: the edition's pages in a real browser, chromium without a window: the figures check themselves against
# golden vectors, a slider changes the curves, and no page writes an error to the console.
set -eu
folder=$(cd "$1" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

command -v chromium >/dev/null || { echo 'chromium is missing: run "make deps-ci".' >&2; exit 1; }

page() { # PAGE[#HASH] OPTION ...: what the page holds once its scripts have run
    page=$1
    shift
    timeout 120 chromium --headless --no-sandbox --disable-gpu --disable-quic --no-first-run --disable-background-networking \
        --disable-component-update --disable-sync --user-data-dir="$work/profile" --enable-logging=stderr --v=0 --virtual-time-budget=1000 "$@" "file://$folder/$page" 2>"$work/log"
}
fails() { echo "browser.sh: $1" >&2; exit 1; }

page turn.html --dump-dom >"$work/paper.html"
page 'turn.html#n=20&dL=-0.5' --dump-dom >"$work/turned.html"
said=$(sed -n 's/.*\(>[0-9]* of [0-9]* vectors passed in this browser[^<]*\).*/\1/p' "$work/paper.html" | cut -c 2-)
echo "$said"
echo "$said" | awk '$1 > 100 && $1 + 0 == $3 + 0 { good = 1 } END { exit !good }' || fails 'the figures do not pass their vectors'
for id in turn-rate turn-roots turn-psi turn-dL; do
    for file in paper turned; do
        tr -d '\n' <"$work/$file.html" | sed -n "s/.*id=\"$id\"[^>]*>\(<svg.*\)/\1/p" | sed 's/<\/svg>.*//' >"$work/$file.svg"
        grep -q '<path' "$work/$file.svg" || fails "$id: no curve"
    done
    if cmp -s "$work/paper.svg" "$work/turned.svg"; then fails "$id: a slider changes nothing"; fi
done
for path in "$folder"/*.html; do
    page "$(basename "$path")" --dump-dom >"$work/dom"
    grep -q '<main>' "$work/dom" || fails "$path: nothing is shown"
    if grep 'CONSOLE' "$work/log"; then fails "$path: a message on the console"; fi
done
echo "$(ls "$folder"/*.html | wc -l) pages without a message on the console"
