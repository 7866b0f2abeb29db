/* The conditions of verdicts: names of assertions, each with `not` before it or without, joined by `and`. */
#ifndef CT_CONDITION_H
#define CT_CONDITION_H

#include "claims/statement.h"

/* What it wants of each assertion; false, with the place and what was expected, where it is broken or a name unknown. */
bool condition_read(struct verdict_condition *c, const struct statement *s, const char *text, size_t *where, struct message *why);

#endif
