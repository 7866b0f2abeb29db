/*
 * The command line: subcommands, their arguments, and one clear line for each mistake.
 */
#ifndef CT_COMMAND_H
#define CT_COMMAND_H

#include <stdbool.h>
#include <stdint.h>

#include "evaluate/operation.h"
#include "evaluate/vectors.h"

enum { EXIT_DONE = 0, EXIT_FAILED_CHECK = 1, EXIT_USAGE = 2 };

/* What a subcommand accepts besides its plain words: flags, and options with a value. */
struct option {
    const char *name; /* "--digits" */
    bool has_value;
    const char *value; /* as given, NULL when it was not */
};

/* An argument list, split: words, NAME=VALUE, options. */
struct arguments {
    const char *subcommand;
    struct option *options;
    int option_count;
    const char *words[2];
    int word_count;
    char **assignments; /* in the order given, NAME=VALUE whole */
    int assignment_count;
};

/* One line on standard error after the program's name; returns the status it is given. */
#if defined(__GNUC__)
__attribute__((format(printf, 2, 3)))
#endif
int usage_error(int status, const char *format, ...);

/* ", did you mean 'x'?" or "". */
void suggest(char text[80], const char *mistaken, const char *const *known, int count);

/* Of a name that could not be opened or run: wrong usage, unless the machine is out of means. */
int status_of_name(int why);

/* Splits what stands after the subcommand; at most `words` plain words. EXIT_DONE or EXIT_USAGE. */
int arguments_split(struct arguments *a, int count, char **texts, int words);
bool option_given(const struct arguments *a, const char *name);
const char *option_value(const struct arguments *a, const char *name); /* of the options; NULL: not given */

/* --digits, 1 ... 10000. */
int option_digits(const struct arguments *a, long otherwise, long *digits);

/* --inputs shortest|exact|hex. */
int option_inputs(const struct arguments *a, enum input_form *form);

/* A whole number below 2^63 in decimal digits. */
int whole_number(const char *name, const char *text, uint64_t *value);

/*
 * The value of one literal called `name`. A malformed one is wrong usage, one that is no finite number
 * (nan, inf, past binary64) lies outside the domain; +inf passes where it may be.
 */
int literal_argument(const char *name, const char *text, bool exact, bool may_be_infinite,
                     struct input *value);

/*
 * All NAME=VALUE of an argument list into values[i] for known[i], and which were seen: EXIT_DONE or EXIT_USAGE. Wrong
 * usage weighs more than a domain, and so the first value that is no finite number is only kept in *refused (NULL:
 * there is none), to be refused once everything else has been found in order.
 */
int read_assignments(const struct arguments *a, const char *const *known, int count, bool exact,
                     const bool *may_be_infinite, bool *seen, struct input *values, const char **refused);
int refuse_assignment(const char *assignment, bool exact);

/* A text as a JSON string, quotes and all. */
void json_text(const char *text);

/* The section of that id; NULL after a complaint that suggests the nearest. */
const struct section *section_argument(const char *id);

/* Everything that was printed is out: EXIT_DONE, or EXIT_FAILED_CHECK after a complaint. */
int output_finished(void);

int command_equations(int count, char **arguments);
int command_eval(int count, char **arguments);
int command_table1(int count, char **arguments);
int command_figure(int count, char **arguments);
int command_trajectory(int count, char **arguments);
int command_verify(int count, char **arguments);
int command_vectors(int count, char **arguments);
int command_conform(int count, char **arguments);
int command_study(int count, char **arguments);
int command_datapackage(int count, char **arguments);
int command_typeset(int count, char **arguments);

#endif
