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

static void mpfr_number_apply(enum operator op, void *z, const void *x, const void *y,
                              slong exponent, slong prec)
{
    (void)prec;
    switch (op) {
    case OPERATOR_NEGATE:
        mpfr_neg(z, x, MPFR_RNDN);
        break;
    case OPERATOR_ADD:
        mpfr_add(z, x, y, MPFR_RNDN);
        break;
    case OPERATOR_SUBTRACT:
        mpfr_sub(z, x, y, MPFR_RNDN);
        break;
    case OPERATOR_MULTIPLY:
        mpfr_mul(z, x, y, MPFR_RNDN);
        break;
    case OPERATOR_DIVIDE:
        mpfr_div(z, x, y, MPFR_RNDN);
        break;
    case OPERATOR_POWER:
        mpfr_pow_si(z, x, exponent, MPFR_RNDN);
        break;
    case OPERATOR_SQRT:
        mpfr_sqrt(z, x, MPFR_RNDN);
        break;
    case OPERATOR_SIN:
        mpfr_sin(z, x, MPFR_RNDN);
        break;
    case OPERATOR_COS:
        mpfr_cos(z, x, MPFR_RNDN);
        break;
    case OPERATOR_EXP:
        mpfr_exp(z, x, MPFR_RNDN);
        break;
    case OPERATOR_LOG:
        mpfr_log(z, x, MPFR_RNDN);
        break;
    case OPERATOR_ATAN2:
        mpfr_atan2(z, x, y, MPFR_RNDN);
        break;
    case OPERATOR_INPUT: /* no operations, these two: never asked for */
    case OPERATOR_NUMBER:
    case OPERATOR_POSITIVE:
        mpfr_set_si(z, mpfr_sgn((mpfr_srcptr)x) > 0, MPFR_RNDN);
        break;
    }
}

const struct arithmetic arithmetic_mpfr = {
    .name = "mpfr",
    .size = sizeof(mpfr_t),
    .init = mpfr_number_init,
    .clear = mpfr_number_clear,
    .set_rational = mpfr_number_set_rational,
    .apply = mpfr_number_apply,
};
