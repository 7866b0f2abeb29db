#include "evaluate/reference.h"

#include <stddef.h>
#include <string.h>

#include "coulombtether.h"

static const double tolerance = 1e-14; /* of the adaptive integrator: what double can do */

/* ---- parts of input and output lists ---- */

static struct ct_vector vector(const double *in)
{
    return (struct ct_vector){in[0], in[1], in[2]};
}

static void put_vector(double *out, struct ct_vector v)
{
    out[0] = v.x;
    out[1] = v.y;
    out[2] = v.z;
}

static struct ct_params masses(const double *in)
{
    return (struct ct_params){.m1 = in[0], .m2 = in[1]};
}

/* Omega k_c m1 m2 */
static struct ct_params pair(const double *in)
{
    return (struct ct_params){.Omega = in[0], .k_c = in[1], .m1 = in[2], .m2 = in[3]};
}

/* Omega k_c m1 m2 L_ref */
static struct ct_params whole(const double *in)
{
    return (struct ct_params){in[0], in[1], in[2], in[3], in[4]};
}

/* Omega L_ref */
static struct ct_params orbit(const double *in)
{
    return (struct ct_params){.Omega = in[0], .L_ref = in[1]};
}

/* C1 C2 */
static struct ct_gains gains(const double *in)
{
    return (struct ct_gains){in[0], in[1]};
}

static struct ct_hill_state hill_state(const double *in)
{
    return (struct ct_hill_state){in[0], in[1], in[2], in[3], in[4], in[5]};
}

static struct ct_spherical spherical(const double *in)
{
    return (struct ct_spherical){in[0], in[1], in[2]};
}

static struct ct_spherical_rate spherical_rate(const double *in)
{
    return (struct ct_spherical_rate){in[0], in[1], in[2]};
}

/* ---- an operation each ---- */

/* One number, the three components of a vector, or members of a struct r, that a function of ref/ gives. */
#define NUMBER(id, ...) static void id(const double *in, double *out) { out[0] = (__VA_ARGS__); }
#define TRIPLE(id, value) static void id(const double *in, double *out) { put_vector(out, value); }
#define STRUCT(id, type, value, ...) \
    static void id(const double *in, double *out) \
    { \
        const struct type r = value; \
        const double members[] = {__VA_ARGS__}; \
        memcpy(out, members, sizeof members); \
    }

static void eq02(const double *in, double *out)
{
    struct ct_craft craft[3];
    struct ct_vector acceleration[3];
    for (int i = 0; i < 3; i++) {
        const double *c = in + 3 + 8 * i;
        craft[i] = (struct ct_craft){c[0], c[1], vector(c + 2), vector(c + 5)};
    }
    ct_formation_acceleration(in[0], in[1], in[2], 3, craft, acceleration);
    for (int i = 0; i < 3; i++)
        put_vector(out + 3 * i, acceleration[i]);
}

TRIPLE(eq03, ct_hill_acceleration(pair(in), hill_state(in + 5), in[4]))
TRIPLE(eq04, ct_second_position(masses(in), vector(in + 2)))
STRUCT(eq05, ct_static_places, ct_static_positions(masses(in), in[2]), r.x1, r.x2)
NUMBER(eq07, ct_reference_charge_product(pair(in), in[4]))

static void eq09(const double *in, double *out)
{
    const struct ct_matrix BO = ct_direction_cosines(in[0], in[1]);
    for (int i = 0; i < 9; i++)
        out[i] = BO.e[i / 3][i % 3];
}

TRIPLE(eq10, ct_position(masses(in), spherical(in + 2)))
TRIPLE(eq10lin, ct_position_small_angles(masses(in), spherical(in + 2)))
STRUCT(eq10inv, ct_spherical, ct_spherical_coordinates(masses(in), vector(in + 2)), r.L, r.psi, r.theta)
TRIPLE(eq11exact, ct_velocity(masses(in), spherical(in + 2), spherical_rate(in + 5)))
TRIPLE(eq11, ct_velocity_small_angles(masses(in), spherical(in + 2), spherical_rate(in + 5)))
NUMBER(eq12, ct_distance(vector(in), vector(in + 3)))
NUMBER(eq13, ct_separation(masses(in), vector(in + 2)))
NUMBER(eq14, ct_separation_acceleration(pair(in), hill_state(in + 5), in[4]))
NUMBER(eq15, ct_separation_acceleration_small_angles(pair(in), in[4], in[5], in[6]))
NUMBER(eq17, ct_length_error_acceleration(whole(in), in[5], in[6], in[7]))
NUMBER(eq18, ct_charge_product_variation((struct ct_params){0.0, in[0], in[1], in[2], in[3]}, gains(in + 4), in[6], in[7]))
NUMBER(eq19, ct_closed_loop_acceleration(orbit(in), gains(in + 2), in[4], in[5], in[6]))

static void eq21(const double *in, double *out)
{
    struct ct_charge_pair q;
    ct_charges(in[0], in[1], &q);
    out[0] = q.q1;
    out[1] = q.q2;
}

TRIPLE(eq25, ct_orbit_angular_velocity(in[0], in[1]))
TRIPLE(eq26, ct_relative_angular_velocity(in[0], in[1], in[2]))
TRIPLE(eq27, ct_angular_velocity(in[0], in[1], in[2], in[3]))
TRIPLE(eq28, ct_angular_velocity_small_angles(in[0], in[1], in[2], in[3]))
TRIPLE(eq29, ct_angular_acceleration_small_angles(in[0], in[1], in[2], in[3]))

static void eq30(const double *in, double *out)
{
    const struct ct_matrix I = ct_inertia_matrix(masses(in), vector(in + 2), vector(in + 5));
    static const int row[] = {0, 0, 0, 1, 1, 2}, column[] = {0, 1, 2, 1, 2, 2};
    for (int i = 0; i < 6; i++)
        out[i] = I.e[row[i]][column[i]];
}

NUMBER(eq32, ct_inertia(masses(in), in[2]))
NUMBER(eq34, ct_inertia_rate(masses(in), in[2], in[3]))
TRIPLE(eq36, ct_centre_position(in[0], in[1], in[2]))
TRIPLE(eq37, ct_gravity_gradient(in[0], vector(in + 1), in[4]))
NUMBER(eq38, ct_orbit_rate(in[0], in[1]))
TRIPLE(eq39, ct_gravity_gradient_small_angles(in[0], in[1], in[2], in[3]))
STRUCT(eq40, ct_tether_acceleration,
       ct_linear_acceleration(orbit(in), gains(in + 2), (struct ct_tether_state){in[4], in[5], in[6], in[8], 0.0, in[7]}),
       r.theta_ddot, r.psi_ddot, r.dL_ddot)
STRUCT(eq41, ct_quartic, ct_characteristic_polynomial(in[0], gains(in + 1)), r.a0, r.a1, r.a2, r.a3, r.a4)

static void eq41roots(const double *in, double *out)
{
    struct ct_root root[4];
    ct_characteristic_roots(in[0], gains(in + 1), root);
    for (int i = 0; i < 4; i++) {
        out[2 * i] = root[i].re;
        out[2 * i + 1] = root[i].im;
    }
}

STRUCT(eq42, ct_margins, ct_routh_margins(in[0], gains(in + 1)), r.margin1, r.margin2, r.stable)
NUMBER(eq43, ct_proportional_gain(in[0], in[1]))
NUMBER(eq44, ct_derivative_gain(in[0], in[1]))

/* Omega L_ref C1 C2 t, six of state, and h after them where h is not NULL */
static void linear_motion(const double *in, const double *h, double *out)
{
    const struct ct_params p = orbit(in);
    const struct ct_gains g = gains(in + 2);
    struct ct_tether_state s = {in[5], in[6], in[7], in[8], in[9], in[10]};
    if (h != NULL)
        ct_linear_runge_kutta(p, g, s, *h, 1, in + 4, &s);
    else
        ct_linear_flow(p, g, s, tolerance, 1, in + 4, &s);
    const double state[] = {s.psi, s.theta, s.dL, s.psi_dot, s.theta_dot, s.dL_dot};
    memcpy(out, state, sizeof state);
}

static void linear_flow(const double *in, double *out)
{
    linear_motion(in, NULL, out);
}

static void linear_steps(const double *in, double *out)
{
    linear_motion(in, in + 11, out);
}

static void nonlinear_motion(const double *in, const double *h, double *out)
{
    const struct ct_params p = whole(in);
    const struct ct_gains g = gains(in + 5);
    struct ct_hill_state s = hill_state(in + 8);
    if (h != NULL)
        ct_nonlinear_runge_kutta(p, g, s, *h, 1, in + 7, &s);
    else
        ct_nonlinear_flow(p, g, s, tolerance, 1, in + 7, &s);
    const double state[] = {s.x1, s.y1, s.z1, s.x1_dot, s.y1_dot, s.z1_dot};
    memcpy(out, state, sizeof state);
}

static void nonlinear_flow(const double *in, double *out)
{
    nonlinear_motion(in, NULL, out);
}

static void nonlinear_steps(const double *in, double *out)
{
    nonlinear_motion(in, in + 14, out);
}

#define OPERATION(name) {#name, name}
static const struct {
    const char *id;
    reference_function *function;
} operations[] = {
    OPERATION(eq02), OPERATION(eq03), OPERATION(eq04), OPERATION(eq05), OPERATION(eq07),
    OPERATION(eq09), OPERATION(eq10), OPERATION(eq10lin), OPERATION(eq10inv), OPERATION(eq11exact),
    OPERATION(eq11), OPERATION(eq12), OPERATION(eq13), OPERATION(eq14), OPERATION(eq15),
    OPERATION(eq17), OPERATION(eq18), OPERATION(eq19), OPERATION(eq21), OPERATION(eq25),
    OPERATION(eq26), OPERATION(eq27), OPERATION(eq28), OPERATION(eq29), OPERATION(eq30),
    OPERATION(eq32), OPERATION(eq34), OPERATION(eq36), OPERATION(eq37), OPERATION(eq38),
    OPERATION(eq39), OPERATION(eq40), OPERATION(eq41), OPERATION(eq41roots), OPERATION(eq42),
    OPERATION(eq43), OPERATION(eq44), {"flow_linear", linear_flow}, {"flow_nonlinear", nonlinear_flow},
    {"rk4_linear", linear_steps}, {"rk4_nonlinear", nonlinear_steps},
};

reference_function *reference_find(const char *id)
{
    for (size_t i = 0; i < sizeof operations / sizeof *operations; i++)
        if (strcmp(operations[i].id, id) == 0)
            return operations[i].function;
    return NULL;
}
