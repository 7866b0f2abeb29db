/*
 * Theorem (bounds by doubles). Let u = 2^-52: a sum, product or quotient of binary64 numbers is off by at most u times itself, on
 * machines with extended registers too, or by 2^-1074 where it is subnormal. So
 *
 *   (M1) what is a sum of products of n factors and signs in all is off by at most n u/(1 - n u) times the sum of their absolute
 *        values (rounding, with the longest chain of roundings that a coefficient has);
 *   (M2) a bound that is itself computed from bounds, by chains of at most 2^16 sums and products of numbers >= 0, is a bound
 *        after upward(): times 1 + 2^-30, plus 2^-1000.
 *
 * For all |e_i| <= 1 a polynomial is at most the sum of its coefficients' absolute values, ||x|| = sum of norm. Of a product
 * (x + d_x) (y + d_y) the model keeps the terms of x y to its degree, and its rest takes
 *
 *   (M3) what is cut off: sum of norm_p(x) norm_q(y), p + q beyond the degree
 *   (M4) ||x|| rest_y   (M5) rest_x ||y||   (M6) rest_x rest_y
 *   (M7) the rest that a sum has already
 *   (M8) of numbers that are no binary64, and of models cut to a smaller space, the difference
 *   (M9) of x^(-1/2) and of sine and cosine what stands at the functions
 *
 * Each has a test of its name in tests/motion/test_model.c.
 */
#include "motion/model.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "text/message.h"
#include "text/scope.h"

static const double U = 0x1p-52;

/* (M2) */
static double upward(double x)
{
    return x * (1 + 0x1p-30) + 0x1p-1000;
}

static void *zeros(int count, size_t size)
{
    return memset(xrealloc(NULL, (size_t)count, size), 0, (size_t)count * size);
}

/* ---- monomials ---- */

/* A monomial is its parent times e_last; its own children follow one another, from itself times e_last on. */
struct origin {
    int parent, last, children;
};

/* Monomial b, not one of the last degree, times e_i */
static int times_unknown(const struct origin *from, int b, int i)
{
    if (i >= from[b].last)
        return from[b].children + i - from[b].last;
    return times_unknown(from, times_unknown(from, from[b].parent, i), from[b].last);
}

void space_init(struct space *s, int variables, int degree)
{
    const int n = variables;
    *s = (struct space){.variables = n, .degree = n == 0 ? 0 : degree, .size = 1, .first = {0, 1}};
    int most = 1;
    for (int d = 1; d <= s->degree; d++)
        most = most * (n + d) / d;
    s->exponent = zeros(most * n + 1, 1);
    s->product = zeros(most, sizeof *s->product);
    struct origin *from = zeros(most, sizeof *from);
    for (int b = 0, d = 0; d < s->degree; b++) {
        from[b].children = s->size;
        for (int i = from[b].last; i < n; i++, s->size++) {
            from[s->size] = (struct origin){.parent = b, .last = i};
            memcpy(s->exponent + s->size * n, s->exponent + b * n, (size_t)n);
            s->exponent[s->size * n + i]++;
        }
        if (b + 1 == s->first[d + 1])
            s->first[++d + 1] = s->size;
    }
    for (int a = 0, d = 0; a < s->size; a++) {
        d += a == s->first[d + 1];
        const int beyond = s->first[s->degree - d + 1];
        s->product[a] = zeros(beyond, sizeof **s->product);
        for (int b = 0; b < beyond; b++)
            s->product[a][b] = a == 0 ? b : times_unknown(from, s->product[from[a].parent][b], from[a].last);
    }
    free(from);
}

void space_clear(struct space *s)
{
    for (int a = 0; a < s->size; a++)
        free(s->product[a]);
    free(s->product);
    free(s->exponent);
}

/* ---- models ---- */

void model_init(struct model *m, const struct space *s)
{
    *m = (struct model){.space = s, .c = zeros(s->size, sizeof *m->c)};
}

void model_clear(struct model *m)
{
    free(m->c);
}

struct model *models_init(int count, const struct space *s)
{
    struct model *m = zeros(count, sizeof *m);
    double *c = zeros(count * s->size, sizeof *c);
    for (int i = 0; i < count; i++)
        m[i] = (struct model){.space = s, .c = c + i * s->size};
    return m;
}

void models_clear(struct model *m)
{
    free(m->c);
    free(m);
}

static double norm(const struct model *x)
{
    double sum = 0;
    for (int d = 0; d <= x->space->degree; d++)
        sum += x->norm[d];
    return sum;
}

/* What has grown beyond binary64, NaN then, is not. */
static bool is_zero_model(const struct model *x)
{
    return norm(x) <= 0 && x->rest <= 0;
}

static void zero(struct model *z)
{
    memset(z->c, 0, (size_t)z->space->size * sizeof *z->c);
    memset(z->norm, 0, sizeof z->norm);
    z->rest = 0;
}

static void find_norms(struct model *z)
{
    for (int d = 0; d <= z->space->degree; d++) {
        z->norm[d] = 0;
        for (int b = z->space->first[d]; b < z->space->first[d + 1]; b++)
            z->norm[d] += fabs(z->c[b]);
    }
}

double model_size(const struct model *x)
{
    return is_zero_model(x) ? 0 : upward(norm(x) + x->rest);
}

/* The nearest binary64, and how far x is from it at most (M8) */
static double nearest(double *off, const arb_t x)
{
    SCOPE(arb, d);
    SCOPE(mag, m);
    const double value = arf_get_d(arb_midref(x), ARF_RND_NEAR);
    arb_set_d(d, value);
    arb_sub(d, d, x, 64);
    arb_get_mag(m, d);
    *off += mag_get_d(m);
    return value;
}

void model_set_ball(struct model *z, const arb_t x)
{
    zero(z);
    z->c[0] = nearest(&z->rest, x);
    z->rest = z->rest <= 0 ? 0 : upward(z->rest);
    find_norms(z);
}

void model_set_variable(struct model *z, const arb_t x, const arb_t radius, int i)
{
    model_set_ball(z, x);
    z->c[1 + i] = nearest(&z->rest, radius);
    z->rest = upward(z->rest);
    find_norms(z);
}

void model_set(struct model *z, const struct model *x)
{
    double beyond = x->rest;
    memcpy(z->c, x->c, (size_t)z->space->size * sizeof *z->c);
    for (int d = z->space->degree + 1; d <= x->space->degree; d++)
        beyond += x->norm[d];
    z->rest = beyond <= 0 ? 0 : upward(beyond);
    find_norms(z);
}

/* The part of z += sign x y that lies in the space */
static void multiply_models(struct model *z, int sign, const struct model *x, const struct model *y)
{
    const struct space *s = z->space;
    double *c = z->c;
    for (int d = 0; d <= s->degree; d++)
        for (int a = s->first[d], most = s->first[s->degree - d + 1]; a < s->first[d + 1]; a++) {
            const double factor = sign * x->c[a];
            const int *place = s->product[a];
            for (int b = 0; b < most && factor != 0; b++)
                c[place[b]] += factor * y->c[b];
        }
}

void model_dot(struct model *z, bool add, int sign, const struct model *x, const struct model *y, int count)
{
    const int degree = z->space->degree;
    bool nothing = true;
    if (!add)
        zero(z);
    double rest = z->rest, size = norm(z); /* (M7) */
    for (int j = 0; j < count; j++) {
        const struct model *a = x + j, *b = y - j;
        if (is_zero_model(a) || is_zero_model(b)) /* what is 0 stays 0 */
            continue;
        nothing = false;
        multiply_models(z, sign, a, b);
        for (int p = 0; p <= degree; p++)
            for (int q = degree + 1 - p; q <= degree; q++)
                rest += a->norm[p] * b->norm[q]; /* (M3) */
        rest += norm(a) * b->rest;   /* (M4) */
        rest += a->rest * norm(b);   /* (M5) */
        rest += a->rest * b->rest;   /* (M6) */
        size += norm(a) * norm(b);
    }
    if (nothing)
        return;
    z->rest = upward(rest + (ldexp(count, degree) + 2) * U * size); /* (M1): at most 2^degree pairs make up a monomial */
    find_norms(z);
}

void model_product(struct model *z, const struct model *x, const struct model *y)
{
    MODEL(product, z->space);
    model_dot(&product, false, 1, x, y, 1);
    model_set(z, &product);
}

void model_scale(struct model *z, double factor)
{
    find_norms(z);
    if (is_zero_model(z))
        return;
    for (int b = 0; b < z->space->size; b++)
        z->c[b] *= factor;
    z->rest = upward(fabs(factor) * (z->rest + 2 * U * norm(z))); /* (M1): and one for the factor, which may be 1/k */
    find_norms(z);
}

void model_widen(struct model *z, const mag_t by)
{
    if (!mag_is_zero(by))
        z->rest = upward(z->rest + mag_get_d(by)); /* exact: 30 bits */
}

void model_evaluate(struct model *z, const struct model *x, int count, double h)
{
    double size = 0, rest = 0;
    bool nothing = true;
    zero(z);
    for (int k = count - 1; k >= 0; k--) {
        for (int b = 0; b < z->space->size; b++)
            z->c[b] = z->c[b] * h + x[k].c[b];
        size = size * fabs(h) + norm(x + k);
        rest = rest * fabs(h) + x[k].rest;
        nothing = nothing && is_zero_model(x + k);
    }
    z->rest = nothing ? 0 : upward(rest + 2 * count * U * size); /* (M1) */
    find_norms(z);
}

/* d = x z^2 - 1, but for roundings of 1 where |d| may be 1/2: nearer to 1 none is rounded */
static void find_defect(struct model *d, const struct model *x, const struct model *z)
{
    MODEL(square, z->space);
    model_dot(&square, false, 1, z, z, 1);
    model_dot(d, false, 1, x, &square, 1);
    d->c[0] -= 1;
    find_norms(d);
}

/*
 * (M9) Whatever polynomial z is: with x z^2 = 1 + d, |d| <= e < 1/2 for all e_i, z does not vanish, so that it is positive
 * everywhere if it is at 0; and x^(-1/2) = z (1 + d)^(-1/2) is off from z by at most ||z|| e/(2 (1 - e)).
 */
void model_inverse_root(struct model *z, const struct model *x)
{
    MODEL(last, z->space);
    MODEL(d, z->space);
    zero(z);
    z->c[0] = 1 / sqrt(x->c[0]);
    find_norms(z);
    for (int correct = 1; correct <= 2 * z->space->degree + 2; correct *= 2) { /* Newton's steps: z (1 - d/2) */
        find_defect(&d, x, z);
        model_scale(&d, -0.5);
        model_set(&last, z);
        model_dot(z, true, 1, &last, &d, 1);
        z->rest = 0;
    }
    find_defect(&d, x, z);
    const double e = model_size(&d);
    z->rest = e < 0.5 && z->c[0] > 0 ? upward(norm(z) * e / (2 * (1 - e))) : HUGE_VAL;
}

/*
 * (M9) With x = x_0 + d: the terms of sin(x_0 + d) = sum sin^(k)(x_0) d^k/k! to k = degree, and the rest of the series, at most
 * |d|^n/n!, n = degree + 1, in all.
 */
void model_sine(struct model *z, const struct model *x, int quarters)
{
    MODEL(d, x->space);
    MODEL(power, x->space);
    MODEL(next, x->space);
    MODEL(value, x->space);
    VECTOR(arb, at, 2);
    SCOPE(arb, angle);
    zero(z);
    arb_set_d(angle, x->c[0]);
    arb_sin_cos(at, at + 1, angle, 128);
    model_set(&d, x);
    d.c[0] = 0;
    find_norms(&d);
    power.c[0] = 1;
    find_norms(&power);
    for (int k = 0; k <= x->space->degree; k++) { /* sin, cos, -sin, -cos, or from there on */
        model_set_ball(&value, at + (k + quarters) % 2);
        model_dot(z, true, (k + quarters) % 4 < 2 ? 1 : -1, &value, &power, 1);
        model_dot(&next, false, 1, &power, &d, 1);
        model_scale(&next, 1.0 / (k + 1));
        model_set(&power, &next);
    }
    if (!is_zero_model(&power))
        z->rest = upward(z->rest + model_size(&power));
}

/* The sum of absolute values of all that is added is ||z||: with the binomial coefficients each c_b is shared out over 2^-p (1 + 1)^p. */
void model_halve(struct model *z, int i, int side)
{
    const struct space *s = z->space;
    if (is_zero_model(z))
        return;
    for (int b = 0; b < s->size; b++)
        z->c[b] = ldexp(z->c[b], -s->exponent[b * s->variables + i]);
    for (int j = 0; j < s->degree; j++)
        for (int b = s->first[s->degree] - 1; b >= 0; b--)
            if (s->exponent[b * s->variables + i] >= j)
                z->c[b] += side * z->c[s->product[b][1 + i]];
    z->rest = upward(z->rest + (s->degree * s->degree + 2) * U * norm(z)); /* (M1) */
    find_norms(z);
}

/* A monomial whose exponents are all even lies in [0, 1]: of c_b b, c_b/2 joins the middle. */
void model_range(arb_t range, const struct model *x)
{
    const struct space *s = x->space;
    double middle = x->c[0], radius = x->rest;
    for (int b = 1; b < s->size; b++) {
        bool even = true;
        for (int i = 0; i < s->variables; i++)
            even = even && s->exponent[b * s->variables + i] % 2 == 0;
        middle += even ? x->c[b] / 2 : 0;
        radius += even ? fabs(x->c[b]) / 2 : fabs(x->c[b]);
    }
    SCOPE(mag, r);
    if (!is_zero_model(x))
        mag_set_d(r, upward(radius + s->size * U * norm(x))); /* (M1) */
    arb_set_d(range, middle);
    arb_add_error_mag(range, r);
}
