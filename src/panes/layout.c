/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Where panes lie. While a run goes on the plots have the rows; paused, the box with what happens within a
 * step takes some of them. The timeline, where it has no row of its own, takes one from the lower plot while
 * we are back in time. */
#include "panes/panes.h"
#include "scenario/concern_body.h"
#include "views/view.h"
#include "lessons/lesson_shown.h"
#include "run/playback.h"

#include <math.h>

enum {
    LEAST_WIDTH = 40,
    LEAST_HEIGHT = 12,
    FULL_WIDTH = 80,
    FULL_HEIGHT = 20,
    WIDE = 120, /* from here on there is a column at the right */
    WIDER = 130,
    PARAMETERS_WIDTH = 25,
    WIDE_PARAMETERS_WIDTH = 28,
    LESSON_WIDTH = 37,
    WIDE_LESSON_WIDTH = 46,
    SIDE_HEIGHT = 30,
    INSPECTOR_WIDTH = 79,
    TIMELINE_WIDTH = 100,
    TIMELINE_HEIGHT = 30,
    LEGEND_HEIGHT = 40,
    PICTURE_LEAST = 6,
    PLOT_LEAST = 30
};

#define TALL_SHARE 0.2 /* height over length */

int pane_runs_rows(const Screen *screen)
{
    enum { LEAST = 2 }; /* earlier runs: of one the legend has all */
    const Ghost *ghosts = experiment_ghosts(screen->experiment);
    int kept = 0, all = 0;
    for (int i = 0; i < GHOSTS_MAX; i++) {
        all += ghosts[i].used;
        kept += ghosts[i].used && ghosts[i].pinned;
    }
    if (kept < LEAST || screen_second_run(screen) || !experiment_readout(screen->experiment)->moving)
        return 0;
    return 1 + all + 1;
}

/* A caption is short; a stage, a summary and a table of runs are not. */
static bool layout_has_caption(const Screen *screen)
{
    return !screen_second_run(screen) && pane_runs_rows(screen) == 0 &&
           (screen_is_running(screen) ||
            (screen->playback->state == STATE_COMPUTING && screen->playback->goes_on));
}

/* While a run goes on no more than the words need where there is a map: it takes the rest. */
static int layout_box_rows(const Screen *screen, int height, bool map)
{
    if (layout_has_caption(screen))
        return height < 27 ? 3 : height < 30 ? 4 : height < 40 || map ? 5 : 6;
    /* sums of the plane are of two directions */
    if (height < 30 && screen_is_inside(screen) && screen_has(screen, HAS_BODIES))
        return 7;
    return height < 22 ? 4 : height < 27 ? 5 : height < 30 ? 6 : height < 40 ? 9 : 10;
}

static int layout_strip_rows(int height)
{
    return height < 28 ? 2 : height < 40 ? 3 : 4;
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

/* The map of bodies, whose lengths are to one scale, is beside the plot or above it, whichever draws it
 * larger; the plot has the rest, at least what can be read. */
static void lay_out_bodies(const Screen *screen, Rect rect, Layout *layout)
{
    const bool upper = screen->views.upper->is_map;
    Rect *map = &layout->panes[upper ? PANE_UPPER : PANE_LOWER],
         *plot = &layout->panes[upper ? PANE_LOWER : PANE_UPPER];
    const Geometry *box = settings_geometry(screen_settings(screen));
    const double across = 2 * box->length / box->height; /* columns to a row */
    const int most = (int)(across * (rect.height - 2)) + 2, free = rect.width - PLOT_LEAST;
    const int beside = most < free ? most : free, high = rect.height * 3 / 5;
    *map = *plot = rect;
    if (rect.height < 2 * PICTURE_LEAST || beside - 2 >= fmin(rect.width - 2, across * (high - 2))) {
        map->width = beside;
        plot->x += beside, plot->width -= beside;
    } else {
        map->height = high;
        plot->y += high, plot->height -= high;
    }
}

static void lay_out_full(const Screen *screen, int width, int height, Layout *layout)
{
    /* a beam that is in a plot pane is not drawn twice */
    const bool drawn = simulation_has_map(screen_simulation(screen)) &&
                       (screen->views.upper->is_map || screen->views.lower->is_map);
    /* nor are bodies in a strip, which is one body at its height at rest */
    const bool has_bodies = screen_has(screen, HAS_BODIES);
    const bool bodies = drawn && has_bodies && !screen_second_run(screen);
    const int box = layout_box_rows(screen, height, drawn);
    const int mesh = drawn || has_bodies ? 0 : layout_strip_rows(height);
    const int top = 1 + mesh, middle = height - 2 - box - mesh;
    const int fields = !screen->lesson->open ? (width < WIDER ? PARAMETERS_WIDTH : WIDE_PARAMETERS_WIDTH)
                       : width < WIDE        ? LESSON_WIDTH
                                             : WIDE_LESSON_WIDTH;
    /* two runs side by side take what else joins at the right */
    const bool tables = !screen->lesson->open || screen_has(screen, HAS_MESH);
    const bool side = width >= WIDE && height >= SIDE_HEIGHT && !screen_second_run(screen) && tables;
    const int side_width = side ? (width < WIDER ? 39 : width < 150 ? 45 : width * 3 / 10) : 0;
    const int left = fields + 1, plots = width - left - (side ? side_width + 1 : 0);
    /* the map of a beam that is not slender wants height more than the curve below it */
    const Settings *settings = screen_settings(screen);
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
        if (bodies) {
            layout->panes[PANE_UPPER].height = middle - timeline;
            layout->panes[PANE_LOWER] = (Rect){width - side_width, top, side_width, upper};
        } else if (above)
            layout->panes[PANE_UPPER].width = width - left;
        /* Tables and energies one below the other; the second table only where all three have so many rows.
         */
        const Rect rect = (Rect){width - side_width, top + above, side_width, middle - above};
        enum { LEAST_ROWS = 8 };
        const int sets = screen_simulation(screen)->n_sets > 1 ? 2 : 1;
        /* beside a lesson energies would answer what is still to be asked: its pages show them */
        const int first = screen->lesson->open ? 0 : 1;
        const int side_tables = rect.height / (first + 2) >= LEAST_ROWS ? sets : 1;
        const int energies = first == 0         ? 0
                             : side_tables == 2 ? rect.height - 2 * (rect.height / 3)
                                                : rect.height / 2;
        const int rest = rect.height - energies;
        layout->sides[0] = (Rect){rect.x, rect.y, energies ? rect.width : 0, energies};
        layout->sides[1] = (Rect){rect.x, rect.y + energies, rect.width, side_tables == 2 ? rest / 2 : rest};
        if (side_tables == 2)
            layout->sides[2] = (Rect){rect.x, rect.y + energies + rest / 2, rect.width, rest - rest / 2};
    } else if (bodies)
        lay_out_bodies(screen, (Rect){left, top, plots, middle - timeline}, layout);
}

/* Where panes lie on a screen without room for all of them, and what a pane that fills the screen leaves.
 *
 * One pane is seen, the one that the keys go to; where there is room with it what it is read with: both plots
 * together, a page of a lesson with a plot below it, and in the middle of a step, at the end and of a duel
 * the box with its numbers. */

enum {
    PAIR_WIDTH = 60, /* from here on both plots are seen, without parameters */
    PAIR_HEIGHT = 20,
    BOX_WIDTH = 56, /* and from here on a box below what else is seen */
    BOX_HEIGHT = 16,
    BOX_ROWS = 5,
    PLOT_ROWS = 5,  /* fewer show nothing */
    PLOT_WANTED = 8 /* the text closes up for them */
};

/* Text above; below it the pane that has the focus or what the page speaks of. False: there is no room. */
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

/* Where panes lie on the plain sheet: in one column below 80 columns; else one large picture, above it the
 * strip of particles, below it what is asked, the number that the scenario is about and the parameters that
 * it asks about. Beside a lesson the text and the picture; in the middle of a step, where a run has failed,
 * and for a user who has asked what is wrong with a code of his own, the box that describes it. */

enum {
    PLAIN_WIDTH = 60,
    PLAIN_HEIGHT = 18,
    STACKED_WIDTH = 80,  /* below it a screen that is high, as a telephone's, has one column */
    STACKED_LEAST = 36,  /* columns */
    STACKED_HEIGHT = 30, /* of one that could have two */
    BESIDE_WIDTH = 80,   /* from here on a low screen, a telephone's on its side, has two columns */
    BESIDE_HEIGHT = 22,
    LESSON_LEAST_WIDTH = 80, /* a text wants a column of its own */
    LESSON_LEAST_HEIGHT = 16,
    LESSON_STRIP_HEIGHT = 20,
    ASKED_WIDTH = 34,
    ASKED_MOST = 40,
    PROFILE_HEIGHT = 30, /* from here on the displacement along a bar is above its plot */
    DRAWING_ROWS = 15    /* with the sums of a stage below it */
};

/* The one picture: the plot that was looked at last. */
static PaneId picture_of(const Screen *screen)
{
    const PaneId focus = screen->panes.focus;
    return screen_view_in(screen, focus) ? focus : screen->panes.last_plot;
}

/* A body that is drawn large is not drawn twice. */
static int strip_rows(const Screen *screen, int height)
{
    if (screen_has(screen, HAS_BODIES))
        return 0;
    return screen_view_in(screen, picture_of(screen))->is_map ? 0 : layout_strip_rows(height);
}

/* A drawing of one thing has the terms of its stage by itself. */
static int box_rows(const Screen *screen, int height, bool wide)
{
    const bool failed = screen->playback->state == STATE_FAILED, inside = screen_is_inside(screen) && !wide;
    return inside || failed || screen->diagnosis[0] ? layout_box_rows(screen, height, false) : 0;
}

/* In one column: the picture, or over it what one thing gives and takes. */
static void lay_out_picture(const Screen *screen, Rect rect, Layout *layout)
{
    const bool map = screen->views.upper->is_map || screen->views.lower->is_map;
    if (map && !screen->panes.inspecting && screen_has(screen, HAS_BODIES))
        lay_out_bodies(screen, rect, layout);
    else
        layout->panes[screen->panes.inspecting ? PANE_INSPECTOR : picture_of(screen)] = rect;
}

static void lay_out_lesson(const Screen *screen, int width, int height, Layout *layout)
{
    /* a drawing across the whole screen goes under the text, where that leaves it room; the strip of all
     * particles would show it once more */
    const bool wide = screen_view_in(screen, picture_of(screen))->is_wide && !screen->panes.inspecting &&
                      screen->lesson->lesson;
    const int below = box_rows(screen, height, true), rows = height - 2 - below;
    const int lines = wide ? pane_lesson_rows(screen, width, rows - DRAWING_ROWS) : rows;
    if (rows - lines >= PICTURE_LEAST) {
        layout->panes[PANE_PARAMETERS] = (Rect){0, 1, width, lines};
        lay_out_picture(screen, (Rect){0, 1 + lines, width, rows - lines}, layout);
        layout->panes[PANE_BOX] = (Rect){0, 1 + rows, below ? width : 0, below};
        return;
    }
    const int strip = height < LESSON_STRIP_HEIGHT ? 0 : strip_rows(screen, height),
              box = box_rows(screen, height, false);
    const int top = 1 + strip, middle = height - 2 - strip - box;
    const int text = width < WIDE ? LESSON_WIDTH : WIDE_LESSON_WIDTH, left = text + 1;
    /* Beside a lesson: in a lecture, and of bodies once it is known, for no plot has it. */
    char digits[NUMBER_DIGITS_MAX], words[NUMBER_WORDS_MAX];
    const bool bodies = screen_has(screen, HAS_BODIES);
    const bool shown = screen->panes.lecture || (bodies && screen_number(screen, digits, words));
    const int number = shown && screen->lesson->lesson ? pane_number_rows(screen, width, height) : 0;
    layout->panes[PANE_MESH] = (Rect){0, 1, strip ? width : 0, strip};
    layout->panes[PANE_PARAMETERS] = (Rect){0, top, text, middle};
    if (number && middle - number >= (screen->panes.lecture ? 1 : 3) * PICTURE_LEAST)
        layout->number = (Rect){left, top + middle - number, width - left, number};
    lay_out_picture(screen, (Rect){left, top, width - left, middle - layout->number.height}, layout);
    layout->panes[PANE_BOX] = (Rect){0, top + middle, box ? width : 0, box};
}

static void lay_out_scenario(const Screen *screen, int width, int height, Layout *layout)
{
    const int asked = pane_asked_rows(screen), number = pane_number_rows(screen, width, height);
    const int wanted = width / 2, fields = wanted < ASKED_WIDTH  ? ASKED_WIDTH
                                           : wanted > ASKED_MOST ? ASKED_MOST
                                                                 : wanted;
    const int question = pane_question_rows(screen, width);
    int below = asked > number ? asked : number;
    int strip = strip_rows(screen, height), box = box_rows(screen, height, false);
    int middle = height - 2 - strip - box - question - below;
    /* in a step its numbers are worth more than the picture of all particles, and what is asked */
    if (middle < PICTURE_LEAST)
        middle += strip, strip = 0;
    if (middle < PICTURE_LEAST && box > 0)
        middle += below, below = 0;
    if (middle < PICTURE_LEAST)
        middle += box, box = 0;
    const int top = 1 + strip, end = top + middle + box;
    layout->panes[PANE_MESH] = (Rect){0, 1, strip ? width : 0, strip};
    const bool both = height >= PROFILE_HEIGHT && middle >= 2 * PICTURE_LEAST && strip > 0 &&
                      !screen->panes.lecture && !screen->panes.inspecting &&
                      screen->views.upper == &view_profile && screen->views.lower->has_time_axis;
    const int profile = both ? middle * 2 / 5 : 0;
    if (both) {
        layout->panes[PANE_UPPER] = (Rect){0, top, width, profile};
        layout->panes[PANE_LOWER] = (Rect){0, top + profile, width, middle - profile};
    } else
        lay_out_picture(screen, (Rect){0, top, width, middle}, layout);
    layout->panes[PANE_BOX] = (Rect){0, top + middle, box ? width : 0, box};
    layout->question = (Rect){0, end, question ? width : 0, question};
    layout->number = (Rect){0, end + question, width - fields - 1, below};
    layout->panes[PANE_PARAMETERS] = (Rect){width - fields - 1, end + question, fields, below};
}

/* In one column: what is asked, the bar or the map, the plot, the number, the parameters, as rows allow. */
static void lay_out_stacked(const Screen *screen, int width, int height, Layout *layout)
{
    const PaneId picture = picture_of(screen);
    const PaneId map = screen->panes.inspecting      ? PANE_COUNT
                       : screen->views.upper->is_map ? PANE_UPPER
                       : screen->views.lower->is_map ? PANE_LOWER
                                                     : PANE_COUNT;
    const PaneId plot = map != picture ? picture : map == PANE_UPPER ? PANE_LOWER : PANE_UPPER;
    const int question = pane_question_rows(screen, width),
              strip = map < PANE_COUNT ? 0 : strip_rows(screen, height);
    const int least = map < PANE_COUNT ? 2 * PICTURE_LEAST : PICTURE_LEAST;
    int box = box_rows(screen, height, false), number = pane_number_rows(screen, width, height),
        asked = pane_asked_rows(screen);
    int middle = height - 2 - question - strip - box - number - asked;
    if (middle < least)
        middle += asked, asked = 0;
    if (middle < least)
        middle += number, number = 0;
    if (middle < least)
        middle += box, box = 0;
    const int above = map < PANE_COUNT ? middle / 2 : 0, top = 1 + question + strip;
    layout->question = (Rect){0, 1, question ? width : 0, question};
    layout->panes[PANE_MESH] = (Rect){0, 1 + question, strip ? width : 0, strip};
    lay_out_picture(screen, (Rect){0, top, width, middle}, layout);
    if (map < PANE_COUNT) {
        layout->panes[map] = (Rect){0, top, width, above};
        layout->panes[plot] = (Rect){0, top + above, width, middle - above};
    }
    const int end = top + middle;
    layout->panes[PANE_BOX] = (Rect){0, end, box ? width : 0, box};
    layout->number = (Rect){0, end + box, number ? width : 0, number};
    layout->panes[PANE_PARAMETERS] = (Rect){0, end + box + number, asked ? width : 0, asked};
}

static bool layout_plain(const Screen *screen, int width, int height, Layout *layout)
{
    const bool lesson = screen->lesson->open;
    if (!lesson && width < STACKED_WIDTH && width >= STACKED_LEAST &&
        height >= (width < PLAIN_WIDTH ? PLAIN_HEIGHT : STACKED_HEIGHT)) {
        layout->kind = LAYOUT_FULL;
        lay_out_stacked(screen, width, height, layout);
        return true;
    }
    if (!lesson && width >= BESIDE_WIDTH && height < BESIDE_HEIGHT) {
        layout->kind = LAYOUT_FULL;
        /* The bar and the picture at the left, the number and the parameters beside them, what is asked
         * above. */
        const int question = pane_question_rows(screen, width), box = box_rows(screen, height, false);
        const int top = 1 + question, middle = height - 2 - question - box, left = width - ASKED_WIDTH - 1;
        const int strip = middle < 2 * PICTURE_LEAST ? 0 : strip_rows(screen, height);
        const int asked = pane_asked_rows(screen), number = pane_number_rows(screen, width, height);
        /* the parameters are what is changed; below the title a row stays free, where there is one */
        const int gap = number > 0 && question == 0 && number + asked < middle;
        const int over = number + asked > middle ? 0 : number + gap;
        layout->question = (Rect){0, 1, question ? width : 0, question};
        layout->panes[PANE_MESH] = (Rect){0, top, strip ? left : 0, strip};
        lay_out_picture(screen, (Rect){0, top + strip, left, middle - strip}, layout);
        layout->number = (Rect){left + 1, top, over ? ASKED_WIDTH : 0, over};
        layout->panes[PANE_PARAMETERS] = (Rect){left + 1, top + over, ASKED_WIDTH, middle - over};
        layout->panes[PANE_BOX] = (Rect){0, top + middle, box ? width : 0, box};
        return true;
    }
    if (width < (lesson ? LESSON_LEAST_WIDTH : PLAIN_WIDTH) ||
        height < (lesson ? LESSON_LEAST_HEIGHT : PLAIN_HEIGHT))
        return false;
    layout->kind = LAYOUT_FULL;
    (lesson ? lay_out_lesson : lay_out_scenario)(screen, width, height, layout);
    return true;
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
    const PaneId given = screen->panes.focus < PANE_COUNT ? screen->panes.focus : PANE_PARAMETERS;
    /* what is moved on the map is looked at there, though the keys go to the parameters */
    const PaneId map = screen->views.upper->is_map ? PANE_UPPER : PANE_LOWER;
    const PaneId focus = screen->parameters->rows.placing ? map : given;
    const bool whole = screen->panes.zoomed, roomy = width >= BOX_WIDTH && height >= BOX_HEIGHT;
    layout.kind = LAYOUT_ONE_PANE;
    if (whole || !roomy || !screen->lesson->open || !screen->lesson->lesson ||
        !lay_out_page(screen, width, height, &layout)) {
        const RunState state = screen->playback->state;
        const bool plot = screen_view_in(screen, focus) != NULL;
        const bool numbers = experiment_stage(screen->experiment) > 0 || state == STATE_ENDED ||
                             state == STATE_FAILED || screen_second_run(screen); /* that no plot has */
        const bool box = !whole && roomy && (plot || focus == PANE_MESH) && numbers;
        const int rows = height - 2 - (box ? BOX_ROWS : 0);
        layout.panes[focus] = (Rect){0, 1, width, rows};
        if (box)
            layout.panes[PANE_BOX] = (Rect){0, 1 + rows, width, BOX_ROWS};
        if (!whole && width >= PAIR_WIDTH && height >= PAIR_HEIGHT && plot) {
            layout.panes[PANE_UPPER] = (Rect){0, 1, width, rows / 2};
            layout.panes[PANE_LOWER] = (Rect){0, 1 + rows / 2, width, rows - rows / 2};
        }
    }
    return layout;
}

bool screen_is_whole(const Screen *screen, int width, int height)
{
    Layout layout = {.kind = LAYOUT_TOO_SMALL};
    if (screen_is_plain(screen))
        return layout_plain(screen, width, height, &layout);
    return width >= FULL_WIDTH && height >= FULL_HEIGHT;
}

Rect screen_pane(const Screen *screen, int width, int height, PaneId pane)
{
    Layout layout = layout_make(screen, width, height);
    return pane < PANE_COUNT ? layout.panes[pane] : (Rect){0};
}
