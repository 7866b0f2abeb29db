/*
 * Certified motion of the two craft: the linear model (40) by the matrix exponential, the nonlinear
 * model (3 closed by 7 and 18) by a validated Taylor integrator, and the paper's classical
 * Runge-Kutta method free of rounding. Every state that leaves here is a proved enclosure: it holds the
 * exact state for all parameters and initial states within the balls given.
 */
#ifndef CT_FLOW_H
#define CT_FLOW_H

#include <stdbool.h>

#include "text/flint.h"

enum { FLOW_STATE = 6, FLOW_HALF = FLOW_STATE / 2 }; /* positions, or the angles and dL; then their rates */
enum { PSI, THETA, DL, PSI_DOT, THETA_DOT, DL_DOT };

/* Enclosures of the parameters, side by side in the sheet's order; the caller makes them as sharp as the working precision. */
struct flow_parameters {
    arb_ptr Omega, k_c, m1, m2, L_ref, C1, C2; /* rad/s, N m^2/C^2, kg, kg, m, 1/s^2, 1/s; the linear model needs no k_c and masses */
};

void flow_parameters_init(struct flow_parameters *p);
void flow_parameters_clear(struct flow_parameters *p);
#define FLOW_PARAMETERS(p) OWNED(flow_parameters) p; flow_parameters_init(&p)

/* C1/Omega^2 and C2/Omega: the gains in radians of orbit */
void flow_gains(arb_t c1, arb_t c2, const struct flow_parameters *p, slong prec);

/*
 * What one of each coordinate is in SI, time being in radians of orbit: of a linear motion the first two are angles and the third is in
 * L_ref, of a nonlinear one all are in r_ref = m2 L_ref/(m1 + m2).
 */
void flow_units(arb_ptr unit, bool nonlinear, const struct flow_parameters *p, slong prec);

enum flow_status {
    FLOW_DONE,
    FLOW_STOPPED,   /* the receiver asked to stop                                               */
    FLOW_WIDE,      /* the enclosure grew past use: more precision may help                     */
    FLOW_CLOSE,     /* at `reached` L < L_ref/128, proved, and steps become too short to go on: whether
                       the craft meet is not known                                              */
    FLOW_UNCHARGED, /* of a set: at the row after the last, Q_ref + dQ may be >= 0 for some motion   */
    FLOW_DOMAIN,    /* of a method: a time lies between its steps, or before the last one */
    FLOW_STALLED    /* too many steps: gains so stiff, or a time so late, that no end is in sight */
};

const char *flow_status_text(enum flow_status status);

/* Called in order of time, once for each requested time; non-zero stops the flow. */
typedef int flow_receiver(void *context, slong k, const fmpq_t t, arb_srcptr state);

/* How the nonlinear flow makes its steps, for other laws and for tests in which one error term outweighs all others. What is 0 is left to it. */
struct system;
struct flow_steps {
    slong order, derivative_order; /* of the series from the centre, >= 2, and of the derivatives, >= 1 */
    double step;                   /* radians, proposed at every step in place of what the series propose */
    const struct system *system;   /* in place of the closed loop: its states, other series, and after its constants ... */
    arb_srcptr constants;          /* ... these */
    arb_srcptr held;               /* charges held, their product being so many Q_ref, and gains of 0 */
};

/*
 * What is to be followed: of either model the motion itself, or where h is not NULL the classical Runge-Kutta method's steps of h > 0,
 * of which every time >= 0 is a multiple. States are psi theta dL psi_dot theta_dot dL_dot (linear) or x1 y1 z1 x1_dot y1_dot z1_dot
 * (nonlinear), SI; parameters and initial states lie in the sheet's domain. `times`, one at least, are exact, monotone away from 0 (all
 * >= 0 ascending or all <= 0 descending); at 0 the initial state itself is handed on. `prec` is the working precision in bits; `digits`
 * is the accuracy wanted: an enclosure wider than 10^-digits of the state's largest coordinate is past use.
 */
struct flow_request {
    const struct flow_parameters *p;
    arb_srcptr initial;
    const fmpq *times;
    slong count, digits, prec;
    flow_receiver *receive;
    void *context;
    bool nonlinear;
    const fmpq *h;
    const struct flow_steps *how; /* of nonlinear motions; NULL: all is left to the flow */
    double reached;               /* gets the last proved time in seconds                */
};
enum flow_status flow_run(struct flow_request *r);

/* Those, one by one */
enum flow_status flow_linear(struct flow_request *r);
enum flow_status flow_nonlinear(struct flow_request *r);
enum flow_status rk4(struct flow_request *r);

/* The rates by (40) of psi theta l and their rates, in radians of orbit and units of L_ref. */
void linear_rates(arb_ptr rate, arb_srcptr state, const arb_t c1, const arb_t c2, slong prec);

/*
 * Working precision in bits for which `digits` digits at time t (in radians of orbit) are expected, with
 * gains near the paper's; where an unstable or stiff motion takes more, a second run at twice that.
 */
slong flow_precision(slong digits, double radians);
slong rk4_precision(slong digits, double radians);

/* Radians up to t, or what few long steps of h cost as if they were radians, whichever is less. */
double rk4_radians(const fmpq_t Omega, const fmpq_t t, const fmpq_t h);

/*
 * Whether the last time is no more radians of orbit away than a flow, or the method, can be followed. What lies
 * further is FLOW_STALLED at once, and the precisions above grow no more.
 */
bool flow_in_reach(const struct flow_request *r);

/* Whether some radius exceeds 2^-bits of the largest coordinate (all in like units), or is not finite. */
bool flow_wide(arb_srcptr state, slong bits);

#endif
