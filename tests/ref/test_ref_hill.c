/*
 * ref/hill.c: Eqs. (2) to (7)
 */
#include "tests/run.h"

#include <string.h>

#include "coulombtether.h"

static const struct ct_params unequal = {7.2915e-5, 8.99e9, 120, 410, 23};

/* Craft of 2 kg and 1 kg where Omega = k_c = 1: the centre of mass takes (3, 4, 12) to (-6, -8, -24), 39 m away. */
static const struct ct_params whole = {1, 1, 2, 1, NAN};

TEST(eq02_single_craft_feels_the_orbit_alone)
{
    const struct ct_craft craft = {5, 7, {1, 2, 3}, {-4, 5, 6}};
    struct ct_vector a;

    ck_assert_int_eq(ct_formation_acceleration(2, 1, 1, 1, &craft, &a), CT_OK);
    ck_assert_double_eq(a.x, 2 * 2 * 5 + 3 * 4 * 1);
    ck_assert_double_eq(a.y, -2 * 2 * -4);
    ck_assert_double_eq(a.z, -4 * 3);
}

TEST(eq02_no_craft_is_no_error)
{
    ck_assert_int_eq(ct_formation_acceleration(1, 1, 1, 0, NULL, NULL), CT_OK);
}

TEST(eq02_rejects_two_craft_in_one_place)
{
    const struct ct_craft craft[3] = {
        {1, 1, {1, 2, 3}, {0, 0, 0}},
        {1, 1, {0, 0, 0}, {0, 0, 0}},
        {1, 1, {1, 2, 3}, {1, 1, 1}},
    };
    struct ct_vector a[4] = {0}; /* one more than there are craft, which nobody may touch */

    ck_assert_int_eq(ct_formation_acceleration(1, 1, 1, 3, craft, a), CT_DOMAIN);
    ck_assert_double_nan(a[0].x);
    ck_assert_double_nan(a[1].y);
    ck_assert_double_nan(a[2].z);
    ck_assert_double_eq(a[3].x, 0);

    const struct ct_craft last_two[3] = {craft[1], craft[0], craft[2]};
    ck_assert_int_eq(ct_formation_acceleration(1, 1, 1, 3, last_two, a), CT_DOMAIN);
}

TEST(eq03_opposite_charges_attract)
{
    const struct ct_hill_state s = {0, -4, 0, 0, 0, 0};

    ck_assert_double_gt(ct_hill_acceleration(unequal, s, -1e-12).y, 0);
    ck_assert_double_lt(ct_hill_acceleration(unequal, s, 1e-12).y, 0);
}

TEST(eq04_centre_of_mass_stays_in_the_origin)
{
    const struct ct_vector r2 = ct_second_position(whole, (struct ct_vector){3, -4, 12});

    ck_assert_double_eq(r2.x, -6);
    ck_assert_double_eq(r2.y, 8);
    ck_assert_double_eq(r2.z, -24);
}

TEST(eq05_lighter_craft_is_farther_out)
{
    const struct ct_static_places at = ct_static_positions((struct ct_params){.m1 = 1, .m2 = 3}, 8);

    ck_assert_double_eq(at.x1, 6);
    ck_assert_double_eq(at.x2, -2);
}

TEST(eq07_craft_can_change_places)
{
    const struct ct_params swapped = {unequal.Omega, unequal.k_c, unequal.m2, unequal.m1, unequal.L_ref};

    /* two roundings of the reduced mass each */
    assert_close(ct_reference_charge_product(swapped, 5), ct_reference_charge_product(unequal, 5), 4);
}
