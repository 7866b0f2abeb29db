#include "text/progress.h"

#include <inttypes.h>
#include <stdio.h>
#include <unistd.h>

struct progress progress_begin(bool rows)
{
    return (struct progress){.terminal = isatty(2) == 1 && !(rows && isatty(1) == 1)};
}

void progress_show(struct progress *p, uint64_t done, uint64_t all)
{
    if (!p->terminal || time(NULL) == p->shown)
        return;
    p->shown = time(NULL);
    fprintf(stderr, "\r%" PRIu64 " of %" PRIu64, done, all);
}

void progress_end(const struct progress *p)
{
    if (p->terminal)
        fputs("\r\033[K", stderr);
}
