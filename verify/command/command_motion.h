/* What trajectory, figure and design share: the scenario from the command line. */
#ifndef CT_COMMAND_MOTION_H
#define CT_COMMAND_MOTION_H

#include "command/command.h"
#include "motion/motion.h"

/* The names that a subcommand takes, in the order of scenario_names, lambda_d last of design's; how many. */
enum { MOST_NAMES = SCENARIO_VALUES };
int names_taken(const struct subcommand *s, const char *names[MOST_NAMES]);

/* All NAME=VALUE into the scenario, and lambda_d where that is taken; then whether they lie in their domains. */
int read_scenario(struct scenario *s, const struct arguments *a, struct input *lambda_d, bool nonlinear);
int check_scenario(const struct scenario *s, bool nonlinear);

/* What is not given of x1 ... z1_dot: the binary64 nearest to where the angles have it. */
void start_by_angles(struct input *start, const bool *given, const struct scenario *s);

/* The roots of (41), in 1/s, those of rational gains by exact ones. False: not isolated. */
bool scenario_roots(acb_ptr roots, const struct scenario *s, slong prec);

#endif
