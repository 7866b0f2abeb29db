#include "claims.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

void evidence_add(struct evidence *e, const char *format, ...)
{
    size_t length = strlen(e->text);
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(e->text + length, sizeof e->text - length, format, arguments);
    va_end(arguments);
}

void evidence_decide(struct evidence *e, enum verdict verdict, enum how how, bool proved)
{
    e->verdict = proved ? verdict : VERDICT_NONE;
    e->how = how;
}
