/* The inspector of beams: the chosen node's family, each bond with its stretch as a share of the critical
 * one, the most stretched bond and why it holds, and the forces of the bonds as they add up to the node's. */
#include "view/map.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { LINKS_MAX = 256, REACH_MAX = 8, SIDES = 3, CELL_LEAST = 4, CELL_MOST = 6, WORDS_WIDTH = 43 };

/* A bond seen from the chosen node. */
typedef struct Ray {
    size_t other;
    int p, q; /* columns and rows from the node to the other end */
    double stretch, pull;
    double direction[2]; /* as it is now */
    bool broken, notch;
} Ray;

typedef struct Family {
    const Screen *screen;
    const Simulation *sim;
    const BeamDef *beam;
    Body body;
    size_t node;
    int i, j, reach;
    Ray rays[LINKS_MAX];
    int count, most; /* the ray of the most stretched whole bond; -1: none */
    int broken, cut; /* in the run; by the notch */
} Family;

static double value_of(const Simulation *sim, int field, size_t index)
{
    double value = 0;
    if (field >= 0)
        sim->method->field(sim, field, index, 1, &value);
    return value;
}

static double named(const Family *family, const char *name, size_t node)
{
    return value_of(family->sim, simulation_find_field(family->sim, 0, name), node);
}

bool has_families(const Simulation *sim)
{
    return sim->dimensions == 2 && sim->method->links && sim->n_sets > 1 &&
           strcmp(sim->sets[1].name, "bond") == 0;
}

/* --- what there is ---------------------------------------------------------------------------------- */

/* Whether the notch cut a bond: its ends lie on two sides, and it crosses no higher than the notch's end. */
static bool is_cut(const Family *family, const Ray *ray)
{
    const BeamDef *beam = family->beam;
    const double little = 1e-6 * family->body.spacing;
    const double x = family->body.first[0] + family->i * family->body.spacing;
    const double to_x = x + ray->p * family->body.spacing, at = beam->notch_position;
    if (beam->problem != BEAM_NOTCHED || (x - at < -little) == (to_x - at < -little))
        return false;
    const double share = (at - x) / (to_x - x);
    const double y = family->body.first[1] + (family->j + share * ray->q) * family->body.spacing;
    return y <= beam->notch_depth + little;
}

static Ray ray_of(const Family *family, const Link *link)
{
    const Simulation *sim = family->sim;
    const long nx = family->body.nx;
    Ray ray = {.other = link->index, .stretch = link->weight, .broken = link->broken};
    ray.p = (int)((long)link->index % nx - family->i);
    ray.q = (int)((long)link->index / nx - family->j);
    const int steps[2] = {ray.p, ray.q};
    for (int d = 0; d < 2; d++)
        ray.direction[d] = steps[d] * family->body.spacing +
                           value_of(sim, sim->displacement[d], link->index) -
                           value_of(sim, sim->displacement[d], family->node);
    const double length = hypot(ray.direction[0], ray.direction[1]);
    for (int d = 0; d < 2 && length > 0; d++)
        ray.direction[d] /= length;
    ray.pull = link->gradient / (family->body.spacing * family->body.spacing);
    ray.notch = ray.broken && is_cut(family, &ray);
    return ray;
}

static bool family_of(Family *family, const Screen *screen)
{
    const Simulation *sim = experiment_simulation(screen->experiment);
    *family = (Family){
        .screen = screen, .sim = sim, .beam = &experiment_settings(screen->experiment)->beam, .most = -1};
    if (!body_of(sim, &family->body) || sim->counts[0] == 0)
        return false;
    family->node = screen->particle < sim->counts[0] ? screen->particle : sim->counts[0] - 1;
    family->i = (int)(family->node % (size_t)family->body.nx);
    family->j = (int)(family->node / (size_t)family->body.nx);
    Link links[LINKS_MAX];
    const size_t count = sim->method->links(sim, 0, family->node, links, LINKS_MAX);
    family->count = (int)(count < LINKS_MAX ? count : LINKS_MAX);
    for (int k = 0; k < family->count; k++) {
        const Ray ray = family->rays[k] = ray_of(family, &links[k]);
        const int reach = abs(ray.p) > abs(ray.q) ? abs(ray.p) : abs(ray.q);
        family->reach = reach > family->reach ? reach : family->reach;
        family->broken += ray.broken && !ray.notch;
        family->cut += ray.notch;
        if (!ray.broken && (family->most < 0 || ray.stretch > family->rays[family->most].stretch))
            family->most = k;
    }
    return family->reach <= REACH_MAX;
}

/* --- the family as a picture ------------------------------------------------------------------------ */

/* The factor that makes stretches numbers of two or three digits: in percent of s0, or of a power of ten. */
static double scale_of(const Family *family, char *caption, size_t size)
{
    const double s0 = family->beam->critical_stretch;
    double most = 0;
    for (int k = 0; k < family->count; k++)
        most = fmax(most, family->rays[k].broken ? 0 : fabs(family->rays[k].stretch));
    if (s0 > 0) {
        snprintf(caption, size, "%% of s0");
        return 100 / s0;
    }
    const int exponent = most > 0 ? (int)floor(log10(most)) - 1 : 0;
    snprintf(caption, size, "s x10^%d", exponent);
    return pow(10, -exponent);
}

static void draw_bond(const Family *family, Area area, const Ray *ray, int cell, double scale)
{
    const int end = (family->reach + ray->p + 1) * cell, y = family->reach - ray->q;
    char text[24];
    if (ray->broken) {
        area_put(area, end - 1, y, ray->notch ? '|' : 'x', STYLE_WARNING);
        return;
    }
    snprintf(text, sizeof text, "%.0f", ray->stretch * scale);
    if (strcmp(text, "-0") == 0)
        strcpy(text, "0");
    if (text_columns(text) > cell - (text[0] != '-')) /* far beyond: about to break, or unstable */
        strcpy(text, ray->stretch > 0 ? ">>" : "<<");
    const bool most = family->most >= 0 && ray == &family->rays[family->most];
    area_text_right(area, end, y, text, most ? STYLE_CHANGED : STYLE_NORMAL);
}

/* Returns the rows used. */
static int draw_family(const Family *family, Area area, int cell)
{
    char caption[48];
    const double scale = scale_of(family, caption, sizeof caption);
    const double horizon = family->beam->horizon / family->body.spacing * (1 + 1e-9);
    /* who is missing: beyond a surface there is no node */
    for (int q = -family->reach; q <= family->reach; q++)
        for (int p = -family->reach; p <= family->reach; p++) {
            const bool inside = family->i + p >= 0 && family->i + p < family->body.nx && family->j + q >= 0 &&
                                family->j + q < family->body.ny;
            if (!inside && hypot(p, q) <= horizon)
                area_put(area, (family->reach + p + 1) * cell - 1, family->reach - q, 0x00b7, STYLE_FAINT);
        }
    for (int k = 0; k < family->count; k++)
        draw_bond(family, area, &family->rays[k], cell, scale);
    area_put(area, (family->reach + 1) * cell - 1, family->reach, 0x25a0, STYLE_SECOND);
    const int rows = 2 * family->reach + 1;
    append(caption, sizeof caption, "%s", family->broken + family->cut ? "  x broken  | notch" : "");
    area_text(area, 1, rows, caption, STYLE_FAINT);
    return rows + 1;
}

/* --- the most stretched bond ------------------------------------------------------------------------ */

static const char *why_it_holds(const Family *family, const Ray *ray)
{
    const double s0 = family->beam->critical_stretch;
    if (s0 <= 0)
        return "holds: bonds never break here (s0 = 0)";
    if (ray->stretch < s0)
        return "holds: below s0";
    if (named(family, "protected", family->node) > 0 || named(family, "protected", ray->other) > 0)
        return "holds: protected, near load or support";
    return "breaks in the next stage of bond forces";
}

static int draw_most(const Family *family, Area area)
{
    char text[96], number[NUMBER_TEXT_MAX], share[NUMBER_TEXT_MAX];
    if (family->most < 0) {
        area_text(area, 0, 0, "no bond of it is whole", STYLE_WARNING);
        return 1;
    }
    const Ray *ray = &family->rays[family->most];
    const double s0 = family->beam->critical_stretch;
    area_print(area, 0, 0, STYLE_HEADING, "most stretched: to node %zu", ray->other);
    number_text(ray->stretch, 4, 12, number);
    number_text(100 * ray->stretch / s0, 3, 8, share);
    snprintf(text, sizeof text, "s = %s", number);
    if (s0 > 0)
        append(text, sizeof text, " = %s %% of s0", share);
    area_text(area, 0, 1, text, STYLE_CHANGED);
    area_text(area, 0, 2, why_it_holds(family, ray), STYLE_NORMAL);
    return 3;
}

/* --- the forces ------------------------------------------------------------------------------------- */

enum { FORCE_ROWS_MAX = 8, FORCE_COLUMN = 11 };

/* A row of the sum. */
typedef struct ForceRow {
    const char *name;
    double value[2];
    bool is_sum, is_changed;
} ForceRow;

typedef struct ForceSum {
    ForceRow rows[FORCE_ROWS_MAX]; /* the sides, all bonds, then load and force, or the force alone */
    double exact[FORCE_ROWS_MAX][2];
    int count;
} ForceSum;

static void add_row(ForceSum *sum, const char *name, double x, double y, bool is_sum, bool is_changed)
{
    sum->exact[sum->count][0] = x;
    sum->exact[sum->count][1] = y;
    sum->rows[sum->count++] = (ForceRow){name, {x, y}, is_sum, is_changed};
}

/* The load on the node at the time to which its force belongs, N/m^3. */
static double load_on(const Family *family)
{
    const BeamDef *beam = family->beam;
    const double time = (double)(family->sim->step + (family->sim->stage > 0)) * family->sim->dt;
    const double share = beam->load_ramp > 0 ? fmin(1, time / beam->load_ramp) : 1;
    return named(family, "loaded", family->node) > 0 ? -beam->load_stress * share / family->body.spacing : 0;
}

/* What the force of the node is made of, as far as this step has come. */
static void sum_forces(const Family *family, ForceSum *sum)
{
    static const char *const names[SIDES] = {"bonds to the left", "bonds up and down", "bonds to the right"};
    const Simulation *sim = family->sim;
    const int bonds = simulation_find_stage(sim, "bonds"), load = simulation_find_stage(sim, "body-force");
    const int drift = simulation_find_stage(sim, "drift");
    double sides[SIDES][2] = {{0}}, total[2] = {0, 0};
    for (int k = 0; k < family->count; k++) {
        const Ray *ray = &family->rays[k];
        for (int d = 0; d < 2; d++) {
            sides[1 + (ray->p > 0) - (ray->p < 0)][d] += ray->pull * ray->direction[d];
            total[d] += ray->pull * ray->direction[d];
        }
    }
    *sum = (ForceSum){.count = 0};
    const bool moved = sim->stage > drift && sim->stage <= bonds; /* the force is still the last step's */
    const bool just_bonds = sim->stage == bonds + 1, just_load = sim->stage == load + 1;
    for (int side = 0; side < SIDES; side++)
        add_row(sum, names[side], sides[side][0], sides[side][1], false, false);
    add_row(sum, "all its bonds", total[0], total[1], true, just_bonds);
    const double fx = named(family, "fx", family->node), fy = named(family, "fy", family->node);
    if (moved) {
        add_row(sum, "f, of the last step", fx, fy, true, false);
        return;
    }
    if (!just_bonds)
        add_row(sum, "load on the node", 0, load_on(family), false, just_load);
    add_row(sum, just_bonds ? "f, without the load" : "f of the node", fx, fy, true, just_bonds || just_load);
}

/* The terms of a sum are rounded so that a pencil finds the sum as it is printed: those that come nearest to
 * the next number take it. */
static void round_to_sum(double *terms, int count, double sum, double unit)
{
    double rounded[FORCE_ROWS_MAX], missing = sum;
    for (int i = 0; i < count; i++) {
        rounded[i] = round(terms[i] / unit) * unit;
        missing -= rounded[i];
    }
    for (int todo = (int)fmin(fabs(round(missing / unit)), count); todo > 0; todo--) {
        const double way = missing > 0 ? 1 : -1;
        int best = 0;
        for (int i = 1; i < count; i++)
            if (way * (terms[i] - rounded[i]) > way * (terms[best] - rounded[best]))
                best = i;
        rounded[best] += way * unit;
        missing -= way * unit;
    }
    memcpy(terms, rounded, (size_t)count * sizeof *terms);
}

/* The numbers that are printed, in units of 10^exponent. */
static void round_rows(ForceSum *sum, int exponent, int decimals)
{
    enum { ALL = SIDES, LOAD, F };
    const double unit = pow(10, -decimals);
    for (int d = 0; d < 2; d++) {
        double terms[SIDES];
        for (int i = 0; i < sum->count; i++) {
            sum->rows[i].value[d] = round(sum->rows[i].value[d] * pow(10, -exponent) / unit) * unit;
            if (i < SIDES)
                terms[i] = sum->exact[i][d] * pow(10, -exponent);
        }
        /* from the force of the node upwards */
        if (sum->count > F)
            sum->rows[ALL].value[d] = sum->rows[F].value[d] - sum->rows[LOAD].value[d];
        round_to_sum(terms, SIDES, sum->rows[ALL].value[d], unit);
        for (int i = 0; i < SIDES; i++)
            sum->rows[i].value[d] = terms[i];
    }
}

static int draw_forces(const Family *family, Area area)
{
    enum { DECIMALS = 5 };
    const Simulation *sim = family->sim;
    ForceSum sum;
    sum_forces(family, &sum);
    double most = 0;
    for (int i = 0; i < sum.count; i++)
        for (int d = 0; d < 2; d++)
            most = fmax(most, fabs(sum.rows[i].value[d]));
    const int exponent = most > 0 && isfinite(most) ? 3 * (int)floor(log10(most) / 3) : 0;
    const double size = most * pow(10, -exponent);
    const int decimals = DECIMALS - (size >= 10) - (size >= 100);
    round_rows(&sum, exponent, decimals);
    const int name_columns = area.rect.width < WORDS_WIDTH ? area.rect.width - 2 * FORCE_COLUMN : 20;
    area_text(area, 0, 0, "forces on it", STYLE_HEADING);
    area_text_right(area, name_columns + FORCE_COLUMN, 0, "fx", STYLE_HEADING);
    area_text_right(area, name_columns + 2 * FORCE_COLUMN, 0, "fy", STYLE_HEADING);
    int y = 1;
    for (int i = 0; i < sum.count; i++, y++) {
        const ForceRow *row = &sum.rows[i];
        const Style style = row->is_changed ? STYLE_CHANGED : row->is_sum ? STYLE_HEADING : STYLE_NORMAL;
        area_text(area, 0, y, row->name, style);
        for (int d = 0; d < 2; d++) {
            char text[48];
            snprintf(text, sizeof text, "%.*f", decimals, row->value[d] + 0.0);
            area_text_right(area, name_columns + (d + 1) * FORCE_COLUMN, y, text, style);
        }
    }
    const int next = sim->stage;
    const char *unit = area.glyphs == GLYPHS_ASCII ? "N/m^3" : "N/m³";
    area_print(area, 0, y, STYLE_FAINT, "x10^%d %s; next: %s", exponent, unit,
               next < sim->n_stages ? sim->stages[next].name : sim->stages[0].name);
    return y + 1;
}

/* --- the pane --------------------------------------------------------------------------------------- */

/* The notch's bonds were cut before the run, the others broke in it. */
static void append_lost(const Family *family, char *text, size_t size)
{
    if (family->cut)
        append(text, size, ", %d cut by the notch", family->cut);
    if (family->broken)
        append(text, size, ", %d broken", family->broken);
}

static void draw_subject(const Family *family, Area area, bool narrow)
{
    char text[128];
    const Body *body = &family->body;
    snprintf(text, sizeof text, "node %zu at %.6g, %.6g mm: %d bonds", family->node,
             1e3 * (body->first[0] + family->i * body->spacing),
             1e3 * (body->first[1] + family->j * body->spacing), family->count);
    append_lost(family, text, sizeof text);
    area_rule(area, 0, text, is_focused(family->screen, PANE_INSPECTOR) ? STYLE_FOCUS : STYLE_HEADING);
    const char *hint = !narrow                  ? " ← → ↑ ↓ next node  i closes "
                       : family->screen->zoomed ? " z family "
                                                : " z forces ";
    if (narrow && 5 + text_columns(text) + text_columns(hint) + 2 > area.rect.width) {
        snprintf(text, sizeof text, "node %zu: %d bonds", family->node, family->count);
        append_lost(family, text, sizeof text);
        area_rule(area, 0, text, is_focused(family->screen, PANE_INSPECTOR) ? STYLE_FOCUS : STYLE_HEADING);
    }
    if (5 + text_columns(text) + text_columns(hint) + 2 <= area.rect.width)
        area_text_right(area, area.rect.width - 1, 0, hint, STYLE_FAINT);
}

/* Where the node lies: the whole beam, small. */
static void draw_place(const Screen *screen, Area area)
{
    Screen whole = *screen;
    whole.magnified = 1;
    if (whole.state == STATE_RUNNING)
        whole.state = STATE_PAUSED; /* the node that is inspected is shown in any case */
    Map map;
    if (map_open(&map, &whole, area) && map_colour(&map, (MapVariant)(screen->variant[8] % MAP_VARIANTS))) {
        map.nodes_seen = true; /* no room for words */
        map_draw_heat(&map);
        map_draw_signs(&map);
    }
    map_close(&map);
}

/* Where words have no room beside the family: below it, and the forces in its place. */
static void draw_narrow(const Family *family, Area area, int cell)
{
    const Area words = area_part(area, 1, 0, area.rect.width - 1, area.rect.height);
    const int used = family->screen->zoomed ? draw_forces(family, words) : draw_family(family, area, cell);
    if (used + 3 <= area.rect.height)
        draw_most(family, area_part(words, 0, used, words.rect.width, words.rect.height - used));
}

void pane_family(const Screen *screen, Area area)
{
    Family family;
    if (!family_of(&family, screen)) {
        area_rule(area, 0, "no family to be drawn", STYLE_HEADING);
        return;
    }
    const int width = 2 * family.reach + 1, room = area.rect.width - WORDS_WIDTH - 1;
    int cell = room / width;
    cell = cell > CELL_MOST ? CELL_MOST : cell < CELL_LEAST ? CELL_LEAST : cell;
    const int left = cell * width + 2;
    const bool narrow = left + WORDS_WIDTH - 1 > area.rect.width;
    draw_subject(&family, area, narrow);
    if (narrow) {
        draw_narrow(&family, area_part(area, 0, 1, area.rect.width, area.rect.height - 1), cell);
        return;
    }
    const int used = 1 + draw_family(&family, area_part(area, 0, 1, left, area.rect.height - 1), cell);
    Area words = area_part(area, left, 1, area.rect.width - left, area.rect.height - 1);
    const bool roomy = area.rect.height >= 16;
    int y = draw_most(&family, words) + roomy;
    y += draw_forces(&family, area_part(words, 0, y, words.rect.width, words.rect.height - y));
    if (area.rect.height - used >= 4)
        draw_place(screen, area_part(area, 1, used, left - 3, area.rect.height - used));
}

/* Bonds are asked for by the thousand: there are more of them than one would keep. */
long screen_broken_node(const Screen *screen, long step)
{
    enum { BONDS = 1, AT_ONCE = 4096 };
    const Simulation *sim = experiment_simulation(screen->experiment);
    const int when = stage_field(sim, BONDS, "broken_at"), end = stage_field(sim, BONDS, "i");
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

void move_node(Screen *screen, int x, int y, int page)
{
    Body body;
    if (!body_of(experiment_simulation(screen->experiment), &body))
        return;
    int i = (int)(screen->particle % (size_t)body.nx) + x * page,
        j = (int)(screen->particle / (size_t)body.nx);
    j -= y * page; /* row 0 lies below */
    i = i < 0 ? 0 : i >= body.nx ? body.nx - 1 : i;
    j = j < 0 ? 0 : j >= body.ny ? body.ny - 1 : j;
    screen->particle = (size_t)j * (size_t)body.nx + (size_t)i;
    screen->node_chosen = false;
    screen->looked_at[0] = (i + 0.5) / body.nx;
    screen->looked_at[1] = (j + 0.5) / body.ny;
}
