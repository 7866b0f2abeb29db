/* coulomb-tether verify errors: how wrong ref/ is on random inputs, against certified truth. */
#include "command/command_verify.h"

#include <math.h>
#include <stdio.h>

#include "command/command.h"
#include "evaluate/errors.h"
#include "evaluate/reference.h"
#include "text/decimal.h"
#include "text/json.h"

enum { SEED = 1, PASS = 8 }; /* E beyond 8 is no rounding of a formula of the sheet: see the oracle's rule */

bool verify_errors(struct verification *v)
{
    const struct sheet *sheet = v->sheet;
    const long inputs = v->count;
    struct json *j = v->json;
    bool fine = true;
    if (j != NULL)
        json_open(j, "errors", '[');
    else
        printf("%-10s %8s %10s  %s\n", "operation", "inputs", "E <=", "MPFR value in the enclosure");
    for (int i = 0; i < sheet->section_count; i++) {
        const struct section *s = &sheet->sections[i];
        struct measured m;
        char text[32];
        if (!operation_has_sensitivity(s))
            continue;
        if (reference_find(s->id) == NULL) {
            usage_error(EXIT_FAILED_CHECK, "verify errors: no '%s' in verify/evaluate/reference.c", s->id);
            fine = false;
            continue;
        }
        measure_errors(&m, s, inputs, SEED);
        decimal_bound(text, m.worst); /* the same wherever libm rounds a little differently */
        fine = fine && m.worst <= PASS && m.outside == 0;
        if (j != NULL) {
            json_open(j, NULL, '{');
            json_string(j, "id", s->id);
            json_value(j, "inputs", "%ld", inputs);
            json_value(j, "worst_E", isfinite(m.worst) ? "%s" : "\"%s\"", text); /* JSON has no number for inf */
            json_value(j, "vector", "\"%s-%d-%ld\"", s->id, SEED, m.index);
            json_value(j, "outside", "%ld", m.outside);
            json_close(j);
            json_line(j, 1);
        } else
            printf("%-10s %8ld %10s  %s\n", s->id, inputs, text,
                   s->method != METHOD_FORMULA ? "-" : m.outside == 0 ? "always" : "NO");
    }
    if (j != NULL) {
        json_line(j, -1);
        json_close(j);
    } else
        printf("\nE = |y - y*| / (2^-53 (|y*| + S)), S = sum |x dy/dx| over the inputs x: the error in roundings of result and inputs,\n"
               "its largest of all outputs of the reference library on the inputs, rounded up; at most %d passes. In the enclosure:\n"
               "whether the sheet's formula in MPFR lies in the ball that the error is measured from; - of roots, which no formula gives.\n",
               PASS);
    return fine;
}
