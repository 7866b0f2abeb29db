/*
 * Claims about the charges that carry the law (18) out, and about errors of their product. Units: see well.h.
 */
#include "claims_statics.h"

#include <stdio.h>

#include "algebra.h"
#include "enclosure.h"
#include "exact.h"
#include "sheet.h"
#include "well.h"

/* ---- pull and push ---- */

/* The product of the charges printed in (21), (22) for Q_ref = -1 and dQ = 5, which command 4. */
static bool printed_product(fmpq_t product)
{
    const struct formulas *f = &section_find(sheet(), "eq21")->printed;
    struct machine m;
    fmpq_t q;
    fmpq_init(q);
    machine_init(&m, &f->program, &arithmetic_exact, 0);
    for (int i = 0; i < 2; i++) {
        fmpq_set_si(q, i == 0 ? -1 : 5, 1);
        m.arithmetic->set_rational(machine_value(&m, i), q, 0);
    }
    machine_run(&m);
    bool rational = exact_is_rational(product, machine_value(&m, f->outputs[0])) &&
                    exact_is_rational(q, machine_value(&m, f->outputs[1]));
    fmpq_mul(product, product, q);
    machine_clear(&m);
    fmpq_clear(q);
    return rational;
}

void decide_tension(struct evidence *e)
{
    fmpq_t product;
    fmpq_init(product);
    bool proved = section_find(sheet(), "eq21")->differs && printed_product(product) && fmpq_sgn(product) < 0;
    char *said = fmpq_get_str(NULL, 10, product);
    evidence_add(e,
                 "Coulomb's force does both, and (20) with a signed product. (21) and (22) make q1 q2 = "
                 "-|Q_ref + dQ| <= 0: with them the tether only pulls, and also where (18) commands a push; "
                 "Q_ref = -1, dQ = 5 give q1 q2 = %s",
                 said);
    flint_free(said);
    fmpq_clear(product);
    e->why = "Only with a product of either sign: (21) and (22) can but pull.";
    evidence_decide(e, QUALIFIED, EXACT, proved);
}

/*
 * Charges as printed where a push is commanded: P = N/r^3 with N = 3 + n (r - 1) + c2 r' < 0. With b = -r r' and
 * h = r^2 (phi' + 1), phi the angle from the radius,
 *
 *     r^2 b' = b (c2 - b) + r (n - 3 - n r) - h^2 + r^4 (1 - 3 cos^2 phi),   |h'| <= 3/2 r^2.
 *
 * From rest at r0, while |h| <= H: b db >= -(n - 3 - n r - H^2/r - 2 r^3) dr >= -mu dr down to r1, so that
 * b >= 1 there or before, and stays so: at b = 1 and r <= r1 still b' > 0. Then r r' <= -1: they meet. Up
 * to there dt = r dr/b, and 1/b <= 1/c2 + 1/sqrt(2 mu (r0 - r)), which bounds the time T, and h by it.
 */
static bool collides(arb_t T, const arb_t n)
{
    arb_t H, mu, c2;
    arb_init(H);
    arb_init(mu);
    arb_init(c2);
    enclose(H, "0.44", NOTHING);
    enclose(mu, "1.3", NOTHING);
    enclose(c2, "2*sqrt(n - 9)", KNOWN({"n", n}));
    const struct known *known = KNOWN({"n", n}, {"H", H}, {"mu", mu}, {"c2", c2}); /* r0 = 1/2, r1 = 1/10 */
    enclose(T, "1/2*(sqrt(2*(1/2 - 1/10)/mu) + (1/2 - 1/10)/c2) + (1/10)^2/2", known);
    bool proved = positive_on("n - 3 - n*x - H^2/x - 2*x^3 - mu", "1/10", "1/2", known) &&
                  positive_at("2*mu*(1/2 - 1/10) - 1", known) &&
                  positive_at("c2 - 1 - H^2 - 2*(1/10)^4", known) &&
                  positive_at("H - (1/2)^2*(1 + 3/2*T)", KNOWN({"H", H}, {"T", T})) &&
                  identity("r b d h n k a", /* a = 3 cos^2 phi, d = c2; r^2 b' = -(r r')^2 - r^3 r'' */
                           "-b^2 - r^3*(h^2/r^3 - r + r*a + (3 + n*(r - 1) - d*b/r)/r^2)",
                           "b*(d - b) + r*(n - 3 - n*r) - h^2 + r^4*(1 - a)");
    arb_clear(H);
    arb_clear(mu);
    arb_clear(c2);
    return proved;
}

void decide_printed_charges(struct evidence *e)
{
    struct numbers n = {.proved = true};
    const char *turned[GAINS], *mirrored[GAINS];
    bool proved = static_polynomial(RADIUS, RADIAL);
    arb_t T, r, most;
    arb_init(T);
    arb_init(r);
    arb_init(most);
    for (int i = 0; i < GAINS; i++) {
        struct well w;
        char cubic[64];
        well_init(&w, well_gains[i]);
        const struct known *known =
            KNOWN({"n", w.n}, {"rim", w.rim}, {"inner", w.inner}, {"outer", w.outer});
        snprintf(cubic, sizeof cubic, "3*x^3 + %lu*x - %lu", w.gain, w.gain - 3);
        /* within the well no push is ever commanded: c2 |r'| < 3 + n (r - 1) */
        proved = positive_on("3 + n*(x - 1)", "inner", "outer", known) &&
                 positive_on("(3 + n*(x - 1))^2 - 8*(n - 9)*(rim - " WELL ")", "inner", "outer", known) &&
                 proved;
        proved = collides(T, w.n) && positive_roots(cubic) == 1 &&
                 change_of_sign(r, "3*x^3 + n*x - (n - 3)", "1/10", "1 - 3/n", KNOWN({"n", w.n})) && proved;
        arb_max(most, most, T, ENCLOSURE_BITS);
        turned[i] = number_of(&n, 2, "L_ref*3/n", KNOWN({"n", w.n}));
        mirrored[i] = number_of(&n, 6, "L_ref*x", KNOWN({"x", r}));
        /* signed: n = 12 brings the same pair back, n = 10 does not */
        proved = well_fate(&w, -50) == (w.gain == 12 ? FATE_RETURNS : FATE_ESCAPES) && proved;
        well_clear(&w);
    }
    proved = proved && positive_at("1/2 - T", KNOWN({"T", most}));
    evidence_add(e,
                 "so long as Q_ref + dQ < 0; at rest down to dL = -%s m (n = 10), -%s m (n = 12), and for ever "
                 "from rest at the dL whose return basin-at-rest proves without flows. Below, (18) commands a "
                 "push and the |.| of (21) makes a pull of it, with gains turned round: places of rest at L = "
                 "%s m, %s m appear, unstable. From rest at L = 5 m the craft meet within 0.5/Omega = %s h, n "
                 "= 10 and 12 (r r' <= -1 once r <= 0.1); with the signed product the same start returns to "
                 "L_ref at n = 12, and escapes outwards at n = 10",
                 turned[0], turned[1], mirrored[0], mirrored[1], number_of(&n, 3, "0.5/Omega/3600", NOTHING));
    arb_clear(T);
    arb_clear(r);
    arb_clear(most);
    e->why = "While the law commands a pull; the printed absolute value makes a pull of a push too.";
    evidence_decide(e, QUALIFIED, CERTIFIED, proved && n.proved);
}

/*
 * The least hundredth that |dQ/Q_ref| = |n (r - 1) + c2 r'|/3 stays below for ever, once E = energy within
 * the well, for all attitudes: WELL <= E there, and r'^2/2 <= E - WELL. -1 if there is none.
 */
static int variation_bound(const struct well *w, const arb_t energy)
{
    static const char *const sides[] = {"eta - n*(x - 1)", "eta + n*(x - 1)"};
    char fast[160];
    arb_t eta, inner, outer;
    int bound = -1;
    arb_init(eta);
    arb_init(inner);
    arb_init(outer);
    const struct known *known =
        KNOWN({"n", w->n}, {"energy", energy}, {"outer", w->outer}, {"inner", w->inner});
    bool trapped = w->proved && arb_lt(energy, w->rim) &&
                   change_of_sign(inner, WELL " - energy", "inner", "1", known) &&
                   change_of_sign(outer, WELL " - energy", "1", "outer", known);
    for (int hundredth = 1; trapped && hundredth < 100 && bound < 0; hundredth++) {
        bool within = true;
        arb_set_si(eta, 3 * hundredth);
        arb_div_si(eta, eta, 100, ENCLOSURE_BITS);
        const struct known *trial =
            KNOWN({"n", w->n}, {"energy", energy}, {"outer", outer}, {"inner", inner}, {"eta", eta});
        for (int i = 0; i < 2; i++) {
            snprintf(fast, sizeof fast, "(%s)^2 - 8*(n - 9)*(energy - %s)", sides[i], WELL);
            within = within && positive_on(sides[i], "inner", "outer", trial) &&
                     positive_on(fast, "inner", "outer", trial);
        }
        if (within)
            bound = hundredth;
    }
    arb_clear(eta);
    arb_clear(inner);
    arb_clear(outer);
    return bound;
}

/* E of the simulation's start, at rest at the sheet's psi, theta and dL */
static void initial_energy(arb_t energy, const struct well *w)
{
    arb_t r;
    arb_init(r);
    enclose(r, "1 + dL/L_ref", NOTHING);
    enclose(energy, SIDE " - x^2*(3*(cos(theta)*cos(psi))^2 - sin(theta)^2)/2", KNOWN({"x", r}, {"n", w->n}));
    arb_clear(r);
}

void decide_negative_product(struct evidence *e)
{
    struct numbers n = {.proved = true};
    struct well w;
    arb_t energy;
    arb_init(energy);
    well_init(&w, well_gains[0]);
    initial_energy(energy, &w);
    int bound = variation_bound(&w, energy);
    bool proved = section_identity("eq18", "k_c*(m1 + m2)/(m1*m2)*dQ", "-L_ref^2*(C1*dL + C2*dL_dot)") &&
                  section_identity("eq07", "k_c*(m1 + m2)/(m1*m2)*Q_ref", "-3*Omega^2*L^3") && bound > 0 &&
                  bound < 100;
    evidence_add(e,
                 "Q_ref + dQ < 0 exactly where C1 dL + C2 dL_dot > -3 Omega^2 L_ref; at rest dL > -(3/n) "
                 "L_ref: -%s m (n = 10), -%s m (n = 12). In the paper's simulation it is so for ever, in the "
                 "nonlinear model and with pitch: E starts at %s, below the rim %s of the well, and never "
                 "grows, hence |dQ| < 0.%02d |Q_ref|",
                 number_of(&n, 2, "3/10*L_ref", NOTHING), number_of(&n, 2, "3/12*L_ref", NOTHING),
                 number(&n, energy, 7), number(&n, w.rim, 7), bound);
    well_clear(&w);
    arb_clear(energy);
    e->why = "While C1 dL + C2 dL_dot > -3 Omega^2 L_ref; in the paper's simulation it does.";
    evidence_decide(e, QUALIFIED, CERTIFIED, proved && n.proved);
}

void decide_small_variation(struct evidence *e)
{
    struct numbers n = {.proved = true};
    struct well w;
    arb_t ratio, energy;
    arb_init(ratio);
    arb_init(energy);
    well_init(&w, well_gains[0]);
    initial_energy(energy, &w);
    int bound = variation_bound(&w, energy);
    enclose(ratio, "n*dL/(3*L_ref)", NOTHING);
    bool proved = section_identity("eq18", "dQ", "-m1*m2*L_ref^2/((m1 + m2)*k_c)*(C1*dL + C2*dL_dot)") &&
                  identity("n d L O", "(-L^2*(n*O^2*d))/(-3*O^2*L^3)", "n*d/(3*L)") && bound > 0;
    bool false_as_printed = arb_is_positive(ratio) && positive_at("1 - ratio", KNOWN({"ratio", ratio}));
    evidence_add(e,
                 "for the magnitudes: at the start |dQ/Q_ref| = n dL/(3 L_ref) = 1/%s, n = 10, dL = 0.1 m, and "
                 "in the nonlinear motion it never reaches 0.%02d. As printed it would say that dQ lies far "
                 "below the negative Q_ref; but dQ = Q_ref/%s > Q_ref",
                 number_of(&n, 2, "1/ratio", KNOWN({"ratio", ratio})), bound,
                 number_of(&n, 2, "1/ratio", KNOWN({"ratio", ratio})));
    well_clear(&w);
    arb_clear(ratio);
    arb_clear(energy);
    e->why = "Q_ref is negative; what is meant is |dQ| << |Q_ref|.";
    evidence_decide(e, HOLDS_AS_CORRECTED, CERTIFIED, proved && false_as_printed && n.proved);
}

/* ---- an error of the charge product ---- */

/* dL in metres at which the pair rests when the charge product is 1 + d of what is commanded; false if nowhere. */
static bool shifted(struct numbers *n, const char **said, slong digits, const arb_t gain, const char *d)
{
    arb_t error, r;
    arb_init(error);
    arb_init(r);
    enclose(error, d, NOTHING);
    *said = "none";
    bool rests = change_of_sign(r, "3*x^3 - (1 + d)*(3 + n*(x - 1))", "1 - 3/n", "3*(n - 3)/(2*n)",
                                KNOWN({"n", gain}, {"d", error}));
    if (rests)
        *said = number_of(n, digits, "L_ref*(x - 1)", KNOWN({"x", r}));
    arb_clear(error);
    arb_clear(r);
    return rests;
}

/*
 * 3 r^3 = (1 + d)(3 + n (r - 1)) has two roots while d is above that of the fold, r = 3 (n - 3)/(2 n), and none
 * below: the tide then wins at every length. E, with the charges' part times 1 + d, still never grows; from rest
 * at L_ref it starts below its least value on the plane across (SIDE), so that the pair cannot turn over, and no
 * place of rest is in reach: no motion from there is bounded.
 */
void decide_charge_error(struct evidence *e)
{
    static const char *const k_c_error =
        "1/(4*pi*8.8541878188e-12)/k_c - 1"; /* CODATA 2022: vacuum electric permittivity */
    struct numbers n = {.proved = true};
    const char *more[GAINS], *less[GAINS], *rounded[GAINS], *fold[GAINS];
    bool proved = identity("m", "3*(3*m/(2*(m + 3)))^3/(3 + (m + 3)*(3*m/(2*(m + 3)) - 1))",
                           "81*m^2/(4*(m + 3)^3)") && /* m = n - 3 */
                  identity("r n", "9*r^2*(3 + n*(r - 1)) - 3*r^3*n", "3*r^2*(2*n*r - 3*(n - 3))");
    bool lost = false;
    for (int i = 0; i < GAINS; i++) {
        struct well w;
        well_init(&w, well_gains[i]);
        proved = w.proved && proved;
        fold[i] = number_of(&n, 4, "100*(1 - 81*(n - 3)^2/(4*n^3))", KNOWN({"n", w.n}));
        proved = shifted(&n, &more[i], 4, w.n, "0.01") && proved;
        proved = shifted(&n, &rounded[i], 3, w.n, k_c_error) && proved;
        const bool rests = shifted(&n, &less[i], 4, w.n, "-0.01");
        if (i == 0) /* the well is gone, and the plane across is higher than the start */
            lost = !rests && positive_at("81*(n - 3)^2/(4*n^3) - (1 - 0.01)", KNOWN({"n", w.n})) &&
                   positive_on("0.99*" SIDE " - (0.99*(n - 3) - 3/2)", "1 - 3/n", "1 - 3/n", KNOWN({"n", w.n}));
        else
            proved = proved && rests;
        well_clear(&w);
    }
    evidence_add(e,
                 "if the charges are right. A product 1 + d times the commanded one rests where 3 r^3 = (1 + "
                 "d)(3 + n (r - 1)), to first order dL = -3 d L_ref/(n - 9). k_c = 8.99e9 for CODATA's: dL = "
                 "+%s m (n = 10), +%s m (n = 12). 1 %% too much: %s m, %s m; 1 %% too little: no rest at all "
                 "at n = 10, from rest at L_ref the pair parts without bound; +%s m at n = 12. The balance "
                 "folds at 1 + d = 81 (n - 3)^2/(4 n^3): %s %% too little (n = 10), %s %% (n = 12)",
                 rounded[0], rounded[1], more[0], more[1], less[1], fold[0], fold[1]);
    e->why = "If the charges are right: with a product 1 % too weak the pair is lost at n = 10.";
    evidence_decide(e, QUALIFIED, CERTIFIED, proved && lost && n.proved);
}
