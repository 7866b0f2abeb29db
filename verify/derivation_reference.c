/*
 * The formulas of a derivation step. Beside the names in scope they may say
 *
 *     eq10.x1                   an output of a section of the sheet, or a named subexpression of it; inputs
 *                               are bound by name to what is in scope, and a free name of the step takes
 *                               the place of a named subexpression of that name
 *     eq40.psi_ddot(psi = 1)    ... with other values for some of them
 *     eq30.I_22@printed         ... as the paper has it
 *     left(6a), right(24, 2)    a side of a relation of the sheet: of (6a), of the second that (24) has
 *     rate(x1)                  the derivative by time: what the step's `rates` names moves
 */
#include <stdlib.h>
#include <string.h>

#include "derivation_reader.h"

/* -1, the mistake being the name that was just passed. */
static int unknown_name(struct parser *s, const char *name, const char *kind, const char *expected)
{
    s->at -= strlen(name);
    message_set(s->why, "unknown %s '%s', expected %s", kind, name, expected);
    return -1;
}

enum { MOST_MOVING = 10000 }; /* nodes: a rate of so many has some times as many */

static int read_rate(struct parser *s)
{
    const struct reader *r = s->context;
    const yaml_node_t *rates = child(r->document, r->step, "rates");
    s->at++; /* the bracket, without which it were a name */
    int node = parse_sum(s);
    if (node < 0 || !parse_symbol(s, ')'))
        return node < 0 ? -1 : parse_refuse(s, "')' or an operator");
    const int count = s->program->count;
    if (count > MOST_MOVING)
        return parse_refuse(s, "fewer rates of rates");
    int *rate = memory(NULL, (size_t)count, sizeof *rate);
    for (int i = 0; i < count; i++)
        rate[i] = -1;
    for (int i = 0; rates != NULL && i < length_of(rates); i++) {
        int moving = program_find(s->program, scalar(key_of(r->document, rates, i)));
        if (moving >= 0)
            rate[moving] = program_find(s->program, scalar(value_of(r->document, rates, i)));
    }
    node = program_derivative(s->program, node, rate, count);
    free(rate);
    return node;
}

/* The relation of that number, the first, second ... ("1", "2" ...) of them; NULL when there is none. */
static const struct relation *find_relation(const struct sheet *sheet, const char *number, const char *index)
{
    char *end;
    long left = strtol(index, &end, 10);
    if (*end != '\0')
        return NULL;
    for (int i = 0; i < sheet->section_count; i++)
        for (int k = 0; k < sheet->sections[i].relation_count; k++) {
            const struct relation *relation = &sheet->sections[i].relations[k];
            if (strcmp(relation->equation, number) == 0 && --left == 0)
                return relation;
        }
    return NULL;
}

static int read_side(struct parser *s, bool right)
{
    const struct reader *r = s->context;
    const char *begin = s->at;
    char number[LONGEST_NAME + 1], index[LONGEST_NAME + 1] = "1";
    s->at++;
    if (!parse_word(s, number) || (parse_symbol(s, ',') && !parse_word(s, index)))
        return -1;
    if (!parse_symbol(s, ')'))
        return parse_refuse(s, "',' or ')'");
    const struct relation *relation = find_relation(r->sheet, number, index);
    if (relation == NULL) {
        s->at = begin;
        message_set(s->why, "unknown relation %s of (%s), expected one of the sheet", index, number);
        return -1;
    }
    char *side = text_copy(relation->text);
    size_t where, left = strcspn(side, "="); /* every relation has one */
    side[left] = '\0';
    int node = program_parse(s->program, right ? side + left + 1 : side, &where, s->why);
    free(side);
    return node;
}

/* (name = formula, ...) */
static bool read_bindings(struct parser *s, const struct program *from, int *stand_in)
{
    char name[LONGEST_NAME + 1];
    do {
        if (!parse_word(s, name))
            return false;
        int node = program_find(from, name);
        if (node < 0)
            return unknown_name(s, name, "name", "an input or a named subexpression of that section") >= 0;
        if (!parse_symbol(s, '='))
            return parse_refuse(s, "'='") >= 0;
        if ((stand_in[node] = parse_sum(s)) < 0)
            return false;
    } while (parse_symbol(s, ','));
    return parse_symbol(s, ')') || parse_refuse(s, "an operator, ',' or ')'") >= 0;
}

/* What no binding names: inputs by what is in scope, named subexpressions by free names of the step. */
static void bind_names(const struct reader *r, const struct program *from, int *stand_in)
{
    const struct program *p = &r->trial->program;
    for (int i = 0; i < from->named; i++) {
        int node = from->names[i].node, here = program_find(p, from->names[i].text);
        const bool is_input = node < from->inputs;
        const bool is_free = here >= r->sheet->quantity_count && here < p->inputs;
        if ((is_input || is_free) && stand_in[node] < 0)
            stand_in[node] = here;
    }
}

static int find_output(const struct section *section, const struct formulas *f, const char *name)
{
    for (int i = 0; i < section->output_count; i++)
        if (strcmp(section->outputs[i]->name, name) == 0)
            return f->outputs[i];
    return program_find(&f->program, name);
}

/* @printed, if it stands there; NULL after a complaint */
static const struct formulas *read_variant(struct parser *s, const struct section *section)
{
    char variant[LONGEST_NAME + 1];
    if (*s->at != '@')
        return &section->corrected;
    s->at++;
    if (!parse_word(s, variant))
        return NULL;
    if (strcmp(variant, "printed") == 0 && section->differs)
        return &section->printed;
    unknown_name(s, variant, "variant", "'printed', of a section that the sheet has as printed too");
    return NULL;
}

static int read_output(struct parser *s, const char *id)
{
    const struct reader *r = s->context;
    const struct section *section = section_find(r->sheet, id);
    char name[LONGEST_NAME + 1];
    const char *more = s->at++;
    if (section == NULL && parse_word(s, name)) { /* a name with a point in it */
        char *whole = memory(NULL, strlen(id) + strlen(name) + 2, 1);
        strcat(strcat(strcpy(whole, id), "."), name);
        const int node = program_find(s->program, whole);
        free(whole);
        if (node >= 0)
            return node;
    }
    s->at = more;
    if (section == NULL || section->method != METHOD_FORMULA)
        return unknown_name(s, id, "section", "one of the sheet that has formulas, as eq10");
    s->at++;
    if (!parse_word(s, name))
        return -1;
    const char *behind = s->at;
    const struct formulas *f = read_variant(s, section);
    if (f == NULL)
        return -1;
    const int wanted = find_output(section, f, name);
    if (wanted < 0) {
        s->at = behind;
        return unknown_name(s, name, "output", "an output or a named subexpression of that section");
    }
    int *stand_in = memory(NULL, (size_t)f->program.count, sizeof *stand_in);
    for (int i = 0; i < f->program.count; i++)
        stand_in[i] = -1;
    int node = -1;
    if (*s->at != '(' || (s->at++, read_bindings(s, &f->program, stand_in))) {
        bind_names(r, &f->program, stand_in);
        node = program_inline(s->program, &f->program, wanted, stand_in);
    }
    free(stand_in);
    return node;
}

static int read_reference(struct parser *s, const char *name)
{
    if (*s->at == '.')
        return read_output(s, name);
    if (strcmp(name, "rate") == 0)
        return read_rate(s);
    if (strcmp(name, "left") == 0 || strcmp(name, "right") == 0)
        return read_side(s, name[0] == 'r');
    return unknown_name(s, name, "function", "rate, left, right, sqrt, sin, cos, exp or atan2");
}

int read_formula_at(struct reader *r, const yaml_node_t *node, const char *text, size_t shift)
{
    struct message expected = {""};
    size_t where;
    int result = program_parse_with(&r->trial->program, text, read_reference, r, &where, &expected);
    if (result < 0)
        mistake(r->document, node, shift + where, "%s", expected.text);
    return result;
}

/* Only then is a place in the text a place in the file. */
static bool on_one_line(struct reader *r, const yaml_node_t *node, const char *expected)
{
    if (scalar(node) == NULL || node->start_mark.line != node->end_mark.line)
        return mistake(r->document, node, 0, "expected %s, on one line", expected);
    return true;
}

int read_formula(struct reader *r, const yaml_node_t *node)
{
    return on_one_line(r, node, "a formula") ? read_formula_at(r, node, scalar(node), 0) : -1;
}

/* The sign outside brackets; NULL where there is none. */
static const char *equality_sign(const char *text)
{
    int depth = 0;
    for (; *text != '\0' && (*text != '=' || depth > 0); text++)
        depth += *text == '(' ? 1 : *text == ')' ? -1 : 0;
    return *text == '=' ? text : NULL;
}

bool read_equality(struct reader *r, const yaml_node_t *node, struct equality *e)
{
    if (!on_one_line(r, node, "left = right"))
        return false;
    const char *sign = equality_sign(scalar(node));
    if (sign == NULL)
        return mistake(r->document, node, 0, "expected left = right");
    const size_t length = (size_t)(sign - scalar(node));
    char *left = text_copy(scalar(node));
    left[length] = '\0';
    *e = (struct equality){.text = scalar(node), .left = read_formula_at(r, node, left, 0)};
    e->right = e->left < 0 ? -1 : read_formula_at(r, node, sign + 1, length + 1);
    free(left);
    return e->right >= 0;
}
