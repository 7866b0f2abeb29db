/*
 * What a small pitch does to yaw, to the length and, through them, to itself: the closed form of second_order.h, held
 * against certified motions.
 *
 * At second order pitch alone drives the length by theta'^2 - 4 theta^2 = -4 a^2 cos 2 phi and yaw by 2 theta theta' =
 * -2 a^2 sin 2 phi (radians of orbit, theta = a cos phi); neither has a mean. Yaw and length answer at 2 phi, and at
 * third order change the amplitude and the frequency of pitch.
 */
#include "claims/convergence.h"
#include "claims/give.h"
#include "claims/second_order.h"
#include "text/scope.h"

enum { DAY = 86400, BITS = 192 };

/* For the gains (43), (44) of that n. */
static bool response_init(struct second_order *o, const struct computed *c, const char *n)
{
    struct track t;
    bool ready = track_run(&t, sheet_of(c), &(struct scene){.n = n}, 0, 1, 0);
    second_order_init(o, steps_of(c), t.c1, t.c2, BITS);
    track_clear(&t);
    return ready;
}

/* |A|, |B| and the coefficients of the slow law; n = 11.8 as 118. */
static void forced_response(struct computed *c)
{
    static const char *const gains[] = {"10", "11.8", "12"}, *const names[] = {"10", "118", "12"};
    SCOPE(arb, size);
    for (int i = 0; i < 3; i++) {
        struct second_order o;
        const bool ready = response_init(&o, c, gains[i]);
        arb_hypot(size, second_order_get(&o, "A_re"), second_order_get(&o, "A_im"), BITS);
        give(c, ready, size, "length_%s", names[i]);
        arb_hypot(size, second_order_get(&o, "B_re"), second_order_get(&o, "B_im"), BITS);
        give(c, ready, size, "yaw_%s", names[i]);
        give(c, ready, second_order_get(&o, "decay"), "decay_%s", names[i]);
        give(c, ready, second_order_get(&o, "shift"), "shift_%s", names[i]);
        second_order_clear(&o);
    }
}

/* What a certified motion, started on the closed form, differs from it by after three days. */
static bool response_error(arb_ptr error, const struct computed *c, const char *n, const char *amplitude)
{
    struct second_order o;
    struct track t;
    VECTOR(arb, row, FLOW_STATE);
    SCOPE(arb, a, tau);
    bool run = arb_set_str(a, amplitude, BITS) == 0 && response_init(&o, c, n);
    second_order_after(row, &o, a, tau);
    run = track_run(&t, sheet_of(c), &(struct scene){.nonlinear = true, .n = n, .start = row}, 3 * DAY, 1, 3 * DAY) && run;
    arb_mul_si(tau, t.Omega, 3 * DAY, BITS);
    second_order_after(row, &o, a, tau);
    for (int i = PSI; i <= ETA; i++) {
        arb_sub(error + i, track_row(&t, 0) + i, row + i, BITS);
        arb_abs(error + i, error + i);
    }
    track_clear(&t);
    second_order_clear(&o);
    return run;
}

/* The error at a pitch of 0.01 rad, and its order from 0.001 to 0.0001 rad; `worst`: the most that one is off its own. */
static void response_errors(struct computed *c)
{
    static const char *const gains[] = {"10", "12"}, *const amplitudes[] = {"1e-2", "1e-3", "1e-4"};
    static const int orders[] = {[PSI] = 4, [THETA] = 5, [ETA] = 4};
    bool proved = true;
    VECTOR(arb, error, 3 * 3);
    SCOPE(arb, order, worst);
    for (int k = 0; k < 2; k++) {
        for (int i = 0; i < 3; i++)
            proved = response_error(error + 3 * i, c, gains[k], amplitudes[i]) && proved;
        for (int j = PSI; j <= ETA; j++) {
            observed_order(order, error + 3 + j, error + 6 + j, 10);
            raise_to_difference(worst, order, orders[j]);
            give(c, proved, order, "p_%s_%s", gains[k], variable_names[j]);
            give(c, proved, error + j, "error_%s_%s", gains[k], variable_names[j]);
        }
    }
    give(c, proved, worst, "worst");
}

/* Of the simulation: its energy at the start, and the bounds on |psi|, |theta|, |dL| (in m) that follow for ever. */
static void energy_bounds(struct computed *c)
{
    struct track t;
    struct bounds b;
    SCOPE(arb, energy);
    bounds_init(&b);
    const bool run = track_run(&t, sheet_of(c), &(struct scene){.nonlinear = true}, 0, 1, 0), bounded = track_bounds(&b, &t, 0);
    track_energy(energy, &t, 0);
    arb_mul(b.of[ETA], b.of[ETA], t.L_ref, t.prec);
    give(c, run, energy, "energy");
    for (int i = PSI; i <= ETA; i++)
        give(c, run && bounded, b.of[i], "%s", variable_names[i]);
    bounds_clear(&b);
    track_clear(&t);
}

/* E = 2 a^2 + O(a^4), so that 1/E grows by the decay of the closed form: 1/E after 5 days, and its growth until day 13, a
   radian of orbit. */
static void pitch_decay(struct computed *c)
{
    struct track t;
    VECTOR(arb, x, 2);
    SCOPE(arb, tau);
    const bool run = track_run(&t, sheet_of(c), &(struct scene){.nonlinear = true}, 5 * DAY, 8 * DAY, 13 * DAY);
    for (int i = 0; i < 2; i++) {
        track_energy(x + i, &t, i);
        arb_inv(x + i, x + i, BITS);
    }
    arb_mul_si(tau, t.Omega, 8 * DAY, BITS);
    arb_sub(x + 1, x + 1, x, BITS);
    arb_div(x + 1, x + 1, tau, BITS);
    give(c, run, x, "inverse_energy");
    give(c, run, x + 1, "growth");
    track_clear(&t);
}

const struct computation computations_forced[] = {
    {"forced_response", forced_response,
     "length_10 yaw_10 decay_10 shift_10 length_118 yaw_118 decay_118 shift_118 length_12 yaw_12 decay_12 shift_12", ""},
    {"response_errors", response_errors,
     "worst" ANGLES_AND_LENGTH("p_10_", "") ANGLES_AND_LENGTH("p_12_", "") ANGLES_AND_LENGTH("error_10_", "")
         ANGLES_AND_LENGTH("error_12_", ""), ""},
    {"energy_bounds", energy_bounds, "energy psi theta dL", ""},
    {"pitch_decay", pitch_decay, "inverse_energy growth", ""},
    {NULL, NULL, NULL, NULL},
};
