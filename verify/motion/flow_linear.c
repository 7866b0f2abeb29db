/*
 * The linear flow (40). In radians of orbit, with l = dL / L_ref, c1 = C1/Omega^2, c2 = C2/Omega,
 *
 *     psi'' = -3 psi - 2 l'      l'' = (9 - c1) l + 2 psi' - c2 l'      theta'' = -4 theta,
 *
 * so the state moves by exp(tau A), which arb_mat_exp encloses; it keeps zeros, those of the pitch apart among them. Each time has
 * an exponential of its own, 0.1 ms: no error is handed on from row to row.
 *
 * Theorem (the linear motion in balls). The state at t lies in the balls for all initial states and parameters in theirs:
 *   (A1) arb_mat_exp encloses exp of all matrices in tau A, tau = Omega t a ball; of A the entries c1 and c2 are balls  (set_rates)
 *   (A2) the units of angles' rates and of lengths, on the way in and out                                              (flow_units)
 * In tests/motion/test_balls.c each ball of what goes in is the widest in turn.
 */
#include "motion/flow.h"

#include "text/scope.h"

void linear_rates(arb_ptr rate, arb_srcptr state, const arb_t c1, const arb_t c2, slong prec)
{
    SCOPE(arb, stiffness);
    _arb_vec_set(rate, state + FLOW_HALF, FLOW_HALF);
    arb_mul_si(rate + PSI_DOT, state + PSI, -3, prec);
    arb_submul_ui(rate + PSI_DOT, state + DL_DOT, 2, prec);
    arb_mul_si(rate + THETA_DOT, state + THETA, -4, prec);
    arb_sub_ui(stiffness, c1, 9, prec);
    arb_mul_2exp_si(rate + DL_DOT, state + PSI_DOT, 1);
    arb_submul(rate + DL_DOT, stiffness, state + DL, prec);
    arb_submul(rate + DL_DOT, c2, state + DL_DOT, prec);
}

/* A, by columns: the rates where one coordinate is 1 and all others are 0 */
static void set_rates(arb_mat_t a, const struct flow_parameters *p, slong prec)
{
    VECTOR(arb, at, FLOW_STATE);
    VECTOR(arb, rate, FLOW_STATE);
    SCOPE(arb, c1, c2);
    flow_gains(c1, c2, p, prec);
    for (int j = 0; j < FLOW_STATE; j++) {
        _arb_vec_zero(at, FLOW_STATE);
        arb_one(at + j);
        linear_rates(rate, at, c1, c2, prec);
        for (int i = 0; i < FLOW_STATE; i++)
            arb_set(arb_mat_entry(a, i, j), rate + i);
    }
}

enum flow_status flow_linear(struct flow_request *r)
{
    const slong prec = r->prec;
    VECTOR(arb, start, FLOW_STATE);
    VECTOR(arb, state, FLOW_STATE);
    VECTOR(arb, unit, FLOW_STATE);
    MATRIX(arb, rates, FLOW_STATE, FLOW_STATE);
    MATRIX(arb, exponential, FLOW_STATE, FLOW_STATE);
    SCOPE(arb, tau);
    if (!flow_in_reach(r))
        return FLOW_STALLED;
    set_rates(rates, r->p, prec);
    flow_units(unit, false, r->p, prec);
    for (int i = 0; i < FLOW_STATE; i++)
        arb_div(start + i, r->initial + i, unit + i, prec);
    for (slong k = 0; k < r->count; k++) {
        arb_set_fmpq(tau, r->times + k, prec);
        arb_mul(tau, tau, r->p->Omega, prec);
        arb_mat_scalar_mul_arb(exponential, rates, tau, prec);
        arb_mat_exp(exponential, exponential, prec);
        for (int i = 0; i < FLOW_STATE; i++) {
            arb_dot(state + i, NULL, 0, arb_mat_entry(exponential, i, 0), 1, start, 1, FLOW_STATE, prec);
            arb_mul(state + i, state + i, unit + i, prec);
        }
        if (fmpq_is_zero(r->times + k))
            _arb_vec_set(state, r->initial, FLOW_STATE);
        if (!_arb_vec_is_finite(state, FLOW_STATE))
            return FLOW_WIDE;
        r->reached = fmpq_get_d(r->times + k);
        if (r->receive(r->context, k, r->times + k, state) != 0)
            return FLOW_STOPPED;
    }
    return FLOW_DONE;
}
