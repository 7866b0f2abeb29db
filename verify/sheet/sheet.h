/*
 * The formula sheet, paper/equations.yaml, as the programs see it: quantities, and a section for each
 * equation with its inputs, its outputs' formulas and, where the print differs, the print's own.
 */
#ifndef CT_SHEET_H
#define CT_SHEET_H

#include "formula/expression.h"
#include "text/tree.h"

/* Of a section, and of a known mistake. */
enum { MOST_INPUTS = 40, MOST_OUTPUTS = 16, MOST_CHANGES = 12 };

enum domain { DOMAIN_FINITE, DOMAIN_POSITIVE, DOMAIN_NOT_NEGATIVE, DOMAIN_POSITIVE_OR_INFINITE };
extern const char *const domain_names[]; /* "finite", "> 0", ... as the sheet has them; NULL after the last */

struct quantity {
    const char *name, *unit, *meaning;
    enum domain domain;
    double low, high;       /* random vectors: the magnitude is drawn between these, evenly in its logarithm */
    bool either_sign;       /* ... and the sign too                                                          */
    const char *value;      /* Table 1 and the initial values of the simulation; NULL for the rest           */
    const char *example;    /* what the paper's case makes of it otherwise                                   */
};

/* A row of Table 1: scale times the printed number is in SI. */
struct table_row {
    const char *name, *printed, *unit, *scale;
};

enum comparison { LESS, GREATER, NOT_LESS, INTEGER };

/* node (comparison) 0; or node an integer, and such a condition stands after all others */
struct condition {
    const char *text;
    int node;
    enum comparison comparison;
};

/* What a section computes: the corrected formulas, or the printed ones. */
struct formulas {
    struct program program;
    int outputs[MOST_INPUTS];       /* nodes, in the order of the section's outputs; or inputs that a mistake makes for a method */
    const char *text[MOST_OUTPUTS]; /* the outputs' formulas                        */
    const char **let;               /* name and formula by turns                    */
    int lets;
    struct condition *conditions;
    int count;                      /* of conditions                                */
};

struct relation {
    const char *equation;       /* "6a" */
    const char *text;           /* "left = right" */
    struct formulas sides;      /* over the quantities; outputs 0 and 1 */
};

/* A golden vector of its own: the paper's case with some inputs replaced, NULL where not. */
struct special {
    const char *name, *flags;
    const char *texts[MOST_INPUTS]; /* literals, of t several with blanks between: a vector each */
};

/*
 * A known mistake of implementations: an input, a subexpression or an output is something else, written in
 * the names of the section as it should be; or another section stands in its place.
 */
enum place { PLACE_INPUT, PLACE_LET, PLACE_OUTPUT };

struct known_mistake {
    const char *name;
    const char *as;             /* the other section, NULL: none */
    struct {
        enum place place;
        const char *name, *formula;
    } changes[MOST_CHANGES];
    int count;
};

/* How a section's outputs come about: by its formulas, or by an algorithm. */
enum method { METHOD_NONE, METHOD_FORMULA, METHOD_ROOTS, METHOD_FLOW_LINEAR, METHOD_FLOW_NONLINEAR,
              METHOD_RK4_LINEAR, METHOD_RK4_NONLINEAR };

struct sheet;

struct section {
    const struct sheet *sheet;  /* that it is of */
    const char *id, *title, *note, *reason;
    const char *defines;        /* the symbol that it is the definition of; NULL: none, or it computes nothing */
    const char *kind;           /* of its verdicts: equation, or beyond, where it is none of the paper's */
    const char *equations[8];   /* the numbers it stands for: "2a", "2b", "2c" */
    int numbers;
    enum method method;         /* METHOD_NONE: a definition, computes nothing */
    const struct quantity *inputs[MOST_INPUTS], *outputs[MOST_OUTPUTS];
    int input_count, output_count;
    struct formulas corrected, printed;
    bool differs;               /* the print differs: `printed` is filled, `reason` says why */
    struct relation *relations;
    struct special *specials;
    struct known_mistake *mistakes;
    int relation_count, special_count, mistake_count;
    double K;                   /* the largest E that the oracle lets pass */
};

struct sheet {
    struct quantity *quantities;
    struct section *sections;
    struct table_row *table1;
    struct known_mistake *mistakes;         /* of every section that has the names they change */
    int quantity_count, section_count, row_count, mistake_count;
    double K;                   /* of every section that says nothing of its own */
    struct tree *tree;          /* everything the above points into */
};

/* Reads a sheet from memory, which is not needed any more then; `name` stands in messages: "name:line:column: expected ...". */
int sheet_read(struct sheet *s, const char *text, size_t length, const char *name, struct message *why);
void sheet_clear(struct sheet *s);

const struct section *section_find(const struct sheet *s, const char *id);
const struct quantity *quantity_find(const struct sheet *s, const char *name);

/* The place of that name in a list, and among a section's inputs; -1: it is not there. */
int quantity_place(const struct quantity *const *list, int count, const char *name);
int input_place(const struct section *s, const char *name);

#endif
