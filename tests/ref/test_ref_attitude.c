/*
 * ref/attitude.c: Eqs. (25) to (39)
 */
#include "tests/run.h"

#include "coulombtether.h"

static const struct ct_params unequal = {7.2915e-5, 8.99e9, 120, 410, 23};

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

TEST(eq37_does_not_overflow_with_the_fifth_power)
{
    /* 3 * 1e200/1e100^3 * 1e100 * (3/5)(4/5), while 1e100^5 has no double */
    assert_close(ct_gravity_gradient(1e200, (struct ct_vector){6e99, 8e99, 0}, 1e100).z, 1.44, 16);
}

TEST(eq38_does_not_overflow_with_the_cube)
{
    assert_close(ct_orbit_rate(4e200, 1e200), 2e-200, 8);
}
