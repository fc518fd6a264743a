/* Any bytes as the file of a session: refused in one line, or read. */
#include "fuzz/fuzz.h"

#include "tui/control/session/session.h"

#include <stdio.h>
#include <string.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    Status status = {STATUS_DONE, ""};
    if (size == 0)
        return 0;
    FILE *file = fmemopen((void *)(uintptr_t)data, size, "r");
    FUZZ_ASSERT(file);
    Session *session = session_read_stream(file, "input", &status);
    FUZZ_ASSERT(session || (status.code != STATUS_DONE && status.text[0] && !strchr(status.text, '\n')));
    for (const SessionEvent *event = session ? session_next(session) : NULL; event; event = NULL)
        FUZZ_ASSERT(event->step >= 0 && event->seconds >= 0);
    session_free(session);
    fclose(file);
    return 0;
}
