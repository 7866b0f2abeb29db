#include "claims/computation.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { LONGEST_WORD = 63 };

struct handed {
    char name[LONGEST_WORD + 1];
    arb_t value;
    enum truth truth;
    enum how how;
};

struct computed {
    const struct computation *of;
    bool done;
    struct handed *numbers, *truths;
    int number_count, truth_count;
};

static const struct computation *const lists[] = {
    computations_loop, computations_motion, computations_convergence, computations_forced, computations_beyond,
};

static int results_of(struct handed **results, const char *names)
{
    char word[LONGEST_WORD + 1];
    int count = 0;
    for (int length; sscanf(names, " %63s%n", word, &length) == 1; names += length) {
        *results = xrealloc(*results, (size_t)count + 1, sizeof **results);
        struct handed *r = &(*results)[count++];
        *r = (struct handed){.truth = UNDECIDED};
        memcpy(r->name, word, sizeof word);
        arb_init(r->value);
        arb_indeterminate(r->value);
    }
    return count;
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
                *new = (struct computed){.of = c};
                new->number_count = results_of(&new->numbers, c->numbers);
                new->truth_count = results_of(&new->truths, c->truths);
                all->of = xrealloc(all->of, (size_t)all->count + 1, sizeof *all->of);
                return all->of[all->count++] = new;
            }
    return NULL;
}

void computations_clear(struct computations *all)
{
    for (int i = 0; i < all->count; i++) {
        struct computed *c = all->of[i];
        for (int k = 0; k < c->number_count; k++)
            arb_clear(c->numbers[k].value);
        for (int k = 0; k < c->truth_count; k++)
            arb_clear(c->truths[k].value);
        free(c->numbers);
        free(c->truths);
        free(c);
    }
    free(all->of);
}

const struct computation *computation_of(const struct computed *c)
{
    return c->of;
}

static struct handed *result(struct handed *results, int count, const char *name)
{
    for (int i = 0; i < count; i++)
        if (strcmp(results[i].name, name) == 0)
            return &results[i];
    return NULL;
}

static void run_once(struct computed *c)
{
    if (!c->done)
        c->of->run(c);
    c->done = true;
}

bool computed_number(struct computed *c, const char *name, arb_t value, enum how *how)
{
    const struct handed *r = result(c->numbers, c->number_count, name);
    if (r == NULL)
        return false;
    run_once(c);
    arb_set(value, r->value);
    *how = r->how;
    return true;
}

bool computed_truth(struct computed *c, const char *name, enum truth *truth, enum how *how)
{
    const struct handed *r = result(c->truths, c->truth_count, name);
    if (r == NULL)
        return false;
    run_once(c);
    *truth = r->truth;
    *how = r->how;
    return true;
}

/* A name that the computation does not announce is a mistake of the program. */
static struct handed *announced(struct handed *results, int count, const char *name)
{
    struct handed *r = result(results, count, name);
    if (r == NULL) {
        fprintf(stderr, "coulomb-tether: '%s' is not announced by its computation\n", name); /* LCOV_EXCL_LINE: a mistake of ours */
        abort();                                                                             /* LCOV_EXCL_LINE: the same */
    }
    return r;
}

void give_number(struct computed *c, const char *name, const arb_t value, enum how how)
{
    struct handed *r = announced(c->numbers, c->number_count, name);
    arb_set(r->value, value);
    r->how = how;
}

void give_truth(struct computed *c, const char *name, enum truth truth, enum how how)
{
    struct handed *r = announced(c->truths, c->truth_count, name);
    r->truth = truth;
    r->how = how;
}

enum truth proved_or_open(bool proved)
{
    return proved ? FOUND_TRUE : UNDECIDED;
}
