/*
 * What binds a step, on a sheet in small: each kind of alteration is tried, and one that nothing tells is refused; what is
 * named is what is used, and holds for all values.
 *
 *   (W1) an equality that holds for any formulas shows nothing    (first_tautology)
 *   (W2) nothing is taken of the sheet that is not named          (nothing_beyond)
 *   (W3) what `from` names changes an equality                    (all_used)
 *   (W4) what `to` names changes one, its sign does, and each alteration of each node   (part_is_bound, all_changes_tell)
 *   (W5) it is shown on an open set of its inputs                 (is_general, fills_open_set)
 *   (W6) it does not start from what it leads to                  (is_new)
 *   (W7) without an equality something of this is missing         (all_wanted)
 */
#include "tests/run.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "proof/derivation.h"

/* The formula of eq1, a relation of eq2, and another section. */
static const char sheet_text[] =
    "quantities:\n"
    "  a: {unit: m, domain: finite, meaning: one, example: 1}\n"
    "  b: {unit: m, domain: finite, meaning: one, example: 1}\n"
    "  c: {unit: m, domain: finite, meaning: one, example: 1}\n"
    "  a_dot: {unit: m/s, domain: finite, meaning: its rate, example: 1}\n"
    "  p: {unit: m, domain: \"> 0\", meaning: one, example: 1}\n"
    "  s: {unit: m, domain: \">= 0\", meaning: one, example: 1}\n"
    "  psi: {unit: rad, domain: finite, meaning: an angle, example: 1}\n"
    "  theta: {unit: rad, domain: finite, meaning: an angle, example: 1}\n"
    "  f: {unit: m, domain: finite, meaning: one, example: 1}\n"
    "  g: {unit: m, domain: finite, meaning: one, example: 1}\n"
    "  h: {unit: m, domain: finite, meaning: one, example: 1}\n"
    "table1: []\n"
    "equations:\n"
    "  eq1: {title: one, equations: [\"1\"], inputs: [a, b, c, p, psi, theta], let: {open: a + b}, outputs: {f: \"%s\"}}\n"
    "  eq2: {title: two, equations: [2a, 2b], inputs: [a], outputs: {f: 2*a, g: 3*a}}\n"
    "  eq3: {title: three, equations: [3a, 3b, 3c], inputs: [a, b], outputs: {f: a, g: b}, relations: [{equation: 3a, holds: a*b = f}]}\n"
    "  eq10: {title: ten, equations: [\"10\"], inputs: [b], outputs: {f: b - 1}}\n"
    "K: {bound: 8, reason: all may}\n"
    "mistakes: {none: {inputs: {a: 2*a}}}\n";

/* With a formula of eq1, principles and properties, and steps; false, and `why`, where they are refused. */
static bool open_with(struct sheet *s, struct derivations *d, const char *formula, const char *definitions, const char *steps, struct message *why)
{
    static char sheet_of[3000], text[3000];
    snprintf(sheet_of, sizeof sheet_of, sheet_text, formula);
    ck_assert_msg(sheet_read(s, sheet_of, strlen(sheet_of), "s", why) == 0, "%s", why->text);
    snprintf(text, sizeof text, "%s\nsteps:\n%s\n", definitions, steps);
    return derivations_read(d, s, text, strlen(text), "t", why) == 0;
}

/* With the formula of eq1 and that of `given`: what is wrong with the step, "" where nothing is, and how many alterations were tried. */
static int bind_step(const char *formula, const char *given, const char *step, char said[600])
{
    char definitions[600], one[2000];
    struct sheet s;
    struct derivations d;
    struct message why = {""};
    int mutants = 0;
    snprintf(definitions, sizeof definitions,
             "principles: {given: {text: a, inputs: [a, b, c, p, psi, theta], outputs: {g: \"%s\"}}, further: {text: b, inputs: [a], outputs: {g: 5*a}}}\n"
             "properties: {shape: {text: c, inputs: [a], outputs: {k: 7*a}}}", given);
    snprintf(one, sizeof one, "  one:\n    title: one\n%s", step);
    if (!open_with(&s, &d, formula, definitions, one, &why)) {
        snprintf(said, 600, "%s", why.text);
    } else {
        const bool bound = step_is_bound(&d, d.steps);
        ck_assert_msg(step_holds(d.steps), "%s", d.steps->proof.evidence != NULL ? d.steps->proof.evidence : d.steps->line_proof.evidence);
        snprintf(said, 600, "%s", d.steps->binding.fault.text);
        ck_assert(bound == (said[0] == '\0'));
        mutants = d.steps->binding.mutants;
        derivations_clear(&d);
    }
    sheet_clear(&s);
    return mutants;
}

#define ENDS "    from: [given]\n    to: [\"1\"]\n"
#define SAME ENDS "    show: [eq1.f = given.g]"

/* (W4) as many alterations as the formula has places for them: each node may lose a side, change its sign, its number. */
static const struct {
    const char *formula, *step;
    int alterations;
} bound[] = {
    {"a*b + c", SAME, 5},
    {"a*b - c", SAME, 5},
    {"b - a", SAME, 3}, /* the first of all names on the right */
    {"a/b", SAME, 2},
    {"-a", SAME, 2},
    {"a^2", SAME, 2},
    {"a^2 + 0*b", SAME, 8}, /* 0*b for -0*b and 0 for it: the same function, as nothing can tell */
    {"2*a", SAME, 3},
    {"1*a", SAME, 3}, /* a for 1*a is the same function, too */
    {"sin(psi) + cos(theta)", ENDS "    angles: [psi, theta]\n    show: [eq1.f = given.g]", 7},
    {"sqrt(p^2)", ENDS "    square roots: [p]\n    show: [eq1.f = given.g]", 3},
    {"a*sqrt(p^2)", ENDS "    square roots: [p]\n    show: [eq1.f = a*p + 0*given.g, eq1.f = given.g]", -1},
    {"a*open", ENDS "    let: {open: a + b}\n    show: [eq1.f = given.g + 0*open]", 5}, /* which that is not */
    {"a*open", ENDS "    free: [open]\n    show: [eq1.f = given.g(b = open - a)]", 2}, /* what is below the open name is not spoken of */
    {"a*b + c", ENDS "    rates: {a: a_dot}\n    show: [rate(eq1.f^2) = rate(given.g^2), eq1.f = given.g]", -1},
    {"exp(a) + b", ENDS "    small: [a]\n    order: 2\n    show: [eq1.f = given.g]", 4},
};

EACH(alterations_are_all_tried, COUNT(bound))
{
    char said[600];
    const char *given = strstr(bound[_i].formula, "open") != NULL ? "a*(a + b)" : bound[_i].formula;
    const int tried = bind_step(bound[_i].formula, given, bound[_i].step, said);
    if (bound[_i].alterations >= 0) {
        ck_assert_str_eq(said, "");
        ck_assert_int_eq(tried, bound[_i].alterations);
    } else {
        ck_assert_msg(strstr(said, "could be left out") != NULL, "%s", said);
    }
}

static const struct {
    const char *formula, *given, *step, *said;
} refused[] = {
    /* (W4) one alteration that nothing tells: values for which it changes nothing */
    {"a*b + c", "a + c", ENDS "    show: [eq1.f(b = 1) = given.g]", "f may be altered (a right factor or term dropped)"},
    {"a*b + c", "b + c", ENDS "    show: [eq1.f(a = 1) = given.g]", "f may be altered (a left factor or term dropped)"},
    {"a*b + c", "a*b", ENDS "    show: [eq1.f(c = 0) = given.g]", "f may be altered (a sign)"},
    {"a*b - c", "a*b", ENDS "    show: [eq1.f(c = 0) = given.g]", "f may be altered (a sign)"},
    {"c - a*b", "-a*b", ENDS "    show: [eq1.f(c = 0) = given.g]", "f is shown for some values of its inputs alone"},
    {"c + a*b", "a*b", ENDS "    show: [eq1.f(c = 0) = given.g]", "f may be altered (a left factor or term dropped)"},
    {"-a + b", "b", ENDS "    show: [eq1.f(a = 0) = given.g]", "f may be altered (a sign)"},
    {"2*a + b", "b", ENDS "    show: [eq1.f(a = 0) = given.g]", "f may be altered (a number or exponent)"},
    {"a^2 + b", "1 + b", ENDS "    show: [eq1.f(a = 1) = given.g]", "f may be altered (a right factor or term dropped)"},
    {"b + a^3", "b", ENDS "    show: [eq1.f(a = 0) = given.g]", "f may be altered (a right factor or term dropped)"},
    {"a/b + c", "a + c", ENDS "    show: [eq1.f(b = 1) = given.g]", "f may be altered (a right factor or term dropped)"},
    {"a/b + c", "c - a", ENDS "    show: [eq1.f(b = -1) = given.g]", "f may be altered (a left factor or term dropped)"},
    {"sin(psi)*cos(psi)", "0*a", ENDS "    angles: [psi]\n    show: [\"eq1.f(psi = psi - psi) = 0 + given.g\"]", "f may have the other sign"},
    {"a", "a^2", ENDS "    show: [eq1.f^2 = given.g]", "f may have the other sign"},
    {"a*b", "a*b", "    from: [given]\n    to: [\"1\", \"2a\"]\n    show: [eq1.f = given.g]\n    lines: {so: eq2.f = a + a}", "f stands in no equality"},
    {"a + b*positive(theta)", "a", ENDS "    show: [eq1.f(theta = -1) = given.g]", "f may be altered (a left factor or term dropped)"},
    {"2*a", "3*a", ENDS "    show: [(eq1.f - 2*a)*(eq1.f - 3*a) = 0, given.g = 3*a]", "f may be altered (a number or exponent)"},
    {"a*open", "a*(b + c)", ENDS "    show: [\"eq1.f(open = b + c) = given.g\"]", "f may be altered (a sign)"}, /* of what is bound to something else */
    /* to the order that is compared */
    {"b + a*c", "b + a", ENDS "    small: [a]\n    order: 0\n    show: [eq1.f = given.g]", "f may be altered (a right factor or term dropped)"},
    {"b + a*a", "b", ENDS "    small: [a]\n    order: 1\n    show: [eq1.f = given.g]", "f may be altered (a sign)"},
    /* an alteration that cannot be told is none that changes nothing */
    {"a*(b^250)^399", "a*(b^250)^399", ENDS "    show: [\"eq1.f(b = 2) = given.g(b = 2)\"]", "may be altered (a number or exponent)"},
    /* values that depend on each other, but for roundings: they fill no open set */
    {"a*b", "a*b", ENDS "    angles: [psi]\n    show: [\"eq1.f(a = sin(psi), b = cos(psi)) = given.g(a = sin(psi), b = cos(psi))\"]", "f is shown for some values"},
    {"a*b", "a*b", ENDS "    show: [\"eq1.f(a = c/3, b = c^2/7) = given.g(a = c/3, b = c^2/7)\"]", "f is shown for some values"},
    /* (W3) what is used is not felt: times zero, in a root, in a rate, beyond the order, by way of what is bound to something else */
    {"a*b", "c", ENDS "    show: [eq1.f = a*b + 0*given.g]", "'given' is not used"},
    {"p*b", "c", ENDS "    square roots: [p + 0*given.g]\n    show: [eq1.f = sqrt((p + 0*given.g)^2)*b]", "'given' is not used"},
    {"a*b", "a*c", ENDS "    rates: {a: a_dot}\n    show: [eq1.f + rate(a + 0*given.g) = a*b + a_dot]", "'given' is not used"},
    {"a*b", "a*c", ENDS "    rates: {a: a_dot}\n    show: [eq1.f + rate(c*0*given.g) = a*b]", "'given' is not used"},
    {"b*c", "c", ENDS "    small: [a]\n    order: 0\n    show: [eq1.f = b*c + a*given.g]", "'given' is not used"},
    {"a*b", "c", ENDS "    rates: {u: a_dot}\n    let: {u: a*c + given.g}\n    show: [\"eq1.f(b = rate(u)) = a*a_dot + 0*u\"]", "'given' is not used"},
    {"b*c", "c", ENDS "    small: [a]\n    order: 1\n    show: [eq1.f = b*c + a^2*given.g]", "'given' is not used"},
    {"a*b", "c", "    from: [given, further]\n    to: [\"1\"]\n    show: [eq1.f + given.g = a*b + given.g, eq1.f = a*further.g*b/(5*a)]",
     "'given' is not used"},
    {"a*b", "a*b", "    from: [given, further]\n    to: [\"1\"]\n    show: [eq1.f = given.g]", "'further' is not used"},
    /* (W1) whatever the formulas are; what is a number is none; the second of several */
    {"a", "a", ENDS "    show: [eq1.f - eq1.f = given.g - given.g]", "holds whatever the formulas are"},
    {"a", "a", ENDS "    show: [eq1.f = given.g, 2*eq1.f = eq1.f + eq1.f]", "2*eq1.f = eq1.f + eq1.f holds whatever"},
    {"a*b", "a*b", ENDS "    show: [eq1.f = given.g, 2*eq1.f = eq1.f + eq1.f]\n    lines: {so: eq1.f - a*b = 0}", "2*eq1.f = eq1.f + eq1.f holds whatever"},
    {"a", "a", ENDS "    show: [eq1.f = given.g, b = b + 0*c]", "b = b + 0*c holds whatever"},
    {"a", "a", ENDS "    rates: {a: a_dot}\n    show: [eq1.f = given.g, rate(eq1.f^2) = 2*eq1.f*rate(eq1.f)]", "holds whatever the formulas are"},
    {"atan2(p*sin(psi), p*cos(psi))", "p", ENDS "    angles: [psi]\n    square roots: [p]\n    show: [sin(eq1.f)^2 + cos(eq1.f)^2 = 1, p = given.g]", "holds whatever"},
    {"a", "p", ENDS "    square roots: [b^2 + 1, p]\n    let:\n"
     "      D: (c-5)*(c-7)*(c-11)*(c-13)*(c-17)*(c-19)*(c-23)*(c-29)*(c-31)*(c-37)*(c-41)*(c-43)*(c-47)*(c-53)*(c-59)*(c-61)*(c-67)*(c-71)\n"
     "    show: [0*sqrt((b^2 + 1)^2)*eq1.f/D + sqrt(p^2) = 0*given.g/D + p]", "holds whatever"}, /* no value at the point: normal forms tell */
    {"p*a", "p*a", ENDS "    square roots: [p]\n    show: [\"eq1.f/p = sqrt(p^2)*given.g/p^2\", \"eq1.f(a = 1) - eq1.f(a = 1) + sqrt(p^2) = p\"]", "holds whatever"},
    {"a", "a", ENDS "    let: {u: a + b}\n    show: [eq1.f = given.g, u = a + b]", "u = a + b holds whatever"},
    {"a*b", "a*b", ENDS "    let: {u: a*b}\n    show: [eq1.f = given.g + 0*u]\n    lines: {so: u - a*b = 0}", ""},
    {"a*b", "a*b", ENDS "    let: {u: a*b, v: b*a}\n    show: [eq1.f = given.g + 0*u*v]\n    lines: {so: u - v = 0}", ""}, /* each definition may be another */
    {"a", "a", ENDS "    show: [eq1.f = given.g = 1*given.g]", "given.g = 1*given.g holds whatever"},
    {"a*b", "a*b", ENDS "    let: {u: eq1.f, v: eq1.f}\n    show: [u = given.g + 0*v]\n    lines: {so: u - v = 0}", "u - v = 0 holds whatever"},
    /* too large to be decided, once altered, at the point and by normal forms: nothing is shown to break */
    {"a", "a", ENDS "    show: [\"eq1.f = given.g + 0*(eq1.f^250)^200\"]", "holds whatever"},
    /* (W2) */
    {"a", "a", ENDS "    positive: [a]\n    show: [eq1.f = given.g]", "'a' may be negative in the sheet, expected a name of its own"}, /* the first of all */
    {"a", "a", ENDS "    show: [eq1.f = given.g + 0*eq2.f]", "it rests on eq2, which neither from nor to names"},
    {"a", "a", ENDS "    show: [eq1.f = given.g]\n    lines: {so: eq2.f = a + a}", "it rests on eq2, which neither from nor to names"},
    {"a", "b - 1", "    from: [given]\n    to: [\"1\", \"10\"]\n    show: [eq10.f = given.g, eq1.f = given.g(b = a + 1)]", ""},
    {"a", "b - 1", "    from: [given]\n    to: [\"1\"]\n    show: [eq10.f = given.g, eq1.f = given.g(b = a + 1)]", "it rests on eq10"},
    /* (W5) for values that hang together */
    {"a*b", "a^2", ENDS "    show: [eq1.f(a = b) = given.g(a = b)]", "f is shown for some values of its inputs alone"},
    {"a*b", "a*b", ENDS "    let: {u: a + b}\n    show: [\"eq1.f(a = u, b = u^2) = given.g(a = u, b = u^2)\"]", "f is shown for some values"},
    {"a*b", "a*b", ENDS "    let: {u: a + b, v: a*b}\n    show: [\"eq1.f(a = u, b = v) = given.g(a = u, b = v)\"]", ""},
    {"a*b", "a*b", ENDS "    let: {u: a + b, v: a - b}\n    show: [\"eq1.f(a = u + v, b = u) = given.g(a = u + v, b = u)\"]", ""},
    {"a*b", "a*b", ENDS "    show: [\"eq1.f(a = c, b = 2) = given.g(a = c, b = 2)\"]", "f is shown for some values"},
    {"a*b", "a*b", ENDS "    show: [\"eq1.f(a = b) = given.g(a = b)\", given.g = a*b]", "f is shown for some values"},
    {"a*b", "a^1*b", ENDS "    show: [\"eq1.f(a = b) = given.g(a = b)\", given.g = a*b]", "f is shown for some values"}, /* which no other of that node is */
    {"a*open", "a*(a + b)", ENDS "    show: [\"eq1.f(a = b) = given.g(a = b)\", eq1.open = a + b]", "f is shown for some values"},
    {"a*theta", "a*theta", ENDS "    show: [\"eq1.f(theta = a) = given.g(theta = a)\"]", "f is shown for some values"},
    {"a + c", "a + c", ENDS "    show: [\"eq1.f(a = b, c = p) = given.g(a = b, c = p)\"]", ""},
    {"a*b", "a*b", ENDS "    show: [\"eq1.f(b = 2) = given.g(b = 2)\", eq1.f = given.g]", "could be left out"},
    {"a*b", "a*b", ENDS "    show: [eq1.f = given.g, \"eq1.f(b = 2) = given.g(b = 2)\"]", "could be left out"},
    {"a*b", "a*b", ENDS "    show: [eq1.f = given.g, eq1.f^2 = a^2*b^2]", "eq1.f^2 = a^2*b^2 could be left out"}, /* it breaks with the other alone */
    /* (W6) */
    {"a", "a", "    from: [\"1\", given]\n    to: [\"1\"]\n    show: [eq1.f = given.g]", "f is in from already"},
    {"a*open", "a*(a + b)", "    from: [eq1.open, given]\n    to: [\"1\"]\n    show: [eq1.f = given.g, eq1.open = given.g/a]", ""},
    {"a", "a", "    from: [given, \"1\"]\n    to: [\"1\"]\n    show: [eq1.f = given.g]", "f is in from already"},
    /* a side of a relation: both, whole */
    {"a", "b", "    from: [given]\n    to: [\"3a\"]\n    show: [\"left(3a) = given.g*a\"]", "stands in no equality as a whole: a side is not shown"},
    {"a", "b", "    from: [given]\n    to: [\"3a\"]\n    let: {f: a*given.g}\n    show: [left(3a) = right(3a)]", ""},
    /* a property claims nothing of its formula, but is to be there */
    {"a", "7*a", "    from: [given]\n    to: [shape]\n    show: [shape.k = given.g]", ""},
    {"a", "7*a", "    from: [given]\n    to: [shape, \"2a\"]\n    show: [\"eq2.f = given.g(a = 2*a/7)\"]", "k stands in no equality"},
    /* (W7) */
    {"a", "a", ENDS "    show: [eq1.f = given.g, \"eq1.f(a = 2*a) = given.g(a = 2*a)\"]", "could be left out"},
    {"a", "a", "    from: [given, further]\n    to: [\"1\"]\n    show: [eq1.f = given.g, eq1.f = further.g/5]", ""},
    {"a", "a", "    from: [given, further]\n    to: [\"1\"]\n    show: [eq1.f = given.g, eq1.f = further.g/5, given.g = further.g/5]", "could be left out"},
};

EACH(unbound_step_is_refused, COUNT(refused))
{
    char said[600];
    bind_step(refused[_i].formula, refused[_i].given, refused[_i].step, said);
    ck_assert_msg(refused[_i].said[0] != '\0' ? strstr(said, refused[_i].said) != NULL : said[0] == '\0', "%s", said);
}

static void open_small(struct sheet *s, struct derivations *d, const char *steps)
{
    struct message why = {""};
    ck_assert_msg(open_with(s, d, "a*open", "principles: {given: {text: a, inputs: [a, b, c], outputs: {g: a + b + c}}}\nproperties: {}", steps, &why),
                  "%s", why.text);
}

/* All that was proved of a step counts; of what is printed instead, that it differs. */
TEST(step_holds_by_all_of_its_proofs)
{
    struct remainder remainders[2];
    const struct step good = {.proved = true, .differs = true, .remainders = remainders, .remainder_count = 2,
                              .printed_proof = {.result = IDENTITY_DIFFERS}};
    for (int fault = 0; fault < 9; fault++) {
        struct step s = good;
        for (int k = 0; k < 2; k++)
            remainders[k] = (struct remainder){.proof = {.state = fault == 1 + k ? REMAINDER_UNDECIDED : REMAINDER_PROVED}};
        s.proof.result = fault == 3 ? IDENTITY_DIFFERS : fault == 4 ? IDENTITY_UNDECIDED : IDENTITY_HOLDS;
        s.line_proof.result = fault == 5 ? IDENTITY_DIFFERS : fault == 6 ? IDENTITY_UNDECIDED : IDENTITY_HOLDS;
        if (fault >= 7)
            s.printed_proof.result = fault == 7 ? IDENTITY_HOLDS : IDENTITY_UNDECIDED;
        ck_assert_int_eq(step_holds(&s), fault == 0);
    }
}

TEST(step_that_does_not_hold_is_not_bound)
{
    static const char *const steps[] = {
        "  one: {title: t, from: [given], to: [\"1\"], show: [eq1.f = given.g]}\n",
        "  one: {title: t, from: [given], to: [\"1\"], show: [eq1.f = given.g*a - a*c], lines: {so: given.g = a + b - c}}\n",
        "  one: {title: t, from: [given], to: [\"1\"], show: [eq1.f = given.g*a - a*c], printed: {show: [given.g = a + b + c]}}\n",
        "  one: {title: t, from: [given], to: [\"1\"], show: [eq1.f = given.g*a - a*c]}\n"};
    for (int i = 0; i < COUNT(steps); i++) {
        struct sheet s;
        struct derivations d;
        open_small(&s, &d, steps[i]);
        ck_assert_int_eq(step_is_bound(&d, &d.steps[0]), i == COUNT(steps) - 1);
        ck_assert_int_eq(d.steps[0].binding.mutants > 0, i == COUNT(steps) - 1);
        derivations_clear(&d);
        sheet_clear(&s);
    }
}

/* ---- which number an output has, and what reaches it ---- */

#define STEP(name, from, to) "  " name ": {title: t, from: [" from "], to: [" to "], show: [a = b]}\n"

TEST(outputs_have_numbers)
{
    struct sheet s;
    struct derivations d;
    struct entry_part parts[MOST_PARTS];
    bool alone;
    open_small(&s, &d, STEP("one", "given", "\"1\""));
    ck_assert_str_eq(output_equation(section_find(&s, "eq2"), 1, &alone), "2b");
    ck_assert(alone);
    ck_assert_str_eq(output_equation(section_find(&s, "eq3"), 0, &alone), "3b"); /* 3a is a relation's */
    ck_assert_str_eq(output_equation(section_find(&s, "eq3"), 1, &alone), "3c");
    ck_assert(alone);
    ck_assert_str_eq(output_equation(section_find(&s, "eq1"), 0, &alone), "1");
    static const struct {
        const char *entry;
        int parts;
    } entries[] = {{"1", 1}, {"2", 2}, {"2a", 1}, {"3", 4}, {"3a", 2}, {"3b", 1}, {"10", 1}, {"eq3", 2}, {"eq3.g", 1}, {"eq3.a", 0},
                   {"eq1.open", 1}, {"eq1.closed", 0}, {"given", 1}, {"given.g", 1}, {"eq4", 0}, {"0", 0}, {"2c", 0}};
    for (int i = 0; i < COUNT(entries); i++)
        ck_assert_msg(entry_parts(&d, entries[i].entry, parts) == entries[i].parts, "%s", entries[i].entry);
    ck_assert(entry_leads_to(&d, "1", "1") && !entry_leads_to(&d, "1", "10") && !entry_leads_to(&d, "10", "1"));
    ck_assert(entry_leads_to(&d, "eq3.f", "3b") && !entry_leads_to(&d, "eq3.f", "3c") && !entry_leads_to(&d, "eq3.f", "3a"));
    derivations_clear(&d);
    sheet_clear(&s);
}

/* Each step that is needed left out; what is named and left open is to be reached by itself; a circle reaches nothing. */
static const struct {
    const char *steps, *gap;
} gaps[] = {
    {STEP("p", "given", "\"1\"") STEP("q", "\"1\"", "\"2\"") STEP("r", "\"2\"", "\"3\"") STEP("s", "\"3\"", "\"10\""), NULL},
    {STEP("s", "\"3\"", "\"10\"") STEP("r", "\"2\"", "\"3\"") STEP("q", "\"1\"", "\"2\"") STEP("p", "given", "\"1\""), NULL},
    {STEP("q", "\"1\"", "\"2\"") STEP("r", "\"2\"", "\"3\"") STEP("s", "\"3\"", "\"10\""), "1"},
    {STEP("p", "given", "\"1\"") STEP("r", "\"2\"", "\"3\"") STEP("s", "\"3\"", "\"10\""), "2a"},
    {STEP("p", "given", "\"1\", 2a") STEP("r", "\"2\"", "\"3\"") STEP("s", "\"1\"", "\"10\""), "2b"},
    {STEP("p", "given", "\"1\", \"2\"") STEP("r", "\"2\"", "3b, 3c") STEP("s", "\"1\"", "\"10\""), "3a"},
    {STEP("p", "given", "\"1\", \"2\", \"3\""), "10"},
    {STEP("p", "given", "\"2\", \"3\"") STEP("q", "given, \"10\"", "\"1\"") STEP("r", "given, \"1\"", "\"10\""), "1"}, /* each of `from` */
    {STEP("p", "given", "\"1\", \"3\", \"10\"") STEP("q", "2b", "2a") STEP("r", "2a", "2b"), "2a"},
    {STEP("p", "given", "\"1\", \"3\", 2b") STEP("q", "\"2\"", "\"10\"") STEP("r", "\"10\"", "2a"), "2a"}, /* all of an entry, the first too */
    {"  p: {title: t, from: [given], to: [\"1\", \"2\", \"3\", \"10\"], free: [open], show: [eq1.f = a*open]}\n", "1"},
    {"  p: {title: t, from: [given], to: [\"1\", eq1.open, \"2\", \"3\", \"10\"], free: [open], show: [eq1.f = a*open]}\n", NULL},
    {"  p: {title: t, from: [given], to: [\"1\", \"2\", \"3\", \"10\"], let: {open: a + b}, show: [eq1.f = a*open]}\n", NULL}, /* no free name */
};

EACH(gap_is_told, COUNT(gaps))
{
    struct sheet s;
    struct derivations d;
    open_small(&s, &d, gaps[_i].steps);
    const char *gap = derivations_gap(&d);
    ck_assert_msg(gaps[_i].gap == NULL ? gap == NULL : gap != NULL && strcmp(gap, gaps[_i].gap) == 0, "%s", gap != NULL ? gap : "none");
    derivations_clear(&d);
    sheet_clear(&s);
}

/* The domain that a step prints says all that was assumed, of what is shown alone. */
TEST(domain_says_what_was_assumed)
{
    struct sheet s;
    struct derivations d;
    open_small(&s, &d, "  one: {title: t, from: [given], to: [\"1\"], positive: [k, q], free: [m], angles: [psi], quarter turns: [theta],\n"
                       "    small: [c], order: 1, rates: {k: a_dot}, square roots: [p, k*q],\n"
                       "    let: {a: 2*k, b: eq2.f(a = k), g: eq2.f(a = k)*0, h: given.g + 0*(k + q + m + c + p + s + a + b), u: a*b, f: rate(k), a_dot: rate(k) + 1},\n"
                       "    show: [a + b + c*p + s + m + g + h + u = sin(psi) + cos(theta) + f*a_dot]}\n");
    char *domain = identities_domain(&d.steps[0].corrected);
    ck_assert_str_eq(domain, "c small, p > 0, s >= 0, psi any angle, theta within a quarter turn, k > 0, q > 0, a = 2*k, g = eq2.f(a = k)*0, h by its definition, a_dot = rate(k) + 1");
    free(domain);
    derivations_clear(&d);
    sheet_clear(&s);
    open_small(&s, &d, STEP("one", "given", "\"1\""));
    domain = identities_domain(&d.steps[0].corrected);
    ck_assert_str_eq(domain, "all values");
    free(domain);
    derivations_clear(&d);
    sheet_clear(&s);
}
