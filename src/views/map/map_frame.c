/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Where the nodes of a beam are drawn: lengths to scale; the displacement enlarged so that it is seen; the
 * height stretched where the beam is too slender for the pane. */
#include "base/math/functions.h"
#include "base/text.h"
#include "panes/entry.h"
#include "panes/screen.h"
#include "scenario/concern_body.h"
#include "scenario/concern_cells.h"
#include "scenario/concern_loads.h"
#include "scenario/concern_output.h"
#include "scenario/concern_time.h"
#include "scenario/settings.h"
#include "views/map/map.h"
#include "views/plots/plots.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

MapScene map_scene(const Settings *settings)
{
    const int concerns = settings->problem->concerns;
    MapScene scene = {.slender = concerns & CONCERN_BEAM,
                      .bent = concerns & CONCERN_DEFLECTION,
                      .by_rows = concerns & CONCERN_PLATE,
                      .leaves = concerns & CONCERN_MOTION,
                      .pressed = concerns & CONCERN_PRESSURE,
                      .notched = concerns & CONCERN_NOTCH,
                      .bodies = concerns & CONCERN_BODIES,
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
    if (!simulation_has_map(sim) || body->count < 1)
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

/* The nearest whole number from 0 to count - 1. */
static int within(double value, int count)
{
    return value < 0 ? 0 : value > count - 1 ? count - 1 : (int)lround(value);
}

void map_body_place(const Map *map, double x, double y, double place[2])
{
    /* a crack parts the nodes: its place is between its sides */
    enum { ASIDE = 3 };
    const Body *body = &map->body;
    const double i = (x - body->first[0]) / body->spacing, j = (y - body->first[1]) / body->spacing;
    const size_t from = (size_t)within(j, body->ny) * (size_t)body->nx;
    const size_t a = from + (size_t)within(i - ASIDE, body->nx),
                 b = from + (size_t)within(i + ASIDE, body->nx);
    place[0] = x + map->drawn->along * ((map->ux[a] + map->ux[b]) / 2);
    place[1] = y + map->drawn->enlarged * ((map->uy[a] + map->uy[b]) / 2);
}

/* A line between two places of the body, bent with it: each piece begins with a dot, so one of a dotted line
 * must be long enough for some of its gaps. */
void map_body_line(Map *map, const double from[2], const double to[2], Stroke pen)
{
    const double length = math_hypot(to[0] - from[0], to[1] - from[1]);
    const double dots = 2 * length * map->drawn->scale[0], gaps = pen.line == LINE_SOLID    ? 2
                                                                  : pen.line == LINE_DASHED ? 4
                                                                                            : 8;
    const int pieces = 1 + (int)fmin(fmin(40, length / (4 * map->body.spacing)), dots / gaps);
    double last[2], next[2];
    map_body_place(map, from[0], from[1], last);
    for (int i = 1; i <= pieces; i++) {
        const double share = (double)i / pieces;
        map_body_place(map, from[0] + share * (to[0] - from[0]), from[1] + share * (to[1] - from[1]), next);
        picture_trace(map->picture, last, next, &pen);
        last[0] = next[0], last[1] = next[1];
    }
}

bool map_has_mesh(const Map *map)
{
    return map->drawn->is_near && simulation_has(map->sim, HAS_MESH);
}

/* --- scales --------------------------------------------------------------------------------------- */

double map_reach(const Map *map, int field, const double *now)
{
    static const char *const probes[][2] = {{"uy", "u_probe"}, {"vy", "v_probe"}};
    double reach = screen_field_reach(map->screen, field, now, map->body.count);
    for (size_t i = 0; i < sizeof probes / sizeof *probes; i++) {
        if (strcmp(map->sim->fields[field].quantity.name, probes[i][0]) != 0)
            continue;
        /* what the probe did, and what theory says that it will do; two maps of a duel have one scale */
        const Experiment *const runs[] = {map->screen->experiment, screen_other_run(map->screen)};
        References *refs = experiment_references(map->screen->experiment);
        const double envelope = references_envelope(refs, probes[i][1], settings_time(map->settings)->end);
        for (int r = 0; r < 2; r++) {
            const int column = runs[r] ? experiment_column(runs[r], probes[i][1]) : -1;
            if (column >= 0)
                reach = fmax(reach, time_plot_reach(experiment_record(runs[r]), column));
        }
        if (isfinite(envelope))
            reach = fmax(reach, envelope);
    }
    return reach;
}

static void lay(Map *map)
{
    const MapEye *eye = &map->screen->eye;
    const Body *body = &map->body;
    BodyRoom room = {.low = {body->low[0], body->low[1]},
                     .size = {body->size[0], body->size[1]},
                     .spacing = body->spacing,
                     .travels = map->scene.leaves,
                     .enlarged = atof(settings_view(map->settings)->exaggeration),
                     .pressed = map->scene.pressed,
                     .on_mesh = simulation_has(map->sim, HAS_MESH),
                     .magnified = eye->magnified};
    if (room.enlarged <= 0)
        room.reach = map_reach(map, map->sim->displacement[1], map->uy);
    if (map->scene.leaves)
        room.travel = settings_motion(map->settings)->speed * settings_time(map->settings)->end;
    const double i = eye->centre[0] * body->nx, j = eye->centre[1] * body->ny;
    const size_t node =
        (size_t)within(j - 0.5, body->ny) * (size_t)body->nx + (size_t)within(i - 0.5, body->nx);
    room.moved[0] = map->ux[node];
    room.moved[1] = map->uy[node];
    for (int d = 0; d < 2; d++)
        room.eye[d] = body->low[d] + (d == 0 ? i : j) * body->spacing;
    picture_lay_body(map->picture, &room);
}

bool map_open(Map *map, const Screen *screen, Picture *picture)
{
    const Simulation *sim = screen_simulation(screen);
    *map = (Map){.screen = screen, .sim = sim, .settings = screen_settings(screen), .picture = picture};
    if (picture->body[0] < 4 || picture->body[1] < 2 || !body_of(sim, &map->body))
        return false;
    map->scene = map_scene(map->settings);
    Body *body = &map->body;
    PictureMap *drawn = map->drawn = picture_map(picture, body->nx, body->ny);
    map->ux = malloc(2 * body->count * sizeof *map->ux);
    if (!map->ux || !drawn)
        return false;
    map->uy = map->ux + body->count;
    drawn->size = body->spacing;
    sim->method->field(sim, sim->displacement[0], 0, body->count, map->ux);
    sim->method->field(sim, sim->displacement[1], 0, body->count, map->uy);
    if (map->scene.bodies) {
        /* Bodies are drawn as they are, in a box that stands still. */
        const Geometry *box = settings_geometry(map->settings);
        const MapEye *eye = &screen->eye;
        BodyRoom room = {.size = {box->length, box->height},
                         .spacing = body->spacing,
                         .in_box = true,
                         .magnified = eye->magnified};
        for (int d = 0; d < 2; d++) {
            body->low[d] = 0;
            body->size[d] = room.size[d];
            room.eye[d] = eye->centre[d] * room.size[d];
        }
        drawn->is_cloud = true;
        picture_lay_body(picture, &room);
        sim->method->field(sim, sim->position[0], 0, body->count, drawn->x);
        sim->method->field(sim, sim->position[1], 0, body->count, drawn->y);
        for (size_t k = 0; k < body->count; k++) {
            drawn->x[k] += map->ux[k];
            drawn->y[k] += map->uy[k];
        }
        return true;
    }
    lay(map);
    size_t node = 0;
    for (int j = 0; j < body->ny; j++)
        for (int i = 0; i < body->nx; i++, node++) {
            drawn->x[node] = body->first[0] + i * body->spacing + drawn->along * map->ux[node];
            drawn->y[node] = body->first[1] + j * body->spacing + drawn->enlarged * map->uy[node];
        }
    return true;
}

void map_close(Map *map)
{
    free(map->ux);
    map->ux = NULL;
}

/* --- the box around bodies ------------------------------------------------------------------------ */

enum { MOVERS_MAX = 28 }; /* particles that show their velocity */
#define MOVER_COLUMNS 5.0 /* from one to the next at least, and the longest arrow */
#define MOVER_ROWS    2.5

#define CELL_COLUMNS  3.0 /* narrower cells are not drawn */
#define CROSS_ARM     0.06
#define GRAVITY_WORDS 2.0 /* columns from the tail of its arrow to its number */
#define HATCH_COLUMNS 3.0 /* from one line of a wall's hatching to the next */
#define HATCH_ROWS    0.75

/* Whether a piece lies in a rectangle. */
static bool is_covered(const Map *map, const double low[2], const double high[2])
{
    for (size_t k = 0; k < map->body.count; k++)
        if (map->drawn->x[k] >= low[0] && map->drawn->x[k] <= high[0] && map->drawn->y[k] >= low[1] &&
            map->drawn->y[k] <= high[1])
            return true;
    return false;
}

/* In the upper corner right of the box, or else in one within it that is free, with room for its number. */
static void add_gravity(Map *map)
{
    const Loads *loads = settings_loads(map->settings);
    const double *size = map->body.size, *scale = map->drawn->scale;
    const double angle = loads->incline * (M_PI / 180), length = 3 / scale[1];
    if (loads->gravity == 0)
        return;
    const double up = loads->gravity > 0 ? 1 : -1;
    const double along[2] = {up * math_sin(angle), -up * math_cos(angle)};
    const NumberText number = text_rounded(fabs(loads->gravity), 4);
    /* from its middle, in columns: the number is to the right of its tail */
    const double tail = -along[0] * length / 2 * scale[0],
                 words = GRAVITY_WORDS + 2 + glyphs_columns(number.text);
    const double left = fabs(tail) + 1, right = fmax(fabs(tail) + 1, tail + words);
    const double edge = map->drawn->middle[0] + map->picture->body[0] / 2.0 / scale[0];
    const double outside = size[0] + (HATCH_COLUMNS + left) / scale[0];
    const double places[] = {outside, size[0] - fmin((right + 1) / scale[0], size[0] / 4),
                             (left + 1) / scale[0]};
    const double middle = size[1] - length;
    for (size_t i = outside + right / scale[0] <= edge ? 0 : 1; i < sizeof places / sizeof *places; i++) {
        const double low[2] = {places[i] - left / scale[0], middle - length},
                     high[2] = {places[i] + right / scale[0], size[1]};
        if (is_covered(map, low, high))
            continue;
        PictureArrow arrow = {.style = STYLE_HEADING};
        for (int d = 0; d < 2; d++) {
            arrow.from[d] = (d == 0 ? places[i] : middle) - along[d] * length / 2;
            arrow.to[d] = (d == 0 ? places[i] : middle) + along[d] * length / 2;
        }
        picture_arrow(map->picture, &arrow);
        picture_label(map->picture, arrow.from[0], arrow.from[1], 1, STYLE_HEADING, "g %s", number.text);
        return;
    }
}

/* The particles that show their velocity: at t = 0 no two of them in one block of so many columns and rows.
 * Returns how many they are, at most one more than MOST. */
static int choose_movers(const Map *map, const double apart[2], size_t movers[MOVERS_MAX + 1])
{
    int count = 0;
    for (size_t k = 0; k < map->body.count && count <= MOVERS_MAX; k++) {
        bool free = true;
        for (int i = 0; i < count && free; i++) {
            const double x = map->drawn->x[k] - map->ux[k] - map->drawn->x[movers[i]] + map->ux[movers[i]];
            const double y = map->drawn->y[k] - map->uy[k] - map->drawn->y[movers[i]] + map->uy[movers[i]];
            free = fabs(x) * map->drawn->scale[0] >= apart[0] || fabs(y) * map->drawn->scale[1] >= apart[1];
        }
        if (free)
            movers[count++] = k;
    }
    return count;
}

void map_add_velocities(Map *map)
{
    size_t movers[MOVERS_MAX + 1];
    double fastest = 0, apart[2] = {MOVER_COLUMNS, MOVER_ROWS};
    int count = MOVERS_MAX + 1;
    for (size_t k = 0; k < map->body.count; k++)
        fastest = fmax(fastest, map->drawn->value[k]);
    while (count > MOVERS_MAX && apart[0] < 1e3) {
        count = choose_movers(map, apart, movers);
        apart[0] *= 1.25, apart[1] *= 1.25;
    }
    if (!(fastest > 0) || count > MOVERS_MAX)
        return;
    const double stretch = MOVER_COLUMNS / map->drawn->scale[0] / fastest;
    for (int i = 0; i < count; i++) {
        const double at[2] = {map->drawn->x[movers[i]], map->drawn->y[movers[i]]};
        PictureArrow arrow = {.style = STYLE_HEADING};
        for (int d = 0; d < 2; d++) {
            arrow.from[d] = at[d];
            arrow.to[d] = at[d] + stretch * simulation_named(map->sim, 0, d ? "vy" : "vx", movers[i]);
        }
        if (picture_in_sight(map->picture, at[0], at[1], 0))
            picture_arrow(map->picture, &arrow);
    }
    char text[64] = "arrows: velocity, the longest";
    text_append(text, sizeof text, " %s", text_rounded(fastest, 3).text);
    picture_note(map->picture, STYLE_FAINT, "%s", text);
}

/* The outline of the body that is being moved, of a round one its circle. */
static void add_moved(Map *map)
{
    enum { SHAPE, CX, CY, R, RI, RO, X0, Y0, X1, Y1, PARTS = 48 };
    int kind, row;
    const Settings *draft = screen_rows_shown(map->screen, &kind, &row);
    double value[ROW_VALUES_MAX], from[2], to[2] = {0, 0};
    if (!map->screen->parameters->rows.placing || kind != ROWS_BODIES)
        return;
    for (int i = 0; i < row_kinds[kind].n_columns; i++)
        value[i] = settings_row_value(draft, kind, row, i);
    const double radius = value[SHAPE] == BODY_DISC ? value[R] : value[RO];
    for (int i = 0; i <= PARTS; i++) {
        const double angle = 2 * M_PI * i / PARTS;
        const bool right = i * 4 / PARTS == 1 || i * 4 / PARTS == 2,
                   up = i * 4 / PARTS == 2 || i * 4 / PARTS == 3;
        memcpy(from, to, sizeof from);
        to[0] = value[SHAPE] == BODY_BLOCK ? value[right ? X1 : X0] : value[CX] + radius * math_cos(angle);
        to[1] = value[SHAPE] == BODY_BLOCK ? value[up ? Y1 : Y0] : value[CY] + radius * math_sin(angle);
        if (i > 0)
            picture_trace(map->picture, from, to, &(Stroke){.style = STYLE_CHANGED, .rank = RANK_BEFORE});
    }
}

void map_add_box(Map *map)
{
    if (!map->scene.bodies)
        return;
    const Domain *domain = settings_domain(map->settings);
    const BodyWall walls[2][2] = {{domain->left, domain->right}, {domain->bottom, domain->top}};
    /* A small cross at each node: lines from edge to edge would hide the particles. */
    const double cell = settings_mesh(map->settings)->cell_size;
    const Stroke pen = {.style = STYLE_FRAME, .rank = RANK_GRID, .letter = '.'};
    const long columns = lround(map->body.size[0] / cell), rows = lround(map->body.size[1] / cell);
    const double arm = CROSS_ARM * cell;
    if (cell * map->drawn->scale[0] >= CELL_COLUMNS) {
        for (long j = 1; j < rows; j++)
            for (long i = 1; i < columns; i++) {
                const double x = (double)i * cell, y = (double)j * cell;
                if (!picture_in_sight(map->picture, x, y, 0))
                    continue;
                picture_trace(map->picture, (double[]){x - arm, y}, (double[]){x + arm, y}, &pen);
                picture_trace(map->picture, (double[]){x, y - arm}, (double[]){x, y + arm}, &pen);
            }
    }
    for (int d = 0; d < 2; d++)
        for (int high = 0; high < 2; high++) {
            /* One side of the box: `d` is the direction that it stands across, `high` its far end. */
            const double *size = map->body.size, *scale = map->drawn->scale;
            const double out = high ? 1 : -1, depth = HATCH_ROWS / scale[1], apart = HATCH_COLUMNS / scale[0];
            const Stroke edge = {.line = walls[d][high] == WALL_OPEN ? LINE_DASHED : LINE_SOLID,
                                 .style = walls[d][high] == WALL_OPEN ? STYLE_FRAME : STYLE_HEADING,
                                 .rank = RANK_ZONE};
            const Stroke hatch = {.style = STYLE_FRAME, .rank = RANK_ANGLE, .letter = '/'};
            double from[2] = {0, 0}, to[2] = {size[0], size[1]};
            from[d] = to[d] = high ? size[d] : 0;
            picture_trace(map->picture, from, to, &edge);
            const int count = walls[d][high] == WALL_OPEN ? 0 : (int)fmin(size[!d] / apart, 200);
            for (int i = 0; i < count; i++) {
                double near[2], far[2];
                near[d] = from[d];
                far[d] = from[d] + out * depth;
                /* all lines rise to the right */
                near[!d] = size[!d] * (i + 0.5) / count;
                far[!d] = near[!d] + out * depth;
                picture_trace(map->picture, near, far, &hatch);
            }
        }
    add_gravity(map);
    add_moved(map);
}
