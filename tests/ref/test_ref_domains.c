/* Every function of ref/ that answers an operation: NaN in all outputs wherever one input leaves its domain in the sheet. */
#include "tests/run.h"
#include "tests/paper.h"

#include <string.h>

#include "evaluate/reference.h"
#include "evaluate/sample.h"

static const struct section *asked;

static size_t outputs_of_ref(const double x[], double y[])
{
    reference_find(asked->id)(x, y);
    return (size_t)asked->output_count - (strcmp(asked->id, "eq42") == 0); /* whose last is a truth value */
}

EACH(each_input_outside_its_domain_gives_no_number, sheet()->section_count)
{
    static const char letters[] = {[DOMAIN_FINITE] = 'r', [DOMAIN_POSITIVE] = '+', [DOMAIN_NOT_NEGATIVE] = '0', [DOMAIN_POSITIVE_OR_INFINITE] = 'i'};
    struct operation o;
    double inside[MOST_INPUTS];
    char domain[MOST_INPUTS + 1] = "";
    asked = &sheet()->sections[_i];
    if (asked->method == METHOD_NONE)
        return;
    const int t = input_place(asked, "t"), h = input_place(asked, "h");
    struct input *inputs = inputs_new(asked->input_count);
    operation_init(&o, asked, false);
    sample(&o, 1, 0, inside, inputs);
    if (t >= 0) /* a short way, on which no craft meet, and whole steps of -1 s would lead nowhere */
        inside[t] = 1;
    if (h >= 0)
        inside[h] = 1;
    for (int i = 0; i < asked->input_count; i++)
        domain[i] = letters[asked->inputs[i]->domain];
    assert_rejects_outside(outputs_of_ref, domain, inside);
    inputs_free(inputs, asked->input_count);
    operation_clear(&o);
}
