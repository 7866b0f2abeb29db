/* Exact sums, what decides zeros and ties: see exact.h. */
#include "arithmetic.h"
#include "exact.h"

static void sums_init(void *x, slong prec)
{
    (void)prec;
    exact_init(x);
}

static void sums_clear(void *x)
{
    exact_clear(x);
}

static void sums_set(void *z, const void *x)
{
    exact_set(z, x);
}

static void sums_set_rational(void *z, const fmpq_t q, slong prec)
{
    (void)prec;
    exact_set_fmpq(z, q);
}

static void sums_set_infinity(void *z)
{
    exact_set_infinity(z);
}

static void sums_apply(enum operator op, void *z, const void *x, const void *y, slong exponent,
                       slong prec)
{
    (void)prec;
    switch (op) {
    case OPERATOR_NEGATE:
        exact_neg(z, x);
        break;
    case OPERATOR_ADD:
        exact_add(z, x, y);
        break;
    case OPERATOR_SUBTRACT:
        exact_sub(z, x, y);
        break;
    case OPERATOR_MULTIPLY:
        exact_mul(z, x, y);
        break;
    case OPERATOR_DIVIDE:
        exact_div(z, x, y);
        break;
    case OPERATOR_POWER:
        exact_pow(z, x, exponent);
        break;
    case OPERATOR_SQRT:
        exact_sqrt(z, x);
        break;
    case OPERATOR_SIN:
        exact_sin(z, x);
        break;
    case OPERATOR_COS:
        exact_cos(z, x);
        break;
    case OPERATOR_EXP:
        exact_exp(z, x);
        break;
    case OPERATOR_LOG: /* unknown, as 0/0 is */
        exact_sub(z, x, x);
        exact_div(z, z, z);
        break;
    case OPERATOR_ATAN2:
        exact_atan2(z, x, y);
        break;
    case OPERATOR_INPUT: /* no operations, these two: never asked for */
    case OPERATOR_NUMBER:
    case OPERATOR_POSITIVE:
        exact_positive(z, x);
        break;
    }
}

const struct arithmetic arithmetic_sums = {
    .name = "sums",
    .size = sizeof(struct exact),
    .init = sums_init,
    .clear = sums_clear,
    .set = sums_set,
    .set_rational = sums_set_rational,
    .set_infinity = sums_set_infinity,
    .apply = sums_apply,
};
