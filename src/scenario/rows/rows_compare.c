/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The rows of settings as a whole: do they lie on the plate, and how do they differ from others? */
#include "scenario/rows/row_text.h"

#include "base/assertion.h"
#include "scenario/settings.h"

#include <stdio.h>

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
