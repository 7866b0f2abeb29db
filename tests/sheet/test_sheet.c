/*
 * The formula sheet: what a sheet says is what the program has, and each mistake in it stops with the
 * file, the line, the column and what was expected there.
 */
#include "tests/run.h"
#include "tests/paper.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "sheet/sheet.h"


/* A sheet in small, without a mistake; the numbers of its lines stand beside it. */
static const char good[] =
    "quantities:\n"                                                                   /*  1 */
    "  Omega: {unit: rad/s, domain: \"> 0\", range: [1, 2], meaning: rate, example: 2}\n" /*  2 */
    "  x1: {unit: m, domain: finite, range: [1, 9], sign: either, meaning: place, example: 3}\n" /*  3 */
    "  y1: {unit: m, domain: finite, range: [1, 9], sign: either, meaning: along, example: 1}\n" /*  4 */
    "  L: {unit: m, domain: \">= 0\", value: 10, meaning: distance}\n"                /*  5 */
    "  lambda_d: {unit: m, domain: \"> 0 or inf\", meaning: length}\n"                /*  6 */
    "table1:\n"                                                                       /*  7 */
    "  - {name: L, printed: \"10\", unit: m, scale: 1}\n"                             /*  8 */
    "equations:\n"                                                                    /*  9 */
    "  eq1:\n"                                                                        /* 10 */
    "    title: a definition\n"                                                       /* 11 */
    "    equations: [\"1\"]\n"                                                        /* 12 */
    "    relations:\n"                                                                /* 13 */
    "      - {equation: \"1\", holds: \"x1 = 2*L\"}\n"                               /* 14 */
    "  eq2:\n"                                                                        /* 15 */
    "    title: a formula\n"                                                          /* 16 */
    "    equations: [2a, 2b]\n"                                                       /* 17 */
    "    inputs: [Omega, x1, y1]\n"                                                   /* 18 */
    "    let:\n"                                                                      /* 19 */
    "      r: sqrt(x1^2 + y1^2)\n"                                                    /* 20 */
    "    outputs:\n"                                                                  /* 21 */
    "      L: Omega*r\n"                                                              /* 22 */
    "    domain: [x1 + y1 > 0, Omega >= y1, y1 < 4]\n"                                /* 23 */
    "    printed:\n"                                                                  /* 24 */
    "      outputs:\n"                                                                /* 25 */
    "        L: Omega*x1\n"                                                           /* 26 */
    "    reason: the root is missing\n"                                               /* 27 */
    "  eq3:\n"                                                                        /* 28 */
    "    title: an algorithm\n"                                                       /* 29 */
    "    equations: [\"3\"]\n"                                                        /* 30 */
    "    method: roots\n"                                                             /* 31 */
    "    inputs: [L]\n"                                                               /* 32 */
    "    outputs: [x1, y1]\n"                                                         /* 33 */
    "  eq4:\n"                                                                        /* 34 */
    "    title: a formula for the oracle\n"                                           /* 35 */
    "    equations: [\"4\"]\n"                                                        /* 36 */
    "    inputs: [Omega, x1]\n"                                                       /* 37 */
    "    let:\n"                                                                      /* 38 */
    "      half: x1/2\n"                                                              /* 39 */
    "    outputs:\n"                                                                  /* 40 */
    "      y1: Omega*half\n"                                                          /* 41 */
    "    vectors:\n"                                                                  /* 42 */
    "      three: {x1: 3, flags: edge}\n"                                             /* 43 */
    "    mistakes:\n"                                                                 /* 44 */
    "      not halved: {let: {half: x1}}\n"                                           /* 45 */
    "    K: {bound: 20, reason: it may}\n"                                            /* 46 */
    "K: {bound: 8, reason: all may}\n"                                                /* 47 */
    "mistakes:\n"                                                                     /* 48 */
    "  another rate: {inputs: {Omega: 2*Omega}}\n";                                   /* 49 */

/* The good sheet with one text in place of another; malloc'ed. */
static char *changed(const char *from, const char *to)
{
    const char *at = strstr(good, from);
    ck_assert_msg(at != NULL, "the sheet has no '%s'", from);
    char *text = malloc(sizeof good + strlen(to));
    sprintf(text, "%.*s%s%s", (int)(at - good), good, to, at + strlen(from));
    return text;
}

TEST(sheet_is_read)
{
    struct sheet s;
    struct message why = {""};
    ck_assert_msg(sheet_read(&s, good, strlen(good), "t", &why) == 0, "%s", why.text);
    ck_assert_int_eq(s.quantity_count, 5);
    ck_assert_int_eq(s.row_count, 1);
    ck_assert_int_eq(s.section_count, 4);
    const struct quantity *x1 = quantity_find(&s, "x1"), *y1 = quantity_find(&s, "y1");
    ck_assert_str_eq(x1->unit, "m");
    ck_assert_str_eq(y1->meaning, "along");
    ck_assert(x1->either_sign);
    ck_assert_int_eq(quantity_find(&s, "lambda_d")->domain, DOMAIN_POSITIVE_OR_INFINITE);
    ck_assert_ptr_null(quantity_find(&s, "x2"));
    const struct section *definition = section_find(&s, "eq1"), *formula = section_find(&s, "eq2");
    ck_assert_int_eq(definition->method, METHOD_NONE);
    ck_assert_str_eq(definition->relations[0].text, "x1 = 2*L");
    ck_assert_int_eq(formula->method, METHOD_FORMULA);
    ck_assert_int_eq(formula->numbers, 2);
    ck_assert_str_eq(formula->equations[1], "2b");
    ck_assert_int_eq(formula->input_count, 3);
    ck_assert_ptr_eq(formula->outputs[0], quantity_find(&s, "L"));
    ck_assert_int_eq(formula->corrected.count, 3);
    ck_assert(formula->differs);
    ck_assert_str_eq(formula->printed.text[0], "Omega*x1");
    ck_assert_int_eq(formula->printed.count, 3); /* the domain is that of the corrected one */
    ck_assert_int_eq(section_find(&s, "eq3")->method, METHOD_ROOTS);
    ck_assert_str_eq(section_find(&s, "eq3")->kind, "equation");
    ck_assert_ptr_null(section_find(&s, "eq5"));
    const struct section *asked = section_find(&s, "eq4");
    ck_assert_int_eq(asked->special_count, 1);
    ck_assert_str_eq(asked->specials[0].flags, "edge");
    ck_assert_ptr_null(asked->specials[0].texts[0]); /* as in the paper's case */
    ck_assert_str_eq(asked->specials[0].texts[1], "3");
    ck_assert_int_eq(asked->mistake_count, 1);
    ck_assert_str_eq(asked->mistakes[0].changes[0].formula, "x1");
    ck_assert_double_eq(asked->K, 20);
    ck_assert_double_eq(formula->K, 8);
    ck_assert_int_eq(s.mistake_count, 1);
    sheet_clear(&s);
}

/* In place of `from`, `to`; the message begins with the place and has this text. */
static const struct {
    const char *from, *to, *place, *expected;
} mistakes[] = {
    {"quantities:", "quantity:", "1:1: ", "unknown key 'quantity', expected perhaps quantities"},
    {"table1:", "table2:", "7:1: ", "unknown key 'table2', expected perhaps table1"},
    {"domain: finite", "domain: infinite", "3:25: ", "expected a domain: finite, > 0, >= 0 or > 0 or inf"},
    {"domain: finite, ", "", "3:7: ", "missing domain, expected a domain"},
    {"unit: rad/s, ", "", "2:10: ", "missing unit, expected a text"},
    {"unit: rad/s", "units: rad/s", "2:11: ", "unknown key 'units', expected perhaps unit"},
    {"  L: {", "  x1: {", "5:3: ", "duplicate 'x1', expected each key once"},
    {"[1, 2]", "[2, 1]", "2:46: ", "expected low < high"},
    {"sign: either", "sign: [either]", "3:54: ", "expected a sign: either"},
    {"[1, 2]", "[1]", "2:46: ", "expected two bounds, [low, high]"},
    {"[1, 2]", "[1, 2, 3]", "2:53: ", "expected a list of at most 2 texts"},
    {"[1, 2]", "[1, two]", "2:50: ", "expected a positive number"},
    {"[1, 2]", "[nan, 2]", "2:47: ", "expected a positive number"},
    {"{name: L, ", "{name: M, ", "8:5: ", "unknown quantity 'M'"},
    {", scale: 1", "", "8:5: ", "missing scale, expected a text"},
    {"  - {name: L, printed: \"10\", unit: m, scale: 1}\n", "  L: 10\n", "8:3: ", "expected a list"},
    {"title: a formula", "titel: a formula", "16:5: ", "unknown key 'titel', expected perhaps title"},
    {"title: a formula\n", "title: a formula\n    kind: rumour\n", "17:11: ", "expected a kind: equation or beyond"},
    {"    equations: [2a, 2b]\n", "", "16:5: ", "missing equations, expected the equation numbers that it stands for"},
    {"[2a, 2b]", "[]", "17:16: ", "expected at least one of the equation numbers that it stands for"},
    {"[Omega, x1, y1]", "[Omga, x1, y1]", "18:14: ",
     "unknown symbol 'Omga', expected a quantity of the sheet (did you mean 'Omega'?)"},
    {"[Omega, x1, y1]", "[Omega, x1, x1]", "18:25: ", "'x1' twice, expected it once"},
    {"[Omega, x1, y1]", "[Omega, x1]", "20:22: ", "unknown symbol 'y1'"},
    {"      r: sqrt", "      x1: sqrt", "20:7: ", "'x1' is an input already, expected a new name"},
    {"sqrt(x1^2 + y1^2)", "sqrt(x1^2 + y1^2", "20:26: ", "expected ')' or an operator, the formula ends here"},
    {"sqrt(x1^2 + y1^2)", "sqrt(x1^2 + y1^2))", "20:27: ", "expected an operator or the end of the formula, found ')'"},
    {"sqrt(x1^2 + y1^2)", "sqrt(x1^2 ++ y1^2)", "20:21: ", "expected a number, a symbol or '(', found '+'"},
    {"sqrt(x1^2 + y1^2)", "sqrt(x1^k + y1^2)", "20:18: ", "expected an exponent"},
    {"sqrt(x1^2 + y1^2)", "[x1, y1]", "20:10: ", "expected a formula"},
    {"L: Omega*r\n", "L: Omega*R\n", "22:16: ", "unknown symbol 'R'"},
    {"L: Omega*r\n", "L: \"Omega*R\"\n", "22:17: ", "unknown symbol 'R'"},
    {"L: Omega*r\n", "M: Omega*r\n", "22:7: ", "unknown symbol 'M', expected a quantity of the sheet"},
    {"L: Omega*r\n", "L: {a: b}\n", "22:10: ", "expected a formula"},
    {"x1 + y1 > 0", "sqrt(x1^2 + 2) > 1", "23:14: ", "expected a condition without functions: it is decided exactly"},
    {"x1 + y1 > 0", "x1 + y1", "23:14: ", "expected a condition with >, >= or <, or that ends"},
    {"x1 + y1 > 0", "x1 + z1 > 0", "23:19: ", "unknown symbol 'z1'"},
    {"x1 + y1 > 0", "x1 + y1 > z1", "23:24: ", "unknown symbol 'z1'"},
    {"        L: Omega*x1\n", "        x1: Omega*x1\n", "26:9: ",
     "expected the outputs of the corrected equation, in its order"},
    {"        L: Omega*x1\n", "        L: Omega*x1\n        x1: \"1\"\n", "27:9: ",
     "expected the outputs of the corrected equation, in its order"},
    {"    reason: the root is missing\n", "", "16:5: ", "missing reason, expected a text"},
    {"      outputs:\n        L: Omega*x1\n", "      domain: []\n", "25:7: ", "missing outputs"},
    {"      outputs:\n        L: Omega*x1\n", "      output:\n        L: Omega*x1\n", "25:7: ",
     "unknown key 'output', expected perhaps outputs"},
    {"x1 = 2*L", "x1 - 2*L", "14:32: ", "expected left = right"},
    {"x1 = 2*L", "x1 = 2* ", "14:41: ", "expected a number, a symbol or '(', the formula ends here"},
    {"equation: \"1\", ", "", "14:9: ", "missing equation, expected a text"},
    {"method: roots", "method: root", "31:13: ", "expected a method: roots, flow_linear, flow_nonlinear, rk4_linear or rk4_nonlinear"},
    {"    inputs: [L]\n", "", "29:5: ", "missing inputs"},
    {"    outputs: [x1, y1]\n", "", "29:5: ", "missing outputs"},
    {"[x1, y1]\n", "[x1, z1]\n", "33:19: ", "unknown symbol 'z1'"},
    {"table1:", "[table1]:", "7:1: ", "expected a plain key"},
    {"unit: rad/s", "unit: \"\"", "2:17: ", "missing unit, expected a text"},
    {"    let:\n      r: sqrt(x1^2 + y1^2)\n", "    let: r\n", "19:10: ", "expected a mapping, key: value"},
    {"      outputs:\n        L: Omega*x1\n", "      outputs: {}\n", "25:16: ", "expected 1 outputs"},
    {"      three: {x1: 3, flags: edge}\n", "      - three\n", "43:7: ", "expected a mapping, key: value"},
    {"{x1: 3, flags: edge}", "3", "43:14: ", "expected a mapping, key: value"},
    {", flags: edge", "", "43:14: ", "missing flags, expected a text"},
    {"{x1: 3", "{y1: 3", "43:15: ", "'y1' is no input of eq4"},
    {"{x1: 3", "{x1: [3]", "43:19: ", "expected a number"},
    {"{let: {half: x1}}", "x1", "45:19: ", "expected a mapping, key: value"},
    {"{let: {half: x1}}", "{lets: {half: x1}}", "45:20: ", "unknown key 'lets', expected perhaps let"},
    {"{half: x1}", "{half: [x1]}", "45:32: ", "expected a formula, and at most 12 of them"},
    {"{half: x1}", "{hlf: x1}", "45:19: ", "'hlf' is not there to be changed"},
    {"{half: x1}", "{Omega: x1}", "45:19: ", "'Omega' is not there to be changed"},
    {"{half: x1}", "{half: x9}", "45:19: ", "half: unknown symbol 'x9'"},
    {"{let: {half: x1}}", "{}", "45:19: ", "nothing is changed"},
    {"{let: {half: x1}}", "{as: eq1}", "45:19: ", "as: expected an operation with as many outputs"},
    {"{let: {half: x1}}", "{as: eq3}", "45:19: ", "as: expected an operation with as many outputs"},
    {"{let: {half: x1}}", "{as: eq5}", "45:19: ", "as: expected an operation with as many outputs"},
    {"{let: {half: x1}}", "{as: eq2}", "45:19: ", "eq2 needs y1"},
    {"{bound: 20, reason: it may}", "20", "46:8: ", "expected a mapping, key: value"},
    {"bound: 20", "bound: 0", "46:16: ", "expected a positive number"},
    {"bound: 8, ", "", "47:4: ", "missing bound, expected a positive number"},
    {"  another rate: {inputs: {Omega: 2*Omega}}\n", "  - another\n", "49:3: ", "expected a mapping, key: value"},
    {"{inputs: {Omega: 2*Omega}}", "2*Omega", "49:17: ", "expected a mapping, key: value"},
    {"bound: 20", "bound: inf", "46:16: ", "expected a positive number, finite"},
    {"[1, 2]", "[1, 1e999]", "2:50: ", "expected a positive number, finite"},
    {"value: 10", "value: -10", "5:39: ", "expected a number of the quantity's own domain"},
    {"value: 10", "value: inf", "5:39: ", "expected a number of the quantity's own domain"},
    {"value: 10", "example: -10", "5:41: ", "expected a number of the quantity's own domain"},
    {"range: [1, 2]", "value: 0", "2:46: ", "expected a number of the quantity's own domain"},
    {"range: [1, 2]", "sign: either", "2:45: ", "expected no sign where the domain has but one"},
    {", example: 3", "", "18:21: ", "expected an input that has a value or an example, 'x1' has neither"},
    {"{x1: 3", "{x1: three", "43:19: ", "expected a number"},
    {"{x1: 3", "{x1: 1e999", "43:19: ", "expected a number"},
    {"{x1: 3", "{x1: \"3 four\"", "43:19: ", "expected a number"},
    {"value: 10", "value: [10]", "5:39: ", "missing value, expected a text"},
    {"unit: rad/s", "\"un\\nit\": rad/s", "2:11: ", "unknown key 'un?it', expected perhaps unit"},
    {"outputs: [x1, y1]\n", "outputs: [x1, y1]\n---\nmore:\n", "34:1: ", "expected one document, another follows"},
    {"outputs: [x1, y1]\n", "outputs: [x1, y1]\n...\n]\n", "34:1: ", "expected one document, another follows"},
    {"[2a, 2b]", "[2a, 2b", "", "expected YAML: "},
    {"[2a, 2b]", "&a [*a]", "17:16: ", "expected no alias of this"},
    {"[2a, 2b]", "\n      &a b:\n        *a : c", "18:7: ", "expected no alias of this"},
    {"[2a, 2b]", "[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[2a]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]", "17:45: ", "expected less in each other"},
    {"equations:\n  eq1:", "equations:\n\teq1:", "", "expected YAML: "},
};

EACH(mistake_is_told_with_its_place, COUNT(mistakes))
{
    struct sheet s;
    struct message why = {""};
    char place[40];
    char *text = changed(mistakes[_i].from, mistakes[_i].to);
    ck_assert_int_ne(sheet_read(&s, text, strlen(text), "t.yaml", &why), 0);
    snprintf(place, sizeof place, "t.yaml:%s", mistakes[_i].place);
    ck_assert_msg(strncmp(why.text, place, strlen(place)) == 0, "'%s' is not at %s", why.text, place);
    ck_assert_msg(strstr(why.text, mistakes[_i].expected) != NULL, "'%s' has no '%s'", why.text,
                  mistakes[_i].expected);
    free(text);
}

/* A place is looked for in the text as long as it is, whatever stands behind it. */
TEST(a_place_behind_the_end_is_the_end)
{
    static const char text[] = "a: >-\n  one\n  two\n\n\n\nmore";
    struct message why = {""};
    struct tree *tree = tree_open(text, strlen("a: >-\n  one\n  two\n"), "t.yaml", &why);
    ck_assert_ptr_nonnull(tree);
    const struct yaml *a = under(&tree->root, "a");
    ck_assert_str_eq(a->text, "one two");
    node_error(a, strlen(a->text), "expected more");
    ck_assert_str_eq(why.text, "t.yaml:4:1: expected more");
    tree_close(tree);
}

TEST(empty_sheet_is_refused)
{
    struct sheet s;
    struct message why = {""};
    ck_assert_int_ne(sheet_read(&s, "", 0, "t.yaml", &why), 0);
    ck_assert_msg(strncmp(why.text, "t.yaml:1:1: expected", 20) == 0, "%s", why.text);
}

/* Whatever byte of the sheet is lost, it is read or refused in words, never worse. */
TEST(cut_sheet_is_read_or_refused)
{
    for (size_t length = 0; length < strlen(good); length++) {
        struct sheet s;
        struct message why = {""};
        if (sheet_read(&s, good, length, "t.yaml", &why) == 0)
            sheet_clear(&s);
        else
            ck_assert_msg(strncmp(why.text, "t.yaml:", 7) == 0, "%s", why.text);
    }
}

/* ---- the paper's sheet ---- */

/*
 * Where random vectors come from is a choice, which nothing else in the sheet depends on: it is made twice. Formations
 * of metres to a kilometre, in orbits from a quarter of an hour of rad/Omega to a day, charges up to ten microcoulombs.
 */
static const struct {
    const char *names;
    double low, high;
    bool either_sign;
} ranges[] = {
    {"Omega", 1e-5, 1e-3, false},
    {"k_c", 8e9, 1e10, false},
    {"lambda_d", 10, 1e4, false},
    {"GM", 1e13, 1e15, false},
    {"m1 m2 m3 L L_ref", 1, 1000, false},
    {"L_dot", 1e-7, 0.1, true},
    {"dL dL_0", 1e-4, 10, true},
    {"dL_dot dL_dot_0", 1e-8, 1e-2, true},
    {"psi theta psi_0 theta_0", 1e-4, 3, true},
    {"psi_dot theta_dot psi_dot_0 theta_dot_0", 1e-8, 1e-3, true},
    {"psi_ddot theta_ddot", 1e-12, 1e-6, true},
    {"Q Q_ref dQ", 1e-16, 1e-10, true},
    {"q1 q2 q3", 1e-8, 1e-5, true},
    {"x1 y1 z1 x2 y2 z2 x3 y3 z3 x1_0 y1_0 z1_0", 0.1, 100, true},
    {"x1_dot y1_dot z1_dot x2_dot y2_dot z2_dot x3_dot y3_dot z3_dot", 1e-7, 0.1, true},
    {"x1_dot_0 y1_dot_0 z1_dot_0", 1e-7, 0.1, true},
    {"I", 1, 1e9, false},
    {"R_c", 6.5e6, 1e8, false},
    {"R_c1 R_c2 R_c3", 1e5, 1e8, true},
    {"C1", 1e-10, 1e-5, true},
    {"C2", 1e-6, 1e-2, true},
    {"n", 9, 100, false},
    {"t", 1, 1e5, true},
    {"h", 1, 1000, false},
};

TEST(ranges_are_these)
{
    int with_range = 0;
    for (int k = 0; k < COUNT(ranges); k++) {
        char names[80], *rest = NULL;
        snprintf(names, sizeof names, "%s", ranges[k].names);
        for (char *name = strtok_r(names, " ", &rest); name; name = strtok_r(NULL, " ", &rest), with_range++) {
            const struct quantity *q = quantity_find(sheet(), name);
            ck_assert_msg(q != NULL && q->low == ranges[k].low && q->high == ranges[k].high &&
                          q->either_sign == ranges[k].either_sign, "%s", name);
        }
    }
    for (int i = 0; i < sheet()->quantity_count; i++)
        with_range -= sheet()->quantities[i].high > 0;
    ck_assert_int_eq(with_range, 0);
}

/* Table 1, the gains and the initial values: what commands fall back on, and the user may override. */
TEST(values_of_the_simulation_are_these)
{
    static const char names[] = " Omega k_c m1 m2 L_ref n dL dL_dot psi theta psi_dot theta_dot dL_0 dL_dot_0 psi_0 theta_0 psi_dot_0 theta_dot_0 ";
    for (int i = 0; i < sheet()->quantity_count; i++) {
        const struct quantity *q = &sheet()->quantities[i];
        char name[40];
        snprintf(name, sizeof name, " %s ", q->name);
        ck_assert_msg((q->value != NULL) == (strstr(names, name) != NULL), "%s", q->name);
        ck_assert_msg(q->value == NULL || q->example == NULL, "%s", q->name);
    }
}

/* eq10lin stands for Eq. (10); a motion for the equations that it obeys. */
TEST(sections_stand_for_the_equation_in_their_name)
{
    for (int i = 0; i < sheet()->section_count; i++) {
        const struct section *s = &sheet()->sections[i];
        const bool linear = strstr(s->id, "_linear") != NULL, motion = strchr(s->id, '_') != NULL;
        const int number = motion ? (linear ? 40 : 3) : atoi(s->id + 2);
        bool found = false;
        for (int k = 0; k < s->numbers; k++)
            found |= atoi(s->equations[k]) == number;
        ck_assert_msg(found, "%s", s->id);
        ck_assert_msg(!motion || (s->numbers == 3 && s->equations[0][strlen(s->equations[0]) - 1] == 'a' &&
                                  s->equations[1][strlen(s->equations[1]) - 1] == 'b' &&
                                  s->equations[2][strlen(s->equations[2]) - 1] == 'c'), "%s", s->id);
    }
}

/* Nothing follows a definition, so that nothing holds it: it is written twice. */
TEST(definitions_are_these)
{
    static const char *const texts[][5] = {{"L = L_ref + dL", "Q = Q_ref + dQ"}, {"w_1 = 0", "w_2 = 0", "w_3 = Omega"}};
    const struct section *sections[] = {section_find(sheet(), "eq16"), section_find(sheet(), "eq23")};
    for (int i = 0; i < 2; i++)
        for (int k = 0; k < sections[i]->relation_count; k++)
            ck_assert_str_eq(sections[i]->relations[k].text, texts[i][k]);
}

TEST(no_relation_stands_twice)
{
    for (int i = 0; i < sheet()->section_count; i++) {
        const struct section *s = &sheet()->sections[i];
        for (int k = 0; k < s->relation_count; k++)
            for (int r = 0; r < k; r++)
                ck_assert_str_ne(s->relations[k].text, s->relations[r].text);
    }
}
