/* The paper as data: its formula sheet, read, and the two sheets that other rooms read when they are asked for. */
#ifndef CT_PAPER_H
#define CT_PAPER_H

#include "sheet/sheet.h"

/* A sheet as text, and its name in messages. */
struct source {
    const char *name, *text;
    size_t length;
};

struct sources {
    struct source equations, derivations, claims;
};

struct paper {
    struct sheet sheet;
    struct source derivations, claims;
};

/* The texts are needed as long as the paper is. -1, and `why`, where the formula sheet is broken. */
int paper_open(struct paper *p, const struct sources *s, struct message *why);
void paper_close(struct paper *p);

/* The three that were compiled into the program. */
struct sources embedded_sources(void);

#endif
