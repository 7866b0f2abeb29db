/* The text files that were compiled into the program. */
#ifndef CT_EMBEDDED_H
#define CT_EMBEDDED_H

#include <stddef.h>

const char *embedded_sheet(size_t *length);
const char *embedded_derivations(size_t *length);
const char *embedded_claims(size_t *length);

#endif
