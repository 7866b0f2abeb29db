/* What trajectory and figure share: times, the scenario and rows from the command line. */
#ifndef CT_COMMAND_MOTION_H
#define CT_COMMAND_MOTION_H

#include <stdio.h>

#include "command/command.h"
#include "motion/motion.h"

struct times {
    fmpq *t;
    slong count;
};

/* 0, every, 2 every ... until; EXIT_DONE or a status after a complaint. */
int times_every(struct times *times, const char *every, const char *until, bool exact);
void times_clear(struct times *times);

/* All NAME=VALUE into the scenario. */
int read_scenario(struct scenario *s, const struct arguments *a, bool nonlinear);

/* --rk4 H: H > 0, and every time a multiple of it, none before 0. */
int read_rk4(fmpq_t h, const struct arguments *a, const struct times *times, bool exact);

/* A line a time: t unless bare, `count` numbers of the row, and what stands beside in lines of its own (NULL: nothing). */
int print_motion(FILE *out, const struct motion *m, const struct times *times, int first, int count, bool bare, const char *beside);

#endif
