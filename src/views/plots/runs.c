/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The runs of a picture: earlier ones as ghosts with letters, then the present one, or both of a duel. */
#include "views/plots/runs.h"

#include "views/plots/time_plot.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static Run run_of_ghost(const Ghost *ghost, int index)
{
    Run run = {
        .letter = ghost->letter,
        .line = LINE_SOLID,
        .style = ghost->pinned ? (Style)(STYLE_GHOST_A + index) : STYLE_FAINT,
        .rank = RANK_GHOST,
        .mark = ':',
        .shown = true,
        .settings = &ghost->settings,
        .record = &ghost->record,
        .columns = ghost->columns,
        .n_columns = ghost->n_columns,
        .readout = &ghost->readout,
        .ghost = index,
        .profile = &ghost->profile,
    };
    snprintf(run.word, sizeof run.word, "%s", ghost->legend);
    snprintf(run.key, sizeof run.key, "%c:", ghost->letter);
    return run;
}

static Run run_of_experiment(Experiment *experiment)
{
    Run run = {
        .settings = experiment_settings(experiment),
        .record = experiment_record(experiment),
        .readout = experiment_readout(experiment),
        .experiment = experiment,
        .ghost = -1,
    };
    run.columns = experiment_columns(experiment, &run.n_columns);
    return run;
}

static Run present_run(Experiment *experiment)
{
    Run run = run_of_experiment(experiment);
    run.line = LINE_SOLID;
    run.style = STYLE_MEASURED;
    run.rank = RANK_MEASURED;
    run.mark = '*';
    run.shown = true;
    strcpy(run.word, "measured");
    return run;
}

/* Of a duel: B dashed over A's solid line; where it has a picture of its own it is solid there. */
static Run duel_run(const Screen *screen, int which)
{
    const Duel *duel = screen->duel;
    Run run = present_run(which == 0 ? duel->a : duel->b);
    run.letter = "AB"[which];
    run.shown = screen->side == SIDE_BOTH || (screen->side == SIDE_B) == (which == 1);
    snprintf(run.word, sizeof run.word, "%c %s", run.letter, duel->names[which]);
    if (which == 1) {
        run.style = STYLE_SECOND;
        run.mark = 'x';
    }
    if (which == 1 && screen->side == SIDE_BOTH) {
        run.line = LINE_DASHED;
        run.rank = RANK_SECOND;
    }
    return run;
}

int runs_of(const Screen *screen, Run runs[RUNS_MAX])
{
    const Ghost *ghosts = experiment_ghosts(screen_clock_run(screen));
    int count = 0;
    for (int i = 0; i < GHOSTS_MAX && screen->side != SIDE_B; i++)
        if (ghosts[i].used)
            runs[count++] = run_of_ghost(&ghosts[i], i);
    if (screen_second_run(screen)) {
        runs[count++] = duel_run(screen, screen->side == SIDE_B ? 0 : 1);
        runs[count++] = duel_run(screen, screen->side == SIDE_B ? 1 : 0);
    } else
        runs[count++] = present_run(screen->experiment);
    return count;
}

int run_column(const Run *run, const char *name)
{
    for (int i = 0; i < run->n_columns; i++)
        if (strcmp(run->columns[i].quantity.name, name) == 0)
            return i;
    return -1;
}

int runs_with(Run *runs, int n_runs, const char *column)
{
    int count = 0;
    for (int i = 0; i < n_runs; i++)
        if (run_column(&runs[i], column) >= 0)
            runs[count++] = runs[i];
    return count;
}

void run_begin(Plot *plot, const Run *run)
{
    plot_begin(plot, STROKE_LINE, run->line, run->style, run->rank, run->mark);
}

Legend run_legend(const Run *run)
{
    return (Legend){run->line, run->mark, run->style, run->word, run->key[0] ? run->key : NULL};
}

void run_letter(const Run *run, const Plot *plot, Area inner, double x, double y)
{
    if (run->letter)
        axes_mark(inner, &plot->x, &plot->y, x, y, (uint32_t)(unsigned char)run->letter, run->style);
}

double run_mark(const Run *run, const Plot *plot, Area inner, int k)
{
    enum { CELLS = 40 }; /* in less the letter at the end suffices; on paper a ghost has dashes of its own */
    if (run->ghost < 0 || run->style == STYLE_FAINT || inner.canvas->picture || inner.rect.width < CELLS)
        return NAN;
    const double share = (k + (run->ghost + 0.5) / GHOSTS_MAX) / RUN_MARKS;
    return plot->x.low + share * (plot->x.high - plot->x.low);
}

void runs_add_ghosts(Plot *plot, const Run *runs, int n_runs, const char *column, int dots)
{
    for (int i = 0; i < n_runs; i++) {
        if (runs[i].ghost < 0 || !runs[i].shown)
            continue;
        run_begin(plot, &runs[i]);
        time_plot_curve(
            plot,
            &(Curve){
                .record = runs[i].record, .column = run_column(&runs[i], column), .minus = -1, .plus = -1},
            dots);
    }
}

void run_letter_over_time(const Plot *plot, Area inner, const Run *run, int column)
{
    const Record *record = run->record;
    if (record->count == 0)
        return;
    const double *row = record_row(record, record_find(record, plot->x.high));
    run_letter(run, plot, inner, row[1], row[column]);
    for (int k = 0; k < RUN_MARKS; k++) {
        const double time = run_mark(run, plot, inner, k);
        const double *here = record_row(record, record_find(record, time));
        if (time < row[1])
            run_letter(run, plot, inner, here[1], here[column]);
    }
}

void runs_draw_letters(const Plot *plot, Area inner, const Run *runs, int n_runs, const char *column)
{
    for (int i = 0; i < n_runs; i++) {
        if (runs[i].shown)
            run_letter_over_time(plot, inner, &runs[i], run_column(&runs[i], column));
    }
}

int runs_ghost_legends(const Run *runs, int n_runs, Legend *out)
{
    int count = 0;
    for (int i = 0; i < n_runs; i++)
        if (runs[i].ghost >= 0 && runs[i].shown)
            out[count++] = run_legend(&runs[i]);
    return count;
}

void runs_ghost_names(const Screen *screen, int columns, char *out, size_t size)
{
    Run runs[RUNS_MAX];
    const int n_runs = runs_of(screen, runs);
    out[0] = '\0';
    for (int i = 0; i < n_runs; i++) {
        char name[RUN_WORD_MAX + sizeof runs[i].key + 3];
        snprintf(name, sizeof name, "%s%s %s", out[0] ? "  " : "", runs[i].key, runs[i].word);
        if (runs[i].ghost >= 0 && glyphs_columns(out) + glyphs_columns(name) <= columns)
            text_append(out, size, "%s", name);
    }
}
