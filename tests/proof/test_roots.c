/*
 * The roots of (41). Exact cases come from factored polynomials: with Omega = 1 two roots may be
 * chosen freely, for they give two linear equations for C1 and C2. Digits come from mpmath 1.3.0:
 *
 *     mpmath.mp.dps = 60
 *     mpmath.polyroots([1, c2, c1 - 2, 3*c2, 3*(c1 - 9)], maxsteps=2000, extraprec=400)
 */

#include "tests/run.h"
#include "formula/expression.h"
#include "proof/roots.h"
#include "text/scope.h"

/* What a test needs: exact parameters and their roots. */
struct fixture {
    fmpq_t Omega, C1, C2;
    acb_ptr roots;
};

static void open_fixture(struct fixture *f, const char *Omega, const char *C1, const char *C2)
{
    fmpq_init(f->Omega);
    fmpq_init(f->C1);
    fmpq_init(f->C2);
    fmpq_set_str(f->Omega, Omega, 10);
    fmpq_set_str(f->C1, C1, 10);
    fmpq_set_str(f->C2, C2, 10);
    f->roots = _acb_vec_init(4);
}

static void fixture_clear(struct fixture *f)
{
    fmpq_clear(f->Omega);
    fmpq_clear(f->C1);
    fmpq_clear(f->C2);
    _acb_vec_clear(f->roots, 4);
    flint_cleanup();
}

static arb_srcptr part(acb_srcptr roots, int k, bool imaginary)
{
    return imaginary ? acb_imagref(roots + k) : acb_realref(roots + k);
}

/* Cases with every part known: a decimal (approximate), or a fraction that ends in "!" for exact. */
static const struct {
    const char *Omega, *C1, *C2;
    const char *value[8]; /* re1 im1 ... re4 im4, 40 digits */
} known[] = {
    {"1", "10", "2",
     {"-0.5840741617124163560749084910764553126396", "-2.496123724292996301548899996018423231362",
      "-0.5840741617124163560749084910764553126396", "2.496123724292996301548899996018423231362",
      "-0.4159258382875836439250915089235446873604", "-0.5324502628010928664781498418987736280046",
      "-0.4159258382875836439250915089235446873604", "0.5324502628010928664781498418987736280046"}},
    {"1", "3", "1",
     {"-2.402166636071528739933243552429197965237", "0",
      "-0.09875804249399613945191495302958045567021", "-2.162047138411428071626875252317747634799",
      "-0.09875804249399613945191495302958045567021", "2.162047138411428071626875252317747634799",
      "1.599682721059521018837073458488358876578", "0"}},
    {"1", "-5", "1/2",
     {"-3.541589130069412365389999926734827648843", "0",
      "-0.01462005763845206745898205490276855147407", "-1.965104744341983934219651035368974543317",
      "-0.01462005763845206745898205490276855147407", "1.965104744341983934219651035368974543317",
      "3.070829245346316500307964036540364751791", "0"}},
    /* a root that is nearly imaginary, beside one 10^15 times as large */
    {"1", "1000000000000000000000000000000", "1",
     {"-0.5", "-999999999999999.999999999999997375", "-0.5", "999999999999999.999999999999997375",
      "-6.000000000000000000000000000096e-60", "-1.732050807568877293527446341502408265328",
      "-6.000000000000000000000000000096e-60", "1.732050807568877293527446341502408265328"}},
    /* mpmath.mp.dps = 150: the real parts are small */
    {"1", "10", "1/1000000000000000000000000000000",
     {"-3.193375245281536402522927166821249220433e-31", "-2.757816396257007768738562585998658606531",
      "-3.193375245281536402522927166821249220433e-31", "2.757816396257007768738562585998658606531",
      "-1.806624754718463597477072833178750779567e-31", "-0.6280515301597558458740294783125338395874",
      "-1.806624754718463597477072833178750779567e-31", "0.6280515301597558458740294783125338395874"}},
    /* c2^2 = 4 (c1 - 8), c1 > 12: u^4 + 3/2 u^2 + 289/16 with u = s + 3/2; u^2 = -3/4 +- i sqrt(70)/2 */
    {"1", "17", "6",
     {"-2.763909304403380640632708264724324921854", "-1.532144487232662239970225819940841425509",
      "-2.763909304403380640632708264724324921854", "1.532144487232662239970225819940841425509",
      "-0.2360906955966193593672917352756750781455", "-1.532144487232662239970225819940841425509",
      "-0.2360906955966193593672917352756750781455", "1.532144487232662239970225819940841425509"}},
};

EACH(eq41_roots_agree_with_mpmath, COUNT(known))
{
    OWNED(fixture) f;
    SCOPE(arb, expected);
    SCOPE(mag, difference, unit);
    open_fixture(&f, known[_i].Omega, known[_i].C1, known[_i].C2);
    ck_assert(roots41(f.roots, f.Omega, f.C1, f.C2, 160));
    for (int k = 0; k < 8; k++) {
        arb_srcptr x = part(f.roots, k / 2, k % 2 == 1);
        arb_set_str(expected, known[_i].value[k], 200);
        arb_get_mag(unit, expected);
        mag_div_ui(unit, unit, 1000000000000000000); /* 10^-36 of it; the digits end at 10^-39 */
        mag_div_ui(unit, unit, 1000000000000000000);
        arb_sub(expected, expected, x, 200);
        arb_get_mag(difference, expected);
        ck_assert_msg(mag_cmp(difference, unit) <= 0, "part %d", k);
    }
}

/* Exactly known parts, as fractions; NULL is an irrational one. */
static const struct {
    const char *Omega, *C1, *C2;
    const char *value[8];
} exact[] = {
    /* c2 = 0: (s^2 + 1)(s^2 + 9) */
    {"1", "12", "0", {"0", "-3", "0", "-1", "0", "1", "0", "3"}},
    /* c2 = 0: (s^2 - 9)(s^2 + 4) */
    {"1", "-3", "0", {"-3", "0", "0", "-2", "0", "2", "3", "0"}},
    /* c2 = 0, c1 = 9: s^2 (s^2 + 7), a double root at 0 */
    {"1", "9", "0", {"0", NULL, "0", "0", "0", "0", "0", NULL}},
    /* ((s + 1)^2 + 2)^2, and its mirror image: double pairs */
    {"1", "12", "4", {"-1", NULL, "-1", NULL, "-1", NULL, "-1", NULL}},
    {"1", "12", "-4", {"1", NULL, "1", NULL, "1", NULL, "1", NULL}},
    /* c2^2 = 4 (c1 - 8), c1 < 12: s (s + 1)(s^2 + s + 6), a pair midway between two real roots */
    {"1", "9", "2", {"-1", "0", "-1/2", NULL, "-1/2", NULL, "0", "0"}},
    {"1", "9", "-2", {"0", "0", "1/2", NULL, "1/2", NULL, "1", "0"}},
    /* c2^2 = 4 (c1 - 8), c1 < 12: two pairs with one real part */
    {"1", "41/4", "3", {"-3/4", NULL, "-3/4", NULL, "-3/4", NULL, "-3/4", NULL}},
    /* the same where -c2/4 is no binary fraction: c1 = 8 + c2^2/4 */
    {"1", "97/9", "10/3", {"-5/6", NULL, "-5/6", NULL, "-5/6", NULL, "-5/6", NULL}},
    /* c1 = 9: s (s^3 + 5 s^2 + 7 s + 15) */
    {"1", "9", "5", {NULL, "0", NULL, NULL, NULL, NULL, "0", "0"}},
    /* (s + 1)^2 (s^2 + 3/2 s + 9/2), (s + 3)^2 (s^2 + 1/2 s + 5/2): a double real root and a pair */
    {"1", "21/2", "7/2", {"-1", "0", "-1", "0", "-3/4", NULL, "-3/4", NULL}},
    {"1", "33/2", "13/2", {"-3", "0", "-3", "0", "-1/4", NULL, "-1/4", NULL}},
    {"1", "21/2", "-7/2", {"3/4", NULL, "3/4", NULL, "1", "0", "1", "0"}},
    /* the same with Omega = 2: roots double, C1 times 4, C2 times 2 */
    {"2", "42", "7", {"-2", "0", "-2", "0", "-3/2", NULL, "-3/2", NULL}},
    /* (s^2 + 2 s + 5)(s^2 + 3/2 s + 3/2): a pair with rational parts */
    {"1", "23/2", "7/2", {"-1", "-2", "-1", "2", "-3/4", NULL, "-3/4", NULL}},
    /* (s^2 + s + 13/16)(s^2 + 3072/1993 s + 12699/1993) */
    {"1", "342021/31888", "5065/1993",
     {"-1536/1993", NULL, "-1536/1993", NULL, "-1/2", "-3/4", "-1/2", "3/4"}},
};

/* The coefficients of (41) are the symmetric functions of its roots (Vieta). */
static void check_coefficients(const struct fixture *f, slong prec)
{
    SCOPE(fmpq_poly, p);
    SCOPE(fmpq, square, c);
    SCOPE(acb_poly, product);
    fmpq_mul(square, f->Omega, f->Omega);
    fmpq_poly_set_coeff_si(p, 4, 1);
    fmpq_poly_set_coeff_fmpq(p, 3, f->C2);
    fmpq_sub(c, f->C1, square);
    fmpq_sub(c, c, square);
    fmpq_poly_set_coeff_fmpq(p, 2, c);
    fmpq_mul(c, square, f->C2);
    fmpq_mul_si(c, c, 3);
    fmpq_poly_set_coeff_fmpq(p, 1, c);
    fmpq_mul_si(c, square, -9);
    fmpq_add(c, c, f->C1);
    fmpq_mul(c, c, square);
    fmpq_mul_si(c, c, 3);
    fmpq_poly_set_coeff_fmpq(p, 0, c);
    acb_poly_product_roots(product, f->roots, 4, prec);
    ck_assert(acb_poly_contains_fmpq_poly(product, p));
}

/* Order and accuracy as the header promises them, seen from the midpoints. */
static void check_promises(const struct fixture *f, slong prec)
{
    SCOPE(acb, conjugate);
    for (int k = 0; k < 4; k++) {
        bool paired = false;
        acb_conj(conjugate, f->roots + k);
        for (int j = 0; j < 4; j++)
            paired = paired || acb_equal(conjugate, f->roots + j);
        ck_assert(paired);
        for (int imaginary = 0; imaginary < 2; imaginary++)
            ck_assert(arb_rel_accuracy_bits(part(f->roots, k, imaginary)) >= prec);
        if (k == 3)
            continue;
        int re = arf_cmp(arb_midref(part(f->roots, k, false)), arb_midref(part(f->roots, k + 1, false)));
        int im = arf_cmp(arb_midref(part(f->roots, k, true)), arb_midref(part(f->roots, k + 1, true)));
        ck_assert(re < 0 || (re == 0 && im <= 0));
    }
}

/* A zero part is an exact zero, for no decimal of an enclosure around zero can be decided; what is rational is told to be. */
EACH(eq41_exact_cases_have_the_coefficients_and_exact_parts, COUNT(exact))
{
    OWNED(fixture) f;
    SCOPE(fmpq, value, expected);
    open_fixture(&f, exact[_i].Omega, exact[_i].C1, exact[_i].C2);
    for (slong prec = 2; prec < 3000; prec *= 5) {
        ck_assert(roots41(f.roots, f.Omega, f.C1, f.C2, prec));
        check_coefficients(&f, prec + 200);
        check_promises(&f, prec);
        for (int k = 0; k < 8; k++) {
            arb_srcptr x = part(f.roots, k / 2, k % 2 == 1);
            const char *known_value = exact[_i].value[k];
            const bool zero = known_value != NULL && known_value[0] == '0';
            ck_assert_msg(arb_contains_zero(x) == zero && arb_is_zero(x) == zero, "part %d", k);
            if (prec > 2)
                continue;
            const bool rational = roots41_rational(value, k / 2, k % 2 == 1, f.Omega, f.C1, f.C2);
            ck_assert_msg(rational == (known_value != NULL), "part %d", k);
            ck_assert_msg(!rational || (fmpq_set_str(expected, known_value, 10) == 0 && fmpq_equal(value, expected)), "part %d", k);
        }
    }
}

/* Small fractions of every sign: real and complex roots, stable and unstable. */
TEST(eq41_grid_has_the_coefficients)
{
    OWNED(fixture) f;
    open_fixture(&f, "3/7", "0", "0");
    for (int c1 = -30; c1 <= 30; c1 += 3) {
        for (int c2 = -30; c2 <= 30; c2 += 3) {
            fmpq_set_si(f.C1, c1, 5);
            fmpq_set_si(f.C2, c2, 7);
            ck_assert(roots41(f.roots, f.Omega, f.C1, f.C2, 64));
            check_coefficients(&f, 256);
            check_promises(&f, 64);
        }
    }
    for (int rate = 0; rate >= -1; rate--) {
        fmpq_set_si(f.Omega, rate, 1);
        ck_assert(!roots41(f.roots, f.Omega, f.C1, f.C2, 64));
    }
}

/* Nearly multiple, nearly equal real parts, tiny, huge: what makes isolation hard. */
static const struct {
    const char *Omega, *C1, *C2;
} hard[] = {
    /* double pair, 10^-40 beside it */
    {"1", "120000000000000000000000000000000000000001/10000000000000000000000000000000000000000", "4"},
    {"1", "119999999999999999999999999999999999999999/10000000000000000000000000000000000000000", "4"},
    {"1", "12", "40000000000000000000000000000000000000001/10000000000000000000000000000000000000000"},
    /* double real root -1, 10^-40 beside it: two real roots, or a pair */
    {"1", "105000000000000000000000000000000000000001/10000000000000000000000000000000000000000", "7/2"},
    {"1", "104999999999999999999999999999999999999999/10000000000000000000000000000000000000000", "7/2"},
    /* a root near zero */
    {"1", "900000000000000000000000000000000000000001/100000000000000000000000000000000000000000", "2"},
    {"1", "899999999999999999999999999999999999999999/100000000000000000000000000000000000000000", "-3"},
    {"1", "10", "1/100000000000000000000000000000000000000000000000000000000000000000000000000000000"},
    /* a real root and a pair that differ by 10^-40 or so in the real part, which is about -3/10: with m the fourth root,
     * r (3 + r^2) m^2 - 6 m + 3 r (1 + r^2) = 0, c2 = -(3 r + m), c1 rounded */
    {"1", "911385103938972820202597624621962490362954645/100000000000000000000000000000000000000000000",
     "106785297919553413620309225311861080425010595/100000000000000000000000000000000000000000000"},
    {"1", "10954886824687941700886645139859704134924/1000000000000000000000000000000000000000",
     "720463893018957913240532198636358984299908499/100000000000000000000000000000000000000000000"},
    {"1", "1000000000000000000000000000000000000000000000000000000000000", "7"},
    {"1", "-1000000000000000000000000000000000000000000000000000000000000", "7"},
    {"1", "11", "1000000000000000000000000000000000000000000000000000000000000"},
    {"1/1000000000000000000000000000000", "3", "-2"},
    {"1000000000000000000000000000000", "3", "-2"},
};

EACH(eq41_hard_cases_have_the_coefficients, COUNT(hard))
{
    OWNED(fixture) f;
    open_fixture(&f, hard[_i].Omega, hard[_i].C1, hard[_i].C2);
    ck_assert(roots41(f.roots, f.Omega, f.C1, f.C2, 53));
    check_coefficients(&f, 1000);
    check_promises(&f, 53);
}

/* No double can hold these coefficients, so the iteration in double starts nothing. */
TEST(eq41_roots_beyond_the_range_of_double)
{
    OWNED(fixture) f;
    open_fixture(&f, "1", "0", "0");
    fmpz_ui_pow_ui(fmpq_numref(f.C1), 10, 400);
    fmpz_ui_pow_ui(fmpq_numref(f.C2), 10, 350);
    ck_assert(roots41(f.roots, f.Omega, f.C1, f.C2, 53));
    check_coefficients(&f, 4000);
}

/*
 * A pair and a real root, r = -3/10, whose real parts differ by less than balls are tried with: algebraic numbers tell. Of
 * (s - m)(s - r)(s^2 - 2 r s + q) the first coefficient is 3 c2, and m is as above.
 */
TEST(eq41_real_parts_that_balls_do_not_tell_apart)
{
    static const char *const lines[][2] = {
        {"r", "-3/10"}, {"m", "(6 - sqrt(36 - 12*r^2*(3 + r^2)*(1 + r^2)))/(2*r*(3 + r^2))"}, {"c2", "-3*r - m"},
        {"q", "-(3*c2 + 2*r^2*m)/(m + r)"}, {"c1", "2 + q + r*m + 2*r*(r + m)"}};
    OWNED(fixture) f;
    struct program p;
    struct machine m;
    open_fixture(&f, "1", "0", "0");
    program_init(&p);
    for (int i = 0; i < COUNT(lines); i++)
        program_name(&p, program_parse(&p, lines[i][1], NULL), lines[i][0]);
    machine_init(&m, &p, &arithmetic_ball, 4000);
    machine_run(&m);
    arf_get_fmpq(f.C1, arb_midref((arb_ptr)machine_value(&m, program_find(&p, "c1"))));
    arf_get_fmpq(f.C2, arb_midref((arb_ptr)machine_value(&m, program_find(&p, "c2"))));
    machine_clear(&m);
    program_clear(&p);
    for (int mirrored = 0; mirrored < 2; mirrored++) { /* the other pair of places; the parts' order is seen where they have bits enough */
        VECTOR(acb, roots, 4);
        ck_assert(roots41(roots, f.Omega, f.C1, f.C2, 53) && roots41(f.roots, f.Omega, f.C1, f.C2, 5000));
        check_coefficients(&f, 6000);
        check_promises(&f, 5000);
        for (int k = 0; k < 4; k++)
            ck_assert_msg(acb_contains(roots + k, f.roots + k), "%d", k);
        fmpq_neg(f.C2, f.C2);
    }
}

/* (42): all real parts negative exactly when C1 > 9 Omega^2 and C2 > 0. */
TEST(eq42_tells_the_sign_of_the_greatest_real_part)
{
    OWNED(fixture) f;
    open_fixture(&f, "1/3", "0", "0");
    for (int c1 = -1; c1 <= 1; c1++) {
        for (int c2 = -1; c2 <= 1; c2++) {
            fmpq_set_si(f.C1, 1000000 + c1, 1000000); /* 9 Omega^2 = 1 */
            fmpq_set_si(f.C2, c2, 1000000);
            ck_assert(roots41(f.roots, f.Omega, f.C1, f.C2, 64));
            int stable = 1;
            for (int k = 0; k < 4; k++)
                stable = stable && arb_is_negative(part(f.roots, k, false));
            ck_assert_int_eq(stable, c1 > 0 && c2 > 0);
        }
    }
}

/*
 * Near C1 = 17, C2 = 6 both pairs have nearly one imaginary part. With a root at -0.236090695597
 * + 1.532144487233 i exactly, the other pair's differs by 1.1e-11.
 */
TEST(eq41_rational_part_is_not_taken_for_its_neighbour)
{
    OWNED(fixture) f;
    SCOPE(fmpq, value);
    open_fixture(&f, "1",
                 "2178187514374146658552225676244405744032183114752112835750523001723681549/"
                 "128128677316210747462701217412660291605389819900500000000000000000000000",
                 "768772063898015500985432866463067393678754684829303196656197/"
                 "128128677316210747462701217412660291605389819900500000000000");
    int rational = 0;
    for (int k = 0; k < 4; k++)
        rational += roots41_rational(value, k, true, f.Omega, f.C1, f.C2);
    ck_assert_int_eq(rational, 2);
}

/* (P1) Each enclosure holds the root of every polynomial in the balls: here of the one with exact gains. It is as thin as they are. */
TEST(eq41_gains_enclose_exact_roots)
{
    OWNED(fixture) f;
    VECTOR(acb, roots, 4);
    SCOPE(arb, c1, c2);
    open_fixture(&f, "1", "3", "1");
    ck_assert(roots41(f.roots, f.Omega, f.C1, f.C2, 300));
    for (int wide = 0; wide < 2; wide++) {
        arb_set_ui(c1, 3);
        arb_set_ui(c2, 1);
        mag_set_d(arb_radref(c1), wide ? 1e-4 : 0);
        mag_set_d(arb_radref(c2), wide ? 1e-4 : 0);
        ck_assert(roots41_gains(roots, c1, c2, 160));
        for (int k = 0; k < 4; k++)
            ck_assert(acb_contains(roots + k, f.roots + k) && acb_rel_accuracy_bits(roots + k) > (wide ? 8 : 140)); /* less a few */
    }
}

/* (P1) where a gain or the rate is no binary fraction. */
TEST(eq41_enclosures_hold_what_more_bits_tell)
{
    static const char *const thirds[] = {"1/3", "2/3", "10/3", "22/7", "1/11", "17/9", "-5/7", "8/13", "31/30", "100/99"};
    for (int i = 0; i < 4*COUNT(thirds); i++)
        for (slong prec = 20; prec < 90; prec += 23) {
            OWNED(fixture) f;
            VECTOR(acb, roots, 4);
            open_fixture(&f, i % 4 == 2 ? thirds[i / 4] : "1", i % 4 == 1 ? thirds[i / 4] : "12", i % 4 == 0 ? thirds[i / 4] : i % 4 == 3 ? "7" : "3");
            if (i % 4 == 2)
                fmpq_abs(f.Omega, f.Omega);
            ck_assert(roots41(roots, f.Omega, f.C1, f.C2, prec));
            ck_assert(roots41(f.roots, f.Omega, f.C1, f.C2, 400));
            for (int k = 0; k < 4; k++)
                ck_assert_msg(acb_contains(roots + k, f.roots + k), "%s, %ld bits, root %d", thirds[i / 4], (long)prec, k);
        }
}

static const struct {
    double c1, c1_radius, c2, c2_radius;
} undecided[] = {
    {10, 5, 2, 2},     /* too wide */
    {12, 0, 4, 0},     /* double pairs */
    {10.5, 0, 3.5, 0}, /* a double real root */
    {12, 0, 0, 1e-30}, /* real parts of either order */
    /* a pair with the real part of a real root, which may be before or after it: the last places, and the first (mpmath, findroot) */
    {10.0519599077040376, 1e-9, 3, 0},
    {10.6994878915544475, 1e-9, 4, 0},
    {10.8792507083087411, 1e-9, 5, 0},
    {10.9288405448506025, 1e-9, 6, 0},
    {10.0519599077040376, 1e-9, -3, 0},
    {10.8792507083087411, 1e-9, -5, 0},
    {NAN, 0, 2, 0},
};

/* (P1), (P3) */
EACH(eq41_gains_that_do_not_decide_are_refused, COUNT(undecided))
{
    VECTOR(acb, roots, 4);
    SCOPE(arb, c1, c2);
    arb_set_d(c1, undecided[_i].c1);
    arb_set_d(c2, undecided[_i].c2);
    mag_set_d(arb_radref(c1), undecided[_i].c1_radius);
    mag_set_d(arb_radref(c2), undecided[_i].c2_radius);
    ck_assert(!roots41_gains(roots, c1, c2, 128));
}

/* Enclosures as squares: centre and half a side. Whether the roots in them may be told real or conjugate. */
static const struct {
    double re[4], im[4], radius;
    bool told;
} squares[] = {
    {{-2, -1, -1, 1}, {0, -1, 1, 0}, 0.375, true},
    {{-2, -1, -1, 1}, {0, -1.25, 1, 0.25}, 0.375, true},       /* they need not be mirror images */
    {{-2, -1, -1, 1}, {0, -0.25, 0.625, 0}, 0.375, false},     /* one touches the axis, and its conjugate may be below */
    {{-2, -1, -1, 1}, {0, -3, 1, 0}, 0.375, false},            /* a conjugate is nowhere */
    {{-2, -1, -1, -1.25}, {0, -0.75, 1, -1.75}, 0.375, false}, /* it may be in either of two */
};

/* (P2) */
EACH(eq41_enclosures_are_paired_where_that_is_certain, COUNT(squares))
{
    VECTOR(acb, roots, 4);
    for (int k = 0; k < 4; k++) {
        acb_set_d_d(roots + k, squares[_i].re[k], squares[_i].im[k]);
        mag_set_d(arb_radref(acb_realref(roots + k)), squares[_i].radius);
        mag_set_d(arb_radref(acb_imagref(roots + k)), squares[_i].radius);
    }
    ck_assert_int_eq(roots41_conjugates(roots), squares[_i].told);
}
