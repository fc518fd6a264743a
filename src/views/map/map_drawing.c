/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The beam before it moves, as in the papers' figures of the problems: dimensions in mm, supports, channel,
 * notch, load, probe. On paper it is laid out in the same columns and rows, a row twice as high as a column
 * is wide, but for rounding. */
#include "views/map/map_drawing.h"

#include "scenario/concern_body.h"
#include "scenario/concern_loads.h"
#include "scenario/settings.h"
#include "base/math/functions.h"

#include <math.h>
#include <stdio.h>

enum { MARGIN_RIGHT = 11, LEAST_ROWS = 3 };

#define WORTH_IT 0.6 /* of the width: a drawing to scale may lose so much, else its height is squeezed */
#define APART    1.3 /* rows from one dimension to the next, on paper */

static void add(Drawing *drawing, double from, double to, int row)
{
    drawing->lengths[drawing->n_dimensions++] = (Dimension){from, to, row};
    drawing->dimension_rows = row + 1 > drawing->dimension_rows ? row + 1 : drawing->dimension_rows;
}

static void millimetres(double metres, char *out, size_t size)
{
    char number[NUMBER_TEXT_MAX];
    text_rounded(number, 1e3 * metres, 4);
    snprintf(out, size, " %s mm ", number);
}

/* --- on paper, or in cells --------------------------------------------------------------------------- */

/* "├────┤", or upright. */
static void draw_span(const Drawing *drawing, double from, double to, double y)
{
    const double places[][2] = {{from, y - 0.25}, {from, y + 0.25}, {from, y},
                                {to, y},          {to, y - 0.25},   {to, y + 0.25}};
    if (drawing_paper(drawing))
        drawing_trace(drawing, STROKE_LINE, STYLE_FAINT, 6, places);
    else
        for (double x = from; x <= to; x++)
            drawing_put(drawing, x, y, x == from ? 0x251c : x == to ? 0x2524 : 0x2500, STYLE_FRAME);
}

static void draw_rise(const Drawing *drawing, double x, double top, double bottom)
{
    const double places[][2] = {{x - 0.5, top}, {x + 0.5, top},    {x, top},
                                {x, bottom},    {x - 0.5, bottom}, {x + 0.5, bottom}};
    if (drawing_paper(drawing))
        drawing_trace(drawing, STROKE_LINE, STYLE_FAINT, 6, places);
    else
        for (double y = top; y <= bottom; y++)
            drawing_put(drawing, x, y, y == top ? 0x252c : y == bottom ? 0x2534 : 0x2502, STYLE_FRAME);
}

static void draw_box(const Drawing *drawing, double left, double right, double top, double bottom)
{
    const double places[][2] = {{left, top}, {right, top}, {right, bottom}, {left, bottom}, {left, top}};
    if (drawing_paper(drawing)) {
        drawing_trace(drawing, STROKE_LINE, STYLE_NORMAL, 5, places);
        return;
    }
    for (double x = left; x <= right; x++) {
        drawing_put(drawing, x, top, x == left ? 0x250c : x == right ? 0x2510 : 0x2500, STYLE_NORMAL);
        drawing_put(drawing, x, bottom, x == left ? 0x2514 : x == right ? 0x2518 : 0x2500, STYLE_NORMAL);
    }
    for (double y = top + 1; y < bottom; y++) {
        drawing_put(drawing, left, y, 0x2502, STYLE_NORMAL);
        drawing_put(drawing, right, y, 0x2502, STYLE_NORMAL);
    }
}

/* A wall along an edge of the beam: above (side -1) or below it. */
static void draw_wall(const Drawing *drawing, double from, double to, double edge, int side)
{
    const double near = edge + 0.15 * side, far = edge + 0.8 * side;
    const double places[][2] = {{from, near}, {from, far}, {to, near}, {to, far}};
    if (drawing_paper(drawing)) {
        Plot *plot = &drawing_paper(drawing)->plot;
        drawing_trace(drawing, STROKE_BAND, STYLE_FRAME, 4, places);
        plot->strokes[plot->n_strokes - 1].fill = 2; /* no darker than the beam's outline */
        return;
    }
    for (double x = from; x <= to; x++)
        drawing_put(drawing, x, edge + side, side < 0 ? 0x2584 : 0x2580, STYLE_FRAME);
}

static void draw_notch(const Drawing *drawing, double x, double end)
{
    const double places[][2] = {{x, drawing->bottom}, {x, end}};
    if (drawing_paper(drawing))
        drawing_trace(drawing, STROKE_LINE, STYLE_HEADING, 2, places);
    else
        for (double y = end; y <= drawing->bottom; y++)
            drawing_put(drawing, x, y, y == drawing->bottom ? 0x2534 : 0x2502, STYLE_HEADING);
}

/* A load that presses on a part of the upper edge. */
static void draw_load(const Drawing *drawing, double from, double to)
{
    const double x = (from + to) / 2, y = drawing->top - 1;
    const double across[][2] = {{from, y}, {to, y}}, shaft[][2] = {{x, y}, {x, drawing->top - 0.5}};
    if (!drawing_paper(drawing)) {
        for (double column = from; column <= to; column++)
            drawing_put(drawing, column, y, 0x25bc, STYLE_HEADING);
        return;
    }
    drawing_trace(drawing, STROKE_LINE, STYLE_HEADING, 2, across);
    drawing_trace(drawing, STROKE_LINE, STYLE_HEADING, 2, shaft);
    drawing_put(drawing, x, drawing->top, 0x25bc, STYLE_HEADING);
}

/* Below the beam; a sign on paper hangs from its place. */
static void draw_support(const Drawing *drawing, double x, bool pinned)
{
    drawing_put(drawing, drawing_column(drawing, x), drawing->bottom + !drawing_paper(drawing),
                pinned ? 0x25b2 : 0x25cb, STYLE_HEADING);
}

/* --- parts ------------------------------------------------------------------------------------------- */

static void draw_dimension(const Drawing *drawing, const Dimension *dimension, double y)
{
    const double from = drawing_column(drawing, dimension->from), to = drawing_column(drawing, dimension->to);
    char text[NUMBER_TEXT_MAX + 8];
    millimetres(dimension->to - dimension->from, text, sizeof text);
    draw_span(drawing, from, to, y);
    if (to - from - 1 >= glyphs_columns(text))
        drawing_label(drawing, (from + to) / 2, y, 0, text, STYLE_NORMAL);
    else
        drawing_label(drawing, to + 1, y, 1, text, STYLE_NORMAL);
}

static void draw_outline(const Drawing *drawing)
{
    const double left = drawing_column(drawing, drawing->body->low[0]);
    const double right = drawing_column(drawing, drawing->body->low[0] + drawing->body->size[0]);
    char text[NUMBER_TEXT_MAX + 8];
    draw_box(drawing, left, right, drawing->top, drawing->bottom);
    millimetres(settings_geometry(drawing->settings)->height, text, sizeof text);
    draw_rise(drawing, right + 2, drawing->top, drawing->bottom);
    drawing_label(drawing, right + 3, drawing_row(drawing, 0.5), 1, text, STYLE_NORMAL);
}

/* The body behind the clamp goes through a channel with walls. */
static void draw_channel(const Drawing *drawing)
{
    const double from = drawing_column(drawing, -settings_motion(drawing->settings)->channel),
                 to = drawing_column(drawing, 0);
    draw_wall(drawing, from, to, drawing->top, -1);
    draw_wall(drawing, from, to, drawing->bottom, 1);
    char text[48], number[NUMBER_TEXT_MAX];
    text_rounded(number, settings_motion(drawing->settings)->speed, 4);
    snprintf(text, sizeof text, "→ %s m/s", number);
    drawing_label(drawing, from + 2, drawing_row(drawing, 0.5), 1, text, STYLE_HEADING);
}

/* A cut from below, with its depth. */
static void draw_cut(const Drawing *drawing)
{
    const Settings *settings = drawing->settings;
    const double notch = drawing_column(drawing, settings_notch(settings)->position);
    const double end =
        fmin(drawing_row(drawing, settings_notch(settings)->depth / settings_geometry(settings)->height),
             drawing->bottom - !drawing_paper(drawing)); /* seen in any case */
    char text[NUMBER_TEXT_MAX + 8];
    draw_notch(drawing, notch, end);
    millimetres(settings_notch(settings)->depth, text, sizeof text);
    drawing_label(drawing, notch + 1, fmin(end, drawing->bottom - 1), 1, text, STYLE_NORMAL);
}

/* A load on the top between two supports below. */
static void draw_pressure(const Drawing *drawing)
{
    const Settings *settings = drawing->settings;
    char text[96], number[NUMBER_TEXT_MAX], width[NUMBER_TEXT_MAX];
    const double from =
        drawing_column(drawing, settings_loads(settings)->position - settings_loads(settings)->width / 2);
    const double to =
        drawing_column(drawing, settings_loads(settings)->position + settings_loads(settings)->width / 2);
    draw_load(drawing, from, to);
    text_rounded(number, 1e-6 * settings_loads(settings)->stress, 4);
    text_rounded(width, 1e3 * settings_loads(settings)->width, 4);
    snprintf(text, sizeof text, "%s MPa on %s mm", number, width);
    drawing_label(drawing, to + 2, drawing->top - 1, 1, text, STYLE_NORMAL);
    draw_support(drawing, settings_supports(settings)->left, settings_supports(settings)->pinned);
    draw_support(drawing, settings_supports(settings)->right, false);
}

static void draw_probe(const Drawing *drawing)
{
    const Body *body = drawing->body;
    const double *probe = drawing->scene.probe;
    const double column = drawing_column(drawing, body->low[0] + probe[0] * body->size[0]);
    const double row = drawing_row(drawing, probe[1]);
    const bool above = probe[1] >= 1;
    drawing_put(drawing, column, row, 0x25cf, STYLE_MEASURED);
    /* a line of cells makes room for words, one on paper does not */
    drawing_label(drawing, above ? column + 1 : column - 1, row + (above && drawing_paper(drawing)),
                  above ? 1 : -1, "probe", STYLE_MEASURED);
}

/* "E 71 GPa  density 2700  thickness 5 mm  u(0) 3 µm" */
static void draw_words(const Drawing *drawing, int y)
{
    const Settings *settings = drawing->settings;
    char text[160], a[NUMBER_TEXT_MAX], b[NUMBER_TEXT_MAX], c[NUMBER_TEXT_MAX];
    text_rounded(a, 1e-9 * settings_material(settings)->youngs_modulus, 4);
    text_rounded(b, settings_material(settings)->density, 5);
    text_rounded(c, 1e3 * settings_geometry(settings)->thickness, 4);
    snprintf(text, sizeof text, "E %s GPa  density %s kg/m³  thickness %s mm", a, b, c);
    if (drawing->scene.bent && settings_start(settings)->amplitude != 0) {
        text_rounded(a, 1e6 * settings_start(settings)->amplitude, 4);
        text_append(text, sizeof text, "  U %s µm", a);
    }
    if (settings_loads(settings)->body_force != 0) {
        text_rounded(a, settings_loads(settings)->body_force, 4);
        text_append(text, sizeof text, "  body force %s m/s²", a);
    }
    if (drawing_paper(drawing))
        picture_note(drawing_paper(drawing), STYLE_FAINT, text);
    else
        area_phrases(drawing->area, 1, y, drawing->area.rect.width - 2, 1, text, STYLE_FAINT);
}

/* The ends of a beam that vibrates are held at half its height. */
static void draw_supports(const Drawing *drawing)
{
    const Body *body = drawing->body;
    const double row = drawing_row(drawing, 0.5);
    drawing_put(drawing, drawing_column(drawing, body->low[0]), row, 0x25b2, STYLE_HEADING);
    drawing_put(drawing, drawing_column(drawing, body->low[0] + body->size[0]), row, 0x25cb, STYLE_HEADING);
}

/* --- what the run is made of -------------------------------------------------------------------------- */

/* The most important lengths first: those that have no row are left out from the end. */
static void add_lengths(Drawing *drawing)
{
    const Settings *settings = drawing->settings;
    const MapScene *scene = &drawing->scene;
    int row = 0;
    if (scene->leaves)
        add(drawing, -settings_motion(settings)->channel, 0, row);
    if (scene->notched)
        add(drawing, 0, settings_notch(settings)->position, row++);
    if (scene->pressed) {
        add(drawing, 0, settings_loads(settings)->position, row++);
        add(drawing, settings_supports(settings)->left, settings_supports(settings)->right, row++);
    }
    add(drawing, 0, settings_geometry(settings)->length, row);
}

static void draw_parts(const Drawing *drawing)
{
    if (drawing->scene.notched)
        draw_cut(drawing);
    if (drawing->scene.pressed)
        draw_pressure(drawing);
    else if (drawing->scene.leaves)
        draw_channel(drawing);
    else if (drawing->scene.bent)
        draw_supports(drawing);
    if (drawing->scene.by_rows)
        drawing_rows(drawing);
}

/* --- the whole ---------------------------------------------------------------------------------------- */

static void draw_all(const Drawing *drawing, double apart)
{
    draw_outline(drawing);
    draw_parts(drawing);
    draw_probe(drawing);
    for (int i = 0; i < drawing->n_dimensions; i++)
        draw_dimension(drawing, &drawing->lengths[i],
                       drawing->bottom + 1 + drawing->scene.around + apart * drawing->lengths[i].row);
}

/* "to scale", or by how much the height is not. */
static void scale_words(double stretch, bool to_scale, const char *times, char *out, size_t size)
{
    char number[NUMBER_TEXT_MAX];
    text_rounded(number, stretch, 2);
    if (to_scale)
        snprintf(out, size, "to scale");
    else
        snprintf(out, size, "height %s %s", times, number);
}

/* The page has as much height as the drawing takes. */
static void draw_on_paper(Drawing *drawing, const Screen *screen)
{
    Picture *picture = drawing_paper(drawing);
    const int columns = drawing->area.rect.width;
    const double rise = drawing->body->size[1] * drawing->scale / 2;
    char words[64];
    drawing->top = drawing->scene.around + 0.5;
    drawing->bottom = drawing->top + fmax(rise, LEAST_ROWS - 1);
    const double end =
        drawing->bottom + 1 + drawing->scene.around + APART * (drawing->dimension_rows - 1) + 0.5;
    const Axis x = axis_with_ticks(axis_make(0, columns), 2), y = axis_with_ticks(axis_make(-end, 0), 2);
    picture->kind = PICTURE_MAP;
    picture_axes(picture, x, "", "", y, "", "");
    picture->bare = true;
    picture->stretch = 2; /* rows, columns */
    screen_time_text(screen, 0, picture->time, sizeof picture->time);
    draw_all(drawing, APART);
    scale_words((drawing->bottom - drawing->top) / rise, rise >= LEAST_ROWS - 1, "×", words, sizeof words);
    picture_note(picture, STYLE_NORMAL, words);
    draw_words(drawing, 0);
}

void map_drawing(const Screen *screen, Area area, Style heading, Picture *picture)
{
    Body body;
    if (!body_of(experiment_simulation(screen->experiment), &body))
        return;
    const Settings *settings = experiment_settings(screen->experiment);
    Drawing drawing = {.settings = settings,
                       .scene = map_scene(settings),
                       .body = &body,
                       .area = area,
                       .picture = picture,
                       .low = body.low[0]};
    const int columns = area.rect.width - 2 - MARGIN_RIGHT;
    add_lengths(&drawing);
    drawing.scale = columns / body.size[0];
    if (picture) {
        if (columns >= 20)
            draw_on_paper(&drawing, screen);
        else
            picture_say(picture, "drawing", "it needs a wider page");
        return;
    }
    const int around = drawing.scene.around;
    int room = area.rect.height - 1 - 2 * around;
    while (drawing.dimension_rows > 1 && drawing.dimension_rows + LEAST_ROWS > room - 1) {
        drawing.n_dimensions--;
        drawing.dimension_rows = drawing.lengths[drawing.n_dimensions - 1].row + 1;
    }
    const bool words = room > drawing.dimension_rows + LEAST_ROWS;
    const int rows = room - drawing.dimension_rows - words;
    if (columns < 20 || rows < LEAST_ROWS) {
        area_rule(area, 0, "drawing", heading);
        area_text(area, 1, 1, "z gives the drawing the room that it needs", STYLE_FAINT);
        return;
    }
    const double wanted = body.size[1] * drawing.scale / 2;
    if (wanted > rows - 1 && wanted * WORTH_IT < rows - 1)
        drawing.scale *= (rows - 1) / wanted;
    const double rise = fmin(fmax(round(body.size[1] * drawing.scale / 2), LEAST_ROWS - 1), rows - 1);
    drawing.top = 1 + around;
    drawing.bottom = drawing.top + rise;
    const double stretch = rise / (body.size[1] * drawing.scale / 2);
    char title[96], scale[64];
    scale_words(stretch, fabs(math_log(stretch)) < 0.2, "x", scale, sizeof scale);
    snprintf(title, sizeof title, "the %s at t = 0  %s", settings->problem->body, scale);
    area_rule(area, 0, title, heading);
    draw_all(&drawing, 1);
    if (words)
        draw_words(&drawing, area.rect.height - 1);
}
