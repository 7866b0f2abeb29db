#include "text/document.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

static bool load(yaml_parser_t *parser, yaml_document_t *document)
{
    const bool fine = yaml_parser_load(parser, document);
    if (!fine && parser->problem == NULL) /* everything but exhausted memory libyaml gives a name */
        out_of_memory();
    return fine;
}

/* What stands after the first document would go unread. */
static bool ends_here(yaml_parser_t *parser)
{
    yaml_document_t rest;
    if (!load(parser, &rest))
        return false;
    const bool ends = yaml_document_get_root_node(&rest) == NULL;
    yaml_document_delete(&rest);
    return ends;
}

bool document_open(struct document *d, const char *text, size_t length, const char *file,
                   struct message *why)
{
    yaml_parser_t parser;
    *d = (struct document){.file = file, .text = text, .why = why};
    if (!yaml_parser_initialize(&parser))
        out_of_memory();
    yaml_parser_set_input_string(&parser, (const unsigned char *)text, length);
    bool fine = load(&parser, &d->yaml);
    if (!fine) {
        message_set(why, "%s:%zu:%zu: expected YAML: %s", file, parser.problem_mark.line + 1,
                    parser.problem_mark.column + 1, parser.problem);
    } else if (document_root(d) == NULL) {
        message_set(why, "%s:1:1: expected a mapping, the file is empty", file);
        document_close(d);
        fine = false;
    } else if (!ends_here(&parser)) {
        message_set(why, "%s:%zu:1: expected one document, another follows", file, d->yaml.end_mark.line + 1);
        document_close(d);
        fine = false;
    }
    yaml_parser_delete(&parser);
    return fine;
}

void document_close(struct document *d)
{
    yaml_document_delete(&d->yaml);
}

static bool is_blank(char c)
{
    return c == ' ' || c == '\n' || c == '\t' || c == '\r';
}

/* Where a scalar's character at `offset` stands. One of several lines is folded: blanks differ there, and nothing else. */
static yaml_mark_t place_in_text(const struct document *d, const yaml_node_t *at, size_t offset)
{
    yaml_mark_t mark = at->start_mark;
    const char *value = scalar(at);
    const bool plain = value == NULL || at->data.scalar.style == YAML_PLAIN_SCALAR_STYLE;
    if (value == NULL || offset == 0 || mark.line == at->end_mark.line) {
        mark.column += offset + (!plain && offset > 0); /* the quotation mark */
        return mark;
    }
    size_t ahead = 0; /* characters that are no blanks */
    for (size_t i = 0; i < offset && value[i] != '\0'; i++)
        ahead += !is_blank(value[i]);
    bool header = !plain; /* the quotation mark, or > and - */
    for (const char *text = d->text + mark.index; *text != '\0'; text++) {
        header = header && strchr("\"'>|-+", *text) != NULL;
        if (!header && !is_blank(*text) && ahead-- == 0)
            break;
        mark.column = *text == '\n' ? 0 : mark.column + 1;
        mark.line += *text == '\n';
    }
    return mark;
}

bool parse_error(const struct document *d, const yaml_node_t *at, size_t offset, const char *format, ...)
{
    char text[384];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    const yaml_mark_t mark = place_in_text(d, at, offset);
    message_set(d->why, "%s:%zu:%zu: %s", d->file, mark.line + 1, mark.column + 1, text);
    return false;
}

const yaml_node_t *document_root(const struct document *d)
{
    return d->yaml.nodes.start < d->yaml.nodes.top ? d->yaml.nodes.start : NULL;
}

/* Nodes are known to each other by their number, from 1. */
static const yaml_node_t *node_by_number(const struct document *d, int index)
{
    return d->yaml.nodes.start + (index - 1);
}

const char *scalar(const yaml_node_t *node)
{
    return node->type == YAML_SCALAR_NODE ? (const char *)node->data.scalar.value : NULL;
}

static bool is_key(const struct document *d, const yaml_node_t *mapping, int i, const char *key)
{
    const char *text = scalar(key_of(d, mapping, i));
    return text != NULL && strcmp(text, key) == 0;
}

const yaml_node_t *child(const struct document *d, const yaml_node_t *mapping, const char *key)
{
    for (int i = 0; i < length_of(mapping); i++)
        if (is_key(d, mapping, i, key))
            return value_of(d, mapping, i);
    return NULL;
}

int length_of(const yaml_node_t *node)
{
    if (node->type == YAML_MAPPING_NODE)
        return (int)(node->data.mapping.pairs.top - node->data.mapping.pairs.start);
    return node->type == YAML_SEQUENCE_NODE ? (int)(node->data.sequence.items.top - node->data.sequence.items.start) : 0;
}

const yaml_node_t *key_of(const struct document *d, const yaml_node_t *mapping, int i)
{
    return node_by_number(d, mapping->data.mapping.pairs.start[i].key);
}

const yaml_node_t *value_of(const struct document *d, const yaml_node_t *mapping, int i)
{
    return node_by_number(d, mapping->data.mapping.pairs.start[i].value);
}

const yaml_node_t *item_of(const struct document *d, const yaml_node_t *list, int i)
{
    return node_by_number(d, list->data.sequence.items.start[i]);
}

static bool is_known(const struct document *d, const yaml_node_t *key, const char *text, const char *const *known)
{
    size_t k = 0;
    while (known[k] != NULL && strcmp(known[k], text) != 0)
        k++;
    if (known[k] != NULL)
        return true;
    const char *near = nearest_name(text, known, k);
    return parse_error(d, key, 0, "unknown key '%s', expected %s%s", text,
                       near ? "perhaps " : "one of this kind of entry", near ? near : "");
}

bool is_mapping(const struct document *d, const yaml_node_t *node, const char *const *known)
{
    if (node->type != YAML_MAPPING_NODE)
        return parse_error(d, node, 0, "expected a mapping, key: value");
    for (int i = 0; i < length_of(node); i++) {
        const yaml_node_t *key = key_of(d, node, i);
        const char *text = scalar(key);
        if (text == NULL)
            return parse_error(d, key, 0, "expected a plain key");
        for (int k = 0; k < i; k++)
            if (is_key(d, node, k, text))
                return parse_error(d, key, 0, "duplicate '%s', expected each key once", text);
        if (known != NULL && !is_known(d, key, text, known))
            return false;
    }
    return true;
}

bool is_list(const struct document *d, const yaml_node_t *node, int most)
{
    if (node->type != YAML_SEQUENCE_NODE)
        return parse_error(d, node, 0, "expected a list");
    for (int i = 0; i < length_of(node); i++)
        if (scalar(item_of(d, node, i)) == NULL || i == most)
            return parse_error(d, item_of(d, node, i), 0, "expected a list of at most %d texts", most);
    return true;
}
