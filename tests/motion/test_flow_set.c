/*
 * verify/motion/flow_set.h and sets of motion.h: certified motions from anywhere in a box, its corners first, keep within what is
 * proved of the set; where one error term outweighs all others, a bound without it would lose them.
 */
#include "tests/run.h"
#include "tests/paper.h"

#include <math.h>
#include <string.h>

#include "motion/flow_set.h"
#include "motion/motion.h"
#include "text/decimal.h"
#include "text/scope.h"

enum { PREC = 128, TIMES = 3, MOST_INTERVALS = 7 };

static double number(int k)
{
    return 2 * fmod(k * 0.6180339887498949, 1) - 1;
}

/* ---- boxes of the command line ---- */

struct interval {
    enum scenario_name name;
    const char *value, *radius;
};

struct box {
    struct interval of[MOST_INTERVALS + 1];
    double seconds;
    int motions;
    double most; /* times as wide as what the motions fill, at most: positions, at the end */
};

#define PLACE(r, v) \
    {SET_x1, "5.05", r}, {SET_y1, "0.0505", r}, {SET_z1, "-0.0505", r}, {SET_x1_dot, "0", v}, {SET_y1_dot, "0", v}, {SET_z1_dot, "0", v}

static const struct box boxes[] = {
    {{PLACE("0.001", "1e-7")}, 86400, 24, 1.3},
    {{PLACE("0.01", "1e-6")}, 43200, 48, 1.4},
    {{PLACE("0.005", "0"), {SET_C1, "5.3166497225e-08", "5.3e-10"}}, 43200, 32, 1.6},
    {{{SET_psi, "0.01", "0.001"}, {SET_theta, "0.02", "0.002"}, {SET_dL, "0.1", "0.01"}, {SET_m1, "150", "1"}}, 43200, 40, 1.5},
    {{{SET_psi_dot, "1e-6", "1e-7"}, {SET_theta_dot, "-1e-6", "1e-7"}, {SET_dL_dot, "1e-5", "1e-6"}, {SET_m2, "100", "2"},
      {SET_L_ref, "10", "0.01"}}, 21600, 40, 1.5},
    {{{SET_C1, "6e-8", "1e-9"}, {SET_C2, "1.5e-4", "1e-6"}}, -20000, 12, 1.6},
    {{{SET_psi, "0.1", "0"}, {SET_dL, "0.5", "0"}, {SET_m1, "150", "75"}}, 5000, 12, 2.5},
    {{PLACE("0", "0")}, 259200, 1, HUGE_VAL},
};

static void give(struct scenario *s, const struct interval *i, bool with_radius)
{
    s->given[i->name] = true;
    ck_assert_int_eq(literal_read(&s->value[i->name].value, i->value, true), LITERAL_FINITE);
    if (with_radius)
        ck_assert_int_eq(literal_read(s->radius + i->name, i->radius, true), LITERAL_FINITE);
}

struct rows {
    fmpq *times, *low, *high;
};

static void rows_clear(struct rows *r)
{
    _fmpq_vec_clear(r->times, TIMES * (1 + 2 * ROW_NUMBERS));
}

static int keep_bounds(void *context, slong k, const fmpq_t t, char *const *numbers)
{
    struct rows *r = context;
    (void)t;
    for (int v = 0; v < ROW_NUMBERS; v++) {
        ck_assert_int_eq(literal_read(r->low + ROW_NUMBERS * k + v, numbers[2 * v], true), LITERAL_FINITE);
        ck_assert_int_eq(literal_read(r->high + ROW_NUMBERS * k + v, numbers[2 * v + 1], true), LITERAL_FINITE);
    }
    return 0;
}

struct seen {
    const struct rows *rows;
    struct flow_parameters parameters; /* of the motion */
    double low[ROW_NUMBERS], high[ROW_NUMBERS]; /* of the last row, over all motions */
    slong count;
};

static int look(void *context, slong k, const fmpq_t t, arb_srcptr state)
{
    struct seen *s = context;
    VECTOR(arb, row, ROW_NUMBERS);
    SCOPE(arb, end, product);
    (void)t;
    _arb_vec_set(row, state, FLOW_STATE);
    charges_of_state(row + FLOW_STATE, product, sheet(), &s->parameters, state, PREC);
    for (int v = 0; v < ROW_NUMBERS; v++) {
        arb_set_fmpq(end, s->rows->low + ROW_NUMBERS * k + v, PREC);
        ck_assert_msg(!arb_gt(end, row + v), "row %d, number %d: below", (int)k, v);
        arb_set_fmpq(end, s->rows->high + ROW_NUMBERS * k + v, PREC);
        ck_assert_msg(!arb_lt(end, row + v), "row %d, number %d: above", (int)k, v);
        const double x = arf_get_d(arb_midref(row + v), ARF_RND_NEAR);
        if (k == TIMES - 1) {
            s->low[v] = fmin(s->low[v], x);
            s->high[v] = fmax(s->high[v], x);
        }
    }
    s->count++;
    return 0;
}

/* A box's scenario, with its radii, and what is proved of it until then */
static struct rows rows_of(struct scenario *s, const struct interval *of, double seconds, int pieces)
{
    fmpq *all = _fmpq_vec_init(TIMES * (1 + 2 * ROW_NUMBERS));
    struct rows r = {all, all + TIMES, all + TIMES * (1 + ROW_NUMBERS)};
    const struct motion m = {.scenario = s, .nonlinear = true, .most_pieces = pieces, .digits = 17};
    struct message why;
    for (int k = 0; k < TIMES; k++)
        fmpq_set_si(r.times + k, (slong)(seconds * k / (TIMES - 1)), 1);
    scenario_init(s, sheet(), true);
    for (; of->value != NULL; of++)
        give(s, of, true);
    ck_assert_msg(motion_rows(&m, r.times, TIMES, keep_bounds, &r, &why) == 0, "%s", why.text);
    return r;
}

/* One motion of the box: a corner, or something within. */
static void follow_one(struct seen *seen, const struct box *box, int motion)
{
    OWNED(scenario) s;
    struct flow_parameters *const p = &seen->parameters;
    VECTOR(arb, initial, FLOW_STATE);
    SCOPE(fmpq, share);
    scenario_init(&s, sheet(), true);
    for (int i = 0; box->of[i].value != NULL; i++) {
        const struct interval *of = &box->of[i];
        SCOPE(arf, x);
        give(&s, of, true);
        arf_set_d(x, motion < 2 * box->motions / 3 ? ((motion * 2654435761u >> (8 + i)) & 1) * 2.0 - 1 : number(8 * motion + i));
        arf_get_fmpq(share, x);
        fmpq_mul(share, share, s.radius + of->name);
        fmpq_add(&s.value[of->name].value, &s.value[of->name].value, share);
    }
    flow_parameters_init(p);
    scenario_parameters(p, &s, PREC);
    scenario_initial(initial, &s, p, true, PREC);
    ck_assert_int_eq(flow_run(&(struct flow_request){p, initial, seen->rows->times, TIMES, 14, PREC, look, seen, true, NULL, NULL, 0}), FLOW_DONE);
    flow_parameters_clear(p);
}

EACH(motions_from_all_of_a_box_keep_within_its_bounds, COUNT(boxes))
{
    const struct box *box = &boxes[_i];
    OWNED(scenario) s;
    OWNED(rows) rows = rows_of(&s, box->of, box->seconds, 8);
    struct seen seen = {.rows = &rows};
    for (int v = 0; v < ROW_NUMBERS; v++) {
        seen.low[v] = HUGE_VAL;
        seen.high[v] = -HUGE_VAL;
    }
    for (int motion = 0; motion < box->motions; motion++)
        follow_one(&seen, box, motion);
    ck_assert_int_eq(seen.count, TIMES * box->motions);
    for (int v = 0; v < ROW_NUMBERS; v += v == FLOW_HALF - 1 ? 1 + FLOW_HALF : 1) {
        const double width = fmpq_get_d(rows.high + ROW_NUMBERS * (TIMES - 1) + v) - fmpq_get_d(rows.low + ROW_NUMBERS * (TIMES - 1) + v);
        ck_assert_double_le(width, fmax(box->most * (seen.high[v] - seen.low[v]), box->motions == 1 ? 1e-8 : 0));
    }
}

/* A radius of k_c is the force's alone: all of it, 3, C1 and C2 alike, is f times what the law with the middle has commanded. */
TEST(a_factor_on_the_force_is_one_of_the_set)
{
    enum { R = JET_CHARGE, Q = JET_STATES - 1, HOLD = JET_ALL - 1, OWN };
    struct term terms[JET_TERMS];
    const struct system law = {JET_STATES, JET_SERIES, JET_ALL + 1, JET_TERMS, terms};
    static const struct interval factor[] = {{SET_k_c, "8.99e9", "8.99e7"}, {0}};
    OWNED(scenario) s;
    OWNED(rows) rows = rows_of(&s, factor, 20000, 1);
    struct seen seen = {.rows = &rows};
    VECTOR(arb, hold, 1);
    VECTOR(arb, initial, FLOW_STATE);
    const struct flow_steps how = {.system = &law, .constants = hold};
    for (int t = 0; t < JET_TERMS; t++) {
        terms[t] = closed_loop.terms[t];
        if (terms[t].to == R && terms[t].a == HOLD)
            terms[t].a = OWN;
    }
    flow_parameters_init(&seen.parameters);
    scenario_parameters(&seen.parameters, &s, PREC);
    scenario_initial(initial, &s, &seen.parameters, true, PREC);
    for (int percent = 99; percent <= 101; percent++) {
        FLOW_PARAMETERS(p);
        scenario_parameters(&p, &s, PREC);
        arb_ptr scaled[] = {p.C1, p.C2, hold};
        arb_set_ui(hold, 3);
        for (int i = 0; i < 3; i++) {
            arb_mul_ui(scaled[i], scaled[i], (ulong)percent, PREC);
            arb_div_ui(scaled[i], scaled[i], 100, PREC);
        }
        ck_assert_int_eq(flow_run(&(struct flow_request){&p, initial, rows.times, TIMES, 14, PREC, look, &seen, true, NULL, &how, 0}), FLOW_DONE);
    }
    ck_assert_int_eq(seen.count, 3 * TIMES);
    flow_parameters_clear(&seen.parameters);
}

static int stop_at_once(void *context, slong k, const fmpq_t t, char *const *numbers)
{
    (void)context;
    (void)t;
    (void)numbers;
    ck_assert_int_eq(k, 0);
    return 1;
}

/* What is 0 stays 0: neither its models nor their rests take up anything. And a receiver that has enough is no failure. */
TEST(a_set_in_the_orbit_plane_stays_there)
{
    static const struct interval plane[] = {{SET_x1, "5.05", "0.01"}, {SET_y1, "0.05", "0.01"},   {SET_z1, "0", "0"},
                                            {SET_x1_dot, "0", "0"},   {SET_y1_dot, "0", "1e-6"}, {SET_z1_dot, "0", "0"}, {0}};
    OWNED(scenario) s;
    OWNED(rows) rows = rows_of(&s, plane, 20000, 1);
    struct message why;
    const struct motion m = {.scenario = &s, .nonlinear = true, .most_pieces = 1, .digits = 17};
    for (int k = 0; k < TIMES; k++)
        for (int v = 2; v < FLOW_STATE; v += FLOW_HALF)
            ck_assert(fmpq_is_zero(rows.low + ROW_NUMBERS * k + v) && fmpq_is_zero(rows.high + ROW_NUMBERS * k + v));
    ck_assert_int_eq(motion_rows(&m, rows.times, TIMES, stop_at_once, NULL, &why), 0);
}

/* ---- one error term larger than all others ---- */

/*
 * In units of r_ref and radians: x = 1.0001 + w e_1, y = 0.0101 + w e_2, z = -0.0101, at rest; c1 = its middle + c e_3, c2 = 2. Or at
 * its equilibrium but for x = 1 + w, where w is no unknown but what the models are off: all of the set is then the rest B s. Models
 * of that degree, series to these orders in steps of that length; each motion, corners of the box among them, has to keep within.
 * Where c1 < 9 the pair leaves its rest, and what is left out of a step grows: long steps or many, so that it grows faster than
 * bounds have to spare.
 */
static const struct {
    const char *term;
    double c1, w, c;
    int degree;
    slong order, derivative_order;
    double step, until;
    int pieces;   /* that are enough, where one is not; 0: one will do */
    bool rests;
    bool charged;
    double vague; /* how far from 1 Omega may be: all rows' times are that vague */
    double off;   /* what the models of the coordinates are off */
} terms[] = {
    {"S1: models of degree 1", 10, 0.01, 0.1, 1, 0, 0, 0.0625, 0.6, 0, false, true, 0, 0},
    {"S2: series to degree 2", 10, 0, 0, 1, 2, 4, 0.03125, 0.5, 0, false, true, 0, 0},
    {"S2: series to degree 1", 10, 0, 0, 1, 1, 3, 0.0078125, 0.25, 0, false, true, 0, 0},
    {"S3: derivatives to degree 1, long steps", -90, 1e-9, 0, 1, 0, 1, 0.0625, 0.8, 0, true, true, 0, 0},
    {"S4, S6: derivatives over a wide rest", -90, 0.01, 0, 1, 0, 4, 0.001953125, 0.12, 0, true, false, 0, 0},
    {"S6: derivatives from all of P(e)", -90, 0.02, 0, 2, 0, 0, 0.0078125, 0.06, 0, false, false, 0, 3e-3},
    {"S5: derivatives for all parameters", -90, 8e-7, 20, 4, 0, 0, 0.0078125, 0.3, 0, true, true, 0, 0},
    {"S7: rows within a step, derivatives to degree 1", -90, 1e-6, 0, 1, 0, 1, 0.03125, 0.0625, 0, true, true, 0, 0},
    {"S7: backwards, for the charges' own tail", -90, 1e-6, 0, 1, 0, 1, 0.03125, -0.03125, 0, true, true, 0, 0},
    {"S7: rows within a step, derivatives to degree 3", -90, 1e-6, 0, 1, 0, 3, 0.03125, 0.1875, 0, true, true, 0, 0},
    {"S8: times that are not known well", 10, 0, 0, 1, 0, 0, 0.125, 0.9, 0, false, true, 0.01, 0},
    {"S8: z'' s^2/2 at times that are not known well", 10, 0, 0, 1, 2, 0, 0x1p-10, 0x1.8p-11, 0, false, false, 0.25, 0},
    {"all together, degree 2", 10, 0.02, 0.2, 2, 5, 3, 0.125, 1, 0, false, true, 0, 0},
    {"S9: a set that is split on its way, with all that it is off", -90, 1e-4, 0, 2, 0, 0, 0.0078125, 0.3, 2, false, false, 0, 1e-4},
    {"S9: a half that takes shorter steps", 10, 0.2, 0, 6, 0, 0, 0, 0.2, 2, false, false, 0, 0},
    {"S9: both halves of what was split", 10, 0.02, 0.3, 4, 0, 0, 0, 4, 64, false, false, 0, 0},
};

enum { WIDE_REST = 4 };

/* The middle of coordinate v of the start; and how far it may be from that, or c1 after them */
static double start_middle(int i, int v)
{
    static const double start[] = {1.0001, 0.0101, -0.0101};
    if (v == FLOW_HALF && terms[i].off > 0)
        return -0.5; /* so fast that what is of another time is elsewhere */
    return v >= FLOW_HALF ? 0 : terms[i].rests ? v == 0 : start[v];
}

static double start_width(int i, int v)
{
    return v == FLOW_STATE ? terms[i].c : v == 0 || (v == 1 && !terms[i].rests) ? terms[i].w : 0;
}

static void start_term(struct flow_set *set, int i)
{
    const double constants[] = {terms[i].c1, 2, 1, 3};
    int unknowns = 0;
    SCOPE(arb, x, radius);
    flow_set_init(set, terms[i].w > 0 ? 3 : 0, terms[i].degree);
    set->how = (struct flow_steps){.order = terms[i].order, .derivative_order = terms[i].derivative_order, .step = terms[i].step};
    for (int v = 0; v < SET_CHARGE; v++) {
        const double width = start_width(i, v);
        const bool rest = terms[i].rests && v < FLOW_STATE;
        arb_set_d(x, v < FLOW_STATE ? start_middle(i, v) : constants[v - FLOW_STATE]);
        arb_set_d(radius, width);
        mag_set_d(arb_radref(x), rest ? width : v < FLOW_STATE ? terms[i].off : 0);
        if (width > 0 && !rest)
            model_set_variable(&set->model[v], x, radius, unknowns++);
        else
            model_set_ball(&set->model[v], x);
    }
    arb_one(set->Omega);
    mag_set_d(arb_radref(set->Omega), terms[i].vague);
    arb_one(set->unit);
    set->charged = terms[i].charged;
    arb_one(x);
    model_set_ball(&set->model[SET_CHARGE], x);
    arb_one(set->charge);
}

struct bounds_at {
    arb_ptr rows; /* of the coordinates, and the charge product of sets that are charged */
    slong count;
    arb_srcptr c1; /* of the motion that is compared, if it is charged */
    const char *term;
};

static int keep_row(void *context, slong k, const fmpq_t t, arb_srcptr state)
{
    struct bounds_at *b = context;
    (void)t;
    ck_assert_int_eq(k, b->count++);
    _arb_vec_set(b->rows + SET_BOUNDS * k, state, SET_BOUNDS);
    return 0;
}

/* (7) with (18): Q_ref + dQ = -(3 + c1 (r - 1) + 2 r_dot), r_ref, Omega and m1 m2/(m1 + m2) 2/k_c being 1 */
static void charge_product(arb_t x, arb_srcptr state, const arb_t c1)
{
    SCOPE(arb, r, rate);
    arb_dot(r, NULL, 0, state, 1, state, 1, FLOW_HALF, PREC);
    arb_sqrt(r, r, PREC);
    arb_dot(rate, NULL, 0, state, 1, state + FLOW_HALF, 1, FLOW_HALF, PREC);
    arb_div(rate, rate, r, PREC);
    arb_sub_ui(r, r, 1, PREC);
    arb_mul(x, r, c1, PREC);
    arb_addmul_ui(x, rate, 2, PREC);
    arb_add_ui(x, x, 3, PREC);
    arb_neg(x, x);
}

static int compare(void *context, slong k, const fmpq_t t, arb_srcptr state)
{
    const struct bounds_at *b = context;
    (void)t;
    VECTOR(arb, row, SET_BOUNDS);
    _arb_vec_set(row, state, FLOW_STATE);
    if (b->c1 != NULL)
        charge_product(row + FLOW_STATE, state, b->c1);
    for (int v = 0; v < (b->c1 != NULL ? SET_BOUNDS : FLOW_STATE) && k < b->count; v++)
        ck_assert_msg(arb_overlaps(b->rows + SET_BOUNDS * k + v, row + v), "%s: row %d, coordinate %d", b->term, (int)k, v);
    return 0;
}

EACH(S1_to_S9_each_motion_keeps_within_its_set, COUNT(terms))
{
    enum { ROWS = 9, MOTIONS = 9 };
    OWNED(flow_set) set;
    FLOW_PARAMETERS(p);
    VECTOR(fmpq, times, ROWS);
    VECTOR(arb, rows, ROWS * SET_BOUNDS);
    VECTOR(arb, initial, FLOW_STATE);
    SCOPE(fmpq, latest);
    struct bounds_at b = {rows, 0, NULL, terms[_i].term};
    double reached;
    fmpq_set_si(latest, (slong)ldexp(1 + terms[_i].vague, 50), 1L << 50);
    fmpq_canonicalise(latest);
    for (int k = 0; k < ROWS; k++) {
        fmpq_set_si(times + k, (slong)(terms[_i].until * (1 << 20) * (k + 1)), ROWS << 20);
        fmpq_canonicalise(times + k);
    }
    start_term(&set, _i);
    if (terms[_i].pieces > 2)
        ck_assert_int_eq(flow_set(&set, times, ROWS, keep_row, &b, &reached), FLOW_WIDE);
    set.most_pieces = FLINT_MAX(terms[_i].pieces, 1);
    b.count = 0;
    (void)flow_set(&set, times, ROWS, keep_row, &b, &reached);
    ck_assert_msg(b.count == ROWS, "%s: %d rows, %g", terms[_i].term, (int)b.count, reached);
    b.c1 = terms[_i].charged ? p.C1 : NULL;
    arb_one(p.Omega);
    arb_set_ui(p.L_ref, 2);
    arb_set_ui(p.C2, 2);
    arb_one(p.k_c);
    arb_one(p.m1);
    arb_one(p.m2);
    for (int k = 0; k < ROWS; k++) /* the last that a row may mean */
        fmpq_mul(times + k, times + k, latest);
    for (int motion = 0; motion < MOTIONS; motion++) {
        arb_set_d(p.C1, terms[_i].c1);
        for (int v = 0, unknown = 0; v <= FLOW_STATE; v++) {
            const double width = start_width(_i, v);
            SCOPE(arb, off);
            arb_set_d(off, width * (motion < 8 ? ((motion >> unknown) & 1) * 2 - 1 : number(3 * motion + unknown)) +
                               (v < FLOW_STATE ? terms[_i].off * ((37 * motion >> v & 1) * 2 - 1) : 0));
            unknown += width > 0;
            if (v < FLOW_STATE)
                arb_set_d(initial + v, start_middle(_i, v));
            arb_ptr x = v < FLOW_STATE ? initial + v : p.C1;
            arb_add(x, x, off, PREC);
        }
        ck_assert_int_eq(flow_run(&(struct flow_request){&p, initial, times, ROWS, 18, PREC, compare, &b, true, NULL, NULL, 0}), FLOW_DONE);
    }
}

/*
 * Where a row is due at the start no step has been taken, and what the models are off is in it all the same: where no step is
 * proved, in the set's units, rounded outward, and where the set is split before it, either half with all of that. Each coordinate
 * is its middle + 2^-4 (v + 1) e +- 2^-5, so that one half has its upper end and the other its lower one; exact in no unit.
 */
EACH(S1_S9_a_row_at_the_start_has_what_the_models_are_off, 4)
{
    OWNED(flow_set) set;
    VECTOR(fmpq, times, 1);
    VECTOR(arb, row, SET_BOUNDS);
    SCOPE(arb, middle, radius, end);
    struct bounds_at b = {.rows = row};
    double reached;
    const bool exact = _i == 3;
    flow_set_init(&set, 1, 1);
    set.how = (struct flow_steps){.order = 3, .derivative_order = 2, .step = _i == 1 ? 1e6 : 0x1p-10};
    set.most_pieces = _i == 2 ? 2 : 1;
    for (int v = 0; v < SET_MODELS; v++) {
        arb_set_d(middle, v == 0 ? 1.5 : v < FLOW_STATE ? 0.25 * v : v);
        mag_set_d(arb_radref(middle), v < FLOW_STATE && !exact ? 0x1p-5 : 0);
        arb_set_d(radius, exact ? 0 : 0x1p-4 * (v + 1));
        if (v < FLOW_STATE && !exact)
            model_set_variable(&set.model[v], middle, radius, 0);
        else
            model_set_ball(&set.model[v], middle);
    }
    arb_set_ui(set.unit, 1);
    arb_div_ui(set.unit, set.unit, 3, PREC);
    arb_set_ui(set.Omega, 1);
    arb_div_ui(set.Omega, set.Omega, 7, PREC);
    ck_assert_int_eq(flow_set(&set, times, 1, keep_row, &b, &reached), FLOW_DONE);
    ck_assert_int_eq(b.count, 1);
    for (int v = 0; v < FLOW_STATE; v++)
        for (int side = -1; side <= 1; side++) {
            arb_set_d(end, (v == 0 ? 1.5 : 0.25 * v) + (exact ? 0 : side * (0x1p-4 * (v + 1) + 0x1p-5)));
            arb_div_ui(end, end, v < FLOW_HALF ? 3 : 21, PREC);
            ck_assert_msg(arb_contains(row + v, end), "coordinate %d, side %d", v, side);
        }
}

/* What is beyond binary64 is in no row, nor is it below zero. */
TEST(a_row_that_is_beyond_binary64_is_none)
{
    OWNED(flow_set) set;
    VECTOR(fmpq, times, 1);
    VECTOR(arb, row, SET_BOUNDS);
    SCOPE(arb, huge);
    struct bounds_at b = {.rows = row};
    double reached;
    start_term(&set, WIDE_REST);
    arb_one(huge);
    arb_mul_2exp_si(huge, huge, 1100);
    model_set_ball(&set.model[FLOW_STATE - 1], huge);
    ck_assert_int_eq(flow_set(&set, times, 1, keep_row, &b, &reached), FLOW_WIDE);
    ck_assert_int_eq(b.count, 0);
}

/* Of x = 1 + w e at rest the charge product is -(3 - 90 w e): below zero in all of the set where w < 1/30. */
EACH(a_set_ends_where_some_of_it_may_have_no_charges, 3)
{
    static const double widths[] = {0.02, 0.034, 0.02};
    OWNED(flow_set) set;
    VECTOR(fmpq, times, 1);
    VECTOR(arb, row, SET_BOUNDS);
    SCOPE(arb, x, radius);
    struct bounds_at b = {.rows = row};
    double reached;
    start_term(&set, WIDE_REST);
    ck_assert(terms[WIDE_REST].c1 == -90);
    arb_one(x);
    arb_set_d(radius, widths[_i]);
    model_set_variable(&set.model[0], x, radius, 0);
    for (int v = 1; v < FLOW_HALF; v++)
        model_set_ball(&set.model[v], row /* 0, by now */);
    set.charged = true;
    if (_i == 2) /* a product of 0 is none */
        model_set_ball(&set.model[SET_CHARGE], row);
    ck_assert_int_eq(flow_set(&set, times, 1, keep_row, &b, &reached), _i == 0 ? FLOW_DONE : FLOW_UNCHARGED);
    ck_assert_int_eq(b.count, _i == 0);
}

static int stop_at(void *context, slong k, const fmpq_t t, arb_srcptr state)
{
    (void)t;
    (void)state;
    ck_assert_int_le(k, *(slong *)context); /* and is not called again */
    return k == *(slong *)context;
}

/* Pieces are joined in any order; their number, and which are split, is settled between rounds alone. */
TEST(the_rows_of_a_set_are_the_same_whoever_follows_its_pieces)
{
    enum { ROWS = 9, MOST = 5 };
    OWNED(flow_set) set;
    VECTOR(fmpq, times, ROWS);
    VECTOR(arb, rows, ROWS * SET_BOUNDS);
    VECTOR(arb, others, ROWS * SET_BOUNDS);
    struct bounds_at alone = {.rows = rows}, together = {.rows = others};
    slong second = 1;
    double reached, reached_together;
    for (int k = 0; k < ROWS; k++)
        fmpq_set_si(times + k, k, 2);
    start_term(&set, COUNT(terms) - 1);
    set.most_pieces = 12; /* fewer than it takes: the last that may be split matter as well */
    set.threads = 1;
    const enum flow_status status = flow_set(&set, times, ROWS, keep_row, &alone, &reached);
    set.threads = MOST;
    ck_assert_int_eq(flow_set(&set, times, ROWS, keep_row, &together, &reached_together), status);
    ck_assert_double_eq(reached, reached_together);
    ck_assert_int_eq(together.count, alone.count);
    for (slong i = 0; i < alone.count * SET_BOUNDS; i++)
        ck_assert(arb_equal(rows + i, others + i));
    ck_assert_int_eq(flow_set(&set, times, ROWS, stop_at, &second, &reached), FLOW_STOPPED);
}

/* Two halves, of which the lower takes the shorter steps and is lost first */
TEST(a_set_is_proved_as_far_as_both_its_halves)
{
    double reached[3];
    SCOPE(fmpq, time);
    fmpq_set_si(time, 100, 1);
    for (int half = -1; half <= 1; half++) {
        OWNED(flow_set) set;
        start_term(&set, COUNT(terms) - 2);
        set.most_pieces = half == 0 ? 2 : 1;
        for (int v = 0; v < SET_MODELS && half != 0; v++)
            model_halve(&set.model[v], 0, half);
        ck_assert_int_eq(flow_set(&set, time, 1, NULL, NULL, &reached[1 + half]), FLOW_WIDE);
    }
    ck_assert_msg(reached[1] <= reached[0] && reached[0] < reached[2], "%g of %g and %g", reached[1], reached[0], reached[2]);
}

/* 2^-16 radians a step, of series that cost little, are too short for a radian. */
TEST(a_set_that_takes_too_many_steps_is_given_up)
{
    OWNED(flow_set) set;
    SCOPE(fmpq, time);
    double reached;
    fmpq_one(time);
    start_term(&set, 1);
    set.how = (struct flow_steps){.order = 2, .derivative_order = 1, .step = 0x1p-16};
    set.threads = 1;
    ck_assert_int_eq(flow_set(&set, time, 1, NULL, NULL, &reached), FLOW_STALLED);
    ck_assert(reached > 0.125 && reached < 0.25); /* of 10,000 steps */
}
