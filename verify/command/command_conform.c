/* coulomb-tether conform: is an implementation of these equations, in whatever language, right? */
#include <errno.h>
#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <time.h>

#include "command/command.h"
#include "conform/client.h"
#include "conform/diagnosis.h"
#include "conform/report.h"
#include "text/progress.h"

/* Digits that a motion has to reach unless --digits says otherwise; PROTOCOL.md has the reasons. */
static const double FLOW_DIGITS = 9, METHOD_DIGITS = 11;

enum { MOST_RANDOM = 100000000 }; /* of each operation: what is never answered is counted one by one */

/* What is asked for: a number a section of the sheet. */
struct choice {
    const struct sheet *sheet;
    bool *chosen, some;      /* some: --only has been given */
    double *digits;
};

static int take_digits(struct choice *c, const char *text)
{
    const char *equals = strchr(text, '=');
    char id[40], *end;
    if (equals == NULL)
        return usage_error(EXIT_USAGE, "--digits: expected ID=DIGITS, got '%.40s'", text);
    snprintf(id, sizeof id, "%.*s", (int)(equals - text), text);
    const struct section *s = section_argument(c->sheet, id);
    if (s == NULL)
        return EXIT_USAGE;
    const long digits = strtol(equals + 1, &end, 10);
    if (!is_motion(s))
        return usage_error(EXIT_USAGE, "--digits: expected a motion, %s is judged by E", id);
    if (end == equals + 1 || *end != '\0' || digits < 1 || digits > 30)
        return usage_error(EXIT_USAGE, "--digits: expected an integer from 1 to 30, got '%.40s'", equals + 1);
    c->digits[s - c->sheet->sections] = (double)digits;
    return EXIT_DONE;
}

static int take_all_digits(struct choice *c, const struct arguments *a)
{
    int status = EXIT_DONE, k = 0;
    const char *text;
    while (status == EXIT_DONE && (text = option_next(a, "--digits", &k)) != NULL)
        status = take_digits(c, text);
    return status;
}

static int choose(struct choice *c, const char *word)
{
    for (int level = 0; level < LEVELS; level++) {
        if (strcmp(word, level_names[level]) != 0)
            continue;
        for (int i = 0; i < c->sheet->section_count; i++)
            if (c->sheet->sections[i].method != METHOD_NONE && level_of(&c->sheet->sections[i]) == level)
                c->chosen[i] = true;
        return EXIT_DONE;
    }
    const struct section *s = section_argument(c->sheet, word);
    if (s == NULL)
        return EXIT_USAGE;
    if (s->method == METHOD_NONE)
        return usage_error(EXIT_USAGE, "%s is a definition, it computes nothing", s->id);
    c->chosen[s - c->sheet->sections] = true;
    return EXIT_DONE;
}

/* ID,... of --only, levels among them; every operation without it. */
static int take_only(struct choice *c, const char *only)
{
    int status = EXIT_DONE;
    c->some = only != NULL;
    for (int i = 0; i < c->sheet->section_count; i++)
        c->chosen[i] = !c->some && c->sheet->sections[i].method != METHOD_NONE;
    char *words = text_copy(c->some ? only : ""), *rest = NULL;
    for (char *word = strtok_r(words, ",", &rest); word && status == EXIT_DONE; word = strtok_r(NULL, ",", &rest))
        status = choose(c, word);
    free(words);
    for (int i = 0; i < c->sheet->section_count && status == EXIT_DONE; i++)
        if (c->chosen[i])
            return EXIT_DONE;
    return status != EXIT_DONE ? status : usage_error(EXIT_USAGE, "--only: expected operations or levels, ID,...");
}

/* The questions; random ones about motions, which may have no end, only where they are asked for by name. */
static int take_questions(struct test_run *e, const struct arguments *a, const struct choice *c)
{
    uint64_t random = 0, significand = BINARY64;
    int status = option_number(a, "--random", &random);
    if (status == EXIT_DONE)
        status = option_number(a, "--seed", &e->sets.seed);
    if (status == EXIT_DONE)
        status = option_inputs(a, &e->sets.form);
    if (status == EXIT_DONE)
        status = option_number(a, "--significand", &significand);
    if (status == EXIT_DONE && option_given(a, "--random") != option_given(a, "--seed"))
        status = usage_error(EXIT_USAGE, "conform: expected --random N and --seed S together");
    if (status == EXIT_DONE && random > MOST_RANDOM)
        status = usage_error(EXIT_USAGE, "--random: expected at most %d vectors an operation", MOST_RANDOM);
    if (status == EXIT_DONE && significand != BINARY32 && significand != BINARY64 && significand != BINARY128)
        status = usage_error(EXIT_USAGE, "--significand: expected 24, 53 or 113");
    if (status != EXIT_DONE)
        return status;
    e->significand = (int)significand;
    e->range = option_given(a, "--range");
    double *digits = xrealloc(NULL, (size_t)c->sheet->section_count, sizeof *digits);
    for (int i = 0; i < c->sheet->section_count; i++) {
        const struct section *s = &c->sheet->sections[i];
        if (!c->chosen[i])
            continue;
        digits[e->sets.count] = c->digits[i];
        test_sets_add(&e->sets, s, is_motion(s) && !c->some ? 0 : random, e->significand,
                      e->range || e->from_file);
    }
    test_run_begin(e, digits);
    free(digits);
    return EXIT_DONE;
}

/* The table, the file, and the exit code that they come to. */
static int print_report(struct test_run *e, const struct arguments *a, const char *client, const char *errors)
{
    const struct totals sum = report_totals(e);
    const char *name = option_value(a, "--report");
    const struct report r = {e, client, errors, (double)clock() / CLOCKS_PER_SEC, diagnose};
    report_text(&r, stdout);
    int status = output_finished();
    const int why = name != NULL ? report_write(&r, name) : 0;
    if (why != 0)
        return usage_error(EXIT_FAILED_CHECK, "%s: %s", name, strerror(why));
    if (sum.failed == 0 && sum.passed == 0)
        return usage_error(EXIT_FAILED_CHECK, "conform: nothing was answered, every vector was skipped");
    return sum.failed > 0 ? EXIT_FAILED_CHECK : status;
}

/* ---- a client ---- */

/* The run, with its progress on a terminal. */
struct watched {
    struct test_run *run;
    struct progress progress;
};

static size_t ask(void *context, char *room, size_t size)
{
    return test_run_ask(((struct watched *)context)->run, room, size);
}

static bool hear(void *context, const char *bytes, size_t size, bool *answered)
{
    struct watched *w = context;
    const bool on = test_run_hear(w->run, bytes, size);
    *answered = memchr(bytes, '\n', size) != NULL;
    progress_show(&w->progress, w->run->next, w->run->sets.total);
    return on;
}

/* What the end of the client means; EXIT_USAGE where it was none. */
static int conclude(struct test_run *e, enum ending ending, int status, const char *name)
{
    const bool signalled = WIFSIGNALED(status);
    if (ending == ENDING_EXIT && status != 0 && e->heard == 0)
        return usage_error(EXIT_USAGE, "client '%s': ended with %s %d before its first answer", name,
                           signalled ? "signal" : "exit status", signalled ? WTERMSIG(status) : WEXITSTATUS(status));
    const uint64_t answered = e->next, total = e->sets.total;
    if (ending == ENDING_EXIT && (status != 0 || answered < total))
        snprintf(e->ended, sizeof e->ended, "with %s %d after %" PRIu64 " of %" PRIu64 " answers", signalled ? "signal" : "exit status",
                 signalled ? WTERMSIG(status) : WEXITSTATUS(status), answered, total);
    if (ending == ENDING_TIMEOUT)
        test_run_end(e, OUTCOME_TIMEOUT);
    else
        test_run_end(e, ending == ENDING_EXIT && signalled ? OUTCOME_CRASH : OUTCOME_MISSING);
    if (ending == ENDING_STOPPED && e->unended < LONGEST_UNENDED)
        test_run_note(e, OUTCOME_FLOOD);
    else if (ending == ENDING_EXIT && !signalled && status != 0)
        test_run_note(e, OUTCOME_EXIT);
    return EXIT_DONE;
}

static int run_client(struct test_run *e, const struct arguments *a, char **client)
{
    double timeout = 60.0;
    const char *text = option_value(a, "--timeout");
    char *end = NULL;
    if (text != NULL)
        timeout = strtod(text, &end);
    if (text != NULL && (*end != '\0' || !(timeout > 0.0 && timeout <= 1e6)))
        return usage_error(EXIT_USAGE, "--timeout: expected seconds, more than 0, got '%.40s'", text);
    struct client c;
    struct watched w = {e, progress_begin(false)};
    const struct conversation talk = {&w, ask, hear};
    const int why = client_start(&c, client);
    if (why != 0)
        return usage_error(status_of_name(why), "client '%s': %s", client[0], strerror(why));
    const enum ending ending = client_converse(&c, &talk, timeout);
    const int status = client_close(&c); /* an interrupt ends the program here */
    progress_end(&w.progress);
    if (ending == ENDING_BROKEN) /* LCOV_EXCL_BR_LINE: a failing system call, make faults */
        return usage_error(EXIT_FAILED_CHECK, "client '%s': %s", client[0], strerror(c.why)); /* LCOV_EXCL_LINE: the same */
    const int concluded = conclude(e, ending, status, client[0]);
    c.tail[c.tail_length] = '\0';
    return concluded != EXIT_DONE ? concluded : print_report(e, a, client[0], c.tail);
}

/* ---- a file ---- */

enum { MOST_CELLS = 64 };

struct answers_file {
    FILE *file;
    const char *name;
    unsigned long row;
    char line[LONGEST_LINE + 2];
    bool too_long;
    int status;
};

/* A line more, without its end, and at most what is too long for an answer; false at the end, and after a complaint. */
static bool read_line(struct answers_file *f)
{
    size_t length = 0, heard = 0;
    int c = f->status == EXIT_DONE ? getc(f->file) : EOF;
    f->row++;
    for (; c != EOF && c != '\n' && heard < LONGEST_UNENDED; c = getc(f->file), heard++)
        if (length <= LONGEST_LINE)
            f->line[length++] = c == '\0' ? '\1' : (char)c;
    f->line[length] = '\0';
    f->too_long = length > LONGEST_LINE;
    if (heard == LONGEST_UNENDED)
        f->status = usage_error(EXIT_USAGE, "%s: line %lu does not end", f->name, f->row);
    else if (f->status == EXIT_DONE && c == EOF && ferror(f->file))
        f->status = usage_error(EXIT_FAILED_CHECK, "%s: %s", f->name, strerror(errno));
    return f->status == EXIT_DONE && (c != EOF || length > 0);
}

/* The cells of a line, as RFC 4180 quotes them; their number. */
static int cells_of(char *line, char **cells)
{
    int count = 0;
    const size_t length = strlen(line);
    if (length > 0 && line[length - 1] == '\r')
        line[length - 1] = '\0';
    for (char *from = line; from != NULL && count < MOST_CELLS;) {
        char *to = from;
        bool quoted = false;
        cells[count++] = to;
        for (; *from != '\0' && (quoted || *from != ','); from++) {
            const bool mark = *from == '"', twice = mark && quoted && from[1] == '"';
            from += twice;
            quoted = mark && !twice ? !quoted : quoted;
            if (!mark || twice)
                *to++ = *from;
        }
        from = *from == ',' ? from + 1 : NULL;
        *to = '\0';
    }
    return count;
}

/* Which cells hold the id and the outputs; false after a complaint. */
static bool take_header(char *line, const struct section *s, const char *name, int *columns)
{
    char *cells[MOST_CELLS];
    const int count = cells_of(line, cells);
    for (int i = 0; i <= s->output_count; i++) {
        const char *wanted = i == 0 ? "id" : s->outputs[i - 1]->name;
        columns[i] = -1;
        for (int k = count; k-- > 0;) /* of a motion the first state is the initial one, the second the output */
            if (strcmp(cells[k], wanted) == 0 && columns[i] < 0)
                columns[i] = k;
        if (columns[i] < 0) {
            usage_error(EXIT_USAGE, "%s: missing column '%s', expected id and every output of %s", name, wanted, s->id);
            return false;
        }
    }
    return true;
}

static void say(struct test_run *e, const char *text)
{
    test_run_hear(e, text, strlen(text));
}

/* A row as a client would say it; blank outputs mean `invalid`. */
static void hear_row(struct test_run *e, char *line, const int *columns, int outputs)
{
    char *cells[MOST_CELLS];
    const int count = cells_of(line, cells);
    bool blank = true;
    say(e, columns[0] < count ? cells[columns[0]] : "");
    for (int i = 1; i <= outputs; i++) {
        if (columns[i] >= count || *cells[columns[i]] == '\0')
            continue;
        say(e, " ");
        say(e, cells[columns[i]]);
        blank = false;
    }
    say(e, blank ? " invalid\n" : "\n");
}

/* The header's columns; then row after row. */
static void hear_file(struct test_run *e, struct answers_file *f, const struct section *s)
{
    int columns[MOST_OUTPUTS + 1] = {0};
    if (!read_line(f))
        f->status = f->status != EXIT_DONE ? f->status
                                           : usage_error(EXIT_USAGE, "%s: expected a header, id and every output of %s", f->name, s->id);
    else if (f->too_long)
        f->status = usage_error(EXIT_USAGE, "%s: line 1 is longer than %d bytes, expected a header", f->name, LONGEST_LINE);
    else if (!take_header(f->line, s, f->name, columns))
        f->status = EXIT_USAGE;
    while (f->status == EXIT_DONE && read_line(f)) {
        if (!f->too_long) {
            hear_row(e, f->line, columns, s->output_count);
            continue;
        }
        say(e, f->line);
        say(e, "\n");
    }
}

static int read_answers(struct test_run *e, const struct arguments *a, const struct section *s)
{
    struct answers_file *f = xrealloc(NULL, 1, sizeof *f);
    *f = (struct answers_file){.name = option_value(a, "--answers"), .status = EXIT_DONE};
    f->file = fopen(f->name, "r");
    if (f->file == NULL) {
        f->status = usage_error(status_of_name(errno), "%s: %s", f->name, strerror(errno));
    } else {
        e->asked = e->sets.total;
        hear_file(e, f, s);
        fclose(f->file);
    }
    if (f->status == EXIT_DONE) {
        test_run_end(e, OUTCOME_MISSING);
        f->status = print_report(e, a, f->name, "");
    }
    const int status = f->status;
    free(f);
    return status;
}

/* ---- the command ---- */

static int print_all_kills(const struct choice *c)
{
    bool fine = true;
    puts("id,mistakes");
    for (int i = 0; i < c->sheet->section_count; i++)
        if (c->chosen[i])
            fine = kills_print(&c->sheet->sections[i], c->digits[i]) && fine;
    const int status = output_finished();
    return fine ? status : EXIT_FAILED_CHECK;
}

static int conform(const struct arguments *a, struct choice *c)
{
    const bool file = option_given(a, "--answers"), kills = option_given(a, "--kills");
    if (file + kills + (a->client != NULL) != 1)
        return usage_error(EXIT_USAGE, "conform: expected -- CLIENT ARGS..., or --answers FILE.csv ID");
    if (file != (a->word_count == 1))
        return usage_error(EXIT_USAGE, file ? "--answers: expected the id of an operation after the file"
                                         : "conform: unexpected argument '%s', a client stands after --", a->words[0]);
    if (file && section_argument(c->sheet, a->words[0]) == NULL) /* of several operations no header tells whose outputs it has */
        return EXIT_USAGE;
    if (file && (option_given(a, "--only") || option_given(a, "--random")))
        return usage_error(EXIT_USAGE, "--answers: expected without --only and --random");
    const char *name = option_value(a, "--report");
    if (name != NULL && report_format(name) == REPORT_NONE)
        return usage_error(EXIT_USAGE, "--report: expected a file .xml or .json, got '%.100s'", name);
    int status = take_only(c, file ? a->words[0] : option_value(a, "--only"));
    if (status != EXIT_DONE || kills)
        return status != EXIT_DONE ? status : print_all_kills(c);
    struct test_run *e = xrealloc(NULL, 1, sizeof *e);
    memset(e, 0, sizeof *e);
    e->from_file = file;
    status = take_questions(e, a, c);
    if (status == EXIT_DONE) {
        status = file ? read_answers(e, a, e->comparators[0].operation->section) : run_client(e, a, a->client);
        test_run_clear(e);
    }
    free(e);
    return status;
}

int command_conform(const struct arguments *a)
{
    const struct sheet *sheet = &a->paper->sheet;
    const size_t sections = (size_t)sheet->section_count;
    struct choice c = {.sheet = sheet,
                       .chosen = xrealloc(NULL, sections, sizeof *c.chosen),
                       .digits = xrealloc(NULL, sections, sizeof *c.digits)};
    for (size_t i = 0; i < sections; i++)
        c.digits[i] = sheet->sections[i].method >= METHOD_RK4_LINEAR ? METHOD_DIGITS : FLOW_DIGITS;
    int status = take_all_digits(&c, a);
    if (status == EXIT_DONE && a->client != NULL && *a->client == NULL)
        status = usage_error(EXIT_USAGE, "conform: expected a client after --");
    if (status == EXIT_DONE)
        status = conform(a, &c);
    free(c.chosen);
    free(c.digits);
    return status;
}
