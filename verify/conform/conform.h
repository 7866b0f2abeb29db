/*
 * A run of the oracle: questions go out as lines, lines come back and become outcomes. Memory does not
 * grow with the number of questions.
 *
 *     ID VECTOR-ID INPUT...      ->      VECTOR-ID OUTPUT... | VECTOR-ID invalid | VECTOR-ID skip REASON...
 */
#ifndef CT_CONFORM_H
#define CT_CONFORM_H

#include "conform/comparator.h"
#include "conform/test_set.h"

enum { LONGEST_LINE = 1 << 16, LONGEST_UNENDED = 1 << 26, MOST_FAILURES = 32, MOST_SPANS = 1000 };

/* A failing answer, kept for the diagnosis. */
struct failure {
    uint64_t position;
    enum outcome outcome;
    struct score score;
    double values[MOST_OUTPUTS]; /* what was answered; of `invalid` and the like nothing */
    bool has_values;
};

/* What was found about one operation, or after them all about the client itself. */
struct summary {
    uint64_t counts[OUTCOMES];
    double worst_E, digits;          /* of all answers in numbers: the largest, the fewest (INFINITY: none yet) */
    uint64_t worst;                  /* the vector that they come from; UINT64_MAX: none                       */
    struct failure worst_failure;
    char got[120], reason[120];      /* the line of the worst failure, the first reason for a skip             */
    char line[120];                  /* the first line that is no answer, and what was found of it             */
    enum outcome line_outcome;
    struct failure failures[MOST_FAILURES];
    int failure_count;
    char diagnosis[240];             /* what they look like, "" when nothing known */
    bool hurried;                    /* ... and not all that is known was tried    */
};

/* Questions first ... last that later ones were answered before. */
struct span {
    uint64_t first, last;
};

struct test_run {
    struct test_sets sets;
    struct comparator *comparators;  /* one a test set                               */
    struct summary *summaries;       /* the client's own after them                  */
    int significand;
    bool from_file;                  /* any order, and answers may be left out of what is flagged range */
    bool range;                      /* such vectors are wanted                      */
    uint64_t asked, next, heard;     /* questions sent; the first one that no later one was answered before; lines */
    uint64_t strays, out_of_place;   /* lines without a question since the last answer; lines out of place in all */
    struct span spans[MOST_SPANS];
    int span_count;
    struct test_vector asking, due;  /* the vectors at `asked` and `next`            */
    char line[LONGEST_LINE + 1];
    char ended[80];                  /* how the client ended, where that was too soon */
    size_t length, unended;          /* bytes kept of the line, and heard of it   */
};

/* All questions are in; digits[k] is what test set k declares. */
void test_run_begin(struct test_run *e, const double *digits);
void test_run_clear(struct test_run *e);

/* The lines of the next questions, as many as the room takes; 0 when all are asked. */
size_t test_run_ask(void *run, char *room, size_t size);

/* Any piece of the answers; false once they are hopeless: lines out of place, or one without an end. */
bool test_run_hear(void *run, const char *bytes, size_t size);

/* No more will come: what is unanswered is missing, the first of it for the reason given (or missing too). */
void test_run_end(struct test_run *e, enum outcome why);

/* A outcome about the client itself. */
void test_run_note(struct test_run *e, enum outcome outcome);

/* Failures of a summary. */
uint64_t summary_failed(const struct summary *t);

#endif
