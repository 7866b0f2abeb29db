/* Between the two halves of reading paper/claims.yaml. */
#ifndef CT_STATEMENT_READER_H
#define CT_STATEMENT_READER_H

#include "statement.h"

enum { MOST_ABBREVIATIONS = 40 };

/* Whether a text has that word. */
bool mentions(const char *text, const char *word);

/* The text, and the formulas of all abbreviations that it needs, which are marked. The caller frees it. */
char *with_abbreviations(const struct document *d, const yaml_node_t *let, const char *text, bool needed[MOST_ABBREVIATIONS]);

/* left = right, left < right: where the sign stands, outside brackets; NULL: nowhere */
const char *find_ordering(const char *text, enum ordering *ordering, size_t *length);

/*
 * Adds to the document what the prover reads of each entry of `prove` that is an equality for all values. identities[k] is
 * the number of that mapping for the entry with the number k, or 0. The caller frees them.
 */
int *identities_add(struct document *d);

#endif
