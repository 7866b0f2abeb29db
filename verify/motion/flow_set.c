/*
 * Theorem (a step of a set). The set is { P(e) + B s : |e_i| <= 1, |s_j| <= radius_j }, P polynomials, for parameters that are
 * polynomials in e too. For each e: the motion from P(e) after h has the series of taylor.h, here in models, of which
 * majorant_prove bounds what is left out: its norms hold for each e. The motion from P(e) + B s differs from it by J(e, s) B s,
 * where J lies in the enclosure of the derivatives from all of { P(e) + B s : s }, a box and thus convex: the mean value theorem,
 * for this e. These derivatives are models of degree 1, J_0 + sum e_i J_i + rest. So the set after h is
 *
 *     { P'(e) + d + J(e, s) B s },   d the rests of the models and of the series,
 *
 * of which lohner_move makes P'(e) + B' s'. No roundings are left: models and balls take them up.
 *
 * The error terms; in tests/motion/test_flow_set.c a motion is lost without each:
 *   (S1) the rest of the models P', at first those given      (S2) the remainder of their series in time
 *   (S3) the remainder of J B s at the step's end             (S4) the rests of J, in derivative[0]
 *   (S5) the parts of J that are linear in e                  (expansion_move)
 *   (S6) the start of J is from all of P(e) + B s             (expand_models)
 *   (S7) within the step all of |J B s|                       (row)
 *   (S8) the time is a ball, the step's polynomial is evaluated at a binary64 near it
 *   (S9) after a split either half is followed                (piece_split)
 *
 * A split halves the unknowns, not time: { P(e) + B s } is the union of its halves, e_i = (e'_i +- 1)/2, wherever it stands.
 */
#include "motion/flow_set.h"

#include <flint/thread_support.h>
#include <math.h>
#include <pthread.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "motion/expansion.h"
#include "text/message.h"
#include "text/progress.h"
#include "text/scope.h"

enum {
    SET_ORDER = 14,           /* of the states' series, and ... */
    DERIVATIVE_ORDER = 8, /* ... of the derivatives' */
    MOST_SET_HALVINGS = 6,    /* of a step before it is given up */
    MOST_ROUNDS = 10000,
    BITS = 64
};

/* A step's series leave out this part of the set; where its models leave out more than that part, and than roundings, it is split. */
static const double LEFT_OUT = 1e-7, MOST_ADDED = 1.5e-7, ROUNDINGS = 1e-11;

static const double LONGEST = 0.25; /* step, radians: at rest the series propose none */

/* Part of the set, and where it stands */
struct piece {
    struct model *model; /* SET_MODELS                                 */
    struct lohner rest; /* its centre is 0                             */
    arf_t now;          /* radians of orbit, exact                     */
    slong k;            /* rows that hold it                           */
    int split;          /* the unknown that it is to be halved along: -1 for none */
    enum flow_status status; /* FLOW_DONE while all is well            */
};

struct follower {
    const struct flow_set *set;
    struct expansion of;
    struct model *end, at; /* of the states at the step's end, and of an answer */
    int direction;
};

/* ---- pieces ---- */

/* What the models of the states are off at first is the set's rest: unknowns of its own, not intervals of the models' arithmetic. */
static void piece_init(struct piece *p, const struct model *model)
{
    VECTOR(arb, off, FLOW_STATE);
    *p = (struct piece){.split = -1, .model = models_init(SET_MODELS, model->space)};
    for (int v = 0; v < SET_MODELS; v++)
        model_set(&p->model[v], model + v);
    for (int v = 0; v < FLOW_STATE; v++) {
        mag_set_d(arb_radref(off + v), p->model[v].rest);
        p->model[v].rest = 0;
    }
    lohner_init(&p->rest);
    lohner_from_box(&p->rest, off);
    arf_init(p->now);
}

static void piece_clear(struct piece *p)
{
    models_clear(p->model);
    lohner_clear(&p->rest);
    arf_clear(p->now);
}

/* The upper half of p, which becomes the lower one; either has all that p is off */
static void piece_split(struct piece *upper, struct piece *p)
{
    piece_init(upper, p->model);
    memcpy(upper->rest.basis, p->rest.basis, sizeof p->rest.basis);
    for (int j = 0; j < FLOW_STATE; j++)
        mag_set(upper->rest.radius + j, p->rest.radius + j);
    arf_set(upper->now, p->now);
    upper->k = p->k;
    for (int v = 0; v < SET_MODELS; v++) {
        model_halve(&upper->model[v], p->split, 1);
        model_halve(&p->model[v], p->split, -1);
    }
    p->split = -1;
}

/* The unknown on which what is not linear depends most, or else what is linear; -1 where nothing depends on any */
static int steepest(const struct piece *p)
{
    const struct space *s = p->model[0].space;
    double most = 0;
    int found = -1;
    for (int i = 0; i < s->variables; i++) {
        double bend = 0;
        for (int v = 0; v < FLOW_STATE; v++)
            for (int b = 1; b < s->size; b++)
                bend += (b <= s->variables ? 1e-9 : 1) * fabs(p->model[v].c[b]) * s->exponent[b * s->variables + i];
        if (bend > most) {
            most = bend;
            found = i;
        }
    }
    return found;
}

/* ---- steps ---- */

static void follower_init(struct follower *f, const struct flow_set *set, int direction)
{
    f->set = set;
    f->direction = direction;
    expansion_init(&f->of, &closed_loop, set->how.order != 0 ? set->how.order : SET_ORDER,
                   set->how.derivative_order != 0 ? set->how.derivative_order : DERIVATIVE_ORDER, &set->space, &set->linear);
    f->end = models_init(FLOW_STATE, &set->space);
    model_init(&f->at, &set->space);
    for (int i = 0; i < 3; i++) { /* the constants 1, 2, 3 */
        SCOPE(arb, x);
        arb_set_ui(x, (ulong)i + 1);
        model_set_ball(f->of.path.m[JET_SERIES + i], x);
        model_set_ball(f->of.hull.m[JET_SERIES + i], x);
    }
}

static void follower_clear(struct follower *f)
{
    expansion_clear(&f->of);
    models_clear(f->end);
    model_clear(&f->at);
}

/* From P(e), and from all of P(e) + B s, linear in e, s in the rest (S6) */
static void expand_models(struct follower *f, const struct piece *p)
{
    VECTOR(arb, box, FLOW_STATE);
    lohner_to_box(box, &p->rest);
    for (int v = 0; v < SET_CHARGE; v++) {
        const int place = v < FLOW_STATE ? v : JET_SERIES + 3 + v - FLOW_STATE;
        model_set(f->of.path.m[place], &p->model[v]);
        model_set(f->of.hull.m[place], &p->model[v]);
        if (v < FLOW_STATE)
            model_widen(f->of.hull.m[v], arb_radref(box + v));
    }
    expansion_path(&f->of, BITS, 0);
    expansion_derivatives(&f->of, &p->rest);
}

/* How far the polynomial of a coordinate goes; a guide, no bound */
static double width(const struct model *x)
{
    return model_size(x) - fabs(x->c[0]);
}

/* Where terms fall to a part of the set, or of rounding */
static double set_step_length(const struct follower *f, const struct piece *p)
{
    double left_out = 0x1p-46;
    for (int v = 0; v < FLOW_STATE; v++)
        left_out = fmax(left_out, LEFT_OUT * width(&p->model[v]));
    return f->set->how.step > 0 ? f->set->how.step : expansion_step(&f->of, log2(left_out), LONGEST);
}

/* P' and what the set after the step is off from it, but for J B s: (S1) to (S3) */
static void find_end(struct follower *f, mag_ptr error, double step)
{
    SCOPE(mag, rest);
    for (int v = 0; v < FLOW_STATE; v++) {
        model_evaluate(&f->end[v], f->of.path.m[v], (int)f->of.path.order + 1, f->direction * step);
        mag_set_d(rest, f->end[v].rest);
        mag_add(error + v, f->of.path_bound.remainder + v, f->of.spread_bound.remainder + v);
        mag_add(error + v, error + v, rest);
    }
}

/* Whether the step's polynomials leave out so much that they should be those of a smaller set */
static bool is_loose(const struct follower *f, const struct piece *p)
{
    double widest = 0, left_out = 0;
    for (int v = 0; v < FLOW_STATE; v++) {
        widest = fmax(widest, width(&p->model[v]));
        left_out = fmax(left_out, f->end[v].rest);
    }
    return left_out > fmax(MOST_ADDED * widest, ROUNDINGS);
}

/* The set at the end of the step; false if it is lost. */
static bool advance_models(struct follower *f, struct piece *p, double step, mag_srcptr error)
{
    VECTOR(arb, nothing, FLOW_STATE);
    SCOPE(arb, h);
    arb_set_d(h, f->direction * step);
    for (int v = 0; v < FLOW_STATE; v++) {
        f->end[v].rest = 0; /* it is in the error */
        model_set(&p->model[v], &f->end[v]);
    }
    arf_add(p->now, p->now, arb_midref(h), ARF_PREC_EXACT, ARF_RND_DOWN);
    return expansion_move(&p->rest, nothing, &f->of, h, error);
}

/* The model of state or series v at s radians after now, |s| <= step, for all of the piece */
static void row(struct follower *f, int v, const arb_t s, double step)
{
    const double near = arf_get_d(arb_midref(s), ARF_RND_NEAR);
    const struct majorant *path = &f->of.path_bound;
    SCOPE(arb, off, error);
    SCOPE(mag, by, h, most);
    if (arb_is_zero(s)) { /* there all is known but B s */
        model_set(&f->at, f->of.path.m[v]);
        model_widen(&f->at, f->of.spread_bound.size[v]);
        return;
    }
    model_evaluate(&f->at, f->of.path.m[v], (int)path->order + 1, near);
    arb_add_error_mag(error, v < JET_STATES ? path->remainder + v : path->tail + v);
    expansion_spread(error, &f->of, v); /* (S7) */
    arb_set_d(off, near); /* (S8): (|s - near|/h) n sum |a_k| h^k */
    arb_sub(off, off, s, BITS);
    arb_get_mag(by, off);
    mag_set_d(h, step);
    mag_div(by, by, h);
    mag_mul_ui(by, by, (ulong)path->order);
    mag_add(most, path->suffix[v] + 1, path->size[v] + path->order);
    mag_mul(by, by, most);
    arb_add_error_mag(error, by);
    model_widen(&f->at, arb_radref(error));
}

/* Q_ref + dQ, in units of the set's, linear in the unknowns but for a rest; false where it may be >= 0 */
static bool charge_row(arb_t x, struct follower *f, const struct piece *p, const arb_t s, double step)
{
    MODEL(product, &f->set->linear);
    MODEL(factor, &f->set->linear);
    MODEL(length, &f->set->linear);
    row(f, JET_CHARGE, s, step);
    model_set(&product, &f->at);
    row(f, JET_STATES - 1, s, step);
    model_set(&factor, &f->at); /* q */
    model_product(&factor, &factor, &factor);
    model_inverse_root(&length, &factor);
    model_product(&product, &product, &length);
    model_set(&factor, &p->model[SET_CHARGE]);
    model_product(&product, &product, &factor);
    model_range(x, &product);
    return arb_is_negative(x);
}

/* ---- all pieces ---- */

struct work {
    const struct flow_set *set;
    const fmpq *times;
    slong limit, proved; /* rows that are wanted and that no piece has failed to prove, and those that all have */
    double now;        /* radians that all have been followed            */
    enum flow_status status;
    arb_ptr low, high; /* of all rows                                    */
    struct piece *piece;
    int count;
    pthread_mutex_t lock; /* of the rows                                 */
    struct follower follower[MOST_THREADS];
};

static void work_clear(struct work *w)
{
    pthread_mutex_destroy(&w->lock);
    for (int i = 0; i < w->set->threads; i++)
        follower_clear(&w->follower[i]);
    for (int i = 0; i < w->count; i++)
        piece_clear(&w->piece[i]);
    free(w->piece);
}

/* Row k's bounds are made wide enough for the piece, if there are any, and charges by (21). */
static enum flow_status widen_row(struct work *w, struct follower *f, const struct piece *p, const arb_t s, double step)
{
    VECTOR(arb, x, SET_BOUNDS);
    SCOPE(arb, end);
    if (w->set->charged && !charge_row(x + FLOW_STATE, f, p, s, step))
        return FLOW_UNCHARGED;
    arb_mul(x + FLOW_STATE, x + FLOW_STATE, w->set->charge, BITS);
    for (int v = 0; v < FLOW_STATE; v++) {
        row(f, v, s, step);
        model_range(x + v, &f->at);
        arb_mul(x + v, x + v, w->set->unit, BITS);
        if (v >= FLOW_HALF)
            arb_mul(x + v, x + v, w->set->Omega, BITS);
    }
    if (!_arb_vec_is_finite(x, SET_BOUNDS))
        return FLOW_WIDE;
    pthread_mutex_lock(&w->lock);
    for (int v = 0; v < SET_BOUNDS; v++) {
        arb_ptr low = w->low + SET_BOUNDS * p->k + v, high = w->high + SET_BOUNDS * p->k + v;
        arb_get_lbound_arf(arb_midref(end), x + v, BITS);
        arb_min(low, low, end, BITS);
        arb_get_ubound_arf(arb_midref(end), x + v, BITS);
        arb_max(high, high, end, BITS);
    }
    pthread_mutex_unlock(&w->lock);
    return FLOW_DONE;
}

/* A step of the piece, or that it should be split, or that no step is proved */
static void follow_piece(struct work *w, struct follower *f, struct piece *p)
{
    VECTOR(mag, error, FLOW_STATE);
    SCOPE(arb, s);
    expand_models(f, p);
    const double step = expansion_prove(&f->of, &p->rest, set_step_length(f, p), MOST_SET_HALVINGS);
    find_end(f, error, step);
    if (w->count < w->set->most_pieces && (!(step > 0) || is_loose(f, p)) && (p->split = steepest(p)) >= 0)
        return;
    for (; p->k < w->limit && time_within(s, w->times + p->k, w->set->Omega, p->now, step, 2 * BITS); p->k++)
        if ((p->status = widen_row(w, f, p, s, step)) != FLOW_DONE)
            return;
    if (!(step > 0 && advance_models(f, p, step, error)))
        p->status = FLOW_WIDE;
}

/* Some of the pieces, each of them once in a round */
static void follow_some(slong thread, void *context)
{
    struct work *w = context;
    for (int i = (int)thread; i < w->count; i += w->set->threads)
        if (w->piece[i].k < w->limit)
            follow_piece(w, &w->follower[thread], &w->piece[i]);
}

/* What a round has found: pieces to be split, as long as there may be more, how far all are, and what cannot be proved */
static void end_round(struct work *w)
{
    const int before = w->count;
    w->now = HUGE_VAL;
    w->proved = w->limit;
    for (int i = 0; i < before; i++) {
        if (w->piece[i].split >= 0 && w->count < w->set->most_pieces) {
            struct piece *upper = APPENDED(w->piece, w->count);
            piece_split(upper, &w->piece[i]);
        }
        struct piece *p = &w->piece[i];
        p->split = -1;
        if (p->status != FLOW_DONE && p->k < w->limit) {
            w->status = p->status;
            w->limit = p->k;
        }
        w->now = fmin(w->now, fabs(arf_get_d(p->now, ARF_RND_DOWN)));
        w->proved = FLINT_MIN(w->proved, p->k);
    }
}

/* Rows that all pieces have, from the k-th on; false where the receiver has enough */
static bool hand_rows(const struct work *w, slong k, flow_receiver *receive, void *context)
{
    VECTOR(arb, state, SET_BOUNDS);
    for (; k < w->proved; k++) {
        for (int v = 0; v < SET_BOUNDS; v++)
            arb_set_interval_arf(state + v, arb_midref(w->low + SET_BOUNDS * k + v), arb_midref(w->high + SET_BOUNDS * k + v), BITS);
        if (receive(context, k, w->times + k, state) != 0)
            return false;
    }
    return true;
}

/* Seconds up to which all pieces, or rows, have been proved */
static double seconds_proved(const struct work *w)
{
    SCOPE(arf, now);
    arf_set_d(now, w->now);
    return fmax(seconds_within(now, w->set->Omega), w->proved > 0 ? fabs(fmpq_get_d(w->times + w->proved - 1)) : 0);
}

static void follow_all(struct work *w, flow_receiver *receive, void *context, double *reached)
{
    struct progress progress = progress_begin(true);
    const uint64_t wanted = (uint64_t)fabs(fmpq_get_d(w->times + w->limit - 1));
    for (int rounds = 0; w->proved < w->limit && w->status != FLOW_STOPPED; rounds++) {
        const slong k = w->proved;
        if (rounds == MOST_ROUNDS) {
            w->status = FLOW_STALLED;
            break;
        }
        flint_parallel_do(follow_some, w, w->set->threads, -1, FLINT_PARALLEL_STRIDED);
        end_round(w);
        *reached = seconds_proved(w);
        progress_show(&progress, (uint64_t)*reached, wanted);
        if (!hand_rows(w, k, receive, context))
            w->status = FLOW_STOPPED;
    }
    progress_end(&progress);
}

enum flow_status flow_set(const struct flow_set *s, const fmpq *times, slong count, flow_receiver *receive, void *context,
                          double *reached)
{
    const int direction = fmpq_sgn(times + count - 1) < 0 ? -1 : 1;
    VECTOR(arb, low, SET_BOUNDS * count);
    VECTOR(arb, high, SET_BOUNDS * count);
    OWNED(work) w = {.set = s, .times = times, .limit = count, .low = low, .high = high};
    for (slong i = 0; i < SET_BOUNDS * count; i++) {
        arb_pos_inf(low + i);
        arb_neg_inf(high + i);
    }
    piece_init(APPENDED(w.piece, w.count), s->model);
    for (int i = 0; i < s->threads; i++)
        follower_init(&w.follower[i], s, direction);
    pthread_mutex_init(&w.lock, NULL);
    flint_set_num_threads(s->threads);
    *reached = 0;
    follow_all(&w, receive, context, reached);
    *reached *= direction;
    flint_set_num_threads(1);
    return w.status;
}

void flow_set_init(struct flow_set *s, int variables, int degree)
{
    *s = (struct flow_set){.most_pieces = 1, .threads = (int)FLINT_MAX(1, FLINT_MIN(MOST_THREADS, sysconf(_SC_NPROCESSORS_ONLN)))};
    space_init(&s->space, variables, degree);
    space_init(&s->linear, variables, 1);
    s->model = models_init(SET_MODELS, &s->space);
    arb_init(s->Omega);
    arb_init(s->unit);
    arb_init(s->charge);
}

void flow_set_clear(struct flow_set *s)
{
    models_clear(s->model);
    space_clear(&s->space);
    space_clear(&s->linear);
    arb_clear(s->Omega);
    arb_clear(s->unit);
    arb_clear(s->charge);
}
