/* coulomb-tether figure: the data of the paper's figures as CSV, every digit proved. */
#include "command/command_motion.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "proof/roots.h"
#include "text/decimal.h"
#include "text/scope.h"

/* ---- Figures 5 to 7: motions ---- */

static const struct figure {
    const char *name;
    bool nonlinear, charges, small_angles;
    int first, count; /* numbers of a row */
    const char *heads[3];
} figures[] = {
    {"5a", false, false, false, 0, 3, {"psi", "theta", "dL"}},
    {"5b", false, false, true, 0, 3, {"x1", "y1", "z1"}},
    {"6", true, false, false, 0, 3, {"x1", "y1", "z1"}},
    {"7a", true, true, false, 6, 1, {"q1_uC"}},
    {"7b", true, true, false, 7, 1, {"q2_uC"}},
};

static void print_figure_heads(const struct figure *f, bool rk4)
{
    putchar('t');
    for (int i = 0; i < f->count; i++)
        printf(",%s", f->heads[i]);
    for (int i = 0; i < f->count && rk4; i++)
        printf(",%s_rk4", f->heads[i]);
    putchar('\n');
}

static int print_motion_figure(const struct figure *f, const struct scenario *s,
                               const struct arguments *a, long digits)
{
    struct motion m = {.scenario = s, .nonlinear = f->nonlinear, .charges = f->charges,
                       .small_angles = f->small_angles, .digits = digits, .microcoulomb = f->charges};
    OWNED(times) times = {0};
    char *beside = NULL;
    size_t size;
    const bool rk4 = option_given(a, "--rk4");
    SCOPE(fmpq, h);
    int status = times_every(&times, "100", "259200", false);
    if (status == EXIT_DONE && rk4)
        status = read_rk4(h, a, &times, s->exact);
    if (status == EXIT_DONE && rk4) {
        FILE *out = open_memstream(&beside, &size);
        if (out == NULL)
            out_of_memory();
        m.h = h;
        status = print_motion(out, &m, &times, f->first, f->count, true, NULL);
        m.h = NULL;
        if (fclose(out) != 0)
            out_of_memory();
    }
    if (status == EXIT_DONE) {
        print_figure_heads(f, rk4);
        status = print_motion(stdout, &m, &times, f->first, f->count, false, beside);
    }
    free(beside);
    return status;
}

static const struct figure *motion_figure(const char *name)
{
    return NAMED(name, figures, sizeof figures / sizeof *figures, struct figure, name);
}

/* ---- Figure 4: the characteristic roots against n ---- */

/*
 * The roots for gains by n, in units of Omega. Where sqrt(n - 9) is rational so are the gains, and
 * the order of the roots is decided exactly; elsewhere c2 is known by a ball.
 */
static bool gain_roots(acb_ptr roots, const fmpq_t n, slong prec)
{
    SCOPE(fmpq, c2, one);
    SCOPE(arb, c1, c2_ball);
    fmpq_one(one);
    fmpq_sub_si(c2, n, 9);
    if (fmpz_is_square(fmpq_numref(c2)) && fmpz_is_square(fmpq_denref(c2))) {
        fmpz_sqrt(fmpq_numref(c2), fmpq_numref(c2));
        fmpz_sqrt(fmpq_denref(c2), fmpq_denref(c2));
        fmpq_add(c2, c2, c2);
        return roots41(roots, one, n, c2, prec);
    }
    arb_set_fmpq(c1, n, prec);
    arb_set_fmpq(c2_ball, c2, prec);
    arb_sqrt(c2_ball, c2_ball, prec);
    arb_mul_2exp_si(c2_ball, c2_ball, 1);
    return roots41_gains(roots, c1, c2_ball, prec);
}

/* Of each conjugate pair the root above the axis, the slower pair first: its place among the four. Isolated roots
   are two such pairs, of which a real one has both on the axis. */
static void pairs(int place[2], acb_srcptr roots)
{
    int count = 0, real = 0;
    for (int k = 3; k >= 0; k--) { /* they ascend */
        const bool on_axis = arb_is_zero(acb_imagref(roots + k));
        if (arb_is_negative(acb_imagref(roots + k)) || (on_axis && real++ % 2 == 1))
            continue;
        place[count++] = k;
    }
    if (arb_equal(acb_realref(roots + place[0]), acb_realref(roots + place[1])) &&
        arb_gt(acb_imagref(roots + place[0]), acb_imagref(roots + place[1]))) {
        int first = place[0]; /* equal real parts: the slower oscillation first */
        place[0] = place[1];
        place[1] = first;
    }
}

/* re1 im1 re2 im2, false while a digit is undecided */
static bool root_texts(char *texts[4], acb_srcptr roots, const arb_t Omega, slong digits, slong prec)
{
    int place[2];
    bool decided = true;
    SCOPE(arb, x);
    pairs(place, roots);
    for (int i = 0; i < 4 && decided; i++) {
        acb_srcptr root = roots + place[i / 2];
        arb_mul(x, i % 2 ? acb_imagref(root) : acb_realref(root), Omega, prec);
        texts[i] = decimal_of_ball(x, digits);
        decided = texts[i] != NULL;
    }
    return decided;
}

static int print_roots(const fmpq_t n, const char *name, const struct scenario *s, long digits)
{
    bool decided = false;
    VECTOR(acb, roots, 4);
    SCOPE(arb, Omega);
    for (slong prec = 4 * digits + 64; !decided && prec < 64 * digits + 4096; prec *= 2) {
        char *texts[4] = {NULL};
        arb_set_fmpq(Omega, &s->value[SET_Omega].value, prec);
        decided = gain_roots(roots, n, prec) && root_texts(texts, roots, Omega, digits, prec);
        if (decided)
            printf("%s,%s,%s,%s,%s\n", name, texts[0], texts[1], texts[2], texts[3]);
        for (int i = 0; i < 4; i++)
            free(texts[i]);
    }
    return decided ? EXIT_DONE : usage_error(EXIT_FAILED_CHECK, "figure 4: undecided at n = %s", name);
}

/* n from 9 to 40 in tenths. */
static int print_figure4(const struct scenario *s, long digits)
{
    int status = EXIT_DONE;
    SCOPE(fmpq, n);
    puts("n,re1,im1,re2,im2");
    for (int tenths = 90; tenths <= 400 && status == EXIT_DONE; tenths++) {
        char decimal[16], name[32];
        snprintf(decimal, sizeof decimal, "%d.%d", tenths / 10, tenths % 10);
        literal_read(n, decimal, s->exact);
        decimal_shortest(name, tenths / 10.0);
        status = print_roots(n, name, s, digits);
    }
    return status;
}

static int check_figure4(const struct scenario *s)
{
    for (int i = 0; i < SCENARIO_VALUES; i++)
        if (s->given[i] && i != SET_Omega)
            return usage_error(EXIT_USAGE, "%s: figure 4 depends on Omega alone, n runs from 9 to 40",
                               scenario_names[i]);
    return EXIT_DONE;
}

int command_figure(const struct arguments *a)
{
    const struct figure *f = motion_figure(a->words[0]); /* NULL: the roots, figure 4 */
    OWNED(scenario) s;
    long digits;
    scenario_init(&s, &a->paper->sheet, option_given(a, "--exact"));
    int status = option_digits(a, 17, &digits);
    if (status == EXIT_DONE)
        status = read_scenario(&s, a, f != NULL && f->nonlinear);
    if (status == EXIT_DONE && f == NULL)
        status = check_figure4(&s);
    if (status == EXIT_DONE && f == NULL)
        status = print_figure4(&s, digits);
    else if (status == EXIT_DONE)
        status = print_motion_figure(f, &s, a, digits);
    return status;
}
