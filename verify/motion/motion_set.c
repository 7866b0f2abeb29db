/* Scenarios some of whose values have a radius: their Taylor models, and the rows of the set. */
#include <math.h>
#include <stdlib.h>

#include "motion/flow_set.h"
#include "motion/motion.h"
#include "text/decimal.h"
#include "text/scope.h"

enum { SET_BITS = 128 };

/* Omega and n enter by roots and as the unit of time. */
bool may_have_radius(enum scenario_name name)
{
    return name != SET_Omega && name != SET_n;
}

struct reader {
    const struct scenario *scenario;
    int known; /* unknowns that have been given out */
};

/* The value, all of it within its radius, in the unit; `middle` NULL for that of the scenario */
static void read_bounds(struct model *z, struct reader *r, enum scenario_name name, arb_srcptr middle, const arb_t unit)
{
    SCOPE(arb, x, radius);
    arb_set_fmpq(x, &r->scenario->value[name].value, SET_BITS);
    arb_div(x, middle != NULL ? middle : x, unit, SET_BITS);
    arb_set_fmpq(radius, r->scenario->radius + name, SET_BITS);
    arb_div(radius, radius, unit, SET_BITS);
    if (arb_is_zero(radius))
        model_set_ball(z, x);
    else
        model_set_variable(z, x, radius, r->known++);
}

enum { M1, M2, LENGTH, FACTOR, AT_PSI, AT_THETA, AT_DL, AT_PSI_DOT, AT_THETA_DOT, AT_DL_DOT, SINE_PSI, COSINE_PSI, SINE, COSINE, ARM, MASSES, UNIT, ANGLE_MODELS };

/*
 * (10) and its exact derivative: with e = (cos theta cos psi, cos theta sin psi, -sin theta) the place is arm L e, the velocity
 * arm L_dot e + arm L psi_dot de/dpsi + arm L theta_dot de/dtheta.
 */
static void place(struct model *state, struct model *m)
{
    static const struct {
        signed char sign;
        unsigned char by, times;
    } e[][FLOW_HALF] = {{{1, COSINE, COSINE_PSI}, {1, COSINE, SINE_PSI}, {-1, SINE, UNIT}},
                        {{-1, COSINE, SINE_PSI}, {1, COSINE, COSINE_PSI}, {0, UNIT, UNIT}},
                        {{-1, SINE, COSINE_PSI}, {-1, SINE, SINE_PSI}, {-1, COSINE, UNIT}}};
    static const int rate[] = {AT_DL_DOT, AT_PSI_DOT, AT_THETA_DOT};
    MODEL(product, state->space);
    for (int i = 0; i < 4; i++)
        model_sine(m + SINE_PSI + i, m + (i < 2 ? AT_PSI : AT_THETA), i % 2);
    model_product(m + AT_DL, m + AT_DL, m + ARM); /* arm L, by now */
    for (int d = 0; d < 3; d++)
        model_product(m + rate[d], m + rate[d], m + (d == 0 ? ARM : AT_DL));
    for (int d = 0; d < 3; d++)
        for (int i = 0; i < FLOW_HALF; i++) {
            model_dot(&product, false, e[d][i].sign, m + e[d][i].by, m + e[d][i].times, 1);
            if (d == 0)
                model_dot(state + i, false, 1, m + AT_DL, &product, 1);
            if (e[d][i].sign != 0)
                model_dot(state + FLOW_HALF + i, true, 1, m + rate[d], &product, 1); /* to 0 at first */
        }
}

/* By taylor.h Q is R/q m1 unit^3 Omega^2/(k_c arm^2), arm = m2/(m1 + m2): lambda = arm length, and `force` is k lambda^2. */
static void charge_model(struct model *charge, struct model *m, const struct model *force)
{
    model_product(charge, m + M1, m + LENGTH);
    model_product(charge, charge, m + LENGTH);
    model_product(m + M1, force, force);
    model_inverse_root(m + M2, m + M1);
    model_product(charge, charge, m + M2);
}

/* In units of r_ref of the middles, or near it, and radians of orbit */
static void models_of(struct flow_set *set, const struct scenario *s)
{
    MODELS(m, ANGLE_MODELS, &set->space);
    struct reader r = {s, 0};
    FLOW_PARAMETERS(p);
    SCOPE(arb, one, mass, speed, square);
    scenario_parameters(&p, s, SET_BITS);
    arb_one(one);
    arb_add(mass, p.m1, p.m2, SET_BITS);
    arb_set(set->Omega, p.Omega);
    arb_mul(set->unit, p.m2, p.L_ref, SET_BITS);
    arb_div(set->unit, set->unit, mass, SET_BITS);
    arb_get_mid_arb(set->unit, set->unit);
    arb_mul(speed, set->unit, p.Omega, SET_BITS);
    arb_sqr(square, p.Omega, SET_BITS);

    read_bounds(m + M1, &r, SET_m1, NULL, mass);
    read_bounds(m + M2, &r, SET_m2, NULL, mass);
    read_bounds(m + LENGTH, &r, SET_L_ref, NULL, set->unit);
    read_bounds(m + FACTOR, &r, SET_k_c, p.k_c, p.k_c);
    struct model *const c1 = set->model + FLOW_STATE, *const c2 = c1 + 1, *const lambda = c1 + 2, *const hold = c1 + 3;
    read_bounds(c1, &r, SET_C1, p.C1, square);
    read_bounds(c2, &r, SET_C2, p.C2, p.Omega);
    model_set(m + MASSES, m + M1); /* arm = m2/(m1 + m2) by the square of a root */
    model_set_ball(hold, one);
    model_dot(m + MASSES, true, 1, hold, m + M2, 1);
    model_inverse_root(m + ARM, m + MASSES);
    model_product(m + ARM, m + ARM, m + ARM);
    model_product(m + ARM, m + ARM, m + M2);
    model_product(lambda, m + ARM, m + LENGTH);
    model_product(m + FACTOR, m + FACTOR, lambda);
    model_product(m + FACTOR, m + FACTOR, lambda); /* k lambda^2, by now */
    model_product(c1, c1, m + FACTOR);
    model_product(c2, c2, m + FACTOR);
    model_product(hold, m + FACTOR, lambda);
    model_scale(hold, 3);

    if (s->given[SET_x1]) {
        for (int i = 0; i < FLOW_STATE; i++)
            read_bounds(set->model + i, &r, (enum scenario_name)(SET_x1 + i), NULL, i < FLOW_HALF ? set->unit : speed);
    } else {
        for (int i = 0; i < FLOW_STATE; i++)
            read_bounds(m + AT_PSI + i, &r, (enum scenario_name)(SET_psi + i), NULL,
                       i == 2 ? set->unit : i < 3 ? one : i == 5 ? speed : p.Omega);
        model_set_ball(m + UNIT, one);
        model_dot(m + AT_DL, true, 1, m + UNIT, m + LENGTH, 1); /* L */
        place(set->model, m);
    }
    charge_model(set->model + SET_CHARGE, m, m + FACTOR);
    arb_pow_ui(set->charge, set->unit, 3, SET_BITS);
    arb_mul(set->charge, set->charge, square, SET_BITS);
    arb_mul(set->charge, set->charge, mass, SET_BITS);
    arb_div(set->charge, set->charge, p.k_c, SET_BITS);
}

/* Whether the box is so wide, against the distance, that one degree more is worth its cost; of many unknowns that forbids more */
static bool is_wide(const struct scenario *s)
{
    static const enum scenario_name places[] = {SET_x1, SET_y1, SET_z1, SET_dL};
    double most = fmax(fmpq_get_d(s->radius + SET_psi), fmpq_get_d(s->radius + SET_theta));
    if (fmpq_sgn(s->radius + SET_C1) > 0)
        most = fmax(most, fmpq_get_d(s->radius + SET_C1) / fabs(fmpq_get_d(&s->value[SET_C1].value)));
    for (size_t i = 0; i < sizeof places / sizeof *places; i++)
        most = fmax(most, fmpq_get_d(s->radius + places[i]) / fmpq_get_d(&s->value[SET_L_ref].value));
    return most > 0.0015;
}

struct set_rows {
    row_receiver *receive;
    void *context;
    slong digits;
};

static int print_bounds(void *context, slong k, const fmpq_t t, arb_srcptr state)
{
    const struct set_rows *rows = context;
    char *numbers[SET_NUMBERS];
    VECTOR(arb, row, ROW_NUMBERS);
    _arb_vec_set(row, state, FLOW_STATE);
    arb_neg(row + FLOW_STATE, state + FLOW_STATE); /* (21) */
    arb_sqrtpos(row + FLOW_STATE, row + FLOW_STATE, SET_BITS); /* it is positive, though its ball may reach beyond 0 */
    arb_neg(row + FLOW_STATE + 1, row + FLOW_STATE);
    for (int i = 0; i < SET_NUMBERS; i++)
        numbers[i] = decimal_of_end(row + i / 2, rows->digits, i % 2);
    const int stopped = rows->receive(rows->context, k, t, numbers);
    for (int i = SET_NUMBERS - 1; i >= 0; i--)
        free(numbers[i]);
    return stopped;
}

enum flow_status motion_set_rows(const struct motion *m, const fmpq *times, slong count, row_receiver *receive, void *context,
                                 double *reached)
{
    const struct scenario *s = m->scenario;
    int unknowns = 0;
    for (int i = 0; i < SCENARIO_VALUES; i++)
        unknowns += !fmpq_is_zero(s->radius + i);
    struct set_rows rows = {receive, context, m->digits};
    OWNED(flow_set) set;
    flow_set_init(&set, unknowns, unknowns > 8 ? 3 : unknowns > 7 ? 5 : is_wide(s) ? 7 : 6);
    set.most_pieces = m->most_pieces;
    set.charged = true;
    models_of(&set, s);
    return flow_set(&set, times, count, print_bounds, &rows, reached);
}
