/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Where a body lies in its picture, and lines and signs over it. What it leaves free for its motion, its
 * supports and the names of its lines is decided here, once for all that draw it. */
#include "picture/picture.h"

#include <math.h>

#define LEAST_ROWS    2.0 /* a body is stretched that would have fewer */
#define SLENDER_PART  0.4 /* of the height for a stretched one; the rest is for its motion */
#define TALL_PART     0.82
#define BENT_PART     0.08
#define MOST_ENLARGED 1e9
#define NODE_COLUMNS  3.0 /* from that distance on pieces are drawn one by one */

enum { KEYS_ROOM = 19, KEYS_ROWS = 4, SIGN_ROWS = 2, WALL_ROWS = 2, SPREAD = 4 };

/* By number: what neighbours have is distinguished. */
Style picture_kind_style(int kind)
{
    static const Style styles[] = {STYLE_MEASURED, STYLE_PREDICTED, STYLE_SECOND,  STYLE_EXACT,
                                   STYLE_THIRD,    STYLE_GHOST_A,   STYLE_GHOST_C, STYLE_GHOST_D};
    return styles[kind % (int)(sizeof styles / sizeof *styles)];
}

int picture_map_step(const PictureMap *map, double value, int steps)
{
    if (map->kinds)
        return (int)value;
    const int step = (int)floor((value - map->low) / (map->high - map->low) * steps);
    return step < 0 ? 0 : step >= steps ? steps - 1 : step;
}

/* The factor that fills the room beside the body with the largest displacement of the run. */
static double choose_enlargement(const PictureMap *map, const BodyRoom *room, double height, double rows)
{
    if (room->enlarged > 0)
        return fmin(room->enlarged, MOST_ENLARGED);
    const double reach = room->reach > 0 ? axis_round_up(room->reach) : 0;
    double free = fmax(0.5, (height - rows) / 2 - 0.5);
    /* a deep beam keeps its shape, and a crack its angle */
    if (room->pressed)
        free = fmin(free, BENT_PART * rows);
    const double factor = reach > 0 ? free / (reach * map->scale[1]) : 1;
    return factor > 1 ? axis_step_down(factor) : 1;
}

/* A part of it, what is looked at in the middle while it moves. */
static void magnify(Picture *picture, const BodyRoom *room, double rows)
{
    PictureMap *map = picture->map;
    const double height = picture->body[1];
    map->is_part = true;
    map->scale[0] *= room->magnified;
    rows *= room->magnified;
    const double stretch = rows < SLENDER_PART * height ? axis_step_down(SLENDER_PART * height / rows) : 1;
    picture->stretch = stretch < picture->stretch ? stretch : picture->stretch;
    map->scale[1] = map->scale[0] / 2 * picture->stretch;
    map->is_near = room->spacing * map->scale[0] >= NODE_COLUMNS && picture->stretch <= 1;
    if (map->is_near && room->on_mesh && room->enlarged <= 0)
        map->enlarged = map->along = 1;
    map->middle[0] = room->eye[0] + map->along * room->moved[0];
    map->middle[1] = room->eye[1] + map->enlarged * room->moved[1];
}

/* With ticks that are round in millimetres, or in its own unit. */
static Axis axis_with_limits(double low, double high, int most, bool millimetres)
{
    const double scale = millimetres ? 1e3 : 1;
    Axis axis = axis_with_ticks(axis_make(scale * low, scale * high), most);
    axis.low = low;
    axis.high = high;
    axis.step *= millimetres ? 1e-3 : 1;
    axis.exponent -= millimetres ? 3 : 0;
    return axis;
}

void picture_lay_body(Picture *picture, const BodyRoom *room)
{
    PictureMap *map = picture->map;
    const int width = picture->body[0], height = picture->body[1];
    /* a body on its way moves across the picture, which stays */
    const double length = room->size[0] + room->travel;
    map->scale[0] = (width - (room->in_box ? 2 * WALL_ROWS : 0)) / length;
    double rows = room->size[1] * map->scale[0] / 2;
    const double most = room->in_box
                            ? fmax(1, height - WALL_ROWS)
                            : fmax(1, fmin(TALL_PART * height, room->pressed ? height - SIGN_ROWS : height));
    if (rows > most) {
        map->scale[0] *= most / rows;
        rows = most;
    }
    picture->stretch = 1;
    if (!room->in_box && rows < LEAST_ROWS && SLENDER_PART * height > rows)
        picture->stretch = fmax(1, axis_step_down(SLENDER_PART * height / rows));
    map->scale[1] = map->scale[0] / 2 * picture->stretch;
    map->enlarged = room->in_box ? 1 : choose_enlargement(map, room, height, rows * picture->stretch);
    map->along = room->travels ? 1 : map->enlarged;
    map->middle[0] = room->low[0] + length / 2;
    map->middle[1] = room->low[1] + room->size[1] / 2;
    /* one that leaves much of the room free stands at the left, the names of its lines beside it */
    const int columns = (int)ceil(length * map->scale[0]);
    if (room->magnified > 1) {
        magnify(picture, room, rows);
    } else if (room->pressed && width - columns >= KEYS_ROOM && height >= KEYS_ROWS + SIGN_ROWS) {
        map->keys_at = columns + 2;
        map->middle[0] += (width - columns - 1) / 2.0 / map->scale[0];
    }
    /* What is seen: as much as on the screen; a pressed body fills the picture but for supports. */
    double low[2], high[2];
    for (int d = 0; d < 2; d++) {
        const double half = picture->body[d] / 2.0 / map->scale[d],
                     margin = (d == 0 ? 0.01 : 0.1) * room->size[d];
        const bool fills = room->pressed && !map->is_part;
        low[d] = fills ? room->low[d] - margin : map->middle[d] - half;
        high[d] = fills ? room->low[d] + room->size[d] + margin : map->middle[d] + half;
    }
    const char *unit = room->in_box ? "" : "m";
    picture_axes(picture, axis_with_limits(low[0], high[0], width / 9, !room->in_box), "x", unit,
                 axis_with_limits(low[1], high[1], 5, !room->in_box), "y", unit);
}

bool picture_in_sight(const Picture *picture, double x, double y, double margin)
{
    const PictureMap *map = picture->map;
    return fabs(x - map->middle[0]) <= picture->body[0] / 2.0 / map->scale[0] + margin &&
           fabs(y - map->middle[1]) <= picture->body[1] / 2.0 / map->scale[1] + margin;
}

void picture_trace(Picture *picture, const double from[2], const double to[2], const Stroke *pen)
{
    Plot *plot = &picture->plot;
    const Stroke *last = plot->n_strokes > 0 ? &plot->strokes[plot->n_strokes - 1] : NULL;
    const bool same = last && last->style == pen->style && last->line == pen->line &&
                      last->rank == pen->rank && last->letter == pen->letter && last->wall == pen->wall &&
                      last->coarse == pen->coarse;
    if (!same) {
        plot_begin(plot, STROKE_LINE, (Pen){pen->line, pen->letter, pen->style, pen->rank, 0});
        plot->strokes[plot->n_strokes - 1].wall = pen->wall;
        plot->strokes[plot->n_strokes - 1].coarse = pen->coarse;
        plot_point(plot, from[0], from[1]);
    } else if (plot->n_points > 0 && (plot->points[2 * plot->n_points - 2] != from[0] ||
                                      plot->points[2 * plot->n_points - 1] != from[1])) {
        plot_point(plot, NAN, NAN);
        plot_point(plot, from[0], from[1]);
    }
    plot_point(plot, to[0], to[1]);
}

void picture_spread(Picture *picture, const double from[2], const double to[2], const double scale[2],
                    const PictureMark *mark)
{
    const double length = fmax(fabs(to[0] - from[0]) * scale[0], 2 * fabs(to[1] - from[1]) * scale[1]);
    const int count = length < 1e4 ? 1 + (int)(length / SPREAD) : 1;
    for (int i = 0; i <= count; i++) {
        PictureMark one = *mark;
        const double share = (double)i / count;
        one.x = from[0] + share * (to[0] - from[0]);
        one.y = from[1] + share * (to[1] - from[1]);
        picture_add_mark(picture, one);
    }
}

/* Characters for the words beside it; rows that it keeps to (0: takes all); columns of one of its pieces. */
static const struct {
    int words, rows, least, most;
} strips[] = {[STRIP_CELLS] = {25, 4, 2, 6}, [STRIP_NODES] = {22, 3, 1, 4}, [STRIP_BODY] = {25, 0, 0, 0}};

void picture_lay_strip(Picture *picture, StripKind strip, const char *heading)
{
    const int rows = strips[strip].rows;
    enum { HEADED = 4, TALL = 7, MARGINS = 3 };
    const bool headed = picture->rows >= HEADED;
    picture->kind = PICTURE_STRIP;
    picture->strip = strip;
    picture->bare = true;
    picture_heading(picture, "%s", headed ? heading : "");
    picture->body[0] = picture->columns - strips[strip].words - MARGINS;
    picture->body[1] = rows > 0 && picture->rows >= TALL ? rows : picture->rows - headed;
}

void picture_lay_row(const Picture *picture, StripRow *row)
{
    const int least = strips[picture->strip].least, most = strips[picture->strip].most;
    const long all = row->pieces + row->beyond, room = picture->body[0] - row->aside;
    const long per = all > 0 ? room / all : 0;
    row->per = (int)(per < most ? per : most);
    row->first = 0;
    row->shown = all;
    if (per >= least)
        return;
    row->per = least;
    row->shown = room > 0 ? room / row->per : 0;
    const long last = row->shown < row->pieces ? all - row->shown : 0, first = row->around - row->shown / 2;
    row->first = first > last ? last : first > 0 ? first : 0;
}

#define WORTH_IT 0.6 /* of the width: a drawing to scale may lose so much, else its height is squeezed */
#define APART    1.3 /* rows from one length to the next where there is room between rows */

enum { MARGIN_RIGHT = 11, DRAWN_LEAST = 3, COLUMNS_LEAST = 20, WORDS_ROW = 1 };

bool picture_lay_drawing(Picture *picture, DrawingRoom *room)
{
    const int columns = picture->columns - 2 - MARGIN_RIGHT;
    room->scale = columns / room->size[0];
    bool fits = columns >= COLUMNS_LEAST;
    if (fits && picture->whole) {
        /* In rows below the heading. False: there are too few. */
        const int most = picture->rows - 1 - 2 * room->around;
        while (room->lengths > 1 && room->lengths + DRAWN_LEAST > most - 1)
            room->lengths--;
        const int rows = most - room->lengths - (most > room->lengths + DRAWN_LEAST ? WORDS_ROW : 0);
        const double wanted = room->size[1] * room->scale / 2;
        if (wanted > rows - 1 && wanted * WORTH_IT < rows - 1)
            room->scale *= (rows - 1) / wanted;
        room->top = -1 - room->around;
        room->bottom =
            room->top - fmin(fmax(round(room->size[1] * room->scale / 2), DRAWN_LEAST - 1), rows - 1);
        room->apart = 1;
        fits = rows >= DRAWN_LEAST;
    } else if (fits) {
        /* With as much height as it takes. */
        room->top = -room->around - 0.5;
        room->bottom = room->top - fmax(room->size[1] * room->scale / 2, DRAWN_LEAST - 1);
        room->apart = APART;
    }
    if (!fits) {
        picture_say(picture, "drawing", "%s",
                    picture->whole ? "z gives the drawing the room that it needs" : "it needs a wider page");
        return false;
    }
    room->stretch = (room->top - room->bottom) / (room->size[1] * room->scale / 2);
    const double end = room->bottom - 1 - room->around - room->apart * (room->lengths - 1);
    picture->kind = PICTURE_MAP;
    picture_axes(picture, axis_with_ticks(axis_make(0, picture->columns), 2), "", "",
                 axis_with_ticks(axis_make(picture->whole ? end - 1 : end - 0.5, 0), 2), "", "");
    picture->bare = true;
    picture->stretch = 2; /* rows, columns */
    return true;
}
