#include "claims/convergence.h"

#include <stdlib.h>
#include <string.h>

#include "claims/second_order.h"
#include "claims/track.h"
#include "motion/two_body.h"
#include "text/decimal.h"
#include "text/scope.h"

enum { PREC = 192, SLOW_DIGITS = 10 }; /* what the slow law leaves is of the order of a^2, a >= 1/20 */

/* ---- motions ----------------------------------------------------------- */

/* A quantity's own value times the scale, as the exact decimal that a scene wants; to be freed. */
static char *scaled(const struct sheet *sheet, const char *name, const fmpq_t scale)
{
    SCOPE(fmpq, x);
    literal_read(x, quantity_find(sheet, name)->value, true);
    fmpq_mul(x, x, scale);
    return decimal_of_rational(x, 17);
}

/* |a - b| of the study's coordinates in the tracks' rows 0, in SI */
static void differences(arb_ptr d, const struct study *study, const struct track *a, const struct track *b)
{
    for (int i = 0; i < study->count; i++) {
        const int which = study->which[i];
        track_gap(d + i, a, b, which, 0, 0);
        if (which == ETA || which == ETA_DOT)
            arb_mul(d + i, d + i, a->L_ref, PREC);
        if (which >= PSI_DOT && which <= ETA_DOT)
            arb_mul(d + i, d + i, a->Omega, PREC);
        if (which >= PLACE_X && which <= PLACE_Z)
            arb_mul(d + i, d + i, a->arm, PREC);
    }
}

/* Two motions after the study's time. */
static bool compare(arb_ptr d, const struct derivations *steps, const struct study *study, const struct scene *one, const struct scene *other)
{
    struct track a, b;
    bool proved = track_run(&a, steps->sheet, one, study->seconds, 1, study->seconds);
    proved = track_run(&b, steps->sheet, other, study->seconds, 1, study->seconds) && proved;
    differences(d, study, &a, &b);
    track_clear(&a);
    track_clear(&b);
    return proved;
}

/* The nonlinear motion against the linear; the parameter scales the initial disturbance. */
static bool from_linear(arb_ptr d, const struct derivations *steps, const struct study *study, const fmpq_t scale)
{
    char *psi = scaled(steps->sheet, "psi", scale), *theta = scaled(steps->sheet, "theta", scale), *dL = scaled(steps->sheet, "dL", scale);
    struct scene s = {.psi = study->pitch_alone ? "0" : psi, .theta = theta, .dL = study->pitch_alone ? "0" : dL};
    struct scene linear = s;
    s.nonlinear = true;
    bool proved = compare(d, steps, study, &s, &linear);
    free(psi);
    free(theta);
    free(dL);
    return proved;
}

/* The classical Runge-Kutta method against the motion; the parameter is its step in s. */
static bool from_steps(arb_ptr d, const struct derivations *steps, const struct study *study, const fmpq_t h)
{
    struct scene exact = {.nonlinear = study->nonlinear}, stepped = exact;
    stepped.rk4 = (long)fmpq_get_d(h);
    return compare(d, steps, study, &stepped, &exact);
}

/* ---- the closed forms of second_order.h -------------------------------- */

/* Where the motion and the closed form are that both had z = a at the start, after so many seconds. */
static bool beside_closed_form(struct track *t, const struct derivations *steps, arb_ptr closed, const fmpq_t a, long seconds, slong digits)
{
    struct second_order o;
    SCOPE(arb, amplitude, tau);
    bool proved = track_run(t, steps->sheet, &(struct scene){.nonlinear = false}, 0, 1, 0); /* for Table 1's gains and Omega */
    second_order_init(&o, steps, t->c1, t->c2, PREC);
    arb_set_fmpq(amplitude, a, PREC);
    second_order_after(closed, &o, amplitude, tau);
    arb_mul_si(tau, t->Omega, seconds, PREC);
    track_clear(t);
    proved = track_run(t, steps->sheet, &(struct scene){.nonlinear = true, .digits = digits, .start = closed}, seconds, 1, seconds) && proved;
    second_order_after(closed, &o, amplitude, tau);
    second_order_clear(&o);
    return proved;
}

/* After a fixed time; the parameter is the amplitude. */
static bool from_forced(arb_ptr d, const struct derivations *steps, const struct study *study, const fmpq_t a)
{
    struct track motion, closed;
    bool proved = track_run(&closed, steps->sheet, &(struct scene){.nonlinear = false}, 0, 1, 0);
    proved = beside_closed_form(&motion, steps, track_row(&closed, 0), a, study->seconds, TRACK_DIGITS) && proved;
    differences(d, study, &motion, &closed);
    track_clear(&motion);
    track_clear(&closed);
    return proved;
}

/* z of a row: what the linear model turns at 2 Omega */
static void pitch_of(acb_t z, arb_srcptr row)
{
    arb_set(acb_realref(z), row + THETA);
    arb_mul_2exp_si(acb_imagref(z), row + THETA_DOT, -1);
    arb_neg(acb_imagref(z), acb_imagref(z));
}

/* After 1/a^2 radians, to the second: the amplitude, relative to the closed form's, and the phase of pitch. */
static bool from_slow_law(arb_ptr d, const struct derivations *steps, const struct study *study, const fmpq_t a)
{
    struct track t;
    VECTOR(arb, closed, FLOW_STATE);
    SCOPE(acb, z, w);
    (void)study;
    sheet_value(acb_realref(z), steps->sheet, "Omega", PREC);
    const double amplitude = fmpq_get_d(a), Omega = arf_get_d(arb_midref(acb_realref(z)), ARF_RND_NEAR);
    bool proved = beside_closed_form(&t, steps, closed, a, (long)(1 / (amplitude * amplitude * Omega)), SLOW_DIGITS);
    pitch_of(z, track_row(&t, 0));
    pitch_of(w, closed);
    acb_div(z, z, w, PREC);
    acb_abs(d, z, PREC);
    arb_sub_ui(d, d, 1, PREC);
    arb_abs(d, d);
    acb_arg(d + 1, z, PREC);
    arb_abs(d + 1, d + 1);
    track_clear(&t);
    return proved;
}

/* ---- Hill's equations against the inverse square ----------------------- */

/* Both craft at rest, craft 1 where the row has it, craft 2 opposite by (4). */
static void place_pair(struct two_body *b, const struct track *t, const fmpq_t smallness)
{
    arb_set_fmpq(b->smallness, smallness, PREC);
    arb_set(b->c1, t->c1);
    arb_set(b->c2, t->c2);
    arb_div(b->mass + 1, t->arm, t->L_ref, PREC); /* arm = m2/(m1 + m2) L_ref */
    arb_sub_ui(b->mass, b->mass + 1, 1, PREC);
    arb_neg(b->mass, b->mass);
    _arb_vec_scalar_mul(b->place, track_row(t, 0) + PLACE_X, AXES, b->mass + 1, PREC);
    _arb_vec_scalar_mul(b->place + AXES, track_row(t, 0) + PLACE_X, AXES, b->mass, PREC);
    _arb_vec_neg(b->place + AXES, b->place + AXES, AXES);
}

/* Craft 1's place in arms, psi theta eta of the line of the craft, where a row has them. */
static void observe_pair(arb_ptr row, const struct two_body *b)
{
    VECTOR(arb, d, AXES);
    _arb_vec_scalar_div(row + PLACE_X, b->place, AXES, b->mass + 1, PREC);
    _arb_vec_sub(d, b->place, b->place + AXES, AXES, PREC);
    arb_dot(row + ETA, NULL, 0, d, 1, d, 1, AXES, PREC);
    arb_sqrt(row + ETA, row + ETA, PREC);
    arb_atan2(row + PSI, d + 1, d, PREC);
    arb_div(row + THETA, d + 2, row + ETA, PREC);
    arb_asin(row + THETA, row + THETA, PREC);
    arb_neg(row + THETA, row + THETA);
    arb_sub_ui(row + ETA, row + ETA, 1, PREC);
}

/* The parameter is L_ref/R_c. */
static bool from_inverse_square(arb_ptr d, const struct derivations *steps, const struct study *study, const fmpq_t smallness)
{
    const struct scene s = {.nonlinear = true, .m1 = study->m1, .m2 = study->m2};
    struct track start, hill;
    struct two_body b;
    SCOPE(arb, tau);
    two_body_init(&b);
    bool proved = track_run(&start, steps->sheet, &s, 0, 1, 0);
    place_pair(&b, &start, smallness);
    arb_mul_si(tau, start.Omega, study->seconds, PREC);
    two_body_move(&b, tau, PREC);
    observe_pair(track_row(&start, 0), &b);
    proved = track_run(&hill, steps->sheet, &s, study->seconds, 1, study->seconds) && proved;
    differences(d, study, &start, &hill);
    track_clear(&start);
    track_clear(&hill);
    two_body_clear(&b);
    return proved;
}

/* ---- the studies ------------------------------------------------------- */

const char *const variable_names[] = {"psi", "theta", "dL", "psi_dot",   "theta_dot", "dL_dot",
                                      "x1",  "y1",    "z1", "amplitude", "phase"};

#define TETHER {PSI, THETA, ETA, PSI_DOT, THETA_DOT, ETA_DOT}, 6
#define PAIR {PLACE_X, PLACE_Y, PLACE_Z, PSI, THETA, ETA}, 6
#define PITCH {AMPLITUDE, PHASE}, 2

/* After half a day and two days; the Runge-Kutta method where no error is near one of its zeros. */
const struct study studies[] = {
    {"linear_43200s", TETHER, {2, 2, 2, 2, 2, 2}, "1", 10, 5, from_linear, .seconds = 43200},
    {"linear_172800s", TETHER, {2, 2, 2, 2, 2, 2}, "1", 10, 5, from_linear, .seconds = 172800},
    {"linear_pitch_172800s", TETHER, {2, 3, 2, 2, 3, 2}, "1", 10, 4, from_linear, .seconds = 172800,
     .pitch_alone = true},
    {"rk4_linear_24000s", TETHER, {4, 4, 4, 4, 4, 4}, "320", 2, 7, from_steps, .seconds = 24000},
    {"rk4_nonlinear_24000s", TETHER, {4, 4, 4, 4, 4, 4}, "320", 2, 7, from_steps, .seconds = 24000,
     .nonlinear = true},
    {"hill_43200s", PAIR, {1, 1, 1, 2, 2, 2}, "0.001", 10, 3, from_inverse_square, .seconds = 43200,
     .measured = true},
    {"hill_unequal_43200s", PAIR, {1, 1, 1, 1, 1, 1}, "0.001", 10, 3, from_inverse_square, .seconds = 43200,
     .measured = true, .m1 = "100", .m2 = "200"},
    {"forced_43200s", TETHER, {4, 5, 4, 4, 5, 4}, "0.1", 10, 4, from_forced, .seconds = 43200},
    {"slow_law", PITCH, {2, 2}, "0.2", 2, 3, from_slow_law, .seconds = 0},
    {.name = NULL}};

const struct study *study_find(const char *name)
{
    const struct study *s = studies;
    while (s->name != NULL && strcmp(s->name, name) != 0)
        s++;
    return s->name != NULL ? s : NULL;
}

/* log(last/this)/log(ratio), and this/parameter^expected */
static void observe(struct convergence *c, int row, int variable)
{
    const struct study *s = c->study;
    const int at = row * VARIABLES + variable;
    SCOPE(arb, x);
    if (row > 0) {
        arb_div(c->orders + at, c->differences + at - VARIABLES, c->differences + at, PREC);
        arb_log_base_ui(c->orders + at, c->orders + at, (ulong)s->ratio, PREC);
    }
    arb_set_fmpq(x, c->parameters + row, PREC);
    arb_pow_ui(x, x, (ulong)s->order[variable], PREC);
    arb_div(c->constants + at, c->differences + at, x, PREC);
}

bool convergence_init(struct convergence *c, const struct derivations *steps, const struct study *s, int from)
{
    const slong size = (slong)s->rows * VARIABLES;
    bool found = true;
    SCOPE(fmpq, ratio);
    fmpq_set_si(ratio, s->ratio, 1);
    *c = (struct convergence){s, _fmpq_vec_init(s->rows), _arb_vec_init(size), _arb_vec_init(size),
                              _arb_vec_init(size)};
    literal_read(c->parameters, s->first, true);
    for (int row = 0; row < s->rows && found; row++) {
        if (row > 0)
            fmpq_div(c->parameters + row, c->parameters + row - 1, ratio);
        if (row < from)
            continue;
        found = s->differences(c->differences + row * VARIABLES, steps, s, c->parameters + row);
        for (int i = 0; i < s->count; i++)
            observe(c, row, i);
    }
    return found;
}

void convergence_clear(struct convergence *c)
{
    const slong size = (slong)c->study->rows * VARIABLES;
    _fmpq_vec_clear(c->parameters, c->study->rows);
    _arb_vec_clear(c->differences, size);
    _arb_vec_clear(c->orders, size);
    _arb_vec_clear(c->constants, size);
}

arb_srcptr convergence_order(const struct convergence *c, int variable)
{
    return c->orders + (c->study->rows - 1) * VARIABLES + variable;
}

arb_srcptr convergence_constant(const struct convergence *c, int variable)
{
    return c->constants + (c->study->rows - 1) * VARIABLES + variable;
}
