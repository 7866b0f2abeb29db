/*
 * What tests/bench/bench.py times of the program's own: one measurement a run, its numbers in one line.
 *
 *     bench flow DIGITS DAYS      seconds with proofs, log10 of the largest radius over L_ref at the end
 *     bench unproved DIGITS DAYS  the same without proofs
 *     bench scalar DIGITS COUNT   seconds for one certified eq07
 *     bench roots DIGITS COUNT    seconds for one certified set of roots of (41), n = 10
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "text/decimal.h"
#include "motion/flow.h"
#include "motion/motion.h"
#include "evaluate/operation.h"
#include "proof/roots.h"
#include "tests/paper.h"

/* Processor time: other work on the machine does not count. */
static double seconds(void)
{
    struct timespec t;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* ---- the nonlinear motion of the simulation ---- */

static void table_value(arb_t x, const char *name, slong prec)
{
    fmpq_t q;
    fmpq_init(q);
    literal_read(q, quantity_find(sheet(), name)->value, true);
    arb_set_fmpq(x, q, prec);
    fmpq_clear(q);
}

static void simulation(struct flow_parameters *p, arb_ptr start, slong prec)
{
    static const char *const names[] = {"m1", "m2", "L_ref", "psi", "theta"};
    arb_ptr in = _arb_vec_init(5);
    arb_t dL;
    arb_init(dL);
    table_value(p->Omega, "Omega", prec);
    table_value(p->L_ref, "L_ref", prec);
    table_value(p->k_c, "k_c", prec);
    table_value(p->m1, "m1", prec);
    table_value(p->m2, "m2", prec);
    arb_mul_2exp_si(p->C2, p->Omega, 1); /* n = 10 */
    arb_sqr(p->C1, p->Omega, prec);
    arb_mul_ui(p->C1, p->C1, 10, prec);
    for (int i = 0; i < 5; i++)
        table_value(in + i, names[i], prec);
    table_value(dL, "dL", prec);
    arb_add(in + 2, in + 2, dL, prec);
    section_enclose(section_find(sheet(), "eq10"), in, prec, start);
    _arb_vec_clear(in, 5);
    arb_clear(dL);
}

static int keep(void *context, slong k, const fmpq_t t, arb_srcptr state)
{
    (void)k;
    (void)t;
    _arb_vec_set(context, state, FLOW_STATE);
    return 0;
}

/* flow_precision() also pays for digits of coordinates far smaller than L_ref; here digits are those of L_ref. */
enum { NOT_NEEDED = 28 };

typedef enum flow_status flow_function(const struct flow_parameters *p, arb_srcptr initial, const fmpq *times,
                                       slong count, slong digits, slong prec, flow_receiver *receive,
                                       void *context, double *reached);

static void bench_flow(flow_function *flow, long digits, double days)
{
    const double Omega = 7.2915e-5; /* Table 1 */
    const slong prec = flow_precision(digits, Omega * 86400 * days) - NOT_NEEDED;
    struct flow_parameters p;
    arb_ptr state = _arb_vec_init(FLOW_STATE);
    fmpq *t = _fmpq_vec_init(1);
    double reached, radius = -HUGE_VAL; /* log2 of m, and of m/s in units of Omega */
    flow_parameters_init(&p);
    simulation(&p, state, prec);
    fmpq_set_si(t, (slong)(86400 * days), 1);
    double start = seconds();
    enum flow_status status = flow(&p, state, t, 1, digits, prec, keep, state, &reached);
    double taken = seconds() - start;
    for (int i = 0; i < FLOW_STATE; i++)
        radius = fmax(radius, mag_get_d_log2_approx(arb_radref(state + i)) - (i < 3 ? 0 : log2(Omega)));
    if (status == FLOW_DONE)
        printf("%.9f %.3f\n", taken, radius * log10(2) - 1); /* L_ref = 10 m */
    else
        fprintf(stderr, "bench: %s\n", flow_status_text(status));
    _arb_vec_clear(state, FLOW_STATE);
    _fmpq_vec_clear(t, 1);
    flow_parameters_clear(&p);
}

/* ---- a formula, and the roots ---- */

/* From binary64 inputs to an enclosure of so many digits. */
static void bench_scalar(long digits, long count)
{
    static const double values[] = {7.2915e-5, 8.99e9, 150, 150, 10}; /* Omega k_c m1 m2 L */
    const slong prec = (slong)(digits * log2(10)) + 16;
    struct operation o;
    struct input *inputs = inputs_new(5);
    arb_t Q_ref;
    arf_t x;
    arb_init(Q_ref);
    arf_init(x);
    operation_init(&o, section_find(sheet(), "eq07"), false);
    double start = seconds();
    for (long k = 0; k < count; k++) {
        for (int i = 0; i < 5; i++) {
            arf_set_d(x, values[i]);
            arf_get_fmpq(&inputs[i].value, x);
        }
        operation_enclose(&o, inputs, prec, Q_ref);
    }
    double taken = (seconds() - start) / (double)count;
    if (arb_rel_accuracy_bits(Q_ref) < (slong)(digits * log2(10)))
        taken = NAN;
    printf("%.12f\n", taken);
    operation_clear(&o);
    inputs_free(inputs, 5);
    arb_clear(Q_ref);
    arf_clear(x);
}

static void bench_roots(long digits, long count)
{
    const slong prec = (slong)(digits * log2(10)) + 1;
    acb_ptr roots = _acb_vec_init(4);
    fmpq_t Omega, C1, C2;
    fmpq_init(Omega);
    fmpq_init(C1);
    fmpq_init(C2);
    fmpq_set_si(Omega, 1, 1);
    fmpq_set_si(C1, 10, 1);
    fmpq_set_si(C2, 2, 1);
    bool found = true;
    double start = seconds();
    for (long k = 0; k < count; k++)
        found = roots41(roots, Omega, C1, C2, prec) && found;
    printf("%.12f\n", found ? (seconds() - start) / (double)count : NAN);
    _acb_vec_clear(roots, 4);
    fmpq_clear(Omega);
    fmpq_clear(C1);
    fmpq_clear(C2);
}

static enum flow_status unproved(const struct flow_parameters *p, arb_srcptr initial, const fmpq *times, slong count,
                                 slong digits, slong prec, flow_receiver *receive, void *context, double *reached)
{
    static const struct flow_steps how = {.unproved = true};
    return flow_nonlinear_by(&how, p, initial, times, count, digits, prec, receive, context, reached);
}

int main(int count, char **arguments)
{
    const char *what = count == 4 ? arguments[1] : "";
    if (strcmp(what, "flow") == 0 || strcmp(what, "unproved") == 0) {
        bench_flow(*what == 'f' ? flow_nonlinear : unproved, strtol(arguments[2], NULL, 10),
                   strtod(arguments[3], NULL));
    } else if (strcmp(what, "scalar") == 0) {
        bench_scalar(strtol(arguments[2], NULL, 10), strtol(arguments[3], NULL, 10));
    } else if (strcmp(what, "roots") == 0) {
        bench_roots(strtol(arguments[2], NULL, 10), strtol(arguments[3], NULL, 10));
    } else {
        fprintf(stderr, "bench: expected flow or unproved DIGITS DAYS, scalar DIGITS COUNT or roots DIGITS COUNT\n");
        return 2;
    }
    flint_cleanup();
    return fflush(stdout) == 0 ? 0 : 1;
}
