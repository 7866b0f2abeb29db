#include "conform/comparator.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "evaluate/sample.h"
#include "formula/exact.h"
#include "text/scope.h"

const char *const outcome_names[OUTCOMES] = {
    "right", "skipped", "wrong", "NaN", "infinite", "invalid where a value is due", "a value where invalid is due", "wrong count",
    "malformed", "truncated", "missing", "time-out", "crash", "no vector's name", "wrong id", "repeated or out of order", "early",
    "too long"};

bool is_motion(const struct section *s)
{
    return s->method != METHOD_NONE && !operation_has_sensitivity(s);
}

void input_values(const struct section *s, const struct input *inputs, double *values)
{
    for (int i = 0; i < s->input_count; i++)
        values[i] = inputs[i].infinite ? INFINITY : fmpq_get_d(&inputs[i].value);
}

double motion_unit(const struct section *s, const double *inputs, int coordinate)
{
    const bool linear = s->method == METHOD_FLOW_LINEAR || s->method == METHOD_RK4_LINEAR;
    const double length = linear && coordinate % 3 < 2 ? 1.0 : inputs[input_place(s, "L_ref")];
    return length * (coordinate < 3 ? 1.0 : inputs[input_place(s, "Omega")]);
}

void match_roots(const double due[8], const double roots[8], int order[4])
{
    for (int k = 0; k < 4; k++)
        order[k] = k;
    for (int k = 0; k < 4; k++) {
        int best = k;
        double least = INFINITY;
        for (int i = k; i < 4; i++) {
            const double off = hypot(roots[2 * order[i]] - due[2 * k], roots[2 * order[i] + 1] - due[2 * k + 1]);
            best = off < least ? i : best;
            least = fmin(least, off);
        }
        const int root = order[best];
        order[best] = order[k];
        order[k] = root;
    }
}

void comparator_init(struct comparator *j, struct operation *o, int significand, double digits)
{
    *j = (struct comparator){.operation = o, .significand = significand, .K = o->section->K, .digits = digits,
                             .bits = 2 * significand > 128 ? 320 : 128};
    j->y = _arb_vec_init(MOST_OUTPUTS);
    j->exact = _arb_vec_init(MOST_OUTPUTS);
    j->S = _arb_vec_init(MOST_OUTPUTS);
}

void comparator_clear(struct comparator *j)
{
    _arb_vec_clear(j->y, MOST_OUTPUTS);
    _arb_vec_clear(j->exact, MOST_OUTPUTS);
    _arb_vec_clear(j->S, MOST_OUTPUTS);
}

/* ---- algebra and roots ---- */

/*
 * Whether roundings of the inputs decide on stability by (42): no margin is at or below zero beyond K u S, and one is within it. A
 * margin that no rounding moves, S = 0, is what it is. Omega^2 has 106 bits: where it is near C1/9 all these numbers are exact,
 * elsewhere their balls are far from equal.
 */
static bool on_the_boundary(const struct comparator *j, const struct input *inputs)
{
    enum { BITS = 256 };
    bool within = false, unstable = false;
    VECTOR(arb, margins, MOST_OUTPUTS);
    VECTOR(arb, S, MOST_OUTPUTS);
    SCOPE(arb, size, bound);
    operation_enclose(j->operation, inputs, BITS, margins);
    formula_sensitivity(j->operation, BITS, NULL, S);
    for (int i = 0; i < 2; i++) {
        arb_set_d(bound, ldexp(j->K, -j->significand));
        arb_mul(bound, bound, S + i, BITS);
        arb_abs(size, margins + i);
        const bool beyond = arb_gt(size, bound) || arb_is_zero(S + i);
        within = within || !beyond;
        unstable = unstable || (beyond && !arb_is_positive(margins + i));
    }
    return within && !unstable;
}

/* On the boundary either verdict on stability is right, and nothing else is. */
static void allow_either(struct comparator *j, const struct input *inputs)
{
    const int stable = j->operation->section->output_count - 1;
    if ((arb_is_zero(j->y + stable) || arb_is_one(j->y + stable)) && on_the_boundary(j, inputs))
        arb_set(j->exact + stable, j->y + stable);
}

/* An exact zero that enclosures only shrink around; a pole of a derivative, where S is infinite and excuses nothing. */
static void settle(struct comparator *j, const struct input *inputs, slong prec)
{
    const struct operation *o = j->operation;
    OWNED(machine) values;
    operation_exact(&values, o, inputs);
    for (int i = 0; i < o->section->output_count; i++) {
        if (exact_is_zero(machine_value(&values, o->formulas->outputs[i])))
            arb_zero(j->exact + i);
        operation_sensitivity_exact(j->operation, inputs, prec, i, j->S + i);
        if (!arb_is_finite(j->S + i))
            arb_zero(j->S + i);
    }
}

/* ---- components of a vector ---- */

/* Of one unit, the names alike but for x, y, z at the front or 1, 2, 3 at the end, where that is no second index. */
static bool are_components(const struct quantity *const three[3])
{
    const char *name = three[0]->name;
    const size_t last = strlen(name) - 1, at = *name == 'x' ? 0 : last;
    bool alike = at == 0 || (name[last] == '1' && strchr("123", name[last - 1]) == NULL);
    for (int k = 1; k < 3; k++)
        alike = alike && strncmp(three[k]->name, name, at) == 0 && three[k]->name[at] == name[at] + k &&
                strcmp(three[k]->name + at + 1, name + at + 1) == 0 && strcmp(three[k]->unit, three[0]->unit) == 0;
    return alike;
}

int vector_of(const struct quantity *const *all, int count, int which)
{
    for (int first = which < 2 ? 0 : which - 2; first <= which && first + 3 <= count; first++)
        if (are_components(all + first))
            return first;
    return -1;
}

/* A component's size is at least each of the three values. */
static void raise_to_vectors(arb_ptr sizes, arb_srcptr values, const struct quantity *const *all, int count)
{
    for (int i = 0; i < count; i++)
        for (int first = vector_of(all, count, i), k = first; first >= 0 && k < first + 3; k++)
            arb_max(sizes + i, sizes + i, values + k, 64);
}

/*
 * A component's S is at least the largest |y*| + S among the vector's: any turn of the axes makes such an error, and where
 * a component is zero or far smaller than the vector it is the axes that make it so. S is that of inputs which are as large as
 * their vectors there: r x (I r) of a craft near one plane of the axes has the roundings of its other coordinates.
 */
static void raise_sensitivity(struct comparator *j, slong prec)
{
    struct operation *o = j->operation;
    const struct section *s = o->section;
    VECTOR(arb, values, MOST_INPUTS);
    VECTOR(arb, sizes, MOST_INPUTS);
    VECTOR(arb, turned, MOST_OUTPUTS);
    SCOPE(arb, size);
    for (int i = 0; i < s->input_count; i++)
        arb_abs(values + i, machine_value(&o->machine, i));
    _arb_vec_set(sizes, values, s->input_count);
    raise_to_vectors(sizes, values, s->inputs, s->input_count);
    formula_sensitivity(o, prec, sizes, turned);
    for (int k = 0; k < s->output_count; k++) {
        arb_abs(size, j->exact + k);
        arb_add(turned + k, turned + k, size, 64);
    }
    raise_to_vectors(j->S, turned, s->outputs, s->output_count);
}

enum outcome outcome_of_bounds(struct error_bounds E, double K)
{
    return E.upper <= K ? OUTCOME_RIGHT : E.lower > K ? OUTCOME_WRONG : OUTCOME_SKIPPED;
}

static struct error_bounds error_of(const struct comparator *j, const struct input *inputs, int *output)
{
    return worst_error(j->operation->section, inputs, j->y, j->exact, j->S, j->significand, output);
}

static enum outcome compare_in_roundings(struct comparator *j, const struct input *inputs, struct score *score)
{
    const struct section *s = j->operation->section;
    const bool compares_stability = strcmp(s->outputs[s->output_count - 1]->name, "stable") == 0;
    const slong most = 16384;
    enum outcome outcome = OUTCOME_SKIPPED;
    for (slong prec = j->bits; prec <= most && outcome == OUTCOME_SKIPPED; prec *= 4) {
        operation_enclose(j->operation, inputs, prec, j->exact);
        operation_sensitivity(j->operation, inputs, prec, j->S);
        if (4 * prec > most && s->method == METHOD_FORMULA)
            settle(j, inputs, prec);
        if (compares_stability)
            allow_either(j, inputs);
        score->strict = error_of(j, inputs, &score->output).upper;
        if (s->method == METHOD_FORMULA)
            raise_sensitivity(j, prec);
        const struct error_bounds E = error_of(j, inputs, &score->output);
        score->E = E.upper;
        outcome = outcome_of_bounds(E, j->K);
    }
    return outcome;
}

/* ---- motions ---- */

static double midpoint(const arb_t x)
{
    return arf_get_d(arb_midref(x), ARF_RND_NEAR);
}

/* Bounds on the digits of the largest coordinate that are right; `lost` gets what the truth's enclosures are wide, on its scale. */
static void digits_reached(const struct comparator *j, const struct input *inputs, double *least, double *most, double *lost)
{
    const struct section *s = j->operation->section;
    const int initial = input_place(s, "t") + 1;
    double x[MOST_INPUTS], scale = 0.0, off = 0.0, off_at_least = 0.0, wide = 0.0;
    SCOPE(arb, difference);
    SCOPE(mag, bound);
    input_values(s, inputs, x);
    for (int i = 0; i < s->output_count; i++) {
        const double unit = 1.0 / motion_unit(s, x, i);
        arb_sub(difference, j->y + i, j->exact + i, 256);
        scale = fmax(scale, unit * fmax(fabs(x[initial + i]), fabs(midpoint(j->exact + i))));
        arb_get_mag(bound, difference);
        off = fmax(off, unit * mag_get_d(bound));
        arb_get_mag_lower(bound, difference);
        off_at_least = fmax(off_at_least, unit * mag_get_d(bound));
        wide = fmax(wide, unit * mag_get_d(arb_radref(j->exact + i))); /* whatever the answer is: more bits make no other */
    }
    *lost = scale > 0.0 ? wide / scale : wide;
    *least = off == 0.0 ? INFINITY : -log10(off / scale);
    *most = off_at_least == 0.0 ? INFINITY : -log10(off_at_least / scale);
}

static enum outcome compare_in_digits(struct comparator *j, const struct input *inputs, struct score *score)
{
    const slong digits = (slong)j->digits + 5; /* enough to see a client do better than it says */
    const slong first = operation_precision(j->operation, inputs, digits);
    double lost = INFINITY, most_digits = INFINITY;
    if (j->followed)
        digits_reached(j, inputs, &score->digits, &most_digits, &lost);
    const slong most = j->once ? first : 8 * first;
    for (slong prec = first; prec <= most && !(lost <= pow(10.0, -(double)digits)); prec *= 2)
        if (operation_follow(j->operation, inputs, digits, prec, j->exact) == OPERATION_PROVED)
            digits_reached(j, inputs, &score->digits, &most_digits, &lost);
    if (isinf(lost))
        return OUTCOME_SKIPPED;
    return score->digits >= j->digits ? OUTCOME_RIGHT : most_digits < j->digits ? OUTCOME_WRONG : OUTCOME_SKIPPED;
}

enum outcome compare_answer(struct comparator *j, const struct input *inputs, struct score *score)
{
    *score = (struct score){.E = 0.0, .digits = INFINITY};
    if (is_motion(j->operation->section))
        return compare_in_digits(j, inputs, score);
    return compare_in_roundings(j, inputs, score);
}
