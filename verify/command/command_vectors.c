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
    uint64_t first = 0, count = option_number(a, "--count");
    bool header = true;
    if (!option_given(a, "--count") || !option_given(a, "--seed"))
        return usage_error(EXIT_USAGE, "vectors: expected --count N and --seed S, or --golden");
    const char *shard = option_value(a, "--shard");
    if (shard != NULL && take_shard(shard, &first, &count, &header) != EXIT_DONE)
        return EXIT_USAGE;
    if (header)
        vectors_header(s);
    return vectors_random(s, option_number(a, "--seed"), first, count, form) ? EXIT_DONE : EXIT_FAILED_CHECK;
}

int command_vectors(const struct arguments *a)
{
    const struct section *s = operation_argument(a);
    const bool random = option_given(a, "--count") || option_given(a, "--seed");
    if (s == NULL)
        return EXIT_USAGE;
    if (!option_given(a, "--golden"))
        return print_random_vectors(a, s, option_inputs(a));
    if (random)
        return usage_error(EXIT_USAGE, "--golden: expected without --count and --seed");
    return vectors_golden(s, option_inputs(a)) ? EXIT_DONE : EXIT_FAILED_CHECK;
}
