/*
 * The nonlinear flow: Taylor steps (taylor.h) that carry a set of states (lohner.h).
 *
 * Theorem (a step of length h). From every state of the set, and at every |s| <= h, the motion lies in
 *
 *     path(s) + J(s) e,   |e_j| <= radius_j,
 *
 * where path is the motion from the set's centre, and J(s) encloses the derivatives of the motion along the
 * set's basis from all the states of a box around the set. This is the mean value theorem, entry by entry: the box is
 * convex, and what encloses derivatives encloses their averages. So at its end the set moves by path(h) and
 * J(h); and within the step a state lies within sum_j ||J_ij|| radius_j of the path. Both series end at some
 * degree, and majorant_prove bounds what they leave out, for all the box and for all parameters within their
 * balls. No guess at where the motion goes is needed.
 *
 * The error terms, each with a test of its name in tests/motion/test_flow.c:
 *   (F1) the remainder of the path                        (path_bound.remainder, in path_at)
 *   (F2) of sum_j ||J_ij|| radius_j the degrees below n    (spread_bound.suffix, in expansion_spread)
 *   (F3) ... degree n                                      (spread_bound.size)
 *   (F4) ... and the remainder                             (spread_bound.remainder)
 *   (F5) the remainder of J e at the step's end            (handed to lohner_move as its error)
 *   (F6) the box around the whole set, 1/|x| included, from which the derivatives start
 *   (F7) the balls of c1 and c2, in the path and in the derivatives
 *   (F8) the three bounds hold on |s| <= h only: each is proved, or the step is halved
 *   (F9) s = Omega t - now is a ball: all of it lies within the step, or the row waits for the next
 */
#include "motion/flow.h"

#include <math.h>

#include "motion/expansion.h"
#include "text/scope.h"

enum {
    GUARD = 12,           /* bits: by then rounding adds 4 per cent to what the steps leave out, measured */
    A_PRIORI_ORDER = 12,  /* degree of the derivatives, which only steer the set                          */
    LEAST_STEP = -32,     /* log2 of radians: shorter steps ...                                           */
    CLOSE = -7,           /* ... where r < 2^-7 r_ref are given up                                        */
    MOST_HALVINGS = 32,   /* of a step too long to prove: beyond that the set is too wide                 */
    MOST_STEPS = 100000,  /* 30 days of Table 1 take some 500                                             */
};

struct flow {
    const struct flow_request *of;
    struct flow_steps how;
    arb_ptr unit;                      /* of each coordinate                                     */
    slong prec, bits;                  /* a step leaves out 2^-bits of the distance, roughly     */
    int direction;                     /* of time, 1 or -1                                       */
    arf_t now;                         /* radians of orbit where the step starts; exact          */
    struct lohner set;
    struct expansion series;           /* of its centre and the box around it                    */
};

static void flow_init(struct flow *f, const struct flow_request *r)
{
    *f = (struct flow){.of = r, .prec = r->prec, .bits = FLINT_MAX(r->prec - GUARD, 16),
                       .direction = fmpq_sgn(r->times + r->count - 1) < 0 ? -1 : 1};
    if (r->how != NULL)
        f->how = *r->how;
    /* Work n^2/h for n terms is least at h = R/e^2, R the radius of convergence: e^-2n = 2^-bits. */
    const slong order = f->how.order != 0 ? f->how.order : (slong)(0.5 * log(2) * (double)f->bits) + 4;
    const slong a_priori_order = f->how.derivative_order != 0 ? f->how.derivative_order : A_PRIORI_ORDER;
    f->unit = _arb_vec_init(FLOW_STATE);
    arf_init(f->now);
    lohner_init(&f->set);
    expansion_init(&f->series, f->how.system != NULL ? f->how.system : &closed_loop, order, a_priori_order, NULL, NULL);
}

static void flow_clear(struct flow *f)
{
    expansion_clear(&f->series);
    lohner_clear(&f->set);
    arf_clear(f->now);
    _arb_vec_clear(f->unit, FLOW_STATE);
}

/* Into radians of orbit and units of r_ref. A quotient that is exact stays so. */
static void set_problem(struct flow *f)
{
    const struct system *system = f->series.path.system;
    VECTOR(arb, state, FLOW_STATE);
    SCOPE(arb, c1, c2);
    flow_gains(c1, c2, f->of->p, f->prec);
    flow_units(f->unit, true, f->of->p, f->prec);
    for (int i = 0; i < FLOW_STATE; i++)
        arb_div(state + i, f->of->initial + i, f->unit + i, f->prec);
    lohner_from_box(&f->set, state);
    jet_constants(&f->series.path, c1, c2);
    const int first = system->series + closed_loop.all - closed_loop.series;
    for (int v = first; v < system->all; v++)
        arb_set(f->series.path.c[v], f->how.constants + v - first);
    if (f->how.held != NULL)
        arb_mul_ui(f->series.path.c[first - 1], f->how.held, 3, f->prec); /* the last of the closed loop's: 3 at rest */
    for (int v = system->series; v < system->all; v++)
        arb_set(f->series.hull.c[v], f->series.path.c[v]);
}

static void expand_series(struct flow *f, arb_srcptr box)
{
    for (int i = 0; i < FLOW_STATE; i++)
        arb_set(f->series.path.c[i], f->set.centre + i);
    expansion_path(&f->series, f->prec, (double)f->bits / (double)f->series.path.order);
    for (int i = 0; i < FLOW_STATE; i++)
        arb_set_round(f->series.hull.c[i], box + i, LOHNER_BITS);
    expansion_derivatives(&f->series, &f->set);
}

/* Where terms fall to 2^-bits of the distance; at rest one radian */
static double step_length(const struct flow *f)
{
    return f->how.step > 0 ? f->how.step : expansion_step(&f->series, expansion_position(&f->series, 0) - (double)f->bits, 1);
}

/* The motion from the centre at s, |s| <= h. */
static void path_at(const struct flow *f, arb_ptr state, const arb_t s)
{
    const slong terms = f->series.path.order + 1;
    VECTOR(arb, power, terms);
    _arb_vec_set_powers(power, s, terms, f->prec);
    for (int i = 0; i < FLOW_STATE; i++) {
        arb_dot(state + i, NULL, 0, f->series.path.c[i], 1, power, 1, terms, f->prec);
        arb_add_error_mag(state + i, f->series.path_bound.remainder + i);
    }
}

/* The motions from all the set at s, |s| <= h, in SI. */
static void state_at(const struct flow *f, arb_ptr state, const arb_t s)
{
    path_at(f, state, s);
    for (int i = 0; i < FLOW_STATE; i++) {
        expansion_spread(state + i, &f->series, i);
        arb_mul(state + i, state + i, f->unit + i, f->prec);
    }
}

/* The set at the end of the step; false if it is lost. */
static bool advance_set(struct flow *f, double step)
{
    VECTOR(arb, image, FLOW_STATE);
    SCOPE(arb, h);
    arb_set_d(h, f->direction * step);
    arf_add(f->now, f->now, arb_midref(h), ARF_PREC_EXACT, ARF_RND_DOWN);
    path_at(f, image, h);
    return expansion_move(&f->set, image, &f->series, h, f->series.spread_bound.remainder);
}

/* Whether the craft are closer than 2^CLOSE L_ref wherever in the box they are. */
static bool is_close(arb_srcptr box, slong prec)
{
    SCOPE(arb, r);
    SCOPE(arf, bound);
    arb_dot(r, NULL, 0, box, 1, box, 1, FLOW_HALF, prec);
    arb_get_ubound_arf(bound, r, prec);
    return arf_cmp_2exp_si(bound, 2 * CLOSE) < 0;
}

/* Expands about the start of a step and proves its length, unless the set has lost the digits that are wanted. */
static enum flow_status begin_step(struct flow *f, double *step)
{
    VECTOR(arb, box, FLOW_STATE);
    lohner_to_box(box, &f->set);
    if (flow_wide(box, (slong)(log2(10) * (double)f->of->digits)))
        return FLOW_WIDE;
    expand_series(f, box);
    *step = step_length(f);
    if (*step < ldexp(1, LEAST_STEP) && is_close(box, f->prec))
        return FLOW_CLOSE;
    *step = expansion_prove(&f->series, &f->set, *step, MOST_HALVINGS);
    return *step > 0 ? FLOW_DONE : FLOW_WIDE;
}

enum flow_status flow_nonlinear(struct flow_request *r)
{
    VECTOR(arb, state, FLOW_STATE);
    SCOPE(arb, s);
    slong k = 0;
    if (!flow_in_reach(r))
        return FLOW_STALLED;
    OWNED(flow) f;
    flow_init(&f, r);
    set_problem(&f);
    for (; k < r->count && fmpq_is_zero(r->times + k); k++)
        if (r->receive(r->context, k, r->times + k, r->initial) != 0)
            return FLOW_STOPPED;
    for (int steps = 0; k < r->count; steps++) {
        double step;
        enum flow_status status = steps < MOST_STEPS ? begin_step(&f, &step) : FLOW_STALLED;
        if (status != FLOW_DONE)
            return status;
        for (; k < r->count && time_within(s, r->times + k, r->p->Omega, f.now, step, f.prec); k++) {
            state_at(&f, state, s);
            r->reached = fmpq_get_d(r->times + k);
            if (r->receive(r->context, k, r->times + k, state) != 0)
                return FLOW_STOPPED;
        }
        if (k == r->count)
            break;
        if (mag_get_d(arb_radref(s)) > step / 4 || !advance_set(&f, step))
            return FLOW_WIDE; /* a time so vague might fall between all steps */
        r->reached = f.direction * seconds_within(f.now, r->p->Omega);
    }
    return FLOW_DONE;
}
