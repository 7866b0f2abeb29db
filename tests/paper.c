#include "tests/paper.h"

#include <stdio.h>
#include <stdlib.h>

#include "motion/taylor.h"
#include "text/scope.h"

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

/* Before the tests, each of which is a process of its own. */
__attribute__((constructor)) static void read_once(void)
{
    sheet();
}

void open_steps(struct derivations *d)
{
    struct message why;
    if (derivations_open(d, whole_paper(), &why) != 0)
        end(&why);
}

const struct derivations *steps(void)
{
    static struct derivations opened;
    if (opened.step_count == 0)
        open_steps(&opened);
    return &opened;
}

void closed_loop_rates(fmpq *rates, const fmpq *state, const fmpq_t c1, const fmpq_t c2)
{
    enum { ONE = JET_SERIES, TWO, THREE, C1, C2, LAMBDA, HOLD };
    VECTOR(fmpq, value, JET_ALL);
    SCOPE(fmpq, product);
    for (int v = 0; v < JET_STATES; v++) {
        fmpq_set(value + v, state + v);
        fmpq_zero(rates + v);
    }
    fmpq_set_si(value + ONE, 1, 1);
    fmpq_set_si(value + TWO, 2, 1);
    fmpq_set_si(value + THREE, 3, 1);
    fmpq_set(value + C1, c1);
    fmpq_set(value + C2, c2);
    fmpq_set_si(value + LAMBDA, 1, 1);
    fmpq_set_si(value + HOLD, 3, 1);
    for (int t = 0; t < JET_TERMS; t++) {
        const struct term *f = closed_loop.terms + t;
        fmpq *to = f->to < JET_STATES ? rates + f->to : value + f->to;
        fmpq_mul(product, value + f->a, value + f->b);
        if (f->sign < 0)
            fmpq_sub(to, to, product);
        else
            fmpq_add(to, to, product);
    }
}
