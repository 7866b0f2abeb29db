/* A YAML document, and one clear line about a mistake in it: "file:line:column: expected ...". */
#ifndef CT_DOCUMENT_H
#define CT_DOCUMENT_H

#include <stdbool.h>
#include <stddef.h>
#include <yaml.h>

#include "text/message.h"

struct document {
    yaml_document_t yaml;
    const char *file, *text; /* the text: as long as mistakes are told */
    struct message *why;
};

/* False where the text is no YAML or is empty: `why` says where, and there is nothing to close. */
bool document_open(struct document *d, const char *text, size_t length, const char *file,
                   struct message *why);
void document_close(struct document *d);

/* The mistake stands `offset` characters into a node (of which only a scalar's own are counted, folded as it is). False. */
#if defined(__GNUC__)
__attribute__((format(printf, 4, 5)))
#endif
bool parse_error(const struct document *d, const yaml_node_t *at, size_t offset, const char *format, ...);

const yaml_node_t *document_root(const struct document *d);

/* The text of a scalar, NULL of anything else. */
const char *scalar(const yaml_node_t *node);

/* The value of a key, NULL when it is not there. */
const yaml_node_t *child(const struct document *d, const yaml_node_t *mapping, const char *key);

/* The pairs of a mapping, the items of a list: their number, and each by its index. */
int length_of(const yaml_node_t *node);
const yaml_node_t *key_of(const struct document *d, const yaml_node_t *mapping, int i);
const yaml_node_t *value_of(const struct document *d, const yaml_node_t *mapping, int i);
const yaml_node_t *item_of(const struct document *d, const yaml_node_t *list, int i);

/* Scalar keys, no key twice and, where `known` is given (NULL ends it), no other key than those. */
bool is_mapping(const struct document *d, const yaml_node_t *node, const char *const *known);

/* Scalars alone, `most` at most. */
bool is_list(const struct document *d, const yaml_node_t *node, int most);

#endif
