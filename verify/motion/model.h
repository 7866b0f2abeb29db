/*
 * Taylor models: a polynomial in unknowns e_i, |e_i| <= 1, whose coefficients are binary64, and a bound on what it is off.
 * All roundings and all that is cut off goes into that bound.
 */
#ifndef CT_MODEL_H
#define CT_MODEL_H

#include <stdbool.h>

#include "text/scope.h"

enum { MODEL_DEGREE = 8 };

/* The monomials to a degree: by degree, 1 first, then e_1, e_2, ... */
struct space {
    int variables, degree, size;
    int first[MODEL_DEGREE + 2]; /* of each degree; after the last, size                       */
    unsigned char *exponent;     /* [b variables + i]                                          */
    int **product;               /* product[a][b], where that is not beyond                    */
};

void space_init(struct space *s, int variables, int degree);
void space_clear(struct space *s);

/* { sum c_b b + d : |d| <= rest }; norm[k] is the sum of the |c_b| of degree k, rounded */
struct model {
    const struct space *space;
    double *c, norm[MODEL_DEGREE + 1], rest;
};

void model_init(struct model *m, const struct space *s);
void model_clear(struct model *m);
#define MODEL(m, space) OWNED(model) m; model_init(&m, space)

/* As many side by side, all 0 */
struct model *models_init(int count, const struct space *s);
void models_clear(struct model *m);
static inline void models_leave(struct model **m) { models_clear(*m); }
#define MODELS(m, count, space) struct model *m CLEARED_BY(models_leave) = models_init(count, space)

/* What holds the ball, and all of x + radius e_i (i from 0). */
void model_set_ball(struct model *z, const arb_t x);
void model_set_variable(struct model *z, const arb_t x, const arb_t radius, int i);

/* x in a space of the same unknowns, its own or a smaller one: then what is cut off goes to the rest. */
void model_set(struct model *z, const struct model *x);

/* z, or nothing where !add, plus sign sum_{j < count} x[j] y[-j]; z is none of them */
void model_dot(struct model *z, bool add, int sign, const struct model *x, const struct model *y, int count);
void model_product(struct model *z, const struct model *x, const struct model *y); /* z may be x or y */
void model_scale(struct model *z, double factor);
void model_widen(struct model *z, const mag_t by);

/* sum_k x[k] h^k */
void model_evaluate(struct model *z, const struct model *x, int count, double h);

/* x^(-1/2), a rest of infinity where x is not known well enough, or not positive; and sin(x + quarters pi/2) */
void model_inverse_root(struct model *z, const struct model *x);
void model_sine(struct model *z, const struct model *x, int quarters);

/* e_i becomes (e_i + side)/2, side 1 or -1: either half of the set */
void model_halve(struct model *z, int i, int side);

/* A bound on |x|, and a ball that holds x, for all e */
double model_size(const struct model *x);
void model_range(arb_t range, const struct model *x);

#endif
