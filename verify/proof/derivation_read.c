/* derivations.yaml: principles, properties and steps. */
#include <stdlib.h>
#include <string.h>

#include "proof/derivation.h"

/* ---- principles and properties ---- */

/* The names of the mapping's formulas, each appended to the program and named; their nodes, as far as wanted. */
static bool read_formulas(struct document *d, const yaml_node_t *mapping, struct formulas *f, bool output)
{
    for (int i = 0; mapping != NULL && i < length_of(mapping); i++) {
        const yaml_node_t *formula = value_of(d, mapping, i);
        struct message expected = {""};
        size_t where = 0;
        if (scalar(formula) == NULL)
            return parse_error(d, formula, 0, "expected a formula");
        const int count = f->program.count;
        int node = program_parse(&f->program, scalar(formula), &where, &expected);
        if (node < 0)
            return parse_error(d, formula, where, "%s", expected.text);
        node = program_own(&f->program, count, node); /* a name alone, too */
        program_name(&f->program, node, scalar(key_of(d, mapping, i)));
        if (output) {
            f->outputs[i] = node;
            f->text[i] = scalar(formula);
        }
    }
    return true;
}

static bool read_definition(struct derivations *d, const yaml_node_t *key, const yaml_node_t *node)
{
    static const char *const known[] = {"text", "inputs", "let", "outputs", NULL};
    struct document *document = &d->document;
    struct section *s = &d->definitions.sections[d->definitions.count];
    const int most_inputs = sizeof s->inputs / sizeof *s->inputs, most_outputs = sizeof s->outputs / sizeof *s->outputs;
    *s = (struct section){.sheet = d->sheet, .id = scalar(key), .method = METHOD_FORMULA};
    if (!is_mapping(document, node, known))
        return false;
    for (int i = 0; known[i] != NULL; i++)
        if (strcmp(known[i], "let") != 0 && child(document, node, known[i]) == NULL)
            return parse_error(document, node, 0, "missing %s, expected text, inputs and outputs", known[i]);
    const yaml_node_t *inputs = child(document, node, "inputs"), *let = child(document, node, "let");
    const yaml_node_t *outputs = child(document, node, "outputs");
    s->title = scalar(child(document, node, "text"));
    if (s->title == NULL)
        return parse_error(document, child(document, node, "text"), 0, "expected a text");
    if (!is_list(document, inputs, most_inputs) || (let != NULL && !is_mapping(document, let, NULL)) ||
        !is_mapping(document, outputs, NULL))
        return false;
    if (length_of(outputs) == 0 || length_of(outputs) > most_outputs)
        return parse_error(document, outputs, 0, "expected from 1 to %d outputs", most_outputs);
    d->definitions.count++;
    program_init(&s->corrected.program);
    for (int i = 0; i < length_of(inputs); i++)
        program_input(&s->corrected.program, scalar(item_of(document, inputs, i)));
    for (; s->output_count < length_of(outputs); s->output_count++) {
        struct definitions *all = &d->definitions;
        struct quantity *q = xrealloc(NULL, 1, sizeof *q);
        all->outputs = xrealloc(all->outputs, (size_t)all->output_count + 1, sizeof *all->outputs);
        all->outputs[all->output_count++] = q;
        *q = (struct quantity){.name = scalar(key_of(document, outputs, s->output_count))};
        s->outputs[s->output_count] = q;
    }
    return read_formulas(document, let, &s->corrected, false) && read_formulas(document, outputs, &s->corrected, true);
}

static bool read_definitions(struct derivations *d, const yaml_node_t *mapping)
{
    if (!is_mapping(&d->document, mapping, NULL))
        return false;
    d->definitions.sections = xrealloc(d->definitions.sections, (size_t)d->definitions.count + (size_t)length_of(mapping),
                                       sizeof *d->definitions.sections);
    for (int i = 0; i < length_of(mapping); i++)
        if (!read_definition(d, key_of(&d->document, mapping, i), value_of(&d->document, mapping, i)))
            return false;
    return true;
}

/* ---- steps ---- */

/* Equations and properties; for `from`, principles too. Their number, or -1 after a complaint. */
static int read_ends(struct derivations *d, const yaml_node_t *step, const char *key, const char **ends)
{
    struct document *document = &d->document;
    const yaml_node_t *list = child(document, step, key);
    struct entry_part parts[MOST_PARTS];
    if (list == NULL) {
        parse_error(document, step, 0, "missing %s, expected a list of equation numbers", key);
        return -1;
    }
    if (!is_list(document, list, MOST_EQUATIONS))
        return -1;
    for (int i = 0; i < length_of(list); i++) {
        const yaml_node_t *item = item_of(document, list, i);
        ends[i] = scalar(item);
        for (int k = 0; k < i; k++)
            if (strcmp(ends[k], ends[i]) == 0) {
                parse_error(document, item, 0, "duplicate '%s', expected each once", ends[i]);
                return -1;
            }
        bool known = entry_parts(d, ends[i], parts) > 0;
        for (int k = 0; k < d->principle_count && strcmp(key, "to") == 0; k++)
            known = known && strcmp(d->definitions.sections[k].id, ends[i]) != 0;
        if (!known) {
            parse_error(document, item, 0, "unknown '%s', expected an equation that has a formula, or a %s", ends[i],
                        strcmp(key, "to") == 0 ? "property" : "principle");
            return -1;
        }
    }
    return length_of(list);
}

static bool take_text(struct document *d, const yaml_node_t *mapping, const char *key, bool required,
                    const char **text)
{
    const yaml_node_t *node = child(d, mapping, key);
    *text = node != NULL ? scalar(node) : NULL;
    if (node == NULL ? required : *text == NULL || **text == '\0')
        return parse_error(d, node ? node : mapping, 0, "missing %s, expected a text", key);
    return true;
}

static struct scope step_scope(const struct derivations *d, const struct step *s)
{
    return (struct scope){.document = &d->document, .sheet = d->sheet,
                          .definitions = &d->definitions, .given = s->node};
}

static bool read_identities(struct identities *t, const struct scope *s)
{
    const yaml_node_t *owner = s->variant ? s->variant : s->given, *show = child(s->document, owner, "show");
    if (!identities_open(t, s))
        return false;
    if (show == NULL)
        return parse_error(s->document, owner, 0, "missing show, expected a list of left = right");
    if (!is_list(s->document, show, MOST_SHOWN))
        return false;
    if (length_of(show) == 0)
        return parse_error(s->document, show, 0, "expected at least one left = right");
    for (int i = 0; i < length_of(show); i++)
        if (!identities_show(t, s, item_of(s->document, show, i)))
            return false;
    return identities_close(t, s);
}

static bool read_step(struct derivations *d, const yaml_node_t *key, const yaml_node_t *node)
{
    static const char *const own[] = {"title", "from", "to", "also", "printed", "remainders", "note", "where", NULL};
    static const char *const variant[] = {"let", "square roots", "show", NULL};
    const char *known[32] = {NULL};
    struct document *document = &d->document;
    for (int i = 0, count = 0; i < 2; i++)
        for (const char *const *key = i == 0 ? own : identities_keys; *key != NULL; key++)
            known[count++] = *key;
    d->steps = xrealloc(d->steps, (size_t)d->step_count + 1, sizeof *d->steps);
    struct step *s = &d->steps[d->step_count++];
    *s = (struct step){.id = scalar(key), .node = node};
    const yaml_node_t *also = node->type == YAML_MAPPING_NODE ? child(document, node, "also") : NULL;
    if (!is_mapping(document, node, known) || !take_text(document, node, "title", true, &s->title) ||
        !take_text(document, node, "note", false, &s->note) || !take_text(document, node, "where", false, &s->where) ||
        (also != NULL && !is_mapping(document, also, NULL)) ||
        (s->from_count = read_ends(d, node, "from", s->from)) < 0 ||
        (s->to_count = read_ends(d, node, "to", s->to)) < 0)
        return false;
    s->let = child(document, node, "let");
    struct scope scope = step_scope(d, s);
    if (!read_identities(&s->corrected, &scope) || !step_read_remainders(d, s, &scope))
        return false;
    scope.variant = child(document, node, "printed");
    s->differs = scope.variant != NULL;
    return !s->differs || (is_mapping(document, scope.variant, variant) && read_identities(&s->printed, &scope));
}

static bool read_derivations(struct derivations *d)
{
    static const char *const known[] = {"principles", "properties", "steps", NULL};
    struct document *document = &d->document;
    const yaml_node_t *root = document_root(document);
    if (!is_mapping(document, root, known))
        return false;
    for (int i = 0; known[i] != NULL; i++)
        if (child(document, root, known[i]) == NULL)
            return parse_error(document, root, 0, "missing %s", known[i]);
    if (!read_definitions(d, child(document, root, "principles")))
        return false;
    d->principle_count = d->definitions.count;
    const yaml_node_t *steps = child(document, root, "steps");
    if (!read_definitions(d, child(document, root, "properties")) || !is_mapping(document, steps, NULL))
        return false;
    for (int i = 0; i < length_of(steps); i++)
        if (!read_step(d, key_of(document, steps, i), value_of(document, steps, i)))
            return false;
    return true;
}

int derivations_read(struct derivations *d, const struct sheet *s, const char *text, size_t length,
                     const char *name, struct message *why)
{
    *d = (struct derivations){.sheet = s};
    if (!document_open(&d->document, text, length, name, why))
        return -1;
    if (read_derivations(d))
        return 0;
    derivations_clear(d);
    return -1;
}

void derivations_clear(struct derivations *d)
{
    for (int i = 0; i < d->step_count; i++) {
        identities_clear(&d->steps[i].corrected);
        identities_clear(&d->steps[i].printed);
        for (int k = 0; k < d->steps[i].remainder_count; k++)
            remainder_clear(&d->steps[i].remainders[k]);
        free(d->steps[i].remainders);
    }
    for (int i = 0; i < d->definitions.count; i++)
        program_clear(&d->definitions.sections[i].corrected.program);
    for (int i = 0; i < d->definitions.output_count; i++)
        free(d->definitions.outputs[i]);
    free(d->definitions.outputs);
    free(d->definitions.sections);
    free(d->steps);
    document_close(&d->document);
    *d = (struct derivations){0};
}
