/*
 * Formulas that a computation writes out, at work in balls. A formula knows what its caller names, and the values that the
 * sheet gives (Omega, k_c, m1, m2, L_ref, n, and the initial psi, theta, dL and rates). One that does not parse, or leaves
 * its domain, is an indeterminate ball, which proves nothing.
 */
#ifndef CT_ENCLOSURE_H
#define CT_ENCLOSURE_H

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

#endif
