/* The command line as its users meet it: what it prints, where, and with which exit code. */
#define _XOPEN_SOURCE 700 /* NOLINT(bugprone-reserved-identifier): the name is POSIX's, and needed for a terminal */

#include "tests/run.h"
#include "tests/paper.h"

#include <ctype.h>
#include <fcntl.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#include "command/command.h"

enum { MOST_TEXT = 1 << 20, MOST_WORDS = 40 };

static char output[MOST_TEXT], errors[MOST_TEXT];
static const char *input; /* the program's standard input, NULL: the test's own */

static void read_back(FILE *file, char *text)
{
    rewind(file);
    size_t length = fread(text, 1, MOST_TEXT - 1, file);
    text[length] = '\0';
    fclose(file);
}

/* Runs the program with the words of a line, '' being an empty one; returns its exit status, -1 for a signal. */
static int run_to(const char *line, int out)
{
    static char words[4096];
    char *arguments[MOST_WORDS + 2] = {getenv("CT_PROGRAM")}, *rest = NULL;
    FILE *error_file = tmpfile(), *input_file = tmpfile();
    int count = 1, status;
    ck_assert_ptr_nonnull(arguments[0]);
    ck_assert_ptr_nonnull(error_file);
    snprintf(words, sizeof words, "%s", line);
    for (char *word = strtok_r(words, " ", &rest); word && count <= MOST_WORDS; word = strtok_r(NULL, " ", &rest))
        arguments[count++] = strcmp(word, "''") == 0 ? word + 2 : word;
    ck_assert_ptr_nonnull(input_file);
    ck_assert(input == NULL || (fputs(input, input_file) >= 0 && fflush(input_file) == 0));
    rewind(input_file);
    pid_t child = fork();
    ck_assert_int_ge(child, 0);
    if (child == 0) {
        if (input != NULL)
            dup2(fileno(input_file), 0);
        dup2(out, 1);
        dup2(fileno(error_file), 2);
        execv(arguments[0], arguments);
        _exit(127);
    }
    ck_assert_int_eq(waitpid(child, &status, 0), child);
    fclose(input_file);
    read_back(error_file, errors);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

static int run(const char *line)
{
    FILE *file = tmpfile();
    ck_assert_ptr_nonnull(file);
    int status = run_to(line, fileno(file));
    read_back(file, output);
    return status;
}

static int lines(const char *text)
{
    int count = 0;
    for (; *text != '\0'; text++)
        count += *text == '\n';
    return count;
}

#define TABLE1 "Omega=7.2915e-5 k_c=8.99e9 m1=150 m2=150 L=10"

#define REST " psi_0=0.01 theta_0=0.01 dL_0=0 psi_dot_0=0 theta_dot_0=0 dL_dot_0=0"

/* Wrong lines: the status, and a word that the one line on standard error has to say. */
static const struct {
    const char *line;
    int status;
    const char *says;
} mistakes[] = {
    {"", 2, "subcommand"},
    {"''", 2, "subcommand"},
    {"evil", 2, "eval"},
    {"ev\nil", 2, "unknown subcommand 'ev?il'"},
    {"--hlep", 2, "did you mean '--help'"},
    {"-X", 2, "unknown option '-X'"},
    {"hlep", 2, "did you mean 'help'"},
    {"eval -x", 2, "unknown option '-x'"},
    {"help trajectry", 2, "did you mean 'trajectory'"},
    {"help eval figure", 2, "unexpected argument 'figure'"},
    {"equations eq1", 2, "unknown operation 'eq1'"},
    {"equations eq07 eq09", 2, "eq09"},
    {"eval", 2, "operation"},
    {"eval eq077", 2, "did you mean 'eq07'"},
    {"eval eq08", 2, "definition"},
    {"eval -- eq07", 2, "unknown option '--', see coulomb-tether help eval\n"}, /* near to -o in no more than its dashes */
    {"eval eq07 " TABLE1 " extra", 2, "extra"},
    {"eval eq07 " TABLE1 " ''", 2, "empty"},
    {"eval eq07 Omega=7.2915e-5 k_c=8.99e9 m1=150 m2=150", 2, "missing L [m]; --table1"},
    {"eval eq07 m1=1", 2, "missing Omega [rad/s], k_c [N m^2/C^2], m2 [kg], L [m]; --table1"},
    {"eval eq07 nonsense=1", 2, "unknown name 'nonsense', there are: Omega k_c m1 m2 L"},
    {"eval eq07 --table1 m1=-1", 1, "m1"},
    {"eval flow_nonlinear --table1 m1=-150", 1, "m1"}, /* of no mass together there is no state to begin with */
    {"eval eq44 N=10 omega=1", 2, "did you mean 'n'?"},
    {"equations EQ7", 2, "did you mean 'eq07'?"},
    {"eval - n=3", 2, "n=3"},
    {"eval - --json", 2, "--json does nothing here"},
    {"eval eq07 " TABLE1 " L=11", 2, "L: given twice"},
    {"eval eq07 " TABLE1 " m3=11", 2, "unknown name 'm3', did you mean 'm1'? there are: Omega k_c m1 m2 L"},
    {"eval eq07 Omega=nan k_c=8.99e9 m1=150 m2=150 L=10", 1, "Omega"},
    {"eval eq07 Omega=7.2915e-5 k_c=8.99e9 m1=-150 m2=150 L=10", 1, "m1"},
    {"eval eq07 Omega=7.2915e-5 k_c=8.99e9 m1=150 m2=150 L=0", 1, "L"},
    {"eval eq07 Omega=7.2915e-5 k_c=8.99e9 m1=150 m2=150 L=1e400", 1, "binary64"},
    {"eval eq07 Omega=1e400 k_c=8.99e9 m1=word m2=150 L=1", 2, "m1"},
    {"eval eq07 " TABLE1 " --digits 0", 2, "--digits"},
    {"eval eq07 " TABLE1 " --digits 10001", 2, "--digits"},
    {"eval eq07 " TABLE1 " --json --json", 2, "twice"},
    {"eval eq07 " TABLE1 " --json=yes", 2, "no value"},
    {"eval eq07 Omega=nan m1=150", 2, "missing k_c"},
    {"eval flow_linear Omega=7e-5 L_ref=10 C1=6e-8 C2=1e-4 t=1e300" REST, 1, "no end in sight"},
    {"eval flow_linear Omega=7e-5 L_ref=10 C1=6e-8 C2=1e-4 t=1e15" REST, 1, "no end in sight"},
    {"eval rk4_linear Omega=7e-5 L_ref=10 C1=6e-8 C2=1e-4 h=1 t=1e18" REST, 1, "no end in sight"},
    {"eval eq44 Omega=7.2915e-5 n=8.999", 1, "n >= 9"},
    {"eval eq43 Omega=7.2915e-5 n=0", 1, "n > 0"},
    {"eval eq21 Q_ref=-1e-13 dQ=2e-13", 1, "Q_ref + dQ < 0"},
    {"eval eq12 x1=1 y1=2 z1=3 x2=1 y2=2 z2=3", 1, "eq12"},
    {"table1 --digits 3", 2, "--digits does nothing here, it belongs to: eval design figure trajectory conform"},
    {"figure", 2, "figure"},
    {"figure 5", 2, "5a, 5b, 6, 7a or 7b, got '5'"},
    {"figure 4 psi=0.1", 2, "psi"},
    {"figure 4 --rk4 100", 2, "--rk4 does nothing here, it goes with 5a or 5b or 6 or 7a or 7b"},
    {"figure 5a n=8", 1, "n"},
    {"figure 5a --rk4 30", 1, "--rk4"},
    {"figure 7a dL=-4 --rk4 100", 1, "Q_ref + dQ >= 0 at t = 0 s"}, /* a push: dL < -3 L_ref/n */
    {"design --digits 0", 2, "--digits"},
    {"design n=10 C1=6e-8", 2, "n: expected either n, or C1 and C2"},
    {"design l_ref=3", 2, "unknown name 'l_ref', did you mean 'L_ref'? there are: m1 m2 L_ref k_c Omega n C1 C2 lambda_d"},
    {"design n=nan C1=word", 2, "C1"},
    {"design n=nan", 1, "n: expected a finite number"},
    {"design m1=0", 1, "m1"},
    {"design lambda_d=0", 1, "lambda_d: expected a number > 0, or inf"},
    {"design lambda_d=80 --digits 4", 1, "lambda_d: expected more than 8.068e+01 m, with less nothing rests near L_ref"},
    {"design n=5", 1, "n: expected a number > 9, the pair is not stable"},
    {"design Omega=0 C1=1", 1, "Omega: expected a number > 0"},
    {"design n=9", 1, "n: expected a number > 9, the pair is not stable"},
    {"design C1=9 Omega=1", 1, "C1: expected more than 9 Omega^2, the pair is not stable"},
    {"design C1=10 C2=0 Omega=1", 1, "C2: expected a number > 0, the pair is not stable"},
    {"design n=1e12 --digits 2", 1, "n: expected at most a million"},
    {"design C1=12 C2=4", 1, "C1: expected 1/s^2, at most a million Omega^2"},
    {"design C1=6e-8 C2=1e20 --digits 2", 1, "design: T: 568 bits do not decide 2 digits"},
    {"trajectory", 2, "linear or nonlinear"},
    {"trajectory circular", 2, "circular"},
    {"trajectory linear --untl 5", 2, "did you mean '--until'"},
    {"trajectory linear --every", 2, "--every: expected a value after it"},
    {"trajectory nonlinear x1=0 y1=0 z1=0 x1_dot=0 y1_dot=0 z1_dot=0", 1, "x1 y1 z1: expected the two craft apart"},
    {"trajectory linear x1=5", 2, "x1"},
    {"trajectory nonlinear x1=5", 2, "all six"},
    {"trajectory linear m1=0", 1, "m1"},
    {"trajectory linear m1=inf", 1, "m1"},
    {"trajectory nonlinear dL=-10", 1, "apart"},
    {"trajectory linear --at 0,1 --every 5", 2, "--at"},
    {"trajectory linear --at ,1", 2, "--at"},
    {"trajectory linear --at 0,nan", 1, "--at"},
    {"trajectory linear --at 5,1", 2, "--at"},
    {"trajectory linear --at -1,1", 2, "--at"},
    {"trajectory linear --every 0", 1, "--every"},
    {"trajectory linear --every 1e400", 1, "--every: '1e400' is too large for binary64"},
    {"trajectory linear --every 1e308 --until 1e309", 1, "--until: '1e309' is too large for binary64"},
    {"trajectory linear --until inf", 1, "--until: expected a finite number"},
    {"trajectory linear --every -1", 1, "--every"},
    {"trajectory linear --every 1e-9", 1, "rows"},
    {"trajectory linear psi=inf n=10 C1=1", 2, "either n, or C1 and C2"},
    {"trajectory linear --at 150 --rk4 100", 1, "multiples"},
    {"trajectory linear --at -100 --rk4 100", 1, "multiples"},
    {"trajectory linear phi=0.1", 2, "psi"},
    {"eval eq07 Omega= k_c=8.99e9 m1=150 m2=150 L=10", 2, "Omega"},
    {"eval eq07 Omega=-inf k_c=8.99e9 m1=150 m2=150 L=10", 1, "Omega"},
    {"figure 5a --rk4 0", 1, "--rk4"},
    {"trajectory linear --until many", 2, "--until"},
    {"trajectory linear n=10 C2=1", 2, "n"},
    {"vectors eq07 --count 5 --seed 1 --shard a/4", 2, "--shard"},
    {"verify errors --count few", 2, "--count"},
    {"trajectory nonlinear psi=0.01+-0.001", 2, "psi: expected without +-, which is for the sets of trajectory nonlinear --set"},
    {"trajectory nonlinear psi=0.01+-abc --set", 2, "psi: expected a number, got 'abc'"},
    {"trajectory nonlinear psi=0.01+- --set", 2, "psi: expected a number, got ''"},
    {"trajectory nonlinear psi=abc+-1 --set", 2, "psi: expected a number, got 'abc'"},
    {"trajectory nonlinear psi=0.01+-nan --set", 1, "psi: expected a finite number"},
    {"trajectory nonlinear psi=0.01+--1 --set", 1, "psi: expected a number >= 0 after +-, got '-1'"},
    {"trajectory nonlinear psi=0.01+-1+-1 --set", 2, "psi: expected a number, got '1+-1'"},
    {"trajectory nonlinear Omega=7e-5+-1e-6 --set", 2, "Omega: expected without +-"},
    {"trajectory nonlinear n=10+-1 --set", 2, "n: expected without +-"},
    {"trajectory nonlinear dL=-9+-1 --set", 1, "dL: expected the two craft apart, L > 0, in all of the box"},
    {"trajectory nonlinear L_ref=10+-10 --set", 1, "L_ref: expected a number > 0, in all of the box"},
    {"trajectory nonlinear m1=150+-150 --set", 1, "m1: expected a number > 0, in all of the box"},
    {"trajectory nonlinear x1=1+-1 y1=0+-1 z1=1.5+-2 x1_dot=0 y1_dot=0 z1_dot=0 --set", 1, "x1 y1 z1: expected the two craft apart"},
    {"trajectory nonlinear x1=1.5+-2 y1=1.5+-2 z1=1+-1 x1_dot=0 y1_dot=0 z1_dot=0 --set", 1, "x1 y1 z1: expected the two craft apart"},
    {"trajectory linear psi=0.01+-0.001 --set", 2, "--set does nothing here, it goes with nonlinear"},
    {"trajectory nonlinear --set --rk4 100", 2, "--set: expected without --rk4"},
    {"trajectory nonlinear x1=5+-0.01 psi=0.1 --set", 2, "x1 ... z1_dot: expected all six, and no angles with them"},
    /* on the orbit normal two attracting craft fall straight into each other */
    {"eval flow_nonlinear Omega=1 k_c=1 m1=1 m2=1 L_ref=2 C1=0 C2=0 t=10 x1_0=0 y1_0=0 z1_0=1 x1_dot_0=0 y1_dot_0=0 z1_dot_0=0", 1,
     "the craft come closer than L_ref/128, nothing is proved beyond, last proved time 0.5"},
    {"eval rk4_linear Omega=1 L_ref=1 C1=1 C2=1 t=0.55 psi_0=0 theta_0=1 dL_0=0 psi_dot_0=0 theta_dot_0=0 dL_dot_0=0 h=0.5", 1, "rk4_linear: expected t/h an integer"},
    /* 2e323 steps; nine of them that are too long */
    {"eval rk4_linear Omega=1 L_ref=1 C1=1 C2=1 t=1 psi_0=0 theta_0=1 dL_0=0 psi_dot_0=0 theta_dot_0=0 dL_dot_0=0 h=5e-324", 1, "too many steps"},
    {"eval rk4_nonlinear Omega=1 k_c=1 m1=1 m2=1 L_ref=2 C1=0 C2=0 t=1 x1_0=0 y1_0=0 z1_0=1 x1_dot_0=0 y1_dot_0=0 z1_dot_0=0 h=5e-324", 1,
     "too many steps"},
    {"eval rk4_linear Omega=1 L_ref=1 C1=1 C2=1 t=0x1.2p103 psi_0=0 theta_0=1 dL_0=0 psi_dot_0=0 theta_dot_0=0 dL_dot_0=0 h=0x1p100", 1, "too many steps"},
    /* f_13 alone makes y1_ddot: 2 e^(-sqrt(5) 10^99)/5^(3/2), an exponent of a hundred digits */
    {"eval eq02 Omega=1 k_c=1 lambda_d=1e-99 m1=1 m2=1 m3=1 q1=1 q2=1 q3=1 x1=1 y1=0 z1=0 x2=-1 y2=0 z2=0 x3=0 y3=2 z3=0 x1_dot=0 "
     "y1_dot=0 z1_dot=0 x2_dot=0 y2_dot=0 z2_dot=0 x3_dot=0 y3_dot=0 z3_dot=0", 1, "eq02: 48896 bits do not decide every digit"},
    {"study", 2, "expected convergence, forced, pitch, damped, basin, saturation, tolerance, balance or sampling"},
    {"study force", 2, "did you mean 'forced'"},
    {"eval flow_linear Omega=1 L_ref=1 C1=-1e300 C2=1e300 t=1 psi_0=1 theta_0=1 dL_0=1 psi_dot_0=0 theta_dot_0=0 dL_dot_0=0", 1,
     "the enclosure grew past use"}, /* e^(1e150) */
    {"vectors", 2, "operation"},
    {"vectors eq7 --count 1 --seed 1", 2, "eq07"},
    {"vectors eq07", 2, "--count"},
    {"vectors eq07 --count 5", 2, "--seed"},
    {"vectors eq07 --count 5 --seed 18446744073709551616", 2, "--seed: expected a whole number below 2^64"},
    {"vectors eq07 --count 5 --seed 1 --shard 1", 2, "K/N"},
    {"vectors eq07 --count 5 --seed 1 --shard 1/", 2, "--shard"},
    {"vectors eq07 --count 5 --seed 1 --shard 0/4", 2, "K/N"},
    {"vectors eq07 --count 5 --seed 1 --shard 5/4", 2, "K/N"},
    {"vectors eq07 --golden --seed 1", 2, "--golden"},
    {"vectors eq07 --golden --shard 1/2", 2, "--shard does nothing here, it goes with --count"},
    {"verify proofs", 2, "proofs"},
    {"verify derivation", 2, "did you mean 'derivations'"},
    {"verify claims n12-optmal", 2, "did you mean 'n12-optimal'"},
    {"verify claims equation-99", 2, "unknown claim 'equation-99'"},
    {"verify claims table1-m3", 2, "unknown claim 'table1-m3'"},
    {"verify errors n12-optimal", 2, "unexpected argument 'n12-optimal'"},
    {"verify claims --count 5", 2, "--count does nothing here, it goes with errors or no word"},
    {"conform --timeout 5 --kills", 2, "--timeout does nothing here, it goes with a client after --"},
    {"verify errors --count 100000001", 2, "--count"},
    {"verify errors --count 99999999999999999999", 2, "--count"},
    {"verify errors --count 0", 2, "--count"},
};

CASE(command_line, NULL, NULL)

EACH(a_mistake_gets_one_line_and_its_exit_code, COUNT(mistakes))
{
    ck_assert_msg(run(mistakes[_i].line) == mistakes[_i].status, "%s: %s", mistakes[_i].line, errors);
    ck_assert_msg(lines(errors) == 1, "%s: %s", mistakes[_i].line, errors);
    ck_assert_msg(strstr(errors, mistakes[_i].says) != NULL, "%s: %s", mistakes[_i].line, errors);
    ck_assert_msg(output[0] == '\0', "%s: %s", mistakes[_i].line, output);
}

/* Lines that work, and all that they print. */
static const struct {
    const char *line, *prints;
} uses[] = {
    {"--version", "coulomb-tether " CT_VERSION "\n"},
    {"-V", "coulomb-tether " CT_VERSION "\n"},
    /* -3 (1/2)^2 2^3/1 (1*3/(1 + 3)) = -9/2 */
    {"eval eq07 Omega=0.5 k_c=1 m1=1 m2=3 L=2 --digits 5", "Q_ref = -4.5000e+00 C^2\n"},
    /* the decimal is not its binary64: 3 (1/10)^2 = 3/100 */
    {"eval eq07 Omega=0.1 k_c=1 m1=2 m2=2 L=1 --digits 20 --exact", "Q_ref = -3.0000000000000000000e-02 C^2\n"},
    /* 0.1 in binary64 is 0.1000000000000000055511151231257827...; its square times 3 */
    {"eval eq07 Omega=0.1 k_c=1 m1=2 m2=2 L=1 --digits 20", "Q_ref = -3.0000000000000003331e-02 C^2\n"},
    /* L = 10.1 m as the simulation starts: -3 (7.2915e-5)^2 10.1^3/8.99e9 (150*50/200) */
    {"eval eq07 m2=50 --table1 --digits 5", "Q_ref = -6.8547e-14 C^2\n"},
    /* python3: 5.05*cos(.01)**2, 5.05*cos(.01)*sin(.01), -5.05*sin(.01) */
    {"eval flow_nonlinear --table1 t=0 x1_dot_0=2 --digits 12",
     "x1 = 5.04949501683e+00 m\ny1 = 5.04966334007e-02 m\nz1 = -5.04991583375e-02 m\nx1_dot = 2.00000000000e+00 m/s\n"
     "y1_dot = 0 m/s\nz1_dot = 0 m/s\n"},
    {"eval eq43 n=0.5 --table1 --exact --digits 12", "C1 = 2.65829861250e-09 1/s^2\n"}, /* (7.2915e-5)^2/2 */
    {"eval eq07 Omega=1e400 k_c=1e400 m1=1 m2=1 L=1e-300 --exact --digits 3", "Q_ref = -1.50e-500 C^2\n"},
    /* a tie, to the even digit: 2.5 and 3.5 */
    {"eval eq43 Omega=0.5 n=10 --digits 1", "C1 = 2e+00 1/s^2\n"},
    {"eval eq43 Omega=0.5 n=14 --digits 1", "C1 = 4e+00 1/s^2\n"},
    /* zero, though sin(1) is no rational number: -sin 1 (psi_dot + Omega) */
    {"eval eq27 Omega=1 theta=1 psi_dot=-1 theta_dot=0.5 --digits 3",
     "w_1 = 0 rad/s\nw_2 = 5.00e-01 rad/s\nw_3 = 0 rad/s\n"},
    {"eval eq42 Omega=1 C1=9 C2=1 --digits 2", "margin1 = 0 1/s^2\nmargin2 = 1.0e+00 1/s\nstable = 0 -\n"},
    {"eval eq42 Omega=1 C1=9.5 C2=1 --digits 2",
     "margin1 = 5.0e-01 1/s^2\nmargin2 = 1.0e+00 1/s\nstable = 1.0e+00 -\n"},
    {"eval eq38 GM=8 R_c=2 --digits 4", "Omega = 1.000e+00 rad/s\n"},
    {"eval eq38 GM=3 R_c=1 --as-printed --digits 4", "Omega = 3.000e+00 rad/s\n"},
    {"eval eq21 Q_ref=4 dQ=5 --as-printed --digits 2", "q1 = 3.0e+00 C\nq2 = -3.0e+00 C\n"},
    {"eval eq38 GM=8 R_c=2 --digits 4 --json",
     "{\"id\": \"eq38\", \"as_printed\": false, \"digits\": 4, \"outputs\": "
     "[{\"name\": \"Omega\", \"value\": \"1.000e+00\", \"unit\": \"rad/s\"}]}\n"},
    /* the double root 0 of s^4 + 7 s^2, n = 9, and +-i sqrt(7): 2.645751311... */
    {"eval eq41roots Omega=1 C1=9 C2=0 --digits 4",
     "re1 = 0 1/s\nim1 = -2.646e+00 1/s\nre2 = 0 1/s\nim2 = 0 1/s\n"
     "re3 = 0 1/s\nim3 = 0 1/s\nre4 = 0 1/s\nim4 = 2.646e+00 1/s\n"},
    /* (s + 3/2)(s^3 + ...): a tie of its digit, to the even one. Over Omega: (s + 1)(s^3 + 3 s^2 + 6 s + 6), the roots
       -1, -1.5961 and -0.70196 +- 1.8073i; times 3/2 -1.5, -2.3941 and -1.0529 +- 2.7110i */
    {"eval eq41roots Omega=1.5 C1=24.75 C2=6 --digits 1",
     "re1 = -2e+00 1/s\nim1 = 0 1/s\nre2 = -2e+00 1/s\nim2 = 0 1/s\n"
     "re3 = -1e+00 1/s\nim3 = -3e+00 1/s\nre4 = -1e+00 1/s\nim4 = 3e+00 1/s\n"},
    /* pitch alone: theta = cos(2 tau), at tau = 1: -0.41614683654714238700 */
    {"eval flow_linear Omega=1 L_ref=10 C1=10 C2=2 t=1 psi_0=0 theta_0=1 dL_0=0 psi_dot_0=0 theta_dot_0=0 dL_dot_0=0 --digits 10",
     "psi = 0 rad\ntheta = -4.161468365e-01 rad\ndL = 0 m\npsi_dot = 0 rad/s\n"
     "theta_dot = -1.818594854e+00 rad/s\ndL_dot = 0 m/s\n"},
    /* at rest at the equilibrium, 1/3 of 3 m from the centre of mass: for ever */
    {"eval flow_nonlinear Omega=1 k_c=1 m1=2 m2=1 L_ref=3 C1=10 C2=2 t=7 x1_0=1 y1_0=0 z1_0=0 x1_dot_0=0 y1_dot_0=0 z1_dot_0=0 --digits 3",
     "x1 = 1.00e+00 m\ny1 = 0 m\nz1 = 0 m\nx1_dot = 0 m/s\ny1_dot = 0 m/s\nz1_dot = 0 m/s\n"},
    /* one step h = 1/2 of theta'' = -4 theta from 1: 1 - 2 h^2 + (2/3) h^4 = 0.541666... */
    {"eval rk4_linear Omega=1 L_ref=10 C1=10 C2=2 t=0.5 psi_0=0 theta_0=1 dL_0=0 psi_dot_0=0 theta_dot_0=0 dL_dot_0=0 h=0.5 --digits 10",
     "psi = 0 rad\ntheta = 5.416666667e-01 rad\ndL = 0 m\npsi_dot = 0 rad/s\n"
     "theta_dot = -1.666666667e+00 rad/s\ndL_dot = 0 m/s\n"},
    /* one step of h = 10^22: (2/3) h^4 and (8/3) h^3 are all that 10 digits show */
    {"eval rk4_linear Omega=1 L_ref=10 C1=10 C2=2 t=1e22 psi_0=0 theta_0=1 dL_0=0 psi_dot_0=0 theta_dot_0=0 dL_dot_0=0 h=1e22 --digits 10",
     "psi = 0 rad\ntheta = 6.666666667e+87 rad\ndL = 0 m\npsi_dot = 0 rad/s\n"
     "theta_dot = 2.666666667e+66 rad/s\ndL_dot = 0 m/s\n"},
    {"trajectory linear --at 0 --digits 3",
     "t,psi,theta,dL,psi_dot,theta_dot,dL_dot\n0,1.00e-02,1.00e-02,1.00e-01,0,0,0\n"},
    {"trajectory linear --every 50 --until 100 --digits 3 psi=0 theta=0 dL=0",
     "t,psi,theta,dL,psi_dot,theta_dot,dL_dot\n0,0,0,0,0,0,0\n50,0,0,0,0,0,0\n100,0,0,0,0,0,0\n"},
    /* at rest where (5) says, Q = -1.3306e-13 C^2: q = sqrt(1.3306e-13) C = 3.65e-7 C */
    {"trajectory nonlinear --at 0,100 --digits 3 x1=5 y1=0 z1=0 x1_dot=0 y1_dot=0 z1_dot=0",
     "t,x1,y1,z1,x1_dot,y1_dot,z1_dot,q1,q2\n0,5.00e+00,0,0,0,0,0,3.65e-07,-3.65e-07\n"
     "100,5.00e+00,0,0,0,0,0,3.65e-07,-3.65e-07\n"},
    /* short of where Q_ref + dQ = 0: q^2 = m1 m2/(m1 + m2) L_ref^2/k_c C1 1e-31 = 75*100/8.99e9*10*1e-31 C^2 */
    {"trajectory nonlinear C1=10 C2=0 Omega=1 L_ref=10 psi=0 theta=0 dL=-2.9999999999999999999999999999999 --exact --at 0 --digits 6",
     "t,x1,y1,z1,x1_dot,y1_dot,z1_dot,q1,q2\n0,3.50000e+00,0,0,0,0,0,9.13379e-19,-9.13379e-19\n"},
    /* rows at multiples of the decimal, the last one too; 0.3 is no sum of three binary64s 0.1 */
    {"trajectory linear --every 0.1 --until 0.3 --digits 3 psi=0 theta=0 dL=0",
     "t,psi,theta,dL,psi_dot,theta_dot,dL_dot\n0,0,0,0,0,0,0\n0.1,0,0,0,0,0,0\n0.2,0,0,0,0,0,0\n0.3,0,0,0,0,0,0\n"},
    {"trajectory linear --every 1.00000000000000000001 --until 1.5 --exact --digits 3 psi=0 theta=0 dL=0",
     "t,psi,theta,dL,psi_dot,theta_dot,dL_dot\n0,0,0,0,0,0,0\n1.00000000000000000001e+00,0,0,0,0,0,0\n"},
    /* at the start 5 and 5.05 cm and what is given beside, outward to three digits */
    {"trajectory nonlinear x1=5+-0.015 y1=0 z1=-0.0505+-0.01 --set --at 0 --digits 3",
     "t,x1_low,x1_high,y1_low,y1_high,z1_low,z1_high,x1_dot_low,x1_dot_high,y1_dot_low,y1_dot_high,z1_dot_low,z1_dot_high,"
     "q1_low,q1_high,q2_low,q2_high\n"
     "0,4.98e+00,5.02e+00,0,0,-6.06e-02,-4.04e-02,0,0,0,0,0,0,3.62e-07,3.67e-07,-3.67e-07,-3.62e-07\n"},
    {"trajectory linear --every 50 --until -50 --digits 3 psi=0 theta=0 dL=0",
     "t,psi,theta,dL,psi_dot,theta_dot,dL_dot\n0,0,0,0,0,0,0\n-50,0,0,0,0,0,0\n"},
};

EACH(a_use_prints_exactly_this, COUNT(uses))
{
    ck_assert_msg(run(uses[_i].line) == 0, "%s: %s", uses[_i].line, errors);
    ck_assert_str_eq(output, uses[_i].prints);
    ck_assert_str_eq(errors, "");
}

/* Answers in the order of the questions, the last without an end of its line; up to the first line that is none. */
EACH(question_lines_are_answered_up_to_the_first_that_is_none, 16)
{
    static const struct {
        const char *line, *asks, *answers;
        int status;
        const char *says;
    } cases[] = {
        /* 4 (1/2)^2 = 1, 2 (1/2) sqrt(25 - 9) = 4, k_c cancels against nothing: -3 (1/4) 2^3/1 (3/4) = -9/2 */
        {"eval - --digits 3", "eq43 a 0.5 4\neq44 b.1 0.5 25\r\neq07 c-2 0.5\t1 1 3 2", "a 1.00e+00\nb.1 4.00e+00\nc-2 -4.50e+00\n", 0, ""},
        {"eval - --digits 3", "\357\273\277eq38 x 3 1\n", "x 1.73e+00\n", 0, ""}, /* sqrt 3, after an editor's byte order mark */
        {"eval - --digits 3 --as-printed", "eq38 x 3 1\n", "x 3.00e+00\n", 0, ""}, /* sqrt(3 3) */
        {"eval - --digits 20", "eq43 x 1 0.1\n", "x 1.0000000000000000555e-01\n", 0, ""},
        {"eval - --digits 20 --exact", "eq43 x 1 0.1\n", "x 1.0000000000000000000e-01\n", 0, ""},
        {"eval -", "eq43 a 0 1\neq43 b nan 1\neq43 c 1 inf\neq43 d 1 -inf\neq43 e 1e400 1\neq44 f 1 8.999\n",
         "a invalid\nb invalid\nc invalid\nd invalid\ne invalid\nf invalid\n", 0, ""},
        /* two charges of 1 C at rest, 1 m apart: shielding is none where lambda_d is infinite */
        {"eval - --digits 2", "eq02 a 1 1 inf 1 0 1 0 0 0 0 0 1 0 2 0 0 0 0 0 1 0 3 0 0 0 0 0\n",
         "a 3.0e+00 0 0 6.0e+00 0 0 9.0e+00 0 0\n", 0, ""},
        /* the fall along the orbit normal, of which nothing is proved after 0.58 s */
        {"eval - --digits 2", "flow_nonlinear a 1 1 1 1 2 0 0 10 0 0 1 0 0 0\neq43 b 1 1\n",
         "a skip the craft come closer than L_ref/128, nothing is proved beyond, last proved time 0.579762 s\nb 1.0e+00\n", 1,
         "standard input: 1 skipped as unproved, the first is line 1"},
        {"eval - --digits 2", "eq43 a 1 1\n\neq43 b 1 1\n", "a 1.0e+00\n", 2, "standard input: line 2: expected ID VECTOR-ID INPUT..., got nothing"},
        {"eval - --digits 2", "eq43\n", "", 2, "line 1: expected ID VECTOR-ID INPUT..., got eq43"},
        {"eval -", "eq4 a 1 1\n", "", 2, "line 1: 'eq4' is no operation"},
        {"eval -", "eq08 a\n", "", 2, "line 1: 'eq08' is no operation"}, /* a definition */
        {"eval -", "eq43 a/b 1 1\n", "", 2, "line 1: 'a/b' is no vector's id"},
        {"eval -", "eq43 a 1\n", "", 2, "line 1: missing n of eq43"},
        {"eval -", "eq43 a 1 1 1\n", "", 2, "line 1: '1' follows the last input of eq43"},
        {"eval -", "eq43 a 1 1,5\n", "", 2, "line 1: n: expected a number, got '1,5'"},
    };
    input = cases[_i].asks;
    const int status = run(cases[_i].line);
    input = NULL;
    ck_assert_str_eq(output, cases[_i].answers);
    ck_assert_msg(strstr(errors, cases[_i].says) != NULL, "%s", errors);
    ck_assert_int_eq(status, cases[_i].status);
    ck_assert_int_eq(lines(errors), status != 0);
}

EACH(questions_that_cannot_be_read_are_none, 6)
{
    static const struct {
        const char *command;
        int status;
        const char *says;
    } cases[] = {
        {"$CT_PROGRAM eval - <.", 1, ""},
        {"head -c 65535 /dev/zero | tr '\\0' a | $CT_PROGRAM eval -", 2, "line 1: expected ID VECTOR-ID INPUT..., got aaa"},
        {"head -c 65536 /dev/zero | tr '\\0' a | $CT_PROGRAM eval -", 2, "line 1: longer than 65535 bytes, or with a zero byte"},
        {"printf 'eq43 a 1 1\\0 2' | $CT_PROGRAM eval -", 2, "line 1: longer than 65535 bytes, or with a zero byte"},
        {"printf 'eq43 a 1 1\\0 2\\n' | $CT_PROGRAM eval -", 2, "line 1: longer than 65535 bytes, or with a zero byte"},
        {"printf 'eq43 a 1 1\\0' | $CT_PROGRAM eval -", 2, "line 1: longer than 65535 bytes, or with a zero byte"},
    };
    char command[1024];
    snprintf(command, sizeof command, "exec 2>\"$CT_BUILD/tests/said\"; %s", cases[_i].command);
    ck_assert_int_eq(WEXITSTATUS(system(command)), cases[_i].status);
    snprintf(command, sizeof command, "grep -q '^coulomb-tether: standard input: %s' \"$CT_BUILD/tests/said\"", cases[_i].says);
    ck_assert_int_eq(system(command), 0);
}

/* The questions of golden vectors have their answers in the columns beside them. */
EACH(question_lines_of_golden_vectors_are_answered_as_they_are_there, 6)
{
    static const char *const ids[] = {"eq03", "eq10inv", "eq21", "eq37", "eq41roots", "rk4_linear"};
    static char command[1024];
    const struct section *s = section_find(sheet(), ids[_i]);
    const int first = 2 + s->input_count, last = first + s->output_count - 1;
    snprintf(command, sizeof command,
             "sed 1d data/golden/%s.csv | awk -F, '{ printf \"%%s\", \"%s\"; for (i = 1; i < %d; i++) printf \" %%s\", $i; print \"\" }' | "
             "\"$CT_PROGRAM\" eval - >\"$CT_BUILD/tests/answered\" && "
             "sed 1d data/golden/%s.csv | awk -F, '{ printf \"%%s\", $1; if ($%d == \"\") printf \" invalid\"; "
             "else for (i = %d; i <= %d; i++) printf \" %%s\", $i; print \"\" }' | cmp - \"$CT_BUILD/tests/answered\"",
             s->id, s->id, first, s->id, first, first, last);
    ck_assert_int_eq(system(command), 0);
}

EACH(help_names_every_subcommand, 3)
{
    static const char *const asks[] = {"--help", "-h", "help"};
    ck_assert_int_eq(run(asks[_i]), 0);
    ck_assert_str_eq(errors, "");
    for (const struct subcommand *s = subcommands; s->name != NULL; s++) {
        char line[64];
        snprintf(line, sizeof line, "coulomb-tether %s", s->name);
        ck_assert_msg(strstr(output, line) != NULL, "%s", s->name);
    }
}

EACH(help_explains_every_option_of_a_subcommand_with_unit_and_default, 3)
{
    static const char *const asks[] = {"help %s", "%s --help", "%s -h"};
    for (const struct subcommand *s = subcommands; s->name != NULL; s++) {
        char line[64];
        snprintf(line, sizeof line, asks[_i], s->name); /* NOLINT: one of the three above */
        ck_assert_msg(run(line) == 0, "%s", line);
        ck_assert_str_eq(errors, "");
        int explained = 0;
        for (const struct option *o = options; o->name != NULL; o++) {
            if (!option_belongs(o, s))
                continue;
            snprintf(line, sizeof line, "\n  %s %s", o->name, o->argument ? o->argument : "");
            ck_assert_msg(strstr(output, line) != NULL, "%s: %s", s->name, o->name);
            snprintf(line, sizeof line, "unless given: %s]", o->otherwise ? o->otherwise : "");
            ck_assert_msg(o->otherwise == NULL || strstr(output, line) != NULL, "%s: %s", s->name, o->name);
            explained++;
        }
        for (const char *at = output; (at = strstr(at, "\n  -")) != NULL; at++)
            explained--;
        ck_assert_int_eq(explained, 0);
        ck_assert_int_eq(strstr(output, "\n  m1 ") != NULL, word_in("trajectory figure design", " ", s->name));
        *strstr(output, "\nExamples:") = '\0'; /* which stand as they are */
        for (const char *at = output; *at != '\0'; at += strcspn(at, "\n") + (at[strcspn(at, "\n")] != '\0')) {
            ck_assert_msg(strcspn(at, "\n") <= 100, "%.120s", at);
            ck_assert_msg(*at == '\n' || at[strcspn(at, "\n") - 1] != ' ', "%.120s", at);
        }
    }
    ck_assert_int_eq(run("help trajectory"), 0);
    ck_assert_ptr_nonnull(strstr(output, "\n  --every S             a row at 0 and every S from there [s, unless given: 100]\n"));
    ck_assert_ptr_nonnull(strstr(output, "\n  m1                    mass of craft 1 [kg, unless given: 150]\n"));
}

/* The words of an example up to where the shell takes over. */
TEST(the_examples_are_lines_that_are_understood_and_have_every_option_in_them)
{
    static const char until[] = "|<>";
    bool used[100] = {false};
    for (const struct example *e = examples; e->line != NULL; e++) {
        char line[256], *words[MOST_WORDS], *rest = NULL;
        int count = 0;
        snprintf(line, sizeof line, "%s", e->line);
        for (char *word = strtok_r(line, " ", &rest); word != NULL && strchr(until, *word) == NULL; word = strtok_r(NULL, " ", &rest))
            words[count++] = word;
        ck_assert_int_gt(count, 0);
        struct arguments a = {.subcommand = subcommand_find(words[0])};
        ck_assert_msg(a.subcommand != NULL, "%s", e->line);
        ck_assert_msg(arguments_read(&a, count - 1, words + 1) == EXIT_DONE, "%s", e->line);
        for (int i = 0; i < a.given_count; i++)
            used[a.given[i].option - options] = true;
        arguments_clear(&a);
    }
    for (const struct option *o = options; o->name != NULL; o++)
        ck_assert_msg(used[o - options], "no example of %s of %s", o->name, o->of);
    for (const struct subcommand *s = subcommands; s->name != NULL; s++) {
        bool shown = false;
        for (const struct example *e = examples; e->line != NULL; e++)
            shown = shown || word_in(e->line, " ", s->name);
        ck_assert_msg(shown, "no example of %s", s->name);
    }
}

TEST(the_manual_page_has_every_option_and_example_and_no_macro_by_mistake)
{
    static const char *const sections[] = {"NAME", "SYNOPSIS", "DESCRIPTION", "EXIT STATUS", "EXAMPLES", "SEE ALSO", "STANDARDS"};
    const char *at = output;
    char line[1000] = "{ \"$CT_PROGRAM\" help; for s in", end[] = "; do echo \"@ $s\"; \"$CT_PROGRAM\" help $s; done; } | awk -f verify/command/manual.awk";
    for (const struct subcommand *c = subcommands; c->name != NULL; c++)
        add_text(line, sizeof line, " ", c->name);
    add_text(line, sizeof line, "", end);
    FILE *page = popen(line, "r");
    ck_assert_ptr_nonnull(page);
    output[fread(output, 1, MOST_TEXT - 1, page)] = '\0';
    ck_assert_int_eq(pclose(page), 0);
    for (size_t i = 0; i < sizeof sections / sizeof *sections; i++) {
        char heading[32];
        snprintf(heading, sizeof heading, "\n.Sh %s\n", sections[i]);
        at = strstr(at, heading);
        ck_assert_msg(at != NULL, "%s", heading);
    }
    for (const struct option *o = options; o->name != NULL; o++) {
        char item[64];
        int length = snprintf(item, sizeof item, "\n.It Li \\%%");
        for (const char *c = o->name; *c != '\0'; c++)
            length += snprintf(item + length, sizeof item - (size_t)length, *c == '-' ? "\\%c" : "%c", *c);
        snprintf(item + length, sizeof item - (size_t)length, "%s%s\n", o->argument ? " " : "", o->argument ? o->argument : "");
        ck_assert_msg(strstr(output, item) != NULL, "%s", item);
    }
    for (at = output; *at != '\0'; at = strchr(at, '\n') + 1)
        ck_assert_msg(*at != '.' || isupper((unsigned char)at[1]), "%.40s", at);
}

/* What bash offers for the last of some words; where there is no bash, nothing. */
EACH(bash_completes_what_help_has, 18)
{
    static const struct {
        const char *words, *offers;
    } lines_of[] = {
        {"tr", "trajectory"},
        {"trajectory lin", "linear"},
        {"trajectory linear --e", "--exact --every"},
        {"trajectory linear --exact Om", "Omega="},
        {"eval eq1", "eq10 eq10lin eq10inv eq11exact eq11 eq12 eq13 eq14 eq15 eq17 eq18 eq19"},
        {"eval eq07 m", "m1= m2="},
        {"eval eq07 --t", "--table1"},
        {"equations eq01", "eq01"},
        {"vectors eq01", ""}, /* a definition */
        {"vectors eq07 --inputs h", "hex"},
        {"conform --only rk", "rk4_linear rk4_nonlinear"},
        {"conform --significand 1", "113"},
        {"help st", "study"},
        {"verify cl", "claims"},
        {"figure 7", "7a 7b"},
        {"design n=10 lam", "lambda_d="},
        {"--v", "--version"},
        {"nonsense --x", ""},
    };
    char command[1024], line[256] = "";
    if (system("bash -c 'type compgen' >/dev/null 2>&1") != 0)
        return;
    snprintf(command, sizeof command,
             "bash -c 'source verify/command/completion.bash && compopt() { :; } && COMP_WORDS=(\"$CT_PROGRAM\" %s) && "
             "COMP_CWORD=$((${#COMP_WORDS[@]} - 1)) && _coulomb_tether && echo \"${COMPREPLY[*]}\"'", lines_of[_i].words);
    FILE *shell = popen(command, "r");
    ck_assert_ptr_nonnull(shell);
    ck_assert_ptr_nonnull(fgets(line, sizeof line, shell));
    ck_assert_int_eq(pclose(shell), 0);
    line[strcspn(line, "\n")] = '\0';
    ck_assert_str_eq(line, lines_of[_i].offers);
}

CASE(long_work, NULL, NULL) /* under valgrind it takes too long */

/*
 * (41) is (s^2 + 2 s + 3)^2: -1 +- i sqrt(2), twice; Q_ref = -3 1^2 2^3/1 (1*3/(1 + 3)) = -18; T and d as those that
 * tests/claims/test_sampling.c confirms; (1 + 1/5) e^(-1/5) = 0.98248; (sqrt(12*12 - 27) - 3)/6 L_ref = 2.60555 m.
 */
#define DESIGN_12_4 \
    "# gains of the law (18)\nC1 = 1.200e+01 1/s^2  # of the length error\nC2 = 4.000e+00 1/s  # of its rate\n" \
    "c1 = 1.200e+01 -  # C1 over Omega^2, which is n by (43)\nc2 = 4.000e+00 -  # C2 over Omega\n" \
    "# rest at L_ref\nQ_ref = -1.800e+01 C^2  # charge product\nq1 = 4.243e+00 C  # charge of craft 1\n" \
    "q2 = -4.243e+00 C  # charge of craft 2\nx1 = 1.500e+00 m  # place of craft 1 on the radius\n" \
    "x2 = -5.000e-01 m  # place of craft 2 there\n" \
    "# roots of (41), yaw and length error, the fastest decay first\nre1 = -1.000e+00 1/s  # fastest decay\nim1 = -1.414e+00 rad/s  # its frequency\n" \
    "re2 = -1.000e+00 1/s\nim2 = -1.414e+00 rad/s\nre3 = -1.000e+00 1/s\nim3 = 1.414e+00 rad/s\n" \
    "re4 = -1.000e+00 1/s  # slowest decay\nim4 = 1.414e+00 rad/s  # its frequency\n" \
    "t_fast = 1.000e+00 s  # time in which the fastest falls to 1/e\n" \
    "t_slow = 1.000e+00 s  # time in which the slowest falls to 1/e\n" \
    "# frequencies, each motion by itself\nw_theta = 2.000e+00 rad/s  # pitch, which no gain damps\n" \
    "w_psi = 1.732e+00 rad/s  # yaw\nw_dL = 1.732e+00 rad/s  # length error\n" \
    "# sampling, by the linear model\nT = 5.582e-01 s  # the law may be held for any time below this one\n" \
    "d = 2.322e-01 s  # the law may act late by any time below this one\n" \
    "# screening at lambda_d\nlost = 1.752e-02 -  # part of the force that is missing\n" \
    "# basin of rest at L_ref, by the energy of the nonlinear model without screening\n" \
    "equilibrium = 2.606e+00 m  # other equilibrium on the radius\n"

TEST(design_prints_what_one_decides_with)
{
    ck_assert_int_eq(run("design Omega=1 C1=12 C2=4 k_c=1 m1=1 m2=3 L_ref=2 lambda_d=10 --digits 4"), 0);
    ck_assert_int_lt((int)strlen(DESIGN_12_4), (int)strlen(output));
    output[strlen(DESIGN_12_4)] = '\0';
    ck_assert_str_eq(output, DESIGN_12_4);
    ck_assert_int_eq(run("design lambda_d=inf --digits 4"), 0);
    ck_assert_ptr_nonnull(strstr(output, "\nlost = 0 -  # "));
    /* polyroots([1, 2, 8, 6, 3]): -0.4159254 +- 0.5324503i the slower, times 7.2915e-5 */
    ck_assert_ptr_nonnull(strstr(output, "\nre4 = -3.033e-05 1/s  # slowest decay\nim4 = 3.882e-05 rad/s"));
    ck_assert_ptr_nonnull(strstr(output, "\nt_slow = 3.297e+04 s  # "));
    /* 3 Omega^2 L_ref, units by name: 3*7.2915e-5**2*10 */
    ck_assert_ptr_nonnull(strstr(output, "\nalong = 1.595e-07 m/s^2  # "));
    ck_assert_ptr_nonnull(strstr(output, " rad/s  # largest rate of yaw, or of pitch"));
    ck_assert_ptr_nonnull(strstr(output, "\ndebye = 8.068e+01 m  # "));
    /* 1 - 81 (40 - 3)^2/(4 40^3) = 0.56683984375, a tie of ten digits */
    ck_assert_int_eq(run("design n=40 --digits 10"), 0);
    ck_assert_ptr_nonnull(strstr(output, "\ndeficit = 5.6683984375e-01 -  # "));
}

EACH(design_speaks_json_of_all_that_it_prints, 3)
{
    static const char *const asks[] = {"design n=1e5 --digits 1", "design n=12 m2=50", "design C1=6e-8 --exact --digits 50"};
    char line[64];
    ck_assert_int_eq(run(asks[_i]), 0);
    int numbers = 0;
    for (const char *at = output; (at = strstr(at, " = ")) != NULL; at++)
        numbers++;
    snprintf(line, sizeof line, "%s --json", asks[_i]);
    ck_assert_int_eq(run(line), 0);
    for (const char *at = output; (at = strstr(at, "\"value\": ")) != NULL; at++)
        numbers--;
    ck_assert_int_eq(numbers, 0);
    ck_assert_int_eq(strncmp(output, "{\"digits\": ", 11), 0);
    ck_assert_str_eq(output + strlen(output) - 4, "}]}\n");
}

CASE(command_line, NULL, NULL)

/* However much it is; a file is named as it was given. */
EACH(a_full_disk_is_said_and_exits_1, 14)
{
    static const char *const asks[] = {"table1", "figure 4", "equations", "trajectory linear",
                                       "eval eq38 GM=8 R_c=2", "--help", "vectors eq43 --golden",
                                       "verify derivations kepler", "eval -", "conform --questions", "vectors eq02 --golden -o /dev/full",
                                       "equations --json -o /dev/full", "table1 -o /dev/full", "conform --questions -o /dev/full"};
    int full = open("/dev/full", O_WRONLY);
    ck_assert_int_ge(full, 0);
    input = "eq43 a 1 1\neq43 b 1 1\n";
    ck_assert_int_eq(run_to(asks[_i], full), 1);
    input = NULL;
    close(full);
    ck_assert_int_eq(lines(errors), 1);
    ck_assert_str_eq(errors, strstr(asks[_i], " -o ") ? "coulomb-tether: /dev/full: No space left on device\n"
                                                      : "coulomb-tether: standard output: No space left on device\n");
}

/* What is printed elsewhere, byte for byte, and nothing of it here; a device is written as it is. */
static const struct {
    const char *line, *file, *says;
} into[] = {
    {"equations eq44", "out", NULL}, {"figure 4", "out", NULL}, {"conform --questions --only eq44", "out", NULL}, {"table1 --csv", "out", NULL},
    {"figure 4", "/nowhere/out", "coulomb-tether: /nowhere/out: No such file or directory\n"},
    {"eval eq44 Omega=1 n=8", "out", "coulomb-tether: eq44: expected n >= 9\n"},
};

EACH(o_names_a_file_that_is_there_whole_or_not_at_all, COUNT(into))
{
    static char due[MOST_TEXT];
    char line[600], file[500];
    snprintf(file, sizeof file, *into[_i].file == '/' ? "%.0s%s" : "%s/tests/%s", getenv("CT_BUILD"), into[_i].file);
    remove(file);
    const int status = run(into[_i].line);
    snprintf(due, sizeof due, "%s", output);
    snprintf(line, sizeof line, "%s -o %s", into[_i].line, file);
    ck_assert_int_eq(run(line), into[_i].says == NULL ? 0 : 1);
    ck_assert_str_eq(output, "");
    ck_assert_str_eq(errors, into[_i].says ? into[_i].says : "");
    FILE *there = fopen(file, "r");
    ck_assert((there == NULL) == (into[_i].says != NULL));
    if (there == NULL)
        return;
    ck_assert_int_eq(status, 0);
    read_back(there, output);
    ck_assert_str_eq(output, due);
    ck_assert_int_eq(run("table1 -o /dev/null"), 0);
}

/* Through one link, two of different folders; in place of one that leads nowhere; and onto standard output, after what stands there. */
TEST(o_writes_where_a_name_leads)
{
    ck_assert_int_eq(system("cd \"$CT_BUILD/tests\" && rm -rf links && mkdir -p links/far && cd links && echo old >far/old && "
                            "ln -s old far/second && ln -s far/second first && ln -s \"$PWD/new\" gone && ln -s loop loop && "
                            "\"$CT_PROGRAM\" table1 >due && for f in first gone; do \"$CT_PROGRAM\" table1 -o $f || exit 1; done && "
                            "test -L first && test -L far/second && ! test -L gone && cmp due far/old && cmp due gone && "
                            "! \"$CT_PROGRAM\" table1 -o loop 2>said && test -L loop && ! ls . far | grep tmp"), 0);
    ck_assert_int_eq(system("cd \"$CT_BUILD/tests/links\" && grep -q '^coulomb-tether: loop: Too many levels of symbolic links$' said && "
                            "echo head >all && \"$CT_PROGRAM\" table1 -o /dev/fd/1 >>all && (echo head; cat due) | cmp - all && "
                            "\"$CT_PROGRAM\" table1 -o /dev/fd/1 | cmp - due"), 0);
    /* what lies beside it, a link or somebody's file of the like name, stays what it is; what nobody else may read stays so */
    ck_assert_int_eq(system("cd \"$CT_BUILD/tests/links\" && echo mine >a && echo mine >t.tmp && ln -s a t.1.tmp && : >t && chmod 600 t && "
                            "\"$CT_PROGRAM\" table1 -o t && cmp due t && test -L t.1.tmp && test \"$(cat a t.tmp t.1.tmp)\" = \"$(printf 'mine\\nmine\\nmine')\" && "
                            "test \"$(ls -l t | cut -c1-10)\" = -rw------- && test \"$(ls t*)\" = \"$(printf 't\\nt.1.tmp\\nt.tmp')\""), 0);
}

TEST(help_says_what_each_study_is)
{
    char words[200], due[60];
    snprintf(words, sizeof words, "%s", subcommand_find("study")->ways[0]);
    ck_assert_int_eq(run("help study"), 0);
    for (char *word = strtok(words, "|"); word != NULL; word = strtok(NULL, "|")) {
        snprintf(due, sizeof due, "(%s)", word);
        ck_assert_msg(strstr(output, due) != NULL, "%s", due);
    }
}

/* Held, the length leaves pitch its amplitude; moved by a hundredth of itself, it keeps pitch within as little of the averaged law. */
TEST(pitch_follows_the_averaged_law_where_the_length_moves)
{
    const char *row = output;
    double t = -14400, at = NAN, moved = NAN, law = NAN, held = NAN; /* no row, no value */
    ck_assert_int_eq(run("study damped"), 0);
    ck_assert_int_eq(lines(output), 1 + 20 * 6 + 1);
    while ((row = strchr(row, '\n') + 1)[0] != '\0') {
        ck_assert_int_eq(sscanf(row, "%lf,%lf,%lf,%lf", &at, &moved, &law, &held), 4);
        ck_assert_double_eq(at, t += 14400);
        ck_assert_double_eq_tol(held, 0.01, 0.01 * 0.01);
        ck_assert_double_eq_tol(moved, law, 0.02 * law);
    }
    ck_assert_double_lt(law, 0.5 * held);
}

TEST(a_closed_pipe_ends_quietly_with_1)
{
    int ends[2];
    ck_assert_int_eq(pipe(ends), 0);
    close(ends[0]);
    ck_assert_int_eq(run_to("trajectory linear", ends[1]), 1);
    close(ends[1]);
    ck_assert_str_eq(errors, "");
}

/* How many lines a use prints (0: however many), what stands in them, and not where it follows a !, and in its one line of errors. */
struct usage {
    const char *line;
    int status, lines;
    const char *prints[5], *says;
};

static void assert_use(const struct usage *u)
{
    ck_assert_msg(run(u->line) == u->status, "%s: %s", u->line, errors);
    if (u->lines > 0)
        ck_assert_msg(lines(output) == u->lines, "%s: %d lines", u->line, lines(output));
    for (int i = 0; i < 5 && u->prints[i] != NULL; i++)
        ck_assert_msg((strstr(output, u->prints[i] + (*u->prints[i] == '!')) == NULL) == (*u->prints[i] == '!'), "%s: %s", u->line, u->prints[i]);
    ck_assert_msg(strstr(errors, u->says ? u->says : "") != NULL && lines(errors) == (u->says != NULL), "%s: %s", u->line, errors);
}

#define FALLING "trajectory nonlinear Omega=1 k_c=1 m1=1 m2=1 L_ref=2 C1=0 C2=0 y1=0 x1_dot=0 y1_dot=0 z1_dot=0 "
#define HARDLY_DAMPED "trajectory nonlinear C1=5.3165972e-8 C2=1e-9 psi=0 theta=0 dL_dot=-3e-4 "
static const struct usage quick[] = {
    {"table1 --csv", 0, 7, {"name,printed,computed,unit,rounds\n", "Q_ref,-1.3306e-1,-1.33062778", "!,no\n"}, NULL},
    {"equations", 0, 0, {"flow_nonlinear"}, NULL},
    {"equations eq30", 0, 0, {"printed", "\n  given    m1         kg         > 0        mass of craft 1\n", "\n  returns  I_11 ", "\n  formula  I_11 = "}, NULL},
    {"equations eq30 --json", 0, 0, {"\"printed\": {\"let\": {}, \"outputs\": {\"I_11\": "}, NULL},
    {"equations eq02", 0, 0, {"  let      r_12 = sqrt((x1 - x2)^2", "  domain   (x1 - x2)^2", "  note     "}, NULL},
    {"equations eq05", 0, 0, {"  relation (5a) m1*x1 + m2*x2 = 0\n           (5b) x1 - x2 = L\n"}, NULL},
    {"equations rk4_linear", 0, 0, {"\n  domain   t >= 0\n           t/h an integer\n"}, NULL},
    {"equations --json", 0, 0, {"[{\"id\": "}, NULL},
    {"help design", 0, 0, {"\n  L_ref                 ", " [m, unless given: inf]\n", "!psi_dot", "limits too"}, NULL},
    /* hardly damped, and moving inwards towards the law's edge: dL = -3 Omega^2 L_ref/C1 = -3 m; of a set the first: 1 mm is passed in 4 s */
    {HARDLY_DAMPED "dL=-2.9", 1, 5, {NULL}, "Q_ref + dQ >= 0 from t = 355.77"},
    {HARDLY_DAMPED "dL=-2.9+-1e-3 --set --every 10", 1, 2 + 35, {NULL},
     "coulomb-tether: Q_ref + dQ may be >= 0 in the set, where Eq. (21) has no charges, last proved time 350 s\n"},
    {"trajectory nonlinear C1=1e300+-1 --set --every 3600", 1, 1, {NULL}, ""}, /* more than binary64 has, in units of Omega */
    {"trajectory nonlinear dL=-4+-0.01 --set", 1, 1, {NULL}, "has no charges, last proved time 0 s\n"}, /* before any row */
    {"trajectory nonlinear dL=-4", 1, 1, {NULL}, "Q_ref + dQ >= 0 at t = 0 s"},
    /* Kepler's fall along the orbit normal, and the tide beside it: after 0.58 s the craft are at one place; from 1 % nearer, what was
       split included, after 0.57 s at the earliest */
    {FALLING "x1=0 z1=1 --every 0.25 --until 10 --digits 4", 1, 4, {NULL},
     "the craft come closer than L_ref/128, nothing is proved beyond, last proved time 0.579"},
    {FALLING "x1=0 z1=1+-0.01 --set --every 0.25 --until 10 --digits 4", 1, 4, {NULL}, "the enclosure grew past use, last proved time 0.5"},
    /* y1 = 0.3125 (1/3) 12 m = 1.25 m, a tie that an enclosure of 1/3 leaves undecided */
    {"figure 5b m1=100 m2=50 dL=2 psi=0.3125 --digits 2", 1, 1, {NULL}, "bits do not decide every digit of row 1"},
};

EACH(a_use_prints_these_among_others, COUNT(quick))
{
    assert_use(&quick[_i]);
}

CASE(long_work, NULL, NULL)

static const struct usage slow[] = {
    {"verify claims n12-optimal", 0, 0, {"n12-optimal            qualified"}, NULL},
    {"verify claims equation-38", 0, 0, {"equation-38            holds as corrected"}, NULL},
    {"verify claims table1-Q_ref", 0, 0, {"table1-Q_ref           holds"}, NULL},
    {"verify derivations kepler --json", 0, 0, {"{\"derivations\": {\"fine\": true, \"steps\": [\n", "]}}\n"}, NULL},
    {"verify claims n12-optimal --json", 0, 0, {"{\"claims\": [{\"id\": \"n12-optimal\", ", "}]}\n"}, NULL},
    {"verify errors --count 2 --json", 0, 0, {"{\"errors\": [{\"id\": \"eq02\", \"inputs\": 2, ", "}]}\n"}, NULL},
    {"verify errors --count 2", 0, 0, {"\nE = |y - y*| / (2^-53 (|y*| + S))"}, NULL},
    /* At rest without a spring, C1 = 9 Omega^2; but 0.1 and 0.09 are no binary fractions, and so the zeros around which the enclosures
       shrink are never known to be such. */
    {"eval flow_linear Omega=0.1 L_ref=1 C1=0.09 C2=0.1 t=1 psi_0=0 theta_0=0 dL_0=1 psi_dot_0=0 theta_dot_0=0 dL_dot_0=0 --exact --digits 3", 1, 0,
     {"!="}, "bits do not decide every digit"},
    {"vectors flow_nonlinear --count 5 --seed 5", 1, 4, {NULL}, "the craft come closer than L_ref/128"}, /* the fourth falls together */
    /* The craft fall past each other, very close: more bits are taken when the first rows are out already. */
    {FALLING "x1=0.05 z1=1 --every 1 --until 3 --digits 3", 0, 5, {"\n3,"}, NULL},
};

EACH(a_long_use_prints_these_among_others, COUNT(slow))
{
    assert_use(&slow[_i]);
}

/* The same number in each form. */
TEST(inputs_of_random_vectors_are_written_as_asked)
{
    ck_assert_int_eq(run("vectors eq44 --count 1 --seed 1 --inputs hex"), 0);
    ck_assert_ptr_nonnull(strstr(output, "eq44-1-0,0x1."));
    const double n = strtod(strchr(strstr(output, "eq44-1-0,") + 9, ',') + 1, NULL);
    ck_assert_int_eq(run("vectors eq44 --count 1 --seed 1 --inputs exact"), 0);
    const char *exact = strchr(strstr(output, "eq44-1-0,") + 9, ',') + 1;
    ck_assert(strtod(exact, NULL) == n);
    ck_assert_uint_gt(strcspn(exact, ","), 40); /* of a binary64 all decimals, where the shortest have 17 at most */
}

/* The program on a terminal of its own, its standard output elsewhere: what the terminal shows. */
static const char *on_a_terminal(const char *line)
{
    static char shown[MOST_TEXT];
    const int terminal = posix_openpt(O_RDWR | O_NOCTTY);
    const char *name = terminal < 0 || grantpt(terminal) != 0 || unlockpt(terminal) != 0 ? NULL : ptsname(terminal);
    const int end = name != NULL ? open(name, O_RDWR | O_NOCTTY) : -1;
    if (end < 0) /* a bare system may have no terminals */
        return NULL;
    char command[1024];
    snprintf(command, sizeof command, "\"$CT_PROGRAM\" %s >/dev/null 2>%s", line, name);
    ck_assert_int_eq(system(command), 0);
    /* what is written there comes through in pieces and late: the test's own mark is the last of it */
    static const char mark[] = "(the end)";
    ck_assert_int_eq(write(end, mark, strlen(mark)), strlen(mark));
    size_t length = 0;
    char *last = NULL;
    while (last == NULL) {
        const ssize_t more = read(terminal, shown + length, sizeof shown - 1 - length);
        ck_assert_int_gt(more, 0);
        length += (size_t)more;
        shown[length] = '\0';
        last = strstr(shown, mark);
    }
    *last = '\0';
    close(end);
    close(terminal);
    return shown;
}

CASE(command_line, NULL, NULL)

EACH(a_terminal_sees_how_far_it_is_and_nothing_in_the_end, 3)
{
    static const struct {
        const char *line, *shows;
    } runs[] = {{"trajectory linear --every 100 --until 12800", "\r1 of 129"},
                {"vectors eq44 --count 7 --seed 1", "\r1 of 7"},
                {"conform --only eq07 -- \"$CT_BUILD/tests/faulty\"", " of 5"}};
    static const char cleared[] = "\r\033[K";
    const char *shown = on_a_terminal(runs[_i].line);
    if (shown == NULL)
        return;
    ck_assert_msg(strstr(shown, runs[_i].shows) != NULL, "%s", shown);
    ck_assert_str_eq(shown + strlen(shown) - strlen(cleared), cleared);
}
