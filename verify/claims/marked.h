/*
 * Text with marked mathematics, $...$, and marked numbers, {...}: taken apart, and written out plainly, and with its mathematics as LaTeX.
 */
#ifndef CT_MARKED_H
#define CT_MARKED_H

#include <stdbool.h>

#include "formula/typeset.h"

enum part_kind { PART_END, PART_WORDS, PART_MATHEMATICS, PART_NUMBER, PART_WRONG };

struct marked_part {
    enum part_kind kind;
    const char *at, *expected; /* where it begins, without its mark; expected: of what is wrong */
    size_t length;
};

/* The part that begins at *text, which goes on behind it. */
struct marked_part marked_next(const char **text);

/* One text in both forms. */
struct written {
    struct tex plain, latex;
};

void written_clear(struct written *w);
void write_part(struct written *w, const struct marked_part *part);

/* A decimal, -1.3e-12 or 0.034, and its unit or NULL. */
void write_decimal(struct written *w, const char *decimal, const char *unit);

/* Text without numbers; what has no marks in mind, as a title, from there on as it stands. */
void write_marked(struct written *w, const char *text);

#endif
