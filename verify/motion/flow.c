/*
 * What the motions have in common: their domains, an enclosure's use, the precision to start with.
 */
#include "motion/flow.h"

#include <math.h>

#include "text/scope.h"

/* Radians: 160,000 orbits of some 10^5 bits, and of the method 1,600 of 240,000: both would take days. */
static const double FLOW_REACH = 1e6, RK4_REACH = 1e4;

enum { PARAMETERS = 7 };

void flow_parameters_init(struct flow_parameters *p)
{
    arb_ptr all = _arb_vec_init(PARAMETERS);
    *p = (struct flow_parameters){all, all + 1, all + 2, all + 3, all + 4, all + 5, all + 6};
}

void flow_parameters_clear(struct flow_parameters *p)
{
    _arb_vec_clear(p->Omega, PARAMETERS);
}

void flow_gains(arb_t c1, arb_t c2, const struct flow_parameters *p, slong prec)
{
    arb_div(c2, p->C2, p->Omega, prec);
    arb_div(c1, p->C1, p->Omega, prec);
    arb_div(c1, c1, p->Omega, prec);
}

void flow_units(arb_ptr unit, bool nonlinear, const struct flow_parameters *p, slong prec)
{
    SCOPE(arb, mass);
    arb_add(mass, p->m1, p->m2, prec);
    for (int i = 0; i < FLOW_HALF; i++) {
        arb_set(unit + i, p->L_ref);
        if (nonlinear) {
            arb_mul(unit + i, p->m2, unit + i, prec);
            arb_div(unit + i, unit + i, mass, prec);
        } else if (i < DL)
            arb_one(unit + i);
    }
    _arb_vec_scalar_mul(unit + FLOW_HALF, unit, FLOW_HALF, p->Omega, prec);
}

const char *flow_status_text(enum flow_status status)
{
    static const char *const texts[] = {[FLOW_DONE] = "done",
                                        [FLOW_STOPPED] = "stopped",
                                        [FLOW_WIDE] = "the enclosure grew past use",
                                        [FLOW_CLOSE] = "the craft come closer than L_ref/128, nothing is proved beyond",
                                        [FLOW_UNCHARGED] = "Q_ref + dQ may be >= 0 in the set, where Eq. (21) has no charges",
                                        [FLOW_DOMAIN] = "a time is no whole number of steps",
                                        [FLOW_STALLED] = "too many steps or orbits, no end in sight"};
    return texts[status];
}

enum flow_status flow_run(struct flow_request *r)
{
    r->reached = 0;
    return r->h != NULL ? rk4(r) : r->nonlinear ? flow_nonlinear(r) : flow_linear(r);
}

bool flow_wide(arb_srcptr state, slong bits)
{
    SCOPE(mag, radius, size, m);
    for (int i = 0; i < FLOW_STATE; i++) {
        mag_max(radius, radius, arb_radref(state + i));
        arb_get_mag(m, state + i);
        mag_max(size, size, m);
    }
    mag_mul_2exp_si(size, size, -bits);
    return mag_is_inf(radius) || mag_cmp(radius, size) > 0;
}

bool flow_in_reach(const struct flow_request *r)
{
    SCOPE(arb, radians, reach);
    arb_set_fmpq(radians, r->times + r->count - 1, 64);
    arb_mul(radians, radians, r->p->Omega, 64);
    arb_abs(radians, radians);
    arb_set_d(reach, r->h != NULL ? RK4_REACH : FLOW_REACH);
    return arb_le(radians, reach);
}

slong flow_precision(slong digits, double radians)
{
    /* Table 1 takes some 35 of the 60 bits (remainders, growth, small coordinates); the others are for near zeros */
    return (slong)(log2(10) * (double)digits + 60 + 0.1 * fmin(fabs(radians), FLOW_REACH));
}

slong rk4_precision(slong digits, double radians)
{
    /* plain balls lose 10 bits per radian of orbit at n = 10, 23 at n = 40, whatever the step */
    return (slong)(log2(10) * (double)digits + 40 + 24 * fmin(fabs(radians), RK4_REACH));
}
