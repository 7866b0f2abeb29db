#include "conform/kinds.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static const double PI = 3.14159265358979323846;

bool is_same(double a, double b)
{
    return fabs(a - b) <= 1e-9 * fmax(fabs(a), fabs(b));
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
                same = is_same(v->y[f][k], v->exact[f][j]);
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

/* How far a number of turns is from a whole one. */
static double part_of_a_turn(double turns)
{
    return fabs(turns - round(turns));
}

static bool turns(double y, double exact)
{
    const double off = (y - exact) / (2.0 * PI);
    return is_same(y, exact) || (round(off) != 0.0 && part_of_a_turn(off) < 1e-9);
}

static bool from_the_other_axis(double y, double exact)
{
    return part_of_a_turn((y + exact - PI / 2.0) / (2.0 * PI)) < 1e-9 || (y == exact && exact == 0.0); /* atan2(0, 0) */
}

static bool is_nothing(double y, double exact)
{
    (void)exact;
    return y == 0.0;
}

bool is_always(const struct evidence *v, int k, bool (*so)(double y, double exact))
{
    bool always = true;
    for (int f = 0; f < v->count; f++)
        always = always && so(v->y[f][k], v->exact[f][k]);
    return always;
}

/* Outputs that are wrong all in one way, where the others are right. */
static void wrong_outputs(const struct evidence *v, char *text, size_t size)
{
    static const struct {
        bool (*so)(double y, double exact);
        const char *what;
    } ways[] = {{turns, "differs by 2 pi: it lies from -pi to pi"}, {from_the_other_axis, "is that of atan2 with its arguments exchanged"},
                {is_nothing, "all zeros"}};
    for (size_t way = 0; way < sizeof ways / sizeof *ways; way++) {
        char names[240] = "";
        bool fits = true;
        for (int k = 0; k < v->section->output_count; k++) {
            if (is_always(v, k, is_same))
                continue;
            fits = fits && is_always(v, k, ways[way].so);
            add_text(names, sizeof names, ", ", v->section->outputs[k]->name);
        }
        if (fits)
            snprintf(text, size, "%s %s", names, ways[way].what);
    }
}

/* One constant in all that is wrong, in every vector. */
static void constant_factor(const struct evidence *v, char *text, size_t size)
{
    double factor = NAN;
    for (int k = 0; k < v->section->output_count; k++)
        for (int f = 0; f < v->count && !is_always(v, k, is_same); f++) {
            const double y = v->y[f][k], exact = v->exact[f][k];
            factor = isnan(factor) && exact != 0.0 ? y / exact : factor;
            if (!(exact == 0.0 ? y == 0.0 : is_same(y, factor * exact)))
                return;
        }
    if (isnormal(factor))
        snprintf(text, size, "a constant factor %.10g", factor);
}

/* Four roots, each in its place, of whose imaginary parts the sizes alone are left. */
static void lost_conjugates(const struct evidence *v, char *text, size_t size)
{
    for (int f = 0; f < v->count; f++)
        for (int k = 0; k < 8; k += 2) {
            const double re = v->exact[f][k], im = v->exact[f][k + 1];
            if (v->section->method != METHOD_ROOTS || hypot(v->y[f][k] - re, v->y[f][k + 1] - fabs(im)) > 1e-6 * hypot(re, im))
                return;
        }
    snprintf(text, size, "conjugates are missing: the imaginary parts have lost their signs");
}

bool kind_of_formula(const struct evidence *v, char *text, size_t size)
{
    static void (*const kinds[])(const struct evidence *, char *, size_t) = {lost_conjugates, wrong_outputs, fixed_decimals, permuted_outputs,
                                                                            constant_factor};
    int wrong = 0;
    bool differ = true;
    for (int f = 0; f < v->count; f++) {
        bool right = true;
        for (int k = 0; k < v->section->output_count; k++)
            right = right && is_same(v->y[f][k], v->exact[f][k]);
        wrong += !right;
    }
    for (int i = 0; i < v->section->input_count; i++) {
        bool same = true;
        for (int f = 1; f < v->count; f++)
            same = same && v->x[f][i] == v->x[0][i];
        differ = differ && !same;
    }
    if (wrong < 2 || !differ)
        return false;
    for (size_t i = 0; i < sizeof kinds / sizeof *kinds && *text == '\0'; i++)
        kinds[i](v, text, size);
    return true;
}
