#include "claims/second_order.h"

#include <string.h>

#include "proof/derivation.h"
#include "text/scope.h"

arb_ptr second_order_get(const struct second_order *o, const char *name)
{
    return machine_value(&o->machine, program_find(o->machine.program, name));
}

void second_order_init(struct second_order *o, const struct derivations *d, const arb_t c1, const arb_t c2, slong prec)
{
    static const char *const units[] = {"Omega", "L_ref", "m1", "m2", "k_c"};
    machine_init(&o->machine, &step_named(d, "pitch_law")->corrected.program, &arithmetic_ball, prec);
    for (size_t i = 0; i < sizeof units / sizeof *units; i++)
        arb_one(second_order_get(o, units[i]));
    arb_set(second_order_get(o, "c1"), c1);
    arb_set(second_order_get(o, "c2"), c2);
    machine_run(&o->machine);
}

void second_order_clear(struct second_order *o)
{
    machine_clear(&o->machine);
}

void second_order_at(arb_ptr sample, struct second_order *o, const arb_t z_re, const arb_t z_im)
{
    static const char *const names[FLOW_STATE] = {"psi", "theta", "dL", "psi_dot", "theta_dot", "dL_dot"};
    arb_set(second_order_get(o, "u"), z_re);
    arb_set(second_order_get(o, "v"), z_im);
    machine_run(&o->machine);
    for (int i = 0; i < FLOW_STATE; i++)
        arb_set(sample + i, second_order_get(o, names[i]));
}

void slow_law(arb_t ratio, arb_t shift, const struct second_order *o, const arb_t a, const arb_t tau)
{
    const slong prec = o->machine.prec;
    SCOPE(arb, growth);
    arb_sqr(growth, a, prec);
    arb_mul(growth, growth, tau, prec);
    arb_mul(growth, growth, second_order_get(o, "decay"), prec);
    arb_mul_2exp_si(growth, growth, 1);
    arb_log1p(shift, growth, prec);
    arb_mul(shift, shift, second_order_get(o, "shift"), prec);
    arb_div(shift, shift, second_order_get(o, "decay"), prec);
    arb_mul_2exp_si(shift, shift, -1);
    arb_add_ui(ratio, growth, 1, prec);
    arb_rsqrt(ratio, ratio, prec);
}

void second_order_after(arb_ptr sample, struct second_order *o, const arb_t a, const arb_t tau)
{
    const slong prec = o->machine.prec;
    SCOPE(arb, size, angle, z_re, z_im);
    slow_law(size, angle, o, a, tau);
    arb_mul(size, size, a, prec);
    arb_addmul_ui(angle, tau, 2, prec);
    arb_sin_cos(z_im, z_re, angle, prec);
    arb_mul(z_re, z_re, size, prec);
    arb_mul(z_im, z_im, size, prec);
    second_order_at(sample, o, z_re, z_im);
}

/* ---- a reference length that moves with pitch ---- */

/* By B = i (8 A - 2)/13 the step's B says c1 S = 36/13 + A (c1 + 4 i c2 - 261/13). */
void second_order_swing(struct second_order *o, const arb_t swing, const arb_t a)
{
    const slong prec = o->machine.prec;
    arb_ptr S_re = second_order_get(o, "S_re"), S_im = second_order_get(o, "S_im");
    SCOPE(arb, part);
    arb_sqr(part, a, prec);
    arb_div(part, swing, part, prec);
    arb_mul_si(S_re, second_order_get(o, "c2"), -4 * 13, prec);
    arb_mul(S_re, S_re, part, prec);
    arb_add_ui(S_re, S_re, 36, prec);
    arb_mul_ui(S_im, second_order_get(o, "c1"), 13, prec);
    arb_sub_ui(S_im, S_im, 261, prec);
    arb_mul(S_im, S_im, part, prec);
    arb_mul_ui(part, second_order_get(o, "c1"), 13, prec);
    arb_div(S_re, S_re, part, prec);
    arb_div(S_im, S_im, part, prec);
    machine_run(&o->machine);
}

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
enum { MOVED_TERMS = sizeof moved_terms / sizeof *moved_terms };

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

void moved_loop_init(struct moved_loop *l, const struct second_order *o)
{
    arb_srcptr c1 = second_order_get(o, "c1");
    l->system = pitch_loop(l->terms);
    l->constants = _arb_vec_init(3);
    arb_mul(l->constants, second_order_get(o, "S_im"), c1, o->machine.prec);
    arb_mul(l->constants + 1, second_order_get(o, "S_re"), c1, o->machine.prec);
    arb_mul_2exp_si(l->constants + 2, l->constants + 1, -2);
}

void moved_loop_clear(struct moved_loop *l)
{
    _arb_vec_clear(l->constants, 3);
}

/* Re(S z^2), z = sin(theta) - i sin(theta)'/2 */
void moved_reference(arb_t sigma, const struct second_order *o, arb_srcptr sample)
{
    const slong prec = o->machine.prec;
    SCOPE(acb, z, S);
    acb_set_arb_arb(S, second_order_get(o, "S_re"), second_order_get(o, "S_im"));
    arb_sin_cos(acb_realref(z), acb_imagref(z), sample + THETA, prec);
    arb_mul(acb_imagref(z), acb_imagref(z), sample + THETA_DOT, prec);
    acb_conj(z, z);
    arb_mul_2exp_si(acb_imagref(z), acb_imagref(z), -1);
    acb_sqr(z, z, prec);
    acb_mul(z, z, S, prec);
    acb_get_real(sigma, z);
}
