/* The remainders of a derivation step: what an equation drops, on which states, and how large that may be. */
#include "proof/derivation.h"

#include <stdlib.h>
#include <string.h>

#include "text/decimal.h"
#include "text/scope.h"

enum { SEARCH_BITS = 128, MOST_BOXES = 20000, DEEPEST_SEARCH = 200 };

void remainder_init(struct remainder *r, const struct program *p, int node)
{
    char *needed = program_needs(p, node, NULL);
    int *stand_in = xrealloc(NULL, (size_t)node + 1, sizeof *stand_in);
    program_init(&r->program);
    for (int i = 0; i <= node; i++)
        stand_in[i] = i < p->inputs && needed[i] ? program_input(&r->program, p->names[i].text) : -1;
    r->node = program_copy_node(&r->program, p, node, stand_in);
    r->low = _fmpq_vec_init(r->program.inputs);
    r->high = _fmpq_vec_init(r->program.inputs);
    fmpq_init(r->bound);
    free(needed);
    free(stand_in);
}

void remainder_clear(struct remainder *r)
{
    _fmpq_vec_clear(r->low, r->program.inputs);
    _fmpq_vec_clear(r->high, r->program.inputs);
    fmpq_clear(r->bound);
    program_clear(&r->program);
}

/* A box is its low ends, then its high ones, thin balls all. */
struct search {
    const struct remainder *of;
    struct machine value;
    struct gradient slope;
    arb_ptr bound, reached; /* |formula| is at least `reached` somewhere in the set */
    int inputs, boxes;
};

/* The formula for states within these balls. */
static void enclose_at(struct search *s, arb_t z, arb_srcptr state)
{
    SCOPE(arb, least);
    for (int i = 0; i < s->inputs; i++)
        arb_set(machine_value(&s->value, i), state + i);
    machine_run(&s->value);
    arb_set(z, machine_value(&s->value, s->of->node));
    arb_get_abs_lbound_arf(arb_midref(least), z, SEARCH_BITS);
    if (arb_gt(least, s->reached))
        arb_swap(s->reached, least);
}

/*
 * An upper bound z of sign * formula on a box:
 *
 *   (1) the formula at the centre, with the radius of its evaluation,
 *   (2) for each input |slope| * radius, the slope's enclosure being that on all of the box,
 *   (3) but where that slope has one sign, the input stands at the end where the formula is largest, and the box is narrower.
 *
 * Returns the input that changes it most by (2), -1: there is none. is_below() adds: (4) a box is both its halves, which
 * share the cut, and remainder_prove(): (5) the formula is bounded from above and from below.
 */
static int bound_above(struct search *s, arb_t z, arb_ptr box, int sign)
{
    const int inputs = s->inputs;
    arb_ptr low = box, high = box + inputs;
    VECTOR(arb, state, inputs);
    SCOPE(mag, change, most, all);
    int widest = -1;
    for (int i = 0; i < inputs; i++)
        arb_union(state + i, low + i, high + i, SEARCH_BITS);
    enclose_at(s, z, state);
    gradient_run(&s->slope, &s->value);
    for (int i = 0; i < inputs; i++) {
        arb_mul_si(z, gradient_value(&s->slope, 0, i), sign, SEARCH_BITS);
        if (arb_is_nonnegative(z)) { /* nor is what has no value */
            arb_set(low + i, high + i);
        } else if (arb_is_nonpositive(z)) {
            arb_set(high + i, low + i);
        } else {
            arb_get_mag(change, z);
            mag_addmul(all, change, arb_radref(state + i));
            mag_mul(change, change, arb_radref(state + i));
            if (widest < 0 || mag_cmp(change, most) > 0) {
                mag_set(most, change);
                widest = i;
            }
        }
        arb_add(state + i, low + i, high + i, SEARCH_BITS);
        arb_mul_2exp_si(state + i, state + i, -1);
    }
    enclose_at(s, z, state);
    arb_mul_si(z, z, sign, SEARCH_BITS);
    arb_add_error_mag(z, all);
    return widest;
}

/* False as soon as a value above the bound was found, or too many boxes were needed. */
static bool is_below(struct search *s, arb_srcptr box, int sign, int depth)
{
    VECTOR(arb, part, 2 * s->inputs);
    arb_ptr low = part, high = part + s->inputs;
    SCOPE(arb, z, end);
    _arb_vec_set(part, box, 2 * s->inputs);
    const int i = bound_above(s, z, part, sign);
    bool below = arb_le(z, s->bound);
    if (!below && i >= 0 && depth < DEEPEST_SEARCH && ++s->boxes < MOST_BOXES && !arb_gt(s->reached, s->bound)) {
        arb_set(end, high + i);
        arb_add(high + i, low + i, high + i, SEARCH_BITS);
        arb_mul_2exp_si(high + i, high + i, -1);
        below = is_below(s, part, sign, depth + 1);
        arb_swap(low + i, high + i);
        arb_swap(high + i, end);
        below = below && is_below(s, part, sign, depth + 1);
    }
    return below;
}

void remainder_prove(const struct remainder *r, struct remainder_proof *proof)
{
    SCOPE(arb, bound, reached);
    struct search s = {.of = r, .inputs = r->program.inputs, .bound = bound, .reached = reached};
    VECTOR(arb, box, 2 * s.inputs);
    machine_init(&s.value, &r->program, &arithmetic_ball, SEARCH_BITS);
    gradient_init(&s.slope, &r->program, &r->node, 1, &arithmetic_ball, SEARCH_BITS);
    arb_set_fmpq(s.bound, r->bound, SEARCH_BITS);
    for (int i = 0; i < s.inputs; i++) {
        arb_set_fmpq(box + i, r->low + i, SEARCH_BITS);
        arb_set_fmpq(box + s.inputs + i, r->high + i, SEARCH_BITS);
    }
    const bool below = is_below(&s, box, 1, 0) && is_below(&s, box, -1, 0), above = arb_gt(s.reached, s.bound);
    arb_div(s.reached, s.reached, s.bound, SEARCH_BITS);
    arb_mul_ui(s.reached, s.reached, 100, SEARCH_BITS);
    proof->boxes = s.boxes;
    proof->percent = above ? 100 : (int)arf_get_d(arb_midref(s.reached), ARF_RND_DOWN);
    proof->state = above                 ? REMAINDER_EXCEEDED
                   : !below              ? REMAINDER_UNDECIDED
                   : proof->percent < 50 ? REMAINDER_TOO_WIDE
                                         : REMAINDER_PROVED;
    machine_clear(&s.value);
    gradient_clear(&s.slope);
}

/* ---- what is written ---- */

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
    struct identities copy = {.scope = *s, .sheet_inputs = t->sheet_inputs};
    if (!fields_read(item, remainder_fields, m))
        return false;
    program_copy(&copy.program, &t->program);
    const int node = identities_formula(&copy, under(item, "of"));
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
