/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Whether work that cannot be cut into frames is to go on; a file of its own, for whatever works so needs it,
 * and frames need all of that. */
#include "lab/laboratory.h"
#include "lab/session/session.h"

#include <stdarg.h>
#include <stdio.h>

bool laboratory_go_on(Laboratory *lab)
{
    if (lab->given_up || lab->host.go_on(lab->host.context))
        return !lab->given_up;
    lab->given_up = true;
    if (lab->recording)
        session_note_stop(lab->recording, lab);
    return false;
}

bool laboratory_work(Laboratory *lab, const char *format, ...)
{
    const Message before = lab->message;
    const double said_at = lab->said_at;
    char text[sizeof before.text];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    laboratory_tell(lab, "%s", text);
    const bool goes_on = laboratory_go_on(lab);
    lab->message = before;
    lab->said_at = said_at;
    return goes_on;
}
