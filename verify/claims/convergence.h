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
 */
#ifndef CT_CONVERGENCE_H
#define CT_CONVERGENCE_H

#include <stdbool.h>

#include "claims/claim.h"
#include "claims/trajectory.h"
#include "proof/derivation.h"

enum { STUDIED = 6 };

struct study {
    const char *name;
    int which[STUDIED], count;   /* variables of trajectories, in SI */
    int order[STUDIED];          /* expected of each */
    long first, over;            /* parameters first/over, first/over/ratio, ... */
    int ratio, rows;
    /* The differences, not negative; false where a motion was not proved. */
    bool (*differences)(arb_ptr d, const struct derivations *steps, const struct study *s, const fmpq_t parameter);
    long seconds, every;         /* after which motions are compared, or the largest difference until then, each `every` */
    bool nonlinear, pitch_alone;
    bool of_claims;              /* it serves claims alone, and stands in no file of data */
    const char *n, *m1, *m2;     /* where they are not the paper's */
};

extern const struct study studies[]; /* ended by one without name */
const struct study *study_find(const char *name); /* NULL: there is none of that name */

/* At [row * STUDIED + variable]; an order is log(difference before/difference)/log(ratio), from row 1 on. */
struct convergence {
    const struct study *study;
    fmpq *parameters;
    arb_ptr differences, orders, constants; /* difference/parameter^expected */
};

/* Differences from that row on, orders from the next; false where one was not found. */
bool convergence_init(struct convergence *c, const struct derivations *steps, const struct study *s, int from);
void convergence_clear(struct convergence *c);

/* As a computation, of a struct study. */
void run_study(struct computed *c);

#endif
