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

void comparator_init(struct comparator *j, struct operation *o, int significand, double digits)
{
    *j = (struct comparator){.operation = o, .significand = significand, .K = o->section->K, .digits = digits};
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

/* K u S: what roundings of the inputs may do to an output. */
static void rounding_bound(arb_t bound, const struct comparator *j, int output)
{
    arb_set_d(bound, j->K);
    arb_mul(bound, bound, j->S + output, 64);
    arb_mul_2exp_si(bound, bound, -j->significand);
}

/*
 * Whether roundings of the inputs decide on stability by (42): no margin is negative beyond them, and one is within them.
 * A margin that no rounding moves, S = 0, is what it is.
 */
static bool on_the_boundary(const struct comparator *j)
{
    bool within = false, unstable = false;
    SCOPE(arb, bound, size);
    for (int i = 0; i < 2; i++) {
        rounding_bound(bound, j, i);
        arb_abs(size, j->exact + i);
        const bool beyond = arb_gt(size, bound) || arb_is_zero(j->S + i);
        within = within || !beyond;
        unstable = unstable || (beyond && !arb_is_positive(j->exact + i));
    }
    return within && !unstable;
}

/* On the boundary either verdict on stability is right, and nothing else is. */
static void allow_either(struct comparator *j)
{
    const int stable = j->operation->section->output_count - 1;
    if ((arb_is_zero(j->y + stable) || arb_is_one(j->y + stable)) && on_the_boundary(j))
        arb_set(j->exact + stable, j->y + stable);
}

/* An exact zero that enclosures only shrink around; a pole of a derivative, where S is infinite and excuses nothing. */
static void settle(struct comparator *j, const struct input *inputs, slong prec)
{
    const struct operation *o = j->operation;
    struct machine values;
    SCOPE(fmpq, value);
    operation_exact(&values, o, inputs);
    for (int i = 0; i < o->section->output_count; i++) {
        if (exact_is_rational(value, machine_value(&values, o->formulas->outputs[i])))
            arb_set_fmpq(j->exact + i, value, prec);
        operation_sensitivity_exact(j->operation, inputs, prec, i, j->S + i, value);
        if (!arb_is_finite(j->S + i))
            arb_zero(j->S + i);
    }
    machine_clear(&values);
}

/* ---- components of a vector ---- */

/* A name without what tells a component from the others: the first of xyz, or a last digit of 123 that is no second index. */
static bool stem_of(const char *name, char stem[40])
{
    const size_t length = strlen(name);
    const bool letter = strchr("xyz", name[0]) != NULL;
    const bool digit = strchr("123", name[length - 1]) != NULL && strchr("123", name[length - 2]) == NULL; /* no name is a digit */
    snprintf(stem, 40, "%s%.*s", letter ? "r" : "", (int)length - (letter ? 1 : digit), name + letter);
    return letter || digit;
}

uint64_t vector_components(const struct quantity *const *all, int count, int which)
{
    char stem[40], other[40];
    uint64_t components = 0;
    int found = 0;
    for (int i = 0; i < count && stem_of(all[which]->name, stem); i++)
        if (stem_of(all[i]->name, other) && strcmp(other, stem) == 0 && strcmp(all[i]->unit, all[which]->unit) == 0) {
            components |= UINT64_C(1) << i;
            found++;
        }
    return found == 3 ? components : 0;
}

/* What roundings of the inputs do where a component of a vector is as large as the vector, which a turn of the axes makes it. */
static void turned_sensitivity(arb_ptr S, struct operation *o, slong prec)
{
    const struct section *s = o->section;
    VECTOR(arb, sizes, MOST_INPUTS);
    SCOPE(arb, size);
    for (int i = 0; i < s->input_count; i++) {
        const uint64_t components = vector_components(s->inputs, s->input_count, i) | UINT64_C(1) << i;
        for (int k = 0; k < s->input_count; k++) {
            arb_abs(size, machine_value(&o->machine, k));
            if (components & UINT64_C(1) << k)
                arb_max(sizes + i, sizes + i, size, prec);
        }
    }
    formula_sensitivity(o, prec, sizes, S);
}

/*
 * A component's S is at least the largest |y*| + S among the vector's: any turn of the axes makes such an error, and where
 * a component is zero or far smaller than the vector it is the axes that make it so. S is the turned inputs' there: r x (I r) of
 * a craft near one plane of the axes has the roundings of its other coordinates.
 */
static void raise_to_the_vector(struct comparator *j, slong prec)
{
    const struct section *s = j->operation->section;
    VECTOR(arb, turned, MOST_OUTPUTS);
    SCOPE(arb, size);
    if (vector_components(s->outputs, s->output_count, 0) == 0)
        return;
    turned_sensitivity(turned, j->operation, prec);
    for (int i = 0; i < s->output_count; i++) {
        const uint64_t components = vector_components(s->outputs, s->output_count, i);
        for (int k = 0; k < s->output_count; k++) {
            arb_abs(size, j->exact + k);
            arb_add(size, size, turned + k, 64);
            if ((components & UINT64_C(1) << k) && arb_is_finite(size))
                arb_max(j->S + i, j->S + i, size, 64);
        }
    }
}

static struct error_bounds error_of(struct comparator *j, const struct input *inputs, slong prec, struct score *score)
{
    const struct section *s = j->operation->section;
    score->strict = worst_error(s, inputs, j->y, j->exact, j->S, j->significand, &score->output).upper;
    if (s->method == METHOD_FORMULA)
        raise_to_the_vector(j, prec);
    const struct error_bounds E = worst_error(s, inputs, j->y, j->exact, j->S, j->significand, &score->output);
    score->E = E.upper;
    return E;
}

enum outcome outcome_of_bounds(struct error_bounds E, double K)
{
    return E.upper <= K ? OUTCOME_RIGHT : E.lower > K ? OUTCOME_WRONG : OUTCOME_SKIPPED;
}

/* |y - y*| 2^significand against K (|y*| + S) in rational numbers: E = K passes, and no enclosure sees that it does. */
static enum outcome compare_output_exactly(struct comparator *j, const struct input *inputs, const fmpq_t exact, int output)
{
    SCOPE(fmpq, S, off, allowed);
    SCOPE(arb, enclosed);
    enum outcome outcome = OUTCOME_SKIPPED;
    if (operation_sensitivity_exact(j->operation, inputs, 64, output, enclosed, S)) {
        arf_get_fmpq(off, arb_midref(j->y + output));
        fmpq_sub(off, off, exact);
        fmpq_abs(off, off);
        fmpq_mul_2exp(off, off, (ulong)j->significand);
        fmpq_abs(allowed, exact);
        fmpq_add(allowed, allowed, S);
        fmpq_set_double(S, j->K);
        fmpq_mul(allowed, allowed, S);
        outcome = fmpq_cmp(off, allowed) <= 0 ? OUTCOME_RIGHT : OUTCOME_WRONG;
    }
    return outcome;
}

/* Outputs that enclosures leave undecided, one by one. */
static enum outcome compare_outputs_exactly(struct comparator *j, const struct input *inputs, struct score *score)
{
    const struct operation *o = j->operation;
    enum outcome all = OUTCOME_RIGHT;
    struct machine exact;
    SCOPE(fmpq, truth);
    operation_exact(&exact, o, inputs);
    for (int i = 0; i < o->section->output_count && all != OUTCOME_WRONG; i++) {
        enum outcome one = outcome_of_bounds(
            error_in_roundings(arb_midref(j->y + i), j->exact + i, j->S + i, j->significand), j->K);
        if (one == OUTCOME_SKIPPED && vector_components(o->section->outputs, o->section->output_count, i) == 0 &&
            exact_is_rational(truth, machine_value(&exact, o->formulas->outputs[i])))
            one = compare_output_exactly(j, inputs, truth, i);
        all = one == OUTCOME_RIGHT ? all : one;
    }
    machine_clear(&exact);
    if (all == OUTCOME_RIGHT)
        score->E = j->K;
    return all;
}

static enum outcome compare_in_roundings(struct comparator *j, const struct input *inputs, struct score *score)
{
    const struct section *s = j->operation->section;
    const bool compares_stability = strcmp(s->outputs[s->output_count - 1]->name, "stable") == 0;
    const slong most = 16384;
    enum outcome outcome = OUTCOME_SKIPPED;
    for (slong prec = 2 * j->significand > 128 ? 320 : 128; prec <= most && outcome == OUTCOME_SKIPPED; prec *= 4) {
        operation_enclose(j->operation, inputs, prec, j->exact);
        _arb_vec_zero(j->S, s->output_count);
        score->strict = score->E = worst_error(s, inputs, j->y, j->exact, j->S, j->significand, &score->output).upper;
        if (score->E <= fmin(j->K, j->worst))
            return OUTCOME_RIGHT; /* without S already, and no new worst */
        operation_sensitivity(j->operation, inputs, prec, j->S);
        if (4 * prec > most && s->method == METHOD_FORMULA)
            settle(j, inputs, prec);
        if (compares_stability)
            allow_either(j);
        outcome = outcome_of_bounds(error_of(j, inputs, prec, score), j->K);
    }
    return outcome == OUTCOME_SKIPPED && s->method == METHOD_FORMULA ? compare_outputs_exactly(j, inputs, score) : outcome;
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
    const bool linear = s->method == METHOD_FLOW_LINEAR || s->method == METHOD_RK4_LINEAR;
    const double Omega = fmpq_get_d(&inputs[input_place(s, "Omega")].value);
    const double L_ref = fmpq_get_d(&inputs[input_place(s, "L_ref")].value);
    const struct input *initial = inputs + input_place(s, "t") + 1;
    double scale = 0.0, off = 0.0, off_at_least = 0.0, wide = 0.0;
    SCOPE(arb, difference);
    SCOPE(mag, bound);
    for (int i = 0; i < s->output_count; i++) {
        const double unit = (linear && i % 3 != 2 ? 1.0 : 1.0 / L_ref) / (i < 3 ? 1.0 : Omega);
        arb_sub(difference, j->y + i, j->exact + i, 256);
        scale = fmax(scale, unit * fmax(fabs(fmpq_get_d(&initial[i].value)), fabs(midpoint(j->exact + i))));
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
    const slong digits = (slong)j->digits + 8; /* enough to see a client do better than it says */
    const slong first = operation_precision(j->operation, inputs, digits);
    double lost = INFINITY, most_digits = INFINITY;
    if (j->followed)
        digits_reached(j, inputs, &score->digits, &most_digits, &lost);
    const slong most = j->once ? first : 8 * first;
    for (slong prec = first; prec <= most && !(lost <= pow(10.0, -j->digits - 5.0)); prec *= 2)
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
    enum outcome outcome = compare_in_roundings(j, inputs, score);
    j->worst = fmax(j->worst, outcome == OUTCOME_RIGHT ? score->E : 0.0);
    return outcome;
}
