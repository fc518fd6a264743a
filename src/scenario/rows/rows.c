/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The rows of settings (rows.h): found, set, removed, read as values, by their place and by their keys. */
#include "base/assertion.h"
#include "base/text.h"
#include "problems/problem.h"
#include "scenario/concern_body.h"
#include "scenario/concern_output.h"
#include "scenario/settings.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

int row_kind_find(const char *section)
{
    for (int kind = 0; kind < ROW_KINDS; kind++)
        if (strcmp(row_kinds[kind].section, section) == 0)
            return kind;
    return -1;
}

bool settings_have_rows(const Settings *settings, int kind)
{
    ASSERT_INDEX(kind, ROW_KINDS);
    return (row_kinds[kind].concern & settings->problem->concerns) != 0;
}

void settings_default_rows(Settings *settings)
{
    for (int kind = 0; kind < ROW_KINDS; kind++)
        if (settings_have_rows(settings, kind) && row_kinds[kind].usual)
            settings_row_set(settings, kind, "", row_kinds[kind].usual, NULL);
}

int settings_row_find(const Settings *settings, int kind, const char *name)
{
    ASSERT_INDEX(kind, ROW_KINDS);
    const RowList *list = &settings->rows[kind];
    for (int i = 0; i < list->count; i++)
        if (strcmp(list->rows[i].name, name) == 0)
            return i;
    return -1;
}

/* "loads.top", "probe". */
static void key_of(const RowKind *kind, const char *name, char out[KEY_MAX])
{
    snprintf(out, KEY_MAX, "%s%s%.*s", kind->section, *name ? "." : "", ROW_NAME_MAX, name);
}

bool settings_row_set(Settings *settings, int index, const char *name, const char *text, Status *status)
{
    static const char letters[] = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-";
    ASSERT_INDEX(index, ROW_KINDS);
    const RowKind *kind = &row_kinds[index];
    RowList *list = &settings->rows[index];
    char about[KEY_MAX];
    key_of(kind, name, about);
    if (!settings_have_rows(settings, index))
        return status_refuse(status, "%s: problem %s has no %s (only: %s)", about, settings->problem->word,
                             kind->section, kind->concern == CONCERN_PLATE ? "plate" : "bodies");
    if (kind->usual && *name)
        return status_refuse(status, "%s: has no rows with names (%s)", about, kind->form);
    if (kind->plain_names && !(*name >= 'a' && *name <= 'z' && !strpbrk(name, "ABCDEFGHIJKLMNOPQRSTUVWXYZ-")))
        return status_refuse(
            status, "%s: is not allowed as the name of a %s (a letter a to z, then a to z, 0 to 9 and _)",
            about, kind->one);
    if (!kind->usual && (!*name || strlen(name) >= ROW_NAME_MAX || name[strspn(name, letters)]))
        return status_refuse(status, "%s: invalid name of a %s (1 to %d letters, digits, _ and -)", about,
                             kind->one, ROW_NAME_MAX - 1);
    int at = settings_row_find(settings, index, name);
    if (at < 0 && list->count == ROWS_OF_KIND_MAX)
        return status_refuse(status, "%s: too many %s (at most %d)", about, kind->section, ROWS_OF_KIND_MAX);
    Row row = {0};
    strcpy(row.name, name);
    if (!row_read(kind, text, &row, about, status))
        return false;
    list->rows[at < 0 ? list->count++ : at] = row;
    return true;
}

/* Fails: there is no row of that name, and the status says which there are. */
static bool row_missing(const Settings *settings, int index, const char *name, Status *status)
{
    ASSERT_INDEX(index, ROW_KINDS);
    const RowKind *kind = &row_kinds[index];
    char there[160] = "", about[KEY_MAX];
    key_of(kind, name, about);
    for (int i = 0; i < settings->rows[index].count; i++)
        text_list_add(there, sizeof there, settings->rows[index].rows[i].name);
    return status_refuse(status, "%s: there is no %s of that name (%s)", about, kind->one,
                         *there ? there : "none at all");
}

bool settings_row_remove(Settings *settings, int index, const char *name, Status *status)
{
    ASSERT_INDEX(index, ROW_KINDS);
    RowList *list = &settings->rows[index];
    const int at = settings_row_find(settings, index, name);
    if (row_kinds[index].usual)
        return status_refuse(status, "%s: cannot be left out (%s)", row_kinds[index].section,
                             row_kinds[index].form);
    if (at < 0)
        return row_missing(settings, index, name, status);
    /* of a row that goes nothing is asked any more */
    char *ask = settings_edit_view(settings)->ask, key[KEY_MAX], kept[LIST_MAX] = "", gone[KEY_MAX];
    const char *asked = ask;
    const int length = snprintf(gone, sizeof gone, "%s.%s", row_kinds[index].section, name);
    while (text_next_item(&asked, key, sizeof key))
        if (strncmp(key, gone, (size_t)length) != 0 || !strchr(".", key[length]))
            text_list_add(kept, sizeof kept, key);
    strcpy(ask, kept);
    memmove(&list->rows[at], &list->rows[at + 1], (size_t)(list->count - at - 1) * sizeof *list->rows);
    memset(&list->rows[--list->count], 0, sizeof *list->rows);
    return true;
}

void settings_row_get(const Settings *settings, int kind, int row, char out[ROW_TEXT_MAX])
{
    ASSERT_INDEX(kind, ROW_KINDS);
    ASSERT_INDEX(row, settings->rows[kind].count);
    row_write(&row_kinds[kind], &settings->rows[kind].rows[row], 0, out);
}

void settings_row_show(const Settings *settings, int kind, int row, char out[ROW_TEXT_MAX])
{
    ASSERT_INDEX(kind, ROW_KINDS);
    ASSERT_INDEX(row, settings->rows[kind].count);
    row_write(&row_kinds[kind], &settings->rows[kind].rows[row], 6, out);
}

/* The plate's length or height: of which a share of such a place is one. `key` (NULL: not wanted): which. */
static double row_whole(const Settings *settings, const Row *row, RowValue value, const char **key)
{
    bool height = value == ROW_ALONG_Y;
    if (value == ROW_ALONG_EDGE)
        height = (int)row->values[0] == ROW_LEFT || (int)row->values[0] == ROW_RIGHT;
    if (key)
        *key = settings->problem->concerns & CONCERN_BODIES ? height ? "domain.height" : "domain.width"
               : height                                     ? "plate.height"
                                                            : "plate.length";
    return height ? settings_geometry(settings)->height : settings_geometry(settings)->length;
}

double settings_row_value(const Settings *settings, int kind, int row, int column)
{
    const Row *at = &settings->rows[kind].rows[row];
    ASSERT_INT(row, <, settings->rows[kind].count);
    ASSERT_INT(column, <, row_kinds[kind].n_columns);
    const RowColumn *what = &row_kinds[kind].columns[column];
    if (!(at->given >> column & 1))
        return what->absent;
    if (!(at->shares >> column & 1))
        return at->values[column];
    return at->values[column] * row_whole(settings, at, what->value, NULL) / 100;
}

/* --- by keys -------------------------------------------------------------------------------------- */

/* A key in its parts. */
typedef struct RowKey {
    int kind;
    char name[ROW_NAME_MAX];
    char value[16]; /* "": the whole row */
} RowKey;

/* Copies up to a dot; false: it is longer than that. */
static bool next_part(const char **key, char *out, size_t size)
{
    const size_t length = strcspn(*key, ".");
    if (length >= size)
        return false;
    memcpy(out, *key, length);
    out[length] = '\0';
    *key += length + ((*key)[length] == '.');
    return true;
}

/* The kind of a key's section; -1: none. */
static int kind_of(const char **key)
{
    char section[16];
    return strchr(*key, '.') && next_part(key, section, sizeof section) ? row_kind_find(section) : -1;
}

static bool cut_key(const char *key, RowKey *out)
{
    *out = (RowKey){0};
    out->kind = kind_of(&key);
    return out->kind >= 0 && (row_kinds[out->kind].usual || next_part(&key, out->name, sizeof out->name)) &&
           next_part(&key, out->value, sizeof out->value) && !*key;
}

/* The column of that word; -1: none. */
static int row_column(const RowKind *kind, const char *word)
{
    for (int i = 0; i < kind->n_columns; i++)
        if (strcmp(kind->columns[i].word, word) == 0)
            return i;
    return -1;
}

bool settings_row_is_key(const Settings *settings, const char *key)
{
    const int kind = kind_of(&key);
    return kind >= 0 && settings_have_rows(settings, kind);
}

/* One value of a row that is there. */
static bool set_value(Settings *settings, const RowKey *at, const char *key, const char *text, Status *status)
{
    const RowKind *kind = &row_kinds[at->kind];
    const int row = settings_row_find(settings, at->kind, at->name), column = row_column(kind, at->value);
    char about[KEY_MAX], words[160] = "";
    if (row < 0)
        return row_missing(settings, at->kind, at->name, status);
    for (int i = 0; i < kind->n_columns; i++)
        text_list_add(words, sizeof words, kind->columns[i].word);
    if (column < 0)
        return status_refuse(status, "%s: a %s has no such value (%s)", key, kind->one, words);
    key_of(kind, at->name, about);
    Row changed = settings->rows[at->kind].rows[row];
    if (!row_has(kind, &changed, column))
        return status_refuse(status, "%s: a %s has no %s (%s)", key, row_shape_words[(int)changed.values[0]],
                             at->value, kind->form);
    if (kind->columns[column].value == ROW_SHAPE)
        return status_refuse(status, "%s: another shape has other values (%s = %s)", key, about, kind->form);
    if (!row_read_value(kind, column, text, &changed, about, status))
        return false;
    for (int k = column; kind->columns[k].follows; k--) /* those that share a word come together */
        changed.given |= 1u << (k - 1);
    for (int k = column + 1; k < kind->n_columns && kind->columns[k].follows; k++)
        changed.given |= 1u << k;
    settings->rows[at->kind].rows[row] = changed;
    return true;
}

bool settings_row_key_set(Settings *settings, const char *key, const char *text, Status *status)
{
    RowKey at;
    if (!cut_key(key, &at)) {
        const char *rest = key;
        const int kind = kind_of(&rest);
        if (kind < 0)
            return status_refuse(status, "%s: no such rows", key);
        return status_refuse(status, "%s: invalid name of a %s (1 to %d letters, digits, _ and -)", key,
                             row_kinds[kind].one, ROW_NAME_MAX - 1);
    }
    if (*at.value)
        return set_value(settings, &at, key, text, status);
    if (strcmp(text, "none") == 0)
        return settings_row_remove(settings, at.kind, at.name, status);
    return settings_row_set(settings, at.kind, at.name, text, status);
}

const RowColumn *row_key_column(const char *key)
{
    RowKey at;
    if (!cut_key(key, &at) || !*at.value)
        return NULL;
    const int column = row_column(&row_kinds[at.kind], at.value);
    return column < 0 ? NULL : &row_kinds[at.kind].columns[column];
}

double settings_row_number(const Settings *settings, const char *key)
{
    RowKey at;
    if (!cut_key(key, &at) || !*at.value)
        return NAN;
    const int row = settings_row_find(settings, at.kind, at.name),
              column = row_column(&row_kinds[at.kind], at.value);
    return row >= 0 && column >= 0 ? settings_row_value(settings, at.kind, row, column) : NAN;
}

void settings_row_key_show(const Settings *settings, const char *key, char out[ROW_TEXT_MAX])
{
    RowKey at;
    _Static_assert((int)ROW_TEXT_MAX == (int)LIST_MAX, "whatever a key stands for has room in either");
    const int row = cut_key(key, &at) ? settings_row_find(settings, at.kind, at.name) : -1,
              column = row >= 0 ? row_column(&row_kinds[at.kind], at.value) : -1;
    strcpy(out, "none");
    if (row >= 0 && !*at.value)
        settings_row_show(settings, at.kind, row, out);
    if (column < 0)
        return;
    const double value = settings_row_value(settings, at.kind, row, column);
    if (row_words(row_kinds[at.kind].columns[column].value))
        strcpy(out, row_words(row_kinds[at.kind].columns[column].value)[(int)value]);
    else if (isfinite(value))
        strcpy(out, text_rounded(value, 6).text);
}

/* What a scenario asks about of its rows (rows.h): found by its key, told, and given another value. */

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
    char name[ROW_NAME_MAX] = "";
    const char *rest = key;
    *out = (RowPlace){.kind = kind_of(&rest), .row = -1};
    ASSERT_INDEX(out->kind, ROW_KINDS); /* settings_row_is_key() */
    const RowKind *kind = &row_kinds[out->kind];
    if (kind->usual) {
        out->row = 0;
        return find_value(kind, key, rest, out, status);
    }
    const size_t length = strcspn(rest, ".");
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

bool settings_rows_check(const Settings *settings, Status *status)
{
    for (int index = 0; index < ROW_KINDS; index++)
        for (int i = 0; settings_have_rows(settings, index) && i < settings->rows[index].count; i++) {
            const RowKind *kind = &row_kinds[index];
            const Row *row = &settings->rows[index].rows[i];
            char about[KEY_MAX];
            key_of(kind, row->name, about);
            for (int column = 0; column < kind->n_columns; column++) {
                const RowColumn *what = &kind->columns[column];
                if (!row_has(kind, row, column) ||
                    (what->value != ROW_ALONG_X && what->value != ROW_ALONG_Y &&
                     what->value != ROW_ALONG_EDGE))
                    continue;
                const char *key;
                const double whole = row_whole(settings, row, what->value, &key);
                const double value = settings_row_value(settings, index, i, column);
                if (!(value <=
                      whole * (1 + 1e-9))) /* where a row has no name, its values are the file's keys */
                    return status_refuse(status, "%s%s%s = %g is off the %s (0 to %s = %g)", about,
                                         kind->usual ? "." : ": ", what->word, value, row_whole_word(kind),
                                         key, whole);
            }
        }
    return true;
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

bool settings_rows_difference(const Settings *a, const Settings *b, int which, RowDifference *out)
{
    ASSERT_INT(which, >=, 0);
    for (int kind = 0; kind < ROW_KINDS; kind++)
        /* those of `a`, then those that `b` alone has */
        for (int i = 0; i < a->rows[kind].count + b->rows[kind].count; i++) {
            const int of_b = i - a->rows[kind].count;
            const char *name = of_b < 0 ? a->rows[kind].rows[i].name : b->rows[kind].rows[of_b].name;
            *out = (RowDifference){kind, row_of(a, kind, name), row_of(b, kind, name)};
            const bool same = out->in_a && out->in_b && row_same(&row_kinds[kind], out->in_a, out->in_b);
            if (!(of_b >= 0 && out->in_a) && !same && which-- == 0)
                return true;
        }
    return false;
}

bool settings_rows_same(const Settings *a, const Settings *b)
{
    return !settings_rows_difference(a, b, 0, &(RowDifference){0});
}

void row_difference_show(const RowDifference *row, char about[64], char in_a[ROW_TEXT_MAX],
                         char in_b[ROW_TEXT_MAX])
{
    const RowKind *kind = &row_kinds[row->kind];
    const char *name = (row->in_a ? row->in_a : row->in_b)->name;
    snprintf(about, 64, "%s%s%s", kind->one, *name ? " " : "", name);
    write_side(kind, row->in_a, row->in_b, in_a);
    write_side(kind, row->in_b, row->in_a, in_b);
}
