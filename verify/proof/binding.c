/* What binds a step to the equations that it leads from and to: tried, by altering their formulas. */
#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "proof/derivation.h"

#include "text/scope.h"

/* ---- what `from` and `to` name ---- */

static bool is_part_of_number(const char *entry, const char *equation)
{
    const size_t length = strlen(entry);
    return strncmp(entry, equation, length) == 0 && !isdigit((unsigned char)equation[length]);
}

const char *output_equation(const struct section *s, int output, bool *alone)
{
    const char *own[8] = {NULL};
    int count = 0;
    for (int i = 0; i < s->numbers; i++) {
        bool taken = false;
        for (int k = 0; k < s->relation_count; k++)
            taken = taken || strcmp(s->relations[k].equation, s->equations[i]) == 0;
        if (!taken)
            own[count++] = s->equations[i];
    }
    if (alone != NULL)
        *alone = count == s->output_count;
    return s->numbers == 0 ? NULL : count > 0 ? own[output % count] : s->equations[output % s->numbers];
}

/* "eq10lin", "eq02.x1_ddot", the id of a definition: the section, and what stands after the point, NULL: nothing. */
static const struct section *section_of_entry(const struct derivations *d, const char *entry, const char **name)
{
    char id[LONGEST_NAME + 1];
    const size_t length = strcspn(entry, ".");
    *name = entry[length] == '.' ? entry + length + 1 : NULL;
    snprintf(id, sizeof id, "%.*s", (int)length, entry);
    return section_or_definition(d->sheet, &d->definitions, id);
}

static void add_outputs(const struct section *s, const char *number, const char *name, struct entry_part *parts, int *count)
{
    for (int i = 0; i < s->output_count && s->method == METHOD_FORMULA && *count < MOST_PARTS; i++) {
        const char *equation = output_equation(s, i, NULL);
        const bool of_number = number == NULL || (equation != NULL && is_part_of_number(number, equation));
        if (of_number && (name == NULL || strcmp(name, s->outputs[i]->name) == 0))
            parts[(*count)++] = (struct entry_part){s, &s->corrected, s->corrected.outputs[i], s->outputs[i]->name, equation};
    }
}

int entry_parts(const struct derivations *d, const char *entry, struct entry_part *parts)
{
    const char *name;
    const struct section *section = section_of_entry(d, entry, &name);
    int count = 0;
    if (section != NULL) {
        add_outputs(section, NULL, name, parts, &count);
        const int node = count == 0 && name != NULL ? program_find(&section->corrected.program, name) : -1;
        if (node >= section->corrected.program.inputs)
            parts[count++] = (struct entry_part){section, &section->corrected, node, name, output_equation(section, 0, NULL)};
        return count;
    }
    for (int i = 0; i < d->sheet->section_count; i++) {
        const struct section *s = &d->sheet->sections[i];
        add_outputs(s, entry, NULL, parts, &count);
        for (int k = 0; k < 2 * s->relation_count && count < MOST_PARTS; k++) {
            const struct relation *r = &s->relations[k / 2];
            if (is_part_of_number(entry, r->equation))
                parts[count++] = (struct entry_part){s, &r->sides, r->sides.outputs[k % 2], r->text, r->equation};
        }
    }
    return count;
}

bool entry_concerns(const struct derivations *d, const char *entry, const struct use *u)
{
    struct entry_part parts[MOST_PARTS];
    const int count = entry_parts(d, entry, parts);
    bool concerns = false;
    for (int i = 0; i < count && !concerns; i++) {
        char *needed = program_needs(&parts[i].formulas->program, parts[i].node, NULL);
        concerns = parts[i].formulas == u->formulas && needed[u->part];
        free(needed);
    }
    return concerns;
}

bool entry_leads_to(const struct derivations *d, const char *entry, const char *equation)
{
    struct entry_part parts[MOST_PARTS];
    const int count = entry_parts(d, entry, parts);
    bool leads = false;
    for (int i = 0; i < count && !leads; i++)
        leads = entry_concerns(d, equation, &(struct use){.formulas = parts[i].formulas, .part = parts[i].node});
    return leads;
}

/* ---- alterations ---- */

/* What becomes of a formula F: a F + b, with free a and b of its own (an angle is turned by b); -F; or one of its nodes. */
enum change { CHANGE_ANY, CHANGE_RESULT, CHANGE_SIGN, CHANGE_LEFT, CHANGE_RIGHT, CHANGE_NUMBER, CHANGES };

static const char *const changes[CHANGES] = {[CHANGE_RESULT] = "its sign",
                                             [CHANGE_SIGN] = "a sign",
                                             [CHANGE_LEFT] = "a right factor or term dropped",
                                             [CHANGE_RIGHT] = "a left factor or term dropped",
                                             [CHANGE_NUMBER] = "a number or exponent"};

/* A step at work: behind the nodes of its program stand those that are other for an alteration. */
struct table {
    const struct derivations *d;
    const struct step *s;
    struct binding *b;
    struct identities t;    /* the step's, the program being the table's own                 */
    struct run run;         /* at a point of the domain: what differs there differs                                          */
    int count;              /* of its nodes                                                  */
    int *mark, *map;        /* of each node: 1 + its pair of free numbers where it is to be altered, else 0; what it is then */
    bool alone[MOST_SHOWN]; /* this equality alone breaks by something: the step needs it    */
};

static void run_open(const struct table *x, struct run *r, enum manner manner)
{
    run_begin(r, &x->t, FLINT_MAX(x->t.order, 0) + 1, manner, 2 * x->count);
    for (int i = 0; i < x->t.root_count; i++)
        run_root(r, x->t.roots[i].node);
    run_keep(r, x->count);
}

static void table_open(struct table *x, const struct identities *t, enum manner manner)
{
    x->t = *t;
    x->count = t->program.count;
    program_copy(&x->t.program, &t->program);
    x->mark = xrealloc(NULL, (size_t)x->count, sizeof *x->mark);
    x->map = xrealloc(NULL, (size_t)x->count, sizeof *x->map);
    memset(x->mark, 0, (size_t)x->count * sizeof *x->mark);
    x->t.needed = xrealloc(NULL, (size_t)x->count, 1);
    memset(x->t.needed, 1, (size_t)x->count); /* any node may be, by an alteration */
    run_open(x, &x->run, manner);
}

static void table_close(struct table *x)
{
    run_end(&x->run);
    program_clear(&x->t.program);
    free(x->t.needed);
    free(x->mark);
    free(x->map);
}

/* What to alter: what an entry stands for, or a part; where all that is NULL, everything. */
struct target {
    enum change change;
    int node; /* of the part's program, which changes */
    const char *entry;
    const struct entry_part *part;
};

static bool concerns(const struct table *x, const struct target *target, const struct use *u)
{
    const struct entry_part *part = target->part;
    if (target->entry != NULL)
        return entry_concerns(x->d, target->entry, u);
    if (part == NULL)
        return true;
    return u->formulas == part->formulas && (target->change >= CHANGE_SIGN || u->part == part->node);
}

/* Marks what a target alters; all uses of one formula have the pair of the first. */
static void mark(struct table *x, const struct target *target)
{
    const struct use *uses = x->t.uses;
    memset(x->mark, 0, (size_t)x->count * sizeof *x->mark);
    for (int i = 0; i < x->t.use_count; i++) {
        if (!concerns(x, target, &uses[i]))
            continue;
        const int at = target->change < CHANGE_SIGN ? uses[i].node : uses[i].copy[target->node];
        int first = 0;
        if (at < uses[i].first) /* something else is bound to it */
            continue;
        while (uses[first].formulas != uses[i].formulas || uses[first].part != uses[i].part)
            first++;
        x->mark[at] = 1 + uses[first].node;
    }
}

/* Changes a node, or says what stands in its place; false where this change is none of this node. Of a number n.exponent is added. */
static bool change_node(struct node *n, enum change change, int *instead)
{
    const bool pair = n->right >= 0;
    *instead = -1;
    if ((change == CHANGE_SIGN && n->op == OPERATOR_NEGATE) || (change == CHANGE_LEFT && n->left >= 0))
        *instead = n->left; /* a term, a factor, a divisor, a function is dropped */
    else if (change == CHANGE_SIGN && (n->op == OPERATOR_ADD || n->op == OPERATOR_SUBTRACT))
        n->op = n->op == OPERATOR_ADD ? OPERATOR_SUBTRACT : OPERATOR_ADD;
    else if (change == CHANGE_SIGN && (n->op == OPERATOR_SIN || n->op == OPERATOR_COS))
        n->op = n->op == OPERATOR_SIN ? OPERATOR_COS : OPERATOR_SIN;
    else if (change == CHANGE_RIGHT && pair && n->op != OPERATOR_DIVIDE)
        *instead = n->right;
    else if (change == CHANGE_RIGHT && n->op == OPERATOR_DIVIDE)
        n->op = OPERATOR_MULTIPLY;
    else if (change == CHANGE_NUMBER && (n->op == OPERATOR_POWER || n->op == OPERATOR_NUMBER))
        n->exponent++;
    else
        return false;
    return true;
}

/* a F + b, of an angle F + b */
static int any_formula(struct program *p, int node, int pair)
{
    const bool angle = p->nodes[node].op == OPERATOR_ATAN2;
    const int factor = program_append(p, OPERATOR_INPUT, -1, -1, 2 * pair);
    const int shift = program_append(p, OPERATOR_INPUT, -1, -1, 2 * pair + 1);
    fmpq_set_si(&p->nodes[shift].number, angle, 1);
    return program_append(p, OPERATOR_ADD, angle ? node : program_append(p, OPERATOR_MULTIPLY, node, factor, 0), shift, 0);
}

/* What node i is once the nodes before it are what the map says. */
static int altered_node(struct table *x, int i, enum change change)
{
    struct program *p = &x->t.program;
    struct node n = p->nodes[i];
    int node = i, instead = -1;
    n.left = n.left < 0 ? -1 : x->map[n.left];
    n.right = n.right < 0 ? -1 : x->map[n.right];
    const bool moved = n.left != p->nodes[i].left || n.right != p->nodes[i].right, own = x->mark[i] > 0;
    if (own && change_node(&n, change, &instead) && instead >= 0)
        return instead;
    if (moved || own) {
        node = program_append(p, n.op, n.left, n.right, n.exponent);
        fmpq_add_si(&p->nodes[node].number, &p->nodes[i].number, n.exponent); /* but numbers nothing has one */
    }
    if (own && change == CHANGE_RESULT)
        return program_append(p, OPERATOR_NEGATE, node, -1, 0);
    return own && change == CHANGE_ANY ? any_formula(p, node, x->mark[i] - 1) : node;
}

/* A derivative is taken anew. */
static void alter_rate(struct table *x, const struct rate *r)
{
    struct program *p = &x->t.program;
    const int count = p->count;
    int *rates = xrealloc(NULL, (size_t)count, sizeof *rates);
    for (int i = 0; i < count; i++)
        rates[i] = -1;
    for (int i = 0; i < r->first; i++)
        if (r->by[i] >= 0)
            rates[x->map[i]] = x->map[r->by[i]];
    x->map[r->result] = program_derivative(p, x->map[r->of], rates, count);
    free(rates);
}

/* What is marked changes, and all that rests on it. */
static void alter(struct table *x, enum change change)
{
    for (int i = 0, rates = 0; i < x->count; i++) {
        if (rates < x->t.rate_count && i == x->t.rates[rates].first) {
            const struct rate *here = &x->t.rates[rates++];
            alter_rate(x, here);
            for (; i < here->result; i++)
                x->map[i] = i; /* nothing else rests on them */
        } else {
            x->map[i] = altered_node(x, i, change);
        }
    }
    run_extend(&x->run);
}

static void restore(struct table *x)
{
    program_truncate(&x->t.program, x->count);
    run_forget(&x->run);
}

/* What is not shown to differ is equal still. Where the point has no value, normal forms tell whether it has one elsewhere. */
static bool equal_still(struct table *x, int left, int right)
{
    struct run everywhere;
    if (x->map[left] == left && x->map[right] == right)
        return true;
    enum result result = run_compare(&x->run, x->map[left], x->map[right]);
    if (result == IDENTITY_UNDECIDED) {
        run_open(x, &everywhere, RUN_LOOSE);
        run_extend(&everywhere);
        result = run_compare(&everywhere, x->map[left], x->map[right]);
        run_end(&everywhere);
    }
    return result != IDENTITY_DIFFERS;
}

/* Whether an equality breaks; where it is the only one, the step needs it. */
static bool breaks_by(struct table *x, struct target target)
{
    int broken = 0, last = -1;
    mark(x, &target);
    alter(x, target.change);
    for (int i = 0; i < x->t.shown_count && broken < 2; i++)
        if (!equal_still(x, x->t.shown[i].left, x->t.shown[i].right)) {
            broken++;
            last = i;
        }
    restore(x);
    if (broken == 1)
        x->alone[last] = true;
    return broken > 0;
}

/* False, after what is wrong was said of the step. */
#define BINDING_FAULT(table, at, offset, format, ...) \
    (node_message(&(table)->b->fault, at, offset, "step %s: " format, (table)->s->id, __VA_ARGS__), false)

static const struct yaml *item(const struct table *table, const char *key, int i)
{
    return &under(table->s->node, key)->items[i];
}

/* ---- no equality holds for any formulas ---- */

/* A line of algebra is true of any formulas, and may be; but what is said to be a number has to be of the step. */
static bool says_number(const struct identities *t, const struct equality *e)
{
    const struct node *nodes = t->program.nodes;
    return nodes[e->left].op == OPERATOR_NUMBER || nodes[e->right].op == OPERATOR_NUMBER;
}

/* The first of the equalities, NULL where there is none; of lines, whatever the definitions are, and none that goes on another. */
static const struct equality *first_tautology(struct table *x, bool lines)
{
    const struct identities *t = &x->t;
    const struct target everything = {.change = CHANGE_ANY};
    const struct equality *e = t->shown, *const end = t->shown + t->shown_count;
    bool speaks = true;
    mark(x, &everything);
    for (int i = t->program.inputs; i < t->program.named && lines; i++)
        if (x->mark[t->program.names[i].node] == 0)
            x->mark[t->program.names[i].node] = 1 + t->program.names[i].node;
    alter(x, CHANGE_ANY);
    for (; e < end && speaks; e++) {
        speaks = (lines && !says_number(t, e)) || !equal_still(x, e->left, e->right);
        for (const struct equality *link = e; !speaks && lines && link->offset > 0; link--)
            speaks = !equal_still(x, link[-1].left, link[-1].right);
    }
    restore(x);
    return speaks ? NULL : e - 1;
}

static const struct equality *tautology_of(const struct identities *t, bool lines)
{
    struct table x = {.d = NULL};
    table_open(&x, t, RUN_AT_POINT);
    const struct equality *empty = first_tautology(&x, lines);
    table_close(&x);
    return empty;
}

const struct equality *identities_tautology(const struct identities *t)
{
    return tautology_of(t, false);
}

static bool no_tautology(struct table *table)
{
    const struct equality *empty = first_tautology(table, false);
    if (empty == NULL)
        empty = tautology_of(&table->s->lines, true);
    return empty == NULL ||
           BINDING_FAULT(table, empty->at, empty->offset, "%s holds whatever the formulas are: it shows nothing", empty->text);
}

/* ---- from ---- */

static bool all_used(struct table *table)
{
    if (table->s->from_count == 0)
        return BINDING_FAULT(table, table->s->node, 0, "expected an equation or a %s in 'from'", "principle");
    for (int i = 0; i < table->s->from_count; i++)
        if (!breaks_by(table, (struct target){.change = CHANGE_ANY, .entry = table->s->from[i]}))
            return BINDING_FAULT(table, item(table, "from", i), 0, "'%s' is not used: any formula in its place would do", table->s->from[i]);
    return true;
}

static bool is_named(const struct table *table, const struct use *u)
{
    const struct step *s = table->s;
    for (int i = 0; i < s->from_count + s->to_count; i++)
        if (entry_concerns(table->d, i < s->from_count ? s->from[i] : s->to[i - s->from_count], u))
            return true;
    return false;
}

static bool nothing_beyond(struct table *table)
{
    const struct identities *t = &table->s->corrected, *lines = &table->s->lines;
    for (int i = 0; i < t->use_count + lines->use_count; i++) {
        const struct use *u = i < t->use_count ? &t->uses[i] : &lines->uses[i - t->use_count];
        if (!is_named(table, u))
            return BINDING_FAULT(table, table->s->node, 0, "it rests on %s, which neither from nor to names", u->section->id);
    }
    return true;
}

/* ---- for which values ---- */

/*
 * Whether what a formula's inputs are bound to fills an open set: their derivatives J by the free quantities are
 * independent at a point, J J^T having a determinant other than zero there, in balls. An equality of analytic
 * functions on an open set is one everywhere.
 */
static bool fills_open_set(const struct identities *t, const struct use *u)
{
    enum { BITS = 256 };
    const struct program *p = &u->formulas->program;
    const int inputs = t->program.inputs;
    char *needed = program_needs(p, u->part, NULL);
    int rows[MOST_INPUTS], count = 0;
    struct machine m;
    struct gradient J;
    SCOPE(arb, determinant);
    for (int i = 0; i < p->inputs; i++)
        if (needed[i])
            rows[count++] = u->copy[i];
    machine_init(&m, &t->program, &arithmetic_ball, BITS);
    gradient_init(&J, &t->program, rows, count, &arithmetic_ball, BITS);
    MATRIX(arb, square, count, count);
    for (int i = 0; i < inputs; i++) { /* 1 + 1/512, 1 + 2/512 ..., where nothing happens to vanish, and within a quarter turn */
        arb_set_si(machine_value(&m, i), 512 + 1 + i);
        arb_mul_2exp_si(machine_value(&m, i), machine_value(&m, i), -9);
    }
    machine_run(&m);
    gradient_run(&J, &m);
    for (int i = 0; i < count; i++)
        for (int k = 0; k < count; k++)
            for (int x = 0; x < inputs; x++)
                arb_addmul(arb_mat_entry(square, i, k), gradient_value(&J, i, x), gradient_value(&J, k, x), BITS);
    arb_mat_det(determinant, square, BITS);
    const bool fills = !arb_contains_zero(determinant); /* nor is it infinite, which contains all */
    machine_clear(&m);
    gradient_clear(&J);
    free(needed);
    return fills;
}

/* An output is shown for all values of its inputs, not for some alone. */
static bool is_general(struct table *table, int to, const struct entry_part *part)
{
    const struct identities *t = &table->s->corrected;
    bool general = false;
    for (int i = 0; i < t->use_count && !general; i++)
        general = t->uses[i].formulas == part->formulas && t->uses[i].part == part->node && fills_open_set(t, &t->uses[i]);
    return general || BINDING_FAULT(table, item(table, "to", to), 0,
                                    "%s is shown for some values of its inputs alone, expected free ones", part->name);
}

/* ---- to ---- */

/* Whether the changed formula is the same function of its inputs: then no step can tell. */
static bool is_equivalent(const struct program *p, int wanted, enum change change, int node)
{
    struct identities t = {.program = *p};
    struct table x = {.s = NULL};
    t.variables = xrealloc(NULL, (size_t)p->inputs + 1, sizeof *t.variables);
    for (int i = 0; i < p->inputs; i++)
        t.variables[i] = (struct variable){.signs = SIGN_ANY};
    table_open(&x, &t, RUN_LOOSE);
    x.mark[node] = 1;
    alter(&x, change);
    const bool same = run_compare(&x.run, wanted, x.map[wanted]) == IDENTITY_HOLDS;
    table_close(&x);
    free(t.variables);
    return same;
}

/* The nodes of a formula that a step speaks of: not those below a named subexpression that it leaves open. */
static char *nodes_spoken_of(const struct table *table, const struct program *p, int wanted)
{
    int *open = xrealloc(NULL, (size_t)p->count, sizeof *open);
    for (int i = 0; i < p->count; i++)
        open[i] = i < p->inputs ? 0 : -1;
    for (int i = 0; i < p->named; i++)
        if (is_free_name(&table->s->corrected, p->names[i].text))
            open[p->names[i].node] = 0;
    char *spoken = program_needs(p, wanted, open);
    for (int i = 0; i < wanted; i++)
        spoken[i] = spoken[i] && open[i] < 0;
    free(open);
    return spoken;
}

/* Every change of every node of the formula breaks an equality, or nothing would tell. */
static bool all_changes_tell(struct table *table, int to, const struct program *p, int wanted, const struct entry_part *part)
{
    struct target target = {.part = part};
    char *spoken = nodes_spoken_of(table, p, wanted);
    const char *silent = NULL;
    for (target.node = 0; target.node <= wanted; target.node++)
        for (target.change = CHANGE_SIGN; target.change < CHANGES && spoken[target.node] && silent == NULL; target.change++) {
            struct node n = p->nodes[target.node];
            int instead;
            if (!change_node(&n, target.change, &instead))
                continue;
            table->b->mutants++;
            if (!breaks_by(table, target) && !is_equivalent(p, wanted, target.change, target.node))
                silent = changes[target.change];
        }
    free(spoken);
    return silent == NULL || BINDING_FAULT(table, item(table, "to", to), 0, "%s may be altered (%s) and every equality holds still",
                                    part->name, silent);
}

/* An output or a side of a relation; the formula of a property says what is shown, and claims nothing. */
static bool part_is_bound(struct table *table, int to, const struct entry_part *part)
{
    const struct program *p = &part->formulas->program;
    const bool side = part->formulas != &part->section->corrected;
    if (!breaks_by(table, (struct target){.change = CHANGE_ANY, .part = part}))
        return BINDING_FAULT(table, item(table, "to", to), 0, "%s stands in no equality%s", part->name,
                             side ? " as a whole: a side is not shown" : "");
    if (!side && !breaks_by(table, (struct target){.change = CHANGE_RESULT, .part = part}) && part->equation != NULL &&
        !is_equivalent(p, part->node, CHANGE_RESULT, part->node))
        return BINDING_FAULT(table, item(table, "to", to), 0, "%s may have the other sign and every equality holds still", part->name);
    return part->equation == NULL || (all_changes_tell(table, to, p, part->node, part) && (side || is_general(table, to, part)));
}

/* What a step starts from it cannot lead to. */
static bool is_new(struct table *table, int to, const struct entry_part *part)
{
    for (int i = 0; i < table->s->from_count; i++)
        if (entry_concerns(table->d, table->s->from[i], &(struct use){.formulas = part->formulas, .part = part->node}))
            return BINDING_FAULT(table, item(table, "to", to), 0, "%s is in from already", part->name);
    return true;
}

static bool all_shown(struct table *table)
{
    if (table->s->to_count == 0)
        return BINDING_FAULT(table, table->s->node, 0, "expected an equation or a %s in 'to'", "property");
    for (int i = 0; i < table->s->to_count; i++) {
        struct entry_part parts[MOST_PARTS];
        const int count = entry_parts(table->d, table->s->to[i], parts);
        for (int k = 0; k < count; k++)
            if (!is_new(table, i, &parts[k]) || !part_is_bound(table, i, &parts[k]))
                return false;
    }
    return true;
}

/* ---- no equality can be left out ---- */

static bool all_wanted(struct table *table)
{
    const struct identities *t = &table->s->corrected;
    for (int i = 0; i < t->shown_count; i++)
        if (!table->alone[i])
            return BINDING_FAULT(table, t->shown[i].at, 0, "%s could be left out: nothing in from and to needs it", t->shown[i].text);
    return true;
}

void step_bind(const struct derivations *d, const struct step *s, struct binding *b)
{
    struct table table = {.d = d, .s = s, .b = b};
    *b = (struct binding){.mutants = 0};
    table_open(&table, &s->corrected, RUN_AT_POINT);
    if (no_tautology(&table) && nothing_beyond(&table) && all_used(&table) && all_shown(&table))
        all_wanted(&table);
    table_close(&table);
}

bool step_holds(struct step *s)
{
    bool bounded = true;
    if (!s->proved) {
        identities_prove(&s->corrected, &s->proof);
        if (s->differs)
            identities_prove(&s->printed, &s->printed_proof);
        for (int k = 0; k < s->remainder_count; k++)
            remainder_prove(&s->remainders[k], &s->remainders[k].proof);
        s->proved = true;
    }
    for (int k = 0; k < s->remainder_count; k++)
        bounded = bounded && s->remainders[k].proof.state == REMAINDER_PROVED;
    return bounded && s->proof.result == IDENTITY_HOLDS && s->line_proof.result == IDENTITY_HOLDS &&
           (!s->differs || s->printed_proof.result == IDENTITY_DIFFERS);
}

bool step_is_bound(const struct derivations *d, struct step *s)
{
    if (!s->bound) {
        identities_prove(&s->lines, &s->line_proof);
        if (step_holds(s))
            step_bind(d, s, &s->binding);
        s->bound = true;
    }
    return step_holds(s) && s->binding.fault.text[0] == '\0';
}
