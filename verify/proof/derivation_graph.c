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

/* Whether all that an entry stands for is reached; a principle always is. It may be reached from now on. */
static bool is_reached(const struct derivations *d, struct ground *g, int count, const char *entry, bool from_now_on)
{
    struct entry_part parts[MOST_PARTS];
    const int most = entry_parts(d, entry, parts);
    bool all = true;
    for (int i = 0; i < count; i++)
        for (int k = 0; k < most; k++)
            if (same_part(&g[i].part, &parts[k])) {
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

/* "6a", "eq06" and "eq06.x1" are the node 6; what begins with no number, and what it has, is its own. */
static void print_node(const char *entry)
{
    const char *number = entry + (strncmp(entry, "eq", 2) == 0 ? 2 : 0);
    number += strspn(number, "0");
    const int digits = (int)strspn(number, "0123456789");
    printf("\"%.*s\"", digits > 0 ? digits : (int)strcspn(entry, "."), digits > 0 ? number : entry);
}

/* Within quotation marks. */
static void print_text(const char *text)
{
    for (; *text != '\0'; text++)
        printf(*text == '"' || *text == '\\' ? "\\%c" : "%c", *text);
}

/* Backwards: of several sections of one number the first has the last word. */
static void print_equations(const struct sheet *sheet)
{
    for (int i = sheet->section_count; i-- > 0;)
        for (int k = 0; k < sheet->sections[i].numbers; k++) {
            const struct section *s = &sheet->sections[i];
            print_node(s->equations[k]);
            printf(" [shape=%s, tooltip=\"", s->method == METHOD_NONE ? "doubleoctagon" : "ellipse");
            print_text(s->title);
            puts("\"];");
        }
}

void derivations_graph(const struct derivations *d)
{
    puts("strict digraph derivations {\n" /* one edge between two nodes, however many parts of one the step names */
         "  ranksep=0.22; nodesep=0.14; fontname=\"Helvetica\"; node [fontname=\"Helvetica\", fontsize=12];\n"
         "  subgraph cluster_legend {\n"
         "    principle [shape=house]; definition [shape=doubleoctagon]; equation [shape=ellipse];\n"
         "    step [shape=box, fontsize=10, height=0.2, margin=\"0.05,0.03\"];\n"
         "  }");
    for (int i = 0; i < d->definitions.count; i++) {
        printf("  \"%s\" [shape=%s, tooltip=\"", d->definitions.sections[i].id, i < d->principle_count ? "house" : "note");
        print_text(d->definitions.sections[i].title);
        puts("\"];");
    }
    print_equations(d->sheet);
    puts("  node [shape=box, fontsize=10, height=0.2, margin=\"0.05,0.03\"];");
    for (int i = 0; i < d->step_count; i++) {
        const struct step *s = &d->steps[i];
        printf("  \"%s\" [label=\"", s->id);
        for (const char *c = s->id; *c != '\0'; c++)
            putchar(*c == '_' ? ' ' : *c);
        printf("\", tooltip=\"");
        print_text(s->title);
        puts("\"];");
        for (int k = 0; k < s->from_count + s->to_count; k++) {
            print_node(k < s->from_count ? s->from[k] : s->id);
            printf(" -> ");
            print_node(k < s->from_count ? s->id : s->to[k - s->from_count]);
            puts(k < s->from_count ? " [arrowhead=none];" : ";");
        }
    }
    puts("}");
}
