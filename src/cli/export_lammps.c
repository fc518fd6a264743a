/* SPDX-License-Identifier: GPL-3.0-or-later */
/* `matvib export-lammps SCENARIO --output DIR`: a beam or a plate as input for LAMMPS. */
#include "cli/cli.h"
#include "scenario/settings.h"
#include "cli/options.h"
#include "cli/progress.h"
#include "export/lammps.h"

#include <stdio.h>

int cli_export_lammps(int count, char **arguments, Status *status)
{
    Options options;
    Settings settings;
    if (!options_parse("export-lammps", count, arguments, &options, status) ||
        !options_words(&options, 1, 1, "SCENARIO", status))
        return (int)status->code;
    if (!options.output) {
        status_refuse(status, "--output: is missing (a folder)");
        return (int)status->code;
    }
    if (!options_load(&options, options.words[0], &settings, status))
        return (int)status->code;
    Progress progress;
    progress_begin(&progress, false);
    settings.patience = (Patience){progress_show, &progress};
    const bool done = lammps_export(&settings, ASKER_COMMAND_LINE, options.output, options.force, status);
    progress_end(&progress);
    if (!done)
        return progress_signal() != 0 ? 128 + progress_signal() : (int)status->code;
    printf("wrote %s; run it with: cd %s && lmp -in in.matvib\n", options.output, options.output);
    return STATUS_DONE;
}
