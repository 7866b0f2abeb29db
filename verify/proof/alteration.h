/* Formulas altered: what rests on one is told by what becomes of it when another formula stands in its place. */
#ifndef CT_ALTERATION_H
#define CT_ALTERATION_H

#include "formula/expression.h"

/* What becomes of a formula F: a F + b, with free a and b of its own (an angle is turned by b); -F; or one of its nodes. */
enum change { CHANGE_ANY, CHANGE_RESULT, CHANGE_SIGN, CHANGE_LEFT, CHANGE_RIGHT, CHANGE_NUMBER, CHANGES };

extern const char *const change_names[CHANGES]; /* "a sign", "a number or exponent" ... */

struct alteration {
    enum change change;
    int node;         /* the formula's that changes, where one does                             */
    const bool *uses; /* of all formulas that are taken (identities.h), in order: it is altered */
    bool definitions; /* each definition that is none of these is any formula, too              */
};

/* Changes a node, or says what stands in its place; false where this change is none of this node. Of a number n.exponent is added. */
bool change_node(struct node *n, enum change change, int *instead);

/* a F + b of node F; `pair` tells these free numbers from those of other formulas. */
int any_formula(struct program *p, int node, int pair);

/* program_copy_node(), altered; what the map puts in the place of the node that is to change stays. */
int alteration_copy(struct program *p, const struct program *from, int part, const struct alteration *a, int pair, int *map);

#endif
