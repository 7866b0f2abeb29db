/* At what order approximations and closed forms err, by the studies of convergence.h; and the closed form's numbers. */
#include "claims/claim.h"
#include "claims/convergence.h"
#include "claims/second_order.h"
#include "text/scope.h"

/*
 * Of a study: orders, differences (in SI) and constants of its last row, p_VARIABLE, d_VARIABLE, c_VARIABLE, and
 * `worst`, the most that an order is off; a study of claims is computed whole, p_VARIABLE_1 and so on its rows', the
 * first being 0, `worst_of_all` of all.
 */
static void run_study(struct computed *c)
{
    const struct study *s = study_find(c->of->name);
    const int last = s->rows - 1, from = s->of_claims ? 0 : last - 1;
    struct convergence study;
    SCOPE(arb, worst);
    const bool found = convergence_init(&study, c->steps, s, from);
    for (int i = 0; i < s->count; i++) {
        const char *variable = variable_names[s->which[i]];
        for (int row = from; row < s->rows; row++) {
            const int at = row * STUDIED + i;
            give(c, CERTIFIED, found && row > from, study.orders + at, "p_%s_%d", variable, row);
            give(c, CERTIFIED, found, study.differences + at, "d_%s_%d", variable, row);
        }
        give(c, CERTIFIED, found, study.orders + last * STUDIED + i, "p_%s", variable);
        give(c, CERTIFIED, found, study.constants + last * STUDIED + i, "c_%s", variable);
    }
    convergence_worst(worst, &study, last, last);
    give(c, CERTIFIED, found, worst, "worst");
    convergence_worst(worst, &study, 1, last);
    give(c, CERTIFIED, found && s->of_claims, worst, "worst_of_all");
    convergence_clear(&study);
}

/* |A|, |B| of the closed form, and the coefficients of the slow law, for the gains (43), (44) of some n; n = 11.8 as 118. */
static void forced_response(struct computed *c)
{
    enum { BITS = 192 };
    static const char *const gains[] = {"10", "11.8", "12"}, *const names[] = {"10", "118", "12"};
    SCOPE(arb, size);
    for (int i = 0; i < 3; i++) {
        struct second_order o;
        struct trajectory t;
        const bool ready = trajectory_run(&t, &(struct simulation){.steps = c->steps, .n = gains[i]}, 0, 1, 0);
        second_order_init(&o, c->steps, t.c1, t.c2, NULL, BITS);
        arb_hypot(size, second_order_get(&o, "A_re"), second_order_get(&o, "A_im"), BITS);
        give(c, CERTIFIED, ready, size, "length_%s", names[i]);
        arb_hypot(size, second_order_get(&o, "B_re"), second_order_get(&o, "B_im"), BITS);
        give(c, CERTIFIED, ready, size, "yaw_%s", names[i]);
        give(c, CERTIFIED, ready, second_order_get(&o, "decay"), "decay_%s", names[i]);
        give(c, CERTIFIED, ready, second_order_get(&o, "shift"), "shift_%s", names[i]);
        second_order_clear(&o);
        trajectory_clear(&t);
    }
}

#define STUDY_ANGLES(before, after) " " before "psi" after " " before "theta" after " " before "dL" after
#define STUDY_TETHER STUDY_ANGLES("p_", "") STUDY_ANGLES("p_", "_dot")
#define STEPS "worst_of_all" STUDY_ANGLES("p_", "_1") STUDY_ANGLES("p_", "_2") STUDY_ANGLES("p_", "_3")
#define ORBIT STUDY_ANGLES("d_", "_0") " d_x1_0 d_y1_0 d_z1_0"

const struct computation computations_studies[] = {
    {"linear_43200s", run_study, "worst" STUDY_TETHER, NULL},
    {"linear_172800s", run_study, "worst" STUDY_TETHER, NULL},
    {"linear_pitch_172800s", run_study, "worst" STUDY_TETHER, NULL},
    {"rk4_nonlinear_24000s", run_study, "worst" STUDY_TETHER, NULL},
    {"hill_43200s", run_study, "worst", NULL},
    {"hill_unequal_43200s", run_study, "worst", NULL},
    {"forced_43200s", run_study, "worst" STUDY_TETHER, NULL},
    {"slow_law", run_study, "worst p_amplitude p_phase c_amplitude c_phase", NULL},
    {"rk4_linear_day", run_study, STEPS, NULL},
    {"rk4_nonlinear_day", run_study, STEPS, NULL},
    {"linear_day", run_study, "worst" STUDY_ANGLES("p_", "") STUDY_ANGLES("c_", "") " p_x1 p_y1 p_z1 c_x1 c_y1 c_z1", NULL},
    {"forced_10", run_study, "worst" STUDY_ANGLES("p_", "") STUDY_ANGLES("d_", "_0"), NULL},
    {"forced_12", run_study, "worst" STUDY_ANGLES("p_", "") STUDY_ANGLES("d_", "_0"), NULL},
    {"hill_in_orbit", run_study, ORBIT, NULL},
    {"hill_unequal_in_orbit", run_study, ORBIT, NULL},
    {"forced_response", forced_response,
     "length_10 yaw_10 decay_10 shift_10 length_118 yaw_118 decay_118 shift_118 length_12 yaw_12 decay_12 shift_12", NULL},
    {NULL, NULL, NULL, NULL},
};
