/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The events of a run in one list (event_log.h), brought up to date after each piece of work. */
#include "run/experiment_internal.h"
#include "scenario/changes.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static void add(Event *events, int *count, int most, long step, EventKind kind, const char *text)
{
    if (*count == most)
        return;
    Event *event = &events[(*count)++];
    event->step = step;
    event->kind = kind;
    snprintf(event->text, sizeof event->text, "%.119s", text);
}

static void add_advice(EventLog *log, const Settings *settings, long step, char last[160])
{
    char advice[160] = "";
    if (!problem_advice(settings, advice, sizeof advice, NULL) || strcmp(advice, last) == 0)
        return;
    memcpy(last, advice, sizeof advice);
    if (advice[0])
        add(log->planned, &log->n_planned, EVENT_LOG_PLANNED_MAX, step, EVENT_ADVICE, advice);
}

/* What was known beforehand: advice, changes, and which references are left out, and because of which
 * parameter. */
static void begin(EventLog *log, const Settings *settings)
{
    char last[160] = "", text[KEY_MAX + VALUE_MAX + 8], left_out[KNOWN_TEXT_MAX];
    long step;
    Settings then;
    *log = (EventLog){.begun = true, .newest = -1};
    changes_in_force(settings, -1, &then);
    add_advice(log, &then, 0, last);
    for (int i = 0; i < settings->n_changes; i++) {
        const Change *change = &settings->changes[i];
        snprintf(text, sizeof text, "%s = %s", change->to.key, change->to.value);
        add(log->planned, &log->n_planned, EVENT_LOG_PLANNED_MAX, change->step, EVENT_CHANGE, text);
        changes_in_force(settings, change->step, &then);
        add_advice(log, &then, change->step, last);
    }
    if (answers_known_text(settings, left_out, &step))
        add(log->planned, &log->n_planned, EVENT_LOG_PLANNED_MAX, step, EVENT_ADVICE, left_out);
}

/* A drift is reported when it is beyond a level in two periods in a row: the sum of energies that are half a
 * step apart ripples. */
static const double levels[] = {.01, .02, .05, .1, .2, .5, 1, 2, 5, 10, 100, 1000};
enum { LEVELS = sizeof levels / sizeof *levels };

static void add_drift(EnergyWatch *watch, const Experiment *experiment, double drift)
{
    const double least = fmin(fabs(drift), fabs(watch->before));
    if (drift * watch->before <= 0 || watch->level == LEVELS || least < levels[watch->level])
        return;
    while (watch->level < LEVELS && least >= levels[watch->level])
        watch->level++;
    char text[120];
    /* Why the energy drifts, as far as it is known. */
    Settings then;
    changes_in_force(&experiment->base, watch->before_step, &then);
    const Solver *solver = problem_solver(then.problem, then.method);
    const char *damping = solver && solver->damping && !(drift > 0) ? solver->damping(&then) : NULL;
    const char *cause = damping ? damping : "";
    for (int i = 0; i < experiment->n_events && !damping; i++)
        if (experiment->events[i].kind == EVENT_CROSSING && experiment->events[i].step <= watch->before_step)
            cause = "cell crossing";
    snprintf(text, sizeof text, "energy %s %% %s the start%s%s",
             text_rounded(100 * fabs(watch->before), 2).text, drift > 0 ? "above" : "below",
             *cause ? ": " : "", cause);
    add(watch->events, &watch->n_events, EVENT_LOG_DRIFTS_MAX, watch->before_step, EVENT_ENERGY, text);
}

static void watch_energy(EnergyWatch *watch, const Experiment *experiment, const Readout *readout)
{
    const Record *record = &experiment->record;
    const int total = references_column(experiment->columns, experiment->n_columns, "total");
    const int work = references_column(experiment->columns, experiment->n_columns, "work");
    const size_t rows = record->count - record->loose_last;
    if (rows < watch->rows || record->spacing != watch->spacing) {
        /* the period that the run really has is the mesh's own: it holds whole ripples */
        const double turn = readout->predicted_known ? readout->predicted : readout->exact;
        const bool known = readout->moving && readout->exact_known && !readout->drifting && turn > 0;
        *watch = (EnergyWatch){.spacing = record->spacing,
                               .period = !known               ? 0
                                         : readout->is_period ? turn
                                                              : 2 * M_PI / turn};
    }
    if (!(watch->period > 0) || total < 0)
        return;
    for (; watch->rows < rows; watch->rows++) {
        const double *row = record_row(record, watch->rows);
        const long block = (long)floor(row[1] / watch->period);
        if (block != watch->block && watch->count > 0) {
            const double mean = watch->sum / (double)watch->count;
            if (watch->block == 0)
                watch->first = mean;
            const double drift = watch->first > 0 ? mean / watch->first - 1 : 0;
            add_drift(watch, experiment, drift);
            watch->before = drift;
            watch->before_step = (long)record_row(record, watch->rows - 1)[0];
            watch->sum = 0;
            watch->count = 0;
        }
        watch->block = block;
        watch->sum += row[total] - (work >= 0 ? row[work] : 0);
        watch->count++;
    }
}

/* Periods that the run falls behind in a unit of time; 0: not known. What the mesh predicts does not change
 * while the run goes on; it counts where the run does as predicted. */
static double lag_per_time(const Readout *readout)
{
    Readout steady = *readout;
    if (!readout->measured_known || !readout->exact_known || readout->drifting || readout->faded)
        return 0;
    if (readout->predicted_known && fabs(readout->measured / readout->predicted - 1) < 0.01)
        steady.measured = readout->predicted;
    return readout_late(&steady, 1);
}

static void add_lags(EventLog *log, const Experiment *experiment)
{
    static const struct {
        double periods;
        const char *words;
    } lags[EVENT_LOG_LAGS_MAX] = {{.5, "half a period"}, {1, "a whole period"}, {2, "two periods"},
                                  {5, "five periods"},   {10, "ten periods"},   {20, "twenty periods"}};
    for (int i = 0; i < EVENT_LOG_LAGS_MAX && log->late != 0; i++) {
        const double step = lags[i].periods / fabs(log->late) / experiment->run.sim->dt;
        char text[120];
        if (step > (double)experiment->newest)
            return;
        snprintf(text, sizeof text, "%s %s %s", lags[i].words, log->late > 0 ? "behind" : "ahead of",
                 experiment->base.problem->answer);
        add(log->events, &log->count, EVENT_LOG_MAX, lround(step), EVENT_LATE, text);
    }
}

void event_log_update(EventLog *log, const Experiment *experiment, const Readout *readout)
{
    if (!log->begun)
        begin(log, &experiment->base);
    const double late = lag_per_time(readout);
    if (log->newest == experiment->newest && log->failed == experiment->run.failed &&
        log->n_reported == experiment->n_events && !(log->late < late) && !(log->late > late))
        return;
    log->late = late;
    log->newest = experiment->newest;
    log->failed = experiment->run.failed;
    log->n_reported = experiment->n_events;
    watch_energy(&log->energy, experiment, readout);
    log->count = 0;
    for (int i = 0; i < log->n_planned; i++)
        if (log->planned[i].step <= experiment->newest)
            log->events[log->count++] = log->planned[i];
    for (int i = 0; i < experiment->n_events; i++) {
        /* others have the same in them, with more detail: changes, and growth that the drift covers */
        const Event *event = &experiment->events[i];
        const bool drifts =
            event->kind == EVENT_ENERGY && log->energy.period > 0 && event->step <= log->energy.before_step;
        if (event->kind != EVENT_CHANGE && !drifts)
            log->events[log->count++] = *event;
    }
    for (int i = 0; i < log->energy.n_events; i++)
        log->events[log->count++] = log->energy.events[i];
    add_lags(log, experiment);
    for (int i = 1; i < log->count; i++) { /* mostly in order already, and equal ones keep theirs */
        const Event event = log->events[i];
        int at = i;
        for (; at > 0 && log->events[at - 1].step > event.step; at--)
            log->events[at] = log->events[at - 1];
        log->events[at] = event;
    }
    if (experiment->run.failed)
        add(log->events, &log->count, EVENT_LOG_MAX, experiment->newest, EVENT_FAILURE,
            experiment->run.failure.text);
}
