/* What a line that is no answer looks like, in words for its writer. */
#ifndef CT_HINTS_H
#define CT_HINTS_H

#include <stddef.h>

#include "conform/comparator.h"

/* Of a line as it is shown, printable; "" where there is nothing to add to the outcome. */
void line_hint(const struct sheet *sheet, const char *line, enum outcome outcome, char *hint, size_t size);

#endif
