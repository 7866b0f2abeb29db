/* Table 1: what its rows print, and what the sheet makes of them. */
#ifndef CT_TABLE1_H
#define CT_TABLE1_H

#include "sheet/sheet.h"

/* Whether a row is computed from the others, by Eq. (7), and not one of the simulation's inputs. */
bool table_row_is_computed(const struct sheet *sheet, const struct table_row *row);

/*
 * The row's value in its printed unit, 17 digits, correctly rounded; the caller frees it. `rounds` gets
 * whether the value, rounded to as many digits as are printed, is what is printed.
 */
char *table_row_value(const struct sheet *sheet, const struct table_row *row, bool *rounds);

#endif
