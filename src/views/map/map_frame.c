/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Where the nodes of a beam are drawn: lengths to scale; the displacement enlarged so that it is seen; the
 * height stretched where the beam is too slender for the pane. */
#include "views/map/map.h"
#include "scenario/concern_body.h"
#include "scenario/concern_loads.h"
#include "scenario/concern_output.h"
#include "scenario/concern_time.h"
#include "scenario/settings.h"
#include "views/plots/time_plot.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define LEAST_ROWS   2.0 /* a beam is stretched that would have fewer */
#define SLENDER_PART 0.4 /* of the pane's height for a stretched beam; the rest is for its motion */
#define TALL_PART    0.82
enum { LEGEND_ROOM = 19, LEGEND_ROWS = 4 };

#define BENT_PART     0.08
#define MOST_ENLARGED 1e9
#define NODE_COLUMNS  3.0 /* from that distance on nodes are drawn one by one */

MapScene map_scene(const Settings *settings)
{
    const int concerns = settings->problem->concerns;
    MapScene scene = {.slender = concerns & CONCERN_BEAM,
                      .bent = concerns & CONCERN_DEFLECTION,
                      .by_rows = concerns & CONCERN_PLATE,
                      .leaves = concerns & CONCERN_MOTION,
                      .pressed = concerns & CONCERN_PRESSURE,
                      .notched = concerns & CONCERN_NOTCH,
                      .pinned = !(concerns & CONCERN_SUPPORTS) || settings_supports(settings)->pinned,
                      .probe = {0.5, 0.5}};
    scene.around = scene.leaves || scene.pressed || scene.by_rows;
    scene.probe[0] = scene.leaves ? 1 : 0.5;  /* the tip */
    scene.probe[1] = scene.pressed ? 1 : 0.5; /* under the load */
    if (scene.by_rows) {
        scene.probe[0] = settings_row_value(settings, ROWS_PROBE, 0, 0) / settings_geometry(settings)->length;
        scene.probe[1] = settings_row_value(settings, ROWS_PROBE, 0, 1) / settings_geometry(settings)->height;
    }
    return scene;
}

bool body_of(const Simulation *sim, Body *body)
{
    *body = (Body){.count = sim->counts[0]};
    if (!simulation_has(sim, HAS_PLANE) || body->count < 4)
        return false;
    for (int d = 0; d < 2; d++)
        body->first[d] = simulation_value(sim, sim->position[d], 0);
    body->nx = (int)sim->columns;
    body->ny = (int)sim->rows;
    body->spacing = sim->spacing;
    for (int d = 0; d < 2; d++) {
        body->low[d] = body->first[d] - body->spacing / 2;
        body->size[d] = body->spacing * (d == 0 ? body->nx : body->ny);
    }
    return body->spacing > 0;
}

/* --- places --------------------------------------------------------------------------------------- */

void map_node_place(const Map *map, size_t node, double *column, double *row)
{
    const Body *body = &map->body;
    const size_t nx = (size_t)body->nx;
    map_place(map, body->first[0] + (double)(node % nx) * body->spacing,
              body->first[1] + (double)(node / nx) * body->spacing, map->ux[node], map->uy[node], column,
              row);
}

/* The nearest whole number from 0 to count - 1. */
static int within(double value, int count)
{
    return value < 0 ? 0 : value > count - 1 ? count - 1 : (int)lround(value);
}

void map_body_place(const Map *map, double x, double y, double *column, double *row)
{
    /* a crack parts the nodes: its place is between its sides */
    enum { ASIDE = 3 };
    const Body *body = &map->body;
    const double i = (x - body->first[0]) / body->spacing, j = (y - body->first[1]) / body->spacing;
    const size_t from = (size_t)within(j, body->ny) * (size_t)body->nx;
    const size_t a = from + (size_t)within(i - ASIDE, body->nx),
                 b = from + (size_t)within(i + ASIDE, body->nx);
    map_place(map, x, y, (map->ux[a] + map->ux[b]) / 2, (map->uy[a] + map->uy[b]) / 2, column, row);
}

void map_place_of(const Map *map, int x, int y, double place[2])
{
    place[0] = map->middle[0] + (x + 0.5 - map->area.rect.width / 2.0) / map->scale_x;
    place[1] = map->middle[1] - (y + 0.5 - map->area.rect.height / 2.0) / map->scale_y;
}

long map_node_at(const Map *map, int x, int y)
{
    long nearest = -1;
    double least = INFINITY;
    for (size_t node = 0; node < map->body.count; node++) {
        double column, row;
        map_node_place(map, node, &column, &row);
        const double dx = column - x - 0.5, dy = 2 * (row - y - 0.5), distance = dx * dx + dy * dy;
        if (distance < least) {
            least = distance;
            nearest = (long)node;
        }
    }
    const double reach = 2 + map->body.spacing * map->scale_x;
    return least <= reach * reach ? nearest : -1;
}

bool map_has_mesh(const Map *map)
{
    return map->nodes_seen && simulation_has(map->sim, HAS_MESH);
}

/* --- scales --------------------------------------------------------------------------------------- */

/* How far a column of the other run of a duel has reached: two maps are compared by one scale. */
static double reach_beside(const Screen *screen, const char *name)
{
    const Experiment *other = screen_other_run(screen);
    int count = 0;
    const Column *columns = other ? experiment_columns(other, &count) : NULL;
    for (int i = 0; i < count; i++)
        if (strcmp(columns[i].quantity.name, name) == 0)
            return time_plot_reach(experiment_record(other), i);
    return 0;
}

double map_reach(const Map *map, int field, const double *now)
{
    static const char *const probes[][2] = {{"uy", "u_probe"}, {"vy", "v_probe"}};
    double reach = screen_field_reach(map->screen, field, now, map->body.count);
    for (size_t i = 0; i < sizeof probes / sizeof *probes; i++) {
        if (strcmp(map->sim->fields[field].quantity.name, probes[i][0]) != 0)
            continue;
        /* what the probe did, and what theory says that it will do */
        const int column = screen_column(map->screen, probes[i][1]);
        References *refs = experiment_references(map->screen->experiment);
        const double envelope = references_envelope(refs, probes[i][1], settings_time(map->settings)->end);
        if (column >= 0)
            reach = fmax(reach, time_plot_reach(experiment_record(map->screen->experiment), column));
        if (isfinite(envelope))
            reach = fmax(reach, envelope);
        reach = fmax(reach, reach_beside(map->screen, probes[i][1]));
    }
    return reach;
}

/* The factor that fills the room beside the beam with the largest displacement of the run. */
static double choose_enlargement(const Map *map, double rows)
{
    const double given = atof(settings_view(map->settings)->exaggeration);
    if (given > 0)
        return fmin(given, MOST_ENLARGED);
    double reach = map_reach(map, map->sim->displacement[1], map->uy);
    reach = reach > 0 ? axis_round_up(reach) : 0;
    double room = fmax(0.5, (map->area.rect.height - rows) / 2 - 0.5);
    /* a deep beam keeps its shape, and a crack its angle */
    if (map->scene.pressed)
        room = fmin(room, BENT_PART * rows);
    const double factor = reach > 0 ? room / (reach * map->scale_y) : 1;
    return factor > 1 ? axis_step_down(factor) : 1;
}

static void choose_scales(Map *map)
{
    const Screen *screen = map->screen;
    const Body *body = &map->body;
    const int width = map->area.rect.width, height = map->area.rect.height;
    /* a beam on its way out of its channel moves across the picture, which stays */
    const double travel =
        map->scene.leaves ? settings_motion(map->settings)->speed * settings_time(map->settings)->end : 0;
    const double length = body->size[0] + travel;
    map->scale_x = width / length;
    double rows = body->size[1] * map->scale_x / 2;
    /* rows that the load above and the supports below take */
    const bool pressed = map->scene.pressed;
    const double most = fmax(1, fmin(TALL_PART * height, pressed ? height - 2 : height));
    if (rows > most) {
        map->scale_x *= most / rows;
        rows = most;
    }
    map->stretch = 1;
    if (rows < LEAST_ROWS && SLENDER_PART * height > rows)
        map->stretch = axis_step_down(SLENDER_PART * height / rows);
    map->stretch = map->stretch > 1 ? map->stretch : 1;
    map->scale_y = map->scale_x / 2 * map->stretch;
    map->enlarged = choose_enlargement(map, rows * map->stretch);
    map->middle[0] = body->low[0] + length / 2;
    map->middle[1] = body->low[1] + body->size[1] / 2;
    if (screen->eye.magnified <= 1) {
        /* a beam that leaves much of the pane free stands at the left, words beside it */
        const int columns = (int)ceil(length * map->scale_x);
        if (pressed && width - columns >= LEGEND_ROOM && height >= LEGEND_ROWS + 2) {
            map->legend_at = columns + 2;
            map->middle[0] += (width - columns - 1) / 2.0 / map->scale_x;
        }
        return;
    }
    map->scale_x *= screen->eye.magnified;
    rows *= screen->eye.magnified;
    const double stretch = rows < SLENDER_PART * height ? axis_step_down(SLENDER_PART * height / rows) : 1;
    map->stretch = stretch < map->stretch ? stretch : map->stretch;
    map->scale_y = map->scale_x / 2 * map->stretch;
    map->nodes_seen = body->spacing * map->scale_x >= NODE_COLUMNS && map->stretch <= 1;
    /* a mesh stands where it is, and a particle in its cell */
    if (map_has_mesh(map) && atof(settings_view(map->settings)->exaggeration) <= 0)
        map->enlarged = 1;
    /* what is looked at stays in the middle while it moves */
    const double i = screen->eye.centre[0] * body->nx, j = screen->eye.centre[1] * body->ny;
    const size_t node =
        (size_t)within(j - 0.5, body->ny) * (size_t)body->nx + (size_t)within(i - 0.5, body->nx);
    map->middle[0] =
        body->low[0] + i * body->spacing + (map->scene.leaves ? 1 : map->enlarged) * map->ux[node];
    map->middle[1] = body->low[1] + j * body->spacing + map->enlarged * map->uy[node];
}

static void fetch(const Simulation *sim, int field, size_t count, double *out)
{
    if (field >= 0)
        sim->method->field(sim, field, 0, count, out);
    else
        for (size_t i = 0; i < count; i++)
            out[i] = 0;
}

bool map_open(Map *map, const Screen *screen, Area area)
{
    const Simulation *sim = experiment_simulation(screen->experiment);
    *map = (Map){.screen = screen,
                 .sim = sim,
                 .settings = experiment_settings(screen->experiment),
                 .area = area,
                 .coloured = screen->look.colours >= 256 && area.glyphs != GLYPHS_ASCII};
    if (area.rect.width < 4 || area.rect.height < 2 || !body_of(sim, &map->body))
        return false;
    map->scene = map_scene(map->settings);
    map->across = !map->coloured && area.glyphs == GLYPHS_BRAILLE ? 2 : 1;
    map->down = map->coloured ? 2 : area.glyphs == GLYPHS_BRAILLE ? 4 : 1;
    const size_t count = map->body.count, cells = (size_t)area.rect.width * (size_t)area.rect.height;
    const size_t pixels = cells * (size_t)(map->across * map->down);
    map->block = malloc(4 * count * sizeof *map->block);
    map->pixels = calloc(1, pixels * sizeof *map->pixels + cells * sizeof *map->marks);
    if (!map->block || !map->pixels)
        return false;
    map->marks = (MapMark *)(map->pixels + pixels);
    map->ux = map->block;
    map->uy = map->ux + count;
    map->value = map->uy + count;
    map->damage = map->value + count;
    fetch(sim, sim->displacement[0], count, map->ux);
    fetch(sim, sim->displacement[1], count, map->uy);
    fetch(sim, simulation_find_field(sim, 0, "damage"), count, map->damage);
    choose_scales(map);
    return true;
}

void map_close(Map *map)
{
    free(map->block);
    free(map->pixels);
    map->block = NULL;
    map->pixels = NULL;
}
