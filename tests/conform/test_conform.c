/* The oracle: what a client can do wrong, each with its own outcome, and no process left behind. */
#include "tests/run.h"
#include "tests/paper.h"

#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>


static char said[1 << 20]; /* both outputs of the program's last run */

/* conform with those arguments, FAULTY standing for the test's own client; its exit status, -1 for a signal. */
static int conform(const char *arguments)
{
    char line[1024];
    const char *client = strstr(arguments, "FAULTY");
    const int before = client ? (int)(client - arguments) : (int)strlen(arguments);
    snprintf(line, sizeof line, "exec 2>&1; \"$CT_PROGRAM\" conform %.*s%s%s", before, arguments,
             client ? "\"$CT_BUILD/tests/faulty\"" : "", client ? client + strlen("FAULTY") : "");
    FILE *pipe = popen(line, "r");
    ck_assert_ptr_nonnull(pipe);
    const size_t length = fread(said, 1, sizeof said - 1, pipe);
    said[length] = '\0';
    const int status = pclose(pipe);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

static void assert_says(const char *text)
{
    ck_assert_msg(strstr(said, text) != NULL, "'%s' is not in:\n%s", text, said);
}

/* ---- faults ---- */

/* eq07, eq09 and eq44 have 51, 27 and 33 golden vectors; faults begin with the eleventh question. */
#define TWO_TIMES(motion) motion "-paper-100," motion "-paper-43200," motion "-rates-100," motion "-rates-43200," motion "-at-rest-100"
#define LATER(motion) motion "-paper-43200," motion "-rates-43200," motion "-other-orbit-7200"
#define THREE "--only eq07,eq09,eq44 --timeout 1 -- FAULTY "

/* A run with its exit status, and what it says: texts, | between them, and none of those after a ! */
struct oracle_run {
    const char *arguments;
    int status;
    const char *says;
};

static void assert_run(const struct oracle_run *r)
{
    const int status = conform(r->arguments);
    char says[1000], *rest = NULL;
    ck_assert_msg(status == r->status, "%s: exit %d\n%s", r->arguments, status, said);
    snprintf(says, sizeof says, "%s", r->says);
    for (char *text = strtok_r(says, "|", &rest); text != NULL; text = strtok_r(NULL, "|", &rest))
        if (*text != '!')
            assert_says(text);
        else
            ck_assert_msg(strstr(said, text + 1) == NULL, "%s: says '%s'\n%s", r->arguments, text + 1, said);
}

static const struct oracle_run faults[] = {
    {THREE "none", 0, " 0 failed"},
    {THREE "crlf", 0, " 0 failed"},
    /* all golden vectors, and random ones of every level; inputs in every form are the same numbers */
    {"--only algebra,roots --random 50 --seed 11 -- FAULTY none", 0, " 0 failed, 0 skipped\n"},
    {"--only flow_linear-11-0,flow_linear-11-19,rk4_linear-11-0,rk4_linear-11-19 --random 20 --seed 11 -- FAULTY none", 0, "4 passed, 0 failed, 0 skipped\n"},
    {"--only algebra --inputs exact -- FAULTY none", 0, " 0 failed"},
    {"--only algebra --inputs hex -- FAULTY none", 0, " 0 failed"},
    {"--only eq38 --inputs hex -- FAULTY printed", 1, "GM         0x"},
    {THREE "wrong", 1, " wrong\n"},
    {THREE "invalid", 1, " invalid where a value is due\n"},
    {THREE "value", 1, " a value where invalid is due\n"},
    {THREE "wrong-id", 1, "eq09: 27 missing\n"}, /* a vector fails once, the line is counted apart */
    {THREE "wrong-id", 1, "111 vectors: 10 passed, 101 failed, 0 skipped; lines that answer nothing: 101\n"},
    {THREE "binary", 1, "  1 no vector's name, the first is line 11: "},
    {THREE "too-long", 1, "  1 too long, the first is line 11: \n    it has more than 65536 bytes\n"},
    {THREE "missing", 1, "eq07: 1 missing\n  eq07-random-7: missing\n\n"}, /* it is not the vector's fault */
    {THREE "repeated", 1, "  1 repeated or out of order, the first is line 12: eq07-random-7 "},
    {THREE "extra", 1, "\nlines that answer nothing: 2\n  1 wrong id, the first is line 113: that was all\n"},
    {THREE "empty", 1, "eq09: 27 missing\n"},
    {THREE "hang", 1, " 1 time-out\n  eq07-random-7: time-out\n    Omega      4.497"},
    {THREE "crash", 1, " 1 crash\n"},
    {THREE "exit-3", 1, "\nthe client ended with exit status 3 after 111 of 111 answers\n"},
    {"--only eq38 -- sh -c '\"$0\"; kill -SEGV $$' FAULTY", 1, "\nthe client ended with signal 11 after 27 of 27 answers\n"},
    {"--only eq07 --random 5000 --seed 1 -- sh -c 'exec <&-; sleep 0.2'", 1, "\nthe client ended after 0 of 5364 answers\n"}, /* it listens no more */
    {THREE "truncated", 1, "\nthe client ended after 10 of 111 answers\n"},
    {THREE "truncated", 1, "  first truncated: eq07-random-7 -1.3\n    the last line has no LF\n"},
    {THREE "malformed", 1, "  first malformed: eq07-random-7 1.5 oops\n    'oops' is no number\n"},
    {THREE "wrong-id", 1, "  101 wrong id, the first is line 11: somebody "},
    {THREE "flood", 1, "\nthe client was stopped for so many lines that answer nothing after 0 of 111 answers\n"},
    {"--only eq38 -- yes", 1, "\nthe client was stopped for so many lines that answer nothing after 0 of 27 answers\n"},
    {THREE "skip", 1, "every vector was skipped\n"},
    {"--only eq38 -- sh -c 'printf %150s; echo \"eq38-paper skip it\"; cat >/dev/null'", 1, "  26        1\n"},
    {"--only eq38 -- sh -c 'printf \"eq38-paper\\\\t\\\\033[1m\\\\n\"; cat >/dev/null'", 1, "got        ?[1m\n"},
    {THREE "dies", 2, "exit status 9 before its first answer\n"},
    {"--only algebra -- FAULTY early", 1, "  1 early, the first is line 1: eq44-negative invalid\n"}, /* more questions than both buffers hold */
    {"--only eq07 --random 300 --seed 1 -- FAULTY invalid", 1, " failed"}, /* not 300 mod 256 = 44 */
    {"--only eq38 -- FAULTY printed-38", 1, "looks like the paper's misprint: Kepler's third law has no factor of 3 there; the 3 of Eq. (39) is the one that Eq. (37) has already.\n"},
    {"--only eq04,eq05,eq07,eq38 -- FAULTY printed", 1, ", 17 failed, 0 skipped\n"}, /* wherever it stands among several */
    {"--only eq38 -- FAULTY printed", 1, "     0.6  eq38-"}, /* S = 2 Omega: -log10((sqrt(3) - 1)/3) = 0.61 digits */
    {"--only eq37 --random 5000 --seed 1 -- FAULTY cross", 0, " 0 failed"}, /* components by their vector: 50 of them near a plane of the axes */
    {"--significand 24 --only eq12,eq38 -- FAULTY float", 0, " 0 failed"},
    /* much in flight: answered at once, all heard first, a megabyte to complain of, and nobody who hears it */
    {"--only eq07 --random 5000 --seed 1 -- FAULTY none", 0, " 0 failed"},
    {"--only eq07 --random 5000 --seed 1 -- sh -c 'cat >\"$CT_BUILD/tests/asked\" && exec \"$0\" <\"$CT_BUILD/tests/asked\"' FAULTY", 0, " 0 failed"},
    {"--only eq07 -- sh -c 'head -c 1000000 /dev/zero >&2; exec \"$0\"' FAULTY 2>/dev/null", 0, " 0 failed"},
    {"--only eq07 -- sh -c 'echo oh >&2; exec \"$0\"' FAULTY 2>/dev/full", 0, " 0 failed"},
    /* R_c^5 leaves binary32's range for the larger of 200 orbits; golden vectors, and 13 from outside the domain, are without such */
    {"--significand 24 --only eq37 --random 200 --seed 1 -- FAULTY float", 0, " 0 failed, 61 skipped\n"},
    {"--only " TWO_TIMES("flow_linear") " -- FAULTY backwards", 1, "looks like a known mistake: backwards in time\n"},
    {"--significand 113 --only eq12,eq38 -- FAULTY none", 1, " wrong\n"},
    {"--only flow_linear-paper-43200,flow_linear-paper-432000 --digits flow_linear=15 -- FAULTY none", 1, " wrong\n"},
};

EACH(a_fault_has_its_own_outcome, COUNT(faults))
{
    assert_run(&faults[_i]);
}

/* ---- mistakes that people make ---- */

CASE(diagnosis, NULL, NULL)

/* Those of a whole client: tests/conform/test_outcomes.c has those of a line and of a formula. */
#define REFUSED "  looks like not all inputs outside the domain are refused\n"
#define ALL_SAY(words) "sh -c 'while read o id in; do echo $id " words "; done'"
static const struct oracle_run diagnoses[] = {
    {"--only eq44 -- FAULTY ends-in-the-middle", 1, "\nthe client ended after 5 of 33 answers\n"},
    {"--only eq43 -- FAULTY value", 1, REFUSED},
    {"--only eq41roots -- FAULTY units", 1, "  looks like a factor Omega is missing\n"},
    {"--only eq41roots -- FAULTY conjugates", 1, "  looks like conjugates are missing: the imaginary parts lost the sign\n"},
    {"--only " TWO_TIMES("flow_linear") " -- FAULTY euler", 1, "  looks like Euler's method with steps of 10 s\n"},
    {"--only " TWO_TIMES("rk4_linear") " -- FAULTY euler", 1, "  looks like Euler's method with steps of 1 h\n"},
    {"--only " LATER("flow_linear") " -- FAULTY long-step", 1, "  looks like the classical Runge-Kutta method with steps of 300 s\n"},
    {"--only " LATER("rk4_linear") " -- FAULTY long-step", 1, "  looks like the classical Runge-Kutta method with steps of 2 h\n"},
    {"--only " TWO_TIMES("flow_linear") " -- FAULTY coupling", 1, "  looks like -2 Omega/L_ref dL_dot in psi_ddot with the other sign\n"},
    /* what passes contradicts: the print's absolute value, a verdict at its edge, the first ten that are right, one n, Euler's method */
    {"--only eq21 -- FAULTY zero-charge", 1, "eq21: 4 a value where invalid is due\n|" REFUSED},
    {"--only eq42 -- FAULTY at-least", 1, "eq42: 2 wrong\n|!looks like"},
    {"--only eq38 -- FAULTY printed", 1, "eq38: 7 wrong\n|!looks like"},
    {"--only eq44-paper,eq44-large-Omega -- FAULTY n-8", 1, "eq44: 2 wrong\n|!looks like"},
    {"--only " TWO_TIMES("flow_linear") " -- sh -c 'for i in 1 2; do read -r q; echo \"$q\"; done | \"$0\" none; exec \"$0\" euler' FAULTY", 1, " wrong|!looks like"},
    /* refused are none of two; of one nothing is told, nor where a value inside is refused, as by answers to the question before */
    {"--only eq44-nan-n -- " ALL_SAY("1"), 1, "eq44: 1 |!looks like"},
    {"--only eq44-nan-n,eq44-nan-Omega -- " ALL_SAY("1"), 1, REFUSED},
    {"--only eq44-paper,eq44-nan-n,eq44-nan-Omega -- " ALL_SAY("`test $id = eq44-paper && echo invalid || echo 1`"), 1, "eq44: 1 |!looks like"},
    /* 6.0770e-4 and 2.6523e-3: six decimals are right within half of the last one, and no more */
    {"--only eq44-random-1,eq44-random-2 -- sh -c 'read o id in; echo $id 0.000608; read o id in; echo $id 0.002652'", 1, "looks like written with 6 decimals"},
    {"--only eq44-random-1,eq44-random-2 -- sh -c 'read o id in; echo $id 0.000609; read o id in; echo $id 0.002652'", 1, " wrong|!looks like"},
    /* nan for `invalid`, in whichever output, always */
    {"--only eq02 -- " ALL_SAY("1 1 1 1 1 1 1 1 1"), 1, REFUSED},
    {"--only eq02 -- " ALL_SAY("1 1 nan 1 1 1 1 1 1"), 1, "\n  looks like nan where `invalid` is due\n"},
    {"--only eq44-nan-n,eq44-nan-Omega -- sh -c 'read o id in; echo $id nan; read o id in; echo $id 1'", 1, "eq44: 2 |!looks like nan"},
    /* what is like nothing known, and one vector alone, are not guessed at: no guess is better than a false one */
    {"--only eq44-random-1,eq44-random-2 -- FAULTY n-7.5", 1, "eq44: 2 wrong\n|!looks like"},
    {"--only flow_linear-rates-100,flow_linear-n-100-100 -- FAULTY zeros", 1, " wrong|!looks like"},
    {"--only rk4_nonlinear-paper-100,rk4_nonlinear-paper-43200,rk4_nonlinear-moving-100 -- FAULTY off", 1, " wrong|!looks like"},
    {"--only eq38-paper -- FAULTY printed-38", 1, "eq38: 1 wrong\n|!looks like"},
    {"--only eq38-paper,eq38-nan-GM -- " ALL_SAY("1.2630391377545192e-4"), 1, "eq38: 1 wrong, 1 a value where invalid is due\n|!looks like"},
};

EACH(a_mistake_of_a_client_is_told_in_words, COUNT(diagnoses))
{
    assert_run(&diagnoses[_i]);
}

/* Failures that are expected speak as well. */
TEST(a_mistake_explains_what_is_expected)
{
    ck_assert_int_eq(system("cut -d, -f1 data/golden/eq44.csv | grep -v -e '^id' -e paper -e large-Omega >\"$CT_BUILD/tests/most\""), 0);
    assert_run(&(struct oracle_run){"--only eq44 --expect \"$CT_BUILD/tests/most\" -- FAULTY n-8", 1,
                                    " of them as expected\n|  looks like n + 1 in place of n\n|33 vectors: 12 passed, 2 failed, 0 skipped, 19 failed as expected\n"});
}

/* ---- what is asked, shown and expected ---- */

CASE(reports, NULL, NULL)

/* Each root beside the one that it is compared with, and a mark where one is off. */
TEST(roots_are_shown_as_a_set_with_a_mark_below_what_is_wrong)
{
    ck_assert_int_eq(conform("--only eq41roots-paper -- sh -c 'read o id in; echo $id -3.0327232498739167e-05 3.8823610912141664e-05 "
                             "-4.2587767501260836e-05 -1.8200486135682383e-04 -4.2587767501260836e-05 1.8200486145682383e-04 "
                             "-3.0327232498739167e-05 -3.8823610912141664e-05'"), 1);
    assert_says("    im2        expected 1.8200486135682382556e-04\n               got      1.8200486145682383e-04\n"
                "                                  ^\n    re3 ");
    assert_says("got      -3.0327232498739167e-05\n    im4        expected 3.8823610912141664092e-05\n"
                "               got      3.8823610912141664e-05\n");
    ck_assert_ptr_null(strstr(strstr(said, " ^\n") + 1, " ^\n"));
    ck_assert_int_eq(conform("--only eq41roots-paper -- sh -c 'read o id in; echo $id -3.0327232498739167e-05 3.8833610912141664e-05 "
                             "-4.2587767501260836e-05 -1.8200486135682383e-04 -4.2587767501260836e-05 1.8200486135682383e-04 "
                             "-3.0327232498739167e-05 -3.8823610912141664e-05'"), 1);
    assert_says("    im4        expected 3.8823610912141664092e-05\n               got      3.8833610912141664e-05\n"
                "                            ^\n");
}

/* Every golden vector of every operation, and those of the four levels are the same. */
TEST(all_that_there_is_is_asked)
{
    ck_assert_int_eq(system("cd \"$CT_BUILD/tests\" && \"$CT_PROGRAM\" conform --questions --range | tee questions | cut -d' ' -f2 | sort >asked && "
                            "\"$CT_PROGRAM\" conform --questions --range --only method,flows,roots,algebra | cmp - questions"), 0);
    ck_assert_int_eq(system("sed -s 1d data/golden/*.csv | cut -d, -f1 | sort | cmp - \"$CT_BUILD/tests/asked\""), 0);
}

/* What is named by its level as well is asked whole, and once. */
TEST(levels_are_asked_with_operations)
{
    ck_assert_int_eq(conform("--only method,eq44,eq44-paper,roots --questions | cut -d- -f1 | sort -u"), 0);
    ck_assert_str_eq(said, "eq41roots eq41roots\neq44 eq44\nrk4_linear rk4_linear\nrk4_nonlinear rk4_nonlinear\n");
}

/* Of each motion what is due, of one that says otherwise that; every failing vector, seven of eq38's after the tenth question; digits by time. */
#define ONES ALL_SAY("1 1 1 1 1 1")
#define BLANKS(width) "sh -c 'printf \"%" width "s\\n\" \"eq38-paper oops\"; cat >/dev/null'"
static const struct oracle_run shown[] = {
    {"--only flow_linear-paper-100 -- " ONES, 1, ", 9 are due"},
    {"--only flow_nonlinear-paper-100 -- " ONES, 1, ", 9 are due"},
    {"--only rk4_linear-paper-100 -- " ONES, 1, ", 11 are due"},
    {"--digits flow_linear=7 --only rk4_nonlinear-paper-100 -- " ONES, 1, ", 11 are due"},
    {"--digits flow_linear=7 --only flow_linear-paper-100 -- " ONES, 1, ", 7 are due"},
    {"--only eq38 --all -- FAULTY printed | grep -c ': wrong, E = '", 0, "7\n"},
    {"--only eq38 -- FAULTY printed | grep -c ': wrong, E = '", 0, "1\n"},
    {"--only flow_linear-rates-100,flow_linear-rates-43200,rk4_linear-rates-100,eq43-paper --all -- FAULTY none", 0,
     "\ndigits by time in s\n  flow_linear-rates                         100: |\n  rk4_linear-rates                          100: "},
    {"--only flow_linear-paper-0,flow_linear-paper--7200 --all -- " ONES, 1, "\n  flow_linear-paper                         0: 0.0  -7200: 0.0\n"},
    {"--only flow_linear-paper-0,flow_linear-paper-100 --all -- " ALL_SAY("nan 1 1 1 1 1"), 1, " NaN|!digits by time"},
    {"--only eq44-boundary,eq44-paper,eq44-boundary,eq43 -- FAULTY none", 0, "eq43                  31       31 |eq44                   2        2 "},
    {"--only eq44,eq44-paper -- FAULTY none", 0, "\n33 vectors: 33 passed, "},
    {"--only eq44-7-3,eq44-7-outside-0 --random 17 --seed 7 -- FAULTY none", 0, "\n2 vectors: 2 passed, "},
    {"--only eq44-paper -- sh -c 'read q; echo eq44-boundary 0; cat >/dev/null'", 1, "  1 wrong id, "}, /* it is not asked */
    /* exact, and infinitely wrong: 0 is margin1 at C1 = 9, Omega = 1; margin2 and stable of n = 10 have E = 0 or infinity */
    {"--only eq42-boundary -- " ALL_SAY("0 1 0"), 0, "        0   exact  eq42-boundary\n"},
    {"--only eq42-no-damping -- " ALL_SAY("1 1e-300 0"), 1, "      inf     0.0  eq42-no-damping\n"},
    /* each reason for a skip once; one operation answered */
    {"--only eq38-paper,eq42,eq43 -- sh -c 'while read o id in; do echo $id skip not yet; done'", 1, "\nskipped, not yet: eq38 eq42 eq43\n"},
    {"--only eq42,eq43 -- sh -c 'while read o id in; do echo $id skip $o; done'", 1, "\nskipped, eq42: eq42\n|\nskipped, eq43: eq43\n"},
    /* of several failures the paper's case, a number that can be followed, one on no scale, a word that is none, and what is missing last */
    {"--only eq44-paper,eq44-random-1,eq44-boundary -- " ALL_SAY("1"), 1, "3 wrong\n  eq44-paper: wrong"},
    {"--only eq44-boundary,eq44-random-1,eq44-random-2 -- " ALL_SAY("1"), 1, "3 wrong\n  eq44-random-1: wrong"},
    {"--only eq44-boundary,eq44-random-2 -- sh -c 'read o id in; echo $id 1; read o id in; echo $id x'", 1, "malformed\n  eq44-boundary: wrong"},
    {"--only eq44-boundary,eq44-random-2 -- sh -c 'read o id in; read o id in; echo $id x; cat >/dev/null'", 1, "1 missing\n  eq44-random-2: malformed"},
    {"--only eq44-random-1,eq44-random-2,eq44-random-3 -- sh -c 'for a in nan oops 1\\ 2; do read o id in; echo $id $a; done'", 1, "first malformed: eq44-random-2 oops\n"},
    /* a line is cut for reports: within its blanks, its id, or its answer */
    {"--only eq38-paper -- " BLANKS("395"), 1, "got        oops\n"},
    {"--only eq38-paper -- " BLANKS("399"), 1, "got        oops\n"},
    {"--only eq38-paper -- " BLANKS("400"), 1, "got        oop\n"},
    {"--only eq38-paper -- " BLANKS("402"), 1, "got        o\n"},
    {"--only eq38-paper -- " BLANKS("403"), 1, "got        nothing\n"},
    {"--only eq38-paper -- " BLANKS("425"), 1, "got        nothing\n"},
};

EACH(what_is_asked_for_is_shown, COUNT(shown))
{
    assert_run(&shown[_i]);
}

/* ---- wrong usage ---- */

static const struct {
    const char *arguments, *says;
} mistakes[] = {
    {"", "expected -- CLIENT"},
    {"--", "after --"},
    {"FAULTY", "/tests/faulty', a client stands after --, did you mean conform -- /"},
    {"python3 my_client.py", "did you mean conform -- python3 my_client.py?"},
    {"-- /nowhere/client", "/nowhere/client': No such file"},
    {"-- ./Makefile", "Permission denied"},
    {"-- README.md", ", did you mean './README.md'?"},
    {"-- false", "exit status 1 before its first answer"},
    {"-- sh -c 'kill -SEGV $$'", "signal 11 before its first answer"},
    {"--only eq7 -- FAULTY", "did you mean 'eq07'"},
    {"--only eq01 -- FAULTY", "definition"},
    {"--only , -- FAULTY", "--only"},
    {"--only eq44-bondary -- FAULTY", "unknown vector 'eq44-bondary', did you mean 'eq44-boundary'?"},
    {"--only eq4-boundary -- FAULTY", "unknown operation 'eq4'"},
    {"--random 5 -- FAULTY", "--seed"},
    {"--random some --seed 1 -- FAULTY", "--random"},
    {"--random 100000001 --seed 1 -- FAULTY", "from 0 to 100000000"},
    {"--timeout 0 -- FAULTY", "--timeout"},
    {"--inputs octal -- FAULTY", "expected shortest, exact or hex, got 'octal'"},
    {"--digits eq07=9 -- FAULTY", "judged by E"},
    {"--digits eq01=9 -- FAULTY", "judged by E"},
    {"--digits flow_linear -- FAULTY", "ID=DIGITS"},
    {"--digits flow_linear=0 -- FAULTY", "from 1 to 30"},
    {"--digits eq1=9 -- FAULTY", "did you mean 'eq01'"},
    {"--digits=flow_linear=x -- FAULTY", "from 1 to 30"},
    {"--digits=flow_linear=15", "expected -- CLIENT"},
    {"--digits flow_linear=9 --digits flow_nonlinear=8 --digits flow_linear=8 -- FAULTY none",
     "--digits: expected flow_linear once, got 'flow_linear=9' and 'flow_linear=8'\n"},
    {"--digits", "--digits"},
    {"x=1 -- FAULTY", "unexpected argument 'x=1'"},
    {"eq07 -- FAULTY", "unexpected argument 'eq07'"},
    {"--seed 1 --random 5 --significand x -- FAULTY", "--significand"},
    {"--report report -- FAULTY", "--report: expected a file .xml or .json, got 'report'"},
    {"-o report -- FAULTY", "-o: expected a file .xml or .json, got 'report'"},
    {"-o a.xml --report b.xml -- FAULTY", "-o: expected without --report, it is the same"},
    {"--significand 64 -- FAULTY", "24, 53 or 113"},
    {"--report report.txt -- FAULTY", ".xml or .json"},
    {"--answers data/golden/eq07.csv eq07 eq09", "id of one operation"},
    {"--answers data/golden/eq07.csv eq07 -- FAULTY", "expected -- CLIENT"},
    {"--answers data/golden/eq07.csv eq09", "line 1: expected id and every output of eq09 in one column each, found 0 of 'BO_11'\n"},
    {"--answers data/golden/eq07.csv --only eq07", "the file has the answers of eq07"},
    {"--answers /dev/null eq07", "header"},
    {"--answers data/golden/eq07.csv --random 1 --seed 1 eq07", "--random"},
    {"--answers data/golden/eq07.csv algebra", "unknown operation 'algebra'"},
    {"--answers data/golden/eq07.csv eq07,eq09", "unknown operation 'eq07,eq09'"},
    {"--answers /dev/zero eq07", "line 1, cell 1: "},
    {"--answers /dev/stdin eq07 </dev/zero", "line 1, cell 1: "},
    {"--random 5 --seed 18446744073709551616 -- FAULTY", "below 2^64"},
};

EACH(wrong_usage_is_one_line_and_exit_2, COUNT(mistakes))
{
    const int status = conform(mistakes[_i].arguments);
    ck_assert_msg(status == 2, "%s: exit %d\n%s", mistakes[_i].arguments, status, said);
    assert_says(mistakes[_i].says);
    ck_assert_ptr_eq(strchr(said, '\n') + 1, said + strlen(said));
}

/* ---- files ---- */

/* A table that a command writes, and what is said of it; of whose answers it has, by its vectors' names, where no id follows. */
#define TABLE(command) "--answers \"$(f=$CT_BUILD/tests/table.csv; { " command "; } >\"$f\"; echo \"$f\")\""
#define EQ07 "awk -F, '{if (NR > 1) print \"\\\"\" $7 \"\\\",\" $1; else print \"Q_ref,id\"}' data/golden/eq07.csv | "
#define EQ07_ROOTS "--only eq07,eq41roots --random 20 --seed 3"
#define QUESTIONS "\"$CT_PROGRAM\" conform --questions " EQ07_ROOTS " "
#define PIPED(change) "--help >/dev/null; sed '" change "' data/golden/eq07.csv | \"$CT_PROGRAM\" conform "
#define NO_TABLE "coulomb-tether: /dev/stdin: a table of no known operation, or through a pipe: expected the operation's id after it\n"
static const struct oracle_run tables[] = {
    {TABLE(EQ07 "sort -r") " eq07", 0, "eq07                  51       51 "}, /* rows and columns in any order */
    {TABLE(EQ07 "sed /eq07-paper/d; echo 1,stranger; " EQ07 "sed -n 3p") " eq07", 1,
     "eq07: 1 missing\n|  1 repeated or out of order, the first is line 53: eq07-|  1 wrong id, the first is line 52: stranger 1\n"},
    /* n = 1e-300 leaves binary64's normal range: what a file has of it is judged on request, all else always */
    {TABLE("sed 's/^\\(eq43-tiny,[^,]*,[^,]*\\),[^,]*/\\1,1/' data/golden/eq43.csv"), 0, " 1 skipped\n"},
    {TABLE("sed 's/^\\(eq43-tiny,[^,]*,[^,]*\\),[^,]*/\\1,1/' data/golden/eq43.csv") " --range", 1, "eq43: 1 wrong\n"},
    {TABLE("sed 's/^\\(eq43-paper,[^,]*,[^,]*\\),[^,]*/\\1,1/' data/golden/eq43.csv"), 1, "eq43: 1 wrong\n"},
    /* as RFC 4180, spreadsheets of several countries and data frames write it */
    {TABLE("awk -F, 'NR == 1 {print \"note,id,\\\"Q_ref\\\"\"} NR > 1 {printf \"\\\"a, \\\"\\\"b\\\"\\\"\\\",\\\"%s\\\",%s\\r\\n\", $1, $7}' data/golden/eq07.csv") " eq07", 0,
     "eq07                  51       51 "},
    {TABLE("awk -F, 'BEGIN {OFS = \";\"; printf \"\\357\\273\\277\"} {print \"a\", $1, $7 \"\\r\"}' data/golden/eq07.csv"), 0, "eq07                  51       51 "},
    {TABLE("awk -F, 'BEGIN {OFS = \"\\t\"} {print $1, $7, \"\"}' data/golden/eq07.csv"), 0, "eq07                  51       51 "},
    {TABLE("awk -F, '{print $1 \",\" (NR > 1 && $7 == \"\" ? NR % 3 ? NR % 3 > 1 ? \"NaN\" : \"nan\" : \"NA\" : $7) \",\\\"a note\\nof two, lines\\\"\"}' data/golden/eq07.csv"), 0,
     "eq07                  51       51 "},
    {TABLE("awk -F, '{print \"\\\"\" $1 \"\\\",\\\"\" $7 \"\\\"\"}' data/golden/eq07.csv"), 0, "eq07                  51       51 "},
    /* what is none, with its place; blank are all outputs, or none */
    {TABLE("echo id,Q_ref; head -c 70000 /dev/zero | tr '\\0' a; echo ,1") " eq07", 2, "table.csv: line 2, cell 1: expected a shorter row\n"},
    {TABLE("printf 'id,Q_ref\\neq07-paper,\"1\\n'") " eq07", 2, "table.csv: line 2, cell 1: "},
    {TABLE("printf 'id;Q_ref\\neq07-paper;-0,00014\\neq07-random-1;\"1\\n2\"\\n'"), 1,
     "'-0,00014' has a decimal comma, a point is due\n|eq07: 1 wrong count, 1 malformed, 49 missing\n"},
    {TABLE("printf 'id,C2\\neq44-paper,1,5\\n'"), 2, "table.csv: line 2 has 3 cells, the header 2: a decimal comma?\n"},
    {TABLE("printf 'id,C2\\neq44-paper\\n'"), 2, "table.csv: line 2 has 1 cell, the header 2\n"},
    {TABLE("printf 'id,w_1,w_2,w_3\\neq25-paper,1,,2\\neq25-random-1,1,NaN,2\\n'"), 1, "eq25: 1 NaN, 1 wrong count, "},
    {TABLE("printf 'id,C2,C2\\neq44-paper,1,5\\n'"), 2, "table.csv: line 1: expected id and every output of eq44 in one column each, found 2 of 'C2'\n"},
    {"--answers data eq07", 1, "data: Is a directory\n"},
    {"--answers data/nothing.csv eq07", 1, "data/nothing.csv: No such file or directory\n"},
    /* a transcript of all operations, perhaps behind an editor's byte order mark; what comes through a pipe is read once, a table with its operation */
    {TABLE(QUESTIONS "| \"$CT_BUILD/tests/faulty\"") " " EQ07_ROOTS, 0, " 0 failed, 0 skipped\n"},
    {TABLE("printf '\\357\\273\\277'; " QUESTIONS "| \"$CT_BUILD/tests/faulty\"") " " EQ07_ROOTS, 0, " 0 failed, 0 skipped\n"},
    {TABLE("yes | head -c 100000"), 1, "expected answers, found lines that answer nothing\n"},
    {"eq07 --answers /dev/stdin <data/golden/eq07.csv", 0, " 0 failed"},
    {PIPED("s/x/x/") "eq07 --answers /dev/stdin", 0, " 0 failed"},
    {"--questions " EQ07_ROOTS " | \"$CT_BUILD/tests/faulty\" | \"$CT_PROGRAM\" conform " EQ07_ROOTS " --answers /dev/stdin", 0, " 0 failed, 0 skipped\n"},
    {PIPED("s/x/x/") "--answers /dev/stdin", 2, NO_TABLE}, /* the operation would be known from the second line */
    {PIPED("s/,/;/g") "--answers /dev/stdin", 2, NO_TABLE},
    {PIPED("1s/id/\"id\"/") "--answers /dev/stdin", 2, NO_TABLE},
    {PIPED("1s/^/\\xef\\xbb\\xbf/") "--answers /dev/stdin", 2, NO_TABLE},
};

EACH(tables_are_read_as_they_are_written, COUNT(tables))
{
    assert_run(&tables[_i]);
}

/* Half a digit short after five days, where C1 and C2 exchanged make a motion of five thousand radians. */
TEST(a_diagnosis_ends)
{
    ck_assert_int_eq(system("printf 'id,x1,y1,z1,x1_dot,y1_dot,z1_dot\\nflow_nonlinear-heavy-and-light-432000,0.00998963217150906,"
                            "-6.355638513927242e-08,9.971916278925862e-05,-3.0083669320652085e-11,2.1976059168129117e-11,"
                            "-2.3756107554970383e-09\\n' >\"$CT_BUILD/tests/one.csv\""), 0);
    const time_t before = time(NULL);
    ck_assert_int_eq(conform("--answers \"$CT_BUILD/tests/one.csv\" flow_nonlinear"), 1);
    assert_says("flow_nonlinear: 1 wrong, 131 missing\n");
    assert_says("-432000: wrong, 8.6 digits, 9 are due\n");
    ck_assert(time(NULL) - before < 30); /* ten minutes without a limit */
}

/* Reports, written and read again. */
#define WRITES(name, options, client) options " --report \"$CT_BUILD/tests/" name "\" -- " client " >/dev/null; s=$?; cat \"$CT_BUILD/tests/" name "\"; exit $s"
#define COMPLAINS(words, fault) "sh -c '" words " >&2; exec \"$0\" " fault "' FAULTY 2>/dev/null"
#define EXPECT(lines) "--expect \"$(f=$CT_BUILD/tests/expect; printf '" lines "' why why >\"$f\"; echo \"$f\")\""
#define KNOWN "# known\\neq38-random-10 the 3\\n\\n  eq38-paper\\neq07-paper\\n"
static const struct oracle_run written[] = {
    {WRITES("r.xml", "--only eq38,eq07", "FAULTY printed"), 1, "<testsuite name=\"eq38\" tests=\"27\" failures=\"17\" errors=\"0\" skipped=\"0\"|"
     "name=\"eq38-random-9\"><failure message=\"wrong\">  eq38-random-9: wrong, E = |name=\"eq07-paper\"></testcase>|"
     "looks like the paper's misprint: Kepler|has already.\n</failure></testcase>|"
     "</testcase>\n</testsuite>\n<testsuite name=\"eq38\"|</testcase>\n</testsuite>\n<testsuite name=\"client\"|name=\"lines\"></testcase>"},
    {WRITES("r.json", "--only eq38,eq07", "FAULTY printed"), 1, "\"vectors\": 78, \"passed\": 61, \"failed\": 17, \"expected\": 0, \"skipped\": 0, |"
     "\"id\": \"eq38\", \"level\": \"algebra\", \"vectors\": 27, \"passed\": 10, \"failed\": 17, |\"diagnosis\": \"the paper's misprint: Kepler|"
     "\"id\": \"eq38-random-9\", \"operation\": \"eq38\", \"outcome\": \"wrong\", \"E\": \"2.2e+15\", |\"R_c\": \"87708441.19820815\"}, \"expected\": {\"Omega\": \"1.2994298160714638761e-05\"}, |"
     "\"id\": \"eq07-paper\", \"operation\": \"eq07\", \"outcome\": \"right\", |\"outcomes\": {\"wrong\": 17}|"
     "\"id\": \"eq38-nan-GM\", \"operation\": \"eq38\", \"outcome\": \"right\", \"inputs\": "},
    {WRITES("r.json", "--only eq38,eq07", "FAULTY malformed"), 1,
     "\"line\": {\"outcome\": \"malformed\", \"text\": \"eq07-random-7 1.5 oops\", \"hint\": \"'oops' is no number\"}|"
     "\"outcome\": \"malformed\", \"inputs\": "},
    {WRITES("r.json", "--only flow_linear-paper-100,flow_linear-paper-0", ALL_SAY("`test $id = flow_linear-paper-0 && echo 1` nan 1 1 1 1")), 1,
     "\"outcome\": \"wrong count\", \"inputs\": "},
    {WRITES("r.json", "--only flow_linear-paper-100", ALL_SAY("1 1 1 1 1 1")), 1, "\"outcome\": \"wrong\", \"digits\": \"0.0\", \"inputs\": "},
    {WRITES("r.json", "--only eq38,eq07", "FAULTY wrong-id"), 1, "\"lines\": [{\"count\": 68, \"first\": 11, \"outcome\": \"wrong id\", "},
    {WRITES("r.json", "--only eq38,eq07", "FAULTY exit-3"), 1, "\"ended\": \"ended with exit status 3 after 78 of 78 answers\""},
    {WRITES("r.json", "--only eq38", "FAULTY too-long"), 1, "\"lines\": [{\"count\": 1, \"first\": 11, \"outcome\": \"too long\", "},
    /* what a client that has left was never asked is missing too */
    {"--only eq43 --random 5000 --seed 1 --report \"$CT_BUILD/tests/r.json\" -- true >/dev/null; grep -o '\"missing\": [0-9]*' \"$CT_BUILD/tests/r.json\"", 0,
     "\"missing\": 5344\n"},
    {WRITES("r.json", "--only eq38", "FAULTY crash"), 1, "\"outcomes\": {\"missing\": 16, \"crash\": 1}"},
    {WRITES("r.json", "--only eq37", "FAULTY cross"), 0, "\"E\": \"2.2e-01\", \"strict_E\": \"inf\"|, \"L_G3\": \"1.7316332501930193480e-09\"}, "},
    {WRITES("r.json", "--only eq38", COMPLAINS("echo \"a <word>\"", "none")), 0, "\"errors\": \"a <word>\\n\""},
    {WRITES("r.xml", "--only eq38,eq07", "FAULTY wrong-id"), 1,
     "<testcase classname=\"client\" name=\"lines\"><failure message=\"lines that answer nothing, or an end that is none\">\nlines that answer nothing: 68\n"},
    {WRITES("r.xml", "--only eq38,eq07", "FAULTY exit-3"), 1, "name=\"lines\"><failure |\nthe client ended with exit status 3 "},
    {"--only eq07 --report /nowhere/report.json -- FAULTY none", 1, "/nowhere/report.json: No such file"},
    {"--only eq02,eq03 --report \"$(f=$CT_BUILD/tests/full.xml; ln -sf /dev/full \"$f\"; echo \"$f\")\" -- FAULTY none", 1, "/full.xml: No space left on device\n"},
    /* of standard error the last 2000 bytes, in however many pieces they come; a zero byte hides nothing, and nothing breaks a report */
    {WRITES("r.json", "--only eq38", COMPLAINS("{ echo one; sleep 0.1; echo two; }", "none")), 0, "\"errors\": \"one\\ntwo\\n\""},
    {"--only eq38 --report \"$CT_BUILD/tests/r.json\" -- " COMPLAINS("{ printf %3000s; sleep 0.1; echo end; }", "none")
     " >/dev/null; sed -n 's/.*\"errors\": \"\\( *end\\\\n\\)\".*/\\1/p' \"$CT_BUILD/tests/r.json\" | wc -c", 0, "2002\n"},
    {WRITES("r.json", "--only eq38", COMPLAINS("printf \"before\\000after\\000\"", "none")), 0, "\"errors\": \"before\\u0001after\\u0001\""},
    {WRITES("r.xml", "--only eq07,eq38", COMPLAINS("printf \"<>&\\042\\047\\134\\001\\n\"", "skip")), 1,
     "&#60;&#62;&#38;&#34;'\\?\n|name=\"eq07-paper\"><skipped message=\"skipped\"/></testcase>"},
    {WRITES("r.json", "--only eq07,eq38", COMPLAINS("printf \"<>&\\042\\047\\134\\001\\n\"", "skip")), 1, "<>&\\\"'\\\\\\u0001\\n|\"passed\": 0, \"failed\": 0, \"expected\": 0, \"skipped\": 78, "},
    /* a report is of the kind that its name ends with: a dot-file's name is all ending */
    {WRITES(".xml", "--only eq07", "FAULTY none"), 0, "<?xml "},
    {WRITES(".json", "--only eq07", "FAULTY none"), 0, "{\n  \"client\""},
    {WRITES("a-name-of-a-report-that-is-longer-than-most-names-are.xml.json", "--only eq07", "FAULTY none"), 0, "{\n  \"client\""},
    {"--only eq07 --report a.xml/b -- FAULTY none", 2, ".xml or .json"},
    /* expected failures are none; what passes is said; no name that no vector has, none that is left out either; the rest of a long line is none */
    {WRITES("r.json", "--only eq38 " EXPECT(KNOWN), "FAULTY printed") "; cat \"$CT_BUILD/tests/r.json\"", 1, "\"expected_to_fail\": true"},
    {"--only eq38 " EXPECT(KNOWN) " -- FAULTY printed", 1, "eq38                  27       20       6 |, 1 failed as expected\n|"
     "\neq38-paper was expected to fail, and passes\n|eq38: 7 wrong; 1 of them as expected\n"},
    {"--only eq38-random-10,eq38-paper --all " EXPECT(KNOWN) " -- " ALL_SAY("1"), 0, "eq38-random-10: wrong, E = |, at most 8 passes, as expected\n"},
    {"--only eq38-paper,eq38-random-9 " EXPECT(KNOWN) " -- " ALL_SAY("1"), 1, "1 of them as expected\n  eq38-random-9: wrong|!eq38-paper:"},
    {"--only eq38-random-10,eq38-paper " EXPECT(KNOWN) " -- " ALL_SAY("`test $id = eq38-paper && echo skip || echo 1`"), 0, "1 skipped|!and passes"},
    {WRITES("r.xml", "--only eq38-random-10,eq38-paper " EXPECT(KNOWN), ALL_SAY("1")), 0, "<skipped message=\"fails as expected\"/>"},
    {EXPECT(KNOWN) " -- true", 1, "0 passed"},
    {EXPECT(KNOWN "eq38-papers\\n") " -- FAULTY none", 2, "expect: line 6: unknown vector 'eq38-papers'\n"},
    {"--only eq07 " EXPECT(KNOWN "eq38-papers\\n") " -- FAULTY none", 2, "expect: line 6: unknown vector 'eq38-papers'\n"},
    {"--only eq07 " EXPECT("eq99-paper") " -- FAULTY none", 2, "expect: line 1: unknown vector '"},
    {"--only eq07 " EXPECT("eq01-paper") " -- FAULTY none", 2, "expect: line 1: unknown vector '"},
    {"--only eq07 " EXPECT("paper") " -- FAULTY none", 2, "expect: line 1: unknown vector '"},
    {"--expect \"$CT_BUILD\" -- FAULTY none", 1, "Is a directory"},
    {"--expect /nowhere -- FAULTY none", 1, "/nowhere: No such file"},
    {EXPECT("eq38-paper%300s\\neq38-random-10\\neq07-paper%400s") " -- true", 1, "0 passed"},
};

EACH(reports_say_the_same_and_what_is_expected, COUNT(written))
{
    assert_run(&written[_i]);
}

/* A full disk, and a name that is taken by a folder: no report, and nothing of it left. */
TEST(a_report_is_there_whole_or_not_at_all)
{
    ck_assert_int_eq(system("cd \"$CT_BUILD/tests\" && rm -rf full taken.xml* && mkdir full taken.xml && cd full && "
                            "trap '' XFSZ && ulimit -f 0 && ! \"$CT_PROGRAM\" conform --only eq07 --report full.json -- "
                            "\"$CT_BUILD/tests/faulty\" none >&2 2>/dev/null && ! ls | grep ."), 0);
    ck_assert_int_eq(conform("--only eq07 --report \"$CT_BUILD/tests/taken.xml\" -- FAULTY none"), 1);
    assert_says("/tests/taken.xml: Is a directory\n");
    ck_assert_int_ne(system("cd \"$CT_BUILD/tests\" && ls taken.xml*tmp 2>/dev/null | grep ."), 0);
}

/* ---- time ---- */

/* A second is the limit at most; each of these moves bytes all the time, or has somebody else do so, and answers nothing. */
static const struct oracle_run slow[] = {
    {"--only eq38 --timeout 1 -- sh -c 'while :; do printf x; sleep 0.2; done'", 1, " 1 time-out\n"},
    {"--only eq38 --timeout 0.3 -- sh -c 'exec yes >&2' 2>/dev/null", 1, " 1 time-out\n"},
    {"--only eq38 --timeout 1 -- sh -c 'sleep 60 & exec \"$0\" none' FAULTY", 0, " 0 failed"},
    {"--only eq38 --timeout 1 -- cat /dev/zero", 1, "1 too long"},
    /* nobody reads what it complains of for longer than that; questions are taken, and nothing answered before the last */
    {"--only eq38 --timeout 2 -- sh -c 'head -c 200000 /dev/zero >&2; exec \"$0\"' FAULTY 2>&1 >\"$CT_BUILD/tests/blocked\" | "
     "{ sleep 3; wc -c; cat \"$CT_BUILD/tests/blocked\"; }", 0, "200000\n| 0 failed"},
    {"--only eq07 --random 5000 --seed 1 --timeout 2 -- sh -c 'f=$CT_BUILD/tests/taken; rm -f \"$f\"; for i in 1 2 3 4; do head -c 100000 >>\"$f\"; sleep 0.8; done; "
     "cat >>\"$f\"; exec \"$0\" <\"$f\"' FAULTY", 0, " 0 failed"},
    /* somebody else's child is not waited for */
    {"--help >/dev/null; sleep 9 >/dev/null 2>&1 & exec \"$CT_PROGRAM\" conform -- /nowhere/client", 2, "/nowhere/client': No such file"},
    /* an answer every third of a second is in time, though all of them take longer than one */
    {"--only eq38 --timeout 1 -- sh -c 'head -n 8 >/dev/null; for i in 1 2 3 4 5 6 7 8; do sleep 0.3; echo eq38-random-$i skip it; done; cat >/dev/null'", 1, "!time-out"},
};

EACH(time_is_up_by_the_clock, COUNT(slow))
{
    const time_t before = time(NULL);
    assert_run(&slow[_i]);
    ck_assert_int_lt(time(NULL) - before, 8); /* and not the sleeper's minute */
}

/* Each pipe to the client takes two descriptors, and some more the program: with fewer it says so. */
TEST(a_client_is_not_started_without_descriptors)
{
    for (int most = 4; most < 9; most++) {
        char line[300];
        snprintf(line, sizeof line, "exec 2>&1 </dev/null 3>&- 4>&- 5>&- 6>&- 7>&- 8>&- 9>&-; ulimit -n %d; "
                 "exec \"$CT_PROGRAM\" conform --only eq07 -- true", most);
        FILE *pipe = popen(line, "r");
        ck_assert_ptr_nonnull(pipe);
        said[fread(said, 1, sizeof said - 1, pipe)] = '\0';
        ck_assert_int_eq(WEXITSTATUS(pclose(pipe)), 1);
        assert_says("client 'true': Too many open files\n");
    }
}

/* No descriptor and no signal of ours, the mask that we have from others, in a process group of its own. A shell may clear its mask with a wait. */
TEST(a_client_starts_as_from_a_shell)
{
    sigset_t mask;
    ck_assert_int_eq(system("cd \"$CT_BUILD/tests\" && rm -f group && echo 'while read -r name mask; do case $name in SigBlk:|SigIgn:) echo $mask; esac; done "
                            "</proc/self/status >\"$1\"; ls /proc/self/fd >>\"$1\"; test \"$(cut -d\" \" -f5 /proc/$$/stat)\" = $$ && : >group; exec \"$2\"' >starts"), 0);
    sigemptyset(&mask);
    sigaddset(&mask, SIGUSR1);
    sigprocmask(SIG_BLOCK, &mask, NULL);
    ck_assert_int_eq(system("cd \"$CT_BUILD/tests\" && exec sh starts direct true"), 0);
    ck_assert_int_eq(system("cd \"$CT_BUILD/tests\" && exec \"$CT_PROGRAM\" conform --only eq38 -- sh starts client ./faulty >/dev/null"), 0);
    ck_assert_int_eq(system("cd \"$CT_BUILD/tests\" && grep -qE '^0*200$' direct && cmp direct client && ls group >/dev/null"), 0);
}

/* ---- an interrupt ---- */

/* Whether a process still runs: one that only waits to be asked for its status does not. */
static bool runs(long pid)
{
    char name[64], state = 'Z';
    snprintf(name, sizeof name, "/proc/%ld/stat", pid);
    FILE *file = fopen(name, "r");
    if (file == NULL)
        return false;
    if (fscanf(file, "%*d %*s %c", &state) != 1)
        state = 'Z';
    fclose(file);
    return state != 'Z';
}

static void nap(void)
{
    nanosleep(&(struct timespec){.tv_nsec = 20000000}, NULL);
}

EACH(an_interrupt_leaves_no_process_behind, 4)
{
    static const int interrupts[] = {SIGINT, SIGTERM, SIGHUP, SIGQUIT};
    char client[512], pids[512];
    const char *program = getenv("CT_PROGRAM");
    long process = 0, child = 0;
    int status;
    ck_assert_ptr_nonnull(program);
    snprintf(client, sizeof client, "%s/tests/faulty", getenv("CT_BUILD"));
    snprintf(pids, sizeof pids, "%s/tests/pids.%d", getenv("CT_BUILD"), _i);
    remove(pids);
    const pid_t oracle = fork();
    ck_assert_int_ge(oracle, 0);
    if (oracle == 0) {
        setrlimit(RLIMIT_CORE, &(struct rlimit){0, 0});
        signal(interrupts[_i], SIG_DFL); /* which nohup, and a shell for what runs in the background, let it ignore */
        ck_assert_ptr_nonnull(freopen("/dev/null", "w", stdout));
        execl(program, "coulomb-tether", "conform", "--only", "eq07", "--", client, "hang", pids, (char *)NULL);
        _exit(127);
    }
    for (int i = 0; i < 500 && child == 0; i++) {
        FILE *file = fopen(pids, "r");
        if (file != NULL && fscanf(file, "%ld %ld", &process, &child) != 2)
            child = 0;
        if (file != NULL)
            fclose(file);
        nap();
    }
    ck_assert(runs(process) && runs(child));
    const time_t before = time(NULL);
    kill(oracle, interrupts[_i]);
    ck_assert_int_eq(waitpid(oracle, &status, 0), oracle);
    ck_assert(WIFSIGNALED(status) && WTERMSIG(status) == interrupts[_i]);
    ck_assert_int_lt(time(NULL) - before, 30); /* and not after the client's minute of silence */
    for (int i = 0; i < 500 && (runs(process) || runs(child)); i++)
        nap();
    ck_assert(!runs(process) && !runs(child));
}

/* What is ignored, as in the background, interrupts nothing: the client ends by itself and is judged. */
TEST(an_interrupt_that_is_ignored_does_nothing)
{
    ck_assert_int_eq(system("trap '' INT; \"$CT_PROGRAM\" conform --only eq38 -- sh -c 'kill -INT $PPID; exec \"$0\" none' "
                            "\"$CT_BUILD/tests/faulty\" >/dev/null"), 0);
}

/* ---- the kill table ---- */

TEST(a_vector_kills_mistakes_or_pins_an_edge)
{
    ck_assert_msg(conform("--kills --only eq21,eq38") == 0, "%s", said); /* data/kills.csv is all of it */
    ck_assert_int_eq(strncmp(said, "id,mistakes\n", 12), 0);
    assert_says("\neq38-paper,as printed; the square of it\n");
}
