/* One clear line about what went wrong. */
#ifndef CT_MESSAGE_H
#define CT_MESSAGE_H

#include <stddef.h>
#include <string.h>

struct message {
    char text[512];
};

#if defined(__GNUC__)
__attribute__((format(printf, 2, 3)))
#endif
void message_set(struct message *m, const char *format, ...);

/* More of a text, as far as its room goes, after a separator where something stands already. */
void add_text(char *text, size_t size, const char *separator, const char *more);

/* What would move a cursor or end the line becomes a question mark. */
void message_printable(char *text);

/* Of names that stand so many bytes apart in memory the nearest to a mistaken one (edit distance), NULL when none is near. */
const char *nearest_name(const char *mistaken, const void *known, size_t count, size_t stride);

/* The same of a member of each struct in an array. */
#define NEAREST(mistaken, array, count, member) \
    nearest_name(mistaken, (count) > 0 ? &(array)->member : NULL, (size_t)(count), sizeof *(array))

/* The first struct of an array in which that member is the name; NULL: there is none. */
void *find_named(const char *name, const void *array, size_t count, size_t size, size_t member);
#define NAMED(key, array, count, type, member) find_named(key, array, (size_t)(count), sizeof(type), offsetof(type, member))

/* One line on standard error and exit status 1. */
__attribute__((noreturn)) void out_of_memory(void);

/* Memory that is there, or the end. */
void *xrealloc(void *old, size_t count, size_t size);

/* One more item of an array that is counted, all zero. */
#define APPENDED(array, count) \
    ((array) = xrealloc(array, (size_t)(count) + 1, sizeof *(array)), \
     memset(&(array)[count], 0, sizeof *(array)), &(array)[(count)++])
char *text_copy(const char *text);

#endif
