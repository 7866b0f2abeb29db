#include "conform/diagnosis.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "conform/kinds.h"
#include "evaluate/reference.h"
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

static const double SHORT = 10.0;

/* Beyond ten hours a motion tells the same mistakes at a higher price; such vectors show what errors grow to. */
static bool is_longer(const struct section *s, const struct input *inputs, double hours)
{
    return is_motion(s) && fabs(fmpq_get_d(&inputs[input_place(s, "t")].value)) > 3600.0 * hours;
}

/* ---- diagnosis ---- */

/* Seconds of processor time for an operation: for the known mistakes, and with what they leave for all. */
static const double PATIENCE_FOR_KNOWN = 0.7, PATIENCE = 1.0;

/* Whether the mutant makes of the question what was answered, or, where that is right, nothing that is wrong there. */
static bool explains(struct mutant *x, const struct test_run *e, const struct record *f, const struct test_vector *q,
                     double digits)
{
    struct score score;
    const struct input *inputs = q->numbers ? inputs_of(x, q->inputs) : NULL;
    const bool inside = inputs != NULL && operation_valid(&x->o, inputs);
    if (!f->has_values || !inside) /* `invalid` was said, or is due */
        return !f->has_values && !inside;
    OWNED(comparator) j;
    comparator_init(&j, &x->o, e->significand, digits);
    j.once = true; /* what is to explain the answer cannot need more than the truth */
    for (int i = 0; i < x->o.section->output_count; i++)
        arb_set_d(j.y + i, f->values[i]);
    if (f->outcome == OUTCOME_RIGHT)
        return compare_answer(&j, inputs, &score) != OUTCOME_WRONG;
    if (f->outcome == OUTCOME_WRONG || f->outcome == OUTCOME_VALUE)
        return compare_answer(&j, inputs, &score) == OUTCOME_RIGHT;
    return operation_enclose(&x->o, inputs, 128, j.exact) == OPERATION_PROVED &&
           !_arb_vec_is_finite(j.exact, x->o.section->output_count); /* no number there either */
}

/* Failures of these outcomes. */
static uint64_t failures(const struct summary *t, enum outcome first, enum outcome last)
{
    uint64_t count = 0;
    for (enum outcome i = first; i <= last; i++)
        count += t->counts[i];
    return count;
}

/* No more is wrong than that values stand where `invalid` is due. */
static bool is_domain_alone(const struct summary *t)
{
    return failures(t, OUTCOME_WRONG, OUTCOME_INVALID) == 0 && t->counts[OUTCOME_VALUE] > 0;
}

/* What is diagnosed: the failures of an operation, until a time. */
struct patient {
    const struct test_run *e;
    struct summary *t;
    const struct section *section;
    double digits; /* that a motion is due */
    clock_t until; /* of processor time    */
};

/*
 * All failures that formulas can explain, two at least, and nothing that passes speaks against it; what is refused may do so only where
 * the domain is all that fails: else a client may check it first. Of a motion the long ones are tried where no others fail.
 */
static bool explains_all(struct mutant *x, const struct patient *p)
{
    const struct summary *t = p->t;
    const bool domain = is_domain_alone(t);
    int explained = 0;
    bool all = true;
    TEST_VECTOR(q);
    for (int pass = 0; pass < 2 && explained == 0 && all; pass++)
        for (int i = 0; i < t->kept_count && all; i++) {
            const struct record *r = &t->kept[i];
            const bool right = r->outcome == OUTCOME_RIGHT;
            if (right ? !r->has_values && !domain : r->outcome > (domain ? OUTCOME_VALUE : OUTCOME_INVALID))
                continue;
            test_vector_make(&q, &p->e->sets, r->position);
            if ((pass == 0 || right) && q.numbers && is_longer(q.set->operation.section, q.inputs, SHORT))
                continue;
            all = clock() <= p->until && explains(x, p->e, r, &q, p->digits);
            explained += !right;
        }
    return all && explained > 1;
}

/* Says so where that mistake (NULL: the print) explains all. */
static void try_mistake(const struct patient *p, const struct known_mistake *m, const char *kind)
{
    struct mutant x;
    char *text = p->t->diagnosis;
    if (!mutant_init(&x, p->section, m))
        return;
    x.o.until = p->until;
    if (explains_all(&x, p)) {
        add_text(text, sizeof p->t->diagnosis, "; or ", kind);
        add_text(text, sizeof p->t->diagnosis, "", m != NULL ? m->name : p->section->reason);
    }
    mutant_clear(&x);
}

/* ---- what no sheet lists ---- */

/* What was answered in numbers, with the truth as ref/ has it: what failed, then what passes, of which the answer is as good. */
static void gather(struct evidence *v, const struct patient *p)
{
    struct operation *o = &p->e->sets.all[p->t - p->e->summaries].operation;
    const struct section *s = p->section;
    TEST_VECTOR(q);
    VECTOR(arb, S, MOST_OUTPUTS);
    *v = (struct evidence){.section = s, .until = p->until, .digits = p->digits};
    for (int i = 0; i < p->t->kept_count; i++) {
        const struct record *r = &p->t->kept[i];
        const bool right = r->outcome == OUTCOME_RIGHT && r->has_values;
        double *y = v->y[v->count], *exact = v->exact[v->count];
        test_vector_make(&q, &p->e->sets, r->position);
        if ((r->outcome != OUTCOME_WRONG && !right) || is_longer(s, q.inputs, 12.0))
            continue;
        for (int k = 0; k < s->input_count; k++)
            v->x[v->count][k] = q.inputs[k].infinite ? INFINITY : fmpq_get_d(&q.inputs[k].value);
        reference_find(s->id)(v->x[v->count], exact);
        memcpy(y, right && !is_motion(s) ? exact : r->values, sizeof v->y[0]); /* the same but for roundings */
        if (!is_motion(s))
            operation_sensitivity(o, q.inputs, 128, S);
        for (int k = 0; k < s->output_count; k++)
            v->tolerance[v->count][k] = alike_within(exact[k], arf_get_d(arb_midref(S + k), ARF_RND_NEAR), p->e->significand);
        v->records[v->count++] = r;
    }
}

static void diagnose_kind(const struct patient *p)
{
    struct evidence *v = xrealloc(NULL, 1, sizeof *v);
    gather(v, p);
    (is_motion(p->section) ? kind_of_motion : kind_of_formula)(v, p->t->diagnosis, sizeof p->t->diagnosis);
    free(v);
}

void diagnose(struct test_run *e, int set)
{
    struct summary *t = &e->summaries[set];
    const struct section *s = e->comparators[set].operation->section;
    const clock_t start = clock();
    struct patient p = {e, t, s, e->comparators[set].digits, start + (clock_t)(PATIENCE_FOR_KNOWN * CLOCKS_PER_SEC)};
    const bool nan = t->nans > 0 && t->nans == t->counts[OUTCOME_VALUE]; /* the word is missing, and not the check */
    const bool several = failures(t, OUTCOME_WRONG, OUTCOME_VALUE) > 1; /* one vector alone tells nothing */
    for (int k = 0; k < mistake_count(s) && several && !(nan && is_domain_alone(t)); k++)
        try_mistake(&p, mistake_at(s, k), k == 0 ? "the paper's misprint: " : "a known mistake: ");
    t->hurried = clock() > p.until;
    p.until = start + (clock_t)(PATIENCE * CLOCKS_PER_SEC);
    if (t->diagnosis[0] == '\0' && several)
        diagnose_kind(&p);
    if (nan)
        add_text(t->diagnosis, sizeof t->diagnosis, "; and ", "nan where `invalid` is due");
    else if (t->counts[OUTCOME_VALUE] > 1 && t->counts[OUTCOME_INVALID] == 0 && (!is_domain_alone(t) || t->diagnosis[0] == '\0'))
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
    if (inside && is_longer(o->section, k->inputs, SHORT))
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
