#include "evaluate/domain.h"

#include <float.h>
#include <math.h>
#include <string.h>

#include "evaluate/sample.h"
#include "text/scope.h"

enum {
    FINITE = 1u << DOMAIN_FINITE,
    POSITIVE = 1u << DOMAIN_POSITIVE,
    NOT_NEGATIVE = 1u << DOMAIN_NOT_NEGATIVE,
    OR_INFINITE = 1u << DOMAIN_POSITIVE_OR_INFINITE
};

const struct extreme extremes[EXTREMES] = {
    {"nan", NAN, FINITE | POSITIVE | NOT_NEGATIVE | OR_INFINITE, true, false},
    {"inf", INFINITY, FINITE | POSITIVE | NOT_NEGATIVE, true, false},
    {"minus-inf", -INFINITY, FINITE, true, false},
    {"negative", -1, POSITIVE | NOT_NEGATIVE | OR_INFINITE, true, false},
    {"zero", 0, POSITIVE | OR_INFINITE, true, false},
    {"minus-inf", -INFINITY, POSITIVE | NOT_NEGATIVE | OR_INFINITE, true, true},
    {"below-zero", -DBL_MIN, NOT_NEGATIVE, true, true},
    {"zero", 0, NOT_NEGATIVE, false, true},
    {"inf", INFINITY, OR_INFINITE, false, true},
};

bool extreme_of(const struct extreme *x, const struct quantity *q)
{
    return (x->domains >> q->domain & 1u) != 0;
}

bool inputs_of_values(const struct section *s, const double *values, struct input *inputs)
{
    bool numbers = true;
    for (int i = 0; i < s->input_count; i++) {
        inputs[i].infinite = isinf(values[i]) && values[i] > 0;
        numbers = numbers && (isfinite(values[i]) || inputs[i].infinite);
        fmpq_set_double(&inputs[i].value, isfinite(values[i]) ? values[i] : 1.0);
    }
    return numbers;
}

/* ---- conditions ---- */

/* A condition's left side at some inputs, of which one is another: conditions are rational in their inputs. */
static void condition_value(fmpq_t f, const struct operation *o, int condition, struct input *inputs, int other, slong x)
{
    SCOPE(fmpq, kept);
    fmpq_set(kept, &inputs[other].value);
    fmpq_set_si(&inputs[other].value, x, 1);
    operation_condition(f, o, inputs, o->formulas->conditions[condition].node);
    fmpq_set(&inputs[other].value, kept);
}

/*
 * A condition f (compared with zero) is linear or quadratic in each input, f = a x^2 + b x + c: x becomes the zero of a line,
 * and where the least f of a parabola is. 1: a line's, 2: a parabola's, 0: nothing depends on this input.
 */
static int move_to_edge(const struct operation *o, int condition, struct input *inputs, int i)
{
    SCOPE(fmpq, a, b, c, x);
    int degree = 0;
    condition_value(c, o, condition, inputs, i, 0);
    condition_value(a, o, condition, inputs, i, 1);
    condition_value(x, o, condition, inputs, i, -1);
    fmpq_sub(b, a, x);
    fmpq_div_2exp(b, b, 1);
    fmpq_add(a, a, x);
    fmpq_div_2exp(a, a, 1);
    fmpq_sub(a, a, c);
    if (!fmpq_is_zero(a) || !fmpq_is_zero(b)) {
        degree = fmpq_is_zero(a) ? 1 : 2;
        if (degree == 1) {
            fmpq_div(x, c, b);
        } else {
            fmpq_div(x, b, a);
            fmpq_div_2exp(x, x, 1);
        }
        fmpq_neg(&inputs[i].value, x);
        fmpq_set_double(&inputs[i].value, fmpq_get_d(&inputs[i].value)); /* a number that can be asked */
    }
    return degree;
}

/* The next number, in whichever of the two directions the condition's being kept is what it is to be. */
static bool nudge(struct operation *o, const struct input *step, int i, double *values, struct input *inputs, bool outside)
{
    const double x = values[i];
    const bool steps = strcmp(o->section->inputs[i]->name, "t") == 0 && step != NULL; /* backwards, by a whole one */
    for (int direction = 0; direction < 2; direction++) {
        const double towards = direction == 0 ? INFINITY : -INFINITY;
        values[i] = x != 0 ? nextafter(x, towards) : copysign(steps ? fmpq_get_d(&step->value) : ldexp(1, -100), towards);
        inputs_of_values(o->section, values, inputs);
        if (operation_valid(o, inputs) != outside)
            return true;
    }
    return false;
}

bool domain_edge(struct operation *o, int condition, bool outside, double *values)
{
    const struct section *s = o->section;
    struct input *inputs = inputs_new(s->input_count);
    int moved = -1, degree = 2;
    const int h = input_place(s, "h");
    inputs_of_values(s, values, inputs);
    for (int i = 0; i < s->input_count && degree != 1; i++) {
        const int of_this = move_to_edge(o, condition, inputs, i);
        values[i] = inputs[i].infinite ? INFINITY : fmpq_get_d(&inputs[i].value);
        moved = of_this > 0 ? i : moved;
        degree = of_this > 0 ? of_this : degree;
    }
    const bool found = moved >= 0 && (operation_valid(o, inputs) != outside ||
                                      nudge(o, h < 0 ? NULL : &inputs[h], moved, values, inputs, outside));
    inputs_free(inputs, s->input_count);
    return found;
}

/* ---- defects ---- */

int edge_count(const struct formulas *f)
{
    int edges = 0;
    while (edges < f->count && f->conditions[edges].comparison != INTEGER)
        edges++;
    return edges;
}

bool domain_between_steps(const struct section *s, double *values)
{
    if (edge_count(&s->corrected) == s->corrected.count)
        return false;
    const int t = input_place(s, "t");
    values[t] = nextafter(values[t], INFINITY);
    return true;
}

void domain_defect(struct operation *o, uint64_t k, double *values)
{
    const struct section *s = o->section;
    uint64_t count = (uint64_t)o->formulas->count;
    for (int i = 0; i < s->input_count; i++)
        for (int n = 0; n < EXTREMES; n++)
            count += extremes[n].outside && extreme_of(&extremes[n], s->inputs[i]);
    k %= count;
    for (int c = 0; c < edge_count(o->formulas); c++)
        if (k-- == 0) {
            domain_edge(o, c, true, values);
            return;
        }
    for (int i = 0; i < s->input_count; i++)
        for (int n = 0; n < EXTREMES; n++)
            if (extremes[n].outside && extreme_of(&extremes[n], s->inputs[i]) && k-- == 0) {
                values[i] = extremes[n].value;
                return;
            }
    domain_between_steps(s, values);
}
