/*
 * The pair under the law (18) as a ball in a well that friction never lets it climb, and what follows of it
 * for motions from rest.
 *
 * Units: time in 1/Omega, lengths of craft 1 in r_ref = L_ref m2/(m1 + m2), so that r = L/L_ref; n = C1/Omega^2 and
 * c2 = C2/Omega = 2 sqrt(n - 9). There (3), closed by (7) and (18), reads
 *
 *     x'' = 2 y' + 3 x + P x,   y'' = -2 x' + P y,   z'' = -z + P z,   P = -(3 + n (r - 1) + c2 r')/r^3,
 *
 * and E = (x'^2 + y'^2 + z'^2)/2 - (3 x^2 - z^2)/2 + (n - 3)/r + n ln r never grows: E' = -c2 r'^2/r^2. Of
 * all places at one distance those on the radius have the least E, WELL(r): a pair with less E than the
 * well's rim, at r = outer, never passes it. At constant charge n = c2 = 0, and E is conserved.
 *
 * A bounded motion in the orbit plane comes to one with r' = 0 throughout (LaSalle). There, phi being the angle
 * from the radius, phi'^2 + 2 phi' + 3 cos^2 phi + P = 0 and phi'' = -3 sin phi cos phi; the derivative of
 * the first is 2 phi'' (2 phi' + 1) = 0, so phi' is constant, sin phi cos phi = 0, and the pair at rest.
 */
#ifndef CT_WELL_H
#define CT_WELL_H

#include "flow.h"

#define WELL "(-3/2*x^2 + (n - 3)/x + n*log(x))" /* E at rest on the radius, x = r        */
#define SIDE "((n - 3)/x + n*log(x))"            /* the same in the plane across it, x = 0 */

/* The simulation's n, and the one that the paper calls optimal. */
enum { GAINS = 2 };
extern const ulong well_gains[GAINS];

/* The well about L_ref for one n: it reaches out to r = outer, at the height of the rim. */
struct well {
    ulong gain; /* n */
    arb_t n, outer, rim;
    bool proved; /* the rim is the lowest way out */
};

void well_init(struct well *w, ulong n);
void well_clear(struct well *w);

/* Follows the pair from rest on the radius at r = start; n = 0: at constant charge. */
enum flow_status follow(ulong n, const arb_t start, const fmpq *times, slong count, flow_receiver *receive,
                        void *context);

/* What comes of a pair let go from rest on the radius so many tenths of a metre longer than L_ref. */
enum fate { FATE_OPEN, FATE_RETURNS, FATE_ESCAPES };
enum fate well_fate(const struct well *w, slong tenths);

#endif
