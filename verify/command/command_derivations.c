/* coulomb-tether verify derivations: the steps, each with its proof and what binds it. */
#include "command/command_verify.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "command/command.h"

/* Blank-separated, padded to a width; "-" where there is nothing. */
static void print_list(const char *const *texts, int count, int width)
{
    width -= count == 0 ? printf("-") : 0;
    for (int i = 0; i < count; i++)
        width -= printf("%s%s", i ? " " : "", texts[i]);
    printf("%*s", width > 0 ? width : 0, "");
}

static const char *derivation_fault(const struct proof_results *p, int i)
{
    return p->bindings != NULL && p->bindings[i].fault.text[0] != '\0' ? p->bindings[i].fault.text : NULL;
}

/* NAME = VALUE, or NAME LOW ... HIGH: the states that a bound is proved on. */
static void print_states(FILE *out, const struct document *d, const yaml_node_t *on)
{
    for (int i = 0; i < length_of(on); i++) {
        const yaml_node_t *range = value_of(d, on, i);
        fprintf(out, "%s%s ", i ? ", " : "", scalar(key_of(d, on, i)));
        if (scalar(range) != NULL)
            fprintf(out, "= %s", scalar(range));
        else
            fprintf(out, "%s ... %s", scalar(item_of(d, range, 0)), scalar(item_of(d, range, 1)));
    }
}

static void print_remainder(const struct document *d, const struct remainder *r, const struct remainder_proof *proof)
{
    static const char *const states[] = {[REMAINDER_PROVED] = "certified",
                                         [REMAINDER_EXCEEDED] = "BROKEN: it is exceeded",
                                         [REMAINDER_TOO_WIDE] = "BROKEN: more than twice too wide",
                                         [REMAINDER_UNDECIDED] = "BROKEN: not proved"};
    printf("    (%s) drops at most %s %s: %s with %d boxes, %d %% of it reached, on ", r->equation, r->at_most, r->unit,
           states[proof->state], proof->boxes, proof->percent);
    print_states(stdout, d, r->on);
    putchar('\n');
}

/* Where a step breaks: at the first equality that does not hold, if that is what the evidence is of, else at the step. */
static void print_broken(const struct derivations *d, const struct step *s, const struct proof *proof)
{
    const struct identities *t = &s->corrected;
    struct message place;
    struct document document = d->document;
    const yaml_node_t *at = s->node;
    for (int i = t->shown_count - 1; i >= 0; i--)
        if (!proof->holds[i] && strncmp(proof->evidence, t->shown[i].text, strlen(t->shown[i].text)) == 0)
            at = t->shown[i].at;
    document.why = &place;
    parse_error(&document, at, 0, "%s", "");
    printf("    BROKEN: %s%s\n", place.text, proof->evidence);
}

static void print_step(const struct proof_results *p, int i)
{
    const struct step *s = &p->derivations.steps[i];
    const struct proof *proof = &p->corrected[i];
    char *domain = identities_domain(&s->corrected);
    printf("%-24s ", s->id);
    print_list(s->from, s->from_count, 26);
    printf(" -> ");
    print_list(s->to, s->to_count, 12);
    if (s->corrected.order < 0)
        printf("  exact  ");
    else
        printf("  order %d", s->corrected.order);
    printf("  for %s%s%s\n", domain, s->where ? "; " : "", s->where ? s->where : "");
    free(domain);
    if (proof->result != IDENTITY_HOLDS)
        print_broken(&p->derivations, s, proof);
    if (derivation_fault(p, i) != NULL)
        printf("    NOT BOUND: %s\n", derivation_fault(p, i));
    if (s->differs && p->printed[i].result == IDENTITY_DIFFERS)
        printf("    not as printed: %s\n", p->printed[i].evidence);
    else if (s->differs)
        printf("    BROKEN: expected to differ as printed: %s\n",
               p->printed[i].result == IDENTITY_HOLDS ? "it holds" : p->printed[i].evidence);
    for (int k = 0; k < s->remainder_count; k++)
        print_remainder(&p->derivations.document, &s->remainders[k], &p->remainders[i][k]);
}

/* The steps from first to end. */
static void table_proofs(const struct proof_results *p, int first, int end)
{
    int holding = 0;
    for (int i = first; i < end; i++) {
        print_step(p, i);
        holding += step_holds(p, i) && derivation_fault(p, i) == NULL;
    }
    printf("%d of %d steps hold, by normal forms\n", holding, end - first);
    if (p->bindings != NULL)
        printf("%d alterations of their equations were tried\n", p->mutants);
    if (p->gap != NULL)
        printf("equation %s is reached by no step, and is no definition\n", p->gap);
    else
        puts("every equation is reached from principles and definitions, or is a definition");
}

/* ---- the same as JSON ---- */

static void json_list(const char *key, const char *const *texts, int count)
{
    printf(", \"%s\": [", key);
    for (int i = 0; i < count; i++) {
        fputs(i ? ", " : "", stdout);
        json_text(texts[i]);
    }
    putchar(']');
}

static void json_member(const char *key, const char *text)
{
    if (text == NULL)
        return;
    printf(", \"%s\": ", key);
    json_text(text);
}

static void json_identities(const char *key, const struct identities *t, const struct proof *p)
{
    static const char *const results[] = {
        [IDENTITY_HOLDS] = "holds", [IDENTITY_DIFFERS] = "differs", [IDENTITY_UNDECIDED] = "undecided"};
    printf(",\n  \"%s\": {\"show\": [", key);
    for (int i = 0; i < t->shown_count; i++) {
        fputs(i ? ", " : "", stdout);
        json_text(t->shown[i].text);
    }
    printf("], \"finding\": \"%s\"", results[p->result]);
    json_member("evidence", p->evidence);
    json_member("difference", p->difference);
    putchar('}');
}

/* The free quantities that are small, or finite angles. */
static void json_variables(const char *key, const struct identities *t, bool small)
{
    const char *separator = "";
    printf(", \"%s\": [", key);
    for (int i = 0; i < t->program.inputs; i++) {
        const struct variable *v = &t->variables[i];
        if (!t->needed[i] || !(small ? v->power > 0 : v->angle))
            continue;
        printf("%s\"%s\"", separator, t->program.names[i].text);
        separator = ", ";
    }
    putchar(']');
}

/* All that the step's equations drop, as one text. */
static void json_dropped(const struct document *d, const struct step *s)
{
    char *text = NULL;
    size_t size;
    FILE *out = open_memstream(&text, &size);
    if (out == NULL)
        out_of_memory();
    for (int k = 0; k < s->remainder_count; k++) {
        const struct remainder *r = &s->remainders[k];
        fprintf(out, "%s(%s) drops at most %s %s for ", k > 0 ? "; " : "", r->equation, r->at_most, r->unit);
        print_states(out, d, r->on);
    }
    if (fclose(out) != 0)
        out_of_memory();
    json_member("dropped", s->remainder_count > 0 ? text : NULL);
    free(text);
}

static void json_step(const struct proof_results *p, int i)
{
    const struct step *s = &p->derivations.steps[i];
    char *domain = identities_domain(&s->corrected);
    printf("{\"id\": \"%s\", \"title\": ", s->id);
    json_text(s->title);
    json_list("from", s->from, s->from_count);
    json_list("to", s->to, s->to_count);
    if (s->corrected.order >= 0)
        printf(", \"order\": %d", s->corrected.order);
    json_variables("small", &s->corrected, true);
    json_variables("angles", &s->corrected, false);
    json_member("domain", domain);
    json_member("where", s->where);
    json_member("unbound", derivation_fault(p, i));
    free(domain);
    json_dropped(&p->derivations.document, s);
    printf(", \"let\": {");
    for (int k = 0; s->let != NULL && k < length_of(s->let); k++) {
        printf("%s\"%s\": ", k ? ", " : "", scalar(key_of(&p->derivations.document, s->let, k)));
        json_text(scalar(value_of(&p->derivations.document, s->let, k)));
    }
    putchar('}');
    json_identities("step", &s->corrected, &p->corrected[i]);
    if (s->differs)
        json_identities("printed", &s->printed, &p->printed[i]);
    putchar('}');
}

static void json_proofs(const struct proof_results *p, int first, int end)
{
    printf("{\"fine\": %s, \"steps\": [\n ", p->fine ? "true" : "false");
    for (int i = first; i < end; i++) {
        fputs(i > first ? ",\n " : "", stdout);
        json_step(p, i);
    }
    puts("]}");
}

bool print_proofs(const struct proof_results *p, const char *only, enum format format)
{
    const struct derivations *d = &p->derivations;
    const int first = only != NULL ? (int)(step_named(d, only) - d->steps) : 0;
    (format == FORMAT_JSON ? json_proofs : table_proofs)(p, first, only != NULL ? first + 1 : d->step_count);
    return p->fine;
}
