/* coulomb-tether study: what the edition adds to the paper's figures, as CSV. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "claims/convergence.h"
#include "claims/guarantee.h"
#include "claims/sampling.h"
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
    second_order_init(&o, steps, motion.c1, motion.c2, NULL, STUDY_BITS);
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
    second_order_init(&o, steps, t.c1, t.c2, NULL, STUDY_BITS);
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

/* ---- what the energy guarantees, in radians of orbit and L_ref ---------- */

static const struct {
    const char *c1, *c2; /* c2 = NULL: by (44) */
} guaranteed_gains[] = {
    {"9.5", NULL}, {"10", NULL}, {"10.5", NULL}, {"11", NULL}, {"11.5", NULL}, {"12", NULL}, {"12", "4"},
    {"13", NULL},  {"14", NULL}, {"15", NULL},   {"16", NULL}, {"18", NULL},   {"20", NULL}, {"22", NULL},
    {"24", NULL},  {"28", NULL}, {"32", NULL},   {"36", NULL}, {"40", NULL},
};

static void set_study_gains(arb_t c1, arb_t c2, size_t gain)
{
    const char *text = guaranteed_gains[gain].c2;
    arb_set_str(c1, guaranteed_gains[gain].c1, STUDY_BITS);
    arb_sub_ui(c2, c1, 9, STUDY_BITS);
    arb_sqrt(c2, c2, STUDY_BITS);
    arb_mul_2exp_si(c2, c2, 1);
    if (text != NULL)
        arb_set_str(c2, text, STUDY_BITS);
}

/* c1, c2; the bound of the charge over the charge at rest, if there is one; and the numbers from `first` to before `end`. */
static bool print_guaranteed(size_t gain, const char *charge, const char *first, const char *end)
{
    VECTOR(arb, values, GUARANTEES);
    SCOPE(arb, c1, c2, y);
    arb_srcptr numbers[GUARANTEES];
    int count = 0;
    set_study_gains(c1, c2, gain);
    if (charge != NULL) {
        arb_set_str(y, charge, STUDY_BITS);
        arb_sqr(y, y, STUDY_BITS);
        arb_root_ui(y, y, 3, STUDY_BITS);
    }
    bool proved = guarantees_enclose(values, c1, charge != NULL ? y : NULL, STUDY_BITS);
    for (int i = guarantee_find(first); guarantees[i].name != NULL && strcmp(guarantees[i].name, end) != 0; i++)
        if (guarantees[i].meaning != NULL)
            numbers[count++] = values + i;
    printf("%s", guaranteed_gains[gain].c1);
    arb_srcptr second = c2;
    proved = print_study_numbers(&second, 1, STUDY_DIGITS) && proved;
    if (charge != NULL)
        printf(",%s", charge);
    proved = print_study_numbers(numbers, count, ROW_DIGITS) && proved;
    putchar('\n');
    return proved;
}

static bool print_guarantees(const char *const *charges, int charge_count, const char *first, const char *end)
{
    bool proved = true;
    fputs(charges[0] != NULL ? "c1,c2,charge" : "c1,c2", stdout);
    for (int i = guarantee_find(first); guarantees[i].name != NULL && strcmp(guarantees[i].name, end) != 0; i++)
        if (guarantees[i].meaning != NULL)
            printf(",%s", guarantees[i].name);
    putchar('\n');
    for (int k = 0; k < charge_count; k++)
        for (size_t gain = 0; gain < sizeof guaranteed_gains / sizeof *guaranteed_gains; gain++)
            proved = print_guaranteed(gain, charges[k], first, end) && proved;
    return proved;
}

static bool print_basin(const struct derivations *steps)
{
    static const char *const unbounded[] = {NULL};
    (void)steps;
    return print_guarantees(unbounded, 1, "equilibrium", "deficit");
}

static bool print_saturation(const struct derivations *steps)
{
    static const char *const charges[] = {"1.02", "1.05", "1.1", "1.2", "1.5", "2"};
    (void)steps;
    return print_guarantees(charges, 6, "outer", "q_max");
}

static bool print_tolerance(const struct derivations *steps)
{
    static const char *const unbounded[] = {NULL};
    (void)steps;
    return print_guarantees(unbounded, 1, "deficit", "");
}

/* How long the law may be held, and how late it may act, in radians of orbit. */
static bool print_sampling(const struct derivations *steps)
{
    bool proved = true;
    SCOPE(arb, c1, c2, hold, delay);
    (void)steps;
    puts("c1,c2,hold,delay");
    for (size_t gain = 0; gain < sizeof guaranteed_gains / sizeof *guaranteed_gains; gain++) {
        arb_srcptr second = c2, numbers[] = {hold, delay};
        set_study_gains(c1, c2, gain);
        largest_hold(hold, c1, c2, STUDY_BITS);
        largest_delay(delay, c1, c2, STUDY_BITS);
        printf("%s", guaranteed_gains[gain].c1);
        proved = print_study_numbers(&second, 1, STUDY_DIGITS) && proved;
        proved = print_study_numbers(numbers, 2, ROW_DIGITS) && proved;
        putchar('\n');
    }
    return proved;
}

static void print_exact(const fmpq_t x)
{
    char *text = decimal_of_rational(x, ROW_DIGITS);
    printf(",%s", text);
    free(text);
}

/* At rest on the radius: 3 r^3 over the command 3 + n (r - 1), where that attracts, and the command over r^2 less 3 r. */
static bool print_balance(const struct derivations *steps)
{
    enum { FROM = 80, TO = 160 };
    static const slong gains[] = {10, 12, 20, 40};
    SCOPE(fmpq, r, command, force, push);
    (void)steps;
    puts("c1,rest,force,push");
    for (int i = 0; i < 4; i++)
        for (slong hundredths = FROM; hundredths <= TO; hundredths++) {
            fmpq_set_si(r, hundredths, 100);
            fmpq_sub_si(command, r, 1);
            fmpq_mul_si(command, command, gains[i]);
            fmpq_add_si(command, command, 3);
            fmpq_pow_si(force, r, 3);
            fmpq_mul_si(force, force, 3);
            fmpq_sub(push, command, force);
            fmpq_div(push, push, r);
            fmpq_div(push, push, r);
            printf("%ld,%ld.%02ld", (long)gains[i], (long)(hundredths / 100), (long)(hundredths % 100));
            if (fmpq_sgn(command) > 0) {
                fmpq_div(force, force, command);
                print_exact(force);
            } else
                putchar(',');
            print_exact(push);
            putchar('\n');
        }
    return true;
}

int command_study(const struct arguments *a)
{
    static const struct {
        const char *name;
        bool (*print)(const struct derivations *);
    } tables[] = {
        {"convergence", print_convergence}, {"forced", print_forced}, {"pitch", print_pitch}, {"basin", print_basin},
        {"saturation", print_saturation}, {"tolerance", print_tolerance}, {"balance", print_balance}, {"sampling", print_sampling},
    };
    enum { TABLES = sizeof tables / sizeof *tables };
    static const char expected[] = "study: expected convergence, forced, pitch, basin, saturation, tolerance, balance or sampling, got";
    const char *name = a->word_count > 0 ? a->words[0] : "";
    for (int i = 0; i < TABLES; i++)
        if (strcmp(tables[i].name, name) == 0) {
            struct derivations steps;
            struct message why;
            if (derivations_open(&steps, a->paper, &why) != 0)
                return usage_error(EXIT_FAILED_CHECK, "%s", why.text);
            bool proved = tables[i].print(&steps);
            derivations_clear(&steps);
            return proved ? EXIT_DONE : usage_error(EXIT_FAILED_CHECK, "study %s: digits undecided", name);
        }
    return unknown_name(expected, name, NEAREST(name, tables, TABLES, name));
}
