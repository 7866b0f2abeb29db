/*
 * Exact power series in an infinitesimal epsilon with rational coefficients, `prec` terms of them.
 *
 * An angle may have a finite part: it is then known by a rational point (c, s) of the unit circle, its
 * cosine and sine, and the series is what comes on top. Nothing here rounds, nothing is approximate;
 * what has no such value (a pole, the root of no square, an angle used as a number) is a fault, which
 * every later result inherits.
 */
#include "series.h"

void series_init(void *x, slong prec)
{
    struct series *z = x;
    (void)prec;
    fmpq_poly_init(z->p);
    fmpq_init(z->c);
    fmpq_init(z->s);
    fmpq_one(z->c);
    z->fault = SERIES_FINE;
}

void series_clear(void *x)
{
    struct series *z = x;
    fmpq_poly_clear(z->p);
    fmpq_clear(z->c);
    fmpq_clear(z->s);
}

static void series_set(void *z, const void *x)
{
    struct series *to = z;
    const struct series *from = x;
    fmpq_poly_set(to->p, from->p);
    fmpq_set(to->c, from->c);
    fmpq_set(to->s, from->s);
    to->fault = from->fault;
}

static void set_rational(void *z, const fmpq_t q, slong prec)
{
    struct series *to = z;
    (void)prec;
    fmpq_poly_set_fmpq(to->p, q);
    fmpq_one(to->c);
    fmpq_zero(to->s);
    to->fault = SERIES_FINE;
}

static void set_infinity(void *z)
{
    ((struct series *)z)->fault = SERIES_POLE;
}

void series_get_fmpq(fmpq_t q, const void *x, slong k)
{
    fmpq_poly_get_coeff_fmpq(q, ((const struct series *)x)->p, k);
}

void series_set_angle(void *z, const fmpq_t c, const fmpq_t s)
{
    struct series *to = z;
    fmpq_poly_zero(to->p);
    fmpq_set(to->c, c);
    fmpq_set(to->s, s);
    to->fault = SERIES_FINE;
}

static bool is_angle(const struct series *x)
{
    return !fmpq_is_one(x->c);
}

/* The point of the sum of two angles; negative: of their difference. */
static void add_angles(struct series *z, const struct series *x, const struct series *y, bool negative)
{
    fmpq_t c, s, t;
    fmpq_init(c);
    fmpq_init(s);
    fmpq_init(t);
    fmpq_mul(c, x->c, y->c);
    fmpq_mul(t, x->s, y->s);
    (negative ? fmpq_add : fmpq_sub)(c, c, t);
    fmpq_mul(s, x->s, y->c);
    fmpq_mul(t, x->c, y->s);
    (negative ? fmpq_sub : fmpq_add)(s, s, t);
    fmpq_swap(z->c, c);
    fmpq_swap(z->s, s);
    fmpq_clear(c);
    fmpq_clear(s);
    fmpq_clear(t);
}

/* sin(a + p) = s cos p + c sin p, cos(a + p) = c cos p - s sin p; p without a constant term */
static void sine_and_cosine(struct series *z, const struct series *x, bool sine, slong prec)
{
    fmpq_poly_t cosp, sinp;
    fmpq_t by_cos, by_sin, constant;
    fmpq_poly_init(cosp);
    fmpq_poly_init(sinp);
    fmpq_init(by_cos);
    fmpq_init(by_sin);
    fmpq_init(constant);
    fmpq_poly_get_coeff_fmpq(constant, x->p, 0);
    if (!fmpq_is_zero(constant)) {
        z->fault = SERIES_NUMBER_AS_ANGLE;
    } else {
        fmpq_set(by_cos, sine ? x->s : x->c);
        fmpq_set(by_sin, sine ? x->c : x->s);
        if (!sine)
            fmpq_neg(by_sin, by_sin);
        fmpq_poly_cos_series(cosp, x->p, prec);
        fmpq_poly_sin_series(sinp, x->p, prec);
        fmpq_poly_scalar_mul_fmpq(cosp, cosp, by_cos);
        fmpq_poly_scalar_mul_fmpq(sinp, sinp, by_sin);
        fmpq_poly_add(z->p, cosp, sinp);
        fmpq_one(z->c);
        fmpq_zero(z->s);
    }
    fmpq_clear(by_cos);
    fmpq_clear(by_sin);
    fmpq_clear(constant);
    fmpq_poly_clear(cosp);
    fmpq_poly_clear(sinp);
}

/* FLINT's square root wants the constant term 1: divide by it, and multiply by its rational root. */
static void square_root(struct series *z, const struct series *x, slong prec)
{
    fmpq_t constant;
    fmpz_t num, den;
    fmpq_init(constant);
    fmpz_init(num);
    fmpz_init(den);
    fmpq_poly_get_coeff_fmpq(constant, x->p, 0);
    if (fmpq_sgn(constant) <= 0 || !fmpz_is_square(fmpq_numref(constant)) ||
        !fmpz_is_square(fmpq_denref(constant))) {
        z->fault = fmpq_poly_is_zero(x->p) ? SERIES_FINE : SERIES_NO_SQUARE;
        fmpq_poly_zero(z->p);
    } else {
        fmpq_poly_scalar_div_fmpq(z->p, x->p, constant);
        fmpq_poly_sqrt_series(z->p, z->p, prec);
        fmpz_sqrt(num, fmpq_numref(constant));
        fmpz_sqrt(den, fmpq_denref(constant));
        fmpq_set_fmpz_frac(constant, num, den);
        fmpq_poly_scalar_mul_fmpq(z->p, z->p, constant);
    }
    fmpq_clear(constant);
    fmpz_clear(num);
    fmpz_clear(den);
}

static bool starts_with_zero(const fmpq_poly_t p)
{
    return fmpq_poly_length(p) == 0 || fmpz_is_zero(fmpq_poly_numref(p));
}

static void divide(struct series *z, const struct series *x, const struct series *y, slong prec)
{
    if (starts_with_zero(y->p))
        z->fault = SERIES_POLE;
    else
        fmpq_poly_div_series(z->p, x->p, y->p, prec);
}

static void power(struct series *z, const struct series *x, slong exponent, slong prec)
{
    if (exponent < 0 && starts_with_zero(x->p)) {
        z->fault = SERIES_POLE;
        return;
    }
    if (exponent < 0)
        fmpq_poly_inv_series(z->p, x->p, prec);
    else
        fmpq_poly_set(z->p, x->p);
    fmpq_poly_pow_trunc(z->p, z->p, (ulong)(exponent < 0 ? -exponent : exponent), prec);
}

static void exponential(struct series *z, const struct series *x, slong prec)
{
    if (starts_with_zero(x->p))
        fmpq_poly_exp_series(z->p, x->p, prec);
    else
        z->fault = SERIES_TRANSCENDENTAL;
}

static bool takes_angles(enum operator op)
{
    return op == OPERATOR_NEGATE || op == OPERATOR_ADD || op == OPERATOR_SUBTRACT ||
           op == OPERATOR_SIN || op == OPERATOR_COS;
}

static void apply(enum operator op, void *result, const void *left, const void *right, slong exponent,
                  slong prec)
{
    struct series *z = result;
    const struct series *x = left, *y = right;
    enum series_fault fault = x->fault != SERIES_FINE ? x->fault : y != NULL ? y->fault : SERIES_FINE;
    if (fault == SERIES_FINE && !takes_angles(op) && (is_angle(x) || (y != NULL && is_angle(y))))
        fault = SERIES_ANGLE_AS_NUMBER;
    z->fault = fault;
    if (fault != SERIES_FINE)
        return;
    switch (op) {
    case OPERATOR_NEGATE:
        fmpq_poly_neg(z->p, x->p);
        fmpq_set(z->c, x->c);
        fmpq_neg(z->s, x->s);
        break;
    case OPERATOR_ADD:
        fmpq_poly_add(z->p, x->p, y->p);
        add_angles(z, x, y, false);
        break;
    case OPERATOR_SUBTRACT:
        fmpq_poly_sub(z->p, x->p, y->p);
        add_angles(z, x, y, true);
        break;
    case OPERATOR_MULTIPLY:
        fmpq_poly_mullow(z->p, x->p, y->p, prec);
        break;
    case OPERATOR_DIVIDE:
        divide(z, x, y, prec);
        break;
    case OPERATOR_POWER:
        power(z, x, exponent, prec);
        break;
    case OPERATOR_SQRT:
        square_root(z, x, prec);
        break;
    case OPERATOR_SIN:
    case OPERATOR_COS:
        sine_and_cosine(z, x, op == OPERATOR_SIN, prec);
        break;
    case OPERATOR_EXP:
        exponential(z, x, prec);
        break;
    case OPERATOR_ATAN2:
    case OPERATOR_POSITIVE:
        z->fault = SERIES_TRANSCENDENTAL;
        break;
    case OPERATOR_INPUT:
    case OPERATOR_NUMBER:
        break;
    }
}

const struct arithmetic arithmetic_series = {
    .name = "series",
    .size = sizeof(struct series),
    .init = series_init,
    .clear = series_clear,
    .set = series_set,
    .set_rational = set_rational,
    .set_infinity = set_infinity,
    .apply = apply,
};
