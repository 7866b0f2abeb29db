/*
 * Numbers as text. The expected values come from hexadecimal constants of the compiler, from libc's
 * strtod, from python3 (the expression stands beside the value) and from the definition of
 * rounding.
 */
#include <check.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "tests/run.h"
#include "text/decimal.h"
#include "text/scope.h"

/* xorshift64 (Marsaglia 2003, J. Stat. Soft. 8(14)): the same doubles everywhere. */
static uint64_t next_random(uint64_t *state)
{
    *state ^= *state << 13;
    *state ^= *state >> 7;
    *state ^= *state << 17;
    return *state;
}

/* A finite double of any sign and exponent. */
static double random_double(uint64_t *state)
{
    double x;
    do {
        uint64_t bits = next_random(state);
        memcpy(&x, &bits, sizeof x);
    } while (!isfinite(x));
    return x;
}

/* The double that a literal means; NaN unless it is finite and fits a double exactly. */
static double read_double(const char *text)
{
    SCOPE(fmpq, value);
    SCOPE(arf, x);
    double result = NAN;
    if (literal_read(value, text, false) == LITERAL_FINITE &&
        arf_set_fmpq(x, value, 53, ARF_RND_DOWN) == 0) /* 53: DBL_MANT_DIG; 0: nothing was lost */
        result = arf_get_d(x, ARF_RND_DOWN);
    return result;
}

static const struct {
    const char *text;
    double value;
} nearest_double[] = {
    {"0", 0.0},
    {"-0", 0.0},
    {"+1.5", 0x1.8p0},
    {".5", 0x1p-1},
    {"5.", 0x1.4p2},
    {"1e3", 0x1.f4p9},
    {"1E+03", 0x1.f4p9},
    {"0.1", 0x1.999999999999ap-4}, /* float.hex(0.1) */
    {"-8.99e9", -8.99e9},
    {"9007199254740993", 0x1p53},               /* 2^53 + 1: a tie, the even one is below */
    {"9007199254740995", 0x1.0000000000002p53}, /* 2^53 + 3: a tie, the even one is above */
    {"9007199254740993.0000000000000000000000000000000000000001", 0x1.0000000000001p53},
    {"0x1.8", 0x1.8p0},
    {"0X.8P1", 0x1p0},
    {"-0xAp-1", -0x1.4p2},
    {"0x1.00000000000008p0", 0x1p0}, /* 1 + 2^-53: a tie */
    {"0x1.000000000000080001p0", 0x1.0000000000001p0},
    {"0x1p-1075", 0.0},         /* half of the least subnormal: a tie */
    {"0x1.8p-1074", 0x1p-1073}, /* one and a half: a tie */
    {"0x1.0000001p-1075", 0x1p-1074},
    {"2.4703282292062327208e-324", 0.0}, /* Decimal(2)**-1075 = 2.47032822920623272088e-324 */
    {"2.4703282292062327209e-324", 0x1p-1074},
    {"2.2250738585072011e-308", 0x0.fffffffffffffp-1022}, /* float.hex(2.2250738585072011e-308) */
    {"1.7976931348623158e308", 0x1.fffffffffffffp1023},
    {"0x1.fffffffffffff7ffp1023", 0x1.fffffffffffffp1023},
    {"1e-400", 0.0},
    {"-1e-99999999999999999999", 0.0},
    {"0e99999999999999999999", 0.0},
    {"0x0p99999999999999999999", 0.0},
};

EACH(literal_means_the_nearest_double, COUNT(nearest_double))
{
    ck_assert_msg(read_double(nearest_double[_i].text) == nearest_double[_i].value, "%s is %a",
                  nearest_double[_i].text, read_double(nearest_double[_i].text));
}

static const struct {
    const char *text;
    enum literal kind, exact_kind;
} kinds[] = {
    {"", LITERAL_MALFORMED, LITERAL_MALFORMED},
    {"-.", LITERAL_MALFORMED, LITERAL_MALFORMED},
    {"1 ", LITERAL_MALFORMED, LITERAL_MALFORMED},
    {" 1", LITERAL_MALFORMED, LITERAL_MALFORMED},
    {"nan(1)", LITERAL_MALFORMED, LITERAL_MALFORMED},
    {"1,5", LITERAL_MALFORMED, LITERAL_MALFORMED},
    {"1e", LITERAL_MALFORMED, LITERAL_MALFORMED},
    {"12a", LITERAL_MALFORMED, LITERAL_MALFORMED},
    {"0x", LITERAL_MALFORMED, LITERAL_MALFORMED},
    {"0x1p", LITERAL_MALFORMED, LITERAL_MALFORMED},
    {"0x-1", LITERAL_MALFORMED, LITERAL_MALFORMED},
    {"infinite", LITERAL_MALFORMED, LITERAL_MALFORMED},
    {"1e400 ", LITERAL_MALFORMED, LITERAL_MALFORMED},
    {"nan", LITERAL_NAN, LITERAL_NAN},
    {"-NaN", LITERAL_NAN, LITERAL_NAN},
    {"inf", LITERAL_INFINITE, LITERAL_INFINITE},
    {"+Inf", LITERAL_INFINITE, LITERAL_INFINITE},
    {"INFINITY", LITERAL_INFINITE, LITERAL_INFINITE},
    {"-inf", LITERAL_NEGATIVE_INFINITE, LITERAL_NEGATIVE_INFINITE},
    {"1e400", LITERAL_OVERFLOW, LITERAL_FINITE},
    {"1.797693134862315808e308", LITERAL_OVERFLOW, LITERAL_FINITE}, /* above 2^1024 - 2^970 */
    {"0x1.fffffffffffff8p1023", LITERAL_OVERFLOW, LITERAL_FINITE},  /* that tie itself     */
    {"0x1p1024", LITERAL_OVERFLOW, LITERAL_FINITE},
    {"0x1p99999999", LITERAL_OVERFLOW, LITERAL_OVERFLOW},
    {"1e-5000", LITERAL_FINITE, LITERAL_FINITE},
    {"1e-5001", LITERAL_FINITE, LITERAL_OVERFLOW},
    {"-1e5001", LITERAL_OVERFLOW, LITERAL_OVERFLOW},
    {"1e99999999999999999999", LITERAL_OVERFLOW, LITERAL_OVERFLOW},
    {"0e99999999999999999999", LITERAL_FINITE, LITERAL_FINITE},
};

EACH(literal_kind_is_told, COUNT(kinds))
{
    SCOPE(fmpq, value);
    ck_assert_int_eq(literal_read(value, kinds[_i].text, false), kinds[_i].kind);
    ck_assert_int_eq(literal_read(value, kinds[_i].text, true), kinds[_i].exact_kind);
}

static const struct {
    const char *text;
    slong p;
    ulong q;
} exact_values[] = {
    {"0.1", 1, 10},        {"-1.25e1", -25, 2}, {"7.2915e-05", 14583, 200000000},
    {"0x1.8p-2", 3, 8},    {"-0xff", -255, 1},  {"000.500e0", 1, 2},
    {"0.0000001e7", 1, 1}, {"0x0.01p8", 1, 1},
};

EACH(exact_literal_is_its_own_value, COUNT(exact_values))
{
    SCOPE(fmpq, value, expected);
    fmpq_set_si(expected, exact_values[_i].p, exact_values[_i].q);
    literal_read(value, exact_values[_i].text, true);
    ck_assert(fmpq_equal(value, expected));
}

TEST(exact_literal_of_giant_length_is_refused)
{
    static char text[20000];
    SCOPE(fmpq, value);
    memset(text, '0', sizeof text - 1);
    text[0] = '1';
    ck_assert_int_eq(literal_read(value, text, true), LITERAL_OVERFLOW);
    text[1] = '.';
    text[sizeof text - 2] = '1';
    ck_assert_int_eq(literal_read(value, text, true), LITERAL_OVERFLOW);
    ck_assert_int_eq(literal_read(value, text, false), LITERAL_FINITE);
    ck_assert(fmpq_is_one(value));
    text[0] = '0';
    ck_assert_int_eq(literal_read(value, text, true), LITERAL_OVERFLOW);
}

/* A significand of 40,000 bits is read, and none of one more; 10,000 decimals, and not one more. */
TEST(exact_literal_of_the_greatest_length_is_read)
{
    static char text[10004];
    SCOPE(fmpq, value);
    memset(text, 'f', sizeof text - 1);
    memcpy(text, "0x1", 3);
    ck_assert_int_eq(literal_read(value, text, true), LITERAL_OVERFLOW);
    text[2] = '0';
    ck_assert_int_eq(literal_read(value, text, true), LITERAL_FINITE);
    ck_assert_uint_eq(fmpz_bits(fmpq_numref(value)), 40000);
    memset(text, '0', sizeof text - 1);
    text[1] = '.';
    text[sizeof text - 2] = '1';
    ck_assert_int_eq(literal_read(value, text, true), LITERAL_OVERFLOW);
    text[10001] = '1';
    text[10002] = '\0';
    ck_assert_int_eq(literal_read(value, text, true), LITERAL_FINITE);
}

/* 1.000...0001 with 4,999 zeros lies above the tie at 1 + 2^-53 only through its last digit. */
TEST(literal_of_thousands_of_digits_is_not_cut)
{
    static const char tie[] =
        "1.00000000000000011102230246251565404236316680908203125"; /* 1 + 2^-53 */
    char text[5100];
    memset(text, '0', sizeof text);
    memcpy(text, tie, sizeof tie - 1);
    text[sizeof text - 2] = '1';
    text[sizeof text - 1] = '\0';
    ck_assert(read_double(tie) == 1.0);
    ck_assert(read_double(text) == 0x1.0000000000001p0);
}

static const struct {
    slong p;
    ulong q;
    slong digits;
    const char *text;
} rationals[] = {
    {0, 1, 40, "0"},
    {1, 1, 1, "1e+00"},
    {1, 2, 1, "5e-01"},
    {1, 1, 5, "1.0000e+00"},
    {-1, 3, 40, "-3.333333333333333333333333333333333333333e-01"},
    {2, 3, 40, "6.666666666666666666666666666666666666667e-01"},
    {1, 8, 2, "1.2e-01"}, /* 0.125: a tie, to even */
    {3, 8, 2, "3.8e-01"}, /* 0.375: a tie, to even */
    {-25, 10, 1, "-2e+00"},
    {35, 10, 1, "4e+00"},
    {95, 10, 1, "1e+01"}, /* a tie, over the power of ten */
    {85, 10, 1, "8e+00"},
    {99994, 10000, 4, "9.999e+00"},
    {99995, 10000, 4, "1.000e+01"},
    {999949999, 100000, 5, "9.9995e+03"},
    {123456789, 1, 9, "1.23456789e+08"},
};

EACH(rational_rounds_to_nearest_even, COUNT(rationals))
{
    SCOPE(fmpq, x);
    fmpq_set_si(x, rationals[_i].p, rationals[_i].q);
    char *text = decimal_of_rational(x, rationals[_i].digits);
    ck_assert_str_eq(text, rationals[_i].text);
    free(text);
}

/* The exponent's first guess errs, if at all, at powers of ten. */
TEST(rational_power_of_ten_is_written_as_such)
{
    SCOPE(fmpq, x);
    for (int k = -400; k <= 400; k++) {
        char literal[16], expected[32];
        snprintf(literal, sizeof literal, "1e%d", k);
        snprintf(expected, sizeof expected, "1.00e%+03d", k);
        ck_assert_int_eq(literal_read(x, literal, true), LITERAL_FINITE);
        char *text = decimal_of_rational(x, 3);
        ck_assert_str_eq(text, expected);
        free(text);
    }
}

/* 1/7 repeats 142857: digit 10,000 is an 8, and 5 comes next. */
TEST(rational_gives_ten_thousand_digits)
{
    char expected[10006] = "1.";
    for (int k = 1; k < 9999; k++)
        expected[k + 1] = "142857"[k % 6];
    snprintf(expected + 10000, 6, "9e-01");
    SCOPE(fmpq, x);
    fmpq_set_si(x, 1, 7);
    char *text = decimal_of_rational(x, 10000);
    ck_assert_str_eq(text, expected);
    free(text);
}

/* The definition: so many digits, and no further than half a unit of the last from x. */
TEST(rational_text_is_within_half_a_unit)
{
    uint64_t state = 2;
    SCOPE(fmpq, x, y, unit);
    for (int k = 0; k < 500; k++) {
        fmpq_set_si(x, (slong)(next_random(&state) >> 1), (next_random(&state) >> (k % 64)) | 1);
        slong digits = 2 + k % 30;
        char *text = decimal_of_rational(x, digits), literal[32];
        ck_assert_int_eq(strcspn(text, "e"), digits + 1);
        snprintf(literal, sizeof literal, "1e%ld", atol(strchr(text, 'e') + 1) - digits + 1);
        ck_assert_int_eq(literal_read(y, text, true), LITERAL_FINITE);
        ck_assert_int_eq(literal_read(unit, literal, true), LITERAL_FINITE);
        fmpq_sub(y, y, x);
        fmpq_abs(y, y);
        fmpq_mul_2exp(y, y, 1);
        ck_assert_msg(fmpq_cmp(y, unit) <= 0, "%s", text);
        free(text);
    }
}

/* mpmath.mp.dps = 60; mpmath.nstr(mpmath.pi, 40), and so on. */
TEST(ball_of_pi_is_rounded)
{
    SCOPE(arb, x);
    arb_const_pi(x, 160);
    char *text = decimal_of_ball(x, 40);
    ck_assert_pstr_eq(text, "3.141592653589793238462643383279502884197e+00");
    free(text);
    arb_neg(x, x);
    text = decimal_of_ball(x, 30);
    ck_assert_pstr_eq(text, "-3.14159265358979323846264338328e+00");
    free(text);
}

/* Ball [low, high] / 100 as integers; NULL where two numbers in it round differently. */
static const struct {
    slong low, high, digits;
    const char *text;
} balls[] = {
    {1020, 1040, 1, "1e+01"},
    {940, 1040, 1, NULL},    /* 9.4 rounds to 9, 10.4 to 10 */
    {-1040, -940, 1, NULL},
    {955, 1040, 1, "1e+01"}, /* over a power of ten, and decided */
    {9995001, 10000100, 3, "1.00e+05"},
    {149, 151, 1, NULL}, /* round a tie */
    {151, 249, 1, "2e+00"},
    {-249, -151, 1, "-2e+00"},
    {-1, 1, 1, NULL},
    {0, 10, 1, NULL},
    {250, 250, 1, "2e+00"}, /* exact: ties are decided */
    {1, 100000000, 1, NULL},
    {0, 0, 7, "0"},
};

EACH(D1_a_ball_is_decided_when_all_of_it_rounds_alike, COUNT(balls))
{
    SCOPE(arb, x);
    arb_set_si(x, balls[_i].low + balls[_i].high);
    mag_set_ui_2exp_si(arb_radref(x), (ulong)(balls[_i].high - balls[_i].low), 0);
    arb_div_ui(x, x, 200, 60);
    char *text = decimal_of_ball(x, balls[_i].digits);
    ck_assert_pstr_eq(text, balls[_i].text);
    free(text);
}

/* 5/2 with a radius that no number of its bits and some more has room for: on either side of the tie. */
TEST(D2_ends_of_a_ball_are_rounded_outward)
{
    SCOPE(arb, x);
    arb_set_d(x, 2.5);
    mag_set_ui_2exp_si(arb_radref(x), 1, -1000);
    ck_assert_ptr_null(decimal_of_ball(x, 1));
    arb_neg(x, x);
    ck_assert_ptr_null(decimal_of_ball(x, 1));
    arb_one(x);
    mag_set_ui_2exp_si(arb_radref(x), 1, -1000); /* far from any tie the ends have bits enough */
    char *text = decimal_of_ball(x, 10);
    ck_assert_pstr_eq(text, "1.000000000e+00");
    free(text);
}

/* (2 j + 1)/2 10^k for whole numbers of 60 digits is exact, as are odd multiples of 2^-k. */
static void assert_tie_is_even(ulong i)
{
    SCOPE(fmpz, j, power);
    SCOPE(arb, x);
    char due[80];
    fmpz_ui_pow_ui(j, 7, 70); /* an odd number of 60 digits: j/2 is a tie */
    fmpz_add_ui(j, j, 2 * i);
    arb_set_fmpz(x, j);
    fmpz_ui_pow_ui(power, 10, i);
    arb_mul_fmpz(x, x, power, ARF_PREC_EXACT);
    arb_mul_2exp_si(x, x, -1);
    fmpz_fdiv_q_2exp(j, j, 1);
    fmpz_add_ui(j, j, fmpz_is_odd(j));
    fmpz_get_str(due, 10, j);
    char *text = decimal_of_ball(x, (slong)strlen(due));
    ck_assert_ptr_nonnull(text);
    ck_assert_int_eq(text[0], due[0]);
    ck_assert_int_eq(strncmp(text + 2, due + 1, strlen(due) - 1), 0);
    free(text);
}

TEST(D3_a_tie_is_decided_and_goes_to_the_even)
{
    for (ulong i = 0; i < 200; i++)
        assert_tie_is_even(i);
}

TEST(ball_without_a_finite_value_is_refused)
{
    SCOPE(arb, x);
    arb_pos_inf(x);
    ck_assert_ptr_null(decimal_of_ball(x, 5));
    arb_indeterminate(x);
    ck_assert_ptr_null(decimal_of_ball(x, 5));
    arb_zero_pm_inf(x);
    ck_assert_ptr_null(decimal_of_ball(x, 5));
}

/* mpmath.mp.dps = 60; mpmath.nstr(mpmath.exp(-mpmath.mpf(10)**10), 20) */
TEST(ball_of_tiny_value_has_its_exponent)
{
    SCOPE(arb, x);
    arb_set_si(x, -10000000000);
    arb_exp(x, x, 128);
    char *text = decimal_of_ball(x, 20);
    ck_assert_pstr_eq(text, "9.2785844203248725781e-4342944820");
    free(text);
}

/* 146964308 log10(2) is 44240665 - 4e-10, which a product of doubles makes 44240665. mpmath.mp.dps = 60; mpmath.mpf(2)**146964308 */
TEST(ball_of_a_power_of_two_below_one_of_ten_has_its_exponent)
{
    SCOPE(arb, x);
    arb_set_ui(x, 1);
    arb_mul_2exp_si(x, x, 146964308);
    char *text = decimal_of_ball(x, 20);
    ck_assert_pstr_eq(text, "9.9999999281501361390e+44240664");
    free(text);
}

TEST(ball_of_absurd_exponent_is_refused)
{
    SCOPE(fmpz, exponent);
    SCOPE(arb, x);
    fmpz_ui_pow_ui(exponent, 2, 60);
    arb_const_pi(x, 128);
    arb_mul_2exp_fmpz(x, x, exponent);
    ck_assert_ptr_null(decimal_of_ball(x, 5));
    arb_one(x);
    arb_mul_2exp_fmpz(x, x, exponent);
    ck_assert_ptr_null(decimal_of_ball(x, 5));
}

/* Mid and radius in 1024ths: of what is no decimal of so many digits the lower end is rounded down, the upper one up. */
EACH(an_end_is_rounded_outward, 7)
{
    static const struct {
        slong mid;
        ulong radius;
        slong digits;
        const char *lower, *upper;
    } ends[] = {{512, 0, 3, "5.00e-01", "5.00e-01"}, {1, 0, 3, "9.76e-04", "9.77e-04"}, {-1, 0, 3, "-9.77e-04", "-9.76e-04"},
                {1024, 1, 2, "9.9e-01", "1.1e+00"},  {0, 128, 2, "-1.3e-01", "1.3e-01"}, {1, 1, 4, "0", "1.954e-03"}, {-1, 1, 4, "-1.954e-03", "0"}};
    SCOPE(arb, x);
    arb_set_si(x, ends[_i].mid);
    mag_set_ui_2exp_si(arb_radref(x), ends[_i].radius, 0);
    arb_mul_2exp_si(x, x, -10);
    char *lower = decimal_of_end(x, ends[_i].digits, false), *upper = decimal_of_end(x, ends[_i].digits, true);
    ck_assert_str_eq(lower, ends[_i].lower);
    ck_assert_str_eq(upper, ends[_i].upper);
    free(lower);
    free(upper);
}

/* python3: repr(x), without its trailing ".0" */
static const struct {
    double x;
    const char *text;
} shortest[] = {
    {0.0, "0"},
    {-0.0, "-0"},
    {100.0, "100"},
    {-150.0, "-150"},
    {0.01, "0.01"},
    {0.1, "0.1"},
    {7.2915e-05, "7.2915e-05"},
    {-1.5e+20, "-1.5e+20"},
    {1e-4, "0.0001"},
    {1e-5, "1e-05"},
    {0.00010298990313487996, "1.0298990313487996e-04"}, /* 21 digits with its zeros, of which simple readers take 17 */
    {0.012345678901234567, "1.2345678901234567e-02"},
    {-0.012345678901234, "-0.012345678901234"},
    {0.012345678901234501, "0.0123456789012345"},
    {8.99e9, "8990000000"},
    {1e15, "1000000000000000"},
    {1e16, "1e+16"},
    {1e22, "1e+22"},
    {1e23, "1e+23"},
    {12345678901234568.0, "1.2345678901234568e+16"},
    {20000000000000012.0, "2.0000000000000012e+16"}, /* odd: 20000000000000010, halfway to the even number below, reads as that */
    {20000000000000028.0, "2.0000000000000028e+16"},
    {123456789012345678.0, "1.2345678901234568e+17"},
    {1234567890123456789.0, "1.2345678901234568e+18"},
    {1.0 / 3.0, "0.3333333333333333"},
    {-1234.5678, "-1234.5678"},
    {1000000000000000.25, "1000000000000000.2"}, /* two of 16 digits are as near: the even one */
    {1000000000000000.75, "1000000000000000.8"},
    {0x1p-44, "5.684341886080802e-14"}, /* not the nearest of 16 digits, which does not read back */
    {0x1p-1074, "5e-324"},
    {0x1p-1067, "6.3e-322"}, /* subnormal: as far from the number below as from the one above */
    {0x1p-1025, "2.781342323134e-309"},
    {0x1p-1022, "2.2250738585072014e-308"},
    {0x1.fffffffffffffp1023, "1.7976931348623157e+308"},
    {INFINITY, "inf"},
    {-INFINITY, "-inf"},
    {NAN, "nan"},
    {-NAN, "nan"},
};

EACH(shortest_decimal_is_known, COUNT(shortest))
{
    char text[32];
    decimal_shortest(text, shortest[_i].x);
    ck_assert_str_eq(text, shortest[_i].text);
}

/* Other road: libc's strtod reads it back, and no number of libc's with a digit less does so. */
TEST(shortest_decimal_reads_back_and_none_shorter)
{
    uint64_t state = 3;
    for (int k = 0; k < 2000; k++) {
        char text[32], shorter[32];
        double x = random_double(&state);
        decimal_shortest(text, x);
        ck_assert_msg(strtod(text, NULL) == x, "%s", text);
        int digits = (int)strcspn(text, "e") - (*text == '-') - (strchr(text, '.') != NULL);
        if (digits < 2 || strchr(text, 'e') == NULL) /* 100 has three digits and needs one */
            continue;
        snprintf(shorter, sizeof shorter, "%.*e", digits - 2, x);
        ck_assert_msg(strtod(shorter, NULL) != x, "%s", text);
    }
}

static const struct {
    double x;
    const char *text;
} bounds[] = {
    {0.0, "0"},
    {1.0, "1.0e+00"},
    {0.5, "5.0e-01"},
    {0.0625, "6.3e-02"},
    {0.99609375, "1.0e+00"},
    {5.0, "5.0e+00"},
    {101.0, "1.1e+02"},
    {100.0, "1.0e+02"},
    {0x1p-53, "1.2e-16"},     /* 1.11e-16 */
    {0x1p1000, "1.1e+301"},   /* 1.07150860718626732e301: Decimal(2)**1000 */
    {0x1p-1074, "5.0e-324"},  /* 4.94e-324 */
    {INFINITY, "inf"},
};

EACH(bound_is_rounded_up, COUNT(bounds))
{
    char text[32];
    decimal_bound(text, bounds[_i].x);
    ck_assert_str_eq(text, bounds[_i].text);
}
