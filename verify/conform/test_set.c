#include "conform/test_set.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "evaluate/domain.h"
#include "evaluate/sample.h"
#include "evaluate/vectors.h"
#include "text/decimal.h"

/* ---- golden vectors ---- */

struct collection {
    struct course *course;
    struct input *inputs;
    int significand;
    bool range;
};

static bool collect(void *context, struct operation *o, const char *id, const char *const *texts, const char *flags)
{
    struct collection *c = context;
    const struct section *s = o->section;
    (void)flags;
    const bool range = s->method == METHOD_FORMULA && vector_read(s, texts, c->inputs) &&
                       operation_valid(o, c->inputs) && vector_leaves_range(o, c->inputs, c->significand);
    if (range && !c->range)
        return true;
    struct course *course = c->course;
    course->golden = xrealloc(course->golden, (size_t)course->golden_count + 1, sizeof *course->golden);
    struct golden_vector *v = &course->golden[course->golden_count++];
    *v = (struct golden_vector){.id = text_copy(id), .range = range};
    for (int i = 0; i < s->input_count; i++)
        v->texts[i] = text_copy(texts[i]);
    return true;
}

void questions_add(struct questions *q, const struct section *s, uint64_t random, int significand, bool range)
{
    q->courses = xrealloc(q->courses, (size_t)q->count + 1, sizeof *q->courses);
    struct course *course = &q->courses[q->count++];
    *course = (struct course){.random = random, .first = q->total};
    operation_init(&course->operation, s, false);
    struct collection c = {course, inputs_new(s->input_count), significand, range};
    golden_each(s, collect, &c);
    inputs_free(c.inputs, s->input_count);
    q->total += course_total(course);
}

void questions_clear(struct questions *q)
{
    for (int k = 0; k < q->count; k++) {
        for (int i = 0; i < q->courses[k].golden_count; i++) {
            free(q->courses[k].golden[i].id);
            for (int n = 0; n < MOST_INPUTS; n++)
                free(q->courses[k].golden[i].texts[n]);
        }
        free(q->courses[k].golden);
        operation_clear(&q->courses[k].operation);
    }
    free(q->courses);
    *q = (struct questions){0};
}

uint64_t course_defects(const struct course *course)
{
    return course->random / 16 + (course->random % 16 != 0);
}

uint64_t course_total(const struct course *course)
{
    return (uint64_t)course->golden_count + course->random + course_defects(course);
}

/* ---- one question ---- */

void question_init(struct question *question)
{
    *question = (struct question){.inputs = inputs_new(MOST_INPUTS)};
}

void question_clear(struct question *question)
{
    inputs_free(question->inputs, MOST_INPUTS);
}

struct course *question_course(const struct questions *q, uint64_t position)
{
    int k = 0;
    while (k + 1 < q->count && q->courses[k + 1].first <= position)
        k++;
    return &q->courses[k];
}

/* The word in the names of random questions from outside the domain. */
static const char OUTSIDE[] = "outside-";

static void random_id(char id[LONGEST_ID + 1], const struct section *s, uint64_t seed, const char *outside, uint64_t number)
{
    snprintf(id, LONGEST_ID + 1, "%.40s-%" PRIu64 "-%s%" PRIu64, s->id, seed, outside, number);
}

void question_make(struct question *question, const struct questions *q, uint64_t position)
{
    struct course *course = question_course(q, position);
    const struct section *s = course->operation.section;
    const uint64_t at = position - course->first;
    question->course = course;
    if (at < (uint64_t)course->golden_count) {
        question->golden = &course->golden[at];
        question->drawn_inside = false;
        snprintf(question->id, sizeof question->id, "%s", question->golden->id);
        question->numbers = vector_read(s, (const char *const *)question->golden->texts, question->inputs);
        return;
    }
    const uint64_t number = at - (uint64_t)course->golden_count;
    question->golden = NULL;
    question->drawn_inside = number < course->random;
    if (question->drawn_inside) {
        random_id(question->id, s, q->seed, "", number);
        sample(&course->operation, q->seed, number, question->values, question->inputs);
    } else {
        const uint64_t k = number - course->random;
        random_id(question->id, s, q->seed, OUTSIDE, k);
        sample(&course->operation, q->seed, k, question->values, question->inputs);
        domain_defect(&course->operation, q->seed + k, question->values);
    }
    question->numbers = inputs_of_values(s, question->values, question->inputs);
}

void question_text(const struct question *question, int input, enum input_form form, char text[LONGEST_INPUT])
{
    char decimal[32];
    if (question->golden == NULL)
        value_text(decimal, question->values[input]);
    input_write(text, question->golden != NULL ? question->golden->texts[input] : decimal, form);
}

/* The number behind ID-SEED-, and the word for questions from outside; UINT64_MAX where the oracle would write it otherwise. */
static uint64_t random_number(const struct questions *q, const struct course *course, const char *id)
{
    const char *digits = strrchr(id, '-') + 1;
    const uint64_t number = strtoull(digits, NULL, 10);
    char text[LONGEST_ID + 1];
    random_id(text, course->operation.section, q->seed, "", number);
    if (strcmp(text, id) == 0 && number < course->random)
        return number;
    random_id(text, course->operation.section, q->seed, OUTSIDE, number);
    return strcmp(text, id) == 0 && number < course_defects(course) ? course->random + number : UINT64_MAX;
}

uint64_t questions_find(const struct questions *q, const char *id)
{
    const size_t length = strcspn(id, "-");
    for (int k = 0; k < q->count; k++) {
        const struct course *course = &q->courses[k];
        const char *operation = course->operation.section->id;
        if (strlen(operation) != length || strncmp(operation, id, length) != 0 || id[length] == '\0')
            continue;
        for (int i = 0; i < course->golden_count; i++)
            if (strcmp(course->golden[i].id, id) == 0)
                return course->first + (uint64_t)i;
        const uint64_t number = random_number(q, course, id);
        if (number != UINT64_MAX)
            return course->first + (uint64_t)course->golden_count + number;
    }
    return UINT64_MAX;
}
