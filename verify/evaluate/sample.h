/*
 * Random inputs for an operation, the same on every machine: the value of an input depends on the
 * seed, the operation, the vector's number and the input's place alone, and is made with integers.
 */
#ifndef CT_SAMPLE_H
#define CT_SAMPLE_H

#include <stdint.h>

#include "evaluate/operation.h"

/*
 * Vector `index` of `seed`: binary64 numbers inside the domain, magnitudes spread evenly over the
 * exponents of the quantities' ranges. values[i] are the inputs as doubles, inputs[i] the same, exact.
 */
void sample(struct operation *o, uint64_t seed, uint64_t index, double *values, struct input *inputs);

/* x = the finite double, exactly. */
void fmpq_set_double(fmpq_t x, double value);

/* Inputs as binary64 has them; false where one is no number. */
bool inputs_of_values(const struct section *s, const double *values, struct input *inputs);

#endif
