/*
 * The edge of an operation's domain, made from the sheet so that no condition is forgotten: inputs just outside, one
 * defect each, and just inside.
 */
#ifndef CT_DOMAIN_H
#define CT_DOMAIN_H

#include <stdint.h>

#include "evaluate/operation.h"

/* What one input may be, by its quantity's domain. A defect is outside, an edge inside. */
struct extreme {
    const char *name;
    double value;
    unsigned domains; /* of which it is said: bits 1 << DOMAIN_... */
    bool outside, late; /* late: joined golden vectors that were there already */
};

enum { EXTREMES = 9 };
extern const struct extreme extremes[EXTREMES];
bool extreme_of(const struct extreme *x, const struct quantity *q);

/*
 * The inputs moved to where a condition of the section is just violated, or just kept, and the others are kept. False
 * where no such place was found.
 */
bool domain_edge(struct operation *o, int condition, bool outside, double *values);

/* How many conditions have an edge: all but that of a Runge-Kutta method, that t/h is an integer. */
int edge_count(const struct formulas *f);

/* Of a Runge-Kutta method, t moved off the multiples of h by as little as can be; false of other operations. */
bool domain_between_steps(const struct section *s, double *values);

/* How many defects a random vector of the operation may get; the k-th of them (any k), by its place in a rotation. */
void domain_defect(struct operation *o, uint64_t k, double *values);

#endif
