#include "formula/exact.h"

/*
 * Calcium keeps every root and exponential that it has met, and the fields that they span. All of it goes when the last
 * number does, so that memory stays flat over any number of inputs.
 */
static ca_ctx_t context;
static slong numbers;

static void init_exact(void *x, slong prec)
{
    (void)prec;
    if (numbers++ == 0)
        ca_ctx_init(context);
    ca_init(x, context);
}

static void clear_exact(void *x)
{
    ca_clear(x, context);
    if (--numbers == 0)
        ca_ctx_clear(context);
}

static void set(void *z, const void *x)
{
    ca_set(z, x, context);
}

static void exact_set_rational(void *z, const fmpq_t q, slong prec)
{
    (void)prec;
    ca_set_fmpq(z, q, context);
}

static void set_infinity(void *z)
{
    ca_pos_inf(z, context);
}

static truth_t exact_is_positive(const ca_t x)
{
    ca_t zero;
    ca_init(zero, context);
    const truth_t above = ca_check_gt(x, zero, context);
    ca_clear(zero, context);
    return above;
}

static void root(ca_t z, const ca_t x, ca_ctx_t ctx)
{
    if (ca_check_is_negative_real(x, ctx) == T_FALSE)
        ca_sqrt(z, x, ctx);
    else
        ca_undefined(z, ctx);
}

/* The angle of (x, y): of those that are rational there is 0 alone, where y = 0 and x > 0 (Lindemann, Weierstrass). */
static void angle(ca_t z, const ca_t y, const ca_t x, ca_ctx_t ctx)
{
    if (ca_check_is_zero(y, ctx) == T_TRUE && exact_is_positive(x) == T_TRUE)
        ca_zero(z, ctx);
    else
        ca_unknown(z, ctx);
}

/* 1 where x > 0, else 0 */
static void exact_positive(ca_t z, const ca_t x, ca_ctx_t ctx)
{
    const truth_t above = exact_is_positive(x);
    ca_set_si(z, above == T_TRUE, ctx);
    if (above == T_UNKNOWN)
        ca_unknown(z, ctx);
}

static void logarithm(ca_t z, const ca_t x, ca_ctx_t ctx)
{
    if (exact_is_positive(x) == T_TRUE)
        ca_log(z, x, ctx);
    else
        ca_unknown(z, ctx);
}

static void (*const unary[])(ca_t, const ca_t, ca_ctx_t) = {
    [OPERATOR_NEGATE] = ca_neg,  [OPERATOR_SQRT] = root,     [OPERATOR_SIN] = ca_sin,         [OPERATOR_COS] = ca_cos,
    [OPERATOR_EXP] = ca_exp,     [OPERATOR_LOG] = logarithm, [OPERATOR_POSITIVE] = exact_positive,
};
static void (*const binary[OPERATOR_POSITIVE + 1])(ca_t, const ca_t, const ca_t, ca_ctx_t) = {
    [OPERATOR_ADD] = ca_add,    [OPERATOR_SUBTRACT] = ca_sub, [OPERATOR_MULTIPLY] = ca_mul,
    [OPERATOR_DIVIDE] = ca_div, [OPERATOR_ATAN2] = angle,
};

static void exact_apply(enum operator op, void *z, const void *x, const void *y, slong exponent, slong prec)
{
    (void)prec;
    if (op == OPERATOR_POWER)
        ca_pow_si(z, x, exponent, context);
    else if (binary[op] != NULL)
        binary[op](z, x, y, context);
    else
        unary[op](z, x, context);
}

const struct arithmetic arithmetic_exact = {
    .size = sizeof(struct exact),
    .init = init_exact,
    .clear = clear_exact,
    .set = set,
    .set_rational = exact_set_rational,
    .set_infinity = set_infinity,
    .apply = exact_apply,
};

bool exact_is_undefined(const struct exact *x)
{
    return CA_IS_SPECIAL(&x->value) && !CA_IS_UNKNOWN(&x->value);
}

bool exact_is_zero(const struct exact *x)
{
    return ca_check_is_zero(&x->value, context) == T_TRUE;
}

bool exact_is_rational(fmpq_t value, const struct exact *x)
{
    return ca_check_is_rational(&x->value, context) == T_TRUE && ca_get_fmpq(value, &x->value, context);
}
