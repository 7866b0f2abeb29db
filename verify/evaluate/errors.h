/*
 * How wrong a floating-point answer is, in the unit in which it could not help being wrong:
 *
 *     E = |y - y*| / (u (|y*| + S)),  S = sum over the inputs of |x_i dy / dx_i|,  u = 2^-significand
 *
 * S is what one relative rounding of each input does to the output. E stays small for a backward
 * stable implementation even where y* is the small difference of large numbers.
 */
#ifndef CT_ERRORS_H
#define CT_ERRORS_H

#include <stdint.h>

#include "evaluate/operation.h"

enum { BINARY32 = 24, BINARY64 = 53, BINARY128 = 113 };

/* A motion has no S: its vectors are judged by digits. */
bool operation_has_sensitivity(const struct section *s);

/*
 * Enclosures of S for every output. Of roots: for each the modulus, on its real and its imaginary
 * part alike. One that no enclosure settles (it is zero, or infinite) is settled by operation_sensitivity_exact().
 */
void operation_sensitivity(struct operation *o, const struct input *inputs, slong prec, arb_ptr S);

/*
 * The same of formulas and their last inputs, from what the last enclosure left in the machine; derivatives have prec bits. What
 * roundings of numbers of those sizes do; NULL: of the inputs themselves.
 */
void formula_sensitivity(struct operation *o, slong prec, arb_srcptr sizes, arb_ptr S);

/* S of one output, where a derivative that is exactly zero adds nothing and a pole makes it infinite. */
void operation_sensitivity_exact(struct operation *o, const struct input *inputs, slong prec, int output, arb_t S);

struct error_bounds {
    double lower, upper; /* rounded outward */
};

/* Bounds on E; 0 where y = y*, infinity where y is no number, y* = S = 0 or S is infinite. */
struct error_bounds error_in_roundings(const arf_t y, const arb_t exact, const arb_t S, int significand);

/*
 * All outputs of an operation at once, y exact balls: the worst E, and which output. Roots are matched as a
 * set, multiple ones judged by their residual.
 */
struct error_bounds worst_error(const struct section *s, const struct input *inputs, arb_srcptr y, arb_srcptr exact,
                                arb_srcptr S, int significand, int *output);

/* ref/ against the truth on random inputs, a line an operation. */
struct measured {
    const struct section *section;
    long inputs;
    double worst;       /* largest E of an output, over all inputs                 */
    long index;         /* the random vector it came from                          */
    long outside;       /* MPFR values outside the ball's enclosure: there is none */
};

/*
 * Whether the same formulas in MPFR, twice as many bits, lie inside the enclosures, widened by what MPFR itself rounds.
 */
bool mpfr_inside(const struct operation *o, const struct input *inputs, arb_srcptr exact, arb_srcptr S);

void measure_errors(struct measured *m, const struct section *s, long count, uint64_t seed);

#endif
