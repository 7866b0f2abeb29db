/*
 * The nonlinear flow: Taylor steps (taylor.h) of a set of states (lohner.h).
 *
 * Theorem (a step of length h). Let J(s) hold, for every state of a box around the set, the derivatives of
 * the flow over the time s in the directions of the basis. The flow takes centre + basis e into
 * path(s) + J(s) e, where path is the motion from the centre: the mean value theorem entry by entry,
 * for the box is convex and an enclosure of derivatives encloses their averages. Hence
 *   within the step, |s| <= h, a state lies in path(s) +- (rest of the path + sum_j ||J_ij|| reach_j);
 *   at its end the set moves by path(h), J(h), and both their rests.
 * The box needs no room to move: derivatives are taken at its points as initial states, and the rests
 * are proved for them all (taylor.c).
 */
#include <math.h>

#include "flow.h"
#include "lohner.h"
#include "taylor.h"

enum {
    GUARD = 12,          /* bits: rounding in one step takes eight, see test_flow                       */
    TUBE_ORDER = 12,     /* of the derivatives, which only steer the set: ...                           */
    STEADY = 10,         /* ... they need be known to 2^-10 only                                        */
    LEAST_STEP = -32,    /* log2 of radians; shorter steps ...                                          */
    CLOSE = -8,          /* ... with the craft this close, log2 of r / r_ref, lead into a collision     */
    MOST_HALVINGS = 32,  /* of a step that was too long to prove: beyond that the set is the reason     */
    MOST_STEPS = 100000, /* 30 days of Table 1 take some 500                                            */
    HALF = FLOW_STATE / 2 /* positions, then velocities */
};

struct flow {
    arb_t Omega, c1, c2, r_ref, speed;           /* speed = Omega r_ref                            */
    slong prec, bits;                            /* a step leaves out 2^-bits of the distance      */
    int direction;                               /* of time, 1 or -1                               */
    bool proving;
    arf_t now;                                   /* radians of orbit at the step's start; exact    */
    struct lohner set;
    struct jet path, tube, column[FLOW_STATE];   /* from the centre, the box, and its derivatives  */
    struct majorant path_bound, tube_bound, spread_bound; /* spread: columns under their reach     */
    arb_ptr power;                               /* of the time since the step's start             */
    arb_ptr state;                               /* handed on at the time s of the step            */
    arb_t s;
};

static void flow_init(struct flow *f, slong prec)
{
    f->prec = prec;
    f->bits = FLINT_MAX(prec - GUARD, 16);
    slong order = (slong)(0.5 * log(2) * (double)f->bits) + 4; /* least work where (h/R)^n = e^-2n = 2^-bits */
    arb_init(f->Omega);
    arb_init(f->c1);
    arb_init(f->c2);
    arb_init(f->r_ref);
    arb_init(f->speed);
    arf_init(f->now);
    lohner_init(&f->set);
    jet_init(&f->path, order);
    jet_init(&f->tube, TUBE_ORDER);
    for (int j = 0; j < FLOW_STATE; j++)
        jet_init(&f->column[j], TUBE_ORDER);
    majorant_init(&f->path_bound, order);
    majorant_init(&f->tube_bound, TUBE_ORDER);
    majorant_init(&f->spread_bound, TUBE_ORDER);
    f->power = _arb_vec_init(FLINT_MAX(order, TUBE_ORDER) + 1);
    f->state = _arb_vec_init(FLOW_STATE);
    arb_init(f->s);
}

static void flow_clear(struct flow *f)
{
    arb_clear(f->s);
    _arb_vec_clear(f->state, FLOW_STATE);
    _arb_vec_clear(f->power, FLINT_MAX(f->path.order, TUBE_ORDER) + 1);
    majorant_clear(&f->spread_bound);
    majorant_clear(&f->tube_bound);
    majorant_clear(&f->path_bound);
    for (int j = 0; j < FLOW_STATE; j++)
        jet_clear(&f->column[j]);
    jet_clear(&f->tube);
    jet_clear(&f->path);
    lohner_clear(&f->set);
    arf_clear(f->now);
    arb_clear(f->speed);
    arb_clear(f->r_ref);
    arb_clear(f->c2);
    arb_clear(f->c1);
    arb_clear(f->Omega);
}

bool flow_nonlinear_domain(const struct flow_parameters *p, arb_srcptr initial)
{
    arb_t square;
    arb_init(square);
    arb_dot(square, NULL, 0, initial, 1, initial, 1, HALF, 64);
    bool valid = flow_linear_domain(p, initial) && arb_is_positive(square)
                 && arb_is_positive(p->k_c) && arb_is_positive(p->m1) && arb_is_positive(p->m2)
                 && arb_is_finite(p->k_c) && arb_is_finite(p->m1) && arb_is_finite(p->m2);
    arb_clear(square);
    return valid;
}

/* Into radians of orbit and units of r_ref. A quotient that is exact stays so. */
static void set_problem(struct flow *f, const struct flow_parameters *p, arb_srcptr initial)
{
    arb_ptr state = _arb_vec_init(FLOW_STATE);
    arb_t mass;
    arb_init(mass);
    arb_set(f->Omega, p->Omega);
    arb_div(f->c2, p->C2, p->Omega, f->prec);
    arb_div(f->c1, p->C1, p->Omega, f->prec);
    arb_div(f->c1, f->c1, p->Omega, f->prec);
    arb_add(mass, p->m1, p->m2, f->prec);
    arb_mul(f->r_ref, p->m2, p->L_ref, f->prec);
    arb_div(f->r_ref, f->r_ref, mass, f->prec);
    arb_mul(f->speed, f->r_ref, f->Omega, f->prec);
    for (int i = 0; i < FLOW_STATE; i++)
        arb_div(state + i, initial + i, i < HALF ? f->r_ref : f->speed, f->prec);
    lohner_from_box(&f->set, state);
    jet_constants(&f->path, f->c1, f->c2);
    jet_constants(&f->tube, f->c1, f->c2);
    _arb_vec_clear(state, FLOW_STATE);
    arb_clear(mass);
}

/* q = 1/|x| of the state whose coefficients 0 stand in the jet */
static void start_q(struct jet *jet, slong prec)
{
    arb_ptr q = jet->c[FLOW_STATE];
    arb_zero(q);
    for (int i = 0; i < HALF; i++)
        arb_addmul(q, jet->c[i], jet->c[i], prec);
    arb_sqrt(q, q, prec);
    arb_inv(q, q, prec);
}

/* Direction j of the basis, in which q = 1/|x| changes by -q^3 x.dx */
static void start_column(struct flow *f, int j)
{
    arb_ptr const *c = f->tube.c;
    arb_ptr *d = f->column[j].c;
    arb_zero(d[FLOW_STATE]);
    for (int i = 0; i < FLOW_STATE; i++) {
        arb_set_d(d[i], f->set.basis[i][j]);
        if (i < HALF)
            arb_submul(d[FLOW_STATE], c[i], d[i], LOHNER_BITS);
    }
    for (int i = 0; i < 3; i++)
        arb_mul(d[FLOW_STATE], d[FLOW_STATE], c[FLOW_STATE], LOHNER_BITS);
}

static void expand(struct flow *f)
{
    for (int i = 0; i < FLOW_STATE; i++)
        arb_set(f->path.c[i], f->set.centre + i);
    start_q(&f->path, f->prec);
    jet_extend(&f->path, f->prec, (double)f->bits / (double)f->path.order);
    if (!f->proving)
        return;
    arb_ptr box = _arb_vec_init(FLOW_STATE);
    lohner_to_box(box, &f->set);
    for (int i = 0; i < FLOW_STATE; i++)
        arb_set_round(f->tube.c[i], box + i, LOHNER_BITS);
    _arb_vec_clear(box, FLOW_STATE);
    start_q(&f->tube, LOHNER_BITS);
    jet_extend(&f->tube, LOHNER_BITS, 0);
    for (int j = 0; j < FLOW_STATE; j++) {
        start_column(f, j);
        jet_extend_column(&f->column[j], &f->tube, LOHNER_BITS);
    }
}

/* log2 of the largest coefficient k of the position; a guide, no bound */
static double position_size(const struct flow *f, slong k)
{
    double size = -HUGE_VAL;
    mag_t m;
    mag_init(m);
    for (int i = 0; i < HALF; i++) {
        arb_get_mag(m, f->path.c[i] + k);
        size = fmax(size, mag_get_d_log2_approx(m));
    }
    mag_clear(m);
    return size;
}

/* The step at which the last two coefficients fall to 2^-bits of the distance: a dyadic of 8 bits. */
static double step_length(const struct flow *f)
{
    double step = 0, r = position_size(f, 0); /* log2, so that 1 radian is the longest: at rest */
    for (slong k = f->path.order - 1; k <= f->path.order; k++)
        step = fmin(step, (r - (double)f->bits - position_size(f, k)) / (double)k);
    int exponent;
    double fraction = frexp(exp2(step), &exponent);
    return ldexp(floor(ldexp(fraction, 8)), exponent - 8);
}

/* Whether the derivatives are known well enough to steer by: a step would else inflate the set. */
static bool steady(const struct majorant *spread)
{
    mag_t all, rest;
    mag_init(all);
    mag_init(rest);
    for (int i = 0; i < FLOW_STATE; i++) {
        mag_max(all, all, spread->suffix[i]);
        mag_max(rest, rest, spread->rest + i);
    }
    mag_mul_2exp_si(rest, rest, STEADY);
    bool result = mag_cmp(rest, all) <= 0;
    mag_clear(all);
    mag_clear(rest);
    return result;
}

/* Bounds on |s| <= step; false where it is too long for them. */
static bool prove(struct flow *f, double step)
{
    mag_t h, one;
    mag_init(h);
    mag_init(one);
    mag_set_d(h, step);
    mag_one(one);
    majorant_of(&f->path_bound, &f->path, one, 1, h);
    majorant_of(&f->tube_bound, &f->tube, one, 1, h);
    majorant_of(&f->spread_bound, f->column, f->set.reach, FLOW_STATE, h);
    bool proved = majorant_prove(&f->path_bound, NULL, h) && majorant_prove(&f->tube_bound, NULL, h)
                  && majorant_prove(&f->spread_bound, &f->tube_bound, h) && steady(&f->spread_bound);
    mag_clear(h);
    mag_clear(one);
    return proved;
}

/* The longest of step, step/2, ... that can be proved, or 0 */
static double proved_step(struct flow *f, double step)
{
    for (int halvings = 0; halvings < MOST_HALVINGS; halvings++, step /= 2)
        if (!f->proving || prove(f, step))
            return step;
    return 0;
}

/* The motion from the centre at s, |s| <= h. */
static void path_at(const struct flow *f, arb_ptr state, const arb_t s)
{
    slong terms = f->path.order + 1;
    _arb_vec_set_powers(f->power, s, terms, f->prec);
    for (int i = 0; i < FLOW_STATE; i++) {
        arb_dot(state + i, NULL, 0, f->path.c[i], 1, f->power, 1, terms, f->prec);
        if (f->proving)
            arb_add_error_mag(state + i, f->path_bound.rest + i);
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
            arb_add_error_mag(state + i, spread->rest + i);
        }
        arb_mul(state + i, state + i, i < HALF ? f->r_ref : f->speed, f->prec);
    }
}

/* The set at the end of the step; false if it is lost. */
static bool advance(struct flow *f, double step)
{
    arb_ptr image = _arb_vec_init(FLOW_STATE);
    arb_mat_t derivative;
    arb_t s;
    bool bounded = true;
    arb_init(s);
    arb_mat_init(derivative, FLOW_STATE, FLOW_STATE);
    arb_set_d(s, f->direction * step);
    arf_add(f->now, f->now, arb_midref(s), ARF_PREC_EXACT, ARF_RND_DOWN);
    path_at(f, image, s);
    if (f->proving) {
        _arb_vec_set_powers(f->power, s, TUBE_ORDER + 1, LOHNER_BITS);
        for (int i = 0; i < FLOW_STATE; i++)
            for (int j = 0; j < FLOW_STATE; j++)
                arb_dot(arb_mat_entry(derivative, i, j), NULL, 0, f->column[j].c[i], 1, f->power, 1,
                        TUBE_ORDER + 1, LOHNER_BITS);
        bounded = lohner_move(&f->set, image, derivative, f->spread_bound.rest);
    } else {
        lohner_from_box(&f->set, image);
    }
    arb_clear(s);
    arb_mat_clear(derivative);
    _arb_vec_clear(image, FLOW_STATE);
    return bounded;
}

bool flow_wide(arb_srcptr state, slong bits)
{
    mag_t radius, size, m;
    mag_init(radius);
    mag_init(size);
    mag_init(m);
    for (int i = 0; i < FLOW_STATE; i++) {
        mag_max(radius, radius, arb_radref(state + i));
        arb_get_mag(m, state + i);
        mag_max(size, size, m);
    }
    mag_mul_2exp_si(size, size, -bits);
    bool wide = mag_is_inf(radius) || mag_cmp(radius, size) > 0;
    mag_clear(radius);
    mag_clear(size);
    mag_clear(m);
    return wide;
}

/* Whether so many digits of the set are lost; no later step could mend that. */
static bool lost(const struct flow *f, slong digits)
{
    arb_ptr box = _arb_vec_init(FLOW_STATE);
    lohner_to_box(box, &f->set);
    bool wide = f->proving && flow_wide(box, (slong)(log2(10) * (double)digits));
    _arb_vec_clear(box, FLOW_STATE);
    return wide;
}

/* The step's start in seconds, rounded towards 0 */
static double seconds(const struct flow *f)
{
    arb_t t;
    arf_t bound;
    arb_init(t);
    arf_init(bound);
    arb_set_arf(t, f->now);
    arb_div(t, t, f->Omega, 64);
    arb_get_abs_lbound_arf(bound, t, 53);
    double result = f->direction * arf_get_d(bound, ARF_RND_DOWN);
    arb_clear(t);
    arf_clear(bound);
    return result;
}

/* s = Omega t - now, and whether |s| <= step for certain */
static bool within(const struct flow *f, arb_t s, const fmpq_t t, double step)
{
    arf_t bound;
    arf_init(bound);
    arb_set_fmpq(s, t, f->prec);
    arb_mul(s, s, f->Omega, f->prec);
    arb_sub_arf(s, s, f->now, f->prec);
    arb_get_abs_ubound_arf(bound, s, 53);
    bool inside = arf_cmp_d(bound, step) <= 0;
    arf_clear(bound);
    return inside;
}

/* Times monotone away from 0? */
static bool ordered(const fmpq *times, slong count, int direction)
{
    for (slong k = 0; k < count; k++)
        if ((k == 0 ? fmpq_sgn(times) : fmpq_cmp(times + k, times + k - 1)) * direction < 0)
            return false;
    return true;
}

/* Expands about the start of a step and proves its length. */
static enum flow_status begin_step(struct flow *f, slong digits, double *step)
{
    if (lost(f, digits))
        return FLOW_WIDE;
    expand(f);
    *step = step_length(f);
    if (*step < ldexp(1, LEAST_STEP) && position_size(f, 0) < CLOSE)
        return FLOW_COLLISION;
    *step = proved_step(f, *step);
    return *step > 0 ? FLOW_DONE : FLOW_WIDE;
}

static enum flow_status run(struct flow *f, arb_srcptr initial, const fmpq *times, slong count,
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
        if (mag_get_d(arb_radref(f->s)) > step / 4 || !advance(f, step))
            return FLOW_WIDE; /* a time so vague might fall between all steps */
        *reached = seconds(f);
    }
    return FLOW_DONE;
}

static enum flow_status flow(bool proving, const struct flow_parameters *p, arb_srcptr initial,
                             const fmpq *times, slong count, slong digits, slong prec,
                             flow_receiver *receive, void *context, double *reached)
{
    int direction = count > 0 && fmpq_sgn(times + count - 1) < 0 ? -1 : 1;
    *reached = 0;
    if (!flow_nonlinear_domain(p, initial) || !ordered(times, count, direction))
        return FLOW_DOMAIN;
    struct flow f;
    flow_init(&f, prec);
    f.proving = proving;
    f.direction = direction;
    set_problem(&f, p, initial);
    enum flow_status status = run(&f, initial, times, count, digits, receive, context, reached);
    flow_clear(&f);
    return status;
}

enum flow_status flow_nonlinear(const struct flow_parameters *p, arb_srcptr initial,
                                const fmpq *times, slong count, slong digits, slong prec,
                                flow_receiver *receive, void *context, double *reached)
{
    return flow(true, p, initial, times, count, digits, prec, receive, context, reached);
}

enum flow_status flow_nonlinear_unproved(const struct flow_parameters *p, arb_srcptr initial,
                                         const fmpq *times, slong count, slong digits, slong prec,
                                         flow_receiver *receive, void *context, double *reached)
{
    return flow(false, p, initial, times, count, digits, prec, receive, context, reached);
}

slong flow_precision(slong digits, double radians)
{
    /* 36 bits go to rests, to growth in the first day, and to coordinates smaller than r_ref and its speed */
    return (slong)(log2(10) * (double)digits + 60 + 0.1 * fabs(radians));
}
