/*
 * What the prover reads of an assertion: {show: [equality]}, with as much of the statement's `given` as the equality needs.
 *
 * These mappings are added to the document before anything is read of it: as it grows its nodes move, and are known by
 * their numbers alone.
 */
#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "statement_reader.h"

bool mentions(const char *text, const char *word)
{
    const size_t length = strlen(word);
    for (const char *at = text; (at = strstr(at, word)) != NULL; at++) {
        const bool begins = at == text || !(isalnum((unsigned char)at[-1]) || strchr("_.", at[-1]) != NULL);
        if (begins && !isalnum((unsigned char)at[length]) && at[length] != '_')
            return true;
    }
    return false;
}

/* The names that a section's output or subexpression takes its inputs from: they are in scope, though nothing writes them. */
static void add_inputs(struct tex *all, const struct section *s, const char *name)
{
    const struct program *p = &s->corrected.program;
    int node = program_find(p, name);
    for (int i = 0; i < s->output_count; i++)
        if (strcmp(s->outputs[i]->name, name) == 0)
            node = s->corrected.outputs[i];
    char *needed = memory(NULL, (size_t)(node < 0 ? 1 : node + 1), 1);
    if (node >= 0)
        program_needs(p, node, NULL, needed);
    for (int i = 0; i <= node; i++)
        if (needed[i] && i < p->inputs)
            tex_add(all, " %s", p->names[i].text);
        else if (needed[i] && p->nodes[i].op == OPERATOR_SQRT)
            tex_add(all, " sqrt(");
    free(needed);
}

/* The same for every eq05.x1 in a text. */
static void add_implied(struct tex *all, const char *text)
{
    char id[16], name[32];
    for (const char *at = text; (at = strstr(at, "eq")) != NULL; at += 2) {
        const bool begins = at == text || !(isalnum((unsigned char)at[-1]) || strchr("_.", at[-1]) != NULL);
        if (begins && sscanf(at, "%15[a-z0-9].%31[A-Za-z0-9_]", id, name) == 2 && section_find(sheet(), id) != NULL)
            add_inputs(all, section_find(sheet(), id), name);
    }
}

char *with_abbreviations(const struct document *d, const yaml_node_t *let, const char *text, bool needed[MOST_ABBREVIATIONS])
{
    struct tex all = {NULL, 0};
    tex_add(&all, "%s", text);
    add_implied(&all, text);
    for (int i = let == NULL ? 0 : length_of(let); i-- > 0;) {
        const char *name = scalar(key_of(d, let, i)), *formula = scalar(value_of(d, let, i));
        needed[i] = i < MOST_ABBREVIATIONS && name != NULL && formula != NULL && mentions(all.text, name);
        if (needed[i]) {
            tex_add(&all, " %s", formula);
            add_implied(&all, formula);
        }
    }
    return all.text;
}

static yaml_node_t *node_of(const struct document *d, int id)
{
    return d->yaml.nodes.start + id - 1; /* as libyaml numbers them */
}

static int id_of(const struct document *d, const yaml_node_t *node)
{
    return node == NULL ? 0 : (int)(node - d->yaml.nodes.start) + 1;
}

static int checked(int id)
{
    if (id == 0)
        out_of_memory();
    return id;
}

static void add_pair(struct document *d, int mapping, const char *key, int value)
{
    const yaml_char_t *text = (const yaml_char_t *)key;
    const int id = checked(yaml_document_add_scalar(&d->yaml, NULL, text, (int)strlen(key), YAML_PLAIN_SCALAR_STYLE));
    checked(yaml_document_append_mapping_pair(&d->yaml, mapping, id, value));
}

/* An entry of `prove`, by numbers: its own mapping or 0, the statement's `given` or 0. */
struct entry {
    struct document *document;
    int own, given, mapping;
};

static int context_of(const struct entry *e, const char *key)
{
    const yaml_node_t *found = e->own != 0 ? child(e->document, node_of(e->document, e->own), key) : NULL;
    if (found == NULL && e->given != 0)
        found = child(e->document, node_of(e->document, e->given), key);
    return id_of(e->document, found);
}

/* Those pairs of a mapping that are needed. */
static void add_pairs(const struct entry *e, const char *key, int let, const bool *needed)
{
    struct document *d = e->document;
    int list = 0;
    for (int i = 0; let != 0 && i < length_of(node_of(d, let)); i++) {
        const yaml_node_pair_t pair = node_of(d, let)->data.mapping.pairs.start[i];
        if (!needed[i])
            continue;
        if (list == 0) {
            list = checked(yaml_document_add_mapping(&d->yaml, NULL, YAML_FLOW_MAPPING_STYLE));
            add_pair(d, e->mapping, key, list);
        }
        checked(yaml_document_append_mapping_pair(&d->yaml, list, pair.key, pair.value));
    }
}

/* The rates of what the text has, in the document: `moves` tells which. The text, and the names of these rates. */
static char *with_rates(const struct entry *e, int rates, const char *text, bool moves[MOST_ABBREVIATIONS])
{
    const struct document *d = e->document;
    struct tex all = {NULL, 0};
    tex_add(&all, "%s", text);
    for (int i = 0; rates != 0 && strstr(text, "rate(") != NULL && i < length_of(node_of(d, rates)) && i < MOST_ABBREVIATIONS; i++) {
        const char *name = scalar(key_of(d, node_of(d, rates), i)), *rate = scalar(value_of(d, node_of(d, rates), i));
        moves[i] = name != NULL && rate != NULL && mentions(text, name);
        if (moves[i])
            tex_add(&all, " %s", rate);
    }
    return all.text;
}

/* The mapping for the equality with that number, its text being given. */
static int add_identity(struct entry *e, int equality)
{
    static const char *const lists[] = {"free", "angles", "positive", "small", "order"};
    struct document *d = e->document;
    bool needed[MOST_ABBREVIATIONS] = {false}, moves[MOST_ABBREVIATIONS] = {false};
    const int let = context_of(e, "let"), rates = context_of(e, "rates"), roots = context_of(e, "square roots");
    const yaml_mark_t begin = node_of(d, equality)->start_mark, end = node_of(d, equality)->end_mark;
    const yaml_node_t *abbreviations = let != 0 ? node_of(d, let) : NULL;
    char *all = with_abbreviations(d, abbreviations, scalar(node_of(d, equality)), needed);
    for (int before = -1, moving = 0; moving > before;) { /* a rate may bring in what moves, too */
        char *text = with_rates(e, rates, all, moves);
        free(all);
        all = with_abbreviations(d, abbreviations, text, needed);
        free(text);
        before = moving;
        moving = 0;
        for (int i = 0; i < MOST_ABBREVIATIONS; i++)
            moving += moves[i];
    }
    e->mapping = checked(yaml_document_add_mapping(&d->yaml, NULL, YAML_FLOW_MAPPING_STYLE));
    const int show = checked(yaml_document_add_sequence(&d->yaml, NULL, YAML_FLOW_SEQUENCE_STYLE));
    checked(yaml_document_append_sequence_item(&d->yaml, show, equality));
    node_of(d, e->mapping)->start_mark = begin;
    node_of(d, e->mapping)->end_mark = end;
    for (size_t k = 0; k < sizeof lists / sizeof *lists; k++)
        if (context_of(e, lists[k]) != 0)
            add_pair(d, e->mapping, lists[k], context_of(e, lists[k]));
    const bool own_let = e->own != 0 && child(d, node_of(d, e->own), "let") != NULL; /* left(24, 2) mentions none of its names */
    for (int i = 0; own_let && i < length_of(node_of(d, let)) && i < MOST_ABBREVIATIONS; i++)
        needed[i] = true;
    add_pairs(e, "let", let, needed);
    add_pairs(e, "rates", rates, moves);
    if (roots != 0)
        add_pair(d, e->mapping, "roots", roots);
    add_pair(d, e->mapping, "show", show);
    free(all);
    return e->mapping;
}

/* The number of the equality that an entry asserts for all values; 0: another assertion. */
static int equality_of(const struct document *d, const yaml_node_t *entry)
{
    enum ordering ordering = IS_EQUAL;
    size_t length;
    const bool mapping = entry->type == YAML_MAPPING_NODE;
    const yaml_node_t *show = mapping ? child(d, entry, "show") : entry;
    if (show == NULL || scalar(show) == NULL || find_ordering(scalar(show), &ordering, &length) == NULL || ordering != IS_EQUAL ||
        (mapping && (child(d, entry, "at") != NULL || child(d, entry, "for") != NULL)))
        return 0;
    return id_of(d, show);
}

int *identities_add(struct document *d)
{
    const int old = (int)(d->yaml.nodes.top - d->yaml.nodes.start), claims = length_of(document_root(d));
    int *identities = memory(NULL, (size_t)old + 1, sizeof *identities);
    memset(identities, 0, ((size_t)old + 1) * sizeof *identities);
    for (int i = 0; i < claims; i++) {
        const yaml_node_t *claim = value_of(d, document_root(d), i);
        const int prove = claim->type == YAML_MAPPING_NODE ? id_of(d, child(d, claim, "prove")) : 0;
        const int given = prove != 0 ? id_of(d, child(d, claim, "given")) : 0;
        for (int k = 0; prove != 0 && k < length_of(node_of(d, prove)) && node_of(d, prove)->type == YAML_MAPPING_NODE; k++) {
            const yaml_node_t *entry = value_of(d, node_of(d, prove), k);
            const int own = id_of(d, entry), equality = equality_of(d, entry);
            struct entry e = {.document = d, .own = equality != own ? own : 0, .given = given};
            if (given != 0 && node_of(d, given)->type != YAML_MAPPING_NODE)
                e.given = 0;
            if (equality != 0)
                identities[own] = add_identity(&e, equality);
        }
    }
    return identities;
}
