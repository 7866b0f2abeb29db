/* One clear line about what went wrong. */
#ifndef CT_MESSAGE_H
#define CT_MESSAGE_H

#include <stddef.h>

struct message {
    char text[512];
};

#if defined(__GNUC__)
__attribute__((format(printf, 2, 3)))
#endif
void message_set(struct message *m, const char *format, ...);

/* What would move a cursor or end the line becomes a question mark. */
void message_printable(char *text);

/* The known name nearest to a mistaken one (edit distance), NULL when none is near. */
const char *nearest_name(const char *mistaken, const char *const *known, size_t count);

/* One line on standard error and exit status 1. */
__attribute__((noreturn)) void out_of_memory(void);

/* Memory that is there, or the end. */
void *xrealloc(void *old, size_t count, size_t size);
char *text_copy(const char *text);

#endif
