/*
 * Exact sums c1 sqrt(n1) e^b1 + c2 sqrt(n2) e^b2 + ... that decide what enclosures cannot: whether
 * a result is zero, or rational, so that raising the precision until a value rounds always ends.
 */
#ifndef CT_EXACT_H
#define CT_EXACT_H

#include <stdbool.h>

#include "flint.h"

struct exact_term;

struct exact {
    enum { EXACT_SUM, EXACT_INFINITE, EXACT_UNKNOWN } kind;
    bool pole; /* unknown, and perhaps no number at all: division by zero, root of a negative number
                */
    slong length;
    struct exact_term *terms; /* of a sum */
};

void exact_init(struct exact *x);
void exact_clear(struct exact *x);
void exact_set(struct exact *z, const struct exact *x);
void exact_set_fmpq(struct exact *z, const fmpq_t q);

/* Plus infinity: any number over it is zero, any other use of it is unknown. */
void exact_set_infinity(struct exact *z);

/*
 * The arithmetic; z may be x or y. Unknown are: what is unknown of an operand, unless multiplied by
 * zero; division by a sum of four terms or more, or one with exponentials; the root of what is not
 * rational; sine, cosine and exponential of what has exponentials; angles other than 0.
 */
void exact_neg(struct exact *z, const struct exact *x);
void exact_add(struct exact *z, const struct exact *x, const struct exact *y);
void exact_sub(struct exact *z, const struct exact *x, const struct exact *y);
void exact_mul(struct exact *z, const struct exact *x, const struct exact *y);
void exact_div(struct exact *z, const struct exact *x, const struct exact *y);
void exact_pow(struct exact *z, const struct exact *x, slong n);
void exact_sqrt(struct exact *z, const struct exact *x);
void exact_sin(struct exact *z, const struct exact *x);
void exact_cos(struct exact *z, const struct exact *x);
void exact_exp(struct exact *z, const struct exact *x);
void exact_atan2(struct exact *z, const struct exact *y, const struct exact *x);
void exact_positive(struct exact *z, const struct exact *x); /* 1 where x > 0, else 0 */

bool exact_is_zero(const struct exact *x);
bool exact_is_rational(fmpq_t value, const struct exact *x);
bool exact_is_unknown(const struct exact *x); /* infinity is not a number, so unknown too */

/* An enclosure of x; indeterminate when x is unknown. */
void exact_enclosure(arb_t y, const struct exact *x, slong prec);

#endif
