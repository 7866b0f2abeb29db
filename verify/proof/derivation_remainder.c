/* The remainders of a derivation step: what an equation drops, on which states, and how large that may be. */
#include <string.h>

#include "proof/derivation.h"
#include "text/decimal.h"

/* The number that a text is, exactly as it is written. */
static bool read_exactly(const struct yaml *node, fmpq_t value)
{
    if (literal_read(value, node->text, true) != LITERAL_FINITE)
        return node_error(node, 0, "expected a number");
    return true;
}

/* VALUE or [LOW, HIGH] */
static bool read_bounds_of(const struct yaml *node, fmpq_t low, fmpq_t high)
{
    if (node->text != NULL)
        return read_exactly(node, low) && read_exactly(node, high);
    if (!is_texts(node, 2) || node->count != 2)
        return node_error(node, 0, "expected [LOW, HIGH]");
    return read_exactly(&node->items[0], low) && read_exactly(&node->items[1], high) &&
           (fmpq_cmp(low, high) < 0 || node_error(node, 0, "expected [LOW, HIGH] with LOW below HIGH"));
}

/* What the paper's Table 1 gives, and nothing else, needs not be stated. */
static bool value_of_table1(const struct sheet *s, const char *name, fmpq_t value)
{
    const struct quantity *q = NULL;
    for (int i = 0; i < s->row_count; i++)
        if (strcmp(s->table1[i].name, name) == 0)
            q = quantity_find(s, name);
    return q != NULL && q->value != NULL && literal_read(value, q->value, true) == LITERAL_FINITE;
}

static bool read_states(const struct scope *s, const struct yaml *on, struct remainder *m)
{
    for (int i = 0; i < m->program.inputs; i++) {
        const char *name = m->program.names[i].text;
        const struct yaml *range = under(on, name);
        if (range != NULL && !read_bounds_of(range, m->low + i, m->high + i))
            return false;
        if (range == NULL && !value_of_table1(s->sheet, name, m->low + i))
            return node_error(on, 0, "missing '%s', which is not in Table 1", name);
        if (range == NULL)
            fmpq_set(m->high + i, m->low + i);
    }
    for (int i = 0; i < on->count; i++) {
        const char *name = on->items[i].key;
        if (program_find(&m->program, name) < 0)
            return node_error(&on->items[i], AT_KEY, "what is dropped does not rest on '%s'", name);
    }
    return true;
}

static const struct field remainder_fields[] = {
    FIELD("equation", struct remainder, equation, FIELD_TEXT, .expected = "an equation number"),
    FIELD("of", struct remainder, text, FIELD_TEXT, .expected = "a formula"),
    FIELD("at_most", struct remainder, at_most, FIELD_TEXT, .expected = "a number"),
    FIELD("unit", struct remainder, unit, FIELD_TEXT, .expected = "a unit"),
    FIELD("on", struct remainder, on, FIELD_MAP, .expected = "states, {name: value, name: [low, high], ...}"),
    {.key = NULL}};

/* The formula is over the names of the step, whose own program stays as it is. */
static bool read_remainder(const struct scope *s, const struct identities *t, const struct yaml *item, struct remainder *m)
{
    struct identities copy = {.sheet_inputs = t->sheet_inputs};
    if (!fields_read(item, remainder_fields, m))
        return false;
    program_copy(&copy.program, &t->program);
    const int node = identities_formula(&copy, s, under(item, "of"));
    if (node >= 0)
        remainder_init(m, &copy.program, node);
    identities_clear(&copy);
    m->at = under(item, "at_most");
    if (node < 0 || !read_exactly(m->at, m->bound) || !read_states(s, m->on, m))
        return false;
    return fmpq_sgn(m->bound) > 0 || node_error(m->at, 0, "expected a bound above zero");
}

/* What drops it is what the step leads to. */
static bool check_equation(const struct derivations *d, const struct step *step, const struct yaml *equation)
{
    for (int i = 0; i < step->to_count; i++)
        if (entry_leads_to(d, step->to[i], equation->text))
            return true;
    return node_error(equation, 0, "expected an equation that the step leads to");
}

bool step_read_remainders(const struct derivations *d, struct step *step, const struct scope *s)
{
    const struct yaml *list = under(step->node, "remainders");
    if (list == NULL)
        return true;
    if (list->mapping || list->count == 0)
        return node_error(list, 0, "expected a list of what is dropped");
    step->remainders = xrealloc(NULL, (size_t)list->count, sizeof *step->remainders);
    while (step->remainder_count < list->count) {
        struct remainder *m = &step->remainders[step->remainder_count];
        const struct yaml *item = &list->items[step->remainder_count++];
        *m = (struct remainder){.equation = NULL};
        if (!read_remainder(s, &step->corrected, item, m) ||
            !check_equation(d, step, under(item, "equation")))
            return false;
    }
    return true;
}
