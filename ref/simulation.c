/*
 * simulation.c   the formation in motion: the linear model (40), (3) closed by (7) and (18), and N craft by (2)
 *
 * Inside, time is tau = Omega t: in seconds, rates and accelerations would lie four and eight orders of magnitude below
 * the coordinates.
 */
#include "internal.h"

#include <float.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>

enum {
    DIMENSION = 6,       /* three coordinates, then their rates: both state structures, member by member */
    COORDINATES = 3,
    MOST_STEPS = 200000  /* between two times asked for; the paper's three days take a few hundred */
};
_Static_assert(sizeof(struct ct_tether_state) == DIMENSION * sizeof(double), "a state is six doubles");
_Static_assert(sizeof(struct ct_hill_state) == DIMENSION * sizeof(double), "a state is six doubles");
_Static_assert(sizeof(struct ct_vector) == COORDINATES * sizeof(double), "a vector is three doubles");

struct model {
    struct ct_params p;
    struct ct_gains g;
};

/* The right-hand side of a model in the form that GSL asks for. */
typedef int slope_function(double tau, const double y[], double dydtau[], void *model);

/* A motion at a moment, in units in which Omega = 1. */
struct motion {
    slope_function *slope;
    void *model;
    double Omega, tau;
    size_t dimension; /* coordinates, and as many rates after them */
    double *y;        /* now */
    const double *y0; /* at tau = 0 */
};

/* The motion of two craft. */
struct motion_of_two {
    struct motion m;
    struct model model;
    double y[DIMENSION], y0[DIMENSION];
};

/* What a motion of N craft works on, for one of them: the lists stand in one block, one after the other. */
struct work {
    struct ct_craft craft;          /* in the motion's units */
    struct ct_vector acceleration;
    double y[DIMENSION], y0[DIMENSION], slope[DIMENSION];
};

struct formation {
    double k_c, lambda_d;
    size_t N;
    struct ct_craft *craft;
    struct ct_vector *acceleration;
};

/* states[i] in SI units, NaN where the motion could not be followed so far. */
typedef void record_function(const struct motion *m, int status, size_t i, void *states);

static int linear_slope(double tau, const double y[], double dydtau[], void *model)
{
    const struct model *m = model;
    struct ct_tether_state s;
    (void)tau;

    memcpy(&s, y, sizeof s);
    const struct ct_tether_acceleration a = ct_linear_acceleration(m->p, m->g, s);
    const double slope[DIMENSION] = {s.psi_dot, s.theta_dot, s.dL_dot, a.psi_ddot, a.theta_ddot, a.dL_ddot};
    memcpy(dydtau, slope, sizeof slope);
    return all_within(-INFINITY, slope, DIMENSION) ? GSL_SUCCESS : GSL_EDOM;
}

static int nonlinear_slope(double tau, const double y[], double dydtau[], void *model)
{
    const struct model *m = model;
    struct ct_hill_state s;
    (void)tau;

    memcpy(&s, y, sizeof s);
    const double dL = ct_separation(m->p, hill_position(s)) - m->p.L_ref;
    const double dQ = ct_charge_product_variation(m->p, m->g, dL, ct_separation_rate(m->p, s));
    const double Q = ct_reference_charge_product(m->p, m->p.L_ref) + dQ;
    const struct ct_vector a = ct_hill_acceleration(m->p, s, Q);
    const double slope[DIMENSION] = {s.x1_dot, s.y1_dot, s.z1_dot, a.x, a.y, a.z};
    memcpy(dydtau, slope, sizeof slope);
    return all_within(-INFINITY, slope, DIMENSION) ? GSL_SUCCESS : GSL_EDOM;
}

static int formation_slope(double tau, const double y[], double dydtau[], void *model)
{
    const struct formation *f = model;
    const size_t coordinates = COORDINATES * f->N;
    (void)tau;

    for (size_t j = 0; j < f->N; j++) {
        const double *r = y + COORDINATES * j, *v = r + coordinates;
        f->craft[j].position = (struct ct_vector){r[0], r[1], r[2]};
        f->craft[j].velocity = (struct ct_vector){v[0], v[1], v[2]};
    }
    const int status = ct_formation_acceleration(1, f->k_c, f->lambda_d, f->N, f->craft, f->acceleration);
    memcpy(dydtau, y + coordinates, coordinates * sizeof *y);
    memcpy(dydtau + coordinates, f->acceleration, coordinates * sizeof *y);
    return status == CT_OK && all_within(-INFINITY, dydtau, 2 * coordinates) ? GSL_SUCCESS : GSL_EDOM;
}

/* The equations know their domain: where they are fed anything outside, the slope is NaN. */
static int start(struct motion_of_two *two, slope_function *slope, struct ct_params p, struct ct_gains g, const void *initial)
{
    double dydtau[DIMENSION];

    memcpy(two->y, initial, sizeof two->y);
    for (size_t k = COORDINATES; k < DIMENSION; k++)
        two->y[k] /= p.Omega;
    memcpy(two->y0, two->y, sizeof two->y);
    two->model.p = (struct ct_params){1, p.k_c / p.Omega / p.Omega, p.m1, p.m2, p.L_ref};
    two->model.g = (struct ct_gains){g.C1 / p.Omega / p.Omega, g.C2 / p.Omega};
    two->m = (struct motion){slope, &two->model, p.Omega, 0, DIMENSION, two->y, two->y0};
    return POSITIVE(p.Omega) && slope(0, two->y, dydtau, &two->model) == GSL_SUCCESS ? CT_OK : CT_DOMAIN;
}

static void record(const struct motion *m, int status, size_t i, void *states)
{
    double s[DIMENSION];

    for (size_t k = 0; k < DIMENSION; k++)
        s[k] = status ? NAN : k < COORDINATES ? m->y[k] : m->Omega * m->y[k];
    memcpy((unsigned char *)states + i * sizeof s, s, sizeof s);
}

static void record_craft(const struct motion *m, int status, size_t i, void *states)
{
    const struct formation *f = m->model;
    struct ct_craft *craft = (struct ct_craft *)states + i * f->N;

    for (size_t j = 0; j < f->N; j++) {
        const double *r = m->y + COORDINATES * j, *v = r + COORDINATES * f->N;
        craft[j] = f->craft[j];
        craft[j].position = status ? nan_vector() : (struct ct_vector){r[0], r[1], r[2]};
        craft[j].velocity = status ? nan_vector() : multiple(m->Omega, (struct ct_vector){v[0], v[1], v[2]});
    }
}

/*
 * A step may err by noise + tolerance (|y| + |h dy/dtau|) in each component: no halt where one passes through zero. A
 * time on the way back to t = 0 is approached from there anew, for backwards a stable motion amplifies its errors.
 */
static int adaptive_flow(struct motion *m, int status, double noise, double tolerance, size_t count, const double t[],
                         record_function *record_state, void *states)
{
    if (status == CT_OK && !(tolerance >= DBL_EPSILON && tolerance < 1 && all_within(-INFINITY, t, count)))
        status = CT_DOMAIN;
    if (status != CT_OK) {
        for (size_t i = 0; i < count; i++)
            record_state(m, status, i, states);
        return status;
    }

    const gsl_odeiv2_system system = {m->slope, NULL, m->dimension, m->model};
    gsl_odeiv2_step *step = gsl_odeiv2_step_alloc(gsl_odeiv2_step_rk8pd, m->dimension);
    gsl_odeiv2_control *control = gsl_odeiv2_control_standard_new(noise, tolerance, 1, 1);
    gsl_odeiv2_evolve *evolve = gsl_odeiv2_evolve_alloc(m->dimension);
    double h = 1e-3; /* a first trial, well below a radian of the orbit */
    if (!step || !control || !evolve)
        status = CT_MEMORY;

    for (size_t i = 0; i < count; i++) {
        const double end = m->Omega * t[i];
        if (status == CT_OK && m->tau * (end - m->tau) < 0) {
            m->tau = 0;
            memcpy(m->y, m->y0, m->dimension * sizeof *m->y);
            gsl_odeiv2_evolve_reset(evolve);
        }
        for (int steps = 0; status == CT_OK && m->tau != end; steps++) {
            h = copysign(h, end - m->tau);
            if (steps == MOST_STEPS ||
                gsl_odeiv2_evolve_apply(evolve, control, step, &system, &m->tau, end, &h, m->y) != GSL_SUCCESS)
                status = CT_CONVERGENCE;
        }
        record_state(m, status, i, states);
    }
    gsl_odeiv2_evolve_free(evolve);
    gsl_odeiv2_control_free(control);
    gsl_odeiv2_step_free(step);
    return status;
}

/* Whether the times are reached by whole steps without turning back, and the steps can be counted. */
static bool whole_steps(double h, size_t count, const double t[])
{
    const double most = 1 / DBL_EPSILON; /* every whole number up to here is a double */

    for (size_t i = 0; i < count; i++)
        if (!(t[i] >= (i ? t[i - 1] : 0) && t[i] / h <= most && fmod(t[i], h) == 0))
            return false;
    return true;
}

/* One step of the classical method. GSL's rk4 takes two of half the length in its place, which is another method. */
static int runge_kutta_step(struct motion *m, double h)
{
    const double reach[] = {0, h / 2, h / 2, h}, weight[] = {h / 6, h / 3, h / 3, h / 6};
    double slope[DIMENSION] = {0}, increment[DIMENSION] = {0};

    for (size_t stage = 0; stage < 4; stage++) {
        double at[DIMENSION];
        for (size_t k = 0; k < DIMENSION; k++)
            at[k] = m->y[k] + reach[stage] * slope[k];
        if (m->slope(m->tau, at, slope, m->model) != GSL_SUCCESS)
            return CT_CONVERGENCE;
        for (size_t k = 0; k < DIMENSION; k++)
            increment[k] += weight[stage] * slope[k];
    }
    for (size_t k = 0; k < DIMENSION; k++)
        m->y[k] += increment[k];
    return all_within(-INFINITY, m->y, DIMENSION) ? CT_OK : CT_CONVERGENCE;
}

static int fixed_step_flow(struct motion *m, int status, double h, size_t count, const double t[], void *states)
{
    double steps = 0;

    if (!(POSITIVE(h) && whole_steps(h, count, t)))
        status = CT_DOMAIN;
    for (size_t i = 0; i < count; i++) {
        for (; status == CT_OK && steps < t[i] / h; steps++)
            status = runge_kutta_step(m, m->Omega * h);
        record(m, status, i, states);
    }
    return status;
}

/*
 * Eq. (40), flow   motion of the linear model, integrated with adaptive steps
 *
 *     (psi, theta, dL, psi_dot, theta_dot, dL_dot) at t = t[0], t[1], ...
 *
 * Given     p          orbit rate [rad/s], reference distance [m]
 *           g          gains C1 [1/s^2], C2 [1/s]
 *           initial    state at t = 0
 *           tolerance  relative error of a step   >= 2^-52 and < 1
 *           count      number of times
 *           t          times [s]                  any finite values in any order
 * Returned  states     states at these times; NaN from the first one that was not reached
 * Status    CT_OK, CT_DOMAIN, CT_MEMORY, or CT_CONVERGENCE where the state outgrows double
 *
 * Note 1    Method: the Prince-Dormand pair of orders 8 and 9, GSL's rk8pd. In the paper's case a tolerance of 1e-13
 *           leaves twelve digits after three days; below it roundings take over.
 * Note 2    GSL calls its error handler, which by default aborts, where memory is exhausted.
 */
int ct_linear_flow(struct ct_params p, struct ct_gains g, struct ct_tether_state initial, double tolerance, size_t count,
                   const double *t, struct ct_tether_state *states)
{
    struct motion_of_two two;
    const int status = start(&two, linear_slope, p, g, &initial);

    return adaptive_flow(&two.m, status, DBL_MIN, tolerance, count, t, record, states);
}

/*
 * Eqs. (3a)-(3c), flow   motion of two craft under the feedback law, integrated with adaptive steps
 *
 *     (x1, y1, z1, x1_dot, y1_dot, z1_dot) at t = t[0], t[1], ..., with Q = Q_ref + dQ of (7) at L_ref and (18)
 *
 * Given     p          the formation
 *           g          gains C1 [1/s^2], C2 [1/s]
 *           initial    state at t = 0, off the origin
 *           tolerance  relative error of a step   >= 2^-52 and < 1
 *           count      number of times
 *           t          times [s]                  any finite values in any order
 * Returned  states     states at these times; NaN from the first one that was not reached
 * Status    CT_OK, CT_DOMAIN, CT_MEMORY, or CT_CONVERGENCE where the craft collide or the state outgrows double
 *
 * Note      Q takes the sign that the law commands. Charges (21) exist only while it is negative: ct_commanded_charges
 *           gives them. Method and memory as for the linear model.
 */
int ct_nonlinear_flow(struct ct_params p, struct ct_gains g, struct ct_hill_state initial, double tolerance, size_t count,
                      const double *t, struct ct_hill_state *states)
{
    struct motion_of_two two;
    const int status = start(&two, nonlinear_slope, p, g, &initial);
    const double noise = DBL_EPSILON * norm(hill_position(initial)); /* near equilibrium, what large forces leave over */

    return adaptive_flow(&two.m, status, noise, tolerance, count, t, record, states);
}

/*
 * Eqs. (2a)-(2c), flow   motion of N craft of constant charges, integrated with adaptive steps
 *
 *     (x_i, y_i, z_i, x_i_dot, y_i_dot, z_i_dot) of every craft at t = t[0], t[1], ...
 *
 * Given     Omega      orbit rate [rad/s]               > 0
 *           k_c        Coulomb constant [N m^2/C^2]     > 0
 *           lambda_d   Debye length [m]                 > 0, INFINITY where nothing shields
 *           N          number of craft                  > 0
 *           initial    N craft at t = 0, no two in one place
 *           tolerance  relative error of a step         >= 2^-52 and < 1
 *           count      number of times
 *           t          times [s]                        any finite values in any order
 * Returned  craft      N craft at t[0], then N at t[1], ...; positions and velocities NaN from the first time not reached
 * Status    CT_OK, CT_DOMAIN, CT_MEMORY, or CT_CONVERGENCE where craft collide or the state outgrows double
 *
 * Note      Method and GSL's memory as for the linear model. Without memory of its own it returns nothing in craft.
 */
int ct_formation_flow(double Omega, double k_c, double lambda_d, size_t N, const struct ct_craft *initial, double tolerance,
                      size_t count, const double *t, struct ct_craft *craft)
{
    struct work *block = N > 0 && N <= SIZE_MAX / sizeof *block ? calloc(N, sizeof *block) : NULL;
    if (!block)
        return N > 0 ? CT_MEMORY : CT_DOMAIN;

    struct ct_craft *const now = (struct ct_craft *)block;
    struct ct_vector *const acceleration = (struct ct_vector *)(now + N);
    double *const y = (double *)(acceleration + N), *const y0 = y + DIMENSION * N, *const slope = y0 + DIMENSION * N;
    struct formation formation = {k_c / Omega / Omega, lambda_d, N, now, acceleration};
    struct motion m = {formation_slope, &formation, Omega, 0, DIMENSION * N, y, y0};
    double noise = DBL_MIN; /* and what large forces leave over */

    memcpy(now, initial, N * sizeof *now);
    for (size_t j = 0; j < N; j++) {
        const struct ct_vector v = multiple(1 / Omega, initial[j].velocity);
        memcpy(y0 + COORDINATES * j, &initial[j].position, sizeof v);
        memcpy(y0 + COORDINATES * (N + j), &v, sizeof v);
        noise = fmax(noise, DBL_EPSILON * norm(initial[j].position));
    }
    memcpy(y, y0, DIMENSION * N * sizeof *y);
    int status = POSITIVE(Omega) && formation_slope(0, y, slope, &formation) == GSL_SUCCESS ? CT_OK : CT_DOMAIN;
    status = adaptive_flow(&m, status, noise, tolerance, count, t, record_craft, craft);
    free(block);
    return status;
}

/*
 * Eq. (40), Runge-Kutta   motion of the linear model by the classical method with a fixed step, the paper's own
 *
 *     k1 = f(y),  k2 = f(y + h/2 k1),  k3 = f(y + h/2 k2),  k4 = f(y + h k3),  y <- y + h/6 (k1 + 2 k2 + 2 k3 + k4)
 *
 * Given     p          orbit rate [rad/s], reference distance [m]
 *           g          gains C1 [1/s^2], C2 [1/s]
 *           initial    state at t = 0
 *           h          step [s]                   > 0
 *           count      number of times
 *           t          times [s]                  >= 0, none before the last, each a whole multiple of h
 * Returned  states     states at these times; NaN from the first one that was not reached
 * Status    CT_OK, CT_DOMAIN, or CT_CONVERGENCE where the state outgrows double
 */
int ct_linear_runge_kutta(struct ct_params p, struct ct_gains g, struct ct_tether_state initial, double h, size_t count,
                          const double *t, struct ct_tether_state *states)
{
    struct motion_of_two two;
    const int status = start(&two, linear_slope, p, g, &initial);

    return fixed_step_flow(&two.m, status, h, count, t, states);
}

/*
 * Eqs. (3a)-(3c), Runge-Kutta   motion of two craft under the feedback law by the classical method with a fixed step
 *
 *     as the flow of (3), with the steps of the linear model's Runge-Kutta
 *
 * Given     p          the formation
 *           g          gains C1 [1/s^2], C2 [1/s]
 *           initial    state at t = 0, off the origin
 *           h          step [s]                   > 0
 *           count      number of times
 *           t          times [s]                  >= 0, none before the last, each a whole multiple of h
 * Returned  states     states at these times; NaN from the first one that was not reached
 * Status    CT_OK, CT_DOMAIN, or CT_CONVERGENCE where the craft meet in one point or the state outgrows double
 */
int ct_nonlinear_runge_kutta(struct ct_params p, struct ct_gains g, struct ct_hill_state initial, double h, size_t count,
                             const double *t, struct ct_hill_state *states)
{
    struct motion_of_two two;
    const int status = start(&two, nonlinear_slope, p, g, &initial);

    return fixed_step_flow(&two.m, status, h, count, t, states);
}
