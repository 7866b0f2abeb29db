/*
 * verify/claims/second_order.h, two_body.h, convergence.h: the closed forms of what pitch leaves, the
 * pair in the inverse-square field, the observed orders.
 */
#include "tests/claims/balls.h"
#include "tests/run.h"
#include "tests/paper.h"
#include "claims/convergence.h"
#include "claims/second_order.h"
#include "motion/two_body.h"

enum { PREC = 192 };


/* x holds the number of that text within the tolerance */
static void assert_number(const arb_t x, const char *text, double tolerance)
{
    SCOPE(arb, y);
    arb_set_str(y, text, PREC);
    arb_sub(y, x, y, PREC);
    arb_abs(y, y);
    ck_assert_msg(is_below(y, tolerance), "%s is off by %g", text, arf_get_d(arb_midref(y), ARF_RND_UP));
}

/* ---- the closed forms ---- */

/* Gains that are not on (44): C1 = c1 Omega^2, C2 = c2 Omega. */
static struct second_order response(slong c1, slong c2)
{
    struct second_order o;
    SCOPE(arb, a, b);
    arb_set_si(a, c1);
    arb_set_si(b, c2);
    second_order_init(&o, steps(), a, b, PREC);
    return o;
}

CASE(convergence, NULL, flint_cleanup)

/* n = 10: k = 2592*2/27977, s = -9/2*701/27977, N = 131^2 + 104^2 = 27977; a halves when 2 k a^2 tau = 3. */
TEST(slow_law_halves_pitch)
{
    struct second_order o = response(10, 2);
    SCOPE(arb, a, tau, ratio, shift, expected);
    arb_set_str(a, "0.01", PREC);
    arb_set_si(tau, 3 * 27977);
    arb_div_si(tau, tau, 2 * 2 * 2592, PREC);
    arb_div(tau, tau, a, PREC);
    arb_div(tau, tau, a, PREC);
    slow_law(ratio, shift, &o, a, tau);
    assert_number(ratio, "0.5", 1e-50);
    arb_const_log2(expected, PREC); /* s/(2 k) log 4 = s/k log 2 */
    arb_mul_si(expected, expected, -9 * 701, PREC);
    arb_div_si(expected, expected, 4 * 2592, PREC);
    arb_sub(expected, expected, shift, PREC);
    assert_number(expected, "0", 1e-50);
    second_order_clear(&o);
}

/* ---- the pair in the inverse-square field ---- */

/* Shares 1 and 2 of `of` of the mass, L_ref/R_c = smallness, c1 = 10, c2 = 2. */
static struct two_body pair(slong share, slong of, const char *smallness)
{
    struct two_body b;
    two_body_init(&b);
    arb_set_str(b.smallness, smallness, PREC);
    arb_set_si(b.c1, 10);
    arb_set_si(b.c2, 2);
    arb_set_si(b.mass, share);
    arb_set_si(b.mass + 1, of - share);
    for (int i = 0; i < CRAFT; i++)
        arb_div_si(b.mass + i, b.mass + i, of, PREC);
    return b;
}

/* At rest at psi = theta = 0.01 rad, L = 1.01 L_ref. */
static void place_at_start(struct two_body *b)
{
    SCOPE(arb, angle, sine, cosine, L);
    arb_set_str(angle, "0.01", PREC);
    arb_set_str(L, "1.01", PREC);
    arb_sin_cos(sine, cosine, angle, PREC);
    arb_mul(b->place, cosine, cosine, PREC);
    arb_mul(b->place + 1, cosine, sine, PREC);
    arb_neg(b->place + 2, sine);
    _arb_vec_scalar_mul(b->place, b->place, AXES, L, PREC);
    _arb_vec_scalar_mul(b->place + AXES, b->place, AXES, b->mass, PREC);
    _arb_vec_neg(b->place + AXES, b->place + AXES, AXES);
    _arb_vec_scalar_mul(b->place, b->place, AXES, b->mass + 1, PREC);
}

static void half_day(arb_t tau)
{
    sheet_value(tau, sheet(), "Omega", PREC);
    arb_mul_si(tau, tau, 43200, PREC);
}

/*
 * mpmath 1.2.1, 30 digits: odefun over 43200*7.2915e-5 radians in the inertial frame, X'' = -X/(s^3 |X|^3) and the
 * charges' pull along the line, s = 0.001, turned back into the Hill frame; craft 1 in L_ref.
 */
TEST(two_body_is_the_inertial_motion)
{
    static const struct {
        slong share, of;
        const char *place[AXES];
    } cases[] = {{1, 2, {"0.4975612729909976798", "0.0048346334768764351521", "-0.0050506882625895745811"}},
                 {1, 3, {"0.66356847530960516602", "0.0044247566322711494782", "-0.0067370740023247348371"}}};
    SCOPE(arb, tau);
    half_day(tau);
    for (int i = 0; i < 2; i++) {
        struct two_body b = pair(cases[i].share, cases[i].of, "0.001");
        place_at_start(&b);
        ck_assert(two_body_move(&b, tau, PREC));
        for (int k = 0; k < AXES; k++)
            assert_number(b.place + k, cases[i].place[k], 1e-17); /* their last digit is 1e-20 or larger */
        two_body_clear(&b);
    }
}

/* One step of 0.2 radians and two of half its length end in the same place: balls without what is left out would not meet. */
TEST(two_body_bounds_what_its_series_leave_out)
{
    enum { BITS = 1024 };
    struct two_body one = pair(1, 3, "0.001"), two = pair(1, 3, "0.001"), near = pair(1, 2, "0.001");
    SCOPE(arb, tau, half);
    SCOPE(mag, most);
    arb_set_d(tau, 0.2);
    arb_set_d(half, 0.1);
    place_at_start(&one);
    place_at_start(&two);
    place_at_start(&near);
    ck_assert(two_body_move(&one, tau, BITS) && two_body_move(&two, half, BITS) && two_body_move(&two, half, BITS));
    mag_set_d(most, 1e-35);
    for (int i = 0; i < CRAFT * AXES; i++) {
        ck_assert(arb_overlaps(one.place + i, two.place + i) && arb_overlaps(one.velocity + i, two.velocity + i));
        ck_assert_int_lt(mag_cmp(arb_radref(one.place + i), most), 0);
    }
    _arb_vec_scalar_mul_2exp_si(near.place, near.place, CRAFT * AXES, -7); /* 0.2 radians are long where q is large */
    ck_assert(!two_body_move(&near, tau, PREC));
    two_body_clear(&one);
    two_body_clear(&two);
    two_body_clear(&near);
}

/* Craft on their way to each other: they meet soon after the second step, which is too long by then. */
TEST(B2_each_step_of_two_bodies_has_to_be_proved)
{
    struct two_body b = pair(1, 2, "0.001");
    SCOPE(arb, tau, rate);
    arb_set_d(rate, -2.4);
    for (int steps = 1; steps <= 2; steps++) {
        arb_set_d(tau, 0.2 * steps);
        place_at_start(&b);
        _arb_vec_scalar_mul(b.velocity, b.place, CRAFT * AXES, rate, PREC);
        ck_assert(two_body_move(&b, tau, PREC) == (steps == 1));
    }
    two_body_clear(&b);
}

/* Where R_c is very large the field is Hill's: what is left is (3), which the certified flow moves. */
TEST(eq02_is_the_limit_of_the_inverse_square)
{
    struct two_body b = pair(1, 2, "1e-25");
    struct trajectory t;
    SCOPE(arb, tau, gap);
    place_at_start(&b);
    half_day(tau);
    ck_assert(two_body_move(&b, tau, 256));
    ck_assert(trajectory_run(&t, &(struct simulation){.steps = steps(), .nonlinear = true}, 43200, 1, 43200));
    for (int k = 0; k < AXES; k++) {
        arb_mul_2exp_si(gap, b.place + k, 1); /* the arm is half L_ref */
        arb_sub(gap, gap, trajectory_sample(&t, 0) + PLACE_X + k, PREC);
        assert_number(gap, "0", 1e-24); /* what the smallness leaves is of the order of 1e-25 */
    }
    trajectory_clear(&t);
    two_body_clear(&b);
}

/* ---- observed orders ---- */

/* 3 x^2 and x^5/7, each within 1/1000, at 1/24 twice that; or 1, where seconds are 0. */
static bool powers(arb_ptr d, const struct derivations *steps, const struct study *s, const fmpq_t x)
{
    SCOPE(fmpq, y, c);
    (void)steps;
    for (int i = 0; i < s->count; i++) {
        fmpq_pow_si(y, x, s->order[i]);
        fmpq_set_si(c, (i == 0 ? 3 : 1) * (fmpz_equal_si(fmpq_denref(x), 24) ? 2 : 1), i == 0 ? 1 : 7);
        fmpq_mul(y, y, c);
        arb_set_fmpq(d + i, y, PREC);
        mag_set_d(arb_radref(d + i), 0.001 * arf_get_d(arb_midref(d + i), ARF_RND_UP));
        if (s->seconds == 0)
            arb_one(d + i);
    }
    return s->every == 0;
}

/* Parameters are 1/3, 1/6, 1/12 and 1/24: what is said where the differences are powers, or 1. */
static const struct {
    const char *name, *of_powers, *of_ones;
} of_study[] = {
    {"p_psi", "1", "0"}, {"p_dL", "4", "0"}, {"c_psi", "6", "576"}, {"c_dL", "2/7", "7962624"}, {"worst", "1", "5"},
    {"d_psi_0", "1/3", "1"}, {"d_dL_0", "1/1701", "1"},
};

/* After the time in its name; the largest differences are those at each of the longest steps, and the paper's are 2592 of 3 days. */
TEST(studies_are_what_their_names_say)
{
    int timed = 0;
    for (const struct study *s = studies; s->name != NULL; s++) {
        long seconds;
        char unit = 0;
        if (sscanf(strrchr(s->name, '_'), "_%ld%c", &seconds, &unit) == 2) {
            ck_assert_msg(unit == 's' && s->seconds == seconds, "%s", s->name);
            timed++;
        }
        ck_assert_msg(s->every == 0 || s->every == s->first, "%s", s->name);
    }
    ck_assert_int_ge(timed, 10);
    for (const struct computation *c = computations_simulation; c->name != NULL; c++) {
        const struct sampled *s = c->of;
        if (strstr(c->name, "_steps") != NULL)
            ck_assert(s->beside->rk4 == s->step && s->step * 2592 == s->last && s->last == 3 * DAY);
    }
}

/* Of claims all rows are there, else the last two; nothing where one is not found. */
EACH(a_study_says_what_its_differences_are, 8)
{
    const bool whole = _i & 1, ones = _i & 2, found = !(_i & 4);
    const struct study s = {"here", {PSI, ETA}, 2, {2, 5}, 1, 3, 2, 4, powers, .seconds = !ones, .every = !found, .of_claims = whole};
    struct computed *c = computed_new((struct computation){"here", run_study, &s}, steps());
    SCOPE(arb, x);
    SCOPE(fmpq, truth);
    for (int k = 0; k < COUNT(of_study); k++)
        computed_ask(c, of_study[k].name);
    for (int k = 0; k < COUNT(of_study); k++) {
        const char *name = of_study[k].name;
        computed_number(c, name, x);
        ck_assert_msg(arb_is_finite(x) == (found && (whole || name[0] != 'd')), "%s", name);
        ck_assert_int_eq(fmpq_set_str(truth, ones ? of_study[k].of_ones : of_study[k].of_powers, 10), 0);
        ck_assert_msg(arb_contains_fmpq(x, truth), "%s", name);
        ck_assert_msg(ones || arb_rel_accuracy_bits(x) < 12, "%s", name); /* no sharper than the differences */
    }
    computed_free(c);
}

/* After two hours from pitch alone and from all of the start; after 1/a^2 radians by the slow law. */
TEST(differences_of_motions_are_balls)
{
    static const struct study alone = {.which = {PSI, THETA, ETA}, .count = 3, .seconds = 7200, .pitch_alone = true};
    VECTOR(arb, d, 2 * STUDIED);
    SCOPE(fmpq, one, fifth);
    struct study all = alone;
    all.pitch_alone = false;
    fmpq_one(one);
    fmpq_set_si(fifth, 1, 5);
    ck_assert(study_find("linear_day")->differences(d, steps(), &alone, one));
    ck_assert(study_find("linear_day")->differences(d + 3, steps(), &all, one));
    for (int i = 0; i < 6; i++)
        ck_assert(arb_is_positive(d + i) && !arb_is_exact(d + i) && !arb_overlaps(d + i, d + (i + 3) % 6));
    ck_assert(study_find("slow_law")->differences(d, steps(), study_find("slow_law"), fifth));
    for (int i = 0; i < 2; i++) /* amplitude and phase: a^2 */
        ck_assert(arb_is_positive(d + i) && is_below(d + i, 0.04) && !arb_is_exact(d + i));
}

/* A length of 0 at the start, a step that does not divide the time, a time out of reach: no differences, and no numbers. */
static const struct {
    const char *like;
    long first, seconds;
    bool fails;
} failing[] = {{"linear_day", -100, 86400, true}, {"rk4_linear_day", 401, 86400, true}, {"forced_10_259200s", 1, 1000000000000000, true},
               {"hill_43200s", 1, 43200, true}, {"linear_day", 1, 86400, false}};

EACH(studies_of_what_is_not_proved_give_nothing, COUNT(failing))
{
    static const char *const names[] = {"worst", "p_psi", "c_psi", "d_psi_0"};
    struct study s = *study_find(failing[_i].like);
    SCOPE(arb, x);
    s.first = failing[_i].first;
    s.over = failing[_i].fails ? 1 : 1000;
    s.rows = 2;
    s.seconds = failing[_i].seconds;
    struct computed *c = computed_new((struct computation){"here", run_study, &s}, steps());
    for (int i = 0; i < COUNT(names); i++)
        computed_ask(c, names[i]);
    for (int i = 0; i < COUNT(names); i++) {
        computed_number(c, names[i], x);
        ck_assert_msg(arb_is_finite(x) != failing[_i].fails, "%s", names[i]);
    }
    computed_free(c);
}

/* Hill's motion less mpmath's of two_body_is_the_inertial_motion: x1 and dL in m. */
TEST(hill_differs_by_what_the_inertial_motion_says)
{
    static const struct {
        int which, variable;
        const char *inertial;
    } cases[] = {{PLACE_X, 0, "4.975612729909976798"}, {ETA, 5, "-0.018640285790863615346"}};
    const struct study *s = study_find("hill_43200s");
    struct trajectory t;
    VECTOR(arb, d, STUDIED);
    SCOPE(arb, x, y);
    SCOPE(fmpq, smallness);
    fmpq_set_si(smallness, 1, 1000);
    ck_assert(s->differences(d, steps(), s, smallness));
    ck_assert(trajectory_run(&t, &(struct simulation){.steps = steps(), .nonlinear = true}, 43200, 1, 43200));
    for (int i = 0; i < 2; i++) {
        arb_mul(x, trajectory_sample(&t, 0) + cases[i].which, t.unit + cases[i].which, PREC);
        arb_set_str(y, cases[i].inertial, PREC);
        arb_sub(x, x, y, PREC);
        arb_abs(x, x);
        arb_sub(x, x, d + cases[i].variable, PREC);
        assert_number(x, "0", 1e-16);
    }
    trajectory_clear(&t);
}

/* ---- what is measured of trajectories ---- */

/*
 * A number is given where it is proved, and nowhere else: for ever only what the energy of the last sample allows, no bound
 * beyond the separatrix, nothing of a pair that turns over. The linear dL passes zero at 5.31 h, 19116 s, and comes back.
 */
static const struct simulation near_rest = {.n = "10"}, beyond_the_hill = {.nonlinear = true, .dL = "3"},
                               captured = {.nonlinear = true, .digits = 8, .psi = "0", .theta = "0", .dL = "-2.4"}, /* bounded at the end alone */
                               turned_over = {.nonlinear = true, .psi = "3.14"}; /* with as little energy, so that numbers are finite */

static const struct {
    const char *name;
    struct sampled sampled;
    bool given;
} measured[] = {
    {"between_psi", {{.n = "10"}, 0, 100, 200, &near_rest}, true},
    {"between_psi", {{.n = "10"}, 0, 100, 200, &beyond_the_hill}, false},
    {"between_psi", {{.nonlinear = true, .dL = "3"}, 0, 100, 200, &near_rest}, false},
    {"part_psi", {{.n = "10"}, 0, 100, 200, &near_rest}, true},
    {"part_psi", {{.n = "10"}, 0, 100, 200, &beyond_the_hill}, false},
    {"ever_dL_0", {{.nonlinear = true, .dL = "3"}, 0, 100, 200, NULL}, false},
    {"sup_dL", {{.nonlinear = true, .psi = "3.14"}, 0, 100, 200, NULL}, false},
    {"ever_dL_0", {{.nonlinear = true, .psi = "3.14"}, 0, 100, 200, NULL}, false},
    {"bound_dL", {{.nonlinear = true, .psi = "3.14"}, 0, 100, 200, NULL}, false},
    {"between_dL", {{.nonlinear = true, .psi = "3.14"}, 0, 100, 200, &near_rest}, false},
    {"between_dL", {{.n = "10"}, 0, 100, 200, &turned_over}, false},
    {"part_dL", {{.n = "10"}, 0, 100, 200, &turned_over}, false},
    {"at_psi_0", {{.nonlinear = true, .dL = "-10"}, 0, 100, 200, NULL}, false}, /* no motion */
    {"gap_psi", {{.n = "10"}, 0, 100, 200, &(const struct simulation){.nonlinear = true, .dL = "-10"}}, false},
    {"gap_psi", {{.nonlinear = true, .dL = "-10"}, 0, 100, 200, &near_rest}, false},
    {"ever_dL_0", {{.nonlinear = true, .digits = 8, .psi = "0", .theta = "0", .dL = "-2.4"}, 0, 3 * DAY, 3 * DAY, NULL}, false},
    {"part_dL", {{.n = "10"}, 0, 3 * DAY, 3 * DAY, &captured}, false},
    {"part_dL_72", {{.n = "10"}, 0, 3 * DAY, 3 * DAY, &captured}, true},
    {"bound_psi", {{.n = "10"}, 0, 1, 0, NULL}, true},
    {"low_dL", {{.n = "10"}, 0, 100, 200, NULL}, true},
    {"at_psi_0", {{.n = "10"}, 3600, 3600, 7200, NULL}, false}, /* before the first sample */
    {"peak_psi", {{.n = "10"}, 0, 1, 0, NULL}, true},
    {"sup_psi", {{.n = "10"}, 0, 1, 0, NULL}, true},
    {"ever_psi_0", {{.n = "10"}, 0, 1, 0, NULL}, false},
    {"exit_dL_100", {{.n = "10"}, 0, 60, 19140, NULL}, true},
    {"settled_dL_100", {{.n = "10"}, 0, 60, 19140, NULL}, false},
    {"exit_dL_1000", {{.n = "10"}, 0, 60, 18000, NULL}, false},
    {"peak_dL", {{.nonlinear = true, .dL = "3"}, 0, 1, 0, NULL}, true},
    {"sup_dL", {{.nonlinear = true, .dL = "3"}, 0, 1, 0, NULL}, false},
    {"bound_dL", {{.nonlinear = true, .dL = "3"}, 0, 1, 0, NULL}, false},
    {"peak_psi", {{.nonlinear = true, .psi = "1.6"}, 0, 100, 1000, NULL}, true},
};

/* One number of a simulation. */
static void number_of(arb_t x, const struct sampled *sampled, const char *name)
{
    struct computed *c = computed_new((struct computation){"here", run_simulation, sampled}, steps());
    SCOPE(arb, other);
    computed_ask(c, name);
    computed_number(c, name, x);
    computed_number(c, "at_theta", other);
    ck_assert(!arb_is_finite(other)); /* not asked for before it ran */
    computed_free(c);
}

EACH(what_is_not_proved_is_not_given, COUNT(measured))
{
    SCOPE(arb, x);
    number_of(x, &measured[_i].sampled, measured[_i].name);
    ck_assert_int_eq(arb_is_finite(x), measured[_i].given);
    ck_assert(!arb_is_exact(x));
}

/* What is the largest or the least of several samples is that of each of them. */
EACH(extremes_are_those_of_all_samples, 5)
{
    enum { HOURS = 3 };
    static const char *const names[] = {"part_psi", "peak_psi", "high_psi", "low_psi", "part_dL"};
    const struct simulation other = {.steps = steps(), .nonlinear = true, .theta = "0"};
    const struct sampled sampled = {{.nonlinear = true}, 0, 2 * HOUR, 2 * HOURS * HOUR, &other};
    SCOPE(arb, all, one, most);
    for (int k = 0; k <= HOURS; k++) {
        char name[32];
        snprintf(name, sizeof name, "%s_%d_%d", _i % 4 == 0 ? names[_i] : "at_psi", 2 * k, 2 * k);
        number_of(one, &sampled, name);
        if (_i == 1)
            arb_abs(one, one);
        (_i != 3 ? arb_max : arb_min)(most, k == 0 ? one : most, one, PREC);
    }
    number_of(all, &sampled, names[_i]);
    ck_assert_msg(arb_overlaps(all, most) && arb_rel_accuracy_bits(all) > 20, "%s", names[_i]);
}

/* Between samples two motions are apart by no more than on them and what each exceeds its own by. */
TEST(what_lies_between_two_motions_has_the_excess_of_both)
{
    const struct simulation one = {.steps = steps()}, other = {.steps = steps(), .nonlinear = true, .theta = "0"};
    const struct sampled sampled = {one, 0, 4000, 40000, &other};
    struct trajectory t[2];
    VECTOR(arb, b, BOUNDS);
    SCOPE(arb, x, y, part);
    number_of(x, &sampled, "between_x1");
    ck_assert(trajectory_run(&t[0], &one, 0, 4000, 40000) && trajectory_run(&t[1], &other, 0, 4000, 40000));
    trajectory_peak(y, &t[0], &t[1], PLACE_X, 0, 10);
    for (int i = 0; i < 2; i++) {
        ck_assert(trajectory_bounds(b, &t[i], 0));
        bound_between_samples(part, &t[i], b, PLACE_X);
        ck_assert(is_above(part, 1e-3)); /* of the same size as the gap */
        arb_add(y, y, part, PREC);
    }
    arb_mul_ui(y, y, 5, PREC); /* arms of 5 m */
    ck_assert(arb_overlaps(x, y) && arb_rel_accuracy_bits(x) > 40);
    trajectory_clear(&t[0]);
    trajectory_clear(&t[1]);
}

static void give_two(struct computed *c)
{
    SCOPE(arb, x);
    arb_one(x);
    mag_one(arb_radref(x));
    give(c, true, x, "a_%d", 1);
    give(c, false, x, "a_%d", 2);
}

/* One of each list, found again as the same; a ball is handed over as it is, and once asked for is there. */
TEST(computations_are_found_by_name)
{
    static const char *const names[] = {"linear_steps", "escaping_12", "of_gains", "damped", "linear_43200s", "slow_law"};
    struct computations all = {.steps = steps()};
    SCOPE(arb, x);
    for (int i = 0; i < COUNT(names); i++) {
        struct computed *found = computed_find(&all, names[i]);
        ck_assert_ptr_nonnull(found);
        ck_assert_str_eq(found->of.name, names[i]);
        ck_assert_ptr_eq(found, computed_find(&all, names[i]));
    }
    ck_assert_ptr_null(computed_find(&all, "nothing"));
    computations_clear(&all);
    struct computed *c = computed_new((struct computation){"here", give_two, NULL}, steps());
    for (int i = 0; i < 4; i++)
        computed_ask(c, i % 2 ? "a_2" : "a_1");
    ck_assert_int_eq(c->count, 2);
    computed_number(c, "a_1", x);
    ck_assert(arb_contains_si(x, 0) && arb_contains_si(x, 2) && arb_is_finite(x));
    computed_number(c, "a_2", x);
    ck_assert(!arb_is_finite(x));
    computed_free(c);
}

/* In SI: the start of the paper, and what is left of its dL after so many samples. */
TEST(measures_are_in_SI)
{
    static const struct {
        const char *name, *value;
        double within;
    } numbers[] = {
        {"peak_dL", "0.1", 1e-15}, {"at_x1_0", "5.05", 1e-14}, {"at_psi_0", "0.01", 1e-15}, {"energy_of_psi", "0.0002", 1e-15}, /* (3 + (c1 - 9))/2 of 1e-4 */
        {"low_dL_0_0", "0.1", 1e-15},
    };
    const struct sampled start = {{.n = "10"}, 0, 3600, 2 * 3600, NULL};
    SCOPE(arb, x, y);
    for (int i = 0; i < COUNT(numbers); i++) {
        number_of(x, &start, numbers[i].name);
        assert_number(x, numbers[i].value, numbers[i].within);
    }
    number_of(x, &start, "low_dL_1_2");
    number_of(y, &start, "at_dL_2");
    arb_sub(x, x, y, PREC);
    assert_number(x, "0", 1e-15); /* it falls */
}

/* The linear dL passes 0 at 5.31, 28.5 and 51.1 h (mpmath, as in test_trajectory.c): told by samples of hours, the first at 1 h too. */
TEST(signs_change_between_samples)
{
    static const struct {
        const char *name;
        slong from_0, from_1;
    } changes[] = {{"changes_dL", 3, 3}, {"changes_dL_0_5", 0, -1}, {"changes_dL_1_28", 1, 1}, {"changes_dL_5_29", 2, 2}, {"changes_dL_6_51", 1, 1},
                   {"changes_dL_6_52", 2, 2}, {"changes_dL_52_72", 0, 0}};
    for (int i = 0; i < 2 * COUNT(changes); i++) {
        const int first = i % 2;
        const struct sampled all = {{.n = "10"}, first * HOUR, HOUR, 72 * HOUR, NULL};
        const slong due = first == 0 ? changes[i / 2].from_0 : changes[i / 2].from_1;
        SCOPE(arb, x);
        number_of(x, &all, changes[i / 2].name);
        ck_assert_msg(due < 0 ? !arb_is_finite(x) : arb_equal_si(x, due), "%s from %d h", changes[i / 2].name, first);
    }
}

/* What no motion has is not given, and nothing outside it read: no such measure, variable or hour, and nothing beside. */
TEST(names_of_nothing_have_no_number)
{
    static const char *const names[] = {"sub_psi", "sup_pis", "sup_amplitude", "exit_product_100", "energy_of_theta", "gap_psi", "part_psi",
                                        "sup_psi_3", "sup_psi_2_1", "peak_psi_0_3", "sup_psi_0_3", "at_psi_1234567890", "sup_psi_1_", "sup_psi_01", "exit_psi_0"};
    const struct sampled start = {{.n = "10"}, 0, 3600, 2 * 3600, NULL};
    SCOPE(arb, x);
    for (int i = 0; i < COUNT(names); i++) {
        number_of(x, &start, names[i]);
        ck_assert_msg(!arb_is_finite(x), "%s", names[i]);
    }
    number_of(x, &start, "sup_psi_1_2");
    ck_assert(arb_is_finite(x));
}
