/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Where panes lie on the plain sheet: in one column below 80 columns; else one large picture, above it the
 * strip of particles, below it what is asked, the number that the scenario is about and the parameters that
 * it asks about. Beside a lesson the text and the picture; in the middle of a step, where a run has failed,
 * and for a user who has asked what is wrong with a code of his own, the box that tells of it. */
#include "panes/panes.h"
#include "views/view.h"
#include "lessons/lesson_shown.h"
#include "run/playback.h"

enum {
    LEAST_WIDTH = 60,
    LEAST_HEIGHT = 18,
    STACKED_WIDTH = 80,      /* below it a screen that is high, as a telephone's, has one column */
    STACKED_LEAST = 36,      /* columns */
    STACKED_HEIGHT = 30,     /* of one that could have two */
    LESSON_LEAST_WIDTH = 80, /* a text wants a column of its own */
    LESSON_LEAST_HEIGHT = 20,
    ASKED_WIDTH = 34,
    ASKED_MOST = 40,
    PICTURE_LEAST = 6,
    DRAWING_ROWS = 15 /* with the sums of a stage below it */
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
    return screen_view_in(screen, picture_of(screen))->is_map ? 0 : layout_strip_rows(height);
}

/* A drawing of one thing has the terms of its stage by itself. */
static int box_rows(const Screen *screen, int height, bool wide)
{
    const bool inside = experiment_stage(screen->experiment) > 0 || experiment_before(screen->experiment);
    const bool speaks = (inside && !wide) || screen->playback->state == STATE_FAILED || screen->diagnosis[0];
    return speaks ? layout_box_rows(screen, height, false) : 0;
}

/* In one column: the picture, or over it what one thing gives and takes. */
static void lay_out_picture(const Screen *screen, Rect rect, Layout *layout)
{
    layout->panes[screen->panes.inspecting ? PANE_INSPECTOR : picture_of(screen)] = rect;
}

/* A drawing across the whole screen under the text; the strip of all particles would show it once more.
 * False: the text leaves it no room. */
static bool lay_out_wide(const Screen *screen, int width, int height, Layout *layout)
{
    const int box = box_rows(screen, height, true), rows = height - 2 - box;
    const int text = pane_lesson_rows(screen, width, rows - DRAWING_ROWS), picture = rows - text;
    if (!screen_view_in(screen, picture_of(screen))->is_wide || screen->panes.inspecting ||
        !screen->lesson->lesson || picture < PICTURE_LEAST)
        return false;
    layout->panes[PANE_PARAMETERS] = (Rect){0, 1, width, text};
    lay_out_picture(screen, (Rect){0, 1 + text, width, picture}, layout);
    layout->panes[PANE_BOX] = (Rect){0, 1 + text + picture, box ? width : 0, box};
    return true;
}

static void lay_out_lesson(const Screen *screen, int width, int height, Layout *layout)
{
    if (lay_out_wide(screen, width, height, layout))
        return;
    const int strip = strip_rows(screen, height), box = box_rows(screen, height, false);
    const int top = 1 + strip, middle = height - 2 - strip - box;
    const int text = layout_lesson_width(width), left = text + 1;
    const int number =
        screen->panes.lecture && screen->lesson->lesson ? pane_number_rows(screen, width, height) : 0;
    layout->panes[PANE_MESH] = (Rect){0, 1, strip ? width : 0, strip};
    layout->panes[PANE_PARAMETERS] = (Rect){0, top, text, middle};
    if (number && middle - number >= PICTURE_LEAST)
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
    const int below = asked > number ? asked : number, question = pane_question_rows(screen, width);
    int strip = strip_rows(screen, height), box = box_rows(screen, height, false);
    int middle = height - 2 - strip - box - question - below;
    if (middle < PICTURE_LEAST) /* in a step its numbers are worth more than the picture of all particles */
        middle += strip, strip = 0;
    if (middle < PICTURE_LEAST)
        middle += box, box = 0;
    const int top = 1 + strip, end = top + middle + box;
    layout->panes[PANE_MESH] = (Rect){0, 1, strip ? width : 0, strip};
    lay_out_picture(screen, (Rect){0, top, width, middle}, layout);
    layout->panes[PANE_BOX] = (Rect){0, top + middle, box ? width : 0, box};
    layout->question = (Rect){0, end, question ? width : 0, question};
    layout->number = (Rect){0, end + question, width - fields - 1, below};
    layout->panes[PANE_PARAMETERS] = (Rect){width - fields - 1, end + question, fields, below};
}

/* In one column: what is asked, the bar or the map, the plot, the number and the parameters, as rows allow.
 */
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

bool layout_plain(const Screen *screen, int width, int height, Layout *layout)
{
    const bool lesson = screen->lesson->open;
    if (!lesson && width < STACKED_WIDTH && width >= STACKED_LEAST &&
        height >= (width < LEAST_WIDTH ? LEAST_HEIGHT : STACKED_HEIGHT)) {
        layout->kind = LAYOUT_FULL;
        lay_out_stacked(screen, width, height, layout);
        return true;
    }
    if (width < (lesson ? LESSON_LEAST_WIDTH : LEAST_WIDTH) ||
        height < (lesson ? LESSON_LEAST_HEIGHT : LEAST_HEIGHT))
        return false;
    layout->kind = LAYOUT_FULL;
    (lesson ? lay_out_lesson : lay_out_scenario)(screen, width, height, layout);
    return true;
}
