#include "proof/proof_results.h"

#include <string.h>

bool step_holds(const struct step *s)
{
    for (int k = 0; k < s->remainder_count; k++)
        if (s->remainders[k].proof.state != REMAINDER_PROVED)
            return false;
    return s->proof.result == IDENTITY_HOLDS && s->line_proof.result == IDENTITY_HOLDS &&
           (!s->differs || s->printed_proof.result == IDENTITY_DIFFERS);
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
    *p = (struct proof_results){.fine = true};
    if (derivations_open(&p->derivations, paper, why) != 0)
        return -1;
    for (int i = 0; i < p->derivations.step_count; i++) {
        struct step *s = &p->derivations.steps[i];
        identities_prove(&s->corrected, &s->proof);
        if (s->differs)
            identities_prove(&s->printed, &s->printed_proof);
        for (int k = 0; k < s->remainder_count; k++)
            remainder_prove(&s->remainders[k], &s->remainders[k].proof);
        p->fine = p->fine && step_holds(s);
    }
    p->gap = derivations_gap(&p->derivations);
    p->fine = p->fine && p->gap == NULL;
    return 0;
}

void proof_results_bind(struct proof_results *p, const char *only)
{
    for (int i = 0; i < p->derivations.step_count; i++) {
        struct step *s = &p->derivations.steps[i];
        if (only != NULL && strcmp(s->id, only) != 0)
            continue;
        if (s->line_map != NULL)
            identities_prove(&s->lines, &s->line_proof);
        if (step_holds(s))
            step_bind(&p->derivations, s, &s->binding);
        p->mutants += s->binding.mutants;
        p->fine = p->fine && step_holds(s) && s->binding.fault.text[0] == '\0';
    }
}

void proof_results_clear(struct proof_results *p)
{
    derivations_clear(&p->derivations);
}
