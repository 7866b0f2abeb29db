/*
 * The paper's simulation as proved samples of a trajectory, and bounds for what happens between and after them.
 *
 * Samples are in radians of orbit and units of L_ref, for both models alike: psi, theta, eta = dL/L_ref, their
 * rates, and the place x1 y1 z1 of craft 1 in units of its arm m2/(m1 + m2) L_ref, by the exact rotation (10) in
 * a nonlinear motion and by small angles (eq10lin) in a linear one, as the paper has it.
 */
#ifndef CT_TRAJECTORY_H
#define CT_TRAJECTORY_H

#include "claims/second_order.h"

enum { ETA = DL, ETA_DOT = DL_DOT, PLACE_X, PLACE_Y, PLACE_Z, COORDINATES }; /* and PSI, THETA and their rates of flow.h */

/*
 * What follows from them: the charges, dQ/Q_ref = (c1 eta + c2 eta')/3 by (7) and (18); the amplitude of pitch,
 * sqrt(theta^2 + theta'^2/4), and its phase.
 */
enum derived { PRODUCT = COORDINATES, AMPLITUDE, PHASE, VARIABLES };
extern const char *const variable_names[VARIABLES];

/* What is NULL is the paper's own: Table 1, n = 10, 0.01 rad, 0.01 rad, 0.1 m, no rates. */
struct simulation {
    const struct derivations *steps;  /* and the sheet that they are of */
    bool nonlinear;
    long rk4;                         /* step in s of the classical Runge-Kutta method, 0: the motion itself */
    slong digits;                     /* that the samples are proved to; 0: TRAJECTORY_DIGITS. Fewer run faster. */
    const char *n, *psi, *theta, *dL; /* exact decimals, SI */
    const char *m1, *m2, *C1, *C2;
    const fmpq *scale;                /* of psi, theta and dL at the start */
    bool forced;                      /* starts on the closed form of second_order.h, theta being its amplitude */
    bool closed_form;                 /* and is that form */
    const char *swing;                /* forced, by the law whose length swings so much, in L_ref */
    arb_srcptr start;                 /* a sample to start from instead of the angles */
    arb_srcptr held;                  /* of a nonlinear motion: Q/Q_ref, held, in place of the law; C1, C2 are 0 */
};

/* Sampled from first to last, each `step` seconds; and another, to compare it with, NULL: none. */
struct sampled {
    struct simulation simulation;
    long first, step, last;
    const struct simulation *beside;
};

struct trajectory {
    const struct derivations *steps;
    bool nonlinear, other_law;        /* than (18), of which no bounds are proved */
    slong prec, count;
    long first, step;                 /* s: of the samples */
    arb_ptr c1, c2;                   /* C1/Omega^2, C2/Omega */
    arb_ptr amplitude;                /* of pitch at the start, rad */
    arb_ptr unit, Omega;              /* what one of each variable is in SI; of psi_dot, in rad/s */
    arb_ptr samples;
    struct second_order closed;       /* the closed form of these gains and this law */
};

enum { TRAJECTORY_DIGITS = 20, HOUR = 3600, DAY = 24 * HOUR };

/* The value that the paper's simulation gives a quantity: Table 1 and the initial conditions. */
void sheet_value(arb_t x, const struct sheet *s, const char *name, slong prec);

/* Samples at first, first + step, ... last, whole seconds; false when the flow ended before: then they are no numbers. */
bool trajectory_run(struct trajectory *t, const struct simulation *s, long first, long step, long last);
void trajectory_init(struct trajectory *t); /* of `count` samples; all its numbers are 0 */
void trajectory_clear(struct trajectory *t);
arb_ptr trajectory_sample(const struct trajectory *t, slong k);

/* From n Taylor coefficients of each of x y z, in units of L_ref, those of psi, theta and eta. */
void angle_series(arb_ptr angles, arb_srcptr place, slong n, slong prec);

/* dQ/Q_ref that the law (18) commands: (c1 eta + c2 eta')/3 */
void commanded(arb_t product, const arb_t c1, const arb_t c2, const arb_t eta, const arb_t eta_dot, slong prec);

/* One of the variables at a sample. */
void trajectory_value(arb_t x, const struct trajectory *t, slong k, int which);

/* The amplitude of pitch at a sample by the slow law of second_order.h. */
void trajectory_slow_law(arb_t amplitude, const struct trajectory *t, slong k);

/* The largest |variable| on these samples, ends included; or difference from that of a motion beside it, NULL: none. */
void trajectory_peak(arb_t peak, const struct trajectory *t, const struct trajectory *beside, int which, slong from, slong to);

/*
 * A Lyapunov function that no motion raises, so that its value at a sample bounds all that comes after.
 *     linear     E = (3 psi^2 + psi'^2 + (c1 - 9) eta^2 + eta'^2)/2              E' = -c2 eta'^2
 *     nonlinear  the property `tether_energy` of derivations.yaml                E' = -c2 (l'/l)^2, by the step `energy`
 * Pitch is left out of the linear one: there it is on its own.
 */
void trajectory_energy(arb_t energy, const struct trajectory *t, slong k);
void tether_energy(arb_t energy, const struct derivations *steps, const arb_t c1, arb_srcptr sample, slong prec);

/*
 * Bounds on the coordinates and their derivatives, from a sample on for ever; of a rate, up to the second. `bounds` has BOUNDS numbers;
 * false where not all of them are proved.
 */
enum { DERIVATIVES = 4, BOUNDS = DERIVATIVES * COORDINATES };
#define BOUND_OF(which, derivative) (DERIVATIVES * (which) + (derivative))
bool trajectory_bounds(arb_ptr bounds, const struct trajectory *t, slong k);

/* What a coordinate or the charges can exceed their samples by between them, ... */
void bound_between_samples(arb_t excess, const struct trajectory *t, arb_srcptr bounds, int which);

/* ... and a bound on their peak from sample to sample, between them too. */
bool trajectory_supremum(arb_t supremum, const struct trajectory *t, const struct trajectory *beside, int which, slong from, slong to);

/*
 * When |coordinate| falls below a limit and stays so until the last sample: the last sample above and the first one after
 * which it is below on samples and between them, as an enclosure of the time in hours; indeterminate if it does not. False
 * where there are no bounds.
 */
bool trajectory_exit(arb_t hours, const struct trajectory *t, int which, const arb_t limit);

#endif
