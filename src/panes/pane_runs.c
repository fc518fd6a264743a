/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The runs of one picture in the box at the bottom, a line each: what it is, what was measured, and how far
 * it is off. */
#include "panes/panes.h"
#include "scenario/parameters.h"

#include "views/plots/runs.h"

#include <math.h>
#include <stdio.h>

enum { NAME_COLUMNS = 26, VALUE_COLUMNS = 12 };

/* The columns of numbers; what may be told: no theory where a class is to guess. */
typedef struct Table {
    bool predicted, exact;
    double unit; /* of the numbers: periods are told in ms */
} Table;

static int values_of(const Table *table, const Readout *readout, double values[4])
{
    int count = 0;
    values[count++] = readout->measured_known ? readout->measured / table->unit : NAN;
    if (table->predicted)
        values[count++] = readout->predicted_known ? readout->predicted / table->unit : NAN;
    if (table->exact)
        values[count++] = readout->exact_known ? readout->exact / table->unit : NAN;
    return count;
}

/* In the rule above the rows, a space on each side. */
static void draw_heads(const Table *table, const Screen *screen, bool is_period, Area area)
{
    const char *heads[] = {is_period ? "T meas, ms" : "ω measured", "predicted",
                           screen_problem(screen)->answer, "off"};
    int x = 1 + NAME_COLUMNS;
    for (int i = 0; i < 4; i++) {
        if ((i == 1 && !table->predicted) || (i >= 2 && !table->exact))
            continue;
        x += VALUE_COLUMNS;
        for (int column = x - glyphs_columns(heads[i]) - 1; column <= x; column++)
            area_put(area, column, 0, ' ', STYLE_NORMAL);
        area_text_right(area, x, 0, heads[i], STYLE_NORMAL);
    }
}

/* "a cell size 1"; of the present run what differs from an earlier one. */
static void name_of(const ShownRun *run, const ShownRun *runs, int n_runs, char *out, size_t size)
{
    char word[RUN_WORD_MAX];
    snprintf(word, sizeof word, "%s", run->word);
    if (run->ghost < 0)
        for (int i = 0; i < n_runs && runs[i].ghost >= 0; i++)
            if (!settings_same(run->settings, runs[i].settings))
                settings_name(run->settings, runs[i].settings, word, sizeof word);
    snprintf(out, size, "%c %s", run->ghost >= 0 ? run->letter : ' ', word);
}

static void draw_row(const Table *table, const ShownRun *run, Area area, int y)
{
    const Readout *readout = run->readout;
    char text[32];
    double values[4];
    int x = 1 + NAME_COLUMNS;
    const int count = values_of(table, readout, values);
    for (int i = 0; i < count; i++) {
        x += VALUE_COLUMNS;
        const NumberText number =
            i == 0 ? readout_text(readout, values[0] < 1 ? 5 : 4) : text_rounded(values[i], 5);
        area_text_right(area, x, y, isfinite(values[i]) ? number.text : "-", run->style);
    }
    const double off = readout->is_period ? readout->error_period : readout->error_frequency;
    if (!table->exact || !readout->measured_known || !readout->exact_known)
        return;
    snprintf(text, sizeof text, "%+.*f %%", readout_error_decimals(readout, 2), off);
    area_text_right(area, x + VALUE_COLUMNS, y, text, run->style);
}

int pane_runs_rows(const Screen *screen)
{
    enum { LEAST = 2 }; /* earlier runs: of one the legend tells all */
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
    const Table table = {screen_shows_predicted(screen), screen_shows_exact(screen),
                         now->is_period ? 1e-3 : 1};
    area_rule(area, 0, "Runs in one picture",
              screen_is_focused(screen, PANE_BOX) ? STYLE_FOCUS : STYLE_HEADING);
    draw_heads(&table, screen, now->is_period, area);
    for (int i = 0; i < n_runs; i++) {
        char name[RUN_WORD_MAX + 4];
        name_of(&runs[i], runs, n_runs, name, sizeof name);
        area_text(area_part(area, 1, 1 + i, NAME_COLUMNS, 1), 0, 0, name, runs[i].style);
        draw_row(&table, &runs[i], area, 1 + i);
    }
    return rows;
}
