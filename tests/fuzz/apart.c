/*
 * What does not take place while the program runs as a function: the linker puts __wrap_X in the place of X (--wrap).
 * It keeps off files (between apart_begin() and apart_end()) and processes, and out of work that is long by its nature.
 */
#include <errno.h>
#include <stdio.h>
#include <string.h>

#include "command/command.h"
#include "conform/client.h"
#include "evaluate/errors.h"
#include "motion/flow.h"
#include "claims/verdicts.h"
#include "proof/derivation.h"
#include "targets.h"

/* NOLINTBEGIN(bugprone-reserved-identifier): names that the linker asks for */
FILE *__real_fopen(const char *name, const char *mode);
bool __real_vectors_random(const struct section *s, uint64_t seed, uint64_t first, uint64_t count);
enum flow_status __real_flow_linear(struct flow_request *r);

static bool apart;
static const char *file_bytes;
static size_t file_size;

void apart_begin(const char *bytes, size_t size)
{
    apart = true;
    file_bytes = bytes;
    file_size = size;
}

void apart_end(void)
{
    apart = false;
}

int __wrap_client_start(struct client *c, char *const *arguments)
{
    (void)c;
    (void)arguments;
    return ENOENT;
}

/* libFuzzer keeps an input that fails while the program runs: in binary, as the program writes nothing. */
FILE *__wrap_fopen(const char *name, const char *mode)
{
    if (!apart || strcmp(mode, "wb") == 0)
        return __real_fopen(name, mode);
    if (*mode == 'w')
        return __real_fopen("/dev/null", "w");
    errno = ENOENT;
    return file_bytes != NULL ? fmemopen((void *)file_bytes, file_size, "r") : NULL;
}

/* What would be renamed goes: a report's unfinished files would otherwise stay, until no name is left for one. */
int __wrap_rename(const char *from, const char *to)
{
    (void)remove(from);
    (void)to;
    return 0;
}

int __real_paper_open(struct paper *p, const struct sources *s, struct message *why);

/* The sheets are the same for any input: read once, and kept. */
int __wrap_paper_open(struct paper *p, const struct sources *s, struct message *why)
{
    static struct paper opened;
    if (opened.sheet.sections == NULL && __real_paper_open(&opened, s, why) != 0)
        return -1;
    *p = opened;
    return 0;
}

void __wrap_paper_close(struct paper *p)
{
    (void)p;
}

void __wrap_flint_cleanup(void) {}

bool __wrap_verdict_rows(const struct derivations *p, struct statements *claims, const char *only, verdict_receiver *receive,
                         void *context)
{
    (void)p;
    (void)claims;
    (void)only;
    (void)receive;
    (void)context;
    return true;
}

/* The steps are the program's own, and so is what binds them: two thousand proofs, the same for any input. */
bool __wrap_step_is_bound(const struct derivations *d, struct step *s)
{
    (void)d;
    return step_holds(s);
}

void __wrap_measure_errors(struct measured *m, const struct section *s, long count, uint64_t seed)
{
    (void)count;
    (void)seed;
    *m = (struct measured){.section = s};
}

bool __wrap_kills_print(const struct section *s, double digits)
{
    (void)s;
    (void)digits;
    return true;
}

int __wrap_command_study(const struct arguments *a)
{
    (void)a;
    return 0;
}

bool __wrap_vectors_random(const struct section *s, uint64_t seed, uint64_t first, uint64_t count)
{
    return __real_vectors_random(s, seed, first, count < 3 ? count : 3);
}

/* Where the gains are irrational: three hundred rows of Figure 4, of up to 10,000 digits. */
bool __wrap_roots41_gains(acb_ptr roots, const arb_t c1, const arb_t c2, slong prec)
{
    (void)roots;
    (void)c1;
    (void)c2;
    (void)prec;
    return false;
}

/* Motions of a few rows and steps alone. */
enum flow_status __wrap_flow_linear(struct flow_request *r)
{
    return r->count > 10 || r->prec > 10000 ? FLOW_STALLED : __real_flow_linear(r);
}

enum flow_status __wrap_flow_nonlinear(struct flow_request *r)
{
    r->reached = 0.0;
    return FLOW_STALLED;
}

enum flow_status __wrap_rk4(struct flow_request *r)
{
    r->reached = 0.0;
    return FLOW_STALLED;
}
/* NOLINTEND(bugprone-reserved-identifier) */
