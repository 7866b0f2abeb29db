/*
 * verify/motion/flow.h: the four motions, and a test for every error term of the theorem in flow_nonlinear.c. What that stands on
 * is in test_taylor.c and test_lohner.c.
 */
#include "tests/run.h"
#include "tests/paper.h"

#include "evaluate/reference.h"
#include "motion/expansion.h"
#include "motion/motion.h"
#include "text/scope.h"

CASE(all, NULL, flint_cleanup)

enum { DAY = 86400, PREC = 256, MOST_TIMES = 64 };

/* ---- pairs: parameters, and a state to start from ---- */

struct pair {
    struct flow_parameters p;
    arb_ptr start;
    slong prec;
};

static void pair_clear(struct pair *s)
{
    flow_parameters_clear(&s->p);
    _arb_vec_clear(s->start, FLOW_STATE);
}

/* Gains c1 Omega^2 and c2 Omega; at rest at the origin. */
static struct pair pair_of(double Omega, double m1, double m2, double L_ref, double c1, double c2)
{
    struct pair s = {.prec = PREC, .start = _arb_vec_init(FLOW_STATE)};
    const double given[] = {Omega, 8.99e9, m1, m2, L_ref, c1, c2};
    flow_parameters_init(&s.p);
    for (int i = 0; i < COUNT(given); i++)
        arb_set_d(s.p.Omega + i, given[i]);
    arb_mul(s.p.C2, s.p.C2, s.p.Omega, PREC);
    arb_mul(s.p.C1, s.p.C1, s.p.Omega, PREC);
    arb_mul(s.p.C1, s.p.C1, s.p.Omega, PREC);
    return s;
}

static struct pair paper(void)
{
    return pair_of(7.2915e-5, 150, 150, 10, 10, 2);
}

static void start_at(struct pair *s, double a, double b, double c, double a_dot, double b_dot, double c_dot)
{
    const double given[FLOW_STATE] = {a, b, c, a_dot, b_dot, c_dot};
    for (int i = 0; i < FLOW_STATE; i++)
        arb_set_d(s->start + i, given[i]);
}

/* At rest in the frame at these angles and this distance */
static void start_at_angles(struct pair *s, double psi, double theta, double dL)
{
    start_at(s, psi, theta, dL, 0, 0, 0);
    state_from_angles(s->start, sheet(), &s->p, s->prec);
}

static struct pair paper_nonlinear(void)
{
    struct pair s = paper();
    start_at_angles(&s, 0.01, 0.01, 0.1);
    return s;
}

/* ---- running a flow ---- */

enum way { LINEAR, NONLINEAR, RK4_LINEAR, RK4_NONLINEAR };

struct found {
    arb_ptr states;
    slong rows, stop_after; /* 0: never */
    enum flow_status status;
    double reached;
};

static void found_clear(struct found *r)
{
    _arb_vec_clear(r->states, MOST_TIMES * FLOW_STATE);
}

static int keep(void *context, slong k, const fmpq_t t, arb_srcptr state)
{
    struct found *r = context;
    (void)t;
    _arb_vec_set(r->states + k * FLOW_STATE, state, FLOW_STATE);
    r->rows++;
    return r->rows == r->stop_after;
}

/* h is for Runge and Kutta; digits 0: no set is too wide. */
static struct found follow(const struct pair *s, enum way way, const fmpq *times, slong count, slong digits, slong h, slong stop_after,
                           const struct flow_steps *how)
{
    struct found r = {.states = _arb_vec_init(MOST_TIMES * FLOW_STATE), .stop_after = stop_after};
    SCOPE(fmpq, step);
    fmpq_set_si(step, h, 1);
    struct flow_request request = {&s->p, s->start, times, count, digits, s->prec, keep, &r, way % 2 == 1,
                                   way >= RK4_LINEAR ? step : NULL, how, 0};
    r.status = flow_run(&request);
    r.reached = request.reached;
    return r;
}

/* At `count` times in seconds */
static struct found run_through(const struct pair *s, enum way way, const slong *seconds, slong count, slong digits, slong h,
                                slong stop_after)
{
    VECTOR(fmpq, times, count);
    for (slong k = 0; k < count; k++)
        fmpq_set_si(times + k, seconds[k], 1);
    return follow(s, way, times, count, digits, h, stop_after, NULL);
}

static struct found run_to(const struct pair *s, enum way way, slong seconds)
{
    return run_through(s, way, &seconds, 1, 17, 100, 0);
}

/* ---- comparing ---- */

static void assert_overlap(arb_srcptr a, arb_srcptr b)
{
    for (int i = 0; i < FLOW_STATE; i++)
        ck_assert_msg(arb_overlaps(a + i, b + i), "coordinate %d: %.17g and %.17g", i,
                      arf_get_d(arb_midref(a + i), ARF_RND_NEAR), arf_get_d(arb_midref(b + i), ARF_RND_NEAR));
}

static void assert_same(arb_srcptr a, arb_srcptr b)
{
    for (int i = 0; i < FLOW_STATE; i++)
        ck_assert_msg(arb_equal(a + i, b + i), "coordinate %d differs", i);
}

static void assert_holds(arb_srcptr set, arb_srcptr member)
{
    for (int i = 0; i < FLOW_STATE; i++)
        ck_assert_msg(arb_contains(set + i, member + i), "coordinate %d: %.17g +- %.3g lacks %.17g", i,
                      arf_get_d(arb_midref(set + i), ARF_RND_NEAR), mag_get_d(arb_radref(set + i)),
                      arf_get_d(arb_midref(member + i), ARF_RND_NEAR));
}

/* Overlap proves nothing where balls are wide: no radius above 2^-bits of the largest position or, per radian, rate. */
static void assert_sharp(arb_srcptr state, slong bits)
{
    enum { RADIAN = 14 }; /* log2 of 1/Omega, in all these scenarios */
    SCOPE(mag, size, m);
    for (int i = 0; i < FLOW_STATE; i++) {
        arb_get_mag(m, state + i);
        mag_mul_2exp_si(m, m, i < 3 ? -bits : RADIAN - bits);
        mag_max(size, size, m);
    }
    for (int i = 0; i < FLOW_STATE; i++) {
        mag_mul_2exp_si(m, arb_radref(state + i), i < 3 ? 0 : RADIAN);
        ck_assert_msg(mag_cmp(m, size) <= 0, "coordinate %d: radius %g", i, mag_get_d(arb_radref(state + i)));
    }
}

static double number(const arb_t x)
{
    return arf_get_d(arb_midref(x), ARF_RND_NEAR);
}

/* To a share of L_ref, and of Omega L_ref, what ref/ makes of it, which shares no line with the flows */
static void assert_near_ref(arb_srcptr state, enum way way, const struct pair *s, double t, double h, double share)
{
    static const char *const ids[] = {"flow_linear", "flow_nonlinear", "rk4_linear", "rk4_nonlinear"};
    double in[15], out[FLOW_STATE], *next = in;
    for (int i = 0; i < 7; i++) /* Omega k_c m1 m2 L_ref C1 C2 */
        if (way % 2 == 1 || i == 0 || i > 3)
            *next++ = number(s->p.Omega + i);
    *next++ = t;
    for (int i = 0; i < FLOW_STATE; i++)
        *next++ = number(s->start + i);
    *next = h;
    reference_find(ids[way])(in, out);
    for (int i = 0; i < FLOW_STATE; i++)
        ck_assert_double_eq_tol(number(state + i), out[i], share * number(s->p.L_ref) * (i < 3 ? 1 : number(s->p.Omega)));
}

/* ---- the linear flow ---- */

/*
 * lambda = -1 solves (41) where 4 c1 = 4 c2 + 28; with c1 = 10, c2 = 3 the mode psi = 1, dL = 2 L_ref decays
 * as exp(-tau). Pitch goes as cos 2 tau.
 */
TEST(eq40_flow_follows_an_exact_mode)
{
    OWNED(pair) s = pair_of(0x1p-14, 150, 150, 8, 10, 3);
    start_at(&s, 0.5, 0.25, 8, -0x1p-15, 0, -0x1p-11);
    OWNED(found) r = run_to(&s, LINEAR, 5 * DAY);
    SCOPE(arb, tau, factor);
    arb_mul_si(tau, s.p.Omega, -5 * DAY, PREC);
    arb_exp(factor, tau, PREC);
    _arb_vec_scalar_mul(s.start, s.start, FLOW_STATE, factor, PREC);
    arb_mul_2exp_si(tau, tau, 1);
    arb_sin_cos(s.start + 4, s.start + 1, tau, PREC);
    arb_mul_2exp_si(s.start + 1, s.start + 1, -2);
    arb_mul_2exp_si(s.start + 4, s.start + 4, -15); /* -2 Omega / 4 sin(2 tau), tau negative here */
    assert_overlap(r.states, s.start);
    assert_sharp(r.states, 180); /* exp(-26) takes 38 bits of 256, the exponential some more */
}

/* There and back; what decays forward grows backward. */
EACH(a_motion_returns, 2)
{
    const enum way m = _i == 0 ? LINEAR : NONLINEAR;
    OWNED(pair) s = paper_nonlinear();
    if (m == LINEAR)
        start_at(&s, 0.01, -0.02, 0.1, 1e-6, 2e-6, -3e-6);
    OWNED(found) there = run_to(&s, m, DAY);
    VECTOR(arb, start, FLOW_STATE);
    _arb_vec_set(start, s.start, FLOW_STATE);
    _arb_vec_set(s.start, there.states, FLOW_STATE);
    OWNED(found) back = run_to(&s, m, -DAY);
    assert_holds(back.states, start);
    assert_sharp(back.states, 150);
    ck_assert_double_eq(back.reached, -DAY);
}

/* ---- the nonlinear flow, against other roads ---- */

/*
 * mpmath 1.2.1, mp.dps = 50, in radians and units of 5 m:
 *   odefun(f, 0, x0)(Omega * 172800), f(t, s): x, y, z, u, v, w = s; q = 1/sqrt(x*x + y*y + z*z)
 *   A = (x*u + y*v + z*w)*q*q; P = q*q*(10*(q - 1) - 3*q - 2*A)
 *   return [u, v, w, 2*v + 3*x + P*x, -2*u + P*y, -z + P*z]
 * from 1.01 (cos t cos p, cos t sin p, -sin t), t = p = mpf(0.01), Omega = mpf(7.2915e-5), then in SI.
 */
TEST(eq03_flow_of_the_paper)
{
    static const char *const expected[FLOW_STATE] = {
        "4.9999437953916800220567873796713413968112114937463 +/- 1e-47",
        "0.00011197034262656221835285960551679100563548384869875 +/- 1e-47",
        "-0.050440264158965645123414510332210992532229395699998 +/- 1e-47",
        "-0.000000031711580383845685955411698211653547390313061381107 +/- 1e-51",
        "0.0000000027597638630855129232732471038931165846453228454936 +/- 1e-51",
        "0.00000045779311177627257314565526507035347304561916236798 +/- 1e-51"};
    OWNED(pair) s = paper_nonlinear();
    OWNED(found) r = run_to(&s, NONLINEAR, 2 * DAY);
    for (int i = 0; i < FLOW_STATE; i++)
        arb_set_str(s.start + i, expected[i], PREC);
    assert_overlap(r.states, s.start);
    assert_sharp(r.states, 200);
}

/* A local error of 1e-14 in some thousand steps of a motion that does not diverge */
TEST(eq03_flow_at_large_angles_agrees_with_ref)
{
    OWNED(pair) s = pair_of(7.2915e-5, 1, 1000, 10, 10, 2);
    start_at_angles(&s, 1.2, 0.9, -3);
    OWNED(found) r = run_to(&s, NONLINEAR, DAY);
    ck_assert_int_eq(r.status, FLOW_DONE);
    assert_near_ref(r.states, NONLINEAR, &s, DAY, 0, 1e-10);
}

/* ---- exact cases ---- */

/* Pitch apart from yaw and length in the linear model, and the orbit plane */
EACH(what_is_zero_stays_zero, 3)
{
    static const struct {
        enum way method;
        double start[3];
        int zero[2]; /* coordinates, and their rates */
    } all[] = {{LINEAR, {0, 1, 0}, {0, 2}}, {LINEAR, {1, 0, 0}, {1, 1}}, {NONLINEAR, {4, 2, 0}, {2, 2}}};
    OWNED(pair) s = paper();
    start_at(&s, all[_i].start[0], all[_i].start[1], all[_i].start[2], 0, 0, 0);
    OWNED(found) r = run_to(&s, all[_i].method, DAY);
    for (int k = 0; k < 2; k++)
        ck_assert(arb_is_zero(r.states + all[_i].zero[k]) && arb_is_zero(r.states + FLOW_HALF + all[_i].zero[k]));
    assert_sharp(r.states, 180);
}

EACH(eq05_static_formation_stays_exactly, 2)
{
    OWNED(pair) s = pair_of(7.2915e-5, 100, 150, 10, 10, 2);
    start_at(&s, 6, 0, 0, 0, 0, 0); /* m2 L_ref / (m1 + m2) */
    OWNED(found) r = run_to(&s, _i == 0 ? NONLINEAR : RK4_NONLINEAR, DAY);
    assert_same(r.states, s.start);
}

/* ---- enclosures ---- */

/* Wide initial balls, and a gain that is not known: what they hold, the enclosure holds, corners included. */
TEST(an_enclosure_holds_the_motions_from_a_box)
{
    enum { CORNERS = 1 << FLOW_STATE };
    OWNED(pair) s = paper(), box = paper();
    box.prec = 100;
    start_at_angles(&s, 0.05, 0.05, 0.1);
    start_at_angles(&box, 0.05, 0.05, 0.1);
    for (int i = 0; i < FLOW_STATE; i++)
        mag_set_d(arb_radref(box.start + i), i < 3 ? 1e-5 : 1e-9);
    mag_set_d(arb_radref(box.p.C1), 1e-13);
    const slong t = DAY / 2;
    OWNED(found) all = run_through(&box, NONLINEAR, &t, 1, 2, 0, 0);
    ck_assert_int_eq(all.status, FLOW_DONE);
    for (int corner = 0; corner < CORNERS; corner += 5) {
        OWNED(pair) one = paper();
        one.prec = 100;
        for (int i = 0; i < FLOW_STATE; i++)
            arb_set_d(one.start + i, number(s.start + i) + (corner >> i & 1 ? 1 : -1) * (i < 3 ? .99e-5 : .99e-9));
        arb_set_d(one.p.C1, number(s.p.C1) + (corner & 1 ? .99e-13 : -.99e-13));
        OWNED(found) r = run_to(&one, NONLINEAR, t);
        assert_holds(all.states, r.states);
    }
    assert_sharp(all.states, 5); /* the box itself grows by the motion, a hundredfold at the most */
}

EACH(motions_that_grow_and_stiff_gains_are_followed, 2)
{
    OWNED(pair) s = pair_of(7.2915e-5, 150, 150, 10, _i == 0 ? 10 : 1e6, _i == 0 ? -0.5 : 2000);
    start_at_angles(&s, 0.01, 0.01, 0.1);
    OWNED(found) r = run_to(&s, NONLINEAR, _i == 0 ? 2 * DAY : 500);
    ck_assert_int_eq(r.status, FLOW_DONE);
    assert_sharp(r.states, 150);
}

/* ---- the error terms of a step ---- */

/* One radian of orbit is 2^14 s; no gains but those given; equal craft, r_ref = 4 m. */
enum { RADIAN_LOG2 = 14, ROWS = 8, R_REF = 4 };

static struct pair plain_pair(double c1, double c2)
{
    struct pair s = pair_of(0x1p-14, 150, 150, 2 * R_REF, c1, c2);
    s.prec = 128; /* of what is true; what is tested has less */
    return s;
}

/* By steps of that kind */
static struct found follow_by(const struct flow_steps *how, const struct pair *s, const fmpq *times, slong count)
{
    return follow(s, NONLINEAR, times, count, 0, 0, 0, how);
}

/* `ROWS` rows, the last of them at that many radians, by steps of that kind */
static struct found run_steps(const struct pair *s, const struct flow_steps *how, double radians)
{
    VECTOR(fmpq, times, ROWS);
    for (slong k = 0; k < ROWS; k++)
        fmpq_set_si(times + k, (slong)ldexp(radians, RADIAN_LOG2 + 16) * (k + 1) / ROWS, 1 << 16);
    return follow_by(how, s, times, ROWS);
}

/* What the flow itself makes of it in 128 bits and more than 40 terms, all of whose rows lie in those of `wide` */
static void assert_rows_hold(const struct found *wide, const struct pair *one, double radians, const char *term)
{
    static const struct flow_steps own;
    OWNED(found) truth = run_steps(one, &own, radians);
    ck_assert_int_eq(wide->status, FLOW_DONE);
    ck_assert_int_eq(wide->rows, ROWS);
    ck_assert_int_eq(truth.rows, ROWS);
    for (slong i = 0; i < ROWS * FLOW_STATE; i++)
        ck_assert_msg(arb_contains(wide->states + i, truth.states + i), "%s: row %d, coordinate %d", term, (int)i / FLOW_STATE,
                      (int)i % FLOW_STATE);
}

enum { UNKNOWN = FLOW_STATE + 4 }; /* the state, c1, c2, and the relative widths of L_ref and m1 */

static void set_unknown(struct pair *s, const double centre[FLOW_STATE], const double c[2], const double radius[UNKNOWN], int corner)
{
    const double sign = corner < 0 ? 0 : 1; /* at the corner of that number, or all of the box */
    double at[UNKNOWN];
    for (int i = 0; i < UNKNOWN; i++)
        at[i] = sign * (corner >> i & 1 ? radius[i] : -radius[i]);
    for (int i = 0; i < FLOW_STATE; i++)
        arb_set_d(s->start + i, (centre[i] + at[i]) * R_REF * (i < 3 ? 1 : 0x1p-14));
    arb_set_d(s->p.C1, (c[0] + at[6]) * 0x1p-28);
    arb_set_d(s->p.C2, (c[1] + at[7]) * 0x1p-14);
    arb_set_d(s->p.L_ref, 2 * R_REF * (1 + at[8]));
    arb_set_d(s->p.m1, 150 * (1 + at[9]));
    if (corner >= 0)
        return;
    for (int i = 0; i < FLOW_STATE; i++)
        mag_set_d(arb_radref(s->start + i), radius[i] * R_REF * (i < 3 ? 1 : 0x1p-14));
    mag_set_d(arb_radref(s->p.C1), radius[6] * 0x1p-28);
    mag_set_d(arb_radref(s->p.C2), radius[7] * 0x1p-14);
    mag_set_d(arb_radref(s->p.L_ref), 2 * R_REF * radius[8]);
    mag_set_d(arb_radref(s->p.m1), 150 * radius[9]);
}

/* Orders 2 to 6, from a point, in 60 bits: what a series leaves out is a million times what is rounded. */
RANGE(F1_the_path_has_a_remainder, 2, 7)
{
    OWNED(pair) s = plain_pair(10, 1), fine = plain_pair(10, 1);
    const struct flow_steps how = {.order = _i, .step = 0x1p-5};
    start_at(&s, 4.5, 0.5, -0.25, 0x1p-14, 0, 0);
    start_at(&fine, 4.5, 0.5, -0.25, 0x1p-14, 0, 0);
    s.prec = 60;
    OWNED(found) one = run_steps(&s, &how, 0x1p-5), many = run_steps(&s, &how, 0x1p-2);
    assert_rows_hold(&one, &fine, 0x1p-5, "one step");
    assert_rows_hold(&many, &fine, 0x1p-2, "eight");
}

/*
 * Boxes whose rows hold those from all of their corners: in units of r_ref and of Omega r_ref, steps of 2^-`step` radians, all rows
 * within 2^-`end`. Where a width is 0 the number is known.
 */
static const struct {
    const char *term;
    double centre[FLOW_STATE], gains[2], radius[UNKNOWN];
    slong derivative_order;
    int step, end;
} boxes[] = {
    /* 1/16 to either side in x: at once every row has that width */
    {"F2: its width", {1, 0.25}, {10, 1}, {0x1p-4}, 1, 8, 8},
    {"F2: its width", {1, 0.25}, {10, 1}, {0x1p-4}, 2, 8, 8},
    {"F2: its width", {1, 0.25}, {10, 1}, {0x1p-4}, 3, 8, 8},
    /* To degree 1, x = u s: the width of u is that of x over s */
    {"F3: the term of degree n", {1, 0.25}, {10, 1}, {[3] = 0x1p-4, 0x1p-4, 0x1p-4}, 1, 8, 8},
    /* To degree 1 again, but v' = -2u and u' grows with x: the width of x is one of v over s^2. Two steps later, of its width of v,
       4 h^2, the second step's bound has 3, and the first left out the fourth. */
    {"F4: the remainder", {0.75}, {10, 1}, {0x1p-12}, 1, 8, 8},
    {"F5: the remainder at the step's end", {0.75}, {10, 1}, {0x1p-12}, 1, 8, 7},
    /* Every direction moves, ... */
    {"F5: along x", {0.75, 0.25, 0, 0, 0, 0.5}, {10, 1}, {[0] = 0x1p-6}, 0, 8, 7},
    {"F5: along y", {0.75, 0.25, 0, 0, 0, 0.5}, {10, 1}, {[1] = 0x1p-6}, 0, 8, 7},
    {"F5: along z", {0.75, 0.25, 0, 0, 0, 0.5}, {10, 1}, {[2] = 0x1p-6}, 0, 8, 7},
    {"F5: along u", {0.75, 0.25, 0, 0, 0, 0.5}, {10, 1}, {[3] = 0x1p-6}, 0, 8, 7},
    {"F5: along v", {0.75, 0.25, 0, 0, 0, 0.5}, {10, 1}, {[4] = 0x1p-6}, 0, 8, 7},
    {"F5: along w", {0.75, 0.25, 0, 0, 0, 0.5}, {10, 1}, {[5] = 0x1p-6}, 0, 8, 7},
    /* ... and by all that its derivatives may be: with c1 = 9 from rest by 9 d^2, where in the middle they are zero; of 32 steps,
       for a row has the width of its own step anyhow */
    {"F5: derivatives in balls", {1}, {9, 0}, {0x1p-6}, 0, 12, 7},
    /* A quarter or less to either side, and times so short that only the first derivatives count: u' is 2.1 and 0.35 at the ends,
       where its derivative in the middle is -1; from the axis 1/|x| changes by what is zero in the middle, u' by 4.5 y^2, where there
       are no gains; with c1 = 9 the derivative in the middle is zero, whatever x is, where 1/|x| is 1; by w = 1 and the damping u'
       changes by -z, which only the velocity of the box tells */
    {"F6: all of the box in x", {1}, {10, 1}, {0.25}, 0, 12, 12},
    {"F6: 1/|x| of the box in y", {1}, {0, 1}, {[1] = 0.25}, 0, 12, 12},
    {"F6: 1/|x| of the box in z", {0, 1}, {0, 1}, {[2] = 0.25}, 0, 12, 12},
    {"F6: x where 1/|x| is 1", {1}, {9, 1}, {0x1p-6}, 0, 12, 12},
    {"F6: the velocity of the box", {1, 0, 0, 0, 0, 1}, {0, 1}, {[2] = 0x1p-6}, 0, 12, 12},
    /* Gains are known to a half of themselves: far from rest, and in motion, the path shows it, and at rest its derivatives do */
    {"F7: c1 in the path", {1.25}, {10, 1}, {[6] = 5}, 0, 8, 8},
    {"F7: c2 in the path", {1.25, 0, 0, 1}, {10, 1}, {[7] = 0.5}, 0, 8, 8},
    {"F7: c1 in the derivatives", {1}, {10, 1}, {[0] = 0x1p-6, [6] = 8}, 0, 10, 10},
    {"F7: c2 in the derivatives", {1}, {10, 1}, {[3] = 0x1p-6, [7] = 0.75}, 0, 10, 10},
    /* L_ref, or m1, is known to a sixteenth of itself: so is r_ref, in which the flow measures */
    {"F7: L_ref", {1.25}, {10, 1}, {[8] = 0x1p-4}, 0, 4, 3},
    {"F7: m1", {1.25}, {10, 1}, {[9] = 0x1p-4}, 0, 4, 3},
};

EACH(F2_to_F7_rows_of_a_box_hold_those_of_its_corners, COUNT(boxes))
{
    const double *const radius = boxes[_i].radius, end = ldexp(1, -boxes[_i].end);
    const struct flow_steps how = {.derivative_order = boxes[_i].derivative_order, .step = ldexp(1, -boxes[_i].step)};
    OWNED(pair) box = plain_pair(0, 0), one = plain_pair(0, 0);
    set_unknown(&box, boxes[_i].centre, boxes[_i].gains, radius, -1);
    box.prec = 60;
    OWNED(found) all = run_steps(&box, &how, end);
    for (int corner = 0; corner < 1 << UNKNOWN; corner++) {
        bool other = true;
        for (int i = 0; i < UNKNOWN; i++)
            other = other && !((corner >> i & 1) && radius[i] == 0);
        if (!other)
            continue;
        set_unknown(&one, boxes[_i].centre, boxes[_i].gains, radius, corner);
        assert_rows_hold(&all, &one, end, boxes[_i].term);
    }
}

/* A law of its own, y'' = c y more: where y is not 0 the path shows what c is, and where it is, the derivatives along y do. */
EACH(F7_constants_of_another_law_are_balls, 2)
{
    enum { V = 4, Y = 1, OWN = JET_ALL };
    struct term terms[JET_TERMS + 1];
    const struct system law = {JET_STATES, JET_SERIES, JET_ALL + 1, JET_TERMS + 1, terms};
    OWNED(pair) box = plain_pair(10, 1), one = plain_pair(10, 1);
    const double y = _i == 0 ? 1 : 0, width = _i == 0 ? 0 : 0x1p-4;
    VECTOR(arb, c, 1);
    VECTOR(arb, last, 4); /* y of each corner: what c is makes a difference */
    const struct flow_steps how = {.step = 0x1p-8, .system = &law, .constants = c};
    for (int t = 0, more = 0; t < JET_TERMS; t++) {
        if (t > 0 && closed_loop.terms[t].to != V && closed_loop.terms[t - 1].to == V)
            terms[t + more++] = (struct term){V, OWN, Y, 1};
        terms[t + more] = closed_loop.terms[t];
    }
    start_at(&box, R_REF, y, 0, 0, 0, 0);
    mag_set_d(arb_radref(box.start + Y), width);
    arb_one(c);
    mag_set_d(arb_radref(c), 0.5);
    box.prec = 60;
    OWNED(found) all = run_steps(&box, &how, 0x1p-8);
    for (int corner = 0; corner < 4; corner++) {
        start_at(&one, R_REF, y + (corner & 1 ? width : -width), 0, 0, 0, 0);
        arb_set_d(c, corner & 2 ? 1.5 : 0.5);
        mag_zero(arb_radref(c));
        OWNED(found) truth = run_steps(&one, &(struct flow_steps){.system = &law, .constants = c}, 0x1p-8);
        ck_assert_int_eq(all.rows, ROWS);
        ck_assert_int_eq(truth.rows, ROWS);
        for (slong k = 0; k < ROWS * FLOW_STATE; k += FLOW_STATE)
            assert_holds(all.states + k, truth.states + k);
        arb_set(last + corner, truth.states + FLOW_STATE * (ROWS - 1) + Y);
        ck_assert(corner < 2 || !arb_overlaps(last + corner, last + corner - 2));
    }
}

/*
 * A radian known to a fifth or a quarter of a step, without gains and from rest. The row lies between 0.96 and 1.44 steps, or between
 * 0.74 and 1.24, so that the first step's bounds do not hold for it: y goes as s^3, and an order of 2 leaves all of that to the remainder.
 */
EACH(F9_a_row_is_within_its_step_for_certain, 2)
{
    const double h = 0x1p-8, share = _i == 0 ? 0.2 : 0.25, middle = _i == 0 ? 1.2 : 0.99;
    const struct flow_steps how = {.order = 2, .step = h};
    OWNED(pair) s = plain_pair(0, 0), fine = plain_pair(0, 0);
    SCOPE(fmpq, t);
    fmpq_set_si(t, (slong)(middle * h * 0x1p24), 1 << 10);
    start_at(&s, 4.5, 0, 0, 0, 0, 0);
    start_at(&fine, 4.5, 0, 0, 0, 0, 0);
    mag_set_d(arb_radref(s.p.Omega), share * 0x1p-14);
    arb_set_d(fine.p.Omega, 0x1p-14 * (1 + share));
    s.prec = 60;
    OWNED(found) vague = follow_by(&how, &s, t, 1), end = follow_by(NULL, &fine, t, 1);
    ck_assert(vague.status == FLOW_DONE && end.status == FLOW_DONE);
    assert_holds(vague.states, end.states);
}

/* Steps of 53 bits, whose sum is no binary64 */
TEST(F9_a_step_starts_where_the_last_one_ended)
{
    OWNED(pair) s = plain_pair(10, 1);
    const struct flow_steps how = {.step = 0x1.0000000000001p-5}, own = {0};
    start_at(&s, 4.5, 0.5, -0.25, 0x1p-14, 0, 0);
    OWNED(found) odd = run_steps(&s, &how, 0x1p-2), other = run_steps(&s, &own, 0x1p-2);
    ck_assert(odd.rows == ROWS && other.rows == ROWS);
    for (int k = 0; k < ROWS; k++)
        assert_overlap(odd.states + k * FLOW_STATE, other.states + k * FLOW_STATE);
}

/*
 * Of every step that is proved, up to the longest, each of the three bounds is: the path's, the hull's, and that of what they spread.
 * And of q' = q^2, on which no direction of the set depends: there the hull alone, or the path, is what bears no longer step.
 */
EACH(F8_each_of_the_three_bounds_is_proved, 18)
{
    enum { Q = JET_STATES - 1 };
    static const slong orders[] = {2, 6, 24};
    static const struct term square = {Q, Q, Q, 1};
    static const struct system apart = {JET_STATES, JET_SERIES, JET_ALL, 1, &square};
    OWNED(expansion) e;
    OWNED(lohner) set;
    VECTOR(arb, box, FLOW_STATE);
    SCOPE(arb, c1, c2);
    SCOPE(mag, h);
    int proved = 0;
    expansion_init(&e, _i < 9 ? &closed_loop : &apart, orders[_i / 3 % 3], orders[_i % 3], NULL, NULL);
    lohner_init(&set);
    arb_set_ui(c1, 10);
    arb_set_ui(c2, 2);
    jet_constants(&e.path, c1, c2);
    jet_constants(&e.hull, c1, c2);
    for (int i = 0; i < FLOW_STATE; i++) {
        arb_set_d(box + i, i == 0 ? 0.75 : 0.125);
        mag_set_d(arb_radref(box + i), _i < 9 || i >= FLOW_HALF ? 0x1p-6 : 0);
        arb_get_mid_arb(e.path.c[i], box + i);
        arb_set(e.hull.c[i], box + i);
    }
    lohner_from_box(&set, box);
    expansion_path(&e, PREC, 0);
    expansion_derivatives(&e, &set);
    for (int k = 0; k < 10 * 32; k++) { /* from 2^-10 to 1 */
        const double step = exp2(k / 32.0 - 10);
        mag_set_d(h, step);
        if (expansion_prove(&e, &set, step, 1) <= 0)
            continue;
        ck_assert(majorant_prove(&e.path_bound, NULL, h) && majorant_prove(&e.hull_bound, NULL, h));
        ck_assert(majorant_prove(&e.spread_bound, &e.hull_bound, h));
        proved++;
    }
    ck_assert_int_gt(proved, 0);
    const double halved = expansion_prove(&e, &set, 1, 32); /* what was proved, and no more */
    ck_assert(halved > 0 && halved < 1 && ldexp(1, (int)lround(log2(halved))) == halved);
}

/* A gain of anything to 1e300 bears no step of 2^-37 radians: no row, not even one that soon. */
TEST(F8_what_no_halving_proves_is_no_step)
{
    OWNED(pair) s = plain_pair(10, 1);
    const struct flow_steps how = {.step = 0x1p-5};
    SCOPE(fmpq, t);
    fmpq_set_si(t, 1, 1);
    fmpq_div_2exp(t, t, 60);
    start_at(&s, 4.5, 0.5, -0.25, 0, 0, 0);
    mag_set_d(arb_radref(s.p.C1), 1e300);
    s.prec = 60;
    OWNED(found) r = follow_by(&how, &s, t, 1);
    ck_assert(r.status == FLOW_WIDE && r.rows == 0);
}

/* Steps are a fraction of 2^-5 radians; whatever Omega is in its ball, no more of them than were proved have been reached. */
EACH(what_is_reached_is_rounded_towards_the_start, 4)
{
    OWNED(pair) s = pair_of(7.2915e-5 * (1 + 0.037 * _i), 150, 150, 2 * R_REF, 8, -1);
    const struct flow_steps how = {.step = 0x1p-5};
    SCOPE(fmpq, t, reached, Omega);
    SCOPE(arf, x);
    fmpq_set_si(t, DAY, 1);
    start_at(&s, 4.5, 0.5, -0.25, 0, 0, 0);
    mag_set_d(arb_radref(s.p.Omega), _i < 2 ? 0 : 0x1p-44); /* 2^-30 of it */
    for (int i = 0; i < 3; i++)
        mag_set_d(arb_radref(s.start + i), 0x1p-5);
    s.prec = 60;
    OWNED(found) r = follow_by(&how, &s, t, 1);
    ck_assert_int_eq(r.status, FLOW_WIDE);
    arf_set_d(x, r.reached);
    arf_get_fmpq(reached, x);
    arb_get_ubound_arf(x, s.p.Omega, 128);
    arf_get_fmpq(Omega, x);
    fmpq_mul(reached, reached, Omega);
    const double steps = ldexp(fmpq_get_d(reached), 20); /* the last ones are halved */
    ck_assert_double_gt(steps, 0);
    ck_assert_double_eq_tol(steps, (double)lround(steps), 0.05);
    fmpq_set_si(t, lround(steps), 1 << 20);
    ck_assert(fmpq_cmp(reached, t) <= 0);
}

/* ---- ends ---- */

/* Of either: the method's steps lose ten bits a radian, 128 last for two days. */
EACH(an_enclosure_past_use_is_reported, 2)
{
    OWNED(pair) s = paper_nonlinear();
    const slong times[] = {DAY, 5 * DAY};
    s.prec = _i == 0 ? 186 : 128;
    OWNED(found) r = run_through(&s, _i == 0 ? NONLINEAR : RK4_NONLINEAR, times, 2, 50, 100, 0);
    ck_assert_int_eq(r.status, FLOW_WIDE);
    ck_assert_int_eq(r.rows, 1);
    ck_assert_double_gt(r.reached, DAY);
    ck_assert_double_lt(r.reached, 5 * DAY);
}

/* Omega t known to half a radian: no step holds all of that. And no exponential one of all gains. */
TEST(a_vague_time_is_reported)
{
    OWNED(pair) s = pair_of(0x1p-14, 150, 150, 10, 0, 0);
    start_at(&s, 6, 0, 0, 0, 0, 0);
    mag_set_d(arb_radref(s.p.Omega), 0x1p-17);
    struct found r = run_to(&s, NONLINEAR, 1 << 16);
    ck_assert_int_eq(r.status, FLOW_WIDE);
    found_clear(&r);
    mag_set_d(arb_radref(s.p.C1), 1e300);
    r = run_to(&s, LINEAR, 100);
    ck_assert_int_eq(r.status, FLOW_WIDE);
    found_clear(&r);
}

/*
 * From rest on the orbit normal at r_ref, no gains: z'' = -z - 3/z^2, so z'^2 = 6/z - 6 + 1 - z^2, and z = sin^2 a
 * makes the time of the fall the integral of 2 sin^2 a / sqrt(sin^4 a + sin^2 a + 6) over a from 0 to pi/2;
 * mpmath 1.2.1, mp.dps = 40: quad(lambda a: 2*sin(a)**2/sqrt(sin(a)**4 + sin(a)**2 + 6), [0, pi/2]).
 */
TEST(craft_too_close_to_follow_are_reported_with_the_time)
{
    const double fall = 0.57976169347716177911871646922770217;
    OWNED(pair) s = pair_of(0x1p-14, 150, 150, 10, 0, 0);
    start_at(&s, 0, 0, 5, 0, 0, 0);
    OWNED(found) r = run_to(&s, NONLINEAR, DAY);
    ck_assert_int_eq(r.status, FLOW_CLOSE);
    ck_assert_int_eq(r.rows, 0);
    ck_assert_double_lt(r.reached, fall * 0x1p14);
    ck_assert_double_gt(r.reached, fall * 0x1p14 * (1 - 1e-7)); /* steps end 2^-32 radians long */
}

/* Steps of 2^-33 radians: given up where the craft are closer than 2^-7 r_ref wherever in the ball they are, and nowhere else. */
EACH(short_steps_are_given_up_near_the_centre_alone, 3)
{
    static const struct {
        double x, width;
        enum flow_status status;
    } all[] = {{0.005, 0, FLOW_CLOSE}, {0.03, 0, FLOW_DONE}, {0.0065, 0.0026, FLOW_DONE}};
    OWNED(pair) s = plain_pair(10, 1);
    const struct flow_steps how = {.step = 0x1p-33};
    SCOPE(fmpq, t);
    fmpq_set_si(t, 1, 1L << 30);
    start_at(&s, all[_i].x * R_REF, 0, 0, 0, 0, 0);
    mag_set_d(arb_radref(s.start), all[_i].width * R_REF);
    s.prec = 60;
    OWNED(found) r = follow_by(&how, &s, t, 1);
    ck_assert_int_eq(r.status, all[_i].status);
    ck_assert_int_eq(r.rows, all[_i].status == FLOW_DONE);
}

/* Without attraction enough to meet, craft that nearly do are followed through. */
TEST(a_near_miss_is_followed_through)
{
    OWNED(pair) s = pair_of(0x1p-14, 150, 150, 10, 0, 0);
    start_at(&s, 0.5, 0, 5, 0, 0, 0);
    OWNED(found) r = run_to(&s, NONLINEAR, 12000); /* after 9,500 s they would have met */
    ck_assert_int_eq(r.status, FLOW_DONE);
}

EACH(a_receiver_stops_a_flow, 4)
{
    const slong times[] = {0, 100, 200, 300};
    OWNED(pair) s = paper_nonlinear();
    OWNED(found) r = run_through(&s, (enum way)_i, times, 4, 17, 100, 2);
    ck_assert_int_eq(r.status, FLOW_STOPPED);
    ck_assert_int_eq(r.rows, 2);
    ck_assert_double_eq(r.reached, 100);
}

/* Whichever coordinate is wide, and whichever is the largest; what has no bound is wide beside anything. */
EACH(any_coordinate_makes_an_enclosure_wide, FLOW_STATE)
{
    VECTOR(arb, state, FLOW_STATE);
    arb_set_ui(state + (_i + 1) % FLOW_STATE, 8);
    mag_set_d(arb_radref(state + _i), 0.24);
    ck_assert(!flow_wide(state, 5));
    mag_set_d(arb_radref(state + _i), 0.26);
    ck_assert(flow_wide(state, 5));
    mag_inf(arb_radref(state + _i));
    ck_assert(flow_wide(state, 5));
    ck_assert(flow_wide(state, -1000));
}

/* Where the craft may be in one place, a parameter may be 0, or is anything, there is no row of anything. */
EACH(of_what_may_be_anything_there_is_no_row, 6)
{
    OWNED(pair) s = paper_nonlinear();
    arb_ptr value[] = {s.p.Omega, s.p.L_ref, s.p.C1, s.start + 5, s.p.m2, s.start};
    for (int m = LINEAR; m <= RK4_NONLINEAR; m++)
        if (_i < 4 || m % 2 == 1) {
            SCOPE(arb, kept);
            arb_set(kept, value[_i]);
            mag_set_d(arb_radref(value[_i]), _i == 2 || _i == 3 ? INFINITY : 2 * fabs(number(kept)));
            OWNED(found) r = run_to(&s, (enum way)m, 100);
            ck_assert_int_eq(r.status, FLOW_WIDE);
            ck_assert_int_eq(r.rows, 0);
            arb_set(value[_i], kept);
        }
}

/* At 0 alone, once or twice, the state is the initial one itself, and nothing else is said. */
EACH(at_time_zero_the_state_is_the_initial_one, 4)
{
    const slong count = 1 + _i / 2;
    static const slong times[MOST_TIMES];
    OWNED(pair) s = paper_nonlinear();
    mag_set_d(arb_radref(s.start), 0x1p-20);
    OWNED(found) r = run_through(&s, _i % 2 == 0 ? NONLINEAR : LINEAR, times, count, 17, 0, 0);
    ck_assert_int_eq(r.status, FLOW_DONE);
    ck_assert_int_eq(r.rows, count);
    for (int k = 0; k < count; k++)
        assert_same(r.states + k * FLOW_STATE, s.start);
}

/* A million radians for a flow, ten thousand and ten million steps for the method: none of them starts. */
EACH(beyond_reach_no_motion_starts, 6)
{
    static const struct {
        enum way method;
        slong t, h;
    } beyond[] = {{LINEAR, 14000000000, 0}, {NONLINEAR, 14000000000, 0}, {NONLINEAR, -14000000000, 0},
                  {RK4_LINEAR, 140000000, 1000}, {RK4_NONLINEAR, 140000000, 1000}, {RK4_LINEAR, 10000001, 1}};
    OWNED(pair) s = paper_nonlinear();
    OWNED(found) r = run_through(&s, beyond[_i].method, &beyond[_i].t, 1, 17, beyond[_i].h, 0);
    ck_assert_int_eq(r.status, FLOW_STALLED);
    ck_assert_int_eq(r.rows, 0);
    ck_assert_int_le(flow_precision(17, INFINITY), 200000);
    ck_assert_int_le(rk4_precision(17, INFINITY), 300000);
}

/* ---- Runge and Kutta ---- */

/* A hundred steps of ref's, in doubles and in SI: a hundred times some roundings. */
EACH(rk4_steps_are_an_implementers, 2)
{
    enum { STEPS = 100, H = 100 };
    OWNED(pair) s = pair_of(7.2915e-5, 120, 410, 23, 12, 4);
    if (_i == 0)
        start_at_angles(&s, 0.3, -0.4, 2);
    else
        start_at(&s, 0.3, -0.4, 2, 1e-5, -2e-5, 3e-5);
    const enum way way = _i == 0 ? RK4_NONLINEAR : RK4_LINEAR;
    OWNED(found) r = run_to(&s, way, STEPS * H);
    assert_near_ref(r.states, way, &s, STEPS * H, H, 1e-12);
    assert_sharp(r.states, 200);
}

EACH(rk4_takes_whole_steps_forward, 3)
{
    static const slong wrong[][2] = {{100, 150}, {100, -100}, {200, 100}};
    OWNED(pair) s = paper_nonlinear();
    for (int m = RK4_LINEAR; m <= RK4_NONLINEAR; m++) {
        OWNED(found) r = run_through(&s, (enum way)m, wrong[_i], 2, 17, 100, 0);
        ck_assert_int_eq(r.status, FLOW_DOMAIN);
        ck_assert_int_eq(r.rows, 1);
    }
}

/* ---- working precisions ---- */

/* At the precision that is foretold, every coordinate has its digits: two days, n = 10 and n = 40. */
EACH(foretold_precision_is_enough, 8)
{
    const enum way m = (enum way)(_i / 2);
    const double n = _i % 2 == 0 ? 10 : 40, radians = 7.2915e-5 * 2 * DAY;
    const slong digits = 40, t = 2 * DAY;
    OWNED(pair) s = pair_of(7.2915e-5, 150, 150, 10, n, 2 * sqrt(n - 9));
    s.prec = m == LINEAR || m == NONLINEAR ? flow_precision(digits, radians) : rk4_precision(digits, radians);
    if (m == LINEAR || m == RK4_LINEAR)
        start_at(&s, 0.01, 0.01, 0.1, 0, 0, 0);
    else
        start_at_angles(&s, 0.01, 0.01, 0.1);
    OWNED(found) r = run_through(&s, m, &t, 1, digits, 100, 0);
    ck_assert_int_eq(r.status, FLOW_DONE);
    for (int i = 0; i < FLOW_STATE; i++)
        ck_assert_double_gt((double)arb_rel_accuracy_bits(r.states + i), log2(10) * (double)digits + 1);
}
