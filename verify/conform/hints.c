#include "conform/hints.h"

#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

enum { WORD = 80 };

/* What names are made of; UTF-8's byte order mark. */
static const char LETTERS[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_.-", MARK[] = "\357\273\277";

static bool is_number(const char *word)
{
    char *end;
    strtod(word, &end);
    return end != word && *end == '\0';
}

/* Whether the word is a number once one of its characters is another. */
static bool is_number_with(const char *word, const char *of, char other)
{
    char changed[WORD];
    snprintf(changed, sizeof changed, "%s", word);
    char *at = strpbrk(changed, of);
    if (at == NULL || is_number(word))
        return false;
    *at = other;
    return is_number(changed);
}

/* A word where a number is due. */
static void number_hint(const char *word, char *hint, size_t size)
{
    const char *odd = strpbrk(word, "[](){},;:=\"'");
    if (strcasecmp(word, "invalid") == 0 || strcasecmp(word, "skip") == 0)
        snprintf(hint, size, "'%s': did you mean %s, alone and in small letters?", word, tolower(*word) == 'i' ? "invalid" : "skip");
    else if (strcasecmp(word, "true") == 0 || strcasecmp(word, "false") == 0)
        snprintf(hint, size, "'%s' is no number, 1 or 0 is due", word);
    else if (is_number_with(word, "dD", 'e'))
        snprintf(hint, size, "'%s' has Fortran's D exponent, E is due", word);
    else if (is_number_with(word, ",", '.') && word[strlen(word) - 1] != ',')
        snprintf(hint, size, "'%s' has a decimal comma, a point is due", word);
    else if (odd != NULL)
        snprintf(hint, size, "'%s' is no number for its '%c'", word, *odd);
    else
        snprintf(hint, size, "'%s' is no number", word);
}

/* A first word that names no vector. */
static void name_hint(const struct sheet *sheet, const char *word, char *hint, size_t size)
{
    const char *odd = word + strspn(word, LETTERS);
    if (sheet != NULL && section_find(sheet, word) != NULL)
        snprintf(hint, size, "'%s' is an operation, the vector's name alone stands first", word);
    else if (is_number(word))
        snprintf(hint, size, "'%s' is a number, the vector's name stands first", word);
    else if (strncmp(word, MARK, strlen(MARK)) == 0)
        snprintf(hint, size, "a byte order mark stands before '%s'", word + strlen(MARK));
    else if (*odd != '\0')
        snprintf(hint, size, "its first word '%s' names no vector: no name has a '%c'", word, *odd);
    else
        snprintf(hint, size, "its first word '%s' names no vector", word);
}

void line_hint(const struct sheet *sheet, const char *line, enum outcome outcome, char *hint, size_t size)
{
    char copy[120], *rest = NULL;
    snprintf(copy, sizeof copy, "%s", line);
    const char *name = strtok_r(copy, " \t", &rest);
    snprintf(hint, size, "%s", "");
    if (outcome == OUTCOME_TRUNCATED)
        snprintf(hint, size, "the last line has no LF");
    else if ((outcome == OUTCOME_MALFORMED || outcome == OUTCOME_STRANGER) && name == NULL)
        snprintf(hint, size, "an empty line");
    else if (outcome == OUTCOME_STRANGER || (outcome == OUTCOME_MALFORMED && name[strspn(name, LETTERS)] != '\0'))
        name_hint(sheet, name, hint, size);
    for (char *word = NULL; outcome == OUTCOME_MALFORMED && *hint == '\0' && (word = strtok_r(NULL, " \t", &rest)) != NULL;)
        if (!is_number(word))
            number_hint(word, hint, size);
}
