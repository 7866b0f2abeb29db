/*
 * The four roots of (41), certified: how many there are, where, and in what order is proved.
 */
#ifndef CT_ROOTS_H
#define CT_ROOTS_H

#include <stdbool.h>

#include "text/flint.h"

/*
 * The roots of (41) for exact parameters, Omega > 0: sorted by real, then imaginary part, multiple
 * roots repeated. Each nonzero part has a relative accuracy of at least prec bits. The imaginary
 * part of a real root, the real part of an imaginary one and a root zero are exact zeros; conjugate
 * roots have conjugate enclosures. Always ends; false only when Omega is not positive.
 */
bool roots41(acb_ptr roots, const fmpq_t Omega, const fmpq_t C1, const fmpq_t C2, slong prec);

/*
 * The same for s = lambda/Omega, c1 = C1/Omega^2 and c2 = C2/Omega, parameters known by enclosures.
 * False when these, or prec, do not suffice to isolate the roots or to order them.
 */
bool roots41_gains(acb_ptr roots, const arb_t c1, const arb_t c2, slong prec);

/*
 * Four enclosures, a root of a real polynomial in each: those off the axis get conjugate ones, those that touch it hold a real root.
 * That is so where the conjugate of each meets one enclosure alone: there the conjugate root is. False where it is not.
 */
bool roots41_conjugates(acb_ptr roots);

/* True when the real (or imaginary) part of root k, in that order, is rational: value. By algebraic numbers, for ties. */
bool roots41_rational(fmpq_t value, int k, bool imaginary, const fmpq_t Omega, const fmpq_t C1, const fmpq_t C2);

#endif
