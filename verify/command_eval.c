/* coulomb-tether eval and table1: values of operations, every digit proved. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "command.h"
#include "decimal.h"
#include "series.h"

enum { MOST_INPUTS = 40, MOST_OUTPUTS = 16 };

static int read_inputs(const struct arguments *a, const struct section *s, bool exact,
                       struct input *inputs)
{
    const char *known[MOST_INPUTS];
    bool seen[MOST_INPUTS] = {false}, may_be_infinite[MOST_INPUTS];
    for (int i = 0; i < s->input_count; i++) {
        known[i] = s->inputs[i]->name;
        may_be_infinite[i] = s->inputs[i]->domain == DOMAIN_POSITIVE_OR_INFINITE;
    }
    int status = read_assignments(a, known, s->input_count, exact, may_be_infinite, seen, inputs);
    if (status == EXIT_USAGE)
        return status;
    for (int i = 0; i < s->input_count; i++)
        if (!seen[i])
            return complain(EXIT_USAGE, "%s: missing %s, expected %s=VALUE [%s]", s->id, known[i],
                            known[i], s->inputs[i]->unit);
    return status;
}

static void print_outputs(const struct section *s, char *const *digits)
{
    for (int i = 0; i < s->output_count; i++)
        printf("%s = %s %s\n", s->outputs[i]->name, digits[i], s->outputs[i]->unit);
}

static void print_json(const struct section *s, bool as_printed, long count, char *const *digits)
{
    printf("{\"id\": \"%s\", \"as_printed\": %s, \"digits\": %ld, \"outputs\": [", s->id,
           as_printed ? "true" : "false", count);
    for (int i = 0; i < s->output_count; i++) {
        printf("%s{\"name\": \"%s\", \"value\": \"%s\", \"unit\": ", i ? ", " : "",
               s->outputs[i]->name, digits[i]);
        json_text(s->outputs[i]->unit);
        putchar('}');
    }
    printf("]}\n");
}

static int evaluate(const struct arguments *a, const struct section *s, long digits)
{
    const bool as_printed = option_given(a, "--as-printed");
    struct input *inputs = inputs_new(s->input_count);
    char *outputs[MOST_OUTPUTS] = {NULL};
    struct operation o;
    operation_init(&o, s, as_printed);
    int status = read_inputs(a, s, option_given(a, "--exact"), inputs);
    if (status == EXIT_DONE && operation_digits(&o, inputs, digits, outputs) != OUTCOME_PROVED)
        status = complain(EXIT_FAILED_CHECK, "%s", o.why.text);
    if (status == EXIT_DONE) {
        if (option_given(a, "--json"))
            print_json(s, as_printed, digits, outputs);
        else
            print_outputs(s, outputs);
        status = output_finished();
    }
    for (int i = 0; i < s->output_count; i++)
        free(outputs[i]);
    operation_clear(&o);
    inputs_free(inputs, s->input_count);
    return status;
}

int command_eval(int count, char **texts)
{
    struct option options[] = {
        {"--digits", true, NULL}, {"--exact", false, NULL}, {"--as-printed", false, NULL}, {"--json", false, NULL}};
    struct arguments a = {.subcommand = "eval", .options = options, .option_count = 4};
    long digits = 40;
    int status = arguments_split(&a, count, texts, 1);
    if (status != EXIT_DONE)
        return status;
    const struct section *s = NULL;
    if (a.word_count == 0)
        status = complain(EXIT_USAGE, "eval: expected the id of an operation, see coulomb-tether equations");
    else if ((s = section_argument(a.words[0])) == NULL)
        status = EXIT_USAGE;
    else if (s->method == METHOD_NONE)
        status = complain(EXIT_USAGE, "%s is a definition, it computes nothing", s->id);
    else
        status = option_digits(&a, 40, &digits);
    if (status == EXIT_DONE && s != NULL)
        status = evaluate(&a, s, digits);
    free(a.assignments);
    return status;
}

/* ---- Table 1 ---- */

/* Significant digits of a printed number: those of its mantissa, leading zeros apart. */
static long printed_digits(const char *printed)
{
    long digits = 0;
    for (; *printed != '\0' && *printed != 'e'; printed++)
        if (*printed >= '0' && *printed <= '9' && (digits > 0 || *printed != '0'))
            digits++;
    return digits;
}

/* What the simulation uses: a value of the sheet, or Q_ref of Eq. (7) from the others; in SI. */
static void table_value(fmpq_t value, const struct table_row *row)
{
    const struct section *s = section_find(sheet(), "eq07");
    const char *given = quantity_find(sheet(), row->name)->value;
    if (given != NULL) {
        literal_read(value, given, true);
        return;
    }
    struct machine sums;
    machine_init(&sums, &s->corrected.program, &arithmetic_series, 1);
    for (int i = 0; i < s->input_count; i++) {
        const char *name = s->inputs[i]->name;
        literal_read(value, quantity_find(sheet(), strcmp(name, "L") == 0 ? "L_ref" : name)->value, true);
        arithmetic_series.set_rational(machine_value(&sums, i), value, 1);
    }
    machine_run(&sums);
    series_get_fmpq(value, machine_value(&sums, s->corrected.outputs[0]), 0);
    machine_clear(&sums);
}

static int print_row(const struct table_row *row, bool csv)
{
    fmpq_t value, scale, printed;
    fmpq_init(value);
    fmpq_init(scale);
    fmpq_init(printed);
    literal_read(scale, row->scale, true);
    literal_read(printed, row->printed, true);
    table_value(value, row);
    fmpq_div(value, value, scale);
    char *computed = decimal_of_rational(value, 17);
    char *rounded = decimal_of_rational(value, printed_digits(row->printed));
    literal_read(value, rounded, true);
    const bool rounds = fmpq_equal(value, printed);
    printf(csv ? "%s,%s,%s,%s,%s\n" : "%-6s %-12s %-24s %-10s %s\n", row->name, row->printed, computed,
           row->unit, rounds ? "yes" : "no");
    free(rounded);
    free(computed);
    fmpq_clear(value);
    fmpq_clear(scale);
    fmpq_clear(printed);
    return rounds ? EXIT_DONE : EXIT_FAILED_CHECK;
}

int command_table1(int count, char **texts)
{
    struct option options[] = {{"--csv", false, NULL}};
    struct arguments a = {.subcommand = "table1", .options = options, .option_count = 1};
    int status = arguments_split(&a, count, texts, 0);
    if (status == EXIT_DONE && a.assignment_count > 0)
        status = complain(EXIT_USAGE, "table1: unexpected argument '%s'", a.assignments[0]);
    free(a.assignments);
    if (status != EXIT_DONE)
        return status;
    const bool csv = option_given(&a, "--csv");
    printf(csv ? "%s,%s,%s,%s,%s\n" : "%-6s %-12s %-24s %-10s %s\n", "name", "printed", "computed",
           "unit", "rounds");
    for (int i = 0; i < sheet()->row_count; i++)
        if (print_row(&sheet()->table1[i], csv) != EXIT_DONE)
            status = EXIT_FAILED_CHECK;
    int written = output_finished();
    return written != EXIT_DONE ? written : status;
}
