/*
 * claims.h   what the suites of the ledger share: a claim yields its verdict, and says a number that was
 *            found by another road. A suite includes this once, with its lists of claims in `lists` and
 *            what it expects in `expected`.
 */
#ifndef COULOMBTETHER_TESTS_CLAIMS_H
#define COULOMBTETHER_TESTS_CLAIMS_H

#include <ctype.h>
#include <string.h>

#include "run.h"
#include "verify/claims.h"
#include "verify/sheet.h"

struct expected_claim {
    const char *id;
    enum verdict verdict;
    enum how how;
    const char *says; /* a number of the evidence, by another road */
};

extern const struct claim *const lists[];      /* ended by NULL */
extern const struct expected_claim expected[]; /* ended by one without id */

static void close_all(void)
{
    sheet_close();
    flint_cleanup();
}

static const struct claim *claim_find(const char *id)
{
    for (int l = 0; lists[l] != NULL; l++)
        for (const struct claim *c = lists[l]; c->id != NULL; c++)
            if (strcmp(c->id, id) == 0)
                return c;
    ck_abort_msg("no claim %s", id);
    return NULL;
}

START_TEST(claims_yield_their_verdicts)
{
    struct evidence e = {0};
    claim_find(expected[_i].id)->decide(&e);
    ck_assert_str_eq(verdict_names[e.verdict], verdict_names[expected[_i].verdict]);
    ck_assert_str_eq(how_names[e.how], how_names[expected[_i].how]);
    ck_assert_msg(strstr(e.text, expected[_i].says) != NULL, "no '%s' in: %s", expected[_i].says, e.text);
    ck_assert_uint_lt(strlen(e.text), sizeof e.text - 1); /* not cut */
    if (e.verdict == HOLDS || e.verdict == DEFINITION)
        ck_assert_ptr_null(e.why);
    else
        ck_assert_ptr_nonnull(e.why);
    for (const char *at = e.text; *at != '\0'; at++)
        ck_assert_msg(isprint((unsigned char)*at), "byte %d in: %s", *at, e.text);
}
END_TEST

START_TEST(claims_are_well_formed)
{
    for (int l = 0; lists[l] != NULL; l++)
        for (const struct claim *c = lists[l]; c->id != NULL; c++) {
            int listed = 0;
            for (int i = 0; expected[i].id != NULL; i++)
                listed += strcmp(expected[i].id, c->id) == 0;
            ck_assert_msg(listed > 0, "%s is not tested here", c->id);
            ck_assert_ptr_eq(claim_find(c->id), c); /* no id twice */
            ck_assert_uint_eq(strspn(c->id, "abcdefghijklmnopqrstuvwxyz0123456789-"), strlen(c->id));
            ck_assert_uint_gt(strlen(c->where), 0);
            ck_assert_uint_gt(strlen(c->claim), 0);
        }
}
END_TEST

#endif
