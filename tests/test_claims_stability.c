/*
 * The claims about the linear model. Digits come from mpmath 1.2.1, with
 *
 *     mp.dps = 90
 *     roots = lambda n: polyroots([1, 2*sqrt(n-9), n-2, 6*sqrt(n-9), 3*(n-9)], maxsteps=500, extraprec=500)
 *     rate = lambda n: min(-re(r) for r in roots(n))
 *     n = findroot(lambda n: diff(rate, n, h=mpf(10)**-25), (mpf('11.8'), mpf('11.82')), tol=1e-50)
 *
 * and the expressions that stand beside them.
 */
#include <stdlib.h>
#include <string.h>

#include "claims.h"
#include "verify/algebra.h"
#include "verify/claims_stability.h"
#include "verify/optimum.h"
#include "verify/roots.h"

enum { BITS = 256, DEGREE = 4 };

/* ---- the verdicts ---- */

const struct claim *const lists[] = {claims_stability, NULL};

const struct expected_claim expected[] = {
    {"routh", HOLDS, EXACT, "12 Omega^4 C2^2"},
    {"length-alone", HOLDS, EXACT, "C1 - 9 Omega^2"},
    {"derivative-feedback", HOLDS, EXACT, "(c1 - 8)^2 + 48"},
    {"no-damping-term", HOLDS, EXACT, "without dL_dot"},
    {"constant-charge-linear", HOLDS, CERTIFIED, "2.5082867902473156351"}, /* sqrt(1 + 2*sqrt(7)) */
    {"constant-charge-linear", HOLDS, CERTIFIED, "5467.72 s"}, /* 1/(7.2915e-5*sqrt(1 + 2*sqrt(7))) = 5467.7157... */
    {"zero-charge-linear", QUALIFIED, EXACT, "sqrt(3) Omega"},
    {"coupling-damps", QUALIFIED, EXACT, "-C2 dL_dot^2"},
    {"phase-damps", HOLDS, CERTIFIED, "171.2852"}, /* arg(-(r**2 + 3))*180/pi, r in roots(10) */
    {"phase-damps", HOLDS, CERTIFIED, "45.26008"},
    {"characteristic-parameters", HOLDS, EXACT, "L_ref cancels"},
    {"roots-scale", HOLDS, EXACT, "proportional to Omega"},
    {"complex-pairs", HOLDS, EXACT, "192*w^4+4032*w^3-33984*w^2+65856*w"},
    {"complex-pairs-any-gains", QUALIFIED, EXACT, "with 2 real roots"},
    {"real-parts-vanish", QUALIFIED, CERTIFIED, "-0.1069846374 and -0.1430153626"}, /* roots(9.0625) */
    {"real-parts-vanish", QUALIFIED, CERTIFIED, "-0.04948884256 and -5.518275520"}, /* roots(40) */
    {"slow-at-the-ends", HOLDS, CERTIFIED, "11.81160194899945"},
    {"n12-optimal", REFUTED, CERTIFIED, "11.8116019489994475627782,"},
    {"n12-optimal", REFUTED, CERTIFIED, "0.598916907216339712577893 "},
    {"n12-optimal", REFUTED, CERTIFIED, "0.995247391941 "}, /* rate(12)/rate(n) */
    {"n12-optimal", REFUTED, CERTIFIED, "0.694463344207 "}, /* rate(10)/rate(n) */
    {"matching-optimal", QUALIFIED, CERTIFIED, "1.669680699 "}, /* 1/rate(n), 1/rate(12), 1/rate(10) */
    {"matching-optimal", QUALIFIED, CERTIFIED, "1.677653930 "},
    {"matching-optimal", QUALIFIED, CERTIFIED, "2.404274772 "},
    {"frequencies", HOLDS, CERTIFIED, "1.10401859576 and 2.10401859576"}, /* im(roots(12)) */
    {"critical-damping", HOLDS, EXACT, "double real root"},
    {"wiggle", HOLDS, CERTIFIED, "-0.415925838288 +- 0.532450262801 i"}, /* roots(10) */
    {"wiggle", HOLDS, CERTIFIED, "-0.584074161712 +- 2.49612372429 i"},
    {"simulation-gains", HOLDS, EXACT, "exactly"},
    {"gains-reference", HOLDS_AS_CORRECTED, EXACT, "(19)"},
    {"pitch-decoupled", HOLDS, EXACT, "43085.6840649 s"}, /* pi/7.2915e-5 */
    {"pitch-uncontrollable", HOLDS, EXACT, "rank 4 of 6"},
    {"yaw-controllable", HOLDS, EXACT, "rank 4 of 4"},
    {"attitude", QUALIFIED, EXACT, "3 of 4"},
    {"no-moment", HOLDS, EXACT, "no moment"},
    {"names-yaw-pitch", DEFINITION, EXACT, "about the orbit normal"},
    {"step-below-period", HOLDS, CERTIFIED, "34522.0740827 s"}, /* 2*pi/(7.2915e-5*2.496123724292996301548900) */
    {NULL, VERDICT_NONE, EXACT, NULL},
};

enum { EXPECTED = sizeof expected / sizeof expected[0] - 1 };

START_TEST(numbers_are_written_positionally)
{
    static const struct {
        slong over;
        ulong under;
        slong digits;
        const char *text;
    } written[] = {{1, 800, 3, "x 0.00125"},  {1, 8, 3, "x 0.125"},        {-5, 4, 3, "x -1.25"},
                   {2469, 20, 5, "x 123.45"}, {-2469, 2, 5, "x -1234.5"},  {12345, 1, 5, "x 1.2345e+04"},
                   {1, 8000, 3, "x 1.25e-04"}, {0, 1, 3, "x 0"}};
    for (size_t i = 0; i < sizeof written / sizeof written[0]; i++) {
        struct evidence e = {0};
        arb_t x;
        arb_init(x);
        arb_set_si(x, written[i].over);
        arb_div_ui(x, x, written[i].under, BITS);
        say(&e, "x ", x, written[i].digits);
        arb_clear(x);
        ck_assert_str_eq(e.text, written[i].text);
    }
}
END_TEST

START_TEST(numbers_without_proof_are_not_written)
{
    struct evidence e = {0};
    arb_t x;
    arb_init(x);
    arb_zero_pm_one(x);
    ck_assert(!say(&e, "x ", x, 3));
    ck_assert_str_eq(e.text, "x undecided");
    arb_clear(x);
}
END_TEST

/* ---- the algebra ---- */

START_TEST(identities_hold_or_not)
{
    ck_assert(identity("a b", "(a + b)^2", "a^2 + 2*a*b + b^2"));
    ck_assert(!identity("a b", "(a + b)^2", "a^2 + b^2"));
    ck_assert(identity("a b", "1/a - 1/b", "(b - a)/(a*b)"));
    ck_assert(identity("a b", "a^-2*(a + b)^3", "a + 3*b + 3*b^2/a + b^3*a^-2"));
    ck_assert(identity("a", "1/(a - 2)", "1/(a - 2)"));  /* wherever there is a value */
    ck_assert(!identity("a", "1/(a - a)", "1/(a - a)")); /* nowhere */
    ck_assert(!identity("a", "sqrt(a^2)", "a"));         /* no rational function */
    ck_assert(!identity("a", "b", "b"));                 /* an unknown name */
}
END_TEST

/* A polynomial of degree d that is zero at 1 ... d, but not everywhere. */
START_TEST(identities_look_at_enough_points)
{
    ck_assert(!identity("a", "(a - 1)*(a - 2)*(a - 3)*(a - 4)", "0"));
    ck_assert(!identity("a b", "(a - 1)*(b - 1)*(b - 2)", "0"));
    ck_assert(!identity("a", "(a - 1)^1/a^3", "0"));
    ck_assert(!identity("a", "(a - 1)*(a - 2)/a - (a - 1)*(a - 2)/(a + 1)", "0"));
}
END_TEST

START_TEST(identities_know_the_sheet)
{
    ck_assert(section_identity("eq43", "C1", "n*Omega^2"));
    ck_assert(!section_identity("eq43", "C1", "(n + 1)*Omega^2"));
    ck_assert(!section_identity("eq99", "0", "0"));
}
END_TEST

static slong beyond(const char *text, slong point)
{
    fmpq_poly_t f;
    fmpq_t x;
    fmpq_poly_init(f);
    fmpq_init(x);
    fmpq_set_si(x, point, 1);
    polynomial(f, text);
    slong count = roots_beyond(f, x);
    fmpq_poly_clear(f);
    fmpq_clear(x);
    return count;
}

START_TEST(roots_are_counted_once_and_strictly_beyond)
{
    ck_assert_int_eq(beyond("(x - 1)^2*(x - 2)*(x + 3)*(x^2 + 1)", -4), 3);
    ck_assert_int_eq(beyond("(x - 1)^2*(x - 2)*(x + 3)*(x^2 + 1)", 0), 2);
    ck_assert_int_eq(beyond("(x - 1)^2*(x - 2)*(x + 3)*(x^2 + 1)", 1), 1);
    ck_assert_int_eq(beyond("(x - 1)^2*(x - 2)*(x + 3)*(x^2 + 1)", 2), 0);
    ck_assert_int_eq(beyond("x^3", 0), 0);
    ck_assert_int_eq(beyond("x^3", -1), 1);
    ck_assert_int_eq(beyond("7", 0), 0);
}
END_TEST

static bool signed_beyond(const char *text, slong point, int sign)
{
    fmpq_poly_t f;
    fmpq_t x;
    fmpq_poly_init(f);
    fmpq_init(x);
    fmpq_set_si(x, point, 1);
    polynomial(f, text);
    bool has = has_sign_beyond(f, x, sign);
    fmpq_poly_clear(f);
    fmpq_clear(x);
    return has;
}

START_TEST(a_sign_beyond_a_point_is_strict)
{
    ck_assert(signed_beyond("x^2 - 1", 1, 1)); /* the root itself is not beyond */
    ck_assert(!signed_beyond("x^2 - 1", 0, 1));
    ck_assert(!signed_beyond("x^2 - 1", 1, -1));
    ck_assert(signed_beyond("1 - x^2", 1, -1));
    ck_assert(!signed_beyond("0", 1, 1));
    ck_assert(!signed_beyond("0", 1, -1));
}
END_TEST

/* ---- the linear model ---- */

/* A^T P + P A = -2 C2 e e^T, e the unit vector of dL_dot: the energy of coupling-damps as a matrix equation. */
START_TEST(eq40_energy_is_lost_through_the_length_rate)
{
    const slong Omega = 2, L_ref = 5, C1 = 41, C2 = 7;
    const slong parameters[4] = {Omega, L_ref, C1, C2};
    const slong diagonal[PLANE] = {3 * Omega * Omega * L_ref * L_ref, C1 - 9 * Omega * Omega, L_ref * L_ref, 1};
    fmpq_mat_t A, P, loss;
    fmpq_mat_init(A, PLANE, PLANE);
    fmpq_mat_init(P, PLANE, PLANE);
    fmpq_mat_init(loss, PLANE, PLANE);
    ck_assert(plane_model(A, parameters));
    for (int i = 0; i < PLANE; i++)
        fmpq_set_si(fmpq_mat_entry(P, i, i), diagonal[i], 1);
    fmpq_mat_mul(loss, P, A);
    fmpq_mat_transpose(P, loss);
    fmpq_mat_add(loss, loss, P);
    for (int i = 0; i < PLANE; i++)
        for (int j = 0; j < PLANE; j++)
            ck_assert_int_eq(fmpq_cmp_si(fmpq_mat_entry(loss, i, j), i == 3 && j == 3 ? -2 * C2 : 0), 0);
    fmpq_mat_clear(A);
    fmpq_mat_clear(P);
    fmpq_mat_clear(loss);
}
END_TEST

/* By hand, Omega = L_ref = b = 1: b, A b, A^2 b, A^3 b have the determinant (0*5 + 2*1)(1*(-4) + 2*5) = 12 in size. */
START_TEST(eq40_charge_controls_the_plane)
{
    const slong constant_charge[4] = {1, 1, 0, 0};
    fmpq_mat_t A, K;
    fmpq_t det;
    fmpq_init(det);
    fmpq_mat_init(A, PLANE, PLANE);
    fmpq_mat_init(K, PLANE, PLANE);
    ck_assert(plane_model(A, constant_charge));
    krylov(K, A);
    fmpq_mat_det(det, K);
    fmpq_abs(det, det);
    ck_assert_int_eq(fmpq_cmp_si(det, 12), 0);
    ck_assert_int_eq(rank_of(K), 4);
    fmpq_mat_clear(A);
    fmpq_mat_clear(K);
    fmpq_clear(det);
}
END_TEST

/* Gains in quarters, Omega = 1: (42) agrees with the signs of the certified roots, on the boundary too. */
START_TEST(eq42_agrees_with_the_roots)
{
    acb_ptr roots = _acb_vec_init(DEGREE);
    fmpq_t Omega, C1, C2;
    fmpq_init(Omega);
    fmpq_init(C1);
    fmpq_init(C2);
    fmpq_one(Omega);
    for (slong k = -4; k <= 60; k += 4) {
        for (slong j = -6; j <= 18; j += 3) {
            fmpq_set_si(C1, k, 4);
            fmpq_set_si(C2, j, 4);
            ck_assert(roots41(roots, Omega, C1, C2, 64));
            bool left = true;
            for (int i = 0; i < DEGREE; i++)
                left = left && arb_is_negative(acb_realref(roots + i));
            ck_assert_msg(left == (k > 36 && j > 0), "C1 = %ld/4, C2 = %ld/4", (long)k, (long)j);
        }
    }
    fmpq_clear(Omega);
    fmpq_clear(C1);
    fmpq_clear(C2);
    _acb_vec_clear(roots, DEGREE);
}
END_TEST

/* ---- rates ---- */

/* The rate of the slowest root at c1, c2 (over Omega, Omega^2). */
static void slowest(arb_t rate, const arb_t c1, const arb_t c2)
{
    acb_ptr roots = _acb_vec_init(DEGREE);
    ck_assert(roots41_gains(roots, c1, c2, BITS));
    arb_neg(rate, acb_realref(roots + DEGREE - 1));
    _acb_vec_clear(roots, DEGREE);
}

/* On (44). */
static void rate_at(arb_t rate, const arb_t n)
{
    arb_t c2;
    arb_init(c2);
    arb_sub_si(c2, n, 9, BITS);
    arb_sqrt(c2, c2, BITS);
    arb_mul_2exp_si(c2, c2, 1);
    slowest(rate, n, c2);
    arb_clear(c2);
}

START_TEST(eq44_optimum_beats_its_neighbours)
{
    struct optimum o;
    arb_t n, rate;
    arb_init(n);
    arb_init(rate);
    optimum_init(&o);
    ck_assert(optimum_find(&o, BITS));
    rate_at(rate, o.n);
    ck_assert(arb_overlaps(rate, o.rate)); /* the rate of the parametrised curve, by the roots */
    for (int k = 0; k < 2; k++) {
        arb_set_d(n, k == 0 ? 1e-6 : -1e-6);
        arb_add(n, n, o.n, BITS);
        rate_at(rate, n);
        ck_assert(arb_lt(rate, o.rate));
    }
    arb_fmpz_poly_evaluate_arb(n, o.n_solves, o.n, BITS);
    ck_assert(arb_contains_zero(n));
    arb_mul(rate, o.rate, o.rate, BITS);
    arb_fmpz_poly_evaluate_arb(n, o.square_solves, rate, BITS);
    ck_assert(arb_contains_zero(n));
    optimum_clear(&o);
    arb_clear(n);
    arb_clear(rate);
}
END_TEST

/* u = sqrt(n - 9) from 1/16 to 16: the bounds of real-parts-vanish against the roots themselves. */
START_TEST(eq44_rates_keep_their_bounds)
{
    arb_t n, rate, u, bound;
    arb_init(n);
    arb_init(rate);
    arb_init(u);
    arb_init(bound);
    for (int k = -16; k <= 16; k++) {
        arb_set_d(u, exp2(k / 4.0)); /* some exact number */
        arb_mul(n, u, u, BITS);
        arb_add_si(n, n, 9, BITS);
        rate_at(rate, n);
        arb_mul_si(bound, u, 3, BITS);
        arb_div_si(bound, bound, 7, BITS);
        ck_assert(arb_lt(rate, bound)); /* 3u/7 */
        arb_sub_si(n, n, 17, BITS);
        arb_neg(n, n);
        arb_mul(bound, bound, n, BITS);
        arb_div_si(bound, bound, 8, BITS);
        ck_assert(arb_gt(rate, bound)); /* 3u/7 (1 - u^2/8) */
        arb_pow_ui(bound, u, 3, BITS);
        arb_ui_div(bound, 12, bound, BITS);
        ck_assert(arb_lt(rate, bound)); /* 12/u^3 */
        arb_inv(n, u, BITS);
        arb_mul(n, n, n, BITS);
        arb_mul_si(n, n, -14, BITS);
        arb_add_si(n, n, 1, BITS);
        arb_mul(bound, bound, n, BITS);
        ck_assert(arb_gt(rate, bound)); /* 12/u^3 (1 - 14/u^2) */
    }
    arb_clear(n);
    arb_clear(rate);
    arb_clear(u);
    arb_clear(bound);
}
END_TEST

START_TEST(eq44_bounds_that_do_not_hold_are_refused)
{
    ck_assert(!slow_rate_compares("x", "49", 0, 1, 1));                            /* 3u/7 from below           */
    ck_assert(!slow_rate_compares("x", "48", 0, 1, -1));                           /* less than 3u/7            */
    ck_assert(!slow_rate_compares("x*(5 + 3*x)^2", "784", 0, 1, -1));              /* crosses the rate          */
    ck_assert(!slow_rate_compares("(x^2 - 22)^2", "x^3", 24, 5, -1));              /* 11/u^3                    */
    ck_assert(!slow_rate_compares("(x^3 - 24*(x - 13))^2", "x^5", 13, 1, 1));      /* 12/u^3 (1 - 13/u^2)       */
}
END_TEST

/* The discriminant of complex-pairs, as the product of the squared differences of the roots. */
START_TEST(eq41_discriminant_from_the_roots)
{
    acb_ptr roots = _acb_vec_init(DEGREE);
    acb_t product, difference;
    arb_t c1, c2;
    acb_init(product);
    acb_init(difference);
    arb_init(c1);
    arb_init(c2);
    for (slong w = 1; w <= 6; w++) {
        arb_set_si(c1, 9 + w);
        arb_sqrt_ui(c2, (ulong)(4 * w), BITS);
        ck_assert(roots41_gains(roots, c1, c2, BITS));
        acb_one(product);
        for (int i = 0; i < DEGREE; i++) {
            for (int j = 0; j < i; j++) {
                acb_sub(difference, roots + i, roots + j, BITS);
                acb_mul(product, product, difference, BITS);
                acb_mul(product, product, difference, BITS);
            }
        }
        ck_assert(arb_contains_si(acb_realref(product), 192 * w * w * w * w + 4032 * w * w * w - 33984 * w * w + 65856 * w));
    }
    acb_clear(product);
    acb_clear(difference);
    arb_clear(c1);
    arb_clear(c2);
    _acb_vec_clear(roots, DEGREE);
}
END_TEST

/* Around C1 = 12, C2 = 4 (Omega = 1), near and far, no gains decay as fast as Omega. */
START_TEST(eq41_no_gains_beat_omega)
{
    arb_t c1, c2, rate;
    arb_init(c1);
    arb_init(c2);
    arb_init(rate);
    for (int scale = 0; scale <= 20; scale += 4) {
        for (int k = 0; k < 16; k++) {
            double angle = 0.19634954084936207 * (2 * k + 1); /* pi/16, odd multiples: off the axes */
            arb_set_d(c1, 12 + 16 * cos(angle) * exp2(-scale));
            arb_set_d(c2, 4 + 8 * sin(angle) * exp2(-scale));
            slowest(rate, c1, c2);
            arb_sub_si(rate, rate, 1, BITS);
            ck_assert_msg(arb_is_negative(rate), "scale %d, direction %d", scale, k);
        }
    }
    arb_clear(c1);
    arb_clear(c2);
    arb_clear(rate);
}
END_TEST

/* The shifted polynomial p(z - 1) at those gains is (z^2 + 2)^2, by Taylor coefficients at -1. */
START_TEST(eq41_best_gains_reach_omega)
{
    const slong best[3] = {1, 12, 4};
    const slong shifted[DEGREE + 1] = {4, 0, 4, 0, 1};
    fmpq *a = _fmpq_vec_init(DEGREE + 1);
    fmpq_poly_t p, z;
    fmpq_t c;
    fmpq_init(c);
    fmpq_poly_init(p);
    fmpq_poly_init(z);
    ck_assert(section_at("eq41", best, a));
    for (int i = 0; i <= DEGREE; i++)
        fmpq_poly_set_coeff_fmpq(p, i, a + i);
    polynomial(z, "x - 1");
    fmpq_poly_compose(p, p, z);
    for (int i = 0; i <= DEGREE; i++) {
        fmpq_poly_get_coeff_fmpq(c, p, i);
        ck_assert_int_eq(fmpq_cmp_si(c, shifted[i]), 0);
    }
    fmpq_clear(c);
    fmpq_poly_clear(p);
    fmpq_poly_clear(z);
    _fmpq_vec_clear(a, DEGREE + 1);
}
END_TEST

Suite *suite(void)
{
    Suite *s = suite_create("claims_stability");
    TCase *c = tcase_create("claims");
    tcase_add_checked_fixture(c, NULL, close_all);
    tcase_add_loop_test(c, claims_yield_their_verdicts, 0, EXPECTED);
    tcase_add_test(c, claims_are_well_formed);
    tcase_add_test(c, numbers_are_written_positionally);
    tcase_add_test(c, numbers_without_proof_are_not_written);
    tcase_add_test(c, identities_hold_or_not);
    tcase_add_test(c, identities_look_at_enough_points);
    tcase_add_test(c, identities_know_the_sheet);
    tcase_add_test(c, roots_are_counted_once_and_strictly_beyond);
    tcase_add_test(c, a_sign_beyond_a_point_is_strict);
    tcase_add_test(c, eq40_energy_is_lost_through_the_length_rate);
    tcase_add_test(c, eq40_charge_controls_the_plane);
    tcase_add_test(c, eq42_agrees_with_the_roots);
    tcase_add_test(c, eq44_optimum_beats_its_neighbours);
    tcase_add_test(c, eq44_rates_keep_their_bounds);
    tcase_add_test(c, eq44_bounds_that_do_not_hold_are_refused);
    tcase_add_test(c, eq41_discriminant_from_the_roots);
    tcase_add_test(c, eq41_no_gains_beat_omega);
    tcase_add_test(c, eq41_best_gains_reach_omega);
    suite_add_tcase(s, c);
    return s;
}
