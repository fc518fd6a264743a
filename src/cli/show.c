/* SPDX-License-Identifier: GPL-3.0-or-later */
/* `matvib show SCENARIO`: what a scenario comes to, as a scenario file. */
#include "cli/cli.h"
#include "scenario/settings.h"
#include "cli/derived.h"
#include "cli/options.h"

#include <stdio.h>

int cli_show(int count, char **arguments, Status *status)
{
    Options options;
    Settings settings;
    char comment[DERIVED_TEXT_MAX];
    if (!options_parse("show", count, arguments, &options, status) ||
        !options_words(&options, 1, 1, "SCENARIO", status) ||
        !options_load(&options, options.words[0], &settings, status))
        return (int)status->code;
    if (!derived_text(&settings, comment, sizeof comment, status)) {
        options_blame(&options, options.words[0], status);
        return (int)status->code;
    }
    if (!scenario_write(stdout, &settings, comment, status))
        return (int)status->code;
    return STATUS_DONE;
}
