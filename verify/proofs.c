#include "proofs.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "embedded.h"

bool proofs_step_holds(const struct proofs *p, int i)
{
    return p->corrected[i].finding == FOUND_EQUAL &&
           (!p->derivations.steps[i].differs || p->printed[i].finding == FOUND_DIFFERENT);
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

void proofs_init(struct proofs *p, ulong seed)
{
    *p = (struct proofs){.fine = true};
    derivations_open(&p->derivations);
    const size_t count = (size_t)p->derivations.step_count;
    p->corrected = memory(NULL, count, sizeof *p->corrected);
    p->printed = memory(NULL, count, sizeof *p->printed);
    for (int i = 0; i < p->derivations.step_count; i++) {
        const struct step *s = &p->derivations.steps[i];
        trial_prove(&s->corrected, seed, &p->corrected[i]);
        if (s->differs)
            trial_prove(&s->printed, seed, &p->printed[i]);
        p->points += p->corrected[i].points;
        p->degree = FLINT_MAX(p->degree, s->corrected.degree);
        p->fine = p->fine && proofs_step_holds(p, i);
    }
    p->gap = derivations_gap(&p->derivations);
    p->fine = p->fine && p->gap == NULL;
}

void proofs_clear(struct proofs *p)
{
    for (int i = 0; i < p->derivations.step_count; i++) {
        proof_clear(&p->corrected[i]);
        if (p->derivations.steps[i].differs)
            proof_clear(&p->printed[i]);
    }
    free(p->corrected);
    free(p->printed);
    derivations_clear(&p->derivations);
}
