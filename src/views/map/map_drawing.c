/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What the nodes of a beam can be coloured by; and the beam before it moves, as in the papers' figures of the
 * problems: dimensions in mm, supports, channel, notch, load, probe; of a plate its cuts, regions by their
 * names, loads with their size. In characters, y upwards from the picture's upper edge: how many to a metre
 * is found in picture/body.c. */
#include "views/map/map.h"

#include "base/math/functions.h"
#include "scenario/concern_body.h"
#include "scenario/concern_loads.h"
#include "scenario/rows/rows.h"
#include "scenario/settings.h"
#include "base/text.h"
#include "answers/crack_growth.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>

enum { LENGTHS_MAX = 4 };

/* A length between two places, with its row below the beam. */
typedef struct Length {
    double from, to; /* m */
    int row;
} Length;

typedef struct Drawing {
    const Settings *settings;
    MapScene scene;
    Body body;
    Picture *picture;
    DrawingRoom room;
    Length lengths[LENGTHS_MAX];
    int n_lengths;
} Drawing;

/* --- places, lines, words ----------------------------------------------------------------------------- */

static double rounded(const Drawing *drawing, double place)
{
    return drawing->picture->whole ? round(place) : place;
}

static double column_of(const Drawing *drawing, double x)
{
    return rounded(drawing, 1 + (x - drawing->body.low[0]) * drawing->room.scale);
}

static double row_of(const Drawing *drawing, double share) /* of the height */
{
    const DrawingRoom *room = &drawing->room;
    return room->bottom + rounded(drawing, share * (room->top - room->bottom));
}

static void trace(const Drawing *drawing, StrokeKind kind, Style style, int count, const double (*places)[2])
{
    Plot *plot = &drawing->picture->plot;
    /* a band is no darker than the body's outline */
    plot_begin(plot, kind, (Pen){LINE_SOLID, '|', style, RANK_EXACT, kind == STROKE_BAND ? 2 : 0});
    for (int i = 0; i < count; i++)
        plot_point(plot, places[i][0], places[i][1]);
}

/* Words that begin (side 1), have their middle (0) or end (-1) at a place; those in the middle break a line.
 * Of those in STYLE_NORMAL, which are sizes, each keeps a space from lines. */
static void label(const Drawing *drawing, double x, double y, int side, Style style, const char *format, ...)
    __attribute__((format(printf, 6, 7)));

static void label(const Drawing *drawing, double x, double y, int side, Style style, const char *format, ...)
{
    PictureLabel label = {
        .x = x, .y = y, .side = side, .style = style, .on_line = side == 0, .is_size = style == STYLE_NORMAL};
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(label.text, sizeof label.text, format, arguments);
    va_end(arguments);
    picture_label(drawing->picture, &label);
}

static void label_length(const Drawing *drawing, double x, double y, int side, double metres)
{
    label(drawing, x, y, side, STYLE_NORMAL, "%s mm", text_rounded(1e3 * metres, 4).text);
}

static void put(const Drawing *drawing, double x, double y, MarkKind kind, int up, uint32_t glyph)
{
    picture_add_mark(drawing->picture,
                     (PictureMark){.x = x,
                                   .y = y,
                                   .glyph = glyph,
                                   .style = glyph == 0x25cf ? STYLE_MEASURED : STYLE_HEADING,
                                   .kind = kind,
                                   .side = {0, (signed char)up}});
}

/* --- parts ------------------------------------------------------------------------------------------- */

static void add_outline(const Drawing *drawing)
{
    const double left = column_of(drawing, drawing->body.low[0]), top = drawing->room.top,
                 right = column_of(drawing, drawing->body.low[0] + drawing->body.size[0]),
                 bottom = drawing->room.bottom, x = right + 2;
    const double box[][2] = {{left, top}, {right, top}, {right, bottom}, {left, bottom}, {left, top}};
    const double rise[][2] = {{x - 0.5, top}, {x + 0.5, top},    {x, top},
                              {x, bottom},    {x - 0.5, bottom}, {x + 0.5, bottom}};
    trace(drawing, STROKE_LINE, STYLE_NORMAL, 5, box);
    trace(drawing, STROKE_LINE, STYLE_FAINT, 6, rise);
    label_length(drawing, x + 1, row_of(drawing, 0.5), 1, settings_geometry(drawing->settings)->height);
}

/* A load on a part of the top between two supports below. */
static void add_pressure(const Drawing *drawing)
{
    const Settings *settings = drawing->settings;
    const double half = settings_loads(settings)->width / 2, top = drawing->room.top,
                 from = column_of(drawing, settings_loads(settings)->position - half),
                 to = column_of(drawing, settings_loads(settings)->position + half);
    picture_add_mark(drawing->picture, (PictureMark){.x = (from + to) / 2,
                                                     .y = top,
                                                     .half = (to - from) / 2,
                                                     .glyph = 0x25bc,
                                                     .style = STYLE_HEADING,
                                                     .kind = MARK_STANDS,
                                                     .side = {0, 1}});
    label(drawing, to + 1, top + 1, 1, STYLE_NORMAL, "%s MPa on %s mm",
          text_rounded(1e-6 * settings_loads(settings)->stress, 4).text,
          text_rounded(1e3 * settings_loads(settings)->width, 4).text);
    put(drawing, column_of(drawing, settings_supports(settings)->left), drawing->room.bottom, MARK_STANDS, -1,
        settings_supports(settings)->pinned ? 0x25b2 : 0x25cb);
    put(drawing, column_of(drawing, settings_supports(settings)->right), drawing->room.bottom, MARK_STANDS,
        -1, 0x25cb);
}

/* --- what a plate has by rows -------------------------------------------------------------------------- */

static void add_line(const Drawing *drawing, const double from[2], const double to[2], Style style)
{
    const double height = drawing->body.size[1];
    const double places[][2] = {{column_of(drawing, from[0]), row_of(drawing, from[1] / height)},
                                {column_of(drawing, to[0]), row_of(drawing, to[1] / height)}};
    trace(drawing, STROKE_LINE, style, 2, places);
}

static void add_rows(const Drawing *drawing)
{
    const Settings *settings = drawing->settings;
    for (int kind = 0; kind < ROW_KINDS; kind++)
        for (int row = 0; settings_have_rows(settings, kind) && row < settings->rows[kind].count; row++) {
            double ends[2][2];
            map_row_ends(settings, kind, row, ends);
            if (kind == ROWS_PROBE)
                continue; /* add_parts() has it */
            if (kind == ROWS_CUTS) {
                add_line(drawing, ends[0], ends[1], STYLE_HEADING);
            } else if (kind == ROWS_LOADS) {
                /* Arrows beside the edge, and the size of the traction where there is room. */
                const double sx = settings_row_value(settings, ROWS_LOADS, row, 3),
                             sy = settings_row_value(settings, ROWS_LOADS, row, 4),
                             height = drawing->body.size[1];
                PictureMark arrow = {
                    .glyph = glyph_arrow(2 * sx, -sy), .style = STYLE_HEADING, .kind = MARK_BESIDE};
                map_row_side((int)settings_row_value(settings, ROWS_LOADS, row, 0), arrow.side);
                const int right = arrow.side[0], up = arrow.side[1];
                double places[2][2];
                for (int i = 0; i < 2; i++) {
                    places[i][0] = column_of(drawing, ends[i][0]);
                    places[i][1] = row_of(drawing, ends[i][1] / height);
                }
                picture_spread(drawing->picture, places[0], places[1], (double[]){1, 1}, &arrow);
                const double x = up ? fmax(places[0][0], places[1][0]) + 2 : places[0][0] - 2 * right,
                             y = up ? places[0][1] + up : (places[0][1] + places[1][1]) / 2;
                label(drawing, x, y, up ? 1 : -right, STYLE_NORMAL, "%s MPa",
                      text_rounded(1e-6 * math_hypot(sx, sy), 4).text);
            } else {
                double corners[5][2];
                map_row_corners(ends, corners);
                for (int i = 0; i < 4; i++)
                    add_line(drawing, corners[i], corners[i + 1], STYLE_FRAME);
                label(drawing, column_of(drawing, fmax(ends[0][0], ends[1][0])) + 1,
                      row_of(drawing, (ends[0][1] + ends[1][1]) / 2 / drawing->body.size[1]), 1, STYLE_FAINT,
                      "%s", settings->rows[kind].rows[row].name);
            }
        }
}

/* --- the whole ---------------------------------------------------------------------------------------- */

static void add(Drawing *drawing, double from, double to, int row)
{
    drawing->lengths[drawing->n_lengths++] = (Length){from, to, row};
    drawing->room.lengths = row + 1 > drawing->room.lengths ? row + 1 : drawing->room.lengths;
}

static void add_parts(const Drawing *drawing)
{
    add_outline(drawing);
    if (drawing->scene.notched) {
        /* A cut from below, seen in any case, with its depth. */
        const Settings *settings = drawing->settings;
        const double x = column_of(drawing, settings_notch(settings)->position),
                     share = settings_notch(settings)->depth / settings_geometry(settings)->height,
                     bottom = drawing->room.bottom,
                     end = fmax(row_of(drawing, share), bottom + drawing->picture->whole);
        const double places[][2] = {{x, bottom}, {x, end}};
        trace(drawing, STROKE_LINE, STYLE_HEADING, 2, places);
        label_length(drawing, x + 1, fmax(end, bottom + 1), 1, settings_notch(settings)->depth);
    }
    if (drawing->scene.pressed)
        add_pressure(drawing);
    else if (drawing->scene.leaves) {
        /* The body behind the clamp goes through a channel with walls. */
        const double from = column_of(drawing, -settings_motion(drawing->settings)->channel),
                     to = column_of(drawing, 0);
        for (int side = 1; side >= -1; side -= 2) {
            const double edge = side > 0 ? drawing->room.top : drawing->room.bottom,
                         near = edge + 0.15 * side, far = edge + 0.8 * side;
            const double places[][2] = {{from, near}, {from, far}, {to, near}, {to, far}};
            trace(drawing, STROKE_BAND, STYLE_FRAME, 4, places);
        }
        label(drawing, from + 2, row_of(drawing, 0.5), 1, STYLE_HEADING, "→ %s m/s",
              text_rounded(settings_motion(drawing->settings)->speed, 4).text);
    } else if (drawing->scene.bent) {
        /* The ends of a beam that vibrates are held at half its height. */
        const double y = row_of(drawing, 0.5), low = drawing->body.low[0];
        put(drawing, column_of(drawing, low), y, MARK_PLACE, 0, 0x25b2);
        put(drawing, column_of(drawing, low + drawing->body.size[0]), y, MARK_PLACE, 0, 0x25cb);
    }
    if (drawing->scene.by_rows)
        add_rows(drawing);
    const double *probe = drawing->scene.probe;
    const double x = column_of(drawing, drawing->body.low[0] + probe[0] * drawing->body.size[0]);
    const int side = probe[1] >= 1 ? 1 : -1;
    put(drawing, x, row_of(drawing, probe[1]), MARK_PLACE, 0, 0x25cf);
    /* a line of cells makes room for words, a thin one does not */
    label(drawing, x + side, row_of(drawing, probe[1]) - (side > 0 && !drawing->picture->whole), side,
          STYLE_MEASURED, "probe");
    for (int i = 0; i < drawing->n_lengths; i++)
        if (drawing->lengths[i].row < drawing->room.lengths) {
            /* "├── 65 mm ──┤", or upright: with a tick at both ends. */
            const Length *length = &drawing->lengths[i];
            const double from = column_of(drawing, length->from), to = column_of(drawing, length->to),
                         y = drawing->room.bottom - 1 - drawing->room.around -
                             drawing->room.apart * length->row;
            const double places[][2] = {{from, y + 0.25}, {from, y - 0.25}, {from, y},
                                        {to, y},          {to, y + 0.25},   {to, y - 0.25}};
            trace(drawing, STROKE_LINE, STYLE_FAINT, 6, places);
            label_length(drawing, (from + to) / 2, y, 0, length->to - length->from);
        }
}

/* "to scale", or by how much the height is not; and "E 71 GPa  density 2700  thickness 5 mm  u(0) 3 µm". */
static void add_notes(const Drawing *drawing)
{
    const Settings *settings = drawing->settings;
    char text[160];
    const double least = drawing->picture->whole ? 0.2 : 1e-9; /* a row is not stretched */
    picture_note(drawing->picture, STYLE_NORMAL,
                 fabs(math_log(drawing->room.stretch)) < least ? "to scale" : "height × %s",
                 text_rounded(drawing->room.stretch, 2).text);
    snprintf(text, sizeof text, "E %s GPa  density %s kg/m³  thickness %s mm",
             text_rounded(1e-9 * settings_material(settings)->youngs_modulus, 4).text,
             text_rounded(settings_material(settings)->density, 5).text,
             text_rounded(1e3 * settings_geometry(settings)->thickness, 4).text);
    if (drawing->scene.bent && settings_start(settings)->amplitude != 0)
        text_append(text, sizeof text, "  U %s µm",
                    text_rounded(1e6 * settings_start(settings)->amplitude, 4).text);
    if (settings_loads(settings)->body_force != 0)
        text_append(text, sizeof text, "  body force %s m/s²",
                    text_rounded(settings_loads(settings)->body_force, 4).text);
    picture_note(drawing->picture, STYLE_FAINT, "%s", text);
}

void map_drawing(const Screen *screen, Picture *picture)
{
    const Settings *settings = screen_settings(screen);
    Drawing drawing = {.settings = settings, .scene = map_scene(settings), .picture = picture};
    if (!body_of(screen_simulation(screen), &drawing.body))
        return;
    drawing.room.around = drawing.scene.around;
    drawing.room.size[0] = drawing.body.size[0];
    drawing.room.size[1] = drawing.body.size[1];
    /* The most important lengths first: those that have no row are left out from the end. */
    const MapScene *scene = &drawing.scene;
    int row = 0;
    if (scene->leaves)
        add(&drawing, -settings_motion(drawing.settings)->channel, 0, row);
    if (scene->notched)
        add(&drawing, 0, settings_notch(drawing.settings)->position, row++);
    if (scene->pressed) {
        add(&drawing, 0, settings_loads(drawing.settings)->position, row++);
        add(&drawing, settings_supports(drawing.settings)->left, settings_supports(drawing.settings)->right,
            row++);
    }
    add(&drawing, 0, settings_geometry(drawing.settings)->length, row);
    if (!picture_lay_drawing(picture, &drawing.room))
        return;
    screen_time_text(screen, 0, picture->time, sizeof picture->time);
    picture_heading(picture, "the %s at t = 0", settings->problem->body);
    add_parts(&drawing);
    add_notes(&drawing);
}

/* --- colours -------------------------------------------------------------------------------------- */

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

static bool is_there(const Simulation *sim, int variant)
{
    const bool of_bodies = variant >= MAP_SPEED && variant < MAP_COLOURINGS;
    if (of_bodies && !simulation_has(sim, HAS_BODIES))
        return false;
    return (variant == MAP_DRAWING && simulation_has(sim, HAS_PLANE)) ||
           (variant != MAP_DRAWING && simulation_find_field(sim, 0, colourings[variant].field) >= 0);
}

const char *map_meaning(const Map *map)
{
    const Colouring *colouring = map->colouring;
    return map->scene.slender || !colouring->flat ? colouring->meaning : colouring->flat;
}

MapVariant map_variant(const Simulation *sim, int number)
{
    int variant = 0;
    for (; variant < MAP_VARIANTS; variant++)
        if (is_there(sim, variant) && number-- == 0)
            break;
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

/* A value that all but a few nodes keep below: a load's edge or a crack's tip must not leave the rest of the
 * beam without colour. */
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
