/* Multiple precision, every operation correctly rounded to nearest. */
#include "formula/arithmetic.h"

static void mpfr_number_init(void *x, slong prec)
{
    mpfr_init2(x, prec);
}

static void mpfr_number_clear(void *x)
{
    mpfr_clear(x);
}

static void mpfr_number_set_rational(void *z, const fmpq_t q, slong prec)
{
    (void)prec;
    fmpq_get_mpfr(z, q, MPFR_RNDN);
}

static int mpfr_positive(mpfr_t z, mpfr_srcptr x, mpfr_rnd_t rounding)
{
    return mpfr_set_si(z, mpfr_sgn(x) > 0, rounding);
}

static int (*const unary[])(mpfr_ptr, mpfr_srcptr, mpfr_rnd_t) = {
    [OPERATOR_NEGATE] = mpfr_neg, [OPERATOR_SQRT] = mpfr_sqrt, [OPERATOR_SIN] = mpfr_sin,      [OPERATOR_COS] = mpfr_cos,
    [OPERATOR_EXP] = mpfr_exp,    [OPERATOR_LOG] = mpfr_log,   [OPERATOR_POSITIVE] = mpfr_positive,
};
static int (*const binary[OPERATOR_POSITIVE + 1])(mpfr_ptr, mpfr_srcptr, mpfr_srcptr, mpfr_rnd_t) = {
    [OPERATOR_ADD] = mpfr_add,    [OPERATOR_SUBTRACT] = mpfr_sub, [OPERATOR_MULTIPLY] = mpfr_mul,
    [OPERATOR_DIVIDE] = mpfr_div, [OPERATOR_ATAN2] = mpfr_atan2,
};

static void mpfr_number_apply(enum operator op, void *z, const void *x, const void *y, slong exponent, slong prec)
{
    (void)prec;
    if (op == OPERATOR_POWER)
        mpfr_pow_si(z, x, exponent, MPFR_RNDN);
    else if (binary[op] != NULL)
        binary[op](z, x, y, MPFR_RNDN);
    else
        unary[op](z, x, MPFR_RNDN);
}

const struct arithmetic arithmetic_mpfr = {
    .size = sizeof(mpfr_t),
    .init = mpfr_number_init,
    .clear = mpfr_number_clear,
    .set_rational = mpfr_number_set_rational,
    .apply = mpfr_number_apply,
};
