/*
 * The units of the sheet: an equation holds in any of them. Where metre, kilogram, second and coulomb are made longer,
 * heavier and so on, and the inputs are counted in them, ref/ has to give the same outputs, counted in them.
 */
#include "tests/run.h"
#include "tests/paper.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "evaluate/reference.h"
#include "sheet/sheet.h"

enum { MOST = 40, BASES = 4 };

/* Powers of 2 for m, kg, s, C: even ones, so that roots scale without rounding, and no product of a few is 1. */
static const int power_of[BASES] = {4, 14, 10, 6};

static bool add(const char *name, size_t length, int exponent, int power[BASES])
{
    static const struct {
        const char *name;
        int power[BASES];
    } units[] = {{"m", {1, 0, 0, 0}}, {"kg", {0, 1, 0, 0}}, {"s", {0, 0, 1, 0}}, {"C", {0, 0, 0, 1}},
                 {"N", {1, 1, -2, 0}}, {"rad", {0}}, {"1", {0}}, {"-", {0}}};
    for (size_t i = 0; i < sizeof units / sizeof *units; i++) {
        if (strlen(units[i].name) != length || strncmp(units[i].name, name, length) != 0)
            continue;
        for (int k = 0; k < BASES; k++)
            power[k] += exponent * units[i].power[k];
        return true;
    }
    return false;
}

/* By how much a number of a unit like "N m^2/C^2" grows; after the slash stands one name. */
static double growth(const char *unit)
{
    int power[BASES] = {0}, sign = 1, total = 0;
    for (const char *at = unit; *at != '\0';) {
        const size_t length = strcspn(at, " /^");
        int exponent = 1, read = 0;
        ck_assert_msg(at[length] != '^' || sscanf(at + length, "^%d%n", &exponent, &read) == 1, "unit '%s'", unit);
        ck_assert_msg(add(at, length, sign * exponent, power), "unit '%s'", unit);
        at += length + (size_t)read;
        ck_assert_msg(*at == '\0' || *at == ' ' || (*at == '/' && sign > 0), "unit '%s'", unit);
        sign = *at == '/' ? -1 : sign;
        at += *at != '\0';
    }
    for (int k = 0; k < BASES; k++)
        total += power[k] * power_of[k];
    return ldexp(1, total);
}

/* A generic number inside the domain: nothing cancels, no angle or rate is zero. */
static double example(const struct quantity *q)
{
    const double value = strtod(q->value ? q->value : q->example, NULL);
    return value != 0 ? value : sqrt(q->low * q->high);
}

START_TEST(every_operation_holds_in_any_units)
{
    const struct section *s = &sheet()->sections[_i];
    reference_function *f = reference_find(s->id);
    double in[MOST], grown[MOST], out[MOST], expected[MOST];
    if (f == NULL)
        return;
    for (int i = 0; i < s->input_count; i++) {
        in[i] = example(s->inputs[i]);
        grown[i] = in[i] * growth(s->inputs[i]->unit);
    }
    f(in, expected);
    f(grown, out);
    for (int i = 0; i < s->output_count; i++) {
        const struct quantity *q = s->outputs[i];
        const double due = expected[i] * growth(q->unit);
        /* scaling by powers of 2 does not round; a motion's step control looks at magnitudes, which may */
        ck_assert_msg(fabs(out[i] - due) <= 1e-9 * fabs(due), "%s: %s is %g [%s], expected %g", s->id, q->name, out[i], q->unit, due);
    }
}
END_TEST

/* What no operation computes stands in relations, as another name for what one does. */
START_TEST(both_sides_of_a_renaming_have_one_unit)
{
    const struct section *s = &sheet()->sections[_i];
    for (int i = 0; i < s->relation_count; i++) {
        char left[16], right[16], more;
        if (sscanf(s->relations[i].text, "%15[A-Za-z0-9_] = %15[A-Za-z0-9_]%c", left, right, &more) != 2)
            continue;
        const struct quantity *a = quantity_find(sheet(), left), *b = quantity_find(sheet(), right);
        if (a != NULL && b != NULL)
            ck_assert_msg(growth(a->unit) == growth(b->unit), "%s [%s], %s [%s]", left, a->unit, right, b->unit);
    }
}
END_TEST

SUITE(test_units)
{
    Suite *suite = suite_create("units");
    TCase *units = tcase_create("units");
    tcase_add_loop_test(units, every_operation_holds_in_any_units, 0, sheet()->section_count);
    tcase_add_loop_test(units, both_sides_of_a_renaming_have_one_unit, 0, sheet()->section_count);
    suite_add_tcase(suite, units);
    return suite;
}
