/*
 * verify/enclosure.h: what is said of signs, at a point, on an interval and between two of its points. Formulas are
 * polynomials of which the roots are known fractions; what fails to hold fails on a stretch, at a point, or at an end.
 */
#include "run.h"

#include <stdio.h>

#include "enclosure.h"
#include "sheet.h"

/* (I1) strictly above zero, for certain: nothing else is positive */
START_TEST(I1_zero_and_what_is_no_number_are_not_positive)
{
    static const char *const texts[] = {"0", "1 - 1", "-1", "1/0", "sqrt(-1)", "1/(1 - 1) + 1", "pi - pi", "x", "("};
    arb_t ball;
    arb_init(ball);
    mag_one(arb_radref(ball));
    ck_assert(!positive_at(texts[_i], NOTHING));
    ck_assert(positive_at("pi - 3", NOTHING));
    ck_assert(!positive_at("1 + y", KNOWN({"y", ball}))); /* [0, 2] */
    ck_assert(positive_at("1 + y/2", KNOWN({"y", ball})));
    arb_clear(ball);
    sheet_close();
    flint_cleanup();
}
END_TEST

/* (I2) both halves of what is halved, (I3) both ends, (I4) in the end no point of doubt */
START_TEST(I2_I3_I4_no_stretch_or_point_is_passed_over)
{
    static const char *const fails[] = {"x - 1/100", "99/100 - x", "(x - 1/2)^2 - 1/10^8", "(x - 3/10)^2 - 1/10^8",
                                        "(x - 7/10)^2 - 1/10^8", "(x - 1/3)^2", "(x - 1/2)^2", "x", "1 - x", "x*(1 - x)", "1/(x - 1/3)",
                                        "sqrt(x - 1/1000)"};
    ck_assert(!positive_on(fails[_i], "0", "1", NOTHING));
    sheet_close();
    flint_cleanup();
}
END_TEST

START_TEST(I2_what_holds_on_the_whole_interval_is_found)
{
    static const char *const holds[] = {"x + 1/1000", "1001/1000 - x", "(x - 1/3)^2 + 1/1000", "x*(1 - x) + 1/100", "2 + ln_x*x - x"};
    ck_assert(positive_on(holds[_i], _i == 4 ? "1/10" : "0", "1", NOTHING));
    ck_assert(!positive_on(holds[_i], "1/0", "1", NOTHING));
    ck_assert(!positive_on(holds[_i], "1/10", "1/0", NOTHING));
    sheet_close();
    flint_cleanup();
}
END_TEST

/* (I5) the ends of the enclosure have certain and opposite signs: the root is in it, wherever a halving may meet it */
START_TEST(I5_the_root_is_in_its_enclosure)
{
    static const int root[][2] = {{1, 2}, {1, 4}, {3, 4}, {1, 3}, {2, 3}, {5, 8}, {1, 1000}, {999, 1000}, {9, 16}};
    char text[64];
    fmpq_t r;
    arb_t x;
    arb_init(x);
    fmpq_init(r);
    fmpq_set_si(r, root[_i / 2][0], (ulong)root[_i / 2][1]);
    snprintf(text, sizeof text, "%d*(x^3 - (%d/%d)^3)", _i % 2 == 0 ? 1 : -1, root[_i / 2][0], root[_i / 2][1]);
    ck_assert(change_of_sign(x, text, "0", "1", NOTHING));
    ck_assert(arb_contains_fmpq(x, r));
    ck_assert_int_gt(arb_rel_accuracy_bits(x), 60);
    fmpq_clear(r);
    arb_clear(x);
    sheet_close();
    flint_cleanup();
}
END_TEST

/* (I6) no change of sign: none, two, a double root, an end that is a root, an end where there is no number */
START_TEST(I6_without_opposite_signs_at_the_ends_nothing_is_found)
{
    static const char *const texts[] = {"x + 1", "-1 - x", "(x - 1/3)*(x - 2/3)", "(x - 1/2)^2", "x", "1 - x", "x*(1 - x)", "1/x - 2", "0*x"};
    arb_t x;
    arb_init(x);
    ck_assert(!change_of_sign(x, texts[_i], "0", "1", NOTHING));
    ck_assert(!arb_is_finite(x));
    arb_clear(x);
    sheet_close();
    flint_cleanup();
}
END_TEST

Suite *suite(void)
{
    Suite *all = suite_create("enclosure");
    TCase *tests = tcase_create("signs");
    suite_add_tcase(all, tests);
    tcase_add_loop_test(tests, I1_zero_and_what_is_no_number_are_not_positive, 0, 9);
    tcase_add_loop_test(tests, I2_I3_I4_no_stretch_or_point_is_passed_over, 0, 12);
    tcase_add_loop_test(tests, I2_what_holds_on_the_whole_interval_is_found, 0, 5);
    tcase_add_loop_test(tests, I5_the_root_is_in_its_enclosure, 0, 18);
    tcase_add_loop_test(tests, I6_without_opposite_signs_at_the_ends_nothing_is_found, 0, 9);
    return all;
}
