/*
 * The law (18) acting on a sample: how long it may be held before the linear model (17), (40) no longer comes to rest;
 * and the nonlinear motion. Units: radians of orbit, L_ref; c1 = C1/Omega^2 > 9, c2 = C2/Omega > 0.
 *
 * Held for T, the state goes from one sample to the next by a matrix with four eigenvalues z, its multipliers. By
 * z = (1 + T v/2)/(1 - T v/2) the unit disk is the left half plane of v, and their polynomial one of v with
 * coefficients r_0 ... r_4, that of (41) at T = 0. A multiplier meets the unit circle only where r_0 = 0 (z = 1), r_4 = 0
 * (z = -1) or r_1 r_2 r_3 = r_0 r_3^2 + r_4 r_1^2 (a pair, by Orlando's formula), and from T = 0 to the first such T all
 * lie inside. Without the law the model has the roots +-a, +-i b, a^2 = 2 sqrt(7) + 1, b^2 = 2 sqrt(7) - 1.
 *
 * The terms of this, with a test named for each in tests/claims/test_sampling.c: (H1) before the limit nothing is met,
 * (H2) at it a multiplier leaves the disk, (H3) for all gains of the balls, or the limit is open; (D1) to (D3) of a delay
 * (guarantee.c) in their place.
 */
#ifndef CT_SAMPLING_H
#define CT_SAMPLING_H

#include "claims/trajectory.h"

/* c1 by (43), c2 by (44), or as it is said. */
void set_gains(arb_t c1, arb_t c2, const char *n, const char *c2_over_Omega, slong prec);

/* The model comes to rest for every T in (0, limit), and not at the limit; indeterminate where prec does not suffice. */
void largest_hold(arb_t limit, const struct derivations *steps, const arb_t c1, const arb_t c2, slong prec);

/*
 * The nonlinear motion with the law held for T seconds again and again: from a sample `count` more, T apart, proved to `digits` at the
 * last, each to one more than the next. False where one is not proved.
 */
bool hold_follow(arb_ptr samples, const struct derivations *steps, const arb_t c1, const arb_t c2, long T, slong count, slong digits);

#endif
