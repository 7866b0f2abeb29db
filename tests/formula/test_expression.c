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

/* ---- formulas at work ---- */

/* A formula over x, y, a and e in one arithmetic. */
struct running {
    struct program p;
    struct machine m;
    int node;
};

static void running_clear(struct running *r)
{
    machine_clear(&r->m);
    program_clear(&r->p);
}

/* x = 9/4 + epsilon, y = 5/3 - 2 epsilon; a the angle of cosine 3/5, sine 4/5, turning by 7 epsilon; e = epsilon */
static void set_inputs(struct machine *m)
{
    static const slong start[] = {9, 4, 5, 3, 0, 1, 0, 1, 3, 5, 4, 5}, slopes[] = {1, -2, 7, 1};
    SCOPE(fmpq, number);
    for (int i = 0; i < 4; i++) {
        struct symbolic *x = machine_value(m, i);
        fmpq_set_si(number, start[2 * i], (ulong)start[2 * i + 1]);
        arithmetic_symbolic.set_rational(x, number, m->prec);
        if (m->prec > 1)
            fmpz_mpoly_q_set_si(x->a + 1, slopes[i], symbolic_context());
        for (int k = 0; k < 2 && i == 2; k++) {
            fmpq_set_si(number, start[8 + 2 * k], (ulong)start[9 + 2 * k]);
            fmpz_mpoly_q_set_fmpq(x->a + x->terms + k, number, symbolic_context());
        }
        x->angle = i == 2;
    }
}

static int parse(struct program *p, const char *formula, size_t *where, struct message *why)
{
    static const char *const names[] = {"x", "y", "a", "e"};
    program_init(p);
    for (int i = 0; i < COUNT(names); i++)
        program_input(p, names[i]);
    return program_parse_with(p, formula, NULL, NULL, where, why);
}

static int parse_inputs(struct program *p, const char *formula)
{
    struct message why = {""};
    size_t where;
    const int node = parse(p, formula, &where, &why);
    ck_assert_msg(node >= 0, "%s: %s", formula, why.text);
    return node;
}

/* Of normal forms the inputs are set. */
static void open_running(struct running *r, const char *formula, const struct arithmetic *a, slong prec)
{
    r->node = parse_inputs(&r->p, formula);
    machine_init(&r->m, &r->p, a, prec);
    if (a == &arithmetic_symbolic)
        set_inputs(&r->m);
}

static void *result_of(struct running *r)
{
    machine_run(&r->m);
    return machine_value(&r->m, r->node);
}

/* ---- the parser, and series ---- */

/* The coefficients of so many powers of epsilon; the fault, or the mistake's text, of what has none. */
static void evaluate(const char *formula, slong terms, char text[200], size_t *where)
{
    struct program p;
    struct message why = {""};
    const bool fine = parse(&p, formula, where, &why) >= 0;
    program_clear(&p);
    snprintf(text, 200, "%.199s", why.text);
    if (!fine)
        return;
    OWNED(running) r;
    open_running(&r, formula, &arithmetic_symbolic, terms);
    const void *x = result_of(&r);
    size_t length = 0;
    if (state(x) != SYMBOLIC_FINE)
        snprintf(text, 200, "%s", symbolic_fault_text(state(x)));
    for (slong k = 0; k < terms && state(x) == SYMBOLIC_FINE; k++) {
        SCOPE(fmpq, value);
        get_coefficient(value, x, k);
        char *digits = fmpq_get_str(NULL, 10, value);
        length += (size_t)snprintf(text + length, 200 - length, "%s%s", k ? " " : "", digits);
        flint_free(digits);
    }
}

static const struct {
    const char *formula, *series;
    slong terms;
} values[] = {
    {"2 + 3*4", "14", 1},
    {"(2 + 3)*4", "20", 1},
    {"2 - 3 - 4", "-5", 1},       /* from the left */
    {"12/3/2", "2", 1},           /* from the left */
    {"12/(3/2)", "8", 1},
    {"2*-3", "-6", 1},
    {"2 - -3", "5", 1},
    {"--3", "3", 1},
    {"-2^2", "-4", 1},            /* the power binds closer than the sign */
    {"(-2)^2", "4", 1},
    {"2*3^2", "18", 1},
    {"0^0", "1", 1},
    {"1.5e1 - .5 + 5.", "39/2", 1},
    {"1e-3", "1/1000", 1},
    {"1e+3", "1000", 1},
    {"0.1 + 0.2", "3/10", 1},     /* decimals, not doubles */
    {"sqrt(16/9)", "4/3", 1},
    {"sqrt(0)", "0", 1},
    {"exp(0) + cos(0) + sin(0)", "2", 1},
    {"cos(atan2(4, 3))", "3/5", 1}, /* 3, 4, 5 */
    {"sin(atan2(4, 3) + atan2(4, 3))", "24/25", 1},
    {"cos(atan2(0, -1))", "-1", 1},
    {"1/(1/0)", "0", 1},          /* a pole may be divided by */
    {"((((1))))", "1", 1},
    {" 1\n + 1\t", "2", 1},
    {"1/0", "division by what is zero at epsilon = 0", 1},
    {"0/0", "division by what is zero at epsilon = 0", 1},
    {"1/0 + 1", "division by what is zero at epsilon = 0", 1},
    {"atan2(0, 0)", "division by what is zero at epsilon = 0", 1},
    {"sqrt(2)", "the square root of no square of a rational function", 1},
    {"1/sqrt(2)", "the square root of no square of a rational function", 1},
    {"1/(1/sqrt(2))", "the square root of no square of a rational function", 1},
    {"atan2(0, 1) + sqrt(2)*exp(0)", "the square root of no square of a rational function", 1},
    {"sqrt(-4)", "the square root of no square of a rational function", 1},
    {"atan2(1, 1)", "the square root of no square of a rational function", 1},
    {"sin(1)", "the sine or cosine of a number that is no angle", 1},
    {"atan2(4, 3)", "a finite angle outside sine and cosine", 1},
    {"2*atan2(4, 3)", "a finite angle outside sine and cosine", 1},
    {"exp(1)", "a value that is no rational series, or whose sign is not known", 1},
    {"positive(1)", "a value that is no rational series, or whose sign is not known", 1},
    {"1/(1 - e)", "1 1 1 1", 4},
    {"1/(1 + e)^2", "1 -2 3 -4", 4},
    {"e/(1/e)", "0 0 1 0", 4},                 /* 1/e is large: e times e */
    {"1/(1/(e + e^2))", "0 1 1 0", 4},
    {"exp(e)", "1 1 1/2 1/6", 4},
    {"sin(e)", "0 1 0 -1/6", 4},
    {"cos(2*e)", "1 0 -2 0", 4},               /* 1 - (2e)^2/2 */
    {"exp(e + e^2)", "1 1 3/2 7/6", 4},        /* (e + e^2)^2 = e^2 + 2 e^3 */
    {"sin(e + e^2)", "0 1 1 -1/6", 4},
    {"cos(e + e^2)", "1 0 -1/2 -1", 4},
    {"sqrt(1 + 2*e + 3*e^2 + 2*e^3)", "1 1 1 0", 4}, /* (1 + e + e^2)^2 */
    {"sqrt(1 + e)", "1 1/2 -1/8 1/16", 4},     /* binomial coefficients of 1/2 */
    {"sqrt(x*4)", "3 2/3 -2/27", 3},           /* sqrt(9 + 4 e) = 3 (1 + 4/9 e)^(1/2) */
    {"cos(a)", "3/5 -28/5 -147/10", 3},        /* cos(a + 7 e) = c - 7 s e - 49/2 c e^2 */
    {"sin(a)", "4/5 21/5 -98/5", 3},           /* s + 7 c e - 49/2 s e^2 */
    {"cos(a - a)", "1 0 0", 3},
    {"sin(-a)", "-4/5 -21/5", 2},
    {"sin(a + a)", "24/25", 1},                /* 2 s c */
    {"sin(a)^2 + cos(a)^2", "1 0 0 0 0", 5},
    {"x*y", "15/4 -17/6 -2", 3},               /* (9/4 + e)(5/3 - 2 e) */
    {"sqrt(e^2)", "the square root of no square of a rational function", 2},      /* e, but e^2 is lost among two terms */
    {"sqrt(e^2)", "the square root of no square of a rational function", 3},
    {"1/e", "division by what is zero at epsilon = 0", 3},
    {"1/e - 1/e", "division by what is zero at epsilon = 0", 3},
    {"e/e", "division by what is zero at epsilon = 0", 3},
    {"sin(x)", "the sine or cosine of a number that is no angle", 2},
    {"a*x", "a finite angle outside sine and cosine", 2},
    {"sqrt(a)", "a finite angle outside sine and cosine", 1},
    {"exp(x)", "a value that is no rational series, or whose sign is not known", 2},
    {"atan2(e, 1)", "a value that is no rational series, or whose sign is not known", 2},
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
    evaluate(values[_i].formula, values[_i].terms, text, &where);
    ck_assert_str_eq(text, values[_i].series);
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
    {"(x", 2, "expected ')' or an operator, the formula ends here"}, /* the first node of all */
    {"x y", 2, "expected an operator or the end of the formula, found 'y'"},
    {"1 2", 2, "expected an operator or the end of the formula, found '2'"},
    {"2x", 1, "expected an operator or the end of the formula, found 'x'"},
    {"1.2.3", 0, "expected a decimal number, found '1'"},
    {"1e", 0, "expected a decimal number, found '1'"},
    {"2^0.5", 3, "expected an operator or the end of the formula, found '.'"},
    {"2^n", 2, "expected an exponent of at most three digits, found 'n'"},
    {"2^1000", 2, "expected an exponent of at most three digits, found '1'"},
    {"2^-2", 2, "expected an exponent of at most three digits, found '-'"},
    {"1 + bcdfgh", 4, "unknown symbol 'bcdfgh', expected an input or a named subexpression"},
    {"1 + xx", 4, "unknown symbol 'xx', expected an input or a named subexpression (did you mean 'x'?)"},
    {"sin 1", 4, "expected '(', found '1'"},
    {"sin(1", 5, "expected ')' or an operator, the formula ends here"},
    {"atan2(1)", 7, "expected ',' and the second argument of atan2, found ')'"},
    {"atan2(1, )", 9, "expected a number, a symbol or '(', found ')'"},
    {"rate(1)", 0, "unknown symbol 'rate', expected an input or a named subexpression (did you mean 'a'?)"},
    {"1 # 2", 2, "expected an operator or the end of the formula, found '#'"},
};

EACH(mistake_is_told_with_its_place, COUNT(mistakes))
{
    char text[200];
    size_t where;
    evaluate(mistakes[_i].formula, 1, text, &where);
    ck_assert_str_eq(text, mistakes[_i].expected);
    ck_assert_uint_eq(where, mistakes[_i].where);
}

/* So many characters of one kind: 10,000 brackets would take the C stack, were they not refused. */
static const struct {
    char character;
    int length;
    const char *expected;
} long_texts[] = {{'(', 10000, "expected less nesting"}, {'-', 10000, "expected less nesting"},
                  {'a', 64, "expected a name of less than 64 characters"}, {'1', 64, "expected a number of less than 64 characters"}};

EACH(long_text_is_refused, COUNT(long_texts))
{
    static char formula[10001];
    char text[200];
    size_t where;
    memset(formula, 0, sizeof formula);
    memset(formula, long_texts[_i].character, (size_t)long_texts[_i].length);
    evaluate(formula, 1, text, &where);
    ck_assert_ptr_nonnull(strstr(text, long_texts[_i].expected));
}

TEST(copy_is_independent_and_later_names_shadow)
{
    struct program p;
    OWNED(running) r;
    r.node = parse_inputs(&p, "x^3 + 1.25");
    program_copy(&r.p, &p);
    program_clear(&p);
    ck_assert_int_eq(r.p.inputs, 4);
    ck_assert_int_eq(program_find(&r.p, "x"), 0);
    program_name(&r.p, 1, "x");
    ck_assert_int_eq(program_find(&r.p, "x"), 1);
    machine_init(&r.m, &r.p, &arithmetic_symbolic, 1);
    SCOPE(fmpq, value);
    fmpq_set_si(value, 2, 1);
    arithmetic_symbolic.set_rational(machine_value(&r.m, 0), value, 1);
    get_coefficient(value, result_of(&r), 0);
    fmpq_mul_si(value, value, 4);
    ck_assert_int_eq(fmpq_cmp_si(value, 37), 0); /* 4 (8 + 5/4) */
}

/* ---- derivatives ---- */

/* Every operator, alone and composed; the rates are those of set_inputs: x 1, y -2, a 7. */
static const char *const differentiable[] = {
    "-x", "x + y", "x - y", "x*y", "x/y", "y/x", "x^3", "1/x^2", "x^0", "x^1", "sqrt(x)", "sqrt(x^3)",
    "sin(a)", "cos(a)", "exp(x - 9/4)", "sqrt(x)^3*cos(a)/(y + sin(a)) - exp(y - 5/3)^2",
    "(x + y)*(x - y)/(x^2 + y^2)", "1/((x/y)^2 - 1/x)^3", "cos(a + a)*sin(a - a + a)", "7", "x - x", "atan2(y, x)",
};

/* Numbers for the rates of the first inputs, appended: program_derivative() by them, all run at set_inputs(). */
static int append_derivative(struct program *p, int node, const slong *rates, int count)
{
    int rate[3];
    for (int i = 0; i < count; i++) {
        rate[i] = rates[i] == 0 ? -1 : program_append(p, OPERATOR_NUMBER, -1, -1, 0);
        if (rate[i] >= 0)
            fmpq_set_si(&p->nodes[rate[i]].number, rates[i], 1);
    }
    return program_derivative(p, node, rate, count);
}

/* An arc tangent has no series here: d atan2(y, x) = (x dy - y dx)/(x^2 + y^2), (9/4 (-2) - 5/3)/(81/16 + 25/9) = (-37/6)/(1129/144). */
EACH(derivative_is_the_first_coefficient, COUNT(differentiable))
{
    const bool series = _i < COUNT(differentiable) - 1;
    OWNED(running) r;
    SCOPE(fmpq, expected, value);
    r.node = parse_inputs(&r.p, differentiable[_i]);
    const int count = r.p.count, derivative = append_derivative(&r.p, r.node, (const slong[]){1, -2, 7}, 3);
    ck_assert_int_ge(derivative, count);
    machine_init(&r.m, &r.p, &arithmetic_symbolic, series ? 2 : 1);
    set_inputs(&r.m);
    fmpq_set_si(expected, -888, 1129);
    if (series)
        get_coefficient(expected, result_of(&r), 1);
    machine_run(&r.m);
    get_coefficient(value, machine_value(&r.m, derivative), 0);
    ck_assert_int_eq(state(machine_value(&r.m, derivative)), SYMBOLIC_FINE);
    ck_assert(!series || state(machine_value(&r.m, r.node)) == SYMBOLIC_FINE);
    ck_assert(fmpq_equal(value, expected));
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
    OWNED(running) r;
    OWNED(gradient) adjoint;
    SCOPE(fmpq, expected, value);
    int derivative[3];
    r.node = parse_inputs(&r.p, differentiable[_i]);
    for (int i = 0; i < 3; i++)
        derivative[i] = append_derivative(&r.p, r.node, (const slong[]){i == 0, i == 1, i == 2}, 3);
    const int by_first = program_derivative(&r.p, r.node, (const int[]){-1, 0, -1}, 3); /* y moves by x, the first node of all */
    machine_init(&r.m, &r.p, &arithmetic_symbolic, 1);
    gradient_init(&adjoint, &r.p, &r.node, 1, &arithmetic_symbolic, 1);
    set_inputs(&r.m);
    machine_run(&r.m);
    gradient_run(&adjoint, &r.m);
    for (int i = 0; i < 3; i++) {
        get_coefficient(expected, machine_value(&r.m, derivative[i]), 0);
        get_coefficient(value, gradient_value(&adjoint, 0, i), 0);
        ck_assert_int_eq(state(gradient_value(&adjoint, 0, i)), SYMBOLIC_FINE);
        ck_assert(fmpq_equal(value, expected));
    }
    get_coefficient(value, gradient_value(&adjoint, 0, 1), 0);
    get_coefficient(expected, machine_value(&r.m, 0), 0);
    fmpq_mul(expected, expected, value);
    get_coefficient(value, machine_value(&r.m, by_first), 0);
    ck_assert(fmpq_equal(value, expected));
}

/* In balls too, which know no zero but as such: else each vector of (37), where I_33 - I_22 is I - I, would be asked of exact numbers. */
TEST(what_is_taken_from_itself_has_no_gradient)
{
    OWNED(running) r;
    OWNED(gradient) by;
    open_running(&r, "x/3*(y - y) + a", &arithmetic_ball, 64);
    gradient_init(&by, &r.p, &r.node, 1, &arithmetic_ball, 64);
    for (int i = 0; i < r.p.inputs; i++)
        arb_set_ui(machine_value(&r.m, i), 7);
    machine_run(&r.m);
    gradient_run(&by, &r.m);
    ck_assert(arb_is_zero(gradient_value(&by, 0, 0)) && arb_is_zero(gradient_value(&by, 0, 1)) && arb_is_one(gradient_value(&by, 0, 2)));
}

/* f(x) = x^2 + 1 with y - 1 in the place of x, beside what p has already */
TEST(inlined_program_takes_the_place_of_its_inputs)
{
    OWNED(running) r;
    struct program other;
    SCOPE(fmpq, value, expected);
    const int y = parse_inputs(&r.p, "y - 1"), f = parse_inputs(&other, "x^2 + 1");
    int stand_in[] = {y, -1, -1, -1, -1, -1, -1};
    ck_assert_int_le(other.count, COUNT(stand_in));
    r.node = program_copy_node(&r.p, &other, f, stand_in);
    program_clear(&other);
    machine_init(&r.m, &r.p, &arithmetic_symbolic, 1);
    set_inputs(&r.m);
    get_coefficient(value, result_of(&r), 0);
    fmpq_set_si(expected, 13, 9); /* (5/3 - 1)^2 + 1 */
    ck_assert(fmpq_equal(value, expected));
}

/* ---- the arithmetics agree ---- */

/*
 * Each function's ball has (1) its rounding, (2) what its arguments' radii make of it. Of thin arguments at 20 bits it holds what
 * 300 bits say, and no binary number of 20 bits is that; of wide ones what 300 bits say at their corners. MPFR says the same.
 */
static const char *const of_balls[] = {"-x/3", "x + y/3", "x - y/3", "x*y/3", "x/y", "x^3/3", "1/x", "x^2/3", "x^0/3", "sqrt(x)", "sin(x)", "sin(x)*sin(x)/3",
                                       "cos(x)", "exp(x)", "log(x)", "atan2(y, x)", "atan2(-y, x)", "atan2(y, -x)", "atan2(y - 3, x)"};

EACH(ball_of_each_function_has_rounding_and_radius, 2*COUNT(of_balls))
{
    const char *formula = of_balls[_i % COUNT(of_balls)];
    const bool wide = _i >= COUNT(of_balls);
    OWNED(running) coarse, fine, rounded;
    SCOPE(arb, known);
    open_running(&coarse, formula, &arithmetic_ball, 20);
    open_running(&fine, formula, &arithmetic_ball, 300);
    open_running(&rounded, formula, &arithmetic_mpfr, 300);
    for (int corner = 0; corner < (wide ? 4 : 1); corner++) {
        for (int i = 0; i < 2; i++) { /* 11/4 and 3, or as much as 1/16 to either side */
            arb_ptr x = machine_value(&fine.m, i), around = machine_value(&coarse.m, i);
            arb_set_si(x, wide ? 4*(11 + i) + (corner >> i & 1 ? 1 : -1) : 11 + i);
            arb_mul_2exp_si(x, x, wide ? -4 : -2);
            arf_get_mpfr(machine_value(&rounded.m, i), arb_midref(x), MPFR_RNDN);
            arb_set_si(around, 11 + i);
            arb_mul_2exp_si(around, around, -2);
            mag_set_d(arb_radref(around), wide ? 0x1p-4 : 0);
        }
        arb_srcptr z = result_of(&fine);
        ck_assert(arb_contains(result_of(&coarse), z));
        arf_set_mpfr(arb_midref(known), result_of(&rounded));
        mag_set_ui_2exp_si(arb_radref(known), 1, -290); /* a few roundings of values below 32 */
        ck_assert(arb_contains(known, z));
    }
}

/* Of special arguments: wide, zero, infinite. NaN: nothing is known of the value; else it is so near, exactly, as MPFR has it too. */
static const struct {
    const char *formula;
    double x, radius, y, value;
} special[] = {
    {"positive(x)", 0.75, 0.25, 1, 1}, {"positive(x)", -0.75, 0.25, 1, 0}, {"positive(x)", 0, 0, 1, 0}, {"positive(x)", 0.25, 0.75, 1, NAN},
    {"x/y", INFINITY, 0, INFINITY, NAN}, /* a finite number over infinity is 0, infinity over it is nothing, nor is a number over all */
    {"x/y", 1, 0, INFINITY, 0},
    {"y/x", INFINITY, 0, 1, 0},
    {"y/x", INFINITY, INFINITY, 1, NAN},
    {"atan2(y, x)", -1, 0, 0, 0x1.921fb54442d18p+1}, /* the nearest double of pi */
    {"atan2(y, x)", 2, 0, 0, 0},
    {"y^0", 4, 0, 0, 1},
};

EACH(ball_of_a_special_argument_is_the_function_there, COUNT(special))
{
    OWNED(running) r;
    open_running(&r, special[_i].formula, &arithmetic_ball, 64);
    arb_set_d(machine_value(&r.m, 0), special[_i].x);
    mag_set_d(arb_radref((arb_ptr)machine_value(&r.m, 0)), special[_i].radius);
    arb_set_d(machine_value(&r.m, 1), special[_i].y);
    arb_srcptr z = result_of(&r);
    ck_assert(arb_is_finite(z) == !isnan(special[_i].value));
    if (isnan(special[_i].value))
        return;
    ck_assert_double_eq(arf_get_d(arb_midref(z), ARF_RND_NEAR), special[_i].value);
    OWNED(running) rounded;
    open_running(&rounded, special[_i].formula, &arithmetic_mpfr, 64);
    mpfr_set_d(machine_value(&rounded.m, 0), special[_i].x, MPFR_RNDN);
    mpfr_set_d(machine_value(&rounded.m, 1), special[_i].y, MPFR_RNDN);
    ck_assert_double_eq(mpfr_get_d(result_of(&rounded), MPFR_RNDN), special[_i].value);
}

/* Where x has either sign, and y is 0 exactly, the angle of (x, y) is 0 or pi. */
TEST(ball_of_an_angle_has_both_sides_of_its_jump)
{
    OWNED(running) r;
    SCOPE(arb, pi);
    open_running(&r, "atan2(y, x)", &arithmetic_ball, 64);
    arb_set_d(machine_value(&r.m, 0), 0.25);
    mag_set_d(arb_radref((arb_ptr)machine_value(&r.m, 0)), 0.75);
    arb_srcptr angle = result_of(&r);
    arb_const_pi(pi, 300);
    ck_assert(arb_contains_si(angle, 0) && arb_contains(angle, pi));
}

/* Its jump apart, positive() has slope 0; so has x^0, at 0 too. And the normal forms have no logarithm. */
EACH(slopes_by_x_in_balls, 4)
{
    static const struct {
        const char *formula;
        slong x;
        double slope;
    } cases[] = {{"positive(x)*y", 2, 0}, {"x^0*y", 2, 0}, {"x^0*y", 0, 0}, {"log(x) + y", 2, 0.5}};
    OWNED(running) r;
    OWNED(gradient) adjoint;
    r.node = parse_inputs(&r.p, cases[_i].formula);
    const int slope = program_derivative(&r.p, r.node, (const int[]){1, -1}, 2);
    gradient_init(&adjoint, &r.p, &r.node, 1, &arithmetic_ball, 64);
    machine_init(&r.m, &r.p, &arithmetic_ball, 64);
    arb_set_si(machine_value(&r.m, 0), cases[_i].x);
    arb_set_si(machine_value(&r.m, 1), 3);
    machine_run(&r.m);
    gradient_run(&adjoint, &r.m);
    ck_assert_double_eq(arf_get_d(arb_midref((arb_ptr)gradient_value(&adjoint, 0, 0)), ARF_RND_NEAR), cases[_i].slope);
    ck_assert(arb_is_one(gradient_value(&adjoint, 0, 1)));
    ck_assert_double_eq(arf_get_d(arb_midref((arb_ptr)machine_value(&r.m, slope)), ARF_RND_NEAR), 3*cases[_i].slope); /* x moves by y */
}

/* ---- normal forms ---- */

/* In the variables x and y: what is equal, and what is too large to say. */
static const struct {
    const char *formula;
    enum symbolic_fault fault;
} forms[] = {
    {"(x + y)^2 - x^2 - 2*x*y - y^2", SYMBOLIC_FINE},
    {"(x^3 - y^3)/(x - y) - x^2 - x*y - y^2", SYMBOLIC_FINE},
    {"1/x + 1/y - (x + y)/(x*y)", SYMBOLIC_FINE},
    {"((2^999)^999)^999", SYMBOLIC_TOO_LARGE},
    {"((x^999)^999)^999", SYMBOLIC_TOO_LARGE},
    {"((x + y)^999)^999", SYMBOLIC_TOO_LARGE},
    {"((x/y + 1)^200 + (y/x - 2)^200)^100", SYMBOLIC_TOO_LARGE},
    {"(((x + 1)^9*(y + 1)^9 + 1)^9 + x)^9/(((x + y)^9 + 7)^9 + y)^9", SYMBOLIC_TOO_LARGE},
    {"1/(x + y)^900 + 1/(x - y)^900", SYMBOLIC_TOO_LARGE}, /* by its denominators alone */
    {"(x^900)^60*(y^900)^60", SYMBOLIC_TOO_LARGE},
    {"(x^900)^60/((y^900)^60 + 1)", SYMBOLIC_TOO_LARGE}, /* that of both together */
    {"1/(x - x)", SYMBOLIC_POLE},
    {"sqrt(x^2)", SYMBOLIC_UNKNOWN_ROOT},
    {"sqrt(x)", SYMBOLIC_NO_SQUARE},
};

static void set_variables(struct running *r, int count)
{
    for (int i = 0; i < count; i++)
        symbolic_set_variable(machine_value(&r->m, i), i, 0, NULL);
}

EACH(normal_form_is_zero_or_refused, COUNT(forms))
{
    symbolic_end();
    symbolic_begin(2, 0);
    OWNED(running) r;
    open_running(&r, forms[_i].formula, &arithmetic_symbolic, 1);
    set_variables(&r, 2);
    const struct symbolic *x = result_of(&r);
    ck_assert_int_eq(x->fault, forms[_i].fault);
    ck_assert(x->fault != SYMBOLIC_FINE || fmpz_mpoly_q_is_zero(x->a, symbolic_context()));
}

/* In x and the angle a, whose half has the tangent x, with room for two functions and -x for a root. */
static const struct {
    const char *formula;
    enum symbolic_fault fault;
    bool zero;
} functions[] = {
    {"sqrt(x^2) + x", SYMBOLIC_FINE, true}, /* a root is the one that was given, of either sign */
    {"sqrt(x) - sqrt(x)", SYMBOLIC_FINE, true}, /* the same unknown is the same function's value */
    {"sqrt(x) - exp(x)", SYMBOLIC_FINE, false},
    {"sin(x + a) - sin(x + a)", SYMBOLIC_FINE, true}, /* of an angle with a number on top */
    {"sin(x + a) - sin(x - a)", SYMBOLIC_FINE, false}, /* the opposite angle has the same cosine */
    {"cos(atan2(x, 1)) - cos(atan2(x, 2))", SYMBOLIC_FINE, false},
    {"cos(atan2(1, x)) - cos(atan2(2, x))", SYMBOLIC_FINE, false},
    {"atan2(x, 1)", SYMBOLIC_ANGLE_AS_NUMBER, false},
    {"exp(x) + exp(2*x) + exp(3*x)", SYMBOLIC_TRANSCENDENTAL, false},
};

EACH(function_without_value_is_an_unknown, COUNT(functions))
{
    symbolic_end();
    symbolic_begin(1, 2);
    OWNED(running) r;
    open_running(&r, functions[_i].formula, &arithmetic_symbolic, 1);
    set_variables(&r, 1);
    arithmetic_symbolic.apply(OPERATOR_NEGATE, machine_value(&r.m, 1), machine_value(&r.m, 0), NULL, 0, 1);
    symbolic_root(machine_value(&r.m, 1));
    symbolic_set_angle(machine_value(&r.m, 2), 0, NULL);
    const struct symbolic *x = result_of(&r);
    ck_assert_int_eq(state(x), functions[_i].fault);
    ck_assert_int_eq(fmpz_mpoly_q_is_zero(x->a, symbolic_context()), functions[_i].zero || x->fault != SYMBOLIC_FINE || x->angle);
    ck_assert_int_eq(symbolic_root_used(0), _i == 0);
}

/* A polynomial of x has a degree; what is none has not, nor what has no value, or is no number. */
EACH(polynomial_is_got, 5)
{
    static const struct {
        const char *formula;
        slong degree;
    } cases[] = {{"x/2 + x^3", 3}, {"1/x", -1}, {"a", -1}, {"log(x)", -1}, {"1/(x - x)", -1}};
    symbolic_end();
    symbolic_begin(1, 0);
    OWNED(running) r;
    SCOPE(fmpq_poly, f);
    open_running(&r, cases[_i].formula, &arithmetic_symbolic, 1);
    set_variables(&r, 1);
    const struct symbolic *x = result_of(&r);
    ck_assert_int_eq(symbolic_get_polynomial(f, x), cases[_i].degree >= 0);
    ck_assert_int_eq(fmpq_poly_degree(f), cases[_i].degree);
    ck_assert_int_eq(x->large, _i == 4);
    if (_i == 4) { /* and what has no value over zero is not large, where it was before */
        struct symbolic *over = machine_value(&r.m, 1);
        over->fault = SYMBOLIC_TRANSCENDENTAL;
        arithmetic_symbolic.apply(OPERATOR_DIVIDE, machine_value(&r.m, r.node), over, machine_value(&r.m, 0), 0, 1);
        ck_assert(!x->large);
    }
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
    symbolic_end();
    passed = 2 * CLOCKS_PER_SEC;
    symbolic_begin(4, 0);
    OWNED(running) r;
    open_running(&r, "(x + y + a + e)^15*(x + 2*y + a + e)^15", &arithmetic_symbolic, 1);
    set_variables(&r, 4);
    ck_assert_int_eq(state(result_of(&r)), SYMBOLIC_FINE);
    passed = 4 * CLOCKS_PER_SEC;
    ck_assert_int_eq(state(result_of(&r)), SYMBOLIC_TOO_LARGE);
    passed = 0;
    ck_assert_ptr_nonnull(strstr(symbolic_fault_text(SYMBOLIC_TOO_LARGE), "too large to normalise, seconds: "));
    symbolic_set_angle(machine_value(&r.m, 0), 0, NULL); /* nor is a sum of angles known */
    arithmetic_symbolic.apply(OPERATOR_ADD, machine_value(&r.m, 1), machine_value(&r.m, 0), machine_value(&r.m, 0), 0, 1);
    ck_assert_int_eq(state(machine_value(&r.m, 1)), SYMBOLIC_TOO_LARGE);
}
