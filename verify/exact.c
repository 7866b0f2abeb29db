/*
 * A number is kept as a sum of terms c sqrt(n) e^b: c rational and not 0, n an integer and not 0,
 * with sqrt(n) = i sqrt(-n) where n < 0, and b a sum of surds c sqrt(n) itself. No two terms have
 * equal exponents and radicands of one class, where the classes are those of n modulo squares:
 * sqrt(m) and sqrt(n) are rational multiples of each other when m n is a square, which needs no
 * factoring.
 *
 * Such a sum is zero only if it is empty. Square roots of different classes are linearly
 * independent over the rationals (Besicovitch 1940, J. London Math. Soc. 15, 3-6; the negative ones
 * are the imaginary parts of the sum). So different b are different algebraic numbers, and the
 * terms with one b add up to an algebraic number times e^b that is not 0. And exponentials of
 * different algebraic numbers are linearly independent over the algebraic numbers (Lindemann,
 * Weierstrass). A sum is rational, likewise, only if it is empty or the one term c sqrt(1) e^0:
 * otherwise, less a rational, it would not be empty.
 */
#include "exact.h"

/* c sqrt(n) */
struct surd {
    fmpq_t c;
    fmpz_t n;
};

struct surds {
    slong length;
    struct surd *surds;
};

struct exact_term {
    struct surd factor;
    struct surds exponent;
};

/* What grows beyond this many terms is given up as unknown. */
enum { MOST_TERMS = 256 };

/* ---- surds ------------------------------------------------------------ */

/* {{{numerator, denominator}}, {radicand}}; FLINT keeps a small integer in the fmpz itself. */
static const struct surd ONE = {{{1, 1}}, {1}}, MINUS_ONE = {{{-1, 1}}, {1}};
static const struct surd IMAGINARY = {{{1, 1}}, {-1}}, MINUS_IMAGINARY = {{{-1, 1}}, {-1}};
static const struct surd HALF = {{{1, 2}}, {1}};
static const struct surd HALF_IMAGINARY = {{{1, 2}}, {-1}},
                         MINUS_HALF_IMAGINARY = {{{-1, 2}}, {-1}};

static void surd_init(struct surd *x)
{
    fmpq_init(x->c);
    fmpz_init_set_ui(x->n, 1);
}

static void surd_clear(struct surd *x)
{
    fmpq_clear(x->c);
    fmpz_clear(x->n);
}

static void surd_set(struct surd *z, const struct surd *x)
{
    fmpq_set(z->c, x->c);
    fmpz_set(z->n, x->n);
}

/* sqrt(m) sqrt(n) = +-g sqrt(m n / g^2), g = gcd(m, n), minus when both are imaginary */
static void surd_mul(struct surd *z, const struct surd *x, const struct surd *y)
{
    fmpz_t g, m, n;
    fmpz_init(g);
    fmpz_init(m);
    fmpz_init(n);
    bool negate = fmpz_sgn(x->n) < 0 && fmpz_sgn(y->n) < 0;
    fmpq_mul(z->c, x->c, y->c);
    fmpz_gcd(g, x->n, y->n);
    fmpz_divexact(m, x->n, g);
    fmpz_divexact(n, y->n, g);
    fmpz_mul(z->n, m, n);
    if (negate)
        fmpz_neg(g, g);
    if (fmpz_is_square(z->n)) {
        fmpz_sqrt(n, z->n);
        fmpz_mul(g, g, n);
        fmpz_one(z->n);
    }
    fmpq_mul_fmpz(z->c, z->c, g);
    fmpz_clear(g);
    fmpz_clear(m);
    fmpz_clear(n);
}

/* z += x where both are of one class; false where not. */
static bool surd_merge(struct surd *z, const struct surd *x)
{
    fmpz_t product;
    fmpz_init(product);
    fmpz_mul(product, z->n, x->n);
    bool merge = fmpz_is_square(product);
    if (merge) {
        /* sqrt(x->n) = sqrt(product)/|z->n| sqrt(z->n) */
        fmpq_t c;
        fmpq_init(c);
        fmpz_sqrt(product, product);
        fmpq_mul_fmpz(c, x->c, product);
        fmpz_abs(product, z->n);
        fmpq_div_fmpz(c, c, product);
        fmpq_add(z->c, z->c, c);
        fmpq_clear(c);
    }
    fmpz_clear(product);
    return merge;
}

static void surds_clear(struct surds *x)
{
    for (slong k = 0; k < x->length; k++)
        surd_clear(x->surds + k);
    flint_free(x->surds);
}

static void surds_add_surd(struct surds *z, const struct surd *x)
{
    for (slong k = 0; k < z->length; k++) {
        struct surd *surd = z->surds + k;
        if (!surd_merge(surd, x))
            continue;
        if (fmpq_is_zero(surd->c)) {
            surd_clear(surd);
            *surd = z->surds[--z->length];
        }
        return;
    }
    z->surds = flint_realloc(z->surds, (size_t)(z->length + 1) * sizeof *z->surds);
    surd_init(z->surds + z->length);
    surd_set(z->surds + z->length, x);
    z->length++;
}

/* z += factor x */
static void surds_addmul(struct surds *z, const struct surds *x, const struct surd *factor)
{
    struct surd product;
    surd_init(&product);
    for (slong k = 0; k < x->length; k++) {
        surd_mul(&product, x->surds + k, factor);
        surds_add_surd(z, &product);
    }
    surd_clear(&product);
}

static bool surds_equal(const struct surds *x, const struct surds *y)
{
    struct surds difference = {0, NULL};
    surds_addmul(&difference, x, &ONE);
    surds_addmul(&difference, y, &MINUS_ONE);
    bool equal = difference.length == 0;
    surds_clear(&difference);
    return equal;
}

/* ---- sums of terms ---------------------------------------------------- */

static void term_clear(struct exact_term *t)
{
    surd_clear(&t->factor);
    surds_clear(&t->exponent);
}

/* z += factor e^(the sum of both exponents) */
static void add_term(struct exact *z, const struct surd *factor, const struct surds *exponent,
                     const struct surds *more)
{
    struct exact_term term = {.exponent = {0, NULL}};
    surd_init(&term.factor);
    surd_set(&term.factor, factor);
    surds_addmul(&term.exponent, exponent, &ONE);
    surds_addmul(&term.exponent, more, &ONE);
    for (slong k = 0; k < z->length; k++) {
        struct exact_term *like = z->terms + k;
        if (!surds_equal(&like->exponent, &term.exponent) ||
            !surd_merge(&like->factor, &term.factor))
            continue;
        if (fmpq_is_zero(like->factor.c)) {
            term_clear(like);
            *like = z->terms[--z->length];
        }
        term_clear(&term);
        return;
    }
    z->terms = flint_realloc(z->terms, (size_t)(z->length + 1) * sizeof *z->terms);
    z->terms[z->length++] = term;
}

static const struct surds NOTHING = {0, NULL};

void exact_init(struct exact *x)
{
    *x = (struct exact){.kind = EXACT_SUM};
}

void exact_clear(struct exact *x)
{
    for (slong k = 0; k < x->length; k++)
        term_clear(x->terms + k);
    flint_free(x->terms);
}

/* z = r, which is used up: results are built apart from z, which may be an operand. */
static void become(struct exact *z, struct exact *r)
{
    exact_clear(z);
    *z = *r;
}

static void become_unknown(struct exact *z, bool pole)
{
    exact_clear(z);
    *z = (struct exact){.kind = EXACT_UNKNOWN, .pole = pole};
}

/* Perhaps no number: then not even zero times it is zero. */
static bool unsafe(const struct exact *x)
{
    return x->kind == EXACT_INFINITE || x->pole;
}

/* z = factor x, the factor not zero: no two terms to merge */
static void scale(struct exact *z, const struct exact *x, const struct surd *factor)
{
    struct exact r = {.kind = x->kind, .pole = x->pole, .length = x->length};
    if (x->length > 0)
        r.terms = flint_calloc((size_t)x->length, sizeof *r.terms);
    for (slong k = 0; k < x->length; k++) {
        surd_init(&r.terms[k].factor);
        surd_mul(&r.terms[k].factor, &x->terms[k].factor, factor);
        surds_addmul(&r.terms[k].exponent, &x->terms[k].exponent, &ONE);
    }
    become(z, &r);
}

void exact_set(struct exact *z, const struct exact *x)
{
    scale(z, x, &ONE);
}

void exact_set_fmpq(struct exact *z, const fmpq_t q)
{
    struct exact r = {.kind = EXACT_SUM};
    struct surd rational;
    surd_init(&rational);
    fmpq_set(rational.c, q);
    if (!fmpq_is_zero(q))
        add_term(&r, &rational, &NOTHING, &NOTHING);
    surd_clear(&rational);
    become(z, &r);
}

static void set_si(struct exact *z, slong n)
{
    fmpq_t q;
    fmpq_init(q);
    fmpq_set_si(q, n, 1);
    exact_set_fmpq(z, q);
    fmpq_clear(q);
}

void exact_set_infinity(struct exact *z)
{
    become_unknown(z, false);
    z->kind = EXACT_INFINITE;
}

/* ---- arithmetic ------------------------------------------------------- */

void exact_neg(struct exact *z, const struct exact *x)
{
    if (x->kind == EXACT_INFINITE)
        become_unknown(z, true);
    else
        scale(z, x, &MINUS_ONE);
}

/* z = x + sign y */
static void combine(struct exact *z, const struct exact *x, const struct exact *y,
                    const struct surd *sign)
{
    if (x->kind != EXACT_SUM || y->kind != EXACT_SUM || x->length + y->length > MOST_TERMS) {
        become_unknown(z, unsafe(x) || unsafe(y));
        return;
    }
    struct exact r, s;
    exact_init(&r);
    exact_init(&s);
    exact_set(&r, x);
    scale(&s, y, sign);
    for (slong k = 0; k < s.length; k++)
        add_term(&r, &s.terms[k].factor, &s.terms[k].exponent, &NOTHING);
    exact_clear(&s);
    become(z, &r);
}

void exact_add(struct exact *z, const struct exact *x, const struct exact *y)
{
    combine(z, x, y, &ONE);
}

void exact_sub(struct exact *z, const struct exact *x, const struct exact *y)
{
    combine(z, x, y, &MINUS_ONE);
}

void exact_mul(struct exact *z, const struct exact *x, const struct exact *y)
{
    bool zero = (exact_is_zero(x) && !unsafe(y)) || (exact_is_zero(y) && !unsafe(x));
    bool sums = x->kind == EXACT_SUM && y->kind == EXACT_SUM && x->length * y->length <= MOST_TERMS;
    if (!zero && !sums) {
        become_unknown(z, unsafe(x) || unsafe(y));
        return;
    }
    struct exact r = {.kind = EXACT_SUM};
    struct surd product;
    surd_init(&product);
    for (slong j = 0; j < x->length; j++) {
        for (slong k = 0; k < y->length; k++) {
            surd_mul(&product, &x->terms[j].factor, &y->terms[k].factor);
            add_term(&r, &product, &x->terms[j].exponent, &y->terms[k].exponent);
        }
    }
    surd_clear(&product);
    become(z, &r);
}

/* 1/(c sqrt(n) e^b) = 1/(c n) sqrt(n) e^-b */
static void invert_term(struct exact *z, const struct exact_term *t)
{
    struct exact r = {.kind = EXACT_SUM};
    struct surd factor;
    struct surds exponent = {0, NULL};
    surd_init(&factor);
    fmpz_set(factor.n, t->factor.n);
    fmpq_mul_fmpz(factor.c, t->factor.c, t->factor.n);
    fmpq_inv(factor.c, factor.c);
    surds_addmul(&exponent, &t->exponent, &MINUS_ONE);
    add_term(&r, &factor, &exponent, &NOTHING);
    surd_clear(&factor);
    surds_clear(&exponent);
    become(z, &r);
}

static bool algebraic(const struct exact *x)
{
    bool none = x->kind == EXACT_SUM;
    for (slong k = 0; k < x->length; k++)
        none = none && x->terms[k].exponent.length == 0;
    return none;
}

/*
 * z = 1/x for a sum that is not empty. With the sign of the last of two or three surds changed, the
 * product is (a + b)^2 - c^2, at most two surds, and not zero, for neither factor is.
 */
static void invert(struct exact *z, const struct exact *x)
{
    if (x->length == 1) {
        invert_term(z, x->terms);
        return;
    }
    if (x->length > 3 || !algebraic(x)) {
        become_unknown(z, false);
        return;
    }
    struct exact other, norm;
    exact_init(&other);
    exact_init(&norm);
    exact_set(&other, x);
    struct surd *last = &other.terms[other.length - 1].factor;
    fmpq_neg(last->c, last->c);
    exact_mul(&norm, x, &other);
    invert(&norm, &norm);
    exact_mul(z, &other, &norm);
    exact_clear(&other);
    exact_clear(&norm);
}

void exact_div(struct exact *z, const struct exact *x, const struct exact *y)
{
    if (unsafe(x) || y->pole || y->kind == EXACT_UNKNOWN || exact_is_zero(y)) {
        become_unknown(z, true);
    } else if (y->kind == EXACT_INFINITE) {
        set_si(z, 0);
    } else {
        struct exact inverse;
        exact_init(&inverse);
        invert(&inverse, y);
        exact_mul(z, x, &inverse);
        exact_clear(&inverse);
    }
}

void exact_pow(struct exact *z, const struct exact *x, slong n)
{
    struct exact power, square;
    exact_init(&power);
    exact_init(&square);
    set_si(&power, 1);
    exact_set(&square, x);
    for (ulong k = n < 0 ? -(ulong)n : (ulong)n; k > 0; k /= 2) {
        if (k % 2 == 1)
            exact_mul(&power, &power, &square);
        if (k > 1)
            exact_mul(&square, &square, &square);
    }
    if (n < 0) {
        set_si(&square, 1);
        exact_div(&power, &square, &power);
    }
    exact_clear(&square);
    become(z, &power);
}

/* The sign of a sum: it ends, for a sum that is not empty is not zero. */
static int sign(const struct exact *x)
{
    arb_t enclosure;
    arb_init(enclosure);
    for (slong prec = 64; x->length > 0 && arb_contains_zero(enclosure); prec *= 2)
        exact_enclosure(enclosure, x, prec);
    int result = arb_is_positive(enclosure) - arb_is_negative(enclosure);
    arb_clear(enclosure);
    return result;
}

/* sqrt(p/q) = 1/q sqrt(p q) */
void exact_sqrt(struct exact *z, const struct exact *x)
{
    fmpq_t q;
    fmpq_init(q);
    bool negative = x->kind == EXACT_SUM && sign(x) < 0;
    if (x->kind != EXACT_SUM || negative || !exact_is_rational(q, x)) {
        become_unknown(z, negative || x->kind != EXACT_SUM);
    } else if (fmpq_is_zero(q)) {
        set_si(z, 0);
    } else {
        struct exact r = {.kind = EXACT_SUM};
        struct surd root;
        surd_init(&root);
        fmpq_div_fmpz(root.c, ONE.c, fmpq_denref(q));
        fmpz_mul(root.n, fmpq_numref(q), fmpq_denref(q));
        surd_mul(&root, &root, &ONE); /* a square leaves the radicand */
        add_term(&r, &root, &NOTHING, &NOTHING);
        surd_clear(&root);
        become(z, &r);
    }
    fmpq_clear(q);
}

/* z += factor e^(direction x) */
static void add_exponential(struct exact *z, const struct surd *factor,
                            const struct surd *direction, const struct exact *x)
{
    struct surds exponent = {0, NULL};
    struct surd product;
    surd_init(&product);
    for (slong k = 0; k < x->length; k++) {
        surd_mul(&product, &x->terms[k].factor, direction);
        surds_add_surd(&exponent, &product);
    }
    add_term(z, factor, &exponent, &NOTHING);
    surd_clear(&product);
    surds_clear(&exponent);
}

/* sin x = 1/2 i e^(-i x) - 1/2 i e^(i x) */
void exact_sin(struct exact *z, const struct exact *x)
{
    if (!algebraic(x)) {
        become_unknown(z, unsafe(x));
        return;
    }
    struct exact r = {.kind = EXACT_SUM};
    add_exponential(&r, &HALF_IMAGINARY, &MINUS_IMAGINARY, x);
    add_exponential(&r, &MINUS_HALF_IMAGINARY, &IMAGINARY, x);
    become(z, &r);
}

/* cos x = 1/2 e^(-i x) + 1/2 e^(i x) */
void exact_cos(struct exact *z, const struct exact *x)
{
    if (!algebraic(x)) {
        become_unknown(z, unsafe(x));
        return;
    }
    struct exact r = {.kind = EXACT_SUM};
    add_exponential(&r, &HALF, &MINUS_IMAGINARY, x);
    add_exponential(&r, &HALF, &IMAGINARY, x);
    become(z, &r);
}

void exact_exp(struct exact *z, const struct exact *x)
{
    if (!algebraic(x)) {
        become_unknown(z, unsafe(x));
        return;
    }
    struct exact r = {.kind = EXACT_SUM};
    add_exponential(&r, &ONE, &ONE, x);
    become(z, &r);
}

void exact_atan2(struct exact *z, const struct exact *y, const struct exact *x)
{
    if (exact_is_zero(y) && x->kind == EXACT_SUM && sign(x) >= 0)
        set_si(z, 0);
    else
        become_unknown(z, unsafe(x) || unsafe(y));
}

void exact_positive(struct exact *z, const struct exact *x)
{
    if (x->kind == EXACT_SUM)
        set_si(z, sign(x) > 0);
    else
        become_unknown(z, unsafe(x));
}

/* ---- questions -------------------------------------------------------- */

bool exact_is_zero(const struct exact *x)
{
    return x->kind == EXACT_SUM && x->length == 0;
}

bool exact_is_rational(fmpq_t value, const struct exact *x)
{
    if (exact_is_zero(x)) {
        fmpq_zero(value);
        return true;
    }
    bool rational = x->length == 1 && algebraic(x) && fmpz_is_one(x->terms->factor.n);
    if (rational)
        fmpq_set(value, x->terms->factor.c);
    return rational;
}

bool exact_is_unknown(const struct exact *x)
{
    return x->kind != EXACT_SUM;
}

static void surd_enclosure(acb_t y, const struct surd *x, slong prec)
{
    arb_t c;
    arb_init(c);
    acb_set_fmpz(y, x->n);
    acb_sqrt(y, y, prec);
    arb_set_fmpq(c, x->c, prec);
    acb_mul_arb(y, y, c, prec);
    arb_clear(c);
}

void exact_enclosure(arb_t y, const struct exact *x, slong prec)
{
    acb_t sum, term, exponent;
    acb_init(sum);
    acb_init(term);
    acb_init(exponent);
    for (slong k = 0; k < x->length; k++) {
        const struct surds *surds = &x->terms[k].exponent;
        acb_zero(exponent);
        for (slong j = 0; j < surds->length; j++) {
            surd_enclosure(term, surds->surds + j, prec);
            acb_add(exponent, exponent, term, prec);
        }
        surd_enclosure(term, &x->terms[k].factor, prec);
        acb_exp(exponent, exponent, prec);
        acb_addmul(sum, term, exponent, prec);
    }
    if (x->kind == EXACT_SUM)
        arb_set(y, acb_realref(sum));
    else
        arb_indeterminate(y);
    acb_clear(sum);
    acb_clear(term);
    acb_clear(exponent);
}
