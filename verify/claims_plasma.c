/*
 * Claims about the plasma, and about the numbers that nature sets: k_c, the Earth's rotation, gravity, charges.
 *
 * A screened potential k_c q e^(-r/lambda_d)/r has the force k_c q q' (1 + u) e^(-u)/r^2, u = r/lambda_d; the paper
 * prints k_c q q' e^(-u)/r^2.
 */
#include "claims_statics.h"

#include "algebra.h"
#include "enclosure.h"
#include "well.h"

#define PRINTED(u) "exp(-(" u "))"
#define SCREENED(u) "((1 + " u ")*exp(-(" u ")))"

/* ---- the shielded force ---- */

/* Differentiates E/r, E standing for e^(-r/d), of which all that counts is E' = -E/d. */
static bool gradient_proved(void)
{
    struct program p;
    program_init(&p);
    int rate[3] = {0};
    const int r = program_input(&p, "r"), d = program_input(&p, "d"), E = program_input(&p, "E");
    rate[r] = formula(&p, "1");
    rate[d] = -1;
    rate[E] = formula(&p, "-E/d");
    int slope = program_derivative(&p, formula(&p, "E/r"), rate, 3), force = formula(&p, "(1 + r/d)*E/r^2");
    program_name(&p, slope, "slope");
    bool proved = force >= 0 && vanishes(&p, program_difference(&p, formula(&p, "-slope"), force));
    program_clear(&p);
    return proved;
}

void decide_shielding(struct evidence *e)
{
    struct numbers n = {.proved = true};
    bool proved = gradient_proved();
    evidence_add(e,
                 "the force that comes of the screened potential e^(-r/lambda_d)/r is (1 + r/lambda_d) "
                 "e^(-r/lambda_d)/r^2: (2) leaves out the factor 1 + r/lambda_d, and with it makes the force "
                 "too weak. The factor at r = 10 m is %s to %s (lambda_d = 1400 to 100 m), at 100 m %s to %s. "
                 "The decay is exponential either way",
                 number_of(&n, 5, "1 + 10/1400", NOTHING), number_of(&n, 2, "1 + 10/100", NOTHING),
                 number_of(&n, 5, "1 + 100/1400", NOTHING), number_of(&n, 1, "1 + 100/100", NOTHING));
    e->why = "The force of a screened potential has a factor 1 + r/lambda_d more.";
    evidence_decide(e, QUALIFIED, EXACT, proved && n.proved);
}

/* 1 - e^(-u) = u - ..., 1 - (1 + u) e^(-u) = u^2/2 - ... */
void decide_shielding_order(struct evidence *e)
{
    struct numbers n = {.proved = true};
    fmpq_poly_t u, decay, screened;
    fmpq_poly_init(u);
    fmpq_poly_init(decay);
    fmpq_poly_init(screened);
    fmpq_poly_set_coeff_si(u, 1, -1);
    fmpq_poly_exp_series(decay, u, 3);
    polynomial(u, "1 + x");
    fmpq_poly_mullow(screened, decay, u, 3);
    polynomial(u, "1 - x + x^2/2");
    bool first = fmpq_poly_equal(decay, u) != 0;
    polynomial(u, "1 - x^2/2");
    bool second = fmpq_poly_equal(screened, u) != 0;
    fmpq_poly_clear(u);
    fmpq_poly_clear(decay);
    fmpq_poly_clear(screened);
    evidence_add(e,
                 "with u = L/lambda_d the shielding printed in (2) takes u - u^2/2 + ... of the force away, a "
                 "term of first order: %s of the force at u = 0.1. It is of second order, u^2/2 - ..., with "
                 "the force of a screened potential: %s",
                 number_of(&n, 4, "1 - " PRINTED("1/10"), NOTHING),
                 number_of(&n, 4, "1 - " SCREENED("1/10"), NOTHING));
    e->why = "It is in the force of a screened potential; in (2) as printed the term is of first order.";
    evidence_decide(e, QUALIFIED, EXACT, first && second && n.proved);
}

/* Both losses rise with u: derivatives e^(-u) and u e^(-u). */
void decide_debye_neglect(struct evidence *e)
{
    static const char *const loss[2][4] = {{"1 - " PRINTED("10/1400"), "1 - " PRINTED("10/100"),
                                            "1 - " PRINTED("100/1400"), "1 - " PRINTED("100/100")},
                                           {"1 - " SCREENED("10/1400"), "1 - " SCREENED("10/100"),
                                            "1 - " SCREENED("100/1400"), "1 - " SCREENED("100/100")}};
    struct numbers n = {.proved = true};
    const char *said[2][4];
    for (int i = 0; i < 2; i++)
        for (int k = 0; k < 4; k++)
            said[i][k] = number_of(&n, 4, loss[i][k], NOTHING);
    bool monotone = identity("u E", "-(-E)", "E") && identity("u E", "-(E + (1 + u)*(-E))", "u*E");
    evidence_add(e,
                 "part of the force that leaving it out adds, lambda_d = 1400 ... 100 m: for L = 10 m %s ... "
                 "%s as printed, %s ... %s for a screened potential; for L = 100 m, the other end of the range "
                 "that the paper gives, %s ... %s and %s ... %s. What it does to the pair: see debye-escape",
                 said[0][0], said[0][1], said[1][0], said[1][1], said[0][2], said[0][3], said[1][2],
                 said[1][3]);
    e->why = "To a tenth of the force for craft 10 m apart, not for the 100 m that are allowed for.";
    evidence_decide(e, QUALIFIED, CERTIFIED, monotone && n.proved);
}

/* ---- where shielding leaves no balance ---- */

/*
 * With the force times s(r/lambda_d) the pair rests on the radius where 3 r^3 = s N, N = 3 + n (r - 1): at two
 * lengths for long Debye lengths, at none for short ones. Then L grows without bound, by the argument in well.h:
 * s <= 1 opens no way over the plane across. The two meet where the ratio s N/(3 r^3) has its maximum 1. Its
 * logarithmic derivative vanishes where, with u = r L_ref/lambda_d and w = (3 n - 9 - 2 n r)/N, u = w as printed,
 * and u^2/(1 + u) = w for a screened potential. w falls as r grows, w' = -n (n - 3)/N^2; so does u, and
 * s N/(3 r^3) on that curve rises: there is one such r.
 */
#define W "((3*n - 9 - 2*n*x)/(3 + n*(x - 1)))"
#define U "((" W " + sqrt(" W "^2 + 4*" W "))/2)"

/* The force against the tide on the radius; s is the shielding. */
#define BALANCE(s) s "*(3 + n*(x - 1)) - 3*x^3"

/* The Debye length in metres at which the two lengths of rest meet; the balance is that on the curve above. */
static bool critical(struct numbers *n, const char **said, const struct known *gain,
                     const char *balance, const char *length)
{
    arb_t r;
    arb_init(r);
    bool found = change_of_sign(r, balance, "1 - 3/n + 1/100", "3*(n - 3)/(2*n) - 1/1000", gain);
    *said = number_of(n, 5, length, KNOWN({"n", gain[0].value}, {"x", r}));
    arb_clear(r);
    return found;
}

/* The shorter of the two: dL in metres. */
static bool rest_at(struct numbers *n, const char **said, const struct known *gain,
                    const char *balance)
{
    arb_t r;
    arb_init(r);
    bool found = change_of_sign(r, balance, "1", "3*(n - 3)/(2*n)", gain);
    *said = number_of(n, 3, "L_ref*(x - 1)", KNOWN({"x", r}));
    arb_clear(r);
    return found;
}

void decide_debye_escape(struct evidence *e)
{
    struct numbers n = {.proved = true};
    const char *printed[2], *screened[2], *printed_far[2], *screened_near[2];
    bool proved =
        gradient_proved() && identity("n r", "-2*n*(3 + n*(r - 1)) - n*(3*n - 9 - 2*n*r)", "-n*(n - 3)");
    arb_t gain;
    arb_init(gain);
    for (int i = 0; i < 2; i++) {
        arb_set_ui(gain, well_gains[i]);
        const struct known *known = KNOWN({"n", gain});
        proved = positive_on("3/2 - (n - 3) + " SIDE, "1 - 3/n", "1 - 3/n", known) && proved;
        proved = critical(&n, &printed[i], known, BALANCE(PRINTED(W)), "L_ref*x/" W) && proved;
        proved = critical(&n, &screened[i], known, BALANCE(SCREENED(U)), "L_ref*x/" U) && proved;
        proved = rest_at(&n, &printed_far[i], known, BALANCE(PRINTED("x*L_ref/1400"))) && proved;
        proved = rest_at(&n, &screened_near[i], known, BALANCE(SCREENED("x*L_ref/100"))) && proved;
    }
    arb_clear(gain);
    evidence_add(e,
                 "L_ref = 10 m, charges by (7) and (18), which know nothing of lambda_d. With the shielding "
                 "printed in (2) no length is at rest, and from L_ref the pair parts without bound, for "
                 "lambda_d < %s m (n = 10), %s m (n = 12); at 1400 m it rests longer by %s m, %s m. With the "
                 "force of a screened potential the limits are %s m, %s m, and at 100 m it rests longer by %s "
                 "m, %s m",
                 printed[0], printed[1], printed_far[0], printed_far[1], screened[0], screened[1],
                 screened_near[0], screened_near[1]);
    e->why = "Not at n = 10 with the shielding of (2): in almost all of that range the pair is lost.";
    evidence_decide(e, QUALIFIED, CERTIFIED, proved && n.proved);
}

/* lambda_d <= 10 cm, L = 10 m: u >= 100, and both factors fall with u */
void decide_low_orbit(struct evidence *e)
{
    struct numbers n = {.proved = true};
    bool proved = positive_at("1e-40 - " SCREENED("10/(1/10)"), NOTHING);
    evidence_add(e,
                 "at L = 10 m and lambda_d = 10 cm or less the force is at most %s of Coulomb's as printed, %s "
                 "for a screened potential, and the charge product would have to make up for it",
                 number_of(&n, 3, PRINTED("10/(1/10)"), NOTHING),
                 number_of(&n, 3, SCREENED("10/(1/10)"), NOTHING));
    evidence_decide(e, HOLDS, CERTIFIED, proved && n.proved);
}

/* lambda_d^2 = eps0 T/(e n_e); eps0: CODATA 2022, e: exact in the SI since 2019 */
void decide_debye_lengths(struct evidence *e)
{
    struct numbers n = {.proved = true};
    evidence_add(e,
                 "lambda_d^2 = eps0 T/(e n_e) takes a density n_e and a temperature T (in eV), and the paper "
                 "gives neither. Needed for 1 cm: n_e/T = %s per m^3 and eV; for 100 m %s, for 1400 m %s",
                 number_of(&n, 4, "8.8541878188e-12/1.602176634e-19/(1/100)^2", NOTHING),
                 number_of(&n, 4, "8.8541878188e-12/1.602176634e-19/100^2", NOTHING),
                 number_of(&n, 4, "8.8541878188e-12/1.602176634e-19/1400^2", NOTHING));
    e->why = "Neither density nor temperature of the plasma is given.";
    evidence_decide(e, NOT_DECIDABLE, CERTIFIED, n.proved);
}

/* ---- reference values ---- */

/* 1/(4 pi eps0); eps0 = 8.8541878188(14)e-12 F/m, CODATA 2022, and three times its uncertainty */
void decide_coulomb_constant(struct evidence *e)
{
    struct numbers n = {.proved = true};
    arb_t k, eps0;
    arb_init(k);
    arb_init(eps0);
    enclose(eps0, "3*0.0000000014e-12", NOTHING);
    arb_add_error(k, eps0);
    enclose(eps0, "8.8541878188e-12", NOTHING);
    arb_add(eps0, eps0, k, ENCLOSURE_BITS);
    enclose(k, "1/(4*pi*eps0)", KNOWN({"eps0", eps0}));
    const struct known *known = KNOWN({"k", k});
    bool rounds = positive_at("(0.005e9)^2 - (k - k_c)^2", known);
    evidence_add(e,
                 "1/(4 pi eps0) is %s N m^2/C^2 (CODATA 2022) and rounds to it in three digits; the paper's is "
                 "too large by %s of itself. What that does to the length: see charge-error",
                 number(&n, k, 8), number_of(&n, 4, "k_c/k - 1", known));
    arb_clear(k);
    arb_clear(eps0);
    evidence_decide(e, HOLDS, CERTIFIED, rounds && n.proved);
}

/* IERS Conventions (2010), table 1.1: nominal mean angular velocity of the Earth, and its GM (TCG) */
void decide_orbit_rate(struct evidence *e)
{
    struct numbers n = {.proved = true};
    arb_t rate, R, R_earth;
    arb_init(rate);
    arb_init(R);
    arb_init(R_earth);
    enclose(rate, "7.292115e-5", NOTHING);
    enclose(R, "3.986004418e14/Omega^2", NOTHING);
    enclose(R_earth, "3.986004418e14/rate^2", KNOWN({"rate", rate}));
    arb_root_ui(R, R, 3, ENCLOSURE_BITS);
    arb_root_ui(R_earth, R_earth, 3, ENCLOSURE_BITS);
    const struct known *known = KNOWN({"rate", rate}, {"R", R}, {"R_earth", R_earth});
    bool differs =
        positive_at("rate - Omega - 0.0005e-5", known); /* more than half a unit of the last digit printed */
    evidence_add(e,
                 "the Earth turns at %s rad/s, in five digits %s: the printed value is too small by %s of it, "
                 "its last two digits are not those. By Kepler's law it belongs to R_c = %s km, the Earth's "
                 "rate to %s km; a craft there would drift west by %s degrees a day",
                 number(&n, rate, 7), number(&n, rate, 5), number_of(&n, 3, "1 - Omega/rate", known),
                 number_of(&n, 8, "R/1000", known), number_of(&n, 8, "R_earth/1000", known),
                 number_of(&n, 3, "(rate - Omega)*86400*180/pi", known));
    arb_clear(rate);
    arb_clear(R);
    arb_clear(R_earth);
    e->why = "To three digits; the last two that are printed are not the Earth's.";
    evidence_decide(e, QUALIFIED, CERTIFIED, differs && n.proved);
}

/* ---- charges, and what else pulls ---- */

#define CHARGE "sqrt(3*Omega^2*L_ref^3/k_c*(m1*m2/(m1 + m2)))" /* at rest, (7) and (21) */

void decide_microcoulomb(struct evidence *e)
{
    struct numbers n = {.proved = true};
    bool proved = section_identity("eq07", "Q_ref", "-3*Omega^2*L^3/k_c*(m1*m2/(m1 + m2))") &&
                  positive_at(CHARGE "^2 - 1e-13", NOTHING) && positive_at("1e-11 - " CHARGE "^2", NOTHING);
    evidence_add(e,
                 "at rest |q1| = |q2| = sqrt(|Q_ref|) = %s uC with Table 1: the nearest power of ten is 1 uC, "
                 "as it lies between 1/sqrt(10) and sqrt(10)",
                 number_of(&n, 10, "1000000*" CHARGE, NOTHING));
    evidence_decide(e, HOLDS, CERTIFIED, proved && n.proved);
}

void decide_reach(struct evidence *e)
{
    struct numbers n = {.proved = true};
    arb_t L;
    arb_init(L);
    enclose(L, "(1e-6/(" CHARGE "))^2", NOTHING);
    arb_root_ui(L, L, 3, ENCLOSURE_BITS);
    bool proved = section_identity("eq07", "Q_ref/L^3", "-3*Omega^2/k_c*(m1*m2/(m1 + m2))");
    evidence_add(e,
                 "no length is set by (7) alone: |Q_ref| grows as L^3, for the tide grows as L while the force "
                 "falls as 1/L^2, so q = q(L_ref) (L/L_ref)^(3/2). With Table 1 %s uC at 10 m, %s uC at 100 m; "
                 "1 uC a craft holds %s m. The range is that of the charge a craft can bear, which the paper "
                 "leaves open",
                 number_of(&n, 4, "1000000*" CHARGE, NOTHING),
                 number_of(&n, 4, "1000000*sqrt(1000)*" CHARGE, NOTHING),
                 number_of(&n, 4, "L_ref*L", KNOWN({"L", L})));
    arb_clear(L);
    e->why = "(7) sets no length; what does is the charge that a craft can bear, which is not given.";
    evidence_decide(e, QUALIFIED, CERTIFIED, proved && n.proved);
}

/* G: CODATA 2022, 6.67430(15)e-11; 2.3e-5 of it is uncertain, which four digits hide: three are printed */
void decide_own_gravity(struct evidence *e)
{
    struct numbers n = {.proved = true};
    const char *shift[2];
    arb_t G, gamma, gain, r;
    arb_init(G);
    arb_init(gamma);
    arb_init(gain);
    arb_init(r);
    enclose(gamma, "3*0.00015e-11", NOTHING);
    enclose(G, "6.67430e-11", NOTHING);
    arb_add_error(G, gamma);
    enclose(gamma, "G*(m1 + m2)/(3*Omega^2*L_ref^3)", KNOWN({"G", G}));
    bool proved = identity("G m M L O k", "G*m*M/(k*(3*O^2*L^3/k*(m*M/(m + M))))", "G*(m + M)/(3*O^2*L^3)");
    for (int i = 0; i < 2; i++) { /* 3 r^3 = 3 + n (r - 1) + 3 gamma */
        arb_set_ui(gain, well_gains[i]);
        const struct known *known = KNOWN({"n", gain}, {"gamma", gamma});
        proved = change_of_sign(r, "3*x^3 - 3 - n*(x - 1) - 3*gamma", "1 - 3/n", "1", known) && proved;
        shift[i] = number_of(&n, 3, "1000*L_ref*(1 - x)", KNOWN({"x", r}));
    }
    proved = proved && positive_at("gamma - (k_c*4*pi*8.8541878188e-12 - 1)", KNOWN({"gamma", gamma}));
    evidence_add(e,
                 "the craft attract each other too: G m1 m2/(k_c |Q_ref|) = G (m1 + m2)/(3 Omega^2 L^3) = %s "
                 "of the Coulomb force with Table 1, more than k_c's rounding. Under (18) it shortens the pair "
                 "by %s mm (n = 10), %s mm (n = 12)",
                 number(&n, gamma, 3), shift[0], shift[1]);
    arb_clear(G);
    arb_clear(gamma);
    arb_clear(gain);
    arb_clear(r);
    e->why = "The craft's own gravity is small, yet shortens the pair by some centimetres.";
    evidence_decide(e, QUALIFIED, CERTIFIED, proved && n.proved);
}
