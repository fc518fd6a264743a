/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Fills a Status (status.h): one line, with everything that could act on a terminal written out. */
#include "base/status.h"

#include "base/visible.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

bool status_fail(Status *status, StatusCode code, const char *format, ...)
{
    if (!status)
        return false;
    char text[sizeof status->text];
    va_list arguments;
    va_start(arguments, format);
    status->code = code;
    vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    visible_text(status->text, sizeof status->text, text);
    return false;
}

bool status_prefix(Status *status, const char *format, ...)
{
    if (!status)
        return false;
    char text[sizeof status->text], prefix[sizeof status->text];
    memcpy(text, status->text, sizeof text);
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(prefix, sizeof prefix, format, arguments);
    va_end(arguments);
    const size_t length = visible_text(status->text, sizeof status->text, prefix);
    snprintf(status->text + length, sizeof status->text - length, ": %s", text);
    return false;
}
