#include "command/command.h"

#include <errno.h>
#include <inttypes.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "text/decimal.h"
#include "text/scope.h"
#include "text/whole_file.h"

int usage_error(int status, const char *format, ...)
{
    char text[8192]; /* as long as a path is */
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    message_printable(text);
    fprintf(stderr, "coulomb-tether: %s\n", text);
    return status;
}

int unknown_name(const char *what, const char *name, const char *near, const char *see)
{
    return usage_error(EXIT_USAGE, "%s '%.95s'%s%s%s", what, name, near ? ", did you mean '" : *see ? ", see coulomb-tether " : "",
                       near ? near : see, near ? "'?" : "");
}

/* ---- arguments ---- */

/* "--every=5": the option that a text names, its value after the sign of equality. */
static bool names_option(const char *text, const char *name)
{
    const size_t length = strlen(name);
    return strncmp(text, name, length) == 0 && (text[length] == '\0' || text[length] == '=');
}

/* Of an option that the subcommand has not: whose it is, or what it may have been meant to be. */
static int unknown_option(const struct arguments *a, const char *text)
{
    enum { MOST_KNOWN = 64 };
    const char *known[MOST_KNOWN] = {"--help"};
    int count = 1;
    char text_of[256] = "", what[64], see[64];
    for (const struct option *o = options; o->name != NULL; o++) {
        if (option_belongs(o, a->subcommand))
            known[count++] = o->name;
        if (names_option(text, o->name))
            add_text(text_of, sizeof text_of, " ", o->of);
    }
    if (*text_of != '\0')
        return usage_error(EXIT_USAGE, "%s: %s does nothing here, it belongs to: %s", a->subcommand->name, text, text_of);
    snprintf(what, sizeof what, "%s: unknown option", a->subcommand->name);
    snprintf(see, sizeof see, "help %s", a->subcommand->name);
    return unknown_name(what, text, nearest_name(text, known, (size_t)count, sizeof *known), see);
}

static int take_option(struct arguments *a, int count, char **texts, int *i)
{
    const char *text = texts[*i], *equals = strchr(text, '=');
    const struct option *o = options;
    while (o->name != NULL && !(option_belongs(o, a->subcommand) && names_option(text, o->name)))
        o++;
    if (o->name == NULL)
        return unknown_option(a, text);
    if (option_given(a, o->name) && !o->repeated)
        return usage_error(EXIT_USAGE, "%s: given twice, expected once", o->name);
    if (o->argument == NULL && equals != NULL)
        return usage_error(EXIT_USAGE, "%s: takes no value", o->name);
    const char *value = o->argument == NULL ? "" : equals != NULL ? equals + 1 : *i + 1 < count ? texts[++*i] : "";
    if (o->argument != NULL && *value == '\0')
        return usage_error(EXIT_USAGE, "%s: expected a value after it, %s", o->name, o->argument);
    a->given[a->given_count++] = (struct given){o, value};
    return EXIT_DONE;
}

static int unexpected_argument(const struct arguments *a, const char *text)
{
    return usage_error(EXIT_USAGE, "%s: unexpected argument '%s', see coulomb-tether help %s", a->subcommand->name, text,
                       a->subcommand->name);
}

/* Whether one of the ways to use the subcommand has this in it. */
static bool has_way(const struct subcommand *s, const char *what)
{
    bool has = false;
    for (int i = 0; s->ways[i] != NULL; i++)
        has = has || strstr(s->ways[i], what) != NULL;
    return has;
}

static int take_argument(struct arguments *a, int count, char **texts, int *i)
{
    char *text = texts[*i];
    if (*text == '\0')
        return usage_error(EXIT_USAGE, "%s: an argument is empty", a->subcommand->name);
    if (*text == '-' && text[1] != '\0')
        return take_option(a, count, texts, i);
    if (strchr(text, '=') != NULL && has_way(a->subcommand, "=VALUE")) {
        a->assignments[a->assignment_count++] = text;
        return EXIT_DONE;
    }
    if (strchr(text, '=') != NULL || a->word_count == a->subcommand->words)
        return unexpected_argument(a, text);
    a->words[a->word_count++] = text;
    return EXIT_DONE;
}

/* Whether there is one of the things without which an option does nothing. */
static bool has_company(const struct arguments *a, const char *with)
{
    if (with == NULL || (a->word_count == 0 && word_in(with, "|", "")) || (a->client != NULL && word_in(with, "|", "--")))
        return true;
    if (a->word_count > 0 && (word_in(with, "|", a->words[0]) || (word_in(with, "|", "ID") && strcmp(a->words[0], "-") != 0)))
        return true;
    for (int i = 0; i < a->given_count; i++)
        if (word_in(with, "|", a->given[i].option->name))
            return true;
    return false;
}

/* Of an option without what it goes with. */
static int out_of_place(const struct arguments *a, const struct option *o)
{
    char with[128] = "", *rest = NULL, *copy = text_copy(o->with);
    for (char *word = strtok_r(copy, "|", &rest); word != NULL; word = strtok_r(NULL, "|", &rest))
        add_text(with, sizeof with, " or ", strcmp(word, "--") == 0 ? "a client after --" : word);
    free(copy);
    return usage_error(EXIT_USAGE, "%s: %s does nothing here, it goes with %s%s", a->subcommand->name, o->name, with,
                       word_in(o->with, "|", "") ? " or no word" : "");
}

/* Whether a word of a way stands for itself. */
static bool is_choice(const char *word)
{
    return (*word >= 'a' && *word <= 'z') || (*word >= '0' && *word <= '9');
}

/* The first word has to be one that a way begins with, unless one of them begins with any, or with none. */
static int check_word(const struct arguments *a)
{
    enum { MOST_CHOICES = 32 };
    const char *known[MOST_CHOICES], *word = a->word_count > 0 ? a->words[0] : NULL;
    char texts[512] = "", what[512], *rest = NULL;
    int count = 0;
    bool fine = false;
    for (int i = 0; a->subcommand->ways[i] != NULL; i++) {
        const char *way = a->subcommand->ways[i];
        fine = fine || (*way == '\0' ? word == NULL : !is_choice(way));
        snprintf(what, sizeof what, "%.*s", (int)strcspn(way, " "), way);
        add_text(texts, sizeof texts, "|", what);
    }
    for (char *choice = strtok_r(texts, "|", &rest); choice != NULL; choice = strtok_r(NULL, "|", &rest)) {
        known[count++] = choice;
        fine = fine || (word != NULL && strcmp(word, choice) == 0);
    }
    snprintf(what, sizeof what, "%s: expected ", a->subcommand->name);
    for (int i = 0; i < count; i++)
        add_text(what, sizeof what, i == 0 ? "" : i == count - 1 ? " or " : ", ", known[i]);
    if (fine)
        return EXIT_DONE;
    if (word == NULL)
        return usage_error(EXIT_USAGE, "%s", what);
    add_text(what, sizeof what, ", ", "got");
    return unknown_name(what, word, nearest_name(word, known, (size_t)count, sizeof *known), "");
}

int arguments_read(struct arguments *a, int count, char **texts)
{
    int status = EXIT_DONE;
    a->assignments = xrealloc(NULL, (size_t)count + 1, sizeof *a->assignments);
    a->given = xrealloc(NULL, (size_t)count + 1, sizeof *a->given);
    for (int i = 0; i < count && a->client == NULL && status == EXIT_DONE; i++) {
        if (strcmp(texts[i], "--") == 0 && has_way(a->subcommand, "-- "))
            a->client = texts + i + 1;
        else
            status = take_argument(a, count, texts, &i);
    }
    if (status == EXIT_DONE)
        status = check_word(a);
    for (int i = 0; i < a->given_count && status == EXIT_DONE; i++)
        if (!has_company(a, a->given[i].option->with))
            status = out_of_place(a, a->given[i].option);
    return status;
}

void arguments_clear(struct arguments *a)
{
    free(a->assignments);
    free(a->given);
}

const char *option_next(const struct arguments *a, const char *name, int *k)
{
    while (*k < a->given_count)
        if (strcmp(a->given[(*k)++].option->name, name) == 0)
            return a->given[*k - 1].value;
    return NULL;
}

const char *option_value(const struct arguments *a, const char *name)
{
    int k = 0;
    return option_next(a, name, &k);
}

bool option_given(const struct arguments *a, const char *name)
{
    return option_value(a, name) != NULL;
}

int option_digits(const struct arguments *a, long otherwise, long *digits)
{
    uint64_t number = (uint64_t)otherwise;
    const int status = option_number(a, "--digits", 1, 10000, &number);
    *digits = (long)number;
    return status;
}

int option_inputs(const struct arguments *a, enum input_form *form)
{
    const char *text = option_value(a, "--inputs");
    *form = INPUTS_SHORTEST;
    if (text == NULL)
        return EXIT_DONE;
    for (int i = 0; i < 3; i++)
        if (strcmp(text, input_forms[i]) == 0) {
            *form = (enum input_form)i;
            return EXIT_DONE;
        }
    return usage_error(EXIT_USAGE, "--inputs: expected shortest, exact or hex, got '%.40s'", text);
}

int option_number(const struct arguments *a, const char *name, uint64_t least, uint64_t most, uint64_t *number)
{
    const char *text = option_value(a, name);
    if (text == NULL)
        return EXIT_DONE;
    errno = 0;
    *number = strtoull(text, NULL, 10);
    if (strspn(text, "0123456789") == strlen(text) && *text != '\0' && errno == 0 && *number >= least && *number <= most)
        return EXIT_DONE;
    if (most == UINT64_MAX)
        return usage_error(EXIT_USAGE, "%s: expected a whole number below 2^64, got '%.40s'", name, text);
    return usage_error(EXIT_USAGE, "%s: expected from %" PRIu64 " to %" PRIu64 ", got '%.40s'", name, least, most, text);
}

/* What a literal is that is no finite number. */
static int refuse_literal(const char *name, const char *text, enum literal literal, bool exact)
{
    if (literal == LITERAL_MALFORMED)
        return usage_error(EXIT_USAGE, "%s: expected a number, got '%.40s'", name, text);
    if (literal == LITERAL_OVERFLOW)
        return usage_error(EXIT_FAILED_CHECK, "%s: '%.40s' is too large%s", name, text,
                           exact ? ", expected an exponent within +-5000 and at most 10000 digits"
                                 : " for binary64, --exact takes it as it is");
    return usage_error(EXIT_FAILED_CHECK, "%s: expected a finite number, got '%s'", name, text);
}

int finite_argument(fmpq_t value, const char *name, const char *text, bool exact)
{
    const enum literal literal = literal_read(value, text, exact);
    return literal == LITERAL_FINITE ? EXIT_DONE : refuse_literal(name, text, literal, exact);
}

/* Which of the known names an assignment sets; -1 after a complaint. */
static int assignment_index(const char *assignment, const char *const *known, int count,
                            const bool *seen)
{
    const char *equals = strchr(assignment, '=');
    char name[64];
    snprintf(name, sizeof name, "%.*s", (int)(equals - assignment), assignment);
    for (int i = 0; i < count; i++) {
        if (strcmp(name, known[i]) != 0)
            continue;
        if (seen[i]) {
            usage_error(EXIT_USAGE, "%s: given twice, expected once", name);
            return -1;
        }
        return i;
    }
    const char *near = nearest_name(name, known, (size_t)count, sizeof *known);
    char names[1024] = "";
    for (int i = 0; i < count; i++)
        add_text(names, sizeof names, " ", known[i]);
    usage_error(EXIT_USAGE, "unknown name '%s',%s%s%s there are: %s", name, near ? " did you mean '" : "", near ? near : "",
                near ? "'?" : "", names);
    return -1;
}

int read_assignments(const struct arguments *a, const char *const *known, int count, bool exact,
                     const bool *may_be_infinite, bool *seen, struct input *values, const char **refused)
{
    *refused = NULL;
    for (int k = 0; k < a->assignment_count; k++) {
        int i = assignment_index(a->assignments[k], known, count, seen);
        if (i < 0)
            return EXIT_USAGE;
        seen[i] = true;
        const char *text = strchr(a->assignments[k], '=') + 1;
        enum literal literal = literal_read(&values[i].value, text, exact);
        if (literal == LITERAL_MALFORMED)
            return refuse_literal(known[i], text, literal, exact);
        values[i].infinite = literal == LITERAL_INFINITE && may_be_infinite[i];
        if (*refused == NULL && literal != LITERAL_FINITE && !values[i].infinite)
            *refused = a->assignments[k];
    }
    return EXIT_DONE;
}

int refuse_assignment(const char *assignment, bool exact)
{
    const char *equals = strchr(assignment, '=');
    char name[64];
    SCOPE(fmpq, value);
    snprintf(name, sizeof name, "%.*s", (int)(equals - assignment), assignment);
    return refuse_literal(name, equals + 1, literal_read(value, equals + 1, exact), exact);
}

const struct section *section_argument(const struct sheet *sheet, const char *id)
{
    const struct section *found = section_find(sheet, id);
    if (found == NULL)
        unknown_name("unknown operation", id, NEAREST(id, sheet->sections, sheet->section_count, id), "equations");
    return found;
}

const struct section *operation_argument(const struct arguments *a)
{
    if (a->word_count == 0) {
        usage_error(EXIT_USAGE, "%s: expected the id of an operation, see coulomb-tether equations", a->subcommand->name);
        return NULL;
    }
    const struct section *s = section_argument(&a->paper->sheet, a->words[0]);
    if (s != NULL && s->method == METHOD_NONE) {
        usage_error(EXIT_USAGE, "%s is a definition, it computes nothing", s->id);
        return NULL;
    }
    return s;
}

void print_list(const char *const *texts, int count, int width)
{
    width -= count == 0 ? printf("-") : 0;
    for (int i = 0; i < count; i++)
        width -= printf("%s%s", i ? " " : "", texts[i]);
    printf("%*s", width > 0 ? width : 0, "");
}

int output_finished(void)
{
    const int why = stream_error(stdout);
    if (why == EPIPE) /* the reader has seen enough */
        return EXIT_FAILED_CHECK;
    return why == 0 ? EXIT_DONE : usage_error(EXIT_FAILED_CHECK, "standard output: %s", strerror(why));
}
