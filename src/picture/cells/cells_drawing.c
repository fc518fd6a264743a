/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A body with its dimensions in cells: lines are drawn with the characters of frames, whose arms meet where
 * lines do, and what lies at an angle with its own. Places are whole columns and rows. */
#include "picture/cells/cells.h"

#include <math.h>
#include <stdio.h>

enum { LEFT = 1, RIGHT = 2, UP = 4, DOWN = 8 };

/* Characters of frames by their arms. */
static const uint32_t frames[16] = {' ',    0x2574, 0x2576, 0x2500, 0x2575, 0x2518, 0x2514, 0x2534,
                                    0x2577, 0x2510, 0x250c, 0x252c, 0x2502, 0x2524, 0x251c, 0x253c};

static int arms_of(uint32_t glyph)
{
    int arms = 15;
    while (arms > 0 && frames[arms] != glyph)
        arms--;
    return arms;
}

static void add_arms(Area area, int x, int y, int arms, Style style)
{
    if (x >= 0 && y >= 0 && x < area.rect.width && y < area.rect.height)
        area_put(area, x, y, frames[arms | arms_of(area_cell(area, x, y)->glyph)], style);
}

static void draw_line(Area area, double from_x, double from_y, double to_x, double to_y, Style style)
{
    const double across = to_x - from_x, down = to_y - from_y, count = round(fmax(fabs(across), fabs(down)));
    const bool whole =
        from_x == round(from_x) && to_x == round(to_x) && from_y == round(from_y) && to_y == round(to_y);
    if (!whole && fabs(across) + fabs(down) <= 1) {
        const int x = (int)round((from_x + to_x) / 2 - 0.01), y = (int)round((from_y + to_y) / 2);
        /* A tick lies within a cell, on one side of its middle or on both. */
        const double least = 0.01;
        add_arms(area, x, y,
                 (fmin(from_x, to_x) < x - least ? LEFT : 0) | (fmax(from_x, to_x) > x + least ? RIGHT : 0) |
                     (fmin(from_y, to_y) < y - least ? UP : 0) | (fmax(from_y, to_y) > y + least ? DOWN : 0),
                 style);
        return;
    }
    const bool lies = fabs(across) > 3 * fabs(down), stands = fabs(down) > 2 * fabs(across);
    for (int i = 0; i <= count; i++) {
        const int x = (int)round(from_x + across * i / count), y = (int)round(from_y + down * i / count);
        const bool first = i == 0, last = i == count, back = (lies ? across : down) < 0;
        const bool low = first == back || !(first || last), high = last == back || !(first || last);
        if (lies || stands)
            add_arms(area, x, y, low * (lies ? LEFT : UP) | high * (lies ? RIGHT : DOWN), style);
        else
            area_put(area, x, y, across * down > 0 ? 0x2572 : 0x2571, style);
    }
}

void cells_drawing(const Picture *picture, Area area, Style heading)
{
    char title[2 * PICTURE_TEXT_MAX + 2], scale[PICTURE_TEXT_MAX];
    const int lowest = area.rect.height - 1;
    for (int i = 0; i < picture->plot.n_strokes; i++) {
        const Stroke *stroke = &picture->plot.strokes[i];
        const double *points = picture->plot.points + 2 * stroke->first;
        if (stroke->kind == STROKE_BAND && stroke->count >= 4) {
            /* A wall beside an edge: half a row, the one that is nearer to it. */
            const double near = -points[1], far = -points[3];
            for (int x = (int)round(points[0]); x <= (int)round(points[4]); x++)
                area_put(area, x, (int)round(far), far > near ? 0x2580 : 0x2584, stroke->style);
        }
        for (size_t j = 1; j < stroke->count && stroke->kind == STROKE_LINE; j++)
            draw_line(area, points[2 * j - 2], -points[2 * j - 1], points[2 * j], -points[2 * j + 1],
                      stroke->style);
    }
    /* An arm that meets none is a line of its own. */
    for (int y = 0; y < area.rect.height; y++)
        for (int x = 0; x < area.rect.width; x++) {
            const Cell *cell = area_cell(area, x, y);
            const int arms = arms_of(cell->glyph);
            if (arms == LEFT || arms == RIGHT || arms == UP || arms == DOWN)
                area_put(area, x, y, arms == LEFT || arms == RIGHT ? 0x2500 : 0x2502, (Style)cell->style);
        }
    for (size_t i = 0; i < picture->n_marks; i++) {
        /* A load as wide as it is. */
        const PictureMark *mark = &picture->marks[i];
        const bool beside = mark->kind != MARK_PLACE;
        const int y = (int)round(-mark->y) - (beside ? mark->side[1] : 0);
        for (double x = mark->x - mark->half; x <= mark->x + mark->half; x++)
            area_put(area, (int)round(x) + (beside ? mark->side[0] : 0), y, mark->glyph, mark->style);
    }
    for (int i = 0; i < picture->n_labels; i++) {
        /* Words keep a space from lines that they break. */
        const PictureLabel *label = &picture->labels[i];
        char text[sizeof label->text + 2];
        snprintf(text, sizeof text, label->style == STYLE_NORMAL ? " %s " : "%s", label->text);
        const int columns = glyphs_columns(text), y = (int)round(-label->y);
        const int from = label->side > 0   ? (int)label->x
                         : label->side < 0 ? (int)label->x - columns
                                           : ((int)(2 * label->x) + 1 - columns) / 2;
        area_text(area, from, y, text, label->style);
    }
    cells_plain_factors(picture->notes[0].text, scale);
    snprintf(title, sizeof title, "%s  %s", picture->heading, scale);
    area_rule(area, title, heading);
    if (-picture->plot.y.low <= lowest)
        area_phrases(area, 1, lowest, area.rect.width - 2, 1, picture->notes[1].text, STYLE_FAINT);
}
