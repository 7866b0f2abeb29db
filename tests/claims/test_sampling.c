/*
 * How long the law may be held, and how late it may act, by other roads than the program's: the multipliers of the exact matrix
 * exponential of the model with its charge held, and the zeros of the characteristic function counted by how often its
 * values turn around 0.
 */
#include "claims/sampling.h"
#include "tests/run.h"
#include "text/scope.h"

#include <complex.h> /* after FLINT, which has names I of its own */

enum { BITS = 256, STATES = 4 };

/* c1, c2; and T, d in hours at Omega = 7.2915e-5 rad/s, to what is known of them from elsewhere */
static const struct {
    double c1, c2, T, d;
} gains[] = {
    {10, 2, 1.6, 0.69}, {12, 3.4641016151377544, 2.5, 0.84}, {12, 4, 2.1, 0.88}, {9.5, 1.4142135623730951, 0, 0},
    {15, 4.898979485566356, 0, 0}, {40, 11.135528725660043, 0, 0}, {9.01, 5, 0, 0}, {30, 12, 0, 0},
};

/* The largest |multiplier| where the law is held for T: of E + F K, (E, F; 0, 1) = exp((A, B; 0, 0) T). */
static void largest_multiplier(arb_t size, const arb_t T, double c1, double c2)
{
    static const signed char model[STATES][STATES + 1] = {{0, 0, 1, 0, 0}, {0, 0, 0, 1, 0}, {-3, 0, 0, -2, 0}, {0, 9, 2, 0, 1}};
    arb_mat_t X;
    SCOPE(arb_poly, p);
    SCOPE(acb_poly, q);
    SCOPE(arb, gain, part);
    VECTOR(acb, z, STATES);
    arb_mat_init(X, STATES + 1, STATES + 1);
    for (int i = 0; i < STATES; i++)
        for (int j = 0; j <= STATES; j++)
            arb_mul_si(arb_mat_entry(X, i, j), T, model[i][j], BITS);
    arb_mat_exp(X, X, BITS);
    for (int i = 0; i < STATES; i++) {
        arb_set_d(gain, -c1);
        arb_addmul(arb_mat_entry(X, i, 1), arb_mat_entry(X, i, STATES), gain, BITS);
        arb_set_d(gain, -c2);
        arb_addmul(arb_mat_entry(X, i, 3), arb_mat_entry(X, i, STATES), gain, BITS);
    }
    for (int i = 0; i <= STATES; i++)
        arb_zero(arb_mat_entry(X, i, STATES)); /* a multiplier 0 more */
    arb_mat_charpoly(p, X, BITS);
    arb_poly_shift_right(p, p, 1);
    acb_poly_set_arb_poly(q, p);
    ck_assert_int_eq(acb_poly_find_roots(z, q, NULL, 0, BITS), STATES);
    arb_zero(size);
    for (int i = 0; i < STATES; i++) {
        acb_abs(part, z + i, BITS);
        arb_max(size, size, part, BITS);
    }
    arb_mat_clear(X);
}

START_TEST(all_multipliers_lie_inside_the_unit_circle_up_to_the_longest_hold_and_not_beyond)
{
    enum { STEPS = 50, CLOSE = 1000000 };
    SCOPE(arb, c1, c2, longest, T, size, one);
    arb_set_d(c1, gains[_i].c1);
    arb_set_d(c2, gains[_i].c2);
    largest_hold(longest, c1, c2, BITS);
    ck_assert_int_ge(arb_rel_accuracy_bits(longest), BITS / 2);
    arb_one(one);
    for (slong k = 1; k <= STEPS + 1; k++) {
        arb_mul_si(T, longest, k <= STEPS ? k * (CLOSE / STEPS) - (k == STEPS) : CLOSE + 1, BITS);
        arb_div_si(T, T, CLOSE, BITS);
        largest_multiplier(size, T, gains[_i].c1, gains[_i].c2);
        ck_assert(k <= STEPS ? arb_lt(size, one) : arb_gt(size, one));
    }
    if (gains[_i].T > 0)
        ck_assert_double_eq_tol(arf_get_d(arb_midref(longest), ARF_RND_NEAR) / 7.2915e-5 / 3600, gains[_i].T, 0.05);
}
END_TEST

/* Zeros to the right of the axis: none lies further out than `far`, and no value is close to 0. */
static int zeros_to_the_right(double c1, double c2, double d)
{
    enum { STEPS = 50000 };
    const double pi = acos(-1), far = 4 * (c1 + c2 + 6);
    double turned = 0;
    double complex before = 0;
    for (int k = 0; k <= 2 * STEPS; k++) {
        const double t = (double)(k % (STEPS + 1)) / STEPS;
        const double complex s = k <= STEPS ? I * far * (1 - 2 * t) : far * cexp(I * pi * (t + 1.0 / STEPS - 0.5));
        const double complex f = s * s * s * s - 2 * s * s - 27 + (c1 + c2 * s) * (s * s + 3) * cexp(-s * d);
        const double turn = k > 0 ? carg(f / before) : 0;
        ck_assert_double_lt(fabs(turn), 2); /* far from half a turn, which would be lost */
        turned += turn;
        before = f;
    }
    return (int)lround(turned / (2 * pi));
}

START_TEST(no_root_is_right_of_the_axis_up_to_the_largest_delay_and_a_pair_beyond)
{
    SCOPE(arb, c1, c2, longest);
    arb_set_d(c1, gains[_i].c1);
    arb_set_d(c2, gains[_i].c2);
    largest_delay(longest, c1, c2, BITS);
    ck_assert_int_ge(arb_rel_accuracy_bits(longest), BITS / 2);
    const double d = arf_get_d(arb_midref(longest), ARF_RND_NEAR);
    for (int tenth = 0; tenth < 10; tenth++)
        ck_assert_int_eq(zeros_to_the_right(gains[_i].c1, gains[_i].c2, d * tenth / 10), 0);
    ck_assert_int_eq(zeros_to_the_right(gains[_i].c1, gains[_i].c2, d * 0.99), 0);
    ck_assert_int_eq(zeros_to_the_right(gains[_i].c1, gains[_i].c2, d * 1.01), 2);
    if (gains[_i].d > 0)
        ck_assert_double_eq_tol(d / 7.2915e-5 / 3600, gains[_i].d, 0.005);
}
END_TEST

START_TEST(what_few_bits_do_not_prove_stays_open)
{
    SCOPE(arb, c1, c2, longest);
    arb_set_ui(c1, 12);
    arb_set_ui(c2, 4);
    mag_set_ui(arb_radref(c1), 1);
    largest_hold(longest, c1, c2, BITS);
    ck_assert(!arb_is_finite(longest));
    largest_delay(longest, c1, c2, 8);
    ck_assert(!arb_is_finite(longest));
}
END_TEST

SUITE(test_sampling)
{
    Suite *s = suite_create("sampling");
    TCase *c = add_case(s, "sampling");
    tcase_add_loop_test(c, all_multipliers_lie_inside_the_unit_circle_up_to_the_longest_hold_and_not_beyond, 0,
                        sizeof gains / sizeof *gains);
    tcase_add_loop_test(c, no_root_is_right_of_the_axis_up_to_the_largest_delay_and_a_pair_beyond, 0,
                        sizeof gains / sizeof *gains);
    tcase_add_test(c, what_few_bits_do_not_prove_stays_open);
    return s;
}
