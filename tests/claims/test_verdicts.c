/*
 * The evidence of data/verdicts.csv, which is what the program writes (tests/project/test_data.sh), says the numbers that were found
 * by another road. Digits come from mpmath 1.3.0, mp.dps = 30; the expressions stand beside them, with
 *
 *     W = lambda n, r: -mpf(3)/2*r**2 + (n - 3)/r + n*log(r)
 *     r2 = lambda n: (-3 + sqrt(12*n - 27))/6
 *     rest = lambda f, near: 10*(findroot(f, near) - 1)
 *     fold = lambda s, n, near: findroot(lambda r, u: [f(s, n, r, u), diff(lambda q: f(s, n, q, u), r)], near)
 *     f = lambda s, n, r, u: s(u*r)*(3 + n*(r - 1)) - 3*r**3
 *
 * Motions are checked by the reference's Runge-Kutta method, which shares nothing with the certified flow.
 */
#include <stdio.h>
#include <string.h>

#include "coulombtether.h"
#include "tests/run.h"
#include "tests/paper.h"

static const struct {
    const char *id, *says;
} expected[] = {
    {"other-static-places", "t = 3, 0, -1"}, /* Hill's tide */
    {"other-static-places", "along the orbit normal -1/3"}, /* L/L_1 = Q/Q_1: z balances at a third */
    {"reorientation", "turned by -9/28 of"}, /* mpf(1)/4 - mpf(4)/7 */
    {"power-and-bandwidth", "6559 V and has k_c q^2/(2 R) = 0.001196 J"}, /* 8.99e9*q/0.5, 8.99e9*q**2, q = sqrt(1.330627782e-13) */
    {"charging-devices", "2.28e+12 electrons"}, /* q/1.602176634e-19 */
    {"static-unstable", "2.50829;"}, /* sqrt(1 + 2*sqrt(7)) */
    {"static-unstable", "1.11803;"}, /* max(re(s) for s in polyroots([1, 0, -1, 0, 4])) */
    {"equal-distances", "x1 = 2 m, x2 = -1 m"},
    {"nadir-axis", "zenith"},
    {"opposite-charges", "-1.330627782e-13 C^2"}, /* -3*7.2915e-5**2*1000/8.99e9*75 */
    {"non-keplerian-periods", "1.7787e-07 slower"}, /* 1 - (1 + 5/R)**-1.5 */
    {"non-keplerian-periods", "42166.54 km"}, /* R = cbrt(3.986004418e14/7.2915e-5**2) */
    {"sum-bounds", "exactly"},
    {"cosines-cited", "(9)"},
    {"masses-cancel", "neither masses nor k_c"},
    {"zero-charge-orbit", "7.6284 and 5.2658 after a quarter"}, /* cosh(sqrt(3)*pi/2), */
    {"zero-charge-orbit", "26626 and 37.712 after a whole one"}, /* sqrt(1 + 144*pi**2) */
    {"constant-charge-separates", "61.361 m after 12 h and 399.65 m"}, /* below */
    {"tension-compression", "q1 q2 = -4"}, /* -|5 - 1| */
    {"other-rests", "11.072751 m (n = 10), 13.027756 m (n = 12)"}, /* 10*r2(10), 10*r2(12) */
    {"other-rests", "7.0 m, 7.5 m"},
    {"other-rests", "6.69933 m, 7.19023 m"}, /* 10*findroot(lambda r: r**3 + n*r - n + 3, 0.7) */
    {"basin-at-rest", "-0.502684 m and 1.0727513 m"}, /* rest(lambda r: W(10, r) - W(10, r2(10)), .95) */
    {"basin-at-rest", "-1.27303 m and 3.0277564 m"},
    {"printed-charges", "6.26300 m, 6.73593 m"}, /* 10*findroot(lambda r: 3*r**3 + n*r - n + 3, 0.65) */
    {"product-negative", "-3.0 m (n = 10), -2.5 m (n = 12)"},
    {"product-negative", "5.501760"}, /* W(10, r2(10)) */
    {"variation-small", "1/30"}, /* 10*0.1/(3*10) */
    {"charge-error", "+0.00825 m (n = 10), +0.00273 m (n = 12)"}, /* rest(f...), u = 0, */
    {"charge-error", "-0.2298 m, -0.09363 m"}, /* s = 1 + d */
    {"charge-error", "+0.1078 m at n = 12"},
    {"charge-error", "0.7750 % too little (n = 10), 5.078 %"}, /* 1 - 81*49/4000, 1 - 81*81/6912 */
    /* expm of the model with its charge held and largest |eigenvalue| 1 by bisection, to 10 digits */
    {"sampled-law", "0.41546766 (n = 10), 0.65162675 (n = 12), 0.55819849 rad"},
    /* min over polyroots x > 0 of (pi - arg((x**2 + 2*x - 27)/((c1 + 1j*c2*sqrt(x))*(3 - x))))/sqrt(x) */
    {"late-law", "0.18066995 (n = 10), 0.22120544 (n = 12), 0.23222548 rad"},
    {"pitch-damped", "by the averaged law 0.004720"}, /* 0.01/sqrt(1 + 2*18/mpf(13)/100*20*86400*7.2915e-5) */
    {"screened-force", "1.0071 to 1.1 "},
    {"debye-order", "0.09516"}, /* 1 - exp(-0.1) */
    {"debye-order", "0.004679"}, /* 1 - 1.1*exp(-0.1) */
    {"debye-neglect", "0.007117 ... 0.09516 as printed, 2.539e-05 ... 0.004679"},
    {"debye-neglect", "0.06894 ... 0.6321 and 0.002433 ... 0.2642"}, /* 1 - 2*exp(-1) */
    /* 10/fold(s, n, near)[1] and rest(lambda r: f(s, n, r, 1/140), 1), s = exp(-u) */
    {"debye-escape", "lost below 1348.7 m, and at 1400 m rest longer by 0.386 m (n = 12: 214.94 m, 0.0756 m)"},
    {"debye-escape", "limit is 8.0681 (n = 10), 3.1143 (n = 12)"}, /* 1/fold(s, n, near)[1], s = (1 + u)*exp(-u) */
    {"debye-escape", "0.186 m, 0.0489 m"}, /* u = 1/10 */
    {"low-orbit", "3.72e-44"}, /* exp(-100) */
    {"debye-lengths", "5526"}, /* 8.8541878188e-12/1.602176634e-19/1e4 */
    {"coulomb-constant", "8.9875518e+09"}, /* 1/(4*pi*8.8541878188e-12) */
    {"orbit-rate", "8.43e-05"}, /* 1 - 7.2915/7.292115 */
    {"orbit-rate", "42164.173 km"},
    {"reach", "11.54 uC 100 m; 1 uC holds 19.59 m, 10 uC 90.92 m"},
    {"own-gravity", "36.5 mm (n = 10), 12.5 mm"}, /* -rest(lambda r: 3*r**3 - 3 - n*(r-1) - 3*g, 1) */
    /* roots = lambda n: polyroots([1, 2*sqrt(n-9), n-2, 6*sqrt(n-9), 3*(n-9)], maxsteps=500, extraprec=500), mp.dps = 90;
       rate = lambda n: min(-re(r) for r in roots(n))
       best = findroot(lambda n: diff(rate, n, h=mpf(10)**-25), (mpf('11.8'), mpf('11.82')), tol=1e-50) */
    {"constant-charge-linear", "2.5082867902473156351"}, /* sqrt(1 + 2*sqrt(7)) */
    {"constant-charge-linear", "5467.72 s"}, /* 1/(7.2915e-5*sqrt(1 + 2*sqrt(7))) = 5467.7157... */
    {"phase-damps", "171.2852"}, /* arg(-(r**2 + 3))*180/pi, r in roots(10) */
    {"phase-damps", "45.26008"},
    {"real-parts-vanish", "-0.1069846374 and -0.1430153626"}, /* roots(9.0625) */
    {"real-parts-vanish", "-0.04948884256 and -5.518275520"}, /* roots(40) */
    {"slow-at-the-ends", "11.81160194899945"},
    {"n12-optimal", "at n = 12.01656610"}, /* 9 + u**2 at the least x'*P*x, x = [1, 1, 0, 0], A'*P + P*A = -diag(1, 1, 0, 0): sympy 1.14, */
    {"n12-optimal", "independent at 12.35835627"}, /* at the least P[0, 0] + P[1, 1]; */
    {"n12-optimal", "least at 10.27554224"}, /* A'*P + P*A = -diag(1, 0, 0, 0) */
    {"fastest-decay", "11.8116019489994475627782,"},
    {"fastest-decay", "0.598916907216339712577893 "},
    {"fastest-decay", "0.5960704898964056783432 "}, /* rate(12) */
    {"fastest-decay", "0.4159258382875836439251,"}, /* rate(10) */
    {"fastest-decay", "0.995247391941 "}, /* rate(12)/rate(best) */
    {"fastest-decay", "0.694463344207 "}, /* rate(10)/rate(best) */
    {"matching-optimal", "1.669680699 "}, /* 1/rate(best), 1/rate(12), 1/rate(10) */
    {"matching-optimal", "1.677653930 "},
    {"matching-optimal", "2.404274772 "},
    {"frequencies", "0.532450262801 and 2.49612372429"}, /* im(roots(10)) */
    {"frequencies", "1.10401859576 and 2.10401859576"}, /* im(roots(12)) */
    {"length-wiggle", "-0.415925838288 +- 0.532450262801 i"}, /* roots(10) */
    {"length-wiggle", "-0.584074161712 +- 2.49612372429 i"},
    {"pitch-decoupled", "43085.6840649 s"}, /* pi/7.2915e-5 */
    {"pitch-uncontrollable", "rank 4 of 6"},
    {"step-below-period", "34522.0740827 s"}, /* 2*pi/(7.2915e-5*2.496123724292996301548900) */
    /* the largest of 2592 steps, R = sum((A(10)*100*Om)**k/k!, k = 0 ... p) against expm(A(10)*100*Om), as in test_trajectory.c:
       p = 4 has 7.3483986e-12, 1.3625865e-10, 5.8378502e-12 in psi, theta, dL/L_ref */
    {"step-small-enough", "linear model 7.4e-12, 1.4e-10, 5.9e-12;"},
    /* abs((sum((1j*h)**k/factorial(k) for k in range(p + 1))*exp(-1j*h))**2592 - 1), h = 200*Om, p = 1 ... 4: 0.317313, 0.00133976, */
    {"runge-kutta-kind", "off by 0.32 of the amplitude (Euler's method), 0.0014 (second order), 4.9e-06 (third), 1.5e-08 (fourth)"}, /* 4.88437e-6, 1.42458e-8 */
    {"two-revolutions", "2.00531 revolutions"}, /* 172800*Om/(2*pi) = 2.0053085 */
    /* psi(2 d) = 3.16895001526e-5 and dL(2 d)/L_ref = 2.76209999640e-5, and less from there on */
    {"settling-linear", "|psi| <= 0.0032 of its initial value, |dL| <= 0.0028 of its"},
    {"length-wiggle", "(n = 10) changes sign at least 3 times"}, /* at 5.31, 28.5, 51.1 h */
    {"length-wiggle", "n = 12 changes sign at least 7 times"}, /* 5.31, 16.6, ... 70.7 h */
    /* 1 - (psi'**2 + 3*psi**2)/(3*0.01**2) after two days, from psi above and psi' = -1.7450238805e-5 */
    {"yaw-energy", " takes 0.9999889 of "},
    {"figure-5b", "at most 0.00051,"}, /* 5.05*(1 - cos(0.01)**2) = 5.0498e-4, at the start */
    /* nonlinear less linear after a day for 1e-6 at the start: 0.10868051e-12, 1.1740994e-12, 0.74260254e-12 in psi,
       theta, dL/L_ref; in x1 0.24175652e-12 */
    {"linear-second-order", "c = 0.109, 1.17, 0.743, 0.242, 0.109, 1.17"},
    /* 0.0964020*a**2/0.01 and 0.2152296*a**2/0.01 for a = 0.0101003, the amplitude of pitch after 8 days */
    {"slower-with-pitch", "; 0.000984, 0.00220 (linear"},
    {"charges-opposite", "|dQ/Q_ref| <= 0.034,"}, /* 10*0.01/3 at the start */
    {"charges-deviation", "|q/q_ref - 1| <= 0.017,"}, /* 1 - sqrt(1 - 10*0.01/3) = 0.01681 */
    {"charges-microcoulomb", "q_ref = sqrt(-Q_ref) = 0.3647777 uC"}, /* 1e6*Om*sqrt(3e3*75/8.99e9) */
    {"charges-microcoulomb", "0.3708075 uC at the start"}, /* ... times sqrt(1 + 1/30) */
    /* 1.5*(1.01*sin(0.01)*cos(0.01))**2 + 2*(1.01*sin(0.01))**2 + 7*(1/1.01 - 1) + 10*log(1.01) - 1.5*(1.01**2 - 1) */
    {"nonlinear-energy", "E = 0.00040339"},
    /* s = sqrt(n - 9), D = 13*s**2 - 144 + 104j*s: 36/abs(D), 2*s*abs(s + 8j)/abs(D), 5184*s/abs(D)**2, and
       4.5*s**2*(13*s**2 + 688)/abs(D)**2 */
    {"forced-response", "10: 0.2152, 0.09640, -0.1853, -0.1128"},
    {"forced-response", "11.8: 0.1760, 0.1337, -0.2072, -0.2180"},
    {"forced-response", "12: 0.1727, 0.1360, -0.2065, -0.2258"},
    {"pitch-slow-law", "by the closed form 0.185"},
    {"pitch-stable", "k = 0.185295063802, phase rate 2 + s |z|^2, s = -0.112753333095"}, /* 5184/27977, -9*701/(2*27977) */
    {"pitch-best-gain", "= 11.48825648793501,"}, /* 9 + (32*sqrt(133) - 272)/39 */
};

EACH(evidence_says_what_another_road_finds, COUNT(expected))
{
    char line[8192];
    const size_t length = strlen(expected[_i].id);
    bool found = false;
    FILE *file = fopen("data/verdicts.csv", "r");
    ck_assert_ptr_nonnull(file);
    while (!found && fgets(line, sizeof line, file) != NULL)
        found = strncmp(line, expected[_i].id, length) == 0 && line[length] == ',';
    ck_assert_int_eq(fclose(file), 0);
    ck_assert_msg(found, "no verdict '%s'", expected[_i].id);
    ck_assert_msg(strstr(line, expected[_i].says) != NULL, "no '%s' in: %s", expected[_i].says, line);
}

/* ---- the same motions by another method ---- */

/* The distance over L_ref after `tau` radians, from rest on the radius; n = 0: constant charge. */
static double length_after(double n, double start, double tau)
{
    const struct ct_params p = {1, 1, 1, 1, 2};
    const struct ct_gains g = {n, n > 9 ? 2 * sqrt(n - 9) : 0};
    struct ct_hill_state s = {start, 0, 0, 0, 0, 0};
    ck_assert_int_eq(ct_nonlinear_flow(p, g, s, 1e-12, 1, &tau, &s), CT_OK);
    return hypot(s.x1, s.y1);
}

TEST(eq03_constant_charge_agrees_with_gsl)
{
    const double day = 7.2915e-5 * 86400;
    /* five digits stand in the evidence; the growth e^(2.5 tau) of the method's 1e-12 stays below 1e-5 */
    ck_assert_double_eq_tol(10 * length_after(0, 1.01, day / 2), 61.361, 0.0005);
    ck_assert_double_eq_tol(10 * length_after(0, 1.01, day), 399.65, 0.005);
    ck_assert_double_eq_tol(10 * length_after(0, 0.99, day / 2), 3.2397, 0.00005);
    ck_assert_double_eq_tol(10 * length_after(0, 0.99, day), 8.8297, 0.00005);
}

/* the slowest mode decays as e^(-0.42 tau), n = 10: 1e-3 is far below what 30 radians leave of a return */
TEST(eq18_returns_agree_with_gsl)
{
    ck_assert_double_eq_tol(length_after(10, 0.76, 30), 1, 1e-3);
    ck_assert_double_eq_tol(length_after(12, 0.2, 30), 1, 1e-3);
    ck_assert_double_eq_tol(length_after(12, 0.5, 30), 1, 1e-3);
    ck_assert_double_eq_tol(length_after(10, 1 + 0.107, 60), 1, 1e-3); /* just inside the outer place of rest */
}

TEST(eq18_escapes_agree_with_gsl)
{
    ck_assert_double_gt(length_after(10, 0.75, 30), 2);
    ck_assert_double_gt(length_after(12, 0.15, 30), 2);
    ck_assert_double_gt(length_after(10, 0.5, 30), 2);
    ck_assert_double_gt(length_after(10, 1 + 0.108, 60), 2); /* just outside */
}
