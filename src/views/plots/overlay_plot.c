/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A foreign series over the plots: which view it belongs to, its stroke, marks and part of the axes. */
#include "views/plots/overlay_plot.h"

#include "picture/picture.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { MARK_EVERY = 6 }; /* cells between the marks of a curve that is dense */

static const OverlayColumn *column_of(const Overlay *overlay, const char *curve, bool along)
{
    const int column = overlay ? overlay_column_for(overlay, curve, along) : -1;
    return column >= 0 ? &overlay->columns[column] : NULL;
}

void overlay_widen(const Screen *screen, const char *curve, bool along, double *least, double *most)
{
    const OverlayColumn *column = column_of(screen->overlay, curve, along);
    if (!column || isnan(column->least))
        return;
    *least = fmin(*least, column->least);
    *most = fmax(*most, column->largest);
}

double overlay_reach(const Screen *screen, const char *curve, bool along)
{
    double least = 0, most = 0;
    overlay_widen(screen, curve, along, &least, &most);
    return fmax(-least, most);
}

/* The rows that lie on the axis of x. */
static void rows_within(const Overlay *overlay, const Axis *x, size_t *first, size_t *end)
{
    const double *values = overlay->columns[overlay->x].values;
    *first = overlay_find(overlay, x->low);
    *end = overlay_find(overlay, x->high);
    *end = *end == overlay->count ? 0 : *end + 1;
    *first = *first == overlay->count ? 0 : *first;
    while (*first < *end && values[*first] < x->low)
        ++*first;
}

typedef struct Samples {
    const double *x, *y;
} Samples;

static double sample(const void *context, size_t index, double *x)
{
    const Samples *samples = context;
    *x = samples->x[index];
    return samples->y[index];
}

void overlay_stroke(const Screen *screen, Plot *plot, const char *curve, bool along, int dots)
{
    const OverlayColumn *column = column_of(screen->overlay, curve, along);
    size_t first, end;
    if (!column)
        return;
    const Samples samples = {screen->overlay->columns[screen->overlay->x].values, column->values};
    rows_within(screen->overlay, &plot->x, &first, &end);
    plot_begin(plot, STROKE_DOTS, LINE_SOLID, STYLE_THIRD, RANK_SECOND, '+');
    plot_curve(plot, sample, &samples, first, end, dots);
}

static void put_mark(Area inner, const Plot *plot, double x, double y)
{
    area_put(inner, axis_column(&plot->x, x, inner.rect.width), axis_row(&plot->y, y, inner.rect.height), '+',
             STYLE_THIRD);
}

/* On paper its dots are all drawn and need no marks; the legend names it. */
static void name_on_paper(Picture *picture, const char *name)
{
    PictureKey key = {.style = STYLE_THIRD};
    snprintf(key.name, sizeof key.name, "%s", name);
    picture_key(picture, &key);
}

static void draw_name(Area inner, const char *name)
{
    const int columns = 2 + glyphs_columns(name), room = inner.rect.width - columns - 1,
              x = room > 1 ? room : 1;
    for (int i = -1; i <= columns; i++)
        area_put(inner, x + i, 0, ' ', STYLE_NORMAL);
    area_put(inner, x, 0, '+', STYLE_THIRD);
    area_text(inner, x + 2, 0, name, STYLE_NORMAL);
}

/* Few values have a mark each; of many one now and then, so that they are seen where the run's own curve
 * covers them. */
void overlay_marks(const Screen *screen, Area inner, const Plot *plot, const char *curve, bool along)
{
    const OverlayColumn *column = column_of(screen->overlay, curve, along);
    const int width = inner.rect.width;
    size_t first, end;
    if (!column || width < 4)
        return;
    if (inner.canvas->picture) {
        name_on_paper(inner.canvas->picture, screen->overlay->file);
        return;
    }
    const double *x = screen->overlay->columns[screen->overlay->x].values;
    rows_within(screen->overlay, &plot->x, &first, &end);
    if (end - first <= (size_t)width / 2)
        for (size_t row = first; row < end; row++)
            put_mark(inner, plot, x[row], column->values[row]);
    else
        for (int cell = 0; cell < width; cell += MARK_EVERY) {
            const double at = plot->x.low + (plot->x.high - plot->x.low) * (cell + 0.5) / width;
            const size_t row = overlay_find(screen->overlay, at);
            if (row >= first && row < end)
                put_mark(inner, plot, x[row], column->values[row]);
        }
    draw_name(inner, screen->overlay->file);
}

double overlay_value(const Screen *screen, const char *curve, bool along, double x)
{
    const OverlayColumn *column = column_of(screen->overlay, curve, along);
    if (!column)
        return NAN;
    const Overlay *overlay = screen->overlay;
    const double *places = overlay->columns[overlay->x].values;
    size_t row = overlay_find(overlay, x);
    if (row == overlay->count || (x > places[row] && row + 1 == overlay->count))
        return NAN;
    if (x > places[row] && places[row + 1] - x < x - places[row])
        row++;
    return column->values[row];
}
