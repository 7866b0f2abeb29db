#include "well.h"

#include "enclosure.h"
#include "motion.h"

const ulong well_gains[GAINS] = {10, 12};

/*
 * WELL' = -(r - 1)(3 r^2 + 3 r + 3 - n)/r^2, which falls to r = 1, rises to the root outer of the
 * second factor, and falls; SIDE is least at r = 1 - 3/n, and there above the rim. The claims prove both slopes.
 */
void well_init(struct well *w, ulong n)
{
    arb_t side;
    arb_init(side);
    arb_init(w->n);
    arb_init(w->outer);
    arb_init(w->rim);
    w->gain = n;
    arb_set_ui(w->n, n);
    enclose(w->outer, "(sqrt(12*n - 27) - 3)/6", KNOWN({"n", w->n}));
    enclose(w->rim, WELL, KNOWN({"n", w->n}, {"x", w->outer}));
    enclose(side, "(n - 3)/(1 - 3/n) + n*log(1 - 3/n)", KNOWN({"n", w->n}));
    w->proved = arb_gt(side, w->rim);
    arb_clear(side);
}

void well_clear(struct well *w)
{
    arb_clear(w->n);
    arb_clear(w->outer);
    arb_clear(w->rim);
}

/* ---- motions from rest on the radius ---- */

enum flow_status follow(ulong n, const arb_t start, const fmpq *times, slong count, flow_receiver *receive,
                        void *context)
{
    enum { DIGITS = 8 };
    struct flow_parameters p;
    arb_ptr initial = _arb_vec_init(FLOW_STATE);
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
        arb_sqrt_ui(p.C2, 4 * (n - 9), ENCLOSURE_BITS);
    arb_set(initial, start);
    enum flow_status status =
        flow_nonlinear(&p, initial, times, count, DIGITS, ENCLOSURE_BITS, receive, context, &reached);
    flow_parameters_clear(&p);
    _arb_vec_clear(initial, FLOW_STATE);
    return status;
}

struct watch {
    const struct well *well;
    enum fate fate;
};

/* Once within the well, or without and below the rim, for ever so. */
static int take_fate(void *context, slong k, const fmpq_t t, arb_srcptr state)
{
    struct watch *watch = context;
    const struct well *w = watch->well;
    arb_t r, room;
    (void)k;
    (void)t;
    arb_init(r);
    arb_init(room);
    enclose(r, "sqrt(X^2 + Y^2)", KNOWN({"X", state}, {"Y", state + 1}));
    const struct known *known =
        KNOWN({"x", r}, {"X", state}, {"u", state + 3}, {"v", state + 4}, {"n", w->n}, {"rim", w->rim});
    enclose(room, "rim - (u^2 + v^2)/2 + 3/2*X^2 - " SIDE, known);
    if (arb_is_positive(room)) {
        if (arb_lt(r, w->outer) && arb_is_positive(state))
            watch->fate = FATE_RETURNS;
        else if (arb_gt(r, w->outer))
            watch->fate = FATE_ESCAPES;
    }
    arb_clear(r);
    arb_clear(room);
    return watch->fate != FATE_OPEN;
}

enum fate well_fate(const struct well *w, slong tenths)
{
    enum { TIMES = 200, PER_RADIAN = 10 };
    struct watch watch = {w, FATE_OPEN};
    fmpq *times = _fmpq_vec_init(TIMES);
    arb_t start, error;
    arb_init(start);
    arb_init(error);
    for (slong k = 0; k < TIMES; k++)
        fmpq_set_si(times + k, k + 1, PER_RADIAN);
    arb_set_si(error, tenths);
    enclose(start, "1 + error/10/L_ref", KNOWN({"error", error}));
    follow(w->gain, start, times, TIMES, take_fate, &watch);
    arb_clear(start);
    arb_clear(error);
    _fmpq_vec_clear(times, TIMES);
    return w->proved ? watch.fate : FATE_OPEN;
}
