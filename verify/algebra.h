/*
 * Exact algebra over the formula sheet: identities, polynomials and their real roots, the matrix of the
 * linear model.
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

/* True when it has none, and that sign there. */
bool has_sign_beyond(const fmpq_poly_t f, const fmpq_t point, int sign);

/* ---- the linear model ---- */

enum { STATE = 6, PLANE = 4 };

/* The matrix of (40) over psi theta dL psi_dot theta_dot dL_dot, for integers Omega L_ref C1 C2. */
bool linear_model(fmpq_mat_t A, const slong parameters[4]);

/* Its part in the orbit plane: psi dL psi_dot dL_dot. */
bool plane_model(fmpq_mat_t B, const slong parameters[4]);

/*
 * K = (b, A b, A^2 b, ...), b being the unit vector of dL_dot, the last state: the one equation that dQ
 * acts in, and the one state whose loss C2 measures.
 */
void krylov(fmpq_mat_t K, const fmpq_mat_t A);

/* True when the characteristic polynomial of a matrix is that text in x. */
bool characteristic_is(const fmpq_mat_t A, const char *text);

slong rank_of(const fmpq_mat_t A);

#endif
