/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Every command of the laboratory, made from its rows. */
#include "help/command.h"

#define COMMAND(id, function, ...) {COMMAND_##id, __VA_ARGS__},
#define DIGIT(n)                   {COMMAND_VIEW_##n, "view-" #n, #n, "Views", NULL, NULL, BY_LESSON},

const Command commands[] = {
#include "help/command_rows.inc"
};

const int n_commands = sizeof commands / sizeof *commands;
