/*
 * Numbers as text. Rationals go through exact integers, balls through MPFR, which rounds correctly; strtod does, too. No
 * locale but C's takes part: the program sets none.
 */
#include "text/decimal.h"

#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "text/message.h"
#include "text/scope.h"

/* Of an exact literal, beyond binary128's 10^+-4966: there certified roots still take but a second. */
static const slong LARGEST_EXPONENT = 5000, MOST_DIGITS = 10000;
static const slong MANTISSA_BITS = DBL_MANT_DIG; /* 53: a binary64's significand */

/* n = p/q rounded to the nearest integer, ties to even; p >= 0, q > 0. */
static void nearest(fmpz_t n, const fmpz_t p, const fmpz_t q)
{
    SCOPE(fmpz, remainder);
    fmpz_fdiv_qr(n, remainder, p, q);
    fmpz_mul_2exp(remainder, remainder, 1);
    int half = fmpz_cmp(remainder, q);
    if (half > 0 || (half == 0 && fmpz_is_odd(n)))
        fmpz_add_ui(n, n, 1);
}

/* p/q = |x| 10^k */
static void scale_decimal(fmpz_t p, fmpz_t q, const fmpq_t x, slong k)
{
    SCOPE(fmpz, power);
    fmpz_ui_pow_ui(power, 10, k < 0 ? -(ulong)k : (ulong)k);
    fmpz_abs(p, fmpq_numref(x));
    fmpz_set(q, fmpq_denref(x));
    if (k < 0)
        fmpz_mul(q, q, power);
    else
        fmpz_mul(p, p, power);
}

/* ---- reading ---------------------------------------------------------- */

/* The literal's own value; strtod() has found it well formed and finite in syntax. False where it is too large to be told. */
static bool own_value(fmpq_t value, const char *text)
{
    const bool negative = *text == '-';
    text += *text == '-' || *text == '+';
    const bool hexadecimal = text[0] == '0' && (text[1] | 0x20) == 'x';
    text += hexadecimal ? 2 : 0;
    const size_t length = strcspn(text, hexadecimal ? "pP" : "eE");
    slong exponent = text[length] != '\0' ? strtol(text + length + 1, NULL, 10) : 0, fraction = 0; /* saturated far outside */
    char *digits = xrealloc(NULL, length + 1, 1);
    size_t count = 0;
    SCOPE(fmpz, mantissa, power);
    for (size_t i = 0; i < length; i++)
        if (text[i] != '.')
            digits[count++] = text[i];
    digits[count] = '\0';
    if (count < length)
        fraction = (slong)(length - 1 - strcspn(text, "."));
    fmpz_set_str(mantissa, digits, hexadecimal ? 16 : 10);
    free(digits);
    const bool giant = exponent < -LARGEST_EXPONENT || exponent > LARGEST_EXPONENT || fraction > MOST_DIGITS ||
                       (slong)fmpz_bits(mantissa) > 4 * MOST_DIGITS;
    if (fmpz_is_zero(mantissa))
        fmpq_zero(value);
    if (fmpz_is_zero(mantissa) || giant)
        return fmpz_is_zero(mantissa);
    exponent -= hexadecimal ? 4 * fraction : fraction;
    fmpz_ui_pow_ui(power, hexadecimal ? 2 : 10, (ulong)labs(exponent));
    if (negative)
        fmpz_neg(mantissa, mantissa);
    if (exponent < 0) {
        fmpq_set_fmpz_frac(value, mantissa, power);
    } else {
        fmpz_mul(mantissa, mantissa, power);
        fmpq_set_fmpz(value, mantissa);
    }
    return true;
}

enum literal literal_read(fmpq_t value, const char *text, bool exact)
{
    char *end;
    const double nearest = strtod(text, &end);
    if (end == text || *end != '\0' || strpbrk(text, " \t\n\v\f\r(") != NULL) /* strtod() skips blanks, and takes nan(...) */
        return LITERAL_MALFORMED;
    if (isnan(nearest))
        return LITERAL_NAN;
    if (strpbrk(text, "iI") != NULL)
        return nearest < 0 ? LITERAL_NEGATIVE_INFINITE : LITERAL_INFINITE;
    if (exact)
        return own_value(value, text) ? LITERAL_FINITE : LITERAL_OVERFLOW;
    if (isinf(nearest))
        return LITERAL_OVERFLOW;
    SCOPE(arf, x);
    arf_set_d(x, nearest);
    arf_get_fmpq(value, x);
    return LITERAL_FINITE;
}

/* ---- writing ---------------------------------------------------------- */

/* What a number needs beside its digits: -, ., e, an exponent's sign and 19 digits, the end. */
enum { BESIDE_DIGITS = 24 };

/* d.ddde-XX from the digits and the exponent of the first. */
static void write_scientific(char *text, const char *digits, slong exponent)
{
    const size_t more = strlen(digits + 1);
    *text++ = *digits;
    if (more > 0)
        *text++ = '.';
    memcpy(text, digits + 1, more);
    snprintf(text + more, BESIDE_DIGITS - 2, "e%c%02ld", exponent < 0 ? '-' : '+', labs(exponent));
}

/* The same with a sign, from their integer. */
static char *scientific(bool negative, const fmpz_t digits, slong exponent)
{
    char *significand = fmpz_get_str(NULL, 10, digits);
    char *text = xrealloc(NULL, strlen(significand) + BESIDE_DIGITS, 1);
    text[0] = '-';
    write_scientific(text + negative, significand, exponent);
    flint_free(significand);
    return text;
}

/*
 * A lower bound on floor(log10(x)), nearly always equal to it, for x = mantissa 2^exponent, x > 0,
 * |exponent| < 2^50. The margin covers the rounding of three operations in double.
 */
static slong decimal_exponent(double mantissa, slong exponent)
{
    const double log10_2 = 0.30102999566398119521; /* OEIS A007524 */
    double margin = 1e-6 + fabs((double)exponent) * DBL_EPSILON;
    return (slong)floor(log10(mantissa) + (double)exponent * log10_2 - margin);
}

/* |x|, x not zero, to so many digits: their integer, and the exponent of the first. */
static slong leading_digits(fmpz_t n, const fmpq_t x, slong digits)
{
    SCOPE(fmpz, p, q, limit);
    fmpz_ui_pow_ui(limit, 10, (ulong)digits);
    slong top, bottom;
    double above = fmpz_get_d_2exp(&top, fmpq_numref(x));
    double below = fmpz_get_d_2exp(&bottom, fmpq_denref(x));
    slong exponent = decimal_exponent(fabs(above / below), top - bottom);
    for (;; exponent++) {
        scale_decimal(p, q, x, digits - 1 - exponent);
        nearest(n, p, q);
        /* A digit too many: the exponent was too low, or the value rounds to the next power of ten.
         */
        if (fmpz_cmp(n, limit) < 0)
            break;
    }
    return exponent;
}

char *decimal_of_rational(const fmpq_t x, slong digits)
{
    if (fmpq_is_zero(x))
        return text_copy("0");
    SCOPE(fmpz, n);
    slong exponent = leading_digits(n, x, digits);
    return scientific(fmpq_sgn(x) < 0, n, exponent);
}

/* The text of a number other than zero, rounded to nearest, ties to even. */
static char *decimal_of_mpfr(const mpfr_t x, slong digits)
{
    mpfr_exp_t exponent;
    char *significand = mpfr_get_str(NULL, &exponent, 10, (size_t)digits, x, MPFR_RNDN);
    const bool negative = *significand == '-';
    char *text = xrealloc(NULL, (size_t)digits + BESIDE_DIGITS, 1);
    text[0] = '-';
    write_scientific(text + negative, significand + negative, exponent - 1);
    mpfr_free_str(significand);
    return text;
}

/* What both ends round to, all between them rounds to. */
char *decimal_of_ball(const arb_t x, slong digits)
{
    if (arb_is_zero(x))
        return text_copy("0");
    if (!arb_is_finite(x) || arb_contains_zero(x) || fmpz_bits(ARF_EXPREF(arb_midref(x))) > FLINT_BITS - 14)
        return NULL; /* MPFR's exponents end at 2^62, at 2^30 where a word has 32 bits */
    const slong prec = FLINT_MAX(arf_bits(arb_midref(x)), 4 * digits) + 64; /* 4 > log2(10), and guard bits */
    const mpfr_exp_t least = mpfr_get_emin(), most = mpfr_get_emax();
    mpfr_t low, high;
    mpfr_set_emin(mpfr_get_emin_min());
    mpfr_set_emax(mpfr_get_emax_max());
    mpfr_init2(low, prec);
    mpfr_init2(high, prec);
    arb_get_interval_mpfr(low, high, x);
    char *text = decimal_of_mpfr(low, digits), *other = decimal_of_mpfr(high, digits);
    if (strcmp(text, other) != 0) {
        free(text);
        text = NULL;
    }
    free(other);
    mpfr_clear(low);
    mpfr_clear(high);
    mpfr_set_emin(least);
    mpfr_set_emax(most);
    return text;
}

/* x > 0 to so many digits, without a point; returns the exponent of the first. C's library rounds to nearest. */
static slong nearest_digits(char digits[24], double x, size_t count)
{
    char text[40];
    snprintf(text, sizeof text, "%.*e", (int)count - 1, x);
    const size_t point = count > 1;
    digits[0] = text[0];
    memcpy(digits + 1, text + 1 + point, count - 1);
    digits[count] = '\0';
    return strtol(text + count + point + 1, NULL, 10);
}

/* The same, rounded up. */
static slong digits_above(char digits[24], double x, size_t count)
{
    mpfr_exp_t exponent;
    mpfr_t y;
    mpfr_init2(y, MANTISSA_BITS);
    mpfr_set_d(y, x, MPFR_RNDN);
    mpfr_get_str(digits, &exponent, 10, count, y, MPFR_RNDU);
    mpfr_clear(y);
    return exponent - 1;
}

static bool reads_back(const char *digits, slong exponent, double x)
{
    char text[40];
    snprintf(text, sizeof text, "%se%ld", digits, exponent + 1 - (long)strlen(digits));
    const double y = strtod(text, NULL);
    return !(y < x) && !(y > x);
}

/*
 * The fewest digits that read back as x, the nearest of them. What reads back as a power of two reaches twice as far
 * above it as below: there the next decimal above may do where the nearest does not. Of a normal number no decimal of
 * fewer than DBL_DIG = 15 digits is lost on the way, so that it stands in the 15 digits, zeros after it.
 */
static slong shortest_digits(char digits[24], double x)
{
    int binary_exponent;
    const int ways = frexp(x, &binary_exponent) > 0.5 ? 1 : 2; /* of a power of two the next above is tried too */
    for (size_t count = x < DBL_MIN ? 1 : DBL_DIG;; count++)
        for (int above = 0; above < ways; above++) {
            const slong exponent = (above ? digits_above : nearest_digits)(digits, x, count);
            if (!reads_back(digits, exponent, x))
                continue;
            while (count > 1 && digits[count - 1] == '0')
                digits[--count] = '\0';
            return exponent;
        }
}

void decimal_shortest(char text[32], double x)
{
    const size_t room = 31; /* after a sign; 23 are used by -1.2345678901234567e-308 */
    if (signbit(x) && !isnan(x))
        *text++ = '-';
    x = fabs(x);
    if (!isfinite(x) || !(x > 0)) {
        snprintf(text, room, "%s", isnan(x) ? "nan" : x > 0 ? "inf" : "0");
        return;
    }
    char digits[24] = ""; /* at most 17 */
    const int first = (int)shortest_digits(digits, x), last = first + 1 - (int)strlen(digits);
    /* Simple readers take in 17 digits, zeros before the first of them too: a small number has all of its own within them. */
    const bool small = first < 0 && (first < -4 || (int)strlen(digits) - first > 17);
    if (small || first >= 16)
        write_scientific(text, digits, first);
    else if (first < 0)
        snprintf(text, room, "0.%.*s%s", -1 - first, "000", digits);
    else if (last < 0)
        snprintf(text, room, "%.*s.%s", first + 1, digits, digits + first + 1);
    else
        snprintf(text, room, "%.0f", x); /* below 10^16: the integer is x itself */
}

void decimal_bound(char text[32], const mag_t x)
{
    const slong least = -1000000, most = 1000000; /* powers of two: what is beyond is bounded by them */
    if (mag_is_zero(x) || mag_cmp_2exp_si(x, most) > 0) {
        snprintf(text, 32, "%s", mag_is_zero(x) ? "0" : "inf");
        return;
    }
    SCOPE(mag, bound);
    SCOPE(arf, value);
    mpfr_t y;
    mpfr_exp_t exponent;
    char digits[8]; /* two */
    mag_set_ui_2exp_si(bound, 1, least);
    mag_max(bound, bound, x);
    arf_set_mag(value, bound);
    mpfr_init2(y, MAG_BITS + 2);
    arf_get_mpfr(y, value, MPFR_RNDU); /* exact */
    mpfr_get_str(digits, &exponent, 10, 2, y, MPFR_RNDU);
    mpfr_clear(y);
    write_scientific(text, digits, exponent - 1);
}
