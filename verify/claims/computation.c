#include "claims/claim.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "claims/convergence.h"
#include "text/message.h"

struct computed *computed_new(struct computation of, const struct derivations *steps)
{
    struct computed *c = xrealloc(NULL, 1, sizeof *c);
    *c = (struct computed){.of = of, .steps = steps};
    return c;
}

struct computed *computed_find(struct computations *all, const char *name)
{
    static const struct computation *const lists[] = {computations_simulation, computations_sampling};
    const struct study *s = study_find(name);
    struct computation found = {s != NULL ? name : NULL, run_study, s};
    for (int i = 0; i < all->count; i++)
        if (strcmp(all->of[i]->of.name, name) == 0)
            return all->of[i];
    for (size_t l = 0; l < sizeof lists / sizeof *lists; l++)
        for (const struct computation *c = lists[l]; c->name != NULL; c++)
            found = strcmp(c->name, name) == 0 ? *c : found;
    return found.name != NULL ? (*APPENDED(all->of, all->count) = computed_new(found, all->steps)) : NULL;
}

void computed_free(struct computed *c)
{
    for (int k = 0; k < c->count; k++)
        arb_clear(c->numbers[k].value);
    free(c->numbers);
    free(c);
}

void computations_clear(struct computations *all)
{
    for (int i = 0; i < all->count; i++)
        computed_free(all->of[i]);
    free(all->of);
}

static struct asked *asked(const struct computed *c, const char *name)
{
    for (int i = 0; i < c->count; i++)
        if (strcmp(c->numbers[i].name, name) == 0)
            return &c->numbers[i];
    return NULL;
}

void computed_ask(struct computed *c, const char *name)
{
    if (asked(c, name) != NULL)
        return;
    struct asked *n = APPENDED(c->numbers, c->count);
    snprintf(n->name, sizeof n->name, "%s", name);
    arb_init(n->value);
    arb_indeterminate(n->value);
}

void computed_number(struct computed *c, const char *name, arb_t value)
{
    if (!c->done)
        c->of.run(c);
    c->done = true;
    arb_indeterminate(value);
    if (asked(c, name) != NULL)
        arb_set(value, asked(c, name)->value);
}

void give(struct computed *c, bool proved, const arb_t x, const char *name, ...)
{
    char text[64];
    va_list arguments;
    va_start(arguments, name);
    vsnprintf(text, sizeof text, name, arguments);
    va_end(arguments);
    struct asked *n = asked(c, text);
    if (n != NULL && proved)
        arb_set(n->value, x);
}
