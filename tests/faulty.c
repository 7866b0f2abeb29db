/*
 * A client of the oracle for the oracle's own test: right in everything but the fault that its first argument
 * names. The second, where a fault needs one, is a file for its process number.
 */
#include <sys/types.h>
#include <unistd.h>

#include "tests/clients/answer.h"

/* Mistakes in the answers themselves; `fault` is at work from the 11th question on. */
static void spoil(struct asked *a, const char *fault)
{
    if (strcmp(fault, "wrong") == 0)
        a->out[0] *= 1.0 + 1e-13;
    else if (strcmp(fault, "invalid") == 0)
        a->valid = false;
    else if (strcmp(fault, "value") == 0) {
        for (int i = 0; i < a->outputs && !a->valid; i++)
            a->out[i] = 1.0;
        a->valid = true;
    }
    else if (strcmp(fault, "zero-charge") == 0 && equal(a->in[0] + a->in[1], 0.0)) { /* of eq21, where it is to be refused */
        memset(a->out, 0, sizeof a->out);
        a->valid = true;
    } else if (strcmp(fault, "wrong-id") == 0)
        snprintf(a->id, sizeof a->id, "somebody");
    else if (strcmp(fault, "printed") == 0 && strcmp(a->operation, "eq38") == 0)
        a->out[0] = sqrt(3.0 * a->in[0] / (a->in[1] * a->in[1] * a->in[1]));
}

/* Euler's method, the classical Runge-Kutta method, and that with another sign in the linear model: a coupling of dL_dot to psi_ddot. */
static void integrate(struct asked *a, double h, bool euler, double sign)
{
    double y[6], rate[6], at[6], sum[6];
    const double Omega = a->in[0], L_ref = a->in[1], C1 = a->in[2], C2 = a->in[3], t = a->in[4];
    const long steps = lround(fabs(t / h));
    memcpy(y, a->in + 5, sizeof y);
    for (long n = 0; n < steps; n++) {
        memcpy(at, y, sizeof at);
        memset(sum, 0, sizeof sum);
        for (int stage = 0; stage < (euler ? 1 : 4); stage++) {
            memcpy(rate, at + 3, 3 * sizeof *rate);
            rate[3] = sign * 2.0 * Omega / L_ref * at[5] - 3.0 * Omega * Omega * at[0];
            rate[4] = -4.0 * Omega * Omega * at[1];
            rate[5] = -C2 * at[5] + 2.0 * Omega * L_ref * at[3] - (C1 - 9.0 * Omega * Omega) * at[2];
            for (int i = 0; i < 6; i++) {
                sum[i] += rate[i] * (euler ? 1.0 : stage == 0 || stage == 3 ? 1.0 / 6.0 : 1.0 / 3.0);
                at[i] = y[i] + (stage < 2 ? 0.5 : 1.0) * t / (double)steps * rate[i];
            }
        }
        for (int i = 0; i < 6; i++)
            y[i] += t / (double)steps * sum[i];
    }
    memcpy(a->out, y, sizeof y);
}

/* Mistakes of the formulas, in every answer. */
static void mistake(struct asked *a, const char *fault)
{
    if (strcmp(fault, "zeros") == 0)
        memset(a->out, 0, sizeof a->out);
    else if (strcmp(fault, "off") == 0)
        a->out[0] *= 1.01;
    else if (strcmp(fault, "backwards") == 0) {
        a->in[4] = -a->in[4]; /* t of flow_linear */
        compute(a);
    } else if (strcmp(fault, "float") == 0)
        for (int i = 0; i < a->outputs; i++)
            a->out[i] = (double)(float)a->out[i];
    else if (strcmp(fault, "at-least") == 0)
        a->out[2] = a->out[0] >= 0.0 && a->out[1] >= 0.0;
    else if (strcmp(fault, "printed-38") == 0)
        a->out[0] *= sqrt(3.0);
    else if (strncmp(fault, "n-", 2) == 0) /* n-8 for n - 9 */
        a->out[0] = 2.0 * a->in[0] * sqrt(a->in[1] - strtod(fault + 2, NULL));
    else if (strcmp(fault, "units") == 0)
        for (int i = 0; i < 8; i++)
            a->out[i] /= a->in[0];
    else if (strcmp(fault, "conjugates") == 0)
        for (int i = 1; i < 8; i += 2)
            a->out[i] = fabs(a->out[i]);
    else if (strcmp(fault, "cross") == 0) { /* eq37 as r x (I r), which is right */
        const double *r = a->in + 1, I = a->in[4], R = sqrt(r[0] * r[0] + r[1] * r[1] + r[2] * r[2]), c = 3.0 * a->in[0] / pow(R, 5.0);
        a->out[0] = c * (r[1] * (I * r[2]) - r[2] * (I * r[1]));
        a->out[1] = c * (r[2] * (0.0 * r[0]) - r[0] * (I * r[2]));
        a->out[2] = c * (r[0] * (I * r[1]) - r[1] * (0.0 * r[0]));
    } else if (strcmp(fault, "euler") == 0)
        integrate(a, a->inputs > 11 ? a->in[11] : 10.0, true, -1.0);
    else if (strcmp(fault, "coupling") == 0)
        integrate(a, 1.0, false, 1.0);
    else if (strcmp(fault, "long-step") == 0)
        integrate(a, a->inputs > 11 ? 2.0 * a->in[11] : 300.0, false, -1.0);
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
    const bool once = n == 11;
    if (once && strcmp(fault, "missing") == 0)
        return true;
    if (once && strcmp(fault, "repeated") == 0)
        say(a, "\n");
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
    return strcmp(fault, "empty") == 0; /* hears everything, says nothing */
}

/* What is said before the first question. */
static void begin(const char *fault)
{
    if (strcmp(fault, "dies") == 0)
        exit(9);
    if (strcmp(fault, "flood") == 0)
        while (puts("y") >= 0 && fflush(stdout) == 0)
            ;
    if (strcmp(fault, "early") == 0) {
        puts("eq44-negative invalid");
        fflush(stdout);
    }
}

int main(int count, char **arguments)
{
    const char *fault = count > 1 ? arguments[1] : "none", *file = count > 2 ? arguments[2] : NULL;
    char line[LONGEST];
    long n = 0;
    begin(fault);
    while (fgets(line, sizeof line, stdin) != NULL) {
        struct asked a;
        understand(&a, line);
        compute(&a);
        n++;
        if (n > 10)
            spoil(&a, fault);
        if (a.valid)
            mistake(&a, fault);
        if (misbehave(&a, fault, file, n))
            continue;
        if (strcmp(fault, "ends-in-the-middle") == 0 && n > 5)
            break;
        say(&a, strcmp(fault, "crlf") == 0 ? "\r\n" : "\n");
    }
    if (strcmp(fault, "extra") == 0)
        puts("eq07-paper 1\nthat was all");
    fflush(stdout);
    return strcmp(fault, "exit-3") == 0 ? 3 : 0;
}
