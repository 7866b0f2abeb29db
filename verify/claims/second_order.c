#include "claims/second_order.h"

#include "motion/flow.h"
#include "proof/proof_results.h"
#include "text/scope.h"

static arb_ptr step_value(const struct second_order *o, const char *name)
{
    return machine_value(&o->machine, program_find(o->machine.program, name));
}

void second_order_init(struct second_order *o, const struct derivations *d, const arb_t c1, const arb_t c2, slong prec)
{
    static const char *const units[] = {"Omega", "L_ref", "m1", "m2", "k_c"};
    machine_init(&o->machine, &step_named(d, "second_order")->corrected.program, &arithmetic_ball, prec);
    for (size_t i = 0; i < sizeof units / sizeof *units; i++)
        arb_one(step_value(o, units[i]));
    arb_set(step_value(o, "c1"), c1);
    arb_set(step_value(o, "c2"), c2);
    machine_run(&o->machine);
}

void second_order_clear(struct second_order *o)
{
    machine_clear(&o->machine);
}

arb_srcptr second_order_get(const struct second_order *o, const char *name)
{
    return step_value(o, name);
}

void second_order_at(arb_ptr sample, struct second_order *o, const arb_t z_re, const arb_t z_im)
{
    static const char *const names[FLOW_STATE] = {"psi", "theta", "dL", "psi_dot", "theta_dot", "dL_dot"};
    arb_set(step_value(o, "u"), z_re);
    arb_set(step_value(o, "v"), z_im);
    machine_run(&o->machine);
    for (int i = 0; i < FLOW_STATE; i++)
        arb_set(sample + i, step_value(o, names[i]));
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
