/*
 * What the motions have in common: their domains, an enclosure's use, the precision to start with.
 */
#include "motion/flow.h"

#include <math.h>

#include "text/scope.h"

/* Radians: 160,000 orbits of some 10^5 bits, and of the method 1,600 of 240,000: both would take days. */
static const double FLOW_REACH = 1e6, RK4_REACH = 1e4;

void flow_parameters_init(struct flow_parameters *p)
{
    arb_ptr all[] = {p->Omega, p->L_ref, p->C1, p->C2, p->k_c, p->m1, p->m2};
    for (size_t i = 0; i < sizeof all / sizeof *all; i++)
        arb_init(all[i]);
}

void flow_parameters_clear(struct flow_parameters *p)
{
    arb_ptr all[] = {p->Omega, p->L_ref, p->C1, p->C2, p->k_c, p->m1, p->m2};
    for (size_t i = 0; i < sizeof all / sizeof *all; i++)
        arb_clear(all[i]);
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
                                        [FLOW_DOMAIN] = "a parameter lies outside the domain",
                                        [FLOW_STALLED] = "too many steps or orbits, no end in sight"};
    return texts[status];
}

enum flow_status flow_run(bool nonlinear, const fmpq *h, const struct flow_parameters *p, arb_srcptr initial, const fmpq *times,
                          slong count, slong digits, slong prec, flow_receiver *receive, void *context, double *reached)
{
    if (h != NULL)
        return rk4(nonlinear, p, initial, h, times, count, prec, receive, context, reached);
    if (nonlinear)
        return flow_nonlinear(p, initial, times, count, digits, prec, receive, context, reached);
    return flow_linear(p, initial, times, count, prec, receive, context, reached);
}

bool flow_linear_domain(const struct flow_parameters *p, arb_srcptr initial)
{
    return arb_is_positive(p->Omega) && arb_is_positive(p->L_ref) && arb_is_finite(p->Omega)
           && arb_is_finite(p->L_ref) && arb_is_finite(p->C1) && arb_is_finite(p->C2)
           && _arb_vec_is_finite(initial, FLOW_STATE);
}

bool flow_nonlinear_domain(const struct flow_parameters *p, arb_srcptr initial)
{
    SCOPE(arb, square);
    arb_dot(square, NULL, 0, initial, 1, initial, 1, FLOW_STATE / 2, 64);
    return flow_linear_domain(p, initial) && arb_is_positive(square)
                 && arb_is_positive(p->k_c) && arb_is_positive(p->m1) && arb_is_positive(p->m2)
                 && arb_is_finite(p->k_c) && arb_is_finite(p->m1) && arb_is_finite(p->m2);
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

bool flow_in_reach(const struct flow_parameters *p, const fmpq *times, slong count, bool by_steps)
{
    SCOPE(arb, radians, reach);
    arb_set_fmpq(radians, times + count - 1, 64);
    arb_mul(radians, radians, p->Omega, 64);
    arb_abs(radians, radians);
    arb_set_d(reach, by_steps ? RK4_REACH : FLOW_REACH);
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

/* ---- what symmetry keeps ---- */

void flow_settle(arb_srcptr initial, bool at_equilibrium, arb_ptr state)
{
    bool zero[3]; /* the pair neither is nor moves off the origin along this axis */
    for (int i = 0; i < 3; i++)
        zero[i] = arb_is_zero(initial + i) && arb_is_zero(initial + i + 3);
    for (int i = 0; i < 3; i++)
        if (i == 2 ? zero[2] : zero[0] && zero[1]) {
            arb_zero(state + i);
            arb_zero(state + i + 3);
        }
    if (at_equilibrium && zero[1] && zero[2] && arb_is_zero(initial + 3))
        _arb_vec_set(state, initial, FLOW_STATE);
}

bool is_equilibrium(const fmpq_t m1, const fmpq_t m2, const fmpq_t L_ref, const fmpq_t x1)
{
    SCOPE(fmpq, a, b);
    fmpq_add(a, m1, m2);
    fmpq_mul(a, a, x1);
    fmpq_abs(a, a);
    fmpq_mul(b, m2, L_ref);
    return fmpq_equal(a, b);
}
