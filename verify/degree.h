/*
 * How much chance a random point leaves a false identity: bounds on the degrees of what a program
 * computes in arithmetic_series, found by running it in one more arithmetic.
 *
 * Let x = (x_1 ... x_m) be the integers that are drawn. Every value is, up to epsilon^K, a quotient
 * N(x, epsilon)/D(x, epsilon) of polynomials with rational coefficients, D(x, 0) not zero wherever the
 * point is accepted (or, of what is only divided by, N(x, 0)). num and den bound the total degree in x of
 * N and D; epsilon counts nothing. By the operations:
 *
 *   drawn number        x_i epsilon^p = N/1                                            1, 0
 *   drawn angle t       cosine (t^2 - 1)/(t^2 + 1), sine 2t/(t^2 + 1)                  2, 2
 *   a/b +- c/d          (ad +- cb)/(bd)
 *   product, quotient   (ac)/(bd), (ad)/(bc); a pole at the point is refused
 *   power               of N and of D
 *   sin, cos, exp of p = N/D, p = 0 at epsilon = 0: the Taylor polynomial sum of p^j/j!, j <= K, is
 *                       congruent to it; over D^K its terms are N^j D^(K-j). The sine and cosine of
 *                       an angle with a finite part come on top of that as factors.
 *   square root of F = N/D, F(x, 0) = r^2 with r a rational function (which the prover has checked):
 *                       r = A/B in lowest terms, so that A^2 divides N(x, 0) and B^2 divides D(x, 0): half
 *                       their degrees. h = F/r^2 - 1 = (N D0 - N0 D)/(D N0), and the binomial series
 *                       r sum of binom(1/2, j) h^j, j <= K, is congruent to the root.
 *   atan2(y, x)         the angle of cosine x/r, sine y/r, r^2 = x^2 + y^2; of constants (K = 0) alone.
 *
 * An equality a/b = c/d claims that ad - cb is zero up to epsilon^K. If it is not, one of these
 * coefficients is a polynomial other than zero, of a degree g that num and den bound, and vanishes at a
 * point with coordinates drawn evenly from 2^64 integers with a chance of g/2^64 at most (Schwartz,
 * Zippel). Points are drawn again where a divisor vanishes. The product of all divisors has a degree
 * below 2^63 (DEGREE_LIMIT), so at least half the points are accepted: the chance that an accepted
 * point hides the fault is g/2^63 at most, and independent points multiply.
 */
#ifndef CT_DEGREE_H
#define CT_DEGREE_H

#include "arithmetic.h"

/* What the form alone tells of a value at epsilon = 0. */
enum sign { SIGN_UNKNOWN, SIGN_ZERO, SIGN_POSITIVE, SIGN_RIGHT_ANGLE /* an angle whose cosine is positive */ };

struct degree {
    ulong num, den;             /* of a number, or of what an angle has besides its finite part */
    ulong point_num, point_den; /* of the sine and cosine of its finite part                    */
    enum sign sign;
};

/* Degrees saturate at 2^40. Fewer than 2^22 divisors below that keep the promise above. */
#define DEGREE_LIMIT ((ulong)1 << 40)
#define NODE_LIMIT (1 << 22)

extern const struct arithmetic arithmetic_degree; /* prec = number of terms, K + 1 */

/* The degree of the numerator of x - y. */
ulong degree_of_difference(const struct degree *x, const struct degree *y);

#endif
