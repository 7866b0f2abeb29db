#include "second_order.h"

#include <stdlib.h>
#include <string.h>

#include "flow.h"

/*
 * x1 and y1 hold psi and dL and are even in z, z1 holds theta and is odd: what is left of (3) is of the fourth order
 * in the first two and of the fifth in the last.
 */
static const char step_text[] =
    "principles: {}\n"
    "steps:\n"
    "  second_order:\n"
    "    title: the motion that a pitch oscillation leaves, z = u + i v\n"
    "    from: ['3', '7', '10', '11', '18']\n"
    "    to: []\n"
    "    note: A factor u, small itself, makes the fourth order of the first two equalities the third order of (3).\n"
    "    free: [c1, c2, u, v]\n"
    "    small: [u, v]\n"
    "    order: 4\n"
    "    roots: [L_ref]\n"
    "    rates: {u: u_dot, v: v_dot}\n"
    "    let:\n"
    "      C1: c1*Omega^2\n"
    "      C2: c2*Omega\n"
    "      N: (13*c1 - 261)^2 + (52*c2)^2\n"
    "      B_re: -1152*c2/N\n"
    "      B_im: -2*((c1 - 9)*(13*c1 - 261) + 208*c2^2)/N\n"
    "      A_re: (2 + 13*B_im)/8\n"
    "      A_im: -13*B_re/8\n"
    "      T_re: (-51*B_im - 8)/96\n"
    "      T_im: 51*B_re/96\n"
    "      decay: 2592*c2/N\n"
    "      shift: -9/2*((c1 - 9)*(13*c1 - 261) + 208*c2^2)/N\n"
    "      u_dot: Omega*(-2*v - (u^2 + v^2)*(decay*u + shift*v))\n"
    "      v_dot: Omega*(2*u + (u^2 + v^2)*(shift*u - decay*v))\n"
    "      psi: B_re*(u^2 - v^2) - 2*B_im*u*v\n"
    "      dL: L_ref*(A_re*(u^2 - v^2) - 2*A_im*u*v)\n"
    "      theta: u + T_re*(u^3 - 3*u*v^2) - T_im*(3*u^2*v - v^3)\n"
    "      psi_dot: rate(psi)\n"
    "      dL_dot: rate(dL)\n"
    "      theta_dot: rate(theta)\n"
    "      L: L_ref + dL\n"
    "      Q: eq07.Q_ref(L = L_ref) + eq18.dQ\n"
    "      x1: eq10.x1\n"
    "      y1: eq10.y1\n"
    "      z1: eq10.z1\n"
    "      x1_dot: eq11exact.x1_dot(L_dot = dL_dot)\n"
    "      y1_dot: eq11exact.y1_dot(L_dot = dL_dot)\n"
    "      z1_dot: eq11exact.z1_dot(L_dot = dL_dot)\n"
    "    show:\n"
    "      - u*rate(x1_dot) = u*eq03.x1_ddot\n"
    "      - u*rate(y1_dot) = u*eq03.y1_ddot\n"
    "      - rate(z1_dot) = eq03.z1_ddot\n";

static arb_ptr value(const struct second_order *o, const char *name)
{
    return machine_value(&o->machine, program_find(o->machine.program, name));
}

void second_order_init(struct second_order *o, const arb_t c1, const arb_t c2, slong prec)
{
    static const char *const units[] = {"Omega", "L_ref", "m1", "m2", "k_c"};
    struct message why;
    if (derivations_read(&o->derivations, sheet(), step_text, strlen(step_text), "second_order", &why) != 0)
        abort(); /* a constant of the program, which its test reads */
    machine_init(&o->machine, &o->derivations.steps[0].corrected.program, &arithmetic_ball, prec);
    for (size_t i = 0; i < sizeof units / sizeof *units; i++)
        arb_one(value(o, units[i]));
    arb_set(value(o, "c1"), c1);
    arb_set(value(o, "c2"), c2);
    machine_run(&o->machine);
}

void second_order_clear(struct second_order *o)
{
    machine_clear(&o->machine);
    derivations_clear(&o->derivations);
}

int second_order_proof(const struct second_order *o)
{
    struct proof p;
    trial_prove(&o->derivations.steps[0].corrected, 1, &p);
    int bits = p.finding == FOUND_EQUAL ? p.bits : 0;
    proof_clear(&p);
    return bits;
}

arb_srcptr second_order_get(const struct second_order *o, const char *name)
{
    return value(o, name);
}

void second_order_at(arb_ptr row, struct second_order *o, const arb_t z_re, const arb_t z_im)
{
    static const char *const names[FLOW_STATE] = {"psi", "theta", "dL", "psi_dot", "theta_dot", "dL_dot"};
    arb_set(value(o, "u"), z_re);
    arb_set(value(o, "v"), z_im);
    machine_run(&o->machine);
    for (int i = 0; i < FLOW_STATE; i++)
        arb_set(row + i, value(o, names[i]));
}

void slow_law(arb_t ratio, arb_t shift, const struct second_order *o, const arb_t a, const arb_t tau)
{
    const slong prec = o->machine.prec;
    arb_t growth;
    arb_init(growth);
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
    arb_clear(growth);
}

void second_order_after(arb_ptr row, struct second_order *o, const arb_t a, const arb_t tau)
{
    const slong prec = o->machine.prec;
    arb_t size, angle, z_re, z_im;
    arb_init(size);
    arb_init(angle);
    arb_init(z_re);
    arb_init(z_im);
    slow_law(size, angle, o, a, tau);
    arb_mul(size, size, a, prec);
    arb_addmul_ui(angle, tau, 2, prec);
    arb_sin_cos(z_im, z_re, angle, prec);
    arb_mul(z_re, z_re, size, prec);
    arb_mul(z_im, z_im, size, prec);
    second_order_at(row, o, z_re, z_im);
    arb_clear(size);
    arb_clear(angle);
    arb_clear(z_re);
    arb_clear(z_im);
}
