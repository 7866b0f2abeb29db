/*
 * verify/claims/trajectory.h: bounds between and after samples, and a test for every error term of the theorem in trajectory.c. Samples are
 * written by hand, so that what is true of them is known: the state of a given energy that goes furthest. And verify/motion.h:
 * what a row may leave out.
 */
#include "tests/claims/balls.h"
#include "tests/run.h"
#include "tests/paper.h"

#include "motion/motion.h"

enum { PREC = 128 };

/* ---- trajectories whose samples are known ---- */

/* One sample at rest in its place; gains c1 Omega^2 and c2 Omega, samples `step` seconds apart, 2^-14 rad/s */
static void trajectory_of(struct trajectory *t, bool nonlinear, slong count, long step, double c1, double c2)
{
    *t = (struct trajectory){.steps = steps(), .nonlinear = nonlinear, .prec = PREC, .count = count, .step = step};
    trajectory_init(t);
    arb_set_d(t->c1, c1);
    arb_set_d(t->c2, c2);
    arb_set_d(t->Omega, 0x1p-14);
}

static void assert_at_least(const arb_t bound, const arb_t truth, double at_most, const char *what, int number)
{
    SCOPE(arb, excess);
    arb_set_d(excess, at_most);
    arb_mul(excess, excess, truth, PREC);
    ck_assert_msg(arb_ge(bound, truth) || arb_overlaps(bound, truth), "%s %d: %.12g for %.12g", what, number,
                  arf_get_d(arb_midref(bound), ARF_RND_NEAR), arf_get_d(arb_midref(truth), ARF_RND_NEAR));
    ck_assert_msg(arb_le(bound, excess) || arb_overlaps(bound, excess), "%s %d: %.12g for %.12g, too much", what, number,
                  arf_get_d(arb_midref(bound), ARF_RND_NEAR), arf_get_d(arb_midref(truth), ARF_RND_NEAR));
}

/* ---- B1: between samples ---- */

/* A parabola with a second derivative of 1 stands tau^2/8 above samples a tau apart, and is that at the middle. */
CASE(error_terms, NULL, flint_cleanup)

EACH(B1_a_parabola_rises_above_its_samples_by_an_eighth, 3)
{
    OWNED(trajectory) t;
    VECTOR(arb, b, BOUNDS);
    SCOPE(arb, excess, truth);
    trajectory_of(&t, false, 1, 100 * (_i + 1), 10, 2);
    arb_set_ui(t.Omega, 1);
    arb_div_ui(t.Omega, t.Omega, 3 << 13, PREC);
    for (int i = 0; i < COORDINATES; i++) {
        _arb_vec_zero(b, BOUNDS);
        arb_one(b + BOUND_OF(i, 2));
        bound_between_samples(excess, &t, b, i);
        arb_set_si(truth, 100 * (_i + 1));
        arb_div_ui(truth, truth, 3 << 13, 2 * PREC);
        arb_sqr(truth, truth, 2 * PREC);
        arb_mul_2exp_si(truth, truth, -3);
        assert_at_least(excess, truth, 1 + 0x1p-100, "excess", i);
        ck_assert(arb_contains(excess, truth) && !arb_is_exact(excess)); /* a third is a ball */
    }
}

/* The charges' second derivative is (c1 eta'' + c2 eta^(3))/3: 10 and 2 of 1 and 5, over 3. */
TEST(B1_the_charges_have_both_their_terms)
{
    OWNED(trajectory) t;
    VECTOR(arb, b, BOUNDS);
    SCOPE(arb, excess, truth);
    trajectory_of(&t, false, 1, 1 << 12, 10, 2); /* a quarter of a radian */
    arb_one(b + BOUND_OF(ETA, 2));
    arb_set_ui(b + BOUND_OF(ETA_DOT, 2), 5);
    bound_between_samples(excess, &t, b, PRODUCT);
    arb_set_d(truth, 20 / 128.0);
    arb_div_ui(truth, truth, 3, 2 * PREC);
    ck_assert(arb_contains(excess, truth) && arb_rel_accuracy_bits(excess) > 100);
}

/* Of 3, -5, 4 and of 2, 7, -7: ends are samples too. */
TEST(B1_peaks_and_gaps_have_the_samples_at_the_ends)
{
    static const double values[2][3] = {{3, -5, 4}, {2, 7, -7}};
    static const struct {
        slong from, to, peak, gap;
    } all[] = {{0, 2, 5, 12}, {0, 0, 3, 1}, {0, 1, 5, 12}, {2, 2, 4, 11}, {1, 1, 5, 12}};
    struct trajectory t[2];
    SCOPE(arb, x);
    for (int i = 0; i < 2; i++) {
        trajectory_of(&t[i], false, 3, 100, 10, 2);
        for (int k = 0; k < 3; k++)
            arb_set_d(trajectory_sample(&t[i], k) + PSI, values[i][k]);
    }
    for (int i = 0; i < COUNT(all); i++) {
        trajectory_peak(x, &t[0], NULL, PSI, all[i].from, all[i].to);
        ck_assert(arb_equal_si(x, all[i].peak));
        trajectory_peak(x, &t[0], &t[1], PSI, all[i].from, all[i].to);
        ck_assert(arb_equal_si(x, all[i].gap));
    }
    trajectory_clear(&t[0]);
    trajectory_clear(&t[1]);
}

/* Pitch goes as cos 2 tau whatever the gains: its peak lies in the middle of two samples, and none but the excess has it. */
TEST(B1_a_supremum_has_the_peak_between_samples)
{
    OWNED(trajectory) t;
    SCOPE(arb, sup, one);
    arb_one(one);
    trajectory_of(&t, false, 2, 1 << 12, 10, 2); /* a quarter of a radian: cos(1/4) on both samples */
    for (slong k = 0; k < 2; k++) {
        arb_set_d(trajectory_sample(&t, k) + THETA, cos(0.25));
        arb_set_d(trajectory_sample(&t, k) + THETA_DOT, (k == 0 ? 2 : -2) * sin(0.25));
    }
    ck_assert(trajectory_supremum(sup, &t, NULL, THETA, 0, 1));
    ck_assert(arb_gt(sup, one));
    ck_assert(is_below(sup, 1.1));
}

/* ---- B2, B3: the linear model ---- */

/* The rates of psi, psi', eta, eta' by (40), as rows over them */
static void matrix_of_40(arb_mat_t a, const struct trajectory *t)
{
    arb_mat_zero(a);
    arb_one(arb_mat_entry(a, 0, 1));
    arb_set_si(arb_mat_entry(a, 1, 0), -3);
    arb_set_si(arb_mat_entry(a, 1, 3), -2);
    arb_one(arb_mat_entry(a, 2, 3));
    arb_set_ui(arb_mat_entry(a, 3, 2), 9);
    arb_sub(arb_mat_entry(a, 3, 2), arb_mat_entry(a, 3, 2), t->c1, PREC);
    arb_set_ui(arb_mat_entry(a, 3, 1), 2);
    arb_neg(arb_mat_entry(a, 3, 3), t->c2);
}

/*
 * Of the states with 3 psi^2 + psi'^2 + (c1 - 9) eta^2 + eta'^2 = 2 E, the one of which derivative d of psi or eta is largest:
 * the row g of A^d, over those weights. Up to the first derivative the bound is exact; then it adds what cannot be
 * at once, the largest of each coordinate with the sizes of the entries of A.
 */
EACH(B2_B3_no_state_of_that_energy_exceeds_a_derivative, 2 * DERIVATIVES)
{
    static const int place[] = {PSI, PSI_DOT, ETA, ETA_DOT};
    const int d = _i / 2, which = _i % 2; /* psi or eta */
    OWNED(trajectory) t;
    VECTOR(arb, b, BOUNDS);
    MATRIX(arb, a, 4, 4);
    MATRIX(arb, power, 4, 4);
    VECTOR(arb, weight, 4);
    SCOPE(arb, truth, sum, most);
    trajectory_of(&t, false, 1, 100, 12, 3);
    matrix_of_40(a, &t);
    arb_mat_pow_ui(power, a, (ulong)d, PREC);
    for (int i = 0; i < 4; i++) {
        arb_ptr state = trajectory_sample(&t, 0) + place[i], g = arb_mat_entry(power, 2 * which, i);
        arb_set_ui(weight + i, i == 0 ? 3 : 1);
        if (i == 2)
            arb_sub_ui(weight + i, t.c1, 9, PREC);
        arb_div(state, g, weight + i, PREC);
        arb_addmul(truth, state, g, PREC);
    }
    for (int i = 0; i < 16; i++)
        arb_abs(arb_mat_entry(a, i / 4, i % 4), arb_mat_entry(a, i / 4, i % 4));
    arb_mat_pow_ui(power, a, (ulong)d, PREC);
    for (int i = 0; i < 4; i++) {
        arb_div(most, truth, weight + i, PREC); /* 2 E is the truth, too */
        arb_sqrt(most, most, PREC);
        arb_addmul(sum, most, arb_mat_entry(power, 2 * which, i), PREC);
    }
    ck_assert(trajectory_bounds(b, &t, 0));
    assert_at_least(b + BOUND_OF(which == 0 ? PSI : ETA, d), truth, 4, "derivative", d);
    assert_at_least(b + BOUND_OF(which == 0 ? PSI : ETA, d), sum, 1 + 0x1p-60, "derivative", d);
}

/* theta = a cos(2 tau) + b/2 sin(2 tau), wherever it starts on its way */
EACH(B2_pitch_has_its_amplitude, 6)
{
    OWNED(trajectory) t;
    VECTOR(arb, b, BOUNDS);
    SCOPE(arb, truth);
    trajectory_of(&t, false, 1, 100, 10, 2);
    arb_set_d(trajectory_sample(&t, 0) + THETA, 0.25 * cos(0.3 * _i));
    arb_set_d(trajectory_sample(&t, 0) + THETA_DOT, 0.5 * sin(0.3 * _i));
    ck_assert(trajectory_bounds(b, &t, 0));
    for (int d = 0; d < DERIVATIVES; d++) {
        arb_set_d(truth, ldexp(0.25, d) * (1 - 0x1p-50));
        assert_at_least(b + BOUND_OF(THETA, d), truth, 4.5, "pitch", d);
        arb_set_d(truth, ldexp(hypot(0.5 * cos(0.3 * _i), sin(0.3 * _i)), d)); /* twice theta and theta_dot */
        assert_at_least(b + BOUND_OF(THETA, d), truth, 1 + 0x1p-40, "pitch", d);
    }
}

/* Whatever eta and psi are within their bounds, 1 + eta, (1 + eta) psi and (1 + eta) theta are within theirs: as polynomials. */
TEST(B3_places_have_all_products_of_derivatives)
{
    OWNED(trajectory) t;
    VECTOR(arb, b, BOUNDS);
    SCOPE(arb_poly, length, angle);
    SCOPE(arb, c, factorial);
    trajectory_of(&t, false, 1, 100, 12, 3);
    for (int i = PSI; i <= ETA_DOT; i++)
        arb_set_d(trajectory_sample(&t, 0) + i, 1 + 0.25 * i);
    ck_assert(trajectory_bounds(b, &t, 0));
    for (int i = PSI; i <= THETA; i++) {
        arb_poly_zero(length);
        arb_poly_zero(angle);
        arb_one(factorial);
        for (int d = 0; d < DERIVATIVES; d++) {
            arb_mul_ui(factorial, factorial, d > 1 ? (ulong)d : 1, PREC);
            arb_div(c, b + BOUND_OF(ETA, d), factorial, PREC);
            arb_add_ui(c, c, d == 0, PREC);
            arb_poly_set_coeff_arb(length, d, c);
            arb_mul(c, c, factorial, PREC);
            assert_at_least(b + BOUND_OF(PLACE_X, d), c, 1 + 0x1p-60, "x", d);
            arb_div(c, b + BOUND_OF(i, d), factorial, PREC);
            arb_poly_set_coeff_arb(angle, d, c);
        }
        arb_poly_mullow(angle, angle, length, DERIVATIVES, PREC);
        arb_one(factorial);
        for (int d = 0; d < DERIVATIVES; d++) {
            arb_mul_ui(factorial, factorial, d > 1 ? (ulong)d : 1, PREC);
            arb_poly_get_coeff_arb(c, angle, d);
            arb_mul(c, c, factorial, PREC);
            assert_at_least(b + BOUND_OF(i == PSI ? PLACE_Y : PLACE_Z, d), c, 1 + 0x1p-60, "place", d);
        }
    }
}

/* ---- samples ---- */

TEST(values_of_the_sheet_are_in_their_balls)
{
    SCOPE(arb, x);
    SCOPE(fmpq, Omega);
    ck_assert_int_eq(fmpq_set_str(Omega, "72915/1000000000", 10), 0);
    for (slong bits = 10; bits < 40; bits += 7) {
        sheet_value(x, sheet(), "Omega", bits);
        ck_assert(arb_contains_fmpq(x, Omega) && arb_rel_accuracy_bits(x) > bits - 4);
    }
}

/* What is to be said of a sample, written anew: L_ref = 10 m, an arm of 5 m, c1 = 10 and c2 = 2 */
static void truth_of_sample(arb_ptr x, arb_srcptr e, bool nonlinear)
{
    VECTOR(arb, sine, 2);
    VECTOR(arb, cosine, 2);
    VECTOR(arb, lin, 3);
    VECTOR(arb, turned, 3);
    SCOPE(arb, l);
    _arb_vec_set(x, e, FLOW_STATE);
    arb_add_ui(l, e + ETA, 1, PREC);
    for (int i = 0; i < 2; i++)
        arb_sin_cos(sine + i, cosine + i, e + i, PREC);
    arb_mul(turned, cosine + PSI, cosine + THETA, PREC);
    arb_mul(turned + 1, sine + PSI, cosine + THETA, PREC);
    arb_neg(turned + 2, sine + THETA);
    arb_one(lin);
    arb_set(lin + 1, e + PSI);
    arb_neg(lin + 2, e + THETA);
    for (int i = 0; i < 3; i++) {
        arb_mul(x + PLACE_X + i, l, (nonlinear ? turned : lin) + i, PREC);
    }
    arb_mul_ui(x + PRODUCT, e + ETA, 10, PREC);
    arb_addmul_ui(x + PRODUCT, e + ETA_DOT, 2, PREC);
    arb_div_ui(x + PRODUCT, x + PRODUCT, 3, PREC);
    arb_mul_2exp_si(l, e + THETA_DOT, -1);
    arb_hypot(x + AMPLITUDE, e + THETA, l, PREC);
    arb_neg(l, l);
    arb_atan2(x + PHASE, l, e + THETA, PREC);
}

/* At the start a sample is what it started from; where one of its numbers is a ball, both of the ball's ends are in what is said. */
EACH(samples_hold_both_ends_of_what_they_start_from, 2 * FLOW_STATE)
{
    static const double start[FLOW_STATE] = {0.25, -0.125, 0.0625, 0.5, 0.375, -0.25};
    static const double unit[VARIABLES] = {1, 1, 10, 7.2915e-5, 7.2915e-5, 7.2915e-4, 5, 5, 5, 1, 1, 1};
    const bool nonlinear = _i % 2 == 1;
    const int wide = _i / 2;
    OWNED(trajectory) t;
    VECTOR(arb, e, FLOW_STATE);
    VECTOR(arb, truth, VARIABLES);
    SCOPE(arb, x);
    const struct simulation simulation = {.steps = steps(), .nonlinear = nonlinear, .start = e};
    for (int i = 0; i < FLOW_STATE; i++)
        arb_set_d(e + i, start[i]);
    mag_set_d(arb_radref(e + wide), 0x1p-20);
    ck_assert(trajectory_run(&t, &simulation, 0, 1, 0));
    mag_zero(arb_radref(e + wide));
    for (int side = -1; side <= 1; side++) {
        arb_set_d(e + wide, start[wide] + side * 0x1p-20);
        truth_of_sample(truth, e, nonlinear);
        for (int i = 0; i < VARIABLES; i++) {
            trajectory_value(x, &t, 0, i);
            ck_assert_msg(arb_contains(x, truth + i) && arb_rel_accuracy_bits(x) > 4, "variable %d, side %d", i, side);
            ck_assert_double_eq_tol(arf_get_d(arb_midref(t.unit + i), ARF_RND_NEAR), unit[i], 1e-15);
        }
    }
}

/* ---- roundings: what few bits say holds what many say ---- */

enum { ENERGY = VARIABLES, EXCESS, SUPREMUM = EXCESS + VARIABLES, GAP = SUPREMUM + VARIABLES, PEAK = GAP + VARIABLES,
       BOUND = PEAK + VARIABLES, SERIES = BOUND + COORDINATES, NUMBERS = SERIES + 3 * DERIVATIVES };

enum { PLAIN = -1, NUMBERS_IN = 3 + 2 * COORDINATES }; /* gains, Omega, samples */

/*
 * All that is said of two trajectories of two samples each, whose numbers are doubles; where not all are plain, the one of that
 * number of the first trajectory is a ball, or one of its ends.
 */
static void numbers_of(arb_ptr z, bool nonlinear, int seed, slong prec, int wide, int side)
{
    OWNED(trajectory) t, other;
    VECTOR(arb, b, BOUNDS);
    trajectory_of(&t, nonlinear, 2, 700, 11.3, 2.7);
    trajectory_of(&other, nonlinear, 2, 700, 11.3, 2.7);
    t.prec = other.prec = prec;
    arb_set_d(t.Omega, 7.2915e-5);
    for (int i = 0; i < 2 * COORDINATES; i++) {
        arb_set_d(t.samples + i, 0.03 * sin(1 + 7 * i + 31 * seed));
        arb_set_d(other.samples + i, 0.03 * sin(2 + 5 * i + 17 * seed));
    }
    if (wide != PLAIN) {
        arb_ptr all[] = {t.c1, t.c2, t.Omega}, x = wide < 3 ? all[wide] : t.samples + wide - 3;
        SCOPE(arb, radius);
        arb_abs(radius, x);
        arb_mul_2exp_si(radius, radius, -20);
        if (side == 0)
            arb_add_error(x, radius);
        arb_addmul_si(x, radius, side, 300);
    }
    trajectory_energy(z + ENERGY, &t, 1);
    ck_assert(nonlinear || trajectory_bounds(b, &t, 0));
    for (int i = 0; i < VARIABLES; i++) {
        trajectory_value(z + i, &t, 1, i);
        trajectory_peak(z + GAP + i, &t, &other, i, 0, 1);
        trajectory_peak(z + PEAK + i, &t, NULL, i, 0, 1);
        if (i <= PRODUCT && !nonlinear) {
            bound_between_samples(z + EXCESS + i, &t, b, i);
            ck_assert(trajectory_supremum(z + SUPREMUM + i, &t, NULL, i, 0, 1));
        }
        if (i < COORDINATES && !nonlinear)
            arb_set(z + BOUND + i, b + BOUND_OF(i, 2));
    }
    arb_one(other.samples); /* a place off both axes, and its derivatives */
    angle_series(z + SERIES, other.samples, DERIVATIVES, prec);
}

TEST(roundings_of_few_bits_are_in_their_balls)
{
    for (int k = 0; k < 24; k++) {
        VECTOR(arb, few, NUMBERS);
        VECTOR(arb, many, NUMBERS);
        numbers_of(few, k % 2, k, 14 + k, PLAIN, 0);
        numbers_of(many, k % 2, k, 300, PLAIN, 0);
        for (int i = 0; i < NUMBERS; i++)
            ck_assert_msg(arb_contains(few + i, many + i), "number %d", i);
    }
}

EACH(both_ends_of_each_number_are_in_what_is_said, 2 * NUMBERS_IN)
{
    VECTOR(arb, held, NUMBERS);
    VECTOR(arb, end, NUMBERS);
    numbers_of(held, _i % 2, 1, PREC, _i / 2, 0);
    for (int side = -1; side <= 1; side += 2) {
        numbers_of(end, _i % 2, 1, 300, _i / 2, side);
        for (int i = 0; i < NUMBERS; i++)
            ck_assert_msg(arb_contains(held + i, end + i), "number %d of %d, side %d", i, _i / 2, side);
    }
}

/* ---- B4 to B6: the nonlinear model ---- */

/*
 * At L_ref, all of the energy in one coordinate: it, or the rate that goes with it, is as large as it can be, and the further derivatives
 * are by (3) with P = -3 - c2 r': y'' = -2 u + P y, x'' = 2 v + (3 + P) x, z'' = (P - 1) z, psi'' and theta'' theirs times a cosine.
 */
enum { RATE, SINE, SINE_COSINE };

static const struct {
    int given, place, d, of;
    double times, at_most;
} largest[] = {
    {PSI, PLACE_Y, 0, SINE, 1, 1 + 0x1p-20},   {THETA, PLACE_Z, 0, SINE, 1, 1 + 0x1p-20}, {PSI_DOT, PLACE_Y, 1, RATE, 1, 1.5},
    {THETA_DOT, PLACE_Z, 1, RATE, 1, 1.5},     {ETA_DOT, PLACE_X, 1, RATE, 1, 1.5},       {PSI, PLACE_Y, 2, SINE, 3, 3},
    {PSI, PSI, 2, SINE_COSINE, 3, 3},          {THETA, PLACE_Z, 2, SINE, 4, 2},           {THETA, THETA, 2, SINE_COSINE, 4, 2},
    {PSI_DOT, PLACE_X, 2, RATE, 2, 4},         {PSI_DOT, PLACE_Y, 3, RATE, 7, 4},         {THETA_DOT, PLACE_Z, 3, RATE, 4, 2},
    {ETA_DOT, PLACE_X, 2, RATE, 2, 4},         {ETA_DOT, ETA, 2, RATE, 2, 10},             {ETA_DOT, PLACE_Y, 2, RATE, 2, 3},
    {ETA_DOT, PSI, 2, RATE, 2, 3},
};

TEST(B2_B6_no_state_at_L_ref_exceeds_its_place_or_derivatives)
{
    VECTOR(arb, b, BOUNDS);
    SCOPE(arb, truth, sine, cosine);
    for (int i = 0; i < COUNT(largest); i++) {
        OWNED(trajectory) t;
        trajectory_of(&t, true, 1, 100, 12, 2);
        arb_ptr given = trajectory_sample(&t, 0) + largest[i].given;
        arb_set_d(given, largest[i].of == RATE ? 0.04 : -0.03);
        arb_abs(truth, given);
        arb_sin_cos(sine, cosine, truth, PREC);
        if (largest[i].of != RATE)
            arb_set(truth, sine);
        if (largest[i].of == SINE_COSINE)
            arb_mul(truth, truth, cosine, PREC);
        arb_set_d(sine, largest[i].times);
        arb_mul(truth, truth, sine, PREC);
        ck_assert(trajectory_bounds(b, &t, 0));
        assert_at_least(b + BOUND_OF(largest[i].place, largest[i].d), truth, largest[i].at_most, "place", i);
    }
}

/* G(l), written anew */
static void potential(arb_t G, const struct trajectory *t, const arb_t eta)
{
    SCOPE(arb, l, a);
    arb_add_ui(l, eta, 1, PREC);
    arb_log(G, l, PREC);
    arb_mul(G, G, t->c1, PREC);
    arb_inv(a, l, PREC);
    arb_sub_ui(a, a, 1, PREC);
    arb_addmul(G, t->c1, a, PREC);
    arb_submul_ui(G, a, 3, PREC);
    arb_sqr(a, l, PREC);
    arb_sub_ui(a, a, 1, PREC);
    arb_mul_ui(a, a, 3, PREC);
    arb_mul_2exp_si(a, a, -1);
    arb_sub(G, G, a, PREC);
}

/*
 * All the energy in L', from much to little of it and so closely that some of it is only just too little for the length
 * at which it is confined: at the bounds of dL and x1 the potential on either side exceeds it.
 */
EACH(B4_B5_no_length_of_that_energy_lies_beyond_its_bound, 2)
{
    enum { CLOSE = 160 }; /* by 2^-10 of L' each: over more than an eighth of dL, to less than a gap between slices */
    OWNED(trajectory) t;
    VECTOR(arb, b, BOUNDS);
    VECTOR(arb, x, 3);
    arb_ptr G = x, energy = x + 1, eta = x + 2;
    trajectory_of(&t, true, 1, 100, 12, 2);
    for (int k = 0; k < CLOSE; k++) {
        arb_set_d(trajectory_sample(&t, 0) + ETA_DOT, 0.1 * pow(0.1, _i) * pow(1 + 0x1p-10, k));
        ck_assert(trajectory_bounds(b, &t, 0));
        trajectory_energy(energy, &t, 0);
        arb_sub_ui(eta, b + BOUND_OF(PLACE_X, 0), 1, PREC); /* the larger of l there; sharper than the bound of dL */
        arb_get_ubound_arf(arb_midref(eta), eta, PREC);
        mag_zero(arb_radref(eta));
        for (int side = 0; side < 2; side++) {
            potential(G, &t, eta);
            ck_assert_msg(arb_gt(G, energy), "x1 to %g", arf_get_d(arb_midref(eta), ARF_RND_NEAR));
            arb_neg(eta, eta);
        }
        ck_assert(arb_ge(b + BOUND_OF(ETA, 0), eta));
    }
}

/* At rest a tenth longer: the potential is less there than a tenth shorter, and its side decides. */
EACH(B4_both_sides_confine, 2)
{
    OWNED(trajectory) t;
    VECTOR(arb, b, BOUNDS);
    trajectory_of(&t, true, 1, 100, 12, 2);
    arb_set_d(trajectory_sample(&t, 0) + ETA, _i == 0 ? 0.1 : -0.1);
    ck_assert(trajectory_bounds(b, &t, 0));
    ck_assert(arb_is_finite(b + BOUND_OF(ETA, 0)) && !is_below(b + BOUND_OF(ETA, 0), 0.1));
    arb_zero(trajectory_sample(&t, 0) + ETA); /* at rest too */
    ck_assert(trajectory_bounds(b, &t, 0) && is_below(b + BOUND_OF(ETA, 0), 1e-9));
    t.other_law = true;
    ck_assert(!trajectory_bounds(b, &t, 0));
}

/* With c1 = 12 the hill is at 1.3 L_ref. At 1.4 the energy is less than there, but the motion is on the other side. */
TEST(B4_what_is_beyond_the_hill_has_no_bounds)
{
    OWNED(trajectory) t;
    VECTOR(arb, b, BOUNDS);
    SCOPE(arb, hours, limit);
    trajectory_of(&t, true, 2, 100, 12, 2);
    arb_set_d(trajectory_sample(&t, 0) + ETA, 0.4);
    arb_set_d(trajectory_sample(&t, 1) + ETA, 0.01);
    ck_assert(!trajectory_bounds(b, &t, 0));
    ck_assert(!trajectory_supremum(hours, &t, NULL, ETA, 0, 1));
    arb_set_d(limit, 0.3);
    ck_assert(!settles(hours, &t, ETA, limit));
    arb_zero(trajectory_sample(&t, 0) + ETA);
    arb_set_d(trajectory_sample(&t, 0) + ETA_DOT, 0.5); /* and with this it would get over the hill */
    ck_assert(!trajectory_bounds(b, &t, 0));
}

/* ---- B7: settling ---- */

/*
 * Pitch of amplitude 1 on samples of cos(1/4): never below 0.99 between them. What is below on every sample but reaches above
 * between is not settled; below 1.2, excess included, it is.
 */
TEST(B7_what_rises_between_samples_has_not_settled)
{
    enum { COUNT = 4 };
    OWNED(trajectory) t;
    SCOPE(arb, hours, limit);
    trajectory_of(&t, false, COUNT, 1 << 12, 10, 2);
    for (slong k = 0; k < COUNT; k++) {
        arb_set_d(trajectory_sample(&t, k) + THETA, k == 0 ? 3 : cos(0.25));
        arb_set_d(trajectory_sample(&t, k) + THETA_DOT, (k % 2 == 1 ? 2 : -2) * sin(0.25));
    }
    arb_set_d(limit, 0.99);
    ck_assert(!settles(hours, &t, THETA, limit));
    arb_set_d(limit, 1.2);
    ck_assert(settles(hours, &t, THETA, limit));
    arb_set_d(limit, 4096.0 / 3600); /* from the first sample, above, to the second, below: an hour and more */
    ck_assert(arb_contains_si(hours, 0) && arb_contains(hours, limit) && is_below(hours, 1.2));
}

/* Of two exits the last counts; what was never above has none. */
TEST(B7_the_last_exit_counts)
{
    enum { COUNT = 6 };
    static const double theta[COUNT] = {3, 0, 3, 0, 0, 0};
    OWNED(trajectory) t;
    SCOPE(arb, hours, limit);
    trajectory_of(&t, false, COUNT, 1 << 12, 10, 2);
    for (slong k = 0; k < COUNT; k++)
        arb_set_d(trajectory_sample(&t, k) + THETA, theta[k]);
    arb_set_d(limit, 1);
    ck_assert(settles(hours, &t, THETA, limit));
    ck_assert(is_above(hours, 2 * 1.13) && is_below(hours, 3 * 1.14)); /* samples are 1.138 h apart */
    arb_set_d(limit, 5);
    ck_assert(!settles(hours, &t, THETA, limit));
}

/*
 * Pitch of amplitude 1, never below 0.99 between its samples, for 256 of them, and none from there on: bounds of the later ones are not
 * those of the earlier. And where a late sample leaves open whether it is below, no earlier one settles anything.
 */
EACH(B7_bounds_are_those_of_the_samples_they_are_asked_for, 2)
{
    enum { SAMPLES = 600, BLOCK = 256, OPEN = 300 };
    OWNED(trajectory) t;
    SCOPE(arb, hours, limit, seconds);
    trajectory_of(&t, false, SAMPLES, 1 << 12, 10, 2);
    for (slong k = 0; k < BLOCK; k++) {
        arb_set_d(trajectory_sample(&t, k) + THETA, k == 0 ? 3 : cos(0.25));
        arb_set_d(trajectory_sample(&t, k) + THETA_DOT, (k % 2 == 1 ? 2 : -2) * sin(0.25));
    }
    if (_i == 1) {
        arb_set_d(trajectory_sample(&t, OPEN) + THETA, 0.98);
        mag_set_d(arb_radref(trajectory_sample(&t, OPEN) + THETA), 0.05);
    }
    arb_set_d(limit, 0.99);
    ck_assert(settles(hours, &t, THETA, limit));
    arb_set_si(seconds, (_i == 0 ? BLOCK : OPEN + 1) * t.step);
    arb_div_ui(seconds, seconds, 3600, PREC);
    ck_assert(arb_contains_si(hours, 0) && arb_contains(hours, seconds));
}

/* ---- rows of a motion ---- */

static int keep_whole_rows(void *context, slong k, const fmpq_t t, char *const *numbers)
{
    (void)t;
    for (int i = 0; i < FLOW_STATE; i++)
        if (numbers[i] == NULL)
            return 1;
    *(slong *)context = k + 1;
    return 0;
}

/* At pi/(4 Omega), to 120 bits, pitch is zero to as many: the first pass has 116, and no row goes out without it. */
TEST(a_row_waits_for_its_last_undecided_number)
{
    struct scenario s;
    struct message why;
    SCOPE(fmpq, t);
    SCOPE(arb, quarter, Omega);
    slong rows = 0;
    scenario_init(&s, sheet(), false);
    arb_set_fmpq(Omega, &s.value[SET_Omega].value, 200);
    arb_const_pi(quarter, 120);
    arb_mul_2exp_si(quarter, quarter, -2);
    arb_div(quarter, quarter, Omega, 120);
    arf_get_fmpq(t, arb_midref(quarter));
    const struct motion m = {.scenario = &s, .digits = 17};
    ck_assert_msg(motion_rows(&m, t, 1, keep_whole_rows, &rows, &why) == 0, "%s", why.text);
    ck_assert_int_eq(rows, 1);
    scenario_clear(&s);
}
