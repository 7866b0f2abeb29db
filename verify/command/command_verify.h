/* The parts of coulomb-tether verify: each prints its proofs and returns whether all of them hold. */
#ifndef CT_COMMAND_VERIFY_H
#define CT_COMMAND_VERIFY_H

#include "claims/statement.h"

/* Markdown is README's, for the errors alone. */
enum format { FORMAT_TABLE, FORMAT_JSON, FORMAT_CSV, FORMAT_MARKDOWN };

bool print_proofs(const struct proof_results *p, const char *only, enum format format); /* NULL: all; whether all of it holds */
bool print_claims(struct statements *claims, const struct proof_results *p, const char *only, enum format format); /* NULL: all */
bool print_errors(const struct sheet *sheet, long inputs, enum format format);

#endif
