/*
 * An operation at work: exact inputs, their domain, and outputs of which every digit is proved.
 */
#ifndef CT_OPERATION_H
#define CT_OPERATION_H

#include "sheet/input.h"

enum operation_status {
    OPERATION_PROVED,
    OPERATION_INVALID,  /* the inputs lie outside the domain                          */
    OPERATION_UNDECIDED /* no certified value: the reason is in the operation's `why` */
};

struct operation {
    const struct section *section;
    const struct formulas *formulas;
    struct machine machine; /* in balls; of a section with formulas: the last inputs' values, to machine.prec bits; after
                               operation_valid() of what its conditions rest on alone */
    struct gradient slopes; /* without any until they are asked for */
    slong constants;        /* bits that the machine's own numbers have */
    struct message why;
};

/* As printed: the print's own formulas, where they differ. */
void operation_init(struct operation *o, const struct section *s, bool as_printed);
void operation_clear(struct operation *o);

/* One as it is right, which ends with its block. */
#define OPERATION(o, section) OWNED(operation) o; operation_init(&o, section, false)

/* Whether the inputs lie in the domain; if not, `why` names the first that does not. */
bool operation_valid(struct operation *o, const struct input *inputs);

/* Bits of working precision that so many digits are expected to take. */
slong operation_precision(const struct operation *o, const struct input *inputs, slong digits);

/* Enclosures of all outputs from prec bits of working precision. */
enum operation_status operation_enclose(struct operation *o, const struct input *inputs, slong prec, arb_ptr outputs);

/* The same of a motion, given up where it gets wider than so many digits of its largest coordinate. */
enum operation_status operation_follow(struct operation *o, const struct input *inputs, slong digits, slong prec,
                                       arb_ptr outputs);

/*
 * All outputs as decimals with that many significant digits, each correctly rounded; the caller frees
 * them. Nothing is set unless all are proved.
 */
enum operation_status operation_digits(struct operation *o, const struct input *inputs, slong digits, char **outputs);

/* The formulas in exact numbers: initialises the machine and runs it. */
void operation_exact(struct machine *m, const struct operation *o, const struct input *inputs);

/* The exact value of a node that is rational in its inputs, and of what it needs alone: roots elsewhere take long. */
void operation_node(fmpq_t value, const struct operation *o, const struct input *inputs, int node);

#endif
