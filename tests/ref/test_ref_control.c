/*
 * ref/control.c: Eqs. (18) to (22)
 */
#include "tests/run.h"

#include <string.h>

#include "coulombtether.h"

static const struct ct_params paper = {7.2915e-5, 8.99e9, 150, 150, 10};
static const struct ct_params unequal = {7.2915e-5, 8.99e9, 120, 410, 23};

TEST(eq18_commands_nothing_without_an_error)
{
    ck_assert_double_eq(ct_charge_product_variation(paper, (struct ct_gains){5e-8, 1e-4}, 0, 0), 0);
}

TEST(eq19_gain_of_nine_just_undoes_the_tide)
{
    const struct ct_params p = {.Omega = 2, .L_ref = 10};

    ck_assert_double_eq(ct_closed_loop_acceleration(p, (struct ct_gains){36, 0}, 1e3, 0, 0), 0);
}

TEST(eq21_takes_a_positive_reference_that_the_variation_outweighs)
{
    struct ct_charge_pair q;

    ck_assert_int_eq(ct_charges(7, -16, &q), CT_OK);
    ck_assert_double_eq(q.q1, 3);
}

TEST(eq21_rejects_like_charges)
{
    struct ct_charge_pair q;

    ck_assert_int_eq(ct_charges(-1, 5, &q), CT_DOMAIN); /* the print would give 2 and -2, which attract */
    ck_assert_double_nan(q.q1);
    ck_assert_double_nan(q.q2);
}

TEST(eq21_charges_at_rest_are_a_third_of_a_microcoulomb)
{
    const struct ct_hill_state rest = {.x1 = 5};
    struct ct_charge_pair q;

    ck_assert_int_eq(ct_commanded_charges(paper, (struct ct_gains){5e-8, 1e-4}, rest, &q), CT_OK);
    /* sqrt(1.3306e-13), of which the print knows half a unit in the fifth digit: 1.4e-11 C */
    ck_assert_double_eq_tol(q.q1, 3.6477e-7, 2e-11);
    ck_assert_double_eq(q.q2, -q.q1);
}

/* Where L = 1.25 L_ref, L_dot = Omega L_ref/2, C1 = 12 Omega^2, C2 = 4 Omega: Q = Q_ref (1 + (12/4 + 4/2)/3). */
TEST(eq21_follows_length_and_rate)
{
    const double Omega = unequal.Omega, share = unequal.m2 / (unequal.m1 + unequal.m2);
    const struct ct_gains g = {12 * Omega * Omega, 4 * Omega};
    const struct ct_hill_state s = {.z1 = -1.25 * share * unequal.L_ref, .z1_dot = -Omega / 2 * share * unequal.L_ref};
    const double Q_ref = -3 * Omega * Omega * pow(unequal.L_ref, 3) / unequal.k_c * unequal.m1 * share;
    struct ct_charge_pair q;

    ck_assert_int_eq(ct_commanded_charges(unequal, g, s, &q), CT_OK);
    assert_close(q.q1 * q.q1, -Q_ref * (1 + 5.0 / 3), 64); /* each road takes about thirty roundings */
}

/* With C1 = 10 Omega^2 the law commands to repel where dL < -0.3 L_ref. */
TEST(eq21_rejects_a_state_in_which_the_law_repels)
{
    const struct ct_gains g = {10 * paper.Omega * paper.Omega, 0};
    struct ct_charge_pair q;

    ck_assert_int_eq(ct_commanded_charges(paper, g, (struct ct_hill_state){.x1 = 0.71 * 5}, &q), CT_OK);
    ck_assert_int_eq(ct_commanded_charges(paper, g, (struct ct_hill_state){.x1 = 0.69 * 5}, &q), CT_DOMAIN);
    ck_assert_double_nan(q.q1);
    ck_assert_double_nan(q.q2);
}

static size_t commanded_charges(const double x[], double y[])
{
    const struct ct_params p = {x[0], x[1], x[2], x[3], x[4]};
    const struct ct_hill_state s = {x[7], x[8], x[9], x[10], x[11], x[12]};
    struct ct_charge_pair q;
    const int status = ct_commanded_charges(p, (struct ct_gains){x[5], x[6]}, s, &q);

    ck_assert_int_eq(status, isnan(q.q1) ? CT_DOMAIN : CT_OK);
    memcpy(y, &q, sizeof q);
    return 2;
}

TEST(eq21_along_a_motion_rejects_each_input_outside_its_domain)
{
    assert_rejects_outside(commanded_charges, "+++++rrrrrrrr", (const double[]){1, 1, 1, 1, 9, 5, 6, 7, 8, 9, 1, 2, 3});
}

TEST(eq21_along_a_motion_rejects_the_origin)
{
    struct ct_charge_pair q;

    ck_assert_int_eq(ct_commanded_charges(paper, (struct ct_gains){0, 0}, (struct ct_hill_state){0}, &q), CT_DOMAIN);
    ck_assert_double_nan(q.q1);
}
