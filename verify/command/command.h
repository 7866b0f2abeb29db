/*
 * The command line: subcommands, their arguments, and one clear line for each mistake.
 */
#ifndef CT_COMMAND_H
#define CT_COMMAND_H

#include <stdbool.h>
#include <stdint.h>

#include "command/options.h"
#include "evaluate/operation.h"
#include "evaluate/vectors.h"
#include "sheet/paper.h"

enum { EXIT_DONE = 0, EXIT_FAILED_CHECK = 1, EXIT_USAGE = 2 };
enum { REPORTED_CHECK = 3 }; /* EXIT_FAILED_CHECK to the caller: a check failed, and what is printed is whole and says which */

/* An argument list, read: words, NAME=VALUE, options, and a client with its own arguments. */
struct arguments {
    const struct paper *paper;
    const struct subcommand *subcommand;
    const char *words[2];
    int word_count;
    char **assignments; /* in the order given, NAME=VALUE whole */
    int assignment_count;
    struct given {
        const struct option *option;
        const char *value; /* "" of a flag */
    } *given;
    int given_count;
    char **client; /* what follows --; NULL: there is none */
};

/* One line on standard error after the program's name; returns the status it is given. */
#if defined(__GNUC__)
__attribute__((format(printf, 2, 3)))
#endif
int usage_error(int status, const char *format, ...);

/* Wrong usage: what is unknown, its name, the known one that is near, or (NULL: none is) what lists all. */
int unknown_name(const char *what, const char *name, const char *near, const char *see);

/* Reads what follows a->subcommand, against the tables of options.h, with no sheet yet: EXIT_DONE or EXIT_USAGE. */
int arguments_read(struct arguments *a, int count, char **texts);
void arguments_clear(struct arguments *a);
bool option_given(const struct arguments *a, const char *name);
const char *option_value(const struct arguments *a, const char *name); /* NULL: not given */

/* The values of a repeated option one by one, *k = 0 before the first; NULL after the last. */
const char *option_next(const struct arguments *a, const char *name, int *k);

/* --digits, 1 ... 10000. */
int option_digits(const struct arguments *a, long otherwise, long *digits);

/* --inputs shortest|exact|hex. */
int option_inputs(const struct arguments *a, enum input_form *form);

/*
 * The value of a literal called `name`. A malformed one is wrong usage, one that is no finite number (nan, inf, past binary64)
 * lies outside the domain.
 */
int finite_argument(fmpq_t value, const char *name, const char *text, bool exact);

/*
 * All NAME=VALUE of an argument list into values[i] for known[i], and which were seen: EXIT_DONE or EXIT_USAGE. Wrong
 * usage weighs more than a domain, and so the first value that is no finite number is only kept in *refused (NULL:
 * there is none), to be refused once everything else has been found in order.
 */
int read_assignments(const struct arguments *a, const char *const *known, int count, bool exact,
                     const bool *may_be_infinite, bool *seen, struct input *values, const char **refused);
int refuse_assignment(const char *assignment, bool exact);

/* A whole number between these two, kept where the option is not given. */
int option_number(const struct arguments *a, const char *name, uint64_t least, uint64_t most, uint64_t *number);

/* The operation that the first word names; NULL after a complaint. */
const struct section *operation_argument(const struct arguments *a);

/* The section of that id; NULL after a complaint that suggests the nearest. */
const struct section *section_argument(const struct sheet *sheet, const char *id);

/* The whole program, on those sheets: its exit status. */
int program_run(const struct sources *sources, int count, char **arguments);

/* Texts, blanks between them, padded to a width; "-" where there is none. */
void print_list(const char *const *texts, int count, int width);

/* Everything that was printed is out: EXIT_DONE, or EXIT_FAILED_CHECK after a complaint. */
int output_finished(void);


#endif
