#include "give.h"

#include <stdarg.h>
#include <stdio.h>

void give(struct computed *c, bool proved, const arb_t x, const char *name, ...)
{
    char text[64];
    arb_t given;
    va_list arguments;
    va_start(arguments, name);
    vsnprintf(text, sizeof text, name, arguments);
    va_end(arguments);
    arb_init(given);
    if (proved)
        arb_set(given, x);
    else
        arb_indeterminate(given);
    give_number(c, text, given, CERTIFIED);
    arb_clear(given);
}
