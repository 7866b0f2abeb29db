/*
 * run.h   what every suite shares with the one main program that runs it
 */
#ifndef COULOMBTETHER_TESTS_RUN_H
#define COULOMBTETHER_TESTS_RUN_H

#include <math.h>
#include <stddef.h>

#include <check.h>

/* The tests of a file, by its name: SUITE(test_flow) { ... } makes the suite. What is linked is known to run.c by itself. */
struct named_suite {
    const char *name;
    Suite *(*make)(void);
    struct named_suite *next;
};
void suite_add(struct named_suite *s);

#define SUITE(file) \
    static Suite *file(void); \
    __attribute__((constructor)) static void file##_add(void) \
    { \
        static struct named_suite s = {#file, file, NULL}; \
        suite_add(&s); \
    } \
    static Suite *file(void)

/* A case of tests that take seconds under valgrind, on a busy machine. */
TCase *add_case(Suite *all, const char *name);

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
