/*
 * What a linearisation drops: how large it may become on a stated set of states, proved in balls.
 *
 * The formal order of a step says how fast the difference of two formulas vanishes, not how large it is.
 * Here |formula| <= bound is proved for every state in a box, by its mean-value form on ever smaller boxes.
 */
#ifndef CT_REMAINDER_H
#define CT_REMAINDER_H

#include "formula/expression.h"
#include "text/tree.h"

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

#endif
