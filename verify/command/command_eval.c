/* coulomb-tether eval: values of an operation, every digit proved. */
#include <stdio.h>
#include <stdlib.h>

#include "command/command.h"
#include "text/decimal.h"

static int read_inputs(const struct arguments *a, const struct section *s, bool exact,
                       struct input *inputs)
{
    const char *known[MOST_INPUTS];
    bool seen[MOST_INPUTS] = {false}, may_be_infinite[MOST_INPUTS];
    for (int i = 0; i < s->input_count; i++) {
        known[i] = s->inputs[i]->name;
        may_be_infinite[i] = s->inputs[i]->domain == DOMAIN_POSITIVE_OR_INFINITE;
    }
    const char *refused;
    int status = read_assignments(a, known, s->input_count, exact, may_be_infinite, seen, inputs, &refused);
    if (status != EXIT_DONE)
        return status;
    for (int i = 0; i < s->input_count; i++)
        if (!seen[i])
            return usage_error(EXIT_USAGE, "%s: missing %s, expected %s=VALUE [%s]", s->id, known[i],
                               known[i], s->inputs[i]->unit);
    return refused != NULL ? refuse_assignment(refused, exact) : EXIT_DONE;
}

static void print_outputs(const struct section *s, char *const *digits)
{
    for (int i = 0; i < s->output_count; i++)
        printf("%s = %s %s\n", s->outputs[i]->name, digits[i], s->outputs[i]->unit);
}

static void print_values_json(const struct section *s, bool as_printed, long count, char *const *digits)
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

static int evaluate_section(const struct arguments *a, const struct section *s, long digits)
{
    const bool as_printed = option_given(a, "--as-printed");
    struct input *inputs = inputs_new(s->input_count);
    char *outputs[MOST_OUTPUTS] = {NULL};
    struct operation o;
    operation_init(&o, s, as_printed);
    int status = read_inputs(a, s, option_given(a, "--exact"), inputs);
    if (status == EXIT_DONE && operation_digits(&o, inputs, digits, outputs) != OPERATION_PROVED)
        status = usage_error(EXIT_FAILED_CHECK, "%s", o.why.text);
    if (status == EXIT_DONE) {
        if (option_given(a, "--json"))
            print_values_json(s, as_printed, digits, outputs);
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

int command_eval(const struct arguments *a)
{
    long digits;
    const struct section *s = operation_argument(a);
    if (s == NULL || option_digits(a, 40, &digits) != EXIT_DONE)
        return EXIT_USAGE;
    return evaluate_section(a, s, digits);
}
