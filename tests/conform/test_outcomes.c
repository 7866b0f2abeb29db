/*
 * Each rule of PROTOCOL.md, kept by the least amount and violated by the least amount: for every operation and every output,
 * for golden vectors and for random ones apart.
 */
#include "tests/run.h"
#include "tests/paper.h"

#include <fcntl.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#include "conform/client.h"
#include "conform/conform.h"
#include "conform/diagnosis.h"
#include "evaluate/domain.h"
#include "conform/kinds.h"
#include "conform/report.h"
#include "evaluate/sample.h"
#include "evaluate/vectors.h"
#include "sheet/known_mistakes.h"
#include "text/scope.h"

enum { RANDOM = 48, MANY = 100000, BITS = 256, DIGITS = 40, LONG = 4096 };

/* ---- a run whose questions are answered one by one, in any order ---- */

static struct test_run *run_of(const struct section *s, uint64_t random, int significand)
{
    struct test_run *e = calloc(1, sizeof *e);
    ck_assert_ptr_nonnull(e);
    e->significand = significand;
    e->sets.seed = 1;
    test_sets_add(&e->sets, s, random, significand, false)->digits = s->method >= METHOD_RK4_LINEAR ? 11 : 9;
    test_run_begin(e);
    e->asked = e->sets.total;
    return e;
}

static void close_run(struct test_run *e)
{
    test_run_clear(e);
    free(e);
}

static void leave_run(struct test_run **e)
{
    close_run(*e);
}

/* A run that ends with its block. */
#define RUN CLEARED_BY(leave_run) struct test_run *

/* Those words for an answer to a question. */
static void answer(struct test_run *e, uint64_t position, const char *words)
{
    char line[LONG];
    TEST_VECTOR(q);
    test_vector_make(&q, &e->sets, position);
    const int size = snprintf(line, sizeof line, "%s %s\n", q.id, words);
    ck_assert_int_lt(size, LONG);
    e->next = position;
    test_run_hear(e, line, (size_t)size);
}

static const char *report_of(struct test_run *e)
{
    static char text[1 << 15];
    FILE *file = fmemopen(text, sizeof text, "w");
    const struct report r = {.run = e, .client = "client", .errors = ""};
    ck_assert_ptr_nonnull(file);
    report_text(&r, file);
    ck_assert_int_eq(fclose(file), 0);
    return text;
}

static const uint64_t *said(struct test_run *e, const char *text)
{
    test_run_hear(e, text, strlen(text));
    return e->summaries[0].counts;
}

/* The outcome on what is said in place of an answer. */
static enum outcome outcome_on(struct test_run *e, uint64_t position, const char *words)
{
    enum outcome outcome = OUTCOME_RIGHT;
    memset(e->summaries[0].counts, 0, sizeof e->summaries[0].counts);
    answer(e, position, words);
    while (outcome < OUTCOME_UNNAMED && e->summaries[0].counts[outcome] == 0)
        outcome++;
    return outcome;
}

static void assert_found(struct test_run *e, uint64_t position, const char *words, enum outcome due)
{
    const enum outcome outcome = outcome_on(e, position, words);
    ck_assert_msg(outcome == due, "%s, question %d: '%s' is %s, expected %s", e->comparators[0].operation->section->id, (int)position, words,
                  outcome < OUTCOMES ? outcome_names[outcome] : "nothing", outcome_names[due]);
    ck_assert_uint_eq(summary_failed(&e->summaries[0]), due >= OUTCOME_WRONG);
}

/* Right outputs as words; one of them (-1: none) as somebody else has it. */
static const char *right_but(char *const *outputs, int count, int output, const char *other)
{
    static char words[LONG];
    size_t used = 0;
    words[0] = '\0';
    for (int i = 0; i < count; i++)
        used += (size_t)snprintf(words + used, sizeof words - used, "%s%s", i ? " " : "", i == output ? other : outputs[i]);
    return words;
}

/* What is right, each output in so many digits. */
struct truth {
    char *of[MOST_OUTPUTS];
};

static void truth_clear(struct truth *t)
{
    for (int i = 0; i < MOST_OUTPUTS; i++)
        free(t->of[i]);
}

static struct truth truth_at(struct test_run *e, uint64_t position)
{
    struct truth t = {{NULL}};
    TEST_VECTOR(q);
    test_vector_make(&q, &e->sets, position);
    ck_assert_int_eq(operation_digits(e->comparators[0].operation, q.inputs, DIGITS, t.of), OPERATION_PROVED);
    return t;
}

/* The first question from a position on that lies inside the domain, or outside. */
static uint64_t question_that(struct test_run *e, uint64_t from, bool inside)
{
    uint64_t p = from;
    TEST_VECTOR(q);
    for (;; p++) {
        ck_assert_uint_lt(p, e->sets.total);
        test_vector_make(&q, &e->sets, p);
        if ((q.numbers && operation_valid(e->comparators[0].operation, q.inputs)) == inside)
            break;
    }
    return p;
}

/* ---- what passes: E <= K ---- */

/* y* + sign K u weight, where that is |y*| + S, of a root with its modulus */
static void limit_of(arb_t limit, const arb_t exact, const arb_t weight, int sign, double K, int significand)
{
    arb_set_d(limit, K);
    arb_mul(limit, limit, weight, BITS);
    arb_mul_2exp_si(limit, limit, -significand);
    arb_mul_si(limit, limit, sign, BITS);
    arb_add(limit, exact, limit, BITS);
}

static void weight_of(arb_t weight, arb_srcptr exact, arb_srcptr S, int k, bool roots)
{
    if (roots)
        arb_hypot(weight, exact + (k & ~1), exact + (k | 1), BITS);
    else
        arb_abs(weight, exact + k);
    arb_add(weight, weight, S + k, BITS);
}

/* Components of a vector: by an S that is at least the largest |y*| + S of the three, with inputs as large as their vectors. */
static void raise_to_vectors(arb_ptr S, arb_srcptr exact, struct operation *o, const struct input *inputs)
{
    const struct section *s = o->section;
    VECTOR(arb, size, s->output_count);
    VECTOR(arb, x, s->input_count);
    for (int i = 0; i < s->input_count; i++) {
        const int first = vector_of(s->inputs, s->input_count, i);
        double large = inputs[i].infinite ? INFINITY : fabs(fmpq_get_d(&inputs[i].value));
        for (int k = first; first >= 0 && k < first + 3; k++)
            large = fmax(large, fabs(fmpq_get_d(&inputs[k].value)));
        arf_set_d(arb_midref(x + i), large);
    }
    formula_sensitivity(o, BITS, x, size);
    for (int k = 0; k < s->output_count; k++) {
        SCOPE(arb, y);
        arb_abs(y, exact + k);
        arb_add(size + k, size + k, y, BITS);
    }
    for (int k = 0; k < s->output_count; k++)
        for (int first = vector_of(s->outputs, s->output_count, k), i = first; first >= 0 && i < first + 3; i++)
            arb_max(S + k, S + k, size + i, BITS);
}

/* In the sheet, of outputs; and of eq02's inputs, where masses and charges are three of a name as well. */
TEST(components_of_the_sheet_make_vectors)
{
    static const char *const none[] = {"eq05", "eq07", "eq09", "eq10inv", "eq12", "eq21", "eq30", "eq40", "eq41", "eq42"};
    static const char *const one[] = {"eq03", "eq04", "eq10", "eq10lin", "eq11", "eq11exact", "eq25", "eq26", "eq27", "eq28", "eq29", "eq36",
                                      "eq37", "eq39"};
    static const int firsts[] = {-1, -1, -1, -1, -1, 5, 5, 5, 8, 8, 8, -1, -1, 13, 13, 13, 16, 16, 16, -1, -1, 21, 21, 21, 24, 24, 24};
    const struct section *s = section_find(sheet(), "eq02");
    ck_assert_int_eq(s->input_count, COUNT(firsts));
    for (int i = 0; i < s->input_count; i++)
        ck_assert_int_eq(vector_of(s->inputs, s->input_count, i), firsts[i]);
    for (int i = 0; i < 9; i++)
        ck_assert_int_eq(vector_of(s->outputs, s->output_count, i), i / 3 * 3);
    for (size_t k = 0; k < COUNT(one); k++)
        for (int i = 0; i < 3; i++)
            ck_assert_int_eq(vector_of(section_find(sheet(), one[k])->outputs, 3, i), 0);
    for (size_t k = 0; k < COUNT(none); k++) {
        s = section_find(sheet(), none[k]);
        for (int i = 0; i < s->output_count; i++)
            ck_assert_msg(vector_of(s->outputs, s->output_count, i) < 0, "%s", none[k]);
    }
}

/* Names that no sheet has yet: what tells components apart, and what does not. */
TEST(components_are_told_by_the_first_letter_or_the_last_digit)
{
    static const struct {
        const char *names[4], *unit;
        int first;
    } rows[] = {{{"", "a1", "a2", "a3"}, "m", 1}, {{"a1", "a2", "a3", ""}, "m", 0}, {{"", "xa", "ya", "za"}, "m", 1}, {{"", "x", "y", "z"}, "m", 1},
                {{"", "a1", "a2", "a3"}, "s", -1}, {{"", "ab", "ac", "ad"}, "m", -1}, {{"", "a1", "a2", "a4"}, "m", -1}, {{"", "a1", "a3", "a2"}, "m", -1},
                {{"", "a11", "a12", "a13"}, "m", -1}, {{"", "xa", "ya", "wa"}, "m", -1}, {{"", "xa", "yb", "za"}, "m", -1}, {{"", "a1", "b2", "a3"}, "m", -1},
                {{"a1", "b", "a2", "a3"}, "m", -1}, {{"", "a2", "a3", "a4"}, "m", -1}, {{"", "ya", "za", "{a"}, "m", -1}, {{"", "a1", "a2", "a3b"}, "m", -1}};
    for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
        struct quantity four[4];
        const struct quantity *const all[] = {&four[0], &four[1], &four[2], &four[3]};
        for (int i = 0; i < 4; i++)
            four[i] = (struct quantity){.name = *rows[k].names[i] ? rows[k].names[i] : "other", .unit = i < 2 ? "m" : rows[k].unit};
        for (int i = 0; i < 4; i++)
            ck_assert_msg(vector_of(all, 4, i) == (rows[k].first >= 0 && *rows[k].names[i] ? rows[k].first : -1), "%s", rows[k].names[1]);
        ck_assert_int_eq(vector_of(all, 2, 1), -1);
    }
}

/* The last binary64 up to the limit passes, the next one does not. */
static void assert_limits(struct test_run *e, uint64_t position)
{
    struct operation *o = e->comparators[0].operation;
    const int count = o->section->output_count;
    VECTOR(arb, exact, count);
    VECTOR(arb, S, count);
    OWNED(truth) truth = truth_at(e, position);
    char **outputs = truth.of, text[40];
    SCOPE(arb, limit, weight);
    const bool roots = o->section->method == METHOD_ROOTS;
    TEST_VECTOR(q);
    test_vector_make(&q, &e->sets, position);
    operation_sensitivity(o, q.inputs, BITS, S);
    operation_enclose(o, q.inputs, BITS, exact);
    if (!roots)
        raise_to_vectors(S, exact, o, q.inputs);
    assert_found(e, position, right_but(outputs, count, -1, ""), OUTCOME_RIGHT);
    for (int i = 0; i < 2 * count; i++) {
        const int k = i / 2, sign = i % 2 ? 1 : -1;
        if (!arb_is_finite(S + k) || (arb_contains_zero(exact + k) && !arb_is_exact(exact + k)))
            continue;
        weight_of(weight, exact, S, k, roots);
        const double K = o->section->K, part = roots ? 1e-2 : 0.0; /* of a root the other part is rounded as well */
        limit_of(limit, exact + k, weight, sign, K * (1.0 - part), BINARY64);
        const double inner = arf_get_d(arb_midref(limit), sign > 0 ? ARF_RND_FLOOR : ARF_RND_CEIL);
        snprintf(text, sizeof text, "%.17g", inner);
        assert_found(e, position, right_but(outputs, count, k, text), OUTCOME_RIGHT);
        limit_of(limit, exact + k, weight, sign, K * (1.0 + part), BINARY64);
        double outer = roots ? arf_get_d(arb_midref(limit), sign > 0 ? ARF_RND_CEIL : ARF_RND_FLOOR) : nextafter(inner, sign * INFINITY);
        for (int n = 0; n < 3; n++)
            outer = nextafter(outer, sign * INFINITY); /* E is known but for a rounding of K, a binary64 */
        snprintf(text, sizeof text, "%.17g", outer);
        assert_found(e, position, right_but(outputs, count, k, text), OUTCOME_WRONG);
    }
}

EACH(each_output_passes_up_to_K_and_no_further, sheet()->section_count)
{
    const struct section *s = &sheet()->sections[_i];
    if (s->method != METHOD_FORMULA && s->method != METHOD_ROOTS)
        return;
    RUN e = run_of(s, RANDOM, BINARY64);
    const uint64_t random = (uint64_t)e->sets.all[0].golden_count;
    assert_limits(e, 0);
    assert_limits(e, random);
    e->comparators[0].bits = 10; /* with so few all radii count: what they leave open more bits decide, and nothing else */
    assert_limits(e, question_that(e, 1, true));
    assert_limits(e, random + 1);
}

/* A float's last bit is 2^29 of binary64's, quadruple precision's is read with all its digits. */
EACH(K_counts_roundings_of_the_clients_own_numbers, 2)
{
    static const int significands[] = {BINARY32, BINARY128};
    const int significand = significands[_i];
    RUN e = run_of(section_find(sheet(), "eq12"), RANDOM, significand);
    struct operation *o = e->comparators[0].operation;
    VECTOR(arb, exact, 1);
    VECTOR(arb, S, 1);
    SCOPE(arb, limit, weight);
    TEST_VECTOR(q);
    for (int i = 0; i < 8; i++) {
        const uint64_t p = i < 4 ? 0 : (uint64_t)e->sets.all[0].golden_count;
        const bool within = i % 4 < 2;
        test_vector_make(&q, &e->sets, p);
        operation_sensitivity(o, q.inputs, BITS, S);
        operation_enclose(o, q.inputs, BITS, exact);
        weight_of(weight, exact, S, 0, false);
        limit_of(limit, exact, weight, i % 2 ? 1 : -1, e->comparators[0].K * (within ? 1 - 1e-3 : 1 + 1e-3), significand);
        char *text = arb_get_str(limit, 50, ARB_STR_NO_RADIUS);
        assert_found(e, p, text, within ? OUTCOME_RIGHT : OUTCOME_WRONG);
        flint_free(text);
    }
}

/* ---- judgements on inputs of our own ---- */

struct judgement {
    struct operation operation;
    struct comparator comparator;
    struct input *inputs;
    struct score score;
};

static void judgement_begin(struct judgement *k, const char *operation, const char *const *inputs, int significand, double digits)
{
    const struct section *s = section_find(sheet(), operation);
    k->inputs = inputs_new(s->input_count);
    ck_assert(vector_read(s, inputs, k->inputs));
    operation_init(&k->operation, s, false);
    ck_assert(operation_valid(&k->operation, k->inputs));
    comparator_init(&k->comparator, &k->operation, significand, digits);
}

static enum outcome judgement_end(struct judgement *k)
{
    const enum outcome outcome = compare_answer(&k->comparator, k->inputs, &k->score);
    comparator_clear(&k->comparator);
    inputs_free(k->inputs, k->operation.section->input_count);
    operation_clear(&k->operation);
    return outcome;
}

/* Words between blanks. */
static void split(char *text, const char **words)
{
    char *rest = NULL;
    for (char *word = strtok_r(text, " ", &rest); word != NULL; word = strtok_r(NULL, " ", &rest))
        *words++ = word;
}

static enum outcome judged(const char *operation, const char *inputs, const char *answer, int significand)
{
    char given[300], *rest;
    const char *words[MOST_INPUTS];
    struct judgement k;
    snprintf(given, sizeof given, "%s", inputs);
    split(given, words);
    judgement_begin(&k, operation, words, significand, 9);
    for (int i = 0; i < k.operation.section->output_count; i++, answer = rest)
        arb_set_d(k.comparator.y + i, strtod(answer, &rest));
    return judgement_end(&k);
}

/* I = m1 m2 L^2/(m1 + m2) = 192/193, S = 3 I. */
TEST(E_is_said_from_above)
{
    static const char *const inputs[] = {"1", "192", "1"};
    const double y = nextafter(192.0 / 193.0, 2.0);
    struct judgement k;
    SCOPE(arb, E, said_E, strict);
    judgement_begin(&k, "eq32", inputs, BINARY64, 9);
    arb_set_d(k.comparator.y, y);
    ck_assert_int_eq(judgement_end(&k), OUTCOME_RIGHT);
    arb_set_d(E, y);
    arb_mul_si(E, E, 193, BITS);
    arb_div_si(E, E, 192, BITS);
    arb_sub_si(E, E, 1, BITS);
    arb_mul_2exp_si(E, E, BINARY64 - 2);
    arb_set_d(said_E, k.score.E);
    arb_set_d(strict, k.score.strict);
    ck_assert(arb_gt(said_E, E) && arb_gt(strict, E));
}

TEST(what_no_bound_decides_is_neither_right_nor_wrong)
{
    ck_assert_int_eq(outcome_of_bounds((struct error_bounds){7, 8}, 8), OUTCOME_RIGHT);
    ck_assert_int_eq(outcome_of_bounds((struct error_bounds){7, 8.0000001}, 8), OUTCOME_SKIPPED);
    ck_assert_int_eq(outcome_of_bounds((struct error_bounds){8, INFINITY}, 8), OUTCOME_SKIPPED);
    ck_assert_int_eq(outcome_of_bounds((struct error_bounds){8.0000001, INFINITY}, 8), OUTCOME_WRONG);
    ck_assert_int_eq(outcome_of_bounds((struct error_bounds){NAN, NAN}, 8), OUTCOME_SKIPPED);
}

/* What passes and what does not, by the least amount, on inputs of our own. */
static const struct {
    const char *operation, *inputs, *answer;
    int significand;
    enum outcome outcome;
} least[] = {
    /* C1 = n Omega^2 = 1 has S = 3: E = 2^53 |y - 1| / 4 is K = 8 at 1 + 2^-48, and E <= 8 passes */
    {"eq43", "1 1", "0x1.000000000001p0", BINARY64, OUTCOME_RIGHT},
    {"eq43", "1 1", "0x1.0000000000011p0", BINARY64, OUTCOME_WRONG},
    /* m1 = 1, m2 = 192, L = 1: I = 192/193 and S = 3 I, so E = K = 8 at I (1 + 32 2^-53) = 192 (2^48 + 1)/193 2^-48, which is a binary64, for 193
       divides 2^48 + 1: no enclosure of 1/193 ever tells E from 8 */
    {"eq32", "1 192 1", "0x1.fd58ded6e1800p-1", BINARY64, OUTCOME_SKIPPED},
    /* Omega = 1, C2 = 1: margin1 = C1 - 9 is 16 u an ulp of 9 (one of 9 is 2^-49), S = C1 + 18 = 27 and K u S = 216 u: 13 ulps are within,
       14 (224 u) are not. Of a float with u = 2^-24 the same is 216 2^-24 = 1.2875e-5, of quadruple precision less than an ulp of binary64 */
    {"eq42", "1 9.00000000000002309 1", "2.3092638912203256e-14 1 1", BINARY64, OUTCOME_RIGHT}, /* 9 + 13 2^-49 */
    {"eq42", "1 9.00000000000002309 1", "2.3092638912203256e-14 1 0", BINARY64, OUTCOME_RIGHT},
    {"eq42", "1 9.00000000000002487 1", "2.4868995751603507e-14 1 1", BINARY64, OUTCOME_RIGHT}, /* 9 + 14 2^-49 */
    {"eq42", "1 9.00000000000002487 1", "2.4868995751603507e-14 1 0", BINARY64, OUTCOME_WRONG},
    {"eq42", "1 8.99999999999997691 1", "-2.3092638912203256e-14 1 1", BINARY64, OUTCOME_RIGHT},
    {"eq42", "1 8.99999999999997513 1", "-2.4868995751603507e-14 1 1", BINARY64, OUTCOME_WRONG},
    {"eq42", "1 8.99999999999997513 1", "-2.4868995751603507e-14 1 0", BINARY64, OUTCOME_RIGHT},
    {"eq42", "1 9.0000128 1", "1.28e-5 1 0", BINARY32, OUTCOME_RIGHT},
    {"eq42", "1 9.0000129 1", "1.29e-5 1 0", BINARY32, OUTCOME_WRONG},
    {"eq42", "1 9.000000000000002 1", "1.7763568394002505e-15 1 0", BINARY128, OUTCOME_WRONG},
    {"eq42", "1 9 1", "0 1 0", BINARY128, OUTCOME_RIGHT},
    {"eq42", "1 9 1", "0 1 1", BINARY128, OUTCOME_RIGHT},
    /* either of the two, and nothing else */
    {"eq42", "1 9 1", "0 1 0.5", BINARY64, OUTCOME_WRONG},
    {"eq42", "1 9 1", "0 1 2", BINARY64, OUTCOME_WRONG},
    {"eq42", "1 9 1", "0 1 -1", BINARY64, OUTCOME_WRONG},
    {"eq42", "1 9 1", "0 1 1.0000000000000002", BINARY64, OUTCOME_WRONG},
    /* no rounding moves C2 = 0: it is not positive; and what is not stable by one margin is not saved by the other */
    {"eq42", "1 10 0", "1 0 0", BINARY64, OUTCOME_RIGHT},
    {"eq42", "1 10 0", "1 0 1", BINARY64, OUTCOME_WRONG},
    {"eq42", "1 9 0", "0 0 1", BINARY64, OUTCOME_WRONG},
    {"eq42", "1 9 0", "0 0 0", BINARY64, OUTCOME_RIGHT},
    {"eq42", "1 9 -1", "0 -1 1", BINARY64, OUTCOME_WRONG},
    {"eq42", "1 9 -1", "0 -1 0", BINARY64, OUTCOME_RIGHT},
    {"eq42", "1 10 2.2250738585072014e-308", "1 2.2250738585072014e-308 0", BINARY64, OUTCOME_WRONG},
    {"eq42", "1 10 -2.2250738585072014e-308", "1 -2.2250738585072014e-308 1", BINARY64, OUTCOME_WRONG},
    /* Omega is 299593 where C1 is that large: 2^21 - 1 = 49 127 337, Omega = 7 127 337: margin1 = 27 127 337 is K u (C1 + 18 Omega^2) = 2^-21 (27 Omega^2 + margin1) */
    {"eq42", "299593 807804846414 1", "1155573 1 0", BINARY32, OUTCOME_RIGHT},
    {"eq42", "299593 807804846414 1", "1155573 1 1", BINARY32, OUTCOME_RIGHT},
    {"eq42", "299593 807804846415 1", "1155574 1 0", BINARY32, OUTCOME_WRONG},
    {"eq42", "299593 807802535268 1", "-1155573 1 1", BINARY32, OUTCOME_WRONG}, /* S is less there */
    /* Omega = 1, C1 = 12, C2 = 4: (s^2 + 2 s + 3)^2. At z = -1 + d +- i sqrt(2) |p| = 8 d^2; its terms are 48 + 24 sqrt(3) = 89.6 and one
       rounding of Omega, C1, C2 does 72, 24 sqrt(3) = 41.6 and 24 to it: 227.1 in all, so |p| <= 8 u 227.1 up to d = 1.588e-7 */
    {"eq41roots", "1 12 4", "-1.000000158 -1.4142135623730951 -0.999999842 -1.4142135623730951 "
     "-1.000000158 1.4142135623730951 -0.999999842 1.4142135623730951", BINARY64, OUTCOME_RIGHT},
    {"eq41roots", "1 12 4", "-1.00000016 -1.4142135623730951 -0.99999984 -1.4142135623730951 "
     "-1.00000016 1.4142135623730951 -0.99999984 1.4142135623730951", BINARY64, OUTCOME_WRONG},
    /* past the most radians that are followed, and at rest on the orbit normal, where the craft fall into each other: whatever is answered */
    {"flow_nonlinear", "1 1 1 1 2 0 0 1e7 0 0 1 0 0 0", "0 0 0 0 0 0", BINARY64, OUTCOME_SKIPPED},
    /* the craft fall past each other, very close: the first bits do not follow them, and more do */
    {"flow_nonlinear", "1 1 1 1 2 0 0 3 0.08 0 1 0 0 0", "0 0 0 0 0 0", BINARY64, OUTCOME_WRONG},
};

EACH(an_answer_passes_up_to_the_least_amount, COUNT(least))
{
    ck_assert_int_eq(judged(least[_i].operation, least[_i].inputs, least[_i].answer, least[_i].significand), least[_i].outcome);
}

/* sin^2 + cos^2 - 1 for a formula: whatever balls say, it is zero, no rounding moves it, and nothing else is right. */
EACH(what_is_exactly_zero_has_no_roundings, 2)
{
    const struct section *s = section_find(sheet(), "eq43");
    const struct known_mistake zero = {.name = "zero", .changes = {{PLACE_OUTPUT, "C1", "sin(n)^2 + cos(n)^2 - 1"}}, .count = 1};
    struct score score;
    struct message why;
    OWNED(mutation) a;
    OWNED(comparator) j;
    INPUTS(inputs);
    ck_assert(mutation_init(&a, sheet(), s, &zero, true, &why));
    struct operation o = {.section = s, .formulas = &a.formulas};
    machine_init(&o.machine, &a.formulas.program, &arithmetic_ball, 128);
    ck_assert(vector_read(s, (const char *const[]){"1", "10"}, inputs));
    comparator_init(&j, &o, BINARY64, 9);
    arb_set_d(j.y, _i == 0 ? 0.0 : 1e-300);
    ck_assert_int_eq(compare_answer(&j, inputs, &score), _i == 0 ? OUTCOME_RIGHT : OUTCOME_WRONG);
    operation_clear(&o);
}

/* In whatever order, each of them once. */
EACH(eq41roots_are_a_set, 2)
{
    static const struct {
        int order[8];
        enum outcome outcome;
    } cases[] = {{{6, 7, 4, 5, 2, 3, 0, 1}, OUTCOME_RIGHT}, {{2, 3, 0, 1, 4, 5, 6, 7}, OUTCOME_RIGHT}, {{0, 1, 0, 1, 4, 5, 6, 7}, OUTCOME_WRONG},
                 {{4, 1, 2, 3, 0, 5, 6, 7}, OUTCOME_WRONG},  {{1, 0, 2, 3, 4, 5, 6, 7}, OUTCOME_WRONG}};
    RUN e = run_of(section_find(sheet(), "eq41roots"), RANDOM, BINARY64);
    const uint64_t p = _i == 0 ? 0 : (uint64_t)e->sets.all[0].golden_count;
    OWNED(truth) truth = truth_at(e, p);
    char *moved[MOST_OUTPUTS];
    for (int k = 0; k < COUNT(cases); k++) {
        for (int i = 0; i < 8; i++)
            moved[i] = truth.of[cases[k].order[i]];
        assert_found(e, p, right_but(moved, 8, -1, ""), cases[k].outcome);
    }
}

/* ---- what passes: digits ---- */

/* Where the coordinate that is off by the last digit due is moved so much, of the largest one: see PROTOCOL. Of golden vectors, and of random ones. */
EACH(a_motion_passes_with_the_digits_due_and_no_fewer, 8)
{
    static const char *const motions[] = {"flow_linear", "flow_nonlinear", "rk4_linear", "rk4_nonlinear"};
    static const char *const golden[] = {"flow_linear-rates-100", "flow_nonlinear-moving-100", "rk4_linear-rates-100", "rk4_nonlinear-moving-100"};
    const struct section *s = section_find(sheet(), motions[_i % 4]);
    const bool linear = _i % 2 == 0;
    RUN e = run_of(s, 1, BINARY64);
    const uint64_t p = _i < 4 ? test_sets_find(&e->sets, golden[_i]) : (uint64_t)e->sets.all[0].golden_count;
    OWNED(truth) truth = truth_at(e, p);
    char **outputs = truth.of, text[40];
    double scale = 0, unit[6];
    TEST_VECTOR(q);
    test_vector_make(&q, &e->sets, p);
    assert_found(e, p, right_but(outputs, 6, -1, ""), OUTCOME_RIGHT);
    ck_assert_double_ge(e->summaries[0].digits, e->comparators[0].digits + 4); /* how much better than declared is seen */
    const struct input *initial = q.inputs + (linear ? 5 : 8);
    const double L_ref = fmpq_get_d(&q.inputs[input_place(s, "L_ref")].value), Omega = fmpq_get_d(&q.inputs[input_place(s, "Omega")].value);
    for (int i = 0; i < 6; i++) { /* angles are numbers already */
        unit[i] = (linear && i % 3 < 2 ? 1 : L_ref) * (i < 3 ? 1 : Omega);
        scale = fmax(scale, fmax(fabs(strtod(outputs[i], NULL)), fabs(fmpq_get_d(&initial[i].value))) / unit[i]);
    }
    for (int i = 0; i < 24; i++) {
        const int k = i / 4;
        const double off = (i % 2 ? 1.001 : 0.999) * pow(10, -e->comparators[0].digits) * scale * unit[k];
        snprintf(text, sizeof text, "%.17g", strtod(outputs[k], NULL) + (i % 4 < 2 ? off : -off));
        assert_found(e, p, right_but(outputs, 6, k, text), i % 2 ? OUTCOME_WRONG : OUTCOME_RIGHT);
    }
    for (int k = 0; k < 6; k++) { /* however far off it is */
        assert_found(e, p, right_but(outputs, 6, k, "1e100"), OUTCOME_WRONG);
        assert_found(e, p, right_but(outputs, 6, k, "-1.7e308"), OUTCOME_WRONG);
    }
}

/*
 * Of a truth known to 9e-7 of the motion's size: more than a digit is right, fewer is wrong, and what lies between is neither. So many
 * digits as are proved pass, and so many as are not excluded do not fail: no more by the last bit.
 */
EACH(digits_that_the_enclosure_leaves_open_are_not_judged, 7)
{
    static const char *const texts[] = {"7.2915e-5", "10", "5.3e-8", "1.4e-4", "1", "1", "0", "0", "0", "0", "0"}; /* psi_0 = 1 */
    static const double answers[] = {0.099999, 0.0999995, 0.100001, 0.1, 0.1, 0.1, 0.1};
    static const enum outcome outcomes[] = {OUTCOME_RIGHT, OUTCOME_SKIPPED, OUTCOME_WRONG, OUTCOME_RIGHT, OUTCOME_SKIPPED, OUTCOME_SKIPPED, OUTCOME_WRONG};
    struct judgement k;
    SCOPE(arb, off);
    SCOPE(mag, bound);
    judgement_begin(&k, "flow_linear", texts, BINARY64, 1);
    k.comparator.followed = true;
    mag_set_d(arb_radref(k.comparator.exact), 9e-7);
    arb_set_d(k.comparator.y, answers[_i]);
    arb_sub(off, k.comparator.y, k.comparator.exact, BITS);
    (_i % 2 ? arb_get_mag : arb_get_mag_lower)(bound, off);
    if (_i >= 3)
        k.comparator.digits = _i < 5 ? -log10(mag_get_d(bound)) : nextafter(-log10(mag_get_d(bound)), 99);
    ck_assert_int_eq(judgement_end(&k), outcomes[_i]);
}

/*
 * At L = (1 - 3/n) L_ref, at rest as a length, the law asks for no charge; the relative orbit x = r sin(tau), y = 2 r cos(tau),
 * z = sqrt(3) r sin(tau) of Clohessy and Wiltshire has the constant length 2 r: it is a motion of the closed loop, but for what
 * rounds sqrt(3), in 11 digits.
 */
TEST(a_motion_without_charge_is_clohessys_and_wiltshires)
{
    const double times[] = {-7200, 100, 43200, 172800}, Omega = 7.2915e-5, r = 1.4;
    RUN e = run_of(section_find(sheet(), "flow_nonlinear"), 0, BINARY64);
    char id[60], words[400];
    e->comparators[0].digits = 11;
    for (int i = 0; i < 4; i++) {
        const double s = sin(Omega * times[i]), c = cos(Omega * times[i]);
        snprintf(id, sizeof id, "flow_nonlinear-no-charge-%g", times[i]);
        snprintf(words, sizeof words, "%.17g %.17g %.17g %.17g %.17g %.17g", r * s, 2 * r * c, sqrt(3) * r * s, r * Omega * c, -2 * r * Omega * s,
                 sqrt(3) * r * Omega * c);
        assert_found(e, test_sets_find(&e->sets, id), words, OUTCOME_RIGHT);
    }
    assert_found(e, test_sets_find(&e->sets, "flow_nonlinear-no-charge-at-rest-432000"), "0 1 0 0 0 0", OUTCOME_RIGHT);
}

/* Yaw of 0.1 rad dies away in five days, to 1e-7 and less; what is off is held against what there was, to as many digits as may be due. */
EACH(a_motion_that_dies_away_is_judged_by_what_there_was, 4)
{
    static const char *const texts[] = {"7.2915e-5", "10", "5.316597225e-8", "1.4583e-4", "432000", "0.1", "0", "0", "0", "0", "0"};
    static const char *const off[] = {"0.999e-10", "1.001e-10", "0.999e-31", "1.001e-31"};
    OWNED(truth) truth = {{NULL}};
    struct judgement k;
    SCOPE(arb, more);
    judgement_begin(&k, "flow_linear", texts, BINARY128, _i < 2 ? 9 : 30);
    ck_assert_int_eq(operation_digits(&k.operation, k.inputs, DIGITS, truth.of), OPERATION_PROVED);
    ck_assert_double_lt(fabs(strtod(truth.of[0], NULL)), 1e-6);
    for (int i = 0; i < 6; i++) {
        arb_set_str(k.comparator.y + i, truth.of[i], BITS);
        mag_zero(arb_radref(k.comparator.y + i));
    }
    arb_set_str(more, off[_i], BITS);
    arb_add(k.comparator.y, k.comparator.y, more, BITS);
    mag_zero(arb_radref(k.comparator.y));
    ck_assert_int_eq(judgement_end(&k), _i % 2 ? OUTCOME_WRONG : OUTCOME_RIGHT);
}

/* ---- outcomes of a line ---- */

/* On a question inside the domain: what is no answer, in each output. */
static void assert_inside(struct test_run *e, uint64_t position, char *const *outputs)
{
    const int count = e->comparators[0].operation->section->output_count;
    char more[LONG];
    assert_found(e, position, right_but(outputs, count, -1, ""), OUTCOME_RIGHT);
    assert_found(e, position, "invalid", OUTCOME_INVALID);
    assert_found(e, position, "invalid it is", OUTCOME_MALFORMED);
    assert_found(e, position, "Invalid", OUTCOME_MALFORMED);
    assert_found(e, position, "skip", OUTCOME_SKIPPED);
    assert_found(e, position, "skip not yet", OUTCOME_SKIPPED);
    assert_found(e, position, "skipping", OUTCOME_MALFORMED);
    assert_found(e, position, "Skip", OUTCOME_MALFORMED);
    assert_found(e, position, "", OUTCOME_COUNT);
    assert_found(e, position, right_but(outputs, count - 1, -1, ""), OUTCOME_COUNT);
    snprintf(more, sizeof more, "%s 0", right_but(outputs, count, -1, ""));
    assert_found(e, position, more, OUTCOME_COUNT);
    for (int k = 0; k < count; k++) {
        assert_found(e, position, right_but(outputs, count, k, "nan"), OUTCOME_NAN);
        assert_found(e, position, right_but(outputs, count, k, "inf"), OUTCOME_INFINITE);
        assert_found(e, position, right_but(outputs, count, k, "-1e999"), OUTCOME_INFINITE);
        snprintf(more, sizeof more, "%sx", outputs[k]);
        assert_found(e, position, right_but(outputs, count, k, more), OUTCOME_MALFORMED);
        snprintf(more, sizeof more, "%s,", outputs[k]);
        assert_found(e, position, right_but(outputs, count, k, more), OUTCOME_MALFORMED);
        assert_found(e, position, right_but(outputs, count, k, "-"), OUTCOME_MALFORMED);
    }
    for (int first = 0; first < 2 && count > 1; first++) { /* a number that is none tells more than one that is too large */
        snprintf(more, sizeof more, first ? "nan inf" : "inf nan");
        for (int k = 2; k < count; k++)
            snprintf(more + strlen(more), sizeof more - strlen(more), " %s", outputs[k]);
        assert_found(e, position, more, OUTCOME_NAN);
    }
}

static void assert_outside(struct test_run *e, uint64_t position)
{
    static const char *const values[] = {"0", "nan", "inf", "-1e999", "1"};
    assert_found(e, position, "invalid", OUTCOME_RIGHT);
    for (int w = 0; w < COUNT(values); w++) {
        char words[8 * MOST_OUTPUTS] = "";
        for (int k = 0; k < e->comparators[0].operation->section->output_count; k++)
            add_text(words, sizeof words, " ", values[w]);
        assert_found(e, position, words, OUTCOME_VALUE);
        add_text(words, sizeof words, " ", values[w]);
        assert_found(e, position, words, OUTCOME_COUNT);
    }
    assert_found(e, position, "invalid inputs", OUTCOME_MALFORMED);
    assert_found(e, position, "skip", OUTCOME_SKIPPED);
}

EACH(a_line_has_the_outcome_that_it_says, sheet()->section_count)
{
    const struct section *s = &sheet()->sections[_i];
    if (s->method == METHOD_NONE)
        return;
    RUN e = run_of(s, RANDOM, BINARY64);
    const uint64_t golden = (uint64_t)e->sets.all[0].golden_count;
    for (int random = 0; random < 2; random++) {
        const uint64_t p = question_that(e, random ? golden : 0, true);
        OWNED(truth) truth = truth_at(e, p);
        assert_inside(e, p, truth.of);
    }
    assert_found(e, golden, "invalid", OUTCOME_INVALID);
    assert_found(e, golden + RANDOM - 1, "invalid", OUTCOME_INVALID);
    assert_outside(e, question_that(e, 0, false));
    for (uint64_t p = golden + RANDOM; p < e->sets.total; p++)
        assert_outside(e, p);
}

/* ---- random questions ---- */

/* Each is answered by its truth and passes; those from inside are the vectors that `vectors` writes, by name and number. */
EACH(random_questions_are_those_of_the_seed, sheet()->section_count)
{
    const struct section *s = &sheet()->sections[_i];
    double values[MOST_INPUTS];
    char id[100];
    if (s->method == METHOD_NONE)
        return;
    RUN e = run_of(s, MANY, BINARY64);
    const uint64_t golden = (uint64_t)e->sets.all[0].golden_count;
    ck_assert_uint_eq(e->sets.total, golden + MANY + MANY / 16);
    INPUTS(inputs);
    TEST_VECTOR(q);
    for (uint64_t n = 0; n <= RANDOM; n++) {
        const uint64_t k = n < RANDOM ? n : MANY - 1;
        test_vector_make(&q, &e->sets, golden + k);
        sample(e->comparators[0].operation, 1, k, values, inputs);
        snprintf(id, sizeof id, "%s-1-%d", s->id, (int)k);
        ck_assert_str_eq(q.id, id);
        ck_assert_mem_eq(q.values, values, (size_t)s->input_count * sizeof *values);
        ck_assert(operation_valid(e->comparators[0].operation, q.inputs));
        if (is_motion(s))
            continue;
        OWNED(truth) truth = truth_at(e, golden + k);
        assert_found(e, golden + k, right_but(truth.of, s->output_count, -1, ""), OUTCOME_RIGHT);
    }
}

/* So many that each defect of the longest list, eq02's with its three conditions, has had its turn. */
EACH(random_questions_from_outside_have_every_defect, sheet()->section_count)
{
    const struct section *s = &sheet()->sections[_i];
    int nans[MOST_INPUTS] = {0}, last = 0;
    if (s->method == METHOD_NONE)
        return;
    RUN e = run_of(s, UINT64_C(16) * 150, BINARY64);
    TEST_VECTOR(q);
    for (uint64_t p = (uint64_t)e->sets.all[0].golden_count + 16 * 150; p < e->sets.total; p++) {
        int defects = 0;
        test_vector_make(&q, &e->sets, p);
        ck_assert_msg(!q.numbers || !operation_valid(e->comparators[0].operation, q.inputs), "%s", q.id);
        ck_assert_uint_eq(test_sets_find(&e->sets, q.id), p);
        for (int i = 0; i < s->input_count; i++) {
            nans[i] += isnan(q.values[i]);
            defects += !isfinite(q.values[i]);
        }
        ck_assert_int_le(defects, 1);
        last += q.numbers;
    }
    for (int i = 0; i < s->input_count; i++)
        ck_assert_msg(nans[i] > 0, "%s: %s is never nan", s->id, s->inputs[i]->name);
    ck_assert(last > 0 || s->corrected.count == 0);
}

/* Of a float's numbers, what leaves their range is not judged; and nothing else is left out, for floats or for doubles. */
EACH(what_leaves_the_clients_range_is_skipped_and_nothing_else, 4)
{
    const int significand = _i % 2 ? BINARY32 : BINARY64;
    const struct section *s = section_find(sheet(), _i < 2 ? "eq37" : "eq12");
    RUN e = run_of(s, RANDOM, significand);
    const uint64_t golden = (uint64_t)e->sets.all[0].golden_count;
    int left = 0;
    TEST_VECTOR(q);
    for (uint64_t p = golden; p < golden + RANDOM; p++) {
        OWNED(truth) truth = truth_at(e, p);
        test_vector_make(&q, &e->sets, p);
        const bool leaves = vector_leaves_range(e->comparators[0].operation, q.inputs, significand);
        assert_found(e, p, right_but(truth.of, s->output_count, -1, ""), leaves ? OUTCOME_SKIPPED : OUTCOME_RIGHT);
        e->range = true; /* on request it is judged */
        assert_found(e, p, right_but(truth.of, s->output_count, -1, ""), OUTCOME_RIGHT);
        e->range = false;
        left += leaves;
    }
    ck_assert((left > 0) == (_i == 1)); /* R_c^5 of eq37 */
}

/* ---- lines ---- */

static struct test_run *eq43(void)
{
    return run_of(section_find(sheet(), "eq43"), RANDOM, BINARY64);
}

/* C1 of n = 10 is 5.316597225e-8. */
TEST(a_line_may_have_65536_bytes)
{
    static char line[LONGEST_LINE + 3];
    for (int more = 0; more < 2; more++) {
        RUN e = eq43();
        memset(line, ' ', sizeof line);
        memcpy(line, "eq43-paper 5.316597225e-8", 25);
        line[LONGEST_LINE + more] = '\n';
        line[LONGEST_LINE + more + 1] = '\0';
        const uint64_t *counts = said(e, line);
        ck_assert_uint_eq(counts[OUTCOME_RIGHT], 1 - (uint64_t)more);
        ck_assert_uint_eq(e->strays[OUTCOME_TOO_LONG].count, (uint64_t)more);
        ck_assert_uint_eq(stray_count(e), (uint64_t)more);
    }
}

/* As many numbers as a line holds are too many, and no more than that. */
TEST(a_line_may_have_30000_words)
{
    static char line[LONGEST_LINE];
    RUN e = eq43();
    size_t used = (size_t)snprintf(line, sizeof line, "eq43-paper");
    for (int k = 0; k < 30000; k++)
        used += (size_t)snprintf(line + used, sizeof line - used, " 1");
    snprintf(line + used, sizeof line - used, "\n");
    ck_assert_uint_eq(said(e, line)[OUTCOME_COUNT], 1);
}

TEST(a_line_without_an_end_is_heard_for_64_MiB)
{
    enum { PIECE = 1 << 16 };
    static char piece[PIECE];
    RUN e = eq43();
    for (int k = 0; k < (1 << 10) - 1; k++)
        ck_assert(test_run_hear(e, piece, PIECE));
    ck_assert(test_run_hear(e, piece, PIECE - 1));
    ck_assert(!test_run_hear(e, piece, 1));
}

static const struct {
    const char *text;
    enum outcome outcome;
} lines[] = {
    {"eq43-paper 5.316597225e-8\n", OUTCOME_RIGHT},
    {"eq43-paper\t 0x1.c8b1359a0b635p-25 \r\n", OUTCOME_RIGHT}, /* the same binary64 */
    {" eq43-paper 5.316597225e-8\n", OUTCOME_RIGHT},
    {"eq43-paper 5.316597225e-8\r\r\n", OUTCOME_MALFORMED},
    {"eq43-paper 5.316597225e-8 \r \n", OUTCOME_MALFORMED},
    {"eq43-Paper 5.316597225e-8\n", OUTCOME_STRANGER},
    {"A0z_.- 5.316597225e-8\n", OUTCOME_STRANGER},
    {"eq43~paper 5.316597225e-8\n", OUTCOME_UNNAMED},
    {"eq43-paper: 5.316597225e-8\n", OUTCOME_UNNAMED},
    {"\n", OUTCOME_UNNAMED},
    {" \t\n", OUTCOME_UNNAMED},
    {"eq43 eq43-paper 5.316597225e-8\n", OUTCOME_STRANGER},
};

EACH(a_line_begins_with_a_vectors_name, COUNT(lines))
{
    RUN e = eq43();
    const uint64_t *counts = said(e, lines[_i].text);
    for (int i = 0; i < OUTCOMES; i++)
        ck_assert_msg((i < OUTCOME_UNNAMED ? counts[i] : e->strays[i].count) == (i == (int)lines[_i].outcome), "%s is %s", lines[_i].text, outcome_names[i]);
}

/* What people write in place of an answer, told in words: the line, and the word in it. */
static const struct {
    const char *operation, *heard, *says;
} odd[] = {
    {"eq44", "Tether library 2.1, all rights reserved\n", "the first is line 1: Tether library 2.1, all rights reserved\n    its first word 'Tether' names no vector\n"},
    {"eq44", "debug: n = 10\neq44-paper skip\ndebug: n = 9\n", "  2 no vector's name, the first is line 1: debug: n = 10\n    its first word 'debug:' names no vector: no name has a ':'\n"},
    {"eq44", "eq44 eq44-paper 1\n", "    'eq44' is an operation, the vector's name alone stands first\n"},
    {"eq44", "1.4e-4\n", "    '1.4e-4' is a number: a line begins with the vector's name, and has all its outputs\n"},
    {"eq44", "\357\273\277eq44-paper 1\n", "    a byte order mark stands before 'eq44-paper'\n"},
    {"eq44", "eq44-paper: 1\n", "    its first word 'eq44-paper:' names no vector: no name has a ':'\n"},
    {"eq25", "eq25-paper,1,2,3\n", "    its first word 'eq25-paper,1,2,3' names no vector: no name has a ','\n"},
    {"eq44", "\n", "    an empty line\n"},
    {"eq44", "eq44-paper skip\neq44-paper 1\n", "    its turn is over: answers come in the order of the questions, one each\n"},
    {"eq42", "eq42-paper 1 1 true\n", "  first malformed: eq42-paper 1 1 true\n    'true' is no number, 1 or 0 is due\n"},
    {"eq42", "eq42-paper INVALID\n", "    'INVALID': did you mean invalid, alone and in small letters?\n"},
    {"eq42", "eq42-paper Skip\n", "    'Skip': did you mean skip, alone and in small letters?\n"},
    {"eq44", "eq44-paper 1.2d-13\n", "    '1.2d-13' has Fortran's D exponent, E is due\n"},
    {"eq44", "eq44-paper 0,00014\n", "    '0,00014' has a decimal comma, a point is due\n"},
    {"eq25", "eq25-paper 1 [2 3]\n", "    '[2' is no number for its '['\n"},
    {"eq25", "eq25-paper 1, 2, 3\n", "    '1,' is no number for its ','\n"},
    {"eq44", "eq44-paper oops\n", "    'oops' is no number\n"},
    {"eq44", "eq44-paper 1.2", "  first truncated: eq44-paper 1.2\n    the last line has no LF\n"},
    {"eq44", "eq44-paper 1 2\n", "    2 numbers, eq44 has 1 output\n"},
    {"eq25", "eq25-paper 1\n", "    1 number, eq25 has 3 outputs\n"},
    {"eq44", "eq44-paper\n", "    nothing stands after the vector's name: numbers, invalid or skip are due\n"},
};

EACH(a_line_that_is_no_answer_is_told_in_words, COUNT(odd))
{
    RUN e = run_of(section_find(sheet(), odd[_i].operation), 0, BINARY64);
    said(e, odd[_i].heard);
    test_run_end(e, OUTCOME_MISSING);
    const char *report = report_of(e);
    ck_assert_msg(strstr(report, odd[_i].says) != NULL, "'%s' is not in:\n%s", odd[_i].says, report);
}

static const struct {
    const char *got, *expected;
    int at;
} digits[] = {
    {"0.00014584", "1.4583000000000000476e-04", 9}, {"1.4584e-4", "1.4583000000000000476e-04", 5}, {"1.458e-4", "1.4583000000000000476e-04", 5},
    {"-1.4583e-4", "1.4583000000000000476e-04", 1}, {"1e300", "1.4583000000000000476e-04", 0}, {"145.83", "145.83", -1},
    {"145.93", "145.83", 4}, {"+146", "145.83", 4}, {"0x1p3", "7", -1}, {"nan", "7", -1}, {"0", "1e-3", 1}, {"12345", "12355", 3},
    {"1e-99999999999999999999", "20", 0}, {"1e99999999999999999999", "20", 0}, {"3.1415926535897932394", "3.1415926535897932385", 20},
};

EACH(the_first_wrong_digit_is_found_as_it_was_written, COUNT(digits))
{
    ck_assert_msg(first_wrong_digit(digits[_i].got, digits[_i].expected) == digits[_i].at, "%s for %s: %d", digits[_i].got,
                  digits[_i].expected, first_wrong_digit(digits[_i].got, digits[_i].expected));
}

/* Of a quadruple precision client a number beyond binary64's range is one; infinity is none. */
TEST(a_number_beyond_1e308_is_one_at_113_bits)
{
    RUN e = run_of(section_find(sheet(), "eq43"), 0, BINARY128);
    assert_found(e, 0, "1e400", OUTCOME_WRONG);
    assert_found(e, 0, "-1e4000", OUTCOME_WRONG);
    assert_found(e, 0, "inf", OUTCOME_INFINITE);
    assert_found(e, 0, "nan", OUTCOME_NAN);
    close_run(e);
    e = run_of(section_find(sheet(), "eq43"), 0, BINARY64);
    assert_found(e, 0, "1e400", OUTCOME_INFINITE);
}

EACH(the_last_line_has_an_end, 4)
{
    static const char *const last[] = {"eq43-paper skip", "eq43-paper skip\n", "eq43-1-47 skip", "eq43-1-47 skip\n"};
    RUN e = eq43();
    const uint64_t *counts = said(e, last[_i]);
    test_run_end(e, OUTCOME_MISSING);
    ck_assert_uint_eq(counts[OUTCOME_SKIPPED], (uint64_t)(_i % 2));
    ck_assert_uint_eq(counts[OUTCOME_TRUNCATED], (uint64_t)(1 - _i % 2));
    ck_assert_uint_eq(counts[OUTCOME_MISSING], e->sets.total - 1);
}

/* A line more, of whatever operation, has its room. */
TEST(questions_are_sent_where_the_longest_has_room)
{
    static char room[2 * LONGEST_ID + LONGEST_INPUT * MOST_INPUTS + 1];
    RUN e = eq43();
    e->asked = 0;
    ck_assert_uint_eq(test_run_ask(e, room, sizeof room - 1), 0);
    ck_assert_uint_gt(test_run_ask(e, room, sizeof room), 0);
}

/* Of a binary64 client an answer means its nearest binary64: digits beyond are no merit. */
TEST(an_answer_is_the_nearest_binary64)
{
    RUN e = eq43();
    const uint64_t position = test_sets_find(&e->sets, "eq43-random-2");
    OWNED(truth) truth = truth_at(e, position);
    answer(e, position, truth.of[0]);
    ck_assert_double_gt(e->summaries[0].worst_E, 1e-3);
}

TEST(an_answer_is_due_once_its_question_is_sent)
{
    RUN e = eq43();
    e->asked = 2;
    said(e, "eq43-random-2 skip\neq43-1-0 skip\n");
    ck_assert_uint_eq(e->strays[OUTCOME_EARLY].count, 2);
    ck_assert_ptr_nonnull(strstr(report_of(e), "eq43-random-2 skip\n    its question had not been asked\n"));
    said(e, "eq43-random-1 skip\neq43-paper skip\neq43-random-1 skip\n");
    ck_assert_uint_eq(e->summaries[0].counts[OUTCOME_SKIPPED], 1);
    ck_assert_uint_eq(e->strays[OUTCOME_LATE].count, 2);
}

/* Whatever ended the client, the first vector without an answer and all after it fail: after the first golden one, and the first random one. */
EACH(what_is_not_answered_fails, 6)
{
    static const enum outcome ends[] = {OUTCOME_MISSING, OUTCOME_TIMEOUT, OUTCOME_CRASH};
    RUN e = eq43();
    const uint64_t left = _i < 3 ? e->sets.total - 1 : RANDOM - 1 + test_set_defects(&e->sets.all[0]);
    e->next = e->sets.total - left - 1;
    said(e, _i < 3 ? "eq43-paper skip\n" : "eq43-1-0 skip\n");
    test_run_end(e, ends[_i % 3]);
    ck_assert_uint_eq(e->summaries[0].counts[ends[_i % 3]], _i % 3 == 0 ? left : 1);
    ck_assert_uint_eq(summary_failed(&e->summaries[0]), left);
}

/* As many as there are questions twice, and 10000 at least. */
TEST(so_many_lines_out_of_place_are_heard)
{
    struct test_run *few = eq43(), *many = run_of(section_find(sheet(), "eq43"), 6000, BINARY64);
    const uint64_t most = 2 * many->sets.total;
    ck_assert_uint_gt(most, 10000);
    for (uint64_t k = 1; k <= most; k++) {
        const bool on = test_run_hear(many, "?\n", 2);
        ck_assert_msg(on == (k < most), "after %d of %d", (int)k, (int)most);
        if (k <= 10000)
            ck_assert(test_run_hear(few, "?\n", 2) == (k < 10000));
    }
    close_run(few);
    close_run(many);
}

/* A client that has ended, and left a pipe full of lines that answer nothing: no more of them are heard than make it hopeless. */
TEST(an_ended_client_is_heard_until_it_is_hopeless)
{
    char *flood[] = {"sh", "-c", "head -c 60000 /dev/zero | tr '\\0' '\\n'", NULL};
    struct client c;
    siginfo_t info;
    RUN e = eq43();
    ck_assert_int_eq(client_start(&c, flood), 0);
    ck_assert_int_eq(waitid(P_PID, (id_t)c.pid, &info, WEXITED | WNOWAIT), 0);
    ck_assert_int_eq(client_converse(&c, e, 60), ENDING_STOPPED);
    ck_assert_int_eq(client_close(&c), 0);
    ck_assert_uint_eq(stray_count(e), 3 * 4096); /* a read of 4096 bytes, and 10000 are too many */
}

/* Of two that are exact the first, of E and of digits; none whose E lies between two binary64, of which one is K. */
TEST(the_first_of_the_worst_answers_is_named)
{
    static const char *const answers[][2] = {{"eq42-boundary", "0 1 0"}, {"eq42-no-damping", "1 0 0"}, {"flow_linear-at-rest-100", "0 0 0 0 0 0"},
                                             {"flow_linear-at-rest-43200", "0 0 0 0 0 0"}};
    for (int k = 0; k < 4; k += 2) {
        RUN e = run_of(section_find(sheet(), k ? "flow_linear" : "eq42"), 0, BINARY64);
        assert_found(e, test_sets_find(&e->sets, answers[k][0]), answers[k][1], OUTCOME_RIGHT);
        assert_found(e, test_sets_find(&e->sets, answers[k + 1][0]), answers[k + 1][1], OUTCOME_RIGHT);
        ck_assert_uint_eq(e->summaries[0].worst, test_sets_find(&e->sets, answers[k][0]));
    }
    struct test_run *once = eq43(), *again = eq43();
    const uint64_t position = test_sets_find(&once->sets, "eq43-random-1");
    assert_found(once, position, "1", OUTCOME_WRONG);
    again->comparators[0].K = nextafter(once->summaries[0].worst_E, 0);
    assert_found(again, position, "1", OUTCOME_SKIPPED);
    ck_assert_uint_eq(again->summaries[0].worst, UINT64_MAX);
    close_run(once);
    close_run(again);
}

/* ---- mistakes and what finds them ---- */

/* A journal that can only be written: an error of its reading is not its end. */
TEST(a_journal_that_cannot_be_read_makes_no_report)
{
    RUN e = run_of(section_find(sheet(), "eq38"), 0, BINARY64);
    const struct report r = {.run = e, .client = "", .errors = ""};
    char name[512];
    snprintf(name, sizeof name, "%s/tests/unread.json", getenv("CT_BUILD"));
    remove(name);
    e->journal = fopen("/dev/null", "w");
    ck_assert_ptr_nonnull(e->journal);
    ck_assert_int_ne(report_write(&r, name), 0);
    ck_assert_int_ne(access(name, F_OK), 0);
}

/* Answers every question with those formulas. */
static void answer_all(struct test_run *e, const struct formulas *formulas)
{
    struct operation o = {.section = e->comparators[0].operation->section, .formulas = formulas};
    VECTOR(arb, y, MOST_OUTPUTS);
    machine_init(&o.machine, &formulas->program, &arithmetic_ball, 128);
    TEST_VECTOR(q);
    for (uint64_t p = 0; p < e->sets.total; p++) {
        char line[1000];
        test_vector_make(&q, &e->sets, p);
        const bool valid = q.numbers && operation_valid(&o, q.inputs);
        int used = snprintf(line, sizeof line, valid ? "%s" : "%s invalid", q.id);
        if (valid)
            operation_enclose(&o, q.inputs, 256, y);
        for (int i = 0; i < o.section->output_count && valid; i++)
            used += snprintf(line + used, sizeof line - (size_t)used, " %.17g", arf_get_d(arb_midref(y + i), ARF_RND_NEAR));
        snprintf(line + used, sizeof line - (size_t)used, "\n");
        said(e, line);
    }
    test_run_end(e, OUTCOME_MISSING);
    diagnose(e, 0);
    operation_clear(&o);
}

/* Every mistake of the sheet that the operation can make, all its formulas in turn. */
EACH(a_known_mistake_is_called_by_its_name, sheet()->section_count)
{
    const struct section *s = &sheet()->sections[_i];
    if (s->method != METHOD_FORMULA)
        return;
    for (int k = 0; k < s->mistake_count + sheet()->mistake_count; k++) {
        const struct known_mistake *mistake = k < s->mistake_count ? &s->mistakes[k] : &sheet()->mistakes[k - s->mistake_count];
        struct mutation a;
        struct message why;
        if (!mutation_init(&a, sheet(), s, mistake, false, &why))
            continue;
        struct test_run *e = run_of(s, 0, BINARY64);
        answer_all(e, &a.formulas);
        ck_assert_msg(summary_failed(&e->summaries[0]) < 2 || strstr(e->summaries[0].diagnosis, mistake->name) != NULL,
                      "%s: %s is taken for: %s", s->id, mistake->name, e->summaries[0].diagnosis);
        close_run(e);
        mutation_clear(&a);
    }
    if (s->differs) {
        struct test_run *e = run_of(s, 0, BINARY64);
        answer_all(e, &s->printed);
        ck_assert_uint_gt(summary_failed(&e->summaries[0]), 0);
        ck_assert_int_eq(strncmp(e->summaries[0].diagnosis, "the paper's misprint: ", 22), 0);
        close_run(e);
    }
    struct test_run *e = run_of(s, 0, BINARY64);
    answer_all(e, &s->corrected);
    ck_assert_uint_eq(summary_failed(&e->summaries[0]), 0);
    close_run(e);
}

/* What people compute and no sheet lists, in the names of what is right; and what it is told to be. */
static const struct {
    const char *section;
    enum place place;
    struct {
        const char *name, *formula;
    } changes[3];
    const char *diagnosis;
} computed[] = {
    {"eq43", PLACE_OUTPUT, {{"C1", "2*C1"}}, "a constant factor 2"},
    {"eq43", PLACE_OUTPUT, {{"C1", "-C1/2"}}, "a constant factor -0.5"},
    {"eq07", PLACE_OUTPUT, {{"Q_ref", "1.01*Q_ref"}}, "a constant factor 1.01"},
    {"eq10inv", PLACE_OUTPUT, {{"L", "psi"}, {"psi", "theta"}, {"theta", "L"}}, "the outputs in another order: psi theta L"},
    {"eq10inv", PLACE_OUTPUT, {{"psi", "atan2(x1, y1)"}}, "psi is that of atan2 with its arguments exchanged"},
    {"eq10inv", PLACE_OUTPUT, {{"psi", "psi + 3.14159265358979323846264*(1 - psi/sqrt(psi^2))"}}, "psi differs by 2 pi: it lies from -pi to pi"},
    {"eq25", PLACE_OUTPUT, {{"w_1", "0"}, {"w_3", "0"}}, "w_1, w_3 all zeros"},
    /* by names */
    {"eq43", PLACE_OUTPUT, {{"C1", "Omega*C1"}}, "a factor Omega too many"},
    {"eq07", PLACE_OUTPUT, {{"Q_ref", "Q_ref*(m1 + m2)/(m1*m2)"}}, "a factor m1*m2/(m1 + m2) is missing"},
    {"eq18", PLACE_OUTPUT, {{"dQ", "dQ*(m1 + m2)/(m1*m2)"}}, "a factor m1*m2/(m1 + m2) is missing"},
    {"eq32", PLACE_OUTPUT, {{"I", "m1*L^2"}}, "a factor m2/(m1 + m2) is missing"},
    {"eq15", PLACE_INPUT, {{"k_c", "k_c*(m1*m2/(m1 + m2))^2"}}, "k_c*(m1*m2/(m1 + m2))^2 in place of k_c"},
    {"eq44", PLACE_INPUT, {{"n", "n + 1"}}, "n + 1 in place of n"},
    {"eq44", PLACE_INPUT, {{"n", "n + 1.5"}}, ""}, /* no guess is better than a false one */
    {"eq40", PLACE_INPUT, {{"dL_dot", "psi_dot"}, {"psi_dot", "dL_dot"}}, "the inputs dL_dot and psi_dot exchanged"},
};
enum { KINDS = 7 }; /* before those by names */

static void make_mistake(struct mutation *a, int row)
{
    struct known_mistake m = {.name = "somebody's"};
    struct message why = {""};
    for (; m.count < 3 && computed[row].changes[m.count].name != NULL; m.count++) {
        m.changes[m.count].place = computed[row].place;
        m.changes[m.count].name = computed[row].changes[m.count].name;
        m.changes[m.count].formula = computed[row].changes[m.count].formula;
    }
    ck_assert_msg(mutation_init(a, sheet(), section_find(sheet(), computed[row].section), &m, true, &why), "%s", why.text);
}

EACH(a_mistake_that_people_make_is_told_in_words, COUNT(computed))
{
    OWNED(mutation) a;
    make_mistake(&a, _i);
    RUN e = run_of(a.section, 0, BINARY64);
    answer_all(e, &a.formulas);
    ck_assert_str_eq(e->summaries[0].diagnosis, computed[_i].diagnosis);
}

static void assert_kind(const struct evidence *v, const char *due)
{
    char text[400] = "";
    kind_of_formula(v, text, sizeof text);
    ck_assert_str_eq(text, due);
}

/* Twelve random vectors, more than any formula here has inputs, answered with the mistake. */
static void answered_so(struct evidence *v, struct record *records, struct operation *o, int row)
{
    OWNED(mutation) a;
    make_mistake(&a, row);
    struct operation wrong = {.section = o->section, .formulas = &a.formulas};
    INPUTS(inputs);
    VECTOR(arb, y, MOST_OUTPUTS);
    machine_init(&wrong.machine, &a.formulas.program, &arithmetic_ball, 128);
    *v = (struct evidence){.section = o->section, .until = clock() + 60 * CLOCKS_PER_SEC, .count = 12};
    for (int f = 0; f < v->count; f++) {
        sample(o, 3, (uint64_t)f, v->x[f], inputs);
        operation_enclose(o, inputs, 128, y);
        for (int k = 0; k < o->section->output_count; k++)
            v->exact[f][k] = arf_get_d(arb_midref(y + k), ARF_RND_NEAR);
        operation_enclose(&wrong, inputs, 128, y);
        for (int k = 0; k < o->section->output_count; k++) {
            v->y[f][k] = arf_get_d(arb_midref(y + k), ARF_RND_NEAR);
            v->tolerance[f][k] = 1e-9 * fabs(v->y[f][k]);
        }
        records[f] = (struct record){.outcome = OUTCOME_WRONG};
        snprintf(records[f].text, sizeof records[f].text, "%.17e", v->y[f][0]);
        v->records[f] = &records[f];
    }
    operation_clear(&wrong);
}

/* A kind is told of all vectors, and of none where the numbers of one, whichever it is, are others. */
EACH(a_kind_of_mistake_fits_every_vector, KINDS)
{
    static struct evidence v;
    static struct record records[MOST_KEPT];
    const struct section *s = section_find(sheet(), computed[_i].section);
    const char *due = computed[_i].diagnosis;
    OPERATION(o, s);
    answered_so(&v, records, &o, _i);
    assert_kind(&v, due);
    for (int f = 0; f < v.count; f++)
        for (int k = 0; k < s->output_count; k++) {
            const double kept = v.y[f][k];
            v.y[f][k] = kept > 0 || kept < 0 ? 1.25 * kept : 1;
            assert_kind(&v, "");
            v.y[f][k] = kept;
        }
    assert_kind(&v, due);
    v.count = 1; /* of one vector nothing is told */
    assert_kind(&v, "");
}

/*
 * Of (32), where S = 3 I: twice the value is told by every vector, and so is, as the last one, three times; I (1 + 2^-48), where E = K, by
 * none, which no bound decides; I itself does no harm; and without mistakes the random vectors pin nothing.
 */
EACH(the_kill_table_is_complete, 4)
{
    static const char *const formulas[] = {"3*I", "I*(1 + 1/2^48)", "I + 0", NULL};
    struct sheet alone = *sheet();
    struct section s = *section_find(sheet(), "eq32");
    struct known_mistake own = {.name = "twice", .changes = {{PLACE_OUTPUT, "I", "2*I"}}, .count = 1};
    struct known_mistake last = {.name = "somebody's", .changes = {{PLACE_OUTPUT, "I", formulas[_i]}}, .count = 1};
    s.mistakes = &own;
    alone.mistakes = &last;
    s.sheet = &alone;
    s.mistake_count = alone.mistake_count = formulas[_i] != NULL;
    fflush(stdout);
    const int ends[] = {dup(STDOUT_FILENO), dup(STDERR_FILENO)}, nowhere = open("/dev/null", O_WRONLY);
    ck_assert(dup2(nowhere, STDOUT_FILENO) >= 0 && dup2(nowhere, STDERR_FILENO) >= 0 && close(nowhere) == 0);
    const bool fine = kills_print(&s, 9);
    fflush(stdout);
    ck_assert(dup2(ends[0], STDOUT_FILENO) >= 0 && dup2(ends[1], STDERR_FILENO) >= 0 && close(ends[0]) == 0 && close(ends[1]) == 0);
    ck_assert(fine == (_i % 2 == 0));
}

/* A line that is no answer, and a skip, have nothing against a mistake that explains all the others. */
TEST(a_mistake_explains_numbers_and_not_lines)
{
    const struct section *s = section_find(sheet(), "eq38");
    RUN e = run_of(s, 0, BINARY64);
    said(e, "eq38-paper 7.3e-5 oops\neq38-random-1 skip\n");
    answer_all(e, &s->printed);
    ck_assert_uint_eq(e->summaries[0].counts[OUTCOME_MALFORMED], 1);
    ck_assert_int_eq(strncmp(e->summaries[0].diagnosis, "the paper's misprint: ", 22), 0);
}

/* ---- order ---- */

/* The number-th random question of eq43, skipped. */
static void skip(struct test_run *e, int number)
{
    char line[64];
    snprintf(line, sizeof line, "eq43-1-%d skip\n", number);
    said(e, line);
}

/* What is passed over is missing for good, and an answer that comes after all answers nothing. */
TEST(answers_come_in_the_order_of_the_questions)
{
    RUN e = run_of(section_find(sheet(), "eq43"), 9, BINARY64);
    const struct summary *t = &e->summaries[0];
    const uint64_t golden = (uint64_t)e->sets.all[0].golden_count;
    skip(e, 3);
    ck_assert_uint_eq(t->counts[OUTCOME_MISSING], golden + 3);
    skip(e, 1);
    skip(e, 3);
    ck_assert_uint_eq(e->strays[OUTCOME_LATE].count, 2);
    skip(e, 8);
    test_run_end(e, OUTCOME_MISSING);
    ck_assert_uint_eq(t->counts[OUTCOME_MISSING], golden + 7 + test_set_defects(&e->sets.all[0]));
    ck_assert_uint_eq(t->counts[OUTCOME_SKIPPED], 2);
}

/* What was heard of it is no answer to what it begins with. */
TEST(a_line_without_an_end_may_be_too_long_as_well)
{
    RUN e = run_of(section_find(sheet(), "eq43"), 0, BINARY64);
    for (int i = 0; i <= LONGEST_LINE; i++)
        said(e, "1");
    test_run_end(e, OUTCOME_MISSING);
    ck_assert_uint_eq(e->strays[OUTCOME_TOO_LONG].count, 1);
    ck_assert_uint_eq(e->summaries[0].counts[OUTCOME_MISSING], e->sets.total);
}

EACH(an_id_is_the_one_that_was_sent_to_the_letter, 16)
{
    static const char *const strangers[] = {"eq43", "eq43-", "eq43-1", "eq43-1-", "eq43-1-5", "eq43-01-4", "eq43-1-04",
                                            "eq43-2-4", "eq43-1-4x", "eq44-1-4", "eq4-1-4", "eq43-papers", "eq43-1-outside-1",
                                            "eq43-1-outside-", "eq43-1-outside", "eq43-1-outside-00"};
    RUN e = run_of(section_find(sheet(), "eq43"), 5, BINARY64);
    ck_assert_uint_eq(test_sets_find(&e->sets, "eq43-paper"), 0);
    ck_assert_uint_eq(test_sets_find(&e->sets, "eq43-1-4"), e->sets.total - 2);
    ck_assert_uint_eq(test_sets_find(&e->sets, "eq43-1-outside-0"), e->sets.total - 1);
    ck_assert_uint_eq(test_sets_find(&e->sets, strangers[_i]), UINT64_MAX);
}

/* Of two operations, the first of which begins as the second does. */
TEST(an_id_is_not_that_of_an_operation_that_begins_alike)
{
    struct test_sets sets = {.seed = 1};
    test_sets_add(&sets, section_find(sheet(), "eq11exact"), 5, BINARY64, false);
    test_sets_add(&sets, section_find(sheet(), "eq11"), 5, BINARY64, false);
    ck_assert_uint_eq(test_sets_find(&sets, "eq11-paper"), sets.all[1].first);
    ck_assert_uint_eq(test_sets_find(&sets, "eq11exact-1-4"), sets.all[1].first - 2); /* one from outside comes after it */
    ck_assert(test_sets_want(&sets, "eq11-random-3") && test_sets_want(&sets, "eq11-paper"));
    ck_assert_uint_eq(test_sets_find(&sets, "eq11-paper"), sets.all[1].first + 1);
    test_sets_clear(&sets);
}

/* ---- judgement ---- */

static const struct {
    const char *id, *outputs;
    enum outcome outcome;
} judgements[] = {
    /* Omega = 1, C1 = 12, C2 = 4: (s^2 + 2 s + 3)^2, the roots -1 +- i sqrt(2) twice, and not one of them four times */
    {"eq41roots-free-gains", "-1 1.4142135623730951 -1 1.4142135623730951 -1 1.4142135623730951 -1 1.4142135623730951", OUTCOME_WRONG},
    /* Omega = 1, C1 = 9, C2 = 0: s^2 (s^2 + 7), sqrt(7) = 2.6457513110645906; in any order */
    {"eq41roots-double-zero", "0 2.6457513110645906 0 0 0 -2.6457513110645906 0 0", OUTCOME_RIGHT},
    {"eq41roots-double-zero", "0 2.6457513110645906 0 0 0 2.6457513110645906 0 0", OUTCOME_WRONG},
    /* an infinite S excuses nothing; of theta it is infinite on the normal, |z| by |z| over zero, and pi/2 = 1.5707963267948966192 */
    {"eq44-boundary", "0", OUTCOME_RIGHT},
    {"eq44-boundary", "-0.0", OUTCOME_RIGHT},
    {"eq44-boundary", "1e-300", OUTCOME_WRONG},
    {"eq10inv-on-the-normal", "10 0 -1.5707963267948966", OUTCOME_RIGHT},
    {"eq10inv-on-the-normal", "10 0 -1.570796326794890", OUTCOME_WRONG},
    /* at rest: exactly so, for ever; theta = 0.5 cos(2 tau) is the scale of psi's error: 4e-10 of 0.5 are 9 digits, 4e-9 are not */
    {"flow_linear-at-rest-43200", "0 0 0 0 0 0", OUTCOME_RIGHT},
    {"flow_linear-at-rest-43200", "0 0 1e-30 0 0 0", OUTCOME_WRONG},
    {"flow_linear-pitch-alone-0", "4e-10 0.5 0 0 0 0", OUTCOME_RIGHT},
    {"flow_linear-pitch-alone-0", "4e-9 0.5 0 0 0 0", OUTCOME_WRONG},
};

EACH(an_answer_is_judged_as_PROTOCOL_says, COUNT(judgements))
{
    char operation[40];
    snprintf(operation, sizeof operation, "%.*s", (int)strcspn(judgements[_i].id, "-"), judgements[_i].id);
    RUN e = run_of(section_find(sheet(), operation), 0, BINARY64);
    assert_found(e, test_sets_find(&e->sets, judgements[_i].id), judgements[_i].outputs, judgements[_i].outcome);
}

/* What data/golden says of a motion is the truth that an answer is held against, where it has a row of the same inputs. */
TEST(golden_motions_are_held_against_what_data_has)
{
    const char *const motions = embedded_sources().motions.text, name[] = "\nflow_nonlinear-paper-100,";
    RUN e = run_of(section_find(sheet(), "flow_nonlinear"), 0, BINARY64);
    const char *const row = strstr(motions, name);
    char text[LONG], words[LONG];
    ck_assert_ptr_nonnull(row);
    snprintf(text, sizeof text, "%.*s\n", 1 + (int)strcspn(row + 1, "\n"), row);
    char *outputs = text, *const t = strstr(text, ",100,") + 1; /* after the 14 inputs, and among them the time */
    for (int i = 0; i < 15; i++)
        outputs = strchr(outputs, ',') + 1;
    snprintf(words, sizeof words, "%s", outputs);
    *strrchr(words, ',') = '\0'; /* the flags */
    for (char *c = words; *c != '\0'; c++)
        *c = *c == ',' ? ' ' : *c;
    const uint64_t position = test_sets_find(&e->sets, "flow_nonlinear-paper-100");
    const struct {
        const char *motions;
        char *at, digit;
        enum outcome due;
    } cases[] = {{NULL, NULL, 0, OUTCOME_RIGHT},         {"", NULL, 0, OUTCOME_RIGHT}, {motions, NULL, 0, OUTCOME_RIGHT},
                 {text, NULL, 0, OUTCOME_RIGHT},         {text, outputs + 8, '0', OUTCOME_WRONG}, /* the eighth digit of x1 */
                 {text, t, '2', OUTCOME_RIGHT},          {text, t, '1', OUTCOME_WRONG}, /* with that digit still, and of another time */
                 {text, outputs, 'x', OUTCOME_RIGHT},    {text, outputs, '5', OUTCOME_WRONG}, /* no number is no truth */
                 {text, strchr(outputs, ',') + 1, 'x', OUTCOME_RIGHT}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        if (cases[i].at != NULL)
            *cases[i].at = cases[i].digit;
        e->sets.motions = cases[i].motions;
        assert_found(e, position, words, cases[i].due);
    }
}

/* It is rounded to 40 digits: more of them are computed. */
TEST(more_digits_than_data_has_are_computed)
{
    const struct section *s = section_find(sheet(), "flow_linear");
    RUN e = run_of(s, 0, BINARY128);
    const uint64_t position = test_sets_find(&e->sets, "flow_linear-paper-100");
    VECTOR(arb, truth, MOST_OUTPUTS);
    VECTOR(arb, rounded, MOST_OUTPUTS);
    TEST_VECTOR(q);
    e->sets.motions = embedded_sources().motions.text;
    test_vector_make(&q, &e->sets, position);
    ck_assert(test_vector_truth(rounded, &q, &e->sets));
    ck_assert(operation_follow(e->comparators[0].operation, q.inputs, 60, 400, truth) == OPERATION_PROVED);
    for (int k = 0; k < s->output_count; k++) {
        ck_assert(arb_contains(rounded + k, truth + k));
        ck_assert(arb_rel_accuracy_bits(rounded + k) >= 128 && arb_rel_accuracy_bits(rounded + k) < 133);
    }
}
