#include "formula/typeset.h"

#include <ctype.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

void tex_clear(struct tex *t)
{
    free(t->text);
    *t = (struct tex){NULL, 0};
}

void tex_add(struct tex *t, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    const int length = vsnprintf(NULL, 0, format, arguments);
    va_end(arguments);
    t->text = xrealloc(t->text, t->length + (size_t)length + 1, 1);
    va_start(arguments, format);
    vsnprintf(t->text + t->length, (size_t)length + 1, format, arguments);
    va_end(arguments);
    t->length += (size_t)length;
}

/* ---- symbols ---- */

static bool is(const char *word, const char *text, int length)
{
    return (int)strlen(word) == length && strncmp(word, text, (size_t)length) == 0;
}

static bool is_greek(const char *word, int length)
{
    static const char *const letters[] = {"Omega", "psi", "theta", "lambda", "phi", "kappa", "mu", "tau", "rho",
                                          "delta", "omega", "pi", "eta"};
    for (size_t i = 0; i < sizeof letters / sizeof *letters; i++)
        if (is(letters[i], word, length))
            return true;
    return false;
}

/* dL, dQ */
static bool is_variation(const char *name)
{
    return name[0] == 'd' && isupper((unsigned char)name[1]);
}

/* The letters of a name, before any index and accent. */
static void add_letters(struct tex *t, const char *letters, int length, const char *accent)
{
    if (is_variation(letters)) {
        tex_add(t, "\\delta ");
        letters++;
        length--;
    }
    if (*accent != '\0')
        tex_add(t, "%s", accent);
    if (is_greek(letters, length))
        tex_add(t, "\\%.*s ", length, letters);
    else if (is("eps", letters, length))
        tex_add(t, "\\varepsilon ");
    else if (length == 1)
        tex_add(t, "%s", *letters == 'w' ? "\\omega " : (const char[]){*letters, '\0'});
    else if (length == 2 && isupper((unsigned char)letters[0]))
        tex_add(t, "{%.*s}", length, letters);
    else
        tex_add(t, "\\mathrm{%.*s}", length, letters);
}

/* One more index: one letter, and digits after it or not, in italics; a word upright. */
static void add_index(struct tex *t, const char *index, int length)
{
    const bool word = isalpha((unsigned char)index[1]);
    tex_add(t, word ? "\\mathrm{%.*s}" : "%.*s", length, index);
}

void typeset_symbol(struct tex *t, const char *name)
{
    const int letters = (int)strspn(name, "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ");
    const char *rest = name + letters, *accent = "";
    struct tex index = {NULL, 0};
    while (*rest != '\0') {
        rest += *rest == '_';
        const int length = (int)strcspn(rest, "_");
        if (is("dot", rest, length))
            accent = "\\dot ";
        else if (is("ddot", rest, length))
            accent = "\\ddot ";
        else
            add_index(&index, rest, length);
        rest += length;
    }
    add_letters(t, name, letters, accent);
    if (index.length > 0)
        tex_add(t, "_{%s}", index.text);
    tex_clear(&index);
}

/* ---- formulas ---- */

/* What a formula is written into, and how tightly its outermost operator binds. */
struct writer {
    struct tex *tex;
    const struct program *program;
    bool flat; /* in an exponent: a/b in place of a fraction */
};

/* How tightly it binds: sin x has to be bracketed to be raised, as a product has. */
enum tightness { SUM, BINDS_PRODUCT, POWER, ATOM };

/* The name of a function; or what stands before, between and after the operands, and how tightly these have to bind. */
static const struct {
    enum tightness tightness;
    const char *function, *before, *between, *after;
    enum tightness left, right;
} operators[] = {
    [OPERATOR_ADD] = {SUM, NULL, "", " + ", "", SUM, SUM},
    [OPERATOR_SUBTRACT] = {SUM, NULL, "", " - ", "", SUM, BINDS_PRODUCT},
    [OPERATOR_NEGATE] = {SUM, NULL, "-", "", "", BINDS_PRODUCT, SUM},
    [OPERATOR_MULTIPLY] = {.tightness = BINDS_PRODUCT},
    [OPERATOR_DIVIDE] = {.tightness = BINDS_PRODUCT},
    [OPERATOR_SIN] = {BINDS_PRODUCT, .function = "sin"},
    [OPERATOR_COS] = {BINDS_PRODUCT, .function = "cos"},
    [OPERATOR_LOG] = {BINDS_PRODUCT, .function = "ln"},
    [OPERATOR_POWER] = {.tightness = POWER},
    [OPERATOR_EXP] = {POWER, NULL, "e^{", "", "}", SUM, SUM},
    [OPERATOR_INPUT] = {.tightness = ATOM},
    [OPERATOR_NUMBER] = {.tightness = ATOM},
    [OPERATOR_SQRT] = {ATOM, NULL, "\\sqrt{", "", "}", SUM, SUM},
    [OPERATOR_ATAN2] = {ATOM, NULL, "\\operatorname{atan2}\\left(", ",\\, ", "\\right)", SUM, SUM},
    [OPERATOR_POSITIVE] = {.tightness = ATOM},
};

static void write_node(const struct writer *w, int node, enum tightness least);

static enum tightness tightness_of(const struct program *p, int node)
{
    return operators[p->nodes[node].op].tightness;
}

static bool is_function(const struct program *p, int node)
{
    return operators[p->nodes[node].op].function != NULL;
}

static const char *input_name(const struct program *p, int node)
{
    int i = 0;
    while (p->names[i].node != node)
        i++;
    return p->names[i].text;
}

/* Whether it is an input whose name is set upright, as a word */
static bool is_word(const struct program *p, int node)
{
    struct tex t = {NULL, 0};
    if (p->nodes[node].op != OPERATOR_INPUT)
        return false;
    typeset_symbol(&t, input_name(p, node));
    const bool word = strncmp(t.text, "\\mathrm", strlen("\\mathrm")) == 0;
    tex_clear(&t);
    return word;
}

/* In brackets as high as what they hold. */
static void write_brackets(const struct writer *w, int node, const char *left, const char *right)
{
    struct tex inside = {NULL, 0};
    const struct writer inner = {&inside, w->program, w->flat};
    write_node(&inner, node, SUM);
    const bool high = strstr(inside.text, "\\frac") != NULL || strstr(inside.text, "\\sqrt") != NULL;
    tex_add(w->tex, high ? "\\left%s%s\\right%s" : "%s%s%s", left, inside.text, right);
    tex_clear(&inside);
}

/* A product or quotient, taken apart: its factors from left to right, each above or below the line. */
struct factors {
    struct factor {
        int node;
        bool below;
    } *list;
    int count;
    bool negative;
};

static void collect(const struct program *p, int node, bool below, struct factors *f)
{
    const struct node *n = &p->nodes[node];
    const bool quotient = n->op == OPERATOR_DIVIDE;
    if (n->op == OPERATOR_MULTIPLY || (quotient && !below)) {
        collect(p, n->left, below, f);
        collect(p, n->right, below || quotient, f);
    } else if (n->op == OPERATOR_NEGATE && f->count == 0) {
        f->negative = true;
        collect(p, n->left, below, f);
    } else {
        *APPENDED(f->list, f->count) = (struct factor){node, below};
    }
}

/* Factors from first to last - 1, side by side, in brackets where they bind less than `least`. */
static void write_factors(const struct writer *w, const struct factors *f, int first, int last, enum tightness least)
{
    bool apart = false; /* from what comes next */
    for (int i = first; i < last; i++) {
        const int node = f->list[i].node;
        const bool function = is_function(w->program, node), word = is_word(w->program, node);
        if (i > first && w->program->nodes[node].op == OPERATOR_NUMBER)
            tex_add(w->tex, "\\cdot ");
        else if (i > first && !function && (apart || word))
            tex_add(w->tex, "\\,");
        write_node(w, node, function ? SUM : least);
        apart = function || word;
    }
}

/* What stands above and below one line; alone on its side, nothing needs brackets. */
static void write_fraction(const struct writer *w, const struct factors *f, int first, int line, int last)
{
    if (w->flat) {
        write_factors(w, f, first, line, POWER);
        const bool several = last - line > 1;
        tex_add(w->tex, several ? "/(" : "/");
        write_factors(w, f, line, last, several ? POWER : ATOM);
        tex_add(w->tex, several ? ")" : "");
        return;
    }
    tex_add(w->tex, "\\frac{");
    write_factors(w, f, first, line, line - first == 1 ? SUM : POWER);
    tex_add(w->tex, "}{");
    write_factors(w, f, line, last, last - line == 1 ? SUM : POWER);
    tex_add(w->tex, "}");
}

/* k_c/m1*(x1 - x2)/L^3*Q is two fractions and a factor: a line ends where a factor stands above it again. */
static void write_product(const struct writer *w, int node)
{
    struct factors f = {.list = NULL};
    collect(w->program, node, false, &f);
    if (f.negative)
        tex_add(w->tex, "-");
    for (int first = 0, last; first < f.count; first = last) {
        int line = first;
        while (line < f.count && !f.list[line].below)
            line++;
        last = line;
        while (last < f.count && f.list[last].below)
            last++;
        if (last > line)
            write_fraction(w, &f, first, line, last);
        else
            write_factors(w, &f, first, line, POWER);
    }
    free(f.list);
}

static void write_call(const struct writer *w, const char *name, int argument)
{
    tex_add(w->tex, "\\%s ", name);
    if (tightness_of(w->program, argument) == ATOM)
        write_node(w, argument, SUM);
    else
        write_brackets(w, argument, "(", ")");
}

static void write_power(const struct writer *w, const struct node *n)
{
    const char *name = w->program->nodes[n->left].op == OPERATOR_INPUT ? input_name(w->program, n->left) : "";
    if (is_variation(name)) /* (\delta L)^2 */
        write_brackets(w, n->left, "(", ")");
    else
        write_node(w, n->left, ATOM);
    tex_add(w->tex, "^{%ld}", (long)n->exponent);
}

static void write_number(const struct writer *w, const struct node *n)
{
    char *text = fmpq_get_str(NULL, 10, &n->number);
    char *slash = strchr(text, '/');
    if (slash == NULL)
        tex_add(w->tex, "%s", text);
    else
        tex_add(w->tex, "\\frac{%.*s}{%s}", (int)(slash - text), text, slash + 1);
    flint_free(text);
}

/* Operands with what stands around them; of what is added, a negative one in brackets. */
static void write_around(const struct writer *w, const struct node *n)
{
    const struct writer inner = {w->tex, w->program, w->flat || n->op == OPERATOR_EXP};
    const bool negative = n->op == OPERATOR_ADD && w->program->nodes[n->right].op == OPERATOR_NEGATE;
    tex_add(w->tex, "%s", operators[n->op].before);
    write_node(&inner, n->left, operators[n->op].left);
    tex_add(w->tex, "%s", operators[n->op].between);
    if (n->right >= 0)
        write_node(&inner, n->right, negative ? BINDS_PRODUCT : operators[n->op].right);
    tex_add(w->tex, "%s", operators[n->op].after);
}

static void write_operator(const struct writer *w, int node)
{
    const struct node *n = &w->program->nodes[node];
    if (n->op == OPERATOR_INPUT && *input_name(w->program, node) == '{')
        tex_add(w->tex, "%s", input_name(w->program, node));
    else if (n->op == OPERATOR_INPUT)
        typeset_symbol(w->tex, input_name(w->program, node));
    else if (n->op == OPERATOR_NUMBER)
        write_number(w, n);
    else if (n->op == OPERATOR_MULTIPLY || n->op == OPERATOR_DIVIDE)
        write_product(w, node);
    else if (n->op == OPERATOR_POWER)
        write_power(w, n);
    else if (operators[n->op].function != NULL)
        write_call(w, operators[n->op].function, n->left);
    else if (n->op == OPERATOR_POSITIVE) /* Iverson's bracket: 1 where it holds, else 0 */
        write_brackets(w, n->left, "[", " > 0]");
    else if (n->op == OPERATOR_SQRT && w->program->nodes[n->left].exponent == 2) /* the absolute value: nothing but a power has one */
        write_brackets(w, w->program->nodes[n->left].left, "|", "|");
    else
        write_around(w, n);
}

/* In brackets where it binds less than its place asks for. */
static void write_node(const struct writer *w, int node, enum tightness least)
{
    if (tightness_of(w->program, node) < least)
        write_brackets(w, node, "(", ")");
    else
        write_operator(w, node);
}

void typeset_formula(struct tex *t, const struct program *p, int node)
{
    const struct writer w = {t, p, false};
    write_node(&w, node, SUM);
}

/* ---- mathematics within a sentence ---- */

/* What stands for what, the longest first. */
static const struct {
    const char *text, *latex;
} signs[] = {{"...", "\\dots "}, {"<<", "\\ll "}, {"<=", "\\le "}, {">=", "\\ge "}, {"!=", "\\ne "},   {"->", "\\to "},
             {"+-", "\\pm "},    {"-+", "\\mp "}, {"|", "\\vert "}, {"%", "\\%"},   {"{", "\\{"},      {"}", "\\}"},
             {"*", "\\,"},       {"&", "\\&"},    {"#", "\\#"},     {"~", "\\sim "}};

/* The words that are no symbols. */
static const struct {
    const char *text, *latex;
} words[] = {{"sin", "\\sin "}, {"cos", "\\cos "}, {"log", "\\ln "}, {"ln", "\\ln "}, {"exp", "\\exp "}, {"det", "\\det "},
             {"cosh", "\\cosh "}, {"Re", "\\operatorname{Re}"}, {"infinity", "\\infty "}, {"and", "\\text{ and }"}};

static const char *inline_part(struct tex *t, const char *at);

static size_t word_length(const char *text)
{
    return strspn(text, "_0123456789abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ");
}

static const char *inline_number(struct tex *t, const char *at)
{
    const size_t length = strspn(at, "0123456789"); /* a point stands for itself, between two of them */
    tex_add(t, "%.*s", (int)length, at);
    at += length;
    if (*at == 'e' && strspn(at + 1, "+-0123456789") > 0) {
        char *end;
        tex_add(t, "\\cdot 10^{%ld}", strtol(at + 1, &end, 10));
        at = end;
    }
    return at;
}

/* In braces: what stands in brackets here, or a word, -n too. */
static const char *inline_argument(struct tex *t, const char *at)
{
    const size_t minus = *at == '-', plain = minus + word_length(at + minus);
    tex_add(t, "{");
    if (*at == '(') {
        at = inline_part(t, at + 1);
        at += *at == ')';
    } else {
        typeset_inline(t, at, plain);
        at += plain;
    }
    tex_add(t, "}");
    return at;
}

static const char *inline_word(struct tex *t, const char *at)
{
    char name[64];
    const size_t length = word_length(at);
    snprintf(name, sizeof name, "%.*s", (int)length, at);
    at += length;
    if (strcmp(name, "sqrt") == 0) { /* sqrt(x), sqrt 7 */
        tex_add(t, "\\sqrt");
        return inline_argument(t, at + (*at == ' '));
    }
    for (size_t k = 0; k < sizeof words / sizeof *words; k++)
        if (strcmp(name, words[k].text) == 0) {
            tex_add(t, "%s", words[k].latex);
            return at;
        }
    typeset_symbol(t, name);
    return at;
}

/* A blank is a product between what ends a factor and what begins one. */
static bool is_product(char before, char after)
{
    return (isalnum((unsigned char)before) || before == ')' || before == '\'') && (isalnum((unsigned char)after) || after == '(');
}

static const char *inline_token(struct tex *t, const char *at)
{
    if (isdigit((unsigned char)*at))
        return inline_number(t, at);
    if (isalpha((unsigned char)*at))
        return inline_word(t, at);
    if (*at == '^') {
        tex_add(t, "^");
        return inline_argument(t, at + 1);
    }
    for (size_t k = 0; k < sizeof signs / sizeof *signs; k++)
        if (strncmp(at, signs[k].text, strlen(signs[k].text)) == 0) {
            tex_add(t, "%s", signs[k].latex);
            return at + strlen(signs[k].text);
        }
    if (*at == ' ' && is_product(at[-1], at[1]))
        tex_add(t, "\\,");
    else
        tex_add(t, "%c", *at);
    return at + 1;
}

/* To the end, or to the bracket that closes what was opened before; there. */
static const char *inline_part(struct tex *t, const char *at)
{
    for (int depth = 0; *at != '\0' && (*at != ')' || depth > 0);) {
        depth += *at == '(' ? 1 : *at == ')' ? -1 : 0;
        at = inline_token(t, at);
    }
    return at;
}

void typeset_inline(struct tex *t, const char *text, size_t length)
{
    struct tex copy = {NULL, 0};
    tex_add(&copy, " %.*s", (int)length, text); /* a blank before the first one, so that each has something before it */
    for (const char *at = copy.text + 1; *(at = inline_part(t, at)) != '\0'; at++)
        tex_add(t, ")");
    tex_clear(&copy);
}
