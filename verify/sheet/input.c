#include "sheet/input.h"

#include <stdlib.h>

#include "text/decimal.h"

bool input_read(struct input *x, const char *literal)
{
    const enum literal kind = literal_read(&x->value, literal, false);
    x->infinite = kind == LITERAL_INFINITE;
    return kind == LITERAL_FINITE || x->infinite;
}

bool input_in_domain(const struct input *x, enum domain domain)
{
    const int sign = fmpq_sgn(&x->value);
    if (x->infinite)
        return domain == DOMAIN_POSITIVE_OR_INFINITE;
    return domain == DOMAIN_FINITE || sign > 0 || (sign == 0 && domain == DOMAIN_NOT_NEGATIVE);
}

struct input *inputs_new(int count)
{
    struct input *inputs = xrealloc(NULL, (size_t)count, sizeof *inputs);
    for (int i = 0; i < count; i++) {
        fmpq_init(&inputs[i].value);
        inputs[i].infinite = false;
    }
    return inputs;
}

void inputs_free(struct input *inputs, int count)
{
    for (int i = 0; i < count; i++)
        fmpq_clear(&inputs[i].value);
    free(inputs);
}

void inputs_leave(struct input **inputs)
{
    inputs_free(*inputs, MOST_INPUTS);
}

void section_enclose(const struct section *s, arb_srcptr inputs, slong prec, arb_ptr outputs)
{
    OWNED(machine) m;
    machine_init(&m, &s->corrected.program, &arithmetic_ball, prec);
    for (int i = 0; i < s->corrected.program.inputs; i++) /* definitions count theirs nowhere else */
        arb_set(machine_value(&m, i), inputs + i);
    machine_run(&m);
    for (int i = 0; i < s->output_count; i++)
        arb_set(outputs + i, machine_value(&m, s->corrected.outputs[i]));
}
