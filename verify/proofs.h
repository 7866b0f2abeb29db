/* All derivation steps, proved. */
#ifndef CT_PROOFS_H
#define CT_PROOFS_H

#include "derivation.h"

struct proofs {
    struct derivations derivations;
    struct proof *corrected, *printed; /* a proof a step; printed: of those that differ */
    const char *gap;                   /* an equation that no step reaches, or NULL     */
    int points;
    ulong degree;                      /* the largest */
    bool fine;                         /* everything holds, and there is no gap */
};

/* Reads the steps that were compiled into the program. */
void derivations_open(struct derivations *d);

/* The step of that id; a program that asks for one that is not there ends. */
const struct step *step_named(const struct derivations *d, const char *id);

/* The steps that were compiled into the program, at points drawn from the seed. */
void proofs_init(struct proofs *p, ulong seed);
void proofs_clear(struct proofs *p);

/* The step holds, and what is printed instead does not. */
bool proofs_step_holds(const struct proofs *p, int i);

#endif
