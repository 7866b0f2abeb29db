/*
 * Exact numbers, on Calcium: they decide what enclosures cannot, whether a result is zero, or rational, so that
 * raising the precision until a value rounds always ends.
 *
 * Calcium computes in the field that the numbers met so far span, and says of a predicate true, false or unknown. What
 * it cannot decide is not decided here either: unknown is neither zero nor rational. Numbers are real; what is none is
 * undefined and stays so: a root of what is negative or of unknown sign, zero over zero. An infinite input (lambda_d) is
 * Calcium's positive infinity: a finite number over it is zero, and zero times it is undefined.
 */
#ifndef CT_EXACT_H
#define CT_EXACT_H

#include "formula/arithmetic.h"

struct exact {
    ca_struct value;
};

/* No number, or an infinite one, for certain. */
bool exact_is_undefined(const struct exact *x);

bool exact_is_zero(const struct exact *x);

/* Sets the value where it is known to be rational. */
bool exact_is_rational(fmpq_t value, const struct exact *x);

#endif
