/*
 * A pair let go from rest on the radius, at constant charge and under the law (18), signed Q. Units: see basin.h.
 */
#include "claims/basin.h"
#include "claims/give.h"
#include "claims/track.h"
#include "sheet/sheet.h"
#include "text/decimal.h"
#include "text/scope.h"

enum { TIMES = 2 }; /* 12 h and 24 h */

static int take_length(void *context, slong k, const fmpq_t t, arb_srcptr state)
{
    (void)t;
    arb_hypot((arb_ptr)context + k, state, state + 1, BASIN_BITS);
    return 0;
}

/* L in m after 12 h and 24 h at constant charge, from the paper's dL above L_ref, and from as much below. */
static void released(struct computed *c)
{
    static const char *const names[] = {"longer", "shorter"};
    VECTOR(arb, lengths, TIMES);
    VECTOR(fmpq, times, TIMES);
    SCOPE(arb, L_ref, start);
    sheet_value(L_ref, sheet_of(c), "L_ref", BASIN_BITS);
    for (slong k = 0; k < TIMES; k++) { /* in radians of orbit */
        literal_read(times + k, quantity_find(sheet_of(c), "Omega")->value, true);
        fmpq_mul_si(times + k, times + k, 43200 * (k + 1));
    }
    for (int i = 0; i < 2; i++) {
        sheet_value(start, sheet_of(c), "dL", BASIN_BITS);
        arb_div(start, start, L_ref, BASIN_BITS);
        arb_mul_si(start, start, i == 0 ? 1 : -1, BASIN_BITS);
        arb_add_ui(start, start, 1, BASIN_BITS);
        const bool run = follow_from_rest(0, start, times, TIMES, take_length, lengths) == FLOW_DONE;
        _arb_vec_scalar_mul(lengths, lengths, TIMES, L_ref, BASIN_BITS);
        give(c, run, lengths, "%s_12", names[i]);
        give(c, run, lengths + 1, "%s_24", names[i]);
    }
}

/* From which dL in m the pair returns, and from which it swings out and escapes: until E is below the separatrix level. */
static void basin(struct computed *c)
{
    static const slong returns[GAINS] = {-24, -80}, escapes[GAINS] = {-25, -85}; /* tenths of a metre */
    SCOPE(arb, x);
    for (int i = 0; i < GAINS; i++) {
        struct basin b;
        basin_init(&b, basin_gains[i]);
        arb_set_si(x, returns[i]);
        arb_div_ui(x, x, 10, BASIN_BITS);
        give(c, basin_release(&b, sheet_of(c), returns[i]) == RELEASE_RETURNS, x, "returns_%lu", basin_gains[i]);
        arb_set_si(x, escapes[i]);
        arb_div_ui(x, x, 10, BASIN_BITS);
        give(c, basin_release(&b, sheet_of(c), escapes[i]) == RELEASE_ESCAPES, x, "escapes_%lu", basin_gains[i]);
        basin_clear(&b);
    }
}

/* From rest at half of L_ref with the charge product that (18) commands, of either sign. */
static void half_length(struct computed *c)
{
    static const char *const names[GAINS][2] = {{"returns_10", "escapes_10"}, {"returns_12", "escapes_12"}};
    for (int i = 0; i < GAINS; i++) {
        struct basin b;
        basin_init(&b, basin_gains[i]);
        const enum release release = basin_release(&b, sheet_of(c), -50);
        for (int k = 0; k < 2; k++) {
            const enum release named = k == 0 ? RELEASE_RETURNS : RELEASE_ESCAPES;
            const enum truth found = release == RELEASE_OPEN ? UNDECIDED : release == named ? FOUND_TRUE : FOUND_FALSE;
            give_truth(c, names[i][k], found, CERTIFIED);
        }
        basin_clear(&b);
    }
}

const struct computation computations_loop[] = {
    {"half_length", half_length, "", "returns_10 escapes_10 returns_12 escapes_12"},
    {"released", released, "longer_12 longer_24 shorter_12 shorter_24", ""},
    {"basin", basin, "returns_10 escapes_10 returns_12 escapes_12", ""},
    {NULL, NULL, NULL, NULL},
};
