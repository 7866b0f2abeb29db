#include "claims/verdicts.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "evaluate/operation.h"
#include "evaluate/table1.h"
#include "text/decimal.h"

void verdict_row_clear(struct verdict_row *row)
{
    written_clear(&row->claim);
    written_clear(&row->why);
    written_clear(&row->evidence);
}

/* Adds marked text to the evidence, printf-like. */
#if defined(__GNUC__)
__attribute__((format(printf, 2, 3)))
#endif
static void add_words(struct verdict_row *row, const char *format, ...)
{
    char text[1024];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    write_marked(&row->evidence, text);
}

/* ---- each equation as printed ---- */

/* What there is to say of one case: nothing, that only the print has values, that its values differ. */
enum difference { NONE, OUTSIDE, INSIDE };

/* "; CASE: NAME = corrected, as printed ..." for the outputs that differ to six digits, some inputs of the paper's case being replaced. */
static enum difference compare_prints(struct verdict_row *row, const struct section *s, const char *name, const char *const *replaced)
{
    char *digits[2][MOST_OUTPUTS] = {{NULL}}; /* as it is right, as printed */
    bool inside[2];
    enum difference difference = NONE;
    struct input *inputs = inputs_new(s->input_count);
    for (int i = 0; i < s->input_count; i++) {
        const struct quantity *q = s->inputs[i];
        literal_read(&inputs[i].value, replaced[i] ? replaced[i] : q->value ? q->value : q->example, true);
    }
    for (int printed = 0; printed < 2; printed++) {
        OWNED(operation) o;
        operation_init(&o, s, printed);
        inside[printed] = operation_digits(&o, inputs, 6, digits[printed]) == OPERATION_PROVED;
    }
    inputs_free(inputs, s->input_count);
    for (int i = 0; i < s->output_count; i++) {
        if (inside[1] && (!inside[0] || strcmp(digits[0][i], digits[1][i]) != 0)) {
            add_words(row, difference == NONE ? "; %s:" : ",", name);
            add_words(row, " $%s$ = ", s->outputs[i]->name);
            if (inside[0])
                write_decimal(&row->evidence, digits[0][i], NULL);
            else
                add_words(row, "none");
            add_words(row, ", as printed ");
            write_decimal(&row->evidence, digits[1][i], NULL);
            difference = inside[0] ? INSIDE : OUTSIDE;
        }
        free(digits[0][i]);
        free(digits[1][i]);
    }
    return difference;
}

/* In the paper's case but for equal masses, which hide what is wrong; else where only the print has a value. */
static enum difference compare_instances(struct verdict_row *row, const struct section *s)
{
    const char *unequal[MOST_INPUTS] = {NULL};
    const int m1 = input_place(s, "m1"); /* m2 stands with it */
    if (m1 >= 0) {
        unequal[m1] = "100";
        unequal[input_place(s, "m2")] = "300";
    }
    enum difference differs = compare_prints(row, s, m1 < 0 ? "the paper's case" : "$m1 = 100$ kg, $m2 = 300$ kg", unequal);
    for (int k = 0; k < s->special_count && differs == NONE; k++) {
        const char *const *special = s->specials[k].texts;
        char name[80] = "";
        for (int i = 0; i < s->input_count; i++)
            if (special[i] != NULL)
                snprintf(name + strlen(name), sizeof name - strlen(name), "%s$%s = %s$", *name ? ", " : "", s->inputs[i]->name, special[i]);
        if (strcmp(s->specials[k].flags, "invalid") == 0)
            differs = compare_prints(row, s, name, special);
    }
    return differs;
}

/* Which steps lead to an equation, and whether all of them hold, and fail as printed where they should. */
static bool steps_to(struct verdict_row *row, const struct derivations *p, const char *equation, int *count)
{
    bool fine = true;
    *count = 0;
    for (int i = 0; i < p->step_count; i++) {
        struct step *step = &p->steps[i];
        bool leads = false;
        for (int k = 0; k < step->to_count; k++)
            leads = leads || entry_leads_to(p, step->to[k], equation);
        if (!leads)
            continue;
        add_words(row, "%s%s", *count ? ", " : "proved by ", step->id);
        if (step->corrected.order >= 0)
            add_words(row, " (to order %d)", step->corrected.order);
        (*count)++;
        fine = fine && step_holds(step);
    }
    return fine;
}

static void add_reason(struct verdict_row *row, const char *reason)
{
    write_marked(&row->why, row->why.plain.length > 0 ? " " : "");
    write_marked(&row->why, reason);
}

/* Claims of the sheet that are reasons of its verdict. */
static void add_claims(struct verdict_row *row, struct statements *claims, const char *equation)
{
    for (int i = 0; claims != NULL && i < claims->count; i++) {
        struct statement *s = &claims->list[i];
        struct ruling ruling;
        for (int k = 0; k < s->equation_count; k++) {
            if (strcmp(s->equations[k], equation) != 0)
                continue;
            statement_decide(claims, s, &ruling);
            add_words(row, "; claim %s: %s", s->id, verdict_names[ruling.verdict]);
            if (s->why != NULL && ruling.verdict < HOLDS)
                add_reason(row, s->why);
            row->verdict = FLINT_MIN(row->verdict, ruling.verdict);
            row->how = FLINT_MAX(row->how, ruling.how);
        }
    }
}

void verdict_on_equation(struct verdict_row *row, const struct derivations *p, struct statements *claims, const struct section *s,
                         const char *equation)
{
    int steps;
    const bool proved = steps_to(row, p, equation, &steps);
    const bool defines = s->method == METHOD_NONE && steps == 0;
    row->verdict = proved && (steps > 0 || defines) ? (defines || s->defines != NULL) ? DEFINITION : HOLDS : VERDICT_NONE;
    if (s->differs) {
        add_words(row, "; %.*s", (int)strlen(s->reason) - 1, s->reason); /* but for its full stop */
        const enum difference differs = compare_instances(row, s);
        if (differs == INSIDE)
            add_reason(row, s->reason);
        else
            add_words(row, ": outside the condition that the paper states for it");
        if (differs != OUTSIDE) /* what is printed must differ somewhere */
            row->verdict = differs == INSIDE && row->verdict == HOLDS ? HOLDS_AS_CORRECTED : VERDICT_NONE;
    }
    if (s->method == METHOD_NONE) {
        const char *before = steps > 0 ? "; " : "a definition, ";
        for (int i = 0; i < s->relation_count; i++)
            if (strcmp(s->relations[i].equation, equation) == 0) {
                add_words(row, "%s$%s$", before, s->relations[i].text);
                before = ", ";
            }
        if (row->evidence.plain.length == 0)
            add_words(row, "a definition");
    }
    if (s->defines != NULL)
        add_words(row, "; it defines $%s$", s->defines);
    add_claims(row, claims, equation);
}

/* ---- the rows ---- */

struct giving {
    const struct derivations *proofs;
    struct statements *claims;
    const char *only;
    verdict_receiver *receive;
    void *context;
    bool decided, known; /* known: a row of those that are wanted */
};

static bool wanted(struct giving *g, const char *id)
{
    const bool asked = g->only == NULL || strcmp(g->only, id) == 0;
    g->known = g->known || asked;
    return asked && g->receive != NULL;
}

static void give_row(struct giving *g, struct verdict_row *row)
{
    if (row->verdict == VERDICT_NONE && row->open.text[0] == '\0')
        message_set(&row->open, "%s is undecided", row->id);
    g->decided = g->decided && row->open.text[0] == '\0';
    g->receive(g->context, row);
    verdict_row_clear(row);
}

/* The first section of each equation number speaks for it. */
static void equation_rows(struct giving *g)
{
    const struct sheet *sheet = g->claims->sheet;
    for (int i = 0; i < sheet->section_count; i++) {
        const struct section *s = &sheet->sections[i];
        for (int k = 0; k < s->numbers; k++) {
            char id[32], where[32];
            snprintf(id, sizeof id, "equation-%s", s->equations[k]);
            if (section_with(sheet, s->equations[k]) != s || !wanted(g, id))
                continue;
            snprintf(where, sizeof where, "Eq. (%s)", s->equations[k]);
            struct verdict_row row = {.id = id, .where = where, .kind = s->kind};
            write_marked(&row.claim, s->title);
            verdict_on_equation(&row, g->proofs, g->claims, s, s->equations[k]);
            give_row(g, &row);
        }
    }
}

static void table_rows(struct giving *g)
{
    const struct sheet *sheet = g->claims->sheet;
    for (int i = 0; i < sheet->row_count; i++) {
        const struct table_row *t = &sheet->table1[i];
        const bool computed = table_row_is_computed(sheet, t);
        char id[64], claim[96];
        bool rounds;
        snprintf(id, sizeof id, "table1-%s", t->name);
        if (!wanted(g, id))
            continue;
        snprintf(claim, sizeof claim, "$%s = %s$ %s", t->name, t->printed, t->unit);
        struct verdict_row row = {.id = id, .where = "Table 1", .kind = "number"};
        write_marked(&row.claim, claim);
        char *value = table_row_value(sheet, t, &rounds);
        add_words(&row, computed ? "by (7) from the other rows: " : "an input of the simulation, used as printed: ");
        write_decimal(&row.evidence, value, t->unit);
        if (computed)
            add_words(&row, ", which rounds to the print");
        row.verdict = !rounds ? VERDICT_NONE : computed ? HOLDS : DEFINITION;
        give_row(g, &row);
        free(value);
    }
}

static void statement_rows(struct giving *g)
{
    for (int i = 0; i < g->claims->count; i++) {
        struct statement *s = &g->claims->list[i];
        struct ruling ruling;
        if (!wanted(g, s->id))
            continue;
        statement_decide(g->claims, s, &ruling);
        struct verdict_row row = {.id = s->id, .where = s->where, .kind = s->kind, .verdict = ruling.verdict, .how = ruling.how,
                                  .statement = s, .open = ruling.open};
        write_marked(&row.claim, s->claim);
        if (s->why != NULL && ruling.as_written)
            write_marked(&row.why, s->why);
        statement_evidence(s, &row.evidence);
        give_row(g, &row);
    }
}

static void give_rows(struct giving *g)
{
    equation_rows(g);
    table_rows(g);
    statement_rows(g);
}

bool verdict_rows(const struct derivations *proofs, struct statements *claims, const char *only, verdict_receiver *receive, void *context)
{
    struct giving g = {proofs, claims, only, receive, context, true, false};
    give_rows(&g);
    return g.decided;
}

bool verdict_known(struct statements *claims, const char *id)
{
    struct giving g = {.proofs = claims->proofs, .claims = claims, .only = id};
    give_rows(&g);
    return g.known;
}
