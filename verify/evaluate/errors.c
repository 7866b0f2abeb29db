#include "evaluate/errors.h"

#include <math.h>
#include <stdlib.h>

#include "evaluate/reference.h"
#include "evaluate/sample.h"
#include "formula/exact.h"
#include "proof/roots.h"
#include "text/scope.h"

enum { TRUTH_BITS = 192 };

/* ---- sensitivities ---- */

/* Adds |x dy| to S; an infinite x has no last digit that anything depends on. */
static void add_term(arb_t S, arb_srcptr x, arb_srcptr derivative, slong prec)
{
    SCOPE(arb, term);
    if (!arb_is_finite(x))
        return;
    arb_mul(term, x, derivative, prec);
    arb_abs(term, term);
    arb_add(S, S, term, prec);
}

/* Of Eq. (41): its five coefficients, what each of the three inputs does to each of them, and the inputs. */
enum { GRADIENTS = 5, VARIABLES41 = GRADIENTS + 15, POLYNOMIAL41 = VARIABLES41 + 3 };

static void polynomial41(const struct sheet *sheet, const struct input *inputs, slong prec, arb_ptr p)
{
    OPERATION(polynomial, section_find(sheet, "eq41"));
    OWNED(gradient) slopes;
    operation_enclose(&polynomial, inputs, prec, p);
    gradient_init(&slopes, polynomial.machine.program, polynomial.formulas->outputs, 5, &arithmetic_ball, prec);
    gradient_run(&slopes, &polynomial.machine);
    for (int k = 0; k < 5; k++)
        for (int i = 0; i < 3; i++)
            arb_set(p + GRADIENTS + 5 * i + k, gradient_value(&slopes, k, i));
    for (int i = 0; i < 3; i++)
        arb_swap(p + VARIABLES41 + i, machine_value(&polynomial.machine, i));
}

/* Adds the sum over the inputs of |x_i dp/dx_i| at z. */
static void add_changes41(arb_t S, acb_srcptr z, arb_srcptr p, slong prec)
{
    SCOPE(acb, change);
    SCOPE(arb, modulus);
    for (int i = 0; i < 3; i++) {
        _arb_poly_evaluate_acb(change, p + GRADIENTS + 5 * i, 5, z, prec);
        acb_abs(modulus, change, prec);
        add_term(S, p + VARIABLES41 + i, modulus, prec);
    }
}

/* Of a root z, from p(z; x) = 0: dz/dx = -p_x(z) / p_z(z). */
static void roots_sensitivity(const struct sheet *sheet, const struct input *inputs, slong prec, arb_ptr S)
{
    VECTOR(acb, roots, 4);
    VECTOR(arb, p, POLYNOMIAL41);
    SCOPE(acb, zero, slope);
    SCOPE(arb, modulus);
    polynomial41(sheet, inputs, prec, p);
    roots41(roots, &inputs[0].value, &inputs[1].value, &inputs[2].value, prec);
    for (int k = 0; k < 4; k++) {
        _arb_poly_evaluate2_acb(zero, slope, p, 5, roots + k, prec);
        acb_abs(modulus, slope, prec);
        arb_zero(S + 2 * k);
        add_changes41(S + 2 * k, roots + k, p, prec);
        arb_div(S + 2 * k, S + 2 * k, modulus, prec);
        arb_set(S + 2 * k + 1, S + 2 * k);
    }
}

bool operation_has_sensitivity(const struct section *s)
{
    return s->method == METHOD_FORMULA || s->method == METHOD_ROOTS;
}

void formula_sensitivity(struct operation *o, slong prec, arb_srcptr sizes, arb_ptr S)
{
    const struct section *s = o->section;
    if (o->slopes.by == NULL)
        gradient_init(&o->slopes, o->machine.program, o->formulas->outputs, s->output_count, &arithmetic_ball, prec);
    o->slopes.machine.prec = prec; /* of derivatives, not of what they are derivatives of */
    gradient_run(&o->slopes, &o->machine);
    for (int k = 0; k < s->output_count; k++) {
        arb_zero(S + k);
        for (int i = 0; i < s->input_count; i++)
            add_term(S + k, sizes != NULL ? sizes + i : machine_value(&o->machine, i), gradient_value(&o->slopes, k, i), prec);
    }
}

void operation_sensitivity(struct operation *o, const struct input *inputs, slong prec, arb_ptr S)
{
    const struct section *s = o->section;
    if (s->method == METHOD_ROOTS) {
        roots_sensitivity(s->sheet, inputs, prec, S);
        return;
    }
    VECTOR(arb, values, s->output_count);
    operation_enclose(o, inputs, prec, values); /* fills the machine */
    formula_sensitivity(o, prec, NULL, S);
}

void operation_sensitivity_exact(struct operation *o, const struct input *inputs, slong prec, int output, arb_t S)
{
    const struct section *s = o->section;
    if (s->method == METHOD_ROOTS) {
        arb_pos_inf(S); /* of a multiple root, which moves like the root of a change */
        return;
    }
    OWNED(machine) exact;
    OWNED(gradient) derivatives, balls;
    VECTOR(arb, values, s->output_count);
    const int node = o->formulas->outputs[output];
    operation_enclose(o, inputs, prec, values);
    operation_exact(&exact, o, inputs);
    gradient_init(&derivatives, exact.program, &node, 1, &arithmetic_exact, 0);
    gradient_init(&balls, exact.program, &node, 1, &arithmetic_ball, prec);
    gradient_run(&derivatives, &exact);
    gradient_run(&balls, &o->machine);
    arb_zero(S);
    for (int i = 0; i < s->input_count; i++) {
        const struct exact *derivative = gradient_value(&derivatives, 0, i);
        if (exact_is_undefined(derivative))
            arb_pos_inf(S);
        else if (!exact_is_zero(derivative))
            add_term(S, machine_value(&o->machine, i), gradient_value(&balls, 0, i), prec);
    }
}

/* ---- the unit of error ---- */

/*
 * Theorem. Whatever y* and S are in their balls, E = |y - y*| / (u (|y*| + S)) lies between lower and upper. The error terms,
 * each with a test of its name in tests/evaluate/test_errors.c:
 *   (E1) the radius of |y - y*|, up and down          (E2) the radii of |y*| and S in the weight
 *   (E3) a weight that may be zero has no upper bound  (E4) the quotient is rounded outward
 *   (E5) of several outputs the worst, of several ways to match roots the best, in both bounds
 *   (E6) MPFR's value lies in the ball widened by 2^16 of its own roundings, for every output  (mpfr_inside)
 *   (E7) the enclosures of outputs and S that all this is told from hold them, however few bits they have
 */
/* Bounds on distance / (u weight). */
static struct error_bounds roundings(const arb_t distance, const arb_t weight, int significand)
{
    struct error_bounds E = {0.0, 0.0};
    SCOPE(arb, quotient);
    SCOPE(arf, bound);
    if (arb_is_zero(distance))
        return E;
    E.upper = INFINITY;
    if (arb_is_zero(weight) || arf_is_pos_inf(arb_midref(weight)))
        E.lower = arb_contains_zero(distance) ? 0.0 : INFINITY;
    if (!arb_is_finite(weight))
        return E;
    arb_mul_2exp_si(quotient, weight, -significand);
    arb_div(quotient, distance, quotient, 64);
    if (!arb_is_finite(quotient)) /* the weight may be zero */
        return E;
    arb_get_ubound_arf(bound, quotient, 64);
    E.upper = arf_get_d(bound, ARF_RND_UP);
    arb_get_lbound_arf(bound, quotient, 64);
    E.lower = fmax(arf_get_d(bound, ARF_RND_DOWN), 0.0);
    return E;
}

struct error_bounds error_in_roundings(const arf_t y, const arb_t exact, const arb_t S, int significand)
{
    SCOPE(arb, distance, weight);
    if (!arf_is_finite(y))
        return (struct error_bounds){INFINITY, INFINITY};
    arb_sub_arf(distance, exact, y, TRUTH_BITS);
    arb_abs(distance, distance);
    arb_abs(weight, exact);
    arb_add(weight, weight, S, 64);
    return roundings(distance, weight, significand);
}

/* ---- roots, complex numbers of which S is a modulus too ---- */

/* |y - z| against u (|z| + S) */
static struct error_bounds root_error(arb_srcptr y, arb_srcptr z, const arb_t S, int significand)
{
    SCOPE(arb, re, im);
    arb_sub(re, y, z, TRUTH_BITS);
    arb_sub(im, y + 1, z + 1, TRUTH_BITS);
    arb_hypot(re, re, im, TRUTH_BITS);
    arb_hypot(im, z, z + 1, TRUTH_BITS);
    arb_add(im, im, S, TRUTH_BITS);
    return roundings(re, im, significand);
}

/*
 * A multiple root moves like a root of the change and has no S: what counts is the polynomial's value there,
 * |p(y)| against u times what one rounding of each coefficient and of each input does to it.
 */
static struct error_bounds residual_error(const struct sheet *sheet, arb_srcptr y, const struct input *inputs, int significand)
{
    VECTOR(arb, p, POLYNOMIAL41);
    VECTOR(arb, powers, 5);
    SCOPE(acb, z, value);
    SCOPE(arb, weight, modulus);
    polynomial41(sheet, inputs, TRUTH_BITS, p);
    acb_set_arb_arb(z, y, y + 1);
    _arb_poly_evaluate_acb(value, p, 5, z, TRUTH_BITS);
    acb_abs(modulus, z, TRUTH_BITS);
    _arb_vec_set_powers(powers, modulus, 5, TRUTH_BITS);
    for (int k = 0; k < 5; k++)
        add_term(weight, powers + k, p + k, TRUTH_BITS);
    add_changes41(weight, z, p, TRUTH_BITS);
    acb_abs(modulus, value, TRUTH_BITS);
    return roundings(modulus, weight, significand);
}

static double distance(arb_srcptr y, arb_srcptr z)
{
    return hypot(arf_get_d(arb_midref(y), ARF_RND_NEAR) - arf_get_d(arb_midref(z), ARF_RND_NEAR),
                 arf_get_d(arb_midref(y + 1), ARF_RND_NEAR) - arf_get_d(arb_midref(z + 1), ARF_RND_NEAR));
}

/* Root j of the four for y; a multiple one by the residual, as long as no other root is nearer. */
static struct error_bounds one_of_four(const struct sheet *sheet, arb_srcptr y, arb_srcptr exact, arb_srcptr S, int j,
                                       const struct input *inputs, int significand)
{
    bool multiple = false, nearest = true;
    for (int k = 0; k < 4; k++) {
        const bool same = arb_equal(exact + 2 * k, exact + 2 * j) && arb_equal(exact + 2 * k + 1, exact + 2 * j + 1);
        multiple = multiple || (same && k != j);
        nearest = nearest && (same || distance(y, exact + 2 * j) < distance(y, exact + 2 * k));
    }
    if (!multiple)
        return root_error(y, exact + 2 * j, S + 2 * j, significand);
    return nearest ? residual_error(sheet, y, inputs, significand) : (struct error_bounds){INFINITY, INFINITY};
}

/* Answers i and after to roots that none before took: of all ways to match them, the one with the least worst E. */
static struct error_bounds matched(struct error_bounds E[4][4], int i, unsigned taken)
{
    struct error_bounds least = {i < 4 ? INFINITY : 0.0, i < 4 ? INFINITY : 0.0};
    for (int j = 0; j < 4; j++) {
        if (taken & 1U << j)
            continue;
        const struct error_bounds rest = matched(E, i + 1, taken | 1U << j);
        least.lower = fmin(least.lower, fmax(E[i][j].lower, rest.lower));
        least.upper = fmin(least.upper, fmax(E[i][j].upper, rest.upper));
    }
    return least;
}

struct error_bounds worst_error(const struct section *s, const struct input *inputs, arb_srcptr y, arb_srcptr exact,
                                arb_srcptr S, int significand, int *output)
{
    struct error_bounds worst = {0.0, -1.0};
    *output = 0;
    if (s->method == METHOD_ROOTS) { /* a set */
        struct error_bounds E[4][4];
        for (int i = 0; i < 16; i++)
            E[i / 4][i % 4] = one_of_four(s->sheet, y + 2 * (i / 4), exact, S, i % 4, inputs, significand);
        return matched(E, 0, 0);
    }
    for (int i = 0; i < s->output_count; i++) {
        const struct error_bounds E = error_in_roundings(arb_midref(y + i), exact + i, S + i, significand);
        worst.lower = fmax(worst.lower, E.lower);
        if (E.upper > worst.upper) {
            worst.upper = E.upper;
            *output = i;
        }
    }
    return worst;
}

/* ---- ref/ on random inputs ---- */

bool mpfr_inside(const struct operation *o, const struct input *inputs, arb_srcptr exact, arb_srcptr S)
{
    OWNED(machine) m;
    SCOPE(arb, value, room);
    bool inside = true;
    machine_init(&m, &o->formulas->program, &arithmetic_mpfr, 2 * TRUTH_BITS);
    for (int i = 0; i < o->section->input_count; i++)
        arithmetic_mpfr.set_rational(machine_value(&m, i), &inputs[i].value, m.prec);
    machine_run(&m);
    for (int i = 0; i < o->section->output_count; i++) {
        arb_zero(value);
        arf_set_mpfr(arb_midref(value), machine_value(&m, o->formulas->outputs[i]));
        arb_abs(room, exact + i);
        arb_add(room, room, S + i, TRUTH_BITS);
        arb_mul_2exp_si(room, room, 16 - 2 * TRUTH_BITS); /* 2^16 roundings: far more than a formula has */
        arb_add_error(value, room);
        inside = inside && arf_is_finite(arb_midref(value)) && arb_overlaps(value, exact + i); /* a ball of NaN overlaps all */
    }
    return inside;
}

void measure_errors(struct measured *m, const struct section *s, long count, uint64_t seed)
{
    double values[MOST_INPUTS], answers[MOST_OUTPUTS];
    INPUTS(inputs);
    VECTOR(arb, y, MOST_OUTPUTS);
    VECTOR(arb, exact, MOST_OUTPUTS);
    VECTOR(arb, S, MOST_OUTPUTS);
    reference_function *function = reference_find(s->id);
    OPERATION(o, s);
    *m = (struct measured){.section = s, .inputs = count};
    for (long index = 0; index < count; index++) {
        int output;
        sample(&o, seed, (uint64_t)index, values, inputs);
        function(values, answers);
        operation_sensitivity(&o, inputs, TRUTH_BITS, S);
        operation_enclose(&o, inputs, TRUTH_BITS, exact);
        for (int i = 0; i < s->output_count; i++)
            arb_set_d(y + i, answers[i]);
        const double E = worst_error(s, inputs, y, exact, S, BINARY64, &output).upper;
        if (E > m->worst) {
            m->worst = E;
            m->index = index;
        }
        m->outside += s->method == METHOD_FORMULA && !mpfr_inside(&o, inputs, exact, S);
    }
}
