/*
 * Which known mistake a client's failures look like: each mistake of the sheet is tried on them, as the
 * formula (or the inputs) that it makes of the right one. And the other way round: which golden vectors
 * tell a mistake from the truth.
 */
#ifndef CT_DIAGNOSIS_H
#define CT_DIAGNOSIS_H

#include "conform/conform.h"

/* What a line that is no answer looks like, as it is shown, printable; "" where there is nothing to add to the outcome. */
void line_hint(const struct sheet *sheet, const char *line, enum outcome outcome, char *hint, size_t size);

/*
 * Into the summary of a test set: "as printed; or ...", what explains all its failures that were kept. Takes a second of
 * processor time, or little more; what has not been tried by then is left.
 */
void diagnose(struct test_run *e, int set);

/*
 * A CSV line for each golden vector that kills some: id,mistakes. False, and a line on standard error each,
 * where a mistake survives all vectors, or a vector kills none and pins no edge.
 */
bool kills_print(const struct section *s, double digits);

#endif
