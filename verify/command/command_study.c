/* coulomb-tether study: what the edition adds to the paper's figures, as CSV. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "claims/convergence.h"
#include "claims/second_order.h"
#include "command/command.h"
#include "proof/proof_results.h"
#include "text/decimal.h"
#include "text/scope.h"

enum { PARAMETER_DIGITS = 4, STUDY_DIGITS = 6, ROW_DIGITS = 12, STUDY_BITS = 192 };

/*
 * The numbers of a row after its first, an empty field for NULL; false where a ball does not decide its digits.
 */
static bool print_study_numbers(const arb_srcptr *x, int count, slong digits)
{
    bool decided = true;
    for (int i = 0; i < count; i++) {
        char *text = x[i] != NULL ? decimal_of_ball(x[i], digits) : NULL;
        printf(",%s", text != NULL ? text : "");
        decided = decided && (x[i] == NULL || text != NULL);
        free(text);
    }
    return decided;
}

/* ---- convergence ------------------------------------------------------- */

static bool print_variable(const struct convergence *c, int variable)
{
    const struct study *s = c->study;
    bool decided = true;
    for (int row = 0; row < s->rows; row++) {
        const int at = row * STUDIED + variable;
        arb_srcptr numbers[] = {c->differences + at, row > 0 ? c->orders + at : NULL, c->constants + at};
        char *parameter = decimal_of_rational(c->parameters + row, PARAMETER_DIGITS);
        printf("%s,%s,%s", s->name, variable_names[s->which[variable]], parameter);
        decided = print_study_numbers(numbers, 3, STUDY_DIGITS) && decided;
        puts(",certified");
        free(parameter);
    }
    return decided;
}

static bool print_convergence(const struct derivations *steps)
{
    bool decided = true;
    puts("study,variable,parameter,difference,order,constant,how");
    for (const struct study *s = studies; s->name != NULL && decided; s++) {
        struct convergence c;
        if (s->of_claims)
            continue;
        decided = convergence_init(&c, steps, s, 0);
        for (int i = 0; i < s->count && decided; i++)
            decided = print_variable(&c, i);
        convergence_clear(&c);
    }
    return decided;
}

/* ---- motions beside the closed forms ----------------------------------- */

/* The simulation over six days, nonlinear and linear, and what the pitch of the moment leaves of psi and dL. */
static bool print_forced(const struct derivations *steps)
{
    enum { STEP = 1200, LAST = 6 * 86400 };
    struct trajectory motion, linear;
    struct second_order o;
    VECTOR(arb, forced, FLOW_STATE);
    VECTOR(arb, dL, 3);
    SCOPE(arb, z);
    bool proved = trajectory_run(&motion, &(struct simulation){.steps = steps, .nonlinear = true}, 0, STEP, LAST);
    proved = trajectory_run(&linear, &(struct simulation){.steps = steps, .nonlinear = false}, 0, STEP, LAST) && proved;
    second_order_init(&o, steps, motion.c1, motion.c2, STUDY_BITS);
    puts("t,psi,dL,psi_linear,dL_linear,psi_forced,dL_forced");
    for (slong k = 0; k < motion.count && proved; k++) {
        arb_srcptr row = trajectory_sample(&motion, k), other = trajectory_sample(&linear, k);
        arb_mul_2exp_si(z, row + THETA_DOT, -1);
        arb_neg(z, z);
        second_order_at(forced, &o, row + THETA, z);
        arb_mul(dL, row + ETA, motion.L_ref, STUDY_BITS);
        arb_mul(dL + 1, other + ETA, motion.L_ref, STUDY_BITS);
        arb_mul(dL + 2, forced + ETA, motion.L_ref, STUDY_BITS);
        arb_srcptr numbers[] = {row + PSI, dL, other + PSI, dL + 1, forced + PSI, dL + 2};
        printf("%ld", (long)k * STEP);
        proved = print_study_numbers(numbers, 6, ROW_DIGITS);
        putchar('\n');
    }
    second_order_clear(&o);
    trajectory_clear(&motion);
    trajectory_clear(&linear);
    return proved;
}

/* A pitch of 0.2 rad, started on the closed form, for 30 days: its amplitude, and that of the slow law. */
static bool print_pitch(const struct derivations *steps)
{
    enum { STEP = 3600, LAST = 30 * 86400 };
    struct trajectory t;
    struct second_order o;
    VECTOR(arb, start, FLOW_STATE);
    SCOPE(arb, a, tau, law, shift, amplitude);
    bool proved = trajectory_run(&t, &(struct simulation){.steps = steps, .nonlinear = true}, 0, 1, 0);
    second_order_init(&o, steps, t.c1, t.c2, STUDY_BITS);
    trajectory_clear(&t);
    arb_set_ui(a, 5);
    arb_inv(a, a, STUDY_BITS);
    second_order_after(start, &o, a, tau);
    proved = trajectory_run(&t, &(struct simulation){.steps = steps, .nonlinear = true, .start = start}, 0, STEP, LAST) && proved;
    puts("t,theta,amplitude,amplitude_law");
    for (slong k = 0; k < t.count && proved; k++) {
        arb_srcptr numbers[] = {trajectory_sample(&t, k) + THETA, amplitude, law};
        trajectory_value(amplitude, &t, k, AMPLITUDE);
        arb_mul_si(tau, t.Omega, k * STEP, STUDY_BITS);
        slow_law(law, shift, &o, a, tau);
        arb_mul(law, law, a, STUDY_BITS);
        printf("%ld", (long)k * STEP);
        proved = print_study_numbers(numbers, 3, ROW_DIGITS);
        putchar('\n');
    }
    second_order_clear(&o);
    trajectory_clear(&t);
    return proved;
}

int command_study(const struct arguments *a)
{
    static const char *const names[] = {"convergence", "forced", "pitch"};
    static bool (*const prints[])(const struct derivations *) = {print_convergence, print_forced, print_pitch};
    char hint[80];
    if (a->word_count == 0)
        return usage_error(EXIT_USAGE, "study: expected convergence, forced or pitch");
    for (int i = 0; i < 3; i++)
        if (strcmp(names[i], a->words[0]) == 0) {
            struct derivations steps;
            struct message why;
            if (derivations_open(&steps, a->paper, &why) != 0)
                return usage_error(EXIT_FAILED_CHECK, "%s", why.text);
            bool proved = prints[i](&steps);
            derivations_clear(&steps);
            int written = output_finished();
            return written != EXIT_DONE || proved ? written
                                                  : usage_error(EXIT_FAILED_CHECK, "study %s: digits undecided", names[i]);
        }
    suggest(hint, a->words[0], names, 3);
    return usage_error(EXIT_USAGE, "study: expected convergence, forced or pitch, got '%s'%s", a->words[0], hint);
}
