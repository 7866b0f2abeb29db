/*
 * What paper/claims.yaml says: its claims, each with assertions, conditions on them, and evidence.
 *
 * An assertion is found true, found false, or stays undecided; so does a condition on several. What takes a trajectory, a
 * basin or an optimum is a computation: a C function that hands over named numbers, and writes no words. It runs once,
 * however many claims use it.
 */
#ifndef CT_CLAIM_H
#define CT_CLAIM_H

#include <stdbool.h>

#include "proof/derivation.h"
#include "text/flint.h"

enum truth { UNDECIDED, FOUND_TRUE, FOUND_FALSE, FOUND_LOOSE }; /* loose: true, by a bound that is too wide */

enum how { EXACT, CERTIFIED };

/* The less is left of a statement, the less the number. */
enum verdict {
    VERDICT_NONE, /* undecided: a failure */
    REFUTED,
    NOT_DECIDABLE,
    QUALIFIED,
    HOLDS_AS_CORRECTED,
    HOLDS,
    DEFINITION,
    VERDICTS
};

extern const char *const verdict_names[VERDICTS]; /* "undecided", "refuted", ... */
extern const char *const how_names[];             /* "exact", "certified"        */

/* Of what a trajectory, an orbit's study or a limit is made: a function that hands over named numbers. */
struct computed;
struct computation {
    const char *name;
    void (*run)(struct computed *c);
    const void *of; /* what is particular to this one of several that run alike */
};

struct asked {
    char name[64];
    arb_t value;
};

/* One at work, with the numbers that are asked of it. */
struct computed {
    struct computation of;
    const struct derivations *steps; /* that it may use, with them the sheet */
    bool done;
    struct asked *numbers;
    int count;
};

/* One of its numbers, by its name (printf-like): the enclosure if it was proved, else nothing. */
#if defined(__GNUC__)
__attribute__((format(printf, 4, 5)))
#endif
void give(struct computed *c, bool proved, const arb_t x, const char *name, ...);

/*
 * Of one that is `of` a struct sampled: the numbers that are asked, in SI, each named for its measure, the variable and, in hours,
 * from when on or from when to when (sup_psi_48_72); of exits, for the part of the start (exit_dL_200).
 */
void run_simulation(struct computed *c);

/* Lists that end with one without name; studies are computations too (convergence.h). */
extern const struct computation computations_simulation[]; /* claims_simulation.c */
extern const struct computation computations_sampling[];   /* claims_sampling.c   */

/* Those that have been asked for. */
struct computations {
    const struct derivations *steps;
    struct computed **of;
    int count;
};
void computations_clear(struct computations *all);

/* The computation of that name, not yet run; NULL: there is none. */
struct computed *computed_find(struct computations *all, const char *name);

struct computed *computed_new(struct computation of, const struct derivations *steps);
void computed_free(struct computed *c);

/* A number is asked of it by its name, before it runs; ... */
void computed_ask(struct computed *c, const char *name);

/* ... and its value, certified: the computation runs for the first. Indeterminate where it has none of that name, or proves none. */
void computed_number(struct computed *c, const char *name, arb_t value);

#endif
