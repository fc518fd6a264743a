/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Where panes lie. While a run goes on the plots have the rows; paused, the box with what happens within a
 * step takes some of them. The timeline, where it has no row of its own, takes one from the lower plot while
 * we are back in time. */
#include "panes/panes.h"
#include "scenario/concern_body.h"
#include "views/view.h"
#include "lessons/lesson_shown.h"
#include "panes/screen_places.h"

enum {
    LEAST_WIDTH = 40,
    LEAST_HEIGHT = 12,
    FULL_WIDTH = 80,
    FULL_HEIGHT = 20,
    WIDE = 120, /* from here on there is a column at the right */
    WIDER = 130,
    PARAMETERS_WIDTH = 25,
    WIDE_PARAMETERS_WIDTH = 28,
    SIDE_HEIGHT = 30,
    INSPECTOR_WIDTH = 79,
    TIMELINE_WIDTH = 100,
    TIMELINE_HEIGHT = 30,
    LEGEND_HEIGHT = 40
};

#define TALL_SHARE 0.2 /* height over length */

/* The tables and the energies one below the other, in so many rows; the second table only where all three
 * have room. */
static void lay_out_sides(const Screen *screen, Rect rect, Layout *layout)
{
    enum { LEAST_ROWS = 8 };
    const int sets = experiment_simulation(screen->experiment)->n_sets > 1 ? 2 : 1;
    /* beside a lesson energies would answer what is still to be asked: its pages show them */
    const int first = screen->lesson->open ? 0 : 1;
    const int tables = rect.height / (first + 2) >= LEAST_ROWS ? sets : 1;
    const int energies = first == 0 ? 0 : tables == 2 ? rect.height - 2 * (rect.height / 3) : rect.height / 2;
    const int rest = rect.height - energies;
    layout->sides[0] = (Rect){rect.x, rect.y, energies ? rect.width : 0, energies};
    layout->sides[1] = (Rect){rect.x, rect.y + energies, rect.width, tables == 2 ? rest / 2 : rest};
    if (tables == 2)
        layout->sides[2] = (Rect){rect.x, rect.y + energies + rest / 2, rect.width, rest - rest / 2};
}

/* Over the plots, and where its columns need the room over the fields too. */
static void lay_out_inspector(int width, Layout *layout)
{
    Rect *fields = &layout->panes[PANE_PARAMETERS], *timeline = &layout->timeline;
    const bool beside = width >= INSPECTOR_WIDTH + fields->width + 1;
    const int x = beside ? layout->panes[PANE_UPPER].x : 0;
    layout->panes[PANE_INSPECTOR] = (Rect){x, fields->y, width - x, fields->height - timeline->height};
    layout->panes[PANE_UPPER] = layout->panes[PANE_LOWER] = (Rect){0};
    if (beside)
        return;
    *fields = (Rect){0};
    if (timeline->height > 0)
        *timeline = (Rect){0, timeline->y, width, timeline->height};
}

static void lay_out_full(const Screen *screen, int width, int height, Layout *layout)
{
    /* a beam that is in a plot pane is not drawn twice */
    const bool drawn = simulation_has(experiment_simulation(screen->experiment), HAS_PLANE) &&
                       (screen->views.upper->is_map || screen->views.lower->is_map);
    const int box = layout_box_rows(screen, height, drawn);
    const int mesh = drawn ? 0 : layout_strip_rows(height);
    const int top = 1 + mesh, middle = height - 2 - box - mesh;
    const int fields = screen->lesson->open ? layout_lesson_width(width)
                       : width < WIDER      ? PARAMETERS_WIDTH
                                            : WIDE_PARAMETERS_WIDTH;
    /* two runs side by side take what else joins at the right */
    const bool tables =
        !screen->lesson->open || simulation_has(experiment_simulation(screen->experiment), HAS_MESH);
    const bool side = width >= WIDE && height >= SIDE_HEIGHT && !screen_second_run(screen) && tables;
    const int side_width = side ? (width < WIDER ? 39 : width < 150 ? 45 : width * 3 / 10) : 0;
    const int left = fields + 1, plots = width - left - (side ? side_width + 1 : 0);
    /* the map of a beam that is not slender wants height more than the curve below it */
    const Settings *settings = experiment_settings(screen->experiment);
    const bool tall = drawn && screen->views.upper->is_map &&
                      settings_geometry(settings)->height > TALL_SHARE * settings_geometry(settings)->length;
    const int lower = tall ? middle * 4 / 9 + 1 : (middle + (layout_has_caption(screen) ? 2 : 3)) / 2,
              upper = middle - lower;
    /* on a large screen with a row for what its marks are */
    const bool own = width >= TIMELINE_WIDTH && height >= TIMELINE_HEIGHT;
    const int timeline = own && height >= LEGEND_HEIGHT ? 2 : own || screen_is_rewound(screen);

    layout->kind = LAYOUT_FULL;
    layout->panes[PANE_MESH] = (Rect){0, 1, mesh ? width : 0, mesh};
    layout->panes[PANE_PARAMETERS] = (Rect){0, top, fields, middle};
    layout->panes[PANE_UPPER] = (Rect){left, top, plots, upper};
    layout->panes[PANE_LOWER] = (Rect){left, top + upper, plots, lower - timeline};
    if (timeline)
        layout->timeline = (Rect){left, top + middle - timeline, plots, timeline};
    layout->panes[PANE_BOX] = (Rect){0, top + middle, width, box};
    if (screen->panes.inspecting)
        lay_out_inspector(width, layout);
    else if (side) {
        /* a beam lies along the whole width, and what joins at the right is beside the lower plot */
        const int above = drawn && screen->views.upper->is_map ? upper : 0;
        if (above)
            layout->panes[PANE_UPPER].width = width - left;
        lay_out_sides(screen, (Rect){width - side_width, top + above, side_width, middle - above}, layout);
    }
}

Layout layout_make(const Screen *screen, int width, int height)
{
    Layout layout = {.kind = LAYOUT_TOO_SMALL};
    if (width < LEAST_WIDTH || height < LEAST_HEIGHT)
        return layout;
    layout.title = (Rect){0, 0, width, 1};
    layout.keys = (Rect){0, height - 1, width, 1};
    if (screen_is_plain(screen) && !screen->panes.zoomed && layout_plain(screen, width, height, &layout))
        return layout;
    if (width >= FULL_WIDTH && height >= FULL_HEIGHT && !screen->panes.zoomed && !screen_is_plain(screen)) {
        lay_out_full(screen, width, height, &layout);
        return layout;
    }
    layout_small(screen, width, height, &layout);
    return layout;
}

bool screen_is_whole(const Screen *screen, int width, int height)
{
    Layout layout;
    if (screen_is_plain(screen))
        return layout_plain(screen, width, height, &layout);
    return width >= FULL_WIDTH && height >= FULL_HEIGHT;
}

Rect screen_pane(const Screen *screen, int width, int height, PaneId pane)
{
    Layout layout = layout_make(screen, width, height);
    return pane < PANE_COUNT ? layout.panes[pane] : (Rect){0};
}
