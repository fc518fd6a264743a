/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The parameter pane: fields by group, read-only numbers below, at the end what the chosen one may be. */
#include "panes/panes.h"
#include "scenario/settings.h"
#include "scenario/rows/rows.h"
#include "lessons/lesson_shown.h"

#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

static bool passes(const ParametersShown *shown, const char *label, const char *key)
{
    return strcasestr(label, shown->filter) || strcasestr(key, shown->filter);
}

/* The rows of a plate of one kind under its section's name, and a place for a new one. */
static int add_rows(const Screen *screen, int kind, ParameterRow *rows, int room)
{
    const Settings *settings = screen_settings(screen);
    const RowKind *about = &row_kinds[kind];
    const RowList *list = &settings->rows[kind];
    int count = 0;
    if (!settings_have_rows(settings, kind))
        return 0;
    const int places = list->count + (about->fresh && list->count < ROWS_OF_KIND_MAX);
    for (int row = 0; row < places && count + 1 < room; row++) {
        const bool is_new = row == list->count;
        if (!passes(screen->parameters, is_new ? "" : list->rows[row].name, about->section))
            continue;
        if (count == 0)
            rows[count++] = (ParameterRow){.heading = about->section, .derived = -1};
        rows[count++] = (ParameterRow){
            .derived = -1, .is_row = true, .place = {.kind = kind, .row = is_new ? ROW_NEW : row}};
    }
    return count;
}

const Settings *screen_rows_shown(const Screen *screen, int *kind, int *row)
{
    const RowsShown *shown = &screen->parameters->rows;
    RowPlace place = {.kind = -1, .row = -1};
    const bool any =
        !shown->placing && screen->panes.focus == PANE_PARAMETERS && screen_selected_row(screen, &place);
    *kind = shown->placing ? shown->kind : any ? place.kind : -1;
    *row = shown->placing ? shown->row : any ? place.row : -1;
    return shown->placing ? shown->draft : screen_settings(screen);
}

int screen_parameter_rows(const Screen *screen, ParameterRow rows[PARAMETER_ROWS_MAX])
{
    const Settings *settings = screen_settings(screen);
    const char *group = "";
    int count = 0;
    if (screen_is_plain(screen) && !screen->lesson->open && !screen->parameters->filter[0]) {
        Asked asked[ASKED_MAX];
        const int n_asked = settings_asked(settings, asked);
        for (; count < n_asked; count++)
            rows[count] = (ParameterRow){.parameter = asked[count].parameter,
                                         .derived = -1,
                                         .is_row = !asked[count].parameter,
                                         .place = asked[count].place};
        return count;
    }
    for (int i = 0; i < n_parameters && count + 2 < PARAMETER_ROWS_MAX; i++) {
        const Parameter *parameter = &parameters[i];
        /* Mistakes are looked for by a filter, or set by name; a row for none of them tells nothing. */
        if (!parameter_applies_to(settings, parameter) ||
            (parameter->wrong && !*screen->parameters->filter &&
             !settings_are_at_work(settings, parameter)) ||
            !passes(screen->parameters, parameter->label, parameter->key))
            continue;
        if (strcmp(parameter->group, group) != 0)
            rows[count++] = (ParameterRow){.heading = group = parameter->group, .derived = -1};
        rows[count++] = (ParameterRow){.parameter = parameter, .derived = -1};
    }
    for (int kind = 0; kind < ROW_KINDS; kind++)
        count += add_rows(screen, kind, rows + count, PARAMETER_ROWS_MAX - count);
    Derived derived[DERIVED_MAX];
    int n_derived = experiment_derived(screen->experiment, derived);
    bool begun = false;
    for (int i = 0; i < n_derived && count + 1 < PARAMETER_ROWS_MAX; i++) {
        bool is_field = false; /* too */
        for (int k = 0; k < n_parameters && !is_field; k++) {
            const char *point = strchr(parameters[k].key, '.');
            is_field = point && strcmp(point + 1, derived[i].name) == 0 &&
                       parameter_applies(&parameters[k], settings->problem);
        }
        if (is_field || !passes(screen->parameters, derived[i].label, derived[i].name))
            continue;
        if (!begun)
            rows[count++] = (ParameterRow){.heading = "Follows from these", .derived = -1};
        begun = true;
        rows[count++] = (ParameterRow){.derived = i};
    }
    return count;
}

bool screen_chosen_row(const Screen *screen, ParameterRow *row)
{
    ParameterRow rows[PARAMETER_ROWS_MAX];
    const int count = screen_parameter_rows(screen, rows), selected = screen->parameters->selected;
    const bool any = selected >= 0 && selected < count;
    if (any)
        *row = rows[selected];
    return any;
}

bool screen_selected_row(const Screen *screen, RowPlace *place)
{
    ParameterRow row;
    const bool any = screen_chosen_row(screen, &row) && row.is_row;
    if (any)
        *place = row.place;
    return any;
}

int screen_row_of(const Screen *screen, const Parameter *parameter)
{
    ParameterRow rows[PARAMETER_ROWS_MAX];
    const int count = screen_parameter_rows(screen, rows);
    int first = 0;
    for (int i = 0; i < count; i++)
        if (rows[i].parameter && rows[i].parameter == parameter)
            return i;
    while (first < count && rows[first].heading)
        first++;
    return first < count ? first : 0;
}

/* A size of a beam as the lattice has it, where that is another one than asked for; "" where it is not. */
static void real_text(const Screen *screen, const Parameter *parameter, char out[NUMBER_TEXT_MAX])
{
    const Settings *settings = screen_settings(screen);
    out[0] = '\0';
    if (parameter->type != PARAMETER_REAL)
        return;
    const double nominal = settings_number(settings, parameter);
    double real = NAN;
    if (strcmp(parameter->key, "beam.height") == 0)
        real = screen_derived(screen, "real_height");
    else if (strcmp(parameter->key, "beam.length") == 0 &&
             !(settings->problem->concerns & (CONCERN_MOTION | CONCERN_SUPPORTS)))
        real = screen_derived(screen, "real_span");
    if (fabs(real - nominal) > 1e-6 * nominal)
        strcpy(out, text_fitted(real, 4, 8).text);
}

/* The first row shown, so that the chosen one stands near the middle. */
int pane_parameters_first(const ParametersShown *shown, int count, int room)
{
    int first = shown->selected - room / 2;
    if (first > count - room)
        first = count - room;
    return first > 0 ? first : 0;
}

/* A long text moves left so that the cursor is seen. */
void pane_field(Area field, const char *text, int cursor)
{
    const int room = field.rect.width;
    for (; cursor >= room && *text; cursor--)
        glyph_next(&text);
    area_blank(field, 0, room, 0, STYLE_EDIT);
    area_text(field, 0, 0, text, STYLE_EDIT);
    field.canvas->cursor_x = field.rect.x + (cursor < room ? cursor : room - 1);
    field.canvas->cursor_y = field.rect.y;
}

/* The field under edit, from column `from` on or, where that leaves too little, farther left. */
static void draw_field(const Screen *screen, Area area, int y, int from)
{
    const int room = area.rect.width - from < 12 ? 12 : area.rect.width - from;
    const FieldEdit *edit = &screen->parameters->edit;
    pane_field(area_part(area, area.rect.width - room, y, room, 1), edit->text, edit->cursor);
}

/* A row of a plate: its name and its values; while it is edited both are in the field, as in a file. */
static void draw_row(const Screen *screen, Area area, int y, const ParameterRow *row, bool chosen)
{
    const Settings *settings = screen_settings(screen);
    const bool focused = chosen && screen->panes.focus == PANE_PARAMETERS;
    const Style style = focused ? STYLE_SELECTED : row->place.row == ROW_NEW ? STYLE_FAINT : STYLE_NORMAL;
    if (focused)
        area_blank(area, 1, area.rect.width, y, style);
    char name[64], value[ROW_TEXT_MAX] = "";
    if (row->place.row == ROW_NEW)
        snprintf(name, sizeof name, "+ %s", row_kinds[row->place.kind].one);
    else
        settings_row_place_show(settings, &row->place, name, value);
    const bool under_heading = !row->place.value && row->place.row != ROW_NEW &&
                               (!screen_is_plain(screen) || screen->parameters->filter[0]);
    if (under_heading)
        snprintf(name, sizeof name, "%s", settings->rows[row->place.kind].rows[row->place.row].name);
    if (focused && screen->parameters->edit.open) {
        draw_field(screen, area, y, row->place.value ? 3 + glyphs_columns(name) : 1);
        return;
    }
    const int label = 2 + area_text(area, 2, y, name, style) - (*name ? 0 : 1);
    const int columns = glyphs_columns(value), room = area.rect.width - label - 1;
    area_text(area_part(area, label + 1, y, room, 1), columns < room ? room - columns : 0, 0, value, style);
    if (focused && !screen->prompt->open) {
        area.canvas->cursor_x = area.rect.x + 1;
        area.canvas->cursor_y = area.rect.y + y;
    }
}

void pane_parameter(const Screen *screen, Area area, int y, const Parameter *parameter, bool chosen)
{
    const Settings *settings = screen_settings(screen);
    const bool focused = chosen && screen->panes.focus == PANE_PARAMETERS;
    const int width = area.rect.width;
    Style style = focused ? STYLE_SELECTED : STYLE_NORMAL;
    if (focused)
        area_blank(area, 1, width, y, style);
    const bool alone = screen_is_plain(screen) && !screen->lesson->open;
    char value[LIST_MAX], name[48];
    if (alone)
        parameter_name_alone(parameter, name, sizeof name);
    else
        snprintf(name, sizeof name, "%s", parameter->label);
    settings_show(settings, parameter, value);
    if (value[0] == '\0')
        snprintf(value, sizeof value, "-");
    /* a number is never cut: where both have no room, the label is shorter */
    const bool is_number = parameter->type == PARAMETER_REAL || parameter->type == PARAMETER_INTEGER;
    const int wanted = 3 + glyphs_columns(name);
    /* the plain sheet has no row for the unit of the chosen one */
    const char *unit = alone && settings->problem->si ? parameter_in(parameter, settings->problem).unit : "";
    if (parameter->type == PARAMETER_REAL && unit[0] && strcmp(unit, "1") != 0 &&
        isdigit((unsigned char)value[strspn(value, "-.")]) &&
        wanted + glyphs_columns(value) + 1 + glyphs_columns(unit) <= width)
        text_append(value, sizeof value, " %s", unit);
    if (is_number && glyphs_columns(value) > width - wanted && parameter->type == PARAMETER_REAL)
        strcpy(value,
               text_fitted(settings_number(settings, parameter), 6, width - wanted < 10 ? 10 : width - wanted)
                   .text);
    const int label_width = is_number ? width - glyphs_columns(value) - 1 : width;
    const int indent = is_number && 2 + glyphs_columns(name) > label_width ? 1 : 2;
    int label = area_text(area_part(area, 0, y, label_width, 1), indent, 0, name, style) + indent;

    if (focused && screen->parameters->edit.open) {
        draw_field(screen, area, y, label + 1);
        return;
    }
    const int columns = glyphs_columns(value), room = width - label - 1;
    if (focused && parameter->type == PARAMETER_CHOICE && columns + 2 <= room) {
        char marked[LIST_MAX + 8];
        snprintf(marked, sizeof marked, "‹%s›", value);
        area_text_right(area, width, y, marked, style);
    } else if (columns <= room) {
        char real[NUMBER_TEXT_MAX], brackets[NUMBER_TEXT_MAX + 4];
        real_text(screen, parameter, real);
        snprintf(brackets, sizeof brackets, "(%s) ", real);
        area_text_right(area, width, y, value, style);
        if (real[0] && glyphs_columns(brackets) + columns + 1 <= room)
            area_text_right(area, width - columns, y, brackets, focused ? style : STYLE_FAINT);
    } else {
        area_text(area_part(area, label + 1, y, room, 1), 0, 0, value, style);
    }
    if (focused && !screen->prompt->open) {
        area.canvas->cursor_x = area.rect.x + 1;
        area.canvas->cursor_y = area.rect.y + y;
    }
}

/* Below the fields: the unit of the chosen one, and what it may be. */
enum { HINT_ROWS = 2 };

/* A text in both rows of the hint, parted at a space. False: it fits into the first, and is there. */
static bool draw_wrapped(Area area, const char *text)
{
    const int room = area.rect.width - 2, top = area.rect.height - HINT_ROWS;
    size_t cut = strlen(text);
    while (cut > 0 && (cut > (size_t)room || (text[cut] && text[cut] != ' ')))
        cut--;
    if (cut == 0)
        cut = strlen(text); /* one word */
    area_print(area, 2, top, STYLE_FAINT, "%.*s", (int)cut, text);
    if (!text[cut])
        return false;
    area_text(area, 2, top + 1, text + cut + 1, STYLE_FAINT);
    return true;
}

static void draw_hint(const Screen *screen, Area area, const ParameterRow *row, const Derived *derived)
{
    const Settings *settings = screen_settings(screen);
    char unit[96] = "", range[96] = "", real[NUMBER_TEXT_MAX] = "", values[ROW_TEXT_MAX];
    if (row->parameter) {
        snprintf(unit, sizeof unit, "%s", parameter_in(row->parameter, settings->problem).unit);
        parameter_range(row->parameter, settings->problem, range, sizeof range);
        real_text(screen, row->parameter, real);
    } else if (row->derived >= 0) {
        snprintf(unit, sizeof unit, "%s", derived[row->derived].unit);
        snprintf(range, sizeof range, "read only");
    } else if (row->is_row) {
        /* The values that have no room beside the name or, while they are edited, what they are. */
        const RowKind *kind = &row_kinds[row->place.kind];
        const bool is_new = row->place.row == ROW_NEW;
        const char *hint = kind->form;
        if (!is_new && !screen->parameters->edit.open) {
            const char *name = settings->rows[row->place.kind].rows[row->place.row].name;
            settings_row_show(settings, row->place.kind, row->place.row, values);
            if (2 + glyphs_columns(name) + 1 + glyphs_columns(values) > area.rect.width)
                hint = values;
        }
        if (draw_wrapped(area, hint))
            return;
        snprintf(range, sizeof range, "%s",
                 is_new        ? "Enter adds one"
                 : kind->usual ? "Enter edits, p moves it"
                               : "Enter edits  p C D: ?");
    }
    if (unit[0] && strcmp(unit, "1") != 0)
        area_print(area, 2, area.rect.height - 2, STYLE_FAINT, real[0] ? "in %s, lattice %s" : "unit: %s",
                   unit, real);
    area_text(area, 2, area.rect.height - 1, range, STYLE_FAINT);
}

/* As many as have room. Returns the first one that is shown. */
static int draw_rows(const Screen *screen, Area area, const ParameterRow *rows, int count,
                     const Derived *derived)
{
    const int first = pane_parameters_first(screen->parameters, count, area.rect.height);
    const bool focused = screen->panes.focus == PANE_PARAMETERS;
    for (int y = 0; y < area.rect.height && first + y < count; y++) {
        const ParameterRow *row = &rows[first + y];
        const bool chosen = first + y == screen->parameters->selected;
        if (row->heading)
            area_text(area, 1, y, row->heading, focused ? STYLE_FOCUS : STYLE_HEADING);
        else if (row->parameter)
            pane_parameter(screen, area, y, row->parameter, chosen);
        else if (row->is_row)
            draw_row(screen, area, y, row, chosen);
        else {
            const Derived *number = &derived[row->derived];
            const Style style = chosen && focused ? STYLE_SELECTED : STYLE_FAINT;
            char value[NUMBER_TEXT_MAX];
            if (chosen && focused)
                area_blank(area, 1, area.rect.width, y, style);
            const int label = area_text(area, 2, y, number->label, style) + 2;
            if (number->integer)
                snprintf(value, sizeof value, "%.0f", number->value);
            else
                strcpy(value, text_fitted(number->value, 6, area.rect.width - label - 1).text);
            area_text_right(area, area.rect.width, y, value, style);
        }
    }
    return first;
}

void pane_parameters(const Screen *screen, Area area)
{
    ParameterRow rows[PARAMETER_ROWS_MAX];
    Derived derived[DERIVED_MAX];
    const int count = screen_parameter_rows(screen, rows);
    experiment_derived(screen->experiment, derived);
    const bool focused = screen->panes.focus == PANE_PARAMETERS;
    const int room = area.rect.height > HINT_ROWS ? area.rect.height - HINT_ROWS : area.rect.height,
              first = draw_rows(screen, area_part(area, 0, 0, area.rect.width, room), rows, count, derived);
    if (count == 0)
        area_text(area, 1, 0, "no parameter of that name", STYLE_FAINT);
    if (room == area.rect.height)
        return;
    if (focused && screen->parameters->selected >= 0 && screen->parameters->selected < count)
        draw_hint(screen, area, &rows[screen->parameters->selected], derived);
    else if (first + room < count) {
        area_print(area, 2, area.rect.height - 1, STYLE_FAINT, "%d more below", count - first - room);
    }
}

/* --- the plain sheet ------------------------------------------------------------------------------- */

enum { ASK_LINES = 2 };

void pane_question_text(const Screen *screen, char out[ABOUT_MAX])
{
    char about[ABOUT_MAX];
    memcpy(about, screen_settings(screen)->about, sizeof about);
    char *end = strchr(about, '?'), *begin = about;
    out[0] = '\0';
    if (!end)
        return;
    end[1] = '\0';
    for (char *c = about; c < end; c++)
        if (strchr(".!", c[0]) && c[1] == ' ')
            begin = c + 2;
    snprintf(out, ABOUT_MAX, "%s", begin);
}

int pane_question_rows(const Screen *screen, int width)
{
    char question[ABOUT_MAX];
    pane_question_text(screen, question);
    const int lines = *question ? area_paragraph_lines(width - 2, question) : 0;
    return lines > ASK_LINES ? 0 : lines;
}

void pane_question(const Screen *screen, Area area)
{
    char question[ABOUT_MAX];
    pane_question_text(screen, question);
    area_paragraph(area, 1, 0, area.rect.width - 2, area.rect.height, question, STYLE_HEADING);
}

/* The parameters that are asked about, or those that a filter has found, and the row for `t`. */
int pane_asked_rows(const Screen *screen)
{
    ParameterRow rows[PARAMETER_ROWS_MAX];
    const int count = screen_parameter_rows(screen, rows);
    return (count < ASKED_MAX ? count : ASKED_MAX) + 1;
}

void pane_asked(const Screen *screen, Area area)
{
    ParameterRow rows[PARAMETER_ROWS_MAX];
    Derived derived[DERIVED_MAX];
    char tried[160];
    const int count = screen_parameter_rows(screen, rows), room = area.rect.height - 1;
    experiment_derived(screen->experiment, derived);
    draw_rows(screen, area_part(area, 0, 0, area.rect.width, room), rows, count, derived);
    if (!screen_question(screen, tried, sizeof tried))
        return;
    const int last = count < room ? count : room;
    area_text(area, 2, last, "t", STYLE_KEY);
    area_print(area, 4, last, STYLE_NORMAL, "tries %s", tried);
}
