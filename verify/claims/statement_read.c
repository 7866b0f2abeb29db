/* paper/claims.yaml: what its statements say, assert and quote; every mistake with its place. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "claims/condition.h"
#include "claims/statement.h"

enum { MOST_NAMES = 128 };

/* What is being read. */
struct reading {
    struct statements *all;
    struct document *document;
    struct statement *statement;
    const yaml_node_t *entry; /* a mapping of `prove`; NULL: none */
    struct values *at;        /* read so far */
};

static const char *keep(struct statements *s, const char *text, size_t length)
{
    char *copy = xrealloc(NULL, length + 1, 1);
    memcpy(copy, text, length);
    copy[length] = '\0';
    s->texts = xrealloc(s->texts, (size_t)s->text_count + 1, sizeof *s->texts);
    return s->texts[s->text_count++] = copy;
}

/* What the entry says under a key; NULL: nothing. */
static const yaml_node_t *own(const struct reading *r, const char *key)
{
    return r->entry != NULL ? child(r->document, r->entry, key) : NULL;
}

static const yaml_node_t *shared(const struct reading *r, const char *key)
{
    return r->statement->given != NULL ? child(r->document, r->statement->given, key) : NULL;
}

/* The same or, where it says nothing, the statement's `given`. */
static const yaml_node_t *given(const struct reading *r, const char *key)
{
    return own(r, key) != NULL ? own(r, key) : shared(r, key);
}

/* A mistake at a node or, where it is missing, in the entry. */
static bool refuse(const struct reading *r, const yaml_node_t *node, const char *expected)
{
    return parse_error(r->document, node != NULL ? node : r->entry, 0, "%s", expected);
}

/* ---- names ---- */

/* The names that formulas may have beside the sheet's and the declared ones. */
struct names {
    const char *list[MOST_NAMES];
    int count;
};

static bool is_declared(const struct reading *r, const char *name)
{
    static const char *const lists[] = {"free", "angles", "positive", "not negative"};
    for (size_t k = 0; k < sizeof lists / sizeof *lists; k++) {
        const yaml_node_t *names = given(r, lists[k]);
        for (int i = 0; names != NULL && i < length_of(names); i++) {
            const yaml_node_t *item = names->type == YAML_MAPPING_NODE ? key_of(r->document, names, i) : item_of(r->document, names, i);
            if (scalar(item) != NULL && strcmp(scalar(item), name) == 0)
                return true;
        }
    }
    return false;
}

static void add_name(const struct reading *r, struct names *n, const char *name)
{
    if (name == NULL || n->count == MOST_NAMES || quantity_find(r->all->sheet, name) != NULL || is_declared(r, name))
        return;
    for (int i = 0; i < n->count; i++)
        if (strcmp(n->list[i], name) == 0)
            return;
    n->list[n->count++] = name;
}

static void add_keys(const struct reading *r, struct names *n, const yaml_node_t *mapping)
{
    for (int i = 0; mapping != NULL && mapping->type == YAML_MAPPING_NODE && i < length_of(mapping); i++)
        add_name(r, n, scalar(key_of(r->document, mapping, i)));
}

/* What an entry of `prove` names: its root, the numbers of its computation; its values, what moves, what takes values. */
static void add_entry(const struct reading *r, struct names *n, const char *key, const yaml_node_t *entry)
{
    static const char *const keys[] = {"at", "on", "for"};
    const yaml_node_t *of = child(r->document, entry, "of"), *compute = child(r->document, entry, "compute");
    const struct computed *c = compute != NULL && scalar(compute) != NULL ? computed_find(&r->all->computed, scalar(compute)) : NULL;
    char name[2 * LONGEST_NAME + 2], word[64];
    for (size_t k = 0; k < 3; k++)
        add_keys(r, n, child(r->document, entry, keys[k]));
    add_name(r, n, of != NULL ? scalar(of) : NULL);
    add_name(r, n, child(r->document, entry, "root") != NULL ? key : NULL);
    for (const char *at = c != NULL ? computation_of(c)->numbers : ""; (at = next_name(at, word)) != NULL;) {
        snprintf(name, sizeof name, "%.63s.%s", key, word);
        add_name(r, n, keep(r->all, name, strlen(name)));
    }
}

static void collect_names(const struct reading *r, struct names *n)
{
    const yaml_node_t *prove = r->statement->prove;
    *n = (struct names){{"pi"}, 1};
    add_keys(r, n, shared(r, "at"));
    for (int i = 0; prove != NULL && prove->type == YAML_MAPPING_NODE && i < length_of(prove); i++)
        if (value_of(r->document, prove, i)->type == YAML_MAPPING_NODE && scalar(key_of(r->document, prove, i)) != NULL)
            add_entry(r, n, scalar(key_of(r->document, prove, i)), value_of(r->document, prove, i));
}

/* ---- formulas ---- */

/* Formulas that are read into one program, and the names that they may have. */
struct parsing {
    struct names names;
    struct scope scope;
    struct identities identities;
    bool fine; /* as yet */
};

static void parsing_open(struct parsing *f, const struct reading *r)
{
    static const yaml_node_t nothing = {.type = YAML_MAPPING_NODE};
    collect_names(r, &f->names);
    f->identities = (struct identities){.order = -1};
    f->scope = (struct scope){.document = r->document, .sheet = r->all->sheet, .definitions = &r->all->proofs->derivations.definitions,
                              .given = r->entry, .shared = r->statement->given != NULL ? r->statement->given : &nothing,
                              .names = f->names.list, .name_count = f->names.count};
    f->fine = identities_open(&f->identities, &f->scope);
}

/* One that stands `shift` characters into a scalar: its node, or -1 after a complaint. */
static int parsing_add(struct parsing *f, const yaml_node_t *node, const char *text, size_t shift)
{
    struct message why;
    size_t where;
    const int result = f->fine ? identities_text(&f->identities, &f->scope, text, &where, &why) : -1;
    if (f->fine && result < 0)
        f->fine = parse_error(f->scope.document, node, shift + where, "%s", why.text);
    return result;
}

/* The program is taken, all else of them goes. */
static bool parsing_close(struct parsing *f, struct program *p)
{
    *p = f->identities.program;
    program_init(&f->identities.program);
    identities_clear(&f->identities);
    return f->fine;
}

/* Whether a name is the number of an entry: ENTRY or ENTRY.number. */
static bool is_number_of(const char *name, const char *entry)
{
    const size_t length = strlen(entry);
    return strncmp(name, entry, length) == 0 && strchr(".", name[length]) != NULL;
}

/* Which assertions a node takes numbers of; those that stand after it are open, and with them the node. */
static ulong uses_of(const struct reading *r, const struct program *p, int node)
{
    char *needed = xrealloc(NULL, (size_t)node + 1, 1);
    ulong uses = 0;
    program_needs(p, node, NULL, needed);
    for (int i = 0; i < p->inputs && i <= node; i++) {
        const char *name = p->names[i].text;
        for (int k = 0; needed[i] && r->statement->prove != NULL && k < length_of(r->statement->prove); k++)
            if (is_number_of(name, scalar(key_of(r->document, r->statement->prove, k))))
                uses |= UWORD(1) << k;
        for (int k = 0; needed[i] && r->at != NULL && k < r->at->count; k++)
            if (strcmp(r->at->list[k].name, name) == 0)
                uses |= r->at->list[k].formula.uses | r->at->list[k].radius.uses;
    }
    free(needed);
    return uses;
}

static bool read_formula_text(struct reading *r, struct formula *f, const yaml_node_t *node, const char *text, size_t shift)
{
    struct parsing one;
    parsing_open(&one, r);
    f->node = parsing_add(&one, node, text, shift);
    parsing_close(&one, &f->program);
    f->uses = one.fine ? uses_of(r, &f->program, f->node) : 0;
    return one.fine;
}

static bool read_scalar_formula(struct reading *r, struct formula *f, const yaml_node_t *node)
{
    if (scalar(node) == NULL)
        return refuse(r, node, "expected a formula");
    return read_formula_text(r, f, node, scalar(node), 0);
}

/* ---- values ---- */

/* One `name: value +- uncertainty`; its formulas may use the values before it. */
static bool read_value(struct reading *r, struct value *v, const yaml_node_t *key, const yaml_node_t *text)
{
    *v = (struct value){.name = scalar(key)};
    const char *sign = scalar(text) != NULL ? strstr(scalar(text), "+-") : NULL;
    v->uncertain = sign != NULL;
    if (sign == NULL)
        return read_scalar_formula(r, &v->formula, text);
    const size_t length = (size_t)(sign - scalar(text));
    return read_formula_text(r, &v->formula, text, keep(r->all, scalar(text), length), 0) &&
           read_formula_text(r, &v->radius, text, sign + 2, length + 2);
}

/* `at` of the entry, then those of `given` that it does not name. */
static bool read_values(struct reading *r, struct values *at)
{
    const yaml_node_t *const both[] = {own(r, "at"), shared(r, "at")};
    r->at = at;
    for (int k = 0; k < 2; k++) {
        if (both[k] != NULL && !is_mapping(r->document, both[k], NULL))
            return false;
        for (int i = 0; both[k] != NULL && i < length_of(both[k]); i++) {
            const yaml_node_t *key = key_of(r->document, both[k], i);
            if (k == 1 && both[0] != NULL && child(r->document, both[0], scalar(key)) != NULL)
                continue;
            struct value v;
            const bool fine = read_value(r, &v, key, value_of(r->document, both[k], i));
            at->list = xrealloc(at->list, (size_t)at->count + 1, sizeof *at->list);
            at->list[at->count++] = v;
            if (!fine)
                return false;
        }
    }
    return true;
}

/* A list of formulas; its length, or -1 after a complaint */
static int read_range(struct reading *r, const yaml_node_t *list, struct formula *f, int most)
{
    if (!is_list(r->document, list, most))
        return -1;
    for (int i = 0; i < length_of(list); i++)
        if (!read_scalar_formula(r, &f[i], item_of(r->document, list, i)))
            return -1;
    return length_of(list);
}

/* ---- assertions ---- */

static const char *find_ordering(const char *text, enum ordering *ordering, size_t *length)
{
    static const struct {
        const char *sign;
        enum ordering ordering;
    } signs[] = {{"!=", IS_UNEQUAL}, {"<=", IS_AT_MOST}, {">=", IS_AT_LEAST}, {"<", IS_BELOW}, {">", IS_ABOVE}, {"=", IS_EQUAL}};
    int depth = 0;
    for (const char *at = text; *at != '\0'; at++) {
        depth += *at == '(' ? 1 : *at == ')' ? -1 : 0;
        for (size_t k = 0; k < sizeof signs / sizeof *signs && depth == 0; k++)
            if (strncmp(at, signs[k].sign, strlen(signs[k].sign)) == 0) {
                *ordering = signs[k].ordering;
                *length = strlen(signs[k].sign);
                return at;
            }
    }
    return NULL;
}

/* left - right of a relation in a scalar, `sign` between them. */
static bool read_difference(struct reading *r, struct assertion *a, const yaml_node_t *node, const char *sign, size_t length)
{
    const char *text = scalar(node), *left = keep(r->all, text, (size_t)(sign - text));
    struct parsing f;
    parsing_open(&f, r);
    const int one = parsing_add(&f, node, left, 0), other = parsing_add(&f, node, sign + length, (size_t)(sign - text) + length);
    if (f.fine) {
        a->formula.node = program_difference(&f.identities.program, one, other);
        a->formula.uses = uses_of(r, &f.identities.program, a->formula.node);
    }
    return parsing_close(&f, &a->formula.program);
}

/* An equality for all values, or a list of them. */
static bool read_identity(struct reading *r, struct assertion *a, const yaml_node_t *node)
{
    struct parsing f;
    parsing_open(&f, r);
    const int count = scalar(node) != NULL ? 1 : length_of(node);
    for (int i = 0; i < count && f.fine; i++)
        f.fine = identities_show(&f.identities, &f.scope, scalar(node) != NULL ? node : item_of(r->document, node, i));
    f.fine = f.fine && identities_close(&f.identities, &f.scope);
    a->everywhere = true;
    a->identity = f.identities;
    if (f.fine && !a->algebra && f.identities.use_count == 0)
        return refuse(r, node, "nothing of the sheet is in it, expected {algebra: left = right} for what is algebra alone");
    return f.fine;
}

/* The same but for blanks. */
static bool same_text(const char *a, const char *a_end, const char *b)
{
    for (;; a++, b++) {
        a += strspn(a, " ");
        b += strspn(b, " ");
        if (a >= a_end || *a != *b)
            return a >= a_end && *b == '\0';
    }
}

static bool read_show(struct reading *r, struct assertion *a, const yaml_node_t *show)
{
    size_t length;
    const char *sign = scalar(show) != NULL ? find_ordering(scalar(show), &a->ordering, &length) : NULL;
    const bool somewhere = own(r, "at") != NULL || own(r, "for") != NULL;
    if (show->type == YAML_SEQUENCE_NODE)
        return is_list(r->document, show, MOST_SHOWN) && read_identity(r, a, show);
    if (sign == NULL)
        return refuse(r, show, "expected left = right, or another sign of < > <= >= != between them");
    if (same_text(scalar(show), sign, sign + length))
        return refuse(r, show, "both sides are the same, expected what could be otherwise");
    return a->ordering == IS_EQUAL && !somewhere ? read_identity(r, a, show) : read_difference(r, a, show, sign, length);
}

/* What rests on no formula of the sheet, and says so. */
static bool read_algebra(struct reading *r, struct assertion *a, const yaml_node_t *value)
{
    a->algebra = true;
    return read_show(r, a, value) && (a->everywhere || refuse(r, value, "expected equalities for all values"));
}

static bool read_count(struct reading *r, const yaml_node_t *node, long *count)
{
    char *end = NULL;
    *count = node != NULL && scalar(node) != NULL ? strtol(scalar(node), &end, 10) : -1;
    return (end != NULL && *end == '\0' && *count >= 0) || refuse(r, node, "expected a count: 0, 1, 2 ...");
}

/* Of the unknown that `of` names. */
static bool read_polynomial(struct reading *r, struct assertion *a, const yaml_node_t *value)
{
    const yaml_node_t *of = own(r, "of");
    a->variable = of != NULL ? scalar(of) : NULL;
    if (a->variable == NULL || a->variable[0] == '\0')
        return refuse(r, of, "missing of, expected the name of the unknown");
    return read_scalar_formula(r, &a->formula, value);
}

static bool read_root(struct reading *r, struct assertion *a, const yaml_node_t *value)
{
    const yaml_node_t *in = own(r, "in");
    if (!read_polynomial(r, a, value))
        return false;
    if (in == NULL || in->type != YAML_SEQUENCE_NODE || length_of(in) != 2)
        return refuse(r, in, "expected in: [low, high]");
    return read_scalar_formula(r, &a->low, item_of(r->document, in, 0)) && read_scalar_formula(r, &a->high, item_of(r->document, in, 1));
}

static bool read_roots(struct reading *r, struct assertion *a, const yaml_node_t *value)
{
    const yaml_node_t *above = own(r, "above"), *below = own(r, "below");
    a->has_low = above != NULL;
    a->has_high = below != NULL;
    return read_polynomial(r, a, value) && (above == NULL || read_scalar_formula(r, &a->low, above)) &&
           (below == NULL || read_scalar_formula(r, &a->high, below)) && read_count(r, own(r, "count"), &a->count);
}

/* One state, its rate, and where it is to be taken. */
static bool read_state(struct reading *r, struct parsing *f, struct linear_system *l, const yaml_node_t *state, const yaml_node_t *rate)
{
    const yaml_node_t *about = given(r, "about"), *place = about != NULL ? child(r->document, about, scalar(state)) : NULL;
    l->states[l->size] = program_find(&f->identities.program, scalar(state));
    if (l->states[l->size] < 0)
        return parse_error(r->document, state, 0, "unknown symbol '%s', expected a quantity or a free name", scalar(state));
    if (scalar(rate) == NULL || (place != NULL && scalar(place) == NULL))
        return refuse(r, rate, "expected a formula");
    l->rates[l->size] = parsing_add(f, rate, scalar(rate), 0);
    l->about[l->size] = place != NULL ? parsing_add(f, place, scalar(place), 0) : -1;
    return f->fine;
}

/* `system` and `about`, in one program. */
static bool read_system(struct reading *r, struct assertion *a)
{
    const yaml_node_t *system = given(r, "system"), *about = given(r, "about"), *control = own(r, "control"), *observe = own(r, "observe");
    struct linear_system *l = &a->system;
    struct parsing f;
    if (system == NULL || !is_mapping(r->document, system, NULL) || length_of(system) > 12 || (about != NULL && !is_mapping(r->document, about, NULL)))
        return refuse(r, system, "expected a system, {state: its rate, ...} of at most 12 states");
    parsing_open(&f, r);
    l->observe = -1;
    for (int i = 0; f.fine && i < length_of(system); i++) {
        const yaml_node_t *state = key_of(r->document, system, i);
        f.fine = read_state(r, &f, l, state, value_of(r->document, system, i));
        if (observe != NULL && scalar(observe) != NULL && strcmp(scalar(observe), scalar(state)) == 0)
            l->observe = i;
        l->size = i + 1;
    }
    l->control = control != NULL && scalar(control) != NULL ? program_find(&f.identities.program, scalar(control)) : -1;
    if (!parsing_close(&f, &l->program))
        return false;
    if ((control != NULL && l->control < 0) || (observe != NULL && l->observe < 0))
        return refuse(r, control != NULL ? control : observe, "expected control: a quantity, or observe: a state");
    for (int i = 0; i < l->size; i++)
        l->uses |= uses_of(r, &l->program, l->rates[i]) | (l->about[i] >= 0 ? uses_of(r, &l->program, l->about[i]) : 0);
    return true;
}

static bool read_characteristic(struct reading *r, struct assertion *a, const yaml_node_t *value)
{
    return read_polynomial(r, a, value) && read_system(r, a);
}

static bool read_rank(struct reading *r, struct assertion *a, const yaml_node_t *value)
{
    return read_count(r, value, &a->count) && read_system(r, a);
}

/* One id, or a list of them, each of which is known. */
static bool read_cited(struct reading *r, struct assertion *a, const yaml_node_t *value, bool (*known)(const struct reading *r, const char *id),
                       const char *expected)
{
    const bool one = value->type != YAML_SEQUENCE_NODE;
    if (!one && !is_list(r->document, value, MOST_CITED))
        return false;
    for (int i = 0; i < (one ? 1 : length_of(value)); i++) {
        const yaml_node_t *node = one ? value : item_of(r->document, value, i);
        if (scalar(node) == NULL || !known(r, scalar(node)))
            return refuse(r, node, expected);
        a->cited[i] = scalar(node);
    }
    return true;
}

static bool is_step(const struct reading *r, const char *id)
{
    const struct derivations *d = &r->all->proofs->derivations;
    for (int i = 0; i < d->step_count; i++)
        if (strcmp(d->steps[i].id, id) == 0)
            return true;
    return false;
}

static bool stands_before(const struct reading *r, const char *id)
{
    const struct statement *cited = statement_find(r->all, id);
    return cited != NULL && cited != r->statement;
}

static bool read_step(struct reading *r, struct assertion *a, const yaml_node_t *value)
{
    return read_cited(r, a, value, is_step, "expected a step of derivations.yaml");
}

static bool read_claim(struct reading *r, struct assertion *a, const yaml_node_t *value)
{
    return read_cited(r, a, value, stands_before, "expected a claim that stands before");
}

static bool read_compute(struct reading *r, struct assertion *a, const yaml_node_t *value)
{
    a->computed = scalar(value) != NULL ? computed_find(&r->all->computed, scalar(value)) : NULL;
    return a->computed != NULL || refuse(r, value, "unknown computation, expected one of verify/claims/claims_*.c");
}

static const struct form {
    const char *key;
    enum assertion_kind kind;
    bool (*read)(struct reading *r, struct assertion *a, const yaml_node_t *value);
} forms[] = {{"show", ASSERT_SHOW, read_show},       {"algebra", ASSERT_SHOW, read_algebra}, {"root", ASSERT_ROOT, read_root},
             {"roots", ASSERT_ROOTS, read_roots},    {"characteristic", ASSERT_CHARACTERISTIC, read_characteristic},
             {"rank", ASSERT_RANK, read_rank},       {"step", ASSERT_STEP, read_step},
             {"claim", ASSERT_CLAIM, read_claim},    {"compute", ASSERT_COMPUTE, read_compute}};

enum { FORMS = sizeof forms / sizeof *forms };

/* for: {name: [value, ...], ...}, lists of one length */
static bool read_turns(struct reading *r, struct assertion *a)
{
    const yaml_node_t *each = own(r, "for");
    if (each == NULL)
        return true;
    if (!is_mapping(r->document, each, NULL) || length_of(each) > MOST_EACH)
        return parse_error(r->document, each, 0, "expected for: {name: [value, ...]} of at most %d names", MOST_EACH);
    for (int i = 0; i < length_of(each); i++) {
        const yaml_node_t *list = value_of(r->document, each, i);
        const int count = read_range(r, list, a->each_of[i], MOST_TURNS);
        a->each[a->each_names++] = scalar(key_of(r->document, each, i));
        if (count <= 0 || (i > 0 && count != a->turns))
            return count < 0 ? false : parse_error(r->document, list, 0, "expected lists of one length, of at most %d values", MOST_TURNS);
        a->turns = count;
    }
    return true;
}

/* on: {name: [low, high]} */
static bool read_interval(struct reading *r, struct assertion *a)
{
    const yaml_node_t *on = own(r, "on");
    struct formula bounds[2];
    memset(bounds, 0, sizeof bounds);
    if (on == NULL)
        return true;
    if (!is_mapping(r->document, on, NULL) || length_of(on) != 1)
        return refuse(r, on, "expected on: {name: [low, high]}");
    const int count = read_range(r, value_of(r->document, on, 0), bounds, 2);
    a->low = bounds[0];
    a->high = bounds[1];
    a->variable = scalar(key_of(r->document, on, 0));
    return count == 2 || (count >= 0 && refuse(r, on, "expected on: {name: [low, high]}"));
}

/* The keys of an entry of `prove`; from CONTEXT on those of `given`, too. */
enum { CONTEXT = 18 };
static const char *const entry_keys[] = {"show", "algebra", "root", "roots", "characteristic", "rank", "step", "claim", "compute", "of", "in", "on", "for",
                                         "above", "below", "count", "control", "observe", "angles", "positive", "free", "small", "order",
                                         "rates", "let", "square roots", "not negative", "at", "system", "about", NULL};

static bool read_assertion(struct reading *r, struct assertion *a)
{
    r->entry = a->node->type == YAML_MAPPING_NODE ? a->node : NULL;
    r->at = NULL;
    if (!read_values(r, &a->at))
        return false;
    if (r->entry == NULL)
        return read_show(r, a, a->node);
    if (!is_mapping(r->document, r->entry, entry_keys) || !read_turns(r, a) || !read_interval(r, a)) /* before the formulas that use them */
        return false;
    for (int i = 0; i < FORMS; i++) {
        const yaml_node_t *value = child(r->document, a->node, forms[i].key);
        a->kind = forms[i].kind;
        if (value != NULL)
            return forms[i].read(r, a, value);
    }
    return refuse(r, a->node, "expected left = right, or one of show, algebra, root, roots, characteristic, rank, step, claim, compute");
}

/* What it takes numbers of stands before it. */
static bool read_uses(struct reading *r, struct assertion *a, int index)
{
    a->uses = a->formula.uses | a->low.uses | a->high.uses | a->system.uses;
    for (int k = 0; k < a->each_names * MOST_TURNS; k++)
        a->uses |= a->each_of[k / MOST_TURNS][k % MOST_TURNS].uses;
    if (a->kind == ASSERT_ROOT && strcmp(a->variable, a->name) == 0)
        a->uses &= ~(UWORD(1) << index); /* the unknown itself */
    return a->uses >> index == 0 || parse_error(r->document, a->node, 0, "'%s' rests on itself, or on what stands after it", a->name);
}

static bool read_prove(struct reading *r, const yaml_node_t *prove)
{
    struct statement *s = r->statement;
    if (prove == NULL)
        return true;
    if (!is_mapping(r->document, prove, NULL))
        return false;
    if (length_of(prove) > MOST_ASSERTIONS)
        return parse_error(r->document, prove, 0, "expected at most %d assertions", MOST_ASSERTIONS);
    s->assertions = xrealloc(NULL, (size_t)length_of(prove), sizeof *s->assertions);
    memset(s->assertions, 0, (size_t)length_of(prove) * sizeof *s->assertions);
    for (int i = 0; i < length_of(prove); i++) {
        struct assertion *a = &s->assertions[s->assertion_count++];
        a->name = scalar(key_of(r->document, prove, i));
        a->node = value_of(r->document, prove, i);
        if (!read_assertion(r, a) || !read_uses(r, a, i))
            return false;
    }
    return true;
}

/* ---- verdicts ---- */

/* Without a condition: all that is to be proved. */
static bool read_verdict(struct reading *r, const yaml_node_t *key, const yaml_node_t *condition)
{
    struct statement *s = r->statement;
    struct message why;
    size_t where;
    int v = HOLDS;
    while (v <= NOT_DECIDABLE && (scalar(key) == NULL || strcmp(verdict_names[v], scalar(key)) != 0))
        v++;
    if (v > NOT_DECIDABLE || s->verdict_count == MOST_VERDICTS)
        return refuse(r, key, "expected a verdict: holds, holds as corrected, qualified, refuted, definition or not decidable");
    struct verdict_condition *c = &s->conditions[s->verdict_count];
    s->verdicts[s->verdict_count++] = (enum verdict)v;
    for (int i = 0; condition == NULL && i < s->assertion_count; i++)
        c->wanted[i] = s->assertions[i].kind != ASSERT_COMPUTE;
    if (condition == NULL)
        return s->assertion_count > 0 || v == NOT_DECIDABLE || refuse(r, key, "expected something to prove; only 'not decidable' needs nothing");
    if (scalar(condition) == NULL)
        return refuse(r, condition, "expected a condition, names of prove");
    return condition_read(c, s, scalar(condition), &where, &why) || parse_error(r->document, condition, where, "%s", why.text);
}

/* Every assertion serves: a condition names it, a number of the evidence or another assertion is made of it. */
static bool all_serve(struct reading *r)
{
    const struct statement *s = r->statement;
    ulong used = 0;
    for (int i = 0; i < s->number_count; i++)
        used |= s->numbers[i].formula.uses;
    for (int i = 0; i < s->assertion_count; i++) {
        used |= s->assertions[i].uses;
        for (int v = 0; v < s->verdict_count; v++)
            used |= (ulong)(s->conditions[v].wanted[i] != 0) << i;
    }
    for (int i = 0; i < s->assertion_count; i++)
        if ((used >> i & 1) == 0)
            return parse_error(r->document, s->assertions[i].node, 0, "'%s' serves no verdict and no number", s->assertions[i].name);
    return true;
}

static bool read_verdicts(struct reading *r, const yaml_node_t *node)
{
    if (node == NULL)
        return refuse(r, r->entry, "missing verdict");
    if (scalar(node) != NULL)
        return read_verdict(r, node, NULL) && all_serve(r);
    if (!is_mapping(r->document, node, NULL) || length_of(node) == 0)
        return refuse(r, node, "expected verdict: {holds: condition, ...}");
    for (int i = 0; i < length_of(node); i++)
        if (!read_verdict(r, key_of(r->document, node, i), value_of(r->document, node, i)))
            return false;
    return all_serve(r);
}

/* ---- evidence ---- */

struct quoting {
    struct reading *reading;
    const yaml_node_t *node;
    bool fine;
};

static void pass(void *context, const char *at, size_t length)
{
    (void)context;
    (void)at;
    (void)length;
}

/* "4", ".2", "exact", "2 up", "2 down" */
static bool read_rounding(const char *text, struct quoted_number *n)
{
    char word[8] = "", end;
    n->rounding = *text == '.' ? TO_DECIMALS : TO_DIGITS;
    if (strcmp(text, "exact") == 0) {
        n->rounding = AS_RATIONAL;
        return true;
    }
    const int count = sscanf(text + (*text == '.'), "%ld %7[a-z]%c", &n->digits, word, &end);
    if (count == 2 && strcmp(word, "up") == 0)
        n->rounding = UPWARD;
    else if (count == 2 && strcmp(word, "down") == 0)
        n->rounding = DOWNWARD;
    else if (count != 1)
        return false;
    return n->digits >= (*text == '.' ? 0 : 1) && n->digits <= 60 && (count == 1 || *text != '.');
}

static const char *keep_trimmed(struct statements *s, const char *from, const char *to)
{
    while (from < to && *from == ' ')
        from++;
    while (from < to && to[-1] == ' ')
        to--;
    return keep(s, from, (size_t)(to - from));
}

/* FORMULA | DIGITS, or FORMULA | DIGITS | UNIT */
static void take_number(void *context, const char *at, size_t length)
{
    struct quoting *q = context;
    struct reading *r = q->reading;
    struct statement *s = r->statement;
    const size_t start = (size_t)(at - s->evidence);
    const char *end = at + length, *bar = memchr(at, '|', length);
    const char *last = bar != NULL ? memchr(bar + 1, '|', (size_t)(end - bar) - 1) : NULL;
    if (!q->fine)
        return;
    s->numbers = xrealloc(s->numbers, (size_t)s->number_count + 1, sizeof *s->numbers);
    struct quoted_number *n = &s->numbers[s->number_count++];
    *n = (struct quoted_number){.node = q->node, .offset = start};
    n->text = keep_trimmed(r->all, at, bar != NULL ? bar : at);
    n->unit = last != NULL ? keep_trimmed(r->all, last + 1, end) : NULL;
    if (bar == NULL || !read_rounding(keep_trimmed(r->all, bar + 1, last != NULL ? last : end), n))
        q->fine = parse_error(r->document, q->node, start + (bar != NULL ? (size_t)(bar - at) + 1 : 0),
                          "expected {FORMULA | DIGITS}, DIGITS being 4, .2, exact, 2 up or 2 down");
    else
        q->fine = read_formula_text(r, &n->formula, q->node, n->text, start + strspn(at, " "));
}

static bool read_marks(struct reading *r, const yaml_node_t *node, bool numbers)
{
    struct quoting quoting = {r, node, true};
    const struct marked_parts parts = {&quoting, pass, pass, numbers ? take_number : NULL};
    struct message why;
    size_t where;
    if (!marked_read(scalar(node), &parts, &where, &why))
        return quoting.fine && parse_error(r->document, node, where, "%s", why.text);
    return quoting.fine;
}

/* ---- statements ---- */

static bool read_words(struct reading *r, const char *key, bool required, const char **text)
{
    const yaml_node_t *node = own(r, key);
    *text = node != NULL ? scalar(node) : NULL;
    if (node == NULL ? required : *text == NULL || **text == '\0')
        return parse_error(r->document, node ? node : r->entry, 0, "missing %s, expected a text", key);
    return node == NULL || strcmp(key, "evidence") == 0 || read_marks(r, node, false);
}

static bool read_texts(struct reading *r, struct statement *s)
{
    static const char *const kinds[] = {"statement", "implied", "misprint", "number", "beyond"};
    s->kind = kinds[0];
    bool known = own(r, "kind") == NULL;
    if (!read_words(r, "where", true, &s->where) || (!known && !read_words(r, "kind", true, &s->kind)))
        return false;
    for (size_t i = 0; i < sizeof kinds / sizeof *kinds; i++)
        known = known || (s->kind != NULL && strcmp(s->kind, kinds[i]) == 0);
    if (!known)
        return refuse(r, own(r, "kind"), "expected a kind: statement, implied, misprint, number or beyond");
    return read_words(r, "claim", true, &s->claim) && read_words(r, "why", false, &s->why) && read_words(r, "evidence", true, &s->evidence);
}

bool has_equation(const struct section *s, const char *equation)
{
    for (int i = 0; i < s->numbers; i++)
        if (strcmp(s->equations[i], equation) == 0)
            return true;
    return false;
}

static bool read_equations(struct reading *r, struct statement *s)
{
    const yaml_node_t *list = own(r, "equations");
    if (list == NULL)
        return true;
    if (!is_list(r->document, list, 8))
        return false;
    for (; s->equation_count < length_of(list); s->equation_count++) {
        const char *number = scalar(item_of(r->document, list, s->equation_count));
        bool known = false;
        for (int i = 0; i < r->all->sheet->section_count; i++)
            known = known || has_equation(&r->all->sheet->sections[i], number);
        if (!known)
            return parse_error(r->document, item_of(r->document, list, s->equation_count), 0, "unknown '%s', expected an equation number", number);
        s->equations[s->equation_count] = number;
    }
    return true;
}

static bool read_statement(struct statements *all, const yaml_node_t *key, const yaml_node_t *node)
{
    static const char *const known[] = {"where", "kind", "claim", "verdict", "why", "given", "prove", "evidence", "equations", NULL};
    if (!is_mapping(&all->document, node, known))
        return false;
    all->list = xrealloc(all->list, (size_t)all->count + 1, sizeof *all->list);
    struct statement *s = &all->list[all->count++];
    *s = (struct statement){.id = scalar(key)};
    struct reading r = {.all = all, .document = &all->document, .statement = s, .entry = node};
    const yaml_node_t *evidence = own(&r, "evidence");
    s->given = own(&r, "given");
    s->prove = own(&r, "prove");
    s->verdict = own(&r, "verdict");
    if ((s->given != NULL && !is_mapping(&all->document, s->given, entry_keys + CONTEXT)) || !read_texts(&r, s) || !read_equations(&r, s) ||
        !read_prove(&r, s->prove))
        return false;
    r.entry = NULL;
    if (!read_values(&r, &s->at) || !read_marks(&r, evidence, true))
        return false;
    r.entry = node;
    if (!read_verdicts(&r, s->verdict))
        return false;
    const bool plain = s->verdicts[0] == HOLDS || s->verdicts[0] == DEFINITION;
    return plain || s->why != NULL || parse_error(&all->document, node, 0, "missing why, of a verdict other than holds and definition");
}

struct statement *statement_find(const struct statements *s, const char *id)
{
    for (int i = 0; i < s->count; i++)
        if (strcmp(s->list[i].id, id) == 0)
            return &s->list[i];
    return NULL;
}

int statements_read(struct statements *s, const struct proof_results *proofs, const struct source *source, struct message *why)
{
    *s = (struct statements){.sheet = proofs->derivations.sheet, .proofs = proofs, .computed.steps = &proofs->derivations};
    if (!document_open(&s->document, source->text, source->length, source->name, why))
        return -1;
    bool fine = is_mapping(&s->document, document_root(&s->document), NULL);
    const yaml_node_t *root = document_root(&s->document);
    for (int i = 0; fine && i < length_of(root); i++)
        fine = read_statement(s, key_of(&s->document, root, i), value_of(&s->document, root, i));
    if (!fine)
        statements_clear(s);
    return fine ? 0 : -1;
}

static void values_clear(struct values *v)
{
    for (int i = 0; i < v->count; i++) {
        program_clear(&v->list[i].formula.program);
        program_clear(&v->list[i].radius.program);
    }
    free(v->list);
}

static void assertion_clear(struct assertion *a)
{
    for (int i = 0; i < MOST_EACH; i++)
        for (int k = 0; k < MOST_TURNS; k++)
            program_clear(&a->each_of[i][k].program);
    program_clear(&a->formula.program);
    program_clear(&a->low.program);
    program_clear(&a->high.program);
    program_clear(&a->system.program);
    values_clear(&a->at);
    if (a->everywhere)
        identities_clear(&a->identity);
}

void statements_clear(struct statements *s)
{
    for (int i = 0; i < s->count; i++) {
        for (int k = 0; k < s->list[i].assertion_count; k++)
            assertion_clear(&s->list[i].assertions[k]);
        for (int k = 0; k < s->list[i].number_count; k++) {
            program_clear(&s->list[i].numbers[k].formula.program);
            free(s->list[i].numbers[k].decimal);
        }
        values_clear(&s->list[i].at);
        free(s->list[i].assertions);
        free(s->list[i].numbers);
    }
    for (int i = 0; i < s->text_count; i++)
        free(s->texts[i]);
    free(s->texts);
    free(s->list);
    computations_clear(&s->computed);
    document_close(&s->document);
    *s = (struct statements){0};
}
