#include "proof/proof_results.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>


bool step_holds(const struct proof_results *p, int i)
{
    for (int k = 0; k < p->derivations.steps[i].remainder_count; k++)
        if (p->remainders[i][k].state != REMAINDER_PROVED)
            return false;
    return p->corrected[i].result == IDENTITY_HOLDS && (p->lines == NULL || p->lines[i].result == IDENTITY_HOLDS) &&
           (!p->derivations.steps[i].differs || p->printed[i].result == IDENTITY_DIFFERS);
}

int derivations_open(struct derivations *d, const struct paper *paper, struct message *why)
{
    const struct source *s = &paper->derivations;
    if (derivations_read(d, &paper->sheet, s->text, s->length, s->name, why) != 0)
        return -1;
    if (step_named(d, "second_order") != NULL) /* its formulas are computed with */
        return 0;
    message_set(why, "%s: no derivation step 'second_order'", s->name);
    derivations_clear(d);
    return -1;
}

const struct step *step_named(const struct derivations *d, const char *id)
{
    int i = 0;
    while (i < d->step_count && strcmp(d->steps[i].id, id) != 0)
        i++;
    return i < d->step_count ? &d->steps[i] : NULL;
}

int proof_results_init(struct proof_results *p, const struct paper *paper, struct message *why)
{
    if (derivations_open(&p->derivations, paper, why) != 0)
        return -1;
    proof_results_of(p);
    return 0;
}

void proof_results_bind(struct proof_results *p, const char *only)
{
    const size_t count = (size_t)p->derivations.step_count;
    p->bindings = xrealloc(NULL, count, sizeof *p->bindings);
    p->lines = xrealloc(NULL, count, sizeof *p->lines);
    memset(p->lines, 0, count * sizeof *p->lines);
    for (int i = 0; i < p->derivations.step_count; i++) {
        const struct step *s = &p->derivations.steps[i];
        const bool asked = only == NULL || strcmp(s->id, only) == 0;
        p->bindings[i] = (struct binding){.mutants = 0};
        if (asked && s->line_map != NULL)
            identities_prove(&s->lines, &p->lines[i]);
        if (asked && step_holds(p, i))
            step_bind(&p->derivations, s, &p->bindings[i]);
        p->mutants += p->bindings[i].mutants;
        p->fine = p->fine && step_holds(p, i) && p->bindings[i].fault.text[0] == '\0';
    }
}

void proof_results_of(struct proof_results *p)
{
    const struct derivations d = p->derivations;
    const size_t count = (size_t)d.step_count;
    *p = (struct proof_results){.derivations = d, .fine = true};
    p->corrected = xrealloc(NULL, count, sizeof *p->corrected);
    p->printed = xrealloc(NULL, count, sizeof *p->printed);
    p->remainders = xrealloc(NULL, count, sizeof *p->remainders);
    for (int i = 0; i < d.step_count; i++) {
        identities_prove(&d.steps[i].corrected, &p->corrected[i]);
        if (d.steps[i].differs)
            identities_prove(&d.steps[i].printed, &p->printed[i]);
        p->remainders[i] = xrealloc(NULL, (size_t)d.steps[i].remainder_count, sizeof **p->remainders);
        for (int k = 0; k < d.steps[i].remainder_count; k++)
            remainder_prove(&d.steps[i].remainders[k], &p->remainders[i][k]);
        p->fine = p->fine && step_holds(p, i);
    }
    p->gap = derivations_gap(&p->derivations);
    p->fine = p->fine && p->gap == NULL;
}

void proof_results_clear(struct proof_results *p)
{
    for (int i = 0; i < p->derivations.step_count; i++) {
        proof_clear(&p->corrected[i]);
        if (p->derivations.steps[i].differs)
            proof_clear(&p->printed[i]);
        if (p->lines != NULL)
            proof_clear(&p->lines[i]);
        free(p->remainders[i]);
    }
    free(p->corrected);
    free(p->printed);
    free(p->remainders);
    free(p->lines);
    free(p->bindings);
    derivations_clear(&p->derivations);
}
