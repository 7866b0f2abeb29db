#include "claims/trajectory.h"

#include "motion/motion.h"
#include "motion/taylor.h"
#include "text/decimal.h"
#include "text/scope.h"

enum { X, Y, Z, U, V, W };

enum {
    SLICES = 24,     /* of a box of states by length: the forces nearly cancel, which one box would not see */
    BOUND_BITS = 64, /* of bounds on derivatives */
    OTHERS = 3       /* numbers of a trajectory beside units and samples */
};

/* ---- the simulation ---- */

void sheet_value(arb_t x, const struct sheet *s, const char *name, slong prec)
{
    SCOPE(fmpq, value);
    literal_read(value, quantity_find(s, name)->value, true);
    arb_set_fmpq(x, value, prec);
}

void trajectory_init(struct trajectory *t)
{
    t->c1 = _arb_vec_init(OTHERS + VARIABLES + COORDINATES * t->count);
    t->c2 = t->c1 + 1;
    t->amplitude = t->c1 + 2;
    t->unit = t->c1 + OTHERS;
    t->Omega = t->unit + PSI_DOT;
    t->samples = t->unit + VARIABLES;
}

void trajectory_clear(struct trajectory *t)
{
    _arb_vec_clear(t->c1, OTHERS + VARIABLES + COORDINATES * t->count);
    second_order_clear(&t->closed);
}

/* What its samples are measured in, and the closed form. */
static void set_constants(struct trajectory *t, const struct flow_parameters *p, const fmpq_t theta, const char *swing)
{
    SCOPE(arb, x);
    flow_gains(t->c1, t->c2, p, t->prec);
    for (int i = PRODUCT; i < VARIABLES; i++)
        arb_one(t->unit + i);
    flow_units(t->unit, true, p, t->prec);
    _arb_vec_set(t->unit + PLACE_X, t->unit, FLOW_HALF);
    flow_units(t->unit, false, p, t->prec);
    arb_set_fmpq(t->amplitude, theta, t->prec);
    second_order_init(&t->closed, t->steps, t->c1, t->c2, t->prec);
    if (swing == NULL)
        return;
    arb_set_str(x, swing, t->prec);
    second_order_swing(&t->closed, x, t->amplitude);
}

/* The paper's scenario with the simulation's values, or with its state to start from. */
static void set_up(struct flow_parameters *p, arb_ptr initial, struct trajectory *t, const struct simulation *s)
{
    const char *const texts[SCENARIO_VALUES] = {[SET_n] = s->n,   [SET_psi] = s->psi, [SET_theta] = s->theta,
                                                [SET_dL] = s->dL, [SET_C1] = s->C1,   [SET_C2] = s->C2,
                                                [SET_m1] = s->m1, [SET_m2] = s->m2};
    OWNED(scenario) scenario;
    VECTOR(arb, forced, FLOW_STATE);
    SCOPE(arb, now);
    scenario_init(&scenario, s->steps->sheet, true);
    for (int i = 0; i < SCENARIO_VALUES; i++)
        if (texts[i] != NULL) {
            literal_read(&scenario.value[i].value, texts[i], true);
            scenario.given[i] = true;
        }
    for (int i = SET_psi; i <= SET_dL && s->scale != NULL; i++)
        fmpq_mul(&scenario.value[i].value, &scenario.value[i].value, s->scale);
    scenario_parameters(p, &scenario, t->prec);
    scenario_initial(initial, &scenario, p, s->nonlinear, t->prec);
    set_constants(t, p, &scenario.value[SET_theta].value, s->swing);
    arb_srcptr start = s->start;
    if (s->forced) {
        second_order_after(forced, &t->closed, t->amplitude, now);
        start = forced;
    }
    if (start == NULL)
        return;
    for (int i = 0; i < FLOW_STATE; i++)
        arb_mul(initial + i, t->unit + i, start + i, t->prec);
    if (s->nonlinear)
        state_from_angles(initial, s->steps->sheet, p, t->prec);
}

/* ---- samples ---- */

void angle_series(arb_ptr angles, arb_srcptr place, slong n, slong prec)
{
    arb_srcptr x = place, y = place + n, z = place + 2 * n;
    arb_ptr psi = angles, theta = angles + n, eta = angles + 2 * n;
    VECTOR(arb, l, n);
    VECTOR(arb, part, n);
    for (int i = 0; i < 3; i++) {
        _arb_poly_mullow(part, place + i * n, n, place + i * n, n, n, prec);
        _arb_vec_add(l, l, part, n, prec);
    }
    _arb_poly_sqrt_series(eta, l, n, n, prec);
    _arb_poly_div_series(part, z, n, eta, n, n, prec);
    _arb_poly_asin_series(theta, part, n, n, prec);
    _arb_vec_neg(theta, theta, n);
    arb_sub_ui(eta, eta, 1, prec);
    _arb_poly_div_series(part, y, n, x, n, n, prec);
    _arb_poly_atan_series(psi, part, n, n, prec);
    arb_atan2(psi, y, x, prec); /* on either side */
}

/* From place and velocity in units of the arm and of Omega. */
static void to_angles(arb_ptr sample, arb_srcptr state, slong prec)
{
    VECTOR(arb, moving, FLOW_STATE); /* each place, and its rate after it */
    VECTOR(arb, angles, FLOW_STATE);
    for (int i = 0; i < FLOW_STATE; i++)
        arb_set(moving + 2 * (i % 3) + i / 3, state + i);
    angle_series(angles, moving, 2, prec);
    for (int i = 0; i < FLOW_STATE; i++)
        arb_set(sample + i, angles + 2 * (i % 3) + i / 3);
}

static int take_sample(void *context, slong k, const fmpq_t time, arb_srcptr state)
{
    struct trajectory *t = context;
    arb_ptr sample = trajectory_sample(t, k), place = sample + PLACE_X;
    VECTOR(arb, own, FLOW_STATE);
    (void)time;
    if (t->nonlinear) {
        for (int i = 0; i < FLOW_STATE; i++) {
            arb_div(own + i, state + i, t->unit + PLACE_X, t->prec);
            if (i >= FLOW_HALF)
                arb_div(own + i, own + i, t->Omega, t->prec);
        }
        to_angles(sample, own, t->prec);
        _arb_vec_set(place, own, FLOW_HALF);
        return 0;
    }
    for (int i = 0; i < FLOW_STATE; i++)
        arb_div(sample + i, state + i, t->unit + i, t->prec);
    arb_add_ui(place, sample + ETA, 1, t->prec); /* eq10lin */
    arb_mul(place + 1, place, sample + PSI, t->prec);
    arb_mul(place + 2, place, sample + THETA, t->prec);
    arb_neg(place + 2, place + 2);
    return 0;
}

arb_ptr trajectory_sample(const struct trajectory *t, slong k)
{
    return t->samples + COORDINATES * k;
}

const char *const variable_names[] = {"psi", "theta", "dL", "psi_dot", "theta_dot", "dL_dot", "x1", "y1", "z1",
                                      "product", "amplitude", "phase"};

void commanded(arb_t product, const arb_t c1, const arb_t c2, const arb_t eta, const arb_t eta_dot, slong prec)
{
    arb_mul(product, c1, eta, prec);
    arb_addmul(product, c2, eta_dot, prec);
    arb_div_ui(product, product, 3, prec);
}

void trajectory_value(arb_t x, const struct trajectory *t, slong k, int which)
{
    arb_srcptr sample = trajectory_sample(t, k);
    SCOPE(arb, eta);
    if (which == PRODUCT) {
        if (t->other_law)
            moved_reference(eta, &t->closed, sample);
        arb_sub(eta, sample + ETA, eta, t->prec);
        commanded(x, t->c1, t->c2, eta, sample + ETA_DOT, t->prec);
    } else if (which == AMPLITUDE || which == PHASE) {
        SCOPE(acb, z);
        arb_set(acb_realref(z), sample + THETA);
        arb_mul_2exp_si(acb_imagref(z), sample + THETA_DOT, -1);
        arb_neg(acb_imagref(z), acb_imagref(z));
        (which == AMPLITUDE ? acb_abs : acb_arg)(x, z, t->prec);
    } else
        arb_set(x, sample + which);
}

/* Radians of orbit since the start. */
static void time_of_sample(arb_t tau, const struct trajectory *t, slong k)
{
    arb_mul_si(tau, t->Omega, t->first + k * t->step, t->prec);
}

void trajectory_slow_law(arb_t amplitude, const struct trajectory *t, slong k)
{
    SCOPE(arb, tau, shift);
    time_of_sample(tau, t, k);
    slow_law(amplitude, shift, &t->closed, t->amplitude, tau);
    arb_mul(amplitude, amplitude, t->amplitude, t->prec);
}

bool trajectory_run(struct trajectory *t, const struct simulation *s, long first, long step, long last)
{
    enum { FORCED_ORDER = 8 }; /* of derivatives: what is forced has no coordinate far from rest */
    const double radians = 7.3e-5 * (double)last; /* Omega, about */
    const slong digits = s->digits > 0 ? s->digits : TRAJECTORY_DIGITS;
    FLOW_PARAMETERS(p);
    SCOPE(fmpq, h);
    SCOPE(arb, tau);
    OWNED(moved_loop) moved;
    *t = (struct trajectory){.steps = s->steps, .nonlinear = s->nonlinear, .other_law = s->swing != NULL || s->held != NULL,
                             .prec = s->rk4 ? rk4_precision(digits, radians) : flow_precision(digits, radians),
                             .count = (last - first) / step + 1, .first = first, .step = step};
    VECTOR(arb, initial, FLOW_STATE);
    VECTOR(fmpq, times, t->count);
    trajectory_init(t);
    set_up(&p, initial, t, s);
    moved_loop_init(&moved, &t->closed);
    for (slong k = 0; k < t->count; k++)
        fmpq_set_si(times + k, first + k * step, 1);
    fmpq_set_si(h, s->rk4, 1);
    if (s->closed_form) {
        for (slong k = 0; k < t->count; k++) {
            time_of_sample(tau, t, k);
            second_order_after(trajectory_sample(t, k), &t->closed, t->amplitude, tau);
        }
        return true;
    }
    const struct flow_steps how = {.derivative_order = s->forced ? FORCED_ORDER : 0, .system = s->swing != NULL ? &moved.system : NULL,
                                   .constants = moved.constants, .held = s->held};
    if (flow_run(&(struct flow_request){&p, initial, times, t->count, digits, t->prec, take_sample, t, s->nonlinear,
                                        s->rk4 ? h : NULL, &how, 0}) == FLOW_DONE)
        return true;
    _arb_vec_indeterminate(t->samples, t->count * COORDINATES);
    return false;
}

/*
 * ---- between and after the samples ----
 *
 * Theorem. E of trajectory_energy never rises, so that from a sample on the state stays among those of its energy: in the
 * linear model an ellipsoid, in the nonlinear one the states with G(l) <= E on this side of the hill. What bounds a
 * coordinate's derivatives there bounds them for ever, and between two samples a tau apart |f| exceeds the larger of theirs
 * by at most tau^2/8 sup |f''|.
 *
 * The error terms, each with a test of its name in tests/claims/test_trajectory_bounds.c:
 *   (B1) the excess between samples, tau^2/8 sup |f''|                  (bound_between_samples, trajectory_supremum)
 *   (B2) of psi, psi', eta, eta', pitch and places the largest with that energy  (linear_bounds, energy_box)
 *   (B3) of their derivatives every term of (40), and of products all of Leibniz's rule   (linear_bounds)
 *   (B4) the length is confined on both sides, and the sample is between them; else nothing is  (confine)
 *   (B5) the slices leave no length out                                 (energy_box)
 *   (B6) k! times coefficient k, its radius included                    (set_bounds)
 *   (B7) what stays within a limit is below it between the samples too  (trajectory_exit)
 */

void tether_energy(arb_t energy, const struct derivations *steps, const arb_t c1, arb_srcptr sample, slong prec)
{
    VECTOR(arb, in, 1 + FLOW_STATE);
    VECTOR(arb, parts, 2); /* kinetic, potential */
    arb_set(in, c1);
    _arb_vec_set(in + 1, sample, FLOW_STATE);
    section_enclose(definition_find(&steps->definitions, "tether_energy"), in, prec, parts);
    arb_add(energy, parts, parts + 1, prec);
}

void trajectory_energy(arb_t energy, const struct trajectory *t, slong k)
{
    static const int of[] = {ETA_DOT, PSI_DOT, ETA, PSI};
    arb_srcptr sample = trajectory_sample(t, k);
    VECTOR(arb, in, 9); /* four squares, their weights, what is lost */
    VECTOR(arb, out, 2);
    for (int i = 0; i < 4; i++) {
        arb_set(in + i, sample + of[i]);
        arb_set_ui(in + 4 + i, of[i] == PSI ? 3 : 1);
    }
    arb_sub_ui(in + 6, t->c1, 9, t->prec);
    section_enclose(definition_find(&t->steps->definitions, "decay"), in, t->prec, out);
    arb_set(energy, out);
    if (t->nonlinear)
        tether_energy(energy, t->steps, t->c1, sample, t->prec);
}

/* sqrt(factor E) */
static void reach(arb_t x, const arb_t E, ulong numerator, ulong denominator, slong prec)
{
    arb_mul_ui(x, E, numerator, prec);
    arb_div_ui(x, x, denominator, prec);
    arb_sqrt(x, x, prec);
}

/* Bounds of the state from E, of its derivatives from (40). */
static void linear_bounds(arb_ptr b, const struct trajectory *t, const arb_t E, slong k)
{
    const slong prec = t->prec;
    arb_ptr psi = b + BOUND_OF(PSI, 0), theta = b + BOUND_OF(THETA, 0), eta = b + BOUND_OF(ETA, 0);
    SCOPE(arb, stiffness);
    arb_sub_ui(stiffness, t->c1, 9, prec);
    reach(psi, E, 2, 3, prec);
    reach(psi + 1, E, 2, 1, prec);
    arb_div(eta, E, stiffness, prec);
    reach(eta, eta, 2, 1, prec);
    arb_set(eta + 1, psi + 1);
    arb_hypot(theta, trajectory_sample(t, k) + THETA_DOT, trajectory_sample(t, k) + THETA, prec);
    arb_mul_2exp_si(theta, theta, 1); /* more than the amplitude, sqrt(theta^2 + theta'^2 / 4) */
    arb_mul_2exp_si(theta + 1, theta, 1);
    for (int d = 0; d + 2 < DERIVATIVES; d++) {
        arb_mul_ui(psi + d + 2, psi + d, 3, prec);
        arb_addmul_ui(psi + d + 2, eta + d + 1, 2, prec);
        arb_mul(eta + d + 2, stiffness, eta + d, prec);
        arb_addmul(eta + d + 2, t->c2, eta + d + 1, prec);
        arb_addmul_ui(eta + d + 2, psi + d + 1, 2, prec);
        arb_mul_ui(theta + d + 2, theta + d, 4, prec);
    }
    /* x = 1 + eta, y = (1 + eta) psi, z = -(1 + eta) theta, by Leibniz's rule */
    for (int d = 0; d < DERIVATIVES; d++) {
        static const ulong binomial[DERIVATIVES][DERIVATIVES] = {{1}, {1, 1}, {1, 2, 1}, {1, 3, 3, 1}};
        arb_add_ui(b + BOUND_OF(PLACE_X, d), eta + d, d == 0, prec);
        arb_set(b + BOUND_OF(PLACE_Y, d), psi + d);
        arb_set(b + BOUND_OF(PLACE_Z, d), theta + d);
        for (int i = 0; i <= d; i++) {
            SCOPE(arb, c);
            arb_mul_ui(c, eta + i, binomial[d][i], prec);
            arb_addmul(b + BOUND_OF(PLACE_Y, d), c, psi + d - i, prec);
            arb_addmul(b + BOUND_OF(PLACE_Z, d), c, theta + d - i, prec);
        }
    }
}

/*
 * An eta at which the potential exceeds E, so that no motion gets there: from most of what (40) says on, in small steps. At -eta it is
 * higher by 2 sum (c1 - 3 - c1/(2 k + 1)) eta^(2 k + 1), k > 0.
 */
static bool confine(arb_t eta, const struct trajectory *t, const arb_t E, slong k)
{
    bool outside = false;
    SCOPE(arb, potential, now);
    SCOPE(mag, bound);
    VECTOR(arb, at, FLOW_STATE); /* rest on the radius */
    arb_abs(now, trajectory_sample(t, k) + ETA);
    arb_sub_ui(potential, t->c1, 9, t->prec);
    arb_div(eta, E, potential, t->prec);
    arb_get_mag(bound, eta);
    mag_add_ui_2exp_si(bound, bound, 1, -99); /* at rest too */
    mag_sqrt(bound, bound);
    arf_set_mag(arb_midref(eta), bound);
    while (!outside && arf_cmp_2exp_si(arb_midref(eta), -1) < 0) {
        arb_mul_ui(eta, eta, 65, t->prec);
        arb_mul_2exp_si(eta, eta, -6);
        arb_get_mid_arb(eta, eta);
        arb_set(at + ETA, eta);
        tether_energy(potential, t->steps, t->c1, at, t->prec);
        outside = arb_gt(potential, E);
    }
    arb_get_mag(bound, trajectory_sample(t, k) + PSI);
    return outside && arb_lt(now, eta) && mag_cmp_2exp_si(bound, 0) < 0; /* 1 rad: on this side of the hill */
}

/* The states with that energy, and q = 1/l; of them the slice number i by length. */
static void energy_box(struct jet *jet, const arb_t E, const arb_t eta, slong i, slong prec)
{
    static const ulong reaches[][2] = {[Y] = {2, 3}, [Z] = {1, 2}, [U] = {2, 1}, [V] = {2, 1}, [W] = {2, 1}};
    SCOPE(arb, a, l);
    for (int k = Y; k <= W; k++) {
        reach(a, E, reaches[k][0], reaches[k][1], prec);
        arb_zero(jet->c[k]);
        arb_add_error(jet->c[k], a);
    }
    arb_div_ui(a, eta, SLICES, prec);
    arb_one(l);
    arb_add_error(l, a);
    arb_addmul_si(l, a, 2 * i + 1 - SLICES, prec);
    arb_inv(jet->c[JET_STATES - 1], l, prec);
    arb_sqr(a, l, prec);
    arb_submul(a, jet->c[Y], jet->c[Y], prec);
    arb_submul(a, jet->c[Z], jet->c[Z], prec);
    arb_sqrt(jet->c[X], a, prec);
}

/* bound k, if not larger yet: |k! coefficient k| */
static void set_bounds(arb_ptr bound, arb_srcptr series, slong prec)
{
    for (slong d = 0, factorial = 1; d < DERIVATIVES; factorial *= ++d) {
        SCOPE(arb, a);
        arb_mul_si(a, series + d, factorial, prec);
        arb_get_abs_ubound_arf(arb_midref(a), a, prec);
        mag_zero(arb_radref(a));
        arb_max(bound + d, bound + d, a, prec);
    }
}

bool trajectory_bounds(arb_ptr b, const struct trajectory *t, slong k)
{
    bool bounded = !t->other_law;
    SCOPE(arb, E, eta);
    VECTOR(arb, angles, 3 * DERIVATIVES);
    _arb_vec_zero(b, BOUNDS);
    trajectory_energy(E, t, k);
    if (t->nonlinear) {
        OWNED(jet) jet;
        jet_init(&jet, &closed_loop, DERIVATIVES - 1, NULL);
        jet_constants(&jet, t->c1, t->c2);
        bounded = confine(eta, t, E, k) && bounded;
        for (slong i = 0; i < SLICES; i++) {
            energy_box(&jet, E, eta, i, BOUND_BITS);
            jet_extend(&jet, &jet, BOUND_BITS, 0);
            angle_series(angles, jet.c[X], DERIVATIVES, BOUND_BITS); /* y and z stand after x */
            for (int c = 0; c < 3; c++) {
                set_bounds(b + BOUND_OF(PSI + c, 0), angles + c * DERIVATIVES, BOUND_BITS);
                set_bounds(b + BOUND_OF(PLACE_X + c, 0), jet.c[X + c], BOUND_BITS);
            }
        }
    } else {
        linear_bounds(b, t, E, k);
    }
    for (int i = 0; i < FLOW_HALF; i++)
        _arb_vec_set(b + BOUND_OF(PSI_DOT + i, 0), b + BOUND_OF(PSI + i, 1), DERIVATIVES - 1);
    return bounded;
}

void bound_between_samples(arb_t excess, const struct trajectory *t, arb_srcptr b, int which)
{
    SCOPE(arb, curvature);
    if (which == PRODUCT)
        commanded(curvature, t->c1, t->c2, b + BOUND_OF(ETA, 2), b + BOUND_OF(ETA_DOT, 2), t->prec);
    else
        arb_set(curvature, b + BOUND_OF(which, 2));
    arb_mul_si(excess, t->Omega, t->step, t->prec);
    arb_sqr(excess, excess, t->prec);
    arb_mul(excess, excess, curvature, t->prec);
    arb_mul_2exp_si(excess, excess, -3);
}

void trajectory_peak(arb_t peak, const struct trajectory *t, const struct trajectory *beside, int which, slong from, slong to)
{
    SCOPE(arb, x, y);
    arb_zero(peak);
    for (slong k = from; k <= to; k++) {
        trajectory_value(x, t, k, which);
        if (beside != NULL)
            trajectory_value(y, beside, k, which);
        arb_sub(x, x, y, t->prec);
        arb_abs(x, x);
        arb_max(peak, peak, x, t->prec);
    }
}

bool trajectory_supremum(arb_t supremum, const struct trajectory *t, const struct trajectory *beside, int which, slong from, slong to)
{
    const struct trajectory *const both[] = {t, beside, NULL};
    bool bounded = true;
    VECTOR(arb, b, BOUNDS);
    SCOPE(arb, excess);
    trajectory_peak(supremum, t, beside, which, from, to);
    for (int i = 0; both[i] != NULL; i++) {
        bounded = trajectory_bounds(b, both[i], from) && bounded;
        bound_between_samples(excess, both[i], b, which);
        arb_add(supremum, supremum, excess, t->prec);
    }
    return bounded;
}

/* The time between two samples in hours. */
static void time_between(arb_t hours, const struct trajectory *t, slong above, slong below)
{
    SCOPE(arb, value);
    arb_set_si(hours, t->first + above * t->step);
    arb_set_si(value, t->first + below * t->step);
    arb_union(hours, hours, value, t->prec);
    arb_div_ui(hours, hours, 3600, t->prec);
}

bool trajectory_exit(arb_t hours, const struct trajectory *t, int which, const arb_t limit)
{
    enum { RENEWED = 256 }; /* samples: bounds hold on; renewed, they are sharper */
    VECTOR(arb, b, BOUNDS);
    SCOPE(arb, value, bound);
    slong below = t->count; /* from that sample on it is below, between samples too */
    bool bounded = true, above = false;
    arb_indeterminate(hours);
    for (slong k = t->count - 1; k >= 0 && !above; k--) {
        if (k % RENEWED == RENEWED - 1 || k == t->count - 1)
            bounded = trajectory_bounds(b, t, k - k % RENEWED) && bounded;
        arb_abs(value, trajectory_sample(t, k) + which);
        bound_between_samples(bound, t, b, which);
        arb_add(bound, bound, value, t->prec);
        above = arb_gt(value, limit);
        if (above && below < t->count)
            time_between(hours, t, k, below);
        if (below == k + 1 && arb_lt(bound, limit))
            below = k;
    }
    return bounded;
}
