/* equations.yaml: what its keys may be, as tables; then names are looked up and formulas parsed. */
#include "sheet/sheet.h"

#include <stddef.h>
#include <stdlib.h>
#include <string.h>

#include "sheet/input.h"
#include "sheet/known_mistakes.h"
#include "text/decimal.h"
#include "text/scope.h"

/* ---- quantities ---- */

const char *const domain_names[] = {"finite", "> 0", ">= 0", "> 0 or inf", NULL};
static const char *const signs[] = {"either", NULL};

struct written_quantity {
    struct quantity q;
    int sign; /* -1: none */
    const struct yaml *range;
};

static const struct field quantity_fields[] = {
    FIELD("unit", struct written_quantity, q.unit, FIELD_TEXT, .expected = "a text"),
    FIELD("meaning", struct written_quantity, q.meaning, FIELD_TEXT, .expected = "a text"),
    FIELD("domain", struct written_quantity, q.domain, FIELD_WORD, .expected = "a domain", .words = domain_names),
    FIELD("range", struct written_quantity, range, FIELD_NODE),
    FIELD("sign", struct written_quantity, sign, FIELD_WORD, .words = signs),
    FIELD("value", struct written_quantity, q.value, FIELD_TEXT),
    FIELD("example", struct written_quantity, q.example, FIELD_TEXT),
    {.key = NULL}};

static bool read_range(const struct yaml *range, struct quantity *q)
{
    if (!is_texts(range, 2))
        return false;
    if (range->count != 2)
        return node_error(range, 0, "expected two bounds, [low, high]");
    return is_positive_number(&range->items[0], &q->low) && is_positive_number(&range->items[1], &q->high) &&
           (q->low < q->high || node_error(range, 0, "expected low < high"));
}

/* Whether a literal is a number of that domain. */
static bool lies_in_domain(const char *text, enum domain domain)
{
    INPUTS(x);
    return input_read(x, text) && input_in_domain(x, domain);
}

static bool read_quantities(struct sheet *s, const struct yaml *all)
{
    for (int i = 0; i < all->count; i++) {
        const struct yaml *n = &all->items[i];
        struct written_quantity w = {.q.name = n->key, .sign = -1};
        if (!fields_read(n, quantity_fields, &w) || (w.range != NULL && !read_range(w.range, &w.q)))
            return false;
        w.q.either_sign = w.sign >= 0;
        if (w.q.either_sign && w.q.domain != DOMAIN_FINITE)
            return node_error(under(n, "sign"), 0, "expected no sign where the domain has but one");
        for (int k = 0; k < 2; k++) {
            const struct yaml *own = under(n, k == 0 ? "value" : "example");
            if (own != NULL && !lies_in_domain(own->text, w.q.domain))
                return node_error(own, 0, "expected a number of the quantity's own domain");
        }
        *APPENDED(s->quantities, s->quantity_count) = w.q;
    }
    return true;
}

/* `name`: the node's text, or its key. */
static const struct quantity *known_quantity(const struct sheet *s, const struct yaml *n, const char *name)
{
    const struct quantity *q = quantity_find(s, name);
    if (q != NULL)
        return q;
    const char *near = NEAREST(name, s->quantities, s->quantity_count, name);
    node_error(n, name == n->key ? AT_KEY : 0, "unknown symbol '%s', expected a quantity of the sheet%s%s%s", name,
               near ? " (did you mean '" : "", near ? near : "", near ? "'?)" : "");
    return NULL;
}

static const struct field row_fields[] = {FIELD("name", struct table_row, name, FIELD_TEXT, .expected = "a text"),
                                          FIELD("printed", struct table_row, printed, FIELD_TEXT, .expected = "a text"),
                                          FIELD("unit", struct table_row, unit, FIELD_TEXT, .expected = "a text"),
                                          FIELD("scale", struct table_row, scale, FIELD_TEXT, .expected = "a text"),
                                          {.key = NULL}};

static bool read_table1(struct sheet *s, const struct yaml *rows)
{
    for (int i = 0; i < rows->count; i++) {
        struct table_row *row = APPENDED(s->table1, s->row_count);
        if (!fields_read(&rows->items[i], row_fields, row))
            return false;
        if (quantity_find(s, row->name) == NULL)
            return node_error(&rows->items[i], 0, "unknown quantity '%s'", row->name);
    }
    return true;
}

/* ---- formulas ---- */

/* Both sides of a sign that stands in a text, or the first alone. */
static bool read_sides(struct program *p, const struct yaml *n, const char *sign, size_t length, int count, int *sides)
{
    char *left = text_copy(n->text);
    const size_t at = (size_t)(sign - n->text);
    left[at] = '\0';
    sides[0] = program_read(p, n, left, 0, NULL, NULL);
    free(left);
    if (count > 1 && sides[0] >= 0)
        sides[1] = program_read(p, n, sign + length, at + length, NULL, NULL);
    return sides[0] >= 0 && sides[count - 1] >= 0;
}

static bool read_lets(const struct yaml *let, struct formulas *f)
{
    for (int i = 0; i < let->count; i++) {
        const struct yaml *n = &let->items[i];
        if (program_find(&f->program, n->key) >= 0)
            return node_error(n, AT_KEY, "'%s' is an input already, expected a new name", n->key);
        const int result = is_text(n, "a formula") ? program_read(&f->program, n, n->text, 0, NULL, NULL) : -1;
        if (result < 0)
            return false;
        program_name(&f->program, result, n->key);
        f->let = xrealloc(f->let, 2 * ((size_t)f->lets + 1), sizeof *f->let);
        f->let[2 * f->lets] = n->key;
        f->let[2 * f->lets++ + 1] = n->text;
    }
    return true;
}

static bool read_outputs(const struct sheet *sheet, const struct yaml *outputs, struct section *s, struct formulas *f)
{
    int count = 0;
    for (; count < outputs->count; count++) {
        const struct yaml *n = &outputs->items[count];
        const struct quantity *q = known_quantity(sheet, n, n->key);
        if (q == NULL)
            return false;
        if (count == MOST_OUTPUTS || n->text == NULL)
            return node_error(n, 0, "expected a formula, and at most %d of them", MOST_OUTPUTS);
        if (f == &s->corrected)
            s->outputs[s->output_count++] = q;
        else if (count >= s->output_count || s->outputs[count] != q)
            return node_error(n, AT_KEY, "expected the outputs of the corrected equation, in its order");
        f->text[count] = n->text;
        f->outputs[count] = program_read(&f->program, n, n->text, 0, NULL, NULL);
        if (f->outputs[count] < 0)
            return false;
    }
    return count == s->output_count || node_error(outputs, 0, "expected %d outputs", s->output_count);
}

/* "formula > formula" becomes the node of left - right, compared with zero; "formula an integer" that of the formula. */
static bool read_condition(const struct yaml *n, struct formulas *f)
{
    static const struct {
        const char *sign;
        enum comparison comparison;
    } comparisons[] = {{" an integer", INTEGER}, {">=", NOT_LESS}, {">", GREATER}, {"<", LESS}};
    const char *sign = NULL;
    int k = 0, sides[2];
    while (k < 4 && (sign = strstr(n->text, comparisons[k].sign)) == NULL)
        k++;
    if (sign == NULL || (comparisons[k].comparison == INTEGER && strlen(sign) > strlen(comparisons[k].sign)))
        return node_error(n, 0, "expected a condition with >, >= or <, or that ends in 'an integer'");
    const bool integer = comparisons[k].comparison == INTEGER;
    if (!read_sides(&f->program, n, sign, strlen(comparisons[k].sign), integer ? 1 : 2, sides))
        return false;
    const int node = integer ? sides[0] : program_append(&f->program, OPERATOR_SUBTRACT, sides[0], sides[1], 0);
    *APPENDED(f->conditions, f->count) = (struct condition){n->text, node, comparisons[k].comparison};
    return true;
}

/* A function of rational inputs that is rational itself: it can be compared with zero exactly. */
static bool is_rational(const struct program *p, int node)
{
    bool rational = true;
    char *needed = program_needs(p, node, NULL);
    for (int i = 0; i <= node; i++)
        rational = rational && (!needed[i] || p->nodes[i].op <= OPERATOR_POWER);
    free(needed);
    return rational;
}

static bool read_conditions(const struct yaml *domain, struct formulas *f)
{
    bool fine = domain == NULL || is_texts(domain, 8);
    for (int i = 0; domain != NULL && i < domain->count && fine; i++)
        fine = read_condition(&domain->items[i], f) &&
               (is_rational(&f->program, f->conditions[i].node) ||
                node_error(&domain->items[i], 0, "expected a condition without functions: it is decided exactly"));
    return fine;
}

/* ---- sections ---- */

/* Under a section, and under its `printed`. */
struct written_formulas {
    const struct yaml *let, *outputs, *domain;
};

struct written_section {
    struct section s;
    int method, kind; /* method -1: none */
    const struct yaml *inputs, *printed, *relations, *vectors, *K, *mistakes;
    struct written_formulas f;
};

static const char *const methods[] = {"roots", "flow_linear", "flow_nonlinear", "rk4_linear", "rk4_nonlinear", NULL};
static const char *const kinds[] = {"equation", "beyond", NULL};

static const struct field section_fields[] = {
    FIELD("title", struct written_section, s.title, FIELD_TEXT, .expected = "a text"),
    FIELD("equations", struct written_section, s.equations, FIELD_TEXTS, .most = 8,
          .count = offsetof(struct written_section, s.numbers), .expected = "the equation numbers that it stands for"),
    FIELD("kind", struct written_section, kind, FIELD_WORD, .words = kinds),
    FIELD("note", struct written_section, s.note, FIELD_TEXT),
    FIELD("defines", struct written_section, s.defines, FIELD_TEXT),
    FIELD("reason", struct written_section, s.reason, FIELD_TEXT),
    FIELD("method", struct written_section, method, FIELD_WORD, .words = methods),
    FIELD("inputs", struct written_section, inputs, FIELD_NODE),
    FIELD("let", struct written_section, f.let, FIELD_MAP),
    FIELD("outputs", struct written_section, f.outputs, FIELD_NODE),
    FIELD("domain", struct written_section, f.domain, FIELD_NODE),
    FIELD("printed", struct written_section, printed, FIELD_MAP),
    FIELD("relations", struct written_section, relations, FIELD_LIST),
    FIELD("vectors", struct written_section, vectors, FIELD_MAP),
    FIELD("K", struct written_section, K, FIELD_MAP),
    FIELD("mistakes", struct written_section, mistakes, FIELD_MAP),
    {.key = NULL}};

static const struct field formulas_fields[] = {
    FIELD("let", struct written_formulas, let, FIELD_MAP),
    FIELD("outputs", struct written_formulas, outputs, FIELD_MAP, .expected = "formulas"),
    FIELD("domain", struct written_formulas, domain, FIELD_NODE),
    {.key = NULL}};

static bool read_formulas(const struct sheet *sheet, const struct written_formulas *w, struct section *s, struct formulas *f)
{
    for (int i = 0; i < s->input_count; i++)
        program_input(&f->program, s->inputs[i]->name);
    return (w->let == NULL || read_lets(w->let, f)) &&
           (s->method != METHOD_FORMULA || (w->outputs != NULL && is_map(w->outputs) && read_outputs(sheet, w->outputs, s, f))) &&
           read_conditions(w->domain, f);
}

static bool read_names(const struct sheet *sheet, const struct yaml *list, const struct quantity **names, int most, int *count)
{
    if (!is_texts(list, most))
        return false;
    for (int i = 0; i < list->count; i++) {
        if ((names[i] = known_quantity(sheet, &list->items[i], list->items[i].text)) == NULL)
            return false;
        for (int k = 0; k < i; k++)
            if (names[k] == names[i])
                return node_error(&list->items[i], 0, "'%s' twice, expected it once", names[i]->name);
    }
    *count = list->count;
    return true;
}

/* The paper's case, which golden vectors and --table1 begin with, has a number for every input. */
static bool have_values(const struct yaml *list, const struct section *s)
{
    for (int i = 0; i < list->count; i++)
        if (s->inputs[i]->value == NULL && s->inputs[i]->example == NULL)
            return node_error(&list->items[i], 0, "expected an input that has a value or an example, '%s' has neither", s->inputs[i]->name);
    return true;
}

static const struct field relation_fields[] = {FIELD("equation", struct relation, equation, FIELD_TEXT, .expected = "a text"),
                                               FIELD("holds", struct relation, text, FIELD_TEXT, .expected = "left = right"),
                                               {.key = NULL}};

static bool read_relation(const struct sheet *s, const struct yaml *n, struct formulas *f)
{
    const char *sign = strchr(n->text, '=');
    if (sign == NULL)
        return node_error(n, 0, "expected left = right");
    for (int i = 0; i < s->quantity_count; i++)
        program_input(&f->program, s->quantities[i].name);
    return read_sides(&f->program, n, sign, 1, 2, f->outputs);
}

static bool read_relations(const struct sheet *sheet, const struct yaml *list, struct section *s)
{
    for (int i = 0; list != NULL && i < list->count; i++) {
        struct relation *r = APPENDED(s->relations, s->relation_count);
        if (!fields_read(&list->items[i], relation_fields, r) || !read_relation(sheet, under(&list->items[i], "holds"), &r->sides))
            return false;
    }
    return true;
}

/* Numbers between blanks, at least one; nan and the infinities are for what the domain has to refuse. */
static bool is_literals(const char *texts)
{
    char *copy = text_copy(texts), *rest = NULL;
    SCOPE(fmpq, value);
    bool fine = true;
    int count = 0;
    for (char *text = strtok_r(copy, " ", &rest); text != NULL; text = strtok_r(NULL, " ", &rest), count++) {
        const enum literal literal = literal_read(value, text, false);
        fine = fine && literal != LITERAL_MALFORMED && literal != LITERAL_OVERFLOW;
    }
    free(copy);
    return fine && count > 0;
}

/* name: {INPUT: literal, ..., flags: what it is there for} */
static bool read_special(const struct yaml *n, struct section *s)
{
    struct special *special = APPENDED(s->specials, s->special_count);
    special->name = n->key;
    if (!is_map(n))
        return false;
    for (int k = 0; k < n->count; k++) {
        const struct yaml *value = &n->items[k];
        const int i = input_place(s, value->key);
        if (strcmp(value->key, "flags") == 0)
            special->flags = value->text;
        else if (i < 0)
            return node_error(value, AT_KEY, "'%s' is no input of %s", value->key, s->id);
        else if (value->text == NULL || !is_literals(value->text))
            return node_error(value, 0, "expected a number");
        else
            special->texts[i] = value->text;
    }
    return special->flags != NULL || node_error(n, 0, "missing flags, expected a text");
}

struct tolerance {
    const struct yaml *bound;
    const char *reason;
};

static const struct field tolerance_fields[] = {
    FIELD("reason", struct tolerance, reason, FIELD_TEXT, .expected = "a text"),
    FIELD("bound", struct tolerance, bound, FIELD_NODE, .expected = "a positive number"),
    {.key = NULL}};

/* K: {bound: 8, reason: ...}; as it was where there is none */
static bool read_K(const struct yaml *n, double *K)
{
    struct tolerance t = {.bound = NULL};
    return n == NULL || (fields_read(n, tolerance_fields, &t) && is_positive_number(t.bound, K));
}

struct written_mistake {
    const char *as;
    const struct yaml *changes[PLACE_OUTPUT + 1];
};

static const struct field mistake_fields[] = {
    FIELD("as", struct written_mistake, as, FIELD_TEXT),
    FIELD("inputs", struct written_mistake, changes[PLACE_INPUT], FIELD_MAP),
    FIELD("let", struct written_mistake, changes[PLACE_LET], FIELD_MAP),
    FIELD("outputs", struct written_mistake, changes[PLACE_OUTPUT], FIELD_MAP),
    {.key = NULL}};

/* name: {inputs: {NAME: formula}, let: {...}, outputs: {...}, as: SECTION} */
static bool read_mistakes(const struct yaml *all, struct known_mistake **mistakes, int *count)
{
    for (int i = 0; all != NULL && i < all->count; i++) {
        struct known_mistake *m = APPENDED(*mistakes, *count);
        struct written_mistake w = {.as = NULL};
        m->name = all->items[i].key;
        if (!fields_read(&all->items[i], mistake_fields, &w))
            return false;
        m->as = w.as;
        for (int place = PLACE_INPUT; place <= PLACE_OUTPUT; place++)
            for (int k = 0; w.changes[place] != NULL && k < w.changes[place]->count; k++) {
                const struct yaml *n = &w.changes[place]->items[k];
                if (n->text == NULL || m->count == MOST_CHANGES)
                    return node_error(n, 0, "expected a formula, and at most %d of them", MOST_CHANGES);
                m->changes[m->count].place = (enum place)place;
                m->changes[m->count].name = n->key;
                m->changes[m->count++].formula = n->text;
            }
    }
    return true;
}

/* A section's own mistakes make sense in it; `as` may name a section that stands further down. */
static bool check_known_mistakes(const struct sheet *sheet, const struct yaml *equations)
{
    for (int i = 0; i < sheet->section_count; i++) {
        const struct section *s = &sheet->sections[i];
        for (int k = 0; k < s->mistake_count; k++) {
            struct mutation a;
            struct message why;
            if (!mutation_init(&a, sheet, s, &s->mistakes[k], true, &why))
                return node_error(under(under(under(equations, s->id), "mistakes"), s->mistakes[k].name), 0, "%.300s", why.text);
            mutation_clear(&a);
        }
    }
    return true;
}

static bool read_section(struct sheet *sheet, const struct yaml *n)
{
    struct written_section w = {.method = -1, .s = {.sheet = sheet, .id = n->key, .K = sheet->K}};
    const bool fine = fields_read(n, section_fields, &w);
    struct section *s = APPENDED(sheet->sections, sheet->section_count);
    *s = w.s;
    if (!fine)
        return false;
    if (w.printed != NULL && s->reason == NULL)
        return node_error(n, 0, "missing reason, expected a text");
    s->kind = kinds[w.kind];
    s->method = w.method >= 0 ? (enum method)(METHOD_ROOTS + w.method) : w.f.outputs != NULL ? METHOD_FORMULA : METHOD_NONE;
    if (w.method >= 0 && (w.inputs == NULL || w.f.outputs == NULL))
        return node_error(n, 0, "missing %s", w.inputs != NULL ? "outputs" : "inputs");
    if ((w.inputs != NULL && (!read_names(sheet, w.inputs, s->inputs, MOST_INPUTS, &s->input_count) || !have_values(w.inputs, s))) ||
        (w.method >= 0 && !read_names(sheet, w.f.outputs, s->outputs, MOST_OUTPUTS, &s->output_count)) ||
        !read_relations(sheet, w.relations, s) || !read_K(w.K, &s->K) ||
        !read_mistakes(w.mistakes, &s->mistakes, &s->mistake_count))
        return false;
    for (int i = 0; w.vectors != NULL && i < w.vectors->count; i++)
        if (!read_special(&w.vectors->items[i], s))
            return false;
    if (!read_formulas(sheet, &w.f, s, &s->corrected))
        return false;
    s->differs = w.printed != NULL;
    struct written_formulas printed = {.domain = w.f.domain};
    return !s->differs || (fields_read(w.printed, formulas_fields, &printed) && read_formulas(sheet, &printed, s, &s->printed));
}

struct written_sheet {
    const struct yaml *quantities, *table1, *equations, *K, *mistakes;
};

static const struct field sheet_fields[] = {
    FIELD("quantities", struct written_sheet, quantities, FIELD_MAP, .expected = "{symbol: {unit: ..., ...}, ...}"),
    FIELD("table1", struct written_sheet, table1, FIELD_LIST, .expected = "a list of rows"),
    FIELD("equations", struct written_sheet, equations, FIELD_MAP, .expected = "sections"),
    FIELD("K", struct written_sheet, K, FIELD_MAP),
    FIELD("mistakes", struct written_sheet, mistakes, FIELD_MAP),
    {.key = NULL}};

static bool read_sheet(struct sheet *s)
{
    struct written_sheet w = {.K = NULL};
    if (!fields_read(&s->tree->root, sheet_fields, &w) || !read_quantities(s, w.quantities) || !read_table1(s, w.table1) ||
        !read_K(w.K, &s->K) || !read_mistakes(w.mistakes, &s->mistakes, &s->mistake_count))
        return false;
    for (int i = 0; i < w.equations->count; i++)
        if (!read_section(s, &w.equations->items[i]))
            return false;
    return check_known_mistakes(s, w.equations);
}

int sheet_read(struct sheet *s, const char *text, size_t length, const char *name, struct message *why)
{
    *s = (struct sheet){.tree = tree_open(text, length, name, why)};
    if (s->tree != NULL && read_sheet(s))
        return 0;
    sheet_clear(s);
    return -1;
}
