#include "claims/guarantee.h"

#include <string.h>

#include "claims/curve.h"
#include "claims/sampling.h"
#include "text/scope.h"

/* U where the charges follow the command, where they have reached their bound (r > bound), and both; U' of the first. */
#define FREE(r) "((n - 3)/(" r ") + n*log(" r "))"
#define HELD(r) "(" FREE("bound") " + 3*outer^3*(1/bound - 1/(" r ")))"
#define U(r) "(" FREE(r) " + positive(" r " - bound)*(" HELD(r) " - " FREE(r) "))"
#define SLOPE(r) "((3 + n*(" r " - 1))/(" r ")^2)"

/* E - U with psi, theta and all rates x, at the length r (claim basin-box). */
#define MOVING(r) "(x^2 + (" r ")^2*(x^2 + sin(x)^2 + cos(x)^2*(x^2 - 3*cos(x)^2)))/2"

/* Where the balance with the screened force folds, L/lambda_d = u: u^2/(1 + u) is the first of these, u the second. */
#define LOSS "((3*n - 9 - 2*n*x)/(3 + n*(x - 1)))"
#define SCREENED "((" LOSS " + sqrt(" LOSS "^2 + 4*" LOSS "))/2)"

/*
 * Why there is one root: E on the radius falls from r = 0 to 1, and rises to `outer`; the most of E in a box rises with the
 * box; `saddle` rises with the length that can be held. The error by which a step lifts E at r = 1 to that of the saddle at
 * r moves the difference by U(1) - U(r), by 1 - r; U'' falls, and is 3 + n - 9 at r = 1.
 *
 * Late by d, the roots are those of lambda^4 - 2 lambda^2 - 27 + (c1 + c2 lambda)(lambda^2 + 3) exp(-d lambda). In the right
 * half plane they are bounded, so they get there over the axis: at lambda = i w, with x = w^2,
 * (x^2 + 2 x - 27)^2 = (c1^2 + c2^2 x)(3 - x)^2 and exp(-i d w) = -(x^2 + 2 x - 27)/((c1 + i c2 w)(3 - x)). The left side is less
 * than the other at 0, more at 3, less where x^2 + 2 x = 27, more at (c1 + c2)^2: all four x are real, and three positive. Then d w is
 * atan(c2 w/c1), of the middle one half a turn more. As atan(c2 w/c1)/w falls with w, the largest x has the least d.
 */
const struct guarantee guarantees[] = {
    {"hold", 0, -1, "s", "the law may be held for any time below this one", {NULL}},
    {"delay", 0, -1, "s", "the law may act late by any time below this one", {"atan2(c2*sqrt(x), n)/sqrt(x)",
      [VANISHES] = "(x^2 + 2*x - 27)^2 - (n^2 + c2^2*x)*(3 - x)^2", "2*sqrt(7) - 1", "(n + c2)^2"}},
    {"equilibrium", 1, 0, "m", "other equilibrium on the radius", {"(sqrt(12*n - 27) - 3)/6"}},
    {"outer", 1, 0, "m", "length that the pair never passes from within the separatrix level", {"equilibrium", "y"}},
    {"bound", 1, 0, "m", NULL, {"1 + 3*(outer^3 - 1)/n"}},
    {"saddle", 0, 0, "-", NULL, {HELD("outer") " - 3/2*outer^2"}},
    {"across", 0, 0, "-", NULL, {"n + n*log(1 - 3/n)"}},
    {"level", 0, 0, "-", "separatrix level of the energy", {"saddle", "across"}},
    {"depth", 0, 0, "-", "separatrix level over the energy of rest at L_ref", {"level - n + 9/2"}},
    {"shortest", 1, 0, "m", "shortest length from which the pair, let go on the radius, surely returns",
     {[VANISHES] = FREE("x") " - 3/2*x^2 - level", "(1 - 3/n)/2", "1"}},
    {"longest", 1, 0, "m", "longest length from which the pair, let go on the radius, surely returns",
     {[VANISHES] = "level - " U("x") " + 3/2*x^2", "1", "outer"}},
    {"length", 1, 0, "m", "largest length error of either sign, all else at rest", {"1 - shortest", "longest - 1"}},
    {"yaw", 0, 0, "rad", "largest yaw, all else at rest", {"atan2(sqrt(2*depth/3), sqrt(1 - 2*depth/3))"}},
    {"pitch", 0, 0, "rad", "largest pitch, all else at rest", {"atan2(sqrt(depth/2), sqrt(1 - depth/2))"}},
    {"angle_rate", 0, 1, "rad/s", "largest rate of yaw, or of pitch, all else at rest", {"sqrt(2*depth)"}},
    {"length_rate", 1, 1, "m/s", "largest rate of the length, all else at rest", {"angle_rate"}},
    {"widest", 0, 0, "-", NULL, {"outer - 1", "1/2"}},
    {"longer", 0, 0, "-", NULL, {[VANISHES] = "level - " MOVING("1 + x") " - " U("1 + x"), "0", "widest"}},
    {"shorter", 0, 0, "-", NULL, {[VANISHES] = "level - " MOVING("1 - x") " - " FREE("1 - x"), "0", "widest"}},
    {"box", 0, 0, "-", "bound of psi, theta, dL/L_ref and of their rates in radians of orbit, all at once",
     {"longer", "shorter"}},
    {"held", 1, 0, "m", NULL,
     {[VANISHES] = "level - " FREE("1 + 3*(x^3 - 1)/n") " - 3*x^3/(1 + 3*(x^3 - 1)/n) + 9/2*x^2", "1", "outer"}},
    {"q_max", 0, 0, "-", "charge that a craft must bear for all of that, over its charge at rest", {"sqrt(held^3)"}},
    {"fold", 1, 0, "m", NULL, {"3*(n - 3)/(2*n)"}},
    {"deficit", 0, 0, "-", "part of the force that may be missing, if it goes slowly", {"1 - 81*(n - 3)^2/(4*n^3)"}},
    {"deficit_step", 0, 0, "-", "part of the force that may be missing at once, at rest at L_ref", {"1 - 3*x^3/(3 + n*(x - 1))",
      [VANISHES] = "3/2*(x^2 - 1) + 3*x^3/(3 + n*(x - 1))*(n - 3 - " FREE("x") ")", "fold", "equilibrium"}},
    {"excess_step", 0, 0, "-", "part by which the force may be too strong at once, at rest at L_ref",
     {"3/(2*(n - 3 - across)) - 1"}},
    {"debye", 1, 0, "m", "shortest Debye length, reached slowly, the force being that of a screened potential", {"x/" SCREENED,
      [VANISHES] = "3*x^3 - (1 + " SCREENED ")*exp(-" SCREENED ")*(3 + n*(x - 1))", "1", "fold"}},
    {"inflection", 1, 0, "m", NULL, {[VANISHES] = "3*x^3 + n*x - 2*(n - 3)", "1", "equilibrium"}},
    {"outward", 1, 2, "m/s^2", "steady outward push, coming on slowly", {SLOPE("inflection") " - 3*inflection"}},
    {"outward_step", 1, 2, "m/s^2", "outward push that may come on at once, at rest at L_ref", {SLOPE("x") " - 3*x",
      [VANISHES] = FREE("x") " - 3/2*x^2 - n + 9/2 - (" SLOPE("x") " - 3*x)*(x - 1)", "inflection", "equilibrium"}},
    {"inward", 1, 2, "m/s^2", "steady inward push, coming on slowly", {"3 - 9/n"}},
    {"inward_step", 1, 2, "m/s^2", "inward push that may come on at once, at rest at L_ref",
     {"3 - sqrt(9 - 6*(across - n + 9/2))"}},
    {"along", 1, 2, "m/s^2", "steady push along the track, coming on slowly, whatever the gains", {"3"}},
    {"turned", 1, 0, "m", NULL, {[VANISHES] = FREE("x") " - " SLOPE("x") "*x - n + 9/2", "1 - 3/n", "1"}},
    {"along_step", 1, 2, "m/s^2", "push along the track that may come on at once, at rest at L_ref",
     {"sqrt(6*(" FREE("equilibrium") " - 3/2*equilibrium^2 - n + 9/2))", SLOPE("turned")}},
    {NULL, 0, 0, NULL, NULL, {NULL}},
};

int guarantee_find(const char *name)
{
    for (int i = 0; guarantees[i].name != NULL; i++)
        if (strcmp(guarantees[i].name, name) == 0)
            return i;
    return -1;
}

/* ---- the table's formulas in balls ---- */

enum { GIVEN_N, GIVEN_C2, GIVEN_Y, UNKNOWN_X, FIRST_NUMBER }; /* inputs: these, then each number */
enum { SLOPE_OF_IT = FORMULAS, NODES };                       /* of a number's formulas, and of what vanishes */

static arb_srcptr value_of_node(struct machine *m, int node)
{
    machine_run_to(m, node);
    return machine_value(m, node);
}

static int sign_at_end(struct curve *c, const arf_t x)
{
    SCOPE(arb, at);
    arb_set_arf(at, x);
    return sign_of_ball(curve_at(c, at));
}

/*
 * The root between the bounds, at which the formula has different signs (of a ball of bounds either end will do). At the upper one, or
 * next to it, it may vanish twice over: then the root lies beyond where its sign is still certain, 2^-j of the interval before the end.
 */
static void guarantee_root(arb_t x, struct machine *m, const int *nodes)
{
    struct curve root = {m, UNKNOWN_X, nodes[VANISHES], nodes[SLOPE_OF_IT]};
    SCOPE(arf, low, high, near, width);
    arb_get_ubound_arf(low, value_of_node(m, nodes[LOW]), m->prec);
    arb_get_ubound_arf(high, value_of_node(m, nodes[HIGH]), m->prec);
    const int sign = sign_at_end(&root, low), end = sign_at_end(&root, high);
    arb_indeterminate(x);
    if (sign == 0 || end == sign)
        return;
    for (arf_sub(width, high, low, m->prec, ARF_RND_DOWN); end == 0; arf_set(low, near)) {
        arf_mul_2exp_si(width, width, -1);
        arf_sub(near, high, width, m->prec, ARF_RND_DOWN);
        if (sign_at_end(&root, near) != sign)
            break;
    }
    arb_set_interval_arf(x, low, high, m->prec);
    narrow_root(x, curve_series, &root, m->prec);
}

bool guarantees_enclose(arb_ptr values, const struct derivations *steps, const arb_t n, const arb_t c2, const arb_t y, slong bits)
{
    struct program p;
    struct machine m;
    static const char *const given[] = {"n", "c2", "y", "x"};
    int nodes[GUARANTEES][NODES];
    SCOPE(arb, least);
    arb_set_ui(least, 9);
    _arb_vec_indeterminate(values, GUARANTEES);
    if (!arb_gt(n, least) || !arb_is_positive(c2))
        return false;
    arb_one(least);
    if (y != NULL && !arb_gt(y, least))
        return false;
    program_init(&p);
    for (int i = 0; i < FIRST_NUMBER; i++)
        program_input(&p, given[i]);
    for (int i = 0; i < GUARANTEES; i++)
        program_input(&p, guarantees[i].name);
    for (int i = 0; i < GUARANTEES; i++) {
        for (int k = 0; k < FORMULAS; k++)
            if (guarantees[i].formula[k] != NULL)
                nodes[i][k] = program_parse(&p, guarantees[i].formula[k], NULL);
        if (guarantees[i].formula[VANISHES] != NULL)
            nodes[i][SLOPE_OF_IT] = program_slope(&p, nodes[i][VANISHES], UNKNOWN_X);
    }
    machine_init(&m, &p, &arithmetic_ball, bits);
    arb_set(machine_value(&m, GIVEN_N), n);
    arb_set(machine_value(&m, GIVEN_C2), c2);
    arb_set(machine_value(&m, GIVEN_Y), y != NULL ? y : n); /* no length is longer than n */
    if (steps != NULL)
        largest_hold(values + guarantee_find("hold"), steps, n, c2, bits);
    for (int i = 0; i < GUARANTEES; i++) {
        const char *const *formula = guarantees[i].formula;
        if (formula[VANISHES] != NULL) {
            guarantee_root(values + i, &m, nodes[i]);
            arb_set(machine_value(&m, UNKNOWN_X), values + i);
        }
        if (formula[VALUE] != NULL)
            arb_set(values + i, value_of_node(&m, nodes[i][VALUE]));
        if (formula[OTHER] != NULL)
            arb_min(values + i, values + i, value_of_node(&m, nodes[i][OTHER]), bits);
        arb_set(machine_value(&m, FIRST_NUMBER + i), values + i);
    }
    machine_clear(&m);
    program_clear(&p);
    return true;
}
