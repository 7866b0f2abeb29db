#include "sheet/known_mistakes.h"

#include <stdlib.h>

/* What a change is about: the index of an input or output, or a subexpression's node, of the section computed in the end; -1: nothing. */
static int target_of(const struct section *s, const struct section *end, enum place place, const char *name)
{
    if (place == PLACE_INPUT)
        return input_place(end, name);
    if (s->method != METHOD_FORMULA || s != end)
        return -1;
    if (place == PLACE_OUTPUT)
        return quantity_place(s->outputs, s->output_count, name);
    return input_place(s, name) < 0 ? program_find(&s->corrected.program, name) : -1;
}

/*
 * Reads the changes in the names of the section as it should be: nodes that stand for inputs and subexpressions of the end, or for
 * its outputs. False where they do not fit it.
 */
static bool take_changes(struct mutation *a, const struct section *s, const struct known_mistake *m, bool strict, int *stand_in,
                         int *outputs, struct message *why)
{
    int taken = m->as != NULL;
    for (int k = 0; k < m->count; k++) {
        const char *name = m->changes[k].name;
        const int target = target_of(s, a->section, m->changes[k].place, name);
        struct message expected;
        if (target < 0 && strict) {
            message_set(why, "'%s' is not there to be changed", name);
            return false;
        }
        if (target < 0)
            continue;
        const int node = program_parse(&a->formulas.program, m->changes[k].formula, &expected);
        if (node < 0) {
            message_set(why, "%s: %.200s", name, expected.text);
            return false;
        }
        (m->changes[k].place == PLACE_OUTPUT ? outputs : stand_in)[target] = node;
        taken++;
    }
    if (taken == 0)
        message_set(why, "nothing is changed");
    for (int i = 0; i < a->section->input_count && taken > 0; i++)
        if (stand_in[i] < 0) {
            message_set(why, "%s needs %s", a->section->id, a->section->inputs[i]->name);
            taken = 0;
        }
    return taken > 0;
}

bool mutation_init(struct mutation *a, const struct sheet *sheet, const struct section *s,
                   const struct known_mistake *m, bool strict, struct message *why)
{
    const struct section *end = m->as ? section_find(sheet, m->as) : s;
    struct formulas *f = &a->formulas;
    *a = (struct mutation){.section = end};
    if (end == NULL || end->method == METHOD_NONE || end->output_count != s->output_count) {
        message_set(why, "as: expected an operation with as many outputs");
        return false;
    }
    a->formulas_end = end->method == METHOD_FORMULA;
    program_copy(&f->program, &s->corrected.program);
    for (int i = 0; i < s->output_count && s->method == METHOD_FORMULA; i++)
        if (program_find(&f->program, s->outputs[i]->name) < 0)
            program_name(&f->program, s->corrected.outputs[i], s->outputs[i]->name);
    int *stand_in = xrealloc(NULL, (size_t)end->corrected.program.count, sizeof *stand_in);
    for (int i = 0; i < end->corrected.program.count; i++)
        stand_in[i] = i < end->input_count ? input_place(s, end->inputs[i]->name) : -1;
    for (int i = 0; i < MOST_INPUTS; i++)
        f->outputs[i] = -1;
    const bool fits = take_changes(a, s, m, strict, stand_in, f->outputs, why);
    for (int i = 0; i < (a->formulas_end ? end->output_count : end->input_count) && fits; i++)
        if (f->outputs[i] < 0)
            f->outputs[i] = a->formulas_end ? program_copy_node(&f->program, &end->corrected.program, end->corrected.outputs[i], stand_in)
                                            : stand_in[i];
    f->conditions = s->corrected.conditions; /* of the same nodes */
    f->count = s->corrected.count;
    free(stand_in);
    if (!fits)
        mutation_clear(a);
    return fits;
}

void mutation_clear(struct mutation *a)
{
    program_clear(&a->formulas.program);
}
