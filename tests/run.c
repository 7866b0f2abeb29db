/*
 * run.c   runs suites, or single tests: BUILD/tests/run [NAME ...]; Check itself reads the name of the TAP log from CK_TAP_LOG_FILE_NAME
 */
#define _XOPEN_SOURCE 700 /* NOLINT(bugprone-reserved-identifier): realpath() */
#include "tests/run.h"

#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_FLAT_INPUTS = 32 };

static bool outside(char domain, double x)
{
    if (isnan(x) || isinf(x))
        return domain != 'i' || x != INFINITY;
    return domain != 'r' && (x < 0 || (x == 0 && domain != '0'));
}

void assert_rejects_outside(flat_function *f, const char *domain, const double inside[])
{
    const double wrong[] = {NAN, INFINITY, -INFINITY, -1, 0, -0.0};
    const size_t inputs = strlen(domain);
    double x[MOST_FLAT_INPUTS], y[MOST_FLAT_OUTPUTS];

    ck_assert_uint_le(inputs, MOST_FLAT_INPUTS);
    memcpy(x, inside, inputs * sizeof x[0]);
    for (size_t k = f(x, y); k-- > 0;)
        ck_assert_msg(isfinite(y[k]), "output %zu is %g inside the domain", k, y[k]);

    for (size_t i = 0; i < inputs; i++) {
        for (size_t w = 0; w < sizeof wrong / sizeof wrong[0]; w++) {
            if (!outside(domain[i], wrong[w]))
                continue;
            x[i] = wrong[w];
            for (size_t k = f(x, y); k-- > 0;)
                ck_assert_msg(isnan(y[k]), "output %zu is %g where input %zu is %g", k, y[k], i, wrong[w]);
        }
        x[i] = inside[i];
    }
}

/* By file and line, in whichever order they come: constructors have none. */
static struct test_mark *marks;

void test_mark_add(struct test_mark *m)
{
    struct test_mark **at = &marks;
    while (*at != NULL && (strcmp((*at)->file, m->file) < 0 || (strcmp((*at)->file, m->file) == 0 && (*at)->line < m->line)))
        at = &(*at)->next;
    m->next = *at;
    *at = m;
}

static const char *base_name(const char *file)
{
    const char *slash = strrchr(file, '/');
    return slash != NULL ? slash + 1 : file;
}

/* By the name of its suite, or by its own. */
static bool is_named(const struct test_mark *m, const char *name)
{
    const char *file = base_name(m->file);
    const size_t length = strlen(name);
    return (strncmp(name, file, length) == 0 && strcmp(file + length, ".c") == 0) || (m->test != NULL && strcmp(name, (*m->test)->name) == 0);
}

static bool is_asked_for(const struct test_mark *m, int count, char **names)
{
    for (int i = 1; i < count; i++)
        if (is_named(m, names[i]))
            return true;
    return count <= 1;
}

static bool is_here(const char *name)
{
    for (const struct test_mark *m = marks; m != NULL; m = m->next)
        if (is_named(m, name))
            return true;
    return false;
}

/* What is asked for of the marks of one file, up to where those of the next begin; NULL where that is nothing. */
static Suite *suite_of(const struct test_mark *first, const struct test_mark *after, int count, char **names)
{
    const char *name = base_name(first->file);
    const struct test_mark *begun = NULL;
    Suite *all = NULL;
    TCase *tests = NULL;
    for (const struct test_mark *m = first; m != after; m = m->next) {
        if (m->test == NULL) {
            begun = m;
            tests = NULL;
        }
        if (m->test == NULL || !is_asked_for(m, count, names))
            continue;
        if (all == NULL)
            all = suite_create(name);
        if (tests == NULL) {
            tests = tcase_create(begun != NULL ? begun->name : name);
            tcase_set_timeout(tests, 120); /* s, under valgrind on a busy machine */
            if (begun != NULL)
                (begun->once ? tcase_add_unchecked_fixture : tcase_add_checked_fixture)(tests, begun->begin, begun->end);
            suite_add_tcase(all, tests);
        }
        tcase_add_loop_test(tests, *m->test, m->first(), m->last());
    }
    return all;
}

static const struct test_mark *next_file(const struct test_mark *m)
{
    const char *file = m->file;
    while (m != NULL && strcmp(m->file, file) == 0)
        m = m->next;
    return m;
}

/* Where the environment does not say where things were built, they were where this program was: in BUILD/tests/. */
static void find_build(const char *program)
{
    char path[4096];
    const char *name = strrchr(program, '/');
    const int length = name != NULL ? (int)(name - program) : 1;
    char *build;

    snprintf(path, sizeof path, "%.*s/..", length, name != NULL ? program : ".");
    build = realpath(path, NULL);
    if (build == NULL)
        return;
    setenv("CT_BUILD", build, 0);
    snprintf(path, sizeof path, "%s/coulomb-tether", getenv("CT_BUILD"));
    setenv("CT_PROGRAM", path, 0);
    free(build);
}

/* What is named, or all. What is not there is none that passes. */
int main(int count, char **names)
{
    find_build(names[0]);
    for (int i = 1; i < count; i++)
        if (!is_here(names[i])) {
            fprintf(stderr, "%s: '%s' is not here; there are the suites:", names[0], names[i]);
            for (const struct test_mark *m = marks; m != NULL; m = next_file(m))
                fprintf(stderr, " %.*s", (int)(strlen(base_name(m->file)) - strlen(".c")), base_name(m->file));
            fputc('\n', stderr);
            return EXIT_FAILURE;
        }
    SRunner *runner = srunner_create(NULL);
    for (const struct test_mark *m = marks; m != NULL; m = next_file(m)) {
        Suite *suite = suite_of(m, next_file(m), count, names);
        if (suite != NULL)
            srunner_add_suite(runner, suite);
    }
    srunner_run_all(runner, CK_NORMAL);
    const int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed ? EXIT_FAILURE : EXIT_SUCCESS;
}
