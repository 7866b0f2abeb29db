/*
 * Numbers as text: integers of so many digits, which rationals and binary64 are rounded to exactly, and balls at both ends;
 * strtod rounds correctly, too. No locale but C's takes part: the program sets none.
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
    text += more;
    *text++ = 'e';
    *text++ = exponent < 0 ? '-' : '+';
    if (labs(exponent) < 100) { /* nearly always, and printf() takes as long as all the rest */
        *text++ = (char)('0' + labs(exponent) / 10);
        *text++ = (char)('0' + labs(exponent) % 10);
        *text = '\0';
    } else {
        snprintf(text, BESIDE_DIGITS - 4, "%ld", labs(exponent));
    }
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

/* |x| 10^k as an integer, the nearest one, ties to even: of an enclosure its end nearer zero, and false where the other rounds
   elsewhere. One rounds down or up. */
typedef bool rounder(fmpz_t n, const void *x, slong k);

/* From the exponent of the first digit, or one that is too low. */
static char *scientific(rounder *round, const void *x, bool negative, slong digits, slong exponent)
{
    SCOPE(fmpz, n);
    char *significand = NULL, *text = NULL;
    bool decided, fits;
    do {
        flint_free(significand);
        decided = round(n, x, digits - 1 - exponent);
        significand = fmpz_get_str(NULL, 10, n);
        fits = (slong)strlen(significand) <= digits; /* not where |x| rounds to the next power of ten, either */
        exponent += !fits;
    } while (!fits);
    if (decided) {
        text = xrealloc(NULL, (size_t)digits + BESIDE_DIGITS, 1);
        text[0] = '-';
        write_scientific(text + negative, significand, exponent);
    }
    flint_free(significand);
    return text;
}

/* p/q becomes p/q 10^k. */
static void scale_decimal(fmpz_t p, fmpz_t q, slong k)
{
    SCOPE(fmpz, power);
    fmpz_ui_pow_ui(power, 10, (ulong)labs(k));
    fmpz_mul(k < 0 ? q : p, k < 0 ? q : p, power);
}

/* Away from zero, towards it, or to the nearest. */
struct rounded {
    const fmpq *x;
    arf_rnd_t way;
};

static bool round_rational(fmpz_t n, const void *what, slong k)
{
    const struct rounded *r = what;
    SCOPE(fmpz, p, q, remainder);
    fmpz_abs(p, fmpq_numref(r->x));
    fmpz_set(q, fmpq_denref(r->x));
    scale_decimal(p, q, k);
    fmpz_fdiv_qr(n, remainder, p, q);
    bool more = r->way == ARF_RND_UP && !fmpz_is_zero(remainder);
    if (r->way == ARF_RND_NEAR) {
        fmpz_mul_2exp(remainder, remainder, 1);
        const int half = fmpz_cmp(remainder, q);
        more = half > 0 || (half == 0 && fmpz_is_odd(n));
    }
    if (more)
        fmpz_add_ui(n, n, 1);
    return true;
}

static char *rounded_text(arf_rnd_t way, const fmpq_t x, slong digits)
{
    const struct rounded r = {x, way};
    slong top, bottom;
    const double above = fmpz_get_d_2exp(&top, fmpq_numref(x)), below = fmpz_get_d_2exp(&bottom, fmpq_denref(x));
    if (fmpq_is_zero(x))
        return text_copy("0");
    return scientific(round_rational, &r, fmpq_sgn(x) < 0, digits, decimal_exponent(fabs(above / below), top - bottom));
}

char *decimal_of_rational(const fmpq_t x, slong digits)
{
    return rounded_text(ARF_RND_NEAR, x, digits);
}

/*
 * Theorem. n is the integer nearest to |x| 10^k, ties to even, for every x of the ball. It rests on these, each with a test of its name
 * in tests/text/test_decimal.c: (D1) the ball's radius; (D2) the roundings of 10^k and of the product or quotient, to prec bits;
 * (D3) ends rounded outward, of which both round to n, and so does all between them; (D4) a tie, of which nothing is rounded.
 */
static bool round_ball(fmpz_t n, const void *x, slong k)
{
    const double bits_a_digit = 3.3219280948873623; /* OEIS A020862 */
    const slong bits = (slong)((double)fmpz_get_si(ARF_EXPREF(arb_midref((arb_srcptr)x))) + (double)k * bits_a_digit);
    /* A tie is exact in these: it has `bits` and one of a half, and 5^k is a factor of it, or one of x. */
    const slong prec = FLINT_MAX(bits, arf_bits(arb_midref((arb_srcptr)x))) + 64 + (slong)FLINT_BIT_COUNT(labs(k));
    SCOPE(arb, y);
    SCOPE(arf, end);
    SCOPE(fmpz, other);
    arb_ui_pow_ui(y, 10, (ulong)labs(k), prec);
    if (k < 0)
        arb_div(y, x, y, prec);
    else
        arb_mul(y, x, y, prec);
    arb_abs(y, y);
    arb_get_lbound_arf(end, y, prec);
    arf_get_fmpz(n, end, ARF_RND_NEAR);
    arb_get_ubound_arf(end, y, prec);
    arf_get_fmpz(other, end, ARF_RND_NEAR);
    return fmpz_equal(n, other);
}

char *decimal_of_ball(const arb_t x, slong digits)
{
    SCOPE(mag, least);
    arb_get_mag_lower(least, x);
    if (arb_is_zero(x))
        return text_copy("0");
    if (!arb_is_finite(x) || mag_is_zero(least) || fmpz_bits(MAG_EXPREF(least)) > EXPONENT_BITS)
        return NULL;
    const slong exponent = decimal_exponent(ldexp((double)MAG_MAN(least), -MAG_BITS), fmpz_get_si(MAG_EXPREF(least)));
    return scientific(round_ball, x, arf_sgn(arb_midref(x)) < 0, digits, exponent);
}

char *decimal_of_end(const arb_t x, slong digits, bool upper)
{
    SCOPE(arf, end);
    SCOPE(fmpq, exact);
    if (upper)
        arb_get_ubound_arf(end, x, 64);
    else
        arb_get_lbound_arf(end, x, 64);
    arf_get_fmpq(exact, end);
    return rounded_text(upper == (fmpq_sgn(exact) > 0) ? ARF_RND_UP : ARF_RND_DOWN, exact, digits);
}

/*
 * The fewest digits that read back as x > 0, the nearest of them, and the exponent of the first. In units of the last of 17
 * digits, which are enough, x = n + rest/q. What lies within `reach`/q, half a binary unit, reads back as x, where x is even
 * the ends do so too; below a power of two units are half as large. Of a normal number no decimal of fewer than DBL_DIG = 15
 * digits is lost on the way, so that it stands among those, zeros after it.
 */
static slong shortest_digits(char digits[24], double x)
{
    enum { ENOUGH = 17 };
    int binary;
    const bool power = !(frexp(x, &binary) > 0.5) && x > DBL_MIN;
    const slong exponent = decimal_exponent(x, 0);
    slong dropped = x < DBL_MIN ? ENOUGH : ENOUGH - DBL_DIG + 1; /* the exponent may be too low, n of 18 digits */
    SCOPE(fmpz, n, rest, q, reach, most);
    SCOPE(fmpz, unit, shorter, below, above);
    binary = (binary < DBL_MIN_EXP ? DBL_MIN_EXP : binary) - DBL_MANT_DIG;
    fmpz_set_d(n, ldexp(x, -binary));
    const bool even = fmpz_is_even(n);
    fmpz_set_ui(q, 2);
    fmpz_set_ui(reach, 1);
    fmpz_mul_2exp(binary < 0 ? q : reach, binary < 0 ? q : reach, (ulong)abs(binary));
    scale_decimal(reach, q, ENOUGH - 1 - exponent);
    fmpz_mul(n, n, reach);
    fmpz_mul_2exp(n, n, 1);
    fmpz_fdiv_qr(n, rest, n, q);
    fmpz_fdiv_q(most, reach, q);
    fmpz_add_ui(most, most, 1);
    for (;; dropped--) {
        fmpz_ui_pow_ui(unit, 10, (ulong)dropped);
        fmpz_fdiv_qr(shorter, below, n, unit);
        fmpz_sub(above, unit, below);
        if (fmpz_cmp(below, most) > 0 && fmpz_cmp(above, most) > 0)
            continue; /* too far away, both */
        fmpz_mul(below, below, q);
        fmpz_add(below, below, rest);
        fmpz_mul(above, unit, q);
        fmpz_sub(above, above, below);
        const int nearer = fmpz_cmp(below, above);
        fmpz_mul_2exp(below, below, power);
        const bool low = fmpz_cmp(below, reach) < even, high = fmpz_cmp(above, reach) < even;
        if (high && (!low || nearer > 0 || (nearer == 0 && fmpz_is_odd(shorter))))
            fmpz_add_ui(shorter, shorter, 1);
        if (high || low)
            break;
    }
    fmpz_get_str(digits, 10, shorter);
    size_t count = strlen(digits);
    const slong first = exponent + (slong)count + dropped - ENOUGH;
    while (count > 1 && digits[count - 1] == '0')
        digits[--count] = '\0';
    return first;
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
    if (small || first >= 16) {
        write_scientific(text, digits, first);
        return;
    }
    for (int power = FLINT_MAX(first, 0); power >= FLINT_MIN(last, 0); power--) {
        if (power == -1)
            *text++ = '.';
        *text++ = power > first || power < last ? '0' : digits[first - power];
    }
    *text = '\0';
}

void decimal_bound(char text[32], double x)
{
    SCOPE(fmpq, exact);
    SCOPE(arf, value);
    arf_set_d(value, x);
    if (!arf_is_normal(value)) {
        snprintf(text, 32, "%s", arf_is_zero(value) ? "0" : "inf");
        return;
    }
    arf_get_fmpq(exact, value);
    char *digits = rounded_text(ARF_RND_UP, exact, 2);
    snprintf(text, 32, "%s", digits);
    free(digits);
}
