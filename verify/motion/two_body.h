/*
 * The pair in the Earth's inverse-square field, each craft on its own: the motion of which the paper's Eq. (2) keeps
 * the part linear in L/R_c.
 */
#ifndef CT_TWO_BODY_H
#define CT_TWO_BODY_H

#include <stdbool.h>

#include "text/flint.h"

enum { CRAFT = 2, AXES = 3 };

/* Units: radians of orbit, lengths in L_ref, masses in m1 + m2; places in the Hill frame of the circle R_c. */
struct two_body {
    arb_ptr smallness;      /* L_ref/R_c > 0                     */
    arb_ptr c1, c2;         /* C1/Omega^2, C2/Omega              */
    arb_ptr mass;           /* two shares, of sum 1              */
    arb_ptr place, velocity; /* x y z of craft 1, then of craft 2 */
};

void two_body_init(struct two_body *b);
void two_body_clear(struct two_body *b);

/*
 * The motion over tau >= 0 radians, charges by (7) and (18) from the true distance and its rate: an enclosure for all starts and
 * parameters within the balls, or false where the series of a step were not proved.
 */
bool two_body_move(struct two_body *b, const arb_t tau, slong prec);

#endif
