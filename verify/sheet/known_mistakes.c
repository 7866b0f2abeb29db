#include "sheet/known_mistakes.h"

#include <stdlib.h>
#include <string.h>

/* A mistake at work in a section: what each change is about, and the value that it puts there. */
struct substitution {
    int target; /* index of an input or output, node of a subexpression; -1: not in this section */
    int value;  /* node of the mutation's program */
};

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

/* Reads the changes in the names of the section as it should be; false where they do not fit it. */
static bool take_changes(struct substitution *changes, struct program *p, struct program *right,
                         const struct section *s, const struct section *end, const struct known_mistake *m,
                         bool strict, struct message *why)
{
    int taken = m->as != NULL;
    for (int k = 0; k < m->count; k++) {
        const char *name = m->changes[k].name;
        struct message expected;
        size_t where;
        changes[k].target = target_of(s, end, m->changes[k].place, name);
        if (changes[k].target < 0 && strict)
            message_set(why, "'%s' is not there to be changed", name);
        if (changes[k].target < 0 && strict)
            return false;
        if (changes[k].target < 0)
            continue;
        int node = program_parse(right, m->changes[k].formula, &where, &expected);
        if (node < 0) {
            message_set(why, "%s: %.200s", name, expected.text);
            return false;
        }
        int *identity = xrealloc(NULL, (size_t)right->count, sizeof *identity);
        for (int i = 0; i < right->count; i++)
            identity[i] = i < right->inputs ? i : -1;
        changes[k].value = program_inline(p, right, node, identity);
        free(identity);
        taken++;
    }
    if (taken == 0)
        message_set(why, "nothing is changed");
    return taken > 0;
}

/* What stands for the inputs, and for changed subexpressions, of the section that is computed in the end. */
static bool take_stand_ins(int *stand_in, const struct section *s, const struct section *end,
                           const struct known_mistake *m, const struct substitution *changes, struct message *why)
{
    for (int i = 0; i < end->corrected.program.count; i++)
        stand_in[i] = i < end->input_count ? input_place(s, end->inputs[i]->name) : -1;
    for (int k = 0; k < m->count; k++)
        if (changes[k].target >= 0 && m->changes[k].place != PLACE_OUTPUT)
            stand_in[changes[k].target] = changes[k].value;
    for (int i = 0; i < end->input_count; i++)
        if (stand_in[i] < 0) {
            message_set(why, "%s needs %s", end->id, end->inputs[i]->name);
            return false;
        }
    return true;
}

static void take_outputs(struct mutation *a, const struct section *s, const struct known_mistake *m,
                         const struct substitution *changes, const int *stand_in)
{
    const struct formulas *end = &a->section->corrected, *right = &s->corrected;
    struct formulas *f = &a->formulas;
    for (int i = 0; i < (a->formulas_end ? s->output_count : a->section->input_count); i++)
        f->outputs[i] = a->formulas_end ? program_inline(&f->program, &end->program, end->outputs[i], stand_in)
                                        : stand_in[i];
    for (int k = 0; k < m->count; k++)
        if (m->changes[k].place == PLACE_OUTPUT && changes[k].target >= 0)
            f->outputs[changes[k].target] = changes[k].value;
    int *identity = xrealloc(NULL, (size_t)right->program.count + 1, sizeof *identity);
    for (int i = 0; i < right->program.count; i++)
        identity[i] = i < right->program.inputs ? i : -1;
    f->conditions = xrealloc(NULL, (size_t)right->count + 1, sizeof *f->conditions);
    for (f->count = 0; f->count < right->count; f->count++) {
        f->conditions[f->count] = right->conditions[f->count];
        f->conditions[f->count].node =
            program_inline(&f->program, &right->program, right->conditions[f->count].node, identity);
    }
    free(identity);
}

bool mutation_init(struct mutation *a, const struct sheet *sheet, const struct section *s,
                   const struct known_mistake *m, bool strict, struct message *why)
{
    const struct section *end = m->as ? section_find(sheet, m->as) : s;
    struct substitution changes[MOST_CHANGES];
    struct program right;
    *a = (struct mutation){.section = end};
    if (end == NULL || end->method == METHOD_NONE || end->output_count != s->output_count) {
        message_set(why, "as: expected an operation with as many outputs");
        return false;
    }
    a->formulas_end = end->method == METHOD_FORMULA;
    if (!a->formulas_end && end->input_count > MOST_OUTPUTS) { /* they take the outputs' places */
        message_set(why, "expected a formula, or a method of at most %d inputs", MOST_OUTPUTS);
        return false;
    }
    for (int i = 0; i < s->input_count; i++)
        program_input(&a->formulas.program, s->inputs[i]->name);
    program_copy(&right, &s->corrected.program);
    for (int i = 0; i < s->output_count && s->method == METHOD_FORMULA; i++)
        if (program_find(&right, s->outputs[i]->name) < 0)
            program_name(&right, s->corrected.outputs[i], s->outputs[i]->name);
    int *stand_in = xrealloc(NULL, (size_t)end->corrected.program.count, sizeof *stand_in);
    bool fits = take_changes(changes, &a->formulas.program, &right, s, end, m, strict, why) &&
                take_stand_ins(stand_in, s, end, m, changes, why);
    if (fits)
        take_outputs(a, s, m, changes, stand_in);
    free(stand_in);
    program_clear(&right);
    if (!fits)
        mutation_clear(a);
    return fits;
}

void mutation_clear(struct mutation *a)
{
    program_clear(&a->formulas.program);
    free(a->formulas.conditions);
}
