/*
 * The paper's simulation, its linear model and their variations: a table of trajectories, and what is measured of each.
 * Samples come from certified flows; what happens between and after them is bounded in trajectory.h.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "claims/claim.h"
#include "claims/curve.h"
#include "claims/trajectory.h"
#include "sheet/input.h"
#include "text/scope.h"

enum { MEASURE_BITS = 128 };

/* What a name asks for. */
struct request {
    const struct measure *measure;
    const struct trajectory *of, *beside; /* beside NULL: none */
    int which;
    long numbers[2];                      /* the hours, or the part of an exit; -1: none */
    slong from, to;                       /* samples */
};

/* Of variables up to the last that it can be of, in their units or not; beside another motion; asked for a part of the start. */
struct measure {
    const char *name;
    bool (*of)(arb_t x, const struct request *r); /* false where nothing is proved */
    int last;
    bool in_units, compares, of_part;
    bool for_ever;                                      /* what it finds, or that part, is not exceeded after the last sample */
    void (*pick)(arb_t, const arb_t, const arb_t, slong); /* of two values */
};

/* What the energy at a sample allows from then on, for ever; no number where that is nothing. */
static void reach_from(arb_t x, const struct trajectory *t, int which, slong k)
{
    VECTOR(arb, b, BOUNDS);
    if (trajectory_bounds(b, t, k))
        arb_set(x, b + BOUND_OF(which, 0));
    else
        arb_indeterminate(x);
}

/* Whether the last sample's energy allows no more than a limit, where that is asked. */
static bool stays_below(const arb_t limit, const struct request *r)
{
    SCOPE(arb, after);
    if (!r->measure->for_ever)
        return true;
    reach_from(after, r->of, r->which, r->of->count - 1);
    return arb_lt(after, limit);
}

/* The largest size or, beside another motion, difference, on samples, ... */
static bool peak(arb_t x, const struct request *r)
{
    trajectory_peak(x, r->of, r->beside, r->which, r->from, r->to);
    return true;
}

/* ... and between them too. */
static bool supremum(arb_t x, const struct request *r)
{
    return trajectory_supremum(x, r->of, r->beside, r->which, r->from, r->to) && stays_below(x, r);
}

static bool bound(arb_t x, const struct request *r)
{
    reach_from(x, r->of, r->which, r->from);
    return true;
}

/* The one that is picked of all values on samples. */
static bool picked(arb_t x, const struct request *r)
{
    SCOPE(arb, value);
    for (slong k = r->from; k <= r->to; k++) {
        trajectory_value(value, r->of, k, r->which);
        r->measure->pick(x, k == r->from ? value : x, value, MEASURE_BITS);
    }
    return true;
}

static bool value_of_sample(arb_t x, const struct request *r)
{
    trajectory_value(x, r->of, r->from, r->which);
    return true;
}

static bool energy(arb_t x, const struct request *r)
{
    trajectory_energy(x, r->of, r->from);
    return true;
}

/* In hours, when it is below a part of its start until the last sample. */
static bool exit_of(arb_t hours, const struct request *r)
{
    SCOPE(arb, limit);
    arb_div_si(limit, trajectory_sample(r->of, 0) + r->which, r->numbers[0], MEASURE_BITS);
    return trajectory_exit(hours, r->of, r->which, limit) && stays_below(limit, r);
}

/* The largest difference on samples as a part of what the linear motion beside may still reach. */
static bool part(arb_t x, const struct request *r)
{
    SCOPE(arb, left, y);
    for (slong k = r->from; k <= r->to; k++) {
        reach_from(left, r->beside, r->which, k);
        trajectory_peak(y, r->of, r->beside, r->which, k, k);
        arb_div(y, y, left, MEASURE_BITS);
        arb_max(x, x, y, MEASURE_BITS);
    }
    return true;
}

/* The changes of sign that samples prove at least; of a rate, the turning points. */
static bool sign_changes(arb_t x, const struct request *r)
{
    int changes = 0, sign = 0;
    for (slong k = r->from; k <= r->to; k++) {
        const int now = sign_of_ball(trajectory_sample(r->of, k) + r->which);
        changes += now * sign < 0;
        sign = now != 0 ? now : sign;
    }
    arb_set_si(x, changes);
    return true;
}

static const struct measure measures[] = {
    {"sup_", supremum, PRODUCT, .in_units = true},
    {"ever_", supremum, PLACE_Z, .in_units = true, .for_ever = true},
    {"bound_", bound, PLACE_Z, .in_units = true},
    {"peak_", peak, PHASE, .in_units = true},
    {"low_", picked, PHASE, .in_units = true, .pick = arb_min},
    {"high_", picked, PHASE, .in_units = true, .pick = arb_max},
    {"at_", value_of_sample, PHASE, .in_units = true},
    {"energy_of_", energy, PSI, .in_units = false},
    {"exit_", exit_of, PLACE_Z, .of_part = true},
    {"settled_", exit_of, PLACE_Z, .of_part = true, .for_ever = true},
    {"gap_", peak, PHASE, .in_units = true, .compares = true},
    {"between_", supremum, PRODUCT, .in_units = true, .compares = true},
    {"part_", part, PLACE_Z, .compares = true},
    {"changes_", sign_changes, PLACE_Z, .in_units = false},
    {.name = NULL},
};

/* What a name asks for, the numbers in it as written; false: nothing that there is. */
static bool read_name(struct request *r, const char *name)
{
    static const char *const forms[] = {"%s%s", "%s%s_%ld", "%s%s_%ld_%ld"};
    char again[128];
    for (const struct measure *m = measures; m->name != NULL; m++)
        for (r->which = PSI; r->which <= m->last; r->which++) {
            const char *const variable = variable_names[r->which];
            const size_t first = strlen(m->name), length = first + strlen(variable);
            if (strncmp(name, m->name, first) != 0 || strncmp(name + first, variable, length - first) != 0)
                continue;
            const int count = sscanf(name + length, "_%9ld_%9ld", &r->numbers[0], &r->numbers[1]);
            snprintf(again, sizeof again, forms[FLINT_MAX(count, 0)], m->name, variable, r->numbers[0], r->numbers[1]);
            r->measure = m;
            if (strcmp(name, again) == 0)
                return r->beside != NULL || !m->compares;
        }
    return false;
}

static void give_measure(struct computed *c, const struct trajectory *t, const struct trajectory *beside, const char *name)
{
    struct request r = {.of = t, .beside = beside, .numbers = {-1, -1}, .to = t->count - 1};
    SCOPE(arb, x);
    if (!read_name(&r, name))
        return;
    const struct measure *m = r.measure;
    if (!m->compares)
        r.beside = NULL;
    if (r.numbers[0] >= 0 && !m->of_part)
        r.from = (r.numbers[0] * HOUR - t->first) / t->step;
    if (r.numbers[1] >= 0)
        r.to = (r.numbers[1] * HOUR - t->first) / t->step;
    const bool proved = r.from >= 0 && r.from <= r.to && r.to < t->count && m->of(x, &r);
    if (m->in_units)
        arb_mul(x, x, t->unit + r.which, t->prec);
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
    for (int i = 0; run && i < c->count; i++)
        give_measure(c, &t, s->beside != NULL ? &beside : NULL, c->numbers[i].name);
    if (s->beside != NULL)
        trajectory_clear(&beside);
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

    {"linear_10", run_simulation, SAMPLED({LINEAR}, 0, 240, 4 * DAY, NULL)},
    {"linear_12", run_simulation, SAMPLED({LINEAR, .n = "12"}, 0, 240, 4 * DAY, NULL)},
    {"linear_places", run_simulation, SAMPLED({LINEAR}, 0, 600, 3 * DAY, NULL)},

    {"pitched_beside", run_simulation, SAMPLED({PITCHED}, 0, 200, 3 * DAY, &linear)},
    {"planar_beside", run_simulation, SAMPLED({PLANAR}, 0, 200, 3 * DAY, &linear_planar)},

    {"unequal", run_simulation, SAMPLED({PITCHED, .m1 = "10", .m2 = "1000"}, 2 * DAY, 50, 3 * DAY, NULL)},

    {"pitched_10", run_simulation, SAMPLED({PITCHED}, 0, 60, 8 * DAY, NULL)},
    {"pitched_12", run_simulation, SAMPLED({PITCHED, .n = "12"}, 0, 60, 8 * DAY, NULL)},
    {"planar_10", run_simulation, SAMPLED({PLANAR}, 0, 60, 4 * DAY, NULL)},
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
