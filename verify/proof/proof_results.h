/* All derivation steps, proved. */
#ifndef CT_PROOF_RESULTS_H
#define CT_PROOF_RESULTS_H

#include "proof/derivation.h"
#include "sheet/paper.h"

struct proof_results {
    struct derivations derivations;
    const char *gap; /* an equation that no step reaches, or NULL          */
    int mutants;
    bool fine;       /* everything holds and is bound, and there is no gap */
};

/* Reads the paper's steps; -1, and `why`, where they are broken. */
int derivations_open(struct derivations *d, const struct paper *paper, struct message *why);

/* The step of that id; NULL: there is none. */
const struct step *step_named(const struct derivations *d, const char *id);

/* Of the paper's steps. */
int proof_results_init(struct proof_results *p, const struct paper *paper, struct message *why);

/* And their lines, and what binds them to their equations, which takes ten times as long: all, or the step of that id alone. */
void proof_results_bind(struct proof_results *p, const char *only);
void proof_results_clear(struct proof_results *p);

/* The step and its lines hold, what is printed instead does not, and what is dropped is bounded. */
bool step_holds(const struct step *s);

#endif
