#include "motion/expansion.h"

#include <math.h>
#include <stdlib.h>

#include "text/message.h"
#include "text/scope.h"

void expansion_init(struct expansion *e, const struct system *system, slong order, slong derivative_order, const struct space *space,
                    const struct space *linear)
{
    jet_init(&e->path, system, order, space);
    jet_init(&e->hull, system, derivative_order, linear);
    for (int j = 0; j < FLOW_STATE; j++)
        jet_init(&e->column[j], system, derivative_order, linear);
    majorant_init(&e->path_bound, system, order);
    majorant_init(&e->hull_bound, system, derivative_order);
    majorant_init(&e->spread_bound, system, derivative_order);
}

void expansion_clear(struct expansion *e)
{
    jet_clear(&e->path);
    jet_clear(&e->hull);
    for (int j = 0; j < FLOW_STATE; j++)
        jet_clear(&e->column[j]);
    majorant_clear(&e->path_bound);
    majorant_clear(&e->hull_bound);
    majorant_clear(&e->spread_bound);
}

void expansion_path(struct expansion *e, slong prec, double fall)
{
    jet_start_q(&e->path, prec);
    jet_extend(&e->path, &e->path, prec, fall);
}

void expansion_derivatives(struct expansion *e, const struct lohner *set)
{
    SCOPE(arb, x);
    jet_start_q(&e->hull, LOHNER_BITS);
    jet_extend(&e->hull, &e->hull, LOHNER_BITS, 0);
    for (int j = 0; j < FLOW_STATE; j++) {
        struct jet *column = &e->column[j];
        for (int i = 0; i < FLOW_STATE; i++) {
            arb_set_d(column->space != NULL ? x : column->c[i], set->basis[i][j]);
            if (column->space != NULL)
                model_set_ball(column->m[i], x);
        }
        jet_start_column_q(column, &e->hull, LOHNER_BITS);
        jet_extend(column, &e->hull, LOHNER_BITS, 0);
    }
}

double expansion_position(const struct expansion *e, slong k)
{
    double size = -HUGE_VAL;
    SCOPE(mag, m);
    for (int i = 0; i < FLOW_HALF; i++) {
        jet_size(m, &e->path, i, k);
        size = fmax(size, mag_get_d_log2_approx(m));
    }
    return size;
}

double expansion_step(const struct expansion *e, double left_out, double longest)
{
    double step = log2(longest);
    for (slong k = e->path.order - 1; k <= e->path.order; k++)
        step = fmin(step, (left_out - expansion_position(e, k)) / (double)k);
    int exponent;
    const double fraction = frexp(exp2(step), &exponent);
    return ldexp(floor(ldexp(fraction, 8)), exponent - 8);
}

/* Bounds on |s| <= step; false where it is too long for them. */
static bool prove_step(struct expansion *e, const struct lohner *set, double step)
{
    SCOPE(mag, h, one);
    mag_set_d(h, step);
    mag_one(one);
    majorant_of(&e->path_bound, &e->path, one, 1, h);
    majorant_of(&e->hull_bound, &e->hull, one, 1, h);
    majorant_of(&e->spread_bound, e->column, set->radius, FLOW_STATE, h);
    return majorant_prove(&e->path_bound, NULL, h) && majorant_prove(&e->hull_bound, NULL, h)
           && majorant_prove(&e->spread_bound, &e->hull_bound, h);
}

double expansion_prove(struct expansion *e, const struct lohner *set, double step, int halvings)
{
    for (int i = 0; i < halvings; i++, step /= 2)
        if (prove_step(e, set, step))
            return step;
    return 0;
}

void expansion_spread(arb_t x, const struct expansion *e, int v)
{
    const struct majorant *spread = &e->spread_bound;
    arb_add_error_mag(x, spread->suffix[v]); /* below degree n, ... */
    arb_add_error_mag(x, spread->size[v] + spread->order);
    arb_add_error_mag(x, v < spread->system->states ? spread->remainder + v : spread->tail + v);
}

bool time_within(arb_t s, const fmpq_t t, const arb_t Omega, const arf_t now, double step, slong prec)
{
    SCOPE(arf, bound);
    arb_set_fmpq(s, t, prec);
    arb_mul(s, s, Omega, prec);
    arb_sub_arf(s, s, now, prec);
    arb_get_abs_ubound_arf(bound, s, 53);
    return arf_cmp_d(bound, step) <= 0;
}

double seconds_within(const arf_t now, const arb_t Omega)
{
    SCOPE(arb, t);
    SCOPE(arf, bound);
    arb_set_arf(t, now);
    arb_div(t, t, Omega, 64);
    arb_get_abs_lbound_arf(bound, t, 53);
    return arf_get_d(bound, ARF_RND_DOWN);
}

bool expansion_move(struct lohner *set, arb_srcptr image, const struct expansion *e, const arb_t h, mag_srcptr error)
{
    const struct space *space = e->hull.space;
    const slong terms = e->hull.order + 1;
    const int count = space != NULL ? space->size : 1;
    arb_mat_struct *derivative = xrealloc(NULL, (size_t)count, sizeof *derivative);
    struct model at_end;
    VECTOR(arb, power, terms);
    SCOPE(mag, rest);
    _arb_vec_set_powers(power, h, terms, LOHNER_BITS);
    for (int i = 0; i < count; i++)
        arb_mat_init(derivative + i, FLOW_STATE, FLOW_STATE);
    if (space != NULL)
        model_init(&at_end, space);
    for (int v = 0; v < FLOW_STATE; v++)
        for (int j = 0; j < FLOW_STATE; j++) {
            arb_ptr entry = arb_mat_entry(derivative, v, j);
            if (space == NULL) {
                arb_dot(entry, NULL, 0, e->column[j].c[v], 1, power, 1, terms, LOHNER_BITS);
                continue;
            }
            model_evaluate(&at_end, e->column[j].m[v], (int)terms, arf_get_d(arb_midref(h), ARF_RND_NEAR));
            for (int i = 0; i < count; i++)
                arb_set_d(arb_mat_entry(derivative + i, v, j), at_end.c[i]); /* (S5) */
            mag_set_d(rest, at_end.rest);
            arb_add_error_mag(entry, rest); /* (S4) */
        }
    const bool bounded = lohner_move(set, image, derivative, count, error, LOHNER_BITS);
    for (int i = count - 1; i >= 0; i--)
        arb_mat_clear(derivative + i);
    free(derivative);
    if (space != NULL)
        model_clear(&at_end);
    return bounded;
}
