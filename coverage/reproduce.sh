#!/bin/sh
# Usage: coverage/reproduce.sh FOLDER [COMPILER\ FLAGS ...]
# Whether data/ is the same to the byte, and ref/ within its error bounds, whatever the compiler and its flags.
# A line a compiler and flags, six of them unless they are named; those that are not there are said and left out.
set -u
folder=$1
shift
failed=0

try() { # COMPILER FLAGS
    name=$(echo "$1 $2" | tr -d ' =')
    build=$folder/$name
    if ! command -v "$1" >/dev/null; then
        echo "$1 $2: left out, there is no $1"
        return
    fi
    mkdir -p "$build"
    if ! make --silent BUILD="$build" DATA="$build/data" CC="$1" CFLAGS="$2" data >"$build/log" 2>&1; then
        tail -n 20 "$build/log"
        result='does not build'
    elif ! diff -r data "$build/data" >>"$build/log" 2>&1; then
        tail -n 1 "$build/log"
        result='data/ differs'
    elif ! "$build/coulomb-tether" verify errors --count 10000 >"$build/errors" 2>&1; then
        cat "$build/errors"
        result='ref/ errs by more than its bounds'
    else
        worst=$(awk '$3 + 0 > worst { worst = $3 + 0; id = $1 } END { print id, "errs by", worst }' "$build/errors")
        version=$("$1" --version | sed -n "1s/.* \([0-9][0-9.]*\).*/\1/p")
        echo "$1 $version $2: data/ is the same; of ref/ $worst roundings at most"
        return
    fi
    echo "$1 $2: $result"
    failed=1
}

[ $# -gt 0 ] || set -- 'gcc -O0' 'gcc -O2' 'gcc -O3 -march=native' 'clang -O0' 'clang -O2' 'clang -O3 -march=native'
for each; do
    try "${each%% *}" "${each#* }"
done
exit "$failed"
