/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What a scenario asks about of its rows (rows.h): found by its key, told, and given another value. */
#include "base/assertion.h"
#include "base/text.h"
#include "scenario/rows/row_text.h"
#include "scenario/settings.h"

#include <stdio.h>
#include <string.h>

static bool is_there(const Settings *settings, const RowPlace *place, int row)
{
    return settings->rows[place->kind].rows[row].given >> (place->value - 1) & 1 &&
           settings_row_value(settings, place->kind, row, place->value - 1) != 0;
}

/* The value of a key's last word; an edge is a word, and has no next one. */
static bool find_value(const RowKind *kind, const char *key, const char *word, RowPlace *out, Status *status)
{
    char words[160] = "";
    const int column = row_column(kind, word);
    for (int i = 0; i < kind->n_columns; i++)
        if (!row_words(kind->columns[i].value))
            text_list_add(words, sizeof words, kind->columns[i].word);
    if (column < 0 || row_words(kind->columns[column].value))
        return status_refuse(status, "screen.ask: %s: a %s has no such number (%s)", key, kind->one, words);
    out->value = column + 1;
    return true;
}

bool settings_row_asked(const Settings *settings, const char *key, RowPlace *out, Status *status)
{
    char section[16], name[ROW_NAME_MAX] = "";
    const char *rest = key + strcspn(key, ".");
    snprintf(section, sizeof section, "%.*s", (int)(rest - key), key);
    *out = (RowPlace){.kind = row_kind_find(section), .row = -1};
    ASSERT_INDEX(out->kind, ROW_KINDS); /* settings_row_is_key() */
    const RowKind *kind = &row_kinds[out->kind];
    if (kind->usual) {
        out->row = 0;
        return find_value(kind, key, rest + 1, out, status);
    }
    const size_t length = strcspn(++rest, ".");
    snprintf(name, sizeof name, "%.*s", length < sizeof name ? (int)length : (int)sizeof name - 1, rest);
    out->row = settings_row_find(settings, out->kind, name);
    if (out->row < 0 && !rest[length] && row_column(kind, name) >= 0) {
        out->all = true;
        if (!find_value(kind, key, name, out, status))
            return false;
        for (int row = settings->rows[out->kind].count - 1; row >= 0; row--)
            if (is_there(settings, out, row))
                out->row = row;
        return true;
    }
    if (out->row < 0 || strlen(name) != length) {
        Status why = {STATUS_DONE, ""};
        row_missing(settings, out->kind, name, &why);
        return status_refuse(status, "screen.ask: %s", why.text);
    }
    return !rest[length] || find_value(kind, key, rest + length + 1, out, status);
}

void settings_row_place_show(const Settings *settings, const RowPlace *place, char name[64],
                             char value[ROW_TEXT_MAX])
{
    const RowKind *kind = &row_kinds[place->kind];
    const char *row = settings->rows[place->kind].rows[place->row].name;
    settings_row_show(settings, place->kind, place->row, value);
    snprintf(name, 64, "%s%s%s", kind->one, *row ? " " : "", row);
    if (place->value == 0)
        return;
    const RowColumn *column = &kind->columns[place->value - 1];
    snprintf(value, ROW_TEXT_MAX, "%s %s",
             text_rounded(settings_row_value(settings, place->kind, place->row, place->value - 1), 6).text,
             column->unit);
    if (place->all)
        snprintf(name, 64, "%s of all %s", column->word, kind->section);
    else
        snprintf(name, 64, "%s of %s%s%s", column->word, kind->one, *row ? " " : "", row);
}

/* What is written with twelve digits, so that of 12e6 and -12e6 the halves are 6e6 and -6e6. */
static void put(Settings *settings, int kind, int row, int column, double value)
{
    const Row *at = &settings->rows[kind].rows[row];
    char text[40];
    if (at->shares >> column & 1)
        snprintf(text, sizeof text, "%.12g%%",
                 100 * value / row_whole(settings, at, row_kinds[kind].columns[column].value, NULL));
    else
        snprintf(text, sizeof text, "%.12g", value);
    row_read_value(&row_kinds[kind], column, text, &settings->rows[kind].rows[row], "", NULL);
}

/* The values of the other rows keep to that of the first. */
static void follow(Settings *settings, const RowPlace *place, double factor)
{
    for (int row = 0; place->all && row < settings->rows[place->kind].count; row++)
        if (row != place->row && is_there(settings, place, row))
            put(settings, place->kind, row, place->value - 1,
                factor * settings_row_value(settings, place->kind, row, place->value - 1));
}

void settings_row_place_put(Settings *settings, const RowPlace *place, double value)
{
    ASSERT_INDEX(place->kind, ROW_KINDS);
    ASSERT_INDEX(place->row, settings->rows[place->kind].count);
    const double before = settings_row_value(settings, place->kind, place->row, place->value - 1);
    put(settings, place->kind, place->row, place->value - 1, value);
    follow(settings, place, value / before);
}

bool settings_row_place_set(Settings *settings, const RowPlace *place, const char *text, Status *status)
{
    Row row = settings->rows[place->kind].rows[place->row];
    const double before = settings_row_value(settings, place->kind, place->row, place->value - 1);
    char name[64], value[ROW_TEXT_MAX];
    settings_row_place_show(settings, place, name, value);
    if (!row_read_value(&row_kinds[place->kind], place->value - 1, text, &row, name, status))
        return false;
    settings->rows[place->kind].rows[place->row] = row;
    follow(settings, place, settings_row_value(settings, place->kind, place->row, place->value - 1) / before);
    return true;
}
