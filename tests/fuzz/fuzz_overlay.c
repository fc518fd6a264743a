/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Any bytes as a foreign series: refused in one line, or a table whose numbers are where they should be. */
#include "fuzz/fuzz.h"

#include "run/overlay.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    Overlay overlay;
    Status status = {STATUS_DONE, ""};
    if (size == 0)
        return 0;
    FILE *file = fmemopen((void *)(uintptr_t)data, size, "r");
    FUZZ_ASSERT(file);
    bool sound = overlay_read(&overlay, file, "input", NULL, NULL, NULL, &status);
    rewind(file);
    if (!sound) /* nobody asks why */
        FUZZ_ASSERT(!overlay_read(&overlay, file, "input", NULL, NULL, NULL, NULL));
    fclose(file);
    FUZZ_ASSERT(sound || (status.text[0] && !strchr(status.text, '\n')));
    if (sound && overlay_choose(&overlay, NULL, NULL, "v_cm", "u", &status)) {
        const double *x = overlay.columns[overlay.x].values;
        for (size_t i = 0; i < overlay.count; i++)
            FUZZ_ASSERT(isfinite(x[i]) && (i == 0 || x[i] >= x[i - 1]));
        FUZZ_ASSERT(overlay_find(&overlay, INFINITY) == (overlay.count > 0 ? overlay.count - 1 : 0));
    }
    if (sound)
        overlay_close(&overlay);
    return 0;
}
