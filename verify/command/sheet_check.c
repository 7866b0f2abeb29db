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

/* 0, or -1 and what is wrong. */
static int check(const struct sources *s, struct message *why)
{
    struct paper paper;
    struct derivations steps;
    struct statements claims;
    if (paper_open(&paper, s, why) != 0)
        return -1;
    int status = derivations_open(&steps, &paper, why);
    if (status == 0) {
        status = statements_read(&claims, &steps, &paper.claims, why);
        if (status == 0)
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
    int status = 0;
    if (count <= SHEETS) {
        fputs("usage: sheet-check EQUATIONS DERIVATIONS CLAIMS [ARGUMENTS...]\n", stderr);
        return 2;
    }
    for (int i = 0; i < SHEETS && status == 0; i++) {
        sources[i].name = arguments[i + 1];
        sources[i].text = file_text(arguments[i + 1], &sources[i].length);
        if (sources[i].text == NULL) {
            message_set(&why, "%s: cannot be read", arguments[i + 1]);
            status = -1;
        }
    }
    const struct sources s = {.equations = sources[0], .derivations = sources[1], .claims = sources[2]};
    if (status == 0)
        status = count > SHEETS + 1 ? program_run(&s, count - SHEETS, arguments + SHEETS) : check(&s, &why);
    if (why.text[0] != '\0')
        fprintf(stderr, "%s\n", why.text);
    for (int i = 0; i < SHEETS; i++)
        free((char *)sources[i].text);
    flint_cleanup();
    return status < 0 ? 1 : status;
}
