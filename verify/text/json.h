/* JSON, written value by value: brackets, commas, colons and quotation marks come by themselves. */
#ifndef CT_JSON_H
#define CT_JSON_H

#include <stdbool.h>
#include <stdio.h>

enum { DEEPEST_JSON = 8 };

struct json {
    FILE *file;
    int depth;
    char closing[DEEPEST_JSON]; /* of the open lists and objects       */
    bool filled[DEEPEST_JSON];  /* something stands in them already    */
    int indent;                 /* of the next value; -1: the same line */
};

struct json json_on(FILE *file);

/* In an object each value has a key, in a list none (NULL). An object or a list, by its bracket, { or [. */
void json_open(struct json *j, const char *key, char bracket);
void json_close(struct json *j); /* the outermost ends its line */

/* Text, what is no UTF-8 in it as question marks; NULL is left out. */
void json_string(struct json *j, const char *key, const char *text);

/* Several texts, key and text by turns; json_record(): an object of these. */
void json_pairs(struct json *j, const char *const *texts, size_t count);
#define json_strings(j, ...) \
    json_pairs(j, (const char *const[]){__VA_ARGS__}, sizeof((const char *const[]){__VA_ARGS__}) / sizeof(const char *))
#define json_record(j, key, ...) (json_open(j, key, '{'), json_strings(j, __VA_ARGS__), json_close(j))

/* A list of texts. */
void json_texts(struct json *j, const char *key, const char *const *texts, int count);

/* A number, true or false, by printf's format. */
#if defined(__GNUC__)
__attribute__((format(printf, 3, 4)))
#endif
void json_value(struct json *j, const char *key, const char *format, ...);
#define json_truth(j, key, truth) json_value(j, key, (truth) ? "true" : "false")

/* The next value, or the next closing bracket, begins a line, so many blanks in; -1: it does not. */
void json_line(struct json *j, int indent);

#endif
