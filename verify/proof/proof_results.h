/* All derivation steps, proved. */
#ifndef CT_PROOF_RESULTS_H
#define CT_PROOF_RESULTS_H

#include "proof/derivation.h"

struct proof_results {
    struct derivations derivations;
    struct proof *corrected, *printed; /* a proof a step; printed: of those that differ            */
    struct remainder_proof **remainders; /* of each step, one a remainder                         */
    struct binding *bindings;          /* NULL where they were not asked for                       */
    const char *gap;                   /* an equation that no step reaches, or NULL                */
    int mutants;
    bool fine;                         /* everything holds and is bound, and there is no gap       */
};

/* Reads the steps that were compiled into the program. */
void derivations_open(struct derivations *d);

/* The step of that id; a program that asks for one that is not there ends. */
const struct step *step_named(const struct derivations *d, const char *id);

/* The steps that were compiled into the program. */
void proof_results_init(struct proof_results *p);

/* Of steps that are open already, which are the results' own from then on. */
void proof_results_of(struct proof_results *p);

/* And what binds them to their equations, which takes ten times as long: all, or the step of that id alone. */
void proof_results_bind(struct proof_results *p, const char *only);
void proof_results_clear(struct proof_results *p);

/* The step holds, what is printed instead does not, and what is dropped is bounded. */
bool step_holds(const struct proof_results *p, int i);

#endif
