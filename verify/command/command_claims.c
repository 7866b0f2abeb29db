/* coulomb-tether verify claims: the verdicts. */
#include "command/command_verify.h"

#include <stdio.h>
#include <string.h>

#include "claims/verdicts.h"
#include "command/command.h"

struct printer {
    enum format format;
    int rows, verdicts[NOT_DECIDABLE + 1];
};

static const char *text_of(const struct tex *t)
{
    return t->text != NULL ? t->text : "";
}

/* RFC 4180: quoted where a comma or a quote stands in it. */
static void csv_field(const char *text, char after)
{
    const bool quoted = strpbrk(text, ",\"\n") != NULL;
    if (quoted)
        putchar('"');
    for (; *text != '\0'; text++) {
        if (*text == '"')
            putchar('"');
        putchar(*text);
    }
    if (quoted)
        putchar('"');
    putchar(after);
}

static void member(const char *key, const char *text)
{
    printf(", \"%s\": ", key);
    json_text(text);
}

/* The numbers of the evidence, as data. */
static void print_numbers(const struct statement *s)
{
    fputs(", \"numbers\": [", stdout);
    for (int i = 0; s != NULL && i < s->number_count; i++) {
        static const char *const roundings[] = {"digits", "decimals", "at most", "at least", "exact"};
        const struct quoted_number *q = &s->numbers[i];
        fputs(i > 0 ? ", {\"formula\": " : "{\"formula\": ", stdout);
        json_text(q->text);
        member("value", q->decimal != NULL ? q->decimal : "undecided");
        if (q->unit != NULL)
            member("unit", q->unit);
        member("how", how_names[q->how]);
        member("rounding", roundings[q->rounding]);
        printf(", \"digits\": %ld}", (long)q->digits);
    }
    putchar(']');
}

static void print_json(const struct verdict_row *r, bool first)
{
    fputs(first ? "[{\"id\": " : ",\n {\"id\": ", stdout);
    json_text(r->id);
    member("where", r->where);
    member("kind", r->kind);
    member("claim", text_of(&r->claim.plain));
    member("verdict", verdict_names[r->verdict]);
    member("how", how_names[r->how]);
    member("evidence", text_of(&r->evidence.plain));
    if (r->why.plain.length > 0) {
        member("why", text_of(&r->why.plain));
        member("why_tex", text_of(&r->why.latex));
    }
    member("claim_tex", text_of(&r->claim.latex));
    member("evidence_tex", text_of(&r->evidence.latex));
    print_numbers(r->statement);
    putchar('}');
}

/* Of a claim that does not come out as it is written: each assertion, and what was found of it. */
static void print_assertions(const struct statement *s)
{
    static const char *const found[] = {"undecided", "true", "false"};
    for (int i = 0; s != NULL && i < s->assertion_count; i++)
        if (s->assertions[i].done)
            printf("    %-20s %s\n", s->assertions[i].name, found[s->assertions[i].truth]);
}

static void print_row(void *context, const struct verdict_row *r)
{
    struct printer *p = context;
    const char *verdict = verdict_names[r->verdict], *how = how_names[r->how];
    const char *claim = text_of(&r->claim.plain), *evidence = text_of(&r->evidence.plain);
    if (p->format == FORMAT_TABLE)
        printf("%-22s %-20s %-10s %s\n    %s\n    %s\n", r->id, verdict, how, r->where, claim, evidence);
    if (p->format == FORMAT_TABLE && r->open.text[0] != '\0')
        print_assertions(r->statement);
    if (p->format == FORMAT_JSON)
        print_json(r, p->rows == 0);
    if (p->format == FORMAT_CSV) {
        const char *const fields[] = {r->id, r->where, r->kind, claim, verdict, how, evidence};
        for (int i = 0; i < 7; i++)
            csv_field(fields[i], i < 6 ? ',' : '\n');
    }
    if (r->open.text[0] != '\0') {
        fflush(stdout);
        fprintf(stderr, "coulomb-tether: %s\n", r->open.text);
    }
    p->rows++;
    p->verdicts[r->verdict]++;
}

bool print_claims(struct statements *claims, const struct proof_results *proofs, const char *only, enum format format)
{
    struct printer p = {.format = format};
    if (format == FORMAT_CSV)
        puts("id,where,kind,claim,verdict,how,evidence");
    bool decided = verdict_rows(proofs, claims, only, print_row, &p);
    if (format == FORMAT_JSON)
        puts("]");
    if (format == FORMAT_TABLE && only == NULL) {
        printf("%d verdicts:", p.rows);
        for (int v = NOT_DECIDABLE; v >= 0; v--)
            if (p.verdicts[v] > 0)
                printf(" %d %s%s", p.verdicts[v], verdict_names[v], v > HOLDS || (v == HOLDS && p.verdicts[0]) ? "," : "");
        putchar('\n');
    }
    return decided;
}
