/* Every input that the fuzzers keep, once through its target; the last name in the log is the one that failed. */
#include "tests/run.h"

#include <glob.h>
#include <stdio.h>

#include "tests/fuzz/targets.h"

enum { LARGEST = 1 << 17 };

START_TEST(inputs_are_survived)
{
    static char bytes[LARGEST];
    char pattern[100];
    glob_t files;
    snprintf(pattern, sizeof pattern, "tests/fuzz/corpus/%s/*", targets[_i].name);
    ck_assert_int_eq(glob(pattern, 0, NULL, &files), 0);
    for (size_t i = 0; i < files.gl_pathc; i++) {
        fprintf(stderr, "%s\n", files.gl_pathv[i]);
        FILE *file = fopen(files.gl_pathv[i], "rb");
        ck_assert_ptr_nonnull(file);
        const size_t size = fread(bytes, 1, LARGEST, file);
        fclose(file);
        targets[_i].run(bytes, size);
    }
    globfree(&files);
}
END_TEST

SUITE(test_corpora)
{
    Suite *s = suite_create("corpora");
    TCase *c = tcase_create("corpora");
    int count = 0;
    while (targets[count].name != NULL)
        count++;
    tcase_set_timeout(c, 60);
    tcase_add_loop_test(c, inputs_are_survived, 0, count);
    suite_add_tcase(s, c);
    return s;
}
