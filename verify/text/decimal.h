/*
 * Numbers as text: what a literal means, and decimals that are correctly rounded or refused.
 */
#ifndef CT_DECIMAL_H
#define CT_DECIMAL_H

#include <stdbool.h>

#include "text/flint.h"

enum literal {
    LITERAL_FINITE,
    LITERAL_INFINITE,   /* inf, +inf, infinity: positive infinity   */
    LITERAL_MALFORMED,  /* no number: text, empty, trailing letters */
    LITERAL_NAN,
    LITERAL_NEGATIVE_INFINITE,
    LITERAL_OVERFLOW    /* overflows binary64 (or, exact, an exponent beyond +-5000, some 10,000 digits) */
};

/*
 * A decimal or C99 hexadecimal literal. Not exact: the nearest binary64, ties to even
 * (what an implementation in double sees). Exact: the literal's own value.
 * The value is set for LITERAL_FINITE alone.
 */
enum literal literal_read(fmpq_t value, const char *text, bool exact);

/*
 * d.ddde-XX with `digits` significant digits (digits >= 1), rounded to nearest, ties to even; zero is "0".
 * At least two digits of exponent, as in C's %e. The caller frees the text with free().
 */
char *decimal_of_rational(const fmpq_t x, slong digits);

/* The same for a real number known by an enclosure; NULL when that does not decide every digit, or its exponent is as long as no decimal's. */
char *decimal_of_ball(const arb_t x, slong digits);

/* The lower or upper end of a ball, rounded outward: all of a finite ball lies above the one and below the other. */
char *decimal_of_end(const arb_t x, slong digits, bool upper);

/* The shortest decimal that reads back as the same binary64: 100, 0.01, 7.2915e-05, -1.5e+20. */
void decimal_shortest(char text[32], double x);

/* Of what is not below zero a bound, two significant digits rounded up: 1.3e-12. */
void decimal_bound(char text[32], double x);

#endif
