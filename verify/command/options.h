/*
 * The subcommands and their options, declared once: parsing and --help follow from these tables.
 */
#ifndef CT_OPTIONS_H
#define CT_OPTIONS_H

#include <stdbool.h>
#include <stdint.h>

struct arguments;

struct subcommand {
    const char *name;
    int (*run)(const struct arguments *a);
    const char *ways[5]; /* what may stand after the name, options in brackets apart; NULL after the last */
    int words;           /* plain words at most: no NAME=VALUE and no option */
    const char *does;
};

/*
 * An option of some subcommands. Where `with` is not NULL it does nothing but with one of the things named there, separated
 * by '|': a word of the command line (ID: any but -), an option, -- for a client, or no word at all (an empty one).
 */
struct option {
    const char *name, *argument; /* "--digits", "N"; no argument: a flag  */
    const char *of, *does;       /* of: subcommands, separated by blanks  */
    const char *unit, *otherwise; /* of the argument, and what it is unless given; NULL: none */
    const char *with;
    bool repeated;               /* may be given several times            */
    uint64_t least, most;        /* of a whole number; most = 0: it is none */
};

struct example {
    const char *line, *shows; /* the line follows the program's name */
};

/* Each ends with a name, or a line, that is NULL. */
extern const struct subcommand subcommands[];
extern const struct option options[];
extern const struct example examples[];

const struct subcommand *subcommand_find(const char *name);
bool option_belongs(const struct option *o, const struct subcommand *s);

/* Whether a word stands in a text of words, separated by any of these. */
bool word_in(const char *text, const char *separators, const char *word);

/* What the subcommands do: each returns the exit status. */
int command_equations(const struct arguments *a);
int command_eval(const struct arguments *a);
int command_table1(const struct arguments *a);
int command_figure(const struct arguments *a);
int command_trajectory(const struct arguments *a);
int command_design(const struct arguments *a);
int command_verify(const struct arguments *a);
int command_vectors(const struct arguments *a);
int command_conform(const struct arguments *a);
int command_study(const struct arguments *a);
int command_help(const struct arguments *a);

#endif
