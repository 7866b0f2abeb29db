/* The computations that claims use, each run once. */
#ifndef CT_COMPUTATION_H
#define CT_COMPUTATION_H

#include "claims/claim.h"

/* Those that have been asked for. */
struct computations {
    const struct derivations *steps;
    struct computed **of;
    int count;
};
void computations_clear(struct computations *all);

/* The computation of that name, not yet run; NULL: there is none. */
struct computed *computed_find(struct computations *all, const char *name);

struct computed *computed_new(const struct computation *of, const struct derivations *steps);
void computed_free(struct computed *c);

/* One of its numbers; the computation runs when the first is asked for. False: it gives none of that name. */
bool computed_number(struct computed *c, const char *name, arb_t value, enum how *how);

#endif
