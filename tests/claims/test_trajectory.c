/*
 * verify/claims/trajectory.h: the samples that the claims about the simulation rest on, and what is certain between and after them.
 * Digits come from mpmath 1.2.1 with
 *
 *     mp.dps = 40; Om = mpf('7.2915e-5')
 *     A = lambda n: the matrix of (40) over psi theta l psi' theta' l', l = dL/L_ref, in radians of orbit
 *     samples of the linear model: expm(A(n)*Om*T)*matrix([0.01, 0.01, 0.01, 0, 0, 0])
 *     samples of the nonlinear model: odefun(f, 0, [0.01, 0.01, 0.01, 0, 0, 0])(Om*T), f with c1 = n, c2 = 2*sqrt(n - 9):
 *         psi''   = -2*(l'/l - theta'*tan(theta))*(1 + psi') - 3*sin(psi)*cos(psi)
 *         theta'' = -2*l'/l*theta' - sin(theta)*cos(theta)*((1 + psi')**2 + 3*cos(psi)**2)
 *         l''     = l*(theta'**2 + cos(theta)**2*((1 + psi')**2 + 3*cos(psi)**2) - 1) + (c1*(1 - l) - 3 - c2*l')/l**2
 *     with l = 1 + dL/L_ref, Lagrange's equations in the angles, which the flow knows nothing of.
 */
#include "tests/claims/balls.h"
#include "tests/run.h"
#include "tests/paper.h"

/* ---- trajectories ---- */

/* The decimal, correctly rounded, lies within its last digit of x. */
static void assert_ball(const arb_t x, const char *decimal)
{
    SCOPE(arb, y, ulp);
    ck_assert_int_eq(arb_set_str(y, decimal, 128), 0);
    arb_abs(ulp, y);
    arb_div_ui(ulp, ulp, 1000000000000000000, 128); /* of 20 digits: 1e-19 to 1e-18 of the value */
    arb_add_error(y, ulp);
    ck_assert_msg(arb_contains(y, x), "expected %s", decimal);
}

static const struct {
    struct simulation simulation;
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

CASE(trajectory, NULL, flint_cleanup)

EACH(trajectories_agree_with_the_equations_in_the_angles, COUNT(rows))
{
    struct trajectory t;
    struct simulation s = rows[_i].simulation;
    s.steps = steps();
    ck_assert(trajectory_run(&t, &s, 0, rows[_i].t, rows[_i].t));
    for (int i = 0; i < FLOW_STATE; i++)
        assert_ball(trajectory_sample(&t, 1) + i, rows[_i].row[i]);
    trajectory_clear(&t);
}

/* From a box of which nothing is proved there is no number of any sample. */
TEST(a_motion_that_is_not_proved_to_its_end_has_no_numbers)
{
    struct trajectory t;
    VECTOR(arb, start, FLOW_STATE);
    mag_set_d(arb_radref(start + PSI), 0.5);
    ck_assert(!trajectory_run(&t, &(struct simulation){.steps = steps(), .nonlinear = true, .start = start}, 0, HOUR, DAY));
    for (slong k = 0; k < t.count; k++)
        for (int i = 0; i < COORDINATES; i++)
            ck_assert(!arb_is_finite(trajectory_sample(&t, k) + i));
    trajectory_clear(&t);
}

/* E falls from sample to sample, and by what C2 takes: -c2 (l'/l)^2, or -c2 eta'^2, by the trapezoidal rule. */
EACH(energy_falls_by_what_the_gain_takes, 2)
{
    struct trajectory t;
    VECTOR(arb, x, 4);
    ck_assert(trajectory_run(&t, &(struct simulation){.steps = steps(), .nonlinear = _i != 0, .theta = "0.03"}, 0, 10, 7200));
    double lost = 0;
    for (slong k = 0; k < t.count; k++) {
        trajectory_energy(x + k % 2, &t, k);
        if (k > 0)
            ck_assert(arb_lt(x + k % 2, x + (k + 1) % 2));
        arb_add_ui(x + 2, trajectory_sample(&t, k) + ETA, _i != 0, t.prec);
        arb_div(x + 3, trajectory_sample(&t, k) + ETA_DOT, x + 2, t.prec);
        arb_sqr(x + 3, _i != 0 ? x + 3 : trajectory_sample(&t, k) + ETA_DOT, t.prec);
        lost += (k == 0 || k == t.count - 1 ? 0.5 : 1) * 2 * arf_get_d(arb_midref(x + 3), ARF_RND_NEAR) * 7.2915e-4;
    }
    trajectory_energy(x, &t, 0);
    trajectory_energy(x + 1, &t, t.count - 1);
    arb_sub(x, x, x + 1, t.prec);
    /* 720 intervals of 7.3e-4 rad: the rule errs by some 1e-6 of the whole */
    ck_assert_double_eq_tol(arf_get_d(arb_midref(x), ARF_RND_NEAR) / lost, 1, 1e-5);
    trajectory_clear(&t);
}

/* One step of the method turns pitch by the terms of exp(i x) up to x^4, x = 2 Omega h: an hour's is 0.524988. */
TEST(steps_are_as_long_as_they_are_said)
{
    struct trajectory t;
    SCOPE(arb, x, sum);
    ck_assert(trajectory_run(&t, &(struct simulation){.steps = steps(), .rk4 = HOUR}, 0, HOUR, HOUR));
    arb_mul_ui(x, t.Omega, 2 * HOUR, t.prec);
    arb_sqr(x, x, t.prec);
    arb_div_si(sum, x, -12, t.prec); /* 1 - x^2/2 (1 - x^2/12) */
    arb_add_ui(sum, sum, 1, t.prec);
    arb_mul(sum, sum, x, t.prec);
    arb_div_si(sum, sum, -2, t.prec);
    arb_add_ui(sum, sum, 1, t.prec);
    arb_mul(sum, sum, trajectory_sample(&t, 0) + THETA, t.prec);
    ck_assert(arb_overlaps(sum, trajectory_sample(&t, 1) + THETA) && arb_rel_accuracy_bits(sum) > 60);
    trajectory_clear(&t);
}
