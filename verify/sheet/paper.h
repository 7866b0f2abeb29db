/* The paper as data: its formula sheet, read, and the two sheets that other rooms read when they are asked for. */
#ifndef CT_PAPER_H
#define CT_PAPER_H

#include "sheet/sheet.h"

/* A file as text, and its name in messages; motions end with a zero, and a text of NULL has none. */
struct source {
    const char *name, *text;
    size_t length;
};

/* The three, and the golden vectors of motions as data/golden has them: certified once, not at each judgement. */
struct sources {
    struct source equations, derivations, claims, motions;
};

struct paper {
    struct sheet sheet;
    struct source derivations, claims, motions;
};

/* The texts are needed as long as the paper is. -1, and `why`, where the formula sheet is broken. */
int paper_open(struct paper *p, const struct sources *s, struct message *why);
void paper_close(struct paper *p);

/* Those that were compiled into the program. */
struct sources embedded_sources(void);

#endif
