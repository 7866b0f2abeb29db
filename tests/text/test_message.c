/* What every other part falls back on: memory that is there, and a name that was perhaps meant. */
#include "tests/run.h"

#include <stdint.h>
#include <stdlib.h>

#include "text/message.h"

START_TEST(memory_that_cannot_be_had_ends_the_program)
{
    free(xrealloc(NULL, SIZE_MAX, 2)); /* a product that wraps round, and asks for nearly nothing */
}
END_TEST

START_TEST(no_memory_at_all_is_some_memory)
{
    void *block = xrealloc(NULL, 0, 8); /* realloc() to nothing might be no block */
    ck_assert_ptr_nonnull(block);
    free(block);
}
END_TEST

START_TEST(nearest_name_is_three_edits_away_at_most)
{
    static const char *const known[] = {"psi", "theta", "lambda_d", "a_name_of_more_than_thirty_letters"};
    static const struct {
        const char *mistaken, *nearest;
    } pairs[] = {{"thta", "theta"}, {"htea", "theta"}, {"lamda", "lambda_d"}, {"lmd", NULL}, {"", NULL}, {"qq", NULL},
                 {"a_name_of_more_than_thirty_letter", NULL}}; /* too long to be compared */
    const char *nearest = nearest_name(pairs[_i].mistaken, known, 4);
    ck_assert_pstr_eq(nearest, pairs[_i].nearest);
}
END_TEST

SUITE(test_message)
{
    Suite *s = suite_create("message");
    TCase *c = tcase_create("message");
    tcase_add_exit_test(c, memory_that_cannot_be_had_ends_the_program, 1);
    tcase_add_test(c, no_memory_at_all_is_some_memory);
    tcase_add_loop_test(c, nearest_name_is_three_edits_away_at_most, 0, 7);
    suite_add_tcase(s, c);
    return s;
}
