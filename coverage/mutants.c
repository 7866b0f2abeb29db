/*
 * mutants.c   in every program that mutants.py makes: which mutant it is, what of it was reached, and the sheets that it reads
 */
#include <fcntl.h>
#include <stdlib.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include "sheet/paper.h"

enum { MOST_MUTANTS = 1 << 17 };

int mutant_; /* 0: the program as it is */
static unsigned char nowhere[MOST_MUTANTS];
unsigned char *mutant_reached_ = nowhere;

static void *mapped(const char *name, size_t length, int protection)
{
    const int file = open(name, protection == PROT_READ ? O_RDONLY : O_RDWR);
    void *bytes = mmap(NULL, length, protection, MAP_SHARED, file, 0); /* so that what dies or forks leaves its traces too */
    close(file);
    return bytes;
}

__attribute__((constructor)) static void begin(void)
{
    const char *mutant = getenv("MUTANT"), *reached = getenv("MUTANT_REACHED");
    mutant_ = mutant != NULL ? atoi(mutant) : 0;
    if (reached != NULL)
        mutant_reached_ = mapped(reached, MOST_MUTANTS, PROT_READ | PROT_WRITE);
}

/* The first assertion that fails decides. */
void __wrap__ck_assert_failed(void)
{
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

/* The sheets of the folder that a program runs in, instead of those that were compiled in. Not every program has some. */
__attribute__((weak)) struct sources __real_embedded_sources(void);
struct sources __wrap_embedded_sources(void)
{
    static struct sources s;
    struct source *const sheets[] = {&s.equations, &s.derivations, &s.claims};
    struct stat file;
    if (s.equations.text != NULL) /* mapped once */
        return s;
    s = __real_embedded_sources();
    for (int i = 0; i < 3; i++)
        if (stat(sheets[i]->name, &file) == 0)
            *sheets[i] = (struct source){sheets[i]->name, mapped(sheets[i]->name, (size_t)file.st_size, PROT_READ), (size_t)file.st_size};
    return s;
}
