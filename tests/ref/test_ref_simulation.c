/*
 * ref/simulation.c: the motion of (40), of (3) under the law of (18), and of N craft by (2)
 */
#include "tests/run.h"

#include <string.h>

#include "coulombtether.h"

/* The paper's simulation: Table 1, n = 10, and the initial values of the text. */
static const struct ct_params paper = {7.2915e-5, 8.99e9, 150, 150, 10};
static const struct ct_gains paper_gains = {10 * 7.2915e-5 * 7.2915e-5, 2 * 7.2915e-5};
static const struct ct_tether_state paper_start = {.psi = 0.01, .theta = 0.01, .dL = 0.1};

/* Unequal craft, and gains 12 Omega^2 and 3 Omega without rounding. */
static const struct ct_params unequal = {0x1p-14, 8.99e9, 120, 410, 23};
static const struct ct_gains unequal_gains = {0x1.8p-25, 0x1.8p-13};

/* Omega = 1. With gains 4 and 3, lambda = 1 solves (41) for psi = 1, dL = -2 L_ref: a motion that only grows. */
static const struct ct_params unit = {.Omega = 1, .L_ref = 4};
static const struct ct_gains growing = {4, 3};
static const struct ct_tether_state growing_start = {.psi = 1, .dL = -8, .psi_dot = 1, .dL_dot = -8};

static const double fine = 1e-13; /* which is worth twelve digits over three days */

static struct ct_tether_state linear(double t)
{
    struct ct_tether_state s;

    ck_assert_int_eq(ct_linear_flow(paper, paper_gains, paper_start, fine, 1, &t, &s), CT_OK);
    return s;
}

TEST(eq40_flow_at_zero_is_the_initial_state)
{
    const struct ct_tether_state start = {1, -2, 3, -4, 5, -6};
    const double t = 0;
    struct ct_tether_state s;

    ck_assert_int_eq(ct_linear_flow(paper, paper_gains, start, fine, 1, &t, &s), CT_OK);
    ck_assert_double_eq(s.theta, -2);
    assert_close(s.psi_dot, -4, 2); /* into units of Omega and back */
    assert_close(s.dL_dot, -6, 2);
}

TEST(eq40_flow_along_an_eigenvector_grows_exponentially)
{
    const double t[] = {1, 10, -1};
    struct ct_tether_state s[3];

    ck_assert_int_eq(ct_linear_flow(unit, growing, growing_start, fine, 3, t, s), CT_OK);
    for (int i = 0; i < 3; i++) {
        assert_close(s[i].psi, exp(t[i]), 1e-11 * 0x1p53); /* some tens of steps of 1e-13 */
        assert_close(s[i].dL_dot, -8 * exp(t[i]), 1e-11 * 0x1p53);
    }
}

TEST(eq40_flow_takes_times_in_any_order)
{
    const double t[] = {5000, -3000, -3000, 0};
    struct ct_tether_state s[4];

    ck_assert_int_eq(ct_linear_flow(paper, paper_gains, paper_start, fine, 4, t, s), CT_OK);
    assert_close(s[0].psi, linear(5000).psi, 1e-11 * 0x1p53);
    assert_close(s[1].psi, linear(-3000).psi, 1e-11 * 0x1p53);
    ck_assert_double_eq(s[2].psi, s[1].psi);
    assert_close(s[3].psi, 0.01, 1e-11 * 0x1p53);
}

/* Backwards, what this motion forgets within a hundredth of an orbit would come back e^80 and e^160 times as large. */
TEST(eq40_flow_does_not_go_back_on_its_way)
{
    const struct ct_gains strong = {1e4, 200};
    const double t[] = {0.9, 0.1, -0.1, -0.05}, direct[] = {0.1, -0.05};
    struct ct_tether_state s[4], d[2];

    ck_assert_int_eq(ct_linear_flow(unit, strong, growing_start, fine, 4, t, s), CT_OK);
    for (int i = 0; i < 2; i++) {
        ck_assert_int_eq(ct_linear_flow(unit, strong, growing_start, fine, 1, direct + i, d + i), CT_OK);
        assert_close(s[2 * i + 1].psi, d[i].psi, 1e-11 * 0x1p53);
        assert_close(s[2 * i + 1].dL, d[i].dL, 1e-11 * 0x1p53);
    }
}

/* The model is linear, powers of 2 round nothing, and an error is measured by the state: all is to scale. */
TEST(eq40_flow_is_to_scale)
{
    const double t = 3, scale[] = {0x1p-40, 0x1p40};
    const struct ct_tether_state start = {1, -2, 3, -4, 5, -6};
    struct ct_tether_state one, s;

    ck_assert_int_eq(ct_linear_flow(unit, growing, start, 1e-9, 1, &t, &one), CT_OK);
    for (int i = 0; i < 2; i++) {
        const double k = scale[i];
        const struct ct_tether_state scaled = {k, -2 * k, 3 * k, -4 * k, 5 * k, -6 * k};
        ck_assert_int_eq(ct_linear_flow(unit, growing, scaled, 1e-9, 1, &t, &s), CT_OK);
        ck_assert_double_eq(s.psi, k * one.psi);
        ck_assert_double_eq(s.dL_dot, k * one.dL_dot);
    }
}

TEST(eq40_flow_at_rest_stays_at_rest)
{
    const struct ct_tether_state rest = {0};
    const double t = 1e6;
    struct ct_tether_state s;

    ck_assert_int_eq(ct_linear_flow(paper, paper_gains, rest, fine, 1, &t, &s), CT_OK);
    ck_assert_double_eq(s.psi, 0);
    ck_assert_double_eq(s.dL, 0);
}

TEST(eq40_flow_of_no_times_is_no_error)
{
    ck_assert_int_eq(ct_linear_flow(paper, paper_gains, paper_start, fine, 0, NULL, NULL), CT_OK);
}

TEST(eq40_flow_keeps_the_states_before_it_overflows)
{
    const double t[] = {1, 1000, 2};
    struct ct_tether_state s[3];

    ck_assert_int_eq(ct_linear_flow(unit, growing, growing_start, fine, 3, t, s), CT_CONVERGENCE); /* exp(1000) */
    assert_close(s[0].psi, exp(1), 1e-11 * 0x1p53);
    ck_assert_double_nan(s[1].psi);
    ck_assert_double_nan(s[2].dL_dot);
}

/* A motion faster than the orbit by 1e10 turns would take more steps than anybody waits for. */
TEST(eq40_flow_gives_up_after_many_steps)
{
    const double t = 100;
    struct ct_tether_state s;

    ck_assert_int_eq(ct_linear_flow(unit, (struct ct_gains){1e20, 0}, growing_start, fine, 1, &t, &s), CT_CONVERGENCE);
    ck_assert_double_nan(s.psi);
}

EACH(eq40_flow_rejects_tolerances_beyond_double, 3)
{
    const double t = 1, tolerance[] = {1e-16, 1, NAN};
    struct ct_tether_state s;

    ck_assert_int_eq(ct_linear_flow(paper, paper_gains, paper_start, tolerance[_i], 1, &t, &s), CT_DOMAIN);
    ck_assert_double_nan(s.theta);
}

TEST(eq40_flow_takes_the_tolerance_of_a_rounding)
{
    const double t = 1;
    struct ct_tether_state s;

    ck_assert_int_eq(ct_linear_flow(paper, paper_gains, paper_start, 0x1p-52, 1, &t, &s), CT_OK);
}

TEST(eq40_flow_outside_its_domain_leaves_no_state_unset)
{
    const double t[] = {1, 2, 3};
    struct ct_tether_state s[3] = {{0}};

    ck_assert_int_eq(ct_linear_flow(paper, paper_gains, paper_start, 1, 3, t, s), CT_DOMAIN);
    for (int i = 0; i < 3; i++)
        ck_assert_double_nan(s[i].theta);
    ck_assert_int_eq(ct_linear_flow(paper, paper_gains, (struct ct_tether_state){.theta_dot = INFINITY}, fine, 1, t, s), CT_DOMAIN);
}

static struct ct_hill_state in_hill_frame(struct ct_params p, struct ct_tether_state s)
{
    const struct ct_spherical c = {p.L_ref + s.dL, s.psi, s.theta};
    const struct ct_vector r = ct_position(p, c);
    const struct ct_vector v = ct_velocity(p, c, (struct ct_spherical_rate){s.dL_dot, s.psi_dot, s.theta_dot});

    return (struct ct_hill_state){r.x, r.y, r.z, v.x, v.y, v.z};
}

/* All forces grow as the lengths do, and the noise is measured by them: with powers of 2 all is to scale. */
TEST(eq03_flow_is_to_scale)
{
    const double t = 50000, scale[] = {0x1p-20, 0x1p20};
    const struct ct_hill_state start = in_hill_frame(unequal, paper_start);
    struct ct_hill_state one, s;

    ck_assert_int_eq(ct_nonlinear_flow(unequal, unequal_gains, start, 1e-9, 1, &t, &one), CT_OK);
    for (int i = 0; i < 2; i++) {
        const double k = scale[i];
        const struct ct_hill_state scaled = {k * start.x1, k * start.y1, k * start.z1, k * start.x1_dot, k * start.y1_dot,
                                             k * start.z1_dot};
        struct ct_params p = unequal;
        p.L_ref *= k;
        ck_assert_int_eq(ct_nonlinear_flow(p, unequal_gains, scaled, 1e-9, 1, &t, &s), CT_OK);
        ck_assert_double_eq(s.x1, k * one.x1);
        ck_assert_double_eq(s.z1_dot, k * one.z1_dot);
    }
}

TEST(eq03_flow_rests_where_eq05_says)
{
    const struct ct_hill_state rest = {.x1 = ct_static_positions(unequal, unequal.L_ref).x1};
    const double t = 1e5;
    struct ct_hill_state s;

    ck_assert_int_eq(ct_nonlinear_flow(unequal, unequal_gains, rest, fine, 1, &t, &s), CT_OK);
    assert_close(s.x1, rest.x1, 64); /* forces that cancel but for about sixteen roundings, and a stable motion */
    ck_assert_double_eq_tol(s.y1, 0, 64 * 0x1p-53 * rest.x1);
    ck_assert_double_eq(s.z1, 0);
}

/* On the orbit normal only the attraction and the tide act, and both draw the craft together. */
TEST(eq03_flow_reports_a_collision)
{
    const double t[] = {100, 1e6};
    struct ct_hill_state s[2];

    ck_assert_int_eq(ct_nonlinear_flow(unequal, (struct ct_gains){0, 0}, (struct ct_hill_state){.z1 = 10}, 1e-10, 2, t, s),
                     CT_CONVERGENCE);
    ck_assert_double_lt(s[0].z1, 10);
    ck_assert_double_nan(s[1].z1);
    ck_assert_double_nan(s[1].x1_dot);
}

TEST(eq03_flow_rejects_the_origin)
{
    const double t = 1;
    struct ct_hill_state s;

    ck_assert_int_eq(ct_nonlinear_flow(paper, paper_gains, (struct ct_hill_state){.x1_dot = 1}, fine, 1, &t, &s), CT_DOMAIN);
    ck_assert_double_nan(s.x1);
}

/* Along an eigenvector a step multiplies by 1 + a + a^2/2 + a^3/6 + a^4/24, a = 0.1. Two steps of 0.05 would give ...1255. */
TEST(eq40_runge_kutta_step_is_the_classical_one)
{
    const double t[] = {0, 0.1};
    struct ct_tether_state s[2];

    ck_assert_int_eq(ct_linear_runge_kutta(unit, growing, growing_start, 0.1, 2, t, s), CT_OK);
    ck_assert_double_eq(s[0].dL, -8);
    assert_close(s[1].psi, 1.10517083333333333, 16); /* about four roundings a stage */
    assert_close(s[1].dL, -8 * 1.10517083333333333, 16);
    assert_close(s[1].psi_dot, 1.10517083333333333, 16);
}

TEST(eq40_runge_kutta_reports_overflow)
{
    const double t[] = {0, 1e5};
    struct ct_tether_state s[2];

    ck_assert_int_eq(ct_linear_runge_kutta(unit, growing, growing_start, 1, 2, t, s), CT_CONVERGENCE);
    ck_assert_double_eq(s[0].psi, 1);
    ck_assert_double_nan(s[1].psi);
}

/* The four stages stay below 1.7977e308, the largest double; what they add up to does not. */
TEST(eq40_runge_kutta_reports_overflow_of_the_last_step)
{
    const struct ct_tether_state start = {.dL = 1.756e308, .dL_dot = 1e307};
    const double t = 0.7;
    struct ct_tether_state s;

    ck_assert_int_eq(ct_linear_runge_kutta(unit, (struct ct_gains){9, 0}, start, 0.7, 1, &t, &s), CT_CONVERGENCE);
    ck_assert_double_nan(s.dL);
}

/* Times that whole steps of 100 s from zero do not reach one after the other. */
EACH(eq40_runge_kutta_rejects_times_off_its_steps, 7)
{
    const double times[][2] = {{50, 100}, {100, 150}, {200, 100}, {-100, 0}, {NAN, 100}, {0, NAN}, {0, INFINITY}};
    struct ct_tether_state s[2];

    ck_assert_int_eq(ct_linear_runge_kutta(paper, paper_gains, paper_start, 100, 2, times[_i], s), CT_DOMAIN);
    ck_assert_double_nan(s[0].psi);
    ck_assert_double_nan(s[1].psi);
}

TEST(eq40_runge_kutta_rejects_more_steps_than_can_be_counted)
{
    const double t = 1;
    struct ct_tether_state s;

    ck_assert_int_eq(ct_linear_runge_kutta(paper, paper_gains, paper_start, 0x1p-60, 1, &t, &s), CT_DOMAIN);
    ck_assert_int_eq(ct_linear_runge_kutta(paper, paper_gains, paper_start, 0x1p-53, 1, &t, &s), CT_DOMAIN);

    const double most = 0x1p52; /* can be counted; this motion overflows long before */
    ck_assert_int_eq(ct_linear_runge_kutta(unit, growing, growing_start, 1, 1, &most, &s), CT_CONVERGENCE);
}

TEST(eq40_runge_kutta_compares_each_time_with_the_last)
{
    const double back[] = {200, 400, 300}, before[] = {-0.5, 0}, around[] = {1e9, 100, 100, 300};
    struct ct_tether_state s[3];

    ck_assert_int_eq(ct_linear_runge_kutta(paper, paper_gains, paper_start, 100, 3, back, s), CT_DOMAIN);
    ck_assert_int_eq(ct_linear_runge_kutta(paper, paper_gains, paper_start, 0.5, 2, before, s), CT_DOMAIN);
    ck_assert_int_eq(ct_linear_runge_kutta(paper, paper_gains, paper_start, 100, 3, around + 1, s), CT_OK);
}

/* Half a step at -2 m/s takes craft 1 from 1 m into the origin, where (3) has no value. */
TEST(eq03_runge_kutta_reports_craft_in_one_point)
{
    const struct ct_params p = {1, 1, 1, 1, 1};
    const struct ct_hill_state start = {.z1 = 1, .z1_dot = -2};
    const double t = 1;
    struct ct_hill_state s;

    ck_assert_int_eq(ct_nonlinear_runge_kutta(p, (struct ct_gains){0, 0}, start, 1, 1, &t, &s), CT_CONVERGENCE);
    ck_assert_double_nan(s.z1);
}

TEST(eq03_eq40_runge_kutta_say_what_is_outside)
{
    const struct ct_params p = {1, 1, 1, 1, -1};
    const double t = 1;
    struct ct_tether_state linear;
    struct ct_hill_state nonlinear;

    ck_assert_int_eq(ct_linear_runge_kutta(p, (struct ct_gains){1, 1}, (struct ct_tether_state){.dL = 1}, 1, 1, &t, &linear), CT_DOMAIN);
    ck_assert_int_eq(ct_nonlinear_runge_kutta(p, (struct ct_gains){1, 1}, (struct ct_hill_state){.x1 = 1}, 1, 1, &t, &nonlinear), CT_DOMAIN);
}

/* ---- N craft ---- */

/* Two craft that keep the charges of rest move as (3) has it with both gains 0; both craft, and in times back and forth. */
TEST(eq02_flow_of_two_is_that_of_eq03)
{
    const double q = sqrt(-ct_reference_charge_product(unequal, unequal.L_ref));
    const struct ct_hill_state start = {16, 3, -2, 1e-4, -2e-4, 3e-4};
    const struct ct_vector r2 = ct_second_position(unequal, (struct ct_vector){16, 3, -2});
    const struct ct_vector v2 = ct_second_position(unequal, (struct ct_vector){1e-4, -2e-4, 3e-4});
    const struct ct_craft craft[] = {{unequal.m1, q, {16, 3, -2}, {1e-4, -2e-4, 3e-4}}, {unequal.m2, -q, r2, v2}};
    const double t[] = {9000, 0, -9000, 4000};
    struct ct_hill_state due[4];
    struct ct_craft moved[8];

    ck_assert_int_eq(ct_nonlinear_flow(unequal, (struct ct_gains){0, 0}, start, fine, 4, t, due), CT_OK);
    ck_assert_int_eq(ct_formation_flow(unequal.Omega, unequal.k_c, INFINITY, 2, craft, fine, 4, t, moved), CT_OK);
    for (int i = 0; i < 4; i++) { /* some hundred steps of 1e-13 each, lengths of 20 m and velocities of 1e-3 m/s */
        const struct ct_craft one = moved[2 * i], two = moved[2 * i + 1];
        ck_assert_double_eq_tol(one.position.x, due[i].x1, 1e-9);
        ck_assert_double_eq_tol(one.position.y, due[i].y1, 1e-9);
        ck_assert_double_eq_tol(one.position.z, due[i].z1, 1e-9);
        ck_assert_double_eq_tol(one.velocity.x, due[i].x1_dot, 1e-13);
        ck_assert_double_eq_tol(one.velocity.y, due[i].y1_dot, 1e-13);
        ck_assert_double_eq_tol(one.velocity.z, due[i].z1_dot, 1e-13);
        ck_assert_double_eq_tol(two.position.y, -unequal.m1 / unequal.m2 * due[i].y1, 1e-9);
        ck_assert_double_eq(one.m, unequal.m1);
        ck_assert_double_eq(two.q, -q);
    }
}

/* Clohessy and Wiltshire's solution: x = 4 - 3 cos nt, y = 6 (sin nt - nt), z = cos nt from (1, 0, 1) at rest. */
TEST(eq02_flow_of_one_is_the_free_motion)
{
    const struct ct_craft craft = {1, 5, {1, 0, 1}, {0, 0, 0}};
    struct ct_craft moved;

    for (int way = -1; way <= 1; way += 2) {
        const double t = 10 * way;
        ck_assert_int_eq(ct_formation_flow(0.5, 1, 1, 1, &craft, fine, 1, &t, &moved), CT_OK);
        ck_assert_double_eq_tol(moved.position.x, 4 - 3 * cos(5), 1e-11); /* along-track error of some tens of steps */
        ck_assert_double_eq_tol(moved.position.y, 6 * way * (sin(5) - 5), 1e-11);
        ck_assert_double_eq_tol(moved.position.z, cos(5), 1e-11);
        ck_assert_double_eq_tol(moved.velocity.x, 1.5 * way * sin(5), 1e-11);
    }
}

/* Of three: back at t = 0 each is where it was, to the bit. */
TEST(eq02_flow_of_three_begins_anew_on_its_way_back)
{
    const struct ct_craft craft[] = {{1, 2, {1, 2, 3}, {4, 5, 6}}, {2, -1, {-7, 8, -9}, {1, -2, 3}}, {3, 1, {10, -11, 12}, {-3, 2, 1}}};
    const double t[] = {0.1, 0};
    struct ct_craft moved[6];

    ck_assert_int_eq(ct_formation_flow(0.5, 1, 1, 3, craft, 1e-9, 2, t, moved), CT_OK);
    for (int j = 0; j < 3; j++) {
        ck_assert_double_eq(moved[3 + j].position.x, craft[j].position.x);
        ck_assert_double_eq(moved[3 + j].position.y, craft[j].position.y);
        ck_assert_double_eq(moved[3 + j].position.z, craft[j].position.z);
        ck_assert_double_eq_tol(moved[3 + j].velocity.z, craft[j].velocity.z, 1e-15); /* over Omega and times Omega */
    }
}

TEST(eq02_flow_reports_a_collision_and_keeps_what_does_not_move)
{
    const struct ct_craft craft[] = {{1, 2, {0, 0, 1}, {0, 0, 0}}, {3, -4, {0, 0, -1}, {0, 0, 0}}};
    const double t = 100;
    struct ct_craft moved[2];

    ck_assert_int_eq(ct_formation_flow(1e-3, 1, INFINITY, 2, craft, 1e-9, 1, &t, moved), CT_CONVERGENCE);
    ck_assert_double_nan(moved[0].position.x);
    ck_assert_double_nan(moved[1].velocity.z);
    ck_assert_double_eq(moved[1].m, 3);
    ck_assert_double_eq(moved[1].q, -4);
}

static int formation_status(size_t N, const struct ct_craft *craft, double tolerance)
{
    const double t = 1;
    struct ct_craft moved[2] = {{.m = 0}};
    const int status = ct_formation_flow(1, 1, INFINITY, N, craft, tolerance, N <= 2, &t, moved);

    if (N == 1 || N == 2)
        ck_assert(isnan(moved[N - 1].position.z) == (status != CT_OK));
    return status;
}

TEST(eq02_flow_rejects_what_is_no_formation)
{
    const struct ct_craft together[] = {{1, 1, {1, 2, 3}, {0, 0, 0}}, {1, 1, {1, 2, 3}, {0, 0, 0}}};
    const struct ct_craft beyond[] = {{1, 1e200, {1, 2, 3}, {0, 0, 0}}, {1, 1e200, {1, 2, 4}, {0, 0, 0}}};
    volatile size_t too_many = SIZE_MAX / 64;

    ck_assert_int_eq(formation_status(1, together, 1e-9), CT_OK);
    ck_assert_int_eq(formation_status(1, together, 0), CT_DOMAIN);
    ck_assert_int_eq(formation_status(2, together, 1e-9), CT_DOMAIN);
    ck_assert_int_eq(formation_status(2, beyond, 1e-9), CT_DOMAIN); /* forces that no double holds */
    ck_assert_int_eq(formation_status(0, NULL, 1e-9), CT_DOMAIN);
    ck_assert_int_eq(formation_status(too_many, NULL, 1e-9), CT_MEMORY);
}

static size_t formation_flow(const double x[], double y[])
{
    const struct ct_craft craft = {x[3], x[4], {x[5], x[6], x[7]}, {x[8], x[9], x[10]}};
    struct ct_craft moved;
    const int status = ct_formation_flow(x[0], x[1], x[2], 1, &craft, 1e-9, 1, &x[11], &moved);

    ck_assert_int_eq(status, isnan(moved.position.x) ? CT_DOMAIN : CT_OK);
    memcpy(y, &moved.position, 6 * sizeof *y);
    return 6;
}

TEST(eq02_flow_rejects_each_input_outside_its_domain)
{
    assert_rejects_outside(formation_flow, "++i+rrrrrrrr", (const double[]){1, 2, 3, 4, 5, 6, -7, 8, -9, 10, -11, 0.1});
}
