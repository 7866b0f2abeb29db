/*
 * The ledger as a whole: a row for every equation number of the sheet, and one for every claim.
 */
#ifndef CT_LEDGER_H
#define CT_LEDGER_H

#include "claims.h"
#include "proof_results.h"

struct ledger_row {
    const char *id, *where, *claim;
    struct evidence evidence;
};

/* The verdict on one equation number of a section, as printed. */
void ledger_equation(struct evidence *e, const struct proof_results *p, const struct section *s, const char *equation);

/* Called for each row, in the order of the ledger. */
typedef void ledger_receiver(void *context, const struct ledger_row *row);

/*
 * Decides everything, or the row of that id alone; `proofs` are the derivation steps, proved. False when a
 * row stays undecided.
 */
bool ledger_rows(const struct proof_results *proofs, const char *only, ledger_receiver *receive, void *context);

/* The ids of the claims, without those of the equations and of Table 1; their number. */
enum { MOST_CLAIMS = 200 };
int ledger_claims(const char *ids[MOST_CLAIMS]);

#endif
