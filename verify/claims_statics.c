/*
 * Claims about the static pair and the frame that it rests in; and the list of all that belongs to it.
 *
 * Units, unless they are written out: time in 1/Omega, lengths in L_ref or, for craft 1 from the centre
 * of mass, in r_ref = L_ref m2/(m1 + m2). A force between the craft is P rho.
 */
#include "claims_statics.h"

#include <stdio.h>
#include <string.h>

#include "algebra.h"
#include "enclosure.h"
#include "exact.h"
#include "operation.h"
#include "symbolic.h"

/* ---- where two craft can rest ---- */

static const char *const axis_name[AXES] = {"radius", "velocity", "orbit normal"};

/* What (3) without charge makes of a place on each axis at rest: acceleration over displacement, Omega = 1. */
static bool tide(slong coefficient[AXES])
{
    bool diagonal = true;
    fmpq *a = _fmpq_vec_init(AXES);
    for (int i = 0; i < AXES; i++) {
        slong inputs[11] = {1, 1, 1, 2, 0}; /* Omega k_c m1 m2 Q, then the state */
        inputs[5 + i] = 1;
        diagonal = section_at("eq03", inputs, a) && diagonal;
        for (int j = 0; j < AXES; j++)
            diagonal = diagonal && (j == i ? fmpz_is_one(fmpq_denref(a + j)) != 0 : fmpq_is_zero(a + j) != 0);
        coefficient[i] = fmpz_get_si(fmpq_numref(a + i));
    }
    _fmpq_vec_clear(a, AXES);
    return diagonal;
}

/* At rest needs (tide + P) times each coordinate to vanish: P = -tide, one axis for each value of it. */
static void decide_static_places(struct evidence *e)
{
    slong t[AXES];
    char force[128], *share;
    fmpq_t third;
    fmpq_init(third);
    bool proved = tide(t) && t[0] != t[1] && t[1] != t[2] && t[2] != t[0] && t[0] == 3;
    evidence_add(e,
                 "at rest (3) asks (t + P) = 0 on every axis with a coordinate, t = %ld, %ld, %ld over Omega^2 "
                 "and P = k_c Q (m1 + m2)/(m1 m2 Omega^2 L^3); the t differ, so off the axes nothing rests, "
                 "and on each one product does:",
                 t[0], t[1], t[2]);
    for (int i = 0; i < AXES; i++) {
        snprintf(force, sizeof force,
                 "(%ld)*Omega^2*x + k_c/m1*((m1 + m2)/m2*x)/L^3*(%ld*Omega^2*L^3/k_c*(m1*m2/(m1 + m2)))", t[i],
                 -t[i]);
        proved = proved && identity("Omega k_c m1 m2 L x", force, "0");
        fmpq_set_si(third, t[i], 3); /* -t against the -3 of (7) */
        share = fmpq_get_str(NULL, 10, third);
        evidence_add(e, "%s %s Q/Q_ref(L) = %s", i > 0 ? "," : "", axis_name[i], share);
        flint_free(share);
    }
    fmpq_clear(third);
    proved = proved && section_identity("eq07", "Q_ref", "-3*Omega^2*L^3/k_c*(m1*m2/(m1 + m2))");
    evidence_add(e, ". Two craft of like charges on the orbit normal, and two without charge one behind the "
                    "other, rest as well; (5) is the only one that attraction holds, and either craft may be "
                    "above");
    e->why = "Two like charges on the orbit normal, and two craft without charge one behind the other, rest as well.";
    evidence_decide(e, REFUTED, EXACT, proved);
}

/* ---- their stability ---- */

/*
 * The matrix of (3) about a place on an axis, from the sheet by differentiation; m1 = 1, m2 = 2, Omega = k_c = 1,
 * L = 3, x1 = 2 and the charge product that rests there. Gains act along the line of the craft: by
 * (18) a length error adds -k1 of it to the acceleration, its rate -k2, k1 = C1 (L_ref/L)^2, k2 = C2 (L_ref/L)^2.
 */
static bool static_matrix(fmpq_mat_t A, int axis, slong t, slong k1, slong k2)
{
    const struct section *s = section_find(sheet(), "eq03");
    const struct program *p = &s->corrected.program;
    struct machine m, slope;
    fmpq_t q;
    bool rational = true;
    fmpq_init(q);
    machine_init(&m, p, &arithmetic_exact, 0);
    machine_init(&slope, p, &arithmetic_exact, 0);
    const slong inputs[5] = {1, 1, 1, 2, -18 * t}; /* -t L^3 m1 m2/(m1 + m2) */
    for (int i = 0; i < p->inputs; i++) {
        fmpq_set_si(q, i < 5 ? inputs[i] : 2 * (i - 5 == axis), 1);
        m.arithmetic->set_rational(machine_value(&m, i), q, 0);
    }
    machine_run(&m);
    fmpq_mat_zero(A);
    for (int i = 0; i < AXES; i++) {
        rational = rational && exact_is_zero(machine_value(&m, s->corrected.outputs[i]));
        machine_gradient(&m, s->corrected.outputs[i], &slope);
        fmpq_one(fmpq_mat_entry(A, i, AXES + i));
        for (int j = 0; j < STATE; j++)
            rational =
                exact_is_rational(fmpq_mat_entry(A, AXES + i, j), machine_value(&slope, 5 + j)) && rational;
    }
    fmpq_sub_si(fmpq_mat_entry(A, AXES + axis, axis), fmpq_mat_entry(A, AXES + axis, axis), k1);
    fmpq_sub_si(fmpq_mat_entry(A, AXES + axis, AXES + axis), fmpq_mat_entry(A, AXES + axis, AXES + axis), k2);
    machine_clear(&m);
    machine_clear(&slope);
    fmpq_clear(q);
    return rational;
}

bool static_polynomial(int axis, const char *factors)
{
    static const int gains[][2] = {{0, 0}, {1, 0}, {0, 1}}; /* in one row: the determinant is affine in them */
    char text[160];
    slong t[AXES];
    fmpq_mat_t A;
    bool same = tide(t);
    fmpq_mat_init(A, STATE, STATE);
    for (int i = 0; i < 3; i++) {
        snprintf(text, sizeof text, "%s", factors);
        for (char *k = text; (k = strchr(k, 'k')) != NULL; k++) {
            k[1] = (char)('0' + gains[i][k[1] - '1']);
            k[0] = ' ';
        }
        same = same && static_matrix(A, axis, t[axis], gains[i][0], gains[i][1]) && characteristic_is(A, text);
    }
    fmpq_mat_clear(A);
    return same;
}

/* How many different positive roots a polynomial in x has. */
slong positive_roots(const char *text)
{
    fmpq_poly_t f;
    fmpq_t zero;
    fmpq_init(zero);
    fmpq_poly_init(f);
    polynomial(f, text);
    slong count = fmpq_poly_is_zero(f) ? -1 : roots_beyond(f, zero);
    fmpq_poly_clear(f);
    fmpq_clear(zero);
    return count;
}

static void decide_static_unstable(struct evidence *e)
{
    struct numbers n = {.proved = true};
    slong t[AXES];
    fmpq_mat_t A;
    fmpq_mat_init(A, STATE, STATE);
    bool proved = static_polynomial(RADIUS, RADIAL) && static_polynomial(NORMAL, ACROSS) &&
                  static_polynomial(VELOCITY, ALONG);
    proved = proved && positive_roots("x^4 - 2*x^2 - 27") == 1 &&
             identity("x r", "(x^2 - r*x + 2)*(x^2 + r*x + 2)", "x^4 + (4 - r^2)*x^2 + 4");
    proved = proved && tide(t) && static_matrix(A, VELOCITY, t[VELOCITY], 0, 0) &&
             fmpq_mat_rref(A, A) == STATE - 1; /* the rank */
    evidence_add(e,
                 "characteristic polynomials in lambda/Omega, constant charge, any masses: radius (s^2 + "
                 "4)(s^4 - 2 s^2 - 27), a root s = sqrt(1 + 2 sqrt 7) = %s; orbit normal (s^4 - s^2 + 4)(s^2 + "
                 "3), the first the product of s^2 -+ sqrt(5) s + 2, growth sqrt(5)/2 = %s; velocity axis, no "
                 "charge, s^2 (s^2 + 1)^2 with a double root 0 of one eigenvector: growth linear in time",
                 number_of(&n, 6, "sqrt(1 + 2*sqrt(7))", NOTHING), number_of(&n, 6, "sqrt(5)/2", NOTHING));
    fmpq_mat_clear(A);
    evidence_decide(e, HOLDS, EXACT, proved && n.proved);
}

/* ---- where they are in the frame ---- */

static void decide_equal_distances(struct evidence *e)
{
    const slong inputs[3] = {1, 2, 3};
    fmpq *x = _fmpq_vec_init(2);
    bool proved = section_identity("eq05", "x1 + x2", "(m2 - m1)/(m1 + m2)*L") &&
                  section_at("eq05", inputs, x) && fmpq_cmp_si(x, 0) > 0;
    char *x1 = fmpq_get_str(NULL, 10, x), *x2 = fmpq_get_str(NULL, 10, x + 1);
    evidence_add(e,
                 "by (5) the distances from the chief differ by x1 + x2 = L (m2 - m1)/(m1 + m2): equal only "
                 "where m1 = m2. m2 = 2 m1, L = 3 m: x1 = %s m, x2 = %s m",
                 x1, x2);
    flint_free(x1);
    flint_free(x2);
    _fmpq_vec_clear(x, 2);
    e->why = "Only where the masses are equal.";
    evidence_decide(e, QUALIFIED, EXACT, proved);
}

/*
 * On a neighbouring circular orbit x1 stays and y1_dot = drift x1. Kepler's rate falls outwards as
 * R^(-3/2), so that a craft drifts by -3/2 Omega of its height: x1 is the height where the two agree.
 */
static void decide_nadir(struct evidence *e)
{
    const slong inputs[11] = {1, 1, 1, 2, 0, 2, 0, 0, 0, -3}; /* x1 = 2, y1_dot = -3 */
    fmpq *a = _fmpq_vec_init(3);
    fmpq_poly_t rate;
    fmpq_t kepler;
    fmpq_init(kepler);
    fmpq_poly_init(rate);
    polynomial(rate, "(1 + x)^3");
    fmpq_poly_invsqrt_series(rate, rate, 2);
    fmpq_poly_get_coeff_fmpq(kepler, rate, 1);
    bool steady = section_at("eq03", inputs, a);
    for (int i = 0; i < 3; i++)
        steady = steady && fmpq_is_zero(a + i);
    bool upward = fmpq_cmp_si(kepler, 0) < 0 && fmpz_equal_si(fmpq_numref(kepler), -3) &&
                  fmpz_equal_si(fmpq_denref(kepler), 2);
    evidence_add(e, "the signs of (2), with y along the velocity, let an uncharged craft keep its x with y_dot "
                    "= -(3/2) Omega x. Kepler's (1 + h/R)^(-3/2) makes a craft at height h drift by -(3/2) "
                    "Omega h, at depth h by +(3/2) Omega h: x is the height, the axis o_r points to the "
                    "zenith, as R_c = (R_c, 0, 0) in (35) says too. True of the line, not of the direction");
    fmpq_poly_clear(rate);
    fmpq_clear(kepler);
    _fmpq_vec_clear(a, 3);
    e->why = "The line is right, the direction is not: by the signs of (2) the axis points to the zenith.";
    evidence_decide(e, QUALIFIED, EXACT, steady && upward);
}

static void decide_opposite_signs(struct evidence *e)
{
    struct numbers n = {.proved = true};
    bool proved = section_identity("eq07", "Q_ref*k_c*(m1 + m2)/(3*Omega^2*L^3*m1*m2)", "-1");
    evidence_add(e,
                 "Q_ref is -3 times quantities that are positive: q1 q2 < 0 for all masses, lengths and "
                 "orbits; with Table 1 it is %s C^2",
                 number_of(&n, 10, "-3*Omega^2*L_ref^3/k_c*(m1*m2/(m1 + m2))", NOTHING));
    evidence_decide(e, HOLDS, EXACT, proved && n.proved);
}

/* Kepler's rate at the heights +-h, over that at R_c; GM of the Earth: IERS Conventions (2010), table 1.1, TCG */
static void decide_own_periods(struct evidence *e)
{
    struct numbers n = {.proved = true};
    arb_t R;
    arb_init(R);
    enclose(R, "3.986004418e14/Omega^2", NOTHING);
    arb_root_ui(R, R, 3, ENCLOSURE_BITS);
    const struct known *known = KNOWN({"R", R});
    bool proved = positive_at("1 - 1/sqrt((1 + L_ref/2/R)^3)", known) &&
                  positive_at("1/sqrt((1 - L_ref/2/R)^3) - 1", known);
    evidence_add(e,
                 "at rest both craft go round at Omega; alone, on circles through their places, a fraction %s "
                 "slower and %s faster (equal masses, L = 10 m, R_c = %s km by Kepler's law): -+(3/2) h/R_c to "
                 "first order, or %s m an orbit along the track. Circles they are, as rho is constant in a "
                 "frame that turns evenly",
                 number_of(&n, 5, "1 - 1/sqrt((1 + L_ref/2/R)^3)", known),
                 number_of(&n, 5, "1/sqrt((1 - L_ref/2/R)^3) - 1", known), number_of(&n, 7, "R/1000", known),
                 number_of(&n, 4, "3/2*2*pi*L_ref/2", known));
    arb_clear(R);
    evidence_decide(e, HOLDS, CERTIFIED, proved && n.proved);
}

/* ---- the equations that all this rests on ---- */

/* A section's outputs for blank-separated rationals, or inf; false where one has no rational value. */
static bool section_exact(const char *id, const char *values, fmpq *outputs)
{
    const struct section *s = section_find(sheet(), id);
    struct machine m;
    fmpq_t q;
    char word[32] = "";
    bool rational = true;
    fmpq_init(q);
    machine_init(&m, &s->corrected.program, &arithmetic_exact, 0);
    for (int i = 0; i < s->input_count; i++) {
        int length = 0;
        sscanf(values, "%31s%n", word, &length);
        values += length;
        if (fmpq_set_str(q, word, 10) == 0)
            m.arithmetic->set_rational(machine_value(&m, i), q, 0);
        else
            m.arithmetic->set_infinity(machine_value(&m, i));
    }
    machine_run(&m);
    for (int i = 0; i < s->output_count && rational; i++)
        rational = exact_is_rational(outputs + i, machine_value(&m, s->corrected.outputs[i]));
    machine_clear(&m);
    fmpq_clear(q);
    return rational;
}

/* Craft of 1 and 2 kg, 30 m apart, and a third place: far off without charge, or the chief's with one. */
static void decide_sum_bounds(struct evidence *e)
{
    static const char *const two = "1 7 inf  1 3 12 16 0 1 2 3  2 -5 -6 -8 0 -1/2 -1 -3/2";
    char values[160];
    fmpq *apart = _fmpq_vec_init(9), *chief = _fmpq_vec_init(9), *pair = _fmpq_vec_init(3);
    snprintf(values, sizeof values, "%s  1 0 80 60 0 0 0 0", two);
    bool proved = section_exact("eq02", values, apart);
    snprintf(values, sizeof values, "%s  1 9 0 0 0 0 0 0", two);
    proved = proved && section_exact("eq02", values, chief) &&
             section_exact("eq03", "1 7 1 2 -15 12 16 0 1 2 3", pair);
    for (int i = 0; i < 3; i++)
        proved = proved && fmpq_equal(apart + i, pair + i);
    bool differs = !fmpq_equal(chief, pair);
    evidence_add(e, "N craft are craft 1 ... N: summed over these, less i itself, (2) without shielding gives "
                    "(3) exactly. As printed, from 0, the sum counts a charge q0 that no craft has: at the "
                    "chief it would add k_c q1 q0/(m1 rho1^2) to craft 1; and its end n is elsewhere the gain "
                    "factor of (43)");
    _fmpq_vec_clear(apart, 9);
    _fmpq_vec_clear(chief, 9);
    _fmpq_vec_clear(pair, 3);
    e->why = "The craft are numbered from 1, and so is the sum.";
    evidence_decide(e, HOLDS_AS_CORRECTED, EXACT, proved && differs);
}

static void decide_cosines_reference(struct evidence *e)
{
    const struct section *matrix = section_find(sheet(), "eq09"), *rate = section_find(sheet(), "eq25");
    struct machine m, w;
    bool proved = true;
    symbolic_begin(3, 0, false);
    machine_init(&m, &matrix->corrected.program, &arithmetic_symbolic, 1);
    machine_init(&w, &rate->corrected.program, &arithmetic_symbolic, 1);
    symbolic_set_angle(machine_value(&m, 0), 0);
    symbolic_set_angle(machine_value(&m, 1), 1);
    symbolic_set_variable(machine_value(&w, 0), 2, 0);
    symbolic_set_angle(machine_value(&w, 1), 1);
    machine_run(&m);
    machine_run(&w);
    for (int i = 0; i < 3; i++) {
        struct symbolic *column = machine_value(&m, matrix->corrected.outputs[3 * i + 2]);
        const struct symbolic *left = machine_value(&w, rate->corrected.outputs[i]);
        arithmetic_symbolic.apply(OPERATOR_MULTIPLY, column, column, machine_value(&w, 0), 0, 1);
        proved = proved && left->fault == SYMBOLIC_FINE && column->fault == SYMBOLIC_FINE &&
                 fmpz_mpoly_q_equal(left->a, column->a, symbolic_context());
    }
    const struct section *cited = section_find(sheet(), "eq10");
    bool no_matrix = cited->output_count == 3 && matrix->output_count == 9;
    machine_clear(&m);
    machine_clear(&w);
    symbolic_end();
    evidence_add(e, "before (25) the text calls (10) the definition of [BO]; the nine cosines are defined in "
                    "(9), (10) uses them: Omega times the third column of (9) is (25)");
    e->why = "(9) defines it, (10) uses it.";
    evidence_decide(e, HOLDS_AS_CORRECTED, EXACT, proved && no_matrix);
}

static void decide_masses_cancel(struct evidence *e)
{
    bool proved = section_identity("eq04", "(x1 - x2)/m1", "(m1 + m2)/(m1*m2)*x1") &&
                  section_identity("eq07", "k_c*(m1 + m2)/(m1*m2)*Q_ref", "-3*Omega^2*L^3") &&
                  section_identity("eq18", "k_c*(m1 + m2)/(m1*m2)*dQ", "-L_ref^2*(C1*dL + C2*dL_dot)");
    evidence_add(e, "in (3) closed by (7) and (18) the charge accelerates craft 1 by P rho1, P = -(3 Omega^2 "
                    "L_ref^3 + L_ref^2 (C1 dL + C2 dL_dot))/L^3: neither masses nor k_c are left. In units of "
                    "Omega and of r_ref = L_ref m2/(m1 + m2) all pairs move alike; the masses only say where "
                    "between the craft the origin lies");
    evidence_decide(e, HOLDS, EXACT, proved);
}

/* ---- no charge at all ---- */

/* Hill's solution from rest at L0 on the radius: x = 4 - 3 c, y = 6 (s - t), c and s the cosine and sine of t. */
static void decide_zero_charge_orbit(struct evidence *e)
{
    static const char *const when[] = {"a tenth of an orbit", "a quarter", "an orbit"};
    static const int share[] = {10, 4, 1};
    struct numbers n = {.proved = true};
    arb_t t, hill, printed;
    arb_init(t);
    arb_init(hill);
    arb_init(printed);
    /* x'' = 3 c, x' = 3 s, y' = 6 (c - 1), y'' = -6 s */
    bool proved =
        identity("c s t", "3*c - 2*6*(c - 1) - 3*(4 - 3*c)", "0") && identity("c s t", "-6*s + 2*3*s", "0");
    evidence_add(e, "L_ddot = 3 Omega^2 L has cosh(sqrt(3) Omega t) from rest. Free craft at rest on the "
                    "radius follow Hill's x = 4 - 3 cos, y = 6 (sin - Omega t), in which the yaw rate does not "
                    "stay 0; L/L(0) of the two:");
    for (int i = 0; i < 3; i++) {
        arb_const_pi(t, ENCLOSURE_BITS);
        arb_mul_si(t, t, 2, ENCLOSURE_BITS);
        arb_div_si(t, t, share[i], ENCLOSURE_BITS);
        enclose(hill, "sqrt((4 - 3*cos(t))^2 + 36*(sin(t) - t)^2)", KNOWN({"t", t}));
        enclose(printed, "(exp(sqrt(3)*t) + exp(-sqrt(3)*t))/2", KNOWN({"t", t}));
        proved = proved && arb_gt(printed, hill);
        evidence_add(e, "%s %s and %s after %s", i > 0 ? "," : "", number(&n, printed, 5), number(&n, hill, 5),
                     when[i]);
    }
    evidence_add(e,
                 ". The equation is exact at the start alone; that the craft leave their places stands: they "
                 "part by 12 pi L(0) = %s L(0) an orbit, not exponentially",
                 number_of(&n, 4, "12*pi", NOTHING));
    arb_clear(t);
    arb_clear(hill);
    arb_clear(printed);
    e->why = "At the start alone: free craft turn, and part linearly in time, not exponentially.";
    evidence_decide(e, QUALIFIED, CERTIFIED, proved && n.proved);
}

/* ---- the list ---- */

const struct claim claims_statics[] = {
    {"static-only-place", "Eq. (5)",
     "the places of (5) are the only ones where two charged craft can rest in the orbit frame",
     decide_static_places},
    {"static-unstable", "Introduction", "static formations of constant charge are all unstable",
     decide_static_unstable},
    {"equal-distances", "Section Static formation", "at rest the two craft are equally far from the chief",
     decide_equal_distances},
    {"nadir-axis", "Eq. (1), Fig. 2", "the first axis of the orbit frame points along the nadir direction",
     decide_nadir},
    {"opposite-charges", "Eq. (7)",
     "the reference charge product is negative, the charges are of opposite sign", decide_opposite_signs},
    {"non-keplerian-periods", "Section Static formation",
     "the two craft describe circles in a time that is not Kepler's for their altitudes", decide_own_periods},
    {"sum-bounds", "Eq. (2)", "the charges act on craft i as a sum over j from 0 to n without i",
     decide_sum_bounds},
    {"cosines-cited", "Eq. (25)", "the matrix of direction cosines is the one defined in (10)",
     decide_cosines_reference},
    {"masses-cancel", "Eqs. (3), (7), (18)",
     "the closed loop depends on the masses through the place of the origin alone", decide_masses_cancel},
    {"zero-charge-orbit", "After Eq. (15)",
     "without charge a pair at rest on the radius parts as L_ddot = 3 Omega^2 L says",
     decide_zero_charge_orbit},
    {"constant-charge-separates", "Section Linearized perturbation",
     "with constant charge a disturbed pair separates", decide_separation},
    {"tension-compression", "Abstract, Eqs. (21), (22)", "the Coulomb tether carries tension and compression",
     decide_tension},
    {"other-rests", "Conclusion", "the law (18) is adequate: under it the pair rests at L_ref and nowhere else",
     decide_other_rests},
    {"basin-at-rest", "Conclusion", "the law (18) is adequate: it brings the pair back from any length error",
     decide_basin},
    {"printed-charges", "Eqs. (20)-(22)", "the charges (21), (22) carry out what (18) commands",
     decide_printed_charges},
    {"product-negative", "After Eq. (22)", "Q_ref + dQ stays negative", decide_negative_product},
    {"variation-small", "After Eq. (22)", "dQ << Q_ref", decide_small_variation},
    {"charge-error", "Eqs. (7), (18)", "the law holds the length L_ref", decide_charge_error},
    {"screened-force", "Eq. (2)", "in a plasma the force falls off as e^(-r/lambda_d)/r^2", decide_shielding},
    {"debye-order", "After Eq. (2)", "the Debye length enters as a term of higher order",
     decide_shielding_order},
    {"debye-neglect", "After Eq. (2)", "at Debye lengths of 100 to 1400 m the shielding may be left out",
     decide_debye_neglect},
    {"debye-escape", "Introduction", "Coulomb formations work comfortably at Debye lengths of 100 to 1400 m",
     decide_debye_escape},
    {"low-orbit", "Introduction", "Debye lengths of centimetres make Coulomb formations impractical",
     decide_low_orbit},
    {"debye-lengths", "Introduction", "the Debye length is centimetres in low orbits and 100 to 1400 m at GEO",
     decide_debye_lengths},
    {"coulomb-constant", "After Eq. (2), Table 1", "k_c = 8.99e9 N m^2/C^2", decide_coulomb_constant},
    {"orbit-rate", "Table 1", "Omega = 7.2915e-5 rad/s is the rate of a geostationary orbit",
     decide_orbit_rate},
    {"microcoulomb", "Section Numerical simulation", "the charges are of the order of a microcoulomb",
     decide_microcoulomb},
    {"reach", "Introduction", "the Coulomb force serves formations of 10 to 100 m", decide_reach},
    {"own-gravity", "Eq. (2)", "beside the tide and the charges no force between the craft counts",
     decide_own_gravity},
    {NULL, NULL, NULL, NULL},
};
