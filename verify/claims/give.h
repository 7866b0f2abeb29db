/* What the files of computations share: numbers that are handed over by the name of what they are of. */
#ifndef CT_GIVE_H
#define CT_GIVE_H

#include "claims/claim.h"

#if defined(__GNUC__)
#define NAMED_LIKE_PRINTF __attribute__((format(printf, 4, 5)))
#else
#define NAMED_LIKE_PRINTF
#endif

/* A certified number, or an indeterminate one where it was not proved. */
NAMED_LIKE_PRINTF void give(struct computed *c, bool proved, const arb_t x, const char *name, ...);

/* The same of a number that is measured. */
NAMED_LIKE_PRINTF void give_measured(struct computed *c, bool found, const arb_t x, const char *name, ...);

/* Names for `numbers` of a computation, of three and of six coordinates. */
#define ANGLES_AND_LENGTH(before, after) " " before "psi" after " " before "theta" after " " before "dL" after
#define TETHER_STATE(before) ANGLES_AND_LENGTH(before, "") ANGLES_AND_LENGTH(before, "_dot")
#define PLACE_OF_1(before) " " before "x1 " before "y1 " before "z1"

#endif
