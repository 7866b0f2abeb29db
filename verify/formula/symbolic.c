#include "formula/symbolic.h"

#include <stdio.h>
#include <stdlib.h>
#include <time.h>

#include "text/message.h"
#include "text/scope.h"

/* ---- the field ---- */

typedef fmpz_mpoly_q_struct quotient, *quotient_ptr;
typedef fmpz_mpoly_q_t quotient_t;

/*
 * What bounds a step: seconds in all, looked at before each call of the library, and for that call the terms of a product
 * before it is made, the bits of its numbers, both together, and the degree. Sums, products and quotients of two random
 * rational functions at these bounds, with a common factor or without one, took at most 0.7 s.
 */
enum { MOST_TERMS = 1000000, MOST_NUMBER_BITS = 100000, MOST_WORK = 200000000, MOST_DEGREE = 100000, MOST_SECONDS = 2 };
enum { MOST_ROOTS = 128 }; /* twice as many as a list of square roots may have */

/* A variable that stands for a function's value. */
struct opaque {
    enum operator op;
    struct symbolic x, y;
};

/* The field at work, within an outer one. */
static struct symbolic_field {
    struct symbolic_field *outer;
    fmpz_mpoly_ctx_t ctx;
    slong variables, more, opaques;
    bool large;
    struct opaque *opaque;
    quotient roots[MOST_ROOTS];
    bool used[MOST_ROOTS];
    int root_count;
    clock_t start;
    char size[80]; /* what is too large in it */
} *field;

#define CTX field->ctx

static void quotient_init(quotient_t x)
{
    fmpz_mpoly_q_init(x, CTX);
}

static void quotient_clear(quotient_t x)
{
    fmpz_mpoly_q_clear(x, CTX);
}

static quotient *_quotient_vec_init(slong count)
{
    quotient *v = xrealloc(NULL, (size_t)count, sizeof *v);
    for (slong k = 0; k < count; k++)
        quotient_init(v + k);
    return v;
}

static void _quotient_vec_clear(quotient *v, slong count)
{
    for (slong k = 0; k < count; k++)
        quotient_clear(v + k);
    free(v);
}

SCOPED(quotient)
SCOPED_VECTOR(quotient, quotient_ptr)

void symbolic_begin(slong variables, slong more)
{
    struct symbolic_field *outer = field;
    field = xrealloc(NULL, 1, sizeof *field);
    *field = (struct symbolic_field){.outer = outer, .variables = variables, .more = more, .start = clock()};
    fmpz_mpoly_ctx_init(CTX, variables + more + 1, ORD_DEGLEX); /* one at least */
    field->opaque = xrealloc(NULL, (size_t)more + 1, sizeof *field->opaque);
}

void symbolic_end(void)
{
    struct symbolic_field *outer = field->outer;
    while (field->opaques > 0) {
        struct opaque *last = &field->opaque[--field->opaques];
        arithmetic_symbolic.clear(&last->x);
        arithmetic_symbolic.clear(&last->y);
    }
    while (field->root_count > 0)
        quotient_clear(&field->roots[--field->root_count]);
    free(field->opaque);
    fmpz_mpoly_ctx_clear(CTX);
    free(field);
    field = outer;
}

const fmpz_mpoly_ctx_struct *symbolic_context(void)
{
    return CTX;
}

const char *symbolic_fault_text(enum symbolic_fault fault)
{
    static const char *const texts[] = {
        [SYMBOLIC_FINE] = "fine",
        [SYMBOLIC_POLE] = "division by what is zero at epsilon = 0",
        [SYMBOLIC_NO_SQUARE] = "the square root of no square of a rational function",
        [SYMBOLIC_UNKNOWN_ROOT] = "a square root that is none of the step's square roots, up to its sign",
        [SYMBOLIC_NUMBER_AS_ANGLE] = "the sine or cosine of a number that is no angle",
        [SYMBOLIC_ANGLE_AS_NUMBER] = "a finite angle outside sine and cosine",
        [SYMBOLIC_TRANSCENDENTAL] = "a value that is no rational series, or whose sign is not known",
    };
    return fault == SYMBOLIC_TOO_LARGE ? field->size : texts[fault];
}

/* ---- rational functions, within bounds ---- */

static bool is_zero(const quotient *x)
{
    return fmpz_mpoly_q_is_zero(x, CTX);
}

static double bits_of(const quotient *x)
{
    slong over = fmpz_mpoly_max_bits(fmpz_mpoly_q_numref(x)), under = fmpz_mpoly_max_bits(fmpz_mpoly_q_denref(x));
    return (double)FLINT_MAX(FLINT_ABS(over), FLINT_ABS(under));
}

static slong degree_of_polynomial(const fmpz_mpoly_t f)
{
    return fmpz_mpoly_is_fmpz(f, CTX) ? 0 : fmpz_mpoly_total_degree_si(f, CTX); /* at a point most are numbers */
}

static double degree_of(const quotient *x)
{
    return (double)FLINT_MAX(degree_of_polynomial(fmpz_mpoly_q_numref(x)), degree_of_polynomial(fmpz_mpoly_q_denref(x)));
}

static double terms_of(const quotient *x)
{
    return (double)(fmpz_mpoly_length(fmpz_mpoly_q_numref(x), CTX) + fmpz_mpoly_length(fmpz_mpoly_q_denref(x), CTX));
}

/* Whether x op y may be made: as large as it may become it is within bounds. */
static bool may_combine(const quotient *x, const quotient *y)
{
    const double terms = terms_of(x) * terms_of(y), bits = bits_of(x) + bits_of(y);
    const struct {
        const char *what;
        double size, most;
    } bounds[] = {{"terms", terms, MOST_TERMS},
                  {"bits of a number", bits, MOST_NUMBER_BITS},
                  {"terms times bits", terms * bits, MOST_WORK},
                  {"degree", degree_of(x) + degree_of(y), MOST_DEGREE},
                  {"seconds", (double)(clock() - field->start) / CLOCKS_PER_SEC, MOST_SECONDS}};
    for (size_t i = 0; i < sizeof bounds / sizeof *bounds && !field->large; i++)
        if (!(bounds[i].size <= bounds[i].most)) {
            field->large = true;
            snprintf(field->size, sizeof field->size, "too large to normalise, %s: %.3g", bounds[i].what, bounds[i].size);
        }
    return !field->large;
}

/* z += sign x */
static void accumulate(quotient *z, const quotient *x, slong sign)
{
    if (may_combine(z, x))
        (sign < 0 ? fmpz_mpoly_q_sub : fmpz_mpoly_q_add)(z, z, x, CTX);
}

/* z += x y p/q */
static void add_product(quotient *z, const quotient *x, const quotient *y, slong p, slong q)
{
    SCOPE(quotient, product);
    if (is_zero(x) || is_zero(y) || !may_combine(x, y))
        return;
    fmpz_mpoly_q_mul(product, x, y, CTX);
    if (p != 1)
        fmpz_mpoly_q_mul_si(product, product, p, CTX);
    if (q != 1)
        fmpz_mpoly_q_div_si(product, product, q, CTX);
    accumulate(z, product, 1);
}

static void divide(quotient *z, const quotient *x, const quotient *y)
{
    if (may_combine(x, y))
        fmpz_mpoly_q_div(z, x, y, CTX);
}

/* ---- series: z is zero before, and is not x or y ---- */

static void quotient_product(quotient *z, const quotient *x, const quotient *y, slong terms)
{
    for (slong k = 0; k < terms; k++)
        for (slong j = 0; j <= k; j++)
            add_product(z + k, x + j, y + k - j, 1, 1);
}

static void ratio(quotient *z, const quotient *x, const quotient *y, slong terms)
{
    for (slong k = 0; k < terms; k++) {
        fmpz_mpoly_q_set(z + k, x + k, CTX);
        for (slong j = 1; j <= k; j++)
            add_product(z + k, y + j, z + k - j, -1, 1);
        divide(z + k, z + k, y);
    }
}

static void exchange(quotient *x, quotient *y, slong terms)
{
    for (slong k = 0; k < terms; k++)
        fmpz_mpoly_q_swap(x + k, y + k, CTX);
}

static void power(quotient *z, const quotient *x, slong exponent, slong terms)
{
    fmpz_mpoly_q_one(z, CTX);
    for (slong bit = (slong)FLINT_BIT_COUNT(exponent); bit-- > 0;)
        for (int with_x = 0; with_x <= (exponent >> bit & 1) && !field->large; with_x++) {
            VECTOR(quotient, next, terms);
            quotient_product(next, z, with_x ? x : z, terms);
            exchange(z, next, terms);
        }
}

/* ---- numbers ---- */

/* Of the finite part of an angle: they stand behind the coefficients. */
static quotient *cosine(const struct symbolic *x)
{
    return x->a + x->terms;
}

static quotient *sine(const struct symbolic *x)
{
    return x->a + x->terms + 1;
}

static void symbolic_init(void *x, slong terms)
{
    struct symbolic *z = x;
    *z = (struct symbolic){.a = _quotient_vec_init(terms + 2), .terms = terms};
    fmpz_mpoly_q_one(cosine(z), CTX);
}

static void symbolic_clear(void *x)
{
    struct symbolic *z = x;
    _quotient_vec_clear(z->a, z->terms + 2);
}

static void symbolic_set(void *to, const void *from)
{
    struct symbolic *z = to;
    const struct symbolic *x = from;
    for (slong k = 0; k < z->terms + 2; k++)
        fmpz_mpoly_q_set(z->a + k, x->a + k, CTX);
    z->angle = x->angle;
    z->large = x->large;
    z->fault = x->fault;
}

/* z has these coefficients, and is a number: the finite part of its angle is zero. */
static void take(struct symbolic *z, quotient *a)
{
    exchange(z->a, a, z->terms);
    fmpz_mpoly_q_one(cosine(z), CTX);
    fmpz_mpoly_q_zero(sine(z), CTX);
    z->angle = z->large = false;
}

static void symbolic_set_rational(void *x, const fmpq_t q, slong terms)
{
    struct symbolic *z = x;
    VECTOR(quotient, a, terms);
    fmpz_mpoly_q_set_fmpq(a, q, CTX);
    take(z, a);
    z->fault = SYMBOLIC_FINE;
}

/* The variable, or a number in its place. */
static void set_generator(quotient *x, slong variable, const fmpq *point)
{
    if (point == NULL)
        fmpz_mpoly_q_gen(x, variable, CTX);
    else
        fmpz_mpoly_q_set_fmpq(x, point, CTX);
}

void symbolic_set_variable(struct symbolic *z, slong variable, slong power, const fmpq *point)
{
    VECTOR(quotient, a, z->terms);
    if (power < z->terms)
        set_generator(a + power, variable, point);
    take(z, a);
    z->fault = SYMBOLIC_FINE;
}

void symbolic_set_angle(struct symbolic *z, slong variable, const fmpq *point)
{
    SCOPE(fmpq, zero);
    SCOPE(quotient, t, under);
    symbolic_set_rational(z, zero, z->terms);
    set_generator(t, variable, point);
    fmpz_mpoly_q_mul(under, t, t, CTX);
    fmpz_mpoly_q_sub(cosine(z), cosine(z), under, CTX);
    fmpz_mpoly_q_add_si(under, under, 1, CTX);
    fmpz_mpoly_q_div(cosine(z), cosine(z), under, CTX);
    fmpz_mpoly_q_mul_si(sine(z), t, 2, CTX);
    fmpz_mpoly_q_div(sine(z), sine(z), under, CTX);
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

/* ---- functions ---- */

static bool same(const struct symbolic *x, const struct symbolic *y)
{
    bool equal = x->angle == y->angle;
    for (slong k = 0; k < x->terms + 2 && equal; k++)
        equal = fmpz_mpoly_q_equal(x->a + k, y->a + k, CTX);
    return equal;
}

/* z is the variable that stands for op(x, y): the one it has already, or the next; a fault where there is no room. */
static void stand_for(struct symbolic *z, enum symbolic_fault fault, enum operator op, const struct symbolic *x,
                      const struct symbolic *y)
{
    slong i = 0;
    while (i < field->opaques && !(field->opaque[i].op == op && same(&field->opaque[i].x, x) && same(&field->opaque[i].y, y)))
        i++;
    if (i == field->more) {
        z->fault = fault;
        return;
    }
    if (i == field->opaques) {
        struct opaque *new = &field->opaque[field->opaques++];
        new->op = op;
        symbolic_init(&new->x, x->terms);
        symbolic_init(&new->y, x->terms);
        symbolic_set(&new->x, x);
        symbolic_set(&new->y, y);
    }
    if (op == OPERATOR_ATAN2)
        symbolic_set_angle(z, field->variables + i, NULL);
    else
        symbolic_set_variable(z, field->variables + i, 0, NULL);
}

void symbolic_root(const struct symbolic *x)
{
    quotient_init(&field->roots[field->root_count]);
    fmpz_mpoly_q_set(&field->roots[field->root_count], x->a, CTX);
    field->used[field->root_count++] = false;
}

bool symbolic_root_used(int i)
{
    return field->used[i];
}

/* Which of the roots has this square; a constant has its own, the one that may be zero. Its fault. */
static enum symbolic_fault find_root(quotient *root, const quotient *square)
{
    SCOPE(quotient, other);
    if (!may_combine(square, square))
        return SYMBOLIC_TOO_LARGE;
    if (!fmpz_mpoly_sqrt(fmpz_mpoly_q_numref(root), fmpz_mpoly_q_numref(square), CTX) ||
        !fmpz_mpoly_sqrt(fmpz_mpoly_q_denref(root), fmpz_mpoly_q_denref(square), CTX))
        return SYMBOLIC_NO_SQUARE;
    if (fmpz_mpoly_q_is_fmpq(root, CTX)) /* FLINT takes the positive one of a number's */
        return SYMBOLIC_FINE;
    fmpz_mpoly_q_neg(other, root, CTX);
    for (int i = 0; i < field->root_count; i++)
        if (fmpz_mpoly_q_equal(root, &field->roots[i], CTX) || fmpz_mpoly_q_equal(other, &field->roots[i], CTX)) {
            fmpz_mpoly_q_set(root, &field->roots[i], CTX);
            field->used[i] = true;
            return SYMBOLIC_FINE;
        }
    return SYMBOLIC_UNKNOWN_ROOT;
}

/* r^2 = x, coefficient by coefficient: 2 r_0 r_k is x_k without the products of what is known. */
static void square_root(struct symbolic *z, const struct symbolic *x)
{
    VECTOR(quotient, r, x->terms);
    enum symbolic_fault fault = find_root(r, x->a);
    if (fault == SYMBOLIC_FINE && x->terms > 1 && is_zero(r)) /* zero to this order is not enough: that of epsilon^2 is epsilon */
        fault = SYMBOLIC_NO_SQUARE;
    if (fault != SYMBOLIC_FINE) {
        stand_for(z, fault, OPERATOR_SQRT, x, x);
        return;
    }
    for (slong k = 1; k < x->terms; k++) {
        fmpz_mpoly_q_set(r + k, x->a + k, CTX);
        for (slong j = 1; j < k; j++)
            add_product(r + k, r + j, r + k - j, -1, 1);
        divide(r + k, r + k, r);
        fmpz_mpoly_q_div_si(r + k, r + k, 2, CTX);
    }
    take(z, r);
}

/* s' = p' c and c' = -p' s, from those of the finite part. */
static void trigonometric(struct symbolic *z, enum operator op, const struct symbolic *x)
{
    VECTOR(quotient, s, x->terms);
    VECTOR(quotient, c, x->terms);
    fmpz_mpoly_q_set(s, sine(x), CTX);
    fmpz_mpoly_q_set(c, cosine(x), CTX);
    for (slong k = 1; k < x->terms; k++)
        for (slong j = 1; j <= k; j++) {
            add_product(s + k, x->a + j, c + k - j, j, k);
            add_product(c + k, x->a + j, s + k - j, -j, k);
        }
    take(z, op == OPERATOR_SIN ? s : c);
}

/* e' = p' e */
static void exponential(struct symbolic *z, const struct symbolic *x)
{
    VECTOR(quotient, e, x->terms);
    fmpz_mpoly_q_one(e, CTX);
    for (slong k = 1; k < x->terms; k++)
        for (slong j = 1; j <= k; j++)
            add_product(e + k, x->a + j, e + k - j, j, k);
    take(z, e);
}

/* The angle of a point off the origin: of constants in epsilon. */
static void arc_tangent(struct symbolic *z, const struct symbolic *y, const struct symbolic *x)
{
    VECTOR(quotient, none, x->terms);
    SCOPE(quotient, square, r, c, s);
    add_product(square, x->a, x->a, 1, 1);
    add_product(square, y->a, y->a, 1, 1);
    enum symbolic_fault fault = x->terms > 1 ? SYMBOLIC_TRANSCENDENTAL : find_root(r, square);
    if (fault == SYMBOLIC_FINE && is_zero(r))
        fault = SYMBOLIC_POLE;
    if (fault != SYMBOLIC_FINE) {
        stand_for(z, fault, OPERATOR_ATAN2, y, x);
        return;
    }
    divide(s, y->a, r);
    divide(c, x->a, r);
    take(z, none);
    fmpz_mpoly_q_swap(cosine(z), c, CTX);
    fmpz_mpoly_q_swap(sine(z), s, CTX);
    z->angle = true;
}

/* ---- arithmetic ---- */

static void symbolic_add(struct symbolic *z, const struct symbolic *x, const struct symbolic *y, slong sign)
{
    VECTOR(quotient, sum, z->terms);
    SCOPE(quotient, c, s);
    const bool angle = x->angle || y->angle;
    add_product(c, cosine(x), cosine(y), 1, 1);
    add_product(c, sine(x), sine(y), -sign, 1);
    add_product(s, sine(x), cosine(y), 1, 1);
    add_product(s, cosine(x), sine(y), sign, 1);
    for (slong k = 0; k < z->terms; k++) {
        fmpz_mpoly_q_set(sum + k, x->a + k, CTX);
        accumulate(sum + k, y->a + k, sign);
    }
    take(z, sum);
    z->angle = angle;
    fmpz_mpoly_q_swap(cosine(z), c, CTX);
    fmpz_mpoly_q_swap(sine(z), s, CTX);
}

static void quotient_of(struct symbolic *z, const struct symbolic *x, const struct symbolic *y)
{
    const bool pole = is_zero(y->a) && !y->large, large = pole && !is_zero(x->a);
    VECTOR(quotient, a, x->terms);
    if (y->large)
        quotient_product(a, x->a, y->a, x->terms);
    else if (large)
        ratio(a, y->a, x->a, x->terms);
    else if (!pole)
        ratio(a, x->a, y->a, x->terms);
    take(z, a);
    z->large = large;
    z->fault = pole ? SYMBOLIC_POLE : SYMBOLIC_FINE;
}

static enum symbolic_fault operand_fault(enum operator op, const struct symbolic *x)
{
    const bool takes_angles = op == OPERATOR_NEGATE || op == OPERATOR_ADD || op == OPERATOR_SUBTRACT ||
                              op == OPERATOR_SIN || op == OPERATOR_COS;
    return x->angle && !takes_angles ? SYMBOLIC_ANGLE_AS_NUMBER : x->fault;
}

/* Of operands that have values. */
static void apply_fine(enum operator op, struct symbolic *z, const struct symbolic *x, const struct symbolic *y, slong exponent)
{
    VECTOR(quotient, a, z->terms);
    if (op == OPERATOR_NEGATE) {
        symbolic_set(z, x);
        for (slong k = 0; k < z->terms; k++)
            fmpz_mpoly_q_neg(z->a + k, z->a + k, CTX);
        fmpz_mpoly_q_neg(sine(z), sine(z), CTX);
    } else if (op == OPERATOR_ADD || op == OPERATOR_SUBTRACT) {
        symbolic_add(z, x, y, op == OPERATOR_ADD ? 1 : -1);
    } else if (op == OPERATOR_MULTIPLY) {
        quotient_product(a, x->a, y->a, z->terms);
        take(z, a);
    } else if (op == OPERATOR_DIVIDE) {
        quotient_of(z, x, y);
    } else if (op == OPERATOR_POWER) {
        power(a, x->a, exponent, z->terms);
        take(z, a);
    } else if (op == OPERATOR_SQRT) {
        square_root(z, x);
    } else if (op == OPERATOR_ATAN2) {
        arc_tangent(z, x, y);
    } else if (is_zero(x->a) && op == OPERATOR_EXP) {
        exponential(z, x);
    } else if (is_zero(x->a) && (op == OPERATOR_SIN || op == OPERATOR_COS)) {
        trigonometric(z, op, x);
    } else { /* a logarithm, and positive(): a question of signs, which the caller has answered if it could */
        stand_for(z, op == OPERATOR_SIN || op == OPERATOR_COS ? SYMBOLIC_NUMBER_AS_ANGLE : SYMBOLIC_TRANSCENDENTAL, op, x, x);
    }
}

static void symbolic_apply(enum operator op, void *result, const void *left, const void *right, slong exponent, slong terms)
{
    struct symbolic *z = result;
    const struct symbolic *x = left, *y = right != NULL ? right : left;
    enum symbolic_fault fault = operand_fault(op, x);
    (void)terms;
    if (fault == SYMBOLIC_FINE && !(op == OPERATOR_DIVIDE && y->large))
        fault = operand_fault(op, y);
    z->fault = fault;
    if (fault == SYMBOLIC_FINE)
        apply_fine(op, z, x, y, exponent);
    else
        z->large = false;
    if (field->large)
        z->fault = SYMBOLIC_TOO_LARGE;
    z->angle = z->angle && z->fault == SYMBOLIC_FINE;
}

const struct arithmetic arithmetic_symbolic = {
    .size = sizeof(struct symbolic),
    .init = symbolic_init,
    .clear = symbolic_clear,
    .set = symbolic_set,
    .set_rational = symbolic_set_rational,
    .apply = symbolic_apply,
};
