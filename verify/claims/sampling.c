#include "claims/sampling.h"

#include "claims/curve.h"
#include "text/scope.h"

void set_gains(arb_t c1, arb_t c2, const char *n, const char *c2_over_Omega, slong prec)
{
    arb_set_str(c1, n, prec);
    arb_sub_ui(c2, c1, 9, prec);
    arb_sqrt(c2, c2, prec);
    arb_mul_2exp_si(c2, c2, 1);
    if (c2_over_Omega != NULL)
        arb_set_str(c2, c2_over_Omega, prec);
}

/* ---- the law held: the property held_law of derivations.yaml ---- */

/* The derivatives by h of its first inputs, h itself and S C R D. */
static const char *const held_rates[] = {"1", "(a*C - S)/h", "a*h*S", "(b*D - R)/h", "-b*h*R"};
enum { HELD_MOVING = sizeof held_rates / sizeof *held_rates };

struct held_law {
    struct program program;
    struct machine machine;
    int met, slope;
};

static void held_law_init(struct held_law *l, const struct derivations *steps, const arb_t c1, const arb_t c2, slong prec)
{
    int rate[HELD_MOVING];
    program_copy(&l->program, &definition_find(&steps->definitions, "held_law")->corrected.program);
    for (int i = 0; i < HELD_MOVING; i++)
        rate[i] = program_parse(&l->program, held_rates[i], NULL);
    l->met = program_find(&l->program, "met");
    l->slope = program_derivative(&l->program, l->met, rate, HELD_MOVING);
    machine_init(&l->machine, &l->program, &arithmetic_ball, prec);
    arb_set(machine_value(&l->machine, program_find(&l->program, "c1")), c1);
    arb_set(machine_value(&l->machine, program_find(&l->program, "c2")), c2);
}

static void held_law_clear(struct held_law *l)
{
    machine_clear(&l->machine);
    program_clear(&l->program);
}

static arb_srcptr held_law_at(struct held_law *l, const arb_t T, int node, slong prec)
{
    arb_ptr value[HELD_MOVING];
    SCOPE(acb, angle, z);
    for (int i = 0; i < HELD_MOVING; i++)
        value[i] = machine_value(&l->machine, i);
    arb_mul_2exp_si(value[0], T, -1);
    for (int i = 0; i < 2; i++) { /* i a h, and b h */
        const int frequency = program_find(&l->program, i == 0 ? "a" : "b");
        machine_run_to(&l->machine, frequency);
        acb_zero(angle);
        arb_mul(i == 0 ? acb_imagref(angle) : acb_realref(angle), value[0], machine_value(&l->machine, frequency), prec);
        acb_sinc(z, angle, prec);
        arb_mul(value[2 * i + 1], acb_realref(z), machine_value(&l->machine, frequency), prec);
        acb_cos(z, angle, prec);
        arb_set(value[2 * i + 2], acb_realref(z));
    }
    machine_run_to(&l->machine, node);
    return machine_value(&l->machine, node);
}

/*
 * For arb_calc: the value, by itself and by the mean value theorem, where there is a derivative; and the derivative. Of strong gains
 * the value by itself is too wide to isolate anything.
 */
static int circle_met(arb_ptr out, const arb_t T, void *law, slong order, slong prec)
{
    struct held_law *l = law;
    SCOPE(arb, middle, slope, away);
    arb_set(out, held_law_at(l, T, l->met, prec));
    arb_mul_2exp_si(slope, held_law_at(l, T, l->slope, prec), -1);
    if (order > 1)
        arb_set(out + 1, slope);
    if (arb_is_finite(slope)) {
        arb_get_mid_arb(middle, T);
        arb_sub(away, T, middle, prec);
        arb_mul(slope, slope, away, prec);
        arb_add(slope, slope, held_law_at(l, middle, l->met, prec), prec);
        arb_intersection(out, out, slope, prec);
    }
    return 0;
}

void largest_hold(arb_t limit, const struct derivations *steps, const arb_t c1, const arb_t c2, slong prec)
{
    enum { LONGEST = 3, EVALUATIONS = 2000 }; /* below 2 pi/b, where z = 1 is met */
    struct held_law law;
    SCOPE(arb, none, longest);
    held_law_init(&law, steps, c1, c2, prec);
    arb_set_ui(longest, LONGEST);
    roots_between(limit, circle_met, &law, none, longest, 1, EVALUATIONS, prec);
    if (arb_is_finite(limit))
        narrow_root(limit, circle_met, &law, prec);
    held_law_clear(&law);
}

/* ---- the nonlinear motion, the law held ---- */

bool hold_follow(arb_ptr samples, const struct derivations *steps, const arb_t c1, const arb_t c2, long T, slong count, slong digits)
{
    enum { BITS = 512 };
    bool proved = true;
    SCOPE(arb, held);
    for (slong k = 0; k < count && proved; k++, samples += COORDINATES) {
        struct trajectory t;
        commanded(held, c1, c2, samples + ETA, samples + ETA_DOT, BITS);
        arb_add_ui(held, held, 1, BITS);
        proved = trajectory_run(&t, &(struct simulation){.steps = steps, .nonlinear = true, .digits = digits + count - k, .C1 = "0", .C2 = "0",
                                                         .start = samples, .held = held}, T, 1, T);
        _arb_vec_set(samples + COORDINATES, trajectory_sample(&t, 0), COORDINATES);
        trajectory_clear(&t);
    }
    return proved;
}
