/* Between the two halves of reading a derivation step: its entries, and the formulas in them. */
#ifndef CT_DERIVATION_READER_H
#define CT_DERIVATION_READER_H

#include "derivation.h"

struct reader {
    struct document *document;
    const struct sheet *sheet;
    const yaml_node_t *step, *printed; /* printed: NULL while the step itself is read */
    struct trial *trial;
    bool shared; /* the context is that of other equalities too: not all of it need serve this one */
};

/* The scalar's formula: its node in the trial's program, or -1 after a complaint. */
int read_formula(struct reader *r, const yaml_node_t *node);

/* The same of a formula that stands `shift` characters into the scalar. */
int read_formula_at(struct reader *r, const yaml_node_t *node, const char *text, size_t shift);

/* left = right; false after a complaint */
bool read_equality(struct reader *r, const yaml_node_t *node, struct equality *e);

#endif
