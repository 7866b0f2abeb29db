#include "conform/report.h"

#include <errno.h>
#include <inttypes.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "conform/diagnosis.h"
#include "text/decimal.h"
#include "text/json.h"
#include "text/progress.h"
#include "text/whole_file.h"

enum { SHOWN_DIGITS = 20 };

const char *const level_names[LEVELS] = {"algebra", "roots", "flows", "method"};

int level_of(const struct section *s)
{
    const bool rk4 = s->method == METHOD_RK4_LINEAR || s->method == METHOD_RK4_NONLINEAR;
    return s->method == METHOD_FORMULA ? 0 : s->method == METHOD_ROOTS ? 1 : rk4 ? 3 : 2;
}

struct totals report_totals(const struct test_run *e, int set)
{
    struct totals sum = {0, 0, 0, 0, 0};
    for (int k = 0; k < e->sets.count; k++) {
        if (set >= 0 && set != k)
            continue;
        sum.vectors += test_set_total(&e->sets.all[k]);
        sum.passed += e->summaries[k].counts[OUTCOME_RIGHT];
        sum.failed += summary_failed(&e->summaries[k]);
        sum.expected += e->summaries[k].expected;
        sum.skipped += e->summaries[k].counts[OUTCOME_SKIPPED];
    }
    return sum;
}

static const struct section *section_of_set(const struct test_run *e, int set)
{
    return e->comparators[set].operation->section;
}

static int set_of(const struct test_run *e, const struct record *r)
{
    return (int)(test_sets_at(&e->sets, r->position) - e->sets.all);
}

/* Until the next one is asked for. */
static const char *vector_name(const struct test_run *e, uint64_t position)
{
    static char name[LONGEST_ID + 1];
    TEST_VECTOR(q);
    test_vector_make(&q, &e->sets, position);
    snprintf(name, sizeof name, "%s", q.id);
    return name;
}

/* ---- numbers as text ---- */

/* E, rounded up to two digits; until the next one is asked for. */
static const char *error_text(double E)
{
    static char text[32];
    decimal_bound(text, E);
    return text;
}

/* Digits, rounded down to one after the point; until the next ones are asked for. */
static const char *digits_text(double digits)
{
    static char text[40];
    if (digits == INFINITY)
        return "exact";
    snprintf(text, sizeof text, "%.1f", floor(10.0 * fmax(digits, 0.0)) / 10.0);
    return text;
}

static double summary_digits(const struct test_run *e, int set)
{
    const struct summary *t = &e->summaries[set];
    return is_motion(section_of_set(e, set)) ? t->digits : -log10(ldexp(t->worst_E, -e->significand));
}

/* As far behind its first digit that counts as their difference is smaller, in powers of ten. */
int first_wrong_digit(const char *got, const char *expected)
{
    const int sign = (int)strspn(got, "+-"), end = (int)strcspn(got, "eE"), lead = sign + (int)strspn(got + sign, "0.");
    const int point = (int)strcspn(got, ".");
    int at = -1;
    mpfr_t is, off;
    mpfr_inits2(256, is, off, (mpfr_ptr)NULL);
    if (strpbrk(got, "xXnN") == NULL && mpfr_set_str(is, got, 10, MPFR_RNDN) == 0 && mpfr_set_str(off, expected, 10, MPFR_RNDN) == 0 &&
        mpfr_cmp(is, off) != 0) {
        mpfr_sub(off, is, off, MPFR_RNDN);
        mpfr_abs(is, is, MPFR_RNDN);
        mpfr_abs(off, off, MPFR_RNDN);
        mpfr_log10(is, is, MPFR_RNDN);
        mpfr_log10(off, off, MPFR_RNDN);
        const double places = floor(mpfr_get_d(is, MPFR_RNDN)) - floor(mpfr_get_d(off, MPFR_RNDN) + 1e-6); /* but for what inputs are rounded */
        at = places >= 0.0 ? lead + (int)fmin(places, end) : sign;
        at += lead < point && at >= point;
        at = lead >= end || at > end ? end : at;
    }
    mpfr_clears(is, off, (mpfr_ptr)NULL);
    return at;
}

/* ---- one vector ---- */

/* A vector with what was due and what came, each as text; made for reports only. */
struct exhibit {
    const struct section *section;
    struct test_vector vector;
    char inputs[MOST_INPUTS][LONGEST_INPUT];
    char *expected[MOST_OUTPUTS]; /* NULL: none was due, or none could be proved */
    bool invalid;
    char text[LONGEST_SHOWN];     /* the answer, cut into its words              */
    char *got[MOST_OUTPUTS];
    bool marked[MOST_OUTPUTS];    /* it is what is wrong                         */
};

/* Roots are a set: each that was answered stands beside the one that it is nearest to; those that are far off are what is wrong. */
static void pair_roots(struct exhibit *x, const struct record *r)
{
    double due[8], off[8], worst = 0.0;
    char *got[8];
    int order[4];
    memcpy(got, x->got, sizeof got);
    for (int k = 0; k < 8; k++)
        due[k] = strtod(x->expected[k], NULL);
    match_roots(due, r->values, order);
    for (int k = 0; k < 8; k++) {
        const int from = 2 * order[k / 2] + k % 2;
        x->got[k] = got[from];
        off[k] = fabs(r->values[from] - due[k]);
        worst = fmax(worst, off[k]);
    }
    for (int k = 0; k < 8; k++)
        x->marked[k] = off[k] > 1e-3 * worst;
}

static void exhibit_init(struct exhibit *x, const struct test_run *e, const struct record *r)
{
    memset(x, 0, sizeof *x);
    test_vector_init(&x->vector);
    test_vector_make(&x->vector, &e->sets, r->position);
    struct operation *o = &x->vector.set->operation;
    x->section = o->section;
    for (int i = 0; i < o->section->input_count; i++)
        test_vector_text(&x->vector, i, e->sets.form, x->inputs[i]);
    x->invalid = !x->vector.numbers ||
                 operation_digits(o, x->vector.inputs, SHOWN_DIGITS, x->expected) == OPERATION_INVALID;
    char *rest = NULL;
    snprintf(x->text, sizeof x->text, "%s", r->text);
    for (int i = 0; i < o->section->output_count && r->has_values; i++)
        x->got[i] = strtok_r(i == 0 ? x->text : NULL, " ", &rest);
    for (int i = 0; i < o->section->output_count; i++)
        x->marked[i] = r->outcome == OUTCOME_WRONG && (is_motion(o->section) || i == r->score.output);
    if (o->section->method == METHOD_ROOTS && r->outcome == OUTCOME_WRONG && r->has_values && x->got[7] != NULL &&
        x->expected[0] != NULL)
        pair_roots(x, r);
}

static void exhibit_clear(struct exhibit *x)
{
    for (int i = 0; i < MOST_OUTPUTS; i++)
        free(x->expected[i]);
    test_vector_clear(&x->vector);
}

/* An output, and a mark below its first wrong digit where the output is what fails. */
static void output_text(const struct exhibit *x, int i, FILE *file)
{
    fprintf(file, "    %-10s expected %s\n", x->section->outputs[i]->name, x->expected[i] ? x->expected[i] : "?");
    if (x->got[i] == NULL)
        return;
    fprintf(file, "    %-10s got      %s\n", "", x->got[i]);
    const int wrong = x->marked[i] && x->expected[i] ? first_wrong_digit(x->got[i], x->expected[i]) : -1;
    if (wrong >= 0)
        fprintf(file, "%*s^\n", 24 + wrong, "");
}

static void record_text(const struct test_run *e, const struct record *r, FILE *file)
{
    OWNED(exhibit) x;
    exhibit_init(&x, e, r);
    const struct section *s = x.section;
    fprintf(file, "  %s: %s", x.vector.id, outcome_names[r->outcome]);
    if (r->outcome == OUTCOME_WRONG && is_motion(s))
        fprintf(file, ", %s digits, %g are due", digits_text(r->score.digits), e->comparators[set_of(e, r)].digits);
    else if (r->outcome == OUTCOME_WRONG)
        fprintf(file, ", E = %s, at most %g passes", error_text(r->score.E), s->K);
    fputs(r->expected ? ", as expected\n" : "\n", file);
    const bool shown = r->outcome != OUTCOME_MISSING; /* else it is not the vector's fault */
    for (int i = 0; i < s->input_count && shown; i++) {
        const char *unit = strcmp(s->inputs[i]->unit, "-") == 0 ? "" : s->inputs[i]->unit;
        fprintf(file, "    %-10s %s%s%s\n", s->inputs[i]->name, x.inputs[i], *unit ? " " : "", unit);
    }
    for (int i = 0; i < s->output_count && shown && !x.invalid; i++)
        output_text(&x, i, file);
    if (x.invalid && shown)
        fprintf(file, "    expected   invalid\n");
    if ((!r->has_values || x.invalid) && shown)
        fprintf(file, "    got        %s\n", *r->text ? r->text : "nothing");
}

/* ---- what failed, as text ---- */

/* The first line of a kind, and why it is no answer. */
static const char *hint_of(const struct test_run *e, const char *line, enum outcome outcome)
{
    static char hint[240];
    line_hint(e->sets.count > 0 ? section_of_set(e, 0)->sheet : NULL, line, outcome, hint, sizeof hint);
    return hint;
}

static void line_text(const struct test_run *e, const char *line, enum outcome outcome, FILE *file)
{
    const char *hint = hint_of(e, line, outcome);
    fprintf(file, *hint != '\0' ? ": %s\n    %s\n" : ": %s\n", line, hint);
}

/* "eq07: 3 wrong, 1 missing", and one vector, or all, that fail so. */
static void failure_text(struct test_run *e, int k, bool all, FILE *file)
{
    const struct summary *t = &e->summaries[k];
    const char *before = ":";
    struct record r;
    fprintf(file, "\n%s", section_of_set(e, k)->id);
    for (int i = OUTCOME_WRONG; i < OUTCOME_UNNAMED; i++)
        if (t->counts[i] > 0) {
            fprintf(file, "%s %" PRIu64 " %s", before, t->counts[i], outcome_names[i]);
            before = ",";
        }
    if (t->expected > 0)
        fprintf(file, "; %" PRIu64 " of them as expected", t->expected);
    fputc('\n', file);
    if (all)
        test_run_rewind(e);
    else
        record_text(e, &t->shown, file);
    while (all && test_run_record(e, &r))
        if (r.outcome >= OUTCOME_WRONG && set_of(e, &r) == k)
            record_text(e, &r, file);
    if (*t->line == '\0')
        return;
    fprintf(file, "  first %s", outcome_names[t->line_outcome]);
    line_text(e, t->line, t->line_outcome, file);
}

static void diagnosis_text(const struct summary *t, FILE *file)
{
    if (t->diagnosis[0] != '\0')
        fprintf(file, "  looks like %s\n", t->diagnosis);
}

/* Lines that answer nothing, and an end that is none. */
static void client_text(const struct test_run *e, FILE *file)
{
    if (stray_count(e) > 0)
        fprintf(file, "\nlines that answer nothing: %" PRIu64 "\n", stray_count(e));
    for (int i = OUTCOME_UNNAMED; i < OUTCOMES; i++)
        if (e->strays[i].count > 0) {
            fprintf(file, "  %" PRIu64 " %s, the first is line %" PRIu64, e->strays[i].count, outcome_names[i], e->strays[i].first);
            line_text(e, e->strays[i].line, (enum outcome)i, file);
        }
    if (*e->ended != '\0')
        fprintf(file, "\nthe client %s\n", e->ended);
}

/* ---- text ---- */

static void row_text(const struct test_run *e, int k, FILE *file)
{
    const struct summary *t = &e->summaries[k];
    const struct totals sum = report_totals(e, k);
    if (sum.skipped == sum.vectors && *t->reason != '\0')
        return; /* named with its reason */
    fprintf(file, "%-15s %8" PRIu64 " %8" PRIu64 " %7" PRIu64 " %8" PRIu64, section_of_set(e, k)->id, sum.vectors,
            sum.passed, sum.failed, sum.skipped);
    if (t->worst != UINT64_MAX)
        fprintf(file, "  %8s  %6s  %s", is_motion(section_of_set(e, k)) ? "-" : error_text(t->worst_E),
                digits_text(summary_digits(e, k)), vector_name(e, t->worst));
    fputc('\n', file);
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
                fprintf(file, " %s", section_of_set(e, i)->id);
        fputc('\n', file);
    }
}

/* Whether numbers were answered that are right or wrong: no others have digits. */
static bool is_judged(const struct record *r)
{
    return r->outcome == OUTCOME_WRONG || (r->outcome == OUTCOME_RIGHT && r->has_values);
}

/* How good an integrator is: a line a scenario, the digits reached at each of its times, in the order they were asked. */
static void digits_by_time(struct test_run *e, FILE *file)
{
    char scenario[LONGEST_ID + 1] = "";
    struct record r;
    test_run_rewind(e);
    while (test_run_record(e, &r)) {
        if (!is_judged(&r) || !is_motion(section_of_set(e, set_of(e, &r))))
            continue;
        const char *name = vector_name(e, r.position), *time = strrchr(name, '-');
        time -= time > name && time[-1] == '-'; /* the other one is the time's sign */
        const size_t length = (size_t)(time - name);
        if (strncmp(scenario, name, length) != 0 || scenario[length] != '\0') {
            fprintf(file, *scenario == '\0' ? "\ndigits by time in s" : "");
            snprintf(scenario, sizeof scenario, "%.*s", (int)length, name);
            fprintf(file, "\n  %-40s", scenario);
        }
        fprintf(file, "  %s: %s", time + 1, digits_text(r.score.digits));
    }
    fputs(*scenario != '\0' ? "\n" : "", file);
}

void report_text(const struct report *r, FILE *file)
{
    struct test_run *e = r->run;
    const struct totals sum = report_totals(e, -1);
    fputs("operation        vectors   passed  failed  skipped   worst E  digits  worst vector\n", file);
    for (int k = 0; k < e->sets.count; k++)
        row_text(e, k, file);
    client_text(e, file);
    for (int k = 0; k < e->sets.count; k++)
        if (summary_failed(&e->summaries[k]) > 0 || (r->all && e->summaries[k].expected > 0)) {
            failure_text(e, k, r->all, file);
            fflush(file); /* before a second of diagnosis; an error stays with the file */
            struct progress p = progress_begin(false);
            progress_show(&p, (uint64_t)k, (uint64_t)e->sets.count);
            diagnose(e, k);
            progress_end(&p);
            diagnosis_text(&e->summaries[k], file);
        }
    if (r->all)
        digits_by_time(e, file);
    skips_text(e, file);
    for (int i = 0; i < e->expected_count; i++)
        if (e->expected[i].passed)
            fprintf(file, "\n%s was expected to fail, and passes\n", vector_name(e, e->expected[i].position));
    fprintf(file, "\n%" PRIu64 " vectors: %" PRIu64 " passed, %" PRIu64 " failed, %" PRIu64 " skipped", sum.vectors, sum.passed,
            sum.failed, sum.skipped);
    if (sum.expected > 0)
        fprintf(file, ", %" PRIu64 " failed as expected", sum.expected);
    if (stray_count(e) > 0)
        fprintf(file, "; lines that answer nothing: %" PRIu64, stray_count(e));
    fputc('\n', file);
}

/* ---- XML ---- */

/* What is no printable ASCII becomes a question mark. */
static void put_xml(FILE *file, const char *text)
{
    for (; *text != '\0'; text++) {
        const unsigned char c = (unsigned char)*text;
        if (c != '\n' && (c < 0x20 || c > 0x7e))
            fputc('?', file);
        else if (strchr("<>&\"", c) != NULL)
            fprintf(file, "&#%u;", (unsigned)c);
        else
            fputc(c, file);
    }
}

/* What is said of the client (no record), or of a vector, escaped. */
static void write_failure(FILE *file, const struct test_run *e, const struct record *r, const char *message)
{
    char *text = NULL;
    size_t size;
    FILE *stream = open_memstream(&text, &size);
    if (stream == NULL)
        out_of_memory();
    if (r == NULL) {
        client_text(e, stream);
    } else {
        record_text(e, r, stream);
        diagnosis_text(&e->summaries[set_of(e, r)], stream);
    }
    if (fclose(stream) != 0)
        out_of_memory();
    fprintf(file, "<failure message=\"%s\">", message);
    put_xml(file, text);
    fputs("</failure>", file);
    free(text);
}

static void write_suite(const char *name, uint64_t tests, uint64_t failures, uint64_t skipped, FILE *file)
{
    fprintf(file, "<testsuite name=\"%s\" tests=\"%" PRIu64 "\" failures=\"%" PRIu64 "\" errors=\"0\" skipped=\"%" PRIu64 "\">\n",
            name, tests, failures, skipped);
}

/* A suite an operation, a case a vector; and one of the client itself. */
static void write_xml(const struct report *r, FILE *file)
{
    struct test_run *e = r->run;
    struct record one;
    int open = -1;
    fputs("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites name=\"", file);
    put_xml(file, r->client);
    fputs("\">\n", file);
    while (test_run_record(e, &one)) {
        const int k = set_of(e, &one);
        const struct totals sum = report_totals(e, k);
        if (k != open) {
            fputs(open >= 0 ? "</testsuite>\n" : "", file);
            write_suite(section_of_set(e, k)->id, sum.vectors, sum.failed, sum.skipped + sum.expected, file);
        }
        open = k;
        fprintf(file, "<testcase classname=\"%s\" name=\"%s\">", section_of_set(e, k)->id, vector_name(e, one.position));
        if (one.outcome == OUTCOME_SKIPPED || one.expected)
            fprintf(file, "<skipped message=\"%s\"/>", one.expected ? "fails as expected" : "skipped");
        else if (one.outcome != OUTCOME_RIGHT)
            write_failure(file, e, &one, outcome_names[one.outcome]);
        fputs("</testcase>\n", file);
    }
    const bool bad = stray_count(e) > 0 || *e->ended != '\0';
    fputs("</testsuite>\n", file);
    write_suite("client", 1, bad, 0, file);
    fputs("<testcase classname=\"client\" name=\"lines\">", file);
    if (bad)
        write_failure(file, e, NULL, "lines that answer nothing, or an end that is none");
    fputs("</testcase>\n<system-err>", file);
    put_xml(file, r->errors);
    fputs("</system-err>\n</testsuite>\n</testsuites>\n", file);
}

/* ---- JSON ---- */

static void write_totals(struct json *j, const struct totals *sum)
{
    json_value(j, "vectors", "%" PRIu64, sum->vectors);
    json_value(j, "passed", "%" PRIu64, sum->passed);
    json_value(j, "failed", "%" PRIu64, sum->failed);
    json_value(j, "expected", "%" PRIu64, sum->expected);
    json_value(j, "skipped", "%" PRIu64, sum->skipped);
}

static void write_line(struct json *j, const struct test_run *e, enum outcome outcome, const char *line)
{
    json_strings(j, "outcome", outcome_names[outcome], "text", line, "hint", hint_of(e, line, outcome));
}

static void write_operation(struct json *j, const struct test_run *e, int k)
{
    const struct summary *t = &e->summaries[k];
    const struct section *s = section_of_set(e, k);
    const struct totals sum = report_totals(e, k);
    json_line(j, 4);
    json_open(j, NULL, '{');
    json_strings(j, "id", s->id, "level", level_names[level_of(s)]);
    write_totals(j, &sum);
    json_value(j, is_motion(s) ? "digits_due" : "K", "%g", is_motion(s) ? e->comparators[k].digits : e->comparators[k].K);
    if (t->worst != UINT64_MAX)
        json_strings(j, "worst_E", is_motion(s) ? NULL : error_text(t->worst_E), "digits", digits_text(summary_digits(e, k)), "worst",
                     vector_name(e, t->worst));
    json_open(j, "outcomes", '{');
    for (int i = OUTCOME_WRONG; i < OUTCOME_UNNAMED; i++)
        if (t->counts[i] > 0)
            json_value(j, outcome_names[i], "%" PRIu64, t->counts[i]);
    json_close(j);
    if (*t->line != '\0') {
        json_open(j, "line", '{');
        write_line(j, e, t->line_outcome, t->line);
        json_close(j);
    }
    json_string(j, "diagnosis", sum.failed > 0 ? t->diagnosis : NULL);
    json_close(j);
}

/* A vector: inputs as they were sent, all else as text. */
static void write_vector(struct json *j, const struct test_run *e, const struct record *r)
{
    OWNED(exhibit) x;
    exhibit_init(&x, e, r);
    const bool motion = is_motion(x.section), judged = is_judged(r);
    json_line(j, 4);
    json_open(j, NULL, '{');
    json_strings(j, "id", x.vector.id, "operation", x.section->id, "outcome", outcome_names[r->outcome]);
    if (r->expected)
        json_truth(j, "expected_to_fail", true);
    json_string(j, "digits", judged && motion ? digits_text(r->score.digits) : NULL);
    json_string(j, "E", judged && !motion ? error_text(r->score.E) : NULL);
    json_string(j, "strict_E", judged && !motion ? error_text(r->score.strict) : NULL);
    json_open(j, "inputs", '{');
    for (int i = 0; i < x.section->input_count; i++)
        json_string(j, x.section->inputs[i]->name, x.inputs[i]);
    json_close(j);
    if (x.invalid) {
        json_string(j, "expected", "invalid");
    } else {
        json_open(j, "expected", '{');
        for (int i = 0; i < x.section->output_count; i++)
            json_string(j, x.section->outputs[i]->name, x.expected[i] ? x.expected[i] : "?");
        json_close(j);
    }
    json_string(j, "got", r->text);
    json_close(j);
}

static void write_json(const struct report *r, FILE *file)
{
    struct test_run *e = r->run;
    const struct totals sum = report_totals(e, -1);
    struct record one;
    struct json j = json_on(file);
    json_open(&j, NULL, '{');
    json_line(&j, 2);
    json_string(&j, "client", r->client);
    write_totals(&j, &sum);
    json_value(&j, "oracle_seconds", "%.3f", r->seconds);
    json_strings(&j, "ended", e->ended, "errors", r->errors);
    json_open(&j, "lines", '[');
    for (int i = OUTCOME_UNNAMED; i < OUTCOMES; i++)
        if (e->strays[i].count > 0) {
            json_open(&j, NULL, '{');
            json_value(&j, "count", "%" PRIu64, e->strays[i].count);
            json_value(&j, "first", "%" PRIu64, e->strays[i].first);
            write_line(&j, e, (enum outcome)i, e->strays[i].line);
            json_close(&j);
        }
    json_close(&j);
    json_line(&j, 2);
    json_open(&j, "operations", '[');
    for (int k = 0; k < e->sets.count; k++)
        write_operation(&j, e, k);
    json_close(&j);
    json_line(&j, 2);
    json_open(&j, "results", '[');
    while (test_run_record(e, &one))
        write_vector(&j, e, &one);
    json_close(&j);
    json_line(&j, 0);
    json_close(&j);
}

/* ---- files ---- */

enum report_format report_format(const char *name)
{
    const char *end = strrchr(name, '.');
    return end == NULL ? REPORT_NONE : strcmp(end, ".xml") == 0 ? REPORT_XML : strcmp(end, ".json") == 0 ? REPORT_JSON : REPORT_NONE;
}

int report_write(const struct report *r, const char *name)
{
    struct whole_file f = whole_file_open(name);
    if (f.file != NULL) {
        test_run_rewind(r->run);
        (report_format(name) == REPORT_XML ? write_xml : write_json)(r, f.file);
    }
    return whole_file_close(&f, r->run->journal_error);
}
