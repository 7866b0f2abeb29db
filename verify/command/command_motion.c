/* coulomb-tether trajectory, and the figures that are motions, as CSV, every digit proved. */
#include "command/command_motion.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "evaluate/sample.h"
#include "proof/roots.h"
#include "text/decimal.h"
#include "text/progress.h"
#include "text/scope.h"

enum { MOST_ROWS = 1000000 };

/* ---- times ---- */

struct times {
    fmpq *t;
    slong count;
};

static void times_clear(struct times *times)
{
    _fmpq_vec_clear(times->t, times->count);
}

static double nearest_binary64(const fmpq_t t)
{
    SCOPE(arf, x);
    arf_set_fmpq(x, t, 53, ARF_RND_NEAR);
    return arf_get_d(x, ARF_RND_NEAR);
}

/* The shortest decimal that means the time; where that means another, as decimals do when they are exact, all its digits. */
static char *time_text(const fmpq_t t, bool exact)
{
    char text[32];
    SCOPE(fmpq, meant);
    SCOPE(fmpz, odd, scale);
    decimal_shortest(text, nearest_binary64(t));
    if (!exact || (literal_read(meant, text, true) == LITERAL_FINITE && fmpq_equal(meant, t)))
        return text_copy(text);
    fmpz_set_ui(scale, 5);
    const ulong twos = fmpz_val2(fmpq_denref(t)), fives = (ulong)fmpz_remove(odd, fmpq_denref(t), scale);
    fmpz_ui_pow_ui(scale, 10, FLINT_MAX(twos, fives));
    fmpq_mul_fmpz(meant, t, scale);
    return decimal_of_rational(t, (slong)fmpz_sizeinbase(fmpq_numref(meant), 10));
}

static int times_at(struct times *times, const char *list, bool exact)
{
    char *copy = text_copy(list), *next = copy;
    int status = EXIT_DONE;
    times->t = _fmpq_vec_init((slong)strlen(list) / 2 + 2);
    while (next != NULL && status == EXIT_DONE) {
        const char *text = next;
        fmpq *t = times->t + times->count;
        next = strchr(text, ',');
        if (next != NULL)
            *next++ = '\0';
        status = finite_argument(t, "--at", text, exact);
        if (status == EXIT_DONE && times->count++ > 0 &&
            (fmpq_cmp(t - 1, t) == 0 || (fmpq_sgn(t - 1) != 0 && fmpq_sgn(t - 1) != fmpq_sgn(t)) ||
             (fmpq_cmp(t - 1, t) < 0) != (fmpq_sgn(t) > 0)))
            status = usage_error(EXIT_USAGE, "--at: expected times of one sign, each further from 0 than the last");
    }
    free(copy);
    return status;
}

/* Multiples of the decimal that is written; not exact, each time is the binary64 nearest to its own, as in --at. */
static int times_every(struct times *times, const char *every, const char *until, bool exact)
{
    SCOPE(fmpq, step, end, rows);
    SCOPE(fmpz, whole);
    int status = finite_argument(step, "--every", every, exact);
    if (status == EXIT_DONE)
        status = finite_argument(end, "--until", until, exact);
    if (status == EXIT_DONE && fmpq_sgn(step) <= 0)
        status = usage_error(EXIT_FAILED_CHECK, "--every: expected a number > 0, got '%.40s'", every);
    if (status == EXIT_DONE)
        status = finite_argument(step, "--every", every, true);
    if (status == EXIT_DONE)
        status = finite_argument(end, "--until", until, true);
    if (status != EXIT_DONE)
        return status;
    fmpq_div(rows, end, step);
    fmpz_tdiv_q(whole, fmpq_numref(rows), fmpq_denref(rows));
    if (fmpz_cmp_si(whole, MOST_ROWS) > 0 || fmpz_cmp_si(whole, -MOST_ROWS) < 0)
        return usage_error(EXIT_FAILED_CHECK, "--every, --until: expected at most %d rows", MOST_ROWS);
    const slong last = fmpz_get_si(whole);
    times->count = labs(last) + 1;
    times->t = _fmpq_vec_init(times->count);
    for (slong i = 0; i < times->count; i++) {
        fmpq *t = times->t + i;
        fmpq_mul_si(t, step, last < 0 ? -i : i);
        if (!exact)
            fmpq_set_double(t, nearest_binary64(t));
    }
    return EXIT_DONE;
}

static int times_option(struct times *times, const struct arguments *a, bool exact)
{
    const char *at = option_value(a, "--at"), *every = option_value(a, "--every");
    const char *until = option_value(a, "--until");
    if (at != NULL && (every != NULL || until != NULL))
        return usage_error(EXIT_USAGE, "--at: expected without --every and --until");
    if (at != NULL)
        return times_at(times, at, exact);
    return times_every(times, every ? every : "100", until ? until : "259200", exact);
}

/* ---- scenario ---- */

int names_taken(const struct subcommand *s, const char *names[MOST_NAMES])
{
    const bool design = s->run == command_design, motion = s->run == command_trajectory || s->run == command_figure;
    const int count = motion ? SCENARIO_VALUES : design ? SET_C2 + 2 : 0;
    for (int i = 0; i < count; i++)
        names[i] = design && i + 1 == count ? "lambda_d" : scenario_names[i];
    return count;
}

static int check_combination(const struct scenario *s, bool nonlinear, bool set)
{
    bool angles = false;
    int cartesian = 0;
    for (int i = SET_psi; i <= SET_dL_dot; i++)
        angles |= s->given[i];
    for (int i = SET_x1; i <= SET_z1_dot; i++)
        cartesian += s->given[i];
    if (s->given[SET_n] && (s->given[SET_C1] || s->given[SET_C2]))
        return usage_error(EXIT_USAGE, "n: expected either n, or C1 and C2");
    if (cartesian > 0 && !nonlinear)
        return usage_error(EXIT_USAGE, "x1 ... z1_dot: expected for nonlinear motions alone");
    if (cartesian > 0 && (angles || (cartesian < FLOW_STATE && !set)))
        return usage_error(EXIT_USAGE, "x1 ... z1_dot: expected all six, and no angles with them");
    return EXIT_DONE;
}

void start_by_angles(struct input *start, const bool *given, const struct scenario *s)
{
    enum { BITS = 256 };
    FLOW_PARAMETERS(p);
    VECTOR(arb, state, FLOW_STATE);
    scenario_parameters(&p, s, BITS);
    for (int i = 0; i < FLOW_STATE; i++)
        arb_set_fmpq(state + i, &s->value[SET_psi + i].value, BITS);
    state_from_angles(state, s->sheet, &p, BITS);
    for (int i = 0; i < FLOW_STATE; i++)
        if (!given[i] && arb_is_finite(state + i)) /* not where the masses are refused in the end */
            fmpq_set_double(&start[i].value, arf_get_d(arb_midref(state + i), ARF_RND_NEAR));
}

int read_scenario(struct scenario *s, const struct arguments *a, struct input *lambda_d, bool nonlinear)
{
    const bool set = option_given(a, "--set");
    const char *names[MOST_NAMES];
    struct assignment known[MOST_NAMES] = {{.name = NULL}};
    const int count = names_taken(a->subcommand, names);
    bool completes = false;
    for (int i = 0; i < count; i++) {
        known[i] = (struct assignment){.name = names[i], .value = &s->value[i]};
        known[i].radius = set && may_have_radius((enum scenario_name)i) ? s->radius + i : NULL;
    }
    if (lambda_d != NULL) {
        known[count - 1].value = lambda_d;
        known[count - 1].may_be_infinite = true;
    }
    int status = take_names(a, known, count);
    for (int i = 0; i < SCENARIO_VALUES; i++)
        s->given[i] = known[i].text != NULL && known[i].value == &s->value[i];
    if (status == EXIT_DONE)
        status = check_combination(s, nonlinear, set);
    if (status == EXIT_DONE)
        status = take_values(known, count, s->exact);
    for (int i = SET_x1; i <= SET_z1_dot; i++)
        completes = completes || s->given[i];
    if (status == EXIT_DONE && completes) { /* of a set some will do */
        start_by_angles(&s->value[SET_x1], &s->given[SET_x1], s);
        memset(&s->given[SET_x1], true, FLOW_STATE);
    }
    return status;
}

int check_scenario(const struct scenario *s, bool nonlinear)
{
    struct message why;
    return scenario_valid(s, nonlinear, &why) ? EXIT_DONE : usage_error(EXIT_FAILED_CHECK, "%s", why.text);
}

bool scenario_roots(acb_ptr roots, const struct scenario *s, slong prec)
{
    const bool by_n = !s->given[SET_C1] && !s->given[SET_C2];
    const fmpq *Omega = &s->value[SET_Omega].value, *n = &s->value[SET_n].value;
    SCOPE(fmpq, C1, C2);
    SCOPE(arb, c1, c2);
    FLOW_PARAMETERS(p);
    fmpq_set(C1, &s->value[SET_C1].value);
    fmpq_set(C2, &s->value[SET_C2].value);
    if (by_n)
        fmpq_sub_si(C2, n, 9);
    const bool rational = by_n && fmpz_is_square(fmpq_numref(C2)) && fmpz_is_square(fmpq_denref(C2));
    if (rational) {
        fmpz_sqrt(fmpq_numref(C2), fmpq_numref(C2));
        fmpz_sqrt(fmpq_denref(C2), fmpq_denref(C2));
        fmpq_mul(C2, C2, Omega);
        fmpq_mul_2exp(C2, C2, 1);
        fmpq_mul(C1, n, Omega);
        fmpq_mul(C1, C1, Omega);
    }
    if (rational || (s->given[SET_C1] && s->given[SET_C2]))
        return roots41(roots, Omega, C1, C2, prec);
    scenario_parameters(&p, s, prec);
    flow_gains(c1, c2, &p, prec);
    const bool isolated = roots41_gains(roots, c1, c2, prec);
    _acb_vec_scalar_mul_arb(roots, roots, 4, p.Omega, prec);
    return isolated;
}

/* ---- rows ---- */

/* What the first word asks for. */
static const struct view {
    const char *name;
    struct motion motion;
    int first, count; /* numbers of a row */
    const char *heads[ROW_NUMBERS];
} views[] = {
    {"linear", {.nonlinear = false}, 0, FLOW_STATE, {"psi", "theta", "dL", "psi_dot", "theta_dot", "dL_dot"}},
    {"nonlinear", {.nonlinear = true, .charges = true}, 0, ROW_NUMBERS, {"x1", "y1", "z1", "x1_dot", "y1_dot", "z1_dot", "q1", "q2"}},
    /* figures */
    {"5a", {.nonlinear = false}, 0, 3, {"psi", "theta", "dL"}},
    {"5b", {.small_angles = true}, 0, 3, {"x1", "y1", "z1"}},
    {"6", {.nonlinear = true}, 0, 3, {"x1", "y1", "z1"}},
    {"7a", {.nonlinear = true, .charges = true, .microcoulomb = true}, FLOW_STATE, 1, {"q1_uC"}},
    {"7b", {.nonlinear = true, .charges = true, .microcoulomb = true}, FLOW_STATE + 1, 1, {"q2_uC"}},
};

struct row_printer {
    FILE *out;
    const struct motion *motion;
    const struct times *times;
    int first, count;   /* which numbers of a row */
    bool bare;          /* rows without a time */
    const char *beside; /* what stands beside the rows that are left, a line each; NULL: nothing */
    struct progress progress;
};

static int print_row(void *context, slong k, const fmpq_t t, char *const *numbers)
{
    struct row_printer *p = context;
    char *time = time_text(t, p->motion->scenario->exact);
    if (!p->bare)
        fputs(time, p->out);
    free(time);
    progress_show(&p->progress, (uint64_t)k + 1, (uint64_t)p->times->count);
    for (int i = p->first; i < p->first + p->count; i++)
        fprintf(p->out, ",%s", numbers[i]);
    if (p->beside != NULL) {
        const size_t length = strcspn(p->beside, "\n");
        fwrite(p->beside, 1, length, p->out);
        p->beside += length + 1;
    }
    putc('\n', p->out);
    return ferror(p->out);
}

static int print_rows(struct row_printer p)
{
    struct message why;
    p.progress = progress_begin(p.motion->most_pieces == 0);
    const int failed = motion_rows(p.motion, p.times->t, p.times->count, print_row, &p, &why);
    progress_end(&p.progress);
    return failed && !ferror(p.out) ? usage_error(EXIT_FAILED_CHECK, "%s", why.text) : EXIT_DONE;
}

/* --rk4 H: H > 0, and every time a multiple of it, none before 0. */
static int read_rk4(fmpq_t h, const struct arguments *a, const struct times *times, bool exact)
{
    SCOPE(fmpq, steps);
    const char *text = option_value(a, "--rk4");
    int status = finite_argument(h, "--rk4", text, exact);
    if (status == EXIT_DONE && fmpq_sgn(h) <= 0)
        status = usage_error(EXIT_FAILED_CHECK, "--rk4: expected a step > 0, got '%.40s'", text);
    for (slong i = 0; i < times->count && status == EXIT_DONE; i++) {
        fmpq_div(steps, times->t + i, h);
        char *time = time_text(times->t + i, exact);
        if (fmpq_sgn(steps) < 0 || !fmpz_is_one(fmpq_denref(steps)))
            status = usage_error(EXIT_FAILED_CHECK, "--rk4: expected times >= 0 that are multiples of %s, got %s%s",
                                 text, time, exact ? "" : " (as binary64; --exact takes decimals as such)");
        free(time);
    }
    return status;
}

/* The rows, of a figure those of the Runge-Kutta method beside them: these are made first. */
static int print_view(const struct view *v, struct motion m, const struct times *times, const fmpq *h, bool beside)
{
    const bool set = m.most_pieces > 0;
    struct row_printer p = {.out = stdout, .motion = &m, .times = times, .first = v->first, .count = set ? SET_NUMBERS : v->count};
    char *rows = NULL;
    size_t size;
    int status = EXIT_DONE;
    m.h = h;
    if (beside) {
        struct row_printer kept = p;
        kept.out = open_memstream(&rows, &size);
        if (kept.out == NULL)
            out_of_memory();
        kept.bare = true;
        status = print_rows(kept);
        if (fclose(kept.out) != 0)
            out_of_memory();
        m.h = NULL;
        p.beside = rows;
    }
    if (status == EXIT_DONE) {
        putchar('t');
        for (int i = 0; i < v->count; i++)
            printf(set ? ",%s_low,%s_high" : ",%s", v->heads[i], v->heads[i]);
        for (int i = 0; i < v->count && beside; i++)
            printf(",%s_rk4", v->heads[i]);
        putchar('\n');
        status = print_rows(p);
    }
    free(rows);
    return status;
}

int command_trajectory(const struct arguments *a)
{
    enum { MOST_PIECES = 256 }; /* some minutes of processor time; options.c says so */
    const bool exact = option_given(a, "--exact"), set = option_given(a, "--set"), rk4 = option_given(a, "--rk4");
    const struct view *v = views;
    OWNED(scenario) s;
    OWNED(times) times = {0};
    SCOPE(fmpq, h);
    scenario_init(&s, &a->paper->sheet, exact);
    while (strcmp(v->name, a->words[0]) != 0)
        v++;
    struct motion m = v->motion;
    m.scenario = &s;
    m.digits = (slong)option_number(a, "--digits");
    m.most_pieces = set ? MOST_PIECES : 0;
    int status = set && rk4 ? usage_error(EXIT_USAGE, "--set: expected without --rk4") : EXIT_DONE;
    if (status == EXIT_DONE)
        status = read_scenario(&s, a, NULL, m.nonlinear);
    if (status == EXIT_DONE)
        status = check_scenario(&s, m.nonlinear);
    if (status == EXIT_DONE)
        status = times_option(&times, a, exact);
    if (status == EXIT_DONE && rk4)
        status = read_rk4(h, a, &times, exact);
    const bool beside = rk4 && a->subcommand->run == command_figure;
    return status == EXIT_DONE ? print_view(v, m, &times, rk4 ? h : NULL, beside) : status;
}
