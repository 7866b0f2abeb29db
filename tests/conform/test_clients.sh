#!/bin/sh
# The oracle asks the clients in tests/clients/, each the equations in a language of its own: those that CLIENTS names, or
# all; without it C alone. Where a language is missing its client is skipped, and the line says so.
. tests/harness.sh

says() { # NAME COMMAND...: a check; what the command printed last is its result
    check "$@"
    echo "$1: $(grep . "$work/log" | tail -n 1)"
}

skips_what_it_does_not_know() {
    reply=$(echo 'eq99 some-vector 1 2' | "$@")
    echo "$reply"
    case $reply in 'some-vector skip '?*) ;; *) return 1 ;; esac
}

# LANGUAGE PROGRAM ARGUMENT...
client() {
    language=$1
    shift
    says "$language conforms" "$CT_PROGRAM" conform -- "$@"
    says "$language skips what it does not know" skips_what_it_does_not_know "$@"
}

# CC, FC and their flags are several words each.
# shellcheck disable=SC2046,SC2086
compile_c() {
    ${CC:-cc} -std=c11 -Wall -Wextra -Wpedantic -D_POSIX_C_SOURCE=200809L -I. -Iref -Iverify ${CFLAGS-} -o "$work/c" \
        tests/clients/client.c "$CT_BUILD/verify/evaluate/reference.o" "$CT_BUILD/libcoulombtether.a" $(${PKG_CONFIG:-pkg-config} --libs gsl) -lm ${LDFLAGS-}
}
# shellcheck disable=SC2086
compile_fortran() { ${FC:-gfortran} -std=f2018 -Wall ${FFLAGS--O2} -J "$work" -o "$work/fortran" tests/clients/client.f90; }

# LANGUAGE PROGRAM...: whether it is asked for, and the first of these programs that there is, in $found.
find_one() {
    language=$1
    case " ${CLIENTS:-C} " in *" $language "* | *' all '*) ;; *) return 1 ;; esac
    shift
    for found; do
        command -v "$found" >/dev/null && return
    done
    echo "$language skipped: not found: $*"
    return 1
}

if find_one C sh; then
    check 'C compiles' compile_c
    client C "$work/c"
fi
if find_one Fortran "${FC:-gfortran}"; then
    check 'Fortran compiles' compile_fortran
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

# Reports are as their schema has them: of a client that is right, and of some that are not.
are_as_described() { # FAULT...
    for fault; do
        "$CT_PROGRAM" conform --report "$work/$fault.json" --only eq07,eq38,eq42,roots,flow_linear -- "$CT_BUILD/tests/faulty" "$fault"
    done
    (cd "$work" && python3 -c 'import json, jsonschema, sys
schema = json.load(sys.stdin)
for name in sys.argv[1:]:
    print(name, flush=True)
    jsonschema.validate(json.load(open(name + ".json")), schema)' "$@") <verify/report.schema.json
}
if python3 -c 'import jsonschema' 2>/dev/null; then
    check 'reports of clients' are_as_described none wrong count value malformed wrong-id printed crash exit-3
else
    echo 'report.schema.json skipped: not found: python3 with jsonschema'
fi
finish
