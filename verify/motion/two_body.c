/*
 * A second table for taylor.h. Of each craft R = e_x/s + r, s the smallness: r_ddot = -R/|s R|^3 + (R - R_z) + twice Coriolis. With
 * F = 1/|s R|
 *
 *     x' = u   u' =  2v - M x - K           M = F^3 - 1,  K = M/s: as many bits are lost as s has zeros
 *     y' = v   v' = -2u - M y               F' = -F^3 E,  E = s (u + s (xu + yv + zw))
 *     z' = w   w' =     - M z - z
 *
 * Theorem (steps without a set). With series in balls, majorant_prove of taylor.h bounds what they leave out from every start in
 * the balls: after each step, from the balls as they then are, the motion of every start and parameter lies in
 *   (B1) the sum of the series at the ball h             (sum_terms)
 *   (B2) and the remainder, proved for all of |s| <= |h|  (two_body_move: with the upper bound of |h|, or nothing is said)
 *   (B3) F and q in balls of all that the craft's are      (inverse_length, expand_pair)
 * Each has a test of its name, in tests/motion/test_balls.c or tests/claims/test_convergence.c.
 *
 * And along the line d from craft 2 to craft 1 the pull P of taylor.h, of q = 1/|d|, in shares of the other's mass.
 */
#include "motion/two_body.h"

#include <math.h>

#include "motion/taylor.h"
#include "text/scope.h"

enum { NUMBERS = 3 + CRAFT + 2 * CRAFT * AXES }; /* of a pair, side by side */
enum { PAIR_ORDER = 40 }; /* of the Taylor steps: the last term falls to 1e-40, balls widen by 10^3 a radian */

static const double TWO_BODY_STEP = 0.2; /* radians */

enum { X, Y, Z, U, V, W, F, CRAFT_STATES }; /* of either craft, */
enum { Q = CRAFT * CRAFT_STATES, STATES };
enum { F2, F3, M, K, S, H, E, CRAFT_SERIES }; /* ... and its series */
enum {
    DX = STATES + CRAFT * CRAFT_SERIES, DY, DZ, DU, DV, DW, G, DS, A, D, R, PULL, PULL1, PULL2,
    ONE, TWO, THREE, C1, C2, LAMBDA, HOLD, SMALLNESS, INVERSE, MASS1, MASS2, ALL
};

_Static_assert((int)ALL <= (int)JET_MOST, "a jet has room");

#define AT(i, v) ((i) * CRAFT_STATES + (v))
#define OF(i, v) (STATES + (i) * CRAFT_SERIES + (v))
#define SERIES_OF(i) \
    {OF(i, F2), AT(i, F), AT(i, F), 1}, {OF(i, F3), AT(i, F), OF(i, F2), 1}, \
    {OF(i, M), ONE, OF(i, F3), 1}, {OF(i, M), ONE, ONE, -1}, {OF(i, K), INVERSE, OF(i, M), 1}, \
    {OF(i, S), AT(i, X), AT(i, U), 1}, {OF(i, S), AT(i, Y), AT(i, V), 1}, {OF(i, S), AT(i, Z), AT(i, W), 1}, \
    {OF(i, H), ONE, AT(i, U), 1}, {OF(i, H), SMALLNESS, OF(i, S), 1}, {OF(i, E), SMALLNESS, OF(i, H), 1}
#define RATES_OF(i, pull, sign) \
    {AT(i, X), ONE, AT(i, U), 1}, {AT(i, Y), ONE, AT(i, V), 1}, {AT(i, Z), ONE, AT(i, W), 1}, \
    {AT(i, U), TWO, AT(i, V), 1}, {AT(i, U), OF(i, M), AT(i, X), -1}, {AT(i, U), ONE, OF(i, K), -1}, {AT(i, U), pull, DX, sign}, \
    {AT(i, V), TWO, AT(i, U), -1}, {AT(i, V), OF(i, M), AT(i, Y), -1}, {AT(i, V), pull, DY, sign}, \
    {AT(i, W), ONE, AT(i, Z), -1}, {AT(i, W), OF(i, M), AT(i, Z), -1}, {AT(i, W), pull, DZ, sign}, \
    {AT(i, F), OF(i, F3), OF(i, E), -1}
#define LINE(to, v) {to, ONE, AT(0, v), 1}, {to, ONE, AT(1, v), -1}

static const struct term terms[] = {
    SERIES_OF(0), SERIES_OF(1),
    LINE(DX, X), LINE(DY, Y), LINE(DZ, Z), LINE(DU, U), LINE(DV, V), LINE(DW, W),
    {G, Q, Q, 1},
    {DS, DX, DU, 1},  {DS, DY, DV, 1},   {DS, DZ, DW, 1},
    {A, G, DS, 1},
    {D, LAMBDA, Q, 1}, {D, ONE, ONE, -1},
    {R, C1, D, 1},     {R, HOLD, Q, -1}, {R, C2, A, -1},
    {PULL, G, R, 1},  {PULL1, MASS2, PULL, 1}, {PULL2, MASS1, PULL, 1},
    RATES_OF(0, PULL1, 1), RATES_OF(1, PULL2, -1),
    {Q, Q, A, -1},
};

static const struct system two_craft = {STATES, ONE, ALL, sizeof terms / sizeof *terms, terms};

void two_body_init(struct two_body *b)
{
    arb_ptr all = _arb_vec_init(NUMBERS);
    *b = (struct two_body){all, all + 1, all + 2, all + 3, all + 3 + CRAFT, all + 3 + CRAFT + CRAFT * AXES};
}

void two_body_clear(struct two_body *b)
{
    _arb_vec_clear(b->smallness, NUMBERS);
}

static void inverse_length(arb_t z, arb_srcptr d, slong prec)
{
    arb_dot(z, NULL, 0, d, 1, d, 1, AXES, prec);
    arb_rsqrt(z, z, prec);
}

/* F and q, and all coefficients after those of degree 0 */
static void expand_pair(struct jet *jet, const struct two_body *b, slong prec)
{
    VECTOR(arb, d, AXES);
    for (int craft = 0; craft < CRAFT; craft++) {
        arb_srcptr place = b->place + AXES * craft;
        for (int i = 0; i < AXES; i++) {
            arb_set(jet->c[AT(craft, i)], place + i);
            arb_set(jet->c[AT(craft, U + i)], b->velocity + AXES * craft + i);
        }
        _arb_vec_scalar_mul(d, place, AXES, b->smallness, prec);
        arb_add_ui(d, d, 1, prec);
        inverse_length(jet->c[AT(craft, F)], d, prec);
    }
    _arb_vec_sub(d, b->place, b->place + AXES, AXES, prec);
    inverse_length(jet->c[Q], d, prec);
    jet_extend(jet, jet, prec, 0);
}

/* The sum at h, with what majorant_prove bounds of the rest */
static void sum_terms(arb_t z, const struct jet *jet, const struct majorant *m, int v, const arb_t h, slong prec)
{
    _arb_poly_evaluate(z, jet->c[v], jet->order + 1, h, prec);
    arb_add_error_mag(z, m->remainder + v);
}

bool two_body_move(struct two_body *b, const arb_t tau, slong prec)
{
    const slong steps = (slong)ceil(arf_get_d(arb_midref(tau), ARF_RND_UP) / TWO_BODY_STEP);
    bool proved = true;
    OWNED(jet) jet;
    OWNED(majorant) bound;
    SCOPE(arb, h);
    SCOPE(mag, length, one);
    jet_init(&jet, &two_craft, PAIR_ORDER, NULL);
    majorant_init(&bound, &two_craft, PAIR_ORDER);
    jet_constants(&jet, b->c1, b->c2);
    arb_set(jet.c[SMALLNESS], b->smallness);
    arb_inv(jet.c[INVERSE], b->smallness, prec);
    arb_set(jet.c[MASS1], b->mass);
    arb_set(jet.c[MASS2], b->mass + 1);
    arb_div_si(h, tau, steps, prec);
    arb_get_mag(length, h);
    mag_one(one);
    for (slong k = 0; k < steps && proved; k++) {
        expand_pair(&jet, b, prec);
        majorant_of(&bound, &jet, one, 1, length);
        proved = majorant_prove(&bound, NULL, length);
        for (int i = 0; i < CRAFT * AXES; i++) {
            sum_terms(b->place + i, &jet, &bound, AT(i / AXES, i % AXES), h, prec);
            sum_terms(b->velocity + i, &jet, &bound, AT(i / AXES, U + i % AXES), h, prec);
        }
    }
    return proved;
}
