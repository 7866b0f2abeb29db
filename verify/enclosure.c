#include "enclosure.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "decimal.h"
#include "sheet.h"

/* ---- a formula at work ---- */

struct worker {
    struct program program;
    struct machine machine;
    int x, ln_x, node; /* -1: x is not known; the text was refused */
};

static void worker_know(struct worker *w, const char *name, arb_srcptr value)
{
    int node = program_find(&w->program, name);
    if (node >= 0)
        arb_set(machine_value(&w->machine, node), value);
}

static bool sheet_value(arb_t z, const struct quantity *q)
{
    fmpq_t value;
    fmpq_init(value);
    bool known = q->value != NULL && literal_read(value, q->value, true) == LITERAL_FINITE;
    arb_set_fmpq(z, value, ENCLOSURE_BITS);
    fmpq_clear(value);
    return known;
}

/* A moving x is set at every turn. What the caller knows comes before what the sheet does. */
static void worker_init(struct worker *w, const char *text, const struct known *known, bool moving)
{
    const struct sheet *s = sheet();
    size_t where;
    struct message why;
    arb_t z;
    arb_init(z);
    program_init(&w->program);
    if (moving)
        program_input(&w->program, "x");
    for (const struct known *k = known; k->name != NULL; k++)
        program_input(&w->program, k->name);
    for (int i = 0; i < s->quantity_count; i++)
        if (s->quantities[i].value != NULL && program_find(&w->program, s->quantities[i].name) < 0)
            program_input(&w->program, s->quantities[i].name);
    program_input(&w->program, "pi");
    w->x = program_find(&w->program, "x");
    w->ln_x = w->x < 0 ? -1 : program_input(&w->program, "ln_x");
    w->node = program_parse(&w->program, text, &where, &why);
    machine_init(&w->machine, &w->program, &arithmetic_ball, ENCLOSURE_BITS);
    arb_const_pi(z, ENCLOSURE_BITS);
    worker_know(w, "pi", z);
    for (int i = 0; i < s->quantity_count; i++)
        if (sheet_value(z, &s->quantities[i]))
            worker_know(w, s->quantities[i].name, z);
    for (const struct known *k = known; k->name != NULL; k++)
        worker_know(w, k->name, k->value);
    arb_clear(z);
}

static void worker_clear(struct worker *w)
{
    machine_clear(&w->machine);
    program_clear(&w->program);
}

/* x = NULL: as it was known */
static void worker_value(struct worker *w, arb_t z, const arb_struct *x)
{
    arb_indeterminate(z);
    if (w->node < 0)
        return;
    if (x != NULL)
        arb_set(machine_value(&w->machine, w->x), x);
    if (w->x >= 0)
        arb_log(machine_value(&w->machine, w->ln_x), machine_value(&w->machine, w->x), ENCLOSURE_BITS);
    machine_run(&w->machine);
    arb_set(z, machine_value(&w->machine, w->node));
}

void enclose(arb_t z, const char *text, const struct known *known)
{
    struct worker w;
    worker_init(&w, text, known, false);
    worker_value(&w, z, NULL);
    worker_clear(&w);
}

bool positive_at(const char *text, const struct known *known)
{
    arb_t z;
    arb_init(z);
    enclose(z, text, known);
    bool positive = arb_is_positive(z);
    arb_clear(z);
    return positive;
}

/* ---- whole intervals ---- */

static bool positive_between(struct worker *w, const arb_t low, const arb_t high, int depth)
{
    arb_t x, z, middle;
    arb_init(x);
    arb_init(z);
    arb_init(middle);
    arb_union(x, low, high, ENCLOSURE_BITS);
    worker_value(w, z, x);
    bool positive = arb_is_positive(z);
    if (!positive && depth > 0) {
        arb_get_mid_arb(middle, x);
        positive = positive_between(w, low, middle, depth - 1) &&
                   positive_between(w, middle, high, depth - 1);
    }
    arb_clear(x);
    arb_clear(z);
    arb_clear(middle);
    return positive;
}

bool positive_on(const char *text, const char *low, const char *high, const struct known *known)
{
    enum { DEEPEST = 16 };
    struct worker w;
    arb_t a, b;
    arb_init(a);
    arb_init(b);
    enclose(a, low, known);
    enclose(b, high, known);
    worker_init(&w, text, known, true);
    bool positive = arb_is_finite(a) && arb_is_finite(b) && positive_between(&w, a, b, DEEPEST);
    worker_clear(&w);
    arb_clear(a);
    arb_clear(b);
    return positive;
}

/* -1, 1, or 0: not certain */
static int sign_at(struct worker *w, const arb_t x)
{
    arb_t z;
    arb_init(z);
    worker_value(w, z, x);
    int sign = arb_is_positive(z) ? 1 : arb_is_negative(z) ? -1 : 0;
    arb_clear(z);
    return sign;
}

/* A point between a and b where the sign is certain: the middle or, as that may be the root, an eighth beside it. */
static int sign_between(struct worker *w, arb_t x, const arb_t a, const arb_t b)
{
    arb_t step;
    arb_init(step);
    arb_add(x, a, b, ENCLOSURE_BITS);
    arb_mul_2exp_si(x, x, -1);
    arb_get_mid_arb(x, x);
    int sign = sign_at(w, x);
    if (sign == 0) {
        arb_sub(step, b, a, ENCLOSURE_BITS);
        arb_mul_2exp_si(step, step, -3);
        arb_add(x, x, step, ENCLOSURE_BITS);
        arb_get_mid_arb(x, x);
        sign = sign_at(w, x);
    }
    arb_clear(step);
    return sign;
}

bool change_of_sign(arb_t x, const char *text, const char *low, const char *high,
                    const struct known *known)
{
    enum { HALVINGS = 100 }; /* fewer where rounding hides the sign before */
    struct worker w;
    arb_t a, b, between;
    arb_init(a);
    arb_init(b);
    arb_init(between);
    enclose(a, low, known);
    enclose(b, high, known);
    worker_init(&w, text, known, true);
    const int left = sign_at(&w, a);
    const bool found = left * sign_at(&w, b) < 0;
    int sign = left;
    for (int i = 0; found && sign != 0 && i < HALVINGS; i++) {
        sign = sign_between(&w, between, a, b);
        if (sign != 0)
            arb_set(sign == left ? a : b, between);
    }
    arb_indeterminate(x);
    if (found)
        arb_union(x, a, b, ENCLOSURE_BITS);
    worker_clear(&w);
    arb_clear(a);
    arb_clear(b);
    arb_clear(between);
    return found;
}

/* ---- numbers as people write them ---- */

/* d.ddde+XX with its point where people put it, for exponents from -4 to 6 */
static void plain(char *to, size_t size, const char *scientific)
{
    const char *mark = strchr(scientific, 'e');
    const long exponent = mark == NULL ? 0 : strtol(mark + 1, NULL, 10);
    char figures[40] = "";
    int count = 0;
    for (const char *at = scientific; *at != '\0' && *at != 'e' && count < 39; at++)
        if (*at >= '0' && *at <= '9')
            figures[count++] = *at;
    const char *sign = *scientific == '-' ? "-" : "";
    const int whole = (int)exponent + 1; /* figures before the point */
    if (exponent < -4 || exponent > 6)
        snprintf(to, size, "%s", scientific);
    else if (whole <= 0)
        snprintf(to, size, "%s0.%.*s%s", sign, -whole, "000", figures);
    else if (whole >= count)
        snprintf(to, size, "%s%s%.*s", sign, figures, whole - count, "000000");
    else
        snprintf(to, size, "%s%.*s.%s", sign, whole, figures, figures + whole);
}

const char *number(struct numbers *n, const arb_t x, slong digits)
{
    char *decimal = NULL, *slot = n->text[n->count % 32];
    if (n->count++ < 32)
        decimal = decimal_of_ball(x, digits);
    n->proved = n->proved && decimal != NULL;
    if (decimal != NULL)
        plain(slot, sizeof n->text[0], decimal);
    else
        snprintf(slot, sizeof n->text[0], "undecided");
    free(decimal);
    return slot;
}

const char *number_of(struct numbers *n, slong digits, const char *text, const struct known *known)
{
    arb_t z;
    arb_init(z);
    enclose(z, text, known);
    const char *decimal = number(n, z, digits);
    arb_clear(z);
    return decimal;
}
