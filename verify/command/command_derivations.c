/* coulomb-tether verify derivations: the steps, each with its proof and what binds it. */
#include "command/command_derivations.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "command/command.h"
#include "command/latex.h"

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

/* A line of the algebra by hand, in mathematics: the sides of an equality, or of a chain of them. */
static void json_line_by_hand(struct json *j, const struct step *s, const struct sheet *sheet, const struct yaml *line)
{
    char *text = text_copy(line->text);
    json_open(j, NULL, '{');
    json_string(j, "how", line->key);
    json_open(j, "tex", '[');
    for (char *side = text, *next; side != NULL; side = next) {
        struct tex t = {NULL, 0};
        char *end = (char *)side_end(side, "=");
        next = *end != '\0' ? end + 1 : NULL;
        *end = '\0';
        typeset_side(&t, sheet, &s->corrected, side);
        json_string(j, NULL, t.text);
        tex_clear(&t);
    }
    json_close(j);
    json_close(j);
    free(text);
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
    json_line(j, 2);
    json_open(j, "lines", '[');
    for (int i = 0; s->line_map != NULL && i < s->line_map->count; i++)
        json_line_by_hand(j, s, sheet, &s->line_map->items[i]);
    json_close(j);
    if (s->differs)
        json_identities(j, "printed", &s->printed, &s->printed_proof);
    json_close(j);
}

static void json_steps(struct json *j, const struct sheet *sheet, const struct step *steps, int count, bool fine)
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

bool print_derivations(const struct derivations *d, const char *only, struct json *j)
{
    struct step *const steps = only != NULL ? step_named(d, only) : d->steps;
    const int count = only != NULL ? 1 : d->step_count;
    const char *gap = derivations_gap(d);
    int holding = 0, mutants = 0;
    for (int i = 0; i < count; i++) {
        const bool bound = step_is_bound(d, &steps[i]);
        holding += bound;
        mutants += steps[i].binding.mutants;
        if (!bound && j != NULL) /* JSON is read by programs; what stops a build is told to whoever builds */
            fprintf(stderr, "coulomb-tether: step %s is broken, see verify derivations %s\n", steps[i].id, steps[i].id);
    }
    const bool fine = holding == count && (only != NULL || gap == NULL);
    if (j != NULL) {
        json_steps(j, d->sheet, steps, count, fine);
        if (gap != NULL && only == NULL)
            fprintf(stderr, "coulomb-tether: equation %s is reached by no step, and is no definition\n", gap);
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
