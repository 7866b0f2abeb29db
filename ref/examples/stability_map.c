/*
 * stability_map.c   where the gains make the linear model stable: yaw and length, by the roots of (41)
 *
 * A row is a C2, in units of Omega, a column a C1, in units of Omega^2; # is stable by the roots, o by the conditions (42)
 * alone. No o is printed: the conditions are necessary and sufficient.
 */
#include <coulombtether.h>

#include <stdio.h>

int main(void)
{
    const struct ct_params p = CT_TABLE1;

    for (int row = 6; row >= -2; row--) {
        printf("%5.1f  ", row / 2.0);
        for (int column = 0; column <= 60; column++) {
            const struct ct_gains g = {column / 4.0 * p.Omega * p.Omega, row / 2.0 * p.Omega};
            struct ct_root root[4];
            const int status = ct_characteristic_roots(p.Omega, g, root);
            if (status != CT_OK) {
                fprintf(stderr, "stability_map: %s\n", ct_status_string(status));
                return 1;
            }
            const int decays = root[3].re < 0; /* the last of ascending ones */
            putchar(decays ? '#' : ct_routh_margins(p.Omega, g).stable ? 'o' : '.');
        }
        putchar('\n');
    }
    puts("C2/Omega, above C1/Omega^2 from 0 to 15 in quarters");
    return 0;
}
