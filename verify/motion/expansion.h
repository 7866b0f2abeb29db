/*
 * What a step of a set of states rests on: the series of the motion from its middle and from all of it, of the derivatives along
 * the set's directions, and bounds for what they leave out. In balls, or in models of sets of parameters and initial states.
 */
#ifndef CT_EXPANSION_H
#define CT_EXPANSION_H

#include "motion/flow.h"
#include "motion/lohner.h"
#include "motion/taylor.h"

struct expansion {
    struct jet path, hull, column[FLOW_STATE];              /* from the middle, from all of the set, and its derivatives */
    struct majorant path_bound, hull_bound, spread_bound;   /* spread: |J| radius                                        */
};

/* `space` of the path, `linear` of all others; NULL, NULL: balls */
void expansion_init(struct expansion *e, const struct system *system, slong order, slong derivative_order, const struct space *space,
                    const struct space *linear);
void expansion_clear(struct expansion *e);

/* What follows from the path's and the hull's coefficients 0, but for q */
void expansion_path(struct expansion *e, slong prec, double fall);
void expansion_derivatives(struct expansion *e, const struct lohner *set);

/*
 * The step at which the path's last two terms, of positions, fall to 2^left_out, but no more than the longest: a dyadic of 8 bits.
 * Then the longest of step, step/2, ... for which bounds on |s| <= step are proved, or 0 after so many halvings.
 */
double expansion_step(const struct expansion *e, double left_out, double longest);
double expansion_prove(struct expansion *e, const struct lohner *set, double step, int halvings);

/* log2 of the largest coefficient k of the position; a guide, no bound */
double expansion_position(const struct expansion *e, slong k);

/* x gets the error that all of |J B s| makes within the step, of state or series v. */
void expansion_spread(arb_t x, const struct expansion *e, int v);

/* The set at the step's end h, exact: the path there has the image, error is what else the motions are off; false if it is lost. */
bool expansion_move(struct lohner *set, arb_srcptr image, const struct expansion *e, const arb_t h, mag_srcptr error);

/* s = Omega t - now, and whether |s| <= step for certain */
bool time_within(arb_t s, const fmpq_t t, const arb_t Omega, const arf_t now, double step, slong prec);

/* Seconds, of no sign, that `now` radians are for certain */
double seconds_within(const arf_t now, const arb_t Omega);

#endif
