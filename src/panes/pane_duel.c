/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Tables of runs in the box: the readout of a duel, and the runs of one picture, a line each. */
#include "answers/comparison.h"
#include "panes/panes.h"
#include "scenario/parameters.h"
#include "scenario/settings.h"
#include "views/plots/plots.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { LABEL_LEAST = 12, VALUE_LEAST = 7, GROUPS_MAX = 3 };

/* How wide the table of these rows is: the widest label and the widest value of each run. */
static void measure(const Comparison *rows, int count, int *label, int values[2])
{
    *label = LABEL_LEAST;
    values[0] = values[1] = VALUE_LEAST;
    for (int i = 0; i < count; i++) {
        *label = glyphs_columns(rows[i].label) > *label ? glyphs_columns(rows[i].label) : *label;
        for (int run = 0; run < 2; run++)
            if (glyphs_columns(rows[i].values[run]) > values[run])
                values[run] = glyphs_columns(rows[i].values[run]);
    }
}

static void draw_group(Area area, const Comparison *rows, int count, int heading, bool own_row)
{
    int label, values[2];
    measure(rows, count, &label, values);
    const int ends[2] = {label + 1 + values[0], label + 1 + values[0] + 1 + values[1]};
    const Style styles[2] = {STYLE_MEASURED, STYLE_SECOND};
    /* A and B head their columns; where the words of the heading reach so far the first values have them. */
    for (int run = 0; run < 2; run++) {
        const char letter[] = {' ', "AB"[run], ' ', '\0'};
        if (own_row || area.rect.x + ends[0] > heading + 1)
            area_text_right(area, ends[run] + 2, own_row, letter, styles[run]);
    }
    for (int y = 0; y < count; y++) {
        const int row = 1 + own_row + y;
        area_text(area, 1, row, rows[y].label, STYLE_NORMAL);
        for (int run = 0; run < 2; run++)
            area_text_right(area, ends[run] + 1, row, rows[y].values[run], styles[run]);
    }
}

/* "A usf", "B usl"; false: there is no room for it. */
static bool name_values(Comparison *row, const int values[2])
{
    for (int run = 0; run < 2; run++)
        if (glyphs_columns(row->values[run]) + 2 > values[run])
            return false;
    for (int run = 0; run < 2; run++) {
        char value[COMPARISON_TEXT_MAX];
        memcpy(value, row->values[run], sizeof value);
        snprintf(row->values[run], sizeof row->values[run], "%c %.*s", "AB"[run], COMPARISON_TEXT_MAX - 3,
                 value);
    }
    return true;
}

void pane_duel(const Screen *screen, Area area)
{
    Comparison rows[COMPARISONS_MAX];
    /* What may be shown: no theory where a class is to guess. */
    const int all = comparison_of_duel(screen->duel, rows);
    int count = 0, label, values[2];
    for (int i = 0; i < all; i++)
        if (rows[i].kind == COLUMN_MEASURED || (rows[i].kind == COLUMN_EXACT && screen_shows_exact(screen)) ||
            (rows[i].kind == COLUMN_PREDICTED && screen_shows_predicted(screen)))
            rows[count++] = rows[i];
    const int height = area.rect.height - 1;
    enum { LETTERS = 16 }; /* of the last columns */
    const Settings *settings = screen_settings(screen);
    /* the scenario's title asks what the duel is to answer */
    const char *heading = settings->title[0] ? settings->title : settings->problem->title;
    if (5 + glyphs_columns(heading) + LETTERS >= area.rect.width)
        heading = "Duel";
    measure(rows, count, &label, values);
    const int width = 1 + label + 1 + values[0] + 1 + values[1] + 1;
    int groups = area.rect.width / width;
    groups = groups > GROUPS_MAX ? GROUPS_MAX : groups < 1 ? 1 : groups;
    const bool own_row = count <= groups * (height - 1);
    if (!own_row && (count < 1 || !name_values(&rows[0], values)))
        heading = "Duel";
    area_rule(area, heading, screen_is_focused(screen, PANE_BOX) ? STYLE_FOCUS : STYLE_HEADING);
    if (height < 1)
        return;
    const int each = height - own_row;
    if (count > groups * each)
        count = groups * each;
    const int used = (count + each - 1) / each, end = area.rect.x + 4 + glyphs_columns(heading);
    for (int i = 0; i < used; i++) {
        const int first = i * each, here = count - first < each ? count - first : each;
        draw_group(area_part(area, i * (area.rect.width / used), 0, width, area.rect.height), rows + first,
                   here, end, own_row);
    }
}

/* --- the runs of one picture ---------------------------------------------------------------------- */

enum { NAME_COLUMNS = 26, VALUE_COLUMNS = 12 };

int pane_runs_rows(const Screen *screen)
{
    enum { LEAST = 2 }; /* earlier runs: of one the legend has all */
    const Ghost *ghosts = experiment_ghosts(screen->experiment);
    int kept = 0, all = 0;
    for (int i = 0; i < GHOSTS_MAX; i++) {
        all += ghosts[i].used;
        kept += ghosts[i].used && ghosts[i].pinned;
    }
    if (kept < LEAST || screen_second_run(screen) || !experiment_readout(screen->experiment)->moving)
        return 0;
    return 1 + all + 1;
}

int pane_runs(const Screen *screen, Area area)
{
    ShownRun runs[RUNS_MAX];
    const int rows = pane_runs_rows(screen), n_runs = runs_of(screen, runs);
    const Readout *now = runs[n_runs - 1].readout;
    if (rows == 0 || area.rect.height < rows)
        return 0;
    const bool predicted = screen_shows_predicted(screen), exact = screen_shows_exact(screen);
    const double unit = now->is_period ? 1e-3 : 1; /* periods are given in ms */
    area_rule(area, "Runs in one picture", screen_is_focused(screen, PANE_BOX) ? STYLE_FOCUS : STYLE_HEADING);
    /* In the rule above the rows, a space on each side. */
    const char *headings[] = {now->is_period ? "T meas, ms" : "ω measured", "predicted",
                              screen_problem(screen)->answer, "off"};
    int x = 1 + NAME_COLUMNS;
    for (int i = 0; i < 4; i++) {
        if ((i == 1 && !predicted) || (i >= 2 && !exact))
            continue;
        x += VALUE_COLUMNS;
        area_blank(area, x - glyphs_columns(headings[i]) - 1, x + 1, 0, STYLE_NORMAL);
        area_text_right(area, x, 0, headings[i], STYLE_NORMAL);
    }
    for (int i = 0; i < n_runs; i++) {
        /* "a cell size 1"; of the present run what differs from an earlier one. */
        char name[RUN_WORD_MAX + 4], word[RUN_WORD_MAX];
        snprintf(word, sizeof word, "%s", runs[i].word);
        if (runs[i].ghost < 0)
            for (int j = 0; j < n_runs && runs[j].ghost >= 0; j++)
                if (!settings_same(runs[i].settings, runs[j].settings))
                    settings_name(runs[i].settings, runs[j].settings, word, sizeof word);
        snprintf(name, sizeof name, "%c %s", runs[i].ghost >= 0 ? runs[i].letter : ' ', word);
        const int y = 1 + i;
        area_text(area_part(area, 1, y, NAME_COLUMNS, 1), 0, 0, name, runs[i].style);
        const Readout *readout = runs[i].readout;
        char text[32];
        double values[4];
        int count = 0;
        x = 1 + NAME_COLUMNS;
        values[count++] = readout->measured_known ? readout->measured / unit : NAN;
        if (predicted)
            values[count++] = readout->predicted_known ? readout->predicted / unit : NAN;
        if (exact)
            values[count++] = readout->exact_known ? readout->exact / unit : NAN;
        for (int k = 0; k < count; k++) {
            x += VALUE_COLUMNS;
            const NumberText number =
                k == 0 ? readout_text(readout, values[0] < 1 ? 5 : 4) : text_rounded(values[k], 5);
            area_text_right(area, x, y, isfinite(values[k]) ? number.text : "-", runs[i].style);
        }
        const double off = readout->is_period ? readout->error_period : readout->error_frequency;
        if (exact && readout->measured_known && readout->exact_known) {
            snprintf(text, sizeof text, "%+.*f %%", readout_error_decimals(readout, 2), off);
            area_text_right(area, x + VALUE_COLUMNS, y, text, runs[i].style);
        }
    }
    return rows;
}
