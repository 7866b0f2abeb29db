/*
 * One formula, several arithmetics. A program of the formula sheet runs in every arithmetic that has
 * these few functions:
 *
 *     mpfr      correctly rounded multiple precision       prec = bits
 *     ball      rigorous enclosures (Arb)                  prec = bits
 *     symbolic  rational functions, series in epsilon      prec = number of terms
 *     exact     exact numbers (Calcium)                    prec = unused
 */
#ifndef CT_ARITHMETIC_H
#define CT_ARITHMETIC_H

#include <stdbool.h>
#include <stddef.h>

#include "text/flint.h"

enum operator
{
    OPERATOR_INPUT,
    OPERATOR_NUMBER,
    OPERATOR_NEGATE,
    OPERATOR_ADD,
    OPERATOR_SUBTRACT,
    OPERATOR_MULTIPLY,
    OPERATOR_DIVIDE,
    OPERATOR_POWER, /* to 0, 1, 2 ... */
    OPERATOR_SQRT,
    OPERATOR_SIN,
    OPERATOR_COS,
    OPERATOR_EXP,
    OPERATOR_LOG,
    OPERATOR_ATAN2,
    OPERATOR_POSITIVE /* 1 where the argument is > 0, else 0 */
};

struct arithmetic {
    size_t size; /* of a number, in bytes */
    void (*init)(void *x, slong prec);
    void (*clear)(void *x);
    void (*set)(void *z, const void *x); /* NULL where no gradient is taken */
    void (*set_rational)(void *z, const fmpq_t q, slong prec);
    void (*set_infinity)(void *z); /* NULL where no input is infinite */
    /* z = x op y; a unary operator ignores y, only a power reads the exponent; z may be x or y */
    void (*apply)(enum operator op, void *z, const void *x, const void *y, slong exponent, slong prec);
};

extern const struct arithmetic arithmetic_mpfr, arithmetic_ball, arithmetic_symbolic, arithmetic_exact;

#endif
