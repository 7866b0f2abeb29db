/*
 * The nonlinear motion beside the linear one: how far the linear model carries, how both come to rest, the charges.
 * Samples come from certified flows; what happens between and after them is bounded in track.h.
 */
#include <stdio.h>

#include "claims/convergence.h"
#include "claims/give.h"
#include "text/scope.h"

enum { DAY = 86400, HORIZON = 3 * DAY, HALF_SWING = 10800, BITS = 128 }; /* s; of 4 Omega, pi/(4 Omega) = 10771 s */

enum { DIGITS = 12 }; /* of the rows: too few would leave digits of the evidence unproved, and the verdict undecided */

static const struct scene linear = {.digits = DIGITS}, linear_planar = {.digits = DIGITS, .theta = "0"},
                          nonlinear = {.nonlinear = true, .digits = DIGITS},
                          planar = {.nonlinear = true, .digits = DIGITS, .theta = "0"},
                          at_12 = {.nonlinear = true, .digits = DIGITS, .n = "12"};

/* psi, theta and dL/L_ref all start at 0.01, and craft 1 starts 0.01 arms from its place, in x, y and z. */
static void of_start(arb_t x)
{
    arb_mul_ui(x, x, 100, BITS);
}

/* ---- the linear model beside the nonlinear one ---- */

/* The largest difference of two tracks from t = 0 to a sample, between the samples too. */
static bool gap_until(arb_t gap, const struct track *a, const struct track *b, int which, slong row)
{
    struct bounds one, other;
    SCOPE(arb, room);
    bounds_init(&one);
    bounds_init(&other);
    bool bounded = track_bounds(&one, a, 0) && track_bounds(&other, b, 0);
    track_gap(gap, a, b, which, 0, row);
    track_room(room, a, &one, which);
    arb_add(gap, gap, room, BITS);
    track_room(room, b, &other, which);
    arb_add(gap, gap, room, BITS);
    bounds_clear(&other);
    bounds_clear(&one);
    return bounded;
}

/* The first sample at which two tracks differ by a tenth of what the linear one may still reach, in hours; false where a
   bound fails before. */
static bool first_parting(bool *parted, arb_t hours, const struct track *a, const struct track *b, int which)
{
    struct bounds left;
    SCOPE(arb, gap);
    slong k = -1;
    bool bounded = true;
    bounds_init(&left);
    *parted = false;
    while (!*parted && ++k < a->count && bounded) {
        bounded = track_bounds(&left, a, k);
        track_gap(gap, a, b, which, k, k);
        arb_mul_ui(gap, gap, 10, BITS);
        *parted = bounded && arb_gt(gap, left.of[which]);
    }
    arb_set_si(hours, k * a->step);
    arb_div_ui(hours, hours, 3600, BITS);
    bounds_clear(&left);
    return bounded;
}

/* With and without pitch: differences in the place of craft 1 as fractions of the start, their largest, `worst`; and when
   psi and dL part, which they do not without pitch. */
static void compare_models(struct computed *c)
{
    static const long until[] = {3, 12, 72}; /* h */
    const long step = 200;
    SCOPE(arb, x, worst);
    bool proved = true;
    for (int without = 0; without < 2; without++) {
        const char *name = without ? "planar" : "pitched";
        struct track a, b;
        proved = track_run(&a, sheet_of(c), without ? &linear_planar : &linear, 0, step, HORIZON) && proved;
        proved = track_run(&b, sheet_of(c), without ? &planar : &nonlinear, 0, step, HORIZON) && proved;
        for (int i = 0; i < 3; i++)
            for (int which = PLACE_X; which <= PLACE_Z; which++) {
                const bool bounded = gap_until(x, &a, &b, which, until[i] * 3600 / step) && proved;
                of_start(x);
                arb_max(worst, worst, x, BITS);
                give(c, bounded, x, "%s_%ld_%s", name, until[i], variable_names[which]);
                proved = proved && bounded;
            }
        for (int which = PSI; which <= ETA; which += ETA) {
            bool parted;
            const bool bounded = first_parting(&parted, x, &a, &b, which) && proved;
            if (without)
                give_truth(c, which ? "together_dL" : "together_psi", !bounded ? UNDECIDED : parted ? FOUND_FALSE : FOUND_TRUE, CERTIFIED);
            else
                give(c, bounded && parted, x, "parted_%s", variable_names[which]);
        }
        track_clear(&a);
        track_clear(&b);
    }
    give(c, proved, worst, "worst");
}

/* Nonlinear minus linear when every initial value shrinks from 1e-5 to 1e-6: order p, constant c; the most that a p is off 2. */
static void second_order(struct computed *c)
{
    static const int which[] = {PSI, THETA, ETA, PLACE_X, PLACE_Y, PLACE_Z};
    static const char *const angle[] = {"1e-5", "1e-6"}, *const length[] = {"1e-4", "1e-5"};
    bool proved = true;
    VECTOR(arb, gap, 2 * 6);
    SCOPE(arb, x, worst);
    for (int i = 0; i < 2; i++) {
        struct track a, b;
        struct scene s = {.psi = angle[i], .theta = angle[i], .dL = length[i]};
        proved = track_run(&a, sheet_of(c), &s, DAY, 1, DAY) && proved;
        s.nonlinear = true;
        proved = track_run(&b, sheet_of(c), &s, DAY, 1, DAY) && proved;
        for (int k = 0; k < 6; k++)
            track_gap(gap + 6 * i + k, &a, &b, which[k], 0, 0);
        track_clear(&b);
        track_clear(&a);
    }
    for (int k = 0; k < 6; k++) {
        observed_order(x, gap + k, gap + 6 + k, 10);
        raise_to_difference(worst, x, 2);
        give(c, proved, x, "p_%s", variable_names[which[k]]);
        arb_set_ui(x, 10);
        arb_pow_ui(x, x, 12, BITS);
        arb_mul(x, x, gap + 6 + k, BITS);
        give(c, proved, x, "c_%s", variable_names[which[k]]);
    }
    give(c, proved, worst, "worst");
}

/* ---- coming to rest ---- */

/* The largest |psi| and |dL| between 2 and 3 days, as fractions of the start. */
static void nonlinear_settling(struct computed *c)
{
    static const struct scene unequal = {.nonlinear = true, .digits = DIGITS, .m1 = "10", .m2 = "1000"};
    static const struct {
        const char *name;
        const struct scene *scene;
    } runs[] = {{"pitched", &nonlinear}, {"planar", &planar}, {"unequal", &unequal}, {"at_12", &at_12}};
    SCOPE(arb, x);
    for (int i = 0; i < 4; i++) {
        struct track t;
        const bool run = track_run(&t, sheet_of(c), runs[i].scene, 2 * DAY, 50, HORIZON);
        for (int which = PSI; which <= ETA; which += ETA) {
            const bool bounded = track_sup(x, &t, which, 0, t.count - 1);
            of_start(x);
            give(c, run && bounded, x, "%s_%s", runs[i].name, variable_names[which]);
        }
        track_clear(&t);
    }
}

/*
 * When |psi| and |dL| last leave the band of 1/B of the start, in hours, and of the motion with pitch whether they are
 * still outside it in the last half swing of 4 Omega before day 8. Without pitch the energy of day 4 keeps them in for ever.
 */
static void exits_of(struct computed *c, const char *motion, const char *n, struct scene s)
{
    enum { BANDS_OF = 8 };
    static const ulong bands[BANDS_OF] = {10, 20, 50, 100, 200, 300, 500, 1000};
    const bool pitched = s.nonlinear && s.theta == NULL;
    const long step = pitched ? 60 : 240, last = pitched ? 8 * DAY : 4 * DAY; /* s: what pitch moves does not calm down */
    struct track t;
    VECTOR(arb, limits, BANDS_OF);
    VECTOR(arb, hours, BANDS_OF);
    struct bounds later;
    SCOPE(arb, peak);
    bounds_init(&later);
    s.n = n;
    const bool run = track_run(&t, sheet_of(c), &s, 0, step, last) && track_bounds(&later, &t, t.count - 1);
    for (int which = PSI; which <= ETA; which += ETA) {
        for (int k = 0; k < BANDS_OF; k++)
            arb_div_ui(limits + k, track_row(&t, 0) + which, bands[k], t.prec);
        const bool bounded = track_exits(hours, &t, which, limits, BANDS_OF) && run;
        track_peak(peak, &t, which, t.count - 1 - HALF_SWING / step, t.count - 1);
        for (int k = 0; k < BANDS_OF; k++) {
            char name[64];
            const bool out = arb_gt(peak, limits + k), in = pitched ? !out : arb_lt(later.of[which], limits + k);
            give(c, bounded && in, hours + k, "%s_%s_%s_%lu", motion, n, variable_names[which], bands[k]);
            snprintf(name, sizeof name, "out_%s_%s_%lu", n, variable_names[which], bands[k]);
            if (pitched)
                give_truth(c, name, run && out ? FOUND_TRUE : bounded && arb_is_finite(hours + k) ? FOUND_FALSE : UNDECIDED, CERTIFIED);
        }
    }
    bounds_clear(&later);
    track_clear(&t);
}

static void last_exits(struct computed *c)
{
    static const char *const gains[] = {"10", "12"};
    for (int i = 0; i < 2; i++) {
        exits_of(c, "linear", gains[i], linear);
        exits_of(c, "pitched", gains[i], nonlinear);
        exits_of(c, "planar", gains[i], planar);
    }
}

/* How fast amplitudes, roots of the energy, shrink without pitch between 4 and 8 days, per day. */
static void planar_rates(struct computed *c)
{
    SCOPE(arb, before, rate);
    for (int m = 0; m < 2; m++) {
        struct track t;
        struct scene s = m ? planar : linear_planar;
        s.digits = TRACK_DIGITS; /* on day 8 the energy is down to 1e-22 */
        const bool run = track_run(&t, sheet_of(c), &s, 4 * DAY, 4 * DAY, 8 * DAY);
        track_energy(before, &t, 0);
        track_energy(rate, &t, 1);
        arb_div(rate, before, rate, t.prec);
        arb_log(rate, rate, t.prec);
        arb_div_ui(rate, rate, 8, t.prec);
        give(c, run, rate, m ? "nonlinear" : "linear");
        track_clear(&t);
    }
}

/* The largest |psi| and |dL| on samples of the last half swing of 4 Omega before so many days, as fractions of the start. */
static void residue(struct computed *c, const char *name, const struct scene *s, long days)
{
    struct track t;
    SCOPE(arb, peak);
    const bool run = track_run(&t, sheet_of(c), s, days * DAY - HALF_SWING, 60, days * DAY);
    for (int which = PSI; which <= ETA; which += ETA) {
        arb_zero(peak);
        track_peak(peak, &t, which, 0, t.count - 1);
        of_start(peak);
        give(c, run, peak, "%s_%s_day%ld", name, variable_names[which], days);
    }
    track_clear(&t);
}

static void residues(struct computed *c)
{
    for (int i = 0; i < 3; i++) {
        static const long days[] = {3, 5, 8};
        residue(c, "nonlinear", &nonlinear, days[i]);
        residue(c, "linear", &linear, days[i]);
    }
}

/* The range of sqrt(theta^2 + theta'^2/4) on samples. */
static void pitch_range(arb_t low, arb_t high, const struct track *t, slong from)
{
    SCOPE(arb, a);
    arb_pos_inf(low);
    arb_zero(high);
    for (slong k = from; k < t->count; k++) {
        arb_mul_2exp_si(a, track_row(t, k) + THETA_DOT, -1);
        arb_hypot(a, a, track_row(t, k) + THETA, t->prec);
        arb_min(low, low, a, t->prec);
        arb_max(high, high, a, t->prec);
    }
}

/* In three days and in the last of them; `apart`: the most that theta differs from the linear model's. */
static void pitch_amplitude(struct computed *c)
{
    const long step = 300;
    struct track t, other;
    VECTOR(arb, x, 2);
    bool run = track_run(&t, sheet_of(c), &nonlinear, 0, step, HORIZON);
    run = track_run(&other, sheet_of(c), &linear, 0, step, HORIZON) && run;
    for (int later = 0; later < 2; later++) {
        pitch_range(x, x + 1, &t, later ? 2 * DAY / step : 0);
        give(c, run, x, later ? "late_low" : "low");
        give(c, run, x + 1, later ? "late_high" : "high");
    }
    track_gap(x, &t, &other, THETA, 0, t.count - 1);
    give(c, run, x, "apart");
    track_clear(&other);
    track_clear(&t);
}

/* Between 2 and 3 days: x1 - 5 m and z1 on samples, y1 between them too [m]. */
static void figure_6(struct computed *c)
{
    struct track t;
    VECTOR(arb, x, 2);
    const bool run = track_run(&t, sheet_of(c), &nonlinear, 2 * DAY, 50, HORIZON);
    arb_pos_inf(x);
    for (slong k = 0; k < t.count; k++) {
        arb_min(x, x, track_row(&t, k) + PLACE_X, t.prec);
        arb_max(x + 1, x + 1, track_row(&t, k) + PLACE_X, t.prec);
    }
    for (int i = 0; i < 2; i++) {
        arb_sub_ui(x + i, x + i, 1, t.prec);
        arb_mul(x + i, x + i, t.arm, t.prec);
        give(c, run, x + i, i ? "x1_high" : "x1_low");
    }
    const bool bounded = track_sup(x, &t, PLACE_Y, 0, t.count - 1);
    track_peak(x + 1, &t, PLACE_Z, 0, t.count - 1);
    _arb_vec_scalar_mul(x, x, 2, t.arm, t.prec);
    give(c, run && bounded, x, "y1");
    give(c, run, x + 1, "z1");
    track_clear(&t);
}

/* ---- charges ---- */

/* dQ/Q_ref at a sample, by (7) and (18): (c1 eta + c2 eta')/3 */
static void charge_product(arb_t x, const struct track *t, slong k)
{
    arb_mul(x, t->c1, track_row(t, k) + ETA, t->prec);
    arb_addmul(x, t->c2, track_row(t, k) + ETA_DOT, t->prec);
    arb_div_ui(x, x, 3, t->prec);
}

/* The largest |dQ/Q_ref| of a scene in some time: the samples reach it, between them is room for more. */
static void largest_product(struct computed *c, const char *name, const struct scene *s, long first, long step, long last)
{
    struct track t;
    struct bounds b;
    SCOPE(arb, x, product, room);
    bounds_init(&b);
    const bool proved = track_run(&t, sheet_of(c), s, first, step, last) && track_bounds(&b, &t, 0);
    for (slong k = 0; k < t.count; k++) {
        charge_product(x, &t, k);
        arb_abs(x, x);
        arb_max(product, product, x, t.prec);
    }
    track_room(x, &t, &b, ETA);
    arb_mul(room, x, t.c1, t.prec);
    track_room(x, &t, &b, ETA_DOT);
    arb_addmul(room, x, t.c2, t.prec);
    arb_div_ui(room, room, 3, t.prec);
    arb_add(room, room, product, t.prec);
    arb_union(product, product, room, t.prec);
    give(c, proved, product, "%s", name);
    bounds_clear(&b);
    track_clear(&t);
}

/* Largest |dQ/Q_ref|: in three days; between 2 and 3 days; in the last half swing of day 8. And dQ/Q_ref after 3 days. */
static void charge_products(struct computed *c)
{
    struct track t;
    SCOPE(arb, x);
    largest_product(c, "pitched", &nonlinear, 0, 100, HORIZON);
    largest_product(c, "planar", &planar, 0, 100, HORIZON);
    largest_product(c, "at_12", &at_12, 0, 100, HORIZON);
    largest_product(c, "pitched_late", &nonlinear, 2 * DAY, 50, HORIZON);
    largest_product(c, "pitched_day8", &nonlinear, 8 * DAY - HALF_SWING, 10, 8 * DAY);
    largest_product(c, "planar_late", &planar, 2 * DAY, 50, HORIZON);
    largest_product(c, "planar_day8", &planar, 8 * DAY - HALF_SWING, 50, 8 * DAY);
    const bool run = track_run(&t, sheet_of(c), &nonlinear, HORIZON, 1, HORIZON);
    charge_product(x, &t, 0);
    give(c, run, x, "last");
    track_clear(&t);
}

#define BANDS(of) " " of "_10 " of "_20 " of "_50 " of "_100 " of "_200 " of "_300 " of "_500 " of "_1000"

const struct computation computations_convergence[] = {
    {"compare_models", compare_models,
     "worst parted_psi parted_dL" PLACE_OF_1("pitched_3_") PLACE_OF_1("pitched_12_") PLACE_OF_1("pitched_72_")
         PLACE_OF_1("planar_3_") PLACE_OF_1("planar_12_") PLACE_OF_1("planar_72_"), "together_psi together_dL"},
    {"second_order", second_order,
     "worst" ANGLES_AND_LENGTH("p_", "") PLACE_OF_1("p_") ANGLES_AND_LENGTH("c_", "") PLACE_OF_1("c_"), ""},
    {"nonlinear_settling", nonlinear_settling,
     "pitched_psi pitched_dL planar_psi planar_dL unequal_psi unequal_dL at_12_psi at_12_dL", ""},
    {"last_exits", last_exits,
     BANDS("linear_10_psi") BANDS("linear_10_dL") BANDS("linear_12_psi") BANDS("linear_12_dL")
     BANDS("pitched_10_psi") BANDS("pitched_10_dL") BANDS("pitched_12_psi") BANDS("pitched_12_dL")
     BANDS("planar_10_psi") BANDS("planar_10_dL") BANDS("planar_12_psi") BANDS("planar_12_dL"),
     BANDS("out_10_psi") BANDS("out_10_dL") BANDS("out_12_psi") BANDS("out_12_dL")},
    {"planar_rates", planar_rates, "linear nonlinear", ""},
    {"residues", residues,
     "nonlinear_psi_day3 nonlinear_dL_day3 nonlinear_psi_day5 nonlinear_dL_day5 nonlinear_psi_day8 nonlinear_dL_day8 "
     "linear_psi_day3 linear_dL_day3 linear_psi_day5 linear_dL_day5 linear_psi_day8 linear_dL_day8", ""},
    {"pitch_amplitude", pitch_amplitude, "low high late_low late_high apart", ""},
    {"figure_6", figure_6, "x1_low x1_high y1 z1", ""},
    {"charge_products", charge_products, "pitched planar at_12 pitched_late pitched_day8 planar_late planar_day8 last", ""},
    {NULL, NULL, NULL, NULL},
};
