/*
 * ref/library.c: the library's version, its statuses in words, and the header's Table 1
 */
#include "tests/run.h"

#include <stdio.h>
#include <string.h>

#include "coulombtether.h"

TEST(version_is_that_of_the_header)
{
    char text[40];

    snprintf(text, sizeof text, "%d.%d.%d", CT_VERSION_MAJOR, CT_VERSION_MINOR, CT_VERSION_PATCH);
    ck_assert_str_eq(ct_version(), text);
    ck_assert_str_eq(ct_version(), CT_VERSION);
}

TEST(each_status_has_words_of_its_own)
{
    static const int statuses[] = {CT_OK, CT_DOMAIN, CT_MEMORY, CT_CONVERGENCE, CT_CONVERGENCE + 1};
    const size_t count = sizeof statuses / sizeof statuses[0];

    for (size_t i = 0; i < count; i++)
        for (size_t k = 0; k < i; k++)
            ck_assert_str_ne(ct_status_string(statuses[i]), ct_status_string(statuses[k]));
    ck_assert_str_eq(ct_status_string(-1), ct_status_string(CT_CONVERGENCE + 1));
    ck_assert_str_eq(ct_status_string(CT_OK), "done");
}

/* The paper prints Q_ref = -0.13306 uC^2. */
TEST(table1_gives_its_charge_product)
{
    const struct ct_params p = CT_TABLE1;

    ck_assert_double_eq_tol(ct_reference_charge_product(p, p.L_ref), -0.13306e-12, 0.000005e-12);
    ck_assert_double_eq(p.m1, p.m2);
}
