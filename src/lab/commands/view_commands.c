/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The commands that choose what is shown, and how. */
#include "lab/commands/commands.h"
#include "views/view.h"
#include "lab/session/state_file.h"
#include "views/plots/plots.h"

#include <math.h>

void command_show_digit(Laboratory *lab, int digit)
{
    const View *view = view_of_digit(digit);
    if (!view) {
        laboratory_tell(lab, "no view has the key %d", digit);
        return;
    }
    command_show_view(lab, view);
    /* Keys go where the view is, as its help says; beside a lesson they stay with its page. */
    Screen *screen = &lab->screen;
    PanesShown *panes = &screen->panes;
    const PaneId at = screen_view_in(screen, panes->focus) == view ? panes->focus
                      : screen->views.upper == view                ? PANE_UPPER
                                                                   : PANE_LOWER;
    if (screen_view_in(screen, at) != view)
        return; /* there is nothing for it to show */
    panes->last_plot = at;
    if (screen->lesson->open || screen_is_plain(screen) || panes->focus == at)
        return;
    panes->followed = true;
    panes->focus = at;
}

void command_show_view(Laboratory *lab, const View *view)
{
    Screen *screen = &lab->screen;
    /* where panes are seen one at a time, the view that is asked for comes to the front */
    const bool alone =
        screen->panes.zoomed || (lab->width > 0 && !screen_is_whole(screen, lab->width, lab->height));
    const char *missing = view_missing(view, screen);
    if (missing) {
        laboratory_tell(lab, "%s: %s", view->word, missing);
        return;
    }
    lab->refining.stopped = NULL;
    if (screen->panes.inspecting) /* it lies over the plots and would hide the one that is asked for */
        command_close_inspector(&lab->screen);
    const bool in_plot = !screen->panes.followed && screen_view_in(screen, screen->panes.focus) != NULL;
    if (screen->views.upper == view || screen->views.lower == view) {
        PaneId at = in_plot && screen_view_in(screen, screen->panes.focus) == view ? screen->panes.focus
                    : screen->views.upper == view                                  ? PANE_UPPER
                                                                                   : PANE_LOWER;
        const bool hidden = screen_is_plain(screen) && screen->panes.last_plot != at;
        screen->panes.last_plot = screen_is_plain(screen) ? at : screen->panes.last_plot;
        if (alone && screen->panes.focus != at)
            screen->panes.focus = at;
        else if (!hidden)
            view_choose_variant(view, screen, view_variant(view, screen) + 1);
        return;
    }
    PaneId pane = in_plot ? screen->panes.focus : view->home;
    if (pane == PANE_UPPER)
        screen->views.upper = view;
    else
        screen->views.lower = view;
    if (alone)
        screen->panes.focus = pane;
    screen->panes.last_plot = pane;
    screen->chosen.table_column = 0;
    screen->time.cursor = NAN;
}

void command_zoom(Laboratory *lab)
{
    PanesShown *panes = &lab->screen.panes;
    if (panes->zoomed) {
        command_zoom_out(&lab->screen);
        return;
    }
    panes->before_zoom = panes->focus;
    if (panes->focus == PANE_PARAMETERS)
        panes->focus = panes->last_plot;
    panes->zoomed = true;
}

/* What the arrows change stays under them, where the other sheet has a row for it. */
static void turn_sheet(Laboratory *lab, Sheet sheet, bool lecture)
{
    Screen *screen = &lab->screen;
    const Parameter *chosen = edit_selected(screen);
    const bool was_plain = screen_is_plain(screen);
    screen->panes.sheet = sheet;
    screen->panes.lecture = lecture;
    if (screen_is_plain(screen) == was_plain)
        return;
    lab->parameters.selected = screen_row_of(screen, chosen);
    screen->panes.zoomed = false;
    if (was_plain || screen->panes.inspecting || screen->eye.open)
        return;
    if (!screen_view_in(screen, screen->panes.focus))
        screen->panes.last_plot = view_pane_of_number(screen);
    screen->panes.focus = PANE_PARAMETERS;
}

void command_lecture(Laboratory *lab)
{
    turn_sheet(lab, lab->screen.panes.sheet, !lab->screen.panes.lecture);
}

void command_show_sheet(Laboratory *lab, Sheet sheet)
{
    const bool by_page = lab->asker == ASKER_LESSON;
    if (by_page && lab->play.full)
        return; /* what the reader likes holds to the end of the lesson */
    turn_sheet(lab, sheet, lab->screen.panes.lecture && by_page);
    if (lesson_entry_page(lab))
        lab->play.full = !by_page && sheet == SHEET_FULL;
    else if (lab->options.keeps_sheet && lab->asker == ASKER_KEYBOARD)
        state_file_put(lab->asker, state_file_sheet, parameter_sheet_words[sheet]);
}

void command_sheet(Laboratory *lab)
{
    command_show_sheet(lab, screen_is_plain(&lab->screen) ? SHEET_FULL : SHEET_PLAIN);
}

/* Wider or narrower; 0: automatic. */
void command_window(Laboratory *lab, int direction)
{
    Screen *screen = &lab->screen;
    double from, to;
    if (command_map_is_focused(&lab->screen)) {
        command_map_enlarge(lab, direction);
        return;
    }
    if (direction == 0) {
        screen->time.window = 0;
        laboratory_tell(lab, "time window automatic");
        return;
    }
    time_plot_window(screen, &from, &to);
    double length = screen->time.window > 0 ? screen->time.window : to - from;
    const double dt = laboratory_simulation(lab)->dt, least = 10 * dt;
    const double end = dt * (double)experiment_last_step(laboratory_run(lab));
    double window = player_next_125(length, direction);
    /* the table of 1, 2, 5 does not reach into the microseconds of a crack */
    if (length < 1e-2)
        window = 1e-6 * player_next_125(1e6 * length, direction);
    if (window < least || (direction > 0 && length >= end)) {
        laboratory_tell(lab, direction < 0 ? "the time window has ten steps, no fewer"
                                           : "the time window holds the whole run");
        return;
    }
    screen->time.window = window;
    const Problem *facts = laboratory_settings(lab)->problem;
    laboratory_tell(lab, "time window %g%s", window / facts->shown_time, facts->shown_time_unit);
}

void command_cycle_references(Laboratory *lab)
{
    static const char *const texts[SHOW_COUNT] = {"all", "exact only", "predicted only", "none"};
    lab->screen.views.references = (ReferencesShown)((lab->screen.views.references + 1) % SHOW_COUNT);
    laboratory_tell(lab, "reference curves: %s", texts[lab->screen.views.references]);
}

void command_cycle_glyphs(Laboratory *lab)
{
    static const char *const texts[GLYPHS_COUNT] = {"braille", "block", "ASCII"};
    if (!lab->utf8) {
        laboratory_tell(lab, "this locale has ASCII only");
        return;
    }
    lab->screen.look.glyphs = (Glyphs)((lab->screen.look.glyphs + 1) % GLYPHS_COUNT);
    laboratory_tell(lab, "glyphs: %s", texts[lab->screen.look.glyphs]);
}
