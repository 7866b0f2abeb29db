#include "conform/diagnosis.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "conform/kinds.h"
#include "evaluate/reference.h"
#include "evaluate/sample.h"
#include "evaluate/vectors.h"
#include "formula/exact.h"
#include "sheet/known_mistakes.h"
#include "text/scope.h"

/* ---- mistakes at work ---- */

struct mutant {
    const char *name;
    bool transforms;       /* the operation is done right, but on other inputs */
    struct mutation a;
    struct operation o;
    struct input *inputs;  /* those others */
    int killed;            /* by so many vectors                        */
    bool differs;          /* else so small a difference does no harm   */
};

/* A known mistake of a section, or its print's own formulas (NULL); false where it cannot be made there. */
static bool mutant_init(struct mutant *x, const struct section *s, const struct known_mistake *m)
{
    struct message why;
    *x = (struct mutant){.name = m != NULL ? m->name : "as printed"};
    if (m == NULL ? !s->differs : !mutation_init(&x->a, s->sheet, s, m, false, &why))
        return false;
    x->transforms = m != NULL && !x->a.formulas_end;
    x->inputs = inputs_new(MOST_INPUTS);
    operation_init(&x->o, x->transforms ? x->a.section : s, m == NULL);
    if (m == NULL || x->transforms)
        return true;
    operation_clear(&x->o);
    x->o.formulas = &x->a.formulas;
    machine_init(&x->o.machine, &x->a.formulas.program, &arithmetic_ball, 128);
    return true;
}

static void mutant_clear(struct mutant *x)
{
    operation_clear(&x->o);
    inputs_free(x->inputs, MOST_INPUTS);
    if (x->a.section != NULL)
        mutation_clear(&x->a);
}

/* Of so many in all the one at a place: NULL for the print, then the section's own, then those that every section may make. */
static int mistake_count(const struct section *s)
{
    return 1 + s->mistake_count + s->sheet->mistake_count;
}

static const struct known_mistake *mistake_at(const struct section *s, int k)
{
    return k == 0 ? NULL : k <= s->mistake_count ? &s->mistakes[k - 1] : &s->sheet->mistakes[k - 1 - s->mistake_count];
}

/* The inputs that the operation is done on; NULL where they have no exact value. */
static const struct input *inputs_of(struct mutant *x, const struct input *inputs)
{
    if (!x->transforms)
        return inputs;
    struct operation transformation = {.section = x->a.section, .formulas = &x->a.formulas};
    OWNED(machine) values;
    bool rational = true;
    operation_exact(&values, &transformation, inputs);
    for (int i = 0; i < x->a.section->input_count; i++) {
        rational = rational && exact_is_rational(&x->inputs[i].value, machine_value(&values, x->a.formulas.outputs[i]));
        x->inputs[i].infinite = false;
    }
    return rational ? x->inputs : NULL;
}

/* After so many hours a motion tells no other mistakes; such vectors show what errors grow to. */
static bool is_longer(const struct section *s, const struct input *inputs, double hours)
{
    return is_motion(s) && fabs(fmpq_get_d(&inputs[input_place(s, "t")].value)) > 3600.0 * hours;
}

/* ---- diagnosis ---- */

/* Seconds of processor time for an operation. */
static const double PATIENCE = 1.0;

/* Failures of these outcomes. */
static uint64_t failures(const struct summary *t, enum outcome first, enum outcome last)
{
    uint64_t count = 0;
    for (enum outcome i = first; i <= last; i++)
        count += t->counts[i];
    return count;
}

/*
 * What was answered, with the truth as ref/ has it. What is to be refused may speak only where the domain is all that fails: else a
 * client may check it first.
 */
static void gather(struct evidence *v, struct test_run *e, int set, bool domain)
{
    const struct summary *t = &e->summaries[set];
    struct operation *o = e->comparators[set].operation;
    const struct section *s = o->section;
    TEST_VECTOR(q);
    VECTOR(arb, S, MOST_OUTPUTS);
    *v = (struct evidence){.section = s, .until = clock() + (clock_t)(PATIENCE * CLOCKS_PER_SEC), .digits = e->comparators[set].digits};
    for (int i = 0; i < t->kept_count; i++) {
        const struct record *r = &t->kept[i];
        const int f = v->count;
        test_vector_make(&q, &e->sets, r->position);
        input_values(s, q.inputs, v->x[f]);
        v->x[f][0] = q.numbers ? v->x[f][0] : NAN;
        reference_find(s->id)(v->x[f], v->exact[f]);
        const bool outside = isnan(v->exact[f][0]);
        if (r->outcome > (domain ? OUTCOME_VALUE : OUTCOME_INVALID) || (outside && !domain) || (!outside && is_longer(s, q.inputs, 12.0)))
            continue;
        if (!outside && !is_motion(s))
            operation_sensitivity(o, q.inputs, 128, S);
        for (int k = 0; k < s->output_count; k++)
            v->y[f][k] = r->has_values && (r->outcome <= OUTCOME_WRONG || r->outcome == OUTCOME_VALUE) ? r->values[k] : NAN;
        for (int k = 0; k < s->output_count; k++)
            v->tolerance[f][k] = tolerance_of(v, f, k, arf_get_d(arb_midref(S + k), ARF_RND_NEAR), e->significand);
        v->failing += r->outcome != OUTCOME_RIGHT;
        v->records[v->count++] = r;
    }
}

/* Whether the mutant makes of all inputs what was answered. */
static bool explains(struct mutant *x, const struct evidence *v)
{
    const struct section *s = v->section;
    bool all = true;
    INPUTS(inputs);
    VECTOR(arb, y, MOST_OUTPUTS);
    for (int f = 0; f < v->count && all; f++) {
        double made[MOST_OUTPUTS] = {NAN}, values[MOST_INPUTS];
        const struct input *done = inputs_of_values(s, v->x[f], inputs) ? inputs_of(x, inputs) : NULL;
        const bool inside = done != NULL && operation_valid(&x->o, done);
        if (inside && x->transforms) {
            input_values(x->o.section, done, values);
            reference_find(x->o.section->id)(values, made);
        } else if (inside) {
            operation_enclose(&x->o, done, 128, y);
            for (int k = 0; k < s->output_count; k++)
                made[k] = arb_is_finite(y + k) ? arf_get_d(arb_midref(y + k), ARF_RND_NEAR) : NAN;
        }
        all = is_answer(v, f, made);
    }
    return all;
}

/* Says so where that mistake (NULL: the print) explains all. */
static void try_mistake(const struct evidence *v, const struct known_mistake *m, char *text, size_t size)
{
    struct mutant x;
    if (!mutant_init(&x, v->section, m))
        return;
    if (explains(&x, v)) {
        add_text(text, size, "; or ", m != NULL ? "a known mistake: " : "the paper's misprint: ");
        add_text(text, size, "", m != NULL ? m->name : v->section->reason);
    }
    mutant_clear(&x);
}

void diagnose(struct test_run *e, int set)
{
    struct summary *t = &e->summaries[set];
    const bool domain = failures(t, OUTCOME_WRONG, OUTCOME_INVALID) == 0 && t->counts[OUTCOME_VALUE] > 0; /* no more is wrong */
    const bool nan = t->nans > 0 && t->nans == t->counts[OUTCOME_VALUE]; /* the word is missing, and not the check */
    struct evidence *v = xrealloc(NULL, 1, sizeof *v);
    gather(v, e, set, domain);
    for (int k = 0; k < mistake_count(v->section) && v->failing > 1 && !(nan && domain); k++)
        try_mistake(v, mistake_at(v->section, k), t->diagnosis, sizeof t->diagnosis);
    if (t->diagnosis[0] == '\0' && v->failing > 1 && !domain)
        (is_motion(v->section) ? kind_of_motion : kind_of_formula)(v, t->diagnosis, sizeof t->diagnosis);
    free(v);
    if (nan)
        add_text(t->diagnosis, sizeof t->diagnosis, "; and ", "nan where `invalid` is due");
    else if (t->counts[OUTCOME_VALUE] > 1 && t->counts[OUTCOME_INVALID] == 0 && (!domain || t->diagnosis[0] == '\0'))
        add_text(t->diagnosis, sizeof t->diagnosis, "; and ", "not all inputs outside the domain are refused");
}

/* ---- the kill table ---- */

struct kills {
    struct mutant *mutants;
    int count;
    struct comparator *comparator;
    struct input *inputs;
    bool fine;
};

/* Whether a vector tells a mutant from the truth. */
static bool mistake_told(struct kills *k, int i, bool inside)
{
    struct mutant *x = &k->mutants[i];
    struct comparator *j = k->comparator;
    const struct section *s = j->operation->section;
    const struct input *inputs = inputs_of(x, k->inputs);
    struct score score;
    if (inputs == NULL || operation_valid(&x->o, inputs) != inside)
        return inside || inputs != NULL;
    if (!inside)
        return false;
    const slong digits = is_motion(s) ? (slong)j->digits + 8 : 60;
    const slong prec = operation_precision(&x->o, inputs, digits);
    if (operation_follow(&x->o, inputs, digits, prec, j->y) != OPERATION_PROVED)
        return true;
    const enum outcome outcome = compare_answer(j, k->inputs, &score);
    j->followed = outcome != OUTCOME_SKIPPED; /* the next mutant is held against the same motion */
    for (int n = 0; n < s->output_count; n++)
        x->differs = x->differs || !arb_overlaps(j->exact + n, j->y + n);
    return outcome == OUTCOME_WRONG;
}

static bool pins_an_edge(const char *flags)
{
    static const char *const edges[] = {"edge", "zero", "sign", "large", "small", "cancellation", "paper"};
    bool pins = false;
    for (size_t i = 0; i < sizeof edges / sizeof *edges; i++)
        pins = pins || strstr(flags, edges[i]) != NULL;
    return pins;
}

static bool print_kills(void *context, struct operation *o, const char *id, const char *const *texts, const char *flags)
{
    struct kills *k = context;
    const bool numbers = vector_read(o->section, texts, k->inputs);
    const bool inside = numbers && operation_valid(k->comparator->operation, k->inputs);
    int killed = 0;
    k->comparator->followed = false;
    if (inside && is_longer(o->section, k->inputs, 10.0))
        return true;
    for (int i = 0; i < k->count && numbers; i++)
        if (mistake_told(k, i, inside)) {
            fputs(killed == 0 ? id : "", stdout);
            printf("%s%s", killed == 0 ? "," : "; ", k->mutants[i].name);
            k->mutants[i].killed++;
            killed++;
        }
    if (killed > 0)
        putchar('\n');
    if (killed == 0 && inside && !pins_an_edge(flags)) {
        fprintf(stderr, "%s: kills no mistake and pins no edge\n", id);
        k->fine = false;
    }
    return true;
}

bool kills_print(const struct section *s, double digits)
{
    OPERATION(o, s);
    OWNED(comparator) comparator;
    INPUTS(inputs);
    struct kills k = {xrealloc(NULL, (size_t)mistake_count(s), sizeof *k.mutants), 0, &comparator, inputs, true};
    comparator_init(&comparator, &o, BINARY64, digits);
    for (int i = 0; i < mistake_count(s); i++)
        k.count += mutant_init(&k.mutants[k.count], s, mistake_at(s, i));
    golden_each(s, print_kills, &k);
    for (int i = 0; i < k.count; i++) {
        if (k.mutants[i].killed == 0 && k.mutants[i].differs) {
            fprintf(stderr, "%s: no golden vector kills the mistake: %s\n", s->id, k.mutants[i].name);
            k.fine = false;
        }
        mutant_clear(&k.mutants[i]);
    }
    free(k.mutants);
    return k.fine;
}
