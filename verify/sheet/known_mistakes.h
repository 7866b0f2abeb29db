/* An operation as one known mistake would have it: a program like the sheet's own, over the same inputs. */
#ifndef CT_KNOWN_MISTAKES_H
#define CT_KNOWN_MISTAKES_H

#include "sheet/sheet.h"

struct mutation {
    const struct section *section; /* what is computed in the end                                */
    bool formulas_end;             /* ... by these formulas, else by its method from their values */
    struct formulas formulas;
};

/*
 * False where the mistake cannot be made in this section: it changes nothing there, or needs a name that
 * the section does not have. A section's own mistake (`strict`) has to use all its names; `why` says what
 * is wrong with it. Clear it only after true.
 */
bool mutation_init(struct mutation *a, const struct sheet *sheet, const struct section *s,
                   const struct known_mistake *m, bool strict, struct message *why);
void mutation_clear(struct mutation *a);

#endif
