/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The strokes that a plot is, and what becomes of them in cells: each becomes dots, and a cell shows those of
 * the highest rank that fell into it. */
#include "picture/plot.h"

#include "base/assertion.h"
#include "picture/cells/cells.h"

#include <math.h>
#include <stdlib.h>

/* --- the list of strokes -------------------------------------------------------------------------- */

void plot_close(Plot *plot)
{
    free(plot->points);
    plot->points = NULL;
    plot->n_points = plot->room = 0;
    plot->n_strokes = 0;
}

const Pen pen_measured = {LINE_SOLID, '*', STYLE_MEASURED, RANK_MEASURED, 0};
const Pen pen_second = {LINE_DASHED, '-', STYLE_SECOND, RANK_SECOND, 0};
const Pen pen_exact = {LINE_DOTTED, '.', STYLE_EXACT, RANK_EXACT, 0};
const Pen pen_predicted = {LINE_DASHED, '-', STYLE_PREDICTED, RANK_PREDICTED, 0};

void plot_begin(Plot *plot, StrokeKind kind, Pen pen)
{
    if (plot->n_strokes == STROKES_MAX)
        return;
    plot->strokes[plot->n_strokes++] =
        (Stroke){kind, pen.line, pen.style, pen.rank, pen.fill, pen.letter, .first = plot->n_points};
}

void plot_point(Plot *plot, double x, double y)
{
    if (plot->n_strokes == 0)
        return;
    if (plot->n_points == plot->room) {
        size_t room = plot->room ? 2 * plot->room : 256;
        double *points = realloc(plot->points, room * 2 * sizeof *points);
        if (!points) {
            plot->lost = true;
            return;
        }
        plot->points = points;
        plot->room = room;
    }
    plot->points[2 * plot->n_points] = x;
    plot->points[2 * plot->n_points + 1] = y;
    plot->n_points++;
    plot->strokes[plot->n_strokes - 1].count++;
}

typedef struct Sample {
    size_t index;
    double x, y;
} Sample;

/* What is kept of the samples of one column. */
typedef struct Extent {
    size_t count;
    Sample first, least, largest, last;
} Extent;

/* In the order in which they come, each once. */
static void flush(Plot *plot, const Extent *extent)
{
    const bool least_first = extent->least.index < extent->largest.index;
    const Sample *const kept[] = {&extent->first, least_first ? &extent->least : &extent->largest,
                                  least_first ? &extent->largest : &extent->least, &extent->last};
    for (int k = 0; k < 4 && extent->count > 0; k++)
        if (k == 0 || kept[k]->index != kept[k - 1]->index)
            plot_point(plot, kept[k]->x, kept[k]->y);
}

void plot_curve(Plot *plot, PlotSample *sample, const void *context, size_t first, size_t end, int columns)
{
    ASSERT_INT(first, <=, end);
    const double scale = columns / (plot->x.high - plot->x.low);
    Extent extent = {0};
    long column = 0;
    for (size_t i = first; i < end; i++) {
        Sample here = {.index = i};
        here.y = sample(context, i, &here.x);
        const long at = (long)floor((here.x - plot->x.low) * scale);
        if (at != column || isnan(here.y)) {
            flush(plot, &extent);
            extent.count = 0;
        }
        if (isnan(here.y)) {
            plot_point(plot, here.x, here.y);
            continue;
        }
        column = at;
        if (extent.count++ == 0)
            extent.first = extent.least = extent.largest = here;
        if (here.y < extent.least.y)
            extent.least = here;
        if (here.y > extent.largest.y)
            extent.largest = here;
        extent.last = here;
    }
    flush(plot, &extent);
}

/* --- dots on cells --- */

/* What the curves have left in one cell: only the dots of the highest rank. */
typedef struct Spot {
    uint8_t dots;
    uint8_t count;
    int8_t rank;
    uint16_t style;
    uint32_t glyph; /* a letter or a shade in place of dots; 0: none */
} Spot;

typedef struct Raster {
    Spot *spots;
    int columns, rows; /* cells */
    int across, down;  /* dots in a cell */
    bool thick;        /* lines of two dots */
    Glyphs glyphs;
} Raster;

int plot_dots_across(Glyphs glyphs)
{
    return glyphs == GLYPHS_NONE ? 16 : glyphs == GLYPHS_BRAILLE ? 2 : 1;
}

int plot_dots_down(Glyphs glyphs)
{
    return glyphs == GLYPHS_BRAILLE ? 4 : glyphs == GLYPHS_BLOCK ? 2 : 1;
}

static void put_dot(Raster *raster, const Stroke *stroke, int x, int y)
{
    if (x < 0 || y < 0 || x >= raster->columns * raster->across || y >= raster->rows * raster->down)
        return;
    Spot *spot =
        &raster->spots[(size_t)(y / raster->down) * (size_t)raster->columns + (size_t)(x / raster->across)];
    if (spot->rank > stroke->rank)
        return;
    if (spot->rank < stroke->rank || spot->style != stroke->style)
        *spot = (Spot){.rank = (int8_t)stroke->rank, .style = (uint16_t)stroke->style};
    /* Half blocks have no room for dots and dashes: such lines are drawn with letters. */
    spot->glyph = 0;
    if (raster->glyphs == GLYPHS_ASCII)
        spot->glyph = (uint32_t)stroke->letter;
    else if (raster->glyphs == GLYPHS_BLOCK && stroke->kind != STROKE_BAND)
        spot->glyph = stroke->line == LINE_DOTTED ? 0x00b7 : stroke->line == LINE_DASHED ? '-' : 0;
    if (raster->glyphs == GLYPHS_BRAILLE)
        spot->dots |= glyph_dot(x % 2, y % 4);
    else
        spot->dots |= (uint8_t)(1 << y % raster->down);
}

/* --- lines --- */

/* Where along a broken line we are. It begins again every few dots of the absolute x, so that a pattern moves
 * with its curve when the window moves by whole cells, instead of crawling along it. */
typedef struct Pattern {
    int begun_at, place;
    long offset; /* dots left of the window */
} Pattern;

enum { PATTERN_CHUNK = 12, VECTOR_FAR = 100000 /* dots */ };

/* Cuts a segment to 0 <= y <= bottom; false: nothing is left. */
static bool cut(double *x0, double *y0, double *x1, double *y1, double bottom)
{
    if ((*y0 < 0 && *y1 < 0) || (*y0 > bottom && *y1 > bottom))
        return false;
    double *ends[2][4] = {{x0, y0, x1, y1}, {x1, y1, x0, y0}};
    for (int e = 0; e < 2; e++) {
        double *x = ends[e][0], *y = ends[e][1], *to_x = ends[e][2], *to_y = ends[e][3];
        double edge = *y < 0 ? 0 : *y > bottom ? bottom : *y;
        if (edge != *y) {
            *x += (*to_x - *x) * (edge - *y) / (*to_y - *y);
            *y = edge;
        }
    }
    return true;
}

static int dot_of(double place)
{
    return (int)floor(place);
}

static void draw_segment(Raster *raster, const Stroke *stroke, Pattern *pattern, double x0, double y0,
                         double x1, double y1, bool first)
{
    double right = raster->columns * raster->across, bottom = raster->rows * raster->down - 0.5;
    if (fmax(x0, x1) < 0 || fmin(x0, x1) > right || !cut(&y0, &x0, &y1, &x1, right - 1e-6) ||
        !cut(&x0, &y0, &x1, &y1, bottom))
        return;
    int ax = dot_of(x0), ay = dot_of(y0), bx = dot_of(x1), by = dot_of(y1);
    int steps = abs(bx - ax) > abs(by - ay) ? abs(bx - ax) : abs(by - ay);
    for (int i = first ? 0 : 1; i <= steps; i++) {
        double share = steps ? (double)i / steps : 0;
        int x = (int)lround(ax + share * (bx - ax)), y = (int)lround(ay + share * (by - ay));
        if (stroke->line != LINE_SOLID) {
            if ((x + pattern->offset) % PATTERN_CHUNK == 0 && pattern->begun_at != x) {
                pattern->begun_at = x;
                pattern->place = 0;
            }
            const int place = pattern->place++;
            if (stroke->line == LINE_DOTTED ? place % 3 != 0 : place % 6 >= 4)
                continue;
        }
        put_dot(raster, stroke, x, y);
        if (raster->thick) {
            put_dot(raster, stroke, x + 1, y);
            put_dot(raster, stroke, x, y + 1);
        }
    }
}

/* --- strokes --- */

typedef struct Place {
    double x, y; /* in dots from the upper left corner */
} Place;

static Place place_at(const Plot *plot, const Raster *raster, double at_x, double at_y)
{
    double width = raster->columns * raster->across, height = raster->rows * raster->down;
    double x = axis_share(&plot->x, at_x) * width;
    const double top = axis_place(&plot->y, plot->y.high), bottom = axis_place(&plot->y, plot->y.low);
    double y = (top - axis_place(&plot->y, at_y)) / (top - bottom) * (height - 1) + 0.5;
    /* the right end belongs to the last dot; rounding must not lose what lies on an edge */
    if (x >= width && x <= width * (1 + 1e-9))
        x = width - 0.5;
    if (x < 0 && x > -1e-9 * width)
        x = 0;
    return (Place){x, y};
}

static Place place_of(const Plot *plot, const Raster *raster, size_t point)
{
    return place_at(plot, raster, plot->points[2 * point], plot->points[2 * point + 1]);
}

static void draw_line(const Plot *plot, const Stroke *stroke, Raster *raster)
{
    double dot = (plot->x.high - plot->x.low) / (raster->columns * raster->across);
    double offset = plot->x.low / dot;
    Pattern pattern = {.begun_at = -1, .offset = fabs(offset) < 1e15 ? lround(offset) : 0};
    bool begun = false;
    Place before = {0, 0};
    for (size_t i = 0; i < stroke->count; i++) {
        Place here = place_of(plot, raster, stroke->first + i);
        if (!isfinite(here.x) || !isfinite(here.y)) {
            begun = false;
            continue;
        }
        if (begun)
            draw_segment(raster, stroke, &pattern, before.x, before.y, here.x, here.y, i == 1);
        else if (i + 1 == stroke->count || !isfinite(plot->points[2 * (stroke->first + i + 1) + 1]))
            draw_segment(raster, stroke, &pattern, here.x, here.y, here.x, here.y, true);
        before = here;
        begun = true;
    }
}

static void draw_band(const Plot *plot, const Stroke *stroke, Raster *raster)
{
    const int columns = raster->columns * raster->across, rows = raster->rows * raster->down;
    static const uint32_t shades[] = {0x2593, 0x2592, 0x2591, 0x00b7};
    size_t i = 0;
    for (int x = 0; x < columns; x++) {
        /* the pair of points whose x is the last one not beyond this column's middle */
        while (i + 3 < stroke->count && place_of(plot, raster, stroke->first + i + 2).x <= x + 0.5)
            i += 2;
        if (i + 1 >= stroke->count)
            return;
        Place low = place_of(plot, raster, stroke->first + i),
              high = place_of(plot, raster, stroke->first + i + 1);
        bool covered = low.x <= x + 0.5 + 1e-6 && (i + 3 < stroke->count || low.x >= x - 0.5);
        if (!covered || !isfinite(low.y) || !isfinite(high.y) || low.y - high.y < 1e-9 * rows)
            continue;
        int top = high.y < 0 ? 0 : dot_of(high.y), bottom = low.y > rows ? rows : dot_of(low.y);
        for (int y = top; y < bottom || (y == bottom && y == rows - 1); y++) {
            const bool lit[] = {true, (x + y) % 2 == 0, x % 2 == 0 && y % 2 == 0,
                                x % 2 == 0 && (y + x) % 4 == 0}; /* of braille, by its fill */
            if (raster->glyphs != GLYPHS_BRAILLE || lit[stroke->fill & 3])
                put_dot(raster, stroke, x, y);
            if (raster->glyphs != GLYPHS_BLOCK)
                continue;
            Spot *spot = &raster->spots[(size_t)(y / raster->down) * (size_t)raster->columns + (size_t)x];
            if (spot->rank == stroke->rank && spot->style == stroke->style)
                spot->glyph = shades[stroke->fill & 3];
        }
    }
}

static Raster raster_of(Area area)
{
    return (Raster){
        .columns = area.rect.width,
        .rows = area.rect.height,
        .across = plot_dots_across(area.glyphs),
        .down = plot_dots_down(area.glyphs),
        /* where a dot is a whole cell or half of one it is thick already */
        .thick = area.canvas->large && area.glyphs == GLYPHS_BRAILLE,
        .glyphs = area.glyphs,
    };
}

void plot_describe_mark(const Plot *plot, Area area, double x, double y, uint32_t glyph, Style style)
{
    const Raster raster = raster_of(area);
    const Place here = place_at(plot, &raster, x, y);
    if (fabs(here.x) < VECTOR_FAR && fabs(here.y) < VECTOR_FAR)
        canvas_mark(area.canvas, here.x / raster.across, here.y / raster.down, glyph, style);
}

void plot_draw(const Plot *plot, Area area)
{
    Raster raster = raster_of(area);
    const size_t count = (size_t)raster.columns * (size_t)raster.rows;
    raster.spots = count ? malloc(count * sizeof *raster.spots) : NULL;
    if (!raster.spots)
        return;
    for (size_t i = 0; i < count; i++)
        raster.spots[i] = (Spot){.rank = -1};
    for (int i = 0; i < plot->n_strokes; i++) {
        const Stroke *stroke = &plot->strokes[i];
        if (stroke->kind == STROKE_LINE)
            draw_line(plot, stroke, &raster);
        else if (stroke->kind == STROKE_DOTS) {
            for (size_t j = 0; j < stroke->count; j++) {
                Place here = place_of(plot, &raster, stroke->first + j);
                if (fabs(here.x) < 1e6 && fabs(here.y) < 1e6)
                    put_dot(&raster, stroke, dot_of(here.x), dot_of(here.y));
            }
        } else
            draw_band(plot, stroke, &raster);
    }
    static const uint32_t halves[] = {' ', 0x2580, 0x2584, 0x2588};
    for (size_t i = 0; i < count; i++) {
        const Spot *spot = &raster.spots[i];
        const uint32_t dots = raster.glyphs == GLYPHS_BRAILLE ? 0x2800u + spot->dots : halves[spot->dots & 3];
        if (spot->rank >= 0 && (spot->dots || spot->glyph))
            area_put(area, (int)i % raster.columns, (int)i / raster.columns, spot->glyph ? spot->glyph : dots,
                     (Style)spot->style);
    }
    /* The strokes as they are, finer than any cell. */
    canvas_vector(area.canvas, ";A%d,%d,%d,%d", area.rect.x, area.rect.y, area.rect.width, area.rect.height);
    for (int i = 0; i < plot->n_strokes && area.canvas->vectored; i++) {
        const Stroke *stroke = &plot->strokes[i];
        const bool band = stroke->kind == STROKE_BAND;
        const char kind = "LDB"[stroke->kind];
        const int pattern = band ? stroke->fill : (int)stroke->line;
        canvas_vector(area.canvas, ";%c%d,%d,%d", kind, (int)stroke->style, pattern, stroke->rank);
        for (size_t k = 0; k < stroke->count; k++) {
            const Place here = place_of(plot, &raster, stroke->first + k);
            if (fabs(here.x) < VECTOR_FAR && fabs(here.y) < VECTOR_FAR)
                canvas_vector(area.canvas, " %ld,%ld", lround(16 * here.x / raster.across),
                              lround(16 * here.y / raster.down));
            else if (!band)
                canvas_vector(area.canvas, " -");
        }
    }
    free(raster.spots);
}

const char *plot_key(LineStyle line, char letter, Glyphs glyphs)
{
    static const char letters[][3] = {"**", "..", "--", "oo", "xx", ",,", "::", "##", "++"};
    if (glyphs < GLYPHS_ASCII)
        return line == LINE_DOTTED        ? "··"
               : line == LINE_DASHED      ? "--"
               : glyphs == GLYPHS_BRAILLE ? "⠒⠒"
                                          : "▄▄";
    for (size_t i = 0; i < sizeof letters / sizeof *letters; i++)
        if (letters[i][0] == letter)
            return letters[i];
    return "  ";
}
