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
 *   (F2) of sum_j ||J_ij|| radius_j the degrees below n    (spread_bound.suffix, in state_at)
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

#include "motion/lohner.h"
#include "motion/taylor.h"
#include "text/scope.h"

enum {
    GUARD = 12,           /* bits: by then rounding adds 4 per cent to what the steps leave out, measured */
    A_PRIORI_ORDER = 12,  /* degree of the derivatives, which only steer the set: ...                     */
    STEADY = 10,          /* ... to know them to 2^-10 will do                                            */
    LEAST_STEP = -32,     /* log2 of radians: shorter steps ...                                           */
    CLOSE = -7,           /* ... where r < 2^-7 r_ref are given up                                        */
    MOST_HALVINGS = 32,   /* of a step too long to prove: beyond that the set is too wide                 */
    MOST_STEPS = 100000,  /* 30 days of Table 1 take some 500                                             */
};

struct flow {
    arb_t Omega, c1, c2, r_ref, speed; /* speed = Omega r_ref                                    */
    slong prec, bits;                  /* a step leaves out 2^-bits of the distance, roughly     */
    int direction;                     /* of time, 1 or -1                                       */
    bool proving;
    const struct system *system;
    double proposed;                   /* a step, or 0: what the series propose                   */
    arf_t now;                         /* radians of orbit where the step starts; exact          */
    struct lohner set;
    struct jet path, a_priori, column[FLOW_STATE]; /* from the centre, from the box, and its derivatives */
    struct majorant path_bound, a_priori_bound, spread_bound; /* spread: |J| radius */
    arb_ptr power;                     /* s^k                                                    */
    arb_ptr state;                     /* the answer at s, ...                                   */
    arb_t s;                           /* ... radians after now                                  */
};

static void flow_init(struct flow *f, slong prec, const struct flow_steps *how)
{
    f->prec = prec;
    f->bits = FLINT_MAX(prec - GUARD, 16);
    /* Work n^2/h for n terms is least at h = R/e^2, R the radius of convergence: e^-2n = 2^-bits. */
    const slong order = how->order != 0 ? how->order : (slong)(0.5 * log(2) * (double)f->bits) + 4;
    const slong a_priori_order = how->derivative_order != 0 ? how->derivative_order : A_PRIORI_ORDER;
    f->proposed = how->step;
    f->proving = !how->unproved;
    f->system = how->system != NULL ? how->system : &closed_loop;
    arb_init(f->Omega);
    arb_init(f->c1);
    arb_init(f->c2);
    arb_init(f->r_ref);
    arb_init(f->speed);
    arf_init(f->now);
    lohner_init(&f->set);
    jet_init(&f->path, f->system, order);
    jet_init(&f->a_priori, f->system, a_priori_order);
    for (int j = 0; j < FLOW_STATE; j++)
        jet_init(&f->column[j], f->system, a_priori_order);
    majorant_init(&f->path_bound, f->system, order);
    majorant_init(&f->a_priori_bound, f->system, a_priori_order);
    majorant_init(&f->spread_bound, f->system, a_priori_order);
    f->power = _arb_vec_init(FLINT_MAX(order, a_priori_order) + 1);
    f->state = _arb_vec_init(FLOW_STATE);
    arb_init(f->s);
}

static void flow_clear(struct flow *f)
{
    arb_clear(f->s);
    _arb_vec_clear(f->state, FLOW_STATE);
    _arb_vec_clear(f->power, FLINT_MAX(f->path.order, f->a_priori.order) + 1);
    majorant_clear(&f->spread_bound);
    majorant_clear(&f->a_priori_bound);
    majorant_clear(&f->path_bound);
    for (int j = 0; j < FLOW_STATE; j++)
        jet_clear(&f->column[j]);
    jet_clear(&f->a_priori);
    jet_clear(&f->path);
    lohner_clear(&f->set);
    arf_clear(f->now);
    arb_clear(f->speed);
    arb_clear(f->r_ref);
    arb_clear(f->c2);
    arb_clear(f->c1);
    arb_clear(f->Omega);
}

/* Into radians of orbit and units of r_ref. A quotient that is exact stays so. */
static void set_problem(struct flow *f, const struct flow_steps *how, const struct flow_parameters *p, arb_srcptr initial)
{
    VECTOR(arb, state, FLOW_STATE);
    SCOPE(arb, mass);
    arb_set(f->Omega, p->Omega);
    arb_div(f->c2, p->C2, p->Omega, f->prec);
    arb_div(f->c1, p->C1, p->Omega, f->prec);
    arb_div(f->c1, f->c1, p->Omega, f->prec);
    arb_add(mass, p->m1, p->m2, f->prec);
    arb_mul(f->r_ref, p->m2, p->L_ref, f->prec);
    arb_div(f->r_ref, f->r_ref, mass, f->prec);
    arb_mul(f->speed, f->r_ref, f->Omega, f->prec);
    for (int i = 0; i < FLOW_STATE; i++)
        arb_div(state + i, initial + i, i < FLOW_HALF ? f->r_ref : f->speed, f->prec);
    lohner_from_box(&f->set, state);
    jet_constants(&f->path, f->c1, f->c2);
    jet_constants(&f->a_priori, f->c1, f->c2);
    const int first = f->system->series + closed_loop.all - closed_loop.series;
    for (int v = first; v < f->system->all; v++) {
        arb_set(f->path.c[v], how->constants + v - first);
        arb_set(f->a_priori.c[v], how->constants + v - first);
    }
}

/* q = 1/|x| of the state whose coefficients 0 stand in the jet */
static void start_q(struct jet *jet, slong prec)
{
    arb_ptr q = jet->c[FLOW_STATE];
    arb_zero(q);
    for (int i = 0; i < FLOW_HALF; i++)
        arb_addmul(q, jet->c[i], jet->c[i], prec);
    arb_sqrt(q, q, prec);
    arb_inv(q, q, prec);
}

/* Direction j of the basis, in which q = 1/|x| changes by -q^3 x.dx */
static void start_column(struct flow *f, int j)
{
    arb_ptr const *c = f->a_priori.c;
    arb_ptr *d = f->column[j].c;
    arb_zero(d[FLOW_STATE]);
    for (int i = 0; i < FLOW_STATE; i++) {
        arb_set_d(d[i], f->set.basis[i][j]);
        if (i < FLOW_HALF)
            arb_submul(d[FLOW_STATE], c[i], d[i], LOHNER_BITS);
    }
    for (int i = 0; i < 3; i++)
        arb_mul(d[FLOW_STATE], d[FLOW_STATE], c[FLOW_STATE], LOHNER_BITS);
}

static void expand_series(struct flow *f)
{
    for (int i = 0; i < FLOW_STATE; i++)
        arb_set(f->path.c[i], f->set.centre + i);
    start_q(&f->path, f->prec);
    jet_extend(&f->path, f->prec, (double)f->bits / (double)f->path.order);
    if (!f->proving)
        return;
    VECTOR(arb, box, FLOW_STATE);
    lohner_to_box(box, &f->set);
    for (int i = 0; i < FLOW_STATE; i++)
        arb_set_round(f->a_priori.c[i], box + i, LOHNER_BITS);
    start_q(&f->a_priori, LOHNER_BITS);
    jet_extend(&f->a_priori, LOHNER_BITS, 0);
    for (int j = 0; j < FLOW_STATE; j++) {
        start_column(f, j);
        jet_extend_column(&f->column[j], &f->a_priori, LOHNER_BITS);
    }
}

/* log2 of the largest coefficient k of the position; a guide, no bound */
static double position_size(const struct flow *f, slong k)
{
    double size = -HUGE_VAL;
    SCOPE(mag, m);
    for (int i = 0; i < FLOW_HALF; i++) {
        arb_get_mag(m, f->path.c[i] + k);
        size = fmax(size, mag_get_d_log2_approx(m));
    }
    return size;
}

/* The step at which the last two coefficients fall to 2^-bits of the distance: a dyadic of 8 bits. */
static double step_length(const struct flow *f)
{
    double step = 0, r = position_size(f, 0); /* log2: at rest the step is one radian */
    if (f->proposed > 0)
        return f->proposed;
    for (slong k = f->path.order - 1; k <= f->path.order; k++)
        step = fmin(step, (r - (double)f->bits - position_size(f, k)) / (double)k);
    int exponent;
    double fraction = frexp(exp2(step), &exponent);
    return ldexp(floor(ldexp(fraction, 8)), exponent - 8);
}

/* Whether the derivatives are known well enough to steer by; else each step would inflate the set. */
static bool steady(const struct majorant *spread)
{
    SCOPE(mag, all, remainder);
    for (int i = 0; i < FLOW_STATE; i++) {
        mag_max(all, all, spread->suffix[i]);
        mag_max(remainder, remainder, spread->remainder + i);
    }
    mag_mul_2exp_si(remainder, remainder, STEADY);
    return mag_cmp(remainder, all) <= 0;
}

/* Bounds on |s| <= step; false where it is too long for them. */
static bool prove_step(struct flow *f, double step)
{
    SCOPE(mag, h, one);
    mag_set_d(h, step);
    mag_one(one);
    majorant_of(&f->path_bound, &f->path, one, 1, h);
    majorant_of(&f->a_priori_bound, &f->a_priori, one, 1, h);
    majorant_of(&f->spread_bound, f->column, f->set.radius, FLOW_STATE, h);
    return majorant_prove(&f->path_bound, NULL, h) && majorant_prove(&f->a_priori_bound, NULL, h)
           && majorant_prove(&f->spread_bound, &f->a_priori_bound, h) && steady(&f->spread_bound);
}

/* The longest of step, step/2, ... that can be proved, or 0 */
static double proved_step(struct flow *f, double step)
{
    int halvings = 0;
    for (; halvings < MOST_HALVINGS && f->proving && !prove_step(f, step); halvings++)
        step /= 2;
    return halvings < MOST_HALVINGS ? step : 0;
}

/* The motion from the centre at s, |s| <= h. */
static void path_at(const struct flow *f, arb_ptr state, const arb_t s)
{
    slong terms = f->path.order + 1;
    _arb_vec_set_powers(f->power, s, terms, f->prec);
    for (int i = 0; i < FLOW_STATE; i++) {
        arb_dot(state + i, NULL, 0, f->path.c[i], 1, f->power, 1, terms, f->prec);
        if (f->proving)
            arb_add_error_mag(state + i, f->path_bound.remainder + i);
    }
}

/* The motions from all the set at s, |s| <= h, in SI. */
static void state_at(const struct flow *f, arb_ptr state, const arb_t s)
{
    const struct majorant *spread = &f->spread_bound;
    path_at(f, state, s);
    for (int i = 0; i < FLOW_STATE; i++) {
        if (f->proving) {
            arb_add_error_mag(state + i, spread->suffix[i]); /* below degree n, ... */
            arb_add_error_mag(state + i, spread->size[i] + spread->order);
            arb_add_error_mag(state + i, spread->remainder + i);
        }
        arb_mul(state + i, state + i, i < FLOW_HALF ? f->r_ref : f->speed, f->prec);
    }
}

/* The set at the end of the step; false if it is lost. */
static bool advance_set(struct flow *f, double step)
{
    VECTOR(arb, image, FLOW_STATE);
    arb_mat_t derivative;
    SCOPE(arb, s);
    bool bounded = true;
    arb_mat_init(derivative, FLOW_STATE, FLOW_STATE);
    arb_set_d(s, f->direction * step);
    arf_add(f->now, f->now, arb_midref(s), ARF_PREC_EXACT, ARF_RND_DOWN);
    path_at(f, image, s);
    if (f->proving) {
        const slong terms = f->a_priori.order + 1;
        _arb_vec_set_powers(f->power, s, terms, LOHNER_BITS);
        for (int i = 0; i < FLOW_STATE; i++)
            for (int j = 0; j < FLOW_STATE; j++)
                arb_dot(arb_mat_entry(derivative, i, j), NULL, 0, f->column[j].c[i], 1, f->power, 1, terms,
                        LOHNER_BITS);
        bounded = lohner_move(&f->set, image, derivative, 1, f->spread_bound.remainder, LOHNER_BITS);
    } else {
        lohner_from_box(&f->set, image);
    }
    arb_mat_clear(derivative);
    return bounded;
}

/* Whether the set has lost so many digits. */
static bool lost(const struct flow *f, slong digits)
{
    VECTOR(arb, box, FLOW_STATE);
    lohner_to_box(box, &f->set);
    return f->proving && flow_wide(box, (slong)(log2(10) * (double)digits));
}

/* The step's start in seconds, rounded towards 0 */
static double start_in_seconds(const struct flow *f)
{
    SCOPE(arb, t);
    SCOPE(arf, bound);
    arb_set_arf(t, f->now);
    arb_div(t, t, f->Omega, 64);
    arb_get_abs_lbound_arf(bound, t, 53);
    return f->direction * arf_get_d(bound, ARF_RND_DOWN);
}

/* s = Omega t - now, and whether |s| <= step for certain */
static bool within(const struct flow *f, arb_t s, const fmpq_t t, double step)
{
    SCOPE(arf, bound);
    arb_set_fmpq(s, t, f->prec);
    arb_mul(s, s, f->Omega, f->prec);
    arb_sub_arf(s, s, f->now, f->prec);
    arb_get_abs_ubound_arf(bound, s, 53);
    return arf_cmp_d(bound, step) <= 0;
}

/* Whether the times go away from 0. */
static bool times_ordered(const fmpq *times, slong count, int direction)
{
    for (slong k = 0; k < count; k++)
        if ((k == 0 ? fmpq_sgn(times) : fmpq_cmp(times + k, times + k - 1)) * direction < 0)
            return false;
    return true;
}

/* Whether the craft are closer than 2^CLOSE L_ref wherever in the set they are. */
static bool is_close(const struct flow *f)
{
    VECTOR(arb, box, FLOW_STATE);
    SCOPE(arb, r);
    SCOPE(arf, bound);
    lohner_to_box(box, &f->set);
    arb_dot(r, NULL, 0, box, 1, box, 1, FLOW_HALF, f->prec);
    arb_get_ubound_arf(bound, r, f->prec);
    return arf_cmp_2exp_si(bound, 2 * CLOSE) < 0;
}

/* Expands about the start of a step and proves its length. */
static enum flow_status begin_step(struct flow *f, slong digits, double *step)
{
    if (lost(f, digits))
        return FLOW_WIDE;
    expand_series(f);
    *step = step_length(f);
    if (*step < ldexp(1, LEAST_STEP) && is_close(f))
        return FLOW_CLOSE;
    *step = proved_step(f, *step);
    return *step > 0 ? FLOW_DONE : FLOW_WIDE;
}

static enum flow_status follow(struct flow *f, arb_srcptr initial, const fmpq *times, slong count,
                               slong digits, flow_receiver *receive, void *context, double *reached)
{
    slong k = 0;
    for (; k < count && fmpq_is_zero(times + k); k++)
        if (receive(context, k, times + k, initial) != 0)
            return FLOW_STOPPED;
    for (int steps = 0; k < count; steps++) {
        double step;
        enum flow_status status = steps < MOST_STEPS ? begin_step(f, digits, &step) : FLOW_STALLED;
        if (status != FLOW_DONE)
            return status;
        for (; k < count && within(f, f->s, times + k, step); k++) {
            state_at(f, f->state, f->s);
            *reached = fmpq_get_d(times + k);
            if (receive(context, k, times + k, f->state) != 0)
                return FLOW_STOPPED;
        }
        if (k == count)
            break;
        if (mag_get_d(arb_radref(f->s)) > step / 4 || !advance_set(f, step))
            return FLOW_WIDE; /* a time so vague might fall between all steps */
        *reached = start_in_seconds(f);
    }
    return FLOW_DONE;
}

enum flow_status flow_nonlinear_by(const struct flow_steps *how, const struct flow_parameters *p, arb_srcptr initial,
                                   const fmpq *times, slong count, slong digits, slong prec,
                                   flow_receiver *receive, void *context, double *reached)
{
    int direction = count > 0 && fmpq_sgn(times + count - 1) < 0 ? -1 : 1;
    *reached = 0;
    if (!flow_nonlinear_domain(p, initial) || !times_ordered(times, count, direction))
        return FLOW_DOMAIN;
    if (!flow_in_reach(p, times, count))
        return FLOW_STALLED;
    struct flow f;
    flow_init(&f, prec, how);
    f.direction = direction;
    set_problem(&f, how, p, initial);
    enum flow_status status = follow(&f, initial, times, count, digits, receive, context, reached);
    flow_clear(&f);
    return status;
}

enum flow_status flow_nonlinear(const struct flow_parameters *p, arb_srcptr initial,
                                const fmpq *times, slong count, slong digits, slong prec,
                                flow_receiver *receive, void *context, double *reached)
{
    static const struct flow_steps own;
    return flow_nonlinear_by(&own, p, initial, times, count, digits, prec, receive, context, reached);
}
