/*
 * Kinds of mistakes that no sheet can list, each told from the numbers of several failing vectors, and explaining those that
 * pass: in words, or "" where none fits. Nothing is concluded from one vector alone, or from zeros where other numbers are due in some vectors only.
 */
#ifndef CT_KINDS_H
#define CT_KINDS_H

#include <time.h>

#include "conform/conform.h"

/* The vectors of a summary that a mistake has to explain, all as binary64, the truth too: NaN where no number was answered, or is due. */
struct evidence {
    const struct section *section;
    clock_t until;      /* of processor time, when no more is tried */
    double digits;      /* that a motion is due                     */
    int count, failing;
    const struct record *records[MOST_KEPT];
    double x[MOST_KEPT][MOST_INPUTS], y[MOST_KEPT][MOST_OUTPUTS], exact[MOST_KEPT][MOST_OUTPUTS];
    double tolerance[MOST_KEPT][MOST_OUTPUTS]; /* of what is the same but for roundings */
};

/* So little that no mistake of a formula makes it, where roundings of the inputs do S; infinite where these make anything of it. */
double tolerance_of(const struct evidence *v, int f, int k, double S, int significand);

/* Whether that is what was answered, roots in whatever order, and no number where none was. */
bool is_answer(const struct evidence *v, int f, const double *made);

/*
 * Of what an operation's formulas or roots come to. Nothing where too little is wrong to tell anything: in one vector, or where
 * the others have lost digits alone, or an input is the same in all, which may be what a factor is made of.
 */
void kind_of_formula(const struct evidence *v, char *text, size_t size);

/* Of a motion: the integrator, its step, the sign of a term. */
void kind_of_motion(const struct evidence *v, char *text, size_t size);

#endif
