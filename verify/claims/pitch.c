#include "claims/pitch.h"

#include <string.h>

#include "claims/sampling.h"
#include "motion/motion.h"
#include "motion/taylor.h"
#include "proof/proof_results.h"
#include "text/scope.h"

/* Of the closed loop (taylor.h) z, w, q, A and R; further series, F = c1 sigma; constants, c1 S_im, c1 S_re, c1 S_re/4. */
enum {
    LAW_Z = 2, LAW_W = 5, LAW_Q = 6, LAW_A = JET_STATES + 2, LAW_R = JET_STATES + 4,
    LAW_SINE = JET_SERIES, LAW_RATE, LAW_PRODUCT, LAW_SQUARE, LAW_RATE_SQUARE, LAW_F, LAW_SERIES,
    LAW_IM = LAW_SERIES + JET_ALL - JET_SERIES, LAW_RE, LAW_QUARTER, LAW_ALL
};

static const struct term moved_terms[] = {
    {LAW_SINE, LAW_Z, LAW_Q, 1},
    {LAW_RATE, LAW_W, LAW_Q, 1}, {LAW_RATE, LAW_SINE, LAW_A, -1},
    {LAW_PRODUCT, LAW_SINE, LAW_RATE, 1}, {LAW_SQUARE, LAW_SINE, LAW_SINE, 1}, {LAW_RATE_SQUARE, LAW_RATE, LAW_RATE, 1},
    {LAW_F, LAW_IM, LAW_PRODUCT, 1}, {LAW_F, LAW_RE, LAW_SQUARE, 1}, {LAW_F, LAW_QUARTER, LAW_RATE_SQUARE, -1},
};
enum { MOVED_TERMS = sizeof moved_terms / sizeof *moved_terms, LAW_TERMS = JET_TERMS + MOVED_TERMS + 1, LAW_NUMBERS = 6 };

static unsigned char law_place(unsigned char v)
{
    return (unsigned char)(v < JET_SERIES ? v : v + LAW_SERIES - JET_SERIES);
}

/* The closed loop with these series before R, and + q F in it. */
static struct system pitch_loop(struct term *terms)
{
    int count = 0;
    for (int t = 0; t < closed_loop.count; t++) {
        const struct term *f = closed_loop.terms + t;
        if (f->to == LAW_R && f[-1].to != LAW_R) {
            memcpy(terms + count, moved_terms, sizeof moved_terms);
            count += MOVED_TERMS;
        }
        terms[count++] = (struct term){f->to, law_place(f->a), law_place(f->b), f->sign};
        if (f->to == LAW_R && f[1].to != LAW_R)
            terms[count++] = (struct term){LAW_R, LAW_Q, LAW_F, 1};
    }
    return (struct system){JET_STATES, LAW_SERIES, LAW_ALL, count, terms};
}

/* ---- the averaged law ---- */

static arb_ptr law_value(const struct machine *m, const char *name)
{
    return machine_value(m, program_find(m->program, name));
}

/* The step at z = a, in radians of orbit and units of L_ref. */
static void law_machine(struct machine *m, const struct pitch_law *l, slong prec)
{
    static const char *const units[] = {"Omega", "L_ref", "m1", "m2", "k_c"};
    machine_init(m, &step_named(l->steps, "pitch_law")->corrected.program, &arithmetic_ball, prec);
    for (size_t i = 0; i < sizeof units / sizeof *units; i++)
        arb_one(law_value(m, units[i]));
    arb_set(law_value(m, "c1"), l->c1);
    arb_set(law_value(m, "c2"), l->c2);
    arb_set(law_value(m, "S_re"), l->S_re);
    arb_set(law_value(m, "S_im"), l->S_im);
    arb_set(law_value(m, "u"), l->a);
    machine_run(m);
}

/* By B = i (8 A - 2)/13 the step's B says c1 S = 36/13 + A (c1 + 4 i c2 - 261/13). */
void pitch_law_init(struct pitch_law *l, const struct derivations *d, const arb_t c1, const arb_t c2, const arb_t swing,
                    const arb_t a, slong prec)
{
    struct machine m;
    SCOPE(acb, S);
    SCOPE(arb, part);
    arb_ptr of = _arb_vec_init(LAW_NUMBERS);
    *l = (struct pitch_law){d, of, of + 1, of + 2, of + 3, of + 4, of + 5};
    arb_set(l->c1, c1);
    arb_set(l->c2, c2);
    arb_set(l->a, a);
    arb_set_ui(part, 261);
    arb_div_ui(part, part, 13, prec);
    arb_sub(acb_realref(S), c1, part, prec);
    arb_mul_2exp_si(acb_imagref(S), c2, 2);
    arb_sqr(part, a, prec);
    arb_div(part, swing, part, prec); /* A itself is i times that */
    acb_mul_arb(S, S, part, prec);
    acb_mul_onei(S, S);
    arb_set_ui(part, 36);
    arb_div_ui(part, part, 13, prec);
    acb_add_arb(S, S, part, prec);
    acb_div_arb(S, S, c1, prec);
    acb_get_real(l->S_re, S);
    acb_get_imag(l->S_im, S);
    law_machine(&m, l, prec);
    arb_set(l->k, law_value(&m, "decay"));
    machine_clear(&m);
}

void pitch_law_clear(struct pitch_law *l)
{
    _arb_vec_clear(l->c1, LAW_NUMBERS);
}

void pitch_law_ratio(arb_t ratio, const struct pitch_law *l, const arb_t tau, slong prec)
{
    arb_sqr(ratio, l->a, prec);
    arb_mul(ratio, ratio, l->k, prec);
    arb_mul(ratio, ratio, tau, prec);
    arb_mul_2exp_si(ratio, ratio, 1);
    arb_add_ui(ratio, ratio, 1, prec);
    arb_rsqrt(ratio, ratio, prec);
}

/* ---- the motion ---- */

static int take_state_of_pitch(void *context, slong k, const fmpq_t t, arb_srcptr state)
{
    (void)t;
    _arb_vec_set((arb_ptr)context + FLOW_STATE * k, state, FLOW_STATE);
    return 0;
}

enum flow_status pitch_law_follow(arb_ptr states, const struct pitch_law *l, const fmpq *times, slong count, slong digits)
{
    static const char *const names[FLOW_STATE] = {"psi", "theta", "dL", "psi_dot", "theta_dot", "dL_dot"};
    const slong prec = flow_precision(digits, fmpq_get_d(times + count - 1));
    struct term terms[LAW_TERMS];
    struct flow_parameters p;
    struct machine m;
    double reached;
    VECTOR(arb, state, FLOW_STATE);
    VECTOR(arb, constants, 3);
    unit_parameters(&p, l->c1, l->c2);
    law_machine(&m, l, prec);
    for (int i = 0; i < FLOW_STATE; i++)
        arb_mul_2exp_si(state + i, law_value(&m, names[i]), i % FLOW_HALF == 2); /* L_ref = 2 */
    machine_clear(&m);
    state_from_angles(state, l->steps->sheet, &p, prec);
    arb_mul(constants, l->S_im, l->c1, prec);
    arb_mul(constants + 1, l->S_re, l->c1, prec);
    arb_mul_2exp_si(constants + 2, constants + 1, -2);
    const struct system loop = pitch_loop(terms);
    const struct flow_steps how = {.system = &loop, .constants = constants};
    const enum flow_status status = flow_nonlinear_by(&how, &p, state, times, count, digits, prec, take_state_of_pitch,
                                                      states, &reached);
    flow_parameters_clear(&p);
    return status;
}

void pitch_law_numbers(arb_t amplitude, arb_t eta, arb_t charge, const struct pitch_law *l, arb_srcptr state, slong prec)
{
    SCOPE(arb, r, stretch, sine, cosine, rate, sigma, part);
    commanded(eta, stretch, charge, state, l->c1, l->c2, prec);
    arb_add_ui(r, eta, 1, prec);
    arb_div(sine, state + 2, r, prec);
    arb_mul(rate, sine, stretch, prec);
    arb_sub(rate, state + 5, rate, prec);
    arb_div(rate, rate, r, prec);
    arb_mul_2exp_si(rate, rate, -1);
    arb_hypot(cosine, state, state + 1, prec);
    arb_div(cosine, cosine, r, prec);
    arb_sqr(sigma, sine, prec); /* S_re (sin^2 - rate^2) + 2 S_im sin rate, the rate being half of that of sin(theta) */
    arb_submul(sigma, rate, rate, prec);
    arb_mul(sigma, sigma, l->S_re, prec);
    arb_mul(part, sine, rate, prec);
    arb_mul_2exp_si(part, part, 1);
    arb_addmul(sigma, part, l->S_im, prec);
    arb_mul(sigma, sigma, l->c1, prec);
    arb_div_ui(sigma, sigma, 3, prec);
    arb_sub(charge, charge, sigma, prec);
    arb_atan2(amplitude, sine, cosine, prec);
    arb_div(rate, rate, cosine, prec);
    arb_hypot(amplitude, amplitude, rate, prec);
}
