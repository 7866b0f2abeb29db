/*
 * verify/algebra.h: the real roots of polynomials are counted.
 */
#include "run.h"
#include "verify/algebra.h"

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
    tcase_add_checked_fixture(c, NULL, flint_cleanup);
    tcase_add_test(c, roots_are_counted_once_and_strictly_beyond);
    suite_add_tcase(s, c);
    return s;
}
