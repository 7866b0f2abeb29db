#include "conform/kinds.h"

#include <gsl/gsl_linalg.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "evaluate/domain.h"
#include "text/scope.h"

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

/* Whether an output is so in every vector. */
static bool is_always(const struct evidence *v, int k, bool (*so)(double y, double exact))
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

/* ---- a factor ---- */

/* Quotients of answers and truths, one a vector; of a vector with zeros alone where they are due there is none. */
struct quotients {
    int count;
    int vectors[MOST_EVIDENCE];
    double values[MOST_EVIDENCE];
};

/* Outputs that are wrong in some vector must all have one quotient in each; false where there are several in one. */
static bool quotients_of(struct quotients *q, const struct evidence *v)
{
    bool wrong[MOST_OUTPUTS];
    q->count = 0;
    for (int k = 0; k < v->section->output_count; k++)
        wrong[k] = !is_always(v, k, is_same);
    for (int f = 0; f < v->count; f++) {
        bool first = true;
        for (int k = 0; k < v->section->output_count; k++) {
            const double quotient = v->y[f][k] / v->exact[f][k];
            if (!wrong[k] || (v->y[f][k] == 0.0 && v->exact[f][k] == 0.0))
                continue;
            if (v->exact[f][k] == 0.0 || !isnormal(quotient) || (!first && !is_same(quotient, q->values[q->count])))
                return false;
            q->values[q->count] = quotient;
            first = false;
        }
        q->vectors[q->count] = f;
        q->count += !first;
    }
    return q->count > 1;
}

/* Whether an input is not the same in all vectors. */
static bool input_differs(const struct evidence *v, int i)
{
    bool differs = false;
    for (int f = 1; f < v->count; f++)
        differs = differs || v->x[f][i] != v->x[0][i];
    return differs;
}

static bool constant_factor(const struct quotients *q, char *text, size_t size)
{
    static const struct {
        double factor;
        const char *name;
    } known[] = {{57.295779513082320877, "180/pi, degrees for radians"}, {0.017453292519943295769, "pi/180, radians for degrees"},
                 {6.2831853071795864769, "2 pi"}, {0.15915494309189533577, "1/(2 pi)"}, {3.14159265358979323846, "pi"}};
    const double factor = q->values[0];
    for (int f = 1; f < q->count; f++)
        if (!is_same(q->values[f], factor))
            return false;
    if (fabs(factor) < 1.0 && is_same(round(1.0 / factor), 1.0 / factor))
        snprintf(text, size, "a constant factor %s1/%.10g", factor < 0.0 ? "-" : "", fabs(1.0 / factor));
    else
        snprintf(text, size, "a constant factor %.10g", factor);
    for (size_t i = 0; i < sizeof known / sizeof *known; i++)
        if (is_same(factor, known[i].factor))
            snprintf(text, size, "a constant factor %s", known[i].name);
    return true;
}

/* What a product of powers is made of: a constant, the inputs above zero that differ from vector to vector, and the sum of the masses. */
enum { MOST_BASES = MOST_INPUTS + 2 };
struct bases {
    int count;
    char names[MOST_BASES][40];
    double logs[MOST_EVIDENCE][MOST_BASES];
};

static void bases_of(struct bases *b, const struct evidence *v, const struct quotients *q)
{
    const int m1 = input_place(v->section, "m1"), m2 = input_place(v->section, "m2");
    b->count = 1;
    for (int f = 0; f < q->count; f++)
        b->logs[f][0] = 1.0;
    for (int i = 0; i <= v->section->input_count; i++) {
        const bool sum = i == v->section->input_count;
        bool fits = !sum || (m1 >= 0 && m2 >= 0), differs = false;
        for (int f = 0; f < q->count && fits; f++) {
            const double *inputs = v->x[q->vectors[f]], x = sum ? inputs[m1] + inputs[m2] : inputs[i];
            b->logs[f][b->count] = log(x);
            fits = x > 0.0 && isfinite(x);
            differs = differs || !is_same(b->logs[f][b->count], b->logs[0][b->count]);
        }
        if (fits && differs)
            snprintf(b->names[b->count++], sizeof *b->names, "%s", sum ? "(m1 + m2)" : v->section->inputs[i]->name);
    }
}

/* Least squares: the power of each base. False where there are too few vectors. */
static bool fit_powers(const struct bases *b, const double *logs, int count, double *powers)
{
    if (count <= b->count)
        return false;
    double rows[MOST_EVIDENCE][MOST_BASES], scales[MOST_BASES], residuals[MOST_EVIDENCE];
    const size_t columns = (size_t)b->count;
    memcpy(rows, b->logs, sizeof rows);
    gsl_matrix_view A = gsl_matrix_view_array_with_tda(*rows, (size_t)count, columns, MOST_BASES);
    gsl_vector_view tau = gsl_vector_view_array(scales, columns), x = gsl_vector_view_array(powers, columns);
    gsl_vector_view residual = gsl_vector_view_array(residuals, (size_t)count);
    gsl_vector_const_view y = gsl_vector_const_view_array(logs, (size_t)count);
    return gsl_linalg_QR_decomp(&A.matrix, &tau.vector) == GSL_SUCCESS &&
           gsl_linalg_QR_lssolve(&A.matrix, &tau.vector, &y.vector, &x.vector, &residual.vector) == GSL_SUCCESS;
}

/* Those bases with a power of that sign, as a product. */
static void product_text(const struct bases *b, const double *powers, double sign, char *text, size_t size)
{
    *text = '\0';
    for (int i = 1; i < b->count; i++) {
        char word[60];
        const double power = sign * powers[i];
        if (power <= 0.0)
            continue;
        snprintf(word, sizeof word, power == 1.0 ? "%s" : "%s^%g", b->names[i], power);
        add_text(text, size, " ", word);
    }
    if (*text == '\0')
        snprintf(text, size, "1");
}

/* A constant, or a product of powers, halves among them, and of a constant: too much, or missing. */
static void factor(const struct evidence *v, char *text, size_t size)
{
    struct bases b;
    struct quotients q;
    double logs[MOST_EVIDENCE] = {0.0}, powers[MOST_BASES], first = 0.0;
    char above[120], below[120], number[40] = "";
    bool differ = true; /* else what is the same in all may be what the factor is made of */
    for (int i = 0; i < v->section->input_count; i++)
        differ = differ && input_differs(v, i);
    if (!differ || !quotients_of(&q, v) || constant_factor(&q, text, size))
        return;
    bases_of(&b, v, &q);
    for (int f = 0; f < q.count; f++)
        logs[f] = log(fabs(q.values[f]));
    if (!fit_powers(&b, logs, q.count, powers))
        return;
    for (int i = b.count - 1; i >= 1; i--) {
        powers[i] = round(2.0 * powers[i]) / 2.0;
        first = powers[i] != 0.0 ? powers[i] : first;
    }
    for (int f = 0; f < q.count; f++)
        for (int i = 1; i < b.count; i++)
            logs[f] -= powers[i] * b.logs[f][i];
    for (int f = 0; f < q.count; f++)
        if (fabs(logs[f] - logs[0]) > 1e-8 || first == 0.0)
            return;
    const double sign = first < 0.0 ? -1.0 : 1.0, constant = exp(sign * logs[0]);
    product_text(&b, powers, sign, above, sizeof above);
    product_text(&b, powers, -sign, below, sizeof below);
    if (!is_same(constant, 1.0))
        snprintf(number, sizeof number, "%.10g ", constant);
    const char *over = strcmp(below, "1") == 0 ? "" : strchr(below, ' ') != NULL && *below != '(' ? "/(" : "/";
    snprintf(text, size, "a factor %s%s%s%s%s %s", number, above, over, *over ? below : "", over[strspn(over, "/")] ? ")" : "",
             sign < 0.0 ? "is missing" : "too many");
}

/* ---- other inputs ---- */

/* Whether the operation makes of these inputs what was answered, in every vector. */
static bool explain(const struct evidence *v, const double inputs[MOST_EVIDENCE][MOST_INPUTS])
{
    INPUTS(read);
    VECTOR(arb, other, MOST_OUTPUTS);
    bool same = true;
    for (int f = 0; f < v->count && same; f++) {
        same = clock() < v->until && inputs_of_values(v->section, inputs[f], read) && operation_valid(v->operation, read) &&
               operation_enclose(v->operation, read, 128, other) == OPERATION_PROVED;
        for (int k = 0; k < v->section->output_count && same; k++)
            same = is_same(v->y[f][k], arf_get_d(arb_midref(other + k), ARF_RND_NEAR));
    }
    return same;
}

/*
 * Two inputs exchanged, or one of them off by one, or with a factor that it should not have: an input stands for a whole term where
 * it stands in one alone.
 */
static void other_inputs(const struct evidence *v, char *text, size_t size)
{
    enum { OFF_BY_ONE = 2, WITHOUT_MASSES = 7 };
    static const char *const names[] = {"+", "-", "-1", "2", "1/2", "3", "1/3", "m1 m2/(m1 + m2)", "(m1 + m2)/(m1 m2)", "(m1 m2/(m1 + m2))^2",
                                        "((m1 + m2)/(m1 m2))^2", "m1/m2", "m2/m1"};
    const struct section *s = v->section;
    const int m1 = input_place(s, "m1"), m2 = input_place(s, "m2"), kinds = m1 >= 0 && m2 >= 0 ? sizeof names / sizeof *names : WITHOUT_MASSES;
    double inputs[MOST_EVIDENCE][MOST_INPUTS];
    for (int i = 0; i < s->input_count * (s->input_count + kinds) && *text == '\0'; i++) {
        const int at = i % s->input_count, other = i / s->input_count, kind = other - s->input_count;
        if (other <= at || (kind >= 0 && kind < OFF_BY_ONE && !input_differs(v, at)))
            continue;
        memcpy(inputs, v->x, sizeof inputs);
        for (int f = 0; f < v->count; f++) {
            const double *x = v->x[f], is = x[at], a = m1 >= 0 ? x[m1] : 1.0, b = m2 >= 0 ? x[m2] : 1.0, M = a * b / (a + b);
            const double all[] = {is + 1.0, is - 1.0, -is, 2.0 * is, 0.5 * is, 3.0 * is, is / 3.0, is * M, is / M, is * M * M, is / (M * M),
                                  is * a / b, is * b / a};
            inputs[f][at] = kind < 0 ? x[other] : all[kind];
            if (kind < 0)
                inputs[f][other] = is;
        }
        if (!explain(v, (const double(*)[MOST_INPUTS])inputs))
            continue;
        if (kind < 0)
            snprintf(text, size, "the inputs %s and %s exchanged", s->inputs[at]->name, s->inputs[other]->name);
        else if (kind < OFF_BY_ONE)
            snprintf(text, size, "%s %s 1 in place of %s", s->inputs[at]->name, names[kind], s->inputs[at]->name);
        else
            snprintf(text, size, "%s with a factor %s too many", s->inputs[at]->name, names[kind]);
    }
}

/* ---- roots ---- */

/* Whether four complex numbers are these roots, times a factor, in whatever order; of the imaginary parts perhaps the sizes alone. */
static bool are_roots(const double *y, const double *exact, double factor, bool sizes)
{
    unsigned taken = 0;
    for (int k = 0; k < 8; k += 2) {
        int found = -1;
        for (int i = 0; i < 8 && found < 0; i += 2) {
            const double im = sizes ? fabs(exact[i + 1]) : exact[i + 1];
            const double off = hypot(y[k] - factor * exact[i], y[k + 1] - factor * im);
            found = (taken & 1U << i) == 0 && off <= 1e-6 * factor * hypot(exact[i], exact[i + 1]) ? i : -1;
        }
        if (found < 0)
            return false;
        taken |= 1U << found;
    }
    return true;
}

static void kind_of_roots(const struct evidence *v, char *text, size_t size)
{
    bool sizes = true, scaled = true;
    for (int f = 0; f < v->count; f++) {
        sizes = sizes && are_roots(v->y[f], v->exact[f], 1.0, true);
        scaled = scaled && are_roots(v->y[f], v->exact[f], 1.0 / v->x[f][input_place(v->section, "Omega")], false);
    }
    if (sizes)
        snprintf(text, size, "conjugates are missing: the imaginary parts have lost their signs");
    else if (scaled)
        snprintf(text, size, "in units of Omega: a factor Omega is missing");
}

void kind_of_formula(const struct evidence *v, char *text, size_t size)
{
    static void (*const kinds[])(const struct evidence *, char *, size_t) = {wrong_outputs, fixed_decimals, permuted_outputs,
                                                                            factor, other_inputs};
    int wrong = 0;
    *text = '\0';
    for (int f = 0; f < v->count; f++) {
        bool right = true;
        for (int k = 0; k < v->section->output_count; k++)
            right = right && is_same(v->y[f][k], v->exact[f][k]);
        wrong += !right;
    }
    if (wrong < 2) /* the others have lost digits alone */
        return;
    if (v->section->method == METHOD_ROOTS)
        kind_of_roots(v, text, size);
    for (size_t i = 0; i < sizeof kinds / sizeof *kinds && *text == '\0'; i++)
        kinds[i](v, text, size);
}
