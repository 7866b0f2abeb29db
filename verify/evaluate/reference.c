#include "evaluate/reference.h"

#include <stddef.h>
#include <string.h>

#include "coulombtether.h"

static const double tolerance = 1e-14; /* of the adaptive integrator: what double can do */

/* ---- parts of input lists ---- */

/* The sheet has inputs and outputs in the order of the members of ref/'s structures of doubles: a list may be read as one. */
#define AT(type, place) (*(const struct type *)(in + (place)))

/* Omega k_c m1 m2 L_ref; a function that takes no L_ref does not look at what stands there */
#define FORMATION AT(ct_params, 0)

static struct ct_params masses(const double *in)
{
    return (struct ct_params){.m1 = in[0], .m2 = in[1]};
}

/* Omega L_ref */
static struct ct_params orbit(const double *in)
{
    return (struct ct_params){.Omega = in[0], .L_ref = in[1]};
}

/* ---- an operation each ---- */

/* Of a function that returns its results, and of one that fills them in. */
#define RETURNS(id, type, ...) static void reference_##id(const double *in, double *out) { *(type *)out = (__VA_ARGS__); }
#define FILLS(id, ...) static void reference_##id(const double *in, double *out) { __VA_ARGS__; }

FILLS(eq02, ct_formation_acceleration(in[0], in[1], in[2], 3, &AT(ct_craft, 3), (struct ct_vector *)out))
RETURNS(eq03, struct ct_vector, ct_hill_acceleration(FORMATION, AT(ct_hill_state, 5), in[4]))
RETURNS(eq04, struct ct_vector, ct_second_position(masses(in), AT(ct_vector, 2)))
RETURNS(eq05, struct ct_static_places, ct_static_positions(masses(in), in[2]))
RETURNS(eq07, double, ct_reference_charge_product(FORMATION, in[4]))
RETURNS(eq09, struct ct_matrix, ct_direction_cosines(in[0], in[1]))
RETURNS(eq10, struct ct_vector, ct_position(masses(in), AT(ct_spherical, 2)))
RETURNS(eq10lin, struct ct_vector, ct_position_small_angles(masses(in), AT(ct_spherical, 2)))
RETURNS(eq10inv, struct ct_spherical, ct_spherical_coordinates(masses(in), AT(ct_vector, 2)))
RETURNS(eq11exact, struct ct_vector, ct_velocity(masses(in), AT(ct_spherical, 2), AT(ct_spherical_rate, 5)))
RETURNS(eq11, struct ct_vector, ct_velocity_small_angles(masses(in), AT(ct_spherical, 2), AT(ct_spherical_rate, 5)))
RETURNS(eq12, double, ct_distance(AT(ct_vector, 0), AT(ct_vector, 3)))
RETURNS(eq13, double, ct_separation(masses(in), AT(ct_vector, 2)))
RETURNS(eq14, double, ct_separation_acceleration(FORMATION, AT(ct_hill_state, 5), in[4]))
RETURNS(eq15, double, ct_separation_acceleration_small_angles(FORMATION, in[4], in[5], in[6]))
RETURNS(eq17, double, ct_length_error_acceleration(FORMATION, in[5], in[6], in[7]))
RETURNS(eq18, double, ct_charge_product_variation((struct ct_params){0, in[0], in[1], in[2], in[3]}, AT(ct_gains, 4), in[6], in[7]))
RETURNS(eq19, double, ct_closed_loop_acceleration(orbit(in), AT(ct_gains, 2), in[4], in[5], in[6]))
FILLS(eq21, ct_charges(in[0], in[1], (struct ct_charge_pair *)out))
RETURNS(eq25, struct ct_vector, ct_orbit_angular_velocity(in[0], in[1]))
RETURNS(eq26, struct ct_vector, ct_relative_angular_velocity(in[0], in[1], in[2]))
RETURNS(eq27, struct ct_vector, ct_angular_velocity(in[0], in[1], in[2], in[3]))
RETURNS(eq28, struct ct_vector, ct_angular_velocity_small_angles(in[0], in[1], in[2], in[3]))
RETURNS(eq29, struct ct_vector, ct_angular_acceleration_small_angles(in[0], in[1], in[2], in[3]))

/* The upper triangle of the symmetric matrix, by rows. */
static void reference_eq30(const double *in, double *out)
{
    const struct ct_matrix I = ct_inertia_matrix(masses(in), AT(ct_vector, 2), AT(ct_vector, 5));
    for (int row = 0; row < 3; row++)
        for (int column = row; column < 3; column++)
            *out++ = I.e[row][column];
}

RETURNS(eq32, double, ct_inertia(masses(in), in[2]))
RETURNS(eq34, double, ct_inertia_rate(masses(in), in[2], in[3]))
RETURNS(eq36, struct ct_vector, ct_centre_position(in[0], in[1], in[2]))
RETURNS(eq37, struct ct_vector, ct_gravity_gradient(in[0], AT(ct_vector, 1), in[4]))
RETURNS(eq38, double, ct_orbit_rate(in[0], in[1]))
RETURNS(eq39, struct ct_vector, ct_gravity_gradient_small_angles(in[0], in[1], in[2], in[3]))
RETURNS(eq40, struct ct_tether_acceleration,
        ct_linear_acceleration(orbit(in), AT(ct_gains, 2), (struct ct_tether_state){in[4], in[5], in[6], in[8], 0, in[7]}))
RETURNS(eq41, struct ct_quartic, ct_characteristic_polynomial(in[0], AT(ct_gains, 1)))
FILLS(eq41roots, ct_characteristic_roots(in[0], AT(ct_gains, 1), (struct ct_root *)out))

static void reference_eq42(const double *in, double *out)
{
    const struct ct_margins m = ct_routh_margins(in[0], AT(ct_gains, 1));
    out[0] = m.margin1;
    out[1] = m.margin2;
    out[2] = m.stable;
}

RETURNS(eq43, double, ct_proportional_gain(in[0], in[1]))
RETURNS(eq44, double, ct_derivative_gain(in[0], in[1]))
FILLS(flow_linear, ct_linear_flow(orbit(in), AT(ct_gains, 2), AT(ct_tether_state, 5), tolerance, 1, in + 4,
                                  (struct ct_tether_state *)out))
FILLS(flow_nonlinear, ct_nonlinear_flow(FORMATION, AT(ct_gains, 5), AT(ct_hill_state, 8), tolerance, 1, in + 7,
                                        (struct ct_hill_state *)out))
FILLS(rk4_linear, ct_linear_runge_kutta(orbit(in), AT(ct_gains, 2), AT(ct_tether_state, 5), in[11], 1, in + 4,
                                        (struct ct_tether_state *)out))
FILLS(rk4_nonlinear, ct_nonlinear_runge_kutta(FORMATION, AT(ct_gains, 5), AT(ct_hill_state, 8), in[14], 1, in + 7,
                                              (struct ct_hill_state *)out))

#define REFERENCE(id) {#id, reference_##id}
static const struct {
    const char *id;
    reference_function *function;
} operations[] = {
    REFERENCE(eq02), REFERENCE(eq03), REFERENCE(eq04), REFERENCE(eq05), REFERENCE(eq07), REFERENCE(eq09),
    REFERENCE(eq10), REFERENCE(eq10lin), REFERENCE(eq10inv), REFERENCE(eq11exact), REFERENCE(eq11), REFERENCE(eq12),
    REFERENCE(eq13), REFERENCE(eq14), REFERENCE(eq15), REFERENCE(eq17), REFERENCE(eq18), REFERENCE(eq19),
    REFERENCE(eq21), REFERENCE(eq25), REFERENCE(eq26), REFERENCE(eq27), REFERENCE(eq28), REFERENCE(eq29),
    REFERENCE(eq30), REFERENCE(eq32), REFERENCE(eq34), REFERENCE(eq36), REFERENCE(eq37), REFERENCE(eq38),
    REFERENCE(eq39), REFERENCE(eq40), REFERENCE(eq41), REFERENCE(eq41roots), REFERENCE(eq42), REFERENCE(eq43),
    REFERENCE(eq44), REFERENCE(flow_linear), REFERENCE(flow_nonlinear), REFERENCE(rk4_linear),
    REFERENCE(rk4_nonlinear),
};

reference_function *reference_find(const char *id)
{
    for (size_t i = 0; i < sizeof operations / sizeof *operations; i++)
        if (strcmp(operations[i].id, id) == 0)
            return operations[i].function;
    return NULL;
}
