#include "sheet/sheet.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "sheet/known_mistakes.h"
#include "text/decimal.h"
#include "text/document.h"
#include "text/scope.h"

struct reader {
    struct document document;
    struct sheet *sheet;
    bool refused; /* something that need not be there is there and no text: the reading goes on, in vain */
};

static const char *keep_text(struct sheet *s, const char *text)
{
    s->texts = xrealloc(s->texts, (size_t)s->text_count + 1, sizeof *s->texts);
    return s->texts[s->text_count++] = text_copy(text);
}

/* A scalar under a key: kept; NULL and a complaint when it has to be there and is not. */
static const char *text_under(struct reader *r, const yaml_node_t *mapping, const char *key, bool required)
{
    const yaml_node_t *node = child(&r->document, mapping, key);
    if (node == NULL && !required)
        return NULL;
    if (node == NULL || scalar(node) == NULL || *scalar(node) == '\0') {
        r->refused = !parse_error(&r->document, node ? node : mapping, 0, "missing %s, expected a text", key);
        return NULL;
    }
    return keep_text(r->sheet, scalar(node));
}

/* The items of a list of scalars; -1 and a complaint for anything else. */
static int list_of(struct reader *r, const yaml_node_t *node, const yaml_node_t **items, int most)
{
    if (!is_list(&r->document, node, most))
        return -1;
    const int count = length_of(node);
    for (int i = 0; i < count; i++)
        items[i] = item_of(&r->document, node, i);
    return count;
}

/* ---- quantities ---- */

static bool read_domain(struct reader *r, const yaml_node_t *node, enum domain *domain)
{
    static const struct {
        const char *text;
        enum domain domain;
    } domains[] = {{"finite", DOMAIN_FINITE},
                   {"> 0", DOMAIN_POSITIVE},
                   {">= 0", DOMAIN_NOT_NEGATIVE},
                   {"> 0 or inf", DOMAIN_POSITIVE_OR_INFINITE}};
    for (size_t i = 0; i < sizeof domains / sizeof *domains; i++)
        if (scalar(node) != NULL && strcmp(scalar(node), domains[i].text) == 0) {
            *domain = domains[i].domain;
            return true;
        }
    return parse_error(&r->document, node, 0, "expected a domain: finite, > 0, >= 0 or > 0 or inf");
}

static bool read_double(struct reader *r, const yaml_node_t *node, double *value)
{
    char *end = NULL;
    const char *text = scalar(node);
    *value = text != NULL ? strtod(text, &end) : 0.0;
    if (text == NULL || end == text || *end != '\0' || !(*value > 0.0) || isinf(*value))
        return parse_error(&r->document, node, 0, "expected a positive number, finite in binary64");
    return true;
}

static bool read_magnitudes(struct reader *r, const yaml_node_t *mapping, struct quantity *q)
{
    const yaml_node_t *range = child(&r->document, mapping, "range"), *bounds[2];
    if (range == NULL)
        return true;
    int count = list_of(r, range, bounds, 2);
    if (count < 0)
        return false;
    if (count != 2)
        return parse_error(&r->document, range, 0, "expected two bounds, [low, high]");
    if (!read_double(r, bounds[0], &q->low) || !read_double(r, bounds[1], &q->high))
        return false;
    return q->low < q->high || parse_error(&r->document, range, 0, "expected low < high");
}

/* Whether a literal is a number of that domain. */
static bool lies_in_domain(const char *text, enum domain domain)
{
    SCOPE(fmpq, value);
    const enum literal literal = literal_read(value, text, false);
    const int sign = literal == LITERAL_FINITE ? fmpq_sgn(value) : 1;
    if (literal == LITERAL_INFINITE)
        return domain == DOMAIN_POSITIVE_OR_INFINITE;
    return literal == LITERAL_FINITE && (domain == DOMAIN_FINITE || sign > 0 || (sign == 0 && domain == DOMAIN_NOT_NEGATIVE));
}

/* `value` or `example`, which are numbers of the quantity's own domain; NULL where there is none. */
static bool read_own_value(struct reader *r, const yaml_node_t *node, const char *key, enum domain domain, const char **text)
{
    *text = text_under(r, node, key, false);
    return *text == NULL || lies_in_domain(*text, domain) ||
           parse_error(&r->document, child(&r->document, node, key), 0, "expected a number of the quantity's own domain");
}

static bool read_quantity(struct reader *r, const yaml_node_t *key, const yaml_node_t *node)
{
    static const char *const known[] = {"unit",  "domain",  "range",   "sign",
                                        "value", "example", "meaning", NULL};
    struct quantity q = {0};
    if (!is_mapping(&r->document, node, known))
        return false;
    if (child(&r->document, node, "domain") == NULL)
        return parse_error(&r->document, node, 0, "missing domain of '%s'", scalar(key));
    q.unit = text_under(r, node, "unit", true);
    q.meaning = q.unit ? text_under(r, node, "meaning", true) : NULL;
    if (q.meaning == NULL || !read_domain(r, child(&r->document, node, "domain"), &q.domain) ||
        !read_magnitudes(r, node, &q))
        return false;
    const yaml_node_t *sign = child(&r->document, node, "sign");
    if (sign != NULL && (scalar(sign) == NULL || strcmp(scalar(sign), "either") != 0))
        return parse_error(&r->document, sign, 0, "expected 'either'");
    q.either_sign = sign != NULL;
    if (q.either_sign && q.domain != DOMAIN_FINITE)
        return parse_error(&r->document, sign, 0, "expected no sign where the domain has but one");
    if (!read_own_value(r, node, "value", q.domain, &q.value) || !read_own_value(r, node, "example", q.domain, &q.example))
        return false;
    char *names = text_copy(scalar(key)), *rest = NULL;
    bool fine = true;
    for (char *name = strtok_r(names, " ", &rest); name && fine; name = strtok_r(NULL, " ", &rest)) {
        struct sheet *s = r->sheet;
        if (quantity_find(s, name) != NULL)
            fine = parse_error(&r->document, key, 0, "duplicate quantity '%s', expected each name once", name);
        q.name = keep_text(s, name);
        s->quantities = xrealloc(s->quantities, (size_t)s->quantity_count + 1, sizeof q);
        s->quantities[s->quantity_count++] = q;
    }
    free(names);
    return fine;
}

static bool read_quantities(struct reader *r, const yaml_node_t *node)
{
    if (!is_mapping(&r->document, node, NULL))
        return false;
    for (int n = 0; n < length_of(node); n++)
        if (!read_quantity(r, key_of(&r->document, node, n), value_of(&r->document, node, n)))
            return false;
    return true;
}

static bool read_table1(struct reader *r, const yaml_node_t *node)
{
    static const char *const known[] = {"name", "printed", "unit", "scale", NULL};
    struct sheet *s = r->sheet;
    if (node->type != YAML_SEQUENCE_NODE)
        return parse_error(&r->document, node, 0, "expected a list of rows");
    for (int n = 0; n < length_of(node); n++) {
        const yaml_node_t *row = item_of(&r->document, node, n);
        struct table_row t;
        if (!is_mapping(&r->document, row, known) || (t.name = text_under(r, row, "name", true)) == NULL ||
            (t.printed = text_under(r, row, "printed", true)) == NULL ||
            (t.unit = text_under(r, row, "unit", true)) == NULL ||
            (t.scale = text_under(r, row, "scale", true)) == NULL)
            return false;
        if (quantity_find(s, t.name) == NULL)
            return parse_error(&r->document, row, 0, "unknown quantity '%s'", t.name);
        s->table1 = xrealloc(s->table1, (size_t)s->row_count + 1, sizeof t);
        s->table1[s->row_count++] = t;
    }
    return true;
}

/* ---- sections ---- */

static const struct quantity *known_quantity(struct reader *r, const yaml_node_t *node)
{
    const struct sheet *s = r->sheet;
    const struct quantity *q = quantity_find(s, scalar(node));
    if (q == NULL) {
        const char **names = xrealloc(NULL, (size_t)s->quantity_count, sizeof *names);
        for (int i = 0; i < s->quantity_count; i++)
            names[i] = s->quantities[i].name;
        const char *near = nearest_name(scalar(node), names, (size_t)s->quantity_count);
        parse_error(&r->document, node, 0, "unknown symbol '%s', expected a quantity of the sheet%s%s%s",
                 scalar(node), near ? " (did you mean '" : "", near ? near : "", near ? "'?)" : "");
        free(names);
    }
    return q;
}

/* One formula of the program; the node, or -1 and a complaint that points into the formula. */
static int read_formula(struct reader *r, struct program *p, const yaml_node_t *node, const char *text,
                        size_t shift)
{
    struct message expected;
    size_t where;
    int result = program_parse(p, text, &where, &expected);
    if (result < 0)
        parse_error(&r->document, node, shift + where, "%s",
                 expected.text);
    return result;
}

static bool read_lets(struct reader *r, const yaml_node_t *node, struct formulas *f)
{
    if (!is_mapping(&r->document, node, NULL))
        return false;
    for (int n = 0; n < length_of(node); n++) {
        const yaml_node_t *key = key_of(&r->document, node, n), *value = value_of(&r->document, node, n);
        if (program_find(&f->program, scalar(key)) >= 0)
            return parse_error(&r->document, key, 0, "'%s' is an input already, expected a new name", scalar(key));
        if (scalar(value) == NULL)
            return parse_error(&r->document, value, 0, "expected a formula");
        int result = read_formula(r, &f->program, value, scalar(value), 0);
        if (result < 0)
            return false;
        program_name(&f->program, result, scalar(key));
        f->let = xrealloc(f->let, 2 * ((size_t)f->lets + 1), sizeof *f->let);
        f->let[2 * f->lets] = keep_text(r->sheet, scalar(key));
        f->let[2 * f->lets + 1] = keep_text(r->sheet, scalar(value));
        f->lets++;
    }
    return true;
}

static bool read_outputs(struct reader *r, const yaml_node_t *node, struct section *s, struct formulas *f)
{
    if (!is_mapping(&r->document, node, NULL))
        return false;
    int count = 0;
    for (int n = 0; n < length_of(node); n++) {
        const yaml_node_t *key = key_of(&r->document, node, n), *value = value_of(&r->document, node, n);
        const struct quantity *q = known_quantity(r, key);
        if (q == NULL)
            return false;
        if (count == MOST_OUTPUTS || scalar(value) == NULL)
            return parse_error(&r->document, value, 0, "expected a formula, and at most %d of them", MOST_OUTPUTS);
        if (f == &s->corrected)
            s->outputs[s->output_count++] = q;
        else if (count >= s->output_count || s->outputs[count] != q)
            return parse_error(&r->document, key, 0, "expected the outputs of the corrected equation, in its order");
        f->text[count] = keep_text(r->sheet, scalar(value));
        f->outputs[count] = read_formula(r, &f->program, value, scalar(value), 0);
        if (f->outputs[count++] < 0)
            return false;
    }
    return count == s->output_count || parse_error(&r->document, node, 0, "expected %d outputs", s->output_count);
}

/* "formula > formula" becomes the node of left - right, compared with zero. */
static bool read_condition(struct reader *r, const yaml_node_t *node, struct formulas *f)
{
    static const struct {
        const char *sign;
        enum comparison comparison;
    } signs[] = {{">=", NOT_LESS}, {">", GREATER}, {"<", LESS}};
    char *text = text_copy(scalar(node)), *sign = NULL;
    size_t i;
    for (i = 0; i < sizeof signs / sizeof *signs && sign == NULL; i++)
        sign = strstr(text, signs[i].sign);
    if (sign == NULL) {
        free(text);
        return parse_error(&r->document, node, 0, "expected a condition with >, >= or <");
    }
    size_t right_at = (size_t)(sign - text) + strlen(signs[i - 1].sign);
    *sign = '\0';
    int left = read_formula(r, &f->program, node, text, 0);
    int right = left < 0 ? -1 : read_formula(r, &f->program, node, text + right_at, right_at);
    free(text);
    if (right < 0)
        return false;
    f->conditions = xrealloc(f->conditions, (size_t)f->count + 1, sizeof *f->conditions);
    f->conditions[f->count++] =
        (struct condition){keep_text(r->sheet, scalar(node)),
                           program_difference(&f->program, left, right), signs[i - 1].comparison};
    return true;
}

static bool read_conditions(struct reader *r, const yaml_node_t *node, struct formulas *f)
{
    const yaml_node_t *items[8];
    int count = list_of(r, node, items, 8);
    for (int i = 0; i < count; i++)
        if (!read_condition(r, items[i], f))
            return false;
    return count >= 0;
}

/* let, outputs and domain under a section, or under its `printed` */
static bool read_section_formulas(struct reader *r, const yaml_node_t *node, const yaml_node_t *domain,
                                  struct section *s, struct formulas *f)
{
    const yaml_node_t *let = child(&r->document, node, "let"), *outputs = child(&r->document, node, "outputs");
    for (int i = 0; i < s->input_count; i++)
        program_input(&f->program, s->inputs[i]->name);
    if (let != NULL && !read_lets(r, let, f))
        return false;
    if (outputs == NULL)
        return parse_error(&r->document, node, 0, "missing outputs");
    if (!read_outputs(r, outputs, s, f))
        return false;
    return domain == NULL || read_conditions(r, domain, f);
}

static bool read_names(struct reader *r, const yaml_node_t *node, const struct quantity **names,
                       int most, int *count)
{
    const yaml_node_t *items[MOST_INPUTS];
    int found = list_of(r, node, items, most);
    for (int i = 0; i < found; i++) {
        if ((names[i] = known_quantity(r, items[i])) == NULL)
            return false;
        for (int k = 0; k < i; k++)
            if (names[k] == names[i])
                return parse_error(&r->document, items[i], 0, "'%s' twice, expected it once", names[i]->name);
    }
    *count = found < 0 ? 0 : found;
    return found >= 0;
}

/* Both sides of a relation are formulas over the quantities: parsed to be sure, kept as text. */
static bool check_relation(struct reader *r, const yaml_node_t *node)
{
    const char *equal = scalar(node) ? strchr(scalar(node), '=') : NULL;
    if (equal == NULL)
        return parse_error(&r->document, node, 0, "expected left = right");
    struct program p;
    program_init(&p);
    for (int i = 0; i < r->sheet->quantity_count; i++)
        program_input(&p, r->sheet->quantities[i].name);
    char *left = text_copy(scalar(node));
    size_t at = (size_t)(equal - scalar(node));
    left[at] = '\0';
    bool fine = read_formula(r, &p, node, left, 0) >= 0 &&
                read_formula(r, &p, node, equal + 1, at + 1) >= 0;
    free(left);
    program_clear(&p);
    return fine;
}

static bool read_relations(struct reader *r, const yaml_node_t *node, struct section *s)
{
    static const char *const known[] = {"equation", "holds", NULL};
    if (node->type != YAML_SEQUENCE_NODE)
        return parse_error(&r->document, node, 0, "expected a list of relations");
    for (int n = 0; n < length_of(node); n++) {
        const yaml_node_t *item = item_of(&r->document, node, n);
        struct relation relation;
        if (!is_mapping(&r->document, item, known) ||
            (relation.equation = text_under(r, item, "equation", true)) == NULL ||
            (relation.text = text_under(r, item, "holds", true)) == NULL ||
            !check_relation(r, child(&r->document, item, "holds")))
            return false;
        s->relations = xrealloc(s->relations, (size_t)s->relation_count + 1, sizeof relation);
        s->relations[s->relation_count++] = relation;
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
static bool read_special(struct reader *r, const yaml_node_t *key, const yaml_node_t *node,
                         struct section *s)
{
    if (!is_mapping(&r->document, node, NULL))
        return false;
    struct special special = {.name = keep_text(r->sheet, scalar(key))};
    special.flags = text_under(r, node, "flags", true);
    if (special.flags == NULL)
        return false;
    for (int n = 0; n < length_of(node); n++) {
        const yaml_node_t *name = key_of(&r->document, node, n), *value = value_of(&r->document, node, n);
        int i = 0;
        while (i < s->input_count && strcmp(s->inputs[i]->name, scalar(name)) != 0)
            i++;
        if (i == s->input_count && strcmp(scalar(name), "flags") != 0)
            return parse_error(&r->document, name, 0, "'%s' is no input of %s", scalar(name), s->id);
        if (scalar(value) == NULL)
            return parse_error(&r->document, value, 0, "expected a number");
        if (i < s->input_count && !is_literals(scalar(value)))
            return parse_error(&r->document, value, 0, "expected a number");
        if (i < s->input_count)
            special.texts[i] = keep_text(r->sheet, scalar(value));
    }
    s->specials = xrealloc(s->specials, (size_t)s->special_count + 1, sizeof special);
    s->specials[s->special_count++] = special;
    return true;
}

static bool read_specials(struct reader *r, const yaml_node_t *node, struct section *s)
{
    if (!is_mapping(&r->document, node, NULL))
        return false;
    for (int n = 0; n < length_of(node); n++)
        if (!read_special(r, key_of(&r->document, node, n), value_of(&r->document, node, n), s))
            return false;
    return true;
}

/* K: {bound: 8, reason: ...}; as it was where there is none */
static bool read_K(struct reader *r, const yaml_node_t *node, double *K, const char **reason)
{
    static const char *const known[] = {"bound", "reason", NULL};
    if (node == NULL)
        return true;
    if (!is_mapping(&r->document, node, known))
        return false;
    const yaml_node_t *bound = child(&r->document, node, "bound");
    *reason = text_under(r, node, "reason", true);
    if (*reason == NULL)
        return false;
    return bound == NULL ? parse_error(&r->document, node, 0, "missing bound, expected a positive number")
                         : read_double(r, bound, K);
}

/* NAME: formula, under inputs, let or outputs of a mistake */
static bool read_changes(struct reader *r, const yaml_node_t *node, enum place place, struct known_mistake *mistake)
{
    if (!is_mapping(&r->document, node, NULL))
        return false;
    for (int n = 0; n < length_of(node); n++) {
        const yaml_node_t *value = value_of(&r->document, node, n);
        if (scalar(value) == NULL || mistake->count == MOST_CHANGES)
            return parse_error(&r->document, value, 0, "expected a formula, and at most %d of them", MOST_CHANGES);
        mistake->changes[mistake->count].place = place;
        mistake->changes[mistake->count].name = keep_text(r->sheet, scalar(key_of(&r->document, node, n)));
        mistake->changes[mistake->count++].formula = keep_text(r->sheet, scalar(value));
    }
    return true;
}

/* name: {inputs: {...}, let: {...}, outputs: {...}, as: SECTION} */
static bool read_mistake(struct reader *r, const char *name, const yaml_node_t *node, struct known_mistake *mistake)
{
    static const char *const known[] = {"inputs", "let", "outputs", "as", NULL};
    *mistake = (struct known_mistake){.name = keep_text(r->sheet, name)};
    if (!is_mapping(&r->document, node, known))
        return false;
    for (int place = PLACE_INPUT; place <= PLACE_OUTPUT; place++) {
        const yaml_node_t *changes = child(&r->document, node, known[place]);
        if (changes != NULL && !read_changes(r, changes, (enum place)place, mistake))
            return false;
    }
    mistake->as = text_under(r, node, "as", false);
    return true;
}

static bool read_mistakes(struct reader *r, const yaml_node_t *node, struct known_mistake **mistakes, int *count)
{
    if (node == NULL)
        return true;
    if (!is_mapping(&r->document, node, NULL))
        return false;
    for (int n = 0; n < length_of(node); n++) {
        *mistakes = xrealloc(*mistakes, (size_t)*count + 1, sizeof **mistakes);
        if (!read_mistake(r, scalar(key_of(&r->document, node, n)), value_of(&r->document, node, n), &(*mistakes)[(*count)++]))
            return false;
    }
    return true;
}

/* A section's own mistakes make sense in it; `as` may name a section that stands further down. */
static bool check_known_mistakes(struct reader *r, const yaml_node_t *equations)
{
    for (int i = 0; i < r->sheet->section_count; i++) {
        const struct section *s = &r->sheet->sections[i];
        for (int k = 0; k < s->mistake_count; k++) {
            const yaml_node_t *section = child(&r->document, equations, s->id);
            const yaml_node_t *at = child(&r->document, child(&r->document, section, "mistakes"), s->mistakes[k].name);
            struct mutation a;
            struct message why;
            if (!mutation_init(&a, r->sheet, s, &s->mistakes[k], true, &why))
                return parse_error(&r->document, at, 0, "%.300s", why.text);
            mutation_clear(&a);
        }
    }
    return true;
}

static bool read_equation_numbers(struct reader *r, const yaml_node_t *section, struct section *s)
{
    const yaml_node_t *items[8], *node = child(&r->document, section, "equations");
    if (node == NULL)
        return parse_error(&r->document, section, 0, "missing equations: the numbers this section stands for");
    s->numbers = list_of(r, node, items, 8);
    for (int i = 0; i < s->numbers; i++)
        s->equations[i] = keep_text(r->sheet, scalar(items[i]));
    return s->numbers > 0 || parse_error(&r->document, node, 0, "expected at least one equation number");
}

static bool read_method(struct reader *r, const yaml_node_t *section, struct section *s)
{
    static const char *const names[] = {"roots",          "flow_linear", "flow_nonlinear",
                                        "rk4_linear", "rk4_nonlinear"};
    const yaml_node_t *node = child(&r->document, section, "method"), *inputs = child(&r->document, section, "inputs");
    const yaml_node_t *outputs = child(&r->document, section, "outputs");
    if (inputs != NULL && !read_names(r, inputs, s->inputs, MOST_INPUTS, &s->input_count))
        return false;
    if (node == NULL) {
        s->method = outputs != NULL ? METHOD_FORMULA : METHOD_NONE;
        return true;
    }
    for (size_t i = 0; i < sizeof names / sizeof *names; i++)
        if (scalar(node) != NULL && strcmp(scalar(node), names[i]) == 0)
            s->method = (enum method)(METHOD_ROOTS + (int)i);
    if (s->method == METHOD_NONE)
        return parse_error(&r->document, node, 0, "expected a method: roots, flow_ or rk4_ linear or nonlinear");
    if (outputs == NULL || inputs == NULL)
        return parse_error(&r->document, section, 0, "missing %s", inputs ? "outputs" : "inputs");
    return read_names(r, outputs, s->outputs, MOST_OUTPUTS, &s->output_count);
}

static bool read_domain_alone(struct reader *r, const yaml_node_t *domain, struct section *s)
{
    for (int i = 0; i < s->input_count; i++)
        program_input(&s->corrected.program, s->inputs[i]->name);
    return domain == NULL || read_conditions(r, domain, &s->corrected);
}

static bool read_section(struct reader *r, const yaml_node_t *key, const yaml_node_t *node)
{
    static const char *const known[] = {"title",   "equations", "inputs",  "let",    "outputs", "domain",
                                        "printed", "relations", "reason", "method", "note",   "vectors", "K", "mistakes", "defines", NULL};
    struct sheet *sheet = r->sheet;
    if (!is_mapping(&r->document, node, known))
        return false;
    sheet->sections = xrealloc(sheet->sections, (size_t)sheet->section_count + 1, sizeof *sheet->sections);
    struct section *s = &sheet->sections[sheet->section_count++];
    *s = (struct section){.sheet = sheet, .id = keep_text(sheet, scalar(key)), .K = sheet->K, .K_reason = sheet->K_reason};
    const yaml_node_t *domain = child(&r->document, node, "domain"), *printed = child(&r->document, node, "printed");
    const yaml_node_t *relations = child(&r->document, node, "relations"), *specials = child(&r->document, node, "vectors");
    s->title = text_under(r, node, "title", true);
    s->note = text_under(r, node, "note", false);
    s->defines = text_under(r, node, "defines", false);
    s->reason = text_under(r, node, "reason", printed != NULL);
    if (s->title == NULL || (printed != NULL && s->reason == NULL) || !read_equation_numbers(r, node, s) ||
        !read_method(r, node, s) || (relations != NULL && !read_relations(r, relations, s)) ||
        (specials != NULL && !read_specials(r, specials, s)) ||
        !read_K(r, child(&r->document, node, "K"), &s->K, &s->K_reason) ||
        !read_mistakes(r, child(&r->document, node, "mistakes"), &s->mistakes, &s->mistake_count))
        return false;
    if (s->method != METHOD_FORMULA)
        return read_domain_alone(r, domain, s);
    if (!read_section_formulas(r, node, domain, s, &s->corrected))
        return false;
    if (printed == NULL)
        return true;
    s->differs = true;
    static const char *const variant[] = {"let", "outputs", "domain", NULL};
    if (!is_mapping(&r->document, printed, variant))
        return false;
    const yaml_node_t *own = child(&r->document, printed, "domain");
    return read_section_formulas(r, printed, own ? own : domain, s, &s->printed);
}

static bool read_sheet(struct reader *r)
{
    static const char *const known[] = {"quantities", "table1", "equations", "K", "mistakes", NULL};
    const yaml_node_t *root = document_root(&r->document);
    if (!is_mapping(&r->document, root, known))
        return false;
    for (int i = 0; i < 3; i++) /* the oracle's keys need not be there */
        if (child(&r->document, root, known[i]) == NULL)
            return parse_error(&r->document, root, 0, "missing %s", known[i]);
    const yaml_node_t *equations = child(&r->document, root, "equations");
    if (!read_quantities(r, child(&r->document, root, "quantities")) ||
        !read_table1(r, child(&r->document, root, "table1")) || !is_mapping(&r->document, equations, NULL) ||
        !read_K(r, child(&r->document, root, "K"), &r->sheet->K, &r->sheet->K_reason) ||
        !read_mistakes(r, child(&r->document, root, "mistakes"), &r->sheet->mistakes, &r->sheet->mistake_count))
        return false;
    for (int n = 0; n < length_of(equations); n++)
        if (!read_section(r, key_of(&r->document, equations, n), value_of(&r->document, equations, n)))
            return false;
    return check_known_mistakes(r, equations) && !r->refused;
}

int sheet_read(struct sheet *s, const char *text, size_t length, const char *name, struct message *why)
{
    struct reader r = {.sheet = s};
    *s = (struct sheet){0};
    if (!document_open(&r.document, text, length, name, why))
        return -1;
    bool fine = read_sheet(&r);
    document_close(&r.document);
    if (!fine)
        sheet_clear(s);
    return fine ? 0 : -1;
}
