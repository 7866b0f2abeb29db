/* A YAML text as a tree, and one clear line about a mistake in it: "file:line:column: expected ...". */
#ifndef CT_TREE_H
#define CT_TREE_H

#include <stdbool.h>
#include <stddef.h>
#include <yaml.h>

#include "text/message.h"

/* A scalar, a list or a mapping. Aliases are refused, and so are keys that are no scalars, or stand twice. */
struct yaml {
    const char *key;     /* under which it stands in a mapping; NULL: in a list, or nowhere */
    const char *text;    /* of a scalar; NULL of anything else                              */
    struct yaml *items;
    int count;
    bool mapping;
    const yaml_node_t *node, *key_node; /* where both stand in the document */
    struct tree *tree;
};

struct tree {
    const char *file, *source, *source_end; /* the source is needed as long as mistakes are told */
    struct message *why;
    yaml_document_t document;
    int met; /* of its nodes, which are numbered in their order */
    struct yaml root;
};

/* NULL where the text is no YAML, or empty; `why` says where. */
struct tree *tree_open(const char *text, size_t length, const char *file, struct message *why);
void tree_close(struct tree *tree);

/* What stands under a key, NULL: nothing (nor in what is no mapping, or NULL). */
const struct yaml *under(const struct yaml *mapping, const char *key);

/* The mistake stands `offset` characters into a node (of which only a scalar's own are counted, folded as it is). False. */
#define AT_KEY ((size_t)-1) /* ... or at its key */
#if defined(__GNUC__)
__attribute__((format(printf, 4, 5)))
#endif
bool node_message(struct message *m, const struct yaml *at, size_t offset, const char *format, ...);

/* The same as the tree's own message. */
#define node_error(at, ...) node_message((at)->tree->why, at, __VA_ARGS__)

bool is_map(const struct yaml *n);
bool is_text(const struct yaml *n, const char *expected);

/* Texts alone, `most` at most. */
bool is_texts(const struct yaml *n, int most);

/* A number above zero, finite in binary64. */
bool is_positive_number(const struct yaml *n, double *value);

/* ---- mappings whose keys are known ---- */

enum field_kind {
    FIELD_ANY,     /* known, and read elsewhere                  */
    FIELD_NODE,    /* const struct yaml *: whatever stands there */
    FIELD_MAP,     /* ... a mapping                              */
    FIELD_LIST,    /* ... a list                                 */
    FIELD_TEXT,    /* const char *                               */
    FIELD_TEXTS,   /* const char *[most], an int counts them     */
    FIELD_WORD     /* int: which of `words`                      */
};

/* What a key fills in a struct. A table of them ends with one without key. */
struct field {
    const char *key;
    size_t offset;
    enum field_kind kind;
    const char *expected;     /* where it is missing; NULL: it may be missing */
    const char *const *words; /* NULL ends them                               */
    int most;
    bool may_be_empty;        /* of a list that has to be there               */
    size_t count;             /* the offset of the count                      */
};

/* FIELD("title", struct section, title, FIELD_TEXT, .expected = "a text") */
#define FIELD(key_, type, member, ...) {.key = (key_), .offset = offsetof(type, member), .kind = __VA_ARGS__}

/* No other keys, no missing ones, each of its kind. What is not there stays as it was. */
bool fields_read(const struct yaml *mapping, const struct field *fields, void *into);

#endif
