/*
 * ref/hill.c: Eqs. (2) to (7)
 */
#include "tests/run.h"

#include <string.h>

#include "coulombtether.h"

/* Table 1, and a formation that shares nothing with it but the orbit. */
static const struct ct_params paper = {7.2915e-5, 8.99e9, 150, 150, 10};
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

/* 13 m apart; 13 * 169 C^2 against the cube of the distance leaves the difference of the positions, and 1/m of it. */
TEST(eq02_like_charges_push_by_the_inverse_square)
{
    const struct ct_craft craft[2] = {{1, 169, {3, 4, 12}, {0, 0, 0}}, {2, 13, {0, 0, 0}, {0, 0, 0}}};
    struct ct_vector a[2];

    ck_assert_int_eq(ct_formation_acceleration(1, 1, INFINITY, 2, craft, a), CT_OK);
    ck_assert_double_eq(a[0].x, 3 * 3 + 3);
    ck_assert_double_eq(a[0].y, 4);
    ck_assert_double_eq(a[0].z, -12 + 12);
    ck_assert_double_eq(a[1].x, -1.5);
    ck_assert_double_eq(a[1].y, -2);
    ck_assert_double_eq(a[1].z, -6);
}

TEST(eq02_shielding_divides_by_e_at_one_debye_length)
{
    const struct ct_craft craft[2] = {{1, 169, {3, 4, 12}, {0, 0, 0}}, {2, -13, {0, 0, 0}, {0, 0, 0}}};
    const double inverse_of_e = 0.36787944117144232160; /* exp(-1) */
    struct ct_vector a[2];

    ck_assert_int_eq(ct_formation_acceleration(1, 1, 13, 2, craft, a), CT_OK);
    assert_close(a[0].y, -4 * inverse_of_e, 4); /* exp, quotient and two products */
    assert_close(a[1].z, 6 * inverse_of_e, 4);
}

TEST(eq02_two_unshielded_craft_obey_eq03)
{
    const struct ct_params p = unequal;
    const struct ct_hill_state s = {-7, 11, 3, 0.001, -0.002, 0.003};
    const struct ct_vector r1 = {s.x1, s.y1, s.z1}, v1 = {s.x1_dot, s.y1_dot, s.z1_dot};
    const struct ct_craft craft[2] = {
        {p.m1, 3e-6, r1, v1},
        {p.m2, -2e-6, ct_second_position(p, r1), {0, 0, 0}},
    };
    struct ct_vector a[2];

    ck_assert_int_eq(ct_formation_acceleration(p.Omega, p.k_c, INFINITY, 2, craft, a), CT_OK);
    const struct ct_vector of_eq03 = ct_hill_acceleration(p, s, 3e-6 * -2e-6);
    assert_close(a[0].x, of_eq03.x, 16); /* two roads of eight roundings */
    assert_close(a[0].y, of_eq03.y, 16);
    assert_close(a[0].z, of_eq03.z, 16);
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

TEST(eq02_charge_of_one_craft_alone_moves_nobody)
{
    const struct ct_craft craft[2] = {{1, 1, {0, 1, 0}, {0, 0, 0}}, {1, 0, {0, 0, 0}, {0, 0, 0}}};
    struct ct_vector a[2];

    ck_assert_int_eq(ct_formation_acceleration(1, 1, 1, 2, craft, a), CT_OK);
    ck_assert_double_eq(a[0].y, 0);
    ck_assert_double_eq(a[1].y, 0);
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

static size_t eq02(const double x[], double y[])
{
    const struct ct_craft craft[2] = {
        {x[3], x[4], {x[5], x[6], x[7]}, {x[8], x[9], x[10]}},
        {x[11], x[12], {x[13], x[14], x[15]}, {x[16], x[17], x[18]}},
    };
    struct ct_vector a[2];
    const int status = ct_formation_acceleration(x[0], x[1], x[2], 2, craft, a);

    ck_assert_int_eq(status, isnan(a[0].x) ? CT_DOMAIN : CT_OK);
    memcpy(y, a, sizeof a);
    return 6;
}

TEST(eq02_rejects_each_input_outside_its_domain)
{
    const double inside[] = {1, 1, 1, 5, -6, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14};

    assert_rejects_outside(eq02, "++i+rrrrrrr+rrrrrrr", inside);
}

TEST(eq03_opposite_charges_attract)
{
    const struct ct_hill_state s = {0, -4, 0, 0, 0, 0};

    ck_assert_double_gt(ct_hill_acceleration(unequal, s, -1e-12).y, 0);
    ck_assert_double_lt(ct_hill_acceleration(unequal, s, 1e-12).y, 0);
}

TEST(eq03_rests_where_eq05_and_eq07_say)
{
    const struct ct_hill_state s = {.x1 = ct_static_positions(unequal, 23).x1};
    const struct ct_vector a = ct_hill_acceleration(unequal, s, ct_reference_charge_product(unequal, 23));
    const double tide = 3 * unequal.Omega * unequal.Omega * s.x1;

    ck_assert_double_le(fabs(a.x), 16 * 0x1p-53 * tide); /* what cancels carries about sixteen roundings */
    ck_assert_double_eq(a.y, 0);
    ck_assert_double_eq(a.z, 0);
}

TEST(eq04_centre_of_mass_stays_in_the_origin)
{
    const struct ct_vector r2 = ct_second_position(whole, (struct ct_vector){3, -4, 12});

    ck_assert_double_eq(r2.x, -6);
    ck_assert_double_eq(r2.y, 8);
    ck_assert_double_eq(r2.z, -24);
}

TEST(eq04_craft_1_in_the_origin_takes_craft_2_there)
{
    const struct ct_vector r2 = ct_second_position(unequal, (struct ct_vector){0, 0, 0});

    ck_assert_double_eq(r2.x, 0);
    ck_assert_double_eq(r2.y, 0);
    ck_assert_double_eq(r2.z, 0);
}

TEST(eq05_lighter_craft_is_farther_out)
{
    const struct ct_static_places at = ct_static_positions((struct ct_params){.m1 = 1, .m2 = 3}, 8);

    ck_assert_double_eq(at.x1, 6);
    ck_assert_double_eq(at.x2, -2);
}

TEST(eq05_paper_formation_is_symmetric)
{
    const struct ct_static_places at = ct_static_positions(paper, paper.L_ref);

    ck_assert_double_eq(at.x1, 5);
    ck_assert_double_eq(at.x2, -5);
}

TEST(eq07_rounds_to_table_1)
{
    /* printed -1.3306e-1 uC^2: half a unit of the last digit is 5e-6 uC^2 */
    ck_assert_double_eq_tol(ct_reference_charge_product(paper, paper.L_ref), -1.3306e-13, 5e-18);
}

TEST(eq07_craft_can_change_places)
{
    const struct ct_params swapped = {unequal.Omega, unequal.k_c, unequal.m2, unequal.m1, unequal.L_ref};

    /* two roundings of the reduced mass each */
    assert_close(ct_reference_charge_product(swapped, 5), ct_reference_charge_product(unequal, 5), 4);
}

