/*
 * verify/motion/motion.h: which scenarios are no motions, what is derived from their values, and which rows a receiver gets.
 */
#include "tests/run.h"
#include "tests/paper.h"

#include <stdio.h>
#include <stdlib.h>

#include "motion/motion.h"
#include "text/scope.h"

static void give(struct scenario *s, enum scenario_name name, slong numerator, ulong denominator)
{
    fmpq_set_si(&s->value[name].value, numerator, denominator);
    s->given[name] = true;
}

/* ---- domains ---- */

struct given {
    enum scenario_name name;
    slong numerator, denominator;
};

static const struct {
    struct given of[6];
    bool linear, nonlinear;
    const char *says;
} domains[] = {
    {{{SET_Omega, 0, 1}}, false, false, "Omega: expected a number > 0"},
    {{{SET_L_ref, 0, 1}}, false, false, "L_ref: expected a number > 0"},
    {{{SET_k_c, 0, 1}}, false, false, "k_c: expected a number > 0"},
    {{{SET_m1, 0, 1}}, false, false, "m1: expected a number > 0"},
    {{{SET_m2, 0, 1}}, false, false, "m2: expected a number > 0"},
    {{{SET_m2, -1, 1}}, false, false, "m2: expected a number > 0"},
    {{{SET_n, 9, 1}}, true, true, NULL},
    {{{SET_n, 89, 10}}, false, false, "n: expected a number >= 9"},
    {{{SET_n, 19, 2}}, true, true, NULL},
    {{{SET_n, 5, 1}, {SET_C1, 1, 1}}, true, true, NULL},
    {{{SET_n, 5, 1}, {SET_C2, 1, 1}}, true, true, NULL},
    {{{SET_dL, -10, 1}}, true, false, "dL: expected the two craft apart"},
    {{{SET_dL, -11, 1}}, true, false, "dL: expected the two craft apart"},
    {{{SET_dL, -9, 1}}, true, true, NULL},
    {{{SET_x1, 0, 1}, {SET_y1, 0, 1}, {SET_z1, 0, 1}}, true, false, "x1 y1 z1: expected the two craft apart"},
    {{{SET_x1, 1, 1}, {SET_y1, 0, 1}, {SET_z1, 0, 1}}, true, true, NULL},
    {{{SET_x1, 0, 1}, {SET_y1, 1, 1}, {SET_z1, 0, 1}}, true, true, NULL},
    {{{SET_x1, 0, 1}, {SET_y1, 0, 1}, {SET_z1, 1, 1}, {SET_dL, -11, 1}}, true, true, NULL},
};

EACH(outside_its_domain_a_scenario_is_refused, COUNT(domains))
{
    OWNED(scenario) s;
    struct message why;
    scenario_init(&s, sheet(), false);
    for (int i = 0; i < 6 && domains[_i].of[i].denominator != 0; i++)
        give(&s, domains[_i].of[i].name, domains[_i].of[i].numerator, (ulong)domains[_i].of[i].denominator);
    ck_assert_int_eq(scenario_valid(&s, false, &why), domains[_i].linear);
    ck_assert_int_eq(scenario_valid(&s, true, &why), domains[_i].nonlinear);
    if (domains[_i].says != NULL)
        ck_assert_ptr_nonnull(strstr(why.text, domains[_i].says));
}

/* L_ref + dL = 10.1 m within 11 m, or 9 m; and what is said of a box is said of one alone. */
TEST(a_box_is_refused_where_some_of_it_is_outside)
{
    OWNED(scenario) s;
    struct message why;
    scenario_init(&s, sheet(), true);
    fmpq_set_si(s.radius + SET_L_ref, 6, 1);
    fmpq_set_si(s.radius + SET_dL, 5, 1);
    ck_assert(!scenario_valid(&s, true, &why) && strstr(why.text, "in all of the box") != NULL);
    fmpq_set_si(s.radius + SET_dL, 3, 1);
    ck_assert(scenario_valid(&s, true, &why));
    for (int i = 0; i < SCENARIO_VALUES; i++)
        fmpq_zero(s.radius + i);
    give(&s, SET_m1, 0, 1);
    ck_assert(!scenario_valid(&s, true, &why) && strstr(why.text, "box") == NULL);
    fmpq_one(s.radius + SET_z1_dot);
    ck_assert(!scenario_valid(&s, true, &why) && strstr(why.text, "in all of the box") != NULL);
    give(&s, SET_m1, 1, 1);
    fmpq_one(s.radius + SET_m1); /* a mass, and a place, within 1 of 1 may be 0 */
    ck_assert(!scenario_valid(&s, true, &why));
    fmpq_zero(s.radius + SET_m1);
    for (int i = SET_x1; i <= SET_z1; i++)
        give(&s, (enum scenario_name)i, i == SET_x1, 1);
    ck_assert(scenario_valid(&s, true, &why));
    fmpq_one(s.radius + SET_x1);
    ck_assert(!scenario_valid(&s, true, &why));
}

/* ---- what is derived ---- */

/* Of thirds, in so few bits that their balls are wide; n = 28/3: C1 = n Omega^2, C2 = 2 sqrt(n - 9) Omega */
TEST(parameters_are_the_exact_values_in_balls)
{
    enum { BITS = 8 };
    static const enum scenario_name names[] = {SET_Omega, SET_L_ref, SET_k_c, SET_m1, SET_m2};
    OWNED(scenario) s;
    FLOW_PARAMETERS(p);
    SCOPE(fmpq, exact, half);
    SCOPE(arb, square);
    arb_ptr found[] = {p.Omega, p.L_ref, p.k_c, p.m1, p.m2};
    scenario_init(&s, sheet(), true);
    for (int i = 0; i < 5; i++)
        give(&s, names[i], 3 * i + 1, 3);
    give(&s, SET_n, 28, 3);
    scenario_parameters(&p, &s, BITS);
    for (int i = 0; i < 5; i++)
        ck_assert(arb_contains_fmpq(found[i], &s.value[names[i]].value));
    fmpq_mul(exact, &s.value[SET_Omega].value, &s.value[SET_Omega].value);
    fmpq_mul(exact, exact, &s.value[SET_n].value);
    ck_assert(arb_contains_fmpq(p.C1, exact));
    arb_sqr(square, p.C2, 64);
    fmpq_set_si(half, 4, 27); /* C2^2 = 4 (n - 9) Omega^2 */
    ck_assert(arb_contains_fmpq(square, half));
    ck_assert(mag_cmp_2exp_si(arb_radref(p.C1), 0) < 0); /* known at all */
    give(&s, SET_C1, 1, 7);
    give(&s, SET_C2, 2, 7);
    for (int given = 1; given < 4; given++) { /* one of them, the other by n, or both */
        s.given[SET_C1] = given & 1;
        s.given[SET_C2] = given & 2;
        scenario_parameters(&p, &s, BITS);
        arb_sqr(square, p.C2, 64);
        ck_assert(arb_contains_fmpq(p.C1, given & 1 ? &s.value[SET_C1].value : exact));
        ck_assert(given & 2 ? arb_contains_fmpq(p.C2, &s.value[SET_C2].value) : arb_contains_fmpq(square, half));
    }
}

/* Of either model, by either kind of start: each number at its own place, in its ball */
EACH(initial_states_are_those_given, 3)
{
    enum { BITS = 8 };
    const bool nonlinear = _i > 0, angles = _i < 2;
    OWNED(scenario) s;
    FLOW_PARAMETERS(p);
    VECTOR(arb, initial, FLOW_STATE);
    VECTOR(arb, expected, FLOW_STATE);
    scenario_init(&s, sheet(), true);
    for (int i = 0; i < FLOW_STATE; i++)
        give(&s, (enum scenario_name)((angles ? SET_psi : SET_x1) + i), i + 1, 7);
    scenario_parameters(&p, &s, BITS);
    scenario_initial(initial, &s, &p, nonlinear, BITS);
    for (int i = 0; i < FLOW_STATE; i++)
        arb_set_fmpq(expected + i, &s.value[(angles ? SET_psi : SET_x1) + i].value, 64);
    if (nonlinear && angles)
        state_from_angles(expected, sheet(), &p, 64);
    for (int i = 0; i < FLOW_STATE; i++) {
        ck_assert(nonlinear && angles ? arb_overlaps(initial + i, expected + i) : arb_contains_fmpq(initial + i, &s.value[(angles ? SET_psi : SET_x1) + i].value));
        ck_assert(!(nonlinear && angles) || !arb_contains_fmpq(initial + i, &s.value[SET_psi + i].value));
    }
}

/* ---- rows ---- */

struct rows {
    slong count, stop_after;
    char first[ROW_NUMBERS][40];
};

static int count_row(void *context, slong k, const fmpq_t t, char *const *numbers)
{
    struct rows *r = context;
    (void)t;
    ck_assert_int_eq(k, r->count++);
    for (int i = 0; i < ROW_NUMBERS; i++)
        snprintf(r->first[i], sizeof r->first[i], "%.39s", numbers[i] != NULL ? numbers[i] : "");
    return r->count == r->stop_after;
}

/* The rows of a scenario: from the paper's with what is given, every so many seconds */
struct asked {
    struct scenario s;
    struct message why;
    struct rows rows;
    struct motion motion;
};

static void asked_clear(struct asked *a)
{
    scenario_clear(&a->s);
}

static void asked_init(struct asked *a, struct motion motion)
{
    *a = (struct asked){.motion = motion};
    scenario_init(&a->s, sheet(), false);
    a->motion.scenario = &a->s;
}
#define ASKED(a, ...) OWNED(asked) a; asked_init(&a, (struct motion){__VA_ARGS__})

static int ask(struct asked *a, slong count, slong seconds)
{
    VECTOR(fmpq, times, count);
    for (slong k = 0; k < count; k++)
        fmpq_set_si(times + k, seconds * (count > 1 ? k : 1), 1);
    a->rows.count = 0;
    return motion_rows(&a->motion, times, count, count_row, &a->rows, &a->why);
}

/* No gains, and 1e-18 m from rest: after 17 radians that is e^2.5 each, 62 of the first 60 bits to spare, and what has been handed
   on is not handed on again. */
TEST(rows_that_take_more_bits_come_once)
{
    enum { ROWS = 14 };
    ASKED(a, .nonlinear = true, .digits = 8);
    for (int i = SET_psi; i <= SET_dL_dot; i++)
        give(&a.s, (enum scenario_name)i, 0, 1);
    give(&a.s, SET_dL, 1, 1000000000000000000);
    give(&a.s, SET_C1, 0, 1);
    give(&a.s, SET_C2, 0, 1);
    ck_assert_msg(ask(&a, ROWS, 20000) == 0, "%s", a.why.text);
    ck_assert_int_eq(a.rows.count, ROWS);
    a.rows.stop_after = 3;
    ck_assert_int_eq(ask(&a, ROWS, 20000), 0);
    ck_assert_int_eq(a.rows.count, 3);
}

/* Omega = 1/32: all is exact. At rest Q = -3 Omega^2 L^3 m1 m2/(k_c (m1 + m2)), q1 its root: 3/8 C, and of small angles x1 = L m2/(m1 + m2) */
TEST(a_row_is_in_the_unit_that_is_asked_for)
{
    ASKED(a, .nonlinear = true, .charges = true, .digits = 6);
    char (*row)[40] = a.rows.first;
    give(&a.s, SET_Omega, 1, 32);
    give(&a.s, SET_k_c, 1, 3);
    give(&a.s, SET_m1, 1, 1);
    give(&a.s, SET_m2, 1, 1);
    give(&a.s, SET_L_ref, 4, 1);
    for (int i = SET_psi; i <= SET_dL_dot; i++)
        give(&a.s, (enum scenario_name)i, 0, 1);
    for (int micro = 0; micro < 2; micro++) {
        const double q = micro ? 530330 : 0.530330; /* sqrt(9/32) */
        a.motion.microcoulomb = micro;
        ck_assert_msg(ask(&a, 1, 0) == 0, "%s", a.why.text);
        ck_assert_double_eq_tol(strtod(row[FLOW_STATE], NULL), q, 2e-6 * q);
        ck_assert_double_eq_tol(strtod(row[FLOW_STATE + 1], NULL), -q, 2e-6 * q);
    }
    a.motion = (struct motion){.scenario = &a.s, .small_angles = true, .digits = 6};
    give(&a.s, SET_psi, 1, 4);
    give(&a.s, SET_theta, 1, 8);
    give(&a.s, SET_dL, 4, 1);
    give(&a.s, SET_m1, 3, 1);
    ck_assert_int_eq(ask(&a, 1, 0), 0);
    ck_assert_double_eq(strtod(row[0], NULL), 2);
    ck_assert_double_eq(strtod(row[1], NULL), 0.5);
    ck_assert_double_eq(strtod(row[2], NULL), -0.25);
}

/* 2 kg and 1 kg at 3 m: craft 1 rests 1 m from the centre of mass, on either side, and where nothing else is displaced. */
EACH(equilibria_are_where_the_masses_have_them, FLOW_STATE)
{
    SCOPE(fmpq, m1, m2, L_ref);
    INPUTS(state);
    fmpq_set_si(m1, 2, 1);
    fmpq_set_si(m2, 1, 1);
    fmpq_set_si(L_ref, 3, 1);
    fmpq_set_si(&state[_i].value, 1, 1 << 20);
    for (int x = -2; x <= 2; x++) {
        fmpq_set_si(&state[0].value, x, 1);
        ck_assert_int_eq(is_static(m1, m2, L_ref, state), _i == 0 && (x == 1 || x == -1));
    }
}

/* From the angles or from x1 = 10/3 m: where nothing is displaced all stays, exactly; where anything is, x1 does not. */
EACH(only_the_static_formation_stays, 2 * (1 + FLOW_STATE))
{
    const int displaced = _i / 2;
    const bool angles = _i % 2;
    ASKED(a, .nonlinear = true, .digits = 3);
    for (int i = 0; i < FLOW_STATE; i++)
        give(&a.s, (enum scenario_name)((angles ? SET_psi : SET_x1) + i), (i == displaced ? 3 : 0) + (i == 0 && !angles ? 10 << 20 : 0), 3 << 20);
    give(&a.s, SET_m1, 100, 1);
    give(&a.s, SET_m2, 50, 1);
    ck_assert_msg(ask(&a, 1, 1000) == 0, "%s", a.why.text);
    ck_assert_int_eq(strcmp(a.rows.first[FLOW_HALF + 1], "0") == 0, displaced == FLOW_STATE); /* y1_dot, which none of them begins with but psi_dot and itself */
}

/* ---- where rows end ---- */

/* Hardly damped and moving inwards: Q_ref + dQ = 0 where dL is -3 Omega^2 L_ref/C1 and C2 little; from one row to the next in tenths */
TEST(charges_end_within_a_millionth_of_a_step)
{
    double after, before;
    ASKED(a, .nonlinear = true, .charges = true, .digits = 6);
    give(&a.s, SET_C1, 53165972, 1000000000000000);
    give(&a.s, SET_C2, 1, 1000000000);
    give(&a.s, SET_psi, 0, 1);
    give(&a.s, SET_theta, 0, 1);
    give(&a.s, SET_dL, -29, 10);
    give(&a.s, SET_dL_dot, -3, 10000);
    ck_assert_int_eq(ask(&a, 7, 100), -1);
    ck_assert_int_eq(a.rows.count, 4);
    ck_assert_int_eq(sscanf(a.why.text, "Q_ref + dQ >= 0 from t = %lf s, proved < 0 at t = %lf s", &after, &before), 2);
    ck_assert_double_eq_tol(after, 355.77, 0.01);
    ck_assert_double_eq_tol(after - before, 1e-4, 1.5e-6); /* nine digits of each are told */
}

/* Omega = 1, dL = -3 L_ref/n: Q_ref + dQ is 0, exactly, and that is not below 0. */
TEST(charges_of_no_product_are_none)
{
    ASKED(a, .nonlinear = true, .charges = true, .digits = 6);
    for (int i = SET_m1; i <= SET_dL_dot; i++)
        give(&a.s, (enum scenario_name)i, i < SET_psi && i != SET_C2, 1);
    give(&a.s, SET_L_ref, 10, 1);
    give(&a.s, SET_C1, 10, 1);
    give(&a.s, SET_dL, -3, 1);
    ck_assert_int_eq(ask(&a, 1, 0), -1);
    ck_assert_msg(strstr(a.why.text, "Q_ref + dQ >= 0 at t = 0 s") != NULL, "%s", a.why.text);
    ck_assert_int_eq(a.rows.count, 0);
}

/* Kepler's fall: the craft meet after 0.58 radians, and nothing is said of what follows. */
TEST(a_motion_that_is_not_followed_to_its_end_is_no_success)
{
    ASKED(a, .nonlinear = true, .digits = 4);
    for (int i = 0; i < SCENARIO_VALUES; i++)
        if (i != SET_n && (i < SET_psi || i > SET_dL_dot))
            give(&a.s, (enum scenario_name)i, i < SET_n || i == SET_z1, 1);
    give(&a.s, SET_L_ref, 2, 1);
    ck_assert_int_eq(ask(&a, 1, 1), -1);
    ck_assert_msg(strstr(a.why.text, "closer than L_ref/128") != NULL, "%s", a.why.text);
    ck_assert_int_eq(a.rows.count, 0);
}

/* y1 = (1/3) 12 m 0.3125 = 1.25 m, a tie of two digits that an enclosure of 1/3 leaves undecided */
TEST(digits_that_no_bits_decide_are_given_up)
{
    ASKED(a, .small_angles = true, .digits = 2);
    give(&a.s, SET_m1, 100, 1);
    give(&a.s, SET_m2, 50, 1);
    give(&a.s, SET_dL, 2, 1);
    give(&a.s, SET_psi, 5, 16);
    ck_assert_int_eq(ask(&a, 1, 0), -1);
    ck_assert_ptr_nonnull(strstr(a.why.text, "bits do not decide every digit of row 1"));
    ck_assert_int_eq(a.rows.count, 0);
}
