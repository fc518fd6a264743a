/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The runs of one picture in the box at the bottom, a line each: what it is, what was measured, and how far
 * it is off. */
#include "panes/panes.h"
#include "scenario/parameters.h"

#include "views/plots/runs.h"

#include <math.h>
#include <stdio.h>

enum { NAME_COLUMNS = 26, VALUE_COLUMNS = 12 };

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
    const bool predicted = screen_shows_predicted(screen), exact = screen_shows_exact(screen);
    const double unit = now->is_period ? 1e-3 : 1; /* periods are told in ms */
    area_rule(area, 0, "Runs in one picture",
              screen_is_focused(screen, PANE_BOX) ? STYLE_FOCUS : STYLE_HEADING);
    /* In the rule above the rows, a space on each side. */
    const char *heads[] = {now->is_period ? "T meas, ms" : "ω measured", "predicted",
                           screen_problem(screen)->answer, "off"};
    int x = 1 + NAME_COLUMNS;
    for (int i = 0; i < 4; i++) {
        if ((i == 1 && !predicted) || (i >= 2 && !exact))
            continue;
        x += VALUE_COLUMNS;
        for (int column = x - glyphs_columns(heads[i]) - 1; column <= x; column++)
            area_put(area, column, 0, ' ', STYLE_NORMAL);
        area_text_right(area, x, 0, heads[i], STYLE_NORMAL);
    }
    for (int i = 0; i < n_runs; i++) {
        char name[RUN_WORD_MAX + 4];
        /* "a cell size 1"; of the present run what differs from an earlier one. */
        const size_t size = sizeof name;
        char word[RUN_WORD_MAX];
        snprintf(word, sizeof word, "%s", runs[i].word);
        if (runs[i].ghost < 0)
            for (int j = 0; j < n_runs && runs[j].ghost >= 0; j++)
                if (!settings_same(runs[i].settings, runs[j].settings))
                    settings_name(runs[i].settings, runs[j].settings, word, sizeof word);
        snprintf(name, size, "%c %s", runs[i].ghost >= 0 ? runs[i].letter : ' ', word);
        area_text(area_part(area, 1, 1 + i, NAME_COLUMNS, 1), 0, 0, name, runs[i].style);
        const int y = 1 + i;
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
