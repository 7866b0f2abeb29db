/* Degrees of what a program computes: the rules and their reasons stand in degree.h. */
#include "degree.h"

static void init(void *x, slong prec)
{
    (void)prec;
    *(struct degree *)x = (struct degree){0};
}

static void clear(void *x)
{
    (void)x;
}

static void set_rational(void *z, const fmpq_t q, slong prec)
{
    init(z, prec);
    ((struct degree *)z)->sign = fmpq_is_zero(q)   ? SIGN_ZERO
                                 : fmpq_sgn(q) > 0 ? SIGN_POSITIVE
                                                   : SIGN_UNKNOWN;
}

static ulong most(ulong a, ulong b)
{
    return a > b ? a : b;
}

static ulong sum(ulong a, ulong b)
{
    return a >= DEGREE_LIMIT - b ? DEGREE_LIMIT : a + b;
}

static ulong product(ulong a, ulong b)
{
    return b != 0 && a >= DEGREE_LIMIT / b ? DEGREE_LIMIT : a * b;
}

ulong degree_of_difference(const struct degree *x, const struct degree *y)
{
    return most(sum(x->num, y->den), sum(y->num, x->den));
}

static void add(struct degree *z, const struct degree *x, const struct degree *y, bool negative)
{
    bool grows = !negative && x->sign == SIGN_POSITIVE && y->sign == SIGN_POSITIVE;
    *z = (struct degree){
        .num = degree_of_difference(x, y),
        .den = sum(x->den, y->den),
        .point_num = sum(x->point_num, y->point_num),
        .point_den = sum(x->point_den, y->point_den),
        .sign = y->sign == SIGN_ZERO                ? x->sign
                : x->sign == SIGN_ZERO && !negative ? y->sign
                : grows                             ? SIGN_POSITIVE
                                                    : SIGN_UNKNOWN,
    };
}

static enum sign sign_of_product(const struct degree *x, const struct degree *y)
{
    if (x->sign == SIGN_ZERO || y->sign == SIGN_ZERO)
        return SIGN_ZERO;
    return x->sign == SIGN_POSITIVE && y->sign == SIGN_POSITIVE ? SIGN_POSITIVE : SIGN_UNKNOWN;
}

static void power(struct degree *z, const struct degree *x, slong exponent)
{
    ulong n = (ulong)(exponent < 0 ? -exponent : exponent);
    ulong num = product(n, x->num), den = product(n, x->den);
    z->num = exponent < 0 ? den : num;
    z->den = exponent < 0 ? num : den;
    z->sign = n == 0 ? SIGN_POSITIVE : x->sign;
}

static void square_root(struct degree *z, const struct degree *x, ulong K)
{
    ulong series = product(K, sum(x->num, x->den));
    z->sign = x->sign == SIGN_POSITIVE ? SIGN_POSITIVE : SIGN_UNKNOWN;
    z->num = sum(x->num / 2, series);
    z->den = sum(x->den / 2, series);
}

static void transcendental(enum operator op, struct degree *z, const struct degree *x, ulong K)
{
    bool at_right = x->sign == SIGN_ZERO || x->sign == SIGN_RIGHT_ANGLE;
    z->sign = op == OPERATOR_EXP || (op == OPERATOR_COS && at_right) ? SIGN_POSITIVE
              : op == OPERATOR_SIN && x->sign == SIGN_ZERO           ? SIGN_ZERO
                                                                     : SIGN_UNKNOWN;
    z->num = sum(x->point_num, product(K, most(x->num, x->den)));
    z->den = sum(x->point_den, product(K, x->den));
    z->point_num = z->point_den = 0;
}

/* r has the degrees most(nx + dy, ny + dx) over dx + dy, and the same bounds hold for x/r and y/r. */
static void arc_tangent(struct degree *z, const struct degree *y, const struct degree *x)
{
    ulong bound = sum(degree_of_difference(x, y), sum(x->den, y->den));
    *z = (struct degree){.point_num = bound, .point_den = bound};
}

static void apply(enum operator op, void *result, const void *left, const void *right, slong exponent,
                  slong prec)
{
    struct degree *z = result;
    const struct degree x = *(const struct degree *)left;
    const struct degree y = right != NULL ? *(const struct degree *)right : (struct degree){0};
    const ulong K = (ulong)(prec - 1);
    *z = x;
    switch (op) {
    case OPERATOR_NEGATE:
        if (x.sign == SIGN_POSITIVE)
            z->sign = SIGN_UNKNOWN;
        break;
    case OPERATOR_ADD:
    case OPERATOR_SUBTRACT:
        add(z, &x, &y, op == OPERATOR_SUBTRACT);
        break;
    case OPERATOR_MULTIPLY:
        *z = (struct degree){.num = sum(x.num, y.num), .den = sum(x.den, y.den), .sign = sign_of_product(&x, &y)};
        break;
    case OPERATOR_DIVIDE:
        *z = (struct degree){.num = sum(x.num, y.den), .den = sum(x.den, y.num), .sign = sign_of_product(&x, &y)};
        break;
    case OPERATOR_POWER:
        power(z, &x, exponent);
        break;
    case OPERATOR_SQRT:
        square_root(z, &x, K);
        break;
    case OPERATOR_SIN:
    case OPERATOR_COS:
    case OPERATOR_EXP:
        transcendental(op, z, &x, K);
        break;
    case OPERATOR_ATAN2:
        arc_tangent(z, &x, &y);
        break;
    case OPERATOR_INPUT: /* no operations, these two: never asked for */
    case OPERATOR_NUMBER:
    case OPERATOR_LOG: /* no series has one */
    case OPERATOR_POSITIVE:
        z->sign = SIGN_UNKNOWN;
        break;
    }
}

const struct arithmetic arithmetic_degree = {
    .name = "degree",
    .size = sizeof(struct degree),
    .init = init,
    .clear = clear,
    .set_rational = set_rational,
    .apply = apply,
};
