/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The commands that choose what is shown, and how. */
#include "lab/commands/commands.h"
#include "scenario/settings.h"
#include "views/view.h"

#include <math.h>

/* The keys go where the view is: Enter and the arrows do what its help says. Beside a lesson they stay with
 * its page. */
static void follow_view(Screen *screen, const View *view)
{
    PanesShown *panes = &screen->panes;
    const PaneId at = screen_view_in(screen, panes->focus) == view ? panes->focus
                      : screen->views.upper == view                ? PANE_UPPER
                                                                   : PANE_LOWER;
    if (screen_view_in(screen, at) != view)
        return; /* there is nothing for it to show */
    panes->last_plot = at;
    if (screen->lesson.open || panes->focus == at)
        return;
    panes->followed = true;
    panes->focus = at;
}

void command_show_digit(Laboratory *lab, int digit)
{
    const View *view = view_of_digit(digit);
    if (view) {
        command_show_view(lab, view);
        follow_view(&lab->screen, view);
    } else {
        laboratory_say(lab, MESSAGE_INFO, "no view has the key %d", digit);
    }
}

void command_show_view(Laboratory *lab, const View *view)
{
    Screen *screen = &lab->screen;
    /* where panes are seen one at a time, the view that is asked for comes to the front */
    const bool alone = screen->panes.zoomed || (lab->width > 0 && !screen_is_whole(lab->width, lab->height));
    const char *missing = view_missing(view, screen);
    if (missing) {
        laboratory_say(lab, MESSAGE_INFO, "%s: %s", view->word, missing);
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
        if (alone && screen->panes.focus != at)
            screen->panes.focus = at;
        else
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

void command_lecture(Laboratory *lab)
{
    lab->screen.panes.lecture = !lab->screen.panes.lecture;
    if (lab->screen.panes.lecture && lab->screen.lesson.open)
        laboratory_say(lab, MESSAGE_INFO, "a lesson keeps its page; the rest gets large when T closes it");
    else if (lab->screen.panes.lecture && !screen_is_whole(lab->width, lab->height))
        laboratory_say(lab, MESSAGE_INFO, "large letters want 80x24 at least; the curves are thick");
}

static void change_window(Laboratory *lab, int direction)
{
    Screen *screen = &lab->screen;
    double from, to;
    if (command_map_is_focused(&lab->screen)) {
        command_map_enlarge(lab, direction);
        return;
    }
    time_plot_window(screen, &from, &to);
    double length = screen->time.window > 0 ? screen->time.window : to - from;
    const double dt = experiment_simulation(screen->experiment)->dt, least = 10 * dt;
    const double end = dt * (double)experiment_last_step(screen->experiment);
    double window = player_next_125(length, direction);
    /* the table of 1, 2, 5 does not reach into the microseconds of a crack */
    if (length < 1e-2)
        window = 1e-6 * player_next_125(1e6 * length, direction);
    if (window < least || (direction > 0 && length >= end)) {
        laboratory_say(lab, MESSAGE_INFO,
                       direction < 0 ? "the time window has ten steps, no fewer"
                                     : "the time window holds the whole run");
        return;
    }
    screen->time.window = window;
    const Problem *facts = experiment_settings(screen->experiment)->problem;
    laboratory_say(lab, MESSAGE_INFO, "time window %g%s", window / facts->shown_time, facts->shown_time_unit);
}

void command_narrower(Laboratory *lab)
{
    change_window(lab, -1);
}

void command_wider(Laboratory *lab)
{
    change_window(lab, 1);
}

void command_automatic(Laboratory *lab)
{
    if (command_map_is_focused(&lab->screen)) {
        command_map_enlarge(lab, 0);
        return;
    }
    lab->screen.time.window = 0;
    laboratory_say(lab, MESSAGE_INFO, "time window automatic");
}

void command_cycle_references(Laboratory *lab)
{
    static const char *const texts[SHOW_COUNT] = {"all", "exact only", "predicted only", "none"};
    lab->screen.views.references = (ReferencesShown)((lab->screen.views.references + 1) % SHOW_COUNT);
    laboratory_say(lab, MESSAGE_INFO, "reference curves: %s", texts[lab->screen.views.references]);
}

void command_cycle_glyphs(Laboratory *lab)
{
    static const char *const texts[GLYPHS_COUNT] = {"braille", "block", "ASCII"};
    if (!lab->utf8) {
        laboratory_say(lab, MESSAGE_INFO, "this locale has ASCII only");
        return;
    }
    lab->screen.look.glyphs = (Glyphs)((lab->screen.look.glyphs + 1) % GLYPHS_COUNT);
    laboratory_say(lab, MESSAGE_INFO, "glyphs: %s", texts[lab->screen.look.glyphs]);
}
