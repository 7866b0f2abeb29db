/* coulomb-tether trajectory: a motion as CSV, every digit proved. */
#include "command/command_motion.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "evaluate/sample.h"
#include "text/decimal.h"
#include "text/progress.h"
#include "text/scope.h"

enum { MOST_ROWS = 1000000 };

/* ---- times ---- */

void times_clear(struct times *times)
{
    _fmpq_vec_clear(times->t, times->count);
}

static double nearest_binary64(const fmpq_t t)
{
    mpfr_t x;
    mpfr_init2(x, 53);
    fmpq_get_mpfr(x, t, MPFR_RNDN);
    const double nearest = mpfr_get_d(x, MPFR_RNDN);
    mpfr_clear(x);
    return nearest;
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
int times_every(struct times *times, const char *every, const char *until, bool exact)
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
        fmpq_set_si(rows, last < 0 ? -i : i, 1);
        fmpq_mul(t, step, rows);
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

static int check_combination(const struct scenario *s, bool nonlinear)
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
    if (cartesian > 0 && (cartesian < FLOW_STATE || angles))
        return usage_error(EXIT_USAGE, "x1 ... z1_dot: expected all six, and no angles with them");
    return EXIT_DONE;
}

/* Where some of x1 ... z1_dot are given of a set, the others are the binary64 nearest to where the angles have them. */
static void complete_start(struct scenario *s)
{
    enum { BITS = 128 };
    int given = 0;
    for (int i = SET_x1; i <= SET_z1_dot; i++)
        given += s->given[i];
    if (given == 0)
        return;
    FLOW_PARAMETERS(p);
    VECTOR(arb, state, FLOW_STATE);
    SCOPE(arf, near);
    scenario_parameters(&p, s, BITS);
    for (int i = 0; i < FLOW_STATE; i++)
        arb_set_fmpq(state + i, &s->value[SET_psi + i].value, BITS);
    state_from_angles(state, s->sheet, &p, BITS);
    for (int i = 0; i < FLOW_STATE; i++)
        if (!s->given[SET_x1 + i] && arb_is_finite(state + i)) {
            arf_set_round(near, arb_midref(state + i), 53, ARF_RND_NEAR);
            arf_get_fmpq(&s->value[SET_x1 + i].value, near);
            s->given[SET_x1 + i] = true;
        }
}

int read_scenario(struct scenario *s, const struct arguments *a, bool nonlinear)
{
    static const bool never_infinite[SCENARIO_VALUES] = {false};
    struct message why;
    const char *refused;
    int status = read_assignments(a, scenario_names, SCENARIO_VALUES, s->exact, never_infinite, s->given, s->value, &refused);
    if (status == EXIT_DONE && option_given(a, "--set"))
        complete_start(s);
    if (status == EXIT_DONE)
        status = check_combination(s, nonlinear);
    if (status != EXIT_DONE)
        return status;
    if (refused != NULL)
        return refuse_assignment(refused, s->exact);
    return scenario_valid(s, nonlinear, &why) ? EXIT_DONE
                                             : usage_error(EXIT_FAILED_CHECK, "%s", why.text);
}

/* NAME=VALUE+-RADIUS into the scenario's values and radii; what is read as NAME=VALUE ends at the sign. */
static int read_set(struct scenario *s, const struct arguments *a)
{
    const char *radius[SCENARIO_VALUES] = {NULL};
    struct message why;
    for (int k = 0; k < a->assignment_count; k++) {
        char *text = a->assignments[k], *sign = strstr(text, "+-");
        for (int i = 0; i < SCENARIO_VALUES && sign != NULL; i++)
            if (strncmp(scenario_names[i], text, strcspn(text, "=")) == 0 && scenario_names[i][strcspn(text, "=")] == '\0')
                radius[i] = sign + 2;
        if (sign != NULL)
            *sign = '\0';
    }
    int status = read_scenario(s, a, true);
    for (int i = 0; i < SCENARIO_VALUES && status == EXIT_DONE; i++) {
        const char *name = scenario_names[i];
        if (radius[i] != NULL)
            status = may_have_radius((enum scenario_name)i) ? finite_argument(s->radius + i, name, radius[i], s->exact)
                                                             : usage_error(EXIT_USAGE, "%s: expected without +-", name);
        if (status == EXIT_DONE && fmpq_sgn(s->radius + i) < 0)
            status = usage_error(EXIT_FAILED_CHECK, "%s: expected a number >= 0 after +-, got '%.40s'", name, radius[i]);
    }
    if (status == EXIT_DONE && !scenario_valid(s, true, &why))
        status = usage_error(EXIT_FAILED_CHECK, "%s", why.text);
    return status;
}

static int refuse_radius(const struct arguments *a)
{
    for (int k = 0; k < a->assignment_count; k++)
        if (strstr(a->assignments[k], "+-") != NULL)
            return usage_error(EXIT_USAGE, "%.60s: a value with a radius is a set of motions, expected with --set", a->assignments[k]);
    return EXIT_DONE;
}

/* ---- rows ---- */

struct row_printer {
    FILE *out;
    slong rows;
    int first, count;   /* which numbers of a row */
    bool bare, exact;   /* rows without a time; a time is the decimal itself */
    const char *beside; /* what stands beside the rows that are left, a line each; NULL: nothing */
    struct progress progress;
};

static int print_motion_row(void *context, slong k, const fmpq_t t, char *const *numbers)
{
    struct row_printer *p = context;
    char *time = time_text(t, p->exact);
    if (!p->bare)
        fputs(time, p->out);
    free(time);
    progress_show(&p->progress, (uint64_t)k + 1, (uint64_t)p->rows);
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

int print_motion(FILE *out, const struct motion *m, const struct times *times, int first, int count, bool bare, const char *beside)
{
    struct message why;
    struct row_printer p = {out, times->count, first, count, bare, m->scenario->exact, beside, progress_begin(m->most_pieces == 0)};
    const int failed = motion_rows(m, times->t, times->count, print_motion_row, &p, &why);
    progress_end(&p.progress);
    return failed && !ferror(out) ? usage_error(EXIT_FAILED_CHECK, "%s", why.text) : EXIT_DONE;
}

int read_rk4(fmpq_t h, const struct arguments *a, const struct times *times, bool exact)
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

static void print_heads(bool nonlinear, bool set)
{
    const enum scenario_name first = nonlinear ? SET_x1 : SET_psi;
    putchar('t');
    for (int i = 0; i < (nonlinear ? ROW_NUMBERS : FLOW_STATE); i++) {
        const char *name = i < FLOW_STATE ? scenario_names[first + i] : i == FLOW_STATE ? "q1" : "q2";
        printf(set ? ",%s_low,%s_high" : ",%s", name, name);
    }
    putchar('\n');
}

int command_trajectory(const struct arguments *a)
{
    enum { MOST_PIECES = 256 }; /* some minutes of processor time; options.c says so */
    int status = EXIT_DONE;
    const bool exact = option_given(a, "--exact"), set = option_given(a, "--set");
    struct motion m = {0};
    OWNED(scenario) s;
    OWNED(times) times = {0};
    SCOPE(fmpq, h);
    scenario_init(&s, &a->paper->sheet, exact);
    m.scenario = &s;
    m.nonlinear = m.charges = strcmp(a->words[0], "nonlinear") == 0;
    if (set && option_given(a, "--rk4"))
        status = usage_error(EXIT_USAGE, "--set: expected without --rk4");
    if (status == EXIT_DONE)
        status = option_digits(a, 17, &m.digits);
    if (status == EXIT_DONE)
        status = set ? read_set(&s, a) : refuse_radius(a);
    if (status == EXIT_DONE && !set)
        status = read_scenario(&s, a, m.nonlinear);
    if (status == EXIT_DONE)
        status = times_option(&times, a, exact);
    if (status == EXIT_DONE && option_given(a, "--rk4")) {
        status = read_rk4(h, a, &times, exact);
        m.h = h;
    }
    if (status == EXIT_DONE) {
        m.most_pieces = set ? MOST_PIECES : 0;
        print_heads(m.nonlinear, set);
        status = print_motion(stdout, &m, &times, 0, set ? SET_NUMBERS : m.nonlinear ? ROW_NUMBERS : FLOW_STATE, false, NULL);
    }
    return status;
}
