/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A body in the plane as it lies, coloured by a field, or drawn with its dimensions. Every factor is stated.
 */
#include "views/map/map.h"
#include "scenario/concern_body.h"
#include "scenario/concern_loads.h"
#include "picture/words/words.h"
#include "views/views.h"
#include "base/math/functions.h"
#include "base/text.h"
#include "answers/crack_growth.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static bool in_plane(const Experiment *experiment)
{
    return simulation_has(experiment_simulation(experiment), HAS_PLANE);
}

static int variants_of(const Screen *screen)
{
    return in_plane(screen->experiment) ? map_variants(experiment_simulation(screen->experiment)) : 1;
}

static MapVariant shown(const Screen *screen, int variant)
{
    return map_variant(experiment_simulation(screen->experiment), variant);
}

static const char *word_of(const Screen *screen, int variant)
{
    return in_plane(screen->experiment) ? parameter_colour_words[shown(screen, variant)] : NULL;
}

static bool shows_start(const Screen *screen, int variant)
{
    return in_plane(screen->experiment) && shown(screen, variant) == MAP_DRAWING;
}

/* --- heading --------------------------------------------------------------------------------------- */

/* Appends a part if the heading still has room for it. */
static void add_part(char *title, size_t size, int room, const char *part)
{
    if (*part && glyphs_columns(title) + 2 + glyphs_columns(part) <= room)
        text_append(title, size, "  %s", part);
}

/* "tip 66.5, 19.5 mm" and "fit 29°": where the crack is, and the slope of the straight line that
 * fits its whole path. */
static void crack_texts(const Map *map, char *tip, char *angle, size_t size)
{
    CrackFacts facts;
    tip[0] = angle[0] = '\0';
    if (!crack_facts(map->sim, &facts))
        return;
    if (facts.measured.begun)
        snprintf(tip, size, "tip %.1f, %.1f mm", 1e3 * facts.measured.x, 1e3 * facts.measured.y);
    else
        snprintf(tip, size, "no crack yet");
    if (isfinite(facts.angle))
        snprintf(angle, size, "whole path %.0f°", fabs(facts.angle));
}

/* What passes between the particles and a mesh that is seen. */
static void flow_text(const Map *map, char *text, size_t size)
{
    static const char *const words[] = {[FLOW_NONE] = "",
                                        [FLOW_TO_NODES] = "particles give to nodes",
                                        [FLOW_TO_PARTICLES] = "particles take",
                                        [FLOW_FORGET] = ""};
    bool inside;
    const Flow flow = map_flow(map, &inside);
    snprintf(text, size, "%s", map_has_mesh(map) ? words[flow] : "");
    if (map_has_mesh(map) && inside && experiment_stage(map->screen->experiment) == 0)
        text_append(text, size, "%sthe grid is forgotten", text[0] ? ", " : "");
}

/* The parts of a title in the order in which they are worth its room: of a piece seen from near that it is
 * magnified comes first. */
enum { FLOW, TIP, FIT, ENLARGED, MAGNIFIED, CROSS, STRETCHED, PARTS };
static const int whole_order[PARTS] = {TIP, FIT, ENLARGED, MAGNIFIED, STRETCHED, FLOW, CROSS};
static const int near_order[PARTS] = {FLOW, MAGNIFIED, CROSS, STRETCHED, ENLARGED, TIP, FIT};

static void draw_title(const Map *map, Area area, Style heading)
{
    const Colouring *colouring = map->colouring;
    const int *order = map->screen->eye.magnified > 1 ? near_order : whole_order;
    const int room = area.rect.width - 6;
    const char *times = map->picture ? "×" : "x";
    char title[192] = "", parts[PARTS][64] = {"", "", "", "", "", "", ""}, number[NUMBER_TEXT_MAX];
    crack_texts(map, parts[TIP], parts[FIT], sizeof parts[TIP]);
    if (map->scene.leaves) {
        const double length = settings_geometry(map->settings)->length +
                              settings_motion(map->settings)->speed * simulation_time(map->sim);
        snprintf(parts[TIP], sizeof parts[TIP], "length %.1f mm", 1e3 * length);
    }
    flow_text(map, parts[FLOW], sizeof parts[FLOW]);
    map_cross_text(map, parts[CROSS], sizeof parts[CROSS]);
    text_factor(map->enlarged, number);
    if (map->enlarged != 1)
        snprintf(parts[ENLARGED], sizeof parts[ENLARGED], "%s %s %s", map->scene.leaves ? "uy" : "u", times,
                 number);
    text_factor(map->screen->eye.magnified, number);
    if (map->screen->eye.magnified > 1)
        snprintf(parts[MAGNIFIED], sizeof parts[MAGNIFIED], "zoom %s", number);
    text_factor(map->stretch, number);
    if (map->stretch != 1)
        snprintf(parts[STRETCHED], sizeof parts[STRETCHED], "height %s %s", times, number);
    else
        snprintf(parts[STRETCHED], sizeof parts[STRETCHED], "to scale");
    if (map->picture) { /* on paper the field stands beside its colours */
        for (int i = 0; i < PARTS; i++)
            add_part(title, sizeof title, (int)sizeof title, parts[order[i]]);
        picture_note(map->picture, STYLE_NORMAL, title);
        return;
    }
    int columns = glyphs_columns(map_meaning(map));
    for (int i = 0; i < PARTS; i++)
        columns += parts[i][0] ? 2 + glyphs_columns(parts[i]) : 0;
    snprintf(title, sizeof title, "%s", columns <= room ? map_meaning(map) : colouring->label);
    for (int i = 0; i < PARTS; i++)
        add_part(title, sizeof title, room, parts[order[i]]);
    area_rule(area, 0, title, heading);
}

/* --- colour bar ------------------------------------------------------------------------------------ */

enum { HALF_RAMP = RAMP_STEPS / 2 };

static int draw_half_ramp(const Map *map, Area area, int x, int y, int first)
{
    for (int step = first; step < first + HALF_RAMP; step++, x++)
        area_put(area, x, y, map->coloured ? 0x2588 : map_letter(map, step), (Style)(STYLE_RAMP_0 + step));
    return x;
}

/* What there is to say beside the ramp, in full or where room is short in a few words. */
static const char *note_of(const Map *map, bool brief)
{
    if (map_has_mesh(map) && fabs(map->sim->common_speed) > 0)
        return brief ? "bars: m, |p - m v0|" : "bars: mass, |momentum - m v0|";
    if (map_has_mesh(map))
        return brief ? "bars: m, |p|" : "bars: mass, |momentum|";
    if (map->nodes_seen)
        return brief ? "lines: whole bonds" : "lines: whole bonds to the nearest neighbours";
    if (strcmp(map->colouring->field, "damage") == 0)
        return brief ? "through: 0.4-0.5" : "a through crack reads 0.4 to 0.5, not 1";
    return "";
}

/* "├────┤ 2 mm": how long that is, where the beam's own length is out of sight. It ends before
 * column `end`, or is left out. Returns its columns. */
static int draw_length(const Map *map, Area area, int x, int y, int end)
{
    enum { COLUMNS_MOST = 10 };
    const double length = axis_step_down(COLUMNS_MOST / map->scale_x);
    const int columns = (int)lround(length * map->scale_x);
    char number[NUMBER_TEXT_MAX], text[NUMBER_TEXT_MAX + 8];
    text_rounded(number, 1e3 * length, 3);
    snprintf(text, sizeof text, " %s mm", number);
    if (x + columns + glyphs_columns(text) > end)
        return 0;
    for (int i = 0; i < columns; i++)
        area_put(area, x + i, y, i == 0 ? 0x251c : i == columns - 1 ? 0x2524 : 0x2500, STYLE_NORMAL);
    return columns + area_text(area, x + columns, y, text, STYLE_NORMAL);
}

/* "-4 [ramp] 0 [ramp] 4 µm", and what there is to say of the picture. */
static void draw_scale(const Map *map, Area area, int y)
{
    Axis axis = axis_with_ticks(axis_make(map->low, map->high), 5);
    const double ends[3] = {map->low, (map->low + map->high) / 2, map->high};
    const double middle = ends[1] * math_pow(10, axis.decimals - axis.exponent);
    axis.decimals += fabs(middle - round(middle)) > 1e-6 * (1 + fabs(middle));
    char text[TICK_TEXT_MAX], scale[TICK_TEXT_MAX];
    int x = 1;
    for (int i = 0; i < 3; i++) {
        axis_label(&axis, ends[i], text);
        if (i == 2 && map->open_ended)
            x += area_text(area, x, y, ">", STYLE_NORMAL);
        x += area_text(area, x, y, text, STYLE_NORMAL) + 1;
        if (i < 2)
            x = draw_half_ramp(map, area, x, y, i * HALF_RAMP) + 1;
    }
    axis_scale_text(&axis, map->colouring->unit, scale);
    x += area_text(area, x, y, scale, STYLE_NORMAL) + 2;
    if (map->screen->eye.magnified > 1) {
        /* what the lines between the nodes are must be said in any case */
        const int kept = map->nodes_seen ? glyphs_columns(note_of(map, true)) + 2 : 0;
        x += draw_length(map, area, x, y, area.rect.width - kept) + 2;
    }
    const char *note = note_of(map, x + glyphs_columns(note_of(map, false)) >= area.rect.width);
    if (x + glyphs_columns(note) < area.rect.width)
        area_text_right(area, area.rect.width - 1, y, note, STYLE_FAINT);
}

/* --- the view -------------------------------------------------------------------------------------- */

static Area map_part(Area area)
{
    return area_part(area, 1, 1, area.rect.width - 2, area.rect.height - 2);
}

/* False: there is nothing to be coloured, and this is its heading. */
static bool open_map(Map *map, const Screen *screen, Area area, int variant, char title[48])
{
    snprintf(title, 48, "the %s", screen_problem(screen)->body);
    if (map_open(map, screen, map_part(area)) && map_colour(map, shown(screen, variant)))
        return true;
    map_close(map);
    return false;
}

/* For a page and for words. */
static void describe(const Screen *screen, int variant, Picture *picture)
{
    const Area area = {NULL, {0, 0, picture->columns, picture->rows}, GLYPHS_NONE};
    Map map;
    char title[48];
    if (!in_plane(screen->experiment))
        return;
    if (shown(screen, variant) == MAP_DRAWING) {
        map_drawing(screen, area, STYLE_HEADING, picture);
        return;
    }
    if (!open_map(&map, screen, area, variant, title)) {
        picture_say(picture, title, "");
        return;
    }
    map.picture = picture;
    map_picture(&map);
    draw_title(&map, area, STYLE_HEADING);
    picture_note(picture, STYLE_FAINT, note_of(&map, false));
    map_close(&map);
}

static void draw(const Screen *screen, Area area, Style heading, int variant)
{
    Map map;
    char title[48];
    if (!in_plane(screen->experiment)) {
        pane_mesh(screen, area);
        return;
    }
    if (shown(screen, variant) == MAP_DRAWING) {
        map_drawing(screen, area, heading, NULL);
        return;
    }
    if (!open_map(&map, screen, area, variant, title)) {
        area_rule(area, 0, title, heading);
        return;
    }
    if (map.nodes_seen)
        map_draw_bonds(&map);
    else
        map_draw_heat(&map);
    map_draw_mesh(&map);
    map_draw_lines(&map);
    if (map.nodes_seen)
        map_draw_nodes(&map);
    map_draw_mesh_nodes(&map);
    map_draw_signs(&map);
    draw_title(&map, area, heading);
    draw_scale(&map, area, area.rect.height - 1);
    map_close(&map);
}

/* --- for keys and the mouse ------------------------------------------------------------------------- */

/* The map in the pane that shows it. False: none does. */
static bool open_shown(Map *map, const Screen *screen, int width, int height)
{
    const PaneId pane = screen->views.upper == &view_beam ? PANE_UPPER : PANE_LOWER;
    const Rect rect = screen_pane(screen, width, height, pane);
    *map = (Map){.block = NULL};
    if (rect.width < 4 || rect.height < 4 ||
        (screen->views.upper != &view_beam && screen->views.lower != &view_beam))
        return false;
    return map_open(map, screen, map_part((Area){NULL, rect, screen->look.glyphs}));
}

double view_map_enlargement(const Screen *screen, int width, int height)
{
    Map map;
    const double factor = open_shown(&map, screen, width, height) ? map.enlarged : 0;
    map_close(&map);
    return factor;
}

bool view_map_place(const Screen *screen, int width, int height, int x, int y, double place[2])
{
    Map map;
    bool is_there = false;
    if (open_shown(&map, screen, width, height)) {
        const Rect *part = &map.area.rect;
        x -= part->x;
        y -= part->y;
        is_there = x >= 0 && y >= 0 && x < part->width && y < part->height;
        map_place_of(&map, x, y, place);
    }
    map_close(&map);
    return is_there;
}

/* The node that is drawn in or near a cell becomes the chosen one. */
static bool click(Screen *screen, Rect rect, int x, int y)
{
    Map map;
    long node = -1;
    if (rect.width >= 4 && rect.height >= 4 &&
        map_open(&map, screen, map_part((Area){NULL, rect, screen->look.glyphs}))) {
        const Rect *part = &map.area.rect;
        x -= part->x;
        y -= part->y;
        if (x >= 0 && y >= 0 && x < part->width && y < part->height)
            node = map_node_at(&map, x, y);
        map_close(&map);
    }
    if (node < 0)
        return false;
    screen->chosen.particle = (size_t)node;
    screen->chosen.is_node = false;
    return true;
}

/* --- in words ----------------------------------------------------------------------------------------- */

/* Where the crack's tip is, and how much is broken. */
static void tell(const Screen *screen, struct Words *words)
{
    static const struct {
        const char *column, *name, *unit;
        double scale;
    } told[] = {{"crack_x", "crack tip: x", " mm", 1e-3},
                {"crack_y", "crack tip: y", " mm", 1e-3},
                {"crack_length", "length of the crack", " mm", 1e-3},
                {"broken_bonds", "broken bonds", "", 1}};
    const Simulation *sim = experiment_simulation(screen->experiment);
    const double *row = experiment_row(screen->experiment);
    const int damage = simulation_find_field(sim, 0, "damage");
    for (size_t i = 0; i < sizeof told / sizeof *told; i++) {
        const int column = screen_column(screen, told[i].column);
        char value[NUMBER_TEXT_MAX];
        if (column < 0 || !isfinite(row[column]))
            continue;
        text_rounded(value, row[column] / told[i].scale, 5);
        words_say(words, 4, "  %s %s%s.", told[i].name, value, told[i].unit);
    }
    size_t damaged = 0;
    double value;
    for (size_t node = 0; damage >= 0 && node < sim->counts[0]; node++) {
        sim->method->field(sim, damage, node, 1, &value);
        damaged += value > CRACK_DAMAGE;
    }
    if (damage >= 0)
        words_say(words, 4, "  %zu of %zu nodes have lost more than %.0f %% of their bonds.", damaged,
                  sim->counts[0], 100 * CRACK_DAMAGE);
}

const View view_beam = {
    .word = "beam",
    .brief = "beam",
    .help = "the beam or plate as it lies, coloured; again: by another field",
    .digit = 8,
    .home = PANE_UPPER,
    .opens = OPENS_IN_PLANE,
    .describe = describe,
    .draw = draw,
    .tell = tell,
    .variants = variants_of,
    .variant_word = word_of,
    .duel = DUEL_APART,
    .of_moment = true,
    .is_map = true,
    .on_paper = true,
    .on_paper_with = HAS_PLANE,
    .shows_start = shows_start,
    .click = click,
};
