/*
 * The build's guard: a mistake in the formula sheet, or in the derivation steps, stops here, with file,
 * line and what was expected.
 */
#include <stdio.h>
#include <stdlib.h>

#include "derivation.h"
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

static int check_sheet(struct sheet *s, const char *name)
{
    struct message why;
    size_t length;
    char *text = file_text(name, &length);
    int status = text == NULL ? -1 : sheet_read(s, text, length, name, &why);
    if (status != 0)
        fprintf(stderr, "%s%s\n", text ? "" : name, text ? why.text : ": cannot be read");
    free(text);
    return status != 0;
}

static int check_derivations(const struct sheet *s, const char *name)
{
    struct derivations d;
    struct message why;
    size_t length;
    char *text = file_text(name, &length);
    int status = text == NULL ? -1 : derivations_read(&d, s, text, length, name, &why);
    if (status == 0)
        derivations_clear(&d);
    else
        fprintf(stderr, "%s%s\n", text ? "" : name, text ? why.text : ": cannot be read");
    free(text);
    return status != 0;
}

int main(int count, char **arguments)
{
    struct sheet s;
    if (count < 2 || count > 3) {
        fputs("usage: sheet-check EQUATIONS [DERIVATIONS]\n", stderr);
        return 2;
    }
    if (check_sheet(&s, arguments[1]) != 0)
        return 1;
    int status = count == 3 ? check_derivations(&s, arguments[2]) : 0;
    sheet_clear(&s);
    return status;
}
