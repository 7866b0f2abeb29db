/*
 * Numbers as text: rationals are rounded as integers of so many digits, exactly, binary numbers and the ends of balls by MPFR, and
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

/* Of the exponent of 2 of a ball: as a decimal's it has fifteen digits. */
enum { EXPONENT_BITS = FLINT_BITS - 14 };

/* x base^k */
static void scale(fmpq_t x, ulong base, slong k)
{
    SCOPE(fmpz, power);
    fmpz_ui_pow_ui(power, base, (ulong)labs(k));
    if (k < 0)
        fmpq_div_fmpz(x, x, power);
    else
        fmpq_mul_fmpz(x, x, power);
}

/* ---- reading ---------------------------------------------------------- */

/* The literal's own value; strtod() has found it well formed and finite in syntax. False where it is too large to be told. */
static bool own_value(fmpq_t value, const char *text)
{
    const bool hexadecimal = strpbrk(text, "xX") != NULL;
    const size_t length = strcspn(text, hexadecimal ? "pP" : "eE");
    slong exponent = text[length] != '\0' ? strtol(text + length + 1, NULL, 10) : 0, fraction = 0; /* saturated far outside */
    char *digits = text_copy(text), *end = digits;
    bool point = false;
    SCOPE(fmpz, mantissa);
    for (size_t i = 0; i < length; i++) {
        if (strchr("+.xX", text[i]) == NULL) {
            *end++ = text[i];
            fraction += point;
        }
        point = point || text[i] == '.';
    }
    *end = '\0';
    fmpz_set_str(mantissa, digits, hexadecimal ? 16 : 10);
    free(digits);
    fmpq_set_fmpz(value, mantissa);
    if (fmpz_is_zero(mantissa))
        return true;
    if (exponent < -LARGEST_EXPONENT || exponent > LARGEST_EXPONENT || fraction > MOST_DIGITS ||
        (slong)fmpz_bits(mantissa) > 4 * MOST_DIGITS)
        return false;
    scale(value, hexadecimal ? 2 : 10, exponent - (hexadecimal ? 4 * fraction : fraction));
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

/* d.ddde-XX from the digits, a sign perhaps before them, and the exponent of the first. */
static void write_scientific(char *text, const char *digits, slong exponent)
{
    if (*digits == '-')
        *text++ = *digits++;
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

char *decimal_of_rational(const fmpq_t x, slong digits)
{
    /* 10^(above - 2) <= |p|, |q| < 10^below */
    const slong above = (slong)fmpz_sizeinbase(fmpq_numref(x), 10), below = (slong)fmpz_sizeinbase(fmpq_denref(x), 10);
    slong first = above - 2 - below; /* the exponent of the first digit, or one that is too low */
    SCOPE(fmpz, n, remainder, limit);
    SCOPE(fmpq, scaled);
    if (fmpq_is_zero(x))
        return text_copy("0");
    fmpz_ui_pow_ui(limit, 10, (ulong)digits);
    for (;; first++) {
        fmpq_set(scaled, x);
        scale(scaled, 10, digits - 1 - first);
        fmpz_ndiv_qr(n, remainder, fmpq_numref(scaled), fmpq_denref(scaled)); /* of a tie the one nearer zero */
        if (fmpz_equal_ui(fmpq_denref(scaled), 2) && fmpz_is_odd(n))
            fmpz_add_si(n, n, fmpq_sgn(x));
        if (fmpz_cmpabs(n, limit) < 0) /* not where x rounds to the next power of ten, either */
            break;
    }
    char *text = xrealloc(NULL, (size_t)digits + BESIDE_DIGITS, 1), *significand = fmpz_get_str(NULL, 10, n);
    write_scientific(text, significand, first);
    flint_free(significand);
    return text;
}

/* x in so many digits, rounded that way. */
static void write_rounded(char *text, mpfr_srcptr x, slong digits, mpfr_rnd_t way)
{
    mpfr_exp_t first;
    char *significand = mpfr_get_str(NULL, &first, 10, (size_t)digits, x, way);
    if (mpfr_zero_p(x))
        memcpy(text, "0", sizeof "0");
    else
        write_scientific(text, significand, first - 1);
    mpfr_free_str(significand);
}

/* The lower or upper end of a ball, outward to prec bits, in so many digits, rounded that way. */
static char *rounded_end(const arb_t x, slong prec, bool upper, slong digits, mpfr_rnd_t way)
{
    mpfr_t low, high;
    char *text = xrealloc(NULL, (size_t)digits + BESIDE_DIGITS, 1);
    mpfr_inits2(prec, low, high, (mpfr_ptr)NULL);
    arb_get_interval_mpfr(low, high, x);
    write_rounded(text, upper ? high : low, digits, way);
    mpfr_clears(low, high, (mpfr_ptr)NULL);
    return text;
}

char *decimal_of_end(const arb_t x, slong digits, bool upper)
{
    return rounded_end(x, 64, upper, digits, upper ? MPFR_RNDU : MPFR_RNDD);
}

/*
 * Theorem. The text is x to the nearest, ties to even, for every x of the ball. It rests on these, each with a test of its name in
 * tests/text/test_decimal.c: (D1) the ball's radius: where both ends round alike, so does all between them; (D2) the ends' own
 * rounding, outward; (D3) a tie, of which nothing is rounded before.
 */
char *decimal_of_ball(const arb_t x, slong digits)
{
    const slong prec = FLINT_MAX(10 * digits / 3, arf_bits(arb_midref(x))) + 64; /* of a number without radius all of its own */
    if (arb_is_zero(x))
        return text_copy("0");
    if (arb_contains_zero(x) || fmpz_bits(ARF_EXPREF(arb_midref(x))) > EXPONENT_BITS) /* as the exponent of an infinity is */
        return NULL;
    char *text = rounded_end(x, prec, false, digits, MPFR_RNDN), *upper = rounded_end(x, prec, true, digits, MPFR_RNDN);
    if (strcmp(text, upper) != 0) {
        free(text);
        text = NULL;
    }
    free(upper);
    return text;
}

/*
 * The fewest digits that read back as x > 0, the nearest of them, and the exponent of the first. Of a normal number no decimal of fewer
 * than DBL_DIG digits is lost on the way, so that it stands among those, zeros after it. Below a power of two numbers lie twice as
 * close: there the next decimal above may read back where the nearest does not.
 */
static slong shortest_digits(char digits[24], double x)
{
    mpfr_t exact;
    mpfr_exp_t first;
    char literal[24 + BESIDE_DIGITS];
    double back;
    mpfr_init2(exact, DBL_MANT_DIG);
    mpfr_set_d(exact, x, MPFR_RNDN);
    const bool power = mpfr_min_prec(exact) == 1;
    int twice = 2 * (x < DBL_MIN ? 1 : DBL_DIG); /* the digits */
    do {
        mpfr_get_str(digits, &first, 10, (size_t)twice / 2, exact, twice % 2 == 0 ? MPFR_RNDN : MPFR_RNDU);
        write_scientific(literal, digits, first - 1);
        back = strtod(literal, NULL);
        twice += power ? 1 : 2;
    } while (back < x || back > x);
    mpfr_clear(exact);
    for (size_t last = strlen(digits) - 1; digits[last] == '0'; last--)
        digits[last] = '\0';
    return first - 1;
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
    char digits[24]; /* at most 17 */
    const int first = (int)shortest_digits(digits, x), last = first + 1 - (int)strlen(digits);
    /* Simple readers take in 17 digits, zeros before the first of them too: a small number has all of its own within them. */
    const bool small = first < -4 || (int)strlen(digits) - first > 17;
    if (small || first >= 16)
        write_scientific(text, digits, first);
    else /* where powers of two are decimals of so few digits themselves, and so the nearest ones */
        snprintf(text, room, "%.*f", FLINT_MAX(-last, 0), x);
}

void decimal_bound(char text[32], double x)
{
    mpfr_t bound;
    mpfr_init2(bound, DBL_MANT_DIG);
    mpfr_set_d(bound, x, MPFR_RNDN); /* exact */
    if (isfinite(x))
        write_rounded(text, bound, 2, MPFR_RNDU);
    else
        memcpy(text, "inf", sizeof "inf");
    mpfr_clear(bound);
}
