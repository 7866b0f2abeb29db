/* Targets: the program as a function, and what clients of the oracle say. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "command/command.h"
#include "evaluate/errors.h"
#include "conform/report.h"
#include "targets.h"
#include "tests/paper.h"

/*
 * With these bytes (NULL: none) for the files that it reads. Standard error has a line exactly where the status is not
 * 0; what a file's answers fail in is a table on standard output.
 */
static void run_program(int count, char **arguments, const char *bytes, size_t size)
{
    char *errors = NULL, *output = NULL;
    size_t room;
    FILE *const error = stderr, *const out = stdout;
    stderr = open_memstream(&errors, &room);
    stdout = open_memstream(&output, &room);
    apart_begin(bytes, size);
    const struct sources sources = embedded_sources();
    const int status = program_run(&sources, count, arguments);
    apart_end();
    fclose(stderr);
    fclose(stdout);
    stderr = error;
    stdout = out;
    lines_of(output);
    const int lines = lines_of(errors);
    require(status >= 0 && status <= 2, "exit status 0, 1 or 2", errors);
    require(lines == (status != 0) || (status == 1 && bytes != NULL && lines == 0), "one line for a failure, else none",
            errors);
    free(errors);
    free(output);
}

/* A line is an argument; what stands after a zero byte is standard input. */
void command_line(const char *bytes, size_t size)
{
    enum { MOST = 40 };
    char *text = text_of(bytes, size), *arguments[MOST + 2] = {"coulomb-tether"}, *at = text;
    const size_t length = strlen(text);
    FILE *const in = stdin;
    int count = 1;
    while (at != NULL && count <= MOST) {
        arguments[count++] = at;
        at = strchr(at, '\n');
        if (at != NULL)
            *at++ = '\0';
    }
    const bool piped = length + 1 < size;
    stdin = fmemopen(piped ? text + length + 1 : "\n", piped ? size - length - 1 : 1, "r");
    run_program(count, arguments, NULL, 0);
    fclose(stdin);
    stdin = in;
    free(text);
}

/* The first line has the operation and options, the others are the file. */
void answers(const char *bytes, size_t size)
{
    enum { MOST = 8 };
    char *text = text_of(bytes, size), *rest = NULL;
    char *arguments[MOST + 5] = {"coulomb-tether", "conform", "--answers", "answers.csv"};
    const size_t length = strcspn(text, "\n"), after = length < size ? length + 1 : size;
    int count = 4;
    text[length] = '\0';
    for (char *word = strtok_r(text, " ", &rest); word && count < MOST + 4; word = strtok_r(NULL, " ", &rest))
        arguments[count++] = word;
    run_program(count, arguments, &bytes[after], size - after);
    free(text);
}

/* ---- the oracle ---- */

/*
 * Of the first byte five bits choose operations, two say how many bits the client's numbers have, and the last whether
 * anything has been asked before it speaks. The rest is what it says, in two pieces.
 */
void protocol(const char *bytes, size_t size)
{
    static const char *const ids[] = {"eq07", "eq21", "eq30", "eq41roots", "eq42"};
    static const int significands[] = {BINARY32, BINARY64, BINARY128, BINARY64};
    static struct test_run e; /* 100 kB */
    char room[1 << 14], *text = NULL;
    const unsigned first = size > 0 ? (unsigned char)bytes[0] : 0;
    size_t length;
    memset(&e, 0, sizeof e);
    e.significand = significands[first >> 5 & 3];
    e.sets.seed = 1;
    e.journal = tmpfile();
    require(e.journal != NULL, "a file for the journal", "none");
    for (size_t i = 0; i < sizeof ids / sizeof *ids; i++)
        if (first >> i & 1)
            test_sets_add(&e.sets, section_find(sheet(), ids[i]), 2, e.significand, false);
    test_run_begin(&e);
    if (first & 128)
        test_run_ask(&e, room, sizeof room);
    const size_t half = size / 2;
    if (size > 0 && test_run_hear(&e, bytes + 1, half > 0 ? half - 1 : 0)) {
        while (test_run_ask(&e, room, sizeof room) > 0)
            ;
        if (half > 0)
            test_run_hear(&e, bytes + half, size - half);
    }
    test_run_end(&e, OUTCOME_MISSING);
    const struct report r = {&e, "client", "", 0.0, false};
    FILE *stream = open_memstream(&text, &length);
    report_text(&r, stream);
    fclose(stream);
    lines_of(text);
    free(text);
    apart_begin(NULL, 0);
    require(report_write(&r, "report.xml") == 0 && report_write(&r, "report.json") == 0, "reports", "none");
    apart_end();
    test_run_clear(&e);
}
