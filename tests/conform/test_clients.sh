#!/bin/sh
# The oracle asks every client in tests/clients/, each the equations in a language of its own. Where a
# language is missing its client is skipped, and the line says so. Prints Check's line of totals.
set -u
work=$CT_BUILD/clients
mkdir -p "$work" || exit 1
checks=0 failures=0

# CLAIM COMMAND...: the command succeeds; what it printed last is the result, all of it when it does not.
check() {
    claim=$1
    shift
    checks=$((checks + 1))
    if "$@" >"$work/log" 2>&1; then
        echo "$claim: $(grep . "$work/log" | tail -n 1)"
    else
        failures=$((failures + 1))
        echo "$claim: failed: $*"
        sed 's/^/    /' "$work/log"
    fi
}

conforms() { "$CT_PROGRAM" conform -- "$@"; }

skips_what_it_does_not_know() {
    reply=$(echo 'eq99 some-vector 1 2' | "$@")
    echo "$reply"
    case $reply in 'some-vector skip '?*) ;; *) return 1 ;; esac
}

client() {
    language=$1
    shift
    check "$language conforms" conforms "$@"
    check "$language skips what it does not know" skips_what_it_does_not_know "$@"
}

# LANGUAGE PROGRAM...: the first of these programs that there is, in $found.
find_one() {
    language=$1
    shift
    for found; do
        command -v "$found" >/dev/null && return
    done
    echo "$language skipped: not found: $*"
    return 1
}

# CC, FC and their flags are several words each.
# shellcheck disable=SC2046,SC2086
compile_c() {
    ${CC:-cc} -std=c11 -Wall -Wextra -Wpedantic -D_POSIX_C_SOURCE=200809L -Iref ${CFLAGS-} -o "$work/c" \
        tests/clients/client.c "$CT_BUILD/libcoulombtether.a" $(${PKG_CONFIG:-pkg-config} --libs gsl) -lm ${LDFLAGS-} &&
        echo compiled
}

# shellcheck disable=SC2086
compile_fortran() {
    $FC -std=f2018 -Wall ${FFLAGS--O2} -J "$work" -o "$work/fortran" tests/clients/client.f90 && echo compiled
}

check "C compiles" compile_c
client C "$work/c"

FC=${FC:-gfortran}
if find_one Fortran "${FC%% *}"; then
    check "Fortran compiles" compile_fortran
    client Fortran "$work/fortran"
fi
if find_one JavaScript node nodejs; then
    client JavaScript "$found" tests/clients/client.js
fi
if find_one Octave octave-cli octave; then
    client Octave "$found" --quiet --no-init-file tests/clients/client.m
fi
if find_one Python python3; then
    client Python "$found" tests/clients/client.py
fi

echo "$((100 * (checks - failures) / checks))%: Checks: $checks, Failures: $failures, Errors: 0"
[ "$failures" -eq 0 ]
