/*
 * The paper's simulation as tables of proved rows, and bounds for what happens between and after them.
 *
 * Rows are in radians of orbit and units of L_ref, for both models alike: psi, theta, eta = dL/L_ref, their
 * rates, and the place x1 y1 z1 of craft 1 in units of its arm m2/(m1 + m2) L_ref, by the exact rotation (10) in
 * a nonlinear motion and by small angles (eq10lin) in a linear one, as the paper has it.
 */
#ifndef CT_TRACK_H
#define CT_TRACK_H

#include "motion/flow.h"
#include "sheet/sheet.h"

enum coordinate { PSI, THETA, ETA, PSI_DOT, THETA_DOT, ETA_DOT, PLACE_X, PLACE_Y, PLACE_Z, COORDINATES };

/* What is NULL is the paper's own: Table 1, n = 10, 0.01 rad, 0.01 rad, 0.1 m, no rates. */
struct scene {
    bool nonlinear;
    long rk4;                         /* step in s of the classical Runge-Kutta method, 0: the motion itself */
    slong digits;                     /* that the rows are proved to; 0: TRACK_DIGITS. Fewer run faster. */
    const char *n, *psi, *theta, *dL; /* exact decimals, SI */
    const char *m1, *m2;
    arb_srcptr start;                 /* a row to start from instead of the angles */
};

struct track {
    bool nonlinear;
    slong prec, count;
    long first, step;                 /* s: of the rows */
    arb_t c1, c2;                     /* C1/Omega^2, C2/Omega */
    arb_t Omega, L_ref, arm;          /* rad/s, m, m */
    arb_ptr rows;
};

enum { TRACK_DIGITS = 20 };

/* The value that the paper's simulation gives a quantity: Table 1 and the initial state. */
void sheet_value(arb_t x, const struct sheet *sheet, const char *name, slong prec);

/* Rows at first, first + step, ... last, whole seconds; false when the flow ended before, or the pair turned over. */
bool track_run(struct track *t, const struct sheet *sheet, const struct scene *s, long first, long step, long last);
void track_clear(struct track *t);
arb_ptr track_row(const struct track *t, slong k);

/* The largest |coordinate|, and the largest difference of two tracks, on these rows, ends included. */
void track_peak(arb_t peak, const struct track *t, int which, slong from, slong to);
void track_gap(arb_t gap, const struct track *a, const struct track *b, int which, slong from, slong to);

/*
 * A Lyapunov function that no motion raises, so that its value at a row bounds all that comes after.
 *     linear     E = (3 psi^2 + psi'^2 + (c1 - 9) eta^2 + eta'^2)/2              E' = -c2 eta'^2
 *     nonlinear  E = (u^2 + v^2 + w^2 + 3 y^2 + 4 z^2)/2 + G(l)                  E' = -c2 (l'/l)^2
 *                G = (c1 - 3)(1/l - 1) + c1 log l - 3/2 (l^2 - 1)
 * Pitch is left out of the linear one: there it is on its own.
 */
void track_energy(arb_t energy, const struct track *t, slong k);

/* Bounds on a coordinate and its derivatives, from a row on for ever; of a rate, up to the second. */
enum { DERIVATIVES = 4 };
struct bounds {
    arb_ptr of[COORDINATES];
};
void bounds_init(struct bounds *b);
void bounds_clear(struct bounds *b);
bool track_bounds(struct bounds *b, const struct track *t, slong k);

/* What a coordinate can exceed its rows by between them, ... */
void track_room(arb_t room, const struct track *t, const struct bounds *b, int which);

/* ... and a bound on |coordinate| from row to row, between them too. */
bool track_sup(arb_t sup, const struct track *t, int which, slong from, slong to);

/*
 * When |coordinate| falls below each of these limits and stays so until the last row: the last row above and the first row
 * after which it is below on rows and between them, as an enclosure of the time in hours; indeterminate if it does not.
 * False where there are no bounds.
 */
bool track_exits(arb_ptr hours, const struct track *t, int which, arb_srcptr limits, int count);

/* The same for one limit; false if it does not. */
bool track_settled(arb_t hours, const struct track *t, int which, const arb_t limit);

/* For certain. */
bool is_below(const arb_t x, double limit);

/* p, where an error shrinks by factor^p when its cause shrinks by factor. */
void observed_order(arb_t order, const arb_t larger, const arb_t smaller, ulong factor);

/* Raises `worst` to |x - expected| if that is larger; indeterminate if one of them is. */
void raise_to_difference(arb_t worst, const arb_t x, slong expected);

#endif
