/* The conditions of verdicts: names, and, or, not and brackets, in three values. */
#ifndef CT_CONDITION_H
#define CT_CONDITION_H

#include "claims/claim.h"
#include "text/message.h"

/* What a name stands for, NAME or NAME.member (else NULL). */
typedef enum truth condition_value(void *context, const char *name, const char *member, bool *known);

/* Reads it without deciding; false, with the place and what was expected, where it is broken or a name is not known. */
bool condition_check(const char *text, condition_value *value, void *context, size_t *where, struct message *why);

/* One that was checked: false as soon as one side of `and` is, true as soon as one of `or` is, whatever is open. */
enum truth condition_decide(const char *text, condition_value *value, void *context);

enum truth truth_not(enum truth t);
enum truth truth_both(enum truth a, enum truth b);

/* Whether a text has that word. */
bool mentions(const char *text, const char *word);

#endif
