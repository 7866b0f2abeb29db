/*
 * client.c   ref/, the reference library, as a client of the oracle
 *
 *     cc -Iref -o client tests/clients/client.c build/libcoulombtether.a $(pkg-config --libs gsl) -lm
 *     coulomb-tether conform -- ./client
 */
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "coulombtether.h"

enum { MOST_INPUTS = 27, MOST_OUTPUTS = 9 };

static const double tolerance = 1e-14; /* of a step; below it roundings take over */

/* The library's arguments, from inputs that stand side by side. Members that a function does not read are 1. */
static struct ct_params orbit(double Omega, double L_ref) { return (struct ct_params){Omega, 1, 1, 1, L_ref}; }
static struct ct_params masses(const double m[]) { return (struct ct_params){1, 1, m[0], m[1], 1}; }
static struct ct_params pair(const double x[]) { return (struct ct_params){x[0], x[1], x[2], x[3], 1}; }
static struct ct_params formation(const double x[]) { return (struct ct_params){x[0], x[1], x[2], x[3], x[4]}; }
static struct ct_params controlled(const double x[]) { return (struct ct_params){1, x[0], x[1], x[2], x[3]}; }
static struct ct_gains gains(const double C[]) { return (struct ct_gains){C[0], C[1]}; }
static struct ct_vector vector(const double r[]) { return (struct ct_vector){r[0], r[1], r[2]}; }
static struct ct_spherical spherical(const double c[]) { return (struct ct_spherical){c[0], c[1], c[2]}; }
static struct ct_spherical_rate rate(const double c[]) { return (struct ct_spherical_rate){c[0], c[1], c[2]}; }
static struct ct_craft craft(const double x[]) { return (struct ct_craft){x[0], x[1], vector(x + 2), vector(x + 5)}; }
static struct ct_hill_state hill(const double s[])
{
    return (struct ct_hill_state){s[0], s[1], s[2], s[3], s[4], s[5]};
}
static struct ct_tether_state tether(const double s[])
{
    return (struct ct_tether_state){s[0], s[1], s[2], s[3], s[4], s[5]};
}

/* How many doubles were put into y. */
static int put(double y[], const void *results, size_t size)
{
    memcpy(y, results, size);
    return (int)(size / sizeof(double));
}

/* An operation that a function of the library answers as it is: all results are doubles, in the oracle's order. */
#define OPERATION(id, type, call)                                                                                      \
    static int id(const double x[], double y[])                                                                        \
    {                                                                                                                  \
        const type results = call;                                                                                     \
        return put(y, &results, sizeof results);                                                                       \
    }

/* The static formation */
OPERATION(eq03, struct ct_vector, ct_hill_acceleration(pair(x), hill(x + 5), x[4]))
OPERATION(eq04, struct ct_vector, ct_second_position(masses(x), vector(x + 2)))
OPERATION(eq05, struct ct_static_places, ct_static_positions(masses(x), x[2]))
OPERATION(eq07, double, ct_reference_charge_product(pair(x), x[4]))

/* The perturbed formation */
OPERATION(eq09, struct ct_matrix, ct_direction_cosines(x[0], x[1]))
OPERATION(eq10, struct ct_vector, ct_position(masses(x), spherical(x + 2)))
OPERATION(eq10lin, struct ct_vector, ct_position_small_angles(masses(x), spherical(x + 2)))
OPERATION(eq10inv, struct ct_spherical, ct_spherical_coordinates(masses(x), vector(x + 2)))
OPERATION(eq11exact, struct ct_vector, ct_velocity(masses(x), spherical(x + 2), rate(x + 5)))
OPERATION(eq11, struct ct_vector, ct_velocity_small_angles(masses(x), spherical(x + 2), rate(x + 5)))
OPERATION(eq12, double, ct_distance(vector(x), vector(x + 3)))
OPERATION(eq13, double, ct_separation(masses(x), vector(x + 2)))
OPERATION(eq14, double, ct_separation_acceleration(pair(x), hill(x + 5), x[4]))
OPERATION(eq15, double, ct_separation_acceleration_small_angles(pair(x), x[4], x[5], x[6]))
OPERATION(eq17, double, ct_length_error_acceleration(formation(x), x[5], x[6], x[7]))

/* The control law */
OPERATION(eq18, double, ct_charge_product_variation(controlled(x), gains(x + 4), x[6], x[7]))
OPERATION(eq19, double, ct_closed_loop_acceleration(orbit(x[0], x[1]), gains(x + 2), x[4], x[5], x[6]))

/* Attitude */
OPERATION(eq25, struct ct_vector, ct_orbit_angular_velocity(x[0], x[1]))
OPERATION(eq26, struct ct_vector, ct_relative_angular_velocity(x[0], x[1], x[2]))
OPERATION(eq27, struct ct_vector, ct_angular_velocity(x[0], x[1], x[2], x[3]))
OPERATION(eq28, struct ct_vector, ct_angular_velocity_small_angles(x[0], x[1], x[2], x[3]))
OPERATION(eq29, struct ct_vector, ct_angular_acceleration_small_angles(x[0], x[1], x[2], x[3]))
OPERATION(eq32, double, ct_inertia(masses(x), x[2]))
OPERATION(eq34, double, ct_inertia_rate(masses(x), x[2], x[3]))
OPERATION(eq36, struct ct_vector, ct_centre_position(x[0], x[1], x[2]))
OPERATION(eq37, struct ct_vector, ct_gravity_gradient(x[0], vector(x + 1), x[4]))
OPERATION(eq38, double, ct_orbit_rate(x[0], x[1]))
OPERATION(eq39, struct ct_vector, ct_gravity_gradient_small_angles(x[0], x[1], x[2], x[3]))

/* The linear model and its stability */
OPERATION(eq41, struct ct_quartic, ct_characteristic_polynomial(x[0], gains(x + 1)))
OPERATION(eq43, double, ct_proportional_gain(x[0], x[1]))
OPERATION(eq44, double, ct_derivative_gain(x[0], x[1]))

/* From here on more is to do than to call. Where a status tells of no convergence, there is nothing to put. */
static int eq02(const double x[], double y[])
{
    const struct ct_craft three[] = {craft(x + 3), craft(x + 11), craft(x + 19)};
    struct ct_vector acceleration[3];

    ct_formation_acceleration(x[0], x[1], x[2], 3, three, acceleration);
    return put(y, acceleration, sizeof acceleration);
}

static int eq21(const double x[], double y[])
{
    struct ct_charge_pair q;

    ct_charges(x[0], x[1], &q);
    return put(y, &q, sizeof q);
}

static int eq30(const double x[], double y[])
{
    const struct ct_matrix I = ct_inertia_matrix(masses(x), vector(x + 2), vector(x + 5));
    const double upper[] = {I.e[0][0], I.e[0][1], I.e[0][2], I.e[1][1], I.e[1][2], I.e[2][2]};

    return put(y, upper, sizeof upper);
}

static int eq40(const double x[], double y[])
{
    const struct ct_tether_state s = {.psi = x[4], .theta = x[5], .dL = x[6], .dL_dot = x[7], .psi_dot = x[8]};
    const struct ct_tether_acceleration a = ct_linear_acceleration(orbit(x[0], x[1]), gains(x + 2), s);

    return put(y, &a, sizeof a);
}

static int eq41roots(const double x[], double y[])
{
    struct ct_root root[4];
    const int status = ct_characteristic_roots(x[0], gains(x + 1), root);

    return status == CT_CONVERGENCE ? 0 : put(y, root, sizeof root);
}

static int eq42(const double x[], double y[])
{
    const struct ct_margins m = ct_routh_margins(x[0], gains(x + 1));
    const double results[] = {m.margin1, m.margin2, m.stable};

    return put(y, results, sizeof results);
}

static int flow_linear(const double x[], double y[])
{
    struct ct_tether_state s;
    const int status = ct_linear_flow(orbit(x[0], x[1]), gains(x + 2), tether(x + 5), tolerance, 1, x + 4, &s);

    return status == CT_CONVERGENCE ? 0 : put(y, &s, sizeof s);
}

static int flow_nonlinear(const double x[], double y[])
{
    struct ct_hill_state s;
    const int status = ct_nonlinear_flow(formation(x), gains(x + 5), hill(x + 8), tolerance, 1, x + 7, &s);

    return status == CT_CONVERGENCE ? 0 : put(y, &s, sizeof s);
}

static int rk4_linear(const double x[], double y[])
{
    struct ct_tether_state s;
    const int status = ct_linear_runge_kutta(orbit(x[0], x[1]), gains(x + 2), tether(x + 5), x[11], 1, x + 4, &s);

    return status == CT_CONVERGENCE ? 0 : put(y, &s, sizeof s);
}

static int rk4_nonlinear(const double x[], double y[])
{
    struct ct_hill_state s;
    const int status = ct_nonlinear_runge_kutta(formation(x), gains(x + 5), hill(x + 8), x[14], 1, x + 7, &s);

    return status == CT_CONVERGENCE ? 0 : put(y, &s, sizeof s);
}

struct operation {
    const char *id;
    int inputs;
    int (*outputs)(const double x[], double y[]);
};

static const struct operation operations[] = {
    {"eq02", 27, eq02}, {"eq03", 11, eq03}, {"eq04", 5, eq04}, {"eq05", 3, eq05}, {"eq07", 5, eq07},
    {"eq09", 2, eq09}, {"eq10", 5, eq10}, {"eq10lin", 5, eq10lin}, {"eq10inv", 5, eq10inv},
    {"eq11exact", 8, eq11exact}, {"eq11", 8, eq11}, {"eq12", 6, eq12}, {"eq13", 5, eq13}, {"eq14", 11, eq14},
    {"eq15", 7, eq15}, {"eq17", 8, eq17}, {"eq18", 8, eq18}, {"eq19", 7, eq19}, {"eq21", 2, eq21},
    {"eq25", 2, eq25}, {"eq26", 3, eq26}, {"eq27", 4, eq27}, {"eq28", 4, eq28}, {"eq29", 4, eq29},
    {"eq30", 8, eq30}, {"eq32", 3, eq32}, {"eq34", 4, eq34}, {"eq36", 3, eq36}, {"eq37", 5, eq37},
    {"eq38", 2, eq38}, {"eq39", 4, eq39}, {"eq40", 9, eq40}, {"eq41", 3, eq41}, {"eq41roots", 3, eq41roots},
    {"eq42", 3, eq42}, {"eq43", 2, eq43}, {"eq44", 2, eq44}, {"flow_linear", 11, flow_linear},
    {"flow_nonlinear", 14, flow_nonlinear}, {"rk4_linear", 12, rk4_linear}, {"rk4_nonlinear", 15, rk4_nonlinear},
};

static const struct operation *find(const char *id)
{
    for (size_t i = 0; i < sizeof operations / sizeof operations[0]; i++)
        if (strcmp(id, operations[i].id) == 0)
            return &operations[i];
    return NULL;
}

/* The library says NaN where an input lies outside the domain. */
static void answer(const struct operation *operation, const double x[])
{
    double y[MOST_OUTPUTS];
    bool outside = false;
    const int outputs = operation->outputs(x, y);

    for (int i = 0; i < outputs; i++)
        outside = outside || isnan(y[i]);
    if (outputs == 0)
        printf(" skip no convergence");
    else if (outside)
        printf(" invalid");
    for (int i = 0; i < outputs && !outside; i++)
        printf(" %.17g", y[i]);
}

int main(void)
{
    char *line = NULL;
    size_t size = 0;

    while (getline(&line, &size, stdin) > 0) {
        const char *blank = " \t\r\n";
        const char *id = strtok(line, blank), *vector_id = strtok(NULL, blank), *word;
        if (!vector_id)
            continue;

        double x[MOST_INPUTS];
        int inputs = 0;
        while (inputs < MOST_INPUTS && (word = strtok(NULL, blank)))
            x[inputs++] = strtod(word, NULL);

        const struct operation *operation = find(id);
        printf("%s", vector_id);
        if (operation && operation->inputs == inputs)
            answer(operation, x);
        else
            printf(operation ? " skip wrong number of inputs" : " skip unknown operation");
        putchar('\n');
    }
    free(line);
    return ferror(stdin) || fflush(stdout);
}
