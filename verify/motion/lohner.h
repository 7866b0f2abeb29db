/*
 * A set of states carried along a flow, after Lohner: an exact point, six directions, and how far the set
 * goes in each. Boxes instead would be turned and boxed again at every step, which costs 2.5 digits per
 * radian of orbit; directions that turn with the flow cost next to nothing.
 */
#ifndef CT_LOHNER_H
#define CT_LOHNER_H

#include <stdbool.h>

#include "text/flint.h"

enum { LOHNER_SIZE = 6, LOHNER_BITS = 64 };

/* { centre + basis e : |e_j| <= radius_j }; centre and basis are exact */
struct lohner {
    arb_ptr centre;
    double basis[LOHNER_SIZE][LOHNER_SIZE];
    mag_ptr radius;
};

void lohner_init(struct lohner *set);
void lohner_clear(struct lohner *set);

void lohner_from_box(struct lohner *set, arb_srcptr box);
void lohner_to_box(arb_ptr box, const struct lohner *set);

/*
 * The image of the set under a map that takes centre + basis e into image + D e + error, where |error_i| <= error[i] and D lies in
 * derivative[0] + sum s_i derivative[i], i from 1 to count - 1, for any |s_i| <= 1; false if no bounded set was found.
 */
bool lohner_move(struct lohner *set, arb_srcptr image, const arb_mat_struct *derivative, int count, mag_srcptr error, slong prec);

#endif
