/*
 * paper.h   the paper as data, once for all tests of a program
 */
#ifndef COULOMBTETHER_TESTS_PAPER_H
#define COULOMBTETHER_TESTS_PAPER_H

#include "proof/proof_results.h"

const struct paper *whole_paper(void);
const struct sheet *sheet(void);

/* Opened anew each time: what is proved belongs to its test. */
void open_steps(struct derivations *d);
const struct derivations *steps(void); /* opened once */
void open_proofs(struct proof_results *p);

#endif
