/*
 * verify/motion/taylor.h: the closed loop as a quadratic system, its series in balls, and a test for every error term of the
 * theorem in taylor.c. Where a term dominates, the system is another one, of which the solution is known in fractions.
 */
#include "tests/run.h"
#include "tests/paper.h"

#include "coulombtether.h"
#include "evaluate/operation.h"
#include "motion/taylor.h"
#include "text/scope.h"

CASE(all, NULL, flint_cleanup)

enum { PREC = 256 };

/* The states, one product, and constants, by their places in a jet */
enum { X, Y, Z, U, V, W, Q, G, S, P = 12, ONE, C1 = 16 };

static double number(const arb_t x)
{
    return arf_get_d(arb_midref(x), ARF_RND_NEAR);
}

/* ---- systems with known solutions ---- */

/*
 * X' = U, U' = V, V' = W, W' = 0: polynomials; Y' = Y: an exponential; Q' = 0; and Z' = a b, of which the remainder has
 * the tails of one product and nothing else. No coefficient of it is negative where the start is not.
 */
static void integral_of_product(struct term system[JET_TERMS], int a, int b)
{
    static const struct term nothing = {P, C1, C1, 1}; /* 0 0, to what nobody needs */
    const struct term first[] = {{S, (unsigned char)a, (unsigned char)b, 1}, {X, ONE, U, 1}, {U, ONE, V, 1},
                                 {V, ONE, W, 1}, {Y, ONE, Y, 1}, {Z, ONE, S, 1}};
    for (size_t t = 0; t < JET_TERMS; t++)
        system[t] = t < sizeof first / sizeof *first ? first[t] : nothing;
}

enum { KNOWN = 24 }; /* terms of an exponential; what is beyond is positive: bounds that fail without it, fail with it */

/* The series of X, U, V, W, Y or Q from that start */
static void known_series(fmpq_poly_t series, int v, const fmpq *start)
{
    static const int chain[] = {X, U, V, W};
    SCOPE(fmpq, c);
    fmpq_poly_zero(series);
    for (slong k = 0; k < KNOWN; k++) {
        int from = v == Y || (v == Q && k == 0) ? v : -1;
        for (int i = 0; i < 4; i++)
            if (chain[i] == v && i + k < 4)
                from = chain[i + k];
        if (from < 0)
            continue;
        SCOPE(fmpz, factorial);
        fmpz_fac_ui(factorial, (ulong)k);
        fmpq_div_fmpz(c, start + from, factorial);
        fmpq_poly_set_coeff_fmpq(series, k, c);
    }
}

/* sum += weight times what the terms of the series beyond degree n sum to at h */
static void add_beyond(fmpq_t sum, const fmpq_poly_t series, slong n, const fmpq_t h, const fmpq_t weight)
{
    SCOPE(fmpq_poly, beyond);
    SCOPE(fmpq, value);
    fmpq_poly_set(beyond, series);
    for (slong k = 0; k <= n; k++)
        fmpq_poly_set_coeff_si(beyond, k, 0);
    fmpq_poly_evaluate_fmpq(value, beyond, h);
    fmpq_addmul(sum, value, weight);
}

/* A case: the product, a start, another start as derivative or none, the order, and what comes of it. */
struct known_case {
    int a, b;
    slong order;
    double h;
    double start[JET_STATES], column[JET_STATES];
    bool of_column;
};

/* A column is one whose constants are all zero. */
static void jet_known(struct jet *jet, slong order, const struct term *terms, const double start[JET_STATES], bool column)
{
    static struct system system; /* a test has one */
    SCOPE(arb, zero);
    jet_init(jet, &closed_loop, order, NULL);
    system = closed_loop;
    system.terms = terms;
    jet->system = &system;
    if (!column)
        jet_constants(jet, zero, zero);
    for (int v = 0; v < JET_STATES; v++)
        arb_set_d(jet->c[v], start[v]);
}

static void fractions(fmpq *to, const double from[JET_STATES])
{
    SCOPE(arf, x);
    for (int v = 0; v < JET_STATES; v++) {
        arf_set_d(x, from[v]);
        arf_get_fmpq(to + v, x);
    }
}

/* What is true of Z's remainder: of the integral of a b, or of da b + a db */
static void true_remainder(fmpq_t remainder, const struct known_case *c, const fmpq_t h)
{
    SCOPE(fmpq_poly, a, b, product, other);
    VECTOR(fmpq, start, JET_STATES);
    VECTOR(fmpq, column, JET_STATES);
    SCOPE(fmpq, one);
    fmpq_one(one);
    fractions(start, c->start);
    fractions(column, c->column);
    known_series(a, c->a, start);
    known_series(b, c->b, c->of_column ? column : start);
    fmpq_poly_mul(product, a, b);
    if (c->of_column) {
        known_series(a, c->a, column);
        known_series(b, c->b, start);
        fmpq_poly_mul(other, a, b);
        fmpq_poly_add(product, product, other);
    }
    fmpq_poly_integral(product, product);
    fmpq_zero(remainder);
    add_beyond(remainder, product, c->order, h, one);
}

static void assert_bounds(const mag_t remainder, const fmpq_t truth, double at_most)
{
    SCOPE(fmpq, bound, ratio);
    mag_get_fmpq(bound, remainder);
    ck_assert_int_gt(fmpq_sgn(truth), 0);
    fmpq_div(ratio, bound, truth);
    ck_assert_msg(fmpq_cmp(bound, truth) >= 0, "the bound is the truth times %.12g", fmpq_get_d(ratio));
    ck_assert_double_le(fmpq_get_d(ratio), at_most); /* else other terms might stand in for the one that is asked for */
}

/* The proved remainder holds the true one, and is no more than so many times as large. */
static void assert_rest_of(const struct known_case *c, double at_most)
{
    struct term system[JET_TERMS];
    OWNED(jet) jet, column;
    OWNED(majorant) base, m;
    SCOPE(mag, h, one);
    SCOPE(fmpq, exact_h, truth);
    mag_one(one);
    mag_set_d(h, c->h);
    mag_get_fmpq(exact_h, h);
    integral_of_product(system, c->a, c->b);
    jet_known(&jet, c->order, system, c->start, false);
    jet_known(&column, c->order, system, c->column, true);
    jet_extend(&jet, &jet, PREC, 0);
    jet_extend(&column, &jet, PREC, 0);
    majorant_init(&base, &closed_loop, c->order);
    majorant_init(&m, &closed_loop, c->order);
    majorant_of(&base, &jet, one, 1, h);
    ck_assert(majorant_prove(&base, NULL, h));
    majorant_of(&m, &column, one, 1, h);
    ck_assert(majorant_prove(&m, &base, h));
    true_remainder(truth, c, exact_h);
    assert_bounds((c->of_column ? m.remainder : base.remainder) + Z, truth, at_most);
}

/* ---- the error terms ---- */

enum { FIRST_ORDER = 1, LAST_ORDER = 6 };
static const double SHORT = 0x1p-10, A_LITTLE_MORE = 1.01; /* all else is a thousandth of the first term left out */
static const double MOST_BITS = 1 + 0x1p-40;               /* of a number that mag_t has to round up */

/* A polynomial of degree below n, squared: no tails, only what its known terms make. */
RANGE(T1_products_of_known_terms_reach_beyond_their_degree, 2, LAST_ORDER + 1)
{
    const slong n = _i;
    const struct known_case c = {.a = X, .b = X, .order = n, .h = SHORT,
                                 .start = {[X] = n == 6 ? 0 : 1, [U] = MOST_BITS, [V] = n > 2, [W] = n > 3}};
    assert_rest_of(&c, n == 6 ? 2.1 : A_LITTLE_MORE); /* s^6 alone would be exact */
}

RANGE(T2_known_terms_meet_the_tail_of_the_second_factor, FIRST_ORDER, LAST_ORDER + 1)
{
    const struct known_case c = {.a = Q, .b = Y, .order = _i, .h = SHORT, .start = {[Q] = 3, [Y] = MOST_BITS}};
    assert_rest_of(&c, A_LITTLE_MORE);
}

RANGE(T3_known_terms_meet_the_tail_of_the_first_factor, FIRST_ORDER, LAST_ORDER + 1)
{
    const struct known_case c = {.a = Y, .b = Q, .order = _i, .h = SHORT, .start = {[Q] = 3, [Y] = MOST_BITS}};
    assert_rest_of(&c, A_LITTLE_MORE);
}

/* s^n squared, where the remainder begins with degree 2n + 1 and the factor is h/(n+1) */
RANGE(T4_tails_meet_tails, 1, 4)
{
    const slong n = _i;
    const struct known_case c = {.a = X, .b = X, .order = n, .h = SHORT, .start = {[U] = n == 1, [V] = n == 2, [W] = n == 3}};
    assert_rest_of(&c, 2);
}

/* Q s^n/n!, whose remainder is exact: nothing beyond degree n */
RANGE(T5_a_tail_has_its_term_of_degree_n, 1, 4)
{
    const slong n = _i;
    const struct known_case c = {.a = Q, .b = X, .order = n, .h = SHORT,
                                 .start = {[Q] = 3, [U] = n == 1, [V] = n == 2, [W] = n == 3}};
    assert_rest_of(&c, 1 + 0x1p-20);
}

/* Q s^(n+1)/(n+1)!: the tail is a remainder itself */
RANGE(T6_a_tail_has_its_rest, 1, 3)
{
    const slong n = _i;
    const struct known_case c = {.a = Q, .b = X, .order = n, .h = SHORT, .start = {[Q] = 3, [V] = n == 1, [W] = n == 2}};
    assert_rest_of(&c, 3.1); /* the image of a remainder that was doubled to be proved */
}

/* da b with da and b both growing, and a db: one of them alone each time */
RANGE(T8_a_column_has_the_change_of_the_first_factor, FIRST_ORDER, LAST_ORDER + 1)
{
    const struct known_case c = {.a = X, .b = Y, .order = _i, .h = SHORT, .of_column = true,
                                 .start = {[X] = 5, [U] = 7, [Y] = 1}, .column = {[X] = 1, [U] = 1, [V] = 1, [W] = 1}};
    assert_rest_of(&c, A_LITTLE_MORE);
}

RANGE(T8_a_column_has_the_change_of_the_second_factor, FIRST_ORDER, LAST_ORDER + 1)
{
    const struct known_case c = {.a = X, .b = Y, .order = _i, .h = SHORT, .of_column = true,
                                 .start = {[X] = 1, [U] = 1, [V] = 1, [W] = 1, [Y] = 9}, .column = {[Y] = 1}};
    assert_rest_of(&c, A_LITTLE_MORE);
}

/* x dx + dx x, polynomials of degree below n: no tails */
RANGE(T8_a_column_has_both_products_of_a_square, 2, LAST_ORDER)
{
    const slong n = _i;
    const struct known_case c = {.a = X, .b = X, .order = n, .h = SHORT, .of_column = true,
                                 .start = {[X] = 1, [U] = 1, [V] = n > 2, [W] = n > 3},
                                 .column = {[X] = 1, [U] = 1, [V] = n > 2, [W] = n > 3}};
    assert_rest_of(&c, A_LITTLE_MORE);
}

/* Tails alone: the product of s^n and s^n, one of which is the column's */
RANGE(T8_a_column_has_the_products_of_tails, 1, 4)
{
    const slong n = _i;
    const struct known_case c = {.a = X, .b = X, .order = n, .h = SHORT, .of_column = true,
                                 .start = {[U] = n == 1, [V] = n == 2, [W] = n == 3},
                                 .column = {[U] = n == 1, [V] = n == 2, [W] = n == 3}};
    assert_rest_of(&c, 2);
}

/* The remainder of X alone: u_n h^(n+1)/(n+1), where the bound is exact but for roundings, and they go up. */
TEST(T7_T12_a_rest_is_h_over_n_plus_1_times_a_tail_rounded_up)
{
    enum { CASES = 300 };
    struct term system[JET_TERMS];
    SCOPE(fmpq, exact, truth, one);
    SCOPE(mag, h, unit);
    SCOPE(fmpq_poly, series);
    VECTOR(fmpq, start, JET_STATES);
    fmpq_one(one);
    mag_one(unit);
    integral_of_product(system, Q, Q);
    for (int k = 1; k <= CASES; k++) {
        const slong n = 1 + k % 2;
        const double value = 1 + fmod(k * 0.6180339887498949, 1); /* 53 bits of it */
        const double from[JET_STATES] = {[V] = n == 1 ? value : 0, [W] = n == 2 ? value : 0};
        OWNED(jet) jet;
        OWNED(majorant) m;
        mag_set_d(h, 0.1 + fmod(k * 0.7548776662466927, 1));
        mag_get_fmpq(exact, h);
        jet_known(&jet, n, system, from, false);
        jet_extend(&jet, &jet, PREC, 0);
        majorant_init(&m, &closed_loop, n);
        majorant_of(&m, &jet, unit, 1, h);
        ck_assert(majorant_prove(&m, NULL, h));
        fractions(start, from);
        known_series(series, X, start);
        fmpq_zero(truth);
        add_beyond(truth, series, n, exact, one);
        assert_bounds(m.remainder + X, truth, 1 + 0x1p-25);
    }
}

/* Three exponentials from 1, 2 and 3 under weights 1/2, 1/4 and 4: as one of 13. And one from the ball 0 +- 13. */
RANGE(T9_T10_a_majorant_has_every_column_and_its_radius, FIRST_ORDER, LAST_ORDER + 1)
{
    static const double factor[] = {1, 2, 3}, weight[] = {0.5, 0.25, 4};
    const slong n = _i;
    struct term system[JET_TERMS];
    struct jet jet, column[4];
    OWNED(majorant) base, m;
    VECTOR(mag, weights, 3);
    SCOPE(fmpq_poly, series);
    VECTOR(fmpq, start, JET_STATES);
    SCOPE(fmpq, exact, truth, one);
    SCOPE(mag, h);
    fmpq_one(one);
    mag_set_d(h, SHORT);
    mag_get_fmpq(exact, h);
    integral_of_product(system, Q, Q);
    jet_known(&jet, n, system, (const double[JET_STATES]){[Q] = 1}, false);
    jet_extend(&jet, &jet, PREC, 0);
    majorant_init(&base, &closed_loop, n);
    mag_one(weights);
    majorant_of(&base, &jet, weights, 1, h);
    ck_assert(majorant_prove(&base, NULL, h));
    for (int j = 0; j < 4; j++) {
        jet_known(&column[j], n, system, (const double[JET_STATES]){[Y] = j < 3 ? factor[j] : 0}, true);
        if (j == 3)
            mag_set_ui(arb_radref(column[j].c[Y]), 13);
        else
            mag_set_d(weights + j, weight[j]);
        jet_extend(&column[j], &jet, PREC, 0);
    }
    fmpq_set_si(start + Y, 13, 1);
    known_series(series, Y, start);
    add_beyond(truth, series, n, exact, one);
    majorant_init(&m, &closed_loop, n);
    majorant_of(&m, column, weights, 3, h);
    ck_assert(majorant_prove(&m, &base, h));
    assert_bounds(m.remainder + Y, truth, A_LITTLE_MORE);
    mag_one(weights);
    majorant_of(&m, column + 3, weights, 1, h);
    ck_assert(majorant_prove(&m, &base, h));
    assert_bounds(m.remainder + Y, truth, A_LITTLE_MORE);
    jet_clear(&jet);
    for (int j = 0; j < 4; j++)
        jet_clear(&column[j]);
}

/*
 * v' = v^2 from 1 is 1/(1 - s): what is proved lies within the circle of convergence, and bounds h^(n+1)/(1 - h); what
 * lies at 1 or beyond is not proved, whichever state it is that does not converge.
 */
static void assert_proved_within_the_circle(int v, slong n)
{
    struct term system[JET_TERMS];
    OWNED(jet) jet;
    OWNED(majorant) m;
    double start[JET_STATES] = {0}, longest = 0;
    SCOPE(mag, h, one);
    mag_one(one);
    integral_of_product(system, P, P);
    for (int t = 1; t < JET_TERMS; t++)
        system[t] = system[JET_TERMS - 1];
    system[1] = (struct term){(unsigned char)v, (unsigned char)v, (unsigned char)v, 1};
    start[v] = 1;
    jet_known(&jet, n, system, start, false);
    jet_extend(&jet, &jet, PREC, 0);
    majorant_init(&m, &closed_loop, n);
    for (int k = 1; k <= 96; k++) {
        const double step = k / 64.0;
        mag_set_d(h, step);
        majorant_of(&m, &jet, one, 1, h);
        if (!majorant_prove(&m, NULL, h))
            continue;
        longest = step;
        ck_assert_msg(step < 1, "state %d proved at %g", v, step);
        ck_assert_double_ge(mag_get_d(m.remainder + v), pow(step, (double)n + 1) / (1 - step) * (1 - 1e-9));
    }
    ck_assert_double_ge(longest, n < 3 ? 0.2 : 0.35);
    mag_inf(arb_radref(jet.c[v])); /* and nothing of what has no bound */
    majorant_of(&m, &jet, one, 1, h);
    ck_assert(!majorant_prove(&m, NULL, h));
}

RANGE(T11_nothing_is_proved_that_does_not_converge, FIRST_ORDER, 2 * LAST_ORDER)
{
    for (int v = 0; v < JET_STATES; v++)
        assert_proved_within_the_circle(v, _i);
}

/* ---- the closed loop in fractions ---- */

enum { EXACT_TERMS = 18, POINTS = 5, CLOSED_LOOPS = 2 * POINTS };

/* Pythagorean points over 5, and gains that hold the pair or let it go. */
static const int point[POINTS][4] = {{2, 3, 6, 7}, {1, -2, 2, 3}, {-4, 4, 7, 9}, {1, 0, 0, 1}, {6, -6, -3, 9}};

struct exact_motion {
    fmpq_t c1, c2, r;
    fmpq *state; /* x y z u v w q */
};

static void exact_motion_init(struct exact_motion *e, int number)
{
    const int *p = point[number % POINTS];
    fmpq_init(e->c1);
    fmpq_init(e->c2);
    fmpq_init(e->r);
    e->state = _fmpq_vec_init(JET_STATES);
    fmpq_set_si(e->c1, number < POINTS ? 31 : -4, 3);
    fmpq_set_si(e->c2, number < POINTS ? 7 : -9, 5);
    for (int i = 0; i < 3; i++) {
        fmpq_set_si(e->state + i, p[i], 5);
        fmpq_set_si(e->state + 3 + i, 3 * i - 2, 11);
    }
    fmpq_set_si(e->r, p[3], 5);
    fmpq_inv(e->state + 6, e->r);
}

static void exact_motion_clear(struct exact_motion *e)
{
    fmpq_clear(e->c1);
    fmpq_clear(e->c2);
    fmpq_clear(e->r);
    _fmpq_vec_clear(e->state, JET_STATES);
}

/* p = (-3 - c1 (r - 1) - c2 r')/r^3 of (3), (7) and (18), in units of Omega and r_ref, and r^-1 */
static void series_of_force(fmpq_poly_t p, fmpq_poly_t inverse, const struct exact_motion *e, const fmpq_poly_struct *x,
                            slong terms)
{
    SCOPE(fmpq_poly, r, rate, t);
    SCOPE(fmpq, square);
    for (int i = 0; i < 3; i++) {
        fmpq_poly_mullow(t, x + i, x + i, terms);
        fmpq_poly_add(r, r, t);
    }
    fmpq_mul(square, e->r, e->r);
    fmpq_poly_scalar_div_fmpq(r, r, square);
    fmpq_poly_sqrt_series(r, r, terms);
    fmpq_poly_scalar_mul_fmpq(r, r, e->r);
    fmpq_poly_inv_series(inverse, r, terms);
    fmpq_poly_zero(rate);
    for (int i = 0; i < 3; i++) {
        fmpq_poly_mullow(t, x + i, x + 3 + i, terms);
        fmpq_poly_add(rate, rate, t);
    }
    fmpq_poly_mullow(t, rate, inverse, terms);
    fmpq_poly_scalar_mul_fmpq(t, t, e->c2);
    fmpq_poly_one(p);
    fmpq_poly_sub(p, r, p);
    fmpq_poly_scalar_mul_fmpq(p, p, e->c1);
    fmpq_poly_add(p, p, t);
    fmpq_poly_set_si(t, 3);
    fmpq_poly_add(p, p, t);
    fmpq_poly_neg(p, p);
    for (int i = 0; i < 3; i++)
        fmpq_poly_mullow(p, p, inverse, terms);
}

/* The series of x y z u v w: each turn of x = x_0 + int u, u = u_0 + int u'(x, u) adds a degree. */
static void series_of_motion(fmpq_poly_struct *x, const struct exact_motion *e, slong most)
{
    static const int own[] = {3, 0, -1};
    fmpq_poly_t p, inverse, rate[6];
    fmpq_poly_init(p);
    fmpq_poly_init(inverse);
    for (int i = 0; i < 6; i++) {
        fmpq_poly_init(rate[i]);
        fmpq_poly_set_fmpq(x + i, e->state + i);
    }
    for (slong terms = 1; terms < most; terms++) {
        series_of_force(p, inverse, e, x, terms);
        for (int i = 0; i < 3; i++) {
            fmpq_poly_mullow(rate[3 + i], p, x + i, terms);
            fmpq_poly_scalar_mul_si(inverse, x + i, own[i]);
            fmpq_poly_add(rate[3 + i], rate[3 + i], inverse);
            if (i < 2) {
                fmpq_poly_scalar_mul_si(inverse, x + 4 - i, i == 0 ? 2 : -2);
                fmpq_poly_add(rate[3 + i], rate[3 + i], inverse);
            }
            fmpq_poly_set(rate[i], x + 3 + i);
        }
        for (int i = 0; i < 6; i++) {
            fmpq_poly_integral(x + i, rate[i]);
            fmpq_poly_set_coeff_fmpq(x + i, 0, e->state + i);
            fmpq_poly_truncate(x + i, terms + 1);
        }
    }
    for (int i = 0; i < 6; i++)
        fmpq_poly_clear(rate[i]);
    fmpq_poly_clear(p);
    fmpq_poly_clear(inverse);
}

/* A ball about another number, that reaches back */
static void move_and_widen(arb_t x, double wide)
{
    SCOPE(arb, shift);
    arb_set_d(shift, wide);
    arb_add(x, x, shift, PREC);
    arb_add_error(x, shift);
}

static void jet_of_exact(struct jet *jet, const struct exact_motion *e, slong order, slong prec, const double wide[3])
{
    SCOPE(arb, c1, c2);
    arb_set_fmpq(c1, e->c1, prec);
    arb_set_fmpq(c2, e->c2, prec);
    move_and_widen(c1, wide[1]);
    move_and_widen(c2, wide[2]);
    jet_init(jet, &closed_loop, order, NULL);
    jet_constants(jet, c1, c2);
    for (int v = 0; v < JET_STATES; v++) {
        arb_set_fmpq(jet->c[v], e->state + v, prec);
        move_and_widen(jet->c[v], wide[0]);
    }
}

/* In 32 bits, and in falling precision, the balls hold the fractions. */
EACH(T13_coefficients_in_balls_hold_the_exact_ones, CLOSED_LOOPS)
{
    static const struct {
        slong prec;
        double fall, wide[3]; /* state, c1, c2 */
    } runs[] = {{32, 0, {0}}, {60, 3, {0}}, {200, 8, {0}}, {200, 8, {0x1p-60}}, {32, 0, {0x1p-20}},
                {200, 8, {0, 0x1p-60}}, {60, 1, {0, 0, 0x1p-20}}};
    OWNED(exact_motion) e;
    fmpq_poly_struct x[6];
    SCOPE(fmpq, c);
    exact_motion_init(&e, _i);
    for (int i = 0; i < 6; i++)
        fmpq_poly_init(x + i);
    series_of_motion(x, &e, EXACT_TERMS);
    for (size_t run = 0; run < sizeof runs / sizeof *runs; run++) {
        OWNED(jet) jet;
        jet_of_exact(&jet, &e, EXACT_TERMS - 1, runs[run].prec, runs[run].wide);
        jet_extend(&jet, &jet, runs[run].prec, runs[run].fall);
        for (int i = 0; i < 6; i++)
            for (slong k = 0; k < EXACT_TERMS; k++) {
                fmpq_poly_get_coeff_fmpq(c, x + i, k);
                ck_assert_msg(arb_contains_fmpq(jet.c[i] + k, c), "run %zu: coefficient %ld of %d", run, (long)k, i);
            }
    }
    for (int i = 0; i < 6; i++)
        fmpq_poly_clear(x + i);
}

/*
 * Ten bits, and a direction in which the radius stays a fraction: x grows by x, u by (1, 2, 3). What the coefficients
 * change by, over 2^-200, is the derivative to some 2^-190.
 */
EACH(T13_columns_in_balls_hold_the_exact_derivatives, CLOSED_LOOPS)
{
    enum { SHIFT = 200, TERMS = 6, BITS = 10 };
    OWNED(exact_motion) e, moved;
    OWNED(jet) jet, column;
    fmpq_poly_struct x[6], y[6];
    SCOPE(fmpq, delta, c);
    SCOPE(arb, truth);
    exact_motion_init(&e, _i);
    exact_motion_init(&moved, _i);
    fmpq_one(delta);
    fmpq_div_2exp(delta, delta, SHIFT);
    for (int i = 0; i < 3; i++) {
        fmpq_addmul(moved.state + i, moved.state + i, delta);
        fmpq_set_si(c, i + 1, 1);
        fmpq_addmul(moved.state + 3 + i, c, delta);
    }
    fmpq_addmul(moved.r, moved.r, delta);
    jet_of_exact(&jet, &e, TERMS, BITS, (double[3]){0});
    jet_init(&column, &closed_loop, TERMS, NULL);
    for (int i = 0; i < 3; i++) {
        arb_set(column.c[i], jet.c[i]);
        arb_set_si(column.c[3 + i], i + 1);
    }
    arb_neg(column.c[Q], jet.c[Q]);
    jet_extend(&jet, &jet, BITS, 0);
    jet_extend(&column, &jet, BITS, 0);
    for (int i = 0; i < 6; i++) {
        fmpq_poly_init(x + i);
        fmpq_poly_init(y + i);
    }
    series_of_motion(x, &e, TERMS + 1);
    series_of_motion(y, &moved, TERMS + 1);
    for (int i = 0; i < 6; i++)
        for (slong k = 0; k <= TERMS; k++) {
            fmpq_poly_sub(y + i, y + i, x + i);
            fmpq_poly_get_coeff_fmpq(c, y + i, k);
            fmpq_poly_add(y + i, y + i, x + i);
            fmpq_div(c, c, delta);
            arb_set_fmpq(truth, c, 2 * SHIFT);
            mag_set_ui_2exp_si(arb_radref(truth), 1, -150);
            ck_assert_msg(arb_overlaps(column.c[i] + k, truth), "coefficient %ld of %d", (long)k, i);
        }
    for (int i = 0; i < 6; i++) {
        fmpq_poly_clear(x + i);
        fmpq_poly_clear(y + i);
    }
}

/* Orders 2 to 6, and steps that grow until none is proved any more: what is proved holds the six degrees beyond. */
EACH(T11_rests_of_the_closed_loop_hold_up_to_the_longest_step, 5 * CLOSED_LOOPS)
{
    enum { BEYOND = 7 };
    const slong n = 2 + _i % 5;
    OWNED(exact_motion) e;
    OWNED(jet) jet;
    OWNED(majorant) m;
    fmpq_poly_struct x[JET_STATES];
    SCOPE(fmpq_poly, force);
    SCOPE(fmpq, c, exact);
    SCOPE(mag, h, one);
    mag_one(one);
    exact_motion_init(&e, _i / 5);
    for (int i = 0; i < JET_STATES; i++)
        fmpq_poly_init(x + i);
    series_of_motion(x, &e, n + BEYOND);
    series_of_force(force, x + Q, &e, x, n + BEYOND);
    for (int i = 0; i < JET_STATES; i++) /* moduli */
        for (slong k = 0; k < n + BEYOND; k++) {
            fmpq_poly_get_coeff_fmpq(c, x + i, k);
            fmpq_abs(c, c);
            fmpq_poly_set_coeff_fmpq(x + i, k, c);
        }
    jet_of_exact(&jet, &e, n, PREC, (double[3]){0});
    jet_extend(&jet, &jet, PREC, 0);
    majorant_init(&m, &closed_loop, n);
    double step = 0x1p-14;
    bool proved = true;
    for (; proved && step < 4; step *= 1.25) {
        mag_set_d(h, step);
        mag_get_fmpq(exact, h);
        majorant_of(&m, &jet, one, 1, h);
        proved = majorant_prove(&m, NULL, h);
        for (int i = 0; i < JET_STATES && proved; i++) {
            ck_assert_int_lt(mag_cmp_2exp_si(m.remainder + i, 64), 0);
            SCOPE(fmpq, truth, weight);
            fmpq_one(weight);
            add_beyond(truth, x + i, n, exact, weight);
            mag_get_fmpq(c, m.remainder + i);
            ck_assert_msg(fmpq_cmp(c, truth) >= 0, "h %g, coordinate %d: %g for %g", step, i, fmpq_get_d(c), fmpq_get_d(truth));
        }
    }
    ck_assert(!proved && step > 0x1p-10);
    for (int i = 0; i < JET_STATES; i++)
        fmpq_poly_clear(x + i);
}

/*
 * m1 = 5, m2 = 3 and L_ref = 8 make r_ref = 3, Omega = 2^-14: the sheet's (3) under its (7) + (18) holds the table's rates,
 * and ref/, in some roundings of the largest part, is that too.
 */
EACH(eq03_closed_by_eq07_eq18_is_one_in_sheet_ref_and_flow, CLOSED_LOOPS)
{
    static const double tidal[] = {3, 0, -1}, Omega = 0x1p-14, k_c = 8.99e9;
    OWNED(exact_motion) e;
    VECTOR(fmpq, rate, JET_STATES);
    VECTOR(arb, in, 11);
    VECTOR(arb, Q, 2);
    VECTOR(arb, out, 3);
    SCOPE(fmpq, q, r_dot);
    exact_motion_init(&e, _i);
    closed_loop_rates(rate, e.state, e.c1, e.c2);
    for (int i = 0; i < 3; i++)
        fmpq_addmul(r_dot, e.state + i, e.state + 3 + i);
    fmpq_div(r_dot, r_dot, e.r);

    const double plain[] = {k_c, 5, 3, 8};
    for (int i = 0; i < 4; i++)
        arb_set_d(in + i, plain[i]);
    arb_set_fmpq(in + 4, e.c1, PREC);
    arb_mul_2exp_si(in + 4, in + 4, -28);
    arb_set_fmpq(in + 5, e.c2, PREC);
    arb_mul_2exp_si(in + 5, in + 5, -14);
    fmpq_sub_si(q, e.r, 1);
    arb_set_fmpq(in + 6, q, PREC);
    arb_mul_2exp_si(in + 6, in + 6, 3); /* dL = L_ref (r - 1) */
    arb_set_fmpq(in + 7, r_dot, PREC);
    arb_mul_2exp_si(in + 7, in + 7, 3 - 14);
    section_enclose(section_find(sheet(), "eq18"), in, PREC, Q);
    const struct ct_gains gains = {number(in + 4), number(in + 5)};
    const double dL = number(in + 6), dL_dot = number(in + 7);
    arb_set_d(in, Omega);
    for (int i = 0; i < 4; i++)
        arb_set_d(in + 1 + i, plain[i]);
    section_enclose(section_find(sheet(), "eq07"), in, PREC, Q + 1);
    arb_add(in + 4, Q, Q + 1, PREC);
    for (int i = 0; i < 6; i++) {
        arb_set_fmpq(in + 5 + i, e.state + i, PREC);
        arb_mul_ui(in + 5 + i, in + 5 + i, 3, PREC);
        arb_mul_2exp_si(in + 5 + i, in + 5 + i, i < 3 ? 0 : -14);
    }
    section_enclose(section_find(sheet(), "eq03"), in, PREC, out);

    const struct ct_params p = {.Omega = Omega, .k_c = k_c, .m1 = 5, .m2 = 3, .L_ref = 8};
    const struct ct_hill_state s = {number(in + 5), number(in + 6), number(in + 7), number(in + 8), number(in + 9), number(in + 10)};
    const struct ct_vector a = ct_hill_acceleration(
        p, s, ct_reference_charge_product(p, 8) + ct_charge_product_variation(p, gains, dL, dL_dot));
    const double of_ref[] = {a.x, a.y, a.z}, place[] = {s.x1, s.y1, s.z1};
    for (int i = 0; i < 3; i++) {
        fmpq_mul_si(q, rate + 3 + i, 3);
        fmpq_div_2exp(q, q, 28);
        ck_assert_msg(arb_contains_fmpq(out + i, q), "coordinate %d", i);
        ck_assert(fmpq_is_zero(q) || arb_rel_accuracy_bits(out + i) > PREC - 20);
        const double part = fabs(number(out + i)) + 3 * Omega * Omega * fabs(tidal[i] * place[i]) + 1e3 * Omega * Omega;
        ck_assert_double_le(fabs(of_ref[i] - fmpq_get_d(q)), 0x1p-48 * part);
    }
}

static void jet_at(struct jet *jet, slong order, slong prec)
{
    static const double start[JET_STATES] = {0.75, 0.5, -0.5, 0.125, -0.25, 0.0625, 0};
    SCOPE(arb, c1, c2);
    arb_set_ui(c1, 10);
    arb_set_ui(c2, 2);
    jet_init(jet, &closed_loop, order, NULL);
    jet_constants(jet, c1, c2);
    for (int v = 0; v < JET_STATES; v++)
        arb_set_d(jet->c[v], start[v]);
    arb_set_d(jet->c[6], 1.0625); /* 0.75^2 + 2 0.5^2 */
    arb_rsqrt(jet->c[6], jet->c[6], prec);
    jet_extend(jet, jet, prec, 0);
}

/* The column along the motion itself is the jet's derivative: of x(s + e), coefficient k is (k + 1) x_{k+1}. */
TEST(a_column_along_the_motion_is_its_derivative)
{
    OWNED(jet) jet, column;
    SCOPE(arb, expected);
    jet_at(&jet, 20, PREC);
    jet_init(&column, &closed_loop, 19, NULL);
    for (int v = 0; v < JET_STATES; v++)
        arb_set(column.c[v], jet.c[v] + 1);
    jet_extend(&column, &jet, PREC, 0);
    for (int v = 0; v < JET_STATES; v++)
        for (slong k = 0; k < 20; k++) {
            arb_mul_ui(expected, jet.c[v] + k + 1, (ulong)k + 1, PREC);
            ck_assert(arb_overlaps(column.c[v] + k, expected));
            ck_assert_int_gt(arb_rel_accuracy_bits(column.c[v] + k), 150);
        }
}

/* Falling precision gives the same series, as sharp as the fall says. */
TEST(coefficients_may_be_computed_to_falling_precision)
{
    OWNED(jet) full, falling;
    jet_at(&full, 60, PREC);
    jet_at(&falling, 60, PREC);
    for (int v = 0; v < JET_SERIES; v++)
        _arb_vec_zero(falling.c[v] + (v < JET_STATES), 60 + (v >= JET_STATES));
    jet_extend(&falling, &falling, PREC, 3);
    for (int v = 0; v < JET_SERIES; v++)
        for (slong k = 0; k <= 60 - (v >= JET_STATES); k++) {
            ck_assert(arb_contains(falling.c[v] + k, full.c[v] + k));
            ck_assert_int_gt(arb_rel_accuracy_bits(falling.c[v] + k), PREC - 3 * k - 60);
        }
}

/* ---- a system of its own: x' = x, y' = y^2, so that y = 1/(1 - s) from 1; the last state and the last term are the hard ones ---- */

enum { EASY, HARD, EASY_ONE, EASY_ALL };
static const struct term easy_terms[] = {{EASY, EASY_ONE, EASY, 1}, {HARD, HARD, HARD, 1}};
static const struct system easy = {2, 2, EASY_ALL, 2, easy_terms};

static bool prove_easy(struct majorant *m, slong order, double step)
{
    OWNED(jet) jet;
    SCOPE(mag, h, one);
    jet_init(&jet, &easy, order, NULL);
    for (int v = 0; v < EASY_ALL; v++)
        arb_one(jet.c[v]);
    jet_extend(&jet, &jet, 64, 0);
    for (slong k = 0; k <= order; k++)
        ck_assert(arb_is_one(jet.c[HARD] + k)); /* the geometric series */
    majorant_init(m, &easy, order);
    mag_set_d(h, step);
    mag_one(one);
    majorant_of(m, &jet, one, 1, h);
    const bool proved = majorant_prove(m, NULL, h);
    return proved;
}

/* Beyond degree n there is h^(n+1)/(1 - h), most of it from the products of known terms. */
RANGE(T1_the_last_term_has_its_products, 2, 8)
{
    OWNED(majorant) m;
    ck_assert(prove_easy(&m, _i, 0.25));
    ck_assert_double_ge(mag_get_d(m.remainder + HARD), pow(0.25, _i + 1) / 0.75);
}

/* The last state has no value at 1, nor has its series a sum at 2. */
EACH(T11_the_last_state_is_asked_too, 2)
{
    OWNED(majorant) m;
    ck_assert(!prove_easy(&m, 6, _i + 1));
}
