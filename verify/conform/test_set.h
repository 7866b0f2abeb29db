/*
 * What the oracle asks: the golden vectors of some operations and fresh random ones behind them, each by its
 * position. Nothing is kept of a random vector: it is made again from its seed and number when it is needed.
 */
#ifndef CT_TEST_SET_H
#define CT_TEST_SET_H

#include <stdint.h>

#include "evaluate/operation.h"
#include "evaluate/vectors.h"

enum { LONGEST_ID = 95 };

struct golden_vector {
    char *id, *texts[MOST_INPUTS];
    bool range; /* leaves the normal range of the client's numbers */
};

/* The questions about one operation. */
struct course {
    struct operation operation;
    struct golden_vector *golden;
    int golden_count;
    uint64_t random, first; /* how many random ones inside the domain; the position of the first of all */
};

/* Random questions from outside the domain, behind those from inside: one to sixteen. */
uint64_t course_defects(const struct course *course);
uint64_t course_total(const struct course *course);

struct questions {
    struct course *courses;
    int count;
    uint64_t seed, total;
    enum input_form form;
};

struct question {
    struct course *course;
    const struct golden_vector *golden; /* NULL: a random one                              */
    bool numbers;                       /* the inputs are numbers, infinite where they may */
    bool drawn_inside;                  /* a random one that needs no look at the domain   */
    char id[LONGEST_ID + 1];
    struct input *inputs;
    double values[MOST_INPUTS];         /* of a random one */
};

/* The golden vectors of a section, and so many random ones, for numbers of that significand. */
void questions_add(struct questions *q, const struct section *s, uint64_t random, int significand, bool range);
void questions_clear(struct questions *q);

void question_init(struct question *question);
void question_clear(struct question *question);

/* The question at a position, and the operation that it is about. */
void question_make(struct question *question, const struct questions *q, uint64_t position);
struct course *question_course(const struct questions *q, uint64_t position);

/* An input as it is asked. */
void question_text(const struct question *question, int input, enum input_form form, char text[LONGEST_INPUT]);

/* The position of an id, UINT64_MAX for a stranger's. */
uint64_t questions_find(const struct questions *q, const char *id);

#endif
