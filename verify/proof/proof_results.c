#include "proof/proof_results.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "sheet/embedded.h"

bool step_holds(const struct proof_results *p, int i)
{
    for (int k = 0; k < p->derivations.steps[i].remainder_count; k++)
        if (p->remainders[i][k].state != REMAINDER_PROVED)
            return false;
    return p->corrected[i].result == IDENTITY_HOLDS &&
           (!p->derivations.steps[i].differs || p->printed[i].result == IDENTITY_DIFFERS);
}

void derivations_open(struct derivations *d)
{
    struct message why;
    size_t length;
    const char *text = embedded_derivations(&length);
    if (derivations_read(d, sheet(), text, length, "paper/derivations.yaml", &why) != 0) {
        fprintf(stderr, "coulomb-tether: %s\n", why.text); /* the build has checked the steps */
        exit(1);
    }
}

const struct step *step_named(const struct derivations *d, const char *id)
{
    int i = 0;
    while (i < d->step_count && strcmp(d->steps[i].id, id) != 0)
        i++;
    if (i == d->step_count) {
        fprintf(stderr, "coulomb-tether: no derivation step '%s'\n", id);
        exit(1);
    }
    return &d->steps[i];
}

void proof_results_init(struct proof_results *p)
{
    derivations_open(&p->derivations);
    proof_results_of(p);
}

void proof_results_bind(struct proof_results *p, const char *only)
{
    p->bindings = xrealloc(NULL, (size_t)p->derivations.step_count, sizeof *p->bindings);
    for (int i = 0; i < p->derivations.step_count; i++) {
        p->bindings[i] = (struct binding){.mutants = 0};
        if (step_holds(p, i) && (only == NULL || strcmp(p->derivations.steps[i].id, only) == 0))
            step_bind(&p->derivations, &p->derivations.steps[i], &p->bindings[i]);
        p->mutants += p->bindings[i].mutants;
        p->fine = p->fine && p->bindings[i].fault.text[0] == '\0';
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
        free(p->remainders[i]);
    }
    free(p->corrected);
    free(p->printed);
    free(p->remainders);
    free(p->bindings);
    derivations_clear(&p->derivations);
}
