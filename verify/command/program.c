/* coulomb-tether: a subcommand on the paper as data. */
#include <errno.h>
#include <fcntl.h>
#include <gsl/gsl_errno.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "command/command.h"
#include "text/flint.h"
#include "text/whole_file.h"

static bool asks_help(const char *text)
{
    return strcmp(text, "--help") == 0 || strcmp(text, "-h") == 0;
}

/* What it prints is kept in a temporary file until it is done; it stands under that name then, or not at all. */
static int run_into(const struct arguments *a, const char *name)
{
    FILE *kept = tmpfile();
    const int out = dup(STDOUT_FILENO); /* which the name may mean */
    char bytes[1 << 12];
    size_t size;
    int why = 0;
    bool ready = kept != NULL && out >= 0 && dup2(fileno(kept), STDOUT_FILENO) >= 0;
    int status = ready ? a->subcommand->run(a) : EXIT_FAILED_CHECK;
    if (ready && output_finished() != EXIT_DONE)
        status = EXIT_FAILED_CHECK; /* LCOV_EXCL_LINE: only on a full disk */
    ready = ready && dup2(out, STDOUT_FILENO) >= 0;
    if (!ready)
        status = usage_error(EXIT_FAILED_CHECK, "a temporary file: %s", strerror(errno)); /* LCOV_EXCL_LINE: only without a place for one */
    if (status == EXIT_DONE || status == REPORTED_CHECK) {
        rewind(kept);
        struct whole_file f = whole_file_open(name);
        while (f.file != NULL && (size = fread(bytes, 1, sizeof bytes, kept)) > 0)
            fwrite(bytes, 1, size, f.file);
        why = whole_file_close(&f, ferror(kept) ? EIO : 0);
    }
    if (kept != NULL)
        fclose(kept);
    close(out);
    return why == 0 ? status : usage_error(EXIT_FAILED_CHECK, "%s: %s", name, strerror(why));
}

/* Of the sheet, once the line asks for nothing that cannot be. */
static int run_on(const struct sources *sources, struct arguments a, bool help)
{
    struct paper paper;
    struct message why;
    const char *file = option_value(&a, "-o");
    int status = EXIT_DONE;
    if (paper_open(&paper, sources, &why) != 0)
        return usage_error(EXIT_FAILED_CHECK, "%s", why.text);
    a.paper = &paper;
    if (help)
        help_print(&paper.sheet, a.subcommand);
    else /* with a client or answers of one it names the report, which has a form of its own */
        status = file == NULL || a.client != NULL || option_given(&a, "--answers") ? a.subcommand->run(&a) : run_into(&a, file);
    paper_close(&paper);
    return status;
}

static int run_subcommand(const struct sources *sources, int count, char **texts)
{
    if (count < 2)
        return usage_error(EXIT_USAGE, "expected a subcommand, see coulomb-tether --help");
    struct arguments a = {.subcommand = subcommand_find(texts[1])};
    bool help = asks_help(texts[1]);
    if (strcmp(texts[1], "--version") == 0 || strcmp(texts[1], "-V") == 0) {
        puts("coulomb-tether " CT_VERSION);
        return EXIT_DONE;
    }
    if (a.subcommand == NULL && !help)
        return unknown_subcommand(texts[1]);
    for (int i = 2; i < count && a.subcommand != NULL && strcmp(texts[i], "--") != 0; i++)
        help = help || asks_help(texts[i]);
    int status = help ? EXIT_DONE : arguments_read(&a, count - 2, texts + 2);
    if (status == EXIT_DONE)
        status = run_on(sources, a, help);
    arguments_clear(&a);
    return status == REPORTED_CHECK ? EXIT_FAILED_CHECK : status;
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

int program_run(const struct sources *sources, int count, char **arguments)
{
    signal(SIGPIPE, SIG_IGN); /* a closed pipe is a write error like others */
    signal(SIGCHLD, SIG_DFL); /* ignored, it would take away how a client ended */
    guard_memory();
    if (!guard_streams())
        return usage_error(EXIT_FAILED_CHECK, "/dev/null: %s", strerror(errno)); /* LCOV_EXCL_LINE: the same */
    int status = run_subcommand(sources, count, arguments);
    if (status == EXIT_DONE)
        status = output_finished();
    flint_cleanup();
    mpfr_free_cache();
    return status;
}
