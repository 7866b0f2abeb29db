/* ref/ behind one door: an operation of the sheet by its id, inputs and outputs in the sheet's order. */
#ifndef CT_REFERENCE_H
#define CT_REFERENCE_H

typedef void reference_function(const double *in, double *out);

/* NULL for an id that ref/ does not compute. Outside its domain a function gives NaN. */
reference_function *reference_find(const char *id);

#endif
