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
    if (q->decimal == NULL && formula_rational(exact, &q->formula, &b)) {
        arb_set_fmpq(x, exact, LAST);
        q->decimal = q->rounding == AS_RATIONAL ? rational_text(exact) : number_text(q, x, exact);
    }
    for (; q->decimal == NULL && b.bits <= LAST; b.bits *= 4) {
        formula_enclose(x, &q->formula, &b);
        q->decimal = number_text(q, x, NULL);
    }
}

/* ---- the verdict ---- */

enum truth truth_both(enum truth a, enum truth b)
{
    return a == FOUND_FALSE || b == FOUND_FALSE ? FOUND_FALSE : a == FOUND_TRUE && b == FOUND_TRUE ? FOUND_TRUE : UNDECIDED;
}

/* The first assertion that is not as the condition wants it; -1: all are. */
static int first_failed(struct statements *all, struct statement *s, const struct verdict_condition *c, enum how *how)
{
    for (int i = 0; i < s->assertion_count; i++) {
        struct assertion *a = &s->assertions[i];
        if (c->wanted[i] == 0)
            continue;
        assertion_find(all, s, a);
        *how = FLINT_MAX(*how, a->how);
        if (a->truth != (c->wanted[i] == 1 ? FOUND_TRUE : FOUND_FALSE))
            return i;
    }
    return -1;
}

void statement_decide(struct statements *all, struct statement *s, struct ruling *r)
{
    static const char *const findings[] = {"found neither true nor false", "true", "false", "true by a bound that is not within ten"};
    *r = (struct ruling){.verdict = VERDICT_NONE};
    const int failed = first_failed(all, s, &s->conditions[0], &r->how);
    r->as_written = failed < 0;
    for (int i = 0; i < s->verdict_count; i++)
        if (first_failed(all, s, &s->conditions[i], &r->how) < 0)
            r->verdict = s->verdicts[i];
    if (!r->as_written)
        node_message(&r->open, s->assertions[failed].node, 0, "%s comes out as '%s', its evidence is written for '%s': '%s' is %s", s->id,
                     verdict_names[r->verdict], verdict_names[s->verdicts[0]], s->assertions[failed].name,
                     findings[s->assertions[failed].truth]);
    for (int i = 0; i < s->number_count && r->as_written; i++) {
        struct quoted_number *q = &s->numbers[i];
        number_decide(all, s, q);
        r->how = FLINT_MAX(r->how, q->how);
        if (q->decimal == NULL) {
            node_message(&r->open, q->node, q->offset, "%s: the digits of %.100s cannot be proved", s->id, q->text);
            r->as_written = false;
            r->verdict = VERDICT_NONE;
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
