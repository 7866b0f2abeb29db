/*
 * faults.so   makes allocations of a program fail, one after the other: LD_PRELOAD=faults.so FAULTS=FOLDER PROGRAM
 *
 * At an allocation the process forks. In the child this allocation fails, and it may end in two ways: with exit
 * status 1 and one line on standard error that names memory, or, where a library gets along without, as if nothing had
 * happened. The parent waits for that, goes on with the allocation granted, and so comes to all of them in one run.
 * Each fails twice: once by itself, once with all that follow it.
 *
 * FOLDER/expected holds the program's output without faults, to which standard output, a file, is compared. What came
 * of it is written to FOLDER/report: a line a child that ended otherwise, and a line of counts at the end.
 *
 * FAULTS_FROM=N      the allocations before number N do not fail
 * FAULTS_STEP=N      of the others the first N fail, and then one in ever larger steps, by 1/N of those passed;
 *                    without it all of them
 * FAULTS_AT=N        no forks: only the allocation number N fails, in the program itself (0: none)
 * FAULTS_SHORT=1     no forks: a read() or write() that the program calls itself transfers one byte
 */
#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <signal.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

/* glibc's own, below the names that are taken here. */
void *__libc_malloc(size_t size);                /* NOLINT(bugprone-reserved-identifier) */
void *__libc_calloc(size_t count, size_t size);  /* NOLINT(bugprone-reserved-identifier) */
void *__libc_realloc(void *old, size_t size);    /* NOLINT(bugprone-reserved-identifier) */
ssize_t __read(int file, void *bytes, size_t size);         /* NOLINT(bugprone-reserved-identifier) */
ssize_t __write(int file, const void *bytes, size_t size);  /* NOLINT(bugprone-reserved-identifier) */

enum { SECONDS = 20 /* after which a child hangs */, MOST_FILES = 16, LONGEST = 4096 };

static enum { ABSENT, FORKING, GRANTING, FAILING } role;
static bool child, from_then_on, shorten;
static unsigned long calls, next = 1, from = 1, step = ULONG_MAX, refused, survived, wrong;
static int expected = -1, out = -1, errors = -1, report = -1;

static int open_in(const char *folder, const char *name, int flags)
{
    char path[LONGEST];
    snprintf(path, sizeof path, "%s/%s", folder, name);
    return open(path, flags | O_CLOEXEC, 0644);
}

static unsigned long number_in(const char *name, unsigned long otherwise)
{
    const char *text = getenv(name);
    return text != NULL ? strtoul(text, NULL, 10) : otherwise;
}

__attribute__((constructor)) static void begin(void)
{
    const char *folder = getenv("FAULTS");
    if (folder == NULL)
        return;
    step = number_in("FAULTS_STEP", ULONG_MAX);
    shorten = getenv("FAULTS_SHORT") != NULL;
    report = open_in(folder, "report", O_WRONLY | O_CREAT | O_TRUNC);
    expected = open_in(folder, "expected", O_RDONLY);
    out = open_in(folder, "child.out", O_RDWR | O_CREAT | O_TRUNC);
    errors = open_in(folder, "child.err", O_RDWR | O_CREAT | O_TRUNC);
    const bool at = getenv("FAULTS_AT") != NULL;
    from = number_in("FAULTS_FROM", 1);
    next = number_in("FAULTS_AT", from);
    unsetenv("LD_PRELOAD"); /* a client of the oracle is another program */
    unsetenv("FAULTS");
    if (report < 0 || (!at && (expected < 0 || out < 0 || errors < 0)))
        abort();
    role = shorten ? ABSENT : at ? FAILING : FORKING;
    calls = 0;
}

__attribute__((destructor)) static void end(void)
{
    if (role == ABSENT || child)
        return;
    dprintf(report, "%lu allocations, %lu refused, %lu survived, %lu wrong\n", calls, refused, survived, wrong);
}

/* ---- the parent's judgement ---- */

/* Whether the child wrote what is expected from there on, the whole of it or a beginning. */
static bool output_is_right(off_t from, bool whole)
{
    static char got[LONGEST], due[LONGEST];
    for (off_t at = 0;; at += LONGEST) {
        const ssize_t size = pread(out, got, LONGEST, at), known = pread(expected, due, LONGEST, from + at);
        if (size > known || size < 0 || memcmp(got, due, (size_t)size) != 0 || (whole && size != known))
            return false;
        if (size < LONGEST)
            return true;
    }
}

static void judge(int status, off_t written)
{
    static char said[LONGEST];
    const ssize_t length = pread(errors, said, sizeof said - 1, 0);
    said[length > 0 ? length : 0] = '\0';
    const char *line_end = strchr(said, '\n');
    if (WIFEXITED(status) && WEXITSTATUS(status) == 1 && line_end != NULL && line_end[1] == '\0' &&
        strstr(said, "memory") != NULL && output_is_right(written, false)) {
        refused++;
    } else if (WIFEXITED(status) && WEXITSTATUS(status) == 0 && length == 0 && output_is_right(written, true)) {
        survived++;
    } else {
        wrong++;
        dprintf(report, "allocation %lu%s: %s %d: %s\n", calls, from_then_on ? " and all after it" : "",
                WIFSIGNALED(status) ? "signal" : "exit status",
                WIFSIGNALED(status) ? WTERMSIG(status) : WEXITSTATUS(status), length > 0 ? said : "silent");
    }
}

/* How far a file has been read is common to parent and child, unless the child opens it again. */
static void open_again(int file)
{
    char path[64];
    struct stat known;
    if (fstat(file, &known) != 0 || !S_ISREG(known.st_mode))
        return;
    snprintf(path, sizeof path, "/proc/self/fd/%d", file);
    const int other = open(path, O_RDONLY);
    if (other < 0 || lseek(other, lseek(file, 0, SEEK_CUR), SEEK_SET) < 0 || dup2(other, file) < 0)
        abort();
    close(other);
}

static void begin_child(void)
{
    child = true;
    lseek(out, 0, SEEK_SET);
    lseek(errors, 0, SEEK_SET);
    if (dup2(out, 1) < 0 || dup2(errors, 2) < 0)
        abort();
    open_again(0);
    for (int file = 3; file < MOST_FILES; file++)
        if (file != report && file != expected && file != out && file != errors)
            open_again(file);
    alarm(SECONDS);
}

/* True in the child. */
static bool forked(void)
{
    int status = 0;
    const off_t written = lseek(1, 0, SEEK_CUR);
    if (ftruncate(out, 0) != 0 || ftruncate(errors, 0) != 0)
        abort();
    const pid_t pid = fork();
    if (pid == 0) {
        begin_child();
        return true;
    }
    if (pid < 0 || waitpid(pid, &status, 0) != pid)
        abort();
    judge(status, written);
    return false;
}

/* ---- allocations ---- */

static bool fails(void)
{
    if (role == ABSENT || role == GRANTING)
        return false;
    calls++;
    if (role == FAILING)
        return calls == next || (from_then_on && calls > next);
    if (calls != next)
        return false;
    role = GRANTING;
    for (from_then_on = false;; from_then_on = true) {
        if (forked()) {
            role = FAILING;
            return true;
        }
        if (from_then_on)
            break;
    }
    role = FORKING;
    next += 1 + (next - from) / step;
    return false;
}

static void *refusal(void)
{
    errno = ENOMEM;
    return NULL;
}

void *malloc(size_t size)
{
    return fails() ? refusal() : __libc_malloc(size);
}

void *calloc(size_t count, size_t size)
{
    return fails() ? refusal() : __libc_calloc(count, size);
}

void *realloc(void *old, size_t size)
{
    return size > 0 && fails() ? refusal() : __libc_realloc(old, size);
}

/* ---- transfers ---- */

ssize_t read(int file, void *bytes, size_t size)
{
    return __read(file, bytes, shorten && size > 1 ? 1 : size);
}

ssize_t write(int file, const void *bytes, size_t size)
{
    return __write(file, bytes, shorten && size > 1 ? 1 : size);
}
