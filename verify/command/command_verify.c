/* coulomb-tether verify: the proofs. */
#include "command/command_verify.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "claims/verdicts.h"
#include "command/command.h"

enum { COUNT_UNLESS_GIVEN = 1000, MOST_COUNT = 100000000 }; /* for each operation of verify errors, unless --count says otherwise */

static const struct part {
    const char *name;
    bool (*verify)(struct verification *v); /* whether all of it holds */
} parts[] = {{"derivations", verify_derivations}, {"claims", verify_claims}, {"errors", verify_errors}};

enum { PARTS_OF_VERIFY = sizeof parts / sizeof *parts };

static bool asked_for(const struct verification *v, const char *part)
{
    return v->part == NULL || strcmp(v->part, part) == 0;
}

static int read_request(const struct arguments *a, struct verification *v)
{
    uint64_t count = COUNT_UNLESS_GIVEN;
    *v = (struct verification){.sheet = &a->paper->sheet,
                               .part = a->word_count > 0 ? a->words[0] : NULL,
                               .only = a->word_count > 1 ? a->words[1] : NULL};
    if (v->only != NULL && asked_for(v, "errors"))
        return usage_error(EXIT_USAGE, "verify: unexpected argument '%s'", v->only);
    const int status = option_number(a, "--count", 1, MOST_COUNT, &count);
    v->count = (long)count;
    return status;
}

/* Whether there is a step, or a row of the verdicts: those of equations and of Table 1 included. */
static int check_asked_name(struct verification *v)
{
    if (v->only == NULL)
        return EXIT_DONE;
    if (asked_for(v, "derivations"))
        return step_named(&v->steps, v->only) != NULL
                   ? EXIT_DONE
                   : unknown_name("unknown step", v->only, NEAREST(v->only, v->steps.steps, v->steps.step_count, id),
                                  "verify derivations");
    return verdict_known(&v->claims, v->only)
               ? EXIT_DONE
               : unknown_name("unknown claim", v->only, NEAREST(v->only, v->claims.list, v->claims.count, id), "verify claims");
}

/* All that was asked for; as JSON, an object with a member a part. */
static int verify(struct verification *v)
{
    int status = check_asked_name(v);
    if (status != EXIT_DONE)
        return status;
    if (v->json != NULL)
        json_open(v->json, NULL, '{');
    for (int i = 0; i < PARTS_OF_VERIFY; i++)
        if (asked_for(v, parts[i].name) && !parts[i].verify(v))
            status = REPORTED_CHECK;
    if (v->json != NULL)
        json_close(v->json);
    return status;
}

int command_verify(const struct arguments *a)
{
    struct verification v;
    struct message why;
    struct json json = json_on(stdout);
    int status = read_request(a, &v);
    v.json = option_given(a, "--json") ? &json : NULL;
    if (status != EXIT_DONE)
        return status;
    if (derivations_open(&v.steps, a->paper, &why) != 0)
        return usage_error(EXIT_FAILED_CHECK, "%s", why.text);
    const bool claims = asked_for(&v, "claims");
    const bool read = !claims || statements_read(&v.claims, &v.steps, &a->paper->claims, &why) == 0;
    status = read ? verify(&v) : usage_error(EXIT_FAILED_CHECK, "%s", why.text);
    if (claims && read)
        statements_clear(&v.claims);
    derivations_clear(&v.steps);
    return status;
}
