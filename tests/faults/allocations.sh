#!/bin/sh
# Allocations that fail: each of those that read the sheet, with which nearly every command begins; after them the
# first $STEP of each command, and a sample of its others. Each by itself, and once more with all that follow it.
. tests/faults/harness.sh
STEP=${STEP:-500}

# What is said of a run by words: a check by the name of its command.
each() {
    # shellcheck disable=SC2086
    check "$1" survives_allocations $1
}

from=1 step=1000000000
each 'equations nothing'

from=$(allocations_of equations nothing) step=$STEP
each equations
each 'equations eq30 --json'
each 'eval eq07 Omega=7.2915e-5 k_c=8.99e9 m1=150 m2=150 L=10'
each 'eval eq07 Omega=7.2915e-5 k_c=8.99e9 m1=150 m2=150 L=10 --exact --digits 1000 --json'
each 'eval eq30 --as-printed m1=1 m2=3 x1=1 y1=2 z1=3 x2=4 y2=5 z2=6'
each 'eval eq41roots Omega=1 C1=10 C2=2'
each 'eval flow_linear Omega=1 L_ref=1 C1=10 C2=2 t=1 psi_0=0.1 theta_0=0.1 dL_0=0 psi_dot_0=0 theta_dot_0=0 dL_dot_0=0'
each table1
each 'figure 4'
each 'figure 7a --rk4 100'
each 'trajectory linear --at 100,200 --rk4 50'
each 'trajectory nonlinear --at 1000 --digits 40'
each 'verify derivations kepler'
each 'verify errors --count 2'
each 'study pitch'
each 'vectors eq14 --count 3 --seed 1'
each 'vectors eq41roots --golden'
each 'conform --answers data/golden/eq09.csv eq09'
each 'conform --kills --only eq30'
each 'equations eq30 --json'

# The client has been started, and hangs: it has to go with the program.
oracle() {
    LD_PRELOAD=$shim FAULTS=$work FAULTS_AT=$1 "$program" conform --only eq09 --timeout 1 -- "$client" hang
}
refuses_with_client() {
    status=0
    without_orphans oracle "$1" || status=$?
    if is_refusal $status || is_right $status; then return; fi
    show $status
    return 1
}
right=1
"$program" conform --only eq09 --timeout 1 -- "$client" hang >"$work/expected" 2>&1
last=$(allocations_of conform --only eq09 --timeout 1 -- "$client" hang)
n=$last
while [ "$n" -gt "$from" ]; do
    check "conform, allocation $n of $last" refuses_with_client "$n"
    n=$((n - 1 - (last - n) / 8))
    refused=$((refused + 1))
done

echo "allocations: $((refused + survived)) made to fail, $survived of them got along without"
finish
