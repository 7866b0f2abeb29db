#include "errors.h"

#include <math.h>
#include <stdlib.h>

#include "exact.h"
#include "reference.h"
#include "roots.h"
#include "sample.h"

enum { MOST_INPUTS = 40, MOST_OUTPUTS = 16, TRUTH_BITS = 192 };

/* ---- sensitivities ---- */

/* Adds |x dy| to S. */
static void add_term(arb_t S, const struct input *x, arb_srcptr derivative, slong prec)
{
    arb_t term;
    if (x->infinite)
        return; /* nothing depends on the last digit of infinity */
    arb_init(term);
    arb_set_fmpq(term, &x->value, prec);
    arb_mul(term, term, derivative, prec);
    arb_abs(term, term);
    arb_add(S, S, term, prec);
    arb_clear(term);
}

/* Of a root z, from p(z; x) = 0: dz/dx = -p_x(z) / p_z(z), coefficients and their gradients of Eq. (41). */
static void root_sensitivity(arb_t S, acb_srcptr z, arb_srcptr coefficients, arb_srcptr gradients,
                             const struct input *inputs, slong prec)
{
    acb_t slope, p, power, term;
    arb_t modulus;
    acb_init(slope);
    acb_init(p);
    acb_init(power);
    acb_init(term);
    arb_init(modulus);
    for (int k = 4; k >= 1; k--) {
        acb_mul(slope, slope, z, prec);
        arb_mul_ui(modulus, coefficients + k, (ulong)k, prec);
        acb_add_arb(slope, slope, modulus, prec);
    }
    arb_zero(S);
    for (int i = 0; i < 3; i++) {
        acb_zero(p);
        for (int k = 4; k >= 0; k--) {
            acb_mul(p, p, z, prec);
            acb_add_arb(p, p, gradients + 5 * i + k, prec);
        }
        acb_div(term, p, slope, prec);
        acb_abs(modulus, term, prec);
        add_term(S, &inputs[i], modulus, prec);
    }
    acb_clear(slope);
    acb_clear(p);
    acb_clear(power);
    acb_clear(term);
    arb_clear(modulus);
}

static void roots_sensitivity(const struct input *inputs, slong prec, arb_ptr S)
{
    struct operation polynomial;
    struct machine adjoint;
    acb_ptr roots = _acb_vec_init(4);
    arb_ptr coefficients = _arb_vec_init(5), gradients = _arb_vec_init(15);
    operation_init(&polynomial, section_find(sheet(), "eq41"), false);
    operation_enclose(&polynomial, inputs, prec, coefficients);
    machine_init(&adjoint, polynomial.machine.program, &arithmetic_ball, prec);
    for (int k = 0; k < 5; k++) {
        machine_gradient(&polynomial.machine, polynomial.formulas->outputs[k], &adjoint);
        for (int i = 0; i < 3; i++)
            arb_set(gradients + 5 * i + k, machine_value(&adjoint, i));
    }
    roots41(roots, &inputs[0].value, &inputs[1].value, &inputs[2].value, prec);
    for (int k = 0; k < 4; k++) {
        root_sensitivity(S + 2 * k, roots + k, coefficients, gradients, inputs, prec);
        arb_set(S + 2 * k + 1, S + 2 * k);
    }
    machine_clear(&adjoint);
    operation_clear(&polynomial);
    _acb_vec_clear(roots, 4);
    _arb_vec_clear(coefficients, 5);
    _arb_vec_clear(gradients, 15);
}

bool operation_has_sensitivity(const struct section *s)
{
    return s->method == METHOD_FORMULA || s->method == METHOD_ROOTS;
}

void operation_sensitivity(struct operation *o, const struct input *inputs, slong prec, arb_ptr S)
{
    const struct section *s = o->section;
    if (s->method == METHOD_ROOTS) {
        roots_sensitivity(inputs, prec, S);
        return;
    }
    struct machine adjoint;
    arb_ptr values = _arb_vec_init(s->output_count);
    operation_enclose(o, inputs, prec, values); /* fills the machine */
    machine_init(&adjoint, o->machine.program, &arithmetic_ball, prec);
    for (int k = 0; k < s->output_count; k++) {
        machine_gradient(&o->machine, o->formulas->outputs[k], &adjoint);
        arb_zero(S + k);
        for (int i = 0; i < s->input_count; i++)
            add_term(S + k, &inputs[i], machine_value(&adjoint, i), prec);
    }
    machine_clear(&adjoint);
    _arb_vec_clear(values, s->output_count);
}

void operation_sensitivity_settled(struct operation *o, const struct input *inputs, slong prec, int output,
                                   arb_t S)
{
    const struct section *s = o->section;
    if (s->method == METHOD_ROOTS) {
        arb_pos_inf(S); /* of a multiple root, which moves like the root of a change */
        return;
    }
    struct machine sums, exact, balls;
    arb_ptr values = _arb_vec_init(s->output_count);
    const int node = o->formulas->outputs[output];
    operation_enclose(o, inputs, prec, values);
    operation_sums(&sums, o, inputs);
    machine_init(&exact, sums.program, &arithmetic_sums, 0);
    machine_init(&balls, sums.program, &arithmetic_ball, prec);
    machine_gradient(&sums, node, &exact);
    machine_gradient(&o->machine, node, &balls);
    arb_zero(S);
    for (int i = 0; i < s->input_count; i++) {
        const struct exact *derivative = machine_value(&exact, i);
        if (derivative->pole)
            arb_pos_inf(S);
        else if (!exact_is_zero(derivative) && arb_is_finite(S))
            add_term(S, &inputs[i], machine_value(&balls, i), prec);
    }
    machine_clear(&sums);
    machine_clear(&exact);
    machine_clear(&balls);
    _arb_vec_clear(values, s->output_count);
}

/* ---- the unit of error ---- */

double error_in_roundings(const arf_t y, const arb_t exact, const arb_t S, int significand)
{
    const slong prec = 64;
    arb_t difference, unit;
    arf_t bound;
    if (!arf_is_finite(y) || !arb_is_finite(exact) || !arb_is_finite(S))
        return INFINITY;
    arb_init(difference);
    arb_init(unit);
    arf_init(bound);
    arb_sub_arf(difference, exact, y, TRUTH_BITS);
    arb_abs(unit, exact);
    arb_add(unit, unit, S, prec);
    arb_mul_2exp_si(unit, unit, -significand);
    double E = 0.0;
    if (!arb_is_zero(difference)) {
        arb_abs(difference, difference);
        arb_div(difference, difference, unit, prec);
        arb_get_ubound_arf(bound, difference, prec);
        E = arf_is_nan(bound) ? INFINITY : arf_get_d(bound, ARF_RND_UP);
    }
    arb_clear(difference);
    arb_clear(unit);
    arf_clear(bound);
    return E;
}

/* |y - z| against u (|z| + S) for a complex root. */
static double root_error(const double *y, arb_srcptr z, const arb_t S)
{
    arb_t re, im, modulus;
    arf_t none;
    double E = INFINITY;
    if (!isfinite(y[0]) || !isfinite(y[1]))
        return E;
    arb_init(re);
    arb_init(im);
    arb_init(modulus);
    arf_init(none);
    arb_set_d(re, y[0]);
    arb_set_d(im, y[1]);
    arb_sub(re, re, z, TRUTH_BITS);
    arb_sub(im, im, z + 1, TRUTH_BITS);
    arb_hypot(re, re, im, TRUTH_BITS); /* the distance, compared with zero on the scale of |z| + S */
    arb_hypot(modulus, z, z + 1, TRUTH_BITS);
    arb_add(modulus, modulus, S, TRUTH_BITS);
    arb_mul_2exp_si(modulus, modulus, -BINARY64);
    arb_div(re, re, modulus, TRUTH_BITS);
    arb_get_ubound_arf(none, re, 64);
    E = arf_is_nan(none) ? INFINITY : arf_get_d(none, ARF_RND_UP);
    arb_clear(re);
    arb_clear(im);
    arb_clear(modulus);
    arf_clear(none);
    return E;
}

/* Roots are a set: of all 24 ways to match them, the one with the least worst error. */
static double matched_error(const double *y, arb_srcptr exact, arb_srcptr S)
{
    double E[4][4], least = INFINITY;
    for (int i = 0; i < 16; i++)
        E[i / 4][i % 4] = root_error(y + 2 * (i / 4), exact + 2 * (i % 4), S + 2 * (i % 4));
    for (int code = 0; code < 256; code++) {
        const int to[4] = {code & 3, (code >> 2) & 3, (code >> 4) & 3, (code >> 6) & 3};
        if (((1 << to[0]) | (1 << to[1]) | (1 << to[2]) | (1 << to[3])) != 15)
            continue;
        double worst = 0.0;
        for (int i = 0; i < 4; i++)
            worst = fmax(worst, E[i][to[i]]);
        least = fmin(least, worst);
    }
    return least;
}

double worst_error(const struct section *s, const double *y, arb_srcptr exact, arb_srcptr S, int *output)
{
    double worst = -1.0;
    *output = 0;
    if (s->method == METHOD_ROOTS)
        return matched_error(y, exact, S);
    for (int i = 0; i < s->output_count; i++) {
        arf_t value;
        arf_init(value);
        arf_set_d(value, y[i]);
        double E = error_in_roundings(value, exact + i, S + i, BINARY64);
        arf_clear(value);
        if (E > worst) {
            worst = E;
            *output = i;
        }
    }
    return worst;
}

/* ---- ref/ on random inputs ---- */

/* The same formulas in MPFR lie inside the enclosures, widened by what MPFR itself rounds. */
static bool mpfr_inside(const struct operation *o, const struct input *inputs, arb_srcptr exact,
                        arb_srcptr S)
{
    struct machine m;
    arb_t value, room;
    bool inside = true;
    machine_init(&m, &o->formulas->program, &arithmetic_mpfr, 2 * TRUTH_BITS);
    for (int i = 0; i < o->section->input_count; i++)
        arithmetic_mpfr.set_rational(machine_value(&m, i), &inputs[i].value, m.prec);
    machine_run(&m);
    arb_init(value);
    arb_init(room);
    for (int i = 0; i < o->section->output_count; i++) {
        arb_zero(value);
        arf_set_mpfr(arb_midref(value), machine_value(&m, o->formulas->outputs[i]));
        arb_abs(room, exact + i);
        arb_add(room, room, S + i, TRUTH_BITS);
        arb_mul_2exp_si(room, room, 16 - 2 * TRUTH_BITS); /* 2^16 roundings: far more than a formula has */
        arb_add_error(value, room);
        inside = inside && arb_overlaps(value, exact + i);
    }
    arb_clear(value);
    arb_clear(room);
    machine_clear(&m);
    return inside;
}

void measure_errors(struct measured *m, const struct section *s, long count, uint64_t seed)
{
    double values[MOST_INPUTS], answers[MOST_OUTPUTS];
    struct input *inputs = inputs_new(s->input_count);
    arb_ptr exact = _arb_vec_init(MOST_OUTPUTS), S = _arb_vec_init(MOST_OUTPUTS);
    reference_function *function = reference_find(s->id);
    struct operation o;
    operation_init(&o, s, false);
    *m = (struct measured){.section = s, .inputs = count};
    for (long index = 0; index < count; index++) {
        int output;
        sample(&o, seed, (uint64_t)index, values, inputs);
        function(values, answers);
        operation_sensitivity(&o, inputs, TRUTH_BITS, S);
        operation_enclose(&o, inputs, TRUTH_BITS, exact);
        double E = worst_error(s, answers, exact, S, &output);
        if (E > m->worst) {
            m->worst = E;
            m->index = index;
        }
        if (s->method == METHOD_FORMULA && !mpfr_inside(&o, inputs, exact, S))
            m->outside++;
    }
    operation_clear(&o);
    inputs_free(inputs, s->input_count);
    _arb_vec_clear(exact, MOST_OUTPUTS);
    _arb_vec_clear(S, MOST_OUTPUTS);
}
