/*
 * ref/hill.c: Eqs. (2) to (7)
 */
#include "tests/run.h"

#include "coulombtether.h"

TEST(eq02_single_craft_feels_the_orbit_alone)
{
    const struct ct_craft craft = {5, 7, {1, 2, 3}, {-4, 5, 6}};
    struct ct_vector a;

    ck_assert_int_eq(ct_formation_acceleration(2, 1, 1, 1, &craft, &a), CT_OK);
    ck_assert_double_eq(a.x, 2 * 2 * 5 + 3 * 4 * 1);
    ck_assert_double_eq(a.y, -2 * 2 * -4);
    ck_assert_double_eq(a.z, -4 * 3);
}

TEST(eq02_forces_between_craft_leave_the_momentum)
{
    const struct ct_craft craft[4] = {
        {100, 1e-6, {10, -20, 30}, {0, 0, 0}},
        {200, -2e-6, {-40, 5, 6}, {0, 0, 0}},
        {300, 3e-6, {7, 8, -9}, {0, 0, 0}},
        {1000, 0, {0, 0, 0}, {0, 0, 0}},
    };
    struct ct_vector a[4];
    double force = 0, sum = 0;

    ck_assert_int_eq(ct_formation_acceleration(1e-9, 8.99e9, 50, 4, craft, a), CT_OK);
    for (size_t i = 0; i < 4; i++) {
        sum += craft[i].m * a[i].y; /* the orbit adds nothing along y to craft at rest */
        force += fabs(craft[i].m * a[i].y);
    }
    ck_assert_double_gt(force, 0);
    ck_assert_double_le(fabs(sum), 32 * 0x1p-53 * force); /* each force twice, sixteen roundings each */
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
