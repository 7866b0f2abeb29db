#include "command/options.h"

#include <stddef.h>
#include <string.h>

#define MOTIONS "5a|5b|6|7a|7b"

const struct subcommand subcommands[] = {
    {"equations", command_equations, {"[ID]"}, 1,
     "What there is: the equations and the motions, or one of them with its title, formula, inputs, units, domain and verdict."},
    {"eval", command_eval, {"ID NAME=VALUE ...", "-"}, 1,
     "The outputs of one operation as NAME = DIGITS UNIT, every digit proved. Every input is given once, by its name in "
     "equations ID, in that unit and inside that domain (t a multiple of h in rk4_linear and rk4_nonlinear). With - it reads "
     "lines ID VECTOR-ID INPUT..., as the oracle writes them, and answers each at once, VECTOR-ID OUTPUT..., VECTOR-ID invalid "
     "where the inputs lie outside the domain, or VECTOR-ID skip REASON where nothing is proved, which makes the exit status 1; "
     "the first malformed line ends it with 2."},
    {"table1", command_table1, {""}, 0,
     "The paper's Table 1: printed, computed, and whether the computed value rounds to the printed digits."},
    {"figure", command_figure, {"4 [Omega=VALUE]", MOTIONS " [NAME=VALUE ...]"}, 1,
     "The data of a figure as CSV, every digit proved: the characteristic roots against n from 9 to 40 (4), or three days of "
     "motion, a row every 100 s: attitude and length error (5a) and craft 1 (5b) by the linear model, craft 1 (6) and the "
     "charges in microcoulomb (7a, 7b) by the nonlinear one. The names are those of trajectory."},
    {"trajectory", command_trajectory, {"linear|nonlinear [NAME=VALUE ...]"}, 1,
     "A motion as CSV, every digit proved: attitude and length error by the linear model, or position and velocity of craft 1 "
     "and both charges by the nonlinear one. A nonlinear motion ends where the charge law has no charges, or where craft "
     "that come closer than L_ref/128 leave nothing to be proved; the rows before that are printed."},
    {"design", command_design, {"[n=VALUE | C1=VALUE C2=VALUE] [NAME=VALUE ...]"}, 0,
     "What one decides with, every digit proved: gains, charges, roots and frequencies; how long the law may be held between "
     "samples, or act late, before the linear model no longer comes to rest; the basin of rest in the nonlinear one, and the errors "
     "that it bears. NAME is Omega, L_ref, k_c, m1, m2 or lambda_d, of which the force that is missing is told, all other "
     "numbers being those without screening; gains outside (42), and a lambda_d at which nothing rests near L_ref, end it with "
     "exit status 1."},
    {"verify", command_verify, {"", "derivations [STEP]", "claims [ID]", "errors"}, 2,
     "The proofs: of the derivation steps between the equations, with bounds of what they drop (derivations); of every claim "
     "of the paper, with its verdict (claims); the reference library's error, measured against the truth on random inputs "
     "(errors). Without a word, all three."},
    {"study", command_study, {"convergence|forced|pitch|damped|basin|saturation|tolerance|balance|sampling"}, 1,
     "Beyond the paper, as CSV: the observed orders of its approximations (convergence), what pitch forces on length and yaw "
     "(forced), the slow decay of pitch itself (pitch), and that under a length that moves with it (damped), beside their closed "
     "forms; over the gains, in radians of orbit and L_ref, the basin of rest (basin), that of charges with a bound "
     "(saturation), the errors that stay and are borne (tolerance), the push under which a length is one of rest (balance), "
     "and how long the law may be held or how late it may act (sampling). Every digit is certified."},
    {"vectors", command_vectors, {"ID --count N --seed S", "ID --golden"}, 1,
     "Vectors of an operation as CSV: inputs, outputs of 40 digits, each proved, their sensitivities, and flags; random ones, "
     "which depend on seed and number alone, or those of data/golden."},
    {"conform", command_conform, {"-- CLIENT [ARG ...]", "--answers FILE [ID]", "--questions", "--kills"}, 2,
     "Is an implementation right, in whatever language: asks a client, or reads a file of its answers, and says what is wrong, "
     "by how much, and which known mistake it looks like. verify/PROTOCOL.md is what a client has to do."},
    {"help", command_help, {"[SUBCOMMAND]"}, 1,
     "The subcommands, or all about one: its words, its options with their units and defaults, and examples. SUBCOMMAND --help "
     "and SUBCOMMAND -h say the same."},
    {.name = NULL},
};

const struct option options[] = {
    /* what equations, points and motions have in common */
    {"--digits", "N", .of = "eval", "significant digits of every output, 1 to 10000", .otherwise = "40", .least = 1, .most = 10000},
    {"--digits", "N", .of = "design",
     "significant digits of every number, 1 to 10000; rounded to the nearest, limits too",
     .otherwise = "8", .least = 1, .most = 10000},
    {"--digits", "N", .of = "figure trajectory",
     "significant digits of every number, 1 to 10000", .otherwise = "17", .least = 1, .most = 10000},
    {"--exact", .of = "eval figure trajectory design",
     "a decimal means itself, defaults included, and not the binary64 nearest to it; exponents up to 5000"},
    {"--as-printed", .of = "eval", "the formula as the paper prints it, where the sheet has a corrected one"},
    {"--table1", .of = "eval",
     "the paper's case for every input that is not given; of a nonlinear motion the state by (10), the binary64 nearest to "
     "it", .with = "ID"},
    {"--json", .of = "equations verify design", "JSON in place of text for reading"},
    {"--json", .of = "eval", "JSON in place of text for reading", .with = "ID"},
    {"--csv", .of = "table1", "CSV in place of text for reading"},
    {"-o", "FILE", .of = "equations eval table1 figure trajectory verify study design vectors",
     "in place of standard output a file, which is there whole or not at all"},
    /* motions */
    {"--at", "T,...", .of = "trajectory",
     "the times wanted, all of one sign, each further from 0 than the last; in place of --every and --until", .unit = "s"},
    {"--every", "S", .of = "trajectory", "a row at 0 and every S from there", .unit = "s", .otherwise = "100"},
    {"--until", "S", .of = "trajectory", "the end of the rows; before 0 they go back in time", .unit = "s", .otherwise = "259200"},
    {"--set", .of = "trajectory",
     "bounds, NAME_low and NAME_high, of all motions for values given as VALUE+-RADIUS, but Omega and n; that of k_c is a "
     "factor on the force alone, the law has its middle; of x1 ... z1_dot some will do, the angles say the others. A set "
     "that is wide is split, into 256 parts at most, followed on all processors; the rows end at the first at which (21) "
     "may have no charges", .with = "nonlinear"},
    {"--rk4", "H", .of = "trajectory",
     "the classical Runge-Kutta method in steps of H, free of rounding, in place of the motion itself; times are multiples "
     "of H", .unit = "s"},
    {"--rk4", "H", .of = "figure",
     "further columns: the classical Runge-Kutta method in steps of H, a divisor of 100, free of rounding",
     .unit = "s", .with = MOTIONS},
    /* proofs */
    {"--count", "N", .of = "verify",
     "random inputs of each operation", .otherwise = "1000", .with = "errors|", .least = 1, .most = 100000000},
    /* vectors */
    {"--count", "N", .of = "vectors", "how many random vectors", .most = UINT64_MAX},
    {"--seed", "S", .of = "vectors", "what they are drawn from, a whole number below 2^64", .most = UINT64_MAX},
    {"--shard", "K/N", .of = "vectors", "the Kth of N parts alone; the first has the header", .otherwise = "1/1", .with = "--count"},
    {"--golden", .of = "vectors", "the golden vectors in place of random ones"},
    /* the oracle */
    {"--only", "ID,...", .of = "conform",
     "operations, single vectors, or levels: algebra, roots, flows (the motions) and method (Runge-Kutta)",
     .otherwise = "all", .with = "--|--kills|--questions|--answers"},
    {"--random", "N", .of = "conform",
     "random vectors beside the golden ones, one of sixteen from outside the domain; of motions only those that --only "
     "names", .otherwise = "0", .with = "--|--questions|--answers", .most = 100000000},
    {"--seed", "S", .of = "conform", "what they are drawn from, a whole number below 2^64", .with = "--random", .most = UINT64_MAX},
    {"--digits", "ID=D", .of = "conform",
     "the digits that a motion has to reach; for several, given several times", .otherwise = "9; rk4_*: 11", .repeated = true},
    {"--significand", "24|53|113", .of = "conform",
     "of the client's numbers: float, double or quad", .unit = "bit", .otherwise = "53", .with = "--|--answers"},
    {"--inputs", "shortest|exact|hex", .of = "vectors conform",
     "inputs as the shortest decimals of their binary64, with all its digits, or in C99 hexadecimal",
     .otherwise = "shortest", .with = "ID|--|--questions|--answers"},
    {"--range", .of = "conform",
     "vectors too that leave the range of the client's numbers on their way", .with = "--|--questions|--answers"},
    {"--timeout", "SECONDS", .of = "conform", "how long a client may be silent", .unit = "s", .otherwise = "60", .with = "--"},
    {"--all", .of = "conform",
     "every failing vector, not the plainest of each operation alone; and of motions the digits reached at each time",
     .with = "--|--answers"},
    {"--expect", "FILE", .of = "conform",
     "a vector's name a line: these may fail, and one that passes is named; # begins a comment", .with = "--|--answers"},
    {"--report", "FILE", .of = "conform", "a report as well: .xml for JUnit, or .json", .with = "--|--answers"},
    {"-o", "FILE", .of = "conform", "the same as --report; with --questions or --kills a file in place of standard output"},
    {"--answers", "FILE", .of = "conform",
     "the answers of one operation, CSV with a column id and one of each output; or what a client has written, of all that "
     "it was asked"},
    {"--questions", .of = "conform",
     "no client: the lines that it would be asked, for one that cannot be started here; --answers takes what it writes"},
    {"--kills", .of = "conform", "no client: which golden vector tells which known mistake from the truth, as CSV"},
    {.name = NULL},
};

const struct example examples[] = {
    {"equations", "every equation, and whether it is misprinted"},
    {"equations eq37 --json", "one of them, for programs"},
    {"eval eq07 Omega=7.2915e-5 k_c=8.99e9 m1=150 m2=150 L=10 --digits 50",
     "the charge product that holds two craft of 150 kg at 10 m in geostationary orbit"},
    {"eval eq38 GM=3.986004418e14 R_c=42164e3 --as-printed --json", "Kepler's third law with the paper's factor of 3"},
    {"eval eq43 Omega=7.2915e-5 n=10 --exact", "3.316...e-8 as the decimals say, no binary64 between"},
    {"eval eq07 m2=50 --table1", "the paper's case but for one craft's mass"},
    {"eval - --digits 17 <questions", "lines like: eq44 first 7.2915e-5 10"},
    {"table1 --csv", "the table, for a spreadsheet"},
    {"figure 4 -o figure4.csv", "the roots against n, in a file that is there whole or not at all"},
    {"figure 5a n=20 --rk4 100 --digits 6 --exact",
     "the attitude with another gain, certified and by the paper's own method"},
    {"trajectory nonlinear m2=50 --every 600 --until 43200 --digits 8", "half a day with a lighter second craft"},
    {"trajectory nonlinear psi=0.01+-0.001 dL=0.1+-0.01 m1=150+-1 --set --every 3600", "where the pair may be, somewhere in a box"},
    {"trajectory linear C1=6e-8 C2=2e-4 --at 0,3600,86164 --exact", "three times, with gains of one's own"},
    {"trajectory linear --rk4 50 --every 100 --until 1000", "the paper's method at half its step"},
    {"trajectory linear | gnuplot -p -e "
     "\"set datafile separator ','; set key autotitle columnhead; plot '<cat' using 1:4 with lines\"",
     "the length error over three days, drawn"},
    {"design n=12 m2=50 --exact --digits 12 --json", "what one decides with, for another gain and a lighter second craft"},
    {"verify", "all the proofs; exit status 0 says that they hold"},
    {"verify claims n12-optimal", "one claim, its verdict and the evidence"},
    {"verify claims --json >verdicts.json", "all of them"},
    {"verify errors --count 10000", "the reference library's largest errors"},
    {"study forced >forced.csv", "six days of motion beside the closed forms"},
    {"vectors eq07 --count 1000 --seed 1 --inputs hex", "a thousand certified vectors"},
    {"vectors eq03 --count 80000 --seed 1 --shard 3/8", "the third of eight parts, made apart and joined by cat"},
    {"vectors eq44 --golden --inputs exact", "the golden vectors, inputs with all their digits"},
    {"conform -- python3 client.py", "every operation's golden vectors"},
    {"conform --only eq07,roots --random 1000 --seed 1 --range --inputs hex --report report.xml -- ./client",
     "random ones too, and a report"},
    {"conform --only flow_nonlinear --digits flow_nonlinear=7 --timeout 300 -- ./client",
     "a slow integrator that promises 7 digits"},
    {"conform --only algebra --significand 24 -- ./client", "a client in single precision"},
    {"conform --all --expect known.txt -- ./client", "every failing vector but those that are known to fail"},
    {"conform --questions --only algebra >questions.txt", "the questions for a target that cannot be started here"},
    {"conform --answers answers.txt --only algebra", "and its answers"},
    {"conform --answers answers.csv -o report.json eq07", "answers to one operation as CSV, and a report"},
    {"conform --kills --only eq21", "what the golden vectors are there for"},
    {"help trajectory", "all about a subcommand"},
    {.line = NULL},
};

bool word_in(const char *text, const char *separators, const char *word)
{
    const size_t length = strlen(word);
    for (const char *at = text;; at++) {
        const size_t here = strcspn(at, separators);
        if (here == length && strncmp(at, word, length) == 0)
            return true;
        at += here;
        if (*at == '\0')
            return false;
    }
}

bool option_belongs(const struct option *o, const struct subcommand *s)
{
    return word_in(o->of, " ", s->name);
}

const struct subcommand *subcommand_find(const char *name)
{
    for (const struct subcommand *s = subcommands; s->name != NULL; s++)
        if (strcmp(s->name, name) == 0)
            return s;
    return NULL;
}
