/*
 * What one decides with: how long the law may be held and how late it may act (sampling.h); and what the energy of the
 * nonlinear closed loop, (3) with (7) and (18), guarantees, for any masses and gains C1 > 9 Omega^2, C2 > 0: the basin
 * of rest at L_ref, the largest boxes in it, and the errors that stay which the pair bears.
 *
 * Units: time in 1/Omega, lengths in L_ref, n = C1/Omega^2, c2 = C2/Omega. The law commands the charge product Q_ref s/3,
 * s = 3 + n (r - 1) + C2/Omega r'; what the pair carries is Q_ref f(s)/3, where f(s) is s itself, or s held to charges of at
 * most q_max a craft, |f| <= S = 3 (q_max/q_ref)^2, or to products that attract, f >= 0. Of that
 *
 *     E = v^2/2 - (3 x^2 - z^2)/2 + U(r),   U' = f(3 + n (r - 1))/r^2
 *
 * never grows, and from E < level, x > 0, r < outer every motion comes to rest at L_ref (claims basin-converges,
 * basin-saturated). Rates of the length do not enter E but by v: none of its numbers depends on C2.
 *
 * Each number is a formula, or the root of one; the formulas stand in one table, in the notation of the sheets. The terms of the
 * theorem, with their tests in tests/claims/test_guarantee.c:
 *   (G1) the level is the lower of the hill on the radius and of the plane across     (half_widths_reach_the_level)
 *   (G2) in all of a box E is below it, whatever the signs                            (box_is_the_largest, corner_comes_back)
 *   (G3) a saturated force has its own U: the level is lower, the box smaller         (bounded_charges_bring_back)
 *   (G4) rest is there up to the fold; at once E is below the saddle                  (errors_are_borne_up_to_the_fold, steps_are_borne)
 *   (G5) for all n, c2 and y of the balls                                                 (numbers_of_a_ball_hold_those_of_its_gains)
 */
#ifndef CT_GUARANTEE_H
#define CT_GUARANTEE_H

#include <stdbool.h>

#include "proof/derivation.h"

/* The number, and another if it is the lesser; what vanishes at x, once from low to high. */
enum { VALUE, OTHER, VANISHES, LOW, HIGH, FORMULAS };

struct guarantee {
    const char *name;    /* in formulas, and as a column of data/basin.csv or data/tolerance.csv */
    int lengths, rates;  /* in SI: times L_ref^lengths Omega^rates */
    const char *unit;    /* there; "-": a number */
    const char *meaning; /* NULL: serves the others alone */
    const char *formula[FORMULAS]; /* NULL: of the number, the root x itself, without one largest_hold */
};

/* Each rests on those before it; the last one has no name. */
extern const struct guarantee guarantees[];
enum { GUARANTEES = 35 };

/*
 * All of them, into GUARANTEES balls, for every n, c2 and y of these balls. n > 9; c2 > 0; y > 1, the longest length
 * that the charges can hold, q_max = y^(3/2) q_ref by (7), NULL where they have no bound: of the basin alone, the
 * tolerances are those without a bound. Of `steps` is the held law; NULL: how long it may be held is left open. What
 * stays open is an indeterminate ball; false where n, c2 or y may lie outside the domain.
 */
bool guarantees_enclose(arb_ptr values, const struct derivations *steps, const arb_t n, const arb_t c2, const arb_t y, slong bits);

/* The place in that of a name; -1: there is none. */
int guarantee_find(const char *name);

#endif
