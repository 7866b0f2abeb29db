/*
 * How fast differences vanish: the same difference as a parameter shrinks, its observed order, its constant.
 *
 *     linear_*          nonlinear motion less linear, the paper's initial disturbance times the parameter;
 *     linear_pitch_*    the same for its pitch alone
 *     rk4_*             the classical Runge-Kutta method less the motion; the parameter is its step in s
 *     hill_*            the pair in the Earth's inverse-square field (two_body.h) less the nonlinear motion, in Hill's;
 *                       the parameter is L_ref/R_c
 *     forced_*          nonlinear motion less the closed form of second_order.h that starts with it; the parameter is
 *                       the amplitude a of pitch in rad
 *     slow_law          the same after 1/a^2 radians of orbit: the amplitude, as a fraction, and the phase of pitch
 *
 * All are certified, but hill_*, which is measured: its Taylor steps have no proved bound on what they leave out.
 */
#ifndef CT_CONVERGENCE_H
#define CT_CONVERGENCE_H

#include <stdbool.h>

#include "claims/track.h"
#include "proof/derivation.h"

enum { VARIABLES = 6 };
enum { AMPLITUDE = COORDINATES, PHASE };   /* beside the coordinates of a track */
extern const char *const variable_names[]; /* of them all, in SI */

struct study {
    const char *name;
    int which[VARIABLES], count; /* coordinates */
    int order[VARIABLES];        /* expected of each */
    const char *first;           /* parameters first, first/ratio, ... */
    int ratio, rows;
    /* The differences, not negative; false where a motion was not proved. */
    bool (*differences)(arb_ptr d, const struct derivations *steps, const struct study *s, const fmpq_t parameter);
    long seconds;                /* after which motions are compared */
    bool nonlinear, pitch_alone;
    bool measured;               /* false: certified */
    const char *m1, *m2;         /* where they are not Table 1's */
};

extern const struct study studies[]; /* ended by one without name */
const struct study *study_find(const char *name);

/* At [row * VARIABLES + variable]; an order is log(difference before/difference)/log(ratio), from row 1 on. */
struct convergence {
    const struct study *study;
    fmpq *parameters;
    arb_ptr differences, orders, constants; /* difference/parameter^expected */
};

/* Differences from that row on, orders from the next; false where one was not found. */
bool convergence_init(struct convergence *c, const struct derivations *steps, const struct study *s, int from);
void convergence_clear(struct convergence *c);

/* Of the last row. */
arb_srcptr convergence_order(const struct convergence *c, int variable);
arb_srcptr convergence_constant(const struct convergence *c, int variable);

#endif
