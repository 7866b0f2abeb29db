/*
 * Reading identities: what is free, what is defined, and formulas that beside the names in scope may say
 *
 *     eq10.x1                   an output of a section of the sheet or of a principle, or a named subexpression of it;
 *                               inputs are bound by name to what is in scope, and a free name of one's own takes the
 *                               place of a named subexpression of that name
 *     eq40.psi_ddot(psi = 1)    ... with other values for some of them
 *     eq30.I_22@printed         ... as the paper has it
 *     left(6a), right(24, 2)    a side of a relation of the sheet: of (6a), of the second that (24) has
 *     rate(x1)                  the derivative by time: what `rates` names moves
 */
#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "proof/identities.h"

enum { MOST_FURTHER_NAMES = 64, MOST_RATES = 10000 };

static const struct yaml *scope_given(const struct scope *s, const char *key)
{
    const struct yaml *own = under(s->given, key);
    return own != NULL ? own : under(s->shared, key);
}

/* ---- free quantities ---- */

/* The lists that name free quantities, and what they say of them. */
static const struct {
    const char *key;
    struct variable as;
} declarations[] = {{"free", {.signs = SIGN_ANY}},
                    {"positive", {.signs = SIGN_POSITIVE}},
                    {"angles", {.signs = SIGN_ANY, .angle = true}},
                    {"quarter turns", {.signs = SIGN_ANY, .angle = true, .quarter_turn = true}},
                    {"small", {.signs = SIGN_ANY, .power = 1}}};

enum { DECLARATIONS = sizeof declarations / sizeof *declarations };

bool is_free_name(const struct identities *t, const char *name)
{
    const int node = program_find(&t->program, name);
    return node >= t->sheet_inputs && node < t->program.inputs;
}

static int add_variable(struct identities *t, const char *name, int signs)
{
    const int input = program_input(&t->program, name);
    t->variables = xrealloc(t->variables, (size_t)input + 1, sizeof *t->variables);
    t->variables[input] = (struct variable){.signs = signs};
    return input;
}

/* Names beyond the sheet's become inputs; those of `free` are new ones, those of `small` are known. */
static bool declare_name(struct identities *t, int list, const struct yaml *item)
{
    const struct variable as = declarations[list].as;
    const char *name = item->text;
    int input = program_find(&t->program, name);
    if (input >= 0 && list == 0)
        return node_error(item, 0, "'%s' is known already, expected a new name", name);
    if (input < 0 && as.power > 0)
        return node_error(item, 0, "unknown symbol '%s', expected a free quantity", name);
    if (input < 0)
        input = add_variable(t, name, SIGN_ANY);
    struct variable *v = &t->variables[input];
    const int excess = v->signs & ~as.signs;
    if (v->angle || v->power > 0)
        return node_error(item, 0, "'%s' is an angle or small already", name);
    if (input < t->sheet_inputs && excess != 0)
        return node_error(item, 0, "'%s' may be %s in the sheet, expected a name of its own", name,
                          excess & SIGN_NEGATIVE ? "negative" : "zero");
    *v = (struct variable){v->signs & as.signs, as.angle, as.quarter_turn, as.power};
    return true;
}

static int signs_of_domain(enum domain domain)
{
    return domain == DOMAIN_FINITE ? SIGN_ANY : domain == DOMAIN_NOT_NEGATIVE ? SIGN_ZERO | SIGN_POSITIVE : SIGN_POSITIVE;
}

static bool read_declarations(struct identities *t, const struct scope *s)
{
    for (int i = 0; i < s->sheet->quantity_count; i++)
        add_variable(t, s->sheet->quantities[i].name, signs_of_domain(s->sheet->quantities[i].domain));
    t->sheet_inputs = t->program.inputs;
    for (int i = 0; i < DECLARATIONS; i++) {
        const struct yaml *names = scope_given(s, declarations[i].key);
        if (names != NULL && !is_texts(names, MOST_FURTHER_NAMES))
            return false;
        for (int k = 0; names != NULL && k < names->count; k++)
            if (!declare_name(t, i, &names->items[k]))
                return false;
    }
    for (int i = 0; i < s->name_count; i++)
        if (program_find(&t->program, s->names[i]) < 0)
            add_variable(t, s->names[i], SIGN_ANY);
    return true;
}

/* -1 where there is none; it has to be there where quantities are small. */
static bool read_order(struct identities *t, const struct scope *s)
{
    const struct yaml *node = scope_given(s, "order");
    const bool small = scope_given(s, "small") != NULL;
    t->order = -1;
    if (node == NULL)
        return !small || node_error(s->given, 0, "missing order: up to which power of the small quantities");
    if (!small)
        return node_error(node, 0, "expected no order where no quantities are small");
    if (node->text == NULL || strlen(node->text) != 1 || !isdigit((unsigned char)*node->text))
        return node_error(node, 0, "expected an order from 0 to 9");
    t->order = *node->text - '0';
    return true;
}

/* ---- rates ---- */

/* The name that the sheet has for the rate of a quantity: x1_dot of x1, w_dot_2 of w_2; false where it has none. */
static bool rate_name(const struct sheet *s, const char *name, char rate[LONGEST_NAME + 8])
{
    const char *index = strrchr(name, '_');
    const int stem = (int)(index != NULL ? index - name : 0);
    if (index != NULL && strcmp(index, "_dot") == 0)
        snprintf(rate, LONGEST_NAME + 8, "%.*s_ddot", stem, name);
    else if (index != NULL)
        snprintf(rate, LONGEST_NAME + 8, "%.*s_dot%s", stem, name, index);
    else
        snprintf(rate, LONGEST_NAME + 8, "%s_dot", name);
    return quantity_find(s, rate) != NULL;
}

static bool are_rates(const struct yaml *rates)
{
    bool fine = rates == NULL || is_map(rates);
    for (int i = 0; rates != NULL && i < rates->count && fine; i++)
        fine = is_text(&rates->items[i], "a text");
    return fine;
}

/* Every name that moves, and what it moves by, is known in the end, and goes by its own name. */
static bool check_rates(const struct identities *t)
{
    const struct yaml *rates = scope_given(&t->scope, "rates");
    char rate[LONGEST_NAME + 8];
    for (int i = 0; rates != NULL && i < rates->count; i++) {
        const struct yaml *by = &rates->items[i];
        for (int k = 0; k < 2; k++)
            if (program_find(&t->program, k == 0 ? by->key : by->text) < 0)
                return node_error(by, k == 0 ? AT_KEY : 0, "unknown symbol '%s', expected name: its rate",
                                  k == 0 ? by->key : by->text);
        if (rate_name(t->scope.sheet, by->key, rate) && strcmp(rate, by->text) != 0)
            return node_error(by, 0, "the rate of %s is %s in the sheet", by->key, rate);
    }
    return true;
}

static int read_rate(struct parser *p)
{
    struct identities *t = p->context;
    const struct scope *s = &t->scope;
    const struct yaml *rates = scope_given(s, "rates");
    const char *begin = p->at;
    char name[LONGEST_NAME + 8];
    p->at++; /* the bracket, without which it were a name */
    const int of = parse_sum(p), first = p->program->count; /* behind what was read */
    if (of < 0)
        return -1;
    if (!parse_symbol(p, ')'))
        return parse_refuse(p, "')' or an operator");
    if (first > MOST_RATES && s->altered == NULL)
        return parse_refuse(p, "fewer rates of rates");
    const char *still = NULL; /* the sheet knows its rate, and nothing here does */
    int *by = xrealloc(NULL, (size_t)first, sizeof *by);
    for (int i = 0; i < first; i++)
        by[i] = -1;
    for (int i = 0; rates != NULL && i < rates->count; i++) {
        const int moving = program_find(p->program, rates->items[i].key);
        if (moving >= 0)
            by[moving] = program_find(p->program, rates->items[i].text);
    }
    char *needed = program_needs(p->program, of, by);
    for (int i = 0; i < s->sheet->quantity_count; i++) {
        const char *own = s->sheet->quantities[i].name;
        if (needed[i] && by[i] < 0 && rate_name(s->sheet, own, name))
            still = own;
    }
    free(needed);
    t->last_rate = program_own(p->program, first, program_derivative(p->program, of, by, first));
    free(by);
    if (still == NULL)
        return t->last_rate;
    p->at = begin;
    rate_name(s->sheet, still, name);
    message_set(p->why, "rate() of what rests on %s, expected %s: %s among the rates", still, still, name);
    return -1;
}

/* ---- what a formula takes of the sheet ---- */

/* -1, the mistake being the name that was just passed. */
static int unknown_in_formula(struct parser *p, const char *name, const char *kind, const char *expected)
{
    p->at -= strlen(name);
    message_set(p->why, "unknown %s '%s', expected %s", kind, name, expected);
    return -1;
}

const struct relation *relation_find(const struct sheet *sheet, const char *number, const char *index,
                                     const struct section **section)
{
    char *end;
    long left = strtol(index, &end, 10);
    if (*end != '\0')
        return NULL;
    for (int i = 0; i < sheet->section_count; i++)
        for (int k = 0; k < sheet->sections[i].relation_count; k++) {
            const struct relation *relation = &sheet->sections[i].relations[k];
            *section = &sheet->sections[i];
            if (strcmp(relation->equation, number) == 0 && --left == 0)
                return relation;
        }
    return NULL;
}

/* (name = formula, ...) */
static int read_bindings(struct parser *p, const struct program *from, int *stand_in)
{
    char name[LONGEST_NAME + 1];
    do {
        if (!parse_word(p, name))
            return -1;
        int node = program_find(from, name);
        if (node < 0)
            return unknown_in_formula(p, name, "name", "an input or a named subexpression of that section");
        if (!parse_symbol(p, '='))
            return parse_refuse(p, "'='");
        if ((stand_in[node] = parse_sum(p)) < 0)
            return -1;
    } while (parse_symbol(p, ','));
    return parse_symbol(p, ')') ? 0 : parse_refuse(p, "an operator, ',' or ')'");
}

/*
 * What no binding names: inputs by what is in scope, named subexpressions by free names of one's own. The first input
 * that is wanted and that nothing is bound to; NULL: there is none.
 */
static const char *bind_names(const struct identities *t, const struct program *from, int wanted, int *stand_in)
{
    const char *missing = NULL;
    for (int i = 0; i < from->named; i++) {
        const int node = from->names[i].node;
        if ((node < from->inputs || is_free_name(t, from->names[i].text)) && stand_in[node] < 0)
            stand_in[node] = program_find(&t->program, from->names[i].text);
    }
    char *needed = program_needs(from, wanted, stand_in);
    for (int i = 0; i < from->inputs && missing == NULL; i++)
        missing = needed[i] && stand_in[i] < 0 ? from->names[i].text : NULL;
    free(needed);
    return missing;
}

static int *nothing_bound(const struct program *from)
{
    int *map = xrealloc(NULL, (size_t)from->count, sizeof *map);
    for (int i = 0; i < from->count; i++)
        map[i] = -1;
    return map;
}

/* Copies the part of a program into the identities', and remembers what became of it: of the map, which it keeps. */
static int take_part(struct parser *p, const struct use *u, int *map)
{
    struct identities *t = p->context;
    const struct alteration *altered = t->scope.altered;
    const struct program *from = &u->formulas->program;
    const char *missing = bind_names(t, from, u->part, map);
    const int first = t->program.count;
    const bool as_it_is = altered == NULL || !altered->uses[t->use_count];
    struct use *own = APPENDED(t->uses, t->use_count);
    *own = *u;
    own->copy = map;
    if (missing != NULL) {
        message_set(p->why, "nothing here is called '%s', expected %s = ... in brackets", missing, missing);
        return -1;
    }
    int like = 0; /* all that is taken of one formula has the free numbers of the first */
    while (t->uses[like].formulas != u->formulas || t->uses[like].part != u->part)
        like++;
    own->node = program_own(&t->program, first, as_it_is ? program_copy_node(&t->program, from, u->part, map)
                                                         : alteration_copy(&t->program, from, u->part, altered, 2 * like, map));
    return own->node;
}

static int read_side(struct parser *p, bool right)
{
    const struct identities *t = p->context;
    const char *begin = p->at;
    char number[LONGEST_NAME + 1], index[LONGEST_NAME + 1] = "1";
    struct use u;
    p->at++;
    if (!parse_word(p, number) || (parse_symbol(p, ',') && !parse_word(p, index)))
        return -1;
    if (!parse_symbol(p, ')'))
        return parse_refuse(p, "',' or ')'");
    const struct relation *relation = relation_find(t->scope.sheet, number, index, &u.section);
    if (relation == NULL) {
        p->at = begin;
        message_set(p->why, "unknown relation %s of (%s), expected one of the sheet", index, number);
        return -1;
    }
    u.formulas = &relation->sides;
    u.part = relation->sides.outputs[right];
    return take_part(p, &u, nothing_bound(&relation->sides.program));
}

/* An output, or the last of that name in the program. */
static bool find_output(struct use *u, const char *name)
{
    u->part = program_find(&u->formulas->program, name);
    for (int i = 0; i < u->section->output_count; i++)
        if (strcmp(u->section->outputs[i]->name, name) == 0)
            u->part = u->formulas->outputs[i];
    return u->part >= 0;
}

/* @printed, if it stands there; NULL after a complaint */
static const struct formulas *read_variant(struct parser *p, const struct section *section)
{
    char variant[LONGEST_NAME + 1];
    if (*p->at != '@')
        return &section->corrected;
    p->at++;
    if (!parse_word(p, variant))
        return NULL;
    if (strcmp(variant, "printed") == 0 && section->differs)
        return &section->printed;
    unknown_in_formula(p, variant, "variant", "'printed', of a section that the sheet has as printed too");
    return NULL;
}

const struct section *definition_find(const struct definitions *d, const char *id)
{
    return NAMED(id, d->sections, d->count, struct section, id);
}

const struct section *section_or_definition(const struct sheet *sheet, const struct definitions *d, const char *id)
{
    const struct section *definition = definition_find(d, id);
    return definition != NULL ? definition : section_find(sheet, id);
}

static int read_output(struct parser *p, const char *id)
{
    const struct identities *t = p->context;
    struct use u = {.section = section_or_definition(t->scope.sheet, t->scope.definitions, id)};
    char name[LONGEST_NAME + 1], whole[2 * LONGEST_NAME + 2];
    const char *point = p->at++;
    if (!parse_word(p, name))
        return -1;
    snprintf(whole, sizeof whole, "%s.%s", id, name); /* as further names may be */
    const int further = u.section == NULL ? program_find(p->program, whole) : -1;
    if (further >= 0)
        return further;
    if (u.section == NULL || u.section->method != METHOD_FORMULA) {
        p->at = point;
        return unknown_in_formula(p, id, "section", "one of the sheet that has formulas, as eq10");
    }
    const char *behind = p->at;
    u.formulas = read_variant(p, u.section);
    if (u.formulas == NULL)
        return -1;
    if (!find_output(&u, name)) {
        p->at = behind;
        return unknown_in_formula(p, name, "output", "an output or a named subexpression of that section");
    }
    int *map = nothing_bound(&u.formulas->program);
    if (*p->at != '(' || (p->at++, read_bindings(p, &u.formulas->program, map) == 0))
        return take_part(p, &u, map);
    free(map);
    return -1;
}

static int read_reference(struct parser *p, const char *name)
{
    if (*p->at == '.')
        return read_output(p, name);
    if (strcmp(name, "rate") == 0)
        return read_rate(p);
    if (strcmp(name, "left") == 0 || strcmp(name, "right") == 0)
        return read_side(p, name[0] == 'r');
    return unknown_in_formula(p, name, "function", "rate, left, right, sqrt, sin, cos, exp or atan2");
}

int identities_text(struct identities *t, const struct yaml *node, const char *text, size_t shift)
{
    return program_read(&t->program, node, text, shift, read_reference, t);
}

int identities_formula(struct identities *t, const struct yaml *node)
{
    return is_text(node, "a formula") ? identities_text(t, node, node->text, 0) : -1;
}

const char *side_end(const char *text, const char *signs)
{
    int depth = 0;
    for (; *text != '\0' && (strchr(signs, *text) == NULL || depth > 0); text++)
        depth += *text == '(' ? 1 : *text == ')' ? -1 : 0;
    return text;
}

bool same_text(const char *a, const char *a_end, const char *b)
{
    for (;; a++, b++) {
        a += strspn(a, " ");
        b += strspn(b, " ");
        if (a >= a_end || *a != *b)
            return a >= a_end && *b == '\0';
    }
}

/* A part of a text, without blanks behind it. */
static char *text_part(const char *from, const char *end)
{
    char *part = text_copy(from);
    while (end > from && end[-1] == ' ')
        end--;
    part[end - from] = '\0';
    return part;
}

/* a = b, or a = b = c */
static bool show_one(struct identities *t, const struct yaml *node)
{
    int left = -1;
    if (!is_text(node, "left = right"))
        return false;
    if (*side_end(node->text, "=") == '\0')
        return node_error(node, 0, "expected left = right");
    for (const char *before = NULL, *from = node->text, *end; from != NULL; from = *end == '\0' ? NULL : end + 1) {
        end = side_end(from, "=");
        char *side = text_part(from, end);
        const int right = identities_text(t, node, side, (size_t)(from - node->text));
        free(side);
        if (right < 0)
            return false;
        if (t->shown_count == MOST_SHOWN)
            return node_error(node, 0, "expected at most %d equalities", MOST_SHOWN);
        if (before != NULL)
            *APPENDED(t->shown, t->shown_count) = (struct equality){text_part(before, end), node, (size_t)(before - node->text), left, right};
        before = from + strspn(from, " ");
        left = right;
    }
    return true;
}

/* ---- definitions ---- */

/* A definition that is a formula of the sheet, or of a principle, or a rate, and nothing beside. */
static bool takes_formula(const struct identities *t, int node, bool of_sheet)
{
    const struct use *last = t->use_count > 0 ? &t->uses[t->use_count - 1] : NULL;
    return node == t->last_rate || (last != NULL && last->node == node && (!of_sheet || last->section->numbers > 0));
}

static bool read_let(struct identities *t)
{
    enum { SHORT = 40 };
    const struct alteration *altered = t->scope.altered;
    const struct yaml *let = scope_given(&t->scope, "let");
    if (let != NULL && !is_map(let))
        return false;
    for (int i = 0; let != NULL && i < let->count; i++) {
        const struct yaml *definition = &let->items[i];
        const int first = t->program.count;
        int node = identities_formula(t, definition);
        if (node < 0)
            return false;
        if (altered != NULL && altered->definitions && node >= first && !takes_formula(t, node, false))
            node = any_formula(&t->program, node, 2 * i + 1);
        program_name(&t->program, node, definition->key);
        /* what restricts nothing that the sheet would not needs no word */
        if (quantity_find(t->scope.sheet, definition->key) != NULL && !takes_formula(t, node, true))
            tex_add(&t->lets, strlen(definition->text) < SHORT ? ", %s = %s" : ", %s by its definition", definition->key, definition->text);
    }
    return true;
}

static bool read_square_roots(struct identities *t)
{
    const struct yaml *roots = scope_given(&t->scope, "square roots");
    if (roots == NULL)
        return true;
    if (!is_texts(roots, MOST_FURTHER_NAMES))
        return false;
    t->roots = xrealloc(NULL, (size_t)roots->count, sizeof *t->roots);
    for (; t->root_count < roots->count; t->root_count++) {
        const struct yaml *item = &roots->items[t->root_count];
        struct root *root = &t->roots[t->root_count];
        *root = (struct root){.text = item->text, .at = item, .node = identities_formula(t, item)};
        if (root->node < 0)
            return false;
    }
    return true;
}

bool identities_open(struct identities *t, const struct scope *s)
{
    *t = (struct identities){.scope = *s, .last_rate = -1};
    program_init(&t->program);
    return are_rates(scope_given(s, "rates")) && read_order(t, s) && read_declarations(t, s) && read_let(t) && read_square_roots(t);
}

/* ---- what serves nothing ---- */

static void mark_needed(struct identities *t)
{
    t->needed = xrealloc(NULL, (size_t)t->program.count, 1);
    memset(t->needed, 0, (size_t)t->program.count);
    for (int i = 0; i < t->shown_count; i++) {
        program_mark(&t->program, t->shown[i].left, NULL, t->needed);
        program_mark(&t->program, t->shown[i].right, NULL, t->needed);
    }
    for (int i = 0; i < t->root_count; i++)
        program_mark(&t->program, t->roots[i].node, NULL, t->needed);
}

static bool all_needed(const struct identities *t)
{
    const struct scope *s = &t->scope;
    const struct program *p = &t->program;
    for (int i = 0; i < DECLARATIONS; i++) {
        const struct yaml *names = scope_given(s, declarations[i].key);
        for (int k = 0; names != NULL && k < names->count; k++) {
            const struct yaml *item = &names->items[k];
            if (!t->needed[program_find(p, item->text)])
                return node_error(item, 0, "nothing shown rests on '%s'", item->text);
        }
    }
    const struct yaml *let = scope_given(s, "let");
    for (int k = 0, first = p->inputs; let != NULL && k < let->count; k++) {
        const int last = p->names[p->inputs + k].node; /* its formula: nodes first ... last, or an older one */
        bool serves = t->needed[last];
        for (; first <= last; first++) /* rate() may take up parts of it alone */
            serves = serves || t->needed[first];
        if (!serves)
            return node_error(&let->items[k], AT_KEY, "nothing shown rests on '%s'", p->names[p->inputs + k].text);
    }
    return true;
}

const struct yaml *text_at(const struct yaml *node, int i)
{
    return node->text != NULL ? (i == 0 ? node : NULL) : i < node->count ? &node->items[i] : NULL;
}

static bool show_each(struct identities *t, const struct yaml *show)
{
    const struct yaml *item;
    bool fine = true;
    t->show = show;
    for (int i = 0; fine && (item = text_at(show, i)) != NULL; i++)
        fine = show_one(t, item);
    return fine;
}

bool identities_show(struct identities *t, const struct yaml *show)
{
    if (!show_each(t, show) || !check_rates(t))
        return false;
    mark_needed(t);
    return t->scope.shared != NULL || all_needed(t);
}

void identities_alter(struct identities *altered, const struct identities *t, const struct alteration *a)
{
    struct scope s = t->scope;
    s.altered = a;
    if (identities_open(altered, &s)) /* what could be read can be read once more */
        show_each(altered, t->show);
}

void identities_clear(struct identities *t)
{
    program_clear(&t->program);
    free(t->variables);
    for (int i = 0; i < t->shown_count; i++)
        free(t->shown[i].text);
    free(t->shown);
    free(t->roots);
    for (int i = 0; i < t->use_count; i++)
        free(t->uses[i].copy);
    free(t->uses);
    free(t->needed);
    tex_clear(&t->lets);
}
