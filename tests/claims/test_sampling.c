/*
 * How long the law may be held, and how late it may act, by other roads than the program's: the multipliers of the exact matrix
 * exponential of the model with its charge held, and the zeros of the characteristic function counted by how often its
 * values turn around 0. Motions are followed by the classical Runge-Kutta method in double, by (3) and the law as they are said.
 */
#include "claims/claim.h"
#include "claims/guarantee.h"
#include "claims/sampling.h"
#include "claims/second_order.h"
#include "claims/trajectory.h"
#include "motion/motion.h"
#include "tests/paper.h"
#include "tests/run.h"
#include "text/scope.h"

#include <string.h>

#include <complex.h> /* after FLINT, which has names I of its own */

enum { BITS = 256, STATES = 4 };

/* c1, c2; and T, d in hours at Omega = 7.2915e-5 rad/s, to what is known of them from elsewhere */
static const struct {
    double c1, c2, T, d;
} gains[] = {
    {10, 2, 1.6, 0.69}, {12, 3.4641016151377544, 2.5, 0.84}, {12, 4, 2.1, 0.88}, {9.5, 1.4142135623730951, 0, 0},
    {15, 4.898979485566356, 0, 0}, {40, 11.135528725660043, 0, 0}, {9.01, 5, 0, 0}, {30, 12, 0, 0},
};

TEST(eq43_eq44_gains_are_those_of_n)
{
    SCOPE(arb, c1, c2);
    SCOPE(fmpq, c);
    for (slong bits = 20; bits <= 64; bits += 11) {
        set_gains(c1, c2, "9.7", NULL, bits);
        fmpq_set_si(c, 97, 10);
        ck_assert(arb_contains_fmpq(c1, c));
        arb_sqr(c2, c2, BITS); /* 4 (n - 9) */
        fmpq_set_si(c, 14, 5);
        ck_assert(arb_contains_fmpq(c2, c) && arb_rel_accuracy_bits(c2) > bits - 10);
        set_gains(c1, c2, "12", "3.7", bits);
        fmpq_set_si(c, 37, 10);
        ck_assert(arb_equal_si(c1, 12) && arb_contains_fmpq(c2, c));
    }
}

/* The largest |multiplier| where the law is held for T: of E + F K, (E, F; 0, 1) = exp((A, B; 0, 0) T). */
static void largest_multiplier(arb_t size, const arb_t T, double c1, double c2)
{
    static const signed char model[STATES][STATES + 1] = {{0, 0, 1, 0, 0}, {0, 0, 0, 1, 0}, {-3, 0, 0, -2, 0}, {0, 9, 2, 0, 1}};
    MATRIX(arb, X, STATES + 1, STATES + 1);
    SCOPE(arb_poly, p);
    SCOPE(acb_poly, q);
    SCOPE(arb, gain, part);
    VECTOR(acb, z, STATES);
    for (int i = 0; i < STATES; i++)
        for (int j = 0; j <= STATES; j++)
            arb_mul_si(arb_mat_entry(X, i, j), T, model[i][j], BITS);
    arb_mat_exp(X, X, BITS);
    for (int i = 0; i < STATES; i++) {
        arb_set_d(gain, -c1);
        arb_addmul(arb_mat_entry(X, i, 1), arb_mat_entry(X, i, STATES), gain, BITS);
        arb_set_d(gain, -c2);
        arb_addmul(arb_mat_entry(X, i, 3), arb_mat_entry(X, i, STATES), gain, BITS);
    }
    for (int i = 0; i <= STATES; i++)
        arb_zero(arb_mat_entry(X, i, STATES)); /* a multiplier 0 more */
    arb_mat_charpoly(p, X, BITS);
    arb_poly_shift_right(p, p, 1);
    acb_poly_set_arb_poly(q, p);
    ck_assert_int_eq(acb_poly_find_roots(z, q, NULL, 0, BITS), STATES);
    arb_zero(size);
    for (int i = 0; i < STATES; i++) {
        acb_abs(part, z + i, BITS);
        arb_max(size, size, part, BITS);
    }
}

/* T or d, as one decides with them. */
static void largest(arb_t limit, const char *name, const arb_t c1, const arb_t c2, slong prec)
{
    VECTOR(arb, values, GUARANTEES);
    ck_assert(guarantees_enclose(values, steps(), c1, c2, NULL, prec));
    arb_set(limit, values + guarantee_find(name));
}

EACH(H1_H2_all_multipliers_lie_inside_the_unit_circle_up_to_the_longest_hold_and_not_beyond, COUNT(gains))
{
    enum { STEPS = 50, CLOSE = 1000000 };
    SCOPE(arb, c1, c2, longest, T, size, one);
    arb_set_d(c1, gains[_i].c1);
    arb_set_d(c2, gains[_i].c2);
    largest(longest, "hold", c1, c2, BITS);
    ck_assert_int_ge(arb_rel_accuracy_bits(longest), BITS / 2);
    arb_one(one);
    for (slong k = 1; k <= STEPS + 1; k++) {
        arb_mul_si(T, longest, k <= STEPS ? k * (CLOSE / STEPS) - (k == STEPS) : CLOSE + 1, BITS);
        arb_div_si(T, T, CLOSE, BITS);
        largest_multiplier(size, T, gains[_i].c1, gains[_i].c2);
        ck_assert(k <= STEPS ? arb_lt(size, one) : arb_gt(size, one));
    }
    if (gains[_i].T > 0)
        ck_assert_double_eq_tol(arf_get_d(arb_midref(longest), ARF_RND_NEAR) / 7.2915e-5 / 3600, gains[_i].T, 0.05);
}

static double complex characteristic(const double law[3], double complex s)
{
    return s * s * s * s - 2 * s * s - 27 + (law[0] + law[1] * s) * (s * s + 3) * cexp(-s * law[2]);
}

/* How far its values turn around 0 from a to b: halved until it is far from half a turn, which would be lost. */
static double turn(const double law[3], double complex a, double complex b)
{
    const double angle = carg(characteristic(law, b) / characteristic(law, a));
    return fabs(angle) < 0.5 ? angle : turn(law, a, (a + b) / 2) + turn(law, (a + b) / 2, b);
}

/* Zeros to the right of the axis: none lies further out than `far`. */
static int zeros_to_the_right(double c1, double c2, double d)
{
    enum { PARTS = 1000 };
    const double law[] = {c1, c2, d}, far = 4 * (c1 + c2 + 6);
    double turned = 0;
    for (int k = 0; k < PARTS; k++) {
        const double from = 2.0 * k / PARTS - 1, to = 2.0 * (k + 1) / PARTS - 1;
        turned -= turn(law, I * far * from, I * far * to);
        turned += turn(law, far * cexp(I * acos(0) * from), far * cexp(I * acos(0) * to));
    }
    return (int)lround(turned / (4 * acos(0)));
}

EACH(D1_D2_no_root_is_right_of_the_axis_up_to_the_largest_delay_and_a_pair_beyond, COUNT(gains))
{
    SCOPE(arb, c1, c2, longest);
    arb_set_d(c1, gains[_i].c1);
    arb_set_d(c2, gains[_i].c2);
    largest(longest, "delay", c1, c2, BITS);
    ck_assert_int_ge(arb_rel_accuracy_bits(longest), BITS / 2);
    const double d = arf_get_d(arb_midref(longest), ARF_RND_NEAR);
    for (int tenth = 0; tenth < 10; tenth++)
        ck_assert_int_eq(zeros_to_the_right(gains[_i].c1, gains[_i].c2, d * tenth / 10), 0);
    ck_assert_int_eq(zeros_to_the_right(gains[_i].c1, gains[_i].c2, d * 0.9999), 0);
    ck_assert_int_eq(zeros_to_the_right(gains[_i].c1, gains[_i].c2, d * 1.0001), 2);
    if (gains[_i].d > 0)
        ck_assert_double_eq_tol(d / 7.2915e-5 / 3600, gains[_i].d, 0.005);
}

/* Where roundings are the only error, as few bits as find the limits still hold those of many. */
EACH(H3_D3_limits_of_few_bits_hold_those_of_many, COUNT(gains))
{
    static const slong few[] = {20, 24, 28, 32, 40, 53};
    SCOPE(arb, c1, c2, limit, exact);
    int found = 0;
    arb_set_d(c1, gains[_i].c1);
    arb_set_d(c2, gains[_i].c2);
    for (int k = 0; k < 2 * COUNT(few); k++) {
        largest(exact, k % 2 ? "hold" : "delay", c1, c2, BITS);
        largest(limit, k % 2 ? "hold" : "delay", c1, c2, few[k / 2]);
        ck_assert(!arb_is_finite(limit) || arb_contains(limit, exact));
        found += arb_is_finite(limit);
    }
    ck_assert_int_ge(found, COUNT(few));
}

/* One gain of an interval after the other: the limits at its ends lie in that of all of it. */
EACH(H3_D3_limits_of_an_interval_hold_those_of_its_ends, 2 * COUNT(gains) + 2)
{
    SCOPE(arb, whole, exact);
    VECTOR(arb, c, 2);
    const bool last = _i / 2 == COUNT(gains); /* gains of which the crossing hardly rests on c2 */
    const double of[] = {last ? 1000 : gains[_i / 2].c1, last ? 0.5 : gains[_i / 2].c2}, off = ldexp(of[_i % 2], -20);
    for (int k = 0; k < 2; k++)
        arb_set_d(c + k, of[k]);
    mag_set_d(arb_radref(c + _i % 2), 1.001 * off);
    largest(whole, "delay", c, c + 1, BITS);
    ck_assert(arb_is_finite(whole));
    for (int end = -1; end <= 1; end += 2) {
        arb_set_d(c + _i % 2, of[_i % 2] + end * off);
        largest(exact, "delay", c, c + 1, BITS);
        ck_assert(arb_contains(whole, exact));
    }
}

TEST(H3_what_few_bits_do_not_prove_stays_open)
{
    SCOPE(arb, c1, c2, longest);
    arb_set_ui(c1, 12);
    arb_set_ui(c2, 4);
    mag_set_ui(arb_radref(c1), 1);
    largest(longest, "hold", c1, c2, BITS);
    ck_assert(!arb_is_finite(longest));
    arb_set_ui(c1, 100000); /* of gains as strong as these it is found all the same */
    arb_set_ui(c2, 632);
    largest(longest, "hold", c1, c2, BITS);
    ck_assert_int_ge(arb_rel_accuracy_bits(longest), BITS / 2);
}

/* ---- motions: x y z and rates, in radians of orbit and units of the arm ---- */

struct held_or_moved {
    double c1, c2, S_re, S_im;
    bool held;
    double command; /* Q/Q_ref, where it is held */
};

static void distance(const double s[6], double *r, double *rate)
{
    *r = sqrt(s[0] * s[0] + s[1] * s[1] + s[2] * s[2]);
    *rate = (s[0] * s[3] + s[1] * s[4] + s[2] * s[5]) / *r;
}

/* Q/Q_ref, the length asked for being 1 + sigma */
static double command(const struct held_or_moved *l, const double s[6])
{
    double r, rate;
    distance(s, &r, &rate);
    const double sine = s[2] / r, sine_rate = s[5] / r - s[2] * rate / (r * r);
    const double sigma = l->S_re * (sine * sine - sine_rate * sine_rate / 4) + l->S_im * sine * sine_rate;
    return 1 + (l->c1 * (r - 1 - sigma) + l->c2 * rate) / 3;
}

static void motion(const struct held_or_moved *l, const double s[6], double f[6])
{
    double r, rate;
    distance(s, &r, &rate);
    const double pull = -3 * (l->held ? l->command : command(l, s)) / (r * r * r);
    const double rates[] = {s[3], s[4], s[5], 2 * s[4] + 3 * s[0] + pull * s[0], -2 * s[3] + pull * s[1], -s[2] + pull * s[2]};
    memcpy(f, rates, sizeof rates);
}

static void follow_in_double(const struct held_or_moved *l, double s[6], double tau, int steps)
{
    static const double at[] = {0, 0.5, 0.5, 1}, weight[] = {1, 2, 2, 1};
    const double h = tau / steps;
    for (int k = 0; k < steps; k++) {
        double sum[6] = {0}, f[6] = {0}, here[6];
        for (int stage = 0; stage < 4; stage++) {
            for (int i = 0; i < 6; i++)
                here[i] = s[i] + h * at[stage] * f[i];
            motion(l, here, f);
            for (int i = 0; i < 6; i++)
                sum[i] += weight[stage] * f[i];
        }
        for (int i = 0; i < 6; i++)
            s[i] += h * sum[i] / 6;
    }
}

static double middle(const arb_t x)
{
    return arf_get_d(arb_midref(x), ARF_RND_NEAR);
}

/* The state of a sample. */
static void state_of(double s[6], arb_srcptr sample)
{
    FLOW_PARAMETERS(p);
    VECTOR(arb, state, FLOW_STATE);
    arb_one(p.m1);
    arb_one(p.m2);
    arb_set_ui(p.L_ref, 2);
    _arb_vec_set(state, sample, FLOW_STATE);
    arb_mul_2exp_si(state + ETA, state + ETA, 1);
    arb_mul_2exp_si(state + ETA_DOT, state + ETA_DOT, 1);
    state_from_angles(state, sheet(), &p, BITS);
    for (int i = 0; i < 6; i++)
        s[i] = middle(state + i);
}

TEST(a_held_law_moves_the_pair_as_the_reference_says)
{
    enum { COUNT = 20, SECONDS = 3429 };
    static const double start[] = {-0.03, 0.01, 0.02, 0.02, -0.03, 0.001}; /* psi, theta, eta and their rates */
    struct held_or_moved l = {12, 4, 0, 0, true, 0};
    double s[6];
    VECTOR(arb, samples, COORDINATES * (COUNT + 1));
    SCOPE(arb, c1, c2);
    for (int i = 0; i < 6; i++)
        arb_set_d(samples + i, start[i]);
    arb_set_ui(c1, 12);
    arb_set_ui(c2, 4);
    ck_assert(hold_follow(samples, steps(), c1, c2, SECONDS, COUNT, 10));
    state_of(s, samples);
    for (int k = 1; k <= COUNT; k++) {
        l.command = command(&l, s);
        follow_in_double(&l, s, 7.2915e-5 * SECONDS, 100);
        for (int i = 0; i < 3; i++) /* a step errs by 0.0025^5, and grows with e^2.5 a radian where it is held */
            ck_assert_double_eq_tol(s[i], middle(samples + COORDINATES * k + PLACE_X + i), 1e-9);
    }
    mag_set_d(arb_radref(samples + PSI), 0.5); /* from a box that the first hold is not proved of no further one is */
    ck_assert(!hold_follow(samples, steps(), c1, c2, SECONDS, 2, 10));
}

/* From a box of one coordinate's or gain's values, the corner among the motions. */
EACH(a_held_law_is_followed_from_all_of_a_box, 32)
{
    enum { C = COORDINATES, SECONDS = 1714 };
    VECTOR(arb, at, 2 * C + 2);
    VECTOR(arb, all, 2 * C + 2);
    SCOPE(arb, away);
    static const double corner[] = {-0.03, 0.01, 0.02, 0.02, -0.03, 0.001, 100, 20};
    const int which = _i / 2 % 8, wide = which < 6 ? which : 2 * C + which - 6;
    for (int i = 0; i < 8; i++) /* gains by which the charge outweighs the tide, and by which the length outweighs that */
        arb_set_d(at + (i < 6 ? i : 2 * C + i - 6), i < 6 || _i < 16 ? corner[i] : 1);
    _arb_vec_set(all, at, 2 * C + 2);
    ck_assert(hold_follow(at, steps(), at + 2 * C, at + 2 * C + 1, SECONDS, 1, 10));
    arb_set_d(away, _i % 2 ? 1e-8 : -1e-8);
    arb_add(all + wide, all + wide, away, 256);
    mag_set_d(arb_radref(all + wide), 1.001e-8);
    ck_assert(hold_follow(all, steps(), all + 2 * C, all + 2 * C + 1, SECONDS, 1, 2));
    for (int i = 0; i < C; i++)
        ck_assert(arb_contains(all + C + i, at + C + i));
}

TEST(a_length_that_moves_with_pitch_moves_the_pair_as_the_law_says)
{
    struct trajectory t;
    SCOPE(arb, x, ratio, tau);
    double s[6];
    const struct simulation moved = {.steps = steps(), .nonlinear = true, .digits = 12, .forced = true, .theta = "0.02", .swing = "0.01"};
    ck_assert(trajectory_run(&t, &moved, 0, 137143, 137143)); /* 10 radians */
    arb_srcptr start = trajectory_sample(&t, 0);
    /* at z = a the length swings in quadrature, by a hundredth: dL = 0, dL' = -4/100 */
    ck_assert_double_eq_tol(middle(start + ETA), 0, 1e-12);
    ck_assert_double_eq_tol(middle(start + ETA_DOT), -0.04, 1e-5);
    state_of(s, start);
    const struct held_or_moved l = {10, 2, middle(second_order_get(&t.closed, "S_re")), middle(second_order_get(&t.closed, "S_im")), false, 0};
    trajectory_value(x, &t, 0, PRODUCT);
    ck_assert_double_eq_tol(middle(x), command(&l, s) - 1, 1e-12);
    follow_in_double(&l, s, 137143 * 7.2915e-5, 5000);
    for (int i = 0; i < 3; i++) /* a step errs by 0.002^5 */
        ck_assert_double_eq_tol(s[i], middle(trajectory_sample(&t, 1) + PLACE_X + i), 1e-9);
    slow_law(ratio, x, &t.closed, t.amplitude, tau);
    ck_assert(arb_is_one(ratio));
    arb_set_ui(tau, 10); /* a' = -18/13 (swing/a^2) a^3 */
    slow_law(ratio, x, &t.closed, t.amplitude, tau);
    ck_assert_double_eq_tol(middle(ratio), 1 / sqrt(1 + 2 * 18.0 / 13 * 0.01 * 10), 1e-12);
    for (int k = 0; k < 2; k++) { /* whole seconds, to 7e-5 radians */
        trajectory_slow_law(x, &t, k);
        ck_assert_double_eq_tol(middle(x), 0.02 * (k == 0 ? 1 : middle(ratio)), 1e-6);
    }
    VECTOR(arb, b, BOUNDS);
    ck_assert(!trajectory_bounds(b, &t, 0)); /* of another law */
    trajectory_clear(&t);
}

/* ---- the numbers that claims are given ---- */

static const struct {
    const char *computation, *names[14];
} computed[] = {
    {"of_gains", {"hold_10", "hold_118", "delay_12", "delay_best", "A_10", "A_best", "B_10", "B_best", "decay_12", "shift_118", "level_10", "along_step_best", NULL}},
    {"held_motion", {"hold", "length_30", "length_60", "length_90", "yaw_30", "yaw_60", "yaw_90", NULL}},
    {"damped", {"amplitude_10", "law_10", "gap_10", "charge_10", "amplitude_best", "law_best", "gap_best", "charge_best", NULL}},
};

/* They are there, and balls; the last samples of a damped motion are among those that its largest gap and charge are of. */
EACH(numbers_of_claims_are_balls, COUNT(computed))
{
    struct computations all = {.steps = steps()};
    struct computed *c = computed_find(&all, computed[_i].computation);
    SCOPE(arb, x, y, z);
    for (int i = 0; computed[_i].names[i] != NULL; i++)
        computed_ask(c, computed[_i].names[i]);
    for (int i = 0; computed[_i].names[i] != NULL; i++) {
        computed_number(c, computed[_i].names[i], x);
        ck_assert_msg(arb_is_finite(x) && !arb_is_exact(x) && arb_rel_accuracy_bits(x) > 8, "%s", computed[_i].names[i]);
        if (_i == 2 && computed[_i].names[i][0] != 'l') /* of motions of 5 digits, as of 40 to 60 bits near the start; the law has more */
            ck_assert_msg(arb_rel_accuracy_bits(x) < 70, "%s", computed[_i].names[i]);
    }
    if (_i == 2) {
        computed_number(c, "amplitude_best", x);
        computed_number(c, "law_best", y);
        arb_sub(x, x, y, BITS);
        arb_div(x, x, y, BITS);
        arb_abs(x, x);
        computed_number(c, "gap_best", z);
        ck_assert(arb_le(x, z) || arb_overlaps(x, z));
    }
    computations_clear(&all);
}
