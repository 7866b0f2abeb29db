/* coulomb-tether figure: the data of the paper's figures as CSV, every digit proved. */
#include "command/command_motion.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "text/decimal.h"
#include "text/scope.h"

/* Of each conjugate pair the root above the axis, the slower pair first: its place among the four. Isolated roots
   are two such pairs, of which a real one has both on the axis. */
static void pairs(int place[2], acb_srcptr roots)
{
    int count = 0, real = 0;
    for (int k = 3; k >= 0; k--) { /* they ascend */
        const bool on_axis = arb_is_zero(acb_imagref(roots + k));
        if (arb_is_negative(acb_imagref(roots + k)) || (on_axis && real++ % 2 == 1))
            continue;
        place[count++] = k;
    }
    if (arb_equal(acb_realref(roots + place[0]), acb_realref(roots + place[1])) &&
        arb_gt(acb_imagref(roots + place[0]), acb_imagref(roots + place[1]))) {
        int first = place[0]; /* equal real parts: the slower oscillation first */
        place[0] = place[1];
        place[1] = first;
    }
}

/* Figure 4: the characteristic roots against n. A row: re1 im1 re2 im2. */
static int print_roots(const char *name, const struct scenario *s, slong digits)
{
    bool decided = false;
    VECTOR(acb, roots, 4);
    for (slong prec = 4 * digits + 64; !decided && prec < 64 * digits + 4096; prec *= 2) {
        char *texts[4] = {NULL};
        int place[2];
        decided = scenario_roots(roots, s, prec);
        if (decided)
            pairs(place, roots);
        for (int i = 0; i < 4 && decided; i++) {
            acb_srcptr root = roots + place[i / 2];
            texts[i] = decimal_of_ball(i % 2 ? acb_imagref(root) : acb_realref(root), digits);
            decided = texts[i] != NULL;
        }
        if (decided)
            printf("%s,%s,%s,%s,%s\n", name, texts[0], texts[1], texts[2], texts[3]);
        for (int i = 0; i < 4; i++)
            free(texts[i]);
    }
    return decided ? EXIT_DONE : usage_error(EXIT_FAILED_CHECK, "figure 4: undecided at n = %s", name);
}

/* n from 9 to 40 in tenths. */
static int print_figure4(struct scenario *s, slong digits)
{
    int status = EXIT_DONE;
    puts("n,re1,im1,re2,im2");
    for (int tenths = 90; tenths <= 400 && status == EXIT_DONE; tenths++) {
        char decimal[16], name[32];
        snprintf(decimal, sizeof decimal, "%d.%d", tenths / 10, tenths % 10);
        literal_read(&s->value[SET_n].value, decimal, s->exact);
        decimal_shortest(name, tenths / 10.0);
        status = print_roots(name, s, digits);
    }
    return status;
}

int command_figure(const struct arguments *a)
{
    if (strcmp(a->words[0], "4") != 0)
        return command_trajectory(a);
    OWNED(scenario) s;
    scenario_init(&s, &a->paper->sheet, option_given(a, "--exact"));
    struct assignment Omega = {.name = "Omega", .value = &s.value[SET_Omega]};
    int status = take_names(a, &Omega, 1);
    if (status == EXIT_DONE)
        status = take_values(&Omega, 1, s.exact);
    if (status == EXIT_DONE)
        status = check_scenario(&s, false);
    return status == EXIT_DONE ? print_figure4(&s, (slong)option_number(a, "--digits")) : status;
}
