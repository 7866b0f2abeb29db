#include "claims/claim.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "text/message.h"

struct handed {
    char name[64];
    arb_t value;
    enum how how;
};

const char *next_name(const char *names, char name[64])
{
    int length;
    return sscanf(names, " %63s%n", name, &length) == 1 ? names + length : NULL;
}

struct computed *computed_new(const struct computation *of, const struct derivations *steps)
{
    struct computed *c = xrealloc(NULL, 1, sizeof *c);
    char name[64];
    *c = (struct computed){.of = of, .steps = steps};
    for (const char *at = of->numbers; (at = next_name(at, name)) != NULL;) {
        struct handed *n = APPENDED(c->numbers, c->count);
        memcpy(n->name, name, sizeof name);
        arb_init(n->value);
        arb_indeterminate(n->value);
    }
    return c;
}

struct computed *computed_find(struct computations *all, const char *name)
{
    static const struct computation *const lists[] = {computations_simulation, computations_studies, computations_sampling};
    for (int i = 0; i < all->count; i++)
        if (strcmp(all->of[i]->of->name, name) == 0)
            return all->of[i];
    for (size_t l = 0; l < sizeof lists / sizeof *lists; l++)
        for (const struct computation *c = lists[l]; c->name != NULL; c++)
            if (strcmp(c->name, name) == 0) {
                return *APPENDED(all->of, all->count) = computed_new(c, all->steps);
            }
    return NULL;
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

static struct handed *announced(const struct computed *c, const char *name)
{
    for (int i = 0; i < c->count; i++)
        if (strcmp(c->numbers[i].name, name) == 0)
            return &c->numbers[i];
    return NULL;
}

bool computed_number(struct computed *c, const char *name, arb_t value, enum how *how)
{
    const struct handed *n = announced(c, name);
    if (n == NULL)
        return false;
    if (!c->done)
        c->of->run(c);
    c->done = true;
    arb_set(value, n->value);
    *how = n->how;
    return true;
}

void give(struct computed *c, enum how how, bool proved, const arb_t x, const char *name, ...)
{
    char text[64];
    va_list arguments;
    va_start(arguments, name);
    vsnprintf(text, sizeof text, name, arguments);
    va_end(arguments);
    struct handed *n = announced(c, text);
    if (n == NULL)
        return; /* no claim asks for it */
    n->how = how;
    if (proved)
        arb_set(n->value, x);
}

enum truth proved_or_open(bool proved)
{
    return proved ? FOUND_TRUE : UNDECIDED;
}
