/* coulomb-tether design: what one decides with, every digit proved. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "claims/guarantee.h"
#include "command/command_motion.h"
#include "proof/identities.h"
#include "text/decimal.h"
#include "text/scope.h"

/* A number of the sheet: a formula of the names before it, or ID.OUTPUT of an equation whose inputs they are. */
struct design_row {
    const char *group; /* "": not printed; NULL: that of the last row */
    const char *name, *unit, *formula, *meaning;
};

static const struct design_row design_rows[] = {
    {"", "L", "m", "L_ref", ""},
    {"", "dQ", "C^2", "0", ""},
    {"", "u", "-", "L_ref*inverse_debye", ""},
    {"", "spare", "-", "u*debye - 1", ""},
    {"gains of the law (18)", "C1", "1/s^2", "C1", "of the length error"},
    {NULL, "C2", "1/s", "C2", "of its rate"},
    {NULL, "c1", "-", "C1/Omega^2", "C1 over Omega^2, which is n by (43)"},
    {NULL, "c2", "-", "C2/Omega", "C2 over Omega"},
    {"rest at L_ref", "Q_ref", "C^2", "eq07.Q_ref", "charge product"},
    {NULL, "q1", "C", "eq21.q1", "charge of craft 1"},
    {NULL, "q2", "C", "eq21.q2", "charge of craft 2"},
    {NULL, "x1", "m", "eq05.x1", "place of craft 1 on the radius"},
    {NULL, "x2", "m", "eq05.x2", "place of craft 2 there"},
    {"roots of (41), yaw and length error, the fastest decay first", "re1", "1/s", "re1", "fastest decay"},
    {NULL, "im1", "rad/s", "im1", "its frequency"},
    {NULL, "re2", "1/s", "re2", ""},
    {NULL, "im2", "rad/s", "im2", ""},
    {NULL, "re3", "1/s", "re3", ""},
    {NULL, "im3", "rad/s", "im3", ""},
    {NULL, "re4", "1/s", "re4", "slowest decay"},
    {NULL, "im4", "rad/s", "im4", "its frequency"},
    {NULL, "t_fast", "s", "-1/re1", "time in which the fastest falls to 1/e"},
    {NULL, "t_slow", "s", "-1/re4", "time in which the slowest falls to 1/e"},
    {"frequencies, each motion by itself", "w_theta", "rad/s", "2*Omega", "pitch, which no gain damps"},
    {NULL, "w_psi", "rad/s", "sqrt(3)*Omega", "yaw"},
    {NULL, "w_dL", "rad/s", "sqrt(C1 - 9*Omega^2)", "length error"},
    {"sampling, by the linear model", "T", "s", "hold/Omega", "the law may be held for any time below this one"},
    {NULL, "d", "s", "delay/Omega", "the law may act late by any time below this one"},
    {"screening at lambda_d", "lost", "-", "1 - (1 + u)*exp(-u)", "part of the force that is missing"},
};
enum { DESIGN_ROWS = sizeof design_rows / sizeof *design_rows };

/* What they start from beside the sheet's quantities: 1/lambda_d, and what is guaranteed, in radians of orbit and L_ref. */
enum { INVERSE_DEBYE, GUARANTEED, DESIGN_INPUTS = GUARANTEED + GUARANTEES };

struct design {
    struct derivations steps;
    struct scenario scenario;
    struct input lambda_d;
    struct identities formulas;
    struct number numbers[DESIGN_ROWS + GUARANTEES];
    int nodes[DESIGN_ROWS + GUARANTEES], count;
};

/* ---- numbers ---- */

static void add_number(struct design *d, const char *group, const char *name, const char *unit,
                       const char *meaning, const char *formula)
{
    const int node = identities_text(&d->formulas, NULL, formula, 0);
    program_name(&d->formulas.program, node, name);
    if (*group != '\0') {
        d->nodes[d->count] = node;
        d->numbers[d->count++] = (struct number){group, name, unit, meaning, NULL};
    }
}

/* The rows, then what the energy guarantees, in SI. */
static void design_formulas(struct design *d)
{
    static const struct definitions none;
    const char *names[DESIGN_INPUTS] = {"inverse_debye"}, *group = "";
    const struct scope scope = {.sheet = d->scenario.sheet, .definitions = &none, .names = names, .name_count = DESIGN_INPUTS};
    for (int i = 0; i < GUARANTEES; i++)
        names[GUARANTEED + i] = guarantees[i].name;
    identities_open(&d->formulas, &scope);
    for (int i = 0; i < DESIGN_ROWS; i++) {
        const struct design_row *r = &design_rows[i];
        group = r->group != NULL ? r->group : group;
        add_number(d, group, r->name, r->unit, r->meaning, r->formula);
    }
    group = "basin of rest at L_ref, by the energy of the nonlinear model without screening";
    for (int i = guarantee_find("equilibrium"); i < GUARANTEES; i++) {
        const struct guarantee *g = &guarantees[i];
        char formula[64];
        snprintf(formula, sizeof formula, "%s*L_ref^%d*Omega^%d", g->name, g->lengths, g->rates);
        if (strcmp(g->name, "deficit") == 0)
            group = "errors that stay and are borne, by the nonlinear model: of the force (charges, k_c, masses); pushes of one "
                    "craft against the other";
        if (g->meaning != NULL)
            add_number(d, group, g->name, g->unit, g->meaning, formula);
    }
}

static void enclose_inputs(struct machine *m, const struct scenario *s, const struct derivations *steps, const struct input *lambda_d, slong prec)
{
    static const char *const names[] = {"Omega", "k_c", "m1", "m2", "L_ref", "C1", "C2"}; /* of a flow's parameters */
    static const char *const root_names[][2] = {{"re1", "im1"}, {"re2", "im2"}, {"re3", "im3"}, {"re4", "im4"}};
    const int first = m->program->inputs - DESIGN_INPUTS;
    FLOW_PARAMETERS(p);
    SCOPE(arb, c1, c2);
    VECTOR(acb, roots, 4);
    VECTOR(arb, guaranteed, GUARANTEES);
    scenario_parameters(&p, s, prec);
    for (size_t i = 0; i < sizeof names / sizeof *names; i++)
        arb_set(machine_value(m, program_find(m->program, names[i])), p.Omega + i);
    const bool isolated = scenario_roots(roots, s, prec);
    for (int i = 0; i < 4; i++) {
        if (!isolated)
            acb_indeterminate(roots + i); /* LCOV_EXCL_LINE: only where two roots meet at gains that are not rational */
        acb_get_real(machine_value(m, program_find(m->program, root_names[i][0])), roots + i);
        acb_get_imag(machine_value(m, program_find(m->program, root_names[i][1])), roots + i);
    }
    if (!lambda_d->infinite) {
        arb_set_fmpq(machine_value(m, first + INVERSE_DEBYE), &lambda_d->value, prec);
        arb_inv(machine_value(m, first + INVERSE_DEBYE), machine_value(m, first + INVERSE_DEBYE), prec);
    }
    flow_gains(c1, c2, &p, prec);
    guarantees_enclose(guaranteed, steps, c1, c2, NULL, prec);
    for (int i = 0; i < GUARANTEES; i++)
        arb_set(machine_value(m, first + GUARANTEED + i), guaranteed + i);
}

/* Every digit of every number, by more and more bits; else the first number that stays open, or there is no rest. */
static int find_digits(struct design *d, slong digits)
{
    const slong first = 7 * digits + 128, most = 4 * first; /* a double root has half of them */
    int open = 0;
    bool rests = true;
    for (slong prec = first; prec <= most && open < d->count; prec *= 2) {
        struct machine m;
        SCOPE(arb, z);
        machine_init(&m, &d->formulas.program, &arithmetic_ball, prec);
        enclose_inputs(&m, &d->scenario, &d->steps, &d->lambda_d, prec);
        machine_run(&m);
        rests = !arb_is_positive(machine_value(&m, program_find(&d->formulas.program, "spare")));
        for (int i = 0; i < d->count; i++)
            if (d->numbers[i].value == NULL) {
                arb_set(z, machine_value(&m, d->nodes[i]));
                d->numbers[i].value = decimal_of_ball(z, digits);
                if (d->numbers[i].value == NULL && 2 * prec > most) /* a tie, it seems, which has one digit more */
                    d->numbers[i].value = decimal_of_ball(z, digits + 1);
            }
        machine_clear(&m);
        for (open = 0; open < d->count && d->numbers[open].value != NULL;)
            open++;
    }
    for (int i = 0; i < d->count && !rests; i++)
        if (strcmp(d->numbers[i].name, "debye") == 0)
            return usage_error(EXIT_FAILED_CHECK, "lambda_d: expected more than %s m, with less nothing rests near L_ref",
                               d->numbers[i].value);
    return open == d->count ? EXIT_DONE
                            : usage_error(EXIT_FAILED_CHECK, "design: %s: %ld bits do not decide %ld digits",
                                          d->numbers[open].name, (long)most, (long)digits);
}

/* ---- arguments ---- */

/* (42), exactly: with other gains the pair does not come to rest, and there is nothing to design. */
static int check_stable(const struct scenario *s)
{
    const bool by_C1 = s->given[SET_C1];
    if (fmpq_sgn(&s->value[SET_Omega].value) <= 0) /* which is refused for itself */
        return EXIT_DONE;
    SCOPE(fmpq, margin);
    fmpq_set(margin, &s->value[by_C1 ? SET_C1 : SET_n].value);
    for (int i = 0; i < 2 && by_C1; i++)
        fmpq_div(margin, margin, &s->value[SET_Omega].value);
    fmpq_sub_si(margin, margin, 9);
    if (fmpq_sgn(margin) <= 0)
        return usage_error(EXIT_FAILED_CHECK, "%s, the pair is not stable, Eq. (42)",
                           by_C1 ? "C1: expected more than 9 Omega^2" : "n: expected a number > 9");
    if (fmpq_cmp_si(margin, 1000000) > 0)
        return usage_error(EXIT_FAILED_CHECK, "%s", by_C1 ? "C1: expected 1/s^2, at most a million Omega^2"
                                                          : "n: expected at most a million");
    if (s->given[SET_C2] && fmpq_sgn(&s->value[SET_C2].value) <= 0)
        return usage_error(EXIT_FAILED_CHECK, "C2: expected a number > 0, the pair is not stable, Eq. (42)");
    return EXIT_DONE;
}

static int read_design(struct design *d, const struct arguments *a)
{
    int status = read_scenario(&d->scenario, a, &d->lambda_d, false);
    if (status == EXIT_DONE && !d->lambda_d.infinite && fmpq_sgn(&d->lambda_d.value) <= 0)
        status = usage_error(EXIT_FAILED_CHECK, "lambda_d: expected a number > 0, or inf");
    if (status == EXIT_DONE)
        status = check_stable(&d->scenario);
    return status == EXIT_DONE ? check_scenario(&d->scenario, false) : status;
}

int command_design(const struct arguments *a)
{
    struct design d = {.lambda_d.infinite = true};
    struct message why;
    const long digits = (long)option_number(a, "--digits");
    if (derivations_open(&d.steps, a->paper, &why) != 0)
        return usage_error(EXIT_FAILED_CHECK, "%s", why.text);
    scenario_init(&d.scenario, &a->paper->sheet, option_given(a, "--exact"));
    fmpq_init(&d.lambda_d.value);
    design_formulas(&d);
    int status = read_design(&d, a);
    if (status == EXIT_DONE)
        status = find_digits(&d, digits);
    if (status == EXIT_DONE)
        print_numbers(a, NULL, digits, d.numbers, d.count);
    for (int i = 0; i < d.count; i++)
        free(d.numbers[i].value);
    identities_clear(&d.formulas);
    fmpq_clear(&d.lambda_d.value);
    scenario_clear(&d.scenario);
    derivations_clear(&d.steps);
    return status;
}
