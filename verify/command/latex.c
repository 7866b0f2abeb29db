#include "command/latex.h"

#include <stdlib.h>
#include <string.h>

/* One side of something: a formula that was understood when the sheet was read. */
static void add_formula(struct tex *t, struct program *symbols, const char *text)
{
    typeset_formula(t, symbols, program_parse(symbols, text, NULL));
}

/* "left SIGN right" with an alignment mark; the sign is the first of = > >= < in it. */
static void json_comparison(struct json *j, const char *kind, const char *number, struct program *symbols, const char *name,
                            const char *text)
{
    const size_t left = strcspn(text, "=<>");
    const size_t sign = strspn(text + left, "=<>");
    struct tex t = {NULL, 0};
    char *copy = text_copy(text);
    copy[left] = '\0';
    add_formula(&t, symbols, copy);
    tex_add(&t, " &%s ", sign == 2 ? "\\ge" : (const char[]){text[left], '\0'});
    add_formula(&t, symbols, copy + left + sign);
    json_record(j, NULL, "kind", kind, "equation", number, "defines", name, "tex", t.text);
    tex_clear(&t);
    free(copy);
}

static void json_definition(struct json *j, const char *kind, const char *number, struct program *symbols, const char *name,
                            const char *formula)
{
    struct tex t = {NULL, 0};
    tex_add(&t, "%s = %s", name, formula);
    json_comparison(j, kind, number, symbols, name, t.text);
    tex_clear(&t);
}

static void json_outputs(struct json *j, const struct section *s, const char *kind, struct program *symbols,
                         const struct formulas *f)
{
    for (int i = 0; i < s->output_count; i++) {
        bool alone;
        const char *number = output_equation(s, i, &alone);
        json_definition(j, kind, alone ? number : "", symbols, s->outputs[i]->name, f->text[i]);
    }
}

/* Symbols are all quantities, and the section's own named subexpressions. */
static void symbols_init(struct program *symbols, const struct section *s)
{
    const struct formulas *const own[] = {&s->corrected, &s->printed};
    program_init(symbols);
    for (int i = 0; i < s->sheet->quantity_count; i++)
        program_input(symbols, s->sheet->quantities[i].name);
    for (int k = 0; k < 2; k++)
        for (int i = 0; i < own[k]->lets; i++)
            program_input(symbols, own[k]->let[2 * i]);
}

void json_display(struct json *j, const struct section *s)
{
    struct program symbols;
    symbols_init(&symbols, s);
    json_open(j, "display", '[');
    for (int i = 0; i < s->relation_count; i++)
        json_comparison(j, "relation", s->relations[i].equation, &symbols, "", s->relations[i].text);
    if (s->method == METHOD_FORMULA) {
        json_outputs(j, s, "output", &symbols, &s->corrected);
        for (int i = 0; i < s->corrected.lets; i++)
            json_definition(j, "let", "", &symbols, s->corrected.let[2 * i], s->corrected.let[2 * i + 1]);
        for (int i = 0; i < s->corrected.count; i++)
            json_comparison(j, "domain", "", &symbols, "", s->corrected.conditions[i].text);
    }
    if (s->differs)
        json_outputs(j, s, "printed", &symbols, &s->printed);
    json_close(j);
    program_clear(&symbols);
}

/* ---- the sides of a step's equalities ---- */

/* A symbol by its name, or where that is in braces by its LaTeX. */
static int add_symbol(struct parser *p, const char *name)
{
    const int node = program_append(p->program, OPERATOR_INPUT, -1, -1, 0);
    program_name(p->program, node, name);
    return node;
}

/* eq14.L_dot(psi = 1), gravity.a_x: the output, below it the number or name of what it is of, and what it is taken at. */
static int set_output(struct parser *p, const char *id)
{
    struct tex t = {NULL, 0};
    char word[LONGEST_NAME + 1];
    const int digits = strncmp(id, "eq", 2) == 0 ? (int)strspn(id + 2, "0123456789") : 0;
    p->at++;
    parse_word(p, word);
    tex_add(&t, strstr(word, "dot") != NULL ? "{{{}" : "{{"); /* TeX takes a group of an accent alone for the accent itself */
    typeset_symbol(&t, word);
    if (digits > 0) /* eq03, eq10lin */
        tex_add(&t, "}_{(%ld%s%s%s", strtol(id + 2, NULL, 10), id[2 + digits] ? "\\mathrm{" : "", id + 2 + digits,
                id[2 + digits] ? "}" : "");
    else
        tex_add(&t, "}_{\\mathrm{%s}", id);
    if (*p->at == '@') {
        p->at++;
        parse_word(p, word);
        tex_add(&t, "\\,\\mathrm{%s}", word);
    }
    tex_add(&t, digits > 0 ? ")}" : "}");
    const char *separator = "(";
    while (*p->at == '(' || (*separator == ',' && parse_symbol(p, ','))) {
        p->at += *separator == '(';
        parse_word(p, word);
        parse_symbol(p, '=');
        const int node = parse_sum(p);
        tex_add(&t, "%s", separator);
        typeset_symbol(&t, word);
        tex_add(&t, " = ");
        typeset_formula(&t, p->program, node);
        separator = ",\\, ";
    }
    tex_add(&t, *separator == ',' && parse_symbol(p, ')') ? ")}" : "}");
    const int result = add_symbol(p, t.text);
    tex_clear(&t);
    return result;
}

/* The side itself. */
static int set_relation(struct parser *p, bool right)
{
    char number[LONGEST_NAME + 1], index[LONGEST_NAME + 1] = "1";
    const struct section *section;
    p->at++;
    parse_word(p, number);
    if (parse_symbol(p, ','))
        parse_word(p, index);
    parse_symbol(p, ')');
    const struct formulas *sides = &relation_find(p->context, number, index, &section)->sides;
    int *here = xrealloc(NULL, (size_t)sides->program.count, sizeof *here);
    for (int i = 0; i < sides->program.count; i++)
        here[i] = i < sides->program.inputs ? program_find(p->program, sides->program.names[i].text) : -1;
    const int node = program_copy_node(p->program, &sides->program, sides->outputs[right], here);
    free(here);
    return node;
}

/* A dot above a symbol that has one at most, and of all else d/dt. */
static int set_rate(struct parser *p)
{
    struct tex t = {NULL, 0};
    p->at++;
    const int node = parse_sum(p);
    const char *name = "{";
    for (int i = 0; i < p->program->named; i++)
        name = p->program->names[i].node == node ? p->program->names[i].text : name;
    const size_t length = strlen(name), stem = length > 4 && strcmp(name + length - 4, "_dot") == 0 ? length - 4 : length;
    const bool symbol = p->program->nodes[node].op == OPERATOR_INPUT;
    parse_symbol(p, ')');
    if (symbol && *name != '{' && strstr(name, stem < length ? "_dot_" : "dot") == NULL) {
        tex_add(&t, "%.*s%s", (int)stem, name, stem < length ? "_ddot" : "_dot");
    } else {
        tex_add(&t, symbol ? "{\\frac{d}{dt}" : "{\\frac{d}{dt}\\left(");
        typeset_formula(&t, p->program, node);
        tex_add(&t, symbol ? "}" : "\\right)}");
    }
    const int result = add_symbol(p, t.text);
    tex_clear(&t);
    return result;
}

static int set_reference(struct parser *p, const char *name)
{
    return *p->at == '.' ? set_output(p, name) : strcmp(name, "rate") == 0 ? set_rate(p) : set_relation(p, name[0] == 'r');
}

void typeset_side(struct tex *t, const struct sheet *sheet, const struct identities *names, const char *text)
{
    struct program symbols;
    struct message why;
    size_t where;
    struct sheet context = *sheet; /* the parser hands it on as it is */
    program_init(&symbols);
    for (int i = 0; i < names->program.named; i++)
        program_input(&symbols, names->program.names[i].text);
    typeset_formula(t, &symbols, program_parse_with(&symbols, text, set_reference, &context, &where, &why));
    program_clear(&symbols);
}
