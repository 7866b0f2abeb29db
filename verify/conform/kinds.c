#include "conform/kinds.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "evaluate/reference.h"

static const double PI = 3.14159265358979323846;

double tolerance_of(const struct evidence *v, int f, int k, double S, int significand)
{
    const struct section *s = v->section;
    const double *y = v->y[f], *exact = v->exact[f];
    const double roundings = S == 0.0 ? 1.0 : 1.0 + S / fabs(exact[k]);
    double size = 0.0;
    if (!is_motion(s))
        return isfinite(roundings) ? fmax(1e-9, ldexp(64.0, -significand)) * roundings * fabs(y[k]) : INFINITY;
    for (int i = 0; i < s->output_count; i++)
        size = fmax(size, fmax(fabs(y[i]), fabs(exact[i])) / motion_unit(s, v->x[f], i));
    return 2.0 * pow(10.0, -fmin(v->digits, 9.0)) * size * motion_unit(s, v->x[f], k);
}

/* Whether an answer is that number, if it is one; and whether an output is right in every vector. */
static bool is_same(const struct evidence *v, int f, int k, double number)
{
    const double y = v->y[f][k];
    return isnan(y) || fabs(y - number) <= v->tolerance[f][k];
}

bool is_answer(const struct evidence *v, int f, const double *made)
{
    bool numbers = true, same = true;
    int order[4] = {0};
    if (v->section->method == METHOD_ROOTS)
        match_roots(v->y[f], made, order);
    for (int k = 0; k < v->section->output_count; k++) {
        numbers = numbers && isfinite(made[k]);
        same = same && is_same(v, f, k, v->section->method == METHOD_ROOTS ? made[2 * order[k / 2] + k % 2] : made[k]);
    }
    return isnan(v->y[f][0]) ? !numbers : numbers && same;
}

static bool is_right(const struct evidence *v, int k)
{
    bool right = true;
    for (int f = 0; f < v->count; f++)
        right = right && is_same(v, f, k, v->exact[f][k]);
    return right;
}

/* ---- all outputs alike ---- */

/* The same digits after the point in every answer, no exponent, and right within half of the last of them. */
static void fixed_decimals(const struct evidence *v, char *text, size_t size)
{
    int decimals = 0;
    for (int f = 0; f < v->count; f++) {
        const char *word = v->records[f]->text;
        for (int k = 0; k < v->section->output_count; k++, word += strcspn(word, " "), word += strspn(word, " ")) {
            const char *point = word + strcspn(word, ". ");
            const int length = (int)strspn(point + (*point == '.'), "0123456789");
            if (length == 0 || (decimals != 0 && length != decimals) || strchr(" ", point[length + 1]) == NULL ||
                fabs(v->y[f][k] - v->exact[f][k]) > 0.50001 * pow(10.0, -length))
                return;
            decimals = length;
        }
    }
    snprintf(text, size, "written with %d decimals: small numbers lose their digits", decimals);
}

/* Each answer is another output's. */
static void permuted_outputs(const struct evidence *v, char *text, size_t size)
{
    const int count = v->section->output_count;
    char names[240] = "";
    unsigned taken = 0;
    bool moved = false;
    for (int k = 0; k < count; k++) {
        int from = -1;
        for (int j = 0; j < count && from < 0; j++) {
            bool same = (taken & 1U << j) == 0;
            for (int f = 0; f < v->count && same; f++)
                same = is_same(v, f, k, v->exact[f][j]);
            from = same ? j : -1;
        }
        if (from < 0)
            return;
        taken |= 1U << from;
        moved = moved || from != k;
        add_text(names, sizeof names, " ", v->section->outputs[from]->name);
    }
    if (moved)
        snprintf(text, size, "the outputs in another order: %s", names);
}

/* ---- one output after another ---- */

/* The angle that is nearest to a number, some turns away. */
static double turned(double angle, double number)
{
    return angle + 2.0 * PI * round((number - angle) / (2.0 * PI));
}

/* Outputs that are wrong all in one way, where the others are right. */
static void wrong_outputs(const struct evidence *v, char *text, size_t size)
{
    enum { TURNED, EXCHANGED, UNSIGNED, ZEROS, WAYS };
    static const char *const ways[WAYS] = {"differs by 2 pi: it lies from -pi to pi", "is that of atan2 with its arguments exchanged",
                                           "lost the sign", "all zeros"};
    for (int way = 0; way < WAYS; way++) {
        char names[240] = "";
        bool fits = true;
        for (int k = 0; k < v->section->output_count; k++) {
            if (is_right(v, k))
                continue;
            for (int f = 0; f < v->count; f++) {
                const double y = v->y[f][k], exact = v->exact[f][k];
                const double due[] = {turned(exact, y), turned(PI / 2.0 - exact, y), fabs(exact), 0.0};
                fits = fits && (is_same(v, f, k, due[way]) || (y == 0.0 && exact == 0.0)); /* atan2(0, 0) */
            }
            add_text(names, sizeof names, ", ", v->section->outputs[k]->name);
        }
        /* of roots, which are a set, it is not told whose */
        const bool conjugates = way == UNSIGNED && v->section->method == METHOD_ROOTS && strstr(names, "re") == NULL;
        if (fits)
            snprintf(text, size, "%s %s", conjugates ? "conjugates are missing: the imaginary parts" : names, ways[way]);
    }
}

/* ---- factors, and other inputs: a number in each vector ---- */

/* Whether a power of it is a factor in all that is wrong. */
static bool is_factor(const struct evidence *v, const double *number, double power)
{
    bool fits = true;
    for (int k = 0; k < v->section->output_count; k++)
        for (int f = 0; f < v->count && fits && !is_right(v, k); f++)
            fits = is_same(v, f, k, v->exact[f][k] == 0.0 ? 0.0 : pow(number[f], power) * v->exact[f][k]);
    return fits;
}

/* One constant, as the answer has it that is least disturbed by roundings. */
static void constant_factor(const struct evidence *v, char *text, size_t size)
{
    double factor[MOST_KEPT] = {NAN}, least = 1.0;
    for (int k = 0; k < v->section->output_count; k++)
        for (int f = 0; f < v->count && !is_right(v, k); f++)
            if (v->tolerance[f][k] < least * fabs(v->y[f][k]) && v->exact[f][k] != 0.0) {
                least = v->tolerance[f][k] / fabs(v->y[f][k]);
                factor[0] = v->y[f][k] / v->exact[f][k];
            }
    for (int f = 1; f < v->count; f++)
        factor[f] = factor[0];
    if (isnormal(factor[0]) && is_factor(v, factor, 1.0))
        snprintf(text, size, "a constant factor %.10g", factor[0]);
}

/* Whether the operation was done with it in place of an input, and with that one in place of the other. */
static bool is_input(const struct evidence *v, int input, int other, const double *number)
{
    bool fits = true;
    for (int f = 0; f < v->count && fits; f++) {
        double x[MOST_INPUTS], made[MOST_OUTPUTS];
        memcpy(x, v->x[f], sizeof x);
        x[other] = x[input];
        x[input] = number[f];
        reference_find(v->section->id)(x, made);
        fits = is_answer(v, f, made);
    }
    return fits;
}

/* Powers of an input, of the masses and of their sum, and what is added; in words, after the input's where it takes part. */
struct guess {
    const char *words;
    double power, m1, m2, sum, plus;
};
enum { FACTORS = 7 };
static const struct guess guesses[] = {
    {"m1*m2/(m1 + m2)", 0, 1, 1, -1, 0}, {"m1/(m1 + m2)", 0, 1, 0, -1, 0}, {"m2/(m1 + m2)", 0, 0, 1, -1, 0}, {"m1/m2", 0, 1, -1, 0, 0},
    {"", 1, 0, 0, 0, 0}, {"^2", 2, 0, 0, 0, 0}, {"^3", 3, 0, 0, 0, 0},
    /* in place of the input */
    {" + 1", 1, 0, 0, 0, 1}, {" - 1", 1, 0, 0, 0, -1}, {"*m1*m2/(m1 + m2)", 1, 1, 1, -1, 0}, {"*(m1*m2/(m1 + m2))^2", 1, 2, 2, -2, 0},
    {"/(m1*m2/(m1 + m2))", 1, -1, -1, 1, 0}, {"/(m1*m2/(m1 + m2))^2", 1, -2, -2, 2, 0}};

/* NaN where it needs masses that the operation does not have: no power but the zeroth makes a number of one. */
static double guessed(const struct guess *g, const struct section *s, const double *x, int input)
{
    const int places[] = {input_place(s, "m1"), input_place(s, "m2")};
    const double m1 = places[0] < 0 ? NAN : x[places[0]], m2 = places[1] < 0 ? NAN : x[places[1]];
    return pow(x[input], g->power) * pow(m1, g->m1) * pow(m2, g->m2) * pow(m1 + m2, g->sum) + g->plus;
}

/* What the masses make, or a power of an input, in what is wrong; one input off by one, or with such a factor; two exchanged. */
static void by_names(const struct evidence *v, char *text, size_t size)
{
    const struct section *s = v->section;
    double number[MOST_KEPT];
    for (int i = 0; i < s->input_count; i++) {
        const char *input = s->inputs[i]->name;
        for (size_t g = 0; g < sizeof guesses / sizeof *guesses && *text == '\0'; g++) {
            const char *name = guesses[g].power > 0.0 ? input : "", *words = guesses[g].words;
            for (int f = 0; f < v->count; f++)
                number[f] = guessed(&guesses[g], s, v->x[f], i);
            if (g >= FACTORS && is_input(v, i, i, number))
                snprintf(text, size, "%s%s in place of %s", name, words, input);
            else if (g < FACTORS && is_factor(v, number, 1.0))
                snprintf(text, size, "a factor %s%s too many", name, words);
            else if (g < FACTORS && is_factor(v, number, -1.0))
                snprintf(text, size, "a factor %s%s is missing", name, words);
        }
        for (int other = i + 1; other < s->input_count && *text == '\0'; other++) {
            for (int f = 0; f < v->count; f++)
                number[f] = v->x[f][other];
            if (is_input(v, i, other, number))
                snprintf(text, size, "the inputs %s and %s exchanged", input, s->inputs[other]->name);
        }
    }
}

void kind_of_formula(const struct evidence *v, char *text, size_t size)
{
    static void (*const kinds[])(const struct evidence *, char *, size_t) = {wrong_outputs, fixed_decimals, permuted_outputs, constant_factor,
                                                                            by_names};
    int wrong = 0;
    bool differ = true;
    for (int f = 0; f < v->count; f++) {
        bool right = true;
        for (int k = 0; k < v->section->output_count; k++)
            right = right && is_same(v, f, k, v->exact[f][k]);
        wrong += !right;
    }
    for (int i = 0; i < v->section->input_count; i++) {
        bool same = true;
        for (int f = 1; f < v->count; f++)
            same = same && v->x[f][i] == v->x[0][i];
        differ = differ && !same;
    }
    for (size_t i = 0; i < sizeof kinds / sizeof *kinds && wrong > 1 && differ && *text == '\0'; i++)
        kinds[i](v, text, size);
}
