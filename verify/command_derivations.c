/* coulomb-tether verify derivations: the steps, each with its proof. */
#include "command_verify.h"

#include <stdio.h>

#include "command.h"

/* Blank-separated, padded to a width; "-" where there is nothing. */
static void print_list(const char *const *texts, int count, int width)
{
    width -= count == 0 ? printf("-") : 0;
    for (int i = 0; i < count; i++)
        width -= printf("%s%s", i ? " " : "", texts[i]);
    printf("%*s", width > 0 ? width : 0, "");
}

static void print_step(const struct proofs *p, int i)
{
    const struct step *s = &p->derivations.steps[i];
    const struct proof *proof = &p->corrected[i];
    printf("%-24s ", s->id);
    print_list(s->from, s->from_count, 26);
    printf(" -> ");
    print_list(s->to, s->to_count, 12);
    if (s->order < 0)
        printf("  exact  ");
    else
        printf("  order %d", s->order);
    if (proof->finding == FOUND_EQUAL)
        printf("  %d points  degree %-5lu  2^-%d\n", proof->points, (unsigned long)s->corrected.degree, proof->bits);
    else
        printf("  BROKEN\n    %s\n", proof->evidence);
    if (s->differs && p->printed[i].finding == FOUND_DIFFERENT)
        printf("    not as printed: %s\n", p->printed[i].evidence);
    else if (s->differs)
        printf("    BROKEN: expected to fail as printed: %s\n",
               p->printed[i].finding == FOUND_EQUAL ? "it holds" : p->printed[i].evidence);
}

static void table_proofs(const struct proofs *p)
{
    int holding = 0;
    for (int i = 0; i < p->derivations.step_count; i++) {
        print_step(p, i);
        holding += proofs_step_holds(p, i);
    }
    printf("%d of %d steps hold: %d points, largest degree %lu, a false one passes with a chance below 2^-%d\n",
           holding, p->derivations.step_count, p->points, (unsigned long)p->degree, ENOUGH_BITS);
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

static void json_trial(const char *key, const struct trial *t, const struct proof *p)
{
    static const char *const findings[] = {
        [FOUND_EQUAL] = "holds", [FOUND_DIFFERENT] = "differs", [FOUND_NOTHING] = "undecided"};
    printf(",\n  \"%s\": {\"show\": [", key);
    for (int i = 0; i < t->shown_count; i++) {
        printf("%s{\"equality\": ", i ? ", " : "");
        json_text(t->shown[i].text);
        printf(", \"degree\": %lu}", (unsigned long)t->shown[i].degree);
    }
    printf("], \"finding\": \"%s\"", findings[p->finding]);
    if (p->evidence != NULL) {
        printf(", \"evidence\": ");
        json_text(p->evidence);
    }
    printf(", \"degree\": %lu, \"bound\": \"2^-%d\", \"retries\": %d, \"points\": [", (unsigned long)t->degree,
           p->bits, p->retries);
    for (int k = 0; k < p->points; k++) {
        const char *separator = k ? ", {" : "{";
        for (int i = 0; i < t->program.inputs; i++) {
            if (!t->needed[i])
                continue;
            char *number = fmpz_get_str(NULL, 10, p->drawn + (slong)k * t->program.inputs + i);
            printf("%s\"%s\": \"%s\"", separator, t->program.names[i].text, number);
            separator = ", ";
            flint_free(number);
        }
        putchar('}');
    }
    fputs("]}", stdout);
}

/* The free quantities that are finite angles, the drawn t giving their cosine (t^2 - 1)/(t^2 + 1), or small. */
static void json_variables(const char *key, const struct trial *t, bool small)
{
    const char *separator = "";
    printf(", \"%s\": [", key);
    for (int i = 0; i < t->program.inputs; i++) {
        const struct variable *v = &t->variables[i];
        if (!t->needed[i] || !(small ? v->power > 0 : v->kind == KIND_ANGLE))
            continue;
        printf("%s\"%s\"", separator, t->program.names[i].text);
        separator = ", ";
    }
    putchar(']');
}

static void json_step(const struct proofs *p, int i)
{
    const struct step *s = &p->derivations.steps[i];
    printf("{\"id\": \"%s\", \"title\": ", s->id);
    json_text(s->title);
    json_list("from", s->from, s->from_count);
    json_list("to", s->to, s->to_count);
    if (s->order >= 0)
        printf(", \"order\": %d", s->order);
    json_variables("small", &s->corrected, true);
    json_variables("angles", &s->corrected, false);
    printf(", \"let\": {");
    for (int k = 0; s->let != NULL && k < length_of(s->let); k++) {
        printf("%s\"%s\": ", k ? ", " : "", scalar(key_of(&p->derivations.document, s->let, k)));
        json_text(scalar(value_of(&p->derivations.document, s->let, k)));
    }
    putchar('}');
    json_trial("step", &s->corrected, &p->corrected[i]);
    if (s->differs)
        json_trial("printed", &s->printed, &p->printed[i]);
    putchar('}');
}

static void json_proofs(const struct proofs *p)
{
    printf("{\"fine\": %s, \"steps\": [\n ", p->fine ? "true" : "false");
    for (int i = 0; i < p->derivations.step_count; i++) {
        fputs(i ? ",\n " : "", stdout);
        json_step(p, i);
    }
    puts("]}");
}

void print_proofs(const struct proofs *p, enum format format)
{
    (format == FORMAT_JSON ? json_proofs : table_proofs)(p);
}
