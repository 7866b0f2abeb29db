/*
 * ref/perturbation.c: Eqs. (9) to (17)
 */
#include "tests/run.h"

#include <string.h>

#include "coulombtether.h"

static const struct ct_params unequal = {7.2915e-5, 8.99e9, 120, 410, 23};

/* Craft of 2 kg and 1 kg where Omega = k_c = 1: craft 1 is a third of the distance from the origin; (3, 4, 12) is 13 m. */
static const struct ct_params whole = {1, 1, 2, 1, NAN};

static const double quarter_turn = 1.57079632679489661923;

/* Attitudes in all quadrants of yaw, pitched up and down. */
static const double angles[][2] = {{0.3, 0.2}, {2.1, -1.4}, {-2.9, 0.7}, {-0.8, -0.1}, {3.1, 1.5}};
enum { ATTITUDES = sizeof angles / sizeof angles[0] };

static struct ct_params masses(const double x[])
{
    return (struct ct_params){NAN, NAN, x[0], x[1], NAN};
}

static struct ct_hill_state hill_state(const double x[])
{
    return (struct ct_hill_state){x[0], x[1], x[2], x[3], x[4], x[5]};
}

static double scalar_product(struct ct_vector a, struct ct_vector b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

TEST(eq09_is_the_identity_at_zero)
{
    const struct ct_matrix BO = ct_direction_cosines(0, 0);

    for (int j = 0; j < 3; j++)
        for (int k = 0; k < 3; k++)
            ck_assert_double_eq(BO.e[j][k], j == k);
}

TEST(eq10_lies_on_the_nadir_line_at_zero)
{
    const struct ct_vector r1 = ct_position(whole, (struct ct_spherical){12, 0, 0});

    ck_assert_double_eq_tol(r1.x, 4, 2 * 0x1p-51); /* a third of 12, two roundings */
    ck_assert_double_eq(r1.y, 0);
    ck_assert_double_eq(r1.z, 0);
}

/* Taylor: the terms left out are of second order, the largest of them r (psi^2 + theta^2)/2 along x. */
TEST(eq10_small_angles_err_by_their_square)
{
    const struct ct_spherical c = {53, 1e-4, -2e-4};
    const struct ct_vector exact = ct_position(unequal, c), linear = ct_position_small_angles(unequal, c);
    const double r = linear.x, squares = c.psi * c.psi + c.theta * c.theta;

    /* the terms of fourth order are 1e-8 of this one, and so are the roundings of 41 m */
    ck_assert_double_eq_tol(linear.x - exact.x, r * squares / 2, 1e-7 * r * squares);
    ck_assert_double_eq_tol(linear.y, exact.y, r * squares * 1e-4);
    ck_assert_double_eq_tol(linear.z, exact.z, r * squares * 1e-4);
}

TEST(eq10_inverse_has_no_yaw_on_the_orbit_normal)
{
    const struct ct_spherical up = ct_spherical_coordinates(whole, (struct ct_vector){-0.0, -0.0, 5});
    const struct ct_spherical down = ct_spherical_coordinates(whole, (struct ct_vector){-0.0, 0.0, -5});

    ck_assert_double_eq(up.psi, 0);
    ck_assert_double_eq(down.psi, 0);
    ck_assert_double_eq(up.theta, -quarter_turn);
    ck_assert_double_eq(down.theta, quarter_turn);
}

TEST(eq10_inverse_takes_a_negative_zero_for_zero)
{
    const struct ct_spherical behind = ct_spherical_coordinates(whole, (struct ct_vector){-5, -0.0, -0.0});
    const struct ct_spherical ahead = ct_spherical_coordinates(whole, (struct ct_vector){5, -0.0, 0.0});

    ck_assert_double_eq(behind.psi, 2 * quarter_turn); /* not minus half a turn */
    ck_assert_int_eq(!!signbit(behind.theta), 0);
    ck_assert_int_eq(!!signbit(ahead.psi), 0);
    ck_assert_int_eq(!!signbit(ahead.theta), 0);
}

/* In spherical coordinates v^2 = r_dot^2 + r^2 (theta_dot^2 + cos^2(theta) psi_dot^2). */
EACH(eq11_exact_has_the_speed_of_spherical_coordinates, ATTITUDES)
{
    const struct ct_spherical c = {12, angles[_i][0], angles[_i][1]};
    const struct ct_vector v1 = ct_velocity(whole, c, (struct ct_spherical_rate){-3, 0.5, 0.25});
    const double across = 2 * cos(c.theta);

    assert_close(scalar_product(v1, v1), 1 + 1 + across * across, 32); /* twice some sixteen roundings */
}

TEST(eq11_is_exact_at_zero_angles)
{
    const struct ct_spherical c = {8, 0, 0};
    const struct ct_spherical_rate c_dot = {-0.5, 0.3, -0.2};
    const struct ct_vector exact = ct_velocity(unequal, c, c_dot), linear = ct_velocity_small_angles(unequal, c, c_dot);

    assert_close(linear.x, exact.x, 4); /* the products in another order */
    assert_close(linear.y, exact.y, 4);
    assert_close(linear.z, exact.z, 4);
}

TEST(eq12_neither_overflows_nor_vanishes)
{
    const struct ct_vector origin = {0, 0, 0};

    assert_close(ct_distance((struct ct_vector){3e200, 4e200, 0}, origin), 5e200, 4);
    assert_close(ct_distance((struct ct_vector){0, 3e-200, 4e-200}, origin), 5e-200, 4);
}

TEST(eq13_agrees_with_eq04_and_eq12)
{
    const struct ct_vector r1 = {5, -7, 0.25};

    assert_close(ct_separation(unequal, r1), ct_distance(r1, ct_second_position(unequal, r1)), 8);
}

EACH(eq13_rate_comes_back_from_eq11, ATTITUDES)
{
    const struct ct_spherical c = {23.5, angles[_i][0], angles[_i][1]};
    const struct ct_spherical_rate c_dot = {-2, 0.1, 0.2};
    const struct ct_vector r = ct_position(unequal, c), v = ct_velocity(unequal, c, c_dot);
    const struct ct_hill_state s = {r.x, r.y, r.z, v.x, v.y, v.z};

    /* r.v takes up to sixteen roundings of r |v|, and with L = 23.5 m |v| is up to three times L_dot */
    assert_close(ct_separation_rate(unequal, s), -2, 48);
}

static size_t eq13_rate(const double x[], double y[])
{
    y[0] = ct_separation_rate(masses(x), hill_state(x + 2));
    return 1;
}

TEST(eq13_rate_rejects_each_input_outside_its_domain)
{
    assert_rejects_outside(eq13_rate, "++rrrrrr", (const double[]){1, 2, 3, -4, 5, -6, 7, -8});
}

TEST(eq13_rate_rejects_the_origin)
{
    ck_assert_double_nan(ct_separation_rate(whole, (struct ct_hill_state){0, 0, 0, 1, 2, 3}));
}

/* Along the line of the craft nothing turns: v1.v1 - L_dot^2 m2^2/M^2 vanishes and 3 r1.a1/r is left, r1.a1 = 27 - 144. */
TEST(eq14_motion_along_the_line_adds_nothing)
{
    const struct ct_hill_state s = {3, 4, 12, 3e8, 4e8, 12e8};

    assert_close(ct_separation_acceleration(whole, s, 0), 3 * (27.0 - 144) / 13, 8);
}

TEST(eq15_uncharged_craft_at_rest_drift_apart)
{
    const struct ct_params p = {2, 8.99e9, 120, 410, NAN};

    ck_assert_double_eq(ct_separation_acceleration_small_angles(p, 7, 0, 0), 3 * 4 * 7);
}

/* What (15) gives at L_ref + e dL, e psi_dot, Q_ref + e dQ, less what it gives at -e, over 2 e, is (17) but for e^2. */
TEST(eq17_linearises_eq15)
{
    const struct ct_params p = unequal;
    const double psi_dot = -3e-5, dL = 2, dQ = 4e-13, Q_ref = ct_reference_charge_product(p, p.L_ref), e = 0x1p-13;
    const double after =
        ct_separation_acceleration_small_angles(p, p.L_ref + e * dL, e * psi_dot, Q_ref + e * dQ);
    const double before =
        ct_separation_acceleration_small_angles(p, p.L_ref - e * dL, -e * psi_dot, Q_ref - e * dQ);
    const double scale = 9 * p.Omega * p.Omega * dL;

    /* e^2 = 1.5e-8 times (dL/L_ref)^2 below 0.01, and roundings of 3 Omega^2 L_ref over e: 5e-12 of scale */
    ck_assert_double_eq_tol((after - before) / (2 * e), ct_length_error_acceleration(p, psi_dot, dL, dQ), 1e-9 * scale);
}

/* ---- whole states ---- */

static size_t tether_to_hill(const double x[], double y[])
{
    const struct ct_params p = {NAN, NAN, x[0], x[1], x[2]};
    const struct ct_hill_state s = ct_hill_state_of_tether(p, (struct ct_tether_state){x[3], x[4], x[5], x[6], x[7], x[8]});

    memcpy(y, &s, sizeof s);
    return 6;
}

static size_t hill_to_tether(const double x[], double y[])
{
    const struct ct_params p = {NAN, NAN, x[0], x[1], x[2]};
    const struct ct_tether_state s = ct_tether_state_of_hill(p, (struct ct_hill_state){x[3], x[4], x[5], x[6], x[7], x[8]});

    memcpy(y, &s, sizeof s);
    return 6;
}

/* However near to the z axis: 1/4 m is half of 1/2 m, 9 1/2 m less than the paper's 10 m. */
TEST(eq10_inverse_knows_a_short_pair)
{
    const struct ct_params table1 = CT_TABLE1;
    const struct ct_tether_state s = ct_tether_state_of_hill(table1, (struct ct_hill_state){.x1 = 0.25});

    ck_assert_double_eq(s.psi, 0);
    ck_assert_double_eq(s.dL, -9.5);
}

EACH(eq10_state_and_its_inverse_make_a_round_trip, ATTITUDES)
{
    const double dL = 0.25, psi_dot = -3e-5, theta_dot = 2e-5, dL_dot = 4e-4, masses[] = {unequal.m1, unequal.m2, unequal.L_ref};
    double x[9], back[9];

    memcpy(x, masses, sizeof masses);
    memcpy(back, masses, sizeof masses);
    memcpy(x + 3, (const double[]){angles[_i][0], angles[_i][1], dL, psi_dot, theta_dot, dL_dot}, 6 * sizeof *x);
    tether_to_hill(x, back + 3);
    hill_to_tether(back, x + 3);
    /* u of an angle below pi; the length error is the difference of lengths of 23 m; at 1.5 rad of pitch yaw has an arm of
       a fourteenth of the tether, and as many roundings more */
    ck_assert_double_eq_tol(x[3], angles[_i][0], 1e-14);
    ck_assert_double_eq_tol(x[4], angles[_i][1], 1e-14);
    ck_assert_double_eq_tol(x[5], dL, 1e-13);
    ck_assert_double_eq_tol(x[6], psi_dot, 1e-18);
    ck_assert_double_eq_tol(x[7], theta_dot, 1e-18);
    ck_assert_double_eq_tol(x[8], dL_dot, 1e-17);
}

/* Three metres off along the radius, half of that by craft 1, which goes up and ahead: by hand. */
TEST(eq10_state_on_the_radius)
{
    double y[6];

    hill_to_tether((const double[]){2, 2, 1, 1.5, 0, 0, 0.5, 3, -6}, y);
    ck_assert_double_eq(y[2], 2);
    ck_assert_double_eq(y[3], 2);
    ck_assert_double_eq(y[4], 4);
    ck_assert_double_eq(y[5], 1);
}

TEST(eq10_state_on_the_orbit_normal_has_no_yaw)
{
    double y[6];

    for (size_t k = hill_to_tether((const double[]){1, 2, 3, 0, 0, 5, 1, 2, 3}, y); k-- > 0;)
        ck_assert_double_nan(y[k]);
}

TEST(eq10_states_reject_each_input_outside_their_domain)
{
    assert_rejects_outside(tether_to_hill, "+++rrrrrr", (const double[]){1, 2, 3, -4, 5, 6, -7, 8, -9});
    assert_rejects_outside(hill_to_tether, "+++rrrrrr", (const double[]){1, 2, 3, -4, 5, 6, -7, 8, -9});
}

TEST(eq10_state_rejects_craft_that_are_not_apart)
{
    double y[6];

    for (size_t k = tether_to_hill((const double[]){1, 2, 3, 0, 0, -3, 1, 2, 3}, y); k-- > 0;)
        ck_assert_double_nan(y[k]);
}
