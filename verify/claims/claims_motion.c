/*
 * The paper's simulation and its linear model: the integrator, how the motion settles, its oscillation, its damping.
 * Samples come from certified flows; what happens between and after them is bounded in track.h.
 */
#include "claims/convergence.h"
#include "claims/give.h"
#include "claims/track.h"
#include "evaluate/operation.h"
#include "text/scope.h"

enum { DAY = 86400, HORIZON = 3 * DAY, STEP = 100 }; /* s: the figures' three days, the simulation's step */

static const char *const models[] = {"linear", "nonlinear"};

/* ---- the integrator ---- */

/* The largest differences on the samples of two scenes, psi theta eta. */
static bool largest_gaps(arb_ptr gap, const struct computed *c, const struct scene *a, const struct scene *b, long step, long last)
{
    struct track one, other;
    bool run = track_run(&one, sheet_of(c), a, 0, step, last);
    run = track_run(&other, sheet_of(c), b, 0, step, last) && run;
    for (int i = PSI; i <= ETA; i++)
        track_gap(gap + i, &one, &other, i, 0, one.count - 1);
    track_clear(&one);
    track_clear(&other);
    return run;
}

/* Of the simulation's steps in three days; `worst` as a fraction of the initial values, each 0.01. */
static void step_errors(struct computed *c)
{
    bool proved = true;
    VECTOR(arb, gap, 3);
    SCOPE(arb, worst);
    for (int m = 0; m < 2; m++) {
        proved = largest_gaps(gap, c, &(struct scene){.nonlinear = m}, &(struct scene){.nonlinear = m, .rk4 = STEP}, STEP, HORIZON) && proved;
        for (int i = PSI; i <= ETA; i++) {
            arb_max(worst, worst, gap + i, 128);
            give(c, proved, gap + i, "%s_%s", models[m], variable_names[i]);
        }
    }
    arb_mul_ui(worst, worst, 100, 128);
    give(c, proved, worst, "worst");
}

/* log2 of what halving a step divides the largest error of a day by; `worst`: the most that one of them is off 4 by */
static void step_orders(struct computed *c)
{
    bool proved = true;
    VECTOR(arb, gap, 3);
    VECTOR(arb, before, 3);
    SCOPE(arb, order, worst);
    for (int m = 0; m < 2; m++)
        for (long step = 400; step >= 50; step /= 2) {
            proved = largest_gaps(gap, c, &(struct scene){.nonlinear = m}, &(struct scene){.nonlinear = m, .rk4 = step}, 400, DAY) && proved;
            for (int i = PSI; i <= ETA && step < 400; i++) {
                observed_order(order, before + i, gap + i, 2);
                give(c, proved, order, "%s_%ld_%s", models[m], step, variable_names[i]);
                raise_to_difference(worst, order, 4);
            }
            _arb_vec_set(before, gap, 3);
        }
    give(c, proved, worst, "worst");
}

/* The matrix of (40), n = 10, in units of Omega and L_ref, over psi theta eta and their rates. */
static void linear_model(arb_mat_t a, const struct computed *c, slong prec)
{
    static const int input[FLOW_STATE] = {4, 5, 6, 8, -1, 7}, row[3] = {4, 3, 5}; /* of (40): it has no theta_dot */
    VECTOR(arb, in, 9);
    VECTOR(arb, out, 3);
    arb_one(in);
    arb_one(in + 1);
    arb_set_ui(in + 2, 10);
    arb_set_ui(in + 3, 2);
    for (int j = 0; j < FLOW_STATE; j++) {
        for (int i = 4; i < 9; i++)
            arb_set_ui(in + i, i == input[j]);
        section_enclose(section_find(sheet_of(c), "eq40"), in, prec, out);
        for (int i = 0; i < 3; i++)
            arb_set(arb_mat_entry(a, row[i], j), out + i);
        if (j >= 3)
            arb_one(arb_mat_entry(a, j - 3, j));
    }
}

/*
 * A step of a method of order p <= 4 with p stages multiplies the state of a linear system by the terms of exp(h A) up
 * to h^p: Euler's with p = 1, the midpoint rule and Heun's with p = 2.
 */
static void step_matrix(arb_mat_t step, const struct computed *c, const arb_t h, slong order, slong prec)
{
    arb_mat_t a, power;
    arb_mat_init(a, FLOW_STATE, FLOW_STATE);
    arb_mat_init(power, FLOW_STATE, FLOW_STATE);
    linear_model(a, c, prec);
    arb_mat_scalar_mul_arb(a, a, h, prec);
    arb_mat_one(power);
    arb_mat_one(step);
    for (slong k = 1; k <= order; k++) {
        arb_mat_mul(power, power, a, prec);
        arb_mat_scalar_div_si(power, power, k, prec);
        arb_mat_add(step, step, power, prec);
    }
    arb_mat_clear(power);
    arb_mat_clear(a);
}

/* The largest error in pitch, and in psi and eta, that steps of that order make on the samples. */
static void order_error(arb_ptr error, const struct computed *c, const struct track *t, slong order)
{
    const slong prec = rk4_precision(TRACK_DIGITS, 20); /* 3 days are 19 radians */
    arb_mat_t step, state;
    SCOPE(arb, gap);
    arb_mat_init(step, FLOW_STATE, FLOW_STATE);
    arb_mat_init(state, FLOW_STATE, 1);
    arb_mul_ui(gap, t->Omega, STEP, prec);
    step_matrix(step, c, gap, order, prec);
    for (int i = 0; i < FLOW_STATE; i++)
        arb_set(arb_mat_entry(state, i, 0), track_row(t, 0) + i);
    _arb_vec_zero(error, 2);
    for (slong k = 1; k < t->count; k++) {
        for (long i = 0; i < t->step / STEP; i++)
            arb_mat_mul(state, step, state, prec);
        for (int i = PSI; i <= ETA; i++) {
            arb_sub(gap, arb_mat_entry(state, i, 0), track_row(t, k) + i, prec);
            arb_abs(gap, gap);
            arb_max(error + (i != THETA), error + (i != THETA), gap, prec);
        }
    }
    for (int i = 0; i < 2; i++)
        arb_mul_ui(error + i, error + i, 100, prec); /* each starts at 0.01 */
    arb_mat_clear(state);
    arb_mat_clear(step);
}

/* Of methods of order 1 to 4, in the linear model, as fractions of the initial values. */
static void method_errors(struct computed *c)
{
    VECTOR(arb, error, 2);
    struct track t;
    const bool run = track_run(&t, sheet_of(c), &(struct scene){.nonlinear = false}, 0, 12 * STEP, HORIZON);
    for (slong order = 1; order <= 4; order++) {
        order_error(error, c, &t, order);
        give(c, run, error, "pitch_%ld", (long)order);
        give(c, run, error + 1, "rest_%ld", (long)order);
    }
    track_clear(&t);
}

/* ---- the linear model, for the paper's n and for the n that matches the frequencies ---- */

static const char *const gains[] = {"10", "12"};

/* |psi|/psi_0 or |dL|/dL_0 from a sample on, for ever: the last one's energy allows no more than the samples. */
static bool fraction_after(arb_t fraction, const struct track *t, int which, slong from)
{
    struct bounds tail;
    bounds_init(&tail);
    bool bounded = track_sup(fraction, t, which, from, t->count - 1) && track_bounds(&tail, t, t->count - 1)
                   && arb_lt(tail.of[which], fraction);
    arb_div(fraction, fraction, track_row(t, 0) + which, t->prec);
    bounds_clear(&tail);
    return bounded;
}

/* What psi and dL keep to after 2 days, as fractions of the start, and when they are below 1/100 of it, for good. */
static void linear_settling(struct computed *c)
{
    enum { SAMPLES = 600 };
    SCOPE(arb, x, limit);
    for (int i = 0; i < 2; i++) {
        struct track t;
        const bool run = track_run(&t, sheet_of(c), &(struct scene){.n = gains[i]}, 0, SAMPLES, 5 * DAY);
        for (int which = PSI; which <= ETA; which += ETA) {
            bool proved = fraction_after(x, &t, which, 2 * DAY / SAMPLES) && run;
            give(c, proved, x, "%s_after_%s", variable_names[which], gains[i]);
            arb_div_ui(limit, track_row(&t, 0) + which, 100, t.prec);
            proved = track_settled(x, &t, which, limit) && run;
            give(c, proved, x, "%s_hours_%s", variable_names[which], gains[i]);
        }
        track_clear(&t);
    }
}

/* The sign that a quantity keeps between two samples, if both exceed what it can bend by; else 0. */
static int kept_sign(arb_srcptr now, arb_srcptr next, const arb_t room, slong prec)
{
    int sign = 0;
    SCOPE(arb, least, other);
    arb_abs(least, now);
    arb_abs(other, next);
    arb_min(least, least, other, prec);
    if (arb_gt(least, room) && arb_is_positive(now) == arb_is_positive(next))
        sign = arb_is_positive(now) ? 1 : -1;
    return sign;
}

/* Sign changes: between two samples none, or one where the rate keeps its sign; -1 where neither is certain. */
static int sign_changes(const struct track *t, int which)
{
    int changes = 0;
    struct bounds b;
    SCOPE(arb, room);
    bounds_init(&b);
    for (slong k = 0; k + 1 < t->count && changes >= 0; k++) {
        arb_srcptr now = track_row(t, k) + which, next = track_row(t, k + 1) + which;
        const bool bounded = track_bounds(&b, t, k);
        track_room(room, t, &b, which);
        if (bounded && kept_sign(now, next, room, t->prec) != 0)
            continue;
        track_room(room, t, &b, which + PSI_DOT);
        const bool certain = bounded && kept_sign(now + PSI_DOT, next + PSI_DOT, room, t->prec) != 0
                             && !arb_contains_zero(now) && !arb_contains_zero(next);
        changes = certain ? changes + (arb_is_positive(now) != arb_is_positive(next)) : -1;
    }
    bounds_clear(&b);
    return changes;
}

/* Turning points that the samples' rates prove at least. */
static int turning_points(const struct track *t, int which)
{
    int turns = 0, sign = 0;
    for (slong k = 0; k < t->count; k++) {
        arb_srcptr rate = track_row(t, k) + which + PSI_DOT;
        int now = arb_is_positive(rate) - arb_is_negative(rate);
        turns += now * sign < 0;
        sign = now != 0 ? now : sign;
    }
    return turns;
}

/* Of dL in three days: sign changes, turning points at least, the least value [m] on samples. */
static void length_oscillation(struct computed *c)
{
    SCOPE(arb, x);
    for (int i = 0; i < 2; i++) {
        struct track t;
        const bool run = track_run(&t, sheet_of(c), &(struct scene){.n = gains[i]}, 0, 5 * STEP, HORIZON);
        const int changes = sign_changes(&t, ETA);
        arb_set_si(x, changes);
        give(c, run && changes >= 0, x, "changes_%s", gains[i]);
        arb_set_si(x, turning_points(&t, ETA));
        give(c, run, x, "turns_%s", gains[i]);
        arb_zero(x);
        for (slong k = 0; k < t.count; k++)
            arb_min(x, x, track_row(&t, k) + ETA, t.prec);
        arb_mul(x, x, t.L_ref, t.prec);
        give(c, run, x, "least_%s", gains[i]);
        track_clear(&t);
    }
}

/* psi'^2/2 + 3/2 psi^2 at a sample */
static void yaw_energy(arb_t energy, const struct track *t, slong k)
{
    arb_srcptr row = track_row(t, k);
    arb_sqr(energy, row + PSI, t->prec);
    arb_mul_ui(energy, energy, 3, t->prec);
    arb_addmul(energy, row + PSI_DOT, row + PSI_DOT, t->prec);
    arb_mul_2exp_si(energy, energy, -1);
}

/* The part of it that is gone after 2 days. */
static void yaw_energy_loss(struct computed *c)
{
    struct track t;
    SCOPE(arb, before, after);
    const bool run = track_run(&t, sheet_of(c), &(struct scene){.nonlinear = false}, 0, 2 * DAY, 2 * DAY);
    yaw_energy(before, &t, 0);
    yaw_energy(after, &t, 1);
    arb_sub(after, before, after, t.prec);
    arb_div(after, after, before, t.prec);
    give(c, run, after, "loss");
    track_clear(&t);
}

/* What small angles leave out of (10) on a sample, in m: raises the worst so far. */
static void small_angle_error(arb_ptr worst, const struct computed *c, const struct track *t, slong k)
{
    VECTOR(arb, in, 5);
    VECTOR(arb, exact, 3);
    arb_one(in); /* equal masses, as in the paper: x1 = L/2 */
    arb_one(in + 1);
    arb_add_ui(in + 2, track_row(t, k) + ETA, 1, t->prec);
    arb_mul(in + 2, in + 2, t->L_ref, t->prec);
    _arb_vec_set(in + 3, track_row(t, k), 2);
    section_enclose(section_find(sheet_of(c), "eq10"), in, t->prec, exact);
    section_enclose(section_find(sheet_of(c), "eq10lin"), in, t->prec, in);
    for (int i = 0; i < 3; i++) {
        arb_sub(exact + i, exact + i, in + i, t->prec);
        arb_abs(exact + i, exact + i);
        arb_max(worst + i, worst + i, exact + i, t->prec);
    }
}

/* Small angles in (10) against the exact rotation on samples, and x1 - 5 m, y1, z1 from 2 to 3 days [m]. */
static void figure_5b(struct computed *c)
{
    enum { SAMPLES = 600 };
    struct track t;
    VECTOR(arb, x, 3);
    const bool run = track_run(&t, sheet_of(c), &(struct scene){.nonlinear = false}, 0, SAMPLES, HORIZON);
    for (slong k = 0; k < t.count; k++)
        small_angle_error(x, c, &t, k);
    for (int i = 0; i < 3; i++)
        give(c, run, x + i, "error_%s", variable_names[PLACE_X + i]);
    for (int i = 0; i < 2; i++) { /* x1 = arm (1 + eta) */
        const bool bounded = track_sup(x, &t, i ? PLACE_Y : ETA, 2 * DAY / SAMPLES, t.count - 1);
        arb_mul(x, x, t.arm, t.prec);
        give(c, bounded && run, x, "late_%s", variable_names[PLACE_X + i]);
    }
    track_peak(x, &t, PLACE_Z, 2 * DAY / SAMPLES, t.count - 1);
    arb_mul(x, x, t.arm, t.prec);
    give(c, run, x, "late_z1");
    track_clear(&t);
}

const struct computation computations_motion[] = {
    {"step_errors", step_errors, "worst" ANGLES_AND_LENGTH("linear_", "") ANGLES_AND_LENGTH("nonlinear_", ""), ""},
    {"step_orders", step_orders,
     "worst" ANGLES_AND_LENGTH("linear_200_", "") ANGLES_AND_LENGTH("linear_100_", "") ANGLES_AND_LENGTH("linear_50_", "")
         ANGLES_AND_LENGTH("nonlinear_200_", "") ANGLES_AND_LENGTH("nonlinear_100_", "") ANGLES_AND_LENGTH("nonlinear_50_", ""), ""},
    {"method_errors", method_errors, "pitch_1 pitch_2 pitch_3 pitch_4 rest_1 rest_2 rest_3 rest_4", ""},
    {"linear_settling", linear_settling,
     "psi_after_10 dL_after_10 psi_hours_10 dL_hours_10 psi_after_12 dL_after_12 psi_hours_12 dL_hours_12", ""},
    {"length_oscillation", length_oscillation, "changes_10 turns_10 least_10 changes_12 turns_12 least_12", ""},
    {"yaw_energy_loss", yaw_energy_loss, "loss", ""},
    {"figure_5b", figure_5b, "late_x1 late_y1 late_z1" PLACE_OF_1("error_"), ""},
    {NULL, NULL, NULL, NULL},
};
