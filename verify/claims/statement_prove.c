/*
 * Whether an assertion is true: by identities, enclosures, Sturm's chains, matrices, steps and computations.
 *
 * Theorem. What is found true is so, and what is found false is not, for all values of the balls that names have. Its terms, tested by
 * the rows of tests/claims/test_statement.c that name them, and by those of narrow_root (curve.c):
 *   (I1) a sign is that of the exact number, or of a ball without 0                                (sign_at)
 *   (I2) between bounds it is the same on parts that leave nothing out, the bounds' radii included (sign_between)
 *   (I3) a root is the only one: all other parts have a sign, its own a slope; bounds as before (roots_between, curve.c)
 *   (I4) a count is of different roots above low, by Sturm's chain of the square-free part         (roots_beyond)
 *   (I5) a rank is that of all rates by all states, and by the control                             (rank_found)
 *   (I6) of several values, conditions, citations each has to be so                                (truth_both)
 */
#include <stdlib.h>
#include <string.h>

#include "claims/curve.h"
#include "claims/statement.h"
#include "formula/symbolic.h"
#include "text/scope.h"

enum { PROVING_BITS = 128, MOST_PROVING_BITS = 1024, DEEPEST_BISECTION = 16, ROOTS = 10 };
enum { EVALUATIONS = 20000 };

static struct bindings bindings_of(struct statements *all, struct statement *s, struct assertion *a)
{
    return (struct bindings){.all = all, .statement = s, .at = &a->at, .at_count = a->at.count, .bits = PROVING_BITS, .how = &a->how};
}

/* ---- a formula of one unknown ---- */

/* A formula at work, all but the unknown bound. */
struct graph {
    struct program program;
    struct machine machine;
    struct curve curve;
};

static void graph_init(struct graph *g, const struct formula *f, const char *variable, const struct bindings *b)
{
    struct bindings moving = *b;
    program_copy(&g->program, f->program);
    g->curve = (struct curve){&g->machine, program_find(&g->program, variable), f->node, -1};
    g->curve.slope = program_slope(&g->program, f->node, g->curve.x);
    moving.moving = variable;
    machine_init(&g->machine, &g->program, &arithmetic_ball, b->bits);
    machine_bind(&g->machine, f->node, true, &moving); /* the slope needs nothing more */
}

/* The bounds between which an unknown moves; false: none, or reversed. */
static bool bounds_enclose(arb_t low, arb_t high, const struct assertion *a, const struct bindings *b)
{
    formula_enclose(low, &a->low, b);
    formula_enclose(high, &a->high, b);
    return arb_le(low, high);
}

static void graph_clear(struct graph *g)
{
    machine_clear(&g->machine);
    program_clear(&g->program);
}

/* The same certain sign everywhere between. */
static bool sign_between(struct curve *c, const arb_t low, const arb_t high, int sign, int depth)
{
    SCOPE(arb, x, middle);
    arb_union(x, low, high, PROVING_BITS);
    if (sign_of_ball(curve_at(c, x)) == sign)
        return true;
    arb_get_mid_arb(middle, x);
    return depth > 0 && sign_between(c, low, middle, sign, depth - 1) && sign_between(c, middle, high, sign, depth - 1);
}

/* ---- roots ---- */

/* The coefficients of a polynomial in one unknown whose other names have exact values; false: the formula is none. */
static bool polynomial_of(fmpq_poly_t f, const struct formula *formula, const char *variable, const struct bindings *at)
{
    struct bindings b = *at;
    struct machine m;
    b.moving = variable;
    symbolic_begin(1, 0);
    machine_init(&m, formula->program, &arithmetic_symbolic, 1);
    bool known = machine_bind(&m, formula->node, false, &b);
    if (known) {
        symbolic_set_variable(machine_value(&m, program_find(formula->program, variable)), 0, 0, NULL);
        machine_run_to(&m, formula->node);
        known = symbolic_get_polynomial(f, machine_value(&m, formula->node));
    }
    machine_clear(&m);
    symbolic_end();
    return known;
}

slong root_enclose(arb_t z, struct assertion *a, const struct bindings *of, slong bits)
{
    struct bindings b = bindings_of(of->all, of->statement, a);
    struct graph g;
    SCOPE(fmpq_poly, f);
    SCOPE(arb, low, high, one);
    b.how = of->how;
    const bool bounded = bounds_enclose(low, high, a, &b);
    b.bits = 2 * bits;
    graph_init(&g, &a->formula, a->variable, &b);
    const slong count = bounded ? roots_between(one, curve_series, &g.curve, low, high, ROOTS, EVALUATIONS, PROVING_BITS) : -1;
    arb_indeterminate(z);
    if (count == 1) {
        narrow_root(one, curve_series, &g.curve, 2 * bits);
        arb_set(z, one);
    }
    if (!polynomial_of(f, &a->formula, a->variable, &b))
        weaken(&b, CERTIFIED);
    graph_clear(&g);
    return count;
}

/* ---- signs ---- */

/* Whether a bound is zero, within ten of what it bounds, which is z more, or next to nothing where that may be 0. */
static bool is_tight(const struct assertion *a, const struct bindings *b, const arb_t z)
{
    struct formula right = a->formula;
    SCOPE(arb, bound, left, ten);
    right.node = a->right;
    formula_enclose(bound, &right, b);
    arb_add(left, bound, z, b->bits);
    if (arb_contains_zero(left) || arb_is_zero(bound))
        return arf_cmpabs_2exp_si(arb_midref(bound), -60) < 0;
    arb_div(left, left, bound, b->bits);
    arb_abs(left, left);
    arb_set_ui(ten, 10);
    arb_inv(bound, left, b->bits);
    return arb_le(left, ten) && arb_le(bound, ten);
}

static enum truth sign_at(struct assertion *a, const struct bindings *at)
{
    struct bindings b = *at;
    SCOPE(fmpq, q);
    SCOPE(arb, z);
    const bool rational = formula_rational(q, &a->formula, &b);
    arb_set_fmpq(z, q, PROVING_BITS);
    for (b.bits = PROVING_BITS; !rational && sign_of_ball(z) == 0 && b.bits <= MOST_PROVING_BITS; b.bits *= 2) {
        formula_enclose(z, &a->formula, &b);
        weaken(&b, CERTIFIED);
    }
    const int sign = sign_of_ball(z);
    if (sign == 0 && !rational)
        return UNDECIDED;
    a->loose = a->loose && !is_tight(a, &b, z);
    return sign == a->sign ? FOUND_TRUE : FOUND_FALSE;
}

/* Above or below zero between two bounds. */
static enum truth sign_on(const struct assertion *a, const struct bindings *b)
{
    const int sign = a->sign;
    enum truth truth = UNDECIDED;
    struct graph g;
    SCOPE(arb, low, high);
    const bool bounded = bounds_enclose(low, high, a, b);
    graph_init(&g, &a->formula, a->variable, b);
    if (bounded) {
        if (sign_of_ball(curve_at(&g.curve, low)) == -sign || sign_of_ball(curve_at(&g.curve, high)) == -sign)
            truth = FOUND_FALSE;
        else if (sign_between(&g.curve, low, high, sign, DEEPEST_BISECTION))
            truth = FOUND_TRUE;
    }
    weaken(b, CERTIFIED);
    graph_clear(&g);
    return truth;
}

/* ---- polynomials and matrices ---- */

/* How many different roots a polynomial, not zero, has beyond a point. */
static slong roots_beyond(const fmpq_poly_t f, const fmpq_t point)
{
    slong negative, positive = 0;
    SCOPE(fmpq_poly, g, h);
    SCOPE(fmpz_poly, simple);
    fmpq_poly_set_coeff_fmpq(h, 0, point);
    fmpq_poly_set_coeff_si(h, 1, 1);
    fmpq_poly_compose(g, f, h); /* Sturm's chain wants no multiple root, and none at 0 */
    fmpq_poly_derivative(h, g);
    fmpq_poly_gcd(h, g, h);
    fmpq_poly_div(g, g, h);
    fmpq_poly_get_numerator(simple, g);
    if (fmpz_is_zero(simple->coeffs))
        fmpz_poly_shift_right(simple, simple, 1);
    if (fmpz_poly_degree(simple) > 0)
        _fmpz_poly_num_real_roots_sturm(&negative, &positive, simple->coeffs, simple->length);
    return positive;
}

static enum truth roots_counted(const struct assertion *a, const struct bindings *b)
{
    SCOPE(fmpq_poly, f);
    SCOPE(fmpq, low);
    if (!polynomial_of(f, &a->formula, a->variable, b) || fmpq_poly_is_zero(f) || !formula_rational(low, &a->low, b))
        return UNDECIDED;
    return roots_beyond(f, low) == a->count ? FOUND_TRUE : FOUND_FALSE;
}

/* A derivative of each rate by each state, and by the control. */
static bool system_matrix(fmpq_mat_t A, fmpq_mat_t column, const struct linear_system *l, const struct bindings *b)
{
    struct program program;
    struct formula entry = {.program = &program};
    bool rational = true;
    program_copy(&program, l->of);
    for (int i = 0; i < l->size; i++)
        for (int j = 0; j <= l->size && rational; j++) {
            const int by = j < l->size ? l->states[j] : l->control;
            if (by < 0)
                continue;
            entry.node = program_slope(&program, l->rates[i], by);
            rational = formula_rational(j < l->size ? fmpq_mat_entry(A, i, j) : fmpq_mat_entry(column, i, 0), &entry, b);
        }
    program_clear(&program);
    return rational;
}

/* Of the matrix itself, or of b, A b, A^2 b ...; observing a state: of the transposed matrix, b its unit vector. */
static enum truth rank_found(const struct assertion *a, const struct bindings *b)
{
    const struct linear_system *l = &a->system;
    enum truth truth = UNDECIDED;
    MATRIX(fmpq, A, l->size, l->size);
    MATRIX(fmpq, K, l->size, l->size);
    MATRIX(fmpq, v, l->size, 1);
    if (system_matrix(A, v, l, b)) {
        if (l->observe >= 0) {
            fmpq_mat_transpose(A, A);
            fmpq_one(fmpq_mat_entry(v, l->observe, 0));
        }
        if (l->control < 0 && l->observe < 0)
            fmpq_mat_set(K, A);
        else
            for (int k = 0; k < l->size; k++) {
                for (int i = 0; i < l->size; i++)
                    fmpq_set(fmpq_mat_entry(K, i, k), fmpq_mat_entry(v, i, 0));
                fmpq_mat_mul(v, A, v);
            }
        truth = fmpq_mat_rref(K, K) == a->count ? FOUND_TRUE : FOUND_FALSE; /* the rank */
    }
    return truth;
}

/* ---- assertions ---- */

/* Proved true or not proved: what cannot be refuted this way stays undecided. */
static enum truth proved_or_open(bool proved)
{
    return proved ? FOUND_TRUE : UNDECIDED;
}

/* The prover's word on an equality for all values. */
static enum truth identity_found(const struct identities *t)
{
    struct proof p;
    identities_prove(t, &p);
    const enum truth truth = p.result == IDENTITY_HOLDS ? FOUND_TRUE : p.result == IDENTITY_DIFFERS ? FOUND_FALSE : UNDECIDED;
    proof_clear(&p);
    return truth;
}

static enum truth claim_found(struct statements *all, const char *id, enum how *how)
{
    struct statement *s = statement_find(all, id);
    struct ruling ruling;
    statement_decide(all, s, &ruling);
    *how = FLINT_MAX(*how, ruling.how);
    return proved_or_open(ruling.as_written);
}

static enum truth cited_found(struct statements *all, struct assertion *a)
{
    enum truth truth = FOUND_TRUE;
    for (int i = 0; a->cited[i] != NULL; i++)
        truth = truth_both(truth, a->kind != ASSERT_STEP ? claim_found(all, a->cited[i], &a->how)
                                         : proved_or_open(step_holds(step_named(all->proofs, a->cited[i]))));
    return truth;
}

static enum truth root_found(struct assertion *a, const struct bindings *b)
{
    SCOPE(arb, z);
    const slong count = root_enclose(z, a, b, PROVING_BITS);
    return count < 0 ? UNDECIDED : count == 1 ? FOUND_TRUE : FOUND_FALSE;
}

/* At the values given, of several at those of this turn. */
static enum truth found_at(struct assertion *a, const struct bindings *b)
{
    if (a->kind == ASSERT_SHOW)
        return a->variable != NULL ? sign_on(a, b) : sign_at(a, b);
    return a->kind == ASSERT_ROOT ? root_found(a, b) : a->kind == ASSERT_ROOTS ? roots_counted(a, b) : rank_found(a, b);
}

static enum truth found_at_each(struct statements *all, struct statement *s, struct assertion *a)
{
    struct bindings b = bindings_of(all, s, a);
    enum truth truth = FOUND_TRUE;
    for (; b.turn < a->at.turns; b.turn++)
        truth = truth_both(truth, found_at(a, &b));
    return truth == FOUND_TRUE && a->loose ? FOUND_LOOSE : truth;
}

void assertion_find(struct statements *all, struct statement *s, struct assertion *a)
{
    if (a->done)
        return;
    a->done = true;
    if (a->identity != NULL)
        a->truth = identity_found(a->identity);
    else if (a->kind == ASSERT_STEP || a->kind == ASSERT_CLAIM)
        a->truth = cited_found(all, a);
    else if (a->kind != ASSERT_COMPUTE)
        a->truth = found_at_each(all, s, a);
}
