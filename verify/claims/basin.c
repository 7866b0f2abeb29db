#include "claims/basin.h"

#include "claims/trajectory.h"
#include "text/scope.h"

/* At rest at the distance r, the angle psi from the radius. */
static void potential(arb_t V, const struct basin *b, const arb_t r, const arb_t psi)
{
    VECTOR(arb, at, FLOW_STATE);
    SCOPE(arb, c1);
    arb_set_ui(c1, b->gain);
    arb_set(at + PSI, psi);
    arb_sub_ui(at + ETA, r, 1, BASIN_BITS);
    tether_energy(V, b->steps, c1, at, BASIN_BITS);
}

void basin_init(struct basin *b, const struct derivations *steps, ulong n)
{
    SCOPE(arb, r, psi, V);
    arb_init(b->outer);
    arb_init(b->level);
    b->steps = steps;
    b->gain = n;
    arb_sqrt_ui(b->outer, 12 * n - 27, BASIN_BITS); /* 3 r^2 + 3 r + 3 = n */
    arb_sub_ui(b->outer, b->outer, 3, BASIN_BITS);
    arb_div_ui(b->outer, b->outer, 6, BASIN_BITS);
    potential(b->level, b, b->outer, psi);
    arb_set_ui(r, n - 3);
    arb_div_ui(r, r, n, BASIN_BITS);
    arb_const_pi(psi, BASIN_BITS);
    arb_mul_2exp_si(psi, psi, -1);
    potential(V, b, r, psi);
    b->closed = arb_gt(V, b->level);
}

void basin_clear(struct basin *b)
{
    arb_clear(b->outer);
    arb_clear(b->level);
}

/* ---- motions from rest on the radius ---- */

enum flow_status follow_from_rest(ulong n, const arb_t start, const fmpq *times, slong count, flow_receiver *receive,
                                  void *context)
{
    enum { DIGITS = 8 };
    struct flow_parameters p;
    VECTOR(arb, initial, FLOW_STATE);
    double reached;
    flow_parameters_init(&p);
    arb_one(p.Omega);
    arb_one(p.k_c);
    arb_one(p.m1);
    arb_one(p.m2);
    arb_set_ui(p.L_ref, 2); /* so that r_ref = 1 */
    arb_set_ui(p.C1, n);
    arb_zero(p.C2);
    if (n > 9)
        arb_sqrt_ui(p.C2, 4 * (n - 9), BASIN_BITS);
    arb_set(initial, start);
    enum flow_status status = flow_nonlinear(&p, initial, times, count, DIGITS, BASIN_BITS, receive, context, &reached);
    flow_parameters_clear(&p);
    return status;
}

struct watch {
    const struct basin *basin;
    enum release release;
};

/* Below the separatrix level, on one side of it: for ever so. */
static int take_release(void *context, slong k, const fmpq_t t, arb_srcptr state)
{
    struct watch *watch = context;
    const struct basin *b = watch->basin;
    SCOPE(arb, r, psi, E, speed);
    (void)k;
    (void)t;
    arb_hypot(r, state, state + 1, BASIN_BITS);
    arb_dot(speed, NULL, 0, state + 3, 1, state + 3, 1, 2, BASIN_BITS);
    arb_mul_2exp_si(speed, speed, -1);
    arb_atan2(psi, state + 1, state, BASIN_BITS);
    potential(E, b, r, psi);
    arb_add(E, E, speed, BASIN_BITS);
    if (arb_lt(E, b->level) && arb_lt(r, b->outer) && arb_is_positive(state))
        watch->release = RELEASE_RETURNS;
    else if (arb_lt(E, b->level) && arb_gt(r, b->outer))
        watch->release = RELEASE_ESCAPES;
    return watch->release != RELEASE_OPEN;
}

enum release basin_release(const struct basin *b, slong tenths)
{
    enum { TIMES = 200, PER_RADIAN = 10 };
    struct watch watch = {b, RELEASE_OPEN};
    VECTOR(fmpq, times, TIMES);
    SCOPE(arb, start, L_ref);
    for (slong k = 0; k < TIMES; k++)
        fmpq_set_si(times + k, k + 1, PER_RADIAN);
    sheet_value(L_ref, b->steps->sheet, "L_ref", BASIN_BITS);
    arb_set_si(start, tenths);
    arb_div_ui(start, start, 10, BASIN_BITS);
    arb_div(start, start, L_ref, BASIN_BITS);
    arb_add_ui(start, start, 1, BASIN_BITS);
    if (b->closed)
        follow_from_rest(b->gain, start, times, TIMES, take_release, &watch);
    return watch.release;
}
