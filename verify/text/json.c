#include "text/json.h"

#include <stdarg.h>

struct json json_on(FILE *file)
{
    return (struct json){.file = file, .indent = -1};
}

static void begin_line(struct json *j)
{
    if (j->indent >= 0)
        fprintf(j->file, "\n%*s", j->indent, "");
    j->indent = -1;
}

/* Of the character that begins there; 0: none does. Longer forms than needed, surrogates and what is beyond Unicode are none. */
static size_t utf8_length(const char *text)
{
    const unsigned char *c = (const unsigned char *)text;
    const size_t length = *c < 0x80 ? 1 : *c < 0xc2 ? 0 : *c < 0xe0 ? 2 : *c < 0xf0 ? 3 : *c < 0xf5 ? 4 : 0;
    for (size_t i = 1; i < length; i++)
        if ((c[i] & 0xc0) != 0x80)
            return 0;
    const unsigned char low = *c == 0xe0 ? 0xa0 : *c == 0xf0 ? 0x90 : 0x80, high = *c == 0xed ? 0x9f : *c == 0xf4 ? 0x8f : 0xbf;
    return length > 2 && (c[1] < low || c[1] > high) ? 0 : length;
}

static void put_string(FILE *file, const char *text)
{
    fputc('"', file);
    while (*text != '\0') {
        const size_t length = utf8_length(text);
        if (*text == '\n')
            fputs("\\n", file);
        else if (length == 0)
            fputc('?', file);
        else if ((unsigned char)*text < 0x20)
            fprintf(file, "\\u%04x", (unsigned)*text);
        else
            fprintf(file, "%s%.*s", *text == '"' || *text == '\\' ? "\\" : "", (int)length, text);
        text += length > 0 ? length : 1;
    }
    fputc('"', file);
}

/* What stands before a value. */
static void begin_value(struct json *j, const char *key)
{
    const bool inside = j->depth > 0;
    if (inside && j->filled[j->depth - 1])
        fputs(j->indent >= 0 ? "," : ", ", j->file);
    if (inside)
        j->filled[j->depth - 1] = true;
    begin_line(j);
    if (key != NULL) {
        put_string(j->file, key);
        fputs(": ", j->file);
    }
}

void json_open(struct json *j, const char *key, char bracket)
{
    begin_value(j, key);
    fputc(bracket, j->file);
    j->closing[j->depth] = bracket == '{' ? '}' : ']';
    j->filled[j->depth++] = false;
}

void json_close(struct json *j)
{
    begin_line(j);
    fputc(j->closing[--j->depth], j->file);
    if (j->depth == 0)
        fputc('\n', j->file);
}

void json_string(struct json *j, const char *key, const char *text)
{
    if (text == NULL)
        return;
    begin_value(j, key);
    put_string(j->file, text);
}

void json_pairs(struct json *j, const char *const *texts, size_t count)
{
    for (size_t i = 0; i < count; i += 2)
        json_string(j, texts[i], texts[i + 1]);
}

void json_texts(struct json *j, const char *key, const char *const *texts, int count)
{
    json_open(j, key, '[');
    for (int i = 0; i < count; i++)
        json_string(j, NULL, texts[i]);
    json_close(j);
}

void json_value(struct json *j, const char *key, const char *format, ...)
{
    va_list arguments;
    begin_value(j, key);
    va_start(arguments, format);
    vfprintf(j->file, format, arguments);
    va_end(arguments);
}

void json_line(struct json *j, int indent)
{
    j->indent = indent;
}
