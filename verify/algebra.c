#include "algebra.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "identities.h"
#include "symbolic.h"

/* ---- identities ------------------------------------------------------- */

bool vanishes(const struct program *p, int node)
{
    struct program difference;
    program_copy(&difference, p);
    const int zero = formula(&difference, "0");
    const bool holds = node >= 0 && nodes_equal(&difference, node, zero, false);
    program_clear(&difference);
    return holds;
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
    const int x = program_input(&p, "x"), node = formula(&p, text);
    fmpq_poly_zero(f);
    if (node >= 0) {
        struct machine m;
        symbolic_begin(1, 0, false);
        machine_init(&m, &p, &arithmetic_symbolic, 1);
        symbolic_set_variable(machine_value(&m, x), 0, 0);
        machine_run(&m);
        symbolic_get_polynomial(f, machine_value(&m, node));
        machine_clear(&m);
        symbolic_end();
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
    symbolic_begin(0, 0, false);
    machine_init(&m, &s->corrected.program, &arithmetic_symbolic, 1);
    for (int i = 0; i < s->input_count; i++) {
        fmpq_set_si(q, inputs[i], 1);
        m.arithmetic->set_rational(machine_value(&m, i), q, 1);
    }
    machine_run(&m);
    for (int i = 0; i < s->output_count; i++)
        rational = symbolic_get_rational(outputs + i, machine_value(&m, s->corrected.outputs[i])) && rational;
    machine_clear(&m);
    symbolic_end();
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
