/*
 * Numbers as text. Every conversion is exact rational arithmetic followed by
 * one rounding to an integer; neither the locale nor libc's conversions take part.
 */
#include "decimal.h"

#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "message.h"

/* Of an exact literal, beyond binary128's 10^+-4966: there certified roots still take but a second. */
static const slong LARGEST_EXPONENT = 5000, MOST_DIGITS = 10000;
static const slong MANTISSA_BITS = DBL_MANT_DIG;                /* 53: a binary64's significand */
static const slong LEAST_EXPONENT = DBL_MIN_EXP - DBL_MANT_DIG; /* -1074: its subnormals' ulp   */

/* n = p/q rounded to the nearest integer, ties to even; p >= 0, q > 0. */
static void nearest(fmpz_t n, const fmpz_t p, const fmpz_t q)
{
    fmpz_t remainder;
    fmpz_init(remainder);
    fmpz_fdiv_qr(n, remainder, p, q);
    fmpz_mul_2exp(remainder, remainder, 1);
    int half = fmpz_cmp(remainder, q);
    if (half > 0 || (half == 0 && fmpz_is_odd(n)))
        fmpz_add_ui(n, n, 1);
    fmpz_clear(remainder);
}

/* p/q = |x| base^k */
static void scale(fmpz_t p, fmpz_t q, const fmpq_t x, ulong base, slong k)
{
    fmpz_t power;
    fmpz_init(power);
    fmpz_ui_pow_ui(power, base, k < 0 ? -(ulong)k : (ulong)k);
    fmpz_abs(p, fmpq_numref(x));
    fmpz_set(q, fmpq_denref(x));
    if (k < 0)
        fmpz_mul(q, q, power);
    else
        fmpz_mul(p, p, power);
    fmpz_clear(power);
}

/* ---- reading ---------------------------------------------------------- */

/* The digit's value, or 16 (no digit in any base used here). */
static int digit_value(char c)
{
    if (c >= '0' && c <= '9')
        return c - '0';
    if (c >= 'a' && c <= 'f')
        return c - 'a' + 10;
    if (c >= 'A' && c <= 'F')
        return c - 'A' + 10;
    return 16;
}

/* Equal but for the case of ASCII letters; the word is in lower case. */
static bool spells(const char *text, const char *word)
{
    while (*word != '\0' && (*text | 0x20) == *word) {
        text++;
        word++;
    }
    return *word == '\0' && *text == '\0';
}

/*
 * Digits of the base with at most one point, at least one digit: their integer, and
 * how many stood behind the point. Returns what follows, NULL when there is no digit.
 */
static const char *read_digits(fmpz_t mantissa, slong *fraction, const char *text, int base)
{
    size_t span = strspn(text, "0123456789abcdefABCDEF.");
    char *digits = memory(NULL, span + 1, 1);
    size_t count = 0;
    bool point = false;
    *fraction = 0;
    for (; digit_value(*text) < base || (*text == '.' && !point); text++) {
        if (*text == '.') {
            point = true;
        } else {
            digits[count++] = *text;
            *fraction += point;
        }
    }
    digits[count] = '\0';
    if (count > 0)
        fmpz_set_str(mantissa, digits, base);
    free(digits);
    return count > 0 ? text : NULL;
}

/* A signed decimal integer, saturated far outside every range used. NULL when there is none. */
static const char *read_exponent(slong *exponent, const char *text)
{
    const slong saturated = 1000000000000; /* a literal would need 10^12 digits to bring it back */
    bool negative = *text == '-';
    if (*text == '-' || *text == '+')
        text++;
    if (digit_value(*text) >= 10)
        return NULL;
    slong value = 0;
    for (; digit_value(*text) < 10; text++)
        value = value < saturated ? 10 * value + digit_value(*text) : value;
    *exponent = negative ? -value : value;
    return text;
}

/* x > 0 becomes the nearest binary64, ties to even; false when that overflows. */
static bool round_to_binary64(fmpq_t x)
{
    fmpz_t p, q, n;
    fmpz_init(p);
    fmpz_init(q);
    fmpz_init(n);
    /* 2^(top - 1) < x < 2^(top + 1); one step down when x lies below 2^top */
    slong top = (slong)fmpz_bits(fmpq_numref(x)) - (slong)fmpz_bits(fmpq_denref(x));
    scale(p, q, x, 2, -top);
    if (fmpz_cmp(p, q) < 0)
        top--;
    slong ulp = FLINT_MAX(top - (MANTISSA_BITS - 1), LEAST_EXPONENT);
    scale(p, q, x, 2, -ulp);
    nearest(n, p, q);
    bool fits = (slong)fmpz_bits(n) + ulp <= DBL_MAX_EXP;
    fmpq_set_fmpz(x, n);
    if (ulp < 0)
        fmpq_div_2exp(x, x, (ulong)-ulp);
    else
        fmpq_mul_2exp(x, x, (ulong)ulp);
    fmpz_clear(p);
    fmpz_clear(q);
    fmpz_clear(n);
    return fits;
}

/* value = mantissa base^exponent, rounded to binary64 unless exact */
static enum literal place(fmpq_t value, const fmpz_t mantissa, ulong base, slong exponent,
                          bool exact)
{
    fmpq_zero(value);
    if (fmpz_is_zero(mantissa))
        return LITERAL_FINITE;
    if (!exact) {
        /* far from binary64's range, known without a giant power: 2^-1075 > 10^-324, 2^1024 <
         * 10^309 */
        slong size = (slong)fmpz_sizeinbase(mantissa, (int)base) + exponent;
        if (size > (base == 2 ? 1030 : 315))
            return LITERAL_OVERFLOW;
        if (size < (base == 2 ? -1080 : -330))
            return LITERAL_FINITE;
    }
    fmpq_t x;
    fmpq_init(x);
    fmpq_set_fmpz(x, mantissa);
    scale(fmpq_numref(x), fmpq_denref(x), x, base, exponent);
    fmpq_canonicalise(x);
    bool fits = exact || round_to_binary64(x);
    if (fits)
        fmpq_swap(value, x);
    fmpq_clear(x);
    return fits ? LITERAL_FINITE : LITERAL_OVERFLOW;
}

enum literal literal_read(fmpq_t value, const char *text, bool exact)
{
    bool negative = *text == '-';
    if (*text == '-' || *text == '+')
        text++;
    if (spells(text, "nan"))
        return LITERAL_NAN;
    if (spells(text, "inf") || spells(text, "infinity"))
        return negative ? LITERAL_NEGATIVE_INFINITE : LITERAL_INFINITE;

    bool hexadecimal = text[0] == '0' && (text[1] | 0x20) == 'x';
    slong fraction = 0, exponent = 0;
    fmpz_t mantissa;
    fmpz_init(mantissa);
    text = hexadecimal ? read_digits(mantissa, &fraction, text + 2, 16)
                       : read_digits(mantissa, &fraction, text, 10);
    if (text != NULL && (*text | 0x20) == (hexadecimal ? 'p' : 'e'))
        text = read_exponent(&exponent, text + 1);

    enum literal what = LITERAL_MALFORMED;
    if (text != NULL && *text == '\0') {
        const bool giant = labs(exponent) > LARGEST_EXPONENT || fraction > MOST_DIGITS ||
                           (slong)fmpz_bits(mantissa) > 4 * MOST_DIGITS;
        if (exact && giant && !fmpz_is_zero(mantissa))
            what = LITERAL_OVERFLOW;
        else
            what = place(value, mantissa, hexadecimal ? 2 : 10,
                         exponent - (hexadecimal ? 4 * fraction : fraction), exact);
    }
    if (what == LITERAL_FINITE && negative)
        fmpq_neg(value, value);
    fmpz_clear(mantissa);
    return what;
}

/* ---- writing ---------------------------------------------------------- */

/* What a number needs beside its digits: -, ., e, an exponent's sign and 19 digits, the end. */
enum { BESIDE_DIGITS = 24 };

/* d.ddde-XX from the digits' integer and the exponent of the first. */
static void write_scientific(char *text, const fmpz_t digits, slong exponent)
{
    fmpz_get_str(text + 1, 10, digits);
    size_t count = strlen(text + 1);
    text[0] = text[1];
    text[1] = '.';
    char *end = text + (count == 1 ? 1 : count + 1);
    snprintf(end, BESIDE_DIGITS - 2, "e%c%02ld", exponent < 0 ? '-' : '+', labs(exponent));
}

static char *scientific(bool negative, const fmpz_t digits, slong exponent)
{
    char *text = memory(NULL, fmpz_sizeinbase(digits, 10) + BESIDE_DIGITS, 1);
    text[0] = '-';
    write_scientific(text + negative, digits, exponent);
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
static slong leading_digits(fmpz_t n, const fmpq_t x, slong digits, bool upward)
{
    fmpz_t p, q, limit;
    fmpz_init(p);
    fmpz_init(q);
    fmpz_init(limit);
    fmpz_ui_pow_ui(limit, 10, (ulong)digits);
    slong top, bottom;
    double above = fmpz_get_d_2exp(&top, fmpq_numref(x));
    double below = fmpz_get_d_2exp(&bottom, fmpq_denref(x));
    slong exponent = decimal_exponent(fabs(above / below), top - bottom);
    for (;; exponent++) {
        scale(p, q, x, 10, digits - 1 - exponent);
        if (upward)
            fmpz_cdiv_q(n, p, q);
        else
            nearest(n, p, q);
        /* A digit too many: the exponent was too low, or the value rounds to the next power of ten.
         */
        if (fmpz_cmp(n, limit) < 0)
            break;
    }
    fmpz_clear(p);
    fmpz_clear(q);
    fmpz_clear(limit);
    return exponent;
}

char *decimal_of_rational(const fmpq_t x, slong digits)
{
    if (fmpq_is_zero(x))
        return text_copy("0");
    fmpz_t n;
    fmpz_init(n);
    slong exponent = leading_digits(n, x, digits, false);
    char *text = scientific(fmpq_sgn(x) < 0, n, exponent);
    fmpz_clear(n);
    return text;
}

/* The nearest integers to the two ends of |x| 10^k: what lies between the ends rounds between them.
 */
static void nearest_ends(fmpz_t low, fmpz_t high, const arb_t x, slong k, slong prec)
{
    arb_t y;
    arf_t end;
    arb_init(y);
    arf_init(end);
    arb_ui_pow_ui(y, 10, (ulong)labs(k), prec);
    if (k < 0)
        arb_div(y, x, y, prec);
    else
        arb_mul(y, x, y, prec);
    arb_get_abs_lbound_arf(end, y, prec);
    arf_get_fmpz(low, end, ARF_RND_NEAR);
    arb_get_abs_ubound_arf(end, y, prec);
    arf_get_fmpz(high, end, ARF_RND_NEAR);
    arb_clear(y);
    arf_clear(end);
}

/* The text of a ball, given a lower bound on the exponent of each of its numbers; NULL when
 * undecided. */
static char *decided(const arb_t x, slong digits, slong exponent)
{
    slong prec = (slong)(3.33 * (double)digits) + 64; /* log2(10) < 3.33, and guard bits */
    fmpz_t low, high, limit;
    fmpz_init(low);
    fmpz_init(high);
    fmpz_init(limit);
    fmpz_ui_pow_ui(limit, 10, (ulong)digits);
    for (;; exponent++) {
        nearest_ends(low, high, x, digits - 1 - exponent, prec);
        if (fmpz_cmp(low, limit) < 0)
            break;
    }
    char *text = fmpz_equal(low, high) ? scientific(arb_is_negative(x), low, exponent) : NULL;
    fmpz_clear(low);
    fmpz_clear(high);
    fmpz_clear(limit);
    return text;
}

/* True when x is a dyadic rational of moderate size, stored in r. */
static bool exact_dyadic(fmpq_t r, const arb_t x)
{
    const slong moderate = 1000000; /* bits: keeps the rational in a few hundred kilobytes */
    if (!arb_is_exact(x) || !arf_is_finite(arb_midref(x)) ||
        arf_cmpabs_2exp_si(arb_midref(x), moderate) > 0 ||
        (!arf_is_zero(arb_midref(x)) && arf_cmpabs_2exp_si(arb_midref(x), -moderate) < 0))
        return false;
    arf_get_fmpq(r, arb_midref(x));
    return true;
}

char *decimal_of_ball(const arb_t x, slong digits)
{
    char *text = NULL;
    fmpq_t r;
    arf_t low, high;
    fmpz_t exponent;
    fmpq_init(r);
    arf_init(low);
    arf_init(high);
    fmpz_init(exponent);
    arb_get_abs_lbound_arf(low, x, MANTISSA_BITS);
    arb_get_abs_ubound_arf(high, x, MANTISSA_BITS);
    arf_mul_2exp_si(high, high, -1);
    if (exact_dyadic(r, x)) {
        text = decimal_of_rational(r, digits);
    } else if (arf_sgn(low) > 0 && arf_cmp(low, high) > 0) {
        /* Within a factor of two, as all numbers with the same first digit, rounded, are (0.95
         * to 1.5). */
        arf_frexp(low, exponent, low);
        if (fmpz_bits(exponent) < 50)
            text = decided(x, digits,
                           decimal_exponent(arf_get_d(low, ARF_RND_DOWN), fmpz_get_si(exponent)));
    }
    fmpq_clear(r);
    arf_clear(low);
    arf_clear(high);
    fmpz_clear(exponent);
    return text;
}

/* p/q = quarters 2^exponent/4 10^k */
static void on_grid(fmpz_t p, fmpz_t q, slong quarters, slong exponent, slong k)
{
    fmpq_t x;
    fmpq_init(x);
    fmpq_set_si(x, quarters, 1);
    if (exponent < 2)
        fmpq_div_2exp(x, x, (ulong)(2 - exponent));
    else
        fmpq_mul_2exp(x, x, (ulong)(exponent - 2));
    scale(p, q, x, 10, k);
    fmpq_clear(x);
}

/*
 * The least and the greatest multiple of 10^-k that read back as x = mantissa 2^exponent: they
 * reach half a step to either side, a quarter below a power of two, ends included when the mantissa
 * is even.
 */
static void neighbourhood(fmpz_t low, fmpz_t high, slong mantissa, slong exponent, slong k)
{
    fmpz_t p, q;
    fmpz_init(p);
    fmpz_init(q);
    bool least = mantissa == (slong)1 << (MANTISSA_BITS - 1) && exponent > LEAST_EXPONENT;
    bool even = mantissa % 2 == 0;
    on_grid(p, q, 4 * mantissa - (least ? 1 : 2), exponent, k);
    if (!even)
        fmpz_add_ui(p, p, 1); /* p/q < n says p + 1 <= n q */
    fmpz_cdiv_q(low, p, q);
    on_grid(p, q, 4 * mantissa + 2, exponent, k);
    if (!even)
        fmpz_sub_ui(p, p, 1);
    fmpz_fdiv_q(high, p, q);
    fmpz_clear(p);
    fmpz_clear(q);
}

/* The fewest digits that read back as mantissa 2^exponent, the nearest of them; returns the last
 * one's exponent. */
static slong shortest_digits(fmpz_t digits, slong mantissa, slong exponent)
{
    fmpz_t p, q, low, high;
    fmpz_init(p);
    fmpz_init(q);
    fmpz_init(low);
    fmpz_init(high);
    /* 17 digits or 18: enough for some multiple to read back (IEEE 754-2019, 5.12.2) */
    slong k = DBL_DECIMAL_DIG - 1 - decimal_exponent((double)mantissa, exponent);
    neighbourhood(low, high, mantissa, exponent, k);
    for (;; k--) {
        fmpz_cdiv_q_ui(p, low, 10);
        fmpz_fdiv_q_ui(q, high, 10);
        if (fmpz_cmp(p, q) > 0)
            break;
        fmpz_swap(low, p);
        fmpz_swap(high, q);
    }
    on_grid(p, q, 4 * mantissa, exponent, k);
    nearest(digits, p, q);
    if (fmpz_cmp(digits, low) < 0) /* below a power of two; above, the neighbourhood is as wide */
        fmpz_set(digits, low);
    fmpz_clear(p);
    fmpz_clear(q);
    fmpz_clear(low);
    fmpz_clear(high);
    return -k;
}

void decimal_shortest(char text[32], double x)
{
    const size_t room = 31; /* behind a sign; 23 are used by -1.2345678901234567e-308 */
    if (signbit(x) && !isnan(x))
        *text++ = '-';
    x = fabs(x);
    if (!isfinite(x) || !(x > 0)) {
        snprintf(text, room, "%s", isnan(x) ? "nan" : x > 0 ? "inf" : "0");
        return;
    }
    int exponent;
    frexp(x, &exponent);
    exponent = (int)FLINT_MAX(exponent - MANTISSA_BITS, LEAST_EXPONENT);
    fmpz_t n;
    fmpz_init(n);
    slong last = shortest_digits(n, (slong)ldexp(x, -exponent), exponent);

    char digits[24]; /* at most 18 */
    fmpz_get_str(digits, 10, n);
    int first = (int)strlen(digits) - 1 + (int)last;
    if (first < -4 || first >= 16)
        write_scientific(text, n, first);
    else if (first < 0)
        snprintf(text, room, "0.%.*s%s", -1 - first, "000", digits);
    else if (last < 0)
        snprintf(text, room, "%.*s.%s", first + 1, digits, digits + first + 1);
    else
        snprintf(text, room, "%ld", (long)x); /* below 10^16: the integer is x itself */
    fmpz_clear(n);
}

void decimal_bound(char text[32], const mag_t x)
{
    const slong least = -1000000,
                most = 1000000; /* powers of two: what is beyond is bounded by them */
    if (mag_is_zero(x) || mag_cmp_2exp_si(x, most) > 0) {
        snprintf(text, 32, "%s", mag_is_zero(x) ? "0" : "inf");
        return;
    }
    mag_t bound;
    fmpq_t value;
    fmpz_t n;
    mag_init(bound);
    fmpq_init(value);
    fmpz_init(n);
    mag_set_ui_2exp_si(bound, 1, least);
    mag_max(bound, bound, x);
    mag_get_fmpq(value, bound);
    slong exponent = leading_digits(n, value, 2, true);
    write_scientific(text, n, exponent);
    mag_clear(bound);
    fmpq_clear(value);
    fmpz_clear(n);
}
