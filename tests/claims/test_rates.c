/*
 * What paper/claims.yaml says of the roots of (41), against the certified roots themselves.
 */
#include <math.h>

#include "tests/run.h"
#include "proof/roots.h"
#include "text/scope.h"

enum { BITS = 256, DEGREE = 4 };

/* Gains in quarters, Omega = 1: (42) agrees with the signs of the certified roots, on the boundary too. */
CASE(rates, NULL, flint_cleanup)

TEST(eq42_agrees_with_the_roots)
{
    VECTOR(acb, roots, DEGREE);
    SCOPE(fmpq, Omega, C1, C2);
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
}

/* The rate of the slowest root at c1, c2 (over Omega, Omega^2). */
static void slowest(arb_t rate, const arb_t c1, const arb_t c2)
{
    VECTOR(acb, roots, DEGREE);
    ck_assert(roots41_gains(roots, c1, c2, BITS));
    arb_neg(rate, acb_realref(roots + DEGREE - 1));
}

/* On (44). */
static void rate_at(arb_t rate, const arb_t n)
{
    SCOPE(arb, c2);
    arb_sub_si(c2, n, 9, BITS);
    arb_sqrt(c2, c2, BITS);
    arb_mul_2exp_si(c2, c2, 1);
    slowest(rate, n, c2);
}

/* The n and the rate of n12-optimal, by the roots themselves. */
TEST(eq44_optimum_beats_its_neighbours)
{
    SCOPE(arb, best, n, rate, greatest);
    arb_set_str(best, "11.8116019489994475627782", BITS);
    rate_at(greatest, best);
    arb_set_str(rate, "0.598916907216339712577893 +/- 1e-24", BITS); /* stationary: the digits that best lacks do not matter */
    ck_assert(arb_overlaps(rate, greatest));
    for (int k = 0; k < 2; k++) {
        arb_set_d(n, k == 0 ? 1e-6 : -1e-6);
        arb_add(n, n, best, BITS);
        rate_at(rate, n);
        ck_assert(arb_lt(rate, greatest));
    }
}

/* u = sqrt(n - 9) from 1/16 to 16: the bounds of real-parts-vanish against the roots themselves. */
TEST(eq44_rates_keep_their_bounds)
{
    SCOPE(arb, n, rate, u, bound);
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
}

/* The discriminant of complex-pairs, as the product of the squared differences of the roots. */
TEST(eq41_discriminant_from_the_roots)
{
    VECTOR(acb, roots, DEGREE);
    SCOPE(acb, product, difference);
    SCOPE(arb, c1, c2);
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
}

/* Around C1 = 12, C2 = 4 (Omega = 1), near and far, no gains decay as fast as Omega. */
TEST(eq41_no_gains_beat_omega)
{
    SCOPE(arb, c1, c2, rate);
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
}

/* The polynomial at those gains is (s^2 + 2 s + 3)^2: two double roots, -1 +- i sqrt 2. */
TEST(eq41_best_gains_reach_omega)
{
    VECTOR(acb, roots, DEGREE);
    SCOPE(acb, z);
    SCOPE(fmpq, Omega, C1, C2);
    fmpq_one(Omega);
    fmpq_set_si(C1, 12, 1);
    fmpq_set_si(C2, 4, 1);
    ck_assert(roots41(roots, Omega, C1, C2, BITS));
    for (int i = 0; i < DEGREE; i++) {
        acb_add_ui(z, roots + i, 1, BITS);
        acb_sqr(z, z, BITS);
        ck_assert(arb_contains_zero(acb_imagref(z)) && arb_contains_si(acb_realref(z), -2));
        ck_assert(arb_contains_si(acb_realref(roots + i), -1));
    }
}
