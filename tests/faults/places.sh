#!/bin/sh
# Strange places: full disks, an unreadable sheet, another folder, a path with blanks, sources that cannot be written,
# a locale with a decimal comma, a user without rights.
. tests/faults/harness.sh
chmod 755 "$work"
project=$(pwd)

nobody() { "$@"; }
if [ "$(id -u)" -eq 0 ]; then
    nobody() { setpriv --reuid=nobody --regid=nogroup --clear-groups env HOME="$work/home" "$@"; }
    mkdir "$work/home" && chmod 777 "$work/home"
else
    echo 'places: not root, so no small disks, and everything as this user'
fi

# ---- another folder ----

works_from_anywhere() {
    expect "$@"
    (cd / && "$program" "$@") >"$work/out" 2>"$work/err"
    is_right $?
}
check 'eval from /' works_from_anywhere eval eq44 Omega=7.2915e-5 n=12 --digits 50
check 'vectors from /' works_from_anywhere vectors eq30 --golden
check 'verify from /' works_from_anywhere verify derivations kepler --json

# ---- full disks ----

# ARGUMENT...: make fails for want of space, what is there is whole; with more of it make completes.
say_no_space() { grep -q 'No space left on device' "$work/said"; }
small_disk() { mount -t tmpfs -o "size=$1" none "$work/disk"; }
fails_for_space() {
    if make --silent "$@" >"$work/said" 2>&1; then echo 'make has succeeded'; return 1; fi
    cat "$work/said"
    say_no_space
}
data_is_whole() {
    (cd "$work/disk/data" && find . -type f ! -name '*.tmp') | while read -r file; do
        cmp "$work/disk/data/$file" "data/$file" || exit 1
    done
}
data_completes() {
    mount -o remount,size=16m "$work/disk" && make --silent DATA="$work/disk/data" data && diff -r data "$work/disk/data"
}
library_completes() {
    mount -o remount,size=16m "$work/disk" && make --silent BUILD="$work/disk/build" "$work/disk/build/libcoulombtether.so"
}
mkdir "$work/disk"
if small_disk 300k 2>/dev/null; then
    trap 'umount "$work/disk"; rm -rf "$work"' EXIT
    check 'a disk too small for the data' fails_for_space DATA="$work/disk/data" data
    check 'no file of them is half there' data_is_whole
    check 'with more space they complete' data_completes
    umount "$work/disk" && small_disk 64k
    check 'a disk too small for the library' fails_for_space BUILD="$work/disk/build" "$work/disk/build/libcoulombtether.so"
    check 'with more space it completes' library_completes
else
    echo 'places: tmpfs cannot be mounted, no small disks'
fi

# ---- a copy with blanks in its path, of which nobody may write anything ----

if localedef -i de_DE -f UTF-8 "$work/de_DE.UTF-8" 2>/dev/null; then
    export LOCPATH="$work" LC_ALL=de_DE.UTF-8
    check 'the locale has a decimal comma' test "$(locale decimal_point)" = ,
else
    echo 'places: no source of the locale de_DE, all in C'
fi
copy="$work/a path with blanks"
mkdir "$copy" "$work/build" "$work/data"
cp -r Makefile README.md LICENSE .ci coverage data paper ref tests verify "$copy"
chmod -R a+rX "$copy"
chmod 777 "$work/build" "$work/data"

# The suites that handle files, folders and numbers as text.
suites='test_clients test_gate test_install test_weave test_conform test_expression'
checks_in_the_copy() (
    cd "$copy" && mkdir build && chmod 777 build || exit
    nobody make --silent CFLAGS=-O0 check ONLY="$suites"
)
data_of_read_only_sources() (
    chmod -R a-w "$copy"
    cd "$copy" && nobody make --silent CFLAGS=-O0 BUILD="$work/build" DATA="$work/data" data || exit
    cd "$project" && diff -r data "$work/data" && [ -z "$(find "$copy" -newer "$work/build/packages.found" -type f)" ]
)
stops_with_one_line() ( # FILE: unreadable
    chmod 0 "$copy/paper/$1" && touch "$copy/paper/$1"
    status=0
    cd "$copy" && nobody make --silent BUILD="$work/build" >"$work/out" 2>"$work/err" || status=$?
    chmod 444 "$copy/paper/$1"
    show $status
    # The others are make's own.
    [ $status -eq 2 ] && [ "$(grep -c "paper/$1: cannot be read" "$work/err")" -eq 1 ] &&
        [ "$(sed '/: cannot be read/d; /^make: /d' "$work/err")" = '' ]
)
check 'make and suites below a path with blanks, by nobody' checks_in_the_copy
check 'make data elsewhere, from sources that cannot be written' data_of_read_only_sources
if [ "$(id -u)" -eq 0 ]; then
    check 'an unreadable sheet' stops_with_one_line equations.yaml
    check 'unreadable derivation steps' stops_with_one_line derivations.yaml
fi

# ---- names that make cannot take ----

says_so() { # NAME=VALUE
    make "$1" >"$work/out" 2>"$work/err"
    [ $? -eq 2 ] && is_one_line "$work/err" && grep -q "${1%%=*}='.*': expected a name without blanks" "$work/err"
}
check 'BUILD with a blank' says_so BUILD='a b'
check 'DATA with a blank' says_so DATA='a b'
finish
