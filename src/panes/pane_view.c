/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A view in its pane: its picture in cells, of two runs as it likes; and what keys and the mouse find there,
 * which the picture says, whichever view it is of. */
#include "panes/panes.h"
#include "views/inspector/inspector.h"
#include "views/view.h"
#include "lessons/lesson_shown.h"
#include "run/duel.h"
#include "run/playback.h"

#include <stdio.h>
#include <string.h>

void pane_view_variant(const View *view, const Screen *screen, Area area, Style heading, int variant)
{
    Picture picture;
    cells_open(&picture, area.rect.width, area.rect.height, area.glyphs);
    view->describe(screen, variant, &picture);
    picture.of_side = screen_second_run(screen) != NULL;
    if (screen_is_plain(screen) && !screen->lesson->open && !picture.map &&
        picture.kind != PICTURE_STRIP) /* one number is in large digits, below */
        picture.n_notes = 0;
    cells_draw(&picture, area, heading, screen->look.colours);
    picture_close(&picture);
}

/* The picture of one run of a duel. */
static void draw_side(const View *view, const Screen *screen, DuelSide side, const char *note, Area area,
                      Style heading)
{
    const Screen one = screen_of_side(screen, side);
    pane_view_variant(view, &one, area, heading, view_variant(view, &one));
    if (view->duel != DUEL_IN_AXES || view->names_run) {
        /* Whose picture it is stands at the end of its heading, in as few words as there is room for. */
        const char letter = side == SIDE_A ? 'A' : 'B';
        char names[3][DUEL_NAME_MAX + 32];
        int end = area.rect.width - 1; /* the heading's words */
        while (end > 0) {
            const uint32_t glyph =
                area.canvas->cells[area.rect.y * area.canvas->width + area.rect.x + end].glyph;
            if (glyph != 0x2500 && glyph != ' ' && glyph != '-')
                break;
            end--;
        }
        snprintf(names[0], sizeof names[0], " %c %s%s ", letter, screen->duel->names[side == SIDE_B], note);
        snprintf(names[1], sizeof names[1], " %c%s ", letter, note);
        snprintf(names[2], sizeof names[2], " %c ", letter);
        int form = 0;
        while (form < 2 && end + glyphs_columns(names[form]) + 1 > area.rect.width - 1)
            form++;
        area_text_right(area, area.rect.width - 1, 0, names[form],
                        side == SIDE_A ? STYLE_MEASURED : STYLE_SECOND);
    }
}

/* A figure has one pair of axes. */
void view_describe(const View *view, const Screen *screen, int columns, int rows, Picture *picture)
{
    enum { PLOT_LEAST = 1 };
    const Screen one = screen_is_shared(screen) ? screen_of_side(screen, SIDE_A) : *screen;
    const Screen *shown = view->duel == DUEL_APART ? &one : screen;
    const int variant = view_variant(view, shown);
    cells_open(picture, columns, rows, GLYPHS_NONE);
    view->describe(shown, variant, picture);
    if (picture->across == 0 || rows - 2 < PLOT_LEAST) { /* then the page is to blame */
        picture->has_axes = false;
        picture->n_notes = 0;
    }
    picture->of_moment = view->home != PANE_LOWER;
    if (!picture->time[0])
        strcpy(picture->time, screen_time_text(screen, experiment_time(screen->experiment)).text);
    cells_fit(picture, rows);
}

void pane_view(const View *view, const Screen *screen, Area area, bool focused)
{
    const Style heading = focused ? STYLE_FOCUS : STYLE_HEADING;
    if (area.rect.width < 1 || area.rect.height < 1)
        return;
    enum { STACK_HEIGHT = 14 };
    const int width = area.rect.width, height = area.rect.height, left = (width - 1) / 2;
    const bool wide = area.canvas->width >= SIDE_BY_SIDE;
    if (!screen_is_shared(screen) || view->duel == DUEL_TOGETHER || (view->duel == DUEL_IN_AXES && !wide)) {
        pane_view_variant(view, screen, area, heading, view_variant(view, screen));
    } else if (wide) {
        draw_side(view, screen, SIDE_A, "", area_part(area, 0, 0, left, height), heading);
        draw_side(view, screen, SIDE_B, "", area_part(area, left + 1, 0, width - left - 1, height), heading);
    } else if (height >= STACK_HEIGHT) {
        draw_side(view, screen, SIDE_A, "", area_part(area, 0, 0, width, height / 2), heading);
        draw_side(view, screen, SIDE_B, "", area_part(area, 0, height / 2, width, height - height / 2),
                  heading);
    } else {
        draw_side(view, screen, SIDE_A, screen->panes.zoomed ? "" : ", z: and B", area, heading);
    }
}

void pane_inspector(const Screen *screen, Area area)
{
    Picture picture;
    cells_open(&picture, area.rect.width, area.rect.height, area.glyphs);
    view_inspector.describe(screen, 0, &picture);
    cells_draw(&picture, area, screen->panes.focus == PANE_INSPECTOR ? STYLE_FOCUS : STYLE_HEADING,
               screen->look.colours);
    const Rect below = cells_below(&picture, area.rect);
    if (below.height > 0) {
        /* Where the node of a family lies: the whole beam, small, below it. */
        const Area small = {area.canvas, below, area.glyphs};
        static const Playback paused = {.state = STATE_PAUSED}; /* the node that is inspected is shown */
        Screen whole = *screen;
        whole.eye.magnified = 1;
        whole.playback = &paused;
        Picture map;
        cells_open(&map, small.rect.width + 2, small.rect.height + 2, small.glyphs);
        if (view_map_small(&whole, &map))
            cells_map_body(&map, small, screen->look.colours);
        picture_close(&map);
    }
    picture_close(&picture);
}

/* --- keys and mouse ---------------------------------------------------------------------------------- */

static void describe_in(const View *view, const Screen *screen, Rect rect, Picture *picture)
{
    cells_open(picture, rect.width, rect.height, screen->look.glyphs);
    view->describe(screen, view_variant(view, screen), picture);
}

/* It becomes the chosen one of all panes. */
static void choose(Screen *screen, PictureThing thing)
{
    *(thing.set == 0 ? &screen->chosen.particle : &screen->chosen.node) = thing.index;
    screen->chosen.is_node = thing.set == 1;
}

/* An event becomes that of the log: the newest one is followed. */
static void choose_row(Screen *screen, const PictureList *list, size_t row)
{
    if (list->set < 0) {
        screen->log.event = row + 1 < list->count ? (int)row : -1;
        return;
    }
    choose(screen, (PictureThing){list->set, row});
}

void view_move(const View *view, Screen *screen, Rect rect, int x, int y, int page)
{
    Picture picture;
    describe_in(view, screen, rect, &picture);
    const PictureList *list = picture.list;
    if (list && list->set < 0 && list->count > 0 && rect.width > 0)
        screen->log.first = (int)cells_top(&picture, rect);
    if (list && list->count > 0 && (list->set >= 0 || (y != 0 && rect.width > 0))) {
        const long to = (long)list->chosen + (long)y * page, last = (long)list->count - 1;
        choose_row(screen, list, to < 0 ? 0 : (size_t)(to < last ? to : last));
    }
    if (list && y == 0 && list->chosen_column >= 0 && rect.width > 0) {
        const int to = list->chosen_column + x, last = list->n_columns - 1;
        screen->chosen.table_column = to < 0 ? 0 : to < last ? to : last;
    }
    picture_close(&picture);
}

/* Where a bond broke is what one wants to look at. */
long view_enter(const View *view, Screen *screen, char follow[FOLLOW_TEXT_MAX])
{
    Picture picture;
    describe_in(view, screen, (Rect){0, 0, 0, 0}, &picture);
    const long step = picture.step;
    const long broken = picture.list && step >= 0 ? inspector_broken_node(screen, step) : -1;
    snprintf(follow, FOLLOW_TEXT_MAX, "%s", picture.follow);
    picture_close(&picture);
    if (broken >= 0) {
        screen->chosen.particle = (size_t)broken;
        screen->chosen.is_node = false;
    }
    return step;
}

bool view_click(const View *view, Screen *screen, Rect rect, int x, int y)
{
    Picture picture;
    if (!rect_holds(rect, x, y))
        return false;
    describe_in(view, screen, rect, &picture);
    const long row = picture.list ? cells_row(&picture, rect, x, y) : -1;
    PictureThing thing = {.set = -1}; /* nothing */
    if (!picture.list && picture.kind == PICTURE_TABLES) {
        thing = cells_thing(&picture, rect, x, y);
    } else if (!picture.list) {
        const long piece = picture.map ? cells_map_piece(&picture, rect, x, y) : -1;
        const PictureMark *mark = picture.map ? NULL : cells_target(&picture, rect, x, y);
        thing = mark ? mark->thing : piece >= 0 ? (PictureThing){0, (size_t)piece} : thing;
    }
    if (row >= 0 && picture.list->set < 0)
        screen->log.first = (int)cells_top(&picture, rect);
    if (row >= 0)
        choose_row(screen, picture.list, (size_t)row);
    if (thing.set >= 0)
        choose(screen, thing);
    picture_close(&picture);
    return row >= 0 || thing.set >= 0;
}

/* Events alone are many enough to be looked through; of things the wheel chooses the next one. */
bool view_scroll(const View *view, Screen *screen, Rect rect, int x, int y, int by)
{
    Picture picture;
    size_t top;
    if (!view->is_list || !rect_holds(rect, x, y) || y == rect.y)
        return false;
    describe_in(view, screen, rect, &picture);
    const bool is_log = picture.list && picture.list->set < 0 && picture.list->count > 0;
    if (is_log) {
        choose_row(screen, picture.list, cells_scroll(&picture, rect, by, &top));
        screen->log.first = (int)top;
    }
    picture_close(&picture);
    return is_log;
}

/* --- places of a map --------------------------------------------------------------------------------- */

/* The map in the pane that shows it. False: none does. */
static bool open_map(const Screen *screen, int width, int height, Rect *rect, Picture *picture)
{
    const View *map = view_of_map();
    if (screen->views.upper != map && screen->views.lower != map)
        return false;
    *rect = screen_pane(screen, width, height, screen->views.upper == map ? PANE_UPPER : PANE_LOWER);
    describe_in(map, screen, *rect, picture);
    if (!picture->map)
        picture_close(picture);
    return picture->map;
}

double view_map_enlargement(const Screen *screen, int width, int height)
{
    Picture picture;
    Rect rect;
    if (!open_map(screen, width, height, &rect, &picture))
        return 0;
    const double factor = picture.map->enlarged;
    picture_close(&picture);
    return factor;
}

bool view_map_place(const Screen *screen, int width, int height, int x, int y, double place[2])
{
    Picture picture;
    Rect rect;
    if (!open_map(screen, width, height, &rect, &picture))
        return false;
    const bool is_there = cells_map_place(&picture, rect, x, y, place);
    picture_close(&picture);
    return is_there;
}
