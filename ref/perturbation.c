/*
 * perturbation.c   the tether's attitude, its length, and how they move: Eqs. (9) to (17)
 */
#include "internal.h"

/* Distance of craft 1 from the centre of mass, Eq. (8), or its rate. */
static double arm(struct ct_params p, double L)
{
    return p.m2 / (p.m1 + p.m2) * L;
}

/* The inverse of arm: distance of the craft, given that of craft 1 from the centre of mass. */
static double length(struct ct_params p, double r)
{
    return (p.m1 + p.m2) / p.m2 * r;
}

/* [BO]^T b: from body components to components in the orbit frame. */
static struct ct_vector in_orbit_frame(struct ct_matrix BO, struct ct_vector b)
{
    return (struct ct_vector){
        BO.e[0][0] * b.x + BO.e[1][0] * b.y + BO.e[2][0] * b.z,
        BO.e[0][1] * b.x + BO.e[1][1] * b.y + BO.e[2][1] * b.z,
        BO.e[0][2] * b.x + BO.e[1][2] * b.y + BO.e[2][2] * b.z,
    };
}

/*
 * Eq. (9)   direction cosines from the orbit frame to the body frame
 *
 *              cos(theta) cos(psi)   cos(theta) sin(psi)   -sin(theta)
 *     [BO] =       -sin(psi)              cos(psi)              0
 *              sin(theta) cos(psi)   sin(theta) sin(psi)    cos(theta)
 *
 * Given     psi      yaw [rad]      any finite value
 *           theta    pitch [rad]    any finite value
 * Returns   [BO]     by rows
 */
struct ct_matrix ct_direction_cosines(double psi, double theta)
{
    if (!FINITE(psi, theta))
        return (struct ct_matrix){{{NAN, NAN, NAN}, {NAN, NAN, NAN}, {NAN, NAN, NAN}}};
    return (struct ct_matrix){{
        {cos(theta) * cos(psi), cos(theta) * sin(psi), -sin(theta)},
        {-sin(psi), cos(psi), 0},
        {sin(theta) * cos(psi), sin(theta) * sin(psi), cos(theta)},
    }};
}

/*
 * Eq. (10)   position of craft 1 in the orbit frame
 *
 *     (x1, y1, z1) = [BO]^T (m2/(m1 + m2) L, 0, 0)
 *
 * Given     p        masses [kg]
 *           c        distance of the craft [m] > 0, yaw and pitch [rad]
 * Returns   (x1, y1, z1)   [m]
 */
struct ct_vector ct_position(struct ct_params p, struct ct_spherical c)
{
    if (!(POSITIVE(p.m1, p.m2, c.L) && FINITE(c.psi, c.theta)))
        return nan_vector();
    return in_orbit_frame(ct_direction_cosines(c.psi, c.theta), (struct ct_vector){arm(p, c.L), 0, 0});
}

/*
 * Eq. (10), small angles   position of craft 1 in the orbit frame, to first order in the angles
 *
 *     (x1, y1, z1) = m2/(m1 + m2) L (1, psi, -theta)
 *
 * Given     p        masses [kg]
 *           c        distance of the craft [m] > 0, yaw and pitch [rad]
 * Returns   (x1, y1, z1)   [m]
 */
struct ct_vector ct_position_small_angles(struct ct_params p, struct ct_spherical c)
{
    if (!(POSITIVE(p.m1, p.m2, c.L) && FINITE(c.psi, c.theta)))
        return nan_vector();
    const double r = arm(p, c.L);
    return (struct ct_vector){r, r * c.psi, -r * c.theta};
}

/*
 * Eq. (10), inverse   distance and angles from the position of craft 1
 *
 *     L = (m1 + m2)/m2 |r1|,  psi = atan2(y1, x1),  theta = atan2(-z1, sqrt(x1^2 + y1^2))
 *
 * Given     p        masses [kg]
 *           r1       position of craft 1 [m]   off the origin
 * Returns   L [m], psi [rad] in (-pi, pi], theta [rad] in [-pi/2, pi/2]
 *
 * Note      A zero counts as positive whatever its sign, and on the z axis, where every yaw is right, psi = 0. It is the
 *           added zero that turns -0 into +0.
 */
struct ct_spherical ct_spherical_coordinates(struct ct_params p, struct ct_vector r1)
{
    const double L = ct_separation(p, r1);

    if (!(L > 0))
        return (struct ct_spherical){NAN, NAN, NAN};
    return (struct ct_spherical){
        .L = L,
        .psi = atan2(r1.y + 0.0, r1.x + 0.0),
        .theta = atan2(0.0 - r1.z, hypot(r1.x, r1.y)),
    };
}

/*
 * Eq. (11), exact   velocity of craft 1 in the orbit frame: the time derivative of (10)
 *
 *     (x1_dot, y1_dot, z1_dot) = m2/(m1 + m2) [BO]^T (L_dot, L cos(theta) psi_dot, -L theta_dot)
 *
 * Given     p        masses [kg]
 *           c        distance of the craft [m] > 0, yaw and pitch [rad]
 *           c_dot    their rates [m/s], [rad/s], [rad/s]
 * Returns   (x1_dot, y1_dot, z1_dot)   [m/s]
 *
 * Note      In the body frame the velocity is r_dot b1 + omega x r b1, with omega from (26).
 */
struct ct_vector ct_velocity(struct ct_params p, struct ct_spherical c, struct ct_spherical_rate c_dot)
{
    if (!(POSITIVE(p.m1, p.m2, c.L) && FINITE(c.psi, c.theta, c_dot.L_dot, c_dot.psi_dot, c_dot.theta_dot)))
        return nan_vector();
    const double r = arm(p, c.L);
    const struct ct_vector in_body_frame = {
        arm(p, c_dot.L_dot),
        r * cos(c.theta) * c_dot.psi_dot,
        -r * c_dot.theta_dot,
    };
    return in_orbit_frame(ct_direction_cosines(c.psi, c.theta), in_body_frame);
}

/*
 * Eq. (11)   velocity of craft 1 in the orbit frame, to first order in the angles
 *
 *     x1_dot = m2/(m1 + m2) L_dot
 *     y1_dot = m2/(m1 + m2) ( psi L_dot + psi_dot L)
 *     z1_dot = m2/(m1 + m2) (-theta L_dot - theta_dot L)
 *
 * Given     p        masses [kg]
 *           c        distance of the craft [m] > 0, yaw and pitch [rad]
 *           c_dot    their rates [m/s], [rad/s], [rad/s]
 * Returns   (x1_dot, y1_dot, z1_dot)   [m/s]
 */
struct ct_vector ct_velocity_small_angles(struct ct_params p, struct ct_spherical c, struct ct_spherical_rate c_dot)
{
    if (!(POSITIVE(p.m1, p.m2, c.L) && FINITE(c.psi, c.theta, c_dot.L_dot, c_dot.psi_dot, c_dot.theta_dot)))
        return nan_vector();
    return (struct ct_vector){
        arm(p, c_dot.L_dot),
        arm(p, c.psi * c_dot.L_dot + c_dot.psi_dot * c.L),
        arm(p, -c.theta * c_dot.L_dot - c_dot.theta_dot * c.L),
    };
}

/*
 * Eq. (12)   distance of the craft
 *
 *     L^2 = (x1 - x2)^2 + (y1 - y2)^2 + (z1 - z2)^2
 *
 * Given     r1, r2   positions [m]   apart
 * Returns   L        [m]
 */
double ct_distance(struct ct_vector r1, struct ct_vector r2)
{
    return distance(r1, r2);
}

/*
 * Eq. (13)   distance of the craft, given craft 1 and the centre of mass in the origin
 *
 *     L^2 = ((m1 + m2)/m2)^2 (x1^2 + y1^2 + z1^2)
 *
 * Given     p        masses [kg]
 *           r1       position of craft 1 [m]   off the origin
 * Returns   L        [m]
 */
double ct_separation(struct ct_params p, struct ct_vector r1)
{
    const double r = norm(r1);

    return POSITIVE(p.m1, p.m2) && finite_vector(r1) && r > 0 ? length(p, r) : NAN;
}

/*
 * Eq. (13), rate   time derivative of the distance of the craft
 *
 *     L L_dot = ((m1 + m2)/m2)^2 (x1 x1_dot + y1 y1_dot + z1 z1_dot)
 *
 * Given     p        masses [kg]
 *           s        position [m], off the origin, and velocity [m/s] of craft 1
 * Returns   L_dot    [m/s]
 */
double ct_separation_rate(struct ct_params p, struct ct_hill_state s)
{
    const struct ct_vector r1 = hill_position(s);
    const double r = norm(r1);

    if (!(POSITIVE(p.m1, p.m2) && finite_hill_state(s) && r > 0))
        return NAN;
    return length(p, dot(r1, hill_velocity(s)) / r);
}

/*
 * State of craft 1 from that of the tether, by (10) and the exact (11)
 *
 * Given     p        masses [kg], reference distance [m]
 *           s        yaw and pitch [rad], length error [m] > -L_ref, their rates [rad/s], [m/s]
 * Returns   position [m] and velocity [m/s] of craft 1 in the Hill frame
 */
struct ct_hill_state ct_hill_state_of_tether(struct ct_params p, struct ct_tether_state s)
{
    const struct ct_spherical c = {p.L_ref + s.dL, s.psi, s.theta};
    const struct ct_spherical_rate c_dot = {s.dL_dot, s.psi_dot, s.theta_dot};
    const struct ct_vector r1 = ct_position(p, c), v1 = ct_velocity(p, c, c_dot);

    if (!(POSITIVE(p.L_ref) && finite_vector(v1)))
        return (struct ct_hill_state){NAN, NAN, NAN, NAN, NAN, NAN};
    return (struct ct_hill_state){r1.x, r1.y, r1.z, v1.x, v1.y, v1.z};
}

/*
 * State of the tether from that of craft 1: the inverse of (10), and its rate
 *
 *     psi_dot = (x1 y1_dot - y1 x1_dot)/rho^2,  theta_dot = (z1 rho_dot - rho z1_dot)/r^2,  rho^2 = x1^2 + y1^2
 *
 * Given     p        masses [kg], reference distance [m]
 *           s        position [m], off the z axis, where no yaw is, and velocity [m/s] of craft 1 in the Hill frame
 * Returns   psi [rad] in (-pi, pi], theta [rad] in [-pi/2, pi/2], dL = L - L_ref [m], and their rates [rad/s], [m/s]
 */
struct ct_tether_state ct_tether_state_of_hill(struct ct_params p, struct ct_hill_state s)
{
    const struct ct_vector r1 = hill_position(s);
    const double rho = hypot(r1.x, r1.y), r = norm(r1);

    if (!(POSITIVE(p.m1, p.m2, p.L_ref) && finite_hill_state(s) && rho > 0))
        return (struct ct_tether_state){NAN, NAN, NAN, NAN, NAN, NAN};
    const struct ct_spherical c = ct_spherical_coordinates(p, r1);
    const double rho_dot = r1.x / rho * s.x1_dot + r1.y / rho * s.y1_dot;
    return (struct ct_tether_state){
        .psi = c.psi,
        .theta = c.theta,
        .dL = c.L - p.L_ref,
        .psi_dot = (r1.x / rho * s.y1_dot - r1.y / rho * s.x1_dot) / rho,
        .theta_dot = (r1.z / r * rho_dot - rho / r * s.z1_dot) / r,
        .dL_dot = ct_separation_rate(p, s),
    };
}

/*
 * Eq. (14)   acceleration of the distance of the craft, all angles
 *
 *     L_dot^2 + L L_ddot = ((m1 + m2)/m2)^2 (v1 . v1 + r1 . a1)   with a1 from (3), solved for L_ddot
 *
 * Given     p        orbit rate [rad/s], Coulomb constant [N m^2/C^2], masses [kg]
 *           s        position [m], off the origin, and velocity [m/s] of craft 1
 *           Q        charge product q1 q2 [C^2]   any finite value
 * Returns   L_ddot   [m/s^2]
 *
 * Note      Where the craft move along their own line, v1 . v1 and L_dot^2 cancel. Lagrange's identity
 *           v1 . v1 - (r1 . v1)^2/r^2 = |r1 x v1|^2/r^2 takes their difference without loss.
 */
double ct_separation_acceleration(struct ct_params p, struct ct_hill_state s, double Q)
{
    const struct ct_vector a1 = ct_hill_acceleration(p, s, Q), r1 = hill_position(s), v1 = hill_velocity(s);
    const struct ct_vector r1_cross_v1 = {
        r1.y * v1.z - r1.z * v1.y,
        r1.z * v1.x - r1.x * v1.z,
        r1.x * v1.y - r1.y * v1.x,
    };
    const double r = norm(r1);
    const double v_across = norm(r1_cross_v1) / r;

    return length(p, v_across * v_across / r + dot(r1, a1) / r);
}

/*
 * Eq. (15)   acceleration of the distance of the craft, to first order in the angles
 *
 *     L_ddot = (2 Omega psi_dot + 3 Omega^2) L + k_c/m1 Q/L^2 (m1 + m2)/m2
 *
 * Given     p        orbit rate [rad/s], Coulomb constant [N m^2/C^2], masses [kg]
 *           L        distance of the craft [m]      > 0
 *           psi_dot  yaw rate [rad/s]               any finite value
 *           Q        charge product q1 q2 [C^2]     any finite value
 * Returns   L_ddot   [m/s^2]
 */
double ct_separation_acceleration_small_angles(struct ct_params p, double L, double psi_dot, double Q)
{
    if (!(POSITIVE(p.Omega, p.k_c, p.m1, p.m2, L) && FINITE(psi_dot, Q)))
        return NAN;
    return (2 * p.Omega * psi_dot + 3 * p.Omega * p.Omega) * L + p.k_c * Q / (L * L) / reduced_mass(p);
}

/*
 * Eq. (17)   acceleration of the length error, to first order in the errors
 *
 *     dL_ddot = 2 Omega L_ref psi_dot + 9 Omega^2 dL + k_c/m1 1/L_ref^2 (m1 + m2)/m2 dQ
 *
 * Given     p        orbit rate [rad/s], Coulomb constant [N m^2/C^2], masses [kg], reference distance [m]
 *           psi_dot  yaw rate [rad/s]                    any finite value
 *           dL       length error L - L_ref [m]          any finite value
 *           dQ       charge product error Q - Q_ref [C^2]   any finite value
 * Returns   dL_ddot  [m/s^2]
 */
double ct_length_error_acceleration(struct ct_params p, double psi_dot, double dL, double dQ)
{
    if (!(POSITIVE(p.Omega, p.k_c, p.m1, p.m2, p.L_ref) && FINITE(psi_dot, dL, dQ)))
        return NAN;
    return 2 * p.Omega * p.L_ref * psi_dot + 9 * p.Omega * p.Omega * dL +
           p.k_c * dQ / (p.L_ref * p.L_ref) / reduced_mass(p);
}
