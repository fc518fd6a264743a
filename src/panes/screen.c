/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The whole screen: each pane drawn where the layout puts it, and what the mouse finds in the plot panes. */

#include "lessons/lesson_shown.h"
#include "panes/panes.h"
#include "run/playback.h"
#include "scenario/concern_output.h"
#include "views/view.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static const Screen nothing = {
    .parameters = &(const ParametersShown){.selected = 0},
    .help = &(const HelpShown){.open = false},
    .playback = &(const Playback){.state = STATE_PAUSED, .pace = 1},
    .bookmarks = &(const Bookmarks){.count = 0},
    .lesson = &(const LessonShown){.open = false},
    .prompt = &(const Prompt){.open = false},
    .message = &(const Message){.kind = MESSAGE_NONE},
    .used = &(const CommandSet){.words = {0}},
    .diagnosis = "",
    .look = {.glyphs = GLYPHS_BRAILLE, .colours = 256},
    .panes = {.focus = PANE_PARAMETERS, .last_plot = PANE_LOWER},
    .time = {.cursor = NAN},
    .eye = {.magnified = 1, .centre = {0.5, 0.5}},
    .log = {.event = -1},
};

void screen_default(Screen *screen)
{
    *screen = nothing;
    screen->views.upper = view_at_home(PANE_UPPER, NULL);
    screen->views.lower = view_at_home(PANE_LOWER, NULL);
}

void screen_read_view(Screen *screen, const ViewSettings *view)
{
    double window;
    if (sscanf(view->window, "%lf", &window) == 1 && window > 0)
        screen->time.window = window;
    for (int i = 0; i < SHOW_COUNT; i++)
        if (strcmp(view->references, parameter_reference_words[i]) == 0)
            screen->views.references = (ReferencesShown)i;
    const int sheet = text_place_in(view->sheet, parameter_sheet_words);
    if (sheet >= 0)
        screen->panes.sheet = (Sheet)sheet;
    const View *map = view_of_map();
    const int colour = view_variant_named(map, screen, view->colour);
    if (colour >= 0)
        view_choose_variant(map, screen, colour);
}

/* --- the whole ------------------------------------------------------------------------------------ */

static Area area_of(const Screen *screen, Canvas *canvas, Rect rect)
{
    return area_part((Area){canvas, {0, 0, canvas->width, canvas->height}, screen->look.glyphs}, rect.x,
                     rect.y, rect.width, rect.height);
}

static void draw_pane(const Screen *screen, PaneId pane, Area area)
{
    if (area.rect.width < 1 || area.rect.height < 1)
        return;
    if (pane == PANE_BOX)
        pane_box(screen, area);
    else if (pane == PANE_INSPECTOR)
        pane_inspector(screen, area);
    else if (pane != PANE_PARAMETERS)
        pane_view(pane == PANE_MESH ? &view_strip : screen_view_in(screen, pane), screen, area,
                  screen->panes.focus == pane);
    else if (screen->lesson->open)
        pane_lesson(screen, area);
    else if (screen_is_plain(screen) &&
             (area.rect.width < area.canvas->width || area.rect.height <= pane_asked_rows(screen)))
        pane_asked(screen, area);
    else
        pane_parameters(screen, area);
}

void screen_draw(const Screen *screen, Canvas *canvas)
{
    canvas_clear(canvas);
    canvas->large = screen->panes.lecture;
    const Layout layout = layout_make(screen, canvas->width, canvas->height);
    if (layout.kind == LAYOUT_TOO_SMALL) {
        char text[64];
        snprintf(text, sizeof text, "matvib needs 40x12, this is %dx%d", canvas->width, canvas->height);
        Area whole = {canvas, {0, 0, canvas->width, canvas->height}, GLYPHS_ASCII};
        int lines = area_paragraph_lines(canvas->width, text), y = (canvas->height - lines) / 2;
        y = y > 0 ? y : 0;
        area_paragraph(whole, 0, y, canvas->width, canvas->height - y, text, STYLE_NORMAL);
    } else if (screen->help->open) {
        help_draw(screen, area_of(screen, canvas, (Rect){0, 1, canvas->width, canvas->height - 2}));
    } else {
        if (layout.question.width > 0)
            pane_question(screen, area_of(screen, canvas, layout.question));
        if (layout.number.width > 0)
            pane_number(screen, area_of(screen, canvas, layout.number));
        for (int pane = 0; pane < PANE_COUNT; pane++)
            draw_pane(screen, (PaneId)pane, area_of(screen, canvas, layout.panes[pane]));
        if (layout.timeline.width > 0)
            pane_timeline(screen, area_of(screen, canvas, layout.timeline));
        if (layout.sides[0].width > 0)
            pane_view_variant(&view_energies, screen, area_of(screen, canvas, layout.sides[0]), STYLE_HEADING,
                              0);
        for (int i = 1; i < SIDES_MAX; i++)
            if (layout.sides[i].width > 0)
                pane_view_variant(&view_table, screen, area_of(screen, canvas, layout.sides[i]),
                                  STYLE_HEADING, i - 1);
    }
    if (layout.kind != LAYOUT_TOO_SMALL) {
        pane_title(screen, area_of(screen, canvas, layout.title));
        pane_keys(screen, area_of(screen, canvas, layout.keys));
    }
    if (screen->look.glyphs == GLYPHS_ASCII)
        canvas_to_ascii(canvas, false);
}

/* --- views ------------------------------------------------------------------------------------------- */

bool screen_click_view(Screen *screen, int width, int height, int x, int y)
{
    if (screen->panes.inspecting &&
        view_click(&view_inspector, screen, screen_pane(screen, width, height, PANE_INSPECTOR), x, y))
        return true;
    for (PaneId pane = PANE_UPPER; pane <= PANE_LOWER; pane++)
        if (view_click(screen_view_in(screen, pane), screen, screen_pane(screen, width, height, pane), x, y))
            return true;
    return view_click(&view_strip, screen, screen_pane(screen, width, height, PANE_MESH), x, y);
}

bool screen_scroll_view(Screen *screen, int width, int height, int x, int y, int by)
{
    for (PaneId pane = PANE_UPPER; pane <= PANE_LOWER; pane++)
        if (view_scroll(screen_view_in(screen, pane), screen, screen_pane(screen, width, height, pane), x, y,
                        by))
            return true;
    return false;
}

/* --- where rows of fields and lines of a lesson lie ----------------------------------------------- */

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
