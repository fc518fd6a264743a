#include "view/runs.h"

#include "view/time_plot.h"

#include <stdio.h>
#include <string.h>

static Run run_of_ghost(const Ghost *ghost, int index)
{
    Run run = {
        .letter = ghost->letter,
        .line = LINE_SOLID,
        .style = STYLE_FAINT,
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
    strcpy(run.brief, "before");
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

int runs_of(const Screen *screen, Run runs[RUNS_MAX])
{
    const Ghost *ghosts = experiment_ghosts(screen->experiment);
    int count = 0;
    for (int i = 0; i < GHOSTS_MAX; i++)
        if (ghosts[i].used)
            runs[count++] = run_of_ghost(&ghosts[i], i);
    Run *present = &runs[count++];
    *present = run_of_experiment(screen->experiment);
    present->line = LINE_SOLID;
    present->style = STYLE_MEASURED;
    present->rank = RANK_MEASURED;
    present->mark = '*';
    present->shown = true;
    strcpy(present->word, "measured");
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

void add_ghosts(Plot *plot, const Run *runs, int n_runs, const char *column, int dots)
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

void draw_run_letters(const Plot *plot, Area inner, const Run *runs, int n_runs, const char *column)
{
    for (int i = 0; i < n_runs; i++) {
        const Record *record = runs[i].record;
        if (!runs[i].shown || record->count == 0)
            continue;
        const double *row = record_row(record, record_find(record, plot->x.high));
        run_letter(&runs[i], plot, inner, row[1], row[run_column(&runs[i], column)]);
    }
}

int ghost_legends(const Run *runs, int n_runs, int room, Legend *out)
{
    int count = 0;
    for (int i = 0; i < n_runs; i++) {
        if (runs[i].ghost < 0 || !runs[i].shown)
            continue;
        out[count] = run_legend(&runs[i]);
        if (text_columns(out[count].name) + 5 > room)
            out[count].name = runs[i].brief;
        room -= text_columns(out[count].name) + 5;
        count++;
    }
    return count;
}
