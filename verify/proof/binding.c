/* What binds a step to the equations that it leads from and to: tried, by altering their formulas. */
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "proof/derivation.h"

#include "text/scope.h"

/* ---- what `from` and `to` name ---- */

static bool is_number_of(const char *entry, const char *equation)
{
    const size_t length = strlen(entry);
    return equation != NULL && strncmp(entry, equation, length) == 0 && (equation[length] < '0' || equation[length] > '9');
}

/* The number that an output has: those that no relation has are dealt out to the outputs in turn. */
static const char *equation_of(const struct section *s, int output)
{
    const char *own[8];
    int count = 0;
    for (int i = 0; i < s->numbers; i++) {
        bool taken = false;
        for (int k = 0; k < s->relation_count; k++)
            taken = taken || strcmp(s->relations[k].equation, s->equations[i]) == 0;
        if (!taken)
            own[count++] = s->equations[i];
    }
    return s->numbers == 0 ? NULL : count > 0 ? own[output % count] : s->equations[output % s->numbers];
}

/* "eq10lin", "eq02.x1_ddot", the id of a definition: the section, and what stands after the point, NULL: nothing. */
static const struct section *section_of_entry(const struct derivations *d, const char *entry, const char **name)
{
    const size_t length = strcspn(entry, ".");
    const struct section *found = NULL;
    *name = entry[length] == '.' ? entry + length + 1 : NULL;
    for (int i = 0; i < d->definitions.count + d->sheet->section_count; i++) {
        const struct section *s = i < d->definitions.count ? &d->definitions.sections[i]
                                                           : &d->sheet->sections[i - d->definitions.count];
        if (found == NULL && strlen(s->id) == length && strncmp(s->id, entry, length) == 0)
            found = s;
    }
    return found;
}

static void add_outputs(const struct section *s, const char *number, const char *name, struct entry_part *parts, int *count)
{
    for (int i = 0; i < s->output_count && s->method == METHOD_FORMULA && *count < MOST_PARTS; i++) {
        const char *equation = equation_of(s, i);
        if ((number == NULL || is_number_of(number, equation)) && (name == NULL || strcmp(name, s->outputs[i]->name) == 0))
            parts[(*count)++] = (struct entry_part){s, NULL, s->corrected.outputs[i], s->outputs[i]->name, equation};
    }
}

int entry_parts(const struct derivations *d, const char *entry, struct entry_part *parts)
{
    const char *name;
    const struct section *section = section_of_entry(d, entry, &name);
    int count = 0;
    if (section != NULL)
        add_outputs(section, NULL, name, parts, &count);
    if (section != NULL && section->method == METHOD_FORMULA && count == 0 && name != NULL) {
        const int node = program_find(&section->corrected.program, name);
        if (node >= section->corrected.program.inputs)
            parts[count++] = (struct entry_part){section, NULL, node, name, equation_of(section, 0)};
    }
    for (int i = 0; i < d->sheet->section_count && section == NULL; i++) {
        const struct section *s = &d->sheet->sections[i];
        add_outputs(s, entry, NULL, parts, &count);
        for (int k = 0; k < s->relation_count && count < MOST_PARTS; k++)
            if (is_number_of(entry, s->relations[k].equation))
                parts[count++] = (struct entry_part){s, &s->relations[k], -1, s->relations[k].text, s->relations[k].equation};
    }
    return count;
}

bool same_part(const struct entry_part *a, const struct entry_part *b)
{
    return a->section == b->section && a->relation == b->relation && a->node == b->node;
}

bool entry_concerns(const struct derivations *d, const char *entry, const struct use *u)
{
    const char *name;
    const struct section *section = section_of_entry(d, entry, &name);
    int output = -1;
    for (int i = 0; u->relation == NULL && i < u->section->output_count; i++)
        output = u->formulas->outputs[i] == u->part ? i : output;
    if (section != NULL && name == NULL)
        return section == u->section;
    if (section != NULL)
        return section == u->section && u->relation == NULL &&
               (output >= 0 ? strcmp(section->outputs[output]->name, name) == 0
                            : program_find(&u->formulas->program, name) == u->part);
    if (u->relation != NULL)
        return is_number_of(entry, u->relation->equation);
    bool any = false;
    for (int i = 0; i < u->section->numbers && output < 0; i++)
        any = any || is_number_of(entry, u->section->equations[i]);
    return any || (output >= 0 && u->section->numbers > 0 && is_number_of(entry, equation_of(u->section, output)));
}

bool entry_leads_to(const struct derivations *d, const char *entry, const char *equation)
{
    struct entry_part parts[MOST_PARTS];
    const int count = entry_parts(d, entry, parts);
    for (int i = 0; i < count; i++) {
        const struct section *s = parts[i].section;
        bool output = parts[i].relation != NULL, leads = false;
        for (int k = 0; k < s->output_count; k++)
            output = output || strcmp(s->outputs[k]->name, parts[i].name) == 0;
        for (int k = 0; k < s->numbers; k++) /* a named subexpression is of all the section's equations */
            leads = leads || strcmp(output ? parts[i].equation : s->equations[k], equation) == 0;
        if (leads)
            return true;
    }
    return false;
}

/* ---- alterations ---- */

/* Which equalities a row of the table breaks: a mutant, or an entry of `from`. */
struct table {
    const struct derivations *d;
    const struct step *s;
    struct binding *b;
    bool alone[MOST_SHOWN]; /* it alone breaks by something: the step needs it */
};

struct target {
    const struct derivations *d;
    const char *entry; /* NULL: the section, or the relation's side, or everything where both are NULL */
    const struct section *section;
    const struct relation *relation;
    int side, part; /* part: where the alteration is that of a result; -1: of a formula */
};

static bool concerns(const void *context, const struct use *u)
{
    const struct target *t = context;
    if (t->entry != NULL)
        return entry_concerns(t->d, t->entry, u);
    if (t->relation != NULL)
        return u->relation == t->relation && u->part == t->side;
    if (t->section != NULL)
        return u->relation == NULL && u->section == t->section && u->formulas == &t->section->corrected &&
               (t->part < 0 || u->part == t->part);
    return true;
}

/* How many equalities hold as altered; holds[] is left as it is where they cannot be read, as no steps are then. */
static int broken(const struct table *table, enum change change, const struct target *target, int node, bool holds[])
{
    const struct alteration a = {.change = change, .concerns = concerns, .context = target, .node = node};
    struct identities t;
    int count = 0;
    if (step_read_altered(&t, table->d, table->s, &a))
        count = identities_broken(&t, change == CHANGE_ANY, holds);
    identities_clear(&t);
    return count;
}

/* The same, and where one alone does not hold, the step needs it. */
static int tried(struct table *table, enum change change, const struct target *target, int node)
{
    bool holds[MOST_SHOWN];
    const int count = broken(table, change, target, node, holds);
    for (int i = 0; i < table->s->corrected.shown_count && count == 1; i++)
        table->alone[i] = table->alone[i] || !holds[i];
    return count;
}

static bool refuse(const struct table *table, const yaml_node_t *at, const char *format, ...)
{
    struct document document = table->d->document;
    char text[300];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    document.why = &table->b->fault;
    return parse_error(&document, at, 0, "step %s: %s", table->s->id, text);
}

static const yaml_node_t *item(const struct table *table, const char *key, int i)
{
    const struct document *document = &table->d->document;
    return item_of(document, child(document, table->s->node, key), i);
}

/* ---- no equality holds for any formulas ---- */

static bool no_tautology(struct table *table)
{
    const struct identities *t = &table->s->corrected;
    const struct target everything = {.part = -1};
    bool holds[MOST_SHOWN] = {false};
    broken(table, CHANGE_ANY, &everything, -1, holds);
    for (int i = 0; i < t->shown_count; i++)
        if (holds[i])
            return refuse(table, t->shown[i].at, "%s holds whatever the formulas are: it shows nothing", t->shown[i].text);
    return true;
}

/* ---- from ---- */

static bool all_used(struct table *table)
{
    if (table->s->from_count == 0)
        return refuse(table, table->s->node, "expected an equation or a principle in 'from'");
    for (int i = 0; i < table->s->from_count; i++) {
        const struct target from = {.d = table->d, .entry = table->s->from[i]};
        if (tried(table, CHANGE_ANY, &from, -1) == 0)
            return refuse(table, item(table, "from", i), "'%s' is not used: any formula in its place would do", table->s->from[i]);
    }
    return true;
}

static bool is_named(const struct table *table, const struct use *u)
{
    const struct step *s = table->s;
    const yaml_node_t *also = child(&table->d->document, s->node, "also");
    for (int i = 0; i < s->from_count + s->to_count; i++)
        if (entry_concerns(table->d, i < s->from_count ? s->from[i] : s->to[i - s->from_count], u))
            return true;
    for (int i = 0; also != NULL && i < length_of(also); i++)
        if (entry_concerns(table->d, scalar(key_of(&table->d->document, also, i)), u))
            return true;
    return false;
}

static bool nothing_beyond(struct table *table)
{
    const struct identities *t = &table->s->corrected;
    for (int i = 0; i < t->use_count; i++) {
        const struct use *u = &t->uses[i];
        if (!is_named(table, u))
            return refuse(table, table->s->node, "it rests on %s%s, which neither from nor to names, nor also with a reason",
                          u->relation ? "a relation of " : "", u->section->id);
    }
    const yaml_node_t *also = child(&table->d->document, table->s->node, "also");
    for (int i = 0; also != NULL && i < length_of(also); i++) {
        const yaml_node_t *key = key_of(&table->d->document, also, i);
        bool used = false;
        for (int k = 0; k < t->use_count; k++)
            used = used || entry_concerns(table->d, scalar(key), &t->uses[k]);
        if (!used)
            return refuse(table, key, "'%s' is not used", scalar(key));
    }
    return true;
}

/* ---- for which values ---- */

/* Numbers at which nothing here happens to vanish: 1 + 1/2, 1 + 1/3 ... of any domain, and within a quarter turn. */
static void set_point(struct machine *m, const struct identities *t)
{
    for (int i = 0; i < t->program.inputs; i++) {
        arb_ptr x = machine_value(m, i);
        arb_set_ui(x, 1);
        arb_div_ui(x, x, (ulong)i % 23 + 2, m->prec);
        if (!t->variables[i].angle && t->variables[i].power == 0)
            arb_add_ui(x, x, 1, m->prec);
    }
}

/*
 * Whether what a formula's inputs are bound to fills an open set: their derivatives by the free quantities are
 * independent at a point, J J^T having a determinant other than zero there, in balls. An equality of analytic
 * functions on an open set is one everywhere.
 */
static bool fills_open_set(const struct identities *t, const struct use *u)
{
    enum { BITS = 256 };
    const struct program *p = &u->formulas->program;
    char *needed = xrealloc(NULL, (size_t)p->count, 1);
    slong rows[MOST_BOUND], count = 0;
    struct machine m, adjoint;
    arb_mat_t J, transposed, square;
    SCOPE(arb, determinant);
    program_needs(p, u->part, NULL, needed);
    for (int i = 0; i < p->inputs && i <= u->part && i < MOST_BOUND; i++)
        if (needed[i])
            rows[count++] = u->bound[i];
    machine_init(&m, &t->program, &arithmetic_ball, BITS);
    machine_init(&adjoint, &t->program, &arithmetic_ball, BITS);
    arb_mat_init(J, count, t->program.inputs);
    arb_mat_init(transposed, t->program.inputs, count);
    arb_mat_init(square, count, count);
    set_point(&m, t);
    machine_run(&m);
    for (slong i = 0; i < count; i++) {
        machine_gradient(&m, (int)rows[i], &adjoint);
        for (slong k = 0; k < t->program.inputs; k++)
            arb_set(arb_mat_entry(J, i, k), machine_value(&adjoint, (int)k));
    }
    arb_mat_transpose(transposed, J);
    arb_mat_mul(square, J, transposed, BITS);
    arb_mat_det(determinant, square, BITS);
    const bool fills = arb_is_finite(determinant) && !arb_contains_zero(determinant);
    arb_mat_clear(J);
    arb_mat_clear(transposed);
    arb_mat_clear(square);
    machine_clear(&m);
    machine_clear(&adjoint);
    free(needed);
    return fills;
}

/* An output is shown for all values of its inputs, not for some alone; or the step says where. */
static bool is_general(struct table *table, int to, const struct entry_part *part)
{
    const struct identities *t = &table->s->corrected;
    bool general = table->s->where != NULL;
    for (int i = 0; i < t->use_count && !general; i++)
        general = t->uses[i].section == part->section && t->uses[i].relation == NULL &&
                  t->uses[i].formulas == &part->section->corrected && t->uses[i].part == part->node &&
                  fills_open_set(t, &t->uses[i]);
    return general || refuse(table, item(table, "to", to),
                             "%s is shown for some values of its inputs alone, expected free ones, or 'where' to say which",
                             part->name);
}

/* ---- to ---- */

/* Whether the changed formula is the same function: then no step can tell. */
static bool is_equivalent(const struct program *p, int wanted, enum change change, int node)
{
    struct program both, altered;
    int *stand_in = xrealloc(NULL, (size_t)p->count, sizeof *stand_in);
    program_copy(&both, p);
    program_copy(&altered, p);
    for (int i = 0; i < p->count; i++)
        stand_in[i] = i < p->inputs ? i : -1;
    const int other = program_inline(&both, &altered, alteration_make(&altered, change, node, wanted), stand_in);
    const bool same = nodes_equal(&both, wanted, other);
    program_clear(&both);
    program_clear(&altered);
    free(stand_in);
    return same;
}

static bool is_zero(const struct program *p, int node)
{
    struct program copy;
    program_copy(&copy, p);
    const int zero = program_append(&copy, OPERATOR_NUMBER, -1, -1, 0);
    const bool same = nodes_equal(&copy, node, zero);
    program_clear(&copy);
    return same;
}

/* The nodes of a formula that a step speaks of: not those below a named subexpression that it leaves open. */
static char *nodes_spoken_of(const struct table *table, const struct program *p, int wanted)
{
    const struct program *own = &table->s->corrected.program;
    int *open = xrealloc(NULL, (size_t)p->count, sizeof *open);
    char *spoken = xrealloc(NULL, (size_t)p->count, 1);
    for (int i = 0; i < p->count; i++)
        open[i] = i < p->inputs ? 0 : -1;
    for (int i = 0; i < p->named; i++) {
        const int here = program_find(own, p->names[i].text);
        if (here >= table->d->sheet->quantity_count && here < own->inputs)
            open[p->names[i].node] = 0;
    }
    program_needs(p, wanted, open, spoken);
    for (int i = 0; i <= wanted; i++)
        spoken[i] = spoken[i] && open[i] < 0;
    free(open);
    return spoken;
}

static const char *const changes[CHANGES] = {[CHANGE_RESULT] = "its sign",
                                             [CHANGE_SIGN] = "a sign",
                                             [CHANGE_LEFT] = "a right factor or term dropped",
                                             [CHANGE_RIGHT] = "a left factor or term dropped",
                                             [CHANGE_NUMBER] = "a number or exponent"};

/* Every change of every node of the formula breaks an equality, or nothing would tell. */
static bool all_changes_tell(struct table *table, int to, const struct entry_part *part, const struct program *p, int wanted,
                             struct target target)
{
    char *spoken = nodes_spoken_of(table, p, wanted);
    bool tell = true;
    for (int node = 0; node <= wanted && tell; node++)
        for (enum change change = CHANGE_SIGN; change < CHANGES && spoken[node] && tell; change++) {
            if (!alteration_applies(p, change, node))
                continue;
            table->b->mutants++;
            if (tried(table, change, &target, node) == 0 && !is_equivalent(p, wanted, change, node))
                tell = refuse(table, item(table, "to", to), "%s may be altered (%s) and every equality holds still",
                              part->name, changes[change]);
        }
    free(spoken);
    return tell;
}

static bool relation_is_bound(struct table *table, int to, const struct entry_part *part)
{
    bool bound = true;
    for (int side = 0; side < 2 && bound; side++) {
        struct program p;
        const struct target target = {.relation = part->relation, .side = side};
        const int wanted = relation_program(&p, table->d->sheet, part->relation, side == 1);
        bound = tried(table, CHANGE_ANY, &target, -1) > 0 ||
                refuse(table, item(table, "to", to), "%s stands in no equality as a whole: a side is not shown", part->name);
        bound = bound && all_changes_tell(table, to, part, &p, wanted, target);
        program_clear(&p);
    }
    return bound;
}

static bool output_is_bound(struct table *table, int to, const struct entry_part *part)
{
    const struct target result = {.section = part->section, .part = part->node};
    const struct target formula = {.section = part->section, .part = -1};
    const struct program *p = &part->section->corrected.program;
    if (tried(table, CHANGE_ANY, &result, -1) == 0)
        return refuse(table, item(table, "to", to), "%s stands in no equality", part->name);
    if (tried(table, CHANGE_RESULT, &result, -1) == 0 && part->equation != NULL && !is_zero(p, part->node))
        return refuse(table, item(table, "to", to), "%s may have the other sign and every equality holds still", part->name);
    if (part->equation == NULL) /* the formula of a property says what is shown, and claims nothing */
        return true;
    return is_general(table, to, part) && all_changes_tell(table, to, part, p, part->node, formula);
}

/* What a step starts from it cannot lead to. */
static bool is_new(struct table *table, int to, const struct entry_part *part)
{
    struct entry_part from[MOST_PARTS];
    for (int i = 0; i < table->s->from_count; i++) {
        const int count = entry_parts(table->d, table->s->from[i], from);
        for (int k = 0; k < count; k++)
            if (same_part(&from[k], part))
                return refuse(table, item(table, "to", to), "%s is in from already", part->name);
    }
    return true;
}

static bool all_shown(struct table *table)
{
    if (table->s->to_count == 0)
        return refuse(table, table->s->node, "expected an equation or a property in 'to'");
    for (int i = 0; i < table->s->to_count; i++) {
        struct entry_part parts[MOST_PARTS];
        const int count = entry_parts(table->d, table->s->to[i], parts);
        for (int k = 0; k < count; k++)
            if (!is_new(table, i, &parts[k]) ||
                !(parts[k].relation != NULL ? relation_is_bound : output_is_bound)(table, i, &parts[k]))
                return false;
    }
    return true;
}

/* ---- no equality can be left out ---- */

/* A name that one equality alone rests on. */
static void note_names(struct table *table)
{
    const struct identities *t = &table->s->corrected;
    const struct program *p = &t->program;
    char *left = xrealloc(NULL, (size_t)p->count, 1), *right = xrealloc(NULL, (size_t)p->count, 1);
    for (int i = p->inputs; i < p->named; i++) {
        const int node = p->names[i].node;
        int count = 0, last = -1;
        for (int e = 0; e < t->shown_count; e++) {
            const struct equality *shown = &t->shown[e];
            program_needs(p, shown->left, NULL, left);
            program_needs(p, shown->right, NULL, right);
            if ((node <= shown->left && left[node]) || (node <= shown->right && right[node])) {
                count++;
                last = e;
            }
        }
        if (count == 1)
            table->alone[last] = true;
    }
    free(left);
    free(right);
}

static bool all_wanted(struct table *table)
{
    const struct identities *t = &table->s->corrected;
    note_names(table);
    for (int i = 0; i < t->shown_count; i++)
        if (!table->alone[i])
            return refuse(table, t->shown[i].at, "%s could be left out: nothing in from and to needs it", t->shown[i].text);
    return true;
}

void step_bind(const struct derivations *d, const struct step *s, struct binding *b)
{
    struct table table = {.d = d, .s = s, .b = b};
    *b = (struct binding){.mutants = 0};
    if (no_tautology(&table) && nothing_beyond(&table) && all_used(&table) && all_shown(&table))
        all_wanted(&table);
}
