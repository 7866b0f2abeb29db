/*
 * A client of the oracle for the oracle's own test: right in everything but the fault that its first argument
 * names. The second, where a fault needs one, is a file for its process number.
 */
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/types.h>
#include <unistd.h>

#include "evaluate/reference.h"

enum { MOST_NUMBERS = 40, OUTPUTS = 16, LONGEST = 4096 };

struct asked {
    char operation[40], id[100];
    double in[MOST_NUMBERS], out[OUTPUTS];
    int inputs, outputs;
    bool valid;
};

static bool equal(double x, double y)
{
    return !(x < y) && !(x > y) && !isnan(x);
}

static void compute(struct asked *a)
{
    reference_function *function = reference_find(a->operation);
    const double unset = -0x1.23456789abcdep-1000; /* ref/ does not tell how many outputs there are: it sets them */
    for (int i = 0; i < OUTPUTS; i++)
        a->out[i] = unset;
    if (function != NULL)
        function(a->in, a->out);
    for (a->outputs = 0; a->outputs < OUTPUTS && !equal(a->out[a->outputs], unset); a->outputs++)
        continue;
    a->valid = function != NULL && !isnan(a->out[0]);
}

static void understand(struct asked *a, char *line)
{
    char *rest = NULL, *word = strtok_r(line, " \n", &rest);
    *a = (struct asked){.outputs = 1};
    snprintf(a->operation, sizeof a->operation, "%s", word ? word : "");
    word = strtok_r(NULL, " \n", &rest);
    snprintf(a->id, sizeof a->id, "%s", word ? word : "");
    while (a->inputs < MOST_NUMBERS && (word = strtok_r(NULL, " \n", &rest)) != NULL)
        a->in[a->inputs++] = strtod(word, NULL);
}

static void say(const struct asked *a, const char *end)
{
    fputs(a->id, stdout);
    if (!a->valid)
        fputs(" invalid", stdout);
    for (int i = 0; i < a->outputs && a->valid; i++)
        printf(" %.17g", a->out[i]);
    fputs(end, stdout);
}

/* Mistakes in the answers themselves; `fault` is at work from the 11th question on. */
static void spoil(struct asked *a, const char *fault)
{
    if (strcmp(fault, "nan") == 0)
        a->out[0] = NAN;
    else if (strcmp(fault, "inf") == 0)
        a->out[0] = INFINITY;
    else if (strcmp(fault, "wrong") == 0)
        a->out[0] *= 1.0 + 1e-13;
    else if (strcmp(fault, "off") == 0)
        a->out[0] *= 1.01;
    else if (strcmp(fault, "count") == 0)
        a->outputs--;
    else if (strcmp(fault, "invalid") == 0)
        a->valid = false;
    else if (strcmp(fault, "value") == 0)
        a->valid = true;
    else if (strcmp(fault, "wrong-id") == 0)
        snprintf(a->id, sizeof a->id, "somebody");
    else if (strcmp(fault, "printed") == 0 && strcmp(a->operation, "eq38") == 0)
        a->out[0] = sqrt(3.0 * a->in[0] / (a->in[1] * a->in[1] * a->in[1]));
    else if (strcmp(fault, "backwards") == 0 && strcmp(a->operation, "flow_linear") == 0) {
        a->in[4] = -a->in[4]; /* t */
        compute(a);
    } else if (strcmp(fault, "float") == 0)
        for (int i = 0; i < a->outputs; i++)
            a->out[i] = (double)(float)a->out[i];
}

/* Two processes, their numbers in the file, that only a signal ends. */
static void hang(const char *file)
{
    const long process = (long)getpid(), child = (long)fork();
    FILE *pids = file && child > 0 ? fopen(file, "w") : NULL;
    if (pids != NULL) {
        fprintf(pids, "%ld %ld\n", process, child);
        fclose(pids);
    }
    for (;;)
        pause();
}

/* What is said in place of answer number n; true when that was all. */
static bool misbehave(const struct asked *a, const char *fault, const char *file, long n)
{
    static struct asked held; /* the answer that a later one overtakes */
    const bool once = n == 11;
    if (once && strcmp(fault, "missing") == 0)
        return true;
    if (once && strcmp(fault, "repeated") == 0)
        say(a, "\n");
    if (once && strcmp(fault, "reordered") == 0) {
        held = *a;
        return true;
    }
    if (n == 12 && strcmp(fault, "reordered") == 0) {
        say(a, "\n");
        say(&held, "\n");
        return true;
    }
    if (once && strcmp(fault, "malformed") == 0) {
        printf("%s 1.5 oops\n", a->id);
        return true;
    }
    if (once && strcmp(fault, "binary") == 0) {
        fwrite("\0\377\376\x1b noise \200\n", 1, 13, stdout);
        return true;
    }
    if (once && strcmp(fault, "too-long") == 0) {
        for (int i = 0; i < 1 << 20; i++)
            putchar('1');
        putchar('\n');
        return true;
    }
    if (once && strcmp(fault, "truncated") == 0) {
        printf("%s -1.3", a->id);
        exit(EXIT_SUCCESS);
    }
    if (once && strcmp(fault, "hang") == 0) {
        fflush(stdout);
        hang(file);
    }
    if (once && strcmp(fault, "crash") == 0) {
        fflush(stdout);
        abort();
    }
    if (strcmp(fault, "skip") == 0) {
        printf("%s skip not written yet\n", a->id);
        return true;
    }
    return false;
}

/* The faults of a client that pays no attention. */
static int without_questions(const char *fault)
{
    char line[LONGEST];
    if (strcmp(fault, "dies") == 0)
        return 9;
    if (strcmp(fault, "flood") == 0)
        while (puts("y") >= 0 && fflush(stdout) == 0)
            ;
    if (strcmp(fault, "early") == 0) {
        puts("eq44-negative invalid");
        fflush(stdout);
    }
    while (strcmp(fault, "early") != 0 && fgets(line, sizeof line, stdin) != NULL)
        ; /* empty: hears everything, says nothing */
    return 0;
}

int main(int count, char **arguments)
{
    const char *fault = count > 1 ? arguments[1] : "none", *file = count > 2 ? arguments[2] : NULL;
    char line[LONGEST];
    long n = 0;
    if (strcmp(fault, "dies") == 0 || strcmp(fault, "flood") == 0 || strcmp(fault, "empty") == 0 ||
        strcmp(fault, "early") == 0) {
        const int status = without_questions(fault);
        if (strcmp(fault, "early") != 0)
            return status;
    }
    while (fgets(line, sizeof line, stdin) != NULL) {
        struct asked a;
        understand(&a, line);
        compute(&a);
        n++;
        if (n > 10)
            spoil(&a, fault);
        if (misbehave(&a, fault, file, n))
            continue;
        say(&a, strcmp(fault, "crlf") == 0 ? "\r\n" : "\n");
    }
    if (strcmp(fault, "extra") == 0)
        puts("eq07-paper 1\nthat was all");
    fflush(stdout);
    return strcmp(fault, "exit-3") == 0 ? 3 : 0;
}
