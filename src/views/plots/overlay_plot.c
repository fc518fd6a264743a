/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A foreign series over the plots: which view it belongs to, its stroke, marks and part of the axes. */
#include "views/plots/plots.h"
#include "run/overlay.h"

#include "picture/picture.h"

#include <math.h>

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

typedef struct Samples {
    const double *x, *y;
} Samples;

static double sample(const void *context, size_t index, double *x)
{
    const Samples *samples = context;
    *x = samples->x[index];
    return samples->y[index];
}

static void put_mark(Picture *picture, double x, double y)
{
    picture_add_mark(picture,
                     (PictureMark){.x = x, .y = y, .glyph = '+', .style = STYLE_THIRD, .kind = MARK_DOT});
}

/* Few values have a mark each; of many one now and then, so that they are seen where the run's own curve
 * covers them. */
void overlay_add(const Screen *screen, Picture *picture, const char *curve, bool along)
{
    const OverlayColumn *column = column_of(screen->overlay, curve, along);
    const Overlay *overlay = screen->overlay;
    const Axis *axis = &picture->plot.x;
    const int width = picture->across;
    if (!column)
        return;
    const double *x = overlay->columns[overlay->x].values;
    const Samples samples = {x, column->values};
    /* The rows that lie on the axis of x. */
    size_t first = overlay_find(overlay, axis->low), end = overlay_find(overlay, axis->high);
    end = end == overlay->count ? 0 : end + 1;
    first = first == overlay->count ? 0 : first;
    while (first < end && x[first] < axis->low)
        first++;
    plot_begin(&picture->plot, STROKE_DOTS, (Pen){LINE_SOLID, '+', STYLE_THIRD, RANK_SECOND, 0});
    plot_curve(&picture->plot, sample, &samples, first, end, picture->dots);
    picture_key(picture, (PictureKey){LINE_SOLID, '+', STYLE_THIRD, overlay->file, '+', 0});
    for (size_t row = first; row < end && end - first <= (size_t)width / 2; row++)
        put_mark(picture, x[row], column->values[row]);
    for (int cell = 0; cell < width && end - first > (size_t)width / 2; cell += MARK_EVERY) {
        const double at = axis->low + (axis->high - axis->low) * (cell + 0.5) / width;
        const size_t row = overlay_find(overlay, at);
        if (row >= first && row < end)
            put_mark(picture, x[row], column->values[row]);
    }
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
