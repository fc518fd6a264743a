/* The beam before it moves, as in the papers' figures of the problems: dimensions in mm, supports, channel,
 * notch, load, probe. */
#include "view/map.h"

#include <math.h>
#include <stdio.h>

enum { MARGIN_RIGHT = 11, DIMENSIONS_MAX = 4, LEAST_ROWS = 3 };

#define WORTH_IT 0.6 /* of the width: a drawing to scale may lose so much, else its height is squeezed */

/* A length between two places, with its row below the beam. */
typedef struct Dimension {
    double from, to; /* m */
    int row;
} Dimension;

struct Drawing {
    const BeamDef *beam;
    const Scenery *scenery;
    const Body *body;
    Area area;
    double low, scale; /* column = 1 + (x - low) scale */
    int top, bottom;   /* rows of the upper and lower edge */
    Dimension dimensions[DIMENSIONS_MAX];
    int n_dimensions, dimension_rows;
};

static int column_of(const Drawing *drawing, double x)
{
    return 1 + (int)lround((x - drawing->low) * drawing->scale);
}

static int row_of(const Drawing *drawing, double share)
{
    return drawing->bottom - (int)lround(share * (drawing->bottom - drawing->top));
}

static void add(Drawing *drawing, double from, double to, int row)
{
    drawing->dimensions[drawing->n_dimensions++] = (Dimension){from, to, row};
    drawing->dimension_rows = row + 1 > drawing->dimension_rows ? row + 1 : drawing->dimension_rows;
}

static void millimetres(double metres, char *out, size_t size)
{
    char number[NUMBER_TEXT_MAX];
    text_rounded(number, 1e3 * metres, 4);
    snprintf(out, size, " %s mm ", number);
}

static void draw_dimension(const Drawing *drawing, const Dimension *dimension, int y)
{
    const int from = column_of(drawing, dimension->from), to = column_of(drawing, dimension->to);
    char text[NUMBER_TEXT_MAX + 8];
    millimetres(dimension->to - dimension->from, text, sizeof text);
    for (int x = from; x <= to; x++)
        area_put(drawing->area, x, y, x == from ? 0x251c : x == to ? 0x2524 : 0x2500, STYLE_FRAME);
    const int columns = text_columns(text);
    const int inside = to - from - 1 >= columns;
    area_text(drawing->area, inside ? (from + to + 1 - columns) / 2 : to + 1, y, text, STYLE_NORMAL);
}

static void draw_outline(const Drawing *drawing)
{
    const int left = column_of(drawing, drawing->body->low[0]);
    const int right = column_of(drawing, drawing->body->low[0] + drawing->body->size[0]);
    const int top = drawing->top, bottom = drawing->bottom;
    for (int x = left; x <= right; x++) {
        area_put(drawing->area, x, top, x == left ? 0x250c : x == right ? 0x2510 : 0x2500, STYLE_NORMAL);
        area_put(drawing->area, x, bottom, x == left ? 0x2514 : x == right ? 0x2518 : 0x2500, STYLE_NORMAL);
    }
    for (int y = top + 1; y < bottom; y++) {
        area_put(drawing->area, left, y, 0x2502, STYLE_NORMAL);
        area_put(drawing->area, right, y, 0x2502, STYLE_NORMAL);
    }
    char text[NUMBER_TEXT_MAX + 8];
    millimetres(drawing->beam->height, text, sizeof text);
    for (int y = top; y <= bottom; y++)
        area_put(drawing->area, right + 2, y, y == top ? 0x252c : y == bottom ? 0x2534 : 0x2502, STYLE_FRAME);
    area_text(drawing->area, right + 3, (top + bottom) / 2, text, STYLE_NORMAL);
}

/* The body behind the clamp goes through a channel with walls. */
static void draw_channel(const Drawing *drawing)
{
    const int from = column_of(drawing, -drawing->beam->channel), to = column_of(drawing, 0);
    for (int x = from; x <= to; x++) {
        area_put(drawing->area, x, drawing->top - 1, 0x2584, STYLE_FRAME);
        area_put(drawing->area, x, drawing->bottom + 1, 0x2580, STYLE_FRAME);
    }
    char text[48], number[NUMBER_TEXT_MAX];
    text_rounded(number, drawing->beam->speed, 4);
    snprintf(text, sizeof text, "→ %s m/s", number);
    area_text(drawing->area, from + 2, (drawing->top + drawing->bottom) / 2, text, STYLE_HEADING);
}

static void draw_notched(const Drawing *drawing)
{
    const BeamDef *beam = drawing->beam;
    const int notch = column_of(drawing, beam->notch_position);
    const int end = row_of(drawing, beam->notch_depth / beam->height);
    char text[96], number[NUMBER_TEXT_MAX], width[NUMBER_TEXT_MAX];
    for (int y = end < drawing->bottom ? end : drawing->bottom - 1; y <= drawing->bottom; y++)
        area_put(drawing->area, notch, y, y == drawing->bottom ? 0x2534 : 0x2502, STYLE_HEADING);
    millimetres(beam->notch_depth, text, sizeof text);
    area_text(drawing->area, notch + 1, end < drawing->bottom - 1 ? end : drawing->bottom - 1, text,
              STYLE_NORMAL);
    const double load[2] = {beam->load_position - beam->load_width / 2,
                            beam->load_position + beam->load_width / 2};
    for (int x = column_of(drawing, load[0]); x <= column_of(drawing, load[1]); x++)
        area_put(drawing->area, x, drawing->top - 1, 0x25bc, STYLE_HEADING);
    text_rounded(number, 1e-6 * beam->load_stress, 4);
    text_rounded(width, 1e3 * beam->load_width, 4);
    snprintf(text, sizeof text, "%s MPa on %s mm", number, width);
    area_text(drawing->area, column_of(drawing, load[1]) + 2, drawing->top - 1, text, STYLE_NORMAL);
    area_put(drawing->area, column_of(drawing, beam->support_left), drawing->bottom + 1,
             beam->pinned ? 0x25b2 : 0x25cb, STYLE_HEADING);
    area_put(drawing->area, column_of(drawing, beam->support_right), drawing->bottom + 1, 0x25cb,
             STYLE_HEADING);
}

static void draw_probe(const Drawing *drawing)
{
    const Body *body = drawing->body;
    const double *probe = drawing->scenery->probe;
    const int column = column_of(drawing, body->low[0] + probe[0] * body->size[0]);
    const int row = row_of(drawing, probe[1]);
    area_put(drawing->area, column, row, 0x25cf, STYLE_MEASURED);
    area_text(drawing->area, probe[1] >= 1 ? column + 1 : column - 6, row, "probe", STYLE_MEASURED);
}

/* "E 71 GPa  density 2700  thickness 5 mm  u(0) 3 µm" */
static void draw_words(const Drawing *drawing, int y)
{
    const BeamDef *beam = drawing->beam;
    char text[160], a[NUMBER_TEXT_MAX], b[NUMBER_TEXT_MAX], c[NUMBER_TEXT_MAX];
    text_rounded(a, 1e-9 * beam->youngs_modulus, 4);
    text_rounded(b, beam->density, 5);
    text_rounded(c, 1e3 * beam->thickness, 4);
    snprintf(text, sizeof text, "E %s GPa  density %s kg/m³  thickness %s mm", a, b, c);
    if (!drawing->scenery->pressed) {
        text_rounded(a, 1e6 * beam->amplitude, 4);
        append(text, sizeof text, "  U %s µm", a);
    }
    area_phrases(drawing->area, 1, y, drawing->area.rect.width - 2, 1, text, STYLE_FAINT);
}

/* The ends of a beam that vibrates are held at half its height. */
static void draw_supports(const Drawing *drawing)
{
    const Body *body = drawing->body;
    const int row = row_of(drawing, 0.5);
    area_put(drawing->area, column_of(drawing, body->low[0]), row, 0x25b2, STYLE_HEADING);
    area_put(drawing->area, column_of(drawing, body->low[0] + body->size[0]), row, 0x25cb, STYLE_HEADING);
}

/* --- what the problems add ---------------------------------------------------------------------------- */

static void length_alone(Drawing *drawing)
{
    add(drawing, 0, drawing->beam->length, 0);
}

static void channel_and_length(Drawing *drawing)
{
    add(drawing, -drawing->beam->channel, 0, 0);
    add(drawing, 0, drawing->beam->length, 0);
}

static void notch_load_supports(Drawing *drawing)
{
    const BeamDef *beam = drawing->beam;
    add(drawing, 0, beam->notch_position, 0);
    add(drawing, 0, beam->load_position, 1);
    add(drawing, beam->support_left, beam->support_right, 2);
    add(drawing, 0, beam->length, 3);
}

const Scenery map_scenery[PROBLEM_COUNT] = {
    [PROBLEM_SUPPORTED_BEAM] = {.pinned = true,
                                .probe = {0.5, 0.5},
                                .dimensions = length_alone,
                                .parts = draw_supports},
    [PROBLEM_MOVING_CANTILEVER] = {.leaves = true,
                                   .around = 1,
                                   .probe = {1, 0.5},
                                   .lines = map_channel_lines,
                                   .dimensions = channel_and_length,
                                   .parts = draw_channel},
    [PROBLEM_NOTCHED_BEAM] = {.pressed = true,
                              .around = 1,
                              .probe = {0.5, 1},
                              .lines = map_notch_lines,
                              .dimensions = notch_load_supports,
                              .parts = draw_notched},
};

/* --- the whole ---------------------------------------------------------------------------------------- */

void map_drawing(const Screen *screen, Area area, Style heading)
{
    Body body;
    if (!body_of(experiment_simulation(screen->experiment), &body))
        return;
    const Settings *settings = experiment_settings(screen->experiment);
    const Scenery *scenery = &map_scenery[settings->problem];
    Drawing drawing = {
        .beam = &settings->beam, .scenery = scenery, .body = &body, .area = area, .low = body.low[0]};
    const int columns = area.rect.width - 2 - MARGIN_RIGHT;
    scenery->dimensions(&drawing);
    const int around = scenery->around;
    int room = area.rect.height - 1 - 2 * around;
    while (drawing.dimension_rows > 1 && drawing.dimension_rows + LEAST_ROWS > room - 1) {
        drawing.n_dimensions--;
        drawing.dimension_rows = drawing.dimensions[drawing.n_dimensions - 1].row + 1;
    }
    const bool words = room > drawing.dimension_rows + LEAST_ROWS;
    const int rows = room - drawing.dimension_rows - words;
    if (columns < 20 || rows < LEAST_ROWS) {
        area_rule(area, 0, "drawing", heading);
        area_text(area, 1, 1, "z gives the drawing the room that it needs", STYLE_FAINT);
        return;
    }
    drawing.scale = columns / body.size[0];
    const double wanted = body.size[1] * drawing.scale / 2;
    if (wanted > rows - 1 && wanted * WORTH_IT < rows - 1)
        drawing.scale *= (rows - 1) / wanted;
    const double rise = fmin(fmax(round(body.size[1] * drawing.scale / 2), LEAST_ROWS - 1), rows - 1);
    drawing.top = 1 + around;
    drawing.bottom = drawing.top + (int)rise;
    const double stretch = rise / (body.size[1] * drawing.scale / 2);
    char title[96], number[NUMBER_TEXT_MAX];
    text_rounded(number, stretch, 2);
    const bool to_scale = fabs(log(stretch)) < 0.2;
    snprintf(title, sizeof title, "the beam at t = 0  %s%s", to_scale ? "to scale" : "height x ",
             to_scale ? "" : number);
    area_rule(area, 0, title, heading);
    draw_outline(&drawing);
    scenery->parts(&drawing);
    draw_probe(&drawing);
    for (int i = 0; i < drawing.n_dimensions; i++)
        draw_dimension(&drawing, &drawing.dimensions[i],
                       drawing.bottom + 1 + around + drawing.dimensions[i].row);
    if (words)
        draw_words(&drawing, area.rect.height - 1);
}
