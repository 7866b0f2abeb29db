#include "text/whole_file.h"

#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "text/message.h"

struct whole_file whole_file_open(const char *name)
{
    const size_t size = strlen(name) + 40;
    struct whole_file f = {.name = name};
    struct stat there;
    const bool exists = stat(name, &there) == 0, special = exists && !S_ISREG(there.st_mode) && !S_ISDIR(there.st_mode);
    const mode_t mode = exists && !special ? there.st_mode & 0666 : 0666; /* what nobody else may read stays so */
    int end = special ? open(name, O_WRONLY) : -1;
    if (!special)
        f.unfinished = xrealloc(NULL, size, 1);
    for (int k = 0; k < 100 && end < 0 && !special && (k == 0 || errno == EEXIST); k++) {
        snprintf(f.unfinished, size, k == 0 ? "%s.tmp" : "%s.%d.tmp", name, k);
        end = open(f.unfinished, O_WRONLY | O_CREAT | O_EXCL, mode);
    }
    f.why = end < 0 ? errno : 0;
    f.file = end < 0 ? NULL : fdopen(end, "w");
    if (end >= 0 && f.file == NULL) { /* LCOV_EXCL_BR_LINE: only where memory runs out, make faults */
        close(end);                  /* LCOV_EXCL_LINE: the same */
        remove(f.unfinished);        /* LCOV_EXCL_LINE: the same */
        f.why = ENOMEM;              /* LCOV_EXCL_LINE: the same */
    }
    return f;
}

int whole_file_close(struct whole_file *f, bool fine)
{
    errno = 0;
    if (f->file != NULL) {
        const bool written = !ferror(f->file) && fine;
        if (fclose(f->file) != 0 || !written || (f->unfinished != NULL && rename(f->unfinished, f->name) != 0)) {
            f->why = errno != 0 ? errno : EIO;
            if (f->unfinished != NULL)
                remove(f->unfinished);
        }
    }
    free(f->unfinished);
    return f->why;
}
