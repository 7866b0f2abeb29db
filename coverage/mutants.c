/*
 * mutants.c   in every program of the tree that mutants.py makes: which mutant it is, what of it was reached, and how far it may go
 */
#define _GNU_SOURCE
#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <unistd.h>

#include "sheet/paper.h"

enum { MOST_FUNCTIONS = 8192, MOST_BYTES = 1 << 22 };

static unsigned char nowhere[MOST_FUNCTIONS];
unsigned char *mutant_reached_ = nowhere;
int mutant_; /* none: the program as it is */

__attribute__((constructor)) static void begin(void)
{
    const char *mutant = getenv("MUTANT"), *seconds = getenv("MUTANT_SECONDS"), *reached = getenv("MUTANT_REACHED");
    if (mutant != NULL)
        mutant_ = atoi(mutant);
    if (seconds != NULL) {
        const rlim_t most = (rlim_t)atoi(seconds);
        setrlimit(RLIMIT_CPU, &(struct rlimit){most, most + 2});
        setrlimit(RLIMIT_AS, &(struct rlimit){3u << 30, 3u << 30});
        setrlimit(RLIMIT_CORE, &(struct rlimit){0, 0});
    }
    if (reached != NULL) { /* shared: what dies or forks leaves its traces too */
        const int file = open(reached, O_RDWR | O_CLOEXEC);
        void *shared = mmap(NULL, MOST_FUNCTIONS, PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
        if (shared != MAP_FAILED)
            mutant_reached_ = shared;
        close(file);
    }
}

/* The first assertion that fails decides. */
void __wrap__ck_assert_failed(const char *file, int line, const char *expression, const char *message, ...)
{
    fprintf(stderr, "%s:%d: %s %s\n", file, line, expression, message != NULL ? message : "");
    _exit(1);
}

/* A mutant that lost the process it asks for would end all of the user's: it is noticed by that. */
int __real_kill(pid_t, int);
int __wrap_kill(pid_t process, int signal)
{
    if (process >= -1 && process <= 1)
        _exit(99);
    return __real_kill(process, signal);
}

static struct source read_sheet(const char *folder, struct source right)
{
    static char text[3][MOST_BYTES];
    static int sheets;
    char path[4096];
    snprintf(path, sizeof path, "%s/%s", folder, right.name);
    FILE *file = fopen(path, "r");
    if (file == NULL)
        return right;
    char *to = text[sheets++ % 3];
    const size_t length = fread(to, 1, MOST_BYTES, file);
    fclose(file);
    return (struct source){right.name, to, length};
}

/* The sheets of the folder that the environment names, instead of those that were compiled in. */
__attribute__((weak)) struct sources __real_embedded_sources(void); /* not every program has sheets */
struct sources __wrap_embedded_sources(void)
{
    const struct sources right = __real_embedded_sources();
    const char *folder = getenv("MUTANT_SHEETS");
    if (folder == NULL)
        return right;
    return (struct sources){read_sheet(folder, right.equations), read_sheet(folder, right.derivations), read_sheet(folder, right.claims), right.motions};
}
