/*
 * What paper/claims.yaml says: its claims, each with assertions, conditions on them, and evidence.
 *
 * An assertion is found true, found false, or stays undecided; so does a condition on several. What takes a trajectory, a
 * basin or an optimum is a computation: a C function that hands over named numbers and truths, and writes no words. It
 * runs once, however many claims use it.
 */
#ifndef CT_CLAIM_H
#define CT_CLAIM_H

#include <stdbool.h>

#include "proof/derivation.h"
#include "text/flint.h"

enum truth { UNDECIDED, FOUND_TRUE, FOUND_FALSE };

enum how { EXACT, CERTIFIED, MEASURED };

enum verdict {
    VERDICT_NONE, /* undecided: a failure */
    HOLDS,
    HOLDS_AS_CORRECTED,
    QUALIFIED,
    REFUTED,
    DEFINITION,
    NOT_DECIDABLE
};

extern const char *const verdict_names[]; /* "undecided", "holds", "holds as corrected", ... */
extern const char *const how_names[];     /* "exact", "certified", "measured"                */

/* What a computation hands its results to. */
struct computed;

/* The derivation steps that it may use, and with them the sheet. */
const struct derivations *steps_of(const struct computed *c);
const struct sheet *sheet_of(const struct computed *c);

/* One of its numbers, enclosed; an indeterminate ball decides nothing. EXACT for closed formulas of exact numbers. */
void give_number(struct computed *c, const char *name, const arb_t value, enum how how);

/* One of its truths: FOUND_TRUE or FOUND_FALSE only where it is proved. */
void give_truth(struct computed *c, const char *name, enum truth truth, enum how how);

/* Proved true or not proved: what cannot be refuted this way stays undecided. */
enum truth proved_or_open(bool proved);

/* A list of computations ends with one without name. Each of its numbers and truths is handed over, in any order. */
struct computation {
    const char *name;
    void (*run)(struct computed *c);
    const char *numbers, *truths; /* their names, blanks between */
};

extern const struct computation computations_loop[];        /* claims_loop.c: rests and basins           */
extern const struct computation computations_motion[];      /* claims_motion.c                           */
extern const struct computation computations_convergence[]; /* claims_convergence.c                      */
extern const struct computation computations_forced[];      /* claims_forced.c                           */
extern const struct computation computations_beyond[];      /* claims_beyond.c                           */

#endif
