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

static void ball_negate(arb_t z, const arb_t x, slong prec)
{
    (void)prec;
    arb_neg(z, x);
}

static void ball_positive(arb_t z, const arb_t x, slong prec)
{
    (void)prec;
    if (arb_is_positive(x))
        arb_one(z);
    else if (arb_is_nonpositive(x))
        arb_zero(z);
    else
        arb_indeterminate(z);
}

static void (*const unary[])(arb_t, const arb_t, slong) = {
    [OPERATOR_NEGATE] = ball_negate, [OPERATOR_SQRT] = arb_sqrt, [OPERATOR_SIN] = arb_sin,           [OPERATOR_COS] = arb_cos,
    [OPERATOR_EXP] = arb_exp,        [OPERATOR_LOG] = arb_log,   [OPERATOR_POSITIVE] = ball_positive,
};
static void (*const binary[OPERATOR_POSITIVE + 1])(arb_t, const arb_t, const arb_t, slong) = {
    [OPERATOR_ADD] = arb_add,        [OPERATOR_SUBTRACT] = arb_sub, [OPERATOR_MULTIPLY] = arb_mul,
    [OPERATOR_DIVIDE] = ball_divide, [OPERATOR_ATAN2] = ball_atan2,
};

static void ball_apply(enum operator op, void *z, const void *x, const void *y, slong exponent, slong prec)
{
    if (op == OPERATOR_POWER)
        arb_pow_ui(z, x, (ulong)exponent, prec); /* the square of a wide ball is sharper than a product */
    else if (binary[op] != NULL)
        binary[op](z, x, y, prec);
    else
        unary[op](z, x, prec);
}

const struct arithmetic arithmetic_ball = {
    .size = sizeof(arb_struct),
    .init = ball_init,
    .clear = ball_clear,
    .set = ball_set,
    .set_rational = ball_set_rational,
    .set_infinity = ball_set_infinity,
    .apply = ball_apply,
};
