#include "claims/sampling.h"

#include "claims/curve.h"
#include "text/scope.h"

void set_gains(arb_t c1, arb_t c2, const char *n, const char *c2_over_Omega, slong prec)
{
    arb_set_str(c1, n, prec);
    arb_sub_ui(c2, c1, 9, prec);
    arb_sqrt(c2, c2, prec);
    arb_mul_2exp_si(c2, c2, 1);
    if (c2_over_Omega != NULL)
        arb_set_str(c2, c2_over_Omega, prec);
}

/* ---- the law held ---- */

/* The polynomial of v, over (1 - T v/2)^4 and positive factors: see sampling.h. S = sinh(a h)/h, R = sin(b h)/h, h = T/2. */
static const char *const hold_inputs[] = {"h", "S", "C", "R", "D", "c1", "c2"};
static const char *const hold_lines[][2] = {
    {"a", "sqrt(2*sqrt(7) + 1)"},
    {"b", "sqrt(2*sqrt(7) - 1)"},
    {"A", "(a^2 + 3)/(a^2*(a^2 + b^2))"}, /* of the step response -1/9 + A cosh(a t) + B cos(b t) of the length */
    {"B", "(3 - b^2)/(b^2*(a^2 + b^2))"},
    {"A_1", "A*C*(c1*C - c2*a*h*S)"},
    {"A_0", "A*S*(c2*a*C - c1*h*S)"},
    {"B_1", "B*D*(c1*D + c2*b*h*R)"},
    {"B_0", "-B*R*(c2*b*D - c1*h*R)"},
    {"r_4", "(1 - c1/9)*C^2*D^2 + A_1*D^2 + B_1*C^2"},
    {"r_3", "A_0*D^2 + B_0*C^2"},
    {"r_2", "(1 - c1/9)*(C^2*R^2 - S^2*D^2) + A_1*R^2 - B_1*S^2"},
    {"r_1", "A_0*R^2 - B_0*S^2"},
    {"r_0", "(c1/9 - 1)*S^2*R^2"},
    {"met", "r_4*(r_1*r_2*r_3 - r_0*r_3^2 - r_4*r_1^2)"},
};
enum { HOLD_INPUTS = sizeof hold_inputs / sizeof *hold_inputs, HOLD_LINES = sizeof hold_lines / sizeof *hold_lines };

/* The derivatives of the first inputs by h. */
static const char *const hold_rates[] = {"1", "(a*C - S)/h", "a*h*S", "(b*D - R)/h", "-b*h*R"};
enum { HOLD_MOVING = sizeof hold_rates / sizeof *hold_rates };

struct held_law {
    struct program program;
    struct machine machine;
    int met, slope;
};

static void held_law_init(struct held_law *l, const arb_t c1, const arb_t c2, slong prec)
{
    int rate[HOLD_INPUTS] = {-1, -1, -1, -1, -1, -1, -1}, node = 0;
    struct message why;
    size_t where;
    program_init(&l->program);
    for (int i = 0; i < HOLD_INPUTS; i++)
        program_input(&l->program, hold_inputs[i]);
    for (int i = 0; i < HOLD_LINES; i++) {
        node = program_parse(&l->program, hold_lines[i][1], &where, &why);
        program_name(&l->program, node, hold_lines[i][0]);
    }
    l->met = node;
    for (int i = 0; i < HOLD_MOVING; i++)
        rate[i] = program_parse(&l->program, hold_rates[i], &where, &why);
    l->slope = program_derivative(&l->program, l->met, rate, HOLD_INPUTS);
    machine_init(&l->machine, &l->program, &arithmetic_ball, prec);
    arb_set(machine_value(&l->machine, HOLD_INPUTS - 2), c1);
    arb_set(machine_value(&l->machine, HOLD_INPUTS - 1), c2);
}

static void held_law_clear(struct held_law *l)
{
    machine_clear(&l->machine);
    program_clear(&l->program);
}

static arb_srcptr held_law_at(struct held_law *l, const arb_t T, int node, slong prec)
{
    arb_ptr value[HOLD_MOVING];
    SCOPE(acb, angle, z);
    for (int i = 0; i < HOLD_MOVING; i++)
        value[i] = machine_value(&l->machine, i);
    arb_mul_2exp_si(value[0], T, -1);
    for (int i = 0; i < 2; i++) { /* i a h, and b h */
        const int frequency = program_find(&l->program, hold_lines[i][0]);
        machine_run_to(&l->machine, frequency);
        acb_zero(angle);
        arb_mul(i == 0 ? acb_imagref(angle) : acb_realref(angle), value[0], machine_value(&l->machine, frequency), prec);
        acb_sinc(z, angle, prec);
        arb_mul(value[2 * i + 1], acb_realref(z), machine_value(&l->machine, frequency), prec);
        acb_cos(z, angle, prec);
        arb_set(value[2 * i + 2], acb_realref(z));
    }
    machine_run_to(&l->machine, node);
    return machine_value(&l->machine, node);
}

/* For arb_calc: the value, by itself and by the mean value theorem, where there is a derivative; and the derivative. */
static int circle_met(arb_ptr out, const arb_t T, void *law, slong order, slong prec)
{
    struct held_law *l = law;
    SCOPE(arb, middle, slope, away);
    arb_set(out, held_law_at(l, T, l->met, prec));
    arb_mul_2exp_si(slope, held_law_at(l, T, l->slope, prec), -1);
    if (order > 1)
        arb_set(out + 1, slope);
    if (arb_is_finite(slope)) {
        arb_get_mid_arb(middle, T);
        arb_sub(away, T, middle, prec);
        arb_mul(slope, slope, away, prec);
        arb_add(slope, slope, held_law_at(l, middle, l->met, prec), prec);
        arb_intersection(out, out, slope, prec);
    }
    return 0;
}

void largest_hold(arb_t limit, const arb_t c1, const arb_t c2, slong prec)
{
    enum { DEEPEST = 60, EVALUATIONS = 2000, LONGEST = 3 }; /* below 2 pi/b, where z = 1 is met */
    struct held_law law;
    arf_interval_t all;
    arf_interval_ptr blocks;
    int *flags;
    held_law_init(&law, c1, c2, prec);
    arf_interval_init(all);
    arf_set_si(&all->b, LONGEST);
    const slong found = arb_calc_isolate_roots(&blocks, &flags, circle_met, &law, all, DEEPEST, EVALUATIONS, 1, prec);
    arb_indeterminate(limit);
    if (found > 0 && flags[0] == 1) {
        arf_interval_get_arb(limit, blocks, prec);
        narrow_root(limit, circle_met, &law, prec);
    }
    _arf_interval_vec_clear(blocks, found);
    flint_free(flags);
    arf_interval_clear(all);
    held_law_clear(&law);
}

/* ---- the law late ---- */

void largest_delay(arb_t limit, const arb_t c1, const arb_t c2, slong prec)
{
    /* of x^k, times 1, c1^2 and c2^2 */
    enum { CROSSINGS = 4 };
    static const slong coefficients[CROSSINGS + 1][3] = {{729, -9, 0}, {-108, 6, -9}, {-50, -1, 6}, {4, 0, -1}, {1, 0, 0}};
    SCOPE(acb_poly, p);
    VECTOR(acb, roots, CROSSINGS);
    VECTOR(arb, squares, 2);
    SCOPE(acb, a);
    SCOPE(arb, w);
    arb_sqr(squares, c1, prec);
    arb_sqr(squares + 1, c2, prec);
    for (int k = CROSSINGS; k >= 0; k--) {
        arb_set_si(acb_realref(a), coefficients[k][0]);
        for (int j = 0; j < 2; j++)
            arb_addmul_si(acb_realref(a), squares + j, coefficients[k][j + 1], prec);
        acb_poly_set_coeff_acb(p, k, a);
    }
    const slong isolated = acb_poly_find_roots(roots, p, NULL, 0, prec);
    for (int k = 0; k < CROSSINGS; k++)
        arb_max(w, w, acb_realref(roots + k), prec);
    arb_sqrt(w, w, prec);
    arb_mul(limit, c2, w, prec);
    arb_atan2(limit, limit, c1, prec);
    arb_div(limit, limit, w, prec);
    if (isolated < CROSSINGS)
        arb_indeterminate(limit);
}

/* ---- the nonlinear motion, the law held ---- */

void unit_parameters(struct flow_parameters *p, const arb_t c1, const arb_t c2)
{
    flow_parameters_init(p);
    arb_one(p->Omega);
    arb_one(p->k_c);
    arb_one(p->m1);
    arb_one(p->m2);
    arb_set_ui(p->L_ref, 2);
    arb_set(p->C1, c1);
    arb_set(p->C2, c2);
}

void commanded(arb_t eta, arb_t rate, arb_t charge, arb_srcptr state, const arb_t c1, const arb_t c2, slong prec)
{
    SCOPE(arb, r);
    arb_dot(r, NULL, 0, state, 1, state, 1, FLOW_HALF, prec);
    arb_sqrt(r, r, prec);
    arb_sub_ui(eta, r, 1, prec);
    arb_dot(rate, NULL, 0, state, 1, state + FLOW_HALF, 1, FLOW_HALF, prec);
    arb_div(rate, rate, r, prec);
    arb_mul(charge, c1, eta, prec);
    arb_addmul(charge, c2, rate, prec);
    arb_div_ui(charge, charge, 3, prec);
}

static int take_held(void *context, slong k, const fmpq_t t, arb_srcptr state)
{
    (void)k;
    (void)t;
    _arb_vec_set(context, state, FLOW_STATE);
    return 0;
}

enum flow_status hold_follow(arb_ptr states, arb_srcptr start, const arb_t c1, const arb_t c2, const fmpq_t T, slong count,
                             slong digits, slong prec)
{
    struct flow_parameters p;
    enum flow_status status = FLOW_DONE;
    SCOPE(arb, eta, rate, charge);
    unit_parameters(&p, eta, eta); /* no feedback between samples */
    for (slong k = 0; k < count && status == FLOW_DONE; k++) {
        arb_srcptr state = k == 0 ? start : states + FLOW_STATE * (k - 1);
        commanded(eta, rate, charge, state, c1, c2, prec);
        arb_add_ui(charge, charge, 1, prec);
        arb_root_ui(charge, charge, 3, prec); /* (7): Q goes like the cube of the length that it holds */
        arb_mul_2exp_si(p.L_ref, charge, 1);
        status = flow_run(&(struct flow_request){&p, state, T, 1, digits, prec, take_held, states + FLOW_STATE * k, true, NULL, NULL, 0, 0});
    }
    flow_parameters_clear(&p);
    return status;
}
