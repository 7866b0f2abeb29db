/* derivations.yaml: principles, properties and steps. */
#include <stdlib.h>
#include <string.h>

#include "proof/derivation.h"

/* ---- principles and properties ---- */

struct written_definition {
    const char *text;
    const struct yaml *inputs, *let, *outputs;
};

static const struct field definition_fields[] = {
    FIELD("text", struct written_definition, text, FIELD_TEXT, .expected = "a text"),
    FIELD("inputs", struct written_definition, inputs, FIELD_LIST, .expected = "a list of names"),
    FIELD("let", struct written_definition, let, FIELD_MAP),
    FIELD("outputs", struct written_definition, outputs, FIELD_MAP, .expected = "{name: formula, ...}"),
    {.key = NULL}};

/* The names of the mapping's formulas, each appended to the program and named; their nodes, as far as wanted. */
static bool read_definition_formulas(const struct yaml *mapping, struct formulas *f, bool output)
{
    for (int i = 0; mapping != NULL && i < mapping->count; i++) {
        const struct yaml *formula = &mapping->items[i];
        if (!is_text(formula, "a formula"))
            return false;
        const int count = f->program.count;
        const int node = program_read(&f->program, formula, formula->text, 0, NULL, NULL);
        if (node < 0)
            return false;
        const int own = program_own(&f->program, count, node);
        program_name(&f->program, own, formula->key);
        if (output) {
            f->outputs[i] = own;
            f->text[i] = formula->text;
        }
    }
    return true;
}

static bool read_definition(struct derivations *d, const struct yaml *n)
{
    struct definitions *all = &d->definitions;
    struct written_definition w = {.text = NULL};
    struct section *s = &all->sections[all->count];
    struct quantity *q = all->outputs[all->count];
    if (!fields_read(n, definition_fields, &w) || !is_texts(w.inputs, MOST_INPUTS))
        return false;
    if (w.outputs->count == 0 || w.outputs->count > MOST_OUTPUTS)
        return node_error(w.outputs, 0, "expected from 1 to %d outputs", MOST_OUTPUTS);
    *s = (struct section){.sheet = d->sheet, .id = n->key, .title = w.text, .method = METHOD_FORMULA};
    all->count++;
    program_init(&s->corrected.program);
    for (int i = 0; i < w.inputs->count; i++)
        program_input(&s->corrected.program, w.inputs->items[i].text);
    for (; s->output_count < w.outputs->count; s->output_count++) {
        *q = (struct quantity){.name = w.outputs->items[s->output_count].key};
        s->outputs[s->output_count] = q++;
    }
    return read_definition_formulas(w.let, &s->corrected, false) && read_definition_formulas(w.outputs, &s->corrected, true);
}

/* ---- steps ---- */

static const struct field step_fields[] = {
    FIELD("title", struct step, title, FIELD_TEXT, .expected = "a text"),
    FIELD("from", struct step, from, FIELD_TEXTS, .most = MOST_EQUATIONS, .may_be_empty = true,
          .count = offsetof(struct step, from_count), .expected = "a list of equation numbers"),
    FIELD("to", struct step, to, FIELD_TEXTS, .most = MOST_EQUATIONS, .may_be_empty = true,
          .count = offsetof(struct step, to_count), .expected = "a list of equation numbers"),
    FIELD("lines", struct step, line_map, FIELD_MAP),
    {.key = "note"}, {.key = "printed"}, {.key = "remainders"}, {.key = "show"}, {.key = "let"}, IDENTITIES_FIELDS, {.key = NULL}};

/* Of what is printed instead. */
static const struct field variant_fields[] = {{.key = "let"}, {.key = "square roots"}, {.key = "show"}, {.key = NULL}};

/* Equations and properties; for `from`, principles too. */
static bool check_ends(const struct derivations *d, const struct yaml *list, bool to)
{
    struct entry_part parts[MOST_PARTS];
    for (int i = 0; i < list->count; i++) {
        const struct yaml *end = &list->items[i];
        for (int k = 0; k < i; k++)
            if (strcmp(list->items[k].text, end->text) == 0)
                return node_error(end, 0, "duplicate '%s', expected each once", end->text);
        bool known = entry_parts(d, end->text, parts) > 0;
        for (int k = 0; k < d->principle_count && to; k++)
            known = known && strcmp(d->definitions.sections[k].id, end->text) != 0;
        if (!known)
            return node_error(end, 0, "unknown '%s', expected an equation that has a formula, or a %s", end->text,
                              to ? "property" : "principle");
    }
    return true;
}

static bool read_identities(struct identities *t, const struct scope *s)
{
    const struct yaml *show = under(s->given, "show");
    if (!identities_open(t, s))
        return false;
    if (show == NULL)
        return node_error(s->given, 0, "missing show, expected a list of left = right");
    if (!is_texts(show, MOST_SHOWN))
        return false;
    return show->count > 0 ? identities_show(t, show) : node_error(show, 0, "expected at least one left = right");
}

/* A line says something, and something else than the equalities and lines before it. */
static bool check_line(const struct step *s, const struct equality *line)
{
    const char *sign = side_end(line->text, "="), *end = line->text + strlen(line->text);
    if (line->at->key[strspn(line->at->key, " ")] == '\0')
        return node_error(line->at, line->offset, "expected how it follows, and not a blank key");
    if (same_text(line->text, sign, sign + 1))
        return node_error(line->at, line->offset, "both sides read the same: the line says nothing");
    for (int i = 0; i < s->corrected.shown_count; i++)
        if (same_text(line->text, end, s->corrected.shown[i].text))
            return node_error(line->at, line->offset, "that is what the step shows, expected how");
    for (const struct equality *e = s->lines.shown; e < line; e++)
        if (same_text(line->text, end, e->text))
            return node_error(line->at, line->offset, "that is said already");
    return true;
}

/* The algebra by hand, in the names of the step. */
static bool read_lines(struct step *s, struct scope scope)
{
    if (s->line_map == NULL)
        return true;
    scope.shared = s->node;
    if (s->line_map->count == 0)
        return node_error(s->line_map, 0, "expected at least one line");
    bool fine = identities_open(&s->lines, &scope) && identities_show(&s->lines, s->line_map);
    for (int i = 0; fine && i < s->lines.shown_count; i++)
        fine = check_line(s, &s->lines.shown[i]);
    return fine;
}

static bool read_step(struct derivations *d, const struct yaml *n)
{
    const struct yaml *printed = under(n, "printed");
    struct step *s = APPENDED(d->steps, d->step_count);
    *s = (struct step){.id = n->key, .node = n, .differs = printed != NULL};
    struct scope scope = {.sheet = d->sheet, .definitions = &d->definitions, .given = n};
    if (!fields_read(n, step_fields, s) || !check_ends(d, under(n, "from"), false) || !check_ends(d, under(n, "to"), true) ||
        !read_identities(&s->corrected, &scope) || !step_read_remainders(d, s, &scope) ||
        !read_lines(s, scope))
        return false;
    scope.given = printed;
    scope.shared = n;
    return printed == NULL || (fields_read(printed, variant_fields, s) && read_identities(&s->printed, &scope));
}

struct written_derivations {
    const struct yaml *principles, *properties, *steps;
};

static const struct field derivations_fields[] = {
    FIELD("principles", struct written_derivations, principles, FIELD_MAP, .expected = "definitions"),
    FIELD("properties", struct written_derivations, properties, FIELD_MAP, .expected = "definitions"),
    FIELD("steps", struct written_derivations, steps, FIELD_MAP, .expected = "{id: {title: ..., from: ...}, ...}"),
    {.key = NULL}};

static bool read_derivations(struct derivations *d)
{
    struct written_derivations w = {.steps = NULL};
    if (!fields_read(&d->tree->root, derivations_fields, &w))
        return false;
    d->principle_count = w.principles->count;
    const int definitions = w.principles->count + w.properties->count;
    d->definitions.sections = xrealloc(NULL, (size_t)definitions + 1, sizeof *d->definitions.sections);
    d->definitions.outputs = xrealloc(NULL, (size_t)definitions + 1, sizeof *d->definitions.outputs);
    for (int i = 0; i < definitions; i++)
        if (!read_definition(d, i < w.principles->count ? &w.principles->items[i] : &w.properties->items[i - w.principles->count]))
            return false;
    for (int i = 0; i < w.steps->count; i++)
        if (!read_step(d, &w.steps->items[i]))
            return false;
    return true;
}

int derivations_read(struct derivations *d, const struct sheet *s, const char *text, size_t length,
                     const char *name, struct message *why)
{
    *d = (struct derivations){.sheet = s, .tree = tree_open(text, length, name, why)};
    if (d->tree != NULL && read_derivations(d))
        return 0;
    derivations_clear(d);
    return -1;
}

int derivations_open(struct derivations *d, const struct paper *paper, struct message *why)
{
    const struct source *s = &paper->derivations;
    if (derivations_read(d, &paper->sheet, s->text, s->length, s->name, why) != 0)
        return -1;
    if (step_named(d, "pitch_law") != NULL) /* its formulas are computed with */
        return 0;
    message_set(why, "%s: no derivation step 'pitch_law'", s->name);
    derivations_clear(d);
    return -1;
}

struct step *step_named(const struct derivations *d, const char *id)
{
    return NAMED(id, d->steps, d->step_count, struct step, id);
}

void derivations_clear(struct derivations *d)
{
    for (int i = 0; i < d->step_count; i++) {
        struct step *s = &d->steps[i];
        identities_clear(&s->corrected);
        identities_clear(&s->printed);
        identities_clear(&s->lines);
        proof_clear(&s->proof);
        proof_clear(&s->printed_proof);
        proof_clear(&s->line_proof);
        for (int k = 0; k < s->remainder_count; k++)
            remainder_clear(&s->remainders[k]);
        free(s->remainders);
    }
    for (int i = 0; i < d->definitions.count; i++)
        program_clear(&d->definitions.sections[i].corrected.program);
    free(d->definitions.outputs);
    free(d->definitions.sections);
    free(d->steps);
    tree_close(d->tree);
    *d = (struct derivations){0};
}
