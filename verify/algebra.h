/*
 * Exact algebra over the formula sheet: identities, polynomials and their real roots, matrices.
 */
#ifndef CT_ALGEBRA_H
#define CT_ALGEBRA_H

#include <stdbool.h>

#include "expression.h"

/* ---- identities ---- */

/* True when a node, a rational function, is zero for all values of the inputs: when its normal form is. */
bool vanishes(const struct program *p, int node);

/* The node of a formula, -1 when it does not parse. */
int formula(struct program *p, const char *text);

/* True when left = right for all values of the blank-separated names. */
bool identity(const char *names, const char *left, const char *right);

/* The same over the inputs and outputs of a section of the sheet. */
bool section_identity(const char *id, const char *left, const char *right);

/* A section's outputs for integer inputs; false where one has no rational value. */
bool section_at(const char *id, const slong *inputs, fmpq *outputs);

/* ---- polynomials in one variable ---- */

/* The polynomial in x of that text, exactly. */
void polynomial(fmpq_poly_t f, const char *text);

/* How many different roots a polynomial, not zero, has beyond a point. */
slong roots_beyond(const fmpq_poly_t f, const fmpq_t point);

/* ---- matrices ---- */

enum { STATE = 6 };

/* True when the characteristic polynomial of a matrix is that text in x. */
bool characteristic_is(const fmpq_mat_t A, const char *text);

slong rank_of(const fmpq_mat_t A);

#endif
