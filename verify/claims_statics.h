/*
 * The claims of claims_statics[] are decided in four files, a subject each: here are those that
 * claims_statics.c, which has the list, takes from the others.
 */
#ifndef CT_CLAIMS_STATICS_H
#define CT_CLAIMS_STATICS_H

#include "claims.h"
#include "flint.h"

enum { RADIUS, VELOCITY, NORMAL, AXES };

/*
 * True when the factors, in x, make up the characteristic polynomial of (3) about rest on that axis, any masses,
 * x = lambda/Omega. Gains k1 (of an error in r, by 1/Omega^2) and k2 (of its rate, by 1/Omega) may
 * act along the line of the craft; at constant charge both are 0.
 */
#define RADIAL "(x^2 + 4)*(x^4 + k2*x^3 + (k1 - 2)*x^2 + 3*k2*x + 3*(k1 - 9))"
#define ALONG "(x^2 + 1)*(x^4 + k2*x^3 + (k1 + 1)*x^2 - 3*k2*x - 3*k1)" /* the velocity  */
#define ACROSS "(x^4 - x^2 + 4)*(x^2 + k2*x + k1 + 3)"                    /* the orbit plane */
bool static_polynomial(int axis, const char *factors);

/* How many different positive roots a polynomial in x has; -1 for none at all. */
slong positive_roots(const char *text);

/* claims_charges.c: the charges that carry the law out */
void decide_tension(struct evidence *e);
void decide_printed_charges(struct evidence *e);
void decide_negative_product(struct evidence *e);
void decide_small_variation(struct evidence *e);
void decide_charge_error(struct evidence *e);

/* claims_plasma.c: the plasma, and the numbers that nature sets */
void decide_shielding(struct evidence *e);
void decide_shielding_order(struct evidence *e);
void decide_debye_neglect(struct evidence *e);
void decide_debye_escape(struct evidence *e);
void decide_low_orbit(struct evidence *e);
void decide_debye_lengths(struct evidence *e);
void decide_coulomb_constant(struct evidence *e);
void decide_orbit_rate(struct evidence *e);
void decide_microcoulomb(struct evidence *e);
void decide_reach(struct evidence *e);
void decide_own_gravity(struct evidence *e);

#endif
