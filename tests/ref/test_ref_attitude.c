/*
 * ref/attitude.c: Eqs. (25) to (39)
 */
#include "tests/run.h"

#include <string.h>

#include "coulombtether.h"

static const struct ct_params unequal = {7.2915e-5, 8.99e9, 120, 410, 23};
static const double pitches[] = {0.2, -1.4, 0.7, -2.9, 1.57};
enum { PITCHES = sizeof pitches / sizeof pitches[0] };

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

TEST(eq37_does_not_overflow_with_the_fifth_power)
{
    /* 3 * 1e200/1e100^3 * 1e100 * (3/5)(4/5), while 1e100^5 has no double */
    assert_close(ct_gravity_gradient(1e200, (struct ct_vector){6e99, 8e99, 0}, 1e100).z, 1.44, 16);
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
