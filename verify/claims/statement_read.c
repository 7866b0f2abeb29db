/* paper/claims.yaml: what its statements say, assert and quote; every mistake with its place. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "claims/statement.h"
#include "text/scope.h"

/* What is being read. */
struct claim_reading {
    struct statements *all;
    struct statement *statement;
    const struct yaml *entry; /* a mapping of `prove`; NULL: none */
    struct identities *formulas; /* its formulas are read into one program */
    struct values *at;        /* read so far */
    ulong uses;               /* the assertions that formulas took numbers of */
};

static const char *keep_text(struct statements *s, const char *text, size_t length)
{
    char *copy = xrealloc(NULL, length + 1, 1);
    memcpy(copy, text, length);
    copy[length] = '\0';
    return *APPENDED(s->texts, s->text_count) = copy;
}

/* What the entry says under a key; NULL: nothing. */
static const struct yaml *own(const struct claim_reading *r, const char *key)
{
    return under(r->entry, key);
}

/* A mistake at a node or, where it is missing, in the entry. */
static bool entry_error(const struct claim_reading *r, const struct yaml *node, const char *expected)
{
    return node_error(node != NULL ? node : r->entry, 0, "%s", expected);
}

/* Of a scalar; else nothing. */
static const char *scalar_of(const struct yaml *node)
{
    return node != NULL && node->text != NULL ? node->text : "";
}

/* One text, or a list of them. */
static bool are_texts(const struct yaml *node, int most, const char *expected)
{
    return node->text != NULL || (is_texts(node, most) && (node->count > 0 || node_error(node, 0, "%s", expected)));
}

/* ---- names ---- */

/* Names that the statement's formulas may have beside the sheet's and the declared ones. */
static void add_name(struct claim_reading *r, const char *name)
{
    *APPENDED(r->all->names, r->all->name_count) = name;
}

static void add_keys(struct claim_reading *r, const struct yaml *mapping)
{
    for (int i = 0; mapping != NULL && mapping->mapping && i < mapping->count; i++)
        add_name(r, mapping->items[i].key);
}

/* What the texts of the statement ask of a computation, as ENTRY.number. */
static void add_numbers(struct claim_reading *r, struct computed *c, const char *entry, const struct yaml *node)
{
    static const char of_names[] = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_";
    const size_t length = strlen(entry);
    for (int i = 0; i < node->count; i++)
        add_numbers(r, c, entry, &node->items[i]);
    for (const char *at = node->text; at != NULL && (at = strstr(at, entry)) != NULL; at += length)
        if (at[length] == '.') {
            const char *name = keep_text(r->all, at, length + 1 + strspn(at + length + 1, of_names));
            computed_ask(c, name + length + 1);
            add_name(r, name);
        }
}

/* The numbers of `given` and of each entry: its root or its computation's; its values, what moves. */
static void collect_names(struct claim_reading *r, const struct yaml *statement)
{
    const struct yaml *prove = under(statement, "prove");
    r->all->name_count = 0;
    add_name(r, "pi");
    add_keys(r, under(under(statement, "given"), "at"));
    for (int i = 0; prove != NULL && i < prove->count; i++) {
        const struct yaml *entry = &prove->items[i];
        struct computed *c = computed_find(&r->all->computed, scalar_of(under(entry, "compute")));
        add_keys(r, under(entry, "at"));
        add_keys(r, under(entry, "on"));
        if (under(entry, "root") != NULL)
            add_name(r, entry->key);
        if (c != NULL)
            add_numbers(r, c, entry->key, statement);
    }
}

/* ---- formulas ---- */

/* What follows is read into one program, with the names and definitions of the entry; NULL: of what is given alone. */
static bool open_formulas(struct claim_reading *r, const struct yaml *entry)
{
    static const struct yaml nothing = {.mapping = true};
    r->entry = entry;
    const struct scope scope = {.sheet = r->all->sheet, .definitions = &r->all->proofs->definitions,
                                .given = entry, .shared = r->statement->given != NULL ? r->statement->given : &nothing,
                                .names = r->all->names, .name_count = r->all->name_count};
    r->formulas = xrealloc(NULL, 1, sizeof *r->formulas);
    *APPENDED(r->all->formulas, r->all->formula_count) = r->formulas;
    return identities_open(r->formulas, &scope);
}

/* Which assertions a node takes numbers of; those that stand after it are open, and with them the node. */
static ulong uses_of(const struct claim_reading *r, int node)
{
    const struct program *p = &r->formulas->program;
    const struct yaml *prove = r->statement->prove;
    char *needed = program_needs(p, node, NULL);
    ulong uses = 0;
    for (int i = 0; i < p->inputs; i++) {
        if (!needed[i])
            continue;
        for (int k = 0; prove != NULL && k < prove->count; k++)
            uses |= (ulong)is_number_of(p->names[i].text, prove->items[k].key) << k;
        for (int k = 0; k < r->at->count; k++)
            if (strcmp(r->at->list[k].name, p->names[i].text) == 0)
                uses |= r->at->list[k].uses;
    }
    free(needed);
    return uses;
}

/* A node becomes a formula. */
static bool take_node(struct claim_reading *r, struct formula *f, int node)
{
    if (node < 0)
        return false;
    *f = (struct formula){&r->formulas->program, node, uses_of(r, node)};
    r->uses |= f->uses;
    return true;
}

/* One that stands `shift` characters into a scalar. */
static bool read_formula_text(struct claim_reading *r, struct formula *f, const struct yaml *node, const char *text, size_t shift)
{
    return take_node(r, f, identities_text(r->formulas, node, text, shift));
}

static bool read_formula(struct claim_reading *r, struct formula *f, const struct yaml *node)
{
    return (node->text != NULL || entry_error(r, node, "expected a formula")) && read_formula_text(r, f, node, node->text, 0);
}

/* ---- values ---- */

/* No formula stands for a name that a value, an unknown or what moves has: `let` would silently take its place. */
static bool is_no_let(const struct claim_reading *r, const struct yaml *node, size_t offset, const char *name)
{
    const bool let = under(own(r, "let"), name) != NULL || under(under(r->statement->given, "let"), name) != NULL;
    return !let || node_error(node, offset, "'%s' stands in let, too", name);
}

/* One `name: value`, `name: value +- uncertainty` or `name: [value, ...]`; its formulas may use the values before it. */
static bool read_value(struct claim_reading *r, struct value *v, const struct yaml *node)
{
    const char *sign = node->text != NULL ? strstr(node->text, "+-") : NULL;
    const size_t length = sign != NULL ? (size_t)(sign - node->text) : 0;
    bool fine = true;
    *v = (struct value){.name = node->key, .turns = 1};
    r->uses = 0;
    if (node->text == NULL) {
        if (!is_texts(node, MOST_TURNS) || (v->turns = node->count) == 0)
            return entry_error(r, node, "expected a value, or several");
        for (int i = 0; i < v->turns && fine; i++)
            fine = read_formula(r, &v->of[i], &node->items[i]);
    } else if (sign == NULL)
        fine = read_formula(r, &v->of[0], node);
    else
        fine = read_formula_text(r, &v->of[0], node, keep_text(r->all, node->text, length), 0) &&
               read_formula_text(r, &v->radius, node, sign + 2, length + 2);
    v->uses = r->uses;
    return fine;
}

/* `at` of the entry, then those of `given` that it does not name. */
static bool read_values(struct claim_reading *r, struct values *at)
{
    const struct yaml *const both[] = {own(r, "at"), under(r->statement->given, "at")};
    r->at = at;
    at->turns = 1;
    for (int k = 0; k < 2; k++) {
        if (both[k] != NULL && !is_map(both[k]))
            return false;
        for (int i = 0; both[k] != NULL && i < both[k]->count; i++) {
            const struct yaml *node = &both[k]->items[i];
            struct value v;
            if (k == 1 && under(both[0], node->key) != NULL)
                continue;
            if (!read_value(r, &v, node) || !is_no_let(r, node, AT_KEY, v.name))
                return false;
            if (v.turns > 1 && at->turns > 1 && v.turns != at->turns)
                return entry_error(r, node, "expected lists of one length");
            *APPENDED(at->list, at->count) = v;
            at->turns = FLINT_MAX(at->turns, v.turns);
        }
    }
    r->uses = 0;
    return true;
}

/* ---- assertions ---- */

/* on: {name: [low, high]}, or [low] alone */
static bool read_interval(struct claim_reading *r, struct assertion *a, int bounds)
{
    const struct yaml *on = own(r, "on"), *range = on != NULL && on->mapping && on->count == 1 ? &on->items[0] : NULL;
    if (range == NULL || range->key[0] == '\0' || range->mapping || range->count != bounds)
        return entry_error(r, on, bounds == 2 ? "expected on: {name: [low, high]}" : "expected on: {name: [low]}");
    a->variable = range->key;
    return is_no_let(r, range, AT_KEY, range->key) && read_formula(r, &a->low, &range->items[0]) &&
           (bounds == 1 || read_formula(r, &a->high, &range->items[1]));
}

/* Whether a node has no name in it. */
static bool is_nameless(const struct program *p, int node)
{
    char *needed = program_needs(p, node, NULL);
    const bool number = memchr(needed, 1, (size_t)FLINT_MIN(p->inputs, node + 1)) == NULL;
    free(needed);
    return number;
}

/* left - right of a relation in a scalar, `sign` between them. */
static bool read_difference(struct claim_reading *r, struct assertion *a, const struct yaml *node, const char *sign)
{
    const char *text = node->text, *left = keep_text(r->all, text, (size_t)(sign - text));
    struct program *p = &r->formulas->program;
    const int one = identities_text(r->formulas, node, left, 0);
    a->right = one >= 0 ? identities_text(r->formulas, node, sign + 1, (size_t)(sign - text) + 1) : -1;
    if (a->right < 0)
        return false;
    a->loose = a->variable == NULL && is_nameless(p, a->right);
    return take_node(r, &a->formula, program_append(p, OPERATOR_SUBTRACT, one, a->right, 0));
}

/* An equality for all values, or a list of them. */
static bool read_identity(struct claim_reading *r, struct assertion *a, const struct yaml *node)
{
    const bool algebra = own(r, "algebra") != NULL; /* it rests on no formula of the sheet, and says so */
    if (own(r, "at") != NULL || own(r, "on") != NULL)
        return entry_error(r, node, "expected no at and no on beside equalities for all values");
    if (!identities_show(r->formulas, node))
        return false;
    a->identity = r->formulas;
    const struct equality *empty = algebra ? NULL : identities_tautology(r->formulas);
    return empty == NULL || node_error(empty->at, 0, "it holds whatever the sheet says, expected {algebra: left = right} for what is "
                                                     "algebra alone");
}

static bool read_show(struct claim_reading *r, struct assertion *a, const struct yaml *show)
{
    if (show->text == NULL)
        return are_texts(show, MOST_SHOWN, "expected equalities") && read_identity(r, a, show);
    const char *sign = side_end(show->text, "<=>");
    if (*sign == '\0')
        return entry_error(r, show, "expected left = right, or < or > between them");
    a->sign = *sign - '=';
    if (own(r, "on") != NULL && !read_interval(r, a, 2))
        return false;
    if (same_text(show->text, sign, sign + 1)) /* but for blanks */
        return entry_error(r, show, "both sides are the same, expected what could be otherwise");
    if (a->sign == 0 && (own(r, "at") == NULL || a->variable != NULL))
        return read_identity(r, a, show);
    return (own(r, "algebra") == NULL || entry_error(r, show, "expected equalities for all values")) && read_difference(r, a, show, sign);
}

static bool read_count(struct claim_reading *r, const struct yaml *node, long *count)
{
    char after;
    return (sscanf(scalar_of(node), "%ld%c", count, &after) == 1 && *count >= 0) || entry_error(r, node, "expected a count: 0, 1, 2 ...");
}

/* The one root between two bounds, or how many there are above one. */
static bool read_root(struct claim_reading *r, struct assertion *a, const struct yaml *value)
{
    const bool one = a->kind == ASSERT_ROOT;
    if (one && a->at.turns > 1)
        return entry_error(r, own(r, "at"), "expected one value each: a root is one number");
    return read_interval(r, a, one ? 2 : 1) && read_formula(r, &a->formula, value) &&
           (one || read_count(r, own(r, "count"), &a->count));
}

/* The rank of a system's matrix: states and their rates, in one program. */
static bool read_rank(struct claim_reading *r, struct assertion *a, const struct yaml *value)
{
    const struct yaml *system = r->statement->system, *control = own(r, "control"), *observe = own(r, "observe");
    struct linear_system *l = &a->system;
    struct formula f;
    if (!read_count(r, value, &a->count))
        return false;
    if (system == NULL || system->count == 0 || system->count > MOST_STATES)
        return entry_error(r, system, "expected a system, {state: its rate, ...} of at most 6 states");
    l->of = &r->formulas->program;
    l->size = system->count;
    l->observe = -1;
    for (int i = 0; i < l->size; i++) {
        const struct yaml *rate = &system->items[i];
        l->states[i] = program_find(l->of, rate->key);
        if (l->states[i] < 0)
            return node_error(rate, AT_KEY, "unknown symbol '%s', expected a quantity or a free name", rate->key);
        if (!read_formula(r, &f, rate))
            return false;
        l->rates[i] = f.node;
        if (strcmp(scalar_of(observe), rate->key) == 0)
            l->observe = i;
    }
    l->control = program_find(l->of, scalar_of(control));
    if ((control != NULL && l->control < 0) || (observe != NULL && l->observe < 0))
        return entry_error(r, control != NULL ? control : observe, "expected control: a quantity, or observe: a state");
    return true;
}

/* The ids of steps, or of claims that stand before. */
static bool read_cited(struct claim_reading *r, struct assertion *a, const struct yaml *value)
{
    const bool step = a->kind == ASSERT_STEP;
    const char *expected = step ? "expected a step of derivations.yaml" : "expected a claim that stands before";
    const struct yaml *node;
    if (!are_texts(value, MOST_CITED, expected))
        return false;
    for (int i = 0; (node = text_at(value, i)) != NULL; i++) {
        const struct statement *claim = statement_find(r->all, node->text);
        if (step ? step_named(r->all->proofs, node->text) == NULL : claim == NULL || claim == r->statement)
            return entry_error(r, node, expected);
        a->cited[i] = node->text;
    }
    return true;
}

static bool read_compute(struct claim_reading *r, struct assertion *a, const struct yaml *value)
{
    a->computed = computed_find(&r->all->computed, scalar_of(value));
    return a->computed != NULL || entry_error(r, value, "unknown computation, expected one of verify/claims/");
}

/* The keys of what has formulas. */
#define FORMULA_FIELDS IDENTITIES_FIELDS, {.key = "let"}, {.key = "at"}
#define KEYS(...) (const struct field[]){__VA_ARGS__, {.key = NULL}}

/* The forms of an entry of `prove`, and the keys of each. */
static const struct form {
    const char *key;
    enum assertion_kind kind;
    bool (*read)(struct claim_reading *r, struct assertion *a, const struct yaml *value);
    const struct field *keys;
} forms[] = {
    {"show", ASSERT_SHOW, read_show, KEYS({.key = "show"}, {.key = "on"}, FORMULA_FIELDS)},
    {"algebra", ASSERT_SHOW, read_show, KEYS({.key = "algebra"}, FORMULA_FIELDS)},
    {"root", ASSERT_ROOT, read_root, KEYS({.key = "root"}, {.key = "on"}, FORMULA_FIELDS)},
    {"roots", ASSERT_ROOTS, read_root, KEYS({.key = "roots"}, {.key = "on"}, {.key = "count"}, FORMULA_FIELDS)},
    {"rank", ASSERT_RANK, read_rank,
     KEYS({.key = "rank"}, {.key = "control"}, {.key = "observe"}, FORMULA_FIELDS)},
    {"step", ASSERT_STEP, read_cited, KEYS({.key = "step"})},
    {"claim", ASSERT_CLAIM, read_cited, KEYS({.key = "claim"})},
    {"compute", ASSERT_COMPUTE, read_compute, KEYS({.key = "compute"})}};

enum { FORMS = sizeof forms / sizeof *forms };

static const struct field given_fields[] = {FORMULA_FIELDS, FIELD("system", struct statement, system, FIELD_MAP), {.key = NULL}};

static bool read_assertion(struct claim_reading *r, struct assertion *a)
{
    if (!open_formulas(r, a->node->mapping ? a->node : NULL) || !read_values(r, &a->at))
        return false;
    if (r->entry == NULL)
        return read_show(r, a, a->node);
    int i = 0;
    while (i < FORMS && under(r->entry, forms[i].key) == NULL)
        i++;
    if (i < FORMS) {
        a->kind = forms[i].kind;
        return fields_read(r->entry, forms[i].keys, a) && forms[i].read(r, a, under(r->entry, forms[i].key));
    }
    return entry_error(r, a->node, "expected left = right, or one of show, algebra, root, roots, rank, step, claim, compute");
}

static bool read_prove(struct claim_reading *r, const struct yaml *prove)
{
    struct statement *s = r->statement;
    if (prove == NULL)
        return true;
    if (prove->count > MOST_ASSERTIONS)
        return node_error(prove, 0, "expected at most %d assertions", MOST_ASSERTIONS);
    s->assertions = xrealloc(NULL, (size_t)prove->count, sizeof *s->assertions);
    memset(s->assertions, 0, (size_t)prove->count * sizeof *s->assertions);
    for (int i = 0; i < prove->count; i++) {
        struct assertion *a = &s->assertions[s->assertion_count++];
        a->name = prove->items[i].key;
        a->node = &prove->items[i];
        if (!read_assertion(r, a))
            return false;
        a->uses = r->uses;
        if (a->kind == ASSERT_ROOT && strcmp(a->variable, a->name) == 0)
            a->uses &= ~(UWORD(1) << i); /* the unknown itself */
        if (a->uses >> i != 0)
            return node_error(a->node, 0, "'%s' rests on itself, or on what stands after it", a->name);
    }
    return true;
}

/* ---- verdicts ---- */

/* Names of assertions, each with `not` before it or without: one, or a list. */
static bool read_wanted(struct verdict_condition *c, const struct statement *s, const struct yaml *condition)
{
    const struct yaml *node;
    if (!are_texts(condition, MOST_ASSERTIONS, "expected a name of prove"))
        return false;
    for (int k = 0; (node = text_at(condition, k)) != NULL; k++) {
        const size_t begin = strncmp(node->text, "not ", 4) == 0 ? 4 : 0;
        int i = 0;
        while (i < s->assertion_count && strcmp(s->assertions[i].name, node->text + begin) != 0)
            i++;
        if (i == s->assertion_count || s->assertions[i].kind == ASSERT_COMPUTE)
            return node_error(node, begin, "expected a name of prove, but no computation");
        c->wanted[i] = begin > 0 ? -1 : 1;
    }
    for (int i = 0; i < s->assertion_count; i++) /* so that none comes true by what it leaves out */
        if ((c->wanted[i] != 0) != (s->conditions[0].wanted[i] != 0))
            return node_error(condition, 0, "expected the names of the first condition, each with not or without");
    for (const struct verdict_condition *before = s->conditions; before < c; before++)
        if (memcmp(before, c, sizeof *c) == 0)
            return node_error(condition, 0, "expected another condition than those before");
    return true;
}

/* Without a condition: all that is to be proved. */
static bool read_verdict(struct claim_reading *r, const char *verdict, const struct yaml *at, size_t offset, const struct yaml *condition)
{
    struct statement *s = r->statement;
    int v = VERDICT_NONE + 1;
    while (v < VERDICTS && strcmp(verdict_names[v], verdict) != 0)
        v++;
    if (v == VERDICTS)
        return node_error(at, offset, "expected a verdict: holds, holds as corrected, qualified, refuted, definition or not decidable");
    struct verdict_condition *c = &s->conditions[s->verdict_count];
    s->verdicts[s->verdict_count++] = (enum verdict)v;
    bool wants = false;
    for (int i = 0; condition == NULL && i < s->assertion_count; i++) {
        c->wanted[i] = s->assertions[i].kind != ASSERT_COMPUTE;
        wants = wants || c->wanted[i] != 0;
    }
    if (condition == NULL)
        return wants || v == NOT_DECIDABLE || node_error(at, offset, "expected something to prove; only 'not decidable' needs nothing");
    return read_wanted(c, s, condition);
}

/* Where nothing is said it holds, a misprint as corrected. */
static bool read_verdicts(struct claim_reading *r, const struct yaml *node, const struct yaml *statement)
{
    const bool misprint = strcmp(r->statement->kind, "misprint") == 0;
    if (node == NULL)
        return read_verdict(r, verdict_names[misprint ? HOLDS_AS_CORRECTED : HOLDS], statement, 0, NULL);
    if (node->text != NULL)
        return read_verdict(r, node->text, node, 0, NULL);
    if (!node->mapping || node->count == 0)
        return entry_error(r, node, "expected verdict: {holds: condition, ...}");
    for (int i = 0; i < node->count; i++)
        if (!read_verdict(r, node->items[i].key, &node->items[i], AT_KEY, &node->items[i]))
            return false;
    return true;
}

/* Nothing stands without one of its assertions, or with its contrary. */
static bool all_serve(const struct statement *s)
{
    ulong serving = 0;
    for (int i = 0; i < s->number_count; i++)
        serving |= s->numbers[i].formula.uses;
    for (int i = s->assertion_count - 1; i >= 0; i--) { /* each uses earlier ones alone */
        serving |= s->conditions[0].wanted[i] != 0 ? UWORD(1) << i : 0;
        if ((serving >> i & 1) == 0)
            return node_error(s->assertions[i].node, 0, "%s stands without '%s', or with its contrary", s->id, s->assertions[i].name);
        serving |= s->assertions[i].uses;
    }
    return true;
}

/* ---- evidence ---- */

/* "4", "exact", "2 up", "2 down" */
static bool read_rounding(const char *text, struct quoted_number *n)
{
    char word[8] = "", end;
    if (strcmp(text, "exact") == 0) {
        n->rounding = AS_RATIONAL;
        return true;
    }
    const int count = sscanf(text, "%ld %7[a-z]%c", &n->digits, word, &end);
    n->rounding = strcmp(word, "up") == 0 ? UPWARD : strcmp(word, "down") == 0 ? DOWNWARD : TO_DIGITS;
    return count == (n->rounding == TO_DIGITS ? 1 : 2) && n->digits >= 1 && n->digits <= 60;
}

static const char *keep_trimmed(struct statements *s, const char *from, const char *to)
{
    while (*from == ' ') /* a bar or a brace stands behind */
        from++;
    while (from < to && to[-1] == ' ')
        to--;
    return keep_text(s, from, (size_t)(to - from));
}

/* FORMULA | DIGITS, or FORMULA | DIGITS | UNIT */
static bool read_number(struct claim_reading *r, const struct yaml *node, const char *at, size_t length)
{
    struct statement *s = r->statement;
    const size_t start = (size_t)(at - node->text);
    const char *end = at + length, *bar = memchr(at, '|', length);
    const char *last = bar != NULL ? memchr(bar + 1, '|', (size_t)(end - bar) - 1) : NULL;
    struct quoted_number *n = APPENDED(s->numbers, s->number_count);
    *n = (struct quoted_number){.node = node, .offset = start};
    n->text = keep_trimmed(r->all, at, bar != NULL ? bar : at);
    n->unit = last != NULL ? keep_trimmed(r->all, last + 1, end) : NULL;
    if (bar == NULL || !read_rounding(keep_trimmed(r->all, bar + 1, last != NULL ? last : end), n))
        return node_error(node, start + (bar != NULL ? (size_t)(bar - at) + 1 : 0),
                          "expected {FORMULA | DIGITS}, DIGITS being 4, exact, 2 up or 2 down");
    return read_formula_text(r, &n->formula, node, n->text, start + strspn(at, " "));
}

static bool read_marks(struct claim_reading *r, const struct yaml *node, bool numbers)
{
    const char *at = node->text;
    for (struct marked_part part = marked_next(&at); part.kind != PART_END; part = marked_next(&at)) {
        if (part.kind == PART_WRONG)
            return node_error(node, (size_t)(part.at - node->text), "%s", part.expected);
        if (part.kind == PART_NUMBER && !numbers)
            return node_error(node, (size_t)(part.at - node->text) - 1, "expected no number {...} here");
        if (part.kind == PART_NUMBER && !read_number(r, node, part.at, part.length))
            return false;
    }
    return true;
}

/* ---- statements ---- */

static const char *const claim_kinds[] = {"statement", "implied", "misprint", "number", "beyond", NULL};

static const struct field statement_fields[] = {
    FIELD("where", struct statement, where, FIELD_TEXT, .expected = "a text"),
    FIELD("kind", struct statement, word_of_kind, FIELD_WORD, .words = claim_kinds),
    FIELD("claim", struct statement, claim, FIELD_TEXT, .expected = "a text"),
    FIELD("why", struct statement, why, FIELD_TEXT),
    FIELD("evidence", struct statement, evidence, FIELD_TEXT, .expected = "a text"),
    FIELD("equations", struct statement, equations, FIELD_TEXTS, .most = 8,
          .count = offsetof(struct statement, equation_count)),
    FIELD("given", struct statement, given, FIELD_NODE),
    FIELD("prove", struct statement, prove, FIELD_MAP),
    FIELD("verdict", struct statement, verdict, FIELD_NODE),
    {.key = NULL}};

const struct section *section_with(const struct sheet *sheet, const char *equation)
{
    for (int i = 0; i < sheet->section_count; i++)
        for (int k = 0; k < sheet->sections[i].numbers; k++)
            if (strcmp(sheet->sections[i].equations[k], equation) == 0)
                return &sheet->sections[i];
    return NULL;
}

static bool check_equations(const struct sheet *sheet, const struct yaml *list)
{
    for (int k = 0; list != NULL && k < list->count; k++)
        if (section_with(sheet, list->items[k].text) == NULL)
            return node_error(&list->items[k], 0, "unknown '%s', expected an equation number", list->items[k].text);
    return true;
}

static bool read_statement(struct statements *all, const struct yaml *n)
{
    static const char *const marked[] = {"where", "claim", "why"};
    struct statement *s = APPENDED(all->list, all->count);
    struct claim_reading r = {.all = all, .statement = s, .entry = n};
    *s = (struct statement){.id = n->key};
    if (!fields_read(n, statement_fields, s))
        return false;
    s->kind = claim_kinds[s->word_of_kind];
    collect_names(&r, n);
    for (int k = 0; k < 3; k++)
        if (own(&r, marked[k]) != NULL && !read_marks(&r, own(&r, marked[k]), false))
            return false;
    if ((s->given != NULL && !fields_read(s->given, given_fields, s)) || !check_equations(all->sheet, own(&r, "equations")) ||
        !read_prove(&r, s->prove))
        return false;
    if (!open_formulas(&r, NULL) || !read_values(&r, &s->at) || !read_marks(&r, under(n, "evidence"), true) || !read_verdicts(&r, s->verdict, n) || !all_serve(s))
        return false;
    const bool plain = s->verdicts[0] == HOLDS || s->verdicts[0] == DEFINITION;
    return plain || s->why != NULL || node_error(n, 0, "missing why, of a verdict other than holds and definition");
}

struct statement *statement_find(const struct statements *s, const char *id)
{
    return NAMED(id, s->list, s->count, struct statement, id);
}

int statements_read(struct statements *s, const struct derivations *proofs, const struct source *source, struct message *why)
{
    *s = (struct statements){.sheet = proofs->sheet, .proofs = proofs, .computed.steps = proofs};
    s->tree = tree_open(source->text, source->length, source->name, why);
    bool fine = s->tree != NULL && is_map(&s->tree->root);
    for (int i = 0; fine && i < s->tree->root.count; i++)
        fine = read_statement(s, &s->tree->root.items[i]);
    if (!fine)
        statements_clear(s);
    return fine ? 0 : -1;
}

void statements_clear(struct statements *s)
{
    for (int i = 0; i < s->count; i++) {
        struct statement *claim = &s->list[i];
        for (int k = 0; k < claim->assertion_count; k++)
            free(claim->assertions[k].at.list);
        for (int k = 0; k < claim->number_count; k++)
            free(claim->numbers[k].decimal);
        free(claim->at.list);
        free(claim->assertions);
        free(claim->numbers);
    }
    for (int i = 0; i < s->formula_count; i++) {
        identities_clear(s->formulas[i]);
        free(s->formulas[i]);
    }
    for (int i = 0; i < s->text_count; i++)
        free(s->texts[i]);
    free(s->formulas);
    free(s->names);
    free(s->texts);
    free(s->list);
    computations_clear(&s->computed);
    tree_close(s->tree);
    *s = (struct statements){0};
}
