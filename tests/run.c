/*
 * run.c   runs one suite; Check itself reads the name of the TAP log from CK_TAP_LOG_FILE_NAME
 */
#include "run.h"

#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_FLAT_INPUTS = 32 };

static bool outside(char domain, double x)
{
    if (isnan(x) || isinf(x))
        return domain != 'i' || x != INFINITY;
    return domain != 'r' && (x < 0 || (x == 0 && domain != '0'));
}

void assert_rejects_outside(flat_function *f, const char *domain, const double inside[])
{
    const double wrong[] = {NAN, INFINITY, -INFINITY, -1, 0, -0.0};
    const size_t inputs = strlen(domain);
    double x[MOST_FLAT_INPUTS], y[MOST_FLAT_OUTPUTS];

    ck_assert_uint_le(inputs, MOST_FLAT_INPUTS);
    memcpy(x, inside, inputs * sizeof x[0]);
    for (size_t k = f(x, y); k-- > 0;)
        ck_assert_msg(isfinite(y[k]), "output %zu is %g inside the domain", k, y[k]);

    for (size_t i = 0; i < inputs; i++) {
        for (size_t w = 0; w < sizeof wrong / sizeof wrong[0]; w++) {
            if (!outside(domain[i], wrong[w]))
                continue;
            x[i] = wrong[w];
            for (size_t k = f(x, y); k-- > 0;)
                ck_assert_msg(isnan(y[k]), "output %zu is %g where input %zu is %g", k, y[k], i, wrong[w]);
        }
        x[i] = inside[i];
    }
}

int main(void)
{
    SRunner *runner = srunner_create(suite());

    srunner_run_all(runner, CK_NORMAL);
    const int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed ? EXIT_FAILURE : EXIT_SUCCESS;
}
