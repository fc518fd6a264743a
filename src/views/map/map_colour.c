/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What the nodes of a beam can be coloured by, and the range of the ramp for it. */
#include "views/map/map.h"
#include "scenario/concern_body.h"
#include "scenario/settings.h"
#include "answers/crack_growth.h"

#include <math.h>
#include <stdio.h>

static const Colouring colourings[MAP_COLOURINGS] = {
    [MAP_BODY] = {"body", "body", "body", "", false, NULL},
    [MAP_UY] = {"uy", "uy", "displacement across the beam", "m", true, "displacement along y"},
    [MAP_UX] = {"ux", "ux", "displacement along the beam", "m", true, "displacement along x"},
    [MAP_VELOCITY] = {"vy", "vy", "velocity across the beam", "m/s", true, "velocity along y"},
    [MAP_ENERGY] = {"strain_energy", "energy density", "strain energy density", "J/m³", false, NULL},
    [MAP_DAMAGE] = {"damage", "damage", "damage: broken share of the family", "", false, NULL},
    [MAP_FAMILY] = {"family", "family", "share of a whole family that is left", "", false, NULL},
    [MAP_SURFACE] = {"surface_factor", "surface factor", "surface factor: bonds near the surface stiffened",
                     "", false, NULL},
    [MAP_SXX] = {"sxx", "stress xx", "stress along the beam", "Pa", true, "stress xx"},
    [MAP_SYY] = {"syy", "stress yy", "stress across the beam", "Pa", true, "stress yy"},
    [MAP_SXY] = {"sxy", "stress xy", "shear stress", "Pa", true, NULL},
    [MAP_MISES] = {"mises", "von Mises", "von Mises' stress", "Pa", false, NULL},
    [MAP_KINETIC] = {"kinetic_energy", "kinetic density", "kinetic energy density", "J/m³", false, NULL},
    [MAP_SPEED] = {"speed", "speed", "magnitude of the velocity", "m/s", false, NULL},
    [MAP_PRESSURE] = {"pressure", "pressure", "pressure", "Pa", true, NULL},
    [MAP_DET_F] = {"det_f", "det F", "volume over that at t = 0", "", false, NULL},
};

/* Of a body that moves along as a whole. */
static const Colouring beside_travel = {"ux", "ux - v0 t", "displacement along the beam beside v0 t",
                                        "m",  true,        NULL};

MapVariant map_variant(const Simulation *sim, int number)
{
    int variant = 0;
    for (; variant < MAP_VARIANTS; variant++) {
        const bool is_there = variant == MAP_DRAWING
                                  ? simulation_has(sim, HAS_PLANE)
                                  : (variant < MAP_SPEED || simulation_has(sim, HAS_BODIES)) &&
                                        simulation_find_field(sim, 0, colourings[variant].field) >= 0;
        if (is_there && number-- == 0)
            break;
    }
    return (MapVariant)variant;
}

/* The range that values have, with round ends. */
static void round_range(Map *map, double least, double most)
{
    if (most - least < 1e-9 * fabs(most))
        least = 0;
    const Axis axis = axis_with_ticks(axis_make(least, most), 5);
    map->drawn->low = floor(least / axis.step + 1e-9) * axis.step;
    map->drawn->high = ceil(most / axis.step - 1e-9) * axis.step;
}

/* The share of a whole family that a node has: it lacks what lies beyond a surface, and what is broken. */
static void share_of_family(Map *map)
{
    enum { AT_ONCE = 256 };
    const size_t count = map->body.count;
    const int damage = simulation_find_field(map->sim, 0, "damage");
    double whole = 1, lost[AT_ONCE] = {0};
    for (size_t i = 0; i < count; i++)
        whole = fmax(whole, map->drawn->value[i]);
    for (size_t i = 0; i < count; i++) {
        if (damage >= 0 && i % AT_ONCE == 0)
            map->sim->method->field(map->sim, damage, i, count - i < AT_ONCE ? count - i : AT_ONCE, lost);
        map->drawn->value[i] *= (1 - lost[i % AT_ONCE]) / whole;
    }
    map->drawn->low = 0;
    map->drawn->high = 1;
}

/* A value that all but a few nodes keep below: a crack's tip must not leave the rest without colour. */
static double most_values(const Map *map, double most)
{
    enum { BINS = 256, PASSES = 3 };
    const size_t few = map->body.count / 100;
    for (int pass = 0; pass < PASSES && most > 0; pass++) {
        size_t bins[BINS] = {0}, above = 0;
        for (size_t i = 0; i < map->body.count; i++) {
            const double share = map->drawn->value[i] / most * BINS;
            bins[share >= BINS ? BINS - 1 : share > 0 ? (int)share : 0]++;
        }
        int bin = BINS - 1;
        while (bin > 0 && above + bins[bin] <= few)
            above += bins[bin--];
        most *= (bin + 1.0) / BINS;
        if (bin > BINS / 8)
            break;
    }
    return most;
}

/* What has lost too many bonds shows no colour, but of what it has lost. */
static void tear(Map *map)
{
    const int damage = simulation_find_field(map->sim, 0, "damage");
    if (damage < 0)
        return;
    map->sim->method->field(map->sim, damage, 0, map->body.count, map->drawn->value);
    for (size_t i = 0; i < map->body.count; i++)
        map->drawn->torn[i] = map->drawn->value[i] > CRACK_DAMAGE;
}

bool map_colour(Map *map, MapVariant variant)
{
    const Colouring *colouring = map->colouring = &colourings[variant < MAP_COLOURINGS ? variant : MAP_UY];
    const int field = simulation_find_field(map->sim, 0, colouring->field);
    const size_t count = map->body.count;
    if (field < 0)
        return false;
    if (variant != MAP_DAMAGE)
        tear(map);
    map->sim->method->field(map->sim, field, 0, count, map->drawn->value);
    const bool travels = variant == MAP_UX && fabs(map->sim->common_speed) > 0;
    const double carried = simulation_carried(map->sim, field);
    for (size_t i = 0; i < count && travels; i++)
        map->drawn->value[i] -= carried;
    if (travels)
        map->colouring = &beside_travel;
    map->drawn->is_signed = map->colouring->is_signed;
    snprintf(map->drawn->unit, sizeof map->drawn->unit, "%s",
             map->settings->problem->si ? map->colouring->unit : "");
    snprintf(map->drawn->brief, sizeof map->drawn->brief, "%s", map->colouring->label);
    double least = INFINITY, most = -INFINITY;
    for (size_t i = 0; i < count; i++) {
        least = map->drawn->value[i] < least ? map->drawn->value[i] : least;
        most = map->drawn->value[i] > most ? map->drawn->value[i] : most;
    }
    if (!isfinite(least) || !isfinite(most))
        return false;
    if (variant == MAP_BODY) {
        const RowList *bodies = &map->settings->rows[ROWS_BODIES];
        map->drawn->kinds = bodies->count;
        for (int i = 0; i < bodies->count; i++)
            map->drawn->kind_names[i] = bodies->rows[i].name;
        map->drawn->low = 0;
        map->drawn->high = map->drawn->kinds;
    } else if (variant == MAP_DET_F) {
        round_range(map, fmin(least, 0.99), fmax(most, 1.01));
    } else if (variant == MAP_FAMILY) {
        share_of_family(map);
    } else if (variant == MAP_SURFACE) {
        round_range(map, least, most_values(map, most));
        map->drawn->open_ended = most > map->drawn->high;
    } else if (variant == MAP_DAMAGE) {
        /* a crack right through leaves half of the family at best */
        map->drawn->low = 0;
        map->drawn->high = 0.5;
        map->drawn->open_ended = most > map->drawn->high;
    } else {
        const bool density = variant == MAP_ENERGY || variant == MAP_KINETIC;
        double reach, scale = 1;
        if (density)
            scale = 1 / (map->body.spacing * map->body.spacing *
                         (map->scene.bodies ? 1 : settings_geometry(map->settings)->thickness));
        else if (travels) /* of a section that turns about its middle by the slope of the oscillation */
            reach = fmax(fmax(-least, most), map_reach(map, map->sim->displacement[1], map->uy) *
                                                 map->body.size[1] /
                                                 (2 * settings_geometry(map->settings)->length));
        else
            reach = map_reach(map, field, map->drawn->value);
        for (size_t i = 0; i < count && density; i++)
            map->drawn->value[i] *= scale;
        if (density)
            reach = most_values(map, scale * most);
        map->drawn->high = reach > 0 ? axis_round_up(reach) : 1;
        map->drawn->low = map->colouring->is_signed ? -map->drawn->high : 0;
        map->drawn->open_ended = most * scale > map->drawn->high;
    }
    return true;
}
