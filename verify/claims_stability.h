/*
 * What the two files of claims about the linear model share. Wherever Omega is missing it is the unit:
 * s = lambda/Omega, c1 = C1/Omega^2, c2 = C2/Omega; on (44) w = n - 9 = u^2.
 */
#ifndef CT_CLAIMS_STABILITY_H
#define CT_CLAIMS_STABILITY_H

#include "claims.h"
#include "flint.h"

enum { CLAIM_BITS = 256 };

/* Adds the text before and the number, positional while that is readable. False when its digits are not proved. */
bool say(struct evidence *e, const char *before, const arb_t x, slong digits);

/* The same for x/y. */
bool say_ratio(struct evidence *e, const char *before, const arb_t x, const arb_t y, slong digits);

/* Table 1's Omega */
void table_rate(arb_t Omega);

/* claims_rates.c: the characteristic equation, its roots, how fast they decay */
void decide_characteristic(struct evidence *e);
void decide_roots_scale(struct evidence *e);
void decide_complex_pairs(struct evidence *e);
void decide_complex_pairs_any(struct evidence *e);
void decide_limits(struct evidence *e);
void decide_slow_ends(struct evidence *e);
void decide_n12(struct evidence *e);
void decide_both_gains(struct evidence *e);
void decide_frequencies(struct evidence *e);
void decide_critical(struct evidence *e);
void decide_wiggle(struct evidence *e);
void decide_simulation_gains(struct evidence *e);
void decide_phase(struct evidence *e);
void decide_step(struct evidence *e);

#endif
