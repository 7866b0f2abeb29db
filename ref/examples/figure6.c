/*
 * figure6.c   Figure 6 of the paper: craft 1 in the nonlinear model over three days, as CSV
 *
 *     cc figure6.c $(pkg-config --cflags --libs coulombtether) && ./a.out >figure6.csv
 */
#include <coulombtether.h>

#include <stdio.h>

enum { TIMES = 2593 }; /* every 100 s, and the beginning */

int main(void)
{
    const struct ct_params p = CT_TABLE1;
    const struct ct_gains g = {ct_proportional_gain(p.Omega, 10), ct_derivative_gain(p.Omega, 10)};
    const struct ct_tether_state start = {.psi = 0.01, .theta = 0.01, .dL = 0.1};
    static struct ct_hill_state s[TIMES];
    double t[TIMES];

    for (int i = 0; i < TIMES; i++)
        t[i] = 100.0 * i;
    const int status = ct_nonlinear_flow(p, g, ct_hill_state_of_tether(p, start), 1e-13, TIMES, t, s);
    if (status != CT_OK) {
        fprintf(stderr, "figure6: %s\n", ct_status_string(status));
        return 1;
    }
    puts("t,x1,y1,z1");
    for (int i = 0; i < TIMES; i++)
        printf("%.0f,%.12e,%.12e,%.12e\n", t[i], s[i].x1, s[i].y1, s[i].z1);
    return 0;
}
