#include "claims/marked.h"

#include <string.h>

/* ---- taking it apart ---- */

static bool mark_error(size_t at, size_t *where, struct message *why, const char *expected)
{
    *where = at;
    message_set(why, "%s", expected);
    return false;
}

bool marked_read(const char *text, const struct marked_parts *parts, size_t *where, struct message *why)
{
    for (const char *at = text; *at != '\0';) {
        const size_t words = strcspn(at, "${}"), offset = (size_t)(at - text) + words;
        if (words > 0)
            parts->words(parts->context, at, words);
        at += words;
        if (*at == '\0')
            break;
        if (*at == '}')
            return mark_error(offset, where, why, "expected '{' before '}'");
        const bool number = *at == '{';
        if (number && parts->number == NULL)
            return mark_error(offset, where, why, "expected no number {...} here");
        const char *end = strpbrk(at + 1, number ? "{}" : "$");
        if (end == NULL || *end == '{' || end == at + 1)
            return mark_error(offset, where, why, number ? "expected {FORMULA | DIGITS}" : "expected $...$, closed");
        (number ? parts->number : parts->mathematics)(parts->context, at + 1, (size_t)(end - at) - 1);
        at = end + 1;
    }
    return true;
}

/* ---- writing it out ---- */

void written_clear(struct written *w)
{
    tex_clear(&w->plain);
    tex_clear(&w->latex);
}

/* Plain words and units as LaTeX: m^2 is raised, uC has its micro. */
static void latex_words(struct tex *t, const char *at, size_t length)
{
    for (size_t i = 0; i < length; i++) {
        size_t digits = 0;
        while (at[i] == '^' && i + 1 + digits < length && strchr("-0123456789", at[i + 1 + digits]) != NULL)
            digits++;
        if (digits > 0)
            tex_add(t, "$^{%.*s}$", (int)digits, at + i + 1);
        else if (at[i] == 'u' && i + 1 < length && at[i + 1] == 'C' && (i == 0 || at[i - 1] == ' '))
            tex_add(t, "\\textmu{}");
        else if (strchr("%&#_", at[i]) != NULL)
            tex_add(t, "\\%c", at[i]);
        else if (strchr("<>", at[i]) != NULL)
            tex_add(t, "$%c$", at[i]);
        else if (strchr("^~\\", at[i]) != NULL)
            tex_add(t, at[i] == '~' ? "\\textasciitilde{}" : at[i] == '^' ? "\\textasciicircum{}" : "\\textbackslash{}");
        else
            tex_add(t, "%c", at[i]);
        i += digits;
    }
}

void write_words(void *written, const char *at, size_t length)
{
    struct written *w = written;
    tex_add(&w->plain, "%.*s", (int)length, at);
    latex_words(&w->latex, at, length);
}

void write_mathematics(void *written, const char *at, size_t length)
{
    struct written *w = written;
    tex_add(&w->plain, "%.*s", (int)length, at);
    tex_add(&w->latex, "$");
    typeset_inline(&w->latex, at, length);
    tex_add(&w->latex, "$");
}

void write_decimal(struct written *w, const char *decimal, const char *unit)
{
    const char *mark = strchr(decimal, 'e');
    const int figures = mark != NULL ? (int)(mark - decimal) : (int)strlen(decimal);
    tex_add(&w->plain, "%s", decimal);
    tex_add(&w->latex, "$%.*s", figures, decimal);
    if (mark != NULL) { /* e-05, e+12 */
        const char *exponent = mark + 1 + strspn(mark + 1, "+-0");
        tex_add(&w->latex, "\\cdot 10^{%s%s}", mark[1] == '-' ? "-" : "", *exponent != '\0' ? exponent : "0");
    }
    tex_add(&w->latex, "$");
    if (unit != NULL) {
        tex_add(&w->plain, " %s", unit);
        tex_add(&w->latex, "~");
        latex_words(&w->latex, unit, strlen(unit));
    }
}

void write_marked(struct written *w, const char *text)
{
    const struct marked_parts parts = {w, write_words, write_mathematics, NULL};
    struct message why;
    size_t where;
    if (!marked_read(text, &parts, &where, &why)) /* what has no marks in mind, as a title */
        write_words(w, text + where, strlen(text + where));
}
