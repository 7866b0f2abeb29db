/*
 * three_craft.c   three charged craft by (2), without plasma: a day, and what their motion has to keep
 *
 * The field keeps of the orbit's whole the integral sum m_i (v_i^2 - 3 Omega^2 x_i^2 + Omega^2 z_i^2)/2 + sum k_c q_i q_j/d_ij.
 */
#include <coulombtether.h>

#include <math.h>
#include <stdio.h>

enum { CRAFT = 3, TIMES = 25 };

static double integral(double Omega, double k_c, const struct ct_craft c[CRAFT])
{
    double sum = 0;

    for (int i = 0; i < CRAFT; i++) {
        const struct ct_vector r = c[i].position, v = c[i].velocity;
        sum += c[i].m / 2 * (v.x * v.x + v.y * v.y + v.z * v.z + Omega * Omega * (r.z * r.z - 3 * r.x * r.x));
        for (int j = 0; j < i; j++)
            sum += k_c * c[i].q * c[j].q / ct_distance(r, c[j].position);
    }
    return sum;
}

int main(void)
{
    const struct ct_params p = CT_TABLE1;
    const struct ct_craft start[CRAFT] = {
        {.m = 150, .q = 1e-6, .position = {.x = 20}},
        {.m = 150, .q = 1e-6, .position = {.x = -20}},
        {.m = 100, .q = -2e-6, .position = {.z = 5}},
    };
    static struct ct_craft c[TIMES][CRAFT];
    double t[TIMES];

    for (int i = 0; i < TIMES; i++)
        t[i] = 3600.0 * i;
    const int status = ct_formation_flow(p.Omega, p.k_c, INFINITY, CRAFT, start, 1e-12, TIMES, t, c[0]);
    if (status != CT_OK) {
        fprintf(stderr, "three_craft: %s\n", ct_status_string(status));
        return 1;
    }
    puts("t,d12,d13,d23,integral");
    for (int i = 0; i < TIMES; i++)
        printf("%.0f,%.9e,%.9e,%.9e,%.12e\n", t[i], ct_distance(c[i][0].position, c[i][1].position),
               ct_distance(c[i][0].position, c[i][2].position), ct_distance(c[i][1].position, c[i][2].position),
               integral(p.Omega, p.k_c, c[i]));
    return 0;
}
