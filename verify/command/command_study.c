/* coulomb-tether study: what the edition adds to the paper's figures, as CSV. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "claims/convergence.h"
#include "claims/guarantee.h"
#include "claims/sampling.h"
#include "claims/second_order.h"
#include "command/command.h"
#include "proof/derivation.h"
#include "text/decimal.h"
#include "text/scope.h"

enum { PARAMETER_DIGITS = 4, STUDY_DIGITS = 6, ROW_DIGITS = 12, STUDY_BITS = 192 };

/* A table: its header, or what makes it, and what prints its rows; false where a ball does not decide its digits. */
struct study_table {
    const char *name, *header;
    bool (*print)(const struct study_table *t, const struct derivations *steps);
    const char *first, *end;  /* of guarantees: from that number on, to before this one, */
    const char *charges[8];   /* with each of these bounds of the charge over that at rest; none: without a bound */
};

/* A field after another; empty for NULL. */
static bool print_field(const arb_t x, slong digits)
{
    char *text = x != NULL ? decimal_of_ball(x, digits) : NULL;
    printf(",%s", text != NULL ? text : "");
    const bool decided = x == NULL || text != NULL;
    free(text);
    return decided;
}

static bool end_row(bool proved)
{
    putchar('\n');
    return proved;
}

/* ---- convergence ------------------------------------------------------- */

static bool print_variable(const struct convergence *c, int variable)
{
    const struct study *s = c->study;
    bool decided = true;
    for (int row = 0; row < s->rows; row++) {
        const int at = row * STUDIED + variable;
        char *parameter = decimal_of_rational(c->parameters + row, PARAMETER_DIGITS);
        printf("%s,%s,%s", s->name, variable_names[s->which[variable]], parameter);
        decided = print_field(c->differences + at, STUDY_DIGITS) && decided;
        decided = print_field(row > 0 ? c->orders + at : NULL, STUDY_DIGITS) && decided;
        decided = print_field(c->constants + at, STUDY_DIGITS) && decided;
        puts(",certified");
        free(parameter);
    }
    return decided;
}

static bool print_convergence(const struct study_table *t, const struct derivations *steps)
{
    bool decided = true;
    (void)t;
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

static bool print_error(const arb_t eta, const struct trajectory *t)
{
    SCOPE(arb, dL);
    arb_mul(dL, eta, t->L_ref, STUDY_BITS);
    return print_field(dL, ROW_DIGITS);
}

/* The simulation over six days, nonlinear and linear, and what the pitch of the moment leaves of psi and dL. */
static bool print_forced(const struct study_table *table, const struct derivations *steps)
{
    enum { STEP = 1200, LAST = 6 * 86400 };
    struct trajectory motion, linear;
    struct second_order o;
    VECTOR(arb, forced, FLOW_STATE);
    SCOPE(arb, z);
    (void)table;
    bool proved = trajectory_run(&motion, &(struct simulation){.steps = steps, .nonlinear = true}, 0, STEP, LAST);
    proved = trajectory_run(&linear, &(struct simulation){.steps = steps, .nonlinear = false}, 0, STEP, LAST) && proved;
    second_order_init(&o, steps, motion.c1, motion.c2, STUDY_BITS);
    for (slong k = 0; k < motion.count && proved; k++) {
        arb_srcptr samples[] = {trajectory_sample(&motion, k), trajectory_sample(&linear, k), forced};
        arb_mul_2exp_si(z, samples[0] + THETA_DOT, -1);
        arb_neg(z, z);
        second_order_at(forced, &o, samples[0] + THETA, z);
        printf("%ld", (long)k * STEP);
        for (int i = 0; i < 3; i++)
            proved = print_field(samples[i] + PSI, ROW_DIGITS) && print_error(samples[i] + ETA, &motion) && proved;
        end_row(proved);
    }
    second_order_clear(&o);
    trajectory_clear(&motion);
    trajectory_clear(&linear);
    return proved;
}

static bool print_amplitude(const struct trajectory *t, slong k)
{
    SCOPE(arb, amplitude);
    trajectory_value(amplitude, t, k, AMPLITUDE);
    return print_field(amplitude, ROW_DIGITS);
}

/*
 * Pitch started on the closed form: 0.2 rad for 30 days, its amplitude and that of the slow law; and damped, by the law whose length
 * swings by 1/100 of itself, the paper's 0.01 rad for 20 days, beside its amplitude under (18).
 */
static bool print_pitch(const struct study_table *table, const struct derivations *steps)
{
    const bool damped = strcmp(table->name, "damped") == 0;
    const long step = damped ? 4 * HOUR : HOUR, last = damped ? 20 * DAY : 30 * DAY;
    struct simulation free = {.steps = steps, .nonlinear = true, .forced = true, .theta = damped ? NULL : "0.2"}, s = free;
    struct trajectory t, beside;
    SCOPE(arb, law);
    s.swing = damped ? "0.01" : NULL;
    bool proved = trajectory_run(&t, &s, 0, step, last);
    proved = trajectory_run(&beside, &free, 0, step, damped ? last : 0) && proved;
    for (slong k = 0; k < t.count && proved; k++) {
        printf("%ld", (long)k * step);
        if (!damped)
            proved = print_field(trajectory_sample(&t, k) + THETA, ROW_DIGITS);
        trajectory_slow_law(law, &t, k);
        proved = print_amplitude(&t, k) && print_field(law, ROW_DIGITS) && proved;
        if (damped)
            proved = print_amplitude(&beside, k) && proved;
        end_row(proved);
    }
    trajectory_clear(&t);
    trajectory_clear(&beside);
    return proved;
}

/* ---- over the gains, in radians of orbit and L_ref ---------------------- */

static const struct {
    const char *c1, *c2; /* c2 = NULL: by (44) */
} study_gains[] = {
    {"9.5", NULL}, {"10", NULL}, {"10.5", NULL}, {"11", NULL}, {"11.5", NULL}, {"12", NULL}, {"12", "4"},
    {"13", NULL},  {"14", NULL}, {"15", NULL},   {"16", NULL}, {"18", NULL},   {"20", NULL}, {"22", NULL},
    {"24", NULL},  {"28", NULL}, {"32", NULL},   {"36", NULL}, {"40", NULL},
};
enum { STUDY_GAINS = sizeof study_gains / sizeof *study_gains };

static bool print_gains(const struct study_table *t, const struct derivations *steps)
{
    const int first = guarantee_find(t->first), end = t->end != NULL ? guarantee_find(t->end) : GUARANTEES;
    bool proved = true;
    VECTOR(arb, values, GUARANTEES);
    SCOPE(arb, c1, c2, y);
    fputs(t->charges[0] != NULL ? "c1,c2,charge" : "c1,c2", stdout);
    for (int i = first; i < end; i++)
        if (guarantees[i].meaning != NULL)
            printf(",%s", guarantees[i].name);
    end_row(proved);
    for (int k = 0; k == 0 || t->charges[k] != NULL; k++)
        for (int gain = 0; gain < STUDY_GAINS; gain++) {
            const char *charge = t->charges[k];
            set_gains(c1, c2, study_gains[gain].c1, study_gains[gain].c2, STUDY_BITS);
            printf("%s", study_gains[gain].c1);
            proved = print_field(c2, STUDY_DIGITS) && proved;
            if (charge != NULL) {
                printf(",%s", charge);
                arb_set_str(y, charge, STUDY_BITS);
                arb_sqr(y, y, STUDY_BITS);
                arb_root_ui(y, y, 3, STUDY_BITS);
            }
            proved = guarantees_enclose(values, first == 0 ? steps : NULL, c1, c2, charge != NULL ? y : NULL, STUDY_BITS) && proved;
            for (int i = first; i < end; i++)
                if (guarantees[i].meaning != NULL)
                    proved = print_field(values + i, ROW_DIGITS) && proved;
            end_row(proved);
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
static bool print_balance(const struct study_table *t, const struct derivations *steps)
{
    enum { FROM = 80, TO = 160 };
    static const slong gains[] = {10, 12, 20, 40};
    SCOPE(fmpq, r, command, force, push);
    (void)t;
    (void)steps;
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

static const struct study_table study_tables[] = {
    {"convergence", "study,variable,parameter,difference,order,constant,how", print_convergence, NULL, NULL, {NULL}},
    {"forced", "t,psi,dL,psi_linear,dL_linear,psi_forced,dL_forced", print_forced, NULL, NULL, {NULL}},
    {"pitch", "t,theta,amplitude,amplitude_law", print_pitch, NULL, NULL, {NULL}},
    {"damped", "t,amplitude,amplitude_law,amplitude_undamped", print_pitch, NULL, NULL, {NULL}},
    {"basin", NULL, print_gains, "equilibrium", "deficit", {NULL}},
    {"saturation", NULL, print_gains, "outer", "q_max", {"1.02", "1.05", "1.1", "1.2", "1.5", "2"}},
    {"tolerance", NULL, print_gains, "deficit", NULL, {NULL}},
    {"balance", "c1,rest,force,push", print_balance, NULL, NULL, {NULL}},
    {"sampling", NULL, print_gains, "hold", "equilibrium", {NULL}},
};

int command_study(const struct arguments *a)
{
    enum { TABLES = sizeof study_tables / sizeof *study_tables };
    struct derivations steps;
    struct message why;
    int i = 0;
    while (i < TABLES - 1 && strcmp(study_tables[i].name, a->words[0]) != 0)
        i++;
    if (derivations_open(&steps, a->paper, &why) != 0)
        return usage_error(EXIT_FAILED_CHECK, "%s", why.text);
    if (study_tables[i].header != NULL)
        puts(study_tables[i].header);
    const bool proved = study_tables[i].print(&study_tables[i], &steps);
    derivations_clear(&steps);
    return proved ? EXIT_DONE : usage_error(EXIT_FAILED_CHECK, "study %s: digits undecided", a->words[0]);
}
