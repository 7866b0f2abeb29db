/*
 * What the formulas of a section are given: exact numbers, or enclosures.
 */
#ifndef CT_INPUT_H
#define CT_INPUT_H

#include "sheet/sheet.h"
#include "text/scope.h"

struct input {
    fmpq value;
    bool infinite; /* only where the domain lets it be */
};

/* The binary64 nearest to a literal, or infinity; false where it is no such number. */
bool input_read(struct input *x, const char *literal);
bool input_in_domain(const struct input *x, enum domain domain);

struct input *inputs_new(int count);
void inputs_free(struct input *inputs, int count);

/* As many as a section may have; they end with their block. */
#define INPUTS(name) struct input *name CLEARED_BY(inputs_leave) = inputs_new(MOST_INPUTS)
void inputs_leave(struct input **inputs);

/* A section's corrected formulas for inputs that are enclosures themselves. */
void section_enclose(const struct section *s, arb_srcptr inputs, slong prec, arb_ptr outputs);

#endif
