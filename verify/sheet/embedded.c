/* The text files are part of the program: it runs from any folder. */
#include "sheet/embedded.h"

#include <stdio.h>
#include <stdlib.h>

#include "sheet/sheet.h"

/* Global labels: aarch64's linker takes two local ones of a section for one place. */
__asm__(".section .rodata\n"
        ".globl ct_sheet_begin, ct_sheet_end, ct_derivations_begin, ct_derivations_end, ct_claims_begin, ct_claims_end\n"
        "ct_sheet_begin: .incbin \"" CT_SHEET_PATH "\"\n"
        "ct_sheet_end:\n"
        "ct_derivations_begin: .incbin \"" CT_DERIVATIONS_PATH "\"\n"
        "ct_derivations_end:\n"
        "ct_claims_begin: .incbin \"" CT_CLAIMS_PATH "\"\n"
        "ct_claims_end:\n"
        ".previous\n");

extern const char ct_sheet_begin[], ct_sheet_end[], ct_derivations_begin[], ct_derivations_end[], ct_claims_begin[], ct_claims_end[];

const char *embedded_sheet(size_t *length)
{
    /* cppcheck-suppress comparePointers ; the two labels bound one object */
    *length = (size_t)(ct_sheet_end - ct_sheet_begin);
    return ct_sheet_begin;
}

const char *embedded_derivations(size_t *length)
{
    /* cppcheck-suppress comparePointers ; the two labels bound one object */
    *length = (size_t)(ct_derivations_end - ct_derivations_begin);
    return ct_derivations_begin;
}

const char *embedded_claims(size_t *length)
{
    /* cppcheck-suppress comparePointers ; the two labels bound one object */
    *length = (size_t)(ct_claims_end - ct_claims_begin);
    return ct_claims_begin;
}

static struct sheet compiled_in; /* read when first asked for */

const struct sheet *sheet(void)
{
    struct message why;
    size_t length;
    const char *text = embedded_sheet(&length);
    if (compiled_in.sections == NULL &&
        sheet_read(&compiled_in, text, length, "paper/equations.yaml", &why) != 0) {
        fprintf(stderr, "coulomb-tether: %s\n", why.text); /* the build has checked the sheet */
        exit(1);
    }
    return &compiled_in;
}

void sheet_close(void)
{
    sheet_clear(&compiled_in);
}
