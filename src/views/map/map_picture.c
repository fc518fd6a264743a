/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The map of a beam on paper: its nodes as pieces with their colours, and what is drawn over them as lines
 * and signs, in millimetres of the beam, displacements enlarged as on the screen. */
#include "views/map/map.h"
#include "picture/picture.h"

#include "answers/crack_growth.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* --- the pieces ------------------------------------------------------------------------------------ */

static void take_nodes(const Map *map, PictureMap *out)
{
    const bool hides = strcmp(map->colouring->field, "damage") != 0;
    for (size_t node = 0; node < map->body.count; node++) {
        double column, row;
        map_node_place(map, node, &column, &row);
        map_picture_place(map, column, row, &out->x[node], &out->y[node]);
        out->value[node] = hides && map->damage[node] > CRACK_DAMAGE ? NAN : map->value[node];
    }
    out->size = map->body.spacing / MAP_MILLI;
    out->enlarged = map->enlarged;
    out->low = map->low;
    out->high = map->high;
    out->is_signed = map->colouring->is_signed;
    snprintf(out->unit, sizeof out->unit, "%s", map->colouring->unit);
}

/* What is seen: as much as on the screen; a beam that is pressed fills the picture, but for its supports. */
static void take_axes(const Map *map, Picture *picture)
{
    const Body *body = &map->body;
    double low[2], high[2];
    map_picture_place(map, 0, map->area.rect.height, &low[0], &low[1]);
    map_picture_place(map, map->area.rect.width, 0, &high[0], &high[1]);
    if (map->scene.pressed && map->screen->eye.magnified <= 1)
        for (int d = 0; d < 2; d++) {
            const double margin = (d == 0 ? 0.01 : 0.1) * body->size[d];
            low[d] = (body->low[d] - margin) / MAP_MILLI;
            high[d] = (body->low[d] + body->size[d] + margin) / MAP_MILLI;
        }
    const Axis x = axis_with_ticks(axis_make(low[0], high[0]), map->area.rect.width / 9);
    const Axis y = axis_with_ticks(axis_make(low[1], high[1]), 5);
    picture_axes(picture, x, "x, mm", "", y, "", "");
}

static void name_lines(Picture *picture, const Map *map)
{
    static const PictureKey keys[] = {
        {LINE_SOLID, '*', STYLE_CHANGED, "crack's path", 0, 0},
        {LINE_DOTTED, '.', STYLE_FAINT, "30° from the notch (paper)", 0, 0},
        {LINE_SOLID, '|', STYLE_HEADING, "notch", 0, 0},
        {LINE_DASHED, '-', STYLE_FRAME, "protected", 0, 0},
    };
    for (size_t i = 0; i < sizeof keys / sizeof *keys; i++)
        for (int k = 0; k < picture->plot.n_strokes && map->scene.pressed; k++)
            if (picture->plot.strokes[k].style == keys[i].style &&
                picture->plot.strokes[k].line == keys[i].line) {
                picture_key(picture, keys[i]);
                break;
            }
    ShownRun before[RUNS_MAX];
    const int n_before = map_cracks_before(map, before);
    for (int i = 0; i < n_before; i++) {
        PictureKey key = runs_key(&before[i]);
        char name[sizeof before[i].word + 16];
        snprintf(name, sizeof name, "crack, %s", before[i].word);
        key.line = LINE_DASHED;
        key.name = name;
        picture_key(picture, key);
    }
}

void map_picture(Map *map)
{
    Picture *picture = map->picture;
    PictureMap *out = picture_map(picture, map->body.nx, map->body.ny);
    if (!out)
        return;
    picture->stretch = map->stretch;
    take_nodes(map, out);
    take_axes(map, picture);
    map_draw_lines(map);
    map_draw_signs(map);
    name_lines(picture, map);
    picture_heading(picture, map_meaning(map));
}
