/* The verdict on a statement: which of its conditions is true, and whether the numbers of its evidence are proved. */
#include "claims/statement.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "text/decimal.h"
#include "text/scope.h"

const char *const verdict_names[] = {"undecided", "refuted", "not decidable", "qualified", "holds as corrected", "holds", "definition"};
const char *const how_names[] = {"exact", "certified"};

/* ---- numbers ---- */

/* d.ddde-05 without an exponent where it takes few zeros. */
static char *plain_decimal(const char *scientific)
{
    struct tex t = {NULL, 0};
    const char *digits = scientific + (*scientific == '-'), *mark = strchr(digits, 'e');
    const slong exponent = mark != NULL ? strtol(mark + 1, NULL, 10) : 0; /* "0" has none */
    const slong count = mark != NULL ? mark - digits - (digits[1] == '.') : 1;
    const slong places = FLINT_MAX(count - 1 - exponent, 0);
    if (exponent < -4 || exponent > 6)
        return text_copy(scientific);
    tex_add(&t, "%s", *scientific == '-' ? "-" : "");
    for (slong power = FLINT_MAX(exponent, 0); power >= -places; power--) {
        const slong k = exponent - power;
        tex_add(&t, "%s%c", power == -1 ? "." : "", k < 0 || k >= count ? '0' : digits[k + (k > 0)]);
    }
    return t.text;
}

/* Its digits, where the enclosure or, if it is rational, the number itself decides them. */
static char *number_text(const struct quoted_number *q, const arb_t x, const fmpq_t exact)
{
    if (q->rounding == AS_RATIONAL || !arb_is_finite(x)) /* what is quoted as a rational number has no digits */
        return NULL;
    char *text = q->rounding != TO_DIGITS ? decimal_of_end(x, q->digits, q->rounding == UPWARD)
                 : exact != NULL          ? decimal_of_rational(exact, q->digits)
                                          : decimal_of_ball(x, q->digits);
    char *plain = text != NULL ? plain_decimal(text) : NULL;
    free(text);
    return plain;
}

static char *rational_text(const fmpq_t x)
{
    char *own = fmpq_get_str(NULL, 10, x), *text = text_copy(own);
    flint_free(own);
    return text;
}

/* Its digits, proved: NULL where that fails. */
static void number_decide(struct statements *all, struct statement *s, struct quoted_number *q)
{
    enum { FIRST = 128, LAST = 2048 };
    struct bindings b = {.all = all, .statement = s, .at = &s->at, .at_count = s->at.count, .bits = FIRST, .how = &q->how};
    SCOPE(fmpq, exact);
    SCOPE(arb, x);
    if (q->decimal == NULL && formula_rational(exact, q->formula, &b)) {
        arb_set_fmpq(x, exact, LAST);
        q->decimal = q->rounding == AS_RATIONAL ? rational_text(exact) : number_text(q, x, exact);
    }
    for (; q->decimal == NULL && b.bits <= LAST; b.bits *= 4) {
        formula_enclose(x, q->formula, &b);
        q->decimal = number_text(q, x, NULL);
    }
}

/* ---- conditions ---- */

enum truth truth_not(enum truth t)
{
    return t == FOUND_TRUE ? FOUND_FALSE : t == FOUND_FALSE ? FOUND_TRUE : UNDECIDED;
}

enum truth truth_both(enum truth a, enum truth b)
{
    return a == FOUND_FALSE || b == FOUND_FALSE ? FOUND_FALSE : a == FOUND_TRUE && b == FOUND_TRUE ? FOUND_TRUE : UNDECIDED;
}

struct deciding {
    struct statements *all;
    struct statement *statement;
    int without; /* what is left out */
    enum how how;
};

/* Whether one of these assertions is left out, or rests on it. */
static bool any_void(const struct deciding *d, ulong of)
{
    bool lost = false;
    for (int k = 0; k < d->statement->assertion_count; k++)
        if ((of >> k & 1) != 0)
            lost = lost || d->without == k || any_void(d, d->statement->assertions[k].uses);
    return lost;
}

static enum truth truth_of(struct deciding *d, int index)
{
    struct assertion *a = &d->statement->assertions[index];
    if (any_void(d, UWORD(1) << index))
        return UNDECIDED;
    assertion_find(d->all, d->statement, a);
    d->how = FLINT_MAX(d->how, a->how);
    return a->truth;
}

/* Whether all that it wants is so; *failed: the first assertion that is not, -1: none. */
static enum truth condition_decide(struct deciding *d, const struct verdict_condition *c, int *failed)
{
    enum truth truth = FOUND_TRUE;
    *failed = -1;
    for (int i = 0; i < d->statement->assertion_count; i++) {
        if (c->wanted[i] == 0)
            continue;
        const enum truth found = c->wanted[i] == 1 ? truth_of(d, i) : truth_not(truth_of(d, i));
        truth = truth_both(truth, found);
        if (found != FOUND_TRUE && *failed < 0)
            *failed = i;
    }
    return truth;
}

/* ---- the verdict ---- */

static void leave_open(struct ruling *r, const struct yaml *at, size_t offset, const char *text)
{
    if (r->open.text[0] == '\0')
        node_message(&r->open, at, offset, "%s", text);
}

static void decide_numbers(struct deciding *d, struct ruling *r)
{
    struct statement *s = d->statement;
    char text[256];
    for (int i = 0; i < s->number_count; i++) {
        struct quoted_number *q = &s->numbers[i];
        number_decide(d->all, s, q);
        d->how = FLINT_MAX(d->how, q->how);
        if (q->decimal == NULL || any_void(d, q->formula->uses)) {
            snprintf(text, sizeof text, "%s: the digits of %.100s cannot be proved", s->id, q->text);
            leave_open(r, q->node, q->offset, text);
            r->as_written = false;
        }
    }
}

void statement_decide(struct statements *all, struct statement *s, int without, struct ruling *r)
{
    static const char *const findings[] = {"found neither true nor false", "true", "false", "true by a bound that is not within ten"};
    struct deciding d = {.all = all, .statement = s, .without = without};
    char text[384];
    int found = -1, many = 0, failed, entry = -1;
    *r = (struct ruling){.verdict = VERDICT_NONE, .as_written = true};
    for (int i = 0; i < s->verdict_count; i++) {
        if (condition_decide(&d, &s->conditions[i], &failed) == FOUND_TRUE) {
            found = i;
            many++;
        }
        entry = i == 0 ? failed : entry;
    }
    if (many == 1)
        r->verdict = s->verdicts[found];
    r->as_written = found == 0; /* the last that is true: the only one */
    if (many > 1)
        snprintf(text, sizeof text, "%s is undecided: more than one of its conditions is true", s->id);
    else if (entry >= 0) {
        const struct assertion *a = &s->assertions[entry];
        if (many == 1)
            snprintf(text, sizeof text, "%s comes out as '%s', its evidence is written for '%s': '%s' is %s", s->id,
                     verdict_names[r->verdict], verdict_names[s->verdicts[0]], a->name, findings[a->truth]);
        else
            snprintf(text, sizeof text, "%s is undecided: '%s' is %s", s->id, a->name, findings[a->truth]);
    }
    if (!r->as_written)
        leave_open(r, many > 1 ? s->verdict : s->assertions[entry].node, 0, text);
    decide_numbers(&d, r);
    r->how = d.how;
    if (!r->as_written && found == 0)
        r->verdict = VERDICT_NONE; /* a number is missing */
}

void statement_rule(struct statements *all, struct statement *s, struct ruling *r)
{
    char text[256];
    statement_decide(all, s, NONE_LEFT_OUT, r);
    for (int i = 0; i < s->assertion_count; i++) {
        struct ruling without;
        statement_decide(all, s, i, &without);
        if (without.as_written) {
            snprintf(text, sizeof text, "%s stands without '%s', or with its contrary", s->id, s->assertions[i].name);
            leave_open(r, s->assertions[i].node, 0, text);
            r->as_written = false;
        }
    }
}

/* ---- the evidence ---- */

void statement_evidence(const struct statement *s, struct written *w)
{
    const struct quoted_number *q = s->numbers;
    const char *at = s->evidence;
    for (struct marked_part part = marked_next(&at); part.kind != PART_END; part = marked_next(&at))
        if (part.kind != PART_NUMBER)
            write_part(w, &part);
        else {
            write_decimal(w, q->decimal != NULL ? q->decimal : "undecided", q->decimal != NULL ? q->unit : NULL);
            q++;
        }
}
