/*
 * The classical Runge-Kutta method, step for step, without rounding: every operation in balls.
 *
 * The method commutes with a linear change of the state and a change of the unit of time, so radians of
 * orbit and lengths in L_ref (linear) or r_ref = m2 L_ref / (m1 + m2) (nonlinear, on the Cartesian state)
 * give the steps that an implementer takes in SI, exactly. Plain balls lose a fixed number of bits per
 * radian, whatever the step; rk4_precision pays for that beforehand.
 */
#include "motion/flow.h"

#include <math.h>

#include "text/scope.h"

enum {
    USEFUL_BITS = 16,      /* balls wider than 2^-16 of the state widen at once */
    MOST_RK4_STEPS = 10000000, /* an hour                                          */
    FEW_STEPS = 8          /* however long: each may lose all bits of a binary64's range, four times over */
};

struct gains {
    arb_t c1, c2; /* C1/Omega^2, C2/Omega */
};

typedef void rates_function(arb_ptr rate, arb_srcptr state, const struct gains *g, slong prec);

/* (40): psi theta l, then their rates */
static void linear_rates(arb_ptr rate, arb_srcptr state, const struct gains *g, slong prec)
{
    SCOPE(arb, stiffness);
    _arb_vec_set(rate, state + FLOW_HALF, FLOW_HALF);
    arb_mul_si(rate + PSI_DOT, state + PSI, -3, prec);
    arb_submul_ui(rate + PSI_DOT, state + DL_DOT, 2, prec);
    arb_mul_si(rate + THETA_DOT, state + THETA, -4, prec);
    arb_sub_ui(stiffness, g->c1, 9, prec);
    arb_mul_2exp_si(rate + DL_DOT, state + PSI_DOT, 1);
    arb_submul(rate + DL_DOT, stiffness, state + DL, prec);
    arb_submul(rate + DL_DOT, g->c2, state + DL_DOT, prec);
}

/* (3) closed by (7) and (18): r and r' from the state, Q from them; p = k_c Q / (m1 L^3) (1 + m1/m2) */
static void nonlinear_rates(arb_ptr rate, arb_srcptr state, const struct gains *g, slong prec)
{
    enum { X, Y, Z, X_DOT, Y_DOT };
    SCOPE(arb, r, r_dot, p);
    arb_dot(r, NULL, 0, state, 1, state, 1, FLOW_HALF, prec);
    arb_sqrt(r, r, prec);
    arb_dot(r_dot, NULL, 0, state, 1, state + FLOW_HALF, 1, FLOW_HALF, prec);
    arb_div(r_dot, r_dot, r, prec);

    arb_sub_ui(p, r, 1, prec);
    arb_mul(p, p, g->c1, prec);
    arb_addmul(p, g->c2, r_dot, prec);
    arb_add_ui(p, p, 3, prec);
    arb_neg(p, p);
    arb_pow_ui(r, r, 3, prec);
    arb_div(p, p, r, prec);

    _arb_vec_set(rate, state + FLOW_HALF, FLOW_HALF);
    _arb_vec_scalar_mul(rate + FLOW_HALF, state, FLOW_HALF, p, prec);
    arb_addmul_ui(rate + FLOW_HALF + X, state + X, 3, prec);
    arb_addmul_ui(rate + FLOW_HALF + X, state + Y_DOT, 2, prec);
    arb_submul_ui(rate + FLOW_HALF + Y, state + X_DOT, 2, prec);
    arb_sub(rate + FLOW_HALF + Z, rate + FLOW_HALF + Z, state + Z, prec);
}

/* state += h/6 (k1 + 2 k2 + 2 k3 + k4), k2 and k3 at h/2, k4 at h */
static void rk4_step(arb_ptr state, const arb_t h, rates_function *rates, const struct gains *g, slong prec)
{
    static const int point[4] = {0, 1, 1, 2}; /* of the step, in halves */
    static const int weight[4] = {1, 2, 2, 1};
    arb_ptr k = _arb_vec_init(FLOW_STATE), at = _arb_vec_init(FLOW_STATE), sum = _arb_vec_init(FLOW_STATE);
    SCOPE(arb, factor);
    for (int stage = 0; stage < 4; stage++) {
        arb_mul_ui(factor, h, (ulong)point[stage], prec);
        arb_mul_2exp_si(factor, factor, -1);
        _arb_vec_set(at, state, FLOW_STATE);
        _arb_vec_scalar_addmul(at, k, FLOW_STATE, factor, prec);
        rates(k, at, g, prec);
        arb_set_si(factor, weight[stage]);
        _arb_vec_scalar_addmul(sum, k, FLOW_STATE, factor, prec);
    }
    arb_div_ui(factor, h, 6, prec);
    _arb_vec_scalar_addmul(state, sum, FLOW_STATE, factor, prec);
    _arb_vec_clear(k, FLOW_STATE);
    _arb_vec_clear(at, FLOW_STATE);
    _arb_vec_clear(sum, FLOW_STATE);
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

/* Whether there are few enough orbits, or few enough steps, up to the last of the times. */
static bool steps_in_reach(const struct flow_parameters *p, const fmpq_t h, const fmpq *times, slong count)
{
    const slong n = count > 0 ? steps_until(times + count - 1, h) : 0;
    return rk4_in_reach(p, times, count) || (n >= 0 && n <= FEW_STEPS);
}

struct march {
    rates_function *rates;
    struct gains gains;
    arb_t h;               /* radians */
    arb_ptr unit;          /* what one of each coordinate is in SI */
    arb_ptr state, si;
};

/* The first `angles` coordinates are angles, the others up to the third lengths. */
static void march_init(struct march *m, rates_function *rates, int angles, const arb_t length,
                       const struct flow_parameters *p, const fmpq_t h, slong prec)
{
    m->rates = rates;
    arb_init(m->gains.c1);
    arb_init(m->gains.c2);
    arb_init(m->h);
    m->unit = _arb_vec_init(FLOW_STATE);
    m->state = _arb_vec_init(FLOW_STATE);
    m->si = _arb_vec_init(FLOW_STATE);
    arb_div(m->gains.c2, p->C2, p->Omega, prec);
    arb_div(m->gains.c1, p->C1, p->Omega, prec);
    arb_div(m->gains.c1, m->gains.c1, p->Omega, prec);
    arb_set_fmpq(m->h, h, prec);
    arb_mul(m->h, m->h, p->Omega, prec);
    for (int i = 0; i < FLOW_HALF; i++) {
        arb_one(m->unit + i);
        if (i >= angles)
            arb_set(m->unit + i, length);
        arb_mul(m->unit + FLOW_HALF + i, m->unit + i, p->Omega, prec);
    }
}

static void march_clear(struct march *m)
{
    arb_clear(m->gains.c1);
    arb_clear(m->gains.c2);
    arb_clear(m->h);
    _arb_vec_clear(m->unit, FLOW_STATE);
    _arb_vec_clear(m->state, FLOW_STATE);
    _arb_vec_clear(m->si, FLOW_STATE);
}

static enum flow_status march_rows(struct march *m, arb_srcptr initial, const fmpq_t h, const fmpq *times,
                                   slong count, slong prec, flow_receiver *receive, void *context,
                                   double *reached)
{
    slong done = 0;
    for (int i = 0; i < FLOW_STATE; i++)
        arb_div(m->state + i, initial + i, m->unit + i, prec);
    for (slong k = 0; k < count; k++) {
        slong n = steps_until(times + k, h);
        if (n < done)
            return FLOW_DOMAIN;
        if (n > MOST_RK4_STEPS)
            return FLOW_STALLED;
        for (; done < n; done++) {
            *reached = fmpq_get_d(h) * (double)done;
            rk4_step(m->state, m->h, m->rates, &m->gains, prec);
            if (flow_wide(m->state, USEFUL_BITS))
                return FLOW_WIDE;
        }
        for (int i = 0; i < FLOW_STATE; i++)
            arb_mul(m->si + i, m->state + i, m->unit + i, prec);
        *reached = fmpq_get_d(times + k);
        if (receive(context, k, times + k, n == 0 ? initial : m->si) != 0)
            return FLOW_STOPPED;
    }
    return FLOW_DONE;
}

static enum flow_status rk4(bool nonlinear, const struct flow_parameters *p, arb_srcptr initial, const fmpq_t h,
                            const fmpq *times, slong count, slong prec, flow_receiver *receive, void *context, double *reached)
{
    struct march m;
    SCOPE(arb, length, mass);
    *reached = 0;
    if (!(nonlinear ? flow_nonlinear_domain : flow_linear_domain)(p, initial) || fmpq_sgn(h) <= 0)
        return FLOW_DOMAIN;
    if (!steps_in_reach(p, h, times, count))
        return FLOW_STALLED;
    arb_set(length, p->L_ref);
    if (nonlinear) {
        arb_add(mass, p->m1, p->m2, prec);
        arb_mul(length, p->m2, length, prec);
        arb_div(length, length, mass, prec);
    }
    march_init(&m, nonlinear ? nonlinear_rates : linear_rates, nonlinear ? 0 : 2, length, p, h, prec);
    enum flow_status status = march_rows(&m, initial, h, times, count, prec, receive, context, reached);
    march_clear(&m);
    return status;
}

enum flow_status rk4_linear(const struct flow_parameters *p, arb_srcptr initial, const fmpq_t h,
                            const fmpq *times, slong count, slong prec, flow_receiver *receive,
                            void *context, double *reached)
{
    return rk4(false, p, initial, h, times, count, prec, receive, context, reached);
}

enum flow_status rk4_nonlinear(const struct flow_parameters *p, arb_srcptr initial, const fmpq_t h,
                               const fmpq *times, slong count, slong prec, flow_receiver *receive,
                               void *context, double *reached)
{
    return rk4(true, p, initial, h, times, count, prec, receive, context, reached);
}
