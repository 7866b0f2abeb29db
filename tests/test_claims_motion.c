/*
 * The claims about the simulation, and the tracks that they rest on. Digits come from mpmath 1.2.1 with
 *
 *     mp.dps = 40; Om = mpf('7.2915e-5')
 *     A = lambda n: the matrix of (40) over psi theta l psi' theta' l', l = dL/L_ref, in radians of orbit
 *     rows of the linear model: expm(A(n)*Om*T)*matrix([0.01, 0.01, 0.01, 0, 0, 0])
 *     rows of the nonlinear model: odefun(f, 0, [0.01, 0.01, 0.01, 0, 0, 0])(Om*T), f with c1 = n, c2 = 2*sqrt(n - 9):
 *         psi''   = -2*(l'/l - theta'*tan(theta))*(1 + psi') - 3*sin(psi)*cos(psi)
 *         theta'' = -2*l'/l*theta' - sin(theta)*cos(theta)*((1 + psi')**2 + 3*cos(psi)**2)
 *         l''     = l*(theta'**2 + cos(theta)**2*((1 + psi')**2 + 3*cos(psi)**2) - 1) + (c1*(1 - l) - 3 - c2*l')/l**2
 *     with l = 1 + dL/L_ref, Lagrange's equations in the angles, which the flow knows nothing of
 *
 * and the expressions that stand beside them.
 */
#include <stdlib.h>
#include <string.h>

#include "claims.h"
#include "verify/track.h"

enum { DAY = 86400 };

/* ---- the verdicts ---- */

const struct claim *const lists[] = {claims_motion, claims_convergence, claims_forced, NULL};

const struct expected_claim expected[] = {
    /* the largest of 2592 steps, R = sum((A(10)*100*Om)**k/k!, k = 0 ... p) against expm(A(10)*100*Om): p = 4 has
       7.3483986e-12, 1.3625865e-10, 5.8378502e-12 in psi, theta, dL/L_ref */
    {"step-small-enough", HOLDS, CERTIFIED, "linear model 7.4e-12, 1.4e-10, 5.9e-12;"},
    {"step-order", HOLDS, CERTIFIED, "4.00, 4.00, 4.00 (linear model)"},
    /* p = 1: 6.8761404e-5, 0.0031660532, 7.2604884e-5; 2: 4.1687472e-7, 1.28139e-5; 3: 1.8534135e-9, 4.8746389e-8 */
    {"runge-kutta-kind", NOT_DECIDABLE, CERTIFIED,
     "Euler's 0.32, 0.0073; second order 0.0013, 4.2e-05; third order 4.9e-06, 1.9e-07; fourth order 1.4e-08, 7.4e-10"},
    {"two-revolutions", HOLDS, CERTIFIED, "2.00531 revolutions"}, /* 172800*Om/(2*pi) = 2.0053085 */
    /* psi(2 d) = 3.16895001526e-5 and dL(2 d)/L_ref = 2.76209999640e-5, and less from there on */
    {"settling-linear", HOLDS, CERTIFIED, "|psi| <= 0.0032 of its initial value, |dL| <= 0.0028 of its"},
    {"length-wiggle", HOLDS, CERTIFIED, "(n = 10) changes sign exactly 3 times"}, /* at 5.31, 28.5, 51.1 h */
    {"length-wiggle", HOLDS, CERTIFIED, "n = 12 changes sign exactly 7 times"},   /* 5.31, 16.6, ... 70.7 h */
    /* 1 - (psi'**2 + 3*psi**2)/(3*0.01**2) after two days, from psi above and psi' = -1.7450238805e-5 */
    {"yaw-energy", HOLDS, CERTIFIED, " takes 0.9999889 of "},
    {"figure-5b", HOLDS, CERTIFIED, "at most 5.1e-04,"}, /* 5.05*(1 - cos(0.01)**2) = 5.0498e-4, at the start */
    {"linear-first-phase", HOLDS, CERTIFIED, "exceeded in psi never, in dL never"},
    /* nonlinear less linear after a day for 1e-6 at the start: 0.10868051e-12, 1.1740994e-12, 0.74260254e-12 in psi,
       theta, dL/L_ref; in x1 0.24175652e-12 */
    {"linear-second-order", HOLDS, CERTIFIED, "c = 0.109, 1.17, 0.743, 0.242, 0.109, 1.17"},
    {"settling-nonlinear", HOLDS, CERTIFIED, "masses of 10 and 1000 kg |psi| <= 0.0030, |dL| <= 0.0042"},
    {"slower-without-pitch", REFUTED, CERTIFIED, "no slower"},
    /* 0.0964020*a**2/0.01 and 0.2152296*a**2/0.01 for a = 0.0101003, the amplitude of pitch after 8 days */
    {"slower-with-pitch", QUALIFIED, CERTIFIED, "; 9.84e-04, 0.00220 (linear"},
    {"pitch-nonlinear", QUALIFIED, CERTIFIED, "0.010135 rad"},
    {"figure-6", QUALIFIED, CERTIFIED, "|z1| up to 0.0505 m"},
    {"charges-opposite", HOLDS, CERTIFIED, "|dQ/Q_ref| <= 0.034,"}, /* 10*0.01/3 at the start */
    {"charges-deviation", HOLDS, CERTIFIED, "|q/q_ref - 1| <= 0.017,"}, /* 1 - sqrt(1 - 10*0.01/3) = 0.01681 */
    {"charges-converge", QUALIFIED, CERTIFIED, "there they converge"},
    {"charges-microcoulomb", HOLDS, CERTIFIED, "q_ref = sqrt(-Q_ref) = 0.3647777 uC"}, /* 1e6*Om*sqrt(3e3*75/8.99e9) */
    {"charges-microcoulomb", HOLDS, CERTIFIED, "0.3708075 uC at the start"},           /* ... times sqrt(1 + 1/30) */
    {"figures-lost", NOT_DECIDABLE, EXACT, "lost"},
    /* 1.5*(1.01*sin(0.01)*cos(0.01))**2 + 2*(1.01*sin(0.01))**2 + 7*(1/1.01 - 1) + 10*log(1.01) - 1.5*(1.01**2 - 1) */
    {"nonlinear-energy", HOLDS, CERTIFIED, "E = 4.0339e-04"},
    /* s = sqrt(n - 9), D = 13*s**2 - 144 + 104j*s: 36/abs(D), 2*s*abs(s + 8j)/abs(D), 5184*s/abs(D)**2, and
       4.5*s**2*(13*s**2 + 688)/abs(D)**2 */
    {"forced-response", HOLDS, EXACT, "10: 0.2152, 0.09640, -0.1853, -0.1128"},
    {"forced-response", HOLDS, EXACT, "11.8: 0.1760, 0.1337, -0.2072, -0.2180"},
    {"forced-response", HOLDS, EXACT, "12: 0.1727, 0.1360, -0.2065, -0.2258"},
    {"forced-response-flow", HOLDS, CERTIFIED, "= 4.00, 5.00, 4.00;"},
    {"pitch-slow-law", HOLDS, CERTIFIED, "by the closed form 0.185"},
    {NULL, VERDICT_NONE, EXACT, NULL},
};

enum { EXPECTED = sizeof expected / sizeof expected[0] - 1 };

/* ---- tracks ---- */

/* The decimal, correctly rounded, lies within its last digit of x. */
static void assert_ball(const arb_t x, const char *decimal)
{
    arb_t y, ulp;
    arb_init(y);
    arb_init(ulp);
    ck_assert_int_eq(arb_set_str(y, decimal, 128), 0);
    arb_abs(ulp, y);
    arb_div_ui(ulp, ulp, 1000000000000000000, 128); /* of 20 digits: 1e-19 to 1e-18 of the value */
    arb_add_error(y, ulp);
    ck_assert_msg(arb_contains(y, x), "expected %s", decimal);
    arb_clear(ulp);
    arb_clear(y);
}

static const struct {
    struct scene scene;
    long t;
    const char *row[FLOW_STATE];
} rows[] = {
    {{.nonlinear = true}, DAY,
     {"-0.00051919039432752793543", "0.010109703619573078919", "-0.00048982902021780843763",
      "0.00018224005908025071397", "-0.00058035170483073109219", "0.00032264746127382402889"}},
    {{.nonlinear = true, .n = "12"}, DAY / 2,
     {"-0.00096565386471418280316", "0.010121395535846329674", "-0.00095274623899147378971",
      "0.0002654313825681201308", "-0.00026596517007763062899", "0.0009355982417933442636"}},
    {{.nonlinear = false}, 2 * DAY,
     {"0.0000316895001526696145", "0.0099777752772584487092", "0.00002762099996404412912",
      "-0.000017450238805324580614", "-0.0013326672750992079326", "-0.000039379184900871486339"}},
    {{.n = "12"}, 3 * DAY,
     {"1.4082079012703849094e-8", "0.0099500175331959826108", "-3.6020993809182304457e-8",
      "-1.1486353536523273143e-7", "-0.0019971490571237121188", "-7.8508583102803106936e-8"}},
};

START_TEST(tracks_agree_with_the_equations_in_the_angles)
{
    struct track t;
    ck_assert(track_run(&t, &rows[_i].scene, 0, rows[_i].t, rows[_i].t));
    for (int i = 0; i < FLOW_STATE; i++)
        assert_ball(track_row(&t, 1) + i, rows[_i].row[i]);
    track_clear(&t);
}
END_TEST

/* Nothing in these rows knows the masses: (3) closed by (7) and (18) has none in the angles and the distance. */
START_TEST(tracks_are_the_same_for_all_masses)
{
    struct track equal, unequal;
    ck_assert(track_run(&equal, &(struct scene){.nonlinear = true}, DAY, DAY, 3 * DAY));
    ck_assert(track_run(&unequal, &(struct scene){.nonlinear = true, .m1 = "3", .m2 = "3000"}, DAY, DAY, 3 * DAY));
    for (slong k = 0; k < 3; k++)
        for (int i = 0; i < COORDINATES; i++)
            ck_assert(arb_overlaps(track_row(&equal, k) + i, track_row(&unequal, k) + i));
    track_clear(&unequal);
    track_clear(&equal);
}
END_TEST

/* A row is where a start from it begins: angles to place and back. */
START_TEST(eq10_tracks_start_where_another_ends)
{
    struct track whole, half, rest;
    ck_assert(track_run(&whole, &(struct scene){.nonlinear = true}, 0, DAY, DAY));
    ck_assert(track_run(&half, &(struct scene){.nonlinear = true}, 0, DAY / 4, DAY / 4));
    const struct scene from = {.nonlinear = true, .start = track_row(&half, 1)};
    ck_assert(track_run(&rest, &from, 0, 3 * DAY / 4, 3 * DAY / 4));
    for (int i = 0; i < COORDINATES; i++)
        ck_assert(arb_overlaps(track_row(&whole, 1) + i, track_row(&rest, 1) + i));
    track_clear(&rest);
    track_clear(&half);
    track_clear(&whole);
}
END_TEST

/* E falls from row to row, and by what C2 takes: -c2 (l'/l)^2, or -c2 eta'^2, by the trapezoidal rule. */
START_TEST(energy_falls_by_what_the_gain_takes)
{
    struct track t;
    arb_ptr x = _arb_vec_init(4);
    ck_assert(track_run(&t, &(struct scene){.nonlinear = _i != 0, .theta = "0.03"}, 0, 10, 7200));
    double lost = 0;
    for (slong k = 0; k < t.count; k++) {
        track_energy(x + k % 2, &t, k);
        if (k > 0)
            ck_assert(arb_lt(x + k % 2, x + (k + 1) % 2));
        arb_add_ui(x + 2, track_row(&t, k) + ETA, _i != 0, t.prec);
        arb_div(x + 3, track_row(&t, k) + ETA_DOT, x + 2, t.prec);
        arb_sqr(x + 3, _i != 0 ? x + 3 : track_row(&t, k) + ETA_DOT, t.prec);
        lost += (k == 0 || k == t.count - 1 ? 0.5 : 1) * 2 * arf_get_d(arb_midref(x + 3), ARF_RND_NEAR) * 7.2915e-4;
    }
    track_energy(x, &t, 0);
    track_energy(x + 1, &t, t.count - 1);
    arb_sub(x, x, x + 1, t.prec);
    /* 720 intervals of 7.3e-4 rad: the rule errs by some 1e-6 of the whole */
    ck_assert_double_eq_tol(arf_get_d(arb_midref(x), ARF_RND_NEAR) / lost, 1, 1e-5);
    track_clear(&t);
    _arb_vec_clear(x, 4);
}
END_TEST

/* The rows of later times keep the bounds of an early one, and their differences those of the derivatives. */
START_TEST(bounds_hold_for_what_follows)
{
    struct track t;
    struct bounds b;
    arb_ptr x = _arb_vec_init(2);
    bounds_init(&b);
    ck_assert(track_run(&t, &(struct scene){.nonlinear = _i != 0}, 0, 600, 2 * DAY));
    for (slong from = 0; from < 3; from++) {
        ck_assert(track_bounds(&b, &t, 40 * from));
        for (int i = 0; i < COORDINATES; i++)
            for (slong k = 40 * from; k + 2 < t.count; k++) {
                arb_srcptr now = track_row(&t, k) + i, next = track_row(&t, k + 1) + i, last = track_row(&t, k + 2) + i;
                arb_abs(x, now);
                ck_assert_msg(arb_le(x, b.of[i]), "coordinate %d, row %ld", i, (long)k);
                arb_add(x, now, last, t.prec); /* |f0 - 2 f1 + f2| <= tau^2 max |f''| */
                arb_submul_ui(x, next, 2, t.prec);
                arb_abs(x, x);
                track_room(x + 1, &t, &b, i);
                arb_mul_2exp_si(x + 1, x + 1, 3);
                ck_assert_msg(arb_le(x, x + 1), "second difference of %d, row %ld", i, (long)k);
            }
    }
    bounds_clear(&b);
    track_clear(&t);
    _arb_vec_clear(x, 2);
}
END_TEST

/* With n = 10 the hill of E is at dL = 1.0728 m, (sqrt(93) - 3)/6 = 1.10728: beyond, E holds nothing. */
START_TEST(bounds_are_refused_beyond_the_hill)
{
    static const struct {
        const char *dL;
        bool bounded;
    } starts[] = {{"0.9", true}, {"1.08", false}, {"3", false}, {"-3", false}};
    struct bounds b;
    bounds_init(&b);
    for (size_t i = 0; i < sizeof starts / sizeof starts[0]; i++) {
        struct track t;
        const struct scene s = {.nonlinear = true, .psi = "0", .theta = "0", .dL = starts[i].dL};
        ck_assert(track_run(&t, &s, 0, 1, 0));
        ck_assert_int_eq(track_bounds(&b, &t, 0), starts[i].bounded);
        track_clear(&t);
    }
    bounds_clear(&b);
}
END_TEST

/* Between rows a day apart the motion goes beyond them: as far as track_sup allows, at most. */
START_TEST(suprema_cover_what_rows_miss)
{
    struct track coarse, fine;
    arb_t sup, peak;
    arb_init(sup);
    arb_init(peak);
    const struct scene s = {.nonlinear = true};
    ck_assert(track_run(&coarse, &s, 0, DAY / 12, DAY));
    ck_assert(track_run(&fine, &s, 0, 100, DAY));
    for (int i = 0; i < COORDINATES; i++) {
        ck_assert(track_sup(sup, &coarse, i, 1, 12));
        track_peak(peak, &fine, i, 72, fine.count - 1);
        ck_assert(arb_le(peak, sup));
    }
    track_peak(peak, &coarse, ETA_DOT, 0, 12);
    track_peak(sup, &fine, ETA_DOT, 0, fine.count - 1);
    ck_assert(arb_lt(peak, sup));
    arb_clear(peak);
    arb_clear(sup);
    track_clear(&fine);
    track_clear(&coarse);
}
END_TEST

/* The linear dL is last above 1/100 of the start at 43.25 h, psi at 29.17 h: rows of the linear flow, 100 s apart. */
START_TEST(settling_is_found_between_rows)
{
    struct track t;
    arb_t hours, limit;
    arb_init(hours);
    arb_init(limit);
    ck_assert(track_run(&t, &(struct scene){.nonlinear = false}, 0, 200, 3 * DAY));
    arb_set_d(limit, 1e-4);
    ck_assert(track_settled(hours, &t, ETA, limit));
    ck_assert(is_above(hours, 43.15) && is_below(hours, 43.36));
    ck_assert(track_settled(hours, &t, PSI, limit));
    ck_assert(is_above(hours, 29.05) && is_below(hours, 29.28));
    arb_set_d(limit, 1e-9); /* not within three days */
    ck_assert(!track_settled(hours, &t, ETA, limit));
    arb_set_d(limit, 1); /* it was never above */
    ck_assert(!track_settled(hours, &t, ETA, limit));
    track_clear(&t);
    arb_clear(limit);
    arb_clear(hours);
}
END_TEST

/* A pair that separates turns over, or leaves binary64's reach: no track. */
START_TEST(tracks_end_where_the_pair_turns_over)
{
    struct track t;
    ck_assert(!track_run(&t, &(struct scene){.nonlinear = true, .psi = "1.6"}, 0, 100, 1000));
    track_clear(&t);
}
END_TEST

/* ---- evidence ---- */

START_TEST(bounds_are_written_outward)
{
    static const struct {
        slong over;
        ulong under;
        const char *text;
    } written[] = {{1, 800, "x 0.0013 m"}, {1, 8, "x 0.13 m"},       {-429, 10, "x 43 m"},
                   {431, 10, "x 44 m"},    {29, 20, "x 1.5e+00 m"}, {1, 81000, "x 1.3e-05 m"}};
    for (size_t i = 0; i < sizeof written / sizeof written[0]; i++) {
        struct evidence e = {0};
        arb_t x;
        arb_init(x);
        arb_set_si(x, written[i].over);
        arb_div_ui(x, x, written[i].under, 128);
        evidence_bound(&e, "x ", x, " m");
        ck_assert_str_eq(e.text, written[i].text);
        arb_clear(x);
    }
}
END_TEST

START_TEST(orders_within_their_tolerance)
{
    struct evidence e = {0};
    arb_t larger, smaller;
    arb_init(larger);
    arb_init(smaller);
    arb_set_ui(larger, 1005);
    arb_set_ui(smaller, 10);
    ck_assert(evidence_order(&e, "p = ", larger, smaller, 10, 2, 0.003)); /* log10 100.5 = 2.00217 */
    ck_assert_str_eq(e.text, "p = 2.00");
    ck_assert(!evidence_order(&e, "", larger, smaller, 10, 2, 0.002));
    ck_assert(!evidence_order(&e, "", larger, smaller, 10, 3, 0.003));
    arb_zero(smaller);
    ck_assert(!evidence_order(&e, "", larger, smaller, 10, 2, 0.003));
    arb_clear(smaller);
    arb_clear(larger);
}
END_TEST

START_TEST(comparisons_are_certain)
{
    arb_t x;
    arb_init(x);
    arb_set_ui(x, 2);
    mag_set_d(arb_radref(x), 0.5);
    ck_assert(is_below(x, 2.75) && !is_below(x, 2.25) && !is_below(x, 1));
    ck_assert(is_above(x, 1.25) && !is_above(x, 1.75) && !is_above(x, 3));
    arb_indeterminate(x);
    ck_assert(!is_below(x, 1) && !is_above(x, 1));
    arb_clear(x);
}
END_TEST

Suite *suite(void)
{
    Suite *s = suite_create("claims_motion");
    TCase *c = tcase_create("claims");
    tcase_add_checked_fixture(c, NULL, close_all);
    tcase_add_loop_test(c, claims_yield_their_verdicts, 0, EXPECTED);
    tcase_add_test(c, claims_are_well_formed);
    tcase_add_loop_test(c, tracks_agree_with_the_equations_in_the_angles, 0, sizeof rows / sizeof rows[0]);
    tcase_add_test(c, tracks_are_the_same_for_all_masses);
    tcase_add_test(c, eq10_tracks_start_where_another_ends);
    tcase_add_loop_test(c, energy_falls_by_what_the_gain_takes, 0, 2);
    tcase_add_loop_test(c, bounds_hold_for_what_follows, 0, 2);
    tcase_add_test(c, bounds_are_refused_beyond_the_hill);
    tcase_add_test(c, suprema_cover_what_rows_miss);
    tcase_add_test(c, settling_is_found_between_rows);
    tcase_add_test(c, tracks_end_where_the_pair_turns_over);
    tcase_add_test(c, bounds_are_written_outward);
    tcase_add_test(c, orders_within_their_tolerance);
    tcase_add_test(c, comparisons_are_certain);
    tcase_set_timeout(c, 60); /* s; under a sanitizer a claim takes some 5 */
    suite_add_tcase(s, c);
    return s;
}
