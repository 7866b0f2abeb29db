/* The proof of a derivation step. */
#include "derivation.h"

#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "degree.h"
#include "series.h"

_Static_assert(FLINT_BITS == 64, "numbers are drawn from 64 bits");

/* ---- what is known of a trial before its proof ---- */

static void mark_needed(struct trial *t)
{
    const size_t count = (size_t)t->program.count;
    char *one = memory(NULL, count, 1);
    t->needed = memory(NULL, count, 1);
    memset(t->needed, 0, count);
    for (int i = 0; i < 2 * t->shown_count; i++) {
        int side = i % 2 ? t->shown[i / 2].left : t->shown[i / 2].right;
        program_needs(&t->program, side, NULL, one);
        for (int k = 0; k <= side; k++)
            t->needed[k] |= one[k];
    }
    free(one);
}

/* An arc tangent has a square root in it, the distance of its point from the origin: it is appended. */
static void find_radicals(struct trial *t)
{
    struct program *p = &t->program;
    const int count = p->count;
    t->radicals = memory(NULL, (size_t)count, sizeof *t->radicals);
    for (int i = 0; i < count; i++) {
        const struct node node = p->nodes[i];
        if (t->needed[i] && node.op == OPERATOR_SQRT)
            t->radicals[t->radical_count++] = i;
        if (t->needed[i] && node.op == OPERATOR_ATAN2) {
            int y = program_append(p, OPERATOR_MULTIPLY, node.left, node.left, 0);
            int x = program_append(p, OPERATOR_MULTIPLY, node.right, node.right, 0);
            int distance = program_append(p, OPERATOR_ADD, y, x, 0);
            t->radicals[t->radical_count++] = program_append(p, OPERATOR_SQRT, distance, -1, 0);
        }
    }
}

static struct degree drawn_degree(const struct variable *v)
{
    if (v->kind == KIND_ANGLE)
        return (struct degree){.point_num = 2, .point_den = 2, .sign = SIGN_RIGHT_ANGLE};
    enum sign finite = v->kind == KIND_POSITIVE ? SIGN_POSITIVE : SIGN_UNKNOWN;
    return (struct degree){.num = 1, .sign = v->power > 0 ? SIGN_ZERO : finite};
}

void trial_prepare(struct trial *t)
{
    struct machine degrees;
    mark_needed(t);
    find_radicals(t);
    machine_init(&degrees, &t->program, &arithmetic_degree, t->terms);
    for (int i = 0; i < t->program.inputs; i++)
        *(struct degree *)machine_value(&degrees, i) = drawn_degree(&t->variables[i]);
    machine_run(&degrees);
    for (int i = 0; i < t->program.count; i++) { /* no divisor may be beyond the limit */
        const struct degree *d = machine_value(&degrees, i);
        if (FLINT_MAX(d->num, d->den) >= DEGREE_LIMIT || t->program.count >= NODE_LIMIT)
            t->degree = DEGREE_LIMIT;
    }
    for (int i = 0; i < t->shown_count; i++) {
        struct equality *e = &t->shown[i];
        e->degree = degree_of_difference(machine_value(&degrees, e->left), machine_value(&degrees, e->right));
        t->degree = FLINT_MAX(t->degree, e->degree);
    }
    for (int k = 0; k < t->root_count; k++) {
        const struct degree *root = machine_value(&degrees, t->roots[k].node);
        const struct degree square = {.num = 2 * root->num, .den = 2 * root->den};
        t->roots[k].positive = root->sign == SIGN_POSITIVE;
        for (int i = 0; i < t->radical_count; i++) { /* whichever root it will be */
            int radicand = t->program.nodes[t->radicals[i]].left;
            t->degree = FLINT_MAX(t->degree, degree_of_difference(machine_value(&degrees, radicand), &square));
        }
    }
    machine_clear(&degrees);
}

/* ---- points ---- */

/* splitmix64: Steele, Lea, Flood, "Fast splittable pseudorandom number generators", OOPSLA 2014 */
static uint64_t next_random(uint64_t *state)
{
    uint64_t z = *state += UINT64_C(0x9e3779b97f4a7c15);
    z = (z ^ (z >> 30)) * UINT64_C(0xbf58476d1ce4e5b9);
    z = (z ^ (z >> 27)) * UINT64_C(0x94d049bb133111eb);
    return z ^ (z >> 31);
}

/* 1 ... 2^64; -2^63 ... 2^63 - 1; of an angle t with |t| > 1, -2^63 - 1 ... -2 and 2 ... 2^63 + 1 */
static void draw_large(fmpz_t x, enum kind kind, uint64_t bits)
{
    fmpz_set_ui(x, bits);
    if (kind == KIND_POSITIVE) {
        fmpz_add_ui(x, x, 1);
        return;
    }
    fmpz_sub_ui(x, x, UINT64_C(1) << 63);
    if (kind == KIND_ANGLE && fmpz_sgn(x) >= 0)
        fmpz_add_ui(x, x, 2);
    else if (kind == KIND_ANGLE)
        fmpz_sub_ui(x, x, 1);
}

/* Numbers that a reader can follow, to show what is false; they prove nothing. */
static void draw_small(fmpz_t x, enum kind kind, uint64_t bits)
{
    slong size = kind == KIND_ANGLE ? 2 + (slong)(bits / 2 % 3) : 1 + (slong)(bits / 2 % 9);
    fmpz_set_si(x, kind == KIND_ANY && bits % 2 ? -size : size);
}

/* cosine (t^2 - 1)/(t^2 + 1), sine 2t/(t^2 + 1) */
static void circle_point(fmpq_t c, fmpq_t s, const fmpz_t t)
{
    fmpz_t square;
    fmpz_init(square);
    fmpz_mul(square, t, t);
    fmpz_sub_ui(fmpq_numref(c), square, 1);
    fmpz_add_ui(fmpq_denref(c), square, 1);
    fmpz_mul_ui(fmpq_numref(s), t, 2);
    fmpz_add_ui(fmpq_denref(s), square, 1);
    fmpq_canonicalise(c);
    fmpq_canonicalise(s);
    fmpz_clear(square);
}

static void evaluate(const struct trial *t, const fmpz *point, struct machine *m)
{
    fmpq_t c, s;
    fmpq_init(c);
    fmpq_init(s);
    for (int i = 0; i < t->program.inputs; i++) {
        if (t->variables[i].kind == KIND_ANGLE) {
            circle_point(c, s, point + i);
            series_set_angle(machine_value(m, i), c, s);
        } else {
            series_set_monomial(machine_value(m, i), point + i, t->variables[i].power);
        }
    }
    fmpq_clear(c);
    fmpq_clear(s);
    machine_run(m);
}

/* ---- what a point shows ---- */

struct outcome {
    enum finding finding;
    enum series_fault fault;   /* FOUND_NOTHING: why            */
    const struct equality *at; /* FOUND_DIFFERENT: where,           */
    slong power;               /* at which power of epsilon */
};

static struct outcome compare(const struct trial *t, const struct machine *m)
{
    struct outcome o = {.finding = FOUND_EQUAL};
    fmpq_t left, right;
    fmpq_init(left);
    fmpq_init(right);
    for (int i = 0; i < t->shown_count && o.finding == FOUND_EQUAL; i++) {
        o.at = &t->shown[i];
        o.fault = series_state(machine_value(m, o.at->left));
        if (o.fault == SERIES_FINE)
            o.fault = series_state(machine_value(m, o.at->right));
        if (o.fault != SERIES_FINE)
            o.finding = FOUND_NOTHING;
        for (slong k = 0; k < t->terms && o.finding == FOUND_EQUAL; k++) {
            series_get_fmpq(left, machine_value(m, o.at->left), k);
            series_get_fmpq(right, machine_value(m, o.at->right), k);
            o.power = k;
            if (!fmpq_equal(left, right))
                o.finding = FOUND_DIFFERENT;
        }
    }
    fmpq_clear(left);
    fmpq_clear(right);
    return o;
}

/*
 * Every square root is one of the roots: which, the first point tells (match[i] < 0: not known yet), and
 * the others have to agree. Both are positive, so that equal values mean equal squares. The index of a
 * radical that is none of them, or -1.
 */
static int unmatched_radical(const struct trial *t, const struct machine *m, int *match)
{
    int unmatched = -1;
    fmpq_t value, root;
    fmpq_init(value);
    fmpq_init(root);
    for (int i = 0; i < t->radical_count && unmatched < 0; i++) {
        series_get_fmpq(value, machine_value(m, t->radicals[i]), 0);
        const int first = match[i] < 0 ? 0 : match[i], last = match[i] < 0 ? t->root_count - 1 : match[i];
        match[i] = -1;
        for (int k = first; k <= last && match[i] < 0; k++) {
            series_get_fmpq(root, machine_value(m, t->roots[k].node), 0);
            if (fmpq_equal(value, root))
                match[i] = k;
        }
        if (match[i] < 0)
            unmatched = i;
    }
    fmpq_clear(value);
    fmpq_clear(root);
    return unmatched;
}

/* ---- evidence ---- */

static void print_fmpq(FILE *out, const fmpq_t q)
{
    char *text = fmpq_get_str(NULL, 10, q);
    fputs(text, out);
    flint_free(text);
}

static void print_coefficient(FILE *out, const struct machine *m, int node, slong power)
{
    fmpq_t q;
    fmpq_init(q);
    series_get_fmpq(q, machine_value(m, node), power);
    print_fmpq(out, q);
    fmpq_clear(q);
}

static void print_point(FILE *out, const struct trial *t, const struct machine *m)
{
    const char *separator = ", where ";
    for (int i = 0; i < t->program.inputs; i++) {
        const struct series *value = machine_value(m, i);
        if (!t->needed[i])
            continue;
        fprintf(out, "%s%s = ", separator, t->program.names[i].text);
        separator = ", ";
        if (t->variables[i].kind == KIND_ANGLE) {
            fputs("the angle of cosine ", out);
            print_fmpq(out, value->c);
            fputs(" and sine ", out);
            print_fmpq(out, value->s);
        } else {
            print_coefficient(out, m, i, t->variables[i].power);
            fputs(t->variables[i].power > 0 ? " epsilon" : "", out);
        }
    }
}

static char *evidence(const struct trial *t, const struct machine *m, const struct outcome *o, int radical)
{
    char *text = NULL;
    size_t size;
    FILE *out = open_memstream(&text, &size);
    if (out == NULL)
        out_of_memory();
    if (radical >= 0) {
        fputs("a square root is ", out);
        print_coefficient(out, m, t->radicals[radical], 0);
        fputs(", none of the roots", out);
    } else if (o->finding == FOUND_DIFFERENT) {
        fprintf(out, "%s: ", o->at->text);
        print_coefficient(out, m, o->at->left, o->power);
        fputs(" is not ", out);
        print_coefficient(out, m, o->at->right, o->power);
        if (t->terms > 1)
            fprintf(out, ", the coefficients of epsilon^%ld", (long)o->power);
    } else {
        fprintf(out, "%s: no value, %s", o->at->text, series_fault_text(o->fault));
    }
    print_point(out, t, m);
    if (fclose(out) != 0)
        out_of_memory();
    return text;
}

/* ---- proofs ---- */

enum { MOST_RETRIES = 16, SMALL_POINTS = 8 };

/* Another point may do where this one met a pole, or a root that is no rational number. */
static bool bad_luck(const struct outcome *o)
{
    return o->finding == FOUND_NOTHING && (o->fault == SERIES_POLE || o->fault == SERIES_NO_SQUARE);
}

static struct outcome try_point(const struct trial *t, uint64_t *state, bool small, fmpz *point,
                                struct machine *m)
{
    for (int i = 0; i < t->program.inputs; i++)
        (small ? draw_small : draw_large)(point + i, t->variables[i].kind, next_random(state));
    evaluate(t, point, m);
    return compare(t, m);
}

static void try_small_points(const struct trial *t, uint64_t *state, struct machine *m, struct proof *p)
{
    for (int i = 0; i < SMALL_POINTS; i++) {
        struct outcome o = try_point(t, state, true, p->drawn, m);
        if (bad_luck(&o))
            continue;
        p->finding = o.finding;
        p->evidence = o.finding != FOUND_EQUAL ? evidence(t, m, &o, -1) : NULL;
        return;
    }
}

static void try_large_points(const struct trial *t, uint64_t *state, int points, struct machine *m,
                             struct proof *p)
{
    int *match = memory(NULL, (size_t)t->radical_count, sizeof *match);
    for (int i = 0; i < t->radical_count; i++)
        match[i] = -1;
    while (p->finding == FOUND_EQUAL && p->points < points) {
        struct outcome o = try_point(t, state, false, p->drawn + (slong)p->points * t->program.inputs, m);
        if (bad_luck(&o) && p->retries < MOST_RETRIES) {
            p->retries++;
            continue;
        }
        int radical = o.finding == FOUND_EQUAL ? unmatched_radical(t, m, match) : -1;
        p->finding = radical < 0 ? o.finding : FOUND_NOTHING;
        if (p->finding == FOUND_EQUAL)
            p->points++;
        else
            p->evidence = evidence(t, m, &o, radical);
    }
    free(match);
}

void trial_prove(const struct trial *t, ulong seed, struct proof *p)
{
    const int bits = 63 - (int)FLINT_BIT_COUNT(t->degree); /* degree/2^63 < 2^-bits */
    const int points = (ENOUGH_BITS + bits - 1) / bits;
    struct machine m;
    uint64_t state = seed;
    *p = (struct proof){.finding = FOUND_EQUAL, .drawn = _fmpz_vec_init((slong)points * t->program.inputs)};
    machine_init(&m, &t->program, &arithmetic_series, t->terms);
    try_small_points(t, &state, &m, p);
    try_large_points(t, &state, points, &m, p);
    p->bits = bits * p->points;
    p->allocated = points * t->program.inputs;
    machine_clear(&m);
}

void proof_clear(struct proof *p)
{
    _fmpz_vec_clear(p->drawn, p->allocated);
    free(p->evidence);
}
