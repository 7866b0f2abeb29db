/*
 * Motions of a pair let go from rest on the radius, under the law (18) and at constant charge, and the basin of the
 * equilibrium at L_ref.
 *
 * Units: time in 1/Omega, lengths of craft 1 in r_ref = L_ref m2/(m1 + m2), so that r = L/L_ref; n = C1/Omega^2 and
 * c2 = C2/Omega = 2 sqrt(n - 9). There (3), closed by (7) and (18), reads
 *
 *     x'' = 2 y' + 3 x + P x,   y'' = -2 x' + P y,   z'' = -z + P z,   P = -(3 + n (r - 1) + c2 r')/r^3,
 *
 * and E = (x'^2 + y'^2 + z'^2)/2 + V never grows: E' = -c2 r'^2/r^2 (step `energy`). Of all
 * places at one distance those on the radius have the least V: a pair with less E than the separatrix level, V on the
 * radius at the second equilibrium, r = outer, never passes that distance. At constant charge n = c2 = 0, and E is
 * conserved. The claim basin-at-rest proves all this.
 *
 * Without bounds of the charges and with C2 > 0 all that stays within comes to rest, in space too: claim basin-converges.
 */
#ifndef CT_BASIN_H
#define CT_BASIN_H

#include "motion/flow.h"
#include "proof/derivation.h"

enum { BASIN_BITS = 128 };

struct basin {
    const struct derivations *steps;
    ulong gain; /* n */
    arb_t outer, level;
    bool closed; /* no way out is lower than the level: in the plane across the radius V is least at r = 1 - 3/n */
};

void basin_init(struct basin *b, const struct derivations *steps, ulong n);
void basin_clear(struct basin *b);

/* Follows the pair from rest on the radius at r = start; n = 0: at constant charge. */
enum flow_status follow_from_rest(ulong n, const arb_t start, const fmpq *times, slong count, flow_receiver *receive,
                                  void *context);

/* What becomes of a pair let go from rest on the radius, so many tenths of a metre longer than L_ref. */
enum release { RELEASE_OPEN, RELEASE_RETURNS, RELEASE_ESCAPES };
enum release basin_release(const struct basin *b, slong tenths);

#endif
