/* `matvib show SCENARIO`: what a scenario comes to, as a scenario file. */
#include "cli/cli.h"
#include "cli/options.h"

#include <stdio.h>

int cli_show(int count, char **arguments, Status *status)
{
    Options options;
    Settings settings;
    if (!options_parse("show", count, arguments, &options, status) ||
        !options_words(&options, 1, 1, "SCENARIO", status) ||
        !options_load(&options, options.words[0], &settings, status) ||
        !scenario_write(stdout, &settings, NULL, status))
        return (int)status->code;
    return STATUS_DONE;
}
