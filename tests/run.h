/*
 * run.h   what every suite shares with the one main program that runs it
 */
#ifndef COULOMBTETHER_TESTS_RUN_H
#define COULOMBTETHER_TESTS_RUN_H

#include <math.h>
#include <stdbool.h>
#include <stddef.h>

#include <check.h>

/*
 * A file of tests is a suite of its name, and knows of its tests where they stand: TEST(name) { ... } is one, EACH(name, count) { ... }
 * one for each _i from 0 to count - 1, RANGE(name, from, to) one for each from `from` to to - 1. CASE(name, begin, end) begins a case
 * of tests that run by themselves on CK_RUN_CASE=name; begin() before each of them and end() after it, where not NULL; of CASE_ONCE
 * before the first and after the last.
 */
struct test_mark {
    const char *file;
    int line;
    const char *name;             /* of the case that begins; NULL at a test */
    const TTest *const *test;
    int (*first)(void), (*last)(void);
    void (*begin)(void), (*end)(void);
    bool once;
    struct test_mark *next;
};
void test_mark_add(struct test_mark *m);

#define COUNT(table) ((int)(sizeof(table) / sizeof(table)[0]))
#define TEST(name) RANGE(name, 0, 1)
#define EACH(name, count) RANGE(name, 0, count)
#define RANGE(name, from, to) \
    static const TTest *name; \
    static int name##_first(void) { return (int)(from); } \
    static int name##_last(void) { return (int)(to); } \
    MARK(name##_mark, NULL, &name, name##_first, name##_last, NULL, NULL, false) \
    START_TEST(name)
#define CASE(name, begin, end) CASE_AT(name, begin, end, false, __LINE__)
#define CASE_ONCE(name, begin, end) CASE_AT(name, begin, end, true, __LINE__)
#define CASE_AT(name, begin, end, once, line) CASE_MARKED(name, begin, end, once, line)
#define CASE_MARKED(name, begin, end, once, line) MARK(name##line##_mark, #name, NULL, NULL, NULL, begin, end, once)
#define MARK(id, ...) \
    __attribute__((constructor)) static void id(void) \
    { \
        static struct test_mark m = {__FILE__, __LINE__, __VA_ARGS__, NULL}; \
        test_mark_add(&m); \
    }

/* Within so many roundings (2^-53, relative) of an expected value that is not zero. NaN fails. */
#define assert_close(actual, expected, roundings) \
    ck_assert_double_eq_tol(actual, expected, (roundings) * 0x1p-53 * fabs((double)(expected)))

/* A function with its inputs in a row x and its outputs in a row y; it returns their number, MOST_FLAT_OUTPUTS or less. */
typedef size_t flat_function(const double x[], double y[]);
enum { MOST_FLAT_OUTPUTS = 16 };

/*
 * All outputs are numbers inside the domain, and all are NaN where one input, whichever, leaves it. The domain is a
 * letter an input: '+' finite and above zero, '0' finite and not below zero, 'i' above zero, infinite too, 'r' finite.
 */
void assert_rejects_outside(flat_function *f, const char *domain, const double inside[]);

#endif
