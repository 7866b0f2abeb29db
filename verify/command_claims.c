/* coulomb-tether verify claims: the ledger of verdicts. */
#include "command_verify.h"

#include <stdio.h>
#include <string.h>

#include "command.h"
#include "ledger.h"

struct printer {
    enum format format;
    int rows, verdicts[NOT_DECIDABLE + 1];
};

/* RFC 4180: quoted where a comma or a quote stands in it. */
static void csv_field(const char *text)
{
    if (strpbrk(text, ",\"\n") == NULL) {
        fputs(text, stdout);
        return;
    }
    putchar('"');
    for (; *text != '\0'; text++) {
        if (*text == '"')
            putchar('"');
        putchar(*text);
    }
    putchar('"');
}

static void print_row(void *context, const struct ledger_row *row)
{
    struct printer *p = context;
    const struct evidence *e = &row->evidence;
    const char *const fields[] = {row->id,  row->where, row->claim, verdict_names[e->verdict],
                                  how_names[e->how], e->text};
    static const char *const keys[] = {"id", "where", "claim", "verdict", "how", "evidence"};
    if (p->format == FORMAT_TABLE)
        printf("%-22s %-20s %-10s %s\n    %s\n    %s\n", row->id, verdict_names[e->verdict],
               how_names[e->how], row->where, row->claim, e->text);
    if (p->format == FORMAT_JSON)
        fputs(p->rows ? ",\n {" : "[{", stdout);
    for (int i = 0; i < 6 && p->format == FORMAT_CSV; i++) {
        csv_field(fields[i]);
        putchar(i < 5 ? ',' : '\n');
    }
    for (int i = 0; i < 6 && p->format == FORMAT_JSON; i++) {
        printf("%s\"%s\": ", i ? ", " : "", keys[i]);
        json_text(fields[i]);
    }
    if (p->format == FORMAT_JSON && e->why != NULL) {
        fputs(", \"why\": ", stdout);
        json_text(e->why);
    }
    if (p->format == FORMAT_JSON)
        putchar('}');
    p->rows++;
    p->verdicts[e->verdict]++;
}

bool print_claims(const struct proof_results *proofs, const char *only, enum format format)
{
    struct printer p = {.format = format};
    if (format == FORMAT_CSV)
        puts("id,where,claim,verdict,how,evidence");
    bool decided = ledger_rows(proofs, only, print_row, &p);
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
