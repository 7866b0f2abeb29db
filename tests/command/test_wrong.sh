#!/bin/sh
# Wrong sheets and wrong steps: the build's guard stops what cannot be read, and what can be read and is wrong is
# left undecided, with exit status 1, or comes out otherwise than its evidence says, which is told.
. tests/harness.sh
export LC_ALL=C

ends() { # STATUS COMMAND...: its outputs are kept in said
    expected=$1
    shift
    "$@" >"$work/said" 2>&1
    status=$?
    [ "$status" -eq "$expected" ] || { echo "exit status $status"; cat "$work/said"; return 1; }
}
says() { grep -qF -- "$1" "$work/said" || { cat "$work/said"; return 1; }; }
nothing_in() { [ ! -s "$1" ] || { cat "$1"; return 1; }; }
one_line() { [ "$(wc -l <"$work/said")" -eq 1 ] || { cat "$work/said"; return 1; }; }

# The program on sheets of its own, in $work/paper; as the program's own, they are named paper/X.yaml.
wrong=$work/coulomb-tether
mkdir "$work/paper"
printf '#!/bin/sh\ncd "%s" && exec "%s/sheet-check" paper/equations.yaml paper/derivations.yaml paper/claims.yaml "$@"\n' \
    "$work" "$CT_BUILD" >"$wrong"
chmod +x "$wrong"
make_wrong() { # SED-SCRIPT: it changes one of the sheets, or more
    changed=1
    for sheet in equations derivations claims; do
        sed "$1" "paper/$sheet.yaml" >"$work/paper/$sheet.yaml" || return 1
        cmp -s "paper/$sheet.yaml" "$work/paper/$sheet.yaml" || changed=0
    done
    return $changed
}

# What a program with a wrong sheet says in the end, after its usual prints.
stops() { # NAME SED-SCRIPT STATUS TEXT ARGUMENTS...
    check "$1: made" make_wrong "$2"
    name=$1 status=$3 text=$4
    shift 4
    check "$name" ends "$status" "$wrong" "$@"
    check "$name" says "$text"
}

# ---- what cannot be read ----

guard() { # NAME STATUS TEXT ARGUMENTS...: the build's guard
    name=$1 status=$2 text=$3
    shift 3
    check "$name" ends "$status" "$CT_BUILD/sheet-check" "$@"
    check "$name" says "$text"
    check "$name" one_line
}
sed 's/^quantities:/quantitiez:/' paper/equations.yaml >"$work/sheet.yaml"
sed 's/^steps:/stepz:/' paper/derivations.yaml >"$work/steps.yaml"
equations=paper/equations.yaml steps=paper/derivations.yaml claims=paper/claims.yaml
guard 'no sheet' 2 'usage: sheet-check'
guard 'two sheets' 2 'usage: sheet-check' $equations $steps
guard 'no such sheet' 1 '/sheet: cannot be read' "$work/sheet" $steps $claims
guard 'a folder for a sheet' 1 'paper: cannot be read' paper $steps $claims
guard 'a wrong sheet' 1 ":1: unknown key 'quantitiez'" "$work/sheet.yaml" $steps $claims
guard 'no such steps' 1 '/steps: cannot be read' $equations "$work/steps" $claims
sed 's/^  verdict:/  verdikt:/' $claims >"$work/claims.yaml"
guard 'no such claims' 1 '/claims: cannot be read' $equations $steps "$work/claims"
guard 'wrong claims' 1 ": unknown key 'verdikt'" $equations $steps "$work/claims.yaml"
guard 'wrong steps' 1 ":1: unknown key 'stepz'" $equations "$work/steps.yaml" $claims

stops 'an unreadable sheet' 's/^quantities:/quantitiez:/' 1 "coulomb-tether: paper/equations.yaml:" equations
check 'an unreadable sheet' one_line
stops 'unreadable steps' 's/^steps:/stepz:/' 1 'coulomb-tether: paper/derivations.yaml:' verify derivations
check 'unreadable steps' one_line
stops 'unreadable steps, equations asked for' 's/^steps:/stepz:/' 1 'coulomb-tether: paper/derivations.yaml:' equations
stops 'unreadable claims' 's/^  evidence:/  avidence:/' 1 'coulomb-tether: paper/claims.yaml:' verify claims
check 'unreadable claims' one_line
stops 'unreadable claims, one asked for' 's/^  evidence:/  avidence:/' 1 'coulomb-tether: paper/claims.yaml:' verify claims routh
stops 'a step of another name' 's/^  pitch_law:/  pitch_low:/' 1 "no derivation step 'pitch_law'" study forced
stops 'a step of another name' 's/^  pitch_law:/  pitch_low:/' 1 "no derivation step 'pitch_law'" design

# ---- what is wrong ----

verdicts() { # ids and verdicts, in CSV or as a table
    names='undecided|holds|holds as corrected|qualified|refuted|definition|not decidable' how='exact|certified|measured'
    sed -nE "s/^([A-Za-z0-9_-]+),.*,($names),($how),.*/\1 \2/p; s/^([A-Za-z0-9_-]+) +($names) +($how) .*/\1 \2/p"
}
verdicts <data/verdicts.csv >"$work/right"

# The verdicts on equations, with the claims that they rest on, Table 1, and some claims, with those that they cite: these at
# least are not as they were, and what comes out otherwise is told.
not_so() { # CLAIM...
    grep -vE '^(equation|table1)-' "$work/right" | sed 's/ .*//' | grep -vxF "$(printf '%s\n' "$@" complex-pairs fastest-decay phase-damps \
        sum-bounds screened-force orbit-normal omega-of-euler)" >"$work/others"
    awk 'NR == FNR { other[$1 ":"] = 1; next } /^[^ #]/ { on = !($1 in other) } on' "$work/others" "$work/paper/claims.yaml" >"$work/claims.yaml"
    mv "$work/claims.yaml" "$work/paper/"
    check 'equations' ends 1 "$wrong" verify claims
    verdicts <"$work/said" >"$work/wrong"
    check 'all claims' [ "$(wc -l <"$work/wrong")" -eq "$(($(wc -l <"$work/right") - $(wc -l <"$work/others")))" ]
    grep -v ' undecided$' "$work/wrong" | grep -vxFf "$work/right" | sed 's/ .*//' >"$work/otherwise"
    while read -r claim; do
        check "$claim otherwise" grep -q "$claim comes out as" "$work/said"
    done <"$work/otherwise"
    for claim; do
        check "$claim" grep -qxe "$claim undecided" -e "coulomb-tether: .*: $claim comes out as .*" "$work/wrong" "$work/said"
    done
}
check 'equations: made' make_wrong '
    s/dL_dot - 3\*Omega^2\*psi$/dL_dot - 4*Omega^2*psi/
    s/theta_ddot: -4\*Omega^2/theta_ddot: -5*Omega^2/
    s/dL_ddot: -(C1 - 9\*Omega^2)/dL_ddot: -(C1 - 8*Omega^2)/
    s/a2: C1 - 2\*Omega^2/a2: C1 - 3*Omega^2/
    s/Q_ref: -3\*Omega^2\*L^3/Q_ref: -4*Omega^2*L^3/
    s/x1_ddot: 2\*Omega/x1_ddot: 3*Omega/
    s/x2: -m1\/m2\*x1/x2: -m2\/m1*x1/
    s/margin1: C1 - 9/margin1: C1 - 8/
    s/L_ddot: (2\*Omega/L_ddot: (4*Omega/
    s/BO_12: cos(theta)/BO_12: sin(theta)/
    s/w_1: -Omega\*sin(theta)$/w_1: -Omega*cos(theta)/
    s/(-C1\*dL - C2\*dL_dot)/(-C1*dL + C2*dL_dot)/'
not_so equation-2a equation-7 equation-41 routh n12-optimal length-wiggle frequencies pitch-decoupled yaw-energy opposite-charges \
    static-unstable nadir-axis masses-cancel cosines-cited
check 'the sum' says ", $(grep -c ' undecided$' "$work/wrong") undecided"
check 'gains and start: made' make_wrong "
    s/Kepler's third/Kepler\"s third/
    s/C1: n\*Omega^2/C1: n*Omega^3/
    s/value: 0\.1, meaning: length/value: 9.1, meaning: length/
    s/value: 8\.99e+9/value: 8.89e+9/"
for claim in equation-43 simulation-gains figure-6 coulomb-constant charges-opposite; do
    check "$claim" ends 1 "$wrong" verify claims "$claim" --json
    check "$claim" grep -qe "$claim is undecided" -e "$claim comes out as" -e "$claim: the digits of" -e "\"verdict\": \"undecided\"" "$work/said"
done
check 'a title with a quotation mark' ends 0 "$wrong" verify claims equation-38 --json
"$PYTHON" paper/claims.py csv <"$work/said" >"$work/said.csv" && mv "$work/said.csv" "$work/said"
check 'a quotation mark in CSV' says 'Kepler""s third'

stops 'a step that is wrong' 's/dL_dot - 3\*Omega^2\*psi$/dL_dot - 4*Omega^2*psi/' 1 'BROKEN: paper/derivations.yaml:' verify derivations attitude
check 'the same as JSON' ends 1 "$wrong" verify derivations attitude --json
check 'its name' says 'coulomb-tether: step attitude is broken, see verify derivations attitude'
check 'its report in a file' ends 1 "$wrong" verify derivations attitude -o report
check 'nothing else' nothing_in "$work/said"
check 'the report says why' grep -q 'BROKEN: paper/derivations.yaml:' "$work/report"
stops 'a printed formula in a line' 's/across it: I_22 = m1/across it: I_22 + 0*eq30.I_22@printed = m1/' 1 '{{I_{22}}_{(30\\,\\mathrm{printed})}}' \
    verify derivations inertia_of_the_pair --json
stops 'a misprint that is none' 's/sqrt(3\*GM\/R_c^3)/sqrt(1*GM\/R_c^3)/; s/R_c^3\/3)/R_c^3\/1)/' 1 \
    ': expected to differ as printed: it holds' verify derivations kepler
check 'its place' says 'BROKEN: paper/derivations.yaml:'
stops 'a bound that is exceeded' 's/at_most: 1\.9e-10/at_most: 1.8e-10/' 1 \
    '(15) drops at most 1.8e-10 m/s^2: BROKEN: paper/derivations.yaml:' verify derivations separation_small
check 'its kind' says ': it is exceeded with'
check 'the same as JSON' ends 1 "$wrong" verify derivations separation_small --json
stops 'a bound that is too wide' 's/at_most: 1\.2e-9/at_most: 9.2e-9/' 1 ': not found to be half reached with' verify derivations torque_small
stops 'a bound on other states' 's/dL: \[-0\.2, 0\.2\]/dL: [-0.9, 0.9]/' 1 ': it is exceeded with' verify derivations length_error
stops 'an equation without a step' 's/to: \["38"\]/to: ["37"]/' 1 'NOT BOUND: paper/derivations.yaml:' verify derivations kepler
check 'a step that holds' ends 0 "$wrong" verify derivations attitude
check 'the same as JSON' ends 0 "$wrong" verify derivations attitude --json
check 'what holds' says '{"fine": true'
check 'what rests on it, as JSON' ends 1 "$wrong" verify derivations --json
check 'its number' says 'coulomb-tether: equation 2a is reached by no step, and is no definition'
stops 'an operation that ref/ does not have' 's/^  eq41roots:/  eq41roops:/' 1 "no 'eq41roops' in verify/evaluate/reference.c" verify errors --count 1
stops 'an error beyond all bounds' 's|      Omega: sqrt(GM/R_c^3)|      Omega: "0"|' 1 '"worst_E": "inf"' verify errors --count 10 --json
stops 'a row that rounds otherwise' 's/-1\.3306e-1/-1.3307e-1/' 1 ',no' table1 --csv
stops 'a mistake that makes no difference' 's/0\.0174532925199432957692369076848861271344/1.0000000000000000000000000000000000000001/g' 1 \
    'eq09: no golden vector kills the mistake: angles taken as degrees' conform --kills --only eq09
stops 'vectors without a purpose' '
    s/{outputs: {L: L^2}}/{outputs: {L: L*1}}/; s/{z1: "0", z2: "0"}/{z1: z1 , z2: z2 }/' 1 \
    ': kills no mistake and pins no edge' conform --kills --only eq12
stops 'a value that is not the one printed' 's/value: 150, meaning: mass of craft 1}/value: 151, meaning: mass of craft 1}/' 1 \
    'm1     150          1.5100000000000000e+02   kg         no' table1
# Decimals of which no ball has the product exactly.
stops 'a condition on its boundary' 's/domain: \[n > 0\]/domain: [n*n >= 1\/100]/' 0 'C1 = 1.000e-01 1/s^2' eval eq43 Omega=1 n=0.1 --exact --digits 4
stops 'a condition that nothing violates' 's/x1^2 + y1^2 + z1^2 > 0/x1^2 + y1^2 + z1^2 >-1/' 1 \
    'eq13: no edge found of x1^2 + y1^2 + z1^2 >-1' vectors eq13 --golden
check 'questions without one' ends 1 "$wrong" conform --questions --only eq13
stops 'a golden vector without end' 's/paper: {\(.*\)x1_0: [^,]*, y1_0: [^,]*, z1_0: [^,]*/paper: {C1: 0, C2: 0, \1x1_0: 0, y1_0: 0, z1_0: -1/' 1 'the craft come closer than L_ref/128' vectors flow_nonlinear --golden
stops 'a title with a quotation mark and a tab' 's/title: orbital rate/title: orb"tal	rate/' 0 'orb\"tal\u0009rate' equations --json

finish
