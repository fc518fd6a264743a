/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Fills a Status (status.h): one line, with everything that could act on a terminal written out. */
#include "base/status.h"

#include "base/visible.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

static void fill(Status *status, StatusCode code, const char *format, va_list arguments)
{
    if (!status)
        return;
    status->code = code;
    visible_format(status->text, sizeof status->text, format, arguments);
}

bool status_refuse(Status *status, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    fill(status, STATUS_USAGE, format, arguments);
    va_end(arguments);
    return false;
}

bool status_fail(Status *status, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    fill(status, STATUS_FAILED, format, arguments);
    va_end(arguments);
    return false;
}

bool status_take(Status *status, const Status *why)
{
    if (status)
        *status = *why;
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
    const size_t length = visible_format(status->text, sizeof status->text, format, arguments);
    va_end(arguments);
    snprintf(status->text + length, sizeof status->text - length, ": %s", text);
    return false;
}
