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

#include "claims/statement.h"
#include "evaluate/reference.h"
#include "text/decimal.h"
#include "text/scope.h"

enum { MOST = 40, BASES = 4 };

/* Powers of 2 for m, kg, s, C: even ones, so that roots scale without rounding, and no product of a few is 1. */
static const int power_of[BASES] = {4, 14, 10, 6};

static bool add(const char *name, size_t length, int exponent, int power[BASES])
{
    static const struct {
        const char *name;
        int power[BASES];
    } units[] = {{"m", {1, 0, 0, 0}}, {"kg", {0, 1, 0, 0}}, {"s", {0, 0, 1, 0}}, {"C", {0, 0, 0, 1}},
                 {"N", {1, 1, -2, 0}}, {"J", {2, 1, -2, 0}}, {"W", {2, 1, -3, 0}}, {"V", {2, 1, -2, -1}},
                 {"rad", {0}}, {"1", {0}}, {"-", {0}}, {"%", {0}}, {"km", {1, 0, 0, 0}}, {"mm", {1, 0, 0, 0}}, {"h", {0, 0, 1, 0}}, {"uC", {0, 0, 0, 1}}};
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

EACH(every_operation_holds_in_any_units, sheet()->section_count)
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

/* What no operation computes stands in relations, as another name for what one does. */
EACH(both_sides_of_a_renaming_have_one_unit, sheet()->section_count)
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

/* ---- the numbers of the evidence ---- */

/* The sheet's values, counted in the grown units; or as they were. */
static void grow_values(const char **were, bool back)
{
    for (int i = 0; i < sheet()->quantity_count; i++) {
        struct quantity *q = &sheet()->quantities[i];
        SCOPE(fmpq, value, factor);
        if (q->value == NULL)
            continue;
        if (back) {
            free((char *)q->value);
            q->value = were[i];
            continue;
        }
        literal_read(value, q->value, true);
        const int power = (int)log2(growth(q->unit));
        fmpq_one(factor);
        fmpz_mul_2exp(power < 0 ? fmpq_denref(factor) : fmpq_numref(factor), fmpq_numref(factor), (ulong)abs(power));
        fmpq_mul(value, value, factor);
        were[i] = q->value;
        q->value = decimal_of_rational(value, 60);
    }
}

static void number_of(arb_t x, struct statements *claims, struct statement *s, const struct quoted_number *q)
{
    enum how how = EXACT;
    const struct bindings b = {.all = claims, .statement = s, .at = &s->at, .at_count = s->at.count, .bits = 256, .how = &how};
    formula_enclose(x, &q->formula, &b);
}

/* What has numbers with units of their own: constants of nature, times of day, steps of 100 s, values of a case. */
static bool has_other_units(const char *id)
{
    static const char *const all[] = {"non-keplerian-periods", "charge-error", "debye-escape", "coulomb-constant", "orbit-rate", "own-gravity",
                                      "power-and-bandwidth", "charging-devices", "reach", "step-below-period", "two-revolutions",
                                      "equal-distances", "runge-kutta-kind"};
    for (size_t i = 0; i < sizeof all / sizeof *all; i++)
        if (strcmp(all[i], id) == 0)
            return true;
    return false;
}

/* Of what rests on the sheet's values alone, and on no computation. */
TEST(numbers_of_the_evidence_have_their_units)
{
    struct derivations proofs;
    struct statements claims;
    struct message why;
    const char *were[200] = {NULL};
    int checked = 0;
    ck_assert(sheet()->quantity_count <= 200);
    open_steps(&proofs);
    ck_assert(statements_read(&claims, &proofs, &whole_paper()->claims, &why) == 0);
    for (int i = 0; i < claims.count; i++)
        for (int k = 0; k < claims.list[i].number_count; k++) {
            struct statement *s = &claims.list[i];
            const struct quoted_number *q = &s->numbers[k];
            SCOPE(arb, x, grown, due);
            ulong computed = 0;
            for (int a = 0; a < s->assertion_count; a++)
                computed |= (ulong)(s->assertions[a].kind == ASSERT_COMPUTE) << a;
            if ((q->formula.uses & computed) != 0 || has_other_units(s->id))
                continue;
            number_of(x, &claims, s, q);
            grow_values(were, false);
            number_of(grown, &claims, s, q);
            grow_values(were, true);
            arb_set_d(due, q->unit != NULL ? growth(q->unit) : 1);
            arb_mul(due, due, x, 256);
            ck_assert_msg(arb_is_finite(grown) && arb_overlaps(grown, due), "%s: %s is no number of [%s]", s->id, q->text, q->unit ? q->unit : "");
            checked++;
        }
    ck_assert_int_gt(checked, 80);
    statements_clear(&claims);
    derivations_clear(&proofs);
}
