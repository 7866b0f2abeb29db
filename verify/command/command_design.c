/* coulomb-tether design: what one decides with, every digit proved. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "claims/sampling.h"
#include "command/command.h"
#include "motion/motion.h"
#include "proof/roots.h"
#include "text/decimal.h"
#include "text/json.h"
#include "text/scope.h"

/* A number of the sheet: a formula of the names before it, or ID.OUTPUT of an equation whose inputs they are. */
struct design_row {
    const char *group; /* "": not printed; NULL: that of the last row */
    const char *name, *unit, *formula, *meaning;
};

static const struct design_row design_rows[] = {
    {"", "L", "m", "L_ref", ""},
    {"", "dQ", "C^2", "0", ""},
    {"gains of the law (18)", "C1", "1/s^2", "C1", "of the length error"},
    {NULL, "C2", "1/s", "C2", "of its rate"},
    {"rest at L_ref", "Q_ref", "C^2", "eq07.Q_ref", "charge product"},
    {NULL, "q1", "C", "eq21.q1", "charge of craft 1"},
    {NULL, "q2", "C", "eq21.q2", "charge of craft 2"},
    {NULL, "x1", "m", "eq05.x1", "place of craft 1 on the radius"},
    {NULL, "x2", "m", "eq05.x2", "place of craft 2"},
    {"roots of (41), yaw and length error", "re1", "1/s", "re1*Omega", "fastest decay"},
    {NULL, "im1", "rad/s", "im1*Omega", "its frequency"},
    {NULL, "re2", "1/s", "re2*Omega", ""},
    {NULL, "im2", "rad/s", "im2*Omega", ""},
    {NULL, "re3", "1/s", "re3*Omega", ""},
    {NULL, "im3", "rad/s", "im3*Omega", ""},
    {NULL, "re4", "1/s", "re4*Omega", "slowest decay"},
    {NULL, "im4", "rad/s", "im4*Omega", "its frequency"},
    {NULL, "t_fast", "s", "-1/re1", "time in which the fastest falls to 1/e"},
    {NULL, "t_slow", "s", "-1/re4", "time in which the slowest falls to 1/e"},
    {"frequencies, each motion by itself", "w_theta", "rad/s", "2*Omega", "pitch, which no gain damps"},
    {NULL, "w_psi", "rad/s", "sqrt(3)*Omega", "yaw"},
    {NULL, "w_dL", "rad/s", "sqrt(C1 - 9*Omega^2)", "length error"},
    {"sampling, by the linear model", "T", "s", "hold/Omega", "the law may be held for any time below this one"},
    {NULL, "d", "s", "delay/Omega", "the law may act late by any time below this one"},
};
enum { DESIGN_ROWS = sizeof design_rows / sizeof *design_rows };

/* What the formulas start from: the parameters, then in radians of orbit the roots, and the largest T and d. */
static const char *const design_inputs[] = {"Omega", "L_ref", "C1", "C2", "k_c", "m1", "m2", "re1", "im1", "re2", "im2",
                                            "re3", "im3", "re4", "im4", "hold", "delay"};
enum { DESIGN_PARAMETERS = 7, DESIGN_INPUTS = sizeof design_inputs / sizeof *design_inputs };

struct design {
    struct scenario scenario;
    struct program program;
    int nodes[DESIGN_ROWS];
    char *digits[DESIGN_ROWS];
};

/* ---- numbers ---- */

/* Of ID.OUTPUT, the id four letters long. */
static int sheet_node(struct program *p, const struct sheet *sheet, const char *formula)
{
    char id[] = "eq..";
    memcpy(id, formula, strlen(id));
    const struct section *s = section_find(sheet, id);
    const struct formulas *f = &s->corrected;
    int *stand_in = xrealloc(NULL, (size_t)f->program.count, sizeof *stand_in), output = 0;
    for (int i = 0; i < f->program.count; i++)
        stand_in[i] = i < s->input_count ? program_find(p, s->inputs[i]->name) : -1;
    while (strcmp(s->outputs[output]->name, formula + sizeof id) != 0)
        output++;
    const int node = program_inline(p, &f->program, f->outputs[output], stand_in);
    free(stand_in);
    return node;
}

static void design_formulas(struct design *d)
{
    struct message why;
    size_t where;
    program_init(&d->program);
    for (int i = 0; i < DESIGN_INPUTS; i++)
        program_input(&d->program, design_inputs[i]);
    for (int i = 0; i < DESIGN_ROWS; i++) {
        const char *formula = design_rows[i].formula;
        d->nodes[i] = strncmp(formula, "eq", 2) == 0 ? sheet_node(&d->program, d->scenario.sheet, formula)
                                                     : program_parse(&d->program, formula, &where, &why);
        program_name(&d->program, d->nodes[i], design_rows[i].name);
    }
}

/* The roots over Omega; exact gains may have equal ones. */
static bool enclose_root_parts(acb_ptr roots, const struct scenario *s, const arb_t c1, const arb_t c2, slong prec)
{
    SCOPE(fmpq, one, exact_c1, exact_c2);
    if (!s->given[SET_C1] || !s->given[SET_C2])
        return roots41_gains(roots, c1, c2, prec);
    fmpq_one(one);
    fmpq_div(exact_c2, &s->value[SET_C2].value, &s->value[SET_Omega].value);
    fmpq_div(exact_c1, &s->value[SET_C1].value, &s->value[SET_Omega].value);
    fmpq_div(exact_c1, exact_c1, &s->value[SET_Omega].value);
    return roots41(roots, one, exact_c1, exact_c2, prec);
}

static void enclose_inputs(struct machine *m, const struct scenario *s, slong prec)
{
    struct flow_parameters p;
    SCOPE(arb, c1, c2);
    VECTOR(acb, roots, 4);
    flow_parameters_init(&p);
    scenario_parameters(&p, s, prec);
    arb_srcptr parameters[DESIGN_PARAMETERS] = {p.Omega, p.L_ref, p.C1, p.C2, p.k_c, p.m1, p.m2};
    for (int i = 0; i < DESIGN_INPUTS; i++)
        if (i < DESIGN_PARAMETERS)
            arb_set(machine_value(m, i), parameters[i]);
        else
            arb_indeterminate(machine_value(m, i));
    arb_div(c2, p.C2, p.Omega, prec);
    arb_div(c1, p.C1, p.Omega, prec);
    arb_div(c1, c1, p.Omega, prec);
    const bool isolated = enclose_root_parts(roots, s, c1, c2, prec);
    for (int i = 0; i < 4 && isolated; i++) {
        arb_set(machine_value(m, DESIGN_PARAMETERS + 2 * i), acb_realref(roots + i));
        arb_set(machine_value(m, DESIGN_PARAMETERS + 2 * i + 1), acb_imagref(roots + i));
    }
    largest_hold(machine_value(m, DESIGN_INPUTS - 2), c1, c2, prec);
    largest_delay(machine_value(m, DESIGN_INPUTS - 1), c1, c2, prec);
    flow_parameters_clear(&p);
}

/* Every digit of every row, by more and more bits; else the first row that stays open. */
static int find_digits(struct design *d, slong digits)
{
    const slong first = 4 * digits + 128, most = 8 * first;
    int open = 0;
    for (slong prec = first; prec <= most && open < DESIGN_ROWS; prec *= 2) {
        struct machine m;
        machine_init(&m, &d->program, &arithmetic_ball, prec);
        enclose_inputs(&m, &d->scenario, prec);
        machine_run(&m);
        for (int i = 0; i < DESIGN_ROWS; i++)
            if (d->digits[i] == NULL)
                d->digits[i] = decimal_of_ball(machine_value(&m, d->nodes[i]), digits);
        machine_clear(&m);
        for (open = 0; open < DESIGN_ROWS && d->digits[open] != NULL;)
            open++;
    }
    return open == DESIGN_ROWS ? EXIT_DONE
                               : usage_error(EXIT_FAILED_CHECK, "design: %s: %ld bits do not decide %ld digits",
                                             design_rows[open].name, (long)most, (long)digits);
}

/* ---- arguments ---- */

static int read_design(struct scenario *s, const struct arguments *a)
{
    enum { KNOWN = SET_C2 + 1 };
    static const bool never_infinite[KNOWN] = {false};
    const char *refused;
    struct message why;
    const int status = read_assignments(a, scenario_names, KNOWN, s->exact, never_infinite, s->given, s->value, &refused);
    if (status != EXIT_DONE)
        return status;
    if (s->given[SET_n] && (s->given[SET_C1] || s->given[SET_C2]))
        return usage_error(EXIT_USAGE, "n: expected either n, or C1 and C2");
    if (refused != NULL)
        return refuse_assignment(refused, s->exact);
    return scenario_valid(s, false, &why) ? EXIT_DONE : usage_error(EXIT_FAILED_CHECK, "%s", why.text);
}

/* (42), exactly: with other gains the pair does not come to rest, and there is nothing to design. */
static int check_stable(const struct scenario *s)
{
    SCOPE(fmpq, least);
    fmpq_set_si(least, 9, 1);
    if (!s->given[SET_C1] && fmpq_cmp(&s->value[SET_n].value, least) <= 0)
        return usage_error(EXIT_FAILED_CHECK, "n: expected a number > 9, the pair is not stable, Eq. (42)");
    fmpq_mul(least, least, &s->value[SET_Omega].value);
    fmpq_mul(least, least, &s->value[SET_Omega].value);
    if (s->given[SET_C1] && fmpq_cmp(&s->value[SET_C1].value, least) <= 0)
        return usage_error(EXIT_FAILED_CHECK, "C1: expected more than 9 Omega^2, the pair is not stable, Eq. (42)");
    if (s->given[SET_C2] && fmpq_sgn(&s->value[SET_C2].value) <= 0)
        return usage_error(EXIT_FAILED_CHECK, "C2: expected a number > 0, the pair is not stable, Eq. (42)");
    return EXIT_DONE;
}

/* ---- print ---- */

static void print_design(const struct design *d)
{
    const char *group = "";
    for (int i = 0; i < DESIGN_ROWS; i++) {
        const struct design_row *r = &design_rows[i];
        if (r->group != NULL)
            group = r->group;
        if (*group == '\0')
            continue;
        if (r->group != NULL)
            printf("# %s\n", group);
        printf("%s = %s %s%s%s\n", r->name, d->digits[i], r->unit, *r->meaning ? "  # " : "", r->meaning);
    }
}

static void print_design_json(const struct design *d, slong digits)
{
    const char *group = "";
    struct json j = json_on(stdout);
    json_open(&j, NULL, '{');
    json_value(&j, "digits", "%ld", (long)digits);
    json_open(&j, "outputs", '[');
    for (int i = 0; i < DESIGN_ROWS; i++) {
        const struct design_row *r = &design_rows[i];
        group = r->group != NULL ? r->group : group;
        if (*group == '\0')
            continue;
        json_open(&j, NULL, '{');
        json_string(&j, "group", group);
        json_string(&j, "name", r->name);
        json_string(&j, "value", d->digits[i]);
        json_string(&j, "unit", r->unit);
        json_string(&j, "meaning", r->meaning);
        json_close(&j);
    }
    json_close(&j);
    json_close(&j);
    putchar('\n');
}

int command_design(const struct arguments *a)
{
    struct design d = {0};
    long digits;
    if (option_digits(a, 8, &digits) != EXIT_DONE)
        return EXIT_USAGE;
    scenario_init(&d.scenario, &a->paper->sheet, option_given(a, "--exact"));
    int status = read_design(&d.scenario, a);
    if (status == EXIT_DONE)
        status = check_stable(&d.scenario);
    if (status == EXIT_DONE) {
        design_formulas(&d);
        status = find_digits(&d, digits);
        if (status == EXIT_DONE) {
            if (option_given(a, "--json"))
                print_design_json(&d, digits);
            else
                print_design(&d);
            status = output_finished();
        }
        program_clear(&d.program);
    }
    for (int i = 0; i < DESIGN_ROWS; i++)
        free(d.digits[i]);
    scenario_clear(&d.scenario);
    return status;
}
