/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Any bytes as the file of a session: refused in one line, or read. */
#include "fuzz/fuzz.h"

#include "lab/session/session.h"

#include <stdio.h>
#include <string.h>

static Session *read_bytes(const uint8_t *data, size_t size, Status *status)
{
    FILE *file = fmemopen((void *)(uintptr_t)data, size, "r");
    FUZZ_ASSERT(file);
    Session *session = session_read_stream(file, "input", status);
    fclose(file);
    return session;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    Status status = {STATUS_DONE, ""};
    if (size == 0)
        return 0;
    Session *session = read_bytes(data, size, &status);
    FUZZ_ASSERT(session || (status.code != STATUS_DONE && status.text[0] && !strchr(status.text, '\n')));
    for (size_t i = 0; session && session_event(session, i); i++)
        FUZZ_ASSERT(session_event(session, i)->step >= 0 && session_event(session, i)->seconds >= 0);
    session_free(session);
    session_free(read_bytes(data, size, NULL)); /* nobody wants to know why */
    return 0;
}
