/* Every input that the fuzzers keep, once through its target; the last name in the log is the one that failed. */
#include "tests/run.h"

#include <glob.h>
#include <stdio.h>

#include "tests/fuzz/targets.h"

enum { LARGEST = 1 << 17 };

EACH(inputs_are_survived, TARGETS)
{
    static char bytes[LARGEST];
    char pattern[100];
    glob_t files;
    snprintf(pattern, sizeof pattern, "tests/fuzz/corpus/%s/*", targets[_i].name);
    ck_assert_int_eq(glob(pattern, 0, NULL, &files), 0);
    for (size_t i = 0; i < files.gl_pathc; i++) {
        fprintf(stderr, "%s\n", files.gl_pathv[i]);
        FILE *file = fopen(files.gl_pathv[i], "rb");
        ck_assert_ptr_nonnull(file);
        const size_t size = fread(bytes, 1, LARGEST, file);
        fclose(file);
        targets[_i].run(bytes, size);
    }
    globfree(&files);
}
