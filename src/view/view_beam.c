/* View 8: a beam as it lies, coloured by a field. The displacement is drawn enlarged and, where the beam is
 * too slender for the pane, its height as well; both factors are stated. */
#include "view/panes.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* What a beam can be coloured by; a signed field has its zero in the middle of the ramp. */
static const struct {
    const char *field;
    bool is_signed;
} colourings[] = {{"uy", true}, {"ux", true}, {"vy", true}, {"strain_energy", false}, {"damage", false}};
enum { COLOURINGS = sizeof colourings / sizeof *colourings };

int view_beam_variants(const Screen *screen)
{
    return experiment_simulation(screen->experiment)->dimensions == 2 ? COLOURINGS : 1;
}

/* One half of a cell: about as wide as it is high. */
typedef struct Pixel {
    double sum;
    float count, broken;
} Pixel;

typedef struct Picture {
    int width, height; /* pixels; two in a cell, one above the other */
    Pixel *pixels;
    double low_x, scale_x; /* pixel = (x - low_x) scale_x */
    double mid_y, scale_y; /* pixel = height / 2 - (y - mid_y) scale_y - move scale_move */
    double move;           /* pixels for a displacement of 1 */
} Picture;

/* The particles and what is needed of them. */
typedef struct Cloud {
    size_t count, columns; /* particles; in a row of the lattice */
    double *x, *y, *ux, *uy, *value, *damage, *held, *loaded;
    double low[2], high[2];
} Cloud;

static double *values_of(const Simulation *sim, int field)
{
    const size_t count = sim->counts[0];
    double *values = calloc(count + 1, sizeof *values);
    if (values && field >= 0)
        sim->method->field(sim, field, 0, count, values);
    return values;
}

static void cloud_close(Cloud *cloud)
{
    double *all[] = {cloud->x,     cloud->y,      cloud->ux,   cloud->uy,
                     cloud->value, cloud->damage, cloud->held, cloud->loaded};
    for (size_t i = 0; i < sizeof all / sizeof *all; i++)
        free(all[i]);
}

static bool cloud_open(Cloud *cloud, const Simulation *sim, int field)
{
    *cloud = (Cloud){
        .count = sim->counts[0],
        .x = values_of(sim, sim->position[0]),
        .y = values_of(sim, sim->position[1]),
        .ux = values_of(sim, sim->displacement[0]),
        .uy = values_of(sim, sim->displacement[1]),
        .value = values_of(sim, field),
        .damage = values_of(sim, simulation_find_field(sim, 0, "damage")),
        .held = values_of(sim, simulation_find_field(sim, 0, "held")),
        .loaded = values_of(sim, simulation_find_field(sim, 0, "loaded")),
    };
    if (!cloud->x || !cloud->y || !cloud->ux || !cloud->uy || !cloud->value || !cloud->damage ||
        !cloud->held || !cloud->loaded || cloud->count < 4)
        return false;
    cloud->low[0] = cloud->high[0] = cloud->x[0];
    cloud->low[1] = cloud->high[1] = cloud->y[0];
    for (size_t i = 0; i < cloud->count; i++) {
        cloud->low[0] = fmin(cloud->low[0], cloud->x[i] + cloud->ux[i]);
        cloud->high[0] = fmax(cloud->high[0], cloud->x[i] + cloud->ux[i]);
        cloud->low[1] = fmin(cloud->low[1], cloud->y[i]);
        cloud->high[1] = fmax(cloud->high[1], cloud->y[i]);
    }
    cloud->columns = 1;
    while (cloud->columns < cloud->count && cloud->y[cloud->columns] == cloud->y[0])
        cloud->columns++;
    return cloud->high[0] > cloud->low[0] && cloud->high[1] > cloud->low[1];
}

/* Scales: lengths true, the height stretched if it would be less than a few pixels, the displacement so that
 * the largest of the run fills what is left. */
static void choose_scales(const Cloud *cloud, double reach, Picture *picture, double *stretch,
                          double *enlarged)
{
    const double spacing = cloud->columns > 1 ? cloud->x[1] - cloud->x[0] : cloud->high[0] - cloud->low[0];
    const double length = cloud->high[0] - cloud->low[0] + spacing,
                 height = cloud->high[1] - cloud->low[1] + spacing;
    picture->scale_x = picture->width / length;
    picture->low_x = cloud->low[0] - spacing / 2;
    picture->mid_y = (cloud->low[1] + cloud->high[1]) / 2;
    const double most = 0.6 * picture->height, true_height = height * picture->scale_x;
    *stretch = 1;
    if (true_height > most)
        *stretch = most / true_height;
    else if (true_height < 0.3 * picture->height)
        *stretch = step_round_down(0.45 * picture->height / true_height);
    picture->scale_y = picture->scale_x * *stretch;
    const double room = (picture->height - height * picture->scale_y) / 2 - 1;
    *enlarged = reach > 0 && room > 0 ? room / (reach * picture->scale_y) : 1;
    *enlarged = *enlarged > 1 ? step_round_down(*enlarged) : 1;
    picture->move = picture->scale_y * *enlarged;
}

static Pixel *pixel_at(Picture *picture, int x, int y)
{
    if (x < 0 || y < 0 || x >= picture->width || y >= picture->height)
        return NULL;
    return &picture->pixels[(size_t)y * (size_t)picture->width + (size_t)x];
}

/* Each particle covers its piece of the lattice; a pixel shows the mean of what covers it. */
static void fill(const Cloud *cloud, Picture *picture, bool hide_broken)
{
    const size_t rows = cloud->count / cloud->columns;
    const double wide = cloud->columns > 1 ? (cloud->x[1] - cloud->x[0]) * picture->scale_x : picture->width;
    const double high =
        (cloud->high[1] - cloud->low[1]) / (double)(rows > 1 ? rows - 1 : 1) * picture->scale_y;
    for (size_t i = 0; i < cloud->count; i++) {
        const double px = (cloud->x[i] + cloud->ux[i] - picture->low_x) * picture->scale_x;
        const double py = picture->height / 2.0 - (cloud->y[i] - picture->mid_y) * picture->scale_y -
                          cloud->uy[i] * picture->move;
        if (!(fabs(px) < 1e6) || !(fabs(py) < 1e6))
            continue;
        int left = (int)floor(px - wide / 2 + 0.5), right = (int)floor(px + wide / 2 + 0.5);
        int top = (int)floor(py - high / 2 + 0.5), bottom = (int)floor(py + high / 2 + 0.5);
        right = right > left ? right : left + 1;
        bottom = bottom > top ? bottom : top + 1;
        if (wide < 1)
            left = (int)floor(px), right = left + 1;
        if (high < 1)
            top = (int)floor(py), bottom = top + 1;
        for (int y = top; y < bottom; y++)
            for (int x = left; x < right; x++) {
                Pixel *pixel = pixel_at(picture, x, y);
                if (!pixel)
                    continue;
                pixel->sum += cloud->value[i];
                pixel->count += 1;
                pixel->broken += hide_broken && cloud->damage[i] > 0.35;
            }
    }
}

/* --- from pixels to cells --- */

enum { NOTHING = -1 };

/* The step of the ramp, or NOTHING. */
static int step_of(const Pixel *pixel, double low, double high)
{
    if (pixel->count < 0.5f || pixel->broken > 0.5f * pixel->count)
        return NOTHING;
    double share = (pixel->sum / (double)pixel->count - low) / (high - low);
    int step = (int)floor(share * RAMP_STEPS);
    return step < 0 ? 0 : step >= RAMP_STEPS ? RAMP_STEPS - 1 : step;
}

/* Where colours are few the ramp is told by glyphs, darker for more. */
static uint32_t letter_of(int step)
{
    return (uint32_t)(unsigned char)".,:;-=+coaxOX%#@"[step];
}

static bool has_colours(const Screen *screen, Area area)
{
    return screen->colours >= 256 && area.glyphs != GLYPHS_ASCII;
}

static void draw_cell(const Screen *screen, Area area, int x, int y, int upper, int lower)
{
    if (upper == NOTHING && lower == NOTHING)
        return;
    if (!has_colours(screen, area)) {
        int step = upper == NOTHING ? lower : lower == NOTHING ? upper : (upper + lower + 1) / 2;
        area_put(area, x, y, letter_of(step), (Style)(STYLE_RAMP_0 + step));
    } else if (lower == NOTHING) {
        area_put(area, x, y, 0x2580, (Style)(STYLE_RAMP_0 + upper));
    } else if (upper == NOTHING) {
        area_put(area, x, y, 0x2584, (Style)(STYLE_RAMP_0 + lower));
    } else {
        area_put_back(area, x, y, 0x2580, (Style)(STYLE_RAMP_0 + upper), (Style)(STYLE_RAMP_0 + lower));
    }
}

/* Supports below, load above: a mark at the first pixel beyond the beam. */
static void draw_marks(const Cloud *cloud, Picture *picture, Area area)
{
    for (int pass = 0; pass < 2; pass++) {
        const double *flag = pass == 0 ? cloud->held : cloud->loaded;
        for (size_t i = 0; i < cloud->count; i++) {
            if (flag[i] <= 0)
                continue;
            const int x = (int)floor((cloud->x[i] + cloud->ux[i] - picture->low_x) * picture->scale_x);
            if (x < 0 || x >= picture->width)
                continue;
            int y = pass == 0 ? picture->height - 1 : 0;
            const int step = pass == 0 ? -1 : 1;
            while (y >= 0 && y < picture->height && pixel_at(picture, x, y)->count < 0.5f)
                y += step;
            y -= step;
            area_put(area, x, y / 2, pass == 0 ? 0x25b2 : 0x25bc, STYLE_HEADING);
        }
    }
}

/* "-3 [ramp] 3 µm" */
static void draw_scale(const Screen *screen, Area area, int y, double low, double high, const char *unit)
{
    const Axis axis = axis_make(low, high, 3);
    char text[TICK_TEXT_MAX], scale[TICK_TEXT_MAX];
    axis_label(&axis, low, text);
    int x = 1 + area_text(area, 1, y, text, STYLE_NORMAL) + 1;
    for (int i = 0; i < RAMP_STEPS; i++)
        area_put(area, x++, y, has_colours(screen, area) ? 0x2588 : letter_of(i), (Style)(STYLE_RAMP_0 + i));
    axis_label(&axis, high, text);
    x += 1 + area_text(area, x + 1, y, text, STYLE_NORMAL) + 1;
    axis_scale_text(&axis, strcmp(unit, "1") == 0 ? "" : unit, scale);
    area_text(area, x, y, scale, STYLE_NORMAL);
}

void view_beam(const Screen *screen, Area area, Style heading, int variant)
{
    const Simulation *sim = experiment_simulation(screen->experiment);
    if (sim->dimensions != 2) {
        pane_mesh(screen, area);
        return;
    }
    const char *name = colourings[variant % COLOURINGS].field;
    const int field = simulation_find_field(sim, 0, name);
    Cloud cloud;
    Picture picture = {.width = area.rect.width - 2, .height = 2 * (area.rect.height - 2)};
    const size_t size =
        picture.width > 0 && picture.height > 0 ? (size_t)picture.width * (size_t)picture.height : 0;
    const bool sound = cloud_open(&cloud, sim, field);
    picture.pixels = size ? calloc(size, sizeof *picture.pixels) : NULL;
    if (!sound || !picture.pixels || field < 0) {
        area_rule(area, 0, "the beam", heading);
        free(picture.pixels);
        cloud_close(&cloud);
        return;
    }
    /* a beam on its way out of its channel moves across the picture, which stays */
    const Settings *settings = experiment_settings(screen->experiment);
    if (settings->problem == PROBLEM_MOVING_CANTILEVER)
        cloud.high[0] = fmax(cloud.high[0], cloud.x[cloud.count - 1] + settings->beam.speed * settings->end);
    double stretch, enlarged;
    double reach = field_reach(screen, sim->displacement[1], cloud.uy, cloud.count);
    reach = reach > 0 ? step_round_up(reach) : 0;
    choose_scales(&cloud, reach, &picture, &stretch, &enlarged);
    const bool damage = strcmp(name, "damage") == 0;
    fill(&cloud, &picture, !damage);

    /* a crack right through leaves half of the family at best */
    double most = damage ? 0.5 : field_reach(screen, field, cloud.value, cloud.count);
    most = most > 0 ? axis_round_up(most) : 1;
    const double low = colourings[variant % COLOURINGS].is_signed ? -most : 0;
    Area map = area_part(area, 1, 1, picture.width, area.rect.height - 2);
    for (int y = 0; y < map.rect.height; y++)
        for (int x = 0; x < picture.width; x++)
            draw_cell(screen, map, x, y, step_of(pixel_at(&picture, x, 2 * y), low, most),
                      step_of(pixel_at(&picture, x, 2 * y + 1), low, most));
    draw_marks(&cloud, &picture, map);

    char title[128], number[NUMBER_TEXT_MAX];
    snprintf(title, sizeof title, "%s", sim->fields[field].quantity.meaning);
    char factors[96] = "";
    append(factors, sizeof factors, "  moved x %.0f", enlarged);
    if (stretch != 1) {
        text_rounded(number, stretch, 2);
        append(factors, sizeof factors, "  height x %s", number);
    }
    if (text_columns(title) + text_columns(factors) + 8 > area.rect.width)
        snprintf(title, sizeof title, "%s", sim->fields[field].quantity.label);
    append(title, sizeof title, "%s", factors);
    area_rule(area, 0, title, heading);
    const char *note = damage ? "a through crack reads 0.4 to 0.5" : "";
    draw_scale(screen, area, area.rect.height - 1, low, most, sim->fields[field].quantity.unit);
    if (area.rect.width > 34 + text_columns(note))
        area_text_right(area, area.rect.width - 1, area.rect.height - 1, note, STYLE_FAINT);
    free(picture.pixels);
    cloud_close(&cloud);
}
