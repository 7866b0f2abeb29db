#include "claims/convergence.h"

#include <stdlib.h>
#include <string.h>

#include "claims/claim.h"
#include "motion/two_body.h"
#include "text/scope.h"

enum { PREC = 192, SLOW_DIGITS = 5 }; /* what the slow law leaves is of the order of a^2, a >= 1/20 */

/* ---- motions ----------------------------------------------------------- */

/* The largest |a - b| of the study's variables on the samples, in SI; of an amplitude, as a part of the first. */
static void differences(arb_ptr d, const struct study *study, const struct trajectory *a, const struct trajectory *b)
{
    SCOPE(arb, whole);
    for (int i = 0; i < study->count; i++) {
        trajectory_peak(d + i, a, b, study->which[i], 0, a->count - 1);
        arb_mul(d + i, d + i, a->unit + study->which[i], PREC);
        if (study->which[i] == AMPLITUDE) {
            trajectory_value(whole, b, 0, AMPLITUDE);
            arb_div(d + i, d + i, whole, PREC);
        }
    }
}

static bool compare_motions(arb_ptr d, const struct study *study, const struct simulation *one, const struct simulation *other, long seconds)
{
    const long first = study->every > 0 ? 0 : seconds, step = study->every > 0 ? study->every : 1;
    struct trajectory a, b;
    bool proved = trajectory_run(&a, one, first, step, seconds);
    proved = trajectory_run(&b, other, first, step, seconds) && proved;
    differences(d, study, &a, &b);
    trajectory_clear(&a);
    trajectory_clear(&b);
    return proved;
}

/* The nonlinear motion against the linear; the parameter scales the initial disturbance. */
static bool from_linear(arb_ptr d, const struct derivations *steps, const struct study *study, const fmpq_t scale)
{
    const char *others = study->pitch_alone ? "0" : NULL;
    struct simulation linear = {.steps = steps, .scale = scale, .psi = others, .dL = others}, nonlinear = linear;
    nonlinear.nonlinear = true;
    return compare_motions(d, study, &nonlinear, &linear, study->seconds);
}

/* The classical Runge-Kutta method against the motion; the parameter is its step in s. */
static bool from_steps(arb_ptr d, const struct derivations *steps, const struct study *study, const fmpq_t h)
{
    struct simulation exact = {.steps = steps, .nonlinear = study->nonlinear}, stepped = exact;
    stepped.rk4 = (long)fmpq_get_d(h);
    return compare_motions(d, study, &stepped, &exact, study->seconds);
}

/*
 * The motion against the closed form that it starts on, with a pitch of a rad, after a fixed time, or after 1/a^2 radians, to the
 * second; the parameter is a.
 */
static bool from_forced(arb_ptr d, const struct derivations *steps, const struct study *study, const fmpq_t a)
{
    const bool slow = study->seconds == 0;
    struct simulation motion = {.steps = steps, .nonlinear = true, .forced = true, .n = study->n, .theta = "1", .scale = a,
                                .digits = slow ? SLOW_DIGITS : TRAJECTORY_DIGITS};
    struct simulation closed = motion;
    SCOPE(arb, Omega);
    closed.closed_form = true;
    sheet_value(Omega, steps->sheet, "Omega", PREC);
    const double size = fmpq_get_d(a), rate = size * size * arf_get_d(arb_midref(Omega), ARF_RND_NEAR);
    return compare_motions(d, study, &motion, &closed, slow ? (long)(1 / rate) : study->seconds);
}

/* ---- Hill's equations against the inverse square ----------------------- */

/* Both craft at rest, craft 1 where the sample has it, craft 2 opposite by (4). */
static void place_pair(struct two_body *b, const struct trajectory *t, const fmpq_t smallness)
{
    arb_set_fmpq(b->smallness, smallness, PREC);
    arb_set(b->c1, t->c1);
    arb_set(b->c2, t->c2);
    arb_div(b->mass + 1, t->unit + PLACE_X, t->unit + ETA, PREC); /* m2/(m1 + m2) L_ref, L_ref */
    arb_sub_ui(b->mass, b->mass + 1, 1, PREC);
    arb_neg(b->mass, b->mass);
    _arb_vec_scalar_mul(b->place, trajectory_sample(t, 0) + PLACE_X, AXES, b->mass + 1, PREC);
    _arb_vec_scalar_mul(b->place + AXES, trajectory_sample(t, 0) + PLACE_X, AXES, b->mass, PREC);
    _arb_vec_neg(b->place + AXES, b->place + AXES, AXES);
}

/* Craft 1's place in arms, psi theta eta of the line of the craft, where a sample has them. */
static void observe_pair(arb_ptr sample, const struct two_body *b)
{
    VECTOR(arb, d, AXES);
    _arb_vec_scalar_div(sample + PLACE_X, b->place, AXES, b->mass + 1, PREC);
    _arb_vec_sub(d, b->place, b->place + AXES, AXES, PREC);
    angle_series(sample + PSI, d, 1, PREC);
}

/* The parameter is L_ref/R_c. */
static bool from_inverse_square(arb_ptr d, const struct derivations *steps, const struct study *study, const fmpq_t smallness)
{
    const struct simulation s = {.steps = steps, .nonlinear = true, .m1 = study->m1, .m2 = study->m2};
    struct trajectory start, hill;
    struct two_body b;
    SCOPE(arb, tau);
    two_body_init(&b);
    bool proved = trajectory_run(&start, &s, 0, 1, 0);
    place_pair(&b, &start, smallness);
    arb_mul_si(tau, start.Omega, study->seconds, PREC);
    proved = two_body_move(&b, tau, PREC) && proved;
    observe_pair(trajectory_sample(&start, 0), &b);
    proved = trajectory_run(&hill, &s, study->seconds, 1, study->seconds) && proved;
    differences(d, study, &start, &hill);
    trajectory_clear(&start);
    trajectory_clear(&hill);
    two_body_clear(&b);
    return proved;
}

/* ---- the studies ------------------------------------------------------- */

#define OF_TETHER {PSI, THETA, ETA, PSI_DOT, THETA_DOT, ETA_DOT}, 6
#define OF_PAIR {PLACE_X, PLACE_Y, PLACE_Z, PSI, THETA, ETA}, 6
#define OF_ANGLES {PSI, THETA, ETA}, 3
#define OF_PITCH {AMPLITUDE, PHASE}, 2

/* After half a day and two days; the Runge-Kutta method where no error is near one of its zeros. */
const struct study studies[] = {
    {"linear_43200s", OF_TETHER, {2, 2, 2, 2, 2, 2}, 1, 1, 10, 5, from_linear, .seconds = DAY / 2},
    {"linear_172800s", OF_TETHER, {2, 2, 2, 2, 2, 2}, 1, 1, 10, 5, from_linear, .seconds = 2 * DAY},
    {"linear_pitch_172800s", OF_TETHER, {2, 3, 2, 2, 3, 2}, 1, 1, 10, 4, from_linear, .seconds = 2 * DAY, .pitch_alone = true},
    {"rk4_linear_24000s", OF_TETHER, {4, 4, 4, 4, 4, 4}, 320, 1, 2, 7, from_steps, .seconds = 24000},
    {"rk4_nonlinear_24000s", OF_TETHER, {4, 4, 4, 4, 4, 4}, 320, 1, 2, 7, from_steps, .seconds = 24000, .nonlinear = true},
    {"hill_43200s", OF_PAIR, {1, 1, 1, 2, 2, 2}, 1, 1000, 10, 3, from_inverse_square, .seconds = DAY / 2},
    {"hill_unequal_43200s", OF_PAIR, {1, 1, 1, 1, 1, 1}, 1, 1000, 10, 3, from_inverse_square, .seconds = DAY / 2,
     .m1 = "100", .m2 = "200"},
    {"forced_43200s", OF_TETHER, {4, 5, 4, 4, 5, 4}, 1, 10, 10, 4, from_forced, .seconds = DAY / 2},
    {"slow_law", OF_PITCH, {2, 2}, 1, 5, 2, 3, from_forced, .n = NULL},
    /* of the claims: the largest errors of a day, small disturbances, three days, the sheet's orbit (L_ref = 10 m, R_c in m) */
    {"rk4_linear_day", OF_ANGLES, {4, 4, 4}, 400, 1, 2, 4, from_steps, .seconds = DAY, .every = 400, .of_claims = true},
    {"rk4_nonlinear_day", OF_ANGLES, {4, 4, 4}, 400, 1, 2, 4, from_steps, .seconds = DAY, .every = 400, .nonlinear = true, .of_claims = true},
    {"linear_day", {PSI, THETA, ETA, PLACE_X, PLACE_Y, PLACE_Z}, 6, {2, 2, 2, 2, 2, 2}, 1, 1000, 10, 2, from_linear, .seconds = DAY,
     .of_claims = true},
    {"forced_10_259200s", OF_ANGLES, {4, 5, 4}, 1, 100, 10, 3, from_forced, .seconds = 3 * DAY, .of_claims = true},
    {"forced_12_259200s", OF_ANGLES, {4, 5, 4}, 1, 100, 10, 3, from_forced, .seconds = 3 * DAY, .of_claims = true, .n = "12"},
    {"hill_in_orbit", OF_PAIR, {1, 1, 1, 2, 2, 2}, 10, 42164000, 10, 1, from_inverse_square, .seconds = DAY / 2,
     .of_claims = true},
    {"hill_unequal_in_orbit", OF_PAIR, {1, 1, 1, 1, 1, 1}, 10, 42164000, 10, 1, from_inverse_square, .seconds = DAY / 2,
     .of_claims = true, .m1 = "100", .m2 = "200"},
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
    const int at = row * STUDIED + variable;
    SCOPE(arb, x);
    if (row > 0) {
        arb_div(c->orders + at, c->differences + at - STUDIED, c->differences + at, PREC);
        arb_log_base_ui(c->orders + at, c->orders + at, (ulong)s->ratio, PREC);
    }
    arb_set_fmpq(x, c->parameters + row, PREC);
    arb_pow_ui(x, x, (ulong)s->order[variable], PREC);
    arb_div(c->constants + at, c->differences + at, x, PREC);
}

bool convergence_init(struct convergence *c, const struct derivations *steps, const struct study *s, int from)
{
    const slong size = (slong)s->rows * STUDIED;
    bool found = true;
    *c = (struct convergence){s, _fmpq_vec_init(s->rows), _arb_vec_init(size), _arb_vec_init(size), _arb_vec_init(size)};
    fmpq_set_si(c->parameters, s->first, (ulong)s->over);
    for (int row = 0; row < s->rows && found; row++) {
        if (row > 0)
            fmpq_div_fmpz(c->parameters + row, c->parameters + row - 1, (fmpz[]){s->ratio});
        if (row < from)
            continue;
        found = s->differences(c->differences + row * STUDIED, steps, s, c->parameters + row);
        for (int i = 0; i < s->count; i++)
            observe(c, row, i);
    }
    return found;
}

void convergence_clear(struct convergence *c)
{
    const slong size = (slong)c->study->rows * STUDIED;
    _fmpq_vec_clear(c->parameters, c->study->rows);
    _arb_vec_clear(c->differences, size);
    _arb_vec_clear(c->orders, size);
    _arb_vec_clear(c->constants, size);
}

/* ---- as a computation ----------------------------------------------------- */

/*
 * Of a study: orders and constants of its last row, p_VARIABLE, c_VARIABLE, and `worst`, the most that an order is off; a study of
 * claims is computed whole, and has the differences of its first row (in SI), d_VARIABLE_0.
 */
void run_study(struct computed *c)
{
    const struct study *s = c->of.of;
    const int last = s->rows - 1, from = s->of_claims ? 0 : last - 1;
    struct convergence study;
    SCOPE(arb, worst, off);
    const bool found = convergence_init(&study, c->steps, s, from);
    for (int i = 0; i < s->count; i++) {
        const char *variable = variable_names[s->which[i]];
        for (int row = from + 1; row < s->rows; row++) {
            arb_sub_si(off, study.orders + row * STUDIED + i, s->order[i], PREC);
            arb_abs(off, off);
            arb_max(worst, worst, off, PREC);
        }
        give(c, found && s->of_claims, study.differences + i, "d_%s_0", variable);
        give(c, found, study.orders + last * STUDIED + i, "p_%s", variable);
        give(c, found, study.constants + last * STUDIED + i, "c_%s", variable);
    }
    give(c, found, worst, "worst");
    convergence_clear(&study);
}
