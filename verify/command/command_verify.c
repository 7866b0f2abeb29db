/* coulomb-tether verify: the proofs of the steps, the verdicts, and how wrong ref/ is against certified truth. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "claims/verdicts.h"
#include "command/command.h"
#include "command/command_derivations.h"
#include "evaluate/errors.h"
#include "evaluate/reference.h"
#include "text/decimal.h"

/* What was asked for, and what it takes. */
struct verification {
    const struct arguments *arguments;
    const char *part, *only; /* a part, and of it a step or a claim by its id; NULL: all */
    struct json *json;       /* an object, of which each part is a member; NULL: text for reading */
    struct derivations steps;
    struct statements claims; /* where they are asked for */
};

/* ---- claims ---- */

struct verdict_printer {
    struct json *json; /* NULL: text */
    int rows, verdicts[VERDICTS];
};

static const char *text_of(const struct tex *t)
{
    return t->text != NULL ? t->text : "";
}

/* The numbers of the evidence, as data. */
static void json_quoted(struct json *j, const struct statement *s)
{
    static const char *const roundings[] = {"digits", "at most", "at least", "exact"};
    json_open(j, "numbers", '[');
    for (int i = 0; s != NULL && i < s->number_count; i++) {
        const struct quoted_number *q = &s->numbers[i];
        json_open(j, NULL, '{');
        json_strings(j, "formula", q->text, "value", q->decimal != NULL ? q->decimal : "undecided", "unit", q->unit,
                     "how", how_names[q->how], "rounding", roundings[q->rounding]);
        json_value(j, "digits", "%ld", (long)q->digits);
        json_close(j);
    }
    json_close(j);
}

static void json_verdict(struct json *j, const struct verdict_row *r)
{
    const bool why = r->why.plain.length > 0;
    json_open(j, NULL, '{');
    json_strings(j, "id", r->id, "where", r->where, "kind", r->kind, "claim", text_of(&r->claim.plain),
                 "verdict", verdict_names[r->verdict], "how", how_names[r->how], "evidence", text_of(&r->evidence.plain),
                 "why", why ? text_of(&r->why.plain) : NULL, "why_tex", why ? text_of(&r->why.latex) : NULL,
                 "claim_tex", text_of(&r->claim.latex), "evidence_tex", text_of(&r->evidence.latex));
    json_quoted(j, r->statement);
    json_close(j);
}

/* Of a claim that does not come out as it is written: each assertion, and what was found of it. */
static void print_assertions(const struct statement *s)
{
    static const char *const found[] = {"undecided", "true", "false", "loose"};
    for (int i = 0; s != NULL && i < s->assertion_count; i++)
        if (s->assertions[i].done)
            printf("    %-20s %s\n", s->assertions[i].name, found[s->assertions[i].truth]);
}

static void print_verdict(void *context, const struct verdict_row *r)
{
    struct verdict_printer *p = context;
    if (p->json != NULL) {
        json_line(p->json, p->rows > 0 ? 1 : -1);
        json_verdict(p->json, r);
    } else
        printf("%-22s %-20s %-10s %s\n    %s\n    %s\n", r->id, verdict_names[r->verdict], how_names[r->how], r->where,
               text_of(&r->claim.plain), text_of(&r->evidence.plain));
    if (p->json == NULL && r->open.text[0] != '\0')
        print_assertions(r->statement);
    if (r->open.text[0] != '\0') {
        fflush(stdout);
        fprintf(stderr, "coulomb-tether: %s\n", r->open.text);
    }
    p->rows++;
    p->verdicts[r->verdict]++;
}

static bool verify_claims(struct verification *v)
{
    struct verdict_printer p = {.json = v->json};
    if (p.json != NULL)
        json_open(p.json, "claims", '[');
    const bool decided = verdict_rows(&v->steps, &v->claims, v->only, print_verdict, &p);
    if (p.json != NULL) {
        json_close(p.json);
    } else if (v->only == NULL) {
        const char *before = ":";
        printf("%d verdicts", p.rows);
        for (int k = VERDICTS - 1; k >= 0; k--)
            if (p.verdicts[k] > 0) {
                printf("%s %d %s", before, p.verdicts[k], verdict_names[k]);
                before = ",";
            }
        putchar('\n');
    }
    return decided;
}

/* ---- errors ---- */

enum { SEED = 1, PASS = 8 }; /* E beyond 8 is no rounding of a formula of the sheet: see the oracle's rule */

/* Of one operation on that many inputs; false where that is more than a rounding. */
static bool print_errors(struct json *j, const struct section *s, long inputs)
{
    struct measured m;
    char text[32];
    measure_errors(&m, s, inputs, SEED);
    decimal_bound(text, m.worst); /* the same wherever libm rounds a little differently */
    if (j != NULL) {
        json_open(j, NULL, '{');
        json_string(j, "id", s->id);
        json_value(j, "inputs", "%ld", inputs);
        json_value(j, "worst_E", isfinite(m.worst) ? "%s" : "\"%s\"", text); /* JSON has no number for inf */
        json_value(j, "vector", "\"%s-%d-%ld\"", s->id, SEED, m.index);
        json_value(j, "outside", "%ld", m.outside);
        json_close(j);
        json_line(j, 1);
    } else
        printf("%-10s %8ld %10s  %s\n", s->id, inputs, text,
               s->method != METHOD_FORMULA ? "-" : m.outside == 0 ? "always" : "NO");
    return m.worst <= PASS && m.outside == 0;
}

static bool verify_errors(struct verification *v)
{
    const struct sheet *sheet = &v->arguments->paper->sheet;
    struct json *j = v->json;
    bool fine = true;
    if (j != NULL)
        json_open(j, "errors", '[');
    else
        printf("%-10s %8s %10s  %s\n", "operation", "inputs", "E <=", "MPFR value in the enclosure");
    for (const struct section *s = sheet->sections; s < sheet->sections + sheet->section_count; s++)
        if (operation_has_sensitivity(s) && reference_find(s->id) == NULL) {
            usage_error(EXIT_FAILED_CHECK, "verify errors: no '%s' in verify/evaluate/reference.c", s->id);
            fine = false;
        } else if (operation_has_sensitivity(s))
            fine = print_errors(j, s, (long)option_number(v->arguments, "--count")) && fine;
    if (j != NULL) {
        json_line(j, -1);
        json_close(j);
    } else
        printf("\nE = |y - y*| / (2^-53 (|y*| + S)), S = sum |x dy/dx| over the inputs x: the error in roundings of result and inputs,\n"
               "its largest of all outputs of the reference library on the inputs, rounded up; at most %d passes. In the enclosure:\n"
               "whether the sheet's formula in MPFR lies in the ball that the error is measured from; - of roots, which no formula gives.\n",
               PASS);
    return fine;
}

/* ---- all of it ---- */

static bool verify_derivations(struct verification *v)
{
    return print_derivations(&v->steps, v->only, v->json);
}

static const struct part {
    const char *name;
    bool (*verify)(struct verification *v); /* whether all of it holds */
} parts[] = {{"derivations", verify_derivations}, {"claims", verify_claims}, {"errors", verify_errors}};

enum { PARTS_OF_VERIFY = sizeof parts / sizeof *parts };

static bool asked_for(const struct verification *v, const char *part)
{
    return v->part == NULL || strcmp(v->part, part) == 0;
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
    struct message why;
    struct json json = json_on(stdout);
    struct verification v = {.arguments = a, .part = a->word_count > 0 ? a->words[0] : NULL,
                             .only = a->word_count > 1 ? a->words[1] : NULL, .json = option_given(a, "--json") ? &json : NULL};
    if (v.only != NULL && asked_for(&v, "errors"))
        return usage_error(EXIT_USAGE, "verify: unexpected argument '%s'", v.only);
    if (derivations_open(&v.steps, a->paper, &why) != 0)
        return usage_error(EXIT_FAILED_CHECK, "%s", why.text);
    const bool claims = asked_for(&v, "claims");
    const bool read = !claims || statements_read(&v.claims, &v.steps, &a->paper->claims, &why) == 0;
    const int status = read ? verify(&v) : usage_error(EXIT_FAILED_CHECK, "%s", why.text);
    if (claims && read)
        statements_clear(&v.claims);
    derivations_clear(&v.steps);
    return status;
}
