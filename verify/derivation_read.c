/* derivations.yaml: what its steps declare, define and show, and what is known of them before a proof. */
#include <stdlib.h>
#include <string.h>

#include "degree.h"
#include "derivation_reader.h"

enum { MOST_NAMES = 64, MOST_SHOWN = 32, HIGHEST_ORDER = 9 };

/* ---- free quantities ---- */

/* The lists of a step that name free quantities, and what they say of them. */
static const struct declaration {
    const char *key;
    enum kind kind;
    int power; /* of epsilon */
} declarations[] = {{"free", KIND_ANY, 0},
                    {"positive", KIND_POSITIVE, 0},
                    {"angles", KIND_ANGLE, 0},
                    {"small", KIND_ANY, 1}};

enum { DECLARATIONS = sizeof declarations / sizeof *declarations };

static int find_input(const struct program *p, const char *name)
{
    for (int i = 0; i < p->inputs; i++)
        if (strcmp(p->names[i].text, name) == 0)
            return i;
    return -1;
}

/* Names beyond the sheet's become inputs; one that is `free` or an angle must not be declared before. */
static bool declare_names(struct reader *r, const struct declaration *declared)
{
    const yaml_node_t *names = child(r->document, r->step, declared->key);
    if (names == NULL)
        return true;
    if (!is_list(r->document, names, MOST_NAMES))
        return false;
    for (int i = 0; i < length_of(names); i++) {
        const yaml_node_t *name = item_of(r->document, names, i);
        const bool known = find_input(&r->trial->program, scalar(name)) >= 0;
        if (known && strcmp(declared->key, "free") == 0)
            return mistake(r->document, name, 0, "'%s' is known already, expected a new name", scalar(name));
        if (!known && declared->power > 0)
            return mistake(r->document, name, 0, "unknown symbol '%s', expected a free quantity", scalar(name));
        if (!known)
            program_input(&r->trial->program, scalar(name));
    }
    return true;
}

static bool qualify_names(struct reader *r, const struct declaration *declared)
{
    const yaml_node_t *names = child(r->document, r->step, declared->key);
    for (int i = 0; names != NULL && i < length_of(names); i++) {
        const yaml_node_t *name = item_of(r->document, names, i);
        struct variable *v = &r->trial->variables[find_input(&r->trial->program, scalar(name))];
        if (v->kind == KIND_ANGLE || v->power > 0)
            return mistake(r->document, name, 0, "'%s' is an angle or small already", scalar(name));
        v->power = declared->power;
        if (declared->kind != KIND_ANY)
            v->kind = declared->kind;
    }
    return true;
}

static bool read_declarations(struct reader *r)
{
    struct trial *t = r->trial;
    const struct sheet *s = r->sheet;
    for (int i = 0; i < s->quantity_count; i++)
        program_input(&t->program, s->quantities[i].name);
    for (int i = 0; i < DECLARATIONS; i++)
        if (!declare_names(r, &declarations[i]))
            return false;
    t->variables = memory(NULL, (size_t)t->program.inputs, sizeof *t->variables);
    for (int i = 0; i < t->program.inputs; i++) {
        bool positive = i < s->quantity_count && (s->quantities[i].domain == DOMAIN_POSITIVE ||
                                                  s->quantities[i].domain == DOMAIN_POSITIVE_OR_INFINITE);
        t->variables[i] = (struct variable){.kind = positive ? KIND_POSITIVE : KIND_ANY};
    }
    for (int i = 0; i < DECLARATIONS; i++)
        if (!qualify_names(r, &declarations[i]))
            return false;
    return true;
}

/* ---- definitions and equalities ---- */

/* What is printed differs in some definitions: by the same names, so that the order is the step's. */
static bool is_variant(struct reader *r, const yaml_node_t *let, const yaml_node_t *variant)
{
    if (!is_mapping(r->document, variant, NULL))
        return false;
    for (int i = 0; i < length_of(variant); i++) {
        const yaml_node_t *key = key_of(r->document, variant, i);
        if (let == NULL || child(r->document, let, scalar(key)) == NULL)
            return mistake(r->document, key, 0, "unknown name '%s', expected one of the step's let", scalar(key));
    }
    return true;
}

static bool read_let(struct reader *r)
{
    const yaml_node_t *let = child(r->document, r->step, "let");
    const yaml_node_t *variant = r->printed ? child(r->document, r->printed, "let") : NULL;
    if ((let != NULL && !is_mapping(r->document, let, NULL)) ||
        (variant != NULL && !is_variant(r, let, variant)))
        return false;
    for (int i = 0; let != NULL && i < length_of(let); i++) {
        const char *name = scalar(key_of(r->document, let, i));
        const yaml_node_t *other = variant ? child(r->document, variant, name) : NULL;
        int node = read_formula(r, other ? other : value_of(r->document, let, i));
        if (node < 0)
            return false;
        program_name(&r->trial->program, node, name);
    }
    return true;
}

static bool read_roots(struct reader *r)
{
    struct trial *t = r->trial;
    const yaml_node_t *roots = child(r->document, r->step, "roots");
    if (roots == NULL)
        return true;
    if (!is_list(r->document, roots, MOST_NAMES))
        return false;
    t->roots = memory(NULL, (size_t)length_of(roots), sizeof *t->roots);
    for (; t->root_count < length_of(roots); t->root_count++) {
        const yaml_node_t *item = item_of(r->document, roots, t->root_count);
        struct root *root = &t->roots[t->root_count];
        *root = (struct root){.text = scalar(item), .node = read_formula(r, item)};
        if (root->node < 0)
            return false;
    }
    return true;
}

static bool read_show(struct reader *r)
{
    struct trial *t = r->trial;
    const yaml_node_t *owner = r->printed ? r->printed : r->step, *show = child(r->document, owner, "show");
    if (show == NULL)
        return mistake(r->document, owner, 0, "missing show, expected a list of left = right");
    if (!is_list(r->document, show, MOST_SHOWN))
        return false;
    if (length_of(show) == 0)
        return mistake(r->document, show, 0, "expected at least one left = right");
    t->shown = memory(NULL, (size_t)length_of(show), sizeof *t->shown);
    for (; t->shown_count < length_of(show); t->shown_count++)
        if (!read_equality(r, item_of(r->document, show, t->shown_count), &t->shown[t->shown_count]))
            return false;
    return true;
}

/* Every name that moves, and what it moves by, is known in the end. */
static bool check_rates(struct reader *r)
{
    const yaml_node_t *rates = child(r->document, r->step, "rates");
    for (int i = 0; rates != NULL && i < length_of(rates); i++) {
        const yaml_node_t *pair[] = {key_of(r->document, rates, i), value_of(r->document, rates, i)};
        for (int k = 0; k < 2; k++)
            if (program_find(&r->trial->program, scalar(pair[k])) < 0)
                return mistake(r->document, pair[k], 0, "unknown symbol '%s', expected name: its rate",
                               scalar(pair[k]));
    }
    return true;
}

/* A name that is declared or defined and serves nothing is a slip. */
static bool all_needed(struct reader *r)
{
    const struct program *p = &r->trial->program;
    const char *needed = r->trial->needed;
    for (int i = 0; i < DECLARATIONS; i++) {
        const yaml_node_t *names = child(r->document, r->step, declarations[i].key);
        for (int k = 0; names != NULL && k < length_of(names); k++) {
            const yaml_node_t *name = item_of(r->document, names, k);
            if (!needed[find_input(p, scalar(name))])
                return mistake(r->document, name, 0, "nothing shown rests on '%s'", scalar(name));
        }
    }
    const yaml_node_t *let = child(r->document, r->step, "let");
    for (int k = 0, first = p->inputs; let != NULL && k < length_of(let); k++) {
        const int last = p->names[p->inputs + k].node; /* its formula: nodes first ... last, or an older one */
        bool serves = needed[last];
        for (; first <= last; first++) /* rate() may take up parts of it alone */
            serves = serves || needed[first];
        if (!serves)
            return mistake(r->document, key_of(r->document, let, k), 0, "nothing shown rests on '%s'",
                           p->names[p->inputs + k].text);
    }
    return true;
}

static bool check_roots(struct reader *r)
{
    const struct trial *t = r->trial;
    const yaml_node_t *roots = child(r->document, r->step, "roots");
    if (t->radical_count > 0 && t->root_count == 0)
        return mistake(r->document, r->step, 0, "missing roots: what the square roots are equal to");
    if (t->radical_count == 0 && t->root_count > 0 && !r->shared)
        return mistake(r->document, roots, 0, "expected no roots, nothing shown rests on a square root");
    for (int i = 0; i < t->root_count; i++)
        if (!t->roots[i].positive)
            return mistake(r->document, item_of(r->document, roots, i), 0,
                           "expected a root that is positive by its form: sums, products and quotients "
                           "of positive quantities");
    return true;
}

static bool read_trial(struct reader *r, struct trial *t, int order)
{
    r->trial = t;
    t->terms = order < 0 ? 1 : order + 1;
    if (!read_declarations(r) || !read_let(r) || !read_roots(r) || !read_show(r) || !check_rates(r))
        return false;
    trial_prepare(t);
    if (r->printed == NULL && ((!r->shared && !all_needed(r)) || !check_roots(r)))
        return false;
    if (t->degree >= DEGREE_LIMIT)
        return mistake(r->document, r->step, 0, "expected a simpler step, its degree is beyond 2^40");
    return true;
}

bool trial_read(struct trial *t, const struct sheet *sheet, struct document *document, const yaml_node_t *mapping)
{
    const yaml_node_t *order = child(document, mapping, "order");
    struct reader r = {.document = document, .sheet = sheet, .step = mapping, .shared = true};
    return read_trial(&r, t, order != NULL && scalar(order) != NULL ? atoi(scalar(order)) : -1);
}

/* ---- steps ---- */

static bool is_principle(const struct derivations *d, const char *id)
{
    for (int i = 0; i < d->principle_count; i++)
        if (strcmp(d->principles[i].id, id) == 0)
            return true;
    return false;
}

static bool is_equation(const struct sheet *sheet, const char *entry)
{
    for (int i = 0; i < sheet->section_count; i++)
        for (int k = 0; k < sheet->sections[i].numbers; k++)
            if (stands_for(entry, sheet->sections[i].equations[k]))
                return true;
    return false;
}

/* Equation numbers; for `from`, principles too. Their number, or -1 after a complaint. */
static int read_ends(struct derivations *d, const yaml_node_t *step, const char *key, const char **ends)
{
    struct document *document = &d->document;
    const yaml_node_t *list = child(document, step, key);
    const bool from = strcmp(key, "from") == 0;
    if (list == NULL) {
        mistake(document, step, 0, "missing %s, expected a list of equation numbers", key);
        return -1;
    }
    if (!is_list(document, list, MOST_EQUATIONS))
        return -1;
    for (int i = 0; i < length_of(list); i++) {
        const yaml_node_t *item = item_of(document, list, i);
        ends[i] = scalar(item);
        if (!is_equation(d->sheet, ends[i]) && !(from && is_principle(d, ends[i]))) {
            mistake(document, item, 0, "unknown '%s', expected an equation number%s", ends[i],
                    from ? " or a principle" : "");
            return -1;
        }
    }
    return length_of(list);
}

/* -1 where there is none; false after a complaint. It has to be there where quantities are small. */
static bool read_order(struct derivations *d, const yaml_node_t *step, int *order)
{
    const yaml_node_t *node = child(&d->document, step, "order");
    const bool small = child(&d->document, step, "small") != NULL;
    *order = -1;
    if (node == NULL && small)
        return mistake(&d->document, step, 0, "missing order: up to which power of the small quantities");
    if (node == NULL)
        return true;
    if (!small)
        return mistake(&d->document, node, 0, "expected no order where no quantities are small");
    if (scalar(node) == NULL || strlen(scalar(node)) != 1 || scalar(node)[0] < '0' ||
        scalar(node)[0] > '0' + HIGHEST_ORDER)
        return mistake(&d->document, node, 0, "expected an order from 0 to %d", HIGHEST_ORDER);
    *order = scalar(node)[0] - '0';
    return true;
}

static bool is_text(struct document *d, const yaml_node_t *mapping, const char *key, bool required,
                    const char **text)
{
    const yaml_node_t *node = child(d, mapping, key);
    *text = node != NULL ? scalar(node) : NULL;
    if (node == NULL ? required : *text == NULL || **text == '\0')
        return mistake(d, node ? node : mapping, 0, "missing %s, expected a text", key);
    return true;
}

static bool is_pairs(struct document *d, const yaml_node_t *mapping, const char *key)
{
    const yaml_node_t *node = child(d, mapping, key);
    if (node == NULL)
        return true;
    if (!is_mapping(d, node, NULL))
        return false;
    for (int i = 0; i < length_of(node); i++)
        if (scalar(value_of(d, node, i)) == NULL)
            return mistake(d, value_of(d, node, i), 0, "expected a text");
    return true;
}

static bool read_step(struct derivations *d, const yaml_node_t *key, const yaml_node_t *node)
{
    static const char *const known[] = {"title", "from",  "to",  "free", "positive", "angles",  "small", "rates",
                                        "roots", "order", "let", "show", "printed",  "note", NULL};
    static const char *const variant[] = {"let", "show", NULL};
    struct document *document = &d->document;
    d->steps = memory(d->steps, (size_t)d->step_count + 1, sizeof *d->steps);
    struct step *s = &d->steps[d->step_count++];
    *s = (struct step){.id = scalar(key)};
    if (!is_mapping(document, node, known) || !is_text(document, node, "title", true, &s->title) ||
        !is_text(document, node, "note", false, &s->note) || !is_pairs(document, node, "let") ||
        !is_pairs(document, node, "rates") || !read_order(d, node, &s->order) ||
        (s->from_count = read_ends(d, node, "from", s->from)) < 0 ||
        (s->to_count = read_ends(d, node, "to", s->to)) < 0)
        return false;
    s->let = child(document, node, "let");
    struct reader r = {.document = document, .sheet = d->sheet, .step = node};
    if (!read_trial(&r, &s->corrected, s->order))
        return false;
    r.printed = child(document, node, "printed");
    s->differs = r.printed != NULL;
    return !s->differs ||
           (is_mapping(document, r.printed, variant) && read_trial(&r, &s->printed, s->order));
}

static bool read_derivations(struct derivations *d)
{
    static const char *const known[] = {"principles", "steps", NULL};
    struct document *document = &d->document;
    const yaml_node_t *root = document_root(document);
    if (!is_mapping(document, root, known))
        return false;
    for (int i = 0; known[i] != NULL; i++)
        if (child(document, root, known[i]) == NULL)
            return mistake(document, root, 0, "missing %s", known[i]);
    const yaml_node_t *principles = child(document, root, "principles"), *steps = child(document, root, "steps");
    if (!is_pairs(document, root, "principles") || !is_mapping(document, steps, NULL))
        return false;
    d->principle_count = length_of(principles);
    d->principles = memory(NULL, (size_t)d->principle_count, sizeof *d->principles);
    for (int i = 0; i < d->principle_count; i++)
        d->principles[i] = (struct principle){scalar(key_of(document, principles, i)),
                                              scalar(value_of(document, principles, i))};
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

void trial_clear(struct trial *t)
{
    program_clear(&t->program);
    free(t->variables);
    free(t->shown);
    free(t->roots);
    free(t->radicals);
    free(t->needed);
}

void derivations_clear(struct derivations *d)
{
    for (int i = 0; i < d->step_count; i++) {
        trial_clear(&d->steps[i].corrected);
        trial_clear(&d->steps[i].printed);
    }
    free(d->steps);
    free(d->principles);
    document_close(&d->document);
    *d = (struct derivations){0};
}
