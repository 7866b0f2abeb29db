#include "claims/curve.h"

#include <stdlib.h>
#include <string.h>

#include "text/scope.h"

int program_slope(struct program *p, int node, int x)
{
    const int inputs = p->inputs;
    int *rate = xrealloc(NULL, (size_t)inputs, sizeof *rate);
    memset(rate, -1, (size_t)inputs * sizeof *rate);
    rate[x] = program_parse(p, "1", NULL);
    const int slope = program_derivative(p, node, rate, inputs);
    free(rate);
    return slope;
}

arb_srcptr curve_at(struct curve *c, const arb_t x)
{
    arb_set(machine_value(c->machine, c->x), x);
    machine_run_to(c->machine, c->node);
    return machine_value(c->machine, c->node);
}

int curve_series(arb_ptr out, const arb_t x, void *curve, slong order, slong prec)
{
    struct curve *c = curve;
    (void)prec;
    arb_set(out, curve_at(c, x));
    if (order > 1) {
        machine_run_to(c->machine, c->slope);
        arb_set(out + 1, machine_value(c->machine, c->slope));
    }
    return 0;
}

int sign_of_ball(const arb_t z)
{
    return arb_is_positive(z) ? 1 : arb_is_negative(z) ? -1 : 0;
}

slong roots_between(arb_t first, arb_calc_func_t f, void *of, const arb_t low, const arb_t high, slong most, slong evaluations, slong prec)
{
    enum { DEEPEST = 60 };
    arf_interval_t all;
    arf_interval_ptr blocks;
    int *flags;
    arf_interval_init(all);
    arb_get_lbound_arf(&all->a, low, prec);
    arb_get_ubound_arf(&all->b, high, prec);
    const slong found = arb_calc_isolate_roots(&blocks, &flags, f, of, all, DEEPEST, evaluations, most, prec);
    slong count = found;
    arb_indeterminate(first);
    for (slong i = 0; i < found; i++) {
        if (flags[i] != 1)
            count = -1;
        else if (i == 0)
            arf_interval_get_arb(first, blocks, prec);
    }
    _arf_interval_vec_clear(blocks, found);
    flint_free(flags);
    arf_interval_clear(all);
    return count;
}

/*
 * Theorem. The root lies in m - f(m)/f'(X) if it lies in X, m in X (the mean value theorem); and beyond m, if f has the sign there
 * that it has at the lower end, before m, if it has the other. (N1) f(m), (N2) f'(X) with their radii, (N3) the side of m.
 */
void narrow_root(arb_t root, arb_calc_func_t f, void *of, slong prec)
{
    SCOPE(arb, at, image);
    SCOPE(arf, low, high, between);
    SCOPE(mag, narrow);
    VECTOR(arb, value, 2);
    arb_get_interval_arf(low, high, root, prec);
    arb_set_arf(at, low);
    f(value, at, of, 1, prec);
    const int sign = sign_of_ball(value);
    do { /* as long as the interval loses a fourth */
        mag_mul_ui(narrow, arb_radref(root), 3);
        mag_mul_2exp_si(narrow, narrow, -2);
        arb_get_interval_arf(low, high, root, prec);
        arb_set_interval_arf(at, low, high, prec); /* X, with its ends */
        f(value, at, of, 2, prec);
        arb_swap(image, value + 1);
        arf_sub(between, high, low, prec, ARF_RND_NEAR); /* 7/16 of it: halves are where formulas have their kinks */
        arf_mul_ui(between, between, 7, prec, ARF_RND_NEAR);
        arf_mul_2exp_si(between, between, -4);
        arf_add(between, between, low, prec, ARF_RND_NEAR);
        arb_set_arf(at, between);
        f(value, at, of, 1, prec);
        arb_div(image, value, image, prec);
        arb_sub(image, at, image, prec);
        if (arb_is_finite(image))
            arb_intersection(root, root, image, prec);
        if (sign * sign_of_ball(value) != 0) {
            arf_swap(sign_of_ball(value) == sign ? low : high, between);
            arb_set_interval_arf(at, low, high, prec);
            arb_intersection(root, root, at, prec);
        }
    } while (mag_cmp(arb_radref(root), narrow) < 0);
}
