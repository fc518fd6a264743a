/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The beam before it moves, as in the papers' figures of the problems: dimensions in mm, supports, channel,
 * notch, load, probe; of a plate its cuts, regions by their names, loads with their size. In characters, y
 * upwards from the picture's upper edge: how many to a metre is found in picture/body.c. */
#include "views/map/map.h"

#include "base/math/functions.h"
#include "scenario/concern_body.h"
#include "scenario/concern_loads.h"
#include "scenario/rows/rows.h"
#include "scenario/settings.h"
#include "base/text.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { LENGTHS_MAX = 4 };

/* A length between two places, with its row below the beam. */
typedef struct Length {
    double from, to; /* m */
    int row;
} Length;

typedef struct Drawing {
    const Settings *settings;
    MapScene scene;
    Body body;
    Picture *picture;
    DrawingRoom room;
    Length lengths[LENGTHS_MAX];
    int n_lengths;
} Drawing;

/* --- places, lines, words ----------------------------------------------------------------------------- */

static double rounded(const Drawing *drawing, double place)
{
    return drawing->picture->whole ? round(place) : place;
}

static double column_of(const Drawing *drawing, double x)
{
    return rounded(drawing, 1 + (x - drawing->body.low[0]) * drawing->room.scale);
}

static double row_of(const Drawing *drawing, double share) /* of the height */
{
    const DrawingRoom *room = &drawing->room;
    return room->bottom + rounded(drawing, share * (room->top - room->bottom));
}

static void trace(const Drawing *drawing, StrokeKind kind, Style style, int count, const double (*places)[2])
{
    Plot *plot = &drawing->picture->plot;
    /* a band is at most as dark as the body's outline */
    plot_begin(plot, kind, (Pen){LINE_SOLID, '|', style, RANK_EXACT, kind == STROKE_BAND ? 2 : 0});
    for (int i = 0; i < count; i++)
        plot_point(plot, places[i][0], places[i][1]);
}

static void label_length(const Drawing *drawing, double x, double y, int side, double metres)
{
    picture_label(drawing->picture, x, y, side, STYLE_NORMAL, "%s mm", text_rounded(1e3 * metres, 4).text);
}

static void put(const Drawing *drawing, double x, double y, MarkKind kind, int up, uint32_t glyph)
{
    const Style style = glyph == 0x25cf ? STYLE_MEASURED : STYLE_HEADING;
    picture_add_mark(drawing->picture, (PictureMark){x, y, glyph, style, kind, .side = {0, (signed char)up}});
}

/* --- parts ------------------------------------------------------------------------------------------- */

static void add_outline(const Drawing *drawing)
{
    const double left = column_of(drawing, drawing->body.low[0]), top = drawing->room.top,
                 right = column_of(drawing, drawing->body.low[0] + drawing->body.size[0]),
                 bottom = drawing->room.bottom, x = right + 2;
    const double box[][2] = {{left, top}, {right, top}, {right, bottom}, {left, bottom}, {left, top}};
    const double rise[][2] = {{x - 0.5, top}, {x + 0.5, top},    {x, top},
                              {x, bottom},    {x - 0.5, bottom}, {x + 0.5, bottom}};
    trace(drawing, STROKE_LINE, STYLE_NORMAL, 5, box);
    trace(drawing, STROKE_LINE, STYLE_FAINT, 6, rise);
    label_length(drawing, x + 1, row_of(drawing, 0.5), 1, settings_geometry(drawing->settings)->height);
}

/* A load on a part of the top between two supports below. */
static void add_pressure(const Drawing *drawing)
{
    const Settings *settings = drawing->settings;
    const double half = settings_loads(settings)->width / 2, top = drawing->room.top,
                 from = column_of(drawing, settings_loads(settings)->position - half),
                 to = column_of(drawing, settings_loads(settings)->position + half);
    picture_add_mark(drawing->picture, (PictureMark){(from + to) / 2, top, 0x25bc, STYLE_HEADING, MARK_STANDS,
                                                     .side = {0, 1}, .half = (to - from) / 2});
    picture_label(drawing->picture, to + 1, top + 1, 1, STYLE_NORMAL, "%s MPa on %s mm",
                  text_rounded(1e-6 * settings_loads(settings)->stress, 4).text,
                  text_rounded(1e3 * settings_loads(settings)->width, 4).text);
    put(drawing, column_of(drawing, settings_supports(settings)->left), drawing->room.bottom, MARK_STANDS, -1,
        settings_supports(settings)->pinned ? 0x25b2 : 0x25cb);
    put(drawing, column_of(drawing, settings_supports(settings)->right), drawing->room.bottom, MARK_STANDS,
        -1, 0x25cb);
}

/* --- what a plate has by rows -------------------------------------------------------------------------- */

static void add_line(const Drawing *drawing, const double from[2], const double to[2], Style style)
{
    const double height = drawing->body.size[1];
    const double places[][2] = {{column_of(drawing, from[0]), row_of(drawing, from[1] / height)},
                                {column_of(drawing, to[0]), row_of(drawing, to[1] / height)}};
    trace(drawing, STROKE_LINE, style, 2, places);
}

static void add_rows(const Drawing *drawing)
{
    const Settings *settings = drawing->settings;
    for (int kind = 0; kind < ROW_KINDS; kind++)
        for (int row = 0; settings_have_rows(settings, kind) && row < settings->rows[kind].count; row++) {
            double ends[2][2];
            map_row_ends(settings, kind, row, ends);
            if (kind == ROWS_PROBE)
                continue; /* add_parts() has it */
            if (kind == ROWS_CUTS) {
                add_line(drawing, ends[0], ends[1], STYLE_HEADING);
            } else if (kind == ROWS_LOADS) {
                /* Arrows beside the edge, and the size of the traction where there is room. */
                const double sx = settings_row_value(settings, ROWS_LOADS, row, 3),
                             sy = settings_row_value(settings, ROWS_LOADS, row, 4),
                             height = drawing->body.size[1];
                PictureMark arrow = {
                    .glyph = glyph_arrow(2 * sx, -sy), .style = STYLE_HEADING, .kind = MARK_BESIDE};
                map_row_side((int)settings_row_value(settings, ROWS_LOADS, row, 0), arrow.side);
                const int right = arrow.side[0], up = arrow.side[1];
                double places[2][2];
                for (int i = 0; i < 2; i++) {
                    places[i][0] = column_of(drawing, ends[i][0]);
                    places[i][1] = row_of(drawing, ends[i][1] / height);
                }
                picture_spread(drawing->picture, places[0], places[1], (double[]){1, 1}, &arrow);
                const double x = up ? fmax(places[0][0], places[1][0]) + 2 : places[0][0] - 2 * right,
                             y = up ? places[0][1] + up : (places[0][1] + places[1][1]) / 2;
                picture_label(drawing->picture, x, y, up ? 1 : -right, STYLE_NORMAL, "%s MPa",
                              text_rounded(1e-6 * math_hypot(sx, sy), 4).text);
            } else {
                double corners[5][2];
                map_row_corners(ends, corners);
                for (int i = 0; i < 4; i++)
                    add_line(drawing, corners[i], corners[i + 1], STYLE_FRAME);
                picture_label(drawing->picture, column_of(drawing, fmax(ends[0][0], ends[1][0])) + 1,
                              row_of(drawing, (ends[0][1] + ends[1][1]) / 2 / drawing->body.size[1]), 1,
                              STYLE_FAINT, "%s", settings->rows[kind].rows[row].name);
            }
        }
}

/* --- the whole ---------------------------------------------------------------------------------------- */

static void add(Drawing *drawing, double from, double to, int row)
{
    drawing->lengths[drawing->n_lengths++] = (Length){from, to, row};
    drawing->room.lengths = row + 1 > drawing->room.lengths ? row + 1 : drawing->room.lengths;
}

static void add_parts(const Drawing *drawing)
{
    add_outline(drawing);
    if (drawing->scene.notched) {
        /* A cut from below, seen in any case, with its depth. */
        const Settings *settings = drawing->settings;
        const double x = column_of(drawing, settings_notch(settings)->position),
                     share = settings_notch(settings)->depth / settings_geometry(settings)->height,
                     bottom = drawing->room.bottom,
                     end = fmax(row_of(drawing, share), bottom + drawing->picture->whole);
        const double places[][2] = {{x, bottom}, {x, end}};
        trace(drawing, STROKE_LINE, STYLE_HEADING, 2, places);
        label_length(drawing, x + 1, fmax(end, bottom + 1), 1, settings_notch(settings)->depth);
    }
    if (drawing->scene.pressed)
        add_pressure(drawing);
    else if (drawing->scene.leaves) {
        /* The body behind the clamp goes through a channel with walls. */
        const double from = column_of(drawing, -settings_motion(drawing->settings)->channel),
                     to = column_of(drawing, 0);
        for (int side = 1; side >= -1; side -= 2) {
            const double edge = side > 0 ? drawing->room.top : drawing->room.bottom,
                         near = edge + 0.15 * side, far = edge + 0.8 * side;
            const double places[][2] = {{from, near}, {from, far}, {to, near}, {to, far}};
            trace(drawing, STROKE_BAND, STYLE_FRAME, 4, places);
        }
        picture_label(drawing->picture, from + 2, row_of(drawing, 0.5), 1, STYLE_HEADING, "→ %s m/s",
                      text_rounded(settings_motion(drawing->settings)->speed, 4).text);
    } else if (drawing->scene.bent) {
        /* The ends of a beam that vibrates are held at half its height. */
        const double y = row_of(drawing, 0.5), low = drawing->body.low[0];
        put(drawing, column_of(drawing, low), y, MARK_PLACE, 0, 0x25b2);
        put(drawing, column_of(drawing, low + drawing->body.size[0]), y, MARK_PLACE, 0, 0x25cb);
    }
    if (drawing->scene.by_rows)
        add_rows(drawing);
    const double *probe = drawing->scene.probe;
    const double x = column_of(drawing, drawing->body.low[0] + probe[0] * drawing->body.size[0]);
    const int side = probe[1] >= 1 ? 1 : -1;
    put(drawing, x, row_of(drawing, probe[1]), MARK_PLACE, 0, 0x25cf);
    /* a line of cells makes room for words, a thin one does not */
    picture_label(drawing->picture, x + side,
                  row_of(drawing, probe[1]) - (side > 0 && !drawing->picture->whole), side, STYLE_MEASURED,
                  "probe");
    for (int i = 0; i < drawing->n_lengths; i++)
        if (drawing->lengths[i].row < drawing->room.lengths) {
            /* "├── 65 mm ──┤", or upright: with a tick at both ends. */
            const Length *length = &drawing->lengths[i];
            const double from = column_of(drawing, length->from), to = column_of(drawing, length->to),
                         y = drawing->room.bottom - 1 - drawing->room.around -
                             drawing->room.apart * length->row;
            const double places[][2] = {{from, y + 0.25}, {from, y - 0.25}, {from, y},
                                        {to, y},          {to, y + 0.25},   {to, y - 0.25}};
            trace(drawing, STROKE_LINE, STYLE_FAINT, 6, places);
            label_length(drawing, (from + to) / 2, y, 0, length->to - length->from);
        }
}

void map_drawing(const Screen *screen, Picture *picture)
{
    const Settings *settings = screen_settings(screen);
    Drawing drawing = {.settings = settings, .scene = map_scene(settings), .picture = picture};
    if (!body_of(screen_simulation(screen), &drawing.body))
        return;
    drawing.room.around = drawing.scene.around;
    drawing.room.size[0] = drawing.body.size[0];
    drawing.room.size[1] = drawing.body.size[1];
    /* The most important lengths first: those that have no row are left out from the end. */
    const MapScene *scene = &drawing.scene;
    int row = 0;
    if (scene->leaves)
        add(&drawing, -settings_motion(settings)->channel, 0, row);
    if (scene->notched)
        add(&drawing, 0, settings_notch(settings)->position, row++);
    if (scene->pressed) {
        add(&drawing, 0, settings_loads(settings)->position, row++);
        add(&drawing, settings_supports(settings)->left, settings_supports(settings)->right, row++);
    }
    add(&drawing, 0, settings_geometry(settings)->length, row);
    if (!picture_lay_drawing(picture, &drawing.room))
        return;
    strcpy(picture->time, screen_time_text(screen, 0).text);
    picture_heading(picture, "the %s at t = 0", settings->problem->body);
    add_parts(&drawing);
    /* "to scale", or by how much the height is not; and "E 71 GPa  density 2700  thickness 5 mm  U 3 µm" */
    char text[160];
    const double least = picture->whole ? 0.2 : 1e-9; /* a row is not stretched */
    picture_note(picture, STYLE_NORMAL,
                 fabs(math_log(drawing.room.stretch)) < least ? "to scale" : "height × %s",
                 text_rounded(drawing.room.stretch, 2).text);
    snprintf(text, sizeof text, "E %s GPa  density %s kg/m³  thickness %s mm",
             text_rounded(1e-9 * settings_material(settings)->youngs_modulus, 4).text,
             text_rounded(settings_material(settings)->density, 5).text,
             text_rounded(1e3 * settings_geometry(settings)->thickness, 4).text);
    if (scene->bent && settings_start(settings)->amplitude != 0)
        text_append(text, sizeof text, "  U %s µm",
                    text_rounded(1e6 * settings_start(settings)->amplitude, 4).text);
    if (settings_loads(settings)->body_force != 0)
        text_append(text, sizeof text, "  body force %s m/s²",
                    text_rounded(settings_loads(settings)->body_force, 4).text);
    picture_note(picture, STYLE_FAINT, "%s", text);
}
