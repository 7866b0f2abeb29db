#include "optimum.h"

#include "algebra.h"

/* ---- the rates on (44) ------------------------------------------------ */

/* w = over/under as a function of y, and the numerator of its derivative, over under^2 */
struct curve {
    fmpq_poly_t over, under, slope;
};

static void curve_init(struct curve *c)
{
    fmpq_poly_t f;
    fmpq_poly_init(f);
    fmpq_poly_init(c->over);
    fmpq_poly_init(c->under);
    fmpq_poly_init(c->slope);
    polynomial(c->over, "x*(x + 7)^2");
    polynomial(c->under, "x^2 + 14*x + 1");
    fmpq_poly_derivative(c->slope, c->over);
    fmpq_poly_mul(c->slope, c->slope, c->under);
    fmpq_poly_derivative(f, c->under);
    fmpq_poly_mul(f, f, c->over);
    fmpq_poly_sub(c->slope, c->slope, f);
    fmpq_poly_clear(f);
}

static void curve_clear(struct curve *c)
{
    fmpq_poly_clear(c->over);
    fmpq_poly_clear(c->under);
    fmpq_poly_clear(c->slope);
}

/*
 * The sheet's (41) is (s^2 + 3 Omega^2)(s^2 + C2 s + C1 - 9 Omega^2) + 4 Omega^2 s^2. On (44) the middle of its roots
 * is -u/2; about it the polynomial splits into two quadratics v^2 +- t v + ..., but for a constant that is
 * zero where y = t^2 solves the cubic. No root is real (a sum of squares, zero for u > 0 nowhere), so these
 * are the two pairs; and the curve w(y) rises from 0, with w > y, so that both rates are positive.
 */
bool rates_proved(void)
{
    const char *const split =
        "4*t^2*((v^2 + t*v + (7 - u^2/2 + t^2 + u/t)/2)*(v^2 - t*v + (7 - u^2/2 + t^2 - u/t)/2)"
        " - ((v - u/2)^2 + 3)*(v - u/2 + u)^2 - 4*(v - u/2)^2)";
    bool proved = section_identity("eq41", "a4", "1") && section_identity("eq41", "a3", "C2") &&
                  section_identity("eq41", "a2", "3*Omega^2 + (C1 - 9*Omega^2) + 4*Omega^2") &&
                  section_identity("eq41", "a1", "3*Omega^2*C2") &&
                  section_identity("eq41", "a0", "3*Omega^2*(C1 - 9*Omega^2)") &&
                  identity("t u v", split, "t^2*(t^2 + 7)^2 - u^2*(t^4 + 14*t^2 + 1)");
    struct curve c;
    fmpq_t zero;
    fmpq_init(zero);
    curve_init(&c);
    proved = proved && has_sign_beyond(c.slope, zero, 1);
    fmpq_poly_shift_left(c.under, c.under, 1);
    fmpq_poly_sub(c.over, c.over, c.under); /* (w - y) under */
    proved = proved && has_sign_beyond(c.over, zero, 1);
    curve_clear(&c);
    fmpq_clear(zero);
    return proved;
}

/* The rate is greater than (u - v)/2 where t < v, that is, where v^2 lies above the root y of the cubic. */
bool slow_rate_compares(const char *numerator, const char *denominator, slong p, ulong q, int sign)
{
    fmpq_poly_t a, b, f, g;
    fmpq_t from;
    fmpq_init(from);
    fmpq_poly_init(a);
    fmpq_poly_init(b);
    fmpq_poly_init(f);
    fmpq_poly_init(g);
    fmpq_set_si(from, p, q);
    polynomial(a, numerator);
    polynomial(b, denominator);
    fmpq_poly_scalar_mul_si(f, b, 7); /* a (a + 7 b)^2 - w b (a^2 + 14 a b + b^2) */
    fmpq_poly_add(f, f, a);
    fmpq_poly_pow(f, f, 2);
    fmpq_poly_mul(f, f, a);
    fmpq_poly_scalar_mul_si(g, b, 14);
    fmpq_poly_add(g, g, a);
    fmpq_poly_mul(g, g, a);
    fmpq_poly_mul(a, b, b);
    fmpq_poly_add(g, g, a);
    fmpq_poly_mul(g, g, b);
    fmpq_poly_shift_left(g, g, 1);
    fmpq_poly_sub(f, f, g);
    bool compares = has_sign_beyond(b, from, 1) && has_sign_beyond(f, from, sign);
    fmpq_clear(from);
    fmpq_poly_clear(a);
    fmpq_poly_clear(b);
    fmpq_poly_clear(f);
    fmpq_poly_clear(g);
    return compares;
}

/* ---- the optimum ------------------------------------------------------ */

void optimum_init(struct optimum *o)
{
    arb_init(o->n);
    arb_init(o->rate);
    fmpz_poly_init(o->n_solves);
    fmpz_poly_init(o->square_solves);
}

void optimum_clear(struct optimum *o)
{
    arb_clear(o->n);
    arb_clear(o->rate);
    fmpz_poly_clear(o->n_solves);
    fmpz_poly_clear(o->square_solves);
}

/* A polynomial with the root over/under at y where y is a root of f: that of multiplication by it modulo f. */
static void solved_by(fmpz_poly_t result, const fmpq_poly_t over, const fmpq_poly_t under, const fmpq_poly_t f)
{
    const slong degree = fmpq_poly_degree(f);
    fmpq_poly_t g, x, y;
    fmpq_mat_t m;
    fmpq_poly_init(g);
    fmpq_poly_init(x);
    fmpq_poly_init(y);
    fmpq_mat_init(m, degree, degree);
    fmpq_poly_xgcd(g, x, y, under, f); /* x is 1/under */
    fmpq_poly_mul(x, x, over);
    for (slong k = 0; k < degree; k++) {
        fmpq_poly_rem(x, x, f);
        for (slong j = 0; j < degree; j++)
            fmpq_poly_get_coeff_fmpq(fmpq_mat_entry(m, j, k), x, j);
        fmpq_poly_shift_left(x, x, 1);
    }
    fmpq_mat_charpoly(g, m);
    fmpq_poly_get_numerator(result, g);
    fmpq_poly_clear(g);
    fmpq_poly_clear(x);
    fmpq_poly_clear(y);
    fmpq_mat_clear(m);
}

/* The positive root of f in y; false unless there is exactly one. */
static bool positive_root(arb_t y, const fmpq_poly_t f, slong prec)
{
    int found = 0;
    fmpz_poly_t g;
    fmpz_poly_init(g);
    fmpq_poly_get_numerator(g, f);
    acb_ptr roots = _acb_vec_init(fmpz_poly_degree(g));
    arb_fmpz_poly_complex_roots(roots, g, 0, prec);
    for (slong k = 0; k < fmpz_poly_degree(g); k++) {
        if (acb_is_real(roots + k) && arb_is_positive(acb_realref(roots + k))) {
            arb_set(y, acb_realref(roots + k));
            found++;
        }
    }
    _acb_vec_clear(roots, fmpz_poly_degree(g));
    fmpz_poly_clear(g);
    return found == 1;
}

static void evaluate(arb_t z, const fmpq_poly_t f, const arb_t x, slong prec)
{
    arb_poly_t g;
    arb_poly_init(g);
    arb_poly_set_fmpq_poly(g, f, prec);
    arb_poly_evaluate(z, g, x, prec);
    arb_poly_clear(g);
}

/* n = 9 + w and rate = (sqrt(w) - sqrt(y))/2 */
static void at_parameter(struct optimum *o, const struct curve *c, const arb_t y, slong prec)
{
    arb_t t;
    arb_init(t);
    evaluate(o->n, c->over, y, prec);
    evaluate(t, c->under, y, prec);
    arb_div(o->n, o->n, t, prec);
    arb_sqrt(o->rate, o->n, prec);
    arb_sqrt(t, y, prec);
    arb_sub(o->rate, o->rate, t, prec);
    arb_mul_2exp_si(o->rate, o->rate, -1);
    arb_add_si(o->n, o->n, 9, prec);
    arb_clear(t);
}

/*
 * Along the curve the rate (u - t)/2 is stationary where du/dt = 1. As u^2 = w, that is t w' = u, and with everything
 * positive y w'^2 = w:  slope^2 - (y + 7)^2 under^3 = 0, whose factor (y + 7)^2 has no positive root.
 * There sqrt(under) = slope/(under (y + 7)), so that 4 rate^2 = y (under (y + 7)^2/slope - 1)^2.
 */
bool optimum_find(struct optimum *o, slong prec)
{
    struct curve c;
    fmpq_poly_t f, g, trivial;
    fmpq_t zero;
    arb_t y;
    arb_init(y);
    fmpq_init(zero);
    fmpq_poly_init(f);
    fmpq_poly_init(g);
    fmpq_poly_init(trivial);
    curve_init(&c);
    polynomial(trivial, "(x + 7)^2");
    fmpq_poly_pow(f, c.under, 3);
    fmpq_poly_mul(f, f, trivial);
    fmpq_poly_pow(g, c.slope, 2);
    fmpq_poly_sub(f, g, f);
    bool only = roots_beyond(f, zero) == 1;
    for (fmpq_poly_rem(g, f, trivial); fmpq_poly_is_zero(g); fmpq_poly_rem(g, f, trivial))
        fmpq_poly_div(f, f, trivial);
    only = only && roots_beyond(f, zero) == 1 && positive_root(y, f, prec);
    if (only) {
        at_parameter(o, &c, y, prec);
        fmpq_poly_scalar_mul_si(g, c.under, 9);
        fmpq_poly_add(g, g, c.over);
        solved_by(o->n_solves, g, c.under, f);
        fmpq_poly_mul(g, c.under, trivial);
        fmpq_poly_sub(g, g, c.slope);
        fmpq_poly_pow(g, g, 2);
        fmpq_poly_shift_left(g, g, 1);
        fmpq_poly_pow(c.slope, c.slope, 2);
        fmpq_poly_scalar_mul_si(c.slope, c.slope, 4);
        solved_by(o->square_solves, g, c.slope, f);
    }
    arb_clear(y);
    fmpq_clear(zero);
    fmpq_poly_clear(f);
    fmpq_poly_clear(g);
    fmpq_poly_clear(trivial);
    curve_clear(&c);
    return only;
}
