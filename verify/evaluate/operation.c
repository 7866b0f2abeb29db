#include "evaluate/operation.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "formula/exact.h"
#include "motion/motion.h"
#include "proof/roots.h"
#include "text/decimal.h"
#include "text/scope.h"

enum { GUARD_BITS = 64, FORMULA_GUARD_BITS = 58 }; /* so that 40 digits take three words */

/* Beyond this no formula of the sheet should need to go; it is the end of a loop that has none else. */
static const slong MOST_WORKING_BITS = 400000;

void operation_init(struct operation *o, const struct section *s, bool as_printed)
{
    *o = (struct operation){.section = s};
    o->formulas = as_printed && s->differs ? &s->printed : &s->corrected;
    o->constants = 4 * GUARD_BITS;
    machine_init(&o->machine, &o->formulas->program, &arithmetic_ball, o->constants);
}

void operation_clear(struct operation *o)
{
    machine_clear(&o->machine);
    if (o->slopes.by != NULL)
        gradient_clear(&o->slopes);
}

/* ---- formulas in balls and in exact numbers ---- */

static void set_inputs(struct machine *m, const struct input *inputs)
{
    for (int i = 0; i < m->program->inputs; i++) {
        if (inputs[i].infinite)
            m->arithmetic->set_infinity(machine_value(m, i));
        else
            m->arithmetic->set_rational(machine_value(m, i), &inputs[i].value, m->prec);
    }
}

static void load_balls(struct operation *o, const struct input *inputs, slong prec)
{
    if (o->constants < prec) {
        machine_clear(&o->machine);
        machine_init(&o->machine, &o->formulas->program, &arithmetic_ball, prec);
        o->constants = prec;
    }
    o->machine.prec = prec;
    set_inputs(&o->machine, inputs);
}

void operation_exact(struct machine *m, const struct operation *o, const struct input *inputs)
{
    machine_init(m, &o->formulas->program, &arithmetic_exact, 0);
    set_inputs(m, inputs);
    machine_run(m);
}

void operation_node(fmpq_t value, const struct operation *o, const struct input *inputs, int node)
{
    OWNED(machine) exact;
    machine_init(&exact, &o->formulas->program, &arithmetic_exact, 0);
    set_inputs(&exact, inputs);
    machine_run_to(&exact, node);
    exact_is_rational(value, machine_value(&exact, node));
}

/* ---- the domain ---- */

static bool compares(int sign, enum comparison comparison)
{
    return comparison == LESS ? sign < 0 : comparison == GREATER ? sign > 0 : sign >= 0;
}

/* By the sign of its node's enclosure where that is clear of zero, else exactly. */
static bool holds(const struct operation *o, const struct input *inputs, const struct condition *c)
{
    arb_srcptr ball = machine_value(&o->machine, c->node);
    if (c->comparison != INTEGER && !arb_contains_zero(ball))
        return compares(arf_sgn(arb_midref(ball)), c->comparison);
    SCOPE(fmpq, value);
    operation_node(value, o, inputs, c->node);
    return c->comparison == INTEGER ? fmpz_is_one(fmpq_denref(value)) : compares(fmpq_sgn(value), c->comparison);
}

static const fmpq *input_named(const struct operation *o, const struct input *inputs, const char *name)
{
    return &inputs[program_find(&o->formulas->program, name)].value;
}

bool operation_valid(struct operation *o, const struct input *inputs)
{
    const struct section *s = o->section;
    for (int i = 0; i < s->input_count; i++)
        if (!input_in_domain(&inputs[i], s->inputs[i]->domain)) {
            message_set(&o->why, "%s: outside its domain, %s", s->inputs[i]->name, domain_names[s->inputs[i]->domain]);
            return false;
        }
    for (int i = 0; i < o->formulas->count; i++) {
        const struct condition *c = &o->formulas->conditions[i];
        if (i == 0)
            load_balls(o, inputs, 2 * GUARD_BITS);
        machine_run_to(&o->machine, c->node);
        if (!holds(o, inputs, c)) {
            message_set(&o->why, "%s: expected %s", s->id, c->text);
            return false;
        }
    }
    return true;
}

/* ---- enclosures ---- */

static int take_state(void *context, slong k, const fmpq_t t, arb_srcptr state)
{
    (void)k;
    (void)t;
    _arb_vec_set(context, state, FLOW_STATE);
    return 0;
}

static enum operation_status enclose_flow(struct operation *o, const struct input *inputs, slong digits,
                                          slong prec, arb_ptr outputs)
{
    const enum method method = o->section->method;
    const bool linear = method == METHOD_FLOW_LINEAR || method == METHOD_RK4_LINEAR;
    const bool steps = method == METHOD_RK4_LINEAR || method == METHOD_RK4_NONLINEAR;
    const fmpq *t = input_named(o, inputs, "t"), *h = steps ? input_named(o, inputs, "h") : NULL;
    FLOW_PARAMETERS(p);
    VECTOR(arb, initial, FLOW_STATE);
    const int parameters = linear ? 4 : 7; /* before t, which the initial state follows */
    for (int i = 0; i < parameters + FLOW_STATE; i++) /* of the linear model all but k_c m1 m2 */
        arb_set_fmpq(i >= parameters ? initial + i - parameters : p.Omega + (linear && i > 0 ? i + 3 : i),
                     &inputs[i < parameters ? i : i + 1].value, prec);
    struct flow_request r = {&p, initial, t, 1, digits, prec, take_state, outputs, !linear, h, NULL, 0};
    const enum flow_status status = flow_run(&r);
    if (!linear && is_static(input_named(o, inputs, "m1"), input_named(o, inputs, "m2"), input_named(o, inputs, "L_ref"), &inputs[parameters + 1]))
        _arb_vec_set(outputs, initial, FLOW_STATE);
    if (status != FLOW_DONE)
        message_set(&o->why, "%s, last proved time %.6g s", flow_status_text(status), r.reached);
    return status == FLOW_DONE ? OPERATION_PROVED : OPERATION_UNDECIDED;
}

slong operation_precision(const struct operation *o, const struct input *inputs, slong digits)
{
    if (o->section->method == METHOD_FORMULA || o->section->method == METHOD_ROOTS)
        return (slong)((double)digits * 3.33) + FORMULA_GUARD_BITS; /* 3.33 > log2(10) */
    const fmpq *Omega = input_named(o, inputs, "Omega"), *t = input_named(o, inputs, "t");
    if (o->section->method >= METHOD_RK4_LINEAR)
        return rk4_precision(digits, rk4_radians(Omega, t, input_named(o, inputs, "h")));
    return flow_precision(digits, fabs(fmpq_get_d(Omega) * fmpq_get_d(t))); /* radians of orbit: what loss of digits grows with */
}

enum operation_status operation_follow(struct operation *o, const struct input *inputs, slong digits, slong prec,
                                       arb_ptr outputs)
{
    if (o->section->method == METHOD_ROOTS) {
        roots41((acb_ptr)outputs, &inputs[0].value, &inputs[1].value, &inputs[2].value, prec); /* a complex ball is two real ones */
        return OPERATION_PROVED;
    }
    if (o->section->method != METHOD_FORMULA)
        return enclose_flow(o, inputs, digits, prec, outputs);
    load_balls(o, inputs, prec);
    machine_run(&o->machine);
    for (int i = 0; i < o->section->output_count; i++)
        arb_set(outputs + i, machine_value(&o->machine, o->formulas->outputs[i]));
    return OPERATION_PROVED;
}

enum operation_status operation_enclose(struct operation *o, const struct input *inputs, slong prec, arb_ptr outputs)
{
    return operation_follow(o, inputs, (slong)((double)prec / 3.33), prec, outputs);
}

/* ---- digits ---- */

/* Texts of what the enclosures decide; how many are left. */
static int decide(arb_srcptr balls, slong digits, char **texts, int count)
{
    int left = 0;
    for (int i = 0; i < count; i++) {
        if (texts[i] == NULL)
            texts[i] = decimal_of_ball(balls + i, digits);
        left += texts[i] == NULL;
    }
    return left;
}

/* Rational outputs, zeros and ties among them, may have no enclosure that ever decides them. How many are left. */
static int decide_exactly(const struct operation *o, const struct input *inputs, slong digits, char **texts)
{
    const bool formulas = o->section->method == METHOD_FORMULA, roots = o->section->method == METHOD_ROOTS;
    struct machine values;
    SCOPE(fmpq, value);
    int left = 0;
    if (formulas)
        operation_exact(&values, o, inputs);
    for (int i = 0; i < o->section->output_count; i++) {
        if (texts[i] == NULL &&
            ((formulas && exact_is_rational(value, machine_value(&values, o->formulas->outputs[i]))) ||
             (roots && roots41_rational(value, i / 2, i % 2, &inputs[0].value, &inputs[1].value, &inputs[2].value))))
            texts[i] = decimal_of_rational(value, digits);
        left += texts[i] == NULL;
    }
    if (formulas)
        machine_clear(&values);
    return left;
}

enum operation_status operation_digits(struct operation *o, const struct input *inputs, slong digits, char **outputs)
{
    const int count = o->section->output_count;
    char *texts[MOST_OUTPUTS] = {NULL};
    if (!operation_valid(o, inputs))
        return OPERATION_INVALID;
    VECTOR(arb, balls, count);
    const slong first = operation_precision(o, inputs, digits), most = 8 * first + MOST_WORKING_BITS / 8;
    enum operation_status status;
    for (slong prec = first;; prec *= 2) {
        status = operation_follow(o, inputs, digits, prec, balls);
        if (status != OPERATION_PROVED || decide(balls, digits, texts, count) == 0)
            break;
        if (prec == first && decide_exactly(o, inputs, digits, texts) == 0)
            break;
        status = OPERATION_UNDECIDED;
        if (2 * prec > most) {
            message_set(&o->why, "%s: %ld bits do not decide every digit", o->section->id, (long)prec);
            break;
        }
    }
    for (int i = 0; i < count; i++) {
        if (status == OPERATION_PROVED)
            outputs[i] = texts[i];
        else
            free(texts[i]);
    }
    return status;
}
