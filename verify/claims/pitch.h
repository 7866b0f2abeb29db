/*
 * Pitch damped by a reference length that moves with it: the law (18) holds the length to L_ref (1 + sigma),
 *
 *     sigma = Re(S z^2) = S_re (theta^2 - theta_dot^2/(4 Omega^2)) + S_im theta theta_dot/Omega
 *
 * in its first term alone, z = theta - i theta_dot/(2 Omega). By the step pitch_law a small pitch has, in radians of orbit,
 * z' = 2 i z + 9/4 B |z|^2 z, so that its amplitude a = |z| obeys a' = -k a^3, k = 18/13 Im A, where
 * dL/L_ref = Re(A z^2): the length in quadrature damps, and nothing else of it. Here it is all in quadrature, A = i swing/a^2
 * at the pitch a that a law is made for.
 */
#ifndef CT_PITCH_H
#define CT_PITCH_H

#include "motion/flow.h"
#include "proof/derivation.h"

struct pitch_law {
    const struct derivations *steps;
    arb_ptr c1, c2, S_re, S_im, a, k;
};

/* `swing` of the length over L_ref at pitch a, in rad; c1 = C1/Omega^2, c2 = C2/Omega. */
void pitch_law_init(struct pitch_law *l, const struct derivations *d, const arb_t c1, const arb_t c2, const arb_t swing,
                    const arb_t a, slong prec);
void pitch_law_clear(struct pitch_law *l);

/* a(tau)/a by the averaged law. */
void pitch_law_ratio(arb_t ratio, const struct pitch_law *l, const arb_t tau, slong prec);

/*
 * The nonlinear motion from that pitch, and what it forces on length and yaw: at each time, in radians of orbit, FLOW_STATE
 * numbers in the units of sampling.h.
 */
enum flow_status pitch_law_follow(arb_ptr states, const struct pitch_law *l, const fmpq *times, slong count, slong digits);

/* Of such a state sqrt(theta^2 + theta'^2/4), dL/L_ref, and the charge product over Q_ref less 1. */
void pitch_law_numbers(arb_t amplitude, arb_t eta, arb_t charge, const struct pitch_law *l, arb_srcptr state, slong prec);

#endif
