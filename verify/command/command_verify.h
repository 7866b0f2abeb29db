/* The parts of coulomb-tether verify: each prints its proofs and returns whether all of them hold. */
#ifndef CT_COMMAND_VERIFY_H
#define CT_COMMAND_VERIFY_H

#include "claims/statement.h"
#include "text/json.h"

/* What was asked for. */
struct verification {
    const struct sheet *sheet;
    const char *part, *only; /* a part, and of it a step or a claim by its id; NULL: all */
    struct json *json; /* an object, of which each part is a member; NULL: text for reading */
    long count;       /* of the inputs that errors are measured on */
    struct derivations steps;
    struct statements claims; /* where they are asked for */
};

bool verify_derivations(struct verification *v);
bool verify_claims(struct verification *v);
bool verify_errors(struct verification *v);

#endif
