/* The report of a run: a table and what failed as text, or a file for machines that holds every vector. */
#ifndef CT_REPORT_H
#define CT_REPORT_H

#include <stdio.h>

#include "conform/conform.h"

struct report {
    struct test_run *run;
    const char *client;          /* its name, or the answers file's                    */
    const char *errors;          /* the last of its standard error                     */
    double seconds;              /* of processor time that the oracle took for itself  */
    bool all;                    /* every failing vector as text, and digits by time: the run keeps a journal */
};

enum { LEVELS = 4 };
extern const char *const level_names[LEVELS]; /* algebra, roots, flows, method */
int level_of(const struct section *s);

/* Of one test set, or of all (-1): how many vectors, those that are right, fail, fail as expected, and are skipped. */
struct totals {
    uint64_t vectors, passed, failed, expected, skipped;
};
struct totals report_totals(const struct test_run *e, int set);

void report_text(const struct report *r, FILE *file);

/* The index of the first wrong digit in a number as it was written; its length where more digits are due, -1 where none is wrong. */
int first_wrong_digit(const char *got, const char *expected);

/* By the name's end: .xml is JUnit's, .json as report.schema.json has it. */
enum report_format { REPORT_NONE, REPORT_XML, REPORT_JSON };
enum report_format report_format(const char *name);

/* A file of that name, whole or not at all, of a run with a journal. 0, or the errno that says why not. */
int report_write(const struct report *r, const char *name);

#endif
