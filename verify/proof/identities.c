/* The proof of identities: signs, normal forms, and what they show where they differ. */
#include "proof/identities.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "formula/symbolic.h"
#include "formula/typeset.h"
#include "text/scope.h"

/* The identities at work: values and sets of signs, computed when they are first asked for. */
struct run {
    const struct identities *t;
    struct symbolic *values;
    char *done, *signs;
    slong *variable; /* of an input, -1 where nothing rests on it */
    slong variables, terms;
};

/* ---- signs at epsilon = 0 ---- */

static int signs_product(int a, int b)
{
    return ((a | b) & SIGN_ZERO) | (((a & 4) && (b & 4)) || ((a & 1) && (b & 1)) ? SIGN_POSITIVE : 0) |
           (((a & 4) && (b & 1)) || ((a & 1) && (b & 4)) ? SIGN_NEGATIVE : 0);
}

static int signs_sum(int a, int b)
{
    int sum = a & b & SIGN_ZERO;
    sum |= ((a | b) & SIGN_POSITIVE) | ((a | b) & SIGN_NEGATIVE);
    return ((a & 4) && (b & 1)) || ((a & 1) && (b & 4)) ? SIGN_ANY : sum;
}

static int signs_negative(int a)
{
    return (a & SIGN_ZERO) | (a & SIGN_NEGATIVE ? SIGN_POSITIVE : 0) | (a & SIGN_POSITIVE ? SIGN_NEGATIVE : 0);
}

static int signs_power(int a, ulong exponent)
{
    return exponent == 0 ? SIGN_POSITIVE : exponent % 2 ? a : (a & SIGN_ZERO) | (a & ~SIGN_ZERO ? SIGN_POSITIVE : 0);
}

/* Of a polynomial: the signs of its terms, or those of a square. */
static int signs_of_polynomial(const struct run *r, const fmpz_mpoly_t f)
{
    const fmpz_mpoly_ctx_struct *ctx = symbolic_context();
    const slong all = fmpz_mpoly_ctx_nvars(ctx);
    ulong *exponents = xrealloc(NULL, (size_t)all, sizeof *exponents);
    int signs = SIGN_ZERO;
    SCOPE(fmpz, c);
    for (slong i = 0; i < fmpz_mpoly_length(f, ctx) && signs != SIGN_ANY; i++) {
        fmpz_mpoly_get_term_coeff_fmpz(c, f, i, ctx);
        fmpz_mpoly_get_term_exp_ui(exponents, f, i, ctx);
        int term = fmpz_sgn(c) > 0 ? SIGN_POSITIVE : SIGN_NEGATIVE;
        for (int k = 0; k < r->t->program.inputs; k++)
            if (r->variable[k] >= 0)
                term = signs_product(term, signs_power(r->t->variables[k].angle ? SIGN_ANY : r->t->variables[k].signs,
                                                       exponents[r->variable[k]]));
        for (slong k = r->variables; k < all; k++) /* what stands for a function */
            term = signs_product(term, signs_power(SIGN_ANY, exponents[k]));
        signs = signs_sum(signs, term);
    }
    if (signs == SIGN_ANY && fmpz_mpoly_is_square(f, ctx))
        signs = SIGN_ZERO | SIGN_POSITIVE;
    free(exponents);
    return signs;
}

static const struct symbolic *value(struct run *r, int i);

/* The signs that a node may have at epsilon = 0: by its form, and where that does not tell by its normal form. */
static int signs(struct run *r, int i)
{
    const struct node *n = &r->t->program.nodes[i];
    if (r->signs[i] != 0)
        return r->signs[i];
    const bool one = n->left >= 0 && n->op != OPERATOR_SIN && n->op != OPERATOR_COS && n->op != OPERATOR_ATAN2;
    const int a = one ? signs(r, n->left) : SIGN_ANY, b = one && n->right >= 0 ? signs(r, n->right) : SIGN_ANY;
    int result = SIGN_ANY;
    if (n->op == OPERATOR_INPUT)
        result = r->t->variables[i].power > 0 ? SIGN_ZERO : r->t->variables[i].signs;
    else if (n->op == OPERATOR_NUMBER)
        result = fmpq_sgn(&n->number) > 0 ? SIGN_POSITIVE : fmpq_sgn(&n->number) < 0 ? SIGN_NEGATIVE : SIGN_ZERO;
    else if (n->op == OPERATOR_NEGATE)
        result = signs_negative(a);
    else if (n->op == OPERATOR_ADD || n->op == OPERATOR_SUBTRACT)
        result = signs_sum(a, n->op == OPERATOR_ADD ? b : signs_negative(b));
    else if (n->op == OPERATOR_MULTIPLY)
        result = n->left == n->right ? signs_power(a, 2) : signs_product(a, b);
    else if (n->op == OPERATOR_DIVIDE)
        result = signs_product(a, b & ~SIGN_ZERO);
    else if (n->op == OPERATOR_POWER)
        result = signs_power(n->exponent < 0 ? a & ~SIGN_ZERO : a, (ulong)FLINT_ABS(n->exponent));
    else if (n->op == OPERATOR_SQRT)
        result = a & ~SIGN_NEGATIVE;
    else if (n->op == OPERATOR_EXP ||
             (n->op == OPERATOR_COS && n->left < r->t->program.inputs &&
              (r->t->variables[n->left].quarter_turn || r->t->variables[n->left].power > 0)))
        result = SIGN_POSITIVE;
    else if (n->op == OPERATOR_POSITIVE)
        result = a == SIGN_POSITIVE ? SIGN_POSITIVE : a & SIGN_POSITIVE ? SIGN_ZERO | SIGN_POSITIVE : SIGN_ZERO;
    if (result == 0) /* division by what is zero: no sign at all */
        result = SIGN_ANY;
    if (result == SIGN_ANY && n->op != OPERATOR_INPUT) {
        const struct symbolic *x = value(r, i);
        if (x->fault == SYMBOLIC_FINE && !x->angle)
            result = signs_product(signs_of_polynomial(r, fmpz_mpoly_q_numref(x->a)),
                                   signs_of_polynomial(r, fmpz_mpoly_q_denref(x->a)) & ~SIGN_ZERO);
    }
    return r->signs[i] = (char)result;
}

/* ---- values ---- */

static const struct symbolic *value(struct run *r, int i)
{
    const struct node *n = &r->t->program.nodes[i];
    struct symbolic *z = &r->values[i];
    fmpq_t truth;
    if (r->done[i])
        return z;
    arithmetic_symbolic.init(z, r->terms);
    r->done[i] = true;
    if (n->op == OPERATOR_INPUT && r->t->variables[i].angle) {
        symbolic_set_angle(z, r->variable[i]);
    } else if (n->op == OPERATOR_INPUT) {
        symbolic_set_variable(z, r->variable[i], r->t->variables[i].power);
    } else if (n->op == OPERATOR_NUMBER) {
        arithmetic_symbolic.set_rational(z, &n->number, r->terms);
    } else {
        const struct symbolic *x = value(r, n->left), *y = n->right < 0 ? NULL : value(r, n->right);
        const int sign = n->op == OPERATOR_POSITIVE && x->fault == SYMBOLIC_FINE ? signs(r, n->left) : SIGN_ANY;
        if (sign == SIGN_POSITIVE || !(sign & SIGN_POSITIVE)) {
            fmpq_init(truth);
            fmpq_set_si(truth, sign == SIGN_POSITIVE, 1);
            arithmetic_symbolic.set_rational(z, truth, r->terms);
            fmpq_clear(truth);
        } else {
            arithmetic_symbolic.apply(n->op, z, x, y, n->exponent, r->terms);
        }
    }
    return z;
}

/* Inputs that something shown rests on are variables, the others are not there. */
static void run_begin(struct run *r, const struct identities *t, slong terms, bool loose)
{
    const size_t count = (size_t)t->program.count;
    slong functions = 0;
    *r = (struct run){.t = t, .terms = terms};
    r->values = xrealloc(NULL, count, sizeof *r->values);
    r->done = xrealloc(NULL, count, 1);
    r->signs = xrealloc(NULL, count, 1);
    r->variable = xrealloc(NULL, (size_t)t->program.inputs + 1, sizeof *r->variable);
    memset(r->done, 0, count);
    memset(r->signs, 0, count);
    for (int i = 0; i < t->program.inputs; i++)
        r->variable[i] = t->needed[i] ? r->variables++ : -1;
    for (int i = t->program.inputs; i < t->program.count; i++)
        functions += t->needed[i] && t->program.nodes[i].op >= OPERATOR_SQRT;
    symbolic_begin(r->variables, loose ? functions : 0, loose);
}

static void run_end(struct run *r)
{
    for (int i = 0; i < r->t->program.count; i++)
        if (r->done[i])
            arithmetic_symbolic.clear(&r->values[i]);
    symbolic_end();
    free(r->values);
    free(r->done);
    free(r->signs);
    free(r->variable);
}

/* ---- evidence ---- */

/* Of the inputs that are variables, in their order; an angle is known by t, the tangent of its half. */
static char **variable_names(const struct run *r)
{
    char **names = xrealloc(NULL, (size_t)r->variables + 1, sizeof *names);
    names[r->variables] = NULL;
    if (r->variables == 0) /* FLINT has one variable at least */
        names[0] = text_copy("none");
    for (int i = 0; i < r->t->program.inputs; i++) {
        const char *name = r->t->program.names[i].text;
        if (r->variable[i] < 0)
            continue;
        char *text = xrealloc(NULL, strlen(name) + 3, 1);
        sprintf(text, "%s%s", r->t->variables[i].angle ? "t_" : "", name);
        names[r->variable[i]] = text;
    }
    return names;
}

static void free_names(char **names, slong count)
{
    for (slong i = 0; i < count; i++)
        free(names[i]);
    free(names);
}

static void evaluate_polynomial(fmpq_t y, const fmpz_mpoly_t f, const fmpq *point)
{
    const fmpz_mpoly_ctx_struct *ctx = symbolic_context();
    ulong *exponents = xrealloc(NULL, (size_t)fmpz_mpoly_ctx_nvars(ctx), sizeof *exponents);
    SCOPE(fmpq, term, factor);
    fmpq_zero(y);
    for (slong i = 0; i < fmpz_mpoly_length(f, ctx); i++) {
        fmpz_one(fmpq_denref(term));
        fmpz_mpoly_get_term_coeff_fmpz(fmpq_numref(term), f, i, ctx);
        fmpz_mpoly_get_term_exp_ui(exponents, f, i, ctx);
        for (slong k = 0; k < fmpz_mpoly_ctx_nvars(ctx); k++)
            if (exponents[k] > 0) {
                fmpq_pow_si(factor, point + k, (slong)exponents[k]);
                fmpq_mul(term, term, factor);
            }
        fmpq_add(y, y, term);
    }
    free(exponents);
}

/* False at a pole. */
static bool evaluate(fmpq_t y, const fmpz_mpoly_q_struct *f, const fmpq *point)
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

static void print_rational(FILE *out, const fmpq_t q)
{
    char *text = fmpq_get_str(NULL, 10, q);
    fputs(text, out);
    flint_free(text);
}

/* "; LEFT is not RIGHT where NAME = ...": a point where the two differ. */
static void print_example(FILE *out, const struct run *r, const fmpz_mpoly_q_struct *x, const fmpz_mpoly_q_struct *y)
{
    enum { ATTEMPTS = 100 };
    VECTOR(fmpq, point, r->variables + 1);
    SCOPE(fmpq, left, right);
    int attempt = 0;
    do
        choose_point(point, r, attempt);
    while (attempt++ < ATTEMPTS &&
           (!evaluate(left, x, point) || !evaluate(right, y, point) || fmpq_equal(left, right)));
    fputs("; ", out);
    print_rational(out, left);
    fputs(" is not ", out);
    print_rational(out, right);
    const char *separator = " where ";
    for (int i = 0; i < r->t->program.inputs && attempt <= ATTEMPTS; i++) {
        const slong k = r->variable[i];
        if (k < 0 || !(fmpz_mpoly_degree_si(fmpz_mpoly_q_numref(x), k, symbolic_context()) > 0 ||
                       fmpz_mpoly_degree_si(fmpz_mpoly_q_denref(x), k, symbolic_context()) > 0 ||
                       fmpz_mpoly_degree_si(fmpz_mpoly_q_numref(y), k, symbolic_context()) > 0 ||
                       fmpz_mpoly_degree_si(fmpz_mpoly_q_denref(y), k, symbolic_context()) > 0))
            continue;
        const char *name = r->t->program.names[i].text;
        fprintf(out, r->t->variables[i].angle ? "%stan(%s/2) = " : "%s%s = ", separator, name);
        print_rational(out, point + k);
        fputs(r->t->variables[i].power > 0 ? " epsilon" : "", out);
        separator = ", ";
    }
}

enum { SHOWN_TERMS = 6 };

/* The leading terms of a polynomial, in the names of the inputs. */
static char *polynomial_text(const fmpz_mpoly_t f, char **names)
{
    const fmpz_mpoly_ctx_struct *ctx = symbolic_context();
    fmpz_mpoly_t head;
    fmpz_mpoly_init(head, ctx);
    fmpz_mpoly_set(head, f, ctx);
    if (fmpz_mpoly_length(head, ctx) > SHOWN_TERMS)
        fmpz_mpoly_resize(head, SHOWN_TERMS, ctx);
    char *text = fmpz_mpoly_get_str_pretty(head, (const char **)names, ctx);
    fmpz_mpoly_clear(head, ctx);
    return text;
}

static char *polynomial_tex(const char *text, char *const *names, slong count, bool cut)
{
    struct program p;
    struct tex t = {NULL, 0};
    struct message why;
    size_t where;
    program_init(&p);
    for (slong i = 0; i < count; i++)
        program_input(&p, names[i]);
    const int node = program_parse(&p, text, &where, &why);
    if (node >= 0)
        typeset_formula(&t, &p, node);
    if (node >= 0 && cut)
        tex_add(&t, " + \\dots");
    program_clear(&p);
    return t.text;
}

/* The difference of two coefficients, not zero. */
static void print_difference(FILE *out, const struct run *r, const fmpz_mpoly_q_struct *x,
                             const fmpz_mpoly_q_struct *y, struct proof *p)
{
    const fmpz_mpoly_ctx_struct *ctx = symbolic_context();
    char **names = variable_names(r);
    fmpz_mpoly_q_t difference;
    fmpz_mpoly_q_init(difference, ctx);
    fmpz_mpoly_q_sub(difference, x, y, ctx);
    const slong length = fmpz_mpoly_length(fmpz_mpoly_q_numref(difference), ctx);
    char *over = polynomial_text(fmpz_mpoly_q_numref(difference), names);
    fprintf(out, length > SHOWN_TERMS ? "(%s+...%ld terms)" : length > 1 ? "(%s)" : "%s", over, (long)length);
    if (!fmpz_mpoly_is_one(fmpz_mpoly_q_denref(difference), ctx)) {
        char *under = polynomial_text(fmpz_mpoly_q_denref(difference), names);
        fprintf(out, "/(%s%s)", under,
                fmpz_mpoly_length(fmpz_mpoly_q_denref(difference), ctx) > SHOWN_TERMS ? "+..." : "");
        flint_free(under);
    }
    p->difference = polynomial_tex(over, names, r->variables, length > SHOWN_TERMS);
    flint_free(over);
    fmpz_mpoly_q_clear(difference, ctx);
    free_names(names, FLINT_MAX(r->variables, 1));
}

/* ---- the proof ---- */

struct finding {
    enum result result;
    const struct root *root; /* that is not proved to be positive, or is no root of anything */
    int at;                  /* the first equality that does not hold                        */
    slong power;             /* of epsilon, where its sides differ                           */
    enum symbolic_fault fault;
    const char *why;
};

static void prove_roots(struct run *r, struct finding *f)
{
    for (int i = 0; i < r->t->root_count; i++) {
        const struct root *root = &r->t->roots[i];
        const struct symbolic *x = value(r, root->node);
        const bool number = x->fault == SYMBOLIC_FINE && !x->angle;
        const int s = number ? signs(r, root->node) : SIGN_ANY;
        const bool positive = s == SIGN_POSITIVE;
        if (number && !(s & SIGN_NEGATIVE) && s != SIGN_ZERO) {
            symbolic_root(x, positive);
        } else {
            symbolic_root(NULL, false);
            if (f->root == NULL)
                *f = (struct finding){.result = IDENTITY_UNDECIDED, .root = root, .why = "is not proved to be positive"};
        }
    }
}

static bool all_zero(const struct symbolic *x)
{
    bool zero = true;
    for (slong k = 0; k < x->terms; k++)
        zero = zero && fmpz_mpoly_q_is_zero(x->a + k, symbolic_context());
    return zero;
}

/* Whether a value may be compared. */
static enum symbolic_fault fault_of(const struct symbolic *x)
{
    return x->fault == SYMBOLIC_FINE && x->angle ? SYMBOLIC_ANGLE_AS_NUMBER : x->fault;
}

/* Compares one equality; *vacuous: both its sides are zero, to this order. */
static struct finding compare(struct run *r, int i, bool *vacuous)
{
    const struct symbolic *left = value(r, r->t->shown[i].left), *right = value(r, r->t->shown[i].right);
    struct finding f = {.result = IDENTITY_HOLDS, .at = i, .fault = fault_of(left)};
    if (f.fault == SYMBOLIC_FINE)
        f.fault = fault_of(right);
    if (f.fault != SYMBOLIC_FINE)
        f.result = IDENTITY_UNDECIDED;
    for (slong k = 0; k < r->terms && f.result == IDENTITY_HOLDS; k++)
        if (!fmpz_mpoly_q_equal(left->a + k, right->a + k, symbolic_context())) {
            f.result = IDENTITY_DIFFERS;
            f.power = k;
        }
    *vacuous = f.result == IDENTITY_HOLDS && r->terms > 1 && all_zero(left) && all_zero(right);
    return f;
}

/* Whether both sides of such equalities are zero for good, and not for want of further terms. */
static void look_further(const struct identities *t, const bool *vacuous, bool loose, struct finding *f, struct proof *p)
{
    struct run r;
    struct finding none = {.result = IDENTITY_HOLDS};
    bool still;
    run_begin(&r, t, 2 * t->order + 4, loose);
    prove_roots(&r, &none);
    for (int i = 0; i < t->shown_count; i++) {
        if (!vacuous[i])
            continue;
        compare(&r, i, &still);
        if (!still) {
            p->holds[i] = false;
            if (f->result == IDENTITY_HOLDS)
                *f = (struct finding){.result = IDENTITY_UNDECIDED, .at = i,
                                      .why = "both sides vanish to this order: nothing is shown"};
        }
    }
    run_end(&r);
}

static char *tell(struct run *r, const struct finding *f, struct proof *p)
{
    char *text = NULL;
    size_t size;
    FILE *out = open_memstream(&text, &size);
    if (out == NULL)
        out_of_memory();
    const struct equality *e = &r->t->shown[f->at];
    if (f->root != NULL) {
        fprintf(out, "square root %s %s", f->root->text, f->why);
    } else if (f->why != NULL) {
        fprintf(out, "%s: %s", e->text, f->why);
    } else if (f->result == IDENTITY_UNDECIDED) {
        fprintf(out, "%s: no value, %s", e->text, symbolic_fault_text(f->fault));
        if (f->fault == SYMBOLIC_TOO_LARGE)
            fprintf(out, ", %s", symbolic_fault_size());
    } else {
        const fmpz_mpoly_q_struct *x = value(r, e->left)->a + f->power, *y = value(r, e->right)->a + f->power;
        if (r->terms > 1)
            fprintf(out, "%s: the coefficients of epsilon^%ld differ by ", e->text, (long)f->power);
        else
            fprintf(out, "%s: the sides differ by ", e->text);
        print_difference(out, r, x, y, p);
        print_example(out, r, x, y);
    }
    if (fclose(out) != 0)
        out_of_memory();
    return text;
}

static void prove(const struct identities *t, bool loose, bool tells, struct proof *p)
{
    struct run r;
    struct finding f = {.result = IDENTITY_HOLDS};
    bool vacuous[MOST_SHOWN] = {false}, any = false;
    *p = (struct proof){.result = IDENTITY_HOLDS};
    run_begin(&r, t, t->order < 0 ? 1 : t->order + 1, loose);
    prove_roots(&r, &f);
    for (int i = 0; i < t->shown_count; i++) {
        const struct finding one = compare(&r, i, &vacuous[i]);
        p->holds[i] = one.result == IDENTITY_HOLDS;
        any = any || vacuous[i];
        if (f.result == IDENTITY_HOLDS)
            f = one;
    }
    for (int i = 0; i < t->root_count && f.result == IDENTITY_HOLDS && !t->shared; i++)
        if (!symbolic_root_used(i))
            f = (struct finding){.result = IDENTITY_UNDECIDED, .root = &t->roots[i], .why = "is the root of nothing shown"};
    if (f.result != IDENTITY_HOLDS && tells)
        p->evidence = tell(&r, &f, p);
    run_end(&r);
    if (any) {
        const bool held = f.result == IDENTITY_HOLDS;
        look_further(t, vacuous, loose, &f, p);
        if (held && f.result != IDENTITY_HOLDS && tells)
            p->evidence = tell(&(struct run){.t = t}, &f, p);
    }
    p->result = f.result;
}

void identities_prove(const struct identities *t, struct proof *p)
{
    prove(t, false, true, p);
}

int identities_broken(const struct identities *t, bool loose, bool holds[MOST_SHOWN])
{
    struct proof p;
    int broken = 0;
    prove(t, loose, false, &p);
    for (int i = 0; i < t->shown_count; i++) {
        holds[i] = p.holds[i];
        broken += !p.holds[i];
    }
    return broken;
}

void proof_clear(struct proof *p)
{
    free(p->evidence);
    free(p->difference);
}

bool nodes_equal(const struct program *p, int left, int right, bool loose)
{
    struct equality e = {.text = "", .left = left, .right = right};
    struct identities t = {.program = *p, .shown = &e, .shown_count = 1, .order = -1};
    bool holds[MOST_SHOWN] = {false};
    t.needed = xrealloc(NULL, (size_t)p->count, 1);
    t.variables = xrealloc(NULL, (size_t)p->inputs + 1, sizeof *t.variables);
    memset(t.needed, 1, (size_t)p->count);
    for (int i = 0; i < p->inputs; i++)
        t.variables[i] = (struct variable){.signs = SIGN_ANY};
    identities_broken(&t, loose, holds);
    free(t.needed);
    free(t.variables);
    return holds[0];
}

/* ---- where they hold ---- */

char *identities_domain(const struct identities *t)
{
    static const char *const bounds[] = {[SIGN_POSITIVE] = " > 0", [SIGN_POSITIVE | SIGN_ZERO] = " >= 0", [SIGN_ANY] = ""};
    char *text = NULL;
    const char *separator = "";
    size_t size;
    FILE *out = open_memstream(&text, &size);
    if (out == NULL)
        out_of_memory();
    for (int i = 0; i < t->program.inputs; i++) {
        const struct variable *v = &t->variables[i];
        if (!t->needed[i] || (!v->angle && v->power == 0 && v->signs == SIGN_ANY))
            continue;
        fprintf(out, "%s%s%s", separator, t->program.names[i].text, v->angle ? "" : bounds[v->signs]);
        fputs(v->quarter_turn ? " within a quarter turn" : v->angle ? " any angle" : "", out);
        fputs(v->power > 0 ? " small" : "", out);
        separator = ", ";
    }
    for (int i = 0; i < t->sheet_lets; i++) {
        fprintf(out, "%s%s", separator, t->lets[i]);
        separator = ", ";
    }
    if (*separator == '\0')
        fputs("all values", out);
    if (fclose(out) != 0)
        out_of_memory();
    return text;
}
