#include "conform/client.h"

#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include "text/progress.h"

extern char **environ;

enum { PIPEFUL = 1 << 16, ANSWERS = 1 << 12 }; /* what a pipe holds; and what one that polls as ready takes at once */

static const int interrupts[] = {SIGINT, SIGTERM, SIGHUP, SIGQUIT};
enum { INTERRUPTS = sizeof interrupts / sizeof *interrupts };

static void close_end(int *end)
{
    if (*end >= 0)
        close(*end);
    *end = -1;
}

/* A pipe of which neither end survives an exec; the parent's, ends[own], never blocks. */
static bool open_pipe(int ends[2], int own)
{
    return pipe(ends) == 0 && fcntl(ends[0], F_SETFD, FD_CLOEXEC) == 0 && fcntl(ends[1], F_SETFD, FD_CLOEXEC) == 0 &&
           fcntl(ends[own], F_SETFL, O_NONBLOCK) == 0;
}

static bool is_passing(int error)
{
    return error == EAGAIN || error == EINTR;
}

/* The client that exit() ends: only one is open at a time. */
static pid_t running;

static void end_group(void)
{
    if (running <= 0)
        return;
    kill(running, SIGKILL);
    kill(-running, SIGKILL); /* not yet waited for, the client keeps its group's number */
}

/* In a group of its own, those ends its standard streams, its signals as ours were; 0, or the errno that says why not. */
static int spawn(struct client *c, char *const *arguments, int in, int out, int errors)
{
    posix_spawnattr_t how;
    posix_spawn_file_actions_t streams;
    sigset_t pipe_signal;
    int why = posix_spawnattr_init(&how);
    if (why != 0)
        return why; /* LCOV_EXCL_LINE: only where memory runs out */
    why = posix_spawn_file_actions_init(&streams);
    if (why == 0) { /* LCOV_EXCL_BR_LINE: the same */
        sigemptyset(&pipe_signal);
        sigaddset(&pipe_signal, SIGPIPE);
        if ((why = posix_spawnattr_setflags(&how, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF)) == 0 &&
            (why = posix_spawnattr_setsigmask(&how, &c->signals)) == 0 &&
            (why = posix_spawnattr_setsigdefault(&how, &pipe_signal)) == 0 &&
            (why = posix_spawn_file_actions_adddup2(&streams, in, 0)) == 0 &&
            (why = posix_spawn_file_actions_adddup2(&streams, out, 1)) == 0 &&
            (why = posix_spawn_file_actions_adddup2(&streams, errors, 2)) == 0)
            why = posix_spawnp(&c->pid, arguments[0], &streams, &how, arguments, environ);
        posix_spawn_file_actions_destroy(&streams);
    }
    posix_spawnattr_destroy(&how);
    return why;
}

int client_start(struct client *c, char *const *arguments)
{
    int in[2] = {-1, -1}, out[2] = {-1, -1}, errors[2] = {-1, -1}, why = 0;
    static bool at_exit;
    sigset_t blocked;
    *c = (struct client){0};
    sigemptyset(&blocked);
    for (int i = 0; i < INTERRUPTS; i++)
        sigaddset(&blocked, interrupts[i]);
    sigprocmask(SIG_BLOCK, &blocked, &c->signals);
    at_exit = at_exit || atexit(end_group) == 0;
    if (!at_exit)
        why = ENOMEM; /* LCOV_EXCL_LINE: only where memory runs out, make faults */
    else if (!open_pipe(in, 1) || !open_pipe(out, 0) || !open_pipe(errors, 0))
        why = errno;
    else
        why = spawn(c, arguments, in[0], out[1], errors[1]);
    c->pid = why == 0 ? c->pid : -1;
    running = c->pid;
    close_end(&in[0]);
    close_end(&out[1]);
    close_end(&errors[1]);
    c->to = in[1];
    c->from = out[0];
    c->errors = errors[0];
    if (why != 0)
        client_close(c);
    return why;
}

static bool is_interrupted(const struct client *c)
{
    sigset_t pending;
    struct sigaction now; /* what is ignored, as by nohup, interrupts nothing */
    bool any = false;
    sigpending(&pending);
    for (int i = 0; i < INTERRUPTS; i++)
        any = any || (sigismember(&pending, interrupts[i]) == 1 && sigismember(&c->signals, interrupts[i]) == 0 &&
                      sigaction(interrupts[i], NULL, &now) == 0 && now.sa_handler != SIG_IGN);
    return any;
}

/* On to our standard error; an interrupt need not wait until somebody reads it. Seconds in which nobody did. */
static double pass_on(const struct client *c, const char *bytes, size_t size)
{
    enum { SLICE = 100 }; /* ms */
    struct pollfd end = {2, POLLOUT, 0};
    double blocked = 0.0;
    while (size > 0 && !is_interrupted(c)) {
        const int ready = poll(&end, 1, SLICE);
        const ssize_t step = ready == 0 ? 0 : write(2, bytes, size < ANSWERS ? size : ANSWERS);
        if (step < 0)
            break;
        blocked += ready == 0 ? 1e-3 * SLICE : 0.0;
        bytes += step;
        size -= (size_t)step;
    }
    return blocked;
}

/* Standard error: on to ours, its last part kept as text. Seconds in which ours was not read. */
static double hear_errors(struct client *c)
{
    static char bytes[PIPEFUL];
    const ssize_t got = read(c->errors, bytes, sizeof bytes);
    if (got == 0 || (got < 0 && !is_passing(errno)))
        close_end(&c->errors);
    if (got <= 0)
        return 0.0;
    const double blocked = pass_on(c, bytes, (size_t)got);
    for (ssize_t i = 0; i < got; i++)
        bytes[i] = bytes[i] == '\0' ? '\1' : bytes[i]; /* which would end the text; neither is printable */
    const size_t size = (size_t)got > CLIENT_TAIL ? CLIENT_TAIL : (size_t)got;
    const size_t keep = c->tail_length + size > CLIENT_TAIL ? CLIENT_TAIL - size : c->tail_length;
    memmove(c->tail, c->tail + c->tail_length - keep, keep);
    memcpy(c->tail + keep, bytes + got - size, size);
    c->tail_length = keep + size;
    return blocked;
}

static double clock_seconds(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

static bool has_ended(const struct client *c)
{
    siginfo_t info = {0};
    return waitid(P_PID, (id_t)c->pid, &info, WEXITED | WNOHANG | WNOWAIT) == 0 && info.si_pid == c->pid;
}

/* Questions on their way: bytes begin ... end - 1 of the room. */
struct outgoing {
    char room[PIPEFUL];
    size_t begin, end;
};

/* Sends what the pipe takes; true when it took something. */
static bool send_questions(struct client *c, struct test_run *run, struct outgoing *o)
{
    if (o->begin == o->end) {
        o->begin = 0;
        o->end = test_run_ask(run, o->room, sizeof o->room);
    }
    ssize_t sent = o->begin < o->end ? write(c->to, o->room + o->begin, o->end - o->begin) : -1;
    if (sent > 0)
        o->begin += (size_t)sent;
    else if (o->begin == o->end || errno == EPIPE) /* all asked, or it listens no more */
        close_end(&c->to);
    else if (!is_passing(errno)) /* LCOV_EXCL_LINE: a failing system call, make faults */
        c->why = errno;         /* LCOV_EXCL_LINE: a failing system call, make faults */
    return sent > 0;
}

/* Takes what there is, and says whether there may be more; *enough when nobody wants to hear more of it, *answered when a line ended in it. */
static bool hear_answers(struct client *c, struct test_run *run, bool *enough, bool *answered)
{
    char bytes[ANSWERS];
    ssize_t got = read(c->from, bytes, sizeof bytes);
    if (got > 0) {
        *enough = !test_run_hear(run, bytes, (size_t)got);
        *answered = memchr(bytes, '\n', (size_t)got) != NULL;
    } else if (got == 0) {
        close_end(&c->from);
    } else if (!is_passing(errno)) { /* LCOV_EXCL_LINE: a failing system call, make faults */
        c->why = errno;              /* LCOV_EXCL_LINE: a failing system call, make faults */
    }
    return got > 0 || errno == EINTR; /* an end that is closed is heard no more */
}

enum ending client_converse(struct client *c, struct test_run *run, double timeout)
{
    struct outgoing o = {.begin = 0, .end = 0};
    struct progress progress = progress_begin(false);
    double moved = clock_seconds(); /* since when only the client could have done something, and did not */
    bool enough = false, ended = false, answered;
    while (!ended && clock_seconds() - moved < timeout && !enough && c->why == 0 && !is_interrupted(c)) {
        ended = has_ended(c); /* all that it has said is there, then */
        struct pollfd ends[] = {{c->to, POLLOUT, 0}, {c->from, POLLIN, 0}, {c->errors, POLLIN, 0}};
        const int slice = ended ? 0 : 10; /* ms until the next look for an interrupt or the end */
        bool taken = false;
        answered = false;
        if (poll(ends, 3, slice) < 0 && !is_passing(errno))
            c->why = errno; /* LCOV_EXCL_LINE: a failing system call, make faults */
        if (ends[0].revents != 0)
            taken = send_questions(c, run, &o);
        if (ends[1].revents != 0)
            hear_answers(c, run, &enough, &answered);
        if (ends[2].revents != 0)
            moved += hear_errors(c);
        if (taken || answered)
            moved = clock_seconds();
        progress_show(&progress, run->next, run->sets.total);
    }
    progress_end(&progress);
    while (c->from >= 0 && !enough && c->why == 0 && hear_answers(c, run, &enough, &answered)) /* which somebody else may hold open */
        ;
    return enough ? ENDING_STOPPED : ended ? ENDING_EXIT : ENDING_TIMEOUT;
}

int client_close(struct client *c)
{
    int status = 0;
    end_group();
    while (c->pid > 0 && waitpid(c->pid, &status, 0) < 0 && errno == EINTR)
        ;
    running = 0;
    close_end(&c->to);
    close_end(&c->from);
    close_end(&c->errors);
    c->pid = -1;
    sigprocmask(SIG_SETMASK, &c->signals, NULL);
    return status;
}
