/*
 * Kinds of mistakes that no sheet can list, each told from the numbers of several failing vectors, and explaining those that
 * pass: in words, or "" where none fits. Nothing is concluded from one vector alone, or from zeros where other numbers are due in some vectors only.
 */
#ifndef CT_KINDS_H
#define CT_KINDS_H

#include "conform/conform.h"

/* The failing vectors of a summary that were answered in numbers, and those that pass: all as binary64, the truth too. */
struct evidence {
    const struct section *section;
    clock_t until;               /* of processor time, when no more is tried */
    double digits;               /* that a motion is due                     */
    int count;
    const struct record *records[MOST_KEPT];
    double x[MOST_KEPT][MOST_INPUTS], y[MOST_KEPT][MOST_OUTPUTS], exact[MOST_KEPT][MOST_OUTPUTS];
    double tolerance[MOST_KEPT][MOST_OUTPUTS]; /* of what is the same but for roundings, relative */
};

/* So little that no mistake of a formula makes it, relative, where roundings of the inputs do S; never more than tells nothing. */
double alike_within(double exact, double S, int significand);

/*
 * Of what an operation's formulas or roots come to. Nothing where too little is wrong to tell anything: in one vector, or where
 * the others have lost digits alone, or an input is the same in all, which may be what a factor is made of.
 */
void kind_of_formula(const struct evidence *v, char *text, size_t size);

/* Of a motion: the integrator, its step, the sign of a term. */
void kind_of_motion(const struct evidence *v, char *text, size_t size);

#endif
