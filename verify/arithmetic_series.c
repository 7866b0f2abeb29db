/*
 * Exact power series in an infinitesimal epsilon with rational coefficients, `prec` terms of them.
 *
 * An angle may have a finite part: it is then known by a rational point (c, s) of the unit circle, its
 * cosine and sine, and the series is what comes on top. A number that grows beyond all bounds as
 * epsilon vanishes is known by its reciprocal; one may divide by it. Nothing here rounds, nothing is
 * approximate; what has no such value (a pole, the root of no square, an angle used as a number) is a
 * fault, which every later result inherits.
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
    z->large = false;
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
    to->large = from->large;
    to->fault = from->fault;
}

/* The series becomes a number, whatever it was; p is left to the caller. */
static void set_number(struct series *z)
{
    fmpq_one(z->c);
    fmpq_zero(z->s);
    z->large = false;
    z->fault = SERIES_FINE;
}

static void set_rational(void *z, const fmpq_t q, slong prec)
{
    (void)prec;
    set_number(z);
    fmpq_poly_set_fmpq(((struct series *)z)->p, q);
}

void series_set_monomial(void *z, const fmpz_t v, slong power)
{
    struct series *to = z;
    set_number(to);
    fmpq_poly_zero(to->p);
    fmpq_poly_set_coeff_fmpz(to->p, power, v);
}

void series_get_fmpq(fmpq_t q, const void *x, slong k)
{
    fmpq_poly_get_coeff_fmpq(q, ((const struct series *)x)->p, k);
}

void series_set_angle(void *z, const fmpq_t c, const fmpq_t s)
{
    struct series *to = z;
    set_number(to);
    fmpq_poly_zero(to->p);
    fmpq_set(to->c, c);
    fmpq_set(to->s, s);
}

static bool is_angle(const struct series *x)
{
    return !fmpq_is_one(x->c);
}

enum series_fault series_state(const void *x)
{
    const struct series *z = x;
    return z->fault == SERIES_FINE && is_angle(z) ? SERIES_ANGLE_AS_NUMBER : z->fault;
}

const char *series_fault_text(enum series_fault fault)
{
    static const char *const texts[] = {
        [SERIES_FINE] = "fine",
        [SERIES_POLE] = "division by what is zero at epsilon = 0",
        [SERIES_NO_SQUARE] = "the square root of no rational square",
        [SERIES_NUMBER_AS_ANGLE] = "the sine or cosine of a number that is no angle",
        [SERIES_ANGLE_AS_NUMBER] = "a finite angle outside sine and cosine",
        [SERIES_TRANSCENDENTAL] = "a value that is no rational series",
    };
    return texts[fault];
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
    }
    fmpq_clear(by_cos);
    fmpq_clear(by_sin);
    fmpq_clear(constant);
    fmpq_poly_clear(cosp);
    fmpq_poly_clear(sinp);
}

/* The positive root of a rational square; false for anything else. */
static bool rational_root(fmpq_t root, const fmpq_t square)
{
    if (fmpq_sgn(square) < 0 || !fmpz_is_square(fmpq_numref(square)) ||
        !fmpz_is_square(fmpq_denref(square)))
        return false;
    fmpz_sqrt(fmpq_numref(root), fmpq_numref(square));
    fmpz_sqrt(fmpq_denref(root), fmpq_denref(square));
    return true;
}

/*
 * FLINT's square root wants the constant term 1: divide by it, and multiply by its rational root. A
 * constant term of zero has no such root, unless it is all there is (zero up to a higher power of
 * epsilon is not enough: the root of epsilon^2 is epsilon).
 */
static void square_root(struct series *z, const struct series *x, slong prec)
{
    fmpq_t constant, root;
    fmpq_init(constant);
    fmpq_init(root);
    fmpq_poly_get_coeff_fmpq(constant, x->p, 0);
    if (!rational_root(root, constant) || (fmpq_is_zero(root) && prec > 1)) {
        z->fault = SERIES_NO_SQUARE;
    } else if (fmpq_is_zero(root)) {
        fmpq_poly_zero(z->p);
    } else {
        fmpq_poly_scalar_div_fmpq(z->p, x->p, constant);
        fmpq_poly_sqrt_series(z->p, z->p, prec);
        fmpq_poly_scalar_mul_fmpq(z->p, z->p, root);
    }
    fmpq_clear(constant);
    fmpq_clear(root);
}

/* The angle of a point off the circle: of constants, and with a rational distance from the origin. */
static void arc_tangent(struct series *z, const struct series *y, const struct series *x, slong prec)
{
    fmpq_t c, s, r;
    fmpq_init(c);
    fmpq_init(s);
    fmpq_init(r);
    fmpq_poly_get_coeff_fmpq(c, x->p, 0);
    fmpq_poly_get_coeff_fmpq(s, y->p, 0);
    fmpq_mul(r, c, c);
    fmpq_addmul(r, s, s);
    if (prec > 1) {
        z->fault = SERIES_TRANSCENDENTAL;
    } else if (!rational_root(r, r)) {
        z->fault = SERIES_NO_SQUARE;
    } else if (fmpq_is_zero(r)) {
        z->fault = SERIES_POLE;
    } else {
        fmpq_div(c, c, r);
        fmpq_div(s, s, r);
        series_set_angle(z, c, s);
    }
    fmpq_clear(c);
    fmpq_clear(s);
    fmpq_clear(r);
}

static bool starts_with_zero(const fmpq_poly_t p)
{
    return fmpq_poly_length(p) == 0 || fmpz_is_zero(fmpq_poly_numref(p));
}

static void divide(struct series *z, const struct series *x, const struct series *y, slong prec)
{
    const bool by_large = y->large;
    z->large = false;
    if (by_large) {
        fmpq_poly_mullow(z->p, x->p, y->p, prec);
    } else if (!starts_with_zero(y->p)) {
        fmpq_poly_div_series(z->p, x->p, y->p, prec);
    } else if (!starts_with_zero(x->p)) {
        fmpq_poly_div_series(z->p, y->p, x->p, prec);
        z->fault = SERIES_POLE;
        z->large = true;
    } else {
        z->fault = SERIES_POLE;
    }
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

static enum series_fault operand_fault(enum operator op, const struct series *x)
{
    return x->fault == SERIES_FINE && is_angle(x) && !takes_angles(op) ? SERIES_ANGLE_AS_NUMBER : x->fault;
}

static void apply(enum operator op, void *result, const void *left, const void *right, slong exponent,
                  slong prec)
{
    struct series *z = result;
    const struct series *x = left, *y = right;
    enum series_fault fault = operand_fault(op, x);
    if (fault == SERIES_FINE && y != NULL && !(op == OPERATOR_DIVIDE && y->large))
        fault = operand_fault(op, y);
    z->fault = fault;
    if (fault != SERIES_FINE) {
        z->large = false;
        return;
    }
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
        arc_tangent(z, x, y, prec);
        break;
    case OPERATOR_INPUT: /* no operations, these two: never asked for */
    case OPERATOR_NUMBER:
    case OPERATOR_LOG:
    case OPERATOR_POSITIVE:
        z->fault = SERIES_TRANSCENDENTAL;
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
    .apply = apply,
};
