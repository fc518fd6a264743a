/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The function of each command, made from the rows of the command table. */
#include "lab/commands/commands.h"

#define COMMAND(id, function, ...)        {COMMAND_##id, function, NULL, 0},
#define COMMAND_BY(id, function, by, ...) {COMMAND_##id, NULL, function, by},
#define DIGIT(n)

const CommandFunction command_functions[] = {
#include "help/command_rows.inc"
};

const int n_command_functions = sizeof command_functions / sizeof *command_functions;
