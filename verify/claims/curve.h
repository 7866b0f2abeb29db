/*
 * A formula of one unknown at work in balls, and its root.
 */
#ifndef CT_CURVE_H
#define CT_CURVE_H

#include "formula/expression.h"

struct curve {
    struct machine *machine;
    int x, node, slope; /* the unknown, the formula, its derivative */
};

/* The derivative of a node by an input, appended to the program. */
int program_slope(struct program *p, int node, int x);

arb_srcptr curve_at(struct curve *c, const arb_t x);

/* For arb_calc: the value and the derivative. */
int curve_series(arb_ptr out, const arb_t x, void *curve, slong order, slong prec);

int sign_of_ball(const arb_t z);

/*
 * The number of roots between low and high, as far as `most`; -1 where so many evaluations leave that open. `first` holds the first of
 * them alone, or is indeterminate where what lies before is not known.
 */
slong roots_between(arb_t first, arb_calc_func_t f, void *of, const arb_t low, const arb_t high, slong most, slong evaluations, slong prec);

/*
 * Narrows an interval that holds one root, at whose lower end f has a certain sign and none further on up to the root, as far
 * as the values of f allow.
 */
void narrow_root(arb_t root, arb_calc_func_t f, void *of, slong prec);

#endif
