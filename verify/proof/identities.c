/* The proof of identities: signs, normal forms, and what they show where they differ. */
#include "proof/identities.h"

#include <stdlib.h>
#include <string.h>

#include "formula/symbolic.h"
#include "text/scope.h"

/* What is known of a node. */
struct known {
    struct symbolic value;
    bool done, kept;
    int signs;
};

static const struct symbolic *value_of(struct run *r, int i);

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

/* Of a polynomial: the signs of its terms, or those of a square. What stands for a function has any; at a point nothing else does. */
static int signs_of_polynomial(const struct run *r, const fmpz_mpoly_t f)
{
    const fmpz_mpoly_ctx_struct *ctx = symbolic_context();
    const slong all = fmpz_mpoly_ctx_nvars(ctx);
    int *signs = xrealloc(NULL, (size_t)all, sizeof *signs), sum = SIGN_ZERO;
    SCOPE(fmpz, c);
    for (slong k = 0; k < all; k++)
        signs[k] = SIGN_ANY;
    for (int k = 0; k < r->t->program.inputs && !r->at_point; k++)
        if (r->variable[k] >= 0 && !r->t->variables[k].angle)
            signs[r->variable[k]] = r->t->variables[k].signs;
    for (slong i = 0; i < fmpz_mpoly_length(f, ctx) && sum != SIGN_ANY; i++) {
        fmpz_mpoly_get_term_coeff_fmpz(c, f, i, ctx);
        int term = signs_of_number(fmpz_sgn(c));
        for (slong k = 0; k < all; k++)
            term = combine(term, signs_power(signs[k], fmpz_mpoly_get_term_var_exp_si(f, i, k, ctx)), false);
        sum = combine(sum, term, true);
    }
    free(signs);
    return sum == SIGN_ANY && symbolic_is_square(f) ? SIGN_ZERO | SIGN_POSITIVE : sum;
}

static int signs_of(struct run *r, int i);

/* By its form; none where it divides by zero. */
static int signs_by_form(struct run *r, const struct node *n)
{
    const struct variable *v = n->left >= 0 && n->left < r->t->program.inputs ? &r->t->variables[n->left] : NULL;
    if (n->op == OPERATOR_NUMBER)
        return signs_of_number(fmpq_sgn(&n->number));
    if (n->op == OPERATOR_COS)
        return v != NULL && (v->quarter_turn || v->power > 0) ? SIGN_POSITIVE : SIGN_ANY;
    if (n->op == OPERATOR_EXP)
        return SIGN_POSITIVE;
    const int a = signs_of(r, n->left), b = n->right < 0 ? SIGN_ANY : signs_of(r, n->right);
    if (n->op == OPERATOR_MULTIPLY)
        return combine(a, b, false);
    if (n->op == OPERATOR_DIVIDE)
        return combine(a, b & ~SIGN_ZERO, false);
    if (n->op != OPERATOR_POSITIVE)
        return SIGN_ANY;
    const int may_be_one = a & (SIGN_POSITIVE | (r->terms > 1 ? SIGN_ZERO : 0)); /* zero at epsilon = 0 alone */
    return (may_be_one ? SIGN_POSITIVE : 0) | (a & ~SIGN_POSITIVE ? SIGN_ZERO : 0);
}

/* The signs that a node may have at epsilon = 0: by its form, and where that does not tell by its normal form. */
static int signs_of(struct run *r, int i)
{
    int *result = &r->nodes[i].signs;
    if (i < r->t->program.inputs)
        return r->t->variables[i].power > 0 ? SIGN_ZERO : r->t->variables[i].signs;
    if (r->t->program.nodes[i].op == OPERATOR_INPUT)
        return SIGN_ANY;
    if (*result == 0 && ((*result = signs_by_form(r, &r->t->program.nodes[i])) == 0 || *result == SIGN_ANY)) {
        const struct symbolic *x = value_of(r, i);
        *result = SIGN_ANY;
        if (x->fault == SYMBOLIC_FINE && !x->angle)
            *result = combine(signs_of_polynomial(r, fmpz_mpoly_q_numref(x->a)),
                              signs_of_polynomial(r, fmpz_mpoly_q_denref(x->a)) & ~SIGN_ZERO, false);
    }
    return *result;
}

/* ---- values ---- */

/* At a point every number is a prime, and an angle is twice the arc tangent of a prime's reciprocal. */
static void set_input(struct run *r, struct symbolic *z, int i)
{
    const struct node *n = &r->t->program.nodes[i];
    const bool own = i < r->t->program.inputs;
    const slong variable = own ? r->variable[i] : r->variables + n->exponent;
    const slong power = own ? r->t->variables[i].power : 0;
    const bool angle = own ? r->t->variables[i].angle : fmpq_is_one(&n->number);
    SCOPE(fmpq, point);
    if (r->at_point)
        fmpq_set_si(point, (slong)n_nth_prime((ulong)variable + 3), 1);
    if (angle && r->at_point)
        fmpq_inv(point, point);
    if (angle)
        symbolic_set_angle(z, variable, r->at_point ? point : NULL);
    else
        symbolic_set_variable(z, variable, power, r->at_point ? point : NULL);
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
        const int sign = n->op == OPERATOR_POSITIVE && x->fault == SYMBOLIC_FINE ? signs_of(r, n->left) : SIGN_ANY;
        SCOPE(fmpq, truth);
        fmpq_set_si(truth, sign == SIGN_POSITIVE, 1);
        if (sign == SIGN_POSITIVE || !(sign & (SIGN_POSITIVE | (r->terms > 1 ? SIGN_ZERO : 0))))
            arithmetic_symbolic.set_rational(z, truth, r->terms);
        else
            arithmetic_symbolic.apply(n->op, z, x, y, n->exponent, r->terms);
    }
    return z;
}

void run_extend(struct run *r)
{
    r->nodes = xrealloc(r->nodes, (size_t)r->t->program.count, sizeof *r->nodes);
    while (r->count < r->t->program.count)
        r->nodes[r->count++] = (struct known){.done = false};
}

/* Inputs that something shown rests on are variables, the others are not there. */
void run_begin(struct run *r, const struct identities *t, slong terms, enum manner manner, slong more)
{
    slong functions = 0;
    *r = (struct run){.t = t, .terms = terms, .at_point = manner == RUN_AT_POINT};
    r->variable = xrealloc(NULL, (size_t)t->program.inputs + 1, sizeof *r->variable);
    for (int i = 0; i < t->program.count; i++) {
        if (i < t->program.inputs)
            r->variable[i] = t->needed[i] ? r->variables++ : -1;
        functions += t->program.nodes[i].op >= OPERATOR_SQRT;
    }
    run_extend(r);
    const slong room = manner == RUN_STRICT ? 0 : 2 * functions; /* those that are altered are functions again */
    r->field = symbolic_begin(r->at_point ? 0 : r->variables + more, room, manner != RUN_STRICT);
}

void run_keep(struct run *r, int count)
{
    symbolic_use(r->field);
    for (int i = 0; i < count; i++) {
        if (r->t->needed[i])
            value_of(r, i);
        r->nodes[i].kept = r->nodes[i].done;
    }
    symbolic_keep();
}

void run_forget(struct run *r)
{
    symbolic_use(r->field);
    for (int i = 0; i < r->count; i++) {
        if (r->nodes[i].done && !r->nodes[i].kept)
            arithmetic_symbolic.clear(&r->nodes[i].value);
        if (!r->nodes[i].kept)
            r->nodes[i] = (struct known){.done = false};
    }
    r->count = FLINT_MIN(r->count, r->t->program.count);
    symbolic_forget();
}

void run_end(struct run *r)
{
    symbolic_use(r->field);
    for (int i = 0; i < r->count; i++)
        if (r->nodes[i].done)
            arithmetic_symbolic.clear(&r->nodes[i].value);
    symbolic_end();
    free(r->nodes);
    free(r->variable);
}

/* ---- evidence ---- */

static void evaluate_polynomial(fmpq_t y, const fmpz_mpoly_t f, fmpq *point)
{
    const fmpq_mpoly_ctx_t ctx = {{.zctx = {*symbolic_context()}}};
    const fmpq_mpoly_t rational = {{.content = {{1, 1}}, .zpoly = {*f}}}; /* borrows it */
    const slong count = fmpz_mpoly_ctx_nvars(ctx->zctx);
    fmpq **at = xrealloc(NULL, (size_t)count, sizeof *at);
    for (slong k = 0; k < count; k++)
        at[k] = point + k;
    fmpq_mpoly_evaluate_all_fmpq(y, rational, at, ctx);
    free(at);
}

/* False at a pole. */
static bool rational_at(fmpq_t y, const fmpz_mpoly_q_struct *f, fmpq *point)
{
    SCOPE(fmpq, under);
    evaluate_polynomial(y, fmpz_mpoly_q_numref(f), point);
    evaluate_polynomial(under, fmpz_mpoly_q_denref(f), point);
    const bool fine = !fmpq_is_zero(under);
    if (fine)
        fmpq_div(y, y, under);
    return fine;
}

/* Small numbers, 1 if it can be; the tangent of half an angle is 1/2, 1/3 ..., so that it is within a quarter turn. */
static void choose_point(fmpq *point, const struct run *r, int attempt)
{
    for (int i = 0; i < r->t->program.inputs; i++) {
        const slong k = r->variable[i], size = 1 + (attempt * (k + 1) + (attempt > 0 ? k : 0)) % 5;
        if (k >= 0 && r->t->variables[i].angle)
            fmpq_set_si(point + k, 1, (ulong)size + 1);
        else if (k >= 0)
            fmpq_set_si(point + k, r->t->variables[i].signs & SIGN_POSITIVE ? size : -size, 1);
    }
}

static void print_rational(struct tex *out, const fmpq_t q)
{
    char *text = fmpq_get_str(NULL, 10, q);
    tex_add(out, "%s", text);
    flint_free(text);
}

/* "; LEFT is not RIGHT where NAME = ...": a point where the two differ. */
static void print_example(struct tex *out, const struct run *r, const fmpz_mpoly_q_struct *x, const fmpz_mpoly_q_struct *y)
{
    enum { ATTEMPTS = 100 };
    VECTOR(fmpq, point, r->variables + 1);
    SCOPE(fmpq, left, right);
    const slong all = fmpz_mpoly_ctx_nvars(symbolic_context());
    int attempt = 0, *used = xrealloc(NULL, 2 * (size_t)all, sizeof *used);
    fmpz_mpoly_q_used_vars(used, x, symbolic_context());
    fmpz_mpoly_q_used_vars(used + all, y, symbolic_context());
    do
        choose_point(point, r, attempt);
    while (attempt++ < ATTEMPTS &&
           (!rational_at(left, x, point) || !rational_at(right, y, point) || fmpq_equal(left, right)));
    tex_add(out, "; ");
    print_rational(out, left);
    tex_add(out, " is not ");
    print_rational(out, right);
    const char *separator = " where ";
    for (int i = 0; i < r->t->program.inputs && attempt <= ATTEMPTS; i++) {
        const slong k = r->variable[i];
        if (k < 0 || !(used[k] || used[all + k]))
            continue;
        const char *name = r->t->program.names[i].text;
        tex_add(out, r->t->variables[i].angle ? "%stan(%s/2) = " : "%s%s = ", separator, name);
        print_rational(out, point + k);
        tex_add(out, r->t->variables[i].power > 0 ? " epsilon" : "");
        separator = ", ";
    }
    free(used);
}

enum { SHOWN_TERMS = 6 };

/* The leading terms of a polynomial, in the names of the inputs; an angle is known by t, the tangent of its half. */
static void print_polynomial(struct tex *out, const struct run *r, const fmpz_mpoly_t f)
{
    const fmpz_mpoly_ctx_struct *ctx = symbolic_context();
    struct tex *names = xrealloc(NULL, (size_t)r->variables + 1, sizeof *names);
    const char **texts = xrealloc(NULL, (size_t)r->variables + 1, sizeof *texts);
    fmpz_mpoly_struct head = *f; /* borrows it */
    texts[0] = "none"; /* FLINT has one variable at least */
    for (int i = 0; i < r->t->program.inputs; i++) {
        const slong k = r->variable[i];
        if (k < 0)
            continue;
        names[k] = (struct tex){NULL, 0};
        tex_add(&names[k], "%s%s", r->t->variables[i].angle ? "t_" : "", r->t->program.names[i].text);
        texts[k] = names[k].text;
    }
    head.length = FLINT_MIN(head.length, SHOWN_TERMS);
    char *text = fmpz_mpoly_get_str_pretty(&head, texts, ctx);
    tex_add(out, "%s", text);
    flint_free(text);
    for (slong k = 0; k < r->variables; k++)
        tex_clear(&names[k]);
    free(names);
    free(texts);
}

/* The difference of two coefficients, not zero. */
static void print_difference(struct tex *out, const struct run *r, const fmpz_mpoly_q_struct *x,
                             const fmpz_mpoly_q_struct *y, struct proof *p)
{
    const fmpz_mpoly_ctx_struct *ctx = symbolic_context();
    struct tex over = {NULL, 0}, under = {NULL, 0}, tex = {NULL, 0};
    fmpz_mpoly_q_t difference;
    fmpz_mpoly_q_init(difference, ctx);
    fmpz_mpoly_q_sub(difference, x, y, ctx);
    const slong length = fmpz_mpoly_length(fmpz_mpoly_q_numref(difference), ctx);
    print_polynomial(&over, r, fmpz_mpoly_q_numref(difference));
    print_polynomial(&under, r, fmpz_mpoly_q_denref(difference));
    tex_add(out, length > SHOWN_TERMS ? "(%s+...%ld terms)" : length > 1 ? "(%s)" : "%s", over.text, (long)length);
    if (!fmpz_mpoly_is_one(fmpz_mpoly_q_denref(difference), ctx))
        tex_add(out, "/(%s%s)", under.text, fmpz_mpoly_length(fmpz_mpoly_q_denref(difference), ctx) > SHOWN_TERMS ? "+..." : "");
    typeset_inline(&tex, over.text, over.length);
    tex_add(&tex, length > SHOWN_TERMS ? " + \\dots" : "");
    p->difference = tex.text;
    tex_clear(&over);
    tex_clear(&under);
    fmpz_mpoly_q_clear(difference, ctx);
}

/* ---- the proof ---- */

/* Where the sides of an equality differ, or why they cannot be compared. */
struct finding {
    slong power; /* of epsilon */
    enum symbolic_fault fault;
};

bool run_root(struct run *r, int node)
{
    symbolic_use(r->field);
    const struct symbolic *x = value_of(r, node);
    const int s = x->fault == SYMBOLIC_FINE && !x->angle ? signs_of(r, node) : SIGN_ANY;
    const bool is_root = !(s & SIGN_NEGATIVE) && s != SIGN_ZERO;
    if (is_root)
        symbolic_root(x, s == SIGN_POSITIVE);
    return is_root;
}

/* Whether a value may be compared. */
static enum symbolic_fault fault_of(const struct symbolic *x)
{
    return x->fault == SYMBOLIC_FINE && x->angle ? SYMBOLIC_ANGLE_AS_NUMBER : x->fault;
}

/* Of two nodes; *zero: both vanish, to this order. */
static enum result compare_nodes(struct run *r, int left, int right, bool *zero, struct finding *f)
{
    const struct symbolic *x = value_of(r, left), *y = value_of(r, right);
    f->fault = fault_of(x) != SYMBOLIC_FINE ? fault_of(x) : fault_of(y);
    if (f->fault != SYMBOLIC_FINE)
        return IDENTITY_UNDECIDED;
    *zero = true;
    for (f->power = 0; f->power < r->terms; f->power++) {
        if (!fmpz_mpoly_q_equal(x->a + f->power, y->a + f->power, symbolic_context()))
            return IDENTITY_DIFFERS;
        *zero = *zero && fmpz_mpoly_q_is_zero(x->a + f->power, symbolic_context());
    }
    return IDENTITY_HOLDS;
}

enum result run_compare(struct run *r, int left, int right, bool *large)
{
    bool zero;
    struct finding f;
    symbolic_use(r->field);
    const enum result result = compare_nodes(r, left, right, &zero, &f);
    *large = f.fault == SYMBOLIC_TOO_LARGE;
    return result;
}

/* How the sides of an equality differ, or why they have no value. */
static char *tell_difference(struct run *r, const struct equality *e, const struct finding *f, struct proof *p)
{
    struct tex out = {NULL, 0};
    tex_add(&out, "%s: ", e->text);
    if (f->fault != SYMBOLIC_FINE) {
        const bool large = f->fault == SYMBOLIC_TOO_LARGE;
        tex_add(&out, "no value, %s%s%s", symbolic_fault_text(f->fault), large ? ", " : "", large ? symbolic_fault_size() : "");
        return out.text;
    }
    const fmpz_mpoly_q_struct *x = value_of(r, e->left)->a + f->power, *y = value_of(r, e->right)->a + f->power;
    if (r->terms > 1)
        tex_add(&out, "the coefficients of epsilon^%ld differ by ", (long)f->power);
    else
        tex_add(&out, "the sides differ by ");
    print_difference(&out, r, x, y, p);
    print_example(&out, r, x, y);
    return out.text;
}

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

/* Whether equalities of which both sides vanish do so for good, and not for want of further terms. */
static void look_further(const struct identities *t, const bool *zero, struct proof *p)
{
    struct run r;
    struct finding f;
    run_begin(&r, t, 2 * t->order + 4, RUN_STRICT, 0);
    for (int i = 0; i < t->root_count; i++)
        run_root(&r, t->roots[i].node);
    for (int i = 0; i < t->shown_count; i++) {
        bool still = true;
        if (zero[i])
            still = compare_nodes(&r, t->shown[i].left, t->shown[i].right, &still, &f) == IDENTITY_HOLDS && still;
        if (!still)
            proof_fails(p, t->shown[i].at, "%s: both sides vanish to this order: nothing is shown", t->shown[i].text);
        p->holds[i] = p->holds[i] && still;
    }
    run_end(&r);
}

void identities_prove(const struct identities *t, struct proof *p)
{
    struct run r;
    bool zero[MOST_SHOWN] = {false};
    *p = (struct proof){.result = IDENTITY_HOLDS};
    run_begin(&r, t, t->order + 1 + (t->order < 0), RUN_STRICT, 0);
    for (int i = 0; i < t->root_count; i++)
        if (!run_root(&r, t->roots[i].node))
            proof_fails(p, t->roots[i].at, "square root %s is not proved to be positive", t->roots[i].text);
    for (int i = 0; i < t->shown_count; i++) {
        const struct equality *e = &t->shown[i];
        struct finding f;
        const enum result result = compare_nodes(&r, e->left, e->right, &zero[i], &f);
        p->holds[i] = result == IDENTITY_HOLDS;
        zero[i] = zero[i] && p->holds[i];
        if (p->result == IDENTITY_HOLDS && result != IDENTITY_HOLDS) {
            p->result = result;
            p->at = e->at;
            p->offset = e->offset;
            p->evidence = tell_difference(&r, e, &f, p);
        }
    }
    for (int i = 0; i < t->root_count && !t->shared; i++)
        if (!symbolic_root_used(i))
            proof_fails(p, t->roots[i].at, "square root %s is the root of nothing shown", t->roots[i].text);
    run_end(&r);
    if (t->order >= 0 && p->result == IDENTITY_HOLDS)
        look_further(t, zero, p);
}

void proof_clear(struct proof *p)
{
    free(p->evidence);
    free(p->difference);
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
