/*
 * A file that appears under its name whole or not at all: where that is a link, where it leads. A device, a pipe, or
 * standard output that has the name is written as it is.
 */
#ifndef CT_WHOLE_FILE_H
#define CT_WHOLE_FILE_H

#include <stdio.h>

struct whole_file {
    FILE *file;              /* NULL: it could not be opened */
    char *name, *unfinished; /* NULL of a device */
    int why;                 /* the errno of its opening */
};

/* Everything written to it is out: 0, or the errno that says why not. */
int stream_error(FILE *file);

/* A new file beside that name, and never one that is there: that is somebody else's, or leads elsewhere. */
struct whole_file whole_file_open(const char *name);

/* Under its name now where every write was fine, and `why` is 0; else nothing is left of it. 0, or the errno that says why. */
int whole_file_close(struct whole_file *f, int why);

#endif
