/* Computations on the charges that carry the law (18) out. Units: see basin.h. */
#include "basin.h"
#include "claim.h"

/* From rest at half of L_ref with the charge product that (18) commands, of either sign. */
static void half_length(struct computed *c)
{
    static const char *const names[GAINS][2] = {{"returns_10", "escapes_10"}, {"returns_12", "escapes_12"}};
    for (int i = 0; i < GAINS; i++) {
        struct basin b;
        basin_init(&b, basin_gains[i]);
        const enum release release = basin_release(&b, -50);
        for (int k = 0; k < 2; k++) {
            const enum release named = k == 0 ? RELEASE_RETURNS : RELEASE_ESCAPES;
            const enum truth found = release == RELEASE_OPEN ? UNDECIDED : release == named ? FOUND_TRUE : FOUND_FALSE;
            give_truth(c, names[i][k], found, CERTIFIED);
        }
        basin_clear(&b);
    }
}

const struct computation computations_charges[] = {
    {"half_length", half_length, "", "returns_10 escapes_10 returns_12 escapes_12"},
    {NULL, NULL, NULL, NULL},
};
