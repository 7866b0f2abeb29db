/* coulomb-tether conform: is an implementation of these equations, in whatever language, right? */
#include <errno.h>
#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include "command/command.h"
#include "conform/client.h"
#include "conform/diagnosis.h"
#include "conform/report.h"
#include "text/csv.h"
#include "text/whole_file.h"

/* Digits that a motion has to reach unless --digits says otherwise; PROTOCOL.md has the reasons. */
static const double FLOW_DIGITS = 9, METHOD_DIGITS = 11;

/* The first --digits about an operation, ID=D; NULL: there is none. */
static const char *digits_given(const struct arguments *a, const char *id)
{
    const size_t length = strlen(id);
    const char *text = NULL;
    for (int k = 0; (text = option_next(a, "--digits", &k)) != NULL && !(strncmp(text, id, length) == 0 && text[length] == '=');)
        ;
    return text;
}

/* Those that a motion has to reach. */
static double digits_due(const struct arguments *a, const struct section *s)
{
    const char *text = digits_given(a, s->id);
    return text != NULL ? strtod(strchr(text, '=') + 1, NULL) : s->method >= METHOD_RK4_LINEAR ? METHOD_DIGITS : FLOW_DIGITS;
}

static int check_digits(const struct arguments *a)
{
    const char *text;
    for (int k = 0; (text = option_next(a, "--digits", &k)) != NULL;) {
        char id[40];
        int digits = 0, length = 0;
        if (sscanf(text, "%39[^=]=%3d%n", id, &digits, &length) != 2 || text[length] != '\0' || digits < 1 || digits > 30)
            return usage_error(EXIT_USAGE, "--digits: expected ID=DIGITS, an integer from 1 to 30, got '%.40s'", text);
        const struct section *s = section_argument(&a->paper->sheet, id);
        if (s == NULL)
            return EXIT_USAGE;
        if (!is_motion(s))
            return usage_error(EXIT_USAGE, "--digits: expected a motion, %s is judged by E", id);
        if (digits_given(a, id) != text)
            return usage_error(EXIT_USAGE, "--digits: expected %s once, got '%.40s' and '%.40s'", id, digits_given(a, id), text);
    }
    return EXIT_DONE;
}

enum { LONGEST_WORD = LONGEST_ID + 1 };
enum asked { NOTHING, SOME_VECTORS, ALL_VECTORS };

/* The next of words with commas between them, from *at on; false after the last. */
static bool next_word(const char **at, char word[LONGEST_WORD + 1])
{
    *at += strspn(*at, ",");
    const size_t length = strcspn(*at, ",");
    snprintf(word, LONGEST_WORD + 1, "%.*s", (int)length, *at);
    *at += length;
    return length > 0;
}

/* What such words ask of a section: by its level, its id, or a vector's name, which goes on after a hyphen. Without words, all. */
static enum asked asked_of(const char *only, const struct section *s)
{
    const size_t length = strlen(s->id);
    char word[LONGEST_WORD + 1];
    enum asked most = only == NULL ? ALL_VECTORS : NOTHING;
    while (only != NULL && most < ALL_VECTORS && next_word(&only, word))
        if (strcmp(word, s->id) == 0 || strcmp(word, level_names[level_of(s)]) == 0)
            most = ALL_VECTORS;
        else if (strncmp(word, s->id, length) == 0 && word[length] == '-')
            most = SOME_VECTORS;
    return s->method == METHOD_NONE ? NOTHING : most;
}

static int check_only(const struct sheet *sheet, const char *only)
{
    char word[LONGEST_WORD + 1];
    if (only != NULL && only[strspn(only, ",")] == '\0')
        return usage_error(EXIT_USAGE, "--only: expected operations, levels or vectors, ID,...");
    while (only != NULL && next_word(&only, word)) {
        int i = 0;
        while (i < sheet->section_count && asked_of(word, &sheet->sections[i]) == NOTHING)
            i++;
        if (i < sheet->section_count)
            continue;
        word[strcspn(word, "-")] = '\0';
        if (section_argument(sheet, word) != NULL)
            usage_error(EXIT_USAGE, "%s is a definition, it computes nothing", word);
        return EXIT_USAGE;
    }
    return EXIT_DONE;
}

/* A set of a section's vectors, or of those that --only names. */
static int take_set(struct test_run *e, const struct arguments *a, const char *only, const struct section *s, uint64_t random)
{
    char word[LONGEST_WORD + 1];
    const enum asked asked = asked_of(only, s);
    if (asked == NOTHING)
        return EXIT_DONE;
    struct test_set *set = test_sets_add(&e->sets, s, is_motion(s) && only == NULL ? 0 : random, e->significand, e->range || e->any_order);
    if (set == NULL)
        return EXIT_FAILED_CHECK;
    set->digits = digits_due(a, s);
    while (asked == SOME_VECTORS && next_word(&only, word))
        if (asked_of(word, s) == SOME_VECTORS && !test_sets_want(&e->sets, word))
            return unknown_name("--only: unknown vector", word, NEAREST(word, set->golden, set->golden_count, id), "conform --questions");
    return EXIT_DONE;
}

/* Whether there is a vector of that name, which --only may leave out. */
static bool is_vector(const struct test_run *e, const struct sheet *sheet, const char *id, uint64_t random)
{
    struct test_sets sets = {.seed = e->sets.seed};
    char operation[40];
    snprintf(operation, sizeof operation, "%.*s", (int)strcspn(id, "-"), id);
    const struct section *s = section_find(sheet, operation);
    const bool found = s != NULL && s->method != METHOD_NONE && test_sets_add(&sets, s, random, e->significand, true) != NULL &&
                       test_sets_find(&sets, id) != UINT64_MAX;
    test_sets_clear(&sets);
    return found;
}

/* A vector a line of those that may fail, # before what is said of them. */
static int take_expectations(struct test_run *e, const struct sheet *sheet, const char *name, uint64_t random)
{
    char line[256];
    int status = EXIT_DONE;
    FILE *file = fopen(name, "r");
    if (file == NULL)
        return usage_error(EXIT_FAILED_CHECK, "%s: %s", name, strerror(errno));
    for (int number = 1; status == EXIT_DONE && fgets(line, sizeof line, file) != NULL; number++) {
        if (strlen(line) == sizeof line - 1 && line[sizeof line - 2] != '\n')
            for (int byte = 0; byte != '\n' && byte != EOF; byte = getc(file)) /* the rest of the line, where its reason is long */
                ;
        char *rest = NULL, *id = strtok_r(line, " \t\r\n", &rest);
        if (id == NULL || *id == '#')
            continue;
        message_printable(id);
        const uint64_t position = test_sets_find(&e->sets, id);
        if (position == UINT64_MAX && !is_vector(e, sheet, id, random))
            status = usage_error(EXIT_USAGE, "%s: line %d: unknown vector '%.95s'", name, number, id);
        if (position == UINT64_MAX)
            continue;
        *APPENDED(e->expected, e->expected_count) = (struct expectation){.position = position};
    }
    if (status == EXIT_DONE && ferror(file))
        status = usage_error(EXIT_FAILED_CHECK, "%s: %s", name, strerror(errno));
    fclose(file);
    return status;
}

/* --report and -o are the same; NULL: none is wanted. */
static const char *report_name(const struct arguments *a)
{
    const char *name = option_value(a, "--report");
    return name != NULL ? name : option_value(a, "-o");
}

/* The questions; random ones about motions, which may have no end, only where they are asked for by name. */
static int take_questions(struct test_run *e, const struct arguments *a, const char *only)
{
    const struct sheet *sheet = &a->paper->sheet;
    const uint64_t random = option_number(a, "--random");
    int status = EXIT_DONE;
    if (option_given(a, "--random") != option_given(a, "--seed"))
        return usage_error(EXIT_USAGE, "conform: expected --random N and --seed S together");
    e->sets.seed = option_number(a, "--seed");
    e->sets.form = option_inputs(a);
    e->sets.motions = a->paper->motions.text;
    e->significand = (int)option_number(a, "--significand");
    e->range = option_given(a, "--range");
    for (int i = 0; i < sheet->section_count && status == EXIT_DONE; i++)
        status = take_set(e, a, only, &sheet->sections[i], random);
    test_run_begin(e);
    if (status == EXIT_DONE && option_given(a, "--expect"))
        status = take_expectations(e, sheet, option_value(a, "--expect"), random);
    if (status == EXIT_DONE && (option_given(a, "--all") || report_name(a) != NULL) && (e->journal = tmpfile()) == NULL)
        status = usage_error(EXIT_FAILED_CHECK, "a temporary file: %s", strerror(errno)); /* LCOV_EXCL_LINE: only without a place for one */
    return status;
}

/* The table, the file, and the exit code that they come to. */
static int print_report(struct test_run *e, const struct arguments *a, const char *client, const char *errors)
{
    const struct totals sum = report_totals(e, -1);
    const char *name = report_name(a);
    const struct report r = {e, client, errors, (double)clock() / CLOCKS_PER_SEC, option_given(a, "--all")};
    int why = e->journal != NULL ? stream_error(e->journal) : 0;
    if (why != 0)
        return usage_error(EXIT_FAILED_CHECK, "a temporary file: %s", strerror(why)); /* LCOV_EXCL_LINE: only on a full disk */
    report_text(&r, stdout);
    int status = output_finished();
    if (e->journal_error != 0)
        return usage_error(EXIT_FAILED_CHECK, "a temporary file: %s", strerror(e->journal_error)); /* LCOV_EXCL_LINE: only on a failing disk */
    why = name != NULL ? report_write(&r, name) : 0;
    if (why != 0)
        return usage_error(EXIT_FAILED_CHECK, "%s: %s", name, strerror(why));
    if (sum.failed + sum.passed + sum.expected == 0)
        return usage_error(EXIT_FAILED_CHECK, "conform: nothing was answered, every vector was skipped");
    return sum.failed > 0 || stray_count(e) > 0 || *e->ended != '\0' ? EXIT_FAILED_CHECK : status;
}

/* ---- a client ---- */

/* What the end of the client means; EXIT_USAGE where it was none. */
static int conclude(struct test_run *e, enum ending ending, int status, const char *name, double timeout)
{
    const bool signalled = WIFSIGNALED(status), stopped = ending == ENDING_STOPPED;
    const int number = signalled ? WTERMSIG(status) : WEXITSTATUS(status);
    char how[60];
    if (ending == ENDING_EXIT && status != 0 && e->heard == 0)
        return usage_error(EXIT_USAGE, "client '%s': ended with %s %d before its first answer", name,
                           signalled ? "signal" : "exit status", number);
    snprintf(how, sizeof how, status == 0 ? "ended" : "ended with %s %d", signalled ? "signal" : "exit status", number);
    if (stopped)
        snprintf(how, sizeof how, "was stopped for %s", e->unended < LONGEST_UNENDED ? "so many lines that answer nothing" : "a line without end");
    else if (ending == ENDING_TIMEOUT)
        snprintf(how, sizeof how, "was stopped for %g s of silence", timeout);
    if (status != 0 || ending != ENDING_EXIT || (e->next < e->sets.total && stray_count(e) == 0))
        snprintf(e->ended, sizeof e->ended, "%s after %" PRIu64 " of %" PRIu64 " answers", how, e->heard - stray_count(e),
                 e->sets.total);
    test_run_end(e, ending == ENDING_TIMEOUT ? OUTCOME_TIMEOUT : ending == ENDING_EXIT && signalled ? OUTCOME_CRASH : OUTCOME_MISSING);
    return EXIT_DONE;
}

/* Of a client that could not be started: wrong usage, unless the machine is out of means. */
static int status_of_start(int why)
{
    const bool out_of_means = why == ENOMEM || why == EAGAIN || why == EMFILE || why == ENFILE || why == EIO;
    return out_of_means ? EXIT_FAILED_CHECK : EXIT_USAGE;
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
    const int why = client_start(&c, client);
    /* EACCES: some folder of PATH may not be searched */
    const bool here = (why == ENOENT || why == EACCES) && strchr(client[0], '/') == NULL && access(client[0], F_OK) == 0;
    if (why != 0)
        return usage_error(status_of_start(why), here ? "client '%s': %s, did you mean './%s'?" : "client '%s': %s", client[0], strerror(why), client[0]);
    const enum ending ending = client_converse(&c, e, timeout);
    const int status = client_close(&c); /* an interrupt ends the program here */
    if (c.why != 0) /* LCOV_EXCL_BR_LINE: a failing system call, make faults */
        return usage_error(EXIT_FAILED_CHECK, "client '%s': %s", client[0], strerror(c.why)); /* LCOV_EXCL_LINE: the same */
    const int concluded = conclude(e, ending, status, client[0], timeout);
    c.tail[c.tail_length] = '\0';
    return concluded != EXIT_DONE ? concluded : print_report(e, a, client[0], c.tail);
}

/* ---- a file ---- */

static void say(struct test_run *e, const char *text)
{
    test_run_hear(e, text, strlen(text));
}

/* The columns of the id and of the outputs, one each; false after a complaint. */
static bool take_header(const struct csv *c, const struct section *s, int *columns)
{
    for (int i = 0; i <= s->output_count; i++) {
        const char *wanted = i == 0 ? "id" : s->outputs[i - 1]->name;
        int found = 0;
        columns[i] = csv_column(c, wanted);
        for (int k = 0; k < c->count; k++)
            found += strcmp(c->cells[k], wanted) == 0;
        if (found != 1) {
            usage_error(EXIT_USAGE, "%s: line %lu: expected id and every output of %s in one column each, found %d of '%s'", c->name, c->line, s->id,
                        found, wanted);
            return false;
        }
    }
    return true;
}

/* As pandas, numpy and R write it. */
static bool is_blank(const char *cell)
{
    return *cell == '\0' || strcmp(cell, "NaN") == 0 || strcmp(cell, "nan") == 0 || strcmp(cell, "NA") == 0;
}

/* A row as a client would say it, told by its line; where all outputs are blank, that is `invalid`. */
static void hear_row(struct test_run *e, const struct csv *c, const int *columns, int outputs)
{
    bool blank = true;
    for (int i = 1; i <= outputs; i++)
        blank = blank && is_blank(c->cells[columns[i]]);
    e->heard = c->line - 1;
    say(e, c->cells[columns[0]]);
    for (int i = 1; i <= outputs && !blank; i++) {
        say(e, " ");
        for (char *at = c->cells[columns[i]]; (at = strchr(at, '\n')) != NULL;)
            *at = ' ';
        say(e, c->cells[columns[i]]);
    }
    say(e, blank ? " invalid\n" : "\n");
}

static int hear_csv(struct test_run *e, struct csv *c, const struct section *s)
{
    int columns[MOST_OUTPUTS + 1] = {0};
    struct message why;
    enum csv_result result = csv_next(c, &why);
    if (result == CSV_END)
        return usage_error(EXIT_USAGE, "%s: expected a header, id and every output of %s", c->name, s->id);
    if (result == CSV_ROW && !take_header(c, s, columns))
        return EXIT_USAGE;
    const int cells = c->count;
    while (result == CSV_ROW && (result = csv_next(c, &why)) == CSV_ROW) {
        if (c->count != cells)
            return usage_error(EXIT_USAGE, "%s: line %lu has %d cell%s, the header %d%s", c->name, c->line, c->count, c->count == 1 ? "" : "s", cells,
                               c->count > cells && c->separator == ',' ? ": a decimal comma?" : "");
        hear_row(e, c, columns, s->output_count);
    }
    return result == CSV_END ? EXIT_DONE : usage_error(result == CSV_MALFORMED ? EXIT_USAGE : EXIT_FAILED_CHECK, "%s", why.text);
}

/* Whether a table begins there: its first column is id, or "id". */
static bool is_table(const char *text, size_t size)
{
    const size_t quote = size > 0 && *text == '"', end = 2 + 2 * quote;
    return size > end && strncmp(text + quote, "id", 2) == 0 && (text[end] == ',' || text[end] == ';' || text[end] == '\t');
}

/* What a client has written to a file, in the order of the questions. */
static int hear_transcript(struct test_run *e, FILE *file, const char *name)
{
    char bytes[1 << 12];
    size_t size;
    for (bool first = true; (size = fread(bytes, 1, sizeof bytes, file)) > 0; first = false) {
        /* a byte order mark before the first line is an editor's, not the client's */
        const size_t skip = first && size >= 3 && memcmp(bytes, "\357\273\277", 3) == 0 ? 3 : 0;
        if (first && is_table(bytes + skip, size - skip))
            return usage_error(EXIT_USAGE, "%s: a table of no known operation, or through a pipe: expected the operation's id after it", name);
        if (!test_run_hear(e, bytes + skip, size - skip))
            return usage_error(EXIT_FAILED_CHECK, "%s: expected answers, found lines that answer nothing", name);
    }
    return ferror(file) ? usage_error(EXIT_FAILED_CHECK, "%s: %s", name, strerror(errno)) : EXIT_DONE;
}

/*
 * Whose answers the file has, by the name of its first row's vector; NULL, and the file's beginning, where it is no CSV with a
 * column id. What comes through a pipe is read once, and so a transcript.
 */
static const struct section *section_of_file(const struct sheet *sheet, FILE *file, const char *name)
{
    if (fseek(file, 0, SEEK_SET) != 0)
        return NULL;
    OWNED(csv) c = csv_on(file, name, LONGEST_LINE);
    struct message why;
    const struct section *s = NULL;
    if (csv_next(&c, &why) == CSV_ROW) {
        const int id = csv_column(&c, "id");
        if (id >= 0 && csv_next(&c, &why) == CSV_ROW && id < c.count) {
            c.cells[id][strcspn(c.cells[id], "-")] = '\0';
            s = section_find(sheet, c.cells[id]);
        }
    }
    rewind(file);
    return s;
}

/* Of one operation as CSV, which the word or the file names, or else of all that are asked. */
static int read_answers(struct test_run *e, const struct arguments *a)
{
    const struct sheet *sheet = &a->paper->sheet;
    const char *name = option_value(a, "--answers");
    FILE *file = fopen(name, "r");
    if (file == NULL)
        return usage_error(EXIT_FAILED_CHECK, "%s: %s", name, strerror(errno));
    const struct section *s = a->word_count == 1 ? section_argument(sheet, a->words[0]) : section_of_file(sheet, file, name);
    int status = a->word_count == 1 && s == NULL ? EXIT_USAGE : EXIT_DONE;
    if (s != NULL && (option_given(a, "--only") || option_given(a, "--random")))
        status = usage_error(EXIT_USAGE, "--answers: expected without --only and --random, the file has the answers of %s", s->id);
    e->any_order = s != NULL;
    const char *only = s != NULL ? s->id : option_value(a, "--only");
    if (status == EXIT_DONE)
        status = check_only(sheet, only);
    if (status == EXIT_DONE)
        status = take_questions(e, a, only);
    e->asked = e->sets.total;
    if (status == EXIT_DONE && s != NULL) {
        OWNED(csv) csv = csv_on(file, name, LONGEST_LINE);
        status = hear_csv(e, &csv, s);
    } else if (status == EXIT_DONE) {
        status = hear_transcript(e, file, name);
    }
    fclose(file);
    if (status != EXIT_DONE)
        return status;
    test_run_end(e, OUTCOME_MISSING);
    return print_report(e, a, name, "");
}

/* The lines of all questions, for a target that cannot be started from here. */
static int print_questions(struct test_run *e)
{
    static char room[1 << 16];
    size_t size;
    while ((size = test_run_ask(e, room, sizeof room)) > 0)
        fwrite(room, 1, size, stdout);
    return EXIT_DONE;
}

/* ---- the command ---- */

static int print_all_kills(const struct arguments *a, const char *only)
{
    const struct sheet *sheet = &a->paper->sheet;
    bool fine = true;
    puts("id,mistakes");
    for (int i = 0; i < sheet->section_count; i++)
        if (asked_of(only, &sheet->sections[i]) != NOTHING)
            fine = kills_print(&sheet->sections[i], digits_due(a, &sheet->sections[i])) && fine;
    return fine ? EXIT_DONE : EXIT_FAILED_CHECK;
}

int command_conform(const struct arguments *a)
{
    const char *only = option_value(a, "--only");
    if (check_digits(a) != EXIT_DONE)
        return EXIT_USAGE;
    if (a->client != NULL && *a->client == NULL)
        return usage_error(EXIT_USAGE, "conform: expected a client after --");
    const bool file = option_given(a, "--answers"), kills = option_given(a, "--kills"), questions = option_given(a, "--questions");
    if (!file && a->word_count > 0)
        return usage_error(EXIT_USAGE, "conform: unexpected argument '%s', a client stands after --, did you mean conform -- %s%s%s?", a->words[0],
                           a->words[0], a->word_count > 1 ? " " : "", a->word_count > 1 ? a->words[1] : "");
    if (file + kills + questions + (a->client != NULL) != 1)
        return usage_error(EXIT_USAGE, "conform: expected -- CLIENT ARGS..., or --answers FILE, or --questions");
    if (a->word_count > 1)
        return usage_error(EXIT_USAGE, "--answers: expected the id of one operation or none, got '%s' and '%s'", a->words[0], a->words[1]);
    const char *name = report_name(a);
    if (option_given(a, "--report") && option_given(a, "-o"))
        return usage_error(EXIT_USAGE, "-o: expected without --report, it is the same");
    if (name != NULL && !kills && !questions && report_format(name) == REPORT_NONE)
        return usage_error(EXIT_USAGE, "%s: expected a file .xml or .json, got '%.100s'", option_given(a, "-o") ? "-o" : "--report", name);
    int status = file ? EXIT_DONE : check_only(&a->paper->sheet, only);
    if (status != EXIT_DONE || kills)
        return status != EXIT_DONE ? status : print_all_kills(a, only);
    struct test_run *e = xrealloc(NULL, 1, sizeof *e);
    memset(e, 0, sizeof *e);
    status = file ? read_answers(e, a) : take_questions(e, a, only);
    if (status == EXIT_DONE && questions)
        status = print_questions(e);
    if (status == EXIT_DONE && a->client != NULL)
        status = run_client(e, a, a->client);
    if (e->summaries != NULL)
        test_run_clear(e);
    free(e);
    return status;
}
