/*
 * The law held between samples or acting late, a reference length that moves with pitch, and what the energy guarantees. Units:
 * sampling.h, second_order.h, guarantee.h.
 */
#include "claims/claim.h"
#include "claims/guarantee.h"
#include "claims/sampling.h"
#include "claims/second_order.h"
#include "claims/trajectory.h"
#include "text/scope.h"

enum { SAMPLING_BITS = 192 };

static const struct {
    const char *name, *n, *c2;
} sampled_gains[] = {{"10", "10", NULL}, {"118", "11.8", NULL}, {"12", "12", NULL}, {"best", "12", "4"}};
enum { SAMPLED_GAINS = sizeof sampled_gains / sizeof *sampled_gains };

/* |A|, |B| of the closed form and the slow law's coefficients; what one decides with. */
static void of_gains(struct computed *c)
{
    VECTOR(arb, values, GUARANTEES);
    SCOPE(arb, c1, c2, x);
    for (int k = 0; k < SAMPLED_GAINS; k++) {
        const char *name = sampled_gains[k].name;
        struct second_order o;
        set_gains(c1, c2, sampled_gains[k].n, sampled_gains[k].c2, SAMPLING_BITS);
        second_order_init(&o, c->steps, c1, c2, SAMPLING_BITS);
        arb_hypot(x, second_order_get(&o, "A_re"), second_order_get(&o, "A_im"), SAMPLING_BITS);
        give(c, true, x, "A_%s", name);
        arb_hypot(x, second_order_get(&o, "B_re"), second_order_get(&o, "B_im"), SAMPLING_BITS);
        give(c, true, x, "B_%s", name);
        give(c, true, second_order_get(&o, "decay"), "decay_%s", name);
        give(c, true, second_order_get(&o, "shift"), "shift_%s", name);
        second_order_clear(&o);
        const bool found = guarantees_enclose(values, c->steps, c1, c2, NULL, SAMPLING_BITS);
        for (int i = 0; i < GUARANTEES; i++)
            give(c, found, values + i, "%s_%s", guarantees[i].name, name);
    }
}

/* The paper's start with its gains, the law held for 0.2077 rad: |dL|/L_ref and yaw after 30, 60 and 90 holds. */
static void held_motion(struct computed *c)
{
    enum { SHOWN = 30, HOLDS = 90, DIGITS = 10, SECONDS = 2848, BITS = 512 };
    VECTOR(arb, samples, COORDINATES * (HOLDS + 1));
    SCOPE(arb, c1, c2, x);
    set_gains(c1, c2, "10", NULL, SAMPLING_BITS);
    sheet_value(x, c->steps->sheet, "L_ref", BITS);
    for (int i = PSI; i <= ETA; i++)
        sheet_value(samples + i, c->steps->sheet, variable_names[i], BITS);
    arb_div(samples + ETA, samples + ETA, x, BITS);
    const bool proved = hold_follow(samples, c->steps, c1, c2, SECONDS, HOLDS, DIGITS);
    sheet_value(x, c->steps->sheet, "Omega", SAMPLING_BITS);
    arb_mul_si(x, x, SECONDS, SAMPLING_BITS);
    give(c, proved, x, "hold");
    for (int k = SHOWN; k <= HOLDS; k += SHOWN) {
        arb_abs(x, samples + COORDINATES * k + ETA);
        give(c, proved, x, "length_%d", k);
        arb_abs(x, samples + COORDINATES * k + PSI);
        give(c, proved, x, "yaw_%d", k);
    }
}

/* From the paper's pitch with a swing of 1/100 at the start, for 20 days, hourly; and the averaged law's amplitude. */
static void damped(struct computed *c)
{
    enum { HOURS = 480, DIGITS = 5 };
    SCOPE(arb, amplitude, law, gap, charge);
    for (int k = 0; k < SAMPLED_GAINS; k += SAMPLED_GAINS - 1) {
        const char *name = sampled_gains[k].name;
        struct trajectory t;
        trajectory_run(&t, &(struct simulation){.steps = c->steps, .nonlinear = true, .digits = DIGITS, .forced = true, .swing = "0.01",
                                                .n = sampled_gains[k].n, .C2 = k > 0 ? "2.9166e-4" : NULL /* 4 Omega */},
                       HOUR, HOUR, HOURS * HOUR);
        arb_zero(gap);
        for (slong i = 0; i < t.count; i++) {
            SCOPE(arb, off);
            trajectory_value(amplitude, &t, i, AMPLITUDE);
            trajectory_slow_law(law, &t, i);
            arb_div(off, amplitude, law, SAMPLING_BITS);
            arb_sub_ui(off, off, 1, SAMPLING_BITS);
            arb_abs(off, off);
            arb_max(gap, gap, off, SAMPLING_BITS);
        }
        trajectory_peak(charge, &t, NULL, PRODUCT, 0, t.count - 1);
        give(c, true, amplitude, "amplitude_%s", name);
        give(c, true, law, "law_%s", name);
        give(c, true, gap, "gap_%s", name);
        give(c, true, charge, "charge_%s", name);
        trajectory_clear(&t);
    }
}

const struct computation computations_sampling[] = {
    {"of_gains", of_gains, NULL}, {"held_motion", held_motion, NULL}, {"damped", damped, NULL}, {NULL, NULL, NULL},
};
