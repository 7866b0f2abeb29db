/*
 * Formulas and symbols as LaTeX, from the parsed program: what is printed is what was computed and proved.
 */
#ifndef CT_TYPESET_H
#define CT_TYPESET_H

#include "formula/expression.h"

/* A text that grows. */
struct tex {
    char *text; /* never NULL once something was added */
    size_t length;
};

void tex_clear(struct tex *t);

/* Appends, printf-like. */
#if defined(__GNUC__)
__attribute__((format(printf, 2, 3)))
#endif
void tex_add(struct tex *t, const char *format, ...);

/* A symbol by its ASCII name: psi_dot is \dot\psi, L_ref is L_{\mathrm{ref}}, x1_ddot is \ddot x_{1}. */
void typeset_symbol(struct tex *t, const char *name);

/* The formula that ends in this node; an input is written by its name, which in braces is LaTeX already. */
void typeset_formula(struct tex *t, const struct program *p, int node);

/*
 * Mathematics within a sentence, token by token, in the sheet's notation and a little more: relations, a blank for a
 * product, primes, |x|, "...", +- and -+. Fractions stay on the line.
 */
void typeset_inline(struct tex *t, const char *text, size_t length);

#endif
