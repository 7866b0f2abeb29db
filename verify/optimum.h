/*
 * The rates of decay under critical damping, on the whole half line of n, and the best of them.
 *
 * With Omega = 1 and (43), (44), w = n - 9 = u^2, the polynomial of (41) is (s^2 + 3)(s + u)^2 + 4 s^2.
 * Its two pairs of roots decay at the rates (u - t)/2 and (u + t)/2, where y = t^2 is the only positive
 * root of
 *                 y (y + 7)^2 = w (y^2 + 14 y + 1),
 *
 * and y grows with w: it is a parameter of the whole half line n > 9. rates_proved() proves all this.
 */
#ifndef CT_OPTIMUM_H
#define CT_OPTIMUM_H

#include <stdbool.h>

#include "flint.h"

bool rates_proved(void);

/*
 * True when for all w beyond p/q the slower rate is greater (sign = 1) or less (-1) than (u - v)/2, where
 * v^2 is the quotient of two polynomials in x = w and v >= 0.
 */
bool slow_rate_compares(const char *numerator, const char *denominator, slong p, ulong q, int sign);

/* The best n on (44), and the greatest slower rate, over Omega, that it gives. */
struct optimum {
    arb_t n, rate;
    fmpz_poly_t n_solves, square_solves; /* polynomials with the root n, and the root rate^2 */
};

void optimum_init(struct optimum *o);
void optimum_clear(struct optimum *o);

/* True when proved to be the only stationary point on n > 9. */
bool optimum_find(struct optimum *o, slong prec);

#endif
