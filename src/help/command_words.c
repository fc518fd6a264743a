/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What is said of a command: the words of a digit are those of the view that has it. */
#include "help/command.h"
#include "views/view.h"

const char *command_brief(const Command *command)
{
    const View *view = view_of_digit(command_digit(command->id));
    return view ? view->brief : command->brief;
}

const char *command_help(const Command *command)
{
    const View *view = view_of_digit(command_digit(command->id));
    return view ? view->help : command->help;
}
