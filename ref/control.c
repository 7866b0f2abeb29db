/*
 * control.c   the charge feedback law and the charges that it commands: Eqs. (18) to (22)
 */
#include "internal.h"

/*
 * Eq. (18)   charge product variation commanded by the feedback law
 *
 *     dQ = m1 m2 L_ref^2 / ((m1 + m2) k_c) (-C1 dL - C2 dL_dot)
 *
 * Given     p        masses [kg], reference distance [m], Coulomb constant [N m^2/C^2]
 *           g        gains C1 [1/s^2], C2 [1/s]
 *           dL       length error [m]           any finite value
 *           dL_dot   its rate [m/s]             any finite value
 * Returns   dQ       [C^2]
 */
double ct_charge_product_variation(struct ct_params p, struct ct_gains g, double dL, double dL_dot)
{
    if (!(POSITIVE(p.k_c, p.m1, p.m2, p.L_ref) && FINITE(g.C1, g.C2, dL, dL_dot)))
        return NAN;
    return reduced_mass(p) * (p.L_ref * p.L_ref) / p.k_c * (-g.C1 * dL - g.C2 * dL_dot);
}

/*
 * Eq. (19)   acceleration of the length error under the feedback law
 *
 *     dL_ddot = -(C1 - 9 Omega^2) dL - C2 dL_dot + 2 Omega L_ref psi_dot
 *
 * Given     p        orbit rate [rad/s], reference distance [m]
 *           g        gains C1 [1/s^2], C2 [1/s]
 *           dL       length error [m]           any finite value
 *           dL_dot   its rate [m/s]             any finite value
 *           psi_dot  yaw rate [rad/s]           any finite value
 * Returns   dL_ddot  [m/s^2]
 */
double ct_closed_loop_acceleration(struct ct_params p, struct ct_gains g, double dL, double dL_dot, double psi_dot)
{
    if (!(POSITIVE(p.Omega, p.L_ref) && FINITE(g.C1, g.C2, dL, dL_dot, psi_dot)))
        return NAN;
    return -(g.C1 - 9 * p.Omega * p.Omega) * dL - g.C2 * dL_dot + 2 * p.Omega * p.L_ref * psi_dot;
}

/*
 * Eq. (21)   charges of the two craft, equal in magnitude
 *
 *     q1 = sqrt(-(Q_ref + dQ)),  q2 = -q1
 *
 * Given     Q_ref    reference charge product [C^2]
 *           dQ       its variation [C^2]           Q_ref + dQ < 0
 * Returned  q        q1 > 0, q2 < 0 [C]
 * Status    CT_OK or CT_DOMAIN
 *
 * Note      (20) asks for q1 q2 = Q_ref + dQ and (22) for opposite signs, which no real charges give where the sum is
 *           not negative. The print takes sqrt(|Q_ref + dQ|) there, and so would attract where the law commands to repel.
 */
int ct_charges(double Q_ref, double dQ, struct ct_charge_pair *q)
{
    if (!(FINITE(Q_ref, dQ) && Q_ref + dQ < 0)) {
        *q = (struct ct_charge_pair){NAN, NAN};
        return CT_DOMAIN;
    }
    q->q1 = sqrt(-(Q_ref + dQ));
    q->q2 = -q->q1;
    return CT_OK;
}

/*
 * Eq. (21), along a motion   charges that the feedback law commands in a state of the two craft
 *
 *     q1, q2 by (21), from Q_ref by (7) at L_ref and dQ by (18) at dL = L - L_ref, L and L_dot from the state by (13)
 *
 * Given     p        the formation
 *           g        gains C1 [1/s^2], C2 [1/s]
 *           s        position [m], off the origin, and velocity [m/s] of craft 1
 * Returned  q        q1 > 0, q2 < 0 [C]
 * Status    CT_OK; CT_DOMAIN also where the law commands the craft to repel each other, or to be neutral
 */
int ct_commanded_charges(struct ct_params p, struct ct_gains g, struct ct_hill_state s, struct ct_charge_pair *q)
{
    const double dL = ct_separation(p, hill_position(s)) - p.L_ref;
    const double dL_dot = ct_separation_rate(p, s);

    return ct_charges(ct_reference_charge_product(p, p.L_ref), ct_charge_product_variation(p, g, dL, dL_dot), q);
}
