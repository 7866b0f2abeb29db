/* The graph of equations and steps: what the steps together reach. */
#include <stdlib.h>

#include "proof/derivation.h"

struct ground {
    struct entry_part part;
    bool reached;
};

/* Whether all that an entry stands for is reached; a principle always is. It may be reached from now on. */
static bool is_reached(const struct derivations *d, struct ground *g, int count, const char *entry, bool from_now_on)
{
    struct entry_part parts[MOST_PARTS];
    const int most = entry_parts(d, entry, parts);
    bool all = true;
    for (int i = 0; i < count; i++)
        for (int k = 0; k < most; k++)
            if (g[i].part.formulas == parts[k].formulas && g[i].part.node == parts[k].node) {
                all = all && g[i].reached;
                g[i].reached = g[i].reached || from_now_on;
            }
    return all;
}

/* Whether the step reaches something new. */
static bool advance(const struct derivations *d, const struct step *s, struct ground *g, int count)
{
    bool news = false;
    for (int i = 0; i < s->from_count; i++)
        if (!is_reached(d, g, count, s->from[i], false))
            return false;
    for (int i = 0; i < s->to_count; i++)
        news |= !is_reached(d, g, count, s->to[i], true);
    return news;
}

/* A step that leaves a named subexpression open speaks of the rest of a formula alone: that is to be reached too. */
static void add_open(const struct identities *t, const struct section *s, struct ground **g, int *count)
{
    const struct program *p = &s->corrected.program;
    for (int k = p->inputs; k < p->named; k++)
        if (is_free_name(t, p->names[k].text))
            *APPENDED(*g, *count) = (struct ground){{s, &s->corrected, p->names[k].node, p->names[k].text, s->equations[0]}, false};
}

const char *derivations_gap(const struct derivations *d)
{
    struct ground *g = NULL;
    struct entry_part parts[MOST_PARTS];
    const char *gap = NULL;
    int count = 0;
    for (int i = 0; i < d->sheet->section_count; i++) {
        const struct section *s = &d->sheet->sections[i];
        for (int k = 0; k < s->numbers && s->method == METHOD_FORMULA; k++)
            for (int j = entry_parts(d, s->equations[k], parts); j-- > 0;)
                if (parts[j].section == s)
                    *APPENDED(g, count) = (struct ground){parts[j], false};
    }
    for (int i = 0; i < d->step_count; i++)
        for (int u = 0; u < d->steps[i].corrected.use_count; u++)
            add_open(&d->steps[i].corrected, d->steps[i].corrected.uses[u].section, &g, &count);
    for (bool news = true; news;) {
        news = false;
        for (int i = 0; i < d->step_count; i++)
            news |= advance(d, &d->steps[i], g, count);
    }
    for (int i = 0; i < count && gap == NULL; i++)
        gap = g[i].reached ? NULL : g[i].part.equation;
    free(g);
    return gap;
}
