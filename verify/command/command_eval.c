/* coulomb-tether eval: values of an operation, every digit proved. */
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "command/command_motion.h"
#include "conform/test_set.h"
#include "text/decimal.h"
#include "text/scope.h"

/*
 * The paper's case for what is not given: Table 1, the initial values, and what follows from them. A nonlinear motion's initial
 * state is that of the paper's attitude and length error by (10), the binary64 nearest to it.
 */
static void take_paper_case(const struct section *s, bool exact, const struct assignment *known, struct input *inputs)
{
    OWNED(scenario) paper;
    bool given[MOST_INPUTS];
    scenario_init(&paper, s->sheet, exact);
    for (int i = 0; i < s->input_count; i++) {
        const struct quantity *q = s->inputs[i];
        const char *text = q->value != NULL ? q->value : q->example; /* the sheet's reader has seen to it that there is one */
        given[i] = known[i].text != NULL;
        if (!given[i])
            inputs[i].infinite = literal_read(&inputs[i].value, text, exact) == LITERAL_INFINITE;
    }
    if (s->method != METHOD_FLOW_NONLINEAR && s->method != METHOD_RK4_NONLINEAR)
        return;
    for (int k = SET_m1; k <= SET_L_ref; k++) /* which may have been given */
        fmpq_set(&paper.value[k].value, &inputs[input_place(s, scenario_names[k])].value);
    const int first = input_place(s, "x1_0");
    start_by_angles(inputs + first, given + first, &paper);
}

/* What is missing, all of it in one line. */
static int check_given(const struct section *s, const struct assignment *known)
{
    char missing[2048] = "";
    for (int i = 0; i < s->input_count; i++)
        if (known[i].text == NULL) {
            add_text(missing, sizeof missing, ", ", s->inputs[i]->name);
            add_text(missing, sizeof missing, " [", s->inputs[i]->unit);
            add_text(missing, sizeof missing, "", "]");
        }
    return *missing == '\0' ? EXIT_DONE
                            : usage_error(EXIT_USAGE, "%s: missing %s; --table1 fills in the paper's case", s->id, missing);
}

static int read_inputs(const struct arguments *a, const struct section *s, bool exact, struct input *inputs)
{
    struct assignment known[MOST_INPUTS] = {{.name = NULL}};
    const bool paper = option_given(a, "--table1");
    for (int i = 0; i < s->input_count; i++)
        known[i] = (struct assignment){.name = s->inputs[i]->name, .value = inputs + i,
                                       .may_be_infinite = s->inputs[i]->domain == DOMAIN_POSITIVE_OR_INFINITE};
    int status = take_names(a, known, s->input_count);
    if (status == EXIT_DONE && !paper)
        status = check_given(s, known);
    if (status == EXIT_DONE)
        status = take_values(known, s->input_count, exact);
    if (status == EXIT_DONE && paper)
        take_paper_case(s, exact, known, inputs);
    return status;
}

static int evaluate_section(const struct arguments *a, const struct section *s, long digits)
{
    INPUTS(inputs);
    char *outputs[MOST_OUTPUTS] = {NULL};
    struct number numbers[MOST_OUTPUTS];
    OWNED(operation) o;
    operation_init(&o, s, option_given(a, "--as-printed"));
    const int status = read_inputs(a, s, option_given(a, "--exact"), inputs);
    if (status != EXIT_DONE)
        return status;
    if (operation_digits(&o, inputs, digits, outputs) != OPERATION_PROVED)
        return usage_error(EXIT_FAILED_CHECK, "%s", o.why.text);
    for (int i = 0; i < s->output_count; i++)
        numbers[i] = (struct number){.name = s->outputs[i]->name, .unit = s->outputs[i]->unit, .value = outputs[i]};
    print_numbers(a, s->id, digits, numbers, s->output_count);
    for (int i = 0; i < s->output_count; i++)
        free(outputs[i]);
    return EXIT_DONE;
}

/* ---- question lines ---- */

enum { LONGEST_QUESTION = 65536 }; /* with the zero byte that ends it */

struct questions {
    const struct sheet *sheet;
    struct operation *operations; /* one of each section, without a section until it is asked for */
    struct input *inputs;
    long digits;
    bool exact, as_printed;
    unsigned long line, unproved, first_unproved;
};

static int malformed(const struct questions *q, const char *format, const char *what, const char *more)
{
    char text[512];
    snprintf(text, sizeof text, format, what, more); /* NOLINT: each format takes two texts */
    return usage_error(EXIT_USAGE, "standard input: line %lu: %s", q->line, text);
}

static struct operation *operation_asked(struct questions *q, const char *id)
{
    const struct section *s = section_find(q->sheet, id);
    if (s == NULL || s->method == METHOD_NONE)
        return NULL;
    struct operation *o = &q->operations[s - q->sheet->sections];
    if (o->section == NULL)
        operation_init(o, s, q->as_printed);
    return o;
}

/* VECTOR OUTPUT..., VECTOR invalid, or VECTOR skip REASON. */
static void print_answer(struct questions *q, struct operation *o, const char *vector, bool numbers)
{
    char *outputs[MOST_OUTPUTS] = {NULL};
    const enum operation_status status = numbers ? operation_digits(o, q->inputs, q->digits, outputs) : OPERATION_INVALID;
    fputs(vector, stdout);
    if (status == OPERATION_INVALID)
        fputs(" invalid", stdout);
    if (status == OPERATION_UNDECIDED) {
        printf(" skip %s", o->why.text);
        q->first_unproved = q->unproved++ == 0 ? q->line : q->first_unproved;
    }
    for (int i = 0; i < o->section->output_count && status == OPERATION_PROVED; i++) {
        printf(" %s", outputs[i]);
        free(outputs[i]);
    }
    putchar('\n');
}

static int answer_line(struct questions *q, char *line)
{
    static const char blanks[] = " \t\r\n";
    char *rest = NULL, *id = strtok_r(line, blanks, &rest), *vector = id ? strtok_r(NULL, blanks, &rest) : NULL;
    if (vector == NULL)
        return malformed(q, "expected ID VECTOR-ID INPUT...%s%s", id ? ", got " : ", got nothing", id ? id : "");
    struct operation *o = operation_asked(q, id);
    if (o == NULL)
        return malformed(q, "'%.40s' is no operation%s", id, "");
    if (!is_vector_id(vector))
        return malformed(q, "'%.40s' is no vector's id, expected letters, digits, '_', '.' and '-'%s", vector, "");
    const struct section *s = o->section;
    bool numbers = true;
    for (int i = 0; i < s->input_count; i++) {
        const char *word = strtok_r(NULL, blanks, &rest);
        const enum literal literal = word ? literal_read(&q->inputs[i].value, word, q->exact) : LITERAL_MALFORMED;
        if (word == NULL)
            return malformed(q, "missing %s of %s", s->inputs[i]->name, s->id);
        if (literal == LITERAL_MALFORMED)
            return malformed(q, "%s: expected a number, got '%.40s'", s->inputs[i]->name, word);
        q->inputs[i].infinite = literal == LITERAL_INFINITE;
        numbers = numbers && (literal == LITERAL_FINITE || literal == LITERAL_INFINITE);
    }
    const char *more = strtok_r(NULL, blanks, &rest);
    if (more != NULL)
        return malformed(q, "'%.40s' follows the last input of %s", more, s->id);
    print_answer(q, o, vector, numbers);
    return EXIT_DONE;
}

/* The next line without its LF; false at the end, or where it cannot be read. It is not fine with a zero byte, or too long. */
static bool next_line(char line[LONGEST_QUESTION], bool *fine)
{
    int length = 0;
    *line = '\0';
    if (scanf("%65535[^\n]%n", line, &length) == EOF)
        return false;
    const int end = getchar();
    *fine = strlen(line) == (size_t)length && (end == '\n' || end == EOF);
    return !ferror(stdin);
}

/* Each line is answered before the next is read: who asks may wait for it. The first malformed one ends it. */
static int answer_lines(struct questions *q)
{
    static char line[LONGEST_QUESTION];
    int status = EXIT_DONE;
    bool fine;
    while (status == EXIT_DONE && next_line(line, &fine)) {
        q->line++;
        if (q->line == 1 && strncmp(line, "\357\273\277", 3) == 0) /* an editor's byte order mark */
            memset(line, ' ', 3);
        if (!fine)
            status = malformed(q, "longer than %s bytes, or with a zero byte%s", "65535", "");
        else
            status = answer_line(q, line);
        if (fflush(stdout) != 0)
            return output_finished();
    }
    if (status == EXIT_DONE && ferror(stdin))
        return usage_error(EXIT_FAILED_CHECK, "standard input: %s", strerror(errno));
    if (status == EXIT_DONE && q->unproved > 0)
        return usage_error(EXIT_FAILED_CHECK, "standard input: %lu skipped as unproved, the first is line %lu", q->unproved,
                           q->first_unproved);
    return status;
}

static int answer_questions(const struct arguments *a, long digits)
{
    const struct sheet *sheet = &a->paper->sheet;
    INPUTS(inputs);
    struct questions q = {.sheet = sheet, .digits = digits, .exact = option_given(a, "--exact"),
                          .as_printed = option_given(a, "--as-printed"), .inputs = inputs};
    const size_t size = (size_t)sheet->section_count * sizeof *q.operations;
    q.operations = memset(xrealloc(NULL, size, 1), 0, size);
    const int status = answer_lines(&q);
    for (int i = 0; i < sheet->section_count; i++)
        if (q.operations[i].section != NULL)
            operation_clear(&q.operations[i]);
    free(q.operations);
    return status;
}

int command_eval(const struct arguments *a)
{
    const long digits = (long)option_number(a, "--digits");
    const bool lines = a->word_count > 0 && strcmp(a->words[0], "-") == 0;
    if (lines && a->assignment_count > 0)
        return usage_error(EXIT_USAGE, "eval -: unexpected argument '%s'", a->assignments[0]);
    const struct section *s = lines ? NULL : operation_argument(a);
    return lines ? answer_questions(a, digits) : s != NULL ? evaluate_section(a, s, digits) : EXIT_USAGE;
}
