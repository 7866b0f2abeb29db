/* The sheet's formulas, and the sides of a step's equalities, as LaTeX for the literate edition. */
#ifndef CT_LATEX_H
#define CT_LATEX_H

#include "formula/typeset.h"
#include "proof/derivation.h"
#include "text/json.h"

/* A member: its relations, outputs, named subexpressions and domain, and what is printed, with & before the sign of each. */
void json_display(struct json *j, const struct section *s);

/* A side of an equality of a step: its references too, as eq14.L_dot, rate(x1), left(6a). */
void typeset_side(struct tex *t, const struct sheet *sheet, const struct identities *names, const char *text);

#endif
