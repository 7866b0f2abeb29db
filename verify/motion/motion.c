#include "motion/motion.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "text/decimal.h"
#include "text/scope.h"

const char *const scenario_names[SCENARIO_VALUES] = {
    "m1",  "m2",    "L_ref", "k_c",     "Omega",     "n",      "C1", "C2", "psi", "theta",
    "dL", "psi_dot", "theta_dot", "dL_dot", "x1", "y1", "z1", "x1_dot", "y1_dot", "z1_dot"};

/* ---- scenario ---- */

void scenario_init(struct scenario *s, const struct sheet *sheet, bool exact)
{
    *s = (struct scenario){.sheet = sheet, .exact = exact};
    for (int i = 0; i < SCENARIO_VALUES; i++) {
        const char *value = quantity_find(sheet, scenario_names[i])->value;
        fmpq_init(&s->value[i].value);
        fmpq_init(s->radius + i);
        if (value != NULL)
            s->value[i].infinite = literal_read(&s->value[i].value, value, exact) == LITERAL_INFINITE;
    }
}

void scenario_clear(struct scenario *s)
{
    for (int i = 0; i < SCENARIO_VALUES; i++) {
        fmpq_clear(&s->value[i].value);
        fmpq_clear(s->radius + i);
    }
}

static bool cartesian(const struct scenario *s)
{
    return s->given[SET_x1];
}

/* Whether no two craft meet: some coordinate never vanishes, or the length is positive. */
static bool is_apart(const struct scenario *s)
{
    SCOPE(fmpq, x, y);
    bool apart = false;
    for (int i = SET_x1; i <= SET_z1; i++) {
        fmpq_abs(x, &s->value[i].value);
        apart = apart || fmpq_cmp(x, s->radius + i) > 0;
    }
    if (cartesian(s))
        return apart;
    fmpq_add(x, &s->value[SET_L_ref].value, &s->value[SET_dL].value);
    fmpq_add(y, s->radius + SET_L_ref, s->radius + SET_dL);
    return fmpq_cmp(x, y) > 0;
}

bool scenario_valid(const struct scenario *s, bool nonlinear, struct message *why)
{
    const char *where = "";
    for (int i = 0; i < SCENARIO_VALUES; i++)
        if (!fmpq_is_zero(s->radius + i))
            where = ", in all of the box";
    for (int i = SET_m1; i <= SET_Omega; i++)
        if (fmpq_cmp(&s->value[i].value, s->radius + i) <= 0) {
            message_set(why, "%s: expected a number > 0%s", scenario_names[i], where);
            return false;
        }
    if (!s->given[SET_C1] && !s->given[SET_C2] && fmpq_cmp_si(&s->value[SET_n].value, 9) < 0) {
        message_set(why, "n: expected a number >= 9, Eq. (44)");
        return false;
    }
    if (!nonlinear || is_apart(s))
        return true;
    message_set(why, "%s: expected the two craft apart, L > 0%s", cartesian(s) ? "x1 y1 z1" : "dL", where);
    return false;
}

/* ---- parameters and initial states, derived without rounding ---- */

void scenario_parameters(struct flow_parameters *p, const struct scenario *s, slong prec)
{
    static const enum scenario_name names[] = {SET_Omega, SET_k_c, SET_m1, SET_m2, SET_L_ref, SET_C1, SET_C2};
    VECTOR(arb, gain_inputs, 2); /* of Eqs. (43) and (44): Omega, n */
    for (size_t i = 0; i < sizeof names / sizeof *names; i++)
        arb_set_fmpq(p->Omega + i, &s->value[names[i]].value, prec);
    arb_set(gain_inputs, p->Omega);
    arb_set_fmpq(gain_inputs + 1, &s->value[SET_n].value, prec);
    if (!s->given[SET_C1])
        section_enclose(section_find(s->sheet, "eq43"), gain_inputs, prec, p->C1);
    if (!s->given[SET_C2])
        section_enclose(section_find(s->sheet, "eq44"), gain_inputs, prec, p->C2);
}

enum { ANGLE_INPUTS = 8 }; /* m1 m2 L psi theta, and L_dot psi_dot theta_dot */

static void inputs_of_angles(arb_ptr inputs, arb_srcptr state, const struct flow_parameters *p, slong prec)
{
    arb_srcptr given[ANGLE_INPUTS] = {p->m1, p->m2, p->L_ref, state, state + 1, state + 5, state + 3, state + 4};
    for (int i = 0; i < ANGLE_INPUTS; i++)
        arb_set(inputs + i, given[i]);
    arb_add(inputs + 2, inputs + 2, state + 2, prec);
}

void state_from_angles(arb_ptr state, const struct sheet *sheet, const struct flow_parameters *p, slong prec)
{
    VECTOR(arb, inputs, ANGLE_INPUTS);
    inputs_of_angles(inputs, state, p, prec);
    section_enclose(section_find(sheet, "eq10"), inputs, prec, state);
    section_enclose(section_find(sheet, "eq11exact"), inputs, prec, state + 3);
}

void scenario_initial(arb_ptr initial, const struct scenario *s, const struct flow_parameters *p, bool nonlinear, slong prec)
{
    const bool angles = !cartesian(s); /* of a linear motion always */
    for (int i = 0; i < FLOW_STATE; i++)
        arb_set_fmpq(initial + i, &s->value[(angles ? SET_psi : SET_x1) + i].value, prec);
    if (nonlinear && angles)
        state_from_angles(initial, s->sheet, p, prec);
}

/* ---- charges along a motion: Eqs. (13), (7), (18), (21) ---- */

void charges_of_state(arb_ptr q, arb_t product, const struct sheet *sheet, const struct flow_parameters *p, arb_srcptr state,
                      slong prec)
{
    /* Eq. (14), of Omega k_c m1 m2 Q and the state, names the distance and its rate on its way. */
    const struct program *program = &section_find(sheet, "eq14")->corrected.program;
    OWNED(machine) m;
    VECTOR(arb, in, 8);
    VECTOR(arb, Q, 2);
    machine_init(&m, program, &arithmetic_ball, prec);
    for (int i = 0; i < 4; i++)
        arb_set(machine_value(&m, i), p->Omega + i);
    for (int i = 0; i < FLOW_STATE; i++)
        arb_set(machine_value(&m, 5 + i), state + i);
    machine_run(&m);
    section_enclose(section_find(sheet, "eq07"), p->Omega, prec, Q); /* Omega k_c m1 m2 L_ref */
    _arb_vec_set(in, p->k_c, 6);                                     /* k_c m1 m2 L_ref C1 C2, dL and dL_dot */
    arb_sub(in + 6, machine_value(&m, program_find(program, "L")), p->L_ref, prec);
    arb_set(in + 7, machine_value(&m, program_find(program, "L_dot")));
    section_enclose(section_find(sheet, "eq18"), in, prec, Q + 1);
    arb_add(product, Q, Q + 1, prec);
    section_enclose(section_find(sheet, "eq21"), Q, prec, q);
}

/* ---- rows ---- */

struct pass {
    const struct motion *motion;
    struct flow_parameters parameters;
    arb_ptr initial;
    slong prec, most; /* working precision, and where trying ends */
    slong done;       /* rows that the receiver has               */
    bool is_static, undecided;
    bool outside;     /* Q_ref + dQ >= 0 at the row after those      */
    double reached;
    row_receiver *receive; /* NULL: nobody is told, it is only asked how far the charges go */
    void *context;
};

static int row_balls(struct pass *p, arb_srcptr state, arb_ptr row)
{
    const struct motion *m = p->motion;
    _arb_vec_set(row, state, FLOW_STATE);
    if (m->nonlinear && p->is_static)
        _arb_vec_set(row, p->initial, FLOW_STATE);
    if (m->charges) {
        SCOPE(arb, product);
        charges_of_state(row + FLOW_STATE, product, m->scenario->sheet, &p->parameters, row, p->prec);
        p->outside = arb_is_nonnegative(product);
        for (int i = FLOW_STATE; i < ROW_NUMBERS && m->microcoulomb; i++)
            arb_mul_ui(row + i, row + i, 1000000, p->prec);
        return ROW_NUMBERS;
    }
    if (m->small_angles) {
        VECTOR(arb, in, ANGLE_INPUTS);
        inputs_of_angles(in, state, &p->parameters, p->prec);
        section_enclose(section_find(m->scenario->sheet, "eq10lin"), in, p->prec, row);
        return 3;
    }
    return FLOW_STATE;
}

static int receive_row(void *context, slong k, const fmpq_t t, arb_srcptr state)
{
    struct pass *p = context;
    if (k < p->done)
        return 0;
    char *numbers[ROW_NUMBERS] = {NULL};
    VECTOR(arb, row, ROW_NUMBERS);
    int count = row_balls(p, state, row);
    for (int i = 0; i < count && !p->outside; i++) {
        numbers[i] = decimal_of_ball(row + i, p->motion->digits);
        p->undecided |= numbers[i] == NULL;
    }
    bool over = p->outside || p->undecided;
    if (!over) {
        over = p->receive != NULL && p->receive(p->context, k, t, numbers) != 0;
        p->done++;
    }
    for (int i = 0; i < count; i++)
        free(numbers[i]);
    return over;
}

bool is_static(const fmpq_t m1, const fmpq_t m2, const fmpq_t L_ref, const struct input *state)
{
    SCOPE(fmpq, a, b);
    fmpq_add(a, m1, m2);
    fmpq_mul(a, a, &state[0].value);
    fmpq_abs(a, a);
    fmpq_mul(b, m2, L_ref);
    bool rests = fmpq_equal(a, b);
    for (int i = 1; i < FLOW_STATE; i++)
        rests = rests && fmpq_is_zero(&state[i].value);
    return rests;
}

static bool starts_static(const struct scenario *s)
{
    bool rests = true;
    for (int i = SET_psi; i <= SET_dL_dot; i++)
        rests = rests && fmpq_is_zero(&s->value[i].value);
    return cartesian(s) ? is_static(&s->value[SET_m1].value, &s->value[SET_m2].value, &s->value[SET_L_ref].value, &s->value[SET_x1]) : rests;
}

/* Passes at rising precision until every row is proved, or nothing more can be. */
static enum flow_status run_pass(struct pass *p, const fmpq *times, slong count)
{
    const struct motion *m = p->motion;
    const double Omega = fmpq_get_d(&m->scenario->value[SET_Omega].value);
    const double radians = fabs(Omega * fmpq_get_d(times + count - 1));
    enum flow_status status;
    flow_parameters_init(&p->parameters);
    p->initial = _arb_vec_init(FLOW_STATE);
    p->prec = m->h ? rk4_precision(m->digits, radians) : flow_precision(m->digits, radians);
    p->most = 8 * p->prec; /* three tries at twice the bits: more than rounding ever needs */
    do {
        scenario_parameters(&p->parameters, m->scenario, p->prec);
        scenario_initial(p->initial, m->scenario, &p->parameters, m->nonlinear, p->prec);
        p->undecided = false;
        struct flow_request r = {&p->parameters, p->initial, times, count, m->digits, p->prec, receive_row, p, m->nonlinear, m->h, NULL, 0};
        status = flow_run(&r);
        p->reached = r.reached;
        p->prec *= 2;
    } while ((p->undecided || status == FLOW_WIDE) && p->prec <= p->most);
    flow_parameters_clear(&p->parameters);
    _arb_vec_clear(p->initial, FLOW_STATE);
    return status;
}

/*
 * When Q_ref + dQ stops being negative: it is so at `before` and not at `after`, and six times over the
 * interval between such times is cut into tenths. A method has of the times in between those that are its steps.
 */
static void say_crossing(const struct pass *found, const fmpq *given, struct message *why)
{
    struct motion m = *found->motion;
    SCOPE(fmpq, before, after, tenth);
    VECTOR(fmpq, times, 11);
    fmpq_set(after, given + found->done);
    if (found->done == 0) {
        message_set(why, "Q_ref + dQ >= 0 at t = %.9g s: Eq. (21) has no charges there", fmpq_get_d(after));
        return;
    }
    fmpq_set(before, given + found->done - 1);
    m.digits = 9; /* a millionth of a step and some to spare */
    for (int cut = 0; cut < 6; cut++) {
        struct pass p = {.motion = &m, .is_static = found->is_static};
        fmpq_sub(tenth, after, before);
        fmpq_div_fmpz(tenth, tenth, (fmpz[]){10});
        fmpq_set(times, before);
        for (int i = 1; i <= 10; i++)
            fmpq_add(times + i, times + i - 1, tenth);
        run_pass(&p, times, 11);
        if (!p.outside || p.done == 0)
            break;
        fmpq_set(before, times + p.done - 1);
        fmpq_set(after, times + p.done);
    }
    message_set(why, "Q_ref + dQ >= 0 from t = %.9g s, proved < 0 at t = %.9g s: Eq. (21) has no charges there",
                fmpq_get_d(after), fmpq_get_d(before));
}

int motion_rows(const struct motion *m, const fmpq *times, slong count, row_receiver *receive,
                void *context, struct message *why)
{
    struct pass p = {.motion = m, .is_static = starts_static(m->scenario), .receive = receive, .context = context};
    const enum flow_status status = m->most_pieces > 0 ? motion_set_rows(m, times, count, receive, context, &p.reached)
                                                       : run_pass(&p, times, count);
    if (p.outside)
        say_crossing(&p, times, why);
    else if (p.undecided)
        message_set(why, "%ld bits do not decide every digit of row %ld", (long)p.most, (long)p.done + 1);
    else if (status == FLOW_DONE || status == FLOW_STOPPED)
        return 0;
    else
        message_set(why, "%s, last proved time %.9g s", flow_status_text(status), p.reached);
    return -1;
}
