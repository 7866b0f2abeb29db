/*
 * Derivation steps: those of the paper hold, and hold every formula of the sheet; false ones are found,
 * with the coefficient that differs; broken files stop with file, line, column and what was expected.
 */
#include "run.h"

#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>

#include "embedded.h"
#include "proofs.h"
#include "series.h"
#include "taylor.h"

#define COUNT(array) ((int)(sizeof(array) / sizeof *(array)))

enum { SEED = 1 };

/* ---- the paper's steps ---- */

START_TEST(every_step_holds_and_fails_as_printed)
{
    struct proofs p;
    proofs_init(&p, SEED);
    for (int i = 0; i < p.derivations.step_count; i++)
        ck_assert_msg(proofs_step_holds(&p, i), "%s: %s", p.derivations.steps[i].id,
                      p.corrected[i].evidence ? p.corrected[i].evidence : "holds as printed");
    ck_assert_int_ge(p.derivations.step_count, 40);
    proofs_clear(&p);
}
END_TEST

/* degree/2^63 < 2^-49 for degrees below 2^14: two points are below 2^-98, three below 2^-100; 2^13 needs two */
START_TEST(points_are_enough)
{
    struct proofs p;
    proofs_init(&p, SEED);
    for (int i = 0; i < p.derivations.step_count; i++) {
        const double chance = (double)p.derivations.steps[i].corrected.degree * 0x1p-63;
        ck_assert_double_lt(pow(chance, p.corrected[i].points), 0x1p-100);
        ck_assert_int_ge(p.corrected[i].bits, 100);
    }
    proofs_clear(&p);
}
END_TEST

START_TEST(other_points_show_the_same)
{
    struct proofs p, q;
    proofs_init(&p, 12345);
    proofs_init(&q, SEED);
    ck_assert(p.fine);
    ck_assert(!fmpz_equal(p.corrected[0].drawn, q.corrected[0].drawn)); /* Omega, the first quantity */
    proofs_clear(&p);
    proofs_clear(&q);
}
END_TEST

START_TEST(every_equation_is_reached)
{
    struct proofs p;
    bool numbers[100] = {false};
    proofs_init(&p, SEED);
    ck_assert_ptr_null(p.gap);
    for (int i = 0; i < sheet()->section_count; i++)
        for (int k = 0; k < sheet()->sections[i].numbers; k++)
            numbers[atoi(sheet()->sections[i].equations[k])] = true;
    for (int i = 1; i <= 44; i++)
        ck_assert_msg(numbers[i], "equation %d is not in the sheet", i);
    proofs_clear(&p);
}
END_TEST

/* The misprints that steps show, and what the print makes of the equality at the point that the evidence names. */
static const struct {
    const char *id, *evidence;
} misprints[] = {
    /* -Omega^2 R_c cos(phi) = -81*15/17, and a third of it */
    {"kepler", "rate(rate(X)) = -GM*X/R_c^3: -1215/17 is not -405/17, where Omega = 3, R_c = 9, phi = the angle of cosine 15/17"},
    /* q1 q2 = -s^2, where it should be s^2 */
    {"charges", "left(20) = right(20): -36 is not 36, where Q_ref = 7, s = 6"},
    /* 2 (y1 s1 - z1 v1) + 8 (y2 s2 - z2 v2), with s1 = -75, v1 = -26, s2 = 90, v2 = 30; and as if both masses were 2 */
    {"inertia", "I_13*w_3: 7088 is not 2408, where m1 = 2, m2 = 8, x1 = -7, y1 = -6, z1 = -1, x2 = 8, y2 = 9, z2 = 1, w_1 = 2"},
    /* m1 (x1^2 + x2^2) = 2 ((8/5)^2 + (2/5)^2), and m1 m2/(m1 + m2) L^2 = 16/10*4 */
    {"inertia_of_the_pair", "left(31, 2) = right(31, 2): 136/25 is not 32/5, where m1 = 2, m2 = 8, L = 2"},
    /* -3 Omega^2 I theta = -3*9*7*3, and a third of it */
    {"torque_small", "eq37.L_G2 = eq39.L_G2: -189 is not -567, the coefficients of epsilon^1, where Omega = 3, psi = 3 epsilon"},
};

START_TEST(misprints_are_these)
{
    struct proofs p;
    size_t found = 0;
    proofs_init(&p, SEED);
    for (int i = 0; i < p.derivations.step_count; i++) {
        if (!p.derivations.steps[i].differs)
            continue;
        ck_assert_uint_lt(found, sizeof misprints / sizeof *misprints);
        ck_assert_str_eq(p.derivations.steps[i].id, misprints[found].id);
        ck_assert_msg(strstr(p.printed[i].evidence, misprints[found].evidence) != NULL, "%s", p.printed[i].evidence);
        found++;
    }
    ck_assert_uint_eq(found, sizeof misprints / sizeof *misprints);
    proofs_clear(&p);
}
END_TEST

/*
 * What follows from what. The proofs cannot tell whether an equation or a principle is named that a step does not rest
 * on: that is for people to judge, and so it is written twice.
 */
static const struct {
    const char *id, *from, *to;
} logic[] = {
    {"kepler", "gravity motion", "38"},
    {"hill", "1 gravity coulomb motion 38", "2"},
    {"coulomb_law", "coulomb", "2"},
    {"action_and_reaction", "coulomb", "2"},
    {"centre_of_mass", "2", "4"},
    {"no_moment", "2", ""},
    {"pair", "2 4", "3"},
    {"static_axes", "3", "5e"},
    {"static_places", "4", "5"},
    {"static_charge_1", "3a 5c 5d 5e", "6a"},
    {"static_charge_2", "3a 5c 5d 5e", "6b"},
    {"reference_charge", "6a 6b", "7"},
    {"rotations", "geometry", "9"},
    {"orthonormal", "9", ""},
    {"place", "8 9", "10"},
    {"place_small", "10", "10"},
    {"place_inverse", "10", "10"},
    {"velocity", "10", "11"},
    {"velocity_small", "10 11", "11"},
    {"distance", "geometry 4 10", "12"},
    {"distance_of_one", "4 12", "13"},
    {"separation", "3 13", "14"},
    {"separation_small", "10 11 14", "15"},
    {"separation_paper", "10 11 14", "15"},
    {"separation_free", "15", ""},
    {"length_error", "7 15 16", "17"},
    {"feedback_law", "feedback 17", "18"},
    {"closed_loop", "17 18", "19"},
    {"charges", "20 22", "21"},
    {"orbit_rate", "9 23", "25"},
    {"body_rate", "geometry 9", "26"},
    {"inertial_rate", "25 26", "27"},
    {"inertial_rate_small", "27", "28"},
    {"angular_acceleration", "27 28", "29"},
    {"inertia", "motion", "30"},
    {"inertia_of_the_pair", "4 8 30", "31 32"},
    {"inertia_turned", "9 10 30 31", ""},
    {"inertia_rate", "16 31 32", "33 34"},
    {"euler", "motion 31 33", "24"},
    {"euler_by_points", "motion 4 9 10 27 32 34", "24"},
    {"nadir", "9 35", "36"},
    {"gravity_gradient", "gravity 8 36 32", "37"},
    {"torque_small", "36 37 38", "39"},
    {"attitude", "16 24 28 29 31 32 33 34 39", "40a 40b"},
    {"length", "19", "40c"},
    {"linearised_hill", "3 7 10 16 18", "40"},
    {"characteristic", "40", "41"},
    {"routh", "41 stability", "42"},
    {"necessity", "41 stability", "42"},
    {"boundary_length", "41", "42"},
    {"boundary_damping", "41", "42"},
    {"decoupled", "19 42", ""},
    {"critical_damping", "19", "43 44"},
    {"characteristic_by_n", "41 43 44", ""},
    {"frequencies", "40 43", ""},
    {"quadratic_system", "3 7 13 18", ""},
    {"second_order", "3 7 10 11 18", ""},
    {"energy", "3 7 10 11 18", ""},
};

/* Whether a step's entries are the words of a text. */
static void assert_words(const char *id, const char *const *entries, int count, const char *words)
{
    char all[200] = "";
    size_t used = 0;
    for (int i = 0; i < count; i++)
        used += (size_t)snprintf(all + used, sizeof all - used, "%s%s", i > 0 ? " " : "", entries[i]);
    ck_assert_msg(strcmp(all, words) == 0, "%s: %s, expected %s", id, all, words);
}

START_TEST(each_step_leads_from_these_to_those)
{
    struct proofs p;
    proofs_init(&p, SEED);
    ck_assert_uint_eq((size_t)p.derivations.step_count, sizeof logic / sizeof *logic);
    for (int i = 0; i < p.derivations.step_count; i++) {
        const struct step *s = &p.derivations.steps[i];
        ck_assert_str_eq(s->id, logic[i].id);
        assert_words(s->id, s->from, s->from_count, logic[i].from);
        assert_words(s->id, s->to, s->to_count, logic[i].to);
    }
    proofs_clear(&p);
}
END_TEST

/* Whether an equality has that side of a relation: "left(31, 2)", or "left(20)" where there is but one. */
static bool has_side(const char *equality, const char *side, const struct section *s, int relation)
{
    const char *equation = s->relations[relation].equation;
    int before = 0, all = 0;
    char text[40];
    for (int i = 0; i < s->relation_count; i++) {
        const bool same = strcmp(s->relations[i].equation, equation) == 0;
        before += same && i <= relation;
        all += same;
    }
    if (all > 1)
        snprintf(text, sizeof text, "%s(%s, %d)", side, equation, before);
    else
        snprintf(text, sizeof text, "%s(%s)", side, equation);
    return strstr(equality, text) != NULL;
}

/* Nothing is proved of a relation whose side is compared with itself, or with that of another. */
START_TEST(both_sides_of_each_relation_are_compared)
{
    struct derivations d;
    derivations_open(&d);
    for (int i = 0; i < sheet()->section_count; i++) {
        const struct section *s = &sheet()->sections[i];
        const bool definition = strcmp(s->id, "eq16") == 0 || strcmp(s->id, "eq23") == 0;
        for (int r = 0; r < s->relation_count && !definition; r++) {
            int together = 0;
            for (int k = 0; k < d.step_count; k++)
                for (int e = 0; e < d.steps[k].corrected.shown_count; e++)
                    together += has_side(d.steps[k].corrected.shown[e].text, "left", s, r) &&
                                has_side(d.steps[k].corrected.shown[e].text, "right", s, r);
            ck_assert_msg(together > 0, "%s: %s", s->relations[r].equation, s->relations[r].text);
        }
    }
    derivations_clear(&d);
}
END_TEST

/* The steps line by line, as they are written. */
static bool next_line(const char **at, char line[], size_t size)
{
    size_t all;
    const char *begin = embedded_derivations(&all), *from = *at ? *at : begin;
    if (from >= begin + all)
        return false;
    const char *end = memchr(from, '\n', (size_t)(begin + all - from));
    const size_t length = (size_t)((end ? end : begin + all) - from);
    ck_assert_uint_lt(length, size);
    memcpy(line, from, length);
    line[length] = '\0';
    *at = from + length + 1;
    return true;
}

/*
 * What is called by the name of an output is the formula of that output, and the rate of L is L_dot: that of another
 * name may be the same number by chance, as I_22 and I_33 are on the radius.
 */
START_TEST(names_stand_for_what_they_name)
{
    const char *at = NULL;
    char line[600], name[40], id[20], output[40];
    int seen = 0;
    while (next_line(&at, line, sizeof line)) {
        if (sscanf(line, " %39[A-Za-z0-9_]: %19[a-z0-9].%39[A-Za-z0-9_]", name, id, output) == 3) {
            const struct section *s = section_find(sheet(), id);
            for (int i = 0; s != NULL && i < s->output_count; i++)
                ck_assert_msg(strcmp(s->outputs[i]->name, name) != 0 || strcmp(output, name) == 0, "%s", line);
            seen++;
        }
        if (strncmp(line, "    rates: {", 12) != 0)
            continue;
        for (char *rest = NULL, *pair = strtok_r(line + 12, ",}", &rest); pair; pair = strtok_r(NULL, ",}", &rest)) {
            char rate[60];
            const size_t length = sscanf(pair, " %39[A-Za-z0-9_]: %39s", name, output) == 2 ? strlen(name) : 0;
            if (length > 4 && strcmp(name + length - 4, "_dot") == 0)
                snprintf(rate, sizeof rate, "%.*s_ddot", (int)length - 4, name);
            else
                snprintf(rate, sizeof rate, "%s_dot", name);
            ck_assert_msg(quantity_find(sheet(), rate) == NULL || strcmp(rate, output) == 0, "%s", pair);
            seen++;
        }
    }
    ck_assert_int_gt(seen, 100);
}
END_TEST

/* On the radius nothing pulls along the velocity, nor along the normal: two claims, and not one of them twice. */
START_TEST(no_output_is_shown_twice_to_vanish)
{
    struct derivations d;
    derivations_open(&d);
    const struct trial *t = &step_named(&d, "static_axes")->corrected;
    bool y1 = false, z1 = false;
    for (int i = 0; i < t->shown_count; i++) {
        y1 |= strncmp(t->shown[i].text, "eq03.y1_ddot(", 13) == 0;
        z1 |= strncmp(t->shown[i].text, "eq03.z1_ddot(", 13) == 0;
    }
    ck_assert(y1 && z1);
    derivations_clear(&d);
}
END_TEST

/* left(5a) = right(5a), and not two sides of one's own, or of two relations that hold both. */
START_TEST(a_relation_is_shown_as_it_stands)
{
    const char *at = NULL;
    char line[600], left[8], right[8], first[20], second[20], more;
    int seen = 0;
    while (next_line(&at, line, sizeof line)) {
        if (sscanf(line, " - %7[a-z](%19[^)]) = %7[a-z](%19[^)])%c", left, first, right, second, &more) != 4)
            continue;
        const bool sides = strcmp(right, "right") == 0 || strcmp(right, "left") == 0;
        ck_assert_msg(!sides || (strcmp(left, "left") == 0 && strcmp(right, "right") == 0 && strcmp(first, second) == 0), "%s", line);
        seen += sides;
    }
    ck_assert_int_gt(seen, 20);
}
END_TEST

/* ---- steps hold the sheet ---- */

/* Whether every step of the paper holds over another sheet. */
static bool steps_hold(const char *sheet_text)
{
    struct sheet s;
    struct derivations d;
    struct message why = {""};
    size_t length;
    const char *steps = embedded_derivations(&length);
    ck_assert_msg(sheet_read(&s, sheet_text, strlen(sheet_text), "sheet", &why) == 0, "%s", why.text);
    bool hold = derivations_read(&d, &s, steps, length, "steps", &why) == 0;
    if (hold) {
        for (int i = 0; i < d.step_count && hold; i++) {
            struct proof p;
            trial_prove(&d.steps[i].corrected, SEED, &p);
            hold = p.finding == FOUND_EQUAL;
            proof_clear(&p);
        }
        derivations_clear(&d);
    }
    sheet_clear(&s);
    return hold;
}

static char *sheet_copy(void)
{
    size_t length;
    const char *text = embedded_sheet(&length);
    char *copy = malloc(length + 100);
    memcpy(copy, text, length);
    copy[length] = '\0';
    return copy;
}

/* The line of the sheet that gives an output of a section its formula. */
static char *formula_line(char *text, const char *section, const char *output)
{
    char name[64];
    snprintf(name, sizeof name, "\n  %s:\n", section);
    char *at = strstr(text, name);
    at = at ? strstr(at, "\n    outputs:\n") : NULL;
    snprintf(name, sizeof name, "\n      %s: ", output);
    at = at ? strstr(at, name) : NULL;
    return at ? at + strlen(name) : NULL;
}

/* Every output doubled (or 1 instead of 0) breaks a step, but for what is no rational function, or zero anyway. */
START_TEST(every_formula_of_the_sheet_is_held)
{
    int held = 0;
    for (int i = 0; i < sheet()->section_count; i++) {
        const struct section *s = &sheet()->sections[i];
        for (int k = 0; k < s->output_count && s->method == METHOD_FORMULA; k++) {
            const char *output = s->outputs[k]->name;
            bool exempt = strcmp(output, "stable") == 0 || (strcmp(s->id, "eq37") == 0 && strcmp(output, "L_G1") == 0);
            char *text = sheet_copy(), *line = formula_line(text, s->id, output);
            ck_assert_msg(line != NULL, "no formula of %s in %s", output, s->id);
            char *rest = text_copy(line + strcspn(line, "\n"));
            sprintf(line, strcmp(s->corrected.text[k], "0") == 0 ? "\"1\"" : "2*(%s)", s->corrected.text[k]);
            memmove(line + strlen(line), rest, strlen(rest) + 1);
            ck_assert_msg(steps_hold(text) == exempt, "%s of %s is held by no step", output, s->id);
            held += !exempt;
            free(rest);
            free(text);
        }
    }
    ck_assert_int_gt(held, 80);
}
END_TEST

/* ---- the integrator's own form ---- */

/* The closed loop's table in taylor.c, at a rational point, against Eq. (3) with (7) and (18) as the sheet has them. */
START_TEST(eq03_closed_by_eq07_eq18_is_the_quadratic_system)
{
    /* x = 2, y = -3, z = 6, r = 7; Omega = 1 and r_ref = 1 by L_ref = 7/2, m1 = 5, m2 = 2 */
    static const slong start[] = {2, -3, 6, 4, 1, -1};
    static const char *const names[] = {"x1", "y1", "z1", "x1_dot", "y1_dot", "z1_dot"};
    static const char text[] =
        "principles: {}\nsteps:\n  loop:\n    title: loop\n    from: []\n    to: []\n    roots: [L_ref]\n    let:\n"
        "      s: (x1*x1_dot + y1*y1_dot + z1*z1_dot)/L_ref\n" /* only to have L_ref positive as a root */
        "      a: eq03.x1_ddot(Q = eq07.Q_ref(L = L_ref) + eq18.dQ)\n"
        "      b: eq03.y1_ddot(Q = eq07.Q_ref(L = L_ref) + eq18.dQ)\n"
        "      c: eq03.z1_ddot(Q = eq07.Q_ref(L = L_ref) + eq18.dQ)\n"
        "    show: [s + a + b + c = 0]\n";
    struct derivations d;
    struct message why = {""};
    struct machine m;
    fmpq_t value, c1, c2;
    fmpq *state = _fmpq_vec_init(JET_STATES), *rates = _fmpq_vec_init(JET_STATES);
    ck_assert_msg(derivations_read(&d, sheet(), text, strlen(text), "t", &why) == 0, "%s", why.text);
    const struct program *p = &d.steps[0].corrected.program;
    fmpq_init(value);
    fmpq_init(c1);
    fmpq_init(c2);
    fmpq_set_si(c1, 13, 1);
    fmpq_set_si(c2, 3, 1);
    machine_init(&m, p, &arithmetic_series, 1);
    for (int i = 0; i < sheet()->quantity_count; i++) {
        fmpq_one(value); /* Omega, k_c */
        arithmetic_series.set_rational(machine_value(&m, i), value, 1);
    }
    const struct {
        const char *name;
        slong num;
        ulong den;
    } settings[] = {{"m1", 5, 1}, {"m2", 2, 1},   {"L_ref", 7, 2}, {"C1", 13, 1},
                    {"C2", 3, 1}, {"dL", 21, 1}, {"dL_dot", -1, 2}}; /* L = 7/2 * 7, L_dot = 7/2 (8 - 3 - 6)/7 */
    for (int i = 0; i < COUNT(settings); i++) {
        fmpq_set_si(value, settings[i].num, settings[i].den);
        arithmetic_series.set_rational(machine_value(&m, program_find(p, settings[i].name)), value, 1);
    }
    for (int i = 0; i < 6; i++) {
        fmpq_set_si(state + i, start[i], 1);
        arithmetic_series.set_rational(machine_value(&m, program_find(p, names[i])), state + i, 1);
    }
    fmpq_set_si(state + 6, 1, 7);
    machine_run(&m);
    closed_loop_rates(rates, state, c1, c2);
    static const char *const accelerations[] = {"a", "b", "c"};
    for (int i = 0; i < 3; i++) {
        series_get_fmpq(value, machine_value(&m, program_find(p, accelerations[i])), 0);
        ck_assert(fmpq_equal(value, rates + 3 + i));
        ck_assert(fmpq_equal(rates + i, state + 3 + i));
    }
    fmpq_set_si(value, 1, 343); /* q' = -q A, A = -1/49 */
    ck_assert(fmpq_equal(value, rates + 6));
    machine_clear(&m);
    _fmpq_vec_clear(state, JET_STATES);
    _fmpq_vec_clear(rates, JET_STATES);
    fmpq_clear(value);
    fmpq_clear(c1);
    fmpq_clear(c2);
    derivations_clear(&d);
}
END_TEST

/* ---- the checker ---- */

static void read_one(struct derivations *d, const char *step)
{
    static char text[2000];
    struct message why = {""};
    snprintf(text, sizeof text, "principles: {}\nsteps:\n  one:\n    title: one\n    from: []\n    to: []\n%s", step);
    ck_assert_msg(derivations_read(d, sheet(), text, strlen(text), "t", &why) == 0, "%s", why.text);
}

/* What the checker finds of a step, and how its evidence begins. */
static const struct {
    const char *step;
    enum finding finding;
    const char *evidence;
} findings[] = {
    {"    show: [(m1 + m2)^2 = m1^2 + 2*m1*m2 + m2^2]", FOUND_EQUAL, ""},
    {"    show: [m1*m2 = m2*m1, m1 = m2]", FOUND_DIFFERENT, "m1 = m2: "},
    {"    show: [2 + 2 = 5]", FOUND_DIFFERENT, "2 + 2 = 5: 4 is not 5"},
    /* zero at all small points */
    {"    free: [k]\n    let:\n      p: (k^2 - 1)*(k^2 - 4)*(k^2 - 9)*(k^2 - 16)*(k^2 - 25)\n"
     "      q: (k^2 - 36)*(k^2 - 49)*(k^2 - 64)*(k^2 - 81)\n    show: [p*q = 0]",
     FOUND_DIFFERENT, "p*q = 0: "},
    {"    small: [psi]\n    order: 2\n    show: [sin(psi) = psi]", FOUND_EQUAL, ""},
    {"    small: [psi]\n    order: 3\n    show: [sin(psi) = psi]", FOUND_DIFFERENT, "sin(psi) = psi: "},
    {"    angles: [psi]\n    show: [sin(psi)^2 = 1 - cos(psi)^2]", FOUND_EQUAL, ""},
    {"    angles: [psi]\n    show: [sin(psi)^2 = cos(psi)^2]", FOUND_DIFFERENT, ""},
    {"    angles: [psi, theta]\n    show: [sin(psi + theta) = sin(psi)*cos(theta) + cos(psi)*sin(theta)]",
     FOUND_EQUAL, ""},
    {"    angles: [psi]\n    rates: {psi: psi_dot}\n    show: [rate(sin(psi)) = psi_dot*cos(psi)]", FOUND_EQUAL, ""},
    {"    rates: {L: L_dot, L_dot: L_ddot}\n    show: [rate(rate(L^2)) = 2*L_dot^2 + 2*L*L_ddot]", FOUND_EQUAL, ""},
    {"    rates: {L: L_dot}\n    show: [rate(m1*L) = m1*L_dot]", FOUND_EQUAL, ""},
    {"    roots: [L*m1]\n    show: [sqrt(L^2*m1^2) = m1*L]", FOUND_EQUAL, ""},
    {"    roots: [m1, L]\n    show: [sqrt(L^2) + sqrt(m1^2) = m1 + L]", FOUND_EQUAL, ""},
    {"    roots: [2*L]\n    show: [sqrt(L^2) = L]", FOUND_NOTHING, "a square root is "},
    {"    roots: [2*L]\n    show: [sqrt(9/4 + 0*L) = 3/2]", FOUND_NOTHING, "a square root is 3/2, none of the roots"},
    {"    roots: [L]\n    show: [sqrt(2*L^2) = L]",
     FOUND_NOTHING, "sqrt(2*L^2) = L: no value, the square root of no rational square"},
    {"    small: [dL]\n    order: 2\n    roots: [L_ref]\n"
     "    show: [sqrt(L_ref^2 + dL) = L_ref + dL/(2*L_ref) - dL^2/(8*L_ref^3)]",
     FOUND_EQUAL, ""},
    {"    show: [sin(L) = L]", FOUND_NOTHING, "sin(L) = L: no value, the sine or cosine of a number that is no angle"},
    {"    show: [exp(L) = L]", FOUND_NOTHING, "exp(L) = L: no value, a value that is no rational series"},
    {"    angles: [psi]\n    show: [psi = psi]",
     FOUND_NOTHING, "psi = psi: no value, a finite angle outside sine and cosine"},
    {"    show: [1/(L - L) = 1]", FOUND_NOTHING, "1/(L - L) = 1: no value, division by what is zero at epsilon = 0"},
    {"    positive: [k]\n    small: [k]\n    order: 1\n    let:\n      lambda_d: 1/k\n"
     "    show: [exp(-L/lambda_d) = 1 - L*k]",
     FOUND_EQUAL, ""},
    {"    angles: [psi]\n    roots: [L]\n    show: [\"cos(atan2(L*sin(psi), L*cos(psi))) = cos(psi)\"]",
     FOUND_EQUAL, ""},
    {"    show: [eq05.x1 - eq05.x2 = L]", FOUND_EQUAL, ""},
    {"    show: [eq05.x1(m1 = m2) = L/2]", FOUND_EQUAL, ""},
    {"    show: [eq30.I_12 = eq30.I_12@printed]", FOUND_DIFFERENT, ""},
    {"    show: [eq30.I_12(m2 = m1) = eq30.I_12@printed]", FOUND_EQUAL, ""},
    {"    show: [left(5b) - right(5b) = x1 - x2 - L]", FOUND_EQUAL, ""},
    {"    show: [\"left(24, 3) = I*w_dot_3 + I_dot*w_3 + I*w_1*w_2\"]", FOUND_EQUAL, ""},
    {"    free: [f_12, f_13]\n    show: [eq02.z1_ddot = (f_12*(z1 - z2) + f_13*(z1 - z3))/m1 - Omega^2*z1]",
     FOUND_EQUAL, ""},
};

START_TEST(checker_finds)
{
    struct derivations d;
    struct proof p;
    read_one(&d, findings[_i].step);
    trial_prove(&d.steps[0].corrected, SEED, &p);
    ck_assert_msg(p.finding == findings[_i].finding, "%s", p.evidence ? p.evidence : "holds");
    const char *begin = findings[_i].evidence;
    ck_assert_msg(strncmp(p.evidence ? p.evidence : "", begin, strlen(begin)) == 0, "%s", p.evidence);
    proof_clear(&p);
    derivations_clear(&d);
}
END_TEST

/* dL = k epsilon: the first coefficient that differs is that of epsilon^2, k^2 against 2 k^2 */
START_TEST(evidence_is_the_first_coefficient_that_differs)
{
    struct derivations d;
    struct proof p;
    long k, left, right;
    char end;
    read_one(&d, "    small: [dL]\n    order: 3\n    show: [1 + dL + dL^2 = 1 + dL + 2*dL^2 + dL^3]");
    trial_prove(&d.steps[0].corrected, SEED, &p);
    ck_assert_int_eq(p.finding, FOUND_DIFFERENT);
    const char *shape = ": %ld is not %ld, the coefficients of epsilon^2, where dL = %ld epsilo%c";
    ck_assert_int_eq(sscanf(strchr(p.evidence, ':'), shape, &left, &right, &k, &end), 4);
    ck_assert_int_eq(left, k * k);
    ck_assert_int_eq(right, 2 * k * k);
    proof_clear(&p);
    derivations_clear(&d);
}
END_TEST

/* A pole at the very point that is drawn first: it is replaced by another, and counted. */
START_TEST(pole_is_replaced_by_another_point)
{
    struct derivations d;
    struct proof p;
    char step[200];
    read_one(&d, "    free: [k]\n    show: [k = k]");
    trial_prove(&d.steps[0].corrected, SEED, &p);
    char *number = fmpz_get_str(NULL, 10, p.drawn + d.steps[0].corrected.program.inputs - 1);
    ck_assert_int_eq(p.retries, 0);
    snprintf(step, sizeof step, "    free: [k]\n    show: [k/(k - (%s)) = 1/(1 - (%s)/k)]", number, number);
    flint_free(number);
    proof_clear(&p);
    derivations_clear(&d);
    read_one(&d, step);
    trial_prove(&d.steps[0].corrected, SEED, &p);
    ck_assert_int_eq(p.finding, FOUND_EQUAL);
    ck_assert_int_eq(p.retries, 1);
    ck_assert_int_eq(p.points, 2);
    proof_clear(&p);
    derivations_clear(&d);
}
END_TEST

/* Degree 999^2 < 2^20, for all that the checker knows: 43 bits a point, three of them for 2^-100 */
/* A square root may be any of the roots, whose squares all count: of degree 10 is (L^5)^2 - L^2. */
START_TEST(a_root_counts_twice)
{
    struct derivations d;
    read_one(&d, "    positive: [L]\n    roots: [L, L^5]\n    show: [sqrt(L^2) = L]");
    ck_assert_uint_eq(d.steps[0].corrected.degree, 10);
    derivations_clear(&d);
}
END_TEST

START_TEST(high_degree_takes_more_points)
{
    struct derivations d;
    struct proof p;
    read_one(&d, "    show: [((L/L)^999)^999 = 1]");
    trial_prove(&d.steps[0].corrected, SEED, &p);
    ck_assert_uint_eq(d.steps[0].corrected.degree, 998001);
    ck_assert_int_eq(p.points, 3);
    ck_assert_int_eq(p.bits, 129);
    proof_clear(&p);
    derivations_clear(&d);
}
END_TEST

START_TEST(entry_stands_for_its_parts)
{
    ck_assert(stands_for("6", "6a"));
    ck_assert(stands_for("6a", "6a"));
    ck_assert(stands_for("6", "6"));
    ck_assert(!stands_for("6a", "6b"));
    ck_assert(!stands_for("6a", "6"));
    ck_assert(!stands_for("4", "40a"));
    ck_assert(!stands_for("40", "4"));
}
END_TEST

/* Nothing is reached from what is not reached itself: (25) rests on (9). */
START_TEST(gap_is_found)
{
    static const char text[] =
        "principles: {}\nsteps:\n  orbit_rate:\n    title: t\n    from: [\"9\", \"23\"]\n    to: [\"25\", 2]\n"
        "    show: [L = L]\n";
    struct derivations d;
    struct message why = {""};
    ck_assert_msg(derivations_read(&d, sheet(), text, strlen(text), "t", &why) == 0, "%s", why.text);
    ck_assert_str_eq(derivations_gap(&d), "2a");
    derivations_clear(&d);
}
END_TEST

/* ---- broken files ---- */

#define TWENTY_RATES "rate(rate(rate(rate(rate(rate(rate(rate(rate(rate(rate(rate(rate(rate(rate(rate(rate(rate(rate(rate"

static const char good[] =
    "principles:\n"                                    /*  1 */
    "  force: a push\n"                                /*  2 */
    "steps:\n"                                         /*  3 */
    "  one:\n"                                         /*  4 */
    "    title: a step\n"                              /*  5 */
    "    from: [force, \"10\"]\n"                      /*  6 */
    "    to: [6a]\n"                                   /*  7 */
    "    free: [u]\n"                                  /*  8 */
    "    positive: [k]\n"                              /*  9 */
    "    angles: [psi]\n"                              /* 10 */
    "    small: [theta]\n"                             /* 11 */
    "    order: 1\n"                                   /* 12 */
    "    rates: {psi: psi_dot}\n"                      /* 13 */
    "    roots: [k]\n"                                 /* 14 */
    "    let:\n"                                       /* 15 */
    "      a: sqrt(k^2)*u\n"                           /* 16 */
    "      b: rate(sin(psi)) + eq10.x1(L = 2*m1)\n"    /* 17 */
    "    show:\n"                                      /* 18 */
    "      - a + b*theta = theta*b + a\n"              /* 19 */
    "    printed:\n"                                   /* 20 */
    "      let:\n"                                     /* 21 */
    "        a: k*u + 1\n"                             /* 22 */
    "      show:\n"                                    /* 23 */
    "        - a = k*u\n"                              /* 24 */
    "  two:\n"                                         /* 25 */
    "    title: another\n"                             /* 26 */
    "    from: [\"6\"]\n"                              /* 27 */
    "    to: []\n"                                     /* 28 */
    "    show: [\"left(24, 2) = left(24, 2)\"]\n";     /* 29 */

START_TEST(good_file_is_read)
{
    struct derivations d;
    struct message why = {""};
    ck_assert_msg(derivations_read(&d, sheet(), good, strlen(good), "t", &why) == 0, "%s", why.text);
    ck_assert_int_eq(d.step_count, 2);
    ck_assert_str_eq(d.principles[0].text, "a push");
    ck_assert_int_eq(d.steps[0].from_count, 2);
    ck_assert_str_eq(d.steps[0].to[0], "6a");
    ck_assert_int_eq(d.steps[0].order, 1);
    ck_assert_int_eq(d.steps[1].order, -1);
    ck_assert(d.steps[0].differs);
    ck_assert_int_eq(d.steps[0].corrected.radical_count, 1);
    derivations_clear(&d);
}
END_TEST

static const struct {
    const char *from, *to, *place, *expected;
} mistakes[] = {
    {"principles:", "principle:", "1:1: ", "unknown key 'principle', expected perhaps principles"},
    {"principles:\n  force: a push\n", "", "1:1: ", "missing principles"},
    {"  force: a push\n", "  force: [a, push]\n", "2:10: ", "expected a text"},
    {"    title: a step\n", "", "5:5: ", "missing title, expected a text"},
    {"title: a step", "titel: a step", "5:5: ", "unknown key 'titel', expected perhaps title"},
    {"title: a step", "title: [a, step]", "5:12: ", "missing title, expected a text"},
    {"    from: [force, \"10\"]\n", "", "5:5: ", "missing from, expected a list of equation numbers"},
    {"[force, \"10\"]", "[forces, \"10\"]", "6:12: ", "unknown 'forces', expected an equation number or a principle"},
    {"[force, \"10\"]", "[force, \"99\"]", "6:19: ", "unknown '99', expected an equation number or a principle"},
    {"[force, \"10\"]", "force", "6:11: ", "expected a list"},
    {"to: [6a]", "to: [6c]", "7:10: ", "unknown '6c', expected an equation number"},
    {"to: [6a]", "to: [force]", "7:10: ", "unknown 'force', expected an equation number"},
    {"to: [6a]", "from: [6a]", "7:5: ", "duplicate 'from', expected each key once"},
    {"free: [u]", "free: [u, L]", "8:15: ", "'L' is known already, expected a new name"},
    {"free: [u]", "free: [u, v]", "8:15: ", "nothing shown rests on 'v'"},
    {"free: [u]", "free: u", "8:11: ", "expected a list"},
    {"positive: [k]", "positive: [k, x1]", "9:19: ", "nothing shown rests on 'x1'"},
    {"positive: [k]", "positive: []", "16:15: ", "unknown symbol 'k'"},
    {"angles: [psi]", "angles: [psi, psi]", "10:19: ", "'psi' is an angle or small already"},
    {"small: [theta]", "small: [theta, psi]", "11:20: ", "'psi' is an angle or small already"},
    {"small: [theta]", "small: [theta, thta]", "11:20: ", "unknown symbol 'thta', expected a free quantity"},
    {"    order: 1\n", "", "5:5: ", "missing order: up to which power of the small quantities"},
    {"order: 1", "order: 10", "12:12: ", "expected an order from 0 to 9"},
    {"order: 1", "order: first", "12:12: ", "expected an order from 0 to 9"},
    {"order: 1", "order: -1", "12:12: ", "expected an order from 0 to 9"},
    {"order: 1", "order: [1]", "12:12: ", "expected an order from 0 to 9"},
    {"{psi: psi_dot}", "{phi: psi_dot}", "13:13: ", "unknown symbol 'phi', expected name: its rate"},
    {"{psi: psi_dot}", "{psi: psi_dt}", "13:18: ", "unknown symbol 'psi_dt', expected name: its rate"},
    {"{psi: psi_dot}", "[psi, psi_dot]", "13:12: ", "expected a mapping, key: value"},
    {"    roots: [k]\n", "", "5:5: ", "missing roots: what the square roots are equal to"},
    {"roots: [k]", "roots: [u]", "14:13: ", "expected a root that is positive by its form"},
    {"roots: [k]", "roots: [m1 - k]", "14:13: ", "expected a root that is positive by its form"},
    {"roots: [k]", "roots: [theta]", "14:13: ", "expected a root that is positive by its form"},
    {"roots: [k]", "roots: [k +]", "14:16: ", "expected a number, a symbol or '(', the formula ends here"},
    {"sqrt(k^2)", "k", "14:12: ", "expected no roots, nothing shown rests on a square root"},
    {"      a: sqrt", "      c: 2*k\n      a: sqrt", "16:7: ", "nothing shown rests on 'c'"},
    {"      b: rate", "      a: rate", "17:7: ", "duplicate 'a', expected each key once"},
    {"sqrt(k^2)*u", "sqrt(k^2)*w", "16:20: ", "unknown symbol 'w'"},
    {"sqrt(k^2)*u", "sqrt(k^2)*\n        u", "16:10: ", "expected a formula, on one line"},
    {"sqrt(k^2)*u", "[k, u]", "16:10: ", "expected a text"},
    {"rate(sin(psi))", "rates(sin(psi))", "17:10: ", "unknown function 'rates', expected rate, left, right, sqrt"},
    {"rate(sin(psi))", "rate sin(psi)", "17:10: ", "unknown symbol 'rate'"},
    {"rate(sin(psi))", "rate(sin(psi)", "17:43: ", "expected ')' or an operator, the formula ends here"},
    {"eq10.x1(", "eq99.x1(", "17:27: ", "unknown section 'eq99', expected one of the sheet that has formulas"},
    {"eq10.x1(", "eq20.x1(", "17:27: ", "unknown section 'eq20', expected one of the sheet that has formulas"},
    {"eq10.x1(", "eq10.x2(", "17:32: ", "unknown output 'x2', expected an output or a named subexpression"},
    {"eq10.x1(", "eq10.(", "17:32: ", "expected a name, found '('"},
    {"eq10.x1(", "eq10.x1@printed(", "17:35: ", "unknown variant 'printed'"},
    {"eq10.x1(", "eq30.I_11@print(", "17:37: ", "unknown variant 'print'"},
    {"eq10.x1(", "eq38.L@printed(", "17:32: ", "unknown output 'L', expected an output or a named subexpression"},
    {"eq10.x1(", "eq30.I_11@(", "17:37: ", "expected a name, found '('"},
    {"(L = 2*m1)", "(M = 2*m1)", "17:35: ", "unknown name 'M', expected an input or a named subexpression"},
    {"(L = 2*m1)", "(L 2*m1)", "17:37: ", "expected '=', found '2'"},
    {"(L = 2*m1)", "(L = 2*m9)", "17:41: ", "unknown symbol 'm9'"},
    {"(L = 2*m1)", "(L = 2*m1", "17:43: ", "expected an operator, ',' or ')', the formula ends here"},
    {"(L = 2*m1)", "()", "17:35: ", "expected a name, found ')'"},
    {"      - a + b*theta = theta*b + a\n", "      - a + b*theta\n", "19:9: ", "expected left = right"},
    {"      - a + b*theta = theta*b + a\n", "      - a + b*theta =\n          theta*b + a\n", "19:9: ",
     "expected left = right, on one line"},
    {"      - a + b*theta = theta*b + a\n", "      - a + b*theta =\n", "19:22: ", "expected a number, a symbol or '('"},
    {"      - a + b*theta = theta*b + a\n", "      - a + b* = theta*b + a\n", "19:16: ",
     "expected a number, a symbol or '(', the formula ends here"},
    {"      - a + b*theta = theta*b + a\n", "      - a + b*theta = theta*b + q\n", "19:33: ", "unknown symbol 'q'"},
    {"    show:\n      - a + b*theta = theta*b + a\n", "    show: []\n", "18:11: ",
     "expected at least one left = right"},
    {"    show:\n      - a + b*theta = theta*b + a\n", "", "5:5: ", "missing show, expected a list of left = right"},
    {"        a: k*u + 1\n", "        c: k*u + 1\n", "22:9: ", "unknown name 'c', expected one of the step's let"},
    {"        a: k*u + 1\n", "        a: k*u + \n", "22:17: ", "expected a number, a symbol or '('"},
    {"      show:\n        - a = k*u\n", "", "21:7: ", "missing show, expected a list of left = right"},
    {"      show:\n        - a = k*u\n", "      shown:\n        - a = k*u\n", "23:7: ",
     "unknown key 'shown', expected perhaps show"},
    {"  two:", "  one:", "25:3: ", "duplicate 'one', expected each key once"},
    {"\"left(24, 2) = left", "\"left(24, 4) = left", "29:17: ",
     "unknown relation 4 of (24), expected one of the sheet"},
    {"\"left(24, 2) = left", "\"left(24, 2x) = left", "29:17: ", "unknown relation 2x of (24)"},
    {"\"left(24, 2) = left", "\"left(24; 2) = left", "29:20: ", "expected ',' or ')', found ';'"},
    {"\"left(24, 2) = left", "\"left() = left", "29:18: ", "expected a name, found ')'"},
    {"sqrt(k^2)*u", "sqrt(k^2)*((((u^999)^999)^999)^999)^999", "5:5: ", "expected a simpler step"},
    {"rate(sin(psi))", TWENTY_RATES "(sin(psi)^2)))))))))))))))))))))", "17:", "expected fewer rates of rates, found ')'"},
    {"    to: []\n", "    to: []\n    order: 1\n", "29:12: ", "expected no order where no quantities are small"},
    {"[force, \"10\"]", "[force, \"10\"", "", "expected YAML: "},
};

START_TEST(mistake_is_told_with_its_place)
{
    struct derivations d;
    struct message why = {""};
    const char *at = strstr(good, mistakes[_i].from);
    char *text = malloc(sizeof good + strlen(mistakes[_i].to)), place[40];
    ck_assert_msg(at != NULL, "no '%s'", mistakes[_i].from);
    sprintf(text, "%.*s%s%s", (int)(at - good), good, mistakes[_i].to, at + strlen(mistakes[_i].from));
    ck_assert_int_ne(derivations_read(&d, sheet(), text, strlen(text), "t.yaml", &why), 0);
    snprintf(place, sizeof place, "t.yaml:%s", mistakes[_i].place);
    ck_assert_msg(strncmp(why.text, place, strlen(place)) == 0, "'%s' is not at %s", why.text, place);
    ck_assert_msg(strstr(why.text, mistakes[_i].expected) != NULL, "'%s' has no '%s'", why.text, mistakes[_i].expected);
    free(text);
}
END_TEST

/* Wherever the file ends too early, it is read or refused in words, never worse. */
START_TEST(cut_file_is_read_or_refused)
{
    for (size_t length = 0; length < strlen(good); length++) {
        struct derivations d;
        struct message why = {""};
        if (derivations_read(&d, sheet(), good, length, "t.yaml", &why) == 0)
            derivations_clear(&d);
        else
            ck_assert_msg(strncmp(why.text, "t.yaml:", 7) == 0, "%s", why.text);
    }
}
END_TEST

/* ---- the command ---- */

/* The program's exit status; what it prints goes where the line says. */
static int shell(const char *line)
{
    int status = system(line);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

static const struct {
    const char *line;
    int status;
} commands[] = {
    {"\"$CT_PROGRAM\" verify derivations | grep -q 'steps hold'", 0},
    {"\"$CT_PROGRAM\" verify derivations >/dev/null", 0},
    {"\"$CT_PROGRAM\" verify derivations --seed 7 >/dev/null", 0},
    {"\"$CT_PROGRAM\" verify derivations --graph | dot -Tsvg | grep -q '</svg>'", 0},
    {"\"$CT_PROGRAM\" verify derivations --graph | grep -q '^  \"coulomb_law\" .label=\"coulomb law\", '", 0},
    {"\"$CT_PROGRAM\" verify derivations | awk 'index($0, \" -> \") == 52 { n++ } END { exit n < 50 }'", 0},
    {"\"$CT_PROGRAM\" verify derivations --graph --json 2>/dev/null", 2},
    {"\"$CT_PROGRAM\" verify derivation 2>/dev/null", 2},
    {"\"$CT_PROGRAM\" verify derivations --seed x 2>/dev/null", 2},
    {"\"$CT_PROGRAM\" verify derivations --seed 18446744073709551616 2>/dev/null", 2},
    {"\"$CT_PROGRAM\" verify derivations >/dev/full 2>/dev/null", 1},
};

/* Brackets that close what was opened, outside texts: what goes wrong where JSON is printed by hand. */
START_TEST(json_is_balanced)
{
    FILE *out = popen("\"$CT_PROGRAM\" verify derivations --json", "r");
    char open[16];
    int depth = 0, opened = 0;
    ck_assert_ptr_nonnull(out);
    for (int c = getc(out), quoted = 0; c != EOF; c = getc(out)) {
        if (c == '"')
            quoted = !quoted;
        else if (c == '\\')
            getc(out);
        else if (!quoted && (c == '{' || c == '[')) {
            ck_assert_int_lt(depth, COUNT(open));
            open[depth++] = (char)c;
            opened++;
        } else if (!quoted && (c == '}' || c == ']')) {
            ck_assert_int_gt(depth, 0);
            ck_assert_int_eq(open[--depth], c == '}' ? '{' : '[');
        }
    }
    ck_assert_int_eq(pclose(out), 0);
    ck_assert_int_eq(depth, 0);
    ck_assert_int_gt(opened, 400);
}
END_TEST

START_TEST(command_has_its_status)
{
    ck_assert_int_eq(shell(commands[_i].line), commands[_i].status);
}
END_TEST

Suite *suite(void)
{
    TCase *paper = tcase_create("paper");
    tcase_set_timeout(paper, 60); /* a hundred sheets, each against all steps: 3 s */
    tcase_add_test(paper, every_step_holds_and_fails_as_printed);
    tcase_add_test(paper, points_are_enough);
    tcase_add_test(paper, other_points_show_the_same);
    tcase_add_test(paper, every_equation_is_reached);
    tcase_add_test(paper, every_formula_of_the_sheet_is_held);
    tcase_add_test(paper, eq03_closed_by_eq07_eq18_is_the_quadratic_system);

    TCase *logic = tcase_create("logic");
    tcase_add_test(logic, misprints_are_these);
    tcase_add_test(logic, each_step_leads_from_these_to_those);
    tcase_add_test(logic, both_sides_of_each_relation_are_compared);
    tcase_add_test(logic, names_stand_for_what_they_name);
    tcase_add_test(logic, a_relation_is_shown_as_it_stands);
    tcase_add_test(logic, no_output_is_shown_twice_to_vanish);

    TCase *checker = tcase_create("checker");
    tcase_add_loop_test(checker, checker_finds, 0, COUNT(findings));
    tcase_add_test(checker, evidence_is_the_first_coefficient_that_differs);
    tcase_add_test(checker, pole_is_replaced_by_another_point);
    tcase_add_test(checker, a_root_counts_twice);
    tcase_add_test(checker, high_degree_takes_more_points);
    tcase_add_test(checker, entry_stands_for_its_parts);
    tcase_add_test(checker, gap_is_found);

    TCase *reading = tcase_create("reading");
    tcase_add_test(reading, good_file_is_read);
    tcase_add_loop_test(reading, mistake_is_told_with_its_place, 0, COUNT(mistakes));
    tcase_add_test(reading, cut_file_is_read_or_refused);
    tcase_add_test(reading, json_is_balanced);
    tcase_add_loop_test(reading, command_has_its_status, 0, COUNT(commands));

    Suite *s = suite_create("derivation");
    suite_add_tcase(s, paper);
    suite_add_tcase(s, logic);
    suite_add_tcase(s, checker);
    suite_add_tcase(s, reading);
    return s;
}
