/* A pair let go from rest on the radius, at constant charge and under the law (18), signed Q. Units: see basin.h. */
#include "claims/basin.h"
#include "claims/claim.h"
#include "claims/guarantee.h"
#include "claims/trajectory.h"
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
    const struct sheet *sheet = sheet_of(c);
    VECTOR(arb, lengths, TIMES);
    VECTOR(fmpq, times, TIMES);
    SCOPE(arb, L_ref, start);
    sheet_value(L_ref, sheet, "L_ref", BASIN_BITS);
    for (slong k = 0; k < TIMES; k++) { /* in radians of orbit */
        literal_read(times + k, quantity_find(sheet, "Omega")->value, true);
        fmpq_mul_si(times + k, times + k, 43200 * (k + 1));
    }
    for (int i = 0; i < 2; i++) {
        sheet_value(start, sheet, "dL", BASIN_BITS);
        arb_div(start, start, L_ref, BASIN_BITS);
        arb_mul_si(start, start, i == 0 ? 1 : -1, BASIN_BITS);
        arb_add_ui(start, start, 1, BASIN_BITS);
        const bool run = follow_from_rest(0, start, times, TIMES, take_length, lengths) == FLOW_DONE;
        _arb_vec_scalar_mul(lengths, lengths, TIMES, L_ref, BASIN_BITS);
        give(c, CERTIFIED, run, lengths, "%s_12", names[i]);
        give(c, CERTIFIED, run, lengths + 1, "%s_24", names[i]);
    }
}

/*
 * From which dL in m the pair returns, and from which it swings out and escapes: until E is below the separatrix level.
 * `half`: from half of L_ref, with the charge product that (18) commands, of either sign.
 */
static void basin(struct computed *c)
{
    static const struct {
        const char *name;
        ulong n;
        slong tenths; /* dL in tenths of a metre */
        enum release release;
    } starts[] = {
        {"returns_10", 10, -24, RELEASE_RETURNS}, {"escapes_10", 10, -25, RELEASE_ESCAPES}, {"returns_12", 12, -80, RELEASE_RETURNS},
        {"escapes_12", 12, -85, RELEASE_ESCAPES}, {"half_escapes_10", 10, -50, RELEASE_ESCAPES}, {"half_returns_12", 12, -50, RELEASE_RETURNS},
    };
    SCOPE(arb, x);
    for (size_t i = 0; i < sizeof starts / sizeof *starts; i++) {
        struct basin b;
        basin_init(&b, steps_of(c), starts[i].n);
        arb_set_si(x, starts[i].tenths);
        arb_div_ui(x, x, 10, BASIN_BITS);
        give(c, CERTIFIED, basin_release(&b, starts[i].tenths) == starts[i].release, x, "%s", starts[i].name);
        basin_clear(&b);
    }
}

/* The numbers of guarantee.h at n = 10 and 12. */
static void give_guarantees(struct computed *c)
{
    VECTOR(arb, values, GUARANTEES);
    SCOPE(arb, n);
    for (int gain = 10; gain <= 12; gain += 2) {
        arb_set_si(n, gain);
        const bool found = guarantees_enclose(values, n, NULL, BASIN_BITS);
        for (int i = 0; i < GUARANTEES; i++)
            give(c, CERTIFIED, found, values + i, "%s_%d", guarantees[i].name, gain);
    }
}

#define BASIN(n) " depth_" n " yaw_" n " pitch_" n " angle_rate_" n " shortest_" n " longest_" n " box_" n " q_max_" n " across_" n
#define STEADY_ERRORS(n) " deficit_" n " debye_" n " outward_" n " inward_" n " along_" n
#define SUDDEN(n) " deficit_step_" n " excess_step_" n " outward_step_" n " inward_step_" n " along_step_" n

const struct computation computations_basin[] = {
    {"guaranteed", give_guarantees, BASIN("10") BASIN("12") STEADY_ERRORS("10") STEADY_ERRORS("12") SUDDEN("10") SUDDEN("12"), NULL},
    {"released", released, "longer_12 longer_24 shorter_12 shorter_24", NULL},
    {"basin", basin, "returns_10 escapes_10 returns_12 escapes_12 half_escapes_10 half_returns_12", NULL},
    {NULL, NULL, NULL, NULL},
};
