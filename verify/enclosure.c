#include "enclosure.h"

#include "decimal.h"
#include "sheet.h"

static void know(const struct machine *m, const char *name, arb_srcptr value)
{
    const int node = program_find(m->program, name);
    if (node >= 0)
        arb_set(machine_value(m, node), value);
}

/* What the caller knows comes before what the sheet does. */
void enclose(arb_t z, const char *text, const struct known *known)
{
    const struct sheet *s = sheet();
    struct program p;
    struct machine m;
    struct message why;
    size_t where;
    fmpq_t q;
    fmpq_init(q);
    program_init(&p);
    for (const struct known *k = known; k->name != NULL; k++)
        program_input(&p, k->name);
    for (int i = 0; i < s->quantity_count; i++)
        if (s->quantities[i].value != NULL && program_find(&p, s->quantities[i].name) < 0)
            program_input(&p, s->quantities[i].name);
    const int node = program_parse(&p, text, &where, &why);
    machine_init(&m, &p, &arithmetic_ball, ENCLOSURE_BITS);
    for (int i = 0; i < s->quantity_count; i++)
        if (s->quantities[i].value != NULL && literal_read(q, s->quantities[i].value, true) == LITERAL_FINITE) {
            arb_set_fmpq(z, q, ENCLOSURE_BITS);
            know(&m, s->quantities[i].name, z);
        }
    for (const struct known *k = known; k->name != NULL; k++)
        know(&m, k->name, k->value);
    machine_run(&m);
    arb_indeterminate(z);
    if (node >= 0)
        arb_set(z, machine_value(&m, node));
    machine_clear(&m);
    program_clear(&p);
    fmpq_clear(q);
}
