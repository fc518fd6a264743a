/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A body in the plane as it lies, coloured by a field, or drawn with its dimensions. Every factor is stated.
 */
#include "views/map/map.h"
#include "scenario/parameters.h"
#include "scenario/concern_body.h"
#include "scenario/concern_loads.h"
#include "views/view.h"
#include "base/text.h"
#include "answers/crack_growth.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static bool in_plane(const Experiment *experiment)
{
    return simulation_has_map(experiment_simulation(experiment));
}

static MapVariant shown(const Screen *screen, int variant)
{
    return map_variant(screen_simulation(screen), variant);
}

static const char *word_of(const Screen *screen, int variant)
{
    return in_plane(screen->experiment) ? parameter_colour_words[shown(screen, variant)] : NULL;
}

static bool shows_start(const Screen *screen, int variant)
{
    return in_plane(screen->experiment) && shown(screen, variant) == MAP_DRAWING;
}

/* --- what is said of it ------------------------------------------------------------------------------ */

/* How it is drawn, in the order in which the phrases are worth their room: of a piece seen from near that it
 * is magnified comes first. */
enum { FLOW, TIP, FIT, ENLARGED, MAGNIFIED, CROSS, STRETCHED, PARTS };
static const int whole_order[PARTS] = {TIP, FIT, ENLARGED, MAGNIFIED, STRETCHED, FLOW, CROSS};
static const int near_order[PARTS] = {FLOW, MAGNIFIED, CROSS, STRETCHED, ENLARGED, TIP, FIT};

static void note_how(const Map *map)
{
    const double magnified = map->screen->eye.magnified;
    const int *order = magnified > 1 ? near_order : whole_order;
    char text[PICTURE_TEXT_MAX] = "", parts[PARTS][64] = {""};
    /* "tip 66.5, 19.5 mm" and "fit 29°": where the crack is, and the slope of the straight line that fits
     * its whole path. */
    CrackFacts facts;
    parts[TIP][0] = parts[FIT][0] = '\0';
    if (crack_facts(map->sim, &facts)) {
        if (facts.measured.begun)
            snprintf(parts[TIP], sizeof parts[TIP], "tip %.1f, %.1f mm", 1e3 * facts.measured.x,
                     1e3 * facts.measured.y);
        else
            snprintf(parts[TIP], sizeof parts[TIP], "no crack yet");
        if (isfinite(facts.angle))
            snprintf(parts[FIT], sizeof parts[TIP], "whole path %.0f°", fabs(facts.angle));
    }
    if (map->scene.leaves) {
        const double length = settings_geometry(map->settings)->length +
                              settings_motion(map->settings)->speed * simulation_time(map->sim);
        snprintf(parts[TIP], sizeof parts[TIP], "length %.1f mm", 1e3 * length);
    }
    /* What passes between the particles and a mesh that is seen. */
    const size_t size = sizeof parts[FLOW];
    static const char *const words[] = {[FLOW_NONE] = "",
                                        [FLOW_TO_NODES] = "particles give to nodes",
                                        [FLOW_TO_PARTICLES] = "particles take",
                                        [FLOW_FORGET] = ""};
    bool inside;
    const Flow flow = flow_of_stage(map->screen, &inside);
    snprintf(parts[FLOW], size, "%s", map_has_mesh(map) ? words[flow] : "");
    if (map_has_mesh(map) && inside && experiment_stage(map->screen->experiment) == 0)
        text_append(parts[FLOW], size, "%sthe grid is forgotten", parts[FLOW][0] ? ", " : "");
    map_cross_text(map, parts[CROSS], sizeof parts[CROSS]);
    if (map->drawn->enlarged != 1)
        snprintf(parts[ENLARGED], sizeof parts[ENLARGED], "%s × %s", map->scene.leaves ? "uy" : "u",
                 text_factor(map->drawn->enlarged).text);
    if (magnified > 1)
        snprintf(parts[MAGNIFIED], sizeof parts[MAGNIFIED], "zoom %s", text_factor(magnified).text);
    if (map->picture->stretch != 1)
        snprintf(parts[STRETCHED], sizeof parts[STRETCHED], "height × %s",
                 text_factor(map->picture->stretch).text);
    else
        snprintf(parts[STRETCHED], sizeof parts[STRETCHED], "to scale");
    for (int i = 0; i < PARTS; i++)
        if (parts[order[i]][0])
            text_append(text, sizeof text, "%s%s", text[0] ? "  " : "", parts[order[i]]);
    picture_note(map->picture, STYLE_NORMAL, "%s", text);
}

/* Where the crack's tip is, and how much is broken: seen by who looks. */
static void note_facts(const Map *map)
{
    static const struct {
        const char *column, *name, *unit;
        double scale;
    } told[] = {{"crack_x", "crack tip: x", " mm", 1e-3},
                {"crack_y", "crack tip: y", " mm", 1e-3},
                {"crack_length", "length of the crack", " mm", 1e-3},
                {"broken_bonds", "broken bonds", "", 1}};
    const double *row = experiment_row(map->screen->experiment);
    for (size_t i = 0; i < sizeof told / sizeof *told; i++) {
        const int column = experiment_column(map->screen->experiment, told[i].column);
        if (column < 0 || !isfinite(row[column]))
            continue;
        picture_note(map->picture, STYLE_NORMAL, "%s %s%s.", told[i].name,
                     text_rounded(row[column] / told[i].scale, 5).text, told[i].unit)
            ->told = true;
    }
    if (simulation_find_field(map->sim, 0, "damage") < 0)
        return;
    const bool damage = strcmp(map->colouring->field, "damage") == 0;
    size_t damaged = 0;
    for (size_t node = 0; node < map->body.count; node++)
        damaged += damage ? map->drawn->value[node] > CRACK_DAMAGE : map->drawn->torn[node];
    picture_note(map->picture, STYLE_NORMAL, "%zu of %zu nodes have lost more than %.0f %% of their bonds.",
                 damaged, map->body.count, 100 * CRACK_DAMAGE)
        ->told = true;
}

/* --- the view -------------------------------------------------------------------------------------- */

/* False: there is nothing to be coloured, and this is its heading. */
static bool open_map(Map *map, const Screen *screen, MapVariant variant, Picture *picture)
{
    if (map_open(map, screen, picture) && map_colour(map, variant))
        return true;
    char title[48];
    snprintf(title, sizeof title, "the %s", screen_problem(screen)->body);
    map_close(map);
    picture_close(picture);
    picture_heading(picture, "%s", title);
    return false;
}

static void describe(const Screen *screen, int variant, Picture *picture)
{
    Map map;
    if (!in_plane(screen->experiment)) { /* the body of a bar is its strip */
        view_strip.describe(screen, 0, picture);
        return;
    }
    if (shown(screen, variant) == MAP_DRAWING) {
        map_drawing(screen, picture);
        return;
    }
    if (!open_map(&map, screen, shown(screen, variant), picture))
        return;
    picture_heading(picture, "%s", map_meaning(&map));
    map_add_bonds(&map);
    map_add_box(&map);
    if (shown(screen, variant) == MAP_SPEED)
        map_add_velocities(&map);
    map_add_mesh(&map);
    map_add_lines(&map);
    map_add_signs(&map);
    note_how(&map);
    /* What its lines and bars are. */
    static const char *const notes[] = {
        LONG_SHORT("bars: mass, |momentum - m v0|", "bars: m, |p - m v0|"),
        LONG_SHORT("bars: mass, |momentum|", "bars: m, |p|"),
        LONG_SHORT("lines: whole bonds to the nearest neighbours", "lines: whole bonds"),
        LONG_SHORT("a through crack reads 0.4 to 0.5, not 1", "through: 0.4-0.5"), ""};
    const bool damage = strcmp(map.colouring->field, "damage") == 0;
    const int which = map_has_mesh(&map)   ? fabs(map.sim->common_speed) > 0 ? 0 : 1
                      : map.scene.bodies   ? 4
                      : map.drawn->is_near ? 2
                      : damage             ? 3
                                           : 4;
    picture_note(map.picture, STYLE_FAINT, "%s", notes[which]);
    note_facts(&map);
    map_close(&map);
}

bool view_map_small(const Screen *screen, Picture *picture)
{
    Map map;
    if (!open_map(&map, screen, shown(screen, view_variant(&view_beam, screen)), picture))
        return false;
    map_add_box(&map);
    map_add_signs(&map);
    map_close(&map);
    return true;
}

const View view_beam = {
    .word = "beam",
    .brief = "beam",
    .help = "the body as it lies, coloured; again: by another field",
    .digit = 8,
    .home = PANE_UPPER,
    .opens = OPENS_IN_PLANE,
    .describe = describe,
    .variant_word = word_of,
    .duel = DUEL_APART,
    .of_moment = true,
    .is_map = true,
    .on_paper = true,
    .on_paper_with = HAS_PLANE | HAS_BODIES,
    .shows_start = shows_start,
};
