/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Where a key goes: to the open question, the field under edit, the help, or the table of commands. */
#include "lab/laboratory.h"

#include "base/visible.h"
#include "lab/session/session.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* --- help ------------------------------------------------------------------------------------------- */

static void scroll_help(Laboratory *lab, int lines)
{
    int most = help_most(&lab->screen, lab->width, lab->height);
    int to = lab->help.scroll + lines;
    lab->help.scroll = to < 0 ? 0 : to > most ? most : to;
    lab->help.found = 0;
}

static bool answer_search(Laboratory *lab, const char *text, Status *status)
{
    HelpShown *help = &lab->help;
    if (!*text)
        return true;
    snprintf(help->sought, sizeof help->sought, "%s", text);
    if (!help_search(&lab->screen, lab->width, text, help))
        return status_refuse(status, "the help does not have these words");
    const int most = help_most(&lab->screen, lab->width, lab->height);
    help->scroll = help->scroll < most ? help->scroll : most;
    return true;
}

static void help_command(Laboratory *lab, CommandId id)
{
    static const struct {
        CommandId id;
        int lines, screens, pages; /* so many of them on */
    } moves[] = {{COMMAND_UP, -1, 0, 0},       {COMMAND_DOWN, 1, 0, 0},          {COMMAND_PAGE_UP, 0, -1, 0},
                 {COMMAND_PAGE_DOWN, 0, 1, 0}, {COMMAND_RUN_PAUSE, 0, 1, 0}, /* Space, as in a pager */
                 {COMMAND_RIGHT, 0, 0, 1},     {COMMAND_NEXT_PANE, 0, 0, 1},     {COMMAND_HELP, 0, 0, 1},
                 {COMMAND_LEFT, 0, 0, -1},     {COMMAND_PREVIOUS_PANE, 0, 0, -1}};
    const int rows = lab->height > 6 ? lab->height - 5 : 1, pages = help_pages(&lab->screen);
    for (size_t i = 0; i < sizeof moves / sizeof *moves; i++)
        if (moves[i].id == id && moves[i].pages != 0) {
            lab->help.page = (lab->help.page + moves[i].pages + pages) % pages;
            lab->help.scroll = lab->help.found = 0;
        } else if (moves[i].id == id) {
            scroll_help(lab, moves[i].lines + moves[i].screens * rows);
        }
    if (id == COMMAND_FILTER)
        prompt_ask(lab, answer_search, &prompt_retyped, lab->help.sought, "search the help");
    else if (id == COMMAND_CANCEL || id == COMMAND_QUIT || id == COMMAND_ENTER)
        lab->help.open = false;
}

/* --- the mouse --------------------------------------------------------------------------------------- */

/* A key in the key line is pressed, a place of the timeline is gone to, a field is chosen (and, once
 * chosen, edited), a row of a table or of the log, a particle or a node is chosen, a pane takes the focus. */
static void click(Laboratory *lab, int x, int y)
{
    Screen *screen = &lab->screen;
    if (y == lab->height - 1) {
        CommandId id = screen_key_command(screen, lab->width, x);
        if (lab->help.open)
            help_command(lab, id);
        else if (id != COMMAND_NONE)
            laboratory_command(lab, id);
        return;
    }
    if (lab->help.open)
        return;
    const long step = screen_timeline_step(screen, lab->width, lab->height, x, y);
    if (step >= 0) {
        lab->held.drag = DRAG_TIME;
        player_go_to(lab, step);
        return;
    }
    for (int pane = 0; pane < PANE_COUNT; pane++)
        if (rect_holds(screen_pane(screen, lab->width, lab->height, (PaneId)pane), x, y) &&
            screen->panes.focus != (PaneId)pane) {
            screen->panes.focus = (PaneId)pane;
            screen->panes.followed = false;
            screen->time.cursor = NAN;
        }
    if (lesson_play_click(lab, x, y) || screen_click_view(screen, lab->width, lab->height, x, y))
        return;
    int row = screen_parameter_at(screen, lab->width, lab->height, x, y);
    if (row < 0)
        return;
    lab->held.drag = DRAG_VALUE;
    lab->held.drag_x = x;
    if (row == lab->parameters.selected)
        laboratory_command(lab, COMMAND_ENTER);
    else
        lab->parameters.selected = row;
}

/* A value gets smaller to the left and larger to the right; the time follows the mouse. */
static void drag(Laboratory *lab, int x)
{
    enum { CELLS_A_NUDGE = 2 };
    const int nudges = (x - lab->held.drag_x) / CELLS_A_NUDGE;
    if (lab->held.drag == DRAG_TIME) {
        player_seek(lab, screen_timeline_nearest(&lab->screen, lab->width, lab->height, x), 0);
    } else if (lab->held.drag == DRAG_VALUE && nudges != 0) {
        lab->parameters.edit.open = false; /* the press began a drag, not an edit */
        lab->held.drag_x += CELLS_A_NUDGE * nudges;
        for (int i = 0; i < abs(nudges); i++)
            row_edit_nudge(lab, nudges > 0 ? 1 : -1, false);
    }
}

/* False: not the mouse. In the middle of a field or a question the mouse does nothing. */
static bool mouse_key(Laboratory *lab, const Key *key)
{
    bool busy = lab->prompting.shown.open || lab->parameters.edit.open;
    const bool clicks = strcmp(key->name, "Click") == 0, drags = strcmp(key->name, "Drag") == 0;
    const bool turns = strncmp(key->name, "Wheel", 5) == 0;
    if (!drags)
        lab->held.drag = DRAG_NOTHING;
    if (!clicks && !drags && !turns)
        return false;
    if (lab->parameters.rows.placing) {
        row_edit_point(lab, turns ? -1 : key->x, key->y);
    } else if (drags) {
        drag(lab, key->x);
    } else if (clicks && !busy) {
        click(lab, key->x, key->y);
    } else if (!busy) {
        const int direction = key->name[5] == 'U' ? -1 : 1;
        enum { LINES = 3 };
        if (lab->help.open)
            scroll_help(lab, LINES * direction);
        else if (!screen_scroll_view(&lab->screen, lab->width, lab->height, key->x, key->y,
                                     LINES * direction))
            laboratory_command(lab, direction < 0 ? COMMAND_UP : COMMAND_DOWN);
    }
    return true;
}

static void text_key(Laboratory *lab, const char *name)
{
    Key key = {.x = -1, .y = -1};
    snprintf(key.name, sizeof key.name, "%s", name);
    if (lab->prompting.shown.open)
        prompt_key(lab, &key);
    else
        edit_key(lab, &key);
}

static void take_key(Laboratory *lab, const Key *key)
{
    const Command *command = command_by_key(key->name);
    const char *pasted = keys_pasted(key->name);
    player_drop_part(&lab->player);
    session_note(lab->recording, lab, (SessionEvent){.key = *key});
    laboratory_say(lab, MESSAGE_NONE, "%s", "");
    /* Pasted text goes into a field or a question, never means commands; the end of its line parts words. */
    const bool ends_line = pasted && strcmp(pasted, "Enter") == 0;
    if (pasted && !(lab->parameters.edit.open || (lab->prompting.shown.open && !lab->prompting.shown.yes_no)))
        laboratory_tell(lab, "pasted text goes into a field or a question only; : asks for a command");
    else {
        if (pasted && !ends_line && lab->held.pasted_line)
            text_key(lab, "Space");
        if (pasted && !ends_line)
            text_key(lab, pasted);
        lab->held.pasted_line = ends_line;
    }
    if (pasted)
        return;
    /* At a first start one key begins the first lesson; any other key does what it always does. */
    Status status = {STATUS_DONE, ""};
    const bool taken = lab->screen.offers_lesson && strcmp(key->name, "Enter") == 0;
    lab->screen.offers_lesson = false;
    if (taken && !lesson_play_open(lab, builtin_lessons[0].name, &status))
        laboratory_say(lab, MESSAGE_ERROR, "%s", status.text);
    if (taken)
        return;
    /* What was refused is read as a message: a key that does something else goes on, Enter and the keys of an
     * editor mend the answer. But a user who is asked for the name of a file, or by an exercise, types
     * another one. */
    const Prompt *prompt = &lab->prompting.shown;
    const Typing *typing = lab->prompting.typing;
    const char *name = key->name;
    const bool retyped =
        typing && typing->retyped && !(typing->leaves && !name[1] && strchr(typing->leaves, *name));
    if (prompt->open && !prompt->yes_no && prompt->problem[0] && !retyped && command &&
        (!name[1] || strcmp(name, "Space") == 0))
        prompt_close(&lab->prompting);
    /* These work in a question and in a field too. */
    if (command &&
        (command->id == COMMAND_INTERRUPT || command->id == COMMAND_REDRAW || command->id == COMMAND_SUSPEND))
        laboratory_command(lab, command->id);
    else if (mouse_key(lab, key) || (!lab->prompting.shown.open && row_edit_key(lab, key->name)))
        return;
    else if (lab->prompting.shown.open)
        prompt_key(lab, key);
    else if (lab->parameters.edit.open)
        edit_key(lab, key);
    else if (lab->help.open)
        help_command(lab, command ? command->id : COMMAND_NONE);
    else if (lesson_play_key(lab, key))
        return;
    else if (command)
        laboratory_command(lab, command->id);
    else if (strlen(key->name) == 1 && key->name[0] >= '1' && key->name[0] <= '9')
        laboratory_command(lab, command_of_digit(key->name[0] - '0')); /* says that no view has it */
    else if (strlen(key->name) == 1)
        laboratory_tell(lab, "the key %s has no function; ? lists the keys", key->name);
}

void laboratory_key(Laboratory *lab, const Key *key)
{
    if (!visible_is_clean(key->name))
        return; /* no text, and no session could keep it */
    if (lesson_entry_keeps(lab, key))
        return;
    lesson_entry_note(lab, key);
    take_key(lab, key);
    /* Who hands in what is missing half of it should know at once. */
    Status why = {STATUS_DONE, ""};
    if (lab->recording && session_is_lost(lab->recording, &why))
        laboratory_say(lab, MESSAGE_ERROR, "this session is kept no further: %s", why.text);
    lesson_play_continue(lab);
    lab->given_up = false;
}
