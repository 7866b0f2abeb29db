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

/* Of one that takes a whole number: what is given, or what its table says of it unless given, or 0. */
uint64_t option_number(const struct arguments *a, const char *name);
enum input_form option_inputs(const struct arguments *a);

/* A finite number, called `name`: a malformed one is wrong usage, one that is none (nan, inf, past binary64) outside the domain. */
int finite_argument(fmpq_t value, const char *name, const char *text, bool exact);

/* A name that may be given a value, NAME=VALUE or NAME=VALUE+-RADIUS, and where these go. */
struct assignment {
    const char *name;
    struct input *value;
    fmpq *radius; /* NULL: it has none */
    bool may_be_infinite;
    const char *text, *radius_text; /* as they are given; NULL: they are not */
};

/* Which of the known names are given: EXIT_DONE or EXIT_USAGE. Then their values, and all have to be numbers before one is refused. */
int take_names(const struct arguments *a, struct assignment *known, int count);
int take_values(const struct assignment *known, int count, bool exact);

/* The operation that the first word names; NULL after a complaint. */
const struct section *operation_argument(const struct arguments *a);

/* The section of that id; NULL after a complaint that suggests the nearest. */
const struct section *section_argument(const struct sheet *sheet, const char *id);

/* All about a subcommand; NULL: about the program. An unknown one is wrong usage, the nearest name suggested. */
void help_print(const struct sheet *sheet, const struct subcommand *s);
int unknown_subcommand(const char *name);

/* The whole program, on those sheets: its exit status. */
int program_run(const struct sources *sources, int count, char **arguments);

/* A number in decimal, with what is said of it; group: a heading that it shares with its neighbours, as meaning it may be NULL. */
struct number {
    const char *group, *name, *unit, *meaning;
    char *value;
};

/* A line each, or with --json an object of all; id: the operation whose outputs they are, or NULL. */
void print_numbers(const struct arguments *a, const char *id, long digits, const struct number *numbers, int count);

/* Texts, blanks between them, padded to a width; "-" where there is none. */
void print_list(const char *const *texts, int count, int width);

/* Everything that was printed is out: EXIT_DONE, or EXIT_FAILED_CHECK after a complaint. */
int output_finished(void);

#endif
