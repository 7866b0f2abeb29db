/*
 * coulombtether.h   the equations of a Coulomb tether formation, one function an equation
 *
 * Two charged craft fly in line with the local vertical; the electrostatic force holds their distance, the gravity gradient their
 * attitude. The number before a function is the equation that it computes; its formula, units and domain stand above its definition,
 * in the installed header above its declaration, and in coulombtether(3).
 *
 * Units are SI. Every input must be finite, lambda_d excepted. Outside its domain
 *   - a function that returns a value returns NaN, in every floating-point member;
 *   - a function that returns a status sets its results to NaN as well.
 * Of a structure that it is given, a function reads only the members that its comment names; the others may hold anything.
 * Nothing here prints, keeps state or changes any setting; only the roots and the flows allocate (through GSL), and free again.
 */
#ifndef COULOMBTETHER_H
#define COULOMBTETHER_H

#include <stddef.h>

/* Domains are checked by comparisons with NaN and infinity, which these options take for never happening. */
#if defined(__FAST_MATH__) || (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__ > 0)
#error "coulombtether.h: compile without -ffast-math and -ffinite-math-only: NaN and infinity say that an input is outside the domain"
#endif

#define CT_VERSION "2.0.0"
#define CT_VERSION_MAJOR 2
#define CT_VERSION_MINOR 0
#define CT_VERSION_PATCH 0

#ifdef __cplusplus
extern "C" {
#endif

enum ct_status {
    CT_OK = 0,
    CT_DOMAIN,     /* an input lies outside the function's domain */
    CT_MEMORY,     /* GSL found no memory, and its error handler let the call return */
    CT_CONVERGENCE /* a root or a trajectory could not be followed to the accuracy asked for */
};

/* The formation: Table 1 of the paper without Q_ref, which Eq. (7) gives. */
struct ct_params {
    double Omega; /* orbit rate [rad/s]                         > 0 */
    double k_c;   /* Coulomb constant [N m^2/C^2]               > 0 */
    double m1;    /* mass of craft 1 [kg]                       > 0 */
    double m2;    /* mass of craft 2 [kg]                       > 0 */
    double L_ref; /* reference distance between the craft [m]   > 0 */
};

/* Table 1: struct ct_params p = CT_TABLE1; */
#define CT_TABLE1 {7.2915e-5, 8.99e9, 150, 150, 10}

/* Feedback gains of the charge control, of either sign. */
struct ct_gains {
    double C1; /* on the length error [1/s^2] */
    double C2; /* on its rate [1/s] */
};

/* Craft 1 in the rotating Hill frame: x radially outwards, y along the velocity, z along the orbit normal. */
struct ct_hill_state {
    double x1, y1, z1;             /* [m] */
    double x1_dot, y1_dot, z1_dot; /* [m/s] */
};

/* The formation as a tether: yaw, pitch and length error L - L_ref. */
struct ct_tether_state {
    double psi, theta, dL;             /* [rad], [rad], [m] */
    double psi_dot, theta_dot, dL_dot; /* [rad/s], [rad/s], [m/s] */
};

struct ct_tether_acceleration {
    double theta_ddot, psi_ddot, dL_ddot; /* [rad/s^2], [rad/s^2], [m/s^2] */
};

/* Components along the first, second and third axis of the equation's frame; elements by row, then column. */
struct ct_vector { double x, y, z; };
struct ct_matrix { double e[3][3]; };

/* One of N craft, in the Hill frame. */
struct ct_craft {
    double m, q;                         /* mass [kg] > 0, charge [C] */
    struct ct_vector position, velocity; /* [m], [m/s] */
};

struct ct_spherical { double L, psi, theta; };                     /* [m], [rad], [rad] */
struct ct_spherical_rate { double L_dot, psi_dot, theta_dot; };    /* [m/s], [rad/s], [rad/s] */
struct ct_static_places { double x1, x2; };                        /* [m] */
struct ct_charge_pair { double q1, q2; };                          /* [C] */
struct ct_quartic { double a0, a1, a2, a3, a4; };                  /* of lambda^k: [1/s^(4-k)] */
struct ct_root { double re, im; };                                 /* [1/s] */
struct ct_margins { double margin1, margin2; int stable; };        /* [1/s^2], [1/s], 1 or 0 */

/* The library: library.c */
const char *ct_version(void);
const char *ct_status_string(int status);

/* Charged dynamics in the Hill frame and the static formation: hill.c */
/* (2)  */ int ct_formation_acceleration(double Omega, double k_c, double lambda_d, size_t N, const struct ct_craft *craft, struct ct_vector *acceleration);
/* (3)  */ struct ct_vector ct_hill_acceleration(struct ct_params p, struct ct_hill_state s, double Q);
/* (4)  */ struct ct_vector ct_second_position(struct ct_params p, struct ct_vector r1);
/* (5)  */ struct ct_static_places ct_static_positions(struct ct_params p, double L);
/* (7)  */ double ct_reference_charge_product(struct ct_params p, double L);

/* Attitude angles, distance, and how they move: perturbation.c */
/* (9)  */ struct ct_matrix ct_direction_cosines(double psi, double theta);
/* (10) */ struct ct_vector ct_position(struct ct_params p, struct ct_spherical c);
/* (10) */ struct ct_vector ct_position_small_angles(struct ct_params p, struct ct_spherical c);
/* (10) */ struct ct_spherical ct_spherical_coordinates(struct ct_params p, struct ct_vector r1);
/* (11) */ struct ct_vector ct_velocity(struct ct_params p, struct ct_spherical c, struct ct_spherical_rate c_dot);
/* (11) */ struct ct_vector ct_velocity_small_angles(struct ct_params p, struct ct_spherical c, struct ct_spherical_rate c_dot);
/* (12) */ double ct_distance(struct ct_vector r1, struct ct_vector r2);
/* (13) */ double ct_separation(struct ct_params p, struct ct_vector r1);
/* (13) */ double ct_separation_rate(struct ct_params p, struct ct_hill_state s);
/* (10) */ struct ct_hill_state ct_hill_state_of_tether(struct ct_params p, struct ct_tether_state s);
/* (10) */ struct ct_tether_state ct_tether_state_of_hill(struct ct_params p, struct ct_hill_state s);
/* (14) */ double ct_separation_acceleration(struct ct_params p, struct ct_hill_state s, double Q);
/* (15) */ double ct_separation_acceleration_small_angles(struct ct_params p, double L, double psi_dot, double Q);
/* (17) */ double ct_length_error_acceleration(struct ct_params p, double psi_dot, double dL, double dQ);

/* Charge control: control.c */
/* (18) */ double ct_charge_product_variation(struct ct_params p, struct ct_gains g, double dL, double dL_dot);
/* (19) */ double ct_closed_loop_acceleration(struct ct_params p, struct ct_gains g, double dL, double dL_dot, double psi_dot);
/* (21) */ int ct_charges(double Q_ref, double dQ, struct ct_charge_pair *q);
/* (21) */ int ct_commanded_charges(struct ct_params p, struct ct_gains g, struct ct_hill_state s, struct ct_charge_pair *q);

/* The formation as a slender body under the gravity gradient: attitude.c */
/* (25) */ struct ct_vector ct_orbit_angular_velocity(double Omega, double theta);
/* (26) */ struct ct_vector ct_relative_angular_velocity(double theta, double psi_dot, double theta_dot);
/* (27) */ struct ct_vector ct_angular_velocity(double Omega, double theta, double psi_dot, double theta_dot);
/* (28) */ struct ct_vector ct_angular_velocity_small_angles(double Omega, double theta, double psi_dot, double theta_dot);
/* (29) */ struct ct_vector ct_angular_acceleration_small_angles(double Omega, double theta_dot, double theta_ddot, double psi_ddot);
/* (30) */ struct ct_matrix ct_inertia_matrix(struct ct_params p, struct ct_vector r1, struct ct_vector r2);
/* (32) */ double ct_inertia(struct ct_params p, double L);
/* (34) */ double ct_inertia_rate(struct ct_params p, double L, double L_dot);
/* (36) */ struct ct_vector ct_centre_position(double R_c, double psi, double theta);
/* (37) */ struct ct_vector ct_gravity_gradient(double GM, struct ct_vector R_c, double inertia);
/* (38) */ double ct_orbit_rate(double GM, double R_c);
/* (39) */ struct ct_vector ct_gravity_gradient_small_angles(double Omega, double inertia, double psi, double theta);

/* The linear model, its characteristic equation and its gains: stability.c */
/* (40) */ struct ct_tether_acceleration ct_linear_acceleration(struct ct_params p, struct ct_gains g, struct ct_tether_state s);
/* (41) */ struct ct_quartic ct_characteristic_polynomial(double Omega, struct ct_gains g);
/* (41) */ int ct_characteristic_roots(double Omega, struct ct_gains g, struct ct_root root[4]);
/* (42) */ struct ct_margins ct_routh_margins(double Omega, struct ct_gains g);
/* (43) */ double ct_proportional_gain(double Omega, double n);
/* (44) */ double ct_derivative_gain(double Omega, double n);

/* Motion: states[i] at t[i], from the initial state at t = 0: simulation.c */
/* (2)  */ int ct_formation_flow(double Omega, double k_c, double lambda_d, size_t N, const struct ct_craft *initial, double tolerance, size_t count, const double *t, struct ct_craft *craft);
/* (40) */ int ct_linear_flow(struct ct_params p, struct ct_gains g, struct ct_tether_state initial, double tolerance, size_t count, const double *t, struct ct_tether_state *states);
/* (3)  */ int ct_nonlinear_flow(struct ct_params p, struct ct_gains g, struct ct_hill_state initial, double tolerance, size_t count, const double *t, struct ct_hill_state *states);
/* (40) */ int ct_linear_runge_kutta(struct ct_params p, struct ct_gains g, struct ct_tether_state initial, double h, size_t count, const double *t, struct ct_tether_state *states);
/* (3)  */ int ct_nonlinear_runge_kutta(struct ct_params p, struct ct_gains g, struct ct_hill_state initial, double h, size_t count, const double *t, struct ct_hill_state *states);

#ifdef __cplusplus
}
#endif

#endif
