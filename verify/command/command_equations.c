/* coulomb-tether equations: what the sheet has. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "claims/verdicts.h"
#include "command/command.h"
#include "command/latex.h"

static void print_quantities(const char *heading, const struct quantity *const *quantities, int count)
{
    for (int i = 0; i < count; i++)
        printf("  %-8s %-10s %-10s %-10s %s\n", i ? "" : heading, quantities[i]->name,
               quantities[i]->unit, domain_names[quantities[i]->domain], quantities[i]->meaning);
}

static void print_formulas(const char *heading, const struct section *s, const struct formulas *f)
{
    for (int i = 0; i < f->lets; i++)
        printf("  %-8s %s = %s\n", i ? "" : "let", f->let[2 * i], f->let[2 * i + 1]);
    for (int i = 0; i < s->output_count && s->method == METHOD_FORMULA; i++)
        printf("  %-8s %s = %s\n", i ? "" : heading, s->outputs[i]->name, f->text[i]);
    for (int i = 0; i < f->count; i++)
        printf("  %-8s %s\n", i ? "" : "domain", f->conditions[i].text);
}

/* Of each of a section's equations, as JSON or (NULL) with its evidence. */
static void print_verdicts(struct json *j, const struct derivations *p, const struct section *s)
{
    for (int i = 0; i < s->numbers; i++) {
        struct verdict_row row = {.id = s->id};
        verdict_on_equation(&row, p, NULL, s, s->equations[i]);
        const char *verdict = verdict_names[row.verdict];
        if (j != NULL)
            json_string(j, s->equations[i], verdict);
        else
            printf("  %-8s (%s) %s: %s\n", i ? "" : "verdict", s->equations[i], verdict, row.evidence.plain.text);
        verdict_row_clear(&row);
    }
}

static void print_section(const struct derivations *p, const struct section *s)
{
    printf("%s  Eq. ", s->id);
    print_list(s->equations, s->numbers, 0);
    printf("  %s\n", s->title);
    print_quantities("given", s->inputs, s->input_count);
    print_quantities("returns", s->outputs, s->output_count);
    print_formulas("formula", s, &s->corrected);
    for (int i = 0; i < s->relation_count; i++)
        printf("  %-8s (%s) %s\n", i ? "" : "relation", s->relations[i].equation, s->relations[i].text);
    if (s->differs) {
        print_formulas("printed", s, &s->printed);
        printf("  %-8s %s\n", "reason", s->reason);
    }
    if (s->note != NULL)
        printf("  %-8s %s\n", "note", s->note);
    print_verdicts(NULL, p, s);
}

static void json_quantities(struct json *j, const char *key, const struct quantity *const *quantities, int count)
{
    json_open(j, key, '[');
    for (int i = 0; i < count; i++) {
        struct tex t = {NULL, 0};
        typeset_symbol(&t, quantities[i]->name);
        json_record(j, NULL, "name", quantities[i]->name, "unit", quantities[i]->unit,
                    "domain", domain_names[quantities[i]->domain], "meaning", quantities[i]->meaning, "tex", t.text);
        tex_clear(&t);
    }
    json_close(j);
}

static void json_formulas(struct json *j, const char *key, const struct section *s, const struct formulas *f)
{
    json_open(j, key, '{');
    json_open(j, "let", '{');
    for (int i = 0; i < f->lets; i++)
        json_string(j, f->let[2 * i], f->let[2 * i + 1]);
    json_close(j);
    json_open(j, "outputs", '{');
    for (int i = 0; i < s->output_count; i++)
        json_string(j, s->outputs[i]->name, f->text[i]);
    json_close(j);
    json_open(j, "domain", '[');
    for (int i = 0; i < f->count; i++)
        json_string(j, NULL, f->conditions[i].text);
    json_close(j);
    json_close(j);
}

static void json_section(struct json *j, const struct derivations *p, const struct section *s)
{
    json_open(j, NULL, '{');
    json_string(j, "id", s->id);
    json_texts(j, "equations", s->equations, s->numbers);
    json_strings(j, "title", s->title, "note", s->note, "reason", s->reason);
    json_truth(j, "computes", s->method != METHOD_NONE);
    json_quantities(j, "inputs", s->inputs, s->input_count);
    json_quantities(j, "outputs", s->outputs, s->output_count);
    if (s->method == METHOD_FORMULA)
        json_formulas(j, "formula", s, &s->corrected);
    if (s->differs)
        json_formulas(j, "printed", s, &s->printed);
    json_display(j, s);
    json_open(j, "verdicts", '{');
    print_verdicts(j, p, s);
    json_close(j);
    json_close(j);
}

static void print_section_line(const struct section *s)
{
    printf("%-15s ", s->id);
    print_list(s->equations, s->numbers, 14);
    printf("  %s%s\n", s->title, s->differs ? " (misprinted)" : "");
}

int command_equations(const struct arguments *a)
{
    const struct sheet *sheet = &a->paper->sheet;
    const struct section *one = a->word_count > 0 ? section_argument(sheet, a->words[0]) : NULL;
    if (a->word_count > 0 && one == NULL)
        return EXIT_USAGE;
    const bool json = option_given(a, "--json");
    struct derivations proofs;
    struct message why;
    if (derivations_open(&proofs, a->paper, &why) != 0)
        return usage_error(EXIT_FAILED_CHECK, "%s", why.text);
    struct json j = json_on(stdout);
    if (json && one == NULL)
        json_open(&j, NULL, '[');
    for (int i = 0; i < sheet->section_count; i++) {
        const struct section *s = &sheet->sections[i];
        if (json && (one == NULL || one == s))
            json_section(&j, &proofs, s);
        else if (one == NULL)
            print_section_line(s);
        else if (one == s)
            print_section(&proofs, s);
        json_line(&j, one == NULL && i + 1 < sheet->section_count ? 1 : -1);
    }
    if (json && one == NULL)
        json_close(&j);
    derivations_clear(&proofs);
    return EXIT_DONE;
}
