#include "text/message.h"

#include <ctype.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

void message_set(struct message *m, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(m->text, sizeof m->text, format, arguments);
    va_end(arguments);
    message_printable(m->text);
}

void add_text(char *text, size_t size, const char *separator, const char *more)
{
    const size_t length = strlen(text);
    snprintf(text + length, size - length, "%s%s", length > 0 ? separator : "", more);
}

void message_printable(char *text)
{
    for (; *text != '\0'; text++)
        if ((unsigned char)*text < 0x20 || *text == 0x7f)
            *text = '?';
}

void out_of_memory(void)
{
    fputs("coulomb-tether: out of memory\n", stderr);
    exit(1);
}

void *xrealloc(void *old, size_t count, size_t size)
{
    void *block = count > SIZE_MAX / size ? NULL : realloc(old, count > 0 ? count * size : size);
    if (block == NULL)
        out_of_memory();
    return block;
}

char *text_copy(const char *text)
{
    size_t size = strlen(text) + 1;
    return memcpy(xrealloc(NULL, size, 1), text, size);
}

/* Levenshtein's distance of two short names, row by row; capitals are the small letters. */
static size_t edit_distance(const char *a, const char *b)
{
    enum { LONGEST = 32 };
    size_t row[LONGEST + 1], length = strlen(b);
    if (length > LONGEST || strlen(a) > LONGEST)
        return SIZE_MAX;
    for (size_t j = 0; j <= length; j++)
        row[j] = j;
    for (size_t i = 1; a[i - 1] != '\0'; i++) {
        size_t diagonal = row[0];
        row[0] = i;
        for (size_t j = 1; j <= length; j++) {
            size_t above = row[j];
            size_t best = diagonal + (tolower((unsigned char)a[i - 1]) != tolower((unsigned char)b[j - 1]));
            if (above + 1 < best)
                best = above + 1;
            if (row[j - 1] + 1 < best)
                best = row[j - 1] + 1;
            diagonal = above;
            row[j] = best;
        }
    }
    return row[length];
}

const char *nearest_name(const char *mistaken, const void *known, size_t count, size_t stride)
{
    const char *nearest = NULL;
    const size_t letters = strlen(mistaken + strspn(mistaken, "-")); /* something of them stays */
    size_t least = letters < 4 ? letters : 4;                        /* further away than three edits is no suggestion */
    for (size_t i = 0; i < count; i++) {
        const char *name = *(const char *const *)((const char *)known + i * stride);
        size_t distance = edit_distance(mistaken, name);
        if (distance < least) {
            least = distance;
            nearest = name;
        }
    }
    return nearest;
}

void *find_named(const char *name, const void *array, size_t count, size_t size, size_t member)
{
    char *item = (char *)array; /* the caller's, who may change it or not */
    for (size_t i = 0; i < count; i++, item += size)
        if (strcmp(*(const char **)(void *)(item + member), name) == 0)
            return item;
    return NULL;
}
