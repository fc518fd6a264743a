/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A node's row of the mass matrix, where masses are not lumped: what it shares with the nodes beside it. */
#include "views/inspector/inspector.h"

#include <stdio.h>

enum { LABEL_WIDTH = 9, COLUMN_MAX = 12, COLUMN_LEAST = 7 };

/* M is symmetric: M(i, i - d) is told with node i - d. False: there is no such matrix, or not yet. */
bool inspector_mass_row(const Simulation *sim, int set, size_t node, MassRow *row)
{
    static const char *const names[MASSES_BESIDE_MAX + 1] = {"mass_0", "mass_1", "mass_2", "mass_3"};
    size_t reach = 0;
    while (reach < MASSES_BESIDE_MAX && simulation_find_field(sim, set, names[reach + 1]) >= 0)
        reach++;
    const int own = simulation_find_field(sim, set, names[0]);
    if (own < 0 || !(simulation_value(sim, own, node) > 0))
        return false;
    row->first = node > reach ? node - reach : 0;
    row->count = 0;
    for (size_t j = row->first; j <= node + reach && j < sim->counts[set]; j++) {
        const size_t apart = j > node ? j - node : node - j;
        row->masses[row->count++] =
            simulation_value(sim, simulation_find_field(sim, set, names[apart]), j < node ? j : node);
    }
    return true;
}

void inspector_write(Area area, int end, int y, double value, Writing writing, int decimals, Style style)
{
    char text[64];
    const int shift = sum_column_number(value, writing, decimals, text);
    area_text_right(area, end - shift, y, text, style);
}

void inspector_draw_masses(const MassRow *row, const char *name, size_t node, Area area, int y)
{
    const int room = (area.rect.width - LABEL_WIDTH) / (int)(row->count + 1);
    const int width = room > COLUMN_MAX ? COLUMN_MAX : room;
    if (width < COLUMN_LEAST)
        return;
    double sum = 0;
    for (size_t k = 0; k < row->count; k++)
        sum += row->masses[k];
    const Writing writing = writing_of(row->masses, row->count, 0, sum, width - 1);
    char text[NUMBER_TEXT_MAX];
    area_text_right(area, LABEL_WIDTH - 1, y, name, STYLE_HEADING);
    snprintf(text, sizeof text, "M(%zu)", node);
    area_text_right(area, LABEL_WIDTH - 1, y + 1, text, STYLE_HEADING);
    for (size_t k = 0; k < row->count; k++) {
        const int end = LABEL_WIDTH + (int)(k + 1) * width - 1;
        snprintf(text, sizeof text, "%zu", row->first + k);
        area_text_right(area, end, y, text, STYLE_HEADING);
        inspector_write(area, end, y + 1, row->masses[k], writing, writing.decimals,
                        row->first + k == node ? STYLE_CHANGED : STYLE_NORMAL);
    }
    const int end = LABEL_WIDTH + (int)(row->count + 1) * width - 1;
    if (writing.exponent != 0)
        snprintf(text, sizeof text, "x10^%d", writing.exponent);
    area_text_right(area, end, y, writing.exponent != 0 ? text : "sum", STYLE_HEADING);
    inspector_write(area, end, y + 1, sum, writing, writing.sum_decimals, STYLE_CHANGED);
}
