/*
 * The closed loop as a quadratic system; its Taylor series in balls; bounds for what series leave out.
 *
 * Units inside: time in radians of orbit (tau = Omega t), lengths in r_ref = m2 L_ref / (m1 + m2), the
 * distance of craft 1 from the centre of mass at rest. Masses and k_c cancel, and with q = 1/r,
 * c1 = C1/Omega^2, c2 = C2/Omega equation (3), closed by (7) and (18), reads
 *
 *     x' = u   u' =  2v + 3x + P x      A = (xu + yv + zw) q^2                  (= r'/r)
 *     y' = v   v' = -2u      + P y      P = q^2 (c1 (q - 1) - 3 q - c2 A)
 *     z' = w   w' =     -  z + P z      q' = -q A
 *
 * P is k_c Q / (m1 L^3) (1 + m1/m2) in units of Omega^2; it is written so that the equilibrium
 * x = q = 1, all else 0, has rates that are zero exactly in balls too. q is one more unknown: q |x| stays
 * 1 when it starts there, for (q^2 |x|^2)' = 2A (1 - q^2 |x|^2).
 *
 * Sets of parameters have r_ref = lambda times the unit and charges whose product is k times what (7) and (18) command: D = lambda q - 1,
 * and c1, 3 and c2 in R are k lambda^2 c1, 3 k lambda^3 and k lambda^2 c2.
 */
#ifndef CT_TAYLOR_H
#define CT_TAYLOR_H

#include <stdbool.h>

#include "motion/model.h"

enum {
    JET_STATES = 7,  /* x y z u v w q */
    JET_SERIES = 13, /* and G = q^2, S = xu + yv + zw, A = G S, D = q - 1, R = c1 D - 3 q - c2 A, P = G R */
    JET_CHARGE = 11, /* R, of the sign of Q_ref + dQ */
    JET_ALL = 20,    /* and the constants 1, 2, 3, c1, c2, lambda, 3 again */
    JET_TERMS = 22,  /* the products of which the system consists */
    JET_MOST = 56    /* unknowns, series and constants of any system here */
};

/*
 * to += sign a b. For a state, `to` is its rate. A constant stands first; the terms of a sum are
 * neighbours, and a sum stands after those that it needs.
 */
struct term {
    unsigned char to, a, b;
    signed char sign;
};

/* Unknowns, then the series that they need, then constants, of which the first seven are the closed loop's. */
struct system {
    int states, series, all, count;
    const struct term *terms;
};

extern const struct system closed_loop;

/* Whether unknown or series v is a constant, and term t the first of its sum */
static inline bool is_constant(const struct system *system, int v)
{
    return v >= system->series;
}

static inline bool first_of_sum(const struct system *system, int t)
{
    return t == 0 || system->terms[t - 1].to != system->terms[t].to;
}

/* Taylor coefficients about the start of a step: c[v][k] of s^k, or m[v][k]; states to degree n, the others to n - 1. */
struct jet {
    slong order;
    const struct system *system;
    const struct space *space; /* of models; NULL: balls */
    union {
        arb_ptr c[JET_MOST];
        struct model *m[JET_MOST];
    };
};

/*
 * Bounds on |s| <= h in the norm ||a|| = sum |a_k| h^k. Known are the terms below degree n (of states,
 * degree n too); tail bounds those from n on, remainder those of a state beyond n.
 */
struct majorant {
    slong order;
    const struct system *system; /* that of its jets, or one of the same sizes */
    mag_ptr size[JET_MOST];   /* size[v][k] >= |a_k| h^k                   */
    mag_ptr suffix[JET_MOST]; /* suffix[v][k] >= sum of size[v][k ... n-1] */
    mag_ptr cross;           /* of a product: what its known terms make from degree n on */
    mag_ptr tail, remainder;
    slong count;              /* of all these */
};

/* order >= 1 */
void jet_init(struct jet *jet, const struct system *system, slong order, const struct space *space);
void jet_clear(struct jet *jet);
void jet_constants(struct jet *jet, const arb_t c1, const arb_t c2);

/* Of the closed loop or another law: q = 1/|x|, and by how much it changes along a column, -q^3 x.dx, from the other states. */
void jet_start_q(struct jet *jet, slong prec);
void jet_start_column_q(struct jet *column, const struct jet *jet, slong prec);

/*
 * From the coefficients 0 of the states to all others of z: a series itself, which is jet then, or a column of jet, its derivative
 * in some direction with respect to the initial state. Of models `prec` and `fall` mean nothing; of balls coefficient k is computed
 * to prec - fall k bits (32 at least): where a_k h^k falls by `fall` bits a degree, nothing is lost by it and half the time is won.
 */
void jet_extend(struct jet *z, const struct jet *jet, slong prec, double fall);

/* A bound on |coefficient k of v| */
void jet_size(mag_t size, const struct jet *jet, int v, slong k);

void majorant_init(struct majorant *m, const struct system *system, slong order);
void majorant_clear(struct majorant *m);

/* The majorant of sum_j weight_j |jet_j|; one jet of weight 1, or columns under the radius of each. */
void majorant_of(struct majorant *m, const struct jet *jets, mag_srcptr weights, slong count,
                 const mag_t h);

/*
 * Proves a bound on the remainders; false when h is too long for it. `base` is NULL for a jet, and for columns
 * the majorant of the jet that they belong to, its remainders proved.
 */
bool majorant_prove(struct majorant *m, const struct majorant *base, const mag_t h);

#endif
