/* coulomb-tether verify: the proofs. */
#include "command_verify.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "command.h"

enum { SEED = 1 }; /* of the points of derivation steps; --seed draws others */

/* What was asked for. */
struct request {
    const char *part; /* NULL: all */
    bool json, graph;
    ulong seed;
};

static bool verify_derivations(const struct request *request)
{
    struct proofs p;
    proofs_init(&p, request->seed);
    if (request->graph)
        derivations_graph(&p.derivations);
    else
        print_proofs(&p, request->json ? FORMAT_JSON : FORMAT_TABLE);
    const bool fine = p.fine;
    proofs_clear(&p);
    return fine;
}

static const struct part {
    const char *name;
    bool (*verify)(const struct request *request); /* prints, and whether all of it holds */
} parts[] = {{"derivations", verify_derivations}};

enum { PARTS = sizeof parts / sizeof *parts };

static int read_request(const struct arguments *a, struct request *r)
{
    const char *known[PARTS], *seed = option_value(a, "--seed");
    char *end = NULL, hint[80];
    *r = (struct request){a->word_count > 0 ? a->words[0] : NULL, option_given(a, "--json"),
                          option_given(a, "--graph"), SEED};
    bool found = r->part == NULL;
    for (int i = 0; i < PARTS; i++) {
        known[i] = parts[i].name;
        found = found || strcmp(r->part, known[i]) == 0;
    }
    suggest(hint, found ? "" : r->part, known, PARTS);
    if (a->assignment_count > 0)
        return complain(EXIT_USAGE, "verify: unexpected argument '%s'", a->assignments[0]);
    if (!found)
        return complain(EXIT_USAGE, "verify: unknown part '%s'%s", r->part, hint);
    if (r->graph && (r->json || r->part == NULL || strcmp(r->part, "derivations") != 0))
        return complain(EXIT_USAGE, "--graph: expected verify derivations before it, and no --json");
    if (seed == NULL)
        return EXIT_DONE;
    errno = 0;
    r->seed = strtoul(seed, &end, 10);
    if (*seed < '0' || *seed > '9' || *end != '\0' || errno != 0)
        return complain(EXIT_USAGE, "--seed: expected an integer from 0 to 2^64 - 1, got '%s'", seed);
    return EXIT_DONE;
}

/* What was asked for; as JSON, an object with a member a part. */
static int verify(const struct request *request)
{
    int status = EXIT_DONE;
    const char *separator = "{";
    for (int i = 0; i < PARTS; i++) {
        if (request->part != NULL && strcmp(request->part, parts[i].name) != 0)
            continue;
        if (request->json)
            printf("%s\"%s\": ", separator, parts[i].name);
        separator = ",";
        if (!parts[i].verify(request))
            status = EXIT_FAILED_CHECK;
    }
    if (request->json)
        puts("}");
    return status;
}

int command_verify(int count, char **texts)
{
    struct option options[] = {{"--json", false, NULL}, {"--graph", false, NULL}, {"--seed", true, NULL}};
    struct arguments a = {.subcommand = "verify", .options = options, .option_count = 3};
    struct request request;
    int status = arguments_split(&a, count, texts, 1);
    if (status != EXIT_DONE)
        return status;
    status = read_request(&a, &request);
    free(a.assignments);
    if (status != EXIT_DONE)
        return status;
    status = verify(&request);
    const int output = output_finished();
    return status != EXIT_DONE ? status : output;
}
