/*
 * The numbers of arithmetic_symbolic: rational functions of named variables in normal form, and truncated power series
 * in epsilon over them. Two formulas are equal where their normal forms are; nothing is drawn, nothing rounds.
 *
 * A finite angle is known by its cosine (1 - t^2)/(1 + t^2) and sine 2t/(1 + t^2), t = tan(angle/2) being a variable.
 * That leaves out half a turn alone, where t is infinite; no loss, as what is continuous in the angle, and equal
 * everywhere else, is equal there too. A number that grows beyond all bounds as epsilon vanishes is known by its
 * reciprocal, and one may divide by it. What has no such value is a fault, which every later result inherits.
 *
 * A square root is one of the values that symbolic_root() was given, which the caller has proved to be positive.
 */
#ifndef CT_SYMBOLIC_H
#define CT_SYMBOLIC_H

#include "formula/arithmetic.h"

enum symbolic_fault {
    SYMBOLIC_FINE,
    SYMBOLIC_POLE,            /* division by zero, or by what is zero at epsilon = 0       */
    SYMBOLIC_NO_SQUARE,       /* the square root of no square of a rational function       */
    SYMBOLIC_UNKNOWN_ROOT,    /* ... of a square whose positive root was not given         */
    SYMBOLIC_NUMBER_AS_ANGLE, /* sine or cosine of a finite number                         */
    SYMBOLIC_ANGLE_AS_NUMBER, /* arithmetic with a finite angle                            */
    SYMBOLIC_TRANSCENDENTAL,  /* a value that is no rational series, or of unknown sign    */
    SYMBOLIC_TOO_LARGE        /* more terms, digits or time than a step may take           */
};

struct symbolic {
    fmpz_mpoly_q_struct *a; /* the coefficients of epsilon^0, epsilon^1 ..., then cosine and sine of the finite part of an angle */
    slong terms;
    bool angle, large; /* what has a fault is no angle */
    enum symbolic_fault fault;
};

/*
 * A field of rational functions, perhaps within another, which waits until it ends; every number is cleared before. As long as
 * there are `more`, a square root, sine, cosine, exponential or arc tangent that has no value is a further variable, the same one
 * for the same argument; so two formulas that are equal whatever their parts mean are still found equal.
 */
void symbolic_begin(slong variables, slong more);
void symbolic_end(void);

const fmpz_mpoly_ctx_struct *symbolic_context(void);

/* The variable, times epsilon^power; the angle whose half has it for its tangent. A point (NULL: none) is its value. */
void symbolic_set_variable(struct symbolic *z, slong variable, slong power, const fmpq *point);
void symbolic_set_angle(struct symbolic *z, slong variable, const fmpq *point);

/* What x is at epsilon = 0, which is above zero, is a square root from now on. */
void symbolic_root(const struct symbolic *x);
bool symbolic_root_used(int i);

/* A polynomial in the one variable. False where it is none; zero then. */
bool symbolic_get_polynomial(fmpq_poly_t f, const struct symbolic *x);

/* In words; of what is too large, what of the last. */
const char *symbolic_fault_text(enum symbolic_fault fault);

#endif
