/*
 * Text with marked mathematics, $...$, and marked numbers, {...}: taken apart, and written out as plain text and as LaTeX.
 */
#ifndef CT_MARKED_H
#define CT_MARKED_H

#include <stdbool.h>

#include "formula/typeset.h"

/* What receives the parts, in turn: where they begin, and how long they are. NULL: such a part is refused. */
struct marked_parts {
    void *context;
    void (*words)(void *context, const char *at, size_t length);
    void (*mathematics)(void *context, const char *at, size_t length);
    void (*number)(void *context, const char *at, size_t length); /* without its braces */
};

/* False where a mark is not closed or not expected: *where is its offset, `why` what was expected. */
bool marked_read(const char *text, const struct marked_parts *parts, size_t *where, struct message *why);

/* One text in both forms. */
struct written {
    struct tex plain, latex;
};

void written_clear(struct written *w);
void write_words(void *written, const char *at, size_t length);
void write_mathematics(void *written, const char *at, size_t length);

/* A decimal, -1.3e-12 or 0.034, and its unit or NULL. */
void write_decimal(struct written *w, const char *decimal, const char *unit);

/* Text without numbers, whose marks have been read before. */
void write_marked(struct written *w, const char *text);

#endif
