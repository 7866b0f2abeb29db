/*
 * Golden vectors: the paper's case, the same with each input changed in turn, random ones, the sheet's
 * own, and one defect each. Their ids never change: new ones may join, none is renamed.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "decimal.h"
#include "sample.h"
#include "vectors.h"

enum { MOST_INPUTS = 40, RANDOM = 10 };

struct golden {
    struct operation o;
    const char *base[MOST_INPUTS]; /* the paper's case */
    golden_receiver *receive;
    void *context;
    bool fine;
};

static void hand_on(struct golden *g, const char *name, const char *const *texts, const char *flags)
{
    char id[96];
    snprintf(id, sizeof id, "%s-%s", g->o.section->id, name);
    g->fine = g->fine && g->receive(g->context, &g->o, id, texts, flags);
}

/* The base with one input replaced, or two masses. */
static void replaced(struct golden *g, const char *how, int i, const char *text, const char *flags)
{
    const char *texts[MOST_INPUTS];
    char name[80];
    memcpy(texts, g->base, sizeof texts);
    texts[i] = text;
    snprintf(name, sizeof name, "%s-%s", how, g->o.section->inputs[i]->name);
    hand_on(g, name, texts, flags);
}

static int place(const struct section *s, const char *name)
{
    for (int i = 0; i < s->input_count; i++)
        if (strcmp(s->inputs[i]->name, name) == 0)
            return i;
    return -1;
}

/* The paper's masses are equal, which hides which is which. */
static void unequal_masses(struct golden *g)
{
    static const char *const ratios[][3] = {
        {"mass-1-3", "100", "300"}, {"mass-1000-1", "1000", "1"}, {"mass-1-1000", "1", "1000"}};
    int m1 = place(g->o.section, "m1"), m2 = place(g->o.section, "m2");
    for (int k = 0; k < 3 && m1 >= 0 && m2 >= 0; k++) {
        const char *texts[MOST_INPUTS];
        memcpy(texts, g->base, sizeof texts);
        texts[m1] = ratios[k][1];
        texts[m2] = ratios[k][2];
        hand_on(g, ratios[k][0], texts, "unequal-masses");
    }
}

/* One input at a time: its sign, zero, a billion times as large or as small. */
static void one_changed(struct golden *g, int i)
{
    const struct quantity *q = g->o.section->inputs[i];
    const double value = strtod(g->base[i], NULL);
    char text[32];
    if (q->either_sign) {
        decimal_shortest(text, -value);
        if (value != 0.0)
            replaced(g, "sign", i, text, "sign");
        replaced(g, "zero", i, "0", "zero");
    }
    if (value == 0.0)
        return;
    decimal_shortest(text, ldexp(value, 30));
    replaced(g, "large", i, text, "large");
    decimal_shortest(text, ldexp(value, -30));
    replaced(g, "small", i, text, "small");
}

/* What the domain has to refuse, one defect at a time. */
static void defects(struct golden *g, int i)
{
    const struct quantity *q = g->o.section->inputs[i];
    replaced(g, "nan", i, "nan", "");
    if (q->domain != DOMAIN_POSITIVE_OR_INFINITE)
        replaced(g, "inf", i, "inf", "");
    if (q->domain == DOMAIN_FINITE) {
        replaced(g, "minus-inf", i, "-inf", "");
        return;
    }
    replaced(g, "negative", i, "-1", "");
    if (q->domain != DOMAIN_NOT_NEGATIVE)
        replaced(g, "zero", i, "0", "");
}

static void random_vectors(struct golden *g)
{
    const struct section *s = g->o.section;
    struct input *inputs = inputs_new(s->input_count);
    double values[MOST_INPUTS];
    char decimals[MOST_INPUTS][32], name[32];
    const char *texts[MOST_INPUTS] = {NULL};
    for (int k = 1; k <= RANDOM; k++) {
        sample(&g->o, 0, (uint64_t)k, values, inputs);
        for (int i = 0; i < s->input_count; i++) {
            decimal_shortest(decimals[i], values[i]);
            texts[i] = decimals[i];
        }
        snprintf(name, sizeof name, "random-%d", k);
        hand_on(g, name, texts, "random");
    }
    inputs_free(inputs, s->input_count);
}

/* One of the sheet's own; where it names several times, a vector each. */
static void special(struct golden *g, const struct special *special)
{
    const char *texts[MOST_INPUTS];
    int t = place(g->o.section, "t");
    for (int i = 0; i < g->o.section->input_count; i++)
        texts[i] = special->texts[i] ? special->texts[i] : g->base[i];
    if (t < 0 || special->texts[t] == NULL || strchr(special->texts[t], ' ') == NULL) {
        hand_on(g, special->name, texts, strcmp(special->flags, "invalid") == 0 ? "" : special->flags);
        return;
    }
    char *times = text_copy(special->texts[t]), *rest = NULL, name[80];
    for (char *time = strtok_r(times, " ", &rest); time; time = strtok_r(NULL, " ", &rest)) {
        texts[t] = time;
        snprintf(name, sizeof name, "%s-%s", special->name, time);
        hand_on(g, name, texts, special->flags);
    }
    free(times);
}

bool golden_each(const struct section *s, golden_receiver *receive, void *context)
{
    struct golden g = {.receive = receive, .context = context, .fine = true};
    operation_init(&g.o, s, false);
    for (int i = 0; i < s->input_count; i++)
        g.base[i] = s->inputs[i]->value ? s->inputs[i]->value : s->inputs[i]->example;
    if (s->method == METHOD_FORMULA || s->method == METHOD_ROOTS) {
        hand_on(&g, "paper", g.base, "paper");
        unequal_masses(&g);
        random_vectors(&g);
        for (int i = 0; i < s->input_count; i++)
            one_changed(&g, i);
        for (int i = 0; i < s->input_count; i++)
            defects(&g, i);
    }
    for (int i = 0; i < s->special_count && g.fine; i++)
        special(&g, &s->specials[i]);
    if (!g.fine)
        fprintf(stderr, "coulomb-tether: %s\n", g.o.why.text);
    operation_clear(&g.o);
    return g.fine;
}

static bool print(void *context, struct operation *o, const char *id, const char *const *texts, const char *flags)
{
    const enum input_form *form = context;
    return vector_print(o, id, texts, flags, *form);
}

bool vectors_golden(const struct section *s, enum input_form form)
{
    vectors_header(s);
    return golden_each(s, print, &form);
}
