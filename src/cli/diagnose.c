/* SPDX-License-Identifier: GPL-3.0-or-later */
/* `matvib diagnose SCENARIO FILE...`: which mistake, scheme or value made the numbers of somebody's own code.
 */
#include "answers/diagnose.h"
#include "base/output.h"
#include "base/text.h"
#include "cli/cli.h"
#include "cli/distinct.h"
#include "cli/options.h"
#include "cli/progress.h"
#include "scenario/settings.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static bool one_file(const Options *options, const Settings *settings, const char *path, Progress *progress,
                     Status *status)
{
    DiagnoseTable *table = calloc(1, sizeof *table);
    Diagnosis *found = calloc(1, sizeof *found);
    const DiagnoseTask task = {.settings = settings,
                               .threads = progress_threads(options->threads),
                               .pairs = options->pairs,
                               .patience = {progress_show, progress}};
    const bool sound = ((table && found) || status_fail(status, STATUS_FAILED, "out of memory")) &&
                       diagnose_read(table, path, settings, options->map, status) &&
                       diagnose(&task, table, found, status);
    progress_end(progress);
    if (sound)
        diagnosis_tell(found, table, stdout);
    if (table)
        diagnose_close(table);
    free(table);
    free(found);
    return sound;
}

int cli_diagnose(int count, char **arguments, Status *status)
{
    Options options;
    Settings settings;
    if (!options_parse("diagnose", count, arguments, &options, status) ||
        !options_words(&options, 2, WORDS_MAX, "SCENARIO FILE", status) ||
        !options_load(&options, options.words[0], &settings, status))
        return (int)status->code;
    Progress progress;
    progress_begin(&progress, options.quiet);
    bool sound = true;
    for (int i = 1; i < options.n_words && sound; i++)
        sound = one_file(&options, &settings, options.words[i], &progress, status);
    if (!sound && progress_signal())
        return 128 + progress_signal();
    return sound ? STATUS_DONE : (int)status->code;
}
