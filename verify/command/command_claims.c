/* coulomb-tether verify claims: the verdicts. */
#include "command/command_verify.h"

#include <stdio.h>
#include <string.h>

#include "claims/verdicts.h"
#include "command/command.h"
#include "text/json.h"

struct printer {
    struct json *json; /* NULL: text */
    int rows, verdicts[VERDICTS];
};

static const char *text_of(const struct tex *t)
{
    return t->text != NULL ? t->text : "";
}

/* The numbers of the evidence, as data. */
static void print_numbers(struct json *j, const struct statement *s)
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

static void print_json(struct json *j, const struct verdict_row *r)
{
    const bool why = r->why.plain.length > 0;
    json_open(j, NULL, '{');
    json_strings(j, "id", r->id, "where", r->where, "kind", r->kind, "claim", text_of(&r->claim.plain),
                 "verdict", verdict_names[r->verdict], "how", how_names[r->how], "evidence", text_of(&r->evidence.plain),
                 "why", why ? text_of(&r->why.plain) : NULL, "why_tex", why ? text_of(&r->why.latex) : NULL,
                 "claim_tex", text_of(&r->claim.latex), "evidence_tex", text_of(&r->evidence.latex));
    print_numbers(j, r->statement);
    json_close(j);
    json_line(j, 1);
}

/* Of a claim that does not come out as it is written: each assertion, and what was found of it. */
static void print_assertions(const struct statement *s)
{
    static const char *const found[] = {"undecided", "true", "false", "loose"};
    for (int i = 0; s != NULL && i < s->assertion_count; i++)
        if (s->assertions[i].done)
            printf("    %-20s %s\n", s->assertions[i].name, found[s->assertions[i].truth]);
}

static void print_row(void *context, const struct verdict_row *r)
{
    struct printer *p = context;
    if (p->json != NULL)
        print_json(p->json, r);
    else
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

bool verify_claims(struct verification *v)
{
    struct printer p = {.json = v->json};
    if (p.json != NULL)
        json_open(p.json, "claims", '[');
    bool decided = verdict_rows(&v->steps, &v->claims, v->only, print_row, &p);
    if (p.json != NULL) {
        json_line(p.json, -1);
        json_close(p.json);
    }
    if (p.json == NULL && v->only == NULL) {
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
