#include "claims/condition.h"

#include <ctype.h>
#include <string.h>

/* The length of the word there, of letters, digits and '_', past blanks. */
static size_t word_at(const char **at)
{
    size_t length = 0;
    *at += strspn(*at, " ");
    while (isalnum((unsigned char)(*at)[length]) || (*at)[length] == '_')
        length++;
    return length;
}

static bool passes(const char **at, const char *keyword)
{
    const size_t length = word_at(at);
    const bool same = length == strlen(keyword) && strncmp(*at, keyword, length) == 0;
    *at += same ? length : 0;
    return same;
}

bool condition_read(struct verdict_condition *c, const struct statement *s, const char *text, size_t *where, struct message *why)
{
    const char *at = text;
    do {
        const signed char wanted = passes(&at, "not") ? -1 : 1;
        const size_t length = word_at(&at);
        int i = 0;
        while (i < s->assertion_count && (strlen(s->assertions[i].name) != length || strncmp(s->assertions[i].name, at, length) != 0))
            i++;
        *where = (size_t)(at - text);
        if (i == s->assertion_count || s->assertions[i].kind == ASSERT_COMPUTE) {
            message_set(why, "expected a name of prove, but no computation");
            return false;
        }
        c->wanted[i] = wanted;
        at += length;
    } while (passes(&at, "and"));
    *where = (size_t)(at - text);
    if (*at != '\0')
        message_set(why, "expected and, or the end of the condition");
    return *at == '\0';
}
