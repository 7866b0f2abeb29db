/*
 * Formulas written out in a claim, at work in balls: their values, the place where one changes sign, and
 * signs proved on whole intervals; and numbers as the evidence prints them.
 *
 * A formula knows what its caller names, pi, and the values that the sheet gives (Omega, k_c, m1, m2, L_ref,
 * n, and the initial psi, theta, dL and rates); where x is known, so is ln_x, its logarithm. One that does not
 * parse, or leaves its domain, is an indeterminate ball, which proves nothing.
 */
#ifndef CT_ENCLOSURE_H
#define CT_ENCLOSURE_H

#include <stdbool.h>

#include "flint.h"

enum { ENCLOSURE_BITS = 128 };

struct known {
    const char *name;
    arb_srcptr value;
};

/* KNOWN({"n", n}, {"x", x}) */
#define KNOWN(...) ((const struct known[]){__VA_ARGS__, {NULL, NULL}})
#define NOTHING KNOWN({NULL, NULL})

void enclose(arb_t z, const char *text, const struct known *known);

/* Whether it is greater than zero there, and for every x from low to high (formulas too). */
bool positive_at(const char *text, const struct known *known);
bool positive_on(const char *text, const char *low, const char *high, const struct known *known);

/* Encloses an x between low and high where the formula changes sign; false unless it does. */
bool change_of_sign(arb_t x, const char *text, const char *low, const char *high,
                    const struct known *known);

/* Numbers on their way into a line of evidence: start with {.proved = true}. */
struct numbers {
    char text[32][48];
    int count;
    bool proved; /* every digit so far */
};

/* Correctly rounded to so many significant digits. */
const char *number(struct numbers *n, const arb_t x, slong digits);

/* The same for the value of a formula. */
const char *number_of(struct numbers *n, slong digits, const char *text, const struct known *known);

#endif
