/*
 * How far long work has come: on a terminal that shows nothing else, at first and then once a second;
 * nothing elsewhere.
 */
#ifndef CT_PROGRESS_H
#define CT_PROGRESS_H

#include <stdbool.h>
#include <stdint.h>
#include <time.h>

struct progress {
    bool terminal;
    time_t shown;
};

/* `rows`: standard output gets rows meanwhile, and should not be the same terminal. */
struct progress progress_begin(bool rows);
void progress_show(struct progress *p, uint64_t done, uint64_t all);
void progress_end(const struct progress *p);

#endif
