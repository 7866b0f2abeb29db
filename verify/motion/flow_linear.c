/*
 * The linear flow (40). In radians of orbit, with l = dL / L_ref, c1 = C1/Omega^2, c2 = C2/Omega,
 *
 *     psi'' = -3 psi - 2 l'      l'' = (9 - c1) l + 2 psi' - c2 l'      theta'' = -4 theta,
 *
 * so (psi, l, psi', l') moves by exp(tau A), which arb_mat_exp encloses, and pitch is a sine. Each time has
 * an exponential of its own, 0.05 ms: no error is handed on from row to row.
 *
 * Theorem (the linear motion in balls). The state at t lies in the balls for all initial states and parameters in theirs:
 *   (A1) arb_mat_exp encloses exp of all matrices in tau A; of A the entries c1 and c2 are balls   (set_rates, move_coupled)
 *   (A2) sine and cosine of 2 tau, tau = Omega t a ball                                           (move_pitch)
 *   (A3) the units of angles' rates and of lengths, on the way in and out                         (flow_linear)
 * In eq40_flow_holds_both_ends_of_every_ball (tests/motion/test_flow.c) each ball of what goes in is the widest in turn.
 */
#include "motion/flow.h"

#include "text/scope.h"

enum { COUPLED = 4 };

/* A */
static void set_rates(arb_mat_t a, const struct flow_parameters *p, slong prec)
{
    static const int integer[COUPLED][COUPLED] = {{0, 0, 1, 0}, {0, 0, 0, 1}, {-3, 0, 0, -2}, {0, 9, 2, 0}};
    SCOPE(arb, c1, c2);
    for (int i = 0; i < COUPLED; i++)
        for (int j = 0; j < COUPLED; j++)
            arb_set_si(arb_mat_entry(a, i, j), integer[i][j]);
    flow_gains(c1, c2, p, prec);
    arb_sub(arb_mat_entry(a, 3, 1), arb_mat_entry(a, 3, 1), c1, prec);
    arb_sub(arb_mat_entry(a, 3, 3), arb_mat_entry(a, 3, 3), c2, prec);
}

/* (psi, l, psi', l') at tau; `unit` is what one of each is in SI */
static void move_coupled(arb_ptr state, arb_srcptr initial, const arb_mat_t rates, const arb_t tau,
                         arb_srcptr unit, slong prec)
{
    static const int place[COUPLED] = {PSI, DL, PSI_DOT, DL_DOT};
    VECTOR(arb, start, COUPLED);
    MATRIX(arb, exponential, COUPLED, COUPLED);
    arb_mat_scalar_mul_arb(exponential, rates, tau, prec);
    arb_mat_exp(exponential, exponential, prec);
    for (int i = 0; i < COUPLED; i++)
        arb_div(start + i, initial + place[i], unit + i, prec);
    for (int i = 0; i < COUPLED; i++) {
        arb_ptr x = state + place[i];
        arb_dot(x, NULL, 0, arb_mat_entry(exponential, i, 0), 1, start, 1, COUPLED, prec);
        arb_mul(x, x, unit + i, prec);
    }
}

/* theta = theta_0 cos 2 tau + theta_dot_0 / (2 Omega) sin 2 tau */
static void move_pitch(arb_ptr state, arb_srcptr initial, const arb_t tau, const arb_t Omega, slong prec)
{
    SCOPE(arb, twice, sine, cosine);
    arb_mul_2exp_si(twice, tau, 1);
    arb_sin_cos(sine, cosine, twice, prec);
    arb_mul_2exp_si(twice, Omega, 1);

    arb_div(state + THETA, initial + THETA_DOT, twice, prec);
    arb_mul(state + THETA, state + THETA, sine, prec);
    arb_addmul(state + THETA, initial + THETA, cosine, prec);

    arb_mul(state + THETA_DOT, initial + THETA, twice, prec);
    arb_mul(state + THETA_DOT, state + THETA_DOT, sine, prec);
    arb_neg(state + THETA_DOT, state + THETA_DOT);
    arb_addmul(state + THETA_DOT, initial + THETA_DOT, cosine, prec);
}

enum flow_status flow_linear(const struct flow_parameters *p, arb_srcptr initial, const fmpq *times,
                             slong count, slong prec, flow_receiver *receive, void *context,
                             double *reached)
{
    enum flow_status status = FLOW_DONE;
    VECTOR(arb, state, FLOW_STATE);
    VECTOR(arb, unit, COUPLED);
    MATRIX(arb, rates, COUPLED, COUPLED);
    SCOPE(arb, tau);
    set_rates(rates, p, prec);
    arb_one(unit);
    arb_set(unit + 1, p->L_ref);
    arb_set(unit + 2, p->Omega);
    arb_mul(unit + 3, p->L_ref, p->Omega, prec);
    *reached = 0;
    if (!flow_linear_domain(p, initial))
        status = FLOW_DOMAIN;
    else if (!flow_in_reach(p, times, count, false))
        status = FLOW_STALLED;
    for (slong k = 0; k < count && status == FLOW_DONE; k++) {
        arb_set_fmpq(tau, times + k, prec);
        arb_mul(tau, tau, p->Omega, prec);
        move_coupled(state, initial, rates, tau, unit, prec);
        move_pitch(state, initial, tau, p->Omega, prec);
        if (fmpq_is_zero(times + k))
            _arb_vec_set(state, initial, FLOW_STATE);
        if (!_arb_vec_is_finite(state, FLOW_STATE)) {
            status = FLOW_WIDE;
        } else {
            *reached = fmpq_get_d(times + k);
            if (receive(context, k, times + k, state) != 0)
                status = FLOW_STOPPED;
        }
    }
    return status;
}
