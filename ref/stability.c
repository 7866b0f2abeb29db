/*
 * stability.c   the linear model, its characteristic equation, and the gains: Eqs. (40) to (44)
 */
#include "internal.h"

#include <complex.h>
#include <float.h>
#include <stdlib.h>

#include <gsl/gsl_poly.h>

enum { DEGREE = 4 };

/*
 * Eqs. (40a)-(40c)   linear model: accelerations of the tether under the feedback law and the gravity gradient
 *
 *     theta_ddot = -4 Omega^2 theta
 *     psi_ddot   = -2 Omega/L_ref dL_dot - 3 Omega^2 psi
 *     dL_ddot    = -(C1 - 9 Omega^2) dL - C2 dL_dot + 2 Omega L_ref psi_dot
 *
 * Given     p        orbit rate [rad/s], reference distance [m]
 *           g        gains C1 [1/s^2], C2 [1/s]
 *           s        all but theta_dot, which does not matter: psi, theta [rad], dL [m], psi_dot [rad/s], dL_dot [m/s]
 * Returns   theta_ddot, psi_ddot [rad/s^2], dL_ddot [m/s^2]
 */
struct ct_tether_acceleration ct_linear_acceleration(struct ct_params p, struct ct_gains g, struct ct_tether_state s)
{
    if (!(POSITIVE(p.Omega, p.L_ref) && FINITE(g.C1, g.C2, s.psi, s.theta, s.dL, s.psi_dot, s.dL_dot)))
        return (struct ct_tether_acceleration){NAN, NAN, NAN};
    return (struct ct_tether_acceleration){
        .theta_ddot = -4 * p.Omega * p.Omega * s.theta,
        .psi_ddot = -2 * p.Omega / p.L_ref * s.dL_dot - 3 * p.Omega * p.Omega * s.psi,
        .dL_ddot = ct_closed_loop_acceleration(p, g, s.dL, s.dL_dot, s.psi_dot),
    };
}

/*
 * Eq. (41)   characteristic polynomial of the coupled yaw and length errors
 *
 *     lambda^4 + C2 lambda^3 + (C1 - 2 Omega^2) lambda^2 + 3 C2 Omega^2 lambda + 3 (C1 Omega^2 - 9 Omega^4)
 *
 * Given     Omega    orbit rate [rad/s]   > 0
 *           g        gains C1 [1/s^2], C2 [1/s]
 * Returns   a0, a1, a2, a3, a4   coefficients, a_k of lambda^k [1/s^(4-k)]
 */
struct ct_quartic ct_characteristic_polynomial(double Omega, struct ct_gains g)
{
    if (!(POSITIVE(Omega) && FINITE(g.C1, g.C2)))
        return (struct ct_quartic){NAN, NAN, NAN, NAN, NAN};
    return (struct ct_quartic){
        .a0 = 3 * Omega * Omega * (g.C1 - 9 * Omega * Omega),
        .a1 = 3 * Omega * Omega * g.C2,
        .a2 = g.C1 - 2 * Omega * Omega,
        .a3 = g.C2,
        .a4 = 1,
    };
}

/*
 * Newton's method on one root, for as long as it halves |p|. True where what is left solves a polynomial that differs from
 * p by a few roundings of each term: of a multiple root, which has half its digits or fewer, there is no more to ask.
 */
static bool polish(size_t degree, const double a[], struct ct_root *root)
{
    double complex z = root->re + root->im * I;
    double residual = INFINITY, terms = 0;

    for (bool halved = true; halved;) {
        double complex p = a[degree], slope = 0;
        double magnitude = fabs(a[degree]);
        for (size_t k = degree; k-- > 0;) {
            slope = slope * z + p;
            p = p * z + a[k];
            magnitude = magnitude * cabs(z) + fabs(a[k]);
        }
        halved = cabs(p) < residual / 2;
        if (halved) {
            *root = (struct ct_root){creal(z), cimag(z)};
            residual = cabs(p);
            terms = magnitude;
            z -= p / slope;
        }
    }
    return residual <= 16 * DBL_EPSILON * terms; /* a complex Horner scheme of degree 4 errs by less than half of that */
}

/* Whether no root was found twice: then the product of all -z is a_0. Loose, as double roots have half their digits. */
static bool complete(size_t degree, const double a[], const struct ct_root root[])
{
    double complex product = 1;

    for (size_t i = 0; i < degree; i++)
        product *= -root[i].re - root[i].im * I;
    return cabs(product / a[0] - 1) < 1e-6;
}

/* The roots of a polynomial of which neither the first nor the last coefficient is zero. */
static int solve(size_t degree, const double a[], struct ct_root root[])
{
    double packed[2 * DEGREE];
    gsl_poly_complex_workspace *workspace = gsl_poly_complex_workspace_alloc(degree + 1);
    if (!workspace)
        return CT_MEMORY;

    const int status = gsl_poly_complex_solve(a, degree + 1, workspace, packed);
    gsl_poly_complex_workspace_free(workspace);
    if (status)
        return CT_CONVERGENCE;

    for (size_t i = 0; i < degree; i++) {
        root[i] = (struct ct_root){packed[2 * i], packed[2 * i + 1]};
        if (!polish(degree, a, &root[i]))
            return CT_CONVERGENCE;
    }
    return complete(degree, a, root) ? CT_OK : CT_CONVERGENCE;
}

/*
 * Without damping lambda^2 solves a quadratic of discriminant (C1 - 8)^2 + 48 > 0, so it is real: the root lies on an axis,
 * and roundings beside it would decide on the order.
 */
static struct ct_root on_axis(struct ct_root z)
{
    return fabs(z.re) < fabs(z.im) ? (struct ct_root){0, z.im} : (struct ct_root){z.re, 0};
}

static int by_real_then_imaginary_part(const void *left, const void *right)
{
    const struct ct_root *a = left, *b = right;

    return a->re != b->re ? (a->re > b->re) - (a->re < b->re) : (a->im > b->im) - (a->im < b->im);
}

/*
 * Eq. (41), roots   roots of the characteristic polynomial
 *
 *     lambda_1 ... lambda_4, in ascending order of their real, then of their imaginary part
 *
 * Given     Omega    orbit rate [rad/s]   > 0
 *           g        gains C1 [1/s^2], C2 [1/s]
 * Returned  root     the four roots [1/s]
 * Status    CT_OK, CT_DOMAIN, CT_MEMORY or CT_CONVERGENCE
 *
 * Note 1    Solved in units of Omega, where the coefficients are near one; in SI they span twenty orders of magnitude.
 *           Each root gets a Newton polish. A root at zero, on the boundary C1 = 9 Omega^2 of (42), is exact.
 * Note 2    GSL calls its error handler, which by default aborts, where memory is exhausted or its QR iteration does not
 *           end; no gains are known that bring the latter about.
 */
int ct_characteristic_roots(double Omega, struct ct_gains g, struct ct_root root[4])
{
    const struct ct_gains scaled = {g.C1 / Omega / Omega, g.C2 / Omega};
    const struct ct_quartic p = ct_characteristic_polynomial(1, scaled);
    const double a[DEGREE + 1] = {p.a0, p.a1, p.a2, p.a3, p.a4};
    int status = CT_DOMAIN;

    if (POSITIVE(Omega) && FINITE(p.a0, p.a1, p.a2, p.a3)) {
        size_t zeros = 0;
        while (a[zeros] == 0)
            root[zeros++] = (struct ct_root){0, 0};
        status = solve(DEGREE - zeros, a + zeros, root + zeros);
    }
    for (size_t i = 0; i < DEGREE; i++) {
        const struct ct_root z = status ? (struct ct_root){NAN, NAN} : g.C2 == 0 ? on_axis(root[i]) : root[i];
        root[i] = (struct ct_root){Omega * z.re, Omega * z.im};
    }
    qsort(root, DEGREE, sizeof root[0], by_real_then_imaginary_part);
    return status;
}

/*
 * Eqs. (42a)-(42b)   Routh-Hurwitz conditions of stability, as margins
 *
 *     margin1 = C1 - 9 Omega^2 > 0,  margin2 = C2 > 0
 *
 * Given     Omega    orbit rate [rad/s]   > 0
 *           g        gains C1 [1/s^2], C2 [1/s]
 * Returns   margin1 [1/s^2], margin2 [1/s], stable: 1 where both are positive, and 0 elsewhere, also outside the domain
 */
struct ct_margins ct_routh_margins(double Omega, struct ct_gains g)
{
    if (!(POSITIVE(Omega) && FINITE(g.C1, g.C2)))
        return (struct ct_margins){NAN, NAN, 0};

    const double margin1 = g.C1 - 9 * Omega * Omega;
    return (struct ct_margins){margin1, g.C2, margin1 > 0 && g.C2 > 0};
}

/*
 * Eq. (43)   gain on the length error
 *
 *     C1 = n Omega^2
 *
 * Given     Omega    orbit rate [rad/s]    > 0
 *           n        scale of the gains    > 0
 * Returns   C1       [1/s^2]
 */
double ct_proportional_gain(double Omega, double n)
{
    return POSITIVE(Omega, n) ? n * Omega * Omega : NAN;
}

/*
 * Eq. (44)   gain on the rate of the length error, for critical damping where the yaw rate is left out
 *
 *     C2 = 2 Omega sqrt(n - 9)
 *
 * Given     Omega    orbit rate [rad/s]    > 0
 *           n        scale of the gains    >= 9
 * Returns   C2       [1/s]
 */
double ct_derivative_gain(double Omega, double n)
{
    return POSITIVE(Omega, n) && n >= 9 ? 2 * Omega * sqrt(n - 9) : NAN;
}
