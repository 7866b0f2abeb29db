/*
 * No claim stands without each of its proofs: every check that a claim makes on its way is made to fail, one at a time,
 * and the claim has to be undecided then. How many there are is written down in tests/proofs.txt, so that none gets lost.
 * The linker puts __wrap_X in the place of X (--wrap, PROVERS in the Makefile).
 */
#include "run.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "algebra.h"
#include "claims_stability.h"
#include "claims_statics.h"
#include "convergence.h"
#include "enclosure.h"
#include "optimum.h"
#include "track.h"
#include "verify/claims.h"
#include "well.h"

#define COUNT(array) ((int)(sizeof(array) / sizeof *(array)))

enum { MOST_SITES = 200 };

/* Where in the program a check is made, and how often it has been. */
struct site {
    const char *check;
    const void *address;
    int times;
};

static struct site sites[MOST_SITES];
static int site_count;
static const void *failing; /* the site of the check that fails, NULL for none, ... */
static int failing_time;    /* ... and which time it does */

/* What a check has found; false for the one that fails. */
static bool take(bool fine, const char *check, const void *address)
{
    int i = 0;
    if (!fine)
        return false;
    while (i < site_count && sites[i].address != address)
        i++;
    if (i == site_count) {
        ck_assert_int_lt(site_count, MOST_SITES);
        sites[site_count++] = (struct site){check, address, 0};
    }
    sites[i].times++;
    return address != failing || sites[i].times != failing_time;
}

/* NOLINTBEGIN(bugprone-reserved-identifier): names that the linker asks for */
#define CHECK(name, parameters, arguments)                     \
    bool __real_##name parameters;                             \
    bool __wrap_##name parameters;                             \
    bool __wrap_##name parameters                              \
    {                                                          \
        const bool fine = __real_##name arguments;             \
        return take(fine, #name, __builtin_return_address(0)); \
    }
CHECK(positive_at, (const char *text, const struct known *known), (text, known))
CHECK(positive_on, (const char *text, const char *low, const char *high, const struct known *known), (text, low, high, known))
CHECK(change_of_sign, (arb_t x, const char *text, const char *low, const char *high, const struct known *known),
      (x, text, low, high, known))
CHECK(identity, (const char *names, const char *left, const char *right), (names, left, right))
CHECK(section_identity, (const char *id, const char *left, const char *right), (id, left, right))
CHECK(section_at, (const char *id, const slong *inputs, fmpq *outputs), (id, inputs, outputs))
CHECK(has_sign_beyond, (const fmpq_poly_t f, const fmpq_t point, int sign), (f, point, sign))
CHECK(linear_model, (fmpq_mat_t A, const slong parameters[4]), (A, parameters))
CHECK(plane_model, (fmpq_mat_t B, const slong parameters[4]), (B, parameters))
CHECK(characteristic_is, (const fmpq_mat_t A, const char *text), (A, text))
CHECK(static_polynomial, (int axis, const char *factors), (axis, factors))
CHECK(energy_decays, (void), ())
CHECK(rates_proved, (void), ())
CHECK(slow_rate_compares, (const char *numerator, const char *denominator, slong p, ulong q, int sign),
      (numerator, denominator, p, q, sign))
CHECK(optimum_find, (struct optimum *o, slong prec), (o, prec))
CHECK(convergence_init, (struct convergence *c, const struct study *s), (c, s))
CHECK(convergence_as_expected, (const struct convergence *c, double tolerance), (c, tolerance))
CHECK(track_run, (struct track *t, const struct scene *s, long first, long step, long last), (t, s, first, step, last))
CHECK(track_bounds, (struct bounds *b, const struct track *t, slong k), (b, t, k))
CHECK(track_sup, (arb_t sup, const struct track *t, int which, slong from, slong to), (sup, t, which, from, to))
CHECK(track_settled, (arb_t hours, const struct track *t, int which, const arb_t limit), (hours, t, which, limit))
CHECK(is_below, (const arb_t x, double limit), (x, limit))
CHECK(is_above, (const arb_t x, double limit), (x, limit))
CHECK(evidence_number, (struct evidence *e, const char *before, const arb_t x, slong digits, const char *after),
      (e, before, x, digits, after))
CHECK(evidence_order,
      (struct evidence *e, const char *before, const arb_t larger, const arb_t smaller, ulong factor, int expected,
       double tolerance),
      (e, before, larger, smaller, factor, expected, tolerance))
CHECK(say, (struct evidence *e, const char *before, const arb_t x, slong digits), (e, before, x, digits))
CHECK(say_ratio, (struct evidence *e, const char *before, const arb_t x, const arb_t y, slong digits),
      (e, before, x, y, digits))
/* NOLINTEND(bugprone-reserved-identifier) */

static void decide(const struct claim *c, struct evidence *e, const void *site, int time)
{
    *e = (struct evidence){.text = ""};
    site_count = 0;
    failing = site;
    failing_time = time;
    c->decide(e);
}

static int proofs_made(void)
{
    int times = 0;
    for (int i = 0; i < site_count; i++)
        times += sites[i].times;
    return times;
}

/* As tests/proofs.txt has it; -1 for a claim that it lacks. */
static int proofs_known(const char *id)
{
    char name[64];
    int proofs = -1, times;
    FILE *file = fopen("tests/proofs.txt", "r");
    ck_assert_ptr_nonnull(file);
    while (proofs < 0 && fscanf(file, "%63s %d", name, &times) == 2)
        if (strcmp(name, id) == 0)
            proofs = times;
    fclose(file);
    return proofs;
}

/* Bounds are tried until one holds: where one fails, these claims go on to the next. */
static bool is_search(const char *id, const char *check)
{
    return strcmp(check, "positive_on") == 0 && (strcmp(id, "product-negative") == 0 || strcmp(id, "variation-small") == 0);
}

/* The last lists follow motions, for as long as that takes: with CT_ALL. */
static bool all(void)
{
    return getenv("CT_ALL") != NULL;
}

static const struct claim *const ledger[] = {claims_statics,     claims_stability, claims_motion,
                                             claims_convergence, claims_forced,    claims_beyond};

START_TEST(no_claim_stands_without_each_of_its_proofs)
{
    static struct site made[MOST_SITES];
    int made_to_fail = 0;
    for (const struct claim *c = ledger[_i]; c->id != NULL; c++) {
        struct evidence e;
        decide(c, &e, NULL, 0);
        ck_assert_int_ne(e.verdict, VERDICT_NONE);
        ck_assert_msg(proofs_made() == proofs_known(c->id), "%s makes %d proofs, of which tests/proofs.txt has %d", c->id,
                      proofs_made(), proofs_known(c->id));
        const int count = site_count;
        memcpy(made, sites, sizeof made);
        for (int i = 0; i < count; i++)
            for (int time = 1; time <= made[i].times && !is_search(c->id, made[i].check);
                 time += time < made[i].times ? made[i].times - time : 1) { /* the first and the last */
                decide(c, &e, made[i].address, time);
                made_to_fail++;
                ck_assert_msg(e.verdict == VERDICT_NONE, "%s stands without %s, check %d of %d, time %d of %d", c->id,
                              made[i].check, i + 1, count, time, made[i].times);
            }
    }
    printf("%d proofs made to fail\n", made_to_fail);
}
END_TEST

/* Of degree 4 in each of four numbers, of degree 1 in each of two masses: five values of those, two of these; two sums. */
START_TEST(a_polynomial_vanishes_at_enough_points)
{
    for (const struct claim *c = claims_stability; c->id != NULL; c++)
        if (strcmp(c->id, "no-moment") == 0) {
            struct evidence e;
            decide(c, &e, NULL, 0);
            ck_assert_int_eq(proofs_made(), 2 * 5 * 5 * 5 * 5 * 2 * 2);
            return;
        }
    ck_abort_msg("no claim no-moment");
}
END_TEST

Suite *suite(void)
{
    Suite *s = suite_create("evidence");
    TCase *t = tcase_create("evidence");
    tcase_set_timeout(t, all() ? 600 : 60);
    tcase_add_loop_test(t, no_claim_stands_without_each_of_its_proofs, 0, all() ? COUNT(ledger) : 2);
    tcase_add_test(t, a_polynomial_vanishes_at_enough_points);
    suite_add_tcase(s, t);
    return s;
}
