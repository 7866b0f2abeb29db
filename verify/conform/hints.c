#include "conform/hints.h"

#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "conform/conform.h"

enum { WORD = 80 };

static const char MARK[] = "\357\273\277"; /* UTF-8's byte order mark */

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
    const char *odd = word + strspn(word, id_letters);
    if (sheet != NULL && section_find(sheet, word) != NULL)
        snprintf(hint, size, "'%s' is an operation, the vector's name alone stands first", word);
    else if (is_number(word))
        snprintf(hint, size, "'%s' is a number: a line begins with the vector's name, and has all its outputs", word);
    else if (strncmp(word, MARK, strlen(MARK)) == 0)
        snprintf(hint, size, "a byte order mark stands before '%s'", word + strlen(MARK));
    else if (*odd != '\0')
        snprintf(hint, size, "its first word '%s' names no vector: no name has a '%c'", word, *odd);
    else
        snprintf(hint, size, "its first word '%s' names no vector", word);
}

/* Too few words or too many, by the operation in the vector's name. */
static void count_hint(const struct sheet *sheet, const char *name, int count, char *hint, size_t size)
{
    char id[WORD];
    snprintf(id, sizeof id, "%.*s", (int)strcspn(name, "-"), name);
    const struct section *s = sheet != NULL ? section_find(sheet, id) : NULL;
    if (count == 0)
        snprintf(hint, size, "nothing stands after the vector's name: numbers, invalid or skip are due");
    else if (s != NULL)
        snprintf(hint, size, "%d number%s, %s has %d output%s", count, count == 1 ? "" : "s", id, s->output_count,
                 s->output_count == 1 ? "" : "s");
}

void line_hint(const struct sheet *sheet, const char *line, enum outcome outcome, char *hint, size_t size)
{
    char copy[LONGEST_SHOWN], *rest = NULL, *odd = NULL;
    int count = 0;
    snprintf(copy, sizeof copy, "%s", line);
    const char *name = strtok_r(copy, " \t", &rest);
    snprintf(hint, size, "%s", "");
    for (char *word = NULL; name != NULL && (word = strtok_r(NULL, " \t", &rest)) != NULL; count++)
        odd = odd == NULL && !is_number(word) ? word : odd;
    if (outcome == OUTCOME_TRUNCATED)
        snprintf(hint, size, "the last line has no LF");
    else if (outcome == OUTCOME_TOO_LONG)
        snprintf(hint, size, "it has more than %d bytes", LONGEST_LINE);
    else if (outcome == OUTCOME_LATE)
        snprintf(hint, size, "its turn is over: answers come in the order of the questions, one each");
    else if (outcome == OUTCOME_EARLY)
        snprintf(hint, size, "its question had not been asked");
    else if (name == NULL)
        snprintf(hint, size, "an empty line");
    else if (outcome == OUTCOME_STRANGER || outcome == OUTCOME_UNNAMED)
        name_hint(sheet, name, hint, size);
    else if (outcome == OUTCOME_COUNT)
        count_hint(sheet, name, count, hint, size);
    else if (odd != NULL)
        number_hint(odd, hint, size);
}
