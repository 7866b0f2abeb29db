/* What the names of a statement's formulas stand for, and the values that these have. */
#include <stdlib.h>
#include <string.h>

#include "claims/statement.h"
#include "formula/exact.h"
#include "text/decimal.h"
#include "text/scope.h"

/* The value that a name has, by the values before it (*within). NULL: none. */
static const struct value *value_of_name(struct bindings *within, const struct bindings *b, const char *name)
{
    *within = *b;
    within->inside = true;
    while (within->at_count-- > 0)
        if (strcmp(b->at->list[within->at_count].name, name) == 0)
            return &b->at->list[within->at_count];
    return NULL;
}

/* Now, if it has several. */
static const struct formula *value_now(const struct value *v, const struct bindings *b)
{
    return &v->of[v->turns > 1 ? b->turn : 0];
}

bool is_number_of(const char *name, const char *entry)
{
    const size_t length = strlen(entry);
    return strncmp(name, entry, length) == 0 && (name[length] == '\0' || name[length] == '.');
}

/* The root, or the computation, that a name is a number of; NULL: none. */
static struct assertion *assertion_of_name(const struct bindings *b, const char *name)
{
    for (int i = 0; i < b->statement->assertion_count; i++) {
        struct assertion *a = &b->statement->assertions[i];
        if ((a->kind == ASSERT_ROOT || a->kind == ASSERT_COMPUTE) && is_number_of(name, a->name))
            return a;
    }
    return NULL;
}

static bool is_moving(const struct bindings *b, const char *name)
{
    return b->moving != NULL && strcmp(name, b->moving) == 0;
}

static bool sheet_rational(fmpq_t q, const struct sheet *s, const char *name)
{
    const struct quantity *quantity = quantity_find(s, name);
    return quantity != NULL && quantity->value != NULL && literal_read(q, quantity->value, true) == LITERAL_FINITE;
}

static void name_enclose(arb_t z, const struct bindings *b, const char *name)
{
    struct bindings within;
    const struct value *value = value_of_name(&within, b, name);
    struct assertion *a = assertion_of_name(b, name);
    SCOPE(fmpq, q);
    SCOPE(arb, radius);
    arb_indeterminate(z);
    if (is_moving(b, name))
        return;
    if (value != NULL) {
        formula_enclose(z, value_now(value, b), &within);
        if (value->radius.program != NULL) {
            formula_enclose(radius, &value->radius, &within);
            arb_add_error(z, radius);
            weaken(b, CERTIFIED);
        }
    } else if (strcmp(name, "pi") == 0)
        arb_const_pi(z, b->bits);
    else if (a != NULL && a->kind == ASSERT_ROOT)
        root_enclose(z, a, b, b->bits);
    else if (a != NULL) {
        computed_number(a->computed, name + strlen(a->name) + 1, z);
        weaken(b, CERTIFIED);
    } else if (sheet_rational(q, b->all->sheet, name))
        arb_set_fmpq(z, q, b->bits);
}

static bool name_rational(fmpq_t q, const struct bindings *b, const char *name)
{
    struct bindings within;
    const struct value *value = value_of_name(&within, b, name);
    if (value != NULL)
        return value->radius.program == NULL && formula_rational(q, value_now(value, b), &within);
    return !is_moving(b, name) && assertion_of_name(b, name) == NULL && sheet_rational(q, b->all->sheet, name);
}

bool machine_bind(struct machine *m, int node, bool balls, const struct bindings *b)
{
    char *needed = program_needs(m->program, node, NULL);
    bool known = true;
    SCOPE(fmpq, q);
    for (int i = 0; i < m->program->inputs; i++) {
        const char *name = m->program->names[i].text;
        if (!needed[i] || (is_moving(b, name) && !b->inside))
            continue;
        if (balls)
            name_enclose(machine_value(m, i), b, name);
        else {
            known = name_rational(q, b, name) && known;
            m->arithmetic->set_rational(machine_value(m, i), q, m->prec);
        }
    }
    free(needed);
    return known;
}

void formula_enclose(arb_t z, const struct formula *f, const struct bindings *b)
{
    struct machine m;
    machine_init(&m, f->program, &arithmetic_ball, b->bits);
    machine_bind(&m, f->node, true, b);
    machine_run_to(&m, f->node);
    arb_set(z, machine_value(&m, f->node));
    machine_clear(&m);
}

bool formula_rational(fmpq_t q, const struct formula *f, const struct bindings *b)
{
    struct machine m;
    machine_init(&m, f->program, &arithmetic_exact, 0);
    bool rational = machine_bind(&m, f->node, false, b);
    if (rational) {
        machine_run_to(&m, f->node);
        rational = exact_is_rational(q, machine_value(&m, f->node));
    }
    machine_clear(&m);
    return rational;
}
