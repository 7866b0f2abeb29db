/* coulomb-tether verify derivations: the steps, each with its proof and what binds it. */
#include "command/command_verify.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "command/command.h"
#include "command/latex.h"
#include "text/json.h"

/* NAME = VALUE, or NAME LOW ... HIGH: the states that a bound is proved on. */
static void add_states(struct tex *t, const struct yaml *on)
{
    for (int i = 0; i < on->count; i++) {
        const struct yaml *range = &on->items[i];
        const bool fixed = range->text != NULL;
        tex_add(t, "%s%s %s%s%s", i ? ", " : "", range->key, fixed ? "= " : range->items[0].text, fixed ? "" : " ... ",
                fixed ? range->text : range->items[1].text);
    }
}

/* "BROKEN: file:line:column: " */
static void print_broken(const struct yaml *at, size_t offset)
{
    struct message place;
    node_message(&place, at, offset, "%s", "");
    printf("BROKEN: %s", place.text);
}

static void print_remainder(const struct remainder *r)
{
    const struct remainder_proof *proof = &r->proof;
    static const char *const states[] = {[REMAINDER_PROVED] = "certified",
                                         [REMAINDER_EXCEEDED] = "it is exceeded",
                                         [REMAINDER_TOO_WIDE] = "not found to be half reached",
                                         [REMAINDER_UNDECIDED] = "not proved"};
    struct tex t = {NULL, 0};
    printf("    (%s) drops at most %s %s: ", r->equation, r->at_most, r->unit);
    if (proof->state != REMAINDER_PROVED)
        print_broken(r->at, 0);
    add_states(&t, r->on);
    printf("%s with %d boxes, %d %% of it reached, on %s\n", states[proof->state], proof->boxes, proof->percent, t.text);
    tex_clear(&t);
}

static void print_fault(const struct proof *p)
{
    if (p->result == IDENTITY_HOLDS)
        return;
    printf("    ");
    print_broken(p->at, p->offset);
    puts(p->evidence);
}

static void print_step(const struct step *s)
{
    const struct proof *printed = &s->printed_proof;
    char *domain = identities_domain(&s->corrected);
    printf("%-24s ", s->id);
    print_list(s->from, s->from_count, 26);
    printf(" -> ");
    print_list(s->to, s->to_count, 12);
    if (s->corrected.order < 0)
        printf("  exact  ");
    else
        printf("  order %d", s->corrected.order);
    printf("  for %s\n", domain);
    free(domain);
    print_fault(&s->proof);
    print_fault(&s->line_proof);
    if (s->binding.fault.text[0] != '\0')
        printf("    NOT BOUND: %s\n", s->binding.fault.text);
    if (s->differs && printed->result == IDENTITY_DIFFERS) {
        printf("    not as printed: %s\n", printed->evidence);
    } else if (s->differs) {
        printf("    ");
        print_broken(printed->at ? printed->at : under(s->node, "printed"), 0);
        printf("expected to differ as printed: %s\n", printed->evidence ? printed->evidence : "it holds");
    }
    for (int k = 0; k < s->remainder_count; k++)
        print_remainder(&s->remainders[k]);
}

/* ---- the same as JSON ---- */

/* The sides of an equality, or of a chain of them. */
static void json_sides(struct json *j, const char *key, const struct step *s, const struct sheet *sheet, const char *text)
{
    json_open(j, key, '[');
    for (const char *end = side_end(text, "=");; text = end + 1, end = side_end(text, "=")) {
        struct tex t = {NULL, 0};
        char *side = text_copy(text);
        side[end - text] = '\0';
        typeset_side(&t, sheet, &s->corrected, side);
        json_string(j, NULL, t.text);
        tex_clear(&t);
        free(side);
        if (*end == '\0')
            break;
    }
    json_close(j);
}

static void json_identities(struct json *j, const char *key, const struct identities *t, const struct proof *p)
{
    static const char *const results[] = {
        [IDENTITY_HOLDS] = "holds", [IDENTITY_DIFFERS] = "differs", [IDENTITY_UNDECIDED] = "undecided"};
    json_line(j, 2);
    json_open(j, key, '{');
    json_open(j, "show", '[');
    for (int i = 0; i < t->shown_count; i++)
        json_string(j, NULL, t->shown[i].text);
    json_close(j);
    json_strings(j, "finding", results[p->result], "evidence", p->evidence);
    json_close(j);
}

/* The algebra by hand, in mathematics. */
static void json_by_hand(struct json *j, const struct step *s, const struct sheet *sheet)
{
    json_line(j, 2);
    json_open(j, "lines", '[');
    for (int i = 0; s->line_map != NULL && i < s->line_map->count; i++) {
        json_open(j, NULL, '{');
        json_string(j, "how", s->line_map->items[i].key);
        json_sides(j, "tex", s, sheet, s->line_map->items[i].text);
        json_close(j);
    }
    json_close(j);
}

/* All that the step's equations drop, as one text. */
static void json_dropped(struct json *j, const struct step *s)
{
    struct tex t = {NULL, 0};
    for (int k = 0; k < s->remainder_count; k++) {
        const struct remainder *r = &s->remainders[k];
        tex_add(&t, "%s(%s) drops at most %s %s for ", k > 0 ? "; " : "", r->equation, r->at_most, r->unit);
        add_states(&t, r->on);
    }
    json_string(j, "dropped", t.text);
    tex_clear(&t);
}

static void json_step(struct json *j, const struct step *s, const struct sheet *sheet)
{
    char *domain = identities_domain(&s->corrected);
    json_open(j, NULL, '{');
    json_strings(j, "id", s->id, "title", s->title);
    json_texts(j, "from", s->from, s->from_count);
    json_texts(j, "to", s->to, s->to_count);
    if (s->corrected.order >= 0)
        json_value(j, "order", "%d", s->corrected.order);
    json_strings(j, "domain", domain, "unbound", s->binding.fault.text[0] != '\0' ? s->binding.fault.text : NULL);
    free(domain);
    json_dropped(j, s);
    json_identities(j, "step", &s->corrected, &s->proof);
    json_by_hand(j, s, sheet);
    if (s->differs)
        json_identities(j, "printed", &s->printed, &s->printed_proof);
    json_close(j);
}

/* JSON is read by programs; what stops a build is told to whoever builds. */
static void tell_broken(const struct derivations *d, struct step *steps, int count, const char *gap)
{
    for (int i = 0; i < count; i++)
        if (!step_is_bound(d, &steps[i]))
            fprintf(stderr, "coulomb-tether: step %s is broken, see verify derivations %s\n", steps[i].id, steps[i].id);
    if (gap != NULL)
        fprintf(stderr, "coulomb-tether: equation %s is reached by no step, and is no definition\n", gap);
}

static void json_proofs(struct json *j, const struct sheet *sheet, const struct step *steps, int count, bool fine)
{
    json_open(j, "derivations", '{');
    json_truth(j, "fine", fine);
    json_open(j, "steps", '[');
    for (int i = 0; i < count; i++) {
        json_line(j, 1);
        json_step(j, &steps[i], sheet);
    }
    json_close(j);
    json_close(j);
}

bool verify_derivations(struct verification *v)
{
    const struct derivations *d = &v->steps;
    struct step *const steps = v->only != NULL ? step_named(d, v->only) : d->steps;
    const int count = v->only != NULL ? 1 : d->step_count;
    const char *gap = derivations_gap(d);
    int holding = 0, mutants = 0;
    for (int i = 0; i < count; i++) {
        holding += step_is_bound(d, &steps[i]);
        mutants += steps[i].binding.mutants;
    }
    const bool fine = holding == count && (v->only != NULL || gap == NULL);
    if (v->json != NULL) {
        json_proofs(v->json, v->sheet, steps, count, fine);
        tell_broken(d, steps, count, v->only == NULL ? gap : NULL);
        return fine;
    }
    for (int i = 0; i < count; i++)
        print_step(&steps[i]);
    printf("%d of %d steps hold, by normal forms\n", holding, count);
    printf("%d alterations of their equations were tried\n", mutants);
    if (gap != NULL)
        printf("equation %s is reached by no step, and is no definition\n", gap);
    else
        puts("every equation is reached from principles and definitions, or is a definition");
    return fine;
}
