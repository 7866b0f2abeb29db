#include "claims/condition.h"

#include <ctype.h>
#include <stdio.h>
#include <string.h>

struct reader_of {
    const char *text, *at;
    condition_value *value;
    void *context;
    struct message *why;
    bool broken;
    int depth;
};

enum { LONGEST = 63, DEEPEST = 50 };

bool mentions(const char *text, const char *word)
{
    const size_t length = strlen(word);
    for (const char *at = text; (at = strstr(at, word)) != NULL; at++) {
        const bool begins = at == text || !(isalnum((unsigned char)at[-1]) || strchr("_.", at[-1]) != NULL);
        if (begins && !isalnum((unsigned char)at[length]) && at[length] != '_')
            return true;
    }
    return false;
}

enum truth truth_not(enum truth t)
{
    return t == FOUND_TRUE ? FOUND_FALSE : t == FOUND_FALSE ? FOUND_TRUE : UNDECIDED;
}

enum truth truth_both(enum truth a, enum truth b)
{
    return a == FOUND_FALSE || b == FOUND_FALSE ? FOUND_FALSE : a == FOUND_TRUE && b == FOUND_TRUE ? FOUND_TRUE : UNDECIDED;
}

static enum truth either(struct reader_of *r);

static enum truth refuse(struct reader_of *r, const char *expected)
{
    if (!r->broken)
        message_set(r->why, "expected %s", expected);
    r->broken = true;
    return UNDECIDED;
}

static size_t word(struct reader_of *r)
{
    size_t length = 0;
    r->at += strspn(r->at, " ");
    while (isalnum((unsigned char)r->at[length]) || r->at[length] == '_')
        length++;
    return length;
}

static bool passes(struct reader_of *r, const char *keyword)
{
    const size_t length = word(r);
    const bool same = length == strlen(keyword) && strncmp(r->at, keyword, length) == 0;
    if (same)
        r->at += length;
    return same;
}

static enum truth name(struct reader_of *r)
{
    char own[LONGEST + 1], member[LONGEST + 1];
    bool known = true;
    size_t length = word(r);
    const char *begin = r->at;
    if (length == 0 || length > LONGEST)
        return refuse(r, "a name of prove, not or '('");
    snprintf(own, sizeof own, "%.*s", (int)length, r->at);
    r->at += length;
    const bool more = *r->at == '.';
    if (more) {
        r->at++;
        length = word(r);
        snprintf(member, sizeof member, "%.*s", (int)(length > LONGEST ? LONGEST : length), r->at);
        r->at += length;
    }
    const enum truth found = r->value(r->context, own, more ? member : NULL, &known);
    if (!known) {
        r->at = begin;
        return refuse(r, "a name of prove; of a computation, NAME.truth");
    }
    return found;
}

static enum truth operand(struct reader_of *r)
{
    if (++r->depth > DEEPEST)
        return refuse(r, "less nesting");
    enum truth found;
    if (passes(r, "not"))
        found = truth_not(operand(r));
    else if (*r->at == '(') {
        r->at++;
        found = either(r);
        word(r);
        if (*r->at != ')')
            return refuse(r, "')', and or or");
        r->at++;
    } else
        found = name(r);
    r->depth--;
    return found;
}

static enum truth all(struct reader_of *r)
{
    enum truth found = operand(r);
    while (!r->broken && passes(r, "and"))
        found = truth_both(found, operand(r));
    return found;
}

static enum truth either(struct reader_of *r)
{
    enum truth found = all(r);
    while (!r->broken && passes(r, "or"))
        found = truth_not(truth_both(truth_not(found), truth_not(all(r))));
    return found;
}

static enum truth run(struct reader_of *r)
{
    const enum truth found = either(r);
    if (!r->broken && (word(r) > 0 || *r->at != '\0'))
        refuse(r, "and, or, or the end of the condition");
    return r->broken ? UNDECIDED : found;
}

bool condition_check(const char *text, condition_value *value, void *context, size_t *where, struct message *why)
{
    struct reader_of r = {text, text, value, context, why, false, 0};
    run(&r);
    *where = (size_t)(r.at - text);
    return !r.broken;
}

enum truth condition_decide(const char *text, condition_value *value, void *context)
{
    struct message why;
    struct reader_of r = {text, text, value, context, &why, false, 0};
    return run(&r);
}
