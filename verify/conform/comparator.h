/*
 * Compares an answer with the truth: of algebra and roots in roundings, E <= K (errors.h), where a component of a vector has
 * an S of at least the vector's size; of motions by the
 * decimal digits reached of the motion's largest coordinate, at 0 or at t, lengths over L_ref and time in
 * radians of orbit. The truth is certified when it is needed, with no more bits than decide.
 */
#ifndef CT_COMPARATOR_H
#define CT_COMPARATOR_H

#include "evaluate/errors.h"

/* What may come of a vector, everything after SKIPPED a failure; and from UNNAMED on of a line that answers none. */
enum outcome {
    OUTCOME_RIGHT,
    OUTCOME_SKIPPED,
    OUTCOME_WRONG,     /* E > K, or too few digits                           */
    OUTCOME_NAN,
    OUTCOME_INFINITE,
    OUTCOME_INVALID,   /* where a value is due                               */
    OUTCOME_VALUE,     /* where `invalid` is due                             */
    OUTCOME_COUNT,     /* too few or too many outputs                        */
    OUTCOME_MALFORMED, /* something that is no number                        */
    OUTCOME_TRUNCATED, /* the last line has no end                           */
    OUTCOME_MISSING,
    OUTCOME_TIMEOUT,
    OUTCOME_CRASH,     /* ended by a signal                                  */
    OUTCOME_UNNAMED,   /* a first word that can be no vector's name, or none */
    OUTCOME_STRANGER,  /* a name that no question has                        */
    OUTCOME_LATE,      /* after the answer to this question or a later one   */
    OUTCOME_EARLY,     /* before its question                                */
    OUTCOME_TOO_LONG,
    OUTCOMES
};

extern const char *const outcome_names[OUTCOMES];

struct comparator {
    struct operation *operation;
    int significand;
    double K, digits;     /* what passes: E of at most K, digits of at least so many */
    slong bits;           /* of the first enclosures; where they decide nothing there are more */
    arb_ptr y, exact, S;  /* the answer; its truth; S raised to the vector's size    */
    bool followed;        /* exact holds the truth of this motion from the last time */
    bool once;            /* a motion is followed with the first precision alone     */
};

struct score {
    double E, strict; /* upper bounds; strict: each output by its own size alone */
    double digits;    /* a lower bound                                           */
    int output;       /* of the worst E                                          */
};

bool is_motion(const struct section *s);

/* Inputs as the nearest binary64. */
void input_values(const struct section *s, const struct input *inputs, double *values);

/* In what a coordinate of a motion is counted: angles as they are, lengths in L_ref, rates by radians of orbit. */
double motion_unit(const struct section *s, const double *inputs, int coordinate);

/* Four roots, each as two numbers: the place among all of the one that stands beside each that is due, the nearest that is left. */
void match_roots(const double due[8], const double roots[8], int order[4]);

/* Of inputs or outputs the first of the three, one after another, that are the components of a vector, that one among them; -1: none. */
int vector_of(const struct quantity *const *all, int count, int which);

/* The operation stays the caller's. */
void comparator_init(struct comparator *j, struct operation *o, int significand, double digits);
void comparator_clear(struct comparator *j);

/* The outcome on j->y, for inputs in the domain: right or wrong; skipped where the truth cannot be certified. */
enum outcome compare_answer(struct comparator *j, const struct input *inputs, struct score *score);

/* What bounds on E come to: E <= K is right, E > K wrong; skipped where neither is proved, which is not the client's fault. */
enum outcome outcome_of_bounds(struct error_bounds E, double K);

#endif
