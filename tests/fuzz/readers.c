/* Targets: what reads numbers, formulas, and the files that hold them. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "text/decimal.h"
#include "proof/derivation.h"
#include "evaluate/sample.h"
#include "targets.h"
#include "tests/paper.h"
#include "formula/typeset.h"

/* ---- literals: the C library reads the same ---- */

void literal(const char *bytes, size_t size)
{
    char *text = text_of(bytes, size), *end;
    fmpq_t value, theirs;
    fmpq_init(value);
    fmpq_init(theirs);
    const enum literal kind = literal_read(value, text, false);
    const double x = strtod(text, &end);
    const bool number = *text != '\0' && *end == '\0' && strpbrk(text, " \t\n\v\f\r(") == NULL;
    require((kind != LITERAL_MALFORMED) == number, "a number, or none, as strtod() says", text);
    if (kind == LITERAL_FINITE)
        fmpq_set_double(theirs, x);
    require(kind != LITERAL_FINITE || fmpq_equal(value, theirs), "the value that strtod() finds", text);
    require(kind != LITERAL_OVERFLOW || isinf(x), "an overflow", text);
    require((kind == LITERAL_NAN) == (number && isnan(x)), "nan, or not", text);
    literal_read(value, text, true);
    fmpq_clear(value);
    fmpq_clear(theirs);
    free(text);
}

/* ---- the expression parser ---- */

/* What it takes can be typeset, and both ways of differentiating it, by all inputs at once, agree. */
static void differentiate(struct program *p, int node, int one)
{
    struct tex t = {NULL, 0};
    struct machine m;
    struct gradient slopes;
    arb_t sum;
    int *rate = xrealloc(NULL, (size_t)p->inputs, sizeof *rate);
    for (int i = 0; i < p->inputs; i++)
        rate[i] = i == one ? -1 : one;
    typeset_formula(&t, p, node);
    tex_clear(&t);
    const int derivative = program_derivative(p, node, rate, p->inputs);
    machine_init(&m, p, &arithmetic_ball, 64);
    gradient_init(&slopes, p, &node, 1, &arithmetic_ball, 64);
    for (int i = 0; i < p->inputs; i++)
        arb_set_d(machine_value(&m, i), i == one ? 1.0 : i % 2 ? -0.75 : 1.5);
    machine_run(&m);
    gradient_run(&slopes, &m);
    arb_init(sum);
    for (int i = 0; i < p->inputs; i++)
        if (i != one)
            arb_add(sum, sum, gradient_value(&slopes, 0, i), 64);
    require(arb_overlaps(machine_value(&m, derivative), sum) != 0, "one derivative", "two different ones");
    arb_clear(sum);
    machine_clear(&m);
    gradient_clear(&slopes);
    free(rate);
}

void expression(const char *bytes, size_t size)
{
    char *text = text_of(bytes, size);
    struct program p;
    struct message why = {""};
    size_t where = 0;
    program_init(&p);
    for (int i = 0; i < sheet()->quantity_count; i++)
        program_input(&p, sheet()->quantities[i].name);
    const int one = program_input(&p, "one");
    const int node = program_parse_with(&p, text, NULL, NULL, &where, &why);
    if (node < 0)
        require_message(why.text);
    require(where <= strlen(text), "a place in the text", text);
    if (node >= 0)
        differentiate(&p, node, one);
    program_clear(&p);
    free(text);
}

/* ---- the sheet and the derivation steps ---- */

static void require_place(const struct message *why)
{
    require_message(why->text);
    require(strncmp(why->text, "f.yaml:", strlen("f.yaml:")) == 0, "file, line and column", why->text);
}

void sheet_file(const char *bytes, size_t size)
{
    struct sheet s;
    struct message why = {""};
    if (sheet_read(&s, bytes, size, "f.yaml", &why) == 0)
        sheet_clear(&s);
    else
        require_place(&why);
}

void derivations_file(const char *bytes, size_t size)
{
    struct derivations d;
    struct message why = {""};
    if (derivations_read(&d, sheet(), bytes, size, "f.yaml", &why) == 0)
        derivations_clear(&d);
    else
        require_place(&why);
}
