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
#include "series.h"

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
    machine_init(&m, p, &arithmetic_sums, 0);
    machine_init(&slope, p, &arithmetic_sums, 0);
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

/*
 * On a neighbouring circular orbit x1 stays and y1_dot = drift x1. Kepler's rate falls outwards as
 * R^(-3/2), so that a craft drifts by -3/2 Omega of its height: x1 is the height where the two agree.
 */
/* Kepler's rate at the heights +-h, over that at R_c; GM of the Earth: IERS Conventions (2010), table 1.1, TCG */
/* ---- the equations that all this rests on ---- */

/* A section's outputs for blank-separated rationals, or inf; false where one has no rational value. */
/* Craft of 1 and 2 kg, 30 m apart, and a third place: far off without charge, or the chief's with one. */
/* Trigonometric polynomials of first degree, linear in Omega: equal everywhere where they are at three angles. */
/* ---- no charge at all ---- */

/* Hill's solution from rest at L0 on the radius: x = 4 - 3 c, y = 6 (s - t), c and s the cosine and sine of t. */
/* ---- the list ---- */

const struct claim claims_statics[] = {
    {"static-only-place", "Eq. (5)",
     "the places of (5) are the only ones where two charged craft can rest in the orbit frame",
     decide_static_places},
    {"static-unstable", "Introduction", "static formations of constant charge are all unstable",
     decide_static_unstable},
    {NULL, NULL, NULL, NULL},
};
