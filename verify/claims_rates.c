/*
 * Claims about the roots of (41): where they lie, how they follow n, which gains damp fastest.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "algebra.h"
#include "claims_stability.h"
#include "decimal.h"
#include "operation.h"
#include "optimum.h"
#include "roots.h"

enum { DEGREE = 4 };

/* ---- what is said ----------------------------------------------------- */

bool say(struct evidence *e, const char *before, const arb_t x, slong digits)
{
    char *text = decimal_of_ball(x, digits);
    if (text == NULL) {
        evidence_add(e, "%sundecided", before);
        return false;
    }
    const char *sign = text[0] == '-' ? "-" : "", *figures = text + strlen(sign);
    char *mark = strchr(text, 'e');
    long exponent = mark == NULL ? 0 : strtol(mark + 1, NULL, 10);
    if (mark == NULL || exponent < -3 || exponent > digits - 2) {
        evidence_add(e, "%s%s", before, text);
    } else { /* d.ddd and its exponent */
        *mark = '\0';
        evidence_add(e, "%s%s", before, sign);
        if (exponent < 0)
            evidence_add(e, "0.%.*s%c%s", (int)-exponent - 1, "00", figures[0], figures + 2);
        else
            evidence_add(e, "%c%.*s.%s", figures[0], (int)exponent, figures + 2, figures + 2 + exponent);
    }
    free(text);
    return true;
}

bool say_ratio(struct evidence *e, const char *before, const arb_t x, const arb_t y, slong digits)
{
    arb_t ratio;
    arb_init(ratio);
    arb_div(ratio, x, y, CLAIM_BITS);
    bool proved = say(e, before, ratio, digits);
    arb_clear(ratio);
    return proved;
}

void table_rate(arb_t Omega)
{
    fmpq_t q;
    fmpq_init(q);
    literal_read(q, quantity_find(sheet(), "Omega")->value, true);
    arb_set_fmpq(Omega, q, CLAIM_BITS);
    fmpq_clear(q);
}

/* ---- the modes -------------------------------------------------------- */

/* Of the slower and the faster pair of roots on (44): the rate of decay, and the frequency. */
struct modes {
    acb_ptr roots; /* as roots41_gains sorts them: the slower pair last */
    arb_t slow, fast;
    arb_ptr slow_frequency, fast_frequency;
};

/* False when the roots are not isolated or are not two pairs. n is exact. */
static bool modes_init(struct modes *m, double n)
{
    arb_t c1, c2;
    arb_init(c1);
    arb_init(c2);
    m->roots = _acb_vec_init(DEGREE);
    arb_set_d(c1, n);
    arb_sub_si(c2, c1, 9, CLAIM_BITS);
    arb_sqrt(c2, c2, CLAIM_BITS);
    arb_mul_2exp_si(c2, c2, 1);
    bool found = roots41_gains(m->roots, c1, c2, CLAIM_BITS);
    arb_init(m->slow);
    arb_init(m->fast);
    arb_neg(m->slow, acb_realref(m->roots + 3));
    arb_neg(m->fast, acb_realref(m->roots + 1));
    m->slow_frequency = acb_imagref(m->roots + 3);
    m->fast_frequency = acb_imagref(m->roots + 1);
    arb_clear(c1);
    arb_clear(c2);
    return found && arb_is_positive(m->slow_frequency) && arb_is_positive(m->fast_frequency);
}

static void modes_clear(struct modes *m)
{
    _acb_vec_clear(m->roots, DEGREE);
    arb_clear(m->slow);
    arb_clear(m->fast);
}

/* (43) and (44) at n = 9 + u^2: (9 + u^2) Omega^2 and 2 u Omega, both of degree 2 at most in u and in Omega. */
static bool gains_of_n(void)
{
    bool as_expected = true;
    fmpq *gain = _fmpq_vec_init(2);
    for (slong k = 0; k < 3 * 3 && as_expected; k++) {
        const slong u = 1 + k % 3, Omega = 1 + k / 3, inputs[2] = {Omega, 9 + u * u};
        as_expected = section_at("eq43", inputs, gain) && section_at("eq44", inputs, gain + 1) &&
                      fmpq_cmp_si(gain, (9 + u * u) * Omega * Omega) == 0 &&
                      fmpq_cmp_si(gain + 1, 2 * u * Omega) == 0;
    }
    _fmpq_vec_clear(gain, 2);
    return as_expected;
}

/* What is said of (44) stands on the sheet's gains and on the rates that these give. */
static bool on_44(void)
{
    return gains_of_n() && rates_proved();
}

/* ---- the characteristic equation -------------------------------------- */

void decide_characteristic(struct evidence *e)
{
    bool proved = true;
    fmpq *a = _fmpq_vec_init(DEGREE + 1);
    fmpq_poly_t product, pitch;
    fmpq_mat_t A;
    fmpq_poly_init(product);
    fmpq_poly_init(pitch);
    fmpq_mat_init(A, STATE, STATE);
    /* a coefficient takes each row of the matrix once: Omega^6 at most, C1, C2, and L_ref^-1 ... L_ref */
    for (int k = 0; k < 7 * 3 * 2 * 2 && proved; k++) {
        const slong p[4] = {1 + k % 7, 1 + k / 7 % 3, 1 + k / 21 % 2, 1 + k / 42};
        const slong gains[3] = {p[0], p[2], p[3]};
        proved = linear_model(A, p) && section_at("eq41", gains, a);
        fmpq_poly_zero(product);
        for (int i = 0; i <= DEGREE; i++)
            fmpq_poly_set_coeff_fmpq(product, i, a + i);
        fmpq_poly_set_coeff_si(pitch, 0, 4 * p[0] * p[0]);
        fmpq_poly_set_coeff_si(pitch, 2, 1);
        fmpq_poly_mul(product, product, pitch);
        fmpq_mat_charpoly(pitch, A);
        proved = proved && fmpq_poly_equal(pitch, product);
        fmpq_poly_zero(pitch);
    }
    fmpq_poly_clear(product);
    fmpq_poly_clear(pitch);
    fmpq_mat_clear(A);
    _fmpq_vec_clear(a, DEGREE + 1);
    evidence_add(e, "det(lambda - A) of the six equations (40) is (lambda^2 + 4 Omega^2) times (41), for all "
                    "Omega, L_ref, C1, C2: L_ref cancels (it only scales dL against psi); masses and k_c are "
                    "not even in (40)");
    evidence_decide(e, HOLDS, EXACT, proved);
}

void decide_roots_scale(struct evidence *e)
{
    bool proved = rates_proved() && /* the sheet's (41) is the product on the left */
                  identity("O s c d", "((O*s)^2 + 3*O^2)*((O*s)^2 + d*O*O*s + c*O^2 - 9*O^2) + 4*O^2*(O*s)^2",
                           "O^4*((s^2 + 3)*(s^2 + d*s + c - 9) + 4*s^2)");
    evidence_add(e, "(41) is (lambda^2 + 3 Omega^2)(lambda^2 + C2 lambda + C1 - 9 Omega^2) + 4 Omega^2 "
                    "lambda^2; with C1 = c1 Omega^2, C2 = c2 Omega it is Omega^4 times a polynomial in "
                    "lambda/Omega: for given n the roots are proportional to Omega and depend on nothing else");
    evidence_decide(e, HOLDS, EXACT, proved);
}

/* Adds a polynomial in the variable of that name, cleared of fractions. */
static void say_polynomial(struct evidence *e, const fmpq_poly_t f, const char *variable)
{
    fmpz_poly_t g;
    fmpz_poly_init(g);
    fmpq_poly_get_numerator(g, f);
    char *text = fmpz_poly_get_str_pretty(g, variable);
    evidence_add(e, "%s", text);
    flint_free(text);
    fmpz_poly_clear(g);
}

void decide_complex_pairs(struct evidence *e)
{
    fmpq_poly_t f;
    fmpq_t zero;
    fmpq_poly_init(f);
    fmpq_init(zero);
    bool proved = on_44() &&
                  identity("y w", "y*(y + 7)^2 - w*(y^2 + 14*y + 1)", "y^3 + (14 - w)*y^2 + (49 - 14*w)*y - w");
    /* a quartic's discriminant is that of its resolvent cubic y^3 + b y^2 + c y + d */
    polynomial(f, "18*(14 - x)*(49 - 14*x)*(-x) - 4*(14 - x)^3*(-x) + (14 - x)^2*(49 - 14*x)^2"
                  " - 4*(49 - 14*x)^3 - 27*x^2");
    proved = proved && has_sign_beyond(f, zero, 1);
    evidence_add(e, "on (44) with u = sqrt(n - 9), s = lambda/Omega, (41) is (s^2 + 3)(s + u)^2 + (2 s)^2: no "
                    "real s makes it zero, for every n > 9; its discriminant ");
    say_polynomial(e, f, "w");
    evidence_add(e, ", w = n - 9, has no root w > 0 (Sturm), so there are four different roots; the two real "
                    "parts are never equal either: they are -(u +- t)/2 with t > 0, t^2 = y the root of y (y + "
                    "7)^2 = w (y^2 + 14 y + 1)");
    fmpq_poly_clear(f);
    fmpq_clear(zero);
    evidence_decide(e, HOLDS, EXACT, proved);
}

void decide_complex_pairs_any(struct evidence *e)
{
    fmpq_poly_t f;
    fmpq_t left;
    fmpq_poly_init(f);
    fmpq_init(left);
    polynomial(f, "(x^2 + 3)*(x^2 + 4*x + 10 - 9) + 4*x^2");
    fmpq_set_si(left, -100, 1); /* left of all roots: past the sum of the coefficients' sizes */
    slong real = roots_beyond(f, left);
    bool squares = rates_proved() && identity("s c a", "(s^2 + 3)*(s^2 + c*s + a) + 4*s^2",
                                              "(s^2 + 3)*((s + c/2)^2 + (a - c^2/4)) + (2*s)^2");
    evidence_add(e, "true while C2^2 <= 4 (C1 - 9 Omega^2), dL alone not overdamped: then (41) is a sum of "
                    "squares. Not for all gains of (42): C1 = 10 Omega^2, C2 = 4 Omega gives ");
    say_polynomial(e, f, "s");
    evidence_add(e, " with %ld real roots", (long)real);
    fmpq_poly_clear(f);
    fmpq_clear(left);
    e->why = "While C2^2 <= 4 (C1 - 9 Omega^2), so under (44); not for all gains of (42).";
    evidence_decide(e, QUALIFIED, EXACT, squares && real > 0);
}

/* ---- rates ------------------------------------------------------------ */

void decide_limits(struct evidence *e)
{
    bool proved = on_44() && slow_rate_compares("x", "49", 0, 1, -1) &&
                  slow_rate_compares("x*(4 + 3*x)^2", "784", 0, 1, 1) &&
                  slow_rate_compares("(x^2 - 24)^2", "x^3", 24, 5, -1) && /* for w^2 <= 24 u/2 <= 12/u^3 */
                  slow_rate_compares("(x^3 - 24*(x - 14))^2", "x^5", 14, 1, 1);
    static const double n[2] = {9 + 1 / 16.0, 40};
    static const char *const at[2] = {" at n = 9.0625, u = 1/4, they are -", "; at n = 40 -"};
    evidence_add(e, "with u = sqrt(n - 9), rates over Omega, for every n > 9: the slower lies between (3/7) u "
                    "(1 - u^2/8) and (3/7) u, and between 12/u^3 (1 - 14/u^2) and 12/u^3; the faster is u less "
                    "the slower. So for n -> 9 both real parts tend to zero, as -3u/7 and -4u/7; for n -> "
                    "infinity one does, as -12/u^3, while the other grows as -u. That is at the ends, not next "
                    "to 12:");
    for (int k = 0; k < 2; k++) {
        struct modes m;
        proved = modes_init(&m, n[k]) && proved;
        proved = say(e, at[k], m.slow, 10) && proved;
        proved = say(e, " and -", m.fast, 10) && proved;
        modes_clear(&m);
    }
    e->why = "At the ends, n = 9 and n without bound, not next to 12.";
    evidence_decide(e, QUALIFIED, CERTIFIED, proved);
}

void decide_slow_ends(struct evidence *e)
{
    struct optimum o;
    optimum_init(&o);
    bool proved = on_44() && optimum_find(&o, CLAIM_BITS) && slow_rate_compares("x", "49", 0, 1, -1) &&
                  slow_rate_compares("(x^2 - 24)^2", "x^3", 24, 5, -1);
    proved = say(e, "the slower rate grows on (9, n*) and falls on (n*, infinity), n* = ", o.n, 16) && proved;
    evidence_add(e, " being its only stationary point; it is below (3/7) sqrt(n - 9) Omega and below 12 (n - "
                    "9)^(-3/2) Omega");
    optimum_clear(&o);
    evidence_decide(e, HOLDS, CERTIFIED, proved);
}

/*
 * At n = 12 the cubic is (y + 1)((y + 5)^2 - 28). Its positive root gives the rates
 * (sqrt 3 -+ sqrt(2 sqrt 7 - 5))/2; the others are -(difference of the frequencies)^2 = -1 and
 * -(their sum)^2 = -(2 sqrt 7 + 5).
 */
static bool closed_form_12(const struct modes *m)
{
    arb_t x, y;
    arb_init(x);
    arb_init(y);
    bool same = identity("y", "y*(y + 7)^2 - 3*(y^2 + 14*y + 1)", "(y + 1)*((y + 5)^2 - 28)");
    arb_sqrt_ui(x, 28, CLAIM_BITS);
    arb_sub_ui(x, x, 5, CLAIM_BITS);
    arb_sub(y, m->fast, m->slow, CLAIM_BITS);
    arb_mul(y, y, y, CLAIM_BITS);
    same = same && arb_overlaps(x, y);
    arb_add_ui(x, x, 10, CLAIM_BITS);
    arb_add(y, m->fast_frequency, m->slow_frequency, CLAIM_BITS);
    arb_mul(y, y, y, CLAIM_BITS);
    same = same && arb_overlaps(x, y);
    arb_sub(y, m->fast_frequency, m->slow_frequency, CLAIM_BITS);
    same = same && arb_contains_si(y, 1);
    arb_clear(x);
    arb_clear(y);
    return same;
}

void decide_n12(struct evidence *e)
{
    struct optimum o;
    struct modes twelve, ten;
    optimum_init(&o);
    bool proved = on_44() && optimum_find(&o, CLAIM_BITS);
    proved = modes_init(&twelve, 12) && proved;
    proved = modes_init(&ten, 10) && proved && closed_form_12(&twelve);
    char *n = fmpz_poly_get_str_pretty(o.n_solves, "n"), *z = fmpz_poly_get_str_pretty(o.square_solves, "z");
    proved = say(e, "under (44) the decay is fastest at n* = ", o.n, 24) && proved;
    evidence_add(e, ", a root of %s, the only stationary point on n > 9 (Sturm)", n);
    proved = say(e, ": rate ", o.rate, 24) && proved;
    evidence_add(e, " Omega, its square a root of %s", z);
    proved = say(e, "; n = 12: ", twelve.slow, 22) && proved;
    proved = say_ratio(e, " = (sqrt 3 - sqrt(2 sqrt 7 - 5))/2, ", twelve.slow, o.rate, 12) && proved;
    proved = say(e, " of the best; n = 10: ", ten.slow, 22) && proved;
    proved = say_ratio(e, ", ", ten.slow, o.rate, 12) && proved;
    evidence_add(e, " of it");
    flint_free(n);
    flint_free(z);
    proved = proved && !arb_contains_si(o.n, 12) && arb_lt(twelve.slow, o.rate) && arb_lt(ten.slow, o.rate);
    modes_clear(&twelve);
    modes_clear(&ten);
    optimum_clear(&o);
    e->why = "The slower pair decays fastest at n = 11.81; n = 12 is within half a percent of it.";
    evidence_decide(e, REFUTED, CERTIFIED, proved);
}

/*
 * Any real quartic is (s^2 + p s + q)(s^2 + P s + R). That it is (41) for some gains are two equations:
 * f = p (R - 3) + P (q - 3) = 0 and g = (q - 3)(R - 3) + 12 - 3 p P = 0; and p g - (q - 3) f = 0 gives
 * 3 p (4 - p P) = P (q - 3)^2 >= 0. A rate r of all roots makes p and P at least 2 r, so 4 r^2 <= 4.
 */
static bool rate_at_most_one(void)
{
    return section_identity("eq41", "a1", "3*Omega^2*a3") &&
           section_identity("eq41", "a0", "3*Omega^2*a2 - 21*Omega^4") &&
           identity("p q P R", "(p*R + P*q) - 3*(p + P)", "p*(R - 3) + P*(q - 3)") &&
           identity("p q P R", "q*R - (3*(q + R + p*P) - 21)", "(q - 3)*(R - 3) + 12 - 3*p*P") &&
           identity("p q P R", "p*((q - 3)*(R - 3) + 12 - 3*p*P) - (q - 3)*(p*(R - 3) + P*(q - 3))",
                    "3*p*(4 - p*P) - P*(q - 3)^2");
}

/* At C1 = 12 Omega^2, C2 = 4 Omega: the matrix B solves (B^2 + 2 B + 3)^2 = 0, but B^2 + 2 B + 3 is not zero. */
static bool best_is_defective(void)
{
    const slong best[4] = {1, 1, 12, 4};
    fmpq_mat_t B, square;
    fmpq_mat_init(B, PLANE, PLANE);
    fmpq_mat_init(square, PLANE, PLANE);
    bool defective = plane_model(B, best) && characteristic_is(B, "(x^2 + 2*x + 3)^2");
    fmpq_mat_mul(square, B, B);
    fmpq_mat_add(square, square, B);
    fmpq_mat_add(square, square, B);
    for (int i = 0; i < PLANE; i++)
        fmpq_add_si(fmpq_mat_entry(square, i, i), fmpq_mat_entry(square, i, i), 3);
    defective = defective && !fmpq_mat_is_zero(square);
    fmpq_mat_clear(B);
    fmpq_mat_clear(square);
    return defective;
}

void decide_both_gains(struct evidence *e)
{
    bool proved = rate_at_most_one() && best_is_defective();
    struct optimum o;
    struct modes twelve, ten;
    arb_t one;
    optimum_init(&o);
    arb_init(one);
    arb_one(one);
    proved = optimum_find(&o, CLAIM_BITS) && proved;
    proved = modes_init(&twelve, 12) && proved;
    proved = modes_init(&ten, 10) && proved;
    evidence_add(e, "true of C1 when C2 is free too: over all gains the slowest root decays at Omega at most, "
                    "and at Omega only with C1 = 12 Omega^2, C2 = 4 Omega, where (41) is (lambda^2 + 2 Omega "
                    "lambda + 3 Omega^2)^2. Every real quartic is (s^2 + p s + q)(s^2 + P s + R); to be (41) "
                    "it needs p (R - 3) + P (q - 3) = 0 and (q - 3)(R - 3) = 3 (p P - 4), hence 3 p (4 - p P) "
                    "= P (q - 3)^2 and p P <= 4, while a rate r needs p, P >= 2 r. The frequencies match, but "
                    "C2 is 2/sqrt 3 times that of (44), and dL alone overdamped");
    proved = say_ratio(e, ". It decays ", one, o.rate, 10) && proved;
    proved = say_ratio(e, " times as fast as the best of (44), ", one, twelve.slow, 10) && proved;
    proved = say_ratio(e, " times n = 12, ", one, ten.slow, 10) && proved;
    evidence_add(e, " times n = 10, the simulation's. The pair -1 +- i sqrt 2 is double and defective: "
                    "amplitudes go as t exp(-Omega t)");
    modes_clear(&twelve);
    modes_clear(&ten);
    optimum_clear(&o);
    arb_clear(one);
    e->why = "True of C1 once C2 is free too; and then C2 = 4 Omega, which is not (44).";
    evidence_decide(e, QUALIFIED, CERTIFIED, proved);
}

/* ---- frequencies and gains -------------------------------------------- */

void decide_frequencies(struct evidence *e)
{
    struct modes ten, twelve;
    bool proved = section_identity("eq40", "psi_ddot", "-3*Omega^2*psi - 2*Omega/L_ref*dL_dot") && gains_of_n() &&
                  section_identity("eq40", "dL_ddot", "-(C1 - 9*Omega^2)*dL - C2*dL_dot + 2*Omega*L_ref*psi_dot") &&
                  identity("n Omega", "n*Omega^2 - 9*Omega^2", "3*Omega^2 + (n - 12)*Omega^2");
    proved = modes_init(&ten, 10) && proved;
    proved = modes_init(&twelve, 12) && proved && closed_form_12(&twelve);
    evidence_add(e, "psi alone: 3 Omega^2, without a gain; dL alone: C1 - 9 Omega^2 = (n - 9) Omega^2; equal "
                    "at n = 12 and nowhere else. The coupled modes have other frequencies");
    proved = say(e, ": n = 10: ", ten.slow_frequency, 12) && proved;
    proved = say(e, " and ", ten.fast_frequency, 12) && proved;
    proved = say(e, ", n = 12: ", twelve.slow_frequency, 12) && proved;
    proved = say(e, " and ", twelve.fast_frequency, 12) && proved;
    evidence_add(e, " Omega, the latter (sqrt(5 + 2 sqrt 7) -+ 1)/2, Omega apart");
    modes_clear(&ten);
    modes_clear(&twelve);
    evidence_decide(e, HOLDS, CERTIFIED, proved);
}

void decide_critical(struct evidence *e)
{
    bool proved = gains_of_n() &&
                  section_identity("eq19", "dL_ddot", "-C2*dL_dot - (C1 - 9*Omega^2)*dL + 2*Omega*L_ref*psi_dot") &&
                  identity("l u Omega", "l^2 + 2*u*Omega*l + (9 + u^2)*Omega^2 - 9*Omega^2", "(l + u*Omega)^2");
    evidence_add(e, "with (43), (44) and no psi_dot, lambda^2 + C2 lambda + C1 - 9 Omega^2 = (lambda + Omega "
                    "sqrt(n - 9))^2: a double real root for every n > 9. The coupled equations have no real "
                    "root at all: see complex-pairs");
    evidence_decide(e, HOLDS, EXACT, proved);
}

void decide_wiggle(struct evidence *e)
{
    struct modes m;
    bool proved = on_44() &&
                  identity("s u", "(s^2 + 3)*(s^2 + 2*u*s + u^2) + 4*s^2", "(s^2 + 3)*(s + u)^2 + (2*s)^2");
    proved = modes_init(&m, 10) && proved;
    evidence_add(e, "the coupling's term 4 Omega^2 lambda^2 is all that parts (41) from (lambda^2 + 3 "
                    "Omega^2)(lambda + Omega sqrt(n - 9))^2, where dL decays without oscillation; with it "
                    "every root is complex");
    proved = say(e, "; n = 10: -", m.slow, 12) && proved;
    proved = say(e, " +- ", m.slow_frequency, 12) && proved;
    proved = say(e, " i and -", m.fast, 12) && proved;
    proved = say(e, " +- ", m.fast_frequency, 12) && proved;
    evidence_add(e, " i, in Omega");
    modes_clear(&m);
    evidence_decide(e, HOLDS, CERTIFIED, proved);
}

void decide_simulation_gains(struct evidence *e)
{
    bool proved = section_identity("eq42", "margin1", "C1 - 9*Omega^2");
    fmpq *gain = _fmpq_vec_init(2);
    for (slong Omega = 1; Omega <= 3; Omega++) { /* of degree 2 in Omega */
        const slong inputs[2] = {Omega, 10};
        proved = proved && section_at("eq43", inputs, gain) && section_at("eq44", inputs, gain + 1) &&
                 fmpq_cmp_si(gain, 10 * Omega * Omega) == 0 && fmpq_cmp_si(gain + 1, 2 * Omega) == 0;
    }
    _fmpq_vec_clear(gain, 2);
    evidence_add(e, "(43), (44) with n = 10 give 10 Omega^2 and 2 Omega exactly; (42) is met, C1 - 9 Omega^2 = "
                    "Omega^2");
    evidence_decide(e, HOLDS, EXACT, proved);
}

/* In a mode Omega dL_dot/(L_ref psi) = -(s^2 + 3)/2 by (40b), of imaginary part -Re s Im s. */
void decide_phase(struct evidence *e)
{
    bool proved = section_identity("eq40", "Omega*dL_dot", "-L_ref/2*(psi_ddot + 3*Omega^2*psi)");
    static const char *const before[2] = {" dL_dot leads psi by ", " degrees in the slower mode, by "};
    struct modes m;
    arb_t angle, degree;
    acb_t ratio;
    arb_init(angle);
    arb_init(degree);
    acb_init(ratio);
    proved = modes_init(&m, 10) && proved;
    arb_const_pi(degree, CLAIM_BITS);
    arb_div_si(degree, degree, 180, CLAIM_BITS);
    evidence_add(e, "by (40b) dL_dot/(L_ref psi) = -(s^2 + 3) Omega/2 in a mode, and real, in phase or "
                    "opposite, only without damping: its imaginary part is -Re s Im s Omega; n = 10:");
    for (int k = 0; k < 2; k++) {
        acb_mul(ratio, m.roots + 3 - 2 * k, m.roots + 3 - 2 * k, CLAIM_BITS);
        acb_add_si(ratio, ratio, 3, CLAIM_BITS);
        acb_neg(ratio, ratio);
        acb_arg(angle, ratio, CLAIM_BITS);
        proved = !arb_contains_zero(acb_imagref(ratio)) && proved;
        proved = say_ratio(e, before[k], angle, degree, 7) && proved;
    }
    evidence_add(e, " in the faster");
    modes_clear(&m);
    arb_clear(angle);
    arb_clear(degree);
    acb_clear(ratio);
    evidence_decide(e, HOLDS, CERTIFIED, proved);
}

void decide_step(struct evidence *e)
{
    struct modes m;
    arb_t period, x;
    arb_init(period);
    arb_init(x);
    bool proved = modes_init(&m, 10);
    arb_sub_si(x, m.fast_frequency, 2, CLAIM_BITS); /* pitch has 2 Omega */
    proved = proved && arb_is_positive(x) && arb_gt(m.fast_frequency, m.slow_frequency);
    table_rate(x);
    arb_mul(x, x, m.fast_frequency, CLAIM_BITS);
    arb_const_pi(period, CLAIM_BITS);
    arb_mul_2exp_si(period, period, 1);
    arb_div(period, period, x, CLAIM_BITS);
    evidence_add(e, "the shortest period of the linear model at n = 10 is the faster mode's");
    proved = say(e, ", ", period, 12) && proved;
    arb_div_si(period, period, 100, CLAIM_BITS);
    proved = say(e, " s, ", period, 8) && proved;
    evidence_add(e, " steps of 100 s; what error these leave is decided with the motion");
    arb_sub_si(x, period, 100, CLAIM_BITS);
    proved = proved && arb_is_positive(x);
    modes_clear(&m);
    arb_clear(period);
    arb_clear(x);
    evidence_decide(e, HOLDS, CERTIFIED, proved);
}
