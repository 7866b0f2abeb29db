/*
 * A pair let go from rest on the radius, at constant charge and under the law (18), signed Q. Units: see well.h.
 */
#include "decimal.h"
#include "enclosure.h"
#include "give.h"
#include "sheet.h"
#include "well.h"

enum { TIMES = 2 }; /* 12 h and 24 h */

static int take_length(void *context, slong k, const fmpq_t t, arb_srcptr state)
{
    arb_ptr lengths = context;
    (void)t;
    enclose(lengths + k, "L_ref*sqrt(x^2 + y^2)", KNOWN({"x", state}, {"y", state + 1}));
    return 0;
}

/* L in m after 12 h and 24 h at constant charge, from the paper's dL above L_ref, and from as much below. */
static void released(struct computed *c)
{
    static const char *const starts[] = {"1 + dL/L_ref", "1 - dL/L_ref"}, *const names[] = {"longer", "shorter"};
    arb_ptr lengths = _arb_vec_init(TIMES);
    fmpq *times = _fmpq_vec_init(TIMES);
    arb_t start;
    arb_init(start);
    for (slong k = 0; k < TIMES; k++) { /* in radians of orbit */
        literal_read(times + k, quantity_find(sheet(), "Omega")->value, true);
        fmpq_mul_si(times + k, times + k, 43200 * (k + 1));
    }
    for (int i = 0; i < 2; i++) {
        enclose(start, starts[i], NOTHING);
        const bool run = follow(0, start, times, TIMES, take_length, lengths) == FLOW_DONE;
        give(c, run, lengths, "%s_12", names[i]);
        give(c, run, lengths + 1, "%s_24", names[i]);
    }
    arb_clear(start);
    _fmpq_vec_clear(times, TIMES);
    _arb_vec_clear(lengths, TIMES);
}

/* From which dL in m the pair returns, and from which it swings out and escapes: until E is below the separatrix level. */
static void basin(struct computed *c)
{
    static const slong returns[GAINS] = {-24, -80}, escapes[GAINS] = {-25, -85}; /* tenths of a metre */
    bool proved = true;
    arb_t x;
    arb_init(x);
    for (int i = 0; i < GAINS; i++) {
        struct well w;
        well_init(&w, well_gains[i]);
        arb_set_si(x, returns[i]);
        arb_div_ui(x, x, 10, ENCLOSURE_BITS);
        give(c, well_fate(&w, returns[i]) == FATE_RETURNS, x, "returns_%lu", well_gains[i]);
        arb_set_si(x, escapes[i]);
        arb_div_ui(x, x, 10, ENCLOSURE_BITS);
        give(c, well_fate(&w, escapes[i]) == FATE_ESCAPES, x, "escapes_%lu", well_gains[i]);
        proved = proved && w.proved;
        well_clear(&w);
    }
    give_truth(c, "level", proved ? FOUND_TRUE : UNDECIDED, EXACT);
    arb_clear(x);
}

const struct computation computations_loop[] = {
    {"released", released, "longer_12 longer_24 shorter_12 shorter_24", ""},
    {"basin", basin, "returns_10 escapes_10 returns_12 escapes_12", "level"},
    {NULL, NULL, NULL, NULL},
};
