#include "conform/kinds.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/*
 * Both motions in binary64, integrated as others do it, with one step, perhaps with the other sign of one term: where that makes
 * of the vectors what was answered, right or wrong, the mistake has its name.
 */
enum { TERMS = 6 };

static const char *const coupling_terms[2][TERMS] = {
    {"the radial Coriolis term 2 Omega y1_dot", "3 Omega^2 x1", "the along-track Coriolis term -2 Omega x1_dot", "-Omega^2 z1",
     "the charges' force", "C2 L_dot in the charge law"},
    {"-2 Omega/L_ref dL_dot in psi_ddot", "-3 Omega^2 psi", "-4 Omega^2 theta", "-C2 dL_dot", "2 Omega L_ref psi_dot in dL_ddot",
     "-(C1 - 9 Omega^2) dL"}};

/* What somebody may have done: a term's sign (-1: none), Euler's or the classical method, and its step in s, or in the steps h that are given. */
struct hypothesis {
    bool linear, in_h;
    int turned, stages;
    double step;
};

/* Inputs in the sheet's order: Omega L_ref C1 C2 t and the state, of the nonlinear motion k_c m1 m2 after Omega; the last is h. */
static void rate_linear(const double *x, const double s[TERMS], const double y[6], double rate[6])
{
    const double W = x[0], L_ref = x[1], C1 = x[2], C2 = x[3];
    rate[3] = -s[0] * 2.0 * W / L_ref * y[5] - s[1] * 3.0 * W * W * y[0];
    rate[4] = -s[2] * 4.0 * W * W * y[1];
    rate[5] = -s[3] * C2 * y[5] + s[4] * 2.0 * W * L_ref * y[3] - s[5] * (C1 - 9.0 * W * W) * y[2];
}

/* (3) closed by (7) and (18), length and its rate from the place of craft 1. */
static void rate_nonlinear(const double *x, const double s[TERMS], const double y[6], double rate[6])
{
    const double W = x[0], k_c = x[1], m1 = x[2], m2 = x[3], L_ref = x[4], C1 = x[5], C2 = x[6];
    const double both = 1.0 + m1 / m2, reduced = m1 * m2 / (m1 + m2);
    const double r = sqrt(y[0] * y[0] + y[1] * y[1] + y[2] * y[2]), L = both * r;
    const double L_dot = both * (y[0] * y[3] + y[1] * y[4] + y[2] * y[5]) / r;
    const double Q = -reduced * L_ref * L_ref / k_c * (3.0 * W * W * L_ref + C1 * (L - L_ref) + s[5] * C2 * L_dot);
    const double force = s[4] * k_c / m1 * Q * both / (L * L * L);
    rate[3] = s[0] * 2.0 * W * y[4] + s[1] * 3.0 * W * W * y[0] + force * y[0];
    rate[4] = -s[2] * 2.0 * W * y[3] + force * y[1];
    rate[5] = -s[3] * W * W * y[2] + force * y[2];
}

static void take_step(const struct hypothesis *p, const double *x, const double signs[TERMS], double h, double y[6])
{
    static const double from[] = {0.0, 0.5, 0.5, 1.0}, classical[] = {1.0 / 6.0, 1.0 / 3.0, 1.0 / 3.0, 1.0 / 6.0};
    double rate[6] = {0.0}, at[6], sum[6] = {0.0};
    for (int k = 0; k < p->stages; k++) {
        for (int i = 0; i < 6; i++)
            at[i] = y[i] + from[k] * h * rate[i];
        memcpy(rate, at + 3, 3 * sizeof *rate);
        (p->linear ? rate_linear : rate_nonlinear)(x, signs, at, rate);
        for (int i = 0; i < 6; i++)
            sum[i] += (p->stages == 1 ? 1.0 : classical[k]) * h * rate[i];
    }
    for (int i = 0; i < 6; i++)
        y[i] += sum[i];
}

static void integrate(const struct hypothesis *p, const double *x, double steps, double y[6])
{
    const double *initial = x + (p->linear ? 5 : 8);
    double signs[TERMS];
    for (int i = 0; i < TERMS; i++)
        signs[i] = i == p->turned ? -1.0 : 1.0;
    memcpy(y, initial, 6 * sizeof *y);
    for (int n = 0; n < (int)steps; n++)
        take_step(p, x, signs, initial[-1] / steps, y);
}

/* The largest difference of two states; infinite where one is no number. */
static double state_distance(const struct evidence *v, int f, const double a[6], const double b[6])
{
    double most = 0.0;
    for (int i = 0; i < 6; i++) {
        const double off = fabs(a[i] - b[i]) / motion_unit(v->section, v->x[f], i);
        most = isnan(off) ? INFINITY : fmax(most, off);
    }
    return most;
}

/* Whether it ends where the answer is: of a wrong one by far closer than the truth does, of a right one within the digits due. */
static bool ends_there(const struct evidence *v, int f, const struct hypothesis *p, double steps)
{
    static const double nowhere[6];
    const double *x = v->x[f];
    double y[6];
    integrate(p, x, steps, y);
    const double off = state_distance(v, f, y, v->y[f]), was = state_distance(v, f, v->exact[f], v->y[f]);
    const double scale = fmax(state_distance(v, f, x + (p->linear ? 5 : 8), nowhere), state_distance(v, f, v->exact[f], nowhere));
    if (v->records[f]->outcome == OUTCOME_RIGHT)
        return off <= 2.0 * pow(10.0, -v->digits) * scale;
    return off <= fmin(0.1 * was, fmax(1e-3 * was, 1e-12 * scale)); /* binary64 loses three digits in thousands of steps */
}

/* Every vector that takes few enough steps; failing ones of two times among them, for one time tells no step. */
static bool fits_all(const struct evidence *v, const struct hypothesis *p)
{
    enum { MOST_FOLLOWED = 50000 };
    const int at = p->linear ? 4 : 7;
    double first = 0.0;
    bool two = false;
    for (int f = 0; f < v->count; f++) {
        const double t = fabs(v->x[f][at]), steps = round(t / p->step / (p->in_h ? v->x[f][at + 7] : 1.0));
        if (!(steps >= 1.0 && steps <= MOST_FOLLOWED) || isnan(v->y[f][0]))
            continue;
        if (clock() >= v->until || !ends_there(v, f, p, steps))
            return false;
        if (v->records[f]->outcome == OUTCOME_RIGHT)
            continue;
        two = two || (first > 0.0 && t != first); /* NOLINT: the same binary64 */
        first = first > 0.0 ? first : t;
    }
    return two;
}

void kind_of_motion(const struct evidence *v, char *text, size_t size)
{
    static const double lengths[] = {1.0, 2.0, 5.0, 10.0, 20.0, 30.0, 50.0, 60.0, 100.0, 200.0, 300.0, 500.0, 600.0, 1000.0};
    const enum method method = v->section->method;
    struct hypothesis p = {.linear = method == METHOD_FLOW_LINEAR || method == METHOD_RK4_LINEAR, .in_h = method >= METHOD_RK4_LINEAR,
                           .stages = 4, .step = 1.0};
    for (p.turned = 0; p.turned < TERMS; p.turned++)
        if (fits_all(v, &p)) {
            snprintf(text, size, "%s with the other sign", coupling_terms[p.linear][p.turned]);
            return;
        }
    p.turned = -1;
    for (size_t k = 0; k < 2 * sizeof lengths / sizeof *lengths; k++) {
        p.stages = k % 2 ? 4 : 1;
        p.step = lengths[k / 2];
        if (fits_all(v, &p)) {
            snprintf(text, size, "%s method with steps of %g %s", k % 2 ? "the classical Runge-Kutta" : "Euler's", p.step, p.in_h ? "h" : "s");
            return;
        }
    }
}
