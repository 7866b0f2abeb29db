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

/* ---- conditions ---- */

/*
 * A condition f (compared with zero) is rational in its inputs, and linear or quadratic in each, f = a x^2 + b x + c: x becomes the
 * zero of a line, and where the least f of a parabola is. 1: a line's, 2: a parabola's, 0: nothing depends on this input.
 */
static int move_to_edge(const struct operation *o, int condition, struct input *inputs, int i)
{
    VECTOR(fmpq, f, 3); /* at -1, 0 and 1 */
    SCOPE(fmpq, kept, slope, curvature);
    fmpq *x = &inputs[i].value;
    fmpq_set(kept, x);
    for (int k = 0; k < 3; k++) {
        fmpq_set_si(x, k - 1, 1);
        operation_node(f + k, o, inputs, o->formulas->conditions[condition].node);
    }
    fmpq_sub(slope, f + 2, f);          /* 2 b */
    fmpq_add(curvature, f + 2, f);
    fmpq_mul_2exp(f + 1, f + 1, 1);     /* 2 c */
    fmpq_sub(curvature, curvature, f + 1); /* 2 a */
    const int degree = !fmpq_is_zero(curvature) ? 2 : !fmpq_is_zero(slope) ? 1 : 0;
    fmpq_mul_2exp(curvature, curvature, 1);
    fmpq_set(x, kept);
    if (degree > 0) {
        fmpq_div(kept, degree == 1 ? f + 1 : slope, degree == 1 ? slope : curvature);
        fmpq_set_double(x, -fmpq_get_d(kept)); /* a number that can be asked */
    }
    return degree;
}

/* The next number, in whichever of the two directions the condition's being kept is what it is to be. */
static bool nudge(struct operation *o, int i, double *values, struct input *inputs, bool outside)
{
    const struct section *s = o->section;
    const double x = values[i];
    const bool time = strcmp(s->inputs[i]->name, "t") == 0; /* backwards, by a whole step: h is the last of the inputs */
    for (int direction = 0; direction < 2; direction++) {
        const double towards = direction == 0 ? INFINITY : -INFINITY;
        values[i] = x != 0 ? nextafter(x, towards) : copysign(time ? values[s->input_count - 1] : ldexp(1, -100), towards);
        inputs_of_values(s, values, inputs);
        if (operation_valid(o, inputs) != outside)
            return true;
    }
    return false;
}

bool domain_edge(struct operation *o, int condition, bool outside, double *values)
{
    const struct section *s = o->section;
    INPUTS(inputs);
    int moved = 0, degree = 2;
    inputs_of_values(s, values, inputs);
    for (int i = 0; i < s->input_count && degree != 1; i++) {
        const int of_this = move_to_edge(o, condition, inputs, i);
        if (of_this == 0)
            continue;
        degree = of_this;
        moved = i;
        values[i] = fmpq_get_d(&inputs[i].value);
    }
    return operation_valid(o, inputs) != outside || nudge(o, moved, values, inputs, outside);
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
    const int edges = edge_count(o->formulas);
    struct {
        double *at, value;
    } defects[MOST_INPUTS * EXTREMES];
    int count = 0;
    for (int i = 0; i < s->input_count; i++)
        for (int n = 0; n < EXTREMES; n++)
            if (extremes[n].outside && extreme_of(&extremes[n], s->inputs[i])) {
                defects[count].at = &values[i];
                defects[count++].value = extremes[n].value;
            }
    const int which = (int)(k % (uint64_t)(o->formulas->count + count));
    if (which < edges)
        domain_edge(o, which, true, values);
    else if (which < edges + count)
        *defects[which - edges].at = defects[which - edges].value;
    else
        domain_between_steps(s, values);
}
