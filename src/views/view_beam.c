/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A body in the plane as it lies, coloured by a field, or drawn with its dimensions. Every factor is stated.
 * Under it and its plots the lines of what the run is judged by. */
#include "views/map/map.h"
#include "scenario/parameters.h"
#include "scenario/concern_body.h"
#include "scenario/concern_loads.h"
#include "views/view.h"
#include "base/text.h"
#include "answers/crack_growth.h"
#include "panes/screen.h"
#include "scenario/settings.h"

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

/* How it is drawn, the phrases by what they are worth: seen from near first that it is magnified. */
enum { FLOW, TIP, FIT, ENLARGED, MAGNIFIED, CROSS, STRETCHED, PARTS };
static const int whole_order[PARTS] = {TIP, FIT, ENLARGED, MAGNIFIED, STRETCHED, FLOW, CROSS};
static const int near_order[PARTS] = {FLOW, MAGNIFIED, CROSS, STRETCHED, ENLARGED, TIP, FIT};

static void note_how(const Map *map)
{
    const double magnified = map->screen->eye.magnified;
    const int *order = magnified > 1 ? near_order : whole_order;
    char text[PICTURE_TEXT_MAX] = "", parts[PARTS][64] = {""};
    /* "tip 66.5, 19.5 mm" and "fit 29°": where the crack is, and the straight line that fits its path. */
    CrackFacts facts;
    const size_t size = sizeof parts[0];
    if (crack_facts(map->sim, &facts)) {
        snprintf(parts[TIP], size, facts.measured.begun ? "tip %.1f, %.1f mm" : "no crack yet",
                 1e3 * facts.measured.x, 1e3 * facts.measured.y);
        if (isfinite(facts.angle))
            snprintf(parts[FIT], size, "whole path %.0f°", fabs(facts.angle));
    }
    if (map->scene.leaves) {
        const double length = settings_geometry(map->settings)->length +
                              settings_motion(map->settings)->speed * simulation_time(map->sim);
        snprintf(parts[TIP], size, "length %.1f mm", 1e3 * length);
    }
    /* What passes between the particles and a mesh that is seen. */
    bool inside;
    const Flow flow = flow_of_stage(map->screen, &inside);
    if (map_has_mesh(map) && (flow == FLOW_TO_NODES || flow == FLOW_TO_PARTICLES))
        snprintf(parts[FLOW], size, flow == FLOW_TO_NODES ? "particles give to nodes" : "particles take");
    if (map_has_mesh(map) && inside && experiment_stage(map->screen->experiment) == 0)
        text_append(parts[FLOW], size, "%sthe grid is forgotten", parts[FLOW][0] ? ", " : "");
    map_cross_text(map, parts[CROSS], size);
    if (map->drawn->enlarged != 1)
        snprintf(parts[ENLARGED], size, "%s × %s", map->scene.leaves ? "uy" : "u",
                 text_factor(map->drawn->enlarged).text);
    if (magnified > 1)
        snprintf(parts[MAGNIFIED], size, "zoom %s", text_factor(magnified).text);
    if (map->picture->stretch != 1)
        snprintf(parts[STRETCHED], size, "height × %s", text_factor(map->picture->stretch).text);
    else if (map->drawn->enlarged == 1)
        snprintf(parts[STRETCHED], size, "to scale");
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
    const Colouring *by = map.colouring;
    picture_heading(picture, "%s", map.scene.slender || !by->flat ? by->meaning : by->flat);
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
    .help = "the body as it lies, coloured; again: by another field",
    .digit = 8,
    .home = PANE_UPPER,
    .opens = OPENS_IN_PLANE,
    .describe = describe,
    .variant_word = word_of,
    .duel = DUEL_APART,
    .is_map = true,
    .on_paper_with = HAS_PLANE | HAS_BODIES,
    .shows_start = shows_start,
};

/* The lines under a beam's plots: what its run is judged by. Phrases are separated by two spaces, what
 * matters most first; what has no room is left out whole. */

static double percent(double ratio)
{
    return 100 * (ratio - 1);
}

/* Of a code that is wrong in one place the answer of the right one is known. */
static const char *predicted_word(const Screen *screen)
{
    return settings_mistake(screen_settings(screen)) ? "right code" : "predicted";
}

static void supported_lines(const Screen *screen, char first[160], char second[160])
{
    const Readout *readout = experiment_readout(screen->experiment);
    const double euler = screen_derived(screen, "period_euler"), timoshenko = readout->exact;
    if (readout->measured_known) {
        const int decimals = readout_error_decimals(readout, 2);
        snprintf(first, 160, "T " LONG_SHORT("measured ", "") "%s ms", readout_text(readout, 4).text);
        if (screen_shows_exact(screen)) {
            text_append(first, 160, "  Timoshenko %+.*f %%", decimals,
                        percent(readout->measured / timoshenko));
            snprintf(second, 160, "Euler %+.*f %%", decimals, percent(readout->measured / euler));
        }
    } else {
        snprintf(first, 160, "T measuring");
        if (screen_shows_exact(screen)) {
            text_append(first, 160, "  Timoshenko %.4f ms", timoshenko / 1e-3);
            snprintf(second, 160, "Euler %.4f ms", euler / 1e-3);
        }
    }
    if (isfinite(readout->by_zeros))
        text_append(second, 160, "%s" LONG_SHORT("by its ", "") "zeros %.4f ms", second[0] ? "  " : "",
                    readout->by_zeros / 1e-3);
    /* The periods of earlier runs, by the letters of their curves. */
    const Ghost *ghosts = experiment_ghosts(screen->experiment);
    for (int i = 0; i < GHOSTS_MAX; i++)
        if (ghosts[i].used && ghosts[i].readout.is_period && ghosts[i].readout.measured_known)
            text_append(second, 160, "  %c: %s", ghosts[i].letter, readout_text(&ghosts[i].readout, 4).text);
    if (screen_shows_predicted(screen) && readout->predicted_known)
        text_append(second, 160, "%s%s %.4f ms", second[0] ? "  " : "", predicted_word(screen),
                    readout->predicted / 1e-3);
}

void beam_lines_tip_speed(const Crack *crack, double rayleigh, char out[160])
{
    snprintf(out, 160, "%.0f m/s = %.2f c_R, fastest %.0f = %.2f", crack->speed, crack->speed / rayleigh,
             crack->fastest, crack->fastest / rayleigh);
}

/* What a beam that breaks is judged by. */
static void crack_lines(const CrackFacts *facts, double rayleigh, char first[160], char second[160])
{
    const Crack *crack = &facts->measured;
    snprintf(first, 160, "broken bonds %ld", crack->broken);
    if (crack->begun)
        text_append(first, 160, "  tip at x %.1f, y %.1f mm", crack->x / 1e-3, crack->y / 1e-3);
    if (crack->begun && crack->fastest > 0) {
        char speed[160];
        beam_lines_tip_speed(crack, rayleigh, speed);
        text_append(first, 160, "  %s", speed);
    }
    for (int i = CRACK_ANGLES - 1; i >= 0 && !second[0]; i--)
        if (isfinite(facts->angles[i]))
            snprintf(second, 160, "fit over %.0f mm %.0f deg", facts->heights[i] / 1e-3, facts->angles[i]);
    if (isnan(crack->first_break))
        return;
    text_append(second, 160, "%s%s %.1f", second[0] ? "  " : "",
                isnan(crack->arrival) ? "first break" : "grew from", crack->first_break / 1e-6);
    if (isfinite(crack->arrival))
        text_append(second, 160, " to %.1f", crack->arrival / 1e-6);
    text_append(second, 160, " µs");
}

/* An oscillation that dies: how fast, and how fast it oscillates meanwhile, beside theory. */
static void decay_lines(const Screen *screen, const Readout *readout, char first[160], char second[160])
{
    const bool exact = screen_shows_exact(screen), measured = isfinite(readout->decay_measured);
    snprintf(first, 160, measured ? "decay %.5g 1/s" : "decay measuring", readout->decay_measured);
    if (exact)
        text_append(first, 160, ", theory %.5g%s", readout->decay_exact, measured ? "" : " 1/s");
    if (readout->measured_known)
        text_append(first, 160, "  T %s ms", readout_text(readout, 4).text);
    snprintf(second, 160, readout->measured_known ? "f %.1f Hz" : "f measuring", 1 / readout->measured);
    if (screen_shows_predicted(screen) && readout->predicted_known)
        text_append(second, 160, ", %s %.1f", predicted_word(screen), 1 / readout->predicted);
    if (exact)
        text_append(second, 160, "  Timoshenko %.1f", 1 / readout->exact);
}

/* A beam that comes out of its channel. */
static void moving_lines(const Screen *screen, const Readout *readout, char first[160], char second[160])
{
    const bool exact = screen_shows_exact(screen), measured = readout->measured_known;
    const int length = experiment_column(screen->experiment, "length");
    const double *row = experiment_row(screen->experiment);
    if (length >= 0 && row)
        snprintf(first, 160, LONG_SHORT("length %.2f mm", "length %.1f mm"), row[length] / 1e-3,
                 row[length] / 1e-3);
    text_append(first, 160, measured ? "  f" LONG_SHORT(" measured", "") " %.1f Hz" : "  f measuring",
                1 / readout->measured);
    if (measured && exact) {
        text_append(first, 160, "  modal %.1f", 1 / readout->exact);
        snprintf(second, 160, "last period %+.2f %%  %.3f T %s  ", readout->error_period, fabs(readout->late),
                 readout->late < 0 ? "ahead" : "behind");
    }
    if (exact)
        text_append(second, 160, "at fixed length %.1f Hz",
                    references_standing_frequency(experiment_references(screen->experiment),
                                                  experiment_time(screen->experiment)));
}

bool beam_lines(const Screen *screen, char first[160], char second[160])
{
    const Readout *readout = experiment_readout(screen->experiment);
    const References *refs = experiment_references(screen->experiment);
    CrackFacts facts;
    Finding findings[FINDINGS_MAX];
    const CrackFronts *fronts = experiment_fronts(screen->experiment);
    first[0] = second[0] = '\0';
    if (crack_facts(screen_simulation(screen), &facts))
        crack_lines(&facts, crack_rayleigh_speed(screen_settings(screen)), first, second);
    else if (fronts) {
        FrontsFacts found;
        crack_fronts_facts(fronts, &found);
        crack_fronts_lines(&found, crack_rayleigh_speed(screen_settings(screen)), "µs", first, second);
    } else if (!screen_has(screen, HAS_PLANE) ||
               (!readout->moving &&
                (readout->unjudged || references_findings(refs, screen_simulation(screen), findings) > 0)))
        return false; /* what comes to rest has no period, but other numbers */
    else if (!readout->moving)
        snprintf(first, 160, "nothing vibrates: no period to measure");
    else if (readout->unaccounted)
        snprintf(first, 160, "T: not known with %s", readout->unaccounted);
    else if (isfinite(readout->decay_exact))
        decay_lines(screen, readout, first, second);
    else if (screen_settings(screen)->problem->concerns & CONCERN_MOTION)
        moving_lines(screen, readout, first, second);
    else
        supported_lines(screen, first, second);
    return true;
}

void beam_note_lines(const Screen *screen, Picture *picture, const char *first)
{
    char lines[2][160];
    beam_lines(screen, lines[0], lines[1]);
    picture_note(picture, STYLE_NORMAL, "%s", *first ? first : lines[0]);
    picture_note(picture, STYLE_NORMAL, "%s", lines[1])->joins = true;
}
