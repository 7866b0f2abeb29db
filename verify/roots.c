/*
 * Eq. (41)   p(lambda) = lambda^4 + C2 lambda^3 + (C1 - 2 Omega^2) lambda^2 + 3 C2 Omega^2 lambda
 *                        + 3 (C1 Omega^2 - 9 Omega^4)
 *
 * With s = lambda/Omega, c1 = C1/Omega^2, c2 = C2/Omega: (s^2 + 3)(s^2 + c2 s + c1 - 9) + 4 s^2.
 * Enclosures isolate and separate what differs. What may be equal is settled by four facts.
 *
 * (a) Imaginary axis. p(i w) = 0 says c2 w (3 - w^2) = 0 and w^4 - (c1 - 2) w^2 + 3 (c1 - 9) = 0,
 *     and w^2 = 3 makes the latter -12. So the axis has no root unless c2 = 0, but for the root 0,
 *     which is there exactly when c1 = 9.
 *
 * (b) Symmetry. With u = s + c2/4, p = u^4 + P u^2 + Q u + R, 8 Q = c2 (c2^2 - 4 (c1 - 8)), and the
 *     four u sum to zero. So two conjugate pairs with one real part, two double roots, or a double
 *     root midway between a conjugate pair, are all of the form u = +-u1, +-u2, which is Q = 0.
 *     There the roots are written down (symmetric_roots).
 *
 * (c) Where Q is not 0 there is therefore at most one multiple root; it is real, so with its
 *     multiplicity m, gcd(p, p') = (s - r)^(m - 1) and r is rational.
 *
 * (d) Other roots with one real part: a real r and a pair r +- i y, the fourth root m being real.
 *     A conjugate of the algebraic number r is a root midway between two others. Neither m nor
 *     r +- i y is, by their imaginary parts, so r is its only conjugate: r is rational. (It then
 *     makes 9 - 9 r^2 - 12 r^4 - 3 r^6 a rational square. Of all fractions with a denominator
 *     below 4000 only 0 does that; should another exist, the order is decided all the same.)
 */
#include "roots.h"

#include <complex.h>
#include <math.h>

enum { DEGREE = 4 };

/* p of (41), or with Omega = 1 the polynomial in s. */
static void polynomial(fmpq_poly_t p, const fmpq_t Omega, const fmpq_t C1, const fmpq_t C2)
{
    fmpq_t square, c;
    fmpq_init(square);
    fmpq_init(c);
    fmpq_mul(square, Omega, Omega);
    fmpq_poly_zero(p);
    fmpq_poly_set_coeff_si(p, 4, 1);
    fmpq_poly_set_coeff_fmpq(p, 3, C2);
    fmpq_mul_si(c, square, -2);
    fmpq_add(c, c, C1);
    fmpq_poly_set_coeff_fmpq(p, 2, c);
    fmpq_mul(c, C2, square);
    fmpq_mul_si(c, c, 3);
    fmpq_poly_set_coeff_fmpq(p, 1, c);
    fmpq_mul_si(c, square, -9);
    fmpq_add(c, c, C1);
    fmpq_mul(c, c, square);
    fmpq_mul_si(c, c, 3);
    fmpq_poly_set_coeff_fmpq(p, 0, c);
    fmpq_clear(square);
    fmpq_clear(c);
}

/* ---- isolation -------------------------------------------------------- */

/* Durand and Kerner's iteration in double: a start that nothing relies on. False when it is none.
 */
static bool approximate(acb_ptr roots, const acb_poly_t p)
{
    double a[DEGREE];
    double complex z[DEGREE] = {1, 0.4 + 0.9 * I, -0.65 + 0.72 * I, -0.908 - 0.297 * I};
    double change = 1;
    for (int k = 0; k < DEGREE; k++)
        a[k] = arf_get_d(arb_midref(acb_realref(acb_poly_get_coeff_ptr(p, k))), ARF_RND_NEAR);
    for (int round = 0; round < 100 && change > 1e-15; round++) {
        change = 0;
        for (int k = 0; k < DEGREE; k++) {
            double complex value = 1, others = 1;
            for (int j = DEGREE - 1; j >= 0; j--) {
                value = value * z[k] + a[j];
                others *= j == k ? 1 : z[k] - z[j];
            }
            z[k] -= value / others;
            change = fmax(change, cabs(value / others) / cabs(z[k]));
        }
    }
    bool finite = true;
    for (int k = 0; k < DEGREE; k++) {
        acb_set_d_d(roots + k, creal(z[k]), cimag(z[k]));
        finite = finite && acb_is_finite(roots + k);
    }
    return finite;
}

/*
 * p is real, so each root off the axis has its conjugate among the others: the one enclosure that
 * meets the conjugate of its own holds it.
 */
static bool pair_up(acb_ptr roots)
{
    bool paired = true;
    acb_t conjugate;
    acb_init(conjugate);
    for (int k = 0; k < DEGREE; k++) {
        if (arb_contains_zero(acb_imagref(roots + k)))
            arb_zero(acb_imagref(roots + k));
        if (!arb_is_positive(acb_imagref(roots + k)))
            continue;
        int partners = 0, partner = k;
        acb_conj(conjugate, roots + k);
        for (int j = 0; j < DEGREE; j++) {
            if (acb_overlaps(roots + j, conjugate)) {
                partners++;
                partner = j;
            }
        }
        paired = paired && partners == 1;
        acb_set(roots + partner, conjugate);
    }
    acb_clear(conjugate);
    return paired;
}

/* Four disjoint enclosures, of one root each for every polynomial in the balls; false when not
 * reached. */
static bool isolate(acb_ptr roots, const acb_poly_t p, slong prec)
{
    acb_ptr start = _acb_vec_init(DEGREE);
    slong isolated = 0;
    if (approximate(start, p))
        isolated = acb_poly_find_roots(roots, p, start, 0, prec);
    if (isolated != DEGREE)
        isolated = acb_poly_find_roots(roots, p, NULL, 0, prec);
    _acb_vec_clear(start, DEGREE);
    return isolated == DEGREE && acb_poly_validate_real_roots(roots, p, prec) && pair_up(roots);
}

/* The same where the above fails: clusters, and by fact (c) a multiple root. */
static void isolate_exactly(acb_ptr roots, const fmpq_poly_t p, slong prec)
{
    fmpq_t r;
    fmpq_poly_t common, simple;
    fmpz_poly_t integral;
    fmpq_init(r);
    fmpq_poly_init(common);
    fmpq_poly_init(simple);
    fmpz_poly_init(integral);
    fmpq_poly_derivative(common, p);
    fmpq_poly_gcd(common, common, p);
    fmpq_poly_div(simple, p, common);
    fmpq_poly_get_numerator(integral, simple);
    arb_fmpz_poly_complex_roots(roots, integral, 0, prec);

    slong repeated = fmpq_poly_degree(common); /* common = s^k - k r s^(k-1) + ... */
    if (repeated > 0) {
        fmpq_set_si(r, -1, (ulong)repeated);
        fmpq_poly_scalar_mul_fmpq(common, common, r);
        fmpq_poly_get_coeff_fmpq(r, common, repeated - 1);
    }
    for (slong k = DEGREE - repeated; k < DEGREE; k++) {
        acb_zero(roots + k);
        arb_set_fmpq(acb_realref(roots + k), r, prec);
    }
    for (slong k = 0; k < DEGREE - repeated; k++)
        if (repeated > 0 && acb_is_real(roots + k) && arb_contains_fmpq(acb_realref(roots + k), r))
            acb_set(roots + k, roots + DEGREE - 1);
    fmpq_clear(r);
    fmpq_poly_clear(common);
    fmpq_poly_clear(simple);
    fmpz_poly_clear(integral);
}

/* ---- rational parts --------------------------------------------------- */

/* The fraction of least denominator in a finite ball. */
static void simplest(fmpq_t t, const arb_t x)
{
    arf_t end;
    fmpq_t low, high;
    arf_init(end);
    fmpq_init(low);
    fmpq_init(high);
    arb_get_lbound_arf(end, x, ARF_PREC_EXACT);
    arf_get_fmpq(low, end);
    arb_get_ubound_arf(end, x, ARF_PREC_EXACT);
    arf_get_fmpq(high, end);
    fmpq_simplest_between(t, low, high);
    arf_clear(end);
    fmpq_clear(low);
    fmpq_clear(high);
}

static bool is_root(const fmpq_poly_t p, const fmpq_t t)
{
    fmpq_t value;
    fmpq_init(value);
    fmpq_poly_evaluate_fmpq(value, p, t);
    bool zero = fmpq_is_zero(value);
    fmpq_clear(value);
    return zero;
}

/* The number of different real roots that f and g, not both zero, have in common. */
static int common_real_roots(const fmpq_poly_t f, const fmpq_poly_t g)
{
    fmpq_poly_t common, repeated;
    fmpz_poly_t simple;
    fmpq_poly_init(common);
    fmpq_poly_init(repeated);
    fmpz_poly_init(simple);
    fmpq_poly_gcd(common, f, g);
    fmpq_poly_derivative(repeated, common);
    fmpq_poly_gcd(repeated, repeated, common);
    fmpq_poly_div(common, common, repeated);
    fmpq_poly_get_numerator(simple, common);
    int count = (int)fmpz_poly_num_real_roots_sturm(simple);
    fmpq_poly_clear(common);
    fmpq_poly_clear(repeated);
    fmpz_poly_clear(simple);
    return count;
}

/* f + i y g = p(t + i y) as polynomials in y, g even; taylor[k] is the k-th derivative of p over k!
 */
static void on_vertical(fmpq_poly_t f, fmpq_poly_t g, fmpq_poly_t taylor[DEGREE], const fmpq_t t)
{
    fmpq_t c;
    fmpq_init(c);
    for (int k = 0; k < DEGREE; k++) {
        fmpq_poly_evaluate_fmpq(c, taylor[k], t);
        if (k >= 2)
            fmpq_neg(c, c); /* i^2 */
        fmpq_poly_set_coeff_fmpq(k % 2 == 0 ? f : g, k - k % 2, c);
    }
    fmpq_poly_set_coeff_si(f, DEGREE, 1);
    fmpq_clear(c);
}

/* f + i t g = p(x + i t) as polynomials in x */
static void on_horizontal(fmpq_poly_t f, fmpq_poly_t g, fmpq_poly_t taylor[DEGREE], const fmpq_t t)
{
    fmpq_t square;
    fmpq_poly_t term;
    fmpq_init(square);
    fmpq_poly_init(term);
    fmpq_mul(square, t, t);
    fmpq_poly_set_fmpq(f, square);
    fmpq_poly_sub(f, f, taylor[2]);
    fmpq_poly_scalar_mul_fmpq(f, f, square);
    fmpq_poly_add(f, f, taylor[0]);
    fmpq_poly_scalar_mul_fmpq(term, taylor[3], square);
    fmpq_poly_sub(g, taylor[1], term);
    fmpq_clear(square);
    fmpq_poly_clear(term);
}

/* How many different conjugate pairs have the real part t, or the imaginary parts +-t. */
static int pairs_with(const fmpq_poly_t p, const fmpq_t t, bool imaginary)
{
    fmpq_poly_t taylor[DEGREE], f, g;
    fmpq_poly_init(f);
    fmpq_poly_init(g);
    for (int k = 0; k < DEGREE; k++) {
        fmpq_poly_init(taylor[k]);
        if (k == 0)
            fmpq_poly_set(taylor[k], p);
        else
            fmpq_poly_derivative(taylor[k], taylor[k - 1]);
        if (k > 1)
            fmpq_poly_scalar_div_ui(taylor[k], taylor[k], (ulong)k);
    }
    int pairs;
    if (imaginary) {
        on_horizontal(f, g, taylor, t);
        pairs = common_real_roots(f, g);
    } else {
        /* each pair is met at y and -y; a multiple root t of p, at y = 0, makes the number odd */
        on_vertical(f, g, taylor, t);
        pairs = common_real_roots(f, g) / 2;
    }
    for (int k = 0; k < DEGREE; k++)
        fmpq_poly_clear(taylor[k]);
    fmpq_poly_clear(f);
    fmpq_poly_clear(g);
    return pairs;
}

/* ---- order ------------------------------------------------------------ */

/*
 * True when the two roots are proved to have the same real part. The enclosures isolate, so that
 * equal or conjugate enclosures hold equal or conjugate roots; else by facts (b) and (d) it is a
 * real root and a pair, at a rational number that is the simplest one in a narrow enough enclosure.
 * Without p that is left undecided.
 */
static bool same_real_part(acb_srcptr x, acb_srcptr y, const fmpq_poly_struct *p)
{
    acb_t conjugate;
    acb_init(conjugate);
    acb_conj(conjugate, x);
    bool same = acb_equal(x, y) || acb_equal(conjugate, y);
    acb_clear(conjugate);
    if (!same && p != NULL && acb_is_real(x) != acb_is_real(y)) {
        fmpq_t t;
        fmpq_init(t);
        simplest(t, acb_realref(acb_is_real(x) ? x : y));
        same = arb_contains_fmpq(acb_realref(x), t) && arb_contains_fmpq(acb_realref(y), t) &&
               is_root(p, t) && pairs_with(p, t, false) > 0;
        fmpq_clear(t);
    }
    return same;
}

/* True when x is proved to come before y, or to equal it. */
static bool ordered(acb_srcptr x, acb_srcptr y, const fmpq_poly_struct *p)
{
    if (!arb_overlaps(acb_realref(x), acb_realref(y)))
        return arb_lt(acb_realref(x), acb_realref(y));
    bool not_after = arb_lt(acb_imagref(x), acb_imagref(y)) || acb_equal(x, y);
    return not_after && same_real_part(x, y, p);
}

/* Sorts by proved order; false when that leaves a place undecided. */
static bool sort(acb_ptr roots, const fmpq_poly_struct *p)
{
    for (int last = DEGREE - 1; last > 0; last--)
        for (int k = 0; k < last; k++)
            if (!ordered(roots + k, roots + k + 1, p) && ordered(roots + k + 1, roots + k, p))
                acb_swap(roots + k, roots + k + 1);
    bool sorted = true;
    for (int k = 0; k + 1 < DEGREE; k++)
        sorted = sorted && ordered(roots + k, roots + k + 1, p);
    return sorted;
}

/* ---- the symmetric case ----------------------------------------------- */

/* +-x +- i y with u^4 + P u^2 + R = 0, where P^2 < 4 R: x^2, y^2 = (2 sqrt(R) -+ P)/4, sorted. */
static void four_complex(acb_ptr u, const fmpq_t P, const fmpq_t R, slong prec)
{
    arb_t x, y, p;
    arb_init(x);
    arb_init(y);
    arb_init(p);
    arb_set_fmpq(x, R, prec);
    arb_sqrt(x, x, prec);
    arb_mul_2exp_si(x, x, 1);
    arb_set_fmpq(p, P, prec);
    arb_add(y, x, p, prec);
    arb_sub(x, x, p, prec);
    arb_sqrt(x, x, prec);
    arb_sqrt(y, y, prec);
    arb_mul_2exp_si(x, x, -1);
    arb_mul_2exp_si(y, y, -1);
    acb_set_arb_arb(u + 3, x, y);
    acb_conj(u + 2, u + 3);
    acb_neg(u + 1, u + 2);
    acb_neg(u, u + 3);
    arb_clear(x);
    arb_clear(y);
    arb_clear(p);
}

/*
 * +-sqrt(v) for both roots v of v^2 + P v + R = 0 where D = P^2 - 4 R >= 0, sorted: the greater v
 * is outermost when it is positive (all real, or real about imaginary), the lesser one when none is
 * (all imaginary). The greater in modulus is computed, the other is R over it.
 */
static void two_by_two(acb_ptr u, const fmpq_t P, const fmpq_t R, const fmpq_t D, slong prec)
{
    acb_t least, greatest;
    acb_init(least);
    acb_init(greatest);
    arb_ptr v = acb_realref(least), other = acb_realref(greatest);
    if (fmpq_sgn(P) < 0) {
        v = acb_realref(greatest);
        other = acb_realref(least);
    }
    arb_set_fmpq(v, D, prec);
    arb_sqrt(v, v, prec);
    arb_set_fmpq(other, P, prec);
    if (fmpq_sgn(P) < 0)
        arb_neg(v, v);
    arb_add(v, v, other, prec);
    arb_mul_2exp_si(v, v, -1);
    arb_neg(v, v);
    arb_set_fmpq(other, R, prec);
    arb_div(other, other, v, prec); /* v is not 0: P = R = 0 would need c1 = 20, where D < 0 */
    bool positive = fmpq_sgn(R) < 0 || fmpq_sgn(P) < 0;
    acb_sqrt(u + 3, positive ? greatest : least, prec);
    acb_sqrt(u + 2, positive ? least : greatest, prec);
    acb_neg(u + 1, u + 2);
    acb_neg(u, u + 3);
    acb_clear(least);
    acb_clear(greatest);
}

/* Fact (b): the roots of p where Q = 0, sorted. */
static void symmetric_roots(acb_ptr roots, const fmpq_poly_t p, slong prec)
{
    fmpq_t middle, P, R, D;
    fmpq_poly_t shift;
    arb_t x;
    fmpq_init(middle);
    fmpq_init(P);
    fmpq_init(R);
    fmpq_init(D);
    fmpq_poly_init(shift);
    arb_init(x);
    fmpq_poly_get_coeff_fmpq(middle, p, 3);
    fmpq_div_2exp(middle, middle, 2);
    fmpq_neg(middle, middle);
    fmpq_poly_set_coeff_fmpq(shift, 0, middle);
    fmpq_poly_set_coeff_si(shift, 1, 1);
    fmpq_poly_compose(shift, p, shift);
    fmpq_poly_get_coeff_fmpq(P, shift, 2);
    fmpq_poly_get_coeff_fmpq(R, shift, 0);
    fmpq_mul_si(D, R, -4);
    fmpq_addmul(D, P, P);
    if (fmpq_sgn(D) < 0)
        four_complex(roots, P, R, prec);
    else
        two_by_two(roots, P, R, D, prec);
    arb_set_fmpq(x, middle, prec);
    for (int k = 0; k < DEGREE; k++)
        arb_add(acb_realref(roots + k), acb_realref(roots + k), x, prec);
    fmpq_clear(middle);
    fmpq_clear(P);
    fmpq_clear(R);
    fmpq_clear(D);
    fmpq_poly_clear(shift);
    arb_clear(x);
}

/* Q = 0, that is, c2 = 0 or c2^2 = 4 (c1 - 8) */
static bool symmetric(const fmpq_t c1, const fmpq_t c2)
{
    fmpq_t q;
    fmpq_init(q);
    fmpq_sub_si(q, c1, 8);
    fmpq_mul_si(q, q, -4);
    fmpq_addmul(q, c2, c2);
    bool zero = fmpq_is_zero(c2) || fmpq_is_zero(q);
    fmpq_clear(q);
    return zero;
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

/* The sorted roots in s at some working precision, by p itself where balls do not suffice. */
static bool general_roots(acb_ptr roots, const fmpq_poly_t p, slong prec)
{
    acb_poly_t balls;
    acb_poly_init(balls);
    acb_poly_set_fmpq_poly(balls, p, prec);
    if (!isolate(roots, balls, prec))
        isolate_exactly(roots, p, prec);
    acb_poly_clear(balls);
    for (int k = 0; k < DEGREE; k++) /* the one that holds a root 0 of p is that root */
        if (acb_contains_zero(roots + k) && fmpz_is_zero(fmpq_poly_numref(p)))
            acb_zero(roots + k);
    return sort(roots, p);
}

bool roots41(acb_ptr roots, const fmpq_t Omega, const fmpq_t C1, const fmpq_t C2, slong prec)
{
    if (fmpq_sgn(Omega) <= 0)
        return false;
    fmpq_t one, c1, c2;
    fmpq_poly_t p;
    arb_t rate;
    fmpq_init(one);
    fmpq_init(c1);
    fmpq_init(c2);
    fmpq_poly_init(p);
    arb_init(rate);
    fmpq_one(one);
    fmpq_div(c1, C1, Omega);
    fmpq_div(c1, c1, Omega);
    fmpq_div(c2, C2, Omega);
    polynomial(p, one, c1, c2);
    slong working = prec + 32; /* guard bits for the cancellation of ordinary roots */
    bool done = false;
    for (; !done; working *= 2) {
        if (symmetric(c1, c2)) {
            symmetric_roots(roots, p, working);
            done = true;
        } else {
            done = general_roots(roots, p, working);
        }
        arb_set_fmpq(rate, Omega, working);
        for (int k = 0; k < DEGREE; k++)
            acb_mul_arb(roots + k, roots + k, rate, working);
        done = done && accurate(roots, prec);
    }
    fmpq_clear(one);
    fmpq_clear(c1);
    fmpq_clear(c2);
    fmpq_poly_clear(p);
    arb_clear(rate);
    return true;
}

bool roots41_gains(acb_ptr roots, const arb_t c1, const arb_t c2, slong prec)
{
    arb_poly_t p;
    acb_poly_t balls;
    arb_t c;
    arb_poly_init(p);
    acb_poly_init(balls);
    arb_init(c);
    arb_poly_set_coeff_si(p, 4, 1);
    arb_poly_set_coeff_arb(p, 3, c2);
    arb_sub_ui(c, c1, 2, prec);
    arb_poly_set_coeff_arb(p, 2, c);
    arb_mul_ui(c, c2, 3, prec);
    arb_poly_set_coeff_arb(p, 1, c);
    arb_sub_ui(c, c1, 9, prec);
    arb_mul_ui(c, c, 3, prec);
    arb_poly_set_coeff_arb(p, 0, c);
    acb_poly_set_arb_poly(balls, p);
    bool done = isolate(roots, balls, prec) && sort(roots, NULL);
    arb_poly_clear(p);
    acb_poly_clear(balls);
    arb_clear(c);
    return done;
}

/* How many different pairs of the enclosures may have the part t (an imaginary part +-t). */
static int candidates(acb_srcptr roots, const fmpq_t t, bool imaginary)
{
    int pairs = 0;
    for (int k = 0; k < DEGREE; k++) {
        arb_srcptr part = imaginary ? acb_imagref(roots + k) : acb_realref(roots + k);
        bool counted = !arb_is_positive(acb_imagref(roots + k));
        for (int j = 0; j < k; j++)
            counted = counted || acb_equal(roots + j, roots + k);
        pairs += !counted && arb_contains_fmpq(part, t);
    }
    return pairs;
}

bool roots41_rational(fmpq_t value, acb_srcptr roots, int k, bool imaginary, const fmpq_t Omega,
                      const fmpq_t C1, const fmpq_t C2)
{
    arb_srcptr part = imaginary ? acb_imagref(roots + k) : acb_realref(roots + k);
    if (!arb_is_finite(part))
        return false;
    simplest(value, part);
    if (arb_is_zero(part))
        return true;
    fmpq_t t;
    fmpq_poly_t p;
    fmpq_init(t);
    fmpq_poly_init(p);
    polynomial(p, Omega, C1, C2);
    fmpq_set(t, value);
    if (imaginary)
        fmpq_abs(t, t);
    bool proved;
    if (acb_is_real(roots + k)) {
        proved = is_root(p, t);
    } else {
        /* as many pairs have the part t as may have it: then this one has it */
        int pairs = pairs_with(p, t, imaginary);
        proved = pairs > 0 && pairs == candidates(roots, t, imaginary);
    }
    fmpq_clear(t);
    fmpq_poly_clear(p);
    return proved;
}
