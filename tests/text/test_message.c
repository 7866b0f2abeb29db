/* What every other part falls back on: memory that is there, and a name that was perhaps meant. */
#include "tests/run.h"

#include <stdint.h>
#include <stdlib.h>
#include <sys/wait.h>
#include <unistd.h>

#include "text/message.h"

TEST(memory_that_cannot_be_had_ends_the_program)
{
    int status;
    const pid_t child = fork();
    if (child == 0)
        free(xrealloc(NULL, SIZE_MAX, 2)); /* a product that wraps round, and asks for nearly nothing */
    ck_assert_int_eq(waitpid(child, &status, 0), child);
    ck_assert_int_eq(WEXITSTATUS(status), 1);
}

TEST(no_memory_at_all_is_some_memory)
{
    void *block = xrealloc(NULL, 0, 8); /* realloc() to nothing might be no block */
    ck_assert_ptr_nonnull(block);
    free(block);
}

EACH(nearest_name_is_three_edits_away_at_most, 7)
{
    static const char *const known[] = {"psi", "theta", "lambda_d", "a_name_of_more_than_thirty_letters"};
    static const struct {
        const char *mistaken, *nearest;
    } pairs[] = {{"thta", "theta"}, {"htea", "theta"}, {"lamda", "lambda_d"}, {"lmd", NULL}, {"", NULL}, {"qq", NULL},
                 {"a_name_of_more_than_thirty_letter", NULL}}; /* too long to be compared */
    const char *nearest = nearest_name(pairs[_i].mistaken, known, 4, sizeof *known);
    ck_assert_pstr_eq(nearest, pairs[_i].nearest);
}
