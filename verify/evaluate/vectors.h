/*
 * Vectors: an operation's inputs with outputs of which every digit is proved, as lines of CSV.
 *
 *     id,INPUTS,OUTPUTS,S_OUTPUT...,flags
 *
 * Outputs have 40 digits, sensitivities 17. A motion has no S. Outside the domain outputs are empty, the flag is invalid.
 */
#ifndef CT_VECTORS_H
#define CT_VECTORS_H

#include <stdint.h>

#include "evaluate/operation.h"

enum { VECTOR_DIGITS = 40, SENSITIVITY_DIGITS = 17, LONGEST_INPUT = 800 };

/* How inputs are written: as the shortest decimals of their binary64, with all its digits, or in C99 hexadecimal. */
enum input_form { INPUTS_SHORTEST, INPUTS_EXACT, INPUTS_HEX };
extern const char *const input_forms[3];

/* An input as files have it: what is no finite number is written as Table Schema and XML have it, NaN, INF, -INF. */
const char *schema_text(const char *text);

/* A literal, which means its nearest binary64, in a form; one that is no finite number stays as it is. */
void input_write(char text[LONGEST_INPUT], const char *literal, enum input_form form);

void vectors_header(const struct section *s);

/*
 * One line. The texts are literals, each meaning its nearest binary64; `flags` (may be empty) stand
 * after "invalid" and "range", which are found here. False and a reason in o->why when a value in the
 * domain cannot be certified; nothing is printed then.
 */
bool vector_print(struct operation *o, const char *id, const char *const *texts, const char *flags, enum input_form form);

/* Random vectors index first ... first + count - 1 of a seed, ids ID-SEED-INDEX. */
bool vectors_random(const struct section *s, uint64_t seed, uint64_t first, uint64_t count, enum input_form form);

/* The golden vectors of an operation. */
bool vectors_golden(const struct section *s, enum input_form form);

/* The same one by one, as literals; "invalid" and "range" are not yet among the flags. False ends it. */
typedef bool golden_receiver(void *context, struct operation *o, const char *id, const char *const *texts,
                             const char *flags);
bool golden_each(const struct section *s, golden_receiver *receive, void *context);

/* Reads literals; false where one is no finite number and may not be infinite either. */
bool vector_read(const struct section *s, const char *const *texts, struct input *inputs);

/*
 * Whether the inputs, or a subexpression of the formulas in their written order, leave the normal range of
 * a format with that significand: BINARY32, 64 or 128 of errors.h.
 */
bool vector_leaves_range(struct operation *o, const struct input *inputs, int significand);

#endif
