/* The tables of options.h as text: for a reader of --help, and for the manual page. */
#ifndef CT_HELP_H
#define CT_HELP_H

#include "command/options.h"
#include "sheet/sheet.h"

/* All about a subcommand; NULL: about the program. */
void help_print(const struct sheet *sheet, const struct subcommand *s);

/* Wrong usage, the nearest name suggested. */
int unknown_subcommand(const char *name);

#endif
