/*
 * ref/stability.c: Eqs. (40) to (44)
 */
#include "tests/run.h"

#include <complex.h>
#include <string.h>

#include "coulombtether.h"

/* Nothing is lost where time is counted in units of Omega, for this one is a power of two. */
static const double Omega = 0x1p-14;

static struct ct_gains gains(double c1, double c2)
{
    return (struct ct_gains){c1 * Omega * Omega, c2 * Omega};
}

TEST(eq40_pitch_stands_alone)
{
    const struct ct_params p = {.Omega = 2, .L_ref = 4};
    const struct ct_tether_state s = {.theta = 1};
    const struct ct_tether_acceleration a = ct_linear_acceleration(p, (struct ct_gains){40, 6}, s);

    ck_assert_double_eq(a.psi_ddot, 0);
    ck_assert_double_eq(a.dL_ddot, 0);
}

/* Where exp(lambda t) solves (40), the determinant of the two coupled equations is zero, whatever L_ref. */
RANGE(eq41_is_the_determinant_of_eq40, -3, 4)
{
    const double lambda = _i, L_ref = 8, C1 = -7, C2 = 5;
    const struct ct_params p = {.Omega = 2, .L_ref = L_ref};
    const struct ct_gains g = {C1, C2};
    const struct ct_tether_state of_yaw = {.psi = 1, .psi_dot = lambda}, of_length = {.dL = 1, .dL_dot = lambda};
    const struct ct_tether_acceleration yaw = ct_linear_acceleration(p, g, of_yaw);
    const struct ct_tether_acceleration length = ct_linear_acceleration(p, g, of_length);
    const double determinant =
        (lambda * lambda - yaw.psi_ddot) * (lambda * lambda - length.dL_ddot) - length.psi_ddot * yaw.dL_ddot;
    const struct ct_quartic a = ct_characteristic_polynomial(2, g);

    ck_assert_double_eq(a.a0 + lambda * (a.a1 + lambda * (a.a2 + lambda * (a.a3 + lambda * a.a4))), determinant);
}

/*
 * Known roots in units of Omega, in the order of the library; tolerance in roundings of the modulus. Where no closed form
 * stands, the digits are mpmath 1.3's with mp.dps = 30:
 * polyroots([1, c2, c1 - 2, 3*c2, 3*(c1 - 9)], maxsteps=200, extraprec=100).
 */
static const struct {
    double c1, c2;
    double complex root[4];
    double roundings;
} known[] = {
    /* the paper's n = 10, and n = 12 where C2 = 2 sqrt(3) is rounded */
    {10, 2,
     {-0.58407416171241635607 - 2.4961237242929963015 * I, -0.58407416171241635607 + 2.4961237242929963015 * I,
      -0.41592583828758364393 - 0.53245026280109286648 * I, -0.41592583828758364393 + 0.53245026280109286648 * I}, 4},
    {12, 3.4641016151377545871,
     {-1.1359803176724716152 - 2.1040185957563881358 * I, -1.1359803176724716152 + 2.1040185957563881358 * I,
      -0.59607048989640567834 - 1.1040185957563881358 * I, -0.59607048989640567834 + 1.1040185957563881358 * I}, 4},
    /* a real pair of both signs */
    {-4, 2.5,
     {-4.5762165194710752479, -0.074147354242569951367 - 1.9559145554785332368 * I,
      -0.074147354242569951367 + 1.9559145554785332368 * I, 2.2245112279562151506}, 4},
    /* no damping, n = 11: a quadratic in lambda^2, with lambda^2 = (-9 +- sqrt(57))/2 */
    {11, 0,
     {-2.8766155839172141370 * I, -0.85151792838708049799 * I, 0.85151792838708049799 * I, 2.8766155839172141370 * I}, 4},
    /* on both boundaries of (42): lambda^2 (lambda^2 + 7) */
    {9, 0, {-2.6457513110645905905 * I, 0, 0, 2.6457513110645905905 * I}, 4},
    /* (lambda + 1)^2 (lambda^2 + 3/2 lambda + 9/2): where the terms are 28 and half the second derivative is 4, 32 roundings
       of the terms move the double root by sqrt(32 * 2^-53 * 28/4) = 1.6e-7 */
    {10.5, 3.5, {-1, -1, -0.75 - 1.9843134832984429429 * I, -0.75 + 1.9843134832984429429 * I}, 1.6e-7 * 0x1p53},
};
enum { KNOWN = sizeof known / sizeof known[0] };

EACH(eq41_roots_are_the_known_ones, KNOWN)
{
    struct ct_root root[4];

    ck_assert_int_eq(ct_characteristic_roots(Omega, gains(known[_i].c1, known[_i].c2), root), CT_OK);
    for (int k = 0; k < 4; k++) {
        const double complex z = (root[k].re + root[k].im * I) / Omega, expected = known[_i].root[k];
        ck_assert_double_le(cabs(z - expected), known[_i].roundings * 0x1p-53 * cabs(expected));
    }
}

/* lambda^2 is real then: four roots on the imaginary axis where C1 > 9, two on either axis below. The order is exact. */
EACH(eq41_roots_without_damping_lie_on_the_axes, 80)
{
    struct ct_root r[4];
    const double c1 = 9 + 0.37 * (_i < 40 ? _i + 1 : 39 - _i);

    ck_assert_int_eq(ct_characteristic_roots(Omega, gains(c1, 0), r), CT_OK);
    for (int k = 0; k < 4; k++)
        ck_assert((r[k].re == 0) != (r[k].im == 0));
    if (c1 > 9)
        ck_assert(r[0].im < r[1].im && r[1].im < 0 && 0 < r[2].im && r[2].im < r[3].im);
    else
        ck_assert(r[0].re < 0 && r[1].im < 0 && r[2].im > 0 && r[3].re > 0);
}

EACH(eq41_roots_sum_and_multiply_to_the_coefficients, 9)
{
    const double c[][2] = {
        {30, 5}, {-30, 5}, {30, -5}, {-30, -5}, {1e-3, 1e3}, {1e6, 1e-3}, {-1e6, 1e-3}, {1, 1e6},
        {0x1.5be4a6c02af6ap+40, -0x1.b93ffbd6a0a1ap+64}, /* Newton's method creeps here unless it is told to stop */
    };
    struct ct_root root[4];
    double complex sum = 0, product = 1;
    double size = 0;

    ck_assert_int_eq(ct_characteristic_roots(Omega, gains(c[_i][0], c[_i][1]), root), CT_OK);
    for (int k = 0; k < 4; k++) {
        const double complex z = (root[k].re + root[k].im * I) / Omega;
        sum += z;
        product *= z;
        size += cabs(z);
    }
    ck_assert_double_le(cabs(sum + c[_i][1]), 16 * 0x1p-53 * size); /* four roots, a few roundings each */
    ck_assert_double_le(cabs(product / (3 * (c[_i][0] - 9)) - 1), 64 * 0x1p-53);
}

TEST(eq41_root_at_zero_on_the_stability_boundary_is_exact)
{
    struct ct_root root[4];

    ck_assert_int_eq(ct_characteristic_roots(Omega, gains(9, 2), root), CT_OK);
    ck_assert_double_eq(root[3].re, 0);
    ck_assert_double_eq(root[3].im, 0);
    ck_assert_double_lt(root[2].re, 0);
}

TEST(eq41_roots_reject_gains_beyond_double_in_units_of_Omega)
{
    struct ct_root root[4];

    ck_assert_int_eq(ct_characteristic_roots(1e-200, (struct ct_gains){1, 1}, root), CT_DOMAIN);
    ck_assert_double_nan(root[3].im);
}

/* Here GSL takes three of the four for zero, and Newton's method all three to one root: a wrong set must not pass. */
TEST(eq41_roots_report_a_set_that_is_not_complete)
{
    struct ct_root root[4];

    ck_assert_int_eq(ct_characteristic_roots(1, (struct ct_gains){1, 1e100}, root), CT_CONVERGENCE);
    ck_assert_double_nan(root[0].re);
    ck_assert_double_nan(root[3].im);
}

TEST(eq42_boundary_is_not_stable)
{
    ck_assert_int_eq(ct_routh_margins(2, (struct ct_gains){36, 3}).stable, 0);
    ck_assert_int_eq(ct_routh_margins(2, (struct ct_gains){40, 0}).stable, 0);
}

/* Over a grid on both sides of both bounds: all real parts are negative exactly where (42) says so. */
EACH(eq42_is_the_sign_of_the_roots_of_eq41, 48)
{
    const double c1[] = {-20, -5, 0, 3, 8.5, 9.5, 12, 40}, c2[] = {-10, -1, -0.1, 0.1, 1, 10};
    const struct ct_gains g = gains(c1[_i % 8], c2[_i / 8]);
    struct ct_root root[4];

    ck_assert_int_eq(ct_characteristic_roots(Omega, g, root), CT_OK);
    ck_assert_int_eq(ct_routh_margins(Omega, g).stable, root[3].re < 0); /* the last has the largest real part */
}

static size_t eq42(const double x[], double y[])
{
    const struct ct_margins m = ct_routh_margins(x[0], (struct ct_gains){x[1], x[2]});

    if (isnan(m.margin1))
        ck_assert_int_eq(m.stable, 0);
    y[0] = m.margin1;
    y[1] = m.margin2;
    return 2;
}

TEST(eq42_rejects_each_input_outside_its_domain)
{
    assert_rejects_outside(eq42, "+rr", (const double[]){1, -2, 3});
}

EACH(eq41_roots_reject_coefficients_that_overflow, 3)
{
    /* finite, but not three times as much; the third without damping */
    const struct ct_gains gains[] = {{1e308, 1}, {1, 1e308}, {1e308, 0}};
    struct ct_root r[4];

    ck_assert_int_eq(ct_characteristic_roots(1, gains[_i], r), CT_DOMAIN);
    ck_assert_double_nan(r[0].re);
}

/* Pairs of which the real part is the greater, and the smaller, of either sign, and real roots; whatever order GSL finds them in. */
TEST(eq41_roots_are_in_order_for_all_gains)
{
    int strong = 0;
    for (int n = -60; n <= 60; n++) {
        for (int c = -60; c <= 60; c++) {
            struct ct_root r[4];
            ck_assert_int_eq(ct_characteristic_roots(1, (struct ct_gains){0.7 * n, 0.3 * c}, r), CT_OK);
            for (int k = 0; k < 3; k++) {
                ck_assert(r[k].re < r[k + 1].re || (r[k].re == r[k + 1].re && r[k].im <= r[k + 1].im));
                strong += r[k].re == r[k + 1].re && fabs(r[k].re) > fabs(r[k].im) && r[k].im != 0;
            }
        }
    }
    ck_assert_int_gt(strong, 100);
}

TEST(eq43_whole_numbers)
{
    ck_assert_double_eq(ct_proportional_gain(3, 10), 90);
}

TEST(eq44_vanishes_at_nine)
{
    ck_assert_double_eq(ct_derivative_gain(3, 9), 0);
}

/* dL_ddot + C2 dL_dot + (C1 - 9 Omega^2) dL has a double root where C2^2 = 4 (C1 - 9 Omega^2). */
RANGE(eq44_damps_critically, 1, 17)
{
    const double n = 9.0 + _i / 8.0, C2 = ct_derivative_gain(Omega, n);
    const struct ct_gains g = {ct_proportional_gain(Omega, n), C2};

    assert_close(C2 * C2, 4 * ct_routh_margins(Omega, g).margin1, 4); /* a root and its square */
}
