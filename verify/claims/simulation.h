/*
 * The paper's simulation sampled, and what is measured of it: numbers in SI, each named for its measure, the variable and, in
 * hours, from when on or from when to when (sup_psi_48_72); of exits, for the part of the start (exit_dL_200).
 */
#ifndef CT_SIMULATION_H
#define CT_SIMULATION_H

#include "claims/computation.h"
#include "claims/trajectory.h"

/* A simulation sampled from first to last, each `step` seconds; and another, to compare it with, NULL: none. */
struct sampled {
    struct simulation simulation;
    long first, step, last;
    const struct simulation *beside;
};

/* Gives the numbers of a computation that is `of` such a one. */
void run_simulation(struct computed *c);

#endif
