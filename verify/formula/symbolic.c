#include "formula/symbolic.h"

#include <stdio.h>
#include <stdlib.h>
#include <time.h>

#include "text/message.h"
#include "text/scope.h"

typedef fmpz_mpoly_q_struct quotient;

/* ---- the field ---- */

/* What bounds a step: the terms of a product before it is made, the bits of a number, the degree, seconds in all. */
enum { MOST_TERMS = 1000000, MOST_BITS = 100000, MOST_DEGREE = 100000, MOST_SECONDS = 2, MOST_ROOTS = 64 };

/* A variable that stands for a function's value. */
struct opaque {
    enum operator op;
    struct symbolic x, y;
};

static struct {
    fmpz_mpoly_ctx_t ctx;
    slong variables, more, opaques;
    bool loose, large;
    struct opaque *opaque;
    quotient roots[MOST_ROOTS];
    bool strict[MOST_ROOTS], used[MOST_ROOTS];
    int root_count;
    clock_t start;
    char size[80];
} field;

#define CTX field.ctx

void symbolic_begin(slong variables, slong more, bool loose)
{
    fmpz_mpoly_ctx_init(CTX, variables + more > 0 ? variables + more : 1, ORD_DEGLEX);
    field.variables = variables;
    field.more = more;
    field.loose = loose;
    field.large = false;
    field.opaques = 0;
    field.opaque = xrealloc(NULL, (size_t)more + 1, sizeof *field.opaque);
    field.root_count = 0;
    field.start = clock();
}

static void symbolic_clear(void *x);

void symbolic_end(void)
{
    for (slong i = 0; i < field.opaques; i++) {
        symbolic_clear(&field.opaque[i].x);
        symbolic_clear(&field.opaque[i].y);
    }
    for (int i = 0; i < field.root_count; i++)
        fmpz_mpoly_q_clear(&field.roots[i], CTX);
    free(field.opaque);
    fmpz_mpoly_ctx_clear(CTX);
}

const fmpz_mpoly_ctx_struct *symbolic_context(void)
{
    return CTX;
}

const char *symbolic_fault_size(void)
{
    return field.size;
}

const char *symbolic_fault_text(enum symbolic_fault fault)
{
    static const char *const texts[] = {
        [SYMBOLIC_FINE] = "fine",
        [SYMBOLIC_POLE] = "division by what is zero at epsilon = 0",
        [SYMBOLIC_NO_SQUARE] = "the square root of no square of a rational function",
        [SYMBOLIC_UNKNOWN_ROOT] = "a square root that is none of the step's square roots, up to its sign",
        [SYMBOLIC_ZERO_ROOT] = "a series of a square root that may be zero",
        [SYMBOLIC_NUMBER_AS_ANGLE] = "the sine or cosine of a number that is no angle",
        [SYMBOLIC_ANGLE_AS_NUMBER] = "a finite angle outside sine and cosine",
        [SYMBOLIC_TRANSCENDENTAL] = "a value that is no rational series, or whose sign is not known",
        [SYMBOLIC_TOO_LARGE] = "too large to normalise",
    };
    return texts[fault];
}

/* ---- rational functions, within bounds ---- */

static bool is_zero(const quotient *x)
{
    return fmpz_mpoly_is_zero(fmpz_mpoly_q_numref(x), CTX);
}

static double bits_of(const quotient *x)
{
    slong over = fmpz_mpoly_max_bits(fmpz_mpoly_q_numref(x)), under = fmpz_mpoly_max_bits(fmpz_mpoly_q_denref(x));
    return (double)FLINT_MAX(FLINT_ABS(over), FLINT_ABS(under));
}

static double degree_of(const quotient *x)
{
    return (double)FLINT_MAX(fmpz_mpoly_total_degree_si(fmpz_mpoly_q_numref(x), CTX),
                             fmpz_mpoly_total_degree_si(fmpz_mpoly_q_denref(x), CTX));
}

static double terms_of(const quotient *x)
{
    return (double)(fmpz_mpoly_length(fmpz_mpoly_q_numref(x), CTX) + fmpz_mpoly_length(fmpz_mpoly_q_denref(x), CTX));
}

static bool refuse(const char *what, double size)
{
    field.large = true;
    snprintf(field.size, sizeof field.size, "%s: %.3g", what, size);
    return false;
}

/* Whether x op y may be made: as large as it may become it is within bounds. */
static bool may_combine(const quotient *x, const quotient *y)
{
    const double seconds = (double)(clock() - field.start) / CLOCKS_PER_SEC;
    if (field.large)
        return false;
    if (terms_of(x) * terms_of(y) > MOST_TERMS)
        return refuse("terms", terms_of(x) * terms_of(y));
    if (bits_of(x) + bits_of(y) > MOST_BITS)
        return refuse("bits of a number", bits_of(x) + bits_of(y));
    if (degree_of(x) + degree_of(y) > MOST_DEGREE)
        return refuse("degree", degree_of(x) + degree_of(y));
    return seconds <= MOST_SECONDS || refuse("seconds", seconds);
}

static void multiply(quotient *z, const quotient *x, const quotient *y)
{
    if (may_combine(x, y))
        fmpz_mpoly_q_mul(z, x, y, CTX);
}

static void divide(quotient *z, const quotient *x, const quotient *y)
{
    if (may_combine(x, y))
        fmpz_mpoly_q_div(z, x, y, CTX);
}

/* z *= p/q */
static void scale(quotient *z, slong p, ulong q)
{
    SCOPE(fmpq, factor);
    fmpq_set_si(factor, p, q);
    if (p != 1 || q != 1)
        fmpz_mpoly_q_mul_fmpq(z, z, factor, CTX);
}

/* z += x y p/q */
static void add_product(quotient *z, const quotient *x, const quotient *y, slong p, ulong q)
{
    fmpz_mpoly_q_t product;
    if (is_zero(x) || is_zero(y))
        return;
    fmpz_mpoly_q_init(product, CTX);
    multiply(product, x, y);
    scale(product, p, q);
    if (may_combine(z, product))
        fmpz_mpoly_q_add(z, z, product, CTX);
    fmpz_mpoly_q_clear(product, CTX);
}

/* ---- coefficients by the dozen ---- */

static quotient *series_new(slong terms)
{
    quotient *a = xrealloc(NULL, (size_t)terms, sizeof *a);
    for (slong k = 0; k < terms; k++)
        fmpz_mpoly_q_init(a + k, CTX);
    return a;
}

static void series_free(quotient *a, slong terms)
{
    for (slong k = 0; k < terms; k++)
        fmpz_mpoly_q_clear(a + k, CTX);
    free(a);
}

/* z takes the coefficients over, and is a number. */
static void take(struct symbolic *z, quotient *a)
{
    series_free(z->a, z->terms);
    z->a = a;
    z->angle = z->large = false;
}

static quotient *product(const quotient *x, const quotient *y, slong terms)
{
    quotient *z = series_new(terms);
    for (slong k = 0; k < terms; k++)
        for (slong j = 0; j <= k; j++)
            add_product(z + k, x + j, y + k - j, 1, 1);
    return z;
}

static quotient *ratio(const quotient *x, const quotient *y, slong terms)
{
    quotient *z = series_new(terms);
    for (slong k = 0; k < terms; k++) {
        fmpz_mpoly_q_set(z + k, x + k, CTX);
        for (slong j = 1; j <= k; j++)
            add_product(z + k, y + j, z + k - j, -1, 1);
        divide(z + k, z + k, y);
    }
    return z;
}

static quotient *power(const quotient *x, slong exponent, slong terms)
{
    quotient *z = series_new(terms), *next;
    fmpz_mpoly_q_set_si(z, 1, CTX);
    for (slong bit = (slong)FLINT_BIT_COUNT(FLINT_ABS(exponent)); bit-- > 0 && !field.large;) {
        next = product(z, z, terms);
        series_free(z, terms);
        z = next;
        if (FLINT_ABS(exponent) >> bit & 1) {
            next = product(z, x, terms);
            series_free(z, terms);
            z = next;
        }
    }
    if (exponent < 0 && !field.large) {
        quotient *one = series_new(terms);
        fmpz_mpoly_q_set_si(one, 1, CTX);
        next = ratio(one, z, terms);
        series_free(one, terms);
        series_free(z, terms);
        z = next;
    }
    return z;
}

/* ---- numbers ---- */

static void symbolic_init(void *x, slong terms)
{
    struct symbolic *z = x;
    *z = (struct symbolic){.a = series_new(terms), .terms = terms};
    fmpz_mpoly_q_init(&z->c, CTX);
    fmpz_mpoly_q_init(&z->s, CTX);
}

static void symbolic_clear(void *x)
{
    struct symbolic *z = x;
    series_free(z->a, z->terms);
    fmpz_mpoly_q_clear(&z->c, CTX);
    fmpz_mpoly_q_clear(&z->s, CTX);
}

static void symbolic_set(void *to, const void *from)
{
    struct symbolic *z = to;
    const struct symbolic *x = from;
    for (slong k = 0; k < z->terms; k++)
        fmpz_mpoly_q_set(z->a + k, x->a + k, CTX);
    fmpz_mpoly_q_set(&z->c, &x->c, CTX);
    fmpz_mpoly_q_set(&z->s, &x->s, CTX);
    z->angle = x->angle;
    z->large = x->large;
    z->fault = x->fault;
}

static void set_rational(void *x, const fmpq_t q, slong terms)
{
    struct symbolic *z = x;
    for (slong k = 1; k < terms; k++)
        fmpz_mpoly_q_set_si(z->a + k, 0, CTX);
    fmpz_mpoly_q_set_fmpq(z->a, q, CTX);
    z->angle = z->large = false;
    z->fault = SYMBOLIC_FINE;
}

static void set_zero(struct symbolic *z)
{
    SCOPE(fmpq, zero);
    set_rational(z, zero, z->terms);
}

void symbolic_set_variable(struct symbolic *z, slong variable, slong degree)
{
    set_zero(z);
    if (degree < z->terms)
        fmpz_mpoly_gen(fmpz_mpoly_q_numref(z->a + degree), variable, CTX);
}

void symbolic_set_angle(struct symbolic *z, slong variable)
{
    fmpz_mpoly_q_t c, s;
    fmpz_mpoly_t t;
    set_zero(z);
    fmpz_mpoly_init(t, CTX);
    fmpz_mpoly_q_init(c, CTX);
    fmpz_mpoly_q_init(s, CTX);
    fmpz_mpoly_gen(t, variable, CTX);
    fmpz_mpoly_scalar_mul_si(fmpz_mpoly_q_numref(s), t, 2, CTX);
    fmpz_mpoly_mul(t, t, t, CTX);
    fmpz_mpoly_add_si(fmpz_mpoly_q_denref(s), t, 1, CTX);
    fmpz_mpoly_add_si(fmpz_mpoly_q_denref(c), t, 1, CTX);
    fmpz_mpoly_neg(t, t, CTX);
    fmpz_mpoly_add_si(fmpz_mpoly_q_numref(c), t, 1, CTX);
    fmpz_mpoly_q_canonicalise(s, CTX);
    fmpz_mpoly_q_canonicalise(c, CTX);
    fmpz_mpoly_q_swap(&z->c, c, CTX);
    fmpz_mpoly_q_swap(&z->s, s, CTX);
    fmpz_mpoly_q_clear(c, CTX);
    fmpz_mpoly_q_clear(s, CTX);
    fmpz_mpoly_clear(t, CTX);
    z->angle = true;
}

bool symbolic_get_polynomial(fmpq_poly_t f, const struct symbolic *x)
{
    const fmpz_mpoly_struct *over = fmpz_mpoly_q_numref(x->a), *under = fmpz_mpoly_q_denref(x->a);
    SCOPE(fmpz, c);
    fmpq_poly_zero(f);
    if (x->fault != SYMBOLIC_FINE || x->angle || !fmpz_mpoly_is_fmpz(under, CTX))
        return false;
    for (slong i = 0; i < fmpz_mpoly_length(over, CTX); i++) {
        fmpz_mpoly_get_term_coeff_fmpz(c, over, i, CTX);
        fmpq_poly_set_coeff_fmpz(f, fmpz_mpoly_get_term_var_exp_si(over, i, 0, CTX), c);
    }
    fmpz_mpoly_get_fmpz(c, under, CTX);
    fmpq_poly_scalar_div_fmpz(f, f, c);
    return true;
}

bool symbolic_get_rational(fmpq_t q, const struct symbolic *x)
{
    SCOPE(fmpq_poly, f);
    const bool constant = symbolic_get_polynomial(f, x) && fmpq_poly_degree(f) <= 0;
    fmpq_zero(q);
    if (constant)
        fmpq_poly_get_coeff_fmpq(q, f, 0);
    return constant;
}

/* ---- functions ---- */

static bool same(const struct symbolic *x, const struct symbolic *y)
{
    bool equal = x->angle == y->angle && (!x->angle || (fmpz_mpoly_q_equal(&x->c, &y->c, CTX) &&
                                                        fmpz_mpoly_q_equal(&x->s, &y->s, CTX)));
    for (slong k = 0; k < x->terms && equal; k++)
        equal = fmpz_mpoly_q_equal(x->a + k, y->a + k, CTX);
    return equal;
}

/* The variable that stands for op(x, y): the one it has already, or the next. False where there is no room. */
static bool stand_for(struct symbolic *z, enum operator op, const struct symbolic *x, const struct symbolic *y)
{
    slong i = 0;
    if (y == NULL)
        y = x;
    while (i < field.opaques && !(field.opaque[i].op == op && same(&field.opaque[i].x, x) && same(&field.opaque[i].y, y)))
        i++;
    if (!field.loose || i == field.more)
        return false;
    if (i == field.opaques) {
        struct opaque *new = &field.opaque[field.opaques++];
        new->op = op;
        symbolic_init(&new->x, x->terms);
        symbolic_init(&new->y, x->terms);
        symbolic_set(&new->x, x);
        symbolic_set(&new->y, y);
    }
    if (op == OPERATOR_ATAN2)
        symbolic_set_angle(z, field.variables + i);
    else
        symbolic_set_variable(z, field.variables + i, 0);
    return true;
}

static void fail(struct symbolic *z, enum symbolic_fault fault, enum operator op, const struct symbolic *x,
                 const struct symbolic *y)
{
    if (!stand_for(z, op, x, y))
        z->fault = fault;
}

void symbolic_root(const struct symbolic *x, bool strict)
{
    if (field.root_count == MOST_ROOTS)
        return; /* LCOV_EXCL_LINE: a list of square roots is as long at most */
    fmpz_mpoly_q_init(&field.roots[field.root_count], CTX);
    if (x != NULL)
        fmpz_mpoly_q_set(&field.roots[field.root_count], x->a, CTX);
    field.strict[field.root_count] = strict;
    field.used[field.root_count++] = false;
}

bool symbolic_root_used(int i)
{
    return field.used[i];
}

/* Which of the roots has this square; a constant has its own. Its fault, and *strict: the root is above zero. */
static enum symbolic_fault find_root(quotient *root, const quotient *square, bool *strict)
{
    fmpz_mpoly_q_t other;
    enum symbolic_fault fault = SYMBOLIC_NO_SQUARE;
    fmpz_mpoly_q_init(other, CTX);
    const bool is_square = fmpz_mpoly_sqrt(fmpz_mpoly_q_numref(root), fmpz_mpoly_q_numref(square), CTX) &&
                           fmpz_mpoly_sqrt(fmpz_mpoly_q_denref(root), fmpz_mpoly_q_denref(square), CTX);
    if (is_square && is_zero(square)) {
        fmpz_mpoly_q_set_si(root, 0, CTX);
        *strict = false;
        fault = SYMBOLIC_FINE;
    } else if (is_square && fmpz_mpoly_is_fmpz(fmpz_mpoly_q_numref(root), CTX) &&
               fmpz_mpoly_is_fmpz(fmpz_mpoly_q_denref(root), CTX)) { /* FLINT takes the positive one of a number's */
        *strict = true;
        fault = SYMBOLIC_FINE;
    } else if (is_square) {
        fault = SYMBOLIC_UNKNOWN_ROOT;
        for (int i = 0; i < field.root_count && fault != SYMBOLIC_FINE; i++) {
            fmpz_mpoly_q_neg(other, &field.roots[i], CTX);
            if (!fmpz_mpoly_q_equal(root, &field.roots[i], CTX) && !fmpz_mpoly_q_equal(root, other, CTX))
                continue;
            fmpz_mpoly_q_set(root, &field.roots[i], CTX);
            *strict = field.strict[i];
            field.used[i] = true;
            fault = SYMBOLIC_FINE;
        }
    }
    fmpz_mpoly_q_clear(other, CTX);
    return fault;
}

/* r^2 = x, coefficient by coefficient: 2 r_0 r_k is x_k without the products of what is known. */
static void square_root(struct symbolic *z, const struct symbolic *x)
{
    const slong terms = x->terms;
    quotient *r = series_new(terms);
    bool strict = false;
    enum symbolic_fault fault = find_root(r, x->a, &strict);
    if (fault == SYMBOLIC_FINE && terms > 1 && !strict) /* zero to this order is not enough: that of epsilon^2 is epsilon */
        fault = is_zero(r) ? SYMBOLIC_NO_SQUARE : SYMBOLIC_ZERO_ROOT;
    for (slong k = 1; k < terms && fault == SYMBOLIC_FINE; k++) {
        fmpz_mpoly_q_set(r + k, x->a + k, CTX);
        for (slong j = 1; j < k; j++)
            add_product(r + k, r + j, r + k - j, -1, 1);
        divide(r + k, r + k, r);
        scale(r + k, 1, 2);
    }
    if (fault == SYMBOLIC_FINE) {
        take(z, r);
        return;
    }
    series_free(r, terms);
    fail(z, fault, OPERATOR_SQRT, x, NULL);
}

/* The sine and cosine of p_1 epsilon + ..., by s' = p' c and c' = -p' s. */
static void sine_and_cosine(quotient *s, quotient *c, const quotient *p, slong terms)
{
    fmpz_mpoly_q_set_si(c, 1, CTX);
    for (slong k = 1; k < terms; k++)
        for (slong j = 1; j <= k; j++) {
            add_product(s + k, p + j, c + k - j, j, (ulong)k);
            add_product(c + k, p + j, s + k - j, -j, (ulong)k);
        }
}

/* Of an angle with a finite part and a series on top, by the sums of angles. */
static void trigonometric(struct symbolic *z, enum operator op, const struct symbolic *x)
{
    const slong terms = x->terms;
    if (!is_zero(x->a)) {
        fail(z, SYMBOLIC_NUMBER_AS_ANGLE, op, x, NULL);
        return;
    }
    quotient *s = series_new(terms), *c = series_new(terms), *turned = series_new(terms);
    sine_and_cosine(s, c, x->a, terms);
    for (slong k = 0; k < terms && x->angle; k++) {
        add_product(turned + k, op == OPERATOR_SIN ? &x->s : &x->c, c + k, 1, 1);
        add_product(turned + k, op == OPERATOR_SIN ? &x->c : &x->s, s + k, op == OPERATOR_SIN ? 1 : -1, 1);
    }
    quotient *result = x->angle ? turned : op == OPERATOR_SIN ? s : c;
    if (result != s)
        series_free(s, terms);
    if (result != c)
        series_free(c, terms);
    if (result != turned)
        series_free(turned, terms);
    take(z, result);
}

/* e' = p' e */
static void exponential(struct symbolic *z, const struct symbolic *x)
{
    if (!is_zero(x->a)) {
        fail(z, SYMBOLIC_TRANSCENDENTAL, OPERATOR_EXP, x, NULL);
        return;
    }
    quotient *e = series_new(x->terms);
    fmpz_mpoly_q_set_si(e, 1, CTX);
    for (slong k = 1; k < x->terms; k++)
        for (slong j = 1; j <= k; j++)
            add_product(e + k, x->a + j, e + k - j, j, (ulong)k);
    take(z, e);
}

/* The angle of a point off the origin: of constants in epsilon. */
static void arc_tangent(struct symbolic *z, const struct symbolic *y, const struct symbolic *x)
{
    bool strict = false;
    fmpz_mpoly_q_t square, r;
    fmpz_mpoly_q_init(square, CTX);
    fmpz_mpoly_q_init(r, CTX);
    add_product(square, x->a, x->a, 1, 1);
    add_product(square, y->a, y->a, 1, 1);
    enum symbolic_fault fault = x->terms > 1 ? SYMBOLIC_TRANSCENDENTAL : find_root(r, square, &strict);
    if (fault == SYMBOLIC_FINE && !strict)
        fault = is_zero(r) ? SYMBOLIC_POLE : SYMBOLIC_ZERO_ROOT;
    if (fault == SYMBOLIC_FINE) {
        fmpz_mpoly_q_t s;
        fmpz_mpoly_q_init(s, CTX);
        divide(s, y->a, r);
        divide(&z->c, x->a, r);
        fmpz_mpoly_q_swap(&z->s, s, CTX);
        fmpz_mpoly_q_set_si(z->a, 0, CTX);
        z->angle = true;
        fmpz_mpoly_q_clear(s, CTX);
    } else {
        fail(z, fault, OPERATOR_ATAN2, y, x);
    }
    fmpz_mpoly_q_clear(square, CTX);
    fmpz_mpoly_q_clear(r, CTX);
}

/* ---- arithmetic ---- */

static void add(struct symbolic *z, const struct symbolic *x, const struct symbolic *y, slong sign)
{
    quotient *sum = series_new(z->terms);
    const bool angle = x->angle || y->angle;
    fmpz_mpoly_q_t c, s, one, none;
    fmpz_mpoly_q_init(c, CTX);
    fmpz_mpoly_q_init(s, CTX);
    fmpz_mpoly_q_init(one, CTX);
    fmpz_mpoly_q_init(none, CTX);
    fmpz_mpoly_q_set_si(one, 1, CTX);
    if (angle) { /* what is no angle has the cosine 1 and the sine 0 */
        const quotient *xc = x->angle ? &x->c : one, *xs = x->angle ? &x->s : none;
        const quotient *yc = y->angle ? &y->c : one, *ys = y->angle ? &y->s : none;
        add_product(c, xc, yc, 1, 1);
        add_product(c, xs, ys, -sign, 1);
        add_product(s, xs, yc, 1, 1);
        add_product(s, xc, ys, sign, 1);
    }
    for (slong k = 0; k < z->terms; k++) {
        add_product(sum + k, x->a + k, one, 1, 1);
        add_product(sum + k, y->a + k, one, sign, 1);
    }
    take(z, sum);
    z->angle = angle;
    fmpz_mpoly_q_swap(&z->c, c, CTX);
    fmpz_mpoly_q_swap(&z->s, s, CTX);
    fmpz_mpoly_q_clear(c, CTX);
    fmpz_mpoly_q_clear(s, CTX);
    fmpz_mpoly_q_clear(one, CTX);
    fmpz_mpoly_q_clear(none, CTX);
}

static void quotient_of(struct symbolic *z, const struct symbolic *x, const struct symbolic *y)
{
    if (y->large) {
        take(z, product(x->a, y->a, x->terms));
    } else if (!is_zero(y->a)) {
        take(z, ratio(x->a, y->a, x->terms));
    } else {
        const bool large = !is_zero(x->a);
        if (large)
            take(z, ratio(y->a, x->a, x->terms));
        z->fault = SYMBOLIC_POLE;
        z->large = large;
    }
}

static enum symbolic_fault operand_fault(enum operator op, const struct symbolic *x)
{
    const bool takes_angles = op == OPERATOR_NEGATE || op == OPERATOR_ADD || op == OPERATOR_SUBTRACT ||
                              op == OPERATOR_SIN || op == OPERATOR_COS;
    return x->fault == SYMBOLIC_FINE && x->angle && !takes_angles ? SYMBOLIC_ANGLE_AS_NUMBER : x->fault;
}

static void apply(enum operator op, void *result, const void *left, const void *right, slong exponent, slong terms)
{
    struct symbolic *z = result;
    const struct symbolic *x = left, *y = right != NULL ? right : left;
    z->fault = operand_fault(op, x);
    if (z->fault == SYMBOLIC_FINE && !(op == OPERATOR_DIVIDE && y->large))
        z->fault = operand_fault(op, y);
    z->large = false;
    if (z->fault != SYMBOLIC_FINE)
        return;
    switch (op) {
    case OPERATOR_NEGATE:
        symbolic_set(z, x);
        for (slong k = 0; k < terms; k++)
            fmpz_mpoly_q_neg(z->a + k, z->a + k, CTX);
        fmpz_mpoly_q_neg(&z->s, &z->s, CTX);
        break;
    case OPERATOR_ADD:
    case OPERATOR_SUBTRACT:
        add(z, x, y, op == OPERATOR_ADD ? 1 : -1);
        break;
    case OPERATOR_MULTIPLY:
        take(z, product(x->a, y->a, terms));
        break;
    case OPERATOR_DIVIDE:
        quotient_of(z, x, y);
        break;
    case OPERATOR_POWER:
        if (exponent < 0 && is_zero(x->a))
            z->fault = SYMBOLIC_POLE;
        else
            take(z, power(x->a, exponent, terms));
        break;
    case OPERATOR_SQRT:
        square_root(z, x);
        break;
    case OPERATOR_SIN:
    case OPERATOR_COS:
        trigonometric(z, op, x);
        break;
    case OPERATOR_EXP:
        exponential(z, x);
        break;
    case OPERATOR_ATAN2:
        arc_tangent(z, x, y);
        break;
    case OPERATOR_INPUT: /* no operations, these two: never asked for */
    case OPERATOR_NUMBER:
    case OPERATOR_LOG:
    case OPERATOR_POSITIVE: /* a question of signs, which the caller has answered if it could */
        fail(z, SYMBOLIC_TRANSCENDENTAL, op, x, NULL);
        break;
    }
    if (field.large)
        z->fault = SYMBOLIC_TOO_LARGE;
}

const struct arithmetic arithmetic_symbolic = {
    .name = "symbolic",
    .size = sizeof(struct symbolic),
    .init = symbolic_init,
    .clear = symbolic_clear,
    .set = symbolic_set,
    .set_rational = set_rational,
    .apply = apply,
};
