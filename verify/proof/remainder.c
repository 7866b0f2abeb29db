#include "proof/remainder.h"

#include <stdlib.h>

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
