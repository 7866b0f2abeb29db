#include "tests/paper.h"

#include <stdio.h>
#include <stdlib.h>

static void end(const struct message *why)
{
    fprintf(stderr, "%s\n", why->text);
    exit(1);
}

const struct paper *whole_paper(void)
{
    static struct paper paper;
    struct message why;
    const struct sources sources = embedded_sources();
    if (paper.sheet.sections == NULL && paper_open(&paper, &sources, &why) != 0)
        end(&why);
    return &paper;
}

const struct sheet *sheet(void)
{
    return &whole_paper()->sheet;
}

void open_steps(struct derivations *d)
{
    struct message why;
    if (derivations_open(d, whole_paper(), &why) != 0)
        end(&why);
}

void open_proofs(struct proof_results *p)
{
    struct message why;
    if (proof_results_init(p, whole_paper(), &why) != 0)
        end(&why);
}

const struct derivations *steps(void)
{
    static struct derivations opened;
    if (opened.step_count == 0)
        open_steps(&opened);
    return &opened;
}
