/*
 * Beyond the paper: at what order its approximations and the closed form of second_order.h err, by the studies of
 * convergence.h.
 */
#include <stdio.h>

#include "convergence.h"
#include "give.h"

enum { BITS = 192 };

/* Raises `worst` to what an order of a study's last row is off the expected one by; hands over these orders, and constants. */
static void give_study(struct computed *c, arb_t worst, const char *prefix, const char *name, bool constants)
{
    struct convergence study;
    const bool found = convergence_init(&study, study_find(name));
    for (int i = 0; i < study.study->count; i++) {
        const char *variable = variable_names[study.study->which[i]];
        raise_to_difference(worst, convergence_order(&study, i), study.study->order[i]);
        if (prefix != NULL)
            give(c, found, convergence_order(&study, i), "%s%s", prefix, variable);
        if (constants)
            give(c, found, convergence_constant(&study, i), "c_%s", variable);
    }
    if (!found)
        arb_indeterminate(worst);
    convergence_clear(&study);
}

static void approximation_orders(struct computed *c)
{
    arb_t worst;
    arb_init(worst);
    give_study(c, worst, "half_day_", "linear_43200s", false);
    give_study(c, worst, "two_days_", "linear_172800s", false);
    give_study(c, worst, "pitch_alone_", "linear_pitch_172800s", false);
    give_study(c, worst, "runge_kutta_", "rk4_nonlinear_24000s", false);
    give(c, true, worst, "worst");
    arb_clear(worst);
}

/* What one study's variables are off by at L_ref/R_c = 10 m / 42164 km, the sheet's. */
static void give_orbit(struct computed *c, const char *prefix, const char *name)
{
    const struct study *s = study_find(name);
    char text[64];
    arb_ptr d = _arb_vec_init(VARIABLES);
    fmpq_t smallness;
    fmpq_init(smallness);
    fmpq_set_si(smallness, 10, 42164000);
    const bool found = s->differences(d, s, smallness);
    for (int i = 0; i < s->count; i++) {
        if (!found)
            arb_indeterminate(d + i);
        snprintf(text, sizeof text, "%s%s", prefix, variable_names[s->which[i]]);
        give_number(c, text, d + i, MEASURED);
    }
    _arb_vec_clear(d, VARIABLES);
    fmpq_clear(smallness);
}

static void hill_orders(struct computed *c)
{
    arb_t worst;
    arb_init(worst);
    give_study(c, worst, NULL, "hill_43200s", false);
    give_study(c, worst, NULL, "hill_unequal_43200s", false);
    give_number(c, "worst", worst, MEASURED);
    give_orbit(c, "equal_", "hill_43200s");
    give_orbit(c, "unequal_", "hill_unequal_43200s");
    arb_clear(worst);
}

static void slow_law_orders(struct computed *c)
{
    arb_t worst;
    arb_init(worst);
    give_study(c, worst, "p_", "forced_43200s", false);
    give(c, true, worst, "worst");
    arb_zero(worst);
    give_study(c, worst, "p_", "slow_law", true);
    give(c, true, worst, "worst_slow");
    arb_clear(worst);
}

#define PAIR_STATE(before) PLACE_OF_1(before) ANGLES_AND_LENGTH(before, "")

const struct computation computations_beyond[] = {
    {"approximation_orders", approximation_orders,
     "worst" TETHER_STATE("half_day_") TETHER_STATE("two_days_") TETHER_STATE("pitch_alone_") TETHER_STATE("runge_kutta_"), ""},
    {"hill_orders", hill_orders,
     "worst" PAIR_STATE("equal_") PAIR_STATE("unequal_"), ""},
    {"slow_law_orders", slow_law_orders,
     "worst worst_slow p_amplitude p_phase c_amplitude c_phase" TETHER_STATE("p_"), ""},
    {NULL, NULL, NULL, NULL},
};
