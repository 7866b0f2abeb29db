#include "command/command.h"

#include <errno.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "text/decimal.h"

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

int status_of_name(int why)
{
    const bool out_of_means = why == ENOMEM || why == EAGAIN || why == EMFILE || why == ENFILE || why == EIO;
    return out_of_means ? EXIT_FAILED_CHECK : EXIT_USAGE;
}

void suggest(char text[80], const char *mistaken, const char *const *known, int count)
{
    const char *near = nearest_name(mistaken, known, (size_t)count);
    text[0] = '\0';
    if (near != NULL)
        snprintf(text, 80, ", did you mean '%s'?", near);
}

static int take_option(struct arguments *a, int count, char **texts, int *i)
{
    const char *text = texts[*i], *equals = strchr(text, '=');
    size_t length = equals ? (size_t)(equals - text) : strlen(text);
    for (int k = 0; k < a->option_count; k++) {
        struct option *o = &a->options[k];
        if (strlen(o->name) != length || strncmp(o->name, text, length) != 0)
            continue;
        if (o->value != NULL)
            return usage_error(EXIT_USAGE, "%s: given twice, expected once", o->name);
        if (!o->has_value && equals)
            return usage_error(EXIT_USAGE, "%s: takes no value", o->name);
        o->value = !o->has_value ? "" : equals ? equals + 1 : *i + 1 < count ? texts[++*i] : NULL;
        if (o->value == NULL || (o->has_value && *o->value == '\0'))
            return usage_error(EXIT_USAGE, "%s: expected a value after it", o->name);
        return EXIT_DONE;
    }
    const char *known[16];
    char hint[80];
    for (int k = 0; k < a->option_count; k++)
        known[k] = a->options[k].name;
    suggest(hint, text, known, a->option_count);
    return usage_error(EXIT_USAGE, "%s: unknown option '%s'%s", a->subcommand, text, hint);
}

int arguments_split(struct arguments *a, int count, char **texts, int words)
{
    a->assignments = xrealloc(NULL, (size_t)count + 1, sizeof *a->assignments);
    for (int i = 0; i < count; i++) {
        int status = EXIT_DONE;
        if (strncmp(texts[i], "--", 2) == 0)
            status = take_option(a, count, texts, &i);
        else if (*texts[i] == '\0')
            status = usage_error(EXIT_USAGE, "%s: an argument is empty", a->subcommand);
        else if (strchr(texts[i], '=') != NULL)
            a->assignments[a->assignment_count++] = texts[i];
        else if (a->word_count < words)
            a->words[a->word_count++] = texts[i];
        else
            status = usage_error(EXIT_USAGE, "%s: unexpected argument '%s'", a->subcommand, texts[i]);
        if (status != EXIT_DONE) {
            free(a->assignments);
            a->assignments = NULL;
            return status;
        }
    }
    return EXIT_DONE;
}

const char *option_value(const struct arguments *a, const char *name)
{
    int k = 0;
    while (strcmp(a->options[k].name, name) != 0)
        k++;
    return a->options[k].value;
}

bool option_given(const struct arguments *a, const char *name)
{
    return option_value(a, name) != NULL;
}

int option_digits(const struct arguments *a, long otherwise, long *digits)
{
    const char *text = option_value(a, "--digits");
    char *end;
    *digits = otherwise;
    if (text == NULL)
        return EXIT_DONE;
    errno = 0;
    *digits = strtol(text, &end, 10);
    if (*text < '0' || *text > '9' || *end != '\0' || errno != 0 || *digits < 1 || *digits > 10000)
        return usage_error(EXIT_USAGE, "--digits: expected an integer from 1 to 10000, got '%s'", text);
    return EXIT_DONE;
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

int whole_number(const char *name, const char *text, uint64_t *value)
{
    char *end;
    errno = 0;
    *value = strtoull(text, &end, 10);
    if (strspn(text, "0123456789") != strlen(text) || *text == '\0' || errno != 0)
        return usage_error(EXIT_USAGE, "%s: expected a whole number below 2^64, got '%.40s'", name, text);
    return EXIT_DONE;
}

int literal_argument(const char *name, const char *text, bool exact, bool may_be_infinite,
                     struct input *value)
{
    switch (literal_read(&value->value, text, exact)) {
    case LITERAL_FINITE:
        return EXIT_DONE;
    case LITERAL_INFINITE:
        value->infinite = may_be_infinite;
        return may_be_infinite ? EXIT_DONE
                               : usage_error(EXIT_FAILED_CHECK, "%s: expected a finite number, got '%s'",
                                             name, text);
    case LITERAL_NAN:
    case LITERAL_NEGATIVE_INFINITE:
        return usage_error(EXIT_FAILED_CHECK, "%s: expected a finite number, got '%s'", name, text);
    case LITERAL_OVERFLOW:
        return usage_error(EXIT_FAILED_CHECK, "%s: '%.40s' is too large%s", name, text,
                           exact ? ", expected an exponent within +-5000 and at most 10000 digits"
                              : " for binary64, --exact takes it as it is");
    case LITERAL_MALFORMED:
        break;
    }
    return usage_error(EXIT_USAGE, "%s: expected a number, got '%.40s'", name, text);
}

/* Which of the known names an assignment sets; -1 after a complaint. */
static int assignment_index(const char *assignment, const char *const *known, int count,
                            const bool *seen)
{
    const char *equals = strchr(assignment, '=');
    char name[64], hint[80];
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
    suggest(hint, name, known, count);
    usage_error(EXIT_USAGE, "unknown name '%s'%s", name, hint);
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
            return literal_argument(known[i], text, exact, may_be_infinite[i], &values[i]);
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
    struct input value = {.infinite = false};
    snprintf(name, sizeof name, "%.*s", (int)(equals - assignment), assignment);
    fmpq_init(&value.value);
    int status = literal_argument(name, equals + 1, exact, false, &value);
    fmpq_clear(&value.value);
    return status;
}

void json_text(const char *text)
{
    putchar('"');
    for (; *text != '\0'; text++) {
        if (*text == '"' || *text == '\\')
            putchar('\\');
        if ((unsigned char)*text < 0x20)
            printf("\\u%04x", (unsigned)*text);
        else
            putchar(*text);
    }
    putchar('"');
}

const struct section *section_argument(const char *id)
{
    const struct section *found = section_find(sheet(), id);
    if (found != NULL)
        return found;
    const int count = sheet()->section_count;
    const char **known = xrealloc(NULL, (size_t)count, sizeof *known);
    char hint[80];
    for (int i = 0; i < count; i++)
        known[i] = sheet()->sections[i].id;
    suggest(hint, id, known, count);
    free(known);
    usage_error(EXIT_USAGE, "unknown operation '%.40s'%s", id, hint);
    return NULL;
}

int output_finished(void)
{
    if (fflush(stdout) == 0 && !ferror(stdout))
        return EXIT_DONE;
    if (errno == EPIPE) /* the reader has seen enough */
        return EXIT_FAILED_CHECK;
    return usage_error(EXIT_FAILED_CHECK, "standard output: %s", strerror(errno));
}
