#include "evaluate/table1.h"

#include <ctype.h>
#include <stdlib.h>
#include <string.h>

#include "evaluate/operation.h"
#include "text/decimal.h"
#include "text/scope.h"

/* Significant digits of a printed number: those of its mantissa, leading zeros apart, before any e. */
static long printed_digits(const char *printed)
{
    long digits = 0;
    for (const char *at = printed + strcspn(printed, "123456789"); isdigit((unsigned char)*at) || *at == '.'; at++)
        digits += *at != '.';
    return digits;
}

/* What the simulation uses: a value of the sheet, or Q_ref of Eq. (7) from the others; in SI. */
static void table_value(fmpq_t value, const struct sheet *sheet, const struct table_row *row)
{
    const struct section *s = section_find(sheet, "eq07");
    const struct operation o = {.section = s, .formulas = &s->corrected};
    if (!table_row_is_computed(sheet, row)) {
        literal_read(value, quantity_find(sheet, row->name)->value, true);
        return;
    }
    INPUTS(inputs);
    for (int i = 0; i < s->input_count; i++) {
        const char *name = s->inputs[i]->name;
        literal_read(&inputs[i].value, quantity_find(sheet, strcmp(name, "L") == 0 ? "L_ref" : name)->value, true);
    }
    operation_node(value, &o, inputs, s->corrected.outputs[0]);
}

bool table_row_is_computed(const struct sheet *sheet, const struct table_row *row)
{
    return quantity_find(sheet, row->name)->value == NULL;
}

char *table_row_value(const struct sheet *sheet, const struct table_row *row, bool *rounds)
{
    SCOPE(fmpq, value, scale, printed);
    literal_read(scale, row->scale, true);
    literal_read(printed, row->printed, true);
    table_value(value, sheet, row);
    fmpq_div(value, value, scale);
    char *computed = decimal_of_rational(value, 17);
    char *rounded = decimal_of_rational(value, printed_digits(row->printed));
    literal_read(value, rounded, true);
    *rounds = fmpq_equal(value, printed);
    free(rounded);
    return computed;
}
