/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Over the map: notch, zones, channel and crack as lines; supports, load and the chosen node as signs. */
#include "answers/crack_growth.h"
#include "base/math/functions.h"
#include "base/text.h"
#include "panes/entry.h"
#include "panes/screen.h"
#include "scenario/concern_body.h"
#include "scenario/concern_bonds.h"
#include "scenario/concern_loads.h"
#include "scenario/rows/rows.h"
#include "scenario/settings.h"
#include "views/map/map.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* --- the notched beam ----------------------------------------------------------------------------- */

int map_cracks_before(const Map *map, ShownRun runs[RUNS_MAX])
{
    const int n_runs = runs_of(map->screen, runs);
    int count = 0;
    for (int i = 0; i < n_runs; i++)
        if (runs[i].ghost >= 0 && runs[i].shown && runs[i].crack->count > 0)
            runs[count++] = runs[i];
    return count;
}

static void draw_notch(Map *map)
{
    const Settings *settings = map->settings;
    const double depth = settings_bonds(settings)->protected_depth, top = settings_geometry(settings)->height;
    const double end[2] = {settings_notch(settings)->position, settings_notch(settings)->depth};
    const double zones[3][4] = {
        /* middle, half the width, edge, inner side */
        {settings_loads(settings)->position, settings_loads(settings)->width / 2 + depth, top, top - depth},
        {settings_supports(settings)->left, depth, 0, depth},
        {settings_supports(settings)->right, depth, 0, depth}};
    for (int z = 0; z < 3 && depth > 0; z++) {
        const Stroke zone = {.line = LINE_DASHED, .style = STYLE_FRAME, .rank = RANK_ZONE, .letter = '~'};
        const double left = zones[z][0] - zones[z][1], right = zones[z][0] + zones[z][1];
        const double corners[4][2] = {
            {left, zones[z][2]}, {left, zones[z][3]}, {right, zones[z][3]}, {right, zones[z][2]}};
        for (int i = 0; i < 3; i++)
            map_body_line(map, corners[i], corners[i + 1], zone);
    }
    /* the paper's angle, from the notch towards the load: an answer, as the exact curves are */
    const double side = settings_loads(settings)->position < end[0] ? -1 : 1, rise = top - depth - end[1];
    const double at[2] = {end[0] + side * rise * CRACK_PAPER_SLOPE, end[1] + rise};
    if (screen_shows_exact(map->screen))
        map_body_line(
            map, end, at,
            (Stroke){.line = LINE_DOTTED, .style = STYLE_FAINT, .rank = RANK_ANGLE, .letter = '\''});
    map_body_line(map, (double[]){end[0], 0}, end,
                  (Stroke){.style = STYLE_HEADING, .rank = RANK_NOTCH, .letter = '|'});
    enum { ROWS_MAX = 512 };
    double x[ROWS_MAX], y[ROWS_MAX];
    const size_t count = crack_line(map->sim, x, y, ROWS_MAX);
    /* on a page the damage itself is seen well enough, and the line would hide it */
    const Stroke pen = {.style = STYLE_CHANGED,
                        .rank = RANK_PATH,
                        .letter = '*',
                        .coarse = strcmp(map->colouring->field, "damage") == 0};
    double from[2] = {settings_notch(map->settings)->position, settings_notch(map->settings)->depth};
    for (size_t i = 0; i < count; i++) {
        const double to[2] = {x[i], y[i]};
        map_body_line(map, from, to, pen);
        from[0] = to[0], from[1] = to[1];
    }
}

enum { SUPPORT_FIXED = 0x25b2, SUPPORT_ROLLER = 0x25cb, LOAD = 0x25bc };

/* A sign at each node of a row whose flag is up, at its edge: `side` up or down, 0: at the node. Returns the
 * last one; NULL: there is none, no such field, or no memory. */
static const PictureMark *add_flagged(Map *map, const char *name, int row, int side, uint32_t left,
                                      uint32_t right)
{
    const int field = simulation_find_field(map->sim, 0, name);
    const size_t nx = (size_t)map->body.nx, first = (size_t)row * nx, before = map->picture->n_marks;
    double *flags = field >= 0 ? malloc(nx * sizeof *flags) : NULL;
    if (flags)
        map->sim->method->field(map->sim, field, first, nx, flags);
    for (size_t i = 0; flags && i < nx; i++)
        if (flags[i] > 0)
            picture_add_mark(map->picture,
                             (PictureMark){map->drawn->x[first + i],
                                           map->drawn->y[first + i] + side * map->body.spacing / 2,
                                           i < nx / 2 ? left : right, STYLE_HEADING,
                                           side ? MARK_STANDS : MARK_PLACE, .side = {0, (signed char)side}});
    free(flags);
    return map->picture->n_marks > before ? &map->picture->marks[map->picture->n_marks - 1] : NULL;
}

/* --- rows of a plate ------------------------------------------------------------------------------ */

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

void map_row_corners(double ends[2][2], double corners[5][2])
{
    for (int i = 0; i < 5; i++) {
        corners[i][0] = ends[i == 1 || i == 2][0];
        corners[i][1] = ends[i == 2 || i == 3][1];
    }
}

/* What a plate has by rows, and its cracks. */
static void add_rows(Map *map)
{
    int chosen_kind, chosen_row;
    const Settings *settings = screen_rows_shown(map->screen, &chosen_kind, &chosen_row);
    for (int kind = 0; kind < ROW_KINDS; kind++)
        for (int row = 0; settings_have_rows(settings, kind) && row < settings->rows[kind].count; row++) {
            const bool chosen = kind == chosen_kind && row == chosen_row;
            if (kind != ROWS_LOADS || chosen) {
                double ends[2][2];
                map_row_ends(settings, kind, row, ends);
                Stroke pen = {.style = STYLE_HEADING, .rank = RANK_WALL};
                if (chosen)
                    pen = (Stroke){.style = STYLE_CHANGED, .rank = RANK_PATH};
                else if (kind == ROWS_PROTECTED)
                    pen =
                        (Stroke){.line = LINE_DASHED, .style = STYLE_FRAME, .rank = RANK_ZONE, .letter = '~'};
                else if (kind != ROWS_CUTS)
                    pen = (Stroke){.line = LINE_DASHED,
                                   .style = STYLE_HEADING,
                                   .rank = RANK_ZONE,
                                   .letter = kind == ROWS_SUPPORTS ? '=' : ':'};
                if (kind == ROWS_CUTS || kind == ROWS_LOADS)
                    map_body_line(map, ends[0], ends[1], pen);
                else if (kind != ROWS_PROBE) {
                    double corners[5][2];
                    map_row_corners(ends, corners);
                    for (int i = 0; i < 4; i++)
                        map_body_line(map, corners[i], corners[i + 1], pen);
                }
            }
        }
    const CrackFronts *fronts = experiment_fronts(map->screen->experiment);
    /* on a page the damage itself is seen well enough, and the line would hide it */
    const Stroke pen = {.style = STYLE_CHANGED, .rank = RANK_NOTCH, .letter = '*', .coarse = true};
    for (int f = 0; fronts && f < fronts->count; f++)
        for (int k = 0; k < fronts->fronts[f].n_paths; k++) {
            const CrackPath *path = &fronts->fronts[f].paths[k];
            for (size_t i = 1; i < path->count; i++)
                map_body_line(map, (double[]){path->x[i - 1], path->y[i - 1]},
                              (double[]){path->x[i], path->y[i]}, pen);
        }
}

/* --- signs of rows --------------------------------------------------------------------------------- */

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

/* Loads, tips, probe. */
static void add_row_signs(Map *map)
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
            double place[2];
            map_body_place(map, ends[i][0], ends[i][1], place);
            picture_add_mark(map->picture,
                             (PictureMark){place[0], place[1], END, STYLE_CHANGED, .kind = MARK_CHOSEN});
        }
}

/* --- all of them ----------------------------------------------------------------------------------- */

void map_add_lines(Map *map)
{
    if (map->scene.leaves) {
        /* Its walls stand still, above and below the beam. */
        const double half = map->body.size[1] / 2, begin = -settings_motion(map->settings)->channel;
        for (int side = 1; side >= -1; side -= 2)
            picture_trace(map->picture, (double[]){begin, side * half}, (double[]){0, side * half},
                          &(Stroke){.style = STYLE_HEADING, .rank = RANK_WALL, .letter = '=', .wall = side});
    }
    ShownRun before[RUNS_MAX];
    const int n_before = map_cracks_before(map, before);
    for (int i = n_before - 1; i >= 0; i--) {
        /* Notch or cuts and paths, dashed, where they were in the body; in pieces long enough for a gap. */
        enum { EVERY = 2, DOTS = 2 }; /* in the width of a cell */
        const Stroke pen = {
            .line = LINE_DASHED, .style = before[i].style, .rank = RANK_BEFORE, .letter = '"'};
        const CrackLine *crack = before[i].crack;
        double from[2] = {0, 0};
        for (size_t j = 0; j < crack->count; j++) {
            const double to[2] = {crack->x[j], crack->y[j]};
            const double dots = DOTS * math_hypot(to[0] - from[0], to[1] - from[1]) * map->drawn->scale[0];
            const bool last = j + 1 == crack->count || crack->begins[j + 1];
            if (!crack->begins[j] && dots < 2 * EVERY && !last)
                continue;
            if (!crack->begins[j])
                map_body_line(map, from, to, pen);
            from[0] = to[0], from[1] = to[1];
        }
    }
    if (map->scene.notched)
        draw_notch(map);
    if (!map->scene.bodies)
        add_rows(map);
    /* What the lines are. */
    Picture *picture = map->picture;
    if (map->scene.pressed)
        picture_key(picture, (PictureKey){LINE_SOLID, '*', STYLE_CHANGED, "crack's path", 0, 0});
    for (int i = 0; i < n_before; i++) {
        char name[sizeof before[i].word + 16];
        snprintf(name, sizeof name, "crack, %s", before[i].word);
        picture_key(picture,
                    (PictureKey){LINE_DASHED, '"', before[i].style, name, (uint32_t)before[i].key[0], 0});
    }
    if (map->scene.pressed && screen_shows_exact(map->screen))
        picture_key(picture,
                    (PictureKey){LINE_DOTTED, '\'', STYLE_FAINT, "30° from the notch (paper)", 0, 0});
    if (map->scene.pressed) {
        picture_key(picture, (PictureKey){LINE_SOLID, '|', STYLE_HEADING, "notch", 0, 0});
        picture_key(picture, (PictureKey){LINE_DASHED, '~', STYLE_FRAME, "protected", 0, 0});
    }
}

void map_add_signs(Map *map)
{
    const bool by_rows = settings_have_rows(map->settings, ROWS_PROBE); /* loads and supports too */
    if (!by_rows) {
        /* Arrows on the loaded nodes; beside them how much of the load has come. */
        const Settings *settings = map->settings;
        const PictureMark *last = add_flagged(map, "loaded", map->body.ny - 1, 1, LOAD, LOAD);
        if (last) {
            const double time = simulation_time(map->sim);
            const double share =
                settings_loads(settings)->ramp > 0 ? fmin(1, time / settings_loads(settings)->ramp) : 1;
            picture_label(map->picture, last->x, last->y, 1, STYLE_NORMAL,
                          share < 1 ? "%s MPa x %.2f" : "%s MPa",
                          text_fitted(settings_loads(settings)->stress * 1e-6, 4, 8).text, share);
        }
    }
    if (!map->scene.leaves && !by_rows) {
        /* A support that holds both ways is a triangle, one that lets the beam slide a roller. */
        const uint32_t left = map->scene.pinned ? SUPPORT_FIXED : SUPPORT_ROLLER;
        const int middle = (map->body.ny - 1) / 2;
        add_flagged(map, "held", 0, -1, left, SUPPORT_ROLLER);
        add_flagged(map, "held", middle, middle == 0 ? -1 : 0, left, SUPPORT_ROLLER);
    }
    add_row_signs(map);
    const Screen *screen = map->screen;
    const size_t node = screen->chosen.particle;
    if (node < map->body.count && !screen_is_running(screen))
        picture_add_mark(map->picture, (PictureMark){map->drawn->x[node], map->drawn->y[node], 0x25a0,
                                                     STYLE_CHANGED, .kind = MARK_CHOSEN});
}
