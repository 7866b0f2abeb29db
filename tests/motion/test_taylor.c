/*
 * verify/motion/taylor.h: the closed loop as a quadratic system, its series in balls, and a test for every error term of the
 * theorem in taylor.c. Where a term dominates, the system is another one, of which the solution is known in fractions.
 */
#include "tests/run.h"

#include <string.h>

#include "evaluate/sample.h"
#include "motion/flow.h"
#include "motion/taylor.h"
#include "text/scope.h"

CASE(all, NULL, flint_cleanup)

enum { PREC = 256 };

/* The states, one product, and constants, by their places in a jet */
enum { X, Y, Z, U, V, W, Q, G, S, P = 12, ONE, C1 = 16, HOLD = JET_ALL - 1 };

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

static const double SHORT = 0x1p-10;
#define A_LITTLE_MORE 1.01 /* all else is a thousandth of the first term left out */
#define MOST_BITS (1 + 0x1p-40) /* of a number that mag_t has to round up */

enum { KNOWN = 24 }; /* terms of an exponential; what is beyond is positive: bounds that fail without it, fail with it */

/* The series of X, U, V, W, Y or Q from that start, or the last of the constants */
static void known_series(fmpq_poly_t series, int v, const fmpq *start)
{
    static const int chain[] = {X, U, V, W};
    SCOPE(fmpq, c);
    fmpq_poly_set_si(series, v == HOLD ? 3 : 0);
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

/* X's polynomial: as its start says, of all powers below s^n, s^n/n! alone, or s^(n+1)/(n+1)! */
enum powers { AS_GIVEN, BELOW_N, N_ALONE, NEXT_ALONE };

/* A case: the product, a start, another start as derivative or none, and how many times as large as the truth a bound may be */
struct known_case {
    const char *term;
    int a, b;
    slong first_order, last_order;
    enum powers of_x;
    bool of_column;
    double at_most, start[JET_STATES], column[JET_STATES];
};

static void start_at_order(double start[JET_STATES], const double given[JET_STATES], enum powers of_x, slong n)
{
    static const int chain[] = {X, U, V, W};
    memcpy(start, given, JET_STATES * sizeof *start);
    for (int k = 0; k < 4 && of_x != AS_GIVEN; k++)
        start[chain[k]] = of_x == BELOW_N ? k < n : k == n + (of_x == NEXT_ALONE);
}

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
    for (int v = 0; v < JET_STATES; v++)
        fmpq_set_double(to + v, from[v]);
}

/* What is true of Z's remainder: of the integral of a b, or of da b + a db */
static void true_remainder(fmpq_t remainder, const struct known_case *c, const fmpq *start, const fmpq *column, slong n, const fmpq_t h)
{
    SCOPE(fmpq_poly, a, b, product, other);
    SCOPE(fmpq, one);
    fmpq_one(one);
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
    add_beyond(remainder, product, n, h, one);
}

static void assert_bounds(const mag_t remainder, const fmpq_t truth, double at_most, const char *term)
{
    SCOPE(fmpq, bound, ratio);
    mag_get_fmpq(bound, remainder);
    ck_assert_int_gt(fmpq_sgn(truth), 0);
    fmpq_div(ratio, bound, truth);
    ck_assert_msg(fmpq_cmp(bound, truth) >= 0, "%s: the bound is the truth times %.12g", term, fmpq_get_d(ratio));
    ck_assert_double_le(fmpq_get_d(ratio), at_most); /* else other terms might stand in for the one that is asked for */
}

/* The proved remainder holds the true one, and is no more than so many times as large. */
static void assert_remainder_of(const struct known_case *c, slong n)
{
    struct term system[JET_TERMS];
    double of_jet[JET_STATES], of_column[JET_STATES];
    OWNED(jet) jet, column;
    OWNED(majorant) base, m;
    VECTOR(fmpq, start, JET_STATES);
    VECTOR(fmpq, direction, JET_STATES);
    SCOPE(mag, h, one);
    SCOPE(fmpq, exact_h, truth);
    mag_one(one);
    mag_set_d(h, SHORT);
    mag_get_fmpq(exact_h, h);
    integral_of_product(system, c->a, c->b);
    start_at_order(of_jet, c->start, c->of_x, n);
    start_at_order(of_column, c->column, c->of_x, n);
    jet_known(&jet, n, system, of_jet, false);
    jet_known(&column, n, system, of_column, true);
    jet_extend(&jet, &jet, PREC, 0);
    jet_extend(&column, &jet, PREC, 0);
    majorant_init(&base, &closed_loop, n);
    majorant_init(&m, &closed_loop, n);
    majorant_of(&base, &jet, one, 1, h);
    ck_assert(majorant_prove(&base, NULL, h));
    majorant_of(&m, &column, one, 1, h);
    ck_assert(majorant_prove(&m, &base, h));
    fractions(start, of_jet);
    fractions(direction, of_column);
    true_remainder(truth, c, start, direction, n, exact_h);
    assert_bounds((c->of_column ? m.remainder : base.remainder) + Z, truth, c->at_most, c->term);
}

/* ---- the error terms ---- */

static const struct known_case known_cases[] = {
    /* a polynomial of degree below n, squared: no tails, only what its known terms make */
    {"T1", X, X, 2, 5, BELOW_N, false, A_LITTLE_MORE, {0}, {0}},
    {"T2", Q, Y, 1, 6, AS_GIVEN, false, A_LITTLE_MORE, {[Q] = 3, [Y] = MOST_BITS}, {0}},
    {"T2: a constant", HOLD, Y, 1, 6, AS_GIVEN, false, A_LITTLE_MORE, {[Y] = MOST_BITS}, {0}},
    {"T3", Y, Q, 1, 6, AS_GIVEN, false, A_LITTLE_MORE, {[Q] = 3, [Y] = MOST_BITS}, {0}},
    /* s^n squared, where the remainder begins with degree 2n + 1 and the factor is h/(n+1) */
    {"T4", X, X, 1, 3, N_ALONE, false, 2, {0}, {0}},
    /* Q s^n/n!, whose remainder is exact: nothing beyond degree n */
    {"T5", Q, X, 1, 3, N_ALONE, false, 1 + 0x1p-20, {[Q] = 3}, {0}},
    /* Q s^(n+1)/(n+1)!: the tail is a remainder itself, and the bound the image of one that was doubled to be proved */
    {"T6", Q, X, 1, 2, NEXT_ALONE, false, 3.1, {[Q] = 3}, {0}},
    /* da b with da and b both growing, and a db: one of them alone each time; x dx + dx x, polynomials of degree below n: no tails;
       and tails alone, s^n and s^n, one of which is the column's */
    {"T8: da b", X, Y, 1, 6, AS_GIVEN, true, A_LITTLE_MORE, {[X] = 5, [U] = 7, [Y] = 1}, {[X] = 1, [U] = 1, [V] = 1, [W] = 1}},
    {"T8: a db", X, Y, 1, 6, AS_GIVEN, true, A_LITTLE_MORE, {[X] = 1, [U] = 1, [V] = 1, [W] = 1, [Y] = 9}, {[Y] = 1}},
    {"T8: both products of a square", X, X, 2, 5, BELOW_N, true, A_LITTLE_MORE, {0}, {0}},
    {"T8: products of tails", X, X, 1, 3, N_ALONE, true, 2, {0}, {0}},
};

EACH(T1_to_T8_a_bound_holds_what_is_true, COUNT(known_cases))
{
    for (slong n = known_cases[_i].first_order; n <= known_cases[_i].last_order; n++)
        assert_remainder_of(&known_cases[_i], n);
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
        assert_bounds(m.remainder + X, truth, 1 + 0x1p-25, "T7, T12");
    }
}

/* Three exponentials from 1, 2 and 3 under weights 1/2, 1/4 and 4: as one of 13. And one from the ball 0 +- 13. */
RANGE(T9_T10_a_majorant_has_every_column_and_its_radius, 1, 7)
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
    assert_bounds(m.remainder + Y, truth, A_LITTLE_MORE, "T9");
    mag_one(weights);
    majorant_of(&m, column + 3, weights, 1, h);
    ck_assert(majorant_prove(&m, &base, h));
    assert_bounds(m.remainder + Y, truth, A_LITTLE_MORE, "T10");
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

RANGE(T11_nothing_is_proved_that_does_not_converge, 1, 12)
{
    for (int v = 0; v < JET_STATES; v++)
        assert_proved_within_the_circle(v, _i);
}

/* ---- the closed loop, in few bits and in many ---- */

enum { LOOPS = 10 };

/* Places around the centre, with gains that hold the pair or let it go; `wide` are the states, c1, c2 on either side of middles so far off. */
static void start_loop(struct jet *jet, int number, slong order, slong prec, const double wide[3])
{
    static const slong place[][3] = {{2, 3, 6}, {1, -2, 2}, {-4, 4, 7}, {1, 0, 0}, {6, -6, -3}};
    const bool held = number < COUNT(place);
    SCOPE(arb, c1, c2, off);
    arb_ptr at[FLOW_STATE + 2] = {c1, c2};
    jet_init(jet, &closed_loop, order, NULL);
    for (int i = 0; i < FLOW_STATE; i++)
        at[2 + i] = jet->c[i];
    for (int i = 0; i < FLOW_STATE + 2; i++) {
        arb_set_si(at[i], i == 0 ? (held ? 31 : -4) : i == 1 ? (held ? 7 : -9) : i < 5 ? place[number % COUNT(place)][i - 2] : 3 * i - 17);
        arb_div_ui(at[i], at[i], i == 0 ? 3 : i < 5 ? 5 : 11, prec);
        arb_set_d(off, wide[i == 0 ? 1 : i == 1 ? 2 : 0]);
        arb_add(at[i], at[i], off, PREC);
        arb_add_error(at[i], off);
    }
    jet_constants(jet, c1, c2);
    jet_start_q(jet, prec);
}

static const double EXACTLY[3];

/* In 32 bits, in falling precision, and of balls about other numbers that reach back */
EACH(T13_coefficients_in_few_bits_hold_those_in_many, LOOPS)
{
    enum { ORDER = 17 };
    static const struct {
        slong prec;
        double fall, wide[3];
    } runs[] = {{32, 0, {0}}, {60, 3, {0}}, {200, 8, {0}}, {200, 8, {0x1p-60}}, {32, 0, {0x1p-20}},
                {200, 8, {0, 0x1p-60}}, {60, 1, {0, 0, 0x1p-20}}};
    OWNED(jet) truth;
    start_loop(&truth, _i, ORDER, PREC, EXACTLY);
    jet_extend(&truth, &truth, PREC, 0);
    for (int run = 0; run < COUNT(runs); run++) {
        OWNED(jet) jet;
        start_loop(&jet, _i, ORDER, runs[run].prec, runs[run].wide);
        jet_extend(&jet, &jet, runs[run].prec, runs[run].fall);
        for (int v = 0; v < JET_STATES; v++)
            for (slong k = 0; k <= ORDER; k++)
                ck_assert_msg(arb_contains(jet.c[v] + k, truth.c[v] + k), "run %d: coefficient %ld of %d", run, (long)k, v);
    }
}

/* In ten bits; x grows by x, u by (1, 2, 3) */
EACH(T13_columns_in_few_bits_hold_those_in_many, LOOPS)
{
    enum { FEW, MANY, ORDER = 6 };
    static const slong bits[] = {10, PREC};
    struct jet jet[2], column[2];
    for (int j = FEW; j <= MANY; j++) {
        start_loop(&jet[j], _i, ORDER, bits[j], EXACTLY);
        jet_init(&column[j], &closed_loop, ORDER, NULL);
        for (int i = 0; i < 3; i++) {
            arb_set(column[j].c[i], jet[j].c[i]);
            arb_set_si(column[j].c[3 + i], i + 1);
        }
        jet_start_column_q(&column[j], &jet[j], bits[j]);
        jet_extend(&jet[j], &jet[j], bits[j], 0);
        jet_extend(&column[j], &jet[j], bits[j], 0);
    }
    for (int v = 0; v < JET_STATES; v++)
        for (slong k = 0; k <= ORDER; k++)
            ck_assert_msg(arb_contains(column[FEW].c[v] + k, column[MANY].c[v] + k), "coefficient %ld of %d", (long)k, v);
    for (int j = FEW; j <= MANY; j++) {
        jet_clear(&jet[j]);
        jet_clear(&column[j]);
    }
}

/* Orders 2 to 6, and steps that grow until none is proved any more: what is proved holds the six degrees beyond. */
EACH(T11_remainders_of_the_closed_loop_hold_up_to_the_longest_step, 5 * LOOPS)
{
    enum { BEYOND = 6 };
    const slong n = 2 + _i % 5;
    OWNED(jet) jet, more;
    OWNED(majorant) m;
    SCOPE(arb, truth, x, bound);
    SCOPE(mag, h, one);
    mag_one(one);
    start_loop(&jet, _i / 5, n, PREC, EXACTLY);
    start_loop(&more, _i / 5, n + BEYOND, PREC, EXACTLY);
    jet_extend(&jet, &jet, PREC, 0);
    jet_extend(&more, &more, PREC, 0);
    majorant_init(&m, &closed_loop, n);
    double step = 0x1p-14;
    bool proved = true;
    for (; proved && step < 4; step *= 1.25) {
        mag_set_d(h, step);
        majorant_of(&m, &jet, one, 1, h);
        proved = majorant_prove(&m, NULL, h);
        for (int v = 0; v < JET_STATES && proved; v++) {
            ck_assert_int_lt(mag_cmp_2exp_si(m.remainder + v, 64), 0);
            arb_zero(truth);
            for (slong k = n + 1; k <= n + BEYOND; k++) {
                arb_set_d(x, step);
                arb_pow_ui(x, x, (ulong)k, PREC);
                arb_mul(x, x, more.c[v] + k, PREC);
                arb_abs(x, x);
                arb_add(truth, truth, x, PREC);
            }
            arf_set_mag(arb_midref(bound), m.remainder + v);
            ck_assert_msg(arb_ge(bound, truth), "h %g, coordinate %d: %g for %g", step, v, number(bound), number(truth));
        }
    }
    ck_assert(!proved && step > 0x1p-10);
}

/* The column along the motion itself is the jet's derivative: of x(s + e), coefficient k is (k + 1) x_{k+1}. */
EACH(a_column_along_the_motion_is_its_derivative, LOOPS)
{
    OWNED(jet) jet, column;
    SCOPE(arb, expected);
    start_loop(&jet, _i, 20, PREC, EXACTLY);
    jet_extend(&jet, &jet, PREC, 0);
    jet_init(&column, &closed_loop, 19, NULL);
    for (int i = 0; i < FLOW_STATE; i++)
        arb_set(column.c[i], jet.c[i] + 1);
    jet_start_column_q(&column, &jet, PREC);
    jet_extend(&column, &jet, PREC, 0);
    for (int v = 0; v < JET_STATES; v++)
        for (slong k = 0; k < 20; k++) {
            arb_mul_ui(expected, jet.c[v] + k + 1, (ulong)k + 1, PREC);
            ck_assert(arb_overlaps(column.c[v] + k, expected));
            ck_assert(mag_cmp_2exp_si(arb_radref(column.c[v] + k), -100) < 0); /* of numbers below 2^50 */
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
