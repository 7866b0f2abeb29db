#include "conform/conform.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "evaluate/vectors.h"

/* After so many lines out of place (and never before there are as many as questions) nothing more is heard. */
enum { MOST_OUT_OF_PLACE = 10000 };

/* ---- outcomes ---- */

uint64_t summary_failed(const struct summary *t)
{
    uint64_t failed = 0;
    for (int i = OUTCOME_WRONG; i < OUTCOMES; i++)
        failed += t->counts[i];
    return failed;
}

static struct summary *own_summary(struct test_run *e)
{
    return &e->summaries[e->sets.count];
}

static struct summary *summary_at(struct test_run *e, uint64_t position)
{
    if (position >= e->sets.total)
        return own_summary(e);
    return &e->summaries[test_sets_at(&e->sets, position) - e->sets.all];
}

/* Wrong numbers before everything else, the further off the worse. */
static bool failure_is_worse(const struct failure *a, const struct failure *b)
{
    if ((a->outcome == OUTCOME_WRONG) != (b->outcome == OUTCOME_WRONG))
        return a->outcome == OUTCOME_WRONG;
    return a->score.E > b->score.E || a->score.digits < b->score.digits;
}

static void record_outcome(struct test_run *e, const struct failure *f, const char *line)
{
    struct summary *t = summary_at(e, f->position);
    const bool first = summary_failed(t) == 0;
    t->counts[f->outcome]++;
    if (f->outcome < OUTCOME_WRONG)
        return;
    if (first || failure_is_worse(f, &t->worst_failure)) {
        t->worst_failure = *f;
        snprintf(t->got, sizeof t->got, "%s", line);
    }
    const bool is_line = f->outcome >= OUTCOME_COUNT && f->outcome <= OUTCOME_EXTRA && *line != '\0';
    if (is_line && *t->line == '\0') {
        t->line_outcome = f->outcome;
        snprintf(t->line, sizeof t->line, "%s", line);
    }
    if (t->failure_count < MOST_FAILURES)
        t->failures[t->failure_count++] = *f;
}

static void found(struct test_run *e, uint64_t position, enum outcome outcome, const char *line)
{
    const struct failure f = {.position = position, .outcome = outcome, .score = {0.0, INFINITY, 0}};
    record_outcome(e, &f, line);
}

void test_run_note(struct test_run *e, enum outcome outcome)
{
    found(e, UINT64_MAX, outcome, "");
}

/* ---- the questions between answers ---- */

static void missing(struct test_run *e, struct span s)
{
    for (uint64_t p = s.first; p <= s.last && p < e->sets.total; p++) {
        const struct test_set *set = test_sets_at(&e->sets, p);
        const uint64_t at = p - set->first;
        const bool golden = at < (uint64_t)set->golden_count;
        const bool optional = e->from_file && !e->range && golden && set->golden[at].range;
        found(e, p, optional ? OUTCOME_SKIPPED : OUTCOME_MISSING, "");
    }
}

/* first ... last were passed over. Lines without a question stood there: each has been counted for one of them. */
static void pass_over(struct test_run *e, uint64_t first, uint64_t last)
{
    const uint64_t known = e->strays < last - first + 1 ? e->strays : last - first + 1;
    if (first + known > last)
        return;
    if (e->span_count == MOST_SPANS) { /* the oldest will hardly be answered any more */
        missing(e, e->spans[0]);
        memmove(e->spans, e->spans + 1, sizeof e->spans - sizeof *e->spans);
        e->span_count--;
    }
    e->spans[e->span_count++] = (struct span){first + known, last};
}

/* Whether a question was passed over; it is not any more. */
static bool take_up(struct test_run *e, uint64_t position)
{
    for (int i = 0; i < e->span_count; i++) {
        struct span *s = &e->spans[i];
        if (position < s->first || position > s->last)
            continue;
        const struct span after = {position + 1, s->last};
        if (position > s->first && position < s->last && e->span_count == MOST_SPANS)
            missing(e, after);
        else if (position > s->first && position < s->last)
            e->spans[e->span_count++] = after;
        if (position > s->first)
            s->last = position - 1;
        else if (position < s->last)
            s->first = position + 1;
        else
            *s = e->spans[--e->span_count];
        return true;
    }
    return false;
}

/* ---- one line ---- */

static void stray(struct test_run *e, enum outcome outcome, const char *line)
{
    const bool over = e->next == e->sets.total && e->span_count == 0 && !e->from_file;
    found(e, e->from_file ? UINT64_MAX : e->next + e->strays, over ? OUTCOME_EXTRA : outcome, line);
    e->strays += !e->from_file; /* rows of a file take nobody's place */
    e->out_of_place++;
}

static bool is_id(const char *text)
{
    static const char letters[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_.-";
    return *text != '\0' && text[strspn(text, letters)] == '\0';
}

/* Words between blanks, `most` at most; returns how many there are in all. */
static int split(char *line, char **words, int most)
{
    char *rest = NULL;
    int count = 0;
    for (char *word = strtok_r(line, " \t", &rest); word != NULL; word = strtok_r(NULL, " \t", &rest))
        if (count++ < most)
            words[count - 1] = word;
    return count;
}

/* A number as C reads it; for more than binary64, with all its digits. */
static bool answer_number(const struct test_run *e, const char *text, double *value, arb_t y)
{
    char *end;
    *value = strtod(text, &end);
    if (*end != '\0' || end == text)
        return false;
    arb_set_d(y, *value);
    if (e->significand > BINARY64 && isfinite(*value)) {
        mpfr_t wide;
        mpfr_init2(wide, 320);
        mpfr_strtofr(wide, text, NULL, 0, MPFR_RNDN);
        arf_set_mpfr(arb_midref(y), wide);
        mpfr_clear(wide);
    }
    return true;
}

/* The numbers of an answer into the comparator's y. */
static enum outcome answer_numbers(struct test_run *e, struct comparator *j, char **words, int count, struct failure *f)
{
    const int due = j->operation->section->output_count;
    enum outcome outcome = OUTCOME_RIGHT;
    for (int i = 0; i < count && i < MOST_OUTPUTS; i++) {
        if (!answer_number(e, words[i], &f->values[i], j->y + i))
            return OUTCOME_MALFORMED;
        if (isnan(f->values[i]))
            outcome = OUTCOME_NAN;
        else if (isinf(f->values[i]) && outcome == OUTCOME_RIGHT)
            outcome = OUTCOME_INFINITE;
    }
    f->has_values = count == due;
    return count == due ? outcome : OUTCOME_COUNT;
}

static enum outcome compare_numbers(struct test_run *e, struct comparator *j, const struct test_vector *q, struct failure *f)
{
    struct summary *t = summary_at(e, f->position);
    if (e->significand == BINARY32 && q->golden == NULL && j->operation->section->method == METHOD_FORMULA &&
        vector_leaves_range(j->operation, q->inputs, BINARY32))
        return OUTCOME_SKIPPED;
    const enum outcome outcome = compare_answer(j, q->inputs, &f->score);
    const bool worse = f->score.E > t->worst_E || f->score.digits < t->digits || t->worst == UINT64_MAX;
    if (outcome != OUTCOME_SKIPPED && worse) {
        t->worst_E = fmax(t->worst_E, f->score.E);
        t->digits = fmin(t->digits, f->score.digits);
        t->worst = f->position;
    }
    return outcome;
}

/* What the words after the id say about the question. */
static void answer(struct test_run *e, const struct test_vector *q, uint64_t position, char **words, int count,
                   const char *line)
{
    struct comparator *j = &e->comparators[q->set - e->sets.all];
    struct failure f = {.position = position, .score = {0.0, INFINITY, 0}};
    const bool inside = q->drawn_inside || (q->numbers && operation_valid(j->operation, q->inputs));
    if (count > 0 && strcmp(words[0], "skip") == 0) {
        char *reason = summary_at(e, position)->reason;
        const size_t after = (size_t)(words[0] - e->line) + strlen("skip");
        if (*reason == '\0' && after < strlen(line)) /* of which there is the beginning alone */
            snprintf(reason, sizeof e->summaries->reason, "%s", line + after);
        f.outcome = OUTCOME_SKIPPED;
    } else if (count == 1 && strcmp(words[0], "invalid") == 0) {
        f.outcome = inside ? OUTCOME_INVALID : OUTCOME_RIGHT;
    } else {
        f.outcome = answer_numbers(e, j, words, count, &f);
        if (!inside && f.outcome != OUTCOME_COUNT && f.outcome != OUTCOME_MALFORMED)
            f.outcome = OUTCOME_VALUE;
        else if (f.outcome == OUTCOME_RIGHT)
            f.outcome = compare_numbers(e, j, q, &f);
    }
    if (e->from_file && !e->range && q->golden != NULL && q->golden->range)
        f.outcome = OUTCOME_SKIPPED;
    record_outcome(e, &f, line);
}

/* An answer to another question than the next one. */
static bool find_place(struct test_run *e, const char *id, const char *line, uint64_t *position)
{
    *position = test_sets_find(&e->sets, id);
    if (*position == UINT64_MAX) {
        stray(e, OUTCOME_STRANGER, line);
        return false;
    }
    if (*position >= e->asked) {
        found(e, *position, OUTCOME_EARLY, line);
    } else if (*position > e->next) {
        return true;
    } else {
        const bool passed_over = take_up(e, *position);
        if (passed_over && e->from_file)
            return true;
        const bool over = e->next == e->sets.total && e->span_count == 0 && !passed_over && !e->from_file;
        found(e, over ? UINT64_MAX : *position,
              passed_over ? OUTCOME_REORDERED : over ? OUTCOME_EXTRA : OUTCOME_REPEATED, line);
    }
    e->out_of_place++;
    return false;
}

static void hear_line(struct test_run *e, char *line, bool ended)
{
    char *words[MOST_OUTPUTS + 2], shown[120];
    uint64_t position = e->next;
    e->heard++;
    snprintf(shown, sizeof shown, "%s", line);
    message_printable(shown);
    int count = split(line, words, MOST_OUTPUTS + 2);
    if (!ended || count == 0 || !is_id(words[0])) {
        stray(e, ended ? OUTCOME_MALFORMED : OUTCOME_TRUNCATED, shown);
        return;
    }
    const bool expected = e->next < e->asked && strcmp(words[0], e->due.id) == 0;
    struct test_vector *q = &e->due, other;
    if (!expected && !find_place(e, words[0], shown, &position))
        return;
    if (position < e->next) { /* of a file, where answers stand in any order */
        test_vector_init(&other);
        test_vector_make(&other, &e->sets, position);
        answer(e, &other, position, words + 1, count - 1, shown);
        test_vector_clear(&other);
        return;
    }
    if (position > e->next)
        pass_over(e, e->next, position - 1);
    if (position > e->next)
        test_vector_make(q, &e->sets, position);
    e->strays = 0;
    answer(e, q, position, words + 1, count - 1, shown);
    e->next = position + 1;
    if (e->next < e->sets.total)
        test_vector_make(q, &e->sets, e->next);
}

/* ---- the stream ---- */

static bool is_too_long(const struct test_run *e)
{
    return e->unended > LONGEST_LINE;
}

bool test_run_hear(void *run, const char *bytes, size_t size)
{
    struct test_run *e = run;
    for (size_t i = 0; i < size; i++) {
        if (bytes[i] != '\n') {
            if (e->length < LONGEST_LINE)
                e->line[e->length++] = bytes[i] == '\0' ? '\1' : bytes[i]; /* neither has business in a line */
            if (++e->unended == LONGEST_UNENDED)
                return false;
            continue;
        }
        if (e->length > 0 && e->line[e->length - 1] == '\r')
            e->length--;
        e->line[e->length] = '\0';
        if (is_too_long(e))
            stray(e, OUTCOME_TOO_LONG, "");
        else
            hear_line(e, e->line, true);
        e->length = 0;
        e->unended = 0;
    }
    return e->out_of_place < MOST_OUT_OF_PLACE || e->out_of_place < 2 * e->sets.total;
}

size_t test_run_ask(void *run, char *room, size_t size)
{
    struct test_run *e = run;
    const size_t longest = 2 * LONGEST_ID + LONGEST_INPUT * (size_t)MOST_INPUTS;
    size_t used = 0;
    while (e->asked < e->sets.total && size - used > longest) {
        char text[LONGEST_INPUT];
        test_vector_make(&e->asking, &e->sets, e->asked);
        const struct section *s = e->asking.set->operation.section;
        used += (size_t)snprintf(room + used, size - used, "%s %s", s->id, e->asking.id);
        for (int i = 0; i < s->input_count; i++) {
            test_vector_text(&e->asking, i, e->sets.form, text);
            used += (size_t)snprintf(room + used, size - used, " %s", text);
        }
        room[used++] = '\n';
        e->asked++;
    }
    return used;
}

void test_run_begin(struct test_run *e, const double *digits)
{
    const int count = e->sets.count;
    e->comparators = xrealloc(NULL, (size_t)count, sizeof *e->comparators);
    e->summaries = xrealloc(NULL, (size_t)count + 1, sizeof *e->summaries);
    for (int k = 0; k <= count; k++)
        e->summaries[k] = (struct summary){.digits = INFINITY, .worst = UINT64_MAX};
    for (int k = 0; k < count; k++)
        comparator_init(&e->comparators[k], &e->sets.all[k].operation, e->significand, digits[k]);
    test_vector_init(&e->asking);
    test_vector_init(&e->due);
    if (e->sets.total > 0)
        test_vector_make(&e->due, &e->sets, 0);
}

void test_run_end(struct test_run *e, enum outcome why)
{
    if (e->unended > 0) {
        e->line[e->length] = '\0';
        if (is_too_long(e))
            stray(e, OUTCOME_TOO_LONG, "");
        else
            hear_line(e, e->line, false);
    }
    if (why != OUTCOME_MISSING) {
        found(e, e->next, why, "");
        e->strays++;
    }
    if (e->next < e->sets.total)
        pass_over(e, e->next, e->sets.total - 1);
    e->next = e->sets.total;
    for (int i = 0; i < e->span_count; i++)
        missing(e, e->spans[i]);
    e->span_count = 0;
}

void test_run_clear(struct test_run *e)
{
    for (int k = 0; k < e->sets.count; k++)
        comparator_clear(&e->comparators[k]);
    test_vector_clear(&e->asking);
    test_vector_clear(&e->due);
    free(e->comparators);
    free(e->summaries);
    test_sets_clear(&e->sets);
}
