#include "command/command.h"

#include <errno.h>
#include <inttypes.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "text/decimal.h"
#include "text/json.h"
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

/* Whether a text is one of the choices A|B|C; else a complaint, after "what: ", that has them all. */
static int check_choice(const char *what, const char *choices, const char *text)
{
    enum { MOST_CHOICES = 32 };
    const char *known[MOST_CHOICES];
    char texts[512], expected[512], *rest = NULL;
    int count = 0;
    snprintf(texts, sizeof texts, "%s", choices);
    for (char *choice = strtok_r(texts, "|", &rest); choice != NULL; choice = strtok_r(NULL, "|", &rest))
        known[count++] = choice;
    snprintf(expected, sizeof expected, "%s: expected ", what);
    for (int i = 0; i < count; i++)
        add_text(expected, sizeof expected, i == 0 ? "" : i == count - 1 ? " or " : ", ", known[i]);
    if (text == NULL)
        return usage_error(EXIT_USAGE, "%s", expected);
    add_text(expected, sizeof expected, ", ", "got");
    return word_in(choices, "|", text) ? EXIT_DONE
                                       : unknown_name(expected, text, nearest_name(text, known, (size_t)count, sizeof *known), "");
}

/* Whether a text is a whole number that the option takes. */
static int check_number(const struct option *o, const char *text)
{
    errno = 0;
    const uint64_t number = strtoull(text, NULL, 10);
    if (strspn(text, "0123456789") == strlen(text) && errno == 0 && number >= o->least && number <= o->most)
        return EXIT_DONE;
    if (o->most == UINT64_MAX)
        return usage_error(EXIT_USAGE, "%s: expected a whole number below 2^64, got '%.40s'", o->name, text);
    return usage_error(EXIT_USAGE, "%s: expected from %" PRIu64 " to %" PRIu64 ", got '%.40s'", o->name, o->least, o->most, text);
}

/* The option of that name, which may have its value behind it: "--every=5"; NULL: the subcommand has none. */
static const struct option *option_find(const struct subcommand *s, const char *text)
{
    for (const struct option *o = options; o->name != NULL; o++)
        if (option_belongs(o, s) && names_option(text, o->name))
            return o;
    return NULL;
}

static int take_option(struct arguments *a, int count, char **texts, int *i)
{
    const char *text = texts[*i], *equals = strchr(text, '=');
    const struct option *o = option_find(a->subcommand, text);
    if (o == NULL)
        return unknown_option(a, text);
    if (option_given(a, o->name) && !o->repeated)
        return usage_error(EXIT_USAGE, "%s: given twice, expected once", o->name);
    if (o->argument == NULL && equals != NULL)
        return usage_error(EXIT_USAGE, "%s: takes no value", o->name);
    const char *value = o->argument == NULL ? "" : equals != NULL ? equals + 1 : *i + 1 < count ? texts[++*i] : "";
    if (o->argument != NULL && *value == '\0')
        return usage_error(EXIT_USAGE, "%s: expected a value after it, %s", o->name, o->argument);
    a->given[a->given_count++] = (struct given){o, value};
    if (o->most > 0)
        return check_number(o, value);
    return o->argument != NULL && strchr(o->argument, '|') != NULL ? check_choice(o->name, o->argument, value) : EXIT_DONE;
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
    const char *word = a->word_count > 0 ? a->words[0] : NULL;
    char choices[512] = "", first[512];
    bool fine = false;
    for (int i = 0; a->subcommand->ways[i] != NULL; i++) {
        const char *way = a->subcommand->ways[i];
        fine = fine || (*way == '\0' ? word == NULL : !is_choice(way));
        snprintf(first, sizeof first, "%.*s", (int)strcspn(way, " "), way);
        add_text(choices, sizeof choices, "|", first);
    }
    return fine ? EXIT_DONE : check_choice(a->subcommand->name, choices, word);
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

uint64_t option_number(const struct arguments *a, const char *name)
{
    const struct option *option = option_find(a->subcommand, name);
    const char *given = option_value(a, name), *text = given == NULL && option != NULL ? option->otherwise : given;
    return text != NULL ? strtoull(text, NULL, 10) : 0;
}

enum input_form option_inputs(const struct arguments *a)
{
    const char *text = option_value(a, "--inputs");
    return text == NULL ? INPUTS_SHORTEST : strcmp(text, input_forms[INPUTS_EXACT]) == 0 ? INPUTS_EXACT
         : strcmp(text, input_forms[INPUTS_HEX]) == 0 ? INPUTS_HEX : INPUTS_SHORTEST;
}

/* The value of a literal; NULL for what may not be infinite. Where `domain` is not asked yet, all but a malformed one pass. */
static int take_literal(fmpq_t value, bool *infinite, const char *name, const char *text, bool exact, bool domain)
{
    const enum literal literal = literal_read(value, text, exact);
    if (infinite != NULL)
        *infinite = literal == LITERAL_INFINITE;
    if (literal == LITERAL_MALFORMED)
        return usage_error(EXIT_USAGE, "%s: expected a number, got '%.40s'", name, text);
    if (literal == LITERAL_FINITE || (literal == LITERAL_INFINITE && infinite != NULL) || !domain)
        return EXIT_DONE;
    if (literal == LITERAL_OVERFLOW)
        return usage_error(EXIT_FAILED_CHECK, "%s: '%.40s' is too large%s", name, text,
                           exact ? ", expected an exponent within +-5000 and at most 10000 digits"
                                 : " for binary64, --exact takes it as it is");
    return usage_error(EXIT_FAILED_CHECK, "%s: expected a finite number, got '%s'", name, text);
}

int finite_argument(fmpq_t value, const char *name, const char *text, bool exact)
{
    return take_literal(value, NULL, name, text, exact, true);
}

/* Which of the known names a text NAME=... begins with; NULL after a complaint. */
static struct assignment *assignment_named(const char *text, struct assignment *known, int count)
{
    char name[64], names[1024] = "";
    snprintf(name, sizeof name, "%.*s", (int)strcspn(text, "="), text);
    for (int i = 0; i < count; i++) {
        if (strcmp(name, known[i].name) == 0)
            return &known[i];
        add_text(names, sizeof names, " ", known[i].name);
    }
    const char *near = NEAREST(name, known, count, name);
    usage_error(EXIT_USAGE, "unknown name '%s',%s%s%s there are: %s", name, near ? " did you mean '" : "", near ? near : "",
                near ? "'?" : "", names);
    return NULL;
}

int take_names(const struct arguments *a, struct assignment *known, int count)
{
    for (int k = 0; k < a->assignment_count; k++) {
        struct assignment *x = assignment_named(a->assignments[k], known, count);
        if (x == NULL)
            return EXIT_USAGE;
        if (x->text != NULL)
            return usage_error(EXIT_USAGE, "%s: given twice, expected once", x->name);
        x->text = strchr(a->assignments[k], '=') + 1;
        char *sign = strstr(x->text, "+-");
        if (sign != NULL && x->radius == NULL)
            return usage_error(EXIT_USAGE, "%s: expected without +-%s", x->name,
                               option_given(a, "--set") ? "" : ", which is for the sets of trajectory nonlinear --set");
        if (sign != NULL) {
            *sign = '\0';
            x->radius_text = sign + 2;
        }
    }
    return EXIT_DONE;
}

int take_values(const struct assignment *known, int count, bool exact)
{
    int status = EXIT_DONE;
    for (int domain = 0; domain <= 1; domain++) /* wrong usage weighs more: all have to be numbers before one is refused */
        for (const struct assignment *x = known; x < known + count && status == EXIT_DONE; x++) {
            if (x->text != NULL)
                status = take_literal(&x->value->value, x->may_be_infinite ? &x->value->infinite : NULL, x->name, x->text, exact, domain);
            if (status == EXIT_DONE && x->radius_text != NULL)
                status = take_literal(x->radius, NULL, x->name, x->radius_text, exact, domain);
            if (status == EXIT_DONE && domain && x->radius_text != NULL && fmpq_sgn(x->radius) < 0)
                status = usage_error(EXIT_FAILED_CHECK, "%s: expected a number >= 0 after +-, got '%.40s'", x->name, x->radius_text);
        }
    return status;
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

void print_numbers(const struct arguments *a, const char *id, long digits, const struct number *numbers, int count)
{
    struct json j = json_on(stdout);
    for (const struct number *z = numbers; z < numbers + count && !option_given(a, "--json"); z++) {
        if (z->group != NULL && (z == numbers || z->group != z[-1].group))
            printf("# %s\n", z->group);
        printf("%s = %s %s%s%s\n", z->name, z->value, z->unit, z->meaning && *z->meaning ? "  # " : "", z->meaning ? z->meaning : "");
    }
    if (!option_given(a, "--json"))
        return;
    json_open(&j, NULL, '{');
    json_string(&j, "id", id);
    if (id != NULL)
        json_truth(&j, "as_printed", option_given(a, "--as-printed"));
    json_value(&j, "digits", "%ld", digits);
    json_open(&j, "outputs", '[');
    for (const struct number *z = numbers; z < numbers + count; z++)
        json_record(&j, NULL, "group", z->group, "name", z->name, "value", z->value, "unit", z->unit, "meaning", z->meaning);
    json_close(&j);
    json_close(&j);
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
