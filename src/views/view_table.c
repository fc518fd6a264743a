/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Numbers of things, one row each; what the last stage changed is marked. The chosen thing and the chosen
 * column are kept in sight; together they are what Enter has followed over time. */
#include "panes/panes.h"
#include "picture/sum_column.h"
#include "views/views.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { CELL_WIDTH = 10, INDEX_WIDTH = 9, FIELDS_MAX = 48, ROWS_MAX = 256, HEAD_ROWS = 2 };

static int variants_of(const Screen *screen)
{
    return experiment_simulation(screen->experiment)->n_sets;
}

/* --- what is shown -------------------------------------------------------------------------------- */

typedef struct TableColumn {
    int field, width;
    char name[88]; /* label and unit */
} TableColumn;

typedef struct Table {
    int set;
    TableColumn columns[FIELDS_MAX];
    int n_columns;
    int first_column, end_column; /* those that fit */
    int chosen_column;
    size_t first, rows, chosen;
} Table;

/* The fields of a set: those of its CSV table first, in their order, then the others. */
static void list_columns(const Screen *screen, Table *table)
{
    const Simulation *sim = experiment_simulation(screen->experiment);
    for (int pass = 0; pass < 2; pass++)
        for (int i = 0; i < sim->n_fields && table->n_columns < FIELDS_MAX; i++) {
            const Field *field = &sim->fields[i];
            if (field->set != table->set || field->in_table != (pass == 0))
                continue;
            TableColumn *column = &table->columns[table->n_columns++];
            char unit[24];
            screen_unit_text(screen, field, unit, sizeof unit);
            snprintf(column->name, sizeof column->name, "%.30s%s%s", field->quantity.label, *unit ? "," : "",
                     unit);
            column->field = i;
            column->width = glyphs_columns(column->name) + 2;
            column->width = column->width > CELL_WIDTH ? column->width : CELL_WIDTH;
        }
}

/* The column after the last one that fits, from `first` on. */
static int last_that_fits(const Table *table, int first, int width)
{
    int end = first, used = INDEX_WIDTH;
    while (end < table->n_columns && used + table->columns[end].width <= width)
        used += table->columns[end++].width;
    return end;
}

static Table table_of(const Screen *screen, int set, int width, int height)
{
    const Simulation *sim = experiment_simulation(screen->experiment);
    Table table = {.set = set < sim->n_sets ? set : 0};
    list_columns(screen, &table);
    table.chosen_column = screen->chosen.table_column;
    if (table.chosen_column > table.n_columns - 1)
        table.chosen_column = table.n_columns - 1;
    /* no further than the chosen one needs */
    while (table.first_column < table.chosen_column &&
           last_that_fits(&table, table.first_column, width) <= table.chosen_column)
        table.first_column++;
    table.end_column = last_that_fits(&table, table.first_column, width);

    const size_t count = sim->counts[table.set],
                 chosen = table.set == 0 ? screen->chosen.particle : screen->chosen.node;
    table.chosen = chosen < count ? chosen : count > 0 ? count - 1 : 0;
    const size_t room = height <= HEAD_ROWS             ? 0
                        : height - HEAD_ROWS < ROWS_MAX ? (size_t)(height - HEAD_ROWS)
                                                        : ROWS_MAX;
    table.first = table.chosen > room / 2 ? table.chosen - room / 2 : 0;
    if (table.first + room > count)
        table.first = count > room ? count - room : 0;
    table.rows = count - table.first < room ? count - table.first : room;
    return table;
}

/* --- drawing -------------------------------------------------------------------------------------- */

static void draw_heading_of(const Screen *screen, Area area, const Table *table, Style heading)
{
    const Simulation *sim = experiment_simulation(screen->experiment);
    char text[96], more[64] = "";
    const bool empty =
        table->set == 1 && simulation_has(sim, HAS_MESH) && experiment_stage(screen->experiment) == 0;
    snprintf(text, sizeof text, "%s, %zu of them%s", sim->sets[table->set].plural, sim->counts[table->set],
             empty ? ": no mass until stage 1" : "");
    area_rule(area, 0, text, heading);
    const int end = screen_second_run(screen) ? 20 : 2; /* in a duel it is said at the end whose they are */
    if (table->end_column - table->first_column < table->n_columns)
        snprintf(more, sizeof more, " ← → columns %d-%d of %d ", table->first_column + 1, table->end_column,
                 table->n_columns);
    heading_hint(area, 5 + glyphs_columns(text), area.rect.width + 1 - end, more);
}

static void draw_column(Experiment *experiment, Area area, const Table *table, const TableColumn *column,
                        int end, Style heading)
{
    const Simulation *sim = experiment_simulation(experiment);
    double values[ROWS_MAX], before[ROWS_MAX];
    area_text_right(area, end, 1, column->name, heading);
    sim->method->field(sim, column->field, table->first, table->rows, values);
    const bool known = experiment_field_before(experiment, column->field, table->first, table->rows, before);
    const Format format = format_of(values, table->rows, 5, CELL_WIDTH - 1);
    for (size_t i = 0; i < table->rows; i++) {
        char text[NUMBER_TEXT_MAX];
        const bool changed = known && before[i] != values[i] && !(isnan(before[i]) && isnan(values[i]));
        if (sim->fields[column->field].integer)
            snprintf(text, sizeof text, "%.0f", values[i]);
        else
            format_number(values[i], format, text);
        area_text_right(area, end, HEAD_ROWS + (int)i, text,
                        changed                             ? STYLE_CHANGED
                        : table->first + i == table->chosen ? STYLE_SELECTED
                                                            : STYLE_NORMAL);
    }
}

static void draw(const Screen *screen, Area area, Style heading, int set)
{
    const Table table = table_of(screen, set, area.rect.width, area.rect.height);
    const Simulation *sim = experiment_simulation(screen->experiment);
    if (area.rect.height <= HEAD_ROWS)
        return;
    draw_heading_of(screen, area, &table, heading);
    area_text_right(area, INDEX_WIDTH - 1, 1, sim->sets[table.set].name, STYLE_HEADING);
    for (size_t i = 0; i < table.rows; i++) {
        const bool here = table.first + i == table.chosen;
        const int y = HEAD_ROWS + (int)i;
        char text[NUMBER_TEXT_MAX];
        snprintf(text, sizeof text, "%zu", table.first + i);
        for (int x = 0; here && x < area.rect.width; x++)
            area_put(area, x, y, ' ', STYLE_SELECTED);
        area_text_right(area, INDEX_WIDTH - 1, y, text, here ? STYLE_SELECTED : STYLE_FAINT);
    }
    int end = INDEX_WIDTH;
    for (int c = table.first_column; c < table.end_column; c++) {
        end += table.columns[c].width;
        draw_column(screen->experiment, area, &table, &table.columns[c], end - 1,
                    c == table.chosen_column && heading == STYLE_FOCUS ? STYLE_FOCUS : STYLE_HEADING);
    }
}

/* --- keys and mouse ------------------------------------------------------------------------------- */

static Table table_at(const Screen *screen, Rect rect)
{
    return table_of(screen, view_variant(&view_table, screen), rect.width, rect.height);
}

/* Up and down go from row to row, left and right from column to column. */
static void move(Screen *screen, Rect rect, int x, int y, int page)
{
    const Table table = table_at(screen, rect);
    screen->chosen.is_node = table.set == 1;
    if (y != 0) {
        selection_next(&screen->chosen, experiment_simulation(screen->experiment), y, (size_t)page);
    } else if (rect.width > 0) {
        const int to = table.chosen_column + x, most = table.n_columns - 1;
        screen->chosen.table_column = to < 0 ? 0 : to > most ? most : to;
    }
}

/* The field of the chosen row in the chosen column, as `:plot` takes it. */
static void follow(const Screen *screen, char out[FOLLOW_TEXT_MAX])
{
    const Simulation *sim = experiment_simulation(screen->experiment);
    const Table table = table_of(screen, view_variant(&view_table, screen), 0, 0);
    out[0] = '\0';
    if (table.n_columns == 0)
        return; /* no field of the set stands in a table */
    snprintf(out, FOLLOW_TEXT_MAX, "%.16s %zu %.30s", sim->sets[table.set].name, table.chosen,
             sim->fields[table.columns[table.chosen_column].field].quantity.name);
}

static bool click(Screen *screen, Rect rect, int x, int y)
{
    const Table table = table_at(screen, rect);
    const int row = y - rect.y - HEAD_ROWS;
    if (x < rect.x || x >= rect.x + rect.width || row < 0 || row >= (int)table.rows)
        return false;
    *(table.set == 0 ? &screen->chosen.particle : &screen->chosen.node) = table.first + (size_t)row;
    screen->chosen.is_node = table.set == 1;
    return true;
}

const View view_table = {
    .word = "tables",
    .brief = "tables",
    .help = "numbers of particles; again: of nodes; Enter: the marked one over time",
    .digit = 7,
    .home = PANE_UPPER,
    .draw = draw,
    .variants = variants_of,
    .duel = DUEL_APART,
    .of_moment = true,
    .move = move,
    .follow = follow,
    .click = click,
};
