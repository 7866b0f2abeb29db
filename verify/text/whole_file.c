#define _XOPEN_SOURCE 700 /* NOLINT(bugprone-reserved-identifier): realpath() */
#include "text/whole_file.h"

#include <errno.h>
#include <fcntl.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "text/message.h"

/* Whether that is standard output, if one can write there: whatever its name */
static bool is_standard_output(const struct stat *there)
{
    struct stat out;
    return (fcntl(STDOUT_FILENO, F_GETFL) & O_ACCMODE) != O_RDONLY && fstat(STDOUT_FILENO, &out) == 0 &&
           out.st_dev == there->st_dev && out.st_ino == there->st_ino;
}

int stream_error(FILE *file)
{
    const bool failed = ferror(file) != 0;
    bool fine = fflush(file) == 0;
    if (fine && failed) /* some write before, whose errno is gone: another one says it */
        fine = fputc('\n', file) != EOF && fflush(file) == 0;
    return !fine ? errno : failed ? EIO : 0;
}

struct whole_file whole_file_open(const char *name)
{
    struct whole_file f = {.file = NULL};
    struct stat there;
    const bool exists = stat(name, &there) == 0, special = exists && !S_ISREG(there.st_mode) && !S_ISDIR(there.st_mode);
    const mode_t mode = exists && !special ? there.st_mode & 0666 : 0666; /* what nobody else may read stays so */
    int end = -1;
    if (exists && is_standard_output(&there)) {
        end = dup(STDOUT_FILENO);
    } else if (special) {
        end = open(name, O_WRONLY);
    } else if (exists || errno == ENOENT) { /* not where links lead nowhere else than to links */
        f.name = realpath(name, NULL);
        if (f.name == NULL) /* nothing yet, or a link to nothing, whose place it takes */
            f.name = text_copy(name);
        const size_t size = strlen(f.name) + 40;
        f.unfinished = xrealloc(NULL, size, 1);
        for (int k = 0; k < 100 && end < 0 && (k == 0 || errno == EEXIST); k++) {
            snprintf(f.unfinished, size, k == 0 ? "%s.tmp" : "%s.%d.tmp", f.name, k);
            end = open(f.unfinished, O_WRONLY | O_CREAT | O_EXCL, mode);
        }
    }
    f.why = end < 0 ? errno : 0;
    f.file = end < 0 ? NULL : fdopen(end, "w");
    if (end >= 0 && f.file == NULL) { /* LCOV_EXCL_BR_LINE: only where memory runs out, make faults */
        close(end);                  /* LCOV_EXCL_LINE: the same */
        f.why = ENOMEM;              /* LCOV_EXCL_LINE: the same */
        if (f.unfinished != NULL)    /* LCOV_EXCL_LINE: the same */
            remove(f.unfinished);    /* LCOV_EXCL_LINE: the same */
    }
    return f;
}

int whole_file_close(struct whole_file *f, int why)
{
    if (f->file != NULL) {
        f->why = why != 0 ? why : stream_error(f->file);
        const bool closed = fclose(f->file) == 0;
        if (f->why == 0 && (!closed || (f->unfinished != NULL && rename(f->unfinished, f->name) != 0)))
            f->why = errno;
        if (f->why != 0 && f->unfinished != NULL)
            remove(f->unfinished);
    }
    free(f->unfinished);
    free(f->name);
    return f->why;
}
