/* coulomb-tether vectors: random certified vectors of an operation, and the golden ones, as CSV. */
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "command/command.h"
#include "evaluate/vectors.h"

/* K/N: the K-th of N contiguous parts, as even as can be. */
static int take_shard(const char *text, uint64_t *first, uint64_t *count, bool *header)
{
    unsigned long k = 0, n = 0;
    int length = 0;
    if (strspn(text, "0123456789/") != strlen(text) || sscanf(text, "%7lu/%7lu%n", &k, &n, &length) != 2 ||
        text[length] != '\0' || k < 1 || k > n || n > 1000000)
        return usage_error(EXIT_USAGE, "--shard: expected K/N with 1 <= K <= N <= 1000000, got '%.40s'", text);
    const uint64_t all = *count, part = all / n, more = all % n; /* the first `more` parts have one more */
    *first = (k - 1) * part + (k - 1 < more ? k - 1 : more);
    *count = part + (k - 1 < more);
    *header = k == 1;
    return EXIT_DONE;
}

static int print_random_vectors(const struct arguments *a, const struct section *s, enum input_form form)
{
    uint64_t first = 0, count = 0, seed = 0;
    bool header = true;
    if (!option_given(a, "--count") || !option_given(a, "--seed"))
        return usage_error(EXIT_USAGE, "vectors: expected --count N and --seed S, or --golden");
    int status = option_number(a, "--count", 0, UINT64_MAX, &count);
    if (status == EXIT_DONE)
        status = option_number(a, "--seed", 0, UINT64_MAX, &seed);
    const char *shard = option_value(a, "--shard");
    if (status == EXIT_DONE && shard != NULL)
        status = take_shard(shard, &first, &count, &header);
    if (status != EXIT_DONE)
        return status;
    if (header)
        vectors_header(s);
    return vectors_random(s, seed, first, count, form) ? EXIT_DONE : EXIT_FAILED_CHECK;
}

int command_vectors(const struct arguments *a)
{
    const struct section *s = operation_argument(a);
    if (s == NULL)
        return EXIT_USAGE;
    enum input_form form;
    int status = option_inputs(a, &form);
    const bool golden = option_given(a, "--golden");
    const bool random = option_given(a, "--count") || option_given(a, "--seed");
    if (status == EXIT_DONE && golden && random)
        status = usage_error(EXIT_USAGE, "--golden: expected without --count and --seed");
    else if (status == EXIT_DONE && golden)
        status = vectors_golden(s, form) ? EXIT_DONE : EXIT_FAILED_CHECK;
    else if (status == EXIT_DONE)
        status = print_random_vectors(a, s, form);
    return status;
}
