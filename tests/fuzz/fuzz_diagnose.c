/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Any bytes as the table of somebody's own code: refused in one line, or each row belongs to a step and a
 * thing that the run has. */
#include "fuzz/fuzz.h"
#include "scenario/settings.h"

#include "answers/diagnose/diagnose.h"
#include "scenario/scenario.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    static DiagnoseTable table;
    static Settings settings;
    Status status = {STATUS_DONE, ""};
    if (size == 0)
        return 0;
    FUZZ_ASSERT(scenario_load_with("mode1", NULL, 0, &settings, &status));
    FILE *file = fmemopen((void *)(uintptr_t)data, size, "r");
    FUZZ_ASSERT(file);
    const bool sound = diagnose_read_from(&table, file, "input", &settings, NULL, &status);
    rewind(file);
    if (!sound) /* nobody asks why */
        FUZZ_ASSERT(!diagnose_read_from(&table, file, "input", &settings, NULL, NULL));
    fclose(file);
    FUZZ_ASSERT(sound || (status.text[0] && !strchr(status.text, '\n')));
    size_t rows = 0;
    for (size_t m = 0; sound && m < table.n_moments; m++) {
        const DiagnoseMoment *moment = &table.moments[m];
        FUZZ_ASSERT(moment->step >= 0 && moment->count > 0 && moment->first == rows);
        FUZZ_ASSERT(m == 0 || moment->step > moment[-1].step ||
                    (moment->step == moment[-1].step && moment->stage > moment[-1].stage));
        rows += moment->count;
    }
    FUZZ_ASSERT(!sound || (rows > 0 && rows <= table.file.count && table.as.n_columns > 0));
    if (sound)
        diagnose_close(&table);
    return 0;
}
