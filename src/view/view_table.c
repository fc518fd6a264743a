/* View 7: numbers of things, one row each; what the last stage changed is marked. */
#include "view/panes.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { CELL_WIDTH = 10, INDEX_WIDTH = 7, FIELDS_MAX = 48, ROWS_MAX = 256 };

int view_table_variants(const Screen *screen)
{
    return experiment_simulation(screen->experiment)->n_sets;
}

/* The fields of a set: those of its CSV table first, in their order, then the others. */
static int fields_of(const Simulation *sim, int set, int out[FIELDS_MAX])
{
    int count = 0;
    for (int pass = 0; pass < 2; pass++)
        for (int i = 0; i < sim->n_fields && count < FIELDS_MAX; i++)
            if (sim->fields[i].set == set && sim->fields[i].in_table == (pass == 0))
                out[count++] = i;
    return count;
}

static size_t chosen_of(const Screen *screen, int set)
{
    return set == 0 ? screen->particle : set == 1 ? screen->node : 0;
}

void view_table(const Screen *screen, Area area, Style heading, int set)
{
    const Simulation *sim = experiment_simulation(screen->experiment);
    if (set >= sim->n_sets)
        set = 0;
    int fields[FIELDS_MAX];
    const int n_fields = fields_of(sim, set, fields);
    const int shown = (area.rect.width - INDEX_WIDTH) / CELL_WIDTH;
    int first_field = screen->table_column;
    if (first_field > n_fields - shown)
        first_field = n_fields - shown;
    if (first_field < 0)
        first_field = 0;

    const size_t count = sim->counts[set];
    size_t chosen = chosen_of(screen, set);
    chosen = chosen < count ? chosen : count ? count - 1 : 0;
    const int room = area.rect.height - 2 < ROWS_MAX ? area.rect.height - 2 : ROWS_MAX;
    if (room < 1)
        return;
    size_t first = chosen > (size_t)(room / 2) ? chosen - (size_t)(room / 2) : 0;
    if (count > (size_t)room && first > count - (size_t)room)
        first = count - (size_t)room;
    if (count <= (size_t)room)
        first = 0;

    const size_t rows = count - first < (size_t)room ? count - first : (size_t)room;
    char name[64];
    const bool empty = set == 1 && has_mesh(sim) && experiment_stage(screen->experiment) == 0;
    snprintf(name, sizeof name, "%s, %zu of them%s", sim->sets[set].plural, count,
             empty ? " (empty between steps)" : "");
    area_rule(area, 0, name, heading);
    area_text_right(area, INDEX_WIDTH - 1, 1, sim->sets[set].name, STYLE_HEADING);
    for (int y = 0; y < room && first + (size_t)y < count; y++) {
        const size_t index = first + (size_t)y;
        const bool here = index == chosen;
        char text[NUMBER_TEXT_MAX];
        snprintf(text, sizeof text, "%zu", index);
        for (int x = 0; here && x < area.rect.width; x++)
            area_put(area, x, 2 + y, ' ', STYLE_SELECTED);
        area_text_right(area, INDEX_WIDTH - 1, 2 + y, text, here ? STYLE_SELECTED : STYLE_FAINT);
    }
    for (int column = 0; column < shown && first_field + column < n_fields; column++) {
        const int field = fields[first_field + column], end = INDEX_WIDTH + (column + 1) * CELL_WIDTH - 1;
        Area label = area_part(area, end - CELL_WIDTH + 1, 1, CELL_WIDTH, 1);
        area_text_right(label, CELL_WIDTH - 1, 0, sim->fields[field].quantity.name, STYLE_HEADING);
        double values[ROWS_MAX], before[ROWS_MAX];
        sim->method->field(sim, field, first, rows, values);
        const bool known = experiment_field_before(screen->experiment, field, first, rows, before);
        for (int y = 0; y < (int)rows; y++) {
            const size_t index = first + (size_t)y;
            const double value = values[y];
            char text[NUMBER_TEXT_MAX];
            bool changed = known && before[y] != value && !(isnan(before[y]) && isnan(value));
            if (sim->fields[field].integer)
                snprintf(text, sizeof text, "%.0f", value);
            else
                number_text(value, 5, CELL_WIDTH - 1, text);
            area_text_right(area, end, 2 + y, text,
                            changed           ? STYLE_CHANGED
                            : index == chosen ? STYLE_SELECTED
                                              : STYLE_NORMAL);
        }
    }
}
