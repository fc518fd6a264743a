/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The commands of the program itself: export, filter, help, leaving. */
#include "lab/commands/commands.h"

#include <string.h>

void command_export(Laboratory *lab)
{
    exporting_ask(lab, "", NULL);
}

void command_filter(Laboratory *lab)
{
    if (lab->play.shown.open && !lab->play.shown.lesson) {
        lesson_play_search(lab);
        return;
    }
    if (lab->screen.panes.inspecting)
        command_close_inspector(&lab->screen);
    lab->screen.panes.focus = PANE_PARAMETERS;
    prompt_ask(lab, edit_answer_filter, NULL, lab->parameters.filter, "parameters whose name contains");
}

void command_help_pages(Laboratory *lab)
{
    lab->help.open = true;
    lab->help.page = lab->help.scroll = lab->help.found = 0;
}

static bool answer_quit(Laboratory *lab, const char *text, Status *status)
{
    (void)text;
    (void)status;
    lab->closed = true;
    return true;
}

static bool quit_key(Laboratory *lab, const char *key)
{
    if (strcmp(key, "q") != 0 && strcmp(key, "F10") != 0)
        return false;
    /* Enter or Esc does not answer, and the keys behind it must not become commands */
    strcpy(lab->prompting.shown.problem, "y leaves, n stays");
    return true;
}

static const Typing quit_typing = {.yes_no = true, .key = quit_key};

void command_quit(Laboratory *lab)
{
    if (command_close_top(lab))
        return;
    if (!lab->editing.changed || lab->play.shown.lesson) {
        lab->closed = true;
        return;
    }
    prompt_ask(lab, answer_quit, &quit_typing, "",
               "parameters were changed and nothing was exported: leave?");
}

void command_interrupt(Laboratory *lab)
{
    if (lesson_entry_cancel(lab))
        laboratory_tell(lab, "cancelled");
    else if (lab->prompting.shown.open && lab->prompting.answer == answer_quit)
        lab->closed = true; /* pressed twice it needs no answer */
    else if (!refining_stop(lab) && !command_close_top(lab))
        command_quit(lab);
}

void command_redraw(Laboratory *lab)
{
    if (lab->host.redraw)
        lab->host.redraw(lab->host.context);
}

void command_suspend(Laboratory *lab)
{
    if (lab->host.suspend && lab->asker != ASKER_REPLAY) /* a replay does not suspend the program */
        lab->host.suspend(lab->host.context);
}
