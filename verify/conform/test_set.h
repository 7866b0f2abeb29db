/*
 * The oracle's test sets: the golden vectors of some operations and fresh random ones after them, each by its
 * position. Nothing is kept of a random vector: it is made again from its seed and number when it is needed.
 */
#ifndef CT_TEST_SET_H
#define CT_TEST_SET_H

#include <stdint.h>

#include "evaluate/operation.h"
#include "evaluate/vectors.h"

enum { LONGEST_ID = 95 };

/* What the names of vectors are made of; and whether a word may be one. */
extern const char id_letters[];
bool is_vector_id(const char *word);

struct golden_vector {
    char *id, *texts[MOST_INPUTS];
    bool range; /* leaves the normal range of the client's numbers */
};

/* The vectors about one operation. */
struct test_set {
    struct operation operation;
    struct golden_vector *golden;
    int golden_count;
    double digits;                /* that a motion has to reach */
    uint64_t random, first;       /* how many random ones inside the domain; the position of the first of all */
    uint64_t *wanted, want_count; /* these alone, by their places among all; NULL: all                        */
};

/* Random vectors from outside the domain, after those from inside: one to sixteen. */
uint64_t test_set_defects(const struct test_set *set);
uint64_t test_set_total(const struct test_set *set);

struct test_sets {
    struct test_set *all;
    int count;
    uint64_t seed, total;
    enum input_form form;
    const char *motions; /* the rows of data/golden about motions; NULL: none */
};

struct test_vector {
    struct test_set *set;
    const struct golden_vector *golden; /* NULL: a random one                              */
    bool numbers;                       /* the inputs are numbers, infinite where they may */
    char id[LONGEST_ID + 1];
    struct input *inputs;
    double values[MOST_INPUTS];         /* of a random one */
};

/* The golden vectors of a section, and so many random ones, for numbers of that significand. */
struct test_set *test_sets_add(struct test_sets *sets, const struct section *s, uint64_t random, int significand, bool range);

/* Of the set that was added last this vector, and others that are wanted; false where it has none of that name. */
bool test_sets_want(struct test_sets *sets, const char *id);
void test_sets_clear(struct test_sets *sets);

void test_vector_init(struct test_vector *vector);
void test_vector_clear(struct test_vector *vector);

/* One that ends with its block. */
#define TEST_VECTOR(q) OWNED(test_vector) q; test_vector_init(&q)

/* The vector at a position, and the operation that it is about. */
void test_vector_make(struct test_vector *vector, const struct test_sets *sets, uint64_t position);
struct test_set *test_sets_at(const struct test_sets *sets, uint64_t position);

/* What is certified of a golden motion, into output_count balls; false where that has no row of these inputs. */
bool test_vector_truth(arb_ptr outputs, const struct test_vector *vector, const struct test_sets *sets);

/* An input as it is asked. */
void test_vector_text(const struct test_vector *vector, int input, enum input_form form, char text[LONGEST_INPUT]);

/* The position of an id, UINT64_MAX for a stranger's. */
uint64_t test_sets_find(const struct test_sets *sets, const char *id);

#endif
