/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Messages in the key line, and whether work that is not cut into frames, which reports how far it is, goes
 * on. A message may hold names of files and scenarios: what would act on the terminal is written out. */
#include "lab/laboratory.h"

#include "base/visible.h"
#include "lab/session/session.h"

#include <stdarg.h>
#include <stdio.h>

static void put(Laboratory *lab, MessageKind kind, const char *format, va_list arguments)
{
    visible_format(lab->message.text, sizeof lab->message.text, format, arguments);
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

bool laboratory_go_on(Laboratory *lab)
{
    if (lab->given_up || lab->host.go_on(lab->host.context))
        return !lab->given_up;
    lab->given_up = true;
    session_note(lab->recording, lab, (SessionEvent){.is_stop = true, .key = {.x = -1}});
    return false;
}

bool laboratory_work(Laboratory *lab, const char *format, ...)
{
    const Message before = lab->message;
    const double said_at = lab->said_at;
    va_list arguments;
    va_start(arguments, format);
    put(lab, MESSAGE_INFO, format, arguments);
    va_end(arguments);
    const bool goes_on = laboratory_go_on(lab);
    lab->message = before;
    lab->said_at = said_at;
    return goes_on;
}
