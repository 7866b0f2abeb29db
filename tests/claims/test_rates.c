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

