#include "evaluate/vectors.h"

#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "evaluate/errors.h"
#include "evaluate/sample.h"
#include "formula/exact.h"
#include "text/decimal.h"
#include "text/progress.h"
#include "text/scope.h"

void vectors_header(const struct section *s)
{
    fputs("id", stdout);
    for (int i = 0; i < s->input_count; i++)
        printf(",%s", s->inputs[i]->name);
    for (int i = 0; i < s->output_count; i++)
        printf(",%s", s->outputs[i]->name);
    for (int i = 0; i < s->output_count && operation_has_sensitivity(s); i++)
        printf(",S_%s", s->outputs[i]->name);
    puts(",flags");
}

bool vector_leaves_range(struct operation *o, const struct input *inputs, int significand)
{
    const slong exponent = significand == BINARY32 ? 128 : significand == BINARY64 ? 1024 : 16384; /* from 2^(2 - exponent) to below 2^exponent */
    bool leaves = false;
    VECTOR(arb, outputs, MOST_OUTPUTS);
    if (o->section->method != METHOD_FORMULA) /* no other has subexpressions */
        return false;
    operation_enclose(o, inputs, 256, outputs);
    for (int i = 0; i < o->formulas->program.count && !leaves; i++) {
        arb_srcptr x = machine_value(&o->machine, i);
        if (!arb_contains_zero(x) && arb_is_finite(x)) /* zero: what underflows to it is seen in its operands; infinity: an input may be */
            leaves = arf_cmpabs_2exp_si(arb_midref(x), 2 - exponent) < 0 || arf_cmpabs_2exp_si(arb_midref(x), exponent) >= 0;
    }
    return leaves;
}

/* Digits of S, or "INF"; NULL while undecided. */
static char *sensitivity_text(const arb_t S)
{
    return arb_is_finite(S) || mag_is_inf(arb_radref(S)) ? decimal_of_ball(S, SENSITIVITY_DIGITS)
                                                         : text_copy("INF");
}

enum { QUICK_BITS = 128 }; /* two limbs: enough nearly always */

static bool sensitivity_texts(struct operation *o, const struct input *inputs, char **texts)
{
    const int count = o->section->output_count;
    VECTOR(arb, S, count);
    int left = count;
    for (slong prec = 192; left > 0 && prec <= 16384; prec *= 2) {
        if (prec == 192 && o->section->method == METHOD_FORMULA)
            formula_sensitivity(o, QUICK_BITS, NULL, S); /* from the outputs' own enclosure */
        else
            operation_sensitivity(o, inputs, prec, S);
        left = 0;
        for (int i = 0; i < count; i++) {
            if (texts[i] == NULL)
                texts[i] = sensitivity_text(S + i);
            if (texts[i] == NULL) {
                operation_sensitivity_exact(o, inputs, prec, i, S + i);
                texts[i] = sensitivity_text(S + i);
            }
            left += texts[i] == NULL;
        }
    }
    if (left > 0)
        message_set(&o->why, "%s: a sensitivity is undecided", o->section->id); /* LCOV_EXCL_LINE: known inputs need fewer bits */
    return left == 0;
}

const char *const input_forms[] = {"shortest", "exact", "hex"};

void input_write(char text[LONGEST_INPUT], const char *literal, enum input_form form)
{
    const double x = form == INPUTS_SHORTEST ? 0.0 : strtod(literal, NULL);
    if (form == INPUTS_SHORTEST || !isfinite(x))
        snprintf(text, LONGEST_INPUT, "%s", literal);
    else
        snprintf(text, LONGEST_INPUT, form == INPUTS_HEX ? "%a" : "%.767g", x); /* no binary64 has more digits */
}

const char *schema_text(const char *text)
{
    if (strpbrk(text, "0123456789") != NULL)
        return text;
    const double x = strtod(text, NULL);
    return isnan(x) ? "NaN" : x > 0 ? "INF" : "-INF";
}

/* printf() would take twice as long. */
static void print_cell(const char *text)
{
    putchar(',');
    if (text != NULL)
        fputs(text, stdout);
}

static void print_line(const char *id, const struct section *s, const char *const *texts, char *const *outputs,
                       char *const *S, const char *flag, const char *flags, enum input_form form)
{
    char input[LONGEST_INPUT];
    fputs(id, stdout);
    for (int i = 0; i < s->input_count; i++) {
        if (form != INPUTS_SHORTEST)
            input_write(input, texts[i], form);
        print_cell(schema_text(form != INPUTS_SHORTEST ? input : texts[i]));
    }
    for (int i = 0; i < s->output_count; i++)
        print_cell(outputs[i]);
    for (int i = 0; i < s->output_count && operation_has_sensitivity(s); i++)
        print_cell(S[i]);
    printf(",%s%s%s\n", flag, *flag && *flags ? " " : "", flags);
}

bool vector_read(const struct section *s, const char *const *texts, struct input *inputs)
{
    bool numbers = true;
    for (int i = 0; i < s->input_count; i++)
        numbers = input_read(&inputs[i], texts[i]) && numbers;
    return numbers;
}

bool vector_print(struct operation *o, const char *id, const char *const *texts, const char *flags, enum input_form form)
{
    const struct section *s = o->section;
    char *outputs[MOST_OUTPUTS] = {NULL}, *S[MOST_OUTPUTS] = {NULL};
    INPUTS(inputs);
    const bool numbers = vector_read(s, texts, inputs);
    const enum operation_status status = numbers ? operation_digits(o, inputs, VECTOR_DIGITS, outputs) : OPERATION_INVALID;
    const char *flag = status == OPERATION_INVALID ? "invalid" : "";
    bool fine = status != OPERATION_UNDECIDED;
    if (status == OPERATION_PROVED && operation_has_sensitivity(s)) {
        fine = sensitivity_texts(o, inputs, S);
        if (vector_leaves_range(o, inputs, BINARY64))
            flag = "range";
    }
    if (fine)
        print_line(id, s, texts, outputs, S, flag, flags, form);
    for (int i = 0; i < s->output_count; i++) {
        free(outputs[i]);
        free(S[i]);
    }
    return fine;
}

bool vectors_random(const struct section *s, uint64_t seed, uint64_t first, uint64_t count, enum input_form form)
{
    OPERATION(o, s);
    INPUTS(inputs);
    double values[MOST_INPUTS];
    char decimals[MOST_INPUTS][32], id[96];
    const char *texts[MOST_INPUTS];
    bool fine = true;
    struct progress progress = progress_begin(true);
    for (int i = 0; i < MOST_INPUTS; i++)
        texts[i] = decimals[i];
    for (uint64_t k = first; k - first < count && fine && !ferror(stdout); k++) {
        sample(&o, seed, k, values, inputs);
        for (int i = 0; i < s->input_count; i++)
            decimal_shortest(decimals[i], values[i]);
        snprintf(id, sizeof id, "%s-%" PRIu64 "-%" PRIu64, s->id, seed, k);
        fine = vector_print(&o, id, texts, "", form);
        progress_show(&progress, k - first + 1, count);
    }
    progress_end(&progress);
    if (!fine)
        fprintf(stderr, "coulomb-tether: %s\n", o.why.text);
    return fine;
}
