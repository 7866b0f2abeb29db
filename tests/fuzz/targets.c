/* The list of the fuzzing targets, and what they all ask of the code. */
#include "targets.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "text/message.h"

const struct target targets[TARGETS] = {
    {"literal", literal},           {"expression", expression}, {"sheet", sheet_file}, {"derivations", derivations_file},
    {"command-line", command_line}, {"protocol", protocol},     {"answers", answers}};

void require(bool holds, const char *what, const char *text)
{
    if (holds)
        return;
    fprintf(stderr, "expected %s, got '%s'\n", what, text);
    abort();
}

int lines_of(const char *text)
{
    int lines = 0;
    for (const char *c = text; *c != '\0'; c++) {
        lines += *c == '\n';
        require(((unsigned char)*c >= 0x20 && *c != 0x7f) || *c == '\n' || *c == '\t', "printable text", text);
    }
    return lines;
}

void require_message(const char *text)
{
    require(lines_of(text) == 0 && *text != '\0', "one line", text);
}

char *text_of(const char *bytes, size_t size)
{
    char *text = xrealloc(NULL, size + 1, 1);
    if (size > 0)
        memcpy(text, bytes, size);
    text[size] = '\0';
    return text;
}
