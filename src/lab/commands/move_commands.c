/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The commands that move: panes, rows, cursors, the inspector; Enter and Esc. */
#include "lab/commands/commands.h"
#include "lab/row_edit.h"
#include "views/inspector/inspector.h"
#include "views/view.h"
#include "panes/screen.h"
#include "views/plots/plots.h"

#include <math.h>
#include <string.h>

void command_pane(Laboratory *lab, int direction)
{
    Screen *screen = &lab->screen;
    Screen whole = *screen;
    whole.panes.zoomed = false; /* from a zoomed pane all panes can be reached */
    int focus = (int)screen->panes.focus;
    for (int i = 0; i < PANE_COUNT; i++) {
        focus = (focus + direction + PANE_COUNT) % PANE_COUNT;
        whole.panes.focus = (PaneId)focus; /* a small screen shows the pane that has the focus */
        if (screen_pane(&whole, lab->width, lab->height, (PaneId)focus).width > 0)
            break;
    }
    screen->panes.focus = (PaneId)focus;
    screen->panes.followed = false;
    screen->time.cursor = NAN;
}

/* Moves the cursor of a time plot by about a column. */
static void move_cursor(Laboratory *lab, int columns)
{
    Screen *screen = &lab->screen;
    double from, to;
    time_plot_window(screen, &from, &to);
    int width = screen_pane(screen, lab->width, lab->height, screen->panes.focus).width - 10;
    double column = (to - from) / (width > 20 ? width : 20);
    if (isnan(screen->time.cursor))
        screen->time.cursor = experiment_time(laboratory_run(lab));
    else
        screen->time.cursor += columns * column;
    if (screen->time.cursor < from)
        screen->time.cursor = from;
    if (screen->time.cursor > to)
        screen->time.cursor = to;
}

static void move(Laboratory *lab, int x, int y, int page)
{
    Screen *screen = &lab->screen;
    const View *view = screen_view_in(screen, screen->panes.focus);
    const bool map = command_map_is_focused(&lab->screen);
    if (screen->eye.open && map) {
        command_map_pan(&lab->screen, x, y);
        return;
    }
    if ((screen->panes.focus == PANE_INSPECTOR || map) && inspector_move(screen, x, y, page))
        return;
    if (screen->panes.focus == PANE_PARAMETERS && lab->play.shown.open) {
        lesson_play_move(lab, x, y);
    } else if (screen->panes.focus == PANE_PARAMETERS) {
        if (x)
            row_edit_nudge(lab, x, false);
        else
            edit_move(lab, y * page);
    } else if (view && view->is_list) {
        view_move(view, screen, screen_pane(screen, lab->width, lab->height, screen->panes.focus), x, y,
                  page);
    } else if (view && view->has_time_axis) {
        move_cursor(lab, x ? x : y * page);
    } else if (x || page > 1) {
        screen->chosen.is_node &= simulation_has(experiment_simulation(laboratory_run(lab)), HAS_MESH);
        selection_next(&screen->chosen, experiment_simulation(laboratory_run(lab)), x ? x : y, (size_t)page);
    } else {
        inspector_choose_across(screen, y < 0);
    }
}

void command_move_down(Laboratory *lab, int y)
{
    move(lab, 0, y, 1);
}

void command_move_right(Laboratory *lab, int x)
{
    move(lab, x, 0, 1);
}

void command_page(Laboratory *lab, int direction)
{
    if (!lesson_play_turn(lab, direction))
        move(lab, 0, direction, 10);
}

/* In the fields a smaller step than with the arrows; elsewhere the same. */
void command_move_finely(Laboratory *lab, int x)
{
    RowPlace place;
    if (lab->screen.panes.focus == PANE_PARAMETERS &&
        (edit_selected(&lab->screen) || (!lab->play.shown.open && screen_selected_row(&lab->screen, &place))))
        row_edit_nudge(lab, x, true);
    else
        move(lab, x, 0, 1);
}

/* Where the chosen row leads: to its step, or to what it has been over time. False: nowhere. */
static bool enter_row(Laboratory *lab, const View *view)
{
    char line[FOLLOW_TEXT_MAX + 8] = "plot ";
    const long step = view_enter(view, &lab->screen, line + strlen(line));
    if (step >= 0) {
        player_pause(lab);
        player_seek(lab, step, 0);
    } else if (lesson_entry_page(lab)) {
        return false;
    } else if (line[strlen("plot ")] && !lab->run_line(lab, line)) {
        laboratory_say(lab, MESSAGE_ERROR, "%s", lab->prompting.shown.problem);
        prompt_close(&lab->prompting);
    }
    return true;
}

void command_enter(Laboratory *lab)
{
    Screen *screen = &lab->screen;
    const bool inspects = screen->panes.focus == PANE_INSPECTOR && !lesson_entry_page(lab);
    const View *view = inspects ? &view_inspector : screen_view_in(screen, screen->panes.focus);
    if (screen->panes.focus == PANE_PARAMETERS && lab->play.shown.open) {
        lesson_play_enter(lab);
    } else if (screen->panes.focus == PANE_PARAMETERS) {
        edit_begin(lab);
        row_edit_begin(lab);
    } else if (view && view->has_time_axis && !isnan(screen->time.cursor)) {
        player_pause(lab);
        player_seek(lab, lround(screen->time.cursor / experiment_simulation(laboratory_run(lab))->dt), 0);
        screen->time.cursor = NAN;
    } else if (!(view && view->is_list && enter_row(lab, view)) && lesson_entry_page(lab)) {
        lesson_play_enter(lab);
    }
}

/* Whoever magnified a plot from the parameters is back there. */
void command_zoom_out(Screen *screen)
{
    PanesShown *panes = &screen->panes;
    if (panes->zoomed && panes->before_zoom == PANE_PARAMETERS && panes->focus == panes->last_plot)
        panes->focus = PANE_PARAMETERS;
    panes->zoomed = false;
}

void command_close_inspector(Screen *screen)
{
    screen->panes.inspecting = false;
    screen->panes.zoomed = false;
    if (screen->panes.focus == PANE_INSPECTOR)
        screen->panes.focus = screen->panes.before_inspector;
}

void command_inspect(Laboratory *lab)
{
    Screen *screen = &lab->screen;
    if (screen->panes.inspecting) {
        command_close_inspector(&lab->screen);
    } else if (!inspector_find(screen)) {
        laboratory_say(lab, MESSAGE_INFO, "there is no inspector for this method");
    } else {
        screen->panes.inspecting = true;
        screen->panes.before_inspector = screen->panes.focus;
        screen->panes.focus = PANE_INSPECTOR;
        screen->time.cursor = NAN;
    }
}

/* Closes what lies on top; false: there is nothing. */
bool command_close_top(Laboratory *lab)
{
    Screen *screen = &lab->screen;
    if (lab->help.open)
        lab->help.open = false;
    else if (lab->prompting.shown.open)
        prompt_close(&lab->prompting);
    else if (lab->parameters.edit.open)
        lab->parameters.edit.open = false;
    else if (!isnan(screen->time.cursor))
        screen->time.cursor = NAN;
    else if (screen->eye.open)
        command_map_whole(&lab->screen);
    else if (screen->panes.zoomed)
        command_zoom_out(screen);
    else if (screen->panes.inspecting)
        command_close_inspector(&lab->screen);
    else if (lab->parameters.filter[0])
        lab->parameters.filter[0] = '\0';
    else
        return false;
    return true;
}

void command_cancel(Laboratory *lab)
{
    if (!lesson_entry_cancel(lab) && !refining_stop(lab))
        command_close_top(lab);
}
