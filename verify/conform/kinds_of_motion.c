#include "conform/kinds.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/*
 * Both motions in binary64, integrated as others do it, with one step and a sign for each term: where that makes of two
 * failing vectors what was answered, the mistake has its name.
 */
enum { TERMS = 6, MOST_STEPS = 20000 };

struct model {
    bool linear;
    double Omega, k_c, m1, m2, L_ref, C1, C2, sign[TERMS];
};

static const char *const terms[2][TERMS] = {
    {"the radial Coriolis term 2 Omega y1_dot", "3 Omega^2 x1", "the along-track Coriolis term -2 Omega x1_dot", "-Omega^2 z1",
     "the charges' force", "C2 L_dot in the charge law"},
    {"-2 Omega/L_ref dL_dot in psi_ddot", "-3 Omega^2 psi", "-4 Omega^2 theta", "-C2 dL_dot", "2 Omega L_ref psi_dot in dL_ddot",
     "-(C1 - 9 Omega^2) dL"}};

static void rate_linear(const struct model *m, const double y[6], double rate[6])
{
    const double W = m->Omega, *s = m->sign;
    rate[3] = -s[0] * 2.0 * W / m->L_ref * y[5] - s[1] * 3.0 * W * W * y[0];
    rate[4] = -s[2] * 4.0 * W * W * y[1];
    rate[5] = -s[3] * m->C2 * y[5] + s[4] * 2.0 * W * m->L_ref * y[3] - s[5] * (m->C1 - 9.0 * W * W) * y[2];
}

/* (3) closed by (7) and (18), length and its rate from the place of craft 1. */
static void rate_nonlinear(const struct model *m, const double y[6], double rate[6])
{
    const double W = m->Omega, *s = m->sign, both = 1.0 + m->m1 / m->m2, reduced = m->m1 * m->m2 / (m->m1 + m->m2);
    const double r = sqrt(y[0] * y[0] + y[1] * y[1] + y[2] * y[2]), L = both * r, L_ref = m->L_ref;
    const double L_dot = both * (y[0] * y[3] + y[1] * y[4] + y[2] * y[5]) / r;
    const double Q = -3.0 * W * W * L_ref * L_ref * L_ref / m->k_c * reduced -
                     reduced * L_ref * L_ref / m->k_c * (m->C1 * (L - L_ref) + s[5] * m->C2 * L_dot);
    const double force = s[4] * m->k_c / m->m1 * Q * both / (L * L * L);
    rate[3] = s[0] * 2.0 * W * y[4] + s[1] * 3.0 * W * W * y[0] + force * y[0];
    rate[4] = -s[2] * 2.0 * W * y[3] + force * y[1];
    rate[5] = -s[3] * W * W * y[2] + force * y[2];
}

static void rate_of(const struct model *m, const double y[6], double rate[6])
{
    memcpy(rate, y + 3, 3 * sizeof *rate);
    (m->linear ? rate_linear : rate_nonlinear)(m, y, rate);
}

/* Explicit Runge-Kutta methods of four stages at most, each stage from the one before it alone. */
struct integrator {
    const char *name;
    int stages;
    double from[4], weights[4];
};

static const struct integrator integrators[] = {
    {"Euler's method", 1, {0.0}, {1.0}},
    {"the midpoint method", 2, {0.0, 0.5}, {0.0, 1.0}},
    {"Heun's method", 2, {0.0, 1.0}, {0.5, 0.5}},
    {"the classical Runge-Kutta method", 4, {0.0, 0.5, 0.5, 1.0}, {1.0 / 6.0, 1.0 / 3.0, 1.0 / 3.0, 1.0 / 6.0}},
};
enum { CLASSICAL = 3, INTEGRATORS = 4 };

static void take_step(const struct model *m, const struct integrator *with, double h, double y[6])
{
    double rate[6] = {0.0}, at[6], sum[6] = {0.0};
    for (int k = 0; k < with->stages; k++) {
        for (int i = 0; i < 6; i++)
            at[i] = y[i] + with->from[k] * h * rate[i];
        rate_of(m, at, rate);
        for (int i = 0; i < 6; i++)
            sum[i] += with->weights[k] * h * rate[i];
    }
    for (int i = 0; i < 6; i++)
        y[i] += sum[i];
}

static double input_of(const struct evidence *v, int f, const char *name)
{
    for (int i = 0; i < v->section->input_count; i++)
        if (strcmp(v->section->inputs[i]->name, name) == 0)
            return v->x[f][i];
    return 0.0;
}

static int place_of_t(const struct section *s)
{
    int i = 0;
    while (strcmp(s->inputs[i]->name, "t") != 0)
        i++;
    return i;
}

/* Whether it ends where the answer is, by far closer than the truth does. */
static bool ends_there(const struct evidence *v, int f, struct model *m, const struct integrator *with, double h)
{
    const int at = place_of_t(v->section);
    const double t = v->x[f][at], steps = round(fabs(t / h));
    double y[6], off = 0.0, was = 0.0;
    memcpy(y, v->x[f] + at + 1, sizeof y);
    m->Omega = input_of(v, f, "Omega");
    m->k_c = input_of(v, f, "k_c");
    m->m1 = input_of(v, f, "m1");
    m->m2 = input_of(v, f, "m2");
    m->L_ref = input_of(v, f, "L_ref");
    m->C1 = input_of(v, f, "C1");
    m->C2 = input_of(v, f, "C2");
    if (!(steps >= 1.0 && steps <= MOST_STEPS))
        return false;
    for (int n = 0; n < (int)steps; n++)
        take_step(m, with, t / steps, y);
    for (int i = 0; i < 6; i++) {
        const double unit = (m->linear && i % 3 < 2 ? 1.0 : m->L_ref) * (i < 3 ? 1.0 : m->Omega);
        off = fmax(off, fabs(y[i] - v->y[f][i]) / unit);
        was = fmax(was, fabs(v->exact[f][i] - v->y[f][i]) / unit);
    }
    return off <= 1e-3 * was; /* NaN passes neither */
}

/* The failing vector with the least time from 0 that is more than so much; -1: there is none. */
static int shortest(const struct evidence *v, double more_than)
{
    const int at = place_of_t(v->section);
    int found = -1;
    for (int f = 0; f < v->count; f++)
        if (fabs(v->x[f][at]) > more_than && (found < 0 || fabs(v->x[f][at]) < fabs(v->x[found][at])))
            found = f;
    return found;
}

static bool both_end_there(const struct evidence *v, const int two[2], struct model *m, const struct integrator *with, double h)
{
    return clock() < v->until && ends_there(v, two[0], m, with, h > 0.0 ? h : -h * input_of(v, two[0], "h")) &&
           ends_there(v, two[1], m, with, h > 0.0 ? h : -h * input_of(v, two[1], "h"));
}

/* Steps in s, or, below zero, in steps that are given. */
void kind_of_motion(const struct evidence *v, char *text, size_t size)
{
    static const double of_flows[] = {1.0, 10.0, 50.0, 60.0, 100.0, 0.1, 1000.0}, of_method[] = {-1.0, -2.0, -0.5};
    const bool method = v->section->method >= METHOD_RK4_LINEAR;
    const double *steps = method ? of_method : of_flows;
    struct model m = {.linear = v->section->method == METHOD_FLOW_LINEAR || v->section->method == METHOD_RK4_LINEAR};
    int two[2] = {shortest(v, 0.0), -1};
    *text = '\0';
    for (int i = 0; i < TERMS; i++)
        m.sign[i] = 1.0;
    if (two[0] >= 0)
        two[1] = shortest(v, fabs(v->x[two[0]][place_of_t(v->section)]));
    if (two[1] < 0) /* one time tells no step */
        return;
    for (int i = 0; i < TERMS; i++) {
        m.sign[i] = -1.0;
        if (both_end_there(v, two, &m, &integrators[CLASSICAL], method ? -1.0 : 1.0)) {
            snprintf(text, size, "%s with the other sign", terms[m.linear][i]);
            return;
        }
        m.sign[i] = 1.0;
    }
    for (int k = 0; k < (method ? 3 : 7); k++)
        for (int i = 0; i < INTEGRATORS; i++)
            if (both_end_there(v, two, &m, &integrators[i], steps[k])) {
                if (method)
                    snprintf(text, size, "%s with steps of %g h", integrators[i].name, -steps[k]);
                else
                    snprintf(text, size, "%s with steps of %g s", integrators[i].name, steps[k]);
                return;
            }
}
