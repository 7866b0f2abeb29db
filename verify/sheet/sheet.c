#include "sheet/sheet.h"

#include <stdlib.h>
#include <string.h>

static void formulas_clear(struct formulas *f)
{
    program_clear(&f->program);
    free(f->let);
    free(f->conditions);
}

void sheet_clear(struct sheet *s)
{
    for (int i = 0; i < s->section_count; i++) {
        formulas_clear(&s->sections[i].corrected);
        formulas_clear(&s->sections[i].printed);
        for (int k = 0; k < s->sections[i].relation_count; k++)
            formulas_clear(&s->sections[i].relations[k].sides);
        free(s->sections[i].relations);
        free(s->sections[i].specials);
        free(s->sections[i].mistakes);
    }
    tree_close(s->tree);
    free(s->table1);
    free(s->mistakes);
    free(s->sections);
    free(s->quantities);
    *s = (struct sheet){0};
}

const struct section *section_find(const struct sheet *s, const char *id)
{
    return NAMED(id, s->sections, s->section_count, struct section, id);
}

const struct quantity *quantity_find(const struct sheet *s, const char *name)
{
    return NAMED(name, s->quantities, s->quantity_count, struct quantity, name);
}

int quantity_place(const struct quantity *const *list, int count, const char *name)
{
    int place = count - 1;
    while (place >= 0 && strcmp(list[place]->name, name) != 0)
        place--;
    return place;
}

int input_place(const struct section *s, const char *name)
{
    return quantity_place(s->inputs, s->input_count, name);
}
