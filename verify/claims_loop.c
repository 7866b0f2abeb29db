/*
 * Claims about a pair that is not at rest in its place: at constant charge, and under the law (18). Units: see well.h.
 */
#include "claims_statics.h"

#include <stdio.h>

#include "algebra.h"
#include "enclosure.h"
#include "well.h"

/* ---- constant charge ---- */

static int take_length(void *context, slong k, const fmpq_t t, arb_srcptr state)
{
    arb_ptr lengths = context;
    (void)t;
    enclose(lengths + k, "L_ref*sqrt(x^2 + y^2)", KNOWN({"x", state}, {"y", state + 1}));
    return 0;
}

void decide_separation(struct evidence *e)
{
    enum { TIMES = 2 };
    static const char *const starts[] = {"1 + dL/L_ref", "1 - dL/L_ref"};
    struct numbers n = {.proved = true};
    arb_ptr lengths = _arb_vec_init(2 * TIMES);
    fmpq *times = _fmpq_vec_init(TIMES); /* 12 h and 24 h, Omega = 7.2915e-5 rad/s */
    arb_t start;
    arb_init(start);
    /* E at rest on the radius, -3/2 r^2 - 3/r, is greatest at r = 1; and (18) with c1 = c2 = 0 conserves E */
    bool proved = energy_decays() && identity("r", "-9/2 + 3/2*r^2 + 3/r", "3/2*(r - 1)^2*(r + 2)/r") &&
                  static_polynomial(RADIUS, RADIAL) && positive_roots("x^2 - 2*x - 27") == 1 &&
                  positive_roots("x^2 + 2*x - 27") == 1; /* x = -+(1 +- sqrt 28) */
    fmpq_set_si(times, 3149928, 1000000);
    fmpq_set_si(times + 1, 6299856, 1000000);
    arb_set_fmpq(start, times + 1, ENCLOSURE_BITS);
    proved = proved && positive_at("1e-30 - (day - Omega*86400)^2", KNOWN({"day", start}));
    for (int i = 0; i < 2; i++) {
        enclose(start, starts[i], NOTHING);
        proved = proved && follow(0, start, times, TIMES, take_length, lengths + i * TIMES) == FLOW_DONE;
    }
    proved = proved && positive_at("a - 10*L_ref", KNOWN({"a", lengths + 1})) &&
             positive_at("L_ref - a", KNOWN({"a", lengths + 3}));
    evidence_add(e,
                 "constant charge is Hill's lunar problem with its libration points at L_ref; E = v^2/2 - 3/2 "
                 "x^2 + z^2/2 - 3/r is conserved and at r = 1 never below -9/2, at rest on the radius -9/2 - "
                 "(3/2)(r - 1)^2 (r + 2)/r. So a pair let go from rest at dL > 0 stays longer than L_ref for "
                 "ever, one at dL < 0 shorter: those fall together. From +%s m L = %s m after 12 h and %s m "
                 "after 24 h; from -%s m %s m and %s m, bound like a moon. Among disturbances are also some "
                 "that do neither: lambda^2 = (1 - sqrt 28) Omega^2 swings in the plane, -4 Omega^2 across it",
                 number_of(&n, 1, "dL", NOTHING), number(&n, lengths, 5), number(&n, lengths + 1, 5),
                 number_of(&n, 1, "dL", NOTHING), number(&n, lengths + 2, 5), number(&n, lengths + 3, 5));
    arb_clear(start);
    _fmpq_vec_clear(times, TIMES);
    _arb_vec_clear(lengths, 2 * TIMES);
    e->why = "One that starts too long does; one that starts too short falls together.";
    evidence_decide(e, QUALIFIED, CERTIFIED, proved && n.proved);
}

/* ---- the law: other places of rest, and what comes back ---- */

/* Counts those of one n, and says how long the pair is there: on the radius, along the velocity, on the normal. */
static bool rests(struct numbers *n, const char *said[3], const struct well *w)
{
    char cubic[64], normal[64];
    arb_t r;
    arb_init(r);
    snprintf(cubic, sizeof cubic, "3*x^3 - %lu*x + %lu", w->gain, w->gain - 3);
    snprintf(normal, sizeof normal, "x^3 + %lu*x - %lu", w->gain, w->gain - 3);
    bool proved = positive_roots(cubic) == 2 && positive_roots(normal) == 1 &&
                  positive_at("x - 1", KNOWN({"x", w->outer})) &&
                  positive_at("9 - n/x^2", KNOWN({"n", w->n}, {"x", w->outer})) &&
                  change_of_sign(r, "x^3 + n*x - (n - 3)", "1/10", "1", KNOWN({"n", w->n}));
    said[0] = number_of(n, 8, "L_ref*x", KNOWN({"x", w->outer}));
    said[1] = number_of(n, 2, "L_ref*(1 - 3/n)", KNOWN({"n", w->n}));
    said[2] = number_of(n, 6, "L_ref*x", KNOWN({"x", r}));
    arb_clear(r);
    return proved;
}

void decide_other_rests(struct evidence *e)
{
    struct numbers n = {.proved = true};
    const char *said[GAINS][3];
    /* P = -3 on the radius, 0 along the velocity, 1 on the orbit normal; for all n > 9 by n = 3 (r^2 + r + 1) */
    bool proved = identity("r n", "3*r^3 - 3 - n*(r - 1)", "(r - 1)*(3*r^2 + 3*r + 3 - n)") &&
                  identity("r", "9*r^2 - 3*(r^2 + r + 1)", "3*(r - 1)*(2*r + 1)") &&
                  static_polynomial(RADIUS, RADIAL) && static_polynomial(VELOCITY, ALONG) &&
                  static_polynomial(NORMAL, ACROSS);
    for (int i = 0; i < GAINS; i++) {
        struct well w;
        well_init(&w, well_gains[i]);
        proved = rests(&n, said[i], &w) && w.proved && proved;
        well_clear(&w);
    }
    evidence_add(e,
                 "all places of rest, signed Q, either craft first: on the radius 3 r^3 - n r + n - 3 = (r - "
                 "1)(3 r^2 + 3 r + 3 - n), L_ref and L = %s m (n = 10), %s m (n = 12); on the velocity axis, "
                 "uncharged, L = (1 - 3/n) L_ref = %s m, %s m; on the orbit normal, repelling, r^3 + n r = n - "
                 "3, L = %s m, %s m. About rest on the radius (41) holds with the gains times (L_ref/L)^2: "
                 "stable where n > 9 r^2, which for all n > 9 is so at L_ref and not at the other; along the "
                 "velocity a characteristic polynomial ends in -3 k1 < 0; on the normal s^4 - s^2 + 4 stays "
                 "whatever the gains. Off the axes nothing rests",
                 said[0][0], said[1][0], said[0][1], said[1][1], said[0][2], said[1][2]);
    e->why = "There is a second place of rest on the radius, and others off it; all are unstable.";
    evidence_decide(e, QUALIFIED, EXACT, proved && n.proved);
}

void decide_basin(struct evidence *e)
{
    static const slong back[GAINS] = {-24, -80}, lost[GAINS] = {-25, -85}; /* tenths of a metre */
    struct numbers n = {.proved = true};
    bool proved = true;
    evidence_add(e, "E = v^2/2 - (3 x^2 - z^2)/2 + (n - 3)/r + n ln r never grows, E' = -c2 r'^2/r^2. From "
                    "rest on the radius, signed Q:");
    for (int i = 0; i < GAINS; i++) {
        struct well w;
        well_init(&w, well_gains[i]);
        proved =
            well_fate(&w, back[i]) == FATE_RETURNS &&
                 well_fate(&w, lost[i]) == FATE_ESCAPES && proved;
        evidence_add(e,
                     "%s n = %lu: all dL between %s m and %s m (rounded) return, none beyond the latter ever comes below "
                     "it; from %.1f m the pair returns, from %.1f m it swings out and escapes",
                     i > 0 ? ";" : "", well_gains[i], number_of(&n, 6, "L_ref*(x - 1)", KNOWN({"x", w.inner})),
                     number_of(&n, 8, "L_ref*(x - 1)", KNOWN({"x", w.outer})), 0.1 * (double)back[i],
                     0.1 * (double)lost[i]);
        well_clear(&w);
    }
    evidence_add(e, " (certified flows until E is below the rim of the well, inside or outside it)");
    e->why = "Only from within a basin, which is narrow for n = 10; beyond its rim the pair is lost.";
    evidence_decide(e, QUALIFIED, CERTIFIED, proved && n.proved);
}
