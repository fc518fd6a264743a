/* What each command does: one function each, found by its id. */
#include "tui/control/commands/commands.h"
#include "tui/control/prompt/scenario_prompt.h"
#include "tui/control/prompt/line.h"
#include "tui/control/writing.h"
#include "tui/control/second_run.h"

#include <string.h>

typedef void (*Carry)(Laboratory *);

/* --- files, help, leaving --------------------------------------------------------------------------- */

static void export_run_as_files(Laboratory *lab)
{
    exporting_ask(lab, "");
}

static void filter(Laboratory *lab)
{
    if (lab->screen.inspecting)
        command_close_inspector(&lab->screen);
    lab->screen.focus = PANE_PARAMETERS;
    prompt_ask(&lab->prompting, edit_answer_filter, false, lab->screen.filter, "parameters whose name holds");
}

static void help(Laboratory *lab)
{
    lab->screen.help = true;
    lab->screen.help_page = lab->screen.help_scroll = 0;
}

static bool answer_quit(Laboratory *lab, const char *text)
{
    (void)text;
    lab->closed = true;
    return true;
}

static bool quit_key(Laboratory *lab, const char *key)
{
    if (strcmp(key, "q") != 0 && strcmp(key, "F10") != 0)
        return false;
    prompt_refuse(&lab->prompting,
                  "y leaves, n stays"); /* neither is certain, and what follows should be no commands */
    return true;
}

static const Typing quit_typing = {.key = quit_key};

static void quit(Laboratory *lab)
{
    if (command_close_top(lab))
        return;
    if (!lab->editing.changed) {
        lab->closed = true;
        return;
    }
    prompt_ask(&lab->prompting, answer_quit, true, "",
               "parameters were changed and nothing was exported: leave?");
    lab->prompting.typing = &quit_typing;
}

static void interrupt(Laboratory *lab)
{
    if (lab->screen.state == STATE_COMPUTING) {
        duel_cancel(&lab->player.duel);
        player_pause(lab);
        laboratory_say(lab, MESSAGE_INFO, "cancelled");
    } else if (lab->screen.prompt.open && lab->prompting.answer == answer_quit)
        lab->closed = true; /* whoever presses it twice means it */
    else if (!command_close_top(lab))
        quit(lab);
}

static void redraw(Laboratory *lab)
{
    lab->host.redraw(lab->host.context);
}

static void suspend(Laboratory *lab)
{
    if (lab->asker != ASKER_REPLAY) /* it is no part of what is shown again */
        lab->host.suspend(lab->host.context);
}

static const Carry carries[COMMAND_COUNT] = {
    [COMMAND_RUN_PAUSE] = command_run_or_pause,
    [COMMAND_STEP_FORWARD] = command_step_forward,
    [COMMAND_STEP_BACK] = command_step_back,
    [COMMAND_STEP_FORWARD_TEN] = command_step_forward_ten,
    [COMMAND_STEP_BACK_TEN] = command_step_back_ten,
    [COMMAND_STAGE_FORWARD] = command_stage_forward,
    [COMMAND_STAGE_BACK] = command_stage_back,
    [COMMAND_FASTER] = command_faster,
    [COMMAND_SLOWER] = command_slower,
    [COMMAND_START] = command_to_start,
    [COMMAND_NEWEST] = command_to_newest,
    [COMMAND_GO_TO] = command_go_to,
    [COMMAND_RESTART] = command_restart,
    [COMMAND_NEXT_PANE] = command_next_pane,
    [COMMAND_PREVIOUS_PANE] = command_previous_pane,
    [COMMAND_UP] = command_up,
    [COMMAND_DOWN] = command_down,
    [COMMAND_LEFT] = command_left,
    [COMMAND_RIGHT] = command_right,
    [COMMAND_PAGE_UP] = command_page_up,
    [COMMAND_PAGE_DOWN] = command_page_down,
    [COMMAND_ENTER] = command_enter,
    [COMMAND_CANCEL] = command_cancel,
    [COMMAND_UNDO] = command_undo,
    [COMMAND_REDO] = command_redo,
    [COMMAND_INSPECT] = command_inspect,
    [COMMAND_ZOOM] = command_zoom,
    [COMMAND_ZOOM_2D] = command_map_zoom,
    [COMMAND_NARROWER] = command_narrower,
    [COMMAND_WIDER] = command_wider,
    [COMMAND_AUTOMATIC] = command_automatic,
    [COMMAND_REFERENCES] = command_cycle_references,
    [COMMAND_QUESTION] = command_question,
    [COMMAND_PIN] = command_pin,
    [COMMAND_DUEL] = second_run_toggle,
    [COMMAND_BOOKMARK] = command_bookmark,
    [COMMAND_JUMP] = command_jump,
    [COMMAND_LESSONS] = lesson_play_toggle,
    [COMMAND_EXPORT] = export_run_as_files,
    [COMMAND_OPEN] = scenario_prompt_ask,
    [COMMAND_WRITE] = writing_ask,
    [COMMAND_LINE] = line_ask,
    [COMMAND_HELP] = help,
    [COMMAND_GLYPHS] = command_cycle_glyphs,
    [COMMAND_LECTURE] = command_lecture,
    [COMMAND_FILTER] = filter,
    [COMMAND_QUIT] = quit,
    [COMMAND_INTERRUPT] = interrupt,
    [COMMAND_REDRAW] = redraw,
    [COMMAND_SUSPEND] = suspend,
};

bool laboratory_can(CommandId id)
{
    return command_digit(id) > 0 || (id > COMMAND_NONE && id < COMMAND_COUNT && carries[id]);
}

void laboratory_command(Laboratory *lab, CommandId id)
{
    if (!laboratory_can(id))
        return;
    lab->screen.used |= (uint64_t)1 << id;
    lab->play.used |= (uint64_t)1 << id;
    if (command_digit(id) > 0)
        command_show_digit(lab, command_digit(id));
    else
        carries[id](lab);
}
