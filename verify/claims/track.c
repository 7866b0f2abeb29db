#include "claims/track.h"

#include <stdlib.h>
#include <string.h>

#include "motion/motion.h"
#include "motion/taylor.h"
#include "text/decimal.h"
#include "text/scope.h"

enum { X, Y, Z, U, V, W };

enum {
    SLICES = 24,     /* of a box of states by length: the forces nearly cancel, which one box would not see */
    BOUND_BITS = 64, /* of bounds on derivatives */
    COMPARISON_BITS = 128
};

/* ---- comparisons ---- */

void observed_order(arb_t order, const arb_t larger, const arb_t smaller, ulong factor)
{
    arb_div(order, larger, smaller, COMPARISON_BITS);
    arb_log_base_ui(order, order, factor, COMPARISON_BITS);
}

void raise_to_difference(arb_t worst, const arb_t x, slong expected)
{
    SCOPE(arb, difference);
    arb_sub_si(difference, x, expected, COMPARISON_BITS);
    arb_abs(difference, difference);
    arb_max(worst, worst, difference, COMPARISON_BITS);
}

/* ---- scenes ---- */

static void set_value(arb_t x, const struct sheet *sheet, const char *text, const char *name, slong prec)
{
    SCOPE(fmpq, value);
    literal_read(value, text != NULL ? text : quantity_find(sheet, name)->value, true);
    arb_set_fmpq(x, value, prec);
}

void sheet_value(arb_t x, const struct sheet *sheet, const char *name, slong prec)
{
    set_value(x, sheet, NULL, name, prec);
}

static void enclose(const struct sheet *sheet, const char *id, arb_srcptr inputs, slong prec, arb_ptr outputs)
{
    section_enclose(section_find(sheet, id), inputs, prec, outputs);
}

/* Table 1, and the gains by (43) and (44) */
static void set_parameters(struct flow_parameters *p, const struct sheet *sheet, const struct scene *s, slong prec)
{
    VECTOR(arb, gains, 2);
    set_value(p->Omega, sheet, NULL, "Omega", prec);
    set_value(p->L_ref, sheet, NULL, "L_ref", prec);
    set_value(p->k_c, sheet, NULL, "k_c", prec);
    set_value(p->m1, sheet, s->m1, "m1", prec);
    set_value(p->m2, sheet, s->m2, "m2", prec);
    arb_set(gains, p->Omega);
    set_value(gains + 1, sheet, s->n, "n", prec);
    enclose(sheet, "eq43", gains, prec, p->C1);
    enclose(sheet, "eq44", gains, prec, p->C2);
}

/* psi theta dL and rates in SI; a nonlinear motion's place and velocity by (10) and its exact derivative */
static void set_initial(arb_ptr initial, const struct sheet *sheet, const struct flow_parameters *p, const struct scene *s, slong prec)
{
    set_value(initial, sheet, s->psi, "psi", prec);
    set_value(initial + 1, sheet, s->theta, "theta", prec);
    set_value(initial + 2, sheet, s->dL, "dL", prec);
    for (int i = 0; i < FLOW_STATE && s->start != NULL; i++) {
        arb_set(initial + i, s->start + i);
        if (i >= PSI_DOT)
            arb_mul(initial + i, initial + i, p->Omega, prec);
        if (i % 3 == ETA)
            arb_mul(initial + i, initial + i, p->L_ref, prec);
    }
    if (!s->nonlinear)
        return;
    VECTOR(arb, in, 8); /* m1 m2 L psi theta L_dot psi_dot theta_dot */
    arb_set(in, p->m1);
    arb_set(in + 1, p->m2);
    arb_add(in + 2, p->L_ref, initial + ETA, prec);
    arb_set(in + 3, initial + PSI);
    arb_set(in + 4, initial + THETA);
    arb_set(in + 5, initial + ETA_DOT);
    arb_set(in + 6, initial + PSI_DOT);
    arb_set(in + 7, initial + THETA_DOT);
    enclose(sheet, "eq10", in, prec, initial);
    enclose(sheet, "eq11exact", in, prec, initial + 3);
}

/* ---- rows ---- */

/* From place and velocity in units of the arm and of Omega; x > 0. */
static void to_angles(arb_ptr row, arb_srcptr s, slong prec)
{
    VECTOR(arb, a, 4);
    arb_ptr across = a, l = a + 1, l_dot = a + 2, x = a + 3; /* across: distance from the orbit normal */
    arb_dot(across, NULL, 0, s, 1, s, 1, 2, prec);
    arb_mul(x, s + X, s + V, prec);
    arb_submul(x, s + Y, s + U, prec);
    arb_div(row + PSI_DOT, x, across, prec);
    arb_dot(l, across, 0, s + Z, 1, s + Z, 1, 1, prec);
    arb_sqrt(across, across, prec);
    arb_sqrt(l, l, prec);
    arb_dot(l_dot, NULL, 0, s, 1, s + U, 1, 3, prec);
    arb_div(l_dot, l_dot, l, prec);
    arb_div(row + PSI, s + Y, s + X, prec);
    arb_atan(row + PSI, row + PSI, prec);
    arb_div(x, s + Z, l, prec);
    arb_asin(row + THETA, x, prec);
    arb_neg(row + THETA, row + THETA);
    arb_mul(x, x, l_dot, prec);
    arb_sub(x, x, s + W, prec);
    arb_div(row + THETA_DOT, x, across, prec);
    arb_sub_ui(row + ETA, l, 1, prec);
    arb_set(row + ETA_DOT, l_dot);
}

static int take_row(void *context, slong k, const fmpq_t time, arb_srcptr state)
{
    struct track *t = context;
    arb_ptr own = _arb_vec_init(FLOW_STATE), row = track_row(t, k);
    (void)time;
    for (int i = 0; i < FLOW_STATE; i++) {
        arb_set(own + i, state + i);
        if (i >= 3)
            arb_div(own + i, own + i, t->Omega, t->prec);
        if (t->nonlinear)
            arb_div(own + i, own + i, t->arm, t->prec);
        else if (i % 3 == ETA)
            arb_div(own + i, own + i, t->L_ref, t->prec);
    }
    if (t->nonlinear) {
        to_angles(row, own, t->prec);
        _arb_vec_set(row + PLACE_X, own, 3);
    } else { /* eq10lin */
        _arb_vec_set(row, own, FLOW_STATE);
        arb_add_ui(row + PLACE_X, row + ETA, 1, t->prec);
        arb_mul(row + PLACE_Y, row + PLACE_X, row + PSI, t->prec);
        arb_mul(row + PLACE_Z, row + PLACE_X, row + THETA, t->prec);
        arb_neg(row + PLACE_Z, row + PLACE_Z);
    }
    const bool upright = !t->nonlinear || arb_is_positive(own + X);
    _arb_vec_clear(own, FLOW_STATE);
    return !upright;
}

static void track_init(struct track *t, const struct flow_parameters *p)
{
    arb_init(t->c1);
    arb_init(t->c2);
    arb_init(t->Omega);
    arb_init(t->L_ref);
    arb_init(t->arm);
    arb_set(t->Omega, p->Omega);
    arb_set(t->L_ref, p->L_ref);
    arb_div(t->c2, p->C2, p->Omega, t->prec);
    arb_div(t->c1, p->C1, p->Omega, t->prec);
    arb_div(t->c1, t->c1, p->Omega, t->prec);
    arb_add(t->arm, p->m1, p->m2, t->prec);
    arb_div(t->arm, p->m2, t->arm, t->prec);
    arb_mul(t->arm, t->arm, p->L_ref, t->prec);
    t->rows = _arb_vec_init(COORDINATES * t->count);
}

void track_clear(struct track *t)
{
    _arb_vec_clear(t->rows, COORDINATES * t->count);
    arb_clear(t->arm);
    arb_clear(t->L_ref);
    arb_clear(t->Omega);
    arb_clear(t->c2);
    arb_clear(t->c1);
}

arb_ptr track_row(const struct track *t, slong k)
{
    return t->rows + COORDINATES * k;
}

bool track_run(struct track *t, const struct sheet *sheet, const struct scene *s, long first, long step, long last)
{
    const double radians = 7.3e-5 * (double)last; /* Omega, about */
    const slong digits = s->digits > 0 ? s->digits : TRACK_DIGITS;
    struct flow_parameters p;
    double reached;
    enum flow_status status;
    SCOPE(fmpq, h);
    flow_parameters_init(&p);
    t->nonlinear = s->nonlinear;
    t->first = first;
    t->step = step;
    t->count = (last - first) / step + 1;
    t->prec = s->rk4 ? rk4_precision(digits, radians) : flow_precision(digits, radians);
    VECTOR(arb, initial, FLOW_STATE);
    VECTOR(fmpq, times, t->count);
    set_parameters(&p, sheet, s, t->prec);
    set_initial(initial, sheet, &p, s, t->prec);
    track_init(t, &p);
    for (slong k = 0; k < t->count; k++)
        fmpq_set_si(times + k, first + k * step, 1);
    fmpq_set_si(h, s->rk4, 1);
    if (s->rk4 && s->nonlinear)
        status = rk4_nonlinear(&p, initial, h, times, t->count, t->prec, take_row, t, &reached);
    else if (s->rk4)
        status = rk4_linear(&p, initial, h, times, t->count, t->prec, take_row, t, &reached);
    else if (s->nonlinear)
        status = flow_nonlinear(&p, initial, times, t->count, digits, t->prec, take_row, t, &reached);
    else
        status = flow_linear(&p, initial, times, t->count, t->prec, take_row, t, &reached);
    flow_parameters_clear(&p);
    return status == FLOW_DONE;
}

/*
 * ---- between and after the rows ----
 *
 * Theorem. E of track_energy never rises, so that from a row on the state stays among those of its energy: in the linear
 * model an ellipsoid, in the nonlinear one the states with G(l) <= E on this side of the hill. What bounds a coordinate's
 * derivatives there bounds them for ever, and between two rows a tau apart |f| exceeds the larger of theirs by at most
 * tau^2/8 sup |f''|.
 *
 * The error terms, each with a test of its name in tests/claims/test_track.c:
 *   (B1) the room between rows, tau^2/8 sup |f''|                       (track_room, track_sup)
 *   (B2) of psi, psi', eta, eta', pitch and places the largest with that energy  (linear_bounds, energy_box)
 *   (B3) of their derivatives every term of (40), and of products all of Leibniz's rule   (linear_bounds)
 *   (B4) the length is confined on both sides, and the row is between them; else nothing is  (confine)
 *   (B5) the slices leave no length out                                 (energy_box)
 *   (B6) k! times coefficient k, its radius included                    (set_bounds)
 *   (B7) what has settled is below between the rows too                 (track_settled)
 */

/* G(1 + eta) */
static void tether_energy(arb_t G, const struct track *t, const arb_t eta)
{
    SCOPE(arb, l, a);
    arb_add_ui(l, eta, 1, t->prec);
    arb_sub_ui(a, t->c1, 3, t->prec);
    arb_mul(a, a, eta, t->prec);
    arb_div(a, a, l, t->prec);
    arb_log(G, l, t->prec);
    arb_mul(G, G, t->c1, t->prec);
    arb_sub(G, G, a, t->prec);
    arb_add_ui(l, l, 1, t->prec);
    arb_mul(l, l, eta, t->prec);
    arb_mul_ui(l, l, 3, t->prec);
    arb_mul_2exp_si(l, l, -1);
    arb_sub(G, G, l, t->prec);
}

/* weight a^2 / 2 */
static void add_square(arb_t sum, const arb_t weight, const arb_t a, slong prec)
{
    SCOPE(arb, s);
    arb_sqr(s, a, prec);
    arb_mul(s, s, weight, prec);
    arb_mul_2exp_si(s, s, -1);
    arb_add(sum, sum, s, prec);
}

void track_energy(arb_t energy, const struct track *t, slong k)
{
    arb_srcptr row = track_row(t, k);
    const slong prec = t->prec;
    VECTOR(arb, a, 6);
    arb_ptr l = a, sine = a + 1, cosine = a + 2, weight = a + 3, v = a + 4;
    arb_zero(energy);
    if (t->nonlinear)
        tether_energy(energy, t, row + ETA);
    arb_one(weight);
    arb_add_ui(l, row + ETA, 1, prec);
    arb_sin_cos(sine, cosine, row + THETA, prec);
    add_square(energy, weight, row + ETA_DOT, prec);
    if (t->nonlinear) { /* u^2 + v^2 + w^2 = l'^2 + (l theta')^2 + (l cos(theta) psi')^2 */
        arb_mul(v, l, row + THETA_DOT, prec);
        add_square(energy, weight, v, prec);
        arb_mul(cosine, cosine, l, prec);
        arb_mul(v, cosine, row + PSI_DOT, prec);
        add_square(energy, weight, v, prec);
        arb_set_ui(weight, 4);
        arb_mul(v, l, sine, prec);
        add_square(energy, weight, v, prec);
        arb_sin(v, row + PSI, prec);
        arb_mul(v, v, cosine, prec);
    } else {
        add_square(energy, weight, row + PSI_DOT, prec);
        arb_sub_ui(weight, t->c1, 9, prec);
        add_square(energy, weight, row + ETA, prec);
        arb_set(v, row + PSI);
    }
    arb_set_ui(weight, 3);
    add_square(energy, weight, v, prec);
}

/* A rate shares its coordinate's vector, from the first derivative on. */
void bounds_init(struct bounds *b)
{
    for (int i = PSI; i <= ETA; i++) {
        b->of[i] = _arb_vec_init(DERIVATIVES);
        b->of[i + PSI_DOT] = b->of[i] + 1;
        b->of[i + PLACE_X] = _arb_vec_init(DERIVATIVES);
    }
}

void bounds_clear(struct bounds *b)
{
    for (int i = PSI; i <= ETA; i++) {
        _arb_vec_clear(b->of[i], DERIVATIVES);
        _arb_vec_clear(b->of[i + PLACE_X], DERIVATIVES);
    }
}

static void bounds_zero(struct bounds *b)
{
    for (int i = PSI; i <= ETA; i++) {
        _arb_vec_zero(b->of[i], DERIVATIVES);
        _arb_vec_zero(b->of[i + PLACE_X], DERIVATIVES);
    }
}

/* sqrt(factor E) */
static void reach(arb_t x, const arb_t E, ulong numerator, ulong denominator, slong prec)
{
    arb_mul_ui(x, E, numerator, prec);
    arb_div_ui(x, x, denominator, prec);
    arb_sqrt(x, x, prec);
}

/* Bounds of the state from E, of its derivatives from (40). */
static void linear_bounds(struct bounds *b, const struct track *t, const arb_t E, slong k)
{
    const slong prec = t->prec;
    arb_ptr psi = b->of[PSI], theta = b->of[THETA], eta = b->of[ETA];
    SCOPE(arb, stiffness);
    arb_sub_ui(stiffness, t->c1, 9, prec);
    reach(psi, E, 2, 3, prec);
    reach(psi + 1, E, 2, 1, prec);
    arb_div(eta, E, stiffness, prec);
    reach(eta, eta, 2, 1, prec);
    arb_set(eta + 1, psi + 1);
    arb_hypot(theta, track_row(t, k) + THETA_DOT, track_row(t, k) + THETA, prec);
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
        arb_add_ui(b->of[PLACE_X] + d, eta + d, d == 0, prec);
        arb_set(b->of[PLACE_Y] + d, psi + d);
        arb_set(b->of[PLACE_Z] + d, theta + d);
        for (int i = 0; i <= d; i++) {
            SCOPE(arb, c);
            arb_mul_ui(c, eta + i, binomial[d][i], prec);
            arb_addmul(b->of[PLACE_Y] + d, c, psi + d - i, prec);
            arb_addmul(b->of[PLACE_Z] + d, c, theta + d - i, prec);
        }
    }
}

/* The shortest eta (within an eighth) at which both G(1 + eta) and G(1 - eta) exceed E: no motion gets there. */
static bool confine(arb_t eta, const struct track *t, const arb_t E, slong k)
{
    bool outside = false, inside;
    SCOPE(arb, G, minus, now);
    arb_abs(now, track_row(t, k) + ETA);
    arb_one(eta);
    arb_mul_2exp_si(eta, eta, -60);
    while (!outside && arf_cmp_2exp_si(arb_midref(eta), -1) < 0) {
        arb_mul_ui(eta, eta, 9, 16);
        arb_mul_2exp_si(eta, eta, -3);
        arb_get_mid_arb(eta, eta);
        arb_neg(minus, eta);
        tether_energy(G, t, eta);
        outside = arb_gt(G, E);
        tether_energy(G, t, minus);
        outside = outside && arb_gt(G, E);
    }
    inside = arb_lt(now, eta);
    return outside && inside;
}

static void plus_minus(arb_t x, const arb_t bound)
{
    SCOPE(mag, m);
    arb_get_mag(m, bound);
    arb_zero(x);
    arb_add_error_mag(x, m);
}

/* The states with that energy, and q = 1/l; of them the slice number i by length. */
static void energy_box(struct jet *jet, const arb_t E, const arb_t eta, slong i, slong prec)
{
    SCOPE(arb, a, b);
    reach(a, E, 2, 1, prec);
    for (int i = U; i <= W; i++)
        plus_minus(jet->c[i], a);
    reach(a, E, 2, 3, prec);
    plus_minus(jet->c[Y], a);
    reach(a, E, 1, 2, prec);
    plus_minus(jet->c[Z], a);
    arb_div_ui(a, eta, SLICES, prec);
    plus_minus(b, a);
    arb_addmul_si(b, a, 2 * i + 1 - SLICES, prec);
    arb_add_ui(b, b, 1, prec); /* l */
    arb_inv(jet->c[JET_STATES - 1], b, prec);
    arb_sqr(a, b, prec);
    arb_submul(a, jet->c[Y], jet->c[Y], prec);
    arb_submul(a, jet->c[Z], jet->c[Z], prec);
    arb_sqrt(jet->c[X], a, prec);
}

/* bound k, if not larger yet: |k! coefficient k| */
static void set_bounds(arb_ptr bound, const arb_poly_t series, slong prec)
{
    for (slong d = 0, factorial = 1; d < DERIVATIVES; factorial *= ++d) {
        SCOPE(arb, a);
        arb_poly_get_coeff_arb(a, series, d);
        arb_mul_si(a, a, factorial, prec);
        arb_get_abs_ubound_arf(arb_midref(a), a, prec);
        mag_zero(arb_radref(a));
        arb_max(bound + d, bound + d, a, prec);
    }
}

/* Taylor series of the motion from any state of the box, and of psi, theta and eta along it. */
static void nonlinear_bounds(struct bounds *b, const struct jet *jet, slong prec)
{
    const slong n = DERIVATIVES;
    arb_poly_t s[3], l, a;
    arb_poly_init(l);
    arb_poly_init(a);
    for (int i = X; i <= Z; i++) {
        arb_poly_init(s[i]);
        for (slong d = 0; d < n; d++)
            arb_poly_set_coeff_arb(s[i], d, jet->c[i] + d);
        set_bounds(b->of[PLACE_X + i], s[i], prec);
        arb_poly_mullow(a, s[i], s[i], n, prec);
        arb_poly_add(l, l, a, prec);
    }
    arb_poly_sqrt_series(l, l, n, prec);
    arb_poly_div_series(a, s[Y], s[X], n, prec);
    arb_poly_atan_series(a, a, n, prec);
    set_bounds(b->of[PSI], a, prec);
    arb_poly_div_series(a, s[Z], l, n, prec);
    arb_poly_asin_series(a, a, n, prec);
    set_bounds(b->of[THETA], a, prec);
    arb_poly_add_si(l, l, -1, prec);
    set_bounds(b->of[ETA], l, prec);
    for (int i = X; i <= Z; i++)
        arb_poly_clear(s[i]);
    arb_poly_clear(a);
    arb_poly_clear(l);
}

bool track_bounds(struct bounds *b, const struct track *t, slong k)
{
    bool bounded = true;
    SCOPE(arb, E, eta);
    bounds_zero(b);
    track_energy(E, t, k);
    if (t->nonlinear) {
        struct jet jet;
        jet_init(&jet, DERIVATIVES - 1);
        jet_constants(&jet, t->c1, t->c2);
        bounded = confine(eta, t, E, k);
        for (slong i = 0; i < SLICES; i++) {
            energy_box(&jet, E, eta, i, BOUND_BITS);
            jet_extend(&jet, BOUND_BITS, 0);
            nonlinear_bounds(b, &jet, BOUND_BITS);
        }
        jet_clear(&jet);
    } else {
        linear_bounds(b, t, E, k);
    }
    return bounded;
}

/* |f| stays below the larger of two rows' |f| plus tau^2/8 |f''|, tau the distance of the rows. */
void track_room(arb_t room, const struct track *t, const struct bounds *b, int which)
{
    arb_mul_si(room, t->Omega, t->step, t->prec);
    arb_sqr(room, room, t->prec);
    arb_mul(room, room, b->of[which] + 2, t->prec);
    arb_mul_2exp_si(room, room, -3);
}

void track_peak(arb_t peak, const struct track *t, int which, slong from, slong to)
{
    SCOPE(arb, a);
    arb_zero(peak);
    for (slong k = from; k <= to; k++) {
        arb_abs(a, track_row(t, k) + which);
        arb_max(peak, peak, a, t->prec);
    }
}

bool track_sup(arb_t sup, const struct track *t, int which, slong from, slong to)
{
    struct bounds b;
    SCOPE(arb, room);
    bounds_init(&b);
    bool bounded = track_bounds(&b, t, from);
    track_peak(sup, t, which, from, to);
    track_room(room, t, &b, which);
    arb_add(sup, sup, room, t->prec);
    bounds_clear(&b);
    return bounded;
}

void track_gap(arb_t gap, const struct track *a, const struct track *b, int which, slong from, slong to)
{
    SCOPE(arb, d);
    arb_zero(gap);
    for (slong k = from; k <= to; k++) {
        arb_sub(d, track_row(a, k) + which, track_row(b, k) + which, a->prec);
        arb_abs(d, d);
        arb_max(gap, gap, d, a->prec);
    }
}

/* From the row `below` on |coordinate| is below the limit, between the rows too; `above` is the last row where it is not. */
struct exit {
    slong below, above;
};

static void exit_find(arb_t hours, const struct exit *e, const struct track *t)
{
    SCOPE(arb, value);
    arb_set_si(hours, t->first + e->above * t->step);
    arb_set_si(value, t->first + e->below * t->step);
    arb_union(hours, hours, value, t->prec);
    arb_div_ui(hours, hours, 3600, t->prec);
    if (e->above < 0 || e->above >= e->below || e->below >= t->count)
        arb_indeterminate(hours);
}

bool track_exits(arb_ptr hours, const struct track *t, int which, arb_srcptr limits, int count)
{
    enum { RENEWED = 256 }; /* rows */
    struct exit *exits = xrealloc(NULL, (size_t)count, sizeof *exits);
    struct bounds b;
    SCOPE(arb, value, bound);
    bool bounded = true;
    bounds_init(&b);
    for (int i = 0; i < count; i++)
        exits[i] = (struct exit){t->count, -1};
    for (slong k = t->count - 1; k >= 0; k--) {
        if (k % RENEWED == RENEWED - 1 || k == t->count - 1) /* bounds hold on; renewed, they are sharper */
            bounded = track_bounds(&b, t, k - k % RENEWED) && bounded;
        arb_abs(value, track_row(t, k) + which);
        track_room(bound, t, &b, which);
        arb_add(bound, bound, value, t->prec);
        bool open = false;
        for (int i = 0; i < count; i++) {
            if (exits[i].above < 0 && arb_gt(value, limits + i))
                exits[i].above = k;
            if (exits[i].below == k + 1 && arb_lt(bound, limits + i))
                exits[i].below = k;
            open = open || exits[i].above < 0;
        }
        if (!open)
            break;
    }
    for (int i = 0; i < count; i++)
        exit_find(hours + i, &exits[i], t);
    free(exits);
    bounds_clear(&b);
    return bounded;
}

bool track_settled(arb_t hours, const struct track *t, int which, const arb_t limit)
{
    return track_exits(hours, t, which, limit, 1) && arb_is_finite(hours);
}

bool is_below(const arb_t x, double limit)
{
    SCOPE(arb, y);
    arb_set_d(y, limit);
    return arb_lt(x, y);
}
