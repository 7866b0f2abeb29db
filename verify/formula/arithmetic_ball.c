/* Rigorous enclosures: every result contains the exact one, whatever the inputs inside theirs. */
#include "formula/arithmetic.h"

static void ball_init(void *x, slong prec)
{
    (void)prec;
    arb_init(x);
}

static void ball_clear(void *x)
{
    arb_clear(x);
}

static void ball_set(void *z, const void *x)
{
    arb_set(z, x);
}

static void ball_set_rational(void *z, const fmpq_t q, slong prec)
{
    const slong power = (slong)fmpz_val2(fmpq_denref(q)); /* a binary64's denominator is a power of two: nothing to divide */
    if (fmpz_bits(fmpq_denref(q)) == (flint_bitcnt_t)power + 1) {
        arb_set_round_fmpz(z, fmpq_numref(q), prec);
        arb_mul_2exp_si(z, z, -power);
    } else {
        arb_set_fmpq(z, q, prec);
    }
}

static void ball_set_infinity(void *z)
{
    arb_pos_inf(z);
}

/* A finite number over infinity is zero; Arb alone would know nothing of it. */
static void ball_divide(arb_t z, const arb_t x, const arb_t y, slong prec)
{
    if (arb_is_finite(x) && arf_is_inf(arb_midref(y)) && mag_is_zero(arb_radref(y)))
        arb_zero(z);
    else
        arb_div(z, x, y, prec);
}

/* The angle of (x, y) in (-pi, pi]: zero where y is zero and x is not negative. */
static void ball_atan2(arb_t z, const arb_t y, const arb_t x, slong prec)
{
    if (arb_is_zero(y) && arb_is_nonnegative(x))
        arb_zero(z);
    else
        arb_atan2(z, y, x, prec);
}

static void ball_positive(arb_t z, const arb_t x)
{
    if (arb_is_positive(x))
        arb_one(z);
    else if (arb_is_nonpositive(x))
        arb_zero(z);
    else
        arb_indeterminate(z);
}

static void ball_apply(enum operator op, void *z, const void *x, const void *y, slong exponent,
                       slong prec)
{
    switch (op) {
    case OPERATOR_NEGATE:
        arb_neg(z, x);
        break;
    case OPERATOR_ADD:
        arb_add(z, x, y, prec);
        break;
    case OPERATOR_SUBTRACT:
        arb_sub(z, x, y, prec);
        if (x == y && arb_is_finite(x)) /* one number less itself, which no ball would know */
            arb_zero(z);
        break;
    case OPERATOR_MULTIPLY:
        arb_mul(z, x, y, prec);
        break;
    case OPERATOR_DIVIDE:
        ball_divide(z, x, y, prec);
        break;
    case OPERATOR_POWER: {
        arb_t base; /* arb_inv of a wide ball and a square are sharper than products of it */
        arb_init(base);
        if (exponent < 0)
            arb_inv(base, x, prec);
        else
            arb_set(base, x);
        arb_pow_ui(z, base, (ulong)(exponent < 0 ? -exponent : exponent), prec);
        arb_clear(base);
        break;
    }
    case OPERATOR_SQRT:
        arb_sqrt(z, x, prec);
        break;
    case OPERATOR_SIN:
        arb_sin(z, x, prec);
        break;
    case OPERATOR_COS:
        arb_cos(z, x, prec);
        break;
    case OPERATOR_EXP:
        arb_exp(z, x, prec);
        break;
    case OPERATOR_LOG:
        arb_log(z, x, prec);
        break;
    case OPERATOR_ATAN2:
        ball_atan2(z, x, y, prec);
        break;
    case OPERATOR_INPUT: /* no operations, these two: never asked for */
    case OPERATOR_NUMBER:
    case OPERATOR_POSITIVE:
        ball_positive(z, x);
        break;
    }
}

const struct arithmetic arithmetic_ball = {
    .name = "ball",
    .size = sizeof(arb_struct),
    .init = ball_init,
    .clear = ball_clear,
    .set = ball_set,
    .set_rational = ball_set_rational,
    .set_infinity = ball_set_infinity,
    .apply = ball_apply,
};
