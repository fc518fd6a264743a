/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The heat map: each node covers its piece of the lattice, a pixel shows the mean of what covers it. Two
 * colours stand in a cell, one above the other; where colours are few the ramp is told by ink: braille dots,
 * shades or letters. */
#include "views/map/map.h"

#include "answers/crack_growth.h"

#include <math.h>
#include <string.h>

#define GAPLESS                                                                                              \
    1.15 /* a node covers so much more than its piece: the body does not tear where it is drawn              \
          */

enum { NOTHING = -1 };

int map_step(const Map *map, double value)
{
    const int step = (int)floor((value - map->low) / (map->high - map->low) * RAMP_STEPS);
    return step < 0 ? 0 : step >= RAMP_STEPS ? RAMP_STEPS - 1 : step;
}

/* --- nodes to pixels ------------------------------------------------------------------------------ */

/* Pixels from .. end - 1 of a row or a column of pixels. */
typedef struct Span {
    int from, end;
} Span;

/* (int)floor(x), without a call for each node. */
static inline int whole(double x)
{
    const int cut = (int)x;
    return cut - (x < cut);
}

/* What a node at x covers whose piece is so wide; at least the pixel that it lies in. */
static inline Span span_of(double x, double wide, int most)
{
    Span span = {whole(x), 0};
    span.end = span.from + 1;
    if (wide > 1)
        span = (Span){whole(x - wide / 2 + 0.5), whole(x + wide / 2 + 0.5)};
    return (Span){span.from > 0 ? span.from : 0, span.end < most ? span.end : most};
}

static void cover_all(Map *map, bool hide_cracks)
{
    const Body *body = &map->body;
    const int width = map->area.rect.width * map->across, height = map->area.rect.height * map->down;
    const double wide = GAPLESS * body->spacing * map->scale_x * map->across;
    const double high = GAPLESS * body->spacing * map->scale_y * map->down;
    size_t node = 0;
    for (int j = 0; j < body->ny; j++)
        for (int i = 0; i < body->nx; i++, node++) {
            double column, row;
            map_place(map, body->first[0] + i * body->spacing, body->first[1] + j * body->spacing,
                      map->ux[node], map->uy[node], &column, &row);
            const Span across = span_of(column * map->across, wide, width),
                       down = span_of(row * map->down, high, height);
            const float value = (float)map->value[node],
                        broken = hide_cracks && map->damage[node] > CRACK_DAMAGE;
            for (int y = down.from; y < down.end; y++)
                for (int x = across.from; x < across.end; x++) {
                    Pixel *pixel = &map->pixels[(size_t)y * (size_t)width + (size_t)x];
                    pixel->sum += value;
                    pixel->count += 1;
                    pixel->broken += broken;
                }
        }
}

/* --- pixels to cells ------------------------------------------------------------------------------ */

uint32_t map_letter(const Map *map, int step)
{
    const bool is_signed = map->colouring->is_signed;
    static const char one_way[] = ".,:;-=+coaxOX%#@", two_ways[] = "WWwwvv-..+ooOO@@";
    static const uint32_t shades[] = {0x2591, 0x2592, 0x2593, 0x2588};
    if (map->area.glyphs == GLYPHS_BLOCK && !is_signed)
        return shades[step * 4 / RAMP_STEPS];
    if (map->area.glyphs == GLYPHS_BRAILLE) {
        /* left column downwards, then the right one: as many dots as the dithered map has */
        static const uint8_t filled[] = {0x40, 0xc0, 0xc4, 0xe4, 0xe6, 0xf6, 0xf7, 0xff};
        return 0x2800u + filled[step * 8 / RAMP_STEPS];
    }
    return (uint32_t)(unsigned char)(is_signed ? two_ways : one_way)[step];
}

static const Pixel *pixel_of(const Map *map, int column, int row)
{
    return &map->pixels[(size_t)row * (size_t)(map->area.rect.width * map->across) + (size_t)column];
}

static bool is_body(const Pixel *pixel)
{
    return pixel->count > 0.5f && pixel->broken <= 0.5f * pixel->count;
}

static int step_of(const Map *map, const Pixel *pixel)
{
    return is_body(pixel) ? map_step(map, (double)(pixel->sum / pixel->count)) : NOTHING;
}

Style map_ink(int step)
{
    return (Style)(STYLE_RAMP_0 + (step < RAMP_STEPS / 2 ? RAMP_STEPS - 1 : 0));
}

static void draw_colours(const Map *map, int x, int y)
{
    const int upper = step_of(map, pixel_of(map, x, 2 * y));
    const int lower = step_of(map, pixel_of(map, x, 2 * y + 1));
    const Style above = (Style)(STYLE_RAMP_0 + upper), below = (Style)(STYLE_RAMP_0 + lower);
    if (upper == NOTHING && lower == NOTHING)
        return;
    if (lower == NOTHING)
        area_put(map->area, x, y, 0x2580, above);
    else if (upper == NOTHING)
        area_put(map->area, x, y, 0x2584, below);
    else
        area_put_back(map->area, x, y, 0x2580, above, below);
}

/* The step of a whole cell, from all of its pixels. */
static int cell_step(const Map *map, int x, int y)
{
    Pixel all = {0, 0, 0};
    for (int row = 0; row < map->down; row++)
        for (int column = 0; column < map->across; column++) {
            const Pixel *pixel = pixel_of(map, x * map->across + column, y * map->down + row);
            if (!is_body(pixel))
                continue;
            all.sum += pixel->sum / pixel->count;
            all.count += 1;
        }
    return step_of(map, &all);
}

/* Braille: each of the eight dots is set where the value is above the dot's own threshold, so that more ink
 * is more; the least value still has a dot. */
static uint32_t dots_of(const Map *map, int x, int y)
{
    static const uint8_t bits[4][2] = {{0x01, 0x08}, {0x02, 0x10}, {0x04, 0x20}, {0x40, 0x80}};
    static const double thresholds[4][2] = {{7, 4}, {2, 5}, {6, 3}, {0, 1}};
    uint32_t dots = 0x2800;
    for (int row = 0; row < 4; row++)
        for (int column = 0; column < 2; column++) {
            const Pixel *pixel = pixel_of(map, 2 * x + column, 4 * y + row);
            if (!is_body(pixel))
                continue;
            const double share = ((double)(pixel->sum / pixel->count) - map->low) / (map->high - map->low);
            if (8 * share >= thresholds[row][column])
                dots |= bits[row][column];
        }
    return dots;
}

void map_draw_heat(Map *map)
{
    const Area area = map->area;
    cover_all(map, strcmp(map->colouring->field, "damage") != 0);
    for (int y = 0; y < area.rect.height; y++)
        for (int x = 0; x < area.rect.width; x++) {
            if (map->coloured) {
                draw_colours(map, x, y);
                continue;
            }
            const int step = cell_step(map, x, y);
            const bool dots = area.glyphs == GLYPHS_BRAILLE;
            const uint32_t glyph = step == NOTHING ? ' ' : dots ? dots_of(map, x, y) : map_letter(map, step);
            if (glyph != ' ' && glyph != 0x2800)
                area_put(area, x, y, glyph, (Style)(STYLE_RAMP_0 + step));
        }
}
