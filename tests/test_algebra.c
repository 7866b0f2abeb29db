/*
 * verify/algebra.h: identities are proved at enough points, roots of polynomials are counted.
 */
#include "run.h"
#include "verify/algebra.h"
#include "verify/sheet.h"

static void close_all(void)
{
    sheet_close();
    flint_cleanup();
}

START_TEST(identities_hold_or_not)
{
    ck_assert(identity("a b", "(a + b)^2", "a^2 + 2*a*b + b^2"));
    ck_assert(!identity("a b", "(a + b)^2", "a^2 + b^2"));
    ck_assert(identity("a b", "1/a - 1/b", "(b - a)/(a*b)"));
    ck_assert(identity("a b", "a^-2*(a + b)^3", "a + 3*b + 3*b^2/a + b^3*a^-2"));
    ck_assert(!identity("a", "1/(a - 2)", "1/(a - 2)")); /* a pole on the grid proves nothing */
    ck_assert(!identity("a", "sqrt(a^2)", "a"));         /* no rational function */
    ck_assert(!identity("a", "b", "b"));                 /* an unknown name */
}
END_TEST

/* A polynomial of degree d that is zero at 1 ... d, but not everywhere. */
START_TEST(identities_look_at_enough_points)
{
    ck_assert(!identity("a", "(a - 1)*(a - 2)*(a - 3)*(a - 4)", "0"));
    ck_assert(!identity("a b", "(a - 1)*(b - 1)*(b - 2)", "0"));
    ck_assert(!identity("a", "(a - 1)^1/a^3", "0"));
    ck_assert(!identity("a", "(a - 1)*(a - 2)/a - (a - 1)*(a - 2)/(a + 1)", "0"));
}
END_TEST

START_TEST(identities_know_the_sheet)
{
    ck_assert(section_identity("eq43", "C1", "n*Omega^2"));
    ck_assert(!section_identity("eq43", "C1", "(n + 1)*Omega^2"));
    ck_assert(!section_identity("eq99", "0", "0"));
}
END_TEST

static slong beyond(const char *text, slong point)
{
    fmpq_poly_t f;
    fmpq_t x;
    fmpq_poly_init(f);
    fmpq_init(x);
    fmpq_set_si(x, point, 1);
    polynomial(f, text);
    slong count = roots_beyond(f, x);
    fmpq_poly_clear(f);
    fmpq_clear(x);
    return count;
}

START_TEST(roots_are_counted_once_and_strictly_beyond)
{
    ck_assert_int_eq(beyond("(x - 1)^2*(x - 2)*(x + 3)*(x^2 + 1)", -4), 3);
    ck_assert_int_eq(beyond("(x - 1)^2*(x - 2)*(x + 3)*(x^2 + 1)", 0), 2);
    ck_assert_int_eq(beyond("(x - 1)^2*(x - 2)*(x + 3)*(x^2 + 1)", 1), 1);
    ck_assert_int_eq(beyond("(x - 1)^2*(x - 2)*(x + 3)*(x^2 + 1)", 2), 0);
    ck_assert_int_eq(beyond("x^3", 0), 0);
    ck_assert_int_eq(beyond("x^3", -1), 1);
    ck_assert_int_eq(beyond("7", 0), 0);
}
END_TEST

Suite *suite(void)
{
    Suite *s = suite_create("algebra");
    TCase *c = tcase_create("algebra");
    tcase_add_checked_fixture(c, NULL, close_all);
    tcase_add_test(c, identities_hold_or_not);
    tcase_add_test(c, identities_look_at_enough_points);
    tcase_add_test(c, identities_know_the_sheet);
    tcase_add_test(c, roots_are_counted_once_and_strictly_beyond);
    suite_add_tcase(s, c);
    return s;
}
