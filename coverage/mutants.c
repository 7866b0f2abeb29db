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

/* So that what dies or forks leaves its traces, too. */
static void *mapped(const char *name, int opened, int protection, size_t *length)
{
    const int file = open(name, opened);
    struct stat about;
    if (fstat(file, &about) != 0)
        return NULL;
    *length = (size_t)about.st_size;
    void *bytes = mmap(NULL, *length, protection, MAP_SHARED, file, 0);
    close(file);
    return bytes;
}

__attribute__((constructor)) static void begin(void)
{
    const char *mutant = getenv("MUTANT"), *reached = getenv("MUTANT_REACHED");
    size_t length;
    mutant_ = mutant != NULL ? atoi(mutant) : 0;
    if (reached != NULL)
        mutant_reached_ = mapped(reached, O_RDWR, PROT_READ | PROT_WRITE, &length);
}

/* The sheets of the folder that a program runs in, instead of those that were compiled in. Not every program has some. */
__attribute__((weak)) struct sources __real_embedded_sources(void);
struct sources __wrap_embedded_sources(void)
{
    static struct sources s;
    struct source *const sheets[] = {&s.equations, &s.derivations, &s.claims};
    if (s.equations.text != NULL) /* mapped once */
        return s;
    s = __real_embedded_sources();
    for (int i = 0; i < 3; i++) {
        size_t length;
        const char *text = mapped(sheets[i]->name, O_RDONLY, PROT_READ, &length);
        if (text != NULL)
            *sheets[i] = (struct source){sheets[i]->name, text, length};
    }
    return s;
}
