/*
 * The mistakes of the sheet, made once more: what somebody who makes them computes, from ref/ and by hand, is what the
 * sheet says of them. The oracle's diagnosis is worth as much as these formulas.
 */
#include "tests/run.h"
#include "tests/paper.h"

#include <stdlib.h>
#include <string.h>

#include "formula/arithmetic.h"
#include "text/flint.h"
#include "evaluate/reference.h"
#include "sheet/known_mistakes.h"

enum { MOST = 40 };

static const double pi = 3.14159265358979323846;

/* A mistake at work: x are the inputs, and y becomes the wrong outputs; or x those of another operation. */
struct wrong {
    const char *section, *mistake, *other; /* other: the operation that x is for in the end */
    double x[MOST], y[MOST];
    bool known;
};

static void right(struct wrong *w)
{
    reference_find(w->other)(w->x, w->y);
}

static bool is(struct wrong *w, const char *section, const char *mistake)
{
    const bool this = strcmp(w->section, section) == 0 && strcmp(w->mistake, mistake) == 0;
    w->known |= this;
    return this;
}

/* Something else goes in; something else comes out; another operation altogether. */
#define GOES_IN(section, mistake, change) if (is(w, section, mistake)) { change; right(w); }
#define COMES_OUT(section, mistake, change) if (is(w, section, mistake)) { right(w); change; }
#define IS_TAKEN_FOR(section, mistake, id) if (is(w, section, mistake)) { w->other = id; right(w); }

static void swap(double *a, double *b)
{
    const double c = *a;
    *a = *b;
    *b = c;
}

static void scale(double *y, int count, double factor)
{
    for (int i = 0; i < count; i++)
        y[i] *= factor;
}

static double norm3(const double *r) { return sqrt(r[0] * r[0] + r[1] * r[1] + r[2] * r[2]); }
static double dot3(const double *a, const double *b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
static double whole(const double *m) { return (m[0] + m[1]) / m[1]; } /* L over the distance of craft 1 */
static double reduced(const double *m) { return m[0] * m[1] / (m[0] + m[1]); }

/* ---- (2): each pair's force times a factor of its distance and the Debye length ---- */

typedef double factor_function(double r, double lambda_d);
static double distance(double r, double lambda_d) { return r + 0 * lambda_d; }
static double other_sign(double r, double lambda_d) { return exp(2 * r / lambda_d); }
static double attraction(double r, double lambda_d) { return -1 + 0 * r * lambda_d; }

static void pair_by_pair(struct wrong *w, factor_function *factor)
{
    double alone[MOST], x[MOST], y[MOST];
    memcpy(x, w->x, sizeof x);
    x[4] = x[12] = x[20] = 0;
    reference_find("eq02")(x, alone);
    memcpy(w->y, alone, sizeof alone);
    for (int third = 0; third < 3; third++) {
        const double *a = w->x + 5 + 8 * ((third + 1) % 3), *b = w->x + 5 + 8 * ((third + 2) % 3);
        const double r = norm3((const double[]){a[0] - b[0], a[1] - b[1], a[2] - b[2]});
        memcpy(x, w->x, sizeof x);
        x[4 + 8 * third] = 0;
        reference_find("eq02")(x, y);
        for (int i = 0; i < 9; i++)
            w->y[i] += factor(r, w->x[2]) * (y[i] - alone[i]);
    }
}

static void formation(struct wrong *w)
{
    double *x = w->x, *y = w->y;
    GOES_IN("eq02", "no shielding", x[2] = INFINITY)
    GOES_IN("eq02", "the third craft left out", x[20] = 0)
    COMES_OUT("eq02", "inverse square of a vector's length", pair_by_pair(w, distance))
    COMES_OUT("eq02", "shielding by the exponent's other sign", pair_by_pair(w, other_sign))
    COMES_OUT("eq02", "attraction for repulsion", pair_by_pair(w, attraction))
    GOES_IN("eq03", "attraction for repulsion", x[4] = -x[4])
    GOES_IN("eq03", "no charge", x[4] = 0)
    GOES_IN("eq03", "distance from the centre of mass for L", x[4] *= pow(whole(x + 2), 3))
    COMES_OUT("eq04", "the other side left out", scale(y, 3, -1))
    COMES_OUT("eq05", "the masses at equal distances", y[0] = x[2] / 2; y[1] = -x[2] / 2)
    COMES_OUT("eq07", "without the factor of 3", y[0] /= 3)
    COMES_OUT("eq07", "L^2 for L^3", y[0] /= x[4])
    COMES_OUT("eq07", "repulsion for attraction", y[0] = -y[0])
    COMES_OUT("eq07", "the total for the reduced mass", y[0] *= (x[2] + x[3]) / reduced(x + 2))
}

/* ---- kinematics and separation ---- */

static void places(struct wrong *w)
{
    double *x = w->x, *y = w->y;
    COMES_OUT("eq09", "transposed", swap(y + 1, y + 3); swap(y + 2, y + 6); swap(y + 5, y + 7))
    IS_TAKEN_FOR("eq10", "small angles", "eq10lin")
    IS_TAKEN_FOR("eq10lin", "the exact rotation", "eq10")
    COMES_OUT("eq10inv", "atan(y1/x1) for atan2", y[1] = atan(x[3] / x[2]))
    COMES_OUT("eq10inv", "distance from the centre of mass for L", y[0] = norm3(x + 2))
    IS_TAKEN_FOR("eq11exact", "small angles", "eq11")
    IS_TAKEN_FOR("eq11", "the exact rotation", "eq11exact")
    GOES_IN("eq11exact", "L_dot left out", x[5] = 0)
    GOES_IN("eq11", "L_dot left out", x[5] = 0)
    COMES_OUT("eq12", "the square of it", y[0] *= y[0])
    GOES_IN("eq12", "z left out", x[2] = x[5] = 0)
    COMES_OUT("eq13", "distance from the centre of mass for L", y[0] = norm3(x + 2))
    COMES_OUT("eq13", "the square of it", y[0] *= y[0])
}

/* (14) without v . v and L_dot^2: the acceleration of (3) along the line. */
static double along_the_line(const double *x)
{
    double a[3];
    reference_find("eq03")(x, a);
    return whole(x + 2) * dot3(x + 5, a) / norm3(x + 5);
}

static void separation(struct wrong *w)
{
    double *x = w->x, *y = w->y;
    COMES_OUT("eq14", "no centrifugal term", y[0] = along_the_line(x))
    COMES_OUT("eq14", "L_dot^2 not taken away", y[0] += whole(x + 2) * pow(dot3(x + 5, x + 8), 2) / pow(norm3(x + 5), 3))
    GOES_IN("eq14", "attraction for repulsion", x[4] = -x[4])
    COMES_OUT("eq14", "not divided by L", y[0] *= whole(x + 2) * norm3(x + 5))
    GOES_IN("eq15", "attraction for repulsion", x[6] = -x[6])
    GOES_IN("eq15", "no charge", x[6] = 0)
    COMES_OUT("eq15", "the small-angle 9 Omega^2 for 3 Omega^2", y[0] += 6 * x[0] * x[0] * x[4])
    COMES_OUT("eq17", "3 Omega^2 for 9 Omega^2", y[0] -= 6 * x[0] * x[0] * x[6])
    GOES_IN("eq17", "attraction for repulsion", x[7] = -x[7])
    GOES_IN("eq18", "the rate left out", x[7] = 0)
    COMES_OUT("eq18", "feedback with the other sign", y[0] = -y[0])
    COMES_OUT("eq19", "3 Omega^2 for 9 Omega^2", y[0] -= 6 * x[0] * x[0] * x[4])
    COMES_OUT("eq19", "the terms on the left of the equation", y[0] = -y[0])
    GOES_IN("eq19", "the rate left out", x[5] = 0)
    COMES_OUT("eq21", "both charges of one sign", y[1] = y[0])
    COMES_OUT("eq21", "the charges swapped", swap(y, y + 1))
    GOES_IN("eq21", "dQ left out", x[1] = 0)
}

/* ---- attitude ---- */

static void turning(struct wrong *w)
{
    double *x = w->x, *y = w->y;
    COMES_OUT("eq25", "small angles", y[0] = -x[0] * x[1]; y[2] = x[0])
    COMES_OUT("eq26", "small angles", y[0] = 0; y[2] = x[1])
    IS_TAKEN_FOR("eq27", "small angles", "eq28")
    COMES_OUT("eq27", "the orbit rate left out", y[0] = -sin(x[1]) * x[2]; y[2] = cos(x[1]) * x[2])
    IS_TAKEN_FOR("eq28", "no small angles", "eq27")
    COMES_OUT("eq28", "the orbit rate left out", y[0] = 0; y[2] = x[2])
    COMES_OUT("eq29", "the orbit rate left out", y[0] = 0)
    COMES_OUT("eq29", "the accelerations swapped", swap(y + 1, y + 2))
    COMES_OUT("eq30", "products of inertia with the other sign", scale(y + 1, 2, -1); y[4] = -y[4])
    GOES_IN("eq30", "the second craft left out", x[5] = x[6] = x[7] = 0)
    COMES_OUT("eq32", "the total for the reduced mass", y[0] = (x[0] + x[1]) * x[2] * x[2])
    COMES_OUT("eq32", "L for L^2", y[0] /= x[2])
    COMES_OUT("eq34", "without the factor of 2", y[0] /= 2)
    COMES_OUT("eq34", "the total for the reduced mass", y[0] = 2 * (x[0] + x[1]) * x[2] * x[3])
    COMES_OUT("eq36", "theta turned first", y[1] = -x[0] * cos(x[2]) * sin(x[1]); y[2] = x[0] * sin(x[2]))
    COMES_OUT("eq37", "R_c^3 for R_c^5", scale(y, 3, pow(norm3(x + 1), 2)))
    COMES_OUT("eq37", "torque with the other sign", scale(y, 3, -1))
    COMES_OUT("eq37", "without the factor of 3", scale(y, 3, 1. / 3))
    COMES_OUT("eq38", "the square of it", y[0] *= y[0])
    COMES_OUT("eq39", "torque with the other sign", scale(y, 3, -1))
    COMES_OUT("eq39", "the angles swapped", swap(y + 1, y + 2))
}

/* ---- the linear model ---- */

static void model(struct wrong *w)
{
    double *x = w->x, *y = w->y;
    COMES_OUT("eq40", "pitch like yaw", y[0] *= 0.75)
    COMES_OUT("eq40", "psi before theta", swap(y, y + 1))
    COMES_OUT("eq40", "the terms on the left of the equation", scale(y, 3, -1))
    GOES_IN("eq40", "L_ref left out", x[1] = 1)
    GOES_IN("eq40", "the rate left out", x[7] = 0)
    COMES_OUT("eq41", "descending coefficients", swap(y, y + 4); swap(y + 1, y + 3))
    COMES_OUT("eq42", "n for C1", y[0] = x[1] - 9)
    COMES_OUT("eq42", "the inequality the other way round", y[2] = 1 - y[2])
    COMES_OUT("eq42", "one condition alone", y[2] = y[0] > 0)
    COMES_OUT("eq43", "Omega for Omega^2", y[0] = x[1] * x[0])
    COMES_OUT("eq43", "n - 9 for n", y[0] = (x[1] - 9) * x[0] * x[0])
    COMES_OUT("eq44", "n for n - 9", y[0] = 2 * x[0] * sqrt(x[1]))
    COMES_OUT("eq44", "without the factor of 2", y[0] /= 2)
}

/* A motion stands in another's place, or has other inputs: h is the last one, t the fifth or eighth. */
#define MOVES_AS(section, mistake, id, change) if (is(w, section, mistake)) { w->other = id; change; }

static void motion(struct wrong *w)
{
    double *x = w->x;
    MOVES_AS("flow_linear", "Runge-Kutta steps of 100 s", "rk4_linear", x[11] = 100)
    MOVES_AS("flow_linear", "backwards in time", "flow_linear", x[4] = -x[4])
    MOVES_AS("flow_linear", "L for L_ref", "flow_linear", x[1] += x[7])
    MOVES_AS("flow_nonlinear", "Runge-Kutta steps of 100 s", "rk4_nonlinear", x[14] = 100)
    MOVES_AS("flow_nonlinear", "backwards in time", "flow_nonlinear", x[7] = -x[7])
    MOVES_AS("rk4_linear", "the motion itself", "flow_linear", (void)x)
    MOVES_AS("rk4_linear", "a step too many", "rk4_linear", x[4] += x[11])
    MOVES_AS("rk4_linear", "steps of 100 s whatever is given", "rk4_linear", x[11] = 100)
    MOVES_AS("rk4_linear", "L for L_ref", "rk4_linear", x[1] += x[7])
    MOVES_AS("rk4_nonlinear", "the motion itself", "flow_nonlinear", (void)x)
    MOVES_AS("rk4_nonlinear", "a step too many", "rk4_nonlinear", x[7] += x[14])
    MOVES_AS("rk4_nonlinear", "steps of 100 s whatever is given", "rk4_nonlinear", x[14] = 100)
}

/* ---- those that can be made anywhere, each where all that it changes is at hand ---- */

static void anywhere(struct wrong *w)
{
    double *x = w->x, *y = w->y;
    GOES_IN("eq05", "m1 for m2", x[1] = x[0])
    GOES_IN("eq05", "m2 for m1", x[0] = x[1])
    GOES_IN("eq05", "the masses swapped", swap(x, x + 1))
    GOES_IN("eq10", "angles taken as degrees", scale(x + 3, 2, pi / 180))
    COMES_OUT("eq10inv", "angles given in degrees", scale(y + 1, 2, 180 / pi))
    GOES_IN("eq10", "psi with the other sign", x[3] = -x[3])
    COMES_OUT("eq10inv", "psi with the other sign", y[1] = -y[1])
    GOES_IN("eq10", "theta with the other sign", x[4] = -x[4])
    COMES_OUT("eq10inv", "theta with the other sign", y[2] = -y[2])
    GOES_IN("eq10", "psi and theta swapped", swap(x + 3, x + 4))
    COMES_OUT("eq10inv", "psi and theta swapped", swap(y + 1, y + 2))
    GOES_IN("eq26", "psi_dot and theta_dot swapped", swap(x + 1, x + 2))
    GOES_IN("eq26", "psi_dot left out", x[1] = 0)
    GOES_IN("eq19", "C1 and C2 swapped", swap(x + 2, x + 3))
    GOES_IN("eq19", "C1 with the other sign", x[2] = -x[2])
    GOES_IN("eq19", "C2 with the other sign", x[3] = -x[3])
    GOES_IN("eq43", "Omega of Table 1 whatever is given", x[0] = 7.2915e-5)
    GOES_IN("eq07", "k_c of Table 1 whatever is given", x[1] = 8.99e9)
    GOES_IN("eq40", "L_ref of Table 1 whatever is given", x[1] = 10)
    GOES_IN("eq17", "L for L_ref", x[4] += x[6])
    GOES_IN("eq03", "Coriolis terms with the other sign", scale(x + 8, 2, -1))
    GOES_IN("eq02", "charges taken as microcoulombs", x[4] *= 1e-6; x[12] *= 1e-6; x[20] *= 1e-6)
    GOES_IN("eq03", "charges taken as microcoulombs", x[4] *= 1e-12)
    GOES_IN("eq17", "charges taken as microcoulombs", x[7] *= 1e-12)
    GOES_IN("eq21", "charges taken as microcoulombs", scale(x, 2, 1e-12))
    COMES_OUT("eq07", "charges given in microcoulombs", y[0] *= 1e12)
    COMES_OUT("eq18", "charges given in microcoulombs", y[0] *= 1e12)
    COMES_OUT("eq21", "charges given in microcoulombs", scale(y, 2, 1e6))
}

static void make_mistake(struct wrong *w)
{
    formation(w);
    places(w);
    separation(w);
    turning(w);
    model(w);
    motion(w);
    anywhere(w);
}

/* ---- the sheet's word for it ---- */

/* What the mutant makes of the inputs: its outputs, or the inputs of the motion that it ends in. */
static int numbers(const struct section *s, const struct mutation *a)
{
    return a->formulas_end ? s->output_count : a->section->input_count;
}

static void compute(const struct formulas *f, int inputs, const double *x, int outputs, double *y)
{
    struct machine m;
    machine_init(&m, &f->program, &arithmetic_ball, 256);
    for (int i = 0; i < inputs; i++)
        arb_set_d(machine_value(&m, i), x[i]);
    machine_run(&m);
    for (int i = 0; i < outputs; i++)
        y[i] = arf_get_d(arb_midref((arb_ptr)machine_value(&m, f->outputs[i])), ARF_RND_NEAR);
    machine_clear(&m);
}

/*
 * A generic number: what the simulation has, changed a little, and 0 for nothing; by point some of the signs turned. The
 * last point lies just outside the boundary C1 = 9 Omega^2.
 */
static int points(const struct section *s) { return s->input_count + 3; }

static double input(const struct section *s, int i, int point)
{
    const struct quantity *q = s->inputs[i];
    double value = strtod(q->value ? q->value : q->example, NULL);
    if (point == points(s) - 1 && strcmp(q->name, "C1") == 0)
        return 8.5 * pow(input(s, 0, 0), 2); /* whoever has C1 and Omega has Omega first */
    value = (value != 0 ? value : sqrt(q->low * q->high)) * (1.1 + 0.01 * i);
    return q->either_sign && (point == 1 || point == i + 2) ? -value : value;
}

/*
 * The same number, or none for both, a root of what is negative. Of 1000 roundings 3 digits may cancel; it is 1e-13, for
 * what microcoulombs leave of a force is 1e-12 of it.
 */
static bool same(double a, double b)
{
    return isnan(b) ? isnan(a) : fabs(a - b) <= 1000 * 0x1p-53 * fabs(b);
}

/* How many points the mistake was tried at; 0 where this file does not make it in that section. */
static int compare(const struct section *s, const struct known_mistake *mistake, const struct mutation *a)
{
    int tried = 0;
    for (int point = 0; point < points(s); point++) {
        struct wrong w = {.section = s->id, .mistake = mistake->name, .other = s->id};
        double x[MOST] = {0}, y[MOST] = {0};
        for (int i = 0; i < s->input_count; i++)
            x[i] = w.x[i] = input(s, i, point);
        reference_find(s->id)(x, y);
        if (isnan(y[0]) && a->formulas_end)
            continue; /* outside the domain */
        make_mistake(&w);
        if (!w.known)
            return 0;
        const double *due = a->formulas_end ? w.y : w.x;
        ck_assert_str_eq(a->formulas_end ? s->id : w.other, a->formulas_end ? s->id : a->section->id);
        compute(&a->formulas, s->input_count, x, numbers(s, a), y);
        for (int i = 0; i < numbers(s, a); i++)
            ck_assert_msg(same(y[i], due[i]), "%s, %s: number %d is %g, expected %g", s->id, mistake->name, i + 1, y[i], due[i]);
        tried++;
    }
    return tried;
}

/* Whether this file makes the mistake in that section, which the sheet has to do then as well, and in the same way. */
static bool made(const struct section *s, const struct known_mistake *mistake, bool own)
{
    struct wrong w = {.section = s->id, .mistake = mistake->name, .other = s->id};
    struct mutation a;
    struct message why = {""};
    for (int i = 0; i < s->input_count; i++)
        w.x[i] = input(s, i, 0);
    make_mistake(&w);
    if (!w.known)
        return false;
    ck_assert_msg(mutation_init(&a, sheet(), s, mistake, own, &why), "%s, %s: %s", s->id, mistake->name, why.text);
    ck_assert_int_gt(compare(s, mistake, &a), 0);
    mutation_clear(&a);
    return true;
}

EACH(every_mistake_of_an_equation_is_made_right, sheet()->section_count)
{
    const struct section *s = &sheet()->sections[_i];
    for (int k = 0; k < s->mistake_count; k++)
        ck_assert_msg(made(s, &s->mistakes[k], true), "%s, %s: expected in this file", s->id, s->mistakes[k].name);
}

EACH(every_mistake_made_anywhere_is_made_right, sheet()->mistake_count)
{
    const struct known_mistake *mistake = &sheet()->mistakes[_i];
    int places = 0;
    for (int i = 0; i < sheet()->section_count; i++)
        if (sheet()->sections[i].method == METHOD_FORMULA)
            places += made(&sheet()->sections[i], mistake, false);
    ck_assert_msg(places > 0, "%s: expected in this file", mistake->name);
}

/* ---- and nothing mistaken ---- */

/* What is printed, by hand: one mass for both, the absolute value, three times GM. */
static void as_printed(const struct section *s, double *x, double *y)
{
    if (strcmp(s->id, "eq30") == 0)
        for (int i = 2; i < 8; i += 3) { /* each craft with the mass of the first, the other one at the origin */
            double at[8] = {x[0], x[0]}, part[6];
            memcpy(at + 2, x + i, 3 * sizeof *x);
            reference_find("eq30")(at, part);
            for (int k = 0; k < 6; k++)
                y[k] = part[k] + (i > 2 ? y[k] : 0);
        }
    if (strcmp(s->id, "eq21") == 0) {
        y[0] = sqrt(fabs(x[0] + x[1]));
        y[1] = -y[0];
    }
    if (strcmp(s->id, "eq38") == 0)
        y[0] = sqrt(3 * x[0] / pow(x[1], 3));
}

EACH(formulas_are_right_and_misprints_wrong_in_their_way, sheet()->section_count)
{
    const struct section *s = &sheet()->sections[_i];
    double x[MOST] = {0}, y[MOST] = {0}, due[MOST] = {0};
    for (int point = 0; point < points(s) && s->method == METHOD_FORMULA; point++) {
        for (int i = 0; i < s->input_count; i++)
            x[i] = input(s, i, point);
        reference_find(s->id)(x, due);
        compute(&s->corrected, s->input_count, x, s->output_count, y);
        for (int i = 0; i < s->output_count && !isnan(due[0]); i++)
            ck_assert_msg(same(y[i], due[i]), "%s: %s is %g, expected %g", s->id, s->outputs[i]->name, y[i], due[i]);
        if (!s->differs)
            continue;
        as_printed(s, x, due);
        compute(&s->printed, s->input_count, x, s->output_count, y);
        for (int i = 0; i < s->output_count; i++)
            ck_assert_msg(same(y[i], due[i]), "%s printed: %s is %g, expected %g", s->id, s->outputs[i]->name, y[i], due[i]);
    }
}
