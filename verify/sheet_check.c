/* The build's guard: a mistake in the formula sheet stops here, with file, line and what was expected. */
#include <stdio.h>
#include <stdlib.h>

#include "sheet.h"

static char *file_text(const char *name, size_t *length)
{
    FILE *file = fopen(name, "rb");
    char *text = NULL;
    size_t got;
    *length = 0;
    if (file == NULL)
        return NULL;
    do {
        text = memory(text, *length + 4096, 1);
        got = fread(text + *length, 1, 4096, file);
        *length += got;
    } while (got == 4096);
    bool fine = !ferror(file);
    if (fclose(file) != 0 || !fine) {
        free(text);
        return NULL;
    }
    return text;
}

int main(int count, char **arguments)
{
    struct sheet s;
    struct message why;
    size_t length;
    if (count != 2) {
        fputs("usage: sheet-check FILE\n", stderr);
        return 2;
    }
    char *text = file_text(arguments[1], &length);
    if (text == NULL) {
        fprintf(stderr, "%s: cannot be read\n", arguments[1]);
        return 1;
    }
    int status = sheet_read(&s, text, length, arguments[1], &why);
    free(text);
    if (status != 0) {
        fprintf(stderr, "%s\n", why.text);
        return 1;
    }
    sheet_clear(&s);
    return 0;
}
