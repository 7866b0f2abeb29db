#include "conform/diagnosis.h"

#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

enum { WORD = 80 };

static const char MARK[] = "\357\273\277"; /* UTF-8's byte order mark */

static bool is_number(const char *word)
{
    char *end;
    strtod(word, &end);
    return end != word && *end == '\0';
}

/* A word where a number is due. */
static void number_hint(const char *word, char *hint, size_t size)
{
    static const struct {
        const char *of; /* one of these, and not the last, in place of: */
        char due;
        const char *says;
    } misspelt[] = {{"dD", 'e', "has Fortran's D exponent, E is due"}, {",", '.', "has a decimal comma, a point is due"}};
    const char *odd = strpbrk(word, "[](){},;:=\"'");
    if (strcasecmp(word, "invalid") == 0 || strcasecmp(word, "skip") == 0)
        snprintf(hint, size, "'%s': did you mean %s, alone and in small letters?", word, tolower(*word) == 'i' ? "invalid" : "skip");
    else if (strcasecmp(word, "true") == 0 || strcasecmp(word, "false") == 0)
        snprintf(hint, size, "'%s' is no number, 1 or 0 is due", word);
    else if (odd != NULL)
        snprintf(hint, size, "'%s' is no number for its '%c'", word, *odd);
    else
        snprintf(hint, size, "'%s' is no number", word);
    for (size_t i = 0; i < sizeof misspelt / sizeof *misspelt; i++) {
        char changed[WORD];
        snprintf(changed, sizeof changed, "%s", word);
        char *at = strpbrk(changed, misspelt[i].of);
        if (at == NULL || at[1] == '\0')
            continue;
        *at = misspelt[i].due;
        if (is_number(changed))
            snprintf(hint, size, "'%s' %s", word, misspelt[i].says);
    }
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

_Static_assert(LONGEST_LINE == 65536, "it is said in words");

void line_hint(const struct sheet *sheet, const char *line, enum outcome outcome, char *hint, size_t size)
{
    static const char *const plain[OUTCOMES] = {
        [OUTCOME_TRUNCATED] = "the last line has no LF", [OUTCOME_TOO_LONG] = "it has more than 65536 bytes",
        [OUTCOME_LATE] = "its turn is over: answers come in the order of the questions, one each",
        [OUTCOME_EARLY] = "its question had not been asked"};
    char copy[LONGEST_SHOWN], *rest = NULL, *odd = NULL;
    int count = 0;
    snprintf(copy, sizeof copy, "%s", line);
    const char *name = strtok_r(copy, " \t", &rest);
    snprintf(hint, size, "%s", "");
    for (char *word = NULL; name != NULL && (word = strtok_r(NULL, " \t", &rest)) != NULL; count++)
        odd = odd == NULL && !is_number(word) ? word : odd;
    if (plain[outcome] != NULL)
        snprintf(hint, size, "%s", plain[outcome]);
    else if (name == NULL)
        snprintf(hint, size, "an empty line");
    else if (outcome == OUTCOME_STRANGER || outcome == OUTCOME_UNNAMED)
        name_hint(sheet, name, hint, size);
    else if (outcome == OUTCOME_COUNT)
        count_hint(sheet, name, count, hint, size);
    else if (odd != NULL)
        number_hint(odd, hint, size);
}
