/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What is drawn over the map: notch, protected zones, channel and crack as lines; supports, load and the
 * chosen node as signs. */
#include "views/map/map.h"
#include "scenario/concern_body.h"
#include "scenario/concern_bonds.h"
#include "scenario/concern_loads.h"
#include "scenario/settings.h"
#include "base/math/functions.h"
#include "answers/crack_growth.h"
#include "panes/screen_runs.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { RANK_ZONE = 1, RANK_ANGLE, RANK_BEFORE, RANK_WALL, RANK_NOTCH, RANK_PATH };

/* The letters are none of the ramp's. */

static void draw_marks(Map *map)
{
    const Area area = map->area;
    for (int y = 0; y < area.rect.height; y++)
        for (int x = 0; x < area.rect.width; x++) {
            const MapMark *mark = &map->marks[(size_t)y * (size_t)area.rect.width + (size_t)x];
            if (!mark->dots)
                continue;
            const uint32_t glyph = area.glyphs == GLYPHS_BRAILLE ? 0x2800u + mark->dots : mark->letter;
            const Cell *cell = &area.canvas->cells[(size_t)(area.rect.y + y) * (size_t)area.canvas->width +
                                                   (size_t)(area.rect.x + x)];
            if (!map->coloured || cell->style < STYLE_RAMP_0)
                area_put(area, x, y, glyph, (Style)mark->style);
            else
                area_put_back(area, x, y, glyph, map_ink(cell->style - STYLE_RAMP_0), (Style)cell->style);
        }
    memset(map->marks, 0, (size_t)area.rect.width * (size_t)area.rect.height * sizeof *map->marks);
}

/* --- the notched beam ----------------------------------------------------------------------------- */

static void draw_zone(Map *map, double left, double right, double edge, double inner)
{
    const Pen pen = {STYLE_FRAME, RANK_ZONE, 2, '~'};
    map_body_line(map, (double[]){left, edge}, (double[]){left, inner}, pen);
    map_body_line(map, (double[]){left, inner}, (double[]){right, inner}, pen);
    map_body_line(map, (double[]){right, inner}, (double[]){right, edge}, pen);
}

static void draw_crack(Map *map)
{
    enum { ROWS_MAX = 512 };
    double x[ROWS_MAX], y[ROWS_MAX];
    const size_t count = crack_line(map->sim, x, y, ROWS_MAX);
    const Pen pen = {STYLE_CHANGED, RANK_PATH, 1, '*'};
    double from[2] = {settings_notch(map->settings)->position, settings_notch(map->settings)->depth};
    for (size_t i = 0; i < count; i++) {
        const double to[2] = {x[i], y[i]};
        map_body_line(map, from, to, pen);
        from[0] = to[0], from[1] = to[1];
    }
}

static const CrackLine *crack_of(const Map *map, const ShownRun *ghost)
{
    return &experiment_ghosts(screen_clock_run(map->screen))[ghost->ghost].crack;
}

int map_cracks_before(const Map *map, ShownRun runs[RUNS_MAX])
{
    const int n_runs = map->scene.notched ? runs_of(map->screen, runs) : 0;
    int count = 0;
    for (int i = 0; i < n_runs; i++)
        if (runs[i].ghost >= 0 && runs[i].shown && crack_of(map, &runs[i])->count > 0)
            runs[count++] = runs[i];
    return count;
}

/* Notch and path, dashed, where they were in the body; in pieces long enough for a gap. */
static void draw_crack_before(Map *map, const ShownRun *run)
{
    enum { EVERY = 2, DOTS = 2 }; /* in the width of a cell */
    const Pen pen = {run->style, RANK_BEFORE, EVERY, '"'};
    const CrackLine *crack = crack_of(map, run);
    double from[2] = {settings_notch(run->settings)->position, settings_notch(run->settings)->depth};
    map_body_line(map, (double[]){from[0], 0}, from, pen);
    for (size_t i = 0; i < crack->count; i++) {
        const double to[2] = {crack->x[i], crack->y[i]};
        const double dots = DOTS * math_hypot(to[0] - from[0], to[1] - from[1]) * map->scale_x;
        if (dots < 2 * EVERY && i + 1 < crack->count)
            continue;
        map_body_line(map, from, to, pen);
        from[0] = to[0], from[1] = to[1];
    }
}

static void draw_notch(Map *map)
{
    const Settings *settings = map->settings;
    const double depth = settings_bonds(settings)->protected_depth, top = settings_geometry(settings)->height;
    const double end[2] = {settings_notch(settings)->position, settings_notch(settings)->depth};
    if (depth > 0) {
        const double half = settings_loads(settings)->width / 2 + depth;
        draw_zone(map, settings_loads(settings)->position - half, settings_loads(settings)->position + half,
                  top, top - depth);
        draw_zone(map, settings_supports(settings)->left - depth, settings_supports(settings)->left + depth,
                  0, depth);
        draw_zone(map, settings_supports(settings)->right - depth, settings_supports(settings)->right + depth,
                  0, depth);
    }
    /* the paper's angle, from the notch towards the load: an answer, as the exact curves are */
    const double side = settings_loads(settings)->position < end[0] ? -1 : 1, rise = top - depth - end[1];
    const double at[2] = {end[0] + side * rise * math_tan(CRACK_PAPER_ANGLE * M_PI / 180), end[1] + rise};
    if (screen_shows_exact(map->screen))
        map_body_line(map, end, at, (Pen){STYLE_FAINT, RANK_ANGLE, 4, '\''});
    ShownRun before[RUNS_MAX];
    for (int i = map_cracks_before(map, before) - 1; i >= 0; i--)
        draw_crack_before(map, &before[i]);
    map_body_line(map, (double[]){end[0], 0}, end, (Pen){STYLE_HEADING, RANK_NOTCH, 1, '|'});
    /* on paper the damage itself is seen well enough, and the line would hide it */
    if (!map->picture || strcmp(map->colouring->field, "damage") != 0)
        draw_crack(map);
}

enum { TALL_MAP = 12 };

static bool is_blank(Area area, int x, int y, int width)
{
    for (int i = x; i < x + width && i < area.rect.width; i++)
        if (area.canvas
                ->cells[(size_t)(area.rect.y + y) * (size_t)area.canvas->width + (size_t)(area.rect.x + i)]
                .glyph > ' ')
            return false;
    return true;
}

/* What the lines are: beside the beam or, in a large map, in a row of their own. */
static void name_lines(const Map *map)
{
    enum { LINES = 5 };
    const bool dots = map->area.glyphs == GLYPHS_BRAILLE;
    Legend lines[LINES];
    int count = 0;
    lines[count++] = (Legend){LINE_SOLID, 0, STYLE_CHANGED, "crack's path", dots ? "⠔⠊" : "**"};
    ShownRun before[RUNS_MAX];
    if (map_cracks_before(map, before) > 0)
        lines[count++] = (Legend){LINE_DASHED, 0, before[0].style, "crack before", dots ? "⠡⠊" : "\"\""};
    if (screen_shows_exact(map->screen))
        lines[count++] = (Legend){LINE_SOLID, 0, STYLE_FAINT, "30° (paper)", dots ? "⠠⠂" : "''"};
    lines[count++] = (Legend){LINE_SOLID, 0, STYLE_HEADING, "notch", dots ? "⢸ " : "| "};
    lines[count++] = (Legend){LINE_SOLID, 0, STYLE_FRAME, "protected", dots ? "⠒⠂" : "~~"};
    const Area area = map->area;
    if (map->legend_at > 0)
        for (int i = 0; i < count; i++)
            legend_draw(area_part(area, map->legend_at, area.rect.height - 1 - (count > 4 ? count : 4),
                                  area.rect.width, LINES),
                        0, i, &lines[i], 1);
    else if (area.rect.height >= TALL_MAP && is_blank(area, 0, 0, area.rect.width))
        legend_draw(area, 0, 0, lines, count);
}

/* --- the channel ---------------------------------------------------------------------------------- */

/* Its walls stand still, above and below the beam. */
static void draw_channel(Map *map)
{
    const Body *body = &map->body;
    const Pen pen = {STYLE_HEADING, RANK_WALL, 1, '='};
    for (int side = -1; side <= 1; side += 2) {
        double from, to, y;
        map_place(map, -settings_motion(map->settings)->channel, side * body->size[1] / 2, 0, 0, &from, &y);
        map_place(map, 0, side * body->size[1] / 2, 0, 0, &to, &y);
        y += side > 0 ? -0.3 : 0.3;
        y = side > 0 ? floor(y) + 0.8 - 1e-6 : ceil(y) - 1 + 0.1;
        map_line(map, from, y, to, y, pen);
        map_line(map, to, y, to, y + (side > 0 ? -0.6 : 0.6), pen);
    }
}

void map_draw_lines(Map *map)
{
    if (map->scene.leaves)
        draw_channel(map);
    if (map->scene.notched)
        draw_notch(map);
    map_draw_rows(map);
    if (!map->picture)
        draw_marks(map);
}

/* --- signs ---------------------------------------------------------------------------------------- */

enum { SUPPORT_FIXED = 0x25b2, SUPPORT_ROLLER = 0x25cb, LOAD = 0x25bc };

/* Flags of the nodes of a row; NULL: no such field, or no memory. */
static double *flags_of(const Map *map, const char *name, int row)
{
    const int field = simulation_find_field(map->sim, 0, name);
    const size_t nx = (size_t)map->body.nx;
    double *flags = field >= 0 ? malloc(nx * sizeof *flags) : NULL;
    if (flags)
        map->sim->method->field(map->sim, field, (size_t)row * nx, nx, flags);
    return flags;
}

/* A support that holds both ways is a triangle, one that lets the beam slide a roller. */
static void draw_supports(Map *map, int row)
{
    const bool pinned = map->scene.pinned;
    double *held = flags_of(map, "held", row), column, y;
    const size_t nx = (size_t)map->body.nx;
    for (size_t i = 0; held && i < nx; i++) {
        if (held[i] <= 0)
            continue;
        map_node_place(map, (size_t)row * nx + i, &column, &y);
        if (map->picture) {
            y += row == 0 ? map->body.spacing * map->scale_y / 2 : 0;
            map_picture_sign(map, column, y, pinned && i < nx / 2 ? SUPPORT_FIXED : SUPPORT_ROLLER,
                             STYLE_HEADING);
            continue;
        }
        if (row == 0) /* just below the lowest row of nodes */
            y = fmin(floor(y + map->body.spacing * map->scale_y / 2 + 0.75), map->area.rect.height - 1);
        area_put(map->area, (int)floor(column), (int)floor(y),
                 pinned && i < nx / 2 ? SUPPORT_FIXED : SUPPORT_ROLLER, STYLE_HEADING);
    }
    free(held);
}

/* Arrows on the loaded nodes; beside them how much of the load has come. */
static void draw_load(Map *map)
{
    const Settings *settings = map->settings;
    const size_t nx = (size_t)map->body.nx;
    double *loaded = flags_of(map, "loaded", map->body.ny - 1), column, y;
    const int lowest = map->area.rect.height - 1;
    int last = -1, last_row = 0;
    for (size_t i = 0; loaded && i < nx; i++) {
        if (loaded[i] <= 0)
            continue;
        map_node_place(map, (size_t)(map->body.ny - 1) * nx + i, &column, &y);
        if (map->picture) {
            map_picture_sign(map, column, y - map->body.spacing * map->scale_y / 2, LOAD, STYLE_HEADING);
            continue;
        }
        last = (int)floor(column);
        /* displacements drawn much too large carry the load out of the picture */
        const double row = floor(y - map->body.spacing * map->scale_y / 2 - 0.75);
        last_row = (int)fmin(fmax(row, 0), lowest);
        area_put(map->area, last, last_row, LOAD, STYLE_HEADING);
    }
    free(loaded);
    if (last < 0)
        return;
    const double time = simulation_time(map->sim);
    const double share =
        settings_loads(settings)->ramp > 0 ? fmin(1, time / settings_loads(settings)->ramp) : 1;
    char text[64], stress[NUMBER_TEXT_MAX];
    while (last_row > 0 && !is_blank(map->area, last + 2, last_row, 14))
        last_row--;
    text_fitted(settings_loads(settings)->stress * 1e-6, 4, 8, stress);
    snprintf(text, sizeof text, "%s MPa", stress);
    if (share < 1)
        text_append(text, sizeof text, " x %.2f", share);
    area_text_whole(map->area, last + 2, last_row, map->area.rect.width - last - 2, text, STYLE_NORMAL);
}

static void draw_chosen(Map *map)
{
    const Screen *screen = map->screen;
    if (map->picture || screen->chosen.particle >= map->body.count || screen->playback.state == STATE_RUNNING)
        return;
    double column, row;
    map_node_place(map, screen->chosen.particle, &column, &row);
    if (column >= 0 && row >= 0)
        area_put(map->area, (int)column, (int)row, 0x25a0, STYLE_CHANGED);
}

void map_draw_signs(Map *map)
{
    const bool by_rows = settings_have_rows(map->settings, ROWS_PROBE); /* loads and supports too */
    if (!by_rows)
        draw_load(map);
    if (map->scene.pressed && !map->nodes_seen && !map->picture)
        name_lines(map);
    if (!map->scene.leaves && !by_rows) {
        draw_supports(map, 0);
        draw_supports(map, (map->body.ny - 1) / 2);
    }
    map_draw_row_signs(map);
    draw_chosen(map);
}
