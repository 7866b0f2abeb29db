/*
 * The build's guard: a mistake in the formula sheet, in the derivation steps or in the claims stops here, with file,
 * line and what was expected. With arguments after the three files it is coulomb-tether on those sheets.
 */
#include <stdio.h>
#include <stdlib.h>

#include "claims/statement.h"
#include "command/command.h"

enum { SHEETS = 3 };

static char *file_text(const char *name, size_t *length)
{
    FILE *file = fopen(name, "rb");
    char *text = NULL;
    size_t size = 0;
    if (file == NULL)
        return NULL;
    const ssize_t got = getdelim(&text, &size, '\0', file); /* text has no zero byte */
    const bool fine = !ferror(file) && feof(file);
    *length = got >= 0 ? (size_t)got : 0;
    if (fclose(file) != 0 || !fine) {
        free(text);
        return NULL;
    }
    return text;
}

/* So many of the three; 0, or -1 and what is wrong. */
static int check(const struct sources *s, int count, struct message *why)
{
    struct paper paper;
    struct derivations steps;
    struct statements claims;
    int status = paper_open(&paper, s, why);
    if (status != 0)
        return status;
    if (count > 1 && (status = derivations_open(&steps, &paper, why)) == 0) {
        if (count > 2 && (status = statements_read(&claims, &steps, &paper.claims, why)) == 0)
            statements_clear(&claims);
        derivations_clear(&steps);
    }
    paper_close(&paper);
    return status;
}

int main(int count, char **arguments)
{
    struct source sources[SHEETS] = {{NULL, NULL, 0}};
    struct message why = {""};
    const int files = count - 1 < SHEETS ? count - 1 : SHEETS;
    int status = 0;
    if (files < 1) {
        fputs("usage: sheet-check EQUATIONS [DERIVATIONS [CLAIMS [ARGUMENTS...]]]\n", stderr);
        return 2;
    }
    for (int i = 0; i < files && status == 0; i++) {
        sources[i].name = arguments[i + 1];
        sources[i].text = file_text(arguments[i + 1], &sources[i].length);
        if (sources[i].text == NULL) {
            message_set(&why, "%s: cannot be read", arguments[i + 1]);
            status = 1;
        }
    }
    const struct sources s = {sources[0], sources[1], sources[2]};
    if (status == 0 && count > SHEETS + 1)
        status = program_run(&s, count - SHEETS, arguments + SHEETS);
    else if (status == 0 && check(&s, files, &why) != 0)
        status = 1;
    if (why.text[0] != '\0')
        fprintf(stderr, "%s\n", why.text);
    for (int i = 0; i < SHEETS; i++)
        free((char *)sources[i].text);
    flint_cleanup();
    return status;
}
