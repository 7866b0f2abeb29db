#include "conform/conform.h"

#include <errno.h>
#include <limits.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "evaluate/vectors.h"
#include "text/scope.h"

/* After so many lines that answer nothing (and never before there are twice as many as questions) nothing more is heard. */
enum { MOST_STRAYS = 10000 };

/* ---- outcomes ---- */

uint64_t summary_failed(const struct summary *t)
{
    uint64_t failed = 0;
    for (int i = OUTCOME_WRONG; i < OUTCOME_UNNAMED; i++)
        failed += t->counts[i];
    return failed - t->expected;
}

uint64_t stray_count(const struct test_run *e)
{
    uint64_t count = 0;
    for (int i = OUTCOME_UNNAMED; i < OUTCOMES; i++)
        count += e->strays[i].count;
    return count;
}

static void stray(struct test_run *e, enum outcome outcome, const char *line)
{
    struct stray_lines *s = &e->strays[outcome];
    if (s->count++ > 0)
        return;
    s->first = e->heard;
    snprintf(s->line, sizeof s->line, "%s", line);
}

/* Made where it is not the one that was asked for last. */
static const struct test_vector *vector_at(struct test_run *e, uint64_t position)
{
    if (e->heard_of.set == NULL || e->position != position)
        test_vector_make(&e->heard_of, &e->sets, position);
    e->position = position;
    return &e->heard_of;
}

/* A number with a scale of its own tells more than one on none, the paper's case more than both; what is no number the least. */
static int ease_of(const struct record *r, const char *id)
{
    const bool numbers = r->outcome == OUTCOME_WRONG, paper = strstr(id, "-paper") != NULL;
    return numbers && isfinite(r->score.E) ? !paper : numbers ? 2 : r->has_values ? 3 : 4 + (r->outcome >= OUTCOME_MISSING);
}

static void expect(struct test_run *e, struct record *r)
{
    for (int i = 0; i < e->expected_count; i++)
        if (e->expected[i].position == r->position) {
            r->expected = r->outcome >= OUTCOME_WRONG;
            e->expected[i].passed = r->outcome == OUTCOME_RIGHT;
        }
}

/* What a diagnosis is made from. */
static void keep_record(struct summary *t, const struct record *r)
{
    const bool right = r->outcome == OUTCOME_RIGHT;
    if (r->outcome == OUTCOME_SKIPPED ||
        (right ? t->kept_count - t->kept_failures == MOST_KEPT - MOST_FAILURES : t->kept_failures == MOST_FAILURES))
        return;
    t->kept[t->kept_count++] = right ? *r : t->kept[t->kept_failures];
    if (!right)
        t->kept[t->kept_failures++] = *r;
}

static void note(struct test_run *e, struct record *r)
{
    const struct test_vector *q = vector_at(e, r->position);
    struct summary *t = &e->summaries[q->set - e->sets.all];
    if (!e->range && q->golden != NULL && q->golden->range)
        r->outcome = OUTCOME_SKIPPED; /* a file has all golden vectors, asked or not */
    expect(e, r);
    t->counts[r->outcome]++;
    t->expected += r->expected;
    if (e->journal != NULL)
        fwrite(r, sizeof *r, 1, e->journal); /* whether all went well is asked at its end */
    keep_record(t, r);
    if (r->outcome < OUTCOME_WRONG || r->expected)
        return;
    if (r->outcome >= OUTCOME_COUNT && r->outcome <= OUTCOME_TRUNCATED && *t->line == '\0') {
        t->line_outcome = r->outcome;
        snprintf(t->line, sizeof t->line, "%s %.250s", q->id, r->text);
    }
    const int ease = ease_of(r, q->id);
    if (ease < t->ease) {
        t->shown = *r;
        t->ease = ease;
    }
}

void test_run_rewind(struct test_run *e)
{
    if (fseek(e->journal, 0, SEEK_SET) != 0)
        e->journal_error = errno; /* LCOV_EXCL_LINE: only where a temporary file cannot be rewound */
}

bool test_run_record(struct test_run *e, struct record *r)
{
    const bool read = fread(r, sizeof *r, 1, e->journal) == 1;
    if (ferror(e->journal))
        e->journal_error = errno;
    return read;
}

/* The vector that is due has come to this, without an answer but that beginning of one; the next one is due. */
static void pass_over(struct test_run *e, enum outcome outcome, const char *text)
{
    struct record r = {.position = e->next, .outcome = outcome, .score = {.digits = INFINITY}};
    snprintf(r.text, sizeof r.text, "%s", text);
    if (e->answered == NULL || !e->answered[e->next])
        note(e, &r);
    e->next++;
}

/* ---- one line ---- */

enum { MOST_WORDS = 1 + MOST_OUTPUTS }; /* a name, and an answer */

/* Words between blanks, of the first two empty ones where there are none; returns how many there are in all. */
static int split(char *line, char *words[MOST_WORDS])
{
    char *rest = NULL, *word = strtok_r(line, " \t", &rest);
    int count = 0;
    words[0] = words[1] = "";
    for (; word != NULL; word = strtok_r(NULL, " \t", &rest), count++)
        if (count < MOST_WORDS)
            words[count] = word;
    return count;
}

/* A word as the number that C reads; for more than binary64, with all its digits and beyond its range. */
static bool answer_number(const struct test_run *e, const char *text, double *value, arb_t y)
{
    char *end;
    *value = strtod(text, &end);
    if (*end != '\0')
        return false;
    arb_set_d(y, *value);
    if (e->significand > BINARY64) {
        mpfr_t wide;
        mpfr_init2(wide, 320);
        mpfr_strtofr(wide, text, NULL, 0, MPFR_RNDN);
        arf_set_mpfr(arb_midref(y), wide);
        mpfr_clear(wide);
    }
    return true;
}

/* The numbers of an answer into the comparator's y. */
static enum outcome answer_numbers(struct test_run *e, struct comparator *j, char **words, int count, struct record *r)
{
    const int due = j->operation->section->output_count;
    enum outcome outcome = OUTCOME_RIGHT;
    for (int i = 0; i < count && i < MOST_OUTPUTS; i++) {
        if (!answer_number(e, words[i], &r->values[i], j->y + i))
            return OUTCOME_MALFORMED;
        if (isnan(r->values[i]))
            outcome = OUTCOME_NAN;
        else if (!arb_is_finite(j->y + i) && outcome == OUTCOME_RIGHT)
            outcome = OUTCOME_INFINITE;
    }
    r->has_values = count == due;
    return count == due ? outcome : OUTCOME_COUNT;
}

static enum outcome compare_numbers(struct test_run *e, struct comparator *j, const struct test_vector *q, struct record *f)
{
    struct summary *t = &e->summaries[q->set - e->sets.all];
    if (e->significand == BINARY32 && !e->range && vector_leaves_range(j->operation, q->inputs, BINARY32))
        return OUTCOME_SKIPPED;
    j->followed = is_motion(j->operation->section) && test_vector_truth(j->exact, q, &e->sets);
    const enum outcome outcome = compare_answer(j, q->inputs, &f->score);
    j->followed = false;
    const bool worse = f->score.E > t->worst_E || f->score.digits < t->digits || t->worst == UINT64_MAX;
    if (outcome != OUTCOME_SKIPPED && worse) {
        t->worst_E = fmax(t->worst_E, f->score.E);
        t->digits = fmin(t->digits, f->score.digits);
        t->worst = f->position;
    }
    return outcome;
}

/* What the words after the id say about the question. */
static void answer(struct test_run *e, uint64_t position, char **words, int count, const char *text)
{
    const struct test_vector *q = vector_at(e, position);
    struct comparator *j = &e->comparators[q->set - e->sets.all];
    struct summary *t = &e->summaries[q->set - e->sets.all];
    struct record r = {.position = position, .score = {.digits = INFINITY}};
    const bool inside = q->numbers && operation_valid(j->operation, q->inputs);
    snprintf(r.text, sizeof r.text, "%s", text);
    if (strcmp(words[0], "skip") == 0) {
        if (*t->reason == '\0')
            snprintf(t->reason, sizeof t->reason, "%.110s", r.text + strlen("skip"));
        r.outcome = OUTCOME_SKIPPED;
    } else if (count == 1 && strcmp(words[0], "invalid") == 0) {
        r.outcome = inside ? OUTCOME_INVALID : OUTCOME_RIGHT;
    } else {
        r.outcome = answer_numbers(e, j, words, count, &r);
        t->nans += !inside && r.outcome == OUTCOME_NAN;
        if (!inside && r.outcome != OUTCOME_COUNT && r.outcome != OUTCOME_MALFORMED)
            r.outcome = OUTCOME_VALUE;
        else if (r.outcome == OUTCOME_RIGHT)
            r.outcome = compare_numbers(e, j, q, &r);
    }
    note(e, &r);
}

static void hear_line(struct test_run *e, char *line, bool ended)
{
    char *words[MOST_WORDS], shown[LONGEST_SHOWN];
    snprintf(shown, sizeof shown, "%s", line);
    for (char *c = shown; *c != '\0'; c++)
        *c = *c == '\t' ? ' ' : *c;
    message_printable(shown);
    const int count = split(line, words);
    if (!is_vector_id(words[0])) {
        stray(e, OUTCOME_UNNAMED, shown);
        return;
    }
    const bool due = e->next < e->asked && strcmp(words[0], vector_at(e, e->next)->id) == 0;
    const uint64_t position = due ? e->next : test_sets_find(&e->sets, words[0]);
    if (position >= e->asked) {
        stray(e, position == UINT64_MAX ? OUTCOME_STRANGER : OUTCOME_EARLY, shown);
        return;
    }
    if (e->any_order ? e->answered[position] : position < e->next) {
        stray(e, OUTCOME_LATE, shown);
        return;
    }
    const char *text = shown + strspn(shown, " "); /* the line is cut, perhaps within its id */
    text += strcspn(text, " ");
    text += strspn(text, " ");
    while (!e->any_order && e->next < position)
        pass_over(e, OUTCOME_MISSING, "");
    if (!ended) {
        pass_over(e, OUTCOME_TRUNCATED, text);
        return;
    }
    answer(e, position, words + 1, count - 1, text);
    if (e->any_order)
        e->answered[position] = true;
    else
        e->next++;
}

/* ---- the stream ---- */

/* The line that has been heard, with its end or without. */
static void take_line(struct test_run *e, bool ended)
{
    e->heard++;
    e->line[e->length] = '\0';
    if (e->unended > LONGEST_LINE)
        stray(e, OUTCOME_TOO_LONG, "");
    else
        hear_line(e, e->line, ended);
    e->length = 0;
    e->unended = 0;
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
        take_line(e, true);
    }
    const uint64_t strays = stray_count(e);
    return strays < MOST_STRAYS || strays < 2 * e->sets.total;
}

size_t test_run_ask(void *run, char *room, size_t size)
{
    struct test_run *e = run;
    const size_t longest = 2 * LONGEST_ID + LONGEST_INPUT * (size_t)MOST_INPUTS;
    size_t used = 0;
    TEST_VECTOR(q);
    while (e->asked < e->sets.total && size - used > longest) {
        char text[LONGEST_INPUT];
        test_vector_make(&q, &e->sets, e->asked);
        const struct section *s = q.set->operation.section;
        used += (size_t)snprintf(room + used, size - used, "%s %s", s->id, q.id);
        for (int i = 0; i < s->input_count; i++) {
            test_vector_text(&q, i, e->sets.form, text);
            used += (size_t)snprintf(room + used, size - used, " %s", text);
        }
        room[used++] = '\n';
        e->asked++;
    }
    return used;
}

void test_run_begin(struct test_run *e)
{
    const int count = e->sets.count;
    e->comparators = xrealloc(NULL, (size_t)count, sizeof *e->comparators);
    e->summaries = xrealloc(NULL, (size_t)count, sizeof *e->summaries);
    if (e->any_order) {
        e->answered = xrealloc(NULL, (size_t)e->sets.total + 1, sizeof *e->answered);
        memset(e->answered, 0, (size_t)e->sets.total + 1);
    }
    for (int k = 0; k < count; k++) {
        e->summaries[k] = (struct summary){.digits = INFINITY, .worst = UINT64_MAX, .ease = INT_MAX};
        comparator_init(&e->comparators[k], &e->sets.all[k].operation, e->significand, e->sets.all[k].digits);
    }
    test_vector_init(&e->heard_of);
}

void test_run_end(struct test_run *e, enum outcome why)
{
    if (e->unended > 0)
        take_line(e, false);
    while (e->next < e->sets.total) {
        pass_over(e, why, "");
        why = OUTCOME_MISSING;
    }
}

void test_run_clear(struct test_run *e)
{
    for (int k = 0; k < e->sets.count; k++)
        comparator_clear(&e->comparators[k]);
    test_vector_clear(&e->heard_of);
    free(e->comparators);
    free(e->summaries);
    free(e->answered);
    free(e->expected);
    if (e->journal != NULL)
        fclose(e->journal);
    test_sets_clear(&e->sets);
}
