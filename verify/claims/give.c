#include "claims/give.h"

#include <stdarg.h>
#include <stdio.h>

#include "text/scope.h"

static void give_named(struct computed *c, enum how how, bool proved, const arb_t x, const char *name, va_list arguments)
{
    char text[64];
    SCOPE(arb, given);
    vsnprintf(text, sizeof text, name, arguments);
    arb_indeterminate(given);
    if (proved)
        arb_set(given, x);
    give_number(c, text, given, how);
}

void give(struct computed *c, bool proved, const arb_t x, const char *name, ...)
{
    va_list arguments;
    va_start(arguments, name);
    give_named(c, CERTIFIED, proved, x, name, arguments);
    va_end(arguments);
}

void give_measured(struct computed *c, bool found, const arb_t x, const char *name, ...)
{
    va_list arguments;
    va_start(arguments, name);
    give_named(c, MEASURED, found, x, name, arguments);
    va_end(arguments);
}
