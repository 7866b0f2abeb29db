#include "conform/kinds.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/*
 * Both motions in binary64, integrated as others do it, with one step, perhaps with the other sign of one term: where that makes
 * of the vectors what was answered, right or wrong, the mistake has its name.
 */
enum { TERMS = 6, MOST_FOLLOWED = 50000 };

static const char *const coupling_terms[2][TERMS] = {
    {"the radial Coriolis term 2 Omega y1_dot", "3 Omega^2 x1", "the along-track Coriolis term -2 Omega x1_dot", "-Omega^2 z1",
     "the charges' force", "C2 L_dot in the charge law"},
    {"-2 Omega/L_ref dL_dot in psi_ddot", "-3 Omega^2 psi", "-4 Omega^2 theta", "-C2 dL_dot", "2 Omega L_ref psi_dot in dL_ddot",
     "-(C1 - 9 Omega^2) dL"}};

/* Explicit Runge-Kutta methods, each stage from the one before it alone, and as many of them as the order. */
static const struct integrator {
    const char *name;
    int stages;
    double from[4], weights[4];
} euler = {"Euler's method", 1, {0.0}, {1.0}},
  classical = {"the classical Runge-Kutta method", 4, {0.0, 0.5, 0.5, 1.0}, {1.0 / 6.0, 1.0 / 3.0, 1.0 / 3.0, 1.0 / 6.0}};

/* What somebody may have done: a term's sign (-1: none), a method, and its step in s, or in the steps h that are given. */
struct hypothesis {
    bool linear, in_h;
    int turned;
    const struct integrator *method;
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
    double rate[6] = {0.0}, at[6], sum[6] = {0.0};
    for (int k = 0; k < p->method->stages; k++) {
        for (int i = 0; i < 6; i++)
            at[i] = y[i] + p->method->from[k] * h * rate[i];
        memcpy(rate, at + 3, 3 * sizeof *rate);
        (p->linear ? rate_linear : rate_nonlinear)(x, signs, at, rate);
        for (int i = 0; i < 6; i++)
            sum[i] += p->method->weights[k] * h * rate[i];
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

/* The largest difference of two states, lengths over L_ref and time in radians; infinite where one is no number. */
static double state_distance(const struct hypothesis *p, const double *x, const double a[6], const double b[6])
{
    double most = 0.0;
    for (int i = 0; i < 6; i++) {
        const double off = fabs(a[i] - b[i]) / ((p->linear && i % 3 < 2 ? 1.0 : x[p->linear ? 1 : 4]) * (i < 3 ? 1.0 : x[0]));
        most = isnan(off) ? INFINITY : fmax(most, off);
    }
    return most;
}

/* The time of a vector, in what the step is in. */
static double time_of(const struct evidence *v, int f, const struct hypothesis *p)
{
    const int at = p->linear ? 4 : 7;
    return fabs(v->x[f][at]) / (p->in_h ? v->x[f][at + 7] : 1.0);
}

/* Whether it ends where the answer is: of a wrong one by far closer than the truth does, of a right one within the digits due. */
static bool ends_there(const struct evidence *v, int f, const struct hypothesis *p, double steps)
{
    static const double nowhere[6];
    const double *x = v->x[f];
    double y[6];
    integrate(p, x, steps, y);
    const double off = state_distance(p, x, y, v->y[f]), was = state_distance(p, x, v->exact[f], v->y[f]);
    const double scale = fmax(state_distance(p, x, x + (p->linear ? 5 : 8), nowhere), state_distance(p, x, v->exact[f], nowhere));
    if (v->records[f]->outcome == OUTCOME_RIGHT)
        return off <= 2.0 * pow(10.0, -v->digits) * scale;
    return off <= fmin(0.1 * was, fmax(1e-3 * was, 1e-12 * scale)); /* binary64 loses three digits in thousands of steps */
}

/*
 * The step, of two digits, with which the first failing motion is as far off as the answer: errors go with that power of it
 * which is the method's order.
 */
static double likely_step(const struct evidence *v, struct hypothesis *p)
{
    double step = p->in_h ? 2.0 : 10.0, y[6];
    char rounded[20];
    int f = 0;
    while (f < v->count && (v->records[f]->outcome == OUTCOME_RIGHT || !(time_of(v, f, p) > 0.0)))
        f++;
    for (int i = 0; i < 5 && f < v->count; i++) {
        const double t = time_of(v, f, p), steps = fmax(1.0, round(t / step));
        if (!(steps <= MOST_FOLLOWED) || clock() >= v->until)
            return 0.0;
        integrate(p, v->x[f], steps, y);
        const double off = state_distance(p, v->x[f], v->y[f], v->exact[f]) / state_distance(p, v->x[f], y, v->exact[f]);
        step = t / steps * pow(off, 1.0 / p->method->stages);
    }
    snprintf(rounded, sizeof rounded, "%.2g", step);
    return strtod(rounded, NULL);
}

/* Every vector that takes few enough steps; failing ones of two times among them, for one time tells no step. */
static bool fits_all(const struct evidence *v, const struct hypothesis *p)
{
    double first = 0.0;
    bool two = false;
    for (int f = 0; f < v->count; f++) {
        const double t = time_of(v, f, p), steps = round(t / p->step);
        if (!(steps >= 1.0 && steps <= MOST_FOLLOWED))
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
    const enum method method = v->section->method;
    struct hypothesis p = {.in_h = method >= METHOD_RK4_LINEAR};
    p.linear = method == METHOD_FLOW_LINEAR || method == METHOD_RK4_LINEAR;
    *text = '\0';
    for (int k = 0; k < TERMS + 2 && *text == '\0'; k++) {
        p.turned = k < TERMS ? k : -1;
        p.method = k == TERMS ? &euler : &classical;
        p.step = k < TERMS ? 1.0 : likely_step(v, &p);
        if (!(p.step > 0.0) || !fits_all(v, &p))
            continue;
        if (k < TERMS)
            snprintf(text, size, "%s with the other sign", coupling_terms[p.linear][k]);
        else
            snprintf(text, size, "%s with steps of %.3g %s", p.method->name, p.step, p.in_h ? "h" : "s");
    }
}
