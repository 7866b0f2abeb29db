/*
 * The derivation steps, paper/derivations.yaml, and their proof.
 *
 * A step is a list of equalities between formulas over free quantities. It is proved by evaluating both
 * sides exactly (arithmetic_series) at random points, until the chance that a false one has passed is
 * below 2^-100; degree.h has the reasoning.
 */
#ifndef CT_DERIVATION_H
#define CT_DERIVATION_H

#include "document.h"
#include "sheet.h"

enum {
    MOST_EQUATIONS = 16, /* that a step leads from, or to               */
    ENOUGH_BITS = 100    /* a false step passes with a chance below 2^-100 */
};

/* What a free quantity is drawn from: 2^64 integers, or so many rational points of the circle. */
enum kind { KIND_ANY, KIND_POSITIVE, KIND_ANGLE };

struct variable {
    enum kind kind;
    int power;   /* the drawn number is multiplied by epsilon^power */
};

struct equality {
    const char *text;
    int left, right;
    ulong degree; /* of the numerator of left - right */
};

/* What a square root is said to be equal to. */
struct root {
    const char *text;
    int node;
    bool positive; /* found to be */
};

/* What is put to the test: the step, or what becomes of it as printed. */
struct trial {
    struct program program;
    struct variable *variables; /* of its inputs */
    struct equality *shown;
    struct root *roots;
    char *needed;               /* needed[i]: something shown rests on node i                       */
    int *radicals;              /* nodes: the square roots that something shown rests on            */
    int shown_count, root_count, radical_count;
    slong terms;                /* of the series: order + 1                                         */
    ulong degree;               /* the largest of any equality, radicand = root^2 included          */
};

struct principle {
    const char *id, *text;
};

struct step {
    const char *id, *title, *note;
    const char *from[MOST_EQUATIONS], *to[MOST_EQUATIONS]; /* equation numbers; `from` principles too */
    int from_count, to_count;
    int order;                  /* the highest power of epsilon that is compared; -1: exact */
    const yaml_node_t *let;     /* NULL: there is none */
    struct trial corrected, printed;
    bool differs;               /* `printed` is there, and must not hold */
};

struct derivations {
    struct document document;   /* everything below points into it */
    const struct sheet *sheet;
    struct principle *principles;
    struct step *steps;
    int principle_count, step_count;
};

/* Reads the steps, and their formulas. -1 and "name:line:column: expected ..." where it is broken. */
int derivations_read(struct derivations *d, const struct sheet *s, const char *text, size_t length,
                     const char *name, struct message *why);
void derivations_clear(struct derivations *d);

/* Whether an entry of `from` or `to` ("6a", or "6" for all of it) stands for this equation number. */
bool stands_for(const char *entry, const char *equation);

/*
 * The first equation number of the sheet that neither is a definition (a section that computes nothing)
 * nor is reached, by steps, from definitions and principles; NULL: there is none.
 */
const char *derivations_gap(const struct derivations *d);

enum finding { FOUND_EQUAL, FOUND_DIFFERENT, FOUND_NOTHING };

struct proof {
    enum finding finding;
    int points, retries;  /* points tried with success, points replaced by others  */
    int bits;             /* a false step would pass with a chance below 2^-bits   */
    fmpz *drawn;          /* the numbers drawn: point by point, input by input     */
    slong allocated;
    char *evidence;       /* of what does not hold: the first coefficient, the point */
};

/* What a mapping {angles, positive, free, small, order, rates, let, roots, show} says; false after a complaint. */
bool trial_read(struct trial *t, const struct sheet *s, struct document *document, const yaml_node_t *mapping);
void trial_clear(struct trial *t);

/* What is known of a trial as soon as it is read: needed, radicals, degrees, signs of the roots. */
void trial_prepare(struct trial *t);

/* The same seed draws the same points. */
void trial_prove(const struct trial *t, ulong seed, struct proof *p);
void proof_clear(struct proof *p);

/* The graph of equations, principles and steps on standard output, for Graphviz's dot. */
void derivations_graph(const struct derivations *d);

#endif
