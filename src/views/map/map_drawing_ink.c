/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Places, lines, signs and words of a drawing, in cells or on paper (map_drawing.h). */
#include "views/map/map_drawing.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

Picture *drawing_paper(const Drawing *drawing)
{
    return drawing->picture;
}

double drawing_column(const Drawing *drawing, double x)
{
    const double column = 1 + (x - drawing->low) * drawing->scale;
    return drawing_paper(drawing) ? column : round(column);
}

double drawing_row(const Drawing *drawing, double share)
{
    const double up = share * (drawing->bottom - drawing->top);
    return drawing->bottom - (drawing_paper(drawing) ? up : round(up));
}

void drawing_trace(const Drawing *drawing, StrokeKind kind, Style style, int count, const double (*places)[2])
{
    Plot *plot = &drawing_paper(drawing)->plot;
    plot_begin(plot, kind, LINE_SOLID, style, RANK_EXACT, '|');
    for (int i = 0; i < count; i++)
        plot_point(plot, places[i][0], -places[i][1]);
}

void drawing_put(const Drawing *drawing, double x, double y, uint32_t glyph, Style style)
{
    if (drawing_paper(drawing))
        picture_mark(drawing_paper(drawing), x, -y, glyph, style);
    else
        area_put(drawing->area, (int)x, (int)y, glyph, style);
}

void drawing_label(const Drawing *drawing, double x, double y, int side, const char *text, Style style)
{
    if (!drawing_paper(drawing)) {
        const int columns = glyphs_columns(text);
        const int from = side > 0 ? (int)x : side < 0 ? (int)x - columns : ((int)(2 * x) + 1 - columns) / 2;
        area_text(drawing->area, from, (int)y, text, style);
        return;
    }
    PictureLabel out = {.x = x, .y = -y, .side = side, .on_line = side == 0, .style = style};
    text += strspn(text, " ");
    size_t length = strlen(text);
    while (length > 0 && text[length - 1] == ' ')
        length--;
    snprintf(out.text, sizeof out.text, "%.*s", (int)length, text);
    picture_label(drawing_paper(drawing), &out);
}
