/*
 * Exact sums of c sqrt(n) e^b. What is expected are identities of the school book, and enclosures
 * by Arb of the same expressions.
 */
#include <check.h>
#include <stdint.h>

#include "tests/run.h"
#include "verify/exact.h"

/* A few numbers, with room for results. */
enum { ROOM = 8 };

static struct exact x[ROOM];

static void open_numbers(void)
{
    for (int k = 0; k < ROOM; k++)
        exact_init(x + k);
}

static void close_numbers(void)
{
    for (int k = 0; k < ROOM; k++)
        exact_clear(x + k);
    flint_cleanup();
}

static void set(struct exact *z, slong p, ulong q)
{
    fmpq_t value;
    fmpq_init(value);
    fmpq_set_si(value, p, q);
    exact_set_fmpq(z, value);
    fmpq_clear(value);
}

static void set_root(struct exact *z, slong p, ulong q)
{
    set(z, p, q);
    exact_sqrt(z, z);
}

static bool equals(const struct exact *z, slong p, ulong q)
{
    fmpq_t value, expected;
    fmpq_init(value);
    fmpq_init(expected);
    fmpq_set_si(expected, p, q);
    bool equal = exact_is_rational(value, z) && fmpq_equal(value, expected);
    fmpq_clear(value);
    fmpq_clear(expected);
    return equal;
}

static bool irrational(const struct exact *z)
{
    fmpq_t value;
    fmpq_init(value);
    bool rational = exact_is_rational(value, z);
    fmpq_clear(value);
    return !rational && !exact_is_unknown(z) && !exact_is_zero(z);
}

static bool unknown(const struct exact *z, bool pole)
{
    fmpq_t value;
    fmpq_init(value);
    bool decided = exact_is_zero(z) || exact_is_rational(value, z) || !exact_is_unknown(z);
    fmpq_clear(value);
    return !decided && z->pole == pole;
}

static bool same(const struct exact *a, const struct exact *b)
{
    struct exact difference;
    exact_init(&difference);
    exact_sub(&difference, a, b);
    bool zero = exact_is_zero(&difference);
    exact_clear(&difference);
    return zero;
}

START_TEST(rationals_are_a_field)
{
    ck_assert(exact_is_zero(x)); /* as initialised */
    set(x, 2, 3);
    set(x + 1, -5, 7);
    exact_add(x + 2, x, x + 1);
    ck_assert(equals(x + 2, -1, 21));
    exact_sub(x + 2, x, x + 1);
    ck_assert(equals(x + 2, 29, 21));
    exact_mul(x + 2, x, x + 1);
    ck_assert(equals(x + 2, -10, 21));
    exact_div(x + 2, x, x + 1);
    ck_assert(equals(x + 2, -14, 15));
    exact_neg(x + 2, x);
    ck_assert(equals(x + 2, -2, 3));
    exact_set(x + 2, x);
    ck_assert(equals(x + 2, 2, 3));
    set(x + 2, 0, 1);
    ck_assert(equals(x + 2, 0, 1));
}
END_TEST

START_TEST(result_may_be_an_operand)
{
    set_root(x, 2, 1);
    exact_add(x, x, x);
    exact_mul(x, x, x);
    ck_assert(equals(x, 8, 1));
    set_root(x, 2, 1);
    exact_div(x, x, x);
    ck_assert(equals(x, 1, 1));
    exact_sub(x, x, x);
    ck_assert(equals(x, 0, 1));
    set_root(x, 3, 1);
    exact_pow(x, x, 4);
    ck_assert(equals(x, 9, 1));
    exact_set(x, x);
    ck_assert(equals(x, 9, 1));
}
END_TEST

START_TEST(root_of_a_square_is_rational)
{
    set_root(x, 4, 9);
    ck_assert(equals(x, 2, 3));
    set_root(x, 0, 1);
    ck_assert(equals(x, 0, 1));
    set_root(x, 8, 18);
    ck_assert(equals(x, 2, 3));
}
END_TEST

START_TEST(roots_of_one_class_are_multiples)
{
    set_root(x, 2, 1);
    ck_assert(irrational(x));
    set_root(x + 1, 8, 1);
    exact_add(x + 2, x, x);
    ck_assert(same(x + 1, x + 2));
    set_root(x + 1, 1, 2);
    exact_add(x + 1, x + 1, x + 1);
    ck_assert(same(x, x + 1));
    set_root(x + 1, 3, 1);
    set_root(x + 2, 6, 1);
    exact_mul(x + 3, x, x + 1);
    ck_assert(same(x + 3, x + 2));
    exact_mul(x + 3, x + 3, x + 2);
    ck_assert(equals(x + 3, 6, 1));
}
END_TEST

/* (sqrt 2 + sqrt 3)^2 = 5 + 2 sqrt 6, and it is no fraction */
START_TEST(roots_of_different_classes_do_not_cancel)
{
    set_root(x, 2, 1);
    set_root(x + 1, 3, 1);
    exact_sub(x + 3, x, x + 1);
    ck_assert(irrational(x + 3));
    exact_add(x, x, x + 1);
    exact_pow(x, x, 2);
    set_root(x + 1, 24, 1);
    exact_sub(x, x, x + 1);
    ck_assert(equals(x, 5, 1));
}
END_TEST

START_TEST(sum_of_roots_is_inverted)
{
    set(x, 1, 1);
    set_root(x + 1, 2, 1);
    set_root(x + 2, 3, 1);
    exact_add(x + 3, x, x + 1);
    exact_div(x + 4, x, x + 3); /* 1/(1 + sqrt 2) = sqrt 2 - 1 */
    exact_sub(x + 5, x + 1, x);
    ck_assert(same(x + 4, x + 5));
    exact_add(x + 3, x + 3, x + 2);
    exact_div(x + 4, x, x + 3); /* 1/(1 + sqrt 2 + sqrt 3) = (2 + sqrt 2 - sqrt 6)/4 */
    ck_assert(irrational(x + 4));
    set_root(x + 5, 6, 1);
    exact_sub(x + 5, x + 1, x + 5);
    set(x + 6, 2, 1);
    exact_add(x + 5, x + 5, x + 6);
    set(x + 6, 4, 1);
    exact_div(x + 5, x + 5, x + 6);
    ck_assert(same(x + 4, x + 5));
}
END_TEST

START_TEST(quotients_beyond_reach_are_unknown)
{
    set(x, 1, 1);
    set_root(x + 1, 2, 1);
    set_root(x + 2, 3, 1);
    set_root(x + 3, 5, 1);
    exact_add(x + 1, x + 1, x);
    exact_add(x + 1, x + 1, x + 2);
    exact_add(x + 1, x + 1, x + 3);
    exact_div(x + 4, x, x + 1); /* four surds */
    ck_assert(unknown(x + 4, false));
    exact_cos(x + 1, x);
    exact_add(x + 1, x + 1, x);
    exact_div(x + 4, x, x + 1); /* 1 + cos 1 */
    ck_assert(unknown(x + 4, false));
    set(x + 5, 0, 1);
    exact_div(x + 4, x + 5, x + 1);
    ck_assert(equals(x + 4, 0, 1));
}
END_TEST

START_TEST(term_with_exponential_is_inverted)
{
    set_root(x, 3, 5);
    exact_exp(x + 1, x);
    exact_mul(x + 1, x + 1, x); /* sqrt(3/5) e^sqrt(3/5) */
    set(x + 2, 1, 1);
    exact_div(x + 3, x + 2, x + 1);
    ck_assert(irrational(x + 3));
    exact_mul(x + 3, x + 3, x + 1);
    ck_assert(equals(x + 3, 1, 1));
    exact_pow(x + 3, x + 1, -2);
    exact_pow(x + 4, x + 1, 2);
    exact_mul(x + 3, x + 3, x + 4);
    ck_assert(equals(x + 3, 1, 1));
}
END_TEST

START_TEST(powers_to_zero_and_of_zero)
{
    set_root(x, 2, 1);
    exact_pow(x + 1, x, 0);
    ck_assert(equals(x + 1, 1, 1));
    exact_pow(x + 1, x, -2);
    ck_assert(equals(x + 1, 1, 2));
    set(x, 0, 1);
    exact_pow(x + 1, x, 3);
    ck_assert(equals(x + 1, 0, 1));
    exact_pow(x + 1, x, 0);
    ck_assert(equals(x + 1, 1, 1));
    exact_pow(x + 1, x, -1);
    ck_assert(unknown(x + 1, true));
}
END_TEST

START_TEST(circular_functions_of_zero)
{
    exact_sin(x + 1, x);
    ck_assert(equals(x + 1, 0, 1));
    exact_cos(x + 1, x);
    ck_assert(equals(x + 1, 1, 1));
    exact_exp(x + 1, x);
    ck_assert(equals(x + 1, 1, 1));
}
END_TEST

START_TEST(sine_and_cosine_squared_are_one)
{
    set(x, 7, 3);
    exact_sin(x + 1, x);
    exact_cos(x + 2, x);
    ck_assert(irrational(x + 1));
    ck_assert(irrational(x + 2));
    exact_pow(x + 3, x + 1, 2);
    exact_pow(x + 4, x + 2, 2);
    ck_assert(irrational(x + 3));
    exact_add(x + 3, x + 3, x + 4);
    ck_assert(equals(x + 3, 1, 1));
}
END_TEST

/* sin(a - b) = sin a cos b - cos a sin b, with a fraction and a root */
START_TEST(addition_theorem_holds)
{
    set(x, -1, 3);
    set_root(x + 1, 5, 1);
    exact_sin(x + 2, x);
    exact_cos(x + 3, x + 1);
    exact_mul(x + 2, x + 2, x + 3);
    exact_cos(x + 4, x);
    exact_sin(x + 5, x + 1);
    exact_mul(x + 4, x + 4, x + 5);
    exact_sub(x + 2, x + 2, x + 4);
    exact_sub(x + 6, x, x + 1);
    exact_sin(x + 6, x + 6);
    ck_assert(same(x + 2, x + 6));
    exact_sin(x + 6, x);
    ck_assert(!same(x + 2, x + 6));
}
END_TEST

/* e^(sqrt 2 + 1/3) = e^sqrt 2 e^(1/3) = e^(sqrt 8 / 2) e^(1/3) */
START_TEST(exponents_add)
{
    set_root(x, 2, 1);
    set(x + 1, 1, 3);
    exact_add(x + 2, x, x + 1);
    exact_exp(x + 2, x + 2);
    ck_assert(irrational(x + 2));
    set_root(x + 3, 8, 1);
    set(x + 4, 1, 2);
    exact_mul(x + 3, x + 3, x + 4);
    exact_exp(x + 3, x + 3);
    exact_exp(x + 1, x + 1);
    exact_mul(x + 3, x + 3, x + 1);
    ck_assert(same(x + 2, x + 3));
    exact_exp(x, x);
    ck_assert(!same(x, x + 2));
}
END_TEST

START_TEST(functions_of_exponentials_are_unknown)
{
    set(x, 1, 1);
    exact_exp(x, x);
    exact_sin(x + 1, x);
    ck_assert(unknown(x + 1, false));
    exact_cos(x + 1, x);
    ck_assert(unknown(x + 1, false));
    exact_exp(x + 1, x);
    ck_assert(unknown(x + 1, false));
    exact_sqrt(x + 1, x);
    ck_assert(unknown(x + 1, false));
}
END_TEST

START_TEST(division_by_zero_is_a_pole)
{
    set(x, 1, 1);
    exact_div(x + 1, x, x + 2);
    ck_assert(unknown(x + 1, true));
    exact_mul(x + 3, x + 1, x + 2); /* 0 times it is not 0 */
    ck_assert(unknown(x + 3, true));
    exact_mul(x + 3, x + 2, x + 1);
    ck_assert(unknown(x + 3, true));
    exact_add(x + 3, x + 1, x);
    ck_assert(unknown(x + 3, true));
    exact_neg(x + 3, x + 1);
    ck_assert(unknown(x + 3, true));
    exact_positive(x + 3, x + 1);
    ck_assert(unknown(x + 3, true));
    exact_set(x + 3, x + 1);
    ck_assert(unknown(x + 3, true));
    exact_div(x + 3, x + 1, x);
    ck_assert(unknown(x + 3, true));
    exact_atan2(x + 3, x + 2, x + 1);
    ck_assert(unknown(x + 3, true));
}
END_TEST

START_TEST(root_of_a_negative_number_is_a_pole)
{
    set_root(x, -4, 1);
    ck_assert(unknown(x, true));
    set_root(x, 2, 1);
    set(x + 1, 3, 2);
    exact_sub(x + 2, x, x + 1); /* sqrt 2 - 3/2 < 0 */
    exact_sqrt(x + 3, x + 2);
    ck_assert(unknown(x + 3, true));
    exact_sub(x + 2, x + 1, x);
    exact_sqrt(x + 3, x + 2);
    ck_assert(unknown(x + 3, false));
    exact_mul(x + 3, x + 3, x + 4);
    ck_assert(equals(x + 3, 0, 1));
    exact_atan2(x + 3, x, x);
    exact_sqrt(x + 3, x + 3); /* an unknown number may be negative */
    ck_assert(unknown(x + 3, true));
}
END_TEST

START_TEST(finite_over_infinite_is_zero)
{
    exact_set_infinity(x);
    ck_assert(exact_is_unknown(x));
    set(x + 1, -5, 1);
    exact_div(x + 2, x + 1, x);
    ck_assert(equals(x + 2, 0, 1));
    exact_exp(x + 2, x + 2); /* no shielding: e^(-L/lambda_d) = 1 */
    ck_assert(equals(x + 2, 1, 1));
    exact_atan2(x + 2, x + 1, x + 1);
    exact_div(x + 2, x + 2, x);
    ck_assert(equals(x + 2, 0, 1));
    exact_set(x + 2, x);
    exact_div(x + 3, x + 1, x + 2);
    ck_assert(equals(x + 3, 0, 1));
}
END_TEST

START_TEST(infinity_otherwise_is_unknown)
{
    exact_set_infinity(x);
    set(x + 1, 1, 1);
    exact_add(x + 2, x, x + 1);
    ck_assert(unknown(x + 2, true));
    exact_mul(x + 2, x, x + 3);
    ck_assert(unknown(x + 2, true));
    exact_div(x + 2, x, x);
    ck_assert(unknown(x + 2, true));
    exact_div(x + 2, x, x + 1);
    ck_assert(unknown(x + 2, true));
    exact_neg(x + 2, x);
    ck_assert(unknown(x + 2, true));
    exact_sqrt(x + 2, x);
    ck_assert(unknown(x + 2, true));
    exact_exp(x + 2, x);
    ck_assert(unknown(x + 2, true));
    exact_sin(x + 2, x);
    ck_assert(unknown(x + 2, true));
    exact_cos(x + 2, x);
    ck_assert(unknown(x + 2, true));
    exact_atan2(x + 2, x, x + 1);
    ck_assert(unknown(x + 2, true));
    exact_positive(x + 2, x);
    ck_assert(unknown(x + 2, true));
    exact_pow(x + 2, x, 2);
    ck_assert(unknown(x + 2, true));
}
END_TEST

START_TEST(angle_is_known_where_it_is_zero)
{
    set(x + 1, 1, 1);
    set_root(x + 2, 2, 1);
    exact_sub(x + 2, x + 2, x + 1);
    exact_atan2(x + 3, x, x + 2); /* (0, sqrt 2 - 1) */
    ck_assert(equals(x + 3, 0, 1));
    exact_atan2(x + 3, x, x);
    ck_assert(equals(x + 3, 0, 1));
    exact_neg(x + 2, x + 2);
    exact_atan2(x + 3, x, x + 2); /* pi */
    ck_assert(unknown(x + 3, false));
    exact_atan2(x + 3, x + 1, x + 1); /* pi/4 */
    ck_assert(unknown(x + 3, false));
    exact_mul(x + 4, x + 3, x);
    ck_assert(equals(x + 4, 0, 1));
    exact_mul(x + 4, x + 3, x + 1);
    ck_assert(unknown(x + 4, false));
    exact_div(x + 4, x + 1, x + 3); /* for all that is known of it, it may be zero */
    ck_assert(unknown(x + 4, true));
}
END_TEST

/* exp(p/q) - r/s */
static void set_difference(struct exact *z, slong p, ulong q, slong r, ulong s)
{
    set(z, p, q);
    exact_exp(z, z);
    set(x + 7, r, s);
    exact_sub(z, z, x + 7);
}

START_TEST(positive_is_decided)
{
    set(x, 1, 1000);
    exact_positive(x + 1, x);
    ck_assert(equals(x + 1, 1, 1));
    set(x, -1, 1000);
    exact_positive(x + 1, x);
    ck_assert(equals(x + 1, 0, 1));
    set(x, 0, 1);
    exact_positive(x + 1, x);
    ck_assert(equals(x + 1, 0, 1));
    set(x, 22, 7); /* > pi */
    exact_sin(x, x);
    exact_positive(x + 1, x);
    ck_assert(equals(x + 1, 0, 1));
    set(x, 333, 106); /* < pi */
    exact_sin(x, x);
    exact_positive(x + 1, x);
    ck_assert(equals(x + 1, 1, 1));
    set(x, -100000, 1);
    exact_exp(x, x);
    exact_positive(x + 1, x);
    ck_assert(equals(x + 1, 1, 1));
    set_difference(x, 1, 1, 2721, 1001); /* a convergent of e, less by 1.1e-7 */
    exact_positive(x + 1, x);
    ck_assert(equals(x + 1, 1, 1));
    set_difference(x, 1, 1, 1457, 536); /* one that is greater by 1.8e-6 */
    exact_positive(x + 1, x);
    ck_assert(equals(x + 1, 0, 1));
}
END_TEST

START_TEST(endless_sums_are_given_up)
{
    for (int k = 1; k <= 17; k++) {
        set(x, k, 1);
        exact_exp(x, x);
        exact_add(x + 1, x + 1, x);
    }
    exact_sub(x + 2, x, x);
    exact_mul(x + 3, x + 1, x + 1); /* 17^2 > 256 */
    ck_assert(unknown(x + 3, false));
    exact_mul(x + 3, x + 3, x + 2);
    ck_assert(equals(x + 3, 0, 1));
    for (int k = 18; k <= 256; k++) {
        set(x, k, 1);
        exact_exp(x, x);
        exact_add(x + 1, x + 1, x);
        ck_assert(irrational(x + 1));
    }
    exact_add(x + 1, x + 1, x);
    ck_assert(unknown(x + 1, false));
}
END_TEST

/* Another road: the same operations in balls. Also, what is not zero must be seen not to be, given
 * digits enough. */
START_TEST(enclosures_agree_with_balls)
{
    uint64_t state = (uint64_t)_i + 1;
    const slong prec = 1000;
    arb_t y[ROOM], enclosure;
    arb_init(enclosure);
    for (int k = 0; k < ROOM; k++) {
        arb_init(y[k]);
        if (k < 4) { /* 3/2, 1, 1/2, 0, then sqrt 2, sqrt(4/2), sqrt 6, sqrt(8/2) */
            set(x + k, 3 - k, 2);
            arb_set_si(y[k], 3 - k);
            arb_mul_2exp_si(y[k], y[k], -1);
        } else {
            set_root(x + k, 2 + (k - 4) * 2, 1 + k % 2);
            arb_set_si(y[k], 2 + (k - 4) * 2);
            arb_div_ui(y[k], y[k], 1 + k % 2, prec);
            arb_sqrt(y[k], y[k], prec);
        }
    }
    for (int step = 0; step < 14; step++) {
        state = state * 6364136223846793005U + 1442695040888963407U; /* Knuth, TAOCP 2, 3.3.4 */
        int z = (int)(state >> 40) % ROOM, a = (int)(state >> 45) % ROOM,
            b = (int)(state >> 50) % ROOM;
        switch ((state >> 56) % 7) {
        case 0:
            exact_add(x + z, x + a, x + b);
            arb_add(y[z], y[a], y[b], prec);
            break;
        case 1:
            exact_sub(x + z, x + a, x + b);
            arb_sub(y[z], y[a], y[b], prec);
            break;
        case 2:
        case 3:
            exact_mul(x + z, x + a, x + b);
            arb_mul(y[z], y[a], y[b], prec);
            break;
        case 4:
            exact_div(x + z, x + a, x + b);
            arb_div(y[z], y[a], y[b], prec);
            break;
        case 5:
            exact_sin(x + z, x + a);
            arb_sin(y[z], y[a], prec);
            break;
        default:
            exact_exp(x + z, x + a);
            arb_exp(y[z], y[a], prec);
            break;
        }
        exact_enclosure(enclosure, x + z, 200);
        ck_assert(arb_is_finite(enclosure) == !exact_is_unknown(x + z));
        ck_assert(arb_overlaps(enclosure, y[z]));
        if (exact_is_unknown(x + z)) { /* begin anew */
            set(x + z, step, 1);
            arb_set_si(y[z], step);
        }
        ck_assert(arb_contains_zero(y[z]) == exact_is_zero(x + z));
    }
    arb_clear(enclosure);
    for (int k = 0; k < ROOM; k++)
        arb_clear(y[k]);
}
END_TEST

Suite *suite(void)
{
    TCase *sums = tcase_create("sums");
    tcase_add_checked_fixture(sums, open_numbers, close_numbers);
    tcase_add_test(sums, rationals_are_a_field);
    tcase_add_test(sums, result_may_be_an_operand);
    tcase_add_test(sums, root_of_a_square_is_rational);
    tcase_add_test(sums, roots_of_one_class_are_multiples);
    tcase_add_test(sums, roots_of_different_classes_do_not_cancel);
    tcase_add_test(sums, sum_of_roots_is_inverted);
    tcase_add_test(sums, quotients_beyond_reach_are_unknown);
    tcase_add_test(sums, term_with_exponential_is_inverted);
    tcase_add_test(sums, powers_to_zero_and_of_zero);
    tcase_add_test(sums, circular_functions_of_zero);
    tcase_add_test(sums, sine_and_cosine_squared_are_one);
    tcase_add_test(sums, addition_theorem_holds);
    tcase_add_test(sums, exponents_add);
    tcase_add_test(sums, functions_of_exponentials_are_unknown);
    tcase_add_test(sums, division_by_zero_is_a_pole);
    tcase_add_test(sums, root_of_a_negative_number_is_a_pole);
    tcase_add_test(sums, finite_over_infinite_is_zero);
    tcase_add_test(sums, infinity_otherwise_is_unknown);
    tcase_add_test(sums, angle_is_known_where_it_is_zero);
    tcase_add_test(sums, positive_is_decided);
    tcase_add_test(sums, endless_sums_are_given_up);
    tcase_add_loop_test(sums, enclosures_agree_with_balls, 0, 60);

    Suite *s = suite_create("exact");
    suite_add_tcase(s, sums);
    return s;
}
