/*
 * The derivation steps, paper/derivations.yaml: identities that lead from equations and principles to equations, their
 * proof, and what binds a step to the equations that it names.
 */
#ifndef CT_DERIVATION_H
#define CT_DERIVATION_H

#include "proof/identities.h"
#include "sheet/paper.h"

enum { MOST_EQUATIONS = 16 }; /* that a step leads from, or to */

/*
 * What a linearisation drops: how large it may become on a stated set of states, proved in balls.
 *
 * The formal order of a step says how fast the difference of two formulas vanishes, not how large it is.
 * Here |formula| <= bound is proved for every state in a box, by its mean-value form on ever smaller boxes.
 */
enum remainder_state {
    REMAINDER_PROVED,
    REMAINDER_EXCEEDED, /* a state of the set is above the bound                */
    REMAINDER_TOO_WIDE, /* proved, but half of it was not found to be reached   */
    REMAINDER_UNDECIDED /* not proved with the boxes that are allowed           */
};

struct remainder_proof {
    enum remainder_state state;
    int boxes;
    int percent; /* of the bound are reached, at least, somewhere in the set */
};

struct remainder {
    const char *equation, *text, *unit, *at_most; /* equation: the number of the one that drops it */
    const struct yaml *on, *at;                   /* the states, as they are written; the bound is written there */
    struct program program; /* the formula alone; what it rests on are its inputs */
    int node;
    fmpq *low, *high;       /* of each input; equal where it is fixed */
    fmpq_t bound;
    struct remainder_proof proof; /* once it was asked for */
};

/* The formula of `node`, copied out of a program; its ranges and its bound are the caller's to fill in. */
void remainder_init(struct remainder *r, const struct program *p, int node);
void remainder_clear(struct remainder *r);

void remainder_prove(const struct remainder *r, struct remainder_proof *proof);

struct binding {
    struct message fault; /* empty: the step shows what it says; else file, line, column and what is wrong */
    int mutants;          /* formulas altered, one at a time */
};

struct step {
    const char *id, *title;
    const char *from[MOST_EQUATIONS], *to[MOST_EQUATIONS]; /* see the head of derivations.yaml */
    int from_count, to_count;
    const struct yaml *node;
    struct identities corrected, printed, lines;
    bool differs;                   /* `printed` is there, and must not hold */
    const struct yaml *line_map;    /* how: the algebra by hand, `lines`; NULL: there is none */
    struct remainder *remainders;   /* what is dropped, and how large that may be */
    int remainder_count;
    bool proved, bound;             /* whether that was asked for yet; what follows is empty before */
    struct proof proof, printed_proof, line_proof;
    struct binding binding;
};

struct derivations {
    struct tree *tree;              /* everything below points into it */
    const struct sheet *sheet;
    struct definitions definitions; /* principles, then properties     */
    struct step *steps;
    int principle_count, step_count;
};

/* Reads the steps, and their formulas. -1 and "name:line:column: expected ..." where it is broken. */
int derivations_read(struct derivations *d, const struct sheet *s, const char *text, size_t length,
                     const char *name, struct message *why);

/* The paper's own; -1, and `why`, where they are broken. */
int derivations_open(struct derivations *d, const struct paper *paper, struct message *why);
void derivations_clear(struct derivations *d);

/* The step of that id; NULL: there is none. */
struct step *step_named(const struct derivations *d, const char *id);

/* `remainders`, when the identities have been read; false after a complaint. */
bool step_read_remainders(const struct derivations *d, struct step *step, const struct scope *s);

/* ---- what `from` and `to` name ---- */

/* A formula that an entry stands for: an output or named subexpression of a section, or a side of a relation. */
struct entry_part {
    const struct section *section;
    const struct formulas *formulas;
    int node;
    const char *name, *equation; /* name: of a side, the relation's text; equation: its number; NULL of a definition */
};

/* The number of an output: those that no relation has are dealt out in turn; *alone (not NULL): it is this output's and no other's. */
const char *output_equation(const struct section *s, int output, bool *alone);

enum { MOST_PARTS = 64 };
int entry_parts(const struct derivations *d, const char *entry, struct entry_part *parts);

/* Whether the entry stands for what a formula takes of the sheet, or for something that rests on it. */
bool entry_concerns(const struct derivations *d, const char *entry, const struct use *u);

/* Whether it stands for an equation of this number ("6" and "6a" do for 6a, eq10lin and eq10.x1 for 10). */
bool entry_leads_to(const struct derivations *d, const char *entry, const char *equation);

/*
 * The first equation number of the sheet that neither is a definition (a section that computes nothing)
 * nor is reached, by steps, from definitions and principles; NULL: there is none.
 */
const char *derivations_gap(const struct derivations *d);

/* ---- what proves and binds a step ---- */

/* Whether it holds, what is printed instead does not, and what is dropped is bounded: proved when it is asked first. */
bool step_holds(struct step *s);

/* Its lines are proved too, and where it holds what it says of from and to is so: bound when it is asked first, which takes long. */
bool step_is_bound(const struct derivations *d, struct step *s);
void step_bind(const struct derivations *d, const struct step *s, struct binding *b);

#endif
