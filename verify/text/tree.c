#include "text/tree.h"

#include <math.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { DEEPEST = 32 };

/* ---- mistakes ---- */

static bool is_white(char c)
{
    return c == ' ' || c == '\n' || c == '\t' || c == '\r';
}

/* Where a scalar's character at `offset` stands. One of several lines is folded: blanks differ there, and nothing else. */
static yaml_mark_t place_in_text(const struct yaml *n, size_t offset)
{
    yaml_mark_t place = n->node->start_mark;
    if (n->text == NULL || offset == 0)
        return place;
    bool header = n->node->data.scalar.style != YAML_PLAIN_SCALAR_STYLE; /* the quotation mark, or > and - */
    if (place.line == n->node->end_mark.line) {
        place.column += offset + header;
        return place;
    }
    size_t ahead = 0; /* characters that are no blanks */
    for (size_t i = 0; i < offset && n->text[i] != '\0'; i++)
        ahead += !is_white(n->text[i]);
    for (const char *c = n->tree->source + place.index; c < n->tree->source_end; c++) {
        header = header && strchr("\"'>|-+", *c) != NULL;
        if (!header && !is_white(*c) && ahead-- == 0)
            break;
        place.column = *c == '\n' ? 0 : place.column + 1;
        place.line += *c == '\n';
    }
    return place;
}

bool node_message(struct message *m, const struct yaml *at, size_t offset, const char *format, ...)
{
    char text[384];
    va_list arguments;
    const yaml_mark_t place = offset == AT_KEY ? at->key_node->start_mark : place_in_text(at, offset);
    va_start(arguments, format);
    vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    message_set(m, "%s:%zu:%zu: %s", at->tree->file, place.line + 1, place.column + 1, text);
    return false;
}

/* ---- reading ---- */

/* The node of that number; an alias has that of a node which was met before. */
static bool document_node(struct yaml *n, int number, const yaml_node_t **node)
{
    *node = yaml_document_get_node(&n->tree->document, number);
    return number == ++n->tree->met;
}

static bool load_key(const struct yaml *mapping, struct yaml *item, int number)
{
    if (!document_node(item, number, &item->key_node))
        return node_error(item, AT_KEY, "expected no alias of this");
    if (item->key_node->type != YAML_SCALAR_NODE)
        return node_error(item, AT_KEY, "expected a plain key");
    const char *key = (const char *)item->key_node->data.scalar.value;
    if (under(mapping, key) != NULL)
        return node_error(item, AT_KEY, "duplicate '%s', expected each key once", key);
    item->key = key;
    return true;
}

static bool load_node(struct yaml *n, int number, int depth)
{
    if (!document_node(n, number, &n->node))
        return node_error(n, 0, "expected no alias of this");
    const yaml_node_t *node = n->node;
    if (node->type == YAML_SCALAR_NODE) {
        n->text = (const char *)node->data.scalar.value;
        return true;
    }
    if (depth == DEEPEST)
        return node_error(n, 0, "expected less in each other");
    n->mapping = node->type == YAML_MAPPING_NODE;
    const yaml_node_pair_t *pairs = node->data.mapping.pairs.start;
    const ptrdiff_t count = n->mapping ? node->data.mapping.pairs.top - pairs
                                       : node->data.sequence.items.top - node->data.sequence.items.start;
    bool fine = true;
    for (ptrdiff_t i = 0; i < count && fine; i++) {
        struct yaml item = {.tree = n->tree};
        fine = (!n->mapping || load_key(n, &item, pairs[i].key)) &&
               load_node(&item, n->mapping ? pairs[i].value : node->data.sequence.items.start[i], depth + 1);
        *APPENDED(n->items, n->count) = item;
    }
    return fine;
}

/* The next document, or one without nodes: there is none. False where it is no YAML, and `why` says where. */
static bool next_document(const struct tree *tree, yaml_parser_t *parser, yaml_document_t *document)
{
    if (yaml_parser_load(parser, document))
        return true;
    if (parser->problem == NULL) /* everything but exhausted memory libyaml gives a name */
        out_of_memory();
    const yaml_mark_t at = parser->problem_mark;
    message_set(tree->why, "%s:%zu:%zu: expected YAML: %s", tree->file, at.line + 1, at.column + 1, parser->problem);
    return false;
}

/* One document and nothing after it. */
static bool load_document(struct tree *tree, yaml_parser_t *parser)
{
    yaml_document_t next;
    if (!next_document(tree, parser, &tree->document))
        return false;
    if (yaml_document_get_root_node(&tree->document) == NULL) {
        message_set(tree->why, "%s:1:1: expected a mapping, the file is empty", tree->file);
        return false;
    }
    const bool alone = next_document(tree, parser, &next) && yaml_document_get_root_node(&next) == NULL;
    yaml_document_delete(&next);
    if (!alone)
        message_set(tree->why, "%s:%zu:1: expected one document, another follows", tree->file, tree->document.end_mark.line + 1);
    return alone;
}

struct tree *tree_open(const char *text, size_t length, const char *file, struct message *why)
{
    struct tree *tree = xrealloc(NULL, 1, sizeof *tree);
    yaml_parser_t parser;
    *tree = (struct tree){.file = file, .source = text, .source_end = text + length, .why = why, .root.tree = tree};
    if (!yaml_parser_initialize(&parser))
        out_of_memory();
    yaml_parser_set_input_string(&parser, (const unsigned char *)text, length);
    const bool fine = load_document(tree, &parser) && load_node(&tree->root, 1, 0);
    yaml_parser_delete(&parser);
    if (fine)
        return tree;
    tree_close(tree);
    return NULL;
}

static void clear_node(struct yaml *n)
{
    for (int i = 0; i < n->count; i++)
        clear_node(&n->items[i]);
    free(n->items);
}

void tree_close(struct tree *tree)
{
    if (tree == NULL)
        return;
    clear_node(&tree->root);
    yaml_document_delete(&tree->document);
    free(tree);
}

/* ---- what is expected of a node ---- */

const struct yaml *under(const struct yaml *mapping, const char *key)
{
    for (int i = 0; mapping != NULL && mapping->mapping && i < mapping->count; i++)
        if (strcmp(mapping->items[i].key, key) == 0)
            return &mapping->items[i];
    return NULL;
}

bool is_map(const struct yaml *n)
{
    return n->mapping || node_error(n, 0, "expected a mapping, key: value");
}

bool is_text(const struct yaml *n, const char *expected)
{
    return n->text != NULL || node_error(n, 0, "expected %s", expected);
}

static bool is_sequence(const struct yaml *n)
{
    return (n->text == NULL && !n->mapping) || node_error(n, 0, "expected a list");
}

bool is_texts(const struct yaml *n, int most)
{
    for (int i = 0; is_sequence(n) && i < n->count; i++)
        if (n->items[i].text == NULL || i == most)
            return node_error(&n->items[i], 0, "expected a list of at most %d texts", most);
    return is_sequence(n);
}

bool is_positive_number(const struct yaml *n, double *value)
{
    char *end = NULL;
    *value = n->text != NULL ? strtod(n->text, &end) : 0.0;
    return (n->text != NULL && end != n->text && *end == '\0' && *value > 0.0 && !isinf(*value)) ||
           node_error(n, 0, "expected a positive number, finite in binary64");
}

/* ---- fields ---- */

static bool read_word(const struct yaml *n, const struct field *f, int *word)
{
    char list[256] = "";
    size_t length = 0;
    for (int i = 0; f->words[i] != NULL; i++) {
        if (n->text != NULL && strcmp(n->text, f->words[i]) == 0) {
            *word = i;
            return true;
        }
        const char *before = i == 0 ? "" : f->words[i + 1] == NULL ? " or " : ", ";
        length += (size_t)snprintf(list + length, sizeof list - length, "%s%s", before, f->words[i]);
    }
    return node_error(n, 0, "expected a %s: %s", f->key, list);
}

static bool read_field(const struct yaml *n, const struct field *f, char *into)
{
    void *at = into + f->offset;
    switch (f->kind) {
    case FIELD_ANY:
        return true;
    case FIELD_TEXT:
        *(const char **)at = n->text;
        return (n->text != NULL && n->text[0] != '\0') || node_error(n, 0, "missing %s, expected a text", f->key);
    case FIELD_TEXTS:
        for (int i = 0; i < n->count && is_texts(n, f->most); i++)
            ((const char **)at)[i] = n->items[i].text;
        *(int *)(into + f->count) = n->count;
        return is_texts(n, f->most) && (n->count > 0 || f->expected == NULL || f->may_be_empty ||
                                        node_error(n, 0, "expected at least one of %s", f->expected));
    case FIELD_WORD:
        return read_word(n, f, at);
    default:
        *(const struct yaml **)at = n;
        return f->kind == FIELD_MAP ? is_map(n) : f->kind == FIELD_LIST ? is_sequence(n) : true;
    }
}

static const struct field *find_field(const struct yaml *item, const struct field *fields)
{
    size_t count = 0;
    for (; fields[count].key != NULL; count++)
        if (strcmp(fields[count].key, item->key) == 0)
            return &fields[count];
    const char *near = NEAREST(item->key, fields, count, key);
    node_error(item, AT_KEY, "unknown key '%s', expected %s%s", item->key, near ? "perhaps " : "one of this kind of entry",
               near ? near : "");
    return NULL;
}

bool fields_read(const struct yaml *mapping, const struct field *fields, void *into)
{
    if (!is_map(mapping))
        return false;
    for (int i = 0; i < mapping->count; i++)
        if (find_field(&mapping->items[i], fields) == NULL)
            return false;
    for (const struct field *f = fields; f->key != NULL; f++)
        if (f->expected != NULL && under(mapping, f->key) == NULL)
            return node_error(mapping, 0, "missing %s, expected %s", f->key, f->expected);
    for (int i = 0; i < mapping->count; i++)
        if (!read_field(&mapping->items[i], find_field(&mapping->items[i], fields), into))
            return false;
    return true;
}
