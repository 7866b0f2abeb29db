/*
 * What tests/bench/bench.py times of the program's own: one measurement a run, its numbers in one line.
 *
 *     bench flow DIGITS DAYS      seconds with proofs, log10 of the largest radius over L_ref at the end
 *     bench unproved DIGITS DAYS  the same without proofs
 *     bench square PREC DAYS      seconds of the pair in the inverse-square field, certified
 *     bench picard PREC DAYS      the same by Picard's iteration, not certified
 *     bench set CM PERCENT MOTIONS  seconds of the paper's start +- CM and C1 +- PERCENT over 3 days, and its bounds' widths over
 *                                 those that so many motions fill, the largest
 *     bench scalar DIGITS COUNT   seconds for one certified eq07
 *     bench roots DIGITS COUNT    seconds for one certified set of roots of (41), n = 10
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "text/decimal.h"
#include "motion/expansion.h"
#include "motion/flow.h"
#include "motion/motion.h"
#include "motion/two_body.h"
#include "evaluate/sample.h"
#include "evaluate/operation.h"
#include "proof/roots.h"
#include "text/scope.h"
#include "tests/paper.h"

/* Processor time: other work on the machine does not count. */
static double seconds(void)
{
    struct timespec t;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* ---- the nonlinear motion of the simulation ---- */

static int keep(void *context, slong k, const fmpq_t t, arb_srcptr state)
{
    (void)k;
    (void)t;
    _arb_vec_set(context, state, FLOW_STATE);
    return 0;
}

/* flow_precision() also pays for digits of coordinates far smaller than L_ref; here digits are those of L_ref. */
enum { NOT_NEEDED = 28 };

typedef enum flow_status flow_function(struct flow_request *r);

/* The same steps from a point, without what they leave out */
static enum flow_status unproved(struct flow_request *r)
{
    const slong prec = r->prec, bits = prec - 12, order = (slong)(0.5 * log(2) * (double)bits) + 4;
    const double end = 7.2915e-5 * fmpq_get_d(r->times);
    OWNED(expansion) e;
    SCOPE(arb, c1, c2, h, unit);
    VECTOR(arb, state, FLOW_STATE);
    expansion_init(&e, &closed_loop, order, 1, NULL, NULL);
    flow_gains(c1, c2, r->p, prec);
    jet_constants(&e.path, c1, c2);
    arb_mul_2exp_si(unit, r->p->L_ref, -1); /* equal masses, at rest */
    _arb_vec_scalar_div(state, r->initial, FLOW_STATE, unit, prec);
    while (r->reached < end) {
        for (int i = 0; i < FLOW_STATE; i++)
            arb_get_mid_arb(e.path.c[i], state + i);
        expansion_path(&e, prec, (double)bits / (double)order);
        const double step = fmin(expansion_step(&e, expansion_position(&e, 0) - (double)bits, 1), end - r->reached);
        arb_set_d(h, step);
        for (int i = 0; i < FLOW_STATE; i++)
            _arb_poly_evaluate(state + i, e.path.c[i], order + 1, h, prec);
        r->reached += step;
    }
    r->receive(r->context, r->count - 1, r->times, state);
    return FLOW_DONE;
}

static void bench_flow(flow_function *flow, long digits, double days)
{
    const double Omega = 7.2915e-5; /* Table 1 */
    const slong prec = flow_precision(digits, Omega * 86400 * days) - NOT_NEEDED;
    OWNED(scenario) s;
    FLOW_PARAMETERS(p);
    VECTOR(arb, state, FLOW_STATE);
    SCOPE(fmpq, t);
    double radius = -HUGE_VAL; /* log2 of m, and of m/s in units of Omega */
    scenario_init(&s, sheet(), true);
    scenario_parameters(&p, &s, prec);
    scenario_initial(state, &s, &p, true, prec);
    fmpq_set_si(t, (slong)(86400 * days), 1);
    double start = seconds();
    enum flow_status status = flow(&(struct flow_request){&p, state, t, 1, digits, prec, keep, state, true, NULL, NULL, 0});
    double taken = seconds() - start;
    for (int i = 0; i < FLOW_STATE; i++)
        radius = fmax(radius, mag_get_d_log2_approx(arb_radref(state + i)) - (i < 3 ? 0 : log2(Omega)));
    if (status == FLOW_DONE)
        printf("%.9f %.3f\n", taken, radius * log10(2) - 1); /* L_ref = 10 m */
    else
        fprintf(stderr, "bench: %s\n", flow_status_text(status));
}

/* ---- the pair in the inverse-square field ---- */

enum { SERIES = CRAFT * AXES, PICARD_ORDER = 28 }; /* the last term falls to 1e-28 */

static const double PICARD_STEP = 0.2; /* radians */

struct picard {
    arb_poly_struct place[SERIES], velocity[SERIES], acceleration[SERIES];
};

/* a.b */
static void scalar_product(arb_poly_t z, const arb_poly_struct *a, const arb_poly_struct *b, slong n, slong prec)
{
    SCOPE(arb_poly, term);
    arb_poly_zero(z);
    for (int i = 0; i < AXES; i++) {
        arb_poly_mullow(term, a + i, b + i, n, prec);
        arb_poly_add(z, z, term, prec);
    }
}

/*
 * R = e_x/s + r, s the smallness: r_ddot = -R/|s R|^3 + (R - R_z) + twice Coriolis. With g = |s R|^-3 that is
 * x (1 - g) + (1 - g)/s + 2 y_dot, y (1 - g) - 2 x_dot, -z g.
 */
static void attract(struct picard *t, int craft, const arb_t s, slong n, slong prec)
{
    arb_poly_struct *r = t->place + AXES * craft, *v = t->velocity + AXES * craft, *a = t->acceleration + AXES * craft;
    SCOPE(arb_poly, g, h);
    SCOPE(arb, power);
    scalar_product(g, r, r, n, prec); /* |s R|^2 = 1 + 2 s x + s^2 r.r */
    arb_poly_scalar_mul(g, g, s, prec);
    arb_poly_scalar_mul_2exp_si(h, r, 1);
    arb_poly_add(g, g, h, prec);
    arb_poly_scalar_mul(g, g, s, prec);
    arb_poly_add_si(g, g, 1, prec);
    arb_set_d(power, -1.5);
    arb_poly_pow_arb_series(g, g, power, n, prec);

    arb_poly_mullow(a + 2, r + 2, g, n, prec);
    arb_poly_neg(a + 2, a + 2);
    arb_poly_add_si(g, g, -1, prec);
    arb_poly_neg(g, g);
    arb_poly_scalar_div(h, g, s, prec);
    arb_poly_mullow(a, r, g, n, prec);
    arb_poly_add(a, a, h, prec);
    arb_poly_mullow(a + 1, r + 1, g, n, prec);
    arb_poly_scalar_mul_2exp_si(h, v + 1, 1);
    arb_poly_add(a, a, h, prec);
    arb_poly_scalar_mul_2exp_si(h, v, 1);
    arb_poly_sub(a + 1, a + 1, h, prec);
}

/* Along the line d from craft 2 to craft 1: d (3 + c1 (L - 1) + c2 L_dot)/L^3, in shares of the other's mass. */
static void pull(struct picard *t, const struct two_body *b, slong n, slong prec)
{
    arb_poly_struct d[AXES], d_dot[AXES];
    SCOPE(arb_poly, L, f, h);
    for (int i = 0; i < AXES; i++) {
        arb_poly_init(d + i);
        arb_poly_init(d_dot + i);
        arb_poly_sub(d + i, t->place + i, t->place + AXES + i, prec);
        arb_poly_sub(d_dot + i, t->velocity + i, t->velocity + AXES + i, prec);
    }
    scalar_product(L, d, d, n, prec);
    arb_poly_sqrt_series(L, L, n, prec);
    scalar_product(f, d, d_dot, n, prec);
    arb_poly_div_series(f, f, L, n, prec);
    arb_poly_scalar_mul(f, f, b->c2, prec);
    arb_poly_add_si(h, L, -1, prec);
    arb_poly_scalar_mul(h, h, b->c1, prec);
    arb_poly_add(f, f, h, prec);
    arb_poly_add_si(f, f, 3, prec);
    arb_poly_pow_ui_trunc_binexp(h, L, 3, n, prec);
    arb_poly_div_series(f, f, h, n, prec);
    for (int i = 0; i < AXES; i++) {
        arb_poly_mullow(h, d + i, f, n, prec);
        arb_poly_scalar_mul(d + i, h, b->mass + 1, prec);
        arb_poly_sub(t->acceleration + i, t->acceleration + i, d + i, prec);
        arb_poly_scalar_mul(d + i, h, b->mass, prec);
        arb_poly_add(t->acceleration + AXES + i, t->acceleration + AXES + i, d + i, prec);
        arb_poly_clear(d + i);
        arb_poly_clear(d_dot + i);
    }
}

/* Picard's iteration: each pass makes one more coefficient right. */
static void expand(struct picard *t, const struct two_body *b, slong prec)
{
    for (slong n = 1; n <= PICARD_ORDER; n++) {
        for (int craft = 0; craft < CRAFT; craft++)
            attract(t, craft, b->smallness, n, prec);
        pull(t, b, n, prec);
        for (int i = 0; i < SERIES; i++) {
            arb_poly_integral(t->place + i, t->velocity + i, prec);
            arb_poly_set_coeff_arb(t->place + i, 0, b->place + i);
            arb_poly_integral(t->velocity + i, t->acceleration + i, prec);
            arb_poly_set_coeff_arb(t->velocity + i, 0, b->velocity + i);
        }
    }
}

/* The sum at h, and its last term as the error. */
static void sum_terms(arb_t z, const arb_poly_t f, const arb_t h, slong prec)
{
    SCOPE(arb, last, power);
    arb_poly_evaluate(z, f, h, prec);
    arb_poly_get_coeff_arb(last, f, PICARD_ORDER);
    arb_pow_ui(power, h, PICARD_ORDER, prec);
    arb_mul(last, last, power, prec);
    arb_add_error(z, last);
}

/* two_body_move by Picard's iteration, with no proof of what it leaves out */
static void picard_move(struct two_body *b, const arb_t tau, slong prec)
{
    const slong steps = (slong)ceil(arf_get_d(arb_midref(tau), ARF_RND_UP) / PICARD_STEP);
    struct picard t;
    SCOPE(arb, h);
    arb_div_si(h, tau, steps, prec);
    for (slong k = 0; k < steps; k++) {
        for (int i = 0; i < SERIES; i++) {
            arb_poly_init(t.place + i);
            arb_poly_init(t.velocity + i);
            arb_poly_init(t.acceleration + i);
            arb_poly_set_coeff_arb(t.place + i, 0, b->place + i);
            arb_poly_set_coeff_arb(t.velocity + i, 0, b->velocity + i);
        }
        expand(&t, b, prec);
        for (int i = 0; i < SERIES; i++) {
            sum_terms(b->place + i, t.place + i, h, prec);
            sum_terms(b->velocity + i, t.velocity + i, h, prec);
            arb_poly_clear(t.place + i);
            arb_poly_clear(t.velocity + i);
            arb_poly_clear(t.acceleration + i);
        }
    }
}

/* Half a day from the paper's attitude at rest, L_ref/R_c = 10^-4 */
static void bench_inverse_square(bool certified, long prec, double days)
{
    OWNED(two_body) b;
    SCOPE(arb, tau);
    two_body_init(&b);
    arb_set_d(b.smallness, 1e-4);
    arb_set_ui(b.c1, 10);
    arb_set_ui(b.c2, 2);
    for (int i = 0; i < CRAFT; i++) {
        arb_set_d(b.mass + i, 0.5);
        arb_set_d(b.place + AXES * i, i ? -0.505 : 0.505);
        arb_set_d(b.place + AXES * i + 1, i ? -0.00505 : 0.00505);
        arb_set_d(b.place + AXES * i + 2, i ? 0.00505 : -0.00505);
    }
    arb_set_d(tau, 7.2915e-5 * 86400 * days);
    double start = seconds();
    bool proved = true;
    if (certified)
        proved = two_body_move(&b, tau, prec);
    else
        picard_move(&b, tau, prec);
    printf("%.9f\n", proved ? seconds() - start : NAN);
}

/* ---- sets of motions ---- */

/* Bounds of the last row, and what motions from the box fill of it */
struct filled {
    double low[FLOW_STATE], high[FLOW_STATE];
};

static int keep_set(void *context, slong k, const fmpq_t t, char *const *numbers)
{
    struct filled *f = context;
    (void)k;
    (void)t;
    for (int v = 0; v < FLOW_STATE; v++) {
        f->low[v] = strtod(numbers[2 * v], NULL);
        f->high[v] = strtod(numbers[2 * v + 1], NULL);
    }
    return 0;
}

/* The paper's start +- cm and a ten-thousandth of it a second, C1 +- percent: seconds, and the widest bound over what is filled. */
static void bench_set(double cm, double percent, long motions)
{
    static const double start[] = {5.05, 0.0505, -0.0505, 0, 0, 0};
    OWNED(scenario) s;
    struct message why;
    struct filled bounds, filled;
    double factor = 0;
    SCOPE(fmpq, t);
    VECTOR(arb, state, FLOW_STATE);
    fmpq_set_si(t, 259200, 1);
    scenario_init(&s, sheet(), true);
    for (int v = 0; v < FLOW_STATE; v++) {
        s.given[SET_x1 + v] = true;
        fmpq_set_double(&s.value[SET_x1 + v].value, start[v]);
        fmpq_set_double(s.radius + SET_x1 + v, cm * (v < 3 ? 1e-2 : 1e-6));
        filled.low[v] = HUGE_VAL;
        filled.high[v] = -HUGE_VAL;
    }
    const double C1 = 10 * 7.2915e-5 * 7.2915e-5;
    if (percent > 0) {
        s.given[SET_C1] = true;
        fmpq_set_double(&s.value[SET_C1].value, C1);
        fmpq_set_double(s.radius + SET_C1, C1 * percent / 100);
    }
    const double begin = seconds();
    const struct motion m = {.scenario = &s, .nonlinear = true, .most_pieces = 256, .digits = 17};
    const int failed = motion_rows(&m, t, 1, keep_set, &bounds, &why);
    const double taken = seconds() - begin;
    for (long k = 0; k < motions && !failed; k++) {
        FLOW_PARAMETERS(p);
        scenario_parameters(&p, &s, 128);
        for (int v = 0; v <= FLOW_STATE; v++) { /* the corners, then anywhere */
            const double share = k < 128 ? (double)((k >> v) & 1) * 2 - 1 : 2 * fmod((double)(7 * k + v) * 0.6180339887498949, 1) - 1;
            if (v < FLOW_STATE)
                arb_set_d(state + v, start[v] + share * cm * (v < 3 ? 1e-2 : 1e-6));
            else if (percent > 0)
                arb_set_d(p.C1, C1 * (1 + share * percent / 100));
        }
        if (flow_run(&(struct flow_request){&p, state, t, 1, 8, 80, keep, state, true, NULL, NULL, 0}) != FLOW_DONE)
            factor = NAN;
        for (int v = 0; v < FLOW_STATE; v++) {
            const double x = arf_get_d(arb_midref(state + v), ARF_RND_NEAR);
            filled.low[v] = fmin(filled.low[v], x);
            filled.high[v] = fmax(filled.high[v], x);
        }
    }
    for (int v = 0; v < FLOW_STATE && motions > 0; v++)
        factor = fmax(factor, (bounds.high[v] - bounds.low[v]) / (filled.high[v] - filled.low[v]));
    if (failed)
        fprintf(stderr, "bench: %s\n", why.text);
    else
        printf("%.9f %.3f\n", taken, factor);
}

/* ---- a formula, and the roots ---- */

/* From binary64 inputs to an enclosure of so many digits. */
static void bench_scalar(long digits, long count)
{
    static const double values[] = {7.2915e-5, 8.99e9, 150, 150, 10}; /* Omega k_c m1 m2 L */
    const slong prec = (slong)(digits * log2(10)) + 16;
    OWNED(operation) o;
    INPUTS(inputs);
    SCOPE(arb, Q_ref);
    operation_init(&o, section_find(sheet(), "eq07"), false);
    double start = seconds();
    for (long k = 0; k < count; k++) {
        for (int i = 0; i < 5; i++)
            fmpq_set_double(&inputs[i].value, values[i]);
        operation_enclose(&o, inputs, prec, Q_ref);
    }
    double taken = (seconds() - start) / (double)count;
    if (arb_rel_accuracy_bits(Q_ref) < (slong)(digits * log2(10)))
        taken = NAN;
    printf("%.12f\n", taken);
}

static void bench_roots(long digits, long count)
{
    const slong prec = (slong)(digits * log2(10)) + 1;
    VECTOR(acb, roots, 4);
    SCOPE(fmpq, Omega, C1, C2);
    fmpq_set_si(Omega, 1, 1);
    fmpq_set_si(C1, 10, 1);
    fmpq_set_si(C2, 2, 1);
    bool found = true;
    double start = seconds();
    for (long k = 0; k < count; k++)
        found = roots41(roots, Omega, C1, C2, prec) && found;
    printf("%.12f\n", found ? (seconds() - start) / (double)count : NAN);
}

int main(int count, char **arguments)
{
    const char *what = count == 4 ? arguments[1] : "";
    if (strcmp(what, "flow") == 0 || strcmp(what, "unproved") == 0) {
        bench_flow(*what == 'f' ? flow_nonlinear : unproved, strtol(arguments[2], NULL, 10),
                   strtod(arguments[3], NULL));
    } else if (strcmp(what, "square") == 0 || strcmp(what, "picard") == 0) {
        bench_inverse_square(*what == 's', strtol(arguments[2], NULL, 10), strtod(arguments[3], NULL));
    } else if (count == 5 && strcmp(arguments[1], "set") == 0) {
        bench_set(strtod(arguments[2], NULL), strtod(arguments[3], NULL), strtol(arguments[4], NULL, 10));
    } else if (strcmp(what, "scalar") == 0) {
        bench_scalar(strtol(arguments[2], NULL, 10), strtol(arguments[3], NULL, 10));
    } else if (strcmp(what, "roots") == 0) {
        bench_roots(strtol(arguments[2], NULL, 10), strtol(arguments[3], NULL, 10));
    } else {
        fprintf(stderr, "bench: expected flow or unproved DIGITS DAYS, square or picard PREC DAYS, scalar DIGITS COUNT or roots DIGITS COUNT\n");
        return 2;
    }
    flint_cleanup();
    return fflush(stdout) == 0 ? 0 : 1;
}
