/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The inspector of beams: the chosen node's family, each bond with its stretch as a share of the critical
 * one, the bond that broke last, the most stretched one and why it holds, and the forces (family_forces.c).
 */
#include "views/inspector/inspector.h"
#include "scenario/concern_bonds.h"
#include "views/views.h"
#include "views/inspector/family.h"
#include "picture/cells/cells.h"
#include "picture/cells/cells_map.h"
#include "base/math/functions.h"
#include "run/playback.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { REACH_MAX = 8, CELL_LEAST = 4, CELL_MOST = 6 };

/* --- what there is ---------------------------------------------------------------------------------- */

static Ray ray_of(const Family *family, const Link *link)
{
    const Simulation *sim = family->sim;
    const long nx = family->body.nx;
    Ray ray = {
        .other = link->index, .stretch = link->stretch, .broken = link->broken, .broken_at = link->broken_at};
    ray.p = (int)((long)link->index % nx - family->i);
    ray.q = (int)((long)link->index / nx - family->j);
    const int steps[2] = {ray.p, ray.q};
    for (int d = 0; d < 2; d++)
        ray.direction[d] = steps[d] * family->body.spacing +
                           simulation_value(sim, sim->displacement[d], link->index) -
                           simulation_value(sim, sim->displacement[d], family->node);
    const double length = math_hypot(ray.direction[0], ray.direction[1]);
    for (int d = 0; d < 2 && length > 0; d++)
        ray.direction[d] /= length;
    ray.pull = link->pull / (family->body.spacing * family->body.spacing);
    return ray;
}

static bool family_of(Family *family, const Screen *screen)
{
    const Simulation *sim = experiment_simulation(screen->experiment);
    *family = (Family){.screen = screen,
                       .sim = sim,
                       .settings = experiment_settings(screen->experiment),
                       .most = -1,
                       .last = -1};
    if (!body_of(sim, &family->body) || sim->counts[0] == 0)
        return false;
    family->node = screen->chosen.particle < sim->counts[0] ? screen->chosen.particle : sim->counts[0] - 1;
    family->i = (int)(family->node % (size_t)family->body.nx);
    family->j = (int)(family->node / (size_t)family->body.nx);
    Link links[FAMILY_LINKS];
    const size_t count = sim->method->links(sim, 0, family->node, links, FAMILY_LINKS);
    family->count = (int)(count < FAMILY_LINKS ? count : FAMILY_LINKS);
    for (int k = 0; k < family->count; k++) {
        const Ray ray = family->rays[k] = ray_of(family, &links[k]);
        const int reach = abs(ray.p) > abs(ray.q) ? abs(ray.p) : abs(ray.q);
        family->reach = reach > family->reach ? reach : family->reach;
        const bool cut = ray.broken && ray.broken_at == 0;
        family->cut += cut;
        family->broken += ray.broken && !cut;
        if (ray.broken && !cut && (family->last < 0 || ray.broken_at > family->rays[family->last].broken_at))
            family->last = k;
        if (!ray.broken && (family->most < 0 || ray.stretch > family->rays[family->most].stretch))
            family->most = k;
    }
    return family->reach <= REACH_MAX;
}

/* --- the family as a picture ------------------------------------------------------------------------ */

/* The factor that makes stretches numbers of two or three digits: in percent of s0, or of a power of ten. */
static double scale_of(const Family *family, char *caption, size_t size)
{
    const double s0 = settings_bonds(family->settings)->critical_stretch;
    double most = 0;
    for (int k = 0; k < family->count; k++)
        most = fmax(most, family->rays[k].broken ? 0 : fabs(family->rays[k].stretch));
    if (s0 > 0) {
        snprintf(caption, size, "%% of s0");
        return 100 / s0;
    }
    const int exponent = most > 0 ? (int)floor(math_log10(most)) - 1 : 0;
    snprintf(caption, size, "s x10^%d", exponent);
    return math_pow(10, -exponent);
}

static void draw_bond(const Family *family, Area area, const Ray *ray, int cell, double scale)
{
    const int end = (family->reach + ray->p + 1) * cell, y = family->reach - ray->q;
    char text[24];
    if (ray->broken) {
        area_put(area, end - 1, y, ray->broken_at == 0 ? '|' : 'x', STYLE_WARNING);
        return;
    }
    snprintf(text, sizeof text, "%.0f", ray->stretch * scale);
    if (strcmp(text, "-0") == 0)
        strcpy(text, "0");
    if (glyphs_columns(text) > cell - (text[0] != '-')) /* far beyond: about to break, or unstable */
        strcpy(text, ray->stretch > 0 ? ">>" : "<<");
    const bool most = family->most >= 0 && ray == &family->rays[family->most];
    area_text_right(area, end, y, text, most ? STYLE_CHANGED : STYLE_NORMAL);
}

/* Returns the rows used. */
static int draw_family(const Family *family, Area area, int cell)
{
    char caption[48];
    const double scale = scale_of(family, caption, sizeof caption);
    const double farthest = lattice_reach(family->settings) / family->body.spacing;
    /* who is missing: beyond a surface there is no node */
    for (int q = -family->reach; q <= family->reach; q++)
        for (int p = -family->reach; p <= family->reach; p++) {
            const bool inside = family->i + p >= 0 && family->i + p < family->body.nx && family->j + q >= 0 &&
                                family->j + q < family->body.ny;
            if (!inside && math_hypot(p, q) <= farthest)
                area_put(area, (family->reach + p + 1) * cell - 1, family->reach - q, 0x00b7, STYLE_FAINT);
        }
    for (int k = 0; k < family->count; k++)
        draw_bond(family, area, &family->rays[k], cell, scale);
    area_put(area, (family->reach + 1) * cell - 1, family->reach, 0x25a0, STYLE_SECOND);
    const int rows = 2 * family->reach + 1;
    text_append(caption, sizeof caption, "%s", family->broken + family->cut ? "  x broken  | notch" : "");
    area_text(area, 1, rows, caption, STYLE_FAINT);
    return rows + 1;
}

/* --- single bonds ----------------------------------------------------------------------------------- */

/* "s = 0.0003878 = 45.6 % of s0 = 0.00085" */
static void draw_stretch(const Family *family, Area area, int y, const Ray *ray)
{
    const double s0 = settings_bonds(family->settings)->critical_stretch;
    char text[96], number[NUMBER_TEXT_MAX], share[NUMBER_TEXT_MAX], critical[NUMBER_TEXT_MAX];
    text_fitted(ray->stretch, 4, 12, number);
    text_fitted(100 * ray->stretch / s0, 4, 8, share);
    text_fitted(s0, 4, 12, critical);
    snprintf(text, sizeof text, "s = %s", number);
    if (s0 > 0)
        text_append(text, sizeof text, " = %s %% of s0 = %s", share, critical);
    area_text(area, 0, y, text, STYLE_CHANGED);
}

/* The bond that broke last, with both ends; in the step in which it did with the stretch that broke it.
 * Returns the rows used. */
static int draw_last(const Family *family, Area area)
{
    if (family->last < 0)
        return 0;
    const Ray *ray = &family->rays[family->last];
    const bool now = ray->broken_at == family->sim->step + (family->sim->stage > 0);
    char text[96];
    snprintf(text, sizeof text, now ? "bond %zu-%zu breaks in this step:" : "bond %zu-%zu broke in step %ld",
             family->node, ray->other, ray->broken_at);
    area_text(area, 0, 0, text, STYLE_WARNING);
    if (now)
        draw_stretch(family, area, 1, ray);
    return 1 + now;
}

/* The most stretched bond that is whole. Returns the rows used. */
static const char *why_it_holds(const Family *family, const Ray *ray)
{
    const double s0 = settings_bonds(family->settings)->critical_stretch;
    if (s0 <= 0)
        return "holds: bonds never break here (s0 = 0)";
    if (ray->stretch < s0)
        return "holds: below s0";
    if (family_field(family, "protected", family->node) > 0 ||
        family_field(family, "protected", ray->other) > 0)
        return "holds: protected, near load or support";
    return "breaks in the next stage of bond forces";
}

static int draw_most(const Family *family, Area area)
{
    if (family->most < 0) {
        area_text(area, 0, 0, "no bond of it is whole", STYLE_WARNING);
        return 1;
    }
    const Ray *ray = &family->rays[family->most];
    area_print(area, 0, 0, STYLE_HEADING, "most stretched: to node %zu", ray->other);
    draw_stretch(family, area, 1, ray);
    area_text(area, 0, 2, why_it_holds(family, ray), STYLE_NORMAL);
    return 3;
}

/* --- the pane --------------------------------------------------------------------------------------- */

/* The notch's bonds were cut before the run, the others broke in it. */
static void append_lost(const Family *family, char *text, size_t size)
{
    if (family->cut)
        text_append(text, size, ", %d cut by the notch", family->cut);
    if (family->broken)
        text_append(text, size, ", %d broken", family->broken);
}

static void draw_subject(const Family *family, Area area, bool narrow)
{
    char text[128];
    const Body *body = &family->body;
    snprintf(text, sizeof text, "node %zu at %.6g, %.6g mm: %d bonds", family->node,
             1e3 * (body->first[0] + family->i * body->spacing),
             1e3 * (body->first[1] + family->j * body->spacing), family->count);
    append_lost(family, text, sizeof text);
    const char *hint = !narrow                        ? " ← → ↑ ↓ next node  i closes "
                       : family->screen->panes.zoomed ? " z family "
                                                      : " z forces ";
    const Style heading = screen_is_focused(family->screen, PANE_INSPECTOR) ? STYLE_FOCUS : STYLE_HEADING;
    const int end = area.rect.width - 1;
    area_rule(area, 0, text, heading);
    if (heading_hint(area, 5 + glyphs_columns(text), end, hint) || !narrow)
        return;
    snprintf(text, sizeof text, "node %zu: %d bonds", family->node, family->count);
    append_lost(family, text, sizeof text);
    area_rule(area, 0, text, heading);
    heading_hint(area, 5 + glyphs_columns(text), end, hint);
}

/* Where the node lies: the whole beam, small. */
static void draw_place(const Screen *screen, Area area)
{
    static const Playback paused = {.state = STATE_PAUSED}; /* the node that is inspected is shown */
    Screen whole = *screen;
    whole.eye.magnified = 1;
    whole.playback = &paused;
    Picture picture;
    cells_open(&picture, area.rect.width + 2, area.rect.height + 2, area.glyphs);
    if (view_map_small(&whole, &picture))
        cells_map_body(&picture, area, screen->look.colours);
    picture_close(&picture);
}

/* Where words have no room beside the family: below it, and the forces in its place. */
static void draw_narrow(const Family *family, Area area, int cell)
{
    const Area words = area_part(area, 1, 0, area.rect.width - 1, area.rect.height);
    const int used =
        family->screen->panes.zoomed ? family_forces(family, words) : draw_family(family, area, cell);
    const Area below = area_part(words, 0, used, words.rect.width, words.rect.height - used);
    const int last = used + 2 <= area.rect.height ? draw_last(family, below) : 0;
    if (used + last + 3 <= area.rect.height)
        draw_most(family, area_part(below, 0, last, below.rect.width, below.rect.height - last));
}

static void draw(const Screen *screen, Area area)
{
    Family family;
    if (!family_of(&family, screen)) {
        area_rule(area, 0, "no family to be drawn", STYLE_HEADING);
        return;
    }
    const int width = 2 * family.reach + 1, room = area.rect.width - FAMILY_WORDS - 1;
    int cell = room / width;
    cell = cell > CELL_MOST ? CELL_MOST : cell < CELL_LEAST ? CELL_LEAST : cell;
    const int left = cell * width + 2;
    const bool narrow = left + FAMILY_WORDS - 1 > area.rect.width;
    draw_subject(&family, area, narrow);
    if (narrow) {
        draw_narrow(&family, area_part(area, 0, 1, area.rect.width, area.rect.height - 1), cell);
        return;
    }
    const int used = 1 + draw_family(&family, area_part(area, 0, 1, left, area.rect.height - 1), cell);
    Area words = area_part(area, left, 1, area.rect.width - left, area.rect.height - 1);
    const bool roomy = area.rect.height >= 16;
    int y = draw_last(&family, words);
    y += draw_most(&family, area_part(words, 0, y, words.rect.width, words.rect.height - y)) + roomy;
    y += family_forces(&family, area_part(words, 0, y, words.rect.width, words.rect.height - y));
    if (area.rect.height - used >= 4)
        draw_place(screen, area_part(area, 1, used, left - 3, area.rect.height - used));
}

/* Bonds are asked for by the thousand: there are more of them than one would keep. */
long inspector_broken_node(const Screen *screen, long step)
{
    enum { BONDS = 1, AT_ONCE = 4096 };
    const Simulation *sim = experiment_simulation(screen->experiment);
    const int when = simulation_find_field(sim, BONDS, "broken_at"),
              end = simulation_find_field(sim, BONDS, "i");
    Body body;
    double value[AT_ONCE];
    if (!body_of(sim, &body) || when < 0 || end < 0)
        return -1;
    for (size_t first = 0; first < sim->counts[BONDS]; first += AT_ONCE) {
        const size_t left = sim->counts[BONDS] - first, count = left < AT_ONCE ? left : AT_ONCE;
        sim->method->field(sim, when, first, count, value);
        for (size_t k = 0; k < count; k++)
            if (value[k] == (double)step) {
                sim->method->field(sim, end, first + k, 1, value);
                return (long)value[0];
            }
    }
    return -1;
}

static void move_on(Screen *screen, int x, int y, int page)
{
    Body body;
    if (!body_of(experiment_simulation(screen->experiment), &body))
        return;
    int i = (int)(screen->chosen.particle % (size_t)body.nx) + x * page,
        j = (int)(screen->chosen.particle / (size_t)body.nx);
    j -= y * page; /* row 0 lies below */
    i = i < 0 ? 0 : i >= body.nx ? body.nx - 1 : i;
    j = j < 0 ? 0 : j >= body.ny ? body.ny - 1 : j;
    screen->chosen.particle = (size_t)j * (size_t)body.nx + (size_t)i;
    screen->chosen.is_node = false;
    screen->eye.centre[0] = (i + 0.5) / body.nx;
    screen->eye.centre[1] = (j + 0.5) / body.ny;
}

const Inspector inspector_family = {.needs = HAS_BONDS | HAS_PLANE, .draw = draw, .move = move_on};
