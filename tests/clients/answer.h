/*
 * answer.h   a question of the oracle, and what ref/ answers it (verify/evaluate/reference.h): for the client in C, and for one with faults
 */
#ifndef COULOMBTETHER_TESTS_ANSWER_H
#define COULOMBTETHER_TESTS_ANSWER_H

#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "evaluate/reference.h"

enum { MOST_NUMBERS = 40, OUTPUTS = 16, LONGEST = 4096 };

struct asked {
    char operation[40], id[100];
    double in[MOST_NUMBERS], out[OUTPUTS];
    int inputs, outputs;
    bool known, valid;
};

static inline bool equal(double x, double y)
{
    return !(x < y) && !(x > y) && !isnan(x);
}

static inline void compute(struct asked *a)
{
    reference_function *function = reference_find(a->operation);
    const double unset = -0x1.23456789abcdep-1000; /* ref/ does not tell how many outputs there are: it sets them */
    for (int i = 0; i < OUTPUTS; i++)
        a->out[i] = unset;
    a->known = function != NULL;
    if (a->known)
        function(a->in, a->out);
    for (a->outputs = 0; a->outputs < OUTPUTS && !equal(a->out[a->outputs], unset); a->outputs++)
        continue;
    a->valid = a->known && !isnan(a->out[0]); /* outside the domain ref/ says NaN */
}

static inline void understand(struct asked *a, char *line)
{
    char *rest = NULL, *word = strtok_r(line, " \t\r\n", &rest);
    *a = (struct asked){.outputs = 1};
    snprintf(a->operation, sizeof a->operation, "%s", word ? word : "");
    word = strtok_r(NULL, " \t\r\n", &rest);
    snprintf(a->id, sizeof a->id, "%s", word ? word : "");
    while (a->inputs < MOST_NUMBERS && (word = strtok_r(NULL, " \t\r\n", &rest)) != NULL)
        a->in[a->inputs++] = strtod(word, NULL);
}

static inline void say(const struct asked *a, const char *end)
{
    fputs(a->id, stdout);
    if (!a->valid)
        fputs(a->known ? " invalid" : " skip unknown operation", stdout);
    for (int i = 0; i < a->outputs && a->valid; i++)
        printf(" %.17g", a->out[i]);
    fputs(end, stdout);
}

#endif
