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

/* The rows of settings as a whole: do they lie on the plate, and how do they differ from others? */

/* --- on the plate --------------------------------------------------------------------------------- */

static bool check_value(const Settings *settings, int kind, int row, int column, const char *about,
                        Status *status)
{
    const RowColumn *what = &row_kinds[kind].columns[column];
    if (!row_has(&row_kinds[kind], &settings->rows[kind].rows[row], column) ||
        (what->value != ROW_ALONG_X && what->value != ROW_ALONG_Y && what->value != ROW_ALONG_EDGE))
        return true;
    const char *key;
    const double whole = row_whole(settings, &settings->rows[kind].rows[row], what->value, &key);
    const double value = settings_row_value(settings, kind, row, column);
    /* where a row has no name, its values are the keys of the file */
    return value <= whole * (1 + 1e-9) || status_refuse(status, "%s%s%s = %g is off the %s (0 to %s = %g)",
                                                        about, row_kinds[kind].usual ? "." : ": ", what->word,
                                                        value, row_whole_word(&row_kinds[kind]), key, whole);
}

bool settings_rows_check(const Settings *settings, Status *status)
{
    for (int kind = 0; kind < ROW_KINDS; kind++)
        for (int row = 0; settings_have_rows(settings, kind) && row < settings->rows[kind].count; row++) {
            char about[KEY_MAX];
            const char *name = settings->rows[kind].rows[row].name;
            snprintf(about, sizeof about, "%s%s%s", row_kinds[kind].section, *name ? "." : "", name);
            for (int column = 0; column < row_kinds[kind].n_columns; column++)
                if (!check_value(settings, kind, row, column, about, status))
                    return false;
        }
    return true;
}

/* --- differences ---------------------------------------------------------------------------------- */

bool settings_rows_same(const Settings *a, const Settings *b)
{
    char about[64], in_a[ROW_TEXT_MAX], in_b[ROW_TEXT_MAX];
    return !settings_rows_difference(a, b, 0, about, in_a, in_b);
}

static void write_side(const RowKind *kind, const Row *row, const Row *other, char out[ROW_TEXT_MAX])
{
    if (!row)
        snprintf(out, ROW_TEXT_MAX, "none");
    else if (!other)
        row_write(kind, row, 6, out);
    else
        row_write_difference(kind, row, other, out);
}

static const Row *row_of(const Settings *settings, int kind, const char *name)
{
    const int at = settings_row_find(settings, kind, name);
    return at < 0 ? NULL : &settings->rows[kind].rows[at];
}

bool settings_rows_difference(const Settings *a, const Settings *b, int which, char about[64],
                              char in_a[ROW_TEXT_MAX], char in_b[ROW_TEXT_MAX])
{
    ASSERT_INT(which, >=, 0);
    for (int kind = 0; kind < ROW_KINDS; kind++) {
        const RowKind *what = &row_kinds[kind];
        /* those of `a`, then those that `b` alone has */
        for (int i = 0; i < a->rows[kind].count + b->rows[kind].count; i++) {
            const int of_b = i - a->rows[kind].count;
            const char *name = of_b < 0 ? a->rows[kind].rows[i].name : b->rows[kind].rows[of_b].name;
            const Row *one = row_of(a, kind, name), *other = row_of(b, kind, name);
            if ((of_b >= 0 && one) || (one && other && row_same(what, one, other)) || which-- > 0)
                continue;
            snprintf(about, 64, "%s%s%s", what->one, *name ? " " : "", name);
            write_side(what, one, other, in_a);
            write_side(what, other, one, in_b);
            return true;
        }
    }
    return false;
}
