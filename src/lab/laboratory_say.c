/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Messages in the key line. They may hold names of files and scenarios: what would act on the terminal is
 * written out. */
#include "lab/laboratory.h"

#include "base/visible.h"

#include <stdarg.h>
#include <stdio.h>

static void put(Laboratory *lab, MessageKind kind, const char *format, va_list arguments)
{
    char text[sizeof lab->message.text];
    vsnprintf(text, sizeof text, format, arguments);
    visible_text(lab->message.text, sizeof lab->message.text, text);
    lab->message.kind = lab->message.text[0] ? kind : MESSAGE_NONE;
    lab->said_at = lab->host.now(lab->host.context);
}

void laboratory_say(Laboratory *lab, MessageKind kind, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    put(lab, kind, format, arguments);
    va_end(arguments);
}

void laboratory_tell(Laboratory *lab, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    put(lab, MESSAGE_INFO, format, arguments);
    va_end(arguments);
}
