/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Where panes lie on a screen without room for all of them, and what a pane that fills the screen leaves.
 *
 * One pane is seen, the one that the keys go to; where there is room with it what it is read with: both plots
 * together, a page of a lesson with a plot below it, and in the middle of a step, at the end and of a duel
 * the box with its numbers. */
#include "panes/panes.h"
#include "views/view.h"
#include "lessons/lesson_shown.h"
#include "run/playback.h"

enum {
    PAIR_WIDTH = 60, /* from here on both plots are seen, without parameters */
    PAIR_HEIGHT = 20,
    BOX_WIDTH = 56, /* and from here on a box below what else is seen */
    BOX_HEIGHT = 16,
    BOX_ROWS = 5,
    PLOT_ROWS = 5,  /* fewer show nothing */
    PLOT_WANTED = 8 /* the text closes up for them */
};

static bool is_plot(PaneId pane)
{
    return pane == PANE_UPPER || pane == PANE_LOWER;
}

/* Whether there are numbers to be read that no plot has. */
static bool has_numbers(const Screen *screen)
{
    const RunState state = screen->playback->state;
    return experiment_stage(screen->experiment) > 0 || state == STATE_ENDED || state == STATE_FAILED ||
           screen_second_run(screen);
}

/* Text above; below it the pane that has the focus or, while the text has it, what the page speaks of. False:
 * the text leaves no room. */
static bool lay_out_page(const Screen *screen, int width, int height, Layout *layout)
{
    const PaneId focus = screen->panes.focus;
    const bool read = focus == PANE_PARAMETERS;
    const bool in_step = experiment_stage(screen->experiment) > 0;
    const View *plot = screen_view_in(screen, screen->panes.last_plot);
    const bool drawn = plot && plot->is_wide && screen_is_plain(screen); /* it has the numbers of the step */
    const PaneId other = !read ? focus : in_step && !drawn ? PANE_BOX : screen->panes.last_plot;
    const int text = pane_lesson_rows(screen, width, height - 2 - PLOT_WANTED), rest = height - 2 - text;
    if (focus == PANE_INSPECTOR || rest < PLOT_ROWS)
        return false;
    layout->panes[PANE_PARAMETERS] = (Rect){0, 1, width, text};
    layout->panes[other] = (Rect){0, 1 + text, width, rest};
    return true;
}

void layout_small(const Screen *screen, int width, int height, Layout *layout)
{
    const PaneId given = screen->panes.focus < PANE_COUNT ? screen->panes.focus : PANE_PARAMETERS;
    /* what is moved on the map is looked at there, though the keys go to the parameters */
    const PaneId map = screen->views.upper->is_map ? PANE_UPPER : PANE_LOWER;
    const PaneId focus = screen->parameters->rows.placing ? map : given;
    const bool whole = screen->panes.zoomed, roomy = width >= BOX_WIDTH && height >= BOX_HEIGHT;
    layout->kind = LAYOUT_ONE_PANE;
    if (!whole && roomy && screen->lesson->open && screen->lesson->lesson &&
        lay_out_page(screen, width, height, layout))
        return;
    const bool box = !whole && roomy && (is_plot(focus) || focus == PANE_MESH) && has_numbers(screen);
    const int rows = height - 2 - (box ? BOX_ROWS : 0);
    layout->panes[focus] = (Rect){0, 1, width, rows};
    if (box)
        layout->panes[PANE_BOX] = (Rect){0, 1 + rows, width, BOX_ROWS};
    if (!whole && width >= PAIR_WIDTH && height >= PAIR_HEIGHT && is_plot(focus)) {
        layout->panes[PANE_UPPER] = (Rect){0, 1, width, rows / 2};
        layout->panes[PANE_LOWER] = (Rect){0, 1 + rows / 2, width, rows - rows / 2};
    }
}
