/* Computations on the charges that carry the law (18) out. Units: see well.h. */
#include "claim.h"
#include "well.h"

/* From rest at half of L_ref with the charge product that (18) commands, of either sign. */
static void half_length(struct computed *c)
{
    static const char *const names[GAINS][2] = {{"returns_10", "escapes_10"}, {"returns_12", "escapes_12"}};
    for (int i = 0; i < GAINS; i++) {
        struct well w;
        well_init(&w, well_gains[i]);
        const enum fate fate = well_fate(&w, -50);
        for (int k = 0; k < 2; k++) {
            const enum truth found = fate == FATE_OPEN                                     ? UNDECIDED
                                     : (fate == FATE_RETURNS) == (k == 0) ? FOUND_TRUE
                                                                                           : FOUND_FALSE;
            give_truth(c, names[i][k], found, CERTIFIED);
        }
        well_clear(&w);
    }
}

const struct computation computations_charges[] = {
    {"half_length", half_length, "", "returns_10 escapes_10 returns_12 escapes_12"},
    {NULL, NULL, NULL, NULL},
};
