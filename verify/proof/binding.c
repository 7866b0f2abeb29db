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

/* Identities with formulas altered, at a point of the domain: what differs there differs. */
struct altered {
    const struct identities *of;
    struct identities t;
    struct run run;
};

static void run_altered(struct run *r, const struct altered *x, enum manner manner)
{
    const struct identities *of = x->of;
    run_begin(r, of, FLINT_MAX(of->order, 0) + 1, manner, 4 * (of->use_count + of->program.named - of->program.inputs + 1));
    for (int i = 0; i < of->root_count; i++)
        run_root(r, of->roots[i].node);
    run_turn_to(r, &x->t);
}

static void altered_open(struct altered *x, const struct identities *of, const struct alteration *a)
{
    x->of = of;
    identities_alter(&x->t, of, a);
    run_altered(&x->run, x, RUN_AT_POINT);
}

static void altered_close(struct altered *x)
{
    run_end(&x->run);
    identities_clear(&x->t);
}

/* What is not shown to differ is equal still. Where the point has no value, normal forms tell whether it has one elsewhere. */
static bool equal_still(struct altered *x, int shown)
{
    const struct equality *e = &x->t.shown[shown];
    struct run everywhere;
    enum result result = run_compare(&x->run, e->left, e->right);
    if (result == IDENTITY_UNDECIDED) {
        run_altered(&everywhere, x, RUN_LOOSE);
        result = run_compare(&everywhere, e->left, e->right);
        run_end(&everywhere);
    }
    return result != IDENTITY_DIFFERS;
}

/* A step at work. */
struct table {
    const struct derivations *d;
    const struct step *s;
    struct binding *b;
    bool *uses;             /* of the formulas that it takes: to be altered               */
    bool alone[MOST_SHOWN]; /* this equality alone breaks by something: the step needs it */
};

/* Whether an equality breaks; where it is the only one, the step needs it. */
static bool breaks_by(struct table *table, enum change change, int node)
{
    int broken = 0, last = -1;
    struct altered x;
    altered_open(&x, &table->s->corrected, &(struct alteration){change, node, table->uses, false});
    for (int i = 0; i < x.t.shown_count && broken < 2; i++)
        if (!equal_still(&x, i)) {
            broken++;
            last = i;
        }
    altered_close(&x);
    if (broken == 1)
        table->alone[last] = true;
    return broken > 0;
}

static bool breaks_by_part(struct table *table, const struct entry_part *part, enum change change, int node)
{
    const struct identities *t = &table->s->corrected;
    for (int i = 0; i < t->use_count; i++)
        table->uses[i] = t->uses[i].formulas == part->formulas && (change >= CHANGE_SIGN || t->uses[i].part == part->node);
    return breaks_by(table, change, node);
}

static bool breaks_by_entry(struct table *table, const char *entry)
{
    const struct identities *t = &table->s->corrected;
    for (int i = 0; i < t->use_count; i++)
        table->uses[i] = entry_concerns(table->d, entry, &t->uses[i]);
    return breaks_by(table, CHANGE_ANY, -1);
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

/* Whether something that was altered is in it. */
static bool is_altered(const struct program *p, const struct equality *e)
{
    char *needed = program_needs(p, FLINT_MAX(e->left, e->right), NULL);
    bool free_number = false;
    program_mark(p, FLINT_MIN(e->left, e->right), NULL, needed);
    for (int i = p->inputs; i < p->count; i++)
        free_number = free_number || (needed[i] && p->nodes[i].op == OPERATOR_INPUT);
    free(needed);
    return free_number;
}

/* The first of the equalities, NULL where there is none; of lines, whatever the definitions are, and none that goes on another. */
static const struct equality *first_tautology(const struct identities *t, bool lines)
{
    bool *all = xrealloc(NULL, (size_t)t->use_count + 1, sizeof *all), speaks = true;
    struct altered x;
    int i = 0;
    memset(all, true, (size_t)t->use_count);
    altered_open(&x, t, &(struct alteration){CHANGE_ANY, -1, all, lines});
    for (; i < x.t.shown_count && speaks; i++) {
        speaks = (lines && !says_number(t, &t->shown[i])) || (is_altered(&x.t.program, &x.t.shown[i]) && !equal_still(&x, i));
        for (int link = i; !speaks && lines && t->shown[link].offset > 0; link--)
            speaks = !equal_still(&x, link - 1);
    }
    altered_close(&x);
    free(all);
    return speaks ? NULL : &t->shown[i - 1];
}

const struct equality *identities_tautology(const struct identities *t)
{
    return first_tautology(t, false);
}

static bool no_tautology(struct table *table)
{
    const struct equality *empty = first_tautology(&table->s->corrected, false);
    if (empty == NULL && table->s->line_map != NULL)
        empty = first_tautology(&table->s->lines, true);
    return empty == NULL ||
           BINDING_FAULT(table, empty->at, empty->offset, "%s holds whatever the formulas are: it shows nothing", empty->text);
}

/* ---- from ---- */

static bool all_used(struct table *table)
{
    if (table->s->from_count == 0)
        return BINDING_FAULT(table, table->s->node, 0, "expected an equation or a %s in 'from'", "principle");
    for (int i = 0; i < table->s->from_count; i++)
        if (!breaks_by_entry(table, table->s->from[i]))
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
    struct identities t = {.order = -1};
    struct run r;
    int *map = xrealloc(NULL, (size_t)p->count, sizeof *map);
    for (int i = 0; i < p->count; i++)
        map[i] = i < p->inputs ? i : -1;
    program_copy(&t.program, p);
    const int changed = alteration_copy(&t.program, p, wanted, &(struct alteration){.change = change, .node = node}, 0, map);
    t.variables = xrealloc(NULL, (size_t)p->inputs + 1, sizeof *t.variables);
    for (int i = 0; i < p->inputs; i++)
        t.variables[i] = (struct variable){.signs = SIGN_ANY};
    run_begin(&r, &t, 1, RUN_LOOSE, 0);
    const bool same = run_compare(&r, wanted, changed) == IDENTITY_HOLDS;
    run_end(&r);
    identities_clear(&t);
    free(map);
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
    char *spoken = nodes_spoken_of(table, p, wanted);
    const char *silent = NULL;
    for (int node = 0; node <= wanted; node++)
        for (enum change change = CHANGE_SIGN; change < CHANGES && spoken[node] && silent == NULL; change++) {
            struct node n = p->nodes[node];
            int instead;
            if (!change_node(&n, change, &instead))
                continue;
            table->b->mutants++;
            if (!breaks_by_part(table, part, change, node) && !is_equivalent(p, wanted, change, node))
                silent = change_names[change];
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
    if (!breaks_by_part(table, part, CHANGE_ANY, -1))
        return BINDING_FAULT(table, item(table, "to", to), 0, "%s stands in no equality%s", part->name,
                             side ? " as a whole: a side is not shown" : "");
    if (!side && !breaks_by_part(table, part, CHANGE_RESULT, -1) && part->equation != NULL &&
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
    struct table table = {.d = d, .s = s, .b = b, .uses = xrealloc(NULL, (size_t)s->corrected.use_count + 1, sizeof *table.uses)};
    *b = (struct binding){.mutants = 0};
    if (no_tautology(&table) && nothing_beyond(&table) && all_used(&table) && all_shown(&table))
        all_wanted(&table);
    free(table.uses);
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
