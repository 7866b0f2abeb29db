/*
 * client.c   ref/, the reference library, as a client of the oracle
 *
 *     cc -I. -Iref -Iverify -o client tests/clients/client.c verify/evaluate/reference.c build/libcoulombtether.a $(pkg-config --libs gsl) -lm
 *     coulomb-tether conform -- ./client
 */
#include "tests/clients/answer.h"

int main(void)
{
    char line[LONGEST];
    while (fgets(line, sizeof line, stdin) != NULL) {
        struct asked a;
        understand(&a, line);
        compute(&a);
        say(&a, "\n");
    }
    return ferror(stdin) || fflush(stdout);
}
