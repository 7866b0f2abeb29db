/* The remainders of a derivation step: what an equation drops, on which states, and how large that may be. */
#include <string.h>

#include "proof/derivation.h"
#include "text/decimal.h"

/* A number, exactly as it is written. */
static bool read_number(const struct document *d, const yaml_node_t *node, fmpq_t value)
{
    if (scalar(node) == NULL || literal_read(value, scalar(node), true) != LITERAL_FINITE)
        return parse_error(d, node, 0, "expected a number");
    return true;
}

/* VALUE or [LOW, HIGH] */
static bool read_range(const struct document *d, const yaml_node_t *node, fmpq_t low, fmpq_t high)
{
    if (scalar(node) != NULL) {
        bool fine = read_number(d, node, low);
        fmpq_set(high, low);
        return fine;
    }
    if (!is_list(d, node, 2))
        return false;
    if (length_of(node) != 2)
        return parse_error(d, node, 0, "expected [LOW, HIGH]");
    if (!read_number(d, item_of(d, node, 0), low) || !read_number(d, item_of(d, node, 1), high))
        return false;
    return fmpq_cmp(low, high) < 0 || parse_error(d, node, 0, "expected [LOW, HIGH] with LOW below HIGH");
}

/* What the paper's Table 1 gives, and nothing else, needs not be stated. */
static bool value_of_table1(const struct sheet *s, const char *name, fmpq_t value)
{
    const struct quantity *q = quantity_find(s, name);
    for (int i = 0; i < s->row_count && q != NULL && q->value != NULL; i++)
        if (strcmp(s->table1[i].name, name) == 0)
            return literal_read(value, q->value, true) == LITERAL_FINITE;
    return false;
}

static bool read_states(const struct scope *s, const yaml_node_t *on, struct remainder *m)
{
    const struct document *d = s->document;
    if (!is_mapping(d, on, NULL))
        return false;
    for (int i = 0; i < m->program.inputs; i++) {
        const char *name = m->program.names[i].text;
        const yaml_node_t *range = child(d, on, name);
        if (range != NULL && !read_range(d, range, m->low + i, m->high + i))
            return false;
        if (range == NULL && !value_of_table1(s->sheet, name, m->low + i))
            return parse_error(d, on, 0, "missing '%s', which is not in Table 1", name);
        if (range == NULL)
            fmpq_set(m->high + i, m->low + i);
    }
    for (int i = 0; i < length_of(on); i++) {
        const yaml_node_t *key = key_of(d, on, i);
        if (program_find(&m->program, scalar(key)) < 0)
            return parse_error(d, key, 0, "what is dropped does not rest on '%s'", scalar(key));
    }
    return true;
}

/* The formula, over the names of the step; the step's own program stays as it is. */
static bool read_dropped(const struct scope *s, const struct identities *t, const yaml_node_t *of, struct remainder *m)
{
    struct identities copy = {0};
    program_copy(&copy.program, &t->program);
    const int node = identities_formula(&copy, s, of);
    if (node >= 0)
        remainder_init(m, &copy.program, node);
    identities_clear(&copy);
    return node >= 0;
}

static bool read_remainder(const struct scope *s, const struct identities *t, const yaml_node_t *item,
                           struct remainder *m)
{
    static const char *const keys[] = {"equation", "of", "at_most", "unit", "on", NULL};
    const struct document *d = s->document;
    const yaml_node_t *nodes[5];
    if (!is_mapping(d, item, keys))
        return false;
    for (int i = 0; keys[i] != NULL; i++) {
        nodes[i] = child(d, item, keys[i]);
        if (nodes[i] == NULL)
            return parse_error(d, item, 0, "missing %s", keys[i]);
        if (i < 4 && scalar(nodes[i]) == NULL)
            return parse_error(d, nodes[i], 0, "expected a text");
    }
    if (!read_dropped(s, t, nodes[1], m))
        return false;
    m->equation = scalar(nodes[0]);
    m->text = scalar(nodes[1]);
    m->at_most = scalar(nodes[2]);
    m->unit = scalar(nodes[3]);
    m->on = nodes[4];
    m->at = nodes[2];
    if (!read_number(d, nodes[2], m->bound) || !read_states(s, m->on, m))
        return false;
    return fmpq_sgn(m->bound) > 0 || parse_error(d, nodes[2], 0, "expected a bound above zero");
}

/* What drops it is what the step leads to. */
static bool check_equation(const struct derivations *d, const struct step *step, const yaml_node_t *equation)
{
    for (int i = 0; i < step->to_count; i++)
        if (entry_leads_to(d, step->to[i], scalar(equation)))
            return true;
    return parse_error(&d->document, equation, 0, "expected an equation that the step leads to");
}

bool step_read_remainders(const struct derivations *d, struct step *step, const struct scope *s)
{
    const yaml_node_t *list = child(s->document, step->node, "remainders");
    if (list == NULL)
        return true;
    if (list->type != YAML_SEQUENCE_NODE || length_of(list) == 0)
        return parse_error(s->document, list, 0, "expected a list of what is dropped");
    step->remainders = xrealloc(NULL, (size_t)length_of(list), sizeof *step->remainders);
    while (step->remainder_count < length_of(list)) {
        struct remainder *m = &step->remainders[step->remainder_count];
        const yaml_node_t *item = item_of(s->document, list, step->remainder_count++);
        *m = (struct remainder){.equation = NULL};
        if (!read_remainder(s, &step->corrected, item, m) ||
            !check_equation(d, step, child(&d->document, item, "equation")))
            return false;
    }
    return true;
}
