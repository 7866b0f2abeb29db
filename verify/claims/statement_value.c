/* What the names of a statement's formulas stand for, and the values that these have. */
#include <stdlib.h>
#include <string.h>

#include "claims/statement.h"
#include "formula/exact.h"
#include "text/decimal.h"
#include "text/scope.h"

static enum how worse(enum how a, enum how b)
{
    return a > b ? a : b;
}

/* One of `at`, of those that come before `count`; -1: none. */
static int find_value(const struct values *at, int count, const char *name)
{
    while (count-- > 0)
        if (strcmp(at->list[count].name, name) == 0)
            return count;
    return -1;
}

static void value_enclose(arb_t z, enum how *how, const struct bindings *b, int index)
{
    const struct value *v = &b->at->list[index];
    struct bindings before = *b;
    before.at_count = index;
    formula_enclose(z, how, &v->formula, &before);
    if (v->uncertain) {
        SCOPE(arb, radius);
        formula_enclose(radius, how, &v->radius, &before);
        arb_add_error(z, radius);
        *how = worse(*how, CERTIFIED);
    }
}

/* A root or a computation's number, NAME or NAME.number. */
static bool assertion_number(arb_t z, enum how *how, const struct bindings *b, const char *name)
{
    for (int i = 0; i < b->statement->assertion_count; i++) {
        struct assertion *a = &b->statement->assertions[i];
        const size_t length = strlen(a->name);
        if (strncmp(name, a->name, length) != 0)
            continue;
        if (a->kind == ASSERT_ROOT && name[length] == '\0') {
            root_enclose(z, how, b->all, b->statement, a, b->bits);
            return true;
        }
        if (a->kind == ASSERT_COMPUTE && name[length] == '.' && computed_number(a->computed, name + length + 1, z, how))
            return true;
    }
    return false;
}

static bool sheet_rational(fmpq_t q, const struct sheet *s, const char *name)
{
    const struct quantity *quantity = quantity_find(s, name);
    return quantity != NULL && quantity->value != NULL && literal_read(q, quantity->value, true) == LITERAL_FINITE;
}

/* The value that `for` gives a name now; NULL: none. Its own formula stands outside of that. */
static const struct formula *turn_of(const struct bindings *b, const char *name)
{
    for (int i = 0; b->each != NULL && i < b->each->each_names; i++)
        if (strcmp(b->each->each[i], name) == 0)
            return &b->each->each_of[i][b->turn];
    return NULL;
}

static struct bindings without_turns(const struct bindings *b)
{
    struct bindings outside = *b;
    outside.each = NULL;
    return outside;
}

static void name_enclose(arb_t z, enum how *how, const struct bindings *b, const char *name)
{
    const struct formula *turn = turn_of(b, name);
    const struct bindings outside = without_turns(b);
    SCOPE(fmpq, q);
    const int index = find_value(b->at, b->at_count, name);
    arb_indeterminate(z);
    *how = EXACT;
    if (b->moving != NULL && strcmp(name, b->moving) == 0) {
        arb_set(z, b->moving_value);
    } else if (turn != NULL)
        formula_enclose(z, how, turn, &outside);
    else if (index >= 0)
        value_enclose(z, how, b, index);
    else if (strcmp(name, "pi") == 0)
        arb_const_pi(z, b->bits);
    else if (!assertion_number(z, how, b, name) && sheet_rational(q, b->all->sheet, name))
        arb_set_fmpq(z, q, b->bits);
}

void machine_bind(struct machine *m, int node, enum how *how, const struct bindings *b)
{
    char *needed = xrealloc(NULL, (size_t)node + 1, 1);
    program_needs(m->program, node, NULL, needed);
    *how = EXACT;
    for (int i = 0; i < m->program->inputs; i++) {
        enum how known = EXACT;
        if (i <= node && needed[i])
            name_enclose(machine_value(m, i), &known, b, m->program->names[i].text);
        *how = worse(*how, known);
    }
    free(needed);
}

void formula_enclose(arb_t z, enum how *how, const struct formula *f, const struct bindings *b)
{
    struct machine m;
    machine_init(&m, &f->program, &arithmetic_ball, b->bits);
    machine_bind(&m, f->node, how, b);
    machine_run(&m);
    arb_set(z, machine_value(&m, f->node));
    machine_clear(&m);
}

/* ---- exact numbers ---- */

static bool name_rational(fmpq_t q, const struct bindings *b, const char *name)
{
    const int index = find_value(b->at, b->at_count, name);
    if (b->moving != NULL && strcmp(name, b->moving) == 0)
        return false;
    const struct formula *turn = turn_of(b, name);
    const struct bindings outside = without_turns(b);
    if (turn != NULL)
        return formula_rational(q, turn, &outside);
    if (index >= 0) {
        struct bindings before = *b;
        before.at_count = index;
        return !b->at->list[index].uncertain && formula_rational(q, &b->at->list[index].formula, &before);
    }
    for (int i = 0; i < b->statement->assertion_count; i++)
        if (strncmp(name, b->statement->assertions[i].name, strcspn(name, ".")) == 0 &&
            strlen(b->statement->assertions[i].name) == strcspn(name, "."))
            return false;
    return sheet_rational(q, b->all->sheet, name);
}

bool machine_bind_exact(struct machine *m, int node, const struct bindings *b)
{
    char *needed = xrealloc(NULL, (size_t)node + 1, 1);
    bool rational = true;
    SCOPE(fmpq, q);
    program_needs(m->program, node, NULL, needed);
    for (int i = 0; i < m->program->inputs && i <= node && rational; i++)
        if (needed[i] && (b->moving == NULL || strcmp(b->moving, m->program->names[i].text) != 0)) {
            rational = name_rational(q, b, m->program->names[i].text);
            m->arithmetic->set_rational(machine_value(m, i), q, m->prec);
        }
    free(needed);
    return rational;
}

bool formula_rational(fmpq_t q, const struct formula *f, const struct bindings *b)
{
    struct machine m;
    machine_init(&m, &f->program, &arithmetic_exact, 0);
    bool rational = machine_bind_exact(&m, f->node, b);
    if (rational) {
        machine_run(&m);
        rational = exact_is_rational(q, machine_value(&m, f->node));
    }
    machine_clear(&m);
    return rational;
}
