/* The proof of identities: signs, normal forms, and what they show where they differ. */
#include "proof/identities.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "formula/symbolic.h"
#include "text/scope.h"

/* What is known of a node. */
struct known {
    struct symbolic value;
    bool done;
};

static const struct symbolic *value_of(struct run *r, int i);

/* Whether a value is a number: that it has a sign, and may be compared. */
static enum symbolic_fault fault_of(const struct symbolic *x)
{
    return x->angle ? SYMBOLIC_ANGLE_AS_NUMBER : x->fault;
}

static const struct variable *variable_of(const struct run *r, slong k)
{
    return &r->t->variables[r->input[k]];
}

/* ---- signs at epsilon = 0 ---- */

static int signs_of_number(int number)
{
    return number > 0 ? SIGN_POSITIVE : number < 0 ? SIGN_NEGATIVE : SIGN_ZERO;
}

/* Of the sums, or the products, of numbers of these signs. */
static int combine(int a, int b, bool sum)
{
    int result = 0;
    for (int x = -1; x <= 1; x++)
        for (int y = -1; y <= 1; y++)
            if ((a & signs_of_number(x)) && (b & signs_of_number(y)))
                result |= !sum ? signs_of_number(x * y) : x * y < 0 ? SIGN_ANY : signs_of_number(x + y);
    return result;
}

static int signs_power(int a, slong exponent)
{
    const int square = (a & SIGN_ZERO) | (a & ~SIGN_ZERO ? SIGN_POSITIVE : 0);
    return exponent == 0 ? SIGN_POSITIVE : exponent % 2 ? a : square;
}

/* Of a polynomial: the signs of its terms. What stands for an angle or a function has any; at a point nothing else does. */
static int signs_of_polynomial(const struct run *r, const fmpz_mpoly_t f)
{
    const fmpz_mpoly_ctx_struct *ctx = symbolic_context();
    int sum = SIGN_ZERO;
    SCOPE(fmpz, c);
    for (slong i = 0; i < fmpz_mpoly_length(f, ctx); i++) {
        fmpz_mpoly_get_term_coeff_fmpz(c, f, i, ctx);
        int term = signs_of_number(fmpz_sgn(c));
        for (slong k = 0; k < fmpz_mpoly_ctx_nvars(ctx); k++) {
            const bool number = k < r->variables && !r->at_point && !variable_of(r, k)->angle;
            term = combine(term, signs_power(number ? variable_of(r, k)->signs : SIGN_ANY, fmpz_mpoly_get_term_var_exp_si(f, i, k, ctx)), false);
        }
        sum = combine(sum, term, true);
    }
    return sum;
}

static int signs_of(struct run *r, int i);

/* By its form; none where it divides by zero. */
static int signs_by_form(struct run *r, const struct node *n)
{
    if (n->op == OPERATOR_COS && n->left < r->t->program.inputs && r->t->variables[n->left].quarter_turn)
        return SIGN_POSITIVE;
    if (n->op != OPERATOR_MULTIPLY && n->op != OPERATOR_DIVIDE)
        return SIGN_ANY;
    const int a = signs_of(r, n->left), b = signs_of(r, n->right);
    return combine(a, n->op == OPERATOR_DIVIDE ? b & ~SIGN_ZERO : b, false);
}

/* The signs that a node that is a number may have at epsilon = 0: by its form, and where that does not tell by its normal form. */
static int signs_of(struct run *r, int i)
{
    const int by_form = signs_by_form(r, &r->t->program.nodes[i]);
    if (by_form != 0 && by_form != SIGN_ANY)
        return by_form;
    const struct symbolic *x = value_of(r, i);
    return combine(signs_of_polynomial(r, fmpz_mpoly_q_numref(x->a)),
                   signs_of_polynomial(r, fmpz_mpoly_q_denref(x->a)) & ~SIGN_ZERO, false);
}

/* ---- values ---- */

/*
 * At a point each variable is a prime of its own, the larger the earlier it is known; of an angle it is the tangent of the half, and one
 * over the prime within a quarter turn.
 */
static void set_input(struct run *r, struct symbolic *z, int i)
{
    const struct node *n = &r->t->program.nodes[i];
    const bool own = i < r->t->program.inputs;
    slong variable = own ? 0 : r->variables + n->exponent;
    SCOPE(fmpq, prime);
    while (own && r->input[variable] != i)
        variable++;
    const fmpq *point = r->at_point ? prime : NULL;
    fmpq_set_ui(prime, n_nth_prime((ulong)(variable < r->variables ? r->variables - variable : variable + 1) + 2), 1);
    if (own && r->t->variables[i].quarter_turn)
        fmpq_inv(prime, prime);
    if (own ? r->t->variables[i].angle : fmpq_is_one(&n->number))
        symbolic_set_angle(z, variable, point);
    else
        symbolic_set_variable(z, variable, own ? r->t->variables[i].power : 0, point);
}

static const struct symbolic *value_of(struct run *r, int i)
{
    const struct node *n = &r->t->program.nodes[i];
    struct symbolic *z = &r->nodes[i].value;
    if (r->nodes[i].done)
        return z;
    arithmetic_symbolic.init(z, r->terms);
    r->nodes[i].done = true;
    if (n->op == OPERATOR_INPUT) {
        set_input(r, z, i);
    } else if (n->op == OPERATOR_NUMBER) {
        arithmetic_symbolic.set_rational(z, &n->number, r->terms);
    } else {
        const struct symbolic *x = value_of(r, n->left), *y = n->right < 0 ? NULL : value_of(r, n->right);
        const int sign = n->op == OPERATOR_POSITIVE && fault_of(x) == SYMBOLIC_FINE ? signs_of(r, n->left) : SIGN_ANY;
        SCOPE(fmpq, truth);
        fmpq_set_si(truth, sign == SIGN_POSITIVE, 1);
        if (sign == SIGN_POSITIVE || !(sign & (SIGN_POSITIVE | (r->terms > 1 ? SIGN_ZERO : 0))))
            arithmetic_symbolic.set_rational(z, truth, r->terms);
        else
            arithmetic_symbolic.apply(n->op, z, x, y, n->exponent, r->terms);
    }
    return z;
}

static void forget_nodes(struct run *r)
{
    while (r->count > 0)
        if (r->nodes[--r->count].done)
            arithmetic_symbolic.clear(&r->nodes[r->count].value);
}

void run_turn_to(struct run *r, const struct identities *altered)
{
    forget_nodes(r);
    r->t = altered;
    r->nodes = xrealloc(r->nodes, (size_t)altered->program.count, sizeof *r->nodes);
    while (r->count < altered->program.count)
        r->nodes[r->count++] = (struct known){.done = false};
}

/* Inputs that something shown rests on are variables, the others are not there: but by an alteration any may be. */
void run_begin(struct run *r, const struct identities *t, slong terms, enum manner manner, slong more)
{
    slong functions = 0;
    *r = (struct run){.t = t, .terms = terms, .at_point = manner == RUN_AT_POINT};
    r->input = xrealloc(NULL, (size_t)t->program.inputs + 1, sizeof *r->input);
    for (int i = 0; i < t->program.count; i++) {
        if (i < t->program.inputs && (manner != RUN_STRICT || t->needed[i]))
            r->input[r->variables++] = i;
        functions += t->program.nodes[i].op >= OPERATOR_SQRT;
    }
    const slong room = manner == RUN_STRICT ? 0 : 2 * functions; /* those that are altered are functions again */
    symbolic_begin(r->at_point ? 0 : r->variables + more, room);
    run_turn_to(r, t);
}

void run_end(struct run *r)
{
    forget_nodes(r);
    symbolic_end();
    free(r->nodes);
    free(r->input);
}

/* ---- comparing ---- */

/* Where the sides of an equality differ, or why they cannot be compared. */
struct finding {
    slong power; /* of epsilon */
    enum symbolic_fault fault;
};

bool run_root(struct run *r, int node)
{
    const struct symbolic *x = value_of(r, node);
    const bool positive = fault_of(x) == SYMBOLIC_FINE && signs_of(r, node) == SIGN_POSITIVE;
    if (positive)
        symbolic_root(x);
    return positive;
}

/* Of two nodes; *zero: both vanish, to this order. */
static enum result compare_nodes(struct run *r, int left, int right, bool *zero, struct finding *f)
{
    const struct symbolic *x = value_of(r, left), *y = value_of(r, right);
    f->fault = fault_of(x) != SYMBOLIC_FINE ? fault_of(x) : fault_of(y);
    *zero = f->fault == SYMBOLIC_FINE;
    if (!*zero)
        return IDENTITY_UNDECIDED;
    for (f->power = 0; f->power < r->terms; f->power++) {
        if (!fmpz_mpoly_q_equal(x->a + f->power, y->a + f->power, symbolic_context()))
            return IDENTITY_DIFFERS;
        *zero = *zero && fmpz_mpoly_q_is_zero(x->a + f->power, symbolic_context());
    }
    return IDENTITY_HOLDS;
}

enum result run_compare(struct run *r, int left, int right)
{
    bool zero;
    struct finding f;
    const enum result result = compare_nodes(r, left, right, &zero, &f);
    const bool nowhere = f.fault == SYMBOLIC_ANGLE_AS_NUMBER || (f.fault == SYMBOLIC_POLE && !r->at_point);
    return nowhere ? IDENTITY_DIFFERS : result;
}

/* ---- evidence ---- */

enum { SHOWN_TERMS = 6, EXAMPLES = 5 };

/* The leading terms of a polynomial, in the names of the inputs; an angle is known by t, the tangent of its half. */
static void print_polynomial(struct tex *out, const struct run *r, const fmpz_mpoly_t f)
{
    char (*names)[LONGEST_NAME + 3] = xrealloc(NULL, (size_t)r->variables + 1, sizeof *names);
    const char **texts = xrealloc(NULL, (size_t)r->variables + 1, sizeof *texts);
    fmpz_mpoly_struct head = *f; /* borrows it */
    texts[r->variables] = "none"; /* the field has one more */
    for (slong k = 0; k < r->variables; k++) {
        snprintf(names[k], sizeof *names, "%s%s", variable_of(r, k)->angle ? "t_" : "", r->t->program.names[r->input[k]].text);
        texts[k] = names[k];
    }
    head.length = FLINT_MIN(head.length, SHOWN_TERMS);
    char *text = fmpz_mpoly_get_str_pretty(&head, texts, symbolic_context());
    tex_add(out, "%s", text);
    flint_free(text);
    free(names);
    free(texts);
}

/* At integers for the variables; false where it has no value there. */
static bool quotient_at(fmpq_t q, const fmpz_mpoly_q_struct *x, fmpz *const *at)
{
    fmpz_mpoly_evaluate_all_fmpz(fmpq_numref(q), fmpz_mpoly_q_numref(x), at, symbolic_context());
    fmpz_mpoly_evaluate_all_fmpz(fmpq_denref(q), fmpz_mpoly_q_denref(x), at, symbolic_context());
    if (fmpz_is_zero(fmpq_denref(q)))
        return false;
    fmpq_canonicalise(q);
    return true;
}

static void print_rational(struct tex *out, const char *before, const fmpq_t q)
{
    char *digits = fmpq_get_str(NULL, 10, q);
    tex_add(out, "%s%s", before, digits);
    flint_free(digits);
}

/* "; LEFT is not RIGHT where NAME = ...", at the first point with small numbers where two coefficients differ. */
static void print_example(struct tex *out, const struct run *r, const fmpz_mpoly_q_struct *x, const fmpz_mpoly_q_struct *y)
{
    const slong all = fmpz_mpoly_ctx_nvars(symbolic_context());
    int *used = xrealloc(NULL, 2 * (size_t)all, sizeof *used);
    fmpz *values = _fmpz_vec_init(all), **at = xrealloc(NULL, (size_t)all, sizeof *at);
    SCOPE(fmpq, left, right);
    const char *separator = " where ";
    bool found = false;
    fmpz_mpoly_q_used_vars(used, x, symbolic_context());
    fmpz_mpoly_q_used_vars(used + all, y, symbolic_context());
    for (slong k = 0; k < all; k++)
        at[k] = values + k;
    for (slong example = 0; example < EXAMPLES && !found; example++) {
        for (slong k = 0; k < r->variables; k++)
            fmpz_set_si(values + k, 1 + variable_of(r, k)->angle + example * (2 * k + 1) % 5);
        found = quotient_at(left, x, at) && quotient_at(right, y, at) && !fmpq_equal(left, right);
    }
    if (found) {
        print_rational(out, "; ", left);
        print_rational(out, " is not ", right);
        for (slong k = 0; k < r->variables; k++) {
            const struct variable *v = variable_of(r, k);
            if (!(used[k] || used[all + k]))
                continue;
            tex_add(out, v->angle ? "%stan(%s/2) = %ld%s" : "%s%s = %ld%s", separator, r->t->program.names[r->input[k]].text,
                    (long)fmpz_get_si(at[k]), v->power > 0 ? " epsilon" : "");
            separator = ", ";
        }
    }
    _fmpz_vec_clear(values, all);
    free(at);
    free(used);
}

/* The difference of two coefficients, not zero. */
static void print_difference(struct tex *out, const struct run *r, const fmpz_mpoly_q_struct *x, const fmpz_mpoly_q_struct *y)
{
    const fmpz_mpoly_ctx_struct *ctx = symbolic_context();
    fmpz_mpoly_q_t difference;
    fmpz_mpoly_q_init(difference, ctx);
    fmpz_mpoly_q_sub(difference, x, y, ctx);
    const fmpz_mpoly_struct *over = fmpz_mpoly_q_numref(difference), *under = fmpz_mpoly_q_denref(difference);
    const slong length = fmpz_mpoly_length(over, ctx);
    tex_add(out, "%s", length > 1 ? "(" : "");
    print_polynomial(out, r, over);
    if (length > SHOWN_TERMS)
        tex_add(out, "+...%ld terms", (long)length);
    tex_add(out, "%s", length > 1 ? ")" : "");
    if (!fmpz_mpoly_is_one(under, ctx)) {
        tex_add(out, "/(");
        print_polynomial(out, r, under);
        tex_add(out, "%s", fmpz_mpoly_length(under, ctx) > SHOWN_TERMS ? "+...)" : ")");
    }
    fmpz_mpoly_q_clear(difference, ctx);
}

/* How the sides of an equality differ, or why they have no value. */
static char *tell_difference(struct run *r, const struct equality *e, const struct finding *f)
{
    struct tex out = {NULL, 0};
    tex_add(&out, "%s: ", e->text);
    if (f->fault != SYMBOLIC_FINE) {
        tex_add(&out, "no value, %s", symbolic_fault_text(f->fault));
        return out.text;
    }
    if (r->terms > 1)
        tex_add(&out, "the coefficients of epsilon^%ld differ by ", (long)f->power);
    else
        tex_add(&out, "the sides differ by ");
    const fmpz_mpoly_q_struct *x = value_of(r, e->left)->a + f->power, *y = value_of(r, e->right)->a + f->power;
    print_difference(&out, r, x, y);
    print_example(&out, r, x, y);
    return out.text;
}

/* ---- the proof ---- */

/* Where nothing told against the identities before: they are undecided, for what is said of `what`. */
static void proof_fails(struct proof *p, const struct yaml *at, const char *format, const char *what)
{
    struct tex out = {NULL, 0};
    if (p->result != IDENTITY_HOLDS)
        return;
    tex_add(&out, format, what);
    p->result = IDENTITY_UNDECIDED;
    p->at = at;
    p->evidence = out.text;
}

/*
 * To so many terms. Further than the order: whether equalities of which both sides vanish to it do so for good, and not for
 * want of further terms.
 */
static void prove_to(const struct identities *t, slong terms, bool further, bool *zero, struct proof *p)
{
    struct run r;
    run_begin(&r, t, terms, RUN_STRICT, 0);
    for (int i = 0; i < t->root_count; i++)
        if (!run_root(&r, t->roots[i].node))
            proof_fails(p, t->roots[i].at, "square root %s is not proved to be positive", t->roots[i].text);
    for (int i = 0; i < t->shown_count; i++) {
        const struct equality *e = &t->shown[i];
        struct finding f;
        if (further && !zero[i])
            continue;
        const enum result result = compare_nodes(&r, e->left, e->right, &zero[i], &f);
        zero[i] = zero[i] && result == IDENTITY_HOLDS;
        if (further && !zero[i])
            proof_fails(p, e->at, "%s: both sides vanish to this order: nothing is shown", e->text);
        if (result != IDENTITY_HOLDS && p->result == IDENTITY_HOLDS) {
            p->result = result;
            p->at = e->at;
            p->offset = e->offset;
            p->evidence = tell_difference(&r, e, &f);
        }
    }
    for (int i = 0; i < t->root_count && t->scope.shared == NULL && !further; i++)
        if (!symbolic_root_used(i))
            proof_fails(p, t->roots[i].at, "square root %s is the root of nothing shown", t->roots[i].text);
    run_end(&r);
}

void identities_prove(const struct identities *t, struct proof *p)
{
    bool zero[MOST_SHOWN] = {false};
    *p = (struct proof){.result = IDENTITY_HOLDS};
    prove_to(t, FLINT_MAX(t->order, 0) + 1, false, zero, p);
    if (t->order >= 0)
        prove_to(t, 2 * t->order + 4, true, zero, p);
}

void proof_clear(struct proof *p)
{
    free(p->evidence);
}

/* ---- where they hold ---- */

char *identities_domain(const struct identities *t)
{
    static const char *const bounds[] = {[SIGN_POSITIVE] = " > 0", [SIGN_POSITIVE | SIGN_ZERO] = " >= 0", [SIGN_ANY] = ""};
    struct tex out = {NULL, 0};
    for (int i = 0; i < t->program.inputs; i++) {
        const struct variable *v = &t->variables[i];
        if (t->needed[i] && (v->angle || v->power > 0 || v->signs != SIGN_ANY))
            tex_add(&out, ", %s%s%s", t->program.names[i].text,
                    v->quarter_turn ? " within a quarter turn" : v->angle ? " any angle" : bounds[v->signs], v->power > 0 ? " small" : "");
    }
    tex_add(&out, "%s", t->lets.text != NULL ? t->lets.text : "");
    char *domain = text_copy(out.length > 0 ? out.text + 2 : "all values");
    tex_clear(&out);
    return domain;
}
