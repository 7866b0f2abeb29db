/*
 * paper.h   the paper as data, once for all tests of a program
 */
#ifndef COULOMBTETHER_TESTS_PAPER_H
#define COULOMBTETHER_TESTS_PAPER_H

#include "proof/derivation.h"

const struct paper *whole_paper(void);
const struct sheet *sheet(void);

/* Opened anew each time: what is proved belongs to its test. */
void open_steps(struct derivations *d);
const struct derivations *steps(void); /* opened once */

/* The rates of x y z u v w q in fractions, by the table of the Taylor series: for the proof that it is the paper's closed loop. */
void closed_loop_rates(fmpq *rates, const fmpq *state, const fmpq_t c1, const fmpq_t c2);

#endif
