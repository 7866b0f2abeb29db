#include "conform/report.h"

#include <errno.h>
#include <fcntl.h>
#include <inttypes.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "conform/hints.h"
#include "text/decimal.h"
#include "text/scope.h"

enum { SHOWN_DIGITS = 20, NUMBER = 40 };

const char *const level_names[LEVELS] = {"algebra", "roots", "flows", "method"};

int level_of(const struct section *s)
{
    const bool rk4 = s->method == METHOD_RK4_LINEAR || s->method == METHOD_RK4_NONLINEAR;
    return s->method == METHOD_FORMULA ? 0 : s->method == METHOD_ROOTS ? 1 : rk4 ? 3 : 2;
}

struct totals report_totals(const struct test_run *e)
{
    struct totals sum = {0, 0, 0};
    for (int k = 0; k <= e->sets.count; k++) {
        sum.passed += e->summaries[k].counts[OUTCOME_RIGHT];
        sum.failed += summary_failed(&e->summaries[k]);
        sum.skipped += e->summaries[k].counts[OUTCOME_SKIPPED];
    }
    return sum;
}

/* ---- numbers as text ---- */

/* E, rounded up to two digits. */
static const char *error_text(double E, char text[NUMBER])
{
    SCOPE(mag, bound);
    if (isinf(E) || E == 0.0)
        return E == 0.0 ? "0" : "inf";
    mag_set_d(bound, E);
    decimal_bound(text, bound);
    return text;
}

/* Digits, rounded down to one after the point. */
static const char *digits_text(double digits, char text[NUMBER])
{
    if (isinf(digits) && digits > 0.0)
        return "exact";
    snprintf(text, NUMBER, "%.1f", floor(10.0 * fmax(digits, 0.0)) / 10.0);
    return text;
}

static double summary_digits(const struct test_run *e, int set)
{
    const struct summary *t = &e->summaries[set];
    if (is_motion(e->comparators[set].operation->section))
        return t->digits;
    return t->worst_E > 0.0 ? -log10(ldexp(t->worst_E, -e->significand)) : INFINITY;
}

/* "3 wrong, 1 missing" */
static void outcomes_text(const struct summary *t, char *text, size_t size)
{
    size_t used = 0;
    text[0] = '\0';
    for (int i = OUTCOME_WRONG; i < OUTCOMES && used < size; i++)
        if (t->counts[i] > 0)
            used += (size_t)snprintf(text + used, size - used, "%s%" PRIu64 " %s", used ? ", " : "", t->counts[i],
                                     outcome_names[i]);
}

/* ---- one failing vector ---- */

/* A vector with what was due, each as text; made for reports only. */
struct exhibit {
    struct test_vector vector;
    char inputs[MOST_INPUTS][LONGEST_INPUT];
    char *expected[MOST_OUTPUTS]; /* NULL: none was due, or none could be proved */
    bool invalid;
};

static void exhibit_init(struct exhibit *x, const struct test_run *e, uint64_t position)
{
    memset(x, 0, sizeof *x);
    test_vector_init(&x->vector);
    test_vector_make(&x->vector, &e->sets, position);
    struct operation *o = &x->vector.set->operation;
    for (int i = 0; i < o->section->input_count; i++)
        test_vector_text(&x->vector, i, e->sets.form, x->inputs[i]);
    x->invalid = !x->vector.numbers ||
                 operation_digits(o, x->vector.inputs, SHOWN_DIGITS, x->expected) == OPERATION_INVALID;
}

static void exhibit_clear(struct exhibit *x)
{
    for (int i = 0; i < MOST_OUTPUTS; i++)
        free(x->expected[i]);
    test_vector_clear(&x->vector);
}

/* Not about the stream of lines: then the vector itself tells something. */
static bool is_about_values(enum outcome outcome)
{
    return outcome <= OUTCOME_MALFORMED || outcome == OUTCOME_TIMEOUT || outcome == OUTCOME_CRASH;
}

static bool has_unit(const struct quantity *q)
{
    return strcmp(q->unit, "-") != 0;
}

static void exhibit_text(const struct exhibit *x, const struct summary *t, FILE *file)
{
    const struct section *s = x->vector.set->operation.section;
    const struct failure *f = &t->worst_failure;
    const bool marked = f->outcome == OUTCOME_WRONG && s->method == METHOD_FORMULA && s->output_count > 1;
    char number[NUMBER];
    fprintf(file, "  %s: %s", x->vector.id, outcome_names[f->outcome]);
    if (f->outcome == OUTCOME_WRONG && is_motion(s))
        fprintf(file, ", %s digits", digits_text(f->score.digits, number));
    else if (f->outcome == OUTCOME_WRONG)
        fprintf(file, ", E = %s", error_text(f->score.E, number));
    fputc('\n', file);
    if (!is_about_values(f->outcome))
        return;
    for (int i = 0; i < s->input_count; i++)
        fprintf(file, "    %-10s %s%s%s\n", s->inputs[i]->name, x->inputs[i], has_unit(s->inputs[i]) ? " " : "",
                has_unit(s->inputs[i]) ? s->inputs[i]->unit : "");
    for (int i = 0; i < s->output_count && !x->invalid; i++) {
        fprintf(file, "    %-10s expected %s", s->outputs[i]->name, x->expected[i] ? x->expected[i] : "?");
        if (f->has_values)
            fprintf(file, ", got %.17g%s", f->values[i], marked && i == f->score.output ? " <-" : "");
        fputc('\n', file);
    }
    if (x->invalid)
        fprintf(file, "    expected   invalid\n");
    if (!f->has_values)
        fprintf(file, "    got        %s\n", *t->got ? t->got : "nothing");
}

/* NULL where nothing was asked. */
static const struct sheet *sheet_of_run(const struct test_run *e)
{
    return e->sets.count > 0 ? e->comparators[0].operation->section->sheet : NULL;
}

/* The first line that is no answer, and why it is none. */
static void line_text(const struct test_run *e, const struct summary *t, FILE *file)
{
    char hint[240];
    if (*t->line == '\0')
        return;
    line_hint(sheet_of_run(e), t->line, t->line_outcome, hint, sizeof hint);
    fprintf(file, "  first %s: %s\n", outcome_names[t->line_outcome], t->line);
    if (*hint != '\0')
        fprintf(file, "    %s\n", hint);
}

static void failure_text(const struct test_run *e, int k, FILE *file)
{
    const struct summary *t = &e->summaries[k];
    char text[512];
    outcomes_text(t, text, sizeof text);
    fprintf(file, "%s: %s\n", k < e->sets.count ? e->comparators[k].operation->section->id : "client", text);
    if (k == e->sets.count) {
        line_text(e, t, file);
        return;
    }
    struct exhibit x;
    exhibit_init(&x, e, t->worst_failure.position);
    exhibit_text(&x, t, file);
    exhibit_clear(&x);
    line_text(e, t, file);
}

static void diagnosis_text(const struct summary *t, FILE *file)
{
    if (t->diagnosis[0] != '\0')
        fprintf(file, "  looks like: %s\n", t->diagnosis);
    fputs(t->hurried ? "  not all known mistakes were tried, it would take too long\n" : "", file);
}

/* ---- text ---- */

static void row_text(const struct test_run *e, int k, FILE *file)
{
    const struct summary *t = &e->summaries[k];
    const struct section *s = e->comparators[k].operation->section;
    const struct test_set *c = &e->sets.all[k];
    char E[NUMBER], digits[NUMBER];
    struct test_vector q;
    fprintf(file, "%-15s %8" PRIu64 " %8" PRIu64 " %7" PRIu64 " %8" PRIu64, s->id,
            test_set_total(c), t->counts[OUTCOME_RIGHT], summary_failed(t), t->counts[OUTCOME_SKIPPED]);
    if (t->worst == UINT64_MAX) {
        fputc('\n', file);
        return;
    }
    test_vector_init(&q);
    test_vector_make(&q, &e->sets, t->worst);
    fprintf(file, "  %8s  %6s  %s\n", is_motion(s) ? "-" : error_text(t->worst_E, E),
            digits_text(summary_digits(e, k), digits), q.id);
    test_vector_clear(&q);
}

/* A line for each reason that a client gave, with the operations that it gave it for first. */
static void skips_text(const struct test_run *e, FILE *file)
{
    for (int k = 0; k < e->sets.count; k++) {
        const char *reason = e->summaries[k].reason;
        int first = 0;
        while (strcmp(e->summaries[first].reason, reason) != 0)
            first++;
        if (*reason == '\0' || first < k)
            continue;
        fprintf(file, "\nskipped,%s:", reason);
        for (int i = k; i < e->sets.count; i++)
            if (strcmp(e->summaries[i].reason, reason) == 0)
                fprintf(file, " %s", e->comparators[i].operation->section->id);
        fputc('\n', file);
    }
}

void report_text(const struct report *r, FILE *file)
{
    struct test_run *e = r->run;
    const struct totals sum = report_totals(e);
    fputs("operation        vectors   passed  failed  skipped   worst E  digits  worst vector\n", file);
    for (int k = 0; k < e->sets.count; k++)
        row_text(e, k, file);
    for (int k = 0; k <= e->sets.count; k++)
        if (summary_failed(&e->summaries[k]) > 0) {
            fputc('\n', file);
            failure_text(e, k, file);
            fflush(file); /* an error stays with the file */
            if (r->diagnose != NULL && k < e->sets.count)
                r->diagnose(e, k);
            diagnosis_text(&e->summaries[k], file);
        }
    skips_text(e, file);
    if (*e->ended != '\0')
        fprintf(file, "\nthe client ended %s\n", e->ended);
    fprintf(file, "\n%" PRIu64 " vectors: %" PRIu64 " passed, %" PRIu64 " failed, %" PRIu64 " skipped\n",
            e->sets.total, sum.passed, sum.failed, sum.skipped);
}

/* ---- files ---- */

/* Text inside a file of that kind; what is no printable ASCII becomes a question mark. */
static void put_text(FILE *file, const char *text, bool xml)
{
    for (; *text != '\0'; text++) {
        const unsigned char c = (unsigned char)*text;
        if (c == '\n')
            fputs(xml ? "\n" : "\\n", file);
        else if (c < 0x20 || c > 0x7e)
            fputc('?', file);
        else if (xml && strchr("<>&\"", c) != NULL)
            fprintf(file, "&#%u;", (unsigned)c);
        else if (!xml && (c == '"' || c == '\\'))
            fprintf(file, "\\%c", c);
        else
            fputc(c, file);
    }
}

/* A failing operation's text, escaped for XML. */
static void put_failure(const struct test_run *e, int k, FILE *file)
{
    char *text = NULL;
    size_t size;
    FILE *stream = open_memstream(&text, &size);
    if (stream == NULL)
        out_of_memory();
    failure_text(e, k, stream);
    diagnosis_text(&e->summaries[k], stream);
    if (fclose(stream) != 0)
        out_of_memory();
    put_text(file, text, true);
    free(text);
}

static void write_xml(const struct report *r, FILE *file)
{
    const struct test_run *e = r->run;
    int failures = 0, skipped = 0;
    for (int k = 0; k <= e->sets.count; k++) {
        const bool failed = summary_failed(&e->summaries[k]) > 0;
        failures += failed;
        skipped += !failed && e->summaries[k].counts[OUTCOME_RIGHT] == 0 && k < e->sets.count;
    }
    fputs("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites>\n<testsuite name=\"", file);
    put_text(file, r->client, true);
    fprintf(file, "\" tests=\"%d\" failures=\"%d\" errors=\"0\" skipped=\"%d\">\n", e->sets.count + 1,
            failures, skipped);
    for (int k = 0; k <= e->sets.count; k++) {
        const bool asked = k < e->sets.count;
        fprintf(file, "<testcase classname=\"%s\" name=\"%s\">",
                asked ? level_names[level_of(e->comparators[k].operation->section)] : "client",
                asked ? e->comparators[k].operation->section->id : "client");
        if (summary_failed(&e->summaries[k]) > 0) {
            char text[512];
            outcomes_text(&e->summaries[k], text, sizeof text);
            fprintf(file, "<failure message=\"%s\">", text);
            put_failure(e, k, file);
            fputs("</failure>", file);
        } else if (asked && e->summaries[k].counts[OUTCOME_RIGHT] == 0) {
            fputs("<skipped/>", file);
        }
        fputs("</testcase>\n", file);
    }
    fputs("<system-err>", file);
    put_text(file, r->errors, true);
    fputs("</system-err>\n</testsuite>\n</testsuites>\n", file);
}

static void write_outcomes(const struct summary *t, FILE *file)
{
    const char *comma = "";
    fputs("\"findings\": {", file);
    for (int i = OUTCOME_WRONG; i < OUTCOMES; i++)
        if (t->counts[i] > 0) {
            fprintf(file, "%s\"%s\": %" PRIu64, comma, outcome_names[i], t->counts[i]);
            comma = ", ";
        }
    fputc('}', file);
}

/* "vector": {...}, the worst failure: inputs as they were sent, all else as text. */
static void write_exhibit(const struct test_run *e, int k, FILE *file)
{
    const struct summary *t = &e->summaries[k];
    const struct failure *f = &t->worst_failure;
    const struct section *s = e->comparators[k].operation->section;
    struct exhibit x;
    char number[NUMBER];
    exhibit_init(&x, e, f->position);
    fprintf(file, "\"vector\": {\"id\": \"%s\", \"finding\": \"%s\", ", x.vector.id, outcome_names[f->outcome]);
    if (f->outcome == OUTCOME_WRONG)
        fprintf(file, "\"%s\": \"%s\", ", is_motion(s) ? "digits" : "E",
                is_motion(s) ? digits_text(f->score.digits, number) : error_text(f->score.E, number));
    fputs("\"inputs\": {", file);
    for (int i = 0; i < s->input_count; i++)
        fprintf(file, "%s\"%s\": \"%s\"", i ? ", " : "", s->inputs[i]->name, x.inputs[i]);
    fputs("}, \"expected\": {", file);
    for (int i = 0; i < s->output_count && !x.invalid; i++)
        fprintf(file, "%s\"%s\": \"%s\"", i ? ", " : "", s->outputs[i]->name, x.expected[i] ? x.expected[i] : "?");
    fprintf(file, "}, \"invalid\": %s, \"got\": \"", x.invalid ? "true" : "false");
    put_text(file, t->got, false);
    fputs("\"}", file);
    exhibit_clear(&x);
}

static void write_row(const struct test_run *e, int k, FILE *file)
{
    const struct summary *t = &e->summaries[k];
    const struct section *s = e->comparators[k].operation->section;
    char number[NUMBER];
    const struct test_set *c = &e->sets.all[k];
    fprintf(file, "    {\"id\": \"%s\", \"level\": \"%s\", \"vectors\": %" PRIu64 ", \"passed\": %" PRIu64
            ", \"failed\": %" PRIu64 ", \"skipped\": %" PRIu64 ", ", s->id, level_names[level_of(s)],
            test_set_total(c), t->counts[OUTCOME_RIGHT], summary_failed(t), t->counts[OUTCOME_SKIPPED]);
    if (t->worst != UINT64_MAX) {
        struct test_vector q;
        test_vector_init(&q);
        test_vector_make(&q, &e->sets, t->worst);
        if (!is_motion(s))
            fprintf(file, "\"K\": %g, \"worst_E\": \"%s\", ", e->comparators[k].K, error_text(t->worst_E, number));
        fprintf(file, "\"digits\": \"%s\", \"worst\": \"%s\", ", digits_text(summary_digits(e, k), number), q.id);
        test_vector_clear(&q);
    }
    write_outcomes(t, file);
    if (*t->line != '\0') {
        char hint[240];
        line_hint(sheet_of_run(e), t->line, t->line_outcome, hint, sizeof hint);
        fprintf(file, ", \"line\": {\"finding\": \"%s\", \"text\": \"", outcome_names[t->line_outcome]);
        put_text(file, t->line, false);
        fputs("\", \"hint\": \"", file);
        put_text(file, hint, false);
        fputs("\"}", file);
    }
    if (summary_failed(t) > 0) {
        fputs(", \"diagnosis\": \"", file);
        put_text(file, t->diagnosis, false);
        fputs("\", ", file);
        write_exhibit(e, k, file);
    }
    fputc('}', file);
}

static void write_json(const struct report *r, FILE *file)
{
    const struct test_run *e = r->run;
    const struct totals sum = report_totals(e);
    fputs("{\n  \"client\": \"", file);
    put_text(file, r->client, false);
    fprintf(file, "\",\n  \"vectors\": %" PRIu64 ", \"passed\": %" PRIu64 ", \"failed\": %" PRIu64
            ", \"skipped\": %" PRIu64 ", \"oracle_seconds\": %.3f,\n  \"operations\": [\n",
            e->sets.total, sum.passed, sum.failed, sum.skipped, r->seconds);
    for (int k = 0; k < e->sets.count; k++) {
        write_row(e, k, file);
        fputs(k + 1 < e->sets.count ? ",\n" : "\n", file);
    }
    fputs("  ],\n  ", file);
    write_outcomes(&e->summaries[e->sets.count], file);
    fputs(",\n  \"errors\": \"", file);
    put_text(file, r->errors, false);
    fputs("\"\n}\n", file);
}

enum report_format report_format(const char *name)
{
    const char *end = strrchr(name, '.');
    return end == NULL ? REPORT_NONE : strcmp(end, ".xml") == 0 ? REPORT_XML : strcmp(end, ".json") == 0 ? REPORT_JSON : REPORT_NONE;
}

/* A new file beside that name, and never one that is there: that is somebody else's, or leads elsewhere. */
static FILE *open_beside(const char *name, char *unfinished, size_t size)
{
    int end = -1;
    for (int k = 0; k < 100 && end < 0; k++) {
        snprintf(unfinished, size, k == 0 ? "%s.tmp" : "%s.%d.tmp", name, k);
        end = open(unfinished, O_WRONLY | O_CREAT | O_EXCL, 0666);
        if (end < 0 && errno != EEXIST)
            return NULL;
    }
    FILE *file = end < 0 ? NULL : fdopen(end, "w");
    if (end >= 0 && file == NULL) { /* LCOV_EXCL_BR_LINE: only where memory runs out, make faults */
        close(end);         /* LCOV_EXCL_LINE: the same */
        remove(unfinished); /* LCOV_EXCL_LINE: the same */
        errno = ENOMEM;     /* LCOV_EXCL_LINE: the same */
    }
    return file;
}

int report_write(const struct report *r, const char *name)
{
    const size_t size = strlen(name) + 40;
    char *unfinished = xrealloc(NULL, size, 1);
    FILE *file = open_beside(name, unfinished, size);
    int why = file == NULL ? errno : 0;
    if (file != NULL) {
        if (report_format(name) == REPORT_XML)
            write_xml(r, file);
        else
            write_json(r, file);
        const bool written = !ferror(file);
        if (fclose(file) != 0 || !written || rename(unfinished, name) != 0) {
            why = errno != 0 ? errno : EIO;
            remove(unfinished);
        }
    }
    free(unfinished);
    return why;
}
