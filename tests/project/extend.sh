#!/bin/sh
# One equation more, as README tells it: in a copy of the project the potential energy of the pair becomes Eq. (45), by
# pieces in the files that README names and in no other. With all of them and `make data` everything that `make check`
# checks passes, and the gate counts one equation more; without any one of them what is printed names it. For make extend.
. tests/harness.sh
unset DATA ONLY CK_RUN_CASE
project=$(pwd)

# FILE LINE: what is on standard input goes into FILE before the first line that begins with LINE.
before() {
    cat >"$work/piece"
    awk -v mark="$2" -v piece="$work/piece" 'index($0, mark) == 1 && !done { while ((getline line < piece) > 0) print line; done = 1 }
        { print } END { exit !done }' "$1" >"$work/edited" && cat "$work/edited" >"$1"
}

# ---- the pieces ----

put_quantity() { before paper/equations.yaml '  C1:' <<'END'
  U: {unit: J, domain: finite, meaning: potential energy of the pair}
END
}
put_formula() { before paper/equations.yaml '# ---- motions ----' <<'END'
  eq45:
    title: potential energy of the pair in the tide and by its charges
    kind: beyond
    equations: ["45"]
    inputs: [Omega, k_c, m1, m2, Q, L, psi, theta]
    outputs:
      U: m1*m2/(m1 + m2)*Omega^2*L^2/2*(sin(theta)^2 - 3*(cos(psi)*cos(theta))^2) + k_c*Q/L

END
}
put_step() { cat >>paper/derivations.yaml <<'END'
  potential_energy:
    title: what the motion takes from the potential energy of the pair the craft have as kinetic energy
    from: ["3", "10", "11"]
    to: ["45"]
    angles: [psi, theta]
    square roots: [L]
    rates: {L: L_dot, psi: psi_dot, theta: theta_dot}
    let:
      x1: eq10.x1
      y1: eq10.y1
      z1: eq10.z1
      x1_dot: eq11exact.x1_dot
      y1_dot: eq11exact.y1_dot
      z1_dot: eq11exact.z1_dot
      work: x1_dot*eq03.x1_ddot + y1_dot*eq03.y1_ddot + z1_dot*eq03.z1_ddot
    lines:
      the tide by the place: eq45.U(Q = 0) = m1*(m1 + m2)/m2*Omega^2*(z1^2 - 3*x1^2)/2
      its rate: rate(eq45.U(Q = 0)) = m1*(m1 + m2)/m2*Omega^2*(z1*z1_dot - 3*x1*x1_dot)
    show:
      - m1*(m1 + m2)/m2*work = -rate(eq45.U)
END
}
put_function() { cat >>ref/hill.c <<'END'

/*
 * Eq. (45)   potential energy of the pair in the tide and by its charges
 *
 *     U = m1 m2/(m1 + m2) Omega^2 L^2/2 (sin^2 theta - 3 cos^2 psi cos^2 theta) + k_c Q/L
 *
 * Given     p        orbit rate [rad/s], Coulomb constant [N m^2/C^2], masses [kg]
 *           Q        charge product [C^2]
 *           c        L [m]   > 0, psi, theta [rad]
 * Returns   U        [J]
 */
double ct_potential_energy(struct ct_params p, double Q, struct ct_spherical c)
{
    if (!POSITIVE(p.Omega, p.k_c, p.m1, p.m2, c.L) || !FINITE(Q, c.psi, c.theta))
        return NAN;
    const double along = cos(c.psi) * cos(c.theta), across = sin(c.theta);
    return reduced_mass(p) * (p.Omega * p.Omega) * (c.L * c.L) / 2 * (across * across - 3 * (along * along)) + p.k_c * Q / c.L;
}
END
    before ref/coulombtether.h '/* Attitude angles' <<'END'
/* (45) */ double ct_potential_energy(struct ct_params p, double Q, struct ct_spherical c);
END
}
put_operation() {
    before verify/evaluate/reference.c 'FILLS(flow_linear' <<'END'
RETURNS(eq45, double, ct_potential_energy(FORMATION, in[4], AT(ct_spherical, 5)))
END
    before verify/evaluate/reference.c '    REFERENCE(eq44)' <<'END'
    REFERENCE(eq45),
END
}
put_test() {
    cat >>tests/ref/test_ref_hill.c <<'END'

TEST(eq45_whole_numbers)
{
    ck_assert_double_eq(ct_potential_energy((struct ct_params){1, 1, 2, 2, NAN}, 8, (struct ct_spherical){2, 0, 0}), -2);
}
END
}
put_place() { before paper/12-beyond.md '## Hill' <<'END'
<<equation eq45>>
<<function eq45>>
<<step potential_energy>>

END
}

# ---- the copy, and what is made in it ----

pieces='quantity formula step function operation test place'
files='paper/equations.yaml paper/derivations.yaml ref/hill.c ref/coulombtether.h verify/evaluate/reference.c
    tests/ref/test_ref_hill.c paper/12-beyond.md'

# PIECE: the copy has all pieces but that one. A file that stays the same keeps its time, and is not compiled again.
put_all_but() {
    for file in $files; do cp "$project/$file" "$work/put/$file" || return; done
    for piece in $pieces; do
        [ "$piece" = "$1" ] || (cd "$work/put" && "put_$piece") || { echo "no place for the $piece"; return 1; }
    done
    for file in $files; do
        cmp -s "$work/put/$file" "$work/copy/$file" || cp "$work/put/$file" "$work/copy/$file" || return
    done
}
made() { (cd "$work/copy" && "${MAKE:-make}" --silent BUILD="$BUILD" "$@"); }
counted() { made gate | grep -qx "gate: $1 of $1 equations have every link"; }

for file in $files; do mkdir -p "$work/put/${file%/*}" || exit 1; done
mkdir -p "$work/copy/$BUILD" && cp -pR .ci Makefile README.md coverage data paper ref tests verify "$work/copy" || exit 1
(cd "$BUILD" && cp -pR ref verify tests ./*.* coulomb-tether sheet-check "$work/copy/$BUILD") || exit 1
sections=$(awk '/^equations:/ { on = 1 } on && /^  [a-z0-9_]+:$/ { n++ } END { print n }' paper/equations.yaml)

check 'all pieces' put_all_but ''
check 'make data' made data
check 'make check' made check
check 'the gate' counted $((sections + 1))
check 'its kind' grep -q '^equation-45,.*,beyond,' "$work/copy/data/verdicts.csv"

# MESSAGE: the copy does not pass, and says so.
stops_with() {
    { made check ONLY='test_ref_hill test_rooms' && made gate; } >"$work/said" 2>&1 && { echo passed; return 1; }
    grep -F -- "$1" "$work/said" || { cat "$work/said"; return 1; }
}
left_out() { check "no $1: put" put_all_but "$1"; check "no $1" stops_with "$2"; }

left_out quantity "unknown symbol 'U', expected a quantity of the sheet"
left_out formula "unknown '45', expected an equation that has a formula"
left_out step 'equation 45 is reached by no step, and is no definition'
left_out function 'ct_potential_energy'
left_out operation "no 'eq45' in verify/evaluate/reference.c"
left_out test 'eq45: no passing test, expected one named eq45_'
left_out place 'eq45: no place in the edition, expected <<equation eq45>> in paper/*.md'
rm "$work/copy/data/golden/eq45.csv"
left_out data 'eq45: no golden vectors in data/golden/eq45.csv'
finish
