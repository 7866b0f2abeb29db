/*
 * Formulas: the parser, series and normal forms, derivatives and gradients. Expected values are exact rationals,
 * worked out in the comment beside them or by another road: the derivative of a program against the first
 * coefficient of its series, the gradient against the derivative.
 */
#include "tests/run.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "formula/expression.h"
#include "formula/symbolic.h"
#include "text/scope.h"


/* The coefficient of epsilon^k, a number. */
static void get_coefficient(fmpq_t q, const void *value, slong k)
{
    const struct symbolic *x = value;
    const struct symbolic one = {.a = x->a + k, .terms = 1, .fault = x->fault};
    SCOPE(fmpq_poly, f);
    symbolic_get_polynomial(f, &one);
    fmpq_poly_get_coeff_fmpq(q, f, 0);
}

static enum symbolic_fault state(const void *value)
{
    const struct symbolic *x = value;
    return x->angle ? SYMBOLIC_ANGLE_AS_NUMBER : x->fault;
}

/* ---- the parser ---- */

/* A formula without inputs, as an exact rational; "" and the mistake's text when it has none. */
static void evaluate(const char *formula, char text[200], size_t *where)
{
    struct program p;
    struct message why = {""};
    program_init(&p);
    int node = program_parse(&p, formula, where, &why);
    if (node < 0) {
        snprintf(text, 200, "%.199s", why.text);
    } else {
        struct machine m;
        machine_init(&m, &p, &arithmetic_symbolic, 1);
        machine_run(&m);
        SCOPE(fmpq, value);
        get_coefficient(value, machine_value(&m, node), 0);
        char *digits = fmpq_get_str(NULL, 10, value);
        enum symbolic_fault fault = state(machine_value(&m, node));
        snprintf(text, 200, "%.199s", fault == SYMBOLIC_FINE ? digits : symbolic_fault_text(fault));
        flint_free(digits);
        machine_clear(&m);
    }
    program_clear(&p);
}

static const struct {
    const char *formula, *value;
} values[] = {
    {"2 + 3*4", "14"},
    {"(2 + 3)*4", "20"},
    {"2 - 3 - 4", "-5"},       /* from the left */
    {"12/3/2", "2"},           /* from the left */
    {"12/(3/2)", "8"},
    {"2*-3", "-6"},
    {"2 - -3", "5"},
    {"--3", "3"},
    {"-2^2", "-4"},            /* the power binds closer than the sign */
    {"(-2)^2", "4"},
    {"2^-2", "1/4"},
    {"2*3^2", "18"},
    {"0^0", "1"},
    {"1.5e1 - .5 + 5.", "39/2"},
    {"1e-3", "1/1000"},
    {"1e+3", "1000"},
    {"0.1 + 0.2", "3/10"},     /* decimals, not doubles */
    {"sqrt(16/9)", "4/3"},
    {"sqrt(0)", "0"},
    {"exp(0) + cos(0) + sin(0)", "2"},
    {"cos(atan2(4, 3))", "3/5"}, /* 3, 4, 5 */
    {"sin(atan2(4, 3) + atan2(4, 3))", "24/25"},
    {"cos(atan2(0, -1))", "-1"},
    {"1/(1/0)", "0"},          /* a pole may be divided by */
    {"((((1))))", "1"},
    {" 1\n + 1\t", "2"},
    {"1/0", "division by what is zero at epsilon = 0"},
    {"0/0", "division by what is zero at epsilon = 0"},
    {"1/0 + 1", "division by what is zero at epsilon = 0"},
    {"0^-1", "division by what is zero at epsilon = 0"},
    {"atan2(0, 0)", "division by what is zero at epsilon = 0"},
    {"sqrt(2)", "the square root of no square of a rational function"},
    {"1/sqrt(2)", "the square root of no square of a rational function"},
    {"1/(1/sqrt(2))", "the square root of no square of a rational function"},
    {"atan2(0, 1) + sqrt(2)*exp(0)", "the square root of no square of a rational function"},
    {"sqrt(-4)", "the square root of no square of a rational function"},
    {"atan2(1, 1)", "the square root of no square of a rational function"},
    {"sin(1)", "the sine or cosine of a number that is no angle"},
    {"atan2(4, 3)", "a finite angle outside sine and cosine"},
    {"2*atan2(4, 3)", "a finite angle outside sine and cosine"},
    {"exp(1)", "a value that is no rational series, or whose sign is not known"},
    {"positive(1)", "a value that is no rational series, or whose sign is not known"},
};

static void begin(void)
{
    symbolic_begin(0, 0);
}

CASE(formulas, begin, symbolic_end)

EACH(formula_has_its_value, COUNT(values))
{
    char text[200];
    size_t where;
    evaluate(values[_i].formula, text, &where);
    ck_assert_str_eq(text, values[_i].value);
}

static const struct {
    const char *formula;
    size_t where;
    const char *expected;
} mistakes[] = {
    {"", 0, "expected a number, a symbol or '(', the formula ends here"},
    {"1 +", 3, "expected a number, a symbol or '(', the formula ends here"},
    {"1 + ^2", 4, "expected a number, a symbol or '(', found '^'"},
    {"1 + *2", 4, "expected a number, a symbol or '(', found '*'"},
    {"(1 + 2", 6, "expected ')' or an operator, the formula ends here"},
    {"1 + 2)", 5, "expected an operator or the end of the formula, found ')'"},
    {"1 2", 2, "expected an operator or the end of the formula, found '2'"},
    {"2x", 1, "expected an operator or the end of the formula, found 'x'"},
    {"1.2.3", 0, "expected a decimal number, found '1'"},
    {"1e", 0, "expected a decimal number, found '1'"},
    {"2^0.5", 3, "expected an operator or the end of the formula, found '.'"},
    {"2^n", 2, "expected an integer exponent of at most three digits, found 'n'"},
    {"2^1000", 2, "expected an integer exponent of at most three digits, found '1'"},
    {"1 + Omga", 4, "unknown symbol 'Omga', expected an input or a named subexpression"},
    {"sin 1", 4, "expected '(', found '1'"},
    {"sin(1", 5, "expected ')' or an operator, the formula ends here"},
    {"atan2(1)", 7, "expected ',' and the second argument of atan2, found ')'"},
    {"atan2(1, )", 9, "expected a number, a symbol or '(', found ')'"},
    {"rate(1)", 0, "unknown symbol 'rate', expected an input or a named subexpression"},
    {"1 # 2", 2, "expected an operator or the end of the formula, found '#'"},
};

EACH(mistake_is_told_with_its_place, COUNT(mistakes))
{
    char text[200];
    size_t where;
    evaluate(mistakes[_i].formula, text, &where);
    ck_assert_str_eq(text, mistakes[_i].expected);
    ck_assert_uint_eq(where, mistakes[_i].where);
}

TEST(unknown_symbol_has_a_suggestion)
{
    struct program p;
    struct message why = {""};
    size_t where;
    program_init(&p);
    program_input(&p, "Omega");
    ck_assert_int_lt(program_parse(&p, "2*Omga", &where, &why), 0);
    ck_assert_ptr_nonnull(strstr(why.text, "did you mean 'Omega'?"));
    program_clear(&p);
}

/* 10,000 brackets would take the C stack, were they not refused. */
TEST(deep_nesting_is_refused)
{
    enum { DEPTH = 10000 };
    static char brackets[DEPTH + 1], signs[DEPTH + 1];
    char text[200];
    size_t where;
    memset(brackets, '(', DEPTH);
    memset(signs, '-', DEPTH);
    evaluate(brackets, text, &where);
    ck_assert_ptr_nonnull(strstr(text, "expected less nesting"));
    evaluate(signs, text, &where);
    ck_assert_ptr_nonnull(strstr(text, "expected less nesting"));
}

TEST(long_words_are_refused)
{
    char word[80], text[200];
    size_t where;
    memset(word, 'a', 64);
    word[64] = '\0';
    evaluate(word, text, &where);
    ck_assert_ptr_nonnull(strstr(text, "expected a name of less than 64 characters"));
    memset(word, '1', 64);
    evaluate(word, text, &where);
    ck_assert_ptr_nonnull(strstr(text, "expected a number of less than 64 characters"));
}

TEST(later_name_shadows_earlier)
{
    struct program p;
    program_init(&p);
    int x = program_input(&p, "x"), y = program_input(&p, "y");
    ck_assert_int_eq(program_find(&p, "x"), x);
    program_name(&p, y, "x");
    ck_assert_int_eq(program_find(&p, "x"), y);
    program_clear(&p);
}

TEST(copy_is_independent)
{
    struct program p, copy;
    struct message why = {""};
    size_t where;
    program_init(&p);
    program_input(&p, "x");
    int node = program_parse(&p, "x^3 + 1.25", &where, &why);
    program_copy(&copy, &p);
    program_clear(&p);
    ck_assert_int_eq(copy.inputs, 1);
    ck_assert_int_eq(program_find(&copy, "x"), 0);
    struct machine m;
    machine_init(&m, &copy, &arithmetic_symbolic, 1);
    SCOPE(fmpq, value);
    fmpq_set_si(value, 2, 1);
    arithmetic_symbolic.set_rational(machine_value(&m, 0), value, 1);
    machine_run(&m);
    get_coefficient(value, machine_value(&m, node), 0);
    fmpq_mul_si(value, value, 4);
    ck_assert_int_eq(fmpq_cmp_si(value, 37), 0); /* 4 (8 + 5/4) */
    machine_clear(&m);
    program_clear(&copy);
}

/* ---- programs over two inputs ---- */

/* x = 9/4 + epsilon, y = 5/3 - 2 epsilon; a the angle of cosine 3/5, sine 4/5, turning by 7 epsilon; e = epsilon */
static void set_inputs(struct machine *m)
{
    SCOPE(fmpq, number, slope);
    const slong start[] = {9, 4, 1, 5, 3, -2};
    for (int i = 0; i < 2; i++) {
        struct symbolic *x = machine_value(m, i);
        fmpq_set_si(number, start[3 * i], (ulong)start[3 * i + 1]);
        fmpq_set_si(slope, start[3 * i + 2], 1);
        arithmetic_symbolic.set_rational(x, number, m->prec);
        if (m->prec > 1)
            fmpz_mpoly_q_set_fmpq(x->a + 1, slope, symbolic_context());
    }
    struct symbolic *a = machine_value(m, 2);
    fmpq_set_si(number, 3, 5);
    fmpq_set_si(slope, 4, 5);
    fmpz_mpoly_q_set_fmpq(a->a + a->terms, number, symbolic_context());
    fmpz_mpoly_q_set_fmpq(a->a + a->terms + 1, slope, symbolic_context());
    a->angle = true;
    a->fault = SYMBOLIC_FINE;
    struct symbolic *e = machine_value(m, 3);
    if (m->prec > 1) {
        fmpz_mpoly_q_set_si(a->a + 1, 7, symbolic_context());
        fmpz_mpoly_q_set_si(e->a + 1, 1, symbolic_context());
    }
}

static int parse_inputs(struct program *p, const char *formula)
{
    struct message why = {""};
    size_t where;
    program_init(p);
    program_input(p, "x");
    program_input(p, "y");
    program_input(p, "a");
    program_input(p, "e");
    int node = program_parse(p, formula, &where, &why);
    ck_assert_msg(node >= 0, "%s: %s", formula, why.text);
    return node;
}

static void expand(const char *formula, slong terms, char text[200])
{
    struct program p;
    struct machine m;
    int node = parse_inputs(&p, formula);
    machine_init(&m, &p, &arithmetic_symbolic, terms);
    set_inputs(&m);
    machine_run(&m);
    const enum symbolic_fault fault = state(machine_value(&m, node));
    size_t length = 0;
    text[0] = '\0';
    for (slong k = 0; k < terms && fault == SYMBOLIC_FINE; k++) {
        SCOPE(fmpq, value);
        get_coefficient(value, machine_value(&m, node), k);
        char *digits = fmpq_get_str(NULL, 10, value);
        length += (size_t)snprintf(text + length, 200 - length, "%s%s", k ? " " : "", digits);
        flint_free(digits);
    }
    if (fault != SYMBOLIC_FINE)
        snprintf(text, 200, "%s", symbolic_fault_text(fault));
    machine_clear(&m);
    program_clear(&p);
}

static const struct {
    const char *formula;
    slong terms;
    const char *series;
} expansions[] = {
    {"1/(1 - e)", 4, "1 1 1 1"},
    {"(1 + e)^-2", 4, "1 -2 3 -4"},
    {"e/(1/e)", 4, "0 0 1 0"},                 /* 1/e is large: e times e */
    {"1/(1/(e + e^2))", 4, "0 1 1 0"},
    {"exp(e)", 4, "1 1 1/2 1/6"},
    {"sin(e)", 4, "0 1 0 -1/6"},
    {"cos(2*e)", 4, "1 0 -2 0"},               /* 1 - (2e)^2/2 */
    {"sqrt(1 + e)", 4, "1 1/2 -1/8 1/16"},     /* binomial coefficients of 1/2 */
    {"sqrt(x*4)", 3, "3 2/3 -2/27"},           /* sqrt(9 + 4 e) = 3 (1 + 4/9 e)^(1/2) */
    {"cos(a)", 3, "3/5 -28/5 -147/10"},        /* cos(a + 7 e) = c - 7 s e - 49/2 c e^2 */
    {"sin(a)", 3, "4/5 21/5 -98/5"},           /* s + 7 c e - 49/2 s e^2 */
    {"cos(a - a)", 3, "1 0 0"},
    {"sin(-a)", 2, "-4/5 -21/5"},
    {"sin(a + a)", 1, "24/25"},                /* 2 s c */
    {"sin(a)^2 + cos(a)^2", 5, "1 0 0 0 0"},
    {"x*y", 3, "15/4 -17/6 -2"},               /* (9/4 + e)(5/3 - 2 e) */
    {"sqrt(e^2)", 2, "the square root of no square of a rational function"},      /* e, but e^2 is lost among two terms */
    {"sqrt(e^2)", 3, "the square root of no square of a rational function"},
    {"1/e", 3, "division by what is zero at epsilon = 0"},
    {"1/e - 1/e", 3, "division by what is zero at epsilon = 0"},
    {"e/e", 3, "division by what is zero at epsilon = 0"},
    {"sin(x)", 2, "the sine or cosine of a number that is no angle"},
    {"a*x", 2, "a finite angle outside sine and cosine"},
    {"sqrt(a)", 1, "a finite angle outside sine and cosine"},
    {"exp(x)", 2, "a value that is no rational series, or whose sign is not known"},
    {"atan2(e, 1)", 2, "a value that is no rational series, or whose sign is not known"},
};

EACH(series_is_exact, COUNT(expansions))
{
    char text[200];
    expand(expansions[_i].formula, expansions[_i].terms, text);
    ck_assert_str_eq(text, expansions[_i].series);
}

/* Every operator, alone and composed; the rates are those of set_inputs: x 1, y -2, a 7. */
static const char *const differentiable[] = {
    "-x", "x + y", "x - y", "x*y", "x/y", "y/x", "x^3", "x^-2", "x^0", "x^1", "sqrt(x)", "sqrt(x^3)",
    "sin(a)", "cos(a)", "exp(x - 9/4)", "sqrt(x)^3*cos(a)/(y + sin(a)) - exp(y - 5/3)^2",
    "(x + y)*(x - y)/(x^2 + y^2)", "((x/y)^2 - 1/x)^-3", "cos(a + a)*sin(a - a + a)", "7", "x - x", "atan2(y, x)",
};

EACH(derivative_is_the_first_coefficient, COUNT(differentiable) - 1) /* an arc tangent has no series here */
{
    struct program p;
    struct machine m;
    SCOPE(fmpq, expected, value);
    int node = parse_inputs(&p, differentiable[_i]), rate[4];
    const slong rates[] = {1, -2, 7};
    const int count = p.count;
    for (int i = 0; i < 4; i++)
        rate[i] = -1;
    for (int i = 0; i < 3; i++) {
        rate[i] = program_append(&p, OPERATOR_NUMBER, -1, -1, 0);
        fmpq_set_si(&p.nodes[rate[i]].number, rates[i], 1);
    }
    int derivative = program_derivative(&p, node, rate, 4);
    ck_assert_int_ge(derivative, count);
    machine_init(&m, &p, &arithmetic_symbolic, 2);
    set_inputs(&m);
    machine_run(&m);
    get_coefficient(expected, machine_value(&m, node), 1);
    get_coefficient(value, machine_value(&m, derivative), 0);
    ck_assert_int_eq(state(machine_value(&m, node)), SYMBOLIC_FINE);
    ck_assert_int_eq(state(machine_value(&m, derivative)), SYMBOLIC_FINE);
    ck_assert(fmpq_equal(value, expected));
    machine_clear(&m);
    program_clear(&p);
}

/* d atan2(y, x) = (x dy - y dx)/(x^2 + y^2): at x = 9/4, y = 5/3 with dx = 1, dy = -2 it is -888/1129. */
TEST(derivative_of_an_arc_tangent)
{
    struct program p;
    struct machine m;
    SCOPE(fmpq, value, expected);
    int node = parse_inputs(&p, "atan2(y, x)"), rate[2];
    for (int i = 0; i < 2; i++) {
        rate[i] = program_append(&p, OPERATOR_NUMBER, -1, -1, 0);
        fmpq_set_si(&p.nodes[rate[i]].number, i ? -2 : 1, 1);
    }
    int derivative = program_derivative(&p, node, rate, 2);
    machine_init(&m, &p, &arithmetic_symbolic, 1);
    set_inputs(&m);
    machine_run(&m);
    get_coefficient(value, machine_value(&m, derivative), 0);
    /* (9/4 (-2) - 5/3)/(81/16 + 25/9) = (-37/6)/(1129/144) */
    fmpq_set_si(expected, -888, 1129);
    ck_assert(fmpq_equal(value, expected));
    machine_clear(&m);
    program_clear(&p);
}

TEST(derivative_follows_a_named_node)
{
    struct program p;
    int node = parse_inputs(&p, "x*x"); /* x x, when x x itself is said to move by y */
    int *rate = malloc((size_t)p.count * sizeof *rate);
    for (int i = 0; i < p.count; i++)
        rate[i] = -1;
    rate[node] = 1;
    ck_assert_int_eq(program_derivative(&p, node, rate, p.count), 1);
    free(rate);
    program_clear(&p);
    char *needed = program_needs(&p, parse_inputs(&p, "y*x"), NULL);
    ck_assert(needed[0] && needed[1] && !needed[2]);
    free(needed);
    program_clear(&p);
    node = parse_inputs(&p, "x + y"); /* x by y, and y by x, the first node of all */
    const int sum = program_derivative(&p, node, (const int[]){1, 0}, 2);
    ck_assert(p.nodes[sum].op == OPERATOR_ADD && p.nodes[sum].left == 1 && p.nodes[sum].right == 0);
    program_clear(&p);
}

EACH(gradient_is_the_derivative_by_every_input, COUNT(differentiable))
{
    struct program p;
    struct machine m;
    struct gradient adjoint;
    SCOPE(fmpq, expected, value);
    int node = parse_inputs(&p, differentiable[_i]), derivative[3];
    for (int i = 0; i < 3; i++) {
        int rate[3] = {-1, -1, -1};
        rate[i] = program_append(&p, OPERATOR_NUMBER, -1, -1, 0);
        fmpq_one(&p.nodes[rate[i]].number);
        derivative[i] = program_derivative(&p, node, rate, 3);
    }
    const int by_first = program_derivative(&p, node, (const int[]){-1, 0, -1}, 3); /* y moves by x, the first node of all */
    machine_init(&m, &p, &arithmetic_symbolic, 1);
    gradient_init(&adjoint, &p, &node, 1, &arithmetic_symbolic, 1);
    set_inputs(&m);
    machine_run(&m);
    gradient_run(&adjoint, &m);
    for (int i = 0; i < 3; i++) {
        get_coefficient(expected, machine_value(&m, derivative[i]), 0);
        get_coefficient(value, gradient_value(&adjoint, 0, i), 0);
        ck_assert_int_eq(state(gradient_value(&adjoint, 0, i)), SYMBOLIC_FINE);
        ck_assert(fmpq_equal(value, expected));
    }
    get_coefficient(value, gradient_value(&adjoint, 0, 1), 0);
    get_coefficient(expected, machine_value(&m, 0), 0);
    fmpq_mul(expected, expected, value);
    get_coefficient(value, machine_value(&m, by_first), 0);
    ck_assert(fmpq_equal(value, expected));
    gradient_clear(&adjoint);
    machine_clear(&m);
    program_clear(&p);
}

/* In balls too, which know no zero but as such: else each vector of (37), where I_33 - I_22 is I - I, would be asked of exact numbers. */
TEST(what_is_taken_from_itself_has_no_gradient)
{
    struct program p;
    OWNED(machine) m;
    OWNED(gradient) by;
    const int node = parse_inputs(&p, "x/3*(y - y) + a");
    machine_init(&m, &p, &arithmetic_ball, 64);
    gradient_init(&by, &p, &node, 1, &arithmetic_ball, 64);
    for (int i = 0; i < p.inputs; i++)
        arb_set_ui(machine_value(&m, i), 7);
    machine_run(&m);
    gradient_run(&by, &m);
    ck_assert(arb_is_zero(gradient_value(&by, 0, 0)) && arb_is_zero(gradient_value(&by, 0, 1)) && arb_is_one(gradient_value(&by, 0, 2)));
    program_clear(&p);
}

/* f(x) = x^2 + 1 with y - 1 in the place of x, beside what p has already */
TEST(inlined_program_takes_the_place_of_its_inputs)
{
    struct program p, other;
    struct machine m;
    struct message why = {""};
    size_t where;
    SCOPE(fmpq, value, expected);
    int y = parse_inputs(&p, "y - 1");
    program_init(&other);
    program_input(&other, "x");
    int f = program_parse(&other, "x^2 + 1", &where, &why);
    int stand_in[8] = {y, -1, -1, -1, -1, -1, -1, -1};
    ck_assert_int_le(other.count, 8);
    int node = program_copy_node(&p, &other, f, stand_in);
    program_clear(&other);
    machine_init(&m, &p, &arithmetic_symbolic, 1);
    set_inputs(&m);
    machine_run(&m);
    get_coefficient(value, machine_value(&m, node), 0);
    fmpq_set_si(expected, 13, 9); /* (5/3 - 1)^2 + 1 */
    ck_assert(fmpq_equal(value, expected));
    machine_clear(&m);
    program_clear(&p);
}

/* ---- the arithmetics agree ---- */

/*
 * Each function's ball has (1) its rounding, (2) what its arguments' radii make of it. Of thin arguments at 20 bits it holds what
 * 300 bits say, and no binary number of 20 bits is that; of wide ones what 300 bits say at their corners. MPFR says the same.
 */
static const char *const of_balls[] = {"-x/3", "x + y/3", "x - y/3", "x*y/3", "x/y", "x^3/3", "x^-1", "x^-2", "x^0/3", "sqrt(x)", "sin(x)", "sin(x)*sin(x)/3",
                                       "cos(x)", "exp(x)", "log(x)", "atan2(y, x)", "atan2(-y, x)", "atan2(y, -x)", "atan2(y - 3, x)"};

EACH(ball_of_each_function_has_rounding_and_radius, 2*COUNT(of_balls))
{
    struct program p;
    struct machine m, fine, rounded;
    SCOPE(arb, known);
    const bool wide = _i >= COUNT(of_balls);
    const int node = parse_inputs(&p, of_balls[_i % COUNT(of_balls)]);
    machine_init(&m, &p, &arithmetic_ball, 20);
    machine_init(&fine, &p, &arithmetic_ball, 300);
    machine_init(&rounded, &p, &arithmetic_mpfr, 300);
    for (int corner = 0; corner < (wide ? 4 : 1); corner++) {
        for (int i = 0; i < 2; i++) { /* 11/4 and 3, or as much as 1/16 to either side */
            arb_ptr x = machine_value(&fine, i);
            arb_set_si(x, wide ? 4*(11 + i) + (corner >> i & 1 ? 1 : -1) : 11 + i);
            arb_mul_2exp_si(x, x, wide ? -4 : -2);
            arf_get_mpfr(machine_value(&rounded, i), arb_midref(x), MPFR_RNDN);
            arb_set_si(machine_value(&m, i), 11 + i);
            arb_mul_2exp_si(machine_value(&m, i), machine_value(&m, i), -2);
            mag_set_d(arb_radref((arb_ptr)machine_value(&m, i)), wide ? 0x1p-4 : 0);
        }
        machine_run(&m);
        machine_run(&fine);
        machine_run(&rounded);
        ck_assert(arb_contains(machine_value(&m, node), machine_value(&fine, node)));
        arf_set_mpfr(arb_midref(known), machine_value(&rounded, node));
        mag_set_ui_2exp_si(arb_radref(known), 1, -290); /* a few roundings of values below 32 */
        ck_assert(arb_contains(known, machine_value(&fine, node)));
    }
    machine_clear(&m);
    machine_clear(&fine);
    machine_clear(&rounded);
    program_clear(&p);
}

/* 1 for [1/2, 1], 0 for [-1, -1/2] and 0, anything for [-1/2, 1]; nothing is known of a number over what may be any */
EACH(ball_of_any_sign_or_size_tells_nothing, 6)
{
    static const struct {
        const char *formula;
        double middle, radius, value;
    } balls[] = {{"positive(x)", 0.75, 0.25, 1}, {"positive(x)", -0.75, 0.25, 0}, {"positive(x)", 0, 0, 0}, {"positive(x)", 0.25, 0.75, NAN},
                 {"1/x", INFINITY, 0, 0}, {"1/x", INFINITY, INFINITY, NAN}};
    struct program p;
    struct machine m;
    int node = parse_inputs(&p, balls[_i].formula);
    machine_init(&m, &p, &arithmetic_ball, 64);
    arb_ptr x = machine_value(&m, 0), y = machine_value(&m, node);
    arb_set_d(x, balls[_i].middle);
    mag_set_d(arb_radref(x), balls[_i].radius);
    machine_run(&m);
    ck_assert(isnan(balls[_i].value) ? !arb_is_finite(y) : arb_equal_si(y, (slong)balls[_i].value));
    machine_clear(&m);
    program_clear(&p);
}

EACH(ball_of_a_special_argument_is_the_function_there, 6)
{
    static const struct {
        const char *formula;
        double x, y;
        bool finite;
        double value;
    } cases[] = {
        {"x/y", INFINITY, INFINITY, false, 0}, /* a finite number over infinity is 0, infinity over it is nothing */
        {"x/y", 1, INFINITY, true, 0},
        {"atan2(y, x)", -1, 0, true, 0x1.921fb54442d18p+1}, /* the nearest double of pi */
        {"atan2(y, x)", 2, 0, true, 0},
        {"x^-1", 4, 0, true, 0.25},
        {"y^0", 4, 0, true, 1},
    };
    struct program p;
    struct machine m;
    int node = parse_inputs(&p, cases[_i].formula);
    machine_init(&m, &p, &arithmetic_ball, 64);
    arb_set_d(machine_value(&m, 0), cases[_i].x);
    arb_set_d(machine_value(&m, 1), cases[_i].y);
    machine_run(&m);
    arb_srcptr z = machine_value(&m, node);
    ck_assert(arb_is_finite(z) == cases[_i].finite);
    ck_assert(!cases[_i].finite || arf_get_d(arb_midref(z), ARF_RND_NEAR) == cases[_i].value); /* so near, exactly */
    machine_clear(&m);
    program_clear(&p);
}

/* Its jump apart, positive() has slope 0; so has x^0, at 0 too. And the normal forms have no logarithm. */
EACH(slopes_by_x_in_balls, 4)
{
    static const struct {
        const char *formula;
        slong x;
        double slope;
    } cases[] = {{"positive(x)*y", 2, 0}, {"x^0*y", 2, 0}, {"x^0*y", 0, 0}, {"log(x) + y", 2, 0.5}};
    struct program p;
    struct machine m;
    struct gradient adjoint;
    int node = parse_inputs(&p, cases[_i].formula), rate[] = {1, -1};
    const int slope = program_derivative(&p, node, rate, 2);
    gradient_init(&adjoint, &p, &node, 1, &arithmetic_ball, 64);
    machine_init(&m, &p, &arithmetic_ball, 64);
    arb_set_si(machine_value(&m, 0), cases[_i].x);
    arb_set_si(machine_value(&m, 1), 3);
    machine_run(&m);
    gradient_run(&adjoint, &m);
    ck_assert_double_eq(arf_get_d(arb_midref((arb_ptr)gradient_value(&adjoint, 0, 0)), ARF_RND_NEAR), cases[_i].slope);
    ck_assert(arb_is_one(gradient_value(&adjoint, 0, 1)));
    ck_assert_double_eq(arf_get_d(arb_midref((arb_ptr)machine_value(&m, slope)), ARF_RND_NEAR), 3*cases[_i].slope); /* x moves by y */
    gradient_clear(&adjoint);
    machine_clear(&m);
    program_clear(&p);
}

EACH(a_number_is_positive_or_not, 3)
{
    static const int signs[][2] = {{-2, 0}, {0, 0}, {3, 1}}; /* of x, and what is said of it */
    struct program p;
    struct machine m;
    int node = parse_inputs(&p, "positive(x)");
    machine_init(&m, &p, &arithmetic_mpfr, 64);
    mpfr_set_si(machine_value(&m, 0), signs[_i][0], MPFR_RNDN);
    mpfr_set_si(machine_value(&m, node), 7, MPFR_RNDN);
    machine_run(&m);
    ck_assert_int_eq(mpfr_cmp_si(machine_value(&m, node), signs[_i][1]), 0);
    machine_clear(&m);
    program_clear(&p);
}

/* ---- normal forms ---- */

/* In the variables u and v: what is equal, and what is too large to say. */
static const struct {
    const char *formula;
    enum symbolic_fault fault;
} forms[] = {
    {"(u + v)^2 - u^2 - 2*u*v - v^2", SYMBOLIC_FINE},
    {"(u^3 - v^3)/(u - v) - u^2 - u*v - v^2", SYMBOLIC_FINE},
    {"1/u + 1/v - (u + v)/(u*v)", SYMBOLIC_FINE},
    {"((2^999)^999)^999", SYMBOLIC_TOO_LARGE},
    {"((u^999)^999)^999", SYMBOLIC_TOO_LARGE},
    {"((u + v)^999)^999", SYMBOLIC_TOO_LARGE},
    {"((u/v + 1)^200 + (v/u - 2)^200)^100", SYMBOLIC_TOO_LARGE},
    {"(((u + 1)^9*(v + 1)^9 + 1)^9 + u)^9/(((u + v)^9 + 7)^9 + v)^9", SYMBOLIC_TOO_LARGE},
    {"1/(u + v)^900 + 1/(u - v)^900", SYMBOLIC_TOO_LARGE}, /* by its denominators alone */
    {"(u^900)^60*(v^900)^60", SYMBOLIC_TOO_LARGE},
    {"(u^900)^60/((v^900)^60 + 1)", SYMBOLIC_TOO_LARGE}, /* that of both together */
    {"1/(u - u)", SYMBOLIC_POLE},
    {"sqrt(u^2)", SYMBOLIC_UNKNOWN_ROOT},
    {"sqrt(u)", SYMBOLIC_NO_SQUARE},
};

EACH(normal_form_is_zero_or_refused, COUNT(forms))
{
    struct program p;
    struct machine m;
    struct message why;
    size_t where;
    symbolic_end();
    symbolic_begin(2, 0);
    program_init(&p);
    program_input(&p, "u");
    program_input(&p, "v");
    const int node = program_parse(&p, forms[_i].formula, &where, &why);
    machine_init(&m, &p, &arithmetic_symbolic, 1);
    for (int i = 0; i < 2; i++)
        symbolic_set_variable(machine_value(&m, i), i, 0, NULL);
    machine_run(&m);
    const struct symbolic *x = machine_value(&m, node);
    ck_assert_int_eq(x->fault, forms[_i].fault);
    ck_assert(x->fault != SYMBOLIC_FINE || fmpz_mpoly_q_is_zero(x->a, symbolic_context()));
    machine_clear(&m);
    program_clear(&p);
}

/* A root is the one that was given, of either sign; and the same unknown stands for the same function's value. */
TEST(given_root_is_taken)
{
    struct symbolic u, z, w;
    SCOPE(fmpq, number);
    SCOPE(fmpq_poly, f);
    symbolic_end();
    symbolic_begin(1, 8);
    arithmetic_symbolic.init(&u, 1);
    arithmetic_symbolic.init(&z, 1);
    arithmetic_symbolic.init(&w, 1);
    symbolic_set_variable(&u, 0, 0, NULL);
    arithmetic_symbolic.apply(OPERATOR_NEGATE, &w, &u, NULL, 0, 1);
    symbolic_root(&w, true);
    arithmetic_symbolic.apply(OPERATOR_MULTIPLY, &z, &u, &u, 0, 1);
    arithmetic_symbolic.apply(OPERATOR_SQRT, &z, &z, NULL, 0, 1);
    ck_assert(fmpz_mpoly_q_equal(z.a, w.a, symbolic_context()));
    ck_assert(symbolic_root_used(0));
    arithmetic_symbolic.apply(OPERATOR_SQRT, &z, &u, NULL, 0, 1);
    arithmetic_symbolic.apply(OPERATOR_SQRT, &w, &u, NULL, 0, 1);
    ck_assert(fmpz_mpoly_q_equal(z.a, w.a, symbolic_context()));
    arithmetic_symbolic.apply(OPERATOR_EXP, &w, &u, NULL, 0, 1);
    ck_assert(!fmpz_mpoly_q_equal(z.a, w.a, symbolic_context()));
    symbolic_set_angle(&z, 0, NULL); /* an angle with a number on top, whose sine is a further unknown, twice the same */
    arithmetic_symbolic.apply(OPERATOR_ADD, &u, &u, &z, 0, 1);
    arithmetic_symbolic.apply(OPERATOR_SIN, &z, &u, NULL, 0, 1);
    arithmetic_symbolic.apply(OPERATOR_SIN, &w, &u, NULL, 0, 1);
    ck_assert(fmpz_mpoly_q_equal(z.a, w.a, symbolic_context()));
    symbolic_set_angle(&w, 0, NULL); /* the opposite angle has the same cosine, and another unknown */
    arithmetic_symbolic.apply(OPERATOR_SUBTRACT, &u, &u, &w, 0, 1);
    arithmetic_symbolic.apply(OPERATOR_SUBTRACT, &w, &u, &w, 0, 1);
    arithmetic_symbolic.apply(OPERATOR_SIN, &w, &w, NULL, 0, 1);
    ck_assert(!fmpz_mpoly_q_equal(z.a, w.a, symbolic_context()));
    symbolic_set_variable(&u, 0, 0, NULL);
    for (int swapped = 0; swapped < 2; swapped++) {
        for (int i = 0; i < 2; i++) { /* the angles of (1, u) and (2, u), or of (u, 1) and (u, 2), by their cosines */
            struct symbolic *angle = i ? &w : &z;
            fmpq_set_si(number, i + 1, 1);
            arithmetic_symbolic.set_rational(angle, number, 1);
            arithmetic_symbolic.apply(OPERATOR_ATAN2, angle, swapped ? angle : &u, swapped ? &u : angle, 0, 1);
        }
        ck_assert(z.fault == SYMBOLIC_FINE && z.angle && w.angle);
        ck_assert(!fmpz_mpoly_q_equal(z.a + 1, w.a + 1, symbolic_context()));
    }
    ck_assert(!symbolic_get_polynomial(f, &w));
    ck_assert(symbolic_get_polynomial(f, &u) && fmpq_poly_degree(f) == 1);
    arithmetic_symbolic.apply(OPERATOR_POWER, &z, &u, NULL, -1, 1);
    ck_assert(z.fault == SYMBOLIC_FINE && !symbolic_get_polynomial(f, &z));
    arithmetic_symbolic.apply(OPERATOR_LOG, &u, &u, NULL, 0, 1); /* the ninth */
    ck_assert_int_eq(u.fault, SYMBOLIC_TRANSCENDENTAL);
    ck_assert(!symbolic_get_polynomial(f, &u));
    arithmetic_symbolic.clear(&u);
    arithmetic_symbolic.clear(&z);
    arithmetic_symbolic.clear(&w);
}

/* The processor's time, and what a test adds to it. */
static clock_t passed;

clock_t clock(void)
{
    struct timespec used;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &used);
    return passed + (clock_t)used.tv_sec * CLOCKS_PER_SEC + (clock_t)(used.tv_nsec / (1000000000 / CLOCKS_PER_SEC));
}

/* A product that is allowed: 2 s after the field began it is too much. */
TEST(time_is_bounded)
{
    static const char *const names[] = {"a", "b", "c", "d"};
    struct program p;
    struct machine m;
    struct message why;
    size_t where;
    symbolic_end();
    passed = 2 * CLOCKS_PER_SEC;
    symbolic_begin(4, 0);
    program_init(&p);
    for (int i = 0; i < 4; i++)
        program_input(&p, names[i]);
    const int node = program_parse(&p, "(a + b + c + d)^15*(a + 2*b + c + d)^15", &where, &why);
    machine_init(&m, &p, &arithmetic_symbolic, 1);
    for (int i = 0; i < 4; i++)
        symbolic_set_variable(machine_value(&m, i), i, 0, NULL);
    machine_run(&m);
    ck_assert_int_eq(state(machine_value(&m, node)), SYMBOLIC_FINE);
    passed = 4 * CLOCKS_PER_SEC;
    machine_run(&m);
    passed = 0;
    ck_assert_int_eq(state(machine_value(&m, node)), SYMBOLIC_TOO_LARGE);
    ck_assert_msg(strncmp(symbolic_fault_size(), "seconds: ", 9) == 0, "%s", symbolic_fault_size());
    symbolic_set_angle(machine_value(&m, 0), 0, NULL); /* nor is a sum of angles known */
    arithmetic_symbolic.apply(OPERATOR_ADD, machine_value(&m, 1), machine_value(&m, 0), machine_value(&m, 0), 0, 1);
    ck_assert_int_eq(state(machine_value(&m, 1)), SYMBOLIC_TOO_LARGE);
    machine_clear(&m);
    program_clear(&p);
}
