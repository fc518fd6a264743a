/* SPDX-License-Identifier: GPL-3.0-or-later */
/* `matvib show SCENARIO`: what a scenario comes to, as a scenario file. */
#include "cli/cli.h"
#include "scenario/settings.h"
#include "cli/derived.h"
#include "cli/options.h"
#include "cli/progress.h"

#include <stdio.h>

int cli_show(Options *options, Status *status)
{
    Settings settings;
    char comment[DERIVED_TEXT_MAX];
    if (!options_load(options, options->words[0], &settings, status))
        return (int)status->code;
    if (!derived_text(&settings, comment, sizeof comment, status)) {
        options_blame(options, options->words[0], status);
        return (int)status->code;
    }
    return progress_result(scenario_write(stdout, &settings, comment, status), status);
}
