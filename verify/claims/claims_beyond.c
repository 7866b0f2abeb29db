/*
 * Beyond the paper: at what order its approximations and the closed form of second_order.h err, by the studies of
 * convergence.h.
 */
#include "claims/convergence.h"
#include "claims/give.h"
#include "text/scope.h"

enum { BITS = 192 };

/* Raises `worst` to what an order of a study's last row is off the expected one by; false where that was not found. */
static bool study_worst(arb_t worst, const struct computed *c, struct convergence *study, const char *name)
{
    const struct study *s = study_find(name);
    const bool found = convergence_init(study, steps_of(c), s, s->rows - 2);
    for (int i = 0; i < s->count; i++)
        raise_to_difference(worst, convergence_order(study, i), s->order[i]);
    return found;
}

/* The same, and hands over its orders. */
static bool give_orders(struct computed *c, arb_t worst, const char *prefix, const char *name)
{
    struct convergence study;
    const bool found = study_worst(worst, c, &study, name);
    for (int i = 0; i < study.study->count; i++)
        give(c, found, convergence_order(&study, i), "%s%s", prefix, variable_names[study.study->which[i]]);
    convergence_clear(&study);
    return found;
}

static void approximation_orders(struct computed *c)
{
    SCOPE(arb, worst);
    bool found = give_orders(c, worst, "half_day_", "linear_43200s");
    found = give_orders(c, worst, "two_days_", "linear_172800s") && found;
    found = give_orders(c, worst, "pitch_alone_", "linear_pitch_172800s") && found;
    found = give_orders(c, worst, "runge_kutta_", "rk4_nonlinear_24000s") && found;
    give(c, found, worst, "worst");
}

/* Orders, and what the variables are off by at L_ref/R_c = 10 m / 42164 km, the sheet's. */
static bool give_orbit(struct computed *c, arb_t worst, const char *prefix, const char *name)
{
    const struct study *s = study_find(name);
    struct convergence study;
    const bool observed = study_worst(worst, c, &study, name);
    VECTOR(arb, d, VARIABLES);
    SCOPE(fmpq, smallness);
    fmpq_set_si(smallness, 10, 42164000);
    const bool found = s->differences(d, steps_of(c), s, smallness);
    for (int i = 0; i < s->count; i++)
        give_measured(c, found, d + i, "%s%s", prefix, variable_names[s->which[i]]);
    convergence_clear(&study);
    return observed;
}

static void hill_orders(struct computed *c)
{
    SCOPE(arb, worst);
    bool found = give_orbit(c, worst, "equal_", "hill_43200s");
    found = give_orbit(c, worst, "unequal_", "hill_unequal_43200s") && found;
    give_measured(c, found, worst, "worst");
}

static void slow_law_orders(struct computed *c)
{
    struct convergence study;
    SCOPE(arb, worst);
    bool found = give_orders(c, worst, "p_", "forced_43200s");
    give(c, found, worst, "worst");
    arb_zero(worst);
    found = study_worst(worst, c, &study, "slow_law");
    give(c, found, worst, "worst_slow");
    for (int i = 0; i < study.study->count; i++) {
        const char *variable = variable_names[study.study->which[i]];
        give(c, found, convergence_order(&study, i), "p_%s", variable);
        give(c, found, convergence_constant(&study, i), "c_%s", variable);
    }
    convergence_clear(&study);
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
