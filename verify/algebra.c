#include "algebra.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "series.h"
#include "sheet.h"

/* ---- identities ------------------------------------------------------- */

/* A bound on the degree of a node's numerator and denominator in one of the inputs. */
struct degrees {
    int over, under;
};

static int most(int a, int b)
{
    return a > b ? a : b;
}

/* The degree of a node in that input; negative when it is no rational function. */
static struct degrees degree_of(const struct program *p, int node, int input)
{
    struct degrees *d = memory(NULL, (size_t)node + 1, sizeof *d), a, b, result;
    for (int i = 0; i <= node; i++) {
        const struct node *at = &p->nodes[i];
        a = at->left < 0 ? (struct degrees){0, 0} : d[at->left];
        b = at->right < 0 ? (struct degrees){0, 0} : d[at->right];
        d[i] = (struct degrees){i == input, 0};
        if (at->op == OPERATOR_NEGATE)
            d[i] = a;
        else if (at->op == OPERATOR_ADD || at->op == OPERATOR_SUBTRACT)
            d[i] = (struct degrees){most(a.over + b.under, b.over + a.under), a.under + b.under};
        else if (at->op == OPERATOR_MULTIPLY)
            d[i] = (struct degrees){a.over + b.over, a.under + b.under};
        else if (at->op == OPERATOR_DIVIDE)
            d[i] = (struct degrees){a.over + b.under, a.under + b.over};
        else if (at->op == OPERATOR_POWER && at->exponent >= 0)
            d[i] = (struct degrees){a.over * (int)at->exponent, a.under * (int)at->exponent};
        else if (at->op == OPERATOR_POWER)
            d[i] = (struct degrees){-a.under * (int)at->exponent, -a.over * (int)at->exponent};
        else if (at->op != OPERATOR_INPUT && at->op != OPERATOR_NUMBER)
            d[i] = (struct degrees){-1, -1};
        if (a.over < 0 || b.over < 0)
            d[i] = (struct degrees){-1, -1};
    }
    result = d[node];
    free(d);
    return result;
}

/* At 1, 2, ... degree + 1 of every input, and so everywhere. */
bool vanishes(const struct program *p, int node)
{
    int *at = memory(NULL, (size_t)p->inputs, sizeof *at);
    int *last = memory(NULL, (size_t)p->inputs, sizeof *last);
    bool zero = node >= 0, done = false;
    struct machine m;
    fmpq_t x;
    fmpq_init(x);
    machine_init(&m, p, &arithmetic_series, 1);
    for (int i = 0; i < p->inputs; i++) {
        at[i] = 1;
        last[i] = zero ? degree_of(p, node, i).over + 1 : 0;
        zero = zero && last[i] > 0;
    }
    while (zero && !done) {
        for (int i = 0; i < p->inputs; i++) {
            fmpq_set_si(x, at[i], 1);
            m.arithmetic->set_rational(machine_value(&m, i), x, 1);
        }
        machine_run(&m);
        const struct series *value = machine_value(&m, node);
        zero = value->fault == SERIES_FINE && fmpq_poly_is_zero(value->p);
        int i = 0;
        while (i < p->inputs && at[i] == last[i])
            at[i++] = 1;
        done = i == p->inputs;
        if (!done)
            at[i]++;
    }
    machine_clear(&m);
    fmpq_clear(x);
    free(at);
    free(last);
    return zero;
}

int formula(struct program *p, const char *text)
{
    size_t where;
    struct message why;
    return program_parse(p, text, &where, &why);
}

static bool equal(struct program *p, const char *left, const char *right)
{
    int a = formula(p, left), b = formula(p, right);
    return a >= 0 && b >= 0 && vanishes(p, program_difference(p, a, b));
}

bool identity(const char *names, const char *left, const char *right)
{
    struct program p;
    char name[32];
    program_init(&p);
    while (*names != '\0') {
        size_t length = strcspn(names, " ");
        snprintf(name, sizeof name, "%.*s", (int)length, names);
        program_input(&p, name);
        names += length + (names[length] == ' ');
    }
    bool holds = equal(&p, left, right);
    program_clear(&p);
    return holds;
}

bool section_identity(const char *id, const char *left, const char *right)
{
    const struct section *s = section_find(sheet(), id);
    if (s == NULL)
        return false;
    struct program p;
    program_copy(&p, &s->corrected.program);
    for (int i = 0; i < s->output_count; i++)
        program_name(&p, s->corrected.outputs[i], s->outputs[i]->name);
    bool holds = equal(&p, left, right);
    program_clear(&p);
    return holds;
}

/* ---- polynomials in one variable -------------------------------------- */

void polynomial(fmpq_poly_t f, const char *text)
{
    struct program p;
    program_init(&p);
    int x = program_input(&p, "x"), node = formula(&p, text);
    fmpq_poly_zero(f);
    if (node >= 0) {
        struct machine m;
        machine_init(&m, &p, &arithmetic_series, degree_of(&p, node, x).over + 1);
        fmpq_poly_set_coeff_si(((struct series *)machine_value(&m, x))->p, 1, 1);
        machine_run(&m);
        fmpq_poly_set(f, ((struct series *)machine_value(&m, node))->p);
        machine_clear(&m);
    }
    program_clear(&p);
}

slong roots_beyond(const fmpq_poly_t f, const fmpq_t point)
{
    slong negative = 0, positive = 0, zeros = 0;
    fmpq_poly_t g, h;
    fmpz_poly_t simple;
    fmpq_poly_init(g);
    fmpq_poly_init(h);
    fmpz_poly_init(simple);
    fmpq_poly_set_coeff_fmpq(h, 0, point);
    fmpq_poly_set_coeff_si(h, 1, 1);
    fmpq_poly_compose(g, f, h); /* Sturm's chain wants no multiple root, and none at 0 */
    fmpq_poly_derivative(h, g);
    fmpq_poly_gcd(h, g, h);
    fmpq_poly_div(g, g, h);
    fmpq_poly_get_numerator(simple, g);
    while (zeros < simple->length && fmpz_is_zero(simple->coeffs + zeros))
        zeros++;
    fmpz_poly_shift_right(simple, simple, zeros);
    if (fmpz_poly_degree(simple) > 0)
        _fmpz_poly_num_real_roots_sturm(&negative, &positive, simple->coeffs, simple->length);
    fmpq_poly_clear(g);
    fmpq_poly_clear(h);
    fmpz_poly_clear(simple);
    return positive;
}

/* ---- the sheet at rational points ------------------------------------- */

bool section_at(const char *id, const slong *inputs, fmpq *outputs)
{
    const struct section *s = section_find(sheet(), id);
    struct machine m;
    fmpq_t q;
    bool rational = true;
    fmpq_init(q);
    machine_init(&m, &s->corrected.program, &arithmetic_series, 1);
    for (int i = 0; i < s->input_count; i++) {
        fmpq_set_si(q, inputs[i], 1);
        m.arithmetic->set_rational(machine_value(&m, i), q, 1);
    }
    machine_run(&m);
    for (int i = 0; i < s->output_count; i++) {
        const struct series *value = machine_value(&m, s->corrected.outputs[i]);
        rational = rational && value->fault == SERIES_FINE;
        series_get_fmpq(outputs + i, value, 0);
    }
    machine_clear(&m);
    fmpq_clear(q);
    return rational;
}

bool characteristic_is(const fmpq_mat_t A, const char *text)
{
    fmpq_poly_t f, g;
    fmpq_poly_init(f);
    fmpq_poly_init(g);
    fmpq_mat_charpoly(f, A);
    polynomial(g, text);
    bool same = fmpq_poly_equal(f, g);
    fmpq_poly_clear(f);
    fmpq_poly_clear(g);
    return same;
}

slong rank_of(const fmpq_mat_t A)
{
    fmpq_mat_t B;
    fmpq_mat_init(B, fmpq_mat_nrows(A), fmpq_mat_ncols(A));
    slong rank = fmpq_mat_rref(B, A);
    fmpq_mat_clear(B);
    return rank;
}
