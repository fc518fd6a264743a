/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What plots over time have in common: the window, the mark of the present, how far references will reach. */
#include "views/plots/plots.h"

#include <math.h>

/* --- the time window ------------------------------------------------------------------------------ */

void time_plot_window(const Screen *screen, double *from, double *to)
{
    const Experiment *clock = screen_clock_run(screen);
    const double present = experiment_time(clock);
    const double dt = experiment_simulation(clock)->dt;
    const double newest = dt * (double)experiment_newest(clock);
    const double last = dt * (double)experiment_last_step(clock);
    enum { PERIODS = 4 };
    const Readout *readout = experiment_readout(clock);
    double window = screen->time.window;
    if (!(window > 0)) {
        window = last > 0 ? last : 1;
        if (last > 0 && readout->nominal_period > 0 && !readout->drifting)
            window = fmin(window, axis_step_up(PERIODS * readout->nominal_period));
    }
    /* it shows the newest; rewound far, the present is in the middle */
    double right = newest - present <= window / 2 ? newest : present + window / 2;
    right = fmax(right, present);
    /* move by whole hundredths, so that curves shift by whole cells and do not shimmer */
    const double grain = window / 100;
    *from = right <= window ? 0 : ceil((right - window) / grain - 1e-9) * grain;
    *to = *from + window;
}

void time_plot_axes(const Screen *screen, Picture *picture, Axis y, const char *name, const char *unit)
{
    const Problem *facts = screen_problem(screen);
    double from, to;
    time_plot_window(screen, &from, &to);
    const double window = to - from, cell = window / (picture->across > 0 ? picture->across : 1);
    if (from > 0)
        from = ceil(from / cell - 1e-9) * cell;
    Axis x = axis_make(from, from + window);
    x.moves = true;
    picture_axes(picture, x, "t", facts->si ? facts->unit_of_time : "", y, name, unit);
    /* What changes the motion at once is marked in plots too. */
    const double dt = screen_simulation(screen)->dt;
    int count;
    const Event *events = experiment_events(screen->experiment, &count);
    for (int i = 0; i < count; i++)
        if (1u << events[i].kind &
            (1u << EVENT_BREAK | 1u << EVENT_TOUCH | 1u << EVENT_PART | 1u << EVENT_TEAR))
            picture_rule(picture, dt * (double)events[i].step, STYLE_FAINT,
                         screen_event_letter(events[i].kind));
    const Experiment *clock = screen_clock_run(screen);
    if (experiment_newest(clock) > experiment_step(clock))
        picture_rule(picture, experiment_time(clock), STYLE_FOCUS, NULL);
    if (isfinite(screen->time.cursor))
        picture_rule(picture, screen->time.cursor, STYLE_SELECTED, NULL);
}

/* --- curves --------------------------------------------------------------------------------------- */

static double curve_sample(const void *context, size_t index, double *x)
{
    const TimeCurve *curve = context;
    const double *row = record_row(curve->record, index);
    *x = row[1];
    return curve->value ? curve->value(row, curve->context) : row[curve->column];
}

void time_plot_curve(Picture *picture, const TimeCurve *curve)
{
    const Record *record = curve->record;
    Plot *plot = &picture->plot;
    if (record->count == 0)
        return;
    size_t first = record_find(record, plot->x.low), end = record_find(record, plot->x.high) + 2;
    plot_curve(plot, curve_sample, curve, first, end < record->count ? end : record->count, picture->dots);
}

size_t time_plot_stride(const Record *record)
{
    enum { ROWS = 20000 };
    return 1 + record->count / ROWS;
}

/* The largest magnitude of a column in the whole record, so that the axis does not depend on the window. */
double time_plot_reach(const Record *record, int column)
{
    double reach = 0;
    for (size_t i = 0; i < record->count; i += time_plot_stride(record)) {
        double value = fabs(record_row(record, i)[column]);
        if (value > reach && isfinite(value))
            reach = value;
    }
    return reach;
}

void time_plot_range_to_come(const Screen *screen, double least[COLUMNS_MAX], double most[COLUMNS_MAX])
{
    enum { TIMES = 96 };
    int n;
    experiment_columns(screen->experiment, &n);
    const Simulation *sim = screen_simulation(screen);
    References *refs = experiment_references(screen->experiment);
    const long last = experiment_last_step(screen->experiment);
    double from, to, nothing[COLUMNS_MAX] = {0}, earlier[COLUMNS_MAX] = {0}, row[COLUMNS_MAX];
    time_plot_window(screen, &from, &to);
    long steps = sim->dt > 0 ? (long)((to - from) / sim->dt) : 0;
    steps = steps < last ? steps : last;
    for (int k = 0; k < n; k++)
        least[k] = INFINITY, most[k] = -INFINITY;
    for (int i = 0; i <= TIMES; i++) {
        long step = steps / TIMES * i + steps % TIMES * i / TIMES;
        references_row_again(refs, step, sim->dt * (double)step, nothing, earlier, row);
        for (int k = 0; k < n; k++)
            if (isfinite(row[k])) {
                least[k] = fmin(least[k], row[k]);
                most[k] = fmax(most[k], row[k]);
            }
    }
}

PictureKey time_plot_key(const Column *columns, int column)
{
    const char *label = columns[column].quantity.label;
    int exact_before = 0; /* of the same curve: beams have two theories */
    for (int i = 0; i < column; i++)
        exact_before += columns[i].kind == COLUMN_EXACT && columns[i].of == columns[column].of;
    const PictureKey keys[] = {[COLUMN_MEASURED] = {LINE_SOLID, 'o', STYLE_SECOND, label, 0, 0},
                               [COLUMN_EXACT] = {LINE_DOTTED, '.', STYLE_EXACT, label, 0, 0},
                               [COLUMN_PREDICTED] = {LINE_DASHED, '-', STYLE_PREDICTED, label, 0, 0}};
    return columns[column].kind == COLUMN_EXACT && exact_before > 0
               ? (PictureKey){LINE_DASHED, '-', STYLE_THIRD, label, 0, 0}
               : keys[columns[column].kind];
}

bool time_plot_shows(const Screen *screen, const Column *column)
{
    return column->kind == COLUMN_EXACT       ? screen_shows_exact(screen)
           : column->kind == COLUMN_PREDICTED ? screen_shows_predicted(screen)
                                              : true;
}
