/* SPDX-License-Identifier: GPL-3.0-or-later */
/* `matvib export-lammps SCENARIO --output DIR`: a beam or a plate as input for LAMMPS. */
#include "cli/cli.h"
#include "scenario/settings.h"
#include "cli/options.h"
#include "cli/progress.h"
#include "export/lammps.h"

#include <stdio.h>

int cli_export_lammps(Options *options, Status *status)
{
    Settings settings;
    if (!options->output)
        return progress_result(status_refuse(status, "--output: is missing (a folder)"), status);
    if (!options_load(options, options->words[0], &settings, status))
        return (int)status->code;
    Progress progress;
    progress_begin(&progress, false);
    settings.patience = (Patience){progress_show, &progress};
    const bool done = lammps_export(&settings, ASKER_COMMAND_LINE, options->output, options->force, status);
    progress_end(&progress);
    if (done)
        printf("wrote %s; run it with: cd %s && lmp -in in.matvib\n", options->output, options->output);
    return progress_result(done, status);
}
