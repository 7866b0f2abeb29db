/*
 * Eq. (41)   p(lambda) = lambda^4 + C2 lambda^3 + (C1 - 2 Omega^2) lambda^2 + 3 C2 Omega^2 lambda
 *                        + 3 (C1 Omega^2 - 9 Omega^4)
 *
 * Balls isolate the roots in s = lambda/Omega and order what differs. What may be equal is left to algebraic numbers
 * (qqbar), which decide it by minimal polynomials, in milliseconds. With c1 = C1/Omega^2, c2 = C2/Omega it may be so
 *
 *   where p has a multiple root: its discriminant is 0;
 *   where c1 = 9: one root is 0, and no ball around 0 has leading bits;
 *   where two pairs have one real part, or a root's real part is 0 and not the root. With u = s + c2/4,
 *   p = u^4 + P u^2 + Q u + R, 8 Q = c2 (c2^2 - 4 (c1 - 8)), and the four u add up to 0: two pairs with one real part are
 *   +-u1, +-u2, which is Q = 0. p(i w) = 0 says c2 w (3 - w^2) = 0 and w^4 - (c1 - 2) w^2 + 3 (c1 - 9) = 0, and
 *   w^2 = 3 makes the latter -12: the imaginary axis has no root but 0 unless c2 = 0, which is Q = 0 again;
 *   where a pair has the real part of a real root. That is settled when balls have not told them apart by MOST_DOUBLINGS.
 *
 * What balls prove, each with its tests in tests/proof/test_roots.c:
 *
 *   (P1) a root in each of four enclosures that do not meet, of every polynomial in the balls   (isolate_roots)
 *   (P2) those off the axis are conjugate, those that touch it hold a real root                 (roots41_conjugates)
 *   (P3) each comes before the next                                                             (sort)
 *   (P4) each part that is not an exact zero has its leading bits                               (accurate)
 */
#include "proof/roots.h"

#include <complex.h>
#include <math.h>

#include "text/scope.h"

enum { DEGREE = 4, MOST_DOUBLINGS = 6 };

SCOPED(qqbar)
SCOPED_VECTOR(qqbar, qqbar_ptr)

/* The coefficient of s^k is the sum of these, times 1, c1 and c2. */
static const slong coefficients[DEGREE + 1][3] = {{-27, 3, 0}, {0, 0, 3}, {-2, 1, 0}, {0, 0, 1}, {1, 0, 0}};

static void set_exact(fmpq_poly_t p, fmpq_t c1, fmpq_t c2, const fmpq_t Omega, const fmpq_t C1, const fmpq_t C2)
{
    SCOPE(fmpq, a, b);
    fmpq_div(c2, C2, Omega);
    fmpq_div(c1, C1, Omega);
    fmpq_div(c1, c1, Omega);
    for (int k = DEGREE; k >= 0; k--) {
        fmpq_mul_si(a, c1, coefficients[k][1]);
        fmpq_add_si(a, a, coefficients[k][0]);
        fmpq_mul_si(b, c2, coefficients[k][2]);
        fmpq_add(a, a, b);
        fmpq_poly_set_coeff_fmpq(p, k, a);
    }
}

static void set_balls(acb_poly_t p, const arb_t c1, const arb_t c2, slong prec)
{
    SCOPE(acb, a);
    for (int k = DEGREE; k >= 0; k--) {
        arb_mul_si(acb_realref(a), c1, coefficients[k][1], prec);
        arb_addmul_si(acb_realref(a), c2, coefficients[k][2], prec);
        arb_add_si(acb_realref(a), acb_realref(a), coefficients[k][0], prec);
        acb_poly_set_coeff_acb(p, k, a);
    }
}

/* ---- isolation -------------------------------------------------------- */

/* Durand and Kerner's iteration in double: a start that nothing relies on, and twice as fast as with none. */
static void approximate(acb_ptr roots, const acb_poly_t p)
{
    double complex z[DEGREE] = {1, 0.4 + 0.9 * I, -0.65 + 0.72 * I, -0.908 - 0.297 * I};
    double change = 1;
    for (int round = 0; round < 100 && change > 1e-15; round++) {
        change = 0;
        for (int k = 0; k < DEGREE; k++) {
            double complex value = 1, others = 1;
            for (int j = DEGREE - 1; j >= 0; j--) {
                value = value * z[k] + arf_get_d(arb_midref(acb_realref(p->coeffs + j)), ARF_RND_NEAR);
                others *= j == k ? 1 : z[k] - z[j];
            }
            z[k] -= value / others;
            change = fmax(change, cabs(value / others) / cabs(z[k]));
        }
    }
    for (int k = 0; k < DEGREE; k++)
        acb_set_d_d(roots + k, creal(z[k]), cimag(z[k]));
}

bool roots41_conjugates(acb_ptr roots)
{
    SCOPE(acb, conjugate);
    for (int k = 0; k < DEGREE; k++) {
        int partners = 0, partner = k;
        acb_conj(conjugate, roots + k);
        for (int j = 0; j < DEGREE; j++)
            if (acb_overlaps(roots + j, conjugate)) {
                partners++;
                partner = j;
            }
        if (partners != 1)
            return false;
        if (partner == k)
            arb_zero(acb_imagref(roots + k));
        else
            acb_set(roots + partner, conjugate);
    }
    return true;
}

/*
 * True when x is proved to come before y, or to equal it. The enclosures isolate: those that are conjugates of each other
 * hold conjugate roots.
 */
static bool ordered(acb_srcptr x, acb_srcptr y)
{
    if (!arb_overlaps(acb_realref(x), acb_realref(y)))
        return arb_lt(acb_realref(x), acb_realref(y));
    return arb_equal(acb_realref(x), acb_realref(y)) && arb_lt(acb_imagref(x), acb_imagref(y));
}

/* Sorts by proved order; false when that leaves a place undecided. */
static bool sort(acb_ptr roots)
{
    bool sorted = true;
    for (int last = DEGREE - 1; last > 0; last--)
        for (int k = 0; k < last; k++)
            if (ordered(roots + k + 1, roots + k))
                acb_swap(roots + k, roots + k + 1);
    for (int k = 0; k + 1 < DEGREE; k++)
        sorted = sorted && ordered(roots + k, roots + k + 1);
    return sorted;
}

/* (P1) to (P3) */
static bool isolate_roots(acb_ptr roots, const acb_poly_t p, slong prec)
{
    VECTOR(acb, start, DEGREE);
    approximate(start, p);
    return (acb_poly_find_roots(roots, p, start, 0, prec) == DEGREE ||
            acb_poly_find_roots(roots, p, NULL, 0, prec) == DEGREE) &&
           roots41_conjugates(roots) && sort(roots);
}

bool roots41_gains(acb_ptr roots, const arb_t c1, const arb_t c2, slong prec)
{
    SCOPE(acb_poly, p);
    set_balls(p, c1, c2, prec);
    return isolate_roots(roots, p, prec);
}

/* ---- what may be equal ------------------------------------------------ */

static bool may_be_equal(const fmpq_poly_t p, const fmpq_t c1, const fmpq_t c2)
{
    SCOPE(fmpq, q);
    fmpq_sub_si(q, c1, 8);
    fmpq_mul_si(q, q, -4);
    fmpq_addmul(q, c2, c2);
    return fmpq_is_zero(c2) || fmpq_is_zero(q) || fmpz_is_zero(fmpq_poly_numref(p)) || !fmpq_poly_is_squarefree(p);
}

/* The roots as algebraic numbers, sorted. */
static void exact_roots(qqbar_ptr z, const fmpq_poly_t p)
{
    qqbar_roots_fmpq_poly(z, p, QQBAR_ROOTS_UNSORTED);
    for (int last = DEGREE - 1; last > 0; last--)
        for (int k = 0; k < last; k++) {
            const int by_real = qqbar_cmp_re(z + k, z + k + 1);
            if (by_real > 0 || (by_real == 0 && qqbar_cmp_im(z + k, z + k + 1) > 0))
                qqbar_swap(z + k, z + k + 1);
        }
}

/* What is real, or imaginary, is an exact zero in the other part; equal roots have equal enclosures. */
static void enclose_exact_roots(acb_ptr roots, const fmpq_poly_t p, slong prec)
{
    VECTOR(qqbar, z, DEGREE);
    exact_roots(z, p);
    for (int k = 0; k < DEGREE; k++)
        qqbar_get_acb(roots + k, z + k, prec);
}

/* ---- the interface ---------------------------------------------------- */

/* True when every part that is not an exact zero has its leading bits. */
static bool accurate(acb_srcptr roots, slong prec)
{
    bool enough = true;
    for (int k = 0; k < DEGREE; k++)
        enough = enough && arb_rel_accuracy_bits(acb_realref(roots + k)) >= prec &&
                 arb_rel_accuracy_bits(acb_imagref(roots + k)) >= prec;
    return enough;
}

bool roots41(acb_ptr roots, const fmpq_t Omega, const fmpq_t C1, const fmpq_t C2, slong prec)
{
    if (fmpq_sgn(Omega) <= 0)
        return false;
    SCOPE(fmpq, c1, c2);
    SCOPE(fmpq_poly, p);
    SCOPE(acb_poly, balls);
    SCOPE(arb, x);
    slong working = prec + 32; /* guard bits for the cancellation of ordinary roots, 4 of them for the product with Omega */
    set_exact(p, c1, c2, Omega, C1, C2);
    bool done = false, exactly = may_be_equal(p, c1, c2);
    for (int doubling = 0; !exactly && !done && doubling < MOST_DOUBLINGS; doubling++) {
        working *= doubling > 0 ? 2 : 1;
        acb_poly_set_fmpq_poly(balls, p, working);
        done = isolate_roots(roots, balls, working) && accurate(roots, prec + 4); /* (P4) */
    }
    if (!done)
        enclose_exact_roots(roots, p, working);
    arb_set_fmpq(x, Omega, working);
    for (int k = 0; k < DEGREE; k++)
        acb_mul_arb(roots + k, roots + k, x, working);
    return true;
}

bool roots41_rational(fmpq_t value, int k, bool imaginary, const fmpq_t Omega, const fmpq_t C1, const fmpq_t C2)
{
    SCOPE(fmpq, c1, c2);
    SCOPE(fmpq_poly, p);
    SCOPE(qqbar, part);
    VECTOR(qqbar, z, DEGREE);
    set_exact(p, c1, c2, Omega, C1, C2);
    exact_roots(z, p);
    (imaginary ? qqbar_im : qqbar_re)(part, z + k);
    const bool rational = qqbar_is_rational(part) != 0;
    if (rational) {
        qqbar_get_fmpq(value, part);
        fmpq_mul(value, value, Omega);
    }
    return rational;
}
