/* The tables of options.h as text, of which manual.awk and completion.bash make theirs. */
#ifndef CT_HELP_H
#define CT_HELP_H

#include "command/options.h"
#include "sheet/sheet.h"

/* All about a subcommand; NULL: about the program. */
void help_print(const struct sheet *sheet, const struct subcommand *s);

/* Wrong usage, the nearest name suggested. */
int unknown_subcommand(const char *name);

#endif
