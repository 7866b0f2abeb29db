/*
 * A run of the oracle: questions go out as lines, lines come back and become outcomes. Memory does not
 * grow with the number of random questions.
 *
 *     ID VECTOR-ID INPUT...      ->      VECTOR-ID OUTPUT... | VECTOR-ID invalid | VECTOR-ID skip REASON...
 *
 * Each vector comes to one outcome, in the order of the questions: a vector that an answer to a later one passes over is
 * missing. Lines that answer none are counted apart from vectors.
 */
#ifndef CT_CONFORM_H
#define CT_CONFORM_H

#include <stdio.h>

#include "conform/comparator.h"
#include "conform/test_set.h"

enum { LONGEST_LINE = 1 << 16, LONGEST_UNENDED = 1 << 26, LONGEST_SHOWN = 400, MOST_FAILURES = 32, MOST_KEPT = 96 };

/* What came of a vector. */
struct record {
    uint64_t position;
    enum outcome outcome;
    bool expected;               /* it fails as was expected                               */
    struct score score;
    bool has_values;
    double values[MOST_OUTPUTS]; /* what was answered; of `invalid` and the like nothing   */
    char text[LONGEST_SHOWN];    /* ... as it was written                                 */
};

/* What was found about one operation. */
struct summary {
    uint64_t counts[OUTCOMES], expected; /* failures that were expected are counted among both                     */
    uint64_t nans;                       /* of values where `invalid` is due those with NaN                         */
    double worst_E, digits;              /* of all answers in numbers: the largest, the fewest (INFINITY: none yet) */
    uint64_t worst;                      /* the vector that they come from; UINT64_MAX: none                       */
    struct record shown;                 /* of the failures the one that is easiest to follow                      */
    int ease;                            /* ... how easy: the less the easier                                      */
    struct record kept[MOST_KEPT];       /* what a mistake has to explain: failures, expected ones among them, then what passes */
    int kept_count, kept_failures;
    char line[LONGEST_SHOWN];            /* the first answer with a word that is none, whole                       */
    enum outcome line_outcome;
    char reason[120];                    /* the first one for a skip                                               */
    char diagnosis[400];                 /* what the failures look like, "" when nothing known                     */
};

/* Lines of a kind that answer nothing. */
struct stray_lines {
    uint64_t count, first; /* how many; the number of the first one */
    char line[LONGEST_SHOWN];
};

/* A vector that may fail, by --expect. */
struct expectation {
    uint64_t position;
    bool passed;
};

struct test_run {
    struct test_sets sets;
    struct comparator *comparators; /* one a test set                             */
    struct summary *summaries;
    struct stray_lines strays[OUTCOMES];
    struct expectation *expected;
    int expected_count;
    int significand;
    bool any_order;                 /* of rows in a file                          */
    bool *answered;                 /* ... which vectors those were about         */
    bool range;                     /* what leaves the normal range is judged too */
    uint64_t asked, next, heard;    /* questions sent; the first one without an outcome; lines */
    struct test_vector heard_of;    /* the one that was answered or passed over   */
    uint64_t position;              /* ... its                                    */
    FILE *journal;                  /* of all records, for reports; NULL: none is wanted */
    int journal_error;              /* the errno that its reading ended with; 0: with its end */
    char line[LONGEST_LINE + 1];
    size_t length, unended;         /* bytes kept of the line, and heard of it    */
    char ended[100];                /* how the client ended, where that was no end of a client */
};

/* All questions are in. */
void test_run_begin(struct test_run *e);
void test_run_clear(struct test_run *e);

/* The lines of the next questions, as many as the room takes; 0 when all are asked. */
size_t test_run_ask(void *run, char *room, size_t size);

/* Any piece of the answers; false once they are hopeless: lines that answer nothing, or one without an end. */
bool test_run_hear(void *run, const char *bytes, size_t size);

/* No more will come: what is unanswered is missing, the first of it for the reason given (or missing too). */
void test_run_end(struct test_run *e, enum outcome why);

/* The next record of the journal; false after the last one, and where it cannot be read. To be rewound before the first. */
void test_run_rewind(struct test_run *e);
bool test_run_record(struct test_run *e, struct record *r);

/* Failures of a summary but those that were expected; lines that answer nothing. */
uint64_t summary_failed(const struct summary *t);
uint64_t stray_count(const struct test_run *e);

#endif
