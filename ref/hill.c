/*
 * hill.c   charged craft in the rotating Hill frame, and the formation that rests there: Eqs. (2) to (7)
 */
#include "internal.h"

/* What the orbit does to a craft: the left-hand sides of (2) and (3), solved for the second derivative. */
static struct ct_vector orbital_acceleration(double Omega, struct ct_vector r, struct ct_vector v)
{
    return (struct ct_vector){
        2 * Omega * v.y + 3 * Omega * Omega * r.x,
        -2 * Omega * v.x,
        -Omega * Omega * r.z,
    };
}

/* Finite craft of positive mass, no two of them in one place. */
static bool valid_formation(size_t N, const struct ct_craft *craft)
{
    for (size_t i = 0; i < N; i++) {
        if (!(POSITIVE(craft[i].m) && FINITE(craft[i].q) && finite_vector(craft[i].position) &&
              finite_vector(craft[i].velocity)))
            return false;
        for (size_t j = 0; j < i; j++)
            if (!(norm(difference(craft[i].position, craft[j].position)) > 0))
                return false;
    }
    return true;
}

/*
 * Eqs. (2a)-(2c)   accelerations of N charged craft in the Hill frame, the plasma shielding their charges
 *
 *     x_i_ddot =  2 Omega y_i_dot + 3 Omega^2 x_i + k_c/m_i sum_j q_i q_j exp(-d_ij/lambda_d) (x_i - x_j) / d_ij^3
 *     y_i_ddot = -2 Omega x_i_dot                 + k_c/m_i sum_j q_i q_j exp(-d_ij/lambda_d) (y_i - y_j) / d_ij^3
 *     z_i_ddot = -Omega^2 z_i                     + k_c/m_i sum_j q_i q_j exp(-d_ij/lambda_d) (z_i - z_j) / d_ij^3
 *
 *     over all j but i, with d_ij = |r_i - r_j|
 *
 * Given     Omega         orbit rate [rad/s]               > 0
 *           k_c           Coulomb constant [N m^2/C^2]     > 0
 *           lambda_d      Debye length [m]                 > 0, INFINITY where nothing shields
 *           N             number of craft
 *           craft         N masses [kg] > 0, charges [C], positions [m], velocities [m/s]; no two in one place
 * Returned  acceleration  N of them [m/s^2]
 * Status    CT_OK or CT_DOMAIN
 *
 * Note      The force is the printed one. The gradient of the shielded potential has a further factor (1 + d/lambda_d).
 */
int ct_formation_acceleration(double Omega, double k_c, double lambda_d, size_t N, const struct ct_craft *craft,
                              struct ct_vector *acceleration)
{
    if (!(POSITIVE(Omega, k_c) && lambda_d > 0 && valid_formation(N, craft))) {
        for (size_t i = 0; i < N; i++)
            acceleration[i] = nan_vector();
        return CT_DOMAIN;
    }
    for (size_t i = 0; i < N; i++) {
        struct ct_vector a = orbital_acceleration(Omega, craft[i].position, craft[i].velocity);
        for (size_t j = 0; j < N; j++) {
            if (j == i)
                continue;
            const struct ct_vector r = difference(craft[i].position, craft[j].position);
            const double d = norm(r);
            const double force = k_c * craft[i].q * craft[j].q * exp(-d / lambda_d) / (d * d * d);
            a = sum(a, multiple(force / craft[i].m, r));
        }
        acceleration[i] = a;
    }
    return CT_OK;
}

/*
 * Eqs. (3a)-(3c)   acceleration of craft 1 of two, unshielded, in the Hill frame
 *
 *     x1_ddot =  2 Omega y1_dot + 3 Omega^2 x1 + k_c/m1 (x1 - x2)/L^3 Q
 *     y1_ddot = -2 Omega x1_dot                + k_c/m1 (y1 - y2)/L^3 Q
 *     z1_ddot = -Omega^2 z1                    + k_c/m1 (z1 - z2)/L^3 Q
 *
 *     with craft 2 from (4) and L from (12)
 *
 * Given     p        orbit rate [rad/s], Coulomb constant [N m^2/C^2], masses [kg]
 *           s        position [m], off the origin, and velocity [m/s] of craft 1
 *           Q        charge product q1 q2 [C^2]   any finite value; the craft attract each other where it is negative
 * Returns   (x1_ddot, y1_ddot, z1_ddot)           [m/s^2]
 */
struct ct_vector ct_hill_acceleration(struct ct_params p, struct ct_hill_state s, double Q)
{
    const struct ct_vector r1 = hill_position(s);
    const struct ct_vector r2 = ct_second_position(p, r1);
    const double L = distance(r1, r2);

    if (!(POSITIVE(p.Omega, p.k_c, p.m1, p.m2) && finite_hill_state(s) && FINITE(Q) && L > 0))
        return nan_vector();
    const struct ct_vector coulomb = multiple(p.k_c / p.m1 * Q / (L * L * L), difference(r1, r2));
    return sum(orbital_acceleration(p.Omega, r1, hill_velocity(s)), coulomb);
}

/*
 * Eq. (4)   position of craft 2, from the centre of mass in the origin
 *
 *     m1 r1 + m2 r2 = 0
 *
 * Given     p        masses [kg]
 *           r1       position of craft 1 [m]
 * Returns   (x2, y2, z2)   [m]
 */
struct ct_vector ct_second_position(struct ct_params p, struct ct_vector r1)
{
    if (!(POSITIVE(p.m1, p.m2) && finite_vector(r1)))
        return nan_vector();
    return multiple(-p.m1 / p.m2, r1);
}

/*
 * Eqs. (5c)-(5d)   places of the two craft at rest on the orbit radius
 *
 *     x1 = m2/(m1 + m2) L,  x2 = -m1/(m1 + m2) L
 *
 * Given     p        masses [kg]
 *           L        distance of the craft [m]   > 0
 * Returns   x1, x2   [m]
 */
struct ct_static_places ct_static_positions(struct ct_params p, double L)
{
    if (!POSITIVE(p.m1, p.m2, L))
        return (struct ct_static_places){NAN, NAN};
    return (struct ct_static_places){p.m2 / (p.m1 + p.m2) * L, -p.m1 / (p.m1 + p.m2) * L};
}

/*
 * Eq. (7)   charge product that holds the formation at rest
 *
 *     Q_ref = -3 Omega^2 L^3/k_c m1 m2/(m1 + m2)
 *
 * Given     p        orbit rate [rad/s], Coulomb constant [N m^2/C^2], masses [kg]
 *           L        distance of the craft [m]   > 0
 * Returns   Q_ref    [C^2]                       < 0: the charges attract each other
 */
double ct_reference_charge_product(struct ct_params p, double L)
{
    if (!POSITIVE(p.Omega, p.k_c, p.m1, p.m2, L))
        return NAN;
    return -3 * p.Omega * p.Omega * (L * L * L) / p.k_c * reduced_mass(p);
}
