#include "ledger.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "decimal.h"
#include "operation.h"
#include "table1.h"

/* ---- each equation as printed ---- */

enum { MOST_INPUTS = 40, MOST_OUTPUTS = 16 };

/* The paper's case, with some inputs replaced. */
struct instance {
    const char *name;
    const char *texts[MOST_INPUTS]; /* NULL: as in the paper's case */
};

/* All outputs to six digits; false outside the domain. */
static bool values(char **texts, const struct section *s, bool as_printed, const struct instance *instance)
{
    struct operation o;
    struct input *inputs = inputs_new(s->input_count);
    operation_init(&o, s, as_printed);
    for (int i = 0; i < s->input_count; i++) {
        const struct quantity *q = s->inputs[i];
        const char *text = instance->texts[i] ? instance->texts[i] : q->value ? q->value : q->example;
        literal_read(&inputs[i].value, text, true);
    }
    bool fine = operation_digits(&o, inputs, 6, texts) == OUTCOME_PROVED;
    operation_clear(&o);
    inputs_free(inputs, s->input_count);
    return fine;
}

/* "; CASE: NAME = corrected, as printed ..." for the outputs that differ; whether any does */
static bool compare(struct evidence *e, const struct section *s, const struct instance *instance)
{
    char *right[MOST_OUTPUTS] = {NULL}, *printed[MOST_OUTPUTS] = {NULL};
    bool same = true;
    const bool inside = values(right, s, false, instance);
    if (values(printed, s, true, instance)) {
        evidence_add(e, "; %s:", instance->name);
        for (int i = 0; i < s->output_count; i++)
            if (!inside || strcmp(right[i], printed[i]) != 0) {
                evidence_add(e, "%s %s = %s, as printed %s", same ? "" : ",", s->outputs[i]->name,
                             inside ? right[i] : "none", printed[i]);
                same = false;
            }
        if (same)
            evidence_add(e, " no difference");
    }
    for (int i = 0; i < s->output_count; i++) {
        free(right[i]);
        free(printed[i]);
    }
    return !same;
}

/* In the paper's case, for unequal masses, and where only the print has a value. */
static bool compare_instances(struct evidence *e, const struct section *s)
{
    struct instance paper = {.name = "the paper's case"}, unequal = {.name = "m1 = 100 kg, m2 = 300 kg"};
    bool masses = false;
    for (int i = 0; i < s->input_count; i++) {
        unequal.texts[i] = strcmp(s->inputs[i]->name, "m1") == 0   ? "100"
                           : strcmp(s->inputs[i]->name, "m2") == 0 ? "300"
                                                                   : NULL;
        masses = masses || unequal.texts[i] != NULL;
    }
    bool differs = compare(e, s, &paper);
    if (masses)
        differs = compare(e, s, &unequal) || differs;
    for (int k = 0; k < s->special_count && !differs; k++) {
        char name[80] = "";
        struct instance special = {.name = name};
        memcpy(special.texts, s->specials[k].texts, sizeof special.texts);
        for (int i = 0; i < s->input_count; i++)
            if (special.texts[i] != NULL)
                snprintf(name + strlen(name), sizeof name - strlen(name), "%s%s = %s", *name ? ", " : "",
                         s->inputs[i]->name, special.texts[i]);
        if (strcmp(s->specials[k].flags, "invalid") == 0)
            differs = compare(e, s, &special);
    }
    return differs;
}

/* Which steps lead to an equation, and whether all of them hold, and fail as printed where they should. */
static bool steps_to(struct evidence *e, const struct proof_results *p, const char *equation, int *count)
{
    bool fine = true;
    *count = 0;
    for (int i = 0; i < p->derivations.step_count; i++) {
        const struct step *step = &p->derivations.steps[i];
        bool leads = false;
        for (int k = 0; k < step->to_count; k++)
            leads = leads || entry_leads_to(&p->derivations, step->to[k], equation);
        if (!leads)
            continue;
        evidence_add(e, "%s%s", *count ? ", " : "proved by ", step->id);
        if (step->corrected.order >= 0)
            evidence_add(e, " (terms to order %d)", step->corrected.order);
        (*count)++;
        fine = fine && step_holds(p, i);
    }
    return fine;
}

void ledger_equation(struct evidence *e, const struct proof_results *p, const struct section *s, const char *equation)
{
    int steps;
    bool proved = steps_to(e, p, equation, &steps);
    if (s->differs) {
        evidence_add(e, "; %.*s", (int)strlen(s->reason) - 1, s->reason); /* but for its full stop */
        const bool differs = compare_instances(e, s);
        e->why = s->reason;
        evidence_decide(e, HOLDS_AS_CORRECTED, EXACT, proved && steps > 0 && differs);
        return;
    }
    if (s->method == METHOD_NONE) {
        evidence_add(e, "%sa definition", steps ? "; " : "");
        for (int i = 0; i < s->relation_count; i++)
            if (strcmp(s->relations[i].equation, equation) == 0)
                evidence_add(e, ", %s", s->relations[i].text);
        evidence_decide(e, DEFINITION, EXACT, proved);
        return;
    }
    evidence_decide(e, HOLDS, EXACT, proved && steps > 0);
}

static bool has_equation(const struct section *s, const char *equation)
{
    for (int i = 0; i < s->numbers; i++)
        if (strcmp(s->equations[i], equation) == 0)
            return true;
    return false;
}

static bool wanted(const char *only, const char *id)
{
    return only == NULL || strcmp(only, id) == 0;
}

/* The first section of each equation number speaks for it. */
static bool equation_rows(const struct proof_results *p, const char *only, ledger_receiver *receive, void *context)
{
    bool decided = true;
    for (int i = 0; i < sheet()->section_count; i++) {
        const struct section *s = &sheet()->sections[i];
        for (int k = 0; k < s->numbers; k++) {
            bool earlier = false;
            for (int j = 0; j < i; j++)
                earlier = earlier || has_equation(&sheet()->sections[j], s->equations[k]);
            char id[32], where[32];
            snprintf(id, sizeof id, "equation-%s", s->equations[k]);
            if (earlier || !wanted(only, id))
                continue;
            snprintf(where, sizeof where, "Eq. (%s)", s->equations[k]);
            struct ledger_row row = {.id = id, .where = where, .claim = s->title};
            ledger_equation(&row.evidence, p, s, s->equations[k]);
            decided = decided && row.evidence.verdict != VERDICT_NONE;
            receive(context, &row);
        }
    }
    return decided;
}

/* ---- Table 1 ---- */

static bool table_rows(const char *only, ledger_receiver *receive, void *context)
{
    bool decided = true;
    for (int i = 0; i < sheet()->row_count; i++) {
        const struct table_row *t = &sheet()->table1[i];
        char id[64], claim[96];
        bool rounds;
        snprintf(id, sizeof id, "table1-%s", t->name);
        if (!wanted(only, id))
            continue;
        snprintf(claim, sizeof claim, "%s = %s %s", t->name, t->printed, t->unit);
        struct ledger_row row = {.id = id, .where = "Table 1", .claim = claim};
        char *value = table_row_value(t, &rounds);
        if (table_row_is_computed(t))
            evidence_add(&row.evidence, "by (7) from the other rows: %s %s, which rounds to the print", value, t->unit);
        else
            evidence_add(&row.evidence, "an input of the simulation, used as printed: %s %s", value, t->unit);
        evidence_decide(&row.evidence, table_row_is_computed(t) ? HOLDS : DEFINITION, EXACT, rounds);
        decided = decided && rounds;
        free(value);
        receive(context, &row);
    }
    return decided;
}

/* ---- all rows ---- */

static const struct claim *const lists[] = {claims_statics,     claims_stability, claims_motion,
                                            claims_convergence, claims_forced,    claims_beyond};
enum { LISTS = sizeof lists / sizeof *lists };

int ledger_claims(const char *ids[MOST_CLAIMS])
{
    int count = 0;
    for (int l = 0; l < LISTS; l++)
        for (const struct claim *c = lists[l]; c->id != NULL && count < MOST_CLAIMS; c++)
            ids[count++] = c->id;
    return count;
}

bool ledger_rows(const struct proof_results *proofs, const char *only, ledger_receiver *receive, void *context)
{
    bool decided = equation_rows(proofs, only, receive, context);
    decided = table_rows(only, receive, context) && decided;
    for (int l = 0; l < LISTS; l++)
        for (const struct claim *c = lists[l]; c->id != NULL; c++) {
            if (!wanted(only, c->id))
                continue;
            struct ledger_row row = {.id = c->id, .where = c->where, .claim = c->claim};
            c->decide(&row.evidence);
            decided = decided && row.evidence.verdict != VERDICT_NONE;
            receive(context, &row);
        }
    return decided;
}
