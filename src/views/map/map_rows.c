/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What a plate has by rows of its scenario, over its map: cuts as lines, regions as outlines, loads as arrows
 * at the edge, the probe; and the cracks that grow from the cuts. The row that is chosen among the
 * parameters, or being moved, is drawn on top, its end that the arrows move with a mark. */
#include "views/map/map.h"
#include "scenario/concern_body.h"
#include "scenario/settings.h"
#include "scenario/rows/rows.h"
#include "answers/crack_growth.h"

#include <math.h>

enum { RANK_REGION = 1, RANK_CUT = 4, RANK_CRACK, RANK_CHOSEN };
enum { PROBE = '+', END = 0x25a0, TIP = 0x25cf, FORK = 'Y' };

typedef struct Place {
    double x, y;
} Place;

/* Both ends of a row as places: of a load along its edge; of the probe twice the same. */
static void ends_of(const Settings *settings, int kind, int row, Place ends[2])
{
    double value[ROW_VALUES_MAX];
    for (int i = 0; i < row_kinds[kind].n_columns; i++)
        value[i] = settings_row_value(settings, kind, row, i);
    if (kind == ROWS_PROBE) {
        ends[0] = ends[1] = (Place){value[0], value[1]};
    } else if (kind == ROWS_LOADS) {
        const int edge = (int)value[0];
        const bool lies = edge == ROW_TOP || edge == ROW_BOTTOM;
        const double at = edge == ROW_TOP     ? settings_geometry(settings)->height
                          : edge == ROW_RIGHT ? settings_geometry(settings)->length
                                              : 0;
        for (int i = 0; i < 2; i++)
            ends[i] = lies ? (Place){value[1 + i], at} : (Place){at, value[1 + i]};
    } else {
        ends[0] = (Place){value[0], value[1]};
        ends[1] = (Place){value[2], value[3]};
    }
}

void map_row_ends(const Settings *settings, int kind, int row, double ends[2][2])
{
    Place places[2];
    ends_of(settings, kind, row, places);
    for (int i = 0; i < 2; i++)
        ends[i][0] = places[i].x, ends[i][1] = places[i].y;
}

uint32_t map_arrow(double sx, double sy)
{
    return fabs(sx) > fabs(sy) ? (sx > 0 ? 0x2192 : 0x2190) : sy > 0 ? 0x2191 : 0x2193;
}

static void line_between(Map *map, Place a, Place b, Pen pen)
{
    map_body_line(map, (double[]){a.x, a.y}, (double[]){b.x, b.y}, pen);
}

static void outline(Map *map, const Place ends[2], Pen pen)
{
    const Place a = ends[0], c = ends[1], b = {c.x, a.y}, d = {a.x, c.y};
    line_between(map, a, b, pen);
    line_between(map, b, c, pen);
    line_between(map, c, d, pen);
    line_between(map, d, a, pen);
}

static void draw_row(Map *map, const Settings *settings, int kind, int row, bool chosen)
{
    Place ends[2];
    ends_of(settings, kind, row, ends);
    Pen pen = {STYLE_HEADING, RANK_CUT, 1, 0};
    if (chosen)
        pen = (Pen){STYLE_CHANGED, RANK_CHOSEN, 1, 0};
    else if (kind == ROWS_PROTECTED)
        pen = (Pen){STYLE_FRAME, RANK_REGION, 2, '~'};
    else if (kind != ROWS_CUTS)
        pen = (Pen){STYLE_HEADING, RANK_REGION, 2, kind == ROWS_SUPPORTS ? '=' : ':'};
    if (kind == ROWS_CUTS || kind == ROWS_LOADS)
        line_between(map, ends[0], ends[1], pen);
    else if (kind != ROWS_PROBE)
        outline(map, ends, pen);
}

static void draw_cracks(Map *map)
{
    const CrackFronts *fronts = experiment_fronts(map->screen->experiment);
    const Pen pen = {STYLE_CHANGED, RANK_CRACK, 1, '*'};
    for (int f = 0; fronts && f < fronts->count; f++)
        for (int k = 0; k < fronts->fronts[f].n_paths; k++) {
            const CrackPath *path = &fronts->fronts[f].paths[k];
            for (size_t i = 1; i < path->count; i++)
                line_between(map, (Place){path->x[i - 1], path->y[i - 1]}, (Place){path->x[i], path->y[i]},
                             pen);
        }
}

void map_draw_rows(Map *map)
{
    int chosen_kind, chosen_row;
    const Settings *settings = screen_rows_shown(map->screen, &chosen_kind, &chosen_row);
    for (int kind = 0; kind < ROW_KINDS; kind++)
        for (int row = 0; settings_have_rows(settings, kind) && row < settings->rows[kind].count; row++) {
            const bool chosen = kind == chosen_kind && row == chosen_row;
            if (kind != ROWS_LOADS || chosen)
                draw_row(map, settings, kind, row, chosen);
        }
    /* on paper the damage itself is seen well enough, and the line would hide it */
    if (!map->picture)
        draw_cracks(map);
}

/* --- signs ------------------------------------------------------------------------------------------- */

static void sign_at(const Map *map, Place place, double away_x, double away_y, uint32_t glyph, Style style)
{
    double column, row;
    map_body_place(map, place.x, place.y, &column, &row);
    const bool on_paper = map->picture; /* an arrow is as long as a column is wide */
    column += (on_paper ? 0.9 : 1) * away_x;
    row += (on_paper ? 0.5 : 1) * away_y;
    if (on_paper)
        map_picture_sign((Map *)map, column, row, glyph, style);
    else if (column >= 0 && row >= 0 && column < map->area.rect.width && row < map->area.rect.height)
        area_put(map->area, (int)column, (int)row, glyph, style);
}

/* Arrows along the stretch, in the direction of the traction, just outside the edge. */
static void draw_load(const Map *map, const Settings *settings, int row, Style style)
{
    enum { APART = 4 };
    Place ends[2];
    ends_of(settings, ROWS_LOADS, row, ends);
    const double sx = settings_row_value(settings, ROWS_LOADS, row, 3),
                 sy = settings_row_value(settings, ROWS_LOADS, row, 4);
    const int edge = (int)settings_row_value(settings, ROWS_LOADS, row, 0);
    const uint32_t arrow = map_arrow(sx, sy);
    const double away_x = edge == ROW_LEFT    ? -1
                          : edge == ROW_RIGHT ? 1
                                              : 0,
                 away_y = edge == ROW_TOP      ? -1
                          : edge == ROW_BOTTOM ? 1
                                               : 0;
    const double length =
        fmax(fabs(ends[1].x - ends[0].x) * map->scale_x, 2 * fabs(ends[1].y - ends[0].y) * map->scale_y);
    const int count = length < 1e4 ? 1 + (int)(length / APART) : 1;
    if (sx == 0 && sy == 0)
        return;
    for (int i = 0; i <= count; i++) {
        const double share = (double)i / count;
        sign_at(
            map,
            (Place){ends[0].x + share * (ends[1].x - ends[0].x), ends[0].y + share * (ends[1].y - ends[0].y)},
            away_x, away_y, arrow, style);
    }
}

/* The tips of the cracks, and where they branched. */
static void draw_tips(const Map *map)
{
    const CrackFronts *fronts = experiment_fronts(map->screen->experiment);
    for (int f = 0; fronts && f < fronts->count; f++) {
        const CrackFront *front = &fronts->fronts[f];
        for (int k = 0; k < front->n_tips; k++)
            sign_at(map, (Place){front->tips[k][0], front->tips[k][1]}, 0, 0, TIP, STYLE_CHANGED);
        if (front->branched)
            sign_at(map, (Place){front->branch[0], front->branch[1]}, 0, 0, FORK, STYLE_CHANGED);
    }
}

void map_draw_row_signs(const Map *map)
{
    int chosen_kind, chosen_row;
    const Settings *settings = screen_rows_shown(map->screen, &chosen_kind, &chosen_row);
    const RowsShown *shown = &map->screen->parameters.rows;
    if (!settings_have_rows(settings, ROWS_PROBE))
        return;
    for (int row = 0; row < settings->rows[ROWS_LOADS].count; row++)
        draw_load(map, settings, row,
                  chosen_kind == ROWS_LOADS && chosen_row == row ? STYLE_CHANGED : STYLE_HEADING);
    draw_tips(map);
    Place ends[2];
    ends_of(settings, ROWS_PROBE, 0, ends);
    sign_at(map, ends[0], 0, 0, PROBE, chosen_kind == ROWS_PROBE ? STYLE_CHANGED : STYLE_HEADING);
    if (!shown->placing)
        return;
    ends_of(settings, chosen_kind, chosen_row, ends);
    for (int i = 0; i < 2; i++)
        if (shown->end == i || shown->end == ROW_BOTH_ENDS)
            sign_at(map, ends[i], 0, 0, END, STYLE_CHANGED);
}
