/* coulomb-tether table1: the paper's Table 1, printed and computed. */
#include <stdio.h>
#include <stdlib.h>

#include "command/command.h"
#include "evaluate/table1.h"

static bool print_table_row(const struct sheet *sheet, const struct table_row *row, const char *format)
{
    bool rounds;
    char *computed = table_row_value(sheet, row, &rounds);
    printf(format, row->name, row->printed, computed, row->unit, rounds ? "yes" : "no");
    free(computed);
    return rounds;
}

int command_table1(const struct arguments *a)
{
    const struct sheet *sheet = &a->paper->sheet;
    int status = EXIT_DONE;
    const char *format = option_given(a, "--csv") ? "%s,%s,%s,%s,%s\n" : "%-6s %-12s %-24s %-10s %s\n";
    printf(format, "name", "printed", "computed", "unit", "rounds");
    for (int i = 0; i < sheet->row_count; i++)
        if (!print_table_row(sheet, &sheet->table1[i], format))
            status = REPORTED_CHECK;
    return status;
}
