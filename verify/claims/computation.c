#include "claims/computation.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { LONGEST_WORD = 63 };

struct handed {
    char name[LONGEST_WORD + 1];
    bool is_truth;
    arb_t value;
    enum truth truth;
    enum how how;
};

struct computed {
    const struct derivations *steps;
    const struct computation *of;
    bool done;
    struct handed *results;
    int count;
};

static const struct computation *const lists[] = {
    computations_loop, computations_motion, computations_convergence, computations_forced, computations_beyond,
};

static void announce(struct computed *c, const char *names, bool is_truth)
{
    char word[LONGEST_WORD + 1];
    for (int length; sscanf(names, " %63s%n", word, &length) == 1; names += length) {
        c->results = xrealloc(c->results, (size_t)c->count + 1, sizeof *c->results);
        struct handed *r = &c->results[c->count++];
        *r = (struct handed){.is_truth = is_truth, .truth = UNDECIDED};
        memcpy(r->name, word, sizeof word);
        arb_init(r->value);
        arb_indeterminate(r->value);
    }
}

struct computed *computed_find(struct computations *all, const char *name)
{
    for (int i = 0; i < all->count; i++)
        if (strcmp(all->of[i]->of->name, name) == 0)
            return all->of[i];
    for (size_t l = 0; l < sizeof lists / sizeof *lists; l++)
        for (const struct computation *c = lists[l]; c->name != NULL; c++)
            if (strcmp(c->name, name) == 0) {
                struct computed *new = xrealloc(NULL, 1, sizeof *new);
                *new = (struct computed){.steps = all->steps, .of = c};
                announce(new, c->numbers, false);
                announce(new, c->truths, true);
                all->of = xrealloc(all->of, (size_t)all->count + 1, sizeof *all->of);
                return all->of[all->count++] = new;
            }
    return NULL;
}

void computations_clear(struct computations *all)
{
    for (int i = 0; i < all->count; i++) {
        struct computed *c = all->of[i];
        for (int k = 0; k < c->count; k++)
            arb_clear(c->results[k].value);
        free(c->results);
        free(c);
    }
    free(all->of);
}

const struct derivations *steps_of(const struct computed *c)
{
    return c->steps;
}

const struct sheet *sheet_of(const struct computed *c)
{
    return c->steps->sheet;
}

const struct computation *computation_of(const struct computed *c)
{
    return c->of;
}

static struct handed *announced(const struct computed *c, const char *name, bool is_truth)
{
    struct handed *found = NULL;
    for (int i = 0; name != NULL && i < c->count && found == NULL; i++)
        if (c->results[i].is_truth == is_truth && strcmp(c->results[i].name, name) == 0)
            found = &c->results[i];
    return found;
}

static const struct handed *result(struct computed *c, const char *name, bool is_truth)
{
    const struct handed *r = announced(c, name, is_truth);
    if (r != NULL && !c->done)
        c->of->run(c);
    c->done = c->done || r != NULL;
    return r;
}

bool computed_number(struct computed *c, const char *name, arb_t value, enum how *how)
{
    const struct handed *r = result(c, name, false);
    if (r != NULL) {
        arb_set(value, r->value);
        *how = r->how;
    }
    return r != NULL;
}

bool computed_truth(struct computed *c, const char *name, enum truth *truth, enum how *how)
{
    const struct handed *r = result(c, name, true);
    if (r != NULL) {
        *truth = r->truth;
        *how = r->how;
    }
    return r != NULL;
}

/* A name that the computation does not announce is a mistake of the program. */
static struct handed *handed(struct computed *c, const char *name, bool is_truth, enum how how)
{
    struct handed *r = announced(c, name, is_truth);
    if (r == NULL) {
        fprintf(stderr, "coulomb-tether: '%s' is not announced by its computation\n", name); /* LCOV_EXCL_LINE: a mistake of ours */
        abort();                                                                             /* LCOV_EXCL_LINE: the same */
    }
    r->how = how;
    return r;
}

void give_number(struct computed *c, const char *name, const arb_t value, enum how how)
{
    arb_set(handed(c, name, false, how)->value, value);
}

void give_truth(struct computed *c, const char *name, enum truth truth, enum how how)
{
    handed(c, name, true, how)->truth = truth;
}

enum truth proved_or_open(bool proved)
{
    return proved ? FOUND_TRUE : UNDECIDED;
}
