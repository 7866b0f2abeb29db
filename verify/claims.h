/*
 * The ledger: every claim of the paper that can be decided, with its verdict and the evidence.
 *
 * A claim is decided by a function that computes its evidence and from it the verdict: nothing here
 * holds because it was written down. Evidence speaks in enclosures, exact values or derivation steps;
 * what was only measured is printed as a bound rounded outward, so that every machine prints the same.
 */
#ifndef CT_CLAIMS_H
#define CT_CLAIMS_H

#include <stdbool.h>
#include <stddef.h>

#include "claim.h"

struct evidence {
    enum verdict verdict;
    enum how how;
    const char *why; /* a sentence, of a verdict other than holds and definition; else NULL */
    char text[1600]; /* one line, no line break */
};

struct claim {
    const char *id;    /* lower case, dashes: routh-sufficient        */
    const char *where; /* Eq. (42), Table 1, section Numerical simulation */
    const char *claim; /* in our words                                */
    void (*decide)(struct evidence *e);
};

/* A list of claims, ended by one without id. */
extern const struct claim claims_statics[];   /* equilibria, charges, plasma       */
extern const struct claim claims_stability[]; /* the linear model, roots, optima   */
extern const struct claim claims_motion[];    /* the simulation, the linear model   */
extern const struct claim claims_convergence[]; /* the nonlinear motion, the charges */
extern const struct claim claims_forced[];    /* what pitch forces, in closed form  */
extern const struct claim claims_beyond[];    /* orders of the approximations, the end of pitch */

/* Appends to the evidence, printf-like. */
#if defined(__GNUC__)
__attribute__((format(printf, 2, 3)))
#endif
void evidence_add(struct evidence *e, const char *format, ...);

/* The verdict if every condition held that was claimed on the way to it; else VERDICT_NONE. */
void evidence_decide(struct evidence *e, enum verdict verdict, enum how how, bool proved);

#endif
