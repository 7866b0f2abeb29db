/*
 * What pitch leaves in the nonlinear motion for ever, in closed form, for any gains.
 *
 * The linear model keeps pitch as a free oscillation z = theta - i theta_dot/(2 Omega), z' = 2 i z in radians of
 * orbit, and brings yaw and length to rest. In the nonlinear motion they come to follow z, whatever the start: with
 * c1 = C1/Omega^2, c2 = C2/Omega and
 *
 *     B = -2 i (c1 - 9 + 4 i c2) / (13 c1 - 261 + 52 i c2)     A = (2 - 13 i B)/8     T = (51 i B - 8)/96
 *
 *     psi = Re(B z^2)     dL/L_ref = Re(A z^2)     theta = Re(z + T z^3)     z' = 2 i z + 9/4 B |z|^2 z
 *
 * up to terms of the fourth order in z (psi, dL) and of the fifth (theta, z'). So the amplitude a = |z| and the phase
 * 2 tau + phi of pitch obey the slow law a' = -k a^3, phi' = s a^2 with -k + i s = 9/4 B:
 *
 *     k = 2592 c2/N     s = -9/2 ((c1 - 9)(13 c1 - 261) + 208 c2^2)/N     N = (13 c1 - 261)^2 + (52 c2)^2
 *
 * Pitch is damped by a reference length that moves with it: the law (18) holds the length to L_ref (1 + sigma),
 *
 *     sigma = Re(S z^2) = S_re (theta^2 - theta_dot^2/(4 Omega^2)) + S_im theta theta_dot/Omega
 *
 * in its first term alone. By the step pitch_law, of which second_order is the case S = 0, all of the above holds with other A
 * and B, and k = 18/13 Im A: the length in quadrature damps, and nothing else of it.
 *
 * That is exact but for (A1) the fourth order of psi and dL, (A2) the fifth of theta and z', and in the slow law (A3) what these make
 * in a time 1/a^2: each is observed, tests/claims/test_convergence.c and the claims forced-response-flow, slow-law-orders.
 *
 * The formulas stand once, in paper/derivations.yaml: x1 and y1 hold psi and dL and are even in z, z1 holds theta and is odd,
 * so that what is left of (3) is of the fourth order in the first two, of the fifth in the last. The program of pitch_law runs
 * in balls for their values.
 */
#ifndef CT_SECOND_ORDER_H
#define CT_SECOND_ORDER_H

#include "motion/flow.h"
#include "motion/taylor.h"
#include "proof/derivation.h"

struct second_order {
    struct machine machine; /* of the step, in balls, in radians of orbit and units of L_ref */
};

/* `d` has the step. S is 0, the law (18) as it is. */
void second_order_init(struct second_order *o, const struct derivations *d, const arb_t c1, const arb_t c2, slong prec);
void second_order_clear(struct second_order *o);

/* The S by which the length swings in quadrature alone, A = i swing/a^2. */
void second_order_swing(struct second_order *o, const arb_t swing, const arb_t a);

/* By name: B_re B_im A_re A_im T_re T_im, S_re S_im, c1 c2, and k and s as decay and shift. */
arb_ptr second_order_get(const struct second_order *o, const char *name);

/* psi theta dL and their rates at z, the first six numbers of a sample; */
void second_order_at(arb_ptr sample, struct second_order *o, const arb_t z_re, const arb_t z_im);

/* ... and at the z that was a, tau radians of orbit before. */
void second_order_after(arb_ptr sample, struct second_order *o, const arb_t a, const arb_t tau);

/* a(tau)/a(0) and phi(tau) - phi(0): (1 + 2 k a^2 tau)^(-1/2), s/(2 k) log(1 + 2 k a^2 tau) */
void slow_law(arb_t ratio, arb_t shift, const struct second_order *o, const arb_t a, const arb_t tau);

/* The nonlinear closed loop with the reference length so. */
struct moved_loop {
    struct term terms[JET_MOST];
    struct system system;
    arb_ptr constants;
};
void moved_loop_init(struct moved_loop *l, const struct second_order *o);
void moved_loop_clear(struct moved_loop *l);

/* sigma of a sample, sin(theta) in place of theta, as the loop has it. */
void moved_reference(arb_t sigma, const struct second_order *o, arb_srcptr sample);

#endif
