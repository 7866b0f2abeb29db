/*
 * ref/ where GSL fails and its error handler lets the call return: the definitions here take the place of GSL's own
 */
#include "tests/run.h"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>
#include <gsl/gsl_poly.h>

#include "coulombtether.h"

static enum { WORKSPACE, STEP, CONTROL, EVOLVE, SOLVE, ROOTS } failing;
static int held; /* what was allocated and not freed */

static void *allocated(unsigned what, void *memory)
{
    held += failing != what;
    return failing == what ? NULL : memory;
}

gsl_poly_complex_workspace *gsl_poly_complex_workspace_alloc(size_t n)
{
    static gsl_poly_complex_workspace workspace;
    (void)n;
    return allocated(WORKSPACE, &workspace);
}

void gsl_poly_complex_workspace_free(gsl_poly_complex_workspace *w)
{
    held -= w != NULL;
}

int gsl_poly_complex_solve(const double *a, size_t n, gsl_poly_complex_workspace *w, gsl_complex_packed_ptr z)
{
    (void)a;
    (void)w;
    for (size_t i = 0; i < 2 * (n - 1); i++)
        z[i] = NAN;
    return failing == SOLVE ? GSL_EFAILED : GSL_SUCCESS;
}

gsl_odeiv2_step *gsl_odeiv2_step_alloc(const gsl_odeiv2_step_type *type, size_t dim)
{
    static gsl_odeiv2_step step;
    (void)type;
    (void)dim;
    return allocated(STEP, &step);
}

void gsl_odeiv2_step_free(gsl_odeiv2_step *s)
{
    held -= s != NULL;
}

gsl_odeiv2_control *gsl_odeiv2_control_standard_new(double eps_abs, double eps_rel, double a_y, double a_dydt)
{
    static gsl_odeiv2_control control;
    ck_assert_double_gt(eps_abs, 0);
    ck_assert_double_gt(eps_rel, 0);
    ck_assert_double_eq(a_y, a_dydt);
    return allocated(CONTROL, &control);
}

void gsl_odeiv2_control_free(gsl_odeiv2_control *c)
{
    held -= c != NULL;
}

gsl_odeiv2_evolve *gsl_odeiv2_evolve_alloc(size_t dim)
{
    static gsl_odeiv2_evolve evolve;
    (void)dim;
    return allocated(EVOLVE, &evolve);
}

void gsl_odeiv2_evolve_free(gsl_odeiv2_evolve *e)
{
    held -= e != NULL;
}

static int roots_status(void)
{
    struct ct_root root[4];
    const int status = ct_characteristic_roots(1, (struct ct_gains){10, 2}, root);

    for (int k = 0; k < 4; k++) {
        ck_assert_double_nan(root[k].re);
        ck_assert_double_nan(root[k].im);
    }
    ck_assert_int_eq(held, 0);
    return status;
}

TEST(eq41_roots_report_exhausted_memory)
{
    failing = WORKSPACE;
    ck_assert_int_eq(roots_status(), CT_MEMORY);
}

TEST(eq41_roots_report_a_solver_without_convergence)
{
    failing = SOLVE;
    ck_assert_int_eq(roots_status(), CT_CONVERGENCE);
}

TEST(eq41_roots_report_what_is_no_root)
{
    failing = ROOTS;
    ck_assert_int_eq(roots_status(), CT_CONVERGENCE);
}

RANGE(eq40_flow_reports_exhausted_memory, STEP, EVOLVE + 1)
{
    const struct ct_params p = {.Omega = 1, .L_ref = 1};
    const struct ct_tether_state start = {.psi = 1};
    const double t[] = {1, 2};
    struct ct_tether_state s[2];

    failing = _i;
    ck_assert_int_eq(ct_linear_flow(p, (struct ct_gains){10, 2}, start, 1e-9, 2, t, s), CT_MEMORY);
    ck_assert_double_nan(s[0].psi);
    ck_assert_double_nan(s[1].dL_dot);
    ck_assert_int_eq(held, 0);
}

RANGE(eq03_flow_reports_exhausted_memory, STEP, EVOLVE + 1)
{
    const struct ct_params p = {1, 1, 1, 1, 1};
    const struct ct_hill_state start = {.x1 = 1};
    const double t = 1;
    struct ct_hill_state s;

    failing = _i;
    ck_assert_int_eq(ct_nonlinear_flow(p, (struct ct_gains){10, 2}, start, 1e-9, 1, &t, &s), CT_MEMORY);
    ck_assert_double_nan(s.x1);
    ck_assert_int_eq(held, 0);
}
