/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The commands that move: panes, rows, cursors, the inspector; Enter and Esc. */
#include "scenario/concern_body.h"
#include "scenario/concern_output.h"
#include "base/text.h"
#include "views/view.h"
#include "lab/commands/commands.h"
#include "views/inspector/inspector.h"
#include "views/plots/plots.h"

#include <stdio.h>
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

static void move(Laboratory *lab, int x, int y, int page)
{
    const double share = 0.2; /* of what is seen of a map, for an arrow */
    Screen *screen = &lab->screen;
    const View *view = screen_view_in(screen, screen->panes.focus);
    const bool map = command_map_is_focused(&lab->screen);
    if (screen->eye.open && map) {
        const Settings *settings = laboratory_settings(lab);
        const double stride = share / screen->eye.magnified;
        screen->eye.centre[0] = fmin(fmax(screen->eye.centre[0] + x * stride, 0), 1);
        /* a pane is not as high as it is wide */
        const double upwards = fmin(0.25, stride * settings_geometry(settings)->length /
                                              settings_geometry(settings)->height / 2);
        screen->eye.centre[1] = fmin(fmax(screen->eye.centre[1] - y * upwards, 0), 1);
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
        /* the cursor of a time plot, by about a column */
        double from, to;
        time_plot_window(screen, &from, &to);
        const int width = screen_pane(screen, lab->width, lab->height, screen->panes.focus).width - 10;
        const double column = (to - from) / (width > 20 ? width : 20);
        if (isnan(screen->time.cursor))
            screen->time.cursor = experiment_time(laboratory_run(lab));
        else
            screen->time.cursor += (x ? x : y * page) * column;
        screen->time.cursor = fmin(fmax(screen->time.cursor, from), to);
    } else if (x || page > 1) {
        screen->chosen.is_node &= simulation_has(laboratory_simulation(lab), HAS_MESH);
        selection_next(&screen->chosen, laboratory_simulation(lab), x ? x : y, (size_t)page);
    } else if (simulation_has(laboratory_simulation(lab), HAS_MESH)) {
        /* from the particle to the node that it shares most with, or back: the strip has the grid above */
        inspector_move(screen, 0, y < 0 ? -1 : 1, 1);
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
    Status status = {STATUS_DONE, ""};
    const long step = view_enter(view, &lab->screen, line + strlen(line));
    if (step >= 0) {
        player_go_to(lab, step);
    } else if (lesson_entry_page(lab)) {
        return false;
    } else if (line[strlen("plot ")] && !lab->run_line(lab, line, &status)) {
        laboratory_say(lab, MESSAGE_ERROR, "%s", status.text);
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
        const Record *record = experiment_record(laboratory_run(lab)); /* the row that is read there */
        player_go_to(lab, (long)record_row(record, record_find(record, screen->time.cursor))[0]);
        screen->time.cursor = NAN;
    } else if (!(view && view->is_list && enter_row(lab, view)) && lesson_entry_page(lab)) {
        lesson_play_enter(lab);
    }
}

/* A plot that was magnified from the parameters gives the focus back to them. */
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
        laboratory_tell(lab, "there is no inspector for this method");
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

/* The commands of the map of a beam: magnify, move, draw displacements larger or smaller. */

#define FIRST_MAGNIFIED 4.0
#define MOST_MAGNIFIED  1024.0

/* The crack's tip is what there is to see of a beam that cracks; else the chosen node. */
static void look_at_something(Screen *screen)
{
    const Settings *settings = screen_settings(screen);
    const double *row = experiment_row(screen->experiment);
    const int x = experiment_column(screen->experiment, "crack_x"),
              y = experiment_column(screen->experiment, "crack_y");
    if (x >= 0 && y >= 0 && row) {
        screen->eye.centre[0] = row[x] / settings_geometry(settings)->length;
        screen->eye.centre[1] = row[y] / settings_geometry(settings)->height;
    } else {
        /* The place of a node as shares of the beam's length and height. */
        const Simulation *simulation = screen_simulation(screen);
        const size_t nx = simulation->columns, ny = simulation->rows;
        screen->eye.centre[0] = ((double)(screen->chosen.particle % nx) + 0.5) / (double)nx;
        screen->eye.centre[1] = ((double)(screen->chosen.particle / nx) + 0.5) / (double)ny;
    }
}

void command_map_whole(Screen *screen)
{
    screen->eye.open = false;
    screen->eye.magnified = 1;
}

void command_map_magnify(Screen *screen, int direction)
{
    const double most = fmax(FIRST_MAGNIFIED, (double)screen_simulation(screen)->columns / 4);
    const double wanted = direction > 0 ? 2 * screen->eye.magnified : screen->eye.magnified / 2;
    double limit = 1; /* the next power of 2 */
    while (limit < most)
        limit *= 2;
    screen->eye.magnified = fmin(fmax(wanted, 1), limit);
}

void command_map_zoom(Laboratory *lab)
{
    Screen *screen = &lab->screen;
    if (!simulation_has_map(laboratory_simulation(lab))) {
        laboratory_tell(lab,
                        "Z magnifies the map of a beam or plate; n and N change the time window of a plot");
        return;
    }
    if (screen->eye.open) {
        command_map_whole(&lab->screen);
        return;
    }
    if (!screen->views.upper->is_map && !screen->views.lower->is_map)
        screen->views.upper = view_of_map();
    screen->panes.focus = screen->views.upper->is_map ? PANE_UPPER : PANE_LOWER;
    screen->eye.open = true;
    screen->eye.magnified = FIRST_MAGNIFIED;
    look_at_something(screen);
}

bool command_answer_magnify(Laboratory *lab, const char *text, Status *status)
{
    Screen *screen = &lab->screen;
    double times;
    if (!simulation_has_map(laboratory_simulation(lab)))
        return status_refuse(status, "there is no map of a bar (only of a beam or plate)");
    if (!text_to_double(text, &times) || !(times >= 1 && times <= MOST_MAGNIFIED))
        return status_refuse(status, "a number from 1 to 1024, as in 16");
    if (!screen->views.upper->is_map && !screen->views.lower->is_map)
        screen->views.upper = view_of_map();
    command_map_whole(screen);
    screen->eye.magnified = times;
    if (times > 1)
        look_at_something(screen);
    return true;
}

bool command_map_is_focused(const Screen *screen)
{
    return simulation_has_map(screen_simulation(screen)) &&
           ((screen->panes.focus == PANE_UPPER && screen->views.upper->is_map) ||
            (screen->panes.focus == PANE_LOWER && screen->views.lower->is_map));
}

/* The size of displacements is part of the scenario's view, which an edit changes without a new run. */
void command_map_enlarge(Laboratory *lab, int direction)
{
    Screen *screen = &lab->screen;
    Settings settings = *laboratory_settings(lab);
    const double now = view_map_enlargement(screen, lab->width, lab->height);
    Status status = {STATUS_DONE, ""};
    if (direction == 0)
        settings_edit_view(&settings)->exaggeration[0] = '\0';
    else
        snprintf(settings_edit_view(&settings)->exaggeration, sizeof settings_view(&settings)->exaggeration,
                 "%.15g", player_next_125(now > 0 ? now : 1, direction));
    if (!experiment_edit(laboratory_run(lab), &settings, &status))
        laboratory_say(lab, MESSAGE_ERROR, "%s", status.text);
    else if (direction == 0)
        laboratory_tell(lab, "displacements are drawn as large as the pane allows");
    else
        laboratory_tell(lab, "displacements are drawn x %s (a: as the pane allows)",
                        settings_view(&settings)->exaggeration);
}
