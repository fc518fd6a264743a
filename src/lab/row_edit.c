/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Rows of a plate: as text in their pane, and moved on the map (edit.h). */
#include "lab/laboratory.h"
#include "scenario/concern_body.h"
#include "scenario/concern_bonds.h"
#include "scenario/concern_cells.h"
#include "scenario/rows/rows.h"
#include "base/text.h"
#include "views/view.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static void select_row(Laboratory *lab, int kind, int row)
{
    ParameterRow rows[PARAMETER_ROWS_MAX];
    const int count = screen_parameter_rows(&lab->screen, rows);
    for (int i = 0; i < count; i++)
        if (rows[i].is_row && rows[i].place.kind == kind && rows[i].place.row == row && !rows[i].place.value)
            lab->parameters.selected = i;
}

/* --- as text --- */

/* "NAME = VALUES" or "NAME VALUES"; of the kind that has no names the values alone. */
static bool part(int kind, const char *text, char name[KEY_MAX], const char **values)
{
    text += strspn(text, " ");
    name[0] = '\0';
    *values = text;
    if (row_kinds[kind].usual)
        return true;
    const size_t length = strcspn(text, " =");
    if (length == 0 || length >= KEY_MAX)
        return false;
    snprintf(name, KEY_MAX, "%.*s", (int)length, text);
    *values = text + length + strspn(text + length, " =");
    return **values != '\0';
}

bool row_edit_line(Laboratory *lab, const char *words, int kind, Status *status)
{
    Settings settings = *laboratory_settings(lab);
    char name[KEY_MAX];
    const char *values;
    if (!settings_have_rows(&settings, kind))
        return status_refuse(status, "problem %s has no %s", settings.problem->word, row_kinds[kind].section);
    if (!part(kind, words, name, &values))
        return status_refuse(status, "a %s is NAME %s, or NAME none", row_kinds[kind].one,
                             row_kinds[kind].form);
    const bool sound = strcmp(values, "none") == 0 && !row_kinds[kind].usual
                           ? settings_row_remove(&settings, kind, name, status)
                           : settings_row_set(&settings, kind, name, values, status);
    if (!sound || !edit_change(lab, &settings, experiment_edit, status))
        return false;
    const int row = settings_row_find(&settings, kind, name);
    if (row >= 0) { /* the keys that edit rows mean it now, so it is to be seen */
        lab->parameters.filter[0] = '\0';
        lab->screen.panes.focus = PANE_PARAMETERS;
        select_row(lab, kind, row);
    }
    return true;
}

/* Under another name it is another row in the place of the old one. */
static bool accept(Laboratory *lab, Status *status)
{
    RowPlace place;
    char name[KEY_MAX];
    const char *values, *text = lab->parameters.edit.text;
    if (!screen_selected_row(&lab->screen, &place) || place.row == ROW_NEW)
        return true;
    const int kind = place.kind, row = place.row;
    Settings settings = *laboratory_settings(lab);
    if (!part(kind, text, name, &values))
        return status_refuse(status, "a %s is NAME = %s", row_kinds[kind].one, row_kinds[kind].form);
    char old[ROW_NAME_MAX];
    snprintf(old, sizeof old, "%s", settings.rows[kind].rows[row].name);
    const bool renamed = strcmp(old, name) != 0;
    if (renamed && settings_row_find(&settings, kind, name) >= 0)
        return status_refuse(status, "%s.%s: there is one of that name already", row_kinds[kind].section,
                             name);
    if ((renamed && !settings_row_remove(&settings, kind, old, status)) ||
        !settings_row_set(&settings, kind, name, values, status))
        return false;
    if (renamed) {
        /* The last row of a kind comes to a place further up. */
        RowList *list = &settings.rows[kind];
        const Row moved = list->rows[list->count - 1];
        memmove(&list->rows[row + 1], &list->rows[row], (size_t)(list->count - 1 - row) * sizeof moved);
        list->rows[row] = moved;
    }
    if (!edit_change(lab, &settings, experiment_edit, status))
        return false;
    select_row(lab, kind, settings_row_find(laboratory_settings(lab), kind, name));
    return true;
}

void row_edit_begin(Laboratory *lab)
{
    RowPlace place;
    if (!screen_selected_row(&lab->screen, &place) || place.value)
        return;
    const Settings *settings = laboratory_settings(lab);
    FieldEdit *edit = &lab->parameters.edit;
    char values[ROW_TEXT_MAX];
    if (place.row == ROW_NEW)
        row_edit_add(lab);
    else {
        settings_row_get(settings, place.kind, place.row, values);
        edit->text[0] = '\0';
        if (!row_kinds[place.kind].usual)
            text_append(edit->text, sizeof edit->text,
                        "%s = ", settings->rows[place.kind].rows[place.row].name);
        text_append(edit->text, sizeof edit->text, "%s", values);
        edit_open_field(lab, accept, false);
    }
}

void row_edit_nudge(Laboratory *lab, int direction, bool fine)
{
    RowPlace place;
    edit_nudge(lab, direction, fine);
    if (screen_selected_row(&lab->screen, &place) && !place.value)
        laboratory_tell(lab,
                        place.row == ROW_NEW          ? "Enter adds a %s"
                        : row_kinds[place.kind].usual ? "the %s: Enter edits, p moves it"
                                                      : "a %s: Enter edits, p moves, C copies, D deletes it",
                        row_kinds[place.kind].one);
}

/* --- on the map --- */

/* The columns of an end's place along x and along y; -1: it has none of its own. */
static void columns_of_end(const Settings *settings, int kind, int row, int end, int columns[2])
{
    int met[2] = {0, 0};
    const bool lies = kind == ROWS_LOADS && settings_row_value(settings, kind, row, 0) <= ROW_BOTTOM;
    columns[0] = columns[1] = -1;
    for (int i = 0; i < row_kinds[kind].n_columns; i++) {
        if (!row_has(&row_kinds[kind], &settings->rows[kind].rows[row], i))
            continue;
        const RowValue value = row_kinds[kind].columns[i].value;
        const int axis = value == ROW_ALONG_X ? 0 : value == ROW_ALONG_Y ? 1 : lies ? 0 : 1;
        if (value != ROW_ALONG_X && value != ROW_ALONG_Y && value != ROW_ALONG_EDGE)
            continue;
        if (met[axis]++ == end)
            columns[axis] = i;
    }
}

/* From one node, or of bodies from one particle, to the next. */
static double spacing_of(const Settings *settings, int kind)
{
    return kind == ROWS_BODIES
               ? settings_mesh(settings)->cell_size / settings_mesh(settings)->particles_per_cell
               : settings_lattice(settings)->spacing;
}

/* Both ends together stop where the first of them meets an edge. */
static void shift(Laboratory *lab, const double by[2])
{
    const RowsShown *shown = &lab->parameters.rows;
    Settings *draft = lab->editing.draft;
    for (int axis = 0; axis < 2; axis++) {
        const double extent = axis == 0 ? settings_geometry(draft)->length : settings_geometry(draft)->height;
        double way = by[axis];
        int columns[2][2];
        for (int end = 0; end < 2; end++) {
            columns_of_end(draft, shown->kind, shown->row, end, columns[end]);
            if (columns[end][axis] < 0 || (shown->end != end && shown->end != ROW_BOTH_ENDS))
                continue;
            const double at = settings_row_value(draft, shown->kind, shown->row, columns[end][axis]);
            way = fmin(fmax(way, -at), extent - at);
        }
        for (int end = 0; end < 2 && way != 0; end++)
            if (columns[end][axis] >= 0 && (shown->end == end || shown->end == ROW_BOTH_ENDS))
                settings_row_place_put(
                    draft, &(RowPlace){shown->kind, shown->row, columns[end][axis] + 1, false},
                    settings_row_value(draft, shown->kind, shown->row, columns[end][axis]) + way);
    }
}

/* What is one place, as the probe, has no other end. */
static bool has_ends(const Settings *settings, const RowsShown *shown)
{
    int columns[2];
    columns_of_end(settings, shown->kind, shown->row, 1, columns);
    return columns[0] >= 0 || columns[1] >= 0;
}

static void say_place(Laboratory *lab)
{
    static const char *const ends[] = {"first end", "second end", "both ends"};
    const RowsShown *shown = &lab->parameters.rows;
    char values[ROW_TEXT_MAX];
    settings_row_show(lab->editing.draft, shown->kind, shown->row, values);
    if (has_ends(lab->editing.draft, shown))
        laboratory_tell(
            lab, "%s   %s: arrows one spacing, ( ) PgUp PgDn ten   Tab the other   Enter take   Esc drop",
            values, ends[shown->end]);
    else
        laboratory_tell(lab, "%s   arrows move it one spacing, ( ) PgUp PgDn ten   Enter take   Esc drop",
                        values);
}

static void begin_placing(Laboratory *lab, int kind, int row, int end)
{
    Screen *screen = &lab->screen;
    lab->parameters.rows =
        (RowsShown){.placing = true, .kind = kind, .row = row, .end = end, .draft = lab->editing.draft};
    if (!screen->views.upper->is_map && !screen->views.lower->is_map) {
        char line[48];
        snprintf(line, sizeof line, "show %s", view_of_map()->word);
        lab->run_line(lab, line, NULL);
    }
    screen->panes.focus = PANE_PARAMETERS;
    player_pause(lab);
    say_place(lab);
}

static void end_placing(Laboratory *lab)
{
    lab->parameters.rows = (RowsShown){.placing = false};
    laboratory_say(lab, MESSAGE_NONE, "%s", "");
}

bool row_edit_key(Laboratory *lab, const char *key)
{
    static const struct {
        const char *keys[2];
        int x, y, spacings;
    } moves[] = {{{"Left", "h"}, -1, 0, 1},  {{"Right", "l"}, 1, 0, 1},    {{"Up", "k"}, 0, 1, 1},
                 {{"Down", "j"}, 0, -1, 1},  {{"S-Left", "("}, -1, 0, 10}, {{"S-Right", ")"}, 1, 0, 10},
                 {{"PageUp", ""}, 0, 1, 10}, {{"PageDown", ""}, 0, -1, 10}};
    RowsShown *shown = &lab->parameters.rows;
    if (!shown->placing)
        return false;
    const double spacing = spacing_of(lab->editing.draft, shown->kind);
    for (size_t i = 0; i < sizeof moves / sizeof *moves; i++)
        if (strcmp(key, moves[i].keys[0]) == 0 || strcmp(key, moves[i].keys[1]) == 0) {
            shift(lab, (double[]){moves[i].x * moves[i].spacings * spacing,
                                  moves[i].y * moves[i].spacings * spacing});
            say_place(lab);
            return true;
        }
    if (strcmp(key, "Enter") == 0) {
        const RowsShown placed = *shown;
        Status status = {STATUS_DONE, ""};
        Settings settings = *lab->editing.draft;
        end_placing(lab);
        if (edit_change(lab, &settings, experiment_edit, &status)) {
            select_row(lab, placed.kind, placed.row);
        } else {
            *shown = placed;
            laboratory_say(lab, MESSAGE_ERROR, "%s", status.text);
        }
    } else if (strcmp(key, "Esc") == 0 || strcmp(key, "F10") == 0 || strcmp(key, "q") == 0) {
        end_placing(lab);
    } else if (strcmp(key, "Tab") == 0) {
        if (has_ends(lab->editing.draft, shown))
            shown->end = (shown->end + 1) % ROW_ENDS;
        say_place(lab);
    } else
        say_place(lab);
    return true;
}

/* An end comes to the nearest whole spacing, between the nodes; from beside the map it stays. */
void row_edit_point(Laboratory *lab, int x, int y)
{
    const RowsShown *shown = &lab->parameters.rows;
    const Settings *draft = lab->editing.draft;
    double place[2], by[2] = {0, 0};
    int columns[2];
    const bool there = view_map_place(&lab->screen, lab->width, lab->height, x, y, place);
    columns_of_end(draft, shown->kind, shown->row, shown->end == ROW_SECOND_END, columns);
    const double spacing = spacing_of(draft, shown->kind);
    for (int axis = 0; axis < 2; axis++)
        if (there && columns[axis] >= 0)
            by[axis] = spacing * round(place[axis] / spacing) -
                       settings_row_value(draft, shown->kind, shown->row, columns[axis]);
    shift(lab, by);
    say_place(lab);
}

/* --- commands --- */

/* The first kind of which rows can be added: cuts, bodies. -1: there is none, and that is said. */
static int first_kind(Laboratory *lab)
{
    for (int kind = 0; kind < ROW_KINDS; kind++)
        if (row_kinds[kind].fresh && settings_have_rows(laboratory_settings(lab), kind))
            return kind;
    laboratory_tell(lab, "only plates (cuts, loads, supports) and bodies have rows to be edited");
    return -1;
}

/* A row that is there; false: none is chosen, and that is said. */
static bool chosen(Laboratory *lab, int *kind, int *row)
{
    RowPlace place;
    const bool any = lab->screen.panes.focus == PANE_PARAMETERS && !lab->play.shown.open &&
                     screen_selected_row(&lab->screen, &place) && place.row != ROW_NEW;
    if (any)
        *kind = place.kind, *row = place.row;
    if (!any) /* where it is not marked nobody sees which one it is */
        laboratory_tell(lab, "choose a row (cut, load, support, body) among the parameters first");
    return any;
}

/* Puts a row into the draft and lets it be moved. */
static void place_new(Laboratory *lab, int kind, const char *values)
{
    Settings *draft = lab->editing.draft;
    char name[ROW_NAME_MAX];
    Status status = {STATUS_DONE, ""};
    /* "cut1", or the first of these that is free. */
    const char *one = row_kinds[kind].one;
    int number = 1;
    do
        snprintf(name, ROW_NAME_MAX, "%.*s%d", (int)strcspn(one, " "), one, number++);
    while (settings_row_find(draft, kind, name) >= 0);
    if (settings_row_set(draft, kind, name, values, &status))
        begin_placing(lab, kind, settings_row_find(draft, kind, name), ROW_BOTH_ENDS);
    else
        laboratory_say(lab, MESSAGE_ERROR, "%s", status.text);
}

void row_edit_add(Laboratory *lab)
{
    RowPlace place;
    const int first = first_kind(lab);
    if (first < 0)
        return;
    const bool any = screen_selected_row(&lab->screen, &place) && row_kinds[place.kind].fresh;
    const int kind = any ? place.kind : first;
    *lab->editing.draft = *laboratory_settings(lab);
    place_new(lab, kind, row_kinds[kind].fresh);
}

void row_edit_copy(Laboratory *lab)
{
    int kind, row;
    char values[ROW_TEXT_MAX];
    if (first_kind(lab) < 0 || !chosen(lab, &kind, &row))
        return;
    if (!row_kinds[kind].fresh) {
        laboratory_tell(lab, "there is one %s only", row_kinds[kind].one);
        return;
    }
    *lab->editing.draft = *laboratory_settings(lab);
    settings_row_get(lab->editing.draft, kind, row, values);
    place_new(lab, kind, values);
}

void row_edit_delete(Laboratory *lab)
{
    int kind, row;
    Status status = {STATUS_DONE, ""};
    if (first_kind(lab) < 0 || !chosen(lab, &kind, &row))
        return;
    Settings settings = *laboratory_settings(lab);
    char name[ROW_NAME_MAX];
    snprintf(name, sizeof name, "%s", settings.rows[kind].rows[row].name);
    if (!row_kinds[kind].fresh)
        laboratory_tell(lab, "the %s stays: it can be moved", row_kinds[kind].one);
    else if (!settings_row_remove(&settings, kind, name, &status) ||
             !edit_change(lab, &settings, experiment_edit, &status))
        laboratory_say(lab, MESSAGE_ERROR, "%s", status.text);
    else
        laboratory_tell(lab, "%s %s is gone; u brings it back", row_kinds[kind].one, name);
}

void row_edit_move(Laboratory *lab)
{
    int kind, row;
    if (first_kind(lab) < 0 || !chosen(lab, &kind, &row))
        return;
    *lab->editing.draft = *laboratory_settings(lab);
    begin_placing(lab, kind, row,
                  row_kinds[kind].usual || kind == ROWS_BODIES ? ROW_BOTH_ENDS : ROW_FIRST_END);
}
