/*
 * verify/evaluate/errors.h: the bounds on E, compared in fractions with E itself at the corners of the balls, and MPFR inside the ball;
 * a test for every error term of the theorem in errors.c.
 */
#include "tests/run.h"
#include "tests/paper.h"

#include "evaluate/errors.h"
#include "evaluate/sample.h"
#include "text/scope.h"

enum { PREC = 192, CASES = 64 };

/* Numbers between 0 and 1 that fill a double, other ones for another k */
static double scattered(int k)
{
    return fmod(0.6180339887498949 * (k + 1), 1);
}

/* |y - exact| / (u (|exact| + S)) */
static void true_error(fmpq_t E, const fmpq_t y, const fmpq_t exact, const fmpq_t S, int significand)
{
    SCOPE(fmpq, weight);
    fmpq_sub(E, y, exact);
    fmpq_abs(E, E);
    fmpq_abs(weight, exact);
    fmpq_add(weight, weight, S);
    fmpq_div(E, E, weight);
    fmpq_mul_2exp(E, E, (ulong)significand);
}

static void fraction(fmpq_t q, double x)
{
    SCOPE(arf, a);
    arf_set_d(a, x);
    arf_get_fmpq(q, a);
}

/* y and the balls of y* and S: E at the four corners, and at y where the ball of y* holds it, keeps its bounds. */
static void assert_bounded(double y, double exact, double exact_radius, double S, double S_radius, double at_most)
{
    struct error_bounds E;
    SCOPE(arb, e, s);
    SCOPE(arf, at);
    fmpq_t q[3], truth, bound;
    fmpq_init(truth);
    fmpq_init(bound);
    for (int i = 0; i < 3; i++)
        fmpq_init(q[i]);
    arb_set_d(e, exact);
    mag_set_d(arb_radref(e), exact_radius);
    arb_set_d(s, S);
    mag_set_d(arb_radref(s), S_radius);
    arf_set_d(at, y);
    E = error_in_roundings(at, e, s, BINARY64);
    ck_assert(E.lower >= 0 && E.lower <= E.upper);
    for (int corner = 0; corner < 5; corner++) {
        fraction(q[0], y);
        if (corner < 4)
            fraction(q[1], exact + (corner & 1 ? exact_radius : -exact_radius));
        else if (fabs(y - exact) <= exact_radius)
            fraction(q[1], y);
        fraction(q[2], S + (corner & 2 ? S_radius : -S_radius));
        true_error(truth, q[0], q[1], q[2], BINARY64);
        if (isfinite(E.upper)) {
            fraction(bound, E.upper);
            ck_assert_msg(fmpq_cmp(bound, truth) >= 0, "corner %d: E = %.17g above %.17g", corner, fmpq_get_d(truth), E.upper);
        }
        fraction(bound, E.lower);
        ck_assert_msg(fmpq_cmp(bound, truth) <= 0, "corner %d: E = %.17g below %.17g", corner, fmpq_get_d(truth), E.lower);
    }
    ck_assert_double_le(E.upper - E.lower, at_most * E.upper);
    fmpq_clear(truth);
    fmpq_clear(bound);
    for (int i = 0; i < 3; i++)
        fmpq_clear(q[i]);
    flint_cleanup();
}

/* Dyadic radii, so that the corners are numbers of a double. */
EACH(E1_the_distance_is_a_ball, CASES)
{
    assert_bounded(1, 1 + ldexp(1 + floor(16 * scattered(_i)), -20), 0x1p-21, 0.5, 0, 1);
    assert_bounded(1, 1 + 0x1p-22, 0x1p-20, 0.5, 0, 1); /* y may be right: E = 0 too */
}

EACH(E2_the_weight_is_a_ball, CASES)
{
    assert_bounded(2, 1, 0, 0.5 + floor(16 * scattered(_i)), 0.25, 0.5);
    assert_bounded(-1024, 1 + floor(16 * scattered(_i)), 0.5, 0, 0, 0.8);
}

/* Nothing is rounded before the quotient, nor is its bound loose: two numbers next to each other, mostly. */
EACH(E4_the_quotient_is_rounded_outward, CASES)
{
    assert_bounded(1 + scattered(_i), 1, 0, 1 + floor(1024 * scattered(_i + 7)), 0, 0x1p-50);
}

TEST(E3_a_weight_that_may_be_zero_has_no_upper_bound)
{
    SCOPE(arb, exact, S);
    SCOPE(arf, y);
    struct error_bounds E;
    arf_one(y);
    E = error_in_roundings(y, exact, S, BINARY64); /* y* = S = 0 */
    ck_assert(isinf(E.lower) && isinf(E.upper));
    mag_set_d(arb_radref(S), 1);
    E = error_in_roundings(y, exact, S, BINARY64); /* S in [-1, 1] */
    ck_assert(isinf(E.upper) && E.lower == 0);
    arb_set_d(S, 2);
    mag_set_d(arb_radref(exact), 0.5); /* y* in [-1/2, 1/2]: E at least 1/2 of 2^53/2.5 */
    E = error_in_roundings(y, exact, S, BINARY64);
    ck_assert(E.lower <= 0.5 / 2.5 * 0x1p53 && E.upper >= 1.5 / 2 * 0x1p53 && isfinite(E.upper));
    arb_pos_inf(S);
    E = error_in_roundings(y, exact, S, BINARY64);
    ck_assert(isinf(E.lower) && isinf(E.upper));
    arf_nan(y);
    E = error_in_roundings(y, exact, S, BINARY64);
    ck_assert(isinf(E.lower) && isinf(E.upper));
    flint_cleanup();
}

/* eq04 has three outputs: whichever is off by three, five and seven roundings, the worst of them counts, and is named. */
EACH(E5_the_worst_output_counts, 3)
{
    const struct section *s = section_find(sheet(), "eq04");
    arb_ptr y = _arb_vec_init(3), exact = _arb_vec_init(3), S = _arb_vec_init(3);
    int output;
    for (int i = 0; i < 3; i++) {
        arb_one(exact + i);
        arb_set_d(y + i, 1 + (3 + 2 * ((i + _i) % 3)) * 0x1p-53);
    }
    const struct error_bounds E = worst_error(s, NULL, y, exact, S, BINARY64, &output);
    ck_assert_int_eq((output + _i) % 3, 2);
    ck_assert(E.lower <= 8 && E.upper >= 7 && E.upper - E.lower < 1e-9);
    _arb_vec_clear(y, 3);
    _arb_vec_clear(exact, 3);
    _arb_vec_clear(S, 3);
    flint_cleanup();
}

/* Inside for the right ball; and outside for every output alone, moved by a tenth more than the room that MPFR gets. */
EACH(E6_mpfr_is_inside_for_every_output, sheet()->section_count)
{
    enum { INPUTS = 40, OUTPUTS = 16, ROOM = 16 - 2 * PREC };
    const struct section *s = &sheet()->sections[_i];
    if (s->method != METHOD_FORMULA)
        return;
    struct operation o;
    double values[INPUTS];
    struct input *inputs = inputs_new(s->input_count);
    arb_ptr exact = _arb_vec_init(OUTPUTS), S = _arb_vec_init(OUTPUTS);
    SCOPE(arb, moved, kept);
    operation_init(&o, s, false);
    sample(&o, 1, 3, values, inputs);
    operation_sensitivity(&o, inputs, 3 * PREC, S);
    operation_enclose(&o, inputs, 3 * PREC, exact); /* finer than the room */
    ck_assert_msg(mpfr_inside(&o, inputs, exact, S), "%s", s->id);
    for (int i = 0; i < s->output_count; i++) {
        arb_abs(moved, exact + i);
        arb_add(moved, moved, S + i, PREC);
        if (!arb_is_positive(moved))
            continue;
        arb_mul_2exp_si(moved, moved, ROOM);
        arb_mul_ui(moved, moved, 9, PREC);
        arb_mul_2exp_si(moved, moved, -3);
        arb_set(kept, exact + i);
        arb_add(exact + i, exact + i, moved, 3 * PREC);
        ck_assert_msg(!mpfr_inside(&o, inputs, exact, S), "%s, output %d", s->id, i);
        arb_set(exact + i, kept);
    }
    operation_clear(&o);
    inputs_free(inputs, s->input_count);
    _arb_vec_clear(exact, OUTPUTS);
    _arb_vec_clear(S, OUTPUTS);
    flint_cleanup();
}
