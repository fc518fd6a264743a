/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Carrying out a command: the function of its row, or for a digit the view that has it. */
#include "lab/commands/commands.h"

static const CommandFunction *function_of(CommandId id)
{
    for (int i = 0; i < n_command_functions; i++)
        if (command_functions[i].id == id)
            return &command_functions[i];
    return NULL;
}

bool laboratory_can(CommandId id)
{
    return command_digit(id) > 0 || function_of(id);
}

void laboratory_command(Laboratory *lab, CommandId id)
{
    const CommandFunction *function = function_of(id);
    if (!laboratory_can(id))
        return;
    command_set_add(&lab->used, id);
    command_set_add(&lab->play.used, id);
    if (command_digit(id) > 0)
        command_show_digit(lab, command_digit(id));
    else if (function->run)
        function->run(lab);
    else
        function->run_by(lab, function->by);
}
