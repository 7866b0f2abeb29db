/*
 * The classical Runge-Kutta method, step for step, without rounding: every operation in balls.
 *
 * The method commutes with a linear change of the state and a change of the unit of time, so radians of
 * orbit and lengths in L_ref (linear) or r_ref = m2 L_ref / (m1 + m2) (nonlinear, on the Cartesian state)
 * give the steps that an implementer takes in SI, exactly. Plain balls lose a fixed number of bits per
 * radian, whatever the step; rk4_precision pays for that beforehand.
 *
 * Theorem (steps in balls). After any number of steps the ball of each coordinate holds it for all initial states and parameters in
 * theirs: each operation's ball holds the operation's result for all numbers in the balls that it is given. A ball that is lost is
 *   (R1) of the rates: the state, and (T13) of taylor.c                             (linear_rates, nonlinear_rates)
 *   (R2) of a step: h, a stage's part of it, the stages and their sum                (rk4_step)
 *   (R3) of the units and gains, on the way in and out                               (flow_units, flow_gains)
 * tests/motion/test_balls.c makes each ball of what goes in the widest, in steps so long that each of these has to be there.
 */
#include "motion/flow.h"

#include <math.h>

#include "motion/taylor.h"
#include "text/scope.h"

enum {
    USEFUL_BITS = 16,      /* balls wider than 2^-16 of the state widen at once */
    MOST_RK4_STEPS = 10000000, /* an hour                                          */
    FEW_STEPS = 8          /* however long: each may lose all bits of a binary64's range, four times over */
};

typedef void rates_function(arb_ptr rate, arb_srcptr state, const arb_t c1, const arb_t c2, slong prec);

/* (3) closed by (7) and (18), by the table of taylor.h: coefficient 1 of the states' series */
static void nonlinear_rates(arb_ptr rate, arb_srcptr state, const arb_t c1, const arb_t c2, slong prec)
{
    OWNED(jet) jet;
    jet_init(&jet, &closed_loop, 1, NULL);
    jet_constants(&jet, c1, c2);
    for (int i = 0; i < FLOW_STATE; i++)
        arb_set(jet.c[i], state + i);
    jet_start_q(&jet, prec);
    jet_extend(&jet, &jet, prec, 0);
    for (int i = 0; i < FLOW_STATE; i++)
        arb_set(rate + i, jet.c[i] + 1);
}

/* state += h/6 (k1 + 2 k2 + 2 k3 + k4), k2 and k3 at h/2, k4 at h */
static void rk4_step(arb_ptr state, const arb_t h, rates_function *rates, const arb_t c1, const arb_t c2, slong prec)
{
    static const int point[4] = {0, 1, 1, 2}; /* of the step, in halves */
    static const int weight[4] = {1, 2, 2, 1};
    VECTOR(arb, k, FLOW_STATE);
    VECTOR(arb, at, FLOW_STATE);
    VECTOR(arb, sum, FLOW_STATE);
    SCOPE(arb, factor);
    for (int stage = 0; stage < 4; stage++) {
        arb_mul_ui(factor, h, (ulong)point[stage], prec);
        arb_mul_2exp_si(factor, factor, -1);
        _arb_vec_set(at, state, FLOW_STATE);
        _arb_vec_scalar_addmul(at, k, FLOW_STATE, factor, prec);
        rates(k, at, c1, c2, prec);
        arb_set_si(factor, weight[stage]);
        _arb_vec_scalar_addmul(sum, k, FLOW_STATE, factor, prec);
    }
    arb_div_ui(factor, h, 6, prec);
    _arb_vec_scalar_addmul(state, sum, FLOW_STATE, factor, prec);
}

/* t / h, at most WORD_MAX; -1 where that is no number of steps */
static slong steps_until(const fmpq_t t, const fmpq_t h)
{
    slong n = -1;
    SCOPE(fmpq, ratio);
    fmpq_div(ratio, t, h);
    if (fmpz_is_one(fmpq_denref(ratio)) && fmpq_sgn(ratio) >= 0)
        n = fmpz_fits_si(fmpq_numref(ratio)) ? fmpz_get_si(fmpq_numref(ratio)) : WORD_MAX;
    return n;
}

double rk4_radians(const fmpq_t Omega, const fmpq_t t, const fmpq_t h)
{
    const double step = fabs(fmpq_get_d(Omega) * fmpq_get_d(h)), steps = (double)steps_until(t, h);
    return fmin(fabs(fmpq_get_d(Omega) * fmpq_get_d(t)), steps < 0 ? INFINITY : steps * (2 + log2(1 + step)));
}

enum flow_status rk4(struct flow_request *r)
{
    const slong prec = r->prec;
    VECTOR(arb, unit, FLOW_STATE);
    VECTOR(arb, state, FLOW_STATE);
    VECTOR(arb, si, FLOW_STATE);
    SCOPE(arb, c1, c2, tau);
    slong done = 0;
    if (!flow_in_reach(r) && steps_until(r->times + r->count - 1, r->h) > FEW_STEPS)
        return FLOW_STALLED;
    flow_gains(c1, c2, r->p, prec);
    flow_units(unit, r->nonlinear, r->p, prec);
    arb_set_fmpq(tau, r->h, prec);
    arb_mul(tau, tau, r->p->Omega, prec);
    for (int i = 0; i < FLOW_STATE; i++)
        arb_div(state + i, r->initial + i, unit + i, prec);
    for (slong k = 0; k < r->count; k++) {
        const slong n = steps_until(r->times + k, r->h);
        if (n < done)
            return FLOW_DOMAIN;
        if (n > MOST_RK4_STEPS)
            return FLOW_STALLED;
        for (; done < n; done++) {
            r->reached = fmpq_get_d(r->h) * (double)done;
            rk4_step(state, tau, r->nonlinear ? nonlinear_rates : linear_rates, c1, c2, prec);
            if (flow_wide(state, USEFUL_BITS))
                return FLOW_WIDE;
        }
        for (int i = 0; i < FLOW_STATE; i++)
            arb_mul(si + i, state + i, unit + i, prec);
        r->reached = fmpq_get_d(r->times + k);
        if (r->receive(r->context, k, r->times + k, n == 0 ? r->initial : si) != 0)
            return FLOW_STOPPED;
    }
    return FLOW_DONE;
}
