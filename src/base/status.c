#include "base/status.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

bool status_fail(Status *status, StatusCode code, const char *format, ...)
{
    if (!status)
        return false;
    va_list arguments;
    va_start(arguments, format);
    status->code = code;
    vsnprintf(status->text, sizeof status->text, format, arguments);
    va_end(arguments);
    return false;
}

bool status_prefix(Status *status, const char *format, ...)
{
    if (!status)
        return false;
    char text[sizeof status->text];
    memcpy(text, status->text, sizeof text);
    va_list arguments;
    va_start(arguments, format);
    int length = vsnprintf(status->text, sizeof status->text, format, arguments);
    va_end(arguments);
    if (length >= 0 && (size_t)length < sizeof status->text)
        snprintf(status->text + length, sizeof status->text - (size_t)length, ": %s", text);
    return false;
}
