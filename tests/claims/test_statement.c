/* Claims as data: what is asserted and found, the verdicts that follow, numbers with proved digits, and every mistake. */
#include "tests/run.h"
#include "tests/paper.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "claims/verdicts.h"
#include "evaluate/table1.h"

static struct derivations proofs;

static void open_all(void)
{
    open_steps(&proofs);
}

static void close_all(void)
{
    derivations_clear(&proofs);
    flint_cleanup();
}

/* A claim with that condition, these entries of `prove`, `given` and evidence; NULL: none. */
static void write_claim(char text[4096], const char *condition, const char *given, const char *prove, const char *evidence)
{
    snprintf(text, 4096, "c:\n  where: here\n  kind: beyond\n  claim: it is so\n  verdict: {holds: %s}\n%s%s%s%s%s\n  evidence: >-\n    %s\n",
             condition, given != NULL ? "  given: {" : "", given != NULL ? given : "", given != NULL ? "}\n" : "", "  prove:\n    ", prove,
             evidence != NULL ? evidence : "so it is");
}

static void read_claim(struct statements *s, const char *text)
{
    struct message why = {""};
    ck_assert_msg(statements_read(s, &proofs, &(struct source){"t", text, strlen(text)}, &why) == 0, "%s\n%s", why.text, text);
}

/* ---- assertions ---- */

static const struct {
    const char *given, *entry;
    enum truth truth;
    enum how how;
} assertions[] = {
    /* equalities for all values */
    {NULL, "a: eq05.x1 - eq05.x2 = L", FOUND_TRUE, EXACT},
    {NULL, "a: eq05.x1 + eq05.x2 = 0", FOUND_FALSE, EXACT},
    {"free: [u], let: {v: u^2}", "a: {algebra: (u + 1)^2 = v + 2*u + 1}", FOUND_TRUE, EXACT},
    {"free: [u], small: [u], order: 1", "a: {algebra: (1 + u)^3 = 1 + 3*u}", FOUND_TRUE, EXACT},
    {"free: [u], small: [u], order: 2", "a: {algebra: (1 + u)^3 = 1 + 3*u}", FOUND_FALSE, EXACT},
    {"angles: [psi, theta]", "a: eq25.w_2 = Omega*eq09.BO_23", FOUND_TRUE, EXACT},
    {"free: [u, u_dot], rates: {u: u_dot}", "a: {algebra: rate(u^2) = 2*u*u_dot}", FOUND_TRUE, EXACT},
    {NULL, "a: {algebra: (s + 1)^2 = s^2 + 1 + 2*s, free: [s]}", FOUND_TRUE, EXACT},
    /* at values, in exact numbers */
    {NULL, "a: {show: sqrt(x) = 3, at: {x: 9}}", FOUND_TRUE, EXACT},
    {NULL, "a: {show: sqrt(x) = 3, at: {x: 10}}", FOUND_FALSE, CERTIFIED},
    {NULL, "a: {show: x^2 = y, at: {x: [1, 2, -3], y: [1, 4, 9]}}", FOUND_TRUE, EXACT},
    {NULL, "a: {show: x^2 = y, at: {x: [1, 2, -3], y: [1, 4, -9]}}", FOUND_FALSE, EXACT},
    {NULL, "a: {show: x^2 = y, at: {x: [1, 2, -3], y: [-1, 4, 9]}}", FOUND_FALSE, EXACT}, /* I6: the first as well as the last */
    {"at: {z: 2}", "a: {show: z*x = y, at: {x: [1, 2], y: [2, 4]}}", FOUND_TRUE, EXACT}, /* one value at each turn */
    /* I1: signs */
    {NULL, "a: dL < L_ref", FOUND_TRUE, EXACT},
    {NULL, "a: dL > L_ref", FOUND_FALSE, EXACT},
    {NULL, "a: Omega < dL", FOUND_TRUE, EXACT},
    {NULL, "a: dL > Omega", FOUND_TRUE, EXACT},
    /* a bound that is a number is within ten, at one turn at least */
    {NULL, "a: dL < 0.99", FOUND_TRUE, EXACT},
    {NULL, "a: dL < 1.01", FOUND_LOOSE, EXACT},
    {NULL, "a: dL > 0.0101", FOUND_TRUE, EXACT},
    {NULL, "a: dL > 1/101", FOUND_LOOSE, EXACT},
    {NULL, "a: -dL < 2", FOUND_LOOSE, EXACT},
    {NULL, "a: dL > 2", FOUND_FALSE, EXACT},
    {NULL, "a: {show: x < 1, at: {x: [0.01, 0.2, 0.01]}}", FOUND_TRUE, EXACT},
    {NULL, "a: {show: x < 1, at: {x: [0.01, 0.02]}}", FOUND_LOOSE, EXACT},
    {NULL, "a: {show: x^2 < 1e-19, at: {x: 0 +- 1e-20}}", FOUND_TRUE, CERTIFIED},
    {NULL, "a: {show: x^2 < 1e-18, at: {x: 0 +- 1e-20}}", FOUND_LOOSE, CERTIFIED},
    {NULL, "a: dL < 100*L_ref", FOUND_TRUE, EXACT}, /* no number alone */
    {NULL, "a: exp(dL) > 11/10", FOUND_TRUE, CERTIFIED},
    {NULL, "a: {show: exp(x) > 1, at: {x: 1/10^60}}", FOUND_TRUE, CERTIFIED}, /* of 200 bits */
    {NULL, "a: L > 0", UNDECIDED, CERTIFIED}, /* L has no value */
    {NULL, "a: L + m1 > 0", UNDECIDED, CERTIFIED}, /* nor beside what has one, before it and after it */
    {NULL, "a: L + dL > 0", UNDECIDED, CERTIFIED},
    {NULL, "a: L + Omega > 0", UNDECIDED, CERTIFIED},
    {"at: {x: 1 +- 1/10}", "a: x > 0", FOUND_TRUE, CERTIFIED},
    {"at: {x: 1 +- 1/10}", "a: x > 1", UNDECIDED, CERTIFIED},
    {"at: {y: 2, x: y^2}", "a: {show: x > 4, at: {y: 3}}", FOUND_TRUE, EXACT}, /* its own y, and x by it */
    {"at: {n: 12}", "a: n > 11", FOUND_TRUE, EXACT}, /* not the sheet's 10 */
    {NULL, "a: {show: n < m, at: {n: [1, 2], m: [2, 3]}}", FOUND_TRUE, EXACT},
    {NULL, "a: {show: y > 1, on: {x: [2, 3]}, at: {y: x}}", UNDECIDED, CERTIFIED}, /* what moves has no value */
    {NULL, "a: {show: y > 0, on: {n: [-1, 1]}, at: {y: n}}", UNDECIDED, CERTIFIED}, /* not the sheet's either */
    /* I2: signs on intervals */
    {NULL, "a: {show: x^2 - x + 0.2501 > 0, on: {x: [0, 1]}}", FOUND_TRUE, CERTIFIED}, /* least 0.0001 */
    {NULL, "a: {show: x^2 - x + 0.25 > 0, on: {x: [0, 1]}}", UNDECIDED, CERTIFIED},    /* touches zero */
    {NULL, "a: {show: x^2 - x + 0.2501 < 0, on: {x: [0, 1]}}", FOUND_FALSE, CERTIFIED},
    {NULL, "a: {show: x - 1/2 > 0, on: {x: [0, 1]}}", FOUND_FALSE, CERTIFIED}, /* at one end */
    {NULL, "a: {show: 1/2 - x > 0, on: {x: [0, 1]}}", FOUND_FALSE, CERTIFIED}, /* at the other */
    {NULL, "a: {show: x < 200, on: {x: [0, 1]}}", FOUND_TRUE, CERTIFIED},
    {NULL, "a: {show: log(x) < x, on: {x: [1/2, 3]}}", FOUND_TRUE, CERTIFIED},
    {NULL, "a: {show: 1 > 0, on: {x: [0, 1/(1 - 1)]}}", UNDECIDED, CERTIFIED},
    /* I3: one root between bounds */
    {NULL, "a: {root: x^2 - 2, on: {x: [1, 2]}}", FOUND_TRUE, EXACT},
    {NULL, "a: {root: 3/2 - x, on: {x: [1, 2]}}", FOUND_TRUE, EXACT}, /* met exactly by halving */
    {NULL, "a: {root: x^2 - 2, on: {x: [2, 3]}}", FOUND_FALSE, EXACT},
    {NULL, "a: {root: x^2 - 2, on: {x: [-2, 2]}}", FOUND_FALSE, EXACT}, /* two */
    {NULL, "a: {root: (x - 1)^2, on: {x: [0, 3]}}", UNDECIDED, EXACT}, /* touches zero */
    {NULL, "a: {root: (x - 1)^2*(x - 2)*(x - 3), on: {x: [0, 5]}}", UNDECIDED, EXACT}, /* and crosses it twice then */
    {"at: {y: 1.25 +- 0.06}", "a: {root: x - y, on: {x: [1, 2]}}", FOUND_TRUE, CERTIFIED}, /* while the sign is certain */
    {NULL, "a: {root: x - 1, on: {x: [pi, 0]}}", UNDECIDED, EXACT}, /* reversed */
    {NULL, "a: {show: x > 0, on: {x: [pi, 1]}}", UNDECIDED, CERTIFIED},
    {NULL, "a: {root: x - 1, on: {x: [2, 0]}}", UNDECIDED, EXACT},
    {NULL, "a: {show: x > 0, on: {x: [1, m]}, at: {m: [2, 0]}}", UNDECIDED, CERTIFIED},
    {NULL, "a: {root: x - 1, on: {x: [1/(1 - 1), 3]}}", UNDECIDED, EXACT},
    {NULL, "a: {show: x > 0, on: {x: [1, 1]}}", FOUND_TRUE, CERTIFIED},
    {NULL, "a: {root: x^2 - 2, on: {x: [sqrt(2), 2]}}", FOUND_TRUE, EXACT}, /* ends belong to it, and to all their balls */
    {NULL, "a: {root: x^2 - 2, on: {x: [1, sqrt(2)]}}", FOUND_TRUE, EXACT},
    {NULL, "a: {root: exp(x) - n, on: {x: [0, 3]}}", FOUND_TRUE, CERTIFIED},
    /* I4: real roots, counted */
    {NULL, "a: {roots: (x - 1)^2*(x - 2)*(x + 3), on: {x: [0]}, count: 2}", FOUND_TRUE, EXACT}, /* different ones */
    {NULL, "a: {roots: (x - 1)^2*(x - 2)*(x + 3), on: {x: [-4]}, count: 3}", FOUND_TRUE, EXACT},
    {NULL, "a: {roots: (x - 1)^2*(x - 2)*(x + 3), on: {x: [1]}, count: 1}", FOUND_TRUE, EXACT}, /* not 1 itself */
    {NULL, "a: {roots: x^2 + 1, on: {x: [-9]}, count: 1}", FOUND_FALSE, EXACT},
    {NULL, "a: {roots: 5, on: {x: [-9]}, count: 0}", FOUND_TRUE, EXACT},
    {NULL, "a: {roots: x^2 - m, on: {x: [-9]}, count: 2, at: {m: [1, 5]}}", FOUND_TRUE, EXACT},
    {NULL, "a: {roots: x - y, on: {x: [-1]}, count: 1, at: {y: x}}", UNDECIDED, EXACT},
    {NULL, "a: {roots: n - y, on: {n: [0]}, count: 1, at: {y: n}}", UNDECIDED, EXACT},
    {NULL, "a: {roots: x - n, on: {x: [0]}, count: 1, at: {n: 3 +- 1}}", UNDECIDED, EXACT},
    {NULL, "a: {roots: exp(x), on: {x: [0]}, count: 0}", UNDECIDED, EXACT},
    {NULL, "a: {roots: 1/x, on: {x: [0]}, count: 0}", UNDECIDED, EXACT},
    {NULL, "a: {roots: sqrt(x) + 1, on: {x: [0]}, count: 0}", UNDECIDED, EXACT},
    {NULL, "a: {roots: 1/x^2, on: {x: [0]}, count: 0}", UNDECIDED, EXACT},
    {NULL, "a: {roots: x - 1, on: {x: [sqrt(2)]}, count: 0}", UNDECIDED, EXACT},
    {NULL, "a: {roots: x - x, on: {x: [0]}, count: 0}", UNDECIDED, EXACT},
    /* I5: matrices */
    {"free: [u, v], system: {u: v, v: 0*u}", "a: {rank: 1}", FOUND_TRUE, EXACT},
    {"free: [u, v], system: {u: v, v: -u}", "a: {rank: 1}", FOUND_FALSE, EXACT}, /* no less */
    {"free: [u, v], system: {u: v, v: dQ}, at: {dQ: 0}", "a: {rank: 2, control: dQ}", FOUND_TRUE, EXACT},
    {"free: [u, v], system: {u: v, v: dQ}, at: {dQ: 0}", "a: {rank: 1, observe: v}", FOUND_TRUE, EXACT},
    {"free: [u, v], system: {u: v, v: dQ}, at: {dQ: 0}", "a: {rank: 2, observe: u}", FOUND_TRUE, EXACT},
    {"free: [u, v], system: {u: v, v: -L*u}", "a: {rank: 2}", UNDECIDED, EXACT}, /* L has no value */
    {"free: [u], system: {Omega: u, u: -Omega}", "a: {rank: 2}", FOUND_TRUE, EXACT}, /* the sheet's first quantity */
    {"free: [u, v], system: {u: v, v: 3*Omega}", "a: {rank: 2, control: Omega}", FOUND_TRUE, EXACT},
    /* steps */
    {NULL, "a: {step: kepler}", FOUND_TRUE, EXACT},
    {NULL, "a: {step: [kepler, static_places]}", FOUND_TRUE, EXACT},
    /* I6: of each all */
    {NULL, "a: [eq05.x1 - eq05.x2 = L, eq04.x2 = -m1/m2*x1]", FOUND_TRUE, EXACT},
    {NULL, "a: [eq05.x1 - eq05.x2 = L, eq04.x2 = -m2/m1*x1]", FOUND_FALSE, EXACT},
    {NULL, "a: {algebra: [s + s = 2*s, (s + 1)^2 = s^2 + 2*s], free: [s]}", FOUND_FALSE, EXACT},
};

CASE_ONCE(statements, open_all, close_all)

EACH(assertions_are_found_true_or_false_or_stay_open, COUNT(assertions))
{
    char text[4096];
    struct statements s;
    write_claim(text, "a", assertions[_i].given, assertions[_i].entry, NULL);
    read_claim(&s, text);
    struct assertion *a = &s.list[0].assertions[0];
    assertion_find(&s, &s.list[0], a);
    ck_assert_msg(a->truth == assertions[_i].truth, "%s: found %d", assertions[_i].entry, (int)a->truth);
    ck_assert_msg(a->how == assertions[_i].how, "%s: %s", assertions[_i].entry, how_names[a->how]);
    statements_clear(&s);
}

/* ---- verdicts ---- */

static void assert_ruled(const char *text, enum verdict verdict, bool as_written, const char *open)
{
    struct statements s;
    struct ruling r;
    read_claim(&s, text);
    statement_decide(&s, &s.list[s.count - 1], &r);
    ck_assert_msg(r.verdict == verdict && r.as_written == as_written, "%s: %s\n%s", verdict_names[r.verdict], r.open.text, text);
    ck_assert_msg(strstr(r.open.text, open) != NULL && (*open != '\0' || r.open.text[0] == '\0'), "'%s'", r.open.text);
    statements_clear(&s);
}

static const struct {
    const char *condition, *prove;
    enum verdict verdict;
    bool as_written;
    const char *open;
} rulings[] = {
    {"a", "a: dL > 0", HOLDS, true, ""},
    {"[a, b]", "a: dL > 0\n    b: dL < 1/2", HOLDS, true, ""},
    {"not a", "a: dL < 0", HOLDS, true, ""},
    {"[a, not b, not d]", "a: dL > 0\n    b: dL < 0\n    d: dL > 1", HOLDS, true, ""},
    {"a", "a: dL < 0", VERDICT_NONE, false, "t:7:8: c comes out as 'undecided', its evidence is written for 'holds': 'a' is false"},
    {"[a, b]", "a: dL < 0\n    b: dL > 1", VERDICT_NONE, false, "t:7:8: c comes out as 'undecided', its evidence is written for 'holds': 'a' is false"},
    {"[a, not b]", "a: dL > 0\n    b: dL < 1/2", VERDICT_NONE, false, "t:8:8: c comes out as 'undecided', its evidence is written for 'holds': 'b' is true"},
    {"[a, b]", "a: dL > 0\n    b: L > 0", VERDICT_NONE, false, "t:8:8: c comes out as 'undecided', its evidence is written for 'holds': 'b' is found neither true nor false"},
    {"a", "r: {root: 3/2 - y, on: {y: [1, 2]}}\n    a: r < 3/2", VERDICT_NONE, false, "'a' is found neither true nor false"},
    {"a", "r: {root: 3/2 - y, on: {y: [1, 2]}}\n    a: r > 3/2", VERDICT_NONE, false, "'a' is found neither true nor false"},
    {"a", "run: {compute: escaping_10}\n    a: run.at_nowhere_0 < 0", VERDICT_NONE, false, "t:8:8: c comes out as 'undecided', its evidence is written for 'holds': 'a' is found neither"},
    {"a, refuted: not a", "a: L > 0", VERDICT_NONE, false, "'a' is found neither true nor false"}, /* nor is what is undecided refuted */
    {"a, refuted: not a", "a: dL < 2", VERDICT_NONE, false, "'a' is true by a bound that is not within ten"},
    {"a, refuted: not a", "a: dL < 0", REFUTED, false, "t:7:8: c comes out as 'refuted', its evidence is written for 'holds': 'a' is false"},
    {"a", "r: {root: y^2 - 2, on: {y: [1, 2]}}\n    a: {show: x > 1, at: {x: r}}", HOLDS, true, ""}, /* r serves a by way of x, */
    {"a", "r: {root: y^2 - 2, on: {y: [1, 2]}}\n    t: {root: t - r, on: {t: [1, 2]}}\n    a: t > 1", HOLDS, true, ""}, /* of t */
    {"[dL, b]", "dL: m1 > 0\n    b: dL > 0", HOLDS, true, ""}, /* an entry that is no number hides none of the sheet */
    {"a", "r: {root: y^2 - 2, on: {y: [1, 2]}}\n    rr: {root: r + 1 - y, on: {y: [2, 3]}}\n    a: rr > 2", HOLDS, true, ""}, /* no other's beginning */
    {"a", "n: {root: y^2 - 2, on: {y: [1, 2]}}\n    a: n < 2", HOLDS, true, ""}, /* not the sheet's 10 */
    {"[a, returns]", "a: dL > 0\n    start: {compute: escaping_10}\n    returns: start.at_dL_0 < 0", HOLDS, true, ""},
    {"[a, returns]", "a: dL > 0\n    start: {compute: escaping_10}\n    returns: start.at_dL_0 > 0", VERDICT_NONE, false, "'returns' is false"},
};

EACH(verdicts_follow_from_conditions, COUNT(rulings))
{
    char text[4096];
    write_claim(text, rulings[_i].condition, NULL, rulings[_i].prove, NULL);
    assert_ruled(text, rulings[_i].verdict, rulings[_i].as_written, rulings[_i].open);
}

/* Where nothing else is said all is wanted, but for the computations that the others rest on. */
EACH(a_verdict_by_itself_wants_all, 3)
{
    static const char *const prove[] = {"a: dL > 0\n    b: dL < 1/2", "a: dL > 0\n    b: dL > 1", "run: {compute: escaping_10}\n    a: run.at_dL_0 < 0"};
    static const char holds[] = {'h', 'o', 'l', 'd', 's'};
    char text[4096];
    write_claim(text, "a}", NULL, prove[_i], NULL);
    char *condition = strstr(text, "{holds: a}}");
    memset(condition, ' ', strlen("{holds: a}}"));
    memcpy(condition, holds, sizeof holds);
    assert_ruled(text, _i == 1 ? VERDICT_NONE : HOLDS, _i != 1, _i == 1 ? "'b' is false" : "");
}

TEST(what_is_not_so_is_told_before_a_number_without_digits)
{
    char text[4096];
    write_claim(text, "a", NULL, "a: dL < 0", "{L | 3}");
    assert_ruled(text, VERDICT_NONE, false, "t:7:8: c comes out as 'undecided'");
}

TEST(a_number_needs_nothing_proved)
{
    assert_ruled("c:\n  where: here\n  kind: beyond\n  claim: it\n  verdict: not decidable\n  why: so\n  evidence: it is {dL | 2}\n",
                 NOT_DECIDABLE, true, "");
}

TEST(a_claim_has_not_too_many_assertions)
{
    char text[4096], prove[1024] = "";
    struct statements s;
    struct message why = {""};
    for (int i = 0; i <= MOST_ASSERTIONS; i++)
        snprintf(prove + strlen(prove), sizeof prove - strlen(prove), "a%d: dL > 0\n    ", i);
    write_claim(text, "a0", NULL, prove, NULL);
    ck_assert_int_eq(statements_read(&s, &proofs, &(struct source){"t", text, strlen(text)}, &why), -1);
    ck_assert_ptr_nonnull(strstr(why.text, "expected at most 40 assertions"));
}

TEST(a_claim_may_rest_on_another)
{
    char text[4096], both[8192];
    write_claim(text, "a", NULL, "a: dL > 0", NULL);
    snprintf(both, sizeof both, "%sd%s", text, strchr(text, ':'));
    char *second = strstr(strstr(both, "\nd:"), "a: dL > 0");
    snprintf(second, sizeof both - (size_t)(second - both), "a: {claim: c}\n  evidence: e\n");
    assert_ruled(both, HOLDS, true, "");
    strstr(both, "dL > 0")[3] = '<';
    assert_ruled(both, VERDICT_NONE, false, "d comes out as 'undecided', its evidence is written for 'holds': 'a'");
}

/* Claims c, d and one on both: it is so where both come out as they are written, and it is known as the weaker of them is. */
static const struct {
    const char *condition, *first, *second;
    enum verdict verdict;
    enum how how;
} pairs_of_claims[] = {
    {"a", "dL > 0", "dL < 1/2", HOLDS, EXACT},
    {"a", "exp(dL) > 1", "dL < 1/2", HOLDS, CERTIFIED},
    {"a", "dL > 0", "exp(dL) > 1", HOLDS, CERTIFIED},
    {"a", "dL < 0", "dL < 1/2", VERDICT_NONE, EXACT},
    {"a", "dL > 0", "dL > 1", VERDICT_NONE, EXACT},
    {"a, refuted: not a", "dL < 0", "dL < 1/2", VERDICT_NONE, EXACT}, /* not by another condition */
};

EACH(a_claim_may_rest_on_two, COUNT(pairs_of_claims))
{
    char text[4096], all[16384];
    struct statements s;
    struct ruling r;
    int length = 0;
    for (int k = 0; k < 3; k++) {
        char prove[256];
        snprintf(prove, sizeof prove, "a: %s", k == 0 ? pairs_of_claims[_i].first : k == 1 ? pairs_of_claims[_i].second : "{claim: [c, d]}");
        write_claim(text, k == 0 ? pairs_of_claims[_i].condition : "a", NULL, prove, NULL);
        length += snprintf(all + length, sizeof all - (size_t)length, "%c%s", 'c' + k, text + 1);
    }
    read_claim(&s, all);
    statement_decide(&s, &s.list[2], &r);
    ck_assert_ptr_eq(statement_find(&s, "e"), &s.list[2]);
    ck_assert_int_eq(r.verdict, pairs_of_claims[_i].verdict);
    ck_assert_int_eq(r.as_written, r.verdict == HOLDS);
    ck_assert_int_eq(r.how, pairs_of_claims[_i].how);
    statements_clear(&s);
}

/* Of two roots neither is the number that the name stands for. */
TEST(a_root_that_is_not_alone_has_no_digits)
{
    char text[4096];
    write_claim(text, "a", NULL, "a: dL > 0\n    r: {root: y^2 - 2, on: {y: [-2, 2]}}", "{r | 1}");
    assert_ruled(text, VERDICT_NONE, false, "the digits of r cannot be proved");
    write_claim(text, "a", "at: {x: 1.25 +- 0.06}", "a: dL > 0\n    r: {root: y - x, on: {y: [1, 2]}}", "{r | 3}"); /* nor one that is vague */
    assert_ruled(text, VERDICT_NONE, false, "the digits of r cannot be proved");
}

/* ---- numbers ---- */

static const struct {
    const char *number, *decimal; /* NULL: not proved */
    enum how how;
} numbers[] = {
    {"1/800 | 3", "0.00125", EXACT},      {"-1.25 | 3", "-1.25", EXACT},        {"1.25e-4 | 3", "0.000125", EXACT},
    {"1.25e-5 | 3", "1.25e-05", EXACT},   {"1250000 | 3", "1250000", EXACT},    {"12500000 | 3", "1.25e+07", EXACT},
    {"-12.5 | 4", "-12.50", EXACT},       {"2 | 1", "2", EXACT},                {"dL - 1/10 | 3", "0", EXACT},
    {"1/8 | exact", "1/8", EXACT},        {"sqrt(2) | exact", NULL, EXACT},     {"sqrt(2) | 5", "1.4142", EXACT},
    {"sqrt(2) | 2 up", "1.5", EXACT},     {"sqrt(2) | 2 down", "1.4", EXACT},   {"-sqrt(2) | 2 up", "-1.4", EXACT},
    {"sqrt(2)/1000 | 2 up", "0.0015", EXACT}, {"pi | 6", "3.14159", EXACT},     {"x | 1", "1", CERTIFIED},
    {"x | 3", NULL, CERTIFIED},           {"x | 2 up", "1.4", CERTIFIED},       {"x | 2 down", "1.1", CERTIFIED},
    {"r | 6", "1.41421", EXACT},          {"L | 3", NULL, EXACT},
    {"9.99 | 2", "10", EXACT},             {"sqrt(99.99) | 3", "10.0", EXACT},
    {"1.51e12*sqrt(1) | 2 up", "1.6e+12", EXACT}, {"dL - 1/10 | 2 up", "0", EXACT},
    {"L | 2 up", NULL, EXACT}, {"12/17 | exact", "12/17", EXACT},
    {"Omega | 5", "7.2915e-05", EXACT}, {"1/3 | 60", "0.333333333333333333333333333333333333333333333333333333333333", EXACT},
};

EACH(numbers_have_proved_digits_or_none, COUNT(numbers))
{
    char text[4096], evidence[128];
    struct statements s;
    struct ruling r;
    snprintf(evidence, sizeof evidence, "{%s}, {r | 3}, {x | 1}", numbers[_i].number);
    write_claim(text, "a", "at: {x: 1.25 +- 0.06}", "a: dL > 0\n    r: {root: y^2 - 2, on: {y: [1, 2]}}", evidence);
    read_claim(&s, text);
    statement_decide(&s, &s.list[0], &r);
    const struct quoted_number *q = &s.list[0].numbers[0];
    ck_assert_int_eq(r.as_written, numbers[_i].decimal != NULL);
    if (numbers[_i].decimal == NULL) {
        ck_assert_ptr_null(q->decimal);
        ck_assert_int_eq(r.verdict, VERDICT_NONE);
        ck_assert_msg(strstr(r.open.text, "t:11:6: c: the digits of") == r.open.text, "%s", r.open.text);
    } else {
        ck_assert_ptr_nonnull(q->decimal);
        ck_assert_str_eq(q->decimal, numbers[_i].decimal);
        ck_assert_int_eq(q->how, numbers[_i].how);
        ck_assert_int_eq(r.how, CERTIFIED); /* x is */
    }
    statements_clear(&s);
}

/* What only a number rests on is needed all the same, directly or through another root. */
TEST(a_verdict_needs_what_its_numbers_rest_on)
{
    char text[4096];
    write_claim(text, "a", NULL, "a: dL > 0\n    r: {root: y^2 - 2, on: {y: [1, 2]}}\n    t: {root: y - r, on: {y: [1, 2]}}\n"
                "    start: {compute: escaping_10}", "{t | 3}, {start.at_dL_0 | 3}");
    assert_ruled(text, HOLDS, true, "");
}

TEST(evidence_is_written_in_both_forms)
{
    char text[4096];
    struct statements s;
    struct ruling r;
    struct written w = {{NULL, 0}, {NULL, 0}};
    write_claim(text, "a", NULL, "a: dL > 0",
                "at $|dQ| <= 2 k_c/L^2$ and\n    5 % it is {1.3e-12 | 2 | m}, {100*dL | 2 | %}, {dL | 1}");
    read_claim(&s, text);
    statement_decide(&s, &s.list[0], &r);
    statement_evidence(&s.list[0], &w);
    ck_assert_str_eq(w.plain.text, "at |dQ| <= 2 k_c/L^2 and 5 % it is 1.3e-12 m, 10 %, 0.1");
    ck_assert_str_eq(w.latex.text, "at $\\vert \\delta Q\\vert  \\le  2\\,k_{c}/L^{2}$ and 5 % it is $1.3\\cdot 10^{-12}$\u00a0m, $10$\u00a0%, $0.1$");
    written_clear(&w);
    statements_clear(&s);
}

static const struct {
    const char *text, *plain, *latex;
} marked[] = {
    {"4 uC_1 ~ m^2 < ^ \\ $", NULL, "4 uC_1 ~ m^2 < ^ \\ $"},
    {"$x$ u c of $y^2$^2", "x u c of y^2^2", "$x$ u c of $y^{2}$^2"},
    {"a {b} and $x$", NULL, "a {b} and $x$"}, /* from there on as it stands */
    {"$$ $x$", NULL, "$$ $x$"},
};

EACH(marked_text_is_written_in_both_forms, COUNT(marked))
{
    struct written w = {{NULL, 0}, {NULL, 0}};
    write_marked(&w, marked[_i].text);
    ck_assert_str_eq(w.plain.text, marked[_i].plain != NULL ? marked[_i].plain : marked[_i].text);
    ck_assert_str_eq(w.latex.text, marked[_i].latex);
    written_clear(&w);
}

/* ---- mistakes ---- */

#define PROVE "  prove:\n    a: dL > 0"

static const struct {
    const char *from, *to, *expected;
} mistakes[] = {
    {"kind: beyond", "kind: rumour", "t:3:9: expected a kind"},
    {"  where: here\n", "", "t:2:3: missing where"},
    {"where: here", "were: here", "t:2:3: unknown key 'were'"},
    {"{holds: [a, b]}", "{stands: [a, b]}", "t:5:13: expected a verdict"},
    {"verdict: {holds: [a, b]}", "verdict: stands", "t:5:12: expected a verdict"},
    {"{holds: [a, b]}", "{holds: {a: b}}", "t:5:20: expected a list"},
    {"  verdict: {holds: [a, b]}\n  prove:\n    a: dL > 0\n    b: dL < 1/2\n", "  verdict: holds\n", "t:5:12: expected something to prove"},
    {"verdict: {holds: [a, b]}", "verdict: {}", "t:5:12: expected verdict"},
    {"{holds: [a, b]}", "{holds: [a, b, d]}", "t:5:27: expected a name of prove"},
    {"{holds: [a, b]}", "{holds: [a, not d]}", "t:5:28: expected a name of prove"},
    {"{holds: [a, b]}", "{holds: a b}", "t:5:20: expected a name of prove"},
    {"{holds: [a, b]}", "{holds: []}", "t:5:20: expected a name of prove"},
    {"{holds: [a, b]}", "{refuted: [a, b]}", "missing why"},
    {"{holds: [a, b]}", "{holds: [a, b], refuted: not a}", "t:5:37: expected the names of the first condition"},
    {"{holds: [a, b]}", "{holds: a, refuted: [not a, b]}", "t:5:32: expected the names of the first condition"},
    {"{holds: [a, b]}", "{holds: [a, b], refuted: [b, a]}", "t:5:37: expected another condition"},
    {"{holds: [a, b]}", "{holds: [a, b], refuted: [a, not b], qualified: [not b, a]}", "t:5:60: expected another condition"},
    {"{holds: [a, b]}", "{holds: a}", "t:8:8: c stands without 'b', or with its contrary"},
    {"{holds: [a, b]}", "{holds: b}", "t:7:8: c stands without 'a', or with its contrary"},
    {"{holds: [a, b]}\n  prove:\n    a: dL > 0\n    b: dL < 1/2", "{holds: a}\n  prove:\n    r: {root: y^2 - 2, on: {y: [1, 2]}}\n    a: r > 1\n    b: dL < 1/2",
     "t:9:8: c stands without 'b', or with its contrary"},
    {"{holds: [a, b]}\n  prove:\n    a: dL > 0\n    b: dL < 1/2", "{holds: a}\n  prove:\n    a: dL > 0\n    b: {compute: escaping_10}",
     "t:8:8: c stands without 'b'"},
    {"a: dL > 0", "a: dL", "t:7:8: expected left = right"},
    {"a: dL > 0", "a: eq05.x1 + 1 = eq05.x1+1", "t:7:8: both sides are the same"},
    {"a: dL > 0", "a: m1 - m1 + m2 = m2", "t:7:8: it holds whatever the sheet says, expected {algebra: left = right}"},
    {"a: dL > 0", "a: [m1 + m2 = m2 + m1]", "t:7:9: it holds whatever the sheet says"},
    {"a: dL > 0", "a: eq43.C1 - eq43.C1 + m2 = m2", "t:7:8: it holds whatever the sheet says"},
    {"a: dL > 0", "a: [eq43.C1 = n*Omega^2, 0*eq44.C2 = 0]", "t:7:30: it holds whatever the sheet says"},
    {"a: dL > 0", "a: [m1 + m2 = 2*m2]", "t:7:9: it holds whatever the sheet says"},
    {"a: dL > 0", "a: [eq43.C1 = n*Omega^2, m1 + m2 = 2*m2]", "t:7:30: it holds whatever the sheet says"},
    {"a: dL > 0", "a: {algebra: dL > 0}", "t:7:18: expected equalities for all values"},
    {"a: dL > 0", "a: {show: dL > dL}", "t:7:15: both sides are the same"},
    {"a: dL > 0", "a: dL > nothing", "t:7:13: unknown symbol 'nothing'"},
    {"a: dL > 0", "a: {sohw: dL > 0}", "t:7:8: expected left = right, or one of show,"},
    {"a: dL > 0", "a: {show: dL > 0, att: {x: [1]}}", "t:7:23: unknown key 'att', expected perhaps at"},
    {"a: dL > 0", "a: {step: kepler, claim: c}", "t:7:23: unknown key 'claim'"},
    {"a: dL > 0", "a: {show: dL > 0, step: kepler}", "t:7:23: unknown key 'step'"},
    {"a: dL > 0", "a: {root: x^2 - 2, on: {x: [1, 2]}, at: {m: [1, 2]}}", "t:7:45: expected one value each"},
    {"a: dL > 0", "a: {algebra: (s + 1)^2 = s^2 + 2*s + 1, free: [s], on: {s: [0, 1]}}", "unknown key 'on'"},
    {"a: dL > 0", "a: {show: eq05.x1 - eq05.x2 = L, on: {x: [0, 1]}}", "t:7:15: expected no at and no on"},
    {"a: dL > 0", "a: {show: x = 1, on: {x: [0, 1]}, at: {m: 1}}", "t:7:15: expected no at and no on"},
    {"a: dL > 0", "a: {show: [eq05.x1 - eq05.x2 = L], at: {x: 1}}", "t:7:15: expected no at and no on"},
    {"a: dL > 0", "a: {algebra: u + 1 = 1 + u, free: [u, u_dot], rates: {u: v}}", "unknown symbol 'v', expected name: its rate"},
    {"a: dL > 0", "a: []", "t:7:8: expected equalities"},
    {"a: dL > 0", "a: {show: []}", "t:7:15: expected equalities"},
    {"a: dL > 0", "a: {algebra: []}", "t:7:18: expected equalities"},
    {"a: dL > 0", "a: {step: []}", "t:7:15: expected a step"},
    {"a: dL > 0", "a: {claim: []}", "t:7:16: expected a claim that stands before"},
    {PROVE, "  given: {system: {}}\n  prove:\n    a: {rank: 0}", "t:6:19: expected a system"},
    {"a: dL > 0", "a: {show: x > 0, let: {x: 2}, at: {x: -1}}", "t:7:40: 'x' stands in let, too"},
    {"a: dL > 0", "a: {show: x > 0, let: {x: 2}, on: {x: [-1, 1]}}", "t:7:40: 'x' stands in let, too"},
    {"a: dL > 0", "a: {show: x > 0, let: {x: 2}, at: {x: [-1, 1]}}", "t:7:40: 'x' stands in let, too"},
    {"a: dL > 0", "a: {root: x^2 - 2, let: {x: dL}, on: {x: [1, 2]}}", "t:7:43: 'x' stands in let, too"},
    {PROVE, "  given: {let: {x: 2}}\n  prove:\n    a: {root: x^2 - 2, on: {x: [1, 2]}}", "t:8:29: 'x' stands in let, too"},
    {PROVE, "  given: {let: {x: 2}, at: {x: 1}}\n  prove:\n    a: x > 1", "t:6:29: 'x' stands in let, too"},
    {"verdict: {holds: [a, b]}\n  prove:\n    a: dL > 0\n    b: dL < 1/2", "verdict: holds\n  prove:\n    a: {compute: escaping_10}",
     "t:5:12: expected something to prove"},
    {"a: dL > 0", "a: {on: {x: [0, 1]}}", "t:7:8: expected left = right, or one of"},
    {"a: dL > 0", "a: {show: dL > x, on: {x: [0]}}", "t:7:27: expected on"},
    {"a: dL > 0", "a: {show: dL > x, at: {x: [0, 3], y: [1, 2, 4]}}", "t:7:42: expected lists of one length"},
    {"a: dL > 0", "a: {root: x}", "t:7:8: expected on"},
    {"a: dL > 0", "a: {root: 1, on: {'': [0, 1]}}", "t:7:22: expected on"},
    {"a: dL > 0", "a: {root: x, on: {x: [0]}}", "t:7:22: expected on"},
    {"a: dL > 0", "a: {roots: x, on: {x: [0, 1]}, count: 0}", "t:7:23: expected on"},
    {"a: dL > 0", "a: {roots: x, on: {x: [0]}, count: many}", "t:7:40: expected a count"},
    {"a: dL > 0", "a: {rank: many}", "t:7:15: expected a "},
    {"a: dL > 0", "a: {rank: 1}", "t:7:8: expected a system"},
    {"a: dL > 0", "a: {step: [kepler, nowhere]}", "t:7:24: expected a step"},
    {"a: dL > 0", "a: {step: [kepler, [kepler]]}", "t:7:24: expected a list"},
    {"a: dL > 0", "a: {step: nowhere}", "t:7:15: expected a step"},
    {"a: dL > 0", "a: {claim: d}", "t:7:16: expected a claim that stands before"},
    {"a: dL > 0", "a: {claim: c}", "t:7:16: expected a claim that stands before"},
    {"a: dL > 0", "a: {compute: nothing}", "t:7:18: unknown computation"},
    {"a: dL > 0", "a: nothing > dL", "t:7:8: unknown symbol 'nothing'"},
    {"a: dL > 0", "a: {show: dL > x, at: {x: [y, 1]}}", "t:7:32: unknown symbol 'y'"},
    {"a: dL > 0", "a: {show: dL > x, at: {x: y +- 1}}", "t:7:31: unknown symbol 'y'"},
    {"a: dL > 0", "a: {show: dL > x, at: {x: 1 +- y}}", "t:7:36: unknown symbol 'y'"},
    {"a: dL > 0", "a: {compute: [linear_10]}", "t:7:18: unknown computation"},
    {PROVE "\n    b: dL < 1/2", "  prove:\n    r: {root: y^2 - 2, on: {y: [1, 2]}}\n    a: {show: dL > 0, at: {x: r}}\n    b: dL < 1/2",
     "t:7:8: c stands without 'r'"}, /* x, and with it r, is in no formula */
    {"a: dL > 0", "a: {root: a + x - 2, on: {x: [0, 3]}}", "t:7:8: 'a' rests on itself"},
    {"a: dL > 0", "a: {show: dL > x, at: {x: {y: 1}}}", "t:7:31: expected a value, or several"},
    {"a: dL > 0", "a: {show: dL > x, at: {x: [1, 2, 3, 4, 5, 6, 7, 8, 9]}}", "t:7:31: expected a value, or several"},
    {"a: dL > 0", "a: {root: x, on: [[0, 1]]}", "t:7:22: expected on"},
    {"a: dL > 0", "a: {root: x, on: {x: {l: 0, h: 1}}}", "t:7:22: expected on"},
    {"a: dL > 0", "a: {root: x, on: {x: 5}}", "t:7:22: expected on"},
    {"a: dL > 0", "a: {show: {b: dL > 0}}", "t:7:15: expected a list"},
    {"a: dL > 0", "a: {roots: x, on: {x: [0]}}", "t:7:8: expected a count"},
    {"a: dL > 0", "a: {roots: x, on: {x: [0]}, count: -1}", "t:7:40: expected a count"},
    {"a: dL > 0", "a: {roots: x, on: {x: [0]}, count: 1x}", "t:7:40: expected a count"},
    {"a: dL > 0", "a: {rank: [1]}", "t:7:15: expected a count"},
    {PROVE, "  given: {system: [psi]}\n  prove:\n    a: {rank: 1}", "t:6:19: expected a mapping"},
    {PROVE, "  given: {system: {psi: 1, theta: 1, dL: 1, psi_dot: 1, theta_dot: 1, dL_dot: 1, L: 1}}\n  prove:\n    a: {rank: 1}",
     "t:6:19: expected a system"},
    {PROVE, "  given: {system: {psi: psi_dot}}\n  prove:\n    a: {rank: 1, observe: [psi]}", "t:8:27: expected control"},
    {PROVE, "  given: {system: {psi: psi_dot}}\n  prove:\n    a: {rank: 1, observe: L}", "t:8:27: expected control"},
    {PROVE, "  given: {fre: [x]}\n" PROVE, "unknown key 'fre'"},
    {"verdict: {holds: [a, b]}\n  prove:\n    a: dL > 0", "verdict: {holds: [a, b]}\n  prove:\n    a: {compute: escaping_10}",
     "t:5:21: expected a name of prove, but no computation"},
    {"verdict: {holds: [a, b]}", "verdict: undecided", "t:5:12: expected a verdict"},
    {"verdict: {holds: [a, b]}", "verdict: [holds]", "t:5:12: expected verdict"},
    {"kind: beyond", "kind: beyond\n  why: so {dL | 2}", "t:4:11: expected no number"},
    {"where: here", "where: here {dL | 2}", "t:2:15: expected no number"},
    {"evidence: >-\n    so", "evidence: >-\n    so { | 2}", "t:10:10: expected a number"},
    {"evidence: >-\n    so", "evidence: >-\n    so {dL | 0}", "t:10:14: expected {FORMULA | DIGITS}"},
    {"evidence: >-\n    so", "evidence: >-\n    so {dL | 61}", "t:10:14: expected {FORMULA | DIGITS}"},
    {"evidence: >-\n    so", "evidence: >-\n    so {dL | 2 upp}", "t:10:14: expected {FORMULA | DIGITS}"},
    {"evidence: >-\n    so", "evidence: >-\n    so {dL | 2 up!}", "t:10:14: expected {FORMULA | DIGITS}"},
    {"evidence: >-\n    so", "evidence: >-\n    so {dL | up}", "t:10:14: expected {FORMULA | DIGITS}"},
    {"a: dL > 0", "a: {show: dL > y, at: {y: z}}", "t:7:31: unknown symbol 'z'"},
    {"evidence: >-\n    so", "evidence: >-\n    so {dL} and\n    so", "t:10:9: expected {FORMULA | DIGITS}"},
    {"evidence: >-\n    so", "evidence: >-\n    so\n    it {dL | many} so", "t:11:14: expected {FORMULA | DIGITS}"},
    {"evidence: >-\n    so", "evidence: >-\n    so\n    it {dM | 2} so", "t:11:9: unknown symbol 'dM'"},
    {"evidence: >-\n    so", "evidence: >-\n    so $dL", "t:10:8: expected $...$, closed"},
    {"evidence: >-\n    so", "evidence: >-\n    so}", "t:10:7: expected '{' before '}'"},
    {"evidence: >-\n    so", "evidence: >-\n    so $$", "t:10:8: expected $...$, closed"},
    {"evidence: >-\n    so", "evidence: >-\n    so {dL | {2}", "t:10:8: expected {FORMULA | DIGITS}"},
    {"claim: it", "claim: it {dL | 2}", "t:4:13: expected no number"},
    {"kind: beyond", "kind: beyond\n  equations: ['99']", "unknown '99', expected an equation number"},
    {"kind: beyond", "kind: beyond\n  equations: 99", "t:4:14: expected a list"},
    {"  verdict: {holds: [a, b]}\n  prove:\n    a: dL > 0\n    b: dL < 1/2\n", "", "expected something to prove"},
    {"kind: beyond\n  claim: it is so\n  verdict: {holds: [a, b]}", "kind: misprint\n  claim: it is so", "missing why, of a verdict other"},
    {"  evidence: >-\n    so it is\n", "", "missing evidence"},
    {"  prove:\n    a: dL > 0\n    b: dL < 1/2", "  prove: [a]", "t:6:10: expected a mapping"},
    {"a: dL > 0", "a: [dL > 0]", "t:7:9: expected left = right"},
    {"a: dL > 0", "a: [dM = 1, eq05.x1 = 1]", "t:7:9: unknown symbol 'dM'"},
    {"a: dL > 0", "a: {root: [1], on: {x: [0, 1]}}", "t:7:15: expected a formula"},
    {"a: dL > 0", "a: {show: dL > 0, at: [1]}", "t:7:27: expected a mapping"},
    {"a: dL > 0", "a: {show: dL > x, at: {x: []}}", "t:7:31: expected a value, or several"},
    {"a: dL > 0", "a: {show: dL > x, at: {x: [y]}}", "t:7:32: unknown symbol 'y'"},
    {"a: dL > 0", "a: {show: dL > x, on: {x: [0, 1], y: [0, 1]}}", "t:7:27: expected on"},
    {PROVE, "  given: {system: {nowhere: 1}}\n  prove:\n    a: {rank: 1}", "t:6:20: unknown symbol 'nowhere'"},
    {PROVE, "  given: {system: {psi: [1]}}\n  prove:\n    a: {rank: 1}", "t:6:25: expected a formula"},
    {PROVE, "  given: {system: {psi: psi_dot}}\n  prove:\n    a: {rank: 1, control: nowhere}", "t:8:27: expected control"},
    {"a: dL > 0\n    b: dL < 1/2", "a: b > 0\n    b: {root: x - 1, on: {x: [0, 2]}}", "t:7:8: 'a' rests on itself, or on what stands after it"},
    {"evidence: >-\n    so", "evidence: >-\n    {dM | 2} {dL | 2}", "t:10:6: unknown symbol 'dM'"},
    {"(nothing)", "c: 5", "t:1:4: expected a mapping"},
    {"(nothing)", "[c]", "t:1:1: expected a mapping"},
    {"(nothing)", "{c", "expected YAML"},
};

EACH(mistakes_are_told_with_their_place, COUNT(mistakes))
{
    char good[4096], text[8192];
    struct statements s;
    struct message why = {""};
    write_claim(good, "[a, b]", NULL, "a: dL > 0\n    b: dL < 1/2", NULL);
    const char *at = strstr(good, mistakes[_i].from);
    const bool whole = strcmp(mistakes[_i].from, "(nothing)") == 0;
    ck_assert_msg(at != NULL || whole, "%s", mistakes[_i].from);
    if (whole)
        snprintf(text, sizeof text, "%s", mistakes[_i].to);
    else
        snprintf(text, sizeof text, "%.*s%s%s", (int)(at - good), good, mistakes[_i].to, at + strlen(mistakes[_i].from));
    ck_assert_int_eq(statements_read(&s, &proofs, &(struct source){"t", text, strlen(text)}, &why), -1);
    ck_assert_msg(strstr(why.text, mistakes[_i].expected) != NULL, "%s\n%s", why.text, text);
}

/* ---- equations ---- */

static enum verdict verdict_on(const struct section *s, const char *equation, struct statements *claims)
{
    struct verdict_row row = {.id = s->id};
    verdict_on_equation(&row, &proofs, claims, s, equation);
    ck_assert(row.verdict == VERDICT_NONE || (row.why.plain.length > 0) == (row.verdict < HOLDS));
    ck_assert_int_eq(row.how, claims != NULL && strcmp(equation, "7") == 0 ? CERTIFIED : EXACT); /* by one of the claims on it */
    verdict_row_clear(&row);
    return row.verdict;
}

/* As if all steps were proved already; or none. */
static void mark_steps(bool proved)
{
    for (int i = 0; i < proofs.step_count; i++) {
        proofs.steps[i].proved = proved;
        proofs.steps[i].printed_proof.result = IDENTITY_DIFFERS;
        for (int k = 0; k < proofs.steps[i].remainder_count; k++)
            proofs.steps[i].remainders[k].proof.state = REMAINDER_PROVED;
    }
}

TEST(an_equation_rests_on_every_step_that_leads_to_it)
{
    int count = 0;
    mark_steps(true);
    for (int i = 0; i < proofs.step_count; i++)
        for (int k = 0; k < proofs.sheet->section_count; k++) {
            const struct section *s = &proofs.sheet->sections[k];
            if (s->numbers != 1 || !entry_leads_to(&proofs, proofs.steps[i].to[0], s->equations[0]))
                continue;
            ck_assert_int_ne(verdict_on(s, s->equations[0], NULL), VERDICT_NONE);
            proofs.steps[i].proof.result = IDENTITY_UNDECIDED;
            ck_assert_int_eq(verdict_on(s, s->equations[0], NULL), VERDICT_NONE);
            proofs.steps[i].proof.result = IDENTITY_HOLDS;
            count++;
        }
    ck_assert_int_gt(count, 40);
    mark_steps(false);
}

static void count_open(void *context, const struct verdict_row *row)
{
    int *count = context;
    *count += row->open.text[0] != '\0';
    if (row->statement != NULL)
        ck_assert_int_eq(strncmp(row->open.text, "t:7:14: c comes out as", 22) == 0, row->id[0] == 'c');
    if (row->statement != NULL)
        ck_assert_int_eq(row->why.plain.length > 0, row->id[0] == 'd'); /* of what is as it is written */
}

/* The first claim, and the row of Table 1 that is computed, with another number in it. */
TEST(rows_are_decided_or_say_what_is_open)
{
    static const char *const text = "c:\n  where: here\n  kind: beyond\n  claim: it\n  why: so\n  evidence: so\n  prove: {a: dL < 0}\n"
                                    "d:\n  where: here\n  kind: beyond\n  claim: it\n  why: so\n  evidence: so\n  prove: {a: dL > 0}\n";
    struct sheet altered = *proofs.sheet;
    struct table_row rows[16];
    struct statements s;
    int open = 0;
    read_claim(&s, text);
    memcpy(rows, altered.table1, (size_t)altered.row_count * sizeof *rows);
    for (int i = 0; i < altered.row_count; i++)
        if (table_row_is_computed(proofs.sheet, &rows[i]))
            rows[i].printed = "9.87";
    altered.table1 = rows;
    s.sheet = &altered;
    mark_steps(true);
    ck_assert(!verdict_rows(&proofs, &s, NULL, count_open, &open));
    ck_assert_int_eq(open, 2);
    mark_steps(false);
    statements_clear(&s);
}

/* (21) differs at its second special values alone, which are outside its domain. */
TEST(what_is_printed_otherwise_has_to_differ)
{
    struct section s = *section_find(proofs.sheet, "eq21");
    int invalid = 0;
    while (strcmp(s.specials[invalid].flags, "invalid") != 0)
        invalid++;
    s.special_count = invalid + 1;
    ck_assert_int_eq(verdict_on(&s, "21", NULL), HOLDS);
    s.special_count = invalid;
    ck_assert_int_eq(verdict_on(&s, "21", NULL), VERDICT_NONE);
    ck_assert_int_eq(verdict_on(section_find(proofs.sheet, "eq18"), "99", NULL), VERDICT_NONE); /* no step leads there */
}

TEST(an_equation_is_as_weak_as_the_weakest_claim_on_it)
{
    static const struct {
        const char *first, *second;
        enum verdict verdict;
    } claims[] = {{"qualified", "qualified", QUALIFIED}, {"refuted", "qualified", REFUTED}, {"qualified", "refuted", REFUTED},
                  {"holds", "holds", HOLDS}, {"{holds: not a}", "qualified", VERDICT_NONE}};
    for (size_t i = 0; i < sizeof claims / sizeof *claims; i++) {
        char text[1024];
        struct statements s;
        int length = 0;
        for (int k = 0; k < 2; k++)
            length += snprintf(text + length, sizeof text - (size_t)length, "%c:\n  where: here\n  kind: beyond\n  claim: it is so\n%s"
                               "  equations: ['7']\n  verdict: %s\n  prove: {a: %s > 0}\n  evidence: so\n", 'c' + k,
                               k == 0 && *claims[i].first == '{' ? "" : "  why: so\n",
                               k == 0 ? claims[i].first : claims[i].second, k == (int)i % 2 ? "exp(dL) - 1" : "dL");
        read_claim(&s, text);
        ck_assert_int_eq(verdict_on(section_find(proofs.sheet, "eq07"), "7", &s), claims[i].verdict);
        ck_assert_int_eq(verdict_on(section_find(proofs.sheet, "eq18"), "18", &s), HOLDS);
        statements_clear(&s);
    }
}
