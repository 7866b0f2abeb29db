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

static void set_rational(void *z, const fmpq_t q, slong prec)
{
    (void)prec;
    ca_set_fmpq(z, q, context);
}

static void set_infinity(void *z)
{
    ca_pos_inf(z, context);
}

static void root(ca_ptr z, ca_srcptr x)
{
    if (ca_check_is_negative_real(x, context) == T_FALSE)
        ca_sqrt(z, x, context);
    else
        ca_undefined(z, context);
}

static void sine_or_cosine(ca_ptr z, ca_srcptr x, bool sine)
{
    ca_t other;
    ca_init(other, context);
    if (sine)
        ca_sin_cos(z, other, x, context);
    else
        ca_sin_cos(other, z, x, context);
    ca_clear(other, context);
}

/* The angle of (x, y): of those that are rational there is 0 alone, where y = 0 and x > 0 (Lindemann, Weierstrass). */
static void angle(ca_ptr z, ca_srcptr y, ca_srcptr x)
{
    ca_t zero;
    ca_init(zero, context);
    if (ca_check_is_zero(y, context) == T_TRUE && ca_check_gt(x, zero, context) == T_TRUE)
        ca_zero(z, context);
    else
        ca_unknown(z, context);
    ca_clear(zero, context);
}

/* 1 where x > 0, else 0 */
static void positive(ca_ptr z, ca_srcptr x)
{
    ca_t zero;
    ca_init(zero, context);
    const truth_t above = ca_check_gt(x, zero, context);
    if (above == T_UNKNOWN)
        ca_unknown(z, context);
    else
        ca_set_si(z, above == T_TRUE, context);
    ca_clear(zero, context);
}

static void logarithm(ca_ptr z, ca_srcptr x)
{
    ca_t zero;
    ca_init(zero, context);
    if (ca_check_gt(x, zero, context) == T_TRUE)
        ca_log(z, x, context);
    else
        ca_unknown(z, context);
    ca_clear(zero, context);
}

static void apply(enum operator op, void *z, const void *x, const void *y, slong exponent, slong prec)
{
    (void)prec;
    switch (op) {
    case OPERATOR_NEGATE:
        ca_neg(z, x, context);
        break;
    case OPERATOR_ADD:
        ca_add(z, x, y, context);
        break;
    case OPERATOR_SUBTRACT:
        ca_sub(z, x, y, context);
        break;
    case OPERATOR_MULTIPLY:
        ca_mul(z, x, y, context);
        break;
    case OPERATOR_DIVIDE:
        ca_div(z, x, y, context);
        break;
    case OPERATOR_POWER:
        ca_pow_si(z, x, exponent, context);
        break;
    case OPERATOR_SQRT:
        root(z, x);
        break;
    case OPERATOR_SIN:
    case OPERATOR_COS:
        sine_or_cosine(z, x, op == OPERATOR_SIN);
        break;
    case OPERATOR_EXP:
        ca_exp(z, x, context);
        break;
    case OPERATOR_LOG:
        logarithm(z, x);
        break;
    case OPERATOR_ATAN2:
        angle(z, x, y);
        break;
    case OPERATOR_INPUT: /* no operations, these two: never asked for */
    case OPERATOR_NUMBER:
    case OPERATOR_POSITIVE:
        positive(z, x);
        break;
    }
}

const struct arithmetic arithmetic_exact = {
    .name = "exact",
    .size = sizeof(struct exact),
    .init = init_exact,
    .clear = clear_exact,
    .set = set,
    .set_rational = set_rational,
    .set_infinity = set_infinity,
    .apply = apply,
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
