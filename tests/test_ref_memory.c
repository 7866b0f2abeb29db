/*
 * ref/ where memory is exhausted: these definitions stand in for GSL's own, as if its error handler had let the calls return
 */
#include "run.h"

#include <gsl/gsl_odeiv2.h>
#include <gsl/gsl_poly.h>

#include "coulombtether.h"

gsl_poly_complex_workspace *gsl_poly_complex_workspace_alloc(size_t n)
{
    (void)n;
    return NULL;
}

gsl_odeiv2_evolve *gsl_odeiv2_evolve_alloc(size_t dim)
{
    (void)dim;
    return NULL;
}

START_TEST(eq41_roots_report_exhausted_memory)
{
    struct ct_root root[4];

    ck_assert_int_eq(ct_characteristic_roots(1, (struct ct_gains){10, 2}, root), CT_MEMORY);
    ck_assert_double_nan(root[0].re);
    ck_assert_double_nan(root[3].im);
}
END_TEST

START_TEST(eq40_flow_reports_exhausted_memory)
{
    const struct ct_params p = {.Omega = 1, .L_ref = 1};
    const double t[] = {1, 2};
    struct ct_tether_state s[2];

    ck_assert_int_eq(ct_linear_flow(p, (struct ct_gains){10, 2}, (struct ct_tether_state){.psi = 1}, 1e-9, 2, t, s), CT_MEMORY);
    ck_assert_double_nan(s[0].psi);
    ck_assert_double_nan(s[1].dL_dot);
}
END_TEST

START_TEST(eq03_flow_reports_exhausted_memory)
{
    const struct ct_params p = {1, 1, 1, 1, 1};
    const double t = 1;
    struct ct_hill_state s;

    ck_assert_int_eq(ct_nonlinear_flow(p, (struct ct_gains){10, 2}, (struct ct_hill_state){.x1 = 1}, 1e-9, 1, &t, &s), CT_MEMORY);
    ck_assert_double_nan(s.x1);
}
END_TEST

Suite *suite(void)
{
    Suite *s = suite_create("ref/ without memory");
    TCase *c = tcase_create("GSL allocates nothing");

    tcase_add_test(c, eq41_roots_report_exhausted_memory);
    tcase_add_test(c, eq40_flow_reports_exhausted_memory);
    tcase_add_test(c, eq03_flow_reports_exhausted_memory);
    suite_add_tcase(s, c);
    return s;
}
