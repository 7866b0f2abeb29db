/*
 * ref/attitude.c: Eqs. (25) to (39)
 */
#include "tests/run.h"

#include <string.h>

#include "coulombtether.h"

static const struct ct_params unequal = {7.2915e-5, 8.99e9, 120, 410, 23};
static const double pitches[] = {0.2, -1.4, 0.7, -2.9, 1.57};
enum { PITCHES = sizeof pitches / sizeof pitches[0] };

static double scalar_product(struct ct_vector a, struct ct_vector b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

EACH(eq25_is_the_third_column_of_eq09, PITCHES)
{
    const double theta = pitches[_i];
    const struct ct_matrix BO = ct_direction_cosines(2, theta); /* whatever the yaw */
    const struct ct_vector omega = ct_orbit_angular_velocity(3, theta);

    ck_assert_double_eq(omega.x, 3 * BO.e[0][2]);
    ck_assert_double_eq(omega.y, 3 * BO.e[1][2]);
    ck_assert_double_eq(omega.z, 3 * BO.e[2][2]);
}

TEST(eq26_level_body_yaws_about_its_third_axis)
{
    const struct ct_vector omega = ct_relative_angular_velocity(0, 5, -7);

    ck_assert_double_eq(omega.x, 0);
    ck_assert_double_eq(omega.y, -7);
    ck_assert_double_eq(omega.z, 5);
}

EACH(eq26_yaw_and_pitch_axes_are_perpendicular, PITCHES)
{
    const struct ct_vector omega = ct_relative_angular_velocity(pitches[_i], -3, 4);

    assert_close(scalar_product(omega, omega), 9 + 16, 8);
}

/* What carries the columns of [BO] along: d/dt (BO v) = -omega x (BO v) for v at rest in the orbit frame. */
EACH(eq26_turns_eq09, PITCHES)
{
    const double psi = 0.4, theta = pitches[_i], psi_dot = 0.5, theta_dot = -0.25, h = 0x1p-17;
    const struct ct_matrix now = ct_direction_cosines(psi, theta);
    const struct ct_matrix after = ct_direction_cosines(psi + h * psi_dot, theta + h * theta_dot);
    const struct ct_matrix before = ct_direction_cosines(psi - h * psi_dot, theta - h * theta_dot);
    const struct ct_vector w = ct_relative_angular_velocity(theta, psi_dot, theta_dot);

    for (int k = 0; k < 3; k++) {
        const double v[3] = {now.e[0][k], now.e[1][k], now.e[2][k]};
        const double turned[3] = {w.z * v[1] - w.y * v[2], w.x * v[2] - w.z * v[0], w.y * v[0] - w.x * v[1]};
        for (int j = 0; j < 3; j++) /* the difference quotient errs by h^2 = 6e-11, and by 2^-53/h = 1.5e-11 */
            ck_assert_double_eq_tol((after.e[j][k] - before.e[j][k]) / (2 * h), turned[j], 2e-10);
    }
}

/* Yaw and orbit turn about the same axis, across that of the pitch. */
EACH(eq27_adds_yaw_rate_and_orbit_rate, PITCHES)
{
    const struct ct_vector omega = ct_angular_velocity(5, pitches[_i], -2, 4);

    assert_close(scalar_product(omega, omega), 9 + 16, 16);
    ck_assert_double_eq(omega.y, 4);
}

EACH(eq27_vanishes_against_the_orbit, PITCHES)
{
    const struct ct_vector omega = ct_angular_velocity(5, pitches[_i], -5, 0);

    ck_assert_double_eq(omega.x, 0);
    ck_assert_double_eq(omega.z, 0);
}

TEST(eq28_errs_from_eq27_by_second_order)
{
    const double e = 1e-5;
    const struct ct_vector exact = ct_angular_velocity(1, e, 2 * e, -3 * e);
    const struct ct_vector linear = ct_angular_velocity_small_angles(1, e, 2 * e, -3 * e);

    ck_assert_double_eq_tol(linear.x, exact.x, 3 * e * e); /* the term left out is theta psi_dot = 2 e^2 */
    ck_assert_double_eq(linear.y, exact.y);
    ck_assert_double_eq_tol(linear.z, exact.z, e * e); /* the term left out is theta^2/2 */
}

/* (28) is linear, so that its rate is its own value at the rates, the constant left out. */
TEST(eq29_is_the_rate_of_eq28)
{
    const struct ct_vector rate = ct_angular_acceleration_small_angles(2, -3, 7, 5);
    const struct ct_vector at_rates = ct_angular_velocity_small_angles(2, -3, 5, 7);

    ck_assert_double_eq(rate.x, at_rates.x);
    ck_assert_double_eq(rate.y, at_rates.y);
    ck_assert_double_eq(rate.z, at_rates.z - 2);
}

TEST(eq30_is_symmetric)
{
    const struct ct_matrix inertia =
        ct_inertia_matrix(unequal, (struct ct_vector){1.1, -2.3, 3.7}, (struct ct_vector){-4.1, 5.3, 6.7});
    const struct ct_matrix none = ct_inertia_matrix(unequal, (struct ct_vector){NAN, 0, 0}, (struct ct_vector){0, 0, 0});

    for (int j = 0; j < 3; j++)
        for (int k = 0; k < j; k++) {
            ck_assert_double_eq(inertia.e[j][k], inertia.e[k][j]);
            ck_assert_double_nan(none.e[j][k]); /* and so it is where there is none */
        }
}

TEST(eq30_of_the_tether_has_the_inertia_of_eq32)
{
    const struct ct_static_places at = ct_static_positions(unequal, 23);
    const struct ct_matrix inertia =
        ct_inertia_matrix(unequal, (struct ct_vector){at.x1, 0, 0}, (struct ct_vector){at.x2, 0, 0});

    ck_assert_double_eq(inertia.e[0][0], 0); /* (31): none about the line itself */
    assert_close(inertia.e[1][1], ct_inertia(unequal, 23), 16);
    assert_close(inertia.e[2][2], ct_inertia(unequal, 23), 16);
}

TEST(eq32_whole_numbers)
{
    ck_assert_double_eq(ct_inertia((struct ct_params){.m1 = 1, .m2 = 3}, 2), 3);
}

/* I is a square: its central difference is exact for any step. */
TEST(eq34_is_the_rate_of_eq32)
{
    const double quotient = (ct_inertia(unequal, 23 + 4) - ct_inertia(unequal, 23 - 4)) / 8;

    assert_close(ct_inertia_rate(unequal, 23, 1), quotient, 16);
}

EACH(eq36_is_the_first_column_of_eq09, PITCHES)
{
    const double psi = -0.9, theta = pitches[_i];
    const struct ct_matrix BO = ct_direction_cosines(psi, theta);
    const struct ct_vector R_c = ct_centre_position(4, psi, theta); /* a power of two scales without rounding */

    ck_assert_double_eq(R_c.x, 4 * BO.e[0][0]);
    ck_assert_double_eq(R_c.y, 4 * BO.e[1][0]);
    ck_assert_double_eq(R_c.z, 4 * BO.e[2][0]);
}

TEST(eq37_has_no_torque_about_the_vertical)
{
    const struct ct_vector R_c = {3e6, -4e7, 7e6};
    const struct ct_vector torque = ct_gravity_gradient(3.986e14, R_c, 1e4);

    ck_assert_double_le(fabs(scalar_product(torque, R_c)), 16 * 0x1p-53 * fabs(torque.y * R_c.y));
}

TEST(eq37_vanishes_in_equilibrium)
{
    const struct ct_vector upright = ct_gravity_gradient(1, (struct ct_vector){-7, 0, 0}, 5);
    const struct ct_vector massless = ct_gravity_gradient(1, (struct ct_vector){1, 2, 3}, 0);

    ck_assert_double_eq(upright.y, 0);
    ck_assert_double_eq(upright.z, 0);
    ck_assert_double_eq(massless.y, 0);
    ck_assert_double_eq(massless.z, 0);
}

TEST(eq37_does_not_overflow_with_the_fifth_power)
{
    /* 3 * 1e200/1e100^3 * 1e100 * (3/5)(4/5), while 1e100^5 has no double */
    assert_close(ct_gravity_gradient(1e200, (struct ct_vector){6e99, 8e99, 0}, 1e100).z, 1.44, 16);
}

TEST(eq38_is_keplers_third_law)
{
    ck_assert_double_eq(ct_orbit_rate(18, 2), 1.5); /* as printed, with 3 GM, this would be 2.6 */
}

TEST(eq38_does_not_overflow_with_the_cube)
{
    assert_close(ct_orbit_rate(4e200, 1e200), 2e-200, 8);
}

TEST(eq39_turns_nothing_without_inertia)
{
    const struct ct_vector torque = ct_gravity_gradient_small_angles(2, 0, 7, -3);

    ck_assert_double_eq(torque.y, 0);
    ck_assert_double_eq(torque.z, 0);
}

TEST(eq39_is_eq37_of_eq36_to_first_order)
{
    const double GM = 4e14, R_c = 4.2e7, I = 1e4, psi = -2e-5, theta = 1e-5;
    const struct ct_vector exact = ct_gravity_gradient(GM, ct_centre_position(R_c, psi, theta), I);
    const struct ct_vector linear = ct_gravity_gradient_small_angles(ct_orbit_rate(GM, R_c), I, psi, theta);

    assert_close(linear.y, exact.y, 1e-9 * 0x1p53); /* terms of third order: 4/3 of 4e-10 and less */
    assert_close(linear.z, exact.z, 1e-9 * 0x1p53);
}

