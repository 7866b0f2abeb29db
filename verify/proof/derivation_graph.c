/* The graph of equations and steps: what it reaches, and how it looks. Shapes tell what a node is, not colours. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "proof/derivation.h"

/* ---- what the steps together reach ---- */

struct ground {
    struct entry_part part;
    bool reached;
};

/* An entry of `from` is firm when all that it stands for is reached; a principle always is. */
static bool is_firm(const struct derivations *d, const struct ground *g, int count, const char *entry)
{
    struct entry_part parts[MOST_PARTS];
    const int most = entry_parts(d, entry, parts);
    for (int i = 0; i < count; i++)
        for (int k = 0; k < most && !g[i].reached; k++)
            if (same_part(&g[i].part, &parts[k]))
                return false;
    return true;
}

static bool advance(const struct derivations *d, const struct step *s, struct ground *g, int count)
{
    struct entry_part parts[MOST_PARTS];
    bool news = false;
    for (int i = 0; i < s->from_count; i++)
        if (!is_firm(d, g, count, s->from[i]))
            return false;
    for (int e = 0; e < s->to_count; e++) {
        const int most = entry_parts(d, s->to[e], parts);
        for (int i = 0; i < count; i++)
            for (int k = 0; k < most && !g[i].reached; k++)
                news |= g[i].reached = same_part(&g[i].part, &parts[k]);
    }
    return news;
}

static void add_ground(struct ground **g, int *count, struct entry_part part)
{
    for (int i = 0; i < *count; i++)
        if (same_part(&(*g)[i].part, &part))
            return;
    APPENDED(*g, *count)->part = part;
}

/* A step that leaves a named subexpression open speaks of the rest of a formula alone: that is to be reached too. */
static void add_open(const struct derivations *d, const struct identities *t, const struct section *s, struct ground **g, int *count)
{
    const struct program *p = &s->corrected.program;
    for (int k = p->inputs; k < p->named && s->numbers > 0; k++) {
        const int here = program_find(&t->program, p->names[k].text);
        if (here >= d->sheet->quantity_count && here < t->program.inputs)
            add_ground(g, count, (struct entry_part){s, &s->corrected, p->names[k].node, p->names[k].text, s->equations[0]});
    }
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
                    add_ground(&g, &count, parts[j]);
    }
    for (int i = 0; i < d->step_count; i++)
        for (int u = 0; u < d->steps[i].corrected.use_count; u++)
            add_open(d, &d->steps[i].corrected, d->steps[i].corrected.uses[u].section, &g, &count);
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

/* ---- for Graphviz ---- */

/* "6a" and "6b" are the node 6, and so is an entry of its section; a principle is its own. */
static int node_name_length(const char *entry)
{
    size_t digits = strspn(entry, "0123456789");
    return (int)(digits > 0 ? digits : strlen(entry));
}

/* The equation number that an entry stands for first; of a principle or a property, itself. */
static const char *number_of(const struct derivations *d, const char *entry)
{
    struct entry_part parts[MOST_PARTS];
    return entry_parts(d, entry, parts) == 0 ? entry : parts[0].equation ? parts[0].equation : parts[0].section->id;
}

static bool same_node(const char *a, const char *b)
{
    const int length = node_name_length(a);
    return length == node_name_length(b) && strncmp(a, b, (size_t)length) == 0;
}

static void print_quoted(const char *text)
{
    putchar('"');
    for (; *text != '\0'; text++)
        printf(*text == '"' || *text == '\\' ? "\\%c" : "%c", *text);
    putchar('"');
}

/* The section that has the equation of this number, or a part of it, first. */
static const struct section *section_of(const struct sheet *sheet, const char *number)
{
    for (int i = 0; i < sheet->section_count; i++)
        for (int k = 0; k < sheet->sections[i].numbers; k++)
            if (same_node(sheet->sections[i].equations[k], number))
                return &sheet->sections[i];
    return NULL;
}

static void print_equations(const struct sheet *sheet)
{
    for (int i = 0; i < sheet->section_count; i++)
        for (int k = 0; k < sheet->sections[i].numbers; k++) {
            const struct section *s = &sheet->sections[i];
            if (section_of(sheet, s->equations[k]) != s || (k > 0 && same_node(s->equations[k - 1], s->equations[k])))
                continue;
            printf("  \"%.*s\" [shape=%s, tooltip=", node_name_length(s->equations[k]), s->equations[k],
                   s->method == METHOD_NONE ? "doubleoctagon" : "ellipse");
            print_quoted(s->title);
            puts("];");
        }
}

/* An edge a node, however many of its parts the step names. */
static void print_edges(const struct derivations *d, const struct step *s, const char *const *ends, int count, bool from)
{
    for (int i = 0; i < count; i++) {
        const char *end = number_of(d, ends[i]);
        bool drawn = false;
        for (int k = 0; k < i; k++)
            drawn = drawn || same_node(number_of(d, ends[k]), end);
        const int length = node_name_length(end);
        if (!drawn && from)
            printf("  \"%.*s\" -> \"%s\" [arrowhead=none];\n", length, end, s->id);
        else if (!drawn)
            printf("  \"%s\" -> \"%.*s\";\n", s->id, length, end);
    }
}

void derivations_graph(const struct derivations *d)
{
    puts("digraph derivations {\n"
         "  ranksep=0.22; nodesep=0.14; fontname=\"Helvetica\"; node [fontname=\"Helvetica\", fontsize=12];\n"
         "  subgraph cluster_legend {\n"
         "    principle [shape=house]; definition [shape=doubleoctagon]; equation [shape=ellipse];\n"
         "    step [shape=box, fontsize=10, height=0.2, margin=\"0.05,0.03\"];\n"
         "  }");
    for (int i = 0; i < d->definitions.count; i++) {
        printf("  \"%s\" [shape=%s, tooltip=", d->definitions.sections[i].id, i < d->principle_count ? "house" : "note");
        print_quoted(d->definitions.sections[i].title);
        puts("];");
    }
    print_equations(d->sheet);
    puts("  node [shape=box, fontsize=10, height=0.2, margin=\"0.05,0.03\"];");
    for (int i = 0; i < d->step_count; i++) {
        const struct step *s = &d->steps[i];
        printf("  \"%s\" [label=\"", s->id);
        for (const char *c = s->id; *c != '\0'; c++)
            putchar(*c == '_' ? ' ' : *c);
        printf("\", tooltip=");
        print_quoted(s->title);
        puts("];");
        print_edges(d, s, s->from, s->from_count, true);
        print_edges(d, s, s->to, s->to_count, false);
    }
    puts("}");
}
