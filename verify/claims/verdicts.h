/*
 * The verdicts: a row for every equation number of the sheet, for every row of Table 1, and for every claim.
 */
#ifndef CT_VERDICTS_H
#define CT_VERDICTS_H

#include "claims/statement.h"

struct verdict_row {
    const char *id, *where, *kind;
    struct written claim, why, evidence; /* why: no text where there is none */
    enum verdict verdict;
    enum how how;
    const struct statement *statement;   /* NULL: none of claims.yaml */
    struct message open;                 /* of one that is undecided, or comes out otherwise than its words say */
};

/* The verdict on one equation number of a section, as printed. `claims` are its further reasons; NULL: without. */
void verdict_on_equation(struct verdict_row *row, const struct derivations *p, struct statements *claims, const struct section *s,
                         const char *equation);
void verdict_row_clear(struct verdict_row *row);

/* Called for each row, in the order of the verdicts. */
typedef void verdict_receiver(void *context, const struct verdict_row *row);

/* Decides everything, or the row of that id alone. False when a row stays undecided or does not fit its words. */
bool verdict_rows(const struct derivations *proofs, struct statements *claims, const char *only, verdict_receiver *receive, void *context);

/* Whether there is such a row. */
bool verdict_known(struct statements *claims, const char *id);

#endif
