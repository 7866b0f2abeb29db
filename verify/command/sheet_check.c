/*
 * The build's guard: a mistake in the formula sheet, in the derivation steps or in the claims stops here, with file,
 * line and what was expected. The files that it reads stand in the place of the embedded ones.
 */
#include <stdio.h>
#include <stdlib.h>

#include "claims/statement.h"
#include "sheet/embedded.h"

static struct sheet read_sheet;

const struct sheet *sheet(void)
{
    return &read_sheet;
}

const char *embedded_derivations(size_t *length) /* LCOV_EXCL_LINE: for the linker, the steps are read from their file */
{
    *length = 0; /* LCOV_EXCL_LINE: the same */
    return "";   /* LCOV_EXCL_LINE: the same */
} /* LCOV_EXCL_LINE: the same */

static char *file_text(const char *name, size_t *length)
{
    FILE *file = fopen(name, "rb");
    char *text = NULL;
    size_t got;
    *length = 0;
    if (file == NULL)
        return NULL;
    do {
        text = xrealloc(text, *length + 4096, 1);
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

static int check_derivations(struct proof_results *p, const char *name)
{
    struct message why;
    size_t length;
    char *text = file_text(name, &length);
    int status = text == NULL ? -1 : derivations_read(&p->derivations, sheet(), text, length, name, &why);
    if (status != 0)
        fprintf(stderr, "%s%s\n", text ? "" : name, text ? why.text : ": cannot be read");
    free(text);
    return status != 0;
}

static int check_claims(const struct proof_results *p, const char *name)
{
    struct statements s;
    struct message why;
    size_t length;
    char *text = file_text(name, &length);
    int status = text == NULL ? -1 : statements_read(&s, p, text, length, name, &why);
    if (status == 0)
        statements_clear(&s);
    else
        fprintf(stderr, "%s%s\n", text ? "" : name, text ? why.text : ": cannot be read");
    free(text);
    return status != 0;
}

int main(int count, char **arguments)
{
    struct proof_results p = {.fine = false};
    int status = 0;
    if (count < 2 || count > 4) {
        fputs("usage: sheet-check EQUATIONS [DERIVATIONS [CLAIMS]]\n", stderr);
        return 2;
    }
    if (check_sheet(&read_sheet, arguments[1]) != 0)
        return 1;
    if (count > 2 && (status = check_derivations(&p, arguments[2])) == 0) {
        status = count > 3 ? check_claims(&p, arguments[3]) : 0;
        derivations_clear(&p.derivations);
    }
    sheet_clear(&read_sheet);
    flint_cleanup();
    return status;
}
