/*
 * The paper's simulation and its linear model: the integrator, how the motion settles, its wiggle, its damping.
 * Rows come from certified flows; what happens between and after them is bounded in track.h.
 */
#include "algebra.h"
#include "operation.h"
#include "track.h"

enum { DAY = 86400, HORIZON = 3 * DAY, STEP = 100 }; /* s: the figures' three days, the simulation's step */

/* ---- the integrator ---- */

/* The largest differences on the rows of two scenes, psi theta eta. */
static bool largest_gaps(arb_ptr gap, const struct scene *a, const struct scene *b, long step, long last)
{
    struct track one, other;
    bool run = track_run(&one, a, 0, step, last);
    run = track_run(&other, b, 0, step, last) && run;
    for (int i = PSI; i <= ETA; i++)
        track_gap(gap + i, &one, &other, i, 0, one.count - 1);
    track_clear(&one);
    track_clear(&other);
    return run;
}

static void step_small_enough(struct evidence *e)
{
    bool proved = true;
    arb_ptr gap = _arb_vec_init(3), worst = _arb_vec_init(2);
    evidence_add(e, "largest errors of psi, theta, dL/L_ref in the 2592 steps of 3 days, against the exact motion: ");
    for (int nonlinear = 0; nonlinear < 2; nonlinear++) {
        const struct scene exact = {.nonlinear = nonlinear}, stepped = {.nonlinear = nonlinear, .rk4 = STEP};
        proved = largest_gaps(gap, &exact, &stepped, STEP, HORIZON) && proved;
        evidence_add(e, "%s model", nonlinear ? "; nonlinear" : "linear");
        for (int i = PSI; i <= ETA; i++) { /* each starts at 0.01 */
            arb_mul_ui(worst + 1, gap + i, 100, 128);
            arb_max(worst, worst, worst + 1, 128);
            evidence_bound(e, i ? ", " : " ", gap + i, "");
        }
    }
    evidence_bound(e, ": at most ", worst, " of the initial values; a plotted line is some 1e-3 of the picture wide");
    evidence_decide(e, HOLDS, CERTIFIED, proved && is_below(worst, 1e-6));
    _arb_vec_clear(worst, 2);
    _arb_vec_clear(gap, 3);
}

static void step_order(struct evidence *e)
{
    static const long steps[] = {400, 200, 100, 50};
    bool proved = true;
    arb_ptr gap = _arb_vec_init(3), before = _arb_vec_init(3);
    evidence_add(e, "steps of 400, 200, 100, 50 s: each halving divides the largest errors of a day, in psi, theta, "
                    "dL, by 2^p, p =");
    for (int nonlinear = 0; nonlinear < 2; nonlinear++) {
        for (int k = 0; k < 4; k++) {
            const struct scene exact = {.nonlinear = nonlinear}, stepped = {.nonlinear = nonlinear, .rk4 = steps[k]};
            proved = largest_gaps(gap, &exact, &stepped, 400, DAY) && proved;
            for (int i = PSI; i <= ETA && k > 0; i++)
                proved = evidence_order(e, i ? ", " : k > 1 ? "; " : " ", before + i, gap + i, 2, 4, 0.05) && proved;
            _arb_vec_set(before, gap, 3);
        }
        evidence_add(e, "%s", nonlinear ? " (nonlinear)" : " (linear model);");
    }
    evidence_decide(e, HOLDS, CERTIFIED, proved);
    _arb_vec_clear(before, 3);
    _arb_vec_clear(gap, 3);
}

/*
 * A step of a method of order p <= 4 with p stages multiplies the state of a linear system by the terms of exp(h A) up
 * to h^p: Euler's with p = 1, the midpoint rule and Heun's with p = 2. A is the sheet's: (40), n = 10, units of Omega.
 */
static bool step_matrix(arb_mat_t step, const arb_t h, slong order, slong prec)
{
    const slong parameters[4] = {1, 1, 10, 2}; /* Omega L_ref C1 C2 */
    fmpq_mat_t rates;
    arb_mat_t a, power;
    fmpq_mat_init(rates, FLOW_STATE, FLOW_STATE);
    arb_mat_init(a, FLOW_STATE, FLOW_STATE);
    arb_mat_init(power, FLOW_STATE, FLOW_STATE);
    const bool known = linear_model(rates, parameters);
    arb_mat_set_fmpq_mat(a, rates, prec);
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
    fmpq_mat_clear(rates);
    return known;
}

/* The largest error in pitch, and in psi and eta, that steps of that order make on the track's rows. */
static bool order_error(arb_ptr error, const struct track *t, slong order)
{
    const slong prec = rk4_precision(TRACK_DIGITS, 20); /* 3 days are 19 radians */
    arb_mat_t step, state;
    arb_t gap;
    arb_init(gap);
    arb_mat_init(step, FLOW_STATE, FLOW_STATE);
    arb_mat_init(state, FLOW_STATE, 1);
    arb_mul_ui(gap, t->Omega, STEP, prec);
    const bool known = step_matrix(step, gap, order, prec);
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
    arb_clear(gap);
    return known;
}

static void which_method(struct evidence *e)
{
    static const struct {
        const char *name;
        double least, most; /* what its error in pitch must lie between for the evidence to be true */
    } methods[] = {
        {"Euler's", 0.1, 1}, {"second order", 1e-3, 1e-2}, {"third order", 0, 1e-4}, {"fourth order", 0, 1e-6}};
    arb_ptr error = _arb_vec_init(2);
    struct track t;
    bool proved = track_run(&t, &(struct scene){.nonlinear = false}, 0, 12 * STEP, HORIZON);
    evidence_add(e, "the text names neither order nor kind. Steps of 100 s err in the linear model by, in pitch and "
                    "in the rest, as fractions of the initial values:");
    for (slong k = 0; k < 4; k++) {
        proved = order_error(error, &t, k + 1) && proved;
        evidence_add(e, "%s %s", k > 0 ? ";" : "", methods[k].name);
        evidence_bound(e, " ", error, "");
        evidence_bound(e, ", ", error + 1, "");
        proved = proved && is_below(error, methods[k].most) && is_above(error, methods[k].least);
    }
    evidence_add(e, ". All of order 3 and more draw the same picture; the classical fourth-order one stands in for it");
    e->why = "Neither order nor kind is given; from the third order on all draw the same picture.";
    evidence_decide(e, NOT_DECIDABLE, CERTIFIED, proved);
    track_clear(&t);
    _arb_vec_clear(error, 2);
}

/* ---- the linear model ---- */

static void two_revolutions(struct evidence *e)
{
    bool proved = true;
    arb_t turns, pi;
    struct track t;
    arb_init(turns);
    arb_init(pi);
    proved = track_run(&t, &(struct scene){.nonlinear = false}, 0, STEP, 0);
    arb_const_pi(pi, t.prec);
    arb_mul_ui(turns, t.Omega, DAY, t.prec);
    arb_div(turns, turns, pi, t.prec);
    proved = evidence_number(e, "2 days are Omega t/(2 pi) = ", turns, 6, " revolutions") && proved;
    arb_sub_ui(pi, turns, 2, t.prec);
    proved = proved && arb_is_positive(pi) && is_below(pi, 0.01);
    arb_mul_ui(turns, turns, 3, t.prec);
    arb_mul_2exp_si(turns, turns, -1);
    proved = evidence_number(e, ", the 3 days of the figures ", turns, 6, "") && proved;
    evidence_decide(e, HOLDS, CERTIFIED, proved);
    track_clear(&t);
    arb_clear(pi);
    arb_clear(turns);
}

/* |psi|/psi_0 or |dL|/dL_0 from a row on, for ever: the last row's energy allows no more than the rows. */
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

static void settling_linear(struct evidence *e)
{
    static const char *const gains[] = {NULL, "12"};
    bool proved = true;
    arb_t x, limit;
    arb_init(x);
    arb_init(limit);
    for (int i = 0; i < 2; i++) {
        const long step = 600; /* s */
        struct track t;
        proved = track_run(&t, &(struct scene){.n = gains[i]}, 0, step, 5 * DAY) && proved;
        evidence_add(e, "%s", i ? "; with n = 12: " : "from 2 days on, for ever, ");
        for (int which = PSI; which <= ETA; which += ETA) {
            proved = fraction_after(x, &t, which, 2 * DAY / step) && proved;
            evidence_bound(e, which ? ", |dL| <= " : "|psi| <= ", x, " of its initial value");
            proved = proved && is_below(x, 0.01);
        }
        for (int which = PSI; which <= ETA; which += ETA) {
            arb_div_ui(limit, track_row(&t, 0) + which, 100, t.prec);
            proved = track_settled(x, &t, which, limit) && proved;
            evidence_bound(e, which ? ", dL within " : "; below 1/100 is psi within ", x, " h");
        }
        track_clear(&t);
    }
    evidence_decide(e, HOLDS, CERTIFIED, proved);
    arb_clear(limit);
    arb_clear(x);
}

/* The sign that a quantity keeps between two rows, if both exceed what it can bend by; else 0. */
static int kept_sign(arb_srcptr now, arb_srcptr next, const arb_t room, slong prec)
{
    int sign = 0;
    arb_t least, other;
    arb_init(least);
    arb_init(other);
    arb_abs(least, now);
    arb_abs(other, next);
    arb_min(least, least, other, prec);
    if (arb_gt(least, room) && arb_is_positive(now) == arb_is_positive(next))
        sign = arb_is_positive(now) ? 1 : -1;
    arb_clear(other);
    arb_clear(least);
    return sign;
}

/* Sign changes: between two rows none, or one where the rate keeps its sign; -1 where neither is certain. */
static int sign_changes(const struct track *t, int which)
{
    int changes = 0;
    struct bounds b;
    arb_t room;
    arb_init(room);
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
    arb_clear(room);
    return changes;
}

/* Turning points that the rows' rates prove at least. */
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

static void length_wiggle(struct evidence *e)
{
    /* f = (1 + s t) e^(-s t), f' = -s^2 t e^(-s t), f'' = (s^3 t - s^2) e^(-s t): f'' + 2 s f' + s^2 f = 0 */
    bool proved = identity("s t", "s^3*t - s^2 - 2*s*s^2*t + s^2*(1 + s*t)", "0");
    evidence_add(e, "without the yaw rate dL = 0.1 m (1 + s Omega t) exp(-s Omega t), s = sqrt(n - 9), without zero "
                    "or turning point at t > 0; with it, in 3 days, dL");
    for (int i = 0; i < 2; i++) {
        struct track t;
        arb_t low;
        arb_init(low);
        proved = track_run(&t, &(struct scene){.n = i ? "12" : NULL}, 0, 5 * STEP, HORIZON) && proved;
        const int changes = sign_changes(&t, ETA), turns = turning_points(&t, ETA);
        for (slong k = 0; k < t.count; k++)
            arb_min(low, low, track_row(&t, k) + ETA, t.prec);
        arb_mul(low, low, t.L_ref, t.prec);
        evidence_add(e, "%s", i ? "; with n = 12" : " (n = 10)");
        evidence_add(e, " changes sign exactly %d times and turns at least %d times", changes, turns);
        proved = evidence_number(e, ", down to ", low, 3, " m") && proved;
        proved = proved && changes > 0 && turns >= changes - 1;
        arb_clear(low);
        track_clear(&t);
    }
    evidence_decide(e, HOLDS, CERTIFIED, proved);
}

/* psi'^2/2 + 3/2 psi^2 at a row */
static void yaw_energy(arb_t energy, const struct track *t, slong k)
{
    arb_srcptr row = track_row(t, k);
    arb_sqr(energy, row + PSI, t->prec);
    arb_mul_ui(energy, energy, 3, t->prec);
    arb_addmul(energy, row + PSI_DOT, row + PSI_DOT, t->prec);
    arb_mul_2exp_si(energy, energy, -1);
}

static void yaw_energy_loss(struct evidence *e)
{
    struct track t;
    arb_t before, after;
    arb_init(before);
    arb_init(after);
    bool proved = track_run(&t, &(struct scene){.nonlinear = false}, 0, 2 * DAY, 2 * DAY);
    proved = section_identity("eq40", "psi_dot*(psi_ddot + 3*Omega^2*psi)", "-2*Omega/L_ref*dL_dot*psi_dot") && proved;
    yaw_energy(before, &t, 0);
    yaw_energy(after, &t, 1);
    arb_sub(after, before, after, t.prec);
    arb_div(after, after, before, t.prec);
    evidence_add(e, "by (40b) the coupling's work alone changes the energy of yaw, (psi'^2 + 3 psi^2)/2 in radians of "
                    "orbit: it is the integral of -2 psi' dL'/L_ref");
    proved = evidence_number(e, ", and takes ", after, 7, " of what yaw starts with in 2 days") && proved;
    evidence_add(e, "; the length gains it, for its coupling does the opposite work, and C2 alone takes it away; in "
                    "phase with psi the rate dL' would do no work over a swing: claim phase-damps has the phases");
    evidence_decide(e, HOLDS, CERTIFIED, proved && arb_is_positive(after));
    arb_clear(after);
    arb_clear(before);
    track_clear(&t);
}

/* What small angles leave out of (10) on a row, in m: raises the worst so far. */
static void small_angle_error(arb_ptr worst, const struct track *t, slong k)
{
    arb_ptr in = _arb_vec_init(5), exact = _arb_vec_init(3);
    arb_one(in); /* equal masses, as in the paper: x1 = L/2 */
    arb_one(in + 1);
    arb_add_ui(in + 2, track_row(t, k) + ETA, 1, t->prec);
    arb_mul(in + 2, in + 2, t->L_ref, t->prec);
    _arb_vec_set(in + 3, track_row(t, k), 2);
    section_enclose(section_find(sheet(), "eq10"), in, t->prec, exact);
    section_enclose(section_find(sheet(), "eq10lin"), in, t->prec, in);
    for (int i = 0; i < 3; i++) {
        arb_sub(exact + i, exact + i, in + i, t->prec);
        arb_abs(exact + i, exact + i);
        arb_max(worst + i, worst + i, exact + i, t->prec);
    }
    _arb_vec_clear(exact, 3);
    _arb_vec_clear(in, 5);
}

static void figure_5b(struct evidence *e)
{
    enum { ROWS = 600 };
    struct track t;
    arb_ptr x = _arb_vec_init(3);
    bool proved = track_run(&t, &(struct scene){.nonlinear = false}, 0, ROWS, HORIZON);
    for (slong k = 0; k < t.count; k++)
        small_angle_error(x, &t, k);
    evidence_add(e, "small angles in (10), against the exact rotation of the same angles, on rows of 600 s: x1, y1, "
                    "z1 off by at most");
    for (int i = 0; i < 3; i++) {
        evidence_bound(e, i ? ", " : " ", x + i, "");
        proved = proved && is_below(x + i, 1e-3);
    }
    evidence_add(e, " m, of the 0.05 m that they start with; between 2 and 3 days");
    for (int i = 0; i < 2; i++) { /* x1 = arm (1 + eta) */
        proved = track_sup(x, &t, i ? PLACE_Y : ETA, 2 * DAY / ROWS, t.count - 1) && proved;
        arb_mul(x, x, t.arm, t.prec);
        evidence_bound(e, i ? ", |y1| <= " : " |x1 - 5 m| <= ", x, " m");
        proved = proved && is_below(x, 1e-3);
    }
    track_peak(x, &t, PLACE_Z, 2 * DAY / ROWS, t.count - 1);
    arb_mul(x, x, t.arm, t.prec);
    proved = evidence_number(e, ", while z1 swings on with pitch, up to ", x, 3, " m") && proved;
    evidence_decide(e, HOLDS, CERTIFIED, proved);
    _arb_vec_clear(x, 3);
    track_clear(&t);
}

#define SIMULATION "section Numerical simulation"

const struct claim claims_motion[] = {
    {"step-small-enough", SIMULATION, "a Runge-Kutta step of 100 s is small enough", step_small_enough},
    {"step-order", SIMULATION, "what the simulation errs by falls as the fourth power of its step", step_order},
    {"runge-kutta-kind", SIMULATION, "which Runge-Kutta method the simulation used", which_method},
    {"two-revolutions", SIMULATION, "two days are two revolutions of the geostationary orbit", two_revolutions},
    {"settling-linear", "Figure 5(a)", "linear model: yaw and length error converge to zero, in about two days",
     settling_linear},
    {"length-wiggle", "Figure 5(a)", "the wiggle of the otherwise critically damped length comes from the yaw rate",
     length_wiggle},
    {"yaw-energy", "Figure 5(a)", "what damps yaw is the rate of the length that drives it", yaw_energy_loss},
    {"figure-5b", "Figure 5(b)", "x1, y1, z1 of the linear model, through Eq. (10) for small angles", figure_5b},
    {NULL, NULL, NULL, NULL},
};
