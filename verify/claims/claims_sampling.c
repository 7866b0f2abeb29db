/*
 * The law held between samples or acting late, a reference length that moves with pitch, and what the energy guarantees. Units:
 * sampling.h, second_order.h, guarantee.h.
 */
#include "claims/claim.h"
#include "claims/guarantee.h"
#include "claims/sampling.h"
#include "claims/second_order.h"
#include "claims/trajectory.h"
#include "motion/motion.h"
#include "text/decimal.h"
#include "text/scope.h"

enum { SAMPLING_BITS = 192 };

/* By (44) where c2 is 0. */
static const struct {
    const char *name;
    ulong c1, c2;
} sampled_gains[] = {{"10", 10, 0}, {"12", 12, 0}, {"best", 12, 4}};
enum { SAMPLED_GAINS = 3 };

static void set_gains(arb_t c1, arb_t c2, int k)
{
    arb_set_ui(c1, sampled_gains[k].c1);
    arb_sqrt_ui(c2, 4 * (sampled_gains[k].c1 - 9), SAMPLING_BITS);
    if (sampled_gains[k].c2 != 0)
        arb_set_ui(c2, sampled_gains[k].c2);
}

static void sampling(struct computed *c)
{
    SCOPE(arb, c1, c2, limit);
    for (int k = 0; k < SAMPLED_GAINS; k++) {
        set_gains(c1, c2, k);
        largest_hold(limit, c1, c2, SAMPLING_BITS);
        give(c, true, limit, "hold_%s", sampled_gains[k].name);
        largest_delay(limit, c1, c2, SAMPLING_BITS);
        give(c, true, limit, "delay_%s", sampled_gains[k].name);
    }
}

/* The paper's start with its gains, the law held for 0.2077 rad: |dL|/L_ref and yaw after 30, 60 and 90 holds. */
static void held_motion(struct computed *c)
{
    enum { SHOWN = 30, HOLDS = 90, DIGITS = 10, BITS = 320 }; /* restarts from a box lose some 10 bits a radian */
    static const char *const names[FLOW_STATE] = {"psi", "theta", "dL"};
    struct flow_parameters p;
    VECTOR(arb, start, FLOW_STATE);
    VECTOR(arb, states, FLOW_STATE * HOLDS);
    SCOPE(fmpq, T);
    SCOPE(arb, c1, c2, eta, rate, charge, across);
    set_gains(c1, c2, 0);
    unit_parameters(&p, c1, c2);
    for (int i = 0; i < FLOW_HALF; i++)
        sheet_value(start + i, c->steps->sheet, names[i], BITS);
    sheet_value(eta, c->steps->sheet, "L_ref", BITS);
    arb_div(start + 2, start + 2, eta, BITS);
    arb_mul(start + 2, start + 2, p.L_ref, BITS);
    state_from_angles(start, c->steps->sheet, &p, BITS);
    flow_parameters_clear(&p);
    fmpq_set_si(T, 2077, 10000);
    const bool proved = hold_follow(states, start, c1, c2, T, HOLDS, DIGITS, BITS) == FLOW_DONE;
    arb_set_fmpq(rate, T, BITS);
    give(c, true, rate, "hold");
    for (int k = SHOWN; k <= HOLDS; k += SHOWN) {
        arb_srcptr state = states + FLOW_STATE * (k - 1);
        commanded(eta, rate, charge, state, c1, c2, BITS);
        arb_atan2(across, state + 1, state, BITS);
        arb_abs(across, across);
        arb_abs(eta, eta);
        give(c, proved, eta, "length_%d", k);
        give(c, proved, across, "yaw_%d", k);
    }
}

/* From the paper's pitch with a swing of 1/100 at the start, for 20 days, hourly; and the averaged law's amplitude. */
static void damped(struct computed *c)
{
    enum { HOURS = 480, DIGITS = 5 };
    static const char *const C2[SAMPLED_GAINS] = {NULL, NULL, "2.9166e-4"}; /* 4 Omega */
    SCOPE(arb, c1, c2, a, amplitude, law, gap, tau, charge);
    SCOPE(arb, swing, shift, product, sigma);
    SCOPE(acb, S);
    sheet_value(a, c->steps->sheet, "theta", SAMPLING_BITS);
    arb_set_ui(swing, 1);
    arb_div_ui(swing, swing, 100, SAMPLING_BITS);
    for (int k = 0; k < SAMPLED_GAINS; k += 2) {
        struct second_order o;
        struct trajectory t;
        const struct simulation s = {.steps = c->steps, .digits = DIGITS, .n = k > 0 ? "12" : "10", .C2 = C2[k]};
        set_gains(c1, c2, k);
        quadrature_reference(S, c1, c2, swing, a, SAMPLING_BITS);
        const bool proved = slow_run(&t, &o, s, c1, c2, S, a, HOUR, HOUR, HOURS * HOUR);
        arb_zero(gap);
        arb_zero(charge);
        for (slong i = 0; i < t.count; i++) {
            trajectory_value(amplitude, &t, i, AMPLITUDE);
            arb_mul_si(tau, t.Omega, (i + 1) * HOUR, SAMPLING_BITS);
            slow_law(law, shift, &o, a, tau);
            arb_mul(law, law, a, SAMPLING_BITS);
            arb_sub(tau, amplitude, law, SAMPLING_BITS);
            arb_div(tau, tau, law, SAMPLING_BITS);
            arb_abs(tau, tau);
            arb_max(gap, gap, tau, SAMPLING_BITS);
            trajectory_value(product, &t, i, PRODUCT);
            moved_reference(sigma, S, trajectory_sample(&t, i), SAMPLING_BITS);
            arb_mul(sigma, sigma, c1, SAMPLING_BITS);
            arb_div_ui(sigma, sigma, 3, SAMPLING_BITS);
            arb_sub(product, product, sigma, SAMPLING_BITS);
            arb_abs(product, product);
            arb_max(charge, charge, product, SAMPLING_BITS);
        }
        give(c, proved, amplitude, "amplitude_%s", sampled_gains[k].name);
        give(c, proved, law, "law_%s", sampled_gains[k].name);
        give(c, proved, gap, "gap_%s", sampled_gains[k].name);
        give(c, proved, charge, "charge_%s", sampled_gains[k].name);
        trajectory_clear(&t);
        second_order_clear(&o);
    }
}

/* |A|, |B| of the closed form, and the coefficients of the slow law, for the gains (43), (44) of some n; n = 11.8 as 118. */
static void forced_response(struct computed *c)
{
    static const char *const gains[] = {"10", "11.8", "12"}, *const names[] = {"10", "118", "12"};
    SCOPE(arb, size);
    for (int i = 0; i < 3; i++) {
        struct second_order o;
        struct trajectory t;
        const bool ready = trajectory_run(&t, &(struct simulation){.steps = c->steps, .n = gains[i]}, 0, 1, 0);
        second_order_init(&o, c->steps, t.c1, t.c2, NULL, SAMPLING_BITS);
        arb_hypot(size, second_order_get(&o, "A_re"), second_order_get(&o, "A_im"), SAMPLING_BITS);
        give(c, ready, size, "length_%s", names[i]);
        arb_hypot(size, second_order_get(&o, "B_re"), second_order_get(&o, "B_im"), SAMPLING_BITS);
        give(c, ready, size, "yaw_%s", names[i]);
        give(c, ready, second_order_get(&o, "decay"), "decay_%s", names[i]);
        give(c, ready, second_order_get(&o, "shift"), "shift_%s", names[i]);
        second_order_clear(&o);
        trajectory_clear(&t);
    }
}

/* The numbers of guarantee.h at n = 10 and 12. */
static void give_guarantees(struct computed *c)
{
    VECTOR(arb, values, GUARANTEES);
    SCOPE(arb, n);
    for (int gain = 10; gain <= 12; gain += 2) {
        arb_set_si(n, gain);
        const bool found = guarantees_enclose(values, n, NULL, SAMPLING_BITS);
        for (int i = 0; i < GUARANTEES; i++)
            give(c, found, values + i, "%s_%d", guarantees[i].name, gain);
    }
}

const struct computation computations_sampling[] = {
    {"guaranteed", give_guarantees, NULL}, {"sampling", sampling, NULL}, {"held_motion", held_motion, NULL}, {"damped", damped, NULL},
    {"forced_response", forced_response, NULL}, {NULL, NULL, NULL},
};
