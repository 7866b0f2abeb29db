#include "claims/marked.h"

#include <string.h>

struct marked_part marked_next(const char **text)
{
    const char *at = *text;
    const size_t words = strcspn(at, "${}");
    *text += words;
    if (words > 0)
        return (struct marked_part){PART_WORDS, at, NULL, words};
    if (*at == '\0')
        return (struct marked_part){PART_END, at, NULL, 0};
    if (*at == '}')
        return (struct marked_part){PART_WRONG, at, "expected '{' before '}'", 0};
    const bool number = *at == '{';
    const char *end = strpbrk(at + 1, number ? "{}" : "$");
    if (end == NULL || *end == '{' || end == at + 1)
        return (struct marked_part){PART_WRONG, at, number ? "expected {FORMULA | DIGITS}" : "expected $...$, closed", 0};
    *text = end + 1;
    return (struct marked_part){number ? PART_NUMBER : PART_MATHEMATICS, at + 1, NULL, (size_t)(end - at) - 1};
}

/* ---- writing it out ---- */

void written_clear(struct written *w)
{
    tex_clear(&w->plain);
    tex_clear(&w->latex);
}

void write_part(struct written *w, const struct marked_part *part)
{
    tex_add(&w->plain, "%.*s", (int)part->length, part->at);
    if (part->kind == PART_MATHEMATICS) {
        tex_add(&w->latex, "$");
        typeset_inline(&w->latex, part->at, part->length);
        tex_add(&w->latex, "$");
    } else
        tex_add(&w->latex, "%.*s", (int)part->length, part->at);
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
        tex_add(&w->latex, "\xc2\xa0%s", unit); /* a blank at which no line ends */
    }
}

void write_marked(struct written *w, const char *text)
{
    const char *from = text;
    struct marked_part part = marked_next(&text);
    for (; part.kind == PART_WORDS || part.kind == PART_MATHEMATICS; part = marked_next(&text)) {
        write_part(w, &part);
        from = text;
    }
    write_part(w, &(struct marked_part){PART_WORDS, from, NULL, strlen(from)});
}
