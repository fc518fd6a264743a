/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Numbers of things, one row each; what the last stage changed is marked. The chosen thing and the chosen
 * column are together what Enter has followed over time. */
#include "panes/screen.h"
#include "views/view.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { FIELDS_MAX = 48 };

static int variants_of(const Screen *screen)
{
    return screen_simulation(screen)->n_sets;
}

static void describe(const Screen *screen, int variant, Picture *picture)
{
    const Simulation *sim = screen_simulation(screen);
    const int set = variant < sim->n_sets ? variant : 0;
    const size_t count = sim->counts[set], wanted = set == 0 ? screen->chosen.particle : screen->chosen.node;
    int fields[FIELDS_MAX], n_fields = 0;
    for (int pass = 0; pass < 2; pass++) /* those of its CSV table first, in their order, then the others */
        for (int i = 0; i < sim->n_fields && n_fields < FIELDS_MAX; i++)
            if (sim->fields[i].set == set && sim->fields[i].in_table == (pass == 0))
                fields[n_fields++] = i;
    const int last = n_fields - 1;
    PictureList *list = picture_list(picture, set, count,
                                     wanted < count ? wanted
                                     : count > 0    ? count - 1
                                                    : 0,
                                     n_fields);
    const bool empty = set == 1 && simulation_has(sim, HAS_MESH) && experiment_stage(screen->experiment) == 0;
    picture_heading(picture, "%s, %zu of them%s", sim->sets[set].plural, count,
                    empty ? ": no mass until stage 1" : "");
    if (!list)
        return;
    snprintf(list->what, sizeof list->what, "%s", sim->sets[set].name);
    for (size_t i = 0; i < list->rows; i++)
        snprintf(list->names[i], sizeof list->names[i], "%zu", list->first + i);
    for (int c = 0; c < n_fields; c++) {
        const int index = fields[c];
        const Field *field = &sim->fields[index];
        PictureColumn *head = &list->columns[c];
        const ScreenText unit = screen_unit_text(screen, field);
        head->kind = field->integer ? LIST_COUNT : LIST_NUMBER;
        snprintf(head->name, sizeof head->name, "%.30s%s%s", field->quantity.label, *unit.text ? "," : "",
                 unit.text);
        double *values = malloc(2 * list->rows * sizeof *values), *before = values + list->rows;
        if (values) {
            sim->method->field(sim, index, list->first, list->rows, values);
            const bool known =
                experiment_field_before(screen->experiment, index, list->first, list->rows, before);
            for (size_t j = 0; j < list->rows; j++) {
                const bool changed =
                    known && before[j] != values[j] && !(isnan(before[j]) && isnan(values[j]));
                *picture_cell(list, c, j) =
                    (PictureCell){.value = values[j], .style = changed ? STYLE_CHANGED : STYLE_NORMAL};
            }
            free(values);
        }
    }
    const int chosen = screen->chosen.table_column;
    list->chosen_column = chosen < last ? chosen : last;
    if (n_fields > 0) /* else no field of the set is in a table */
        snprintf(picture->follow, sizeof picture->follow, "%.16s %zu %.30s", sim->sets[set].name,
                 list->chosen, sim->fields[fields[list->chosen_column]].quantity.name);
}

const View view_table = {
    .word = "tables",
    .help = "numbers of particles; again: of nodes; Enter: the marked one over time",
    .digit = 7,
    .home = PANE_UPPER,
    .describe = describe,
    .is_list = true,
    .variants = variants_of,
    .duel = DUEL_APART,
    .no_figure = true,
};
