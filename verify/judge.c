#include "judge.h"

#include <math.h>
#include <string.h>

#include "exact.h"

const char *const finding_names[FINDINGS] = {
    "right",     "skipped",       "wrong",     "NaN",     "infinite",  "invalid where a value is due",
    "a value where invalid is due", "wrong count", "malformed", "truncated", "too long", "wrong id",
    "repeated",  "reordered",     "early",     "missing", "extra line", "too many lines out of place",
    "time-out",  "crash",         "exit status"};

bool is_motion(const struct section *s)
{
    return s->method != METHOD_NONE && !operation_has_sensitivity(s);
}

void judge_init(struct judge *j, struct operation *o, int significand, double digits)
{
    *j = (struct judge){.operation = o, .significand = significand, .K = o->section->K, .digits = digits};
    j->y = _arb_vec_init(MOST_ANSWERS);
    j->exact = _arb_vec_init(MOST_ANSWERS);
    j->S = _arb_vec_init(MOST_ANSWERS);
}

void judge_clear(struct judge *j)
{
    _arb_vec_clear(j->y, MOST_ANSWERS);
    _arb_vec_clear(j->exact, MOST_ANSWERS);
    _arb_vec_clear(j->S, MOST_ANSWERS);
}

/* ---- algebra and roots ---- */

/*
 * Whether a margin of (42) is within what roundings of the inputs may do to it: then either verdict on
 * stability is right.
 */
static bool on_the_boundary(const struct judge *j)
{
    bool on = false;
    arb_t reach, margin;
    arb_init(reach);
    arb_init(margin);
    for (int i = 0; i < 2; i++) {
        arb_set_d(reach, j->K);
        arb_mul(reach, reach, j->S + i, 64);
        arb_mul_2exp_si(reach, reach, -j->significand);
        arb_abs(margin, j->exact + i);
        on = on || !arb_gt(margin, reach);
    }
    arb_clear(reach);
    arb_clear(margin);
    return on;
}

/* An exact zero that enclosures only shrink around; a pole of a derivative, where S is infinite and excuses nothing. */
static void settle(struct judge *j, const struct input *inputs, slong prec)
{
    const struct operation *o = j->operation;
    struct machine values;
    fmpq_t value;
    operation_exact(&values, o, inputs);
    fmpq_init(value);
    for (int i = 0; i < o->section->output_count; i++) {
        if (exact_is_rational(value, machine_value(&values, o->formulas->outputs[i])))
            arb_set_fmpq(j->exact + i, value, prec);
        operation_sensitivity_settled(j->operation, inputs, prec, i, j->S + i);
        if (!arb_is_finite(j->S + i))
            arb_zero(j->S + i);
    }
    fmpq_clear(value);
    machine_clear(&values);
}

static struct bounds error_of(struct judge *j, const struct input *inputs, struct score *score)
{
    const struct section *s = j->operation->section;
    const struct bounds E = worst_error(s, inputs, j->y, j->exact, j->S, j->significand, &score->output);
    score->E = E.upper;
    return E;
}

static enum finding judge_in_roundings(struct judge *j, const struct input *inputs, struct score *score)
{
    const struct section *s = j->operation->section;
    const slong most = 16384;
    struct bounds E = {0.0, INFINITY};
    for (slong prec = 2 * j->significand > 128 ? 320 : 128; prec <= most; prec *= 4) {
        operation_enclose(j->operation, inputs, prec, j->exact);
        _arb_vec_zero(j->S, s->output_count);
        if (s->method == METHOD_FORMULA && error_of(j, inputs, score).upper <= fmin(j->K, j->worst))
            return FOUND_RIGHT; /* without S already, and no new worst */
        operation_sensitivity(j->operation, inputs, prec, j->S);
        if (4 * prec > most && s->method == METHOD_FORMULA)
            settle(j, inputs, prec);
        if (strcmp(s->outputs[s->output_count - 1]->name, "stable") == 0 && on_the_boundary(j))
            arb_set(j->exact + s->output_count - 1, j->y + s->output_count - 1);
        E = error_of(j, inputs, score);
        if (E.upper <= j->K || E.lower > j->K)
            break;
    }
    return E.upper <= j->K ? FOUND_RIGHT : FOUND_WRONG;
}

/* ---- motions ---- */

static double midpoint(const arb_t x)
{
    return arf_get_d(arb_midref(x), ARF_RND_NEAR);
}

static int place_of(const struct section *s, const char *name)
{
    int i = 0;
    while (i < s->input_count && strcmp(s->inputs[i]->name, name) != 0)
        i++;
    return i;
}

/* Digits of the largest coordinate; `lost` gets what the enclosures are wide, on the same scale. */
static double digits_reached(const struct judge *j, const struct input *inputs, double *lost)
{
    const struct section *s = j->operation->section;
    const bool linear = s->method == METHOD_FLOW_LINEAR || s->method == METHOD_RK4_LINEAR;
    const double Omega = fmpq_get_d(&inputs[place_of(s, "Omega")].value);
    const double L_ref = fmpq_get_d(&inputs[place_of(s, "L_ref")].value);
    const struct input *initial = inputs + place_of(s, "t") + 1;
    double scale = 0.0, off = 0.0, wide = 0.0;
    for (int i = 0; i < s->output_count; i++) {
        const double unit = (linear && i % 3 != 2 ? 1.0 : 1.0 / L_ref) / (i < 3 ? 1.0 : Omega);
        arb_t difference;
        arb_init(difference);
        arb_sub(difference, j->y + i, j->exact + i, 256);
        scale = fmax(scale, unit * fmax(fabs(fmpq_get_d(&initial[i].value)), fabs(midpoint(j->exact + i))));
        off = fmax(off, unit * fabs(midpoint(difference)));
        wide = fmax(wide, unit * mag_get_d(arb_radref(difference)));
        arb_clear(difference);
    }
    *lost = scale > 0.0 ? wide / scale : wide;
    return off + wide == 0.0 ? INFINITY : scale > 0.0 ? -log10((off + wide) / scale) : 0.0;
}

static enum finding judge_in_digits(struct judge *j, const struct input *inputs, struct score *score)
{
    const slong digits = (slong)j->digits + 8; /* enough to see a client do better than it says */
    const slong first = operation_precision(j->operation, inputs, digits);
    double lost = INFINITY;
    if (j->followed)
        score->digits = digits_reached(j, inputs, &lost);
    for (slong prec = first; prec <= 8 * first && !(lost <= pow(10.0, -j->digits - 5.0)); prec *= 2)
        if (operation_follow(j->operation, inputs, digits, prec, j->exact) == OUTCOME_PROVED)
            score->digits = digits_reached(j, inputs, &lost);
    if (isinf(lost))
        return FOUND_SKIPPED;
    return score->digits >= j->digits ? FOUND_RIGHT : FOUND_WRONG;
}

enum finding judge_answer(struct judge *j, const struct input *inputs, struct score *score)
{
    *score = (struct score){.E = 0.0, .digits = INFINITY};
    if (is_motion(j->operation->section))
        return judge_in_digits(j, inputs, score);
    enum finding finding = judge_in_roundings(j, inputs, score);
    j->worst = fmax(j->worst, finding == FOUND_RIGHT ? score->E : 0.0);
    return finding;
}
