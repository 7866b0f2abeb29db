/*
 * attitude.c   the formation as a slender body under the gravity gradient: Eqs. (25) to (39)
 */
#include "internal.h"

/*
 * Eq. (25)   angular velocity of the orbit frame, body components
 *
 *     omega = (-Omega sin(theta), 0, Omega cos(theta))
 *
 * Given     Omega    orbit rate [rad/s]   > 0
 *           theta    pitch [rad]          any finite value
 * Returns   omega    [rad/s]
 */
struct ct_vector ct_orbit_angular_velocity(double Omega, double theta)
{
    if (!(POSITIVE(Omega) && FINITE(theta)))
        return nan_vector();
    return (struct ct_vector){-Omega * sin(theta), 0, Omega * cos(theta)};
}

/*
 * Eq. (26)   angular velocity of the body relative to the orbit frame, body components
 *
 *     omega = (-sin(theta) psi_dot, theta_dot, cos(theta) psi_dot)
 *
 * Given     theta      pitch [rad]           any finite value
 *           psi_dot    yaw rate [rad/s]      any finite value
 *           theta_dot  pitch rate [rad/s]    any finite value
 * Returns   omega      [rad/s]
 */
struct ct_vector ct_relative_angular_velocity(double theta, double psi_dot, double theta_dot)
{
    if (!FINITE(theta, psi_dot, theta_dot))
        return nan_vector();
    return (struct ct_vector){-sin(theta) * psi_dot, theta_dot, cos(theta) * psi_dot};
}

/*
 * Eq. (27)   angular velocity of the body in inertial space, body components
 *
 *     omega = (-sin(theta) psi_dot - Omega sin(theta), theta_dot, cos(theta) psi_dot + Omega cos(theta))
 *
 * Given     Omega      orbit rate [rad/s]    > 0
 *           theta      pitch [rad]           any finite value
 *           psi_dot    yaw rate [rad/s]      any finite value
 *           theta_dot  pitch rate [rad/s]    any finite value
 * Returns   omega      [rad/s]
 */
struct ct_vector ct_angular_velocity(double Omega, double theta, double psi_dot, double theta_dot)
{
    return sum(ct_relative_angular_velocity(theta, psi_dot, theta_dot), ct_orbit_angular_velocity(Omega, theta));
}

/*
 * Eq. (28)   angular velocity of the body in inertial space, to first order
 *
 *     omega = (-Omega theta, theta_dot, psi_dot + Omega)
 *
 * Given     Omega      orbit rate [rad/s]    > 0
 *           theta      pitch [rad]           any finite value
 *           psi_dot    yaw rate [rad/s]      any finite value
 *           theta_dot  pitch rate [rad/s]    any finite value
 * Returns   omega      [rad/s]
 */
struct ct_vector ct_angular_velocity_small_angles(double Omega, double theta, double psi_dot, double theta_dot)
{
    if (!(POSITIVE(Omega) && FINITE(theta, psi_dot, theta_dot)))
        return nan_vector();
    return (struct ct_vector){-Omega * theta, theta_dot, psi_dot + Omega};
}

/*
 * Eq. (29)   angular acceleration of the body in inertial space, to first order
 *
 *     omega_dot = (-Omega theta_dot, theta_ddot, psi_ddot)
 *
 * Given     Omega       orbit rate [rad/s]              > 0
 *           theta_dot   pitch rate [rad/s]              any finite value
 *           theta_ddot  pitch acceleration [rad/s^2]    any finite value
 *           psi_ddot    yaw acceleration [rad/s^2]      any finite value
 * Returns   omega_dot   [rad/s^2]
 */
struct ct_vector ct_angular_acceleration_small_angles(double Omega, double theta_dot, double theta_ddot, double psi_ddot)
{
    if (!(POSITIVE(Omega) && FINITE(theta_dot, theta_ddot, psi_ddot)))
        return nan_vector();
    return (struct ct_vector){-Omega * theta_dot, theta_ddot, psi_ddot};
}

/*
 * Eq. (30)   moment of inertia matrix of the two craft
 *
 *     [I] = -m1 [r1~][r1~] - m2 [r2~][r2~],   -[r~][r~] = |r|^2 [1] - r r^T
 *
 * Given     p        masses [kg]
 *           r1, r2   positions from the centre of mass [m]
 * Returns   [I]      [kg m^2]   symmetric
 *
 * Note      The print has m1 in the second term too, which is right for equal masses alone.
 */
struct ct_matrix ct_inertia_matrix(struct ct_params p, struct ct_vector r1, struct ct_vector r2)
{
    if (!(POSITIVE(p.m1, p.m2) && finite_vector(r1) && finite_vector(r2)))
        return (struct ct_matrix){{{NAN, NAN, NAN}, {NAN, NAN, NAN}, {NAN, NAN, NAN}}};

    const double I_11 = p.m1 * (r1.y * r1.y + r1.z * r1.z) + p.m2 * (r2.y * r2.y + r2.z * r2.z);
    const double I_22 = p.m1 * (r1.x * r1.x + r1.z * r1.z) + p.m2 * (r2.x * r2.x + r2.z * r2.z);
    const double I_33 = p.m1 * (r1.x * r1.x + r1.y * r1.y) + p.m2 * (r2.x * r2.x + r2.y * r2.y);
    const double I_12 = -p.m1 * r1.x * r1.y - p.m2 * r2.x * r2.y;
    const double I_13 = -p.m1 * r1.x * r1.z - p.m2 * r2.x * r2.z;
    const double I_23 = -p.m1 * r1.y * r1.z - p.m2 * r2.y * r2.z;

    return (struct ct_matrix){{{I_11, I_12, I_13}, {I_12, I_22, I_23}, {I_13, I_23, I_33}}};
}

/*
 * Eq. (32)   moment of inertia of the tether about an axis across it
 *
 *     I = m1 m2/(m1 + m2) L^2
 *
 * Given     p        masses [kg]
 *           L        distance of the craft [m]   > 0
 * Returns   I        [kg m^2]
 */
double ct_inertia(struct ct_params p, double L)
{
    return POSITIVE(p.m1, p.m2, L) ? reduced_mass(p) * (L * L) : NAN;
}

/*
 * Eq. (34)   rate of the moment of inertia
 *
 *     I_dot = 2 m1 m2/(m1 + m2) L L_dot
 *
 * Given     p        masses [kg]
 *           L        distance of the craft [m]   > 0
 *           L_dot    its rate [m/s]              any finite value
 * Returns   I_dot    [kg m^2/s]
 */
double ct_inertia_rate(struct ct_params p, double L, double L_dot)
{
    return POSITIVE(p.m1, p.m2, L) && FINITE(L_dot) ? 2 * reduced_mass(p) * L * L_dot : NAN;
}

/*
 * Eq. (36)   position of the formation's centre from the planet's, body components
 *
 *     (R_c1, R_c2, R_c3) = (cos(theta) cos(psi), -sin(psi), sin(theta) cos(psi)) R_c
 *
 * Given     R_c      orbit radius [m]   > 0
 *           psi      yaw [rad]          any finite value
 *           theta    pitch [rad]        any finite value
 * Returns   (R_c1, R_c2, R_c3)          [m]
 */
struct ct_vector ct_centre_position(double R_c, double psi, double theta)
{
    if (!(POSITIVE(R_c) && FINITE(psi, theta)))
        return nan_vector();
    return (struct ct_vector){cos(theta) * cos(psi) * R_c, -sin(psi) * R_c, sin(theta) * cos(psi) * R_c};
}

/*
 * Eq. (37)   gravity gradient torque on the tether, body components
 *
 *     L_G = 3 GM/R_c^5 (R_c2 R_c3 (I_33 - I_22), R_c1 R_c3 (I_11 - I_33), R_c1 R_c2 (I_22 - I_11))
 *
 *     with the inertia (31) of a slender body, I_11 = 0 and I_22 = I_33 = I
 *
 * Given     GM       gravitational parameter [m^3/s^2]                        > 0
 *           R_c      centre of mass from the planet's centre [m], its norm    > 0
 *           inertia  I [kg m^2]                                               >= 0
 * Returns   L_G      [N m]
 *
 * Note      Written with direction cosines, for R_c^5 leaves the range of double where the torque does not.
 */
struct ct_vector ct_gravity_gradient(double GM, struct ct_vector R_c, double inertia)
{
    const double R = norm(R_c);

    if (!(POSITIVE(GM) && finite_vector(R_c) && R > 0 && FINITE(inertia) && inertia >= 0))
        return nan_vector();
    const double torque = 3 * GM / R / R / R * inertia;
    return (struct ct_vector){0, -torque * (R_c.x / R) * (R_c.z / R), torque * (R_c.x / R) * (R_c.y / R)};
}

/*
 * Eq. (38)   orbit rate at a radius: Kepler's third law
 *
 *     GM/R_c^3 = Omega^2
 *
 * Given     GM       gravitational parameter [m^3/s^2]   > 0
 *           R_c      orbit radius [m]                    > 0
 * Returns   Omega    [rad/s]
 *
 * Note      The print has 3 GM/R_c^3 = Omega^2, against (2), (39) and Kepler.
 */
double ct_orbit_rate(double GM, double R_c)
{
    return POSITIVE(GM, R_c) ? sqrt(GM / R_c) / R_c : NAN;
}

/*
 * Eq. (39)   gravity gradient torque on the tether, body components, to first order in the angles
 *
 *     L_G = 3 Omega^2 (0, -I theta, -I psi)
 *
 * Given     Omega    orbit rate [rad/s]             > 0
 *           inertia  I [kg m^2]                     >= 0
 *           psi      yaw [rad]                      any finite value
 *           theta    pitch [rad]                    any finite value
 * Returns   L_G      [N m]
 */
struct ct_vector ct_gravity_gradient_small_angles(double Omega, double inertia, double psi, double theta)
{
    if (!(POSITIVE(Omega) && FINITE(inertia, psi, theta) && inertia >= 0))
        return nan_vector();
    const double stiffness = 3 * Omega * Omega * inertia;
    return (struct ct_vector){0, -stiffness * theta, -stiffness * psi};
}
