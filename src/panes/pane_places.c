/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Where rows of fields and lines of a lesson lie on the screen: for the mouse, and for how far a text can be
 * scrolled. Apart from the panes that draw them, which the layout asks how much room they need. */
#include "panes/panes.h"
#include "lessons/lesson_shown.h"
#include "panes/screen_places.h"

int screen_lesson_at(const Screen *screen, int width, int height, int x, int y)
{
    const Rect pane = screen_pane(screen, width, height, PANE_PARAMETERS);
    Canvas none = {.width = width, .height = height};
    const Area area = {&none, pane, screen->look.glyphs};
    const bool inside = x >= pane.x && x < pane.x + pane.width && y > pane.y && y < pane.y + pane.height - 1;
    if (!screen->lesson->open || screen->lesson->lesson || !inside)
        return -1;
    return pane_lesson_at(screen, area, y - pane.y);
}

int screen_lesson_most(const Screen *screen, int width, int height)
{
    const Rect pane = screen_pane(screen, width, height, PANE_PARAMETERS);
    if (!screen->lesson->open || pane.width == 0)
        return 0;
    const int most = pane_lesson_rows(screen, pane.width, pane.height) - pane.height;
    return most > 0 ? most : 0;
}

int screen_parameter_at(const Screen *screen, int width, int height, int x, int y)
{
    ParameterRow rows[PARAMETER_ROWS_MAX];
    const Rect pane = screen_pane(screen, width, height, PANE_PARAMETERS);
    if (screen->lesson->open)
        return -1;
    const int count = screen_parameter_rows(screen, rows), room = pane.height - 1;
    if (x < pane.x || x >= pane.x + pane.width || y < pane.y || y >= pane.y + room)
        return -1;
    const int row = pane_parameters_first(screen->parameters, count, room) + y - pane.y;
    return row < count && !rows[row].heading ? row : -1;
}
