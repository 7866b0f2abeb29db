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

/* A table that is printed: proved until a ball does not decide its digits. */
struct study_run {
    const struct study_table *table;
    const struct derivations *steps;
    bool proved;
};

struct study_table {
    const char *name, *header;
    void (*print)(struct study_run *r);
    const char *first, *end; /* of guarantees: from that number on, to before this one, which end the header */
    const char *charges[8];  /* with each of these bounds of the charge over that at rest; none: without a bound */
};

/* A field after another; empty for NULL. */
static void print_field(struct study_run *r, const arb_t x, slong digits)
{
    char *text = x != NULL ? decimal_of_ball(x, digits) : NULL;
    printf(",%s", text != NULL ? text : "");
    r->proved = r->proved && (x == NULL || text != NULL);
    free(text);
}

/* ---- convergence ------------------------------------------------------- */

static void print_variable(struct study_run *r, const struct convergence *c, int variable)
{
    const struct study *s = c->study;
    for (int row = 0; row < s->rows; row++) {
        const int at = row * STUDIED + variable;
        char *parameter = decimal_of_rational(c->parameters + row, PARAMETER_DIGITS);
        printf("%s,%s,%s", s->name, variable_names[s->which[variable]], parameter);
        print_field(r, c->differences + at, STUDY_DIGITS);
        print_field(r, row > 0 ? c->orders + at : NULL, STUDY_DIGITS);
        print_field(r, c->constants + at, STUDY_DIGITS);
        puts(",certified");
        free(parameter);
    }
}

static void print_convergence(struct study_run *r)
{
    for (const struct study *s = studies; s->name != NULL && r->proved; s++) {
        struct convergence c;
        if (s->of_claims)
            continue;
        r->proved = convergence_init(&c, r->steps, s, 0);
        for (int i = 0; i < s->count && r->proved; i++)
            print_variable(r, &c, i);
        convergence_clear(&c);
    }
}

/* ---- motions beside the closed forms ----------------------------------- */

/* The simulation over six days, nonlinear and linear, and what the pitch of the moment leaves of psi and dL. */
static void print_forced(struct study_run *r)
{
    enum { STEP = 1200, LAST = 6 * 86400 };
    struct trajectory motion, linear;
    struct second_order o;
    VECTOR(arb, forced, FLOW_STATE);
    SCOPE(arb, z, dL);
    r->proved = trajectory_run(&motion, &(struct simulation){.steps = r->steps, .nonlinear = true}, 0, STEP, LAST);
    r->proved = trajectory_run(&linear, &(struct simulation){.steps = r->steps, .nonlinear = false}, 0, STEP, LAST) && r->proved;
    second_order_init(&o, r->steps, motion.c1, motion.c2, STUDY_BITS);
    for (slong k = 0; k < motion.count && r->proved; k++) {
        arb_srcptr samples[] = {trajectory_sample(&motion, k), trajectory_sample(&linear, k), forced};
        arb_mul_2exp_si(z, samples[0] + THETA_DOT, -1);
        arb_neg(z, z);
        second_order_at(forced, &o, samples[0] + THETA, z);
        printf("%ld", (long)k * STEP);
        for (int i = 0; i < 3; i++) {
            arb_mul(dL, samples[i] + ETA, motion.unit + ETA, STUDY_BITS);
            print_field(r, samples[i] + PSI, ROW_DIGITS);
            print_field(r, dL, ROW_DIGITS);
        }
        putchar('\n');
    }
    second_order_clear(&o);
    trajectory_clear(&motion);
    trajectory_clear(&linear);
}

/*
 * Pitch started on the closed form: 0.2 rad for 30 days, its amplitude and that of the slow law; and damped, by the law whose length
 * swings by 1/100 of itself, the paper's 0.01 rad for 20 days, beside its amplitude under (18).
 */
static void print_pitch(struct study_run *r)
{
    const bool damped = strcmp(r->table->name, "damped") == 0;
    const long step = damped ? 4 * HOUR : HOUR, last = damped ? 20 * DAY : 30 * DAY;
    struct simulation free = {.steps = r->steps, .nonlinear = true, .forced = true, .theta = damped ? NULL : "0.2"}, s = free;
    struct trajectory t, beside;
    SCOPE(arb, amplitude, law);
    s.swing = damped ? "0.01" : NULL;
    r->proved = trajectory_run(&t, &s, 0, step, last);
    r->proved = trajectory_run(&beside, &free, 0, step, damped ? last : 0) && r->proved;
    for (slong k = 0; k < t.count && r->proved; k++) {
        printf("%ld", (long)k * step);
        if (!damped)
            print_field(r, trajectory_sample(&t, k) + THETA, ROW_DIGITS);
        trajectory_value(amplitude, &t, k, AMPLITUDE);
        print_field(r, amplitude, ROW_DIGITS);
        trajectory_slow_law(law, &t, k);
        print_field(r, law, ROW_DIGITS);
        if (damped) {
            trajectory_value(amplitude, &beside, k, AMPLITUDE);
            print_field(r, amplitude, ROW_DIGITS);
        }
        putchar('\n');
    }
    trajectory_clear(&t);
    trajectory_clear(&beside);
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

/* The numbers of a table for those gains, or (NULL) their names. */
static void print_guarantees(struct study_run *r, arb_srcptr values)
{
    const int end = r->table->end != NULL ? guarantee_find(r->table->end) : GUARANTEES;
    for (int i = guarantee_find(r->table->first); i < end; i++)
        if (guarantees[i].meaning != NULL && values != NULL)
            print_field(r, values + i, ROW_DIGITS);
        else if (guarantees[i].meaning != NULL)
            printf(",%s", guarantees[i].name);
    putchar('\n');
}

static void print_gains(struct study_run *r)
{
    const char *const *charges = r->table->charges;
    const bool holds = guarantee_find(r->table->first) == 0;
    VECTOR(arb, values, GUARANTEES);
    SCOPE(arb, c1, c2, y);
    print_guarantees(r, NULL);
    for (int k = 0; k == 0 || charges[k] != NULL; k++)
        for (int gain = 0; gain < STUDY_GAINS; gain++) {
            const char *charge = charges[k];
            set_gains(c1, c2, study_gains[gain].c1, study_gains[gain].c2, STUDY_BITS);
            printf("%s", study_gains[gain].c1);
            print_field(r, c2, STUDY_DIGITS);
            if (charge != NULL) {
                printf(",%s", charge);
                arb_set_str(y, charge, STUDY_BITS);
                arb_sqr(y, y, STUDY_BITS);
                arb_root_ui(y, y, 3, STUDY_BITS);
            }
            r->proved = guarantees_enclose(values, holds ? r->steps : NULL, c1, c2, charge != NULL ? y : NULL, STUDY_BITS) && r->proved;
            print_guarantees(r, values);
        }
}

static void print_exact(const fmpq_t x)
{
    char *text = decimal_of_rational(x, ROW_DIGITS);
    printf(",%s", text);
    free(text);
}

/* At rest on the radius: 3 r^3 over the command 3 + n (r - 1), where that attracts, and the command over r^2 less 3 r; some are ties. */
static void print_balance(struct study_run *run)
{
    enum { FROM = 80, TO = 160 };
    static const slong gains[] = {10, 12, 20, 40};
    SCOPE(fmpq, r, command, force, push);
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
                print_field(run, NULL, ROW_DIGITS);
            print_exact(push);
            putchar('\n');
        }
}

static const struct study_table study_tables[] = {
    {"convergence", "study,variable,parameter,difference,order,constant,how\n", print_convergence, NULL, NULL, {NULL}},
    {"forced", "t,psi,dL,psi_linear,dL_linear,psi_forced,dL_forced\n", print_forced, NULL, NULL, {NULL}},
    {"pitch", "t,theta,amplitude,amplitude_law\n", print_pitch, NULL, NULL, {NULL}},
    {"damped", "t,amplitude,amplitude_law,amplitude_undamped\n", print_pitch, NULL, NULL, {NULL}},
    {"basin", "c1,c2", print_gains, "equilibrium", "deficit", {NULL}},
    {"saturation", "c1,c2,charge", print_gains, "outer", "q_max", {"1.02", "1.05", "1.1", "1.2", "1.5", "2"}},
    {"tolerance", "c1,c2", print_gains, "deficit", NULL, {NULL}},
    {"balance", "c1,rest,force,push\n", print_balance, NULL, NULL, {NULL}},
    {"sampling", "c1,c2", print_gains, "hold", "equilibrium", {NULL}},
};

int command_study(const struct arguments *a)
{
    struct derivations steps;
    struct message why;
    struct study_run r = {study_tables, &steps, true};
    while (strcmp(r.table->name, a->words[0]) != 0)
        r.table++;
    if (derivations_open(&steps, a->paper, &why) != 0)
        return usage_error(EXIT_FAILED_CHECK, "%s", why.text);
    fputs(r.table->header, stdout);
    r.table->print(&r);
    derivations_clear(&steps);
    return r.proved ? EXIT_DONE : usage_error(EXIT_FAILED_CHECK, "study %s: digits undecided", r.table->name);
}
