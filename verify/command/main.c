/* coulomb-tether: the program's door. */
#include <errno.h>
#include <fcntl.h>
#include <gsl/gsl_errno.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "command/command.h"
#include "text/flint.h"

static const struct subcommand {
    const char *name;
    int (*run)(int count, char **arguments);
    const char *usage;
} subcommands[] = {
    {"equations", command_equations,
     "equations [ID] [--json]\n"
     "    what there is: title, formula, inputs with units and domains\n"},
    {"eval", command_eval,
     "eval ID NAME=VALUE ... [--digits 40] [--exact] [--as-printed] [--json]\n"
     "    the outputs of one operation, every digit proved\n"},
    {"table1", command_table1,
     "table1 [--csv]\n"
     "    the paper's Table 1: printed, computed, and whether it rounds to the printed digits\n"},
    {"figure", command_figure,
     "figure 4|5a|5b|6|7a|7b [NAME=VALUE ...] [--digits 17] [--exact] [--rk4 H]\n"
     "    the data of a figure as CSV; --rk4 adds the classical Runge-Kutta method's columns\n"},
    {"trajectory", command_trajectory,
     "trajectory linear|nonlinear [--at T,...|--every S --until S] [--rk4 H] [NAME=VALUE ...]\n"
     "           [--digits D] [--exact]\n"
     "    a motion as CSV; names: m1 m2 L_ref k_c Omega n C1 C2 psi theta dL psi_dot theta_dot\n"
     "    dL_dot, and for nonlinear x1 y1 z1 x1_dot y1_dot z1_dot in place of the angles\n"},
    {"verify", command_verify,
     "verify [derivations|claims [ID]|errors] [--json] [--csv] [--graph] [--count N]\n"
     "    the proofs of the derivation steps, the verdicts, ref's measured error; --graph draws the steps for\n"
     "    dot, --csv prints the verdicts as CSV, --count sets the random inputs of errors\n"},
    {"study", command_study,
     "study convergence|forced|pitch\n"
     "    beyond the paper, as CSV: orders of its approximations; what pitch leaves in yaw and length, and\n"
     "    how it decays, beside their closed forms\n"},
    {"vectors", command_vectors,
     "vectors ID --count N --seed S [--shard K/N] [--inputs shortest|exact|hex] | vectors ID --golden\n"
     "    random certified vectors, or the golden ones, as CSV; inputs as shortest decimals of their binary64, with\n"
     "    all its digits, or in C99 hexadecimal\n"},
    {"conform", command_conform,
     "conform [--only ID|LEVEL,...] [--random N --seed S] [--digits ID=D] ... [--timeout SECONDS]\n"
     "        [--significand 24|53|113] [--inputs shortest|exact|hex] [--range] [--report FILE.xml|FILE.json]\n"
     "        -- CLIENT ARGS...\n"
     "conform --answers FILE.csv ID | conform --kills [--only ID|LEVEL,...]\n"
     "    is an implementation right, by how much is it wrong, and which mistake does it look like\n"},
    {"typeset", command_typeset,
     "typeset [ID]\n"
     "    the sheet's formulas as LaTeX, a line each, for the weaver of the literate edition\n"},
    {"datapackage", command_datapackage,
     "datapackage < LINES-OF-SHA256SUM\n"
     "    the description of the data files, datapackage.json\n"},
};

enum { SUBCOMMANDS = sizeof subcommands / sizeof *subcommands };

static int help(void)
{
    fputs("coulomb-tether: a machine-checked edition of the equations of a Coulomb tether formation\n\n",
          stdout);
    for (int i = 0; i < SUBCOMMANDS; i++)
        printf("coulomb-tether %s", subcommands[i].usage);
    fputs("coulomb-tether --help | --version | SUBCOMMAND --help\n\n"
          "Exit: 0 done; 1 a check failed, a value outside its domain, input or output failed;\n"
          "2 wrong usage.\n",
          stdout);
    return output_finished();
}

static int run_subcommand(int count, char **arguments)
{
    if (count < 2)
        return usage_error(EXIT_USAGE, "expected a subcommand, see coulomb-tether --help");
    if (strcmp(arguments[1], "--help") == 0)
        return help();
    if (strcmp(arguments[1], "--version") == 0) {
        puts("coulomb-tether " CT_VERSION);
        return output_finished();
    }
    const char *known[SUBCOMMANDS];
    for (int i = 0; i < SUBCOMMANDS; i++) {
        known[i] = subcommands[i].name;
        if (strcmp(arguments[1], known[i]) != 0)
            continue;
        for (int k = 2; k < count && strcmp(arguments[k], "--") != 0; k++)
            if (strcmp(arguments[k], "--help") == 0) {
                printf("coulomb-tether %s", subcommands[i].usage);
                return output_finished();
            }
        return subcommands[i].run(count - 2, arguments + 2);
    }
    char hint[80];
    suggest(hint, arguments[1], known, SUBCOMMANDS);
    return usage_error(EXIT_USAGE, "unknown subcommand '%s'%s", arguments[1], hint);
}

/* ---- memory: where it runs out the libraries would end by a signal ---- */

static void *allocate(size_t size)
{
    return xrealloc(NULL, size, 1);
}

static void *allocate_zeros(size_t count, size_t size)
{
    return memset(xrealloc(NULL, count, size), 0, count * size);
}

static void *reallocate(void *old, size_t size)
{
    return xrealloc(old, size, 1);
}

static void *reallocate_sized(void *old, size_t old_size, size_t size)
{
    (void)old_size;
    return xrealloc(old, size, 1);
}

static void release_sized(void *block, size_t size)
{
    (void)size;
    free(block);
}

/* What else GSL reports is the status of its caller. */
static void gsl_failed(const char *reason, const char *file, int line, int code) /* LCOV_EXCL_LINE: make faults */
{
    (void)reason;
    (void)file;
    (void)line;
    if (code == GSL_ENOMEM) /* LCOV_EXCL_LINE: only where memory runs out, make faults */
        out_of_memory();
} /* LCOV_EXCL_LINE: make faults */

static void guard_memory(void)
{
    mp_set_memory_functions(allocate, reallocate_sized, release_sized);
    __flint_set_memory_functions(allocate, allocate_zeros, reallocate, free);
    gsl_set_error_handler(gsl_failed);
}

/* ---- what the caller hands over ---- */

/* Standard streams that are closed: no pipe or file may take their numbers, and using them stays an error. */
static bool guard_streams(void)
{
    for (int file = 0; file <= 2; file++)
        if (fcntl(file, F_GETFD) < 0 && open("/dev/null", file == 0 ? O_WRONLY : O_RDONLY) != file)
            return false; /* LCOV_EXCL_LINE: /dev/null fails, make faults */
    return true;
}

int main(int count, char **arguments)
{
    signal(SIGPIPE, SIG_IGN); /* a closed pipe is a write error like others */
    signal(SIGCHLD, SIG_DFL); /* ignored, it would take away how a client ended */
    guard_memory();
    if (!guard_streams())
        return usage_error(EXIT_FAILED_CHECK, "/dev/null: %s", strerror(errno)); /* LCOV_EXCL_LINE: the same */
    int status = run_subcommand(count, arguments);
    sheet_close();
    flint_cleanup();
    mpfr_free_cache();
    return status;
}
