/* coulomb-tether verify: the proofs. */
#include "command/command_verify.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "claims/verdicts.h"
#include "command/command.h"

enum { INPUTS = 1000, MOST_COUNT = 100000000 }; /* for each operation of verify errors, unless --count says otherwise */

/* What was asked for. */
struct verify_request {
    const struct paper *paper;
    const char *part; /* NULL: all */
    const char *claim; /* its id, or a step's; NULL: all */
    bool graph;
    enum format format;
    long count;
    struct statements claims; /* where they are asked for */
};

static bool verify_derivations(const struct derivations *d, struct verify_request *request)
{
    if (!request->graph)
        return print_proofs(d, request->claim, request->format);
    derivations_graph(d);
    bool fine = derivations_gap(d) == NULL;
    for (int i = 0; i < d->step_count; i++)
        fine = fine && step_holds(&d->steps[i]);
    return fine;
}

static bool verify_claims(const struct derivations *p, struct verify_request *request)
{
    return print_claims(&request->claims, p, request->claim, request->format);
}

static bool verify_errors(const struct derivations *p, struct verify_request *request)
{
    (void)p;
    return print_errors(&request->paper->sheet, request->count, request->format);
}

static const struct part {
    const char *name;
    bool (*verify)(const struct derivations *p, struct verify_request *request); /* whether all of it holds */
} parts[] = {{"derivations", verify_derivations}, {"claims", verify_claims}, {"errors", verify_errors}};

enum { PARTS_OF_VERIFY = sizeof parts / sizeof *parts };

static int check_request(const struct verify_request *r)
{
    bool found = r->part == NULL;
    for (int i = 0; i < PARTS_OF_VERIFY; i++)
        found = found || strcmp(r->part, parts[i].name) == 0;
    if (!found)
        return unknown_name("verify: unknown part", r->part, NEAREST(r->part, parts, PARTS_OF_VERIFY, name));
    if (r->claim != NULL && (r->part == NULL || strcmp(r->part, "errors") == 0 || r->graph))
        return usage_error(EXIT_USAGE, "verify: unexpected argument '%s'", r->claim);
    if (r->count < 1)
        return usage_error(EXIT_USAGE, "--count: expected from 1 to %d inputs", MOST_COUNT);
    return EXIT_DONE;
}

static int read_request(const struct arguments *a, struct verify_request *r)
{
    const bool json = option_given(a, "--json"), csv = option_given(a, "--csv");
    const bool markdown = option_given(a, "--markdown");
    uint64_t count = INPUTS;
    *r = (struct verify_request){.paper = a->paper,
                          .part = a->word_count > 0 ? a->words[0] : NULL,
                          .claim = a->word_count > 1 ? a->words[1] : NULL,
                          .graph = option_given(a, "--graph"),
                          .format = json       ? FORMAT_JSON
                                    : csv      ? FORMAT_CSV
                                    : markdown ? FORMAT_MARKDOWN
                                               : FORMAT_TABLE};
    if (json + csv + markdown + r->graph > 1)
        return usage_error(EXIT_USAGE, "--json, --csv, --markdown, --graph: expected one of them");
    int status = option_number(a, "--count", &count);
    r->count = count <= MOST_COUNT ? (long)count : 0;
    return status != EXIT_DONE ? status : check_request(r);
}

static bool asked_for(const struct verify_request *r, int part)
{
    return r->part == NULL || strcmp(r->part, parts[part].name) == 0;
}

/* Whether there is a step, or a row of the verdicts: those of equations and of Table 1 included. */
static int check_asked_name(const struct derivations *d, struct verify_request *r)
{
    if (r->claim == NULL)
        return EXIT_DONE;
    if (asked_for(r, 0))
        return step_named(d, r->claim) != NULL ? EXIT_DONE
                                               : unknown_name("unknown step", r->claim, NEAREST(r->claim, d->steps, d->step_count, id));
    return verdict_known(&r->claims, r->claim)
               ? EXIT_DONE
               : unknown_name("unknown claim", r->claim, NEAREST(r->claim, r->claims.list, r->claims.count, id));
}

/* What was asked for; as JSON, an object with a member a part. */
static int verify(struct verify_request *request)
{
    const char *separator = "{";
    const bool claims = asked_for(request, 1);
    struct derivations p;
    struct message why;
    if (derivations_open(&p, request->paper, &why) != 0)
        return usage_error(EXIT_FAILED_CHECK, "%s", why.text);
    if (claims && statements_read(&request->claims, &p, &request->paper->claims, &why) != 0) {
        derivations_clear(&p);
        return usage_error(EXIT_FAILED_CHECK, "%s", why.text);
    }
    int status = check_asked_name(&p, request);
    const bool known = status == EXIT_DONE;
    for (int i = 0; i < PARTS_OF_VERIFY && known; i++) {
        if (!asked_for(request, i))
            continue;
        if (request->format == FORMAT_JSON)
            printf("%s\"%s\": ", separator, parts[i].name);
        separator = ",";
        if (!parts[i].verify(&p, request))
            status = REPORTED_CHECK;
    }
    if (claims)
        statements_clear(&request->claims);
    derivations_clear(&p);
    if (request->format == FORMAT_JSON && known)
        puts("}");
    return status;
}

int command_verify(const struct arguments *a)
{
    struct verify_request request;
    int status = read_request(a, &request);
    return status == EXIT_DONE ? verify(&request) : status;
}
