/* Vectors: what is certified, counted, flagged; and ref/ against it. */
#include "tests/run.h"
#include "tests/paper.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "evaluate/domain.h"
#include "evaluate/errors.h"
#include "evaluate/reference.h"
#include "evaluate/sample.h"
#include "evaluate/vectors.h"
#include "text/csv.h"
#include "text/scope.h"

/* Largest E of ref/ that a test lets pass, and why: see worst_error_of_ref_stays_below_the_bound. */
enum { BOUND = 8, INPUTS = 60, SEED = 1 }; /* `verify errors`, which make check runs, takes 1000 */

static const struct section *operation_at(int i)
{
    return &sheet()->sections[i];
}

/*
 * A formula of k operations, each of relative error u, has E <= k to first order; the longest of the
 * sheet has some thirty, but rounding errors rarely agree: the worst of 10^5 inputs is 4.0, in eq02
 * (make errors). 8 leaves room for another libm's sin, cos and exp, and catches three lost bits.
 */
EACH(worst_error_of_ref_stays_below_the_bound, sheet()->section_count)
{
    const struct section *s = operation_at(_i);
    struct measured m;
    if (!operation_has_sensitivity(s))
        return;
    measure_errors(&m, s, INPUTS, SEED);
    ck_assert_msg(m.worst > 0.0 && m.worst <= BOUND, "%s: E = %g at %ld", s->id, m.worst, m.index);
    ck_assert_msg(m.outside == 0, "%s: %ld MPFR values outside the ball", s->id, m.outside);
}

EACH(every_operation_has_a_reference, sheet()->section_count)
{
    const struct section *s = operation_at(_i);
    ck_assert_double_eq(s->K, BOUND); /* what the oracle asks of others is what is asked here of ref/ */
    ck_assert_msg((reference_find(s->id) != NULL) == (s->method != METHOD_NONE), "%s", s->id);
}

/*
 * (38): S = |GM dOmega/dGM| + |R_c dOmega/dR_c| = (1/2 + 3/2) Omega. (2) with uncharged craft: x1_ddot = 2 Omega y1_dot +
 * 3 Omega^2 x1, S = 4 Omega |y1_dot| + 9 Omega^2 |x1|, to which an infinite lambda_d adds nothing.
 */
EACH(a_sensitivity_sums_what_each_input_does, 2)
{
    static const struct {
        const char *id;
        double values[30];
        slong S;
    } cases[] = {{"eq38", {4, 1}, 4},
                 {"eq02", {2, 1, INFINITY, 1, 0, 3, 0, 0, 0, 5, 0, 1, 0, 0, 4, 0, 0, 0, 0, 1, 0, 9, 0, 0, 0, 0, 0}, 40 + 108}};
    const struct section *s = section_find(sheet(), cases[_i].id);
    VECTOR(arb, S, MOST_OUTPUTS);
    INPUTS(inputs);
    OPERATION(o, s);
    ck_assert(inputs_of_values(s, cases[_i].values, inputs) && operation_valid(&o, inputs));
    for (int exact = 0; exact < 2; exact++) {
        if (exact)
            operation_sensitivity_exact(&o, inputs, 64, 0, S);
        else
            operation_sensitivity(&o, inputs, 64, S);
        ck_assert(arb_contains_si(S, cases[_i].S) && arb_rel_accuracy_bits(S) > 50);
    }
}

TEST(a_sample_depends_on_seed_and_index_alone)
{
    const struct section *s = section_find(sheet(), "eq27");
    INPUTS(inputs);
    double first[4], again[4], other[4], seeded[4];
    OPERATION(o, s);
    sample(&o, 7, 3, first, inputs);
    sample(&o, 7, 4, other, inputs);
    sample(&o, 8, 3, seeded, inputs);
    sample(&o, 7, 3, again, inputs);
    ck_assert_mem_eq(first, again, sizeof first);
    ck_assert_mem_ne(first, other, sizeof first);
    ck_assert_mem_ne(first, seeded, sizeof first);
}

TEST(samples_lie_in_their_ranges)
{
    const struct section *s = section_find(sheet(), "eq02");
    INPUTS(inputs);
    double values[40];
    int negative = 0;
    OPERATION(o, s);
    for (uint64_t k = 0; k < 200; k++) {
        sample(&o, 1, k, values, inputs);
        for (int i = 0; i < s->input_count; i++) {
            const struct quantity *q = s->inputs[i];
            ck_assert(fabs(values[i]) >= q->low && fabs(values[i]) <= q->high);
            ck_assert(values[i] > 0.0 || q->either_sign);
            negative += values[i] < 0.0;
        }
    }
    ck_assert_int_gt(negative, 200 * 8); /* of 200 * 21 signed ones about half */
}

/*
 * A sheet's operation is valid where ref/ gives numbers, and nowhere else. So few values make craft meet, angles vanish
 * and n reach 9 by themselves, and every sign turn up. Flows stay where they begin, for craft may meet on the way.
 */
CASE(domains, NULL, NULL)

EACH(domain_of_the_sheet_is_that_of_ref, sheet()->section_count)
{
    static const double values[] = {-9, -2, -1, 0, 1, 2, 9, 9.000000000000002, 1, -1};
    const struct section *s = &sheet()->sections[_i];
    const bool flow = s->method == METHOD_FLOW_LINEAR || s->method == METHOD_FLOW_NONLINEAR;
    const bool motion = s->method != METHOD_FORMULA && s->method != METHOD_ROOTS;
    uint64_t random = 1;
    if (s->method == METHOD_NONE)
        return;
    INPUTS(inputs);
    OPERATION(o, s);
    for (int k = 0; k < 6000; k++) {
        double in[40], out[16] = {0};
        for (int i = 0; i < s->input_count; i++) {
            random = random * UINT64_C(6364136223846793005) + 1442695040888963407; /* Knuth's */
            in[i] = values[(random >> 33) % (sizeof values / sizeof *values)];
            if (!motion && in[i] == -9 && s->inputs[i]->domain == DOMAIN_POSITIVE_OR_INFINITE)
                in[i] = INFINITY;
            if (flow && strcmp(s->inputs[i]->name, "t") == 0)
                in[i] = 0;
            if (s->inputs[i]->domain != DOMAIN_FINITE && random % 16 != 0)
                in[i] = fabs(in[i]);
            inputs[i].infinite = isinf(in[i]);
            fmpq_set_double(&inputs[i].value, isinf(in[i]) ? 1 : in[i]);
        }
        reference_find(s->id)(in, out);
        ck_assert_msg(operation_valid(&o, inputs) != (bool)isnan(out[0]), "%s: %s, ref/ gives %g", s->id,
                      isnan(out[0]) ? "valid" : o.why.text, out[0]);
    }
}

/* Beside the edge by 2^-200, on it, and beyond, where balls of 128 bits hold all three: Q_ref + dQ < 0, n >= 9, craft apart. */
EACH(a_condition_is_decided_however_near_its_edge, 9)
{
    static const struct {
        const char *id;
        slong at_edge[6];
        int moved;
        bool valid[3];
    } edges[] = {{"eq21", {-1, 1}, 1, {true, false, false}}, {"eq44", {1, 9}, 1, {false, true, true}},
                 {"eq12", {1, 2, 3, 1, 2, 3}, 4, {true, false, true}}};
    const struct section *s = section_find(sheet(), edges[_i / 3].id);
    SCOPE(fmpq, step);
    INPUTS(inputs);
    OPERATION(o, s);
    for (int i = 0; i < s->input_count; i++)
        fmpq_set_si(&inputs[i].value, edges[_i / 3].at_edge[i], 1);
    fmpq_set_si(step, _i % 3 - 1, 1);
    fmpq_div_2exp(step, step, 200);
    fmpq_add(&inputs[edges[_i / 3].moved].value, &inputs[edges[_i / 3].moved].value, step);
    ck_assert_msg(operation_valid(&o, inputs) == edges[_i / 3].valid[_i % 3], "%s", s->id);
}

/*
 * Each in its rotation: a condition just violated, a value outside, a time between Runge-Kutta steps. What the program enforces
 * stands in the sheet: for whatever reason it refuses a defect, the text is a condition of the
 * operation, or the domain of an input; and of the methods it refuses a time between steps by the text that says so.
 */
EACH(a_defect_is_refused_by_a_text_of_the_sheet, sheet()->section_count)
{
    const struct section *s = operation_at(_i);
    double values[MOST_INPUTS];
    bool between = false;
    if (s->method == METHOD_NONE)
        return;
    INPUTS(inputs);
    OPERATION(o, s);
    for (uint64_t k = 0; k < 64; k++) {
        bool said = false;
        sample(&o, SEED, k, values, inputs);
        domain_defect(&o, k, values);
        if (!inputs_of_values(s, values, inputs))
            continue;
        ck_assert(operation_digits(&o, inputs, 1, NULL) == OPERATION_INVALID && !operation_valid(&o, inputs));
        const char *reason = strstr(o.why.text, ": expected ");
        for (int c = 0; c < s->corrected.count && reason != NULL; c++)
            said = said || strcmp(reason + strlen(": expected "), s->corrected.conditions[c].text) == 0;
        for (int i = 0; i < s->input_count; i++) {
            char text[128];
            snprintf(text, sizeof text, "%s: outside its domain, %s", s->inputs[i]->name, domain_names[s->inputs[i]->domain]);
            said = said || strcmp(o.why.text, text) == 0;
        }
        ck_assert_msg(said, "%s: %s", s->id, o.why.text);
        between = between || (reason != NULL && strcmp(reason, ": expected t/h an integer") == 0);
    }
    ck_assert_int_eq(between, s->method >= METHOD_RK4_LINEAR);
}

/*
 * Outputs in one digit, at a tie or beside it, which enclosures of 1/3 never tell, and of what is irrational only with many bits: x2 of
 * (5) is -4.5/3, L_ddot of (15) 6 - 1/2 and 6 - 6, Omega of (38) sqrt(6.25 +- 2^-200). At C1 = 9 Omega^2, C2 = 0 (41) is
 * s^2 (s^2 + 7 Omega^2), and Omega 2.5/sqrt(7), but for 2^-200, a little more. At C1 = 8 Omega^2, C2 = Omega it is
 * (s + Omega) (s^3 + 6 Omega^2 s - 3 Omega^3): of four roots the first is a tie, and rational alone.
 */
EACH(digits_are_decided_at_a_tie_and_beside_it, 7)
{
    static const struct {
        const char *id;
        double values[8];
        int moved; /* by 2^-200 */
        const char *outputs[8];
    } cases[] = {{"eq05", {1, 2, 4.5}, 0, {"3e+00", "-2e+00"}},           {"eq15", {1, 1, 3, 3, 2, 0, -3}, 0, {"6e+00"}},
                 {"eq15", {1, 1, 3, 3, 2, 0, -36}, 0, {"0"}},             {"eq38", {6.25, 1}, 1, {"3e+00"}},
                 {"eq38", {6.25, 1}, -1, {"2e+00"}},                      {"eq41roots", {1, 9, 0}, 1, {"0", "-3e+00", "0", "0", "0", "0", "0", "3e+00"}},
                 {"eq41roots", {2.5, 50, 2.5}, 0, {"-2e+00", "0", "-6e-01", "-6e+00", "-6e-01", "6e+00", "1e+00", "0"}}};
    const struct section *s = section_find(sheet(), cases[_i].id);
    INPUTS(inputs);
    char *outputs[MOST_OUTPUTS];
    SCOPE(fmpq, step);
    SCOPE(fmpz, root);
    OPERATION(o, s);
    ck_assert(inputs_of_values(s, cases[_i].values, inputs));
    fmpq_set_si(step, cases[_i].moved, 1);
    fmpq_div_2exp(step, step, 200);
    fmpq_add(&inputs[0].value, &inputs[0].value, step);
    if (s->method == METHOD_ROOTS && cases[_i].moved != 0) { /* 2.5/sqrt(7) = sqrt(6.25/7) in units of 2^-200, the next of them, and C1 */
        fmpz_one_2exp(root, 398);
        fmpz_mul_ui(root, root, 25);
        fmpz_fdiv_q_ui(root, root, 7);
        fmpz_sqrt(root, root);
        fmpz_add_ui(root, root, 1);
        fmpq_set_fmpz(step, root);
        fmpq_div_2exp(&inputs[0].value, step, 200);
        fmpq_mul(step, &inputs[0].value, &inputs[0].value);
        fmpq_mul_si(&inputs[1].value, step, 9);
    }
    ck_assert_int_eq(operation_digits(&o, inputs, 1, outputs), OPERATION_PROVED);
    for (int i = 0; i < s->output_count; i++) {
        ck_assert_pstr_eq(outputs[i], cases[_i].outputs[i]);
        free(outputs[i]);
    }
}

/* ---- the program's vectors ---- */

static char *printed(const char *arguments)
{
    static char text[1 << 20];
    char line[256];
    snprintf(line, sizeof line, "\"$CT_PROGRAM\" vectors %s", arguments);
    FILE *pipe = popen(line, "r");
    ck_assert_ptr_nonnull(pipe);
    size_t length = fread(text, 1, sizeof text - 1, pipe);
    text[length] = '\0';
    ck_assert_int_eq(pclose(pipe), 0);
    return text;
}

CASE(vectors, NULL, NULL)

TEST(four_shards_are_one_run)
{
    char *whole = text_copy(printed("eq14 --count 11 --seed 5")), *end = whole;
    for (int k = 1; k <= 4; k++) {
        char arguments[64];
        snprintf(arguments, sizeof arguments, "eq14 --count 11 --seed 5 --shard %d/4", k);
        const char *part = printed(arguments);
        ck_assert_int_eq(strncmp(end, part, strlen(part)), 0);
        end += strlen(part);
    }
    ck_assert_int_eq(*end, '\0');
    free(whole);
}

/* Header, numbers, sensitivities and flags, to the byte: of a formula, of roots and of a motion, inside and outside. */
EACH(golden_vectors_are_printed_as_the_files_have_them, 4)
{
    static const char *const ids[] = {"eq02", "eq21", "eq41roots", "flow_linear"};
    static char due[1 << 20];
    char arguments[64], path[64];
    snprintf(arguments, sizeof arguments, "%s --golden", ids[_i]);
    snprintf(path, sizeof path, "data/golden/%s.csv", ids[_i]);
    FILE *file = fopen(path, "r");
    ck_assert_ptr_nonnull(file);
    due[fread(due, 1, sizeof due - 1, file)] = '\0';
    fclose(file);
    ck_assert_str_eq(printed(arguments), due);
}

TEST(a_seed_has_64_bits)
{
    ck_assert_ptr_nonnull(strstr(printed("eq43 --count 1 --seed 18446744073709551615"), "\neq43-18446744073709551615-0,"));
}

/* Whether two rows of inputs differ in one number alone, and in that by what rounding an edge takes. */
static bool are_neighbours(const double *a, const double *b, int count)
{
    int others = 0;
    bool near = true;
    for (int i = 0; i < count; i++)
        if (a[i] != b[i]) {
            others++;
            near = near && fabs(a[i] - b[i]) <= 0x1p-48 * fmax(1, fabs(a[i]));
        }
    return others == 1 && near;
}

enum { MOST_ROWS = 400 };

/* The inputs and outputs of a section's golden vectors, no numbers where it has none; how many vectors there are */
static int golden_rows(const struct section *s, double row[MOST_ROWS][MOST_INPUTS + MOST_OUTPUTS])
{
    struct message why;
    char path[64];
    int rows = 0;
    snprintf(path, sizeof path, "data/golden/%s.csv", s->id);
    FILE *file = fopen(path, "r");
    ck_assert_ptr_nonnull(file);
    struct csv c = csv_on(file, path, 100000);
    ck_assert_int_eq(csv_next(&c, &why), CSV_ROW);
    for (; csv_next(&c, &why) == CSV_ROW; rows++)
        for (int i = 0; i < s->input_count + s->output_count; i++)
            row[rows][i] = *c.cells[1 + i] != '\0' ? strtod(c.cells[1 + i], NULL) : NAN;
    csv_clear(&c);
    fclose(file);
    return rows;
}

/*
 * Every condition is asked by a golden vector that it alone refuses, and by a neighbour of it that is inside. A motion's is
 * asked from outside: a whole step lies between, or craft so near that no motion is followed.
 */
EACH(every_condition_is_asked_from_just_outside_and_just_inside, sheet()->section_count)
{
    static double row[MOST_ROWS][MOST_INPUTS + MOST_OUTPUTS];
    const struct section *s = operation_at(_i);
    if (s->method == METHOD_NONE)
        return;
    const int rows = golden_rows(s, row);
    OPERATION(o, s);
    const struct formulas whole = *o.formulas;
    INPUTS(inputs);
    for (int k = 0; k < whole.count; k++) {
        struct formulas without = whole;
        struct condition others[16];
        bool valid[MOST_ROWS], refused[MOST_ROWS], asked = false;
        ck_assert_int_le(whole.count, 16);
        without.conditions = others;
        without.count = 0;
        for (int i = 0; i < whole.count; i++)
            if (i != k)
                others[without.count++] = whole.conditions[i];
        for (int r = 0; r < rows; r++) {
            const bool numbers = inputs_of_values(s, row[r], inputs);
            o.formulas = &whole;
            valid[r] = numbers && operation_valid(&o, inputs);
            o.formulas = &without;
            refused[r] = numbers && !valid[r] && operation_valid(&o, inputs);
        }
        for (int r = 0; r < rows && !asked; r++)
            for (int i = 0; i < rows && refused[r] && !asked; i++)
                asked = !operation_has_sensitivity(s) || (valid[i] && are_neighbours(row[r], row[i], s->input_count));
        ck_assert_msg(asked, "%s: %s", s->id, whole.conditions[k].text);
    }
}

/* 0.1 and the least number above zero in full, by hand: 3602879701896397/2^55 and 2^-1074. */
static const struct {
    const char *literal;
    enum input_form form;
    const char *written;
} forms[] = {
    {"0.1", INPUTS_SHORTEST, "0.1"},
    {"0.1", INPUTS_EXACT, "0.1000000000000000055511151231257827021181583404541015625"},
    {"0.1", INPUTS_HEX, "0x1.999999999999ap-4"},
    {"8.99e+9", INPUTS_EXACT, "8990000000"},
    {"-150", INPUTS_HEX, "-0x1.2cp+7"},
    {"0", INPUTS_HEX, "0x0p+0"},
    {"nan", INPUTS_HEX, "nan"},
    {"inf", INPUTS_EXACT, "inf"},
    {"1e400", INPUTS_EXACT, "1e400"},
};

EACH(inputs_are_written_in_every_form, COUNT(forms))
{
    char text[LONGEST_INPUT];
    input_write(text, forms[_i].literal, forms[_i].form);
    ck_assert_str_eq(text, forms[_i].written);
}

TEST(the_longest_input_has_all_its_digits)
{
    char text[LONGEST_INPUT], exponent[] = "e-308";
    input_write(text, "2.2250738585072009e-308", INPUTS_EXACT); /* the largest number below the normal ones */
    const size_t length = strlen(text);
    ck_assert_uint_eq(length, 767 + strlen(".") + strlen(exponent));
    ck_assert_str_eq(text + length - strlen(exponent), exponent);
    ck_assert(strtod(text, NULL) == 2.2250738585072009e-308);
}

/*
 * Omega^2 of (43), and n times that, at the least and the greatest normal numbers, 2^-1022 and 2^1024 (of floats 2^-126 and 2^128), and
 * beside them. m1 m2/(m1 + m2) L^2 of (32): m1 m2 is 1e-400, or 1e-160, inside the range if not far; or all is 1e310, and no part of it.
 */
EACH(the_normal_range_is_that_of_the_format, 15)
{
    static const struct {
        const char *id, *texts[3];
        int significand;
        bool leaves;
    } edges[] = {
        {"eq43", {"0x1p-511", "1"}, BINARY64, false}, {"eq43", {"0x1.fffffffffffffp-512", "1"}, BINARY64, true},
        {"eq43", {"0x1.fffffffffffffp511", "1"}, BINARY64, false}, {"eq43", {"0x1p512", "1"}, BINARY64, true},
        {"eq43", {"0x1p-63", "1"}, BINARY32, false}, {"eq43", {"0x1.fffffffffffffp-64", "1"}, BINARY32, true},
        {"eq43", {"0x1.fffffffffffffp63", "1"}, BINARY32, false}, {"eq43", {"0x1p64", "1"}, BINARY32, true},
        {"eq43", {"0x1p-512", "1"}, BINARY128, false}, {"eq43", {"0x1p512", "1"}, BINARY128, false},
        {"eq43", {"0x1p-510", "0.25"}, BINARY64, false}, {"eq43", {"0x1p-510", "0.125"}, BINARY64, true},
        {"eq32", {"1e-200", "1e-200", "1e100"}, BINARY64, true}, {"eq32", {"1e-80", "1e-80", "1e80"}, BINARY64, false},
        {"eq32", {"2e10", "2e10", "1e150"}, BINARY64, true},
    };
    const struct section *s = section_find(sheet(), edges[_i].id);
    INPUTS(inputs);
    OPERATION(o, s);
    ck_assert(vector_read(s, edges[_i].texts, inputs));
    ck_assert_msg(vector_leaves_range(&o, inputs, edges[_i].significand) == edges[_i].leaves, "%s", edges[_i].texts[0]);
}

/* Of quadruple precision the least is 2^-16382, which no power of binary64 reaches: exp(-11355) in (2) is 2^-16381.8, exp(-11355.5) 2^-16382.5. */
EACH(the_normal_range_of_quadruple_precision_is_its_own, 2)
{
    double values[MOST_INPUTS] = {1, 1e10, 1, 1, 1e9, 0, 0, 0, 0, 0, 0, 1, 1e9, _i == 0 ? 11355 : 11355.5, 0, 0, 0, 0, 0, 1, 0, 5000};
    const struct section *s = section_find(sheet(), "eq02");
    INPUTS(inputs);
    OPERATION(o, s);
    ck_assert(inputs_of_values(s, values, inputs) && operation_valid(&o, inputs));
    ck_assert_int_eq(vector_leaves_range(&o, inputs, BINARY128), _i);
}

/* ---- golden files ---- */

/* The next line has that id, those inputs as they are written, and ends with those flags. Nothing is computed. */
static bool is_next_line(void *context, struct operation *o, const char *id, const char *const *texts, const char *flags)
{
    char line[4096], due[2048];
    int used = snprintf(due, sizeof due, "%s", id);
    for (int i = 0; i < o->section->input_count; i++)
        used += snprintf(due + used, sizeof due - (size_t)used, ",%s", schema_text(texts[i]));
    ck_assert_msg(fgets(line, sizeof line, context) != NULL, "%s is not in the file", id);
    line[strcspn(line, "\n")] = '\0';
    ck_assert_msg(strncmp(line, due, (size_t)used) == 0 && line[used] == ',', "expected %s in the line %s", due, line);
    ck_assert_msg(strlen(line) >= strlen(flags) && strcmp(line + strlen(line) - strlen(flags), flags) == 0, "%s: expected %s", id, flags);
    return true;
}

CASE(golden, NULL, NULL)

EACH(golden_files_have_these_inputs, sheet()->section_count)
{
    const struct section *s = operation_at(_i);
    char name[80], line[4096];
    if (s->method == METHOD_NONE)
        return;
    snprintf(name, sizeof name, "data/golden/%s.csv", s->id);
    FILE *file = fopen(name, "r");
    ck_assert_msg(file != NULL && fgets(line, sizeof line, file) != NULL, "%s", name);
    golden_each(s, is_next_line, file);
    ck_assert_msg(fgets(line, sizeof line, file) == NULL, "%s has more: %s", name, line);
    fclose(file);
}

/* ---- motions ---- */

CASE(motions, NULL, flint_cleanup)

/* At rest in the equilibrium, of unequal masses, a third of a metre from the centre, which no ball has: exact, forever. */
TEST(an_equilibrium_is_exact)
{
    const struct section *s = section_find(sheet(), "flow_nonlinear");
    const char *texts[] = {"7.2915e-5", "8.99e+9", "100", "200", "0.5", "5e-8", "1e-4", "123456", "0", "0", "0", "0", "0", "0"};
    char *outputs[MOST_OUTPUTS];
    INPUTS(inputs);
    OPERATION(o, s);
    ck_assert(vector_read(s, texts, inputs));
    fmpq_set_si(&inputs[input_place(s, "x1_0")].value, 1, 3);
    ck_assert_msg(operation_digits(&o, inputs, 40, outputs) == OPERATION_PROVED, "%s", o.why.text);
    for (int i = 0; i < s->output_count; i++) {
        ck_assert_double_eq(strtod(outputs[i], NULL), i == 0 ? 1.0 / 3 : 0);
        free(outputs[i]);
    }
}

/* Of every motion the paper's case, and the last golden vector that is inside, to ten digits of what data/golden has to forty. */
EACH(motions_are_those_of_the_golden_vectors, 2 * sheet()->section_count)
{
    static double row[MOST_ROWS][MOST_INPUTS + MOST_OUTPUTS];
    const struct section *s = operation_at(_i / 2);
    char *outputs[MOST_OUTPUTS];
    int which = 0;
    if (s->method < METHOD_FLOW_LINEAR)
        return;
    for (int k = 1, rows = golden_rows(s, row); _i % 2 == 1 && k < rows; k++)
        which = isnan(row[k][s->input_count]) ? which : k;
    INPUTS(inputs);
    OPERATION(o, s);
    ck_assert(inputs_of_values(s, row[which], inputs));
    ck_assert_msg(operation_digits(&o, inputs, 11, outputs) == OPERATION_PROVED, "%s", o.why.text);
    for (int i = 0; i < s->output_count; i++) {
        const double due = row[which][s->input_count + i];
        ck_assert_double_le(fabs(strtod(outputs[i], NULL) - due), 1e-10 * fabs(due));
        free(outputs[i]);
    }
}

