/* The derivation steps of coulomb-tether verify, each with its proof and what binds it. */
#ifndef CT_COMMAND_DERIVATIONS_H
#define CT_COMMAND_DERIVATIONS_H

#include "proof/derivation.h"
#include "text/json.h"

/* All, or the step of that id (not NULL), as a member of an object or (NULL) as text; whether all of them hold. */
bool print_derivations(const struct derivations *d, const char *only, struct json *j);

#endif
