/*
 * Exact numbers: what is decided of a formula, by identities of the school book, and what has to stay undecided. Each
 * irrational number is held against a ball of the same formula.
 */
#include <string.h>

#include "tests/run.h"
#include "formula/exact.h"
#include "formula/expression.h"
#include "text/scope.h"

/* z is an input: an exact zero, which no formula shows; inf is +infinity. A result p/q is rational; others are named. */
static const struct {
    const char *formula, *expected;
} decided[] = {
    {"2/3 + -5/7", "-1/21"},
    {"2/3 - -5/7", "29/21"},
    {"2/3*(-5/7)", "-10/21"},
    {"2/3/(-5/7)", "-14/15"},
    {"z", "0"},
    /* roots */
    {"sqrt(4/9)", "2/3"},
    {"sqrt(8/18)", "2/3"},
    {"sqrt(z)", "0"},
    {"sqrt(2)", "irrational"},
    {"sqrt(8) - 2*sqrt(2)", "0"},
    {"sqrt(2) - 2*sqrt(1/2)", "0"},
    {"sqrt(2)*sqrt(3)*sqrt(6)", "6"},
    {"sqrt(3)^4", "9"},
    {"sqrt(2)^0", "1"},
    {"sqrt(2) - sqrt(3)", "irrational"},
    {"(sqrt(2) + sqrt(3))^2 - sqrt(24)", "5"},
    {"1/(1 + sqrt(2)) - sqrt(2)", "-1"},
    {"4/(1 + sqrt(2) + sqrt(3)) - sqrt(2) + sqrt(6)", "2"},
    {"(1 + sqrt(2) + sqrt(3) + sqrt(5))/(1 + sqrt(2) + sqrt(3) + sqrt(5))", "1"},
    {"sqrt(3 + 2*sqrt(2)) - sqrt(2)", "1"}, /* of what is no fraction, too */
    /* exponentials and angles */
    {"exp(z)", "1"},
    {"cos(z)", "1"},
    {"sin(z)", "0"},
    {"exp(1)", "irrational"},
    {"sin(7/3)^2 + cos(7/3)^2", "1"},
    {"sin(7/3)^2", "irrational"},
    {"sin(-1/3)*cos(sqrt(5)) - cos(-1/3)*sin(sqrt(5)) - sin(-1/3 - sqrt(5))", "0"},
    {"exp(sqrt(2) + 1/3) - exp(sqrt(8)/2)*exp(1/3)", "0"},
    {"exp(sqrt(2)) - exp(sqrt(2) + 1/3)", "irrational"},
    {"1/(sqrt(3/5)*exp(sqrt(3/5)))^2*(sqrt(3/5)*exp(sqrt(3/5)))^2", "1"},
    {"z/(1 + cos(1))", "0"},
    {"atan2(z, sqrt(2) - 1)", "0"},
    {"log(1)", "0"},
    {"log(2)", "irrational"},
    /* signs */
    {"positive(1/1000)", "1"},
    {"positive(-1/1000)", "0"},
    {"positive(z)", "0"},
    {"positive(sin(22/7))", "0"},    /* 22/7 > pi */
    {"positive(sin(333/106))", "1"}, /* 333/106 < pi */
    {"positive(exp(1) - 2721/1001)", "1"}, /* convergents of e: less by 1.1e-7, */
    {"positive(exp(1) - 1457/536)", "0"},  /* greater by 1.8e-6 */
    {"positive(exp(-1000))", "1"},
    {"positive((sqrt(2) + sqrt(3))^2 - 5 - sqrt(24))", "0"},
    /* an infinite Debye length */
    {"-5/inf", "0"},
    {"exp(-5/inf)", "1"},
    {"sqrt(2)/inf", "0"},
    {"inf", "undefined"},
    {"inf/inf", "undefined"},
    {"z*inf", "undefined"},
    {"inf + 1", "undefined"},
    /* no number, and what rests on it */
    {"1/z", "undefined"},
    {"z/z", "undefined"},
    {"z*(1/z)", "undefined"},
    {"1/z - 1/z", "undefined"},
    {"sqrt(-4)", "undefined"},
    {"sqrt(sqrt(2) - 3/2)", "undefined"},
    {"sqrt(-4)^2", "undefined"},
    {"sqrt(atan2(1, 1))", "undefined"}, /* for all that is known of it, it may be negative */
    /* not decided */
    {"log(z)", "unknown"},
    {"atan2(1, 1)", "unknown"},
    {"atan2(z, z)", "unknown"},
    {"atan2(z, 1 - sqrt(2))", "unknown"}, /* pi */
    {"positive(atan2(1, 1))", "unknown"},
    {"atan2(1, 1) - atan2(1, 1)", "unknown"},
};

static const char *kind_of(const struct exact *x, fmpq_t value)
{
    if (exact_is_rational(value, x))
        return "rational";
    return exact_is_undefined(x) ? "undefined" : CA_IS_UNKNOWN(&x->value) ? "unknown" : "irrational";
}

struct evaluation {
    struct program p;
    struct machine m;
    int node;
};

static void evaluation_clear(struct evaluation *e)
{
    machine_clear(&e->m);
    program_clear(&e->p);
}

/* The formula in an arithmetic, z = 0 and inf infinite; its value. */
static const void *evaluate(struct evaluation *e, const struct arithmetic *a, const char *text)
{
    struct message why;
    SCOPE(fmpq, zero);
    program_init(&e->p);
    program_input(&e->p, "z");
    program_input(&e->p, "inf");
    e->node = program_parse(&e->p, text, &why);
    ck_assert_msg(e->node >= 0, "%s: %s", text, why.text);
    machine_init(&e->m, &e->p, a, 128);
    a->set_rational(machine_value(&e->m, 0), zero, 128);
    a->set_infinity(machine_value(&e->m, 1));
    machine_run(&e->m);
    return machine_value(&e->m, e->node);
}

EACH(formula_is_decided, COUNT(decided))
{
    OWNED(evaluation) exactly, in_balls;
    SCOPE(fmpq, value, expected);
    const struct exact *x = evaluate(&exactly, &arithmetic_exact, decided[_i].formula);
    arb_srcptr ball = evaluate(&in_balls, &arithmetic_ball, decided[_i].formula);
    const bool rational = fmpq_set_str(expected, decided[_i].expected, 10) == 0;
    ck_assert_str_eq(kind_of(x, value), rational ? "rational" : decided[_i].expected);
    ck_assert_int_eq(exact_is_zero(x), rational && fmpq_is_zero(expected));
    ck_assert(!rational || fmpq_equal(value, expected));
    ck_assert(!rational || !arb_is_finite(ball) || arb_contains_fmpq(ball, expected));
    ck_assert(strcmp(decided[_i].expected, "irrational") != 0 || !arb_contains_zero(ball));
}

/* Derivatives run backwards, through values that are copied: of sqrt(exp(z) + 3), the last of them, at 0 it is 1/4. */
TEST(gradient_is_exact)
{
    OWNED(evaluation) e;
    OWNED(gradient) slope;
    SCOPE(fmpq, value, expected);
    evaluate(&e, &arithmetic_exact, "sqrt(exp(z) + 3)");
    gradient_init(&slope, &e.p, &e.node, 1, &arithmetic_exact, 0);
    gradient_run(&slope, &e.m);
    fmpq_set_si(expected, 1, 4);
    ck_assert(exact_is_rational(value, gradient_value(&slope, 0, 0)) && fmpq_equal(value, expected));
}
