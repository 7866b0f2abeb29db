/*
 * The paper's simulation, its linear model and their variations: a table of trajectories, and what is measured of each.
 * Samples come from certified flows; what happens between and after them is bounded in trajectory.h.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "claims/claim.h"
#include "claims/trajectory.h"
#include "sheet/input.h"
#include "text/scope.h"

enum { MEASURE_BITS = 128 };

/* What a name asks for. */
struct request {
    const struct trajectory *of, *beside; /* beside NULL: none */
    int which;
    long numbers[2];                      /* the hours, or the part of an exit; -1: none */
    slong from, to;                       /* samples */
    bool high;                            /* of the extremes the largest */
};

/* ---- measures: false where nothing is proved ---- */

/* The largest size, between samples too. */
static bool supremum(arb_t x, const struct request *r)
{
    return trajectory_supremum(x, r->of, r->which, r->from, r->to);
}

/* What the energy at a sample allows from then on, for ever. */
static bool reach_from(arb_t x, const struct trajectory *t, int which, slong k)
{
    struct bounds b;
    bounds_init(&b);
    const bool bounded = trajectory_bounds(&b, t, k);
    arb_set(x, b.of[which]);
    bounds_clear(&b);
    return bounded;
}

/* From then on for ever: the last sample's energy allows no more. */
static bool ever(arb_t x, const struct request *r)
{
    SCOPE(arb, after);
    return supremum(x, r) && reach_from(after, r->of, r->which, r->to) && arb_lt(after, x);
}

static bool bound(arb_t x, const struct request *r)
{
    return reach_from(x, r->of, r->which, r->from);
}

static bool peak(arb_t x, const struct request *r)
{
    trajectory_peak(x, r->of, NULL, r->which, r->from, r->to);
    return true;
}

/* The least or the largest value on samples. */
static bool extreme(arb_t x, const struct request *r)
{
    SCOPE(arb, value);
    for (slong k = r->from; k <= r->to; k++) {
        trajectory_value(value, r->of, k, r->which);
        if (k == r->from)
            arb_set(x, value);
        (r->high ? arb_max : arb_min)(x, x, value, MEASURE_BITS);
    }
    return true;
}

static bool energy(arb_t x, const struct request *r)
{
    trajectory_energy(x, r->of, r->from);
    return true;
}

/* In hours, when it is below a part of its start until the last sample; ... */
static bool exit_of(arb_t hours, const struct request *r)
{
    SCOPE(arb, limit);
    arb_div_si(limit, trajectory_sample(r->of, 0) + r->which, r->numbers[0], MEASURE_BITS);
    return trajectory_exit(hours, r->of, r->which, limit);
}

/* ... and for ever, by the energy of the last sample. */
static bool settled(arb_t hours, const struct request *r)
{
    SCOPE(arb, limit, after);
    arb_div_si(limit, trajectory_sample(r->of, 0) + r->which, r->numbers[0], MEASURE_BITS);
    return exit_of(hours, r) && reach_from(after, r->of, r->which, r->of->count - 1) && arb_lt(after, limit);
}

/* The largest difference on samples from the start on, ... */
static bool gap(arb_t x, const struct request *r)
{
    trajectory_peak(x, r->of, r->beside, r->which, 0, r->to);
    return true;
}

/* ... and between them. */
static bool gap_between(arb_t x, const struct request *r)
{
    const struct trajectory *const both[] = {r->of, r->beside};
    struct bounds b;
    SCOPE(arb, excess);
    bool bounded = gap(x, r);
    bounds_init(&b);
    for (int i = 0; i < 2; i++) {
        bounded = trajectory_bounds(&b, both[i], 0) && bounded;
        bound_between_samples(excess, both[i], &b, r->which);
        arb_add(x, x, excess, MEASURE_BITS);
    }
    bounds_clear(&b);
    return bounded;
}

/* The largest difference on samples as a part of what the linear motion beside may still reach; ... */
static bool part(arb_t x, const struct request *r)
{
    SCOPE(arb, left, y);
    bool bounded = true;
    for (slong k = r->from; k <= r->to && bounded; k++) {
        bounded = reach_from(left, r->beside, r->which, k);
        trajectory_peak(y, r->of, r->beside, r->which, k, k);
        arb_div(y, y, left, MEASURE_BITS);
        arb_max(x, x, y, MEASURE_BITS);
    }
    return bounded;
}

/* ... and the first sample, in hours, where that is a tenth; none is the first after one that leaves it open. */
static bool parted(arb_t hours, const struct request *r)
{
    struct request here = *r;
    bool bounded = true, found = false;
    SCOPE(arb, x);
    for (slong k = 0; k <= r->to && bounded && !found; k++) {
        here.from = here.to = k;
        arb_zero(x);
        bounded = part(x, &here);
        arb_mul_ui(x, x, 10, MEASURE_BITS);
        arb_sub_ui(x, x, 1, MEASURE_BITS);
        found = arb_is_positive(x);
        bounded = bounded && (found || arb_is_nonpositive(x));
        arb_set_si(hours, k * r->of->step);
    }
    arb_div_ui(hours, hours, HOUR, MEASURE_BITS);
    return bounded && found;
}

/* The changes of sign that samples prove at least; of a rate, the turning points. */
static bool sign_changes(arb_t x, const struct request *r)
{
    int changes = 0, sign = 0;
    for (slong k = r->from; k <= r->to; k++) {
        arb_srcptr value = trajectory_sample(r->of, k) + r->which;
        const int now = arb_is_positive(value) - arb_is_negative(value);
        changes += now * sign < 0;
        sign = now != 0 ? now : sign;
    }
    arb_set_si(x, changes);
    return true;
}

/* Of variables up to the last that it can be of, in their units or not; and whether it takes a motion beside. */
static const struct measure {
    const char *name;
    bool (*of)(arb_t x, const struct request *r);
    int last;
    bool in_units, compares;
} measures[] = {
    {"sup_", supremum, PRODUCT, true, false},        {"ever_", ever, PLACE_Z, true, false},
    {"bound_", bound, PLACE_Z, true, false},         {"peak_", peak, ERROR_Z, true, false},
    {"low_", extreme, ERROR_Z, true, false},         {"high_", extreme, ERROR_Z, true, false},
    {"at_", extreme, ERROR_Z, true, false},          {"energy_of_", energy, PSI, false, false},
    {"exit_", exit_of, PLACE_Z, false, false},       {"settled_", settled, PLACE_Z, false, false},
    {"gap_", gap, ERROR_Z, true, true},              {"between_", gap_between, PRODUCT, true, true},
    {"part_", part, PLACE_Z, false, true},           {"parted_", parted, PLACE_Z, false, true},
    {"changes_", sign_changes, PLACE_Z, false, false},
};
enum { MEASURES = sizeof measures / sizeof *measures };

/* What a name asks for, the numbers in it as written; false: nothing that there is. */
static bool read_name(struct request *r, const struct measure **m, const char *name)
{
    static const char *const forms[] = {"%s%s", "%s%s_%ld", "%s%s_%ld_%ld"};
    for (int i = 0; i < MEASURES * VARIABLES; i++) {
        char again[128];
        *m = &measures[i / VARIABLES];
        r->which = i % VARIABLES;
        const size_t length = strlen((*m)->name) + strlen(variable_names[r->which]);
        const int count = strlen(name) > length ? sscanf(name + length, "_%9ld_%9ld", &r->numbers[0], &r->numbers[1]) : 0;
        snprintf(again, sizeof again, forms[FLINT_MAX(count, 0)], (*m)->name, variable_names[r->which], r->numbers[0], r->numbers[1]);
        if (strcmp(name, again) == 0)
            return r->which <= (*m)->last && (r->beside != NULL || !(*m)->compares);
    }
    return false;
}

static void give_measure(struct computed *c, bool run, const struct trajectory *t, const struct trajectory *beside, const char *name)
{
    struct request r = {.of = t, .beside = beside, .numbers = {-1, -1}, .to = t->count - 1};
    const struct measure *m;
    SCOPE(arb, x, unit);
    if (!run || !read_name(&r, &m, name))
        return;
    const bool part_of_start = m->of == exit_of || m->of == settled;
    r.high = strcmp(m->name, "high_") == 0;
    if (m->of == gap_between && r.numbers[0] >= 0)
        r.to = (r.numbers[0] * HOUR - t->first) / t->step;
    else if (r.numbers[0] >= 0 && !part_of_start)
        r.from = (r.numbers[0] * HOUR - t->first) / t->step;
    if (strcmp(m->name, "at_") == 0)
        r.to = r.from;
    if (r.numbers[1] >= 0)
        r.to = (r.numbers[1] * HOUR - t->first) / t->step;
    const bool proved = r.from >= 0 && r.from <= r.to && r.to < t->count && m->of(x, &r);
    trajectory_unit(unit, t, r.which);
    if (m->in_units)
        arb_mul(x, x, unit, t->prec);
    give(c, proved, x, "%s", name);
}

void run_simulation(struct computed *c)
{
    const struct sampled *s = c->of.of;
    struct simulation one = s->simulation, other = s->beside != NULL ? *s->beside : one;
    struct trajectory t, beside;
    one.steps = other.steps = c->steps;
    bool run = trajectory_run(&t, &one, s->first, s->step, s->last);
    if (s->beside != NULL)
        run = trajectory_run(&beside, &other, s->first, s->step, s->last) && run;
    for (int i = 0; asked_name(c, i) != NULL; i++)
        give_measure(c, run, &t, s->beside != NULL ? &beside : NULL, asked_name(c, i));
    if (s->beside != NULL)
        trajectory_clear(&beside);
    trajectory_clear(&t);
}

/* ---- the methods of order 1 to 4, in the linear model ---- */

/*
 * A step of a method of order p <= 4 with p stages multiplies the state of a linear system by the terms of exp(h A) up
 * to h^p, here by Horner's rule: Euler's with p = 1, the midpoint rule and Heun's with p = 2.
 */
static void method_step(arb_ptr state, const arb_t h, int order, const struct trajectory *t)
{
    VECTOR(arb, sum, FLOW_STATE);
    VECTOR(arb, rate, FLOW_STATE);
    SCOPE(arb, part_of_h);
    _arb_vec_set(sum, state, FLOW_STATE);
    for (int k = order; k > 0; k--) {
        linear_rates(rate, sum, t->c1, t->c2, t->prec);
        arb_div_ui(part_of_h, h, (ulong)k, t->prec);
        _arb_vec_set(sum, state, FLOW_STATE);
        _arb_vec_scalar_addmul(sum, rate, FLOW_STATE, part_of_h, t->prec);
    }
    _arb_vec_set(state, sum, FLOW_STATE);
}

/* The largest errors that steps of 100 s make on the samples of 3 days, in pitch and in psi and dL/L_ref. */
static void method_errors(struct computed *c)
{
    enum { STEP = 100, SAMPLES = 12 * STEP };
    const struct simulation s = {.steps = c->steps, .digits = 2 * TRAJECTORY_DIGITS};
    struct trajectory t;
    SCOPE(arb, h, off);
    const bool run = trajectory_run(&t, &s, 0, SAMPLES, 3 * DAY);
    t.prec = rk4_precision(TRAJECTORY_DIGITS, 20); /* 3 days are 19 radians, in which balls widen step by step */
    arb_mul_ui(h, t.Omega, STEP, t.prec);
    for (int order = 1; order <= 4; order++) {
        VECTOR(arb, state, FLOW_STATE);
        VECTOR(arb, error, 2);
        _arb_vec_set(state, trajectory_sample(&t, 0), FLOW_STATE);
        for (slong k = 1; k < t.count; k++) {
            for (int i = 0; i < SAMPLES / STEP; i++)
                method_step(state, h, order, &t);
            for (int i = PSI; i <= ETA; i++) {
                arb_sub(off, state + i, trajectory_sample(&t, k) + i, t.prec);
                arb_abs(off, off);
                arb_max(error + (i != THETA), error + (i != THETA), off, t.prec);
            }
        }
        give(c, run, error, "pitch_%d", order);
        give(c, run, error + 1, "rest_%d", order);
    }
    trajectory_clear(&t);
}

/* ---- the trajectories ---- */

enum { DIGITS = 12 }; /* of nonlinear samples: too few would leave digits of the evidence unproved, and the verdict undecided */

#define LINEAR .digits = DIGITS
#define PITCHED .nonlinear = true, .digits = DIGITS
#define PLANAR .nonlinear = true, .digits = DIGITS, .theta = "0"

static const struct simulation linear = {LINEAR}, linear_planar = {LINEAR, .theta = "0"}, linear_steps = {LINEAR, .rk4 = 100},
                               nonlinear_steps = {.nonlinear = true, .rk4 = 100};

#define SAMPLED(...) &(const struct sampled){__VA_ARGS__}

/* From rest on the radius: where it is, and what energy is left. */
#define RELEASED(step, last, ...) \
    SAMPLED({.nonlinear = true, .digits = 8, .psi = "0", .theta = "0", __VA_ARGS__}, 0, step, last, NULL)

const struct computation computations_simulation[] = {
    {"linear_steps", run_simulation, SAMPLED({LINEAR}, 0, 100, 3 * DAY, &linear_steps)},
    {"nonlinear_steps", run_simulation, SAMPLED({.nonlinear = true}, 0, 100, 3 * DAY, &nonlinear_steps)},
    {"method_errors", method_errors, NULL},

    {"linear_10", run_simulation, SAMPLED({LINEAR}, 0, 240, 4 * DAY, NULL)},
    {"linear_12", run_simulation, SAMPLED({LINEAR, .n = "12"}, 0, 240, 4 * DAY, NULL)},
    {"linear_places", run_simulation, SAMPLED({LINEAR}, 0, 600, 3 * DAY, NULL)},

    {"pitched_beside", run_simulation, SAMPLED({PITCHED}, 0, 200, 3 * DAY, &linear)},
    {"planar_beside", run_simulation, SAMPLED({PLANAR}, 0, 200, 3 * DAY, &linear_planar)},
    {"pitch", run_simulation, SAMPLED({PITCHED}, 0, 300, 3 * DAY, &linear)},

    {"pitched", run_simulation, SAMPLED({PITCHED}, 0, 50, 3 * DAY, NULL)},
    {"planar", run_simulation, SAMPLED({PLANAR}, 0, 50, 3 * DAY, NULL)},
    {"pitched_at_12", run_simulation, SAMPLED({PITCHED, .n = "12"}, 0, 50, 3 * DAY, NULL)},
    {"unequal", run_simulation, SAMPLED({PITCHED, .m1 = "10", .m2 = "1000"}, 2 * DAY, 50, 3 * DAY, NULL)},

    {"pitched_10", run_simulation, SAMPLED({PITCHED}, 0, 60, 8 * DAY, NULL)},
    {"pitched_12", run_simulation, SAMPLED({PITCHED, .n = "12"}, 0, 60, 8 * DAY, NULL)},
    {"planar_10", run_simulation, SAMPLED({PLANAR}, 0, 240, 4 * DAY, NULL)},
    {"linear_days", run_simulation, SAMPLED({LINEAR}, 69 * HOUR, 600, 8 * DAY, NULL)},
    {"pitched_day8", run_simulation, SAMPLED({PITCHED}, 189 * HOUR, 10, 8 * DAY, NULL)},
    {"planar_day8", run_simulation, SAMPLED({PLANAR}, 189 * HOUR, 50, 8 * DAY, NULL)},

    {"planar_energy", run_simulation, SAMPLED({.nonlinear = true, .theta = "0"}, 4 * DAY, 4 * DAY, 8 * DAY, NULL)}, /* on day 8 the energy is down to 1e-22 */
    {"linear_energy", run_simulation, SAMPLED({LINEAR, .theta = "0"}, 4 * DAY, 4 * DAY, 8 * DAY, NULL)},
    {"pitched_energy", run_simulation, SAMPLED({.nonlinear = true}, 5 * DAY, 8 * DAY, 13 * DAY, NULL)},

    {"longer", run_simulation, RELEASED(12 * HOUR, DAY, .dL = "0.1", .C1 = "0", .C2 = "0")},
    {"shorter", run_simulation, RELEASED(12 * HOUR, DAY, .dL = "-0.1", .C1 = "0", .C2 = "0")},
    {"returning_10", run_simulation, RELEASED(3 * DAY, 3 * DAY, .dL = "-2.4")},
    {"escaping_10", run_simulation, RELEASED(3 * DAY, 3 * DAY, .dL = "-2.5")},
    {"half_10", run_simulation, RELEASED(3 * DAY, 3 * DAY, .dL = "-5")},
    {"returning_12", run_simulation, RELEASED(3 * DAY, 3 * DAY, .dL = "-8", .n = "12")},
    {"escaping_12", run_simulation, RELEASED(3 * DAY, 3 * DAY, .dL = "-8.5", .n = "12")},
    {"half_12", run_simulation, RELEASED(3 * DAY, 3 * DAY, .dL = "-5", .n = "12")},
    {NULL, NULL, NULL},
};
