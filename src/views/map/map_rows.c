/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What a plate has by rows of its scenario, over its map: cuts as lines, regions as outlines, loads as arrows
 * at the edge, the probe; and the cracks that grow from the cuts. The row that is chosen among the
 * parameters, or being moved, is drawn on top, its end that the arrows move with a mark. */
#include "views/map/map.h"
#include "panes/parameters_shown.h"
#include "scenario/concern_body.h"
#include "scenario/settings.h"
#include "scenario/rows/rows.h"
#include "answers/crack_growth.h"

enum { RANK_REGION = 1, RANK_CUT = 4, RANK_CRACK, RANK_CHOSEN };
enum { PROBE = '+', END = 0x25a0, TIP = 0x25cf, FORK = 'Y' };

void map_row_ends(const Settings *settings, int kind, int row, double ends[2][2])
{
    double value[ROW_VALUES_MAX];
    for (int i = 0; i < row_kinds[kind].n_columns; i++)
        value[i] = settings_row_value(settings, kind, row, i);
    const int edge = (int)value[0];
    const bool lies = edge == ROW_TOP || edge == ROW_BOTTOM;
    for (int i = 0; i < 2; i++)
        if (kind == ROWS_LOADS) {
            ends[i][!lies] = value[1 + i];
            ends[i][lies] = edge == ROW_TOP     ? settings_geometry(settings)->height
                            : edge == ROW_RIGHT ? settings_geometry(settings)->length
                                                : 0;
        } else {
            const int first = kind == ROWS_PROBE ? 0 : 2 * i;
            ends[i][0] = value[first];
            ends[i][1] = value[first + 1];
        }
}

void map_add_rows(Map *map)
{
    int chosen_kind, chosen_row;
    const Settings *settings = screen_rows_shown(map->screen, &chosen_kind, &chosen_row);
    for (int kind = 0; kind < ROW_KINDS; kind++)
        for (int row = 0; settings_have_rows(settings, kind) && row < settings->rows[kind].count; row++) {
            const bool chosen = kind == chosen_kind && row == chosen_row;
            if (kind != ROWS_LOADS || chosen) {
                double ends[2][2];
                map_row_ends(settings, kind, row, ends);
                Stroke pen = {.style = STYLE_HEADING, .rank = RANK_CUT};
                if (chosen)
                    pen = (Stroke){.style = STYLE_CHANGED, .rank = RANK_CHOSEN};
                else if (kind == ROWS_PROTECTED)
                    pen = (Stroke){
                        .line = LINE_DASHED, .style = STYLE_FRAME, .rank = RANK_REGION, .letter = '~'};
                else if (kind != ROWS_CUTS)
                    pen = (Stroke){.line = LINE_DASHED,
                                   .style = STYLE_HEADING,
                                   .rank = RANK_REGION,
                                   .letter = kind == ROWS_SUPPORTS ? '=' : ':'};
                if (kind == ROWS_CUTS || kind == ROWS_LOADS)
                    map_body_line(map, ends[0], ends[1], pen);
                else if (kind != ROWS_PROBE) {
                    const double *a = ends[0], *c = ends[1];
                    const double b[2] = {c[0], a[1]}, d[2] = {a[0], c[1]};
                    map_body_line(map, a, b, pen);
                    map_body_line(map, b, c, pen);
                    map_body_line(map, c, d, pen);
                    map_body_line(map, d, a, pen);
                }
            }
        }
    const CrackFronts *fronts = experiment_fronts(map->screen->experiment);
    /* on a page the damage itself is seen well enough, and the line would hide it */
    const Stroke pen = {.style = STYLE_CHANGED, .rank = RANK_CRACK, .letter = '*', .coarse = true};
    for (int f = 0; fronts && f < fronts->count; f++)
        for (int k = 0; k < fronts->fronts[f].n_paths; k++) {
            const CrackPath *path = &fronts->fronts[f].paths[k];
            for (size_t i = 1; i < path->count; i++)
                map_body_line(map, (double[]){path->x[i - 1], path->y[i - 1]},
                              (double[]){path->x[i], path->y[i]}, pen);
        }
}

/* --- signs ------------------------------------------------------------------------------------------- */

static void sign_at(Map *map, const double at[2], uint32_t glyph, Style style)
{
    double place[2];
    map_body_place(map, at[0], at[1], place);
    picture_mark(map->picture, place[0], place[1], glyph, style);
}

void map_row_side(int edge, signed char side[2])
{
    side[0] = (signed char)((edge == ROW_RIGHT) - (edge == ROW_LEFT));
    side[1] = (signed char)((edge == ROW_TOP) - (edge == ROW_BOTTOM));
}

void map_add_row_signs(Map *map)
{
    int chosen_kind, chosen_row;
    const Settings *settings = screen_rows_shown(map->screen, &chosen_kind, &chosen_row);
    const RowsShown *shown = &map->screen->parameters->rows;
    if (!settings_have_rows(settings, ROWS_PROBE))
        return;
    for (int row = 0; row < settings->rows[ROWS_LOADS].count; row++) {
        /* Arrows along the stretch, in the direction of the traction, just outside the edge. */
        const Style style = chosen_kind == ROWS_LOADS && chosen_row == row ? STYLE_CHANGED : STYLE_HEADING;
        double ends[2][2];
        map_row_ends(settings, ROWS_LOADS, row, ends);
        const double sx = settings_row_value(settings, ROWS_LOADS, row, 3),
                     sy = settings_row_value(settings, ROWS_LOADS, row, 4);
        PictureMark arrow = {.glyph = glyph_arrow(2 * sx, -sy), .style = style, .kind = MARK_BESIDE};
        map_row_side((int)settings_row_value(settings, ROWS_LOADS, row, 0), arrow.side);
        const size_t first = map->picture->n_marks;
        if (sx != 0 || sy != 0)
            picture_spread(map->picture, ends[0], ends[1], map->drawn->scale, &arrow);
        for (size_t i = first; i < map->picture->n_marks; i++) { /* they go with the body */
            PictureMark *mark = &map->picture->marks[i];
            double place[2];
            map_body_place(map, mark->x, mark->y, place);
            mark->x = place[0], mark->y = place[1];
        }
    }
    /* The tips of the cracks, and where they branched. */
    const CrackFronts *fronts = experiment_fronts(map->screen->experiment);
    for (int f = 0; fronts && f < fronts->count; f++) {
        const CrackFront *front = &fronts->fronts[f];
        for (int k = 0; k < front->n_tips; k++)
            sign_at(map, front->tips[k], TIP, STYLE_CHANGED);
        if (front->branched)
            sign_at(map, front->branch, FORK, STYLE_CHANGED);
    }
    double ends[2][2];
    map_row_ends(settings, ROWS_PROBE, 0, ends);
    sign_at(map, ends[0], PROBE, chosen_kind == ROWS_PROBE ? STYLE_CHANGED : STYLE_HEADING);
    if (!shown->placing)
        return;
    map_row_ends(settings, chosen_kind, chosen_row, ends);
    for (int i = 0; i < 2; i++)
        if (shown->end == i || shown->end == ROW_BOTH_ENDS) {
            const double *end = ends[i];
            double place[2];
            map_body_place(map, end[0], end[1], place);
            picture_add_mark(
                map->picture,
                (PictureMark){
                    .x = place[0], .y = place[1], .glyph = END, .style = STYLE_CHANGED, .kind = MARK_CHOSEN});
        }
}
