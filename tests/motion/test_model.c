/*
 * verify/motion/model.h: what a model says of a number holds for all its unknowns, against balls of many bits; a test for every
 * error term of the theorem in model.c.
 */
#include "tests/run.h"

#include <math.h>
#include <string.h>

#include "motion/taylor.h"
#include "text/scope.h"

enum { PREC = 320, POINTS = 9 };

/* Binary64 numbers between -1 and 1 with all their bits */
static double number(int k)
{
    return sin(k);
}

/* Point number k of the unknowns: corners first */
static double unknown(int k, int i)
{
    return k < 4 ? ((k >> i % 2) & 1) * 2 - 1 : number(7 * k + i);
}

/* x at a point */
static void value_at(arb_t z, const struct model *x, int point)
{
    const struct space *s = x->space;
    SCOPE(arb, term, e);
    arb_zero(z);
    for (int b = 0; b < s->size; b++) {
        arb_set_d(term, x->c[b]);
        for (int i = 0; i < s->variables; i++) {
            arb_set_d(e, unknown(point, i));
            arb_pow_ui(e, e, s->exponent[b * s->variables + i], PREC);
            arb_mul(term, term, e, PREC);
        }
        arb_add(z, z, term, PREC);
    }
}

/* |truth - x| <= rest there, for certain; and the rest is not more than `most` */
static void assert_holds(const struct model *x, const arb_t truth, int point, double most)
{
    SCOPE(arb, off, rest);
    value_at(off, x, point);
    arb_sub(off, off, truth, PREC);
    arb_abs(off, off);
    arb_set_d(rest, x->rest);
    ck_assert_msg(arb_le(off, rest), "point %d", point);
    ck_assert_double_le(x->rest, most);
}

/* Those coefficients, the first of all, and the others 0 */
static void set_model(struct model *x, int count, const double c[], double rest)
{
    memset(x->c, 0, (size_t)x->space->size * sizeof *x->c);
    for (int b = 0; b < count; b++)
        x->c[b] = c[b];
    model_scale(x, 1); /* finds its norms */
    x->rest = rest;
}

static void set_random(struct model *x, int seed, double rest)
{
    for (int b = 0; b < x->space->size; b++)
        x->c[b] = number(seed + 3 * b);
    model_scale(x, 1);
    x->rest = rest;
}

/* What is beyond binary64 is not known, and is no zero: not as a factor, nor cut, nor its range. */
TEST(what_overflows_is_nothing_known)
{
    OWNED(space) s, linear;
    SCOPE(arb, huge, one, range);
    space_init(&s, 2, 3);
    space_init(&linear, 2, 1);
    MODEL(x, &s);
    MODEL(y, &s);
    MODEL(z, &s);
    MODEL(cut, &linear);
    arb_one(one);
    arb_mul_2exp_si(huge, one, 1024);
    model_set_variable(&x, huge, one, 0);
    model_set_variable(&y, one, one, 1);
    model_dot(&z, false, 1, &x, &y, 1);
    model_dot(&x, false, 1, &z, &y, 1);
    model_set(&cut, &x);
    ck_assert(!(model_size(&x) < HUGE_VAL) && !(model_size(&cut) < HUGE_VAL));
    model_range(range, &x);
    ck_assert(!arb_is_finite(range));
    model_range(range, &cut);
    ck_assert(!arb_is_finite(range));
}

TEST(monomials_are_in_order_and_multiply)
{
    OWNED(space) s;
    space_init(&s, 4, 5);
    ck_assert_int_eq(s.size, 126);
    for (int i = 0; i < 4; i++)
        ck_assert_int_eq(s.exponent[(1 + i) * 4 + i], 1);
    for (int a = 0, degree = 0; a < s.size; a++) {
        degree += a == s.first[degree + 1];
        for (int b = 0; b < s.first[s.degree - degree + 1]; b++)
            for (int i = 0; i < 4; i++)
                ck_assert_int_eq(s.exponent[s.product[a][b] * 4 + i], s.exponent[a * 4 + i] + s.exponent[b * 4 + i]);
    }
}

/* Three products and a sum of polynomials of degree 2, nothing cut off: what is left is rounding. */
EACH(M1_sums_of_products_are_rounded, 20)
{
    OWNED(space) s;
    SCOPE(arb, truth, a, b);
    space_init(&s, 3, 4);
    MODELS(x, 3, &s);
    MODELS(y, 3, &s);
    MODEL(z, &s);
    for (int k = 0; k < 3; k++) {
        set_random(&x[k], 11 * _i + k, 0);
        set_random(&y[k], 17 * _i + 5 * k, 0);
        for (int c = s.first[3]; c < s.size; c++)
            x[k].c[c] = y[k].c[c] = 0;
        model_scale(&x[k], 1);
        model_scale(&y[k], 1);
        x[k].rest = y[k].rest = 0;
    }
    set_random(&z, _i, 0);
    for (int point = 0; point < POINTS; point++) {
        value_at(a, &z, point);
        model_dot(&z, true, -1, x, y + 2, 3);
        arb_set(truth, a);
        for (int k = 0; k < 3; k++) {
            value_at(a, &x[k], point);
            value_at(b, &y[2 - k], point);
            arb_submul(truth, a, b, PREC);
        }
        assert_holds(&z, truth, point, 1e-10);
        z.rest = 0;
    }
}

/* To 1 are added 2^-53, one by one: each is lost, all of them are four times the rounding of any one sum. */
TEST(M1_as_many_roundings_as_there_are_sums)
{
    enum { SUMS = 20 };
    OWNED(space) s;
    SCOPE(arb, truth, x);
    space_init(&s, 0, 0);
    MODEL(z, &s);
    MODELS(term, SUMS + 1, &s);
    MODELS(one, SUMS + 1, &s);
    arb_one(truth);
    for (int k = 0; k <= SUMS; k++) {
        model_set_ball(&one[k], truth);
        arb_set_d(x, k == 0 ? 1 : 0x1p-53);
        model_set_ball(&term[k], x);
    }
    arb_mul_ui(x, x, SUMS, PREC);
    arb_add(truth, truth, x, PREC);
    model_dot(&z, false, 1, term, one + SUMS, SUMS + 1);
    assert_holds(&z, truth, 0, 1e-14);
    arb_set_d(x, 1);
    model_set_ball(&term[SUMS], x); /* and from the last on, by Horner's rule */
    arb_set_d(x, 0x1p-53);
    model_set_ball(&term[0], x);
    model_evaluate(&z, term, SUMS + 1, 1);
    assert_holds(&z, truth, 0, 1e-13);
    for (int k = 0; k <= SUMS; k++)
        term[k].rest = 1;
    model_evaluate(&z, term, SUMS + 1, -1);
    ck_assert_double_ge(z.rest, SUMS + 1); /* and so are their rests */
}

/*
 * A product of models of degree 3, of which twenty pairs make e_1 ... e_6: 1, and nineteen 2^-53, each of which is lost beside it.
 * Nothing is cut off, and all other coefficients are exact.
 */
TEST(M1_as_many_roundings_as_pairs_make_a_monomial)
{
    enum { VARIABLES = 6, ALL_ONE = 3 /* number of the point where every unknown is 1 */ };
    OWNED(space) s;
    SCOPE(arb, truth, b);
    space_init(&s, VARIABLES, VARIABLES);
    MODEL(x, &s);
    MODEL(y, &s);
    MODEL(z, &s);
    int first = 0, last = 0; /* e_1 e_2 e_3 and e_4 e_5 e_6 */
    for (int c = s.first[3]; c < s.first[4]; c++) {
        bool square = false;
        for (int i = 0; i < VARIABLES; i++)
            square = square || s.exponent[c * VARIABLES + i] > 1;
        if (square)
            continue;
        x.c[c] = 0x1p-26;
        y.c[c] = 0x1p-27;
        first = first == 0 ? c : first;
        last = c;
    }
    x.c[first] = y.c[last] = 1;
    model_scale(&x, 1);
    model_scale(&y, 1);
    x.rest = y.rest = 0;
    model_dot(&z, false, 1, &x, &y, 1);
    value_at(truth, &x, ALL_ONE);
    value_at(b, &y, ALL_ONE);
    arb_mul(truth, truth, b, PREC);
    assert_holds(&z, truth, ALL_ONE, 2e-14);
}

/* One coefficient with all its bits, by a third; and as the only term of a series: nothing else is rounded. */
EACH(M1_a_scaled_number_and_a_term_of_a_series_are_rounded, 20)
{
    OWNED(space) s;
    SCOPE(arb, truth, factor);
    space_init(&s, 0, 0);
    MODELS(x, 2, &s); /* the first of them is 0 */
    MODEL(z, &s);
    set_random(&x[1], _i + 1, 0);
    set_random(&z, _i + 1, 0);
    value_at(truth, &z, 0);
    arb_set_d(factor, 1.0 / 3);
    arb_mul(truth, truth, factor, PREC);
    model_scale(&z, 1.0 / 3);
    assert_holds(&z, truth, 0, 1e-15);
    model_evaluate(&z, x, 2, 1.0 / 3);
    assert_holds(&z, truth, 0, 1e-14);
}

/* Rests alone, of which the products are no binary64; or the bounds of what is cut off. */
static const struct {
    const char *term;
    double x[3], y[3]; /* coefficients: one of each, or the rest */
    double rest_x, rest_y, rest_z;
} rests[] = {
    {"M3: degrees 2 and 2", {0, 0, 1}, {0, 0, 1}, 0, 0, 0},
    {"M3: degrees 1 and 2", {0, 1, 0}, {0, 0, 1}, 0, 0, 0},
    {"M4", {0, 0, 0.1}, {0}, 0, 0.3, 0},
    {"M5", {0}, {0, 0, 0.7}, 0.1, 0, 0},
    {"M6", {0}, {0}, 0.1, 0.3, 0},
    {"M7", {0}, {0}, 0x1p-30, 0x1p-30, 0.1},
    {"M2: a product below binary64", {0}, {0}, 0x1p-540, 0x1p-540, 0},
};

EACH(M2_to_M7_a_rest_has_what_is_cut_off_and_all_rests, COUNT(rests))
{
    OWNED(space) s;
    SCOPE(arb, truth, a, b, rest);
    space_init(&s, 1, 2);
    MODEL(x, &s);
    MODEL(y, &s);
    MODEL(z, &s);
    for (int k = 0; k < 200; k++) {
        const double scale = 1 + fabs(number(k)); /* any bits */
        set_model(&x, 3, rests[_i].x, 0);
        set_model(&y, 3, rests[_i].y, 0);
        set_model(&z, 0, NULL, rests[_i].rest_z * scale);
        model_scale(&x, scale);
        model_scale(&y, scale);
        x.rest = rests[_i].rest_x * scale;
        y.rest = rests[_i].rest_y * scale;
        arb_set_d(truth, z.rest);
        arb_set_d(a, x.c[1] + x.c[2] + x.rest); /* all but one of them are 0 */
        arb_set_d(b, y.c[1] + y.c[2] + y.rest);
        arb_addmul(truth, a, b, PREC);
        model_dot(&z, true, 1, &x, &y, 1);
        arb_set_d(rest, z.rest);
        ck_assert_msg(arb_le(truth, rest), "%s", rests[_i].term);
        ck_assert_double_le(z.rest, arf_get_d(arb_midref(truth), ARF_RND_UP) * (1 + 1e-8) + 0x1p-999);
        model_range(a, &z);
        ck_assert(arb_contains(a, rest)); /* though no coefficient is left */
    }
}

/* 1 + e +- 1/4 is as large as 9/4: what bounds a series of models holds for all unknowns. */
TEST(a_coefficient_of_models_is_as_large_as_any_of_them)
{
    OWNED(space) s;
    OWNED(jet) jet;
    SCOPE(arb, one);
    SCOPE(mag, size, quarter);
    space_init(&s, 1, 1);
    jet_init(&jet, &closed_loop, 1, &s);
    arb_one(one);
    mag_set_d(quarter, 0.25);
    model_set_variable(jet.m[2] + 1, one, one, 0);
    model_widen(jet.m[2] + 1, quarter);
    jet_size(size, &jet, 2, 1);
    ck_assert_double_ge(mag_get_d(size), 2.25);
}

/* A third is no binary64, and a linear model of what is not linear is off by that. */
TEST(M8_numbers_and_models_that_do_not_fit_leave_a_rest)
{
    OWNED(space) s, linear;
    SCOPE(arb, third, truth, e);
    space_init(&s, 2, 3);
    space_init(&linear, 2, 1);
    MODEL(x, &s);
    MODEL(cut, &linear);
    arb_set_ui(third, 1);
    arb_div_ui(third, third, 3, PREC);
    model_set_ball(&x, third);
    assert_holds(&x, third, 4, 1e-16);
    model_set_variable(&x, third, third, 1);
    for (int point = 0; point < POINTS; point++) {
        arb_set_d(e, unknown(point, 1));
        arb_mul(truth, third, e, PREC);
        arb_add(truth, truth, third, PREC);
        assert_holds(&x, truth, point, 2e-16);
    }
    MODEL(all, &s);
    set_random(&all, 0, 0.25);
    model_set(&cut, &all);
    for (int point = 0; point < POINTS; point++) {
        value_at(truth, &all, point);
        mag_set_d(arb_radref(truth), 0.25);
        assert_holds(&cut, truth, point, 10);
    }
}

/* x = 2 + e_1/2 - e_2/4 +- 1e-3: of degree `_i` and what that leaves out */
RANGE(M9_roots_sines_and_cosines_hold, 1, 7)
{
    static const double most[] = {10, 1, 0.1, 0.1, 0.02, 0.02, 0.02};
    OWNED(space) s;
    SCOPE(arb, value, truth, other);
    space_init(&s, 2, _i);
    MODEL(x, &s);
    MODEL(root, &s);
    MODEL(sine, &s);
    MODEL(cosine, &s);
    set_model(&x, 3, (double[]){2, 0.5, -0.25}, 1e-3);
    model_inverse_root(&root, &x);
    model_sine(&sine, &x, 0);
    model_sine(&cosine, &x, 1);
    for (int point = 0; point < POINTS; point++)
        for (int side = -1; side <= 1; side++) {
            value_at(value, &x, point);
            arb_set_d(other, side * 1e-3);
            arb_add(value, value, other, PREC);
            arb_rsqrt(truth, value, PREC);
            assert_holds(&root, truth, point, most[_i]);
            arb_sin_cos(truth, other, value, PREC);
            assert_holds(&sine, truth, point, most[_i]);
            assert_holds(&cosine, other, point, most[_i]);
        }
    set_model(&x, 3, (double[]){0.5, 0.5, -0.25}, 1e-3); /* down to -0.25 */
    model_inverse_root(&root, &x);
    ck_assert(isinf(root.rest));
}

/* Of all numbers within r of 1, and where r is so large that nothing is said: 1/sqrt(1 - r) - 1 is the furthest from 1. */
EACH(M9_the_root_of_what_is_hardly_known, 4)
{
    static const double rests[] = {0.1, 0.3, 0.49, 0.5};
    OWNED(space) s;
    SCOPE(arb, one);
    SCOPE(mag, r);
    space_init(&s, 0, 0);
    MODEL(x, &s);
    MODEL(root, &s);
    arb_one(one);
    mag_set_d(r, rests[_i] / 2);
    model_set_ball(&x, one);
    model_widen(&x, r);
    model_widen(&x, r);
    model_inverse_root(&root, &x);
    ck_assert_double_eq(root.c[0], 1);
    ck_assert_double_ge(root.rest, 1 / sqrt(1 - rests[_i]) - 1);
    ck_assert(_i < 3 ? root.rest < 0.5 : isinf(root.rest));
}

/* 1 + 2^-52 (e_1^2 + ... + e_20^2): its middle is rounded twenty times, by all that it is wide. */
TEST(M1_the_middle_of_a_range_is_rounded)
{
    enum { UNKNOWNS = 20 };
    OWNED(space) s;
    SCOPE(arb, range, end);
    space_init(&s, UNKNOWNS, 2);
    MODEL(x, &s);
    x.c[0] = 1;
    for (int i = 1; i <= UNKNOWNS; i++)
        x.c[s.product[i][i]] = 0x1p-52;
    model_scale(&x, 1);
    x.rest = 0;
    model_range(range, &x);
    arb_set_d(end, UNKNOWNS * 0x1p-52);
    arb_add_ui(end, end, 1, PREC);
    ck_assert(arb_contains(range, end));
}

/* Either half is the polynomial on half of the box; all of a polynomial lies in its range, at 0 and at corners. */
EACH(M1_halves_ranges_and_sums_hold, 10)
{
    OWNED(space) s;
    SCOPE(arb, truth, e, range, power);
    space_init(&s, 2, 4);
    MODEL(x, &s);
    MODEL(half, &s);
    MODEL(at, &s);
    MODELS(sum, 3, &s);
    set_random(&x, _i, 0);
    model_halve(&half, 0, 1);
    model_dot(&at, true, 1, &half, &x, 1);
    model_dot(&at, true, 1, &x, &half, 1);
    ck_assert(model_size(&half) <= 0 && model_size(&at) <= 0); /* what is 0 stays 0 */
    for (int side = -1; side <= 1; side += 2) {
        model_set(&half, &x);
        model_halve(&half, 1, side);
        for (int point = 0; point < POINTS; point++) {
            arb_zero(truth);
            for (int b = 0; b < s.size; b++) {
                arb_set_d(range, x.c[b]);
                for (int i = 0; i < 2; i++) {
                    arb_set_d(e, unknown(point, i));
                    if (i == 1) {
                        arb_add_si(e, e, side, PREC);
                        arb_mul_2exp_si(e, e, -1);
                    }
                    arb_pow_ui(e, e, s.exponent[2 * b + i], PREC);
                    arb_mul(range, range, e, PREC);
                }
                arb_add(truth, truth, range, PREC);
            }
            assert_holds(&half, truth, point, 1e-12);
        }
        half.rest = 1;
        model_halve(&half, 0, side);
        ck_assert_double_ge(half.rest, 1);
    }
    model_range(range, &x);
    for (int k = 0; k < 3; k++)
        set_random(&sum[k], 5 * k + _i, 1e-20 * k);
    model_evaluate(&at, sum, 3, -0.3);
    for (int point = 0; point < POINTS; point++) {
        value_at(truth, &x, point);
        ck_assert(arb_contains(range, truth));
        arb_zero(truth);
        arb_set_d(e, -0.3);
        for (int k = 2; k >= 0; k--) {
            value_at(power, &sum[k], point);
            arb_mul(truth, truth, e, PREC);
            arb_add(truth, truth, power, PREC);
        }
        assert_holds(&at, truth, point, 1e-13);
    }
    set_model(&x, 4, (double[]){0, 0, 0, 1}, 0); /* e_1^2 lies in [0, 1] */
    model_range(range, &x);
    arb_set_si(truth, -1);
    ck_assert(!arb_contains(range, truth));
    arb_one(truth);
    ck_assert(arb_contains_si(range, 0) && arb_contains(range, truth));
}
