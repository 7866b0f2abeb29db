/*
 * Derivation steps: those of the paper hold and are bound to their equations; false and emptied ones are refused, with
 * what is wrong; broken files stop with file, line, column and what was expected.
 */
#include "tests/run.h"
#include "tests/paper.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>

#include "proof/derivation.h"
#include "motion/taylor.h"
#include "text/scope.h"

/* ---- the paper's steps ---- */

TEST(every_equation_is_in_the_sheet)
{
    bool numbers[100] = {false};
    for (int i = 0; i < sheet()->section_count; i++)
        for (int k = 0; k < sheet()->sections[i].numbers; k++)
            numbers[atoi(sheet()->sections[i].equations[k])] = true;
    for (int i = 1; i <= 44; i++)
        ck_assert_msg(numbers[i], "equation %d is not in the sheet", i);
}

/* The misprints that steps show: the difference that the print makes, and a point. */
static const struct {
    const char *id, *evidence;
} misprints[] = {
    {"kepler", "motion.F(m = m1, a = rate(rate(X))) = m1*gravity.a_x(GM = Omega^2*R_c^3/3): the sides differ by "
     "(2*Omega^2*m1*R_c*t_phi^2-2*Omega^2*m1*R_c)/(3*t_phi^2+3); 3/5 is not 1/5 where Omega = 1, m1 = 1, "
     "R_c = 1, tan(phi/2) = 2"},
    {"charges", "left(20) = right(20): the sides differ by -2*s^2; -1 is not 1 where s = 1"},
    {"inertia", "H_1 = eq30.I_11@printed*w_1 + eq30.I_12@printed*w_2 + eq30.I_13@printed*w_3: the sides differ by "
     "(m1*x2*y2*w_2+m1*x2*z2*w_3-m1*y2^2*w_1-m1*z2^2*w_1-m2*x2*y2*w_2-m2*x2*z2*w_3+...8 terms); 182 is not "
     "168 where m1 = 2, m2 = 4, x1 = 1, y1 = 3, z1 = 5, x2 = 2, y2 = 4, z2 = 1, w_1 = 3, w_2 = 5, w_3 = 2"},
    {"inertia_of_the_pair", "eq30.I_22@printed = right(31, 2): the sides differ by (m1^3*L^2-m1^2*m2*L^2)/(m1^2+2*m1*m2+m2^2); 10/9 is "
     "not 4/3 where m1 = 2, m2 = 4, L = 1"},
    {"torque_small", "eq37.L_G2(GM = Omega^2*R_c^3/3) = eq39.L_G2: the coefficients of epsilon^1 differ by 2*Omega^2*theta*I; -1 is not -3 where "
     "Omega = 1, theta = 1 epsilon, I = 1"},
};

/* That each step is bound to its equations is shown once, by the program, before the suites run (BUILD/derivations.json). */
TEST(every_step_holds_and_misprints_are_these)
{
    struct derivations p;
    int found = 0;
    open_steps(&p);
    for (int i = 0; i < p.step_count; i++) {
        const struct proof *printed = &p.steps[i].printed_proof;
        ck_assert_msg(step_holds(&p.steps[i]), "%s: %s", p.steps[i].id,
                      p.steps[i].proof.evidence ? p.steps[i].proof.evidence : "holds as printed");
        if (!p.steps[i].differs)
            continue;
        ck_assert_int_lt(found, COUNT(misprints));
        ck_assert_str_eq(p.steps[i].id, misprints[found].id);
        ck_assert_str_eq(printed->evidence, misprints[found].evidence);
        found++;
    }
    ck_assert_int_eq(found, COUNT(misprints));
    ck_assert_int_ge(p.step_count, 60);
    ck_assert_ptr_null(derivations_gap(&p));
    derivations_clear(&p);
}

/* ---- the prover ---- */

/* The paper's principles and properties, and this step. */
static bool read_step_text(struct derivations *d, const char *step, struct message *why)
{
    static char text[400000];
    const struct source s = whole_paper()->derivations;
    ck_assert_uint_lt(s.length, sizeof text / 2);
    snprintf(text, sizeof text, "%.*s", (int)s.length, s.text);
    char *steps = strstr(text, "\nsteps:\n");
    ck_assert_ptr_nonnull(steps);
    snprintf(steps, sizeof text / 2, "\nsteps:\n  one:\n    title: one\n%s\n", step);
    return derivations_read(d, sheet(), text, strlen(text), "t", why) == 0;
}

static void read_one(struct derivations *d, const char *step)
{
    char text[2000];
    struct message why = {""};
    snprintf(text, sizeof text, "    from: []\n    to: []\n%s", step);
    ck_assert_msg(read_step_text(d, text, &why), "%s", why.text);
}

/* The closed loop's table in taylor.c, at a rational point, against Eq. (3) with (7) and (18) as the sheet has them. */
TEST(eq03_closed_by_eq07_eq18_is_the_quadratic_system)
{
    /* x = 2, y = -3, z = 6, r = 7; Omega = 1 and r_ref = 1 by L_ref = 7/2: L = 7/2 * 7, L_dot = 7/2 (8 - 3 - 6)/7 */
    static const slong start[] = {2, -3, 6, 4, 1, -1};
    static const char let[] = "    let: {Omega: 1, k_c: 1, m1: 5, m2: 2, L_ref: 7/2, C1: 13, C2: 3, dL: 21, dL_dot: -1/2, x1: 2, \"y1\": -3, z1: 6,\n"
                              "      x1_dot: 4, y1_dot: 1, Q: eq07.Q_ref(L = L_ref) + eq18.dQ}\n";
    struct derivations d;
    struct proof p;
    char step[900];
    SCOPE(fmpq, c1, c2);
    VECTOR(fmpq, state, JET_STATES);
    VECTOR(fmpq, rates, JET_STATES);
    fmpq_set_si(c1, 13, 1);
    fmpq_set_si(c2, 3, 1);
    for (int i = 0; i < 6; i++)
        fmpq_set_si(state + i, start[i], 1);
    fmpq_set_si(state + 6, 1, 7);
    closed_loop_rates(rates, state, c1, c2);
    char *accelerations[3];
    for (int i = 0; i < 3; i++) {
        accelerations[i] = fmpq_get_str(NULL, 10, rates + 3 + i);
        ck_assert(fmpq_equal(rates + i, state + 3 + i));
    }
    snprintf(step, sizeof step, "%s    show: [eq03.x1_ddot = %s, eq03.y1_ddot = %s, eq03.z1_ddot = %s]", let, accelerations[0], accelerations[1], accelerations[2]);
    read_one(&d, step);
    identities_prove(&d.steps[0].corrected, &p);
    ck_assert_msg(p.result == IDENTITY_HOLDS, "%s", p.evidence);
    for (int i = 0; i < 3; i++)
        flint_free(accelerations[i]);
    proof_clear(&p);
    derivations_clear(&d);
    fmpq_set_si(c1, 1, 343); /* q' = -q A, A = -1/49 */
    ck_assert(fmpq_equal(c1, rates + 6));
}

/* What the prover finds of a step, and how its evidence begins. */
static const struct {
    const char *step;
    enum result result;
    const char *evidence;
} findings[] = {
    {"    show: [(m1 + m2)^2 = m1^2 + 2*m1*m2 + m2^2]", IDENTITY_HOLDS, ""},
    {"    show: [m1*m2 = m2*m1, m1 = m2]", IDENTITY_DIFFERS, "m1 = m2: "},
    {"    show: [2 + 2 = 5]", IDENTITY_DIFFERS, "2 + 2 = 5: the sides differ by -1; 4 is not 5"},
    /* zero at all small points */
    {"    free: [k]\n    let:\n      p: (k^2 - 1)*(k^2 - 4)*(k^2 - 9)*(k^2 - 16)*(k^2 - 25)\n"
     "      q: (k^2 - 36)*(k^2 - 49)*(k^2 - 64)*(k^2 - 81)\n    show: [p*q = 0]",
     IDENTITY_DIFFERS, "p*q = 0: "},
    {"    small: [psi]\n    order: 2\n    show: [sin(psi) = psi]", IDENTITY_HOLDS, ""},
    {"    small: [psi]\n    order: 3\n    show: [sin(psi) = psi]", IDENTITY_DIFFERS, "sin(psi) = psi: "},
    {"    angles: [psi]\n    show: [sin(psi)^2 = 1 - cos(psi)^2]", IDENTITY_HOLDS, ""},
    {"    angles: [psi]\n    show: [sin(psi)^2 = cos(psi)^2]", IDENTITY_DIFFERS, ""},
    {"    angles: [psi, theta]\n    show: [sin(psi + theta) = sin(psi)*cos(theta) + cos(psi)*sin(theta)]",
     IDENTITY_HOLDS, ""},
    {"    angles: [psi]\n    rates: {psi: psi_dot}\n    show: [rate(sin(psi)) = psi_dot*cos(psi)]", IDENTITY_HOLDS, ""},
    {"    rates: {L: L_dot, L_dot: L_ddot}\n    show: [rate(rate(L^2)) = 2*L_dot^2 + 2*L*L_ddot]", IDENTITY_HOLDS, ""},
    {"    rates: {L: L_dot}\n    show: [rate(m1*L) = m1*L_dot]", IDENTITY_HOLDS, ""},
    {"    let: {u: Omega}\n    show: [u = Omega]", IDENTITY_HOLDS, ""},
    {"    show: [\"rate(Omega) = 0\", \"eq05.x1(m1 = Omega, m2 = Omega) = L/2\"]", IDENTITY_HOLDS, ""}, /* the first of all names */
    {"    square roots: [L*m1]\n    show: [sqrt(L^2*m1^2) = m1*L]", IDENTITY_HOLDS, ""},
    {"    square roots: [m1, L]\n    show: [sqrt(L^2) + sqrt(m1^2) = m1 + L]", IDENTITY_HOLDS, ""},
    {"    square roots: [L, x1]\n    show: [sqrt(L^2) + sqrt(x1^2) = L + x1]", IDENTITY_UNDECIDED, "square root x1 is not proved to be positive"},
    {"    square roots: [L, m1]\n    show: [sqrt(L^2) = L]", IDENTITY_UNDECIDED, "square root m1 is the root of nothing shown"},
    {"    small: [L]\n    order: 1\n    square roots: [m1/L, m1]\n    show: [sqrt(m1^2) + L = m1 + L]", IDENTITY_UNDECIDED,
     "square root m1/L is not proved to be positive"},
    {"    square roots: [2*L]\n    show: [sqrt(L^2) = L]", IDENTITY_UNDECIDED, "sqrt(L^2) = L: no value, a square root that is none of"},
    {"    small: [dL]\n    order: 1\n    square roots: [2*L]\n    show: [sqrt(L^2 + dL) = L]",
     IDENTITY_UNDECIDED, "sqrt(L^2 + dL) = L: no value, a square root that is none of"},
    {"    square roots: [2*L]\n    show: [sqrt(9/4 + 0*L) = 3/2]", IDENTITY_UNDECIDED, "square root 2*L is the root of nothing shown"},
    {"    small: [dL]\n    order: 1\n    show: [sqrt(L^2/m1 + dL) = L]",
     IDENTITY_UNDECIDED, "sqrt(L^2/m1 + dL) = L: no value, the square root of no square of a rational function"},
    {"    square roots: [L]\n    show: [sqrt(2*L^2) = L]",
     IDENTITY_UNDECIDED, "sqrt(2*L^2) = L: no value, the square root of no square of a rational function"},
    {"    small: [dL]\n    order: 2\n    square roots: [L_ref]\n"
     "    show: [sqrt(L_ref^2 + dL) = L_ref + dL/(2*L_ref) - dL^2/(8*L_ref^3)]",
     IDENTITY_HOLDS, ""},
    {"    square roots: [-(-L)]\n    show: [sqrt(L^2) = L]", IDENTITY_HOLDS, ""},
    {"    square roots: [L*exp(0)]\n    show: [sqrt(L^2) = L]", IDENTITY_HOLDS, ""},
    {"    square roots: [L, sqrt(L^2)*m1]\n    show: [sqrt(L^2*m1^2) = L*m1]", IDENTITY_HOLDS, ""},
    {"    square roots: [L*(2 - positive(L))]\n    show: [sqrt(L^2) = L]", IDENTITY_HOLDS, ""},
    {"    small: [dL]\n    order: 1\n    square roots: [L + L/(1/dL)]\n    show: [sqrt(L^2 + 2*L^2*dL) = L + L*dL]", IDENTITY_HOLDS, ""},
    {"    square roots: [I]\n    show: [sqrt(I^2) = I]", IDENTITY_UNDECIDED, "square root I is not proved to be positive"},
    {"    angles: [psi]\n    small: [dL]\n    order: 1\n    square roots: [L]\n"
     "    show: [\"cos(atan2(L*sin(psi) + dL, L*cos(psi))) = cos(psi)\"]",
     IDENTITY_UNDECIDED, "cos(atan2(L*sin(psi) + dL, L*cos(psi))) = cos(psi): no value, a value that is no rational series"},
    {"    angles: [L]\n    square roots: [1 + sin(L)/(1 + cos(L))]\n    show: [sqrt((1 + sin(L)/(1 + cos(L)))^2) = 1 + sin(L)/(1 + cos(L))]", /* a tangent has any sign */
     IDENTITY_UNDECIDED, "square root 1 + sin(L)/(1 + cos(L)) is not proved to be positive"},
    {"    show: [0 = 1/(L - L)]", IDENTITY_UNDECIDED, "0 = 1/(L - L): no value, division by what is zero at epsilon = 0"},
    /* positive() jumps where a small quantity starts from */
    {"    positive: [k]\n    small: [k]\n    order: 1\n    show: [positive(k) = 0]",
     IDENTITY_UNDECIDED, "positive(k) = 0: no value, a value that is no rational series"},
    {"    positive: [k]\n    small: [k]\n    order: 1\n    show: [positive(L/(1/k)) = 0]", IDENTITY_UNDECIDED, "positive(L/(1/k)) = 0: no value"},
    {"    positive: [k]\n    small: [k]\n    order: 1\n    square roots: [2 - 2*positive(k)]\n    show: [sqrt((2 - 2*positive(k))^2 + k) = 2]",
     IDENTITY_UNDECIDED, "square root 2 - 2*positive(k) is not proved to be positive"},
    /* what is no number has no sign */
    {"    show: [positive(exp(L)) = 0]", IDENTITY_UNDECIDED, "positive(exp(L)) = 0: no value"},
    {"    show: [positive(1/(L - L)) = 0]", IDENTITY_UNDECIDED, "positive(1/(L - L)) = 0: no value"},
    {"    angles: [psi, theta]\n    show: [positive(psi + theta) = 0]", IDENTITY_UNDECIDED, "positive(psi + theta) = 0: no value"},
    {"    angles: [psi, theta]\n    square roots: [psi + theta]\n    show: [psi + theta = psi]", IDENTITY_UNDECIDED, "square root psi + theta is not proved"},
    {"    angles: [psi]\n    square roots: [psi + L]\n    show: [sqrt(L^2) = L]", IDENTITY_UNDECIDED, "square root psi + L is not proved"},
    {"    show: [positive(L) = 1, positive(-L) = 0, positive(L - L) = 0, positive(x1^2 + 1) = 1, positive(-x1^2) = 0]", IDENTITY_HOLDS, ""},
    {"    show: [positive(I) = 1]", IDENTITY_UNDECIDED, "positive(I) = 1: no value"},
    {"    show: [positive(x1) = 0]", IDENTITY_UNDECIDED, "positive(x1) = 0: no value"},
    {"    show: [positive(L - m1) = 0]", IDENTITY_UNDECIDED, "positive(L - m1) = 0: no value"}, /* of either sign */
    {"    quarter turns: [psi]\n    square roots: [cos(psi)]\n    show: [sqrt(cos(psi)^2) = cos(psi)]", IDENTITY_HOLDS, ""},
    {"    small: [theta]\n    order: 1\n    show: [theta*theta = 2*theta*theta]",
     IDENTITY_UNDECIDED, "theta*theta = 2*theta*theta: both sides vanish to this order: nothing is shown"},
    {"    small: [theta]\n    order: 0\n    show: [theta = 2*theta]", IDENTITY_UNDECIDED, "theta = 2*theta: both sides vanish to this order: nothing is shown"},
    {"    small: [theta]\n    order: 1\n    show: [theta^5 = 2*theta^5]", IDENTITY_UNDECIDED, "theta^5 = 2*theta^5: both sides vanish to this order"},
    {"    small: [theta]\n    order: 1\n    show: [theta^3 = theta^2*theta]", IDENTITY_UNDECIDED, "theta^3 = theta^2*theta: both sides vanish to this order"},
    {"    small: [dL]\n    order: 2\n    show: [L*dL + dL^2 = L^2*dL + 2*dL^2]", /* where L = 1 the next ones differ */
     IDENTITY_DIFFERS, "L*dL + dL^2 = L^2*dL + 2*dL^2: the coefficients of epsilon^1 differ by (-L^2*dL+L*dL); 8 is not 16 where L = 2, dL = 4 epsilon"},
    {"    show: [0 = m2]", IDENTITY_DIFFERS, "0 = m2: the sides differ by -m2; 0 is not 1 where m2 = 1"},
    {"    show: [sin(L) = L]", IDENTITY_UNDECIDED, "sin(L) = L: no value, the sine or cosine of a number that is no angle"},
    {"    show: [exp(L) = L]", IDENTITY_UNDECIDED, "exp(L) = L: no value, a value that is no rational series"},
    {"    angles: [psi]\n    show: [psi = psi]",
     IDENTITY_UNDECIDED, "psi = psi: no value, a finite angle outside sine and cosine"},
    {"    angles: [psi, theta]\n    show: [L + psi = L + theta]", IDENTITY_UNDECIDED, "L + psi = L + theta: no value, a finite angle outside sine and cosine"},
    {"    show: [1/(L - L) = 2/(L - L)]", IDENTITY_UNDECIDED, "1/(L - L) = 2/(L - L): no value"},
    {"    show: [1/(L - m1) = -1/(L - m1)]", IDENTITY_DIFFERS, "1/(L - m1) = -1/(L - m1): the sides differ by -2/(m1-L); 1/2 is not -1/2 where m1 = 2, L = 4"}, /* not where both are 1 */
    {"    show: [h = 2*h]", IDENTITY_DIFFERS, "h = 2*h: "}, /* the sheet's last */
    {"    show: [1/(L - L) = 1]", IDENTITY_UNDECIDED, "1/(L - L) = 1: no value, division by what is zero at epsilon = 0"},
    {"    positive: [k]\n    small: [k]\n    order: 1\n    let:\n      lambda_d: 1/k\n"
     "    show: [exp(-L/lambda_d) = 1 - L*k]",
     IDENTITY_HOLDS, ""},
    {"    angles: [psi]\n    square roots: [L]\n    show: [\"cos(atan2(L*sin(psi), L*cos(psi))) = cos(psi)\"]",
     IDENTITY_HOLDS, ""},
    {"    show: [eq05.x1 - eq05.x2 = L]", IDENTITY_HOLDS, ""},
    {"    show: [eq05.x1(m1 = m2) = L/2]", IDENTITY_HOLDS, ""},
    {"    show: [eq30.I_12 = eq30.I_12@printed]", IDENTITY_DIFFERS, ""},
    {"    show: [eq30.I_12(m2 = m1) = eq30.I_12@printed]", IDENTITY_HOLDS, ""},
    {"    show: [left(5b) - right(5b) = x1 - x2 - L]", IDENTITY_HOLDS, ""},
    {"    show: [\"left(24, 3) = I*w_dot_3 + I_dot*w_3 + I*w_1*w_2\"]", IDENTITY_HOLDS, ""},
    {"    free: [f_12, f_13]\n    show: [eq02.z1_ddot = (f_12*(z1 - z2) + f_13*(z1 - z3))/m1 - Omega^2*z1]",
     IDENTITY_HOLDS, ""},
};

EACH(prover_finds, COUNT(findings))
{
    struct derivations d;
    struct proof p;
    read_one(&d, findings[_i].step);
    identities_prove(&d.steps[0].corrected, &p);
    ck_assert_msg(p.result == findings[_i].result, "%s", p.evidence ? p.evidence : "holds");
    const char *begin = findings[_i].evidence;
    ck_assert_msg(strncmp(p.evidence ? p.evidence : "", begin, strlen(begin)) == 0, "%s", p.evidence);
    ck_assert(strcmp(begin, "p*q = 0: ") != 0 || strstr(p.evidence, " where ") == NULL);
    proof_clear(&p);
    derivations_clear(&d);
}

/* ---- signs of square roots ---- */

/*
 * What proves that a root is above zero, at epsilon = 0:
 *
 *   (Q1) a product's and a quotient's signs are those of its factors        (signs_by_form)
 *   (Q2) so is the cosine's of a quarter turn positive, and no other's
 *   (Q3) a polynomial has the signs of its terms, each by the signs of its variables and their exponents  (signs_of_polynomial)
 *   (Q4) small quantities are zero there                                    (signs_of)
 *   (Q5) a root is one of those proved, up to its sign                      (find_root)
 */
enum { NOT_PROVED, ABOVE_ZERO };

static const struct {
    const char *root;
    bool proved;
} root_signs[] = {
    /* (Q1) */
    {"L*m1", ABOVE_ZERO}, {"L/m1", ABOVE_ZERO}, {"I*L", NOT_PROVED}, {"I/L", NOT_PROVED}, {"L*x1", NOT_PROVED}, {"L/x1", NOT_PROVED},
    {"I*x1", NOT_PROVED}, {"x1*y1", NOT_PROVED}, {"L/x1^2", ABOVE_ZERO}, {"I/x1^2", NOT_PROVED}, {"-L/x1^2", NOT_PROVED}, {"L/(-x1^2)", NOT_PROVED},
    {"(-L)*(-m1)", ABOVE_ZERO}, {"(-L)/(-m1)", ABOVE_ZERO}, {"(-L)*m1", NOT_PROVED}, {"L/(-m1)", NOT_PROVED},
    /* (Q2) */
    {"cos(theta)", ABOVE_ZERO}, {"L*cos(theta)", ABOVE_ZERO}, {"cos(theta)/L", ABOVE_ZERO}, {"I*cos(theta)", NOT_PROVED}, {"cos(theta)/x1^2", ABOVE_ZERO},
    {"x1^2*cos(theta)", NOT_PROVED}, {"x1*cos(theta)", NOT_PROVED}, {"cos(theta)/x1", NOT_PROVED}, {"-cos(theta)", NOT_PROVED},
    {"(-L)*cos(theta)", NOT_PROVED}, {"cos(psi)", NOT_PROVED}, {"L*cos(psi)", NOT_PROVED}, {"sin(theta)", NOT_PROVED}, {"sin(psi)", NOT_PROVED},
    {"cos(psi)*cos(theta)", NOT_PROVED}, {"cos(-theta)", NOT_PROVED}, {"cos(2*theta/2)", NOT_PROVED}, {"cos(theta + psi)", NOT_PROVED},
    /* (Q3) */
    {"L + m1", ABOVE_ZERO}, {"I + L", ABOVE_ZERO}, {"I + I^2", NOT_PROVED}, {"I", NOT_PROVED}, {"I^2", NOT_PROVED}, {"x1^2 + 1", ABOVE_ZERO}, {"x1^2 + L", ABOVE_ZERO}, {"x1^2 + I", NOT_PROVED},
    {"x1^2*y1^4 + y1^2", NOT_PROVED}, {"L*x1^2 + m1", ABOVE_ZERO}, {"L^3", ABOVE_ZERO}, {"I^3", NOT_PROVED}, {"x1^4", NOT_PROVED}, {"x1^3", NOT_PROVED},
    {"x1^2*y1", NOT_PROVED}, {"x1^2*y1^3", NOT_PROVED}, {"x1^2 + y1", NOT_PROVED}, {"x1^2 - 1", NOT_PROVED}, {"1 - x1^2", NOT_PROVED}, {"L - m1", NOT_PROVED},
    {"I - L", NOT_PROVED}, {"L - I", NOT_PROVED}, {"-I", NOT_PROVED}, {"-L - I", NOT_PROVED}, {"x1", NOT_PROVED}, {"x1 + 1", NOT_PROVED}, {"-2", NOT_PROVED},
    {"2*L - L", ABOVE_ZERO}, {"(L^2 - m1^2)/(L - m1)", ABOVE_ZERO}, {"1 + 1/x1 - 1", NOT_PROVED}, {"L - L", NOT_PROVED},
    {"L/(x1^2 + 1)", ABOVE_ZERO}, {"x1^2 - 2*x1*y1 + y1^2", NOT_PROVED},
    /* (Q4) */
    {"L + dL", ABOVE_ZERO}, {"L*(1 + dL)", ABOVE_ZERO}, {"L*cos(dL)", ABOVE_ZERO}, {"L*exp(dL)", ABOVE_ZERO}, {"dL - L", NOT_PROVED}, {"dL", NOT_PROVED}, {"L*dL", NOT_PROVED},
};

EACH(sign_of_a_root_is_proved, COUNT(root_signs))
{
    const char *r = root_signs[_i].root, *why = root_signs[_i].proved ? NULL : "is not proved to be positive";
    struct derivations d;
    struct proof p;
    char step[900];
    snprintf(step, sizeof step, "    angles: [psi]\n    quarter turns: [theta]\n    small: [dL]\n    order: 1\n    square roots: [%s]\n    show:\n"
             "      - sin(psi) + sin(theta) + dL = dL + sin(theta) + sin(psi)\n      - sqrt((%s)^2 + dL*(%s)^2) = (%s)*(1 + dL/2)\n", r, r, r, r);
    read_one(&d, step);
    identities_prove(&d.steps[0].corrected, &p);
    ck_assert_int_eq(p.result, why == NULL ? IDENTITY_HOLDS : IDENTITY_UNDECIDED);
    ck_assert_msg(why == NULL || strstr(p.evidence, why) != NULL, "%s: %s", r, p.evidence);
    proof_clear(&p);
    derivations_clear(&d);
}

/* ---- false and careless steps ---- */

/* What is said of the one step of a file: by the reader, the prover or the binding. */
static void judge_step(const char *step, char said[600])
{
    struct derivations d;
    struct message why = {""};
    struct proof p;
    struct binding b = {.mutants = 0};
    const bool read = read_step_text(&d, step, &why);
    snprintf(said, 600, "%s", read ? "nothing" : why.text);
    if (!read)
        return;
    identities_prove(&d.steps[0].corrected, &p);
    if (p.result == IDENTITY_HOLDS)
        step_bind(&d, &d.steps[0], &b);
    if (p.evidence != NULL)
        snprintf(said, 600, "%s", p.evidence);
    else if (b.fault.text[0] != '\0')
        snprintf(said, 600, "%s", b.fault.text);
    proof_clear(&p);
    derivations_clear(&d);
}

#define CLOSED_LOOP \
    "    from: [\"17\", \"18\"]\n    to: [\"19\"]\n    let:\n      a: eq17.dL_ddot(dQ = eq18.dQ)\n      b: eq19.dL_ddot\n    show: [a = b]\n"

static const struct {
    const char *step, *said;
} refused[] = {
    /* the root of dL^2 is |dL| */
    {"    from: [\"16\"]\n    to: [\"7\"]\n    positive: [dL]\n    square roots: [dL]\n    show: [sqrt(dL^2) = dL]",
     "'dL' may be negative in the sheet, expected a name of its own"},
    {"    from: [\"16\"]\n    to: [\"7\"]\n    square roots: [dL]\n    show: [sqrt(dL^2) = dL]",
     "square root dL is not proved to be positive"},
    {"    from: [\"16\"]\n    to: [\"7\"]\n    square roots: [L - L_ref]\n    show: [sqrt((L - L_ref)^2) = L - L_ref]",
     "square root L - L_ref is not proved to be positive"},
    {"    from: [\"9\"]\n    to: [\"7\"]\n    angles: [psi]\n    square roots: [cos(psi)]\n"
     "    show: [sqrt(eq09.BO_22^2) = cos(psi)]",
     "square root cos(psi) is not proved to be positive"},
    {"    from: [\"9\"]\n    to: [\"7\"]\n    small: [dL]\n    order: 2\n    square roots: [dL*L]\n    show: [sqrt(dL^2*L^2) = dL*L]",
     "square root dL*L is not proved to be positive"},
    {"    from: [eq10]\n    to: [eq11exact]\n    small: [psi, psi_dot]\n    order: 0\n    rates: {L: L_dot, theta: theta_dot}\n"
     "    show: [eq11exact.z1_dot = rate(eq10.y1)]",
     "rate() of what rests on psi, expected psi: psi_dot among the rates"},
    {"    from: [eq10]\n    to: [eq11exact]\n    rates: {L: L_dot, psi: theta_dot, theta: theta_dot}\n"
     "    show: [eq11exact.z1_dot = rate(eq10.z1)]",
     "the rate of psi is psi_dot in the sheet"},
    {"    from: [\"39\"]\n    to: [40a]\n    small: [theta, theta_ddot]\n    order: 1\n"
     "    show: [theta*theta_ddot = theta*(-3*Omega^2*theta)]",
     "both sides vanish to this order: nothing is shown"},
    {"    from: [\"39\"]\n    to: [40a]\n    small: [theta, theta_ddot]\n    order: 2\n"
     "    show: [theta*theta_ddot = theta*(-3*Omega^2*theta)]",
     "the coefficients of epsilon^2 differ by (3*Omega^2*theta^2+theta*theta_ddot)"},
    {"    from: [\"36\", \"37\"]\n    to: [\"39\"]\n    small: [psi, theta]\n    order: 1\n    square roots: [R_c]\n    let:\n      I: 0\n"
     "      R_c1: eq36.R_c1\n      R_c2: eq36.R_c2\n      R_c3: eq36.R_c3\n"
     "    show: [eq37.L_G1 = eq39.L_G1, eq37.L_G2 = eq39.L_G2, eq37.L_G3 = eq39.L_G3]",
     "'36' is not used"},
    {"    from: [\"17\", \"18\"]\n    to: [\"19\"]\n"
     "    show: [eq17.dL_ddot(dQ = eq18.dQ) = eq19.dL_ddot + (dL - 9)*(dL + 481469837209919230)*(dL + 7698790055570312779)]",
     "the sides differ by "},
    {"    from: [coulomb]\n    to: [\"38\"]\n    square roots: [Omega]\n    let:\n      GM: Omega^2*R_c^3\n"
     "    show: [eq38.Omega = Omega]",
     "'coulomb' is not used: any formula in its place would do"},
    {"    from: [\"38\"]\n    to: [\"7\"]\n    show: [((2^999)^999)^999 = 1]", "too large to normalise, bits of a number: "},
    {"    from: [\"38\"]\n    to: [\"7\"]\n    show: [((L^999)^999)^999 = L]", "too large to normalise, degree: "},
    {"    from: [\"38\"]\n    to: [\"7\"]\n    show: [(m1 + m2 + L + Omega)^900 = L]", "too large to normalise, terms: "},
    {"    from: [\"38\"]\n    to: [\"7\"]\n    show: [((m1 + m2 + L + Omega)^8*(2^900)^8)^2 = L]",
     "too large to normalise, terms times bits: "},
    {"    from: [\"38\"]\n    to: [\"7\"]\n    show: [sqrt((m1 + m2 + L + Omega)^17) = L]", "too large to normalise, terms: "},
    {"    from: []\n    to: [\"39\"]\n    show: [eq39.L_G1 = 0, eq39.L_G2 = -3*Omega^2*I*theta, eq39.L_G3 = -3*Omega^2*I*psi]",
     "expected an equation or a principle in 'from'"},
    {"    from: [motion]\n    to: [eq05.x1]\n    square roots: [eq05.x1]\n"
     "    show: [\"motion.F(m = m1, a = sqrt(eq05.x1^2)) = m1*eq05.x1\"]", /* as true of another that is positive */
     "x1 stands in no equality"},
    {"    from: [\"17\"]\n    to: []\n    show: [\"eq17.dL_ddot(dQ = 0, psi_dot = 0) = 9*Omega^2*dL\"]",
     "expected an equation or a property in 'to'"},
    {"    from: [geometry]\n    to: [\"7\"]\n    show: [geometry.dot = 0]", "nothing here is called 'p_1', expected p_1 = ... in brackets"},
    /* lines that are true of anything: of no name of the step, of its definition a in any sense, and by way of another such line */
    {CLOSED_LOOP "    lines: {so: x1 - x1 = 0}", ":17: step one: x1 - x1 = 0 holds whatever the formulas are: it shows nothing"},
    {CLOSED_LOOP "    lines: {so: a - b = eq19.dL_ddot - a, and: a - a = 0}", ":48: step one: a - a = 0 holds whatever"},
    {CLOSED_LOOP "    lines: {so: 1 = a^0}", "1 = a^0 holds whatever the formulas are"},
    {CLOSED_LOOP "    lines: {so: x1 - x1 = y1 - y1 = 0}", "y1 - y1 = 0 holds whatever the formulas are"},
    {CLOSED_LOOP "    lines: {so: b - a = 0, and: b - a = x1 - x1 = 0, rest: 2*a = a + a}", "nothing"},
};

EACH(false_step_is_refused, COUNT(refused))
{
    char said[600];
    judge_step(refused[_i].step, said);
    ck_assert_msg(strstr(said, refused[_i].said) != NULL, "%s", said);
}

/* ---- emptied steps ---- */

enum { EMPTY_LEFT, EMPTY_RIGHT, EMPTY_DELETED };

/* A text that says one of its sides twice. */
static void empty_equality(char text[1000], const char *equality, bool left)
{
    const char *sign = side_end(equality, "=");
    const int length = left ? (int)(sign - equality) : (int)strlen(sign + 1);
    snprintf(text, 1000, "%.*s = %.*s", length, left ? equality : sign + 1, length, left ? equality : sign + 1);
}

/* Every equality of every step, replaced by its left or right side twice, or left out; of deletions, which take a whole binding each, some. */
TEST(emptied_step_is_refused)
{
    struct derivations d;
    int tried = 0, proved = 0;
    open_steps(&d);
    for (int i = 0; i < d.step_count; i++)
        for (int k = 0; k < d.steps[i].corrected.show->count; k++)
            for (int how = EMPTY_LEFT; how <= EMPTY_DELETED; how++) {
                struct step s = d.steps[i];
                struct yaml show = *s.corrected.show, equalities[MOST_SHOWN];
                struct message unused = {""}; /* what only the deleted one rested on */
                struct binding b = {.mutants = 0};
                char text[1000];
                struct proof p;
                if ((how > EMPTY_LEFT && k > 0) || (how == EMPTY_DELETED && (i % 5 > 0 || show.count == 1)))
                    continue;
                memcpy(equalities, show.items, (size_t)show.count * sizeof *equalities);
                empty_equality(text, equalities[k].text, how == EMPTY_LEFT);
                equalities[k].text = text;
                show.items = how == EMPTY_DELETED ? equalities + 1 : equalities;
                show.count -= how == EMPTY_DELETED;
                d.tree->why = &unused;
                ck_assert(identities_open(&s.corrected, &d.steps[i].corrected.scope));
                if (identities_show(&s.corrected, &show)) {
                    identities_prove(&s.corrected, &p);
                    if (p.result == IDENTITY_HOLDS)
                        step_bind(&d, &s, &b);
                    ck_assert_msg(p.result != IDENTITY_HOLDS || b.fault.text[0] != '\0', "%s: %s: %d", s.id, text, how);
                    proved += p.result == IDENTITY_HOLDS;
                    proof_clear(&p);
                }
                tried++;
                identities_clear(&s.corrected);
            }
    ck_assert_int_gt(tried, 250);
    ck_assert_int_gt(proved, 150);
    derivations_clear(&d);
}

/* Changes a sign, a factor, a number; false: nothing. */
static bool alter_node(struct node *n)
{
    static const enum operator others[OPERATOR_POSITIVE + 1] = {[OPERATOR_ADD] = OPERATOR_SUBTRACT, [OPERATOR_SUBTRACT] = OPERATOR_ADD,
                                                                 [OPERATOR_MULTIPLY] = OPERATOR_ADD, [OPERATOR_SIN] = OPERATOR_COS};
    const bool number = n->op == OPERATOR_NUMBER || n->op == OPERATOR_POWER;
    n->exponent += number;
    fmpq_add_si(&n->number, &n->number, number);
    if (others[n->op] != OPERATOR_INPUT)
        n->op = others[n->op];
    else
        return number;
    return true;
}

/*
 * All lines of the algebra by hand, their operators and numbers one at a time, of each line until three are noticed. An altered line
 * that is true still cannot be told from a right one: of terms that are zero, as the third component of (8), and of squares of what
 * may have either sign.
 */
TEST(altered_line_is_noticed)
{
    struct derivations d;
    int tried = 0, true_still = 0;
    open_steps(&d);
    for (int i = 0; i < d.step_count; i++) {
        struct identities line = d.steps[i].lines;
        const struct equality *end = line.shown + line.shown_count;
        int first = line.program.inputs; /* of the line's own nodes */
        ck_assert_msg(line.shown_count > 0, "%s", d.steps[i].id);
        for (int k = line.program.inputs; k < line.program.named; k++)
            first = FLINT_MAX(first, line.program.names[k].node + 1);
        for (int k = 0; k < line.root_count; k++)
            first = FLINT_MAX(first, line.roots[k].node + 1);
        for (line.shown_count = 1; line.shown < end; line.shown++) {
            const int last = FLINT_MAX(line.shown->left, line.shown->right);
            char *spoken = program_needs(&line.program, line.shown->left, NULL);
            int noticed = 0, here = 0;
            program_mark(&line.program, line.shown->right, NULL, spoken);
            for (int n = last; n >= first && noticed < 3; n--) {
                struct node *node = &line.program.nodes[n];
                const enum operator op = node->op;
                const slong exponent = node->exponent;
                struct proof p;
                if (!spoken[n] || !alter_node(node))
                    continue;
                identities_prove(&line, &p);
                noticed += p.result != IDENTITY_HOLDS;
                true_still += p.result == IDENTITY_HOLDS;
                here++;
                proof_clear(&p);
                fmpq_sub_si(&node->number, &node->number, node->exponent - exponent);
                node->op = op;
                node->exponent = exponent;
            }
            ck_assert_msg(noticed > 0 || here == 0, "%s: %s", d.steps[i].id, line.shown->text);
            tried += here;
            first = FLINT_MAX(first, last + 1);
            free(spoken);
        }
    }
    ck_assert_int_gt(tried, 500);
    ck_assert_int_lt(true_still, tried/25);
    derivations_clear(&d);
}

TEST(entry_stands_for_its_parts)
{
    struct derivations d;
    struct entry_part parts[MOST_PARTS];
    open_steps(&d);
    ck_assert_ptr_null(step_named(&d, "none"));
    ck_assert_ptr_eq(step_named(&d, d.steps[d.step_count - 1].id), &d.steps[d.step_count - 1]);
    ck_assert(entry_leads_to(&d, "6", "6a"));
    ck_assert(entry_leads_to(&d, "6a", "6a"));
    ck_assert(!entry_leads_to(&d, "6a", "6b"));
    ck_assert(!entry_leads_to(&d, "4", "40a"));
    ck_assert(entry_leads_to(&d, "eq10lin", "10"));
    ck_assert(entry_leads_to(&d, "eq40.dL_ddot", "40c"));
    ck_assert(!entry_leads_to(&d, "eq40.dL_ddot", "40a"));
    ck_assert_int_eq(entry_parts(&d, "2b", parts), 3);
    ck_assert_int_eq(entry_parts(&d, "5", parts), 14); /* two outputs, both sides of six relations */
    ck_assert_int_eq(entry_parts(&d, "99", parts), 0);
    ck_assert_int_eq(entry_parts(&d, "eq41roots", parts), 0); /* an algorithm */
    ck_assert_int_eq(entry_parts(&d, "eq02.f_12", parts), 1);
    derivations_clear(&d);
}

#define TEN_TIMES " = 2 = 3 = 4 = 5 = 6 = 7 = 8 = 9 = 10 = 11"
#define TWENTY_RATES "rate(rate(rate(rate(rate(rate(rate(rate(rate(rate(rate(rate(rate(rate(rate(rate(rate(rate(rate(rate"

static const char good[] =
    "principles: {force: {text: a push, inputs: [b, c], outputs: {F: b*c}}}\n" /*  1 */
    "properties: {length: {text: a length, inputs: [b], outputs: {p: b}}}\n"   /*  2 */
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
    "    square roots: [k]\n"                          /* 14 */
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

static const struct {
    const char *from, *to, *place, *expected;
} mistakes[] = {
    {"principles:", "principles:", NULL, NULL}, /* there is none */
    {"principles:", "principle:", "1:1: ", "unknown key 'principle', expected perhaps principles"},
    {"principles: {force: {text: a push, inputs: [b, c], outputs: {F: b*c}}}", "principles: force", "1:13: ",
     "expected a mapping, key: value"},
    {"principles:", "\x01principles:", "1:1: ", "control characters are not allowed"},
    {"properties: {length: {text: a length, inputs: [b], outputs: {p: b}}}", "properties: {length: 1}", "2:22: ",
     "expected a mapping, key: value"},
    {"properties:", "steps:", "3:1: ", "duplicate 'steps', expected each key once"},
    {"{text: a push, inputs", "{inputs", "1:21: ", "missing text, expected a text"},
    {"text: a push", "text: [a, push]", "1:28: ", "expected a text"},
    {"text: a push", "texts: a push", "1:22: ", "unknown key 'texts', expected perhaps text"},
    {"inputs: [b, c]", "inputs: [b, [c]]", "1:48: ", "expected a list of at most 40 texts"},
    {"inputs: [b, c]", "inputs: b", "1:44: ", "expected a list"},
    {"{F: b*c}", "{F: b*d}", "1:67: ", "unknown symbol 'd'"},
    {"{F: b*c}", "{F: [b]}", "1:65: ", "expected a formula"},
    {"{F: b*c}", "{a: b, c: b, d: b, e: b, f: b, g: b, h: b, i: b, j: b, k: b, l: b, m: b, n: b, o: b, p: b, q: b, r: b}", "1:61: ",
     "expected from 1 to 16 outputs"},
    {"{F: b*c}", "{}", "1:61: ", "expected from 1 to 16 outputs"},
    {"steps:\n", "tests:\n", "3:1: ", "unknown key 'tests', expected perhaps steps"},
    {"    title: a step\n", "", "5:5: ", "missing title, expected a text"},
    {"title: a step", "titel: a step", "5:5: ", "unknown key 'titel', expected perhaps title"},
    {"title: a step", "title: [a, step]", "5:12: ", "missing title, expected a text"},
    {"    from: [force, \"10\"]\n", "", "5:5: ", "missing from, expected a list of equation numbers"},
    {"[force, \"10\"]", "[forces, \"10\"]", "6:12: ", "unknown 'forces', expected an equation that has a formula, or a principle"},
    {"[force, \"10\"]", "[force, \"99\"]", "6:19: ", "unknown '99', expected an equation that has a formula, or a principle"},
    {"[force, \"10\"]", "force", "6:11: ", "expected a list"},
    {"to: [6a]", "to: [6c]", "7:10: ", "unknown '6c', expected an equation that has a formula, or a property"},
    {"to: [6a]", "to: [force]", "7:10: ", "unknown 'force', expected an equation that has a formula, or a property"},
    {"to: [6a]", "to: [6a, 6a]", "7:14: ", "duplicate '6a', expected each once"},
    {"to: [6a]", "from: [6a]", "7:5: ", "duplicate 'from', expected each key once"},
    {"free: [u]", "free: [u, L]", "8:15: ", "'L' is known already, expected a new name"},
    {"free: [u]", "free: [u, Omega]", "8:15: ", "'Omega' is known already, expected a new name"}, /* the first of all */
    {"free: [u]", "free: [u, v]", "8:15: ", "nothing shown rests on 'v'"},
    {"free: [u]", "free: u", "8:11: ", "expected a list"},
    {"positive: [k]", "positive: [k, x1]", "9:19: ", "'x1' may be negative in the sheet, expected a name of its own"},
    {"positive: [k]", "positive: [k, dL]", "9:19: ", "'dL' may be negative in the sheet, expected a name of its own"},
    {"positive: [k]", "positive: [k, I]", "9:19: ", "'I' may be zero in the sheet, expected a name of its own"},
    {"angles: [psi]", "angles: {psi: any}", "10:13: ", "expected a list"},
    {"positive: [k]", "positive: []", "16:15: ", "unknown symbol 'k'"},
    {"angles: [psi]", "angles: [psi, psi]", "10:19: ", "'psi' is an angle or small already"},
    {"small: [theta]", "small: [theta, theta]", "11:20: ", "'theta' is an angle or small already"},
    {"small: [theta]", "small: [theta, psi]", "11:20: ", "'psi' is an angle or small already"},
    {"small: [theta]", "small: [theta, thta]", "11:20: ", "unknown symbol 'thta', expected a free quantity"},
    {"    order: 1\n", "", "5:5: ", "missing order: up to which power of the small quantities"},
    {"order: 1", "order: 10", "12:12: ", "expected an order from 0 to 9"},
    {"order: 1", "order: /", "12:12: ", "expected an order from 0 to 9"},
    {"order: 1", "order: first", "12:12: ", "expected an order from 0 to 9"},
    {"order: 1", "order: -1", "12:12: ", "expected an order from 0 to 9"},
    {"order: 1", "order: a", "12:12: ", "expected an order from 0 to 9"},
    {"order: 1", "order: [1]", "12:12: ", "expected an order from 0 to 9"},
    {"{psi: psi_dot}", "{psi: psi_dot, phi: psi_dot}", "13:27: ", "unknown symbol 'phi', expected name: its rate"},
    {"{psi: psi_dot}", "{psi: psi_dot, u: u_dot}", "13:30: ", "unknown symbol 'u_dot', expected name: its rate"},
    {"{psi: psi_dot}", "{L: L_dot}", "17:14: ", "rate() of what rests on psi, expected psi: psi_dot among the rates"},
    {"    rates: {psi: psi_dot}\n", "", "16:14: ", "rate() of what rests on psi, expected psi: psi_dot among the rates"},
    {"{psi: psi_dot}", "{psi: psi_dot, L: L_ddot}", "13:30: ", "the rate of L is L_dot in the sheet"},
    {"{psi: psi_dot}", "{psi: psi_dot, L_dot: L}", "13:34: ", "the rate of L_dot is L_ddot in the sheet"},
    {"{psi: psi_dot}", "{psi: psi_dot, w_2: L}", "13:32: ", "the rate of w_2 is w_dot_2 in the sheet"},
    {"{psi: psi_dot}", "[psi, psi_dot]", "13:12: ", "expected a mapping, key: value"},
    {"square roots: [k]", "square roots: k", "14:19: ", "expected a list"},
    {"      let:\n        a: k*u + 1\n", "      let: a\n", "21:12: ", "expected a mapping, key: value"},
    {"small: [theta]", "small: [theta, R_c]", "11:20: ", "nothing shown rests on 'R_c'"},
    {"    show:\n      - a + b", "      c: 2*k\n    show:\n      - a + b", "18:7: ", "nothing shown rests on 'c'"},
    {"square roots: [k]", "square roots: [k +]", "14:23: ", "expected a number, a symbol or '(', the formula ends here"},
    {"      a: sqrt", "      c: 2*k\n      a: sqrt", "16:7: ", "nothing shown rests on 'c'"},
    {"      b: rate", "      a: rate", "17:7: ", "duplicate 'a', expected each key once"},
    {"sqrt(k^2)*u", "sqrt(k^2)*w", "16:20: ", "unknown symbol 'w'"},
    {"sqrt(k^2)*u", "sqrt(k^2)*\n        w", "17:9: ", "unknown symbol 'w'"}, /* where a further line has it */
    {"sqrt(k^2)*u", "[k, u]", "16:10: ", "expected a formula"},
    {"{psi: psi_dot}", "{psi: [psi_dot]}", "13:18: ", "expected a text"},
    {"rate(sin(psi))", "rates(sin(psi))", "17:10: ", "unknown function 'rates', expected rate, left, right, sqrt"},
    {"rate(sin(psi))", "rate(Omega, 1)", "17:20: ", "expected ')' or an operator, found ','"},
    {"rate(sin(psi))", "rate()", "17:15: ", "expected a number, a symbol or '(', found ')'"},
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
    {"eq10.x1(L = 2*m1)", "force.F(b = 2*m1)", "17:44: ", "nothing here is called 'c', expected c = ... in brackets"},
    {"(L = 2*m1)", "(M = 2*m1)", "17:35: ", "unknown name 'M', expected an input or a named subexpression"},
    {"(L = 2*m1)", "(L 2*m1)", "17:37: ", "expected '=', found '2'"},
    {"(L = 2*m1)", "(L = 2*m9)", "17:41: ", "unknown symbol 'm9'"},
    {"(L = 2*m1)", "(L = 2*m1", "17:43: ", "expected an operator, ',' or ')', the formula ends here"},
    {"(L = 2*m1)", "()", "17:35: ", "expected a name, found ')'"},
    {"      - a + b*theta = theta*b + a\n", "      - a + b*theta\n", "19:9: ", "expected left = right"},
    {"      - a + b*theta = theta*b + a\n", "      - a + b*theta =\n          theta*b + q\n", "20:21: ", "unknown symbol 'q'"},
    {"      - a + b*theta = theta*b + a\n", "      - [a + b*theta]\n", "19:9: ", "expected a list of at most"},
    {"      - a + b*theta = theta*b + a\n", "      - a + b*theta =\n", "19:22: ", "expected a number, a symbol or '('"},
    {"      - a + b*theta = theta*b + a\n", "      - a + b* = theta*b + a\n", "19:15: ",
     "expected a number, a symbol or '(', the formula ends here"},
    {"      - a + b*theta = theta*b + a\n", "      - a + b*theta = theta*b + q\n", "19:33: ", "unknown symbol 'q'"},
    {"    show:\n      - a + b*theta = theta*b + a\n", "    show: {x: a + b*theta = theta*b + a}\n", "18:11: ", "expected a list"},
    {"    show:\n      - a + b*theta = theta*b + a\n", "    show: []\n", "18:11: ",
     "expected at least one left = right"},
    {"    show:\n      - a + b*theta = theta*b + a\n", "", "5:5: ", "missing show, expected a list of left = right"},
    {"        a: k*u + 1\n", "        c: k*u + 1\n", "24:11: ", "unknown symbol 'a'"},
    {"        a: k*u + 1\n", "        a: k*u + \n", "22:17: ", "expected a number, a symbol or '('"},
    {"      show:\n        - a = k*u\n", "", "21:7: ", "missing show, expected a list of left = right"},
    {"      show:\n        - a = k*u\n", "      shown:\n        - a = k*u\n", "23:7: ",
     "unknown key 'shown', expected perhaps show"},
    {"    printed:\n", "    lines: {' ': a = k*u}\n    printed:\n", "20:18: ", "expected how it follows, and not a blank key"},
    {"    printed:\n", "    lines: {put it: a + b*theta = theta*b+a}\n    printed:\n", "20:21: ", "that is what the step shows, expected how"},
    {"    printed:\n", "    lines: {put it: [a = k*u]}\n    printed:\n", "20:21: ", "expected left = right"},
    {"    printed:\n", "    lines: {put it: u = u}\n    printed:\n", "20:21: ", "both sides read the same: the line says nothing"},
    {"    printed:\n", "    lines: {put it: a = k*u, and: a = k*u}\n    printed:\n", "20:35: ", "that is said already"},
    {"    printed:\n", "    lines: {put it: a = k*w, and: a = k*u}\n    printed:\n", "20:27: ", "unknown symbol 'w'"},
    {"    printed:\n", "    lines: {put it: a = k*u, and: u*k = a = k*u}\n    printed:\n", "20:41: ", "that is said already"},
    {"    printed:\n", "    lines: {put it: a = k*u = w}\n    printed:\n", "20:31: ", "unknown symbol 'w'"},
    {"    printed:\n", "    lines: {}\n    printed:\n", "20:12: ", "expected at least one line"},
    {"    printed:\n", "    lines: [a = k*u]\n    printed:\n", "20:12: ", "expected a mapping, key: value"},
    {"    show:\n", "    lines: {put it: 1 = 1" TEN_TIMES TEN_TIMES TEN_TIMES TEN_TIMES "}\n    show:\n", "18:21: ", "expected at most 32 equalities"},
    {"  two:", "  one:", "25:3: ", "duplicate 'one', expected each key once"},
    {"\"left(24, 2) = left", "\"left(24, 4) = left", "29:17: ",
     "unknown relation 4 of (24), expected one of the sheet"},
    {"\"left(24, 2) = left", "\"left(24, 2x) = left", "29:17: ", "unknown relation 2x of (24)"},
    {"\"left(24, 2) = left", "\"left(24; 2) = left", "29:20: ", "expected ',' or ')', found ';'"},
    {"\"left(24, 2) = left", "\"left() = left", "29:18: ", "expected a name, found ')'"},
    {"{psi: psi_dot}\n    square roots: [k]\n    let:\n      a: sqrt(k^2)*u\n      b: rate(sin(psi))",
     "{psi: psi_dot, psi_dot: psi_ddot}\n    square roots: [k]\n    let:\n      a: sqrt(k^2)*u\n      b: " TWENTY_RATES "(sin(psi)^2)))))))))))))))))))))", "17:", "expected fewer rates of rates, found ')'"},
    {"    to: []\n", "    to: []\n    order: 1\n", "29:12: ", "expected no order where no quantities are small"},
    {"[force, \"10\"]", "[force, \"10\"", "", "expected YAML: "},
};

EACH(mistake_is_told_with_its_place, COUNT(mistakes))
{
    struct derivations d;
    struct message why = {""};
    const char *at = strstr(good, mistakes[_i].from);
    char *text = malloc(sizeof good + strlen(mistakes[_i].to)), place[40];
    ck_assert_msg(at != NULL, "no '%s'", mistakes[_i].from);
    sprintf(text, "%.*s%s%s", (int)(at - good), good, mistakes[_i].to, at + strlen(mistakes[_i].from));
    const bool read = derivations_read(&d, sheet(), text, strlen(text), "t.yaml", &why) == 0;
    free(text);
    ck_assert_msg(read == (mistakes[_i].place == NULL), "%s", why.text);
    if (read) {
        derivations_clear(&d);
        return;
    }
    snprintf(place, sizeof place, "t.yaml:%s", mistakes[_i].place);
    ck_assert_msg(strncmp(why.text, place, strlen(place)) == 0, "'%s' is not at %s", why.text, place);
    ck_assert_msg(strstr(why.text, mistakes[_i].expected) != NULL, "'%s' has no '%s'", why.text, mistakes[_i].expected);
}

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
    {"\"$CT_PROGRAM\" verify derivations closed_loop >$CT_BUILD/tests/step && grep -q '^1 of 1 steps hold' $CT_BUILD/tests/step && "
     "grep -q '^[1-9][0-9]* alterations of their equations were tried' $CT_BUILD/tests/step", 0},
    {"\"$CT_PROGRAM\" verify derivations separation --json | grep -qF '{\"how\": \"square (13)\", \"tex\": "
     "[\"{{L}_{(13)}}^{2}\", \"\\\\left(\\\\frac{m_{1} + m_{2}}{m_{2}}\\\\right)^{2}(x_{1}^{2} + y_{1}^{2} + z_{1}^{2})\"]}'", 0},
    {"\"$CT_PROGRAM\" verify derivations closed_lop 2>&1 | grep -q \"unknown step 'closed_lop', did you mean 'closed_loop'\"", 0},
    {"\"$CT_PROGRAM\" verify derivations kepler --json | "
     "if command -v python3 >/dev/null; then python3 -m json.tool >/dev/null; else grep -q '\"id\": \"kepler\"'; fi", 0},
    {"\"$CT_PROGRAM\" verify derivations closed_loop >/dev/full 2>/dev/null", 1},
};

EACH(command_has_its_status, COUNT(commands))
{
    ck_assert_int_eq(shell(commands[_i].line), commands[_i].status);
}
