/* The sheets, and the golden vectors of motions, are part of the program: it runs from any folder. */
#include "sheet/paper.h"

/* Global labels: aarch64's linker takes two local ones of a section for one place. */
__asm__(".section .rodata\n"
        ".globl ct_sheet_begin, ct_sheet_end, ct_derivations_begin, ct_derivations_end, ct_claims_begin, ct_claims_end\n"
        ".globl ct_motions_begin, ct_motions_end\n"
        "ct_sheet_begin: .incbin \"" CT_SHEET_PATH "\"\n"
        "ct_sheet_end:\n"
        "ct_derivations_begin: .incbin \"" CT_DERIVATIONS_PATH "\"\n"
        "ct_derivations_end:\n"
        "ct_claims_begin: .incbin \"" CT_CLAIMS_PATH "\"\n"
        "ct_claims_end:\n"
        "ct_motions_begin: .incbin \"" CT_GOLDEN_PATH "/flow_linear.csv\"\n.incbin \"" CT_GOLDEN_PATH "/flow_nonlinear.csv\"\n"
        ".incbin \"" CT_GOLDEN_PATH "/rk4_linear.csv\"\n.incbin \"" CT_GOLDEN_PATH "/rk4_nonlinear.csv\"\n"
        "ct_motions_end: .byte 0\n"
        ".previous\n");

extern const char ct_sheet_begin[], ct_sheet_end[], ct_derivations_begin[], ct_derivations_end[], ct_claims_begin[], ct_claims_end[];
extern const char ct_motions_begin[], ct_motions_end[];

struct sources embedded_sources(void)
{
    return (struct sources){
        /* cppcheck-suppress comparePointers ; the two labels bound one object */
        {"paper/equations.yaml", ct_sheet_begin, (size_t)(ct_sheet_end - ct_sheet_begin)},
        /* cppcheck-suppress comparePointers ; the two labels bound one object */
        {"paper/derivations.yaml", ct_derivations_begin, (size_t)(ct_derivations_end - ct_derivations_begin)},
        /* cppcheck-suppress comparePointers ; the two labels bound one object */
        {"paper/claims.yaml", ct_claims_begin, (size_t)(ct_claims_end - ct_claims_begin)},
        /* cppcheck-suppress comparePointers ; the two labels bound one object */
        {CT_GOLDEN_PATH, ct_motions_begin, (size_t)(ct_motions_end - ct_motions_begin)},
    };
}
