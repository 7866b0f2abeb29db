/* What the tests of claims/ ask of balls: for certain. */
#ifndef CT_TESTS_BALLS_H
#define CT_TESTS_BALLS_H

#include "claims/trajectory.h"
#include "text/scope.h"

static inline bool is_below(const arb_t x, double limit)
{
    SCOPE(arb, y);
    arb_set_d(y, limit);
    return arb_lt(x, y);
}

static inline bool is_above(const arb_t x, double limit)
{
    SCOPE(arb, y);
    arb_set_d(y, limit);
    return arb_gt(x, y);
}

/* It falls below the limit and stays there. */
static inline bool settles(arb_t hours, const struct trajectory *t, int which, const arb_t limit)
{
    return trajectory_exit(hours, t, which, limit) && arb_is_finite(hours);
}

#endif
