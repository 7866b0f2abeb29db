#include "motion/two_body.h"

#include <math.h>

#include "text/scope.h"

enum {
    SERIES = CRAFT * AXES,
    ORDER = 28 /* of the Taylor steps: the last term falls to 1e-28, balls then widen by 10^3 a radian */
};

static const double TWO_BODY_STEP = 0.2; /* radians */

struct expansion {
    arb_poly_struct place[SERIES], velocity[SERIES], acceleration[SERIES];
};

void two_body_init(struct two_body *b)
{
    arb_init(b->smallness);
    arb_init(b->c1);
    arb_init(b->c2);
    b->mass = _arb_vec_init(CRAFT);
    b->place = _arb_vec_init(SERIES);
    b->velocity = _arb_vec_init(SERIES);
}

void two_body_clear(struct two_body *b)
{
    arb_clear(b->smallness);
    arb_clear(b->c1);
    arb_clear(b->c2);
    _arb_vec_clear(b->mass, CRAFT);
    _arb_vec_clear(b->place, SERIES);
    _arb_vec_clear(b->velocity, SERIES);
}

/* a.b */
static void scalar_product(arb_poly_t z, const arb_poly_struct *a, const arb_poly_struct *b, slong n, slong prec)
{
    SCOPE(arb_poly, term);
    arb_poly_zero(z);
    for (int i = 0; i < AXES; i++) {
        arb_poly_mullow(term, a + i, b + i, n, prec);
        arb_poly_add(z, z, term, prec);
    }
}

/*
 * R = e_x/s + r, s the smallness: r_ddot = -R/|s R|^3 + (R - R_z) + twice Coriolis. With g = |s R|^-3 that is
 * x (1 - g) + (1 - g)/s + 2 y_dot, y (1 - g) - 2 x_dot, -z g.
 */
static void attract(struct expansion *t, int craft, const arb_t s, slong n, slong prec)
{
    arb_poly_struct *r = t->place + AXES * craft, *v = t->velocity + AXES * craft, *a = t->acceleration + AXES * craft;
    SCOPE(arb_poly, g, h);
    SCOPE(arb, power);
    scalar_product(g, r, r, n, prec); /* |s R|^2 = 1 + 2 s x + s^2 r.r */
    arb_poly_scalar_mul(g, g, s, prec);
    arb_poly_scalar_mul_2exp_si(h, r, 1);
    arb_poly_add(g, g, h, prec);
    arb_poly_scalar_mul(g, g, s, prec);
    arb_poly_add_si(g, g, 1, prec);
    arb_set_d(power, -1.5);
    arb_poly_pow_arb_series(g, g, power, n, prec);

    arb_poly_mullow(a + 2, r + 2, g, n, prec);
    arb_poly_neg(a + 2, a + 2);
    arb_poly_add_si(g, g, -1, prec);
    arb_poly_neg(g, g);
    arb_poly_scalar_div(h, g, s, prec);
    arb_poly_mullow(a, r, g, n, prec);
    arb_poly_add(a, a, h, prec);
    arb_poly_mullow(a + 1, r + 1, g, n, prec);
    arb_poly_scalar_mul_2exp_si(h, v + 1, 1);
    arb_poly_add(a, a, h, prec);
    arb_poly_scalar_mul_2exp_si(h, v, 1);
    arb_poly_sub(a + 1, a + 1, h, prec);
}

/* Along the line d from craft 2 to craft 1: d (3 + c1 (L - 1) + c2 L_dot)/L^3, in shares of the other's mass. */
static void pull(struct expansion *t, const struct two_body *b, slong n, slong prec)
{
    arb_poly_struct d[AXES], d_dot[AXES];
    SCOPE(arb_poly, L, f, h);
    for (int i = 0; i < AXES; i++) {
        arb_poly_init(d + i);
        arb_poly_init(d_dot + i);
        arb_poly_sub(d + i, t->place + i, t->place + AXES + i, prec);
        arb_poly_sub(d_dot + i, t->velocity + i, t->velocity + AXES + i, prec);
    }
    scalar_product(L, d, d, n, prec);
    arb_poly_sqrt_series(L, L, n, prec);
    scalar_product(f, d, d_dot, n, prec);
    arb_poly_div_series(f, f, L, n, prec);
    arb_poly_scalar_mul(f, f, b->c2, prec);
    arb_poly_add_si(h, L, -1, prec);
    arb_poly_scalar_mul(h, h, b->c1, prec);
    arb_poly_add(f, f, h, prec);
    arb_poly_add_si(f, f, 3, prec);
    arb_poly_pow_ui_trunc_binexp(h, L, 3, n, prec);
    arb_poly_div_series(f, f, h, n, prec);
    for (int i = 0; i < AXES; i++) {
        arb_poly_mullow(h, d + i, f, n, prec);
        arb_poly_scalar_mul(d + i, h, b->mass + 1, prec);
        arb_poly_sub(t->acceleration + i, t->acceleration + i, d + i, prec);
        arb_poly_scalar_mul(d + i, h, b->mass, prec);
        arb_poly_add(t->acceleration + AXES + i, t->acceleration + AXES + i, d + i, prec);
        arb_poly_clear(d + i);
        arb_poly_clear(d_dot + i);
    }
}

/* Picard's iteration: each pass makes one more coefficient right. */
static void expand(struct expansion *t, const struct two_body *b, slong prec)
{
    for (slong n = 1; n <= ORDER; n++) {
        for (int craft = 0; craft < CRAFT; craft++)
            attract(t, craft, b->smallness, n, prec);
        pull(t, b, n, prec);
        for (int i = 0; i < SERIES; i++) {
            arb_poly_integral(t->place + i, t->velocity + i, prec);
            arb_poly_set_coeff_arb(t->place + i, 0, b->place + i);
            arb_poly_integral(t->velocity + i, t->acceleration + i, prec);
            arb_poly_set_coeff_arb(t->velocity + i, 0, b->velocity + i);
        }
    }
}

/* The sum at h, and its last term as the error. */
static void sum_terms(arb_t z, const arb_poly_t f, const arb_t h, slong prec)
{
    SCOPE(arb, last, power);
    arb_poly_evaluate(z, f, h, prec);
    arb_poly_get_coeff_arb(last, f, ORDER);
    arb_pow_ui(power, h, ORDER, prec);
    arb_mul(last, last, power, prec);
    arb_add_error(z, last);
}

void two_body_move(struct two_body *b, const arb_t tau, slong prec)
{
    const slong steps = (slong)ceil(arf_get_d(arb_midref(tau), ARF_RND_UP) / TWO_BODY_STEP);
    struct expansion t;
    SCOPE(arb, h);
    arb_div_si(h, tau, steps, prec);
    for (slong k = 0; k < steps; k++) {
        for (int i = 0; i < SERIES; i++) {
            arb_poly_init(t.place + i);
            arb_poly_init(t.velocity + i);
            arb_poly_init(t.acceleration + i);
            arb_poly_set_coeff_arb(t.place + i, 0, b->place + i);
            arb_poly_set_coeff_arb(t.velocity + i, 0, b->velocity + i);
        }
        expand(&t, b, prec);
        for (int i = 0; i < SERIES; i++) {
            sum_terms(b->place + i, t.place + i, h, prec);
            sum_terms(b->velocity + i, t.velocity + i, h, prec);
            arb_poly_clear(t.place + i);
            arb_poly_clear(t.velocity + i);
            arb_poly_clear(t.acceleration + i);
        }
    }
}
