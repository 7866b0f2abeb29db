#include "sheet/paper.h"

int paper_open(struct paper *p, const struct sources *s, struct message *why)
{
    *p = (struct paper){.derivations = s->derivations, .claims = s->claims, .motions = s->motions};
    return sheet_read(&p->sheet, s->equations.text, s->equations.length, s->equations.name, why);
}

void paper_close(struct paper *p)
{
    sheet_clear(&p->sheet);
}
