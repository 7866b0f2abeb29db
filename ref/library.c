/*
 * library.c   the library itself: its version, and its statuses in words
 */
#include "coulombtether.h"

/*
 * Version   of the library in use, which may be another than the header's CT_VERSION
 *
 * Returns   MAJOR.MINOR.PATCH; the major one rises where a function or a structure changes
 */
const char *ct_version(void)
{
    return CT_VERSION;
}

/*
 * Status   in words
 *
 * Given     status   what a function of the library returned
 * Returns   a text without a line's end, also for what is no status
 */
const char *ct_status_string(int status)
{
    static const char *const texts[] = {
        [CT_OK] = "done",
        [CT_DOMAIN] = "an input lies outside the domain",
        [CT_MEMORY] = "no memory",
        [CT_CONVERGENCE] = "a root or a trajectory could not be followed to the accuracy asked for",
    };
    const size_t count = sizeof texts / sizeof *texts;

    return status >= 0 && (size_t)status < count ? texts[status] : "no status of this library";
}
