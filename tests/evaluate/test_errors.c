/*
 * verify/evaluate/errors.h: the bounds on E, compared in fractions with E itself at the corners of the balls, and MPFR inside the ball;
 * a test for every error term of the theorem in errors.c.
 */
#include "tests/run.h"
#include "tests/paper.h"

#include <string.h>

#include "evaluate/domain.h"
#include "evaluate/errors.h"
#include "evaluate/reference.h"
#include "evaluate/sample.h"
#include "text/scope.h"

enum { PREC = 192, CASES = 64 };

CASE(all, NULL, flint_cleanup)

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

/* y and the balls of y* and S: E at the four corners, and at y where the ball of y* holds it, keeps its bounds. */
static void assert_bounded(double y, double exact, double exact_radius, double S, double S_radius, double at_most)
{
    SCOPE(arb, e, s);
    SCOPE(arf, at);
    SCOPE(fmpq, given, value, sensitivity, truth, bound);
    arb_set_d(e, exact);
    mag_set_d(arb_radref(e), exact_radius);
    arb_set_d(s, S);
    mag_set_d(arb_radref(s), S_radius);
    arf_set_d(at, y);
    const struct error_bounds E = error_in_roundings(at, e, s, BINARY64);
    ck_assert(E.lower >= 0 && E.lower <= E.upper);
    fmpq_set_double(given, y);
    for (int corner = 0; corner < 5; corner++) {
        if (corner < 4)
            fmpq_set_double(value, exact + (corner & 1 ? exact_radius : -exact_radius));
        else if (fabs(y - exact) <= exact_radius)
            fmpq_set(value, given);
        fmpq_set_double(sensitivity, S + (corner & 2 ? S_radius : -S_radius));
        true_error(truth, given, value, sensitivity, BINARY64);
        if (isfinite(E.upper)) {
            fmpq_set_double(bound, E.upper);
            ck_assert_msg(fmpq_cmp(bound, truth) >= 0, "corner %d: E = %.17g above %.17g", corner, fmpq_get_d(truth), E.upper);
        }
        fmpq_set_double(bound, E.lower);
        ck_assert_msg(fmpq_cmp(bound, truth) <= 0, "corner %d: E = %.17g below %.17g", corner, fmpq_get_d(truth), E.lower);
    }
    ck_assert_double_le(E.upper - E.lower, at_most * E.upper);
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
    for (int no_number = 0; no_number < 3; no_number++) {
        arf_nan(y);
        if (no_number > 0)
            (no_number == 1 ? arf_pos_inf : arf_neg_inf)(y);
        E = error_in_roundings(y, exact, S, BINARY64);
        ck_assert(isinf(E.lower) && isinf(E.upper));
    }
    arf_one(y);
    arb_pos_inf(S);
    E = error_in_roundings(y, exact, S, BINARY64);
    ck_assert(isinf(E.lower) && isinf(E.upper));
    arb_add_si(exact, exact, 1, PREC); /* y* in [1/2, 3/2] may be y, where E is 0 whatever S */
    E = error_in_roundings(y, exact, S, BINARY64);
    ck_assert(isinf(E.upper) && E.lower == 0);
}

/* eq04 has three outputs: whichever is off by eight, ten and twelve roundings, the worst of them counts, and is named; of equals the first. */
EACH(E5_the_worst_output_counts, 4)
{
    const struct section *s = section_find(sheet(), "eq04");
    VECTOR(arb, y, 3);
    VECTOR(arb, exact, 3);
    VECTOR(arb, S, 3);
    int output;
    for (int i = 0; i < 3; i++) {
        arb_one(exact + i);
        mag_set_d(arb_radref(exact + i), 0x1p-53); /* a rounding each way */
        arb_set_d(y + i, 1 + (_i < 3 ? 8 + 2 * ((i + _i) % 3) : 12) * 0x1p-53);
    }
    const struct error_bounds E = worst_error(s, NULL, y, exact, S, BINARY64, &output);
    ck_assert_int_eq(output, _i < 3 ? 2 - _i : 0);
    ck_assert_msg(E.lower <= 11 && E.lower > 10.99 && E.upper >= 13 && E.upper < 13.01, "%.17g to %.17g", E.lower, E.upper);
}

/* Inside for the right ball; and outside for every output alone, moved by a tenth more than the room that MPFR gets. */
EACH(E6_mpfr_is_inside_for_every_output, sheet()->section_count)
{
    enum { INPUTS = 40, OUTPUTS = 16, ROOM = 16 - 2 * PREC };
    const struct section *s = &sheet()->sections[_i];
    if (s->method != METHOD_FORMULA)
        return;
    double values[INPUTS];
    INPUTS(inputs);
    VECTOR(arb, exact, OUTPUTS);
    VECTOR(arb, S, OUTPUTS);
    SCOPE(arb, moved, kept);
    OPERATION(o, s);
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
}

/* Where MPFR has no numbers so large all that (7) divides is infinite, and its value NaN: outside, of each input. */
TEST(E6_every_input_counts)
{
    const mpfr_exp_t most = mpfr_get_emax();
    struct measured m;
    mpfr_set_emax(-1000);
    measure_errors(&m, section_find(sheet(), "eq07"), 5, 1);
    mpfr_set_emax(most);
    ck_assert_int_eq(m.outside, 5);
}

/* (15) where (7) holds the craft at rest: of what is left S is 2^50 times, and so are MPFR's roundings. Inside, for S is in the room. */
TEST(E6_the_room_of_mpfr_has_S)
{
    const struct section *s = section_find(sheet(), "eq15");
    double values[] = {1, 1, 1, 2, 0.7, 0, 0}; /* Omega k_c m1 m2 L psi_dot Q */
    INPUTS(inputs);
    SCOPE(arb, exact, S);
    OPERATION(o, s);
    reference_find("eq07")(values, values + 6);
    ck_assert(inputs_of_values(s, values, inputs));
    operation_sensitivity(&o, inputs, 3 * PREC, S);
    operation_enclose(&o, inputs, 3 * PREC, exact);
    ck_assert(fabs(arf_get_d(arb_midref(exact), ARF_RND_NEAR)) * 0x1p50 < arf_get_d(arb_midref(S), ARF_RND_NEAR));
    ck_assert(mpfr_inside(&o, inputs, exact, S));
}

/* ---- roots ---- */

/* (41) with Omega = 1: (lambda + 1)^2 (lambda^2 + 3/2 lambda + 9/2), by hand; and four simple ones, two of them real: C1 = 8, C2 = 1. */
enum { DOUBLE, SIMPLE };
static const double coefficients[][3] = {{1, 10.5, 3.5}, {1, 8, 1}};

/* E of four answers, parts by turns, to the roots of a quartic, of which each ball has that radius. */
static struct error_bounds error_of_roots(int quartic, const double *y, double radius, double S)
{
    const struct section *s = section_find(sheet(), "eq41roots");
    INPUTS(inputs);
    VECTOR(arb, exact, 8);
    VECTOR(arb, sizes, 8);
    VECTOR(arb, answers, 8);
    int output;
    OPERATION(o, s);
    ck_assert(inputs_of_values(s, coefficients[quartic], inputs));
    operation_enclose(&o, inputs, PREC, exact);
    for (int i = 0; i < 8; i++) {
        arb_set_d(answers + i, y[i]);
        arb_set_d(sizes + i, S);
        if (radius > 0) {
            arb_set_d(exact + i, arf_get_d(arb_midref(exact + i), ARF_RND_NEAR));
            mag_set_d(arb_radref(exact + i), radius);
        }
    }
    const struct error_bounds E = worst_error(s, inputs, answers, exact, sizes, BINARY64, &output);
    return E;
}

static void nearest_roots(int quartic, double *y)
{
    const double at = sqrt(63) / 4; /* of (9/2 - 9/16)^(1/2) */
    const double twice[] = {-1, 0, -1, 0, -0.75, -at, -0.75, at};
    double in[3];
    memcpy(in, coefficients[quartic], sizeof in);
    if (quartic == SIMPLE)
        reference_find("eq41roots")(in, y);
    else
        memcpy(y, twice, sizeof twice);
}

/* One answer moved by a known way d: E = d / (u (|z| + S)), whichever place the others take. */
EACH(E5_the_distance_of_a_simple_root_is_that_in_the_plane, 24)
{
    static const double moves[][2] = {{0x1p-20, 0}, {0, 0x1p-20}, {0x1.8p-20, -0x1p-19}};
    static const int orders[][4] = {{0, 1, 2, 3}, {3, 2, 1, 0}};
    const double *move = moves[_i % 3];
    const int which = _i / 3 % 4, *order = orders[_i / 12];
    double y[8], z[8];
    nearest_roots(SIMPLE, z);
    const double *root = z + 2 * which, due = hypot(move[0], move[1]) * 0x1p53 / (hypot(root[0], root[1]) + 0.25);
    for (int k = 0; k < 4; k++) {
        const int from = order[k];
        y[2 * k] = z[2 * from] + (from == which ? move[0] : 0);
        y[2 * k + 1] = z[2 * from + 1] + (from == which ? move[1] : 0);
    }
    struct error_bounds E = error_of_roots(SIMPLE, y, 0, 0.25);
    ck_assert_msg(fabs(E.upper / due - 1) < 1e-6 && fabs(E.lower / due - 1) < 1e-6, "%.17g to %.17g, expected %.17g", E.lower, E.upper, due);
}

/* The same of balls: E at their corners, where a moved answer lies inwards or outwards of its root by a quarter of its modulus. */
EACH(E1_and_E2_a_root_is_a_ball, 8)
{
    const double radius = 0x1p-6, S = 0.25, by = _i < 4 ? 1.25 : 0.75;
    double y[8], z[8];
    nearest_roots(SIMPLE, z);
    memcpy(y, z, sizeof y);
    double *answer = y + 2 * (_i % 4), *root = z + 2 * (_i % 4);
    answer[0] *= by;
    answer[1] *= by;
    const struct error_bounds E = error_of_roots(SIMPLE, y, radius, S);
    for (int corner = 0; corner < 4; corner++) {
        const double re = root[0] + (corner & 1 ? radius : -radius), im = root[1] + (corner & 2 ? radius : -radius);
        const double due = hypot(answer[0] - re, answer[1] - im) / (hypot(re, im) + S) * 0x1p53;
        ck_assert_msg(E.lower <= due && due <= E.upper && E.upper < 2 * E.lower, "%.17g to %.17g, corner %.17g", E.lower, E.upper, due);
    }
}

/*
 * A double root may come out as two roots d on either side, p = (lambda + 1)^2 (lambda^2 + 3/2 lambda + 9/2) = 4 d^2 there, up to d^3. Of
 * the coefficients one rounding each makes 1 + 7/2 + 17/2 + 21/2 + 9/2 = 28, of Omega, C1 and C2 70 + 42 + 14: E = 4 d^2/154 2^53.
 * No other root may stand for it, and none of it for another.
 */
#define RESIDUAL(d) (4 * (d) * (d) / 154 * 0x1p53)

EACH(E5_a_double_root_is_judged_by_its_residual, 8)
{
    static const struct {
        double y[8]; /* the last two: 0 for the root itself */
        double lower, upper;
    } answers[] = {
        {{-1, 0, -1, 0}, 0, 1},
        {{-1 - 0x1p-24, 0, -1 + 0x1p-24, 0}, RESIDUAL(0x1p-24), RESIDUAL(0x1p-24)},
        {{-1, 0x1p-24, -1, -0x1p-24}, RESIDUAL(0x1p-24), RESIDUAL(0x1p-24)},
        {{-1 - 0x1p-24, -0x1p-24, -1 + 0x1p-24, 0x1p-24}, 2 * RESIDUAL(0x1p-24), 2 * RESIDUAL(0x1p-24)}, /* p = 8 i d^2 */
        {{-1 - 0x1p-20, 0, -1 + 0x1p-20, 0}, RESIDUAL(0x1p-20), RESIDUAL(0x1p-20)},
        {{-0.75, 1, -1, 0}, 1e12, INFINITY},
        {{-0.75, 1.9843134832984430, -1, 0}, INFINITY, INFINITY}, /* the simple root in its place */
        {{7, 0, -1, 0}, INFINITY, INFINITY},                     /* as far from one as from the other */
    };
    double y[8];
    nearest_roots(DOUBLE, y);
    memcpy(y, answers[_i].y, 4 * sizeof *y);
    const struct error_bounds E = error_of_roots(DOUBLE, y, 0, 0);
    ck_assert_msg(E.lower >= answers[_i].lower * (1 - 1e-5) && E.upper >= E.lower && E.upper <= answers[_i].upper * (1 + 1e-5), "%g to %g", E.lower, E.upper);
    y[4] = y[0] = -1; /* the double root in a simple one's place */
    y[5] = y[1] = 0;
    ck_assert(error_of_roots(DOUBLE, y, 0, 0).lower > 1e12);
}

/* ---- ref/ ---- */

/* What is measured is an upper bound on E, of the last input too: E of each input alone, from three times as many bits. */
EACH(E4_a_measured_error_is_a_bound, sheet()->section_count)
{
    enum { INPUTS = 3, BITS = 3 * PREC };
    const struct section *s = &sheet()->sections[_i];
    double values[MOST_INPUTS], answers[MOST_OUTPUTS];
    struct measured m;
    SCOPE(arb, E, weight, measured, worst);
    VECTOR(arb, exact, MOST_OUTPUTS);
    VECTOR(arb, S, MOST_OUTPUTS);
    if (s->method != METHOD_FORMULA)
        return;
    INPUTS(inputs);
    OPERATION(o, s);
    for (uint64_t k = 0; k < INPUTS; k++) {
        sample(&o, 1, k, values, inputs);
        reference_find(s->id)(values, answers);
        operation_sensitivity(&o, inputs, BITS, S);
        operation_enclose(&o, inputs, BITS, exact);
        for (int i = 0; i < s->output_count; i++) {
            arb_set_d(E, answers[i]);
            arb_sub(E, E, exact + i, BITS);
            arb_abs(E, E);
            arb_abs(weight, exact + i);
            arb_add(weight, weight, S + i, BITS);
            arb_mul_2exp_si(E, E, BINARY64);
            if (arb_is_positive(E))
                arb_div(E, E, weight, BITS);
            arb_max(worst, worst, E, BITS);
        }
        measure_errors(&m, s, (long)k + 1, 1);
        arb_set_d(measured, m.worst);
        ck_assert_msg(arb_is_zero(worst) ? m.worst == 0 : arb_gt(measured, worst), "%s: %.17g, input %d", s->id, m.worst, (int)k);
    }
}

/* ---- sensitivities ---- */

/* S by differences: every input in turn x (1 + h) and x (1 - h). The remainder is h^2 as large. */
static void difference_S(struct operation *o, struct input *inputs, arb_ptr S)
{
    enum { BITS = 800, STEP = 100 };
    const int outputs = o->section->output_count;
    const bool roots = o->section->method == METHOD_ROOTS;
    VECTOR(arb, low, MOST_OUTPUTS);
    VECTOR(arb, high, MOST_OUTPUTS);
    SCOPE(fmpq, h, kept);
    fmpq_one(h);
    fmpq_div_2exp(h, h, STEP);
    _arb_vec_zero(S, outputs);
    for (int i = 0; i < o->section->input_count; i++) {
        fmpq_set(kept, &inputs[i].value);
        fmpq_addmul(&inputs[i].value, kept, h);
        operation_enclose(o, inputs, BITS, high);
        fmpq_set(&inputs[i].value, kept);
        fmpq_submul(&inputs[i].value, kept, h);
        operation_enclose(o, inputs, BITS, low);
        fmpq_set(&inputs[i].value, kept);
        _arb_vec_sub(high, high, low, outputs, BITS);
        for (int k = 0; k < outputs; k++) {
            if (roots)
                arb_hypot(low + k, high + k, high + (k ^ 1), BITS);
            else
                arb_abs(low + k, high + k);
            arb_mul_2exp_si(low + k, low + k, STEP - 1);
            arb_add(S + k, S + k, low + k, BITS);
        }
    }
}

/* By few bits and by many, S holds what the differences make of it, and the outputs hold their values of many bits. */
EACH(E7_enclosures_of_few_bits_hold_outputs_and_S, sheet()->section_count)
{
    enum { FEW = 6, ROOTS = 150, MANY = 600 };
    static const slong few[] = {20, 30, 53};
    const struct section *s = &sheet()->sections[_i];
    if (!operation_has_sensitivity(s))
        return;
    double values[MOST_INPUTS];
    INPUTS(inputs);
    VECTOR(arb, truth, MOST_OUTPUTS);
    VECTOR(arb, true_S, MOST_OUTPUTS);
    VECTOR(arb, y, MOST_OUTPUTS);
    VECTOR(arb, S, MOST_OUTPUTS);
    OPERATION(o, s);
    for (uint64_t k = 0; k < (s->method == METHOD_ROOTS ? ROOTS : FEW); k++) {
        sample(&o, 5, k, values, inputs);
        if (s->method == METHOD_ROOTS && k % 2 == 1) { /* near a double root, where the slope is small */
            values[1] = 10.5 * values[0] * values[0];
            values[2] = 3.5 * values[0] * (1 + ldexp(1, -3 - (int)(k % 12)));
            ck_assert(inputs_of_values(s, values, inputs));
        }
        operation_enclose(&o, inputs, MANY, truth);
        difference_S(&o, inputs, true_S);
        for (int f = 0; f < COUNT(few); f++) {
            operation_enclose(&o, inputs, few[f], y);
            operation_sensitivity(&o, inputs, few[f], S);
            for (int i = 0; i < s->output_count; i++) {
                ck_assert_msg(arb_contains(y + i, truth + i), "%s: %ld bits of output %d", s->id, few[f], i);
                ck_assert_msg(arb_contains_arf(S + i, arb_midref(true_S + i)), "%s: %ld bits of S %d", s->id, few[f], i);
                if (s->method != METHOD_ROOTS && k == 0 && f == 0) {
                    operation_sensitivity_exact(&o, inputs, few[f], i, S + i);
                    ck_assert_msg(arb_contains_arf(S + i, arb_midref(true_S + i)), "%s: S %d by exact derivatives", s->id, i);
                }
            }
        }
    }
}

/*
 * At the double next to a quarter turn the sine in (9) has a slope of 6.1e-17, of which balls of few bits hold zero too; (44) has none
 * at n = 9, and S is infinite.
 */
TEST(E7_a_slope_next_to_zero_counts_and_a_pole)
{
    const struct section *s = section_find(sheet(), "eq09"), *pole = section_find(sheet(), "eq44");
    VECTOR(arb, truth, MOST_OUTPUTS);
    VECTOR(arb, S, MOST_OUTPUTS);
    INPUTS(inputs);
    OPERATION(o, s);
    OPERATION(at_pole, pole);
    ck_assert(inputs_of_values(s, (const double[]){0x1.921fb54442d18p+0, 0}, inputs)); /* psi theta */
    difference_S(&o, inputs, truth);
    for (slong prec = 20; prec <= BINARY64; prec++)
        for (int i = 0; i < s->output_count; i++) {
            operation_sensitivity(&o, inputs, prec, S);
            ck_assert_msg(arb_contains_arf(S + i, arb_midref(truth + i)), "%ld bits of S %d", prec, i);
            operation_sensitivity_exact(&o, inputs, prec, i, S + i);
            ck_assert_msg(arb_contains_arf(S + i, arb_midref(truth + i)), "%ld bits of S %d by exact derivatives", prec, i);
        }
    ck_assert(inputs_of_values(pole, (const double[]){1, 9}, inputs)); /* Omega n */
    operation_sensitivity_exact(&at_pole, inputs, BINARY64, 0, S);
    ck_assert(arf_is_pos_inf(arb_midref(S)));
}

/* Thirds have no enclosure without a radius: a motion that ends where it begins holds them, each of its start. */
EACH(E7_a_motion_of_no_time_holds_its_start, sheet()->section_count)
{
    const struct section *s = &sheet()->sections[_i];
    VECTOR(arb, y, MOST_OUTPUTS);
    if (s->method < METHOD_FLOW_LINEAR)
        return;
    INPUTS(inputs);
    const int t = input_place(s, "t");
    OPERATION(o, s);
    for (int i = 0; i < s->input_count; i++)
        fmpq_set_si(&inputs[i].value, i == t ? 0 : i + 1, i > t && i <= t + s->output_count ? 3 : 1);
    for (slong prec = 20; prec <= 192; prec++) {
        ck_assert_int_eq(operation_enclose(&o, inputs, prec, y), OPERATION_PROVED);
        for (int i = 0; i < s->output_count; i++)
            ck_assert_msg(arb_contains_fmpq(y + i, &inputs[t + 1 + i].value), "%s, %ld bits of output %d", s->id, prec, i);
    }
}
