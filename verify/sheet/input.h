/*
 * What the formulas of a section are given: exact numbers, or enclosures.
 */
#ifndef CT_INPUT_H
#define CT_INPUT_H

#include "sheet/sheet.h"

struct input {
    fmpq value;
    bool infinite; /* only where the domain lets it be */
};

struct input *inputs_new(int count);
void inputs_free(struct input *inputs, int count);

/* A section's corrected formulas for inputs that are enclosures themselves. */
void section_enclose(const struct section *s, arb_srcptr inputs, slong prec, arb_ptr outputs);

#endif
