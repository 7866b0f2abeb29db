/* The graph of equations and steps: what it reaches, and how it looks. Shapes tell what a node is, not colours. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "derivation.h"

/* ---- what the steps together reach ---- */

bool stands_for(const char *entry, const char *equation)
{
    const size_t length = strlen(entry);
    return strncmp(entry, equation, length) == 0 && (equation[length] < '0' || equation[length] > '9');
}

struct ground {
    const char *equation;
    bool reached;
};

/* An entry of `from` is firm when all equations that it stands for are reached; a principle always is. */
static bool is_firm(const struct ground *g, int count, const char *entry)
{
    for (int i = 0; i < count; i++)
        if (stands_for(entry, g[i].equation) && !g[i].reached)
            return false;
    return true;
}

static bool advance(const struct step *s, struct ground *g, int count)
{
    bool news = false;
    for (int i = 0; i < s->from_count; i++)
        if (!is_firm(g, count, s->from[i]))
            return false;
    for (int i = 0; i < count; i++)
        for (int k = 0; k < s->to_count && !g[i].reached; k++)
            news |= g[i].reached = stands_for(s->to[k], g[i].equation);
    return news;
}

const char *derivations_gap(const struct derivations *d)
{
    struct ground *g = NULL;
    const char *gap = NULL;
    int count = 0;
    for (int i = 0; i < d->sheet->section_count; i++) {
        const struct section *s = &d->sheet->sections[i];
        for (int k = 0; k < s->numbers; k++) {
            g = memory(g, (size_t)count + 1, sizeof *g);
            g[count++] = (struct ground){s->equations[k], s->method == METHOD_NONE};
        }
    }
    for (bool news = true; news;) {
        news = false;
        for (int i = 0; i < d->step_count; i++)
            news |= advance(&d->steps[i], g, count);
    }
    for (int i = 0; i < count && gap == NULL; i++)
        gap = g[i].reached ? NULL : g[i].equation;
    free(g);
    return gap;
}

/* ---- for Graphviz ---- */

/* "6a" and "6b" are the node 6; a principle is its own. */
static int node_name_length(const char *entry)
{
    size_t digits = strspn(entry, "0123456789");
    return (int)(digits > 0 ? digits : strlen(entry));
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
    enum { MOST = 100 };
    for (int number = 1; number < MOST; number++) {
        char text[16];
        snprintf(text, sizeof text, "%d", number);
        const struct section *s = section_of(sheet, text);
        if (s == NULL)
            continue;
        printf("  \"%s\" [shape=%s, label=\"", text, s->method == METHOD_NONE ? "doubleoctagon" : "ellipse");
        const char *separator = "";
        for (int k = 0; k < s->numbers; k++)
            if (same_node(s->equations[k], text)) {
                printf("%s%s", separator, s->equations[k]);
                separator = " ";
            }
        printf("\", tooltip=");
        print_quoted(s->title);
        puts("];");
    }
}

/* An edge a node, however many of its parts the step names. */
static void print_edges(const struct step *s, const char *const *ends, int count, bool from)
{
    for (int i = 0; i < count; i++) {
        bool drawn = false;
        for (int k = 0; k < i; k++)
            drawn = drawn || same_node(ends[k], ends[i]);
        const int length = node_name_length(ends[i]);
        if (!drawn && from)
            printf("  \"%.*s\" -> \"%s\" [arrowhead=none];\n", length, ends[i], s->id);
        else if (!drawn)
            printf("  \"%s\" -> \"%.*s\";\n", s->id, length, ends[i]);
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
    for (int i = 0; i < d->principle_count; i++) {
        printf("  \"%s\" [shape=house, tooltip=", d->principles[i].id);
        print_quoted(d->principles[i].text);
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
        print_edges(s, s->from, s->from_count, true);
        print_edges(s, s->to, s->to_count, false);
    }
    puts("}");
}
