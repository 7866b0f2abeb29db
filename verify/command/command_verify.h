/* The parts of coulomb-tether verify: each prints its proofs and returns whether all of them hold. */
#ifndef CT_COMMAND_VERIFY_H
#define CT_COMMAND_VERIFY_H

#include "claims/statement.h"
#include "formula/typeset.h"

/* Markdown is README's, for the errors alone. */
enum format { FORMAT_TABLE, FORMAT_JSON, FORMAT_CSV, FORMAT_MARKDOWN };

bool print_proofs(const struct derivations *d, const char *only, enum format format); /* NULL: all; whether all of it holds */
bool print_claims(struct statements *claims, const struct derivations *p, const char *only, enum format format); /* NULL: all */
bool print_errors(const struct sheet *sheet, long inputs, enum format format);

/* A side of an equality of a step, as LaTeX: its references too, as eq14.L_dot, rate(x1), left(6a). */
void typeset_side(struct tex *t, const struct sheet *sheet, const struct identities *names, const char *text);

#endif
