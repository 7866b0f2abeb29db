/* The numbers of arithmetic_series: exact power series in epsilon, and angles known by their sine and cosine. */
#ifndef CT_SERIES_H
#define CT_SERIES_H

#include "arithmetic.h"

enum series_fault {
    SERIES_FINE,
    SERIES_POLE,            /* division by zero, or by what is zero at epsilon = 0, left standing */
    SERIES_NO_SQUARE,       /* the square root of no rational square    */
    SERIES_NUMBER_AS_ANGLE, /* sine or cosine of a finite number        */
    SERIES_ANGLE_AS_NUMBER, /* arithmetic with a finite angle           */
    SERIES_TRANSCENDENTAL   /* a value that is no rational series       */
};

struct series {
    fmpq_poly_t p;
    fmpq_t c, s; /* cosine and sine of the finite part of an angle; 1 and 0 of a number       */
    bool large;  /* a pole of which p is the reciprocal, so that one may divide by it         */
    enum series_fault fault;
};

void series_init(void *x, slong prec);
void series_clear(void *x);

/* v epsilon^power */
void series_set_monomial(void *z, const fmpz_t v, slong power);

/* The coefficient of epsilon^k. */
void series_get_fmpq(fmpq_t q, const void *x, slong k);

/* The finite angle at that point of the unit circle, c^2 + s^2 = 1, c != 1. */
void series_set_angle(void *z, const fmpq_t c, const fmpq_t s);

/* SERIES_FINE where the coefficients of x are there to be compared; else why not. */
enum series_fault series_state(const void *x);
const char *series_fault_text(enum series_fault fault);

#endif
